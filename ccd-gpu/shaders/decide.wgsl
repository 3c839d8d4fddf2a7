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
var<storage, read_write> undecided: type_42;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_42;

fn function_(param: array<f32, 3>, param_1: array<f32, 3>) -> array<f32, 3> {
    let _e24 = ((((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])) < (((param[0] * param[0]) + (param[1] * param[1])) + (param[2] * param[2])));
    return array<f32, 3>(select(param[0], param_1[0], _e24), select(param[1], param_1[1], _e24), select(param[2], param_1[2], _e24));
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: u32) -> array<f32, 3> {
    var phi_672_: array<array<f32, 3>, 4>;

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
        phi_672_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e155)), (param_2[1] - (param_3[1] * _e155)), (param_2[2] - (param_3[2] * _e155))), array<f32, 3>((param_2[0] - (param_4[0] * _e195)), (param_2[1] - (param_4[1] * _e195)), (param_2[2] - (param_4[2] * _e195))), array<f32, 3>((_e9 - (param_4[0] * _e232)), (_e12 - (param_4[1] * _e232)), (_e15 - (param_4[2] * _e232))), array<f32, 3>((_e245 - (param_3[0] * _e275)), (_e248 - (param_3[1] * _e275)), (_e251 - (param_3[2] * _e275))));
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
        phi_672_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e74)), (param_2[1] - (param_3[1] * _e74)), (param_2[2] - (param_3[2] * _e74))), array<f32, 3>((param_2[0] - (param_4[0] * _e114)), (param_2[1] - (param_4[1] * _e114)), (param_2[2] - (param_4[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_672_;
    let _e291 = function_(_e288[0], _e288[1]);
    let _e293 = function_(_e291, _e288[2]);
    let _e295 = function_(_e293, _e288[3]);
    return _e295;
}

fn function_2(param_6: array<f32, 3>, param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: u32) -> array<f32, 3> {
    var phi_300_: bool;
    var phi_333_: array<f32, 3>;
    var phi_334_: bool;
    var phi_335_: array<f32, 3>;
    var phi_336_: bool;
    var phi_341_: array<f32, 3>;

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
        phi_300_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_300_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_300_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_333_ = array<f32, 3>((param_6[0] - ((param_7[0] * _e74) + (param_8[0] * _e78))), (param_6[1] - ((param_7[1] * _e74) + (param_8[1] * _e78))), (param_6[2] - ((param_7[2] * _e74) + (param_8[2] * _e78))));
            phi_334_ = false;
        } else {
            phi_333_ = array<f32, 3>();
            phi_334_ = true;
        }
        let _e129 = phi_333_;
        let _e131 = phi_334_;
        phi_335_ = _e129;
        phi_336_ = _e131;
    } else {
        phi_335_ = array<f32, 3>();
        phi_336_ = true;
    }
    let _e133 = phi_335_;
    let _e135 = phi_336_;
    if _e135 {
        let _e136 = function_1(param_6, param_7, param_8, param_9);
        phi_341_ = _e136;
    } else {
        phi_341_ = _e133;
    }
    let _e138 = phi_341_;
    return _e138;
}

fn function_3(param_10: f32) -> array<u32, 2> {
    let _e7 = bitcast<u32>(param_10);
    let _e8 = (_e7 & 2147483647u);
    let _e9 = (_e8 < 8388608u);
    return array<u32, 2>(select((_e7 << bitcast<u32>(29i)), 0u, _e9), select(((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e9));
}

fn function_4(param_11: ptr<function, type_36>, param_12: f32, param_13: f32, param_14: f32) -> bool {
    var phi_7121_: bool;
    var phi_7122_: bool;
    var phi_7127_: bool;

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
            phi_7121_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_7122_ = select(true, false, _e84);
        } else {
            phi_7121_ = bool();
            phi_7122_ = true;
        }
        let _e91 = phi_7121_;
        let _e93 = phi_7122_;
        phi_7127_ = select(_e91, false, _e93);
    } else {
        phi_7127_ = false;
    }
    let _e96 = phi_7127_;
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
    var phi_782_: u32;
    var phi_828_: u32;
    var phi_831_: type_9;
    var phi_1014_: type_23;
    var phi_1149_: type_29;
    var phi_1417_: bool;
    var phi_1511_: type_32;
    var phi_1512_: bool;
    var phi_1513_: type_32;
    var phi_1514_: bool;
    var phi_1515_: type_32;
    var phi_1516_: bool;
    var phi_1521_: type_32;
    var phi_2246_: bool;
    var phi_2258_: f32;
    var phi_2329_: type_14;
    var phi_2332_: f32;
    var phi_2330_: type_14;
    var phi_2373_: type_15;
    var phi_2333_: f32;
    var local_8: f32;
    var phi_2386_: f32;
    var phi_2417_: type_9;
    var phi_2420_: u32;
    var phi_2487_: u32;
    var phi_2488_: u32;
    var phi_2421_: u32;
    var phi_2489_: u32;
    var phi_2545_: type_9;
    var phi_2701_: type_38;
    var phi_2702_: bool;
    var phi_2703_: type_38;
    var phi_2704_: bool;
    var phi_2735_: type_9;
    var phi_2738_: f32;
    var phi_2740_: f32;
    var phi_2742_: f32;
    var phi_2852_: bool;
    var phi_2859_: f32;
    var phi_2860_: bool;
    var phi_2739_: f32;
    var phi_2741_: f32;
    var phi_2743_: f32;
    var phi_2861_: f32;
    var phi_2862_: bool;
    var phi_2863_: bool;
    var local_9: bool;
    var local_10: f32;
    var local_11: f32;
    var phi_2868_: f32;
    var phi_2884_: type_9;
    var phi_2887_: f32;
    var phi_2952_: f32;
    var phi_2953_: bool;
    var phi_2954_: bool;
    var phi_2955_: bool;
    var phi_2956_: f32;
    var phi_2888_: f32;
    var phi_2957_: bool;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_2960_: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: f32;
    var phi_2974_: f32;
    var phi_2976_: type_38;
    var phi_3813_: array<type_16, 4>;
    var phi_3833_: type_9;
    var phi_3836_: bool;
    var phi_3837_: bool;
    var phi_3888_: bool;
    var phi_3889_: bool;
    var local_17: bool;
    var local_18: bool;
    var phi_3903_: u32;
    var phi_3904_: u32;
    var phi_3905_: bool;
    var phi_3936_: bool;
    var phi_3937_: bool;
    var phi_3938_: bool;
    var phi_3939_: bool;
    var phi_3940_: bool;
    var phi_3941_: bool;
    var phi_3942_: bool;
    var phi_3943_: bool;
    var phi_3944_: bool;
    var phi_3945_: bool;
    var phi_3946_: bool;
    var phi_3947_: bool;
    var phi_3948_: type_38;
    var phi_3949_: bool;
    var phi_3950_: type_38;
    var phi_3951_: bool;
    var phi_3952_: bool;
    var phi_3953_: bool;
    var phi_3954_: bool;
    var phi_3955_: type_38;
    var phi_3956_: bool;
    var phi_3957_: type_38;
    var phi_3958_: bool;
    var phi_3959_: bool;
    var phi_3960_: bool;
    var phi_3961_: bool;
    var phi_3962_: bool;
    var phi_3970_: type_38;
    var phi_3971_: bool;
    var phi_3972_: type_38;
    var phi_3973_: bool;
    var phi_3974_: bool;
    var phi_3975_: bool;
    var phi_3976_: bool;
    var phi_3977_: bool;
    var phi_4400_: type_9;
    var phi_4403_: f32;
    var phi_4405_: f32;
    var phi_4407_: f32;
    var phi_4409_: f32;
    var phi_4411_: bool;
    var phi_4413_: u32;
    var phi_4564_: array<f32, 3>;
    var phi_4630_: type_14;
    var phi_4633_: f32;
    var phi_4631_: type_14;
    var phi_4674_: type_15;
    var phi_4634_: f32;
    var local_19: f32;
    var phi_4687_: f32;
    var phi_4810_: type_30;
    var phi_4811_: bool;
    var phi_4812_: type_30;
    var phi_4813_: bool;
    var phi_4821_: type_30;
    var phi_4992_: bool;
    var phi_4993_: bool;
    var phi_4994_: bool;
    var phi_4995_: bool;
    var phi_4996_: bool;
    var phi_4997_: bool;
    var phi_5298_: bool;
    var phi_5299_: bool;
    var phi_5300_: bool;
    var phi_5301_: bool;
    var phi_5302_: bool;
    var phi_5303_: bool;
    var phi_5311_: bool;
    var phi_5418_: f32;
    var phi_5419_: bool;
    var phi_5420_: f32;
    var phi_5421_: bool;
    var phi_5422_: f32;
    var phi_5423_: bool;
    var phi_5424_: bool;
    var phi_5486_: f32;
    var phi_5487_: bool;
    var phi_5488_: f32;
    var phi_5489_: bool;
    var phi_5490_: f32;
    var phi_5491_: bool;
    var phi_5492_: bool;
    var phi_5559_: f32;
    var phi_5560_: bool;
    var phi_5561_: f32;
    var phi_5562_: bool;
    var phi_5563_: f32;
    var phi_5564_: bool;
    var phi_5565_: bool;
    var phi_5627_: f32;
    var phi_5628_: bool;
    var phi_5629_: f32;
    var phi_5630_: bool;
    var phi_5631_: f32;
    var phi_5632_: bool;
    var phi_5633_: bool;
    var phi_6162_: f32;
    var phi_6163_: f32;
    var phi_6164_: bool;
    var phi_6166_: f32;
    var phi_6167_: f32;
    var phi_6168_: f32;
    var phi_6170_: bool;
    var phi_6171_: bool;
    var phi_6173_: bool;
    var phi_6174_: f32;
    var phi_6175_: f32;
    var phi_6176_: f32;
    var phi_6178_: bool;
    var phi_6179_: bool;
    var phi_6180_: bool;
    var phi_6182_: bool;
    var phi_6183_: f32;
    var phi_6184_: f32;
    var phi_6185_: f32;
    var phi_6187_: bool;
    var phi_6188_: bool;
    var phi_6189_: bool;
    var phi_6191_: bool;
    var phi_6524_: f32;
    var phi_6526_: u32;
    var phi_6527_: f32;
    var phi_6528_: bool;
    var phi_6529_: bool;
    var phi_6530_: bool;
    var phi_6531_: u32;
    var phi_6532_: f32;
    var phi_6533_: f32;
    var phi_6534_: f32;
    var phi_6535_: f32;
    var phi_6536_: bool;
    var phi_6537_: u32;
    var phi_6538_: bool;
    var phi_6539_: bool;
    var phi_6540_: bool;
    var phi_6541_: bool;
    var phi_6543_: bool;
    var phi_6571_: f32;
    var phi_6572_: f32;
    var phi_6573_: f32;
    var phi_6574_: f32;
    var phi_6575_: bool;
    var phi_6576_: u32;
    var phi_6577_: bool;
    var phi_6578_: bool;
    var phi_6579_: bool;
    var phi_6580_: bool;
    var phi_6582_: bool;
    var phi_4404_: f32;
    var phi_4406_: f32;
    var phi_4408_: f32;
    var phi_4410_: f32;
    var phi_4412_: bool;
    var phi_4414_: u32;
    var phi_6583_: f32;
    var phi_6585_: bool;
    var phi_6586_: bool;
    var phi_6587_: bool;
    var phi_6588_: bool;
    var phi_6590_: bool;
    var phi_6591_: bool;
    var local_20: bool;
    var local_21: bool;
    var local_22: bool;
    var local_23: bool;
    var local_24: bool;
    var local_25: bool;
    var local_26: bool;
    var local_27: bool;
    var local_28: f32;
    var local_29: bool;
    var local_30: f32;
    var local_31: f32;
    var phi_6659_: f32;
    var phi_6660_: bool;
    var phi_6661_: bool;
    var phi_6662_: bool;
    var phi_6663_: bool;
    var phi_6664_: bool;
    var phi_6665_: type_38;
    var phi_6666_: bool;
    var phi_6667_: f32;
    var phi_6668_: type_38;
    var phi_6669_: bool;
    var phi_6670_: bool;
    var phi_6671_: bool;
    var phi_6672_: bool;
    var phi_6673_: bool;
    var phi_6674_: bool;
    var local_32: bool;
    var local_33: bool;
    var local_34: type_38;
    var local_35: f32;
    var local_36: f32;
    var phi_6690_: type_33;
    var phi_6691_: bool;
    var local_37: f32;
    var phi_6697_: type_33;
    var phi_6698_: bool;
    var phi_6699_: bool;
    var phi_6700_: bool;
    var phi_6701_: bool;
    var local_38: bool;
    var local_39: type_38;
    var phi_6743_: type_33;
    var phi_6744_: type_33;
    var phi_6745_: bool;
    var phi_6789_: type_31;
    var phi_6829_: bool;
    var phi_6845_: bool;
    var phi_6864_: type_31;
    var phi_6865_: type_31;
    var phi_6866_: type_9;
    var phi_6896_: u32;
    var phi_6918_: u32;
    var phi_6995_: u32;
    var local_40: u32;
    var local_41: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e102 = id_2;
    let _e103 = n_2;
    let _e104 = lane_2;
    let _e116 = ((_e102.y * _e103.x) + _e102.x);
    let _e119 = (_e103.x * _e103.y);
    let _e122 = params.member.member_1.member_2;
    let _e124 = input.member[0u];
    let _e126 = select(_e124, _e122, (_e122 < _e124));
    let _e128 = params.member.member_1.member_1;
    if (_e126 > _e128) {
        let _e131 = params.member.member_1.member_1;
        phi_782_ = (_e126 - _e131);
    } else {
        phi_782_ = 0u;
    }
    let _e134 = phi_782_;
    let _e136 = params.member.member_1.member;
    let _e138 = select(_e134, _e136, (_e136 < _e134));
    let _e140 = (_e138 / 64u);
    let _e144 = select(_e140, (_e140 + 1u), ((_e138 % 64u) > 0u));
    if (_e144 > _e116) {
        let _e146 = (_e144 - _e116);
        if (_e119 == 0u) {
            return;
        }
        let _e148 = (_e146 / _e119);
        if (_e119 == 0u) {
            return;
        }
        phi_828_ = select(_e148, (_e148 + 1u), ((_e146 % _e119) > 0u));
    } else {
        phi_828_ = 0u;
    }
    let _e155 = phi_828_;
    phi_831_ = type_9(0u, _e155);
    loop {
        let _e158 = phi_831_;
        let _e161 = (_e158.member < _e158.member_1);
        let _e174 = (bitcast<i32>(select(0u, 1u, _e161)) != 0i);
        if _e174 {
            let _e178 = (((_e116 + (select(type_9().member_1, _e158.member, _e161) * _e119)) * 64u) + _e104);
            if (_e178 < _e138) {
                let _e182 = params.member.member_1.member_1;
                let _e184 = (2u * (_e182 + _e178));
                let _e187 = input.member[(4u + _e184)];
                let _e190 = input.member[(_e184 + 5u)];
                let _e191 = (_e187 & 2147483647u);
                if ((_e187 & 2147483648u) != 0u) {
                    phi_6864_ = type_31(1u, 0u, array<u32, 2>(0u, 0u), true);
                } else {
                    let _e198 = (_e190 & 2147483647u);
                    if (select(1u, 0u, ((_e190 & 2147483648u) == 0u)) == 0u) {
                        let _e217 = params.member.member.member[1u];
                        let _e220 = ((2u * _e217) + (3u * _e198));
                        let _e222 = elements.member[_e220];
                        let _e225 = elements.member[(_e220 + 1u)];
                        let _e228 = elements.member[(_e220 + 2u)];
                        phi_1014_ = type_23(0u, array<u32, 4>(_e191, _e222, _e225, _e228));
                    } else {
                        let _e201 = (2u * _e191);
                        let _e203 = elements.member[_e201];
                        let _e206 = elements.member[(_e201 + 1u)];
                        let _e207 = (2u * _e198);
                        let _e209 = elements.member[_e207];
                        let _e212 = elements.member[(_e207 + 1u)];
                        phi_1014_ = type_23(1u, array<u32, 4>(_e203, _e206, _e209, _e212));
                    }
                    let _e232 = phi_1014_;
                    let _e237 = paths.member[_e232.member_1[0]];
                    let _e252 = paths.member[_e232.member_1[1]];
                    let _e267 = paths.member[_e232.member_1[2]];
                    let _e282 = paths.member[_e232.member_1[3]];
                    let _e296 = params.member.member.member_4;
                    if (_e232.member != 0u) {
                        phi_1149_ = type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e267.member.x - _e237.member.x), (_e267.member.y - _e237.member.y), (_e267.member.z - _e237.member.z)), array<f32, 3>((_e267.member_1.x - _e237.member_1.x), (_e267.member_1.y - _e237.member_1.y), (_e267.member_1.z - _e237.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e252.member.x - _e237.member.x), (_e252.member.y - _e237.member.y), (_e252.member.z - _e237.member.z)), array<f32, 3>((_e252.member_1.x - _e237.member_1.x), (_e252.member_1.y - _e237.member_1.y), (_e252.member_1.z - _e237.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e267.member.x - _e282.member.x), (_e267.member.y - _e282.member.y), (_e267.member.z - _e282.member.z)), array<f32, 3>((_e267.member_1.x - _e282.member_1.x), (_e267.member_1.y - _e282.member_1.y), (_e267.member_1.z - _e282.member_1.z))), (_e296 + _e296));
                    } else {
                        phi_1149_ = type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e237.member.x - _e252.member.x), (_e237.member.y - _e252.member.y), (_e237.member.z - _e252.member.z)), array<f32, 3>((_e237.member_1.x - _e252.member_1.x), (_e237.member_1.y - _e252.member_1.y), (_e237.member_1.z - _e252.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e267.member.x - _e252.member.x), (_e267.member.y - _e252.member.y), (_e267.member.z - _e252.member.z)), array<f32, 3>((_e267.member_1.x - _e252.member_1.x), (_e267.member_1.y - _e252.member_1.y), (_e267.member_1.z - _e252.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e282.member.x - _e252.member.x), (_e282.member.y - _e252.member.y), (_e282.member.z - _e252.member.z)), array<f32, 3>((_e282.member_1.x - _e252.member_1.x), (_e282.member_1.y - _e252.member_1.y), (_e282.member_1.z - _e252.member_1.z))), (_e296 + _e296));
                    }
                    let _e357 = phi_1149_;
                    let _e359 = params.member.member.member_11;
                    let _e361 = params.member.member.member_12;
                    let _e363 = params.member.member.member_13;
                    let _e365 = params.member.member.member_13;
                    let _e371 = select(_e357.member[0][0], -(_e357.member[0][0]), (_e357.member[0][0] < 0f));
                    let _e375 = select(_e357.member[0][1], -(_e357.member[0][1]), (_e357.member[0][1] < 0f));
                    let _e377 = select(_e375, _e371, (_e371 > _e375));
                    let _e381 = select(_e357.member[0][2], -(_e357.member[0][2]), (_e357.member[0][2] < 0f));
                    let _e383 = select(_e381, _e377, (_e377 > _e381));
                    let _e389 = select(_e357.member[1][0], -(_e357.member[1][0]), (_e357.member[1][0] < 0f));
                    let _e393 = select(_e357.member[1][1], -(_e357.member[1][1]), (_e357.member[1][1] < 0f));
                    let _e395 = select(_e393, _e389, (_e389 > _e393));
                    let _e399 = select(_e357.member[1][2], -(_e357.member[1][2]), (_e357.member[1][2] < 0f));
                    let _e401 = select(_e399, _e395, (_e395 > _e399));
                    let _e405 = (select(_e401, _e383, (_e383 > _e401)) + _e357.member_3);
                    let _e411 = select(_e357.member_1[0][0], -(_e357.member_1[0][0]), (_e357.member_1[0][0] < 0f));
                    let _e415 = select(_e357.member_1[0][1], -(_e357.member_1[0][1]), (_e357.member_1[0][1] < 0f));
                    let _e417 = select(_e415, _e411, (_e411 > _e415));
                    let _e421 = select(_e357.member_1[0][2], -(_e357.member_1[0][2]), (_e357.member_1[0][2] < 0f));
                    let _e423 = select(_e421, _e417, (_e417 > _e421));
                    let _e429 = select(_e357.member_1[1][0], -(_e357.member_1[1][0]), (_e357.member_1[1][0] < 0f));
                    let _e433 = select(_e357.member_1[1][1], -(_e357.member_1[1][1]), (_e357.member_1[1][1] < 0f));
                    let _e435 = select(_e433, _e429, (_e429 > _e433));
                    let _e439 = select(_e357.member_1[1][2], -(_e357.member_1[1][2]), (_e357.member_1[1][2] < 0f));
                    let _e441 = select(_e439, _e435, (_e435 > _e439));
                    let _e445 = (select(_e441, _e423, (_e423 > _e441)) + _e357.member_3);
                    let _e451 = select(_e357.member_2[0][0], -(_e357.member_2[0][0]), (_e357.member_2[0][0] < 0f));
                    let _e455 = select(_e357.member_2[0][1], -(_e357.member_2[0][1]), (_e357.member_2[0][1] < 0f));
                    let _e457 = select(_e455, _e451, (_e451 > _e455));
                    let _e461 = select(_e357.member_2[0][2], -(_e357.member_2[0][2]), (_e357.member_2[0][2] < 0f));
                    let _e463 = select(_e461, _e457, (_e457 > _e461));
                    let _e469 = select(_e357.member_2[1][0], -(_e357.member_2[1][0]), (_e357.member_2[1][0] < 0f));
                    let _e473 = select(_e357.member_2[1][1], -(_e357.member_2[1][1]), (_e357.member_2[1][1] < 0f));
                    let _e475 = select(_e473, _e469, (_e469 > _e473));
                    let _e479 = select(_e357.member_2[1][2], -(_e357.member_2[1][2]), (_e357.member_2[1][2] < 0f));
                    let _e481 = select(_e479, _e475, (_e475 > _e479));
                    let _e485 = (select(_e481, _e463, (_e463 > _e481)) + _e357.member_3);
                    let _e487 = select(_e445, _e405, (_e405 > _e445));
                    let _e489 = select(_e485, _e487, (_e487 > _e485));
                    if (_e489 <= 65536f) {
                        phi_1417_ = (_e489 >= (1f / 65536f));
                    } else {
                        phi_1417_ = false;
                    }
                    let _e494 = phi_1417_;
                    if _e494 {
                        phi_1515_ = type_32();
                        phi_1516_ = true;
                    } else {
                        if (_e489 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e489) & 2139095040u) != 2139095040u) {
                                let _e501 = (2130706432u - (bitcast<u32>(_e489) & 2139095040u));
                                let _e504 = bitcast<f32>(select(8388608u, _e501, (_e501 > 8388608u)));
                                phi_1511_ = type_32(type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e357.member[0][0] * _e504), (_e357.member[0][1] * _e504), (_e357.member[0][2] * _e504)), array<f32, 3>((_e357.member[1][0] * _e504), (_e357.member[1][1] * _e504), (_e357.member[1][2] * _e504))), array<array<f32, 3>, 2>(array<f32, 3>((_e357.member_1[0][0] * _e504), (_e357.member_1[0][1] * _e504), (_e357.member_1[0][2] * _e504)), array<f32, 3>((_e357.member_1[1][0] * _e504), (_e357.member_1[1][1] * _e504), (_e357.member_1[1][2] * _e504))), array<array<f32, 3>, 2>(array<f32, 3>((_e357.member_2[0][0] * _e504), (_e357.member_2[0][1] * _e504), (_e357.member_2[0][2] * _e504)), array<f32, 3>((_e357.member_2[1][0] * _e504), (_e357.member_2[1][1] * _e504), (_e357.member_2[1][2] * _e504))), ((_e357.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e504)), (0f * _e504));
                                phi_1512_ = false;
                            } else {
                                phi_1511_ = type_32();
                                phi_1512_ = true;
                            }
                            let _e570 = phi_1511_;
                            let _e572 = phi_1512_;
                            phi_1513_ = _e570;
                            phi_1514_ = _e572;
                        } else {
                            phi_1513_ = type_32();
                            phi_1514_ = true;
                        }
                        let _e574 = phi_1513_;
                        let _e576 = phi_1514_;
                        phi_1515_ = _e574;
                        phi_1516_ = _e576;
                    }
                    let _e578 = phi_1515_;
                    let _e580 = phi_1516_;
                    if _e580 {
                        phi_1521_ = type_32(_e357, 0f);
                    } else {
                        phi_1521_ = _e578;
                    }
                    let _e583 = phi_1521_;
                    local_7 = type_29(array<array<f32, 3>, 2>(array<f32, 3>(_e583.member.member[0][0], _e583.member.member[0][1], _e583.member.member[0][2]), array<f32, 3>(_e583.member.member[1][0], _e583.member.member[1][1], _e583.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e583.member.member_1[0][0], _e583.member.member_1[0][1], _e583.member.member_1[0][2]), array<f32, 3>(_e583.member.member_1[1][0], _e583.member.member_1[1][1], _e583.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e583.member.member_2[0][0], _e583.member.member_2[0][1], _e583.member.member_2[0][2]), array<f32, 3>(_e583.member.member_2[1][0], _e583.member.member_2[1][1], _e583.member.member_2[1][2])), _e583.member.member_3);
                    let _e625 = local_7.member_1[0u];
                    let _e631 = local_7.member_2[0u];
                    let _e637 = ((_e625[1] * _e631[2]) - (_e625[2] * _e631[1]));
                    let _e640 = ((_e625[2] * _e631[0]) - (_e625[0] * _e631[2]));
                    let _e643 = ((_e625[0] * _e631[1]) - (_e625[1] * _e631[0]));
                    let _e646 = local_7.member_1[1u];
                    let _e652 = local_7.member_2[1u];
                    let _e658 = ((_e646[1] * _e652[2]) - (_e646[2] * _e652[1]));
                    let _e661 = ((_e646[2] * _e652[0]) - (_e646[0] * _e652[2]));
                    let _e664 = ((_e646[0] * _e652[1]) - (_e646[1] * _e652[0]));
                    let _e667 = local_7.member_1[0u];
                    let _e673 = local_7.member_2[1u];
                    let _e688 = local_7.member_1[1u];
                    let _e694 = local_7.member_2[0u];
                    let _e707 = (((_e667[1] * _e673[2]) - (_e667[2] * _e673[1])) + ((_e688[1] * _e694[2]) - (_e688[2] * _e694[1])));
                    let _e708 = (((_e667[2] * _e673[0]) - (_e667[0] * _e673[2])) + ((_e688[2] * _e694[0]) - (_e688[0] * _e694[2])));
                    let _e709 = (((_e667[0] * _e673[1]) - (_e667[1] * _e673[0])) + ((_e688[0] * _e694[1]) - (_e688[1] * _e694[0])));
                    let _e712 = local_7.member[0u];
                    let _e720 = (((_e712[0] * _e637) + (_e712[1] * _e640)) + (_e712[2] * _e643));
                    let _e723 = local_7.member[1u];
                    let _e734 = local_7.member[0u];
                    let _e743 = ((((_e723[0] * _e637) + (_e723[1] * _e640)) + (_e723[2] * _e643)) + (((_e734[0] * _e707) + (_e734[1] * _e708)) + (_e734[2] * _e709)));
                    let _e746 = local_7.member[0u];
                    let _e757 = local_7.member[1u];
                    let _e766 = ((((_e746[0] * _e658) + (_e746[1] * _e661)) + (_e746[2] * _e664)) + (((_e757[0] * _e707) + (_e757[1] * _e708)) + (_e757[2] * _e709)));
                    let _e769 = local_7.member[1u];
                    let _e777 = (((_e769[0] * _e658) + (_e769[1] * _e661)) + (_e769[2] * _e664));
                    let _e780 = local_7.member[0u];
                    let _e786 = select(_e780[0], -(_e780[0]), (_e780[0] < 0f));
                    let _e789 = select(_e780[1], -(_e780[1]), (_e780[1] < 0f));
                    let _e791 = select(_e789, _e786, (_e786 > _e789));
                    let _e794 = select(_e780[2], -(_e780[2]), (_e780[2] < 0f));
                    let _e796 = select(_e794, _e791, (_e791 > _e794));
                    let _e799 = local_7.member[1u];
                    let _e805 = select(_e799[0], -(_e799[0]), (_e799[0] < 0f));
                    let _e808 = select(_e799[1], -(_e799[1]), (_e799[1] < 0f));
                    let _e810 = select(_e808, _e805, (_e805 > _e808));
                    let _e813 = select(_e799[2], -(_e799[2]), (_e799[2] < 0f));
                    let _e815 = select(_e813, _e810, (_e810 > _e813));
                    let _e819 = local_7.member_3;
                    let _e820 = (select(_e815, _e796, (_e796 > _e815)) + _e819);
                    let _e823 = local_7.member_1[0u];
                    let _e829 = select(_e823[0], -(_e823[0]), (_e823[0] < 0f));
                    let _e832 = select(_e823[1], -(_e823[1]), (_e823[1] < 0f));
                    let _e834 = select(_e832, _e829, (_e829 > _e832));
                    let _e837 = select(_e823[2], -(_e823[2]), (_e823[2] < 0f));
                    let _e839 = select(_e837, _e834, (_e834 > _e837));
                    let _e842 = local_7.member_1[1u];
                    let _e848 = select(_e842[0], -(_e842[0]), (_e842[0] < 0f));
                    let _e851 = select(_e842[1], -(_e842[1]), (_e842[1] < 0f));
                    let _e853 = select(_e851, _e848, (_e848 > _e851));
                    let _e856 = select(_e842[2], -(_e842[2]), (_e842[2] < 0f));
                    let _e858 = select(_e856, _e853, (_e853 > _e856));
                    let _e862 = local_7.member_3;
                    let _e863 = (select(_e858, _e839, (_e839 > _e858)) + _e862);
                    let _e866 = local_7.member_2[0u];
                    let _e872 = select(_e866[0], -(_e866[0]), (_e866[0] < 0f));
                    let _e875 = select(_e866[1], -(_e866[1]), (_e866[1] < 0f));
                    let _e877 = select(_e875, _e872, (_e872 > _e875));
                    let _e880 = select(_e866[2], -(_e866[2]), (_e866[2] < 0f));
                    let _e882 = select(_e880, _e877, (_e877 > _e880));
                    let _e885 = local_7.member_2[1u];
                    let _e891 = select(_e885[0], -(_e885[0]), (_e885[0] < 0f));
                    let _e894 = select(_e885[1], -(_e885[1]), (_e885[1] < 0f));
                    let _e896 = select(_e894, _e891, (_e891 > _e894));
                    let _e899 = select(_e885[2], -(_e885[2]), (_e885[2] < 0f));
                    let _e901 = select(_e899, _e896, (_e896 > _e899));
                    let _e905 = local_7.member_3;
                    let _e906 = (select(_e901, _e882, (_e882 > _e901)) + _e905);
                    let _e908 = ((_e863 * 8f) * _e906);
                    let _e915 = local_7.member_3;
                    let _e939 = ((select(_e637, -(_e637), (_e637 < 0f)) + select(_e640, -(_e640), (_e640 < 0f))) + select(_e643, -(_e643), (_e643 < 0f)));
                    let _e950 = ((select(_e658, -(_e658), (_e658 < 0f)) + select(_e661, -(_e661), (_e661 < 0f))) + select(_e664, -(_e664), (_e664 < 0f)));
                    let _e952 = select(_e950, _e939, (_e939 > _e950));
                    let _e964 = (((select(_e707, -(_e707), (_e707 < 0f)) + select(_e708, -(_e708), (_e708 < 0f))) + select(_e709, -(_e709), (_e709 < 0f))) * 0.5f);
                    let _e971 = local_7.member_3;
                    let _e983 = (((((_e820 * 8f) * _e908) * (0.000000059604645f * (524f / 64f))) + ((_e915 * 19f) * ((_e820 * (_e863 + _e906)) + (_e863 * _e906)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e820) * ((1f + _e863) * (1f + _e906)))));
                    let _e984 = (_e720 * 3f);
                    let _e985 = (_e777 * 3f);
                    let _e987 = select(_e985, _e984, (_e984 < _e985));
                    let _e989 = select(_e766, _e743, (_e743 < _e766));
                    let _e991 = select(_e989, _e987, (_e987 < _e989));
                    let _e993 = select(_e985, _e984, (_e984 > _e985));
                    let _e995 = select(_e766, _e743, (_e743 > _e766));
                    let _e998 = -(select(_e995, _e993, (_e993 > _e995)));
                    if ((select(_e998, _e991, (_e991 > _e998)) - (_e983 + ((0f * (((select(_e964, _e952, (_e952 > _e964)) + (_e908 * (0.000000059604645f * 8f))) + ((_e971 * 6f) * (_e863 + _e906))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e863) * (1f + _e906))))) * (3f * 1.0001f)))) > 0f) {
                        phi_6743_ = type_33(0u, type_33().member_1);
                        phi_6744_ = type_33();
                        phi_6745_ = true;
                    } else {
                        let _e1010 = select(_e720, -(_e720), (_e720 < 0f));
                        let _e1013 = select(_e743, -(_e743), (_e743 < 0f));
                        let _e1015 = select(_e1013, _e1010, (_e1010 > _e1013));
                        let _e1018 = select(_e766, -(_e766), (_e766 < 0f));
                        let _e1021 = select(_e777, -(_e777), (_e777 < 0f));
                        let _e1023 = select(_e1021, _e1018, (_e1018 > _e1021));
                        let _e1025 = select(_e1023, _e1015, (_e1015 > _e1023));
                        let _e1026 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e1025 >= _e1026) {
                            phi_2246_ = (_e1025 <= (1f / _e1026));
                        } else {
                            phi_2246_ = false;
                        }
                        let _e1031 = phi_2246_;
                        if _e1031 {
                            phi_2258_ = (1f / _e1025);
                        } else {
                            phi_2258_ = 0f;
                        }
                        let _e1038 = phi_2258_;
                        let _e1039 = (_e359 * 0.0625f);
                        local_5 = type_36(array<f32, 4>(_e720, _e743, _e766, _e777), ((_e983 * 0.34f) + (_e1025 * select(2f, (0.000000059604645f * 256f), _e1031))), _e1038, select(_e1039, 0.00000000000022737368f, (0.00000000000022737368f < _e1039)));
                        let _e1046 = local_5.member[0u];
                        let _e1049 = local_5.member[1u];
                        let _e1052 = local_5.member[2u];
                        let _e1055 = local_5.member[3u];
                        let _e1062 = local_5.member_2;
                        let _e1063 = ((_e1049 - (3f * _e1046)) * _e1062);
                        let _e1065 = local_5.member_2;
                        let _e1066 = ((_e1052 - _e1049) * _e1065);
                        let _e1068 = local_5.member_2;
                        let _e1069 = (((3f * _e1055) - _e1052) * _e1068);
                        local_3[0u] = 0f;
                        local_3[1u] = 1f;
                        local_3[2u] = 1f;
                        local_3[3u] = 1f;
                        let _e1076 = ((_e1066 * _e1066) - (_e1063 * _e1069));
                        if (_e1076 > 0f) {
                            if (_e1076 <= 0.000000000000000000000000000000000000011754944f) {
                                phi_2386_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1076 > 0f));
                            } else {
                                phi_2329_ = type_14(0i, 5i);
                                phi_2332_ = bitcast<f32>(((bitcast<u32>(_e1076) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e1085 = phi_2329_;
                                    let _e1087 = phi_2332_;
                                    local_8 = _e1087;
                                    if (_e1085.member < _e1085.member_1) {
                                        let _e1094 = (_e1085.member + 1i);
                                        phi_2330_ = type_14(select(_e1094, type_15().member_1, select(false, true, ((false == (_e1094 > _e1085.member)) != false))), _e1085.member_1);
                                        phi_2373_ = type_15(1u, _e1085.member);
                                    } else {
                                        phi_2330_ = _e1085;
                                        phi_2373_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e1105 = phi_2330_;
                                    let _e1107 = phi_2373_;
                                    let _e1110 = (bitcast<i32>(_e1107.member) != 0i);
                                    if _e1110 {
                                        phi_2333_ = (0.5f * (_e1087 + (_e1076 / _e1087)));
                                    } else {
                                        phi_2333_ = f32();
                                    }
                                    let _e1115 = phi_2333_;
                                    continue;
                                    continuing {
                                        phi_2329_ = _e1105;
                                        phi_2332_ = _e1115;
                                        break if !(_e1110);
                                    }
                                }
                                let _e1120 = local_8;
                                phi_2386_ = (_e1120 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1126 = phi_2386_;
                            let _e1131 = -((_e1066 + select(_e1126, -(_e1126), (_e1066 < 0f))));
                            local_4[0u] = (_e1131 / (_e1131 + _e1069));
                            local_4[1u] = (_e1063 / (_e1063 + _e1131));
                            let _e1140 = local_4[1u];
                            let _e1141 = local_4[0u];
                            if (_e1140 < _e1141) {
                                let _e1144 = local_4[1u];
                                let _e1146 = local_4[0u];
                                local_4[0u] = _e1144;
                                local_4[1u] = _e1146;
                            }
                            phi_2417_ = type_9(0u, 2u);
                            phi_2420_ = 1u;
                            loop {
                                let _e1150 = phi_2417_;
                                let _e1152 = phi_2420_;
                                local_40 = _e1152;
                                let _e1155 = (_e1150.member < _e1150.member_1);
                                let _e1166 = select(type_9().member_1, _e1150.member, _e1155);
                                let _e1168 = (bitcast<i32>(select(0u, 1u, _e1155)) != 0i);
                                if _e1168 {
                                    let _e1170 = local_4[_e1166];
                                    if (_e1170 > 0f) {
                                        let _e1173 = local_4[_e1166];
                                        if (_e1173 < 1f) {
                                            let _e1176 = local_4[_e1166];
                                            local_3[_e1152] = _e1176;
                                            phi_2487_ = (_e1152 + 1u);
                                        } else {
                                            phi_2487_ = _e1152;
                                        }
                                        let _e1180 = phi_2487_;
                                        phi_2488_ = _e1180;
                                    } else {
                                        phi_2488_ = _e1152;
                                    }
                                    let _e1182 = phi_2488_;
                                    phi_2421_ = _e1182;
                                } else {
                                    phi_2421_ = u32();
                                }
                                let _e1184 = phi_2421_;
                                continue;
                                continuing {
                                    phi_2417_ = type_9(select(_e1150.member, (_e1150.member + 1u), _e1155), select(_e1150.member_1, _e1150.member_1, _e1155));
                                    phi_2420_ = _e1184;
                                    break if !(_e1168);
                                }
                            }
                            let _e3841 = local_40;
                            phi_2489_ = _e3841;
                        } else {
                            phi_2489_ = 1u;
                        }
                        let _e1187 = phi_2489_;
                        local_3[_e1187] = 1f;
                        let _e1189 = local_3;
                        local_6 = _e1189;
                        let _e1190 = (_e359 * 0.99f);
                        let _e1191 = (1f - _e361);
                        let _e1194 = local_5.member[0u];
                        let _e1197 = local_5.member[1u];
                        let _e1200 = local_5.member[2u];
                        let _e1203 = local_5.member[3u];
                        let _e1214 = ((((_e1194 * _e1191) + (_e1197 * _e361)) * (_e1191 * _e1191)) + (((_e1200 * _e1191) + (_e1203 * _e361)) * (_e361 * _e361)));
                        let _e1219 = local_5.member_1;
                        phi_2545_ = type_9(select(1u, 0u, !((select(_e1214, -(_e1214), (_e1214 < 0f)) > _e1219))), (_e1187 + 1u));
                        loop {
                            let _e1226 = phi_2545_;
                            let _e1229 = (_e1226.member < _e1226.member_1);
                            let _e1240 = select(type_9().member_1, _e1226.member, _e1229);
                            if (bitcast<i32>(select(0u, 1u, _e1229)) != 0i) {
                                if (_e1240 > 0u) {
                                    let _e1247 = local_6[(_e1240 - 1u)];
                                    let _e1249 = select(_e361, _e1247, (_e1247 > _e361));
                                    let _e1251 = local_6[_e1240];
                                    let _e1253 = select(_e363, _e1251, (_e1251 < _e363));
                                    if (_e1249 <= _e1253) {
                                        let _e1255 = function_4((&local_5), _e365, _e1249, _e1253);
                                        if _e1255 {
                                            phi_3948_ = type_38();
                                            phi_3949_ = bool();
                                            phi_3950_ = type_38();
                                            phi_3951_ = false;
                                            phi_3952_ = false;
                                            phi_3953_ = false;
                                            phi_3954_ = false;
                                        } else {
                                            let _e1256 = (1f - _e1249);
                                            let _e1259 = local_5.member[0u];
                                            let _e1262 = local_5.member[1u];
                                            let _e1265 = local_5.member[2u];
                                            let _e1268 = local_5.member[3u];
                                            let _e1279 = ((((_e1259 * _e1256) + (_e1262 * _e1249)) * (_e1256 * _e1256)) + (((_e1265 * _e1256) + (_e1268 * _e1249)) * (_e1249 * _e1249)));
                                            let _e1280 = (1f - _e1253);
                                            let _e1283 = local_5.member[0u];
                                            let _e1286 = local_5.member[1u];
                                            let _e1289 = local_5.member[2u];
                                            let _e1292 = local_5.member[3u];
                                            let _e1303 = ((((_e1283 * _e1280) + (_e1286 * _e1253)) * (_e1280 * _e1280)) + (((_e1289 * _e1280) + (_e1292 * _e1253)) * (_e1253 * _e1253)));
                                            let _e1308 = local_5.member_1;
                                            let _e1309 = (select(_e1279, -(_e1279), (_e1279 < 0f)) > _e1308);
                                            let _e1314 = local_5.member_1;
                                            let _e1315 = (select(_e1303, -(_e1303), (_e1303 < 0f)) > _e1314);
                                            let _e1323 = select(select(bool(), select(bool(), ((_e1279 > 0f) != (_e1303 > 0f)), _e1315), _e1309), false, select(true, select(true, false, _e1315), _e1309));
                                            if _e1309 {
                                                if _e1315 {
                                                    phi_2701_ = type_38(select(1f, type_38().member, _e1323), select(0f, type_38().member_1, _e1323), select(_e1323, type_38().member_2, _e1323));
                                                    phi_2702_ = _e1323;
                                                } else {
                                                    phi_2701_ = type_38();
                                                    phi_2702_ = true;
                                                }
                                                let _e1332 = phi_2701_;
                                                let _e1334 = phi_2702_;
                                                phi_2703_ = _e1332;
                                                phi_2704_ = _e1334;
                                            } else {
                                                phi_2703_ = type_38();
                                                phi_2704_ = true;
                                            }
                                            let _e1336 = phi_2703_;
                                            let _e1338 = phi_2704_;
                                            if _e1338 {
                                                if _e1309 {
                                                    let _e1340 = select(1f, -1f, (_e1279 < 0f));
                                                    let _e1342 = local_5.member_3;
                                                    let _e1345 = local_5.member[0u];
                                                    let _e1348 = local_5.member[1u];
                                                    let _e1351 = local_5.member[2u];
                                                    let _e1354 = local_5.member[3u];
                                                    let _e1357 = (_e1351 - _e1348);
                                                    phi_2735_ = type_9(0u, 64u);
                                                    phi_2738_ = _e1253;
                                                    phi_2740_ = _e1249;
                                                    phi_2742_ = (0.5f * (_e1249 + _e1253));
                                                    loop {
                                                        let _e1363 = phi_2735_;
                                                        let _e1365 = phi_2738_;
                                                        let _e1367 = phi_2740_;
                                                        let _e1369 = phi_2742_;
                                                        local_11 = _e1367;
                                                        let _e1372 = (_e1363.member < _e1363.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e1372)) != 0i) {
                                                            let _e1384 = (1f - _e1369);
                                                            let _e1387 = local_5.member[0u];
                                                            let _e1390 = local_5.member[1u];
                                                            let _e1393 = local_5.member[2u];
                                                            let _e1396 = local_5.member[3u];
                                                            let _e1410 = local_5.member_1;
                                                            let _e1411 = ((_e1340 * ((((_e1387 * _e1384) + (_e1390 * _e1369)) * (_e1384 * _e1384)) + (((_e1393 * _e1384) + (_e1396 * _e1369)) * (_e1369 * _e1369)))) - _e1410);
                                                            let _e1412 = (_e1411 > 0f);
                                                            let _e1413 = select(_e1369, _e1365, _e1412);
                                                            let _e1414 = select(_e1367, _e1369, _e1412);
                                                            let _e1416 = ((_e1413 - _e1414) > _e1342);
                                                            if _e1416 {
                                                                let _e1417 = (1f - _e1369);
                                                                let _e1429 = (-(_e1411) / (_e1340 * (((((_e1348 - (3f * _e1345)) * _e1417) + (_e1357 * _e1369)) * _e1417) + (((_e1357 * _e1417) + (((3f * _e1354) - _e1351) * _e1369)) * _e1369))));
                                                                let _e1436 = ((_e1369 + _e1429) + select(-((0.5f * _e1342)), (0.5f * _e1342), (_e1411 > 0f)));
                                                                if (_e1436 > _e1414) {
                                                                    phi_2852_ = select(true, select(true, false, (select(_e1429, -(_e1429), (_e1429 < 0f)) < (0.5f * (_e1413 - _e1414)))), (_e1436 < _e1413));
                                                                } else {
                                                                    phi_2852_ = true;
                                                                }
                                                                let _e1448 = phi_2852_;
                                                                phi_2859_ = select(_e1436, (0.5f * (_e1414 + _e1413)), _e1448);
                                                                phi_2860_ = false;
                                                            } else {
                                                                phi_2859_ = f32();
                                                                phi_2860_ = true;
                                                            }
                                                            let _e1453 = phi_2859_;
                                                            let _e1455 = phi_2860_;
                                                            phi_2739_ = _e1413;
                                                            phi_2741_ = _e1414;
                                                            phi_2743_ = _e1453;
                                                            phi_2861_ = _e1414;
                                                            phi_2862_ = _e1416;
                                                            phi_2863_ = _e1455;
                                                        } else {
                                                            phi_2739_ = f32();
                                                            phi_2741_ = f32();
                                                            phi_2743_ = f32();
                                                            phi_2861_ = f32();
                                                            phi_2862_ = false;
                                                            phi_2863_ = false;
                                                        }
                                                        let _e1457 = phi_2739_;
                                                        let _e1459 = phi_2741_;
                                                        let _e1461 = phi_2743_;
                                                        let _e1463 = phi_2861_;
                                                        let _e1465 = phi_2862_;
                                                        let _e1467 = phi_2863_;
                                                        local_9 = _e1467;
                                                        local_10 = _e1463;
                                                        continue;
                                                        continuing {
                                                            phi_2735_ = type_9(select(_e1363.member, (_e1363.member + 1u), _e1372), select(_e1363.member_1, _e1363.member_1, _e1372));
                                                            phi_2738_ = _e1457;
                                                            phi_2740_ = _e1459;
                                                            phi_2742_ = _e1461;
                                                            break if !(_e1465);
                                                        }
                                                    }
                                                    let _e1470 = local_9;
                                                    let _e1472 = local_10;
                                                    let _e1474 = local_11;
                                                    phi_2868_ = select(_e1474, _e1472, _e1470);
                                                } else {
                                                    phi_2868_ = _e1249;
                                                }
                                                let _e1477 = phi_2868_;
                                                if _e1315 {
                                                    let _e1481 = local_5.member_3;
                                                    let _e1483 = local_5.member_3;
                                                    phi_2884_ = type_9(0u, 64u);
                                                    phi_2887_ = (_e1481 + _e1483);
                                                    loop {
                                                        let _e1486 = phi_2884_;
                                                        let _e1488 = phi_2887_;
                                                        let _e1491 = (_e1486.member < _e1486.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e1491)) != 0i) {
                                                            let _e1503 = (_e1477 + _e1488);
                                                            if (_e1503 < _e1253) {
                                                                let _e1505 = (1f - _e1503);
                                                                let _e1508 = local_5.member[0u];
                                                                let _e1511 = local_5.member[1u];
                                                                let _e1514 = local_5.member[2u];
                                                                let _e1517 = local_5.member[3u];
                                                                let _e1531 = local_5.member_1;
                                                                let _e1532 = ((select(1f, -1f, (_e1303 < 0f)) * ((((_e1508 * _e1505) + (_e1511 * _e1503)) * (_e1505 * _e1505)) + (((_e1514 * _e1505) + (_e1517 * _e1503)) * (_e1503 * _e1503)))) > _e1531);
                                                                phi_2952_ = select((_e1488 + _e1488), f32(), _e1532);
                                                                phi_2953_ = select(true, false, _e1532);
                                                                phi_2954_ = _e1532;
                                                                phi_2955_ = false;
                                                            } else {
                                                                phi_2952_ = f32();
                                                                phi_2953_ = false;
                                                                phi_2954_ = false;
                                                                phi_2955_ = true;
                                                            }
                                                            let _e1537 = phi_2952_;
                                                            let _e1539 = phi_2953_;
                                                            let _e1541 = phi_2954_;
                                                            let _e1543 = phi_2955_;
                                                            phi_2956_ = _e1503;
                                                            phi_2888_ = _e1537;
                                                            phi_2957_ = _e1539;
                                                            phi_2958_ = _e1541;
                                                            phi_2959_ = _e1543;
                                                            phi_2960_ = false;
                                                        } else {
                                                            phi_2956_ = f32();
                                                            phi_2888_ = f32();
                                                            phi_2957_ = false;
                                                            phi_2958_ = false;
                                                            phi_2959_ = false;
                                                            phi_2960_ = true;
                                                        }
                                                        let _e1545 = phi_2956_;
                                                        let _e1547 = phi_2888_;
                                                        let _e1549 = phi_2957_;
                                                        let _e1551 = phi_2958_;
                                                        let _e1553 = phi_2959_;
                                                        let _e1555 = phi_2960_;
                                                        local_12 = _e1551;
                                                        local_13 = _e1553;
                                                        local_14 = _e1551;
                                                        local_15 = _e1555;
                                                        local_16 = _e1545;
                                                        continue;
                                                        continuing {
                                                            phi_2884_ = type_9(select(_e1486.member, (_e1486.member + 1u), _e1491), select(_e1486.member_1, _e1486.member_1, _e1491));
                                                            phi_2887_ = _e1547;
                                                            break if !(_e1549);
                                                        }
                                                    }
                                                    let _e1558 = local_12;
                                                    let _e1560 = local_13;
                                                    let _e1563 = local_14;
                                                    let _e1565 = local_15;
                                                    let _e1569 = local_16;
                                                    phi_2974_ = select(_e1569, _e1253, select(select(_e1565, false, _e1563), true, select(_e1560, false, _e1558)));
                                                } else {
                                                    phi_2974_ = _e1253;
                                                }
                                                let _e1572 = phi_2974_;
                                                phi_2976_ = type_38(_e1477, _e1572, _e1323);
                                            } else {
                                                phi_2976_ = _e1336;
                                            }
                                            let _e1575 = phi_2976_;
                                            if (_e1575.member > _e1575.member_1) {
                                                phi_3943_ = bool();
                                                phi_3944_ = true;
                                                phi_3945_ = false;
                                                phi_3946_ = false;
                                                phi_3947_ = false;
                                            } else {
                                                let _e1580 = (_e1575.member > _e365);
                                                if _e1580 {
                                                    phi_3939_ = bool();
                                                    phi_3940_ = false;
                                                    phi_3941_ = false;
                                                    phi_3942_ = false;
                                                } else {
                                                    let _e1584 = ((_e1575.member_1 - _e1575.member) * 0.5f);
                                                    let _e1585 = (_e1575.member + _e1584);
                                                    let _e1587 = (_e1584 + (0.000000059604645f * 4f));
                                                    let _e1589 = local_7.member_3;
                                                    let _e1592 = local_7.member[0u];
                                                    let _e1598 = select(_e1592[0], -(_e1592[0]), (_e1592[0] < 0f));
                                                    let _e1601 = select(_e1592[1], -(_e1592[1]), (_e1592[1] < 0f));
                                                    let _e1603 = select(_e1601, _e1598, (_e1598 > _e1601));
                                                    let _e1606 = select(_e1592[2], -(_e1592[2]), (_e1592[2] < 0f));
                                                    let _e1608 = select(_e1606, _e1603, (_e1603 > _e1606));
                                                    let _e1610 = local_7.member[1u];
                                                    let _e1616 = select(_e1610[0], -(_e1610[0]), (_e1610[0] < 0f));
                                                    let _e1619 = select(_e1610[1], -(_e1610[1]), (_e1610[1] < 0f));
                                                    let _e1621 = select(_e1619, _e1616, (_e1616 > _e1619));
                                                    let _e1624 = select(_e1610[2], -(_e1610[2]), (_e1610[2] < 0f));
                                                    let _e1626 = select(_e1624, _e1621, (_e1621 > _e1624));
                                                    let _e1631 = local_7.member[0u];
                                                    let _e1636 = local_7.member[1u];
                                                    let _e1646 = (_e1631[0] + ((_e1636[0] - _e1631[0]) * _e1585));
                                                    let _e1647 = (_e1631[1] + ((_e1636[1] - _e1631[1]) * _e1585));
                                                    let _e1648 = (_e1631[2] + ((_e1636[2] - _e1631[2]) * _e1585));
                                                    let _e1650 = local_7.member[1u];
                                                    let _e1655 = local_7.member[0u];
                                                    let _e1659 = (_e1650[0] - _e1655[0]);
                                                    let _e1660 = (_e1650[1] - _e1655[1]);
                                                    let _e1661 = (_e1650[2] - _e1655[2]);
                                                    let _e1664 = select(_e1659, -(_e1659), (_e1659 < 0f));
                                                    let _e1667 = select(_e1660, -(_e1660), (_e1660 < 0f));
                                                    let _e1669 = select(_e1667, _e1664, (_e1664 > _e1667));
                                                    let _e1672 = select(_e1661, -(_e1661), (_e1661 < 0f));
                                                    let _e1680 = ((((_e1587 * select(_e1672, _e1669, (_e1669 > _e1672))) * 1.01f) + ((select(_e1626, _e1608, (_e1608 > _e1626)) + _e1589) * (0.000000059604645f * 8f))) + _e1589);
                                                    let _e1683 = select(_e1646, -(_e1646), (_e1646 < 0f));
                                                    let _e1686 = select(_e1647, -(_e1647), (_e1647 < 0f));
                                                    let _e1688 = select(_e1686, _e1683, (_e1683 > _e1686));
                                                    let _e1691 = select(_e1648, -(_e1648), (_e1648 < 0f));
                                                    let _e1694 = (select(_e1691, _e1688, (_e1688 > _e1691)) + _e1680);
                                                    let _e1697 = local_7.member_3;
                                                    let _e1699 = local_7.member_1[0u];
                                                    let _e1705 = select(_e1699[0], -(_e1699[0]), (_e1699[0] < 0f));
                                                    let _e1708 = select(_e1699[1], -(_e1699[1]), (_e1699[1] < 0f));
                                                    let _e1710 = select(_e1708, _e1705, (_e1705 > _e1708));
                                                    let _e1713 = select(_e1699[2], -(_e1699[2]), (_e1699[2] < 0f));
                                                    let _e1715 = select(_e1713, _e1710, (_e1710 > _e1713));
                                                    let _e1717 = local_7.member_1[1u];
                                                    let _e1723 = select(_e1717[0], -(_e1717[0]), (_e1717[0] < 0f));
                                                    let _e1726 = select(_e1717[1], -(_e1717[1]), (_e1717[1] < 0f));
                                                    let _e1728 = select(_e1726, _e1723, (_e1723 > _e1726));
                                                    let _e1731 = select(_e1717[2], -(_e1717[2]), (_e1717[2] < 0f));
                                                    let _e1733 = select(_e1731, _e1728, (_e1728 > _e1731));
                                                    let _e1738 = local_7.member_1[0u];
                                                    let _e1743 = local_7.member_1[1u];
                                                    let _e1753 = (_e1738[0] + ((_e1743[0] - _e1738[0]) * _e1585));
                                                    let _e1754 = (_e1738[1] + ((_e1743[1] - _e1738[1]) * _e1585));
                                                    let _e1755 = (_e1738[2] + ((_e1743[2] - _e1738[2]) * _e1585));
                                                    let _e1757 = local_7.member_1[1u];
                                                    let _e1762 = local_7.member_1[0u];
                                                    let _e1766 = (_e1757[0] - _e1762[0]);
                                                    let _e1767 = (_e1757[1] - _e1762[1]);
                                                    let _e1768 = (_e1757[2] - _e1762[2]);
                                                    let _e1771 = select(_e1766, -(_e1766), (_e1766 < 0f));
                                                    let _e1774 = select(_e1767, -(_e1767), (_e1767 < 0f));
                                                    let _e1776 = select(_e1774, _e1771, (_e1771 > _e1774));
                                                    let _e1779 = select(_e1768, -(_e1768), (_e1768 < 0f));
                                                    let _e1787 = ((((_e1587 * select(_e1779, _e1776, (_e1776 > _e1779))) * 1.01f) + ((select(_e1733, _e1715, (_e1715 > _e1733)) + _e1697) * (0.000000059604645f * 8f))) + _e1697);
                                                    let _e1790 = select(_e1753, -(_e1753), (_e1753 < 0f));
                                                    let _e1793 = select(_e1754, -(_e1754), (_e1754 < 0f));
                                                    let _e1795 = select(_e1793, _e1790, (_e1790 > _e1793));
                                                    let _e1798 = select(_e1755, -(_e1755), (_e1755 < 0f));
                                                    let _e1801 = (select(_e1798, _e1795, (_e1795 > _e1798)) + _e1787);
                                                    let _e1804 = local_7.member_3;
                                                    let _e1806 = local_7.member_2[0u];
                                                    let _e1812 = select(_e1806[0], -(_e1806[0]), (_e1806[0] < 0f));
                                                    let _e1815 = select(_e1806[1], -(_e1806[1]), (_e1806[1] < 0f));
                                                    let _e1817 = select(_e1815, _e1812, (_e1812 > _e1815));
                                                    let _e1820 = select(_e1806[2], -(_e1806[2]), (_e1806[2] < 0f));
                                                    let _e1822 = select(_e1820, _e1817, (_e1817 > _e1820));
                                                    let _e1824 = local_7.member_2[1u];
                                                    let _e1830 = select(_e1824[0], -(_e1824[0]), (_e1824[0] < 0f));
                                                    let _e1833 = select(_e1824[1], -(_e1824[1]), (_e1824[1] < 0f));
                                                    let _e1835 = select(_e1833, _e1830, (_e1830 > _e1833));
                                                    let _e1838 = select(_e1824[2], -(_e1824[2]), (_e1824[2] < 0f));
                                                    let _e1840 = select(_e1838, _e1835, (_e1835 > _e1838));
                                                    let _e1845 = local_7.member_2[0u];
                                                    let _e1850 = local_7.member_2[1u];
                                                    let _e1860 = (_e1845[0] + ((_e1850[0] - _e1845[0]) * _e1585));
                                                    let _e1861 = (_e1845[1] + ((_e1850[1] - _e1845[1]) * _e1585));
                                                    let _e1862 = (_e1845[2] + ((_e1850[2] - _e1845[2]) * _e1585));
                                                    let _e1864 = local_7.member_2[1u];
                                                    let _e1869 = local_7.member_2[0u];
                                                    let _e1873 = (_e1864[0] - _e1869[0]);
                                                    let _e1874 = (_e1864[1] - _e1869[1]);
                                                    let _e1875 = (_e1864[2] - _e1869[2]);
                                                    let _e1878 = select(_e1873, -(_e1873), (_e1873 < 0f));
                                                    let _e1881 = select(_e1874, -(_e1874), (_e1874 < 0f));
                                                    let _e1883 = select(_e1881, _e1878, (_e1878 > _e1881));
                                                    let _e1886 = select(_e1875, -(_e1875), (_e1875 < 0f));
                                                    let _e1894 = ((((_e1587 * select(_e1886, _e1883, (_e1883 > _e1886))) * 1.01f) + ((select(_e1840, _e1822, (_e1822 > _e1840)) + _e1804) * (0.000000059604645f * 8f))) + _e1804);
                                                    let _e1897 = select(_e1860, -(_e1860), (_e1860 < 0f));
                                                    let _e1900 = select(_e1861, -(_e1861), (_e1861 < 0f));
                                                    let _e1902 = select(_e1900, _e1897, (_e1897 > _e1900));
                                                    let _e1905 = select(_e1862, -(_e1862), (_e1862 < 0f));
                                                    let _e1908 = (select(_e1905, _e1902, (_e1902 > _e1905)) + _e1894);
                                                    let _e1911 = ((_e1754 * _e1862) - (_e1755 * _e1861));
                                                    let _e1914 = ((_e1755 * _e1860) - (_e1753 * _e1862));
                                                    let _e1917 = ((_e1753 * _e1861) - (_e1754 * _e1860));
                                                    let _e1932 = select(false, (select(_e1911, -(_e1911), (_e1911 < 0f)) > select(_e1917, -(_e1917), (_e1917 < 0f))), (select(_e1911, -(_e1911), (_e1911 < 0f)) > select(_e1914, -(_e1914), (_e1914 < 0f))));
                                                    let _e1947 = select((select(_e1914, -(_e1914), (_e1914 < 0f)) > select(_e1917, -(_e1917), (_e1917 < 0f))), false, (select(_e1911, -(_e1911), (_e1911 < 0f)) > select(_e1914, -(_e1914), (_e1914 < 0f))));
                                                    let _e1950 = select(select(_e1646, _e1647, _e1932), _e1648, _e1947);
                                                    let _e1951 = select(select(_e1647, _e1648, _e1932), _e1646, _e1947);
                                                    let _e1954 = select(select(_e1753, _e1754, _e1932), _e1755, _e1947);
                                                    let _e1955 = select(select(_e1754, _e1755, _e1932), _e1753, _e1947);
                                                    let _e1958 = select(select(_e1860, _e1861, _e1932), _e1862, _e1947);
                                                    let _e1959 = select(select(_e1861, _e1862, _e1932), _e1860, _e1947);
                                                    let _e1962 = ((_e1954 * _e1959) - (_e1955 * _e1958));
                                                    let _e1978 = (((((_e1787 * _e1908) + (_e1801 * _e1894)) * 2.01f) + (((_e1801 * 2f) * (_e1908 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1801) * (1f + _e1908))));
                                                    if (select(_e1962, -(_e1962), (_e1962 < 0f)) > _e1978) {
                                                        let _e1984 = select(1f, -1f, (_e1962 < 0f));
                                                        let _e2003 = (((((_e1680 * _e1908) + (_e1694 * _e1894)) * 2.01f) + (((_e1694 * 2f) * (_e1908 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1694) * (1f + _e1908))));
                                                        let _e2022 = (((((_e1787 * _e1694) + (_e1801 * _e1680)) * 2.01f) + (((_e1801 * 2f) * (_e1694 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1801) * (1f + _e1694))));
                                                        let _e2023 = (_e1962 * _e1984);
                                                        let _e2024 = (((_e1950 * _e1959) - (_e1951 * _e1958)) * _e1984);
                                                        let _e2025 = (((_e1954 * _e1951) - (_e1955 * _e1950)) * _e1984);
                                                        let _e2038 = (((select(_e2023, -(_e2023), (_e2023 < 0f)) + select(_e2024, -(_e2024), (_e2024 < 0f))) + select(_e2025, -(_e2025), (_e2025 < 0f))) * (0.000000059604645f * 4f));
                                                        if (_e232.member != 0u) {
                                                            phi_3813_ = array<type_16, 4>(type_16(_e2024, _e2003), type_16(_e2025, _e2022), type_16((_e2023 - _e2024), ((_e1978 + _e2003) + _e2038)), type_16((_e2023 - _e2025), ((_e1978 + _e2022) + _e2038)));
                                                        } else {
                                                            let _e2041 = ((_e2023 - _e2024) - _e2025);
                                                            let _e2044 = (((_e1978 + _e2003) + _e2022) + _e2038);
                                                            phi_3813_ = array<type_16, 4>(type_16(_e2024, _e2003), type_16(_e2025, _e2022), type_16(_e2041, _e2044), type_16(_e2041, _e2044));
                                                        }
                                                        let _e2062 = phi_3813_;
                                                        local_2 = array<type_16, 4>(type_16(_e2062[0].member, _e2062[0].member_1), type_16(_e2062[1].member, _e2062[1].member_1), type_16(_e2062[2].member, _e2062[2].member_1), type_16(_e2062[3].member, _e2062[3].member_1));
                                                        phi_3833_ = type_9(0u, 4u);
                                                        phi_3836_ = true;
                                                        loop {
                                                            let _e2081 = phi_3833_;
                                                            let _e2083 = phi_3836_;
                                                            local_18 = _e2083;
                                                            let _e2086 = (_e2081.member < _e2081.member_1);
                                                            let _e2097 = select(type_9().member_1, _e2081.member, _e2086);
                                                            if (bitcast<i32>(select(0u, 1u, _e2086)) != 0i) {
                                                                let _e2102 = local_2[_e2097].member;
                                                                let _e2105 = local_2[_e2097].member_1;
                                                                let _e2107 = (_e2102 < -(_e2105));
                                                                phi_3837_ = select((_e2083 && (_e2102 > _e2105)), bool(), _e2107);
                                                                phi_3888_ = select(true, false, _e2107);
                                                                phi_3889_ = _e2107;
                                                            } else {
                                                                phi_3837_ = bool();
                                                                phi_3888_ = false;
                                                                phi_3889_ = false;
                                                            }
                                                            let _e2113 = phi_3837_;
                                                            let _e2115 = phi_3888_;
                                                            let _e2117 = phi_3889_;
                                                            local_17 = _e2117;
                                                            continue;
                                                            continuing {
                                                                phi_3833_ = type_9(select(_e2081.member, (_e2081.member + 1u), _e2086), select(_e2081.member_1, _e2081.member_1, _e2086));
                                                                phi_3836_ = _e2113;
                                                                break if !(_e2115);
                                                            }
                                                        }
                                                        let _e2120 = local_17;
                                                        let _e2121 = select(true, false, _e2120);
                                                        let _e2123 = local_18;
                                                        phi_3903_ = select(u32(), select(2u, 1u, _e2123), _e2121);
                                                        phi_3904_ = 0u;
                                                        phi_3905_ = select(true, false, _e2121);
                                                    } else {
                                                        phi_3903_ = u32();
                                                        phi_3904_ = 2u;
                                                        phi_3905_ = true;
                                                    }
                                                    let _e2128 = phi_3903_;
                                                    let _e2130 = phi_3904_;
                                                    let _e2132 = phi_3905_;
                                                    let _e2133 = select(_e2128, _e2130, _e2132);
                                                    let _e2134 = (_e2133 == 0u);
                                                    if _e2134 {
                                                        phi_3936_ = bool();
                                                        phi_3937_ = false;
                                                        phi_3938_ = false;
                                                    } else {
                                                        let _e2137 = select(false, _e1575.member_2, (_e2133 == 1u));
                                                        let _e2143 = select(true, select(true, false, ((_e1575.member_1 - _e1575.member) <= _e1190)), _e2137);
                                                        phi_3936_ = _e2137;
                                                        phi_3937_ = _e2143;
                                                        phi_3938_ = select(true, false, _e2143);
                                                    }
                                                    let _e2146 = phi_3936_;
                                                    let _e2148 = phi_3937_;
                                                    let _e2150 = phi_3938_;
                                                    phi_3939_ = _e2146;
                                                    phi_3940_ = _e2134;
                                                    phi_3941_ = _e2148;
                                                    phi_3942_ = _e2150;
                                                }
                                                let _e2152 = phi_3939_;
                                                let _e2154 = phi_3940_;
                                                let _e2156 = phi_3941_;
                                                let _e2158 = phi_3942_;
                                                phi_3943_ = _e2152;
                                                phi_3944_ = _e2154;
                                                phi_3945_ = _e2156;
                                                phi_3946_ = _e1580;
                                                phi_3947_ = _e2158;
                                            }
                                            let _e2160 = phi_3943_;
                                            let _e2162 = phi_3944_;
                                            let _e2164 = phi_3945_;
                                            let _e2166 = phi_3946_;
                                            let _e2168 = phi_3947_;
                                            phi_3948_ = _e1575;
                                            phi_3949_ = _e2160;
                                            phi_3950_ = _e1575;
                                            phi_3951_ = _e2162;
                                            phi_3952_ = _e2164;
                                            phi_3953_ = _e2166;
                                            phi_3954_ = _e2168;
                                        }
                                        let _e2170 = phi_3948_;
                                        let _e2172 = phi_3949_;
                                        let _e2174 = phi_3950_;
                                        let _e2176 = phi_3951_;
                                        let _e2178 = phi_3952_;
                                        let _e2180 = phi_3953_;
                                        let _e2182 = phi_3954_;
                                        phi_3955_ = _e2170;
                                        phi_3956_ = _e2172;
                                        phi_3957_ = _e2174;
                                        phi_3958_ = _e2176;
                                        phi_3959_ = _e2178;
                                        phi_3960_ = _e1255;
                                        phi_3961_ = _e2180;
                                        phi_3962_ = _e2182;
                                    } else {
                                        phi_3955_ = type_38();
                                        phi_3956_ = bool();
                                        phi_3957_ = type_38();
                                        phi_3958_ = true;
                                        phi_3959_ = false;
                                        phi_3960_ = false;
                                        phi_3961_ = false;
                                        phi_3962_ = false;
                                    }
                                    let _e2184 = phi_3955_;
                                    let _e2186 = phi_3956_;
                                    let _e2188 = phi_3957_;
                                    let _e2190 = phi_3958_;
                                    let _e2192 = phi_3959_;
                                    let _e2194 = phi_3960_;
                                    let _e2196 = phi_3961_;
                                    let _e2198 = phi_3962_;
                                    phi_3970_ = _e2184;
                                    phi_3971_ = _e2186;
                                    phi_3972_ = _e2188;
                                    phi_3973_ = select(_e2192, false, _e2190);
                                    phi_3974_ = _e2190;
                                    phi_3975_ = select(_e2194, false, _e2190);
                                    phi_3976_ = select(_e2196, false, _e2190);
                                    phi_3977_ = select(_e2198, false, _e2190);
                                } else {
                                    phi_3970_ = type_38(_e361, _e361, false);
                                    phi_3971_ = false;
                                    phi_3972_ = type_38();
                                    phi_3973_ = true;
                                    phi_3974_ = false;
                                    phi_3975_ = false;
                                    phi_3976_ = false;
                                    phi_3977_ = false;
                                }
                                let _e2204 = phi_3970_;
                                let _e2206 = phi_3971_;
                                let _e2208 = phi_3972_;
                                let _e2210 = phi_3973_;
                                let _e2212 = phi_3974_;
                                let _e2214 = phi_3975_;
                                let _e2216 = phi_3976_;
                                let _e2218 = phi_3977_;
                                if _e2210 {
                                    let _e2223 = local_7.member[0u];
                                    let _e2229 = local_7.member_1[0u];
                                    let _e2235 = local_7.member_2[0u];
                                    let _e2239 = (_e2223[0] - _e2229[0]);
                                    let _e2240 = (_e2223[1] - _e2229[1]);
                                    let _e2241 = (_e2223[2] - _e2229[2]);
                                    let _e2242 = (_e232.member == 0u);
                                    let _e2254 = local_7.member[1u];
                                    let _e2260 = local_7.member_1[1u];
                                    let _e2266 = local_7.member_2[1u];
                                    let _e2270 = (_e2254[0] - _e2260[0]);
                                    let _e2271 = (_e2254[1] - _e2260[1]);
                                    let _e2272 = (_e2254[2] - _e2260[2]);
                                    let _e2273 = (_e232.member == 0u);
                                    let _e2285 = local_7.member[0u];
                                    let _e2291 = select(_e2285[0], -(_e2285[0]), (_e2285[0] < 0f));
                                    let _e2294 = select(_e2285[1], -(_e2285[1]), (_e2285[1] < 0f));
                                    let _e2296 = select(_e2294, _e2291, (_e2291 > _e2294));
                                    let _e2299 = select(_e2285[2], -(_e2285[2]), (_e2285[2] < 0f));
                                    let _e2301 = select(_e2299, _e2296, (_e2296 > _e2299));
                                    let _e2304 = local_7.member[1u];
                                    let _e2310 = select(_e2304[0], -(_e2304[0]), (_e2304[0] < 0f));
                                    let _e2313 = select(_e2304[1], -(_e2304[1]), (_e2304[1] < 0f));
                                    let _e2315 = select(_e2313, _e2310, (_e2310 > _e2313));
                                    let _e2318 = select(_e2304[2], -(_e2304[2]), (_e2304[2] < 0f));
                                    let _e2320 = select(_e2318, _e2315, (_e2315 > _e2318));
                                    let _e2324 = local_7.member_3;
                                    let _e2328 = local_7.member_1[0u];
                                    let _e2334 = select(_e2328[0], -(_e2328[0]), (_e2328[0] < 0f));
                                    let _e2337 = select(_e2328[1], -(_e2328[1]), (_e2328[1] < 0f));
                                    let _e2339 = select(_e2337, _e2334, (_e2334 > _e2337));
                                    let _e2342 = select(_e2328[2], -(_e2328[2]), (_e2328[2] < 0f));
                                    let _e2344 = select(_e2342, _e2339, (_e2339 > _e2342));
                                    let _e2347 = local_7.member_1[1u];
                                    let _e2353 = select(_e2347[0], -(_e2347[0]), (_e2347[0] < 0f));
                                    let _e2356 = select(_e2347[1], -(_e2347[1]), (_e2347[1] < 0f));
                                    let _e2358 = select(_e2356, _e2353, (_e2353 > _e2356));
                                    let _e2361 = select(_e2347[2], -(_e2347[2]), (_e2347[2] < 0f));
                                    let _e2363 = select(_e2361, _e2358, (_e2358 > _e2361));
                                    let _e2367 = local_7.member_3;
                                    let _e2371 = local_7.member_2[0u];
                                    let _e2377 = select(_e2371[0], -(_e2371[0]), (_e2371[0] < 0f));
                                    let _e2380 = select(_e2371[1], -(_e2371[1]), (_e2371[1] < 0f));
                                    let _e2382 = select(_e2380, _e2377, (_e2377 > _e2380));
                                    let _e2385 = select(_e2371[2], -(_e2371[2]), (_e2371[2] < 0f));
                                    let _e2387 = select(_e2385, _e2382, (_e2382 > _e2385));
                                    let _e2390 = local_7.member_2[1u];
                                    let _e2396 = select(_e2390[0], -(_e2390[0]), (_e2390[0] < 0f));
                                    let _e2399 = select(_e2390[1], -(_e2390[1]), (_e2390[1] < 0f));
                                    let _e2401 = select(_e2399, _e2396, (_e2396 > _e2399));
                                    let _e2404 = select(_e2390[2], -(_e2390[2]), (_e2390[2] < 0f));
                                    let _e2406 = select(_e2404, _e2401, (_e2401 > _e2404));
                                    let _e2410 = local_7.member_3;
                                    let _e2417 = local_7.member_3;
                                    let _e2422 = (_e359 * 0.00390625f);
                                    local = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_4400_ = type_9(0u, 96u);
                                    phi_4403_ = _e2204.member;
                                    phi_4405_ = _e2204.member;
                                    phi_4407_ = (_e2204.member_1 - _e2204.member);
                                    phi_4409_ = _e2204.member;
                                    phi_4411_ = false;
                                    phi_4413_ = 0u;
                                    loop {
                                        let _e2425 = phi_4400_;
                                        let _e2427 = phi_4403_;
                                        let _e2429 = phi_4405_;
                                        let _e2431 = phi_4407_;
                                        let _e2433 = phi_4409_;
                                        let _e2435 = phi_4411_;
                                        let _e2437 = phi_4413_;
                                        local_28 = _e2427;
                                        local_31 = _e2429;
                                        let _e2440 = (_e2425.member < _e2425.member_1);
                                        if (bitcast<i32>(select(0u, 1u, _e2440)) != 0i) {
                                            let _e2454 = local_7.member[0u];
                                            let _e2460 = local_7.member[1u];
                                            let _e2476 = local_7.member_1[0u];
                                            let _e2482 = local_7.member_1[1u];
                                            let _e2498 = local_7.member_2[0u];
                                            let _e2504 = local_7.member_2[1u];
                                            let _e2518 = function_2(array<f32, 3>((_e2454[0] + ((_e2460[0] - _e2454[0]) * _e2427)), (_e2454[1] + ((_e2460[1] - _e2454[1]) * _e2427)), (_e2454[2] + ((_e2460[2] - _e2454[2]) * _e2427))), array<f32, 3>((_e2476[0] + ((_e2482[0] - _e2476[0]) * _e2427)), (_e2476[1] + ((_e2482[1] - _e2476[1]) * _e2427)), (_e2476[2] + ((_e2482[2] - _e2476[2]) * _e2427))), array<f32, 3>((_e2498[0] + ((_e2504[0] - _e2498[0]) * _e2427)), (_e2498[1] + ((_e2504[1] - _e2498[1]) * _e2427)), (_e2498[2] + ((_e2504[2] - _e2498[2]) * _e2427))), _e232.member);
                                            if (_e2437 == 0u) {
                                                phi_4564_ = _e2518;
                                            } else {
                                                phi_4564_ = array<f32, 3>(select(0f, _e2518[0], (_e2437 == 1u)), select(0f, _e2518[1], (_e2437 == 2u)), select(0f, _e2518[2], (_e2437 == 3u)));
                                            }
                                            let _e2531 = phi_4564_;
                                            let _e2545 = ((select(_e2531[0], -(_e2531[0]), (_e2531[0] < 0f)) + select(_e2531[1], -(_e2531[1]), (_e2531[1] < 0f))) + select(_e2531[2], -(_e2531[2]), (_e2531[2] < 0f)));
                                            if (_e2545 > 0f) {
                                                if ((bitcast<u32>(_e2545) & 2139095040u) != 2139095040u) {
                                                    let _e2550 = (1f / _e2545);
                                                    let _e2552 = (_e2531[0] * _e2550);
                                                    let _e2554 = (_e2531[1] * _e2550);
                                                    let _e2556 = (_e2531[2] * _e2550);
                                                    let _e2561 = (((_e2552 * _e2552) + (_e2554 * _e2554)) + (_e2556 * _e2556));
                                                    if (_e2561 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_4687_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2561 > 0f));
                                                    } else {
                                                        phi_4630_ = type_14(0i, 5i);
                                                        phi_4633_ = bitcast<f32>(((bitcast<u32>(_e2561) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e2569 = phi_4630_;
                                                            let _e2571 = phi_4633_;
                                                            local_19 = _e2571;
                                                            if (_e2569.member < _e2569.member_1) {
                                                                let _e2578 = (_e2569.member + 1i);
                                                                phi_4631_ = type_14(select(_e2578, type_15().member_1, select(false, true, ((false == (_e2578 > _e2569.member)) != false))), _e2569.member_1);
                                                                phi_4674_ = type_15(1u, _e2569.member);
                                                            } else {
                                                                phi_4631_ = _e2569;
                                                                phi_4674_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e2589 = phi_4631_;
                                                            let _e2591 = phi_4674_;
                                                            let _e2594 = (bitcast<i32>(_e2591.member) != 0i);
                                                            if _e2594 {
                                                                phi_4634_ = (0.5f * (_e2571 + (_e2561 / _e2571)));
                                                            } else {
                                                                phi_4634_ = f32();
                                                            }
                                                            let _e2599 = phi_4634_;
                                                            continue;
                                                            continuing {
                                                                phi_4630_ = _e2589;
                                                                phi_4633_ = _e2599;
                                                                break if !(_e2594);
                                                            }
                                                        }
                                                        let _e2604 = local_19;
                                                        phi_4687_ = (_e2604 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e2610 = phi_4687_;
                                                    let _e2611 = (0.000000059604645f * 12f);
                                                    let _e2616 = ((((((((select(_e2320, _e2301, (_e2301 > _e2320)) + _e2324) + (select(_e2363, _e2344, (_e2344 > _e2363)) + _e2367)) + (select(_e2406, _e2387, (_e2387 > _e2406)) + _e2410)) * (0.000000059604645f * 16f)) + (_e2417 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2610) * (1f + _e2611)));
                                                    let _e2621 = (((_e2552 * _e2223[0]) + (_e2554 * _e2223[1])) + (_e2556 * _e2223[2]));
                                                    let _e2626 = (((_e2552 * _e2239) + (_e2554 * _e2240)) + (_e2556 * _e2241));
                                                    let _e2631 = (((_e2552 * (_e2223[0] - _e2235[0])) + (_e2554 * (_e2223[1] - _e2235[1]))) + (_e2556 * (_e2223[2] - _e2235[2])));
                                                    let _e2636 = (((_e2552 * select((_e2239 - _e2235[0]), _e2223[0], _e2242)) + (_e2554 * select((_e2240 - _e2235[1]), _e2223[1], _e2242))) + (_e2556 * select((_e2241 - _e2235[2]), _e2223[2], _e2242)));
                                                    let _e2642 = (((_e2552 * _e2254[0]) + (_e2554 * _e2254[1])) + (_e2556 * _e2254[2]));
                                                    let _e2647 = (((_e2552 * _e2270) + (_e2554 * _e2271)) + (_e2556 * _e2272));
                                                    let _e2652 = (((_e2552 * (_e2254[0] - _e2266[0])) + (_e2554 * (_e2254[1] - _e2266[1]))) + (_e2556 * (_e2254[2] - _e2266[2])));
                                                    let _e2657 = (((_e2552 * select((_e2270 - _e2266[0]), _e2254[0], _e2273)) + (_e2554 * select((_e2271 - _e2266[1]), _e2254[1], _e2273))) + (_e2556 * select((_e2272 - _e2266[2]), _e2254[2], _e2273)));
                                                    phi_4810_ = type_30(array<f32, 4>(_e2621, _e2626, _e2631, _e2636), array<f32, 4>(_e2642, _e2647, _e2652, _e2657), array<f32, 4>((_e2616 + ((select(_e2621, -(_e2621), (_e2621 < 0f)) + select(_e2642, -(_e2642), (_e2642 < 0f))) * _e2611)), (_e2616 + ((select(_e2626, -(_e2626), (_e2626 < 0f)) + select(_e2647, -(_e2647), (_e2647 < 0f))) * _e2611)), (_e2616 + ((select(_e2631, -(_e2631), (_e2631 < 0f)) + select(_e2652, -(_e2652), (_e2652 < 0f))) * _e2611)), (_e2616 + ((select(_e2636, -(_e2636), (_e2636 < 0f)) + select(_e2657, -(_e2657), (_e2657 < 0f))) * _e2611))));
                                                    phi_4811_ = false;
                                                } else {
                                                    phi_4810_ = type_30();
                                                    phi_4811_ = true;
                                                }
                                                let _e2698 = phi_4810_;
                                                let _e2700 = phi_4811_;
                                                phi_4812_ = _e2698;
                                                phi_4813_ = _e2700;
                                            } else {
                                                phi_4812_ = type_30();
                                                phi_4813_ = true;
                                            }
                                            let _e2702 = phi_4812_;
                                            let _e2704 = phi_4813_;
                                            if _e2704 {
                                                phi_4821_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_4821_ = _e2702;
                                            }
                                            let _e2706 = phi_4821_;
                                            local_1 = type_30(array<f32, 4>(_e2706.member[0], _e2706.member[1], _e2706.member[2], _e2706.member[3]), array<f32, 4>(_e2706.member_1[0], _e2706.member_1[1], _e2706.member_1[2], _e2706.member_1[3]), array<f32, 4>(_e2706.member_2[0], _e2706.member_2[1], _e2706.member_2[2], _e2706.member_2[3]));
                                            let _e2726 = (_e2427 - _e2433);
                                            let _e2730 = local_1.member[0u];
                                            let _e2733 = local_1.member_1[0u];
                                            let _e2736 = local_1.member[0u];
                                            let _e2742 = local_1.member_2[0u];
                                            if (((_e2730 + ((_e2733 - _e2736) * _e2427)) - _e2742) > 0f) {
                                                let _e2747 = local_1.member[1u];
                                                let _e2750 = local_1.member_1[1u];
                                                let _e2753 = local_1.member[1u];
                                                let _e2759 = local_1.member_2[1u];
                                                if (((_e2747 + ((_e2750 - _e2753) * _e2427)) - _e2759) > 0f) {
                                                    let _e2764 = local_1.member[2u];
                                                    let _e2767 = local_1.member_1[2u];
                                                    let _e2770 = local_1.member[2u];
                                                    let _e2776 = local_1.member_2[2u];
                                                    if (((_e2764 + ((_e2767 - _e2770) * _e2427)) - _e2776) > 0f) {
                                                        let _e2781 = local_1.member[3u];
                                                        let _e2784 = local_1.member_1[3u];
                                                        let _e2787 = local_1.member[3u];
                                                        let _e2793 = local_1.member_2[3u];
                                                        phi_4992_ = (((_e2781 + ((_e2784 - _e2787) * _e2427)) - _e2793) > 0f);
                                                        phi_4993_ = false;
                                                    } else {
                                                        phi_4992_ = bool();
                                                        phi_4993_ = true;
                                                    }
                                                    let _e2797 = phi_4992_;
                                                    let _e2799 = phi_4993_;
                                                    phi_4994_ = _e2797;
                                                    phi_4995_ = _e2799;
                                                } else {
                                                    phi_4994_ = bool();
                                                    phi_4995_ = true;
                                                }
                                                let _e2801 = phi_4994_;
                                                let _e2803 = phi_4995_;
                                                phi_4996_ = _e2801;
                                                phi_4997_ = _e2803;
                                            } else {
                                                phi_4996_ = bool();
                                                phi_4997_ = true;
                                            }
                                            let _e2805 = phi_4996_;
                                            let _e2807 = phi_4997_;
                                            if select(_e2805, false, _e2807) {
                                                if (_e2427 <= _e2429) {
                                                    phi_5311_ = true;
                                                } else {
                                                    let _e2812 = local.member[0u];
                                                    let _e2815 = local.member_1[0u];
                                                    let _e2818 = local.member[0u];
                                                    let _e2824 = local.member_2[0u];
                                                    let _e2828 = local_1.member[0u];
                                                    let _e2831 = local_1.member_1[0u];
                                                    let _e2834 = local_1.member[0u];
                                                    let _e2840 = local_1.member_2[0u];
                                                    if ((((_e2812 + ((_e2815 - _e2818) * _e2427)) - _e2824) + ((_e2828 + ((_e2831 - _e2834) * _e2433)) - _e2840)) > 0f) {
                                                        let _e2846 = local.member[1u];
                                                        let _e2849 = local.member_1[1u];
                                                        let _e2852 = local.member[1u];
                                                        let _e2858 = local.member_2[1u];
                                                        let _e2862 = local_1.member[1u];
                                                        let _e2865 = local_1.member_1[1u];
                                                        let _e2868 = local_1.member[1u];
                                                        let _e2874 = local_1.member_2[1u];
                                                        if ((((_e2846 + ((_e2849 - _e2852) * _e2427)) - _e2858) + ((_e2862 + ((_e2865 - _e2868) * _e2433)) - _e2874)) > 0f) {
                                                            let _e2880 = local.member[2u];
                                                            let _e2883 = local.member_1[2u];
                                                            let _e2886 = local.member[2u];
                                                            let _e2892 = local.member_2[2u];
                                                            let _e2896 = local_1.member[2u];
                                                            let _e2899 = local_1.member_1[2u];
                                                            let _e2902 = local_1.member[2u];
                                                            let _e2908 = local_1.member_2[2u];
                                                            if ((((_e2880 + ((_e2883 - _e2886) * _e2427)) - _e2892) + ((_e2896 + ((_e2899 - _e2902) * _e2433)) - _e2908)) > 0f) {
                                                                let _e2914 = local.member[3u];
                                                                let _e2917 = local.member_1[3u];
                                                                let _e2920 = local.member[3u];
                                                                let _e2926 = local.member_2[3u];
                                                                let _e2930 = local_1.member[3u];
                                                                let _e2933 = local_1.member_1[3u];
                                                                let _e2936 = local_1.member[3u];
                                                                let _e2942 = local_1.member_2[3u];
                                                                phi_5298_ = ((((_e2914 + ((_e2917 - _e2920) * _e2427)) - _e2926) + ((_e2930 + ((_e2933 - _e2936) * _e2433)) - _e2942)) > 0f);
                                                                phi_5299_ = false;
                                                            } else {
                                                                phi_5298_ = bool();
                                                                phi_5299_ = true;
                                                            }
                                                            let _e2947 = phi_5298_;
                                                            let _e2949 = phi_5299_;
                                                            phi_5300_ = _e2947;
                                                            phi_5301_ = _e2949;
                                                        } else {
                                                            phi_5300_ = bool();
                                                            phi_5301_ = true;
                                                        }
                                                        let _e2951 = phi_5300_;
                                                        let _e2953 = phi_5301_;
                                                        phi_5302_ = _e2951;
                                                        phi_5303_ = _e2953;
                                                    } else {
                                                        phi_5302_ = bool();
                                                        phi_5303_ = true;
                                                    }
                                                    let _e2955 = phi_5302_;
                                                    let _e2957 = phi_5303_;
                                                    phi_5311_ = select(_e2955, false, _e2957);
                                                }
                                                let _e2960 = phi_5311_;
                                                if _e2960 {
                                                    if select(true, select(true, false, (_e2427 >= _e2204.member_1)), _e2435) {
                                                        local = type_30(array<f32, 4>(_e2706.member[0], _e2706.member[1], _e2706.member[2], _e2706.member[3]), array<f32, 4>(_e2706.member_1[0], _e2706.member_1[1], _e2706.member_1[2], _e2706.member_1[3]), array<f32, 4>(_e2706.member_2[0], _e2706.member_2[1], _e2706.member_2[2], _e2706.member_2[3]));
                                                        let _e2985 = local.member[0u];
                                                        let _e2988 = local.member_1[0u];
                                                        let _e2991 = local.member_2[0u];
                                                        if select(true, select(true, false, (_e2988 > _e2991)), (_e2985 > _e2991)) {
                                                            let _e2996 = (_e2988 >= _e2985);
                                                            if _e2996 {
                                                                phi_5420_ = f32();
                                                                phi_5421_ = false;
                                                            } else {
                                                                if ((_e2985 - _e2988) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_5418_ = (((_e2985 - _e2991) / (_e2985 - _e2988)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_5419_ = false;
                                                                } else {
                                                                    phi_5418_ = f32();
                                                                    phi_5419_ = true;
                                                                }
                                                                let _e3007 = phi_5418_;
                                                                let _e3009 = phi_5419_;
                                                                phi_5420_ = _e3007;
                                                                phi_5421_ = _e3009;
                                                            }
                                                            let _e3011 = phi_5420_;
                                                            let _e3013 = phi_5421_;
                                                            phi_5422_ = _e3011;
                                                            phi_5423_ = _e2996;
                                                            phi_5424_ = _e3013;
                                                        } else {
                                                            phi_5422_ = f32();
                                                            phi_5423_ = true;
                                                            phi_5424_ = false;
                                                        }
                                                        let _e3015 = phi_5422_;
                                                        let _e3017 = phi_5423_;
                                                        let _e3019 = phi_5424_;
                                                        let _e3022 = select(_e3015, select(_e2427, 2f, _e3017), select(_e3019, true, _e3017));
                                                        let _e3025 = local.member[1u];
                                                        let _e3028 = local.member_1[1u];
                                                        let _e3031 = local.member_2[1u];
                                                        if select(true, select(true, false, (_e3028 > _e3031)), (_e3025 > _e3031)) {
                                                            let _e3036 = (_e3028 >= _e3025);
                                                            if _e3036 {
                                                                phi_5488_ = f32();
                                                                phi_5489_ = false;
                                                            } else {
                                                                if ((_e3025 - _e3028) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_5486_ = (((_e3025 - _e3031) / (_e3025 - _e3028)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_5487_ = false;
                                                                } else {
                                                                    phi_5486_ = f32();
                                                                    phi_5487_ = true;
                                                                }
                                                                let _e3047 = phi_5486_;
                                                                let _e3049 = phi_5487_;
                                                                phi_5488_ = _e3047;
                                                                phi_5489_ = _e3049;
                                                            }
                                                            let _e3051 = phi_5488_;
                                                            let _e3053 = phi_5489_;
                                                            phi_5490_ = _e3051;
                                                            phi_5491_ = _e3036;
                                                            phi_5492_ = _e3053;
                                                        } else {
                                                            phi_5490_ = f32();
                                                            phi_5491_ = true;
                                                            phi_5492_ = false;
                                                        }
                                                        let _e3055 = phi_5490_;
                                                        let _e3057 = phi_5491_;
                                                        let _e3059 = phi_5492_;
                                                        let _e3062 = select(_e3055, select(_e2427, 2f, _e3057), select(_e3059, true, _e3057));
                                                        let _e3064 = select(_e3062, _e3022, (_e3022 < _e3062));
                                                        let _e3067 = local.member[2u];
                                                        let _e3070 = local.member_1[2u];
                                                        let _e3073 = local.member_2[2u];
                                                        if select(true, select(true, false, (_e3070 > _e3073)), (_e3067 > _e3073)) {
                                                            let _e3078 = (_e3070 >= _e3067);
                                                            if _e3078 {
                                                                phi_5561_ = f32();
                                                                phi_5562_ = false;
                                                            } else {
                                                                if ((_e3067 - _e3070) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_5559_ = (((_e3067 - _e3073) / (_e3067 - _e3070)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_5560_ = false;
                                                                } else {
                                                                    phi_5559_ = f32();
                                                                    phi_5560_ = true;
                                                                }
                                                                let _e3089 = phi_5559_;
                                                                let _e3091 = phi_5560_;
                                                                phi_5561_ = _e3089;
                                                                phi_5562_ = _e3091;
                                                            }
                                                            let _e3093 = phi_5561_;
                                                            let _e3095 = phi_5562_;
                                                            phi_5563_ = _e3093;
                                                            phi_5564_ = _e3078;
                                                            phi_5565_ = _e3095;
                                                        } else {
                                                            phi_5563_ = f32();
                                                            phi_5564_ = true;
                                                            phi_5565_ = false;
                                                        }
                                                        let _e3097 = phi_5563_;
                                                        let _e3099 = phi_5564_;
                                                        let _e3101 = phi_5565_;
                                                        let _e3104 = select(_e3097, select(_e2427, 2f, _e3099), select(_e3101, true, _e3099));
                                                        let _e3107 = local.member[3u];
                                                        let _e3110 = local.member_1[3u];
                                                        let _e3113 = local.member_2[3u];
                                                        if select(true, select(true, false, (_e3110 > _e3113)), (_e3107 > _e3113)) {
                                                            let _e3118 = (_e3110 >= _e3107);
                                                            if _e3118 {
                                                                phi_5629_ = f32();
                                                                phi_5630_ = false;
                                                            } else {
                                                                if ((_e3107 - _e3110) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_5627_ = (((_e3107 - _e3113) / (_e3107 - _e3110)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_5628_ = false;
                                                                } else {
                                                                    phi_5627_ = f32();
                                                                    phi_5628_ = true;
                                                                }
                                                                let _e3129 = phi_5627_;
                                                                let _e3131 = phi_5628_;
                                                                phi_5629_ = _e3129;
                                                                phi_5630_ = _e3131;
                                                            }
                                                            let _e3133 = phi_5629_;
                                                            let _e3135 = phi_5630_;
                                                            phi_5631_ = _e3133;
                                                            phi_5632_ = _e3118;
                                                            phi_5633_ = _e3135;
                                                        } else {
                                                            phi_5631_ = f32();
                                                            phi_5632_ = true;
                                                            phi_5633_ = false;
                                                        }
                                                        let _e3137 = phi_5631_;
                                                        let _e3139 = phi_5632_;
                                                        let _e3141 = phi_5633_;
                                                        let _e3144 = select(_e3137, select(_e2427, 2f, _e3139), select(_e3141, true, _e3139));
                                                        let _e3146 = select(_e3144, _e3104, (_e3104 < _e3144));
                                                        let _e3148 = select(_e3146, _e3064, (_e3064 < _e3146));
                                                        let _e3150 = select(_e2427, _e3148, (_e3148 > _e2427));
                                                        let _e3151 = (_e3150 > _e2204.member_1);
                                                        if _e3151 {
                                                            phi_6162_ = f32();
                                                            phi_6163_ = f32();
                                                            phi_6164_ = false;
                                                        } else {
                                                            let _e3152 = (_e3150 - _e2427);
                                                            phi_6162_ = select((_e2204.member_1 - _e2427), select(0f, (_e2726 + _e2726), select(select(true, false, (_e3152 <= (_e2431 * 0.25f))), true, (_e3152 <= _e2422))), _e2435);
                                                            phi_6163_ = _e3152;
                                                            phi_6164_ = true;
                                                        }
                                                        let _e3163 = phi_6162_;
                                                        let _e3165 = phi_6163_;
                                                        let _e3167 = phi_6164_;
                                                        phi_6166_ = _e3150;
                                                        phi_6167_ = _e3163;
                                                        phi_6168_ = _e3165;
                                                        phi_6170_ = _e3167;
                                                        phi_6171_ = _e3151;
                                                        phi_6173_ = false;
                                                    } else {
                                                        phi_6166_ = f32();
                                                        phi_6167_ = f32();
                                                        phi_6168_ = f32();
                                                        phi_6170_ = false;
                                                        phi_6171_ = false;
                                                        phi_6173_ = true;
                                                    }
                                                    let _e3169 = phi_6166_;
                                                    let _e3171 = phi_6167_;
                                                    let _e3173 = phi_6168_;
                                                    let _e3175 = phi_6170_;
                                                    let _e3177 = phi_6171_;
                                                    let _e3179 = phi_6173_;
                                                    phi_6174_ = _e3169;
                                                    phi_6175_ = _e3171;
                                                    phi_6176_ = _e3173;
                                                    phi_6178_ = false;
                                                    phi_6179_ = _e3175;
                                                    phi_6180_ = _e3177;
                                                    phi_6182_ = _e3179;
                                                } else {
                                                    phi_6174_ = f32();
                                                    phi_6175_ = f32();
                                                    phi_6176_ = f32();
                                                    phi_6178_ = true;
                                                    phi_6179_ = false;
                                                    phi_6180_ = false;
                                                    phi_6182_ = false;
                                                }
                                                let _e3181 = phi_6174_;
                                                let _e3183 = phi_6175_;
                                                let _e3185 = phi_6176_;
                                                let _e3187 = phi_6178_;
                                                let _e3189 = phi_6179_;
                                                let _e3191 = phi_6180_;
                                                let _e3193 = phi_6182_;
                                                phi_6183_ = _e3181;
                                                phi_6184_ = _e3183;
                                                phi_6185_ = _e3185;
                                                phi_6187_ = _e3187;
                                                phi_6188_ = _e3189;
                                                phi_6189_ = _e3191;
                                                phi_6191_ = _e3193;
                                            } else {
                                                phi_6183_ = f32();
                                                phi_6184_ = f32();
                                                phi_6185_ = f32();
                                                phi_6187_ = true;
                                                phi_6188_ = false;
                                                phi_6189_ = false;
                                                phi_6191_ = false;
                                            }
                                            let _e3195 = phi_6183_;
                                            let _e3197 = phi_6184_;
                                            let _e3199 = phi_6185_;
                                            let _e3201 = phi_6187_;
                                            let _e3203 = phi_6188_;
                                            let _e3205 = phi_6189_;
                                            let _e3207 = phi_6191_;
                                            if _e3201 {
                                                if (_e2427 <= _e2429) {
                                                    let _e3360 = (_e2437 + 1u);
                                                    let _e3361 = (_e3360 > 3u);
                                                    phi_6526_ = _e3360;
                                                    phi_6527_ = f32();
                                                    phi_6528_ = false;
                                                    phi_6529_ = select(true, false, _e3361);
                                                    phi_6530_ = _e3361;
                                                } else {
                                                    let _e3211 = local.member[0u];
                                                    let _e3214 = local.member_1[0u];
                                                    let _e3217 = local.member[0u];
                                                    let _e3223 = local.member_2[0u];
                                                    let _e3224 = ((_e3211 + ((_e3214 - _e3217) * _e2433)) - _e3223);
                                                    let _e3227 = local.member[1u];
                                                    let _e3230 = local.member_1[1u];
                                                    let _e3233 = local.member[1u];
                                                    let _e3239 = local.member_2[1u];
                                                    let _e3240 = ((_e3227 + ((_e3230 - _e3233) * _e2433)) - _e3239);
                                                    let _e3242 = select(_e3240, _e3224, (_e3224 < _e3240));
                                                    let _e3245 = local.member[2u];
                                                    let _e3248 = local.member_1[2u];
                                                    let _e3251 = local.member[2u];
                                                    let _e3257 = local.member_2[2u];
                                                    let _e3258 = ((_e3245 + ((_e3248 - _e3251) * _e2433)) - _e3257);
                                                    let _e3261 = local.member[3u];
                                                    let _e3264 = local.member_1[3u];
                                                    let _e3267 = local.member[3u];
                                                    let _e3273 = local.member_2[3u];
                                                    let _e3274 = ((_e3261 + ((_e3264 - _e3267) * _e2433)) - _e3273);
                                                    let _e3276 = select(_e3274, _e3258, (_e3258 < _e3274));
                                                    let _e3278 = select(_e3276, _e3242, (_e3242 < _e3276));
                                                    let _e3281 = local_1.member[0u];
                                                    let _e3284 = local_1.member_1[0u];
                                                    let _e3287 = local_1.member[0u];
                                                    let _e3293 = local_1.member_2[0u];
                                                    let _e3294 = ((_e3281 + ((_e3284 - _e3287) * _e2427)) - _e3293);
                                                    let _e3297 = local_1.member[1u];
                                                    let _e3300 = local_1.member_1[1u];
                                                    let _e3303 = local_1.member[1u];
                                                    let _e3309 = local_1.member_2[1u];
                                                    let _e3310 = ((_e3297 + ((_e3300 - _e3303) * _e2427)) - _e3309);
                                                    let _e3312 = select(_e3310, _e3294, (_e3294 < _e3310));
                                                    let _e3315 = local_1.member[2u];
                                                    let _e3318 = local_1.member_1[2u];
                                                    let _e3321 = local_1.member[2u];
                                                    let _e3327 = local_1.member_2[2u];
                                                    let _e3328 = ((_e3315 + ((_e3318 - _e3321) * _e2427)) - _e3327);
                                                    let _e3331 = local_1.member[3u];
                                                    let _e3334 = local_1.member_1[3u];
                                                    let _e3337 = local_1.member[3u];
                                                    let _e3343 = local_1.member_2[3u];
                                                    let _e3344 = ((_e3331 + ((_e3334 - _e3337) * _e2427)) - _e3343);
                                                    let _e3346 = select(_e3344, _e3328, (_e3328 < _e3344));
                                                    let _e3348 = select(_e3346, _e3312, (_e3312 < _e3346));
                                                    if (_e3348 > 0f) {
                                                        phi_6524_ = 0.5f;
                                                    } else {
                                                        let _e3352 = (0.95f * (_e3278 / (_e3278 - _e3348)));
                                                        phi_6524_ = select(0.0625f, select(0.9f, _e3352, (_e3352 < 0.9f)), (_e3352 > 0.0625f));
                                                    }
                                                    let _e3358 = phi_6524_;
                                                    phi_6526_ = u32();
                                                    phi_6527_ = (_e2726 * _e3358);
                                                    phi_6528_ = true;
                                                    phi_6529_ = false;
                                                    phi_6530_ = false;
                                                }
                                                let _e3364 = phi_6526_;
                                                let _e3366 = phi_6527_;
                                                let _e3368 = phi_6528_;
                                                let _e3370 = phi_6529_;
                                                let _e3372 = phi_6530_;
                                                phi_6531_ = _e3364;
                                                phi_6532_ = _e2429;
                                                phi_6533_ = _e3366;
                                                phi_6534_ = _e2431;
                                                phi_6535_ = _e2433;
                                                phi_6536_ = _e2435;
                                                phi_6537_ = _e2437;
                                                phi_6538_ = _e3368;
                                                phi_6539_ = _e3370;
                                                phi_6540_ = _e3372;
                                                phi_6541_ = false;
                                                phi_6543_ = false;
                                            } else {
                                                phi_6531_ = u32();
                                                phi_6532_ = _e3195;
                                                phi_6533_ = _e3197;
                                                phi_6534_ = _e3199;
                                                phi_6535_ = _e2427;
                                                phi_6536_ = true;
                                                phi_6537_ = 0u;
                                                phi_6538_ = _e3203;
                                                phi_6539_ = false;
                                                phi_6540_ = false;
                                                phi_6541_ = _e3205;
                                                phi_6543_ = _e3207;
                                            }
                                            let _e3374 = phi_6531_;
                                            let _e3376 = phi_6532_;
                                            let _e3378 = phi_6533_;
                                            let _e3380 = phi_6534_;
                                            let _e3382 = phi_6535_;
                                            let _e3384 = phi_6536_;
                                            let _e3386 = phi_6537_;
                                            let _e3388 = phi_6538_;
                                            let _e3390 = phi_6539_;
                                            let _e3392 = phi_6540_;
                                            let _e3394 = phi_6541_;
                                            let _e3396 = phi_6543_;
                                            if _e3388 {
                                                let _e3397 = (_e3382 + _e3378);
                                                let _e3399 = select(_e3376, _e3397, (_e3397 > _e3376));
                                                let _e3401 = select(_e2204.member_1, _e3399, (_e3399 < _e2204.member_1));
                                                let _e3404 = select(((_e3401 - _e3382) > _e2422), true, !(_e2435));
                                                phi_6571_ = _e3401;
                                                phi_6572_ = _e3376;
                                                phi_6573_ = _e3380;
                                                phi_6574_ = _e3382;
                                                phi_6575_ = _e3384;
                                                phi_6576_ = _e3386;
                                                phi_6577_ = _e3404;
                                                phi_6578_ = select(true, false, _e3404);
                                                phi_6579_ = false;
                                                phi_6580_ = false;
                                                phi_6582_ = false;
                                            } else {
                                                phi_6571_ = _e2427;
                                                phi_6572_ = _e2429;
                                                phi_6573_ = _e2431;
                                                phi_6574_ = _e2433;
                                                phi_6575_ = _e2435;
                                                phi_6576_ = _e3374;
                                                phi_6577_ = _e3390;
                                                phi_6578_ = false;
                                                phi_6579_ = _e3392;
                                                phi_6580_ = _e3394;
                                                phi_6582_ = _e3396;
                                            }
                                            let _e3407 = phi_6571_;
                                            let _e3409 = phi_6572_;
                                            let _e3411 = phi_6573_;
                                            let _e3413 = phi_6574_;
                                            let _e3415 = phi_6575_;
                                            let _e3417 = phi_6576_;
                                            let _e3419 = phi_6577_;
                                            let _e3421 = phi_6578_;
                                            let _e3423 = phi_6579_;
                                            let _e3425 = phi_6580_;
                                            let _e3427 = phi_6582_;
                                            phi_4404_ = _e3407;
                                            phi_4406_ = _e3409;
                                            phi_4408_ = _e3411;
                                            phi_4410_ = _e3413;
                                            phi_4412_ = _e3415;
                                            phi_4414_ = _e3417;
                                            phi_6583_ = _e3376;
                                            phi_6585_ = _e3419;
                                            phi_6586_ = _e3421;
                                            phi_6587_ = _e3423;
                                            phi_6588_ = _e3425;
                                            phi_6590_ = false;
                                            phi_6591_ = _e3427;
                                        } else {
                                            phi_4404_ = f32();
                                            phi_4406_ = f32();
                                            phi_4408_ = f32();
                                            phi_4410_ = f32();
                                            phi_4412_ = bool();
                                            phi_4414_ = u32();
                                            phi_6583_ = f32();
                                            phi_6585_ = false;
                                            phi_6586_ = false;
                                            phi_6587_ = false;
                                            phi_6588_ = false;
                                            phi_6590_ = true;
                                            phi_6591_ = false;
                                        }
                                        let _e3429 = phi_4404_;
                                        let _e3431 = phi_4406_;
                                        let _e3433 = phi_4408_;
                                        let _e3435 = phi_4410_;
                                        let _e3437 = phi_4412_;
                                        let _e3439 = phi_4414_;
                                        let _e3441 = phi_6583_;
                                        let _e3443 = phi_6585_;
                                        let _e3445 = phi_6586_;
                                        let _e3447 = phi_6587_;
                                        let _e3449 = phi_6588_;
                                        let _e3451 = phi_6590_;
                                        let _e3453 = phi_6591_;
                                        local_20 = _e3445;
                                        local_21 = _e3447;
                                        local_22 = _e3445;
                                        local_23 = _e3449;
                                        local_24 = _e3445;
                                        local_25 = _e3451;
                                        local_26 = _e3445;
                                        local_27 = _e3453;
                                        local_29 = _e3445;
                                        local_30 = _e3441;
                                        continue;
                                        continuing {
                                            phi_4400_ = type_9(select(_e2425.member, (_e2425.member + 1u), _e2440), select(_e2425.member_1, _e2425.member_1, _e2440));
                                            phi_4403_ = _e3429;
                                            phi_4405_ = _e3431;
                                            phi_4407_ = _e3433;
                                            phi_4409_ = _e3435;
                                            phi_4411_ = _e3437;
                                            phi_4413_ = _e3439;
                                            break if !(_e3443);
                                        }
                                    }
                                    let _e3456 = local_20;
                                    let _e3458 = local_21;
                                    let _e3459 = select(_e3458, false, _e3456);
                                    let _e3461 = local_22;
                                    let _e3463 = local_23;
                                    let _e3466 = local_24;
                                    let _e3468 = local_25;
                                    let _e3471 = local_26;
                                    let _e3473 = local_27;
                                    let _e3479 = local_28;
                                    let _e3481 = select(select(_e3463, false, _e3461), false, _e3459);
                                    let _e3483 = local_29;
                                    let _e3490 = select(select(_e3483, false, _e3459), false, _e3481);
                                    let _e3495 = local_30;
                                    let _e3497 = local_31;
                                    let _e3499 = select(select(select(select(_e3468, false, _e3466), false, _e3459), false, _e3481), true, _e3490);
                                    let _e3506 = select(select(select(select(select(_e3473, false, _e3471), false, _e3459), false, _e3481), false, _e3490), false, _e3499);
                                    let _e3511 = select(select(select(select(_e3459, true, _e3481), false, _e3490), false, _e3499), true, _e3506);
                                    let _e3514 = (select(select(type_33().member, 1u, _e3499), select(select(select(type_33().member, 1u, _e3459), 0u, _e3481), 0u, _e3506), _e3511) != 0u);
                                    phi_6659_ = select(select(type_33().member_1, select(_e3497, _e3495, _e3490), _e3499), select(select(select(type_33().member_1, _e3479, _e3459), type_33().member_1, _e3481), type_33().member_1, _e3506), _e3511);
                                    phi_6660_ = select(true, false, _e3514);
                                    phi_6661_ = _e3514;
                                    phi_6662_ = false;
                                    phi_6663_ = false;
                                    phi_6664_ = false;
                                } else {
                                    phi_6659_ = f32();
                                    phi_6660_ = _e2212;
                                    phi_6661_ = false;
                                    phi_6662_ = _e2214;
                                    phi_6663_ = _e2216;
                                    phi_6664_ = _e2218;
                                }
                                let _e3517 = phi_6659_;
                                let _e3519 = phi_6660_;
                                let _e3521 = phi_6661_;
                                let _e3523 = phi_6662_;
                                let _e3525 = phi_6663_;
                                let _e3527 = phi_6664_;
                                phi_6665_ = _e2204;
                                phi_6666_ = _e2206;
                                phi_6667_ = _e3517;
                                phi_6668_ = _e2208;
                                phi_6669_ = _e3519;
                                phi_6670_ = _e3521;
                                phi_6671_ = false;
                                phi_6672_ = _e3523;
                                phi_6673_ = _e3525;
                                phi_6674_ = _e3527;
                            } else {
                                phi_6665_ = type_38();
                                phi_6666_ = bool();
                                phi_6667_ = f32();
                                phi_6668_ = type_38();
                                phi_6669_ = false;
                                phi_6670_ = false;
                                phi_6671_ = true;
                                phi_6672_ = false;
                                phi_6673_ = false;
                                phi_6674_ = false;
                            }
                            let _e3529 = phi_6665_;
                            let _e3531 = phi_6666_;
                            let _e3533 = phi_6667_;
                            let _e3535 = phi_6668_;
                            let _e3537 = phi_6669_;
                            let _e3539 = phi_6670_;
                            let _e3541 = phi_6671_;
                            let _e3543 = phi_6672_;
                            let _e3545 = phi_6673_;
                            let _e3547 = phi_6674_;
                            local_32 = _e3539;
                            local_33 = _e3531;
                            local_34 = _e3529;
                            local_35 = _e3533;
                            local_36 = _e3533;
                            local_37 = _e3533;
                            local_41 = _e3541;
                            local_42 = _e3543;
                            local_43 = _e3545;
                            local_44 = _e3547;
                            local_38 = _e3539;
                            local_39 = _e3535;
                            continue;
                            continuing {
                                phi_2545_ = type_9(select(_e1226.member, (_e1226.member + 1u), _e1229), select(_e1226.member_1, _e1226.member_1, _e1229));
                                break if !(_e3537);
                            }
                        }
                        let _e3550 = local_32;
                        if _e3550 {
                            let _e3552 = local_33;
                            if _e3552 {
                                let _e3554 = local_34;
                                let _e3557 = local_35;
                                let _e3559 = ((_e3554.member_1 - _e3557) <= _e1190);
                                let _e3564 = local_36;
                                phi_6690_ = type_33(select(type_33().member, 1u, _e3559), select(type_33().member_1, _e3564, _e3559));
                                phi_6691_ = select(true, false, _e3559);
                            } else {
                                phi_6690_ = type_33();
                                phi_6691_ = true;
                            }
                            let _e3569 = phi_6690_;
                            let _e3571 = phi_6691_;
                            let _e3576 = local_37;
                            phi_6697_ = type_33(select(_e3569.member, 2u, _e3571), select(_e3569.member_1, _e3576, _e3571));
                            phi_6698_ = false;
                            phi_6699_ = false;
                            phi_6700_ = false;
                            phi_6701_ = false;
                        } else {
                            phi_6697_ = type_33();
                            let _e4094 = local_41;
                            phi_6698_ = _e4094;
                            let _e4097 = local_42;
                            phi_6699_ = _e4097;
                            let _e4100 = local_43;
                            phi_6700_ = _e4100;
                            let _e4103 = local_44;
                            phi_6701_ = _e4103;
                        }
                        let _e3580 = phi_6697_;
                        let _e3582 = phi_6698_;
                        let _e3584 = phi_6699_;
                        let _e3586 = phi_6700_;
                        let _e3588 = phi_6701_;
                        let _e3595 = select(_e3584, false, _e3582);
                        let _e3599 = local_38;
                        let _e3606 = select(select(_e3586, false, _e3582), false, _e3595);
                        let _e3612 = select(select(select(_e3588, false, _e3582), false, _e3595), false, _e3606);
                        let _e3616 = local_39;
                        let _e3620 = select(select(_e3595, true, _e3606), true, _e3612);
                        phi_6743_ = type_33(select(_e3580.member, select(select(select(type_33().member, 0u, _e3595), 0u, _e3606), 1u, _e3612), _e3620), select(_e3580.member_1, select(select(select(type_33().member_1, type_33().member_1, _e3595), type_33().member_1, _e3606), _e3616.member, _e3612), _e3620));
                        phi_6744_ = type_33(select(type_33().member, 0u, _e3582), select(type_33().member_1, type_33().member_1, _e3582));
                        phi_6745_ = select(select(select(select(select(_e3599, false, _e3582), false, _e3595), false, _e3606), false, _e3612), true, _e3620);
                    }
                    let _e3631 = phi_6743_;
                    let _e3633 = phi_6744_;
                    let _e3635 = phi_6745_;
                    let _e3638 = select(_e3633.member, _e3631.member, _e3635);
                    let _e3641 = select(_e3633.member_1, _e3631.member_1, _e3635);
                    let _e3647 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e3641 > _e361)), (_e3638 == 1u))));
                    switch bitcast<i32>(_e3638) {
                        case 0: {
                            phi_6789_ = type_31(0u, _e3647, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e3651 = function_3(_e3641);
                            phi_6789_ = type_31(0u, _e3647, _e3651, true);
                            break;
                        }
                        case 2: {
                            let _e3649 = function_3(_e3641);
                            phi_6789_ = type_31(1u, _e3647, _e3649, true);
                            break;
                        }
                        default: {
                            phi_6789_ = type_31();
                            break;
                        }
                    }
                    let _e3655 = phi_6789_;
                    let _e3659 = params.member.member.member_12;
                    let _e3660 = bitcast<u32>(_e3659);
                    if (_e3655.member_2[0] == select((_e3660 << bitcast<u32>(29i)), 0u, ((_e3660 & 2147483647u) < 8388608u))) {
                        let _e3670 = params.member.member.member_12;
                        let _e3671 = bitcast<u32>(_e3670);
                        let _e3672 = (_e3671 & 2147483647u);
                        phi_6829_ = (_e3655.member_2[1] == select(((_e3671 ^ _e3672) | ((_e3672 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e3672 < 8388608u)));
                    } else {
                        phi_6829_ = false;
                    }
                    let _e3682 = phi_6829_;
                    let _e3684 = params.member.member.member_1;
                    if ((_e3684 & 128u) != 0u) {
                        phi_6845_ = true;
                    } else {
                        let _e3688 = params.member.member.member_1;
                        phi_6845_ = select(false, _e3682, ((_e3688 & 64u) != 0u));
                    }
                    let _e3693 = phi_6845_;
                    phi_6864_ = type_31(select(1u, _e3655.member, select(true, select(true, false, _e3693), _e3655.member_3)), _e3655.member_1, _e3655.member_2, _e3655.member_3);
                }
                let _e3704 = phi_6864_;
                phi_6865_ = _e3704;
                phi_6866_ = type_9(_e191, _e190);
            } else {
                phi_6865_ = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_6866_ = type_9(0u, 0u);
            }
            let _e3706 = phi_6865_;
            let _e3708 = phi_6866_;
            let _e3712 = (_e3706.member != 0u);
            let _e3715 = select(false, !(_e3712), _e3706.member_3);
            if _e3715 {
                let _e3719 = (_e3706.member_2[1] >> bitcast<u32>(20i));
                if (_e3719 <= 896u) {
                    phi_6896_ = 0u;
                } else {
                    phi_6896_ = ((((_e3719 - 896u) << bitcast<u32>(23i)) | ((_e3706.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e3706.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e3734 = phi_6896_;
                let _e3736 = atomicMin((&earliest.member[0u]), _e3734);
            }
            let _e3739 = params.member.member.member_1;
            if ((_e3739 & 16u) != 0u) {
                if (_e104 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e3715 {
                    let _e3745 = atomicAdd((&counters[0u]), 1u);
                    phi_6918_ = _e3745;
                } else {
                    phi_6918_ = 0u;
                }
                let _e3747 = phi_6918_;
                workgroupBarrier();
                if (_e104 == 0u) {
                    let _e3750 = atomicLoad((&counters[0u]));
                    if (_e3750 > 0u) {
                        let _e3753 = atomicAdd((&contacts.member[0u]), _e3750);
                        atomicStore((&counters[1u]), _e3753);
                    }
                }
                workgroupBarrier();
                let _e3756 = atomicLoad((&counters[1u]));
                let _e3757 = (_e3756 + _e3747);
                if _e3715 {
                    let _e3760 = params.member.member_1.member_3;
                    if (_e3757 < _e3760) {
                        let _e3766 = (7u * _e3757);
                        atomicStore((&contacts.member[(4u + _e3766)]), select(1u, 0u, ((_e3708.member_1 & 2147483648u) == 0u)));
                        atomicStore((&contacts.member[(_e3766 + 5u)]), _e3706.member);
                        atomicStore((&contacts.member[(_e3766 + 6u)]), _e3708.member);
                        atomicStore((&contacts.member[(_e3766 + 7u)]), (_e3708.member_1 & 2147483647u));
                        atomicStore((&contacts.member[(_e3766 + 8u)]), _e3706.member_2[0]);
                        atomicStore((&contacts.member[(_e3766 + 9u)]), _e3706.member_2[1]);
                        atomicStore((&contacts.member[(_e3766 + 10u)]), _e3706.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e104 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e3712 {
                let _e3790 = atomicAdd((&counters[0u]), 1u);
                phi_6995_ = _e3790;
            } else {
                phi_6995_ = 0u;
            }
            let _e3792 = phi_6995_;
            workgroupBarrier();
            if (_e104 == 0u) {
                let _e3795 = atomicLoad((&counters[0u]));
                if (_e3795 > 0u) {
                    let _e3798 = atomicAdd((&undecided.member[0u]), _e3795);
                    atomicStore((&counters[1u]), _e3798);
                }
            }
            workgroupBarrier();
            let _e3801 = atomicLoad((&counters[1u]));
            let _e3802 = (_e3801 + _e3792);
            if _e3712 {
                let _e3804 = params.member.member_2.member;
                if (_e3802 < _e3804) {
                    let _e3806 = (2u * _e3802);
                    atomicStore((&undecided.member[(4u + _e3806)]), _e3708.member);
                    atomicStore((&undecided.member[(_e3806 + 5u)]), _e3708.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_831_ = type_9(select(_e158.member, (_e158.member + 1u), _e161), select(_e158.member_1, _e158.member_1, _e161));
            break if !(_e174);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
