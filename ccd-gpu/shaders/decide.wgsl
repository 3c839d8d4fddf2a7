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

struct type_18 {
    member: f32,
    member_1: f32,
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

struct type_29 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_30 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_31 {
    member: type_28,
    member_1: f32,
}

struct type_32 {
    member: u32,
    member_1: f32,
}

struct type_35 {
    member: array<f32, 4>,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_37 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_41 {
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
var<storage> paths: type_25;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_41;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_41;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_41;

fn function_(param: array<f32, 3>, param_1: array<f32, 3>) -> array<f32, 3> {
    let _e24 = ((((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])) < (((param[0] * param[0]) + (param[1] * param[1])) + (param[2] * param[2])));
    return array<f32, 3>(select(param[0], param_1[0], _e24), select(param[1], param_1[1], _e24), select(param[2], param_1[2], _e24));
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: u32) -> array<f32, 3> {
    var phi_669_: array<array<f32, 3>, 4>;

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
        phi_669_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e155)), (param_2[1] - (param_3[1] * _e155)), (param_2[2] - (param_3[2] * _e155))), array<f32, 3>((param_2[0] - (param_4[0] * _e195)), (param_2[1] - (param_4[1] * _e195)), (param_2[2] - (param_4[2] * _e195))), array<f32, 3>((_e9 - (param_4[0] * _e232)), (_e12 - (param_4[1] * _e232)), (_e15 - (param_4[2] * _e232))), array<f32, 3>((_e245 - (param_3[0] * _e275)), (_e248 - (param_3[1] * _e275)), (_e251 - (param_3[2] * _e275))));
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
        phi_669_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e74)), (param_2[1] - (param_3[1] * _e74)), (param_2[2] - (param_3[2] * _e74))), array<f32, 3>((param_2[0] - (param_4[0] * _e114)), (param_2[1] - (param_4[1] * _e114)), (param_2[2] - (param_4[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_669_;
    let _e291 = function_(_e288[0], _e288[1]);
    let _e293 = function_(_e291, _e288[2]);
    let _e295 = function_(_e293, _e288[3]);
    return _e295;
}

fn function_2(param_6: array<f32, 3>, param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: u32) -> array<f32, 3> {
    var phi_297_: bool;
    var phi_330_: array<f32, 3>;
    var phi_331_: bool;
    var phi_332_: array<f32, 3>;
    var phi_333_: bool;
    var phi_338_: array<f32, 3>;

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
        phi_297_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_297_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_297_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_330_ = array<f32, 3>((param_6[0] - ((param_7[0] * _e74) + (param_8[0] * _e78))), (param_6[1] - ((param_7[1] * _e74) + (param_8[1] * _e78))), (param_6[2] - ((param_7[2] * _e74) + (param_8[2] * _e78))));
            phi_331_ = false;
        } else {
            phi_330_ = array<f32, 3>();
            phi_331_ = true;
        }
        let _e129 = phi_330_;
        let _e131 = phi_331_;
        phi_332_ = _e129;
        phi_333_ = _e131;
    } else {
        phi_332_ = array<f32, 3>();
        phi_333_ = true;
    }
    let _e133 = phi_332_;
    let _e135 = phi_333_;
    if _e135 {
        let _e136 = function_1(param_6, param_7, param_8, param_9);
        phi_338_ = _e136;
    } else {
        phi_338_ = _e133;
    }
    let _e138 = phi_338_;
    return _e138;
}

fn function_3(param_10: f32) -> array<u32, 2> {
    let _e7 = bitcast<u32>(param_10);
    let _e8 = (_e7 & 2147483647u);
    let _e9 = (_e8 < 8388608u);
    return array<u32, 2>(select((_e7 << bitcast<u32>(29i)), 0u, _e9), select(((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e9));
}

fn function_4(param_11: ptr<function, type_35>, param_12: f32, param_13: f32, param_14: f32) -> bool {
    var phi_7092_: bool;
    var phi_7093_: bool;
    var phi_7098_: bool;

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
            phi_7092_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_7093_ = select(true, false, _e84);
        } else {
            phi_7092_ = bool();
            phi_7093_ = true;
        }
        let _e91 = phi_7092_;
        let _e93 = phi_7093_;
        phi_7098_ = select(_e91, false, _e93);
    } else {
        phi_7098_ = false;
    }
    let _e96 = phi_7098_;
    return _e96;
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_29;
    var local_1: type_29;
    var local_2: array<type_18, 4>;
    var local_3: array<f32, 4>;
    var local_4: array<f32, 2>;
    var local_5: type_35;
    var local_6: array<f32, 4>;
    var local_7: type_28;
    var phi_779_: u32;
    var phi_825_: u32;
    var phi_828_: type_9;
    var phi_996_: type_22;
    var phi_1131_: type_28;
    var phi_1399_: bool;
    var phi_1493_: type_31;
    var phi_1494_: bool;
    var phi_1495_: type_31;
    var phi_1496_: bool;
    var phi_1497_: type_31;
    var phi_1498_: bool;
    var phi_1503_: type_31;
    var phi_2228_: bool;
    var phi_2240_: f32;
    var phi_2311_: type_16;
    var phi_2314_: f32;
    var phi_2312_: type_16;
    var phi_2355_: type_17;
    var phi_2315_: f32;
    var local_8: f32;
    var phi_2368_: f32;
    var phi_2399_: type_9;
    var phi_2402_: u32;
    var phi_2469_: u32;
    var phi_2470_: u32;
    var phi_2403_: u32;
    var phi_2471_: u32;
    var phi_2527_: type_9;
    var phi_2683_: type_37;
    var phi_2684_: bool;
    var phi_2685_: type_37;
    var phi_2686_: bool;
    var phi_2717_: type_9;
    var phi_2720_: f32;
    var phi_2722_: f32;
    var phi_2724_: f32;
    var phi_2834_: bool;
    var phi_2841_: f32;
    var phi_2842_: bool;
    var phi_2721_: f32;
    var phi_2723_: f32;
    var phi_2725_: f32;
    var phi_2843_: f32;
    var phi_2844_: bool;
    var phi_2845_: bool;
    var local_9: bool;
    var local_10: f32;
    var local_11: f32;
    var phi_2850_: f32;
    var phi_2866_: type_9;
    var phi_2869_: f32;
    var phi_2934_: f32;
    var phi_2935_: bool;
    var phi_2936_: bool;
    var phi_2937_: bool;
    var phi_2938_: f32;
    var phi_2870_: f32;
    var phi_2939_: bool;
    var phi_2940_: bool;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: f32;
    var phi_2956_: f32;
    var phi_2958_: type_37;
    var phi_3795_: array<type_18, 4>;
    var phi_3815_: type_9;
    var phi_3818_: bool;
    var phi_3819_: bool;
    var phi_3870_: bool;
    var phi_3871_: bool;
    var local_17: bool;
    var local_18: bool;
    var phi_3885_: u32;
    var phi_3886_: u32;
    var phi_3887_: bool;
    var phi_3918_: bool;
    var phi_3919_: bool;
    var phi_3920_: bool;
    var phi_3921_: bool;
    var phi_3922_: bool;
    var phi_3923_: bool;
    var phi_3924_: bool;
    var phi_3925_: bool;
    var phi_3926_: bool;
    var phi_3927_: bool;
    var phi_3928_: bool;
    var phi_3929_: bool;
    var phi_3930_: type_37;
    var phi_3931_: bool;
    var phi_3932_: type_37;
    var phi_3933_: bool;
    var phi_3934_: bool;
    var phi_3935_: bool;
    var phi_3936_: bool;
    var phi_3937_: type_37;
    var phi_3938_: bool;
    var phi_3939_: type_37;
    var phi_3940_: bool;
    var phi_3941_: bool;
    var phi_3942_: bool;
    var phi_3943_: bool;
    var phi_3944_: bool;
    var phi_3952_: type_37;
    var phi_3953_: bool;
    var phi_3954_: type_37;
    var phi_3955_: bool;
    var phi_3956_: bool;
    var phi_3957_: bool;
    var phi_3958_: bool;
    var phi_3959_: bool;
    var phi_4382_: type_9;
    var phi_4385_: f32;
    var phi_4387_: f32;
    var phi_4389_: f32;
    var phi_4391_: f32;
    var phi_4393_: bool;
    var phi_4395_: u32;
    var phi_4546_: array<f32, 3>;
    var phi_4612_: type_16;
    var phi_4615_: f32;
    var phi_4613_: type_16;
    var phi_4656_: type_17;
    var phi_4616_: f32;
    var local_19: f32;
    var phi_4669_: f32;
    var phi_4792_: type_29;
    var phi_4793_: bool;
    var phi_4794_: type_29;
    var phi_4795_: bool;
    var phi_4803_: type_29;
    var phi_4974_: bool;
    var phi_4975_: bool;
    var phi_4976_: bool;
    var phi_4977_: bool;
    var phi_4978_: bool;
    var phi_4979_: bool;
    var phi_5280_: bool;
    var phi_5281_: bool;
    var phi_5282_: bool;
    var phi_5283_: bool;
    var phi_5284_: bool;
    var phi_5285_: bool;
    var phi_5293_: bool;
    var phi_5400_: f32;
    var phi_5401_: bool;
    var phi_5402_: f32;
    var phi_5403_: bool;
    var phi_5404_: f32;
    var phi_5405_: bool;
    var phi_5406_: bool;
    var phi_5468_: f32;
    var phi_5469_: bool;
    var phi_5470_: f32;
    var phi_5471_: bool;
    var phi_5472_: f32;
    var phi_5473_: bool;
    var phi_5474_: bool;
    var phi_5541_: f32;
    var phi_5542_: bool;
    var phi_5543_: f32;
    var phi_5544_: bool;
    var phi_5545_: f32;
    var phi_5546_: bool;
    var phi_5547_: bool;
    var phi_5609_: f32;
    var phi_5610_: bool;
    var phi_5611_: f32;
    var phi_5612_: bool;
    var phi_5613_: f32;
    var phi_5614_: bool;
    var phi_5615_: bool;
    var phi_6144_: f32;
    var phi_6145_: f32;
    var phi_6146_: bool;
    var phi_6148_: f32;
    var phi_6149_: f32;
    var phi_6150_: f32;
    var phi_6152_: bool;
    var phi_6153_: bool;
    var phi_6155_: bool;
    var phi_6156_: f32;
    var phi_6157_: f32;
    var phi_6158_: f32;
    var phi_6160_: bool;
    var phi_6161_: bool;
    var phi_6162_: bool;
    var phi_6164_: bool;
    var phi_6165_: f32;
    var phi_6166_: f32;
    var phi_6167_: f32;
    var phi_6169_: bool;
    var phi_6170_: bool;
    var phi_6171_: bool;
    var phi_6173_: bool;
    var phi_6506_: f32;
    var phi_6508_: u32;
    var phi_6509_: f32;
    var phi_6510_: bool;
    var phi_6511_: bool;
    var phi_6512_: bool;
    var phi_6513_: u32;
    var phi_6514_: f32;
    var phi_6515_: f32;
    var phi_6516_: f32;
    var phi_6517_: f32;
    var phi_6518_: bool;
    var phi_6519_: u32;
    var phi_6520_: bool;
    var phi_6521_: bool;
    var phi_6522_: bool;
    var phi_6523_: bool;
    var phi_6525_: bool;
    var phi_6553_: f32;
    var phi_6554_: f32;
    var phi_6555_: f32;
    var phi_6556_: f32;
    var phi_6557_: bool;
    var phi_6558_: u32;
    var phi_6559_: bool;
    var phi_6560_: bool;
    var phi_6561_: bool;
    var phi_6562_: bool;
    var phi_6564_: bool;
    var phi_4386_: f32;
    var phi_4388_: f32;
    var phi_4390_: f32;
    var phi_4392_: f32;
    var phi_4394_: bool;
    var phi_4396_: u32;
    var phi_6565_: f32;
    var phi_6567_: bool;
    var phi_6568_: bool;
    var phi_6569_: bool;
    var phi_6570_: bool;
    var phi_6572_: bool;
    var phi_6573_: bool;
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
    var phi_6641_: f32;
    var phi_6642_: bool;
    var phi_6643_: bool;
    var phi_6644_: bool;
    var phi_6645_: bool;
    var phi_6646_: bool;
    var phi_6647_: type_37;
    var phi_6648_: bool;
    var phi_6649_: f32;
    var phi_6650_: type_37;
    var phi_6651_: bool;
    var phi_6652_: bool;
    var phi_6653_: bool;
    var phi_6654_: bool;
    var phi_6655_: bool;
    var phi_6656_: bool;
    var local_32: bool;
    var local_33: bool;
    var local_34: type_37;
    var local_35: f32;
    var local_36: f32;
    var phi_6672_: type_32;
    var phi_6673_: bool;
    var local_37: f32;
    var phi_6679_: type_32;
    var phi_6680_: bool;
    var phi_6681_: bool;
    var phi_6682_: bool;
    var phi_6683_: bool;
    var local_38: bool;
    var local_39: type_37;
    var phi_6725_: type_32;
    var phi_6726_: type_32;
    var phi_6727_: bool;
    var phi_6771_: type_30;
    var phi_6811_: bool;
    var phi_6827_: bool;
    var phi_6846_: type_30;
    var phi_6847_: type_30;
    var phi_6848_: type_9;
    var phi_6878_: u32;
    var phi_6900_: u32;
    var phi_6966_: u32;
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
        phi_779_ = (_e126 - _e131);
    } else {
        phi_779_ = 0u;
    }
    let _e134 = phi_779_;
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
        phi_825_ = select(_e148, (_e148 + 1u), ((_e146 % _e119) > 0u));
    } else {
        phi_825_ = 0u;
    }
    let _e155 = phi_825_;
    phi_828_ = type_9(0u, _e155);
    loop {
        let _e158 = phi_828_;
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
                    phi_6846_ = type_30(1u, 0u, array<u32, 2>(0u, 0u), true);
                } else {
                    let _e196 = params.member.member_2.member;
                    if (_e196 == 0u) {
                        let _e213 = (3u * _e190);
                        let _e215 = elements.member[_e213];
                        let _e218 = elements.member[(_e213 + 1u)];
                        let _e221 = elements.member[(_e213 + 2u)];
                        phi_996_ = type_22(0u, array<u32, 4>(_e191, _e215, _e218, _e221));
                    } else {
                        let _e199 = (2u * _e191);
                        let _e200 = (2u * _e190);
                        let _e202 = elements.member[_e199];
                        let _e204 = elements.member[_e200];
                        let _e207 = elements.member[(_e199 + 1u)];
                        let _e210 = elements.member[(_e200 + 1u)];
                        phi_996_ = type_22(1u, array<u32, 4>(_e202, _e207, _e204, _e210));
                    }
                    let _e225 = phi_996_;
                    let _e230 = paths.member[_e225.member_1[0]];
                    let _e245 = paths.member[_e225.member_1[1]];
                    let _e260 = paths.member[_e225.member_1[2]];
                    let _e275 = paths.member[_e225.member_1[3]];
                    let _e289 = params.member.member.member_4;
                    if (_e225.member != 0u) {
                        phi_1131_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e260.member.x - _e230.member.x), (_e260.member.y - _e230.member.y), (_e260.member.z - _e230.member.z)), array<f32, 3>((_e260.member_1.x - _e230.member_1.x), (_e260.member_1.y - _e230.member_1.y), (_e260.member_1.z - _e230.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e245.member.x - _e230.member.x), (_e245.member.y - _e230.member.y), (_e245.member.z - _e230.member.z)), array<f32, 3>((_e245.member_1.x - _e230.member_1.x), (_e245.member_1.y - _e230.member_1.y), (_e245.member_1.z - _e230.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e260.member.x - _e275.member.x), (_e260.member.y - _e275.member.y), (_e260.member.z - _e275.member.z)), array<f32, 3>((_e260.member_1.x - _e275.member_1.x), (_e260.member_1.y - _e275.member_1.y), (_e260.member_1.z - _e275.member_1.z))), (_e289 + _e289));
                    } else {
                        phi_1131_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e230.member.x - _e245.member.x), (_e230.member.y - _e245.member.y), (_e230.member.z - _e245.member.z)), array<f32, 3>((_e230.member_1.x - _e245.member_1.x), (_e230.member_1.y - _e245.member_1.y), (_e230.member_1.z - _e245.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e260.member.x - _e245.member.x), (_e260.member.y - _e245.member.y), (_e260.member.z - _e245.member.z)), array<f32, 3>((_e260.member_1.x - _e245.member_1.x), (_e260.member_1.y - _e245.member_1.y), (_e260.member_1.z - _e245.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e275.member.x - _e245.member.x), (_e275.member.y - _e245.member.y), (_e275.member.z - _e245.member.z)), array<f32, 3>((_e275.member_1.x - _e245.member_1.x), (_e275.member_1.y - _e245.member_1.y), (_e275.member_1.z - _e245.member_1.z))), (_e289 + _e289));
                    }
                    let _e350 = phi_1131_;
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
                    if (_e482 <= 65536f) {
                        phi_1399_ = (_e482 >= (1f / 65536f));
                    } else {
                        phi_1399_ = false;
                    }
                    let _e487 = phi_1399_;
                    if _e487 {
                        phi_1497_ = type_31();
                        phi_1498_ = true;
                    } else {
                        if (_e482 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e482) & 2139095040u) != 2139095040u) {
                                let _e494 = (2130706432u - (bitcast<u32>(_e482) & 2139095040u));
                                let _e497 = bitcast<f32>(select(8388608u, _e494, (_e494 > 8388608u)));
                                phi_1493_ = type_31(type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e350.member[0][0] * _e497), (_e350.member[0][1] * _e497), (_e350.member[0][2] * _e497)), array<f32, 3>((_e350.member[1][0] * _e497), (_e350.member[1][1] * _e497), (_e350.member[1][2] * _e497))), array<array<f32, 3>, 2>(array<f32, 3>((_e350.member_1[0][0] * _e497), (_e350.member_1[0][1] * _e497), (_e350.member_1[0][2] * _e497)), array<f32, 3>((_e350.member_1[1][0] * _e497), (_e350.member_1[1][1] * _e497), (_e350.member_1[1][2] * _e497))), array<array<f32, 3>, 2>(array<f32, 3>((_e350.member_2[0][0] * _e497), (_e350.member_2[0][1] * _e497), (_e350.member_2[0][2] * _e497)), array<f32, 3>((_e350.member_2[1][0] * _e497), (_e350.member_2[1][1] * _e497), (_e350.member_2[1][2] * _e497))), ((_e350.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e497)), (0f * _e497));
                                phi_1494_ = false;
                            } else {
                                phi_1493_ = type_31();
                                phi_1494_ = true;
                            }
                            let _e563 = phi_1493_;
                            let _e565 = phi_1494_;
                            phi_1495_ = _e563;
                            phi_1496_ = _e565;
                        } else {
                            phi_1495_ = type_31();
                            phi_1496_ = true;
                        }
                        let _e567 = phi_1495_;
                        let _e569 = phi_1496_;
                        phi_1497_ = _e567;
                        phi_1498_ = _e569;
                    }
                    let _e571 = phi_1497_;
                    let _e573 = phi_1498_;
                    if _e573 {
                        phi_1503_ = type_31(_e350, 0f);
                    } else {
                        phi_1503_ = _e571;
                    }
                    let _e576 = phi_1503_;
                    local_7 = type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e576.member.member[0][0], _e576.member.member[0][1], _e576.member.member[0][2]), array<f32, 3>(_e576.member.member[1][0], _e576.member.member[1][1], _e576.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e576.member.member_1[0][0], _e576.member.member_1[0][1], _e576.member.member_1[0][2]), array<f32, 3>(_e576.member.member_1[1][0], _e576.member.member_1[1][1], _e576.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e576.member.member_2[0][0], _e576.member.member_2[0][1], _e576.member.member_2[0][2]), array<f32, 3>(_e576.member.member_2[1][0], _e576.member.member_2[1][1], _e576.member.member_2[1][2])), _e576.member.member_3);
                    let _e618 = local_7.member_1[0u];
                    let _e624 = local_7.member_2[0u];
                    let _e630 = ((_e618[1] * _e624[2]) - (_e618[2] * _e624[1]));
                    let _e633 = ((_e618[2] * _e624[0]) - (_e618[0] * _e624[2]));
                    let _e636 = ((_e618[0] * _e624[1]) - (_e618[1] * _e624[0]));
                    let _e639 = local_7.member_1[1u];
                    let _e645 = local_7.member_2[1u];
                    let _e651 = ((_e639[1] * _e645[2]) - (_e639[2] * _e645[1]));
                    let _e654 = ((_e639[2] * _e645[0]) - (_e639[0] * _e645[2]));
                    let _e657 = ((_e639[0] * _e645[1]) - (_e639[1] * _e645[0]));
                    let _e660 = local_7.member_1[0u];
                    let _e666 = local_7.member_2[1u];
                    let _e681 = local_7.member_1[1u];
                    let _e687 = local_7.member_2[0u];
                    let _e700 = (((_e660[1] * _e666[2]) - (_e660[2] * _e666[1])) + ((_e681[1] * _e687[2]) - (_e681[2] * _e687[1])));
                    let _e701 = (((_e660[2] * _e666[0]) - (_e660[0] * _e666[2])) + ((_e681[2] * _e687[0]) - (_e681[0] * _e687[2])));
                    let _e702 = (((_e660[0] * _e666[1]) - (_e660[1] * _e666[0])) + ((_e681[0] * _e687[1]) - (_e681[1] * _e687[0])));
                    let _e705 = local_7.member[0u];
                    let _e713 = (((_e705[0] * _e630) + (_e705[1] * _e633)) + (_e705[2] * _e636));
                    let _e716 = local_7.member[1u];
                    let _e727 = local_7.member[0u];
                    let _e736 = ((((_e716[0] * _e630) + (_e716[1] * _e633)) + (_e716[2] * _e636)) + (((_e727[0] * _e700) + (_e727[1] * _e701)) + (_e727[2] * _e702)));
                    let _e739 = local_7.member[0u];
                    let _e750 = local_7.member[1u];
                    let _e759 = ((((_e739[0] * _e651) + (_e739[1] * _e654)) + (_e739[2] * _e657)) + (((_e750[0] * _e700) + (_e750[1] * _e701)) + (_e750[2] * _e702)));
                    let _e762 = local_7.member[1u];
                    let _e770 = (((_e762[0] * _e651) + (_e762[1] * _e654)) + (_e762[2] * _e657));
                    let _e773 = local_7.member[0u];
                    let _e779 = select(_e773[0], -(_e773[0]), (_e773[0] < 0f));
                    let _e782 = select(_e773[1], -(_e773[1]), (_e773[1] < 0f));
                    let _e784 = select(_e782, _e779, (_e779 > _e782));
                    let _e787 = select(_e773[2], -(_e773[2]), (_e773[2] < 0f));
                    let _e789 = select(_e787, _e784, (_e784 > _e787));
                    let _e792 = local_7.member[1u];
                    let _e798 = select(_e792[0], -(_e792[0]), (_e792[0] < 0f));
                    let _e801 = select(_e792[1], -(_e792[1]), (_e792[1] < 0f));
                    let _e803 = select(_e801, _e798, (_e798 > _e801));
                    let _e806 = select(_e792[2], -(_e792[2]), (_e792[2] < 0f));
                    let _e808 = select(_e806, _e803, (_e803 > _e806));
                    let _e812 = local_7.member_3;
                    let _e813 = (select(_e808, _e789, (_e789 > _e808)) + _e812);
                    let _e816 = local_7.member_1[0u];
                    let _e822 = select(_e816[0], -(_e816[0]), (_e816[0] < 0f));
                    let _e825 = select(_e816[1], -(_e816[1]), (_e816[1] < 0f));
                    let _e827 = select(_e825, _e822, (_e822 > _e825));
                    let _e830 = select(_e816[2], -(_e816[2]), (_e816[2] < 0f));
                    let _e832 = select(_e830, _e827, (_e827 > _e830));
                    let _e835 = local_7.member_1[1u];
                    let _e841 = select(_e835[0], -(_e835[0]), (_e835[0] < 0f));
                    let _e844 = select(_e835[1], -(_e835[1]), (_e835[1] < 0f));
                    let _e846 = select(_e844, _e841, (_e841 > _e844));
                    let _e849 = select(_e835[2], -(_e835[2]), (_e835[2] < 0f));
                    let _e851 = select(_e849, _e846, (_e846 > _e849));
                    let _e855 = local_7.member_3;
                    let _e856 = (select(_e851, _e832, (_e832 > _e851)) + _e855);
                    let _e859 = local_7.member_2[0u];
                    let _e865 = select(_e859[0], -(_e859[0]), (_e859[0] < 0f));
                    let _e868 = select(_e859[1], -(_e859[1]), (_e859[1] < 0f));
                    let _e870 = select(_e868, _e865, (_e865 > _e868));
                    let _e873 = select(_e859[2], -(_e859[2]), (_e859[2] < 0f));
                    let _e875 = select(_e873, _e870, (_e870 > _e873));
                    let _e878 = local_7.member_2[1u];
                    let _e884 = select(_e878[0], -(_e878[0]), (_e878[0] < 0f));
                    let _e887 = select(_e878[1], -(_e878[1]), (_e878[1] < 0f));
                    let _e889 = select(_e887, _e884, (_e884 > _e887));
                    let _e892 = select(_e878[2], -(_e878[2]), (_e878[2] < 0f));
                    let _e894 = select(_e892, _e889, (_e889 > _e892));
                    let _e898 = local_7.member_3;
                    let _e899 = (select(_e894, _e875, (_e875 > _e894)) + _e898);
                    let _e901 = ((_e856 * 8f) * _e899);
                    let _e908 = local_7.member_3;
                    let _e932 = ((select(_e630, -(_e630), (_e630 < 0f)) + select(_e633, -(_e633), (_e633 < 0f))) + select(_e636, -(_e636), (_e636 < 0f)));
                    let _e943 = ((select(_e651, -(_e651), (_e651 < 0f)) + select(_e654, -(_e654), (_e654 < 0f))) + select(_e657, -(_e657), (_e657 < 0f)));
                    let _e945 = select(_e943, _e932, (_e932 > _e943));
                    let _e957 = (((select(_e700, -(_e700), (_e700 < 0f)) + select(_e701, -(_e701), (_e701 < 0f))) + select(_e702, -(_e702), (_e702 < 0f))) * 0.5f);
                    let _e964 = local_7.member_3;
                    let _e976 = (((((_e813 * 8f) * _e901) * (0.000000059604645f * (524f / 64f))) + ((_e908 * 19f) * ((_e813 * (_e856 + _e899)) + (_e856 * _e899)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e813) * ((1f + _e856) * (1f + _e899)))));
                    let _e977 = (_e713 * 3f);
                    let _e978 = (_e770 * 3f);
                    let _e980 = select(_e978, _e977, (_e977 < _e978));
                    let _e982 = select(_e759, _e736, (_e736 < _e759));
                    let _e984 = select(_e982, _e980, (_e980 < _e982));
                    let _e986 = select(_e978, _e977, (_e977 > _e978));
                    let _e988 = select(_e759, _e736, (_e736 > _e759));
                    let _e995 = -(select(_e988, _e986, (_e986 > _e988)));
                    if ((select(_e995, _e984, (_e984 > _e995)) - (_e976 + ((0f * (((select(_e957, _e945, (_e945 > _e957)) + (_e901 * (0.000000059604645f * 8f))) + ((_e964 * 6f) * (_e856 + _e899))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e856) * (1f + _e899))))) * (3f * 1.0001f)))) > 0f) {
                        phi_6725_ = type_32(0u, type_32().member_1);
                        phi_6726_ = type_32();
                        phi_6727_ = true;
                    } else {
                        let _e1003 = select(_e713, -(_e713), (_e713 < 0f));
                        let _e1006 = select(_e736, -(_e736), (_e736 < 0f));
                        let _e1008 = select(_e1006, _e1003, (_e1003 > _e1006));
                        let _e1011 = select(_e759, -(_e759), (_e759 < 0f));
                        let _e1014 = select(_e770, -(_e770), (_e770 < 0f));
                        let _e1016 = select(_e1014, _e1011, (_e1011 > _e1014));
                        let _e1018 = select(_e1016, _e1008, (_e1008 > _e1016));
                        let _e1019 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e1018 >= _e1019) {
                            phi_2228_ = (_e1018 <= (1f / _e1019));
                        } else {
                            phi_2228_ = false;
                        }
                        let _e1024 = phi_2228_;
                        if _e1024 {
                            phi_2240_ = (1f / _e1018);
                        } else {
                            phi_2240_ = 0f;
                        }
                        let _e1031 = phi_2240_;
                        let _e1032 = (_e352 * 0.0625f);
                        local_5 = type_35(array<f32, 4>(_e713, _e736, _e759, _e770), ((_e976 * 0.34f) + (_e1018 * select(2f, (0.000000059604645f * 256f), _e1024))), _e1031, select(_e1032, 0.00000000000022737368f, (0.00000000000022737368f < _e1032)));
                        let _e1039 = local_5.member[0u];
                        let _e1042 = local_5.member[1u];
                        let _e1045 = local_5.member[2u];
                        let _e1048 = local_5.member[3u];
                        let _e1055 = local_5.member_2;
                        let _e1056 = ((_e1042 - (3f * _e1039)) * _e1055);
                        let _e1058 = local_5.member_2;
                        let _e1059 = ((_e1045 - _e1042) * _e1058);
                        let _e1061 = local_5.member_2;
                        let _e1062 = (((3f * _e1048) - _e1045) * _e1061);
                        local_3[0u] = 0f;
                        local_3[1u] = 1f;
                        local_3[2u] = 1f;
                        local_3[3u] = 1f;
                        let _e1069 = ((_e1059 * _e1059) - (_e1056 * _e1062));
                        if (_e1069 > 0f) {
                            if (_e1069 <= 0.000000000000000000000000000000000000011754944f) {
                                phi_2368_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1069 > 0f));
                            } else {
                                phi_2311_ = type_16(0i, 5i);
                                phi_2314_ = bitcast<f32>(((bitcast<u32>(_e1069) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e1078 = phi_2311_;
                                    let _e1080 = phi_2314_;
                                    local_8 = _e1080;
                                    if (_e1078.member < _e1078.member_1) {
                                        let _e1087 = (_e1078.member + 1i);
                                        phi_2312_ = type_16(select(_e1087, type_17().member_1, select(false, true, ((false == (_e1087 > _e1078.member)) != false))), _e1078.member_1);
                                        phi_2355_ = type_17(1u, _e1078.member);
                                    } else {
                                        phi_2312_ = _e1078;
                                        phi_2355_ = type_17(0u, type_17().member_1);
                                    }
                                    let _e1098 = phi_2312_;
                                    let _e1100 = phi_2355_;
                                    let _e1103 = (bitcast<i32>(_e1100.member) != 0i);
                                    if _e1103 {
                                        phi_2315_ = (0.5f * (_e1080 + (_e1069 / _e1080)));
                                    } else {
                                        phi_2315_ = f32();
                                    }
                                    let _e1108 = phi_2315_;
                                    continue;
                                    continuing {
                                        phi_2311_ = _e1098;
                                        phi_2314_ = _e1108;
                                        break if !(_e1103);
                                    }
                                }
                                let _e1113 = local_8;
                                phi_2368_ = (_e1113 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1119 = phi_2368_;
                            let _e1124 = -((_e1059 + select(_e1119, -(_e1119), (_e1059 < 0f))));
                            local_4[0u] = (_e1124 / (_e1124 + _e1062));
                            local_4[1u] = (_e1056 / (_e1056 + _e1124));
                            let _e1133 = local_4[1u];
                            let _e1134 = local_4[0u];
                            if (_e1133 < _e1134) {
                                let _e1137 = local_4[1u];
                                let _e1139 = local_4[0u];
                                local_4[0u] = _e1137;
                                local_4[1u] = _e1139;
                            }
                            phi_2399_ = type_9(0u, 2u);
                            phi_2402_ = 1u;
                            loop {
                                let _e1143 = phi_2399_;
                                let _e1145 = phi_2402_;
                                local_40 = _e1145;
                                let _e1148 = (_e1143.member < _e1143.member_1);
                                let _e1159 = select(type_9().member_1, _e1143.member, _e1148);
                                let _e1161 = (bitcast<i32>(select(0u, 1u, _e1148)) != 0i);
                                if _e1161 {
                                    let _e1163 = local_4[_e1159];
                                    if (_e1163 > 0f) {
                                        let _e1166 = local_4[_e1159];
                                        if (_e1166 < 1f) {
                                            let _e1169 = local_4[_e1159];
                                            local_3[_e1145] = _e1169;
                                            phi_2469_ = (_e1145 + 1u);
                                        } else {
                                            phi_2469_ = _e1145;
                                        }
                                        let _e1173 = phi_2469_;
                                        phi_2470_ = _e1173;
                                    } else {
                                        phi_2470_ = _e1145;
                                    }
                                    let _e1175 = phi_2470_;
                                    phi_2403_ = _e1175;
                                } else {
                                    phi_2403_ = u32();
                                }
                                let _e1177 = phi_2403_;
                                continue;
                                continuing {
                                    phi_2399_ = type_9(select(_e1143.member, (_e1143.member + 1u), _e1148), select(_e1143.member_1, _e1143.member_1, _e1148));
                                    phi_2402_ = _e1177;
                                    break if !(_e1161);
                                }
                            }
                            let _e3832 = local_40;
                            phi_2471_ = _e3832;
                        } else {
                            phi_2471_ = 1u;
                        }
                        let _e1180 = phi_2471_;
                        local_3[_e1180] = 1f;
                        let _e1182 = local_3;
                        local_6 = _e1182;
                        let _e1183 = (_e352 * 0.99f);
                        let _e1184 = (1f - _e354);
                        let _e1187 = local_5.member[0u];
                        let _e1190 = local_5.member[1u];
                        let _e1193 = local_5.member[2u];
                        let _e1196 = local_5.member[3u];
                        let _e1207 = ((((_e1187 * _e1184) + (_e1190 * _e354)) * (_e1184 * _e1184)) + (((_e1193 * _e1184) + (_e1196 * _e354)) * (_e354 * _e354)));
                        let _e1212 = local_5.member_1;
                        phi_2527_ = type_9(select(1u, 0u, !((select(_e1207, -(_e1207), (_e1207 < 0f)) > _e1212))), (_e1180 + 1u));
                        loop {
                            let _e1219 = phi_2527_;
                            let _e1222 = (_e1219.member < _e1219.member_1);
                            let _e1233 = select(type_9().member_1, _e1219.member, _e1222);
                            if (bitcast<i32>(select(0u, 1u, _e1222)) != 0i) {
                                if (_e1233 > 0u) {
                                    let _e1240 = local_6[(_e1233 - 1u)];
                                    let _e1242 = select(_e354, _e1240, (_e1240 > _e354));
                                    let _e1244 = local_6[_e1233];
                                    let _e1246 = select(_e356, _e1244, (_e1244 < _e356));
                                    if (_e1242 <= _e1246) {
                                        let _e1248 = function_4((&local_5), _e358, _e1242, _e1246);
                                        if _e1248 {
                                            phi_3930_ = type_37();
                                            phi_3931_ = bool();
                                            phi_3932_ = type_37();
                                            phi_3933_ = false;
                                            phi_3934_ = false;
                                            phi_3935_ = false;
                                            phi_3936_ = false;
                                        } else {
                                            let _e1249 = (1f - _e1242);
                                            let _e1252 = local_5.member[0u];
                                            let _e1255 = local_5.member[1u];
                                            let _e1258 = local_5.member[2u];
                                            let _e1261 = local_5.member[3u];
                                            let _e1272 = ((((_e1252 * _e1249) + (_e1255 * _e1242)) * (_e1249 * _e1249)) + (((_e1258 * _e1249) + (_e1261 * _e1242)) * (_e1242 * _e1242)));
                                            let _e1273 = (1f - _e1246);
                                            let _e1276 = local_5.member[0u];
                                            let _e1279 = local_5.member[1u];
                                            let _e1282 = local_5.member[2u];
                                            let _e1285 = local_5.member[3u];
                                            let _e1296 = ((((_e1276 * _e1273) + (_e1279 * _e1246)) * (_e1273 * _e1273)) + (((_e1282 * _e1273) + (_e1285 * _e1246)) * (_e1246 * _e1246)));
                                            let _e1301 = local_5.member_1;
                                            let _e1302 = (select(_e1272, -(_e1272), (_e1272 < 0f)) > _e1301);
                                            let _e1307 = local_5.member_1;
                                            let _e1308 = (select(_e1296, -(_e1296), (_e1296 < 0f)) > _e1307);
                                            let _e1316 = select(select(bool(), select(bool(), ((_e1272 > 0f) != (_e1296 > 0f)), _e1308), _e1302), false, select(true, select(true, false, _e1308), _e1302));
                                            if _e1302 {
                                                if _e1308 {
                                                    phi_2683_ = type_37(select(1f, type_37().member, _e1316), select(0f, type_37().member_1, _e1316), select(_e1316, type_37().member_2, _e1316));
                                                    phi_2684_ = _e1316;
                                                } else {
                                                    phi_2683_ = type_37();
                                                    phi_2684_ = true;
                                                }
                                                let _e1325 = phi_2683_;
                                                let _e1327 = phi_2684_;
                                                phi_2685_ = _e1325;
                                                phi_2686_ = _e1327;
                                            } else {
                                                phi_2685_ = type_37();
                                                phi_2686_ = true;
                                            }
                                            let _e1329 = phi_2685_;
                                            let _e1331 = phi_2686_;
                                            if _e1331 {
                                                if _e1302 {
                                                    let _e1333 = select(1f, -1f, (_e1272 < 0f));
                                                    let _e1335 = local_5.member_3;
                                                    let _e1338 = local_5.member[0u];
                                                    let _e1341 = local_5.member[1u];
                                                    let _e1344 = local_5.member[2u];
                                                    let _e1347 = local_5.member[3u];
                                                    let _e1350 = (_e1344 - _e1341);
                                                    phi_2717_ = type_9(0u, 64u);
                                                    phi_2720_ = _e1246;
                                                    phi_2722_ = _e1242;
                                                    phi_2724_ = (0.5f * (_e1242 + _e1246));
                                                    loop {
                                                        let _e1356 = phi_2717_;
                                                        let _e1358 = phi_2720_;
                                                        let _e1360 = phi_2722_;
                                                        let _e1362 = phi_2724_;
                                                        local_11 = _e1360;
                                                        let _e1365 = (_e1356.member < _e1356.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e1365)) != 0i) {
                                                            let _e1377 = (1f - _e1362);
                                                            let _e1380 = local_5.member[0u];
                                                            let _e1383 = local_5.member[1u];
                                                            let _e1386 = local_5.member[2u];
                                                            let _e1389 = local_5.member[3u];
                                                            let _e1403 = local_5.member_1;
                                                            let _e1404 = ((_e1333 * ((((_e1380 * _e1377) + (_e1383 * _e1362)) * (_e1377 * _e1377)) + (((_e1386 * _e1377) + (_e1389 * _e1362)) * (_e1362 * _e1362)))) - _e1403);
                                                            let _e1405 = (_e1404 > 0f);
                                                            let _e1406 = select(_e1362, _e1358, _e1405);
                                                            let _e1407 = select(_e1360, _e1362, _e1405);
                                                            let _e1409 = ((_e1406 - _e1407) > _e1335);
                                                            if _e1409 {
                                                                let _e1410 = (1f - _e1362);
                                                                let _e1422 = (-(_e1404) / (_e1333 * (((((_e1341 - (3f * _e1338)) * _e1410) + (_e1350 * _e1362)) * _e1410) + (((_e1350 * _e1410) + (((3f * _e1347) - _e1344) * _e1362)) * _e1362))));
                                                                let _e1429 = ((_e1362 + _e1422) + select(-((0.5f * _e1335)), (0.5f * _e1335), (_e1404 > 0f)));
                                                                if (_e1429 > _e1407) {
                                                                    phi_2834_ = select(true, select(true, false, (select(_e1422, -(_e1422), (_e1422 < 0f)) < (0.5f * (_e1406 - _e1407)))), (_e1429 < _e1406));
                                                                } else {
                                                                    phi_2834_ = true;
                                                                }
                                                                let _e1441 = phi_2834_;
                                                                phi_2841_ = select(_e1429, (0.5f * (_e1407 + _e1406)), _e1441);
                                                                phi_2842_ = false;
                                                            } else {
                                                                phi_2841_ = f32();
                                                                phi_2842_ = true;
                                                            }
                                                            let _e1446 = phi_2841_;
                                                            let _e1448 = phi_2842_;
                                                            phi_2721_ = _e1406;
                                                            phi_2723_ = _e1407;
                                                            phi_2725_ = _e1446;
                                                            phi_2843_ = _e1407;
                                                            phi_2844_ = _e1409;
                                                            phi_2845_ = _e1448;
                                                        } else {
                                                            phi_2721_ = f32();
                                                            phi_2723_ = f32();
                                                            phi_2725_ = f32();
                                                            phi_2843_ = f32();
                                                            phi_2844_ = false;
                                                            phi_2845_ = false;
                                                        }
                                                        let _e1450 = phi_2721_;
                                                        let _e1452 = phi_2723_;
                                                        let _e1454 = phi_2725_;
                                                        let _e1456 = phi_2843_;
                                                        let _e1458 = phi_2844_;
                                                        let _e1460 = phi_2845_;
                                                        local_9 = _e1460;
                                                        local_10 = _e1456;
                                                        continue;
                                                        continuing {
                                                            phi_2717_ = type_9(select(_e1356.member, (_e1356.member + 1u), _e1365), select(_e1356.member_1, _e1356.member_1, _e1365));
                                                            phi_2720_ = _e1450;
                                                            phi_2722_ = _e1452;
                                                            phi_2724_ = _e1454;
                                                            break if !(_e1458);
                                                        }
                                                    }
                                                    let _e1463 = local_9;
                                                    let _e1465 = local_10;
                                                    let _e1467 = local_11;
                                                    phi_2850_ = select(_e1467, _e1465, _e1463);
                                                } else {
                                                    phi_2850_ = _e1242;
                                                }
                                                let _e1470 = phi_2850_;
                                                if _e1308 {
                                                    let _e1474 = local_5.member_3;
                                                    let _e1476 = local_5.member_3;
                                                    phi_2866_ = type_9(0u, 64u);
                                                    phi_2869_ = (_e1474 + _e1476);
                                                    loop {
                                                        let _e1479 = phi_2866_;
                                                        let _e1481 = phi_2869_;
                                                        let _e1484 = (_e1479.member < _e1479.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e1484)) != 0i) {
                                                            let _e1496 = (_e1470 + _e1481);
                                                            if (_e1496 < _e1246) {
                                                                let _e1498 = (1f - _e1496);
                                                                let _e1501 = local_5.member[0u];
                                                                let _e1504 = local_5.member[1u];
                                                                let _e1507 = local_5.member[2u];
                                                                let _e1510 = local_5.member[3u];
                                                                let _e1524 = local_5.member_1;
                                                                let _e1525 = ((select(1f, -1f, (_e1296 < 0f)) * ((((_e1501 * _e1498) + (_e1504 * _e1496)) * (_e1498 * _e1498)) + (((_e1507 * _e1498) + (_e1510 * _e1496)) * (_e1496 * _e1496)))) > _e1524);
                                                                phi_2934_ = select((_e1481 + _e1481), f32(), _e1525);
                                                                phi_2935_ = select(true, false, _e1525);
                                                                phi_2936_ = _e1525;
                                                                phi_2937_ = false;
                                                            } else {
                                                                phi_2934_ = f32();
                                                                phi_2935_ = false;
                                                                phi_2936_ = false;
                                                                phi_2937_ = true;
                                                            }
                                                            let _e1530 = phi_2934_;
                                                            let _e1532 = phi_2935_;
                                                            let _e1534 = phi_2936_;
                                                            let _e1536 = phi_2937_;
                                                            phi_2938_ = _e1496;
                                                            phi_2870_ = _e1530;
                                                            phi_2939_ = _e1532;
                                                            phi_2940_ = _e1534;
                                                            phi_2941_ = _e1536;
                                                            phi_2942_ = false;
                                                        } else {
                                                            phi_2938_ = f32();
                                                            phi_2870_ = f32();
                                                            phi_2939_ = false;
                                                            phi_2940_ = false;
                                                            phi_2941_ = false;
                                                            phi_2942_ = true;
                                                        }
                                                        let _e1538 = phi_2938_;
                                                        let _e1540 = phi_2870_;
                                                        let _e1542 = phi_2939_;
                                                        let _e1544 = phi_2940_;
                                                        let _e1546 = phi_2941_;
                                                        let _e1548 = phi_2942_;
                                                        local_12 = _e1544;
                                                        local_13 = _e1546;
                                                        local_14 = _e1544;
                                                        local_15 = _e1548;
                                                        local_16 = _e1538;
                                                        continue;
                                                        continuing {
                                                            phi_2866_ = type_9(select(_e1479.member, (_e1479.member + 1u), _e1484), select(_e1479.member_1, _e1479.member_1, _e1484));
                                                            phi_2869_ = _e1540;
                                                            break if !(_e1542);
                                                        }
                                                    }
                                                    let _e1551 = local_12;
                                                    let _e1553 = local_13;
                                                    let _e1556 = local_14;
                                                    let _e1558 = local_15;
                                                    let _e1562 = local_16;
                                                    phi_2956_ = select(_e1562, _e1246, select(select(_e1558, false, _e1556), true, select(_e1553, false, _e1551)));
                                                } else {
                                                    phi_2956_ = _e1246;
                                                }
                                                let _e1565 = phi_2956_;
                                                phi_2958_ = type_37(_e1470, _e1565, _e1316);
                                            } else {
                                                phi_2958_ = _e1329;
                                            }
                                            let _e1568 = phi_2958_;
                                            if (_e1568.member > _e1568.member_1) {
                                                phi_3925_ = bool();
                                                phi_3926_ = true;
                                                phi_3927_ = false;
                                                phi_3928_ = false;
                                                phi_3929_ = false;
                                            } else {
                                                let _e1573 = (_e1568.member > _e358);
                                                if _e1573 {
                                                    phi_3921_ = bool();
                                                    phi_3922_ = false;
                                                    phi_3923_ = false;
                                                    phi_3924_ = false;
                                                } else {
                                                    let _e1577 = ((_e1568.member_1 - _e1568.member) * 0.5f);
                                                    let _e1578 = (_e1568.member + _e1577);
                                                    let _e1580 = (_e1577 + (0.000000059604645f * 4f));
                                                    let _e1582 = local_7.member_3;
                                                    let _e1585 = local_7.member[0u];
                                                    let _e1591 = select(_e1585[0], -(_e1585[0]), (_e1585[0] < 0f));
                                                    let _e1594 = select(_e1585[1], -(_e1585[1]), (_e1585[1] < 0f));
                                                    let _e1596 = select(_e1594, _e1591, (_e1591 > _e1594));
                                                    let _e1599 = select(_e1585[2], -(_e1585[2]), (_e1585[2] < 0f));
                                                    let _e1601 = select(_e1599, _e1596, (_e1596 > _e1599));
                                                    let _e1603 = local_7.member[1u];
                                                    let _e1609 = select(_e1603[0], -(_e1603[0]), (_e1603[0] < 0f));
                                                    let _e1612 = select(_e1603[1], -(_e1603[1]), (_e1603[1] < 0f));
                                                    let _e1614 = select(_e1612, _e1609, (_e1609 > _e1612));
                                                    let _e1617 = select(_e1603[2], -(_e1603[2]), (_e1603[2] < 0f));
                                                    let _e1619 = select(_e1617, _e1614, (_e1614 > _e1617));
                                                    let _e1624 = local_7.member[0u];
                                                    let _e1629 = local_7.member[1u];
                                                    let _e1639 = (_e1624[0] + ((_e1629[0] - _e1624[0]) * _e1578));
                                                    let _e1640 = (_e1624[1] + ((_e1629[1] - _e1624[1]) * _e1578));
                                                    let _e1641 = (_e1624[2] + ((_e1629[2] - _e1624[2]) * _e1578));
                                                    let _e1643 = local_7.member[1u];
                                                    let _e1648 = local_7.member[0u];
                                                    let _e1652 = (_e1643[0] - _e1648[0]);
                                                    let _e1653 = (_e1643[1] - _e1648[1]);
                                                    let _e1654 = (_e1643[2] - _e1648[2]);
                                                    let _e1657 = select(_e1652, -(_e1652), (_e1652 < 0f));
                                                    let _e1660 = select(_e1653, -(_e1653), (_e1653 < 0f));
                                                    let _e1662 = select(_e1660, _e1657, (_e1657 > _e1660));
                                                    let _e1665 = select(_e1654, -(_e1654), (_e1654 < 0f));
                                                    let _e1673 = ((((_e1580 * select(_e1665, _e1662, (_e1662 > _e1665))) * 1.01f) + ((select(_e1619, _e1601, (_e1601 > _e1619)) + _e1582) * (0.000000059604645f * 8f))) + _e1582);
                                                    let _e1676 = select(_e1639, -(_e1639), (_e1639 < 0f));
                                                    let _e1679 = select(_e1640, -(_e1640), (_e1640 < 0f));
                                                    let _e1681 = select(_e1679, _e1676, (_e1676 > _e1679));
                                                    let _e1684 = select(_e1641, -(_e1641), (_e1641 < 0f));
                                                    let _e1687 = (select(_e1684, _e1681, (_e1681 > _e1684)) + _e1673);
                                                    let _e1690 = local_7.member_3;
                                                    let _e1692 = local_7.member_1[0u];
                                                    let _e1698 = select(_e1692[0], -(_e1692[0]), (_e1692[0] < 0f));
                                                    let _e1701 = select(_e1692[1], -(_e1692[1]), (_e1692[1] < 0f));
                                                    let _e1703 = select(_e1701, _e1698, (_e1698 > _e1701));
                                                    let _e1706 = select(_e1692[2], -(_e1692[2]), (_e1692[2] < 0f));
                                                    let _e1708 = select(_e1706, _e1703, (_e1703 > _e1706));
                                                    let _e1710 = local_7.member_1[1u];
                                                    let _e1716 = select(_e1710[0], -(_e1710[0]), (_e1710[0] < 0f));
                                                    let _e1719 = select(_e1710[1], -(_e1710[1]), (_e1710[1] < 0f));
                                                    let _e1721 = select(_e1719, _e1716, (_e1716 > _e1719));
                                                    let _e1724 = select(_e1710[2], -(_e1710[2]), (_e1710[2] < 0f));
                                                    let _e1726 = select(_e1724, _e1721, (_e1721 > _e1724));
                                                    let _e1731 = local_7.member_1[0u];
                                                    let _e1736 = local_7.member_1[1u];
                                                    let _e1746 = (_e1731[0] + ((_e1736[0] - _e1731[0]) * _e1578));
                                                    let _e1747 = (_e1731[1] + ((_e1736[1] - _e1731[1]) * _e1578));
                                                    let _e1748 = (_e1731[2] + ((_e1736[2] - _e1731[2]) * _e1578));
                                                    let _e1750 = local_7.member_1[1u];
                                                    let _e1755 = local_7.member_1[0u];
                                                    let _e1759 = (_e1750[0] - _e1755[0]);
                                                    let _e1760 = (_e1750[1] - _e1755[1]);
                                                    let _e1761 = (_e1750[2] - _e1755[2]);
                                                    let _e1764 = select(_e1759, -(_e1759), (_e1759 < 0f));
                                                    let _e1767 = select(_e1760, -(_e1760), (_e1760 < 0f));
                                                    let _e1769 = select(_e1767, _e1764, (_e1764 > _e1767));
                                                    let _e1772 = select(_e1761, -(_e1761), (_e1761 < 0f));
                                                    let _e1780 = ((((_e1580 * select(_e1772, _e1769, (_e1769 > _e1772))) * 1.01f) + ((select(_e1726, _e1708, (_e1708 > _e1726)) + _e1690) * (0.000000059604645f * 8f))) + _e1690);
                                                    let _e1783 = select(_e1746, -(_e1746), (_e1746 < 0f));
                                                    let _e1786 = select(_e1747, -(_e1747), (_e1747 < 0f));
                                                    let _e1788 = select(_e1786, _e1783, (_e1783 > _e1786));
                                                    let _e1791 = select(_e1748, -(_e1748), (_e1748 < 0f));
                                                    let _e1794 = (select(_e1791, _e1788, (_e1788 > _e1791)) + _e1780);
                                                    let _e1797 = local_7.member_3;
                                                    let _e1799 = local_7.member_2[0u];
                                                    let _e1805 = select(_e1799[0], -(_e1799[0]), (_e1799[0] < 0f));
                                                    let _e1808 = select(_e1799[1], -(_e1799[1]), (_e1799[1] < 0f));
                                                    let _e1810 = select(_e1808, _e1805, (_e1805 > _e1808));
                                                    let _e1813 = select(_e1799[2], -(_e1799[2]), (_e1799[2] < 0f));
                                                    let _e1815 = select(_e1813, _e1810, (_e1810 > _e1813));
                                                    let _e1817 = local_7.member_2[1u];
                                                    let _e1823 = select(_e1817[0], -(_e1817[0]), (_e1817[0] < 0f));
                                                    let _e1826 = select(_e1817[1], -(_e1817[1]), (_e1817[1] < 0f));
                                                    let _e1828 = select(_e1826, _e1823, (_e1823 > _e1826));
                                                    let _e1831 = select(_e1817[2], -(_e1817[2]), (_e1817[2] < 0f));
                                                    let _e1833 = select(_e1831, _e1828, (_e1828 > _e1831));
                                                    let _e1838 = local_7.member_2[0u];
                                                    let _e1843 = local_7.member_2[1u];
                                                    let _e1853 = (_e1838[0] + ((_e1843[0] - _e1838[0]) * _e1578));
                                                    let _e1854 = (_e1838[1] + ((_e1843[1] - _e1838[1]) * _e1578));
                                                    let _e1855 = (_e1838[2] + ((_e1843[2] - _e1838[2]) * _e1578));
                                                    let _e1857 = local_7.member_2[1u];
                                                    let _e1862 = local_7.member_2[0u];
                                                    let _e1866 = (_e1857[0] - _e1862[0]);
                                                    let _e1867 = (_e1857[1] - _e1862[1]);
                                                    let _e1868 = (_e1857[2] - _e1862[2]);
                                                    let _e1871 = select(_e1866, -(_e1866), (_e1866 < 0f));
                                                    let _e1874 = select(_e1867, -(_e1867), (_e1867 < 0f));
                                                    let _e1876 = select(_e1874, _e1871, (_e1871 > _e1874));
                                                    let _e1879 = select(_e1868, -(_e1868), (_e1868 < 0f));
                                                    let _e1887 = ((((_e1580 * select(_e1879, _e1876, (_e1876 > _e1879))) * 1.01f) + ((select(_e1833, _e1815, (_e1815 > _e1833)) + _e1797) * (0.000000059604645f * 8f))) + _e1797);
                                                    let _e1890 = select(_e1853, -(_e1853), (_e1853 < 0f));
                                                    let _e1893 = select(_e1854, -(_e1854), (_e1854 < 0f));
                                                    let _e1895 = select(_e1893, _e1890, (_e1890 > _e1893));
                                                    let _e1898 = select(_e1855, -(_e1855), (_e1855 < 0f));
                                                    let _e1901 = (select(_e1898, _e1895, (_e1895 > _e1898)) + _e1887);
                                                    let _e1904 = ((_e1747 * _e1855) - (_e1748 * _e1854));
                                                    let _e1907 = ((_e1748 * _e1853) - (_e1746 * _e1855));
                                                    let _e1910 = ((_e1746 * _e1854) - (_e1747 * _e1853));
                                                    let _e1925 = select(false, (select(_e1904, -(_e1904), (_e1904 < 0f)) > select(_e1910, -(_e1910), (_e1910 < 0f))), (select(_e1904, -(_e1904), (_e1904 < 0f)) > select(_e1907, -(_e1907), (_e1907 < 0f))));
                                                    let _e1940 = select((select(_e1907, -(_e1907), (_e1907 < 0f)) > select(_e1910, -(_e1910), (_e1910 < 0f))), false, (select(_e1904, -(_e1904), (_e1904 < 0f)) > select(_e1907, -(_e1907), (_e1907 < 0f))));
                                                    let _e1943 = select(select(_e1639, _e1640, _e1925), _e1641, _e1940);
                                                    let _e1944 = select(select(_e1640, _e1641, _e1925), _e1639, _e1940);
                                                    let _e1947 = select(select(_e1746, _e1747, _e1925), _e1748, _e1940);
                                                    let _e1948 = select(select(_e1747, _e1748, _e1925), _e1746, _e1940);
                                                    let _e1951 = select(select(_e1853, _e1854, _e1925), _e1855, _e1940);
                                                    let _e1952 = select(select(_e1854, _e1855, _e1925), _e1853, _e1940);
                                                    let _e1955 = ((_e1947 * _e1952) - (_e1948 * _e1951));
                                                    let _e1971 = (((((_e1780 * _e1901) + (_e1794 * _e1887)) * 2.01f) + (((_e1794 * 2f) * (_e1901 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1794) * (1f + _e1901))));
                                                    if (select(_e1955, -(_e1955), (_e1955 < 0f)) > _e1971) {
                                                        let _e1977 = select(1f, -1f, (_e1955 < 0f));
                                                        let _e1996 = (((((_e1673 * _e1901) + (_e1687 * _e1887)) * 2.01f) + (((_e1687 * 2f) * (_e1901 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1687) * (1f + _e1901))));
                                                        let _e2015 = (((((_e1780 * _e1687) + (_e1794 * _e1673)) * 2.01f) + (((_e1794 * 2f) * (_e1687 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1794) * (1f + _e1687))));
                                                        let _e2016 = (_e1955 * _e1977);
                                                        let _e2017 = (((_e1943 * _e1952) - (_e1944 * _e1951)) * _e1977);
                                                        let _e2018 = (((_e1947 * _e1944) - (_e1948 * _e1943)) * _e1977);
                                                        let _e2031 = (((select(_e2016, -(_e2016), (_e2016 < 0f)) + select(_e2017, -(_e2017), (_e2017 < 0f))) + select(_e2018, -(_e2018), (_e2018 < 0f))) * (0.000000059604645f * 4f));
                                                        if (_e225.member != 0u) {
                                                            phi_3795_ = array<type_18, 4>(type_18(_e2017, _e1996), type_18(_e2018, _e2015), type_18((_e2016 - _e2017), ((_e1971 + _e1996) + _e2031)), type_18((_e2016 - _e2018), ((_e1971 + _e2015) + _e2031)));
                                                        } else {
                                                            let _e2034 = ((_e2016 - _e2017) - _e2018);
                                                            let _e2037 = (((_e1971 + _e1996) + _e2015) + _e2031);
                                                            phi_3795_ = array<type_18, 4>(type_18(_e2017, _e1996), type_18(_e2018, _e2015), type_18(_e2034, _e2037), type_18(_e2034, _e2037));
                                                        }
                                                        let _e2055 = phi_3795_;
                                                        local_2 = array<type_18, 4>(type_18(_e2055[0].member, _e2055[0].member_1), type_18(_e2055[1].member, _e2055[1].member_1), type_18(_e2055[2].member, _e2055[2].member_1), type_18(_e2055[3].member, _e2055[3].member_1));
                                                        phi_3815_ = type_9(0u, 4u);
                                                        phi_3818_ = true;
                                                        loop {
                                                            let _e2074 = phi_3815_;
                                                            let _e2076 = phi_3818_;
                                                            local_18 = _e2076;
                                                            let _e2079 = (_e2074.member < _e2074.member_1);
                                                            let _e2090 = select(type_9().member_1, _e2074.member, _e2079);
                                                            if (bitcast<i32>(select(0u, 1u, _e2079)) != 0i) {
                                                                let _e2095 = local_2[_e2090].member;
                                                                let _e2098 = local_2[_e2090].member_1;
                                                                let _e2100 = (_e2095 < -(_e2098));
                                                                phi_3819_ = select((_e2076 && (_e2095 > _e2098)), bool(), _e2100);
                                                                phi_3870_ = select(true, false, _e2100);
                                                                phi_3871_ = _e2100;
                                                            } else {
                                                                phi_3819_ = bool();
                                                                phi_3870_ = false;
                                                                phi_3871_ = false;
                                                            }
                                                            let _e2106 = phi_3819_;
                                                            let _e2108 = phi_3870_;
                                                            let _e2110 = phi_3871_;
                                                            local_17 = _e2110;
                                                            continue;
                                                            continuing {
                                                                phi_3815_ = type_9(select(_e2074.member, (_e2074.member + 1u), _e2079), select(_e2074.member_1, _e2074.member_1, _e2079));
                                                                phi_3818_ = _e2106;
                                                                break if !(_e2108);
                                                            }
                                                        }
                                                        let _e2113 = local_17;
                                                        let _e2114 = select(true, false, _e2113);
                                                        let _e2116 = local_18;
                                                        phi_3885_ = select(u32(), select(2u, 1u, _e2116), _e2114);
                                                        phi_3886_ = 0u;
                                                        phi_3887_ = select(true, false, _e2114);
                                                    } else {
                                                        phi_3885_ = u32();
                                                        phi_3886_ = 2u;
                                                        phi_3887_ = true;
                                                    }
                                                    let _e2121 = phi_3885_;
                                                    let _e2123 = phi_3886_;
                                                    let _e2125 = phi_3887_;
                                                    let _e2126 = select(_e2121, _e2123, _e2125);
                                                    let _e2127 = (_e2126 == 0u);
                                                    if _e2127 {
                                                        phi_3918_ = bool();
                                                        phi_3919_ = false;
                                                        phi_3920_ = false;
                                                    } else {
                                                        let _e2130 = select(false, _e1568.member_2, (_e2126 == 1u));
                                                        let _e2136 = select(true, select(true, false, ((_e1568.member_1 - _e1568.member) <= _e1183)), _e2130);
                                                        phi_3918_ = _e2130;
                                                        phi_3919_ = _e2136;
                                                        phi_3920_ = select(true, false, _e2136);
                                                    }
                                                    let _e2139 = phi_3918_;
                                                    let _e2141 = phi_3919_;
                                                    let _e2143 = phi_3920_;
                                                    phi_3921_ = _e2139;
                                                    phi_3922_ = _e2127;
                                                    phi_3923_ = _e2141;
                                                    phi_3924_ = _e2143;
                                                }
                                                let _e2145 = phi_3921_;
                                                let _e2147 = phi_3922_;
                                                let _e2149 = phi_3923_;
                                                let _e2151 = phi_3924_;
                                                phi_3925_ = _e2145;
                                                phi_3926_ = _e2147;
                                                phi_3927_ = _e2149;
                                                phi_3928_ = _e1573;
                                                phi_3929_ = _e2151;
                                            }
                                            let _e2153 = phi_3925_;
                                            let _e2155 = phi_3926_;
                                            let _e2157 = phi_3927_;
                                            let _e2159 = phi_3928_;
                                            let _e2161 = phi_3929_;
                                            phi_3930_ = _e1568;
                                            phi_3931_ = _e2153;
                                            phi_3932_ = _e1568;
                                            phi_3933_ = _e2155;
                                            phi_3934_ = _e2157;
                                            phi_3935_ = _e2159;
                                            phi_3936_ = _e2161;
                                        }
                                        let _e2163 = phi_3930_;
                                        let _e2165 = phi_3931_;
                                        let _e2167 = phi_3932_;
                                        let _e2169 = phi_3933_;
                                        let _e2171 = phi_3934_;
                                        let _e2173 = phi_3935_;
                                        let _e2175 = phi_3936_;
                                        phi_3937_ = _e2163;
                                        phi_3938_ = _e2165;
                                        phi_3939_ = _e2167;
                                        phi_3940_ = _e2169;
                                        phi_3941_ = _e2171;
                                        phi_3942_ = _e1248;
                                        phi_3943_ = _e2173;
                                        phi_3944_ = _e2175;
                                    } else {
                                        phi_3937_ = type_37();
                                        phi_3938_ = bool();
                                        phi_3939_ = type_37();
                                        phi_3940_ = true;
                                        phi_3941_ = false;
                                        phi_3942_ = false;
                                        phi_3943_ = false;
                                        phi_3944_ = false;
                                    }
                                    let _e2177 = phi_3937_;
                                    let _e2179 = phi_3938_;
                                    let _e2181 = phi_3939_;
                                    let _e2183 = phi_3940_;
                                    let _e2185 = phi_3941_;
                                    let _e2187 = phi_3942_;
                                    let _e2189 = phi_3943_;
                                    let _e2191 = phi_3944_;
                                    phi_3952_ = _e2177;
                                    phi_3953_ = _e2179;
                                    phi_3954_ = _e2181;
                                    phi_3955_ = select(_e2185, false, _e2183);
                                    phi_3956_ = _e2183;
                                    phi_3957_ = select(_e2187, false, _e2183);
                                    phi_3958_ = select(_e2189, false, _e2183);
                                    phi_3959_ = select(_e2191, false, _e2183);
                                } else {
                                    phi_3952_ = type_37(_e354, _e354, false);
                                    phi_3953_ = false;
                                    phi_3954_ = type_37();
                                    phi_3955_ = true;
                                    phi_3956_ = false;
                                    phi_3957_ = false;
                                    phi_3958_ = false;
                                    phi_3959_ = false;
                                }
                                let _e2197 = phi_3952_;
                                let _e2199 = phi_3953_;
                                let _e2201 = phi_3954_;
                                let _e2203 = phi_3955_;
                                let _e2205 = phi_3956_;
                                let _e2207 = phi_3957_;
                                let _e2209 = phi_3958_;
                                let _e2211 = phi_3959_;
                                if _e2203 {
                                    let _e2216 = local_7.member[0u];
                                    let _e2222 = local_7.member_1[0u];
                                    let _e2228 = local_7.member_2[0u];
                                    let _e2232 = (_e2216[0] - _e2222[0]);
                                    let _e2233 = (_e2216[1] - _e2222[1]);
                                    let _e2234 = (_e2216[2] - _e2222[2]);
                                    let _e2235 = (_e225.member == 0u);
                                    let _e2247 = local_7.member[1u];
                                    let _e2253 = local_7.member_1[1u];
                                    let _e2259 = local_7.member_2[1u];
                                    let _e2263 = (_e2247[0] - _e2253[0]);
                                    let _e2264 = (_e2247[1] - _e2253[1]);
                                    let _e2265 = (_e2247[2] - _e2253[2]);
                                    let _e2266 = (_e225.member == 0u);
                                    let _e2278 = local_7.member[0u];
                                    let _e2284 = select(_e2278[0], -(_e2278[0]), (_e2278[0] < 0f));
                                    let _e2287 = select(_e2278[1], -(_e2278[1]), (_e2278[1] < 0f));
                                    let _e2289 = select(_e2287, _e2284, (_e2284 > _e2287));
                                    let _e2292 = select(_e2278[2], -(_e2278[2]), (_e2278[2] < 0f));
                                    let _e2294 = select(_e2292, _e2289, (_e2289 > _e2292));
                                    let _e2297 = local_7.member[1u];
                                    let _e2303 = select(_e2297[0], -(_e2297[0]), (_e2297[0] < 0f));
                                    let _e2306 = select(_e2297[1], -(_e2297[1]), (_e2297[1] < 0f));
                                    let _e2308 = select(_e2306, _e2303, (_e2303 > _e2306));
                                    let _e2311 = select(_e2297[2], -(_e2297[2]), (_e2297[2] < 0f));
                                    let _e2313 = select(_e2311, _e2308, (_e2308 > _e2311));
                                    let _e2317 = local_7.member_3;
                                    let _e2321 = local_7.member_1[0u];
                                    let _e2327 = select(_e2321[0], -(_e2321[0]), (_e2321[0] < 0f));
                                    let _e2330 = select(_e2321[1], -(_e2321[1]), (_e2321[1] < 0f));
                                    let _e2332 = select(_e2330, _e2327, (_e2327 > _e2330));
                                    let _e2335 = select(_e2321[2], -(_e2321[2]), (_e2321[2] < 0f));
                                    let _e2337 = select(_e2335, _e2332, (_e2332 > _e2335));
                                    let _e2340 = local_7.member_1[1u];
                                    let _e2346 = select(_e2340[0], -(_e2340[0]), (_e2340[0] < 0f));
                                    let _e2349 = select(_e2340[1], -(_e2340[1]), (_e2340[1] < 0f));
                                    let _e2351 = select(_e2349, _e2346, (_e2346 > _e2349));
                                    let _e2354 = select(_e2340[2], -(_e2340[2]), (_e2340[2] < 0f));
                                    let _e2356 = select(_e2354, _e2351, (_e2351 > _e2354));
                                    let _e2360 = local_7.member_3;
                                    let _e2364 = local_7.member_2[0u];
                                    let _e2370 = select(_e2364[0], -(_e2364[0]), (_e2364[0] < 0f));
                                    let _e2373 = select(_e2364[1], -(_e2364[1]), (_e2364[1] < 0f));
                                    let _e2375 = select(_e2373, _e2370, (_e2370 > _e2373));
                                    let _e2378 = select(_e2364[2], -(_e2364[2]), (_e2364[2] < 0f));
                                    let _e2380 = select(_e2378, _e2375, (_e2375 > _e2378));
                                    let _e2383 = local_7.member_2[1u];
                                    let _e2389 = select(_e2383[0], -(_e2383[0]), (_e2383[0] < 0f));
                                    let _e2392 = select(_e2383[1], -(_e2383[1]), (_e2383[1] < 0f));
                                    let _e2394 = select(_e2392, _e2389, (_e2389 > _e2392));
                                    let _e2397 = select(_e2383[2], -(_e2383[2]), (_e2383[2] < 0f));
                                    let _e2399 = select(_e2397, _e2394, (_e2394 > _e2397));
                                    let _e2403 = local_7.member_3;
                                    let _e2410 = local_7.member_3;
                                    let _e2415 = (_e352 * 0.00390625f);
                                    local = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_4382_ = type_9(0u, 96u);
                                    phi_4385_ = _e2197.member;
                                    phi_4387_ = _e2197.member;
                                    phi_4389_ = (_e2197.member_1 - _e2197.member);
                                    phi_4391_ = _e2197.member;
                                    phi_4393_ = false;
                                    phi_4395_ = 0u;
                                    loop {
                                        let _e2418 = phi_4382_;
                                        let _e2420 = phi_4385_;
                                        let _e2422 = phi_4387_;
                                        let _e2424 = phi_4389_;
                                        let _e2426 = phi_4391_;
                                        let _e2428 = phi_4393_;
                                        let _e2430 = phi_4395_;
                                        local_28 = _e2420;
                                        local_31 = _e2422;
                                        let _e2433 = (_e2418.member < _e2418.member_1);
                                        if (bitcast<i32>(select(0u, 1u, _e2433)) != 0i) {
                                            let _e2447 = local_7.member[0u];
                                            let _e2453 = local_7.member[1u];
                                            let _e2469 = local_7.member_1[0u];
                                            let _e2475 = local_7.member_1[1u];
                                            let _e2491 = local_7.member_2[0u];
                                            let _e2497 = local_7.member_2[1u];
                                            let _e2511 = function_2(array<f32, 3>((_e2447[0] + ((_e2453[0] - _e2447[0]) * _e2420)), (_e2447[1] + ((_e2453[1] - _e2447[1]) * _e2420)), (_e2447[2] + ((_e2453[2] - _e2447[2]) * _e2420))), array<f32, 3>((_e2469[0] + ((_e2475[0] - _e2469[0]) * _e2420)), (_e2469[1] + ((_e2475[1] - _e2469[1]) * _e2420)), (_e2469[2] + ((_e2475[2] - _e2469[2]) * _e2420))), array<f32, 3>((_e2491[0] + ((_e2497[0] - _e2491[0]) * _e2420)), (_e2491[1] + ((_e2497[1] - _e2491[1]) * _e2420)), (_e2491[2] + ((_e2497[2] - _e2491[2]) * _e2420))), _e225.member);
                                            if (_e2430 == 0u) {
                                                phi_4546_ = _e2511;
                                            } else {
                                                phi_4546_ = array<f32, 3>(select(0f, _e2511[0], (_e2430 == 1u)), select(0f, _e2511[1], (_e2430 == 2u)), select(0f, _e2511[2], (_e2430 == 3u)));
                                            }
                                            let _e2524 = phi_4546_;
                                            let _e2538 = ((select(_e2524[0], -(_e2524[0]), (_e2524[0] < 0f)) + select(_e2524[1], -(_e2524[1]), (_e2524[1] < 0f))) + select(_e2524[2], -(_e2524[2]), (_e2524[2] < 0f)));
                                            if (_e2538 > 0f) {
                                                if ((bitcast<u32>(_e2538) & 2139095040u) != 2139095040u) {
                                                    let _e2543 = (1f / _e2538);
                                                    let _e2545 = (_e2524[0] * _e2543);
                                                    let _e2547 = (_e2524[1] * _e2543);
                                                    let _e2549 = (_e2524[2] * _e2543);
                                                    let _e2554 = (((_e2545 * _e2545) + (_e2547 * _e2547)) + (_e2549 * _e2549));
                                                    if (_e2554 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_4669_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2554 > 0f));
                                                    } else {
                                                        phi_4612_ = type_16(0i, 5i);
                                                        phi_4615_ = bitcast<f32>(((bitcast<u32>(_e2554) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e2562 = phi_4612_;
                                                            let _e2564 = phi_4615_;
                                                            local_19 = _e2564;
                                                            if (_e2562.member < _e2562.member_1) {
                                                                let _e2571 = (_e2562.member + 1i);
                                                                phi_4613_ = type_16(select(_e2571, type_17().member_1, select(false, true, ((false == (_e2571 > _e2562.member)) != false))), _e2562.member_1);
                                                                phi_4656_ = type_17(1u, _e2562.member);
                                                            } else {
                                                                phi_4613_ = _e2562;
                                                                phi_4656_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e2582 = phi_4613_;
                                                            let _e2584 = phi_4656_;
                                                            let _e2587 = (bitcast<i32>(_e2584.member) != 0i);
                                                            if _e2587 {
                                                                phi_4616_ = (0.5f * (_e2564 + (_e2554 / _e2564)));
                                                            } else {
                                                                phi_4616_ = f32();
                                                            }
                                                            let _e2592 = phi_4616_;
                                                            continue;
                                                            continuing {
                                                                phi_4612_ = _e2582;
                                                                phi_4615_ = _e2592;
                                                                break if !(_e2587);
                                                            }
                                                        }
                                                        let _e2597 = local_19;
                                                        phi_4669_ = (_e2597 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e2603 = phi_4669_;
                                                    let _e2604 = (0.000000059604645f * 12f);
                                                    let _e2609 = ((((((((select(_e2313, _e2294, (_e2294 > _e2313)) + _e2317) + (select(_e2356, _e2337, (_e2337 > _e2356)) + _e2360)) + (select(_e2399, _e2380, (_e2380 > _e2399)) + _e2403)) * (0.000000059604645f * 16f)) + (_e2410 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2603) * (1f + _e2604)));
                                                    let _e2614 = (((_e2545 * _e2216[0]) + (_e2547 * _e2216[1])) + (_e2549 * _e2216[2]));
                                                    let _e2619 = (((_e2545 * _e2232) + (_e2547 * _e2233)) + (_e2549 * _e2234));
                                                    let _e2624 = (((_e2545 * (_e2216[0] - _e2228[0])) + (_e2547 * (_e2216[1] - _e2228[1]))) + (_e2549 * (_e2216[2] - _e2228[2])));
                                                    let _e2629 = (((_e2545 * select((_e2232 - _e2228[0]), _e2216[0], _e2235)) + (_e2547 * select((_e2233 - _e2228[1]), _e2216[1], _e2235))) + (_e2549 * select((_e2234 - _e2228[2]), _e2216[2], _e2235)));
                                                    let _e2635 = (((_e2545 * _e2247[0]) + (_e2547 * _e2247[1])) + (_e2549 * _e2247[2]));
                                                    let _e2640 = (((_e2545 * _e2263) + (_e2547 * _e2264)) + (_e2549 * _e2265));
                                                    let _e2645 = (((_e2545 * (_e2247[0] - _e2259[0])) + (_e2547 * (_e2247[1] - _e2259[1]))) + (_e2549 * (_e2247[2] - _e2259[2])));
                                                    let _e2650 = (((_e2545 * select((_e2263 - _e2259[0]), _e2247[0], _e2266)) + (_e2547 * select((_e2264 - _e2259[1]), _e2247[1], _e2266))) + (_e2549 * select((_e2265 - _e2259[2]), _e2247[2], _e2266)));
                                                    phi_4792_ = type_29(array<f32, 4>(_e2614, _e2619, _e2624, _e2629), array<f32, 4>(_e2635, _e2640, _e2645, _e2650), array<f32, 4>((_e2609 + ((select(_e2614, -(_e2614), (_e2614 < 0f)) + select(_e2635, -(_e2635), (_e2635 < 0f))) * _e2604)), (_e2609 + ((select(_e2619, -(_e2619), (_e2619 < 0f)) + select(_e2640, -(_e2640), (_e2640 < 0f))) * _e2604)), (_e2609 + ((select(_e2624, -(_e2624), (_e2624 < 0f)) + select(_e2645, -(_e2645), (_e2645 < 0f))) * _e2604)), (_e2609 + ((select(_e2629, -(_e2629), (_e2629 < 0f)) + select(_e2650, -(_e2650), (_e2650 < 0f))) * _e2604))));
                                                    phi_4793_ = false;
                                                } else {
                                                    phi_4792_ = type_29();
                                                    phi_4793_ = true;
                                                }
                                                let _e2691 = phi_4792_;
                                                let _e2693 = phi_4793_;
                                                phi_4794_ = _e2691;
                                                phi_4795_ = _e2693;
                                            } else {
                                                phi_4794_ = type_29();
                                                phi_4795_ = true;
                                            }
                                            let _e2695 = phi_4794_;
                                            let _e2697 = phi_4795_;
                                            if _e2697 {
                                                phi_4803_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_4803_ = _e2695;
                                            }
                                            let _e2699 = phi_4803_;
                                            local_1 = type_29(array<f32, 4>(_e2699.member[0], _e2699.member[1], _e2699.member[2], _e2699.member[3]), array<f32, 4>(_e2699.member_1[0], _e2699.member_1[1], _e2699.member_1[2], _e2699.member_1[3]), array<f32, 4>(_e2699.member_2[0], _e2699.member_2[1], _e2699.member_2[2], _e2699.member_2[3]));
                                            let _e2719 = (_e2420 - _e2426);
                                            let _e2723 = local_1.member[0u];
                                            let _e2726 = local_1.member_1[0u];
                                            let _e2729 = local_1.member[0u];
                                            let _e2735 = local_1.member_2[0u];
                                            if (((_e2723 + ((_e2726 - _e2729) * _e2420)) - _e2735) > 0f) {
                                                let _e2740 = local_1.member[1u];
                                                let _e2743 = local_1.member_1[1u];
                                                let _e2746 = local_1.member[1u];
                                                let _e2752 = local_1.member_2[1u];
                                                if (((_e2740 + ((_e2743 - _e2746) * _e2420)) - _e2752) > 0f) {
                                                    let _e2757 = local_1.member[2u];
                                                    let _e2760 = local_1.member_1[2u];
                                                    let _e2763 = local_1.member[2u];
                                                    let _e2769 = local_1.member_2[2u];
                                                    if (((_e2757 + ((_e2760 - _e2763) * _e2420)) - _e2769) > 0f) {
                                                        let _e2774 = local_1.member[3u];
                                                        let _e2777 = local_1.member_1[3u];
                                                        let _e2780 = local_1.member[3u];
                                                        let _e2786 = local_1.member_2[3u];
                                                        phi_4974_ = (((_e2774 + ((_e2777 - _e2780) * _e2420)) - _e2786) > 0f);
                                                        phi_4975_ = false;
                                                    } else {
                                                        phi_4974_ = bool();
                                                        phi_4975_ = true;
                                                    }
                                                    let _e2790 = phi_4974_;
                                                    let _e2792 = phi_4975_;
                                                    phi_4976_ = _e2790;
                                                    phi_4977_ = _e2792;
                                                } else {
                                                    phi_4976_ = bool();
                                                    phi_4977_ = true;
                                                }
                                                let _e2794 = phi_4976_;
                                                let _e2796 = phi_4977_;
                                                phi_4978_ = _e2794;
                                                phi_4979_ = _e2796;
                                            } else {
                                                phi_4978_ = bool();
                                                phi_4979_ = true;
                                            }
                                            let _e2798 = phi_4978_;
                                            let _e2800 = phi_4979_;
                                            if select(_e2798, false, _e2800) {
                                                if (_e2420 <= _e2422) {
                                                    phi_5293_ = true;
                                                } else {
                                                    let _e2805 = local.member[0u];
                                                    let _e2808 = local.member_1[0u];
                                                    let _e2811 = local.member[0u];
                                                    let _e2817 = local.member_2[0u];
                                                    let _e2821 = local_1.member[0u];
                                                    let _e2824 = local_1.member_1[0u];
                                                    let _e2827 = local_1.member[0u];
                                                    let _e2833 = local_1.member_2[0u];
                                                    if ((((_e2805 + ((_e2808 - _e2811) * _e2420)) - _e2817) + ((_e2821 + ((_e2824 - _e2827) * _e2426)) - _e2833)) > 0f) {
                                                        let _e2839 = local.member[1u];
                                                        let _e2842 = local.member_1[1u];
                                                        let _e2845 = local.member[1u];
                                                        let _e2851 = local.member_2[1u];
                                                        let _e2855 = local_1.member[1u];
                                                        let _e2858 = local_1.member_1[1u];
                                                        let _e2861 = local_1.member[1u];
                                                        let _e2867 = local_1.member_2[1u];
                                                        if ((((_e2839 + ((_e2842 - _e2845) * _e2420)) - _e2851) + ((_e2855 + ((_e2858 - _e2861) * _e2426)) - _e2867)) > 0f) {
                                                            let _e2873 = local.member[2u];
                                                            let _e2876 = local.member_1[2u];
                                                            let _e2879 = local.member[2u];
                                                            let _e2885 = local.member_2[2u];
                                                            let _e2889 = local_1.member[2u];
                                                            let _e2892 = local_1.member_1[2u];
                                                            let _e2895 = local_1.member[2u];
                                                            let _e2901 = local_1.member_2[2u];
                                                            if ((((_e2873 + ((_e2876 - _e2879) * _e2420)) - _e2885) + ((_e2889 + ((_e2892 - _e2895) * _e2426)) - _e2901)) > 0f) {
                                                                let _e2907 = local.member[3u];
                                                                let _e2910 = local.member_1[3u];
                                                                let _e2913 = local.member[3u];
                                                                let _e2919 = local.member_2[3u];
                                                                let _e2923 = local_1.member[3u];
                                                                let _e2926 = local_1.member_1[3u];
                                                                let _e2929 = local_1.member[3u];
                                                                let _e2935 = local_1.member_2[3u];
                                                                phi_5280_ = ((((_e2907 + ((_e2910 - _e2913) * _e2420)) - _e2919) + ((_e2923 + ((_e2926 - _e2929) * _e2426)) - _e2935)) > 0f);
                                                                phi_5281_ = false;
                                                            } else {
                                                                phi_5280_ = bool();
                                                                phi_5281_ = true;
                                                            }
                                                            let _e2940 = phi_5280_;
                                                            let _e2942 = phi_5281_;
                                                            phi_5282_ = _e2940;
                                                            phi_5283_ = _e2942;
                                                        } else {
                                                            phi_5282_ = bool();
                                                            phi_5283_ = true;
                                                        }
                                                        let _e2944 = phi_5282_;
                                                        let _e2946 = phi_5283_;
                                                        phi_5284_ = _e2944;
                                                        phi_5285_ = _e2946;
                                                    } else {
                                                        phi_5284_ = bool();
                                                        phi_5285_ = true;
                                                    }
                                                    let _e2948 = phi_5284_;
                                                    let _e2950 = phi_5285_;
                                                    phi_5293_ = select(_e2948, false, _e2950);
                                                }
                                                let _e2953 = phi_5293_;
                                                if _e2953 {
                                                    if select(true, select(true, false, (_e2420 >= _e2197.member_1)), _e2428) {
                                                        local = type_29(array<f32, 4>(_e2699.member[0], _e2699.member[1], _e2699.member[2], _e2699.member[3]), array<f32, 4>(_e2699.member_1[0], _e2699.member_1[1], _e2699.member_1[2], _e2699.member_1[3]), array<f32, 4>(_e2699.member_2[0], _e2699.member_2[1], _e2699.member_2[2], _e2699.member_2[3]));
                                                        let _e2978 = local.member[0u];
                                                        let _e2981 = local.member_1[0u];
                                                        let _e2984 = local.member_2[0u];
                                                        if select(true, select(true, false, (_e2981 > _e2984)), (_e2978 > _e2984)) {
                                                            let _e2989 = (_e2981 >= _e2978);
                                                            if _e2989 {
                                                                phi_5402_ = f32();
                                                                phi_5403_ = false;
                                                            } else {
                                                                if ((_e2978 - _e2981) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_5400_ = (((_e2978 - _e2984) / (_e2978 - _e2981)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_5401_ = false;
                                                                } else {
                                                                    phi_5400_ = f32();
                                                                    phi_5401_ = true;
                                                                }
                                                                let _e3000 = phi_5400_;
                                                                let _e3002 = phi_5401_;
                                                                phi_5402_ = _e3000;
                                                                phi_5403_ = _e3002;
                                                            }
                                                            let _e3004 = phi_5402_;
                                                            let _e3006 = phi_5403_;
                                                            phi_5404_ = _e3004;
                                                            phi_5405_ = _e2989;
                                                            phi_5406_ = _e3006;
                                                        } else {
                                                            phi_5404_ = f32();
                                                            phi_5405_ = true;
                                                            phi_5406_ = false;
                                                        }
                                                        let _e3008 = phi_5404_;
                                                        let _e3010 = phi_5405_;
                                                        let _e3012 = phi_5406_;
                                                        let _e3015 = select(_e3008, select(_e2420, 2f, _e3010), select(_e3012, true, _e3010));
                                                        let _e3018 = local.member[1u];
                                                        let _e3021 = local.member_1[1u];
                                                        let _e3024 = local.member_2[1u];
                                                        if select(true, select(true, false, (_e3021 > _e3024)), (_e3018 > _e3024)) {
                                                            let _e3029 = (_e3021 >= _e3018);
                                                            if _e3029 {
                                                                phi_5470_ = f32();
                                                                phi_5471_ = false;
                                                            } else {
                                                                if ((_e3018 - _e3021) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_5468_ = (((_e3018 - _e3024) / (_e3018 - _e3021)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_5469_ = false;
                                                                } else {
                                                                    phi_5468_ = f32();
                                                                    phi_5469_ = true;
                                                                }
                                                                let _e3040 = phi_5468_;
                                                                let _e3042 = phi_5469_;
                                                                phi_5470_ = _e3040;
                                                                phi_5471_ = _e3042;
                                                            }
                                                            let _e3044 = phi_5470_;
                                                            let _e3046 = phi_5471_;
                                                            phi_5472_ = _e3044;
                                                            phi_5473_ = _e3029;
                                                            phi_5474_ = _e3046;
                                                        } else {
                                                            phi_5472_ = f32();
                                                            phi_5473_ = true;
                                                            phi_5474_ = false;
                                                        }
                                                        let _e3048 = phi_5472_;
                                                        let _e3050 = phi_5473_;
                                                        let _e3052 = phi_5474_;
                                                        let _e3055 = select(_e3048, select(_e2420, 2f, _e3050), select(_e3052, true, _e3050));
                                                        let _e3057 = select(_e3055, _e3015, (_e3015 < _e3055));
                                                        let _e3060 = local.member[2u];
                                                        let _e3063 = local.member_1[2u];
                                                        let _e3066 = local.member_2[2u];
                                                        if select(true, select(true, false, (_e3063 > _e3066)), (_e3060 > _e3066)) {
                                                            let _e3071 = (_e3063 >= _e3060);
                                                            if _e3071 {
                                                                phi_5543_ = f32();
                                                                phi_5544_ = false;
                                                            } else {
                                                                if ((_e3060 - _e3063) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_5541_ = (((_e3060 - _e3066) / (_e3060 - _e3063)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_5542_ = false;
                                                                } else {
                                                                    phi_5541_ = f32();
                                                                    phi_5542_ = true;
                                                                }
                                                                let _e3082 = phi_5541_;
                                                                let _e3084 = phi_5542_;
                                                                phi_5543_ = _e3082;
                                                                phi_5544_ = _e3084;
                                                            }
                                                            let _e3086 = phi_5543_;
                                                            let _e3088 = phi_5544_;
                                                            phi_5545_ = _e3086;
                                                            phi_5546_ = _e3071;
                                                            phi_5547_ = _e3088;
                                                        } else {
                                                            phi_5545_ = f32();
                                                            phi_5546_ = true;
                                                            phi_5547_ = false;
                                                        }
                                                        let _e3090 = phi_5545_;
                                                        let _e3092 = phi_5546_;
                                                        let _e3094 = phi_5547_;
                                                        let _e3097 = select(_e3090, select(_e2420, 2f, _e3092), select(_e3094, true, _e3092));
                                                        let _e3100 = local.member[3u];
                                                        let _e3103 = local.member_1[3u];
                                                        let _e3106 = local.member_2[3u];
                                                        if select(true, select(true, false, (_e3103 > _e3106)), (_e3100 > _e3106)) {
                                                            let _e3111 = (_e3103 >= _e3100);
                                                            if _e3111 {
                                                                phi_5611_ = f32();
                                                                phi_5612_ = false;
                                                            } else {
                                                                if ((_e3100 - _e3103) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_5609_ = (((_e3100 - _e3106) / (_e3100 - _e3103)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_5610_ = false;
                                                                } else {
                                                                    phi_5609_ = f32();
                                                                    phi_5610_ = true;
                                                                }
                                                                let _e3122 = phi_5609_;
                                                                let _e3124 = phi_5610_;
                                                                phi_5611_ = _e3122;
                                                                phi_5612_ = _e3124;
                                                            }
                                                            let _e3126 = phi_5611_;
                                                            let _e3128 = phi_5612_;
                                                            phi_5613_ = _e3126;
                                                            phi_5614_ = _e3111;
                                                            phi_5615_ = _e3128;
                                                        } else {
                                                            phi_5613_ = f32();
                                                            phi_5614_ = true;
                                                            phi_5615_ = false;
                                                        }
                                                        let _e3130 = phi_5613_;
                                                        let _e3132 = phi_5614_;
                                                        let _e3134 = phi_5615_;
                                                        let _e3137 = select(_e3130, select(_e2420, 2f, _e3132), select(_e3134, true, _e3132));
                                                        let _e3139 = select(_e3137, _e3097, (_e3097 < _e3137));
                                                        let _e3141 = select(_e3139, _e3057, (_e3057 < _e3139));
                                                        let _e3143 = select(_e2420, _e3141, (_e3141 > _e2420));
                                                        let _e3144 = (_e3143 > _e2197.member_1);
                                                        if _e3144 {
                                                            phi_6144_ = f32();
                                                            phi_6145_ = f32();
                                                            phi_6146_ = false;
                                                        } else {
                                                            let _e3145 = (_e3143 - _e2420);
                                                            phi_6144_ = select((_e2197.member_1 - _e2420), select(0f, (_e2719 + _e2719), select(select(true, false, (_e3145 <= (_e2424 * 0.25f))), true, (_e3145 <= _e2415))), _e2428);
                                                            phi_6145_ = _e3145;
                                                            phi_6146_ = true;
                                                        }
                                                        let _e3156 = phi_6144_;
                                                        let _e3158 = phi_6145_;
                                                        let _e3160 = phi_6146_;
                                                        phi_6148_ = _e3143;
                                                        phi_6149_ = _e3156;
                                                        phi_6150_ = _e3158;
                                                        phi_6152_ = _e3160;
                                                        phi_6153_ = _e3144;
                                                        phi_6155_ = false;
                                                    } else {
                                                        phi_6148_ = f32();
                                                        phi_6149_ = f32();
                                                        phi_6150_ = f32();
                                                        phi_6152_ = false;
                                                        phi_6153_ = false;
                                                        phi_6155_ = true;
                                                    }
                                                    let _e3162 = phi_6148_;
                                                    let _e3164 = phi_6149_;
                                                    let _e3166 = phi_6150_;
                                                    let _e3168 = phi_6152_;
                                                    let _e3170 = phi_6153_;
                                                    let _e3172 = phi_6155_;
                                                    phi_6156_ = _e3162;
                                                    phi_6157_ = _e3164;
                                                    phi_6158_ = _e3166;
                                                    phi_6160_ = false;
                                                    phi_6161_ = _e3168;
                                                    phi_6162_ = _e3170;
                                                    phi_6164_ = _e3172;
                                                } else {
                                                    phi_6156_ = f32();
                                                    phi_6157_ = f32();
                                                    phi_6158_ = f32();
                                                    phi_6160_ = true;
                                                    phi_6161_ = false;
                                                    phi_6162_ = false;
                                                    phi_6164_ = false;
                                                }
                                                let _e3174 = phi_6156_;
                                                let _e3176 = phi_6157_;
                                                let _e3178 = phi_6158_;
                                                let _e3180 = phi_6160_;
                                                let _e3182 = phi_6161_;
                                                let _e3184 = phi_6162_;
                                                let _e3186 = phi_6164_;
                                                phi_6165_ = _e3174;
                                                phi_6166_ = _e3176;
                                                phi_6167_ = _e3178;
                                                phi_6169_ = _e3180;
                                                phi_6170_ = _e3182;
                                                phi_6171_ = _e3184;
                                                phi_6173_ = _e3186;
                                            } else {
                                                phi_6165_ = f32();
                                                phi_6166_ = f32();
                                                phi_6167_ = f32();
                                                phi_6169_ = true;
                                                phi_6170_ = false;
                                                phi_6171_ = false;
                                                phi_6173_ = false;
                                            }
                                            let _e3188 = phi_6165_;
                                            let _e3190 = phi_6166_;
                                            let _e3192 = phi_6167_;
                                            let _e3194 = phi_6169_;
                                            let _e3196 = phi_6170_;
                                            let _e3198 = phi_6171_;
                                            let _e3200 = phi_6173_;
                                            if _e3194 {
                                                if (_e2420 <= _e2422) {
                                                    let _e3353 = (_e2430 + 1u);
                                                    let _e3354 = (_e3353 > 3u);
                                                    phi_6508_ = _e3353;
                                                    phi_6509_ = f32();
                                                    phi_6510_ = false;
                                                    phi_6511_ = select(true, false, _e3354);
                                                    phi_6512_ = _e3354;
                                                } else {
                                                    let _e3204 = local.member[0u];
                                                    let _e3207 = local.member_1[0u];
                                                    let _e3210 = local.member[0u];
                                                    let _e3216 = local.member_2[0u];
                                                    let _e3217 = ((_e3204 + ((_e3207 - _e3210) * _e2426)) - _e3216);
                                                    let _e3220 = local.member[1u];
                                                    let _e3223 = local.member_1[1u];
                                                    let _e3226 = local.member[1u];
                                                    let _e3232 = local.member_2[1u];
                                                    let _e3233 = ((_e3220 + ((_e3223 - _e3226) * _e2426)) - _e3232);
                                                    let _e3235 = select(_e3233, _e3217, (_e3217 < _e3233));
                                                    let _e3238 = local.member[2u];
                                                    let _e3241 = local.member_1[2u];
                                                    let _e3244 = local.member[2u];
                                                    let _e3250 = local.member_2[2u];
                                                    let _e3251 = ((_e3238 + ((_e3241 - _e3244) * _e2426)) - _e3250);
                                                    let _e3254 = local.member[3u];
                                                    let _e3257 = local.member_1[3u];
                                                    let _e3260 = local.member[3u];
                                                    let _e3266 = local.member_2[3u];
                                                    let _e3267 = ((_e3254 + ((_e3257 - _e3260) * _e2426)) - _e3266);
                                                    let _e3269 = select(_e3267, _e3251, (_e3251 < _e3267));
                                                    let _e3271 = select(_e3269, _e3235, (_e3235 < _e3269));
                                                    let _e3274 = local_1.member[0u];
                                                    let _e3277 = local_1.member_1[0u];
                                                    let _e3280 = local_1.member[0u];
                                                    let _e3286 = local_1.member_2[0u];
                                                    let _e3287 = ((_e3274 + ((_e3277 - _e3280) * _e2420)) - _e3286);
                                                    let _e3290 = local_1.member[1u];
                                                    let _e3293 = local_1.member_1[1u];
                                                    let _e3296 = local_1.member[1u];
                                                    let _e3302 = local_1.member_2[1u];
                                                    let _e3303 = ((_e3290 + ((_e3293 - _e3296) * _e2420)) - _e3302);
                                                    let _e3305 = select(_e3303, _e3287, (_e3287 < _e3303));
                                                    let _e3308 = local_1.member[2u];
                                                    let _e3311 = local_1.member_1[2u];
                                                    let _e3314 = local_1.member[2u];
                                                    let _e3320 = local_1.member_2[2u];
                                                    let _e3321 = ((_e3308 + ((_e3311 - _e3314) * _e2420)) - _e3320);
                                                    let _e3324 = local_1.member[3u];
                                                    let _e3327 = local_1.member_1[3u];
                                                    let _e3330 = local_1.member[3u];
                                                    let _e3336 = local_1.member_2[3u];
                                                    let _e3337 = ((_e3324 + ((_e3327 - _e3330) * _e2420)) - _e3336);
                                                    let _e3339 = select(_e3337, _e3321, (_e3321 < _e3337));
                                                    let _e3341 = select(_e3339, _e3305, (_e3305 < _e3339));
                                                    if (_e3341 > 0f) {
                                                        phi_6506_ = 0.5f;
                                                    } else {
                                                        let _e3345 = (0.95f * (_e3271 / (_e3271 - _e3341)));
                                                        phi_6506_ = select(0.0625f, select(0.9f, _e3345, (_e3345 < 0.9f)), (_e3345 > 0.0625f));
                                                    }
                                                    let _e3351 = phi_6506_;
                                                    phi_6508_ = u32();
                                                    phi_6509_ = (_e2719 * _e3351);
                                                    phi_6510_ = true;
                                                    phi_6511_ = false;
                                                    phi_6512_ = false;
                                                }
                                                let _e3357 = phi_6508_;
                                                let _e3359 = phi_6509_;
                                                let _e3361 = phi_6510_;
                                                let _e3363 = phi_6511_;
                                                let _e3365 = phi_6512_;
                                                phi_6513_ = _e3357;
                                                phi_6514_ = _e2422;
                                                phi_6515_ = _e3359;
                                                phi_6516_ = _e2424;
                                                phi_6517_ = _e2426;
                                                phi_6518_ = _e2428;
                                                phi_6519_ = _e2430;
                                                phi_6520_ = _e3361;
                                                phi_6521_ = _e3363;
                                                phi_6522_ = _e3365;
                                                phi_6523_ = false;
                                                phi_6525_ = false;
                                            } else {
                                                phi_6513_ = u32();
                                                phi_6514_ = _e3188;
                                                phi_6515_ = _e3190;
                                                phi_6516_ = _e3192;
                                                phi_6517_ = _e2420;
                                                phi_6518_ = true;
                                                phi_6519_ = 0u;
                                                phi_6520_ = _e3196;
                                                phi_6521_ = false;
                                                phi_6522_ = false;
                                                phi_6523_ = _e3198;
                                                phi_6525_ = _e3200;
                                            }
                                            let _e3367 = phi_6513_;
                                            let _e3369 = phi_6514_;
                                            let _e3371 = phi_6515_;
                                            let _e3373 = phi_6516_;
                                            let _e3375 = phi_6517_;
                                            let _e3377 = phi_6518_;
                                            let _e3379 = phi_6519_;
                                            let _e3381 = phi_6520_;
                                            let _e3383 = phi_6521_;
                                            let _e3385 = phi_6522_;
                                            let _e3387 = phi_6523_;
                                            let _e3389 = phi_6525_;
                                            if _e3381 {
                                                let _e3390 = (_e3375 + _e3371);
                                                let _e3392 = select(_e3369, _e3390, (_e3390 > _e3369));
                                                let _e3394 = select(_e2197.member_1, _e3392, (_e3392 < _e2197.member_1));
                                                let _e3397 = select(((_e3394 - _e3375) > _e2415), true, !(_e2428));
                                                phi_6553_ = _e3394;
                                                phi_6554_ = _e3369;
                                                phi_6555_ = _e3373;
                                                phi_6556_ = _e3375;
                                                phi_6557_ = _e3377;
                                                phi_6558_ = _e3379;
                                                phi_6559_ = _e3397;
                                                phi_6560_ = select(true, false, _e3397);
                                                phi_6561_ = false;
                                                phi_6562_ = false;
                                                phi_6564_ = false;
                                            } else {
                                                phi_6553_ = _e2420;
                                                phi_6554_ = _e2422;
                                                phi_6555_ = _e2424;
                                                phi_6556_ = _e2426;
                                                phi_6557_ = _e2428;
                                                phi_6558_ = _e3367;
                                                phi_6559_ = _e3383;
                                                phi_6560_ = false;
                                                phi_6561_ = _e3385;
                                                phi_6562_ = _e3387;
                                                phi_6564_ = _e3389;
                                            }
                                            let _e3400 = phi_6553_;
                                            let _e3402 = phi_6554_;
                                            let _e3404 = phi_6555_;
                                            let _e3406 = phi_6556_;
                                            let _e3408 = phi_6557_;
                                            let _e3410 = phi_6558_;
                                            let _e3412 = phi_6559_;
                                            let _e3414 = phi_6560_;
                                            let _e3416 = phi_6561_;
                                            let _e3418 = phi_6562_;
                                            let _e3420 = phi_6564_;
                                            phi_4386_ = _e3400;
                                            phi_4388_ = _e3402;
                                            phi_4390_ = _e3404;
                                            phi_4392_ = _e3406;
                                            phi_4394_ = _e3408;
                                            phi_4396_ = _e3410;
                                            phi_6565_ = _e3369;
                                            phi_6567_ = _e3412;
                                            phi_6568_ = _e3414;
                                            phi_6569_ = _e3416;
                                            phi_6570_ = _e3418;
                                            phi_6572_ = false;
                                            phi_6573_ = _e3420;
                                        } else {
                                            phi_4386_ = f32();
                                            phi_4388_ = f32();
                                            phi_4390_ = f32();
                                            phi_4392_ = f32();
                                            phi_4394_ = bool();
                                            phi_4396_ = u32();
                                            phi_6565_ = f32();
                                            phi_6567_ = false;
                                            phi_6568_ = false;
                                            phi_6569_ = false;
                                            phi_6570_ = false;
                                            phi_6572_ = true;
                                            phi_6573_ = false;
                                        }
                                        let _e3422 = phi_4386_;
                                        let _e3424 = phi_4388_;
                                        let _e3426 = phi_4390_;
                                        let _e3428 = phi_4392_;
                                        let _e3430 = phi_4394_;
                                        let _e3432 = phi_4396_;
                                        let _e3434 = phi_6565_;
                                        let _e3436 = phi_6567_;
                                        let _e3438 = phi_6568_;
                                        let _e3440 = phi_6569_;
                                        let _e3442 = phi_6570_;
                                        let _e3444 = phi_6572_;
                                        let _e3446 = phi_6573_;
                                        local_20 = _e3438;
                                        local_21 = _e3440;
                                        local_22 = _e3438;
                                        local_23 = _e3442;
                                        local_24 = _e3438;
                                        local_25 = _e3444;
                                        local_26 = _e3438;
                                        local_27 = _e3446;
                                        local_29 = _e3438;
                                        local_30 = _e3434;
                                        continue;
                                        continuing {
                                            phi_4382_ = type_9(select(_e2418.member, (_e2418.member + 1u), _e2433), select(_e2418.member_1, _e2418.member_1, _e2433));
                                            phi_4385_ = _e3422;
                                            phi_4387_ = _e3424;
                                            phi_4389_ = _e3426;
                                            phi_4391_ = _e3428;
                                            phi_4393_ = _e3430;
                                            phi_4395_ = _e3432;
                                            break if !(_e3436);
                                        }
                                    }
                                    let _e3449 = local_20;
                                    let _e3451 = local_21;
                                    let _e3452 = select(_e3451, false, _e3449);
                                    let _e3454 = local_22;
                                    let _e3456 = local_23;
                                    let _e3459 = local_24;
                                    let _e3461 = local_25;
                                    let _e3464 = local_26;
                                    let _e3466 = local_27;
                                    let _e3472 = local_28;
                                    let _e3474 = select(select(_e3456, false, _e3454), false, _e3452);
                                    let _e3476 = local_29;
                                    let _e3483 = select(select(_e3476, false, _e3452), false, _e3474);
                                    let _e3488 = local_30;
                                    let _e3490 = local_31;
                                    let _e3492 = select(select(select(select(_e3461, false, _e3459), false, _e3452), false, _e3474), true, _e3483);
                                    let _e3499 = select(select(select(select(select(_e3466, false, _e3464), false, _e3452), false, _e3474), false, _e3483), false, _e3492);
                                    let _e3504 = select(select(select(select(_e3452, true, _e3474), false, _e3483), false, _e3492), true, _e3499);
                                    let _e3507 = (select(select(type_32().member, 1u, _e3492), select(select(select(type_32().member, 1u, _e3452), 0u, _e3474), 0u, _e3499), _e3504) != 0u);
                                    phi_6641_ = select(select(type_32().member_1, select(_e3490, _e3488, _e3483), _e3492), select(select(select(type_32().member_1, _e3472, _e3452), type_32().member_1, _e3474), type_32().member_1, _e3499), _e3504);
                                    phi_6642_ = select(true, false, _e3507);
                                    phi_6643_ = _e3507;
                                    phi_6644_ = false;
                                    phi_6645_ = false;
                                    phi_6646_ = false;
                                } else {
                                    phi_6641_ = f32();
                                    phi_6642_ = _e2205;
                                    phi_6643_ = false;
                                    phi_6644_ = _e2207;
                                    phi_6645_ = _e2209;
                                    phi_6646_ = _e2211;
                                }
                                let _e3510 = phi_6641_;
                                let _e3512 = phi_6642_;
                                let _e3514 = phi_6643_;
                                let _e3516 = phi_6644_;
                                let _e3518 = phi_6645_;
                                let _e3520 = phi_6646_;
                                phi_6647_ = _e2197;
                                phi_6648_ = _e2199;
                                phi_6649_ = _e3510;
                                phi_6650_ = _e2201;
                                phi_6651_ = _e3512;
                                phi_6652_ = _e3514;
                                phi_6653_ = false;
                                phi_6654_ = _e3516;
                                phi_6655_ = _e3518;
                                phi_6656_ = _e3520;
                            } else {
                                phi_6647_ = type_37();
                                phi_6648_ = bool();
                                phi_6649_ = f32();
                                phi_6650_ = type_37();
                                phi_6651_ = false;
                                phi_6652_ = false;
                                phi_6653_ = true;
                                phi_6654_ = false;
                                phi_6655_ = false;
                                phi_6656_ = false;
                            }
                            let _e3522 = phi_6647_;
                            let _e3524 = phi_6648_;
                            let _e3526 = phi_6649_;
                            let _e3528 = phi_6650_;
                            let _e3530 = phi_6651_;
                            let _e3532 = phi_6652_;
                            let _e3534 = phi_6653_;
                            let _e3536 = phi_6654_;
                            let _e3538 = phi_6655_;
                            let _e3540 = phi_6656_;
                            local_32 = _e3532;
                            local_33 = _e3524;
                            local_34 = _e3522;
                            local_35 = _e3526;
                            local_36 = _e3526;
                            local_37 = _e3526;
                            local_41 = _e3534;
                            local_42 = _e3536;
                            local_43 = _e3538;
                            local_44 = _e3540;
                            local_38 = _e3532;
                            local_39 = _e3528;
                            continue;
                            continuing {
                                phi_2527_ = type_9(select(_e1219.member, (_e1219.member + 1u), _e1222), select(_e1219.member_1, _e1219.member_1, _e1222));
                                break if !(_e3530);
                            }
                        }
                        let _e3543 = local_32;
                        if _e3543 {
                            let _e3545 = local_33;
                            if _e3545 {
                                let _e3547 = local_34;
                                let _e3550 = local_35;
                                let _e3552 = ((_e3547.member_1 - _e3550) <= _e1183);
                                let _e3557 = local_36;
                                phi_6672_ = type_32(select(type_32().member, 1u, _e3552), select(type_32().member_1, _e3557, _e3552));
                                phi_6673_ = select(true, false, _e3552);
                            } else {
                                phi_6672_ = type_32();
                                phi_6673_ = true;
                            }
                            let _e3562 = phi_6672_;
                            let _e3564 = phi_6673_;
                            let _e3569 = local_37;
                            phi_6679_ = type_32(select(_e3562.member, 2u, _e3564), select(_e3562.member_1, _e3569, _e3564));
                            phi_6680_ = false;
                            phi_6681_ = false;
                            phi_6682_ = false;
                            phi_6683_ = false;
                        } else {
                            phi_6679_ = type_32();
                            let _e4085 = local_41;
                            phi_6680_ = _e4085;
                            let _e4088 = local_42;
                            phi_6681_ = _e4088;
                            let _e4091 = local_43;
                            phi_6682_ = _e4091;
                            let _e4094 = local_44;
                            phi_6683_ = _e4094;
                        }
                        let _e3573 = phi_6679_;
                        let _e3575 = phi_6680_;
                        let _e3577 = phi_6681_;
                        let _e3579 = phi_6682_;
                        let _e3581 = phi_6683_;
                        let _e3588 = select(_e3577, false, _e3575);
                        let _e3592 = local_38;
                        let _e3599 = select(select(_e3579, false, _e3575), false, _e3588);
                        let _e3605 = select(select(select(_e3581, false, _e3575), false, _e3588), false, _e3599);
                        let _e3609 = local_39;
                        let _e3613 = select(select(_e3588, true, _e3599), true, _e3605);
                        phi_6725_ = type_32(select(_e3573.member, select(select(select(type_32().member, 0u, _e3588), 0u, _e3599), 1u, _e3605), _e3613), select(_e3573.member_1, select(select(select(type_32().member_1, type_32().member_1, _e3588), type_32().member_1, _e3599), _e3609.member, _e3605), _e3613));
                        phi_6726_ = type_32(select(type_32().member, 0u, _e3575), select(type_32().member_1, type_32().member_1, _e3575));
                        phi_6727_ = select(select(select(select(select(_e3592, false, _e3575), false, _e3588), false, _e3599), false, _e3605), true, _e3613);
                    }
                    let _e3624 = phi_6725_;
                    let _e3626 = phi_6726_;
                    let _e3628 = phi_6727_;
                    let _e3631 = select(_e3626.member, _e3624.member, _e3628);
                    let _e3634 = select(_e3626.member_1, _e3624.member_1, _e3628);
                    let _e3640 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e3634 > _e354)), (_e3631 == 1u))));
                    switch bitcast<i32>(_e3631) {
                        case 0: {
                            phi_6771_ = type_30(0u, _e3640, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e3644 = function_3(_e3634);
                            phi_6771_ = type_30(0u, _e3640, _e3644, true);
                            break;
                        }
                        case 2: {
                            let _e3642 = function_3(_e3634);
                            phi_6771_ = type_30(1u, _e3640, _e3642, true);
                            break;
                        }
                        default: {
                            phi_6771_ = type_30();
                            break;
                        }
                    }
                    let _e3648 = phi_6771_;
                    let _e3652 = params.member.member.member_12;
                    let _e3653 = bitcast<u32>(_e3652);
                    if (_e3648.member_2[0] == select((_e3653 << bitcast<u32>(29i)), 0u, ((_e3653 & 2147483647u) < 8388608u))) {
                        let _e3663 = params.member.member.member_12;
                        let _e3664 = bitcast<u32>(_e3663);
                        let _e3665 = (_e3664 & 2147483647u);
                        phi_6811_ = (_e3648.member_2[1] == select(((_e3664 ^ _e3665) | ((_e3665 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e3665 < 8388608u)));
                    } else {
                        phi_6811_ = false;
                    }
                    let _e3675 = phi_6811_;
                    let _e3677 = params.member.member.member_1;
                    if ((_e3677 & 128u) != 0u) {
                        phi_6827_ = true;
                    } else {
                        let _e3681 = params.member.member.member_1;
                        phi_6827_ = select(false, _e3675, ((_e3681 & 64u) != 0u));
                    }
                    let _e3686 = phi_6827_;
                    phi_6846_ = type_30(select(1u, _e3648.member, select(true, select(true, false, _e3686), _e3648.member_3)), _e3648.member_1, _e3648.member_2, _e3648.member_3);
                }
                let _e3697 = phi_6846_;
                phi_6847_ = _e3697;
                phi_6848_ = type_9(_e191, _e190);
            } else {
                phi_6847_ = type_30(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_6848_ = type_9(0u, 0u);
            }
            let _e3699 = phi_6847_;
            let _e3701 = phi_6848_;
            let _e3705 = (_e3699.member != 0u);
            let _e3708 = select(false, !(_e3705), _e3699.member_3);
            if _e3708 {
                let _e3712 = (_e3699.member_2[1] >> bitcast<u32>(20i));
                if (_e3712 <= 896u) {
                    phi_6878_ = 0u;
                } else {
                    phi_6878_ = ((((_e3712 - 896u) << bitcast<u32>(23i)) | ((_e3699.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e3699.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e3727 = phi_6878_;
                let _e3729 = atomicMin((&earliest.member[0u]), _e3727);
            }
            let _e3732 = params.member.member.member_1;
            if ((_e3732 & 16u) != 0u) {
                if (_e104 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e3708 {
                    let _e3738 = atomicAdd((&counters[0u]), 1u);
                    phi_6900_ = _e3738;
                } else {
                    phi_6900_ = 0u;
                }
                let _e3740 = phi_6900_;
                workgroupBarrier();
                if (_e104 == 0u) {
                    let _e3743 = atomicLoad((&counters[0u]));
                    if (_e3743 > 0u) {
                        let _e3746 = atomicAdd((&contacts.member[0u]), _e3743);
                        atomicStore((&counters[1u]), _e3746);
                    }
                }
                workgroupBarrier();
                let _e3749 = atomicLoad((&counters[1u]));
                let _e3750 = (_e3749 + _e3740);
                if _e3708 {
                    let _e3753 = params.member.member_1.member_3;
                    let _e3755 = params.member.member_2.member;
                    if (_e3750 < _e3753) {
                        let _e3757 = (7u * _e3750);
                        atomicStore((&contacts.member[(4u + _e3757)]), _e3755);
                        atomicStore((&contacts.member[(_e3757 + 5u)]), _e3699.member);
                        atomicStore((&contacts.member[(_e3757 + 6u)]), _e3701.member);
                        atomicStore((&contacts.member[(_e3757 + 7u)]), _e3701.member_1);
                        atomicStore((&contacts.member[(_e3757 + 8u)]), _e3699.member_2[0]);
                        atomicStore((&contacts.member[(_e3757 + 9u)]), _e3699.member_2[1]);
                        atomicStore((&contacts.member[(_e3757 + 10u)]), _e3699.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e104 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e3705 {
                let _e3781 = atomicAdd((&counters[0u]), 1u);
                phi_6966_ = _e3781;
            } else {
                phi_6966_ = 0u;
            }
            let _e3783 = phi_6966_;
            workgroupBarrier();
            if (_e104 == 0u) {
                let _e3786 = atomicLoad((&counters[0u]));
                if (_e3786 > 0u) {
                    let _e3789 = atomicAdd((&undecided.member[0u]), _e3786);
                    atomicStore((&counters[1u]), _e3789);
                }
            }
            workgroupBarrier();
            let _e3792 = atomicLoad((&counters[1u]));
            let _e3793 = (_e3792 + _e3783);
            if _e3705 {
                let _e3795 = params.member.member_2.member_1;
                if (_e3793 < _e3795) {
                    let _e3797 = (2u * _e3793);
                    atomicStore((&undecided.member[(4u + _e3797)]), _e3701.member);
                    atomicStore((&undecided.member[(_e3797 + 5u)]), _e3701.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_828_ = type_9(select(_e158.member, (_e158.member + 1u), _e161), select(_e158.member_1, _e158.member_1, _e161));
            break if !(_e174);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
