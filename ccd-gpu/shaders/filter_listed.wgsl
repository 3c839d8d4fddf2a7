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

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_25 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_27 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_30 {
    member: array<type_28>,
}

struct type_31 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_32 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
}

struct type_36 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(1) 
var<storage> boxes: type_21;
@group(0) @binding(3) 
var<storage> bodies: type_13;
@group(0) @binding(4) 
var<storage> keys: type_25;
@group(0) @binding(5) 
var<storage> paths: type_30;
@group(0) @binding(6) 
var<storage> input: type_13;
@group(0) @binding(7) 
var<storage, read_write> output: type_36;
@group(0) @binding(2) 
var<storage> elements: type_13;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_145_: bool;
    var phi_146_: bool;
    var phi_150_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_146_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_145_ = (param[0] > param_1[0]);
        } else {
            phi_145_ = false;
        }
        let _e14 = phi_145_;
        phi_146_ = _e14;
    }
    let _e16 = phi_146_;
    if _e16 {
        phi_150_ = param_1;
    } else {
        phi_150_ = param;
    }
    let _e18 = phi_150_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_169_: bool;
    var phi_170_: bool;
    var phi_174_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_170_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_169_ = (param_3[0] > param_2[0]);
        } else {
            phi_169_ = false;
        }
        let _e14 = phi_169_;
        phi_170_ = _e14;
    }
    let _e16 = phi_170_;
    if _e16 {
        phi_174_ = param_3;
    } else {
        phi_174_ = param_2;
    }
    let _e18 = phi_174_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_193_: bool;
    var phi_194_: bool;
    var phi_198_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_194_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_193_ = (param_4[0] > param_5[0]);
        } else {
            phi_193_ = false;
        }
        let _e14 = phi_193_;
        phi_194_ = _e14;
    }
    let _e16 = phi_194_;
    if _e16 {
        phi_198_ = param_5;
    } else {
        phi_198_ = param_4;
    }
    let _e18 = phi_198_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_217_: bool;
    var phi_218_: bool;
    var phi_222_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_218_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_217_ = (param_7[0] > param_6[0]);
        } else {
            phi_217_ = false;
        }
        let _e14 = phi_217_;
        phi_218_ = _e14;
    }
    let _e16 = phi_218_;
    if _e16 {
        phi_222_ = param_7;
    } else {
        phi_222_ = param_6;
    }
    let _e18 = phi_222_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_241_: bool;
    var phi_242_: bool;
    var phi_246_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_242_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_241_ = (param_8[0] > param_9[0]);
        } else {
            phi_241_ = false;
        }
        let _e14 = phi_241_;
        phi_242_ = _e14;
    }
    let _e16 = phi_242_;
    if _e16 {
        phi_246_ = param_9;
    } else {
        phi_246_ = param_8;
    }
    let _e18 = phi_246_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_265_: bool;
    var phi_266_: bool;
    var phi_270_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_266_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_265_ = (param_11[0] > param_10[0]);
        } else {
            phi_265_ = false;
        }
        let _e14 = phi_265_;
        phi_266_ = _e14;
    }
    let _e16 = phi_266_;
    if _e16 {
        phi_270_ = param_11;
    } else {
        phi_270_ = param_10;
    }
    let _e18 = phi_270_;
    return _e18;
}

fn function_6(param_12: f32, param_13: f32) -> f32 {
    var phi_282_: bool;
    var phi_286_: f32;

    if (param_12 != param_12) {
        phi_282_ = true;
    } else {
        phi_282_ = (param_13 <= param_12);
    }
    let _e6 = phi_282_;
    if _e6 {
        phi_286_ = param_13;
    } else {
        phi_286_ = param_12;
    }
    let _e8 = phi_286_;
    return _e8;
}

fn function_7(param_14: f32, param_15: f32) -> f32 {
    var phi_298_: bool;
    var phi_302_: f32;

    if (param_14 != param_14) {
        phi_298_ = true;
    } else {
        phi_298_ = (param_15 >= param_14);
    }
    let _e6 = phi_298_;
    if _e6 {
        phi_302_ = param_15;
    } else {
        phi_302_ = param_14;
    }
    let _e8 = phi_302_;
    return _e8;
}

