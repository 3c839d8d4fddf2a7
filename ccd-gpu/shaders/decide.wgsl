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
    var phi_677_: array<array<f32, 3>, 4>;

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
        phi_677_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e155)), (param_2[1] - (param_3[1] * _e155)), (param_2[2] - (param_3[2] * _e155))), array<f32, 3>((param_2[0] - (param_4[0] * _e195)), (param_2[1] - (param_4[1] * _e195)), (param_2[2] - (param_4[2] * _e195))), array<f32, 3>((_e9 - (param_4[0] * _e232)), (_e12 - (param_4[1] * _e232)), (_e15 - (param_4[2] * _e232))), array<f32, 3>((_e245 - (param_3[0] * _e275)), (_e248 - (param_3[1] * _e275)), (_e251 - (param_3[2] * _e275))));
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
        phi_677_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e74)), (param_2[1] - (param_3[1] * _e74)), (param_2[2] - (param_3[2] * _e74))), array<f32, 3>((param_2[0] - (param_4[0] * _e114)), (param_2[1] - (param_4[1] * _e114)), (param_2[2] - (param_4[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_677_;
    let _e291 = function_(_e288[0], _e288[1]);
    let _e293 = function_(_e291, _e288[2]);
    let _e295 = function_(_e293, _e288[3]);
    return _e295;
}

fn function_2(param_6: array<f32, 3>, param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: u32) -> array<f32, 3> {
    var phi_305_: bool;
    var phi_338_: array<f32, 3>;
    var phi_339_: bool;
    var phi_340_: array<f32, 3>;
    var phi_341_: bool;
    var phi_346_: array<f32, 3>;

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
        phi_305_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_305_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_305_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_338_ = array<f32, 3>((param_6[0] - ((param_7[0] * _e74) + (param_8[0] * _e78))), (param_6[1] - ((param_7[1] * _e74) + (param_8[1] * _e78))), (param_6[2] - ((param_7[2] * _e74) + (param_8[2] * _e78))));
            phi_339_ = false;
        } else {
            phi_338_ = array<f32, 3>();
            phi_339_ = true;
        }
        let _e129 = phi_338_;
        let _e131 = phi_339_;
        phi_340_ = _e129;
        phi_341_ = _e131;
    } else {
        phi_340_ = array<f32, 3>();
        phi_341_ = true;
    }
    let _e133 = phi_340_;
    let _e135 = phi_341_;
    if _e135 {
        let _e136 = function_1(param_6, param_7, param_8, param_9);
        phi_346_ = _e136;
    } else {
        phi_346_ = _e133;
    }
    let _e138 = phi_346_;
    return _e138;
}

fn function_3(param_10: f32) -> array<u32, 2> {
    let _e7 = bitcast<u32>(param_10);
    let _e8 = (_e7 & 2147483647u);
    let _e9 = (_e8 < 8388608u);
    return array<u32, 2>(select((_e7 << bitcast<u32>(29i)), 0u, _e9), select(((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e9));
}

fn function_4(param_11: ptr<function, type_36>, param_12: f32, param_13: f32, param_14: f32) -> bool {
    var phi_7104_: bool;
    var phi_7105_: bool;
    var phi_7110_: bool;

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
            phi_7104_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_7105_ = select(true, false, _e84);
        } else {
            phi_7104_ = bool();
            phi_7105_ = true;
        }
        let _e91 = phi_7104_;
        let _e93 = phi_7105_;
        phi_7110_ = select(_e91, false, _e93);
    } else {
        phi_7110_ = false;
    }
    let _e96 = phi_7110_;
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
    var phi_787_: u32;
    var phi_832_: u32;
    var phi_835_: type_9;
    var phi_1009_: type_23;
    var phi_1144_: type_29;
    var phi_1412_: bool;
    var phi_1506_: type_32;
    var phi_1507_: bool;
    var phi_1508_: type_32;
    var phi_1509_: bool;
    var phi_1510_: type_32;
    var phi_1511_: bool;
    var phi_1516_: type_32;
    var phi_2241_: bool;
    var phi_2253_: f32;
    var phi_2324_: type_14;
    var phi_2327_: f32;
    var phi_2325_: type_14;
    var phi_2368_: type_15;
    var phi_2328_: f32;
    var local_9: f32;
    var phi_2381_: f32;
    var phi_2412_: type_9;
    var phi_2415_: u32;
    var phi_2482_: u32;
    var phi_2483_: u32;
    var phi_2416_: u32;
    var phi_2484_: u32;
    var phi_2540_: type_9;
    var phi_2696_: type_38;
    var phi_2697_: bool;
    var phi_2698_: type_38;
    var phi_2699_: bool;
    var phi_2730_: type_9;
    var phi_2733_: f32;
    var phi_2735_: f32;
    var phi_2737_: f32;
    var phi_2847_: bool;
    var phi_2854_: f32;
    var phi_2855_: bool;
    var phi_2734_: f32;
    var phi_2736_: f32;
    var phi_2738_: f32;
    var phi_2856_: f32;
    var phi_2857_: bool;
    var phi_2858_: bool;
    var local_10: bool;
    var local_11: f32;
    var local_12: f32;
    var phi_2863_: f32;
    var phi_2879_: type_9;
    var phi_2882_: f32;
    var phi_2947_: f32;
    var phi_2948_: bool;
    var phi_2949_: bool;
    var phi_2950_: bool;
    var phi_2951_: f32;
    var phi_2883_: f32;
    var phi_2952_: bool;
    var phi_2953_: bool;
    var phi_2954_: bool;
    var phi_2955_: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: f32;
    var phi_2969_: f32;
    var phi_2971_: type_38;
    var phi_3808_: array<type_16, 4>;
    var phi_3828_: type_9;
    var phi_3831_: bool;
    var phi_3832_: bool;
    var phi_3883_: bool;
    var phi_3884_: bool;
    var local_18: bool;
    var local_19: bool;
    var phi_3898_: u32;
    var phi_3899_: u32;
    var phi_3900_: bool;
    var phi_3931_: bool;
    var phi_3932_: bool;
    var phi_3933_: bool;
    var phi_3934_: bool;
    var phi_3935_: bool;
    var phi_3936_: bool;
    var phi_3937_: bool;
    var phi_3938_: bool;
    var phi_3939_: bool;
    var phi_3940_: bool;
    var phi_3941_: bool;
    var phi_3942_: bool;
    var phi_3943_: type_38;
    var phi_3944_: bool;
    var phi_3945_: type_38;
    var phi_3946_: bool;
    var phi_3947_: bool;
    var phi_3948_: bool;
    var phi_3949_: bool;
    var phi_3950_: type_38;
    var phi_3951_: bool;
    var phi_3952_: type_38;
    var phi_3953_: bool;
    var phi_3954_: bool;
    var phi_3955_: bool;
    var phi_3956_: bool;
    var phi_3957_: bool;
    var phi_3965_: type_38;
    var phi_3966_: bool;
    var phi_3967_: type_38;
    var phi_3968_: bool;
    var phi_3969_: bool;
    var phi_3970_: bool;
    var phi_3971_: bool;
    var phi_3972_: bool;
    var phi_4395_: type_9;
    var phi_4398_: f32;
    var phi_4400_: f32;
    var phi_4402_: f32;
    var phi_4404_: f32;
    var phi_4406_: bool;
    var phi_4408_: u32;
    var phi_4559_: array<f32, 3>;
    var phi_4625_: type_14;
    var phi_4628_: f32;
    var phi_4626_: type_14;
    var phi_4669_: type_15;
    var phi_4629_: f32;
    var local_20: f32;
    var phi_4682_: f32;
    var phi_4805_: type_30;
    var phi_4806_: bool;
    var phi_4807_: type_30;
    var phi_4808_: bool;
    var phi_4816_: type_30;
    var phi_4987_: bool;
    var phi_4988_: bool;
    var phi_4989_: bool;
    var phi_4990_: bool;
    var phi_4991_: bool;
    var phi_4992_: bool;
    var phi_5293_: bool;
    var phi_5294_: bool;
    var phi_5295_: bool;
    var phi_5296_: bool;
    var phi_5297_: bool;
    var phi_5298_: bool;
    var phi_5306_: bool;
    var phi_5413_: f32;
    var phi_5414_: bool;
    var phi_5415_: f32;
    var phi_5416_: bool;
    var phi_5417_: f32;
    var phi_5418_: bool;
    var phi_5419_: bool;
    var phi_5481_: f32;
    var phi_5482_: bool;
    var phi_5483_: f32;
    var phi_5484_: bool;
    var phi_5485_: f32;
    var phi_5486_: bool;
    var phi_5487_: bool;
    var phi_5554_: f32;
    var phi_5555_: bool;
    var phi_5556_: f32;
    var phi_5557_: bool;
    var phi_5558_: f32;
    var phi_5559_: bool;
    var phi_5560_: bool;
    var phi_5622_: f32;
    var phi_5623_: bool;
    var phi_5624_: f32;
    var phi_5625_: bool;
    var phi_5626_: f32;
    var phi_5627_: bool;
    var phi_5628_: bool;
    var phi_6157_: f32;
    var phi_6158_: f32;
    var phi_6159_: bool;
    var phi_6161_: f32;
    var phi_6162_: f32;
    var phi_6163_: f32;
    var phi_6165_: bool;
    var phi_6166_: bool;
    var phi_6168_: bool;
    var phi_6169_: f32;
    var phi_6170_: f32;
    var phi_6171_: f32;
    var phi_6173_: bool;
    var phi_6174_: bool;
    var phi_6175_: bool;
    var phi_6177_: bool;
    var phi_6178_: f32;
    var phi_6179_: f32;
    var phi_6180_: f32;
    var phi_6182_: bool;
    var phi_6183_: bool;
    var phi_6184_: bool;
    var phi_6186_: bool;
    var phi_6519_: f32;
    var phi_6521_: u32;
    var phi_6522_: f32;
    var phi_6523_: bool;
    var phi_6524_: bool;
    var phi_6525_: bool;
    var phi_6526_: u32;
    var phi_6527_: f32;
    var phi_6528_: f32;
    var phi_6529_: f32;
    var phi_6530_: f32;
    var phi_6531_: bool;
    var phi_6532_: u32;
    var phi_6533_: bool;
    var phi_6534_: bool;
    var phi_6535_: bool;
    var phi_6536_: bool;
    var phi_6538_: bool;
    var phi_6566_: f32;
    var phi_6567_: f32;
    var phi_6568_: f32;
    var phi_6569_: f32;
    var phi_6570_: bool;
    var phi_6571_: u32;
    var phi_6572_: bool;
    var phi_6573_: bool;
    var phi_6574_: bool;
    var phi_6575_: bool;
    var phi_6577_: bool;
    var phi_4399_: f32;
    var phi_4401_: f32;
    var phi_4403_: f32;
    var phi_4405_: f32;
    var phi_4407_: bool;
    var phi_4409_: u32;
    var phi_6578_: f32;
    var phi_6580_: bool;
    var phi_6581_: bool;
    var phi_6582_: bool;
    var phi_6583_: bool;
    var phi_6585_: bool;
    var phi_6586_: bool;
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
    var phi_6654_: f32;
    var phi_6655_: bool;
    var phi_6656_: bool;
    var phi_6657_: bool;
    var phi_6658_: bool;
    var phi_6659_: bool;
    var phi_6660_: type_38;
    var phi_6661_: bool;
    var phi_6662_: f32;
    var phi_6663_: type_38;
    var phi_6664_: bool;
    var phi_6665_: bool;
    var phi_6666_: bool;
    var phi_6667_: bool;
    var phi_6668_: bool;
    var phi_6669_: bool;
    var local_33: bool;
    var local_34: bool;
    var local_35: type_38;
    var local_36: f32;
    var local_37: f32;
    var phi_6685_: type_33;
    var phi_6686_: bool;
    var local_38: f32;
    var phi_6692_: type_33;
    var phi_6693_: bool;
    var phi_6694_: bool;
    var phi_6695_: bool;
    var phi_6696_: bool;
    var local_39: bool;
    var local_40: type_38;
    var phi_6738_: type_33;
    var phi_6739_: type_33;
    var phi_6740_: bool;
    var phi_6784_: type_31;
    var phi_6824_: bool;
    var phi_6840_: bool;
    var phi_6867_: type_9;
    var phi_6896_: bool;
    var phi_6897_: bool;
    var phi_6940_: u32;
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
        phi_787_ = (_e124 - _e129);
    } else {
        phi_787_ = 0u;
    }
    let _e132 = phi_787_;
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
        phi_832_ = select(_e145, (_e145 + 1u), ((_e143 % _e117) > 0u));
    } else {
        phi_832_ = 0u;
    }
    let _e152 = phi_832_;
    phi_835_ = type_9(0u, _e152);
    loop {
        let _e155 = phi_835_;
        let _e158 = (_e155.member < _e155.member_1);
        let _e171 = (bitcast<i32>(select(0u, 1u, _e158)) != 0i);
        if _e171 {
            let _e175 = (((_e114 + (select(type_9().member_1, _e155.member, _e158) * _e117)) * 64u) + _e103);
            local_8 = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
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
                    phi_1009_ = type_23(0u, array<u32, 4>(_e184, _e216, _e219, _e222));
                } else {
                    let _e195 = (2u * _e184);
                    let _e197 = elements.member[_e195];
                    let _e200 = elements.member[(_e195 + 1u)];
                    let _e201 = (2u * _e192);
                    let _e203 = elements.member[_e201];
                    let _e206 = elements.member[(_e201 + 1u)];
                    phi_1009_ = type_23(1u, array<u32, 4>(_e197, _e200, _e203, _e206));
                }
                let _e226 = phi_1009_;
                let _e231 = paths.member[_e226.member_1[0]];
                let _e246 = paths.member[_e226.member_1[1]];
                let _e261 = paths.member[_e226.member_1[2]];
                let _e276 = paths.member[_e226.member_1[3]];
                let _e290 = params.member.member.member_4;
                if (_e226.member != 0u) {
                    phi_1144_ = type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e261.member.x - _e231.member.x), (_e261.member.y - _e231.member.y), (_e261.member.z - _e231.member.z)), array<f32, 3>((_e261.member_1.x - _e231.member_1.x), (_e261.member_1.y - _e231.member_1.y), (_e261.member_1.z - _e231.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e246.member.x - _e231.member.x), (_e246.member.y - _e231.member.y), (_e246.member.z - _e231.member.z)), array<f32, 3>((_e246.member_1.x - _e231.member_1.x), (_e246.member_1.y - _e231.member_1.y), (_e246.member_1.z - _e231.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e261.member.x - _e276.member.x), (_e261.member.y - _e276.member.y), (_e261.member.z - _e276.member.z)), array<f32, 3>((_e261.member_1.x - _e276.member_1.x), (_e261.member_1.y - _e276.member_1.y), (_e261.member_1.z - _e276.member_1.z))), (_e290 + _e290));
                } else {
                    phi_1144_ = type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e231.member.x - _e246.member.x), (_e231.member.y - _e246.member.y), (_e231.member.z - _e246.member.z)), array<f32, 3>((_e231.member_1.x - _e246.member_1.x), (_e231.member_1.y - _e246.member_1.y), (_e231.member_1.z - _e246.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e261.member.x - _e246.member.x), (_e261.member.y - _e246.member.y), (_e261.member.z - _e246.member.z)), array<f32, 3>((_e261.member_1.x - _e246.member_1.x), (_e261.member_1.y - _e246.member_1.y), (_e261.member_1.z - _e246.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e276.member.x - _e246.member.x), (_e276.member.y - _e246.member.y), (_e276.member.z - _e246.member.z)), array<f32, 3>((_e276.member_1.x - _e246.member_1.x), (_e276.member_1.y - _e246.member_1.y), (_e276.member_1.z - _e246.member_1.z))), (_e290 + _e290));
                }
                let _e351 = phi_1144_;
                let _e353 = params.member.member.member_11;
                let _e355 = params.member.member.member_12;
                let _e357 = params.member.member.member_13;
                let _e359 = params.member.member.member_13;
                let _e365 = select(_e351.member[0][0], -(_e351.member[0][0]), (_e351.member[0][0] < 0f));
                let _e369 = select(_e351.member[0][1], -(_e351.member[0][1]), (_e351.member[0][1] < 0f));
                let _e371 = select(_e369, _e365, (_e365 > _e369));
                let _e375 = select(_e351.member[0][2], -(_e351.member[0][2]), (_e351.member[0][2] < 0f));
                let _e377 = select(_e375, _e371, (_e371 > _e375));
                let _e383 = select(_e351.member[1][0], -(_e351.member[1][0]), (_e351.member[1][0] < 0f));
                let _e387 = select(_e351.member[1][1], -(_e351.member[1][1]), (_e351.member[1][1] < 0f));
                let _e389 = select(_e387, _e383, (_e383 > _e387));
                let _e393 = select(_e351.member[1][2], -(_e351.member[1][2]), (_e351.member[1][2] < 0f));
                let _e395 = select(_e393, _e389, (_e389 > _e393));
                let _e399 = (select(_e395, _e377, (_e377 > _e395)) + _e351.member_3);
                let _e405 = select(_e351.member_1[0][0], -(_e351.member_1[0][0]), (_e351.member_1[0][0] < 0f));
                let _e409 = select(_e351.member_1[0][1], -(_e351.member_1[0][1]), (_e351.member_1[0][1] < 0f));
                let _e411 = select(_e409, _e405, (_e405 > _e409));
                let _e415 = select(_e351.member_1[0][2], -(_e351.member_1[0][2]), (_e351.member_1[0][2] < 0f));
                let _e417 = select(_e415, _e411, (_e411 > _e415));
                let _e423 = select(_e351.member_1[1][0], -(_e351.member_1[1][0]), (_e351.member_1[1][0] < 0f));
                let _e427 = select(_e351.member_1[1][1], -(_e351.member_1[1][1]), (_e351.member_1[1][1] < 0f));
                let _e429 = select(_e427, _e423, (_e423 > _e427));
                let _e433 = select(_e351.member_1[1][2], -(_e351.member_1[1][2]), (_e351.member_1[1][2] < 0f));
                let _e435 = select(_e433, _e429, (_e429 > _e433));
                let _e439 = (select(_e435, _e417, (_e417 > _e435)) + _e351.member_3);
                let _e445 = select(_e351.member_2[0][0], -(_e351.member_2[0][0]), (_e351.member_2[0][0] < 0f));
                let _e449 = select(_e351.member_2[0][1], -(_e351.member_2[0][1]), (_e351.member_2[0][1] < 0f));
                let _e451 = select(_e449, _e445, (_e445 > _e449));
                let _e455 = select(_e351.member_2[0][2], -(_e351.member_2[0][2]), (_e351.member_2[0][2] < 0f));
                let _e457 = select(_e455, _e451, (_e451 > _e455));
                let _e463 = select(_e351.member_2[1][0], -(_e351.member_2[1][0]), (_e351.member_2[1][0] < 0f));
                let _e467 = select(_e351.member_2[1][1], -(_e351.member_2[1][1]), (_e351.member_2[1][1] < 0f));
                let _e469 = select(_e467, _e463, (_e463 > _e467));
                let _e473 = select(_e351.member_2[1][2], -(_e351.member_2[1][2]), (_e351.member_2[1][2] < 0f));
                let _e475 = select(_e473, _e469, (_e469 > _e473));
                let _e479 = (select(_e475, _e457, (_e457 > _e475)) + _e351.member_3);
                let _e481 = select(_e439, _e399, (_e399 > _e439));
                let _e483 = select(_e479, _e481, (_e481 > _e479));
                if (_e483 <= 65536f) {
                    phi_1412_ = (_e483 >= (1f / 65536f));
                } else {
                    phi_1412_ = false;
                }
                let _e488 = phi_1412_;
                if _e488 {
                    phi_1510_ = type_32();
                    phi_1511_ = true;
                } else {
                    if (_e483 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e483) & 2139095040u) != 2139095040u) {
                            let _e495 = (2130706432u - (bitcast<u32>(_e483) & 2139095040u));
                            let _e498 = bitcast<f32>(select(8388608u, _e495, (_e495 > 8388608u)));
                            phi_1506_ = type_32(type_29(array<array<f32, 3>, 2>(array<f32, 3>((_e351.member[0][0] * _e498), (_e351.member[0][1] * _e498), (_e351.member[0][2] * _e498)), array<f32, 3>((_e351.member[1][0] * _e498), (_e351.member[1][1] * _e498), (_e351.member[1][2] * _e498))), array<array<f32, 3>, 2>(array<f32, 3>((_e351.member_1[0][0] * _e498), (_e351.member_1[0][1] * _e498), (_e351.member_1[0][2] * _e498)), array<f32, 3>((_e351.member_1[1][0] * _e498), (_e351.member_1[1][1] * _e498), (_e351.member_1[1][2] * _e498))), array<array<f32, 3>, 2>(array<f32, 3>((_e351.member_2[0][0] * _e498), (_e351.member_2[0][1] * _e498), (_e351.member_2[0][2] * _e498)), array<f32, 3>((_e351.member_2[1][0] * _e498), (_e351.member_2[1][1] * _e498), (_e351.member_2[1][2] * _e498))), ((_e351.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e498)), (0f * _e498));
                            phi_1507_ = false;
                        } else {
                            phi_1506_ = type_32();
                            phi_1507_ = true;
                        }
                        let _e564 = phi_1506_;
                        let _e566 = phi_1507_;
                        phi_1508_ = _e564;
                        phi_1509_ = _e566;
                    } else {
                        phi_1508_ = type_32();
                        phi_1509_ = true;
                    }
                    let _e568 = phi_1508_;
                    let _e570 = phi_1509_;
                    phi_1510_ = _e568;
                    phi_1511_ = _e570;
                }
                let _e572 = phi_1510_;
                let _e574 = phi_1511_;
                if _e574 {
                    phi_1516_ = type_32(_e351, 0f);
                } else {
                    phi_1516_ = _e572;
                }
                let _e577 = phi_1516_;
                local_7 = type_29(array<array<f32, 3>, 2>(array<f32, 3>(_e577.member.member[0][0], _e577.member.member[0][1], _e577.member.member[0][2]), array<f32, 3>(_e577.member.member[1][0], _e577.member.member[1][1], _e577.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e577.member.member_1[0][0], _e577.member.member_1[0][1], _e577.member.member_1[0][2]), array<f32, 3>(_e577.member.member_1[1][0], _e577.member.member_1[1][1], _e577.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e577.member.member_2[0][0], _e577.member.member_2[0][1], _e577.member.member_2[0][2]), array<f32, 3>(_e577.member.member_2[1][0], _e577.member.member_2[1][1], _e577.member.member_2[1][2])), _e577.member.member_3);
                let _e619 = local_7.member_1[0u];
                let _e625 = local_7.member_2[0u];
                let _e631 = ((_e619[1] * _e625[2]) - (_e619[2] * _e625[1]));
                let _e634 = ((_e619[2] * _e625[0]) - (_e619[0] * _e625[2]));
                let _e637 = ((_e619[0] * _e625[1]) - (_e619[1] * _e625[0]));
                let _e640 = local_7.member_1[1u];
                let _e646 = local_7.member_2[1u];
                let _e652 = ((_e640[1] * _e646[2]) - (_e640[2] * _e646[1]));
                let _e655 = ((_e640[2] * _e646[0]) - (_e640[0] * _e646[2]));
                let _e658 = ((_e640[0] * _e646[1]) - (_e640[1] * _e646[0]));
                let _e661 = local_7.member_1[0u];
                let _e667 = local_7.member_2[1u];
                let _e682 = local_7.member_1[1u];
                let _e688 = local_7.member_2[0u];
                let _e701 = (((_e661[1] * _e667[2]) - (_e661[2] * _e667[1])) + ((_e682[1] * _e688[2]) - (_e682[2] * _e688[1])));
                let _e702 = (((_e661[2] * _e667[0]) - (_e661[0] * _e667[2])) + ((_e682[2] * _e688[0]) - (_e682[0] * _e688[2])));
                let _e703 = (((_e661[0] * _e667[1]) - (_e661[1] * _e667[0])) + ((_e682[0] * _e688[1]) - (_e682[1] * _e688[0])));
                let _e706 = local_7.member[0u];
                let _e714 = (((_e706[0] * _e631) + (_e706[1] * _e634)) + (_e706[2] * _e637));
                let _e717 = local_7.member[1u];
                let _e728 = local_7.member[0u];
                let _e737 = ((((_e717[0] * _e631) + (_e717[1] * _e634)) + (_e717[2] * _e637)) + (((_e728[0] * _e701) + (_e728[1] * _e702)) + (_e728[2] * _e703)));
                let _e740 = local_7.member[0u];
                let _e751 = local_7.member[1u];
                let _e760 = ((((_e740[0] * _e652) + (_e740[1] * _e655)) + (_e740[2] * _e658)) + (((_e751[0] * _e701) + (_e751[1] * _e702)) + (_e751[2] * _e703)));
                let _e763 = local_7.member[1u];
                let _e771 = (((_e763[0] * _e652) + (_e763[1] * _e655)) + (_e763[2] * _e658));
                let _e774 = local_7.member[0u];
                let _e780 = select(_e774[0], -(_e774[0]), (_e774[0] < 0f));
                let _e783 = select(_e774[1], -(_e774[1]), (_e774[1] < 0f));
                let _e785 = select(_e783, _e780, (_e780 > _e783));
                let _e788 = select(_e774[2], -(_e774[2]), (_e774[2] < 0f));
                let _e790 = select(_e788, _e785, (_e785 > _e788));
                let _e793 = local_7.member[1u];
                let _e799 = select(_e793[0], -(_e793[0]), (_e793[0] < 0f));
                let _e802 = select(_e793[1], -(_e793[1]), (_e793[1] < 0f));
                let _e804 = select(_e802, _e799, (_e799 > _e802));
                let _e807 = select(_e793[2], -(_e793[2]), (_e793[2] < 0f));
                let _e809 = select(_e807, _e804, (_e804 > _e807));
                let _e813 = local_7.member_3;
                let _e814 = (select(_e809, _e790, (_e790 > _e809)) + _e813);
                let _e817 = local_7.member_1[0u];
                let _e823 = select(_e817[0], -(_e817[0]), (_e817[0] < 0f));
                let _e826 = select(_e817[1], -(_e817[1]), (_e817[1] < 0f));
                let _e828 = select(_e826, _e823, (_e823 > _e826));
                let _e831 = select(_e817[2], -(_e817[2]), (_e817[2] < 0f));
                let _e833 = select(_e831, _e828, (_e828 > _e831));
                let _e836 = local_7.member_1[1u];
                let _e842 = select(_e836[0], -(_e836[0]), (_e836[0] < 0f));
                let _e845 = select(_e836[1], -(_e836[1]), (_e836[1] < 0f));
                let _e847 = select(_e845, _e842, (_e842 > _e845));
                let _e850 = select(_e836[2], -(_e836[2]), (_e836[2] < 0f));
                let _e852 = select(_e850, _e847, (_e847 > _e850));
                let _e856 = local_7.member_3;
                let _e857 = (select(_e852, _e833, (_e833 > _e852)) + _e856);
                let _e860 = local_7.member_2[0u];
                let _e866 = select(_e860[0], -(_e860[0]), (_e860[0] < 0f));
                let _e869 = select(_e860[1], -(_e860[1]), (_e860[1] < 0f));
                let _e871 = select(_e869, _e866, (_e866 > _e869));
                let _e874 = select(_e860[2], -(_e860[2]), (_e860[2] < 0f));
                let _e876 = select(_e874, _e871, (_e871 > _e874));
                let _e879 = local_7.member_2[1u];
                let _e885 = select(_e879[0], -(_e879[0]), (_e879[0] < 0f));
                let _e888 = select(_e879[1], -(_e879[1]), (_e879[1] < 0f));
                let _e890 = select(_e888, _e885, (_e885 > _e888));
                let _e893 = select(_e879[2], -(_e879[2]), (_e879[2] < 0f));
                let _e895 = select(_e893, _e890, (_e890 > _e893));
                let _e899 = local_7.member_3;
                let _e900 = (select(_e895, _e876, (_e876 > _e895)) + _e899);
                let _e902 = ((_e857 * 8f) * _e900);
                let _e909 = local_7.member_3;
                let _e933 = ((select(_e631, -(_e631), (_e631 < 0f)) + select(_e634, -(_e634), (_e634 < 0f))) + select(_e637, -(_e637), (_e637 < 0f)));
                let _e944 = ((select(_e652, -(_e652), (_e652 < 0f)) + select(_e655, -(_e655), (_e655 < 0f))) + select(_e658, -(_e658), (_e658 < 0f)));
                let _e946 = select(_e944, _e933, (_e933 > _e944));
                let _e958 = (((select(_e701, -(_e701), (_e701 < 0f)) + select(_e702, -(_e702), (_e702 < 0f))) + select(_e703, -(_e703), (_e703 < 0f))) * 0.5f);
                let _e965 = local_7.member_3;
                let _e977 = (((((_e814 * 8f) * _e902) * (0.000000059604645f * (524f / 64f))) + ((_e909 * 19f) * ((_e814 * (_e857 + _e900)) + (_e857 * _e900)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e814) * ((1f + _e857) * (1f + _e900)))));
                let _e978 = (_e714 * 3f);
                let _e979 = (_e771 * 3f);
                let _e981 = select(_e979, _e978, (_e978 < _e979));
                let _e983 = select(_e760, _e737, (_e737 < _e760));
                let _e985 = select(_e983, _e981, (_e981 < _e983));
                let _e987 = select(_e979, _e978, (_e978 > _e979));
                let _e989 = select(_e760, _e737, (_e737 > _e760));
                let _e992 = -(select(_e989, _e987, (_e987 > _e989)));
                if ((select(_e992, _e985, (_e985 > _e992)) - (_e977 + ((0f * (((select(_e958, _e946, (_e946 > _e958)) + (_e902 * (0.000000059604645f * 8f))) + ((_e965 * 6f) * (_e857 + _e900))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e857) * (1f + _e900))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6738_ = type_33(0u, type_33().member_1);
                    phi_6739_ = type_33();
                    phi_6740_ = true;
                } else {
                    let _e1004 = select(_e714, -(_e714), (_e714 < 0f));
                    let _e1007 = select(_e737, -(_e737), (_e737 < 0f));
                    let _e1009 = select(_e1007, _e1004, (_e1004 > _e1007));
                    let _e1012 = select(_e760, -(_e760), (_e760 < 0f));
                    let _e1015 = select(_e771, -(_e771), (_e771 < 0f));
                    let _e1017 = select(_e1015, _e1012, (_e1012 > _e1015));
                    let _e1019 = select(_e1017, _e1009, (_e1009 > _e1017));
                    let _e1020 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                    if (_e1019 >= _e1020) {
                        phi_2241_ = (_e1019 <= (1f / _e1020));
                    } else {
                        phi_2241_ = false;
                    }
                    let _e1025 = phi_2241_;
                    if _e1025 {
                        phi_2253_ = (1f / _e1019);
                    } else {
                        phi_2253_ = 0f;
                    }
                    let _e1032 = phi_2253_;
                    let _e1033 = (_e353 * 0.0625f);
                    local_5 = type_36(array<f32, 4>(_e714, _e737, _e760, _e771), ((_e977 * 0.34f) + (_e1019 * select(2f, (0.000000059604645f * 256f), _e1025))), _e1032, select(_e1033, 0.00000000000022737368f, (0.00000000000022737368f < _e1033)));
                    let _e1040 = local_5.member[0u];
                    let _e1043 = local_5.member[1u];
                    let _e1046 = local_5.member[2u];
                    let _e1049 = local_5.member[3u];
                    let _e1056 = local_5.member_2;
                    let _e1057 = ((_e1043 - (3f * _e1040)) * _e1056);
                    let _e1059 = local_5.member_2;
                    let _e1060 = ((_e1046 - _e1043) * _e1059);
                    let _e1062 = local_5.member_2;
                    let _e1063 = (((3f * _e1049) - _e1046) * _e1062);
                    local_3[0u] = 0f;
                    local_3[1u] = 1f;
                    local_3[2u] = 1f;
                    local_3[3u] = 1f;
                    let _e1070 = ((_e1060 * _e1060) - (_e1057 * _e1063));
                    if (_e1070 > 0f) {
                        if (_e1070 <= 0.000000000000000000000000000000000000011754944f) {
                            phi_2381_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1070 > 0f));
                        } else {
                            phi_2324_ = type_14(0i, 5i);
                            phi_2327_ = bitcast<f32>(((bitcast<u32>(_e1070) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1079 = phi_2324_;
                                let _e1081 = phi_2327_;
                                local_9 = _e1081;
                                if (_e1079.member < _e1079.member_1) {
                                    let _e1088 = (_e1079.member + 1i);
                                    phi_2325_ = type_14(select(_e1088, type_15().member_1, select(false, true, ((false == (_e1088 > _e1079.member)) != false))), _e1079.member_1);
                                    phi_2368_ = type_15(1u, _e1079.member);
                                } else {
                                    phi_2325_ = _e1079;
                                    phi_2368_ = type_15(0u, type_15().member_1);
                                }
                                let _e1099 = phi_2325_;
                                let _e1101 = phi_2368_;
                                let _e1104 = (bitcast<i32>(_e1101.member) != 0i);
                                if _e1104 {
                                    phi_2328_ = (0.5f * (_e1081 + (_e1070 / _e1081)));
                                } else {
                                    phi_2328_ = f32();
                                }
                                let _e1109 = phi_2328_;
                                continue;
                                continuing {
                                    phi_2324_ = _e1099;
                                    phi_2327_ = _e1109;
                                    break if !(_e1104);
                                }
                            }
                            let _e1114 = local_9;
                            phi_2381_ = (_e1114 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1120 = phi_2381_;
                        let _e1125 = -((_e1060 + select(_e1120, -(_e1120), (_e1060 < 0f))));
                        local_4[0u] = (_e1125 / (_e1125 + _e1063));
                        local_4[1u] = (_e1057 / (_e1057 + _e1125));
                        let _e1134 = local_4[1u];
                        let _e1135 = local_4[0u];
                        if (_e1134 < _e1135) {
                            let _e1138 = local_4[1u];
                            let _e1140 = local_4[0u];
                            local_4[0u] = _e1138;
                            local_4[1u] = _e1140;
                        }
                        phi_2412_ = type_9(0u, 2u);
                        phi_2415_ = 1u;
                        loop {
                            let _e1144 = phi_2412_;
                            let _e1146 = phi_2415_;
                            local_41 = _e1146;
                            let _e1149 = (_e1144.member < _e1144.member_1);
                            let _e1160 = select(type_9().member_1, _e1144.member, _e1149);
                            let _e1162 = (bitcast<i32>(select(0u, 1u, _e1149)) != 0i);
                            if _e1162 {
                                let _e1164 = local_4[_e1160];
                                if (_e1164 > 0f) {
                                    let _e1167 = local_4[_e1160];
                                    if (_e1167 < 1f) {
                                        let _e1170 = local_4[_e1160];
                                        local_3[_e1146] = _e1170;
                                        phi_2482_ = (_e1146 + 1u);
                                    } else {
                                        phi_2482_ = _e1146;
                                    }
                                    let _e1174 = phi_2482_;
                                    phi_2483_ = _e1174;
                                } else {
                                    phi_2483_ = _e1146;
                                }
                                let _e1176 = phi_2483_;
                                phi_2416_ = _e1176;
                            } else {
                                phi_2416_ = u32();
                            }
                            let _e1178 = phi_2416_;
                            continue;
                            continuing {
                                phi_2412_ = type_9(select(_e1144.member, (_e1144.member + 1u), _e1149), select(_e1144.member_1, _e1144.member_1, _e1149));
                                phi_2415_ = _e1178;
                                break if !(_e1162);
                            }
                        }
                        let _e3820 = local_41;
                        phi_2484_ = _e3820;
                    } else {
                        phi_2484_ = 1u;
                    }
                    let _e1181 = phi_2484_;
                    local_3[_e1181] = 1f;
                    let _e1183 = local_3;
                    local_6 = _e1183;
                    let _e1184 = (_e353 * 0.99f);
                    let _e1185 = (1f - _e355);
                    let _e1188 = local_5.member[0u];
                    let _e1191 = local_5.member[1u];
                    let _e1194 = local_5.member[2u];
                    let _e1197 = local_5.member[3u];
                    let _e1208 = ((((_e1188 * _e1185) + (_e1191 * _e355)) * (_e1185 * _e1185)) + (((_e1194 * _e1185) + (_e1197 * _e355)) * (_e355 * _e355)));
                    let _e1213 = local_5.member_1;
                    phi_2540_ = type_9(select(1u, 0u, !((select(_e1208, -(_e1208), (_e1208 < 0f)) > _e1213))), (_e1181 + 1u));
                    loop {
                        let _e1220 = phi_2540_;
                        let _e1223 = (_e1220.member < _e1220.member_1);
                        let _e1234 = select(type_9().member_1, _e1220.member, _e1223);
                        if (bitcast<i32>(select(0u, 1u, _e1223)) != 0i) {
                            if (_e1234 > 0u) {
                                let _e1241 = local_6[(_e1234 - 1u)];
                                let _e1243 = select(_e355, _e1241, (_e1241 > _e355));
                                let _e1245 = local_6[_e1234];
                                let _e1247 = select(_e357, _e1245, (_e1245 < _e357));
                                if (_e1243 <= _e1247) {
                                    let _e1249 = function_4((&local_5), _e359, _e1243, _e1247);
                                    if _e1249 {
                                        phi_3943_ = type_38();
                                        phi_3944_ = bool();
                                        phi_3945_ = type_38();
                                        phi_3946_ = false;
                                        phi_3947_ = false;
                                        phi_3948_ = false;
                                        phi_3949_ = false;
                                    } else {
                                        let _e1250 = (1f - _e1243);
                                        let _e1253 = local_5.member[0u];
                                        let _e1256 = local_5.member[1u];
                                        let _e1259 = local_5.member[2u];
                                        let _e1262 = local_5.member[3u];
                                        let _e1273 = ((((_e1253 * _e1250) + (_e1256 * _e1243)) * (_e1250 * _e1250)) + (((_e1259 * _e1250) + (_e1262 * _e1243)) * (_e1243 * _e1243)));
                                        let _e1274 = (1f - _e1247);
                                        let _e1277 = local_5.member[0u];
                                        let _e1280 = local_5.member[1u];
                                        let _e1283 = local_5.member[2u];
                                        let _e1286 = local_5.member[3u];
                                        let _e1297 = ((((_e1277 * _e1274) + (_e1280 * _e1247)) * (_e1274 * _e1274)) + (((_e1283 * _e1274) + (_e1286 * _e1247)) * (_e1247 * _e1247)));
                                        let _e1302 = local_5.member_1;
                                        let _e1303 = (select(_e1273, -(_e1273), (_e1273 < 0f)) > _e1302);
                                        let _e1308 = local_5.member_1;
                                        let _e1309 = (select(_e1297, -(_e1297), (_e1297 < 0f)) > _e1308);
                                        let _e1317 = select(select(bool(), select(bool(), ((_e1273 > 0f) != (_e1297 > 0f)), _e1309), _e1303), false, select(true, select(true, false, _e1309), _e1303));
                                        if _e1303 {
                                            if _e1309 {
                                                phi_2696_ = type_38(select(1f, type_38().member, _e1317), select(0f, type_38().member_1, _e1317), select(_e1317, type_38().member_2, _e1317));
                                                phi_2697_ = _e1317;
                                            } else {
                                                phi_2696_ = type_38();
                                                phi_2697_ = true;
                                            }
                                            let _e1326 = phi_2696_;
                                            let _e1328 = phi_2697_;
                                            phi_2698_ = _e1326;
                                            phi_2699_ = _e1328;
                                        } else {
                                            phi_2698_ = type_38();
                                            phi_2699_ = true;
                                        }
                                        let _e1330 = phi_2698_;
                                        let _e1332 = phi_2699_;
                                        if _e1332 {
                                            if _e1303 {
                                                let _e1334 = select(1f, -1f, (_e1273 < 0f));
                                                let _e1336 = local_5.member_3;
                                                let _e1339 = local_5.member[0u];
                                                let _e1342 = local_5.member[1u];
                                                let _e1345 = local_5.member[2u];
                                                let _e1348 = local_5.member[3u];
                                                let _e1351 = (_e1345 - _e1342);
                                                phi_2730_ = type_9(0u, 64u);
                                                phi_2733_ = _e1247;
                                                phi_2735_ = _e1243;
                                                phi_2737_ = (0.5f * (_e1243 + _e1247));
                                                loop {
                                                    let _e1357 = phi_2730_;
                                                    let _e1359 = phi_2733_;
                                                    let _e1361 = phi_2735_;
                                                    let _e1363 = phi_2737_;
                                                    local_12 = _e1361;
                                                    let _e1366 = (_e1357.member < _e1357.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1366)) != 0i) {
                                                        let _e1378 = (1f - _e1363);
                                                        let _e1381 = local_5.member[0u];
                                                        let _e1384 = local_5.member[1u];
                                                        let _e1387 = local_5.member[2u];
                                                        let _e1390 = local_5.member[3u];
                                                        let _e1404 = local_5.member_1;
                                                        let _e1405 = ((_e1334 * ((((_e1381 * _e1378) + (_e1384 * _e1363)) * (_e1378 * _e1378)) + (((_e1387 * _e1378) + (_e1390 * _e1363)) * (_e1363 * _e1363)))) - _e1404);
                                                        let _e1406 = (_e1405 > 0f);
                                                        let _e1407 = select(_e1363, _e1359, _e1406);
                                                        let _e1408 = select(_e1361, _e1363, _e1406);
                                                        let _e1410 = ((_e1407 - _e1408) > _e1336);
                                                        if _e1410 {
                                                            let _e1411 = (1f - _e1363);
                                                            let _e1423 = (-(_e1405) / (_e1334 * (((((_e1342 - (3f * _e1339)) * _e1411) + (_e1351 * _e1363)) * _e1411) + (((_e1351 * _e1411) + (((3f * _e1348) - _e1345) * _e1363)) * _e1363))));
                                                            let _e1430 = ((_e1363 + _e1423) + select(-((0.5f * _e1336)), (0.5f * _e1336), (_e1405 > 0f)));
                                                            if (_e1430 > _e1408) {
                                                                phi_2847_ = select(true, select(true, false, (select(_e1423, -(_e1423), (_e1423 < 0f)) < (0.5f * (_e1407 - _e1408)))), (_e1430 < _e1407));
                                                            } else {
                                                                phi_2847_ = true;
                                                            }
                                                            let _e1442 = phi_2847_;
                                                            phi_2854_ = select(_e1430, (0.5f * (_e1408 + _e1407)), _e1442);
                                                            phi_2855_ = false;
                                                        } else {
                                                            phi_2854_ = f32();
                                                            phi_2855_ = true;
                                                        }
                                                        let _e1447 = phi_2854_;
                                                        let _e1449 = phi_2855_;
                                                        phi_2734_ = _e1407;
                                                        phi_2736_ = _e1408;
                                                        phi_2738_ = _e1447;
                                                        phi_2856_ = _e1408;
                                                        phi_2857_ = _e1410;
                                                        phi_2858_ = _e1449;
                                                    } else {
                                                        phi_2734_ = f32();
                                                        phi_2736_ = f32();
                                                        phi_2738_ = f32();
                                                        phi_2856_ = f32();
                                                        phi_2857_ = false;
                                                        phi_2858_ = false;
                                                    }
                                                    let _e1451 = phi_2734_;
                                                    let _e1453 = phi_2736_;
                                                    let _e1455 = phi_2738_;
                                                    let _e1457 = phi_2856_;
                                                    let _e1459 = phi_2857_;
                                                    let _e1461 = phi_2858_;
                                                    local_10 = _e1461;
                                                    local_11 = _e1457;
                                                    continue;
                                                    continuing {
                                                        phi_2730_ = type_9(select(_e1357.member, (_e1357.member + 1u), _e1366), select(_e1357.member_1, _e1357.member_1, _e1366));
                                                        phi_2733_ = _e1451;
                                                        phi_2735_ = _e1453;
                                                        phi_2737_ = _e1455;
                                                        break if !(_e1459);
                                                    }
                                                }
                                                let _e1464 = local_10;
                                                let _e1466 = local_11;
                                                let _e1468 = local_12;
                                                phi_2863_ = select(_e1468, _e1466, _e1464);
                                            } else {
                                                phi_2863_ = _e1243;
                                            }
                                            let _e1471 = phi_2863_;
                                            if _e1309 {
                                                let _e1475 = local_5.member_3;
                                                let _e1477 = local_5.member_3;
                                                phi_2879_ = type_9(0u, 64u);
                                                phi_2882_ = (_e1475 + _e1477);
                                                loop {
                                                    let _e1480 = phi_2879_;
                                                    let _e1482 = phi_2882_;
                                                    let _e1485 = (_e1480.member < _e1480.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1485)) != 0i) {
                                                        let _e1497 = (_e1471 + _e1482);
                                                        if (_e1497 < _e1247) {
                                                            let _e1499 = (1f - _e1497);
                                                            let _e1502 = local_5.member[0u];
                                                            let _e1505 = local_5.member[1u];
                                                            let _e1508 = local_5.member[2u];
                                                            let _e1511 = local_5.member[3u];
                                                            let _e1525 = local_5.member_1;
                                                            let _e1526 = ((select(1f, -1f, (_e1297 < 0f)) * ((((_e1502 * _e1499) + (_e1505 * _e1497)) * (_e1499 * _e1499)) + (((_e1508 * _e1499) + (_e1511 * _e1497)) * (_e1497 * _e1497)))) > _e1525);
                                                            phi_2947_ = select((_e1482 + _e1482), f32(), _e1526);
                                                            phi_2948_ = select(true, false, _e1526);
                                                            phi_2949_ = _e1526;
                                                            phi_2950_ = false;
                                                        } else {
                                                            phi_2947_ = f32();
                                                            phi_2948_ = false;
                                                            phi_2949_ = false;
                                                            phi_2950_ = true;
                                                        }
                                                        let _e1531 = phi_2947_;
                                                        let _e1533 = phi_2948_;
                                                        let _e1535 = phi_2949_;
                                                        let _e1537 = phi_2950_;
                                                        phi_2951_ = _e1497;
                                                        phi_2883_ = _e1531;
                                                        phi_2952_ = _e1533;
                                                        phi_2953_ = _e1535;
                                                        phi_2954_ = _e1537;
                                                        phi_2955_ = false;
                                                    } else {
                                                        phi_2951_ = f32();
                                                        phi_2883_ = f32();
                                                        phi_2952_ = false;
                                                        phi_2953_ = false;
                                                        phi_2954_ = false;
                                                        phi_2955_ = true;
                                                    }
                                                    let _e1539 = phi_2951_;
                                                    let _e1541 = phi_2883_;
                                                    let _e1543 = phi_2952_;
                                                    let _e1545 = phi_2953_;
                                                    let _e1547 = phi_2954_;
                                                    let _e1549 = phi_2955_;
                                                    local_13 = _e1545;
                                                    local_14 = _e1547;
                                                    local_15 = _e1545;
                                                    local_16 = _e1549;
                                                    local_17 = _e1539;
                                                    continue;
                                                    continuing {
                                                        phi_2879_ = type_9(select(_e1480.member, (_e1480.member + 1u), _e1485), select(_e1480.member_1, _e1480.member_1, _e1485));
                                                        phi_2882_ = _e1541;
                                                        break if !(_e1543);
                                                    }
                                                }
                                                let _e1552 = local_13;
                                                let _e1554 = local_14;
                                                let _e1557 = local_15;
                                                let _e1559 = local_16;
                                                let _e1563 = local_17;
                                                phi_2969_ = select(_e1563, _e1247, select(select(_e1559, false, _e1557), true, select(_e1554, false, _e1552)));
                                            } else {
                                                phi_2969_ = _e1247;
                                            }
                                            let _e1566 = phi_2969_;
                                            phi_2971_ = type_38(_e1471, _e1566, _e1317);
                                        } else {
                                            phi_2971_ = _e1330;
                                        }
                                        let _e1569 = phi_2971_;
                                        if (_e1569.member > _e1569.member_1) {
                                            phi_3938_ = bool();
                                            phi_3939_ = true;
                                            phi_3940_ = false;
                                            phi_3941_ = false;
                                            phi_3942_ = false;
                                        } else {
                                            let _e1574 = (_e1569.member > _e359);
                                            if _e1574 {
                                                phi_3934_ = bool();
                                                phi_3935_ = false;
                                                phi_3936_ = false;
                                                phi_3937_ = false;
                                            } else {
                                                let _e1578 = ((_e1569.member_1 - _e1569.member) * 0.5f);
                                                let _e1579 = (_e1569.member + _e1578);
                                                let _e1581 = (_e1578 + (0.000000059604645f * 4f));
                                                let _e1583 = local_7.member_3;
                                                let _e1586 = local_7.member[0u];
                                                let _e1592 = select(_e1586[0], -(_e1586[0]), (_e1586[0] < 0f));
                                                let _e1595 = select(_e1586[1], -(_e1586[1]), (_e1586[1] < 0f));
                                                let _e1597 = select(_e1595, _e1592, (_e1592 > _e1595));
                                                let _e1600 = select(_e1586[2], -(_e1586[2]), (_e1586[2] < 0f));
                                                let _e1602 = select(_e1600, _e1597, (_e1597 > _e1600));
                                                let _e1604 = local_7.member[1u];
                                                let _e1610 = select(_e1604[0], -(_e1604[0]), (_e1604[0] < 0f));
                                                let _e1613 = select(_e1604[1], -(_e1604[1]), (_e1604[1] < 0f));
                                                let _e1615 = select(_e1613, _e1610, (_e1610 > _e1613));
                                                let _e1618 = select(_e1604[2], -(_e1604[2]), (_e1604[2] < 0f));
                                                let _e1620 = select(_e1618, _e1615, (_e1615 > _e1618));
                                                let _e1625 = local_7.member[0u];
                                                let _e1630 = local_7.member[1u];
                                                let _e1640 = (_e1625[0] + ((_e1630[0] - _e1625[0]) * _e1579));
                                                let _e1641 = (_e1625[1] + ((_e1630[1] - _e1625[1]) * _e1579));
                                                let _e1642 = (_e1625[2] + ((_e1630[2] - _e1625[2]) * _e1579));
                                                let _e1644 = local_7.member[1u];
                                                let _e1649 = local_7.member[0u];
                                                let _e1653 = (_e1644[0] - _e1649[0]);
                                                let _e1654 = (_e1644[1] - _e1649[1]);
                                                let _e1655 = (_e1644[2] - _e1649[2]);
                                                let _e1658 = select(_e1653, -(_e1653), (_e1653 < 0f));
                                                let _e1661 = select(_e1654, -(_e1654), (_e1654 < 0f));
                                                let _e1663 = select(_e1661, _e1658, (_e1658 > _e1661));
                                                let _e1666 = select(_e1655, -(_e1655), (_e1655 < 0f));
                                                let _e1674 = ((((_e1581 * select(_e1666, _e1663, (_e1663 > _e1666))) * 1.01f) + ((select(_e1620, _e1602, (_e1602 > _e1620)) + _e1583) * (0.000000059604645f * 8f))) + _e1583);
                                                let _e1677 = select(_e1640, -(_e1640), (_e1640 < 0f));
                                                let _e1680 = select(_e1641, -(_e1641), (_e1641 < 0f));
                                                let _e1682 = select(_e1680, _e1677, (_e1677 > _e1680));
                                                let _e1685 = select(_e1642, -(_e1642), (_e1642 < 0f));
                                                let _e1688 = (select(_e1685, _e1682, (_e1682 > _e1685)) + _e1674);
                                                let _e1691 = local_7.member_3;
                                                let _e1693 = local_7.member_1[0u];
                                                let _e1699 = select(_e1693[0], -(_e1693[0]), (_e1693[0] < 0f));
                                                let _e1702 = select(_e1693[1], -(_e1693[1]), (_e1693[1] < 0f));
                                                let _e1704 = select(_e1702, _e1699, (_e1699 > _e1702));
                                                let _e1707 = select(_e1693[2], -(_e1693[2]), (_e1693[2] < 0f));
                                                let _e1709 = select(_e1707, _e1704, (_e1704 > _e1707));
                                                let _e1711 = local_7.member_1[1u];
                                                let _e1717 = select(_e1711[0], -(_e1711[0]), (_e1711[0] < 0f));
                                                let _e1720 = select(_e1711[1], -(_e1711[1]), (_e1711[1] < 0f));
                                                let _e1722 = select(_e1720, _e1717, (_e1717 > _e1720));
                                                let _e1725 = select(_e1711[2], -(_e1711[2]), (_e1711[2] < 0f));
                                                let _e1727 = select(_e1725, _e1722, (_e1722 > _e1725));
                                                let _e1732 = local_7.member_1[0u];
                                                let _e1737 = local_7.member_1[1u];
                                                let _e1747 = (_e1732[0] + ((_e1737[0] - _e1732[0]) * _e1579));
                                                let _e1748 = (_e1732[1] + ((_e1737[1] - _e1732[1]) * _e1579));
                                                let _e1749 = (_e1732[2] + ((_e1737[2] - _e1732[2]) * _e1579));
                                                let _e1751 = local_7.member_1[1u];
                                                let _e1756 = local_7.member_1[0u];
                                                let _e1760 = (_e1751[0] - _e1756[0]);
                                                let _e1761 = (_e1751[1] - _e1756[1]);
                                                let _e1762 = (_e1751[2] - _e1756[2]);
                                                let _e1765 = select(_e1760, -(_e1760), (_e1760 < 0f));
                                                let _e1768 = select(_e1761, -(_e1761), (_e1761 < 0f));
                                                let _e1770 = select(_e1768, _e1765, (_e1765 > _e1768));
                                                let _e1773 = select(_e1762, -(_e1762), (_e1762 < 0f));
                                                let _e1781 = ((((_e1581 * select(_e1773, _e1770, (_e1770 > _e1773))) * 1.01f) + ((select(_e1727, _e1709, (_e1709 > _e1727)) + _e1691) * (0.000000059604645f * 8f))) + _e1691);
                                                let _e1784 = select(_e1747, -(_e1747), (_e1747 < 0f));
                                                let _e1787 = select(_e1748, -(_e1748), (_e1748 < 0f));
                                                let _e1789 = select(_e1787, _e1784, (_e1784 > _e1787));
                                                let _e1792 = select(_e1749, -(_e1749), (_e1749 < 0f));
                                                let _e1795 = (select(_e1792, _e1789, (_e1789 > _e1792)) + _e1781);
                                                let _e1798 = local_7.member_3;
                                                let _e1800 = local_7.member_2[0u];
                                                let _e1806 = select(_e1800[0], -(_e1800[0]), (_e1800[0] < 0f));
                                                let _e1809 = select(_e1800[1], -(_e1800[1]), (_e1800[1] < 0f));
                                                let _e1811 = select(_e1809, _e1806, (_e1806 > _e1809));
                                                let _e1814 = select(_e1800[2], -(_e1800[2]), (_e1800[2] < 0f));
                                                let _e1816 = select(_e1814, _e1811, (_e1811 > _e1814));
                                                let _e1818 = local_7.member_2[1u];
                                                let _e1824 = select(_e1818[0], -(_e1818[0]), (_e1818[0] < 0f));
                                                let _e1827 = select(_e1818[1], -(_e1818[1]), (_e1818[1] < 0f));
                                                let _e1829 = select(_e1827, _e1824, (_e1824 > _e1827));
                                                let _e1832 = select(_e1818[2], -(_e1818[2]), (_e1818[2] < 0f));
                                                let _e1834 = select(_e1832, _e1829, (_e1829 > _e1832));
                                                let _e1839 = local_7.member_2[0u];
                                                let _e1844 = local_7.member_2[1u];
                                                let _e1854 = (_e1839[0] + ((_e1844[0] - _e1839[0]) * _e1579));
                                                let _e1855 = (_e1839[1] + ((_e1844[1] - _e1839[1]) * _e1579));
                                                let _e1856 = (_e1839[2] + ((_e1844[2] - _e1839[2]) * _e1579));
                                                let _e1858 = local_7.member_2[1u];
                                                let _e1863 = local_7.member_2[0u];
                                                let _e1867 = (_e1858[0] - _e1863[0]);
                                                let _e1868 = (_e1858[1] - _e1863[1]);
                                                let _e1869 = (_e1858[2] - _e1863[2]);
                                                let _e1872 = select(_e1867, -(_e1867), (_e1867 < 0f));
                                                let _e1875 = select(_e1868, -(_e1868), (_e1868 < 0f));
                                                let _e1877 = select(_e1875, _e1872, (_e1872 > _e1875));
                                                let _e1880 = select(_e1869, -(_e1869), (_e1869 < 0f));
                                                let _e1888 = ((((_e1581 * select(_e1880, _e1877, (_e1877 > _e1880))) * 1.01f) + ((select(_e1834, _e1816, (_e1816 > _e1834)) + _e1798) * (0.000000059604645f * 8f))) + _e1798);
                                                let _e1891 = select(_e1854, -(_e1854), (_e1854 < 0f));
                                                let _e1894 = select(_e1855, -(_e1855), (_e1855 < 0f));
                                                let _e1896 = select(_e1894, _e1891, (_e1891 > _e1894));
                                                let _e1899 = select(_e1856, -(_e1856), (_e1856 < 0f));
                                                let _e1902 = (select(_e1899, _e1896, (_e1896 > _e1899)) + _e1888);
                                                let _e1905 = ((_e1748 * _e1856) - (_e1749 * _e1855));
                                                let _e1908 = ((_e1749 * _e1854) - (_e1747 * _e1856));
                                                let _e1911 = ((_e1747 * _e1855) - (_e1748 * _e1854));
                                                let _e1926 = select(false, (select(_e1905, -(_e1905), (_e1905 < 0f)) > select(_e1911, -(_e1911), (_e1911 < 0f))), (select(_e1905, -(_e1905), (_e1905 < 0f)) > select(_e1908, -(_e1908), (_e1908 < 0f))));
                                                let _e1941 = select((select(_e1908, -(_e1908), (_e1908 < 0f)) > select(_e1911, -(_e1911), (_e1911 < 0f))), false, (select(_e1905, -(_e1905), (_e1905 < 0f)) > select(_e1908, -(_e1908), (_e1908 < 0f))));
                                                let _e1944 = select(select(_e1640, _e1641, _e1926), _e1642, _e1941);
                                                let _e1945 = select(select(_e1641, _e1642, _e1926), _e1640, _e1941);
                                                let _e1948 = select(select(_e1747, _e1748, _e1926), _e1749, _e1941);
                                                let _e1949 = select(select(_e1748, _e1749, _e1926), _e1747, _e1941);
                                                let _e1952 = select(select(_e1854, _e1855, _e1926), _e1856, _e1941);
                                                let _e1953 = select(select(_e1855, _e1856, _e1926), _e1854, _e1941);
                                                let _e1956 = ((_e1948 * _e1953) - (_e1949 * _e1952));
                                                let _e1972 = (((((_e1781 * _e1902) + (_e1795 * _e1888)) * 2.01f) + (((_e1795 * 2f) * (_e1902 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1795) * (1f + _e1902))));
                                                if (select(_e1956, -(_e1956), (_e1956 < 0f)) > _e1972) {
                                                    let _e1978 = select(1f, -1f, (_e1956 < 0f));
                                                    let _e1997 = (((((_e1674 * _e1902) + (_e1688 * _e1888)) * 2.01f) + (((_e1688 * 2f) * (_e1902 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1688) * (1f + _e1902))));
                                                    let _e2016 = (((((_e1781 * _e1688) + (_e1795 * _e1674)) * 2.01f) + (((_e1795 * 2f) * (_e1688 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1795) * (1f + _e1688))));
                                                    let _e2017 = (_e1956 * _e1978);
                                                    let _e2018 = (((_e1944 * _e1953) - (_e1945 * _e1952)) * _e1978);
                                                    let _e2019 = (((_e1948 * _e1945) - (_e1949 * _e1944)) * _e1978);
                                                    let _e2032 = (((select(_e2017, -(_e2017), (_e2017 < 0f)) + select(_e2018, -(_e2018), (_e2018 < 0f))) + select(_e2019, -(_e2019), (_e2019 < 0f))) * (0.000000059604645f * 4f));
                                                    if (_e226.member != 0u) {
                                                        phi_3808_ = array<type_16, 4>(type_16(_e2018, _e1997), type_16(_e2019, _e2016), type_16((_e2017 - _e2018), ((_e1972 + _e1997) + _e2032)), type_16((_e2017 - _e2019), ((_e1972 + _e2016) + _e2032)));
                                                    } else {
                                                        let _e2035 = ((_e2017 - _e2018) - _e2019);
                                                        let _e2038 = (((_e1972 + _e1997) + _e2016) + _e2032);
                                                        phi_3808_ = array<type_16, 4>(type_16(_e2018, _e1997), type_16(_e2019, _e2016), type_16(_e2035, _e2038), type_16(_e2035, _e2038));
                                                    }
                                                    let _e2056 = phi_3808_;
                                                    local_2 = array<type_16, 4>(type_16(_e2056[0].member, _e2056[0].member_1), type_16(_e2056[1].member, _e2056[1].member_1), type_16(_e2056[2].member, _e2056[2].member_1), type_16(_e2056[3].member, _e2056[3].member_1));
                                                    phi_3828_ = type_9(0u, 4u);
                                                    phi_3831_ = true;
                                                    loop {
                                                        let _e2075 = phi_3828_;
                                                        let _e2077 = phi_3831_;
                                                        local_19 = _e2077;
                                                        let _e2080 = (_e2075.member < _e2075.member_1);
                                                        let _e2091 = select(type_9().member_1, _e2075.member, _e2080);
                                                        if (bitcast<i32>(select(0u, 1u, _e2080)) != 0i) {
                                                            let _e2096 = local_2[_e2091].member;
                                                            let _e2099 = local_2[_e2091].member_1;
                                                            let _e2101 = (_e2096 < -(_e2099));
                                                            phi_3832_ = select((_e2077 && (_e2096 > _e2099)), bool(), _e2101);
                                                            phi_3883_ = select(true, false, _e2101);
                                                            phi_3884_ = _e2101;
                                                        } else {
                                                            phi_3832_ = bool();
                                                            phi_3883_ = false;
                                                            phi_3884_ = false;
                                                        }
                                                        let _e2107 = phi_3832_;
                                                        let _e2109 = phi_3883_;
                                                        let _e2111 = phi_3884_;
                                                        local_18 = _e2111;
                                                        continue;
                                                        continuing {
                                                            phi_3828_ = type_9(select(_e2075.member, (_e2075.member + 1u), _e2080), select(_e2075.member_1, _e2075.member_1, _e2080));
                                                            phi_3831_ = _e2107;
                                                            break if !(_e2109);
                                                        }
                                                    }
                                                    let _e2114 = local_18;
                                                    let _e2115 = select(true, false, _e2114);
                                                    let _e2117 = local_19;
                                                    phi_3898_ = select(u32(), select(2u, 1u, _e2117), _e2115);
                                                    phi_3899_ = 0u;
                                                    phi_3900_ = select(true, false, _e2115);
                                                } else {
                                                    phi_3898_ = u32();
                                                    phi_3899_ = 2u;
                                                    phi_3900_ = true;
                                                }
                                                let _e2122 = phi_3898_;
                                                let _e2124 = phi_3899_;
                                                let _e2126 = phi_3900_;
                                                let _e2127 = select(_e2122, _e2124, _e2126);
                                                let _e2128 = (_e2127 == 0u);
                                                if _e2128 {
                                                    phi_3931_ = bool();
                                                    phi_3932_ = false;
                                                    phi_3933_ = false;
                                                } else {
                                                    let _e2131 = select(false, _e1569.member_2, (_e2127 == 1u));
                                                    let _e2137 = select(true, select(true, false, ((_e1569.member_1 - _e1569.member) <= _e1184)), _e2131);
                                                    phi_3931_ = _e2131;
                                                    phi_3932_ = _e2137;
                                                    phi_3933_ = select(true, false, _e2137);
                                                }
                                                let _e2140 = phi_3931_;
                                                let _e2142 = phi_3932_;
                                                let _e2144 = phi_3933_;
                                                phi_3934_ = _e2140;
                                                phi_3935_ = _e2128;
                                                phi_3936_ = _e2142;
                                                phi_3937_ = _e2144;
                                            }
                                            let _e2146 = phi_3934_;
                                            let _e2148 = phi_3935_;
                                            let _e2150 = phi_3936_;
                                            let _e2152 = phi_3937_;
                                            phi_3938_ = _e2146;
                                            phi_3939_ = _e2148;
                                            phi_3940_ = _e2150;
                                            phi_3941_ = _e1574;
                                            phi_3942_ = _e2152;
                                        }
                                        let _e2154 = phi_3938_;
                                        let _e2156 = phi_3939_;
                                        let _e2158 = phi_3940_;
                                        let _e2160 = phi_3941_;
                                        let _e2162 = phi_3942_;
                                        phi_3943_ = _e1569;
                                        phi_3944_ = _e2154;
                                        phi_3945_ = _e1569;
                                        phi_3946_ = _e2156;
                                        phi_3947_ = _e2158;
                                        phi_3948_ = _e2160;
                                        phi_3949_ = _e2162;
                                    }
                                    let _e2164 = phi_3943_;
                                    let _e2166 = phi_3944_;
                                    let _e2168 = phi_3945_;
                                    let _e2170 = phi_3946_;
                                    let _e2172 = phi_3947_;
                                    let _e2174 = phi_3948_;
                                    let _e2176 = phi_3949_;
                                    phi_3950_ = _e2164;
                                    phi_3951_ = _e2166;
                                    phi_3952_ = _e2168;
                                    phi_3953_ = _e2170;
                                    phi_3954_ = _e2172;
                                    phi_3955_ = _e1249;
                                    phi_3956_ = _e2174;
                                    phi_3957_ = _e2176;
                                } else {
                                    phi_3950_ = type_38();
                                    phi_3951_ = bool();
                                    phi_3952_ = type_38();
                                    phi_3953_ = true;
                                    phi_3954_ = false;
                                    phi_3955_ = false;
                                    phi_3956_ = false;
                                    phi_3957_ = false;
                                }
                                let _e2178 = phi_3950_;
                                let _e2180 = phi_3951_;
                                let _e2182 = phi_3952_;
                                let _e2184 = phi_3953_;
                                let _e2186 = phi_3954_;
                                let _e2188 = phi_3955_;
                                let _e2190 = phi_3956_;
                                let _e2192 = phi_3957_;
                                phi_3965_ = _e2178;
                                phi_3966_ = _e2180;
                                phi_3967_ = _e2182;
                                phi_3968_ = select(_e2186, false, _e2184);
                                phi_3969_ = _e2184;
                                phi_3970_ = select(_e2188, false, _e2184);
                                phi_3971_ = select(_e2190, false, _e2184);
                                phi_3972_ = select(_e2192, false, _e2184);
                            } else {
                                phi_3965_ = type_38(_e355, _e355, false);
                                phi_3966_ = false;
                                phi_3967_ = type_38();
                                phi_3968_ = true;
                                phi_3969_ = false;
                                phi_3970_ = false;
                                phi_3971_ = false;
                                phi_3972_ = false;
                            }
                            let _e2198 = phi_3965_;
                            let _e2200 = phi_3966_;
                            let _e2202 = phi_3967_;
                            let _e2204 = phi_3968_;
                            let _e2206 = phi_3969_;
                            let _e2208 = phi_3970_;
                            let _e2210 = phi_3971_;
                            let _e2212 = phi_3972_;
                            if _e2204 {
                                let _e2217 = local_7.member[0u];
                                let _e2223 = local_7.member_1[0u];
                                let _e2229 = local_7.member_2[0u];
                                let _e2233 = (_e2217[0] - _e2223[0]);
                                let _e2234 = (_e2217[1] - _e2223[1]);
                                let _e2235 = (_e2217[2] - _e2223[2]);
                                let _e2236 = (_e226.member == 0u);
                                let _e2248 = local_7.member[1u];
                                let _e2254 = local_7.member_1[1u];
                                let _e2260 = local_7.member_2[1u];
                                let _e2264 = (_e2248[0] - _e2254[0]);
                                let _e2265 = (_e2248[1] - _e2254[1]);
                                let _e2266 = (_e2248[2] - _e2254[2]);
                                let _e2267 = (_e226.member == 0u);
                                let _e2279 = local_7.member[0u];
                                let _e2285 = select(_e2279[0], -(_e2279[0]), (_e2279[0] < 0f));
                                let _e2288 = select(_e2279[1], -(_e2279[1]), (_e2279[1] < 0f));
                                let _e2290 = select(_e2288, _e2285, (_e2285 > _e2288));
                                let _e2293 = select(_e2279[2], -(_e2279[2]), (_e2279[2] < 0f));
                                let _e2295 = select(_e2293, _e2290, (_e2290 > _e2293));
                                let _e2298 = local_7.member[1u];
                                let _e2304 = select(_e2298[0], -(_e2298[0]), (_e2298[0] < 0f));
                                let _e2307 = select(_e2298[1], -(_e2298[1]), (_e2298[1] < 0f));
                                let _e2309 = select(_e2307, _e2304, (_e2304 > _e2307));
                                let _e2312 = select(_e2298[2], -(_e2298[2]), (_e2298[2] < 0f));
                                let _e2314 = select(_e2312, _e2309, (_e2309 > _e2312));
                                let _e2318 = local_7.member_3;
                                let _e2322 = local_7.member_1[0u];
                                let _e2328 = select(_e2322[0], -(_e2322[0]), (_e2322[0] < 0f));
                                let _e2331 = select(_e2322[1], -(_e2322[1]), (_e2322[1] < 0f));
                                let _e2333 = select(_e2331, _e2328, (_e2328 > _e2331));
                                let _e2336 = select(_e2322[2], -(_e2322[2]), (_e2322[2] < 0f));
                                let _e2338 = select(_e2336, _e2333, (_e2333 > _e2336));
                                let _e2341 = local_7.member_1[1u];
                                let _e2347 = select(_e2341[0], -(_e2341[0]), (_e2341[0] < 0f));
                                let _e2350 = select(_e2341[1], -(_e2341[1]), (_e2341[1] < 0f));
                                let _e2352 = select(_e2350, _e2347, (_e2347 > _e2350));
                                let _e2355 = select(_e2341[2], -(_e2341[2]), (_e2341[2] < 0f));
                                let _e2357 = select(_e2355, _e2352, (_e2352 > _e2355));
                                let _e2361 = local_7.member_3;
                                let _e2365 = local_7.member_2[0u];
                                let _e2371 = select(_e2365[0], -(_e2365[0]), (_e2365[0] < 0f));
                                let _e2374 = select(_e2365[1], -(_e2365[1]), (_e2365[1] < 0f));
                                let _e2376 = select(_e2374, _e2371, (_e2371 > _e2374));
                                let _e2379 = select(_e2365[2], -(_e2365[2]), (_e2365[2] < 0f));
                                let _e2381 = select(_e2379, _e2376, (_e2376 > _e2379));
                                let _e2384 = local_7.member_2[1u];
                                let _e2390 = select(_e2384[0], -(_e2384[0]), (_e2384[0] < 0f));
                                let _e2393 = select(_e2384[1], -(_e2384[1]), (_e2384[1] < 0f));
                                let _e2395 = select(_e2393, _e2390, (_e2390 > _e2393));
                                let _e2398 = select(_e2384[2], -(_e2384[2]), (_e2384[2] < 0f));
                                let _e2400 = select(_e2398, _e2395, (_e2395 > _e2398));
                                let _e2404 = local_7.member_3;
                                let _e2411 = local_7.member_3;
                                let _e2416 = (_e353 * 0.00390625f);
                                local = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                phi_4395_ = type_9(0u, 96u);
                                phi_4398_ = _e2198.member;
                                phi_4400_ = _e2198.member;
                                phi_4402_ = (_e2198.member_1 - _e2198.member);
                                phi_4404_ = _e2198.member;
                                phi_4406_ = false;
                                phi_4408_ = 0u;
                                loop {
                                    let _e2419 = phi_4395_;
                                    let _e2421 = phi_4398_;
                                    let _e2423 = phi_4400_;
                                    let _e2425 = phi_4402_;
                                    let _e2427 = phi_4404_;
                                    let _e2429 = phi_4406_;
                                    let _e2431 = phi_4408_;
                                    local_29 = _e2421;
                                    local_32 = _e2423;
                                    let _e2434 = (_e2419.member < _e2419.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2434)) != 0i) {
                                        let _e2448 = local_7.member[0u];
                                        let _e2454 = local_7.member[1u];
                                        let _e2470 = local_7.member_1[0u];
                                        let _e2476 = local_7.member_1[1u];
                                        let _e2492 = local_7.member_2[0u];
                                        let _e2498 = local_7.member_2[1u];
                                        let _e2512 = function_2(array<f32, 3>((_e2448[0] + ((_e2454[0] - _e2448[0]) * _e2421)), (_e2448[1] + ((_e2454[1] - _e2448[1]) * _e2421)), (_e2448[2] + ((_e2454[2] - _e2448[2]) * _e2421))), array<f32, 3>((_e2470[0] + ((_e2476[0] - _e2470[0]) * _e2421)), (_e2470[1] + ((_e2476[1] - _e2470[1]) * _e2421)), (_e2470[2] + ((_e2476[2] - _e2470[2]) * _e2421))), array<f32, 3>((_e2492[0] + ((_e2498[0] - _e2492[0]) * _e2421)), (_e2492[1] + ((_e2498[1] - _e2492[1]) * _e2421)), (_e2492[2] + ((_e2498[2] - _e2492[2]) * _e2421))), _e226.member);
                                        if (_e2431 == 0u) {
                                            phi_4559_ = _e2512;
                                        } else {
                                            phi_4559_ = array<f32, 3>(select(0f, _e2512[0], (_e2431 == 1u)), select(0f, _e2512[1], (_e2431 == 2u)), select(0f, _e2512[2], (_e2431 == 3u)));
                                        }
                                        let _e2525 = phi_4559_;
                                        let _e2539 = ((select(_e2525[0], -(_e2525[0]), (_e2525[0] < 0f)) + select(_e2525[1], -(_e2525[1]), (_e2525[1] < 0f))) + select(_e2525[2], -(_e2525[2]), (_e2525[2] < 0f)));
                                        if (_e2539 > 0f) {
                                            if ((bitcast<u32>(_e2539) & 2139095040u) != 2139095040u) {
                                                let _e2544 = (1f / _e2539);
                                                let _e2546 = (_e2525[0] * _e2544);
                                                let _e2548 = (_e2525[1] * _e2544);
                                                let _e2550 = (_e2525[2] * _e2544);
                                                let _e2555 = (((_e2546 * _e2546) + (_e2548 * _e2548)) + (_e2550 * _e2550));
                                                if (_e2555 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4682_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2555 > 0f));
                                                } else {
                                                    phi_4625_ = type_14(0i, 5i);
                                                    phi_4628_ = bitcast<f32>(((bitcast<u32>(_e2555) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2563 = phi_4625_;
                                                        let _e2565 = phi_4628_;
                                                        local_20 = _e2565;
                                                        if (_e2563.member < _e2563.member_1) {
                                                            let _e2572 = (_e2563.member + 1i);
                                                            phi_4626_ = type_14(select(_e2572, type_15().member_1, select(false, true, ((false == (_e2572 > _e2563.member)) != false))), _e2563.member_1);
                                                            phi_4669_ = type_15(1u, _e2563.member);
                                                        } else {
                                                            phi_4626_ = _e2563;
                                                            phi_4669_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e2583 = phi_4626_;
                                                        let _e2585 = phi_4669_;
                                                        let _e2588 = (bitcast<i32>(_e2585.member) != 0i);
                                                        if _e2588 {
                                                            phi_4629_ = (0.5f * (_e2565 + (_e2555 / _e2565)));
                                                        } else {
                                                            phi_4629_ = f32();
                                                        }
                                                        let _e2593 = phi_4629_;
                                                        continue;
                                                        continuing {
                                                            phi_4625_ = _e2583;
                                                            phi_4628_ = _e2593;
                                                            break if !(_e2588);
                                                        }
                                                    }
                                                    let _e2598 = local_20;
                                                    phi_4682_ = (_e2598 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2604 = phi_4682_;
                                                let _e2605 = (0.000000059604645f * 12f);
                                                let _e2610 = ((((((((select(_e2314, _e2295, (_e2295 > _e2314)) + _e2318) + (select(_e2357, _e2338, (_e2338 > _e2357)) + _e2361)) + (select(_e2400, _e2381, (_e2381 > _e2400)) + _e2404)) * (0.000000059604645f * 16f)) + (_e2411 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2604) * (1f + _e2605)));
                                                let _e2615 = (((_e2546 * _e2217[0]) + (_e2548 * _e2217[1])) + (_e2550 * _e2217[2]));
                                                let _e2620 = (((_e2546 * _e2233) + (_e2548 * _e2234)) + (_e2550 * _e2235));
                                                let _e2625 = (((_e2546 * (_e2217[0] - _e2229[0])) + (_e2548 * (_e2217[1] - _e2229[1]))) + (_e2550 * (_e2217[2] - _e2229[2])));
                                                let _e2630 = (((_e2546 * select((_e2233 - _e2229[0]), _e2217[0], _e2236)) + (_e2548 * select((_e2234 - _e2229[1]), _e2217[1], _e2236))) + (_e2550 * select((_e2235 - _e2229[2]), _e2217[2], _e2236)));
                                                let _e2636 = (((_e2546 * _e2248[0]) + (_e2548 * _e2248[1])) + (_e2550 * _e2248[2]));
                                                let _e2641 = (((_e2546 * _e2264) + (_e2548 * _e2265)) + (_e2550 * _e2266));
                                                let _e2646 = (((_e2546 * (_e2248[0] - _e2260[0])) + (_e2548 * (_e2248[1] - _e2260[1]))) + (_e2550 * (_e2248[2] - _e2260[2])));
                                                let _e2651 = (((_e2546 * select((_e2264 - _e2260[0]), _e2248[0], _e2267)) + (_e2548 * select((_e2265 - _e2260[1]), _e2248[1], _e2267))) + (_e2550 * select((_e2266 - _e2260[2]), _e2248[2], _e2267)));
                                                phi_4805_ = type_30(array<f32, 4>(_e2615, _e2620, _e2625, _e2630), array<f32, 4>(_e2636, _e2641, _e2646, _e2651), array<f32, 4>((_e2610 + ((select(_e2615, -(_e2615), (_e2615 < 0f)) + select(_e2636, -(_e2636), (_e2636 < 0f))) * _e2605)), (_e2610 + ((select(_e2620, -(_e2620), (_e2620 < 0f)) + select(_e2641, -(_e2641), (_e2641 < 0f))) * _e2605)), (_e2610 + ((select(_e2625, -(_e2625), (_e2625 < 0f)) + select(_e2646, -(_e2646), (_e2646 < 0f))) * _e2605)), (_e2610 + ((select(_e2630, -(_e2630), (_e2630 < 0f)) + select(_e2651, -(_e2651), (_e2651 < 0f))) * _e2605))));
                                                phi_4806_ = false;
                                            } else {
                                                phi_4805_ = type_30();
                                                phi_4806_ = true;
                                            }
                                            let _e2692 = phi_4805_;
                                            let _e2694 = phi_4806_;
                                            phi_4807_ = _e2692;
                                            phi_4808_ = _e2694;
                                        } else {
                                            phi_4807_ = type_30();
                                            phi_4808_ = true;
                                        }
                                        let _e2696 = phi_4807_;
                                        let _e2698 = phi_4808_;
                                        if _e2698 {
                                            phi_4816_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_4816_ = _e2696;
                                        }
                                        let _e2700 = phi_4816_;
                                        local_1 = type_30(array<f32, 4>(_e2700.member[0], _e2700.member[1], _e2700.member[2], _e2700.member[3]), array<f32, 4>(_e2700.member_1[0], _e2700.member_1[1], _e2700.member_1[2], _e2700.member_1[3]), array<f32, 4>(_e2700.member_2[0], _e2700.member_2[1], _e2700.member_2[2], _e2700.member_2[3]));
                                        let _e2720 = (_e2421 - _e2427);
                                        let _e2724 = local_1.member[0u];
                                        let _e2727 = local_1.member_1[0u];
                                        let _e2730 = local_1.member[0u];
                                        let _e2736 = local_1.member_2[0u];
                                        if (((_e2724 + ((_e2727 - _e2730) * _e2421)) - _e2736) > 0f) {
                                            let _e2741 = local_1.member[1u];
                                            let _e2744 = local_1.member_1[1u];
                                            let _e2747 = local_1.member[1u];
                                            let _e2753 = local_1.member_2[1u];
                                            if (((_e2741 + ((_e2744 - _e2747) * _e2421)) - _e2753) > 0f) {
                                                let _e2758 = local_1.member[2u];
                                                let _e2761 = local_1.member_1[2u];
                                                let _e2764 = local_1.member[2u];
                                                let _e2770 = local_1.member_2[2u];
                                                if (((_e2758 + ((_e2761 - _e2764) * _e2421)) - _e2770) > 0f) {
                                                    let _e2775 = local_1.member[3u];
                                                    let _e2778 = local_1.member_1[3u];
                                                    let _e2781 = local_1.member[3u];
                                                    let _e2787 = local_1.member_2[3u];
                                                    phi_4987_ = (((_e2775 + ((_e2778 - _e2781) * _e2421)) - _e2787) > 0f);
                                                    phi_4988_ = false;
                                                } else {
                                                    phi_4987_ = bool();
                                                    phi_4988_ = true;
                                                }
                                                let _e2791 = phi_4987_;
                                                let _e2793 = phi_4988_;
                                                phi_4989_ = _e2791;
                                                phi_4990_ = _e2793;
                                            } else {
                                                phi_4989_ = bool();
                                                phi_4990_ = true;
                                            }
                                            let _e2795 = phi_4989_;
                                            let _e2797 = phi_4990_;
                                            phi_4991_ = _e2795;
                                            phi_4992_ = _e2797;
                                        } else {
                                            phi_4991_ = bool();
                                            phi_4992_ = true;
                                        }
                                        let _e2799 = phi_4991_;
                                        let _e2801 = phi_4992_;
                                        if select(_e2799, false, _e2801) {
                                            if (_e2421 <= _e2423) {
                                                phi_5306_ = true;
                                            } else {
                                                let _e2806 = local.member[0u];
                                                let _e2809 = local.member_1[0u];
                                                let _e2812 = local.member[0u];
                                                let _e2818 = local.member_2[0u];
                                                let _e2822 = local_1.member[0u];
                                                let _e2825 = local_1.member_1[0u];
                                                let _e2828 = local_1.member[0u];
                                                let _e2834 = local_1.member_2[0u];
                                                if ((((_e2806 + ((_e2809 - _e2812) * _e2421)) - _e2818) + ((_e2822 + ((_e2825 - _e2828) * _e2427)) - _e2834)) > 0f) {
                                                    let _e2840 = local.member[1u];
                                                    let _e2843 = local.member_1[1u];
                                                    let _e2846 = local.member[1u];
                                                    let _e2852 = local.member_2[1u];
                                                    let _e2856 = local_1.member[1u];
                                                    let _e2859 = local_1.member_1[1u];
                                                    let _e2862 = local_1.member[1u];
                                                    let _e2868 = local_1.member_2[1u];
                                                    if ((((_e2840 + ((_e2843 - _e2846) * _e2421)) - _e2852) + ((_e2856 + ((_e2859 - _e2862) * _e2427)) - _e2868)) > 0f) {
                                                        let _e2874 = local.member[2u];
                                                        let _e2877 = local.member_1[2u];
                                                        let _e2880 = local.member[2u];
                                                        let _e2886 = local.member_2[2u];
                                                        let _e2890 = local_1.member[2u];
                                                        let _e2893 = local_1.member_1[2u];
                                                        let _e2896 = local_1.member[2u];
                                                        let _e2902 = local_1.member_2[2u];
                                                        if ((((_e2874 + ((_e2877 - _e2880) * _e2421)) - _e2886) + ((_e2890 + ((_e2893 - _e2896) * _e2427)) - _e2902)) > 0f) {
                                                            let _e2908 = local.member[3u];
                                                            let _e2911 = local.member_1[3u];
                                                            let _e2914 = local.member[3u];
                                                            let _e2920 = local.member_2[3u];
                                                            let _e2924 = local_1.member[3u];
                                                            let _e2927 = local_1.member_1[3u];
                                                            let _e2930 = local_1.member[3u];
                                                            let _e2936 = local_1.member_2[3u];
                                                            phi_5293_ = ((((_e2908 + ((_e2911 - _e2914) * _e2421)) - _e2920) + ((_e2924 + ((_e2927 - _e2930) * _e2427)) - _e2936)) > 0f);
                                                            phi_5294_ = false;
                                                        } else {
                                                            phi_5293_ = bool();
                                                            phi_5294_ = true;
                                                        }
                                                        let _e2941 = phi_5293_;
                                                        let _e2943 = phi_5294_;
                                                        phi_5295_ = _e2941;
                                                        phi_5296_ = _e2943;
                                                    } else {
                                                        phi_5295_ = bool();
                                                        phi_5296_ = true;
                                                    }
                                                    let _e2945 = phi_5295_;
                                                    let _e2947 = phi_5296_;
                                                    phi_5297_ = _e2945;
                                                    phi_5298_ = _e2947;
                                                } else {
                                                    phi_5297_ = bool();
                                                    phi_5298_ = true;
                                                }
                                                let _e2949 = phi_5297_;
                                                let _e2951 = phi_5298_;
                                                phi_5306_ = select(_e2949, false, _e2951);
                                            }
                                            let _e2954 = phi_5306_;
                                            if _e2954 {
                                                if select(true, select(true, false, (_e2421 >= _e2198.member_1)), _e2429) {
                                                    local = type_30(array<f32, 4>(_e2700.member[0], _e2700.member[1], _e2700.member[2], _e2700.member[3]), array<f32, 4>(_e2700.member_1[0], _e2700.member_1[1], _e2700.member_1[2], _e2700.member_1[3]), array<f32, 4>(_e2700.member_2[0], _e2700.member_2[1], _e2700.member_2[2], _e2700.member_2[3]));
                                                    let _e2979 = local.member[0u];
                                                    let _e2982 = local.member_1[0u];
                                                    let _e2985 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e2982 > _e2985)), (_e2979 > _e2985)) {
                                                        let _e2990 = (_e2982 >= _e2979);
                                                        if _e2990 {
                                                            phi_5415_ = f32();
                                                            phi_5416_ = false;
                                                        } else {
                                                            if ((_e2979 - _e2982) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5413_ = (((_e2979 - _e2985) / (_e2979 - _e2982)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5414_ = false;
                                                            } else {
                                                                phi_5413_ = f32();
                                                                phi_5414_ = true;
                                                            }
                                                            let _e3001 = phi_5413_;
                                                            let _e3003 = phi_5414_;
                                                            phi_5415_ = _e3001;
                                                            phi_5416_ = _e3003;
                                                        }
                                                        let _e3005 = phi_5415_;
                                                        let _e3007 = phi_5416_;
                                                        phi_5417_ = _e3005;
                                                        phi_5418_ = _e2990;
                                                        phi_5419_ = _e3007;
                                                    } else {
                                                        phi_5417_ = f32();
                                                        phi_5418_ = true;
                                                        phi_5419_ = false;
                                                    }
                                                    let _e3009 = phi_5417_;
                                                    let _e3011 = phi_5418_;
                                                    let _e3013 = phi_5419_;
                                                    let _e3016 = select(_e3009, select(_e2421, 2f, _e3011), select(_e3013, true, _e3011));
                                                    let _e3019 = local.member[1u];
                                                    let _e3022 = local.member_1[1u];
                                                    let _e3025 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3022 > _e3025)), (_e3019 > _e3025)) {
                                                        let _e3030 = (_e3022 >= _e3019);
                                                        if _e3030 {
                                                            phi_5483_ = f32();
                                                            phi_5484_ = false;
                                                        } else {
                                                            if ((_e3019 - _e3022) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5481_ = (((_e3019 - _e3025) / (_e3019 - _e3022)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5482_ = false;
                                                            } else {
                                                                phi_5481_ = f32();
                                                                phi_5482_ = true;
                                                            }
                                                            let _e3041 = phi_5481_;
                                                            let _e3043 = phi_5482_;
                                                            phi_5483_ = _e3041;
                                                            phi_5484_ = _e3043;
                                                        }
                                                        let _e3045 = phi_5483_;
                                                        let _e3047 = phi_5484_;
                                                        phi_5485_ = _e3045;
                                                        phi_5486_ = _e3030;
                                                        phi_5487_ = _e3047;
                                                    } else {
                                                        phi_5485_ = f32();
                                                        phi_5486_ = true;
                                                        phi_5487_ = false;
                                                    }
                                                    let _e3049 = phi_5485_;
                                                    let _e3051 = phi_5486_;
                                                    let _e3053 = phi_5487_;
                                                    let _e3056 = select(_e3049, select(_e2421, 2f, _e3051), select(_e3053, true, _e3051));
                                                    let _e3058 = select(_e3056, _e3016, (_e3016 < _e3056));
                                                    let _e3061 = local.member[2u];
                                                    let _e3064 = local.member_1[2u];
                                                    let _e3067 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3064 > _e3067)), (_e3061 > _e3067)) {
                                                        let _e3072 = (_e3064 >= _e3061);
                                                        if _e3072 {
                                                            phi_5556_ = f32();
                                                            phi_5557_ = false;
                                                        } else {
                                                            if ((_e3061 - _e3064) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5554_ = (((_e3061 - _e3067) / (_e3061 - _e3064)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5555_ = false;
                                                            } else {
                                                                phi_5554_ = f32();
                                                                phi_5555_ = true;
                                                            }
                                                            let _e3083 = phi_5554_;
                                                            let _e3085 = phi_5555_;
                                                            phi_5556_ = _e3083;
                                                            phi_5557_ = _e3085;
                                                        }
                                                        let _e3087 = phi_5556_;
                                                        let _e3089 = phi_5557_;
                                                        phi_5558_ = _e3087;
                                                        phi_5559_ = _e3072;
                                                        phi_5560_ = _e3089;
                                                    } else {
                                                        phi_5558_ = f32();
                                                        phi_5559_ = true;
                                                        phi_5560_ = false;
                                                    }
                                                    let _e3091 = phi_5558_;
                                                    let _e3093 = phi_5559_;
                                                    let _e3095 = phi_5560_;
                                                    let _e3098 = select(_e3091, select(_e2421, 2f, _e3093), select(_e3095, true, _e3093));
                                                    let _e3101 = local.member[3u];
                                                    let _e3104 = local.member_1[3u];
                                                    let _e3107 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3104 > _e3107)), (_e3101 > _e3107)) {
                                                        let _e3112 = (_e3104 >= _e3101);
                                                        if _e3112 {
                                                            phi_5624_ = f32();
                                                            phi_5625_ = false;
                                                        } else {
                                                            if ((_e3101 - _e3104) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5622_ = (((_e3101 - _e3107) / (_e3101 - _e3104)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5623_ = false;
                                                            } else {
                                                                phi_5622_ = f32();
                                                                phi_5623_ = true;
                                                            }
                                                            let _e3123 = phi_5622_;
                                                            let _e3125 = phi_5623_;
                                                            phi_5624_ = _e3123;
                                                            phi_5625_ = _e3125;
                                                        }
                                                        let _e3127 = phi_5624_;
                                                        let _e3129 = phi_5625_;
                                                        phi_5626_ = _e3127;
                                                        phi_5627_ = _e3112;
                                                        phi_5628_ = _e3129;
                                                    } else {
                                                        phi_5626_ = f32();
                                                        phi_5627_ = true;
                                                        phi_5628_ = false;
                                                    }
                                                    let _e3131 = phi_5626_;
                                                    let _e3133 = phi_5627_;
                                                    let _e3135 = phi_5628_;
                                                    let _e3138 = select(_e3131, select(_e2421, 2f, _e3133), select(_e3135, true, _e3133));
                                                    let _e3140 = select(_e3138, _e3098, (_e3098 < _e3138));
                                                    let _e3142 = select(_e3140, _e3058, (_e3058 < _e3140));
                                                    let _e3144 = select(_e2421, _e3142, (_e3142 > _e2421));
                                                    let _e3145 = (_e3144 > _e2198.member_1);
                                                    if _e3145 {
                                                        phi_6157_ = f32();
                                                        phi_6158_ = f32();
                                                        phi_6159_ = false;
                                                    } else {
                                                        let _e3146 = (_e3144 - _e2421);
                                                        phi_6157_ = select((_e2198.member_1 - _e2421), select(0f, (_e2720 + _e2720), select(select(true, false, (_e3146 <= (_e2425 * 0.25f))), true, (_e3146 <= _e2416))), _e2429);
                                                        phi_6158_ = _e3146;
                                                        phi_6159_ = true;
                                                    }
                                                    let _e3157 = phi_6157_;
                                                    let _e3159 = phi_6158_;
                                                    let _e3161 = phi_6159_;
                                                    phi_6161_ = _e3144;
                                                    phi_6162_ = _e3157;
                                                    phi_6163_ = _e3159;
                                                    phi_6165_ = _e3161;
                                                    phi_6166_ = _e3145;
                                                    phi_6168_ = false;
                                                } else {
                                                    phi_6161_ = f32();
                                                    phi_6162_ = f32();
                                                    phi_6163_ = f32();
                                                    phi_6165_ = false;
                                                    phi_6166_ = false;
                                                    phi_6168_ = true;
                                                }
                                                let _e3163 = phi_6161_;
                                                let _e3165 = phi_6162_;
                                                let _e3167 = phi_6163_;
                                                let _e3169 = phi_6165_;
                                                let _e3171 = phi_6166_;
                                                let _e3173 = phi_6168_;
                                                phi_6169_ = _e3163;
                                                phi_6170_ = _e3165;
                                                phi_6171_ = _e3167;
                                                phi_6173_ = false;
                                                phi_6174_ = _e3169;
                                                phi_6175_ = _e3171;
                                                phi_6177_ = _e3173;
                                            } else {
                                                phi_6169_ = f32();
                                                phi_6170_ = f32();
                                                phi_6171_ = f32();
                                                phi_6173_ = true;
                                                phi_6174_ = false;
                                                phi_6175_ = false;
                                                phi_6177_ = false;
                                            }
                                            let _e3175 = phi_6169_;
                                            let _e3177 = phi_6170_;
                                            let _e3179 = phi_6171_;
                                            let _e3181 = phi_6173_;
                                            let _e3183 = phi_6174_;
                                            let _e3185 = phi_6175_;
                                            let _e3187 = phi_6177_;
                                            phi_6178_ = _e3175;
                                            phi_6179_ = _e3177;
                                            phi_6180_ = _e3179;
                                            phi_6182_ = _e3181;
                                            phi_6183_ = _e3183;
                                            phi_6184_ = _e3185;
                                            phi_6186_ = _e3187;
                                        } else {
                                            phi_6178_ = f32();
                                            phi_6179_ = f32();
                                            phi_6180_ = f32();
                                            phi_6182_ = true;
                                            phi_6183_ = false;
                                            phi_6184_ = false;
                                            phi_6186_ = false;
                                        }
                                        let _e3189 = phi_6178_;
                                        let _e3191 = phi_6179_;
                                        let _e3193 = phi_6180_;
                                        let _e3195 = phi_6182_;
                                        let _e3197 = phi_6183_;
                                        let _e3199 = phi_6184_;
                                        let _e3201 = phi_6186_;
                                        if _e3195 {
                                            if (_e2421 <= _e2423) {
                                                let _e3354 = (_e2431 + 1u);
                                                let _e3355 = (_e3354 > 3u);
                                                phi_6521_ = _e3354;
                                                phi_6522_ = f32();
                                                phi_6523_ = false;
                                                phi_6524_ = select(true, false, _e3355);
                                                phi_6525_ = _e3355;
                                            } else {
                                                let _e3205 = local.member[0u];
                                                let _e3208 = local.member_1[0u];
                                                let _e3211 = local.member[0u];
                                                let _e3217 = local.member_2[0u];
                                                let _e3218 = ((_e3205 + ((_e3208 - _e3211) * _e2427)) - _e3217);
                                                let _e3221 = local.member[1u];
                                                let _e3224 = local.member_1[1u];
                                                let _e3227 = local.member[1u];
                                                let _e3233 = local.member_2[1u];
                                                let _e3234 = ((_e3221 + ((_e3224 - _e3227) * _e2427)) - _e3233);
                                                let _e3236 = select(_e3234, _e3218, (_e3218 < _e3234));
                                                let _e3239 = local.member[2u];
                                                let _e3242 = local.member_1[2u];
                                                let _e3245 = local.member[2u];
                                                let _e3251 = local.member_2[2u];
                                                let _e3252 = ((_e3239 + ((_e3242 - _e3245) * _e2427)) - _e3251);
                                                let _e3255 = local.member[3u];
                                                let _e3258 = local.member_1[3u];
                                                let _e3261 = local.member[3u];
                                                let _e3267 = local.member_2[3u];
                                                let _e3268 = ((_e3255 + ((_e3258 - _e3261) * _e2427)) - _e3267);
                                                let _e3270 = select(_e3268, _e3252, (_e3252 < _e3268));
                                                let _e3272 = select(_e3270, _e3236, (_e3236 < _e3270));
                                                let _e3275 = local_1.member[0u];
                                                let _e3278 = local_1.member_1[0u];
                                                let _e3281 = local_1.member[0u];
                                                let _e3287 = local_1.member_2[0u];
                                                let _e3288 = ((_e3275 + ((_e3278 - _e3281) * _e2421)) - _e3287);
                                                let _e3291 = local_1.member[1u];
                                                let _e3294 = local_1.member_1[1u];
                                                let _e3297 = local_1.member[1u];
                                                let _e3303 = local_1.member_2[1u];
                                                let _e3304 = ((_e3291 + ((_e3294 - _e3297) * _e2421)) - _e3303);
                                                let _e3306 = select(_e3304, _e3288, (_e3288 < _e3304));
                                                let _e3309 = local_1.member[2u];
                                                let _e3312 = local_1.member_1[2u];
                                                let _e3315 = local_1.member[2u];
                                                let _e3321 = local_1.member_2[2u];
                                                let _e3322 = ((_e3309 + ((_e3312 - _e3315) * _e2421)) - _e3321);
                                                let _e3325 = local_1.member[3u];
                                                let _e3328 = local_1.member_1[3u];
                                                let _e3331 = local_1.member[3u];
                                                let _e3337 = local_1.member_2[3u];
                                                let _e3338 = ((_e3325 + ((_e3328 - _e3331) * _e2421)) - _e3337);
                                                let _e3340 = select(_e3338, _e3322, (_e3322 < _e3338));
                                                let _e3342 = select(_e3340, _e3306, (_e3306 < _e3340));
                                                if (_e3342 > 0f) {
                                                    phi_6519_ = 0.5f;
                                                } else {
                                                    let _e3346 = (0.95f * (_e3272 / (_e3272 - _e3342)));
                                                    phi_6519_ = select(0.0625f, select(0.9f, _e3346, (_e3346 < 0.9f)), (_e3346 > 0.0625f));
                                                }
                                                let _e3352 = phi_6519_;
                                                phi_6521_ = u32();
                                                phi_6522_ = (_e2720 * _e3352);
                                                phi_6523_ = true;
                                                phi_6524_ = false;
                                                phi_6525_ = false;
                                            }
                                            let _e3358 = phi_6521_;
                                            let _e3360 = phi_6522_;
                                            let _e3362 = phi_6523_;
                                            let _e3364 = phi_6524_;
                                            let _e3366 = phi_6525_;
                                            phi_6526_ = _e3358;
                                            phi_6527_ = _e2423;
                                            phi_6528_ = _e3360;
                                            phi_6529_ = _e2425;
                                            phi_6530_ = _e2427;
                                            phi_6531_ = _e2429;
                                            phi_6532_ = _e2431;
                                            phi_6533_ = _e3362;
                                            phi_6534_ = _e3364;
                                            phi_6535_ = _e3366;
                                            phi_6536_ = false;
                                            phi_6538_ = false;
                                        } else {
                                            phi_6526_ = u32();
                                            phi_6527_ = _e3189;
                                            phi_6528_ = _e3191;
                                            phi_6529_ = _e3193;
                                            phi_6530_ = _e2421;
                                            phi_6531_ = true;
                                            phi_6532_ = 0u;
                                            phi_6533_ = _e3197;
                                            phi_6534_ = false;
                                            phi_6535_ = false;
                                            phi_6536_ = _e3199;
                                            phi_6538_ = _e3201;
                                        }
                                        let _e3368 = phi_6526_;
                                        let _e3370 = phi_6527_;
                                        let _e3372 = phi_6528_;
                                        let _e3374 = phi_6529_;
                                        let _e3376 = phi_6530_;
                                        let _e3378 = phi_6531_;
                                        let _e3380 = phi_6532_;
                                        let _e3382 = phi_6533_;
                                        let _e3384 = phi_6534_;
                                        let _e3386 = phi_6535_;
                                        let _e3388 = phi_6536_;
                                        let _e3390 = phi_6538_;
                                        if _e3382 {
                                            let _e3391 = (_e3376 + _e3372);
                                            let _e3393 = select(_e3370, _e3391, (_e3391 > _e3370));
                                            let _e3395 = select(_e2198.member_1, _e3393, (_e3393 < _e2198.member_1));
                                            let _e3398 = select(((_e3395 - _e3376) > _e2416), true, !(_e2429));
                                            phi_6566_ = _e3395;
                                            phi_6567_ = _e3370;
                                            phi_6568_ = _e3374;
                                            phi_6569_ = _e3376;
                                            phi_6570_ = _e3378;
                                            phi_6571_ = _e3380;
                                            phi_6572_ = _e3398;
                                            phi_6573_ = select(true, false, _e3398);
                                            phi_6574_ = false;
                                            phi_6575_ = false;
                                            phi_6577_ = false;
                                        } else {
                                            phi_6566_ = _e2421;
                                            phi_6567_ = _e2423;
                                            phi_6568_ = _e2425;
                                            phi_6569_ = _e2427;
                                            phi_6570_ = _e2429;
                                            phi_6571_ = _e3368;
                                            phi_6572_ = _e3384;
                                            phi_6573_ = false;
                                            phi_6574_ = _e3386;
                                            phi_6575_ = _e3388;
                                            phi_6577_ = _e3390;
                                        }
                                        let _e3401 = phi_6566_;
                                        let _e3403 = phi_6567_;
                                        let _e3405 = phi_6568_;
                                        let _e3407 = phi_6569_;
                                        let _e3409 = phi_6570_;
                                        let _e3411 = phi_6571_;
                                        let _e3413 = phi_6572_;
                                        let _e3415 = phi_6573_;
                                        let _e3417 = phi_6574_;
                                        let _e3419 = phi_6575_;
                                        let _e3421 = phi_6577_;
                                        phi_4399_ = _e3401;
                                        phi_4401_ = _e3403;
                                        phi_4403_ = _e3405;
                                        phi_4405_ = _e3407;
                                        phi_4407_ = _e3409;
                                        phi_4409_ = _e3411;
                                        phi_6578_ = _e3370;
                                        phi_6580_ = _e3413;
                                        phi_6581_ = _e3415;
                                        phi_6582_ = _e3417;
                                        phi_6583_ = _e3419;
                                        phi_6585_ = false;
                                        phi_6586_ = _e3421;
                                    } else {
                                        phi_4399_ = f32();
                                        phi_4401_ = f32();
                                        phi_4403_ = f32();
                                        phi_4405_ = f32();
                                        phi_4407_ = bool();
                                        phi_4409_ = u32();
                                        phi_6578_ = f32();
                                        phi_6580_ = false;
                                        phi_6581_ = false;
                                        phi_6582_ = false;
                                        phi_6583_ = false;
                                        phi_6585_ = true;
                                        phi_6586_ = false;
                                    }
                                    let _e3423 = phi_4399_;
                                    let _e3425 = phi_4401_;
                                    let _e3427 = phi_4403_;
                                    let _e3429 = phi_4405_;
                                    let _e3431 = phi_4407_;
                                    let _e3433 = phi_4409_;
                                    let _e3435 = phi_6578_;
                                    let _e3437 = phi_6580_;
                                    let _e3439 = phi_6581_;
                                    let _e3441 = phi_6582_;
                                    let _e3443 = phi_6583_;
                                    let _e3445 = phi_6585_;
                                    let _e3447 = phi_6586_;
                                    local_21 = _e3439;
                                    local_22 = _e3441;
                                    local_23 = _e3439;
                                    local_24 = _e3443;
                                    local_25 = _e3439;
                                    local_26 = _e3445;
                                    local_27 = _e3439;
                                    local_28 = _e3447;
                                    local_30 = _e3439;
                                    local_31 = _e3435;
                                    continue;
                                    continuing {
                                        phi_4395_ = type_9(select(_e2419.member, (_e2419.member + 1u), _e2434), select(_e2419.member_1, _e2419.member_1, _e2434));
                                        phi_4398_ = _e3423;
                                        phi_4400_ = _e3425;
                                        phi_4402_ = _e3427;
                                        phi_4404_ = _e3429;
                                        phi_4406_ = _e3431;
                                        phi_4408_ = _e3433;
                                        break if !(_e3437);
                                    }
                                }
                                let _e3450 = local_21;
                                let _e3452 = local_22;
                                let _e3453 = select(_e3452, false, _e3450);
                                let _e3455 = local_23;
                                let _e3457 = local_24;
                                let _e3460 = local_25;
                                let _e3462 = local_26;
                                let _e3465 = local_27;
                                let _e3467 = local_28;
                                let _e3473 = local_29;
                                let _e3475 = select(select(_e3457, false, _e3455), false, _e3453);
                                let _e3477 = local_30;
                                let _e3484 = select(select(_e3477, false, _e3453), false, _e3475);
                                let _e3489 = local_31;
                                let _e3491 = local_32;
                                let _e3493 = select(select(select(select(_e3462, false, _e3460), false, _e3453), false, _e3475), true, _e3484);
                                let _e3500 = select(select(select(select(select(_e3467, false, _e3465), false, _e3453), false, _e3475), false, _e3484), false, _e3493);
                                let _e3505 = select(select(select(select(_e3453, true, _e3475), false, _e3484), false, _e3493), true, _e3500);
                                let _e3508 = (select(select(type_33().member, 1u, _e3493), select(select(select(type_33().member, 1u, _e3453), 0u, _e3475), 0u, _e3500), _e3505) != 0u);
                                phi_6654_ = select(select(type_33().member_1, select(_e3491, _e3489, _e3484), _e3493), select(select(select(type_33().member_1, _e3473, _e3453), type_33().member_1, _e3475), type_33().member_1, _e3500), _e3505);
                                phi_6655_ = select(true, false, _e3508);
                                phi_6656_ = _e3508;
                                phi_6657_ = false;
                                phi_6658_ = false;
                                phi_6659_ = false;
                            } else {
                                phi_6654_ = f32();
                                phi_6655_ = _e2206;
                                phi_6656_ = false;
                                phi_6657_ = _e2208;
                                phi_6658_ = _e2210;
                                phi_6659_ = _e2212;
                            }
                            let _e3511 = phi_6654_;
                            let _e3513 = phi_6655_;
                            let _e3515 = phi_6656_;
                            let _e3517 = phi_6657_;
                            let _e3519 = phi_6658_;
                            let _e3521 = phi_6659_;
                            phi_6660_ = _e2198;
                            phi_6661_ = _e2200;
                            phi_6662_ = _e3511;
                            phi_6663_ = _e2202;
                            phi_6664_ = _e3513;
                            phi_6665_ = _e3515;
                            phi_6666_ = false;
                            phi_6667_ = _e3517;
                            phi_6668_ = _e3519;
                            phi_6669_ = _e3521;
                        } else {
                            phi_6660_ = type_38();
                            phi_6661_ = bool();
                            phi_6662_ = f32();
                            phi_6663_ = type_38();
                            phi_6664_ = false;
                            phi_6665_ = false;
                            phi_6666_ = true;
                            phi_6667_ = false;
                            phi_6668_ = false;
                            phi_6669_ = false;
                        }
                        let _e3523 = phi_6660_;
                        let _e3525 = phi_6661_;
                        let _e3527 = phi_6662_;
                        let _e3529 = phi_6663_;
                        let _e3531 = phi_6664_;
                        let _e3533 = phi_6665_;
                        let _e3535 = phi_6666_;
                        let _e3537 = phi_6667_;
                        let _e3539 = phi_6668_;
                        let _e3541 = phi_6669_;
                        local_33 = _e3533;
                        local_34 = _e3525;
                        local_35 = _e3523;
                        local_36 = _e3527;
                        local_37 = _e3527;
                        local_38 = _e3527;
                        local_42 = _e3535;
                        local_43 = _e3537;
                        local_44 = _e3539;
                        local_45 = _e3541;
                        local_39 = _e3533;
                        local_40 = _e3529;
                        continue;
                        continuing {
                            phi_2540_ = type_9(select(_e1220.member, (_e1220.member + 1u), _e1223), select(_e1220.member_1, _e1220.member_1, _e1223));
                            break if !(_e3531);
                        }
                    }
                    let _e3544 = local_33;
                    if _e3544 {
                        let _e3546 = local_34;
                        if _e3546 {
                            let _e3548 = local_35;
                            let _e3551 = local_36;
                            let _e3553 = ((_e3548.member_1 - _e3551) <= _e1184);
                            let _e3558 = local_37;
                            phi_6685_ = type_33(select(type_33().member, 1u, _e3553), select(type_33().member_1, _e3558, _e3553));
                            phi_6686_ = select(true, false, _e3553);
                        } else {
                            phi_6685_ = type_33();
                            phi_6686_ = true;
                        }
                        let _e3563 = phi_6685_;
                        let _e3565 = phi_6686_;
                        let _e3570 = local_38;
                        phi_6692_ = type_33(select(_e3563.member, 2u, _e3565), select(_e3563.member_1, _e3570, _e3565));
                        phi_6693_ = false;
                        phi_6694_ = false;
                        phi_6695_ = false;
                        phi_6696_ = false;
                    } else {
                        phi_6692_ = type_33();
                        let _e4073 = local_42;
                        phi_6693_ = _e4073;
                        let _e4076 = local_43;
                        phi_6694_ = _e4076;
                        let _e4079 = local_44;
                        phi_6695_ = _e4079;
                        let _e4082 = local_45;
                        phi_6696_ = _e4082;
                    }
                    let _e3574 = phi_6692_;
                    let _e3576 = phi_6693_;
                    let _e3578 = phi_6694_;
                    let _e3580 = phi_6695_;
                    let _e3582 = phi_6696_;
                    let _e3589 = select(_e3578, false, _e3576);
                    let _e3593 = local_39;
                    let _e3600 = select(select(_e3580, false, _e3576), false, _e3589);
                    let _e3606 = select(select(select(_e3582, false, _e3576), false, _e3589), false, _e3600);
                    let _e3610 = local_40;
                    let _e3614 = select(select(_e3589, true, _e3600), true, _e3606);
                    phi_6738_ = type_33(select(_e3574.member, select(select(select(type_33().member, 0u, _e3589), 0u, _e3600), 1u, _e3606), _e3614), select(_e3574.member_1, select(select(select(type_33().member_1, type_33().member_1, _e3589), type_33().member_1, _e3600), _e3610.member, _e3606), _e3614));
                    phi_6739_ = type_33(select(type_33().member, 0u, _e3576), select(type_33().member_1, type_33().member_1, _e3576));
                    phi_6740_ = select(select(select(select(select(_e3593, false, _e3576), false, _e3589), false, _e3600), false, _e3606), true, _e3614);
                }
                let _e3625 = phi_6738_;
                let _e3627 = phi_6739_;
                let _e3629 = phi_6740_;
                let _e3632 = select(_e3627.member, _e3625.member, _e3629);
                let _e3635 = select(_e3627.member_1, _e3625.member_1, _e3629);
                let _e3641 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e3635 > _e355)), (_e3632 == 1u))));
                switch bitcast<i32>(_e3632) {
                    case 0: {
                        phi_6784_ = type_31(0u, _e3641, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e3645 = function_3(_e3635);
                        phi_6784_ = type_31(0u, _e3641, _e3645, true);
                        break;
                    }
                    case 2: {
                        let _e3643 = function_3(_e3635);
                        phi_6784_ = type_31(1u, _e3641, _e3643, true);
                        break;
                    }
                    default: {
                        phi_6784_ = type_31();
                        break;
                    }
                }
                let _e3649 = phi_6784_;
                let _e3653 = params.member.member.member_12;
                let _e3654 = bitcast<u32>(_e3653);
                if (_e3649.member_2[0] == select((_e3654 << bitcast<u32>(29i)), 0u, ((_e3654 & 2147483647u) < 8388608u))) {
                    let _e3664 = params.member.member.member_12;
                    let _e3665 = bitcast<u32>(_e3664);
                    let _e3666 = (_e3665 & 2147483647u);
                    phi_6824_ = (_e3649.member_2[1] == select(((_e3665 ^ _e3666) | ((_e3666 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e3666 < 8388608u)));
                } else {
                    phi_6824_ = false;
                }
                let _e3676 = phi_6824_;
                let _e3678 = params.member.member.member_1;
                if ((_e3678 & 128u) != 0u) {
                    phi_6840_ = true;
                } else {
                    let _e3682 = params.member.member.member_1;
                    phi_6840_ = select(false, _e3676, ((_e3682 & 64u) != 0u));
                }
                let _e3687 = phi_6840_;
                local_8 = type_31(select(1u, _e3649.member, select(true, select(true, false, _e3687), _e3649.member_3)), _e3649.member_1, array<u32, 2>(_e3649.member_2[0], _e3649.member_2[1]), _e3649.member_3);
                phi_6867_ = type_9(_e184, _e187);
            } else {
                phi_6867_ = type_9(0u, 0u);
            }
            let _e3701 = phi_6867_;
            let _e3707 = local_8.member;
            let _e3709 = select(true, false, (_e3707 == 0u));
            let _e3711 = local_8.member_3;
            if _e3711 {
                if _e3709 {
                    phi_6896_ = true;
                } else {
                    let _e3713 = params.member.member.member_1;
                    phi_6896_ = ((_e3713 & 16u) != 0u);
                }
                let _e3717 = phi_6896_;
                phi_6897_ = _e3717;
            } else {
                phi_6897_ = false;
            }
            let _e3719 = phi_6897_;
            let _e3721 = local_8.member_3;
            if _e3721 {
                if _e3709 {
                } else {
                    let _e3723 = local_8.member_2;
                    let _e3727 = (_e3723[1] >> bitcast<u32>(20i));
                    let _e3741 = atomicMin((&earliest.member[0u]), select(((((_e3727 - 896u) << bitcast<u32>(23i)) | ((_e3723[1] & 1048575u) << bitcast<u32>(3i))) | (_e3723[0] >> bitcast<u32>(29i))), 0u, (_e3727 <= 896u)));
                }
            }
            if (_e103 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e3719 {
                let _e3745 = atomicAdd((&counters[0u]), 1u);
                phi_6940_ = _e3745;
            } else {
                phi_6940_ = 0u;
            }
            let _e3747 = phi_6940_;
            workgroupBarrier();
            if (_e103 == 0u) {
                let _e3750 = atomicLoad((&counters[0u]));
                if (_e3750 > 0u) {
                    let _e3753 = atomicAdd((&contacts.member[0u]), _e3750);
                    atomicStore((&counters[1u]), _e3753);
                }
            }
            workgroupBarrier();
            let _e3756 = atomicLoad((&counters[1u]));
            let _e3757 = (_e3756 + _e3747);
            if _e3719 {
                let _e3759 = params.member.member_1.member_3;
                if (_e3757 < _e3759) {
                    let _e3765 = (7u * _e3757);
                    atomicStore((&contacts.member[(4u + _e3765)]), select(1u, 0u, ((_e3701.member_1 & 2147483648u) == 0u)));
                    let _e3770 = local_8.member;
                    atomicStore((&contacts.member[(_e3765 + 5u)]), _e3770);
                    atomicStore((&contacts.member[(_e3765 + 6u)]), _e3701.member);
                    atomicStore((&contacts.member[(_e3765 + 7u)]), (_e3701.member_1 & 2147483647u));
                    let _e3779 = local_8.member_2[0u];
                    atomicStore((&contacts.member[(_e3765 + 8u)]), _e3779);
                    let _e3784 = local_8.member_2[1u];
                    atomicStore((&contacts.member[(_e3765 + 9u)]), _e3784);
                    let _e3788 = local_8.member_1;
                    atomicStore((&contacts.member[(_e3765 + 10u)]), _e3788);
                }
            }
        }
        continue;
        continuing {
            phi_835_ = type_9(select(_e155.member, (_e155.member + 1u), _e158), select(_e155.member_1, _e155.member_1, _e158));
            break if !(_e171);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
