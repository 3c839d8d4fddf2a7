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
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_28 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_30 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
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
var<storage> boxes: type_25;
@group(0) @binding(3) 
var<storage> bodies: type_13;
@group(0) @binding(4) 
var<storage> keys: type_28;
@group(0) @binding(5) 
var<storage> paths: type_21;
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
    var local: type_30;
    var local_1: type_30;
    var local_2: type_30;
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
    var phi_1846_: type_30;
    var phi_2126_: f32;
    var phi_2133_: f32;
    var phi_2138_: f32;
    var phi_2145_: f32;
    var phi_2150_: f32;
    var phi_2163_: f32;
    var phi_2170_: f32;
    var phi_2175_: f32;
    var phi_2182_: f32;
    var phi_2187_: f32;
    var phi_2192_: f32;
    var phi_2209_: f32;
    var phi_2216_: f32;
    var phi_2221_: f32;
    var phi_2228_: f32;
    var phi_2233_: f32;
    var phi_2247_: f32;
    var phi_2254_: f32;
    var phi_2259_: f32;
    var phi_2266_: f32;
    var phi_2271_: f32;
    var phi_2276_: f32;
    var phi_2293_: f32;
    var phi_2300_: f32;
    var phi_2305_: f32;
    var phi_2312_: f32;
    var phi_2317_: f32;
    var phi_2331_: f32;
    var phi_2338_: f32;
    var phi_2343_: f32;
    var phi_2350_: f32;
    var phi_2355_: f32;
    var phi_2360_: f32;
    var phi_2391_: f32;
    var phi_2397_: f32;
    var phi_2404_: f32;
    var phi_2411_: f32;
    var phi_2417_: f32;
    var phi_2424_: f32;
    var phi_2430_: f32;
    var phi_2436_: f32;
    var phi_2442_: f32;
    var phi_2449_: f32;
    var phi_2456_: f32;
    var phi_2480_: f32;
    var phi_2485_: f32;
    var phi_2490_: f32;
    var phi_2495_: f32;
    var phi_2500_: f32;
    var phi_2505_: f32;
    var phi_2515_: f32;
    var phi_2631_: array<f32, 3>;
    var phi_2696_: array<f32, 3>;
    var phi_2718_: f32;
    var phi_2725_: f32;
    var phi_2730_: f32;
    var phi_2737_: f32;
    var phi_2742_: f32;
    var phi_2755_: f32;
    var phi_2762_: f32;
    var phi_2767_: f32;
    var phi_2774_: f32;
    var phi_2779_: f32;
    var phi_2784_: f32;
    var phi_2801_: f32;
    var phi_2808_: f32;
    var phi_2813_: f32;
    var phi_2820_: f32;
    var phi_2825_: f32;
    var phi_2839_: f32;
    var phi_2846_: f32;
    var phi_2851_: f32;
    var phi_2858_: f32;
    var phi_2863_: f32;
    var phi_2868_: f32;
    var phi_2885_: f32;
    var phi_2892_: f32;
    var phi_2897_: f32;
    var phi_2904_: f32;
    var phi_2909_: f32;
    var phi_2923_: f32;
    var phi_2930_: f32;
    var phi_2935_: f32;
    var phi_2942_: f32;
    var phi_2947_: f32;
    var phi_2952_: f32;
    var phi_3031_: f32;
    var phi_3036_: f32;
    var phi_3041_: f32;
    var phi_3046_: f32;
    var phi_3051_: f32;
    var phi_3056_: f32;
    var phi_3061_: f32;
    var phi_3066_: f32;
    var phi_3071_: f32;
    var phi_3076_: f32;
    var phi_3081_: f32;
    var phi_3086_: f32;
    var phi_3091_: f32;
    var phi_3096_: f32;
    var phi_3102_: f32;
    var phi_3108_: f32;
    var phi_3115_: f32;
    var phi_3126_: f32;
    var phi_3197_: f32;
    var phi_3202_: f32;
    var phi_3207_: f32;
    var phi_3212_: f32;
    var phi_3217_: f32;
    var phi_3222_: f32;
    var phi_3227_: f32;
    var phi_3232_: f32;
    var phi_3237_: f32;
    var phi_3242_: f32;
    var phi_3247_: f32;
    var phi_3252_: f32;
    var phi_3257_: f32;
    var phi_3262_: f32;
    var phi_3268_: f32;
    var phi_3274_: f32;
    var phi_3281_: f32;
    var phi_3292_: f32;
    var phi_3302_: f32;
    var phi_3375_: f32;
    var phi_3380_: f32;
    var phi_3385_: f32;
    var phi_3390_: f32;
    var phi_3395_: f32;
    var phi_3400_: f32;
    var phi_3405_: f32;
    var phi_3410_: f32;
    var phi_3415_: f32;
    var phi_3420_: f32;
    var phi_3425_: f32;
    var phi_3430_: f32;
    var phi_3435_: f32;
    var phi_3440_: f32;
    var phi_3446_: f32;
    var phi_3452_: f32;
    var phi_3459_: f32;
    var phi_3470_: f32;
    var phi_3480_: f32;
    var phi_3481_: f32;
    var phi_3484_: bool;
    var phi_3936_: f32;
    var phi_3943_: f32;
    var phi_3948_: f32;
    var phi_3955_: f32;
    var phi_3960_: f32;
    var phi_3973_: f32;
    var phi_3980_: f32;
    var phi_3985_: f32;
    var phi_3992_: f32;
    var phi_3997_: f32;
    var phi_4002_: f32;
    var phi_4019_: f32;
    var phi_4026_: f32;
    var phi_4031_: f32;
    var phi_4038_: f32;
    var phi_4043_: f32;
    var phi_4057_: f32;
    var phi_4064_: f32;
    var phi_4069_: f32;
    var phi_4076_: f32;
    var phi_4081_: f32;
    var phi_4086_: f32;
    var phi_4103_: f32;
    var phi_4110_: f32;
    var phi_4115_: f32;
    var phi_4122_: f32;
    var phi_4127_: f32;
    var phi_4141_: f32;
    var phi_4148_: f32;
    var phi_4153_: f32;
    var phi_4160_: f32;
    var phi_4165_: f32;
    var phi_4170_: f32;
    var phi_4201_: f32;
    var phi_4207_: f32;
    var phi_4214_: f32;
    var phi_4221_: f32;
    var phi_4227_: f32;
    var phi_4234_: f32;
    var phi_4240_: f32;
    var phi_4246_: f32;
    var phi_4252_: f32;
    var phi_4259_: f32;
    var phi_4266_: f32;
    var phi_4290_: f32;
    var phi_4295_: f32;
    var phi_4300_: f32;
    var phi_4305_: f32;
    var phi_4310_: f32;
    var phi_4315_: f32;
    var phi_4325_: f32;
    var phi_4441_: array<f32, 3>;
    var phi_4506_: array<f32, 3>;
    var phi_4528_: f32;
    var phi_4535_: f32;
    var phi_4540_: f32;
    var phi_4547_: f32;
    var phi_4552_: f32;
    var phi_4565_: f32;
    var phi_4572_: f32;
    var phi_4577_: f32;
    var phi_4584_: f32;
    var phi_4589_: f32;
    var phi_4594_: f32;
    var phi_4611_: f32;
    var phi_4618_: f32;
    var phi_4623_: f32;
    var phi_4630_: f32;
    var phi_4635_: f32;
    var phi_4649_: f32;
    var phi_4656_: f32;
    var phi_4661_: f32;
    var phi_4668_: f32;
    var phi_4673_: f32;
    var phi_4678_: f32;
    var phi_4695_: f32;
    var phi_4702_: f32;
    var phi_4707_: f32;
    var phi_4714_: f32;
    var phi_4719_: f32;
    var phi_4733_: f32;
    var phi_4740_: f32;
    var phi_4745_: f32;
    var phi_4752_: f32;
    var phi_4757_: f32;
    var phi_4762_: f32;
    var phi_4841_: f32;
    var phi_4846_: f32;
    var phi_4851_: f32;
    var phi_4856_: f32;
    var phi_4861_: f32;
    var phi_4866_: f32;
    var phi_4871_: f32;
    var phi_4876_: f32;
    var phi_4881_: f32;
    var phi_4886_: f32;
    var phi_4891_: f32;
    var phi_4896_: f32;
    var phi_4901_: f32;
    var phi_4906_: f32;
    var phi_4912_: f32;
    var phi_4918_: f32;
    var phi_4925_: f32;
    var phi_4936_: f32;
    var phi_5007_: f32;
    var phi_5012_: f32;
    var phi_5017_: f32;
    var phi_5022_: f32;
    var phi_5027_: f32;
    var phi_5032_: f32;
    var phi_5037_: f32;
    var phi_5042_: f32;
    var phi_5047_: f32;
    var phi_5052_: f32;
    var phi_5057_: f32;
    var phi_5062_: f32;
    var phi_5067_: f32;
    var phi_5072_: f32;
    var phi_5078_: f32;
    var phi_5084_: f32;
    var phi_5091_: f32;
    var phi_5102_: f32;
    var phi_5112_: f32;
    var phi_5185_: f32;
    var phi_5190_: f32;
    var phi_5195_: f32;
    var phi_5200_: f32;
    var phi_5205_: f32;
    var phi_5210_: f32;
    var phi_5215_: f32;
    var phi_5220_: f32;
    var phi_5225_: f32;
    var phi_5230_: f32;
    var phi_5235_: f32;
    var phi_5240_: f32;
    var phi_5245_: f32;
    var phi_5250_: f32;
    var phi_5256_: f32;
    var phi_5262_: f32;
    var phi_5269_: f32;
    var phi_5280_: f32;
    var phi_5290_: f32;
    var phi_5291_: f32;
    var phi_5294_: bool;
    var phi_5539_: f32;
    var phi_5546_: f32;
    var phi_5551_: f32;
    var phi_5558_: f32;
    var phi_5563_: f32;
    var phi_5576_: f32;
    var phi_5583_: f32;
    var phi_5588_: f32;
    var phi_5595_: f32;
    var phi_5600_: f32;
    var phi_5605_: f32;
    var phi_5622_: f32;
    var phi_5629_: f32;
    var phi_5634_: f32;
    var phi_5641_: f32;
    var phi_5646_: f32;
    var phi_5660_: f32;
    var phi_5667_: f32;
    var phi_5672_: f32;
    var phi_5679_: f32;
    var phi_5684_: f32;
    var phi_5689_: f32;
    var phi_5706_: f32;
    var phi_5713_: f32;
    var phi_5718_: f32;
    var phi_5725_: f32;
    var phi_5730_: f32;
    var phi_5744_: f32;
    var phi_5751_: f32;
    var phi_5756_: f32;
    var phi_5763_: f32;
    var phi_5768_: f32;
    var phi_5773_: f32;
    var phi_5804_: f32;
    var phi_5810_: f32;
    var phi_5817_: f32;
    var phi_5824_: f32;
    var phi_5830_: f32;
    var phi_5837_: f32;
    var phi_5843_: f32;
    var phi_5849_: f32;
    var phi_5855_: f32;
    var phi_5862_: f32;
    var phi_5869_: f32;
    var phi_5893_: f32;
    var phi_5898_: f32;
    var phi_5903_: f32;
    var phi_5908_: f32;
    var phi_5913_: f32;
    var phi_5918_: f32;
    var phi_5928_: f32;
    var phi_6044_: array<f32, 3>;
    var phi_6109_: array<f32, 3>;
    var phi_6131_: f32;
    var phi_6138_: f32;
    var phi_6143_: f32;
    var phi_6150_: f32;
    var phi_6155_: f32;
    var phi_6168_: f32;
    var phi_6175_: f32;
    var phi_6180_: f32;
    var phi_6187_: f32;
    var phi_6192_: f32;
    var phi_6197_: f32;
    var phi_6214_: f32;
    var phi_6221_: f32;
    var phi_6226_: f32;
    var phi_6233_: f32;
    var phi_6238_: f32;
    var phi_6252_: f32;
    var phi_6259_: f32;
    var phi_6264_: f32;
    var phi_6271_: f32;
    var phi_6276_: f32;
    var phi_6281_: f32;
    var phi_6298_: f32;
    var phi_6305_: f32;
    var phi_6310_: f32;
    var phi_6317_: f32;
    var phi_6322_: f32;
    var phi_6336_: f32;
    var phi_6343_: f32;
    var phi_6348_: f32;
    var phi_6355_: f32;
    var phi_6360_: f32;
    var phi_6365_: f32;
    var phi_6444_: f32;
    var phi_6449_: f32;
    var phi_6454_: f32;
    var phi_6459_: f32;
    var phi_6464_: f32;
    var phi_6469_: f32;
    var phi_6474_: f32;
    var phi_6479_: f32;
    var phi_6484_: f32;
    var phi_6489_: f32;
    var phi_6494_: f32;
    var phi_6499_: f32;
    var phi_6504_: f32;
    var phi_6509_: f32;
    var phi_6515_: f32;
    var phi_6521_: f32;
    var phi_6528_: f32;
    var phi_6539_: f32;
    var phi_6610_: f32;
    var phi_6615_: f32;
    var phi_6620_: f32;
    var phi_6625_: f32;
    var phi_6630_: f32;
    var phi_6635_: f32;
    var phi_6640_: f32;
    var phi_6645_: f32;
    var phi_6650_: f32;
    var phi_6655_: f32;
    var phi_6660_: f32;
    var phi_6665_: f32;
    var phi_6670_: f32;
    var phi_6675_: f32;
    var phi_6681_: f32;
    var phi_6687_: f32;
    var phi_6694_: f32;
    var phi_6705_: f32;
    var phi_6715_: f32;
    var phi_6788_: f32;
    var phi_6793_: f32;
    var phi_6798_: f32;
    var phi_6803_: f32;
    var phi_6808_: f32;
    var phi_6813_: f32;
    var phi_6818_: f32;
    var phi_6823_: f32;
    var phi_6828_: f32;
    var phi_6833_: f32;
    var phi_6838_: f32;
    var phi_6843_: f32;
    var phi_6848_: f32;
    var phi_6853_: f32;
    var phi_6859_: f32;
    var phi_6865_: f32;
    var phi_6872_: f32;
    var phi_6883_: f32;
    var phi_6893_: f32;
    var phi_6894_: f32;
    var phi_6897_: bool;
    var phi_6899_: bool;
    var phi_6901_: bool;
    var phi_6908_: u32;
    var phi_6909_: u32;
    var phi_6910_: bool;
    var phi_6911_: u32;
    var phi_6912_: bool;
    var phi_6913_: type_9;
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
                    let _e821 = paths.member[_e179.member_1[1]];
                    let _e828 = paths.member[_e179.member_1[2]];
                    let _e831 = paths.member[_e179.member_1[3]];
                    if (_e179.member != 0u) {
                        phi_1846_ = type_30(array<array<f32, 3>, 2>(array<f32, 3>((_e828.member[0] - _e818.member[0]), (_e828.member[1] - _e818.member[1]), (_e828.member[2] - _e818.member[2])), array<f32, 3>((_e828.member_1[0] - _e818.member_1[0]), (_e828.member_1[1] - _e818.member_1[1]), (_e828.member_1[2] - _e818.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e821.member[0] - _e818.member[0]), (_e821.member[1] - _e818.member[1]), (_e821.member[2] - _e818.member[2])), array<f32, 3>((_e821.member_1[0] - _e818.member_1[0]), (_e821.member_1[1] - _e818.member_1[1]), (_e821.member_1[2] - _e818.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e828.member[0] - _e831.member[0]), (_e828.member[1] - _e831.member[1]), (_e828.member[2] - _e831.member[2])), array<f32, 3>((_e828.member_1[0] - _e831.member_1[0]), (_e828.member_1[1] - _e831.member_1[1]), (_e828.member_1[2] - _e831.member_1[2]))), (_e813 + _e813));
                    } else {
                        phi_1846_ = type_30(array<array<f32, 3>, 2>(array<f32, 3>((_e818.member[0] - _e821.member[0]), (_e818.member[1] - _e821.member[1]), (_e818.member[2] - _e821.member[2])), array<f32, 3>((_e818.member_1[0] - _e821.member_1[0]), (_e818.member_1[1] - _e821.member_1[1]), (_e818.member_1[2] - _e821.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e828.member[0] - _e821.member[0]), (_e828.member[1] - _e821.member[1]), (_e828.member[2] - _e821.member[2])), array<f32, 3>((_e828.member_1[0] - _e821.member_1[0]), (_e828.member_1[1] - _e821.member_1[1]), (_e828.member_1[2] - _e821.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e831.member[0] - _e821.member[0]), (_e831.member[1] - _e821.member[1]), (_e831.member[2] - _e821.member[2])), array<f32, 3>((_e831.member_1[0] - _e821.member_1[0]), (_e831.member_1[1] - _e821.member_1[1]), (_e831.member_1[2] - _e821.member_1[2]))), (_e813 + _e813));
                    }
                    let _e920 = phi_1846_;
                    local_2 = type_30(array<array<f32, 3>, 2>(array<f32, 3>(_e920.member[0][0], _e920.member[0][1], _e920.member[0][2]), array<f32, 3>(_e920.member[1][0], _e920.member[1][1], _e920.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e920.member_1[0][0], _e920.member_1[0][1], _e920.member_1[0][2]), array<f32, 3>(_e920.member_1[1][0], _e920.member_1[1][1], _e920.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e920.member_2[0][0], _e920.member_2[0][1], _e920.member_2[0][2]), array<f32, 3>(_e920.member_2[1][0], _e920.member_2[1][1], _e920.member_2[1][2])), _e920.member_3);
                    let _e961 = local_2.member_1[0u];
                    let _e967 = local_2.member_2[0u];
                    let _e973 = ((_e961[1] * _e967[2]) - (_e961[2] * _e967[1]));
                    let _e976 = ((_e961[2] * _e967[0]) - (_e961[0] * _e967[2]));
                    let _e979 = ((_e961[0] * _e967[1]) - (_e961[1] * _e967[0]));
                    let _e982 = local_2.member_1[1u];
                    let _e988 = local_2.member_2[1u];
                    let _e994 = ((_e982[1] * _e988[2]) - (_e982[2] * _e988[1]));
                    let _e997 = ((_e982[2] * _e988[0]) - (_e982[0] * _e988[2]));
                    let _e1000 = ((_e982[0] * _e988[1]) - (_e982[1] * _e988[0]));
                    let _e1003 = local_2.member_1[0u];
                    let _e1009 = local_2.member_2[1u];
                    let _e1024 = local_2.member_1[1u];
                    let _e1030 = local_2.member_2[0u];
                    let _e1043 = (((_e1003[1] * _e1009[2]) - (_e1003[2] * _e1009[1])) + ((_e1024[1] * _e1030[2]) - (_e1024[2] * _e1030[1])));
                    let _e1044 = (((_e1003[2] * _e1009[0]) - (_e1003[0] * _e1009[2])) + ((_e1024[2] * _e1030[0]) - (_e1024[0] * _e1030[2])));
                    let _e1045 = (((_e1003[0] * _e1009[1]) - (_e1003[1] * _e1009[0])) + ((_e1024[0] * _e1030[1]) - (_e1024[1] * _e1030[0])));
                    let _e1048 = local_2.member[0u];
                    let _e1059 = local_2.member[1u];
                    let _e1070 = local_2.member[0u];
                    let _e1079 = ((((_e1059[0] * _e973) + (_e1059[1] * _e976)) + (_e1059[2] * _e979)) + (((_e1070[0] * _e1043) + (_e1070[1] * _e1044)) + (_e1070[2] * _e1045)));
                    let _e1082 = local_2.member[0u];
                    let _e1093 = local_2.member[1u];
                    let _e1102 = ((((_e1082[0] * _e994) + (_e1082[1] * _e997)) + (_e1082[2] * _e1000)) + (((_e1093[0] * _e1043) + (_e1093[1] * _e1044)) + (_e1093[2] * _e1045)));
                    let _e1105 = local_2.member[1u];
                    let _e1116 = local_2.member[0u];
                    if (_e1116[0] < 0f) {
                        phi_2126_ = -(_e1116[0]);
                    } else {
                        phi_2126_ = _e1116[0];
                    }
                    let _e1123 = phi_2126_;
                    if (_e1116[1] < 0f) {
                        phi_2133_ = -(_e1116[1]);
                    } else {
                        phi_2133_ = _e1116[1];
                    }
                    let _e1127 = phi_2133_;
                    if (_e1123 > _e1127) {
                        phi_2138_ = _e1123;
                    } else {
                        phi_2138_ = _e1127;
                    }
                    let _e1130 = phi_2138_;
                    if (_e1116[2] < 0f) {
                        phi_2145_ = -(_e1116[2]);
                    } else {
                        phi_2145_ = _e1116[2];
                    }
                    let _e1134 = phi_2145_;
                    if (_e1130 > _e1134) {
                        phi_2150_ = _e1130;
                    } else {
                        phi_2150_ = _e1134;
                    }
                    let _e1137 = phi_2150_;
                    let _e1140 = local_2.member[1u];
                    if (_e1140[0] < 0f) {
                        phi_2163_ = -(_e1140[0]);
                    } else {
                        phi_2163_ = _e1140[0];
                    }
                    let _e1147 = phi_2163_;
                    if (_e1140[1] < 0f) {
                        phi_2170_ = -(_e1140[1]);
                    } else {
                        phi_2170_ = _e1140[1];
                    }
                    let _e1151 = phi_2170_;
                    if (_e1147 > _e1151) {
                        phi_2175_ = _e1147;
                    } else {
                        phi_2175_ = _e1151;
                    }
                    let _e1154 = phi_2175_;
                    if (_e1140[2] < 0f) {
                        phi_2182_ = -(_e1140[2]);
                    } else {
                        phi_2182_ = _e1140[2];
                    }
                    let _e1158 = phi_2182_;
                    if (_e1154 > _e1158) {
                        phi_2187_ = _e1154;
                    } else {
                        phi_2187_ = _e1158;
                    }
                    let _e1161 = phi_2187_;
                    if (_e1137 > _e1161) {
                        phi_2192_ = _e1137;
                    } else {
                        phi_2192_ = _e1161;
                    }
                    let _e1164 = phi_2192_;
                    let _e1166 = local_2.member_3;
                    let _e1167 = (_e1164 + _e1166);
                    let _e1170 = local_2.member_1[0u];
                    if (_e1170[0] < 0f) {
                        phi_2209_ = -(_e1170[0]);
                    } else {
                        phi_2209_ = _e1170[0];
                    }
                    let _e1177 = phi_2209_;
                    if (_e1170[1] < 0f) {
                        phi_2216_ = -(_e1170[1]);
                    } else {
                        phi_2216_ = _e1170[1];
                    }
                    let _e1181 = phi_2216_;
                    if (_e1177 > _e1181) {
                        phi_2221_ = _e1177;
                    } else {
                        phi_2221_ = _e1181;
                    }
                    let _e1184 = phi_2221_;
                    if (_e1170[2] < 0f) {
                        phi_2228_ = -(_e1170[2]);
                    } else {
                        phi_2228_ = _e1170[2];
                    }
                    let _e1188 = phi_2228_;
                    if (_e1184 > _e1188) {
                        phi_2233_ = _e1184;
                    } else {
                        phi_2233_ = _e1188;
                    }
                    let _e1191 = phi_2233_;
                    let _e1194 = local_2.member_1[1u];
                    if (_e1194[0] < 0f) {
                        phi_2247_ = -(_e1194[0]);
                    } else {
                        phi_2247_ = _e1194[0];
                    }
                    let _e1201 = phi_2247_;
                    if (_e1194[1] < 0f) {
                        phi_2254_ = -(_e1194[1]);
                    } else {
                        phi_2254_ = _e1194[1];
                    }
                    let _e1205 = phi_2254_;
                    if (_e1201 > _e1205) {
                        phi_2259_ = _e1201;
                    } else {
                        phi_2259_ = _e1205;
                    }
                    let _e1208 = phi_2259_;
                    if (_e1194[2] < 0f) {
                        phi_2266_ = -(_e1194[2]);
                    } else {
                        phi_2266_ = _e1194[2];
                    }
                    let _e1212 = phi_2266_;
                    if (_e1208 > _e1212) {
                        phi_2271_ = _e1208;
                    } else {
                        phi_2271_ = _e1212;
                    }
                    let _e1215 = phi_2271_;
                    if (_e1191 > _e1215) {
                        phi_2276_ = _e1191;
                    } else {
                        phi_2276_ = _e1215;
                    }
                    let _e1218 = phi_2276_;
                    let _e1220 = local_2.member_3;
                    let _e1221 = (_e1218 + _e1220);
                    let _e1224 = local_2.member_2[0u];
                    if (_e1224[0] < 0f) {
                        phi_2293_ = -(_e1224[0]);
                    } else {
                        phi_2293_ = _e1224[0];
                    }
                    let _e1231 = phi_2293_;
                    if (_e1224[1] < 0f) {
                        phi_2300_ = -(_e1224[1]);
                    } else {
                        phi_2300_ = _e1224[1];
                    }
                    let _e1235 = phi_2300_;
                    if (_e1231 > _e1235) {
                        phi_2305_ = _e1231;
                    } else {
                        phi_2305_ = _e1235;
                    }
                    let _e1238 = phi_2305_;
                    if (_e1224[2] < 0f) {
                        phi_2312_ = -(_e1224[2]);
                    } else {
                        phi_2312_ = _e1224[2];
                    }
                    let _e1242 = phi_2312_;
                    if (_e1238 > _e1242) {
                        phi_2317_ = _e1238;
                    } else {
                        phi_2317_ = _e1242;
                    }
                    let _e1245 = phi_2317_;
                    let _e1248 = local_2.member_2[1u];
                    if (_e1248[0] < 0f) {
                        phi_2331_ = -(_e1248[0]);
                    } else {
                        phi_2331_ = _e1248[0];
                    }
                    let _e1255 = phi_2331_;
                    if (_e1248[1] < 0f) {
                        phi_2338_ = -(_e1248[1]);
                    } else {
                        phi_2338_ = _e1248[1];
                    }
                    let _e1259 = phi_2338_;
                    if (_e1255 > _e1259) {
                        phi_2343_ = _e1255;
                    } else {
                        phi_2343_ = _e1259;
                    }
                    let _e1262 = phi_2343_;
                    if (_e1248[2] < 0f) {
                        phi_2350_ = -(_e1248[2]);
                    } else {
                        phi_2350_ = _e1248[2];
                    }
                    let _e1266 = phi_2350_;
                    if (_e1262 > _e1266) {
                        phi_2355_ = _e1262;
                    } else {
                        phi_2355_ = _e1266;
                    }
                    let _e1269 = phi_2355_;
                    if (_e1245 > _e1269) {
                        phi_2360_ = _e1245;
                    } else {
                        phi_2360_ = _e1269;
                    }
                    let _e1272 = phi_2360_;
                    let _e1274 = local_2.member_3;
                    let _e1275 = (_e1272 + _e1274);
                    let _e1277 = ((_e1221 * 8f) * _e1275);
                    let _e1284 = local_2.member_3;
                    if (_e973 < 0f) {
                        phi_2391_ = -(_e973);
                    } else {
                        phi_2391_ = _e973;
                    }
                    let _e1301 = phi_2391_;
                    if (_e976 < 0f) {
                        phi_2397_ = -(_e976);
                    } else {
                        phi_2397_ = _e976;
                    }
                    let _e1305 = phi_2397_;
                    if (_e979 < 0f) {
                        phi_2404_ = -(_e979);
                    } else {
                        phi_2404_ = _e979;
                    }
                    let _e1310 = phi_2404_;
                    let _e1311 = ((_e1301 + _e1305) + _e1310);
                    if (_e994 < 0f) {
                        phi_2411_ = -(_e994);
                    } else {
                        phi_2411_ = _e994;
                    }
                    let _e1315 = phi_2411_;
                    if (_e997 < 0f) {
                        phi_2417_ = -(_e997);
                    } else {
                        phi_2417_ = _e997;
                    }
                    let _e1319 = phi_2417_;
                    if (_e1000 < 0f) {
                        phi_2424_ = -(_e1000);
                    } else {
                        phi_2424_ = _e1000;
                    }
                    let _e1324 = phi_2424_;
                    let _e1325 = ((_e1315 + _e1319) + _e1324);
                    if (_e1311 > _e1325) {
                        phi_2430_ = _e1311;
                    } else {
                        phi_2430_ = _e1325;
                    }
                    let _e1328 = phi_2430_;
                    if (_e1043 < 0f) {
                        phi_2436_ = -(_e1043);
                    } else {
                        phi_2436_ = _e1043;
                    }
                    let _e1332 = phi_2436_;
                    if (_e1044 < 0f) {
                        phi_2442_ = -(_e1044);
                    } else {
                        phi_2442_ = _e1044;
                    }
                    let _e1336 = phi_2442_;
                    if (_e1045 < 0f) {
                        phi_2449_ = -(_e1045);
                    } else {
                        phi_2449_ = _e1045;
                    }
                    let _e1341 = phi_2449_;
                    let _e1343 = (((_e1332 + _e1336) + _e1341) * 0.5f);
                    if (_e1328 > _e1343) {
                        phi_2456_ = _e1328;
                    } else {
                        phi_2456_ = _e1343;
                    }
                    let _e1346 = phi_2456_;
                    let _e1351 = local_2.member_3;
                    let _e1364 = ((((_e1048[0] * _e973) + (_e1048[1] * _e976)) + (_e1048[2] * _e979)) * 3f);
                    let _e1365 = ((((_e1105[0] * _e994) + (_e1105[1] * _e997)) + (_e1105[2] * _e1000)) * 3f);
                    if (_e1364 < _e1365) {
                        phi_2480_ = _e1364;
                    } else {
                        phi_2480_ = _e1365;
                    }
                    let _e1368 = phi_2480_;
                    if (_e1079 < _e1102) {
                        phi_2485_ = _e1079;
                    } else {
                        phi_2485_ = _e1102;
                    }
                    let _e1371 = phi_2485_;
                    if (_e1368 < _e1371) {
                        phi_2490_ = _e1368;
                    } else {
                        phi_2490_ = _e1371;
                    }
                    let _e1374 = phi_2490_;
                    if (_e1364 > _e1365) {
                        phi_2495_ = _e1364;
                    } else {
                        phi_2495_ = _e1365;
                    }
                    let _e1377 = phi_2495_;
                    if (_e1079 > _e1102) {
                        phi_2500_ = _e1079;
                    } else {
                        phi_2500_ = _e1102;
                    }
                    let _e1380 = phi_2500_;
                    if (_e1377 > _e1380) {
                        phi_2505_ = _e1377;
                    } else {
                        phi_2505_ = _e1380;
                    }
                    let _e1383 = phi_2505_;
                    let _e1388 = -(_e1383);
                    if (_e1374 > _e1388) {
                        phi_2515_ = _e1374;
                    } else {
                        phi_2515_ = _e1388;
                    }
                    let _e1391 = phi_2515_;
                    let _e1393 = ((_e1391 - ((((((_e1167 * 8f) * _e1277) * (0.000000059604645f * (524f / 64f))) + ((_e1284 * 19f) * ((_e1167 * (_e1221 + _e1275)) + (_e1221 * _e1275)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1167) * ((1f + _e1221) * (1f + _e1275))))) + ((_e815 * (((_e1346 + (_e1277 * (0.000000059604645f * 8f))) + ((_e1351 * 6f) * (_e1221 + _e1275))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1221) * (1f + _e1275))))) * (3f * 1.0001f)))) > 0f);
                    if _e1393 {
                        phi_3484_ = _e1393;
                    } else {
                        let _e1396 = local_2.member_1[0u];
                        let _e1402 = local_2.member_1[1u];
                        let _e1406 = (_e1396[0] + _e1402[0]);
                        let _e1407 = (_e1396[1] + _e1402[1]);
                        let _e1408 = (_e1396[2] + _e1402[2]);
                        let _e1411 = local_2.member_2[0u];
                        let _e1417 = local_2.member_2[1u];
                        let _e1421 = (_e1411[0] + _e1417[0]);
                        let _e1422 = (_e1411[1] + _e1417[1]);
                        let _e1423 = (_e1411[2] + _e1417[2]);
                        let _e1426 = ((_e1407 * _e1423) - (_e1408 * _e1422));
                        let _e1429 = ((_e1408 * _e1421) - (_e1406 * _e1423));
                        let _e1432 = ((_e1406 * _e1422) - (_e1407 * _e1421));
                        let _e1435 = local_2.member[0u];
                        let _e1442 = local_2.member_1[0u];
                        let _e1448 = local_2.member_2[0u];
                        let _e1452 = (_e1435[0] - _e1442[0]);
                        let _e1453 = (_e1435[1] - _e1442[1]);
                        let _e1454 = (_e1435[2] - _e1442[2]);
                        if (_e179.member == 0u) {
                            phi_2631_ = array<f32, 3>(_e1435[0], _e1435[1], _e1435[2]);
                        } else {
                            phi_2631_ = array<f32, 3>((_e1452 - _e1448[0]), (_e1453 - _e1448[1]), (_e1454 - _e1448[2]));
                        }
                        let _e1461 = phi_2631_;
                        let _e1462 = (_e1435[0] - _e1448[0]);
                        let _e1463 = (_e1435[1] - _e1448[1]);
                        let _e1464 = (_e1435[2] - _e1448[2]);
                        let _e1467 = local_2.member[1u];
                        let _e1474 = local_2.member_1[1u];
                        let _e1480 = local_2.member_2[1u];
                        let _e1484 = (_e1467[0] - _e1474[0]);
                        let _e1485 = (_e1467[1] - _e1474[1]);
                        let _e1486 = (_e1467[2] - _e1474[2]);
                        if (_e179.member == 0u) {
                            phi_2696_ = array<f32, 3>(_e1467[0], _e1467[1], _e1467[2]);
                        } else {
                            phi_2696_ = array<f32, 3>((_e1484 - _e1480[0]), (_e1485 - _e1480[1]), (_e1486 - _e1480[2]));
                        }
                        let _e1493 = phi_2696_;
                        let _e1494 = (_e1467[0] - _e1480[0]);
                        let _e1495 = (_e1467[1] - _e1480[1]);
                        let _e1496 = (_e1467[2] - _e1480[2]);
                        let _e1499 = local_2.member[0u];
                        if (_e1499[0] < 0f) {
                            phi_2718_ = -(_e1499[0]);
                        } else {
                            phi_2718_ = _e1499[0];
                        }
                        let _e1506 = phi_2718_;
                        if (_e1499[1] < 0f) {
                            phi_2725_ = -(_e1499[1]);
                        } else {
                            phi_2725_ = _e1499[1];
                        }
                        let _e1510 = phi_2725_;
                        if (_e1506 > _e1510) {
                            phi_2730_ = _e1506;
                        } else {
                            phi_2730_ = _e1510;
                        }
                        let _e1513 = phi_2730_;
                        if (_e1499[2] < 0f) {
                            phi_2737_ = -(_e1499[2]);
                        } else {
                            phi_2737_ = _e1499[2];
                        }
                        let _e1517 = phi_2737_;
                        if (_e1513 > _e1517) {
                            phi_2742_ = _e1513;
                        } else {
                            phi_2742_ = _e1517;
                        }
                        let _e1520 = phi_2742_;
                        let _e1523 = local_2.member[1u];
                        if (_e1523[0] < 0f) {
                            phi_2755_ = -(_e1523[0]);
                        } else {
                            phi_2755_ = _e1523[0];
                        }
                        let _e1530 = phi_2755_;
                        if (_e1523[1] < 0f) {
                            phi_2762_ = -(_e1523[1]);
                        } else {
                            phi_2762_ = _e1523[1];
                        }
                        let _e1534 = phi_2762_;
                        if (_e1530 > _e1534) {
                            phi_2767_ = _e1530;
                        } else {
                            phi_2767_ = _e1534;
                        }
                        let _e1537 = phi_2767_;
                        if (_e1523[2] < 0f) {
                            phi_2774_ = -(_e1523[2]);
                        } else {
                            phi_2774_ = _e1523[2];
                        }
                        let _e1541 = phi_2774_;
                        if (_e1537 > _e1541) {
                            phi_2779_ = _e1537;
                        } else {
                            phi_2779_ = _e1541;
                        }
                        let _e1544 = phi_2779_;
                        if (_e1520 > _e1544) {
                            phi_2784_ = _e1520;
                        } else {
                            phi_2784_ = _e1544;
                        }
                        let _e1547 = phi_2784_;
                        let _e1549 = local_2.member_3;
                        let _e1553 = local_2.member_1[0u];
                        if (_e1553[0] < 0f) {
                            phi_2801_ = -(_e1553[0]);
                        } else {
                            phi_2801_ = _e1553[0];
                        }
                        let _e1560 = phi_2801_;
                        if (_e1553[1] < 0f) {
                            phi_2808_ = -(_e1553[1]);
                        } else {
                            phi_2808_ = _e1553[1];
                        }
                        let _e1564 = phi_2808_;
                        if (_e1560 > _e1564) {
                            phi_2813_ = _e1560;
                        } else {
                            phi_2813_ = _e1564;
                        }
                        let _e1567 = phi_2813_;
                        if (_e1553[2] < 0f) {
                            phi_2820_ = -(_e1553[2]);
                        } else {
                            phi_2820_ = _e1553[2];
                        }
                        let _e1571 = phi_2820_;
                        if (_e1567 > _e1571) {
                            phi_2825_ = _e1567;
                        } else {
                            phi_2825_ = _e1571;
                        }
                        let _e1574 = phi_2825_;
                        let _e1577 = local_2.member_1[1u];
                        if (_e1577[0] < 0f) {
                            phi_2839_ = -(_e1577[0]);
                        } else {
                            phi_2839_ = _e1577[0];
                        }
                        let _e1584 = phi_2839_;
                        if (_e1577[1] < 0f) {
                            phi_2846_ = -(_e1577[1]);
                        } else {
                            phi_2846_ = _e1577[1];
                        }
                        let _e1588 = phi_2846_;
                        if (_e1584 > _e1588) {
                            phi_2851_ = _e1584;
                        } else {
                            phi_2851_ = _e1588;
                        }
                        let _e1591 = phi_2851_;
                        if (_e1577[2] < 0f) {
                            phi_2858_ = -(_e1577[2]);
                        } else {
                            phi_2858_ = _e1577[2];
                        }
                        let _e1595 = phi_2858_;
                        if (_e1591 > _e1595) {
                            phi_2863_ = _e1591;
                        } else {
                            phi_2863_ = _e1595;
                        }
                        let _e1598 = phi_2863_;
                        if (_e1574 > _e1598) {
                            phi_2868_ = _e1574;
                        } else {
                            phi_2868_ = _e1598;
                        }
                        let _e1601 = phi_2868_;
                        let _e1603 = local_2.member_3;
                        let _e1607 = local_2.member_2[0u];
                        if (_e1607[0] < 0f) {
                            phi_2885_ = -(_e1607[0]);
                        } else {
                            phi_2885_ = _e1607[0];
                        }
                        let _e1614 = phi_2885_;
                        if (_e1607[1] < 0f) {
                            phi_2892_ = -(_e1607[1]);
                        } else {
                            phi_2892_ = _e1607[1];
                        }
                        let _e1618 = phi_2892_;
                        if (_e1614 > _e1618) {
                            phi_2897_ = _e1614;
                        } else {
                            phi_2897_ = _e1618;
                        }
                        let _e1621 = phi_2897_;
                        if (_e1607[2] < 0f) {
                            phi_2904_ = -(_e1607[2]);
                        } else {
                            phi_2904_ = _e1607[2];
                        }
                        let _e1625 = phi_2904_;
                        if (_e1621 > _e1625) {
                            phi_2909_ = _e1621;
                        } else {
                            phi_2909_ = _e1625;
                        }
                        let _e1628 = phi_2909_;
                        let _e1631 = local_2.member_2[1u];
                        if (_e1631[0] < 0f) {
                            phi_2923_ = -(_e1631[0]);
                        } else {
                            phi_2923_ = _e1631[0];
                        }
                        let _e1638 = phi_2923_;
                        if (_e1631[1] < 0f) {
                            phi_2930_ = -(_e1631[1]);
                        } else {
                            phi_2930_ = _e1631[1];
                        }
                        let _e1642 = phi_2930_;
                        if (_e1638 > _e1642) {
                            phi_2935_ = _e1638;
                        } else {
                            phi_2935_ = _e1642;
                        }
                        let _e1645 = phi_2935_;
                        if (_e1631[2] < 0f) {
                            phi_2942_ = -(_e1631[2]);
                        } else {
                            phi_2942_ = _e1631[2];
                        }
                        let _e1649 = phi_2942_;
                        if (_e1645 > _e1649) {
                            phi_2947_ = _e1645;
                        } else {
                            phi_2947_ = _e1649;
                        }
                        let _e1652 = phi_2947_;
                        if (_e1628 > _e1652) {
                            phi_2952_ = _e1628;
                        } else {
                            phi_2952_ = _e1652;
                        }
                        let _e1655 = phi_2952_;
                        let _e1657 = local_2.member_3;
                        let _e1661 = ((((_e1547 + _e1549) + (_e1601 + _e1603)) + (_e1655 + _e1657)) * 2f);
                        let _e1664 = local_2.member_3;
                        let _e1668 = (((_e815 * 1.0001f) + (_e1664 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                        let _e1671 = ((_e1429 * _e1408) - (_e1432 * _e1407));
                        let _e1674 = ((_e1432 * _e1406) - (_e1426 * _e1408));
                        let _e1677 = ((_e1426 * _e1407) - (_e1429 * _e1406));
                        let _e1682 = (((_e1671 * _e1435[0]) + (_e1674 * _e1435[1])) + (_e1677 * _e1435[2]));
                        let _e1687 = (((_e1671 * _e1452) + (_e1674 * _e1453)) + (_e1677 * _e1454));
                        let _e1692 = (((_e1671 * _e1462) + (_e1674 * _e1463)) + (_e1677 * _e1464));
                        let _e1700 = (((_e1671 * _e1461[0]) + (_e1674 * _e1461[1])) + (_e1677 * _e1461[2]));
                        let _e1705 = (((_e1671 * _e1467[0]) + (_e1674 * _e1467[1])) + (_e1677 * _e1467[2]));
                        let _e1710 = (((_e1671 * _e1484) + (_e1674 * _e1485)) + (_e1677 * _e1486));
                        let _e1715 = (((_e1671 * _e1494) + (_e1674 * _e1495)) + (_e1677 * _e1496));
                        let _e1723 = (((_e1671 * _e1493[0]) + (_e1674 * _e1493[1])) + (_e1677 * _e1493[2]));
                        if (_e1682 < _e1687) {
                            phi_3031_ = _e1682;
                        } else {
                            phi_3031_ = _e1687;
                        }
                        let _e1726 = phi_3031_;
                        if (_e1692 < _e1700) {
                            phi_3036_ = _e1692;
                        } else {
                            phi_3036_ = _e1700;
                        }
                        let _e1729 = phi_3036_;
                        if (_e1726 < _e1729) {
                            phi_3041_ = _e1726;
                        } else {
                            phi_3041_ = _e1729;
                        }
                        let _e1732 = phi_3041_;
                        if (_e1705 < _e1710) {
                            phi_3046_ = _e1705;
                        } else {
                            phi_3046_ = _e1710;
                        }
                        let _e1735 = phi_3046_;
                        if (_e1715 < _e1723) {
                            phi_3051_ = _e1715;
                        } else {
                            phi_3051_ = _e1723;
                        }
                        let _e1738 = phi_3051_;
                        if (_e1735 < _e1738) {
                            phi_3056_ = _e1735;
                        } else {
                            phi_3056_ = _e1738;
                        }
                        let _e1741 = phi_3056_;
                        if (_e1732 < _e1741) {
                            phi_3061_ = _e1732;
                        } else {
                            phi_3061_ = _e1741;
                        }
                        let _e1744 = phi_3061_;
                        if (_e1682 > _e1687) {
                            phi_3066_ = _e1682;
                        } else {
                            phi_3066_ = _e1687;
                        }
                        let _e1747 = phi_3066_;
                        if (_e1692 > _e1700) {
                            phi_3071_ = _e1692;
                        } else {
                            phi_3071_ = _e1700;
                        }
                        let _e1750 = phi_3071_;
                        if (_e1747 > _e1750) {
                            phi_3076_ = _e1747;
                        } else {
                            phi_3076_ = _e1750;
                        }
                        let _e1753 = phi_3076_;
                        if (_e1705 > _e1710) {
                            phi_3081_ = _e1705;
                        } else {
                            phi_3081_ = _e1710;
                        }
                        let _e1756 = phi_3081_;
                        if (_e1715 > _e1723) {
                            phi_3086_ = _e1715;
                        } else {
                            phi_3086_ = _e1723;
                        }
                        let _e1759 = phi_3086_;
                        if (_e1756 > _e1759) {
                            phi_3091_ = _e1756;
                        } else {
                            phi_3091_ = _e1759;
                        }
                        let _e1762 = phi_3091_;
                        if (_e1753 > _e1762) {
                            phi_3096_ = _e1753;
                        } else {
                            phi_3096_ = _e1762;
                        }
                        let _e1765 = phi_3096_;
                        if (_e1671 < 0f) {
                            phi_3102_ = -(_e1671);
                        } else {
                            phi_3102_ = _e1671;
                        }
                        let _e1769 = phi_3102_;
                        if (_e1674 < 0f) {
                            phi_3108_ = -(_e1674);
                        } else {
                            phi_3108_ = _e1674;
                        }
                        let _e1773 = phi_3108_;
                        if (_e1677 < 0f) {
                            phi_3115_ = -(_e1677);
                        } else {
                            phi_3115_ = _e1677;
                        }
                        let _e1778 = phi_3115_;
                        let _e1779 = ((_e1769 + _e1773) + _e1778);
                        let _e1784 = -(_e1765);
                        if (_e1744 > _e1784) {
                            phi_3126_ = _e1744;
                        } else {
                            phi_3126_ = _e1784;
                        }
                        let _e1787 = phi_3126_;
                        let _e1792 = (((_e1787 - ((_e1779 * _e1661) * (0.000000059604645f * (17f / 2f)))) - (_e1779 * _e1668)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        let _e1795 = ((_e1429 * _e1423) - (_e1432 * _e1422));
                        let _e1798 = ((_e1432 * _e1421) - (_e1426 * _e1423));
                        let _e1801 = ((_e1426 * _e1422) - (_e1429 * _e1421));
                        let _e1806 = (((_e1795 * _e1435[0]) + (_e1798 * _e1435[1])) + (_e1801 * _e1435[2]));
                        let _e1811 = (((_e1795 * _e1452) + (_e1798 * _e1453)) + (_e1801 * _e1454));
                        let _e1816 = (((_e1795 * _e1462) + (_e1798 * _e1463)) + (_e1801 * _e1464));
                        let _e1824 = (((_e1795 * _e1461[0]) + (_e1798 * _e1461[1])) + (_e1801 * _e1461[2]));
                        let _e1829 = (((_e1795 * _e1467[0]) + (_e1798 * _e1467[1])) + (_e1801 * _e1467[2]));
                        let _e1834 = (((_e1795 * _e1484) + (_e1798 * _e1485)) + (_e1801 * _e1486));
                        let _e1839 = (((_e1795 * _e1494) + (_e1798 * _e1495)) + (_e1801 * _e1496));
                        let _e1847 = (((_e1795 * _e1493[0]) + (_e1798 * _e1493[1])) + (_e1801 * _e1493[2]));
                        if (_e1806 < _e1811) {
                            phi_3197_ = _e1806;
                        } else {
                            phi_3197_ = _e1811;
                        }
                        let _e1850 = phi_3197_;
                        if (_e1816 < _e1824) {
                            phi_3202_ = _e1816;
                        } else {
                            phi_3202_ = _e1824;
                        }
                        let _e1853 = phi_3202_;
                        if (_e1850 < _e1853) {
                            phi_3207_ = _e1850;
                        } else {
                            phi_3207_ = _e1853;
                        }
                        let _e1856 = phi_3207_;
                        if (_e1829 < _e1834) {
                            phi_3212_ = _e1829;
                        } else {
                            phi_3212_ = _e1834;
                        }
                        let _e1859 = phi_3212_;
                        if (_e1839 < _e1847) {
                            phi_3217_ = _e1839;
                        } else {
                            phi_3217_ = _e1847;
                        }
                        let _e1862 = phi_3217_;
                        if (_e1859 < _e1862) {
                            phi_3222_ = _e1859;
                        } else {
                            phi_3222_ = _e1862;
                        }
                        let _e1865 = phi_3222_;
                        if (_e1856 < _e1865) {
                            phi_3227_ = _e1856;
                        } else {
                            phi_3227_ = _e1865;
                        }
                        let _e1868 = phi_3227_;
                        if (_e1806 > _e1811) {
                            phi_3232_ = _e1806;
                        } else {
                            phi_3232_ = _e1811;
                        }
                        let _e1871 = phi_3232_;
                        if (_e1816 > _e1824) {
                            phi_3237_ = _e1816;
                        } else {
                            phi_3237_ = _e1824;
                        }
                        let _e1874 = phi_3237_;
                        if (_e1871 > _e1874) {
                            phi_3242_ = _e1871;
                        } else {
                            phi_3242_ = _e1874;
                        }
                        let _e1877 = phi_3242_;
                        if (_e1829 > _e1834) {
                            phi_3247_ = _e1829;
                        } else {
                            phi_3247_ = _e1834;
                        }
                        let _e1880 = phi_3247_;
                        if (_e1839 > _e1847) {
                            phi_3252_ = _e1839;
                        } else {
                            phi_3252_ = _e1847;
                        }
                        let _e1883 = phi_3252_;
                        if (_e1880 > _e1883) {
                            phi_3257_ = _e1880;
                        } else {
                            phi_3257_ = _e1883;
                        }
                        let _e1886 = phi_3257_;
                        if (_e1877 > _e1886) {
                            phi_3262_ = _e1877;
                        } else {
                            phi_3262_ = _e1886;
                        }
                        let _e1889 = phi_3262_;
                        if (_e1795 < 0f) {
                            phi_3268_ = -(_e1795);
                        } else {
                            phi_3268_ = _e1795;
                        }
                        let _e1893 = phi_3268_;
                        if (_e1798 < 0f) {
                            phi_3274_ = -(_e1798);
                        } else {
                            phi_3274_ = _e1798;
                        }
                        let _e1897 = phi_3274_;
                        if (_e1801 < 0f) {
                            phi_3281_ = -(_e1801);
                        } else {
                            phi_3281_ = _e1801;
                        }
                        let _e1902 = phi_3281_;
                        let _e1903 = ((_e1893 + _e1897) + _e1902);
                        let _e1908 = -(_e1889);
                        if (_e1868 > _e1908) {
                            phi_3292_ = _e1868;
                        } else {
                            phi_3292_ = _e1908;
                        }
                        let _e1911 = phi_3292_;
                        let _e1916 = (((_e1911 - ((_e1903 * _e1661) * (0.000000059604645f * (17f / 2f)))) - (_e1903 * _e1668)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        if (_e1792 > _e1916) {
                            phi_3302_ = _e1792;
                        } else {
                            phi_3302_ = _e1916;
                        }
                        let _e1919 = phi_3302_;
                        if (_e179.member == 0u) {
                            let _e1921 = (_e1421 - _e1406);
                            let _e1922 = (_e1422 - _e1407);
                            let _e1923 = (_e1423 - _e1408);
                            let _e1926 = ((_e1429 * _e1923) - (_e1432 * _e1922));
                            let _e1929 = ((_e1432 * _e1921) - (_e1426 * _e1923));
                            let _e1932 = ((_e1426 * _e1922) - (_e1429 * _e1921));
                            let _e1937 = (((_e1926 * _e1435[0]) + (_e1929 * _e1435[1])) + (_e1932 * _e1435[2]));
                            let _e1942 = (((_e1926 * _e1452) + (_e1929 * _e1453)) + (_e1932 * _e1454));
                            let _e1947 = (((_e1926 * _e1462) + (_e1929 * _e1463)) + (_e1932 * _e1464));
                            let _e1955 = (((_e1926 * _e1461[0]) + (_e1929 * _e1461[1])) + (_e1932 * _e1461[2]));
                            let _e1960 = (((_e1926 * _e1467[0]) + (_e1929 * _e1467[1])) + (_e1932 * _e1467[2]));
                            let _e1965 = (((_e1926 * _e1484) + (_e1929 * _e1485)) + (_e1932 * _e1486));
                            let _e1970 = (((_e1926 * _e1494) + (_e1929 * _e1495)) + (_e1932 * _e1496));
                            let _e1978 = (((_e1926 * _e1493[0]) + (_e1929 * _e1493[1])) + (_e1932 * _e1493[2]));
                            if (_e1937 < _e1942) {
                                phi_3375_ = _e1937;
                            } else {
                                phi_3375_ = _e1942;
                            }
                            let _e1981 = phi_3375_;
                            if (_e1947 < _e1955) {
                                phi_3380_ = _e1947;
                            } else {
                                phi_3380_ = _e1955;
                            }
                            let _e1984 = phi_3380_;
                            if (_e1981 < _e1984) {
                                phi_3385_ = _e1981;
                            } else {
                                phi_3385_ = _e1984;
                            }
                            let _e1987 = phi_3385_;
                            if (_e1960 < _e1965) {
                                phi_3390_ = _e1960;
                            } else {
                                phi_3390_ = _e1965;
                            }
                            let _e1990 = phi_3390_;
                            if (_e1970 < _e1978) {
                                phi_3395_ = _e1970;
                            } else {
                                phi_3395_ = _e1978;
                            }
                            let _e1993 = phi_3395_;
                            if (_e1990 < _e1993) {
                                phi_3400_ = _e1990;
                            } else {
                                phi_3400_ = _e1993;
                            }
                            let _e1996 = phi_3400_;
                            if (_e1987 < _e1996) {
                                phi_3405_ = _e1987;
                            } else {
                                phi_3405_ = _e1996;
                            }
                            let _e1999 = phi_3405_;
                            if (_e1937 > _e1942) {
                                phi_3410_ = _e1937;
                            } else {
                                phi_3410_ = _e1942;
                            }
                            let _e2002 = phi_3410_;
                            if (_e1947 > _e1955) {
                                phi_3415_ = _e1947;
                            } else {
                                phi_3415_ = _e1955;
                            }
                            let _e2005 = phi_3415_;
                            if (_e2002 > _e2005) {
                                phi_3420_ = _e2002;
                            } else {
                                phi_3420_ = _e2005;
                            }
                            let _e2008 = phi_3420_;
                            if (_e1960 > _e1965) {
                                phi_3425_ = _e1960;
                            } else {
                                phi_3425_ = _e1965;
                            }
                            let _e2011 = phi_3425_;
                            if (_e1970 > _e1978) {
                                phi_3430_ = _e1970;
                            } else {
                                phi_3430_ = _e1978;
                            }
                            let _e2014 = phi_3430_;
                            if (_e2011 > _e2014) {
                                phi_3435_ = _e2011;
                            } else {
                                phi_3435_ = _e2014;
                            }
                            let _e2017 = phi_3435_;
                            if (_e2008 > _e2017) {
                                phi_3440_ = _e2008;
                            } else {
                                phi_3440_ = _e2017;
                            }
                            let _e2020 = phi_3440_;
                            if (_e1926 < 0f) {
                                phi_3446_ = -(_e1926);
                            } else {
                                phi_3446_ = _e1926;
                            }
                            let _e2024 = phi_3446_;
                            if (_e1929 < 0f) {
                                phi_3452_ = -(_e1929);
                            } else {
                                phi_3452_ = _e1929;
                            }
                            let _e2028 = phi_3452_;
                            if (_e1932 < 0f) {
                                phi_3459_ = -(_e1932);
                            } else {
                                phi_3459_ = _e1932;
                            }
                            let _e2033 = phi_3459_;
                            let _e2034 = ((_e2024 + _e2028) + _e2033);
                            let _e2039 = -(_e2020);
                            if (_e1999 > _e2039) {
                                phi_3470_ = _e1999;
                            } else {
                                phi_3470_ = _e2039;
                            }
                            let _e2042 = phi_3470_;
                            let _e2047 = (((_e2042 - ((_e2034 * _e1661) * (0.000000059604645f * (17f / 2f)))) - (_e2034 * _e1668)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e1919 > _e2047) {
                                phi_3480_ = _e1919;
                            } else {
                                phi_3480_ = _e2047;
                            }
                            let _e2050 = phi_3480_;
                            phi_3481_ = _e2050;
                        } else {
                            phi_3481_ = _e1919;
                        }
                        let _e2052 = phi_3481_;
                        phi_3484_ = (_e1393 || (_e2052 > 0f));
                    }
                    let _e2056 = phi_3484_;
                    if _e2056 {
                        phi_6901_ = _e2056;
                    } else {
                        let _e2059 = local_2.member[0u];
                        let _e2065 = local_2.member[1u];
                        let _e2072 = ((_e2059[0] + _e2065[0]) * 0.5f);
                        let _e2073 = ((_e2059[1] + _e2065[1]) * 0.5f);
                        let _e2074 = ((_e2059[2] + _e2065[2]) * 0.5f);
                        let _e2077 = local_2.member_1[0u];
                        let _e2083 = local_2.member_1[1u];
                        let _e2090 = ((_e2077[0] + _e2083[0]) * 0.5f);
                        let _e2091 = ((_e2077[1] + _e2083[1]) * 0.5f);
                        let _e2092 = ((_e2077[2] + _e2083[2]) * 0.5f);
                        let _e2095 = local_2.member_2[0u];
                        let _e2101 = local_2.member_2[1u];
                        let _e2108 = ((_e2095[0] + _e2101[0]) * 0.5f);
                        let _e2109 = ((_e2095[1] + _e2101[1]) * 0.5f);
                        let _e2110 = ((_e2095[2] + _e2101[2]) * 0.5f);
                        let _e2113 = local_2.member[0u];
                        let _e2116 = local_2.member_1[0u];
                        let _e2119 = local_2.member_2[0u];
                        let _e2121 = local_2.member_3;
                        let _e2124 = local_2.member[1u];
                        let _e2127 = local_2.member_1[1u];
                        let _e2130 = local_2.member_2[1u];
                        let _e2132 = local_2.member_3;
                        local = type_30(array<array<f32, 3>, 2>(_e2113, array<f32, 3>(_e2072, _e2073, _e2074)), array<array<f32, 3>, 2>(_e2116, array<f32, 3>(_e2090, _e2091, _e2092)), array<array<f32, 3>, 2>(_e2119, array<f32, 3>(_e2108, _e2109, _e2110)), _e2121);
                        local_1 = type_30(array<array<f32, 3>, 2>(array<f32, 3>(_e2072, _e2073, _e2074), _e2124), array<array<f32, 3>, 2>(array<f32, 3>(_e2090, _e2091, _e2092), _e2127), array<array<f32, 3>, 2>(array<f32, 3>(_e2108, _e2109, _e2110), _e2130), _e2132);
                        let _e2149 = local.member_1[0u];
                        let _e2155 = local.member_2[0u];
                        let _e2161 = ((_e2149[1] * _e2155[2]) - (_e2149[2] * _e2155[1]));
                        let _e2164 = ((_e2149[2] * _e2155[0]) - (_e2149[0] * _e2155[2]));
                        let _e2167 = ((_e2149[0] * _e2155[1]) - (_e2149[1] * _e2155[0]));
                        let _e2170 = local.member_1[1u];
                        let _e2176 = local.member_2[1u];
                        let _e2182 = ((_e2170[1] * _e2176[2]) - (_e2170[2] * _e2176[1]));
                        let _e2185 = ((_e2170[2] * _e2176[0]) - (_e2170[0] * _e2176[2]));
                        let _e2188 = ((_e2170[0] * _e2176[1]) - (_e2170[1] * _e2176[0]));
                        let _e2191 = local.member_1[0u];
                        let _e2197 = local.member_2[1u];
                        let _e2212 = local.member_1[1u];
                        let _e2218 = local.member_2[0u];
                        let _e2231 = (((_e2191[1] * _e2197[2]) - (_e2191[2] * _e2197[1])) + ((_e2212[1] * _e2218[2]) - (_e2212[2] * _e2218[1])));
                        let _e2232 = (((_e2191[2] * _e2197[0]) - (_e2191[0] * _e2197[2])) + ((_e2212[2] * _e2218[0]) - (_e2212[0] * _e2218[2])));
                        let _e2233 = (((_e2191[0] * _e2197[1]) - (_e2191[1] * _e2197[0])) + ((_e2212[0] * _e2218[1]) - (_e2212[1] * _e2218[0])));
                        let _e2236 = local.member[0u];
                        let _e2247 = local.member[1u];
                        let _e2258 = local.member[0u];
                        let _e2267 = ((((_e2247[0] * _e2161) + (_e2247[1] * _e2164)) + (_e2247[2] * _e2167)) + (((_e2258[0] * _e2231) + (_e2258[1] * _e2232)) + (_e2258[2] * _e2233)));
                        let _e2270 = local.member[0u];
                        let _e2281 = local.member[1u];
                        let _e2290 = ((((_e2270[0] * _e2182) + (_e2270[1] * _e2185)) + (_e2270[2] * _e2188)) + (((_e2281[0] * _e2231) + (_e2281[1] * _e2232)) + (_e2281[2] * _e2233)));
                        let _e2293 = local.member[1u];
                        let _e2304 = local.member[0u];
                        if (_e2304[0] < 0f) {
                            phi_3936_ = -(_e2304[0]);
                        } else {
                            phi_3936_ = _e2304[0];
                        }
                        let _e2311 = phi_3936_;
                        if (_e2304[1] < 0f) {
                            phi_3943_ = -(_e2304[1]);
                        } else {
                            phi_3943_ = _e2304[1];
                        }
                        let _e2315 = phi_3943_;
                        if (_e2311 > _e2315) {
                            phi_3948_ = _e2311;
                        } else {
                            phi_3948_ = _e2315;
                        }
                        let _e2318 = phi_3948_;
                        if (_e2304[2] < 0f) {
                            phi_3955_ = -(_e2304[2]);
                        } else {
                            phi_3955_ = _e2304[2];
                        }
                        let _e2322 = phi_3955_;
                        if (_e2318 > _e2322) {
                            phi_3960_ = _e2318;
                        } else {
                            phi_3960_ = _e2322;
                        }
                        let _e2325 = phi_3960_;
                        let _e2328 = local.member[1u];
                        if (_e2328[0] < 0f) {
                            phi_3973_ = -(_e2328[0]);
                        } else {
                            phi_3973_ = _e2328[0];
                        }
                        let _e2335 = phi_3973_;
                        if (_e2328[1] < 0f) {
                            phi_3980_ = -(_e2328[1]);
                        } else {
                            phi_3980_ = _e2328[1];
                        }
                        let _e2339 = phi_3980_;
                        if (_e2335 > _e2339) {
                            phi_3985_ = _e2335;
                        } else {
                            phi_3985_ = _e2339;
                        }
                        let _e2342 = phi_3985_;
                        if (_e2328[2] < 0f) {
                            phi_3992_ = -(_e2328[2]);
                        } else {
                            phi_3992_ = _e2328[2];
                        }
                        let _e2346 = phi_3992_;
                        if (_e2342 > _e2346) {
                            phi_3997_ = _e2342;
                        } else {
                            phi_3997_ = _e2346;
                        }
                        let _e2349 = phi_3997_;
                        if (_e2325 > _e2349) {
                            phi_4002_ = _e2325;
                        } else {
                            phi_4002_ = _e2349;
                        }
                        let _e2352 = phi_4002_;
                        let _e2354 = local.member_3;
                        let _e2355 = (_e2352 + _e2354);
                        let _e2358 = local.member_1[0u];
                        if (_e2358[0] < 0f) {
                            phi_4019_ = -(_e2358[0]);
                        } else {
                            phi_4019_ = _e2358[0];
                        }
                        let _e2365 = phi_4019_;
                        if (_e2358[1] < 0f) {
                            phi_4026_ = -(_e2358[1]);
                        } else {
                            phi_4026_ = _e2358[1];
                        }
                        let _e2369 = phi_4026_;
                        if (_e2365 > _e2369) {
                            phi_4031_ = _e2365;
                        } else {
                            phi_4031_ = _e2369;
                        }
                        let _e2372 = phi_4031_;
                        if (_e2358[2] < 0f) {
                            phi_4038_ = -(_e2358[2]);
                        } else {
                            phi_4038_ = _e2358[2];
                        }
                        let _e2376 = phi_4038_;
                        if (_e2372 > _e2376) {
                            phi_4043_ = _e2372;
                        } else {
                            phi_4043_ = _e2376;
                        }
                        let _e2379 = phi_4043_;
                        let _e2382 = local.member_1[1u];
                        if (_e2382[0] < 0f) {
                            phi_4057_ = -(_e2382[0]);
                        } else {
                            phi_4057_ = _e2382[0];
                        }
                        let _e2389 = phi_4057_;
                        if (_e2382[1] < 0f) {
                            phi_4064_ = -(_e2382[1]);
                        } else {
                            phi_4064_ = _e2382[1];
                        }
                        let _e2393 = phi_4064_;
                        if (_e2389 > _e2393) {
                            phi_4069_ = _e2389;
                        } else {
                            phi_4069_ = _e2393;
                        }
                        let _e2396 = phi_4069_;
                        if (_e2382[2] < 0f) {
                            phi_4076_ = -(_e2382[2]);
                        } else {
                            phi_4076_ = _e2382[2];
                        }
                        let _e2400 = phi_4076_;
                        if (_e2396 > _e2400) {
                            phi_4081_ = _e2396;
                        } else {
                            phi_4081_ = _e2400;
                        }
                        let _e2403 = phi_4081_;
                        if (_e2379 > _e2403) {
                            phi_4086_ = _e2379;
                        } else {
                            phi_4086_ = _e2403;
                        }
                        let _e2406 = phi_4086_;
                        let _e2408 = local.member_3;
                        let _e2409 = (_e2406 + _e2408);
                        let _e2412 = local.member_2[0u];
                        if (_e2412[0] < 0f) {
                            phi_4103_ = -(_e2412[0]);
                        } else {
                            phi_4103_ = _e2412[0];
                        }
                        let _e2419 = phi_4103_;
                        if (_e2412[1] < 0f) {
                            phi_4110_ = -(_e2412[1]);
                        } else {
                            phi_4110_ = _e2412[1];
                        }
                        let _e2423 = phi_4110_;
                        if (_e2419 > _e2423) {
                            phi_4115_ = _e2419;
                        } else {
                            phi_4115_ = _e2423;
                        }
                        let _e2426 = phi_4115_;
                        if (_e2412[2] < 0f) {
                            phi_4122_ = -(_e2412[2]);
                        } else {
                            phi_4122_ = _e2412[2];
                        }
                        let _e2430 = phi_4122_;
                        if (_e2426 > _e2430) {
                            phi_4127_ = _e2426;
                        } else {
                            phi_4127_ = _e2430;
                        }
                        let _e2433 = phi_4127_;
                        let _e2436 = local.member_2[1u];
                        if (_e2436[0] < 0f) {
                            phi_4141_ = -(_e2436[0]);
                        } else {
                            phi_4141_ = _e2436[0];
                        }
                        let _e2443 = phi_4141_;
                        if (_e2436[1] < 0f) {
                            phi_4148_ = -(_e2436[1]);
                        } else {
                            phi_4148_ = _e2436[1];
                        }
                        let _e2447 = phi_4148_;
                        if (_e2443 > _e2447) {
                            phi_4153_ = _e2443;
                        } else {
                            phi_4153_ = _e2447;
                        }
                        let _e2450 = phi_4153_;
                        if (_e2436[2] < 0f) {
                            phi_4160_ = -(_e2436[2]);
                        } else {
                            phi_4160_ = _e2436[2];
                        }
                        let _e2454 = phi_4160_;
                        if (_e2450 > _e2454) {
                            phi_4165_ = _e2450;
                        } else {
                            phi_4165_ = _e2454;
                        }
                        let _e2457 = phi_4165_;
                        if (_e2433 > _e2457) {
                            phi_4170_ = _e2433;
                        } else {
                            phi_4170_ = _e2457;
                        }
                        let _e2460 = phi_4170_;
                        let _e2462 = local.member_3;
                        let _e2463 = (_e2460 + _e2462);
                        let _e2465 = ((_e2409 * 8f) * _e2463);
                        let _e2472 = local.member_3;
                        if (_e2161 < 0f) {
                            phi_4201_ = -(_e2161);
                        } else {
                            phi_4201_ = _e2161;
                        }
                        let _e2489 = phi_4201_;
                        if (_e2164 < 0f) {
                            phi_4207_ = -(_e2164);
                        } else {
                            phi_4207_ = _e2164;
                        }
                        let _e2493 = phi_4207_;
                        if (_e2167 < 0f) {
                            phi_4214_ = -(_e2167);
                        } else {
                            phi_4214_ = _e2167;
                        }
                        let _e2498 = phi_4214_;
                        let _e2499 = ((_e2489 + _e2493) + _e2498);
                        if (_e2182 < 0f) {
                            phi_4221_ = -(_e2182);
                        } else {
                            phi_4221_ = _e2182;
                        }
                        let _e2503 = phi_4221_;
                        if (_e2185 < 0f) {
                            phi_4227_ = -(_e2185);
                        } else {
                            phi_4227_ = _e2185;
                        }
                        let _e2507 = phi_4227_;
                        if (_e2188 < 0f) {
                            phi_4234_ = -(_e2188);
                        } else {
                            phi_4234_ = _e2188;
                        }
                        let _e2512 = phi_4234_;
                        let _e2513 = ((_e2503 + _e2507) + _e2512);
                        if (_e2499 > _e2513) {
                            phi_4240_ = _e2499;
                        } else {
                            phi_4240_ = _e2513;
                        }
                        let _e2516 = phi_4240_;
                        if (_e2231 < 0f) {
                            phi_4246_ = -(_e2231);
                        } else {
                            phi_4246_ = _e2231;
                        }
                        let _e2520 = phi_4246_;
                        if (_e2232 < 0f) {
                            phi_4252_ = -(_e2232);
                        } else {
                            phi_4252_ = _e2232;
                        }
                        let _e2524 = phi_4252_;
                        if (_e2233 < 0f) {
                            phi_4259_ = -(_e2233);
                        } else {
                            phi_4259_ = _e2233;
                        }
                        let _e2529 = phi_4259_;
                        let _e2531 = (((_e2520 + _e2524) + _e2529) * 0.5f);
                        if (_e2516 > _e2531) {
                            phi_4266_ = _e2516;
                        } else {
                            phi_4266_ = _e2531;
                        }
                        let _e2534 = phi_4266_;
                        let _e2539 = local.member_3;
                        let _e2552 = ((((_e2236[0] * _e2161) + (_e2236[1] * _e2164)) + (_e2236[2] * _e2167)) * 3f);
                        let _e2553 = ((((_e2293[0] * _e2182) + (_e2293[1] * _e2185)) + (_e2293[2] * _e2188)) * 3f);
                        if (_e2552 < _e2553) {
                            phi_4290_ = _e2552;
                        } else {
                            phi_4290_ = _e2553;
                        }
                        let _e2556 = phi_4290_;
                        if (_e2267 < _e2290) {
                            phi_4295_ = _e2267;
                        } else {
                            phi_4295_ = _e2290;
                        }
                        let _e2559 = phi_4295_;
                        if (_e2556 < _e2559) {
                            phi_4300_ = _e2556;
                        } else {
                            phi_4300_ = _e2559;
                        }
                        let _e2562 = phi_4300_;
                        if (_e2552 > _e2553) {
                            phi_4305_ = _e2552;
                        } else {
                            phi_4305_ = _e2553;
                        }
                        let _e2565 = phi_4305_;
                        if (_e2267 > _e2290) {
                            phi_4310_ = _e2267;
                        } else {
                            phi_4310_ = _e2290;
                        }
                        let _e2568 = phi_4310_;
                        if (_e2565 > _e2568) {
                            phi_4315_ = _e2565;
                        } else {
                            phi_4315_ = _e2568;
                        }
                        let _e2571 = phi_4315_;
                        let _e2576 = -(_e2571);
                        if (_e2562 > _e2576) {
                            phi_4325_ = _e2562;
                        } else {
                            phi_4325_ = _e2576;
                        }
                        let _e2579 = phi_4325_;
                        let _e2581 = ((_e2579 - ((((((_e2355 * 8f) * _e2465) * (0.000000059604645f * (524f / 64f))) + ((_e2472 * 19f) * ((_e2355 * (_e2409 + _e2463)) + (_e2409 * _e2463)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2355) * ((1f + _e2409) * (1f + _e2463))))) + ((_e815 * (((_e2534 + (_e2465 * (0.000000059604645f * 8f))) + ((_e2539 * 6f) * (_e2409 + _e2463))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2409) * (1f + _e2463))))) * (3f * 1.0001f)))) > 0f);
                        if _e2581 {
                            phi_5294_ = _e2581;
                        } else {
                            let _e2584 = local.member_1[0u];
                            let _e2590 = local.member_1[1u];
                            let _e2594 = (_e2584[0] + _e2590[0]);
                            let _e2595 = (_e2584[1] + _e2590[1]);
                            let _e2596 = (_e2584[2] + _e2590[2]);
                            let _e2599 = local.member_2[0u];
                            let _e2605 = local.member_2[1u];
                            let _e2609 = (_e2599[0] + _e2605[0]);
                            let _e2610 = (_e2599[1] + _e2605[1]);
                            let _e2611 = (_e2599[2] + _e2605[2]);
                            let _e2614 = ((_e2595 * _e2611) - (_e2596 * _e2610));
                            let _e2617 = ((_e2596 * _e2609) - (_e2594 * _e2611));
                            let _e2620 = ((_e2594 * _e2610) - (_e2595 * _e2609));
                            let _e2623 = local.member[0u];
                            let _e2630 = local.member_1[0u];
                            let _e2636 = local.member_2[0u];
                            let _e2640 = (_e2623[0] - _e2630[0]);
                            let _e2641 = (_e2623[1] - _e2630[1]);
                            let _e2642 = (_e2623[2] - _e2630[2]);
                            if (_e179.member == 0u) {
                                phi_4441_ = array<f32, 3>(_e2623[0], _e2623[1], _e2623[2]);
                            } else {
                                phi_4441_ = array<f32, 3>((_e2640 - _e2636[0]), (_e2641 - _e2636[1]), (_e2642 - _e2636[2]));
                            }
                            let _e2649 = phi_4441_;
                            let _e2650 = (_e2623[0] - _e2636[0]);
                            let _e2651 = (_e2623[1] - _e2636[1]);
                            let _e2652 = (_e2623[2] - _e2636[2]);
                            let _e2655 = local.member[1u];
                            let _e2662 = local.member_1[1u];
                            let _e2668 = local.member_2[1u];
                            let _e2672 = (_e2655[0] - _e2662[0]);
                            let _e2673 = (_e2655[1] - _e2662[1]);
                            let _e2674 = (_e2655[2] - _e2662[2]);
                            if (_e179.member == 0u) {
                                phi_4506_ = array<f32, 3>(_e2655[0], _e2655[1], _e2655[2]);
                            } else {
                                phi_4506_ = array<f32, 3>((_e2672 - _e2668[0]), (_e2673 - _e2668[1]), (_e2674 - _e2668[2]));
                            }
                            let _e2681 = phi_4506_;
                            let _e2682 = (_e2655[0] - _e2668[0]);
                            let _e2683 = (_e2655[1] - _e2668[1]);
                            let _e2684 = (_e2655[2] - _e2668[2]);
                            let _e2687 = local.member[0u];
                            if (_e2687[0] < 0f) {
                                phi_4528_ = -(_e2687[0]);
                            } else {
                                phi_4528_ = _e2687[0];
                            }
                            let _e2694 = phi_4528_;
                            if (_e2687[1] < 0f) {
                                phi_4535_ = -(_e2687[1]);
                            } else {
                                phi_4535_ = _e2687[1];
                            }
                            let _e2698 = phi_4535_;
                            if (_e2694 > _e2698) {
                                phi_4540_ = _e2694;
                            } else {
                                phi_4540_ = _e2698;
                            }
                            let _e2701 = phi_4540_;
                            if (_e2687[2] < 0f) {
                                phi_4547_ = -(_e2687[2]);
                            } else {
                                phi_4547_ = _e2687[2];
                            }
                            let _e2705 = phi_4547_;
                            if (_e2701 > _e2705) {
                                phi_4552_ = _e2701;
                            } else {
                                phi_4552_ = _e2705;
                            }
                            let _e2708 = phi_4552_;
                            let _e2711 = local.member[1u];
                            if (_e2711[0] < 0f) {
                                phi_4565_ = -(_e2711[0]);
                            } else {
                                phi_4565_ = _e2711[0];
                            }
                            let _e2718 = phi_4565_;
                            if (_e2711[1] < 0f) {
                                phi_4572_ = -(_e2711[1]);
                            } else {
                                phi_4572_ = _e2711[1];
                            }
                            let _e2722 = phi_4572_;
                            if (_e2718 > _e2722) {
                                phi_4577_ = _e2718;
                            } else {
                                phi_4577_ = _e2722;
                            }
                            let _e2725 = phi_4577_;
                            if (_e2711[2] < 0f) {
                                phi_4584_ = -(_e2711[2]);
                            } else {
                                phi_4584_ = _e2711[2];
                            }
                            let _e2729 = phi_4584_;
                            if (_e2725 > _e2729) {
                                phi_4589_ = _e2725;
                            } else {
                                phi_4589_ = _e2729;
                            }
                            let _e2732 = phi_4589_;
                            if (_e2708 > _e2732) {
                                phi_4594_ = _e2708;
                            } else {
                                phi_4594_ = _e2732;
                            }
                            let _e2735 = phi_4594_;
                            let _e2737 = local.member_3;
                            let _e2741 = local.member_1[0u];
                            if (_e2741[0] < 0f) {
                                phi_4611_ = -(_e2741[0]);
                            } else {
                                phi_4611_ = _e2741[0];
                            }
                            let _e2748 = phi_4611_;
                            if (_e2741[1] < 0f) {
                                phi_4618_ = -(_e2741[1]);
                            } else {
                                phi_4618_ = _e2741[1];
                            }
                            let _e2752 = phi_4618_;
                            if (_e2748 > _e2752) {
                                phi_4623_ = _e2748;
                            } else {
                                phi_4623_ = _e2752;
                            }
                            let _e2755 = phi_4623_;
                            if (_e2741[2] < 0f) {
                                phi_4630_ = -(_e2741[2]);
                            } else {
                                phi_4630_ = _e2741[2];
                            }
                            let _e2759 = phi_4630_;
                            if (_e2755 > _e2759) {
                                phi_4635_ = _e2755;
                            } else {
                                phi_4635_ = _e2759;
                            }
                            let _e2762 = phi_4635_;
                            let _e2765 = local.member_1[1u];
                            if (_e2765[0] < 0f) {
                                phi_4649_ = -(_e2765[0]);
                            } else {
                                phi_4649_ = _e2765[0];
                            }
                            let _e2772 = phi_4649_;
                            if (_e2765[1] < 0f) {
                                phi_4656_ = -(_e2765[1]);
                            } else {
                                phi_4656_ = _e2765[1];
                            }
                            let _e2776 = phi_4656_;
                            if (_e2772 > _e2776) {
                                phi_4661_ = _e2772;
                            } else {
                                phi_4661_ = _e2776;
                            }
                            let _e2779 = phi_4661_;
                            if (_e2765[2] < 0f) {
                                phi_4668_ = -(_e2765[2]);
                            } else {
                                phi_4668_ = _e2765[2];
                            }
                            let _e2783 = phi_4668_;
                            if (_e2779 > _e2783) {
                                phi_4673_ = _e2779;
                            } else {
                                phi_4673_ = _e2783;
                            }
                            let _e2786 = phi_4673_;
                            if (_e2762 > _e2786) {
                                phi_4678_ = _e2762;
                            } else {
                                phi_4678_ = _e2786;
                            }
                            let _e2789 = phi_4678_;
                            let _e2791 = local.member_3;
                            let _e2795 = local.member_2[0u];
                            if (_e2795[0] < 0f) {
                                phi_4695_ = -(_e2795[0]);
                            } else {
                                phi_4695_ = _e2795[0];
                            }
                            let _e2802 = phi_4695_;
                            if (_e2795[1] < 0f) {
                                phi_4702_ = -(_e2795[1]);
                            } else {
                                phi_4702_ = _e2795[1];
                            }
                            let _e2806 = phi_4702_;
                            if (_e2802 > _e2806) {
                                phi_4707_ = _e2802;
                            } else {
                                phi_4707_ = _e2806;
                            }
                            let _e2809 = phi_4707_;
                            if (_e2795[2] < 0f) {
                                phi_4714_ = -(_e2795[2]);
                            } else {
                                phi_4714_ = _e2795[2];
                            }
                            let _e2813 = phi_4714_;
                            if (_e2809 > _e2813) {
                                phi_4719_ = _e2809;
                            } else {
                                phi_4719_ = _e2813;
                            }
                            let _e2816 = phi_4719_;
                            let _e2819 = local.member_2[1u];
                            if (_e2819[0] < 0f) {
                                phi_4733_ = -(_e2819[0]);
                            } else {
                                phi_4733_ = _e2819[0];
                            }
                            let _e2826 = phi_4733_;
                            if (_e2819[1] < 0f) {
                                phi_4740_ = -(_e2819[1]);
                            } else {
                                phi_4740_ = _e2819[1];
                            }
                            let _e2830 = phi_4740_;
                            if (_e2826 > _e2830) {
                                phi_4745_ = _e2826;
                            } else {
                                phi_4745_ = _e2830;
                            }
                            let _e2833 = phi_4745_;
                            if (_e2819[2] < 0f) {
                                phi_4752_ = -(_e2819[2]);
                            } else {
                                phi_4752_ = _e2819[2];
                            }
                            let _e2837 = phi_4752_;
                            if (_e2833 > _e2837) {
                                phi_4757_ = _e2833;
                            } else {
                                phi_4757_ = _e2837;
                            }
                            let _e2840 = phi_4757_;
                            if (_e2816 > _e2840) {
                                phi_4762_ = _e2816;
                            } else {
                                phi_4762_ = _e2840;
                            }
                            let _e2843 = phi_4762_;
                            let _e2845 = local.member_3;
                            let _e2849 = ((((_e2735 + _e2737) + (_e2789 + _e2791)) + (_e2843 + _e2845)) * 2f);
                            let _e2852 = local.member_3;
                            let _e2856 = (((_e815 * 1.0001f) + (_e2852 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e2859 = ((_e2617 * _e2596) - (_e2620 * _e2595));
                            let _e2862 = ((_e2620 * _e2594) - (_e2614 * _e2596));
                            let _e2865 = ((_e2614 * _e2595) - (_e2617 * _e2594));
                            let _e2870 = (((_e2859 * _e2623[0]) + (_e2862 * _e2623[1])) + (_e2865 * _e2623[2]));
                            let _e2875 = (((_e2859 * _e2640) + (_e2862 * _e2641)) + (_e2865 * _e2642));
                            let _e2880 = (((_e2859 * _e2650) + (_e2862 * _e2651)) + (_e2865 * _e2652));
                            let _e2888 = (((_e2859 * _e2649[0]) + (_e2862 * _e2649[1])) + (_e2865 * _e2649[2]));
                            let _e2893 = (((_e2859 * _e2655[0]) + (_e2862 * _e2655[1])) + (_e2865 * _e2655[2]));
                            let _e2898 = (((_e2859 * _e2672) + (_e2862 * _e2673)) + (_e2865 * _e2674));
                            let _e2903 = (((_e2859 * _e2682) + (_e2862 * _e2683)) + (_e2865 * _e2684));
                            let _e2911 = (((_e2859 * _e2681[0]) + (_e2862 * _e2681[1])) + (_e2865 * _e2681[2]));
                            if (_e2870 < _e2875) {
                                phi_4841_ = _e2870;
                            } else {
                                phi_4841_ = _e2875;
                            }
                            let _e2914 = phi_4841_;
                            if (_e2880 < _e2888) {
                                phi_4846_ = _e2880;
                            } else {
                                phi_4846_ = _e2888;
                            }
                            let _e2917 = phi_4846_;
                            if (_e2914 < _e2917) {
                                phi_4851_ = _e2914;
                            } else {
                                phi_4851_ = _e2917;
                            }
                            let _e2920 = phi_4851_;
                            if (_e2893 < _e2898) {
                                phi_4856_ = _e2893;
                            } else {
                                phi_4856_ = _e2898;
                            }
                            let _e2923 = phi_4856_;
                            if (_e2903 < _e2911) {
                                phi_4861_ = _e2903;
                            } else {
                                phi_4861_ = _e2911;
                            }
                            let _e2926 = phi_4861_;
                            if (_e2923 < _e2926) {
                                phi_4866_ = _e2923;
                            } else {
                                phi_4866_ = _e2926;
                            }
                            let _e2929 = phi_4866_;
                            if (_e2920 < _e2929) {
                                phi_4871_ = _e2920;
                            } else {
                                phi_4871_ = _e2929;
                            }
                            let _e2932 = phi_4871_;
                            if (_e2870 > _e2875) {
                                phi_4876_ = _e2870;
                            } else {
                                phi_4876_ = _e2875;
                            }
                            let _e2935 = phi_4876_;
                            if (_e2880 > _e2888) {
                                phi_4881_ = _e2880;
                            } else {
                                phi_4881_ = _e2888;
                            }
                            let _e2938 = phi_4881_;
                            if (_e2935 > _e2938) {
                                phi_4886_ = _e2935;
                            } else {
                                phi_4886_ = _e2938;
                            }
                            let _e2941 = phi_4886_;
                            if (_e2893 > _e2898) {
                                phi_4891_ = _e2893;
                            } else {
                                phi_4891_ = _e2898;
                            }
                            let _e2944 = phi_4891_;
                            if (_e2903 > _e2911) {
                                phi_4896_ = _e2903;
                            } else {
                                phi_4896_ = _e2911;
                            }
                            let _e2947 = phi_4896_;
                            if (_e2944 > _e2947) {
                                phi_4901_ = _e2944;
                            } else {
                                phi_4901_ = _e2947;
                            }
                            let _e2950 = phi_4901_;
                            if (_e2941 > _e2950) {
                                phi_4906_ = _e2941;
                            } else {
                                phi_4906_ = _e2950;
                            }
                            let _e2953 = phi_4906_;
                            if (_e2859 < 0f) {
                                phi_4912_ = -(_e2859);
                            } else {
                                phi_4912_ = _e2859;
                            }
                            let _e2957 = phi_4912_;
                            if (_e2862 < 0f) {
                                phi_4918_ = -(_e2862);
                            } else {
                                phi_4918_ = _e2862;
                            }
                            let _e2961 = phi_4918_;
                            if (_e2865 < 0f) {
                                phi_4925_ = -(_e2865);
                            } else {
                                phi_4925_ = _e2865;
                            }
                            let _e2966 = phi_4925_;
                            let _e2967 = ((_e2957 + _e2961) + _e2966);
                            let _e2972 = -(_e2953);
                            if (_e2932 > _e2972) {
                                phi_4936_ = _e2932;
                            } else {
                                phi_4936_ = _e2972;
                            }
                            let _e2975 = phi_4936_;
                            let _e2980 = (((_e2975 - ((_e2967 * _e2849) * (0.000000059604645f * (17f / 2f)))) - (_e2967 * _e2856)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2983 = ((_e2617 * _e2611) - (_e2620 * _e2610));
                            let _e2986 = ((_e2620 * _e2609) - (_e2614 * _e2611));
                            let _e2989 = ((_e2614 * _e2610) - (_e2617 * _e2609));
                            let _e2994 = (((_e2983 * _e2623[0]) + (_e2986 * _e2623[1])) + (_e2989 * _e2623[2]));
                            let _e2999 = (((_e2983 * _e2640) + (_e2986 * _e2641)) + (_e2989 * _e2642));
                            let _e3004 = (((_e2983 * _e2650) + (_e2986 * _e2651)) + (_e2989 * _e2652));
                            let _e3012 = (((_e2983 * _e2649[0]) + (_e2986 * _e2649[1])) + (_e2989 * _e2649[2]));
                            let _e3017 = (((_e2983 * _e2655[0]) + (_e2986 * _e2655[1])) + (_e2989 * _e2655[2]));
                            let _e3022 = (((_e2983 * _e2672) + (_e2986 * _e2673)) + (_e2989 * _e2674));
                            let _e3027 = (((_e2983 * _e2682) + (_e2986 * _e2683)) + (_e2989 * _e2684));
                            let _e3035 = (((_e2983 * _e2681[0]) + (_e2986 * _e2681[1])) + (_e2989 * _e2681[2]));
                            if (_e2994 < _e2999) {
                                phi_5007_ = _e2994;
                            } else {
                                phi_5007_ = _e2999;
                            }
                            let _e3038 = phi_5007_;
                            if (_e3004 < _e3012) {
                                phi_5012_ = _e3004;
                            } else {
                                phi_5012_ = _e3012;
                            }
                            let _e3041 = phi_5012_;
                            if (_e3038 < _e3041) {
                                phi_5017_ = _e3038;
                            } else {
                                phi_5017_ = _e3041;
                            }
                            let _e3044 = phi_5017_;
                            if (_e3017 < _e3022) {
                                phi_5022_ = _e3017;
                            } else {
                                phi_5022_ = _e3022;
                            }
                            let _e3047 = phi_5022_;
                            if (_e3027 < _e3035) {
                                phi_5027_ = _e3027;
                            } else {
                                phi_5027_ = _e3035;
                            }
                            let _e3050 = phi_5027_;
                            if (_e3047 < _e3050) {
                                phi_5032_ = _e3047;
                            } else {
                                phi_5032_ = _e3050;
                            }
                            let _e3053 = phi_5032_;
                            if (_e3044 < _e3053) {
                                phi_5037_ = _e3044;
                            } else {
                                phi_5037_ = _e3053;
                            }
                            let _e3056 = phi_5037_;
                            if (_e2994 > _e2999) {
                                phi_5042_ = _e2994;
                            } else {
                                phi_5042_ = _e2999;
                            }
                            let _e3059 = phi_5042_;
                            if (_e3004 > _e3012) {
                                phi_5047_ = _e3004;
                            } else {
                                phi_5047_ = _e3012;
                            }
                            let _e3062 = phi_5047_;
                            if (_e3059 > _e3062) {
                                phi_5052_ = _e3059;
                            } else {
                                phi_5052_ = _e3062;
                            }
                            let _e3065 = phi_5052_;
                            if (_e3017 > _e3022) {
                                phi_5057_ = _e3017;
                            } else {
                                phi_5057_ = _e3022;
                            }
                            let _e3068 = phi_5057_;
                            if (_e3027 > _e3035) {
                                phi_5062_ = _e3027;
                            } else {
                                phi_5062_ = _e3035;
                            }
                            let _e3071 = phi_5062_;
                            if (_e3068 > _e3071) {
                                phi_5067_ = _e3068;
                            } else {
                                phi_5067_ = _e3071;
                            }
                            let _e3074 = phi_5067_;
                            if (_e3065 > _e3074) {
                                phi_5072_ = _e3065;
                            } else {
                                phi_5072_ = _e3074;
                            }
                            let _e3077 = phi_5072_;
                            if (_e2983 < 0f) {
                                phi_5078_ = -(_e2983);
                            } else {
                                phi_5078_ = _e2983;
                            }
                            let _e3081 = phi_5078_;
                            if (_e2986 < 0f) {
                                phi_5084_ = -(_e2986);
                            } else {
                                phi_5084_ = _e2986;
                            }
                            let _e3085 = phi_5084_;
                            if (_e2989 < 0f) {
                                phi_5091_ = -(_e2989);
                            } else {
                                phi_5091_ = _e2989;
                            }
                            let _e3090 = phi_5091_;
                            let _e3091 = ((_e3081 + _e3085) + _e3090);
                            let _e3096 = -(_e3077);
                            if (_e3056 > _e3096) {
                                phi_5102_ = _e3056;
                            } else {
                                phi_5102_ = _e3096;
                            }
                            let _e3099 = phi_5102_;
                            let _e3104 = (((_e3099 - ((_e3091 * _e2849) * (0.000000059604645f * (17f / 2f)))) - (_e3091 * _e2856)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e2980 > _e3104) {
                                phi_5112_ = _e2980;
                            } else {
                                phi_5112_ = _e3104;
                            }
                            let _e3107 = phi_5112_;
                            if (_e179.member == 0u) {
                                let _e3109 = (_e2609 - _e2594);
                                let _e3110 = (_e2610 - _e2595);
                                let _e3111 = (_e2611 - _e2596);
                                let _e3114 = ((_e2617 * _e3111) - (_e2620 * _e3110));
                                let _e3117 = ((_e2620 * _e3109) - (_e2614 * _e3111));
                                let _e3120 = ((_e2614 * _e3110) - (_e2617 * _e3109));
                                let _e3125 = (((_e3114 * _e2623[0]) + (_e3117 * _e2623[1])) + (_e3120 * _e2623[2]));
                                let _e3130 = (((_e3114 * _e2640) + (_e3117 * _e2641)) + (_e3120 * _e2642));
                                let _e3135 = (((_e3114 * _e2650) + (_e3117 * _e2651)) + (_e3120 * _e2652));
                                let _e3143 = (((_e3114 * _e2649[0]) + (_e3117 * _e2649[1])) + (_e3120 * _e2649[2]));
                                let _e3148 = (((_e3114 * _e2655[0]) + (_e3117 * _e2655[1])) + (_e3120 * _e2655[2]));
                                let _e3153 = (((_e3114 * _e2672) + (_e3117 * _e2673)) + (_e3120 * _e2674));
                                let _e3158 = (((_e3114 * _e2682) + (_e3117 * _e2683)) + (_e3120 * _e2684));
                                let _e3166 = (((_e3114 * _e2681[0]) + (_e3117 * _e2681[1])) + (_e3120 * _e2681[2]));
                                if (_e3125 < _e3130) {
                                    phi_5185_ = _e3125;
                                } else {
                                    phi_5185_ = _e3130;
                                }
                                let _e3169 = phi_5185_;
                                if (_e3135 < _e3143) {
                                    phi_5190_ = _e3135;
                                } else {
                                    phi_5190_ = _e3143;
                                }
                                let _e3172 = phi_5190_;
                                if (_e3169 < _e3172) {
                                    phi_5195_ = _e3169;
                                } else {
                                    phi_5195_ = _e3172;
                                }
                                let _e3175 = phi_5195_;
                                if (_e3148 < _e3153) {
                                    phi_5200_ = _e3148;
                                } else {
                                    phi_5200_ = _e3153;
                                }
                                let _e3178 = phi_5200_;
                                if (_e3158 < _e3166) {
                                    phi_5205_ = _e3158;
                                } else {
                                    phi_5205_ = _e3166;
                                }
                                let _e3181 = phi_5205_;
                                if (_e3178 < _e3181) {
                                    phi_5210_ = _e3178;
                                } else {
                                    phi_5210_ = _e3181;
                                }
                                let _e3184 = phi_5210_;
                                if (_e3175 < _e3184) {
                                    phi_5215_ = _e3175;
                                } else {
                                    phi_5215_ = _e3184;
                                }
                                let _e3187 = phi_5215_;
                                if (_e3125 > _e3130) {
                                    phi_5220_ = _e3125;
                                } else {
                                    phi_5220_ = _e3130;
                                }
                                let _e3190 = phi_5220_;
                                if (_e3135 > _e3143) {
                                    phi_5225_ = _e3135;
                                } else {
                                    phi_5225_ = _e3143;
                                }
                                let _e3193 = phi_5225_;
                                if (_e3190 > _e3193) {
                                    phi_5230_ = _e3190;
                                } else {
                                    phi_5230_ = _e3193;
                                }
                                let _e3196 = phi_5230_;
                                if (_e3148 > _e3153) {
                                    phi_5235_ = _e3148;
                                } else {
                                    phi_5235_ = _e3153;
                                }
                                let _e3199 = phi_5235_;
                                if (_e3158 > _e3166) {
                                    phi_5240_ = _e3158;
                                } else {
                                    phi_5240_ = _e3166;
                                }
                                let _e3202 = phi_5240_;
                                if (_e3199 > _e3202) {
                                    phi_5245_ = _e3199;
                                } else {
                                    phi_5245_ = _e3202;
                                }
                                let _e3205 = phi_5245_;
                                if (_e3196 > _e3205) {
                                    phi_5250_ = _e3196;
                                } else {
                                    phi_5250_ = _e3205;
                                }
                                let _e3208 = phi_5250_;
                                if (_e3114 < 0f) {
                                    phi_5256_ = -(_e3114);
                                } else {
                                    phi_5256_ = _e3114;
                                }
                                let _e3212 = phi_5256_;
                                if (_e3117 < 0f) {
                                    phi_5262_ = -(_e3117);
                                } else {
                                    phi_5262_ = _e3117;
                                }
                                let _e3216 = phi_5262_;
                                if (_e3120 < 0f) {
                                    phi_5269_ = -(_e3120);
                                } else {
                                    phi_5269_ = _e3120;
                                }
                                let _e3221 = phi_5269_;
                                let _e3222 = ((_e3212 + _e3216) + _e3221);
                                let _e3227 = -(_e3208);
                                if (_e3187 > _e3227) {
                                    phi_5280_ = _e3187;
                                } else {
                                    phi_5280_ = _e3227;
                                }
                                let _e3230 = phi_5280_;
                                let _e3235 = (((_e3230 - ((_e3222 * _e2849) * (0.000000059604645f * (17f / 2f)))) - (_e3222 * _e2856)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3107 > _e3235) {
                                    phi_5290_ = _e3107;
                                } else {
                                    phi_5290_ = _e3235;
                                }
                                let _e3238 = phi_5290_;
                                phi_5291_ = _e3238;
                            } else {
                                phi_5291_ = _e3107;
                            }
                            let _e3240 = phi_5291_;
                            phi_5294_ = (_e2581 || (_e3240 > 0f));
                        }
                        let _e3244 = phi_5294_;
                        if _e3244 {
                            let _e3247 = local_1.member_1[0u];
                            let _e3253 = local_1.member_2[0u];
                            let _e3259 = ((_e3247[1] * _e3253[2]) - (_e3247[2] * _e3253[1]));
                            let _e3262 = ((_e3247[2] * _e3253[0]) - (_e3247[0] * _e3253[2]));
                            let _e3265 = ((_e3247[0] * _e3253[1]) - (_e3247[1] * _e3253[0]));
                            let _e3268 = local_1.member_1[1u];
                            let _e3274 = local_1.member_2[1u];
                            let _e3280 = ((_e3268[1] * _e3274[2]) - (_e3268[2] * _e3274[1]));
                            let _e3283 = ((_e3268[2] * _e3274[0]) - (_e3268[0] * _e3274[2]));
                            let _e3286 = ((_e3268[0] * _e3274[1]) - (_e3268[1] * _e3274[0]));
                            let _e3289 = local_1.member_1[0u];
                            let _e3295 = local_1.member_2[1u];
                            let _e3310 = local_1.member_1[1u];
                            let _e3316 = local_1.member_2[0u];
                            let _e3329 = (((_e3289[1] * _e3295[2]) - (_e3289[2] * _e3295[1])) + ((_e3310[1] * _e3316[2]) - (_e3310[2] * _e3316[1])));
                            let _e3330 = (((_e3289[2] * _e3295[0]) - (_e3289[0] * _e3295[2])) + ((_e3310[2] * _e3316[0]) - (_e3310[0] * _e3316[2])));
                            let _e3331 = (((_e3289[0] * _e3295[1]) - (_e3289[1] * _e3295[0])) + ((_e3310[0] * _e3316[1]) - (_e3310[1] * _e3316[0])));
                            let _e3334 = local_1.member[0u];
                            let _e3345 = local_1.member[1u];
                            let _e3356 = local_1.member[0u];
                            let _e3365 = ((((_e3345[0] * _e3259) + (_e3345[1] * _e3262)) + (_e3345[2] * _e3265)) + (((_e3356[0] * _e3329) + (_e3356[1] * _e3330)) + (_e3356[2] * _e3331)));
                            let _e3368 = local_1.member[0u];
                            let _e3379 = local_1.member[1u];
                            let _e3388 = ((((_e3368[0] * _e3280) + (_e3368[1] * _e3283)) + (_e3368[2] * _e3286)) + (((_e3379[0] * _e3329) + (_e3379[1] * _e3330)) + (_e3379[2] * _e3331)));
                            let _e3391 = local_1.member[1u];
                            let _e3402 = local_1.member[0u];
                            if (_e3402[0] < 0f) {
                                phi_5539_ = -(_e3402[0]);
                            } else {
                                phi_5539_ = _e3402[0];
                            }
                            let _e3409 = phi_5539_;
                            if (_e3402[1] < 0f) {
                                phi_5546_ = -(_e3402[1]);
                            } else {
                                phi_5546_ = _e3402[1];
                            }
                            let _e3413 = phi_5546_;
                            if (_e3409 > _e3413) {
                                phi_5551_ = _e3409;
                            } else {
                                phi_5551_ = _e3413;
                            }
                            let _e3416 = phi_5551_;
                            if (_e3402[2] < 0f) {
                                phi_5558_ = -(_e3402[2]);
                            } else {
                                phi_5558_ = _e3402[2];
                            }
                            let _e3420 = phi_5558_;
                            if (_e3416 > _e3420) {
                                phi_5563_ = _e3416;
                            } else {
                                phi_5563_ = _e3420;
                            }
                            let _e3423 = phi_5563_;
                            let _e3426 = local_1.member[1u];
                            if (_e3426[0] < 0f) {
                                phi_5576_ = -(_e3426[0]);
                            } else {
                                phi_5576_ = _e3426[0];
                            }
                            let _e3433 = phi_5576_;
                            if (_e3426[1] < 0f) {
                                phi_5583_ = -(_e3426[1]);
                            } else {
                                phi_5583_ = _e3426[1];
                            }
                            let _e3437 = phi_5583_;
                            if (_e3433 > _e3437) {
                                phi_5588_ = _e3433;
                            } else {
                                phi_5588_ = _e3437;
                            }
                            let _e3440 = phi_5588_;
                            if (_e3426[2] < 0f) {
                                phi_5595_ = -(_e3426[2]);
                            } else {
                                phi_5595_ = _e3426[2];
                            }
                            let _e3444 = phi_5595_;
                            if (_e3440 > _e3444) {
                                phi_5600_ = _e3440;
                            } else {
                                phi_5600_ = _e3444;
                            }
                            let _e3447 = phi_5600_;
                            if (_e3423 > _e3447) {
                                phi_5605_ = _e3423;
                            } else {
                                phi_5605_ = _e3447;
                            }
                            let _e3450 = phi_5605_;
                            let _e3452 = local_1.member_3;
                            let _e3453 = (_e3450 + _e3452);
                            let _e3456 = local_1.member_1[0u];
                            if (_e3456[0] < 0f) {
                                phi_5622_ = -(_e3456[0]);
                            } else {
                                phi_5622_ = _e3456[0];
                            }
                            let _e3463 = phi_5622_;
                            if (_e3456[1] < 0f) {
                                phi_5629_ = -(_e3456[1]);
                            } else {
                                phi_5629_ = _e3456[1];
                            }
                            let _e3467 = phi_5629_;
                            if (_e3463 > _e3467) {
                                phi_5634_ = _e3463;
                            } else {
                                phi_5634_ = _e3467;
                            }
                            let _e3470 = phi_5634_;
                            if (_e3456[2] < 0f) {
                                phi_5641_ = -(_e3456[2]);
                            } else {
                                phi_5641_ = _e3456[2];
                            }
                            let _e3474 = phi_5641_;
                            if (_e3470 > _e3474) {
                                phi_5646_ = _e3470;
                            } else {
                                phi_5646_ = _e3474;
                            }
                            let _e3477 = phi_5646_;
                            let _e3480 = local_1.member_1[1u];
                            if (_e3480[0] < 0f) {
                                phi_5660_ = -(_e3480[0]);
                            } else {
                                phi_5660_ = _e3480[0];
                            }
                            let _e3487 = phi_5660_;
                            if (_e3480[1] < 0f) {
                                phi_5667_ = -(_e3480[1]);
                            } else {
                                phi_5667_ = _e3480[1];
                            }
                            let _e3491 = phi_5667_;
                            if (_e3487 > _e3491) {
                                phi_5672_ = _e3487;
                            } else {
                                phi_5672_ = _e3491;
                            }
                            let _e3494 = phi_5672_;
                            if (_e3480[2] < 0f) {
                                phi_5679_ = -(_e3480[2]);
                            } else {
                                phi_5679_ = _e3480[2];
                            }
                            let _e3498 = phi_5679_;
                            if (_e3494 > _e3498) {
                                phi_5684_ = _e3494;
                            } else {
                                phi_5684_ = _e3498;
                            }
                            let _e3501 = phi_5684_;
                            if (_e3477 > _e3501) {
                                phi_5689_ = _e3477;
                            } else {
                                phi_5689_ = _e3501;
                            }
                            let _e3504 = phi_5689_;
                            let _e3506 = local_1.member_3;
                            let _e3507 = (_e3504 + _e3506);
                            let _e3510 = local_1.member_2[0u];
                            if (_e3510[0] < 0f) {
                                phi_5706_ = -(_e3510[0]);
                            } else {
                                phi_5706_ = _e3510[0];
                            }
                            let _e3517 = phi_5706_;
                            if (_e3510[1] < 0f) {
                                phi_5713_ = -(_e3510[1]);
                            } else {
                                phi_5713_ = _e3510[1];
                            }
                            let _e3521 = phi_5713_;
                            if (_e3517 > _e3521) {
                                phi_5718_ = _e3517;
                            } else {
                                phi_5718_ = _e3521;
                            }
                            let _e3524 = phi_5718_;
                            if (_e3510[2] < 0f) {
                                phi_5725_ = -(_e3510[2]);
                            } else {
                                phi_5725_ = _e3510[2];
                            }
                            let _e3528 = phi_5725_;
                            if (_e3524 > _e3528) {
                                phi_5730_ = _e3524;
                            } else {
                                phi_5730_ = _e3528;
                            }
                            let _e3531 = phi_5730_;
                            let _e3534 = local_1.member_2[1u];
                            if (_e3534[0] < 0f) {
                                phi_5744_ = -(_e3534[0]);
                            } else {
                                phi_5744_ = _e3534[0];
                            }
                            let _e3541 = phi_5744_;
                            if (_e3534[1] < 0f) {
                                phi_5751_ = -(_e3534[1]);
                            } else {
                                phi_5751_ = _e3534[1];
                            }
                            let _e3545 = phi_5751_;
                            if (_e3541 > _e3545) {
                                phi_5756_ = _e3541;
                            } else {
                                phi_5756_ = _e3545;
                            }
                            let _e3548 = phi_5756_;
                            if (_e3534[2] < 0f) {
                                phi_5763_ = -(_e3534[2]);
                            } else {
                                phi_5763_ = _e3534[2];
                            }
                            let _e3552 = phi_5763_;
                            if (_e3548 > _e3552) {
                                phi_5768_ = _e3548;
                            } else {
                                phi_5768_ = _e3552;
                            }
                            let _e3555 = phi_5768_;
                            if (_e3531 > _e3555) {
                                phi_5773_ = _e3531;
                            } else {
                                phi_5773_ = _e3555;
                            }
                            let _e3558 = phi_5773_;
                            let _e3560 = local_1.member_3;
                            let _e3561 = (_e3558 + _e3560);
                            let _e3563 = ((_e3507 * 8f) * _e3561);
                            let _e3570 = local_1.member_3;
                            if (_e3259 < 0f) {
                                phi_5804_ = -(_e3259);
                            } else {
                                phi_5804_ = _e3259;
                            }
                            let _e3587 = phi_5804_;
                            if (_e3262 < 0f) {
                                phi_5810_ = -(_e3262);
                            } else {
                                phi_5810_ = _e3262;
                            }
                            let _e3591 = phi_5810_;
                            if (_e3265 < 0f) {
                                phi_5817_ = -(_e3265);
                            } else {
                                phi_5817_ = _e3265;
                            }
                            let _e3596 = phi_5817_;
                            let _e3597 = ((_e3587 + _e3591) + _e3596);
                            if (_e3280 < 0f) {
                                phi_5824_ = -(_e3280);
                            } else {
                                phi_5824_ = _e3280;
                            }
                            let _e3601 = phi_5824_;
                            if (_e3283 < 0f) {
                                phi_5830_ = -(_e3283);
                            } else {
                                phi_5830_ = _e3283;
                            }
                            let _e3605 = phi_5830_;
                            if (_e3286 < 0f) {
                                phi_5837_ = -(_e3286);
                            } else {
                                phi_5837_ = _e3286;
                            }
                            let _e3610 = phi_5837_;
                            let _e3611 = ((_e3601 + _e3605) + _e3610);
                            if (_e3597 > _e3611) {
                                phi_5843_ = _e3597;
                            } else {
                                phi_5843_ = _e3611;
                            }
                            let _e3614 = phi_5843_;
                            if (_e3329 < 0f) {
                                phi_5849_ = -(_e3329);
                            } else {
                                phi_5849_ = _e3329;
                            }
                            let _e3618 = phi_5849_;
                            if (_e3330 < 0f) {
                                phi_5855_ = -(_e3330);
                            } else {
                                phi_5855_ = _e3330;
                            }
                            let _e3622 = phi_5855_;
                            if (_e3331 < 0f) {
                                phi_5862_ = -(_e3331);
                            } else {
                                phi_5862_ = _e3331;
                            }
                            let _e3627 = phi_5862_;
                            let _e3629 = (((_e3618 + _e3622) + _e3627) * 0.5f);
                            if (_e3614 > _e3629) {
                                phi_5869_ = _e3614;
                            } else {
                                phi_5869_ = _e3629;
                            }
                            let _e3632 = phi_5869_;
                            let _e3637 = local_1.member_3;
                            let _e3650 = ((((_e3334[0] * _e3259) + (_e3334[1] * _e3262)) + (_e3334[2] * _e3265)) * 3f);
                            let _e3651 = ((((_e3391[0] * _e3280) + (_e3391[1] * _e3283)) + (_e3391[2] * _e3286)) * 3f);
                            if (_e3650 < _e3651) {
                                phi_5893_ = _e3650;
                            } else {
                                phi_5893_ = _e3651;
                            }
                            let _e3654 = phi_5893_;
                            if (_e3365 < _e3388) {
                                phi_5898_ = _e3365;
                            } else {
                                phi_5898_ = _e3388;
                            }
                            let _e3657 = phi_5898_;
                            if (_e3654 < _e3657) {
                                phi_5903_ = _e3654;
                            } else {
                                phi_5903_ = _e3657;
                            }
                            let _e3660 = phi_5903_;
                            if (_e3650 > _e3651) {
                                phi_5908_ = _e3650;
                            } else {
                                phi_5908_ = _e3651;
                            }
                            let _e3663 = phi_5908_;
                            if (_e3365 > _e3388) {
                                phi_5913_ = _e3365;
                            } else {
                                phi_5913_ = _e3388;
                            }
                            let _e3666 = phi_5913_;
                            if (_e3663 > _e3666) {
                                phi_5918_ = _e3663;
                            } else {
                                phi_5918_ = _e3666;
                            }
                            let _e3669 = phi_5918_;
                            let _e3674 = -(_e3669);
                            if (_e3660 > _e3674) {
                                phi_5928_ = _e3660;
                            } else {
                                phi_5928_ = _e3674;
                            }
                            let _e3677 = phi_5928_;
                            let _e3679 = ((_e3677 - ((((((_e3453 * 8f) * _e3563) * (0.000000059604645f * (524f / 64f))) + ((_e3570 * 19f) * ((_e3453 * (_e3507 + _e3561)) + (_e3507 * _e3561)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3453) * ((1f + _e3507) * (1f + _e3561))))) + ((_e815 * (((_e3632 + (_e3563 * (0.000000059604645f * 8f))) + ((_e3637 * 6f) * (_e3507 + _e3561))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3507) * (1f + _e3561))))) * (3f * 1.0001f)))) > 0f);
                            if _e3679 {
                                phi_6897_ = _e3679;
                            } else {
                                let _e3682 = local_1.member_1[0u];
                                let _e3688 = local_1.member_1[1u];
                                let _e3692 = (_e3682[0] + _e3688[0]);
                                let _e3693 = (_e3682[1] + _e3688[1]);
                                let _e3694 = (_e3682[2] + _e3688[2]);
                                let _e3697 = local_1.member_2[0u];
                                let _e3703 = local_1.member_2[1u];
                                let _e3707 = (_e3697[0] + _e3703[0]);
                                let _e3708 = (_e3697[1] + _e3703[1]);
                                let _e3709 = (_e3697[2] + _e3703[2]);
                                let _e3712 = ((_e3693 * _e3709) - (_e3694 * _e3708));
                                let _e3715 = ((_e3694 * _e3707) - (_e3692 * _e3709));
                                let _e3718 = ((_e3692 * _e3708) - (_e3693 * _e3707));
                                let _e3721 = local_1.member[0u];
                                let _e3728 = local_1.member_1[0u];
                                let _e3734 = local_1.member_2[0u];
                                let _e3738 = (_e3721[0] - _e3728[0]);
                                let _e3739 = (_e3721[1] - _e3728[1]);
                                let _e3740 = (_e3721[2] - _e3728[2]);
                                if (_e179.member == 0u) {
                                    phi_6044_ = array<f32, 3>(_e3721[0], _e3721[1], _e3721[2]);
                                } else {
                                    phi_6044_ = array<f32, 3>((_e3738 - _e3734[0]), (_e3739 - _e3734[1]), (_e3740 - _e3734[2]));
                                }
                                let _e3747 = phi_6044_;
                                let _e3748 = (_e3721[0] - _e3734[0]);
                                let _e3749 = (_e3721[1] - _e3734[1]);
                                let _e3750 = (_e3721[2] - _e3734[2]);
                                let _e3753 = local_1.member[1u];
                                let _e3760 = local_1.member_1[1u];
                                let _e3766 = local_1.member_2[1u];
                                let _e3770 = (_e3753[0] - _e3760[0]);
                                let _e3771 = (_e3753[1] - _e3760[1]);
                                let _e3772 = (_e3753[2] - _e3760[2]);
                                if (_e179.member == 0u) {
                                    phi_6109_ = array<f32, 3>(_e3753[0], _e3753[1], _e3753[2]);
                                } else {
                                    phi_6109_ = array<f32, 3>((_e3770 - _e3766[0]), (_e3771 - _e3766[1]), (_e3772 - _e3766[2]));
                                }
                                let _e3779 = phi_6109_;
                                let _e3780 = (_e3753[0] - _e3766[0]);
                                let _e3781 = (_e3753[1] - _e3766[1]);
                                let _e3782 = (_e3753[2] - _e3766[2]);
                                let _e3785 = local_1.member[0u];
                                if (_e3785[0] < 0f) {
                                    phi_6131_ = -(_e3785[0]);
                                } else {
                                    phi_6131_ = _e3785[0];
                                }
                                let _e3792 = phi_6131_;
                                if (_e3785[1] < 0f) {
                                    phi_6138_ = -(_e3785[1]);
                                } else {
                                    phi_6138_ = _e3785[1];
                                }
                                let _e3796 = phi_6138_;
                                if (_e3792 > _e3796) {
                                    phi_6143_ = _e3792;
                                } else {
                                    phi_6143_ = _e3796;
                                }
                                let _e3799 = phi_6143_;
                                if (_e3785[2] < 0f) {
                                    phi_6150_ = -(_e3785[2]);
                                } else {
                                    phi_6150_ = _e3785[2];
                                }
                                let _e3803 = phi_6150_;
                                if (_e3799 > _e3803) {
                                    phi_6155_ = _e3799;
                                } else {
                                    phi_6155_ = _e3803;
                                }
                                let _e3806 = phi_6155_;
                                let _e3809 = local_1.member[1u];
                                if (_e3809[0] < 0f) {
                                    phi_6168_ = -(_e3809[0]);
                                } else {
                                    phi_6168_ = _e3809[0];
                                }
                                let _e3816 = phi_6168_;
                                if (_e3809[1] < 0f) {
                                    phi_6175_ = -(_e3809[1]);
                                } else {
                                    phi_6175_ = _e3809[1];
                                }
                                let _e3820 = phi_6175_;
                                if (_e3816 > _e3820) {
                                    phi_6180_ = _e3816;
                                } else {
                                    phi_6180_ = _e3820;
                                }
                                let _e3823 = phi_6180_;
                                if (_e3809[2] < 0f) {
                                    phi_6187_ = -(_e3809[2]);
                                } else {
                                    phi_6187_ = _e3809[2];
                                }
                                let _e3827 = phi_6187_;
                                if (_e3823 > _e3827) {
                                    phi_6192_ = _e3823;
                                } else {
                                    phi_6192_ = _e3827;
                                }
                                let _e3830 = phi_6192_;
                                if (_e3806 > _e3830) {
                                    phi_6197_ = _e3806;
                                } else {
                                    phi_6197_ = _e3830;
                                }
                                let _e3833 = phi_6197_;
                                let _e3835 = local_1.member_3;
                                let _e3839 = local_1.member_1[0u];
                                if (_e3839[0] < 0f) {
                                    phi_6214_ = -(_e3839[0]);
                                } else {
                                    phi_6214_ = _e3839[0];
                                }
                                let _e3846 = phi_6214_;
                                if (_e3839[1] < 0f) {
                                    phi_6221_ = -(_e3839[1]);
                                } else {
                                    phi_6221_ = _e3839[1];
                                }
                                let _e3850 = phi_6221_;
                                if (_e3846 > _e3850) {
                                    phi_6226_ = _e3846;
                                } else {
                                    phi_6226_ = _e3850;
                                }
                                let _e3853 = phi_6226_;
                                if (_e3839[2] < 0f) {
                                    phi_6233_ = -(_e3839[2]);
                                } else {
                                    phi_6233_ = _e3839[2];
                                }
                                let _e3857 = phi_6233_;
                                if (_e3853 > _e3857) {
                                    phi_6238_ = _e3853;
                                } else {
                                    phi_6238_ = _e3857;
                                }
                                let _e3860 = phi_6238_;
                                let _e3863 = local_1.member_1[1u];
                                if (_e3863[0] < 0f) {
                                    phi_6252_ = -(_e3863[0]);
                                } else {
                                    phi_6252_ = _e3863[0];
                                }
                                let _e3870 = phi_6252_;
                                if (_e3863[1] < 0f) {
                                    phi_6259_ = -(_e3863[1]);
                                } else {
                                    phi_6259_ = _e3863[1];
                                }
                                let _e3874 = phi_6259_;
                                if (_e3870 > _e3874) {
                                    phi_6264_ = _e3870;
                                } else {
                                    phi_6264_ = _e3874;
                                }
                                let _e3877 = phi_6264_;
                                if (_e3863[2] < 0f) {
                                    phi_6271_ = -(_e3863[2]);
                                } else {
                                    phi_6271_ = _e3863[2];
                                }
                                let _e3881 = phi_6271_;
                                if (_e3877 > _e3881) {
                                    phi_6276_ = _e3877;
                                } else {
                                    phi_6276_ = _e3881;
                                }
                                let _e3884 = phi_6276_;
                                if (_e3860 > _e3884) {
                                    phi_6281_ = _e3860;
                                } else {
                                    phi_6281_ = _e3884;
                                }
                                let _e3887 = phi_6281_;
                                let _e3889 = local_1.member_3;
                                let _e3893 = local_1.member_2[0u];
                                if (_e3893[0] < 0f) {
                                    phi_6298_ = -(_e3893[0]);
                                } else {
                                    phi_6298_ = _e3893[0];
                                }
                                let _e3900 = phi_6298_;
                                if (_e3893[1] < 0f) {
                                    phi_6305_ = -(_e3893[1]);
                                } else {
                                    phi_6305_ = _e3893[1];
                                }
                                let _e3904 = phi_6305_;
                                if (_e3900 > _e3904) {
                                    phi_6310_ = _e3900;
                                } else {
                                    phi_6310_ = _e3904;
                                }
                                let _e3907 = phi_6310_;
                                if (_e3893[2] < 0f) {
                                    phi_6317_ = -(_e3893[2]);
                                } else {
                                    phi_6317_ = _e3893[2];
                                }
                                let _e3911 = phi_6317_;
                                if (_e3907 > _e3911) {
                                    phi_6322_ = _e3907;
                                } else {
                                    phi_6322_ = _e3911;
                                }
                                let _e3914 = phi_6322_;
                                let _e3917 = local_1.member_2[1u];
                                if (_e3917[0] < 0f) {
                                    phi_6336_ = -(_e3917[0]);
                                } else {
                                    phi_6336_ = _e3917[0];
                                }
                                let _e3924 = phi_6336_;
                                if (_e3917[1] < 0f) {
                                    phi_6343_ = -(_e3917[1]);
                                } else {
                                    phi_6343_ = _e3917[1];
                                }
                                let _e3928 = phi_6343_;
                                if (_e3924 > _e3928) {
                                    phi_6348_ = _e3924;
                                } else {
                                    phi_6348_ = _e3928;
                                }
                                let _e3931 = phi_6348_;
                                if (_e3917[2] < 0f) {
                                    phi_6355_ = -(_e3917[2]);
                                } else {
                                    phi_6355_ = _e3917[2];
                                }
                                let _e3935 = phi_6355_;
                                if (_e3931 > _e3935) {
                                    phi_6360_ = _e3931;
                                } else {
                                    phi_6360_ = _e3935;
                                }
                                let _e3938 = phi_6360_;
                                if (_e3914 > _e3938) {
                                    phi_6365_ = _e3914;
                                } else {
                                    phi_6365_ = _e3938;
                                }
                                let _e3941 = phi_6365_;
                                let _e3943 = local_1.member_3;
                                let _e3947 = ((((_e3833 + _e3835) + (_e3887 + _e3889)) + (_e3941 + _e3943)) * 2f);
                                let _e3950 = local_1.member_3;
                                let _e3954 = (((_e815 * 1.0001f) + (_e3950 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e3957 = ((_e3715 * _e3694) - (_e3718 * _e3693));
                                let _e3960 = ((_e3718 * _e3692) - (_e3712 * _e3694));
                                let _e3963 = ((_e3712 * _e3693) - (_e3715 * _e3692));
                                let _e3968 = (((_e3957 * _e3721[0]) + (_e3960 * _e3721[1])) + (_e3963 * _e3721[2]));
                                let _e3973 = (((_e3957 * _e3738) + (_e3960 * _e3739)) + (_e3963 * _e3740));
                                let _e3978 = (((_e3957 * _e3748) + (_e3960 * _e3749)) + (_e3963 * _e3750));
                                let _e3986 = (((_e3957 * _e3747[0]) + (_e3960 * _e3747[1])) + (_e3963 * _e3747[2]));
                                let _e3991 = (((_e3957 * _e3753[0]) + (_e3960 * _e3753[1])) + (_e3963 * _e3753[2]));
                                let _e3996 = (((_e3957 * _e3770) + (_e3960 * _e3771)) + (_e3963 * _e3772));
                                let _e4001 = (((_e3957 * _e3780) + (_e3960 * _e3781)) + (_e3963 * _e3782));
                                let _e4009 = (((_e3957 * _e3779[0]) + (_e3960 * _e3779[1])) + (_e3963 * _e3779[2]));
                                if (_e3968 < _e3973) {
                                    phi_6444_ = _e3968;
                                } else {
                                    phi_6444_ = _e3973;
                                }
                                let _e4012 = phi_6444_;
                                if (_e3978 < _e3986) {
                                    phi_6449_ = _e3978;
                                } else {
                                    phi_6449_ = _e3986;
                                }
                                let _e4015 = phi_6449_;
                                if (_e4012 < _e4015) {
                                    phi_6454_ = _e4012;
                                } else {
                                    phi_6454_ = _e4015;
                                }
                                let _e4018 = phi_6454_;
                                if (_e3991 < _e3996) {
                                    phi_6459_ = _e3991;
                                } else {
                                    phi_6459_ = _e3996;
                                }
                                let _e4021 = phi_6459_;
                                if (_e4001 < _e4009) {
                                    phi_6464_ = _e4001;
                                } else {
                                    phi_6464_ = _e4009;
                                }
                                let _e4024 = phi_6464_;
                                if (_e4021 < _e4024) {
                                    phi_6469_ = _e4021;
                                } else {
                                    phi_6469_ = _e4024;
                                }
                                let _e4027 = phi_6469_;
                                if (_e4018 < _e4027) {
                                    phi_6474_ = _e4018;
                                } else {
                                    phi_6474_ = _e4027;
                                }
                                let _e4030 = phi_6474_;
                                if (_e3968 > _e3973) {
                                    phi_6479_ = _e3968;
                                } else {
                                    phi_6479_ = _e3973;
                                }
                                let _e4033 = phi_6479_;
                                if (_e3978 > _e3986) {
                                    phi_6484_ = _e3978;
                                } else {
                                    phi_6484_ = _e3986;
                                }
                                let _e4036 = phi_6484_;
                                if (_e4033 > _e4036) {
                                    phi_6489_ = _e4033;
                                } else {
                                    phi_6489_ = _e4036;
                                }
                                let _e4039 = phi_6489_;
                                if (_e3991 > _e3996) {
                                    phi_6494_ = _e3991;
                                } else {
                                    phi_6494_ = _e3996;
                                }
                                let _e4042 = phi_6494_;
                                if (_e4001 > _e4009) {
                                    phi_6499_ = _e4001;
                                } else {
                                    phi_6499_ = _e4009;
                                }
                                let _e4045 = phi_6499_;
                                if (_e4042 > _e4045) {
                                    phi_6504_ = _e4042;
                                } else {
                                    phi_6504_ = _e4045;
                                }
                                let _e4048 = phi_6504_;
                                if (_e4039 > _e4048) {
                                    phi_6509_ = _e4039;
                                } else {
                                    phi_6509_ = _e4048;
                                }
                                let _e4051 = phi_6509_;
                                if (_e3957 < 0f) {
                                    phi_6515_ = -(_e3957);
                                } else {
                                    phi_6515_ = _e3957;
                                }
                                let _e4055 = phi_6515_;
                                if (_e3960 < 0f) {
                                    phi_6521_ = -(_e3960);
                                } else {
                                    phi_6521_ = _e3960;
                                }
                                let _e4059 = phi_6521_;
                                if (_e3963 < 0f) {
                                    phi_6528_ = -(_e3963);
                                } else {
                                    phi_6528_ = _e3963;
                                }
                                let _e4064 = phi_6528_;
                                let _e4065 = ((_e4055 + _e4059) + _e4064);
                                let _e4070 = -(_e4051);
                                if (_e4030 > _e4070) {
                                    phi_6539_ = _e4030;
                                } else {
                                    phi_6539_ = _e4070;
                                }
                                let _e4073 = phi_6539_;
                                let _e4078 = (((_e4073 - ((_e4065 * _e3947) * (0.000000059604645f * (17f / 2f)))) - (_e4065 * _e3954)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e4081 = ((_e3715 * _e3709) - (_e3718 * _e3708));
                                let _e4084 = ((_e3718 * _e3707) - (_e3712 * _e3709));
                                let _e4087 = ((_e3712 * _e3708) - (_e3715 * _e3707));
                                let _e4092 = (((_e4081 * _e3721[0]) + (_e4084 * _e3721[1])) + (_e4087 * _e3721[2]));
                                let _e4097 = (((_e4081 * _e3738) + (_e4084 * _e3739)) + (_e4087 * _e3740));
                                let _e4102 = (((_e4081 * _e3748) + (_e4084 * _e3749)) + (_e4087 * _e3750));
                                let _e4110 = (((_e4081 * _e3747[0]) + (_e4084 * _e3747[1])) + (_e4087 * _e3747[2]));
                                let _e4115 = (((_e4081 * _e3753[0]) + (_e4084 * _e3753[1])) + (_e4087 * _e3753[2]));
                                let _e4120 = (((_e4081 * _e3770) + (_e4084 * _e3771)) + (_e4087 * _e3772));
                                let _e4125 = (((_e4081 * _e3780) + (_e4084 * _e3781)) + (_e4087 * _e3782));
                                let _e4133 = (((_e4081 * _e3779[0]) + (_e4084 * _e3779[1])) + (_e4087 * _e3779[2]));
                                if (_e4092 < _e4097) {
                                    phi_6610_ = _e4092;
                                } else {
                                    phi_6610_ = _e4097;
                                }
                                let _e4136 = phi_6610_;
                                if (_e4102 < _e4110) {
                                    phi_6615_ = _e4102;
                                } else {
                                    phi_6615_ = _e4110;
                                }
                                let _e4139 = phi_6615_;
                                if (_e4136 < _e4139) {
                                    phi_6620_ = _e4136;
                                } else {
                                    phi_6620_ = _e4139;
                                }
                                let _e4142 = phi_6620_;
                                if (_e4115 < _e4120) {
                                    phi_6625_ = _e4115;
                                } else {
                                    phi_6625_ = _e4120;
                                }
                                let _e4145 = phi_6625_;
                                if (_e4125 < _e4133) {
                                    phi_6630_ = _e4125;
                                } else {
                                    phi_6630_ = _e4133;
                                }
                                let _e4148 = phi_6630_;
                                if (_e4145 < _e4148) {
                                    phi_6635_ = _e4145;
                                } else {
                                    phi_6635_ = _e4148;
                                }
                                let _e4151 = phi_6635_;
                                if (_e4142 < _e4151) {
                                    phi_6640_ = _e4142;
                                } else {
                                    phi_6640_ = _e4151;
                                }
                                let _e4154 = phi_6640_;
                                if (_e4092 > _e4097) {
                                    phi_6645_ = _e4092;
                                } else {
                                    phi_6645_ = _e4097;
                                }
                                let _e4157 = phi_6645_;
                                if (_e4102 > _e4110) {
                                    phi_6650_ = _e4102;
                                } else {
                                    phi_6650_ = _e4110;
                                }
                                let _e4160 = phi_6650_;
                                if (_e4157 > _e4160) {
                                    phi_6655_ = _e4157;
                                } else {
                                    phi_6655_ = _e4160;
                                }
                                let _e4163 = phi_6655_;
                                if (_e4115 > _e4120) {
                                    phi_6660_ = _e4115;
                                } else {
                                    phi_6660_ = _e4120;
                                }
                                let _e4166 = phi_6660_;
                                if (_e4125 > _e4133) {
                                    phi_6665_ = _e4125;
                                } else {
                                    phi_6665_ = _e4133;
                                }
                                let _e4169 = phi_6665_;
                                if (_e4166 > _e4169) {
                                    phi_6670_ = _e4166;
                                } else {
                                    phi_6670_ = _e4169;
                                }
                                let _e4172 = phi_6670_;
                                if (_e4163 > _e4172) {
                                    phi_6675_ = _e4163;
                                } else {
                                    phi_6675_ = _e4172;
                                }
                                let _e4175 = phi_6675_;
                                if (_e4081 < 0f) {
                                    phi_6681_ = -(_e4081);
                                } else {
                                    phi_6681_ = _e4081;
                                }
                                let _e4179 = phi_6681_;
                                if (_e4084 < 0f) {
                                    phi_6687_ = -(_e4084);
                                } else {
                                    phi_6687_ = _e4084;
                                }
                                let _e4183 = phi_6687_;
                                if (_e4087 < 0f) {
                                    phi_6694_ = -(_e4087);
                                } else {
                                    phi_6694_ = _e4087;
                                }
                                let _e4188 = phi_6694_;
                                let _e4189 = ((_e4179 + _e4183) + _e4188);
                                let _e4194 = -(_e4175);
                                if (_e4154 > _e4194) {
                                    phi_6705_ = _e4154;
                                } else {
                                    phi_6705_ = _e4194;
                                }
                                let _e4197 = phi_6705_;
                                let _e4202 = (((_e4197 - ((_e4189 * _e3947) * (0.000000059604645f * (17f / 2f)))) - (_e4189 * _e3954)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e4078 > _e4202) {
                                    phi_6715_ = _e4078;
                                } else {
                                    phi_6715_ = _e4202;
                                }
                                let _e4205 = phi_6715_;
                                if (_e179.member == 0u) {
                                    let _e4207 = (_e3707 - _e3692);
                                    let _e4208 = (_e3708 - _e3693);
                                    let _e4209 = (_e3709 - _e3694);
                                    let _e4212 = ((_e3715 * _e4209) - (_e3718 * _e4208));
                                    let _e4215 = ((_e3718 * _e4207) - (_e3712 * _e4209));
                                    let _e4218 = ((_e3712 * _e4208) - (_e3715 * _e4207));
                                    let _e4223 = (((_e4212 * _e3721[0]) + (_e4215 * _e3721[1])) + (_e4218 * _e3721[2]));
                                    let _e4228 = (((_e4212 * _e3738) + (_e4215 * _e3739)) + (_e4218 * _e3740));
                                    let _e4233 = (((_e4212 * _e3748) + (_e4215 * _e3749)) + (_e4218 * _e3750));
                                    let _e4241 = (((_e4212 * _e3747[0]) + (_e4215 * _e3747[1])) + (_e4218 * _e3747[2]));
                                    let _e4246 = (((_e4212 * _e3753[0]) + (_e4215 * _e3753[1])) + (_e4218 * _e3753[2]));
                                    let _e4251 = (((_e4212 * _e3770) + (_e4215 * _e3771)) + (_e4218 * _e3772));
                                    let _e4256 = (((_e4212 * _e3780) + (_e4215 * _e3781)) + (_e4218 * _e3782));
                                    let _e4264 = (((_e4212 * _e3779[0]) + (_e4215 * _e3779[1])) + (_e4218 * _e3779[2]));
                                    if (_e4223 < _e4228) {
                                        phi_6788_ = _e4223;
                                    } else {
                                        phi_6788_ = _e4228;
                                    }
                                    let _e4267 = phi_6788_;
                                    if (_e4233 < _e4241) {
                                        phi_6793_ = _e4233;
                                    } else {
                                        phi_6793_ = _e4241;
                                    }
                                    let _e4270 = phi_6793_;
                                    if (_e4267 < _e4270) {
                                        phi_6798_ = _e4267;
                                    } else {
                                        phi_6798_ = _e4270;
                                    }
                                    let _e4273 = phi_6798_;
                                    if (_e4246 < _e4251) {
                                        phi_6803_ = _e4246;
                                    } else {
                                        phi_6803_ = _e4251;
                                    }
                                    let _e4276 = phi_6803_;
                                    if (_e4256 < _e4264) {
                                        phi_6808_ = _e4256;
                                    } else {
                                        phi_6808_ = _e4264;
                                    }
                                    let _e4279 = phi_6808_;
                                    if (_e4276 < _e4279) {
                                        phi_6813_ = _e4276;
                                    } else {
                                        phi_6813_ = _e4279;
                                    }
                                    let _e4282 = phi_6813_;
                                    if (_e4273 < _e4282) {
                                        phi_6818_ = _e4273;
                                    } else {
                                        phi_6818_ = _e4282;
                                    }
                                    let _e4285 = phi_6818_;
                                    if (_e4223 > _e4228) {
                                        phi_6823_ = _e4223;
                                    } else {
                                        phi_6823_ = _e4228;
                                    }
                                    let _e4288 = phi_6823_;
                                    if (_e4233 > _e4241) {
                                        phi_6828_ = _e4233;
                                    } else {
                                        phi_6828_ = _e4241;
                                    }
                                    let _e4291 = phi_6828_;
                                    if (_e4288 > _e4291) {
                                        phi_6833_ = _e4288;
                                    } else {
                                        phi_6833_ = _e4291;
                                    }
                                    let _e4294 = phi_6833_;
                                    if (_e4246 > _e4251) {
                                        phi_6838_ = _e4246;
                                    } else {
                                        phi_6838_ = _e4251;
                                    }
                                    let _e4297 = phi_6838_;
                                    if (_e4256 > _e4264) {
                                        phi_6843_ = _e4256;
                                    } else {
                                        phi_6843_ = _e4264;
                                    }
                                    let _e4300 = phi_6843_;
                                    if (_e4297 > _e4300) {
                                        phi_6848_ = _e4297;
                                    } else {
                                        phi_6848_ = _e4300;
                                    }
                                    let _e4303 = phi_6848_;
                                    if (_e4294 > _e4303) {
                                        phi_6853_ = _e4294;
                                    } else {
                                        phi_6853_ = _e4303;
                                    }
                                    let _e4306 = phi_6853_;
                                    if (_e4212 < 0f) {
                                        phi_6859_ = -(_e4212);
                                    } else {
                                        phi_6859_ = _e4212;
                                    }
                                    let _e4310 = phi_6859_;
                                    if (_e4215 < 0f) {
                                        phi_6865_ = -(_e4215);
                                    } else {
                                        phi_6865_ = _e4215;
                                    }
                                    let _e4314 = phi_6865_;
                                    if (_e4218 < 0f) {
                                        phi_6872_ = -(_e4218);
                                    } else {
                                        phi_6872_ = _e4218;
                                    }
                                    let _e4319 = phi_6872_;
                                    let _e4320 = ((_e4310 + _e4314) + _e4319);
                                    let _e4325 = -(_e4306);
                                    if (_e4285 > _e4325) {
                                        phi_6883_ = _e4285;
                                    } else {
                                        phi_6883_ = _e4325;
                                    }
                                    let _e4328 = phi_6883_;
                                    let _e4333 = (((_e4328 - ((_e4320 * _e3947) * (0.000000059604645f * (17f / 2f)))) - (_e4320 * _e3954)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4205 > _e4333) {
                                        phi_6893_ = _e4205;
                                    } else {
                                        phi_6893_ = _e4333;
                                    }
                                    let _e4336 = phi_6893_;
                                    phi_6894_ = _e4336;
                                } else {
                                    phi_6894_ = _e4205;
                                }
                                let _e4338 = phi_6894_;
                                phi_6897_ = (_e3679 || (_e4338 > 0f));
                            }
                            let _e4342 = phi_6897_;
                            phi_6899_ = (_e3244 && _e4342);
                        } else {
                            phi_6899_ = _e3244;
                        }
                        let _e4345 = phi_6899_;
                        phi_6901_ = (_e2056 || _e4345);
                    }
                    let _e4348 = phi_6901_;
                    let _e4349 = !(_e4348);
                    if _e4349 {
                        let _e4351 = atomicAdd((&counters[0u]), 1u);
                        phi_6908_ = _e4351;
                    } else {
                        phi_6908_ = 0u;
                    }
                    let _e4353 = phi_6908_;
                    phi_6909_ = _e4353;
                    phi_6910_ = _e4349;
                } else {
                    phi_6909_ = 0u;
                    phi_6910_ = false;
                }
                let _e4355 = phi_6909_;
                let _e4357 = phi_6910_;
                phi_6911_ = _e4355;
                phi_6912_ = _e4357;
                phi_6913_ = type_9(_e147, _e150);
            } else {
                phi_6911_ = 0u;
                phi_6912_ = false;
                phi_6913_ = type_9(0u, 0u);
            }
            let _e4359 = phi_6911_;
            let _e4361 = phi_6912_;
            let _e4363 = phi_6913_;
            workgroupBarrier();
            if (_e53 == 0u) {
                let _e4366 = atomicLoad((&counters[0u]));
                let _e4368 = atomicLoad((&counters[1u]));
                if (_e4366 > 0u) {
                    let _e4371 = atomicAdd((&output.member[0u]), _e4366);
                    if ((_e4371 + _e4366) < _e4371) {
                        let _e4375 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e4371);
                }
                if (_e4368 > 0u) {
                    let _e4379 = atomicAdd((&output.member[1u]), _e4368);
                    if ((_e4379 + _e4368) < _e4379) {
                        let _e4383 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e4361 {
                let _e4385 = params.member.member_1.member_3;
                let _e4387 = atomicLoad((&counters[2u]));
                let _e4388 = (_e4387 + _e4359);
                if (_e4388 < _e4385) {
                    let _e4392 = (2u * _e4388);
                    atomicStore((&output.member[(4u + _e4392)]), _e4363.member);
                    atomicStore((&output.member[(_e4392 + 5u)]), _e4363.member_1);
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