fn function_8(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_27;
    var local_1: type_27;
    var local_2: type_27;
    var phi_352_: u32;
    var phi_362_: u32;
    var phi_369_: u32;
    var phi_385_: u32;
    var phi_406_: u32;
    var phi_407_: u32;
    var phi_410_: type_9;
    var phi_411_: type_9;
    var phi_434_: type_9;
    var phi_569_: type_31;
    var phi_584_: array<u32, 3>;
    var phi_585_: array<u32, 3>;
    var phi_607_: array<u32, 2>;
    var phi_675_: bool;
    var phi_681_: bool;
    var phi_649_: bool;
    var phi_656_: bool;
    var phi_664_: bool;
    var phi_683_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_740_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_892_: u32;
    var phi_893_: u32;
    var phi_894_: u32;
    var phi_895_: u32;
    var phi_898_: type_16;
    var phi_901_: u32;
    var phi_903_: u32;
    var phi_924_: bool;
    var phi_930_: type_17;
    var phi_899_: type_16;
    var phi_944_: type_17;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1014_: bool;
    var phi_1015_: bool;
    var phi_1019_: bool;
    var phi_1020_: bool;
    var phi_1025_: u32;
    var phi_1026_: u32;
    var phi_1027_: u32;
    var phi_1028_: u32;
    var phi_1029_: bool;
    var phi_902_: u32;
    var phi_904_: u32;
    var phi_1030_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1080_: bool;
    var phi_1081_: bool;
    var phi_1085_: bool;
    var phi_1086_: bool;
    var phi_1090_: bool;
    var phi_1094_: bool;
    var phi_1095_: bool;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1104_: bool;
    var phi_1105_: bool;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1335_: bool;
    var phi_1336_: bool;
    var phi_1430_: bool;
    var phi_1431_: bool;
    var phi_1524_: bool;
    var phi_1525_: bool;
    var phi_1620_: bool;
    var phi_1621_: bool;
    var phi_1714_: bool;
    var phi_1715_: bool;
    var phi_1719_: bool;
    var phi_1720_: bool;
    var phi_1721_: bool;
    var phi_1725_: bool;
    var phi_1726_: bool;
    var phi_1727_: bool;
    var phi_1728_: bool;
    var phi_1729_: bool;
    var phi_1733_: bool;
    var phi_1865_: type_32;
    var phi_1912_: type_32;
    var phi_2110_: type_27;
    var phi_2390_: f32;
    var phi_2397_: f32;
    var phi_2402_: f32;
    var phi_2409_: f32;
    var phi_2414_: f32;
    var phi_2427_: f32;
    var phi_2434_: f32;
    var phi_2439_: f32;
    var phi_2446_: f32;
    var phi_2451_: f32;
    var phi_2456_: f32;
    var phi_2473_: f32;
    var phi_2480_: f32;
    var phi_2485_: f32;
    var phi_2492_: f32;
    var phi_2497_: f32;
    var phi_2511_: f32;
    var phi_2518_: f32;
    var phi_2523_: f32;
    var phi_2530_: f32;
    var phi_2535_: f32;
    var phi_2540_: f32;
    var phi_2557_: f32;
    var phi_2564_: f32;
    var phi_2569_: f32;
    var phi_2576_: f32;
    var phi_2581_: f32;
    var phi_2595_: f32;
    var phi_2602_: f32;
    var phi_2607_: f32;
    var phi_2614_: f32;
    var phi_2619_: f32;
    var phi_2624_: f32;
    var phi_2655_: f32;
    var phi_2661_: f32;
    var phi_2668_: f32;
    var phi_2675_: f32;
    var phi_2681_: f32;
    var phi_2688_: f32;
    var phi_2694_: f32;
    var phi_2700_: f32;
    var phi_2706_: f32;
    var phi_2713_: f32;
    var phi_2720_: f32;
    var phi_2744_: f32;
    var phi_2749_: f32;
    var phi_2754_: f32;
    var phi_2759_: f32;
    var phi_2764_: f32;
    var phi_2769_: f32;
    var phi_2779_: f32;
    var phi_2895_: array<f32, 3>;
    var phi_2960_: array<f32, 3>;
    var phi_2982_: f32;
    var phi_2989_: f32;
    var phi_2994_: f32;
    var phi_3001_: f32;
    var phi_3006_: f32;
    var phi_3019_: f32;
    var phi_3026_: f32;
    var phi_3031_: f32;
    var phi_3038_: f32;
    var phi_3043_: f32;
    var phi_3048_: f32;
    var phi_3065_: f32;
    var phi_3072_: f32;
    var phi_3077_: f32;
    var phi_3084_: f32;
    var phi_3089_: f32;
    var phi_3103_: f32;
    var phi_3110_: f32;
    var phi_3115_: f32;
    var phi_3122_: f32;
    var phi_3127_: f32;
    var phi_3132_: f32;
    var phi_3149_: f32;
    var phi_3156_: f32;
    var phi_3161_: f32;
    var phi_3168_: f32;
    var phi_3173_: f32;
    var phi_3187_: f32;
    var phi_3194_: f32;
    var phi_3199_: f32;
    var phi_3206_: f32;
    var phi_3211_: f32;
    var phi_3216_: f32;
    var phi_3295_: f32;
    var phi_3300_: f32;
    var phi_3305_: f32;
    var phi_3310_: f32;
    var phi_3315_: f32;
    var phi_3320_: f32;
    var phi_3325_: f32;
    var phi_3330_: f32;
    var phi_3335_: f32;
    var phi_3340_: f32;
    var phi_3345_: f32;
    var phi_3350_: f32;
    var phi_3355_: f32;
    var phi_3360_: f32;
    var phi_3366_: f32;
    var phi_3372_: f32;
    var phi_3379_: f32;
    var phi_3390_: f32;
    var phi_3461_: f32;
    var phi_3466_: f32;
    var phi_3471_: f32;
    var phi_3476_: f32;
    var phi_3481_: f32;
    var phi_3486_: f32;
    var phi_3491_: f32;
    var phi_3496_: f32;
    var phi_3501_: f32;
    var phi_3506_: f32;
    var phi_3511_: f32;
    var phi_3516_: f32;
    var phi_3521_: f32;
    var phi_3526_: f32;
    var phi_3532_: f32;
    var phi_3538_: f32;
    var phi_3545_: f32;
    var phi_3556_: f32;
    var phi_3566_: f32;
    var phi_3639_: f32;
    var phi_3644_: f32;
    var phi_3649_: f32;
    var phi_3654_: f32;
    var phi_3659_: f32;
    var phi_3664_: f32;
    var phi_3669_: f32;
    var phi_3674_: f32;
    var phi_3679_: f32;
    var phi_3684_: f32;
    var phi_3689_: f32;
    var phi_3694_: f32;
    var phi_3699_: f32;
    var phi_3704_: f32;
    var phi_3710_: f32;
    var phi_3716_: f32;
    var phi_3723_: f32;
    var phi_3734_: f32;
    var phi_3744_: f32;
    var phi_3745_: f32;
    var phi_3748_: bool;
    var phi_4200_: f32;
    var phi_4207_: f32;
    var phi_4212_: f32;
    var phi_4219_: f32;
    var phi_4224_: f32;
    var phi_4237_: f32;
    var phi_4244_: f32;
    var phi_4249_: f32;
    var phi_4256_: f32;
    var phi_4261_: f32;
    var phi_4266_: f32;
    var phi_4283_: f32;
    var phi_4290_: f32;
    var phi_4295_: f32;
    var phi_4302_: f32;
    var phi_4307_: f32;
    var phi_4321_: f32;
    var phi_4328_: f32;
    var phi_4333_: f32;
    var phi_4340_: f32;
    var phi_4345_: f32;
    var phi_4350_: f32;
    var phi_4367_: f32;
    var phi_4374_: f32;
    var phi_4379_: f32;
    var phi_4386_: f32;
    var phi_4391_: f32;
    var phi_4405_: f32;
    var phi_4412_: f32;
    var phi_4417_: f32;
    var phi_4424_: f32;
    var phi_4429_: f32;
    var phi_4434_: f32;
    var phi_4465_: f32;
    var phi_4471_: f32;
    var phi_4478_: f32;
    var phi_4485_: f32;
    var phi_4491_: f32;
    var phi_4498_: f32;
    var phi_4504_: f32;
    var phi_4510_: f32;
    var phi_4516_: f32;
    var phi_4523_: f32;
    var phi_4530_: f32;
    var phi_4554_: f32;
    var phi_4559_: f32;
    var phi_4564_: f32;
    var phi_4569_: f32;
    var phi_4574_: f32;
    var phi_4579_: f32;
    var phi_4589_: f32;
    var phi_4705_: array<f32, 3>;
    var phi_4770_: array<f32, 3>;
    var phi_4792_: f32;
    var phi_4799_: f32;
    var phi_4804_: f32;
    var phi_4811_: f32;
    var phi_4816_: f32;
    var phi_4829_: f32;
    var phi_4836_: f32;
    var phi_4841_: f32;
    var phi_4848_: f32;
    var phi_4853_: f32;
    var phi_4858_: f32;
    var phi_4875_: f32;
    var phi_4882_: f32;
    var phi_4887_: f32;
    var phi_4894_: f32;
    var phi_4899_: f32;
    var phi_4913_: f32;
    var phi_4920_: f32;
    var phi_4925_: f32;
    var phi_4932_: f32;
    var phi_4937_: f32;
    var phi_4942_: f32;
    var phi_4959_: f32;
    var phi_4966_: f32;
    var phi_4971_: f32;
    var phi_4978_: f32;
    var phi_4983_: f32;
    var phi_4997_: f32;
    var phi_5004_: f32;
    var phi_5009_: f32;
    var phi_5016_: f32;
    var phi_5021_: f32;
    var phi_5026_: f32;
    var phi_5105_: f32;
    var phi_5110_: f32;
    var phi_5115_: f32;
    var phi_5120_: f32;
    var phi_5125_: f32;
    var phi_5130_: f32;
    var phi_5135_: f32;
    var phi_5140_: f32;
    var phi_5145_: f32;
    var phi_5150_: f32;
    var phi_5155_: f32;
    var phi_5160_: f32;
    var phi_5165_: f32;
    var phi_5170_: f32;
    var phi_5176_: f32;
    var phi_5182_: f32;
    var phi_5189_: f32;
    var phi_5200_: f32;
    var phi_5271_: f32;
    var phi_5276_: f32;
    var phi_5281_: f32;
    var phi_5286_: f32;
    var phi_5291_: f32;
    var phi_5296_: f32;
    var phi_5301_: f32;
    var phi_5306_: f32;
    var phi_5311_: f32;
    var phi_5316_: f32;
    var phi_5321_: f32;
    var phi_5326_: f32;
    var phi_5331_: f32;
    var phi_5336_: f32;
    var phi_5342_: f32;
    var phi_5348_: f32;
    var phi_5355_: f32;
    var phi_5366_: f32;
    var phi_5376_: f32;
    var phi_5449_: f32;
    var phi_5454_: f32;
    var phi_5459_: f32;
    var phi_5464_: f32;
    var phi_5469_: f32;
    var phi_5474_: f32;
    var phi_5479_: f32;
    var phi_5484_: f32;
    var phi_5489_: f32;
    var phi_5494_: f32;
    var phi_5499_: f32;
    var phi_5504_: f32;
    var phi_5509_: f32;
    var phi_5514_: f32;
    var phi_5520_: f32;
    var phi_5526_: f32;
    var phi_5533_: f32;
    var phi_5544_: f32;
    var phi_5554_: f32;
    var phi_5555_: f32;
    var phi_5558_: bool;
    var phi_5803_: f32;
    var phi_5810_: f32;
    var phi_5815_: f32;
    var phi_5822_: f32;
    var phi_5827_: f32;
    var phi_5840_: f32;
    var phi_5847_: f32;
    var phi_5852_: f32;
    var phi_5859_: f32;
    var phi_5864_: f32;
    var phi_5869_: f32;
    var phi_5886_: f32;
    var phi_5893_: f32;
    var phi_5898_: f32;
    var phi_5905_: f32;
    var phi_5910_: f32;
    var phi_5924_: f32;
    var phi_5931_: f32;
    var phi_5936_: f32;
    var phi_5943_: f32;
    var phi_5948_: f32;
    var phi_5953_: f32;
    var phi_5970_: f32;
    var phi_5977_: f32;
    var phi_5982_: f32;
    var phi_5989_: f32;
    var phi_5994_: f32;
    var phi_6008_: f32;
    var phi_6015_: f32;
    var phi_6020_: f32;
    var phi_6027_: f32;
    var phi_6032_: f32;
    var phi_6037_: f32;
    var phi_6068_: f32;
    var phi_6074_: f32;
    var phi_6081_: f32;
    var phi_6088_: f32;
    var phi_6094_: f32;
    var phi_6101_: f32;
    var phi_6107_: f32;
    var phi_6113_: f32;
    var phi_6119_: f32;
    var phi_6126_: f32;
    var phi_6133_: f32;
    var phi_6157_: f32;
    var phi_6162_: f32;
    var phi_6167_: f32;
    var phi_6172_: f32;
    var phi_6177_: f32;
    var phi_6182_: f32;
    var phi_6192_: f32;
    var phi_6308_: array<f32, 3>;
    var phi_6373_: array<f32, 3>;
    var phi_6395_: f32;
    var phi_6402_: f32;
    var phi_6407_: f32;
    var phi_6414_: f32;
    var phi_6419_: f32;
    var phi_6432_: f32;
    var phi_6439_: f32;
    var phi_6444_: f32;
    var phi_6451_: f32;
    var phi_6456_: f32;
    var phi_6461_: f32;
    var phi_6478_: f32;
    var phi_6485_: f32;
    var phi_6490_: f32;
    var phi_6497_: f32;
    var phi_6502_: f32;
    var phi_6516_: f32;
    var phi_6523_: f32;
    var phi_6528_: f32;
    var phi_6535_: f32;
    var phi_6540_: f32;
    var phi_6545_: f32;
    var phi_6562_: f32;
    var phi_6569_: f32;
    var phi_6574_: f32;
    var phi_6581_: f32;
    var phi_6586_: f32;
    var phi_6600_: f32;
    var phi_6607_: f32;
    var phi_6612_: f32;
    var phi_6619_: f32;
    var phi_6624_: f32;
    var phi_6629_: f32;
    var phi_6708_: f32;
    var phi_6713_: f32;
    var phi_6718_: f32;
    var phi_6723_: f32;
    var phi_6728_: f32;
    var phi_6733_: f32;
    var phi_6738_: f32;
    var phi_6743_: f32;
    var phi_6748_: f32;
    var phi_6753_: f32;
    var phi_6758_: f32;
    var phi_6763_: f32;
    var phi_6768_: f32;
    var phi_6773_: f32;
    var phi_6779_: f32;
    var phi_6785_: f32;
    var phi_6792_: f32;
    var phi_6803_: f32;
    var phi_6874_: f32;
    var phi_6879_: f32;
    var phi_6884_: f32;
    var phi_6889_: f32;
    var phi_6894_: f32;
    var phi_6899_: f32;
    var phi_6904_: f32;
    var phi_6909_: f32;
    var phi_6914_: f32;
    var phi_6919_: f32;
    var phi_6924_: f32;
    var phi_6929_: f32;
    var phi_6934_: f32;
    var phi_6939_: f32;
    var phi_6945_: f32;
    var phi_6951_: f32;
    var phi_6958_: f32;
    var phi_6969_: f32;
    var phi_6979_: f32;
    var phi_7052_: f32;
    var phi_7057_: f32;
    var phi_7062_: f32;
    var phi_7067_: f32;
    var phi_7072_: f32;
    var phi_7077_: f32;
    var phi_7082_: f32;
    var phi_7087_: f32;
    var phi_7092_: f32;
    var phi_7097_: f32;
    var phi_7102_: f32;
    var phi_7107_: f32;
    var phi_7112_: f32;
    var phi_7117_: f32;
    var phi_7123_: f32;
    var phi_7129_: f32;
    var phi_7136_: f32;
    var phi_7147_: f32;
    var phi_7157_: f32;
    var phi_7158_: f32;
    var phi_7161_: bool;
    var phi_7163_: bool;
    var phi_7165_: bool;
    var phi_7167_: bool;
    var phi_7173_: u32;
    var phi_7174_: u32;
    var phi_7175_: bool;
    var phi_7176_: u32;
    var phi_7177_: bool;
    var phi_7178_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e51 = id_2;
    let _e52 = n_2;
    let _e53 = lane_2;
    let _e66 = ((_e51.y * _e52.x) + _e51.x);
    let _e69 = (_e52.x * _e52.y);
    let _e73 = params.member.member_2.member;
    let _e75 = params.member.member_1.member_2;
    let _e77 = input.member[0u];
    if (_e75 < _e77) {
        phi_352_ = _e75;
    } else {
        phi_352_ = _e77;
    }
    let _e80 = phi_352_;
    let _e82 = params.member.member_1.member_1;
    if (_e80 > _e82) {
        let _e85 = params.member.member_1.member_1;
        phi_362_ = (_e80 - _e85);
    } else {
        phi_362_ = 0u;
    }
    let _e88 = phi_362_;
    let _e90 = params.member.member_1.member;
    if (_e90 < _e88) {
        phi_369_ = _e90;
    } else {
        phi_369_ = _e88;
    }
    let _e93 = phi_369_;
    let _e94 = (_e93 / 128u);
    if ((_e93 % 128u) > 0u) {
        phi_385_ = (_e94 + 1u);
    } else {
        phi_385_ = _e94;
    }
    let _e99 = phi_385_;
    if (_e99 > _e66) {
        let _e101 = (_e99 - _e66);
        if (_e69 == 0u) {
            return;
        }
        let _e103 = (_e101 / _e69);
        if (_e69 == 0u) {
            return;
        }
        if ((_e101 % _e69) > 0u) {
            phi_406_ = (_e103 + 1u);
        } else {
            phi_406_ = _e103;
        }
        let _e109 = phi_406_;
        phi_407_ = _e109;
    } else {
        phi_407_ = 0u;
    }
    let _e111 = phi_407_;
    phi_410_ = type_9(0u, _e111);
    loop {
        let _e114 = phi_410_;
        if (_e114.member < _e114.member_1) {
            phi_411_ = type_9((_e114.member + 1u), _e114.member_1);
            phi_434_ = type_9(1u, _e114.member);
        } else {
            phi_411_ = _e114;
            phi_434_ = type_9(0u, type_9().member_1);
        }
        let _e126 = phi_411_;
        let _e128 = phi_434_;
        let _e132 = (bitcast<i32>(_e128.member) != 0i);
        if _e132 {
            let _e136 = (((_e66 + (_e128.member_1 * _e69)) * 128u) + _e53);
            if (_e53 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e136 < _e93) {
                let _e142 = params.member.member_1.member_1;
                let _e144 = (2u * (_e142 + _e136));
                let _e147 = input.member[(4u + _e144)];
                let _e150 = input.member[(_e144 + 5u)];
                if (_e73 == 0u) {
                    let _e167 = (3u * _e150);
                    let _e169 = elements.member[_e167];
                    let _e172 = elements.member[(_e167 + 1u)];
                    let _e175 = elements.member[(_e167 + 2u)];
                    phi_569_ = type_31(0u, array<u32, 4>(_e147, _e169, _e172, _e175));
                } else {
                    let _e153 = (2u * _e147);
                    let _e154 = (2u * _e150);
                    let _e156 = elements.member[_e153];
                    let _e158 = elements.member[_e154];
                    let _e161 = elements.member[(_e153 + 1u)];
                    let _e164 = elements.member[(_e154 + 1u)];
                    phi_569_ = type_31(1u, array<u32, 4>(_e156, _e161, _e158, _e164));
                }
                let _e179 = phi_569_;
                if (_e73 == 0u) {
                    phi_584_ = array<u32, 3>(_e179.member_1[1], _e179.member_1[2], _e179.member_1[3]);
                    phi_585_ = array<u32, 3>(_e179.member_1[0], _e179.member_1[0], _e179.member_1[0]);
                } else {
                    phi_584_ = array<u32, 3>(_e179.member_1[2], _e179.member_1[3], _e179.member_1[3]);
                    phi_585_ = array<u32, 3>(_e179.member_1[0], _e179.member_1[1], _e179.member_1[1]);
                }
                let _e192 = phi_584_;
                let _e194 = phi_585_;
                if (_e73 == 0u) {
                    let _e208 = params.member.member.member_2[2u];
                    phi_607_ = array<u32, 2>(_e147, (_e208 + _e150));
                } else {
                    let _e199 = params.member.member.member_2[1u];
                    let _e203 = params.member.member.member_2[1u];
                    phi_607_ = array<u32, 2>((_e199 + _e147), (_e203 + _e150));
                }
                let _e212 = phi_607_;
                let _e216 = boxes.member[_e212[0]];
                let _e218 = boxes.member[_e212[1]];
                let _e221 = params.member.member.member_1;
                if ((_e221 & 1u) != 0u) {
                    if (_e73 == 0u) {
                        if (_e192[0] == _e194[0]) {
                            phi_649_ = true;
                        } else {
                            phi_649_ = (_e192[0] == _e194[0]);
                        }
                        let _e243 = phi_649_;
                        if (_e192[1] == _e194[0]) {
                            phi_656_ = true;
                        } else {
                            phi_656_ = (_e192[1] == _e194[0]);
                        }
                        let _e248 = phi_656_;
                        if (_e192[2] == _e194[0]) {
                            phi_664_ = true;
                        } else {
                            phi_664_ = (_e192[2] == _e194[0]);
                        }
                        let _e254 = phi_664_;
                        phi_683_ = ((_e243 || _e248) || _e254);
                    } else {
                        if (_e192[0] == _e194[0]) {
                            phi_675_ = true;
                        } else {
                            phi_675_ = (_e192[0] == _e194[1]);
                        }
                        let _e232 = phi_675_;
                        if (_e192[1] == _e194[0]) {
                            phi_681_ = true;
                        } else {
                            phi_681_ = (_e192[1] == _e194[1]);
                        }
                        let _e236 = phi_681_;
                        phi_683_ = (_e232 || _e236);
                    }
                    let _e257 = phi_683_;
                    if _e257 {
                        phi_687_ = false;
                    } else {
                        phi_687_ = true;
                    }
                    let _e259 = phi_687_;
                    phi_688_ = _e259;
                } else {
                    phi_688_ = true;
                }
                let _e261 = phi_688_;
                if _e261 {
                    let _e263 = params.member.member.member_1;
                    if ((_e263 & 2u) != 0u) {
                        let _e268 = bodies.member[_e194[0]];
                        let _e271 = bodies.member[_e192[0]];
                        if ((_e268 / 4u) != (_e271 / 4u)) {
                            phi_733_ = true;
                        } else {
                            if ((_e268 & 2u) == 0u) {
                                phi_732_ = false;
                            } else {
                                phi_732_ = true;
                            }
                            let _e278 = phi_732_;
                            phi_733_ = _e278;
                        }
                        let _e280 = phi_733_;
                        if _e280 {
                            phi_740_ = (((_e268 & _e271) & 1u) == 0u);
                        } else {
                            phi_740_ = false;
                        }
                        let _e285 = phi_740_;
                        if _e285 {
                            let _e287 = params.member.member.member_1;
                            if ((_e287 & 4u) != 0u) {
                                let _e292 = params.member.member.member[0u];
                                let _e294 = bodies.member[_e292];
                                let _e297 = bodies.member[(_e292 + 1u)];
                                let _e302 = ((_e292 + 4u) + (2u * (_e268 >> bitcast<u32>(2i))));
                                let _e307 = ((_e292 + 4u) + (2u * (_e271 >> bitcast<u32>(2i))));
                                let _e309 = bodies.member[_e302];
                                let _e311 = bodies.member[_e307];
                                let _e320 = bodies.member[((((_e292 + 4u) + (2u * _e294)) + (_e309 * _e297)) + (_e311 / 32u))];
                                let _e323 = bodies.member[(_e302 + 1u)];
                                let _e326 = bodies.member[(_e307 + 1u)];
                                if (_e323 == _e326) {
                                    if (((_e320 >> bitcast<u32>(((_e311 % 32u) & 31u))) & 1u) == 1u) {
                                        phi_856_ = true;
                                    } else {
                                        phi_856_ = ((_e268 >> bitcast<u32>(2i)) == (_e271 >> bitcast<u32>(2i)));
                                    }
                                    let _e340 = phi_856_;
                                    phi_857_ = _e340;
                                } else {
                                    phi_857_ = false;
                                }
                                let _e342 = phi_857_;
                                if _e342 {
                                    let _e345 = bodies.member[(_e292 + 2u)];
                                    let _e348 = bodies.member[(_e292 + 3u)];
                                    let _e349 = (_e348 + _e292);
                                    if (_e73 == 1u) {
                                        if (_e150 < _e147) {
                                            phi_892_ = _e147;
                                            phi_893_ = _e150;
                                        } else {
                                            phi_892_ = _e150;
                                            phi_893_ = _e147;
                                        }
                                        let _e353 = phi_892_;
                                        let _e355 = phi_893_;
                                        phi_894_ = _e353;
                                        phi_895_ = _e355;
                                    } else {
                                        phi_894_ = _e150;
                                        phi_895_ = _e147;
                                    }
                                    let _e357 = phi_894_;
                                    let _e359 = phi_895_;
                                    phi_898_ = type_16(0i, 32i);
                                    phi_901_ = _e345;
                                    phi_903_ = 0u;
                                    loop {
                                        let _e361 = phi_898_;
                                        let _e363 = phi_901_;
                                        let _e365 = phi_903_;
                                        local_3 = _e365;
                                        local_4 = _e365;
                                        if (_e361.member < _e361.member_1) {
                                            let _e372 = (_e361.member + 1i);
                                            if ((false == (_e372 > _e361.member)) != false) {
                                                phi_924_ = true;
                                            } else {
                                                phi_924_ = false;
                                            }
                                            let _e377 = phi_924_;
                                            if _e377 {
                                                phi_930_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_930_ = type_17(1u, _e372);
                                            }
                                            let _e382 = phi_930_;
                                            phi_899_ = type_16(_e382.member_1, _e361.member_1);
                                            phi_944_ = type_17(1u, _e361.member);
                                        } else {
                                            phi_899_ = _e361;
                                            phi_944_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e388 = phi_899_;
                                        let _e390 = phi_944_;
                                        if (bitcast<i32>(_e390.member) != 0i) {
                                            if (_e365 >= _e363) {
                                                phi_1027_ = u32();
                                                phi_1028_ = u32();
                                                phi_1029_ = false;
                                            } else {
                                                let _e397 = (_e365 + ((_e363 - _e365) / 2u));
                                                let _e399 = (_e349 + (3u * _e397));
                                                let _e401 = bodies.member[_e399];
                                                let _e404 = bodies.member[(_e399 + 1u)];
                                                let _e407 = bodies.member[(_e399 + 2u)];
                                                if (_e401 < _e73) {
                                                    phi_1020_ = true;
                                                } else {
                                                    if (_e401 == _e73) {
                                                        if (_e404 < _e359) {
                                                            phi_1014_ = false;
                                                        } else {
                                                            if (_e404 == _e359) {
                                                                if (_e407 < _e357) {
                                                                    phi_1012_ = false;
                                                                } else {
                                                                    phi_1012_ = true;
                                                                }
                                                                let _e414 = phi_1012_;
                                                                phi_1013_ = _e414;
                                                            } else {
                                                                phi_1013_ = true;
                                                            }
                                                            let _e416 = phi_1013_;
                                                            phi_1014_ = _e416;
                                                        }
                                                        let _e418 = phi_1014_;
                                                        phi_1015_ = _e418;
                                                    } else {
                                                        phi_1015_ = true;
                                                    }
                                                    let _e420 = phi_1015_;
                                                    if _e420 {
                                                        phi_1019_ = false;
                                                    } else {
                                                        phi_1019_ = true;
                                                    }
                                                    let _e422 = phi_1019_;
                                                    phi_1020_ = _e422;
                                                }
                                                let _e424 = phi_1020_;
                                                if _e424 {
                                                    phi_1025_ = _e363;
                                                    phi_1026_ = (_e397 + 1u);
                                                } else {
                                                    phi_1025_ = _e397;
                                                    phi_1026_ = _e365;
                                                }
                                                let _e427 = phi_1025_;
                                                let _e429 = phi_1026_;
                                                phi_1027_ = _e427;
                                                phi_1028_ = _e429;
                                                phi_1029_ = true;
                                            }
                                            let _e431 = phi_1027_;
                                            let _e433 = phi_1028_;
                                            let _e435 = phi_1029_;
                                            phi_902_ = _e431;
                                            phi_904_ = _e433;
                                            phi_1030_ = _e435;
                                        } else {
                                            phi_902_ = u32();
                                            phi_904_ = u32();
                                            phi_1030_ = false;
                                        }
                                        let _e437 = phi_902_;
                                        let _e439 = phi_904_;
                                        let _e441 = phi_1030_;
                                        continue;
                                        continuing {
                                            phi_898_ = _e388;
                                            phi_901_ = _e437;
                                            phi_903_ = _e439;
                                            break if !(_e441);
                                        }
                                    }
                                    let _e444 = local_3;
                                    if (_e444 < _e345) {
                                        let _e447 = local_4;
                                        let _e449 = (_e349 + (3u * _e447));
                                        let _e451 = bodies.member[_e449];
                                        if (_e451 == _e73) {
                                            let _e455 = bodies.member[(_e449 + 1u)];
                                            if (_e455 == _e359) {
                                                let _e459 = bodies.member[(_e449 + 2u)];
                                                phi_1078_ = (_e459 == _e357);
                                                phi_1079_ = false;
                                            } else {
                                                phi_1078_ = bool();
                                                phi_1079_ = true;
                                            }
                                            let _e462 = phi_1078_;
                                            let _e464 = phi_1079_;
                                            phi_1080_ = _e462;
                                            phi_1081_ = _e464;
                                        } else {
                                            phi_1080_ = bool();
                                            phi_1081_ = true;
                                        }
                                        let _e466 = phi_1080_;
                                        let _e468 = phi_1081_;
                                        if _e468 {
                                            phi_1085_ = false;
                                        } else {
                                            phi_1085_ = _e466;
                                        }
                                        let _e470 = phi_1085_;
                                        phi_1086_ = _e470;
                                    } else {
                                        phi_1086_ = false;
                                    }
                                    let _e472 = phi_1086_;
                                    phi_1090_ = _e472;
                                } else {
                                    phi_1090_ = true;
                                }
                                let _e474 = phi_1090_;
                                if _e474 {
                                    phi_1094_ = false;
                                } else {
                                    phi_1094_ = true;
                                }
                                let _e476 = phi_1094_;
                                phi_1095_ = _e476;
                            } else {
                                phi_1095_ = true;
                            }
                            let _e478 = phi_1095_;
                            if _e478 {
                                phi_1099_ = false;
                            } else {
                                phi_1099_ = true;
                            }
                            let _e480 = phi_1099_;
                            phi_1100_ = _e480;
                        } else {
                            phi_1100_ = true;
                        }
                        let _e482 = phi_1100_;
                        if _e482 {
                            phi_1104_ = false;
                        } else {
                            phi_1104_ = true;
                        }
                        let _e484 = phi_1104_;
                        phi_1105_ = _e484;
                    } else {
                        phi_1105_ = true;
                    }
                    let _e486 = phi_1105_;
                    if _e486 {
                        let _e488 = params.member.member.member_1;
                        if ((_e488 & 32u) != 0u) {
                            let _e492 = params.member.member.member_6;
                            let _e533 = (((((_e216.member_1[0] - _e218.member[0]) > _e492) && ((_e218.member_1[0] - _e216.member[0]) > _e492)) && (((_e216.member_1[1] - _e218.member[1]) > _e492) && ((_e218.member_1[1] - _e216.member[1]) > _e492))) && (((_e216.member_1[2] - _e218.member[2]) > _e492) && ((_e218.member_1[2] - _e216.member[2]) > _e492)));
                            if _e533 {
                                phi_1719_ = bool();
                            } else {
                                let _e536 = keys.member[_e194[0]];
                                let _e540 = keys.member[_e194[1]];
                                let _e542 = function_(_e536[0], _e540[0]);
                                let _e545 = keys.member[_e194[2]];
                                let _e547 = function_(_e542, _e545[0]);
                                let _e550 = keys.member[_e192[0]];
                                let _e554 = keys.member[_e192[1]];
                                let _e556 = function_1(_e550[3], _e554[3]);
                                let _e559 = keys.member[_e192[2]];
                                let _e561 = function_1(_e556, _e559[3]);
                                if (_e547[1] > _e561[1]) {
                                    phi_1242_ = true;
                                } else {
                                    if (_e547[1] == _e561[1]) {
                                        phi_1241_ = (_e547[0] > _e561[0]);
                                    } else {
                                        phi_1241_ = false;
                                    }
                                    let _e572 = phi_1241_;
                                    phi_1242_ = _e572;
                                }
                                let _e574 = phi_1242_;
                                let _e578 = keys.member[_e192[0]];
                                let _e582 = keys.member[_e192[1]];
                                let _e584 = function_(_e578[0], _e582[0]);
                                let _e587 = keys.member[_e192[2]];
                                let _e589 = function_(_e584, _e587[0]);
                                let _e592 = keys.member[_e194[0]];
                                let _e596 = keys.member[_e194[1]];
                                let _e598 = function_1(_e592[3], _e596[3]);
                                let _e601 = keys.member[_e194[2]];
                                let _e603 = function_1(_e598, _e601[3]);
                                if (_e589[1] > _e603[1]) {
                                    phi_1336_ = true;
                                } else {
                                    if (_e589[1] == _e603[1]) {
                                        phi_1335_ = (_e589[0] > _e603[0]);
                                    } else {
                                        phi_1335_ = false;
                                    }
                                    let _e614 = phi_1335_;
                                    phi_1336_ = _e614;
                                }
                                let _e616 = phi_1336_;
                                let _e621 = keys.member[_e194[0]];
                                let _e625 = keys.member[_e194[1]];
                                let _e627 = function_2(_e621[1], _e625[1]);
                                let _e630 = keys.member[_e194[2]];
                                let _e632 = function_2(_e627, _e630[1]);
                                let _e635 = keys.member[_e192[0]];
                                let _e639 = keys.member[_e192[1]];
                                let _e641 = function_3(_e635[4], _e639[4]);
                                let _e644 = keys.member[_e192[2]];
                                let _e646 = function_3(_e641, _e644[4]);
                                if (_e632[1] > _e646[1]) {
                                    phi_1431_ = true;
                                } else {
                                    if (_e632[1] == _e646[1]) {
                                        phi_1430_ = (_e632[0] > _e646[0]);
                                    } else {
                                        phi_1430_ = false;
                                    }
                                    let _e657 = phi_1430_;
                                    phi_1431_ = _e657;
                                }
                                let _e659 = phi_1431_;
                                let _e663 = keys.member[_e192[0]];
                                let _e667 = keys.member[_e192[1]];
                                let _e669 = function_2(_e663[1], _e667[1]);
                                let _e672 = keys.member[_e192[2]];
                                let _e674 = function_2(_e669, _e672[1]);
                                let _e677 = keys.member[_e194[0]];
                                let _e681 = keys.member[_e194[1]];
                                let _e683 = function_3(_e677[4], _e681[4]);
                                let _e686 = keys.member[_e194[2]];
                                let _e688 = function_3(_e683, _e686[4]);
                                if (_e674[1] > _e688[1]) {
                                    phi_1525_ = true;
                                } else {
                                    if (_e674[1] == _e688[1]) {
                                        phi_1524_ = (_e674[0] > _e688[0]);
                                    } else {
                                        phi_1524_ = false;
                                    }
                                    let _e699 = phi_1524_;
                                    phi_1525_ = _e699;
                                }
                                let _e701 = phi_1525_;
                                let _e707 = keys.member[_e194[0]];
                                let _e711 = keys.member[_e194[1]];
                                let _e713 = function_4(_e707[2], _e711[2]);
                                let _e716 = keys.member[_e194[2]];
                                let _e718 = function_4(_e713, _e716[2]);
                                let _e721 = keys.member[_e192[0]];
                                let _e725 = keys.member[_e192[1]];
                                let _e727 = function_5(_e721[5], _e725[5]);
                                let _e730 = keys.member[_e192[2]];
                                let _e732 = function_5(_e727, _e730[5]);
                                if (_e718[1] > _e732[1]) {
                                    phi_1621_ = true;
                                } else {
                                    if (_e718[1] == _e732[1]) {
                                        phi_1620_ = (_e718[0] > _e732[0]);
                                    } else {
                                        phi_1620_ = false;
                                    }
                                    let _e743 = phi_1620_;
                                    phi_1621_ = _e743;
                                }
                                let _e745 = phi_1621_;
                                let _e749 = keys.member[_e192[0]];
                                let _e753 = keys.member[_e192[1]];
                                let _e755 = function_4(_e749[2], _e753[2]);
                                let _e758 = keys.member[_e192[2]];
                                let _e760 = function_4(_e755, _e758[2]);
                                let _e763 = keys.member[_e194[0]];
                                let _e767 = keys.member[_e194[1]];
                                let _e769 = function_5(_e763[5], _e767[5]);
                                let _e772 = keys.member[_e194[2]];
                                let _e774 = function_5(_e769, _e772[5]);
                                if (_e760[1] > _e774[1]) {
                                    phi_1715_ = true;
                                } else {
                                    if (_e760[1] == _e774[1]) {
                                        phi_1714_ = (_e760[0] > _e774[0]);
                                    } else {
                                        phi_1714_ = false;
                                    }
                                    let _e785 = phi_1714_;
                                    phi_1715_ = _e785;
                                }
                                let _e787 = phi_1715_;
                                phi_1719_ = (((!(_e574) && !(_e616)) && (!(_e659) && !(_e701))) && (!(_e745) && !(_e787)));
                            }
                            let _e792 = phi_1719_;
                            phi_1720_ = _e792;
                            phi_1721_ = _e533;
                        } else {
                            phi_1720_ = bool();
                            phi_1721_ = true;
                        }
                        let _e794 = phi_1720_;
                        let _e796 = phi_1721_;
                        if _e796 {
                            phi_1725_ = false;
                        } else {
                            phi_1725_ = true;
                        }
                        let _e798 = phi_1725_;
                        phi_1726_ = _e794;
                        phi_1727_ = _e798;
                    } else {
                        phi_1726_ = false;
                        phi_1727_ = true;
                    }
                    let _e800 = phi_1726_;
                    let _e802 = phi_1727_;
                    phi_1728_ = _e800;
                    phi_1729_ = _e802;
                } else {
                    phi_1728_ = false;
                    phi_1729_ = true;
                }
                let _e804 = phi_1728_;
                let _e806 = phi_1729_;
                if _e806 {
                    phi_1733_ = _e804;
                } else {
                    phi_1733_ = true;
                }
                let _e808 = phi_1733_;
                if _e808 {
                    let _e810 = atomicAdd((&counters[1u]), 1u);
                    let _e813 = params.member.member.member_4;
                    let _e815 = params.member.member.member_5;
                    let _e818 = paths.member[_e179.member_1[0]];
                    let _e833 = paths.member[_e179.member_1[1]];
                    let _e848 = paths.member[_e179.member_1[2]];
                    let _e863 = paths.member[_e179.member_1[3]];
                    let _e876 = array<f32, 3>(_e818.member.x, _e818.member.y, _e818.member.z);
                    let _e877 = array<f32, 3>(_e818.member_1.x, _e818.member_1.y, _e818.member_1.z);
                    let _e882 = (((_e815 + (2f * _e813)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                    if (_e179.member != 0u) {
                        let _e907 = function_6(_e818.member.x, _e833.member.x);
                        let _e908 = function_6(_e818.member.y, _e833.member.y);
                        let _e909 = function_6(_e818.member.z, _e833.member.z);
                        let _e911 = function_7(_e818.member.x, _e833.member.x);
                        let _e912 = function_7(_e818.member.y, _e833.member.y);
                        let _e913 = function_7(_e818.member.z, _e833.member.z);
                        let _e916 = function_6(_e848.member.x, _e863.member.x);
                        let _e917 = function_6(_e848.member.y, _e863.member.y);
                        let _e918 = function_6(_e848.member.z, _e863.member.z);
                        let _e920 = function_7(_e848.member.x, _e863.member.x);
                        let _e921 = function_7(_e848.member.y, _e863.member.y);
                        let _e922 = function_7(_e848.member.z, _e863.member.z);
                        phi_1865_ = type_32(array<array<f32, 3>, 2>(array<f32, 3>(_e907, _e908, _e909), array<f32, 3>(_e911, _e912, _e913)), array<array<f32, 3>, 2>(array<f32, 3>(_e916, _e917, _e918), array<f32, 3>(_e920, _e921, _e922)));
                    } else {
                        let _e884 = function_6(_e833.member.x, _e848.member.x);
                        let _e885 = function_6(_e833.member.y, _e848.member.y);
                        let _e886 = function_6(_e833.member.z, _e848.member.z);
                        let _e887 = function_7(_e833.member.x, _e848.member.x);
                        let _e888 = function_7(_e833.member.y, _e848.member.y);
                        let _e889 = function_7(_e833.member.z, _e848.member.z);
                        let _e891 = function_6(_e884, _e863.member.x);
                        let _e892 = function_6(_e885, _e863.member.y);
                        let _e893 = function_6(_e886, _e863.member.z);
                        let _e895 = function_7(_e884, _e863.member.x);
                        let _e896 = function_7(_e885, _e863.member.y);
                        let _e897 = function_7(_e886, _e863.member.z);
                        let _e898 = function_6(_e887, _e863.member.x);
                        let _e899 = function_6(_e888, _e863.member.y);
                        let _e900 = function_6(_e889, _e863.member.z);
                        let _e901 = function_7(_e887, _e863.member.x);
                        let _e902 = function_7(_e888, _e863.member.y);
                        let _e903 = function_7(_e889, _e863.member.z);
                        phi_1865_ = type_32(array<array<f32, 3>, 2>(_e876, _e876), array<array<f32, 3>, 2>(array<f32, 3>(_e891, _e892, _e893), array<f32, 3>(_e901, _e902, _e903)));
                    }
                    let _e927 = phi_1865_;
                    if (_e179.member != 0u) {
                        let _e952 = function_6(_e818.member_1.x, _e833.member_1.x);
                        let _e953 = function_6(_e818.member_1.y, _e833.member_1.y);
                        let _e954 = function_6(_e818.member_1.z, _e833.member_1.z);
                        let _e956 = function_7(_e818.member_1.x, _e833.member_1.x);
                        let _e957 = function_7(_e818.member_1.y, _e833.member_1.y);
                        let _e958 = function_7(_e818.member_1.z, _e833.member_1.z);
                        let _e961 = function_6(_e848.member_1.x, _e863.member_1.x);
                        let _e962 = function_6(_e848.member_1.y, _e863.member_1.y);
                        let _e963 = function_6(_e848.member_1.z, _e863.member_1.z);
                        let _e965 = function_7(_e848.member_1.x, _e863.member_1.x);
                        let _e966 = function_7(_e848.member_1.y, _e863.member_1.y);
                        let _e967 = function_7(_e848.member_1.z, _e863.member_1.z);
                        phi_1912_ = type_32(array<array<f32, 3>, 2>(array<f32, 3>(_e952, _e953, _e954), array<f32, 3>(_e956, _e957, _e958)), array<array<f32, 3>, 2>(array<f32, 3>(_e961, _e962, _e963), array<f32, 3>(_e965, _e966, _e967)));
                    } else {
                        let _e929 = function_6(_e833.member_1.x, _e848.member_1.x);
                        let _e930 = function_6(_e833.member_1.y, _e848.member_1.y);
                        let _e931 = function_6(_e833.member_1.z, _e848.member_1.z);
                        let _e932 = function_7(_e833.member_1.x, _e848.member_1.x);
                        let _e933 = function_7(_e833.member_1.y, _e848.member_1.y);
                        let _e934 = function_7(_e833.member_1.z, _e848.member_1.z);
                        let _e936 = function_6(_e929, _e863.member_1.x);
                        let _e937 = function_6(_e930, _e863.member_1.y);
                        let _e938 = function_6(_e931, _e863.member_1.z);
                        let _e940 = function_7(_e929, _e863.member_1.x);
                        let _e941 = function_7(_e930, _e863.member_1.y);
                        let _e942 = function_7(_e931, _e863.member_1.z);
                        let _e943 = function_6(_e932, _e863.member_1.x);
                        let _e944 = function_6(_e933, _e863.member_1.y);
                        let _e945 = function_6(_e934, _e863.member_1.z);
                        let _e946 = function_7(_e932, _e863.member_1.x);
                        let _e947 = function_7(_e933, _e863.member_1.y);
                        let _e948 = function_7(_e934, _e863.member_1.z);
                        phi_1912_ = type_32(array<array<f32, 3>, 2>(_e877, _e877), array<array<f32, 3>, 2>(array<f32, 3>(_e936, _e937, _e938), array<f32, 3>(_e946, _e947, _e948)));
                    }
                    let _e972 = phi_1912_;
                    if !(((((((_e927.member[0][0] - _e927.member_1[1][0]) > _e882) && ((_e972.member[0][0] - _e972.member_1[1][0]) > _e882)) || (((_e927.member_1[0][0] - _e927.member[1][0]) > _e882) && ((_e972.member_1[0][0] - _e972.member[1][0]) > _e882))) || ((((_e927.member[0][1] - _e927.member_1[1][1]) > _e882) && ((_e972.member[0][1] - _e972.member_1[1][1]) > _e882)) || (((_e927.member_1[0][1] - _e927.member[1][1]) > _e882) && ((_e972.member_1[0][1] - _e972.member[1][1]) > _e882)))) || ((((_e927.member[0][2] - _e927.member_1[1][2]) > _e882) && ((_e972.member[0][2] - _e972.member_1[1][2]) > _e882)) || (((_e927.member_1[0][2] - _e927.member[1][2]) > _e882) && ((_e972.member_1[0][2] - _e972.member[1][2]) > _e882))))) {
                        let _e1063 = paths.member[_e179.member_1[0]];
                        let _e1078 = paths.member[_e179.member_1[1]];
                        let _e1093 = paths.member[_e179.member_1[2]];
                        let _e1108 = paths.member[_e179.member_1[3]];
                        if (_e179.member != 0u) {
                            phi_2110_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e1093.member.x - _e1063.member.x), (_e1093.member.y - _e1063.member.y), (_e1093.member.z - _e1063.member.z)), array<f32, 3>((_e1093.member_1.x - _e1063.member_1.x), (_e1093.member_1.y - _e1063.member_1.y), (_e1093.member_1.z - _e1063.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1078.member.x - _e1063.member.x), (_e1078.member.y - _e1063.member.y), (_e1078.member.z - _e1063.member.z)), array<f32, 3>((_e1078.member_1.x - _e1063.member_1.x), (_e1078.member_1.y - _e1063.member_1.y), (_e1078.member_1.z - _e1063.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1093.member.x - _e1108.member.x), (_e1093.member.y - _e1108.member.y), (_e1093.member.z - _e1108.member.z)), array<f32, 3>((_e1093.member_1.x - _e1108.member_1.x), (_e1093.member_1.y - _e1108.member_1.y), (_e1093.member_1.z - _e1108.member_1.z))), (_e813 + _e813));
                        } else {
                            phi_2110_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e1063.member.x - _e1078.member.x), (_e1063.member.y - _e1078.member.y), (_e1063.member.z - _e1078.member.z)), array<f32, 3>((_e1063.member_1.x - _e1078.member_1.x), (_e1063.member_1.y - _e1078.member_1.y), (_e1063.member_1.z - _e1078.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1093.member.x - _e1078.member.x), (_e1093.member.y - _e1078.member.y), (_e1093.member.z - _e1078.member.z)), array<f32, 3>((_e1093.member_1.x - _e1078.member_1.x), (_e1093.member_1.y - _e1078.member_1.y), (_e1093.member_1.z - _e1078.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1108.member.x - _e1078.member.x), (_e1108.member.y - _e1078.member.y), (_e1108.member.z - _e1078.member.z)), array<f32, 3>((_e1108.member_1.x - _e1078.member_1.x), (_e1108.member_1.y - _e1078.member_1.y), (_e1108.member_1.z - _e1078.member_1.z))), (_e813 + _e813));
                        }
                        let _e1181 = phi_2110_;
                        local_2 = type_27(array<array<f32, 3>, 2>(array<f32, 3>(_e1181.member[0][0], _e1181.member[0][1], _e1181.member[0][2]), array<f32, 3>(_e1181.member[1][0], _e1181.member[1][1], _e1181.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1181.member_1[0][0], _e1181.member_1[0][1], _e1181.member_1[0][2]), array<f32, 3>(_e1181.member_1[1][0], _e1181.member_1[1][1], _e1181.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1181.member_2[0][0], _e1181.member_2[0][1], _e1181.member_2[0][2]), array<f32, 3>(_e1181.member_2[1][0], _e1181.member_2[1][1], _e1181.member_2[1][2])), _e1181.member_3);
                        let _e1222 = local_2.member_1[0u];
                        let _e1228 = local_2.member_2[0u];
                        let _e1234 = ((_e1222[1] * _e1228[2]) - (_e1222[2] * _e1228[1]));
                        let _e1237 = ((_e1222[2] * _e1228[0]) - (_e1222[0] * _e1228[2]));
                        let _e1240 = ((_e1222[0] * _e1228[1]) - (_e1222[1] * _e1228[0]));
                        let _e1243 = local_2.member_1[1u];
                        let _e1249 = local_2.member_2[1u];
                        let _e1255 = ((_e1243[1] * _e1249[2]) - (_e1243[2] * _e1249[1]));
                        let _e1258 = ((_e1243[2] * _e1249[0]) - (_e1243[0] * _e1249[2]));
                        let _e1261 = ((_e1243[0] * _e1249[1]) - (_e1243[1] * _e1249[0]));
                        let _e1264 = local_2.member_1[0u];
                        let _e1270 = local_2.member_2[1u];
                        let _e1285 = local_2.member_1[1u];
                        let _e1291 = local_2.member_2[0u];
                        let _e1304 = (((_e1264[1] * _e1270[2]) - (_e1264[2] * _e1270[1])) + ((_e1285[1] * _e1291[2]) - (_e1285[2] * _e1291[1])));
                        let _e1305 = (((_e1264[2] * _e1270[0]) - (_e1264[0] * _e1270[2])) + ((_e1285[2] * _e1291[0]) - (_e1285[0] * _e1291[2])));
                        let _e1306 = (((_e1264[0] * _e1270[1]) - (_e1264[1] * _e1270[0])) + ((_e1285[0] * _e1291[1]) - (_e1285[1] * _e1291[0])));
                        let _e1309 = local_2.member[0u];
                        let _e1320 = local_2.member[1u];
                        let _e1331 = local_2.member[0u];
                        let _e1340 = ((((_e1320[0] * _e1234) + (_e1320[1] * _e1237)) + (_e1320[2] * _e1240)) + (((_e1331[0] * _e1304) + (_e1331[1] * _e1305)) + (_e1331[2] * _e1306)));
                        let _e1343 = local_2.member[0u];
                        let _e1354 = local_2.member[1u];
                        let _e1363 = ((((_e1343[0] * _e1255) + (_e1343[1] * _e1258)) + (_e1343[2] * _e1261)) + (((_e1354[0] * _e1304) + (_e1354[1] * _e1305)) + (_e1354[2] * _e1306)));
                        let _e1366 = local_2.member[1u];
                        let _e1377 = local_2.member[0u];
                        if (_e1377[0] < 0f) {
                            phi_2390_ = -(_e1377[0]);
                        } else {
                            phi_2390_ = _e1377[0];
                        }
                        let _e1384 = phi_2390_;
                        if (_e1377[1] < 0f) {
                            phi_2397_ = -(_e1377[1]);
                        } else {
                            phi_2397_ = _e1377[1];
                        }
                        let _e1388 = phi_2397_;
                        if (_e1384 > _e1388) {
                            phi_2402_ = _e1384;
                        } else {
                            phi_2402_ = _e1388;
                        }
                        let _e1391 = phi_2402_;
                        if (_e1377[2] < 0f) {
                            phi_2409_ = -(_e1377[2]);
                        } else {
                            phi_2409_ = _e1377[2];
                        }
                        let _e1395 = phi_2409_;
                        if (_e1391 > _e1395) {
                            phi_2414_ = _e1391;
                        } else {
                            phi_2414_ = _e1395;
                        }
                        let _e1398 = phi_2414_;
                        let _e1401 = local_2.member[1u];
                        if (_e1401[0] < 0f) {
                            phi_2427_ = -(_e1401[0]);
                        } else {
                            phi_2427_ = _e1401[0];
                        }
                        let _e1408 = phi_2427_;
                        if (_e1401[1] < 0f) {
                            phi_2434_ = -(_e1401[1]);
                        } else {
                            phi_2434_ = _e1401[1];
                        }
                        let _e1412 = phi_2434_;
                        if (_e1408 > _e1412) {
                            phi_2439_ = _e1408;
                        } else {
                            phi_2439_ = _e1412;
                        }
                        let _e1415 = phi_2439_;
                        if (_e1401[2] < 0f) {
                            phi_2446_ = -(_e1401[2]);
                        } else {
                            phi_2446_ = _e1401[2];
                        }
                        let _e1419 = phi_2446_;
                        if (_e1415 > _e1419) {
                            phi_2451_ = _e1415;
                        } else {
                            phi_2451_ = _e1419;
                        }
                        let _e1422 = phi_2451_;
                        if (_e1398 > _e1422) {
                            phi_2456_ = _e1398;
                        } else {
                            phi_2456_ = _e1422;
                        }
                        let _e1425 = phi_2456_;
                        let _e1427 = local_2.member_3;
                        let _e1428 = (_e1425 + _e1427);
                        let _e1431 = local_2.member_1[0u];
                        if (_e1431[0] < 0f) {
                            phi_2473_ = -(_e1431[0]);
                        } else {
                            phi_2473_ = _e1431[0];
                        }
                        let _e1438 = phi_2473_;
                        if (_e1431[1] < 0f) {
                            phi_2480_ = -(_e1431[1]);
                        } else {
                            phi_2480_ = _e1431[1];
                        }
                        let _e1442 = phi_2480_;
                        if (_e1438 > _e1442) {
                            phi_2485_ = _e1438;
                        } else {
                            phi_2485_ = _e1442;
                        }
                        let _e1445 = phi_2485_;
                        if (_e1431[2] < 0f) {
                            phi_2492_ = -(_e1431[2]);
                        } else {
                            phi_2492_ = _e1431[2];
                        }
                        let _e1449 = phi_2492_;
                        if (_e1445 > _e1449) {
                            phi_2497_ = _e1445;
                        } else {
                            phi_2497_ = _e1449;
                        }
                        let _e1452 = phi_2497_;
                        let _e1455 = local_2.member_1[1u];
                        if (_e1455[0] < 0f) {
                            phi_2511_ = -(_e1455[0]);
                        } else {
                            phi_2511_ = _e1455[0];
                        }
                        let _e1462 = phi_2511_;
                        if (_e1455[1] < 0f) {
                            phi_2518_ = -(_e1455[1]);
                        } else {
                            phi_2518_ = _e1455[1];
                        }
                        let _e1466 = phi_2518_;
                        if (_e1462 > _e1466) {
                            phi_2523_ = _e1462;
                        } else {
                            phi_2523_ = _e1466;
                        }
                        let _e1469 = phi_2523_;
                        if (_e1455[2] < 0f) {
                            phi_2530_ = -(_e1455[2]);
                        } else {
                            phi_2530_ = _e1455[2];
                        }
                        let _e1473 = phi_2530_;
                        if (_e1469 > _e1473) {
                            phi_2535_ = _e1469;
                        } else {
                            phi_2535_ = _e1473;
                        }
                        let _e1476 = phi_2535_;
                        if (_e1452 > _e1476) {
                            phi_2540_ = _e1452;
                        } else {
                            phi_2540_ = _e1476;
                        }
                        let _e1479 = phi_2540_;
                        let _e1481 = local_2.member_3;
                        let _e1482 = (_e1479 + _e1481);
                        let _e1485 = local_2.member_2[0u];
                        if (_e1485[0] < 0f) {
                            phi_2557_ = -(_e1485[0]);
                        } else {
                            phi_2557_ = _e1485[0];
                        }
                        let _e1492 = phi_2557_;
                        if (_e1485[1] < 0f) {
                            phi_2564_ = -(_e1485[1]);
                        } else {
                            phi_2564_ = _e1485[1];
                        }
                        let _e1496 = phi_2564_;
                        if (_e1492 > _e1496) {
                            phi_2569_ = _e1492;
                        } else {
                            phi_2569_ = _e1496;
                        }
                        let _e1499 = phi_2569_;
                        if (_e1485[2] < 0f) {
                            phi_2576_ = -(_e1485[2]);
                        } else {
                            phi_2576_ = _e1485[2];
                        }
                        let _e1503 = phi_2576_;
                        if (_e1499 > _e1503) {
                            phi_2581_ = _e1499;
                        } else {
                            phi_2581_ = _e1503;
                        }
                        let _e1506 = phi_2581_;
                        let _e1509 = local_2.member_2[1u];
                        if (_e1509[0] < 0f) {
                            phi_2595_ = -(_e1509[0]);
                        } else {
                            phi_2595_ = _e1509[0];
                        }
                        let _e1516 = phi_2595_;
                        if (_e1509[1] < 0f) {
                            phi_2602_ = -(_e1509[1]);
                        } else {
                            phi_2602_ = _e1509[1];
                        }
                        let _e1520 = phi_2602_;
                        if (_e1516 > _e1520) {
                            phi_2607_ = _e1516;
                        } else {
                            phi_2607_ = _e1520;
                        }
                        let _e1523 = phi_2607_;
                        if (_e1509[2] < 0f) {
                            phi_2614_ = -(_e1509[2]);
                        } else {
                            phi_2614_ = _e1509[2];
                        }
                        let _e1527 = phi_2614_;
                        if (_e1523 > _e1527) {
                            phi_2619_ = _e1523;
                        } else {
                            phi_2619_ = _e1527;
                        }
                        let _e1530 = phi_2619_;
                        if (_e1506 > _e1530) {
                            phi_2624_ = _e1506;
                        } else {
                            phi_2624_ = _e1530;
                        }
                        let _e1533 = phi_2624_;
                        let _e1535 = local_2.member_3;
                        let _e1536 = (_e1533 + _e1535);
                        let _e1538 = ((_e1482 * 8f) * _e1536);
                        let _e1545 = local_2.member_3;
                        if (_e1234 < 0f) {
                            phi_2655_ = -(_e1234);
                        } else {
                            phi_2655_ = _e1234;
                        }
                        let _e1562 = phi_2655_;
                        if (_e1237 < 0f) {
                            phi_2661_ = -(_e1237);
                        } else {
                            phi_2661_ = _e1237;
                        }
                        let _e1566 = phi_2661_;
                        if (_e1240 < 0f) {
                            phi_2668_ = -(_e1240);
                        } else {
                            phi_2668_ = _e1240;
                        }
                        let _e1571 = phi_2668_;
                        let _e1572 = ((_e1562 + _e1566) + _e1571);
                        if (_e1255 < 0f) {
                            phi_2675_ = -(_e1255);
                        } else {
                            phi_2675_ = _e1255;
                        }
                        let _e1576 = phi_2675_;
                        if (_e1258 < 0f) {
                            phi_2681_ = -(_e1258);
                        } else {
                            phi_2681_ = _e1258;
                        }
                        let _e1580 = phi_2681_;
                        if (_e1261 < 0f) {
                            phi_2688_ = -(_e1261);
                        } else {
                            phi_2688_ = _e1261;
                        }
                        let _e1585 = phi_2688_;
                        let _e1586 = ((_e1576 + _e1580) + _e1585);
                        if (_e1572 > _e1586) {
                            phi_2694_ = _e1572;
                        } else {
                            phi_2694_ = _e1586;
                        }
                        let _e1589 = phi_2694_;
                        if (_e1304 < 0f) {
                            phi_2700_ = -(_e1304);
                        } else {
                            phi_2700_ = _e1304;
                        }
                        let _e1593 = phi_2700_;
                        if (_e1305 < 0f) {
                            phi_2706_ = -(_e1305);
                        } else {
                            phi_2706_ = _e1305;
                        }
                        let _e1597 = phi_2706_;
                        if (_e1306 < 0f) {
                            phi_2713_ = -(_e1306);
                        } else {
                            phi_2713_ = _e1306;
                        }
                        let _e1602 = phi_2713_;
                        let _e1604 = (((_e1593 + _e1597) + _e1602) * 0.5f);
                        if (_e1589 > _e1604) {
                            phi_2720_ = _e1589;
                        } else {
                            phi_2720_ = _e1604;
                        }
                        let _e1607 = phi_2720_;
                        let _e1612 = local_2.member_3;
                        let _e1625 = ((((_e1309[0] * _e1234) + (_e1309[1] * _e1237)) + (_e1309[2] * _e1240)) * 3f);
                        let _e1626 = ((((_e1366[0] * _e1255) + (_e1366[1] * _e1258)) + (_e1366[2] * _e1261)) * 3f);
                        if (_e1625 < _e1626) {
                            phi_2744_ = _e1625;
                        } else {
                            phi_2744_ = _e1626;
                        }
                        let _e1629 = phi_2744_;
                        if (_e1340 < _e1363) {
                            phi_2749_ = _e1340;
                        } else {
                            phi_2749_ = _e1363;
                        }
                        let _e1632 = phi_2749_;
                        if (_e1629 < _e1632) {
                            phi_2754_ = _e1629;
                        } else {
                            phi_2754_ = _e1632;
                        }
                        let _e1635 = phi_2754_;
                        if (_e1625 > _e1626) {
                            phi_2759_ = _e1625;
                        } else {
                            phi_2759_ = _e1626;
                        }
                        let _e1638 = phi_2759_;
                        if (_e1340 > _e1363) {
                            phi_2764_ = _e1340;
                        } else {
                            phi_2764_ = _e1363;
                        }
                        let _e1641 = phi_2764_;
                        if (_e1638 > _e1641) {
                            phi_2769_ = _e1638;
                        } else {
                            phi_2769_ = _e1641;
                        }
                        let _e1644 = phi_2769_;
                        let _e1649 = -(_e1644);
                        if (_e1635 > _e1649) {
                            phi_2779_ = _e1635;
                        } else {
                            phi_2779_ = _e1649;
                        }
                        let _e1652 = phi_2779_;
                        let _e1654 = ((_e1652 - ((((((_e1428 * 8f) * _e1538) * (0.000000059604645f * (524f / 64f))) + ((_e1545 * 19f) * ((_e1428 * (_e1482 + _e1536)) + (_e1482 * _e1536)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1428) * ((1f + _e1482) * (1f + _e1536))))) + ((_e815 * (((_e1607 + (_e1538 * (0.000000059604645f * 8f))) + ((_e1612 * 6f) * (_e1482 + _e1536))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1482) * (1f + _e1536))))) * (3f * 1.0001f)))) > 0f);
                        if _e1654 {
                            phi_3748_ = _e1654;
                        } else {
                            let _e1657 = local_2.member_1[0u];
                            let _e1663 = local_2.member_1[1u];
                            let _e1667 = (_e1657[0] + _e1663[0]);
                            let _e1668 = (_e1657[1] + _e1663[1]);
                            let _e1669 = (_e1657[2] + _e1663[2]);
                            let _e1672 = local_2.member_2[0u];
                            let _e1678 = local_2.member_2[1u];
                            let _e1682 = (_e1672[0] + _e1678[0]);
                            let _e1683 = (_e1672[1] + _e1678[1]);
                            let _e1684 = (_e1672[2] + _e1678[2]);
                            let _e1687 = ((_e1668 * _e1684) - (_e1669 * _e1683));
                            let _e1690 = ((_e1669 * _e1682) - (_e1667 * _e1684));
                            let _e1693 = ((_e1667 * _e1683) - (_e1668 * _e1682));
                            let _e1696 = local_2.member[0u];
                            let _e1703 = local_2.member_1[0u];
                            let _e1709 = local_2.member_2[0u];
                            let _e1713 = (_e1696[0] - _e1703[0]);
                            let _e1714 = (_e1696[1] - _e1703[1]);
                            let _e1715 = (_e1696[2] - _e1703[2]);
                            if (_e179.member == 0u) {
                                phi_2895_ = array<f32, 3>(_e1696[0], _e1696[1], _e1696[2]);
                            } else {
                                phi_2895_ = array<f32, 3>((_e1713 - _e1709[0]), (_e1714 - _e1709[1]), (_e1715 - _e1709[2]));
                            }
                            let _e1722 = phi_2895_;
                            let _e1723 = (_e1696[0] - _e1709[0]);
                            let _e1724 = (_e1696[1] - _e1709[1]);
                            let _e1725 = (_e1696[2] - _e1709[2]);
                            let _e1728 = local_2.member[1u];
                            let _e1735 = local_2.member_1[1u];
                            let _e1741 = local_2.member_2[1u];
                            let _e1745 = (_e1728[0] - _e1735[0]);
                            let _e1746 = (_e1728[1] - _e1735[1]);
                            let _e1747 = (_e1728[2] - _e1735[2]);
                            if (_e179.member == 0u) {
                                phi_2960_ = array<f32, 3>(_e1728[0], _e1728[1], _e1728[2]);
                            } else {
                                phi_2960_ = array<f32, 3>((_e1745 - _e1741[0]), (_e1746 - _e1741[1]), (_e1747 - _e1741[2]));
                            }
                            let _e1754 = phi_2960_;
                            let _e1755 = (_e1728[0] - _e1741[0]);
                            let _e1756 = (_e1728[1] - _e1741[1]);
                            let _e1757 = (_e1728[2] - _e1741[2]);
                            let _e1760 = local_2.member[0u];
                            if (_e1760[0] < 0f) {
                                phi_2982_ = -(_e1760[0]);
                            } else {
                                phi_2982_ = _e1760[0];
                            }
                            let _e1767 = phi_2982_;
                            if (_e1760[1] < 0f) {
                                phi_2989_ = -(_e1760[1]);
                            } else {
                                phi_2989_ = _e1760[1];
                            }
                            let _e1771 = phi_2989_;
                            if (_e1767 > _e1771) {
                                phi_2994_ = _e1767;
                            } else {
                                phi_2994_ = _e1771;
                            }
                            let _e1774 = phi_2994_;
                            if (_e1760[2] < 0f) {
                                phi_3001_ = -(_e1760[2]);
                            } else {
                                phi_3001_ = _e1760[2];
                            }
                            let _e1778 = phi_3001_;
                            if (_e1774 > _e1778) {
                                phi_3006_ = _e1774;
                            } else {
                                phi_3006_ = _e1778;
                            }
                            let _e1781 = phi_3006_;
                            let _e1784 = local_2.member[1u];
                            if (_e1784[0] < 0f) {
                                phi_3019_ = -(_e1784[0]);
                            } else {
                                phi_3019_ = _e1784[0];
                            }
                            let _e1791 = phi_3019_;
                            if (_e1784[1] < 0f) {
                                phi_3026_ = -(_e1784[1]);
                            } else {
                                phi_3026_ = _e1784[1];
                            }
                            let _e1795 = phi_3026_;
                            if (_e1791 > _e1795) {
                                phi_3031_ = _e1791;
                            } else {
                                phi_3031_ = _e1795;
                            }
                            let _e1798 = phi_3031_;
                            if (_e1784[2] < 0f) {
                                phi_3038_ = -(_e1784[2]);
                            } else {
                                phi_3038_ = _e1784[2];
                            }
                            let _e1802 = phi_3038_;
                            if (_e1798 > _e1802) {
                                phi_3043_ = _e1798;
                            } else {
                                phi_3043_ = _e1802;
                            }
                            let _e1805 = phi_3043_;
                            if (_e1781 > _e1805) {
                                phi_3048_ = _e1781;
                            } else {
                                phi_3048_ = _e1805;
                            }
                            let _e1808 = phi_3048_;
                            let _e1810 = local_2.member_3;
                            let _e1814 = local_2.member_1[0u];
                            if (_e1814[0] < 0f) {
                                phi_3065_ = -(_e1814[0]);
                            } else {
                                phi_3065_ = _e1814[0];
                            }
                            let _e1821 = phi_3065_;
                            if (_e1814[1] < 0f) {
                                phi_3072_ = -(_e1814[1]);
                            } else {
                                phi_3072_ = _e1814[1];
                            }
                            let _e1825 = phi_3072_;
                            if (_e1821 > _e1825) {
                                phi_3077_ = _e1821;
                            } else {
                                phi_3077_ = _e1825;
                            }
                            let _e1828 = phi_3077_;
                            if (_e1814[2] < 0f) {
                                phi_3084_ = -(_e1814[2]);
                            } else {
                                phi_3084_ = _e1814[2];
                            }
                            let _e1832 = phi_3084_;
                            if (_e1828 > _e1832) {
                                phi_3089_ = _e1828;
                            } else {
                                phi_3089_ = _e1832;
                            }
                            let _e1835 = phi_3089_;
                            let _e1838 = local_2.member_1[1u];
                            if (_e1838[0] < 0f) {
                                phi_3103_ = -(_e1838[0]);
                            } else {
                                phi_3103_ = _e1838[0];
                            }
                            let _e1845 = phi_3103_;
                            if (_e1838[1] < 0f) {
                                phi_3110_ = -(_e1838[1]);
                            } else {
                                phi_3110_ = _e1838[1];
                            }
                            let _e1849 = phi_3110_;
                            if (_e1845 > _e1849) {
                                phi_3115_ = _e1845;
                            } else {
                                phi_3115_ = _e1849;
                            }
                            let _e1852 = phi_3115_;
                            if (_e1838[2] < 0f) {
                                phi_3122_ = -(_e1838[2]);
                            } else {
                                phi_3122_ = _e1838[2];
                            }
                            let _e1856 = phi_3122_;
                            if (_e1852 > _e1856) {
                                phi_3127_ = _e1852;
                            } else {
                                phi_3127_ = _e1856;
                            }
                            let _e1859 = phi_3127_;
                            if (_e1835 > _e1859) {
                                phi_3132_ = _e1835;
                            } else {
                                phi_3132_ = _e1859;
                            }
                            let _e1862 = phi_3132_;
                            let _e1864 = local_2.member_3;
                            let _e1868 = local_2.member_2[0u];
                            if (_e1868[0] < 0f) {
                                phi_3149_ = -(_e1868[0]);
                            } else {
                                phi_3149_ = _e1868[0];
                            }
                            let _e1875 = phi_3149_;
                            if (_e1868[1] < 0f) {
                                phi_3156_ = -(_e1868[1]);
                            } else {
                                phi_3156_ = _e1868[1];
                            }
                            let _e1879 = phi_3156_;
                            if (_e1875 > _e1879) {
                                phi_3161_ = _e1875;
                            } else {
                                phi_3161_ = _e1879;
                            }
                            let _e1882 = phi_3161_;
                            if (_e1868[2] < 0f) {
                                phi_3168_ = -(_e1868[2]);
                            } else {
                                phi_3168_ = _e1868[2];
                            }
                            let _e1886 = phi_3168_;
                            if (_e1882 > _e1886) {
                                phi_3173_ = _e1882;
                            } else {
                                phi_3173_ = _e1886;
                            }
                            let _e1889 = phi_3173_;
                            let _e1892 = local_2.member_2[1u];
                            if (_e1892[0] < 0f) {
                                phi_3187_ = -(_e1892[0]);
                            } else {
                                phi_3187_ = _e1892[0];
                            }
                            let _e1899 = phi_3187_;
                            if (_e1892[1] < 0f) {
                                phi_3194_ = -(_e1892[1]);
                            } else {
                                phi_3194_ = _e1892[1];
                            }
                            let _e1903 = phi_3194_;
                            if (_e1899 > _e1903) {
                                phi_3199_ = _e1899;
                            } else {
                                phi_3199_ = _e1903;
                            }
                            let _e1906 = phi_3199_;
                            if (_e1892[2] < 0f) {
                                phi_3206_ = -(_e1892[2]);
                            } else {
                                phi_3206_ = _e1892[2];
                            }
                            let _e1910 = phi_3206_;
                            if (_e1906 > _e1910) {
                                phi_3211_ = _e1906;
                            } else {
                                phi_3211_ = _e1910;
                            }
                            let _e1913 = phi_3211_;
                            if (_e1889 > _e1913) {
                                phi_3216_ = _e1889;
                            } else {
                                phi_3216_ = _e1913;
                            }
                            let _e1916 = phi_3216_;
                            let _e1918 = local_2.member_3;
                            let _e1922 = ((((_e1808 + _e1810) + (_e1862 + _e1864)) + (_e1916 + _e1918)) * 2f);
                            let _e1925 = local_2.member_3;
                            let _e1929 = (((_e815 * 1.0001f) + (_e1925 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e1932 = ((_e1690 * _e1669) - (_e1693 * _e1668));
                            let _e1935 = ((_e1693 * _e1667) - (_e1687 * _e1669));
                            let _e1938 = ((_e1687 * _e1668) - (_e1690 * _e1667));
                            let _e1943 = (((_e1932 * _e1696[0]) + (_e1935 * _e1696[1])) + (_e1938 * _e1696[2]));
                            let _e1948 = (((_e1932 * _e1713) + (_e1935 * _e1714)) + (_e1938 * _e1715));
                            let _e1953 = (((_e1932 * _e1723) + (_e1935 * _e1724)) + (_e1938 * _e1725));
                            let _e1961 = (((_e1932 * _e1722[0]) + (_e1935 * _e1722[1])) + (_e1938 * _e1722[2]));
                            let _e1966 = (((_e1932 * _e1728[0]) + (_e1935 * _e1728[1])) + (_e1938 * _e1728[2]));
                            let _e1971 = (((_e1932 * _e1745) + (_e1935 * _e1746)) + (_e1938 * _e1747));
                            let _e1976 = (((_e1932 * _e1755) + (_e1935 * _e1756)) + (_e1938 * _e1757));
                            let _e1984 = (((_e1932 * _e1754[0]) + (_e1935 * _e1754[1])) + (_e1938 * _e1754[2]));
                            if (_e1943 < _e1948) {
                                phi_3295_ = _e1943;
                            } else {
                                phi_3295_ = _e1948;
                            }
                            let _e1987 = phi_3295_;
                            if (_e1953 < _e1961) {
                                phi_3300_ = _e1953;
                            } else {
                                phi_3300_ = _e1961;
                            }
                            let _e1990 = phi_3300_;
                            if (_e1987 < _e1990) {
                                phi_3305_ = _e1987;
                            } else {
                                phi_3305_ = _e1990;
                            }
                            let _e1993 = phi_3305_;
                            if (_e1966 < _e1971) {
                                phi_3310_ = _e1966;
                            } else {
                                phi_3310_ = _e1971;
                            }
                            let _e1996 = phi_3310_;
                            if (_e1976 < _e1984) {
                                phi_3315_ = _e1976;
                            } else {
                                phi_3315_ = _e1984;
                            }
                            let _e1999 = phi_3315_;
                            if (_e1996 < _e1999) {
                                phi_3320_ = _e1996;
                            } else {
                                phi_3320_ = _e1999;
                            }
                            let _e2002 = phi_3320_;
                            if (_e1993 < _e2002) {
                                phi_3325_ = _e1993;
                            } else {
                                phi_3325_ = _e2002;
                            }
                            let _e2005 = phi_3325_;
                            if (_e1943 > _e1948) {
                                phi_3330_ = _e1943;
                            } else {
                                phi_3330_ = _e1948;
                            }
                            let _e2008 = phi_3330_;
                            if (_e1953 > _e1961) {
                                phi_3335_ = _e1953;
                            } else {
                                phi_3335_ = _e1961;
                            }
                            let _e2011 = phi_3335_;
                            if (_e2008 > _e2011) {
                                phi_3340_ = _e2008;
                            } else {
                                phi_3340_ = _e2011;
                            }
                            let _e2014 = phi_3340_;
                            if (_e1966 > _e1971) {
                                phi_3345_ = _e1966;
                            } else {
                                phi_3345_ = _e1971;
                            }
                            let _e2017 = phi_3345_;
                            if (_e1976 > _e1984) {
                                phi_3350_ = _e1976;
                            } else {
                                phi_3350_ = _e1984;
                            }
                            let _e2020 = phi_3350_;
                            if (_e2017 > _e2020) {
                                phi_3355_ = _e2017;
                            } else {
                                phi_3355_ = _e2020;
                            }
                            let _e2023 = phi_3355_;
                            if (_e2014 > _e2023) {
                                phi_3360_ = _e2014;
                            } else {
                                phi_3360_ = _e2023;
                            }
                            let _e2026 = phi_3360_;
                            if (_e1932 < 0f) {
                                phi_3366_ = -(_e1932);
                            } else {
                                phi_3366_ = _e1932;
                            }
                            let _e2030 = phi_3366_;
                            if (_e1935 < 0f) {
                                phi_3372_ = -(_e1935);
                            } else {
                                phi_3372_ = _e1935;
                            }
                            let _e2034 = phi_3372_;
                            if (_e1938 < 0f) {
                                phi_3379_ = -(_e1938);
                            } else {
                                phi_3379_ = _e1938;
                            }
                            let _e2039 = phi_3379_;
                            let _e2040 = ((_e2030 + _e2034) + _e2039);
                            let _e2045 = -(_e2026);
                            if (_e2005 > _e2045) {
                                phi_3390_ = _e2005;
                            } else {
                                phi_3390_ = _e2045;
                            }
                            let _e2048 = phi_3390_;
                            let _e2053 = (((_e2048 - ((_e2040 * _e1922) * (0.000000059604645f * (17f / 2f)))) - (_e2040 * _e1929)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2056 = ((_e1690 * _e1684) - (_e1693 * _e1683));
                            let _e2059 = ((_e1693 * _e1682) - (_e1687 * _e1684));
                            let _e2062 = ((_e1687 * _e1683) - (_e1690 * _e1682));
                            let _e2067 = (((_e2056 * _e1696[0]) + (_e2059 * _e1696[1])) + (_e2062 * _e1696[2]));
                            let _e2072 = (((_e2056 * _e1713) + (_e2059 * _e1714)) + (_e2062 * _e1715));
                            let _e2077 = (((_e2056 * _e1723) + (_e2059 * _e1724)) + (_e2062 * _e1725));
                            let _e2085 = (((_e2056 * _e1722[0]) + (_e2059 * _e1722[1])) + (_e2062 * _e1722[2]));
                            let _e2090 = (((_e2056 * _e1728[0]) + (_e2059 * _e1728[1])) + (_e2062 * _e1728[2]));
                            let _e2095 = (((_e2056 * _e1745) + (_e2059 * _e1746)) + (_e2062 * _e1747));
                            let _e2100 = (((_e2056 * _e1755) + (_e2059 * _e1756)) + (_e2062 * _e1757));
                            let _e2108 = (((_e2056 * _e1754[0]) + (_e2059 * _e1754[1])) + (_e2062 * _e1754[2]));
                            if (_e2067 < _e2072) {
                                phi_3461_ = _e2067;
                            } else {
                                phi_3461_ = _e2072;
                            }
                            let _e2111 = phi_3461_;
                            if (_e2077 < _e2085) {
                                phi_3466_ = _e2077;
                            } else {
                                phi_3466_ = _e2085;
                            }
                            let _e2114 = phi_3466_;
                            if (_e2111 < _e2114) {
                                phi_3471_ = _e2111;
                            } else {
                                phi_3471_ = _e2114;
                            }
                            let _e2117 = phi_3471_;
                            if (_e2090 < _e2095) {
                                phi_3476_ = _e2090;
                            } else {
                                phi_3476_ = _e2095;
                            }
                            let _e2120 = phi_3476_;
                            if (_e2100 < _e2108) {
                                phi_3481_ = _e2100;
                            } else {
                                phi_3481_ = _e2108;
                            }
                            let _e2123 = phi_3481_;
                            if (_e2120 < _e2123) {
                                phi_3486_ = _e2120;
                            } else {
                                phi_3486_ = _e2123;
                            }
                            let _e2126 = phi_3486_;
                            if (_e2117 < _e2126) {
                                phi_3491_ = _e2117;
                            } else {
                                phi_3491_ = _e2126;
                            }
                            let _e2129 = phi_3491_;
                            if (_e2067 > _e2072) {
                                phi_3496_ = _e2067;
                            } else {
                                phi_3496_ = _e2072;
                            }
                            let _e2132 = phi_3496_;
                            if (_e2077 > _e2085) {
                                phi_3501_ = _e2077;
                            } else {
                                phi_3501_ = _e2085;
                            }
                            let _e2135 = phi_3501_;
                            if (_e2132 > _e2135) {
                                phi_3506_ = _e2132;
                            } else {
                                phi_3506_ = _e2135;
                            }
                            let _e2138 = phi_3506_;
                            if (_e2090 > _e2095) {
                                phi_3511_ = _e2090;
                            } else {
                                phi_3511_ = _e2095;
                            }
                            let _e2141 = phi_3511_;
                            if (_e2100 > _e2108) {
                                phi_3516_ = _e2100;
                            } else {
                                phi_3516_ = _e2108;
                            }
                            let _e2144 = phi_3516_;
                            if (_e2141 > _e2144) {
                                phi_3521_ = _e2141;
                            } else {
                                phi_3521_ = _e2144;
                            }
                            let _e2147 = phi_3521_;
                            if (_e2138 > _e2147) {
                                phi_3526_ = _e2138;
                            } else {
                                phi_3526_ = _e2147;
                            }
                            let _e2150 = phi_3526_;
                            if (_e2056 < 0f) {
                                phi_3532_ = -(_e2056);
                            } else {
                                phi_3532_ = _e2056;
                            }
                            let _e2154 = phi_3532_;
                            if (_e2059 < 0f) {
                                phi_3538_ = -(_e2059);
                            } else {
                                phi_3538_ = _e2059;
                            }
                            let _e2158 = phi_3538_;
                            if (_e2062 < 0f) {
                                phi_3545_ = -(_e2062);
                            } else {
                                phi_3545_ = _e2062;
                            }
                            let _e2163 = phi_3545_;
                            let _e2164 = ((_e2154 + _e2158) + _e2163);
                            let _e2169 = -(_e2150);
                            if (_e2129 > _e2169) {
                                phi_3556_ = _e2129;
                            } else {
                                phi_3556_ = _e2169;
                            }
                            let _e2172 = phi_3556_;
                            let _e2177 = (((_e2172 - ((_e2164 * _e1922) * (0.000000059604645f * (17f / 2f)))) - (_e2164 * _e1929)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e2053 > _e2177) {
                                phi_3566_ = _e2053;
                            } else {
                                phi_3566_ = _e2177;
                            }
                            let _e2180 = phi_3566_;
                            if (_e179.member == 0u) {
                                let _e2182 = (_e1682 - _e1667);
                                let _e2183 = (_e1683 - _e1668);
                                let _e2184 = (_e1684 - _e1669);
                                let _e2187 = ((_e1690 * _e2184) - (_e1693 * _e2183));
                                let _e2190 = ((_e1693 * _e2182) - (_e1687 * _e2184));
                                let _e2193 = ((_e1687 * _e2183) - (_e1690 * _e2182));
                                let _e2198 = (((_e2187 * _e1696[0]) + (_e2190 * _e1696[1])) + (_e2193 * _e1696[2]));
                                let _e2203 = (((_e2187 * _e1713) + (_e2190 * _e1714)) + (_e2193 * _e1715));
                                let _e2208 = (((_e2187 * _e1723) + (_e2190 * _e1724)) + (_e2193 * _e1725));
                                let _e2216 = (((_e2187 * _e1722[0]) + (_e2190 * _e1722[1])) + (_e2193 * _e1722[2]));
                                let _e2221 = (((_e2187 * _e1728[0]) + (_e2190 * _e1728[1])) + (_e2193 * _e1728[2]));
                                let _e2226 = (((_e2187 * _e1745) + (_e2190 * _e1746)) + (_e2193 * _e1747));
                                let _e2231 = (((_e2187 * _e1755) + (_e2190 * _e1756)) + (_e2193 * _e1757));
                                let _e2239 = (((_e2187 * _e1754[0]) + (_e2190 * _e1754[1])) + (_e2193 * _e1754[2]));
                                if (_e2198 < _e2203) {
                                    phi_3639_ = _e2198;
                                } else {
                                    phi_3639_ = _e2203;
                                }
                                let _e2242 = phi_3639_;
                                if (_e2208 < _e2216) {
                                    phi_3644_ = _e2208;
                                } else {
                                    phi_3644_ = _e2216;
                                }
                                let _e2245 = phi_3644_;
                                if (_e2242 < _e2245) {
                                    phi_3649_ = _e2242;
                                } else {
                                    phi_3649_ = _e2245;
                                }
                                let _e2248 = phi_3649_;
                                if (_e2221 < _e2226) {
                                    phi_3654_ = _e2221;
                                } else {
                                    phi_3654_ = _e2226;
                                }
                                let _e2251 = phi_3654_;
                                if (_e2231 < _e2239) {
                                    phi_3659_ = _e2231;
                                } else {
                                    phi_3659_ = _e2239;
                                }
                                let _e2254 = phi_3659_;
                                if (_e2251 < _e2254) {
                                    phi_3664_ = _e2251;
                                } else {
                                    phi_3664_ = _e2254;
                                }
                                let _e2257 = phi_3664_;
                                if (_e2248 < _e2257) {
                                    phi_3669_ = _e2248;
                                } else {
                                    phi_3669_ = _e2257;
                                }
                                let _e2260 = phi_3669_;
                                if (_e2198 > _e2203) {
                                    phi_3674_ = _e2198;
                                } else {
                                    phi_3674_ = _e2203;
                                }
                                let _e2263 = phi_3674_;
                                if (_e2208 > _e2216) {
                                    phi_3679_ = _e2208;
                                } else {
                                    phi_3679_ = _e2216;
                                }
                                let _e2266 = phi_3679_;
                                if (_e2263 > _e2266) {
                                    phi_3684_ = _e2263;
                                } else {
                                    phi_3684_ = _e2266;
                                }
                                let _e2269 = phi_3684_;
                                if (_e2221 > _e2226) {
                                    phi_3689_ = _e2221;
                                } else {
                                    phi_3689_ = _e2226;
                                }
                                let _e2272 = phi_3689_;
                                if (_e2231 > _e2239) {
                                    phi_3694_ = _e2231;
                                } else {
                                    phi_3694_ = _e2239;
                                }
                                let _e2275 = phi_3694_;
                                if (_e2272 > _e2275) {
                                    phi_3699_ = _e2272;
                                } else {
                                    phi_3699_ = _e2275;
                                }
                                let _e2278 = phi_3699_;
                                if (_e2269 > _e2278) {
                                    phi_3704_ = _e2269;
                                } else {
                                    phi_3704_ = _e2278;
                                }
                                let _e2281 = phi_3704_;
                                if (_e2187 < 0f) {
                                    phi_3710_ = -(_e2187);
                                } else {
                                    phi_3710_ = _e2187;
                                }
                                let _e2285 = phi_3710_;
                                if (_e2190 < 0f) {
                                    phi_3716_ = -(_e2190);
                                } else {
                                    phi_3716_ = _e2190;
                                }
                                let _e2289 = phi_3716_;
                                if (_e2193 < 0f) {
                                    phi_3723_ = -(_e2193);
                                } else {
                                    phi_3723_ = _e2193;
                                }
                                let _e2294 = phi_3723_;
                                let _e2295 = ((_e2285 + _e2289) + _e2294);
                                let _e2300 = -(_e2281);
                                if (_e2260 > _e2300) {
                                    phi_3734_ = _e2260;
                                } else {
                                    phi_3734_ = _e2300;
                                }
                                let _e2303 = phi_3734_;
                                let _e2308 = (((_e2303 - ((_e2295 * _e1922) * (0.000000059604645f * (17f / 2f)))) - (_e2295 * _e1929)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2180 > _e2308) {
                                    phi_3744_ = _e2180;
                                } else {
                                    phi_3744_ = _e2308;
                                }
                                let _e2311 = phi_3744_;
                                phi_3745_ = _e2311;
                            } else {
                                phi_3745_ = _e2180;
                            }
                            let _e2313 = phi_3745_;
                            phi_3748_ = (_e1654 || (_e2313 > 0f));
                        }
                        let _e2317 = phi_3748_;
                        if _e2317 {
                            phi_7165_ = _e2317;
                        } else {
                            let _e2320 = local_2.member[0u];
                            let _e2326 = local_2.member[1u];
                            let _e2333 = ((_e2320[0] + _e2326[0]) * 0.5f);
                            let _e2334 = ((_e2320[1] + _e2326[1]) * 0.5f);
                            let _e2335 = ((_e2320[2] + _e2326[2]) * 0.5f);
                            let _e2338 = local_2.member_1[0u];
                            let _e2344 = local_2.member_1[1u];
                            let _e2351 = ((_e2338[0] + _e2344[0]) * 0.5f);
                            let _e2352 = ((_e2338[1] + _e2344[1]) * 0.5f);
                            let _e2353 = ((_e2338[2] + _e2344[2]) * 0.5f);
                            let _e2356 = local_2.member_2[0u];
                            let _e2362 = local_2.member_2[1u];
                            let _e2369 = ((_e2356[0] + _e2362[0]) * 0.5f);
                            let _e2370 = ((_e2356[1] + _e2362[1]) * 0.5f);
                            let _e2371 = ((_e2356[2] + _e2362[2]) * 0.5f);
                            let _e2374 = local_2.member[0u];
                            let _e2377 = local_2.member_1[0u];
                            let _e2380 = local_2.member_2[0u];
                            let _e2382 = local_2.member_3;
                            let _e2385 = local_2.member[1u];
                            let _e2388 = local_2.member_1[1u];
                            let _e2391 = local_2.member_2[1u];
                            let _e2393 = local_2.member_3;
                            local = type_27(array<array<f32, 3>, 2>(_e2374, array<f32, 3>(_e2333, _e2334, _e2335)), array<array<f32, 3>, 2>(_e2377, array<f32, 3>(_e2351, _e2352, _e2353)), array<array<f32, 3>, 2>(_e2380, array<f32, 3>(_e2369, _e2370, _e2371)), _e2382);
                            local_1 = type_27(array<array<f32, 3>, 2>(array<f32, 3>(_e2333, _e2334, _e2335), _e2385), array<array<f32, 3>, 2>(array<f32, 3>(_e2351, _e2352, _e2353), _e2388), array<array<f32, 3>, 2>(array<f32, 3>(_e2369, _e2370, _e2371), _e2391), _e2393);
                            let _e2410 = local.member_1[0u];
                            let _e2416 = local.member_2[0u];
                            let _e2422 = ((_e2410[1] * _e2416[2]) - (_e2410[2] * _e2416[1]));
                            let _e2425 = ((_e2410[2] * _e2416[0]) - (_e2410[0] * _e2416[2]));
                            let _e2428 = ((_e2410[0] * _e2416[1]) - (_e2410[1] * _e2416[0]));
                            let _e2431 = local.member_1[1u];
                            let _e2437 = local.member_2[1u];
                            let _e2443 = ((_e2431[1] * _e2437[2]) - (_e2431[2] * _e2437[1]));
                            let _e2446 = ((_e2431[2] * _e2437[0]) - (_e2431[0] * _e2437[2]));
                            let _e2449 = ((_e2431[0] * _e2437[1]) - (_e2431[1] * _e2437[0]));
                            let _e2452 = local.member_1[0u];
                            let _e2458 = local.member_2[1u];
                            let _e2473 = local.member_1[1u];
                            let _e2479 = local.member_2[0u];
                            let _e2492 = (((_e2452[1] * _e2458[2]) - (_e2452[2] * _e2458[1])) + ((_e2473[1] * _e2479[2]) - (_e2473[2] * _e2479[1])));
                            let _e2493 = (((_e2452[2] * _e2458[0]) - (_e2452[0] * _e2458[2])) + ((_e2473[2] * _e2479[0]) - (_e2473[0] * _e2479[2])));
                            let _e2494 = (((_e2452[0] * _e2458[1]) - (_e2452[1] * _e2458[0])) + ((_e2473[0] * _e2479[1]) - (_e2473[1] * _e2479[0])));
                            let _e2497 = local.member[0u];
                            let _e2508 = local.member[1u];
                            let _e2519 = local.member[0u];
                            let _e2528 = ((((_e2508[0] * _e2422) + (_e2508[1] * _e2425)) + (_e2508[2] * _e2428)) + (((_e2519[0] * _e2492) + (_e2519[1] * _e2493)) + (_e2519[2] * _e2494)));
                            let _e2531 = local.member[0u];
                            let _e2542 = local.member[1u];
                            let _e2551 = ((((_e2531[0] * _e2443) + (_e2531[1] * _e2446)) + (_e2531[2] * _e2449)) + (((_e2542[0] * _e2492) + (_e2542[1] * _e2493)) + (_e2542[2] * _e2494)));
                            let _e2554 = local.member[1u];
                            let _e2565 = local.member[0u];
                            if (_e2565[0] < 0f) {
                                phi_4200_ = -(_e2565[0]);
                            } else {
                                phi_4200_ = _e2565[0];
                            }
                            let _e2572 = phi_4200_;
                            if (_e2565[1] < 0f) {
                                phi_4207_ = -(_e2565[1]);
                            } else {
                                phi_4207_ = _e2565[1];
                            }
                            let _e2576 = phi_4207_;
                            if (_e2572 > _e2576) {
                                phi_4212_ = _e2572;
                            } else {
                                phi_4212_ = _e2576;
                            }
                            let _e2579 = phi_4212_;
                            if (_e2565[2] < 0f) {
                                phi_4219_ = -(_e2565[2]);
                            } else {
                                phi_4219_ = _e2565[2];
                            }
                            let _e2583 = phi_4219_;
                            if (_e2579 > _e2583) {
                                phi_4224_ = _e2579;
                            } else {
                                phi_4224_ = _e2583;
                            }
                            let _e2586 = phi_4224_;
                            let _e2589 = local.member[1u];
                            if (_e2589[0] < 0f) {
                                phi_4237_ = -(_e2589[0]);
                            } else {
                                phi_4237_ = _e2589[0];
                            }
                            let _e2596 = phi_4237_;
                            if (_e2589[1] < 0f) {
                                phi_4244_ = -(_e2589[1]);
                            } else {
                                phi_4244_ = _e2589[1];
                            }
                            let _e2600 = phi_4244_;
                            if (_e2596 > _e2600) {
                                phi_4249_ = _e2596;
                            } else {
                                phi_4249_ = _e2600;
                            }
                            let _e2603 = phi_4249_;
                            if (_e2589[2] < 0f) {
                                phi_4256_ = -(_e2589[2]);
                            } else {
                                phi_4256_ = _e2589[2];
                            }
                            let _e2607 = phi_4256_;
                            if (_e2603 > _e2607) {
                                phi_4261_ = _e2603;
                            } else {
                                phi_4261_ = _e2607;
                            }
                            let _e2610 = phi_4261_;
                            if (_e2586 > _e2610) {
                                phi_4266_ = _e2586;
                            } else {
                                phi_4266_ = _e2610;
                            }
                            let _e2613 = phi_4266_;
                            let _e2615 = local.member_3;
                            let _e2616 = (_e2613 + _e2615);
                            let _e2619 = local.member_1[0u];
                            if (_e2619[0] < 0f) {
                                phi_4283_ = -(_e2619[0]);
                            } else {
                                phi_4283_ = _e2619[0];
                            }
                            let _e2626 = phi_4283_;
                            if (_e2619[1] < 0f) {
                                phi_4290_ = -(_e2619[1]);
                            } else {
                                phi_4290_ = _e2619[1];
                            }
                            let _e2630 = phi_4290_;
                            if (_e2626 > _e2630) {
                                phi_4295_ = _e2626;
                            } else {
                                phi_4295_ = _e2630;
                            }
                            let _e2633 = phi_4295_;
                            if (_e2619[2] < 0f) {
                                phi_4302_ = -(_e2619[2]);
                            } else {
                                phi_4302_ = _e2619[2];
                            }
                            let _e2637 = phi_4302_;
                            if (_e2633 > _e2637) {
                                phi_4307_ = _e2633;
                            } else {
                                phi_4307_ = _e2637;
                            }
                            let _e2640 = phi_4307_;
                            let _e2643 = local.member_1[1u];
                            if (_e2643[0] < 0f) {
                                phi_4321_ = -(_e2643[0]);
                            } else {
                                phi_4321_ = _e2643[0];
                            }
                            let _e2650 = phi_4321_;
                            if (_e2643[1] < 0f) {
                                phi_4328_ = -(_e2643[1]);
                            } else {
                                phi_4328_ = _e2643[1];
                            }
                            let _e2654 = phi_4328_;
                            if (_e2650 > _e2654) {
                                phi_4333_ = _e2650;
                            } else {
                                phi_4333_ = _e2654;
                            }
                            let _e2657 = phi_4333_;
                            if (_e2643[2] < 0f) {
                                phi_4340_ = -(_e2643[2]);
                            } else {
                                phi_4340_ = _e2643[2];
                            }
                            let _e2661 = phi_4340_;
                            if (_e2657 > _e2661) {
                                phi_4345_ = _e2657;
                            } else {
                                phi_4345_ = _e2661;
                            }
                            let _e2664 = phi_4345_;
                            if (_e2640 > _e2664) {
                                phi_4350_ = _e2640;
                            } else {
                                phi_4350_ = _e2664;
                            }
                            let _e2667 = phi_4350_;
                            let _e2669 = local.member_3;
                            let _e2670 = (_e2667 + _e2669);
                            let _e2673 = local.member_2[0u];
                            if (_e2673[0] < 0f) {
                                phi_4367_ = -(_e2673[0]);
                            } else {
                                phi_4367_ = _e2673[0];
                            }
                            let _e2680 = phi_4367_;
                            if (_e2673[1] < 0f) {
                                phi_4374_ = -(_e2673[1]);
                            } else {
                                phi_4374_ = _e2673[1];
                            }
                            let _e2684 = phi_4374_;
                            if (_e2680 > _e2684) {
                                phi_4379_ = _e2680;
                            } else {
                                phi_4379_ = _e2684;
                            }
                            let _e2687 = phi_4379_;
                            if (_e2673[2] < 0f) {
                                phi_4386_ = -(_e2673[2]);
                            } else {
                                phi_4386_ = _e2673[2];
                            }
                            let _e2691 = phi_4386_;
                            if (_e2687 > _e2691) {
                                phi_4391_ = _e2687;
                            } else {
                                phi_4391_ = _e2691;
                            }
                            let _e2694 = phi_4391_;
                            let _e2697 = local.member_2[1u];
                            if (_e2697[0] < 0f) {
                                phi_4405_ = -(_e2697[0]);
                            } else {
                                phi_4405_ = _e2697[0];
                            }
                            let _e2704 = phi_4405_;
                            if (_e2697[1] < 0f) {
                                phi_4412_ = -(_e2697[1]);
                            } else {
                                phi_4412_ = _e2697[1];
                            }
                            let _e2708 = phi_4412_;
                            if (_e2704 > _e2708) {
                                phi_4417_ = _e2704;
                            } else {
                                phi_4417_ = _e2708;
                            }
                            let _e2711 = phi_4417_;
                            if (_e2697[2] < 0f) {
                                phi_4424_ = -(_e2697[2]);
                            } else {
                                phi_4424_ = _e2697[2];
                            }
                            let _e2715 = phi_4424_;
                            if (_e2711 > _e2715) {
                                phi_4429_ = _e2711;
                            } else {
                                phi_4429_ = _e2715;
                            }
                            let _e2718 = phi_4429_;
                            if (_e2694 > _e2718) {
                                phi_4434_ = _e2694;
                            } else {
                                phi_4434_ = _e2718;
                            }
                            let _e2721 = phi_4434_;
                            let _e2723 = local.member_3;
                            let _e2724 = (_e2721 + _e2723);
                            let _e2726 = ((_e2670 * 8f) * _e2724);
                            let _e2733 = local.member_3;
                            if (_e2422 < 0f) {
                                phi_4465_ = -(_e2422);
                            } else {
                                phi_4465_ = _e2422;
                            }
                            let _e2750 = phi_4465_;
                            if (_e2425 < 0f) {
                                phi_4471_ = -(_e2425);
                            } else {
                                phi_4471_ = _e2425;
                            }
                            let _e2754 = phi_4471_;
                            if (_e2428 < 0f) {
                                phi_4478_ = -(_e2428);
                            } else {
                                phi_4478_ = _e2428;
                            }
                            let _e2759 = phi_4478_;
                            let _e2760 = ((_e2750 + _e2754) + _e2759);
                            if (_e2443 < 0f) {
                                phi_4485_ = -(_e2443);
                            } else {
                                phi_4485_ = _e2443;
                            }
                            let _e2764 = phi_4485_;
                            if (_e2446 < 0f) {
                                phi_4491_ = -(_e2446);
                            } else {
                                phi_4491_ = _e2446;
                            }
                            let _e2768 = phi_4491_;
                            if (_e2449 < 0f) {
                                phi_4498_ = -(_e2449);
                            } else {
                                phi_4498_ = _e2449;
                            }
                            let _e2773 = phi_4498_;
                            let _e2774 = ((_e2764 + _e2768) + _e2773);
                            if (_e2760 > _e2774) {
                                phi_4504_ = _e2760;
                            } else {
                                phi_4504_ = _e2774;
                            }
                            let _e2777 = phi_4504_;
                            if (_e2492 < 0f) {
                                phi_4510_ = -(_e2492);
                            } else {
                                phi_4510_ = _e2492;
                            }
                            let _e2781 = phi_4510_;
                            if (_e2493 < 0f) {
                                phi_4516_ = -(_e2493);
                            } else {
                                phi_4516_ = _e2493;
                            }
                            let _e2785 = phi_4516_;
                            if (_e2494 < 0f) {
                                phi_4523_ = -(_e2494);
                            } else {
                                phi_4523_ = _e2494;
                            }
                            let _e2790 = phi_4523_;
                            let _e2792 = (((_e2781 + _e2785) + _e2790) * 0.5f);
                            if (_e2777 > _e2792) {
                                phi_4530_ = _e2777;
                            } else {
                                phi_4530_ = _e2792;
                            }
                            let _e2795 = phi_4530_;
                            let _e2800 = local.member_3;
                            let _e2813 = ((((_e2497[0] * _e2422) + (_e2497[1] * _e2425)) + (_e2497[2] * _e2428)) * 3f);
                            let _e2814 = ((((_e2554[0] * _e2443) + (_e2554[1] * _e2446)) + (_e2554[2] * _e2449)) * 3f);
                            if (_e2813 < _e2814) {
                                phi_4554_ = _e2813;
                            } else {
                                phi_4554_ = _e2814;
                            }
                            let _e2817 = phi_4554_;
                            if (_e2528 < _e2551) {
                                phi_4559_ = _e2528;
                            } else {
                                phi_4559_ = _e2551;
                            }
                            let _e2820 = phi_4559_;
                            if (_e2817 < _e2820) {
                                phi_4564_ = _e2817;
                            } else {
                                phi_4564_ = _e2820;
                            }
                            let _e2823 = phi_4564_;
                            if (_e2813 > _e2814) {
                                phi_4569_ = _e2813;
                            } else {
                                phi_4569_ = _e2814;
                            }
                            let _e2826 = phi_4569_;
                            if (_e2528 > _e2551) {
                                phi_4574_ = _e2528;
                            } else {
                                phi_4574_ = _e2551;
                            }
                            let _e2829 = phi_4574_;
                            if (_e2826 > _e2829) {
                                phi_4579_ = _e2826;
                            } else {
                                phi_4579_ = _e2829;
                            }
                            let _e2832 = phi_4579_;
                            let _e2837 = -(_e2832);
                            if (_e2823 > _e2837) {
                                phi_4589_ = _e2823;
                            } else {
                                phi_4589_ = _e2837;
                            }
                            let _e2840 = phi_4589_;
                            let _e2842 = ((_e2840 - ((((((_e2616 * 8f) * _e2726) * (0.000000059604645f * (524f / 64f))) + ((_e2733 * 19f) * ((_e2616 * (_e2670 + _e2724)) + (_e2670 * _e2724)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2616) * ((1f + _e2670) * (1f + _e2724))))) + ((_e815 * (((_e2795 + (_e2726 * (0.000000059604645f * 8f))) + ((_e2800 * 6f) * (_e2670 + _e2724))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2670) * (1f + _e2724))))) * (3f * 1.0001f)))) > 0f);
                            if _e2842 {
                                phi_5558_ = _e2842;
                            } else {
                                let _e2845 = local.member_1[0u];
                                let _e2851 = local.member_1[1u];
                                let _e2855 = (_e2845[0] + _e2851[0]);
                                let _e2856 = (_e2845[1] + _e2851[1]);
                                let _e2857 = (_e2845[2] + _e2851[2]);
                                let _e2860 = local.member_2[0u];
                                let _e2866 = local.member_2[1u];
                                let _e2870 = (_e2860[0] + _e2866[0]);
                                let _e2871 = (_e2860[1] + _e2866[1]);
                                let _e2872 = (_e2860[2] + _e2866[2]);
                                let _e2875 = ((_e2856 * _e2872) - (_e2857 * _e2871));
                                let _e2878 = ((_e2857 * _e2870) - (_e2855 * _e2872));
                                let _e2881 = ((_e2855 * _e2871) - (_e2856 * _e2870));
                                let _e2884 = local.member[0u];
                                let _e2891 = local.member_1[0u];
                                let _e2897 = local.member_2[0u];
                                let _e2901 = (_e2884[0] - _e2891[0]);
                                let _e2902 = (_e2884[1] - _e2891[1]);
                                let _e2903 = (_e2884[2] - _e2891[2]);
                                if (_e179.member == 0u) {
                                    phi_4705_ = array<f32, 3>(_e2884[0], _e2884[1], _e2884[2]);
                                } else {
                                    phi_4705_ = array<f32, 3>((_e2901 - _e2897[0]), (_e2902 - _e2897[1]), (_e2903 - _e2897[2]));
                                }
                                let _e2910 = phi_4705_;
                                let _e2911 = (_e2884[0] - _e2897[0]);
                                let _e2912 = (_e2884[1] - _e2897[1]);
                                let _e2913 = (_e2884[2] - _e2897[2]);
                                let _e2916 = local.member[1u];
                                let _e2923 = local.member_1[1u];
                                let _e2929 = local.member_2[1u];
                                let _e2933 = (_e2916[0] - _e2923[0]);
                                let _e2934 = (_e2916[1] - _e2923[1]);
                                let _e2935 = (_e2916[2] - _e2923[2]);
                                if (_e179.member == 0u) {
                                    phi_4770_ = array<f32, 3>(_e2916[0], _e2916[1], _e2916[2]);
                                } else {
                                    phi_4770_ = array<f32, 3>((_e2933 - _e2929[0]), (_e2934 - _e2929[1]), (_e2935 - _e2929[2]));
                                }
                                let _e2942 = phi_4770_;
                                let _e2943 = (_e2916[0] - _e2929[0]);
                                let _e2944 = (_e2916[1] - _e2929[1]);
                                let _e2945 = (_e2916[2] - _e2929[2]);
                                let _e2948 = local.member[0u];
                                if (_e2948[0] < 0f) {
                                    phi_4792_ = -(_e2948[0]);
                                } else {
                                    phi_4792_ = _e2948[0];
                                }
                                let _e2955 = phi_4792_;
                                if (_e2948[1] < 0f) {
                                    phi_4799_ = -(_e2948[1]);
                                } else {
                                    phi_4799_ = _e2948[1];
                                }
                                let _e2959 = phi_4799_;
                                if (_e2955 > _e2959) {
                                    phi_4804_ = _e2955;
                                } else {
                                    phi_4804_ = _e2959;
                                }
                                let _e2962 = phi_4804_;
                                if (_e2948[2] < 0f) {
                                    phi_4811_ = -(_e2948[2]);
                                } else {
                                    phi_4811_ = _e2948[2];
                                }
                                let _e2966 = phi_4811_;
                                if (_e2962 > _e2966) {
                                    phi_4816_ = _e2962;
                                } else {
                                    phi_4816_ = _e2966;
                                }
                                let _e2969 = phi_4816_;
                                let _e2972 = local.member[1u];
                                if (_e2972[0] < 0f) {
                                    phi_4829_ = -(_e2972[0]);
                                } else {
                                    phi_4829_ = _e2972[0];
                                }
                                let _e2979 = phi_4829_;
                                if (_e2972[1] < 0f) {
                                    phi_4836_ = -(_e2972[1]);
                                } else {
                                    phi_4836_ = _e2972[1];
                                }
                                let _e2983 = phi_4836_;
                                if (_e2979 > _e2983) {
                                    phi_4841_ = _e2979;
                                } else {
                                    phi_4841_ = _e2983;
                                }
                                let _e2986 = phi_4841_;
                                if (_e2972[2] < 0f) {
                                    phi_4848_ = -(_e2972[2]);
                                } else {
                                    phi_4848_ = _e2972[2];
                                }
                                let _e2990 = phi_4848_;
                                if (_e2986 > _e2990) {
                                    phi_4853_ = _e2986;
                                } else {
                                    phi_4853_ = _e2990;
                                }
                                let _e2993 = phi_4853_;
                                if (_e2969 > _e2993) {
                                    phi_4858_ = _e2969;
                                } else {
                                    phi_4858_ = _e2993;
                                }
                                let _e2996 = phi_4858_;
                                let _e2998 = local.member_3;
                                let _e3002 = local.member_1[0u];
                                if (_e3002[0] < 0f) {
                                    phi_4875_ = -(_e3002[0]);
                                } else {
                                    phi_4875_ = _e3002[0];
                                }
                                let _e3009 = phi_4875_;
                                if (_e3002[1] < 0f) {
                                    phi_4882_ = -(_e3002[1]);
                                } else {
                                    phi_4882_ = _e3002[1];
                                }
                                let _e3013 = phi_4882_;
                                if (_e3009 > _e3013) {
                                    phi_4887_ = _e3009;
                                } else {
                                    phi_4887_ = _e3013;
                                }
                                let _e3016 = phi_4887_;
                                if (_e3002[2] < 0f) {
                                    phi_4894_ = -(_e3002[2]);
                                } else {
                                    phi_4894_ = _e3002[2];
                                }
                                let _e3020 = phi_4894_;
                                if (_e3016 > _e3020) {
                                    phi_4899_ = _e3016;
                                } else {
                                    phi_4899_ = _e3020;
                                }
                                let _e3023 = phi_4899_;
                                let _e3026 = local.member_1[1u];
                                if (_e3026[0] < 0f) {
                                    phi_4913_ = -(_e3026[0]);
                                } else {
                                    phi_4913_ = _e3026[0];
                                }
                                let _e3033 = phi_4913_;
                                if (_e3026[1] < 0f) {
                                    phi_4920_ = -(_e3026[1]);
                                } else {
                                    phi_4920_ = _e3026[1];
                                }
                                let _e3037 = phi_4920_;
                                if (_e3033 > _e3037) {
                                    phi_4925_ = _e3033;
                                } else {
                                    phi_4925_ = _e3037;
                                }
                                let _e3040 = phi_4925_;
                                if (_e3026[2] < 0f) {
                                    phi_4932_ = -(_e3026[2]);
                                } else {
                                    phi_4932_ = _e3026[2];
                                }
                                let _e3044 = phi_4932_;
                                if (_e3040 > _e3044) {
                                    phi_4937_ = _e3040;
                                } else {
                                    phi_4937_ = _e3044;
                                }
                                let _e3047 = phi_4937_;
                                if (_e3023 > _e3047) {
                                    phi_4942_ = _e3023;
                                } else {
                                    phi_4942_ = _e3047;
                                }
                                let _e3050 = phi_4942_;
                                let _e3052 = local.member_3;
                                let _e3056 = local.member_2[0u];
                                if (_e3056[0] < 0f) {
                                    phi_4959_ = -(_e3056[0]);
                                } else {
                                    phi_4959_ = _e3056[0];
                                }
                                let _e3063 = phi_4959_;
                                if (_e3056[1] < 0f) {
                                    phi_4966_ = -(_e3056[1]);
                                } else {
                                    phi_4966_ = _e3056[1];
                                }
                                let _e3067 = phi_4966_;
                                if (_e3063 > _e3067) {
                                    phi_4971_ = _e3063;
                                } else {
                                    phi_4971_ = _e3067;
                                }
                                let _e3070 = phi_4971_;
                                if (_e3056[2] < 0f) {
                                    phi_4978_ = -(_e3056[2]);
                                } else {
                                    phi_4978_ = _e3056[2];
                                }
                                let _e3074 = phi_4978_;
                                if (_e3070 > _e3074) {
                                    phi_4983_ = _e3070;
                                } else {
                                    phi_4983_ = _e3074;
                                }
                                let _e3077 = phi_4983_;
                                let _e3080 = local.member_2[1u];
                                if (_e3080[0] < 0f) {
                                    phi_4997_ = -(_e3080[0]);
                                } else {
                                    phi_4997_ = _e3080[0];
                                }
                                let _e3087 = phi_4997_;
                                if (_e3080[1] < 0f) {
                                    phi_5004_ = -(_e3080[1]);
                                } else {
                                    phi_5004_ = _e3080[1];
                                }
                                let _e3091 = phi_5004_;
                                if (_e3087 > _e3091) {
                                    phi_5009_ = _e3087;
                                } else {
                                    phi_5009_ = _e3091;
                                }
                                let _e3094 = phi_5009_;
                                if (_e3080[2] < 0f) {
                                    phi_5016_ = -(_e3080[2]);
                                } else {
                                    phi_5016_ = _e3080[2];
                                }
                                let _e3098 = phi_5016_;
                                if (_e3094 > _e3098) {
                                    phi_5021_ = _e3094;
                                } else {
                                    phi_5021_ = _e3098;
                                }
                                let _e3101 = phi_5021_;
                                if (_e3077 > _e3101) {
                                    phi_5026_ = _e3077;
                                } else {
                                    phi_5026_ = _e3101;
                                }
                                let _e3104 = phi_5026_;
                                let _e3106 = local.member_3;
                                let _e3110 = ((((_e2996 + _e2998) + (_e3050 + _e3052)) + (_e3104 + _e3106)) * 2f);
                                let _e3113 = local.member_3;
                                let _e3117 = (((_e815 * 1.0001f) + (_e3113 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e3120 = ((_e2878 * _e2857) - (_e2881 * _e2856));
                                let _e3123 = ((_e2881 * _e2855) - (_e2875 * _e2857));
                                let _e3126 = ((_e2875 * _e2856) - (_e2878 * _e2855));
                                let _e3131 = (((_e3120 * _e2884[0]) + (_e3123 * _e2884[1])) + (_e3126 * _e2884[2]));
                                let _e3136 = (((_e3120 * _e2901) + (_e3123 * _e2902)) + (_e3126 * _e2903));
                                let _e3141 = (((_e3120 * _e2911) + (_e3123 * _e2912)) + (_e3126 * _e2913));
                                let _e3149 = (((_e3120 * _e2910[0]) + (_e3123 * _e2910[1])) + (_e3126 * _e2910[2]));
                                let _e3154 = (((_e3120 * _e2916[0]) + (_e3123 * _e2916[1])) + (_e3126 * _e2916[2]));
                                let _e3159 = (((_e3120 * _e2933) + (_e3123 * _e2934)) + (_e3126 * _e2935));
                                let _e3164 = (((_e3120 * _e2943) + (_e3123 * _e2944)) + (_e3126 * _e2945));
                                let _e3172 = (((_e3120 * _e2942[0]) + (_e3123 * _e2942[1])) + (_e3126 * _e2942[2]));
                                if (_e3131 < _e3136) {
                                    phi_5105_ = _e3131;
                                } else {
                                    phi_5105_ = _e3136;
                                }
                                let _e3175 = phi_5105_;
                                if (_e3141 < _e3149) {
                                    phi_5110_ = _e3141;
                                } else {
                                    phi_5110_ = _e3149;
                                }
                                let _e3178 = phi_5110_;
                                if (_e3175 < _e3178) {
                                    phi_5115_ = _e3175;
                                } else {
                                    phi_5115_ = _e3178;
                                }
                                let _e3181 = phi_5115_;
                                if (_e3154 < _e3159) {
                                    phi_5120_ = _e3154;
                                } else {
                                    phi_5120_ = _e3159;
                                }
                                let _e3184 = phi_5120_;
                                if (_e3164 < _e3172) {
                                    phi_5125_ = _e3164;
                                } else {
                                    phi_5125_ = _e3172;
                                }
                                let _e3187 = phi_5125_;
                                if (_e3184 < _e3187) {
                                    phi_5130_ = _e3184;
                                } else {
                                    phi_5130_ = _e3187;
                                }
                                let _e3190 = phi_5130_;
                                if (_e3181 < _e3190) {
                                    phi_5135_ = _e3181;
                                } else {
                                    phi_5135_ = _e3190;
                                }
                                let _e3193 = phi_5135_;
                                if (_e3131 > _e3136) {
                                    phi_5140_ = _e3131;
                                } else {
                                    phi_5140_ = _e3136;
                                }
                                let _e3196 = phi_5140_;
                                if (_e3141 > _e3149) {
                                    phi_5145_ = _e3141;
                                } else {
                                    phi_5145_ = _e3149;
                                }
                                let _e3199 = phi_5145_;
                                if (_e3196 > _e3199) {
                                    phi_5150_ = _e3196;
                                } else {
                                    phi_5150_ = _e3199;
                                }
                                let _e3202 = phi_5150_;
                                if (_e3154 > _e3159) {
                                    phi_5155_ = _e3154;
                                } else {
                                    phi_5155_ = _e3159;
                                }
                                let _e3205 = phi_5155_;
                                if (_e3164 > _e3172) {
                                    phi_5160_ = _e3164;
                                } else {
                                    phi_5160_ = _e3172;
                                }
                                let _e3208 = phi_5160_;
                                if (_e3205 > _e3208) {
                                    phi_5165_ = _e3205;
                                } else {
                                    phi_5165_ = _e3208;
                                }
                                let _e3211 = phi_5165_;
                                if (_e3202 > _e3211) {
                                    phi_5170_ = _e3202;
                                } else {
                                    phi_5170_ = _e3211;
                                }
                                let _e3214 = phi_5170_;
                                if (_e3120 < 0f) {
                                    phi_5176_ = -(_e3120);
                                } else {
                                    phi_5176_ = _e3120;
                                }
                                let _e3218 = phi_5176_;
                                if (_e3123 < 0f) {
                                    phi_5182_ = -(_e3123);
                                } else {
                                    phi_5182_ = _e3123;
                                }
                                let _e3222 = phi_5182_;
                                if (_e3126 < 0f) {
                                    phi_5189_ = -(_e3126);
                                } else {
                                    phi_5189_ = _e3126;
                                }
                                let _e3227 = phi_5189_;
                                let _e3228 = ((_e3218 + _e3222) + _e3227);
                                let _e3233 = -(_e3214);
                                if (_e3193 > _e3233) {
                                    phi_5200_ = _e3193;
                                } else {
                                    phi_5200_ = _e3233;
                                }
                                let _e3236 = phi_5200_;
                                let _e3241 = (((_e3236 - ((_e3228 * _e3110) * (0.000000059604645f * (17f / 2f)))) - (_e3228 * _e3117)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3244 = ((_e2878 * _e2872) - (_e2881 * _e2871));
                                let _e3247 = ((_e2881 * _e2870) - (_e2875 * _e2872));
                                let _e3250 = ((_e2875 * _e2871) - (_e2878 * _e2870));
                                let _e3255 = (((_e3244 * _e2884[0]) + (_e3247 * _e2884[1])) + (_e3250 * _e2884[2]));
                                let _e3260 = (((_e3244 * _e2901) + (_e3247 * _e2902)) + (_e3250 * _e2903));
                                let _e3265 = (((_e3244 * _e2911) + (_e3247 * _e2912)) + (_e3250 * _e2913));
                                let _e3273 = (((_e3244 * _e2910[0]) + (_e3247 * _e2910[1])) + (_e3250 * _e2910[2]));
                                let _e3278 = (((_e3244 * _e2916[0]) + (_e3247 * _e2916[1])) + (_e3250 * _e2916[2]));
                                let _e3283 = (((_e3244 * _e2933) + (_e3247 * _e2934)) + (_e3250 * _e2935));
                                let _e3288 = (((_e3244 * _e2943) + (_e3247 * _e2944)) + (_e3250 * _e2945));
                                let _e3296 = (((_e3244 * _e2942[0]) + (_e3247 * _e2942[1])) + (_e3250 * _e2942[2]));
                                if (_e3255 < _e3260) {
                                    phi_5271_ = _e3255;
                                } else {
                                    phi_5271_ = _e3260;
                                }
                                let _e3299 = phi_5271_;
                                if (_e3265 < _e3273) {
                                    phi_5276_ = _e3265;
                                } else {
                                    phi_5276_ = _e3273;
                                }
                                let _e3302 = phi_5276_;
                                if (_e3299 < _e3302) {
                                    phi_5281_ = _e3299;
                                } else {
                                    phi_5281_ = _e3302;
                                }
                                let _e3305 = phi_5281_;
                                if (_e3278 < _e3283) {
                                    phi_5286_ = _e3278;
                                } else {
                                    phi_5286_ = _e3283;
                                }
                                let _e3308 = phi_5286_;
                                if (_e3288 < _e3296) {
                                    phi_5291_ = _e3288;
                                } else {
                                    phi_5291_ = _e3296;
                                }
                                let _e3311 = phi_5291_;
                                if (_e3308 < _e3311) {
                                    phi_5296_ = _e3308;
                                } else {
                                    phi_5296_ = _e3311;
                                }
                                let _e3314 = phi_5296_;
                                if (_e3305 < _e3314) {
                                    phi_5301_ = _e3305;
                                } else {
                                    phi_5301_ = _e3314;
                                }
                                let _e3317 = phi_5301_;
                                if (_e3255 > _e3260) {
                                    phi_5306_ = _e3255;
                                } else {
                                    phi_5306_ = _e3260;
                                }
                                let _e3320 = phi_5306_;
                                if (_e3265 > _e3273) {
                                    phi_5311_ = _e3265;
                                } else {
                                    phi_5311_ = _e3273;
                                }
                                let _e3323 = phi_5311_;
                                if (_e3320 > _e3323) {
                                    phi_5316_ = _e3320;
                                } else {
                                    phi_5316_ = _e3323;
                                }
                                let _e3326 = phi_5316_;
                                if (_e3278 > _e3283) {
                                    phi_5321_ = _e3278;
                                } else {
                                    phi_5321_ = _e3283;
                                }
                                let _e3329 = phi_5321_;
                                if (_e3288 > _e3296) {
                                    phi_5326_ = _e3288;
                                } else {
                                    phi_5326_ = _e3296;
                                }
                                let _e3332 = phi_5326_;
                                if (_e3329 > _e3332) {
                                    phi_5331_ = _e3329;
                                } else {
                                    phi_5331_ = _e3332;
                                }
                                let _e3335 = phi_5331_;
                                if (_e3326 > _e3335) {
                                    phi_5336_ = _e3326;
                                } else {
                                    phi_5336_ = _e3335;
                                }
                                let _e3338 = phi_5336_;
                                if (_e3244 < 0f) {
                                    phi_5342_ = -(_e3244);
                                } else {
                                    phi_5342_ = _e3244;
                                }
                                let _e3342 = phi_5342_;
                                if (_e3247 < 0f) {
                                    phi_5348_ = -(_e3247);
                                } else {
                                    phi_5348_ = _e3247;
                                }
                                let _e3346 = phi_5348_;
                                if (_e3250 < 0f) {
                                    phi_5355_ = -(_e3250);
                                } else {
                                    phi_5355_ = _e3250;
                                }
                                let _e3351 = phi_5355_;
                                let _e3352 = ((_e3342 + _e3346) + _e3351);
                                let _e3357 = -(_e3338);
                                if (_e3317 > _e3357) {
                                    phi_5366_ = _e3317;
                                } else {
                                    phi_5366_ = _e3357;
                                }
                                let _e3360 = phi_5366_;
                                let _e3365 = (((_e3360 - ((_e3352 * _e3110) * (0.000000059604645f * (17f / 2f)))) - (_e3352 * _e3117)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3241 > _e3365) {
                                    phi_5376_ = _e3241;
                                } else {
                                    phi_5376_ = _e3365;
                                }
                                let _e3368 = phi_5376_;
                                if (_e179.member == 0u) {
                                    let _e3370 = (_e2870 - _e2855);
                                    let _e3371 = (_e2871 - _e2856);
                                    let _e3372 = (_e2872 - _e2857);
                                    let _e3375 = ((_e2878 * _e3372) - (_e2881 * _e3371));
                                    let _e3378 = ((_e2881 * _e3370) - (_e2875 * _e3372));
                                    let _e3381 = ((_e2875 * _e3371) - (_e2878 * _e3370));
                                    let _e3386 = (((_e3375 * _e2884[0]) + (_e3378 * _e2884[1])) + (_e3381 * _e2884[2]));
                                    let _e3391 = (((_e3375 * _e2901) + (_e3378 * _e2902)) + (_e3381 * _e2903));
                                    let _e3396 = (((_e3375 * _e2911) + (_e3378 * _e2912)) + (_e3381 * _e2913));
                                    let _e3404 = (((_e3375 * _e2910[0]) + (_e3378 * _e2910[1])) + (_e3381 * _e2910[2]));
                                    let _e3409 = (((_e3375 * _e2916[0]) + (_e3378 * _e2916[1])) + (_e3381 * _e2916[2]));
                                    let _e3414 = (((_e3375 * _e2933) + (_e3378 * _e2934)) + (_e3381 * _e2935));
                                    let _e3419 = (((_e3375 * _e2943) + (_e3378 * _e2944)) + (_e3381 * _e2945));
                                    let _e3427 = (((_e3375 * _e2942[0]) + (_e3378 * _e2942[1])) + (_e3381 * _e2942[2]));
                                    if (_e3386 < _e3391) {
                                        phi_5449_ = _e3386;
                                    } else {
                                        phi_5449_ = _e3391;
                                    }
                                    let _e3430 = phi_5449_;
                                    if (_e3396 < _e3404) {
                                        phi_5454_ = _e3396;
                                    } else {
                                        phi_5454_ = _e3404;
                                    }
                                    let _e3433 = phi_5454_;
                                    if (_e3430 < _e3433) {
                                        phi_5459_ = _e3430;
                                    } else {
                                        phi_5459_ = _e3433;
                                    }
                                    let _e3436 = phi_5459_;
                                    if (_e3409 < _e3414) {
                                        phi_5464_ = _e3409;
                                    } else {
                                        phi_5464_ = _e3414;
                                    }
                                    let _e3439 = phi_5464_;
                                    if (_e3419 < _e3427) {
                                        phi_5469_ = _e3419;
                                    } else {
                                        phi_5469_ = _e3427;
                                    }
                                    let _e3442 = phi_5469_;
                                    if (_e3439 < _e3442) {
                                        phi_5474_ = _e3439;
                                    } else {
                                        phi_5474_ = _e3442;
                                    }
                                    let _e3445 = phi_5474_;
                                    if (_e3436 < _e3445) {
                                        phi_5479_ = _e3436;
                                    } else {
                                        phi_5479_ = _e3445;
                                    }
                                    let _e3448 = phi_5479_;
                                    if (_e3386 > _e3391) {
                                        phi_5484_ = _e3386;
                                    } else {
                                        phi_5484_ = _e3391;
                                    }
                                    let _e3451 = phi_5484_;
                                    if (_e3396 > _e3404) {
                                        phi_5489_ = _e3396;
                                    } else {
                                        phi_5489_ = _e3404;
                                    }
                                    let _e3454 = phi_5489_;
                                    if (_e3451 > _e3454) {
                                        phi_5494_ = _e3451;
                                    } else {
                                        phi_5494_ = _e3454;
                                    }
                                    let _e3457 = phi_5494_;
                                    if (_e3409 > _e3414) {
                                        phi_5499_ = _e3409;
                                    } else {
                                        phi_5499_ = _e3414;
                                    }
                                    let _e3460 = phi_5499_;
                                    if (_e3419 > _e3427) {
                                        phi_5504_ = _e3419;
                                    } else {
                                        phi_5504_ = _e3427;
                                    }
                                    let _e3463 = phi_5504_;
                                    if (_e3460 > _e3463) {
                                        phi_5509_ = _e3460;
                                    } else {
                                        phi_5509_ = _e3463;
                                    }
                                    let _e3466 = phi_5509_;
                                    if (_e3457 > _e3466) {
                                        phi_5514_ = _e3457;
                                    } else {
                                        phi_5514_ = _e3466;
                                    }
                                    let _e3469 = phi_5514_;
                                    if (_e3375 < 0f) {
                                        phi_5520_ = -(_e3375);
                                    } else {
                                        phi_5520_ = _e3375;
                                    }
                                    let _e3473 = phi_5520_;
                                    if (_e3378 < 0f) {
                                        phi_5526_ = -(_e3378);
                                    } else {
                                        phi_5526_ = _e3378;
                                    }
                                    let _e3477 = phi_5526_;
                                    if (_e3381 < 0f) {
                                        phi_5533_ = -(_e3381);
                                    } else {
                                        phi_5533_ = _e3381;
                                    }
                                    let _e3482 = phi_5533_;
                                    let _e3483 = ((_e3473 + _e3477) + _e3482);
                                    let _e3488 = -(_e3469);
                                    if (_e3448 > _e3488) {
                                        phi_5544_ = _e3448;
                                    } else {
                                        phi_5544_ = _e3488;
                                    }
                                    let _e3491 = phi_5544_;
                                    let _e3496 = (((_e3491 - ((_e3483 * _e3110) * (0.000000059604645f * (17f / 2f)))) - (_e3483 * _e3117)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3368 > _e3496) {
                                        phi_5554_ = _e3368;
                                    } else {
                                        phi_5554_ = _e3496;
                                    }
                                    let _e3499 = phi_5554_;
                                    phi_5555_ = _e3499;
                                } else {
                                    phi_5555_ = _e3368;
                                }
                                let _e3501 = phi_5555_;
                                phi_5558_ = (_e2842 || (_e3501 > 0f));
                            }
                            let _e3505 = phi_5558_;
                            if _e3505 {
                                let _e3508 = local_1.member_1[0u];
                                let _e3514 = local_1.member_2[0u];
                                let _e3520 = ((_e3508[1] * _e3514[2]) - (_e3508[2] * _e3514[1]));
                                let _e3523 = ((_e3508[2] * _e3514[0]) - (_e3508[0] * _e3514[2]));
                                let _e3526 = ((_e3508[0] * _e3514[1]) - (_e3508[1] * _e3514[0]));
                                let _e3529 = local_1.member_1[1u];
                                let _e3535 = local_1.member_2[1u];
                                let _e3541 = ((_e3529[1] * _e3535[2]) - (_e3529[2] * _e3535[1]));
                                let _e3544 = ((_e3529[2] * _e3535[0]) - (_e3529[0] * _e3535[2]));
                                let _e3547 = ((_e3529[0] * _e3535[1]) - (_e3529[1] * _e3535[0]));
                                let _e3550 = local_1.member_1[0u];
                                let _e3556 = local_1.member_2[1u];
                                let _e3571 = local_1.member_1[1u];
                                let _e3577 = local_1.member_2[0u];
                                let _e3590 = (((_e3550[1] * _e3556[2]) - (_e3550[2] * _e3556[1])) + ((_e3571[1] * _e3577[2]) - (_e3571[2] * _e3577[1])));
                                let _e3591 = (((_e3550[2] * _e3556[0]) - (_e3550[0] * _e3556[2])) + ((_e3571[2] * _e3577[0]) - (_e3571[0] * _e3577[2])));
                                let _e3592 = (((_e3550[0] * _e3556[1]) - (_e3550[1] * _e3556[0])) + ((_e3571[0] * _e3577[1]) - (_e3571[1] * _e3577[0])));
                                let _e3595 = local_1.member[0u];
                                let _e3606 = local_1.member[1u];
                                let _e3617 = local_1.member[0u];
                                let _e3626 = ((((_e3606[0] * _e3520) + (_e3606[1] * _e3523)) + (_e3606[2] * _e3526)) + (((_e3617[0] * _e3590) + (_e3617[1] * _e3591)) + (_e3617[2] * _e3592)));
                                let _e3629 = local_1.member[0u];
                                let _e3640 = local_1.member[1u];
                                let _e3649 = ((((_e3629[0] * _e3541) + (_e3629[1] * _e3544)) + (_e3629[2] * _e3547)) + (((_e3640[0] * _e3590) + (_e3640[1] * _e3591)) + (_e3640[2] * _e3592)));
                                let _e3652 = local_1.member[1u];
                                let _e3663 = local_1.member[0u];
                                if (_e3663[0] < 0f) {
                                    phi_5803_ = -(_e3663[0]);
                                } else {
                                    phi_5803_ = _e3663[0];
                                }
                                let _e3670 = phi_5803_;
                                if (_e3663[1] < 0f) {
                                    phi_5810_ = -(_e3663[1]);
                                } else {
                                    phi_5810_ = _e3663[1];
                                }
                                let _e3674 = phi_5810_;
                                if (_e3670 > _e3674) {
                                    phi_5815_ = _e3670;
                                } else {
                                    phi_5815_ = _e3674;
                                }
                                let _e3677 = phi_5815_;
                                if (_e3663[2] < 0f) {
                                    phi_5822_ = -(_e3663[2]);
                                } else {
                                    phi_5822_ = _e3663[2];
                                }
                                let _e3681 = phi_5822_;
                                if (_e3677 > _e3681) {
                                    phi_5827_ = _e3677;
                                } else {
                                    phi_5827_ = _e3681;
                                }
                                let _e3684 = phi_5827_;
                                let _e3687 = local_1.member[1u];
                                if (_e3687[0] < 0f) {
                                    phi_5840_ = -(_e3687[0]);
                                } else {
                                    phi_5840_ = _e3687[0];
                                }
                                let _e3694 = phi_5840_;
                                if (_e3687[1] < 0f) {
                                    phi_5847_ = -(_e3687[1]);
                                } else {
                                    phi_5847_ = _e3687[1];
                                }
                                let _e3698 = phi_5847_;
                                if (_e3694 > _e3698) {
                                    phi_5852_ = _e3694;
                                } else {
                                    phi_5852_ = _e3698;
                                }
                                let _e3701 = phi_5852_;
                                if (_e3687[2] < 0f) {
                                    phi_5859_ = -(_e3687[2]);
                                } else {
                                    phi_5859_ = _e3687[2];
                                }
                                let _e3705 = phi_5859_;
                                if (_e3701 > _e3705) {
                                    phi_5864_ = _e3701;
                                } else {
                                    phi_5864_ = _e3705;
                                }
                                let _e3708 = phi_5864_;
                                if (_e3684 > _e3708) {
                                    phi_5869_ = _e3684;
                                } else {
                                    phi_5869_ = _e3708;
                                }
                                let _e3711 = phi_5869_;
                                let _e3713 = local_1.member_3;
                                let _e3714 = (_e3711 + _e3713);
                                let _e3717 = local_1.member_1[0u];
                                if (_e3717[0] < 0f) {
                                    phi_5886_ = -(_e3717[0]);
                                } else {
                                    phi_5886_ = _e3717[0];
                                }
                                let _e3724 = phi_5886_;
                                if (_e3717[1] < 0f) {
                                    phi_5893_ = -(_e3717[1]);
                                } else {
                                    phi_5893_ = _e3717[1];
                                }
                                let _e3728 = phi_5893_;
                                if (_e3724 > _e3728) {
                                    phi_5898_ = _e3724;
                                } else {
                                    phi_5898_ = _e3728;
                                }
                                let _e3731 = phi_5898_;
                                if (_e3717[2] < 0f) {
                                    phi_5905_ = -(_e3717[2]);
                                } else {
                                    phi_5905_ = _e3717[2];
                                }
                                let _e3735 = phi_5905_;
                                if (_e3731 > _e3735) {
                                    phi_5910_ = _e3731;
                                } else {
                                    phi_5910_ = _e3735;
                                }
                                let _e3738 = phi_5910_;
                                let _e3741 = local_1.member_1[1u];
                                if (_e3741[0] < 0f) {
                                    phi_5924_ = -(_e3741[0]);
                                } else {
                                    phi_5924_ = _e3741[0];
                                }
                                let _e3748 = phi_5924_;
                                if (_e3741[1] < 0f) {
                                    phi_5931_ = -(_e3741[1]);
                                } else {
                                    phi_5931_ = _e3741[1];
                                }
                                let _e3752 = phi_5931_;
                                if (_e3748 > _e3752) {
                                    phi_5936_ = _e3748;
                                } else {
                                    phi_5936_ = _e3752;
                                }
                                let _e3755 = phi_5936_;
                                if (_e3741[2] < 0f) {
                                    phi_5943_ = -(_e3741[2]);
                                } else {
                                    phi_5943_ = _e3741[2];
                                }
                                let _e3759 = phi_5943_;
                                if (_e3755 > _e3759) {
                                    phi_5948_ = _e3755;
                                } else {
                                    phi_5948_ = _e3759;
                                }
                                let _e3762 = phi_5948_;
                                if (_e3738 > _e3762) {
                                    phi_5953_ = _e3738;
                                } else {
                                    phi_5953_ = _e3762;
                                }
                                let _e3765 = phi_5953_;
                                let _e3767 = local_1.member_3;
                                let _e3768 = (_e3765 + _e3767);
                                let _e3771 = local_1.member_2[0u];
                                if (_e3771[0] < 0f) {
                                    phi_5970_ = -(_e3771[0]);
                                } else {
                                    phi_5970_ = _e3771[0];
                                }
                                let _e3778 = phi_5970_;
                                if (_e3771[1] < 0f) {
                                    phi_5977_ = -(_e3771[1]);
                                } else {
                                    phi_5977_ = _e3771[1];
                                }
                                let _e3782 = phi_5977_;
                                if (_e3778 > _e3782) {
                                    phi_5982_ = _e3778;
                                } else {
                                    phi_5982_ = _e3782;
                                }
                                let _e3785 = phi_5982_;
                                if (_e3771[2] < 0f) {
                                    phi_5989_ = -(_e3771[2]);
                                } else {
                                    phi_5989_ = _e3771[2];
                                }
                                let _e3789 = phi_5989_;
                                if (_e3785 > _e3789) {
                                    phi_5994_ = _e3785;
                                } else {
                                    phi_5994_ = _e3789;
                                }
                                let _e3792 = phi_5994_;
                                let _e3795 = local_1.member_2[1u];
                                if (_e3795[0] < 0f) {
                                    phi_6008_ = -(_e3795[0]);
                                } else {
                                    phi_6008_ = _e3795[0];
                                }
                                let _e3802 = phi_6008_;
                                if (_e3795[1] < 0f) {
                                    phi_6015_ = -(_e3795[1]);
                                } else {
                                    phi_6015_ = _e3795[1];
                                }
                                let _e3806 = phi_6015_;
                                if (_e3802 > _e3806) {
                                    phi_6020_ = _e3802;
                                } else {
                                    phi_6020_ = _e3806;
                                }
                                let _e3809 = phi_6020_;
                                if (_e3795[2] < 0f) {
                                    phi_6027_ = -(_e3795[2]);
                                } else {
                                    phi_6027_ = _e3795[2];
                                }
                                let _e3813 = phi_6027_;
                                if (_e3809 > _e3813) {
                                    phi_6032_ = _e3809;
                                } else {
                                    phi_6032_ = _e3813;
                                }
                                let _e3816 = phi_6032_;
                                if (_e3792 > _e3816) {
                                    phi_6037_ = _e3792;
                                } else {
                                    phi_6037_ = _e3816;
                                }
                                let _e3819 = phi_6037_;
                                let _e3821 = local_1.member_3;
                                let _e3822 = (_e3819 + _e3821);
                                let _e3824 = ((_e3768 * 8f) * _e3822);
                                let _e3831 = local_1.member_3;
                                if (_e3520 < 0f) {
                                    phi_6068_ = -(_e3520);
                                } else {
                                    phi_6068_ = _e3520;
                                }
                                let _e3848 = phi_6068_;
                                if (_e3523 < 0f) {
                                    phi_6074_ = -(_e3523);
                                } else {
                                    phi_6074_ = _e3523;
                                }
                                let _e3852 = phi_6074_;
                                if (_e3526 < 0f) {
                                    phi_6081_ = -(_e3526);
                                } else {
                                    phi_6081_ = _e3526;
                                }
                                let _e3857 = phi_6081_;
                                let _e3858 = ((_e3848 + _e3852) + _e3857);
                                if (_e3541 < 0f) {
                                    phi_6088_ = -(_e3541);
                                } else {
                                    phi_6088_ = _e3541;
                                }
                                let _e3862 = phi_6088_;
                                if (_e3544 < 0f) {
                                    phi_6094_ = -(_e3544);
                                } else {
                                    phi_6094_ = _e3544;
                                }
                                let _e3866 = phi_6094_;
                                if (_e3547 < 0f) {
                                    phi_6101_ = -(_e3547);
                                } else {
                                    phi_6101_ = _e3547;
                                }
                                let _e3871 = phi_6101_;
                                let _e3872 = ((_e3862 + _e3866) + _e3871);
                                if (_e3858 > _e3872) {
                                    phi_6107_ = _e3858;
                                } else {
                                    phi_6107_ = _e3872;
                                }
                                let _e3875 = phi_6107_;
                                if (_e3590 < 0f) {
                                    phi_6113_ = -(_e3590);
                                } else {
                                    phi_6113_ = _e3590;
                                }
                                let _e3879 = phi_6113_;
                                if (_e3591 < 0f) {
                                    phi_6119_ = -(_e3591);
                                } else {
                                    phi_6119_ = _e3591;
                                }
                                let _e3883 = phi_6119_;
                                if (_e3592 < 0f) {
                                    phi_6126_ = -(_e3592);
                                } else {
                                    phi_6126_ = _e3592;
                                }
                                let _e3888 = phi_6126_;
                                let _e3890 = (((_e3879 + _e3883) + _e3888) * 0.5f);
                                if (_e3875 > _e3890) {
                                    phi_6133_ = _e3875;
                                } else {
                                    phi_6133_ = _e3890;
                                }
                                let _e3893 = phi_6133_;
                                let _e3898 = local_1.member_3;
                                let _e3911 = ((((_e3595[0] * _e3520) + (_e3595[1] * _e3523)) + (_e3595[2] * _e3526)) * 3f);
                                let _e3912 = ((((_e3652[0] * _e3541) + (_e3652[1] * _e3544)) + (_e3652[2] * _e3547)) * 3f);
                                if (_e3911 < _e3912) {
                                    phi_6157_ = _e3911;
                                } else {
                                    phi_6157_ = _e3912;
                                }
                                let _e3915 = phi_6157_;
                                if (_e3626 < _e3649) {
                                    phi_6162_ = _e3626;
                                } else {
                                    phi_6162_ = _e3649;
                                }
                                let _e3918 = phi_6162_;
                                if (_e3915 < _e3918) {
                                    phi_6167_ = _e3915;
                                } else {
                                    phi_6167_ = _e3918;
                                }
                                let _e3921 = phi_6167_;
                                if (_e3911 > _e3912) {
                                    phi_6172_ = _e3911;
                                } else {
                                    phi_6172_ = _e3912;
                                }
                                let _e3924 = phi_6172_;
                                if (_e3626 > _e3649) {
                                    phi_6177_ = _e3626;
                                } else {
                                    phi_6177_ = _e3649;
                                }
                                let _e3927 = phi_6177_;
                                if (_e3924 > _e3927) {
                                    phi_6182_ = _e3924;
                                } else {
                                    phi_6182_ = _e3927;
                                }
                                let _e3930 = phi_6182_;
                                let _e3935 = -(_e3930);
                                if (_e3921 > _e3935) {
                                    phi_6192_ = _e3921;
                                } else {
                                    phi_6192_ = _e3935;
                                }
                                let _e3938 = phi_6192_;
                                let _e3940 = ((_e3938 - ((((((_e3714 * 8f) * _e3824) * (0.000000059604645f * (524f / 64f))) + ((_e3831 * 19f) * ((_e3714 * (_e3768 + _e3822)) + (_e3768 * _e3822)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3714) * ((1f + _e3768) * (1f + _e3822))))) + ((_e815 * (((_e3893 + (_e3824 * (0.000000059604645f * 8f))) + ((_e3898 * 6f) * (_e3768 + _e3822))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3768) * (1f + _e3822))))) * (3f * 1.0001f)))) > 0f);
                                if _e3940 {
                                    phi_7161_ = _e3940;
                                } else {
                                    let _e3943 = local_1.member_1[0u];
                                    let _e3949 = local_1.member_1[1u];
                                    let _e3953 = (_e3943[0] + _e3949[0]);
                                    let _e3954 = (_e3943[1] + _e3949[1]);
                                    let _e3955 = (_e3943[2] + _e3949[2]);
                                    let _e3958 = local_1.member_2[0u];
                                    let _e3964 = local_1.member_2[1u];
                                    let _e3968 = (_e3958[0] + _e3964[0]);
                                    let _e3969 = (_e3958[1] + _e3964[1]);
                                    let _e3970 = (_e3958[2] + _e3964[2]);
                                    let _e3973 = ((_e3954 * _e3970) - (_e3955 * _e3969));
                                    let _e3976 = ((_e3955 * _e3968) - (_e3953 * _e3970));
                                    let _e3979 = ((_e3953 * _e3969) - (_e3954 * _e3968));
                                    let _e3982 = local_1.member[0u];
                                    let _e3989 = local_1.member_1[0u];
                                    let _e3995 = local_1.member_2[0u];
                                    let _e3999 = (_e3982[0] - _e3989[0]);
                                    let _e4000 = (_e3982[1] - _e3989[1]);
                                    let _e4001 = (_e3982[2] - _e3989[2]);
                                    if (_e179.member == 0u) {
                                        phi_6308_ = array<f32, 3>(_e3982[0], _e3982[1], _e3982[2]);
                                    } else {
                                        phi_6308_ = array<f32, 3>((_e3999 - _e3995[0]), (_e4000 - _e3995[1]), (_e4001 - _e3995[2]));
                                    }
                                    let _e4008 = phi_6308_;
                                    let _e4009 = (_e3982[0] - _e3995[0]);
                                    let _e4010 = (_e3982[1] - _e3995[1]);
                                    let _e4011 = (_e3982[2] - _e3995[2]);
                                    let _e4014 = local_1.member[1u];
                                    let _e4021 = local_1.member_1[1u];
                                    let _e4027 = local_1.member_2[1u];
                                    let _e4031 = (_e4014[0] - _e4021[0]);
                                    let _e4032 = (_e4014[1] - _e4021[1]);
                                    let _e4033 = (_e4014[2] - _e4021[2]);
                                    if (_e179.member == 0u) {
                                        phi_6373_ = array<f32, 3>(_e4014[0], _e4014[1], _e4014[2]);
                                    } else {
                                        phi_6373_ = array<f32, 3>((_e4031 - _e4027[0]), (_e4032 - _e4027[1]), (_e4033 - _e4027[2]));
                                    }
                                    let _e4040 = phi_6373_;
                                    let _e4041 = (_e4014[0] - _e4027[0]);
                                    let _e4042 = (_e4014[1] - _e4027[1]);
                                    let _e4043 = (_e4014[2] - _e4027[2]);
                                    let _e4046 = local_1.member[0u];
                                    if (_e4046[0] < 0f) {
                                        phi_6395_ = -(_e4046[0]);
                                    } else {
                                        phi_6395_ = _e4046[0];
                                    }
                                    let _e4053 = phi_6395_;
                                    if (_e4046[1] < 0f) {
                                        phi_6402_ = -(_e4046[1]);
                                    } else {
                                        phi_6402_ = _e4046[1];
                                    }
                                    let _e4057 = phi_6402_;
                                    if (_e4053 > _e4057) {
                                        phi_6407_ = _e4053;
                                    } else {
                                        phi_6407_ = _e4057;
                                    }
                                    let _e4060 = phi_6407_;
                                    if (_e4046[2] < 0f) {
                                        phi_6414_ = -(_e4046[2]);
                                    } else {
                                        phi_6414_ = _e4046[2];
                                    }
                                    let _e4064 = phi_6414_;
                                    if (_e4060 > _e4064) {
                                        phi_6419_ = _e4060;
                                    } else {
                                        phi_6419_ = _e4064;
                                    }
                                    let _e4067 = phi_6419_;
                                    let _e4070 = local_1.member[1u];
                                    if (_e4070[0] < 0f) {
                                        phi_6432_ = -(_e4070[0]);
                                    } else {
                                        phi_6432_ = _e4070[0];
                                    }
                                    let _e4077 = phi_6432_;
                                    if (_e4070[1] < 0f) {
                                        phi_6439_ = -(_e4070[1]);
                                    } else {
                                        phi_6439_ = _e4070[1];
                                    }
                                    let _e4081 = phi_6439_;
                                    if (_e4077 > _e4081) {
                                        phi_6444_ = _e4077;
                                    } else {
                                        phi_6444_ = _e4081;
                                    }
                                    let _e4084 = phi_6444_;
                                    if (_e4070[2] < 0f) {
                                        phi_6451_ = -(_e4070[2]);
                                    } else {
                                        phi_6451_ = _e4070[2];
                                    }
                                    let _e4088 = phi_6451_;
                                    if (_e4084 > _e4088) {
                                        phi_6456_ = _e4084;
                                    } else {
                                        phi_6456_ = _e4088;
                                    }
                                    let _e4091 = phi_6456_;
                                    if (_e4067 > _e4091) {
                                        phi_6461_ = _e4067;
                                    } else {
                                        phi_6461_ = _e4091;
                                    }
                                    let _e4094 = phi_6461_;
                                    let _e4096 = local_1.member_3;
                                    let _e4100 = local_1.member_1[0u];
                                    if (_e4100[0] < 0f) {
                                        phi_6478_ = -(_e4100[0]);
                                    } else {
                                        phi_6478_ = _e4100[0];
                                    }
                                    let _e4107 = phi_6478_;
                                    if (_e4100[1] < 0f) {
                                        phi_6485_ = -(_e4100[1]);
                                    } else {
                                        phi_6485_ = _e4100[1];
                                    }
                                    let _e4111 = phi_6485_;
                                    if (_e4107 > _e4111) {
                                        phi_6490_ = _e4107;
                                    } else {
                                        phi_6490_ = _e4111;
                                    }
                                    let _e4114 = phi_6490_;
                                    if (_e4100[2] < 0f) {
                                        phi_6497_ = -(_e4100[2]);
                                    } else {
                                        phi_6497_ = _e4100[2];
                                    }
                                    let _e4118 = phi_6497_;
                                    if (_e4114 > _e4118) {
                                        phi_6502_ = _e4114;
                                    } else {
                                        phi_6502_ = _e4118;
                                    }
                                    let _e4121 = phi_6502_;
                                    let _e4124 = local_1.member_1[1u];
                                    if (_e4124[0] < 0f) {
                                        phi_6516_ = -(_e4124[0]);
                                    } else {
                                        phi_6516_ = _e4124[0];
                                    }
                                    let _e4131 = phi_6516_;
                                    if (_e4124[1] < 0f) {
                                        phi_6523_ = -(_e4124[1]);
                                    } else {
                                        phi_6523_ = _e4124[1];
                                    }
                                    let _e4135 = phi_6523_;
                                    if (_e4131 > _e4135) {
                                        phi_6528_ = _e4131;
                                    } else {
                                        phi_6528_ = _e4135;
                                    }
                                    let _e4138 = phi_6528_;
                                    if (_e4124[2] < 0f) {
                                        phi_6535_ = -(_e4124[2]);
                                    } else {
                                        phi_6535_ = _e4124[2];
                                    }
                                    let _e4142 = phi_6535_;
                                    if (_e4138 > _e4142) {
                                        phi_6540_ = _e4138;
                                    } else {
                                        phi_6540_ = _e4142;
                                    }
                                    let _e4145 = phi_6540_;
                                    if (_e4121 > _e4145) {
                                        phi_6545_ = _e4121;
                                    } else {
                                        phi_6545_ = _e4145;
                                    }
                                    let _e4148 = phi_6545_;
                                    let _e4150 = local_1.member_3;
                                    let _e4154 = local_1.member_2[0u];
                                    if (_e4154[0] < 0f) {
                                        phi_6562_ = -(_e4154[0]);
                                    } else {
                                        phi_6562_ = _e4154[0];
                                    }
                                    let _e4161 = phi_6562_;
                                    if (_e4154[1] < 0f) {
                                        phi_6569_ = -(_e4154[1]);
                                    } else {
                                        phi_6569_ = _e4154[1];
                                    }
                                    let _e4165 = phi_6569_;
                                    if (_e4161 > _e4165) {
                                        phi_6574_ = _e4161;
                                    } else {
                                        phi_6574_ = _e4165;
                                    }
                                    let _e4168 = phi_6574_;
                                    if (_e4154[2] < 0f) {
                                        phi_6581_ = -(_e4154[2]);
                                    } else {
                                        phi_6581_ = _e4154[2];
                                    }
                                    let _e4172 = phi_6581_;
                                    if (_e4168 > _e4172) {
                                        phi_6586_ = _e4168;
                                    } else {
                                        phi_6586_ = _e4172;
                                    }
                                    let _e4175 = phi_6586_;
                                    let _e4178 = local_1.member_2[1u];
                                    if (_e4178[0] < 0f) {
                                        phi_6600_ = -(_e4178[0]);
                                    } else {
                                        phi_6600_ = _e4178[0];
                                    }
                                    let _e4185 = phi_6600_;
                                    if (_e4178[1] < 0f) {
                                        phi_6607_ = -(_e4178[1]);
                                    } else {
                                        phi_6607_ = _e4178[1];
                                    }
                                    let _e4189 = phi_6607_;
                                    if (_e4185 > _e4189) {
                                        phi_6612_ = _e4185;
                                    } else {
                                        phi_6612_ = _e4189;
                                    }
                                    let _e4192 = phi_6612_;
                                    if (_e4178[2] < 0f) {
                                        phi_6619_ = -(_e4178[2]);
                                    } else {
                                        phi_6619_ = _e4178[2];
                                    }
                                    let _e4196 = phi_6619_;
                                    if (_e4192 > _e4196) {
                                        phi_6624_ = _e4192;
                                    } else {
                                        phi_6624_ = _e4196;
                                    }
                                    let _e4199 = phi_6624_;
                                    if (_e4175 > _e4199) {
                                        phi_6629_ = _e4175;
                                    } else {
                                        phi_6629_ = _e4199;
                                    }
                                    let _e4202 = phi_6629_;
                                    let _e4204 = local_1.member_3;
                                    let _e4208 = ((((_e4094 + _e4096) + (_e4148 + _e4150)) + (_e4202 + _e4204)) * 2f);
                                    let _e4211 = local_1.member_3;
                                    let _e4215 = (((_e815 * 1.0001f) + (_e4211 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e4218 = ((_e3976 * _e3955) - (_e3979 * _e3954));
                                    let _e4221 = ((_e3979 * _e3953) - (_e3973 * _e3955));
                                    let _e4224 = ((_e3973 * _e3954) - (_e3976 * _e3953));
                                    let _e4229 = (((_e4218 * _e3982[0]) + (_e4221 * _e3982[1])) + (_e4224 * _e3982[2]));
                                    let _e4234 = (((_e4218 * _e3999) + (_e4221 * _e4000)) + (_e4224 * _e4001));
                                    let _e4239 = (((_e4218 * _e4009) + (_e4221 * _e4010)) + (_e4224 * _e4011));
                                    let _e4247 = (((_e4218 * _e4008[0]) + (_e4221 * _e4008[1])) + (_e4224 * _e4008[2]));
                                    let _e4252 = (((_e4218 * _e4014[0]) + (_e4221 * _e4014[1])) + (_e4224 * _e4014[2]));
                                    let _e4257 = (((_e4218 * _e4031) + (_e4221 * _e4032)) + (_e4224 * _e4033));
                                    let _e4262 = (((_e4218 * _e4041) + (_e4221 * _e4042)) + (_e4224 * _e4043));
                                    let _e4270 = (((_e4218 * _e4040[0]) + (_e4221 * _e4040[1])) + (_e4224 * _e4040[2]));
                                    if (_e4229 < _e4234) {
                                        phi_6708_ = _e4229;
                                    } else {
                                        phi_6708_ = _e4234;
                                    }
                                    let _e4273 = phi_6708_;
                                    if (_e4239 < _e4247) {
                                        phi_6713_ = _e4239;
                                    } else {
                                        phi_6713_ = _e4247;
                                    }
                                    let _e4276 = phi_6713_;
                                    if (_e4273 < _e4276) {
                                        phi_6718_ = _e4273;
                                    } else {
                                        phi_6718_ = _e4276;
                                    }
                                    let _e4279 = phi_6718_;
                                    if (_e4252 < _e4257) {
                                        phi_6723_ = _e4252;
                                    } else {
                                        phi_6723_ = _e4257;
                                    }
                                    let _e4282 = phi_6723_;
                                    if (_e4262 < _e4270) {
                                        phi_6728_ = _e4262;
                                    } else {
                                        phi_6728_ = _e4270;
                                    }
                                    let _e4285 = phi_6728_;
                                    if (_e4282 < _e4285) {
                                        phi_6733_ = _e4282;
                                    } else {
                                        phi_6733_ = _e4285;
                                    }
                                    let _e4288 = phi_6733_;
                                    if (_e4279 < _e4288) {
                                        phi_6738_ = _e4279;
                                    } else {
                                        phi_6738_ = _e4288;
                                    }
                                    let _e4291 = phi_6738_;
                                    if (_e4229 > _e4234) {
                                        phi_6743_ = _e4229;
                                    } else {
                                        phi_6743_ = _e4234;
                                    }
                                    let _e4294 = phi_6743_;
                                    if (_e4239 > _e4247) {
                                        phi_6748_ = _e4239;
                                    } else {
                                        phi_6748_ = _e4247;
                                    }
                                    let _e4297 = phi_6748_;
                                    if (_e4294 > _e4297) {
                                        phi_6753_ = _e4294;
                                    } else {
                                        phi_6753_ = _e4297;
                                    }
                                    let _e4300 = phi_6753_;
                                    if (_e4252 > _e4257) {
                                        phi_6758_ = _e4252;
                                    } else {
                                        phi_6758_ = _e4257;
                                    }
                                    let _e4303 = phi_6758_;
                                    if (_e4262 > _e4270) {
                                        phi_6763_ = _e4262;
                                    } else {
                                        phi_6763_ = _e4270;
                                    }
                                    let _e4306 = phi_6763_;
                                    if (_e4303 > _e4306) {
                                        phi_6768_ = _e4303;
                                    } else {
                                        phi_6768_ = _e4306;
                                    }
                                    let _e4309 = phi_6768_;
                                    if (_e4300 > _e4309) {
                                        phi_6773_ = _e4300;
                                    } else {
                                        phi_6773_ = _e4309;
                                    }
                                    let _e4312 = phi_6773_;
                                    if (_e4218 < 0f) {
                                        phi_6779_ = -(_e4218);
                                    } else {
                                        phi_6779_ = _e4218;
                                    }
                                    let _e4316 = phi_6779_;
                                    if (_e4221 < 0f) {
                                        phi_6785_ = -(_e4221);
                                    } else {
                                        phi_6785_ = _e4221;
                                    }
                                    let _e4320 = phi_6785_;
                                    if (_e4224 < 0f) {
                                        phi_6792_ = -(_e4224);
                                    } else {
                                        phi_6792_ = _e4224;
                                    }
                                    let _e4325 = phi_6792_;
                                    let _e4326 = ((_e4316 + _e4320) + _e4325);
                                    let _e4331 = -(_e4312);
                                    if (_e4291 > _e4331) {
                                        phi_6803_ = _e4291;
                                    } else {
                                        phi_6803_ = _e4331;
                                    }
                                    let _e4334 = phi_6803_;
                                    let _e4339 = (((_e4334 - ((_e4326 * _e4208) * (0.000000059604645f * (17f / 2f)))) - (_e4326 * _e4215)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e4342 = ((_e3976 * _e3970) - (_e3979 * _e3969));
                                    let _e4345 = ((_e3979 * _e3968) - (_e3973 * _e3970));
                                    let _e4348 = ((_e3973 * _e3969) - (_e3976 * _e3968));
                                    let _e4353 = (((_e4342 * _e3982[0]) + (_e4345 * _e3982[1])) + (_e4348 * _e3982[2]));
                                    let _e4358 = (((_e4342 * _e3999) + (_e4345 * _e4000)) + (_e4348 * _e4001));
                                    let _e4363 = (((_e4342 * _e4009) + (_e4345 * _e4010)) + (_e4348 * _e4011));
                                    let _e4371 = (((_e4342 * _e4008[0]) + (_e4345 * _e4008[1])) + (_e4348 * _e4008[2]));
                                    let _e4376 = (((_e4342 * _e4014[0]) + (_e4345 * _e4014[1])) + (_e4348 * _e4014[2]));
                                    let _e4381 = (((_e4342 * _e4031) + (_e4345 * _e4032)) + (_e4348 * _e4033));
                                    let _e4386 = (((_e4342 * _e4041) + (_e4345 * _e4042)) + (_e4348 * _e4043));
                                    let _e4394 = (((_e4342 * _e4040[0]) + (_e4345 * _e4040[1])) + (_e4348 * _e4040[2]));
                                    if (_e4353 < _e4358) {
                                        phi_6874_ = _e4353;
                                    } else {
                                        phi_6874_ = _e4358;
                                    }
                                    let _e4397 = phi_6874_;
                                    if (_e4363 < _e4371) {
                                        phi_6879_ = _e4363;
                                    } else {
                                        phi_6879_ = _e4371;
                                    }
                                    let _e4400 = phi_6879_;
                                    if (_e4397 < _e4400) {
                                        phi_6884_ = _e4397;
                                    } else {
                                        phi_6884_ = _e4400;
                                    }
                                    let _e4403 = phi_6884_;
                                    if (_e4376 < _e4381) {
                                        phi_6889_ = _e4376;
                                    } else {
                                        phi_6889_ = _e4381;
                                    }
                                    let _e4406 = phi_6889_;
                                    if (_e4386 < _e4394) {
                                        phi_6894_ = _e4386;
                                    } else {
                                        phi_6894_ = _e4394;
                                    }
                                    let _e4409 = phi_6894_;
                                    if (_e4406 < _e4409) {
                                        phi_6899_ = _e4406;
                                    } else {
                                        phi_6899_ = _e4409;
                                    }
                                    let _e4412 = phi_6899_;
                                    if (_e4403 < _e4412) {
                                        phi_6904_ = _e4403;
                                    } else {
                                        phi_6904_ = _e4412;
                                    }
                                    let _e4415 = phi_6904_;
                                    if (_e4353 > _e4358) {
                                        phi_6909_ = _e4353;
                                    } else {
                                        phi_6909_ = _e4358;
                                    }
                                    let _e4418 = phi_6909_;
                                    if (_e4363 > _e4371) {
                                        phi_6914_ = _e4363;
                                    } else {
                                        phi_6914_ = _e4371;
                                    }
                                    let _e4421 = phi_6914_;
                                    if (_e4418 > _e4421) {
                                        phi_6919_ = _e4418;
                                    } else {
                                        phi_6919_ = _e4421;
                                    }
                                    let _e4424 = phi_6919_;
                                    if (_e4376 > _e4381) {
                                        phi_6924_ = _e4376;
                                    } else {
                                        phi_6924_ = _e4381;
                                    }
                                    let _e4427 = phi_6924_;
                                    if (_e4386 > _e4394) {
                                        phi_6929_ = _e4386;
                                    } else {
                                        phi_6929_ = _e4394;
                                    }
                                    let _e4430 = phi_6929_;
                                    if (_e4427 > _e4430) {
                                        phi_6934_ = _e4427;
                                    } else {
                                        phi_6934_ = _e4430;
                                    }
                                    let _e4433 = phi_6934_;
                                    if (_e4424 > _e4433) {
                                        phi_6939_ = _e4424;
                                    } else {
                                        phi_6939_ = _e4433;
                                    }
                                    let _e4436 = phi_6939_;
                                    if (_e4342 < 0f) {
                                        phi_6945_ = -(_e4342);
                                    } else {
                                        phi_6945_ = _e4342;
                                    }
                                    let _e4440 = phi_6945_;
                                    if (_e4345 < 0f) {
                                        phi_6951_ = -(_e4345);
                                    } else {
                                        phi_6951_ = _e4345;
                                    }
                                    let _e4444 = phi_6951_;
                                    if (_e4348 < 0f) {
                                        phi_6958_ = -(_e4348);
                                    } else {
                                        phi_6958_ = _e4348;
                                    }
                                    let _e4449 = phi_6958_;
                                    let _e4450 = ((_e4440 + _e4444) + _e4449);
                                    let _e4455 = -(_e4436);
                                    if (_e4415 > _e4455) {
                                        phi_6969_ = _e4415;
                                    } else {
                                        phi_6969_ = _e4455;
                                    }
                                    let _e4458 = phi_6969_;
                                    let _e4463 = (((_e4458 - ((_e4450 * _e4208) * (0.000000059604645f * (17f / 2f)))) - (_e4450 * _e4215)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4339 > _e4463) {
                                        phi_6979_ = _e4339;
                                    } else {
                                        phi_6979_ = _e4463;
                                    }
                                    let _e4466 = phi_6979_;
                                    if (_e179.member == 0u) {
                                        let _e4468 = (_e3968 - _e3953);
                                        let _e4469 = (_e3969 - _e3954);
                                        let _e4470 = (_e3970 - _e3955);
                                        let _e4473 = ((_e3976 * _e4470) - (_e3979 * _e4469));
                                        let _e4476 = ((_e3979 * _e4468) - (_e3973 * _e4470));
                                        let _e4479 = ((_e3973 * _e4469) - (_e3976 * _e4468));
                                        let _e4484 = (((_e4473 * _e3982[0]) + (_e4476 * _e3982[1])) + (_e4479 * _e3982[2]));
                                        let _e4489 = (((_e4473 * _e3999) + (_e4476 * _e4000)) + (_e4479 * _e4001));
                                        let _e4494 = (((_e4473 * _e4009) + (_e4476 * _e4010)) + (_e4479 * _e4011));
                                        let _e4502 = (((_e4473 * _e4008[0]) + (_e4476 * _e4008[1])) + (_e4479 * _e4008[2]));
                                        let _e4507 = (((_e4473 * _e4014[0]) + (_e4476 * _e4014[1])) + (_e4479 * _e4014[2]));
                                        let _e4512 = (((_e4473 * _e4031) + (_e4476 * _e4032)) + (_e4479 * _e4033));
                                        let _e4517 = (((_e4473 * _e4041) + (_e4476 * _e4042)) + (_e4479 * _e4043));
                                        let _e4525 = (((_e4473 * _e4040[0]) + (_e4476 * _e4040[1])) + (_e4479 * _e4040[2]));
                                        if (_e4484 < _e4489) {
                                            phi_7052_ = _e4484;
                                        } else {
                                            phi_7052_ = _e4489;
                                        }
                                        let _e4528 = phi_7052_;
                                        if (_e4494 < _e4502) {
                                            phi_7057_ = _e4494;
                                        } else {
                                            phi_7057_ = _e4502;
                                        }
                                        let _e4531 = phi_7057_;
                                        if (_e4528 < _e4531) {
                                            phi_7062_ = _e4528;
                                        } else {
                                            phi_7062_ = _e4531;
                                        }
                                        let _e4534 = phi_7062_;
                                        if (_e4507 < _e4512) {
                                            phi_7067_ = _e4507;
                                        } else {
                                            phi_7067_ = _e4512;
                                        }
                                        let _e4537 = phi_7067_;
                                        if (_e4517 < _e4525) {
                                            phi_7072_ = _e4517;
                                        } else {
                                            phi_7072_ = _e4525;
                                        }
                                        let _e4540 = phi_7072_;
                                        if (_e4537 < _e4540) {
                                            phi_7077_ = _e4537;
                                        } else {
                                            phi_7077_ = _e4540;
                                        }
                                        let _e4543 = phi_7077_;
                                        if (_e4534 < _e4543) {
                                            phi_7082_ = _e4534;
                                        } else {
                                            phi_7082_ = _e4543;
                                        }
                                        let _e4546 = phi_7082_;
                                        if (_e4484 > _e4489) {
                                            phi_7087_ = _e4484;
                                        } else {
                                            phi_7087_ = _e4489;
                                        }
                                        let _e4549 = phi_7087_;
                                        if (_e4494 > _e4502) {
                                            phi_7092_ = _e4494;
                                        } else {
                                            phi_7092_ = _e4502;
                                        }
                                        let _e4552 = phi_7092_;
                                        if (_e4549 > _e4552) {
                                            phi_7097_ = _e4549;
                                        } else {
                                            phi_7097_ = _e4552;
                                        }
                                        let _e4555 = phi_7097_;
                                        if (_e4507 > _e4512) {
                                            phi_7102_ = _e4507;
                                        } else {
                                            phi_7102_ = _e4512;
                                        }
                                        let _e4558 = phi_7102_;
                                        if (_e4517 > _e4525) {
                                            phi_7107_ = _e4517;
                                        } else {
                                            phi_7107_ = _e4525;
                                        }
                                        let _e4561 = phi_7107_;
                                        if (_e4558 > _e4561) {
                                            phi_7112_ = _e4558;
                                        } else {
                                            phi_7112_ = _e4561;
                                        }
                                        let _e4564 = phi_7112_;
                                        if (_e4555 > _e4564) {
                                            phi_7117_ = _e4555;
                                        } else {
                                            phi_7117_ = _e4564;
                                        }
                                        let _e4567 = phi_7117_;
                                        if (_e4473 < 0f) {
                                            phi_7123_ = -(_e4473);
                                        } else {
                                            phi_7123_ = _e4473;
                                        }
                                        let _e4571 = phi_7123_;
                                        if (_e4476 < 0f) {
                                            phi_7129_ = -(_e4476);
                                        } else {
                                            phi_7129_ = _e4476;
                                        }
                                        let _e4575 = phi_7129_;
                                        if (_e4479 < 0f) {
                                            phi_7136_ = -(_e4479);
                                        } else {
                                            phi_7136_ = _e4479;
                                        }
                                        let _e4580 = phi_7136_;
                                        let _e4581 = ((_e4571 + _e4575) + _e4580);
                                        let _e4586 = -(_e4567);
                                        if (_e4546 > _e4586) {
                                            phi_7147_ = _e4546;
                                        } else {
                                            phi_7147_ = _e4586;
                                        }
                                        let _e4589 = phi_7147_;
                                        let _e4594 = (((_e4589 - ((_e4581 * _e4208) * (0.000000059604645f * (17f / 2f)))) - (_e4581 * _e4215)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4466 > _e4594) {
                                            phi_7157_ = _e4466;
                                        } else {
                                            phi_7157_ = _e4594;
                                        }
                                        let _e4597 = phi_7157_;
                                        phi_7158_ = _e4597;
                                    } else {
                                        phi_7158_ = _e4466;
                                    }
                                    let _e4599 = phi_7158_;
                                    phi_7161_ = (_e3940 || (_e4599 > 0f));
                                }
                                let _e4603 = phi_7161_;
                                phi_7163_ = (_e3505 && _e4603);
                            } else {
                                phi_7163_ = _e3505;
                            }
                            let _e4606 = phi_7163_;
                            phi_7165_ = (_e2317 || _e4606);
                        }
                        let _e4609 = phi_7165_;
                        phi_7167_ = !(_e4609);
                    } else {
                        phi_7167_ = false;
                    }
                    let _e4612 = phi_7167_;
                    if _e4612 {
                        let _e4614 = atomicAdd((&counters[0u]), 1u);
                        phi_7173_ = _e4614;
                    } else {
                        phi_7173_ = 0u;
                    }
                    let _e4616 = phi_7173_;
                    phi_7174_ = _e4616;
                    phi_7175_ = _e4612;
                } else {
                    phi_7174_ = 0u;
                    phi_7175_ = false;
                }
                let _e4618 = phi_7174_;
                let _e4620 = phi_7175_;
                phi_7176_ = _e4618;
                phi_7177_ = _e4620;
                phi_7178_ = type_9(_e147, _e150);
            } else {
                phi_7176_ = 0u;
                phi_7177_ = false;
                phi_7178_ = type_9(0u, 0u);
            }
            let _e4622 = phi_7176_;
            let _e4624 = phi_7177_;
            let _e4626 = phi_7178_;
            workgroupBarrier();
            if (_e53 == 0u) {
                let _e4629 = atomicLoad((&counters[0u]));
                let _e4631 = atomicLoad((&counters[1u]));
                if (_e4629 > 0u) {
                    let _e4634 = atomicAdd((&output.member[0u]), _e4629);
                    if ((_e4634 + _e4629) < _e4634) {
                        let _e4638 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e4634);
                }
                if (_e4631 > 0u) {
                    let _e4642 = atomicAdd((&output.member[1u]), _e4631);
                    if ((_e4642 + _e4631) < _e4642) {
                        let _e4646 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e4624 {
                let _e4648 = params.member.member_1.member_3;
                let _e4650 = atomicLoad((&counters[2u]));
                let _e4651 = (_e4650 + _e4622);
                if (_e4651 < _e4648) {
                    let _e4655 = (2u * _e4651);
                    atomicStore((&output.member[(4u + _e4655)]), _e4626.member);
                    atomicStore((&output.member[(_e4655 + 5u)]), _e4626.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_410_ = _e126;
            break if !(_e132);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_listed(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_8(id, n, lane);
}
