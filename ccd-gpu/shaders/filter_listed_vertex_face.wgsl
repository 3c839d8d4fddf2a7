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

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: i32,
    member_1: i32,
}

struct type_15 {
    member: u32,
    member_1: i32,
}

struct type_17 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_26 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_28 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_29 {
    member: u32,
}

struct type_30 {
    member: type_7,
    member_1: type_8,
    member_2: type_29,
}

struct type_31 {
    member: type_30,
}

struct type_33 {
    member: array<array<u32, 3>>,
}

struct type_36 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> bodies: type_10;
@group(0) @binding(4) 
var<storage> keys: type_26;
@group(0) @binding(5) 
var<storage> paths: type_19;
@group(0) @binding(6) 
var<storage> input: type_10;
@group(0) @binding(7) 
var<storage, read_write> output: type_36;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_31;
@group(0) @binding(1) 
var<storage> boxes: type_23;
@group(0) @binding(2) 
var<storage> elements: type_33;

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

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_28;
    var local_1: type_28;
    var local_2: type_28;
    var phi_317_: u32;
    var phi_327_: u32;
    var phi_334_: u32;
    var phi_350_: u32;
    var phi_371_: u32;
    var phi_372_: u32;
    var phi_375_: type_12;
    var phi_376_: type_12;
    var phi_399_: type_12;
    var phi_520_: bool;
    var phi_527_: bool;
    var phi_535_: bool;
    var phi_556_: bool;
    var phi_557_: bool;
    var phi_600_: bool;
    var phi_601_: bool;
    var phi_608_: bool;
    var phi_724_: bool;
    var phi_725_: bool;
    var phi_766_: type_14;
    var phi_769_: u32;
    var phi_771_: u32;
    var phi_792_: bool;
    var phi_798_: type_15;
    var phi_767_: type_14;
    var phi_812_: type_15;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_887_: bool;
    var phi_893_: u32;
    var phi_894_: u32;
    var phi_895_: u32;
    var phi_896_: u32;
    var phi_897_: bool;
    var phi_770_: u32;
    var phi_772_: u32;
    var phi_898_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_946_: bool;
    var phi_947_: bool;
    var phi_948_: bool;
    var phi_949_: bool;
    var phi_953_: bool;
    var phi_954_: bool;
    var phi_958_: bool;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_972_: bool;
    var phi_973_: bool;
    var phi_1106_: bool;
    var phi_1107_: bool;
    var phi_1197_: bool;
    var phi_1198_: bool;
    var phi_1289_: bool;
    var phi_1290_: bool;
    var phi_1380_: bool;
    var phi_1381_: bool;
    var phi_1473_: bool;
    var phi_1474_: bool;
    var phi_1564_: bool;
    var phi_1565_: bool;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1571_: bool;
    var phi_1575_: bool;
    var phi_1576_: bool;
    var phi_1577_: bool;
    var phi_1578_: bool;
    var phi_1579_: bool;
    var phi_1583_: bool;
    var phi_1977_: f32;
    var phi_1984_: f32;
    var phi_1989_: f32;
    var phi_1996_: f32;
    var phi_2001_: f32;
    var phi_2014_: f32;
    var phi_2021_: f32;
    var phi_2026_: f32;
    var phi_2033_: f32;
    var phi_2038_: f32;
    var phi_2043_: f32;
    var phi_2060_: f32;
    var phi_2067_: f32;
    var phi_2072_: f32;
    var phi_2079_: f32;
    var phi_2084_: f32;
    var phi_2098_: f32;
    var phi_2105_: f32;
    var phi_2110_: f32;
    var phi_2117_: f32;
    var phi_2122_: f32;
    var phi_2127_: f32;
    var phi_2144_: f32;
    var phi_2151_: f32;
    var phi_2156_: f32;
    var phi_2163_: f32;
    var phi_2168_: f32;
    var phi_2182_: f32;
    var phi_2189_: f32;
    var phi_2194_: f32;
    var phi_2201_: f32;
    var phi_2206_: f32;
    var phi_2211_: f32;
    var phi_2242_: f32;
    var phi_2248_: f32;
    var phi_2255_: f32;
    var phi_2262_: f32;
    var phi_2268_: f32;
    var phi_2275_: f32;
    var phi_2281_: f32;
    var phi_2287_: f32;
    var phi_2293_: f32;
    var phi_2300_: f32;
    var phi_2307_: f32;
    var phi_2331_: f32;
    var phi_2336_: f32;
    var phi_2341_: f32;
    var phi_2346_: f32;
    var phi_2351_: f32;
    var phi_2356_: f32;
    var phi_2366_: f32;
    var phi_2569_: f32;
    var phi_2576_: f32;
    var phi_2581_: f32;
    var phi_2588_: f32;
    var phi_2593_: f32;
    var phi_2606_: f32;
    var phi_2613_: f32;
    var phi_2618_: f32;
    var phi_2625_: f32;
    var phi_2630_: f32;
    var phi_2635_: f32;
    var phi_2652_: f32;
    var phi_2659_: f32;
    var phi_2664_: f32;
    var phi_2671_: f32;
    var phi_2676_: f32;
    var phi_2690_: f32;
    var phi_2697_: f32;
    var phi_2702_: f32;
    var phi_2709_: f32;
    var phi_2714_: f32;
    var phi_2719_: f32;
    var phi_2736_: f32;
    var phi_2743_: f32;
    var phi_2748_: f32;
    var phi_2755_: f32;
    var phi_2760_: f32;
    var phi_2774_: f32;
    var phi_2781_: f32;
    var phi_2786_: f32;
    var phi_2793_: f32;
    var phi_2798_: f32;
    var phi_2803_: f32;
    var phi_2882_: f32;
    var phi_2887_: f32;
    var phi_2892_: f32;
    var phi_2897_: f32;
    var phi_2902_: f32;
    var phi_2907_: f32;
    var phi_2912_: f32;
    var phi_2917_: f32;
    var phi_2922_: f32;
    var phi_2927_: f32;
    var phi_2932_: f32;
    var phi_2937_: f32;
    var phi_2942_: f32;
    var phi_2947_: f32;
    var phi_2953_: f32;
    var phi_2959_: f32;
    var phi_2966_: f32;
    var phi_2977_: f32;
    var phi_3048_: f32;
    var phi_3053_: f32;
    var phi_3058_: f32;
    var phi_3063_: f32;
    var phi_3068_: f32;
    var phi_3073_: f32;
    var phi_3078_: f32;
    var phi_3083_: f32;
    var phi_3088_: f32;
    var phi_3093_: f32;
    var phi_3098_: f32;
    var phi_3103_: f32;
    var phi_3108_: f32;
    var phi_3113_: f32;
    var phi_3119_: f32;
    var phi_3125_: f32;
    var phi_3132_: f32;
    var phi_3143_: f32;
    var phi_3153_: f32;
    var phi_3226_: f32;
    var phi_3231_: f32;
    var phi_3236_: f32;
    var phi_3241_: f32;
    var phi_3246_: f32;
    var phi_3251_: f32;
    var phi_3256_: f32;
    var phi_3261_: f32;
    var phi_3266_: f32;
    var phi_3271_: f32;
    var phi_3276_: f32;
    var phi_3281_: f32;
    var phi_3286_: f32;
    var phi_3291_: f32;
    var phi_3297_: f32;
    var phi_3303_: f32;
    var phi_3310_: f32;
    var phi_3321_: f32;
    var phi_3331_: f32;
    var phi_3335_: bool;
    var phi_3787_: f32;
    var phi_3794_: f32;
    var phi_3799_: f32;
    var phi_3806_: f32;
    var phi_3811_: f32;
    var phi_3824_: f32;
    var phi_3831_: f32;
    var phi_3836_: f32;
    var phi_3843_: f32;
    var phi_3848_: f32;
    var phi_3853_: f32;
    var phi_3870_: f32;
    var phi_3877_: f32;
    var phi_3882_: f32;
    var phi_3889_: f32;
    var phi_3894_: f32;
    var phi_3908_: f32;
    var phi_3915_: f32;
    var phi_3920_: f32;
    var phi_3927_: f32;
    var phi_3932_: f32;
    var phi_3937_: f32;
    var phi_3954_: f32;
    var phi_3961_: f32;
    var phi_3966_: f32;
    var phi_3973_: f32;
    var phi_3978_: f32;
    var phi_3992_: f32;
    var phi_3999_: f32;
    var phi_4004_: f32;
    var phi_4011_: f32;
    var phi_4016_: f32;
    var phi_4021_: f32;
    var phi_4052_: f32;
    var phi_4058_: f32;
    var phi_4065_: f32;
    var phi_4072_: f32;
    var phi_4078_: f32;
    var phi_4085_: f32;
    var phi_4091_: f32;
    var phi_4097_: f32;
    var phi_4103_: f32;
    var phi_4110_: f32;
    var phi_4117_: f32;
    var phi_4141_: f32;
    var phi_4146_: f32;
    var phi_4151_: f32;
    var phi_4156_: f32;
    var phi_4161_: f32;
    var phi_4166_: f32;
    var phi_4176_: f32;
    var phi_4379_: f32;
    var phi_4386_: f32;
    var phi_4391_: f32;
    var phi_4398_: f32;
    var phi_4403_: f32;
    var phi_4416_: f32;
    var phi_4423_: f32;
    var phi_4428_: f32;
    var phi_4435_: f32;
    var phi_4440_: f32;
    var phi_4445_: f32;
    var phi_4462_: f32;
    var phi_4469_: f32;
    var phi_4474_: f32;
    var phi_4481_: f32;
    var phi_4486_: f32;
    var phi_4500_: f32;
    var phi_4507_: f32;
    var phi_4512_: f32;
    var phi_4519_: f32;
    var phi_4524_: f32;
    var phi_4529_: f32;
    var phi_4546_: f32;
    var phi_4553_: f32;
    var phi_4558_: f32;
    var phi_4565_: f32;
    var phi_4570_: f32;
    var phi_4584_: f32;
    var phi_4591_: f32;
    var phi_4596_: f32;
    var phi_4603_: f32;
    var phi_4608_: f32;
    var phi_4613_: f32;
    var phi_4692_: f32;
    var phi_4697_: f32;
    var phi_4702_: f32;
    var phi_4707_: f32;
    var phi_4712_: f32;
    var phi_4717_: f32;
    var phi_4722_: f32;
    var phi_4727_: f32;
    var phi_4732_: f32;
    var phi_4737_: f32;
    var phi_4742_: f32;
    var phi_4747_: f32;
    var phi_4752_: f32;
    var phi_4757_: f32;
    var phi_4763_: f32;
    var phi_4769_: f32;
    var phi_4776_: f32;
    var phi_4787_: f32;
    var phi_4858_: f32;
    var phi_4863_: f32;
    var phi_4868_: f32;
    var phi_4873_: f32;
    var phi_4878_: f32;
    var phi_4883_: f32;
    var phi_4888_: f32;
    var phi_4893_: f32;
    var phi_4898_: f32;
    var phi_4903_: f32;
    var phi_4908_: f32;
    var phi_4913_: f32;
    var phi_4918_: f32;
    var phi_4923_: f32;
    var phi_4929_: f32;
    var phi_4935_: f32;
    var phi_4942_: f32;
    var phi_4953_: f32;
    var phi_4963_: f32;
    var phi_5036_: f32;
    var phi_5041_: f32;
    var phi_5046_: f32;
    var phi_5051_: f32;
    var phi_5056_: f32;
    var phi_5061_: f32;
    var phi_5066_: f32;
    var phi_5071_: f32;
    var phi_5076_: f32;
    var phi_5081_: f32;
    var phi_5086_: f32;
    var phi_5091_: f32;
    var phi_5096_: f32;
    var phi_5101_: f32;
    var phi_5107_: f32;
    var phi_5113_: f32;
    var phi_5120_: f32;
    var phi_5131_: f32;
    var phi_5141_: f32;
    var phi_5145_: bool;
    var phi_5390_: f32;
    var phi_5397_: f32;
    var phi_5402_: f32;
    var phi_5409_: f32;
    var phi_5414_: f32;
    var phi_5427_: f32;
    var phi_5434_: f32;
    var phi_5439_: f32;
    var phi_5446_: f32;
    var phi_5451_: f32;
    var phi_5456_: f32;
    var phi_5473_: f32;
    var phi_5480_: f32;
    var phi_5485_: f32;
    var phi_5492_: f32;
    var phi_5497_: f32;
    var phi_5511_: f32;
    var phi_5518_: f32;
    var phi_5523_: f32;
    var phi_5530_: f32;
    var phi_5535_: f32;
    var phi_5540_: f32;
    var phi_5557_: f32;
    var phi_5564_: f32;
    var phi_5569_: f32;
    var phi_5576_: f32;
    var phi_5581_: f32;
    var phi_5595_: f32;
    var phi_5602_: f32;
    var phi_5607_: f32;
    var phi_5614_: f32;
    var phi_5619_: f32;
    var phi_5624_: f32;
    var phi_5655_: f32;
    var phi_5661_: f32;
    var phi_5668_: f32;
    var phi_5675_: f32;
    var phi_5681_: f32;
    var phi_5688_: f32;
    var phi_5694_: f32;
    var phi_5700_: f32;
    var phi_5706_: f32;
    var phi_5713_: f32;
    var phi_5720_: f32;
    var phi_5744_: f32;
    var phi_5749_: f32;
    var phi_5754_: f32;
    var phi_5759_: f32;
    var phi_5764_: f32;
    var phi_5769_: f32;
    var phi_5779_: f32;
    var phi_5982_: f32;
    var phi_5989_: f32;
    var phi_5994_: f32;
    var phi_6001_: f32;
    var phi_6006_: f32;
    var phi_6019_: f32;
    var phi_6026_: f32;
    var phi_6031_: f32;
    var phi_6038_: f32;
    var phi_6043_: f32;
    var phi_6048_: f32;
    var phi_6065_: f32;
    var phi_6072_: f32;
    var phi_6077_: f32;
    var phi_6084_: f32;
    var phi_6089_: f32;
    var phi_6103_: f32;
    var phi_6110_: f32;
    var phi_6115_: f32;
    var phi_6122_: f32;
    var phi_6127_: f32;
    var phi_6132_: f32;
    var phi_6149_: f32;
    var phi_6156_: f32;
    var phi_6161_: f32;
    var phi_6168_: f32;
    var phi_6173_: f32;
    var phi_6187_: f32;
    var phi_6194_: f32;
    var phi_6199_: f32;
    var phi_6206_: f32;
    var phi_6211_: f32;
    var phi_6216_: f32;
    var phi_6295_: f32;
    var phi_6300_: f32;
    var phi_6305_: f32;
    var phi_6310_: f32;
    var phi_6315_: f32;
    var phi_6320_: f32;
    var phi_6325_: f32;
    var phi_6330_: f32;
    var phi_6335_: f32;
    var phi_6340_: f32;
    var phi_6345_: f32;
    var phi_6350_: f32;
    var phi_6355_: f32;
    var phi_6360_: f32;
    var phi_6366_: f32;
    var phi_6372_: f32;
    var phi_6379_: f32;
    var phi_6390_: f32;
    var phi_6461_: f32;
    var phi_6466_: f32;
    var phi_6471_: f32;
    var phi_6476_: f32;
    var phi_6481_: f32;
    var phi_6486_: f32;
    var phi_6491_: f32;
    var phi_6496_: f32;
    var phi_6501_: f32;
    var phi_6506_: f32;
    var phi_6511_: f32;
    var phi_6516_: f32;
    var phi_6521_: f32;
    var phi_6526_: f32;
    var phi_6532_: f32;
    var phi_6538_: f32;
    var phi_6545_: f32;
    var phi_6556_: f32;
    var phi_6566_: f32;
    var phi_6639_: f32;
    var phi_6644_: f32;
    var phi_6649_: f32;
    var phi_6654_: f32;
    var phi_6659_: f32;
    var phi_6664_: f32;
    var phi_6669_: f32;
    var phi_6674_: f32;
    var phi_6679_: f32;
    var phi_6684_: f32;
    var phi_6689_: f32;
    var phi_6694_: f32;
    var phi_6699_: f32;
    var phi_6704_: f32;
    var phi_6710_: f32;
    var phi_6716_: f32;
    var phi_6723_: f32;
    var phi_6734_: f32;
    var phi_6744_: f32;
    var phi_6748_: bool;
    var phi_6750_: bool;
    var phi_6752_: bool;
    var phi_6759_: u32;
    var phi_6760_: u32;
    var phi_6761_: bool;
    var phi_6762_: u32;
    var phi_6763_: bool;
    var phi_6764_: type_12;
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
    let _e72 = params.member.member_1.member_2;
    let _e74 = input.member[0u];
    if (_e72 < _e74) {
        phi_317_ = _e72;
    } else {
        phi_317_ = _e74;
    }
    let _e77 = phi_317_;
    let _e79 = params.member.member_1.member_1;
    if (_e77 > _e79) {
        let _e82 = params.member.member_1.member_1;
        phi_327_ = (_e77 - _e82);
    } else {
        phi_327_ = 0u;
    }
    let _e85 = phi_327_;
    let _e87 = params.member.member_1.member;
    if (_e87 < _e85) {
        phi_334_ = _e87;
    } else {
        phi_334_ = _e85;
    }
    let _e90 = phi_334_;
    let _e91 = (_e90 / 128u);
    if ((_e90 % 128u) > 0u) {
        phi_350_ = (_e91 + 1u);
    } else {
        phi_350_ = _e91;
    }
    let _e96 = phi_350_;
    if (_e96 > _e66) {
        let _e98 = (_e96 - _e66);
        if (_e69 == 0u) {
            return;
        }
        let _e100 = (_e98 / _e69);
        if (_e69 == 0u) {
            return;
        }
        if ((_e98 % _e69) > 0u) {
            phi_371_ = (_e100 + 1u);
        } else {
            phi_371_ = _e100;
        }
        let _e106 = phi_371_;
        phi_372_ = _e106;
    } else {
        phi_372_ = 0u;
    }
    let _e108 = phi_372_;
    phi_375_ = type_12(0u, _e108);
    loop {
        let _e111 = phi_375_;
        if (_e111.member < _e111.member_1) {
            phi_376_ = type_12((_e111.member + 1u), _e111.member_1);
            phi_399_ = type_12(1u, _e111.member);
        } else {
            phi_376_ = _e111;
            phi_399_ = type_12(0u, type_12().member_1);
        }
        let _e123 = phi_376_;
        let _e125 = phi_399_;
        let _e129 = (bitcast<i32>(_e125.member) != 0i);
        if _e129 {
            let _e133 = (((_e66 + (_e125.member_1 * _e69)) * 128u) + _e53);
            if (_e53 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e133 < _e90) {
                let _e139 = params.member.member_1.member_1;
                let _e141 = (2u * (_e139 + _e133));
                let _e144 = input.member[(4u + _e141)];
                let _e147 = input.member[(_e141 + 5u)];
                let _e150 = elements.member[_e147];
                let _e154 = params.member.member.member_2[2u];
                let _e157 = boxes.member[_e144];
                let _e159 = boxes.member[(_e154 + _e147)];
                let _e162 = params.member.member.member_1;
                if ((_e162 & 1u) != 0u) {
                    if (_e150[0] == _e144) {
                        phi_520_ = true;
                    } else {
                        phi_520_ = (_e150[0] == _e144);
                    }
                    let _e169 = phi_520_;
                    if (_e150[1] == _e144) {
                        phi_527_ = true;
                    } else {
                        phi_527_ = (_e150[1] == _e144);
                    }
                    let _e174 = phi_527_;
                    if (_e150[2] == _e144) {
                        phi_535_ = true;
                    } else {
                        phi_535_ = (_e150[2] == _e144);
                    }
                    let _e180 = phi_535_;
                    if ((_e169 || _e174) || _e180) {
                        phi_556_ = false;
                    } else {
                        phi_556_ = true;
                    }
                    let _e183 = phi_556_;
                    phi_557_ = _e183;
                } else {
                    phi_557_ = true;
                }
                let _e185 = phi_557_;
                if _e185 {
                    let _e187 = params.member.member.member_1;
                    if ((_e187 & 2u) != 0u) {
                        let _e191 = bodies.member[_e144];
                        let _e194 = bodies.member[_e150[0]];
                        if ((_e191 / 4u) != (_e194 / 4u)) {
                            phi_601_ = true;
                        } else {
                            if ((_e191 & 2u) == 0u) {
                                phi_600_ = false;
                            } else {
                                phi_600_ = true;
                            }
                            let _e201 = phi_600_;
                            phi_601_ = _e201;
                        }
                        let _e203 = phi_601_;
                        if _e203 {
                            phi_608_ = (((_e191 & _e194) & 1u) == 0u);
                        } else {
                            phi_608_ = false;
                        }
                        let _e208 = phi_608_;
                        if _e208 {
                            let _e210 = params.member.member.member_1;
                            if ((_e210 & 4u) != 0u) {
                                let _e215 = params.member.member.member[0u];
                                let _e217 = bodies.member[_e215];
                                let _e220 = bodies.member[(_e215 + 1u)];
                                let _e225 = ((_e215 + 4u) + (2u * (_e191 >> bitcast<u32>(2i))));
                                let _e230 = ((_e215 + 4u) + (2u * (_e194 >> bitcast<u32>(2i))));
                                let _e232 = bodies.member[_e225];
                                let _e234 = bodies.member[_e230];
                                let _e243 = bodies.member[((((_e215 + 4u) + (2u * _e217)) + (_e232 * _e220)) + (_e234 / 32u))];
                                let _e246 = bodies.member[(_e225 + 1u)];
                                let _e249 = bodies.member[(_e230 + 1u)];
                                if (_e246 == _e249) {
                                    if (((_e243 >> bitcast<u32>(((_e234 % 32u) & 31u))) & 1u) == 1u) {
                                        phi_724_ = true;
                                    } else {
                                        phi_724_ = ((_e191 >> bitcast<u32>(2i)) == (_e194 >> bitcast<u32>(2i)));
                                    }
                                    let _e263 = phi_724_;
                                    phi_725_ = _e263;
                                } else {
                                    phi_725_ = false;
                                }
                                let _e265 = phi_725_;
                                if _e265 {
                                    let _e268 = bodies.member[(_e215 + 2u)];
                                    let _e271 = bodies.member[(_e215 + 3u)];
                                    let _e272 = (_e271 + _e215);
                                    phi_766_ = type_14(0i, 32i);
                                    phi_769_ = _e268;
                                    phi_771_ = 0u;
                                    loop {
                                        let _e274 = phi_766_;
                                        let _e276 = phi_769_;
                                        let _e278 = phi_771_;
                                        local_3 = _e278;
                                        local_4 = _e278;
                                        if (_e274.member < _e274.member_1) {
                                            let _e285 = (_e274.member + 1i);
                                            if ((false == (_e285 > _e274.member)) != false) {
                                                phi_792_ = true;
                                            } else {
                                                phi_792_ = false;
                                            }
                                            let _e290 = phi_792_;
                                            if _e290 {
                                                phi_798_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_798_ = type_15(1u, _e285);
                                            }
                                            let _e295 = phi_798_;
                                            phi_767_ = type_14(_e295.member_1, _e274.member_1);
                                            phi_812_ = type_15(1u, _e274.member);
                                        } else {
                                            phi_767_ = _e274;
                                            phi_812_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e301 = phi_767_;
                                        let _e303 = phi_812_;
                                        if (bitcast<i32>(_e303.member) != 0i) {
                                            if (_e278 >= _e276) {
                                                phi_895_ = u32();
                                                phi_896_ = u32();
                                                phi_897_ = false;
                                            } else {
                                                let _e310 = (_e278 + ((_e276 - _e278) / 2u));
                                                let _e312 = (_e272 + (3u * _e310));
                                                let _e314 = bodies.member[_e312];
                                                let _e317 = bodies.member[(_e312 + 1u)];
                                                let _e320 = bodies.member[(_e312 + 2u)];
                                                if (_e314 == 0u) {
                                                    if (_e317 < _e144) {
                                                        phi_882_ = false;
                                                    } else {
                                                        if (_e317 == _e144) {
                                                            if (_e320 < _e147) {
                                                                phi_880_ = false;
                                                            } else {
                                                                phi_880_ = true;
                                                            }
                                                            let _e326 = phi_880_;
                                                            phi_881_ = _e326;
                                                        } else {
                                                            phi_881_ = true;
                                                        }
                                                        let _e328 = phi_881_;
                                                        phi_882_ = _e328;
                                                    }
                                                    let _e330 = phi_882_;
                                                    phi_883_ = _e330;
                                                } else {
                                                    phi_883_ = true;
                                                }
                                                let _e332 = phi_883_;
                                                if _e332 {
                                                    phi_887_ = false;
                                                } else {
                                                    phi_887_ = true;
                                                }
                                                let _e334 = phi_887_;
                                                if _e334 {
                                                    phi_893_ = _e276;
                                                    phi_894_ = (_e310 + 1u);
                                                } else {
                                                    phi_893_ = _e310;
                                                    phi_894_ = _e278;
                                                }
                                                let _e337 = phi_893_;
                                                let _e339 = phi_894_;
                                                phi_895_ = _e337;
                                                phi_896_ = _e339;
                                                phi_897_ = true;
                                            }
                                            let _e341 = phi_895_;
                                            let _e343 = phi_896_;
                                            let _e345 = phi_897_;
                                            phi_770_ = _e341;
                                            phi_772_ = _e343;
                                            phi_898_ = _e345;
                                        } else {
                                            phi_770_ = u32();
                                            phi_772_ = u32();
                                            phi_898_ = false;
                                        }
                                        let _e347 = phi_770_;
                                        let _e349 = phi_772_;
                                        let _e351 = phi_898_;
                                        continue;
                                        continuing {
                                            phi_766_ = _e301;
                                            phi_769_ = _e347;
                                            phi_771_ = _e349;
                                            break if !(_e351);
                                        }
                                    }
                                    let _e354 = local_3;
                                    if (_e354 < _e268) {
                                        let _e357 = local_4;
                                        let _e359 = (_e272 + (3u * _e357));
                                        let _e361 = bodies.member[_e359];
                                        if (_e361 == 0u) {
                                            let _e365 = bodies.member[(_e359 + 1u)];
                                            if (_e365 == _e144) {
                                                let _e369 = bodies.member[(_e359 + 2u)];
                                                phi_946_ = (_e369 == _e147);
                                                phi_947_ = false;
                                            } else {
                                                phi_946_ = bool();
                                                phi_947_ = true;
                                            }
                                            let _e372 = phi_946_;
                                            let _e374 = phi_947_;
                                            phi_948_ = _e372;
                                            phi_949_ = _e374;
                                        } else {
                                            phi_948_ = bool();
                                            phi_949_ = true;
                                        }
                                        let _e376 = phi_948_;
                                        let _e378 = phi_949_;
                                        if _e378 {
                                            phi_953_ = false;
                                        } else {
                                            phi_953_ = _e376;
                                        }
                                        let _e380 = phi_953_;
                                        phi_954_ = _e380;
                                    } else {
                                        phi_954_ = false;
                                    }
                                    let _e382 = phi_954_;
                                    phi_958_ = _e382;
                                } else {
                                    phi_958_ = true;
                                }
                                let _e384 = phi_958_;
                                if _e384 {
                                    phi_962_ = false;
                                } else {
                                    phi_962_ = true;
                                }
                                let _e386 = phi_962_;
                                phi_963_ = _e386;
                            } else {
                                phi_963_ = true;
                            }
                            let _e388 = phi_963_;
                            if _e388 {
                                phi_967_ = false;
                            } else {
                                phi_967_ = true;
                            }
                            let _e390 = phi_967_;
                            phi_968_ = _e390;
                        } else {
                            phi_968_ = true;
                        }
                        let _e392 = phi_968_;
                        if _e392 {
                            phi_972_ = false;
                        } else {
                            phi_972_ = true;
                        }
                        let _e394 = phi_972_;
                        phi_973_ = _e394;
                    } else {
                        phi_973_ = true;
                    }
                    let _e396 = phi_973_;
                    if _e396 {
                        let _e398 = params.member.member.member_1;
                        if ((_e398 & 32u) != 0u) {
                            let _e402 = params.member.member.member_6;
                            let _e443 = (((((_e157.member_1[0] - _e159.member[0]) > _e402) && ((_e159.member_1[0] - _e157.member[0]) > _e402)) && (((_e157.member_1[1] - _e159.member[1]) > _e402) && ((_e159.member_1[1] - _e157.member[1]) > _e402))) && (((_e157.member_1[2] - _e159.member[2]) > _e402) && ((_e159.member_1[2] - _e157.member[2]) > _e402)));
                            if _e443 {
                                phi_1569_ = bool();
                            } else {
                                let _e445 = keys.member[_e144];
                                let _e448 = keys.member[_e144];
                                let _e450 = function_(_e445[0], _e448[0]);
                                let _e452 = keys.member[_e144];
                                let _e454 = function_(_e450, _e452[0]);
                                let _e457 = keys.member[_e150[0]];
                                let _e461 = keys.member[_e150[1]];
                                let _e463 = function_1(_e457[3], _e461[3]);
                                let _e466 = keys.member[_e150[2]];
                                let _e468 = function_1(_e463, _e466[3]);
                                if (_e454[1] > _e468[1]) {
                                    phi_1107_ = true;
                                } else {
                                    if (_e454[1] == _e468[1]) {
                                        phi_1106_ = (_e454[0] > _e468[0]);
                                    } else {
                                        phi_1106_ = false;
                                    }
                                    let _e479 = phi_1106_;
                                    phi_1107_ = _e479;
                                }
                                let _e481 = phi_1107_;
                                let _e485 = keys.member[_e150[0]];
                                let _e489 = keys.member[_e150[1]];
                                let _e491 = function_(_e485[0], _e489[0]);
                                let _e494 = keys.member[_e150[2]];
                                let _e496 = function_(_e491, _e494[0]);
                                let _e498 = keys.member[_e144];
                                let _e501 = keys.member[_e144];
                                let _e503 = function_1(_e498[3], _e501[3]);
                                let _e505 = keys.member[_e144];
                                let _e507 = function_1(_e503, _e505[3]);
                                if (_e496[1] > _e507[1]) {
                                    phi_1198_ = true;
                                } else {
                                    if (_e496[1] == _e507[1]) {
                                        phi_1197_ = (_e496[0] > _e507[0]);
                                    } else {
                                        phi_1197_ = false;
                                    }
                                    let _e518 = phi_1197_;
                                    phi_1198_ = _e518;
                                }
                                let _e520 = phi_1198_;
                                let _e524 = keys.member[_e144];
                                let _e527 = keys.member[_e144];
                                let _e529 = function_2(_e524[1], _e527[1]);
                                let _e531 = keys.member[_e144];
                                let _e533 = function_2(_e529, _e531[1]);
                                let _e536 = keys.member[_e150[0]];
                                let _e540 = keys.member[_e150[1]];
                                let _e542 = function_3(_e536[4], _e540[4]);
                                let _e545 = keys.member[_e150[2]];
                                let _e547 = function_3(_e542, _e545[4]);
                                if (_e533[1] > _e547[1]) {
                                    phi_1290_ = true;
                                } else {
                                    if (_e533[1] == _e547[1]) {
                                        phi_1289_ = (_e533[0] > _e547[0]);
                                    } else {
                                        phi_1289_ = false;
                                    }
                                    let _e558 = phi_1289_;
                                    phi_1290_ = _e558;
                                }
                                let _e560 = phi_1290_;
                                let _e564 = keys.member[_e150[0]];
                                let _e568 = keys.member[_e150[1]];
                                let _e570 = function_2(_e564[1], _e568[1]);
                                let _e573 = keys.member[_e150[2]];
                                let _e575 = function_2(_e570, _e573[1]);
                                let _e577 = keys.member[_e144];
                                let _e580 = keys.member[_e144];
                                let _e582 = function_3(_e577[4], _e580[4]);
                                let _e584 = keys.member[_e144];
                                let _e586 = function_3(_e582, _e584[4]);
                                if (_e575[1] > _e586[1]) {
                                    phi_1381_ = true;
                                } else {
                                    if (_e575[1] == _e586[1]) {
                                        phi_1380_ = (_e575[0] > _e586[0]);
                                    } else {
                                        phi_1380_ = false;
                                    }
                                    let _e597 = phi_1380_;
                                    phi_1381_ = _e597;
                                }
                                let _e599 = phi_1381_;
                                let _e604 = keys.member[_e144];
                                let _e607 = keys.member[_e144];
                                let _e609 = function_4(_e604[2], _e607[2]);
                                let _e611 = keys.member[_e144];
                                let _e613 = function_4(_e609, _e611[2]);
                                let _e616 = keys.member[_e150[0]];
                                let _e620 = keys.member[_e150[1]];
                                let _e622 = function_5(_e616[5], _e620[5]);
                                let _e625 = keys.member[_e150[2]];
                                let _e627 = function_5(_e622, _e625[5]);
                                if (_e613[1] > _e627[1]) {
                                    phi_1474_ = true;
                                } else {
                                    if (_e613[1] == _e627[1]) {
                                        phi_1473_ = (_e613[0] > _e627[0]);
                                    } else {
                                        phi_1473_ = false;
                                    }
                                    let _e638 = phi_1473_;
                                    phi_1474_ = _e638;
                                }
                                let _e640 = phi_1474_;
                                let _e644 = keys.member[_e150[0]];
                                let _e648 = keys.member[_e150[1]];
                                let _e650 = function_4(_e644[2], _e648[2]);
                                let _e653 = keys.member[_e150[2]];
                                let _e655 = function_4(_e650, _e653[2]);
                                let _e657 = keys.member[_e144];
                                let _e660 = keys.member[_e144];
                                let _e662 = function_5(_e657[5], _e660[5]);
                                let _e664 = keys.member[_e144];
                                let _e666 = function_5(_e662, _e664[5]);
                                if (_e655[1] > _e666[1]) {
                                    phi_1565_ = true;
                                } else {
                                    if (_e655[1] == _e666[1]) {
                                        phi_1564_ = (_e655[0] > _e666[0]);
                                    } else {
                                        phi_1564_ = false;
                                    }
                                    let _e677 = phi_1564_;
                                    phi_1565_ = _e677;
                                }
                                let _e679 = phi_1565_;
                                phi_1569_ = (((!(_e481) && !(_e520)) && (!(_e560) && !(_e599))) && (!(_e640) && !(_e679)));
                            }
                            let _e684 = phi_1569_;
                            phi_1570_ = _e684;
                            phi_1571_ = _e443;
                        } else {
                            phi_1570_ = bool();
                            phi_1571_ = true;
                        }
                        let _e686 = phi_1570_;
                        let _e688 = phi_1571_;
                        if _e688 {
                            phi_1575_ = false;
                        } else {
                            phi_1575_ = true;
                        }
                        let _e690 = phi_1575_;
                        phi_1576_ = _e686;
                        phi_1577_ = _e690;
                    } else {
                        phi_1576_ = false;
                        phi_1577_ = true;
                    }
                    let _e692 = phi_1576_;
                    let _e694 = phi_1577_;
                    phi_1578_ = _e692;
                    phi_1579_ = _e694;
                } else {
                    phi_1578_ = false;
                    phi_1579_ = true;
                }
                let _e696 = phi_1578_;
                let _e698 = phi_1579_;
                if _e698 {
                    phi_1583_ = _e696;
                } else {
                    phi_1583_ = true;
                }
                let _e700 = phi_1583_;
                if _e700 {
                    let _e702 = atomicAdd((&counters[1u]), 1u);
                    let _e705 = params.member.member.member_4;
                    let _e707 = params.member.member.member_5;
                    let _e712 = paths.member[_e144];
                    let _e714 = paths.member[_e150[0]];
                    let _e720 = paths.member[_e150[1]];
                    let _e722 = paths.member[_e150[2]];
                    local_2 = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e712.member[0] - _e714.member[0]), (_e712.member[1] - _e714.member[1]), (_e712.member[2] - _e714.member[2])), array<f32, 3>((_e712.member_1[0] - _e714.member_1[0]), (_e712.member_1[1] - _e714.member_1[1]), (_e712.member_1[2] - _e714.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e720.member[0] - _e714.member[0]), (_e720.member[1] - _e714.member[1]), (_e720.member[2] - _e714.member[2])), array<f32, 3>((_e720.member_1[0] - _e714.member_1[0]), (_e720.member_1[1] - _e714.member_1[1]), (_e720.member_1[2] - _e714.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e722.member[0] - _e714.member[0]), (_e722.member[1] - _e714.member[1]), (_e722.member[2] - _e714.member[2])), array<f32, 3>((_e722.member_1[0] - _e714.member_1[0]), (_e722.member_1[1] - _e714.member_1[1]), (_e722.member_1[2] - _e714.member_1[2]))), (_e705 + _e705));
                    let _e782 = local_2.member_1[0u];
                    let _e788 = local_2.member_2[0u];
                    let _e794 = ((_e782[1] * _e788[2]) - (_e782[2] * _e788[1]));
                    let _e797 = ((_e782[2] * _e788[0]) - (_e782[0] * _e788[2]));
                    let _e800 = ((_e782[0] * _e788[1]) - (_e782[1] * _e788[0]));
                    let _e803 = local_2.member_1[1u];
                    let _e809 = local_2.member_2[1u];
                    let _e815 = ((_e803[1] * _e809[2]) - (_e803[2] * _e809[1]));
                    let _e818 = ((_e803[2] * _e809[0]) - (_e803[0] * _e809[2]));
                    let _e821 = ((_e803[0] * _e809[1]) - (_e803[1] * _e809[0]));
                    let _e824 = local_2.member_1[0u];
                    let _e830 = local_2.member_2[1u];
                    let _e845 = local_2.member_1[1u];
                    let _e851 = local_2.member_2[0u];
                    let _e864 = (((_e824[1] * _e830[2]) - (_e824[2] * _e830[1])) + ((_e845[1] * _e851[2]) - (_e845[2] * _e851[1])));
                    let _e865 = (((_e824[2] * _e830[0]) - (_e824[0] * _e830[2])) + ((_e845[2] * _e851[0]) - (_e845[0] * _e851[2])));
                    let _e866 = (((_e824[0] * _e830[1]) - (_e824[1] * _e830[0])) + ((_e845[0] * _e851[1]) - (_e845[1] * _e851[0])));
                    let _e869 = local_2.member[0u];
                    let _e880 = local_2.member[1u];
                    let _e891 = local_2.member[0u];
                    let _e900 = ((((_e880[0] * _e794) + (_e880[1] * _e797)) + (_e880[2] * _e800)) + (((_e891[0] * _e864) + (_e891[1] * _e865)) + (_e891[2] * _e866)));
                    let _e903 = local_2.member[0u];
                    let _e914 = local_2.member[1u];
                    let _e923 = ((((_e903[0] * _e815) + (_e903[1] * _e818)) + (_e903[2] * _e821)) + (((_e914[0] * _e864) + (_e914[1] * _e865)) + (_e914[2] * _e866)));
                    let _e926 = local_2.member[1u];
                    let _e937 = local_2.member[0u];
                    if (_e937[0] < 0f) {
                        phi_1977_ = -(_e937[0]);
                    } else {
                        phi_1977_ = _e937[0];
                    }
                    let _e944 = phi_1977_;
                    if (_e937[1] < 0f) {
                        phi_1984_ = -(_e937[1]);
                    } else {
                        phi_1984_ = _e937[1];
                    }
                    let _e948 = phi_1984_;
                    if (_e944 > _e948) {
                        phi_1989_ = _e944;
                    } else {
                        phi_1989_ = _e948;
                    }
                    let _e951 = phi_1989_;
                    if (_e937[2] < 0f) {
                        phi_1996_ = -(_e937[2]);
                    } else {
                        phi_1996_ = _e937[2];
                    }
                    let _e955 = phi_1996_;
                    if (_e951 > _e955) {
                        phi_2001_ = _e951;
                    } else {
                        phi_2001_ = _e955;
                    }
                    let _e958 = phi_2001_;
                    let _e961 = local_2.member[1u];
                    if (_e961[0] < 0f) {
                        phi_2014_ = -(_e961[0]);
                    } else {
                        phi_2014_ = _e961[0];
                    }
                    let _e968 = phi_2014_;
                    if (_e961[1] < 0f) {
                        phi_2021_ = -(_e961[1]);
                    } else {
                        phi_2021_ = _e961[1];
                    }
                    let _e972 = phi_2021_;
                    if (_e968 > _e972) {
                        phi_2026_ = _e968;
                    } else {
                        phi_2026_ = _e972;
                    }
                    let _e975 = phi_2026_;
                    if (_e961[2] < 0f) {
                        phi_2033_ = -(_e961[2]);
                    } else {
                        phi_2033_ = _e961[2];
                    }
                    let _e979 = phi_2033_;
                    if (_e975 > _e979) {
                        phi_2038_ = _e975;
                    } else {
                        phi_2038_ = _e979;
                    }
                    let _e982 = phi_2038_;
                    if (_e958 > _e982) {
                        phi_2043_ = _e958;
                    } else {
                        phi_2043_ = _e982;
                    }
                    let _e985 = phi_2043_;
                    let _e987 = local_2.member_3;
                    let _e988 = (_e985 + _e987);
                    let _e991 = local_2.member_1[0u];
                    if (_e991[0] < 0f) {
                        phi_2060_ = -(_e991[0]);
                    } else {
                        phi_2060_ = _e991[0];
                    }
                    let _e998 = phi_2060_;
                    if (_e991[1] < 0f) {
                        phi_2067_ = -(_e991[1]);
                    } else {
                        phi_2067_ = _e991[1];
                    }
                    let _e1002 = phi_2067_;
                    if (_e998 > _e1002) {
                        phi_2072_ = _e998;
                    } else {
                        phi_2072_ = _e1002;
                    }
                    let _e1005 = phi_2072_;
                    if (_e991[2] < 0f) {
                        phi_2079_ = -(_e991[2]);
                    } else {
                        phi_2079_ = _e991[2];
                    }
                    let _e1009 = phi_2079_;
                    if (_e1005 > _e1009) {
                        phi_2084_ = _e1005;
                    } else {
                        phi_2084_ = _e1009;
                    }
                    let _e1012 = phi_2084_;
                    let _e1015 = local_2.member_1[1u];
                    if (_e1015[0] < 0f) {
                        phi_2098_ = -(_e1015[0]);
                    } else {
                        phi_2098_ = _e1015[0];
                    }
                    let _e1022 = phi_2098_;
                    if (_e1015[1] < 0f) {
                        phi_2105_ = -(_e1015[1]);
                    } else {
                        phi_2105_ = _e1015[1];
                    }
                    let _e1026 = phi_2105_;
                    if (_e1022 > _e1026) {
                        phi_2110_ = _e1022;
                    } else {
                        phi_2110_ = _e1026;
                    }
                    let _e1029 = phi_2110_;
                    if (_e1015[2] < 0f) {
                        phi_2117_ = -(_e1015[2]);
                    } else {
                        phi_2117_ = _e1015[2];
                    }
                    let _e1033 = phi_2117_;
                    if (_e1029 > _e1033) {
                        phi_2122_ = _e1029;
                    } else {
                        phi_2122_ = _e1033;
                    }
                    let _e1036 = phi_2122_;
                    if (_e1012 > _e1036) {
                        phi_2127_ = _e1012;
                    } else {
                        phi_2127_ = _e1036;
                    }
                    let _e1039 = phi_2127_;
                    let _e1041 = local_2.member_3;
                    let _e1042 = (_e1039 + _e1041);
                    let _e1045 = local_2.member_2[0u];
                    if (_e1045[0] < 0f) {
                        phi_2144_ = -(_e1045[0]);
                    } else {
                        phi_2144_ = _e1045[0];
                    }
                    let _e1052 = phi_2144_;
                    if (_e1045[1] < 0f) {
                        phi_2151_ = -(_e1045[1]);
                    } else {
                        phi_2151_ = _e1045[1];
                    }
                    let _e1056 = phi_2151_;
                    if (_e1052 > _e1056) {
                        phi_2156_ = _e1052;
                    } else {
                        phi_2156_ = _e1056;
                    }
                    let _e1059 = phi_2156_;
                    if (_e1045[2] < 0f) {
                        phi_2163_ = -(_e1045[2]);
                    } else {
                        phi_2163_ = _e1045[2];
                    }
                    let _e1063 = phi_2163_;
                    if (_e1059 > _e1063) {
                        phi_2168_ = _e1059;
                    } else {
                        phi_2168_ = _e1063;
                    }
                    let _e1066 = phi_2168_;
                    let _e1069 = local_2.member_2[1u];
                    if (_e1069[0] < 0f) {
                        phi_2182_ = -(_e1069[0]);
                    } else {
                        phi_2182_ = _e1069[0];
                    }
                    let _e1076 = phi_2182_;
                    if (_e1069[1] < 0f) {
                        phi_2189_ = -(_e1069[1]);
                    } else {
                        phi_2189_ = _e1069[1];
                    }
                    let _e1080 = phi_2189_;
                    if (_e1076 > _e1080) {
                        phi_2194_ = _e1076;
                    } else {
                        phi_2194_ = _e1080;
                    }
                    let _e1083 = phi_2194_;
                    if (_e1069[2] < 0f) {
                        phi_2201_ = -(_e1069[2]);
                    } else {
                        phi_2201_ = _e1069[2];
                    }
                    let _e1087 = phi_2201_;
                    if (_e1083 > _e1087) {
                        phi_2206_ = _e1083;
                    } else {
                        phi_2206_ = _e1087;
                    }
                    let _e1090 = phi_2206_;
                    if (_e1066 > _e1090) {
                        phi_2211_ = _e1066;
                    } else {
                        phi_2211_ = _e1090;
                    }
                    let _e1093 = phi_2211_;
                    let _e1095 = local_2.member_3;
                    let _e1096 = (_e1093 + _e1095);
                    let _e1098 = ((_e1042 * 8f) * _e1096);
                    let _e1105 = local_2.member_3;
                    if (_e794 < 0f) {
                        phi_2242_ = -(_e794);
                    } else {
                        phi_2242_ = _e794;
                    }
                    let _e1122 = phi_2242_;
                    if (_e797 < 0f) {
                        phi_2248_ = -(_e797);
                    } else {
                        phi_2248_ = _e797;
                    }
                    let _e1126 = phi_2248_;
                    if (_e800 < 0f) {
                        phi_2255_ = -(_e800);
                    } else {
                        phi_2255_ = _e800;
                    }
                    let _e1131 = phi_2255_;
                    let _e1132 = ((_e1122 + _e1126) + _e1131);
                    if (_e815 < 0f) {
                        phi_2262_ = -(_e815);
                    } else {
                        phi_2262_ = _e815;
                    }
                    let _e1136 = phi_2262_;
                    if (_e818 < 0f) {
                        phi_2268_ = -(_e818);
                    } else {
                        phi_2268_ = _e818;
                    }
                    let _e1140 = phi_2268_;
                    if (_e821 < 0f) {
                        phi_2275_ = -(_e821);
                    } else {
                        phi_2275_ = _e821;
                    }
                    let _e1145 = phi_2275_;
                    let _e1146 = ((_e1136 + _e1140) + _e1145);
                    if (_e1132 > _e1146) {
                        phi_2281_ = _e1132;
                    } else {
                        phi_2281_ = _e1146;
                    }
                    let _e1149 = phi_2281_;
                    if (_e864 < 0f) {
                        phi_2287_ = -(_e864);
                    } else {
                        phi_2287_ = _e864;
                    }
                    let _e1153 = phi_2287_;
                    if (_e865 < 0f) {
                        phi_2293_ = -(_e865);
                    } else {
                        phi_2293_ = _e865;
                    }
                    let _e1157 = phi_2293_;
                    if (_e866 < 0f) {
                        phi_2300_ = -(_e866);
                    } else {
                        phi_2300_ = _e866;
                    }
                    let _e1162 = phi_2300_;
                    let _e1164 = (((_e1153 + _e1157) + _e1162) * 0.5f);
                    if (_e1149 > _e1164) {
                        phi_2307_ = _e1149;
                    } else {
                        phi_2307_ = _e1164;
                    }
                    let _e1167 = phi_2307_;
                    let _e1172 = local_2.member_3;
                    let _e1185 = ((((_e869[0] * _e794) + (_e869[1] * _e797)) + (_e869[2] * _e800)) * 3f);
                    let _e1186 = ((((_e926[0] * _e815) + (_e926[1] * _e818)) + (_e926[2] * _e821)) * 3f);
                    if (_e1185 < _e1186) {
                        phi_2331_ = _e1185;
                    } else {
                        phi_2331_ = _e1186;
                    }
                    let _e1189 = phi_2331_;
                    if (_e900 < _e923) {
                        phi_2336_ = _e900;
                    } else {
                        phi_2336_ = _e923;
                    }
                    let _e1192 = phi_2336_;
                    if (_e1189 < _e1192) {
                        phi_2341_ = _e1189;
                    } else {
                        phi_2341_ = _e1192;
                    }
                    let _e1195 = phi_2341_;
                    if (_e1185 > _e1186) {
                        phi_2346_ = _e1185;
                    } else {
                        phi_2346_ = _e1186;
                    }
                    let _e1198 = phi_2346_;
                    if (_e900 > _e923) {
                        phi_2351_ = _e900;
                    } else {
                        phi_2351_ = _e923;
                    }
                    let _e1201 = phi_2351_;
                    if (_e1198 > _e1201) {
                        phi_2356_ = _e1198;
                    } else {
                        phi_2356_ = _e1201;
                    }
                    let _e1204 = phi_2356_;
                    let _e1209 = -(_e1204);
                    if (_e1195 > _e1209) {
                        phi_2366_ = _e1195;
                    } else {
                        phi_2366_ = _e1209;
                    }
                    let _e1212 = phi_2366_;
                    let _e1214 = ((_e1212 - ((((((_e988 * 8f) * _e1098) * (0.000000059604645f * (524f / 64f))) + ((_e1105 * 19f) * ((_e988 * (_e1042 + _e1096)) + (_e1042 * _e1096)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e988) * ((1f + _e1042) * (1f + _e1096))))) + ((_e707 * (((_e1167 + (_e1098 * (0.000000059604645f * 8f))) + ((_e1172 * 6f) * (_e1042 + _e1096))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1042) * (1f + _e1096))))) * (3f * 1.0001f)))) > 0f);
                    if _e1214 {
                        phi_3335_ = _e1214;
                    } else {
                        let _e1217 = local_2.member_1[0u];
                        let _e1223 = local_2.member_1[1u];
                        let _e1227 = (_e1217[0] + _e1223[0]);
                        let _e1228 = (_e1217[1] + _e1223[1]);
                        let _e1229 = (_e1217[2] + _e1223[2]);
                        let _e1232 = local_2.member_2[0u];
                        let _e1238 = local_2.member_2[1u];
                        let _e1242 = (_e1232[0] + _e1238[0]);
                        let _e1243 = (_e1232[1] + _e1238[1]);
                        let _e1244 = (_e1232[2] + _e1238[2]);
                        let _e1247 = ((_e1228 * _e1244) - (_e1229 * _e1243));
                        let _e1250 = ((_e1229 * _e1242) - (_e1227 * _e1244));
                        let _e1253 = ((_e1227 * _e1243) - (_e1228 * _e1242));
                        let _e1256 = local_2.member[0u];
                        let _e1262 = local_2.member_1[0u];
                        let _e1268 = local_2.member_2[0u];
                        let _e1272 = (_e1256[0] - _e1262[0]);
                        let _e1273 = (_e1256[1] - _e1262[1]);
                        let _e1274 = (_e1256[2] - _e1262[2]);
                        let _e1275 = (_e1256[0] - _e1268[0]);
                        let _e1276 = (_e1256[1] - _e1268[1]);
                        let _e1277 = (_e1256[2] - _e1268[2]);
                        let _e1280 = local_2.member[1u];
                        let _e1286 = local_2.member_1[1u];
                        let _e1292 = local_2.member_2[1u];
                        let _e1296 = (_e1280[0] - _e1286[0]);
                        let _e1297 = (_e1280[1] - _e1286[1]);
                        let _e1298 = (_e1280[2] - _e1286[2]);
                        let _e1299 = (_e1280[0] - _e1292[0]);
                        let _e1300 = (_e1280[1] - _e1292[1]);
                        let _e1301 = (_e1280[2] - _e1292[2]);
                        let _e1304 = local_2.member[0u];
                        if (_e1304[0] < 0f) {
                            phi_2569_ = -(_e1304[0]);
                        } else {
                            phi_2569_ = _e1304[0];
                        }
                        let _e1311 = phi_2569_;
                        if (_e1304[1] < 0f) {
                            phi_2576_ = -(_e1304[1]);
                        } else {
                            phi_2576_ = _e1304[1];
                        }
                        let _e1315 = phi_2576_;
                        if (_e1311 > _e1315) {
                            phi_2581_ = _e1311;
                        } else {
                            phi_2581_ = _e1315;
                        }
                        let _e1318 = phi_2581_;
                        if (_e1304[2] < 0f) {
                            phi_2588_ = -(_e1304[2]);
                        } else {
                            phi_2588_ = _e1304[2];
                        }
                        let _e1322 = phi_2588_;
                        if (_e1318 > _e1322) {
                            phi_2593_ = _e1318;
                        } else {
                            phi_2593_ = _e1322;
                        }
                        let _e1325 = phi_2593_;
                        let _e1328 = local_2.member[1u];
                        if (_e1328[0] < 0f) {
                            phi_2606_ = -(_e1328[0]);
                        } else {
                            phi_2606_ = _e1328[0];
                        }
                        let _e1335 = phi_2606_;
                        if (_e1328[1] < 0f) {
                            phi_2613_ = -(_e1328[1]);
                        } else {
                            phi_2613_ = _e1328[1];
                        }
                        let _e1339 = phi_2613_;
                        if (_e1335 > _e1339) {
                            phi_2618_ = _e1335;
                        } else {
                            phi_2618_ = _e1339;
                        }
                        let _e1342 = phi_2618_;
                        if (_e1328[2] < 0f) {
                            phi_2625_ = -(_e1328[2]);
                        } else {
                            phi_2625_ = _e1328[2];
                        }
                        let _e1346 = phi_2625_;
                        if (_e1342 > _e1346) {
                            phi_2630_ = _e1342;
                        } else {
                            phi_2630_ = _e1346;
                        }
                        let _e1349 = phi_2630_;
                        if (_e1325 > _e1349) {
                            phi_2635_ = _e1325;
                        } else {
                            phi_2635_ = _e1349;
                        }
                        let _e1352 = phi_2635_;
                        let _e1354 = local_2.member_3;
                        let _e1358 = local_2.member_1[0u];
                        if (_e1358[0] < 0f) {
                            phi_2652_ = -(_e1358[0]);
                        } else {
                            phi_2652_ = _e1358[0];
                        }
                        let _e1365 = phi_2652_;
                        if (_e1358[1] < 0f) {
                            phi_2659_ = -(_e1358[1]);
                        } else {
                            phi_2659_ = _e1358[1];
                        }
                        let _e1369 = phi_2659_;
                        if (_e1365 > _e1369) {
                            phi_2664_ = _e1365;
                        } else {
                            phi_2664_ = _e1369;
                        }
                        let _e1372 = phi_2664_;
                        if (_e1358[2] < 0f) {
                            phi_2671_ = -(_e1358[2]);
                        } else {
                            phi_2671_ = _e1358[2];
                        }
                        let _e1376 = phi_2671_;
                        if (_e1372 > _e1376) {
                            phi_2676_ = _e1372;
                        } else {
                            phi_2676_ = _e1376;
                        }
                        let _e1379 = phi_2676_;
                        let _e1382 = local_2.member_1[1u];
                        if (_e1382[0] < 0f) {
                            phi_2690_ = -(_e1382[0]);
                        } else {
                            phi_2690_ = _e1382[0];
                        }
                        let _e1389 = phi_2690_;
                        if (_e1382[1] < 0f) {
                            phi_2697_ = -(_e1382[1]);
                        } else {
                            phi_2697_ = _e1382[1];
                        }
                        let _e1393 = phi_2697_;
                        if (_e1389 > _e1393) {
                            phi_2702_ = _e1389;
                        } else {
                            phi_2702_ = _e1393;
                        }
                        let _e1396 = phi_2702_;
                        if (_e1382[2] < 0f) {
                            phi_2709_ = -(_e1382[2]);
                        } else {
                            phi_2709_ = _e1382[2];
                        }
                        let _e1400 = phi_2709_;
                        if (_e1396 > _e1400) {
                            phi_2714_ = _e1396;
                        } else {
                            phi_2714_ = _e1400;
                        }
                        let _e1403 = phi_2714_;
                        if (_e1379 > _e1403) {
                            phi_2719_ = _e1379;
                        } else {
                            phi_2719_ = _e1403;
                        }
                        let _e1406 = phi_2719_;
                        let _e1408 = local_2.member_3;
                        let _e1412 = local_2.member_2[0u];
                        if (_e1412[0] < 0f) {
                            phi_2736_ = -(_e1412[0]);
                        } else {
                            phi_2736_ = _e1412[0];
                        }
                        let _e1419 = phi_2736_;
                        if (_e1412[1] < 0f) {
                            phi_2743_ = -(_e1412[1]);
                        } else {
                            phi_2743_ = _e1412[1];
                        }
                        let _e1423 = phi_2743_;
                        if (_e1419 > _e1423) {
                            phi_2748_ = _e1419;
                        } else {
                            phi_2748_ = _e1423;
                        }
                        let _e1426 = phi_2748_;
                        if (_e1412[2] < 0f) {
                            phi_2755_ = -(_e1412[2]);
                        } else {
                            phi_2755_ = _e1412[2];
                        }
                        let _e1430 = phi_2755_;
                        if (_e1426 > _e1430) {
                            phi_2760_ = _e1426;
                        } else {
                            phi_2760_ = _e1430;
                        }
                        let _e1433 = phi_2760_;
                        let _e1436 = local_2.member_2[1u];
                        if (_e1436[0] < 0f) {
                            phi_2774_ = -(_e1436[0]);
                        } else {
                            phi_2774_ = _e1436[0];
                        }
                        let _e1443 = phi_2774_;
                        if (_e1436[1] < 0f) {
                            phi_2781_ = -(_e1436[1]);
                        } else {
                            phi_2781_ = _e1436[1];
                        }
                        let _e1447 = phi_2781_;
                        if (_e1443 > _e1447) {
                            phi_2786_ = _e1443;
                        } else {
                            phi_2786_ = _e1447;
                        }
                        let _e1450 = phi_2786_;
                        if (_e1436[2] < 0f) {
                            phi_2793_ = -(_e1436[2]);
                        } else {
                            phi_2793_ = _e1436[2];
                        }
                        let _e1454 = phi_2793_;
                        if (_e1450 > _e1454) {
                            phi_2798_ = _e1450;
                        } else {
                            phi_2798_ = _e1454;
                        }
                        let _e1457 = phi_2798_;
                        if (_e1433 > _e1457) {
                            phi_2803_ = _e1433;
                        } else {
                            phi_2803_ = _e1457;
                        }
                        let _e1460 = phi_2803_;
                        let _e1462 = local_2.member_3;
                        let _e1466 = ((((_e1352 + _e1354) + (_e1406 + _e1408)) + (_e1460 + _e1462)) * 2f);
                        let _e1469 = local_2.member_3;
                        let _e1473 = (((_e707 * 1.0001f) + (_e1469 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                        let _e1476 = ((_e1250 * _e1229) - (_e1253 * _e1228));
                        let _e1479 = ((_e1253 * _e1227) - (_e1247 * _e1229));
                        let _e1482 = ((_e1247 * _e1228) - (_e1250 * _e1227));
                        let _e1487 = (((_e1476 * _e1256[0]) + (_e1479 * _e1256[1])) + (_e1482 * _e1256[2]));
                        let _e1492 = (((_e1476 * _e1272) + (_e1479 * _e1273)) + (_e1482 * _e1274));
                        let _e1497 = (((_e1476 * _e1275) + (_e1479 * _e1276)) + (_e1482 * _e1277));
                        let _e1502 = (((_e1476 * _e1256[0]) + (_e1479 * _e1256[1])) + (_e1482 * _e1256[2]));
                        let _e1507 = (((_e1476 * _e1280[0]) + (_e1479 * _e1280[1])) + (_e1482 * _e1280[2]));
                        let _e1512 = (((_e1476 * _e1296) + (_e1479 * _e1297)) + (_e1482 * _e1298));
                        let _e1517 = (((_e1476 * _e1299) + (_e1479 * _e1300)) + (_e1482 * _e1301));
                        let _e1522 = (((_e1476 * _e1280[0]) + (_e1479 * _e1280[1])) + (_e1482 * _e1280[2]));
                        if (_e1487 < _e1492) {
                            phi_2882_ = _e1487;
                        } else {
                            phi_2882_ = _e1492;
                        }
                        let _e1525 = phi_2882_;
                        if (_e1497 < _e1502) {
                            phi_2887_ = _e1497;
                        } else {
                            phi_2887_ = _e1502;
                        }
                        let _e1528 = phi_2887_;
                        if (_e1525 < _e1528) {
                            phi_2892_ = _e1525;
                        } else {
                            phi_2892_ = _e1528;
                        }
                        let _e1531 = phi_2892_;
                        if (_e1507 < _e1512) {
                            phi_2897_ = _e1507;
                        } else {
                            phi_2897_ = _e1512;
                        }
                        let _e1534 = phi_2897_;
                        if (_e1517 < _e1522) {
                            phi_2902_ = _e1517;
                        } else {
                            phi_2902_ = _e1522;
                        }
                        let _e1537 = phi_2902_;
                        if (_e1534 < _e1537) {
                            phi_2907_ = _e1534;
                        } else {
                            phi_2907_ = _e1537;
                        }
                        let _e1540 = phi_2907_;
                        if (_e1531 < _e1540) {
                            phi_2912_ = _e1531;
                        } else {
                            phi_2912_ = _e1540;
                        }
                        let _e1543 = phi_2912_;
                        if (_e1487 > _e1492) {
                            phi_2917_ = _e1487;
                        } else {
                            phi_2917_ = _e1492;
                        }
                        let _e1546 = phi_2917_;
                        if (_e1497 > _e1502) {
                            phi_2922_ = _e1497;
                        } else {
                            phi_2922_ = _e1502;
                        }
                        let _e1549 = phi_2922_;
                        if (_e1546 > _e1549) {
                            phi_2927_ = _e1546;
                        } else {
                            phi_2927_ = _e1549;
                        }
                        let _e1552 = phi_2927_;
                        if (_e1507 > _e1512) {
                            phi_2932_ = _e1507;
                        } else {
                            phi_2932_ = _e1512;
                        }
                        let _e1555 = phi_2932_;
                        if (_e1517 > _e1522) {
                            phi_2937_ = _e1517;
                        } else {
                            phi_2937_ = _e1522;
                        }
                        let _e1558 = phi_2937_;
                        if (_e1555 > _e1558) {
                            phi_2942_ = _e1555;
                        } else {
                            phi_2942_ = _e1558;
                        }
                        let _e1561 = phi_2942_;
                        if (_e1552 > _e1561) {
                            phi_2947_ = _e1552;
                        } else {
                            phi_2947_ = _e1561;
                        }
                        let _e1564 = phi_2947_;
                        if (_e1476 < 0f) {
                            phi_2953_ = -(_e1476);
                        } else {
                            phi_2953_ = _e1476;
                        }
                        let _e1568 = phi_2953_;
                        if (_e1479 < 0f) {
                            phi_2959_ = -(_e1479);
                        } else {
                            phi_2959_ = _e1479;
                        }
                        let _e1572 = phi_2959_;
                        if (_e1482 < 0f) {
                            phi_2966_ = -(_e1482);
                        } else {
                            phi_2966_ = _e1482;
                        }
                        let _e1577 = phi_2966_;
                        let _e1578 = ((_e1568 + _e1572) + _e1577);
                        let _e1583 = -(_e1564);
                        if (_e1543 > _e1583) {
                            phi_2977_ = _e1543;
                        } else {
                            phi_2977_ = _e1583;
                        }
                        let _e1586 = phi_2977_;
                        let _e1591 = (((_e1586 - ((_e1578 * _e1466) * (0.000000059604645f * (17f / 2f)))) - (_e1578 * _e1473)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        let _e1594 = ((_e1250 * _e1244) - (_e1253 * _e1243));
                        let _e1597 = ((_e1253 * _e1242) - (_e1247 * _e1244));
                        let _e1600 = ((_e1247 * _e1243) - (_e1250 * _e1242));
                        let _e1605 = (((_e1594 * _e1256[0]) + (_e1597 * _e1256[1])) + (_e1600 * _e1256[2]));
                        let _e1610 = (((_e1594 * _e1272) + (_e1597 * _e1273)) + (_e1600 * _e1274));
                        let _e1615 = (((_e1594 * _e1275) + (_e1597 * _e1276)) + (_e1600 * _e1277));
                        let _e1620 = (((_e1594 * _e1256[0]) + (_e1597 * _e1256[1])) + (_e1600 * _e1256[2]));
                        let _e1625 = (((_e1594 * _e1280[0]) + (_e1597 * _e1280[1])) + (_e1600 * _e1280[2]));
                        let _e1630 = (((_e1594 * _e1296) + (_e1597 * _e1297)) + (_e1600 * _e1298));
                        let _e1635 = (((_e1594 * _e1299) + (_e1597 * _e1300)) + (_e1600 * _e1301));
                        let _e1640 = (((_e1594 * _e1280[0]) + (_e1597 * _e1280[1])) + (_e1600 * _e1280[2]));
                        if (_e1605 < _e1610) {
                            phi_3048_ = _e1605;
                        } else {
                            phi_3048_ = _e1610;
                        }
                        let _e1643 = phi_3048_;
                        if (_e1615 < _e1620) {
                            phi_3053_ = _e1615;
                        } else {
                            phi_3053_ = _e1620;
                        }
                        let _e1646 = phi_3053_;
                        if (_e1643 < _e1646) {
                            phi_3058_ = _e1643;
                        } else {
                            phi_3058_ = _e1646;
                        }
                        let _e1649 = phi_3058_;
                        if (_e1625 < _e1630) {
                            phi_3063_ = _e1625;
                        } else {
                            phi_3063_ = _e1630;
                        }
                        let _e1652 = phi_3063_;
                        if (_e1635 < _e1640) {
                            phi_3068_ = _e1635;
                        } else {
                            phi_3068_ = _e1640;
                        }
                        let _e1655 = phi_3068_;
                        if (_e1652 < _e1655) {
                            phi_3073_ = _e1652;
                        } else {
                            phi_3073_ = _e1655;
                        }
                        let _e1658 = phi_3073_;
                        if (_e1649 < _e1658) {
                            phi_3078_ = _e1649;
                        } else {
                            phi_3078_ = _e1658;
                        }
                        let _e1661 = phi_3078_;
                        if (_e1605 > _e1610) {
                            phi_3083_ = _e1605;
                        } else {
                            phi_3083_ = _e1610;
                        }
                        let _e1664 = phi_3083_;
                        if (_e1615 > _e1620) {
                            phi_3088_ = _e1615;
                        } else {
                            phi_3088_ = _e1620;
                        }
                        let _e1667 = phi_3088_;
                        if (_e1664 > _e1667) {
                            phi_3093_ = _e1664;
                        } else {
                            phi_3093_ = _e1667;
                        }
                        let _e1670 = phi_3093_;
                        if (_e1625 > _e1630) {
                            phi_3098_ = _e1625;
                        } else {
                            phi_3098_ = _e1630;
                        }
                        let _e1673 = phi_3098_;
                        if (_e1635 > _e1640) {
                            phi_3103_ = _e1635;
                        } else {
                            phi_3103_ = _e1640;
                        }
                        let _e1676 = phi_3103_;
                        if (_e1673 > _e1676) {
                            phi_3108_ = _e1673;
                        } else {
                            phi_3108_ = _e1676;
                        }
                        let _e1679 = phi_3108_;
                        if (_e1670 > _e1679) {
                            phi_3113_ = _e1670;
                        } else {
                            phi_3113_ = _e1679;
                        }
                        let _e1682 = phi_3113_;
                        if (_e1594 < 0f) {
                            phi_3119_ = -(_e1594);
                        } else {
                            phi_3119_ = _e1594;
                        }
                        let _e1686 = phi_3119_;
                        if (_e1597 < 0f) {
                            phi_3125_ = -(_e1597);
                        } else {
                            phi_3125_ = _e1597;
                        }
                        let _e1690 = phi_3125_;
                        if (_e1600 < 0f) {
                            phi_3132_ = -(_e1600);
                        } else {
                            phi_3132_ = _e1600;
                        }
                        let _e1695 = phi_3132_;
                        let _e1696 = ((_e1686 + _e1690) + _e1695);
                        let _e1701 = -(_e1682);
                        if (_e1661 > _e1701) {
                            phi_3143_ = _e1661;
                        } else {
                            phi_3143_ = _e1701;
                        }
                        let _e1704 = phi_3143_;
                        let _e1709 = (((_e1704 - ((_e1696 * _e1466) * (0.000000059604645f * (17f / 2f)))) - (_e1696 * _e1473)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        if (_e1591 > _e1709) {
                            phi_3153_ = _e1591;
                        } else {
                            phi_3153_ = _e1709;
                        }
                        let _e1712 = phi_3153_;
                        let _e1713 = (_e1242 - _e1227);
                        let _e1714 = (_e1243 - _e1228);
                        let _e1715 = (_e1244 - _e1229);
                        let _e1718 = ((_e1250 * _e1715) - (_e1253 * _e1714));
                        let _e1721 = ((_e1253 * _e1713) - (_e1247 * _e1715));
                        let _e1724 = ((_e1247 * _e1714) - (_e1250 * _e1713));
                        let _e1729 = (((_e1718 * _e1256[0]) + (_e1721 * _e1256[1])) + (_e1724 * _e1256[2]));
                        let _e1734 = (((_e1718 * _e1272) + (_e1721 * _e1273)) + (_e1724 * _e1274));
                        let _e1739 = (((_e1718 * _e1275) + (_e1721 * _e1276)) + (_e1724 * _e1277));
                        let _e1744 = (((_e1718 * _e1256[0]) + (_e1721 * _e1256[1])) + (_e1724 * _e1256[2]));
                        let _e1749 = (((_e1718 * _e1280[0]) + (_e1721 * _e1280[1])) + (_e1724 * _e1280[2]));
                        let _e1754 = (((_e1718 * _e1296) + (_e1721 * _e1297)) + (_e1724 * _e1298));
                        let _e1759 = (((_e1718 * _e1299) + (_e1721 * _e1300)) + (_e1724 * _e1301));
                        let _e1764 = (((_e1718 * _e1280[0]) + (_e1721 * _e1280[1])) + (_e1724 * _e1280[2]));
                        if (_e1729 < _e1734) {
                            phi_3226_ = _e1729;
                        } else {
                            phi_3226_ = _e1734;
                        }
                        let _e1767 = phi_3226_;
                        if (_e1739 < _e1744) {
                            phi_3231_ = _e1739;
                        } else {
                            phi_3231_ = _e1744;
                        }
                        let _e1770 = phi_3231_;
                        if (_e1767 < _e1770) {
                            phi_3236_ = _e1767;
                        } else {
                            phi_3236_ = _e1770;
                        }
                        let _e1773 = phi_3236_;
                        if (_e1749 < _e1754) {
                            phi_3241_ = _e1749;
                        } else {
                            phi_3241_ = _e1754;
                        }
                        let _e1776 = phi_3241_;
                        if (_e1759 < _e1764) {
                            phi_3246_ = _e1759;
                        } else {
                            phi_3246_ = _e1764;
                        }
                        let _e1779 = phi_3246_;
                        if (_e1776 < _e1779) {
                            phi_3251_ = _e1776;
                        } else {
                            phi_3251_ = _e1779;
                        }
                        let _e1782 = phi_3251_;
                        if (_e1773 < _e1782) {
                            phi_3256_ = _e1773;
                        } else {
                            phi_3256_ = _e1782;
                        }
                        let _e1785 = phi_3256_;
                        if (_e1729 > _e1734) {
                            phi_3261_ = _e1729;
                        } else {
                            phi_3261_ = _e1734;
                        }
                        let _e1788 = phi_3261_;
                        if (_e1739 > _e1744) {
                            phi_3266_ = _e1739;
                        } else {
                            phi_3266_ = _e1744;
                        }
                        let _e1791 = phi_3266_;
                        if (_e1788 > _e1791) {
                            phi_3271_ = _e1788;
                        } else {
                            phi_3271_ = _e1791;
                        }
                        let _e1794 = phi_3271_;
                        if (_e1749 > _e1754) {
                            phi_3276_ = _e1749;
                        } else {
                            phi_3276_ = _e1754;
                        }
                        let _e1797 = phi_3276_;
                        if (_e1759 > _e1764) {
                            phi_3281_ = _e1759;
                        } else {
                            phi_3281_ = _e1764;
                        }
                        let _e1800 = phi_3281_;
                        if (_e1797 > _e1800) {
                            phi_3286_ = _e1797;
                        } else {
                            phi_3286_ = _e1800;
                        }
                        let _e1803 = phi_3286_;
                        if (_e1794 > _e1803) {
                            phi_3291_ = _e1794;
                        } else {
                            phi_3291_ = _e1803;
                        }
                        let _e1806 = phi_3291_;
                        if (_e1718 < 0f) {
                            phi_3297_ = -(_e1718);
                        } else {
                            phi_3297_ = _e1718;
                        }
                        let _e1810 = phi_3297_;
                        if (_e1721 < 0f) {
                            phi_3303_ = -(_e1721);
                        } else {
                            phi_3303_ = _e1721;
                        }
                        let _e1814 = phi_3303_;
                        if (_e1724 < 0f) {
                            phi_3310_ = -(_e1724);
                        } else {
                            phi_3310_ = _e1724;
                        }
                        let _e1819 = phi_3310_;
                        let _e1820 = ((_e1810 + _e1814) + _e1819);
                        let _e1825 = -(_e1806);
                        if (_e1785 > _e1825) {
                            phi_3321_ = _e1785;
                        } else {
                            phi_3321_ = _e1825;
                        }
                        let _e1828 = phi_3321_;
                        let _e1833 = (((_e1828 - ((_e1820 * _e1466) * (0.000000059604645f * (17f / 2f)))) - (_e1820 * _e1473)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        if (_e1712 > _e1833) {
                            phi_3331_ = _e1712;
                        } else {
                            phi_3331_ = _e1833;
                        }
                        let _e1836 = phi_3331_;
                        phi_3335_ = (_e1214 || (_e1836 > 0f));
                    }
                    let _e1840 = phi_3335_;
                    if _e1840 {
                        phi_6752_ = _e1840;
                    } else {
                        let _e1843 = local_2.member[0u];
                        let _e1849 = local_2.member[1u];
                        let _e1856 = ((_e1843[0] + _e1849[0]) * 0.5f);
                        let _e1857 = ((_e1843[1] + _e1849[1]) * 0.5f);
                        let _e1858 = ((_e1843[2] + _e1849[2]) * 0.5f);
                        let _e1861 = local_2.member_1[0u];
                        let _e1867 = local_2.member_1[1u];
                        let _e1874 = ((_e1861[0] + _e1867[0]) * 0.5f);
                        let _e1875 = ((_e1861[1] + _e1867[1]) * 0.5f);
                        let _e1876 = ((_e1861[2] + _e1867[2]) * 0.5f);
                        let _e1879 = local_2.member_2[0u];
                        let _e1885 = local_2.member_2[1u];
                        let _e1892 = ((_e1879[0] + _e1885[0]) * 0.5f);
                        let _e1893 = ((_e1879[1] + _e1885[1]) * 0.5f);
                        let _e1894 = ((_e1879[2] + _e1885[2]) * 0.5f);
                        let _e1897 = local_2.member[0u];
                        let _e1900 = local_2.member_1[0u];
                        let _e1903 = local_2.member_2[0u];
                        let _e1905 = local_2.member_3;
                        let _e1908 = local_2.member[1u];
                        let _e1911 = local_2.member_1[1u];
                        let _e1914 = local_2.member_2[1u];
                        let _e1916 = local_2.member_3;
                        local = type_28(array<array<f32, 3>, 2>(_e1897, array<f32, 3>(_e1856, _e1857, _e1858)), array<array<f32, 3>, 2>(_e1900, array<f32, 3>(_e1874, _e1875, _e1876)), array<array<f32, 3>, 2>(_e1903, array<f32, 3>(_e1892, _e1893, _e1894)), _e1905);
                        local_1 = type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e1856, _e1857, _e1858), _e1908), array<array<f32, 3>, 2>(array<f32, 3>(_e1874, _e1875, _e1876), _e1911), array<array<f32, 3>, 2>(array<f32, 3>(_e1892, _e1893, _e1894), _e1914), _e1916);
                        let _e1933 = local.member_1[0u];
                        let _e1939 = local.member_2[0u];
                        let _e1945 = ((_e1933[1] * _e1939[2]) - (_e1933[2] * _e1939[1]));
                        let _e1948 = ((_e1933[2] * _e1939[0]) - (_e1933[0] * _e1939[2]));
                        let _e1951 = ((_e1933[0] * _e1939[1]) - (_e1933[1] * _e1939[0]));
                        let _e1954 = local.member_1[1u];
                        let _e1960 = local.member_2[1u];
                        let _e1966 = ((_e1954[1] * _e1960[2]) - (_e1954[2] * _e1960[1]));
                        let _e1969 = ((_e1954[2] * _e1960[0]) - (_e1954[0] * _e1960[2]));
                        let _e1972 = ((_e1954[0] * _e1960[1]) - (_e1954[1] * _e1960[0]));
                        let _e1975 = local.member_1[0u];
                        let _e1981 = local.member_2[1u];
                        let _e1996 = local.member_1[1u];
                        let _e2002 = local.member_2[0u];
                        let _e2015 = (((_e1975[1] * _e1981[2]) - (_e1975[2] * _e1981[1])) + ((_e1996[1] * _e2002[2]) - (_e1996[2] * _e2002[1])));
                        let _e2016 = (((_e1975[2] * _e1981[0]) - (_e1975[0] * _e1981[2])) + ((_e1996[2] * _e2002[0]) - (_e1996[0] * _e2002[2])));
                        let _e2017 = (((_e1975[0] * _e1981[1]) - (_e1975[1] * _e1981[0])) + ((_e1996[0] * _e2002[1]) - (_e1996[1] * _e2002[0])));
                        let _e2020 = local.member[0u];
                        let _e2031 = local.member[1u];
                        let _e2042 = local.member[0u];
                        let _e2051 = ((((_e2031[0] * _e1945) + (_e2031[1] * _e1948)) + (_e2031[2] * _e1951)) + (((_e2042[0] * _e2015) + (_e2042[1] * _e2016)) + (_e2042[2] * _e2017)));
                        let _e2054 = local.member[0u];
                        let _e2065 = local.member[1u];
                        let _e2074 = ((((_e2054[0] * _e1966) + (_e2054[1] * _e1969)) + (_e2054[2] * _e1972)) + (((_e2065[0] * _e2015) + (_e2065[1] * _e2016)) + (_e2065[2] * _e2017)));
                        let _e2077 = local.member[1u];
                        let _e2088 = local.member[0u];
                        if (_e2088[0] < 0f) {
                            phi_3787_ = -(_e2088[0]);
                        } else {
                            phi_3787_ = _e2088[0];
                        }
                        let _e2095 = phi_3787_;
                        if (_e2088[1] < 0f) {
                            phi_3794_ = -(_e2088[1]);
                        } else {
                            phi_3794_ = _e2088[1];
                        }
                        let _e2099 = phi_3794_;
                        if (_e2095 > _e2099) {
                            phi_3799_ = _e2095;
                        } else {
                            phi_3799_ = _e2099;
                        }
                        let _e2102 = phi_3799_;
                        if (_e2088[2] < 0f) {
                            phi_3806_ = -(_e2088[2]);
                        } else {
                            phi_3806_ = _e2088[2];
                        }
                        let _e2106 = phi_3806_;
                        if (_e2102 > _e2106) {
                            phi_3811_ = _e2102;
                        } else {
                            phi_3811_ = _e2106;
                        }
                        let _e2109 = phi_3811_;
                        let _e2112 = local.member[1u];
                        if (_e2112[0] < 0f) {
                            phi_3824_ = -(_e2112[0]);
                        } else {
                            phi_3824_ = _e2112[0];
                        }
                        let _e2119 = phi_3824_;
                        if (_e2112[1] < 0f) {
                            phi_3831_ = -(_e2112[1]);
                        } else {
                            phi_3831_ = _e2112[1];
                        }
                        let _e2123 = phi_3831_;
                        if (_e2119 > _e2123) {
                            phi_3836_ = _e2119;
                        } else {
                            phi_3836_ = _e2123;
                        }
                        let _e2126 = phi_3836_;
                        if (_e2112[2] < 0f) {
                            phi_3843_ = -(_e2112[2]);
                        } else {
                            phi_3843_ = _e2112[2];
                        }
                        let _e2130 = phi_3843_;
                        if (_e2126 > _e2130) {
                            phi_3848_ = _e2126;
                        } else {
                            phi_3848_ = _e2130;
                        }
                        let _e2133 = phi_3848_;
                        if (_e2109 > _e2133) {
                            phi_3853_ = _e2109;
                        } else {
                            phi_3853_ = _e2133;
                        }
                        let _e2136 = phi_3853_;
                        let _e2138 = local.member_3;
                        let _e2139 = (_e2136 + _e2138);
                        let _e2142 = local.member_1[0u];
                        if (_e2142[0] < 0f) {
                            phi_3870_ = -(_e2142[0]);
                        } else {
                            phi_3870_ = _e2142[0];
                        }
                        let _e2149 = phi_3870_;
                        if (_e2142[1] < 0f) {
                            phi_3877_ = -(_e2142[1]);
                        } else {
                            phi_3877_ = _e2142[1];
                        }
                        let _e2153 = phi_3877_;
                        if (_e2149 > _e2153) {
                            phi_3882_ = _e2149;
                        } else {
                            phi_3882_ = _e2153;
                        }
                        let _e2156 = phi_3882_;
                        if (_e2142[2] < 0f) {
                            phi_3889_ = -(_e2142[2]);
                        } else {
                            phi_3889_ = _e2142[2];
                        }
                        let _e2160 = phi_3889_;
                        if (_e2156 > _e2160) {
                            phi_3894_ = _e2156;
                        } else {
                            phi_3894_ = _e2160;
                        }
                        let _e2163 = phi_3894_;
                        let _e2166 = local.member_1[1u];
                        if (_e2166[0] < 0f) {
                            phi_3908_ = -(_e2166[0]);
                        } else {
                            phi_3908_ = _e2166[0];
                        }
                        let _e2173 = phi_3908_;
                        if (_e2166[1] < 0f) {
                            phi_3915_ = -(_e2166[1]);
                        } else {
                            phi_3915_ = _e2166[1];
                        }
                        let _e2177 = phi_3915_;
                        if (_e2173 > _e2177) {
                            phi_3920_ = _e2173;
                        } else {
                            phi_3920_ = _e2177;
                        }
                        let _e2180 = phi_3920_;
                        if (_e2166[2] < 0f) {
                            phi_3927_ = -(_e2166[2]);
                        } else {
                            phi_3927_ = _e2166[2];
                        }
                        let _e2184 = phi_3927_;
                        if (_e2180 > _e2184) {
                            phi_3932_ = _e2180;
                        } else {
                            phi_3932_ = _e2184;
                        }
                        let _e2187 = phi_3932_;
                        if (_e2163 > _e2187) {
                            phi_3937_ = _e2163;
                        } else {
                            phi_3937_ = _e2187;
                        }
                        let _e2190 = phi_3937_;
                        let _e2192 = local.member_3;
                        let _e2193 = (_e2190 + _e2192);
                        let _e2196 = local.member_2[0u];
                        if (_e2196[0] < 0f) {
                            phi_3954_ = -(_e2196[0]);
                        } else {
                            phi_3954_ = _e2196[0];
                        }
                        let _e2203 = phi_3954_;
                        if (_e2196[1] < 0f) {
                            phi_3961_ = -(_e2196[1]);
                        } else {
                            phi_3961_ = _e2196[1];
                        }
                        let _e2207 = phi_3961_;
                        if (_e2203 > _e2207) {
                            phi_3966_ = _e2203;
                        } else {
                            phi_3966_ = _e2207;
                        }
                        let _e2210 = phi_3966_;
                        if (_e2196[2] < 0f) {
                            phi_3973_ = -(_e2196[2]);
                        } else {
                            phi_3973_ = _e2196[2];
                        }
                        let _e2214 = phi_3973_;
                        if (_e2210 > _e2214) {
                            phi_3978_ = _e2210;
                        } else {
                            phi_3978_ = _e2214;
                        }
                        let _e2217 = phi_3978_;
                        let _e2220 = local.member_2[1u];
                        if (_e2220[0] < 0f) {
                            phi_3992_ = -(_e2220[0]);
                        } else {
                            phi_3992_ = _e2220[0];
                        }
                        let _e2227 = phi_3992_;
                        if (_e2220[1] < 0f) {
                            phi_3999_ = -(_e2220[1]);
                        } else {
                            phi_3999_ = _e2220[1];
                        }
                        let _e2231 = phi_3999_;
                        if (_e2227 > _e2231) {
                            phi_4004_ = _e2227;
                        } else {
                            phi_4004_ = _e2231;
                        }
                        let _e2234 = phi_4004_;
                        if (_e2220[2] < 0f) {
                            phi_4011_ = -(_e2220[2]);
                        } else {
                            phi_4011_ = _e2220[2];
                        }
                        let _e2238 = phi_4011_;
                        if (_e2234 > _e2238) {
                            phi_4016_ = _e2234;
                        } else {
                            phi_4016_ = _e2238;
                        }
                        let _e2241 = phi_4016_;
                        if (_e2217 > _e2241) {
                            phi_4021_ = _e2217;
                        } else {
                            phi_4021_ = _e2241;
                        }
                        let _e2244 = phi_4021_;
                        let _e2246 = local.member_3;
                        let _e2247 = (_e2244 + _e2246);
                        let _e2249 = ((_e2193 * 8f) * _e2247);
                        let _e2256 = local.member_3;
                        if (_e1945 < 0f) {
                            phi_4052_ = -(_e1945);
                        } else {
                            phi_4052_ = _e1945;
                        }
                        let _e2273 = phi_4052_;
                        if (_e1948 < 0f) {
                            phi_4058_ = -(_e1948);
                        } else {
                            phi_4058_ = _e1948;
                        }
                        let _e2277 = phi_4058_;
                        if (_e1951 < 0f) {
                            phi_4065_ = -(_e1951);
                        } else {
                            phi_4065_ = _e1951;
                        }
                        let _e2282 = phi_4065_;
                        let _e2283 = ((_e2273 + _e2277) + _e2282);
                        if (_e1966 < 0f) {
                            phi_4072_ = -(_e1966);
                        } else {
                            phi_4072_ = _e1966;
                        }
                        let _e2287 = phi_4072_;
                        if (_e1969 < 0f) {
                            phi_4078_ = -(_e1969);
                        } else {
                            phi_4078_ = _e1969;
                        }
                        let _e2291 = phi_4078_;
                        if (_e1972 < 0f) {
                            phi_4085_ = -(_e1972);
                        } else {
                            phi_4085_ = _e1972;
                        }
                        let _e2296 = phi_4085_;
                        let _e2297 = ((_e2287 + _e2291) + _e2296);
                        if (_e2283 > _e2297) {
                            phi_4091_ = _e2283;
                        } else {
                            phi_4091_ = _e2297;
                        }
                        let _e2300 = phi_4091_;
                        if (_e2015 < 0f) {
                            phi_4097_ = -(_e2015);
                        } else {
                            phi_4097_ = _e2015;
                        }
                        let _e2304 = phi_4097_;
                        if (_e2016 < 0f) {
                            phi_4103_ = -(_e2016);
                        } else {
                            phi_4103_ = _e2016;
                        }
                        let _e2308 = phi_4103_;
                        if (_e2017 < 0f) {
                            phi_4110_ = -(_e2017);
                        } else {
                            phi_4110_ = _e2017;
                        }
                        let _e2313 = phi_4110_;
                        let _e2315 = (((_e2304 + _e2308) + _e2313) * 0.5f);
                        if (_e2300 > _e2315) {
                            phi_4117_ = _e2300;
                        } else {
                            phi_4117_ = _e2315;
                        }
                        let _e2318 = phi_4117_;
                        let _e2323 = local.member_3;
                        let _e2336 = ((((_e2020[0] * _e1945) + (_e2020[1] * _e1948)) + (_e2020[2] * _e1951)) * 3f);
                        let _e2337 = ((((_e2077[0] * _e1966) + (_e2077[1] * _e1969)) + (_e2077[2] * _e1972)) * 3f);
                        if (_e2336 < _e2337) {
                            phi_4141_ = _e2336;
                        } else {
                            phi_4141_ = _e2337;
                        }
                        let _e2340 = phi_4141_;
                        if (_e2051 < _e2074) {
                            phi_4146_ = _e2051;
                        } else {
                            phi_4146_ = _e2074;
                        }
                        let _e2343 = phi_4146_;
                        if (_e2340 < _e2343) {
                            phi_4151_ = _e2340;
                        } else {
                            phi_4151_ = _e2343;
                        }
                        let _e2346 = phi_4151_;
                        if (_e2336 > _e2337) {
                            phi_4156_ = _e2336;
                        } else {
                            phi_4156_ = _e2337;
                        }
                        let _e2349 = phi_4156_;
                        if (_e2051 > _e2074) {
                            phi_4161_ = _e2051;
                        } else {
                            phi_4161_ = _e2074;
                        }
                        let _e2352 = phi_4161_;
                        if (_e2349 > _e2352) {
                            phi_4166_ = _e2349;
                        } else {
                            phi_4166_ = _e2352;
                        }
                        let _e2355 = phi_4166_;
                        let _e2360 = -(_e2355);
                        if (_e2346 > _e2360) {
                            phi_4176_ = _e2346;
                        } else {
                            phi_4176_ = _e2360;
                        }
                        let _e2363 = phi_4176_;
                        let _e2365 = ((_e2363 - ((((((_e2139 * 8f) * _e2249) * (0.000000059604645f * (524f / 64f))) + ((_e2256 * 19f) * ((_e2139 * (_e2193 + _e2247)) + (_e2193 * _e2247)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2139) * ((1f + _e2193) * (1f + _e2247))))) + ((_e707 * (((_e2318 + (_e2249 * (0.000000059604645f * 8f))) + ((_e2323 * 6f) * (_e2193 + _e2247))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2193) * (1f + _e2247))))) * (3f * 1.0001f)))) > 0f);
                        if _e2365 {
                            phi_5145_ = _e2365;
                        } else {
                            let _e2368 = local.member_1[0u];
                            let _e2374 = local.member_1[1u];
                            let _e2378 = (_e2368[0] + _e2374[0]);
                            let _e2379 = (_e2368[1] + _e2374[1]);
                            let _e2380 = (_e2368[2] + _e2374[2]);
                            let _e2383 = local.member_2[0u];
                            let _e2389 = local.member_2[1u];
                            let _e2393 = (_e2383[0] + _e2389[0]);
                            let _e2394 = (_e2383[1] + _e2389[1]);
                            let _e2395 = (_e2383[2] + _e2389[2]);
                            let _e2398 = ((_e2379 * _e2395) - (_e2380 * _e2394));
                            let _e2401 = ((_e2380 * _e2393) - (_e2378 * _e2395));
                            let _e2404 = ((_e2378 * _e2394) - (_e2379 * _e2393));
                            let _e2407 = local.member[0u];
                            let _e2413 = local.member_1[0u];
                            let _e2419 = local.member_2[0u];
                            let _e2423 = (_e2407[0] - _e2413[0]);
                            let _e2424 = (_e2407[1] - _e2413[1]);
                            let _e2425 = (_e2407[2] - _e2413[2]);
                            let _e2426 = (_e2407[0] - _e2419[0]);
                            let _e2427 = (_e2407[1] - _e2419[1]);
                            let _e2428 = (_e2407[2] - _e2419[2]);
                            let _e2431 = local.member[1u];
                            let _e2437 = local.member_1[1u];
                            let _e2443 = local.member_2[1u];
                            let _e2447 = (_e2431[0] - _e2437[0]);
                            let _e2448 = (_e2431[1] - _e2437[1]);
                            let _e2449 = (_e2431[2] - _e2437[2]);
                            let _e2450 = (_e2431[0] - _e2443[0]);
                            let _e2451 = (_e2431[1] - _e2443[1]);
                            let _e2452 = (_e2431[2] - _e2443[2]);
                            let _e2455 = local.member[0u];
                            if (_e2455[0] < 0f) {
                                phi_4379_ = -(_e2455[0]);
                            } else {
                                phi_4379_ = _e2455[0];
                            }
                            let _e2462 = phi_4379_;
                            if (_e2455[1] < 0f) {
                                phi_4386_ = -(_e2455[1]);
                            } else {
                                phi_4386_ = _e2455[1];
                            }
                            let _e2466 = phi_4386_;
                            if (_e2462 > _e2466) {
                                phi_4391_ = _e2462;
                            } else {
                                phi_4391_ = _e2466;
                            }
                            let _e2469 = phi_4391_;
                            if (_e2455[2] < 0f) {
                                phi_4398_ = -(_e2455[2]);
                            } else {
                                phi_4398_ = _e2455[2];
                            }
                            let _e2473 = phi_4398_;
                            if (_e2469 > _e2473) {
                                phi_4403_ = _e2469;
                            } else {
                                phi_4403_ = _e2473;
                            }
                            let _e2476 = phi_4403_;
                            let _e2479 = local.member[1u];
                            if (_e2479[0] < 0f) {
                                phi_4416_ = -(_e2479[0]);
                            } else {
                                phi_4416_ = _e2479[0];
                            }
                            let _e2486 = phi_4416_;
                            if (_e2479[1] < 0f) {
                                phi_4423_ = -(_e2479[1]);
                            } else {
                                phi_4423_ = _e2479[1];
                            }
                            let _e2490 = phi_4423_;
                            if (_e2486 > _e2490) {
                                phi_4428_ = _e2486;
                            } else {
                                phi_4428_ = _e2490;
                            }
                            let _e2493 = phi_4428_;
                            if (_e2479[2] < 0f) {
                                phi_4435_ = -(_e2479[2]);
                            } else {
                                phi_4435_ = _e2479[2];
                            }
                            let _e2497 = phi_4435_;
                            if (_e2493 > _e2497) {
                                phi_4440_ = _e2493;
                            } else {
                                phi_4440_ = _e2497;
                            }
                            let _e2500 = phi_4440_;
                            if (_e2476 > _e2500) {
                                phi_4445_ = _e2476;
                            } else {
                                phi_4445_ = _e2500;
                            }
                            let _e2503 = phi_4445_;
                            let _e2505 = local.member_3;
                            let _e2509 = local.member_1[0u];
                            if (_e2509[0] < 0f) {
                                phi_4462_ = -(_e2509[0]);
                            } else {
                                phi_4462_ = _e2509[0];
                            }
                            let _e2516 = phi_4462_;
                            if (_e2509[1] < 0f) {
                                phi_4469_ = -(_e2509[1]);
                            } else {
                                phi_4469_ = _e2509[1];
                            }
                            let _e2520 = phi_4469_;
                            if (_e2516 > _e2520) {
                                phi_4474_ = _e2516;
                            } else {
                                phi_4474_ = _e2520;
                            }
                            let _e2523 = phi_4474_;
                            if (_e2509[2] < 0f) {
                                phi_4481_ = -(_e2509[2]);
                            } else {
                                phi_4481_ = _e2509[2];
                            }
                            let _e2527 = phi_4481_;
                            if (_e2523 > _e2527) {
                                phi_4486_ = _e2523;
                            } else {
                                phi_4486_ = _e2527;
                            }
                            let _e2530 = phi_4486_;
                            let _e2533 = local.member_1[1u];
                            if (_e2533[0] < 0f) {
                                phi_4500_ = -(_e2533[0]);
                            } else {
                                phi_4500_ = _e2533[0];
                            }
                            let _e2540 = phi_4500_;
                            if (_e2533[1] < 0f) {
                                phi_4507_ = -(_e2533[1]);
                            } else {
                                phi_4507_ = _e2533[1];
                            }
                            let _e2544 = phi_4507_;
                            if (_e2540 > _e2544) {
                                phi_4512_ = _e2540;
                            } else {
                                phi_4512_ = _e2544;
                            }
                            let _e2547 = phi_4512_;
                            if (_e2533[2] < 0f) {
                                phi_4519_ = -(_e2533[2]);
                            } else {
                                phi_4519_ = _e2533[2];
                            }
                            let _e2551 = phi_4519_;
                            if (_e2547 > _e2551) {
                                phi_4524_ = _e2547;
                            } else {
                                phi_4524_ = _e2551;
                            }
                            let _e2554 = phi_4524_;
                            if (_e2530 > _e2554) {
                                phi_4529_ = _e2530;
                            } else {
                                phi_4529_ = _e2554;
                            }
                            let _e2557 = phi_4529_;
                            let _e2559 = local.member_3;
                            let _e2563 = local.member_2[0u];
                            if (_e2563[0] < 0f) {
                                phi_4546_ = -(_e2563[0]);
                            } else {
                                phi_4546_ = _e2563[0];
                            }
                            let _e2570 = phi_4546_;
                            if (_e2563[1] < 0f) {
                                phi_4553_ = -(_e2563[1]);
                            } else {
                                phi_4553_ = _e2563[1];
                            }
                            let _e2574 = phi_4553_;
                            if (_e2570 > _e2574) {
                                phi_4558_ = _e2570;
                            } else {
                                phi_4558_ = _e2574;
                            }
                            let _e2577 = phi_4558_;
                            if (_e2563[2] < 0f) {
                                phi_4565_ = -(_e2563[2]);
                            } else {
                                phi_4565_ = _e2563[2];
                            }
                            let _e2581 = phi_4565_;
                            if (_e2577 > _e2581) {
                                phi_4570_ = _e2577;
                            } else {
                                phi_4570_ = _e2581;
                            }
                            let _e2584 = phi_4570_;
                            let _e2587 = local.member_2[1u];
                            if (_e2587[0] < 0f) {
                                phi_4584_ = -(_e2587[0]);
                            } else {
                                phi_4584_ = _e2587[0];
                            }
                            let _e2594 = phi_4584_;
                            if (_e2587[1] < 0f) {
                                phi_4591_ = -(_e2587[1]);
                            } else {
                                phi_4591_ = _e2587[1];
                            }
                            let _e2598 = phi_4591_;
                            if (_e2594 > _e2598) {
                                phi_4596_ = _e2594;
                            } else {
                                phi_4596_ = _e2598;
                            }
                            let _e2601 = phi_4596_;
                            if (_e2587[2] < 0f) {
                                phi_4603_ = -(_e2587[2]);
                            } else {
                                phi_4603_ = _e2587[2];
                            }
                            let _e2605 = phi_4603_;
                            if (_e2601 > _e2605) {
                                phi_4608_ = _e2601;
                            } else {
                                phi_4608_ = _e2605;
                            }
                            let _e2608 = phi_4608_;
                            if (_e2584 > _e2608) {
                                phi_4613_ = _e2584;
                            } else {
                                phi_4613_ = _e2608;
                            }
                            let _e2611 = phi_4613_;
                            let _e2613 = local.member_3;
                            let _e2617 = ((((_e2503 + _e2505) + (_e2557 + _e2559)) + (_e2611 + _e2613)) * 2f);
                            let _e2620 = local.member_3;
                            let _e2624 = (((_e707 * 1.0001f) + (_e2620 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e2627 = ((_e2401 * _e2380) - (_e2404 * _e2379));
                            let _e2630 = ((_e2404 * _e2378) - (_e2398 * _e2380));
                            let _e2633 = ((_e2398 * _e2379) - (_e2401 * _e2378));
                            let _e2638 = (((_e2627 * _e2407[0]) + (_e2630 * _e2407[1])) + (_e2633 * _e2407[2]));
                            let _e2643 = (((_e2627 * _e2423) + (_e2630 * _e2424)) + (_e2633 * _e2425));
                            let _e2648 = (((_e2627 * _e2426) + (_e2630 * _e2427)) + (_e2633 * _e2428));
                            let _e2653 = (((_e2627 * _e2407[0]) + (_e2630 * _e2407[1])) + (_e2633 * _e2407[2]));
                            let _e2658 = (((_e2627 * _e2431[0]) + (_e2630 * _e2431[1])) + (_e2633 * _e2431[2]));
                            let _e2663 = (((_e2627 * _e2447) + (_e2630 * _e2448)) + (_e2633 * _e2449));
                            let _e2668 = (((_e2627 * _e2450) + (_e2630 * _e2451)) + (_e2633 * _e2452));
                            let _e2673 = (((_e2627 * _e2431[0]) + (_e2630 * _e2431[1])) + (_e2633 * _e2431[2]));
                            if (_e2638 < _e2643) {
                                phi_4692_ = _e2638;
                            } else {
                                phi_4692_ = _e2643;
                            }
                            let _e2676 = phi_4692_;
                            if (_e2648 < _e2653) {
                                phi_4697_ = _e2648;
                            } else {
                                phi_4697_ = _e2653;
                            }
                            let _e2679 = phi_4697_;
                            if (_e2676 < _e2679) {
                                phi_4702_ = _e2676;
                            } else {
                                phi_4702_ = _e2679;
                            }
                            let _e2682 = phi_4702_;
                            if (_e2658 < _e2663) {
                                phi_4707_ = _e2658;
                            } else {
                                phi_4707_ = _e2663;
                            }
                            let _e2685 = phi_4707_;
                            if (_e2668 < _e2673) {
                                phi_4712_ = _e2668;
                            } else {
                                phi_4712_ = _e2673;
                            }
                            let _e2688 = phi_4712_;
                            if (_e2685 < _e2688) {
                                phi_4717_ = _e2685;
                            } else {
                                phi_4717_ = _e2688;
                            }
                            let _e2691 = phi_4717_;
                            if (_e2682 < _e2691) {
                                phi_4722_ = _e2682;
                            } else {
                                phi_4722_ = _e2691;
                            }
                            let _e2694 = phi_4722_;
                            if (_e2638 > _e2643) {
                                phi_4727_ = _e2638;
                            } else {
                                phi_4727_ = _e2643;
                            }
                            let _e2697 = phi_4727_;
                            if (_e2648 > _e2653) {
                                phi_4732_ = _e2648;
                            } else {
                                phi_4732_ = _e2653;
                            }
                            let _e2700 = phi_4732_;
                            if (_e2697 > _e2700) {
                                phi_4737_ = _e2697;
                            } else {
                                phi_4737_ = _e2700;
                            }
                            let _e2703 = phi_4737_;
                            if (_e2658 > _e2663) {
                                phi_4742_ = _e2658;
                            } else {
                                phi_4742_ = _e2663;
                            }
                            let _e2706 = phi_4742_;
                            if (_e2668 > _e2673) {
                                phi_4747_ = _e2668;
                            } else {
                                phi_4747_ = _e2673;
                            }
                            let _e2709 = phi_4747_;
                            if (_e2706 > _e2709) {
                                phi_4752_ = _e2706;
                            } else {
                                phi_4752_ = _e2709;
                            }
                            let _e2712 = phi_4752_;
                            if (_e2703 > _e2712) {
                                phi_4757_ = _e2703;
                            } else {
                                phi_4757_ = _e2712;
                            }
                            let _e2715 = phi_4757_;
                            if (_e2627 < 0f) {
                                phi_4763_ = -(_e2627);
                            } else {
                                phi_4763_ = _e2627;
                            }
                            let _e2719 = phi_4763_;
                            if (_e2630 < 0f) {
                                phi_4769_ = -(_e2630);
                            } else {
                                phi_4769_ = _e2630;
                            }
                            let _e2723 = phi_4769_;
                            if (_e2633 < 0f) {
                                phi_4776_ = -(_e2633);
                            } else {
                                phi_4776_ = _e2633;
                            }
                            let _e2728 = phi_4776_;
                            let _e2729 = ((_e2719 + _e2723) + _e2728);
                            let _e2734 = -(_e2715);
                            if (_e2694 > _e2734) {
                                phi_4787_ = _e2694;
                            } else {
                                phi_4787_ = _e2734;
                            }
                            let _e2737 = phi_4787_;
                            let _e2742 = (((_e2737 - ((_e2729 * _e2617) * (0.000000059604645f * (17f / 2f)))) - (_e2729 * _e2624)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2745 = ((_e2401 * _e2395) - (_e2404 * _e2394));
                            let _e2748 = ((_e2404 * _e2393) - (_e2398 * _e2395));
                            let _e2751 = ((_e2398 * _e2394) - (_e2401 * _e2393));
                            let _e2756 = (((_e2745 * _e2407[0]) + (_e2748 * _e2407[1])) + (_e2751 * _e2407[2]));
                            let _e2761 = (((_e2745 * _e2423) + (_e2748 * _e2424)) + (_e2751 * _e2425));
                            let _e2766 = (((_e2745 * _e2426) + (_e2748 * _e2427)) + (_e2751 * _e2428));
                            let _e2771 = (((_e2745 * _e2407[0]) + (_e2748 * _e2407[1])) + (_e2751 * _e2407[2]));
                            let _e2776 = (((_e2745 * _e2431[0]) + (_e2748 * _e2431[1])) + (_e2751 * _e2431[2]));
                            let _e2781 = (((_e2745 * _e2447) + (_e2748 * _e2448)) + (_e2751 * _e2449));
                            let _e2786 = (((_e2745 * _e2450) + (_e2748 * _e2451)) + (_e2751 * _e2452));
                            let _e2791 = (((_e2745 * _e2431[0]) + (_e2748 * _e2431[1])) + (_e2751 * _e2431[2]));
                            if (_e2756 < _e2761) {
                                phi_4858_ = _e2756;
                            } else {
                                phi_4858_ = _e2761;
                            }
                            let _e2794 = phi_4858_;
                            if (_e2766 < _e2771) {
                                phi_4863_ = _e2766;
                            } else {
                                phi_4863_ = _e2771;
                            }
                            let _e2797 = phi_4863_;
                            if (_e2794 < _e2797) {
                                phi_4868_ = _e2794;
                            } else {
                                phi_4868_ = _e2797;
                            }
                            let _e2800 = phi_4868_;
                            if (_e2776 < _e2781) {
                                phi_4873_ = _e2776;
                            } else {
                                phi_4873_ = _e2781;
                            }
                            let _e2803 = phi_4873_;
                            if (_e2786 < _e2791) {
                                phi_4878_ = _e2786;
                            } else {
                                phi_4878_ = _e2791;
                            }
                            let _e2806 = phi_4878_;
                            if (_e2803 < _e2806) {
                                phi_4883_ = _e2803;
                            } else {
                                phi_4883_ = _e2806;
                            }
                            let _e2809 = phi_4883_;
                            if (_e2800 < _e2809) {
                                phi_4888_ = _e2800;
                            } else {
                                phi_4888_ = _e2809;
                            }
                            let _e2812 = phi_4888_;
                            if (_e2756 > _e2761) {
                                phi_4893_ = _e2756;
                            } else {
                                phi_4893_ = _e2761;
                            }
                            let _e2815 = phi_4893_;
                            if (_e2766 > _e2771) {
                                phi_4898_ = _e2766;
                            } else {
                                phi_4898_ = _e2771;
                            }
                            let _e2818 = phi_4898_;
                            if (_e2815 > _e2818) {
                                phi_4903_ = _e2815;
                            } else {
                                phi_4903_ = _e2818;
                            }
                            let _e2821 = phi_4903_;
                            if (_e2776 > _e2781) {
                                phi_4908_ = _e2776;
                            } else {
                                phi_4908_ = _e2781;
                            }
                            let _e2824 = phi_4908_;
                            if (_e2786 > _e2791) {
                                phi_4913_ = _e2786;
                            } else {
                                phi_4913_ = _e2791;
                            }
                            let _e2827 = phi_4913_;
                            if (_e2824 > _e2827) {
                                phi_4918_ = _e2824;
                            } else {
                                phi_4918_ = _e2827;
                            }
                            let _e2830 = phi_4918_;
                            if (_e2821 > _e2830) {
                                phi_4923_ = _e2821;
                            } else {
                                phi_4923_ = _e2830;
                            }
                            let _e2833 = phi_4923_;
                            if (_e2745 < 0f) {
                                phi_4929_ = -(_e2745);
                            } else {
                                phi_4929_ = _e2745;
                            }
                            let _e2837 = phi_4929_;
                            if (_e2748 < 0f) {
                                phi_4935_ = -(_e2748);
                            } else {
                                phi_4935_ = _e2748;
                            }
                            let _e2841 = phi_4935_;
                            if (_e2751 < 0f) {
                                phi_4942_ = -(_e2751);
                            } else {
                                phi_4942_ = _e2751;
                            }
                            let _e2846 = phi_4942_;
                            let _e2847 = ((_e2837 + _e2841) + _e2846);
                            let _e2852 = -(_e2833);
                            if (_e2812 > _e2852) {
                                phi_4953_ = _e2812;
                            } else {
                                phi_4953_ = _e2852;
                            }
                            let _e2855 = phi_4953_;
                            let _e2860 = (((_e2855 - ((_e2847 * _e2617) * (0.000000059604645f * (17f / 2f)))) - (_e2847 * _e2624)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e2742 > _e2860) {
                                phi_4963_ = _e2742;
                            } else {
                                phi_4963_ = _e2860;
                            }
                            let _e2863 = phi_4963_;
                            let _e2864 = (_e2393 - _e2378);
                            let _e2865 = (_e2394 - _e2379);
                            let _e2866 = (_e2395 - _e2380);
                            let _e2869 = ((_e2401 * _e2866) - (_e2404 * _e2865));
                            let _e2872 = ((_e2404 * _e2864) - (_e2398 * _e2866));
                            let _e2875 = ((_e2398 * _e2865) - (_e2401 * _e2864));
                            let _e2880 = (((_e2869 * _e2407[0]) + (_e2872 * _e2407[1])) + (_e2875 * _e2407[2]));
                            let _e2885 = (((_e2869 * _e2423) + (_e2872 * _e2424)) + (_e2875 * _e2425));
                            let _e2890 = (((_e2869 * _e2426) + (_e2872 * _e2427)) + (_e2875 * _e2428));
                            let _e2895 = (((_e2869 * _e2407[0]) + (_e2872 * _e2407[1])) + (_e2875 * _e2407[2]));
                            let _e2900 = (((_e2869 * _e2431[0]) + (_e2872 * _e2431[1])) + (_e2875 * _e2431[2]));
                            let _e2905 = (((_e2869 * _e2447) + (_e2872 * _e2448)) + (_e2875 * _e2449));
                            let _e2910 = (((_e2869 * _e2450) + (_e2872 * _e2451)) + (_e2875 * _e2452));
                            let _e2915 = (((_e2869 * _e2431[0]) + (_e2872 * _e2431[1])) + (_e2875 * _e2431[2]));
                            if (_e2880 < _e2885) {
                                phi_5036_ = _e2880;
                            } else {
                                phi_5036_ = _e2885;
                            }
                            let _e2918 = phi_5036_;
                            if (_e2890 < _e2895) {
                                phi_5041_ = _e2890;
                            } else {
                                phi_5041_ = _e2895;
                            }
                            let _e2921 = phi_5041_;
                            if (_e2918 < _e2921) {
                                phi_5046_ = _e2918;
                            } else {
                                phi_5046_ = _e2921;
                            }
                            let _e2924 = phi_5046_;
                            if (_e2900 < _e2905) {
                                phi_5051_ = _e2900;
                            } else {
                                phi_5051_ = _e2905;
                            }
                            let _e2927 = phi_5051_;
                            if (_e2910 < _e2915) {
                                phi_5056_ = _e2910;
                            } else {
                                phi_5056_ = _e2915;
                            }
                            let _e2930 = phi_5056_;
                            if (_e2927 < _e2930) {
                                phi_5061_ = _e2927;
                            } else {
                                phi_5061_ = _e2930;
                            }
                            let _e2933 = phi_5061_;
                            if (_e2924 < _e2933) {
                                phi_5066_ = _e2924;
                            } else {
                                phi_5066_ = _e2933;
                            }
                            let _e2936 = phi_5066_;
                            if (_e2880 > _e2885) {
                                phi_5071_ = _e2880;
                            } else {
                                phi_5071_ = _e2885;
                            }
                            let _e2939 = phi_5071_;
                            if (_e2890 > _e2895) {
                                phi_5076_ = _e2890;
                            } else {
                                phi_5076_ = _e2895;
                            }
                            let _e2942 = phi_5076_;
                            if (_e2939 > _e2942) {
                                phi_5081_ = _e2939;
                            } else {
                                phi_5081_ = _e2942;
                            }
                            let _e2945 = phi_5081_;
                            if (_e2900 > _e2905) {
                                phi_5086_ = _e2900;
                            } else {
                                phi_5086_ = _e2905;
                            }
                            let _e2948 = phi_5086_;
                            if (_e2910 > _e2915) {
                                phi_5091_ = _e2910;
                            } else {
                                phi_5091_ = _e2915;
                            }
                            let _e2951 = phi_5091_;
                            if (_e2948 > _e2951) {
                                phi_5096_ = _e2948;
                            } else {
                                phi_5096_ = _e2951;
                            }
                            let _e2954 = phi_5096_;
                            if (_e2945 > _e2954) {
                                phi_5101_ = _e2945;
                            } else {
                                phi_5101_ = _e2954;
                            }
                            let _e2957 = phi_5101_;
                            if (_e2869 < 0f) {
                                phi_5107_ = -(_e2869);
                            } else {
                                phi_5107_ = _e2869;
                            }
                            let _e2961 = phi_5107_;
                            if (_e2872 < 0f) {
                                phi_5113_ = -(_e2872);
                            } else {
                                phi_5113_ = _e2872;
                            }
                            let _e2965 = phi_5113_;
                            if (_e2875 < 0f) {
                                phi_5120_ = -(_e2875);
                            } else {
                                phi_5120_ = _e2875;
                            }
                            let _e2970 = phi_5120_;
                            let _e2971 = ((_e2961 + _e2965) + _e2970);
                            let _e2976 = -(_e2957);
                            if (_e2936 > _e2976) {
                                phi_5131_ = _e2936;
                            } else {
                                phi_5131_ = _e2976;
                            }
                            let _e2979 = phi_5131_;
                            let _e2984 = (((_e2979 - ((_e2971 * _e2617) * (0.000000059604645f * (17f / 2f)))) - (_e2971 * _e2624)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e2863 > _e2984) {
                                phi_5141_ = _e2863;
                            } else {
                                phi_5141_ = _e2984;
                            }
                            let _e2987 = phi_5141_;
                            phi_5145_ = (_e2365 || (_e2987 > 0f));
                        }
                        let _e2991 = phi_5145_;
                        if _e2991 {
                            let _e2994 = local_1.member_1[0u];
                            let _e3000 = local_1.member_2[0u];
                            let _e3006 = ((_e2994[1] * _e3000[2]) - (_e2994[2] * _e3000[1]));
                            let _e3009 = ((_e2994[2] * _e3000[0]) - (_e2994[0] * _e3000[2]));
                            let _e3012 = ((_e2994[0] * _e3000[1]) - (_e2994[1] * _e3000[0]));
                            let _e3015 = local_1.member_1[1u];
                            let _e3021 = local_1.member_2[1u];
                            let _e3027 = ((_e3015[1] * _e3021[2]) - (_e3015[2] * _e3021[1]));
                            let _e3030 = ((_e3015[2] * _e3021[0]) - (_e3015[0] * _e3021[2]));
                            let _e3033 = ((_e3015[0] * _e3021[1]) - (_e3015[1] * _e3021[0]));
                            let _e3036 = local_1.member_1[0u];
                            let _e3042 = local_1.member_2[1u];
                            let _e3057 = local_1.member_1[1u];
                            let _e3063 = local_1.member_2[0u];
                            let _e3076 = (((_e3036[1] * _e3042[2]) - (_e3036[2] * _e3042[1])) + ((_e3057[1] * _e3063[2]) - (_e3057[2] * _e3063[1])));
                            let _e3077 = (((_e3036[2] * _e3042[0]) - (_e3036[0] * _e3042[2])) + ((_e3057[2] * _e3063[0]) - (_e3057[0] * _e3063[2])));
                            let _e3078 = (((_e3036[0] * _e3042[1]) - (_e3036[1] * _e3042[0])) + ((_e3057[0] * _e3063[1]) - (_e3057[1] * _e3063[0])));
                            let _e3081 = local_1.member[0u];
                            let _e3092 = local_1.member[1u];
                            let _e3103 = local_1.member[0u];
                            let _e3112 = ((((_e3092[0] * _e3006) + (_e3092[1] * _e3009)) + (_e3092[2] * _e3012)) + (((_e3103[0] * _e3076) + (_e3103[1] * _e3077)) + (_e3103[2] * _e3078)));
                            let _e3115 = local_1.member[0u];
                            let _e3126 = local_1.member[1u];
                            let _e3135 = ((((_e3115[0] * _e3027) + (_e3115[1] * _e3030)) + (_e3115[2] * _e3033)) + (((_e3126[0] * _e3076) + (_e3126[1] * _e3077)) + (_e3126[2] * _e3078)));
                            let _e3138 = local_1.member[1u];
                            let _e3149 = local_1.member[0u];
                            if (_e3149[0] < 0f) {
                                phi_5390_ = -(_e3149[0]);
                            } else {
                                phi_5390_ = _e3149[0];
                            }
                            let _e3156 = phi_5390_;
                            if (_e3149[1] < 0f) {
                                phi_5397_ = -(_e3149[1]);
                            } else {
                                phi_5397_ = _e3149[1];
                            }
                            let _e3160 = phi_5397_;
                            if (_e3156 > _e3160) {
                                phi_5402_ = _e3156;
                            } else {
                                phi_5402_ = _e3160;
                            }
                            let _e3163 = phi_5402_;
                            if (_e3149[2] < 0f) {
                                phi_5409_ = -(_e3149[2]);
                            } else {
                                phi_5409_ = _e3149[2];
                            }
                            let _e3167 = phi_5409_;
                            if (_e3163 > _e3167) {
                                phi_5414_ = _e3163;
                            } else {
                                phi_5414_ = _e3167;
                            }
                            let _e3170 = phi_5414_;
                            let _e3173 = local_1.member[1u];
                            if (_e3173[0] < 0f) {
                                phi_5427_ = -(_e3173[0]);
                            } else {
                                phi_5427_ = _e3173[0];
                            }
                            let _e3180 = phi_5427_;
                            if (_e3173[1] < 0f) {
                                phi_5434_ = -(_e3173[1]);
                            } else {
                                phi_5434_ = _e3173[1];
                            }
                            let _e3184 = phi_5434_;
                            if (_e3180 > _e3184) {
                                phi_5439_ = _e3180;
                            } else {
                                phi_5439_ = _e3184;
                            }
                            let _e3187 = phi_5439_;
                            if (_e3173[2] < 0f) {
                                phi_5446_ = -(_e3173[2]);
                            } else {
                                phi_5446_ = _e3173[2];
                            }
                            let _e3191 = phi_5446_;
                            if (_e3187 > _e3191) {
                                phi_5451_ = _e3187;
                            } else {
                                phi_5451_ = _e3191;
                            }
                            let _e3194 = phi_5451_;
                            if (_e3170 > _e3194) {
                                phi_5456_ = _e3170;
                            } else {
                                phi_5456_ = _e3194;
                            }
                            let _e3197 = phi_5456_;
                            let _e3199 = local_1.member_3;
                            let _e3200 = (_e3197 + _e3199);
                            let _e3203 = local_1.member_1[0u];
                            if (_e3203[0] < 0f) {
                                phi_5473_ = -(_e3203[0]);
                            } else {
                                phi_5473_ = _e3203[0];
                            }
                            let _e3210 = phi_5473_;
                            if (_e3203[1] < 0f) {
                                phi_5480_ = -(_e3203[1]);
                            } else {
                                phi_5480_ = _e3203[1];
                            }
                            let _e3214 = phi_5480_;
                            if (_e3210 > _e3214) {
                                phi_5485_ = _e3210;
                            } else {
                                phi_5485_ = _e3214;
                            }
                            let _e3217 = phi_5485_;
                            if (_e3203[2] < 0f) {
                                phi_5492_ = -(_e3203[2]);
                            } else {
                                phi_5492_ = _e3203[2];
                            }
                            let _e3221 = phi_5492_;
                            if (_e3217 > _e3221) {
                                phi_5497_ = _e3217;
                            } else {
                                phi_5497_ = _e3221;
                            }
                            let _e3224 = phi_5497_;
                            let _e3227 = local_1.member_1[1u];
                            if (_e3227[0] < 0f) {
                                phi_5511_ = -(_e3227[0]);
                            } else {
                                phi_5511_ = _e3227[0];
                            }
                            let _e3234 = phi_5511_;
                            if (_e3227[1] < 0f) {
                                phi_5518_ = -(_e3227[1]);
                            } else {
                                phi_5518_ = _e3227[1];
                            }
                            let _e3238 = phi_5518_;
                            if (_e3234 > _e3238) {
                                phi_5523_ = _e3234;
                            } else {
                                phi_5523_ = _e3238;
                            }
                            let _e3241 = phi_5523_;
                            if (_e3227[2] < 0f) {
                                phi_5530_ = -(_e3227[2]);
                            } else {
                                phi_5530_ = _e3227[2];
                            }
                            let _e3245 = phi_5530_;
                            if (_e3241 > _e3245) {
                                phi_5535_ = _e3241;
                            } else {
                                phi_5535_ = _e3245;
                            }
                            let _e3248 = phi_5535_;
                            if (_e3224 > _e3248) {
                                phi_5540_ = _e3224;
                            } else {
                                phi_5540_ = _e3248;
                            }
                            let _e3251 = phi_5540_;
                            let _e3253 = local_1.member_3;
                            let _e3254 = (_e3251 + _e3253);
                            let _e3257 = local_1.member_2[0u];
                            if (_e3257[0] < 0f) {
                                phi_5557_ = -(_e3257[0]);
                            } else {
                                phi_5557_ = _e3257[0];
                            }
                            let _e3264 = phi_5557_;
                            if (_e3257[1] < 0f) {
                                phi_5564_ = -(_e3257[1]);
                            } else {
                                phi_5564_ = _e3257[1];
                            }
                            let _e3268 = phi_5564_;
                            if (_e3264 > _e3268) {
                                phi_5569_ = _e3264;
                            } else {
                                phi_5569_ = _e3268;
                            }
                            let _e3271 = phi_5569_;
                            if (_e3257[2] < 0f) {
                                phi_5576_ = -(_e3257[2]);
                            } else {
                                phi_5576_ = _e3257[2];
                            }
                            let _e3275 = phi_5576_;
                            if (_e3271 > _e3275) {
                                phi_5581_ = _e3271;
                            } else {
                                phi_5581_ = _e3275;
                            }
                            let _e3278 = phi_5581_;
                            let _e3281 = local_1.member_2[1u];
                            if (_e3281[0] < 0f) {
                                phi_5595_ = -(_e3281[0]);
                            } else {
                                phi_5595_ = _e3281[0];
                            }
                            let _e3288 = phi_5595_;
                            if (_e3281[1] < 0f) {
                                phi_5602_ = -(_e3281[1]);
                            } else {
                                phi_5602_ = _e3281[1];
                            }
                            let _e3292 = phi_5602_;
                            if (_e3288 > _e3292) {
                                phi_5607_ = _e3288;
                            } else {
                                phi_5607_ = _e3292;
                            }
                            let _e3295 = phi_5607_;
                            if (_e3281[2] < 0f) {
                                phi_5614_ = -(_e3281[2]);
                            } else {
                                phi_5614_ = _e3281[2];
                            }
                            let _e3299 = phi_5614_;
                            if (_e3295 > _e3299) {
                                phi_5619_ = _e3295;
                            } else {
                                phi_5619_ = _e3299;
                            }
                            let _e3302 = phi_5619_;
                            if (_e3278 > _e3302) {
                                phi_5624_ = _e3278;
                            } else {
                                phi_5624_ = _e3302;
                            }
                            let _e3305 = phi_5624_;
                            let _e3307 = local_1.member_3;
                            let _e3308 = (_e3305 + _e3307);
                            let _e3310 = ((_e3254 * 8f) * _e3308);
                            let _e3317 = local_1.member_3;
                            if (_e3006 < 0f) {
                                phi_5655_ = -(_e3006);
                            } else {
                                phi_5655_ = _e3006;
                            }
                            let _e3334 = phi_5655_;
                            if (_e3009 < 0f) {
                                phi_5661_ = -(_e3009);
                            } else {
                                phi_5661_ = _e3009;
                            }
                            let _e3338 = phi_5661_;
                            if (_e3012 < 0f) {
                                phi_5668_ = -(_e3012);
                            } else {
                                phi_5668_ = _e3012;
                            }
                            let _e3343 = phi_5668_;
                            let _e3344 = ((_e3334 + _e3338) + _e3343);
                            if (_e3027 < 0f) {
                                phi_5675_ = -(_e3027);
                            } else {
                                phi_5675_ = _e3027;
                            }
                            let _e3348 = phi_5675_;
                            if (_e3030 < 0f) {
                                phi_5681_ = -(_e3030);
                            } else {
                                phi_5681_ = _e3030;
                            }
                            let _e3352 = phi_5681_;
                            if (_e3033 < 0f) {
                                phi_5688_ = -(_e3033);
                            } else {
                                phi_5688_ = _e3033;
                            }
                            let _e3357 = phi_5688_;
                            let _e3358 = ((_e3348 + _e3352) + _e3357);
                            if (_e3344 > _e3358) {
                                phi_5694_ = _e3344;
                            } else {
                                phi_5694_ = _e3358;
                            }
                            let _e3361 = phi_5694_;
                            if (_e3076 < 0f) {
                                phi_5700_ = -(_e3076);
                            } else {
                                phi_5700_ = _e3076;
                            }
                            let _e3365 = phi_5700_;
                            if (_e3077 < 0f) {
                                phi_5706_ = -(_e3077);
                            } else {
                                phi_5706_ = _e3077;
                            }
                            let _e3369 = phi_5706_;
                            if (_e3078 < 0f) {
                                phi_5713_ = -(_e3078);
                            } else {
                                phi_5713_ = _e3078;
                            }
                            let _e3374 = phi_5713_;
                            let _e3376 = (((_e3365 + _e3369) + _e3374) * 0.5f);
                            if (_e3361 > _e3376) {
                                phi_5720_ = _e3361;
                            } else {
                                phi_5720_ = _e3376;
                            }
                            let _e3379 = phi_5720_;
                            let _e3384 = local_1.member_3;
                            let _e3397 = ((((_e3081[0] * _e3006) + (_e3081[1] * _e3009)) + (_e3081[2] * _e3012)) * 3f);
                            let _e3398 = ((((_e3138[0] * _e3027) + (_e3138[1] * _e3030)) + (_e3138[2] * _e3033)) * 3f);
                            if (_e3397 < _e3398) {
                                phi_5744_ = _e3397;
                            } else {
                                phi_5744_ = _e3398;
                            }
                            let _e3401 = phi_5744_;
                            if (_e3112 < _e3135) {
                                phi_5749_ = _e3112;
                            } else {
                                phi_5749_ = _e3135;
                            }
                            let _e3404 = phi_5749_;
                            if (_e3401 < _e3404) {
                                phi_5754_ = _e3401;
                            } else {
                                phi_5754_ = _e3404;
                            }
                            let _e3407 = phi_5754_;
                            if (_e3397 > _e3398) {
                                phi_5759_ = _e3397;
                            } else {
                                phi_5759_ = _e3398;
                            }
                            let _e3410 = phi_5759_;
                            if (_e3112 > _e3135) {
                                phi_5764_ = _e3112;
                            } else {
                                phi_5764_ = _e3135;
                            }
                            let _e3413 = phi_5764_;
                            if (_e3410 > _e3413) {
                                phi_5769_ = _e3410;
                            } else {
                                phi_5769_ = _e3413;
                            }
                            let _e3416 = phi_5769_;
                            let _e3421 = -(_e3416);
                            if (_e3407 > _e3421) {
                                phi_5779_ = _e3407;
                            } else {
                                phi_5779_ = _e3421;
                            }
                            let _e3424 = phi_5779_;
                            let _e3426 = ((_e3424 - ((((((_e3200 * 8f) * _e3310) * (0.000000059604645f * (524f / 64f))) + ((_e3317 * 19f) * ((_e3200 * (_e3254 + _e3308)) + (_e3254 * _e3308)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3200) * ((1f + _e3254) * (1f + _e3308))))) + ((_e707 * (((_e3379 + (_e3310 * (0.000000059604645f * 8f))) + ((_e3384 * 6f) * (_e3254 + _e3308))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3254) * (1f + _e3308))))) * (3f * 1.0001f)))) > 0f);
                            if _e3426 {
                                phi_6748_ = _e3426;
                            } else {
                                let _e3429 = local_1.member_1[0u];
                                let _e3435 = local_1.member_1[1u];
                                let _e3439 = (_e3429[0] + _e3435[0]);
                                let _e3440 = (_e3429[1] + _e3435[1]);
                                let _e3441 = (_e3429[2] + _e3435[2]);
                                let _e3444 = local_1.member_2[0u];
                                let _e3450 = local_1.member_2[1u];
                                let _e3454 = (_e3444[0] + _e3450[0]);
                                let _e3455 = (_e3444[1] + _e3450[1]);
                                let _e3456 = (_e3444[2] + _e3450[2]);
                                let _e3459 = ((_e3440 * _e3456) - (_e3441 * _e3455));
                                let _e3462 = ((_e3441 * _e3454) - (_e3439 * _e3456));
                                let _e3465 = ((_e3439 * _e3455) - (_e3440 * _e3454));
                                let _e3468 = local_1.member[0u];
                                let _e3474 = local_1.member_1[0u];
                                let _e3480 = local_1.member_2[0u];
                                let _e3484 = (_e3468[0] - _e3474[0]);
                                let _e3485 = (_e3468[1] - _e3474[1]);
                                let _e3486 = (_e3468[2] - _e3474[2]);
                                let _e3487 = (_e3468[0] - _e3480[0]);
                                let _e3488 = (_e3468[1] - _e3480[1]);
                                let _e3489 = (_e3468[2] - _e3480[2]);
                                let _e3492 = local_1.member[1u];
                                let _e3498 = local_1.member_1[1u];
                                let _e3504 = local_1.member_2[1u];
                                let _e3508 = (_e3492[0] - _e3498[0]);
                                let _e3509 = (_e3492[1] - _e3498[1]);
                                let _e3510 = (_e3492[2] - _e3498[2]);
                                let _e3511 = (_e3492[0] - _e3504[0]);
                                let _e3512 = (_e3492[1] - _e3504[1]);
                                let _e3513 = (_e3492[2] - _e3504[2]);
                                let _e3516 = local_1.member[0u];
                                if (_e3516[0] < 0f) {
                                    phi_5982_ = -(_e3516[0]);
                                } else {
                                    phi_5982_ = _e3516[0];
                                }
                                let _e3523 = phi_5982_;
                                if (_e3516[1] < 0f) {
                                    phi_5989_ = -(_e3516[1]);
                                } else {
                                    phi_5989_ = _e3516[1];
                                }
                                let _e3527 = phi_5989_;
                                if (_e3523 > _e3527) {
                                    phi_5994_ = _e3523;
                                } else {
                                    phi_5994_ = _e3527;
                                }
                                let _e3530 = phi_5994_;
                                if (_e3516[2] < 0f) {
                                    phi_6001_ = -(_e3516[2]);
                                } else {
                                    phi_6001_ = _e3516[2];
                                }
                                let _e3534 = phi_6001_;
                                if (_e3530 > _e3534) {
                                    phi_6006_ = _e3530;
                                } else {
                                    phi_6006_ = _e3534;
                                }
                                let _e3537 = phi_6006_;
                                let _e3540 = local_1.member[1u];
                                if (_e3540[0] < 0f) {
                                    phi_6019_ = -(_e3540[0]);
                                } else {
                                    phi_6019_ = _e3540[0];
                                }
                                let _e3547 = phi_6019_;
                                if (_e3540[1] < 0f) {
                                    phi_6026_ = -(_e3540[1]);
                                } else {
                                    phi_6026_ = _e3540[1];
                                }
                                let _e3551 = phi_6026_;
                                if (_e3547 > _e3551) {
                                    phi_6031_ = _e3547;
                                } else {
                                    phi_6031_ = _e3551;
                                }
                                let _e3554 = phi_6031_;
                                if (_e3540[2] < 0f) {
                                    phi_6038_ = -(_e3540[2]);
                                } else {
                                    phi_6038_ = _e3540[2];
                                }
                                let _e3558 = phi_6038_;
                                if (_e3554 > _e3558) {
                                    phi_6043_ = _e3554;
                                } else {
                                    phi_6043_ = _e3558;
                                }
                                let _e3561 = phi_6043_;
                                if (_e3537 > _e3561) {
                                    phi_6048_ = _e3537;
                                } else {
                                    phi_6048_ = _e3561;
                                }
                                let _e3564 = phi_6048_;
                                let _e3566 = local_1.member_3;
                                let _e3570 = local_1.member_1[0u];
                                if (_e3570[0] < 0f) {
                                    phi_6065_ = -(_e3570[0]);
                                } else {
                                    phi_6065_ = _e3570[0];
                                }
                                let _e3577 = phi_6065_;
                                if (_e3570[1] < 0f) {
                                    phi_6072_ = -(_e3570[1]);
                                } else {
                                    phi_6072_ = _e3570[1];
                                }
                                let _e3581 = phi_6072_;
                                if (_e3577 > _e3581) {
                                    phi_6077_ = _e3577;
                                } else {
                                    phi_6077_ = _e3581;
                                }
                                let _e3584 = phi_6077_;
                                if (_e3570[2] < 0f) {
                                    phi_6084_ = -(_e3570[2]);
                                } else {
                                    phi_6084_ = _e3570[2];
                                }
                                let _e3588 = phi_6084_;
                                if (_e3584 > _e3588) {
                                    phi_6089_ = _e3584;
                                } else {
                                    phi_6089_ = _e3588;
                                }
                                let _e3591 = phi_6089_;
                                let _e3594 = local_1.member_1[1u];
                                if (_e3594[0] < 0f) {
                                    phi_6103_ = -(_e3594[0]);
                                } else {
                                    phi_6103_ = _e3594[0];
                                }
                                let _e3601 = phi_6103_;
                                if (_e3594[1] < 0f) {
                                    phi_6110_ = -(_e3594[1]);
                                } else {
                                    phi_6110_ = _e3594[1];
                                }
                                let _e3605 = phi_6110_;
                                if (_e3601 > _e3605) {
                                    phi_6115_ = _e3601;
                                } else {
                                    phi_6115_ = _e3605;
                                }
                                let _e3608 = phi_6115_;
                                if (_e3594[2] < 0f) {
                                    phi_6122_ = -(_e3594[2]);
                                } else {
                                    phi_6122_ = _e3594[2];
                                }
                                let _e3612 = phi_6122_;
                                if (_e3608 > _e3612) {
                                    phi_6127_ = _e3608;
                                } else {
                                    phi_6127_ = _e3612;
                                }
                                let _e3615 = phi_6127_;
                                if (_e3591 > _e3615) {
                                    phi_6132_ = _e3591;
                                } else {
                                    phi_6132_ = _e3615;
                                }
                                let _e3618 = phi_6132_;
                                let _e3620 = local_1.member_3;
                                let _e3624 = local_1.member_2[0u];
                                if (_e3624[0] < 0f) {
                                    phi_6149_ = -(_e3624[0]);
                                } else {
                                    phi_6149_ = _e3624[0];
                                }
                                let _e3631 = phi_6149_;
                                if (_e3624[1] < 0f) {
                                    phi_6156_ = -(_e3624[1]);
                                } else {
                                    phi_6156_ = _e3624[1];
                                }
                                let _e3635 = phi_6156_;
                                if (_e3631 > _e3635) {
                                    phi_6161_ = _e3631;
                                } else {
                                    phi_6161_ = _e3635;
                                }
                                let _e3638 = phi_6161_;
                                if (_e3624[2] < 0f) {
                                    phi_6168_ = -(_e3624[2]);
                                } else {
                                    phi_6168_ = _e3624[2];
                                }
                                let _e3642 = phi_6168_;
                                if (_e3638 > _e3642) {
                                    phi_6173_ = _e3638;
                                } else {
                                    phi_6173_ = _e3642;
                                }
                                let _e3645 = phi_6173_;
                                let _e3648 = local_1.member_2[1u];
                                if (_e3648[0] < 0f) {
                                    phi_6187_ = -(_e3648[0]);
                                } else {
                                    phi_6187_ = _e3648[0];
                                }
                                let _e3655 = phi_6187_;
                                if (_e3648[1] < 0f) {
                                    phi_6194_ = -(_e3648[1]);
                                } else {
                                    phi_6194_ = _e3648[1];
                                }
                                let _e3659 = phi_6194_;
                                if (_e3655 > _e3659) {
                                    phi_6199_ = _e3655;
                                } else {
                                    phi_6199_ = _e3659;
                                }
                                let _e3662 = phi_6199_;
                                if (_e3648[2] < 0f) {
                                    phi_6206_ = -(_e3648[2]);
                                } else {
                                    phi_6206_ = _e3648[2];
                                }
                                let _e3666 = phi_6206_;
                                if (_e3662 > _e3666) {
                                    phi_6211_ = _e3662;
                                } else {
                                    phi_6211_ = _e3666;
                                }
                                let _e3669 = phi_6211_;
                                if (_e3645 > _e3669) {
                                    phi_6216_ = _e3645;
                                } else {
                                    phi_6216_ = _e3669;
                                }
                                let _e3672 = phi_6216_;
                                let _e3674 = local_1.member_3;
                                let _e3678 = ((((_e3564 + _e3566) + (_e3618 + _e3620)) + (_e3672 + _e3674)) * 2f);
                                let _e3681 = local_1.member_3;
                                let _e3685 = (((_e707 * 1.0001f) + (_e3681 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e3688 = ((_e3462 * _e3441) - (_e3465 * _e3440));
                                let _e3691 = ((_e3465 * _e3439) - (_e3459 * _e3441));
                                let _e3694 = ((_e3459 * _e3440) - (_e3462 * _e3439));
                                let _e3699 = (((_e3688 * _e3468[0]) + (_e3691 * _e3468[1])) + (_e3694 * _e3468[2]));
                                let _e3704 = (((_e3688 * _e3484) + (_e3691 * _e3485)) + (_e3694 * _e3486));
                                let _e3709 = (((_e3688 * _e3487) + (_e3691 * _e3488)) + (_e3694 * _e3489));
                                let _e3714 = (((_e3688 * _e3468[0]) + (_e3691 * _e3468[1])) + (_e3694 * _e3468[2]));
                                let _e3719 = (((_e3688 * _e3492[0]) + (_e3691 * _e3492[1])) + (_e3694 * _e3492[2]));
                                let _e3724 = (((_e3688 * _e3508) + (_e3691 * _e3509)) + (_e3694 * _e3510));
                                let _e3729 = (((_e3688 * _e3511) + (_e3691 * _e3512)) + (_e3694 * _e3513));
                                let _e3734 = (((_e3688 * _e3492[0]) + (_e3691 * _e3492[1])) + (_e3694 * _e3492[2]));
                                if (_e3699 < _e3704) {
                                    phi_6295_ = _e3699;
                                } else {
                                    phi_6295_ = _e3704;
                                }
                                let _e3737 = phi_6295_;
                                if (_e3709 < _e3714) {
                                    phi_6300_ = _e3709;
                                } else {
                                    phi_6300_ = _e3714;
                                }
                                let _e3740 = phi_6300_;
                                if (_e3737 < _e3740) {
                                    phi_6305_ = _e3737;
                                } else {
                                    phi_6305_ = _e3740;
                                }
                                let _e3743 = phi_6305_;
                                if (_e3719 < _e3724) {
                                    phi_6310_ = _e3719;
                                } else {
                                    phi_6310_ = _e3724;
                                }
                                let _e3746 = phi_6310_;
                                if (_e3729 < _e3734) {
                                    phi_6315_ = _e3729;
                                } else {
                                    phi_6315_ = _e3734;
                                }
                                let _e3749 = phi_6315_;
                                if (_e3746 < _e3749) {
                                    phi_6320_ = _e3746;
                                } else {
                                    phi_6320_ = _e3749;
                                }
                                let _e3752 = phi_6320_;
                                if (_e3743 < _e3752) {
                                    phi_6325_ = _e3743;
                                } else {
                                    phi_6325_ = _e3752;
                                }
                                let _e3755 = phi_6325_;
                                if (_e3699 > _e3704) {
                                    phi_6330_ = _e3699;
                                } else {
                                    phi_6330_ = _e3704;
                                }
                                let _e3758 = phi_6330_;
                                if (_e3709 > _e3714) {
                                    phi_6335_ = _e3709;
                                } else {
                                    phi_6335_ = _e3714;
                                }
                                let _e3761 = phi_6335_;
                                if (_e3758 > _e3761) {
                                    phi_6340_ = _e3758;
                                } else {
                                    phi_6340_ = _e3761;
                                }
                                let _e3764 = phi_6340_;
                                if (_e3719 > _e3724) {
                                    phi_6345_ = _e3719;
                                } else {
                                    phi_6345_ = _e3724;
                                }
                                let _e3767 = phi_6345_;
                                if (_e3729 > _e3734) {
                                    phi_6350_ = _e3729;
                                } else {
                                    phi_6350_ = _e3734;
                                }
                                let _e3770 = phi_6350_;
                                if (_e3767 > _e3770) {
                                    phi_6355_ = _e3767;
                                } else {
                                    phi_6355_ = _e3770;
                                }
                                let _e3773 = phi_6355_;
                                if (_e3764 > _e3773) {
                                    phi_6360_ = _e3764;
                                } else {
                                    phi_6360_ = _e3773;
                                }
                                let _e3776 = phi_6360_;
                                if (_e3688 < 0f) {
                                    phi_6366_ = -(_e3688);
                                } else {
                                    phi_6366_ = _e3688;
                                }
                                let _e3780 = phi_6366_;
                                if (_e3691 < 0f) {
                                    phi_6372_ = -(_e3691);
                                } else {
                                    phi_6372_ = _e3691;
                                }
                                let _e3784 = phi_6372_;
                                if (_e3694 < 0f) {
                                    phi_6379_ = -(_e3694);
                                } else {
                                    phi_6379_ = _e3694;
                                }
                                let _e3789 = phi_6379_;
                                let _e3790 = ((_e3780 + _e3784) + _e3789);
                                let _e3795 = -(_e3776);
                                if (_e3755 > _e3795) {
                                    phi_6390_ = _e3755;
                                } else {
                                    phi_6390_ = _e3795;
                                }
                                let _e3798 = phi_6390_;
                                let _e3803 = (((_e3798 - ((_e3790 * _e3678) * (0.000000059604645f * (17f / 2f)))) - (_e3790 * _e3685)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3806 = ((_e3462 * _e3456) - (_e3465 * _e3455));
                                let _e3809 = ((_e3465 * _e3454) - (_e3459 * _e3456));
                                let _e3812 = ((_e3459 * _e3455) - (_e3462 * _e3454));
                                let _e3817 = (((_e3806 * _e3468[0]) + (_e3809 * _e3468[1])) + (_e3812 * _e3468[2]));
                                let _e3822 = (((_e3806 * _e3484) + (_e3809 * _e3485)) + (_e3812 * _e3486));
                                let _e3827 = (((_e3806 * _e3487) + (_e3809 * _e3488)) + (_e3812 * _e3489));
                                let _e3832 = (((_e3806 * _e3468[0]) + (_e3809 * _e3468[1])) + (_e3812 * _e3468[2]));
                                let _e3837 = (((_e3806 * _e3492[0]) + (_e3809 * _e3492[1])) + (_e3812 * _e3492[2]));
                                let _e3842 = (((_e3806 * _e3508) + (_e3809 * _e3509)) + (_e3812 * _e3510));
                                let _e3847 = (((_e3806 * _e3511) + (_e3809 * _e3512)) + (_e3812 * _e3513));
                                let _e3852 = (((_e3806 * _e3492[0]) + (_e3809 * _e3492[1])) + (_e3812 * _e3492[2]));
                                if (_e3817 < _e3822) {
                                    phi_6461_ = _e3817;
                                } else {
                                    phi_6461_ = _e3822;
                                }
                                let _e3855 = phi_6461_;
                                if (_e3827 < _e3832) {
                                    phi_6466_ = _e3827;
                                } else {
                                    phi_6466_ = _e3832;
                                }
                                let _e3858 = phi_6466_;
                                if (_e3855 < _e3858) {
                                    phi_6471_ = _e3855;
                                } else {
                                    phi_6471_ = _e3858;
                                }
                                let _e3861 = phi_6471_;
                                if (_e3837 < _e3842) {
                                    phi_6476_ = _e3837;
                                } else {
                                    phi_6476_ = _e3842;
                                }
                                let _e3864 = phi_6476_;
                                if (_e3847 < _e3852) {
                                    phi_6481_ = _e3847;
                                } else {
                                    phi_6481_ = _e3852;
                                }
                                let _e3867 = phi_6481_;
                                if (_e3864 < _e3867) {
                                    phi_6486_ = _e3864;
                                } else {
                                    phi_6486_ = _e3867;
                                }
                                let _e3870 = phi_6486_;
                                if (_e3861 < _e3870) {
                                    phi_6491_ = _e3861;
                                } else {
                                    phi_6491_ = _e3870;
                                }
                                let _e3873 = phi_6491_;
                                if (_e3817 > _e3822) {
                                    phi_6496_ = _e3817;
                                } else {
                                    phi_6496_ = _e3822;
                                }
                                let _e3876 = phi_6496_;
                                if (_e3827 > _e3832) {
                                    phi_6501_ = _e3827;
                                } else {
                                    phi_6501_ = _e3832;
                                }
                                let _e3879 = phi_6501_;
                                if (_e3876 > _e3879) {
                                    phi_6506_ = _e3876;
                                } else {
                                    phi_6506_ = _e3879;
                                }
                                let _e3882 = phi_6506_;
                                if (_e3837 > _e3842) {
                                    phi_6511_ = _e3837;
                                } else {
                                    phi_6511_ = _e3842;
                                }
                                let _e3885 = phi_6511_;
                                if (_e3847 > _e3852) {
                                    phi_6516_ = _e3847;
                                } else {
                                    phi_6516_ = _e3852;
                                }
                                let _e3888 = phi_6516_;
                                if (_e3885 > _e3888) {
                                    phi_6521_ = _e3885;
                                } else {
                                    phi_6521_ = _e3888;
                                }
                                let _e3891 = phi_6521_;
                                if (_e3882 > _e3891) {
                                    phi_6526_ = _e3882;
                                } else {
                                    phi_6526_ = _e3891;
                                }
                                let _e3894 = phi_6526_;
                                if (_e3806 < 0f) {
                                    phi_6532_ = -(_e3806);
                                } else {
                                    phi_6532_ = _e3806;
                                }
                                let _e3898 = phi_6532_;
                                if (_e3809 < 0f) {
                                    phi_6538_ = -(_e3809);
                                } else {
                                    phi_6538_ = _e3809;
                                }
                                let _e3902 = phi_6538_;
                                if (_e3812 < 0f) {
                                    phi_6545_ = -(_e3812);
                                } else {
                                    phi_6545_ = _e3812;
                                }
                                let _e3907 = phi_6545_;
                                let _e3908 = ((_e3898 + _e3902) + _e3907);
                                let _e3913 = -(_e3894);
                                if (_e3873 > _e3913) {
                                    phi_6556_ = _e3873;
                                } else {
                                    phi_6556_ = _e3913;
                                }
                                let _e3916 = phi_6556_;
                                let _e3921 = (((_e3916 - ((_e3908 * _e3678) * (0.000000059604645f * (17f / 2f)))) - (_e3908 * _e3685)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3803 > _e3921) {
                                    phi_6566_ = _e3803;
                                } else {
                                    phi_6566_ = _e3921;
                                }
                                let _e3924 = phi_6566_;
                                let _e3925 = (_e3454 - _e3439);
                                let _e3926 = (_e3455 - _e3440);
                                let _e3927 = (_e3456 - _e3441);
                                let _e3930 = ((_e3462 * _e3927) - (_e3465 * _e3926));
                                let _e3933 = ((_e3465 * _e3925) - (_e3459 * _e3927));
                                let _e3936 = ((_e3459 * _e3926) - (_e3462 * _e3925));
                                let _e3941 = (((_e3930 * _e3468[0]) + (_e3933 * _e3468[1])) + (_e3936 * _e3468[2]));
                                let _e3946 = (((_e3930 * _e3484) + (_e3933 * _e3485)) + (_e3936 * _e3486));
                                let _e3951 = (((_e3930 * _e3487) + (_e3933 * _e3488)) + (_e3936 * _e3489));
                                let _e3956 = (((_e3930 * _e3468[0]) + (_e3933 * _e3468[1])) + (_e3936 * _e3468[2]));
                                let _e3961 = (((_e3930 * _e3492[0]) + (_e3933 * _e3492[1])) + (_e3936 * _e3492[2]));
                                let _e3966 = (((_e3930 * _e3508) + (_e3933 * _e3509)) + (_e3936 * _e3510));
                                let _e3971 = (((_e3930 * _e3511) + (_e3933 * _e3512)) + (_e3936 * _e3513));
                                let _e3976 = (((_e3930 * _e3492[0]) + (_e3933 * _e3492[1])) + (_e3936 * _e3492[2]));
                                if (_e3941 < _e3946) {
                                    phi_6639_ = _e3941;
                                } else {
                                    phi_6639_ = _e3946;
                                }
                                let _e3979 = phi_6639_;
                                if (_e3951 < _e3956) {
                                    phi_6644_ = _e3951;
                                } else {
                                    phi_6644_ = _e3956;
                                }
                                let _e3982 = phi_6644_;
                                if (_e3979 < _e3982) {
                                    phi_6649_ = _e3979;
                                } else {
                                    phi_6649_ = _e3982;
                                }
                                let _e3985 = phi_6649_;
                                if (_e3961 < _e3966) {
                                    phi_6654_ = _e3961;
                                } else {
                                    phi_6654_ = _e3966;
                                }
                                let _e3988 = phi_6654_;
                                if (_e3971 < _e3976) {
                                    phi_6659_ = _e3971;
                                } else {
                                    phi_6659_ = _e3976;
                                }
                                let _e3991 = phi_6659_;
                                if (_e3988 < _e3991) {
                                    phi_6664_ = _e3988;
                                } else {
                                    phi_6664_ = _e3991;
                                }
                                let _e3994 = phi_6664_;
                                if (_e3985 < _e3994) {
                                    phi_6669_ = _e3985;
                                } else {
                                    phi_6669_ = _e3994;
                                }
                                let _e3997 = phi_6669_;
                                if (_e3941 > _e3946) {
                                    phi_6674_ = _e3941;
                                } else {
                                    phi_6674_ = _e3946;
                                }
                                let _e4000 = phi_6674_;
                                if (_e3951 > _e3956) {
                                    phi_6679_ = _e3951;
                                } else {
                                    phi_6679_ = _e3956;
                                }
                                let _e4003 = phi_6679_;
                                if (_e4000 > _e4003) {
                                    phi_6684_ = _e4000;
                                } else {
                                    phi_6684_ = _e4003;
                                }
                                let _e4006 = phi_6684_;
                                if (_e3961 > _e3966) {
                                    phi_6689_ = _e3961;
                                } else {
                                    phi_6689_ = _e3966;
                                }
                                let _e4009 = phi_6689_;
                                if (_e3971 > _e3976) {
                                    phi_6694_ = _e3971;
                                } else {
                                    phi_6694_ = _e3976;
                                }
                                let _e4012 = phi_6694_;
                                if (_e4009 > _e4012) {
                                    phi_6699_ = _e4009;
                                } else {
                                    phi_6699_ = _e4012;
                                }
                                let _e4015 = phi_6699_;
                                if (_e4006 > _e4015) {
                                    phi_6704_ = _e4006;
                                } else {
                                    phi_6704_ = _e4015;
                                }
                                let _e4018 = phi_6704_;
                                if (_e3930 < 0f) {
                                    phi_6710_ = -(_e3930);
                                } else {
                                    phi_6710_ = _e3930;
                                }
                                let _e4022 = phi_6710_;
                                if (_e3933 < 0f) {
                                    phi_6716_ = -(_e3933);
                                } else {
                                    phi_6716_ = _e3933;
                                }
                                let _e4026 = phi_6716_;
                                if (_e3936 < 0f) {
                                    phi_6723_ = -(_e3936);
                                } else {
                                    phi_6723_ = _e3936;
                                }
                                let _e4031 = phi_6723_;
                                let _e4032 = ((_e4022 + _e4026) + _e4031);
                                let _e4037 = -(_e4018);
                                if (_e3997 > _e4037) {
                                    phi_6734_ = _e3997;
                                } else {
                                    phi_6734_ = _e4037;
                                }
                                let _e4040 = phi_6734_;
                                let _e4045 = (((_e4040 - ((_e4032 * _e3678) * (0.000000059604645f * (17f / 2f)))) - (_e4032 * _e3685)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3924 > _e4045) {
                                    phi_6744_ = _e3924;
                                } else {
                                    phi_6744_ = _e4045;
                                }
                                let _e4048 = phi_6744_;
                                phi_6748_ = (_e3426 || (_e4048 > 0f));
                            }
                            let _e4052 = phi_6748_;
                            phi_6750_ = (_e2991 && _e4052);
                        } else {
                            phi_6750_ = _e2991;
                        }
                        let _e4055 = phi_6750_;
                        phi_6752_ = (_e1840 || _e4055);
                    }
                    let _e4058 = phi_6752_;
                    let _e4059 = !(_e4058);
                    if _e4059 {
                        let _e4061 = atomicAdd((&counters[0u]), 1u);
                        phi_6759_ = _e4061;
                    } else {
                        phi_6759_ = 0u;
                    }
                    let _e4063 = phi_6759_;
                    phi_6760_ = _e4063;
                    phi_6761_ = _e4059;
                } else {
                    phi_6760_ = 0u;
                    phi_6761_ = false;
                }
                let _e4065 = phi_6760_;
                let _e4067 = phi_6761_;
                phi_6762_ = _e4065;
                phi_6763_ = _e4067;
                phi_6764_ = type_12(_e144, _e147);
            } else {
                phi_6762_ = 0u;
                phi_6763_ = false;
                phi_6764_ = type_12(0u, 0u);
            }
            let _e4069 = phi_6762_;
            let _e4071 = phi_6763_;
            let _e4073 = phi_6764_;
            workgroupBarrier();
            if (_e53 == 0u) {
                let _e4076 = atomicLoad((&counters[0u]));
                let _e4078 = atomicLoad((&counters[1u]));
                if (_e4076 > 0u) {
                    let _e4081 = atomicAdd((&output.member[0u]), _e4076);
                    if ((_e4081 + _e4076) < _e4081) {
                        let _e4085 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e4081);
                }
                if (_e4078 > 0u) {
                    let _e4089 = atomicAdd((&output.member[1u]), _e4078);
                    if ((_e4089 + _e4078) < _e4089) {
                        let _e4093 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e4071 {
                let _e4095 = params.member.member_1.member_3;
                let _e4097 = atomicLoad((&counters[2u]));
                let _e4098 = (_e4097 + _e4069);
                if (_e4098 < _e4095) {
                    let _e4102 = (2u * _e4098);
                    atomicStore((&output.member[(4u + _e4102)]), _e4073.member);
                    atomicStore((&output.member[(_e4102 + 5u)]), _e4073.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_375_ = _e123;
            break if !(_e129);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_listed_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
