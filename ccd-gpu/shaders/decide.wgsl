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
    member: type_28,
    member_1: f32,
}

struct type_31 {
    member: u32,
    member_1: f32,
}

struct type_32 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
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
    var phi_665_: array<array<f32, 3>, 4>;

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
        phi_665_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e155)), (param_2[1] - (param_3[1] * _e155)), (param_2[2] - (param_3[2] * _e155))), array<f32, 3>((param_2[0] - (param_4[0] * _e195)), (param_2[1] - (param_4[1] * _e195)), (param_2[2] - (param_4[2] * _e195))), array<f32, 3>((_e9 - (param_4[0] * _e232)), (_e12 - (param_4[1] * _e232)), (_e15 - (param_4[2] * _e232))), array<f32, 3>((_e245 - (param_3[0] * _e275)), (_e248 - (param_3[1] * _e275)), (_e251 - (param_3[2] * _e275))));
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
        phi_665_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e74)), (param_2[1] - (param_3[1] * _e74)), (param_2[2] - (param_3[2] * _e74))), array<f32, 3>((param_2[0] - (param_4[0] * _e114)), (param_2[1] - (param_4[1] * _e114)), (param_2[2] - (param_4[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_665_;
    let _e291 = function_(_e288[0], _e288[1]);
    let _e293 = function_(_e291, _e288[2]);
    let _e295 = function_(_e293, _e288[3]);
    return _e295;
}

fn function_2(param_6: array<f32, 3>, param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: u32) -> array<f32, 3> {
    var phi_293_: bool;
    var phi_326_: array<f32, 3>;
    var phi_327_: bool;
    var phi_328_: array<f32, 3>;
    var phi_329_: bool;
    var phi_334_: array<f32, 3>;

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
        phi_293_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_293_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_293_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_326_ = array<f32, 3>((param_6[0] - ((param_7[0] * _e74) + (param_8[0] * _e78))), (param_6[1] - ((param_7[1] * _e74) + (param_8[1] * _e78))), (param_6[2] - ((param_7[2] * _e74) + (param_8[2] * _e78))));
            phi_327_ = false;
        } else {
            phi_326_ = array<f32, 3>();
            phi_327_ = true;
        }
        let _e129 = phi_326_;
        let _e131 = phi_327_;
        phi_328_ = _e129;
        phi_329_ = _e131;
    } else {
        phi_328_ = array<f32, 3>();
        phi_329_ = true;
    }
    let _e133 = phi_328_;
    let _e135 = phi_329_;
    if _e135 {
        let _e136 = function_1(param_6, param_7, param_8, param_9);
        phi_334_ = _e136;
    } else {
        phi_334_ = _e133;
    }
    let _e138 = phi_334_;
    return _e138;
}

fn function_3(param_10: f32) -> array<u32, 2> {
    let _e7 = bitcast<u32>(param_10);
    let _e8 = (_e7 & 2147483647u);
    let _e9 = (_e8 < 8388608u);
    return array<u32, 2>(select((_e7 << bitcast<u32>(29i)), 0u, _e9), select(((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e9));
}

fn function_4(param_11: ptr<function, type_35>, param_12: f32, param_13: f32, param_14: f32) -> bool {
    var phi_7076_: bool;
    var phi_7077_: bool;
    var phi_7082_: bool;

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
            phi_7076_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_7077_ = select(true, false, _e84);
        } else {
            phi_7076_ = bool();
            phi_7077_ = true;
        }
        let _e91 = phi_7076_;
        let _e93 = phi_7077_;
        phi_7082_ = select(_e91, false, _e93);
    } else {
        phi_7082_ = false;
    }
    let _e96 = phi_7082_;
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
    var phi_775_: u32;
    var phi_821_: u32;
    var phi_824_: type_9;
    var phi_981_: type_22;
    var phi_1116_: type_28;
    var phi_1384_: bool;
    var phi_1478_: type_30;
    var phi_1479_: bool;
    var phi_1480_: type_30;
    var phi_1481_: bool;
    var phi_1482_: type_30;
    var phi_1483_: bool;
    var phi_1488_: type_30;
    var phi_2213_: bool;
    var phi_2225_: f32;
    var phi_2296_: type_16;
    var phi_2299_: f32;
    var phi_2297_: type_16;
    var phi_2340_: type_17;
    var phi_2300_: f32;
    var local_8: f32;
    var phi_2353_: f32;
    var phi_2384_: type_9;
    var phi_2387_: u32;
    var phi_2454_: u32;
    var phi_2455_: u32;
    var phi_2388_: u32;
    var phi_2456_: u32;
    var phi_2512_: type_9;
    var phi_2668_: type_37;
    var phi_2669_: bool;
    var phi_2670_: type_37;
    var phi_2671_: bool;
    var phi_2702_: type_9;
    var phi_2705_: f32;
    var phi_2707_: f32;
    var phi_2709_: f32;
    var phi_2819_: bool;
    var phi_2826_: f32;
    var phi_2827_: bool;
    var phi_2706_: f32;
    var phi_2708_: f32;
    var phi_2710_: f32;
    var phi_2828_: f32;
    var phi_2829_: bool;
    var phi_2830_: bool;
    var local_9: bool;
    var local_10: f32;
    var local_11: f32;
    var phi_2835_: f32;
    var phi_2851_: type_9;
    var phi_2854_: f32;
    var phi_2919_: f32;
    var phi_2920_: bool;
    var phi_2921_: bool;
    var phi_2922_: bool;
    var phi_2923_: f32;
    var phi_2855_: f32;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: f32;
    var phi_2941_: f32;
    var phi_2943_: type_37;
    var phi_3780_: array<type_18, 4>;
    var phi_3800_: type_9;
    var phi_3803_: bool;
    var phi_3804_: bool;
    var phi_3855_: bool;
    var phi_3856_: bool;
    var local_17: bool;
    var local_18: bool;
    var phi_3870_: u32;
    var phi_3871_: u32;
    var phi_3872_: bool;
    var phi_3903_: bool;
    var phi_3904_: bool;
    var phi_3905_: bool;
    var phi_3906_: bool;
    var phi_3907_: bool;
    var phi_3908_: bool;
    var phi_3909_: bool;
    var phi_3910_: bool;
    var phi_3911_: bool;
    var phi_3912_: bool;
    var phi_3913_: bool;
    var phi_3914_: bool;
    var phi_3915_: type_37;
    var phi_3916_: bool;
    var phi_3917_: type_37;
    var phi_3918_: bool;
    var phi_3919_: bool;
    var phi_3920_: bool;
    var phi_3921_: bool;
    var phi_3922_: type_37;
    var phi_3923_: bool;
    var phi_3924_: type_37;
    var phi_3925_: bool;
    var phi_3926_: bool;
    var phi_3927_: bool;
    var phi_3928_: bool;
    var phi_3929_: bool;
    var phi_3937_: type_37;
    var phi_3938_: bool;
    var phi_3939_: type_37;
    var phi_3940_: bool;
    var phi_3941_: bool;
    var phi_3942_: bool;
    var phi_3943_: bool;
    var phi_3944_: bool;
    var phi_4367_: type_9;
    var phi_4370_: f32;
    var phi_4372_: f32;
    var phi_4374_: f32;
    var phi_4376_: f32;
    var phi_4378_: bool;
    var phi_4380_: u32;
    var phi_4531_: array<f32, 3>;
    var phi_4597_: type_16;
    var phi_4600_: f32;
    var phi_4598_: type_16;
    var phi_4641_: type_17;
    var phi_4601_: f32;
    var local_19: f32;
    var phi_4654_: f32;
    var phi_4777_: type_29;
    var phi_4778_: bool;
    var phi_4779_: type_29;
    var phi_4780_: bool;
    var phi_4788_: type_29;
    var phi_4959_: bool;
    var phi_4960_: bool;
    var phi_4961_: bool;
    var phi_4962_: bool;
    var phi_4963_: bool;
    var phi_4964_: bool;
    var phi_5265_: bool;
    var phi_5266_: bool;
    var phi_5267_: bool;
    var phi_5268_: bool;
    var phi_5269_: bool;
    var phi_5270_: bool;
    var phi_5278_: bool;
    var phi_5385_: f32;
    var phi_5386_: bool;
    var phi_5387_: f32;
    var phi_5388_: bool;
    var phi_5389_: f32;
    var phi_5390_: bool;
    var phi_5391_: bool;
    var phi_5453_: f32;
    var phi_5454_: bool;
    var phi_5455_: f32;
    var phi_5456_: bool;
    var phi_5457_: f32;
    var phi_5458_: bool;
    var phi_5459_: bool;
    var phi_5526_: f32;
    var phi_5527_: bool;
    var phi_5528_: f32;
    var phi_5529_: bool;
    var phi_5530_: f32;
    var phi_5531_: bool;
    var phi_5532_: bool;
    var phi_5594_: f32;
    var phi_5595_: bool;
    var phi_5596_: f32;
    var phi_5597_: bool;
    var phi_5598_: f32;
    var phi_5599_: bool;
    var phi_5600_: bool;
    var phi_6129_: f32;
    var phi_6130_: f32;
    var phi_6131_: bool;
    var phi_6133_: f32;
    var phi_6134_: f32;
    var phi_6135_: f32;
    var phi_6137_: bool;
    var phi_6138_: bool;
    var phi_6140_: bool;
    var phi_6141_: f32;
    var phi_6142_: f32;
    var phi_6143_: f32;
    var phi_6145_: bool;
    var phi_6146_: bool;
    var phi_6147_: bool;
    var phi_6149_: bool;
    var phi_6150_: f32;
    var phi_6151_: f32;
    var phi_6152_: f32;
    var phi_6154_: bool;
    var phi_6155_: bool;
    var phi_6156_: bool;
    var phi_6158_: bool;
    var phi_6491_: f32;
    var phi_6493_: u32;
    var phi_6494_: f32;
    var phi_6495_: bool;
    var phi_6496_: bool;
    var phi_6497_: bool;
    var phi_6498_: u32;
    var phi_6499_: f32;
    var phi_6500_: f32;
    var phi_6501_: f32;
    var phi_6502_: f32;
    var phi_6503_: bool;
    var phi_6504_: u32;
    var phi_6505_: bool;
    var phi_6506_: bool;
    var phi_6507_: bool;
    var phi_6508_: bool;
    var phi_6510_: bool;
    var phi_6538_: f32;
    var phi_6539_: f32;
    var phi_6540_: f32;
    var phi_6541_: f32;
    var phi_6542_: bool;
    var phi_6543_: u32;
    var phi_6544_: bool;
    var phi_6545_: bool;
    var phi_6546_: bool;
    var phi_6547_: bool;
    var phi_6549_: bool;
    var phi_4371_: f32;
    var phi_4373_: f32;
    var phi_4375_: f32;
    var phi_4377_: f32;
    var phi_4379_: bool;
    var phi_4381_: u32;
    var phi_6550_: f32;
    var phi_6552_: bool;
    var phi_6553_: bool;
    var phi_6554_: bool;
    var phi_6555_: bool;
    var phi_6557_: bool;
    var phi_6558_: bool;
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
    var phi_6626_: f32;
    var phi_6627_: bool;
    var phi_6628_: bool;
    var phi_6629_: bool;
    var phi_6630_: bool;
    var phi_6631_: bool;
    var phi_6632_: type_37;
    var phi_6633_: bool;
    var phi_6634_: f32;
    var phi_6635_: type_37;
    var phi_6636_: bool;
    var phi_6637_: bool;
    var phi_6638_: bool;
    var phi_6639_: bool;
    var phi_6640_: bool;
    var phi_6641_: bool;
    var local_32: bool;
    var local_33: bool;
    var local_34: type_37;
    var local_35: f32;
    var local_36: f32;
    var phi_6657_: type_31;
    var phi_6658_: bool;
    var local_37: f32;
    var phi_6664_: type_31;
    var phi_6665_: bool;
    var phi_6666_: bool;
    var phi_6667_: bool;
    var phi_6668_: bool;
    var local_38: bool;
    var local_39: type_37;
    var phi_6710_: type_31;
    var phi_6711_: type_31;
    var phi_6712_: bool;
    var phi_6756_: type_32;
    var phi_6796_: bool;
    var phi_6812_: bool;
    var phi_6831_: type_32;
    var phi_6832_: type_9;
    var phi_6862_: u32;
    var phi_6884_: u32;
    var phi_6950_: u32;
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
    let _e100 = id_2;
    let _e101 = n_2;
    let _e102 = lane_2;
    let _e114 = ((_e100.y * _e101.x) + _e100.x);
    let _e117 = (_e101.x * _e101.y);
    let _e120 = params.member.member_1.member_2;
    let _e122 = input.member[0u];
    let _e124 = select(_e122, _e120, (_e120 < _e122));
    let _e126 = params.member.member_1.member_1;
    if (_e124 > _e126) {
        let _e129 = params.member.member_1.member_1;
        phi_775_ = (_e124 - _e129);
    } else {
        phi_775_ = 0u;
    }
    let _e132 = phi_775_;
    let _e134 = params.member.member_1.member;
    let _e136 = select(_e132, _e134, (_e134 < _e132));
    let _e138 = (_e136 / 64u);
    let _e142 = select(_e138, (_e138 + 1u), ((_e136 % 64u) > 0u));
    if (_e142 > _e114) {
        let _e144 = (_e142 - _e114);
        if (_e117 == 0u) {
            return;
        }
        let _e146 = (_e144 / _e117);
        if (_e117 == 0u) {
            return;
        }
        phi_821_ = select(_e146, (_e146 + 1u), ((_e144 % _e117) > 0u));
    } else {
        phi_821_ = 0u;
    }
    let _e153 = phi_821_;
    phi_824_ = type_9(0u, _e153);
    loop {
        let _e156 = phi_824_;
        let _e159 = (_e156.member < _e156.member_1);
        let _e172 = (bitcast<i32>(select(0u, 1u, _e159)) != 0i);
        if _e172 {
            let _e176 = (((_e114 + (select(type_9().member_1, _e156.member, _e159) * _e117)) * 64u) + _e102);
            if (_e176 < _e136) {
                let _e180 = params.member.member_1.member_1;
                let _e182 = (2u * (_e180 + _e176));
                let _e185 = input.member[(4u + _e182)];
                let _e188 = input.member[(_e182 + 5u)];
                let _e191 = params.member.member_2.member;
                if (_e191 == 0u) {
                    let _e208 = (3u * _e188);
                    let _e210 = elements.member[_e208];
                    let _e213 = elements.member[(_e208 + 1u)];
                    let _e216 = elements.member[(_e208 + 2u)];
                    phi_981_ = type_22(0u, array<u32, 4>(_e185, _e210, _e213, _e216));
                } else {
                    let _e194 = (2u * _e185);
                    let _e195 = (2u * _e188);
                    let _e197 = elements.member[_e194];
                    let _e199 = elements.member[_e195];
                    let _e202 = elements.member[(_e194 + 1u)];
                    let _e205 = elements.member[(_e195 + 1u)];
                    phi_981_ = type_22(1u, array<u32, 4>(_e197, _e202, _e199, _e205));
                }
                let _e220 = phi_981_;
                let _e225 = paths.member[_e220.member_1[0]];
                let _e240 = paths.member[_e220.member_1[1]];
                let _e255 = paths.member[_e220.member_1[2]];
                let _e270 = paths.member[_e220.member_1[3]];
                let _e284 = params.member.member.member_4;
                if (_e220.member != 0u) {
                    phi_1116_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e255.member.x - _e225.member.x), (_e255.member.y - _e225.member.y), (_e255.member.z - _e225.member.z)), array<f32, 3>((_e255.member_1.x - _e225.member_1.x), (_e255.member_1.y - _e225.member_1.y), (_e255.member_1.z - _e225.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e240.member.x - _e225.member.x), (_e240.member.y - _e225.member.y), (_e240.member.z - _e225.member.z)), array<f32, 3>((_e240.member_1.x - _e225.member_1.x), (_e240.member_1.y - _e225.member_1.y), (_e240.member_1.z - _e225.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e255.member.x - _e270.member.x), (_e255.member.y - _e270.member.y), (_e255.member.z - _e270.member.z)), array<f32, 3>((_e255.member_1.x - _e270.member_1.x), (_e255.member_1.y - _e270.member_1.y), (_e255.member_1.z - _e270.member_1.z))), (_e284 + _e284));
                } else {
                    phi_1116_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e225.member.x - _e240.member.x), (_e225.member.y - _e240.member.y), (_e225.member.z - _e240.member.z)), array<f32, 3>((_e225.member_1.x - _e240.member_1.x), (_e225.member_1.y - _e240.member_1.y), (_e225.member_1.z - _e240.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e255.member.x - _e240.member.x), (_e255.member.y - _e240.member.y), (_e255.member.z - _e240.member.z)), array<f32, 3>((_e255.member_1.x - _e240.member_1.x), (_e255.member_1.y - _e240.member_1.y), (_e255.member_1.z - _e240.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e270.member.x - _e240.member.x), (_e270.member.y - _e240.member.y), (_e270.member.z - _e240.member.z)), array<f32, 3>((_e270.member_1.x - _e240.member_1.x), (_e270.member_1.y - _e240.member_1.y), (_e270.member_1.z - _e240.member_1.z))), (_e284 + _e284));
                }
                let _e345 = phi_1116_;
                let _e347 = params.member.member.member_11;
                let _e349 = params.member.member.member_12;
                let _e351 = params.member.member.member_13;
                let _e353 = params.member.member.member_13;
                let _e359 = select(_e345.member[0][0], -(_e345.member[0][0]), (_e345.member[0][0] < 0f));
                let _e363 = select(_e345.member[0][1], -(_e345.member[0][1]), (_e345.member[0][1] < 0f));
                let _e365 = select(_e363, _e359, (_e359 > _e363));
                let _e369 = select(_e345.member[0][2], -(_e345.member[0][2]), (_e345.member[0][2] < 0f));
                let _e371 = select(_e369, _e365, (_e365 > _e369));
                let _e377 = select(_e345.member[1][0], -(_e345.member[1][0]), (_e345.member[1][0] < 0f));
                let _e381 = select(_e345.member[1][1], -(_e345.member[1][1]), (_e345.member[1][1] < 0f));
                let _e383 = select(_e381, _e377, (_e377 > _e381));
                let _e387 = select(_e345.member[1][2], -(_e345.member[1][2]), (_e345.member[1][2] < 0f));
                let _e389 = select(_e387, _e383, (_e383 > _e387));
                let _e393 = (select(_e389, _e371, (_e371 > _e389)) + _e345.member_3);
                let _e399 = select(_e345.member_1[0][0], -(_e345.member_1[0][0]), (_e345.member_1[0][0] < 0f));
                let _e403 = select(_e345.member_1[0][1], -(_e345.member_1[0][1]), (_e345.member_1[0][1] < 0f));
                let _e405 = select(_e403, _e399, (_e399 > _e403));
                let _e409 = select(_e345.member_1[0][2], -(_e345.member_1[0][2]), (_e345.member_1[0][2] < 0f));
                let _e411 = select(_e409, _e405, (_e405 > _e409));
                let _e417 = select(_e345.member_1[1][0], -(_e345.member_1[1][0]), (_e345.member_1[1][0] < 0f));
                let _e421 = select(_e345.member_1[1][1], -(_e345.member_1[1][1]), (_e345.member_1[1][1] < 0f));
                let _e423 = select(_e421, _e417, (_e417 > _e421));
                let _e427 = select(_e345.member_1[1][2], -(_e345.member_1[1][2]), (_e345.member_1[1][2] < 0f));
                let _e429 = select(_e427, _e423, (_e423 > _e427));
                let _e433 = (select(_e429, _e411, (_e411 > _e429)) + _e345.member_3);
                let _e439 = select(_e345.member_2[0][0], -(_e345.member_2[0][0]), (_e345.member_2[0][0] < 0f));
                let _e443 = select(_e345.member_2[0][1], -(_e345.member_2[0][1]), (_e345.member_2[0][1] < 0f));
                let _e445 = select(_e443, _e439, (_e439 > _e443));
                let _e449 = select(_e345.member_2[0][2], -(_e345.member_2[0][2]), (_e345.member_2[0][2] < 0f));
                let _e451 = select(_e449, _e445, (_e445 > _e449));
                let _e457 = select(_e345.member_2[1][0], -(_e345.member_2[1][0]), (_e345.member_2[1][0] < 0f));
                let _e461 = select(_e345.member_2[1][1], -(_e345.member_2[1][1]), (_e345.member_2[1][1] < 0f));
                let _e463 = select(_e461, _e457, (_e457 > _e461));
                let _e467 = select(_e345.member_2[1][2], -(_e345.member_2[1][2]), (_e345.member_2[1][2] < 0f));
                let _e469 = select(_e467, _e463, (_e463 > _e467));
                let _e473 = (select(_e469, _e451, (_e451 > _e469)) + _e345.member_3);
                let _e475 = select(_e433, _e393, (_e393 > _e433));
                let _e477 = select(_e473, _e475, (_e475 > _e473));
                if (_e477 <= 65536f) {
                    phi_1384_ = (_e477 >= (1f / 65536f));
                } else {
                    phi_1384_ = false;
                }
                let _e482 = phi_1384_;
                if _e482 {
                    phi_1482_ = type_30();
                    phi_1483_ = true;
                } else {
                    if (_e477 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e477) & 2139095040u) != 2139095040u) {
                            let _e489 = (2130706432u - (bitcast<u32>(_e477) & 2139095040u));
                            let _e492 = bitcast<f32>(select(8388608u, _e489, (_e489 > 8388608u)));
                            phi_1478_ = type_30(type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e345.member[0][0] * _e492), (_e345.member[0][1] * _e492), (_e345.member[0][2] * _e492)), array<f32, 3>((_e345.member[1][0] * _e492), (_e345.member[1][1] * _e492), (_e345.member[1][2] * _e492))), array<array<f32, 3>, 2>(array<f32, 3>((_e345.member_1[0][0] * _e492), (_e345.member_1[0][1] * _e492), (_e345.member_1[0][2] * _e492)), array<f32, 3>((_e345.member_1[1][0] * _e492), (_e345.member_1[1][1] * _e492), (_e345.member_1[1][2] * _e492))), array<array<f32, 3>, 2>(array<f32, 3>((_e345.member_2[0][0] * _e492), (_e345.member_2[0][1] * _e492), (_e345.member_2[0][2] * _e492)), array<f32, 3>((_e345.member_2[1][0] * _e492), (_e345.member_2[1][1] * _e492), (_e345.member_2[1][2] * _e492))), ((_e345.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e492)), (0f * _e492));
                            phi_1479_ = false;
                        } else {
                            phi_1478_ = type_30();
                            phi_1479_ = true;
                        }
                        let _e558 = phi_1478_;
                        let _e560 = phi_1479_;
                        phi_1480_ = _e558;
                        phi_1481_ = _e560;
                    } else {
                        phi_1480_ = type_30();
                        phi_1481_ = true;
                    }
                    let _e562 = phi_1480_;
                    let _e564 = phi_1481_;
                    phi_1482_ = _e562;
                    phi_1483_ = _e564;
                }
                let _e566 = phi_1482_;
                let _e568 = phi_1483_;
                if _e568 {
                    phi_1488_ = type_30(_e345, 0f);
                } else {
                    phi_1488_ = _e566;
                }
                let _e571 = phi_1488_;
                local_7 = type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e571.member.member[0][0], _e571.member.member[0][1], _e571.member.member[0][2]), array<f32, 3>(_e571.member.member[1][0], _e571.member.member[1][1], _e571.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e571.member.member_1[0][0], _e571.member.member_1[0][1], _e571.member.member_1[0][2]), array<f32, 3>(_e571.member.member_1[1][0], _e571.member.member_1[1][1], _e571.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e571.member.member_2[0][0], _e571.member.member_2[0][1], _e571.member.member_2[0][2]), array<f32, 3>(_e571.member.member_2[1][0], _e571.member.member_2[1][1], _e571.member.member_2[1][2])), _e571.member.member_3);
                let _e613 = local_7.member_1[0u];
                let _e619 = local_7.member_2[0u];
                let _e625 = ((_e613[1] * _e619[2]) - (_e613[2] * _e619[1]));
                let _e628 = ((_e613[2] * _e619[0]) - (_e613[0] * _e619[2]));
                let _e631 = ((_e613[0] * _e619[1]) - (_e613[1] * _e619[0]));
                let _e634 = local_7.member_1[1u];
                let _e640 = local_7.member_2[1u];
                let _e646 = ((_e634[1] * _e640[2]) - (_e634[2] * _e640[1]));
                let _e649 = ((_e634[2] * _e640[0]) - (_e634[0] * _e640[2]));
                let _e652 = ((_e634[0] * _e640[1]) - (_e634[1] * _e640[0]));
                let _e655 = local_7.member_1[0u];
                let _e661 = local_7.member_2[1u];
                let _e676 = local_7.member_1[1u];
                let _e682 = local_7.member_2[0u];
                let _e695 = (((_e655[1] * _e661[2]) - (_e655[2] * _e661[1])) + ((_e676[1] * _e682[2]) - (_e676[2] * _e682[1])));
                let _e696 = (((_e655[2] * _e661[0]) - (_e655[0] * _e661[2])) + ((_e676[2] * _e682[0]) - (_e676[0] * _e682[2])));
                let _e697 = (((_e655[0] * _e661[1]) - (_e655[1] * _e661[0])) + ((_e676[0] * _e682[1]) - (_e676[1] * _e682[0])));
                let _e700 = local_7.member[0u];
                let _e708 = (((_e700[0] * _e625) + (_e700[1] * _e628)) + (_e700[2] * _e631));
                let _e711 = local_7.member[1u];
                let _e722 = local_7.member[0u];
                let _e731 = ((((_e711[0] * _e625) + (_e711[1] * _e628)) + (_e711[2] * _e631)) + (((_e722[0] * _e695) + (_e722[1] * _e696)) + (_e722[2] * _e697)));
                let _e734 = local_7.member[0u];
                let _e745 = local_7.member[1u];
                let _e754 = ((((_e734[0] * _e646) + (_e734[1] * _e649)) + (_e734[2] * _e652)) + (((_e745[0] * _e695) + (_e745[1] * _e696)) + (_e745[2] * _e697)));
                let _e757 = local_7.member[1u];
                let _e765 = (((_e757[0] * _e646) + (_e757[1] * _e649)) + (_e757[2] * _e652));
                let _e768 = local_7.member[0u];
                let _e774 = select(_e768[0], -(_e768[0]), (_e768[0] < 0f));
                let _e777 = select(_e768[1], -(_e768[1]), (_e768[1] < 0f));
                let _e779 = select(_e777, _e774, (_e774 > _e777));
                let _e782 = select(_e768[2], -(_e768[2]), (_e768[2] < 0f));
                let _e784 = select(_e782, _e779, (_e779 > _e782));
                let _e787 = local_7.member[1u];
                let _e793 = select(_e787[0], -(_e787[0]), (_e787[0] < 0f));
                let _e796 = select(_e787[1], -(_e787[1]), (_e787[1] < 0f));
                let _e798 = select(_e796, _e793, (_e793 > _e796));
                let _e801 = select(_e787[2], -(_e787[2]), (_e787[2] < 0f));
                let _e803 = select(_e801, _e798, (_e798 > _e801));
                let _e807 = local_7.member_3;
                let _e808 = (select(_e803, _e784, (_e784 > _e803)) + _e807);
                let _e811 = local_7.member_1[0u];
                let _e817 = select(_e811[0], -(_e811[0]), (_e811[0] < 0f));
                let _e820 = select(_e811[1], -(_e811[1]), (_e811[1] < 0f));
                let _e822 = select(_e820, _e817, (_e817 > _e820));
                let _e825 = select(_e811[2], -(_e811[2]), (_e811[2] < 0f));
                let _e827 = select(_e825, _e822, (_e822 > _e825));
                let _e830 = local_7.member_1[1u];
                let _e836 = select(_e830[0], -(_e830[0]), (_e830[0] < 0f));
                let _e839 = select(_e830[1], -(_e830[1]), (_e830[1] < 0f));
                let _e841 = select(_e839, _e836, (_e836 > _e839));
                let _e844 = select(_e830[2], -(_e830[2]), (_e830[2] < 0f));
                let _e846 = select(_e844, _e841, (_e841 > _e844));
                let _e850 = local_7.member_3;
                let _e851 = (select(_e846, _e827, (_e827 > _e846)) + _e850);
                let _e854 = local_7.member_2[0u];
                let _e860 = select(_e854[0], -(_e854[0]), (_e854[0] < 0f));
                let _e863 = select(_e854[1], -(_e854[1]), (_e854[1] < 0f));
                let _e865 = select(_e863, _e860, (_e860 > _e863));
                let _e868 = select(_e854[2], -(_e854[2]), (_e854[2] < 0f));
                let _e870 = select(_e868, _e865, (_e865 > _e868));
                let _e873 = local_7.member_2[1u];
                let _e879 = select(_e873[0], -(_e873[0]), (_e873[0] < 0f));
                let _e882 = select(_e873[1], -(_e873[1]), (_e873[1] < 0f));
                let _e884 = select(_e882, _e879, (_e879 > _e882));
                let _e887 = select(_e873[2], -(_e873[2]), (_e873[2] < 0f));
                let _e889 = select(_e887, _e884, (_e884 > _e887));
                let _e893 = local_7.member_3;
                let _e894 = (select(_e889, _e870, (_e870 > _e889)) + _e893);
                let _e896 = ((_e851 * 8f) * _e894);
                let _e903 = local_7.member_3;
                let _e927 = ((select(_e625, -(_e625), (_e625 < 0f)) + select(_e628, -(_e628), (_e628 < 0f))) + select(_e631, -(_e631), (_e631 < 0f)));
                let _e938 = ((select(_e646, -(_e646), (_e646 < 0f)) + select(_e649, -(_e649), (_e649 < 0f))) + select(_e652, -(_e652), (_e652 < 0f)));
                let _e940 = select(_e938, _e927, (_e927 > _e938));
                let _e952 = (((select(_e695, -(_e695), (_e695 < 0f)) + select(_e696, -(_e696), (_e696 < 0f))) + select(_e697, -(_e697), (_e697 < 0f))) * 0.5f);
                let _e959 = local_7.member_3;
                let _e971 = (((((_e808 * 8f) * _e896) * (0.000000059604645f * (524f / 64f))) + ((_e903 * 19f) * ((_e808 * (_e851 + _e894)) + (_e851 * _e894)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e808) * ((1f + _e851) * (1f + _e894)))));
                let _e972 = (_e708 * 3f);
                let _e973 = (_e765 * 3f);
                let _e975 = select(_e973, _e972, (_e972 < _e973));
                let _e977 = select(_e754, _e731, (_e731 < _e754));
                let _e979 = select(_e977, _e975, (_e975 < _e977));
                let _e981 = select(_e973, _e972, (_e972 > _e973));
                let _e983 = select(_e754, _e731, (_e731 > _e754));
                let _e990 = -(select(_e983, _e981, (_e981 > _e983)));
                if ((select(_e990, _e979, (_e979 > _e990)) - (_e971 + ((0f * (((select(_e952, _e940, (_e940 > _e952)) + (_e896 * (0.000000059604645f * 8f))) + ((_e959 * 6f) * (_e851 + _e894))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e851) * (1f + _e894))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6710_ = type_31(0u, type_31().member_1);
                    phi_6711_ = type_31();
                    phi_6712_ = true;
                } else {
                    let _e998 = select(_e708, -(_e708), (_e708 < 0f));
                    let _e1001 = select(_e731, -(_e731), (_e731 < 0f));
                    let _e1003 = select(_e1001, _e998, (_e998 > _e1001));
                    let _e1006 = select(_e754, -(_e754), (_e754 < 0f));
                    let _e1009 = select(_e765, -(_e765), (_e765 < 0f));
                    let _e1011 = select(_e1009, _e1006, (_e1006 > _e1009));
                    let _e1013 = select(_e1011, _e1003, (_e1003 > _e1011));
                    let _e1014 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                    if (_e1013 >= _e1014) {
                        phi_2213_ = (_e1013 <= (1f / _e1014));
                    } else {
                        phi_2213_ = false;
                    }
                    let _e1019 = phi_2213_;
                    if _e1019 {
                        phi_2225_ = (1f / _e1013);
                    } else {
                        phi_2225_ = 0f;
                    }
                    let _e1026 = phi_2225_;
                    let _e1027 = (_e347 * 0.0625f);
                    local_5 = type_35(array<f32, 4>(_e708, _e731, _e754, _e765), ((_e971 * 0.34f) + (_e1013 * select(2f, (0.000000059604645f * 256f), _e1019))), _e1026, select(_e1027, 0.00000000000022737368f, (0.00000000000022737368f < _e1027)));
                    let _e1034 = local_5.member[0u];
                    let _e1037 = local_5.member[1u];
                    let _e1040 = local_5.member[2u];
                    let _e1043 = local_5.member[3u];
                    let _e1050 = local_5.member_2;
                    let _e1051 = ((_e1037 - (3f * _e1034)) * _e1050);
                    let _e1053 = local_5.member_2;
                    let _e1054 = ((_e1040 - _e1037) * _e1053);
                    let _e1056 = local_5.member_2;
                    let _e1057 = (((3f * _e1043) - _e1040) * _e1056);
                    local_3[0u] = 0f;
                    local_3[1u] = 1f;
                    local_3[2u] = 1f;
                    local_3[3u] = 1f;
                    let _e1064 = ((_e1054 * _e1054) - (_e1051 * _e1057));
                    if (_e1064 > 0f) {
                        if (_e1064 <= 0.000000000000000000000000000000000000011754944f) {
                            phi_2353_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1064 > 0f));
                        } else {
                            phi_2296_ = type_16(0i, 5i);
                            phi_2299_ = bitcast<f32>(((bitcast<u32>(_e1064) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1073 = phi_2296_;
                                let _e1075 = phi_2299_;
                                local_8 = _e1075;
                                if (_e1073.member < _e1073.member_1) {
                                    let _e1082 = (_e1073.member + 1i);
                                    phi_2297_ = type_16(select(_e1082, type_17().member_1, select(false, true, ((false == (_e1082 > _e1073.member)) != false))), _e1073.member_1);
                                    phi_2340_ = type_17(1u, _e1073.member);
                                } else {
                                    phi_2297_ = _e1073;
                                    phi_2340_ = type_17(0u, type_17().member_1);
                                }
                                let _e1093 = phi_2297_;
                                let _e1095 = phi_2340_;
                                let _e1098 = (bitcast<i32>(_e1095.member) != 0i);
                                if _e1098 {
                                    phi_2300_ = (0.5f * (_e1075 + (_e1064 / _e1075)));
                                } else {
                                    phi_2300_ = f32();
                                }
                                let _e1103 = phi_2300_;
                                continue;
                                continuing {
                                    phi_2296_ = _e1093;
                                    phi_2299_ = _e1103;
                                    break if !(_e1098);
                                }
                            }
                            let _e1108 = local_8;
                            phi_2353_ = (_e1108 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1114 = phi_2353_;
                        let _e1119 = -((_e1054 + select(_e1114, -(_e1114), (_e1054 < 0f))));
                        local_4[0u] = (_e1119 / (_e1119 + _e1057));
                        local_4[1u] = (_e1051 / (_e1051 + _e1119));
                        let _e1128 = local_4[1u];
                        let _e1129 = local_4[0u];
                        if (_e1128 < _e1129) {
                            let _e1132 = local_4[1u];
                            let _e1134 = local_4[0u];
                            local_4[0u] = _e1132;
                            local_4[1u] = _e1134;
                        }
                        phi_2384_ = type_9(0u, 2u);
                        phi_2387_ = 1u;
                        loop {
                            let _e1138 = phi_2384_;
                            let _e1140 = phi_2387_;
                            local_40 = _e1140;
                            let _e1143 = (_e1138.member < _e1138.member_1);
                            let _e1154 = select(type_9().member_1, _e1138.member, _e1143);
                            let _e1156 = (bitcast<i32>(select(0u, 1u, _e1143)) != 0i);
                            if _e1156 {
                                let _e1158 = local_4[_e1154];
                                if (_e1158 > 0f) {
                                    let _e1161 = local_4[_e1154];
                                    if (_e1161 < 1f) {
                                        let _e1164 = local_4[_e1154];
                                        local_3[_e1140] = _e1164;
                                        phi_2454_ = (_e1140 + 1u);
                                    } else {
                                        phi_2454_ = _e1140;
                                    }
                                    let _e1168 = phi_2454_;
                                    phi_2455_ = _e1168;
                                } else {
                                    phi_2455_ = _e1140;
                                }
                                let _e1170 = phi_2455_;
                                phi_2388_ = _e1170;
                            } else {
                                phi_2388_ = u32();
                            }
                            let _e1172 = phi_2388_;
                            continue;
                            continuing {
                                phi_2384_ = type_9(select(_e1138.member, (_e1138.member + 1u), _e1143), select(_e1138.member_1, _e1138.member_1, _e1143));
                                phi_2387_ = _e1172;
                                break if !(_e1156);
                            }
                        }
                        let _e3825 = local_40;
                        phi_2456_ = _e3825;
                    } else {
                        phi_2456_ = 1u;
                    }
                    let _e1175 = phi_2456_;
                    local_3[_e1175] = 1f;
                    let _e1177 = local_3;
                    local_6 = _e1177;
                    let _e1178 = (_e347 * 0.99f);
                    let _e1179 = (1f - _e349);
                    let _e1182 = local_5.member[0u];
                    let _e1185 = local_5.member[1u];
                    let _e1188 = local_5.member[2u];
                    let _e1191 = local_5.member[3u];
                    let _e1202 = ((((_e1182 * _e1179) + (_e1185 * _e349)) * (_e1179 * _e1179)) + (((_e1188 * _e1179) + (_e1191 * _e349)) * (_e349 * _e349)));
                    let _e1207 = local_5.member_1;
                    phi_2512_ = type_9(select(1u, 0u, !((select(_e1202, -(_e1202), (_e1202 < 0f)) > _e1207))), (_e1175 + 1u));
                    loop {
                        let _e1214 = phi_2512_;
                        let _e1217 = (_e1214.member < _e1214.member_1);
                        let _e1228 = select(type_9().member_1, _e1214.member, _e1217);
                        if (bitcast<i32>(select(0u, 1u, _e1217)) != 0i) {
                            if (_e1228 > 0u) {
                                let _e1235 = local_6[(_e1228 - 1u)];
                                let _e1237 = select(_e349, _e1235, (_e1235 > _e349));
                                let _e1239 = local_6[_e1228];
                                let _e1241 = select(_e351, _e1239, (_e1239 < _e351));
                                if (_e1237 <= _e1241) {
                                    let _e1243 = function_4((&local_5), _e353, _e1237, _e1241);
                                    if _e1243 {
                                        phi_3915_ = type_37();
                                        phi_3916_ = bool();
                                        phi_3917_ = type_37();
                                        phi_3918_ = false;
                                        phi_3919_ = false;
                                        phi_3920_ = false;
                                        phi_3921_ = false;
                                    } else {
                                        let _e1244 = (1f - _e1237);
                                        let _e1247 = local_5.member[0u];
                                        let _e1250 = local_5.member[1u];
                                        let _e1253 = local_5.member[2u];
                                        let _e1256 = local_5.member[3u];
                                        let _e1267 = ((((_e1247 * _e1244) + (_e1250 * _e1237)) * (_e1244 * _e1244)) + (((_e1253 * _e1244) + (_e1256 * _e1237)) * (_e1237 * _e1237)));
                                        let _e1268 = (1f - _e1241);
                                        let _e1271 = local_5.member[0u];
                                        let _e1274 = local_5.member[1u];
                                        let _e1277 = local_5.member[2u];
                                        let _e1280 = local_5.member[3u];
                                        let _e1291 = ((((_e1271 * _e1268) + (_e1274 * _e1241)) * (_e1268 * _e1268)) + (((_e1277 * _e1268) + (_e1280 * _e1241)) * (_e1241 * _e1241)));
                                        let _e1296 = local_5.member_1;
                                        let _e1297 = (select(_e1267, -(_e1267), (_e1267 < 0f)) > _e1296);
                                        let _e1302 = local_5.member_1;
                                        let _e1303 = (select(_e1291, -(_e1291), (_e1291 < 0f)) > _e1302);
                                        let _e1311 = select(select(bool(), select(bool(), ((_e1267 > 0f) != (_e1291 > 0f)), _e1303), _e1297), false, select(true, select(true, false, _e1303), _e1297));
                                        if _e1297 {
                                            if _e1303 {
                                                phi_2668_ = type_37(select(1f, type_37().member, _e1311), select(0f, type_37().member_1, _e1311), select(_e1311, type_37().member_2, _e1311));
                                                phi_2669_ = _e1311;
                                            } else {
                                                phi_2668_ = type_37();
                                                phi_2669_ = true;
                                            }
                                            let _e1320 = phi_2668_;
                                            let _e1322 = phi_2669_;
                                            phi_2670_ = _e1320;
                                            phi_2671_ = _e1322;
                                        } else {
                                            phi_2670_ = type_37();
                                            phi_2671_ = true;
                                        }
                                        let _e1324 = phi_2670_;
                                        let _e1326 = phi_2671_;
                                        if _e1326 {
                                            if _e1297 {
                                                let _e1328 = select(1f, -1f, (_e1267 < 0f));
                                                let _e1330 = local_5.member_3;
                                                let _e1333 = local_5.member[0u];
                                                let _e1336 = local_5.member[1u];
                                                let _e1339 = local_5.member[2u];
                                                let _e1342 = local_5.member[3u];
                                                let _e1345 = (_e1339 - _e1336);
                                                phi_2702_ = type_9(0u, 64u);
                                                phi_2705_ = _e1241;
                                                phi_2707_ = _e1237;
                                                phi_2709_ = (0.5f * (_e1237 + _e1241));
                                                loop {
                                                    let _e1351 = phi_2702_;
                                                    let _e1353 = phi_2705_;
                                                    let _e1355 = phi_2707_;
                                                    let _e1357 = phi_2709_;
                                                    local_11 = _e1355;
                                                    let _e1360 = (_e1351.member < _e1351.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1360)) != 0i) {
                                                        let _e1372 = (1f - _e1357);
                                                        let _e1375 = local_5.member[0u];
                                                        let _e1378 = local_5.member[1u];
                                                        let _e1381 = local_5.member[2u];
                                                        let _e1384 = local_5.member[3u];
                                                        let _e1398 = local_5.member_1;
                                                        let _e1399 = ((_e1328 * ((((_e1375 * _e1372) + (_e1378 * _e1357)) * (_e1372 * _e1372)) + (((_e1381 * _e1372) + (_e1384 * _e1357)) * (_e1357 * _e1357)))) - _e1398);
                                                        let _e1400 = (_e1399 > 0f);
                                                        let _e1401 = select(_e1357, _e1353, _e1400);
                                                        let _e1402 = select(_e1355, _e1357, _e1400);
                                                        let _e1404 = ((_e1401 - _e1402) > _e1330);
                                                        if _e1404 {
                                                            let _e1405 = (1f - _e1357);
                                                            let _e1417 = (-(_e1399) / (_e1328 * (((((_e1336 - (3f * _e1333)) * _e1405) + (_e1345 * _e1357)) * _e1405) + (((_e1345 * _e1405) + (((3f * _e1342) - _e1339) * _e1357)) * _e1357))));
                                                            let _e1424 = ((_e1357 + _e1417) + select(-((0.5f * _e1330)), (0.5f * _e1330), (_e1399 > 0f)));
                                                            if (_e1424 > _e1402) {
                                                                phi_2819_ = select(true, select(true, false, (select(_e1417, -(_e1417), (_e1417 < 0f)) < (0.5f * (_e1401 - _e1402)))), (_e1424 < _e1401));
                                                            } else {
                                                                phi_2819_ = true;
                                                            }
                                                            let _e1436 = phi_2819_;
                                                            phi_2826_ = select(_e1424, (0.5f * (_e1402 + _e1401)), _e1436);
                                                            phi_2827_ = false;
                                                        } else {
                                                            phi_2826_ = f32();
                                                            phi_2827_ = true;
                                                        }
                                                        let _e1441 = phi_2826_;
                                                        let _e1443 = phi_2827_;
                                                        phi_2706_ = _e1401;
                                                        phi_2708_ = _e1402;
                                                        phi_2710_ = _e1441;
                                                        phi_2828_ = _e1402;
                                                        phi_2829_ = _e1404;
                                                        phi_2830_ = _e1443;
                                                    } else {
                                                        phi_2706_ = f32();
                                                        phi_2708_ = f32();
                                                        phi_2710_ = f32();
                                                        phi_2828_ = f32();
                                                        phi_2829_ = false;
                                                        phi_2830_ = false;
                                                    }
                                                    let _e1445 = phi_2706_;
                                                    let _e1447 = phi_2708_;
                                                    let _e1449 = phi_2710_;
                                                    let _e1451 = phi_2828_;
                                                    let _e1453 = phi_2829_;
                                                    let _e1455 = phi_2830_;
                                                    local_9 = _e1455;
                                                    local_10 = _e1451;
                                                    continue;
                                                    continuing {
                                                        phi_2702_ = type_9(select(_e1351.member, (_e1351.member + 1u), _e1360), select(_e1351.member_1, _e1351.member_1, _e1360));
                                                        phi_2705_ = _e1445;
                                                        phi_2707_ = _e1447;
                                                        phi_2709_ = _e1449;
                                                        break if !(_e1453);
                                                    }
                                                }
                                                let _e1458 = local_9;
                                                let _e1460 = local_10;
                                                let _e1462 = local_11;
                                                phi_2835_ = select(_e1462, _e1460, _e1458);
                                            } else {
                                                phi_2835_ = _e1237;
                                            }
                                            let _e1465 = phi_2835_;
                                            if _e1303 {
                                                let _e1469 = local_5.member_3;
                                                let _e1471 = local_5.member_3;
                                                phi_2851_ = type_9(0u, 64u);
                                                phi_2854_ = (_e1469 + _e1471);
                                                loop {
                                                    let _e1474 = phi_2851_;
                                                    let _e1476 = phi_2854_;
                                                    let _e1479 = (_e1474.member < _e1474.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1479)) != 0i) {
                                                        let _e1491 = (_e1465 + _e1476);
                                                        if (_e1491 < _e1241) {
                                                            let _e1493 = (1f - _e1491);
                                                            let _e1496 = local_5.member[0u];
                                                            let _e1499 = local_5.member[1u];
                                                            let _e1502 = local_5.member[2u];
                                                            let _e1505 = local_5.member[3u];
                                                            let _e1519 = local_5.member_1;
                                                            let _e1520 = ((select(1f, -1f, (_e1291 < 0f)) * ((((_e1496 * _e1493) + (_e1499 * _e1491)) * (_e1493 * _e1493)) + (((_e1502 * _e1493) + (_e1505 * _e1491)) * (_e1491 * _e1491)))) > _e1519);
                                                            phi_2919_ = select((_e1476 + _e1476), f32(), _e1520);
                                                            phi_2920_ = select(true, false, _e1520);
                                                            phi_2921_ = _e1520;
                                                            phi_2922_ = false;
                                                        } else {
                                                            phi_2919_ = f32();
                                                            phi_2920_ = false;
                                                            phi_2921_ = false;
                                                            phi_2922_ = true;
                                                        }
                                                        let _e1525 = phi_2919_;
                                                        let _e1527 = phi_2920_;
                                                        let _e1529 = phi_2921_;
                                                        let _e1531 = phi_2922_;
                                                        phi_2923_ = _e1491;
                                                        phi_2855_ = _e1525;
                                                        phi_2924_ = _e1527;
                                                        phi_2925_ = _e1529;
                                                        phi_2926_ = _e1531;
                                                        phi_2927_ = false;
                                                    } else {
                                                        phi_2923_ = f32();
                                                        phi_2855_ = f32();
                                                        phi_2924_ = false;
                                                        phi_2925_ = false;
                                                        phi_2926_ = false;
                                                        phi_2927_ = true;
                                                    }
                                                    let _e1533 = phi_2923_;
                                                    let _e1535 = phi_2855_;
                                                    let _e1537 = phi_2924_;
                                                    let _e1539 = phi_2925_;
                                                    let _e1541 = phi_2926_;
                                                    let _e1543 = phi_2927_;
                                                    local_12 = _e1539;
                                                    local_13 = _e1541;
                                                    local_14 = _e1539;
                                                    local_15 = _e1543;
                                                    local_16 = _e1533;
                                                    continue;
                                                    continuing {
                                                        phi_2851_ = type_9(select(_e1474.member, (_e1474.member + 1u), _e1479), select(_e1474.member_1, _e1474.member_1, _e1479));
                                                        phi_2854_ = _e1535;
                                                        break if !(_e1537);
                                                    }
                                                }
                                                let _e1546 = local_12;
                                                let _e1548 = local_13;
                                                let _e1551 = local_14;
                                                let _e1553 = local_15;
                                                let _e1557 = local_16;
                                                phi_2941_ = select(_e1557, _e1241, select(select(_e1553, false, _e1551), true, select(_e1548, false, _e1546)));
                                            } else {
                                                phi_2941_ = _e1241;
                                            }
                                            let _e1560 = phi_2941_;
                                            phi_2943_ = type_37(_e1465, _e1560, _e1311);
                                        } else {
                                            phi_2943_ = _e1324;
                                        }
                                        let _e1563 = phi_2943_;
                                        if (_e1563.member > _e1563.member_1) {
                                            phi_3910_ = bool();
                                            phi_3911_ = true;
                                            phi_3912_ = false;
                                            phi_3913_ = false;
                                            phi_3914_ = false;
                                        } else {
                                            let _e1568 = (_e1563.member > _e353);
                                            if _e1568 {
                                                phi_3906_ = bool();
                                                phi_3907_ = false;
                                                phi_3908_ = false;
                                                phi_3909_ = false;
                                            } else {
                                                let _e1572 = ((_e1563.member_1 - _e1563.member) * 0.5f);
                                                let _e1573 = (_e1563.member + _e1572);
                                                let _e1575 = (_e1572 + (0.000000059604645f * 4f));
                                                let _e1577 = local_7.member_3;
                                                let _e1580 = local_7.member[0u];
                                                let _e1586 = select(_e1580[0], -(_e1580[0]), (_e1580[0] < 0f));
                                                let _e1589 = select(_e1580[1], -(_e1580[1]), (_e1580[1] < 0f));
                                                let _e1591 = select(_e1589, _e1586, (_e1586 > _e1589));
                                                let _e1594 = select(_e1580[2], -(_e1580[2]), (_e1580[2] < 0f));
                                                let _e1596 = select(_e1594, _e1591, (_e1591 > _e1594));
                                                let _e1598 = local_7.member[1u];
                                                let _e1604 = select(_e1598[0], -(_e1598[0]), (_e1598[0] < 0f));
                                                let _e1607 = select(_e1598[1], -(_e1598[1]), (_e1598[1] < 0f));
                                                let _e1609 = select(_e1607, _e1604, (_e1604 > _e1607));
                                                let _e1612 = select(_e1598[2], -(_e1598[2]), (_e1598[2] < 0f));
                                                let _e1614 = select(_e1612, _e1609, (_e1609 > _e1612));
                                                let _e1619 = local_7.member[0u];
                                                let _e1624 = local_7.member[1u];
                                                let _e1634 = (_e1619[0] + ((_e1624[0] - _e1619[0]) * _e1573));
                                                let _e1635 = (_e1619[1] + ((_e1624[1] - _e1619[1]) * _e1573));
                                                let _e1636 = (_e1619[2] + ((_e1624[2] - _e1619[2]) * _e1573));
                                                let _e1638 = local_7.member[1u];
                                                let _e1643 = local_7.member[0u];
                                                let _e1647 = (_e1638[0] - _e1643[0]);
                                                let _e1648 = (_e1638[1] - _e1643[1]);
                                                let _e1649 = (_e1638[2] - _e1643[2]);
                                                let _e1652 = select(_e1647, -(_e1647), (_e1647 < 0f));
                                                let _e1655 = select(_e1648, -(_e1648), (_e1648 < 0f));
                                                let _e1657 = select(_e1655, _e1652, (_e1652 > _e1655));
                                                let _e1660 = select(_e1649, -(_e1649), (_e1649 < 0f));
                                                let _e1668 = ((((_e1575 * select(_e1660, _e1657, (_e1657 > _e1660))) * 1.01f) + ((select(_e1614, _e1596, (_e1596 > _e1614)) + _e1577) * (0.000000059604645f * 8f))) + _e1577);
                                                let _e1671 = select(_e1634, -(_e1634), (_e1634 < 0f));
                                                let _e1674 = select(_e1635, -(_e1635), (_e1635 < 0f));
                                                let _e1676 = select(_e1674, _e1671, (_e1671 > _e1674));
                                                let _e1679 = select(_e1636, -(_e1636), (_e1636 < 0f));
                                                let _e1682 = (select(_e1679, _e1676, (_e1676 > _e1679)) + _e1668);
                                                let _e1685 = local_7.member_3;
                                                let _e1687 = local_7.member_1[0u];
                                                let _e1693 = select(_e1687[0], -(_e1687[0]), (_e1687[0] < 0f));
                                                let _e1696 = select(_e1687[1], -(_e1687[1]), (_e1687[1] < 0f));
                                                let _e1698 = select(_e1696, _e1693, (_e1693 > _e1696));
                                                let _e1701 = select(_e1687[2], -(_e1687[2]), (_e1687[2] < 0f));
                                                let _e1703 = select(_e1701, _e1698, (_e1698 > _e1701));
                                                let _e1705 = local_7.member_1[1u];
                                                let _e1711 = select(_e1705[0], -(_e1705[0]), (_e1705[0] < 0f));
                                                let _e1714 = select(_e1705[1], -(_e1705[1]), (_e1705[1] < 0f));
                                                let _e1716 = select(_e1714, _e1711, (_e1711 > _e1714));
                                                let _e1719 = select(_e1705[2], -(_e1705[2]), (_e1705[2] < 0f));
                                                let _e1721 = select(_e1719, _e1716, (_e1716 > _e1719));
                                                let _e1726 = local_7.member_1[0u];
                                                let _e1731 = local_7.member_1[1u];
                                                let _e1741 = (_e1726[0] + ((_e1731[0] - _e1726[0]) * _e1573));
                                                let _e1742 = (_e1726[1] + ((_e1731[1] - _e1726[1]) * _e1573));
                                                let _e1743 = (_e1726[2] + ((_e1731[2] - _e1726[2]) * _e1573));
                                                let _e1745 = local_7.member_1[1u];
                                                let _e1750 = local_7.member_1[0u];
                                                let _e1754 = (_e1745[0] - _e1750[0]);
                                                let _e1755 = (_e1745[1] - _e1750[1]);
                                                let _e1756 = (_e1745[2] - _e1750[2]);
                                                let _e1759 = select(_e1754, -(_e1754), (_e1754 < 0f));
                                                let _e1762 = select(_e1755, -(_e1755), (_e1755 < 0f));
                                                let _e1764 = select(_e1762, _e1759, (_e1759 > _e1762));
                                                let _e1767 = select(_e1756, -(_e1756), (_e1756 < 0f));
                                                let _e1775 = ((((_e1575 * select(_e1767, _e1764, (_e1764 > _e1767))) * 1.01f) + ((select(_e1721, _e1703, (_e1703 > _e1721)) + _e1685) * (0.000000059604645f * 8f))) + _e1685);
                                                let _e1778 = select(_e1741, -(_e1741), (_e1741 < 0f));
                                                let _e1781 = select(_e1742, -(_e1742), (_e1742 < 0f));
                                                let _e1783 = select(_e1781, _e1778, (_e1778 > _e1781));
                                                let _e1786 = select(_e1743, -(_e1743), (_e1743 < 0f));
                                                let _e1789 = (select(_e1786, _e1783, (_e1783 > _e1786)) + _e1775);
                                                let _e1792 = local_7.member_3;
                                                let _e1794 = local_7.member_2[0u];
                                                let _e1800 = select(_e1794[0], -(_e1794[0]), (_e1794[0] < 0f));
                                                let _e1803 = select(_e1794[1], -(_e1794[1]), (_e1794[1] < 0f));
                                                let _e1805 = select(_e1803, _e1800, (_e1800 > _e1803));
                                                let _e1808 = select(_e1794[2], -(_e1794[2]), (_e1794[2] < 0f));
                                                let _e1810 = select(_e1808, _e1805, (_e1805 > _e1808));
                                                let _e1812 = local_7.member_2[1u];
                                                let _e1818 = select(_e1812[0], -(_e1812[0]), (_e1812[0] < 0f));
                                                let _e1821 = select(_e1812[1], -(_e1812[1]), (_e1812[1] < 0f));
                                                let _e1823 = select(_e1821, _e1818, (_e1818 > _e1821));
                                                let _e1826 = select(_e1812[2], -(_e1812[2]), (_e1812[2] < 0f));
                                                let _e1828 = select(_e1826, _e1823, (_e1823 > _e1826));
                                                let _e1833 = local_7.member_2[0u];
                                                let _e1838 = local_7.member_2[1u];
                                                let _e1848 = (_e1833[0] + ((_e1838[0] - _e1833[0]) * _e1573));
                                                let _e1849 = (_e1833[1] + ((_e1838[1] - _e1833[1]) * _e1573));
                                                let _e1850 = (_e1833[2] + ((_e1838[2] - _e1833[2]) * _e1573));
                                                let _e1852 = local_7.member_2[1u];
                                                let _e1857 = local_7.member_2[0u];
                                                let _e1861 = (_e1852[0] - _e1857[0]);
                                                let _e1862 = (_e1852[1] - _e1857[1]);
                                                let _e1863 = (_e1852[2] - _e1857[2]);
                                                let _e1866 = select(_e1861, -(_e1861), (_e1861 < 0f));
                                                let _e1869 = select(_e1862, -(_e1862), (_e1862 < 0f));
                                                let _e1871 = select(_e1869, _e1866, (_e1866 > _e1869));
                                                let _e1874 = select(_e1863, -(_e1863), (_e1863 < 0f));
                                                let _e1882 = ((((_e1575 * select(_e1874, _e1871, (_e1871 > _e1874))) * 1.01f) + ((select(_e1828, _e1810, (_e1810 > _e1828)) + _e1792) * (0.000000059604645f * 8f))) + _e1792);
                                                let _e1885 = select(_e1848, -(_e1848), (_e1848 < 0f));
                                                let _e1888 = select(_e1849, -(_e1849), (_e1849 < 0f));
                                                let _e1890 = select(_e1888, _e1885, (_e1885 > _e1888));
                                                let _e1893 = select(_e1850, -(_e1850), (_e1850 < 0f));
                                                let _e1896 = (select(_e1893, _e1890, (_e1890 > _e1893)) + _e1882);
                                                let _e1899 = ((_e1742 * _e1850) - (_e1743 * _e1849));
                                                let _e1902 = ((_e1743 * _e1848) - (_e1741 * _e1850));
                                                let _e1905 = ((_e1741 * _e1849) - (_e1742 * _e1848));
                                                let _e1920 = select(false, (select(_e1899, -(_e1899), (_e1899 < 0f)) > select(_e1905, -(_e1905), (_e1905 < 0f))), (select(_e1899, -(_e1899), (_e1899 < 0f)) > select(_e1902, -(_e1902), (_e1902 < 0f))));
                                                let _e1935 = select((select(_e1902, -(_e1902), (_e1902 < 0f)) > select(_e1905, -(_e1905), (_e1905 < 0f))), false, (select(_e1899, -(_e1899), (_e1899 < 0f)) > select(_e1902, -(_e1902), (_e1902 < 0f))));
                                                let _e1938 = select(select(_e1634, _e1635, _e1920), _e1636, _e1935);
                                                let _e1939 = select(select(_e1635, _e1636, _e1920), _e1634, _e1935);
                                                let _e1942 = select(select(_e1741, _e1742, _e1920), _e1743, _e1935);
                                                let _e1943 = select(select(_e1742, _e1743, _e1920), _e1741, _e1935);
                                                let _e1946 = select(select(_e1848, _e1849, _e1920), _e1850, _e1935);
                                                let _e1947 = select(select(_e1849, _e1850, _e1920), _e1848, _e1935);
                                                let _e1950 = ((_e1942 * _e1947) - (_e1943 * _e1946));
                                                let _e1966 = (((((_e1775 * _e1896) + (_e1789 * _e1882)) * 2.01f) + (((_e1789 * 2f) * (_e1896 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1789) * (1f + _e1896))));
                                                if (select(_e1950, -(_e1950), (_e1950 < 0f)) > _e1966) {
                                                    let _e1972 = select(1f, -1f, (_e1950 < 0f));
                                                    let _e1991 = (((((_e1668 * _e1896) + (_e1682 * _e1882)) * 2.01f) + (((_e1682 * 2f) * (_e1896 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1682) * (1f + _e1896))));
                                                    let _e2010 = (((((_e1775 * _e1682) + (_e1789 * _e1668)) * 2.01f) + (((_e1789 * 2f) * (_e1682 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1789) * (1f + _e1682))));
                                                    let _e2011 = (_e1950 * _e1972);
                                                    let _e2012 = (((_e1938 * _e1947) - (_e1939 * _e1946)) * _e1972);
                                                    let _e2013 = (((_e1942 * _e1939) - (_e1943 * _e1938)) * _e1972);
                                                    let _e2026 = (((select(_e2011, -(_e2011), (_e2011 < 0f)) + select(_e2012, -(_e2012), (_e2012 < 0f))) + select(_e2013, -(_e2013), (_e2013 < 0f))) * (0.000000059604645f * 4f));
                                                    if (_e220.member != 0u) {
                                                        phi_3780_ = array<type_18, 4>(type_18(_e2012, _e1991), type_18(_e2013, _e2010), type_18((_e2011 - _e2012), ((_e1966 + _e1991) + _e2026)), type_18((_e2011 - _e2013), ((_e1966 + _e2010) + _e2026)));
                                                    } else {
                                                        let _e2029 = ((_e2011 - _e2012) - _e2013);
                                                        let _e2032 = (((_e1966 + _e1991) + _e2010) + _e2026);
                                                        phi_3780_ = array<type_18, 4>(type_18(_e2012, _e1991), type_18(_e2013, _e2010), type_18(_e2029, _e2032), type_18(_e2029, _e2032));
                                                    }
                                                    let _e2050 = phi_3780_;
                                                    local_2 = array<type_18, 4>(type_18(_e2050[0].member, _e2050[0].member_1), type_18(_e2050[1].member, _e2050[1].member_1), type_18(_e2050[2].member, _e2050[2].member_1), type_18(_e2050[3].member, _e2050[3].member_1));
                                                    phi_3800_ = type_9(0u, 4u);
                                                    phi_3803_ = true;
                                                    loop {
                                                        let _e2069 = phi_3800_;
                                                        let _e2071 = phi_3803_;
                                                        local_18 = _e2071;
                                                        let _e2074 = (_e2069.member < _e2069.member_1);
                                                        let _e2085 = select(type_9().member_1, _e2069.member, _e2074);
                                                        if (bitcast<i32>(select(0u, 1u, _e2074)) != 0i) {
                                                            let _e2090 = local_2[_e2085].member;
                                                            let _e2093 = local_2[_e2085].member_1;
                                                            let _e2095 = (_e2090 < -(_e2093));
                                                            phi_3804_ = select((_e2071 && (_e2090 > _e2093)), bool(), _e2095);
                                                            phi_3855_ = select(true, false, _e2095);
                                                            phi_3856_ = _e2095;
                                                        } else {
                                                            phi_3804_ = bool();
                                                            phi_3855_ = false;
                                                            phi_3856_ = false;
                                                        }
                                                        let _e2101 = phi_3804_;
                                                        let _e2103 = phi_3855_;
                                                        let _e2105 = phi_3856_;
                                                        local_17 = _e2105;
                                                        continue;
                                                        continuing {
                                                            phi_3800_ = type_9(select(_e2069.member, (_e2069.member + 1u), _e2074), select(_e2069.member_1, _e2069.member_1, _e2074));
                                                            phi_3803_ = _e2101;
                                                            break if !(_e2103);
                                                        }
                                                    }
                                                    let _e2108 = local_17;
                                                    let _e2109 = select(true, false, _e2108);
                                                    let _e2111 = local_18;
                                                    phi_3870_ = select(u32(), select(2u, 1u, _e2111), _e2109);
                                                    phi_3871_ = 0u;
                                                    phi_3872_ = select(true, false, _e2109);
                                                } else {
                                                    phi_3870_ = u32();
                                                    phi_3871_ = 2u;
                                                    phi_3872_ = true;
                                                }
                                                let _e2116 = phi_3870_;
                                                let _e2118 = phi_3871_;
                                                let _e2120 = phi_3872_;
                                                let _e2121 = select(_e2116, _e2118, _e2120);
                                                let _e2122 = (_e2121 == 0u);
                                                if _e2122 {
                                                    phi_3903_ = bool();
                                                    phi_3904_ = false;
                                                    phi_3905_ = false;
                                                } else {
                                                    let _e2125 = select(false, _e1563.member_2, (_e2121 == 1u));
                                                    let _e2131 = select(true, select(true, false, ((_e1563.member_1 - _e1563.member) <= _e1178)), _e2125);
                                                    phi_3903_ = _e2125;
                                                    phi_3904_ = _e2131;
                                                    phi_3905_ = select(true, false, _e2131);
                                                }
                                                let _e2134 = phi_3903_;
                                                let _e2136 = phi_3904_;
                                                let _e2138 = phi_3905_;
                                                phi_3906_ = _e2134;
                                                phi_3907_ = _e2122;
                                                phi_3908_ = _e2136;
                                                phi_3909_ = _e2138;
                                            }
                                            let _e2140 = phi_3906_;
                                            let _e2142 = phi_3907_;
                                            let _e2144 = phi_3908_;
                                            let _e2146 = phi_3909_;
                                            phi_3910_ = _e2140;
                                            phi_3911_ = _e2142;
                                            phi_3912_ = _e2144;
                                            phi_3913_ = _e1568;
                                            phi_3914_ = _e2146;
                                        }
                                        let _e2148 = phi_3910_;
                                        let _e2150 = phi_3911_;
                                        let _e2152 = phi_3912_;
                                        let _e2154 = phi_3913_;
                                        let _e2156 = phi_3914_;
                                        phi_3915_ = _e1563;
                                        phi_3916_ = _e2148;
                                        phi_3917_ = _e1563;
                                        phi_3918_ = _e2150;
                                        phi_3919_ = _e2152;
                                        phi_3920_ = _e2154;
                                        phi_3921_ = _e2156;
                                    }
                                    let _e2158 = phi_3915_;
                                    let _e2160 = phi_3916_;
                                    let _e2162 = phi_3917_;
                                    let _e2164 = phi_3918_;
                                    let _e2166 = phi_3919_;
                                    let _e2168 = phi_3920_;
                                    let _e2170 = phi_3921_;
                                    phi_3922_ = _e2158;
                                    phi_3923_ = _e2160;
                                    phi_3924_ = _e2162;
                                    phi_3925_ = _e2164;
                                    phi_3926_ = _e2166;
                                    phi_3927_ = _e1243;
                                    phi_3928_ = _e2168;
                                    phi_3929_ = _e2170;
                                } else {
                                    phi_3922_ = type_37();
                                    phi_3923_ = bool();
                                    phi_3924_ = type_37();
                                    phi_3925_ = true;
                                    phi_3926_ = false;
                                    phi_3927_ = false;
                                    phi_3928_ = false;
                                    phi_3929_ = false;
                                }
                                let _e2172 = phi_3922_;
                                let _e2174 = phi_3923_;
                                let _e2176 = phi_3924_;
                                let _e2178 = phi_3925_;
                                let _e2180 = phi_3926_;
                                let _e2182 = phi_3927_;
                                let _e2184 = phi_3928_;
                                let _e2186 = phi_3929_;
                                phi_3937_ = _e2172;
                                phi_3938_ = _e2174;
                                phi_3939_ = _e2176;
                                phi_3940_ = select(_e2180, false, _e2178);
                                phi_3941_ = _e2178;
                                phi_3942_ = select(_e2182, false, _e2178);
                                phi_3943_ = select(_e2184, false, _e2178);
                                phi_3944_ = select(_e2186, false, _e2178);
                            } else {
                                phi_3937_ = type_37(_e349, _e349, false);
                                phi_3938_ = false;
                                phi_3939_ = type_37();
                                phi_3940_ = true;
                                phi_3941_ = false;
                                phi_3942_ = false;
                                phi_3943_ = false;
                                phi_3944_ = false;
                            }
                            let _e2192 = phi_3937_;
                            let _e2194 = phi_3938_;
                            let _e2196 = phi_3939_;
                            let _e2198 = phi_3940_;
                            let _e2200 = phi_3941_;
                            let _e2202 = phi_3942_;
                            let _e2204 = phi_3943_;
                            let _e2206 = phi_3944_;
                            if _e2198 {
                                let _e2211 = local_7.member[0u];
                                let _e2217 = local_7.member_1[0u];
                                let _e2223 = local_7.member_2[0u];
                                let _e2227 = (_e2211[0] - _e2217[0]);
                                let _e2228 = (_e2211[1] - _e2217[1]);
                                let _e2229 = (_e2211[2] - _e2217[2]);
                                let _e2230 = (_e220.member == 0u);
                                let _e2242 = local_7.member[1u];
                                let _e2248 = local_7.member_1[1u];
                                let _e2254 = local_7.member_2[1u];
                                let _e2258 = (_e2242[0] - _e2248[0]);
                                let _e2259 = (_e2242[1] - _e2248[1]);
                                let _e2260 = (_e2242[2] - _e2248[2]);
                                let _e2261 = (_e220.member == 0u);
                                let _e2273 = local_7.member[0u];
                                let _e2279 = select(_e2273[0], -(_e2273[0]), (_e2273[0] < 0f));
                                let _e2282 = select(_e2273[1], -(_e2273[1]), (_e2273[1] < 0f));
                                let _e2284 = select(_e2282, _e2279, (_e2279 > _e2282));
                                let _e2287 = select(_e2273[2], -(_e2273[2]), (_e2273[2] < 0f));
                                let _e2289 = select(_e2287, _e2284, (_e2284 > _e2287));
                                let _e2292 = local_7.member[1u];
                                let _e2298 = select(_e2292[0], -(_e2292[0]), (_e2292[0] < 0f));
                                let _e2301 = select(_e2292[1], -(_e2292[1]), (_e2292[1] < 0f));
                                let _e2303 = select(_e2301, _e2298, (_e2298 > _e2301));
                                let _e2306 = select(_e2292[2], -(_e2292[2]), (_e2292[2] < 0f));
                                let _e2308 = select(_e2306, _e2303, (_e2303 > _e2306));
                                let _e2312 = local_7.member_3;
                                let _e2316 = local_7.member_1[0u];
                                let _e2322 = select(_e2316[0], -(_e2316[0]), (_e2316[0] < 0f));
                                let _e2325 = select(_e2316[1], -(_e2316[1]), (_e2316[1] < 0f));
                                let _e2327 = select(_e2325, _e2322, (_e2322 > _e2325));
                                let _e2330 = select(_e2316[2], -(_e2316[2]), (_e2316[2] < 0f));
                                let _e2332 = select(_e2330, _e2327, (_e2327 > _e2330));
                                let _e2335 = local_7.member_1[1u];
                                let _e2341 = select(_e2335[0], -(_e2335[0]), (_e2335[0] < 0f));
                                let _e2344 = select(_e2335[1], -(_e2335[1]), (_e2335[1] < 0f));
                                let _e2346 = select(_e2344, _e2341, (_e2341 > _e2344));
                                let _e2349 = select(_e2335[2], -(_e2335[2]), (_e2335[2] < 0f));
                                let _e2351 = select(_e2349, _e2346, (_e2346 > _e2349));
                                let _e2355 = local_7.member_3;
                                let _e2359 = local_7.member_2[0u];
                                let _e2365 = select(_e2359[0], -(_e2359[0]), (_e2359[0] < 0f));
                                let _e2368 = select(_e2359[1], -(_e2359[1]), (_e2359[1] < 0f));
                                let _e2370 = select(_e2368, _e2365, (_e2365 > _e2368));
                                let _e2373 = select(_e2359[2], -(_e2359[2]), (_e2359[2] < 0f));
                                let _e2375 = select(_e2373, _e2370, (_e2370 > _e2373));
                                let _e2378 = local_7.member_2[1u];
                                let _e2384 = select(_e2378[0], -(_e2378[0]), (_e2378[0] < 0f));
                                let _e2387 = select(_e2378[1], -(_e2378[1]), (_e2378[1] < 0f));
                                let _e2389 = select(_e2387, _e2384, (_e2384 > _e2387));
                                let _e2392 = select(_e2378[2], -(_e2378[2]), (_e2378[2] < 0f));
                                let _e2394 = select(_e2392, _e2389, (_e2389 > _e2392));
                                let _e2398 = local_7.member_3;
                                let _e2405 = local_7.member_3;
                                let _e2410 = (_e347 * 0.00390625f);
                                local = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                phi_4367_ = type_9(0u, 96u);
                                phi_4370_ = _e2192.member;
                                phi_4372_ = _e2192.member;
                                phi_4374_ = (_e2192.member_1 - _e2192.member);
                                phi_4376_ = _e2192.member;
                                phi_4378_ = false;
                                phi_4380_ = 0u;
                                loop {
                                    let _e2413 = phi_4367_;
                                    let _e2415 = phi_4370_;
                                    let _e2417 = phi_4372_;
                                    let _e2419 = phi_4374_;
                                    let _e2421 = phi_4376_;
                                    let _e2423 = phi_4378_;
                                    let _e2425 = phi_4380_;
                                    local_28 = _e2415;
                                    local_31 = _e2417;
                                    let _e2428 = (_e2413.member < _e2413.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2428)) != 0i) {
                                        let _e2442 = local_7.member[0u];
                                        let _e2448 = local_7.member[1u];
                                        let _e2464 = local_7.member_1[0u];
                                        let _e2470 = local_7.member_1[1u];
                                        let _e2486 = local_7.member_2[0u];
                                        let _e2492 = local_7.member_2[1u];
                                        let _e2506 = function_2(array<f32, 3>((_e2442[0] + ((_e2448[0] - _e2442[0]) * _e2415)), (_e2442[1] + ((_e2448[1] - _e2442[1]) * _e2415)), (_e2442[2] + ((_e2448[2] - _e2442[2]) * _e2415))), array<f32, 3>((_e2464[0] + ((_e2470[0] - _e2464[0]) * _e2415)), (_e2464[1] + ((_e2470[1] - _e2464[1]) * _e2415)), (_e2464[2] + ((_e2470[2] - _e2464[2]) * _e2415))), array<f32, 3>((_e2486[0] + ((_e2492[0] - _e2486[0]) * _e2415)), (_e2486[1] + ((_e2492[1] - _e2486[1]) * _e2415)), (_e2486[2] + ((_e2492[2] - _e2486[2]) * _e2415))), _e220.member);
                                        if (_e2425 == 0u) {
                                            phi_4531_ = _e2506;
                                        } else {
                                            phi_4531_ = array<f32, 3>(select(0f, _e2506[0], (_e2425 == 1u)), select(0f, _e2506[1], (_e2425 == 2u)), select(0f, _e2506[2], (_e2425 == 3u)));
                                        }
                                        let _e2519 = phi_4531_;
                                        let _e2533 = ((select(_e2519[0], -(_e2519[0]), (_e2519[0] < 0f)) + select(_e2519[1], -(_e2519[1]), (_e2519[1] < 0f))) + select(_e2519[2], -(_e2519[2]), (_e2519[2] < 0f)));
                                        if (_e2533 > 0f) {
                                            if ((bitcast<u32>(_e2533) & 2139095040u) != 2139095040u) {
                                                let _e2538 = (1f / _e2533);
                                                let _e2540 = (_e2519[0] * _e2538);
                                                let _e2542 = (_e2519[1] * _e2538);
                                                let _e2544 = (_e2519[2] * _e2538);
                                                let _e2549 = (((_e2540 * _e2540) + (_e2542 * _e2542)) + (_e2544 * _e2544));
                                                if (_e2549 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4654_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2549 > 0f));
                                                } else {
                                                    phi_4597_ = type_16(0i, 5i);
                                                    phi_4600_ = bitcast<f32>(((bitcast<u32>(_e2549) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2557 = phi_4597_;
                                                        let _e2559 = phi_4600_;
                                                        local_19 = _e2559;
                                                        if (_e2557.member < _e2557.member_1) {
                                                            let _e2566 = (_e2557.member + 1i);
                                                            phi_4598_ = type_16(select(_e2566, type_17().member_1, select(false, true, ((false == (_e2566 > _e2557.member)) != false))), _e2557.member_1);
                                                            phi_4641_ = type_17(1u, _e2557.member);
                                                        } else {
                                                            phi_4598_ = _e2557;
                                                            phi_4641_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2577 = phi_4598_;
                                                        let _e2579 = phi_4641_;
                                                        let _e2582 = (bitcast<i32>(_e2579.member) != 0i);
                                                        if _e2582 {
                                                            phi_4601_ = (0.5f * (_e2559 + (_e2549 / _e2559)));
                                                        } else {
                                                            phi_4601_ = f32();
                                                        }
                                                        let _e2587 = phi_4601_;
                                                        continue;
                                                        continuing {
                                                            phi_4597_ = _e2577;
                                                            phi_4600_ = _e2587;
                                                            break if !(_e2582);
                                                        }
                                                    }
                                                    let _e2592 = local_19;
                                                    phi_4654_ = (_e2592 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2598 = phi_4654_;
                                                let _e2599 = (0.000000059604645f * 12f);
                                                let _e2604 = ((((((((select(_e2308, _e2289, (_e2289 > _e2308)) + _e2312) + (select(_e2351, _e2332, (_e2332 > _e2351)) + _e2355)) + (select(_e2394, _e2375, (_e2375 > _e2394)) + _e2398)) * (0.000000059604645f * 16f)) + (_e2405 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2598) * (1f + _e2599)));
                                                let _e2609 = (((_e2540 * _e2211[0]) + (_e2542 * _e2211[1])) + (_e2544 * _e2211[2]));
                                                let _e2614 = (((_e2540 * _e2227) + (_e2542 * _e2228)) + (_e2544 * _e2229));
                                                let _e2619 = (((_e2540 * (_e2211[0] - _e2223[0])) + (_e2542 * (_e2211[1] - _e2223[1]))) + (_e2544 * (_e2211[2] - _e2223[2])));
                                                let _e2624 = (((_e2540 * select((_e2227 - _e2223[0]), _e2211[0], _e2230)) + (_e2542 * select((_e2228 - _e2223[1]), _e2211[1], _e2230))) + (_e2544 * select((_e2229 - _e2223[2]), _e2211[2], _e2230)));
                                                let _e2630 = (((_e2540 * _e2242[0]) + (_e2542 * _e2242[1])) + (_e2544 * _e2242[2]));
                                                let _e2635 = (((_e2540 * _e2258) + (_e2542 * _e2259)) + (_e2544 * _e2260));
                                                let _e2640 = (((_e2540 * (_e2242[0] - _e2254[0])) + (_e2542 * (_e2242[1] - _e2254[1]))) + (_e2544 * (_e2242[2] - _e2254[2])));
                                                let _e2645 = (((_e2540 * select((_e2258 - _e2254[0]), _e2242[0], _e2261)) + (_e2542 * select((_e2259 - _e2254[1]), _e2242[1], _e2261))) + (_e2544 * select((_e2260 - _e2254[2]), _e2242[2], _e2261)));
                                                phi_4777_ = type_29(array<f32, 4>(_e2609, _e2614, _e2619, _e2624), array<f32, 4>(_e2630, _e2635, _e2640, _e2645), array<f32, 4>((_e2604 + ((select(_e2609, -(_e2609), (_e2609 < 0f)) + select(_e2630, -(_e2630), (_e2630 < 0f))) * _e2599)), (_e2604 + ((select(_e2614, -(_e2614), (_e2614 < 0f)) + select(_e2635, -(_e2635), (_e2635 < 0f))) * _e2599)), (_e2604 + ((select(_e2619, -(_e2619), (_e2619 < 0f)) + select(_e2640, -(_e2640), (_e2640 < 0f))) * _e2599)), (_e2604 + ((select(_e2624, -(_e2624), (_e2624 < 0f)) + select(_e2645, -(_e2645), (_e2645 < 0f))) * _e2599))));
                                                phi_4778_ = false;
                                            } else {
                                                phi_4777_ = type_29();
                                                phi_4778_ = true;
                                            }
                                            let _e2686 = phi_4777_;
                                            let _e2688 = phi_4778_;
                                            phi_4779_ = _e2686;
                                            phi_4780_ = _e2688;
                                        } else {
                                            phi_4779_ = type_29();
                                            phi_4780_ = true;
                                        }
                                        let _e2690 = phi_4779_;
                                        let _e2692 = phi_4780_;
                                        if _e2692 {
                                            phi_4788_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_4788_ = _e2690;
                                        }
                                        let _e2694 = phi_4788_;
                                        local_1 = type_29(array<f32, 4>(_e2694.member[0], _e2694.member[1], _e2694.member[2], _e2694.member[3]), array<f32, 4>(_e2694.member_1[0], _e2694.member_1[1], _e2694.member_1[2], _e2694.member_1[3]), array<f32, 4>(_e2694.member_2[0], _e2694.member_2[1], _e2694.member_2[2], _e2694.member_2[3]));
                                        let _e2714 = (_e2415 - _e2421);
                                        let _e2718 = local_1.member[0u];
                                        let _e2721 = local_1.member_1[0u];
                                        let _e2724 = local_1.member[0u];
                                        let _e2730 = local_1.member_2[0u];
                                        if (((_e2718 + ((_e2721 - _e2724) * _e2415)) - _e2730) > 0f) {
                                            let _e2735 = local_1.member[1u];
                                            let _e2738 = local_1.member_1[1u];
                                            let _e2741 = local_1.member[1u];
                                            let _e2747 = local_1.member_2[1u];
                                            if (((_e2735 + ((_e2738 - _e2741) * _e2415)) - _e2747) > 0f) {
                                                let _e2752 = local_1.member[2u];
                                                let _e2755 = local_1.member_1[2u];
                                                let _e2758 = local_1.member[2u];
                                                let _e2764 = local_1.member_2[2u];
                                                if (((_e2752 + ((_e2755 - _e2758) * _e2415)) - _e2764) > 0f) {
                                                    let _e2769 = local_1.member[3u];
                                                    let _e2772 = local_1.member_1[3u];
                                                    let _e2775 = local_1.member[3u];
                                                    let _e2781 = local_1.member_2[3u];
                                                    phi_4959_ = (((_e2769 + ((_e2772 - _e2775) * _e2415)) - _e2781) > 0f);
                                                    phi_4960_ = false;
                                                } else {
                                                    phi_4959_ = bool();
                                                    phi_4960_ = true;
                                                }
                                                let _e2785 = phi_4959_;
                                                let _e2787 = phi_4960_;
                                                phi_4961_ = _e2785;
                                                phi_4962_ = _e2787;
                                            } else {
                                                phi_4961_ = bool();
                                                phi_4962_ = true;
                                            }
                                            let _e2789 = phi_4961_;
                                            let _e2791 = phi_4962_;
                                            phi_4963_ = _e2789;
                                            phi_4964_ = _e2791;
                                        } else {
                                            phi_4963_ = bool();
                                            phi_4964_ = true;
                                        }
                                        let _e2793 = phi_4963_;
                                        let _e2795 = phi_4964_;
                                        if select(_e2793, false, _e2795) {
                                            if (_e2415 <= _e2417) {
                                                phi_5278_ = true;
                                            } else {
                                                let _e2800 = local.member[0u];
                                                let _e2803 = local.member_1[0u];
                                                let _e2806 = local.member[0u];
                                                let _e2812 = local.member_2[0u];
                                                let _e2816 = local_1.member[0u];
                                                let _e2819 = local_1.member_1[0u];
                                                let _e2822 = local_1.member[0u];
                                                let _e2828 = local_1.member_2[0u];
                                                if ((((_e2800 + ((_e2803 - _e2806) * _e2415)) - _e2812) + ((_e2816 + ((_e2819 - _e2822) * _e2421)) - _e2828)) > 0f) {
                                                    let _e2834 = local.member[1u];
                                                    let _e2837 = local.member_1[1u];
                                                    let _e2840 = local.member[1u];
                                                    let _e2846 = local.member_2[1u];
                                                    let _e2850 = local_1.member[1u];
                                                    let _e2853 = local_1.member_1[1u];
                                                    let _e2856 = local_1.member[1u];
                                                    let _e2862 = local_1.member_2[1u];
                                                    if ((((_e2834 + ((_e2837 - _e2840) * _e2415)) - _e2846) + ((_e2850 + ((_e2853 - _e2856) * _e2421)) - _e2862)) > 0f) {
                                                        let _e2868 = local.member[2u];
                                                        let _e2871 = local.member_1[2u];
                                                        let _e2874 = local.member[2u];
                                                        let _e2880 = local.member_2[2u];
                                                        let _e2884 = local_1.member[2u];
                                                        let _e2887 = local_1.member_1[2u];
                                                        let _e2890 = local_1.member[2u];
                                                        let _e2896 = local_1.member_2[2u];
                                                        if ((((_e2868 + ((_e2871 - _e2874) * _e2415)) - _e2880) + ((_e2884 + ((_e2887 - _e2890) * _e2421)) - _e2896)) > 0f) {
                                                            let _e2902 = local.member[3u];
                                                            let _e2905 = local.member_1[3u];
                                                            let _e2908 = local.member[3u];
                                                            let _e2914 = local.member_2[3u];
                                                            let _e2918 = local_1.member[3u];
                                                            let _e2921 = local_1.member_1[3u];
                                                            let _e2924 = local_1.member[3u];
                                                            let _e2930 = local_1.member_2[3u];
                                                            phi_5265_ = ((((_e2902 + ((_e2905 - _e2908) * _e2415)) - _e2914) + ((_e2918 + ((_e2921 - _e2924) * _e2421)) - _e2930)) > 0f);
                                                            phi_5266_ = false;
                                                        } else {
                                                            phi_5265_ = bool();
                                                            phi_5266_ = true;
                                                        }
                                                        let _e2935 = phi_5265_;
                                                        let _e2937 = phi_5266_;
                                                        phi_5267_ = _e2935;
                                                        phi_5268_ = _e2937;
                                                    } else {
                                                        phi_5267_ = bool();
                                                        phi_5268_ = true;
                                                    }
                                                    let _e2939 = phi_5267_;
                                                    let _e2941 = phi_5268_;
                                                    phi_5269_ = _e2939;
                                                    phi_5270_ = _e2941;
                                                } else {
                                                    phi_5269_ = bool();
                                                    phi_5270_ = true;
                                                }
                                                let _e2943 = phi_5269_;
                                                let _e2945 = phi_5270_;
                                                phi_5278_ = select(_e2943, false, _e2945);
                                            }
                                            let _e2948 = phi_5278_;
                                            if _e2948 {
                                                if select(true, select(true, false, (_e2415 >= _e2192.member_1)), _e2423) {
                                                    local = type_29(array<f32, 4>(_e2694.member[0], _e2694.member[1], _e2694.member[2], _e2694.member[3]), array<f32, 4>(_e2694.member_1[0], _e2694.member_1[1], _e2694.member_1[2], _e2694.member_1[3]), array<f32, 4>(_e2694.member_2[0], _e2694.member_2[1], _e2694.member_2[2], _e2694.member_2[3]));
                                                    let _e2973 = local.member[0u];
                                                    let _e2976 = local.member_1[0u];
                                                    let _e2979 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e2976 > _e2979)), (_e2973 > _e2979)) {
                                                        let _e2984 = (_e2976 >= _e2973);
                                                        if _e2984 {
                                                            phi_5387_ = f32();
                                                            phi_5388_ = false;
                                                        } else {
                                                            if ((_e2973 - _e2976) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5385_ = (((_e2973 - _e2979) / (_e2973 - _e2976)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5386_ = false;
                                                            } else {
                                                                phi_5385_ = f32();
                                                                phi_5386_ = true;
                                                            }
                                                            let _e2995 = phi_5385_;
                                                            let _e2997 = phi_5386_;
                                                            phi_5387_ = _e2995;
                                                            phi_5388_ = _e2997;
                                                        }
                                                        let _e2999 = phi_5387_;
                                                        let _e3001 = phi_5388_;
                                                        phi_5389_ = _e2999;
                                                        phi_5390_ = _e2984;
                                                        phi_5391_ = _e3001;
                                                    } else {
                                                        phi_5389_ = f32();
                                                        phi_5390_ = true;
                                                        phi_5391_ = false;
                                                    }
                                                    let _e3003 = phi_5389_;
                                                    let _e3005 = phi_5390_;
                                                    let _e3007 = phi_5391_;
                                                    let _e3010 = select(_e3003, select(_e2415, 2f, _e3005), select(_e3007, true, _e3005));
                                                    let _e3013 = local.member[1u];
                                                    let _e3016 = local.member_1[1u];
                                                    let _e3019 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3016 > _e3019)), (_e3013 > _e3019)) {
                                                        let _e3024 = (_e3016 >= _e3013);
                                                        if _e3024 {
                                                            phi_5455_ = f32();
                                                            phi_5456_ = false;
                                                        } else {
                                                            if ((_e3013 - _e3016) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5453_ = (((_e3013 - _e3019) / (_e3013 - _e3016)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5454_ = false;
                                                            } else {
                                                                phi_5453_ = f32();
                                                                phi_5454_ = true;
                                                            }
                                                            let _e3035 = phi_5453_;
                                                            let _e3037 = phi_5454_;
                                                            phi_5455_ = _e3035;
                                                            phi_5456_ = _e3037;
                                                        }
                                                        let _e3039 = phi_5455_;
                                                        let _e3041 = phi_5456_;
                                                        phi_5457_ = _e3039;
                                                        phi_5458_ = _e3024;
                                                        phi_5459_ = _e3041;
                                                    } else {
                                                        phi_5457_ = f32();
                                                        phi_5458_ = true;
                                                        phi_5459_ = false;
                                                    }
                                                    let _e3043 = phi_5457_;
                                                    let _e3045 = phi_5458_;
                                                    let _e3047 = phi_5459_;
                                                    let _e3050 = select(_e3043, select(_e2415, 2f, _e3045), select(_e3047, true, _e3045));
                                                    let _e3052 = select(_e3050, _e3010, (_e3010 < _e3050));
                                                    let _e3055 = local.member[2u];
                                                    let _e3058 = local.member_1[2u];
                                                    let _e3061 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3058 > _e3061)), (_e3055 > _e3061)) {
                                                        let _e3066 = (_e3058 >= _e3055);
                                                        if _e3066 {
                                                            phi_5528_ = f32();
                                                            phi_5529_ = false;
                                                        } else {
                                                            if ((_e3055 - _e3058) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5526_ = (((_e3055 - _e3061) / (_e3055 - _e3058)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5527_ = false;
                                                            } else {
                                                                phi_5526_ = f32();
                                                                phi_5527_ = true;
                                                            }
                                                            let _e3077 = phi_5526_;
                                                            let _e3079 = phi_5527_;
                                                            phi_5528_ = _e3077;
                                                            phi_5529_ = _e3079;
                                                        }
                                                        let _e3081 = phi_5528_;
                                                        let _e3083 = phi_5529_;
                                                        phi_5530_ = _e3081;
                                                        phi_5531_ = _e3066;
                                                        phi_5532_ = _e3083;
                                                    } else {
                                                        phi_5530_ = f32();
                                                        phi_5531_ = true;
                                                        phi_5532_ = false;
                                                    }
                                                    let _e3085 = phi_5530_;
                                                    let _e3087 = phi_5531_;
                                                    let _e3089 = phi_5532_;
                                                    let _e3092 = select(_e3085, select(_e2415, 2f, _e3087), select(_e3089, true, _e3087));
                                                    let _e3095 = local.member[3u];
                                                    let _e3098 = local.member_1[3u];
                                                    let _e3101 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3098 > _e3101)), (_e3095 > _e3101)) {
                                                        let _e3106 = (_e3098 >= _e3095);
                                                        if _e3106 {
                                                            phi_5596_ = f32();
                                                            phi_5597_ = false;
                                                        } else {
                                                            if ((_e3095 - _e3098) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                phi_5594_ = (((_e3095 - _e3101) / (_e3095 - _e3098)) * (1f - (0.000000059604645f * 16f)));
                                                                phi_5595_ = false;
                                                            } else {
                                                                phi_5594_ = f32();
                                                                phi_5595_ = true;
                                                            }
                                                            let _e3117 = phi_5594_;
                                                            let _e3119 = phi_5595_;
                                                            phi_5596_ = _e3117;
                                                            phi_5597_ = _e3119;
                                                        }
                                                        let _e3121 = phi_5596_;
                                                        let _e3123 = phi_5597_;
                                                        phi_5598_ = _e3121;
                                                        phi_5599_ = _e3106;
                                                        phi_5600_ = _e3123;
                                                    } else {
                                                        phi_5598_ = f32();
                                                        phi_5599_ = true;
                                                        phi_5600_ = false;
                                                    }
                                                    let _e3125 = phi_5598_;
                                                    let _e3127 = phi_5599_;
                                                    let _e3129 = phi_5600_;
                                                    let _e3132 = select(_e3125, select(_e2415, 2f, _e3127), select(_e3129, true, _e3127));
                                                    let _e3134 = select(_e3132, _e3092, (_e3092 < _e3132));
                                                    let _e3136 = select(_e3134, _e3052, (_e3052 < _e3134));
                                                    let _e3138 = select(_e2415, _e3136, (_e3136 > _e2415));
                                                    let _e3139 = (_e3138 > _e2192.member_1);
                                                    if _e3139 {
                                                        phi_6129_ = f32();
                                                        phi_6130_ = f32();
                                                        phi_6131_ = false;
                                                    } else {
                                                        let _e3140 = (_e3138 - _e2415);
                                                        phi_6129_ = select((_e2192.member_1 - _e2415), select(0f, (_e2714 + _e2714), select(select(true, false, (_e3140 <= (_e2419 * 0.25f))), true, (_e3140 <= _e2410))), _e2423);
                                                        phi_6130_ = _e3140;
                                                        phi_6131_ = true;
                                                    }
                                                    let _e3151 = phi_6129_;
                                                    let _e3153 = phi_6130_;
                                                    let _e3155 = phi_6131_;
                                                    phi_6133_ = _e3138;
                                                    phi_6134_ = _e3151;
                                                    phi_6135_ = _e3153;
                                                    phi_6137_ = _e3155;
                                                    phi_6138_ = _e3139;
                                                    phi_6140_ = false;
                                                } else {
                                                    phi_6133_ = f32();
                                                    phi_6134_ = f32();
                                                    phi_6135_ = f32();
                                                    phi_6137_ = false;
                                                    phi_6138_ = false;
                                                    phi_6140_ = true;
                                                }
                                                let _e3157 = phi_6133_;
                                                let _e3159 = phi_6134_;
                                                let _e3161 = phi_6135_;
                                                let _e3163 = phi_6137_;
                                                let _e3165 = phi_6138_;
                                                let _e3167 = phi_6140_;
                                                phi_6141_ = _e3157;
                                                phi_6142_ = _e3159;
                                                phi_6143_ = _e3161;
                                                phi_6145_ = false;
                                                phi_6146_ = _e3163;
                                                phi_6147_ = _e3165;
                                                phi_6149_ = _e3167;
                                            } else {
                                                phi_6141_ = f32();
                                                phi_6142_ = f32();
                                                phi_6143_ = f32();
                                                phi_6145_ = true;
                                                phi_6146_ = false;
                                                phi_6147_ = false;
                                                phi_6149_ = false;
                                            }
                                            let _e3169 = phi_6141_;
                                            let _e3171 = phi_6142_;
                                            let _e3173 = phi_6143_;
                                            let _e3175 = phi_6145_;
                                            let _e3177 = phi_6146_;
                                            let _e3179 = phi_6147_;
                                            let _e3181 = phi_6149_;
                                            phi_6150_ = _e3169;
                                            phi_6151_ = _e3171;
                                            phi_6152_ = _e3173;
                                            phi_6154_ = _e3175;
                                            phi_6155_ = _e3177;
                                            phi_6156_ = _e3179;
                                            phi_6158_ = _e3181;
                                        } else {
                                            phi_6150_ = f32();
                                            phi_6151_ = f32();
                                            phi_6152_ = f32();
                                            phi_6154_ = true;
                                            phi_6155_ = false;
                                            phi_6156_ = false;
                                            phi_6158_ = false;
                                        }
                                        let _e3183 = phi_6150_;
                                        let _e3185 = phi_6151_;
                                        let _e3187 = phi_6152_;
                                        let _e3189 = phi_6154_;
                                        let _e3191 = phi_6155_;
                                        let _e3193 = phi_6156_;
                                        let _e3195 = phi_6158_;
                                        if _e3189 {
                                            if (_e2415 <= _e2417) {
                                                let _e3348 = (_e2425 + 1u);
                                                let _e3349 = (_e3348 > 3u);
                                                phi_6493_ = _e3348;
                                                phi_6494_ = f32();
                                                phi_6495_ = false;
                                                phi_6496_ = select(true, false, _e3349);
                                                phi_6497_ = _e3349;
                                            } else {
                                                let _e3199 = local.member[0u];
                                                let _e3202 = local.member_1[0u];
                                                let _e3205 = local.member[0u];
                                                let _e3211 = local.member_2[0u];
                                                let _e3212 = ((_e3199 + ((_e3202 - _e3205) * _e2421)) - _e3211);
                                                let _e3215 = local.member[1u];
                                                let _e3218 = local.member_1[1u];
                                                let _e3221 = local.member[1u];
                                                let _e3227 = local.member_2[1u];
                                                let _e3228 = ((_e3215 + ((_e3218 - _e3221) * _e2421)) - _e3227);
                                                let _e3230 = select(_e3228, _e3212, (_e3212 < _e3228));
                                                let _e3233 = local.member[2u];
                                                let _e3236 = local.member_1[2u];
                                                let _e3239 = local.member[2u];
                                                let _e3245 = local.member_2[2u];
                                                let _e3246 = ((_e3233 + ((_e3236 - _e3239) * _e2421)) - _e3245);
                                                let _e3249 = local.member[3u];
                                                let _e3252 = local.member_1[3u];
                                                let _e3255 = local.member[3u];
                                                let _e3261 = local.member_2[3u];
                                                let _e3262 = ((_e3249 + ((_e3252 - _e3255) * _e2421)) - _e3261);
                                                let _e3264 = select(_e3262, _e3246, (_e3246 < _e3262));
                                                let _e3266 = select(_e3264, _e3230, (_e3230 < _e3264));
                                                let _e3269 = local_1.member[0u];
                                                let _e3272 = local_1.member_1[0u];
                                                let _e3275 = local_1.member[0u];
                                                let _e3281 = local_1.member_2[0u];
                                                let _e3282 = ((_e3269 + ((_e3272 - _e3275) * _e2415)) - _e3281);
                                                let _e3285 = local_1.member[1u];
                                                let _e3288 = local_1.member_1[1u];
                                                let _e3291 = local_1.member[1u];
                                                let _e3297 = local_1.member_2[1u];
                                                let _e3298 = ((_e3285 + ((_e3288 - _e3291) * _e2415)) - _e3297);
                                                let _e3300 = select(_e3298, _e3282, (_e3282 < _e3298));
                                                let _e3303 = local_1.member[2u];
                                                let _e3306 = local_1.member_1[2u];
                                                let _e3309 = local_1.member[2u];
                                                let _e3315 = local_1.member_2[2u];
                                                let _e3316 = ((_e3303 + ((_e3306 - _e3309) * _e2415)) - _e3315);
                                                let _e3319 = local_1.member[3u];
                                                let _e3322 = local_1.member_1[3u];
                                                let _e3325 = local_1.member[3u];
                                                let _e3331 = local_1.member_2[3u];
                                                let _e3332 = ((_e3319 + ((_e3322 - _e3325) * _e2415)) - _e3331);
                                                let _e3334 = select(_e3332, _e3316, (_e3316 < _e3332));
                                                let _e3336 = select(_e3334, _e3300, (_e3300 < _e3334));
                                                if (_e3336 > 0f) {
                                                    phi_6491_ = 0.5f;
                                                } else {
                                                    let _e3340 = (0.95f * (_e3266 / (_e3266 - _e3336)));
                                                    phi_6491_ = select(0.0625f, select(0.9f, _e3340, (_e3340 < 0.9f)), (_e3340 > 0.0625f));
                                                }
                                                let _e3346 = phi_6491_;
                                                phi_6493_ = u32();
                                                phi_6494_ = (_e2714 * _e3346);
                                                phi_6495_ = true;
                                                phi_6496_ = false;
                                                phi_6497_ = false;
                                            }
                                            let _e3352 = phi_6493_;
                                            let _e3354 = phi_6494_;
                                            let _e3356 = phi_6495_;
                                            let _e3358 = phi_6496_;
                                            let _e3360 = phi_6497_;
                                            phi_6498_ = _e3352;
                                            phi_6499_ = _e2417;
                                            phi_6500_ = _e3354;
                                            phi_6501_ = _e2419;
                                            phi_6502_ = _e2421;
                                            phi_6503_ = _e2423;
                                            phi_6504_ = _e2425;
                                            phi_6505_ = _e3356;
                                            phi_6506_ = _e3358;
                                            phi_6507_ = _e3360;
                                            phi_6508_ = false;
                                            phi_6510_ = false;
                                        } else {
                                            phi_6498_ = u32();
                                            phi_6499_ = _e3183;
                                            phi_6500_ = _e3185;
                                            phi_6501_ = _e3187;
                                            phi_6502_ = _e2415;
                                            phi_6503_ = true;
                                            phi_6504_ = 0u;
                                            phi_6505_ = _e3191;
                                            phi_6506_ = false;
                                            phi_6507_ = false;
                                            phi_6508_ = _e3193;
                                            phi_6510_ = _e3195;
                                        }
                                        let _e3362 = phi_6498_;
                                        let _e3364 = phi_6499_;
                                        let _e3366 = phi_6500_;
                                        let _e3368 = phi_6501_;
                                        let _e3370 = phi_6502_;
                                        let _e3372 = phi_6503_;
                                        let _e3374 = phi_6504_;
                                        let _e3376 = phi_6505_;
                                        let _e3378 = phi_6506_;
                                        let _e3380 = phi_6507_;
                                        let _e3382 = phi_6508_;
                                        let _e3384 = phi_6510_;
                                        if _e3376 {
                                            let _e3385 = (_e3370 + _e3366);
                                            let _e3387 = select(_e3364, _e3385, (_e3385 > _e3364));
                                            let _e3389 = select(_e2192.member_1, _e3387, (_e3387 < _e2192.member_1));
                                            let _e3392 = select(((_e3389 - _e3370) > _e2410), true, !(_e2423));
                                            phi_6538_ = _e3389;
                                            phi_6539_ = _e3364;
                                            phi_6540_ = _e3368;
                                            phi_6541_ = _e3370;
                                            phi_6542_ = _e3372;
                                            phi_6543_ = _e3374;
                                            phi_6544_ = _e3392;
                                            phi_6545_ = select(true, false, _e3392);
                                            phi_6546_ = false;
                                            phi_6547_ = false;
                                            phi_6549_ = false;
                                        } else {
                                            phi_6538_ = _e2415;
                                            phi_6539_ = _e2417;
                                            phi_6540_ = _e2419;
                                            phi_6541_ = _e2421;
                                            phi_6542_ = _e2423;
                                            phi_6543_ = _e3362;
                                            phi_6544_ = _e3378;
                                            phi_6545_ = false;
                                            phi_6546_ = _e3380;
                                            phi_6547_ = _e3382;
                                            phi_6549_ = _e3384;
                                        }
                                        let _e3395 = phi_6538_;
                                        let _e3397 = phi_6539_;
                                        let _e3399 = phi_6540_;
                                        let _e3401 = phi_6541_;
                                        let _e3403 = phi_6542_;
                                        let _e3405 = phi_6543_;
                                        let _e3407 = phi_6544_;
                                        let _e3409 = phi_6545_;
                                        let _e3411 = phi_6546_;
                                        let _e3413 = phi_6547_;
                                        let _e3415 = phi_6549_;
                                        phi_4371_ = _e3395;
                                        phi_4373_ = _e3397;
                                        phi_4375_ = _e3399;
                                        phi_4377_ = _e3401;
                                        phi_4379_ = _e3403;
                                        phi_4381_ = _e3405;
                                        phi_6550_ = _e3364;
                                        phi_6552_ = _e3407;
                                        phi_6553_ = _e3409;
                                        phi_6554_ = _e3411;
                                        phi_6555_ = _e3413;
                                        phi_6557_ = false;
                                        phi_6558_ = _e3415;
                                    } else {
                                        phi_4371_ = f32();
                                        phi_4373_ = f32();
                                        phi_4375_ = f32();
                                        phi_4377_ = f32();
                                        phi_4379_ = bool();
                                        phi_4381_ = u32();
                                        phi_6550_ = f32();
                                        phi_6552_ = false;
                                        phi_6553_ = false;
                                        phi_6554_ = false;
                                        phi_6555_ = false;
                                        phi_6557_ = true;
                                        phi_6558_ = false;
                                    }
                                    let _e3417 = phi_4371_;
                                    let _e3419 = phi_4373_;
                                    let _e3421 = phi_4375_;
                                    let _e3423 = phi_4377_;
                                    let _e3425 = phi_4379_;
                                    let _e3427 = phi_4381_;
                                    let _e3429 = phi_6550_;
                                    let _e3431 = phi_6552_;
                                    let _e3433 = phi_6553_;
                                    let _e3435 = phi_6554_;
                                    let _e3437 = phi_6555_;
                                    let _e3439 = phi_6557_;
                                    let _e3441 = phi_6558_;
                                    local_20 = _e3433;
                                    local_21 = _e3435;
                                    local_22 = _e3433;
                                    local_23 = _e3437;
                                    local_24 = _e3433;
                                    local_25 = _e3439;
                                    local_26 = _e3433;
                                    local_27 = _e3441;
                                    local_29 = _e3433;
                                    local_30 = _e3429;
                                    continue;
                                    continuing {
                                        phi_4367_ = type_9(select(_e2413.member, (_e2413.member + 1u), _e2428), select(_e2413.member_1, _e2413.member_1, _e2428));
                                        phi_4370_ = _e3417;
                                        phi_4372_ = _e3419;
                                        phi_4374_ = _e3421;
                                        phi_4376_ = _e3423;
                                        phi_4378_ = _e3425;
                                        phi_4380_ = _e3427;
                                        break if !(_e3431);
                                    }
                                }
                                let _e3444 = local_20;
                                let _e3446 = local_21;
                                let _e3447 = select(_e3446, false, _e3444);
                                let _e3449 = local_22;
                                let _e3451 = local_23;
                                let _e3454 = local_24;
                                let _e3456 = local_25;
                                let _e3459 = local_26;
                                let _e3461 = local_27;
                                let _e3467 = local_28;
                                let _e3469 = select(select(_e3451, false, _e3449), false, _e3447);
                                let _e3471 = local_29;
                                let _e3478 = select(select(_e3471, false, _e3447), false, _e3469);
                                let _e3483 = local_30;
                                let _e3485 = local_31;
                                let _e3487 = select(select(select(select(_e3456, false, _e3454), false, _e3447), false, _e3469), true, _e3478);
                                let _e3494 = select(select(select(select(select(_e3461, false, _e3459), false, _e3447), false, _e3469), false, _e3478), false, _e3487);
                                let _e3499 = select(select(select(select(_e3447, true, _e3469), false, _e3478), false, _e3487), true, _e3494);
                                let _e3502 = (select(select(type_31().member, 1u, _e3487), select(select(select(type_31().member, 1u, _e3447), 0u, _e3469), 0u, _e3494), _e3499) != 0u);
                                phi_6626_ = select(select(type_31().member_1, select(_e3485, _e3483, _e3478), _e3487), select(select(select(type_31().member_1, _e3467, _e3447), type_31().member_1, _e3469), type_31().member_1, _e3494), _e3499);
                                phi_6627_ = select(true, false, _e3502);
                                phi_6628_ = _e3502;
                                phi_6629_ = false;
                                phi_6630_ = false;
                                phi_6631_ = false;
                            } else {
                                phi_6626_ = f32();
                                phi_6627_ = _e2200;
                                phi_6628_ = false;
                                phi_6629_ = _e2202;
                                phi_6630_ = _e2204;
                                phi_6631_ = _e2206;
                            }
                            let _e3505 = phi_6626_;
                            let _e3507 = phi_6627_;
                            let _e3509 = phi_6628_;
                            let _e3511 = phi_6629_;
                            let _e3513 = phi_6630_;
                            let _e3515 = phi_6631_;
                            phi_6632_ = _e2192;
                            phi_6633_ = _e2194;
                            phi_6634_ = _e3505;
                            phi_6635_ = _e2196;
                            phi_6636_ = _e3507;
                            phi_6637_ = _e3509;
                            phi_6638_ = false;
                            phi_6639_ = _e3511;
                            phi_6640_ = _e3513;
                            phi_6641_ = _e3515;
                        } else {
                            phi_6632_ = type_37();
                            phi_6633_ = bool();
                            phi_6634_ = f32();
                            phi_6635_ = type_37();
                            phi_6636_ = false;
                            phi_6637_ = false;
                            phi_6638_ = true;
                            phi_6639_ = false;
                            phi_6640_ = false;
                            phi_6641_ = false;
                        }
                        let _e3517 = phi_6632_;
                        let _e3519 = phi_6633_;
                        let _e3521 = phi_6634_;
                        let _e3523 = phi_6635_;
                        let _e3525 = phi_6636_;
                        let _e3527 = phi_6637_;
                        let _e3529 = phi_6638_;
                        let _e3531 = phi_6639_;
                        let _e3533 = phi_6640_;
                        let _e3535 = phi_6641_;
                        local_32 = _e3527;
                        local_33 = _e3519;
                        local_34 = _e3517;
                        local_35 = _e3521;
                        local_36 = _e3521;
                        local_37 = _e3521;
                        local_41 = _e3529;
                        local_42 = _e3531;
                        local_43 = _e3533;
                        local_44 = _e3535;
                        local_38 = _e3527;
                        local_39 = _e3523;
                        continue;
                        continuing {
                            phi_2512_ = type_9(select(_e1214.member, (_e1214.member + 1u), _e1217), select(_e1214.member_1, _e1214.member_1, _e1217));
                            break if !(_e3525);
                        }
                    }
                    let _e3538 = local_32;
                    if _e3538 {
                        let _e3540 = local_33;
                        if _e3540 {
                            let _e3542 = local_34;
                            let _e3545 = local_35;
                            let _e3547 = ((_e3542.member_1 - _e3545) <= _e1178);
                            let _e3552 = local_36;
                            phi_6657_ = type_31(select(type_31().member, 1u, _e3547), select(type_31().member_1, _e3552, _e3547));
                            phi_6658_ = select(true, false, _e3547);
                        } else {
                            phi_6657_ = type_31();
                            phi_6658_ = true;
                        }
                        let _e3557 = phi_6657_;
                        let _e3559 = phi_6658_;
                        let _e3564 = local_37;
                        phi_6664_ = type_31(select(_e3557.member, 2u, _e3559), select(_e3557.member_1, _e3564, _e3559));
                        phi_6665_ = false;
                        phi_6666_ = false;
                        phi_6667_ = false;
                        phi_6668_ = false;
                    } else {
                        phi_6664_ = type_31();
                        let _e4078 = local_41;
                        phi_6665_ = _e4078;
                        let _e4081 = local_42;
                        phi_6666_ = _e4081;
                        let _e4084 = local_43;
                        phi_6667_ = _e4084;
                        let _e4087 = local_44;
                        phi_6668_ = _e4087;
                    }
                    let _e3568 = phi_6664_;
                    let _e3570 = phi_6665_;
                    let _e3572 = phi_6666_;
                    let _e3574 = phi_6667_;
                    let _e3576 = phi_6668_;
                    let _e3583 = select(_e3572, false, _e3570);
                    let _e3587 = local_38;
                    let _e3594 = select(select(_e3574, false, _e3570), false, _e3583);
                    let _e3600 = select(select(select(_e3576, false, _e3570), false, _e3583), false, _e3594);
                    let _e3604 = local_39;
                    let _e3608 = select(select(_e3583, true, _e3594), true, _e3600);
                    phi_6710_ = type_31(select(_e3568.member, select(select(select(type_31().member, 0u, _e3583), 0u, _e3594), 1u, _e3600), _e3608), select(_e3568.member_1, select(select(select(type_31().member_1, type_31().member_1, _e3583), type_31().member_1, _e3594), _e3604.member, _e3600), _e3608));
                    phi_6711_ = type_31(select(type_31().member, 0u, _e3570), select(type_31().member_1, type_31().member_1, _e3570));
                    phi_6712_ = select(select(select(select(select(_e3587, false, _e3570), false, _e3583), false, _e3594), false, _e3600), true, _e3608);
                }
                let _e3619 = phi_6710_;
                let _e3621 = phi_6711_;
                let _e3623 = phi_6712_;
                let _e3626 = select(_e3621.member, _e3619.member, _e3623);
                let _e3629 = select(_e3621.member_1, _e3619.member_1, _e3623);
                let _e3635 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e3629 > _e349)), (_e3626 == 1u))));
                switch bitcast<i32>(_e3626) {
                    case 0: {
                        phi_6756_ = type_32(0u, _e3635, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e3639 = function_3(_e3629);
                        phi_6756_ = type_32(0u, _e3635, _e3639, true);
                        break;
                    }
                    case 2: {
                        let _e3637 = function_3(_e3629);
                        phi_6756_ = type_32(1u, _e3635, _e3637, true);
                        break;
                    }
                    default: {
                        phi_6756_ = type_32();
                        break;
                    }
                }
                let _e3643 = phi_6756_;
                let _e3647 = params.member.member.member_12;
                let _e3648 = bitcast<u32>(_e3647);
                if (_e3643.member_2[0] == select((_e3648 << bitcast<u32>(29i)), 0u, ((_e3648 & 2147483647u) < 8388608u))) {
                    let _e3658 = params.member.member.member_12;
                    let _e3659 = bitcast<u32>(_e3658);
                    let _e3660 = (_e3659 & 2147483647u);
                    phi_6796_ = (_e3643.member_2[1] == select(((_e3659 ^ _e3660) | ((_e3660 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e3660 < 8388608u)));
                } else {
                    phi_6796_ = false;
                }
                let _e3670 = phi_6796_;
                let _e3672 = params.member.member.member_1;
                if ((_e3672 & 128u) != 0u) {
                    phi_6812_ = true;
                } else {
                    let _e3676 = params.member.member.member_1;
                    phi_6812_ = select(false, _e3670, ((_e3676 & 64u) != 0u));
                }
                let _e3681 = phi_6812_;
                phi_6831_ = type_32(select(1u, _e3643.member, select(true, select(true, false, _e3681), _e3643.member_3)), _e3643.member_1, _e3643.member_2, _e3643.member_3);
                phi_6832_ = type_9(_e185, _e188);
            } else {
                phi_6831_ = type_32(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_6832_ = type_9(0u, 0u);
            }
            let _e3692 = phi_6831_;
            let _e3694 = phi_6832_;
            let _e3698 = (_e3692.member != 0u);
            let _e3701 = select(false, !(_e3698), _e3692.member_3);
            if _e3701 {
                let _e3705 = (_e3692.member_2[1] >> bitcast<u32>(20i));
                if (_e3705 <= 896u) {
                    phi_6862_ = 0u;
                } else {
                    phi_6862_ = ((((_e3705 - 896u) << bitcast<u32>(23i)) | ((_e3692.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e3692.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e3720 = phi_6862_;
                let _e3722 = atomicMin((&earliest.member[0u]), _e3720);
            }
            let _e3725 = params.member.member.member_1;
            if ((_e3725 & 16u) != 0u) {
                if (_e102 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e3701 {
                    let _e3731 = atomicAdd((&counters[0u]), 1u);
                    phi_6884_ = _e3731;
                } else {
                    phi_6884_ = 0u;
                }
                let _e3733 = phi_6884_;
                workgroupBarrier();
                if (_e102 == 0u) {
                    let _e3736 = atomicLoad((&counters[0u]));
                    if (_e3736 > 0u) {
                        let _e3739 = atomicAdd((&contacts.member[0u]), _e3736);
                        atomicStore((&counters[1u]), _e3739);
                    }
                }
                workgroupBarrier();
                let _e3742 = atomicLoad((&counters[1u]));
                let _e3743 = (_e3742 + _e3733);
                if _e3701 {
                    let _e3746 = params.member.member_1.member_3;
                    let _e3748 = params.member.member_2.member;
                    if (_e3743 < _e3746) {
                        let _e3750 = (7u * _e3743);
                        atomicStore((&contacts.member[(4u + _e3750)]), _e3748);
                        atomicStore((&contacts.member[(_e3750 + 5u)]), _e3692.member);
                        atomicStore((&contacts.member[(_e3750 + 6u)]), _e3694.member);
                        atomicStore((&contacts.member[(_e3750 + 7u)]), _e3694.member_1);
                        atomicStore((&contacts.member[(_e3750 + 8u)]), _e3692.member_2[0]);
                        atomicStore((&contacts.member[(_e3750 + 9u)]), _e3692.member_2[1]);
                        atomicStore((&contacts.member[(_e3750 + 10u)]), _e3692.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e102 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e3698 {
                let _e3774 = atomicAdd((&counters[0u]), 1u);
                phi_6950_ = _e3774;
            } else {
                phi_6950_ = 0u;
            }
            let _e3776 = phi_6950_;
            workgroupBarrier();
            if (_e102 == 0u) {
                let _e3779 = atomicLoad((&counters[0u]));
                if (_e3779 > 0u) {
                    let _e3782 = atomicAdd((&undecided.member[0u]), _e3779);
                    atomicStore((&counters[1u]), _e3782);
                }
            }
            workgroupBarrier();
            let _e3785 = atomicLoad((&counters[1u]));
            let _e3786 = (_e3785 + _e3776);
            if _e3698 {
                let _e3788 = params.member.member_2.member_1;
                if (_e3786 < _e3788) {
                    let _e3790 = (2u * _e3786);
                    atomicStore((&undecided.member[(4u + _e3790)]), _e3694.member);
                    atomicStore((&undecided.member[(_e3790 + 5u)]), _e3694.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_824_ = type_9(select(_e156.member, (_e156.member + 1u), _e159), select(_e156.member_1, _e156.member_1, _e159));
            break if !(_e172);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
