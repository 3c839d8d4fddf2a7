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

struct type_35 {
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
var<storage, read_write> output: type_35;
@group(0) @binding(2) 
var<storage> elements: type_13;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_141_: bool;
    var phi_142_: bool;
    var phi_146_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_142_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_141_ = (param[0] > param_1[0]);
        } else {
            phi_141_ = false;
        }
        let _e14 = phi_141_;
        phi_142_ = _e14;
    }
    let _e16 = phi_142_;
    if _e16 {
        phi_146_ = param_1;
    } else {
        phi_146_ = param;
    }
    let _e18 = phi_146_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_165_: bool;
    var phi_166_: bool;
    var phi_170_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_166_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_165_ = (param_3[0] > param_2[0]);
        } else {
            phi_165_ = false;
        }
        let _e14 = phi_165_;
        phi_166_ = _e14;
    }
    let _e16 = phi_166_;
    if _e16 {
        phi_170_ = param_3;
    } else {
        phi_170_ = param_2;
    }
    let _e18 = phi_170_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_189_: bool;
    var phi_190_: bool;
    var phi_194_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_190_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_189_ = (param_4[0] > param_5[0]);
        } else {
            phi_189_ = false;
        }
        let _e14 = phi_189_;
        phi_190_ = _e14;
    }
    let _e16 = phi_190_;
    if _e16 {
        phi_194_ = param_5;
    } else {
        phi_194_ = param_4;
    }
    let _e18 = phi_194_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_213_: bool;
    var phi_214_: bool;
    var phi_218_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_214_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_213_ = (param_7[0] > param_6[0]);
        } else {
            phi_213_ = false;
        }
        let _e14 = phi_213_;
        phi_214_ = _e14;
    }
    let _e16 = phi_214_;
    if _e16 {
        phi_218_ = param_7;
    } else {
        phi_218_ = param_6;
    }
    let _e18 = phi_218_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_237_: bool;
    var phi_238_: bool;
    var phi_242_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_238_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_237_ = (param_8[0] > param_9[0]);
        } else {
            phi_237_ = false;
        }
        let _e14 = phi_237_;
        phi_238_ = _e14;
    }
    let _e16 = phi_238_;
    if _e16 {
        phi_242_ = param_9;
    } else {
        phi_242_ = param_8;
    }
    let _e18 = phi_242_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_261_: bool;
    var phi_262_: bool;
    var phi_266_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_262_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_261_ = (param_11[0] > param_10[0]);
        } else {
            phi_261_ = false;
        }
        let _e14 = phi_261_;
        phi_262_ = _e14;
    }
    let _e16 = phi_262_;
    if _e16 {
        phi_266_ = param_11;
    } else {
        phi_266_ = param_10;
    }
    let _e18 = phi_266_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_27;
    var local_1: type_27;
    var local_2: type_27;
    var phi_316_: u32;
    var phi_326_: u32;
    var phi_333_: u32;
    var phi_349_: u32;
    var phi_370_: u32;
    var phi_371_: u32;
    var phi_374_: type_9;
    var phi_375_: type_9;
    var phi_398_: type_9;
    var phi_533_: type_31;
    var phi_548_: array<u32, 3>;
    var phi_549_: array<u32, 3>;
    var phi_571_: array<u32, 2>;
    var phi_639_: bool;
    var phi_645_: bool;
    var phi_613_: bool;
    var phi_620_: bool;
    var phi_628_: bool;
    var phi_647_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_696_: bool;
    var phi_697_: bool;
    var phi_704_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_856_: u32;
    var phi_857_: u32;
    var phi_858_: u32;
    var phi_859_: u32;
    var phi_862_: type_16;
    var phi_865_: u32;
    var phi_867_: u32;
    var phi_888_: bool;
    var phi_894_: type_17;
    var phi_863_: type_16;
    var phi_908_: type_17;
    var phi_976_: bool;
    var phi_977_: bool;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_983_: bool;
    var phi_984_: bool;
    var phi_989_: u32;
    var phi_990_: u32;
    var phi_991_: u32;
    var phi_992_: u32;
    var phi_993_: bool;
    var phi_866_: u32;
    var phi_868_: u32;
    var phi_994_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1042_: bool;
    var phi_1043_: bool;
    var phi_1044_: bool;
    var phi_1045_: bool;
    var phi_1049_: bool;
    var phi_1050_: bool;
    var phi_1054_: bool;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1063_: bool;
    var phi_1064_: bool;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1205_: bool;
    var phi_1206_: bool;
    var phi_1299_: bool;
    var phi_1300_: bool;
    var phi_1394_: bool;
    var phi_1395_: bool;
    var phi_1488_: bool;
    var phi_1489_: bool;
    var phi_1584_: bool;
    var phi_1585_: bool;
    var phi_1678_: bool;
    var phi_1679_: bool;
    var phi_1683_: bool;
    var phi_1684_: bool;
    var phi_1685_: bool;
    var phi_1689_: bool;
    var phi_1690_: bool;
    var phi_1691_: bool;
    var phi_1692_: bool;
    var phi_1693_: bool;
    var phi_1697_: bool;
    var phi_1838_: type_27;
    var phi_2118_: f32;
    var phi_2125_: f32;
    var phi_2130_: f32;
    var phi_2137_: f32;
    var phi_2142_: f32;
    var phi_2155_: f32;
    var phi_2162_: f32;
    var phi_2167_: f32;
    var phi_2174_: f32;
    var phi_2179_: f32;
    var phi_2184_: f32;
    var phi_2201_: f32;
    var phi_2208_: f32;
    var phi_2213_: f32;
    var phi_2220_: f32;
    var phi_2225_: f32;
    var phi_2239_: f32;
    var phi_2246_: f32;
    var phi_2251_: f32;
    var phi_2258_: f32;
    var phi_2263_: f32;
    var phi_2268_: f32;
    var phi_2285_: f32;
    var phi_2292_: f32;
    var phi_2297_: f32;
    var phi_2304_: f32;
    var phi_2309_: f32;
    var phi_2323_: f32;
    var phi_2330_: f32;
    var phi_2335_: f32;
    var phi_2342_: f32;
    var phi_2347_: f32;
    var phi_2352_: f32;
    var phi_2383_: f32;
    var phi_2389_: f32;
    var phi_2396_: f32;
    var phi_2403_: f32;
    var phi_2409_: f32;
    var phi_2416_: f32;
    var phi_2422_: f32;
    var phi_2428_: f32;
    var phi_2434_: f32;
    var phi_2441_: f32;
    var phi_2448_: f32;
    var phi_2472_: f32;
    var phi_2477_: f32;
    var phi_2482_: f32;
    var phi_2487_: f32;
    var phi_2492_: f32;
    var phi_2497_: f32;
    var phi_2507_: f32;
    var phi_2623_: array<f32, 3>;
    var phi_2688_: array<f32, 3>;
    var phi_2710_: f32;
    var phi_2717_: f32;
    var phi_2722_: f32;
    var phi_2729_: f32;
    var phi_2734_: f32;
    var phi_2747_: f32;
    var phi_2754_: f32;
    var phi_2759_: f32;
    var phi_2766_: f32;
    var phi_2771_: f32;
    var phi_2776_: f32;
    var phi_2793_: f32;
    var phi_2800_: f32;
    var phi_2805_: f32;
    var phi_2812_: f32;
    var phi_2817_: f32;
    var phi_2831_: f32;
    var phi_2838_: f32;
    var phi_2843_: f32;
    var phi_2850_: f32;
    var phi_2855_: f32;
    var phi_2860_: f32;
    var phi_2877_: f32;
    var phi_2884_: f32;
    var phi_2889_: f32;
    var phi_2896_: f32;
    var phi_2901_: f32;
    var phi_2915_: f32;
    var phi_2922_: f32;
    var phi_2927_: f32;
    var phi_2934_: f32;
    var phi_2939_: f32;
    var phi_2944_: f32;
    var phi_3023_: f32;
    var phi_3028_: f32;
    var phi_3033_: f32;
    var phi_3038_: f32;
    var phi_3043_: f32;
    var phi_3048_: f32;
    var phi_3053_: f32;
    var phi_3058_: f32;
    var phi_3063_: f32;
    var phi_3068_: f32;
    var phi_3073_: f32;
    var phi_3078_: f32;
    var phi_3083_: f32;
    var phi_3088_: f32;
    var phi_3094_: f32;
    var phi_3100_: f32;
    var phi_3107_: f32;
    var phi_3118_: f32;
    var phi_3189_: f32;
    var phi_3194_: f32;
    var phi_3199_: f32;
    var phi_3204_: f32;
    var phi_3209_: f32;
    var phi_3214_: f32;
    var phi_3219_: f32;
    var phi_3224_: f32;
    var phi_3229_: f32;
    var phi_3234_: f32;
    var phi_3239_: f32;
    var phi_3244_: f32;
    var phi_3249_: f32;
    var phi_3254_: f32;
    var phi_3260_: f32;
    var phi_3266_: f32;
    var phi_3273_: f32;
    var phi_3284_: f32;
    var phi_3294_: f32;
    var phi_3367_: f32;
    var phi_3372_: f32;
    var phi_3377_: f32;
    var phi_3382_: f32;
    var phi_3387_: f32;
    var phi_3392_: f32;
    var phi_3397_: f32;
    var phi_3402_: f32;
    var phi_3407_: f32;
    var phi_3412_: f32;
    var phi_3417_: f32;
    var phi_3422_: f32;
    var phi_3427_: f32;
    var phi_3432_: f32;
    var phi_3438_: f32;
    var phi_3444_: f32;
    var phi_3451_: f32;
    var phi_3462_: f32;
    var phi_3472_: f32;
    var phi_3473_: f32;
    var phi_3476_: bool;
    var phi_3928_: f32;
    var phi_3935_: f32;
    var phi_3940_: f32;
    var phi_3947_: f32;
    var phi_3952_: f32;
    var phi_3965_: f32;
    var phi_3972_: f32;
    var phi_3977_: f32;
    var phi_3984_: f32;
    var phi_3989_: f32;
    var phi_3994_: f32;
    var phi_4011_: f32;
    var phi_4018_: f32;
    var phi_4023_: f32;
    var phi_4030_: f32;
    var phi_4035_: f32;
    var phi_4049_: f32;
    var phi_4056_: f32;
    var phi_4061_: f32;
    var phi_4068_: f32;
    var phi_4073_: f32;
    var phi_4078_: f32;
    var phi_4095_: f32;
    var phi_4102_: f32;
    var phi_4107_: f32;
    var phi_4114_: f32;
    var phi_4119_: f32;
    var phi_4133_: f32;
    var phi_4140_: f32;
    var phi_4145_: f32;
    var phi_4152_: f32;
    var phi_4157_: f32;
    var phi_4162_: f32;
    var phi_4193_: f32;
    var phi_4199_: f32;
    var phi_4206_: f32;
    var phi_4213_: f32;
    var phi_4219_: f32;
    var phi_4226_: f32;
    var phi_4232_: f32;
    var phi_4238_: f32;
    var phi_4244_: f32;
    var phi_4251_: f32;
    var phi_4258_: f32;
    var phi_4282_: f32;
    var phi_4287_: f32;
    var phi_4292_: f32;
    var phi_4297_: f32;
    var phi_4302_: f32;
    var phi_4307_: f32;
    var phi_4317_: f32;
    var phi_4433_: array<f32, 3>;
    var phi_4498_: array<f32, 3>;
    var phi_4520_: f32;
    var phi_4527_: f32;
    var phi_4532_: f32;
    var phi_4539_: f32;
    var phi_4544_: f32;
    var phi_4557_: f32;
    var phi_4564_: f32;
    var phi_4569_: f32;
    var phi_4576_: f32;
    var phi_4581_: f32;
    var phi_4586_: f32;
    var phi_4603_: f32;
    var phi_4610_: f32;
    var phi_4615_: f32;
    var phi_4622_: f32;
    var phi_4627_: f32;
    var phi_4641_: f32;
    var phi_4648_: f32;
    var phi_4653_: f32;
    var phi_4660_: f32;
    var phi_4665_: f32;
    var phi_4670_: f32;
    var phi_4687_: f32;
    var phi_4694_: f32;
    var phi_4699_: f32;
    var phi_4706_: f32;
    var phi_4711_: f32;
    var phi_4725_: f32;
    var phi_4732_: f32;
    var phi_4737_: f32;
    var phi_4744_: f32;
    var phi_4749_: f32;
    var phi_4754_: f32;
    var phi_4833_: f32;
    var phi_4838_: f32;
    var phi_4843_: f32;
    var phi_4848_: f32;
    var phi_4853_: f32;
    var phi_4858_: f32;
    var phi_4863_: f32;
    var phi_4868_: f32;
    var phi_4873_: f32;
    var phi_4878_: f32;
    var phi_4883_: f32;
    var phi_4888_: f32;
    var phi_4893_: f32;
    var phi_4898_: f32;
    var phi_4904_: f32;
    var phi_4910_: f32;
    var phi_4917_: f32;
    var phi_4928_: f32;
    var phi_4999_: f32;
    var phi_5004_: f32;
    var phi_5009_: f32;
    var phi_5014_: f32;
    var phi_5019_: f32;
    var phi_5024_: f32;
    var phi_5029_: f32;
    var phi_5034_: f32;
    var phi_5039_: f32;
    var phi_5044_: f32;
    var phi_5049_: f32;
    var phi_5054_: f32;
    var phi_5059_: f32;
    var phi_5064_: f32;
    var phi_5070_: f32;
    var phi_5076_: f32;
    var phi_5083_: f32;
    var phi_5094_: f32;
    var phi_5104_: f32;
    var phi_5177_: f32;
    var phi_5182_: f32;
    var phi_5187_: f32;
    var phi_5192_: f32;
    var phi_5197_: f32;
    var phi_5202_: f32;
    var phi_5207_: f32;
    var phi_5212_: f32;
    var phi_5217_: f32;
    var phi_5222_: f32;
    var phi_5227_: f32;
    var phi_5232_: f32;
    var phi_5237_: f32;
    var phi_5242_: f32;
    var phi_5248_: f32;
    var phi_5254_: f32;
    var phi_5261_: f32;
    var phi_5272_: f32;
    var phi_5282_: f32;
    var phi_5283_: f32;
    var phi_5286_: bool;
    var phi_5531_: f32;
    var phi_5538_: f32;
    var phi_5543_: f32;
    var phi_5550_: f32;
    var phi_5555_: f32;
    var phi_5568_: f32;
    var phi_5575_: f32;
    var phi_5580_: f32;
    var phi_5587_: f32;
    var phi_5592_: f32;
    var phi_5597_: f32;
    var phi_5614_: f32;
    var phi_5621_: f32;
    var phi_5626_: f32;
    var phi_5633_: f32;
    var phi_5638_: f32;
    var phi_5652_: f32;
    var phi_5659_: f32;
    var phi_5664_: f32;
    var phi_5671_: f32;
    var phi_5676_: f32;
    var phi_5681_: f32;
    var phi_5698_: f32;
    var phi_5705_: f32;
    var phi_5710_: f32;
    var phi_5717_: f32;
    var phi_5722_: f32;
    var phi_5736_: f32;
    var phi_5743_: f32;
    var phi_5748_: f32;
    var phi_5755_: f32;
    var phi_5760_: f32;
    var phi_5765_: f32;
    var phi_5796_: f32;
    var phi_5802_: f32;
    var phi_5809_: f32;
    var phi_5816_: f32;
    var phi_5822_: f32;
    var phi_5829_: f32;
    var phi_5835_: f32;
    var phi_5841_: f32;
    var phi_5847_: f32;
    var phi_5854_: f32;
    var phi_5861_: f32;
    var phi_5885_: f32;
    var phi_5890_: f32;
    var phi_5895_: f32;
    var phi_5900_: f32;
    var phi_5905_: f32;
    var phi_5910_: f32;
    var phi_5920_: f32;
    var phi_6036_: array<f32, 3>;
    var phi_6101_: array<f32, 3>;
    var phi_6123_: f32;
    var phi_6130_: f32;
    var phi_6135_: f32;
    var phi_6142_: f32;
    var phi_6147_: f32;
    var phi_6160_: f32;
    var phi_6167_: f32;
    var phi_6172_: f32;
    var phi_6179_: f32;
    var phi_6184_: f32;
    var phi_6189_: f32;
    var phi_6206_: f32;
    var phi_6213_: f32;
    var phi_6218_: f32;
    var phi_6225_: f32;
    var phi_6230_: f32;
    var phi_6244_: f32;
    var phi_6251_: f32;
    var phi_6256_: f32;
    var phi_6263_: f32;
    var phi_6268_: f32;
    var phi_6273_: f32;
    var phi_6290_: f32;
    var phi_6297_: f32;
    var phi_6302_: f32;
    var phi_6309_: f32;
    var phi_6314_: f32;
    var phi_6328_: f32;
    var phi_6335_: f32;
    var phi_6340_: f32;
    var phi_6347_: f32;
    var phi_6352_: f32;
    var phi_6357_: f32;
    var phi_6436_: f32;
    var phi_6441_: f32;
    var phi_6446_: f32;
    var phi_6451_: f32;
    var phi_6456_: f32;
    var phi_6461_: f32;
    var phi_6466_: f32;
    var phi_6471_: f32;
    var phi_6476_: f32;
    var phi_6481_: f32;
    var phi_6486_: f32;
    var phi_6491_: f32;
    var phi_6496_: f32;
    var phi_6501_: f32;
    var phi_6507_: f32;
    var phi_6513_: f32;
    var phi_6520_: f32;
    var phi_6531_: f32;
    var phi_6602_: f32;
    var phi_6607_: f32;
    var phi_6612_: f32;
    var phi_6617_: f32;
    var phi_6622_: f32;
    var phi_6627_: f32;
    var phi_6632_: f32;
    var phi_6637_: f32;
    var phi_6642_: f32;
    var phi_6647_: f32;
    var phi_6652_: f32;
    var phi_6657_: f32;
    var phi_6662_: f32;
    var phi_6667_: f32;
    var phi_6673_: f32;
    var phi_6679_: f32;
    var phi_6686_: f32;
    var phi_6697_: f32;
    var phi_6707_: f32;
    var phi_6780_: f32;
    var phi_6785_: f32;
    var phi_6790_: f32;
    var phi_6795_: f32;
    var phi_6800_: f32;
    var phi_6805_: f32;
    var phi_6810_: f32;
    var phi_6815_: f32;
    var phi_6820_: f32;
    var phi_6825_: f32;
    var phi_6830_: f32;
    var phi_6835_: f32;
    var phi_6840_: f32;
    var phi_6845_: f32;
    var phi_6851_: f32;
    var phi_6857_: f32;
    var phi_6864_: f32;
    var phi_6875_: f32;
    var phi_6885_: f32;
    var phi_6886_: f32;
    var phi_6889_: bool;
    var phi_6891_: bool;
    var phi_6893_: bool;
    var phi_6900_: u32;
    var phi_6901_: u32;
    var phi_6902_: bool;
    var phi_6903_: u32;
    var phi_6904_: bool;
    var phi_6905_: type_9;
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
        phi_316_ = _e75;
    } else {
        phi_316_ = _e77;
    }
    let _e80 = phi_316_;
    let _e82 = params.member.member_1.member_1;
    if (_e80 > _e82) {
        let _e85 = params.member.member_1.member_1;
        phi_326_ = (_e80 - _e85);
    } else {
        phi_326_ = 0u;
    }
    let _e88 = phi_326_;
    let _e90 = params.member.member_1.member;
    if (_e90 < _e88) {
        phi_333_ = _e90;
    } else {
        phi_333_ = _e88;
    }
    let _e93 = phi_333_;
    let _e94 = (_e93 / 128u);
    if ((_e93 % 128u) > 0u) {
        phi_349_ = (_e94 + 1u);
    } else {
        phi_349_ = _e94;
    }
    let _e99 = phi_349_;
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
            phi_370_ = (_e103 + 1u);
        } else {
            phi_370_ = _e103;
        }
        let _e109 = phi_370_;
        phi_371_ = _e109;
    } else {
        phi_371_ = 0u;
    }
    let _e111 = phi_371_;
    phi_374_ = type_9(0u, _e111);
    loop {
        let _e114 = phi_374_;
        if (_e114.member < _e114.member_1) {
            phi_375_ = type_9((_e114.member + 1u), _e114.member_1);
            phi_398_ = type_9(1u, _e114.member);
        } else {
            phi_375_ = _e114;
            phi_398_ = type_9(0u, type_9().member_1);
        }
        let _e126 = phi_375_;
        let _e128 = phi_398_;
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
                    phi_533_ = type_31(0u, array<u32, 4>(_e147, _e169, _e172, _e175));
                } else {
                    let _e153 = (2u * _e147);
                    let _e154 = (2u * _e150);
                    let _e156 = elements.member[_e153];
                    let _e158 = elements.member[_e154];
                    let _e161 = elements.member[(_e153 + 1u)];
                    let _e164 = elements.member[(_e154 + 1u)];
                    phi_533_ = type_31(1u, array<u32, 4>(_e156, _e161, _e158, _e164));
                }
                let _e179 = phi_533_;
                if (_e73 == 0u) {
                    phi_548_ = array<u32, 3>(_e179.member_1[1], _e179.member_1[2], _e179.member_1[3]);
                    phi_549_ = array<u32, 3>(_e179.member_1[0], _e179.member_1[0], _e179.member_1[0]);
                } else {
                    phi_548_ = array<u32, 3>(_e179.member_1[2], _e179.member_1[3], _e179.member_1[3]);
                    phi_549_ = array<u32, 3>(_e179.member_1[0], _e179.member_1[1], _e179.member_1[1]);
                }
                let _e192 = phi_548_;
                let _e194 = phi_549_;
                if (_e73 == 0u) {
                    let _e208 = params.member.member.member_2[2u];
                    phi_571_ = array<u32, 2>(_e147, (_e208 + _e150));
                } else {
                    let _e199 = params.member.member.member_2[1u];
                    let _e203 = params.member.member.member_2[1u];
                    phi_571_ = array<u32, 2>((_e199 + _e147), (_e203 + _e150));
                }
                let _e212 = phi_571_;
                let _e216 = boxes.member[_e212[0]];
                let _e218 = boxes.member[_e212[1]];
                let _e221 = params.member.member.member_1;
                if ((_e221 & 1u) != 0u) {
                    if (_e73 == 0u) {
                        if (_e192[0] == _e194[0]) {
                            phi_613_ = true;
                        } else {
                            phi_613_ = (_e192[0] == _e194[0]);
                        }
                        let _e243 = phi_613_;
                        if (_e192[1] == _e194[0]) {
                            phi_620_ = true;
                        } else {
                            phi_620_ = (_e192[1] == _e194[0]);
                        }
                        let _e248 = phi_620_;
                        if (_e192[2] == _e194[0]) {
                            phi_628_ = true;
                        } else {
                            phi_628_ = (_e192[2] == _e194[0]);
                        }
                        let _e254 = phi_628_;
                        phi_647_ = ((_e243 || _e248) || _e254);
                    } else {
                        if (_e192[0] == _e194[0]) {
                            phi_639_ = true;
                        } else {
                            phi_639_ = (_e192[0] == _e194[1]);
                        }
                        let _e232 = phi_639_;
                        if (_e192[1] == _e194[0]) {
                            phi_645_ = true;
                        } else {
                            phi_645_ = (_e192[1] == _e194[1]);
                        }
                        let _e236 = phi_645_;
                        phi_647_ = (_e232 || _e236);
                    }
                    let _e257 = phi_647_;
                    if _e257 {
                        phi_651_ = false;
                    } else {
                        phi_651_ = true;
                    }
                    let _e259 = phi_651_;
                    phi_652_ = _e259;
                } else {
                    phi_652_ = true;
                }
                let _e261 = phi_652_;
                if _e261 {
                    let _e263 = params.member.member.member_1;
                    if ((_e263 & 2u) != 0u) {
                        let _e268 = bodies.member[_e194[0]];
                        let _e271 = bodies.member[_e192[0]];
                        if ((_e268 / 4u) != (_e271 / 4u)) {
                            phi_697_ = true;
                        } else {
                            if ((_e268 & 2u) == 0u) {
                                phi_696_ = false;
                            } else {
                                phi_696_ = true;
                            }
                            let _e278 = phi_696_;
                            phi_697_ = _e278;
                        }
                        let _e280 = phi_697_;
                        if _e280 {
                            phi_704_ = (((_e268 & _e271) & 1u) == 0u);
                        } else {
                            phi_704_ = false;
                        }
                        let _e285 = phi_704_;
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
                                        phi_820_ = true;
                                    } else {
                                        phi_820_ = ((_e268 >> bitcast<u32>(2i)) == (_e271 >> bitcast<u32>(2i)));
                                    }
                                    let _e340 = phi_820_;
                                    phi_821_ = _e340;
                                } else {
                                    phi_821_ = false;
                                }
                                let _e342 = phi_821_;
                                if _e342 {
                                    let _e345 = bodies.member[(_e292 + 2u)];
                                    let _e348 = bodies.member[(_e292 + 3u)];
                                    let _e349 = (_e348 + _e292);
                                    if (_e73 == 1u) {
                                        if (_e150 < _e147) {
                                            phi_856_ = _e147;
                                            phi_857_ = _e150;
                                        } else {
                                            phi_856_ = _e150;
                                            phi_857_ = _e147;
                                        }
                                        let _e353 = phi_856_;
                                        let _e355 = phi_857_;
                                        phi_858_ = _e353;
                                        phi_859_ = _e355;
                                    } else {
                                        phi_858_ = _e150;
                                        phi_859_ = _e147;
                                    }
                                    let _e357 = phi_858_;
                                    let _e359 = phi_859_;
                                    phi_862_ = type_16(0i, 32i);
                                    phi_865_ = _e345;
                                    phi_867_ = 0u;
                                    loop {
                                        let _e361 = phi_862_;
                                        let _e363 = phi_865_;
                                        let _e365 = phi_867_;
                                        local_3 = _e365;
                                        local_4 = _e365;
                                        if (_e361.member < _e361.member_1) {
                                            let _e372 = (_e361.member + 1i);
                                            if ((false == (_e372 > _e361.member)) != false) {
                                                phi_888_ = true;
                                            } else {
                                                phi_888_ = false;
                                            }
                                            let _e377 = phi_888_;
                                            if _e377 {
                                                phi_894_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_894_ = type_17(1u, _e372);
                                            }
                                            let _e382 = phi_894_;
                                            phi_863_ = type_16(_e382.member_1, _e361.member_1);
                                            phi_908_ = type_17(1u, _e361.member);
                                        } else {
                                            phi_863_ = _e361;
                                            phi_908_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e388 = phi_863_;
                                        let _e390 = phi_908_;
                                        if (bitcast<i32>(_e390.member) != 0i) {
                                            if (_e365 >= _e363) {
                                                phi_991_ = u32();
                                                phi_992_ = u32();
                                                phi_993_ = false;
                                            } else {
                                                let _e397 = (_e365 + ((_e363 - _e365) / 2u));
                                                let _e399 = (_e349 + (3u * _e397));
                                                let _e401 = bodies.member[_e399];
                                                let _e404 = bodies.member[(_e399 + 1u)];
                                                let _e407 = bodies.member[(_e399 + 2u)];
                                                if (_e401 < _e73) {
                                                    phi_984_ = true;
                                                } else {
                                                    if (_e401 == _e73) {
                                                        if (_e404 < _e359) {
                                                            phi_978_ = false;
                                                        } else {
                                                            if (_e404 == _e359) {
                                                                if (_e407 < _e357) {
                                                                    phi_976_ = false;
                                                                } else {
                                                                    phi_976_ = true;
                                                                }
                                                                let _e414 = phi_976_;
                                                                phi_977_ = _e414;
                                                            } else {
                                                                phi_977_ = true;
                                                            }
                                                            let _e416 = phi_977_;
                                                            phi_978_ = _e416;
                                                        }
                                                        let _e418 = phi_978_;
                                                        phi_979_ = _e418;
                                                    } else {
                                                        phi_979_ = true;
                                                    }
                                                    let _e420 = phi_979_;
                                                    if _e420 {
                                                        phi_983_ = false;
                                                    } else {
                                                        phi_983_ = true;
                                                    }
                                                    let _e422 = phi_983_;
                                                    phi_984_ = _e422;
                                                }
                                                let _e424 = phi_984_;
                                                if _e424 {
                                                    phi_989_ = _e363;
                                                    phi_990_ = (_e397 + 1u);
                                                } else {
                                                    phi_989_ = _e397;
                                                    phi_990_ = _e365;
                                                }
                                                let _e427 = phi_989_;
                                                let _e429 = phi_990_;
                                                phi_991_ = _e427;
                                                phi_992_ = _e429;
                                                phi_993_ = true;
                                            }
                                            let _e431 = phi_991_;
                                            let _e433 = phi_992_;
                                            let _e435 = phi_993_;
                                            phi_866_ = _e431;
                                            phi_868_ = _e433;
                                            phi_994_ = _e435;
                                        } else {
                                            phi_866_ = u32();
                                            phi_868_ = u32();
                                            phi_994_ = false;
                                        }
                                        let _e437 = phi_866_;
                                        let _e439 = phi_868_;
                                        let _e441 = phi_994_;
                                        continue;
                                        continuing {
                                            phi_862_ = _e388;
                                            phi_865_ = _e437;
                                            phi_867_ = _e439;
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
                                                phi_1042_ = (_e459 == _e357);
                                                phi_1043_ = false;
                                            } else {
                                                phi_1042_ = bool();
                                                phi_1043_ = true;
                                            }
                                            let _e462 = phi_1042_;
                                            let _e464 = phi_1043_;
                                            phi_1044_ = _e462;
                                            phi_1045_ = _e464;
                                        } else {
                                            phi_1044_ = bool();
                                            phi_1045_ = true;
                                        }
                                        let _e466 = phi_1044_;
                                        let _e468 = phi_1045_;
                                        if _e468 {
                                            phi_1049_ = false;
                                        } else {
                                            phi_1049_ = _e466;
                                        }
                                        let _e470 = phi_1049_;
                                        phi_1050_ = _e470;
                                    } else {
                                        phi_1050_ = false;
                                    }
                                    let _e472 = phi_1050_;
                                    phi_1054_ = _e472;
                                } else {
                                    phi_1054_ = true;
                                }
                                let _e474 = phi_1054_;
                                if _e474 {
                                    phi_1058_ = false;
                                } else {
                                    phi_1058_ = true;
                                }
                                let _e476 = phi_1058_;
                                phi_1059_ = _e476;
                            } else {
                                phi_1059_ = true;
                            }
                            let _e478 = phi_1059_;
                            if _e478 {
                                phi_1063_ = false;
                            } else {
                                phi_1063_ = true;
                            }
                            let _e480 = phi_1063_;
                            phi_1064_ = _e480;
                        } else {
                            phi_1064_ = true;
                        }
                        let _e482 = phi_1064_;
                        if _e482 {
                            phi_1068_ = false;
                        } else {
                            phi_1068_ = true;
                        }
                        let _e484 = phi_1068_;
                        phi_1069_ = _e484;
                    } else {
                        phi_1069_ = true;
                    }
                    let _e486 = phi_1069_;
                    if _e486 {
                        let _e488 = params.member.member.member_1;
                        if ((_e488 & 32u) != 0u) {
                            let _e492 = params.member.member.member_6;
                            let _e533 = (((((_e216.member_1[0] - _e218.member[0]) > _e492) && ((_e218.member_1[0] - _e216.member[0]) > _e492)) && (((_e216.member_1[1] - _e218.member[1]) > _e492) && ((_e218.member_1[1] - _e216.member[1]) > _e492))) && (((_e216.member_1[2] - _e218.member[2]) > _e492) && ((_e218.member_1[2] - _e216.member[2]) > _e492)));
                            if _e533 {
                                phi_1683_ = bool();
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
                                    phi_1206_ = true;
                                } else {
                                    if (_e547[1] == _e561[1]) {
                                        phi_1205_ = (_e547[0] > _e561[0]);
                                    } else {
                                        phi_1205_ = false;
                                    }
                                    let _e572 = phi_1205_;
                                    phi_1206_ = _e572;
                                }
                                let _e574 = phi_1206_;
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
                                    phi_1300_ = true;
                                } else {
                                    if (_e589[1] == _e603[1]) {
                                        phi_1299_ = (_e589[0] > _e603[0]);
                                    } else {
                                        phi_1299_ = false;
                                    }
                                    let _e614 = phi_1299_;
                                    phi_1300_ = _e614;
                                }
                                let _e616 = phi_1300_;
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
                                    phi_1395_ = true;
                                } else {
                                    if (_e632[1] == _e646[1]) {
                                        phi_1394_ = (_e632[0] > _e646[0]);
                                    } else {
                                        phi_1394_ = false;
                                    }
                                    let _e657 = phi_1394_;
                                    phi_1395_ = _e657;
                                }
                                let _e659 = phi_1395_;
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
                                    phi_1489_ = true;
                                } else {
                                    if (_e674[1] == _e688[1]) {
                                        phi_1488_ = (_e674[0] > _e688[0]);
                                    } else {
                                        phi_1488_ = false;
                                    }
                                    let _e699 = phi_1488_;
                                    phi_1489_ = _e699;
                                }
                                let _e701 = phi_1489_;
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
                                    phi_1585_ = true;
                                } else {
                                    if (_e718[1] == _e732[1]) {
                                        phi_1584_ = (_e718[0] > _e732[0]);
                                    } else {
                                        phi_1584_ = false;
                                    }
                                    let _e743 = phi_1584_;
                                    phi_1585_ = _e743;
                                }
                                let _e745 = phi_1585_;
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
                                    phi_1679_ = true;
                                } else {
                                    if (_e760[1] == _e774[1]) {
                                        phi_1678_ = (_e760[0] > _e774[0]);
                                    } else {
                                        phi_1678_ = false;
                                    }
                                    let _e785 = phi_1678_;
                                    phi_1679_ = _e785;
                                }
                                let _e787 = phi_1679_;
                                phi_1683_ = (((!(_e574) && !(_e616)) && (!(_e659) && !(_e701))) && (!(_e745) && !(_e787)));
                            }
                            let _e792 = phi_1683_;
                            phi_1684_ = _e792;
                            phi_1685_ = _e533;
                        } else {
                            phi_1684_ = bool();
                            phi_1685_ = true;
                        }
                        let _e794 = phi_1684_;
                        let _e796 = phi_1685_;
                        if _e796 {
                            phi_1689_ = false;
                        } else {
                            phi_1689_ = true;
                        }
                        let _e798 = phi_1689_;
                        phi_1690_ = _e794;
                        phi_1691_ = _e798;
                    } else {
                        phi_1690_ = false;
                        phi_1691_ = true;
                    }
                    let _e800 = phi_1690_;
                    let _e802 = phi_1691_;
                    phi_1692_ = _e800;
                    phi_1693_ = _e802;
                } else {
                    phi_1692_ = false;
                    phi_1693_ = true;
                }
                let _e804 = phi_1692_;
                let _e806 = phi_1693_;
                if _e806 {
                    phi_1697_ = _e804;
                } else {
                    phi_1697_ = true;
                }
                let _e808 = phi_1697_;
                if _e808 {
                    let _e810 = atomicAdd((&counters[1u]), 1u);
                    let _e813 = params.member.member.member_4;
                    let _e815 = params.member.member.member_5;
                    let _e818 = paths.member[_e179.member_1[0]];
                    let _e833 = paths.member[_e179.member_1[1]];
                    let _e848 = paths.member[_e179.member_1[2]];
                    let _e863 = paths.member[_e179.member_1[3]];
                    if (_e179.member != 0u) {
                        phi_1838_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e848.member.x - _e818.member.x), (_e848.member.y - _e818.member.y), (_e848.member.z - _e818.member.z)), array<f32, 3>((_e848.member_1.x - _e818.member_1.x), (_e848.member_1.y - _e818.member_1.y), (_e848.member_1.z - _e818.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e833.member.x - _e818.member.x), (_e833.member.y - _e818.member.y), (_e833.member.z - _e818.member.z)), array<f32, 3>((_e833.member_1.x - _e818.member_1.x), (_e833.member_1.y - _e818.member_1.y), (_e833.member_1.z - _e818.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e848.member.x - _e863.member.x), (_e848.member.y - _e863.member.y), (_e848.member.z - _e863.member.z)), array<f32, 3>((_e848.member_1.x - _e863.member_1.x), (_e848.member_1.y - _e863.member_1.y), (_e848.member_1.z - _e863.member_1.z))), (_e813 + _e813));
                    } else {
                        phi_1838_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e818.member.x - _e833.member.x), (_e818.member.y - _e833.member.y), (_e818.member.z - _e833.member.z)), array<f32, 3>((_e818.member_1.x - _e833.member_1.x), (_e818.member_1.y - _e833.member_1.y), (_e818.member_1.z - _e833.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e848.member.x - _e833.member.x), (_e848.member.y - _e833.member.y), (_e848.member.z - _e833.member.z)), array<f32, 3>((_e848.member_1.x - _e833.member_1.x), (_e848.member_1.y - _e833.member_1.y), (_e848.member_1.z - _e833.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e863.member.x - _e833.member.x), (_e863.member.y - _e833.member.y), (_e863.member.z - _e833.member.z)), array<f32, 3>((_e863.member_1.x - _e833.member_1.x), (_e863.member_1.y - _e833.member_1.y), (_e863.member_1.z - _e833.member_1.z))), (_e813 + _e813));
                    }
                    let _e936 = phi_1838_;
                    local_2 = type_27(array<array<f32, 3>, 2>(array<f32, 3>(_e936.member[0][0], _e936.member[0][1], _e936.member[0][2]), array<f32, 3>(_e936.member[1][0], _e936.member[1][1], _e936.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e936.member_1[0][0], _e936.member_1[0][1], _e936.member_1[0][2]), array<f32, 3>(_e936.member_1[1][0], _e936.member_1[1][1], _e936.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e936.member_2[0][0], _e936.member_2[0][1], _e936.member_2[0][2]), array<f32, 3>(_e936.member_2[1][0], _e936.member_2[1][1], _e936.member_2[1][2])), _e936.member_3);
                    let _e977 = local_2.member_1[0u];
                    let _e983 = local_2.member_2[0u];
                    let _e989 = ((_e977[1] * _e983[2]) - (_e977[2] * _e983[1]));
                    let _e992 = ((_e977[2] * _e983[0]) - (_e977[0] * _e983[2]));
                    let _e995 = ((_e977[0] * _e983[1]) - (_e977[1] * _e983[0]));
                    let _e998 = local_2.member_1[1u];
                    let _e1004 = local_2.member_2[1u];
                    let _e1010 = ((_e998[1] * _e1004[2]) - (_e998[2] * _e1004[1]));
                    let _e1013 = ((_e998[2] * _e1004[0]) - (_e998[0] * _e1004[2]));
                    let _e1016 = ((_e998[0] * _e1004[1]) - (_e998[1] * _e1004[0]));
                    let _e1019 = local_2.member_1[0u];
                    let _e1025 = local_2.member_2[1u];
                    let _e1040 = local_2.member_1[1u];
                    let _e1046 = local_2.member_2[0u];
                    let _e1059 = (((_e1019[1] * _e1025[2]) - (_e1019[2] * _e1025[1])) + ((_e1040[1] * _e1046[2]) - (_e1040[2] * _e1046[1])));
                    let _e1060 = (((_e1019[2] * _e1025[0]) - (_e1019[0] * _e1025[2])) + ((_e1040[2] * _e1046[0]) - (_e1040[0] * _e1046[2])));
                    let _e1061 = (((_e1019[0] * _e1025[1]) - (_e1019[1] * _e1025[0])) + ((_e1040[0] * _e1046[1]) - (_e1040[1] * _e1046[0])));
                    let _e1064 = local_2.member[0u];
                    let _e1075 = local_2.member[1u];
                    let _e1086 = local_2.member[0u];
                    let _e1095 = ((((_e1075[0] * _e989) + (_e1075[1] * _e992)) + (_e1075[2] * _e995)) + (((_e1086[0] * _e1059) + (_e1086[1] * _e1060)) + (_e1086[2] * _e1061)));
                    let _e1098 = local_2.member[0u];
                    let _e1109 = local_2.member[1u];
                    let _e1118 = ((((_e1098[0] * _e1010) + (_e1098[1] * _e1013)) + (_e1098[2] * _e1016)) + (((_e1109[0] * _e1059) + (_e1109[1] * _e1060)) + (_e1109[2] * _e1061)));
                    let _e1121 = local_2.member[1u];
                    let _e1132 = local_2.member[0u];
                    if (_e1132[0] < 0f) {
                        phi_2118_ = -(_e1132[0]);
                    } else {
                        phi_2118_ = _e1132[0];
                    }
                    let _e1139 = phi_2118_;
                    if (_e1132[1] < 0f) {
                        phi_2125_ = -(_e1132[1]);
                    } else {
                        phi_2125_ = _e1132[1];
                    }
                    let _e1143 = phi_2125_;
                    if (_e1139 > _e1143) {
                        phi_2130_ = _e1139;
                    } else {
                        phi_2130_ = _e1143;
                    }
                    let _e1146 = phi_2130_;
                    if (_e1132[2] < 0f) {
                        phi_2137_ = -(_e1132[2]);
                    } else {
                        phi_2137_ = _e1132[2];
                    }
                    let _e1150 = phi_2137_;
                    if (_e1146 > _e1150) {
                        phi_2142_ = _e1146;
                    } else {
                        phi_2142_ = _e1150;
                    }
                    let _e1153 = phi_2142_;
                    let _e1156 = local_2.member[1u];
                    if (_e1156[0] < 0f) {
                        phi_2155_ = -(_e1156[0]);
                    } else {
                        phi_2155_ = _e1156[0];
                    }
                    let _e1163 = phi_2155_;
                    if (_e1156[1] < 0f) {
                        phi_2162_ = -(_e1156[1]);
                    } else {
                        phi_2162_ = _e1156[1];
                    }
                    let _e1167 = phi_2162_;
                    if (_e1163 > _e1167) {
                        phi_2167_ = _e1163;
                    } else {
                        phi_2167_ = _e1167;
                    }
                    let _e1170 = phi_2167_;
                    if (_e1156[2] < 0f) {
                        phi_2174_ = -(_e1156[2]);
                    } else {
                        phi_2174_ = _e1156[2];
                    }
                    let _e1174 = phi_2174_;
                    if (_e1170 > _e1174) {
                        phi_2179_ = _e1170;
                    } else {
                        phi_2179_ = _e1174;
                    }
                    let _e1177 = phi_2179_;
                    if (_e1153 > _e1177) {
                        phi_2184_ = _e1153;
                    } else {
                        phi_2184_ = _e1177;
                    }
                    let _e1180 = phi_2184_;
                    let _e1182 = local_2.member_3;
                    let _e1183 = (_e1180 + _e1182);
                    let _e1186 = local_2.member_1[0u];
                    if (_e1186[0] < 0f) {
                        phi_2201_ = -(_e1186[0]);
                    } else {
                        phi_2201_ = _e1186[0];
                    }
                    let _e1193 = phi_2201_;
                    if (_e1186[1] < 0f) {
                        phi_2208_ = -(_e1186[1]);
                    } else {
                        phi_2208_ = _e1186[1];
                    }
                    let _e1197 = phi_2208_;
                    if (_e1193 > _e1197) {
                        phi_2213_ = _e1193;
                    } else {
                        phi_2213_ = _e1197;
                    }
                    let _e1200 = phi_2213_;
                    if (_e1186[2] < 0f) {
                        phi_2220_ = -(_e1186[2]);
                    } else {
                        phi_2220_ = _e1186[2];
                    }
                    let _e1204 = phi_2220_;
                    if (_e1200 > _e1204) {
                        phi_2225_ = _e1200;
                    } else {
                        phi_2225_ = _e1204;
                    }
                    let _e1207 = phi_2225_;
                    let _e1210 = local_2.member_1[1u];
                    if (_e1210[0] < 0f) {
                        phi_2239_ = -(_e1210[0]);
                    } else {
                        phi_2239_ = _e1210[0];
                    }
                    let _e1217 = phi_2239_;
                    if (_e1210[1] < 0f) {
                        phi_2246_ = -(_e1210[1]);
                    } else {
                        phi_2246_ = _e1210[1];
                    }
                    let _e1221 = phi_2246_;
                    if (_e1217 > _e1221) {
                        phi_2251_ = _e1217;
                    } else {
                        phi_2251_ = _e1221;
                    }
                    let _e1224 = phi_2251_;
                    if (_e1210[2] < 0f) {
                        phi_2258_ = -(_e1210[2]);
                    } else {
                        phi_2258_ = _e1210[2];
                    }
                    let _e1228 = phi_2258_;
                    if (_e1224 > _e1228) {
                        phi_2263_ = _e1224;
                    } else {
                        phi_2263_ = _e1228;
                    }
                    let _e1231 = phi_2263_;
                    if (_e1207 > _e1231) {
                        phi_2268_ = _e1207;
                    } else {
                        phi_2268_ = _e1231;
                    }
                    let _e1234 = phi_2268_;
                    let _e1236 = local_2.member_3;
                    let _e1237 = (_e1234 + _e1236);
                    let _e1240 = local_2.member_2[0u];
                    if (_e1240[0] < 0f) {
                        phi_2285_ = -(_e1240[0]);
                    } else {
                        phi_2285_ = _e1240[0];
                    }
                    let _e1247 = phi_2285_;
                    if (_e1240[1] < 0f) {
                        phi_2292_ = -(_e1240[1]);
                    } else {
                        phi_2292_ = _e1240[1];
                    }
                    let _e1251 = phi_2292_;
                    if (_e1247 > _e1251) {
                        phi_2297_ = _e1247;
                    } else {
                        phi_2297_ = _e1251;
                    }
                    let _e1254 = phi_2297_;
                    if (_e1240[2] < 0f) {
                        phi_2304_ = -(_e1240[2]);
                    } else {
                        phi_2304_ = _e1240[2];
                    }
                    let _e1258 = phi_2304_;
                    if (_e1254 > _e1258) {
                        phi_2309_ = _e1254;
                    } else {
                        phi_2309_ = _e1258;
                    }
                    let _e1261 = phi_2309_;
                    let _e1264 = local_2.member_2[1u];
                    if (_e1264[0] < 0f) {
                        phi_2323_ = -(_e1264[0]);
                    } else {
                        phi_2323_ = _e1264[0];
                    }
                    let _e1271 = phi_2323_;
                    if (_e1264[1] < 0f) {
                        phi_2330_ = -(_e1264[1]);
                    } else {
                        phi_2330_ = _e1264[1];
                    }
                    let _e1275 = phi_2330_;
                    if (_e1271 > _e1275) {
                        phi_2335_ = _e1271;
                    } else {
                        phi_2335_ = _e1275;
                    }
                    let _e1278 = phi_2335_;
                    if (_e1264[2] < 0f) {
                        phi_2342_ = -(_e1264[2]);
                    } else {
                        phi_2342_ = _e1264[2];
                    }
                    let _e1282 = phi_2342_;
                    if (_e1278 > _e1282) {
                        phi_2347_ = _e1278;
                    } else {
                        phi_2347_ = _e1282;
                    }
                    let _e1285 = phi_2347_;
                    if (_e1261 > _e1285) {
                        phi_2352_ = _e1261;
                    } else {
                        phi_2352_ = _e1285;
                    }
                    let _e1288 = phi_2352_;
                    let _e1290 = local_2.member_3;
                    let _e1291 = (_e1288 + _e1290);
                    let _e1293 = ((_e1237 * 8f) * _e1291);
                    let _e1300 = local_2.member_3;
                    if (_e989 < 0f) {
                        phi_2383_ = -(_e989);
                    } else {
                        phi_2383_ = _e989;
                    }
                    let _e1317 = phi_2383_;
                    if (_e992 < 0f) {
                        phi_2389_ = -(_e992);
                    } else {
                        phi_2389_ = _e992;
                    }
                    let _e1321 = phi_2389_;
                    if (_e995 < 0f) {
                        phi_2396_ = -(_e995);
                    } else {
                        phi_2396_ = _e995;
                    }
                    let _e1326 = phi_2396_;
                    let _e1327 = ((_e1317 + _e1321) + _e1326);
                    if (_e1010 < 0f) {
                        phi_2403_ = -(_e1010);
                    } else {
                        phi_2403_ = _e1010;
                    }
                    let _e1331 = phi_2403_;
                    if (_e1013 < 0f) {
                        phi_2409_ = -(_e1013);
                    } else {
                        phi_2409_ = _e1013;
                    }
                    let _e1335 = phi_2409_;
                    if (_e1016 < 0f) {
                        phi_2416_ = -(_e1016);
                    } else {
                        phi_2416_ = _e1016;
                    }
                    let _e1340 = phi_2416_;
                    let _e1341 = ((_e1331 + _e1335) + _e1340);
                    if (_e1327 > _e1341) {
                        phi_2422_ = _e1327;
                    } else {
                        phi_2422_ = _e1341;
                    }
                    let _e1344 = phi_2422_;
                    if (_e1059 < 0f) {
                        phi_2428_ = -(_e1059);
                    } else {
                        phi_2428_ = _e1059;
                    }
                    let _e1348 = phi_2428_;
                    if (_e1060 < 0f) {
                        phi_2434_ = -(_e1060);
                    } else {
                        phi_2434_ = _e1060;
                    }
                    let _e1352 = phi_2434_;
                    if (_e1061 < 0f) {
                        phi_2441_ = -(_e1061);
                    } else {
                        phi_2441_ = _e1061;
                    }
                    let _e1357 = phi_2441_;
                    let _e1359 = (((_e1348 + _e1352) + _e1357) * 0.5f);
                    if (_e1344 > _e1359) {
                        phi_2448_ = _e1344;
                    } else {
                        phi_2448_ = _e1359;
                    }
                    let _e1362 = phi_2448_;
                    let _e1367 = local_2.member_3;
                    let _e1380 = ((((_e1064[0] * _e989) + (_e1064[1] * _e992)) + (_e1064[2] * _e995)) * 3f);
                    let _e1381 = ((((_e1121[0] * _e1010) + (_e1121[1] * _e1013)) + (_e1121[2] * _e1016)) * 3f);
                    if (_e1380 < _e1381) {
                        phi_2472_ = _e1380;
                    } else {
                        phi_2472_ = _e1381;
                    }
                    let _e1384 = phi_2472_;
                    if (_e1095 < _e1118) {
                        phi_2477_ = _e1095;
                    } else {
                        phi_2477_ = _e1118;
                    }
                    let _e1387 = phi_2477_;
                    if (_e1384 < _e1387) {
                        phi_2482_ = _e1384;
                    } else {
                        phi_2482_ = _e1387;
                    }
                    let _e1390 = phi_2482_;
                    if (_e1380 > _e1381) {
                        phi_2487_ = _e1380;
                    } else {
                        phi_2487_ = _e1381;
                    }
                    let _e1393 = phi_2487_;
                    if (_e1095 > _e1118) {
                        phi_2492_ = _e1095;
                    } else {
                        phi_2492_ = _e1118;
                    }
                    let _e1396 = phi_2492_;
                    if (_e1393 > _e1396) {
                        phi_2497_ = _e1393;
                    } else {
                        phi_2497_ = _e1396;
                    }
                    let _e1399 = phi_2497_;
                    let _e1404 = -(_e1399);
                    if (_e1390 > _e1404) {
                        phi_2507_ = _e1390;
                    } else {
                        phi_2507_ = _e1404;
                    }
                    let _e1407 = phi_2507_;
                    let _e1409 = ((_e1407 - ((((((_e1183 * 8f) * _e1293) * (0.000000059604645f * (524f / 64f))) + ((_e1300 * 19f) * ((_e1183 * (_e1237 + _e1291)) + (_e1237 * _e1291)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1183) * ((1f + _e1237) * (1f + _e1291))))) + ((_e815 * (((_e1362 + (_e1293 * (0.000000059604645f * 8f))) + ((_e1367 * 6f) * (_e1237 + _e1291))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1237) * (1f + _e1291))))) * (3f * 1.0001f)))) > 0f);
                    if _e1409 {
                        phi_3476_ = _e1409;
                    } else {
                        let _e1412 = local_2.member_1[0u];
                        let _e1418 = local_2.member_1[1u];
                        let _e1422 = (_e1412[0] + _e1418[0]);
                        let _e1423 = (_e1412[1] + _e1418[1]);
                        let _e1424 = (_e1412[2] + _e1418[2]);
                        let _e1427 = local_2.member_2[0u];
                        let _e1433 = local_2.member_2[1u];
                        let _e1437 = (_e1427[0] + _e1433[0]);
                        let _e1438 = (_e1427[1] + _e1433[1]);
                        let _e1439 = (_e1427[2] + _e1433[2]);
                        let _e1442 = ((_e1423 * _e1439) - (_e1424 * _e1438));
                        let _e1445 = ((_e1424 * _e1437) - (_e1422 * _e1439));
                        let _e1448 = ((_e1422 * _e1438) - (_e1423 * _e1437));
                        let _e1451 = local_2.member[0u];
                        let _e1458 = local_2.member_1[0u];
                        let _e1464 = local_2.member_2[0u];
                        let _e1468 = (_e1451[0] - _e1458[0]);
                        let _e1469 = (_e1451[1] - _e1458[1]);
                        let _e1470 = (_e1451[2] - _e1458[2]);
                        if (_e179.member == 0u) {
                            phi_2623_ = array<f32, 3>(_e1451[0], _e1451[1], _e1451[2]);
                        } else {
                            phi_2623_ = array<f32, 3>((_e1468 - _e1464[0]), (_e1469 - _e1464[1]), (_e1470 - _e1464[2]));
                        }
                        let _e1477 = phi_2623_;
                        let _e1478 = (_e1451[0] - _e1464[0]);
                        let _e1479 = (_e1451[1] - _e1464[1]);
                        let _e1480 = (_e1451[2] - _e1464[2]);
                        let _e1483 = local_2.member[1u];
                        let _e1490 = local_2.member_1[1u];
                        let _e1496 = local_2.member_2[1u];
                        let _e1500 = (_e1483[0] - _e1490[0]);
                        let _e1501 = (_e1483[1] - _e1490[1]);
                        let _e1502 = (_e1483[2] - _e1490[2]);
                        if (_e179.member == 0u) {
                            phi_2688_ = array<f32, 3>(_e1483[0], _e1483[1], _e1483[2]);
                        } else {
                            phi_2688_ = array<f32, 3>((_e1500 - _e1496[0]), (_e1501 - _e1496[1]), (_e1502 - _e1496[2]));
                        }
                        let _e1509 = phi_2688_;
                        let _e1510 = (_e1483[0] - _e1496[0]);
                        let _e1511 = (_e1483[1] - _e1496[1]);
                        let _e1512 = (_e1483[2] - _e1496[2]);
                        let _e1515 = local_2.member[0u];
                        if (_e1515[0] < 0f) {
                            phi_2710_ = -(_e1515[0]);
                        } else {
                            phi_2710_ = _e1515[0];
                        }
                        let _e1522 = phi_2710_;
                        if (_e1515[1] < 0f) {
                            phi_2717_ = -(_e1515[1]);
                        } else {
                            phi_2717_ = _e1515[1];
                        }
                        let _e1526 = phi_2717_;
                        if (_e1522 > _e1526) {
                            phi_2722_ = _e1522;
                        } else {
                            phi_2722_ = _e1526;
                        }
                        let _e1529 = phi_2722_;
                        if (_e1515[2] < 0f) {
                            phi_2729_ = -(_e1515[2]);
                        } else {
                            phi_2729_ = _e1515[2];
                        }
                        let _e1533 = phi_2729_;
                        if (_e1529 > _e1533) {
                            phi_2734_ = _e1529;
                        } else {
                            phi_2734_ = _e1533;
                        }
                        let _e1536 = phi_2734_;
                        let _e1539 = local_2.member[1u];
                        if (_e1539[0] < 0f) {
                            phi_2747_ = -(_e1539[0]);
                        } else {
                            phi_2747_ = _e1539[0];
                        }
                        let _e1546 = phi_2747_;
                        if (_e1539[1] < 0f) {
                            phi_2754_ = -(_e1539[1]);
                        } else {
                            phi_2754_ = _e1539[1];
                        }
                        let _e1550 = phi_2754_;
                        if (_e1546 > _e1550) {
                            phi_2759_ = _e1546;
                        } else {
                            phi_2759_ = _e1550;
                        }
                        let _e1553 = phi_2759_;
                        if (_e1539[2] < 0f) {
                            phi_2766_ = -(_e1539[2]);
                        } else {
                            phi_2766_ = _e1539[2];
                        }
                        let _e1557 = phi_2766_;
                        if (_e1553 > _e1557) {
                            phi_2771_ = _e1553;
                        } else {
                            phi_2771_ = _e1557;
                        }
                        let _e1560 = phi_2771_;
                        if (_e1536 > _e1560) {
                            phi_2776_ = _e1536;
                        } else {
                            phi_2776_ = _e1560;
                        }
                        let _e1563 = phi_2776_;
                        let _e1565 = local_2.member_3;
                        let _e1569 = local_2.member_1[0u];
                        if (_e1569[0] < 0f) {
                            phi_2793_ = -(_e1569[0]);
                        } else {
                            phi_2793_ = _e1569[0];
                        }
                        let _e1576 = phi_2793_;
                        if (_e1569[1] < 0f) {
                            phi_2800_ = -(_e1569[1]);
                        } else {
                            phi_2800_ = _e1569[1];
                        }
                        let _e1580 = phi_2800_;
                        if (_e1576 > _e1580) {
                            phi_2805_ = _e1576;
                        } else {
                            phi_2805_ = _e1580;
                        }
                        let _e1583 = phi_2805_;
                        if (_e1569[2] < 0f) {
                            phi_2812_ = -(_e1569[2]);
                        } else {
                            phi_2812_ = _e1569[2];
                        }
                        let _e1587 = phi_2812_;
                        if (_e1583 > _e1587) {
                            phi_2817_ = _e1583;
                        } else {
                            phi_2817_ = _e1587;
                        }
                        let _e1590 = phi_2817_;
                        let _e1593 = local_2.member_1[1u];
                        if (_e1593[0] < 0f) {
                            phi_2831_ = -(_e1593[0]);
                        } else {
                            phi_2831_ = _e1593[0];
                        }
                        let _e1600 = phi_2831_;
                        if (_e1593[1] < 0f) {
                            phi_2838_ = -(_e1593[1]);
                        } else {
                            phi_2838_ = _e1593[1];
                        }
                        let _e1604 = phi_2838_;
                        if (_e1600 > _e1604) {
                            phi_2843_ = _e1600;
                        } else {
                            phi_2843_ = _e1604;
                        }
                        let _e1607 = phi_2843_;
                        if (_e1593[2] < 0f) {
                            phi_2850_ = -(_e1593[2]);
                        } else {
                            phi_2850_ = _e1593[2];
                        }
                        let _e1611 = phi_2850_;
                        if (_e1607 > _e1611) {
                            phi_2855_ = _e1607;
                        } else {
                            phi_2855_ = _e1611;
                        }
                        let _e1614 = phi_2855_;
                        if (_e1590 > _e1614) {
                            phi_2860_ = _e1590;
                        } else {
                            phi_2860_ = _e1614;
                        }
                        let _e1617 = phi_2860_;
                        let _e1619 = local_2.member_3;
                        let _e1623 = local_2.member_2[0u];
                        if (_e1623[0] < 0f) {
                            phi_2877_ = -(_e1623[0]);
                        } else {
                            phi_2877_ = _e1623[0];
                        }
                        let _e1630 = phi_2877_;
                        if (_e1623[1] < 0f) {
                            phi_2884_ = -(_e1623[1]);
                        } else {
                            phi_2884_ = _e1623[1];
                        }
                        let _e1634 = phi_2884_;
                        if (_e1630 > _e1634) {
                            phi_2889_ = _e1630;
                        } else {
                            phi_2889_ = _e1634;
                        }
                        let _e1637 = phi_2889_;
                        if (_e1623[2] < 0f) {
                            phi_2896_ = -(_e1623[2]);
                        } else {
                            phi_2896_ = _e1623[2];
                        }
                        let _e1641 = phi_2896_;
                        if (_e1637 > _e1641) {
                            phi_2901_ = _e1637;
                        } else {
                            phi_2901_ = _e1641;
                        }
                        let _e1644 = phi_2901_;
                        let _e1647 = local_2.member_2[1u];
                        if (_e1647[0] < 0f) {
                            phi_2915_ = -(_e1647[0]);
                        } else {
                            phi_2915_ = _e1647[0];
                        }
                        let _e1654 = phi_2915_;
                        if (_e1647[1] < 0f) {
                            phi_2922_ = -(_e1647[1]);
                        } else {
                            phi_2922_ = _e1647[1];
                        }
                        let _e1658 = phi_2922_;
                        if (_e1654 > _e1658) {
                            phi_2927_ = _e1654;
                        } else {
                            phi_2927_ = _e1658;
                        }
                        let _e1661 = phi_2927_;
                        if (_e1647[2] < 0f) {
                            phi_2934_ = -(_e1647[2]);
                        } else {
                            phi_2934_ = _e1647[2];
                        }
                        let _e1665 = phi_2934_;
                        if (_e1661 > _e1665) {
                            phi_2939_ = _e1661;
                        } else {
                            phi_2939_ = _e1665;
                        }
                        let _e1668 = phi_2939_;
                        if (_e1644 > _e1668) {
                            phi_2944_ = _e1644;
                        } else {
                            phi_2944_ = _e1668;
                        }
                        let _e1671 = phi_2944_;
                        let _e1673 = local_2.member_3;
                        let _e1677 = ((((_e1563 + _e1565) + (_e1617 + _e1619)) + (_e1671 + _e1673)) * 2f);
                        let _e1680 = local_2.member_3;
                        let _e1684 = (((_e815 * 1.0001f) + (_e1680 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                        let _e1687 = ((_e1445 * _e1424) - (_e1448 * _e1423));
                        let _e1690 = ((_e1448 * _e1422) - (_e1442 * _e1424));
                        let _e1693 = ((_e1442 * _e1423) - (_e1445 * _e1422));
                        let _e1698 = (((_e1687 * _e1451[0]) + (_e1690 * _e1451[1])) + (_e1693 * _e1451[2]));
                        let _e1703 = (((_e1687 * _e1468) + (_e1690 * _e1469)) + (_e1693 * _e1470));
                        let _e1708 = (((_e1687 * _e1478) + (_e1690 * _e1479)) + (_e1693 * _e1480));
                        let _e1716 = (((_e1687 * _e1477[0]) + (_e1690 * _e1477[1])) + (_e1693 * _e1477[2]));
                        let _e1721 = (((_e1687 * _e1483[0]) + (_e1690 * _e1483[1])) + (_e1693 * _e1483[2]));
                        let _e1726 = (((_e1687 * _e1500) + (_e1690 * _e1501)) + (_e1693 * _e1502));
                        let _e1731 = (((_e1687 * _e1510) + (_e1690 * _e1511)) + (_e1693 * _e1512));
                        let _e1739 = (((_e1687 * _e1509[0]) + (_e1690 * _e1509[1])) + (_e1693 * _e1509[2]));
                        if (_e1698 < _e1703) {
                            phi_3023_ = _e1698;
                        } else {
                            phi_3023_ = _e1703;
                        }
                        let _e1742 = phi_3023_;
                        if (_e1708 < _e1716) {
                            phi_3028_ = _e1708;
                        } else {
                            phi_3028_ = _e1716;
                        }
                        let _e1745 = phi_3028_;
                        if (_e1742 < _e1745) {
                            phi_3033_ = _e1742;
                        } else {
                            phi_3033_ = _e1745;
                        }
                        let _e1748 = phi_3033_;
                        if (_e1721 < _e1726) {
                            phi_3038_ = _e1721;
                        } else {
                            phi_3038_ = _e1726;
                        }
                        let _e1751 = phi_3038_;
                        if (_e1731 < _e1739) {
                            phi_3043_ = _e1731;
                        } else {
                            phi_3043_ = _e1739;
                        }
                        let _e1754 = phi_3043_;
                        if (_e1751 < _e1754) {
                            phi_3048_ = _e1751;
                        } else {
                            phi_3048_ = _e1754;
                        }
                        let _e1757 = phi_3048_;
                        if (_e1748 < _e1757) {
                            phi_3053_ = _e1748;
                        } else {
                            phi_3053_ = _e1757;
                        }
                        let _e1760 = phi_3053_;
                        if (_e1698 > _e1703) {
                            phi_3058_ = _e1698;
                        } else {
                            phi_3058_ = _e1703;
                        }
                        let _e1763 = phi_3058_;
                        if (_e1708 > _e1716) {
                            phi_3063_ = _e1708;
                        } else {
                            phi_3063_ = _e1716;
                        }
                        let _e1766 = phi_3063_;
                        if (_e1763 > _e1766) {
                            phi_3068_ = _e1763;
                        } else {
                            phi_3068_ = _e1766;
                        }
                        let _e1769 = phi_3068_;
                        if (_e1721 > _e1726) {
                            phi_3073_ = _e1721;
                        } else {
                            phi_3073_ = _e1726;
                        }
                        let _e1772 = phi_3073_;
                        if (_e1731 > _e1739) {
                            phi_3078_ = _e1731;
                        } else {
                            phi_3078_ = _e1739;
                        }
                        let _e1775 = phi_3078_;
                        if (_e1772 > _e1775) {
                            phi_3083_ = _e1772;
                        } else {
                            phi_3083_ = _e1775;
                        }
                        let _e1778 = phi_3083_;
                        if (_e1769 > _e1778) {
                            phi_3088_ = _e1769;
                        } else {
                            phi_3088_ = _e1778;
                        }
                        let _e1781 = phi_3088_;
                        if (_e1687 < 0f) {
                            phi_3094_ = -(_e1687);
                        } else {
                            phi_3094_ = _e1687;
                        }
                        let _e1785 = phi_3094_;
                        if (_e1690 < 0f) {
                            phi_3100_ = -(_e1690);
                        } else {
                            phi_3100_ = _e1690;
                        }
                        let _e1789 = phi_3100_;
                        if (_e1693 < 0f) {
                            phi_3107_ = -(_e1693);
                        } else {
                            phi_3107_ = _e1693;
                        }
                        let _e1794 = phi_3107_;
                        let _e1795 = ((_e1785 + _e1789) + _e1794);
                        let _e1800 = -(_e1781);
                        if (_e1760 > _e1800) {
                            phi_3118_ = _e1760;
                        } else {
                            phi_3118_ = _e1800;
                        }
                        let _e1803 = phi_3118_;
                        let _e1808 = (((_e1803 - ((_e1795 * _e1677) * (0.000000059604645f * (17f / 2f)))) - (_e1795 * _e1684)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        let _e1811 = ((_e1445 * _e1439) - (_e1448 * _e1438));
                        let _e1814 = ((_e1448 * _e1437) - (_e1442 * _e1439));
                        let _e1817 = ((_e1442 * _e1438) - (_e1445 * _e1437));
                        let _e1822 = (((_e1811 * _e1451[0]) + (_e1814 * _e1451[1])) + (_e1817 * _e1451[2]));
                        let _e1827 = (((_e1811 * _e1468) + (_e1814 * _e1469)) + (_e1817 * _e1470));
                        let _e1832 = (((_e1811 * _e1478) + (_e1814 * _e1479)) + (_e1817 * _e1480));
                        let _e1840 = (((_e1811 * _e1477[0]) + (_e1814 * _e1477[1])) + (_e1817 * _e1477[2]));
                        let _e1845 = (((_e1811 * _e1483[0]) + (_e1814 * _e1483[1])) + (_e1817 * _e1483[2]));
                        let _e1850 = (((_e1811 * _e1500) + (_e1814 * _e1501)) + (_e1817 * _e1502));
                        let _e1855 = (((_e1811 * _e1510) + (_e1814 * _e1511)) + (_e1817 * _e1512));
                        let _e1863 = (((_e1811 * _e1509[0]) + (_e1814 * _e1509[1])) + (_e1817 * _e1509[2]));
                        if (_e1822 < _e1827) {
                            phi_3189_ = _e1822;
                        } else {
                            phi_3189_ = _e1827;
                        }
                        let _e1866 = phi_3189_;
                        if (_e1832 < _e1840) {
                            phi_3194_ = _e1832;
                        } else {
                            phi_3194_ = _e1840;
                        }
                        let _e1869 = phi_3194_;
                        if (_e1866 < _e1869) {
                            phi_3199_ = _e1866;
                        } else {
                            phi_3199_ = _e1869;
                        }
                        let _e1872 = phi_3199_;
                        if (_e1845 < _e1850) {
                            phi_3204_ = _e1845;
                        } else {
                            phi_3204_ = _e1850;
                        }
                        let _e1875 = phi_3204_;
                        if (_e1855 < _e1863) {
                            phi_3209_ = _e1855;
                        } else {
                            phi_3209_ = _e1863;
                        }
                        let _e1878 = phi_3209_;
                        if (_e1875 < _e1878) {
                            phi_3214_ = _e1875;
                        } else {
                            phi_3214_ = _e1878;
                        }
                        let _e1881 = phi_3214_;
                        if (_e1872 < _e1881) {
                            phi_3219_ = _e1872;
                        } else {
                            phi_3219_ = _e1881;
                        }
                        let _e1884 = phi_3219_;
                        if (_e1822 > _e1827) {
                            phi_3224_ = _e1822;
                        } else {
                            phi_3224_ = _e1827;
                        }
                        let _e1887 = phi_3224_;
                        if (_e1832 > _e1840) {
                            phi_3229_ = _e1832;
                        } else {
                            phi_3229_ = _e1840;
                        }
                        let _e1890 = phi_3229_;
                        if (_e1887 > _e1890) {
                            phi_3234_ = _e1887;
                        } else {
                            phi_3234_ = _e1890;
                        }
                        let _e1893 = phi_3234_;
                        if (_e1845 > _e1850) {
                            phi_3239_ = _e1845;
                        } else {
                            phi_3239_ = _e1850;
                        }
                        let _e1896 = phi_3239_;
                        if (_e1855 > _e1863) {
                            phi_3244_ = _e1855;
                        } else {
                            phi_3244_ = _e1863;
                        }
                        let _e1899 = phi_3244_;
                        if (_e1896 > _e1899) {
                            phi_3249_ = _e1896;
                        } else {
                            phi_3249_ = _e1899;
                        }
                        let _e1902 = phi_3249_;
                        if (_e1893 > _e1902) {
                            phi_3254_ = _e1893;
                        } else {
                            phi_3254_ = _e1902;
                        }
                        let _e1905 = phi_3254_;
                        if (_e1811 < 0f) {
                            phi_3260_ = -(_e1811);
                        } else {
                            phi_3260_ = _e1811;
                        }
                        let _e1909 = phi_3260_;
                        if (_e1814 < 0f) {
                            phi_3266_ = -(_e1814);
                        } else {
                            phi_3266_ = _e1814;
                        }
                        let _e1913 = phi_3266_;
                        if (_e1817 < 0f) {
                            phi_3273_ = -(_e1817);
                        } else {
                            phi_3273_ = _e1817;
                        }
                        let _e1918 = phi_3273_;
                        let _e1919 = ((_e1909 + _e1913) + _e1918);
                        let _e1924 = -(_e1905);
                        if (_e1884 > _e1924) {
                            phi_3284_ = _e1884;
                        } else {
                            phi_3284_ = _e1924;
                        }
                        let _e1927 = phi_3284_;
                        let _e1932 = (((_e1927 - ((_e1919 * _e1677) * (0.000000059604645f * (17f / 2f)))) - (_e1919 * _e1684)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        if (_e1808 > _e1932) {
                            phi_3294_ = _e1808;
                        } else {
                            phi_3294_ = _e1932;
                        }
                        let _e1935 = phi_3294_;
                        if (_e179.member == 0u) {
                            let _e1937 = (_e1437 - _e1422);
                            let _e1938 = (_e1438 - _e1423);
                            let _e1939 = (_e1439 - _e1424);
                            let _e1942 = ((_e1445 * _e1939) - (_e1448 * _e1938));
                            let _e1945 = ((_e1448 * _e1937) - (_e1442 * _e1939));
                            let _e1948 = ((_e1442 * _e1938) - (_e1445 * _e1937));
                            let _e1953 = (((_e1942 * _e1451[0]) + (_e1945 * _e1451[1])) + (_e1948 * _e1451[2]));
                            let _e1958 = (((_e1942 * _e1468) + (_e1945 * _e1469)) + (_e1948 * _e1470));
                            let _e1963 = (((_e1942 * _e1478) + (_e1945 * _e1479)) + (_e1948 * _e1480));
                            let _e1971 = (((_e1942 * _e1477[0]) + (_e1945 * _e1477[1])) + (_e1948 * _e1477[2]));
                            let _e1976 = (((_e1942 * _e1483[0]) + (_e1945 * _e1483[1])) + (_e1948 * _e1483[2]));
                            let _e1981 = (((_e1942 * _e1500) + (_e1945 * _e1501)) + (_e1948 * _e1502));
                            let _e1986 = (((_e1942 * _e1510) + (_e1945 * _e1511)) + (_e1948 * _e1512));
                            let _e1994 = (((_e1942 * _e1509[0]) + (_e1945 * _e1509[1])) + (_e1948 * _e1509[2]));
                            if (_e1953 < _e1958) {
                                phi_3367_ = _e1953;
                            } else {
                                phi_3367_ = _e1958;
                            }
                            let _e1997 = phi_3367_;
                            if (_e1963 < _e1971) {
                                phi_3372_ = _e1963;
                            } else {
                                phi_3372_ = _e1971;
                            }
                            let _e2000 = phi_3372_;
                            if (_e1997 < _e2000) {
                                phi_3377_ = _e1997;
                            } else {
                                phi_3377_ = _e2000;
                            }
                            let _e2003 = phi_3377_;
                            if (_e1976 < _e1981) {
                                phi_3382_ = _e1976;
                            } else {
                                phi_3382_ = _e1981;
                            }
                            let _e2006 = phi_3382_;
                            if (_e1986 < _e1994) {
                                phi_3387_ = _e1986;
                            } else {
                                phi_3387_ = _e1994;
                            }
                            let _e2009 = phi_3387_;
                            if (_e2006 < _e2009) {
                                phi_3392_ = _e2006;
                            } else {
                                phi_3392_ = _e2009;
                            }
                            let _e2012 = phi_3392_;
                            if (_e2003 < _e2012) {
                                phi_3397_ = _e2003;
                            } else {
                                phi_3397_ = _e2012;
                            }
                            let _e2015 = phi_3397_;
                            if (_e1953 > _e1958) {
                                phi_3402_ = _e1953;
                            } else {
                                phi_3402_ = _e1958;
                            }
                            let _e2018 = phi_3402_;
                            if (_e1963 > _e1971) {
                                phi_3407_ = _e1963;
                            } else {
                                phi_3407_ = _e1971;
                            }
                            let _e2021 = phi_3407_;
                            if (_e2018 > _e2021) {
                                phi_3412_ = _e2018;
                            } else {
                                phi_3412_ = _e2021;
                            }
                            let _e2024 = phi_3412_;
                            if (_e1976 > _e1981) {
                                phi_3417_ = _e1976;
                            } else {
                                phi_3417_ = _e1981;
                            }
                            let _e2027 = phi_3417_;
                            if (_e1986 > _e1994) {
                                phi_3422_ = _e1986;
                            } else {
                                phi_3422_ = _e1994;
                            }
                            let _e2030 = phi_3422_;
                            if (_e2027 > _e2030) {
                                phi_3427_ = _e2027;
                            } else {
                                phi_3427_ = _e2030;
                            }
                            let _e2033 = phi_3427_;
                            if (_e2024 > _e2033) {
                                phi_3432_ = _e2024;
                            } else {
                                phi_3432_ = _e2033;
                            }
                            let _e2036 = phi_3432_;
                            if (_e1942 < 0f) {
                                phi_3438_ = -(_e1942);
                            } else {
                                phi_3438_ = _e1942;
                            }
                            let _e2040 = phi_3438_;
                            if (_e1945 < 0f) {
                                phi_3444_ = -(_e1945);
                            } else {
                                phi_3444_ = _e1945;
                            }
                            let _e2044 = phi_3444_;
                            if (_e1948 < 0f) {
                                phi_3451_ = -(_e1948);
                            } else {
                                phi_3451_ = _e1948;
                            }
                            let _e2049 = phi_3451_;
                            let _e2050 = ((_e2040 + _e2044) + _e2049);
                            let _e2055 = -(_e2036);
                            if (_e2015 > _e2055) {
                                phi_3462_ = _e2015;
                            } else {
                                phi_3462_ = _e2055;
                            }
                            let _e2058 = phi_3462_;
                            let _e2063 = (((_e2058 - ((_e2050 * _e1677) * (0.000000059604645f * (17f / 2f)))) - (_e2050 * _e1684)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e1935 > _e2063) {
                                phi_3472_ = _e1935;
                            } else {
                                phi_3472_ = _e2063;
                            }
                            let _e2066 = phi_3472_;
                            phi_3473_ = _e2066;
                        } else {
                            phi_3473_ = _e1935;
                        }
                        let _e2068 = phi_3473_;
                        phi_3476_ = (_e1409 || (_e2068 > 0f));
                    }
                    let _e2072 = phi_3476_;
                    if _e2072 {
                        phi_6893_ = _e2072;
                    } else {
                        let _e2075 = local_2.member[0u];
                        let _e2081 = local_2.member[1u];
                        let _e2088 = ((_e2075[0] + _e2081[0]) * 0.5f);
                        let _e2089 = ((_e2075[1] + _e2081[1]) * 0.5f);
                        let _e2090 = ((_e2075[2] + _e2081[2]) * 0.5f);
                        let _e2093 = local_2.member_1[0u];
                        let _e2099 = local_2.member_1[1u];
                        let _e2106 = ((_e2093[0] + _e2099[0]) * 0.5f);
                        let _e2107 = ((_e2093[1] + _e2099[1]) * 0.5f);
                        let _e2108 = ((_e2093[2] + _e2099[2]) * 0.5f);
                        let _e2111 = local_2.member_2[0u];
                        let _e2117 = local_2.member_2[1u];
                        let _e2124 = ((_e2111[0] + _e2117[0]) * 0.5f);
                        let _e2125 = ((_e2111[1] + _e2117[1]) * 0.5f);
                        let _e2126 = ((_e2111[2] + _e2117[2]) * 0.5f);
                        let _e2129 = local_2.member[0u];
                        let _e2132 = local_2.member_1[0u];
                        let _e2135 = local_2.member_2[0u];
                        let _e2137 = local_2.member_3;
                        let _e2140 = local_2.member[1u];
                        let _e2143 = local_2.member_1[1u];
                        let _e2146 = local_2.member_2[1u];
                        let _e2148 = local_2.member_3;
                        local = type_27(array<array<f32, 3>, 2>(_e2129, array<f32, 3>(_e2088, _e2089, _e2090)), array<array<f32, 3>, 2>(_e2132, array<f32, 3>(_e2106, _e2107, _e2108)), array<array<f32, 3>, 2>(_e2135, array<f32, 3>(_e2124, _e2125, _e2126)), _e2137);
                        local_1 = type_27(array<array<f32, 3>, 2>(array<f32, 3>(_e2088, _e2089, _e2090), _e2140), array<array<f32, 3>, 2>(array<f32, 3>(_e2106, _e2107, _e2108), _e2143), array<array<f32, 3>, 2>(array<f32, 3>(_e2124, _e2125, _e2126), _e2146), _e2148);
                        let _e2165 = local.member_1[0u];
                        let _e2171 = local.member_2[0u];
                        let _e2177 = ((_e2165[1] * _e2171[2]) - (_e2165[2] * _e2171[1]));
                        let _e2180 = ((_e2165[2] * _e2171[0]) - (_e2165[0] * _e2171[2]));
                        let _e2183 = ((_e2165[0] * _e2171[1]) - (_e2165[1] * _e2171[0]));
                        let _e2186 = local.member_1[1u];
                        let _e2192 = local.member_2[1u];
                        let _e2198 = ((_e2186[1] * _e2192[2]) - (_e2186[2] * _e2192[1]));
                        let _e2201 = ((_e2186[2] * _e2192[0]) - (_e2186[0] * _e2192[2]));
                        let _e2204 = ((_e2186[0] * _e2192[1]) - (_e2186[1] * _e2192[0]));
                        let _e2207 = local.member_1[0u];
                        let _e2213 = local.member_2[1u];
                        let _e2228 = local.member_1[1u];
                        let _e2234 = local.member_2[0u];
                        let _e2247 = (((_e2207[1] * _e2213[2]) - (_e2207[2] * _e2213[1])) + ((_e2228[1] * _e2234[2]) - (_e2228[2] * _e2234[1])));
                        let _e2248 = (((_e2207[2] * _e2213[0]) - (_e2207[0] * _e2213[2])) + ((_e2228[2] * _e2234[0]) - (_e2228[0] * _e2234[2])));
                        let _e2249 = (((_e2207[0] * _e2213[1]) - (_e2207[1] * _e2213[0])) + ((_e2228[0] * _e2234[1]) - (_e2228[1] * _e2234[0])));
                        let _e2252 = local.member[0u];
                        let _e2263 = local.member[1u];
                        let _e2274 = local.member[0u];
                        let _e2283 = ((((_e2263[0] * _e2177) + (_e2263[1] * _e2180)) + (_e2263[2] * _e2183)) + (((_e2274[0] * _e2247) + (_e2274[1] * _e2248)) + (_e2274[2] * _e2249)));
                        let _e2286 = local.member[0u];
                        let _e2297 = local.member[1u];
                        let _e2306 = ((((_e2286[0] * _e2198) + (_e2286[1] * _e2201)) + (_e2286[2] * _e2204)) + (((_e2297[0] * _e2247) + (_e2297[1] * _e2248)) + (_e2297[2] * _e2249)));
                        let _e2309 = local.member[1u];
                        let _e2320 = local.member[0u];
                        if (_e2320[0] < 0f) {
                            phi_3928_ = -(_e2320[0]);
                        } else {
                            phi_3928_ = _e2320[0];
                        }
                        let _e2327 = phi_3928_;
                        if (_e2320[1] < 0f) {
                            phi_3935_ = -(_e2320[1]);
                        } else {
                            phi_3935_ = _e2320[1];
                        }
                        let _e2331 = phi_3935_;
                        if (_e2327 > _e2331) {
                            phi_3940_ = _e2327;
                        } else {
                            phi_3940_ = _e2331;
                        }
                        let _e2334 = phi_3940_;
                        if (_e2320[2] < 0f) {
                            phi_3947_ = -(_e2320[2]);
                        } else {
                            phi_3947_ = _e2320[2];
                        }
                        let _e2338 = phi_3947_;
                        if (_e2334 > _e2338) {
                            phi_3952_ = _e2334;
                        } else {
                            phi_3952_ = _e2338;
                        }
                        let _e2341 = phi_3952_;
                        let _e2344 = local.member[1u];
                        if (_e2344[0] < 0f) {
                            phi_3965_ = -(_e2344[0]);
                        } else {
                            phi_3965_ = _e2344[0];
                        }
                        let _e2351 = phi_3965_;
                        if (_e2344[1] < 0f) {
                            phi_3972_ = -(_e2344[1]);
                        } else {
                            phi_3972_ = _e2344[1];
                        }
                        let _e2355 = phi_3972_;
                        if (_e2351 > _e2355) {
                            phi_3977_ = _e2351;
                        } else {
                            phi_3977_ = _e2355;
                        }
                        let _e2358 = phi_3977_;
                        if (_e2344[2] < 0f) {
                            phi_3984_ = -(_e2344[2]);
                        } else {
                            phi_3984_ = _e2344[2];
                        }
                        let _e2362 = phi_3984_;
                        if (_e2358 > _e2362) {
                            phi_3989_ = _e2358;
                        } else {
                            phi_3989_ = _e2362;
                        }
                        let _e2365 = phi_3989_;
                        if (_e2341 > _e2365) {
                            phi_3994_ = _e2341;
                        } else {
                            phi_3994_ = _e2365;
                        }
                        let _e2368 = phi_3994_;
                        let _e2370 = local.member_3;
                        let _e2371 = (_e2368 + _e2370);
                        let _e2374 = local.member_1[0u];
                        if (_e2374[0] < 0f) {
                            phi_4011_ = -(_e2374[0]);
                        } else {
                            phi_4011_ = _e2374[0];
                        }
                        let _e2381 = phi_4011_;
                        if (_e2374[1] < 0f) {
                            phi_4018_ = -(_e2374[1]);
                        } else {
                            phi_4018_ = _e2374[1];
                        }
                        let _e2385 = phi_4018_;
                        if (_e2381 > _e2385) {
                            phi_4023_ = _e2381;
                        } else {
                            phi_4023_ = _e2385;
                        }
                        let _e2388 = phi_4023_;
                        if (_e2374[2] < 0f) {
                            phi_4030_ = -(_e2374[2]);
                        } else {
                            phi_4030_ = _e2374[2];
                        }
                        let _e2392 = phi_4030_;
                        if (_e2388 > _e2392) {
                            phi_4035_ = _e2388;
                        } else {
                            phi_4035_ = _e2392;
                        }
                        let _e2395 = phi_4035_;
                        let _e2398 = local.member_1[1u];
                        if (_e2398[0] < 0f) {
                            phi_4049_ = -(_e2398[0]);
                        } else {
                            phi_4049_ = _e2398[0];
                        }
                        let _e2405 = phi_4049_;
                        if (_e2398[1] < 0f) {
                            phi_4056_ = -(_e2398[1]);
                        } else {
                            phi_4056_ = _e2398[1];
                        }
                        let _e2409 = phi_4056_;
                        if (_e2405 > _e2409) {
                            phi_4061_ = _e2405;
                        } else {
                            phi_4061_ = _e2409;
                        }
                        let _e2412 = phi_4061_;
                        if (_e2398[2] < 0f) {
                            phi_4068_ = -(_e2398[2]);
                        } else {
                            phi_4068_ = _e2398[2];
                        }
                        let _e2416 = phi_4068_;
                        if (_e2412 > _e2416) {
                            phi_4073_ = _e2412;
                        } else {
                            phi_4073_ = _e2416;
                        }
                        let _e2419 = phi_4073_;
                        if (_e2395 > _e2419) {
                            phi_4078_ = _e2395;
                        } else {
                            phi_4078_ = _e2419;
                        }
                        let _e2422 = phi_4078_;
                        let _e2424 = local.member_3;
                        let _e2425 = (_e2422 + _e2424);
                        let _e2428 = local.member_2[0u];
                        if (_e2428[0] < 0f) {
                            phi_4095_ = -(_e2428[0]);
                        } else {
                            phi_4095_ = _e2428[0];
                        }
                        let _e2435 = phi_4095_;
                        if (_e2428[1] < 0f) {
                            phi_4102_ = -(_e2428[1]);
                        } else {
                            phi_4102_ = _e2428[1];
                        }
                        let _e2439 = phi_4102_;
                        if (_e2435 > _e2439) {
                            phi_4107_ = _e2435;
                        } else {
                            phi_4107_ = _e2439;
                        }
                        let _e2442 = phi_4107_;
                        if (_e2428[2] < 0f) {
                            phi_4114_ = -(_e2428[2]);
                        } else {
                            phi_4114_ = _e2428[2];
                        }
                        let _e2446 = phi_4114_;
                        if (_e2442 > _e2446) {
                            phi_4119_ = _e2442;
                        } else {
                            phi_4119_ = _e2446;
                        }
                        let _e2449 = phi_4119_;
                        let _e2452 = local.member_2[1u];
                        if (_e2452[0] < 0f) {
                            phi_4133_ = -(_e2452[0]);
                        } else {
                            phi_4133_ = _e2452[0];
                        }
                        let _e2459 = phi_4133_;
                        if (_e2452[1] < 0f) {
                            phi_4140_ = -(_e2452[1]);
                        } else {
                            phi_4140_ = _e2452[1];
                        }
                        let _e2463 = phi_4140_;
                        if (_e2459 > _e2463) {
                            phi_4145_ = _e2459;
                        } else {
                            phi_4145_ = _e2463;
                        }
                        let _e2466 = phi_4145_;
                        if (_e2452[2] < 0f) {
                            phi_4152_ = -(_e2452[2]);
                        } else {
                            phi_4152_ = _e2452[2];
                        }
                        let _e2470 = phi_4152_;
                        if (_e2466 > _e2470) {
                            phi_4157_ = _e2466;
                        } else {
                            phi_4157_ = _e2470;
                        }
                        let _e2473 = phi_4157_;
                        if (_e2449 > _e2473) {
                            phi_4162_ = _e2449;
                        } else {
                            phi_4162_ = _e2473;
                        }
                        let _e2476 = phi_4162_;
                        let _e2478 = local.member_3;
                        let _e2479 = (_e2476 + _e2478);
                        let _e2481 = ((_e2425 * 8f) * _e2479);
                        let _e2488 = local.member_3;
                        if (_e2177 < 0f) {
                            phi_4193_ = -(_e2177);
                        } else {
                            phi_4193_ = _e2177;
                        }
                        let _e2505 = phi_4193_;
                        if (_e2180 < 0f) {
                            phi_4199_ = -(_e2180);
                        } else {
                            phi_4199_ = _e2180;
                        }
                        let _e2509 = phi_4199_;
                        if (_e2183 < 0f) {
                            phi_4206_ = -(_e2183);
                        } else {
                            phi_4206_ = _e2183;
                        }
                        let _e2514 = phi_4206_;
                        let _e2515 = ((_e2505 + _e2509) + _e2514);
                        if (_e2198 < 0f) {
                            phi_4213_ = -(_e2198);
                        } else {
                            phi_4213_ = _e2198;
                        }
                        let _e2519 = phi_4213_;
                        if (_e2201 < 0f) {
                            phi_4219_ = -(_e2201);
                        } else {
                            phi_4219_ = _e2201;
                        }
                        let _e2523 = phi_4219_;
                        if (_e2204 < 0f) {
                            phi_4226_ = -(_e2204);
                        } else {
                            phi_4226_ = _e2204;
                        }
                        let _e2528 = phi_4226_;
                        let _e2529 = ((_e2519 + _e2523) + _e2528);
                        if (_e2515 > _e2529) {
                            phi_4232_ = _e2515;
                        } else {
                            phi_4232_ = _e2529;
                        }
                        let _e2532 = phi_4232_;
                        if (_e2247 < 0f) {
                            phi_4238_ = -(_e2247);
                        } else {
                            phi_4238_ = _e2247;
                        }
                        let _e2536 = phi_4238_;
                        if (_e2248 < 0f) {
                            phi_4244_ = -(_e2248);
                        } else {
                            phi_4244_ = _e2248;
                        }
                        let _e2540 = phi_4244_;
                        if (_e2249 < 0f) {
                            phi_4251_ = -(_e2249);
                        } else {
                            phi_4251_ = _e2249;
                        }
                        let _e2545 = phi_4251_;
                        let _e2547 = (((_e2536 + _e2540) + _e2545) * 0.5f);
                        if (_e2532 > _e2547) {
                            phi_4258_ = _e2532;
                        } else {
                            phi_4258_ = _e2547;
                        }
                        let _e2550 = phi_4258_;
                        let _e2555 = local.member_3;
                        let _e2568 = ((((_e2252[0] * _e2177) + (_e2252[1] * _e2180)) + (_e2252[2] * _e2183)) * 3f);
                        let _e2569 = ((((_e2309[0] * _e2198) + (_e2309[1] * _e2201)) + (_e2309[2] * _e2204)) * 3f);
                        if (_e2568 < _e2569) {
                            phi_4282_ = _e2568;
                        } else {
                            phi_4282_ = _e2569;
                        }
                        let _e2572 = phi_4282_;
                        if (_e2283 < _e2306) {
                            phi_4287_ = _e2283;
                        } else {
                            phi_4287_ = _e2306;
                        }
                        let _e2575 = phi_4287_;
                        if (_e2572 < _e2575) {
                            phi_4292_ = _e2572;
                        } else {
                            phi_4292_ = _e2575;
                        }
                        let _e2578 = phi_4292_;
                        if (_e2568 > _e2569) {
                            phi_4297_ = _e2568;
                        } else {
                            phi_4297_ = _e2569;
                        }
                        let _e2581 = phi_4297_;
                        if (_e2283 > _e2306) {
                            phi_4302_ = _e2283;
                        } else {
                            phi_4302_ = _e2306;
                        }
                        let _e2584 = phi_4302_;
                        if (_e2581 > _e2584) {
                            phi_4307_ = _e2581;
                        } else {
                            phi_4307_ = _e2584;
                        }
                        let _e2587 = phi_4307_;
                        let _e2592 = -(_e2587);
                        if (_e2578 > _e2592) {
                            phi_4317_ = _e2578;
                        } else {
                            phi_4317_ = _e2592;
                        }
                        let _e2595 = phi_4317_;
                        let _e2597 = ((_e2595 - ((((((_e2371 * 8f) * _e2481) * (0.000000059604645f * (524f / 64f))) + ((_e2488 * 19f) * ((_e2371 * (_e2425 + _e2479)) + (_e2425 * _e2479)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2371) * ((1f + _e2425) * (1f + _e2479))))) + ((_e815 * (((_e2550 + (_e2481 * (0.000000059604645f * 8f))) + ((_e2555 * 6f) * (_e2425 + _e2479))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2425) * (1f + _e2479))))) * (3f * 1.0001f)))) > 0f);
                        if _e2597 {
                            phi_5286_ = _e2597;
                        } else {
                            let _e2600 = local.member_1[0u];
                            let _e2606 = local.member_1[1u];
                            let _e2610 = (_e2600[0] + _e2606[0]);
                            let _e2611 = (_e2600[1] + _e2606[1]);
                            let _e2612 = (_e2600[2] + _e2606[2]);
                            let _e2615 = local.member_2[0u];
                            let _e2621 = local.member_2[1u];
                            let _e2625 = (_e2615[0] + _e2621[0]);
                            let _e2626 = (_e2615[1] + _e2621[1]);
                            let _e2627 = (_e2615[2] + _e2621[2]);
                            let _e2630 = ((_e2611 * _e2627) - (_e2612 * _e2626));
                            let _e2633 = ((_e2612 * _e2625) - (_e2610 * _e2627));
                            let _e2636 = ((_e2610 * _e2626) - (_e2611 * _e2625));
                            let _e2639 = local.member[0u];
                            let _e2646 = local.member_1[0u];
                            let _e2652 = local.member_2[0u];
                            let _e2656 = (_e2639[0] - _e2646[0]);
                            let _e2657 = (_e2639[1] - _e2646[1]);
                            let _e2658 = (_e2639[2] - _e2646[2]);
                            if (_e179.member == 0u) {
                                phi_4433_ = array<f32, 3>(_e2639[0], _e2639[1], _e2639[2]);
                            } else {
                                phi_4433_ = array<f32, 3>((_e2656 - _e2652[0]), (_e2657 - _e2652[1]), (_e2658 - _e2652[2]));
                            }
                            let _e2665 = phi_4433_;
                            let _e2666 = (_e2639[0] - _e2652[0]);
                            let _e2667 = (_e2639[1] - _e2652[1]);
                            let _e2668 = (_e2639[2] - _e2652[2]);
                            let _e2671 = local.member[1u];
                            let _e2678 = local.member_1[1u];
                            let _e2684 = local.member_2[1u];
                            let _e2688 = (_e2671[0] - _e2678[0]);
                            let _e2689 = (_e2671[1] - _e2678[1]);
                            let _e2690 = (_e2671[2] - _e2678[2]);
                            if (_e179.member == 0u) {
                                phi_4498_ = array<f32, 3>(_e2671[0], _e2671[1], _e2671[2]);
                            } else {
                                phi_4498_ = array<f32, 3>((_e2688 - _e2684[0]), (_e2689 - _e2684[1]), (_e2690 - _e2684[2]));
                            }
                            let _e2697 = phi_4498_;
                            let _e2698 = (_e2671[0] - _e2684[0]);
                            let _e2699 = (_e2671[1] - _e2684[1]);
                            let _e2700 = (_e2671[2] - _e2684[2]);
                            let _e2703 = local.member[0u];
                            if (_e2703[0] < 0f) {
                                phi_4520_ = -(_e2703[0]);
                            } else {
                                phi_4520_ = _e2703[0];
                            }
                            let _e2710 = phi_4520_;
                            if (_e2703[1] < 0f) {
                                phi_4527_ = -(_e2703[1]);
                            } else {
                                phi_4527_ = _e2703[1];
                            }
                            let _e2714 = phi_4527_;
                            if (_e2710 > _e2714) {
                                phi_4532_ = _e2710;
                            } else {
                                phi_4532_ = _e2714;
                            }
                            let _e2717 = phi_4532_;
                            if (_e2703[2] < 0f) {
                                phi_4539_ = -(_e2703[2]);
                            } else {
                                phi_4539_ = _e2703[2];
                            }
                            let _e2721 = phi_4539_;
                            if (_e2717 > _e2721) {
                                phi_4544_ = _e2717;
                            } else {
                                phi_4544_ = _e2721;
                            }
                            let _e2724 = phi_4544_;
                            let _e2727 = local.member[1u];
                            if (_e2727[0] < 0f) {
                                phi_4557_ = -(_e2727[0]);
                            } else {
                                phi_4557_ = _e2727[0];
                            }
                            let _e2734 = phi_4557_;
                            if (_e2727[1] < 0f) {
                                phi_4564_ = -(_e2727[1]);
                            } else {
                                phi_4564_ = _e2727[1];
                            }
                            let _e2738 = phi_4564_;
                            if (_e2734 > _e2738) {
                                phi_4569_ = _e2734;
                            } else {
                                phi_4569_ = _e2738;
                            }
                            let _e2741 = phi_4569_;
                            if (_e2727[2] < 0f) {
                                phi_4576_ = -(_e2727[2]);
                            } else {
                                phi_4576_ = _e2727[2];
                            }
                            let _e2745 = phi_4576_;
                            if (_e2741 > _e2745) {
                                phi_4581_ = _e2741;
                            } else {
                                phi_4581_ = _e2745;
                            }
                            let _e2748 = phi_4581_;
                            if (_e2724 > _e2748) {
                                phi_4586_ = _e2724;
                            } else {
                                phi_4586_ = _e2748;
                            }
                            let _e2751 = phi_4586_;
                            let _e2753 = local.member_3;
                            let _e2757 = local.member_1[0u];
                            if (_e2757[0] < 0f) {
                                phi_4603_ = -(_e2757[0]);
                            } else {
                                phi_4603_ = _e2757[0];
                            }
                            let _e2764 = phi_4603_;
                            if (_e2757[1] < 0f) {
                                phi_4610_ = -(_e2757[1]);
                            } else {
                                phi_4610_ = _e2757[1];
                            }
                            let _e2768 = phi_4610_;
                            if (_e2764 > _e2768) {
                                phi_4615_ = _e2764;
                            } else {
                                phi_4615_ = _e2768;
                            }
                            let _e2771 = phi_4615_;
                            if (_e2757[2] < 0f) {
                                phi_4622_ = -(_e2757[2]);
                            } else {
                                phi_4622_ = _e2757[2];
                            }
                            let _e2775 = phi_4622_;
                            if (_e2771 > _e2775) {
                                phi_4627_ = _e2771;
                            } else {
                                phi_4627_ = _e2775;
                            }
                            let _e2778 = phi_4627_;
                            let _e2781 = local.member_1[1u];
                            if (_e2781[0] < 0f) {
                                phi_4641_ = -(_e2781[0]);
                            } else {
                                phi_4641_ = _e2781[0];
                            }
                            let _e2788 = phi_4641_;
                            if (_e2781[1] < 0f) {
                                phi_4648_ = -(_e2781[1]);
                            } else {
                                phi_4648_ = _e2781[1];
                            }
                            let _e2792 = phi_4648_;
                            if (_e2788 > _e2792) {
                                phi_4653_ = _e2788;
                            } else {
                                phi_4653_ = _e2792;
                            }
                            let _e2795 = phi_4653_;
                            if (_e2781[2] < 0f) {
                                phi_4660_ = -(_e2781[2]);
                            } else {
                                phi_4660_ = _e2781[2];
                            }
                            let _e2799 = phi_4660_;
                            if (_e2795 > _e2799) {
                                phi_4665_ = _e2795;
                            } else {
                                phi_4665_ = _e2799;
                            }
                            let _e2802 = phi_4665_;
                            if (_e2778 > _e2802) {
                                phi_4670_ = _e2778;
                            } else {
                                phi_4670_ = _e2802;
                            }
                            let _e2805 = phi_4670_;
                            let _e2807 = local.member_3;
                            let _e2811 = local.member_2[0u];
                            if (_e2811[0] < 0f) {
                                phi_4687_ = -(_e2811[0]);
                            } else {
                                phi_4687_ = _e2811[0];
                            }
                            let _e2818 = phi_4687_;
                            if (_e2811[1] < 0f) {
                                phi_4694_ = -(_e2811[1]);
                            } else {
                                phi_4694_ = _e2811[1];
                            }
                            let _e2822 = phi_4694_;
                            if (_e2818 > _e2822) {
                                phi_4699_ = _e2818;
                            } else {
                                phi_4699_ = _e2822;
                            }
                            let _e2825 = phi_4699_;
                            if (_e2811[2] < 0f) {
                                phi_4706_ = -(_e2811[2]);
                            } else {
                                phi_4706_ = _e2811[2];
                            }
                            let _e2829 = phi_4706_;
                            if (_e2825 > _e2829) {
                                phi_4711_ = _e2825;
                            } else {
                                phi_4711_ = _e2829;
                            }
                            let _e2832 = phi_4711_;
                            let _e2835 = local.member_2[1u];
                            if (_e2835[0] < 0f) {
                                phi_4725_ = -(_e2835[0]);
                            } else {
                                phi_4725_ = _e2835[0];
                            }
                            let _e2842 = phi_4725_;
                            if (_e2835[1] < 0f) {
                                phi_4732_ = -(_e2835[1]);
                            } else {
                                phi_4732_ = _e2835[1];
                            }
                            let _e2846 = phi_4732_;
                            if (_e2842 > _e2846) {
                                phi_4737_ = _e2842;
                            } else {
                                phi_4737_ = _e2846;
                            }
                            let _e2849 = phi_4737_;
                            if (_e2835[2] < 0f) {
                                phi_4744_ = -(_e2835[2]);
                            } else {
                                phi_4744_ = _e2835[2];
                            }
                            let _e2853 = phi_4744_;
                            if (_e2849 > _e2853) {
                                phi_4749_ = _e2849;
                            } else {
                                phi_4749_ = _e2853;
                            }
                            let _e2856 = phi_4749_;
                            if (_e2832 > _e2856) {
                                phi_4754_ = _e2832;
                            } else {
                                phi_4754_ = _e2856;
                            }
                            let _e2859 = phi_4754_;
                            let _e2861 = local.member_3;
                            let _e2865 = ((((_e2751 + _e2753) + (_e2805 + _e2807)) + (_e2859 + _e2861)) * 2f);
                            let _e2868 = local.member_3;
                            let _e2872 = (((_e815 * 1.0001f) + (_e2868 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e2875 = ((_e2633 * _e2612) - (_e2636 * _e2611));
                            let _e2878 = ((_e2636 * _e2610) - (_e2630 * _e2612));
                            let _e2881 = ((_e2630 * _e2611) - (_e2633 * _e2610));
                            let _e2886 = (((_e2875 * _e2639[0]) + (_e2878 * _e2639[1])) + (_e2881 * _e2639[2]));
                            let _e2891 = (((_e2875 * _e2656) + (_e2878 * _e2657)) + (_e2881 * _e2658));
                            let _e2896 = (((_e2875 * _e2666) + (_e2878 * _e2667)) + (_e2881 * _e2668));
                            let _e2904 = (((_e2875 * _e2665[0]) + (_e2878 * _e2665[1])) + (_e2881 * _e2665[2]));
                            let _e2909 = (((_e2875 * _e2671[0]) + (_e2878 * _e2671[1])) + (_e2881 * _e2671[2]));
                            let _e2914 = (((_e2875 * _e2688) + (_e2878 * _e2689)) + (_e2881 * _e2690));
                            let _e2919 = (((_e2875 * _e2698) + (_e2878 * _e2699)) + (_e2881 * _e2700));
                            let _e2927 = (((_e2875 * _e2697[0]) + (_e2878 * _e2697[1])) + (_e2881 * _e2697[2]));
                            if (_e2886 < _e2891) {
                                phi_4833_ = _e2886;
                            } else {
                                phi_4833_ = _e2891;
                            }
                            let _e2930 = phi_4833_;
                            if (_e2896 < _e2904) {
                                phi_4838_ = _e2896;
                            } else {
                                phi_4838_ = _e2904;
                            }
                            let _e2933 = phi_4838_;
                            if (_e2930 < _e2933) {
                                phi_4843_ = _e2930;
                            } else {
                                phi_4843_ = _e2933;
                            }
                            let _e2936 = phi_4843_;
                            if (_e2909 < _e2914) {
                                phi_4848_ = _e2909;
                            } else {
                                phi_4848_ = _e2914;
                            }
                            let _e2939 = phi_4848_;
                            if (_e2919 < _e2927) {
                                phi_4853_ = _e2919;
                            } else {
                                phi_4853_ = _e2927;
                            }
                            let _e2942 = phi_4853_;
                            if (_e2939 < _e2942) {
                                phi_4858_ = _e2939;
                            } else {
                                phi_4858_ = _e2942;
                            }
                            let _e2945 = phi_4858_;
                            if (_e2936 < _e2945) {
                                phi_4863_ = _e2936;
                            } else {
                                phi_4863_ = _e2945;
                            }
                            let _e2948 = phi_4863_;
                            if (_e2886 > _e2891) {
                                phi_4868_ = _e2886;
                            } else {
                                phi_4868_ = _e2891;
                            }
                            let _e2951 = phi_4868_;
                            if (_e2896 > _e2904) {
                                phi_4873_ = _e2896;
                            } else {
                                phi_4873_ = _e2904;
                            }
                            let _e2954 = phi_4873_;
                            if (_e2951 > _e2954) {
                                phi_4878_ = _e2951;
                            } else {
                                phi_4878_ = _e2954;
                            }
                            let _e2957 = phi_4878_;
                            if (_e2909 > _e2914) {
                                phi_4883_ = _e2909;
                            } else {
                                phi_4883_ = _e2914;
                            }
                            let _e2960 = phi_4883_;
                            if (_e2919 > _e2927) {
                                phi_4888_ = _e2919;
                            } else {
                                phi_4888_ = _e2927;
                            }
                            let _e2963 = phi_4888_;
                            if (_e2960 > _e2963) {
                                phi_4893_ = _e2960;
                            } else {
                                phi_4893_ = _e2963;
                            }
                            let _e2966 = phi_4893_;
                            if (_e2957 > _e2966) {
                                phi_4898_ = _e2957;
                            } else {
                                phi_4898_ = _e2966;
                            }
                            let _e2969 = phi_4898_;
                            if (_e2875 < 0f) {
                                phi_4904_ = -(_e2875);
                            } else {
                                phi_4904_ = _e2875;
                            }
                            let _e2973 = phi_4904_;
                            if (_e2878 < 0f) {
                                phi_4910_ = -(_e2878);
                            } else {
                                phi_4910_ = _e2878;
                            }
                            let _e2977 = phi_4910_;
                            if (_e2881 < 0f) {
                                phi_4917_ = -(_e2881);
                            } else {
                                phi_4917_ = _e2881;
                            }
                            let _e2982 = phi_4917_;
                            let _e2983 = ((_e2973 + _e2977) + _e2982);
                            let _e2988 = -(_e2969);
                            if (_e2948 > _e2988) {
                                phi_4928_ = _e2948;
                            } else {
                                phi_4928_ = _e2988;
                            }
                            let _e2991 = phi_4928_;
                            let _e2996 = (((_e2991 - ((_e2983 * _e2865) * (0.000000059604645f * (17f / 2f)))) - (_e2983 * _e2872)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2999 = ((_e2633 * _e2627) - (_e2636 * _e2626));
                            let _e3002 = ((_e2636 * _e2625) - (_e2630 * _e2627));
                            let _e3005 = ((_e2630 * _e2626) - (_e2633 * _e2625));
                            let _e3010 = (((_e2999 * _e2639[0]) + (_e3002 * _e2639[1])) + (_e3005 * _e2639[2]));
                            let _e3015 = (((_e2999 * _e2656) + (_e3002 * _e2657)) + (_e3005 * _e2658));
                            let _e3020 = (((_e2999 * _e2666) + (_e3002 * _e2667)) + (_e3005 * _e2668));
                            let _e3028 = (((_e2999 * _e2665[0]) + (_e3002 * _e2665[1])) + (_e3005 * _e2665[2]));
                            let _e3033 = (((_e2999 * _e2671[0]) + (_e3002 * _e2671[1])) + (_e3005 * _e2671[2]));
                            let _e3038 = (((_e2999 * _e2688) + (_e3002 * _e2689)) + (_e3005 * _e2690));
                            let _e3043 = (((_e2999 * _e2698) + (_e3002 * _e2699)) + (_e3005 * _e2700));
                            let _e3051 = (((_e2999 * _e2697[0]) + (_e3002 * _e2697[1])) + (_e3005 * _e2697[2]));
                            if (_e3010 < _e3015) {
                                phi_4999_ = _e3010;
                            } else {
                                phi_4999_ = _e3015;
                            }
                            let _e3054 = phi_4999_;
                            if (_e3020 < _e3028) {
                                phi_5004_ = _e3020;
                            } else {
                                phi_5004_ = _e3028;
                            }
                            let _e3057 = phi_5004_;
                            if (_e3054 < _e3057) {
                                phi_5009_ = _e3054;
                            } else {
                                phi_5009_ = _e3057;
                            }
                            let _e3060 = phi_5009_;
                            if (_e3033 < _e3038) {
                                phi_5014_ = _e3033;
                            } else {
                                phi_5014_ = _e3038;
                            }
                            let _e3063 = phi_5014_;
                            if (_e3043 < _e3051) {
                                phi_5019_ = _e3043;
                            } else {
                                phi_5019_ = _e3051;
                            }
                            let _e3066 = phi_5019_;
                            if (_e3063 < _e3066) {
                                phi_5024_ = _e3063;
                            } else {
                                phi_5024_ = _e3066;
                            }
                            let _e3069 = phi_5024_;
                            if (_e3060 < _e3069) {
                                phi_5029_ = _e3060;
                            } else {
                                phi_5029_ = _e3069;
                            }
                            let _e3072 = phi_5029_;
                            if (_e3010 > _e3015) {
                                phi_5034_ = _e3010;
                            } else {
                                phi_5034_ = _e3015;
                            }
                            let _e3075 = phi_5034_;
                            if (_e3020 > _e3028) {
                                phi_5039_ = _e3020;
                            } else {
                                phi_5039_ = _e3028;
                            }
                            let _e3078 = phi_5039_;
                            if (_e3075 > _e3078) {
                                phi_5044_ = _e3075;
                            } else {
                                phi_5044_ = _e3078;
                            }
                            let _e3081 = phi_5044_;
                            if (_e3033 > _e3038) {
                                phi_5049_ = _e3033;
                            } else {
                                phi_5049_ = _e3038;
                            }
                            let _e3084 = phi_5049_;
                            if (_e3043 > _e3051) {
                                phi_5054_ = _e3043;
                            } else {
                                phi_5054_ = _e3051;
                            }
                            let _e3087 = phi_5054_;
                            if (_e3084 > _e3087) {
                                phi_5059_ = _e3084;
                            } else {
                                phi_5059_ = _e3087;
                            }
                            let _e3090 = phi_5059_;
                            if (_e3081 > _e3090) {
                                phi_5064_ = _e3081;
                            } else {
                                phi_5064_ = _e3090;
                            }
                            let _e3093 = phi_5064_;
                            if (_e2999 < 0f) {
                                phi_5070_ = -(_e2999);
                            } else {
                                phi_5070_ = _e2999;
                            }
                            let _e3097 = phi_5070_;
                            if (_e3002 < 0f) {
                                phi_5076_ = -(_e3002);
                            } else {
                                phi_5076_ = _e3002;
                            }
                            let _e3101 = phi_5076_;
                            if (_e3005 < 0f) {
                                phi_5083_ = -(_e3005);
                            } else {
                                phi_5083_ = _e3005;
                            }
                            let _e3106 = phi_5083_;
                            let _e3107 = ((_e3097 + _e3101) + _e3106);
                            let _e3112 = -(_e3093);
                            if (_e3072 > _e3112) {
                                phi_5094_ = _e3072;
                            } else {
                                phi_5094_ = _e3112;
                            }
                            let _e3115 = phi_5094_;
                            let _e3120 = (((_e3115 - ((_e3107 * _e2865) * (0.000000059604645f * (17f / 2f)))) - (_e3107 * _e2872)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e2996 > _e3120) {
                                phi_5104_ = _e2996;
                            } else {
                                phi_5104_ = _e3120;
                            }
                            let _e3123 = phi_5104_;
                            if (_e179.member == 0u) {
                                let _e3125 = (_e2625 - _e2610);
                                let _e3126 = (_e2626 - _e2611);
                                let _e3127 = (_e2627 - _e2612);
                                let _e3130 = ((_e2633 * _e3127) - (_e2636 * _e3126));
                                let _e3133 = ((_e2636 * _e3125) - (_e2630 * _e3127));
                                let _e3136 = ((_e2630 * _e3126) - (_e2633 * _e3125));
                                let _e3141 = (((_e3130 * _e2639[0]) + (_e3133 * _e2639[1])) + (_e3136 * _e2639[2]));
                                let _e3146 = (((_e3130 * _e2656) + (_e3133 * _e2657)) + (_e3136 * _e2658));
                                let _e3151 = (((_e3130 * _e2666) + (_e3133 * _e2667)) + (_e3136 * _e2668));
                                let _e3159 = (((_e3130 * _e2665[0]) + (_e3133 * _e2665[1])) + (_e3136 * _e2665[2]));
                                let _e3164 = (((_e3130 * _e2671[0]) + (_e3133 * _e2671[1])) + (_e3136 * _e2671[2]));
                                let _e3169 = (((_e3130 * _e2688) + (_e3133 * _e2689)) + (_e3136 * _e2690));
                                let _e3174 = (((_e3130 * _e2698) + (_e3133 * _e2699)) + (_e3136 * _e2700));
                                let _e3182 = (((_e3130 * _e2697[0]) + (_e3133 * _e2697[1])) + (_e3136 * _e2697[2]));
                                if (_e3141 < _e3146) {
                                    phi_5177_ = _e3141;
                                } else {
                                    phi_5177_ = _e3146;
                                }
                                let _e3185 = phi_5177_;
                                if (_e3151 < _e3159) {
                                    phi_5182_ = _e3151;
                                } else {
                                    phi_5182_ = _e3159;
                                }
                                let _e3188 = phi_5182_;
                                if (_e3185 < _e3188) {
                                    phi_5187_ = _e3185;
                                } else {
                                    phi_5187_ = _e3188;
                                }
                                let _e3191 = phi_5187_;
                                if (_e3164 < _e3169) {
                                    phi_5192_ = _e3164;
                                } else {
                                    phi_5192_ = _e3169;
                                }
                                let _e3194 = phi_5192_;
                                if (_e3174 < _e3182) {
                                    phi_5197_ = _e3174;
                                } else {
                                    phi_5197_ = _e3182;
                                }
                                let _e3197 = phi_5197_;
                                if (_e3194 < _e3197) {
                                    phi_5202_ = _e3194;
                                } else {
                                    phi_5202_ = _e3197;
                                }
                                let _e3200 = phi_5202_;
                                if (_e3191 < _e3200) {
                                    phi_5207_ = _e3191;
                                } else {
                                    phi_5207_ = _e3200;
                                }
                                let _e3203 = phi_5207_;
                                if (_e3141 > _e3146) {
                                    phi_5212_ = _e3141;
                                } else {
                                    phi_5212_ = _e3146;
                                }
                                let _e3206 = phi_5212_;
                                if (_e3151 > _e3159) {
                                    phi_5217_ = _e3151;
                                } else {
                                    phi_5217_ = _e3159;
                                }
                                let _e3209 = phi_5217_;
                                if (_e3206 > _e3209) {
                                    phi_5222_ = _e3206;
                                } else {
                                    phi_5222_ = _e3209;
                                }
                                let _e3212 = phi_5222_;
                                if (_e3164 > _e3169) {
                                    phi_5227_ = _e3164;
                                } else {
                                    phi_5227_ = _e3169;
                                }
                                let _e3215 = phi_5227_;
                                if (_e3174 > _e3182) {
                                    phi_5232_ = _e3174;
                                } else {
                                    phi_5232_ = _e3182;
                                }
                                let _e3218 = phi_5232_;
                                if (_e3215 > _e3218) {
                                    phi_5237_ = _e3215;
                                } else {
                                    phi_5237_ = _e3218;
                                }
                                let _e3221 = phi_5237_;
                                if (_e3212 > _e3221) {
                                    phi_5242_ = _e3212;
                                } else {
                                    phi_5242_ = _e3221;
                                }
                                let _e3224 = phi_5242_;
                                if (_e3130 < 0f) {
                                    phi_5248_ = -(_e3130);
                                } else {
                                    phi_5248_ = _e3130;
                                }
                                let _e3228 = phi_5248_;
                                if (_e3133 < 0f) {
                                    phi_5254_ = -(_e3133);
                                } else {
                                    phi_5254_ = _e3133;
                                }
                                let _e3232 = phi_5254_;
                                if (_e3136 < 0f) {
                                    phi_5261_ = -(_e3136);
                                } else {
                                    phi_5261_ = _e3136;
                                }
                                let _e3237 = phi_5261_;
                                let _e3238 = ((_e3228 + _e3232) + _e3237);
                                let _e3243 = -(_e3224);
                                if (_e3203 > _e3243) {
                                    phi_5272_ = _e3203;
                                } else {
                                    phi_5272_ = _e3243;
                                }
                                let _e3246 = phi_5272_;
                                let _e3251 = (((_e3246 - ((_e3238 * _e2865) * (0.000000059604645f * (17f / 2f)))) - (_e3238 * _e2872)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3123 > _e3251) {
                                    phi_5282_ = _e3123;
                                } else {
                                    phi_5282_ = _e3251;
                                }
                                let _e3254 = phi_5282_;
                                phi_5283_ = _e3254;
                            } else {
                                phi_5283_ = _e3123;
                            }
                            let _e3256 = phi_5283_;
                            phi_5286_ = (_e2597 || (_e3256 > 0f));
                        }
                        let _e3260 = phi_5286_;
                        if _e3260 {
                            let _e3263 = local_1.member_1[0u];
                            let _e3269 = local_1.member_2[0u];
                            let _e3275 = ((_e3263[1] * _e3269[2]) - (_e3263[2] * _e3269[1]));
                            let _e3278 = ((_e3263[2] * _e3269[0]) - (_e3263[0] * _e3269[2]));
                            let _e3281 = ((_e3263[0] * _e3269[1]) - (_e3263[1] * _e3269[0]));
                            let _e3284 = local_1.member_1[1u];
                            let _e3290 = local_1.member_2[1u];
                            let _e3296 = ((_e3284[1] * _e3290[2]) - (_e3284[2] * _e3290[1]));
                            let _e3299 = ((_e3284[2] * _e3290[0]) - (_e3284[0] * _e3290[2]));
                            let _e3302 = ((_e3284[0] * _e3290[1]) - (_e3284[1] * _e3290[0]));
                            let _e3305 = local_1.member_1[0u];
                            let _e3311 = local_1.member_2[1u];
                            let _e3326 = local_1.member_1[1u];
                            let _e3332 = local_1.member_2[0u];
                            let _e3345 = (((_e3305[1] * _e3311[2]) - (_e3305[2] * _e3311[1])) + ((_e3326[1] * _e3332[2]) - (_e3326[2] * _e3332[1])));
                            let _e3346 = (((_e3305[2] * _e3311[0]) - (_e3305[0] * _e3311[2])) + ((_e3326[2] * _e3332[0]) - (_e3326[0] * _e3332[2])));
                            let _e3347 = (((_e3305[0] * _e3311[1]) - (_e3305[1] * _e3311[0])) + ((_e3326[0] * _e3332[1]) - (_e3326[1] * _e3332[0])));
                            let _e3350 = local_1.member[0u];
                            let _e3361 = local_1.member[1u];
                            let _e3372 = local_1.member[0u];
                            let _e3381 = ((((_e3361[0] * _e3275) + (_e3361[1] * _e3278)) + (_e3361[2] * _e3281)) + (((_e3372[0] * _e3345) + (_e3372[1] * _e3346)) + (_e3372[2] * _e3347)));
                            let _e3384 = local_1.member[0u];
                            let _e3395 = local_1.member[1u];
                            let _e3404 = ((((_e3384[0] * _e3296) + (_e3384[1] * _e3299)) + (_e3384[2] * _e3302)) + (((_e3395[0] * _e3345) + (_e3395[1] * _e3346)) + (_e3395[2] * _e3347)));
                            let _e3407 = local_1.member[1u];
                            let _e3418 = local_1.member[0u];
                            if (_e3418[0] < 0f) {
                                phi_5531_ = -(_e3418[0]);
                            } else {
                                phi_5531_ = _e3418[0];
                            }
                            let _e3425 = phi_5531_;
                            if (_e3418[1] < 0f) {
                                phi_5538_ = -(_e3418[1]);
                            } else {
                                phi_5538_ = _e3418[1];
                            }
                            let _e3429 = phi_5538_;
                            if (_e3425 > _e3429) {
                                phi_5543_ = _e3425;
                            } else {
                                phi_5543_ = _e3429;
                            }
                            let _e3432 = phi_5543_;
                            if (_e3418[2] < 0f) {
                                phi_5550_ = -(_e3418[2]);
                            } else {
                                phi_5550_ = _e3418[2];
                            }
                            let _e3436 = phi_5550_;
                            if (_e3432 > _e3436) {
                                phi_5555_ = _e3432;
                            } else {
                                phi_5555_ = _e3436;
                            }
                            let _e3439 = phi_5555_;
                            let _e3442 = local_1.member[1u];
                            if (_e3442[0] < 0f) {
                                phi_5568_ = -(_e3442[0]);
                            } else {
                                phi_5568_ = _e3442[0];
                            }
                            let _e3449 = phi_5568_;
                            if (_e3442[1] < 0f) {
                                phi_5575_ = -(_e3442[1]);
                            } else {
                                phi_5575_ = _e3442[1];
                            }
                            let _e3453 = phi_5575_;
                            if (_e3449 > _e3453) {
                                phi_5580_ = _e3449;
                            } else {
                                phi_5580_ = _e3453;
                            }
                            let _e3456 = phi_5580_;
                            if (_e3442[2] < 0f) {
                                phi_5587_ = -(_e3442[2]);
                            } else {
                                phi_5587_ = _e3442[2];
                            }
                            let _e3460 = phi_5587_;
                            if (_e3456 > _e3460) {
                                phi_5592_ = _e3456;
                            } else {
                                phi_5592_ = _e3460;
                            }
                            let _e3463 = phi_5592_;
                            if (_e3439 > _e3463) {
                                phi_5597_ = _e3439;
                            } else {
                                phi_5597_ = _e3463;
                            }
                            let _e3466 = phi_5597_;
                            let _e3468 = local_1.member_3;
                            let _e3469 = (_e3466 + _e3468);
                            let _e3472 = local_1.member_1[0u];
                            if (_e3472[0] < 0f) {
                                phi_5614_ = -(_e3472[0]);
                            } else {
                                phi_5614_ = _e3472[0];
                            }
                            let _e3479 = phi_5614_;
                            if (_e3472[1] < 0f) {
                                phi_5621_ = -(_e3472[1]);
                            } else {
                                phi_5621_ = _e3472[1];
                            }
                            let _e3483 = phi_5621_;
                            if (_e3479 > _e3483) {
                                phi_5626_ = _e3479;
                            } else {
                                phi_5626_ = _e3483;
                            }
                            let _e3486 = phi_5626_;
                            if (_e3472[2] < 0f) {
                                phi_5633_ = -(_e3472[2]);
                            } else {
                                phi_5633_ = _e3472[2];
                            }
                            let _e3490 = phi_5633_;
                            if (_e3486 > _e3490) {
                                phi_5638_ = _e3486;
                            } else {
                                phi_5638_ = _e3490;
                            }
                            let _e3493 = phi_5638_;
                            let _e3496 = local_1.member_1[1u];
                            if (_e3496[0] < 0f) {
                                phi_5652_ = -(_e3496[0]);
                            } else {
                                phi_5652_ = _e3496[0];
                            }
                            let _e3503 = phi_5652_;
                            if (_e3496[1] < 0f) {
                                phi_5659_ = -(_e3496[1]);
                            } else {
                                phi_5659_ = _e3496[1];
                            }
                            let _e3507 = phi_5659_;
                            if (_e3503 > _e3507) {
                                phi_5664_ = _e3503;
                            } else {
                                phi_5664_ = _e3507;
                            }
                            let _e3510 = phi_5664_;
                            if (_e3496[2] < 0f) {
                                phi_5671_ = -(_e3496[2]);
                            } else {
                                phi_5671_ = _e3496[2];
                            }
                            let _e3514 = phi_5671_;
                            if (_e3510 > _e3514) {
                                phi_5676_ = _e3510;
                            } else {
                                phi_5676_ = _e3514;
                            }
                            let _e3517 = phi_5676_;
                            if (_e3493 > _e3517) {
                                phi_5681_ = _e3493;
                            } else {
                                phi_5681_ = _e3517;
                            }
                            let _e3520 = phi_5681_;
                            let _e3522 = local_1.member_3;
                            let _e3523 = (_e3520 + _e3522);
                            let _e3526 = local_1.member_2[0u];
                            if (_e3526[0] < 0f) {
                                phi_5698_ = -(_e3526[0]);
                            } else {
                                phi_5698_ = _e3526[0];
                            }
                            let _e3533 = phi_5698_;
                            if (_e3526[1] < 0f) {
                                phi_5705_ = -(_e3526[1]);
                            } else {
                                phi_5705_ = _e3526[1];
                            }
                            let _e3537 = phi_5705_;
                            if (_e3533 > _e3537) {
                                phi_5710_ = _e3533;
                            } else {
                                phi_5710_ = _e3537;
                            }
                            let _e3540 = phi_5710_;
                            if (_e3526[2] < 0f) {
                                phi_5717_ = -(_e3526[2]);
                            } else {
                                phi_5717_ = _e3526[2];
                            }
                            let _e3544 = phi_5717_;
                            if (_e3540 > _e3544) {
                                phi_5722_ = _e3540;
                            } else {
                                phi_5722_ = _e3544;
                            }
                            let _e3547 = phi_5722_;
                            let _e3550 = local_1.member_2[1u];
                            if (_e3550[0] < 0f) {
                                phi_5736_ = -(_e3550[0]);
                            } else {
                                phi_5736_ = _e3550[0];
                            }
                            let _e3557 = phi_5736_;
                            if (_e3550[1] < 0f) {
                                phi_5743_ = -(_e3550[1]);
                            } else {
                                phi_5743_ = _e3550[1];
                            }
                            let _e3561 = phi_5743_;
                            if (_e3557 > _e3561) {
                                phi_5748_ = _e3557;
                            } else {
                                phi_5748_ = _e3561;
                            }
                            let _e3564 = phi_5748_;
                            if (_e3550[2] < 0f) {
                                phi_5755_ = -(_e3550[2]);
                            } else {
                                phi_5755_ = _e3550[2];
                            }
                            let _e3568 = phi_5755_;
                            if (_e3564 > _e3568) {
                                phi_5760_ = _e3564;
                            } else {
                                phi_5760_ = _e3568;
                            }
                            let _e3571 = phi_5760_;
                            if (_e3547 > _e3571) {
                                phi_5765_ = _e3547;
                            } else {
                                phi_5765_ = _e3571;
                            }
                            let _e3574 = phi_5765_;
                            let _e3576 = local_1.member_3;
                            let _e3577 = (_e3574 + _e3576);
                            let _e3579 = ((_e3523 * 8f) * _e3577);
                            let _e3586 = local_1.member_3;
                            if (_e3275 < 0f) {
                                phi_5796_ = -(_e3275);
                            } else {
                                phi_5796_ = _e3275;
                            }
                            let _e3603 = phi_5796_;
                            if (_e3278 < 0f) {
                                phi_5802_ = -(_e3278);
                            } else {
                                phi_5802_ = _e3278;
                            }
                            let _e3607 = phi_5802_;
                            if (_e3281 < 0f) {
                                phi_5809_ = -(_e3281);
                            } else {
                                phi_5809_ = _e3281;
                            }
                            let _e3612 = phi_5809_;
                            let _e3613 = ((_e3603 + _e3607) + _e3612);
                            if (_e3296 < 0f) {
                                phi_5816_ = -(_e3296);
                            } else {
                                phi_5816_ = _e3296;
                            }
                            let _e3617 = phi_5816_;
                            if (_e3299 < 0f) {
                                phi_5822_ = -(_e3299);
                            } else {
                                phi_5822_ = _e3299;
                            }
                            let _e3621 = phi_5822_;
                            if (_e3302 < 0f) {
                                phi_5829_ = -(_e3302);
                            } else {
                                phi_5829_ = _e3302;
                            }
                            let _e3626 = phi_5829_;
                            let _e3627 = ((_e3617 + _e3621) + _e3626);
                            if (_e3613 > _e3627) {
                                phi_5835_ = _e3613;
                            } else {
                                phi_5835_ = _e3627;
                            }
                            let _e3630 = phi_5835_;
                            if (_e3345 < 0f) {
                                phi_5841_ = -(_e3345);
                            } else {
                                phi_5841_ = _e3345;
                            }
                            let _e3634 = phi_5841_;
                            if (_e3346 < 0f) {
                                phi_5847_ = -(_e3346);
                            } else {
                                phi_5847_ = _e3346;
                            }
                            let _e3638 = phi_5847_;
                            if (_e3347 < 0f) {
                                phi_5854_ = -(_e3347);
                            } else {
                                phi_5854_ = _e3347;
                            }
                            let _e3643 = phi_5854_;
                            let _e3645 = (((_e3634 + _e3638) + _e3643) * 0.5f);
                            if (_e3630 > _e3645) {
                                phi_5861_ = _e3630;
                            } else {
                                phi_5861_ = _e3645;
                            }
                            let _e3648 = phi_5861_;
                            let _e3653 = local_1.member_3;
                            let _e3666 = ((((_e3350[0] * _e3275) + (_e3350[1] * _e3278)) + (_e3350[2] * _e3281)) * 3f);
                            let _e3667 = ((((_e3407[0] * _e3296) + (_e3407[1] * _e3299)) + (_e3407[2] * _e3302)) * 3f);
                            if (_e3666 < _e3667) {
                                phi_5885_ = _e3666;
                            } else {
                                phi_5885_ = _e3667;
                            }
                            let _e3670 = phi_5885_;
                            if (_e3381 < _e3404) {
                                phi_5890_ = _e3381;
                            } else {
                                phi_5890_ = _e3404;
                            }
                            let _e3673 = phi_5890_;
                            if (_e3670 < _e3673) {
                                phi_5895_ = _e3670;
                            } else {
                                phi_5895_ = _e3673;
                            }
                            let _e3676 = phi_5895_;
                            if (_e3666 > _e3667) {
                                phi_5900_ = _e3666;
                            } else {
                                phi_5900_ = _e3667;
                            }
                            let _e3679 = phi_5900_;
                            if (_e3381 > _e3404) {
                                phi_5905_ = _e3381;
                            } else {
                                phi_5905_ = _e3404;
                            }
                            let _e3682 = phi_5905_;
                            if (_e3679 > _e3682) {
                                phi_5910_ = _e3679;
                            } else {
                                phi_5910_ = _e3682;
                            }
                            let _e3685 = phi_5910_;
                            let _e3690 = -(_e3685);
                            if (_e3676 > _e3690) {
                                phi_5920_ = _e3676;
                            } else {
                                phi_5920_ = _e3690;
                            }
                            let _e3693 = phi_5920_;
                            let _e3695 = ((_e3693 - ((((((_e3469 * 8f) * _e3579) * (0.000000059604645f * (524f / 64f))) + ((_e3586 * 19f) * ((_e3469 * (_e3523 + _e3577)) + (_e3523 * _e3577)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3469) * ((1f + _e3523) * (1f + _e3577))))) + ((_e815 * (((_e3648 + (_e3579 * (0.000000059604645f * 8f))) + ((_e3653 * 6f) * (_e3523 + _e3577))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3523) * (1f + _e3577))))) * (3f * 1.0001f)))) > 0f);
                            if _e3695 {
                                phi_6889_ = _e3695;
                            } else {
                                let _e3698 = local_1.member_1[0u];
                                let _e3704 = local_1.member_1[1u];
                                let _e3708 = (_e3698[0] + _e3704[0]);
                                let _e3709 = (_e3698[1] + _e3704[1]);
                                let _e3710 = (_e3698[2] + _e3704[2]);
                                let _e3713 = local_1.member_2[0u];
                                let _e3719 = local_1.member_2[1u];
                                let _e3723 = (_e3713[0] + _e3719[0]);
                                let _e3724 = (_e3713[1] + _e3719[1]);
                                let _e3725 = (_e3713[2] + _e3719[2]);
                                let _e3728 = ((_e3709 * _e3725) - (_e3710 * _e3724));
                                let _e3731 = ((_e3710 * _e3723) - (_e3708 * _e3725));
                                let _e3734 = ((_e3708 * _e3724) - (_e3709 * _e3723));
                                let _e3737 = local_1.member[0u];
                                let _e3744 = local_1.member_1[0u];
                                let _e3750 = local_1.member_2[0u];
                                let _e3754 = (_e3737[0] - _e3744[0]);
                                let _e3755 = (_e3737[1] - _e3744[1]);
                                let _e3756 = (_e3737[2] - _e3744[2]);
                                if (_e179.member == 0u) {
                                    phi_6036_ = array<f32, 3>(_e3737[0], _e3737[1], _e3737[2]);
                                } else {
                                    phi_6036_ = array<f32, 3>((_e3754 - _e3750[0]), (_e3755 - _e3750[1]), (_e3756 - _e3750[2]));
                                }
                                let _e3763 = phi_6036_;
                                let _e3764 = (_e3737[0] - _e3750[0]);
                                let _e3765 = (_e3737[1] - _e3750[1]);
                                let _e3766 = (_e3737[2] - _e3750[2]);
                                let _e3769 = local_1.member[1u];
                                let _e3776 = local_1.member_1[1u];
                                let _e3782 = local_1.member_2[1u];
                                let _e3786 = (_e3769[0] - _e3776[0]);
                                let _e3787 = (_e3769[1] - _e3776[1]);
                                let _e3788 = (_e3769[2] - _e3776[2]);
                                if (_e179.member == 0u) {
                                    phi_6101_ = array<f32, 3>(_e3769[0], _e3769[1], _e3769[2]);
                                } else {
                                    phi_6101_ = array<f32, 3>((_e3786 - _e3782[0]), (_e3787 - _e3782[1]), (_e3788 - _e3782[2]));
                                }
                                let _e3795 = phi_6101_;
                                let _e3796 = (_e3769[0] - _e3782[0]);
                                let _e3797 = (_e3769[1] - _e3782[1]);
                                let _e3798 = (_e3769[2] - _e3782[2]);
                                let _e3801 = local_1.member[0u];
                                if (_e3801[0] < 0f) {
                                    phi_6123_ = -(_e3801[0]);
                                } else {
                                    phi_6123_ = _e3801[0];
                                }
                                let _e3808 = phi_6123_;
                                if (_e3801[1] < 0f) {
                                    phi_6130_ = -(_e3801[1]);
                                } else {
                                    phi_6130_ = _e3801[1];
                                }
                                let _e3812 = phi_6130_;
                                if (_e3808 > _e3812) {
                                    phi_6135_ = _e3808;
                                } else {
                                    phi_6135_ = _e3812;
                                }
                                let _e3815 = phi_6135_;
                                if (_e3801[2] < 0f) {
                                    phi_6142_ = -(_e3801[2]);
                                } else {
                                    phi_6142_ = _e3801[2];
                                }
                                let _e3819 = phi_6142_;
                                if (_e3815 > _e3819) {
                                    phi_6147_ = _e3815;
                                } else {
                                    phi_6147_ = _e3819;
                                }
                                let _e3822 = phi_6147_;
                                let _e3825 = local_1.member[1u];
                                if (_e3825[0] < 0f) {
                                    phi_6160_ = -(_e3825[0]);
                                } else {
                                    phi_6160_ = _e3825[0];
                                }
                                let _e3832 = phi_6160_;
                                if (_e3825[1] < 0f) {
                                    phi_6167_ = -(_e3825[1]);
                                } else {
                                    phi_6167_ = _e3825[1];
                                }
                                let _e3836 = phi_6167_;
                                if (_e3832 > _e3836) {
                                    phi_6172_ = _e3832;
                                } else {
                                    phi_6172_ = _e3836;
                                }
                                let _e3839 = phi_6172_;
                                if (_e3825[2] < 0f) {
                                    phi_6179_ = -(_e3825[2]);
                                } else {
                                    phi_6179_ = _e3825[2];
                                }
                                let _e3843 = phi_6179_;
                                if (_e3839 > _e3843) {
                                    phi_6184_ = _e3839;
                                } else {
                                    phi_6184_ = _e3843;
                                }
                                let _e3846 = phi_6184_;
                                if (_e3822 > _e3846) {
                                    phi_6189_ = _e3822;
                                } else {
                                    phi_6189_ = _e3846;
                                }
                                let _e3849 = phi_6189_;
                                let _e3851 = local_1.member_3;
                                let _e3855 = local_1.member_1[0u];
                                if (_e3855[0] < 0f) {
                                    phi_6206_ = -(_e3855[0]);
                                } else {
                                    phi_6206_ = _e3855[0];
                                }
                                let _e3862 = phi_6206_;
                                if (_e3855[1] < 0f) {
                                    phi_6213_ = -(_e3855[1]);
                                } else {
                                    phi_6213_ = _e3855[1];
                                }
                                let _e3866 = phi_6213_;
                                if (_e3862 > _e3866) {
                                    phi_6218_ = _e3862;
                                } else {
                                    phi_6218_ = _e3866;
                                }
                                let _e3869 = phi_6218_;
                                if (_e3855[2] < 0f) {
                                    phi_6225_ = -(_e3855[2]);
                                } else {
                                    phi_6225_ = _e3855[2];
                                }
                                let _e3873 = phi_6225_;
                                if (_e3869 > _e3873) {
                                    phi_6230_ = _e3869;
                                } else {
                                    phi_6230_ = _e3873;
                                }
                                let _e3876 = phi_6230_;
                                let _e3879 = local_1.member_1[1u];
                                if (_e3879[0] < 0f) {
                                    phi_6244_ = -(_e3879[0]);
                                } else {
                                    phi_6244_ = _e3879[0];
                                }
                                let _e3886 = phi_6244_;
                                if (_e3879[1] < 0f) {
                                    phi_6251_ = -(_e3879[1]);
                                } else {
                                    phi_6251_ = _e3879[1];
                                }
                                let _e3890 = phi_6251_;
                                if (_e3886 > _e3890) {
                                    phi_6256_ = _e3886;
                                } else {
                                    phi_6256_ = _e3890;
                                }
                                let _e3893 = phi_6256_;
                                if (_e3879[2] < 0f) {
                                    phi_6263_ = -(_e3879[2]);
                                } else {
                                    phi_6263_ = _e3879[2];
                                }
                                let _e3897 = phi_6263_;
                                if (_e3893 > _e3897) {
                                    phi_6268_ = _e3893;
                                } else {
                                    phi_6268_ = _e3897;
                                }
                                let _e3900 = phi_6268_;
                                if (_e3876 > _e3900) {
                                    phi_6273_ = _e3876;
                                } else {
                                    phi_6273_ = _e3900;
                                }
                                let _e3903 = phi_6273_;
                                let _e3905 = local_1.member_3;
                                let _e3909 = local_1.member_2[0u];
                                if (_e3909[0] < 0f) {
                                    phi_6290_ = -(_e3909[0]);
                                } else {
                                    phi_6290_ = _e3909[0];
                                }
                                let _e3916 = phi_6290_;
                                if (_e3909[1] < 0f) {
                                    phi_6297_ = -(_e3909[1]);
                                } else {
                                    phi_6297_ = _e3909[1];
                                }
                                let _e3920 = phi_6297_;
                                if (_e3916 > _e3920) {
                                    phi_6302_ = _e3916;
                                } else {
                                    phi_6302_ = _e3920;
                                }
                                let _e3923 = phi_6302_;
                                if (_e3909[2] < 0f) {
                                    phi_6309_ = -(_e3909[2]);
                                } else {
                                    phi_6309_ = _e3909[2];
                                }
                                let _e3927 = phi_6309_;
                                if (_e3923 > _e3927) {
                                    phi_6314_ = _e3923;
                                } else {
                                    phi_6314_ = _e3927;
                                }
                                let _e3930 = phi_6314_;
                                let _e3933 = local_1.member_2[1u];
                                if (_e3933[0] < 0f) {
                                    phi_6328_ = -(_e3933[0]);
                                } else {
                                    phi_6328_ = _e3933[0];
                                }
                                let _e3940 = phi_6328_;
                                if (_e3933[1] < 0f) {
                                    phi_6335_ = -(_e3933[1]);
                                } else {
                                    phi_6335_ = _e3933[1];
                                }
                                let _e3944 = phi_6335_;
                                if (_e3940 > _e3944) {
                                    phi_6340_ = _e3940;
                                } else {
                                    phi_6340_ = _e3944;
                                }
                                let _e3947 = phi_6340_;
                                if (_e3933[2] < 0f) {
                                    phi_6347_ = -(_e3933[2]);
                                } else {
                                    phi_6347_ = _e3933[2];
                                }
                                let _e3951 = phi_6347_;
                                if (_e3947 > _e3951) {
                                    phi_6352_ = _e3947;
                                } else {
                                    phi_6352_ = _e3951;
                                }
                                let _e3954 = phi_6352_;
                                if (_e3930 > _e3954) {
                                    phi_6357_ = _e3930;
                                } else {
                                    phi_6357_ = _e3954;
                                }
                                let _e3957 = phi_6357_;
                                let _e3959 = local_1.member_3;
                                let _e3963 = ((((_e3849 + _e3851) + (_e3903 + _e3905)) + (_e3957 + _e3959)) * 2f);
                                let _e3966 = local_1.member_3;
                                let _e3970 = (((_e815 * 1.0001f) + (_e3966 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e3973 = ((_e3731 * _e3710) - (_e3734 * _e3709));
                                let _e3976 = ((_e3734 * _e3708) - (_e3728 * _e3710));
                                let _e3979 = ((_e3728 * _e3709) - (_e3731 * _e3708));
                                let _e3984 = (((_e3973 * _e3737[0]) + (_e3976 * _e3737[1])) + (_e3979 * _e3737[2]));
                                let _e3989 = (((_e3973 * _e3754) + (_e3976 * _e3755)) + (_e3979 * _e3756));
                                let _e3994 = (((_e3973 * _e3764) + (_e3976 * _e3765)) + (_e3979 * _e3766));
                                let _e4002 = (((_e3973 * _e3763[0]) + (_e3976 * _e3763[1])) + (_e3979 * _e3763[2]));
                                let _e4007 = (((_e3973 * _e3769[0]) + (_e3976 * _e3769[1])) + (_e3979 * _e3769[2]));
                                let _e4012 = (((_e3973 * _e3786) + (_e3976 * _e3787)) + (_e3979 * _e3788));
                                let _e4017 = (((_e3973 * _e3796) + (_e3976 * _e3797)) + (_e3979 * _e3798));
                                let _e4025 = (((_e3973 * _e3795[0]) + (_e3976 * _e3795[1])) + (_e3979 * _e3795[2]));
                                if (_e3984 < _e3989) {
                                    phi_6436_ = _e3984;
                                } else {
                                    phi_6436_ = _e3989;
                                }
                                let _e4028 = phi_6436_;
                                if (_e3994 < _e4002) {
                                    phi_6441_ = _e3994;
                                } else {
                                    phi_6441_ = _e4002;
                                }
                                let _e4031 = phi_6441_;
                                if (_e4028 < _e4031) {
                                    phi_6446_ = _e4028;
                                } else {
                                    phi_6446_ = _e4031;
                                }
                                let _e4034 = phi_6446_;
                                if (_e4007 < _e4012) {
                                    phi_6451_ = _e4007;
                                } else {
                                    phi_6451_ = _e4012;
                                }
                                let _e4037 = phi_6451_;
                                if (_e4017 < _e4025) {
                                    phi_6456_ = _e4017;
                                } else {
                                    phi_6456_ = _e4025;
                                }
                                let _e4040 = phi_6456_;
                                if (_e4037 < _e4040) {
                                    phi_6461_ = _e4037;
                                } else {
                                    phi_6461_ = _e4040;
                                }
                                let _e4043 = phi_6461_;
                                if (_e4034 < _e4043) {
                                    phi_6466_ = _e4034;
                                } else {
                                    phi_6466_ = _e4043;
                                }
                                let _e4046 = phi_6466_;
                                if (_e3984 > _e3989) {
                                    phi_6471_ = _e3984;
                                } else {
                                    phi_6471_ = _e3989;
                                }
                                let _e4049 = phi_6471_;
                                if (_e3994 > _e4002) {
                                    phi_6476_ = _e3994;
                                } else {
                                    phi_6476_ = _e4002;
                                }
                                let _e4052 = phi_6476_;
                                if (_e4049 > _e4052) {
                                    phi_6481_ = _e4049;
                                } else {
                                    phi_6481_ = _e4052;
                                }
                                let _e4055 = phi_6481_;
                                if (_e4007 > _e4012) {
                                    phi_6486_ = _e4007;
                                } else {
                                    phi_6486_ = _e4012;
                                }
                                let _e4058 = phi_6486_;
                                if (_e4017 > _e4025) {
                                    phi_6491_ = _e4017;
                                } else {
                                    phi_6491_ = _e4025;
                                }
                                let _e4061 = phi_6491_;
                                if (_e4058 > _e4061) {
                                    phi_6496_ = _e4058;
                                } else {
                                    phi_6496_ = _e4061;
                                }
                                let _e4064 = phi_6496_;
                                if (_e4055 > _e4064) {
                                    phi_6501_ = _e4055;
                                } else {
                                    phi_6501_ = _e4064;
                                }
                                let _e4067 = phi_6501_;
                                if (_e3973 < 0f) {
                                    phi_6507_ = -(_e3973);
                                } else {
                                    phi_6507_ = _e3973;
                                }
                                let _e4071 = phi_6507_;
                                if (_e3976 < 0f) {
                                    phi_6513_ = -(_e3976);
                                } else {
                                    phi_6513_ = _e3976;
                                }
                                let _e4075 = phi_6513_;
                                if (_e3979 < 0f) {
                                    phi_6520_ = -(_e3979);
                                } else {
                                    phi_6520_ = _e3979;
                                }
                                let _e4080 = phi_6520_;
                                let _e4081 = ((_e4071 + _e4075) + _e4080);
                                let _e4086 = -(_e4067);
                                if (_e4046 > _e4086) {
                                    phi_6531_ = _e4046;
                                } else {
                                    phi_6531_ = _e4086;
                                }
                                let _e4089 = phi_6531_;
                                let _e4094 = (((_e4089 - ((_e4081 * _e3963) * (0.000000059604645f * (17f / 2f)))) - (_e4081 * _e3970)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e4097 = ((_e3731 * _e3725) - (_e3734 * _e3724));
                                let _e4100 = ((_e3734 * _e3723) - (_e3728 * _e3725));
                                let _e4103 = ((_e3728 * _e3724) - (_e3731 * _e3723));
                                let _e4108 = (((_e4097 * _e3737[0]) + (_e4100 * _e3737[1])) + (_e4103 * _e3737[2]));
                                let _e4113 = (((_e4097 * _e3754) + (_e4100 * _e3755)) + (_e4103 * _e3756));
                                let _e4118 = (((_e4097 * _e3764) + (_e4100 * _e3765)) + (_e4103 * _e3766));
                                let _e4126 = (((_e4097 * _e3763[0]) + (_e4100 * _e3763[1])) + (_e4103 * _e3763[2]));
                                let _e4131 = (((_e4097 * _e3769[0]) + (_e4100 * _e3769[1])) + (_e4103 * _e3769[2]));
                                let _e4136 = (((_e4097 * _e3786) + (_e4100 * _e3787)) + (_e4103 * _e3788));
                                let _e4141 = (((_e4097 * _e3796) + (_e4100 * _e3797)) + (_e4103 * _e3798));
                                let _e4149 = (((_e4097 * _e3795[0]) + (_e4100 * _e3795[1])) + (_e4103 * _e3795[2]));
                                if (_e4108 < _e4113) {
                                    phi_6602_ = _e4108;
                                } else {
                                    phi_6602_ = _e4113;
                                }
                                let _e4152 = phi_6602_;
                                if (_e4118 < _e4126) {
                                    phi_6607_ = _e4118;
                                } else {
                                    phi_6607_ = _e4126;
                                }
                                let _e4155 = phi_6607_;
                                if (_e4152 < _e4155) {
                                    phi_6612_ = _e4152;
                                } else {
                                    phi_6612_ = _e4155;
                                }
                                let _e4158 = phi_6612_;
                                if (_e4131 < _e4136) {
                                    phi_6617_ = _e4131;
                                } else {
                                    phi_6617_ = _e4136;
                                }
                                let _e4161 = phi_6617_;
                                if (_e4141 < _e4149) {
                                    phi_6622_ = _e4141;
                                } else {
                                    phi_6622_ = _e4149;
                                }
                                let _e4164 = phi_6622_;
                                if (_e4161 < _e4164) {
                                    phi_6627_ = _e4161;
                                } else {
                                    phi_6627_ = _e4164;
                                }
                                let _e4167 = phi_6627_;
                                if (_e4158 < _e4167) {
                                    phi_6632_ = _e4158;
                                } else {
                                    phi_6632_ = _e4167;
                                }
                                let _e4170 = phi_6632_;
                                if (_e4108 > _e4113) {
                                    phi_6637_ = _e4108;
                                } else {
                                    phi_6637_ = _e4113;
                                }
                                let _e4173 = phi_6637_;
                                if (_e4118 > _e4126) {
                                    phi_6642_ = _e4118;
                                } else {
                                    phi_6642_ = _e4126;
                                }
                                let _e4176 = phi_6642_;
                                if (_e4173 > _e4176) {
                                    phi_6647_ = _e4173;
                                } else {
                                    phi_6647_ = _e4176;
                                }
                                let _e4179 = phi_6647_;
                                if (_e4131 > _e4136) {
                                    phi_6652_ = _e4131;
                                } else {
                                    phi_6652_ = _e4136;
                                }
                                let _e4182 = phi_6652_;
                                if (_e4141 > _e4149) {
                                    phi_6657_ = _e4141;
                                } else {
                                    phi_6657_ = _e4149;
                                }
                                let _e4185 = phi_6657_;
                                if (_e4182 > _e4185) {
                                    phi_6662_ = _e4182;
                                } else {
                                    phi_6662_ = _e4185;
                                }
                                let _e4188 = phi_6662_;
                                if (_e4179 > _e4188) {
                                    phi_6667_ = _e4179;
                                } else {
                                    phi_6667_ = _e4188;
                                }
                                let _e4191 = phi_6667_;
                                if (_e4097 < 0f) {
                                    phi_6673_ = -(_e4097);
                                } else {
                                    phi_6673_ = _e4097;
                                }
                                let _e4195 = phi_6673_;
                                if (_e4100 < 0f) {
                                    phi_6679_ = -(_e4100);
                                } else {
                                    phi_6679_ = _e4100;
                                }
                                let _e4199 = phi_6679_;
                                if (_e4103 < 0f) {
                                    phi_6686_ = -(_e4103);
                                } else {
                                    phi_6686_ = _e4103;
                                }
                                let _e4204 = phi_6686_;
                                let _e4205 = ((_e4195 + _e4199) + _e4204);
                                let _e4210 = -(_e4191);
                                if (_e4170 > _e4210) {
                                    phi_6697_ = _e4170;
                                } else {
                                    phi_6697_ = _e4210;
                                }
                                let _e4213 = phi_6697_;
                                let _e4218 = (((_e4213 - ((_e4205 * _e3963) * (0.000000059604645f * (17f / 2f)))) - (_e4205 * _e3970)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e4094 > _e4218) {
                                    phi_6707_ = _e4094;
                                } else {
                                    phi_6707_ = _e4218;
                                }
                                let _e4221 = phi_6707_;
                                if (_e179.member == 0u) {
                                    let _e4223 = (_e3723 - _e3708);
                                    let _e4224 = (_e3724 - _e3709);
                                    let _e4225 = (_e3725 - _e3710);
                                    let _e4228 = ((_e3731 * _e4225) - (_e3734 * _e4224));
                                    let _e4231 = ((_e3734 * _e4223) - (_e3728 * _e4225));
                                    let _e4234 = ((_e3728 * _e4224) - (_e3731 * _e4223));
                                    let _e4239 = (((_e4228 * _e3737[0]) + (_e4231 * _e3737[1])) + (_e4234 * _e3737[2]));
                                    let _e4244 = (((_e4228 * _e3754) + (_e4231 * _e3755)) + (_e4234 * _e3756));
                                    let _e4249 = (((_e4228 * _e3764) + (_e4231 * _e3765)) + (_e4234 * _e3766));
                                    let _e4257 = (((_e4228 * _e3763[0]) + (_e4231 * _e3763[1])) + (_e4234 * _e3763[2]));
                                    let _e4262 = (((_e4228 * _e3769[0]) + (_e4231 * _e3769[1])) + (_e4234 * _e3769[2]));
                                    let _e4267 = (((_e4228 * _e3786) + (_e4231 * _e3787)) + (_e4234 * _e3788));
                                    let _e4272 = (((_e4228 * _e3796) + (_e4231 * _e3797)) + (_e4234 * _e3798));
                                    let _e4280 = (((_e4228 * _e3795[0]) + (_e4231 * _e3795[1])) + (_e4234 * _e3795[2]));
                                    if (_e4239 < _e4244) {
                                        phi_6780_ = _e4239;
                                    } else {
                                        phi_6780_ = _e4244;
                                    }
                                    let _e4283 = phi_6780_;
                                    if (_e4249 < _e4257) {
                                        phi_6785_ = _e4249;
                                    } else {
                                        phi_6785_ = _e4257;
                                    }
                                    let _e4286 = phi_6785_;
                                    if (_e4283 < _e4286) {
                                        phi_6790_ = _e4283;
                                    } else {
                                        phi_6790_ = _e4286;
                                    }
                                    let _e4289 = phi_6790_;
                                    if (_e4262 < _e4267) {
                                        phi_6795_ = _e4262;
                                    } else {
                                        phi_6795_ = _e4267;
                                    }
                                    let _e4292 = phi_6795_;
                                    if (_e4272 < _e4280) {
                                        phi_6800_ = _e4272;
                                    } else {
                                        phi_6800_ = _e4280;
                                    }
                                    let _e4295 = phi_6800_;
                                    if (_e4292 < _e4295) {
                                        phi_6805_ = _e4292;
                                    } else {
                                        phi_6805_ = _e4295;
                                    }
                                    let _e4298 = phi_6805_;
                                    if (_e4289 < _e4298) {
                                        phi_6810_ = _e4289;
                                    } else {
                                        phi_6810_ = _e4298;
                                    }
                                    let _e4301 = phi_6810_;
                                    if (_e4239 > _e4244) {
                                        phi_6815_ = _e4239;
                                    } else {
                                        phi_6815_ = _e4244;
                                    }
                                    let _e4304 = phi_6815_;
                                    if (_e4249 > _e4257) {
                                        phi_6820_ = _e4249;
                                    } else {
                                        phi_6820_ = _e4257;
                                    }
                                    let _e4307 = phi_6820_;
                                    if (_e4304 > _e4307) {
                                        phi_6825_ = _e4304;
                                    } else {
                                        phi_6825_ = _e4307;
                                    }
                                    let _e4310 = phi_6825_;
                                    if (_e4262 > _e4267) {
                                        phi_6830_ = _e4262;
                                    } else {
                                        phi_6830_ = _e4267;
                                    }
                                    let _e4313 = phi_6830_;
                                    if (_e4272 > _e4280) {
                                        phi_6835_ = _e4272;
                                    } else {
                                        phi_6835_ = _e4280;
                                    }
                                    let _e4316 = phi_6835_;
                                    if (_e4313 > _e4316) {
                                        phi_6840_ = _e4313;
                                    } else {
                                        phi_6840_ = _e4316;
                                    }
                                    let _e4319 = phi_6840_;
                                    if (_e4310 > _e4319) {
                                        phi_6845_ = _e4310;
                                    } else {
                                        phi_6845_ = _e4319;
                                    }
                                    let _e4322 = phi_6845_;
                                    if (_e4228 < 0f) {
                                        phi_6851_ = -(_e4228);
                                    } else {
                                        phi_6851_ = _e4228;
                                    }
                                    let _e4326 = phi_6851_;
                                    if (_e4231 < 0f) {
                                        phi_6857_ = -(_e4231);
                                    } else {
                                        phi_6857_ = _e4231;
                                    }
                                    let _e4330 = phi_6857_;
                                    if (_e4234 < 0f) {
                                        phi_6864_ = -(_e4234);
                                    } else {
                                        phi_6864_ = _e4234;
                                    }
                                    let _e4335 = phi_6864_;
                                    let _e4336 = ((_e4326 + _e4330) + _e4335);
                                    let _e4341 = -(_e4322);
                                    if (_e4301 > _e4341) {
                                        phi_6875_ = _e4301;
                                    } else {
                                        phi_6875_ = _e4341;
                                    }
                                    let _e4344 = phi_6875_;
                                    let _e4349 = (((_e4344 - ((_e4336 * _e3963) * (0.000000059604645f * (17f / 2f)))) - (_e4336 * _e3970)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4221 > _e4349) {
                                        phi_6885_ = _e4221;
                                    } else {
                                        phi_6885_ = _e4349;
                                    }
                                    let _e4352 = phi_6885_;
                                    phi_6886_ = _e4352;
                                } else {
                                    phi_6886_ = _e4221;
                                }
                                let _e4354 = phi_6886_;
                                phi_6889_ = (_e3695 || (_e4354 > 0f));
                            }
                            let _e4358 = phi_6889_;
                            phi_6891_ = (_e3260 && _e4358);
                        } else {
                            phi_6891_ = _e3260;
                        }
                        let _e4361 = phi_6891_;
                        phi_6893_ = (_e2072 || _e4361);
                    }
                    let _e4364 = phi_6893_;
                    let _e4365 = !(_e4364);
                    if _e4365 {
                        let _e4367 = atomicAdd((&counters[0u]), 1u);
                        phi_6900_ = _e4367;
                    } else {
                        phi_6900_ = 0u;
                    }
                    let _e4369 = phi_6900_;
                    phi_6901_ = _e4369;
                    phi_6902_ = _e4365;
                } else {
                    phi_6901_ = 0u;
                    phi_6902_ = false;
                }
                let _e4371 = phi_6901_;
                let _e4373 = phi_6902_;
                phi_6903_ = _e4371;
                phi_6904_ = _e4373;
                phi_6905_ = type_9(_e147, _e150);
            } else {
                phi_6903_ = 0u;
                phi_6904_ = false;
                phi_6905_ = type_9(0u, 0u);
            }
            let _e4375 = phi_6903_;
            let _e4377 = phi_6904_;
            let _e4379 = phi_6905_;
            workgroupBarrier();
            if (_e53 == 0u) {
                let _e4382 = atomicLoad((&counters[0u]));
                let _e4384 = atomicLoad((&counters[1u]));
                if (_e4382 > 0u) {
                    let _e4387 = atomicAdd((&output.member[0u]), _e4382);
                    if ((_e4387 + _e4382) < _e4387) {
                        let _e4391 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e4387);
                }
                if (_e4384 > 0u) {
                    let _e4395 = atomicAdd((&output.member[1u]), _e4384);
                    if ((_e4395 + _e4384) < _e4395) {
                        let _e4399 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e4377 {
                let _e4401 = params.member.member_1.member_3;
                let _e4403 = atomicLoad((&counters[2u]));
                let _e4404 = (_e4403 + _e4375);
                if (_e4404 < _e4401) {
                    let _e4408 = (2u * _e4404);
                    atomicStore((&output.member[(4u + _e4408)]), _e4379.member);
                    atomicStore((&output.member[(_e4408 + 5u)]), _e4379.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_374_ = _e126;
            break if !(_e132);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_listed(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
