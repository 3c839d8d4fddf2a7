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

struct type_15 {
    member: i32,
    member_1: i32,
}

struct type_16 {
    member: u32,
    member_1: i32,
}

struct type_18 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_22 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_25 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_31 {
    member: array<type_29>,
}

struct type_33 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_39 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_41 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_45 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(2) 
var<storage> leaves: type_27;
@group(0) @binding(1) 
var<storage> nodes: type_31;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_33, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_39;
@group(0) @binding(5) 
var<storage> paths: type_24;
@group(0) @binding(6) 
var<storage> input: type_11;
@group(0) @binding(7) 
var<storage, read_write> output: type_45;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_179_: bool;
    var phi_180_: bool;
    var phi_184_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_180_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_179_ = (param[0] > param_1[0]);
        } else {
            phi_179_ = false;
        }
        let _e14 = phi_179_;
        phi_180_ = _e14;
    }
    let _e16 = phi_180_;
    if _e16 {
        phi_184_ = param_1;
    } else {
        phi_184_ = param;
    }
    let _e18 = phi_184_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_203_: bool;
    var phi_204_: bool;
    var phi_208_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_204_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_203_ = (param_3[0] > param_2[0]);
        } else {
            phi_203_ = false;
        }
        let _e14 = phi_203_;
        phi_204_ = _e14;
    }
    let _e16 = phi_204_;
    if _e16 {
        phi_208_ = param_3;
    } else {
        phi_208_ = param_2;
    }
    let _e18 = phi_208_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_227_: bool;
    var phi_228_: bool;
    var phi_232_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_228_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_227_ = (param_4[0] > param_5[0]);
        } else {
            phi_227_ = false;
        }
        let _e14 = phi_227_;
        phi_228_ = _e14;
    }
    let _e16 = phi_228_;
    if _e16 {
        phi_232_ = param_5;
    } else {
        phi_232_ = param_4;
    }
    let _e18 = phi_232_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_256_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_252_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_251_ = (param_7[0] > param_6[0]);
        } else {
            phi_251_ = false;
        }
        let _e14 = phi_251_;
        phi_252_ = _e14;
    }
    let _e16 = phi_252_;
    if _e16 {
        phi_256_ = param_7;
    } else {
        phi_256_ = param_6;
    }
    let _e18 = phi_256_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_275_: bool;
    var phi_276_: bool;
    var phi_280_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_276_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_275_ = (param_8[0] > param_9[0]);
        } else {
            phi_275_ = false;
        }
        let _e14 = phi_275_;
        phi_276_ = _e14;
    }
    let _e16 = phi_276_;
    if _e16 {
        phi_280_ = param_9;
    } else {
        phi_280_ = param_8;
    }
    let _e18 = phi_280_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_304_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_300_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_299_ = (param_11[0] > param_10[0]);
        } else {
            phi_299_ = false;
        }
        let _e14 = phi_299_;
        phi_300_ = _e14;
    }
    let _e16 = phi_300_;
    if _e16 {
        phi_304_ = param_11;
    } else {
        phi_304_ = param_10;
    }
    let _e18 = phi_304_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_41;
    var local_1: type_41;
    var local_2: type_41;
    var phi_351_: u32;
    var phi_392_: u32;
    var phi_393_: u32;
    var phi_401_: u32;
    var phi_417_: u32;
    var phi_438_: u32;
    var phi_439_: u32;
    var phi_442_: type_9;
    var phi_443_: type_9;
    var phi_466_: type_9;
    var phi_507_: u32;
    var phi_508_: u32;
    var phi_516_: u32;
    var phi_528_: u32;
    var phi_613_: array<u32, 2>;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_822_: type_33;
    var phi_835_: type_9;
    var phi_838_: u32;
    var phi_836_: type_9;
    var phi_861_: type_9;
    var phi_951_: u32;
    var phi_953_: u32;
    var phi_839_: u32;
    var phi_956_: type_9;
    var phi_959_: u32;
    var phi_957_: type_9;
    var phi_982_: type_9;
    var phi_1076_: bool;
    var phi_1083_: bool;
    var phi_1091_: bool;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1167_: bool;
    var phi_1283_: bool;
    var phi_1284_: bool;
    var phi_1327_: type_15;
    var phi_1330_: u32;
    var phi_1332_: u32;
    var phi_1353_: bool;
    var phi_1359_: type_16;
    var phi_1328_: type_15;
    var phi_1373_: type_16;
    var phi_1441_: bool;
    var phi_1442_: bool;
    var phi_1443_: bool;
    var phi_1444_: bool;
    var phi_1448_: bool;
    var phi_1454_: u32;
    var phi_1455_: u32;
    var phi_1456_: u32;
    var phi_1457_: u32;
    var phi_1458_: bool;
    var phi_1331_: u32;
    var phi_1333_: u32;
    var phi_1459_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1507_: bool;
    var phi_1508_: bool;
    var phi_1509_: bool;
    var phi_1510_: bool;
    var phi_1514_: bool;
    var phi_1515_: bool;
    var phi_1519_: bool;
    var phi_1523_: bool;
    var phi_1524_: bool;
    var phi_1528_: bool;
    var phi_1529_: bool;
    var phi_1533_: bool;
    var phi_1534_: bool;
    var phi_1658_: bool;
    var phi_1659_: bool;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1847_: bool;
    var phi_1848_: bool;
    var phi_1941_: bool;
    var phi_1942_: bool;
    var phi_2037_: bool;
    var phi_2038_: bool;
    var phi_2131_: bool;
    var phi_2132_: bool;
    var phi_2136_: bool;
    var phi_2137_: bool;
    var phi_2138_: bool;
    var phi_2142_: bool;
    var phi_2143_: bool;
    var phi_2144_: bool;
    var phi_2145_: bool;
    var phi_2146_: bool;
    var phi_2150_: bool;
    var phi_2212_: u32;
    var phi_2213_: bool;
    var phi_960_: u32;
    var phi_2214_: bool;
    var phi_2221_: u32;
    var phi_2224_: type_9;
    var phi_2225_: type_9;
    var phi_2248_: type_9;
    var phi_2350_: bool;
    var phi_2357_: bool;
    var phi_2365_: bool;
    var phi_2388_: bool;
    var phi_2389_: bool;
    var phi_2433_: bool;
    var phi_2434_: bool;
    var phi_2441_: bool;
    var phi_2557_: bool;
    var phi_2558_: bool;
    var phi_2601_: type_15;
    var phi_2604_: u32;
    var phi_2606_: u32;
    var phi_2627_: bool;
    var phi_2633_: type_16;
    var phi_2602_: type_15;
    var phi_2647_: type_16;
    var phi_2715_: bool;
    var phi_2716_: bool;
    var phi_2717_: bool;
    var phi_2718_: bool;
    var phi_2722_: bool;
    var phi_2728_: u32;
    var phi_2729_: u32;
    var phi_2730_: u32;
    var phi_2731_: u32;
    var phi_2732_: bool;
    var phi_2605_: u32;
    var phi_2607_: u32;
    var phi_2733_: bool;
    var local_5: u32;
    var local_6: u32;
    var phi_2781_: bool;
    var phi_2782_: bool;
    var phi_2783_: bool;
    var phi_2784_: bool;
    var phi_2788_: bool;
    var phi_2789_: bool;
    var phi_2793_: bool;
    var phi_2797_: bool;
    var phi_2798_: bool;
    var phi_2802_: bool;
    var phi_2803_: bool;
    var phi_2807_: bool;
    var phi_2808_: bool;
    var phi_2932_: bool;
    var phi_2933_: bool;
    var phi_3026_: bool;
    var phi_3027_: bool;
    var phi_3121_: bool;
    var phi_3122_: bool;
    var phi_3215_: bool;
    var phi_3216_: bool;
    var phi_3311_: bool;
    var phi_3312_: bool;
    var phi_3405_: bool;
    var phi_3406_: bool;
    var phi_3410_: bool;
    var phi_3411_: bool;
    var phi_3412_: bool;
    var phi_3416_: bool;
    var phi_3417_: bool;
    var phi_3418_: bool;
    var phi_3419_: bool;
    var phi_3420_: bool;
    var phi_3424_: bool;
    var phi_3853_: f32;
    var phi_3860_: f32;
    var phi_3865_: f32;
    var phi_3872_: f32;
    var phi_3877_: f32;
    var phi_3890_: f32;
    var phi_3897_: f32;
    var phi_3902_: f32;
    var phi_3909_: f32;
    var phi_3914_: f32;
    var phi_3919_: f32;
    var phi_3936_: f32;
    var phi_3943_: f32;
    var phi_3948_: f32;
    var phi_3955_: f32;
    var phi_3960_: f32;
    var phi_3974_: f32;
    var phi_3981_: f32;
    var phi_3986_: f32;
    var phi_3993_: f32;
    var phi_3998_: f32;
    var phi_4003_: f32;
    var phi_4020_: f32;
    var phi_4027_: f32;
    var phi_4032_: f32;
    var phi_4039_: f32;
    var phi_4044_: f32;
    var phi_4058_: f32;
    var phi_4065_: f32;
    var phi_4070_: f32;
    var phi_4077_: f32;
    var phi_4082_: f32;
    var phi_4087_: f32;
    var phi_4118_: f32;
    var phi_4124_: f32;
    var phi_4131_: f32;
    var phi_4138_: f32;
    var phi_4144_: f32;
    var phi_4151_: f32;
    var phi_4157_: f32;
    var phi_4163_: f32;
    var phi_4169_: f32;
    var phi_4176_: f32;
    var phi_4183_: f32;
    var phi_4207_: f32;
    var phi_4212_: f32;
    var phi_4217_: f32;
    var phi_4222_: f32;
    var phi_4227_: f32;
    var phi_4232_: f32;
    var phi_4242_: f32;
    var phi_4445_: f32;
    var phi_4452_: f32;
    var phi_4457_: f32;
    var phi_4464_: f32;
    var phi_4469_: f32;
    var phi_4482_: f32;
    var phi_4489_: f32;
    var phi_4494_: f32;
    var phi_4501_: f32;
    var phi_4506_: f32;
    var phi_4511_: f32;
    var phi_4528_: f32;
    var phi_4535_: f32;
    var phi_4540_: f32;
    var phi_4547_: f32;
    var phi_4552_: f32;
    var phi_4566_: f32;
    var phi_4573_: f32;
    var phi_4578_: f32;
    var phi_4585_: f32;
    var phi_4590_: f32;
    var phi_4595_: f32;
    var phi_4612_: f32;
    var phi_4619_: f32;
    var phi_4624_: f32;
    var phi_4631_: f32;
    var phi_4636_: f32;
    var phi_4650_: f32;
    var phi_4657_: f32;
    var phi_4662_: f32;
    var phi_4669_: f32;
    var phi_4674_: f32;
    var phi_4679_: f32;
    var phi_4758_: f32;
    var phi_4763_: f32;
    var phi_4768_: f32;
    var phi_4773_: f32;
    var phi_4778_: f32;
    var phi_4783_: f32;
    var phi_4788_: f32;
    var phi_4793_: f32;
    var phi_4798_: f32;
    var phi_4803_: f32;
    var phi_4808_: f32;
    var phi_4813_: f32;
    var phi_4818_: f32;
    var phi_4823_: f32;
    var phi_4829_: f32;
    var phi_4835_: f32;
    var phi_4842_: f32;
    var phi_4853_: f32;
    var phi_4924_: f32;
    var phi_4929_: f32;
    var phi_4934_: f32;
    var phi_4939_: f32;
    var phi_4944_: f32;
    var phi_4949_: f32;
    var phi_4954_: f32;
    var phi_4959_: f32;
    var phi_4964_: f32;
    var phi_4969_: f32;
    var phi_4974_: f32;
    var phi_4979_: f32;
    var phi_4984_: f32;
    var phi_4989_: f32;
    var phi_4995_: f32;
    var phi_5001_: f32;
    var phi_5008_: f32;
    var phi_5019_: f32;
    var phi_5029_: f32;
    var phi_5102_: f32;
    var phi_5107_: f32;
    var phi_5112_: f32;
    var phi_5117_: f32;
    var phi_5122_: f32;
    var phi_5127_: f32;
    var phi_5132_: f32;
    var phi_5137_: f32;
    var phi_5142_: f32;
    var phi_5147_: f32;
    var phi_5152_: f32;
    var phi_5157_: f32;
    var phi_5162_: f32;
    var phi_5167_: f32;
    var phi_5173_: f32;
    var phi_5179_: f32;
    var phi_5186_: f32;
    var phi_5197_: f32;
    var phi_5207_: f32;
    var phi_5211_: bool;
    var phi_5663_: f32;
    var phi_5670_: f32;
    var phi_5675_: f32;
    var phi_5682_: f32;
    var phi_5687_: f32;
    var phi_5700_: f32;
    var phi_5707_: f32;
    var phi_5712_: f32;
    var phi_5719_: f32;
    var phi_5724_: f32;
    var phi_5729_: f32;
    var phi_5746_: f32;
    var phi_5753_: f32;
    var phi_5758_: f32;
    var phi_5765_: f32;
    var phi_5770_: f32;
    var phi_5784_: f32;
    var phi_5791_: f32;
    var phi_5796_: f32;
    var phi_5803_: f32;
    var phi_5808_: f32;
    var phi_5813_: f32;
    var phi_5830_: f32;
    var phi_5837_: f32;
    var phi_5842_: f32;
    var phi_5849_: f32;
    var phi_5854_: f32;
    var phi_5868_: f32;
    var phi_5875_: f32;
    var phi_5880_: f32;
    var phi_5887_: f32;
    var phi_5892_: f32;
    var phi_5897_: f32;
    var phi_5928_: f32;
    var phi_5934_: f32;
    var phi_5941_: f32;
    var phi_5948_: f32;
    var phi_5954_: f32;
    var phi_5961_: f32;
    var phi_5967_: f32;
    var phi_5973_: f32;
    var phi_5979_: f32;
    var phi_5986_: f32;
    var phi_5993_: f32;
    var phi_6017_: f32;
    var phi_6022_: f32;
    var phi_6027_: f32;
    var phi_6032_: f32;
    var phi_6037_: f32;
    var phi_6042_: f32;
    var phi_6052_: f32;
    var phi_6255_: f32;
    var phi_6262_: f32;
    var phi_6267_: f32;
    var phi_6274_: f32;
    var phi_6279_: f32;
    var phi_6292_: f32;
    var phi_6299_: f32;
    var phi_6304_: f32;
    var phi_6311_: f32;
    var phi_6316_: f32;
    var phi_6321_: f32;
    var phi_6338_: f32;
    var phi_6345_: f32;
    var phi_6350_: f32;
    var phi_6357_: f32;
    var phi_6362_: f32;
    var phi_6376_: f32;
    var phi_6383_: f32;
    var phi_6388_: f32;
    var phi_6395_: f32;
    var phi_6400_: f32;
    var phi_6405_: f32;
    var phi_6422_: f32;
    var phi_6429_: f32;
    var phi_6434_: f32;
    var phi_6441_: f32;
    var phi_6446_: f32;
    var phi_6460_: f32;
    var phi_6467_: f32;
    var phi_6472_: f32;
    var phi_6479_: f32;
    var phi_6484_: f32;
    var phi_6489_: f32;
    var phi_6568_: f32;
    var phi_6573_: f32;
    var phi_6578_: f32;
    var phi_6583_: f32;
    var phi_6588_: f32;
    var phi_6593_: f32;
    var phi_6598_: f32;
    var phi_6603_: f32;
    var phi_6608_: f32;
    var phi_6613_: f32;
    var phi_6618_: f32;
    var phi_6623_: f32;
    var phi_6628_: f32;
    var phi_6633_: f32;
    var phi_6639_: f32;
    var phi_6645_: f32;
    var phi_6652_: f32;
    var phi_6663_: f32;
    var phi_6734_: f32;
    var phi_6739_: f32;
    var phi_6744_: f32;
    var phi_6749_: f32;
    var phi_6754_: f32;
    var phi_6759_: f32;
    var phi_6764_: f32;
    var phi_6769_: f32;
    var phi_6774_: f32;
    var phi_6779_: f32;
    var phi_6784_: f32;
    var phi_6789_: f32;
    var phi_6794_: f32;
    var phi_6799_: f32;
    var phi_6805_: f32;
    var phi_6811_: f32;
    var phi_6818_: f32;
    var phi_6829_: f32;
    var phi_6839_: f32;
    var phi_6912_: f32;
    var phi_6917_: f32;
    var phi_6922_: f32;
    var phi_6927_: f32;
    var phi_6932_: f32;
    var phi_6937_: f32;
    var phi_6942_: f32;
    var phi_6947_: f32;
    var phi_6952_: f32;
    var phi_6957_: f32;
    var phi_6962_: f32;
    var phi_6967_: f32;
    var phi_6972_: f32;
    var phi_6977_: f32;
    var phi_6983_: f32;
    var phi_6989_: f32;
    var phi_6996_: f32;
    var phi_7007_: f32;
    var phi_7017_: f32;
    var phi_7021_: bool;
    var phi_7266_: f32;
    var phi_7273_: f32;
    var phi_7278_: f32;
    var phi_7285_: f32;
    var phi_7290_: f32;
    var phi_7303_: f32;
    var phi_7310_: f32;
    var phi_7315_: f32;
    var phi_7322_: f32;
    var phi_7327_: f32;
    var phi_7332_: f32;
    var phi_7349_: f32;
    var phi_7356_: f32;
    var phi_7361_: f32;
    var phi_7368_: f32;
    var phi_7373_: f32;
    var phi_7387_: f32;
    var phi_7394_: f32;
    var phi_7399_: f32;
    var phi_7406_: f32;
    var phi_7411_: f32;
    var phi_7416_: f32;
    var phi_7433_: f32;
    var phi_7440_: f32;
    var phi_7445_: f32;
    var phi_7452_: f32;
    var phi_7457_: f32;
    var phi_7471_: f32;
    var phi_7478_: f32;
    var phi_7483_: f32;
    var phi_7490_: f32;
    var phi_7495_: f32;
    var phi_7500_: f32;
    var phi_7531_: f32;
    var phi_7537_: f32;
    var phi_7544_: f32;
    var phi_7551_: f32;
    var phi_7557_: f32;
    var phi_7564_: f32;
    var phi_7570_: f32;
    var phi_7576_: f32;
    var phi_7582_: f32;
    var phi_7589_: f32;
    var phi_7596_: f32;
    var phi_7620_: f32;
    var phi_7625_: f32;
    var phi_7630_: f32;
    var phi_7635_: f32;
    var phi_7640_: f32;
    var phi_7645_: f32;
    var phi_7655_: f32;
    var phi_7858_: f32;
    var phi_7865_: f32;
    var phi_7870_: f32;
    var phi_7877_: f32;
    var phi_7882_: f32;
    var phi_7895_: f32;
    var phi_7902_: f32;
    var phi_7907_: f32;
    var phi_7914_: f32;
    var phi_7919_: f32;
    var phi_7924_: f32;
    var phi_7941_: f32;
    var phi_7948_: f32;
    var phi_7953_: f32;
    var phi_7960_: f32;
    var phi_7965_: f32;
    var phi_7979_: f32;
    var phi_7986_: f32;
    var phi_7991_: f32;
    var phi_7998_: f32;
    var phi_8003_: f32;
    var phi_8008_: f32;
    var phi_8025_: f32;
    var phi_8032_: f32;
    var phi_8037_: f32;
    var phi_8044_: f32;
    var phi_8049_: f32;
    var phi_8063_: f32;
    var phi_8070_: f32;
    var phi_8075_: f32;
    var phi_8082_: f32;
    var phi_8087_: f32;
    var phi_8092_: f32;
    var phi_8171_: f32;
    var phi_8176_: f32;
    var phi_8181_: f32;
    var phi_8186_: f32;
    var phi_8191_: f32;
    var phi_8196_: f32;
    var phi_8201_: f32;
    var phi_8206_: f32;
    var phi_8211_: f32;
    var phi_8216_: f32;
    var phi_8221_: f32;
    var phi_8226_: f32;
    var phi_8231_: f32;
    var phi_8236_: f32;
    var phi_8242_: f32;
    var phi_8248_: f32;
    var phi_8255_: f32;
    var phi_8266_: f32;
    var phi_8337_: f32;
    var phi_8342_: f32;
    var phi_8347_: f32;
    var phi_8352_: f32;
    var phi_8357_: f32;
    var phi_8362_: f32;
    var phi_8367_: f32;
    var phi_8372_: f32;
    var phi_8377_: f32;
    var phi_8382_: f32;
    var phi_8387_: f32;
    var phi_8392_: f32;
    var phi_8397_: f32;
    var phi_8402_: f32;
    var phi_8408_: f32;
    var phi_8414_: f32;
    var phi_8421_: f32;
    var phi_8432_: f32;
    var phi_8442_: f32;
    var phi_8515_: f32;
    var phi_8520_: f32;
    var phi_8525_: f32;
    var phi_8530_: f32;
    var phi_8535_: f32;
    var phi_8540_: f32;
    var phi_8545_: f32;
    var phi_8550_: f32;
    var phi_8555_: f32;
    var phi_8560_: f32;
    var phi_8565_: f32;
    var phi_8570_: f32;
    var phi_8575_: f32;
    var phi_8580_: f32;
    var phi_8586_: f32;
    var phi_8592_: f32;
    var phi_8599_: f32;
    var phi_8610_: f32;
    var phi_8620_: f32;
    var phi_8624_: bool;
    var phi_8626_: bool;
    var phi_8628_: bool;
    var phi_8639_: bool;
    var phi_8640_: bool;
    var phi_8690_: type_9;
    var phi_8691_: type_9;
    var phi_8714_: type_9;
    var phi_8737_: u32;
    var phi_8811_: bool;
    var phi_8812_: bool;
    var local_7: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e69 = id_2;
    let _e70 = n_2;
    let _e71 = lane_2;
    let _e84 = ((_e69.y * _e70.x) + _e69.x);
    let _e87 = (_e70.x * _e70.y);
    let _e90 = params.member.member_1.member_2;
    let _e92 = input.member[0u];
    if (_e90 < _e92) {
        phi_351_ = _e90;
    } else {
        phi_351_ = _e92;
    }
    let _e95 = phi_351_;
    let _e96 = (_e71 / 32u);
    let _e97 = (_e71 % 32u);
    let _e100 = params.member.member_1.member_1;
    if (_e95 > _e100) {
        let _e104 = params.member.member_1.member_1;
        let _e105 = (_e95 - _e104);
        let _e108 = params.member.member_2.member_3;
        if (_e108 == 0u) {
            return;
        }
        let _e110 = (_e105 / _e108);
        if (_e108 == 0u) {
            return;
        }
        if ((_e105 % _e108) > 0u) {
            phi_392_ = (_e110 + 1u);
        } else {
            phi_392_ = _e110;
        }
        let _e116 = phi_392_;
        phi_393_ = _e116;
    } else {
        phi_393_ = 0u;
    }
    let _e118 = phi_393_;
    let _e121 = params.member.member_2.member_4;
    if (_e121 < _e118) {
        phi_401_ = _e121;
    } else {
        phi_401_ = _e118;
    }
    let _e124 = phi_401_;
    let _e125 = (_e124 / 4u);
    if ((_e124 % 4u) > 0u) {
        phi_417_ = (_e125 + 1u);
    } else {
        phi_417_ = _e125;
    }
    let _e130 = phi_417_;
    if (_e130 > _e84) {
        let _e132 = (_e130 - _e84);
        if (_e87 == 0u) {
            return;
        }
        let _e134 = (_e132 / _e87);
        if (_e87 == 0u) {
            return;
        }
        if ((_e132 % _e87) > 0u) {
            phi_438_ = (_e134 + 1u);
        } else {
            phi_438_ = _e134;
        }
        let _e140 = phi_438_;
        phi_439_ = _e140;
    } else {
        phi_439_ = 0u;
    }
    let _e142 = phi_439_;
    phi_442_ = type_9(0u, _e142);
    loop {
        let _e145 = phi_442_;
        if (_e145.member < _e145.member_1) {
            phi_443_ = type_9((_e145.member + 1u), _e145.member_1);
            phi_466_ = type_9(1u, _e145.member);
        } else {
            phi_443_ = _e145;
            phi_466_ = type_9(0u, type_9().member_1);
        }
        let _e157 = phi_443_;
        let _e159 = phi_466_;
        let _e163 = (bitcast<i32>(_e159.member) != 0i);
        if _e163 {
            let _e167 = (((_e84 + (_e159.member_1 * _e87)) * 4u) + _e96);
            let _e170 = params.member.member_1.member_1;
            if (_e95 > _e170) {
                let _e174 = params.member.member_1.member_1;
                let _e175 = (_e95 - _e174);
                let _e178 = params.member.member_2.member_3;
                if (_e178 == 0u) {
                    return;
                }
                let _e180 = (_e175 / _e178);
                if (_e178 == 0u) {
                    return;
                }
                if ((_e175 % _e178) > 0u) {
                    phi_507_ = (_e180 + 1u);
                } else {
                    phi_507_ = _e180;
                }
                let _e186 = phi_507_;
                phi_508_ = _e186;
            } else {
                phi_508_ = 0u;
            }
            let _e188 = phi_508_;
            let _e191 = params.member.member_2.member_4;
            if (_e191 < _e188) {
                phi_516_ = _e191;
            } else {
                phi_516_ = _e188;
            }
            let _e194 = phi_516_;
            let _e195 = (_e167 < _e194);
            let _e198 = params.member.member_1.member_1;
            if _e195 {
                let _e201 = params.member.member_2.member_3;
                phi_528_ = (_e167 * _e201);
            } else {
                phi_528_ = 0u;
            }
            let _e204 = phi_528_;
            let _e206 = (2u * (_e198 + _e204));
            let _e209 = input.member[(4u + _e206)];
            let _e212 = input.member[(_e206 + 5u)];
            if (_e71 < 8u) {
                atomicStore((&counters[_e71]), 0u);
            }
            workgroupBarrier();
            let _e220 = params.member.member_2.member[0u][0u];
            let _e221 = (_e220 + (_e209 * 32u));
            let _e227 = params.member.member_2.member[0u][2u];
            let _e228 = (_e227 + (_e212 * 32u));
            if (_e97 == 0u) {
                firsts[(2u * _e96)] = _e221;
                firsts[((2u * _e96) + 1u)] = _e228;
            }
            let _e237 = params.member.member_2.member_1;
            if (_e237 == 0u) {
                phi_613_ = array<u32, 2>(0u, 2u);
            } else {
                phi_613_ = array<u32, 2>(1u, 1u);
            }
            let _e240 = phi_613_;
            let _e243 = (_e71 / 32u);
            let _e244 = (_e71 % 32u);
            let _e248 = params.member.member_2.member_2;
            let _e252 = params.member.member_2.member[_e248][_e240[0]];
            let _e255 = nodes.member[(_e252 + _e209)];
            let _e271 = params.member.member_2.member_2;
            let _e275 = params.member.member_2.member[_e271][_e240[1]];
            let _e278 = nodes.member[(_e275 + _e212)];
            let _e294 = params.member.member_2.member_2;
            let _e301 = params.member.member_2.member[(_e294 - 1u)][_e240[0]];
            let _e304 = nodes.member[(_e301 + ((_e209 * 32u) + _e244))];
            let _e323 = params.member.member_2.member_2;
            let _e330 = params.member.member_2.member[(_e323 - 1u)][_e240[1]];
            let _e333 = nodes.member[(_e330 + ((_e212 * 32u) + _e244))];
            if _e195 {
                if ((((((_e333.member.x <= _e255.member_1.y) && (_e255.member.x <= _e333.member_1.y)) && (_e333.member.y <= _e255.member_2.x)) && (_e255.member.y <= _e333.member_2.x)) && (_e333.member_1.x <= _e255.member_2.y)) && (_e255.member_1.x <= _e333.member_2.y)) {
                    let _e359 = atomicAdd((&counters[_e243]), 1u);
                    let _e360 = ((_e243 * 32u) + _e359);
                    columns[_e360] = type_33(array<f32, 3>(_e333.member.x, _e333.member.y, _e333.member_1.x), array<f32, 3>(_e333.member_1.y, _e333.member_2.x, _e333.member_2.y));
                    names[_e360] = _e244;
                }
            }
            workgroupBarrier();
            if _e195 {
                if ((((((_e304.member.x <= _e278.member_1.y) && (_e278.member.x <= _e304.member_1.y)) && (_e304.member.y <= _e278.member_2.x)) && (_e278.member.y <= _e304.member_2.x)) && (_e304.member_1.x <= _e278.member_2.y)) && (_e278.member_1.x <= _e304.member_2.y)) {
                    phi_817_ = false;
                } else {
                    phi_817_ = true;
                }
                let _e378 = phi_817_;
                phi_818_ = _e378;
            } else {
                phi_818_ = true;
            }
            let _e380 = phi_818_;
            if _e380 {
                phi_822_ = type_33(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_822_ = type_33(array<f32, 3>(_e304.member.x, _e304.member.y, _e304.member_1.x), array<f32, 3>(_e304.member_1.y, _e304.member_2.x, _e304.member_2.y));
            }
            let _e382 = phi_822_;
            let _e383 = (_e71 / 32u);
            let _e386 = atomicLoad((&counters[_e383]));
            phi_835_ = type_9(0u, _e386);
            phi_838_ = 0u;
            loop {
                let _e389 = phi_835_;
                let _e391 = phi_838_;
                local_7 = _e391;
                if (_e389.member < _e389.member_1) {
                    phi_836_ = type_9((_e389.member + 1u), _e389.member_1);
                    phi_861_ = type_9(1u, _e389.member);
                } else {
                    phi_836_ = _e389;
                    phi_861_ = type_9(0u, type_9().member_1);
                }
                let _e403 = phi_836_;
                let _e405 = phi_861_;
                let _e409 = (bitcast<i32>(_e405.member) != 0i);
                if _e409 {
                    let _e413 = names[((_e383 * 32u) + _e405.member_1)];
                    let _e417 = columns[((_e383 * 32u) + _e405.member_1)];
                    if ((((((_e382.member[0] <= _e417.member_1[0]) && (_e417.member[0] <= _e382.member_1[0])) && (_e382.member[1] <= _e417.member_1[1])) && (_e417.member[1] <= _e382.member_1[1])) && (_e382.member[2] <= _e417.member_1[2])) && (_e417.member[2] <= _e382.member_1[2])) {
                        let _e450 = atomicAdd((&counters[4u]), 1u);
                        if (_e450 < 2048u) {
                            hits[_e450] = (((_e383 << bitcast<u32>(10i)) | ((_e71 % 32u) << bitcast<u32>(5i))) | _e413);
                            phi_951_ = _e391;
                        } else {
                            phi_951_ = (_e391 | (1u << bitcast<u32>((_e405.member_1 & 31u))));
                        }
                        let _e464 = phi_951_;
                        phi_953_ = _e464;
                    } else {
                        phi_953_ = _e391;
                    }
                    let _e466 = phi_953_;
                    phi_839_ = _e466;
                } else {
                    phi_839_ = u32();
                }
                let _e468 = phi_839_;
                continue;
                continuing {
                    phi_835_ = _e403;
                    phi_838_ = _e468;
                    break if !(_e409);
                }
            }
            phi_956_ = type_9(0u, 32u);
            let _e5301 = local_7;
            phi_959_ = _e5301;
            loop {
                let _e471 = phi_956_;
                let _e473 = phi_959_;
                if (_e471.member < _e471.member_1) {
                    phi_957_ = type_9((_e471.member + 1u), _e471.member_1);
                    phi_982_ = type_9(1u, _e471.member);
                } else {
                    phi_957_ = _e471;
                    phi_982_ = type_9(0u, type_9().member_1);
                }
                let _e485 = phi_957_;
                let _e487 = phi_982_;
                if (bitcast<i32>(_e487.member) != 0i) {
                    if (_e473 == 0u) {
                        phi_2212_ = u32();
                        phi_2213_ = false;
                    } else {
                        let _e498 = names[((_e96 * 32u) + select(firstTrailingBit(_e473), 32u, (_e473 == 0u)))];
                        let _e501 = (_e221 + _e97);
                        let _e502 = (_e228 + _e498);
                        let _e504 = leaves.member[_e501];
                        let _e506 = leaves.member[_e502];
                        let _e508 = nodes.member[_e501];
                        let _e522 = nodes.member[_e502];
                        let _e537 = params.member.member.member_1;
                        if ((_e537 & 1u) != 0u) {
                            if (_e506.member[0] == _e504.member[0]) {
                                phi_1076_ = true;
                            } else {
                                phi_1076_ = (_e506.member[0] == _e504.member[0]);
                            }
                            let _e547 = phi_1076_;
                            if (_e506.member[1] == _e504.member[0]) {
                                phi_1083_ = true;
                            } else {
                                phi_1083_ = (_e506.member[1] == _e504.member[0]);
                            }
                            let _e552 = phi_1083_;
                            if (_e506.member[2] == _e504.member[0]) {
                                phi_1091_ = true;
                            } else {
                                phi_1091_ = (_e506.member[2] == _e504.member[0]);
                            }
                            let _e558 = phi_1091_;
                            if ((_e547 || _e552) || _e558) {
                                phi_1114_ = false;
                            } else {
                                phi_1114_ = true;
                            }
                            let _e561 = phi_1114_;
                            phi_1115_ = _e561;
                        } else {
                            phi_1115_ = true;
                        }
                        let _e563 = phi_1115_;
                        if _e563 {
                            let _e565 = params.member.member.member_1;
                            if ((_e565 & 2u) != 0u) {
                                let _e571 = bodies.member[_e504.member[0]];
                                let _e575 = bodies.member[_e506.member[0]];
                                if ((_e571 / 4u) != (_e575 / 4u)) {
                                    phi_1160_ = true;
                                } else {
                                    if ((_e571 & 2u) == 0u) {
                                        phi_1159_ = false;
                                    } else {
                                        phi_1159_ = true;
                                    }
                                    let _e582 = phi_1159_;
                                    phi_1160_ = _e582;
                                }
                                let _e584 = phi_1160_;
                                if _e584 {
                                    phi_1167_ = (((_e571 & _e575) & 1u) == 0u);
                                } else {
                                    phi_1167_ = false;
                                }
                                let _e589 = phi_1167_;
                                if _e589 {
                                    let _e591 = params.member.member.member_1;
                                    if ((_e591 & 4u) != 0u) {
                                        let _e596 = params.member.member.member[0u];
                                        let _e598 = bodies.member[_e596];
                                        let _e601 = bodies.member[(_e596 + 1u)];
                                        let _e606 = ((_e596 + 4u) + (2u * (_e571 >> bitcast<u32>(2i))));
                                        let _e611 = ((_e596 + 4u) + (2u * (_e575 >> bitcast<u32>(2i))));
                                        let _e613 = bodies.member[_e606];
                                        let _e615 = bodies.member[_e611];
                                        let _e624 = bodies.member[((((_e596 + 4u) + (2u * _e598)) + (_e613 * _e601)) + (_e615 / 32u))];
                                        let _e627 = bodies.member[(_e606 + 1u)];
                                        let _e630 = bodies.member[(_e611 + 1u)];
                                        if (_e627 == _e630) {
                                            if (((_e624 >> bitcast<u32>(((_e615 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_1283_ = true;
                                            } else {
                                                phi_1283_ = ((_e571 >> bitcast<u32>(2i)) == (_e575 >> bitcast<u32>(2i)));
                                            }
                                            let _e644 = phi_1283_;
                                            phi_1284_ = _e644;
                                        } else {
                                            phi_1284_ = false;
                                        }
                                        let _e646 = phi_1284_;
                                        if _e646 {
                                            let _e651 = bodies.member[(_e596 + 2u)];
                                            let _e654 = bodies.member[(_e596 + 3u)];
                                            let _e655 = (_e654 + _e596);
                                            phi_1327_ = type_15(0i, 32i);
                                            phi_1330_ = _e651;
                                            phi_1332_ = 0u;
                                            loop {
                                                let _e657 = phi_1327_;
                                                let _e659 = phi_1330_;
                                                let _e661 = phi_1332_;
                                                local_3 = _e661;
                                                local_4 = _e661;
                                                if (_e657.member < _e657.member_1) {
                                                    let _e668 = (_e657.member + 1i);
                                                    if ((false == (_e668 > _e657.member)) != false) {
                                                        phi_1353_ = true;
                                                    } else {
                                                        phi_1353_ = false;
                                                    }
                                                    let _e673 = phi_1353_;
                                                    if _e673 {
                                                        phi_1359_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_1359_ = type_16(1u, _e668);
                                                    }
                                                    let _e678 = phi_1359_;
                                                    phi_1328_ = type_15(_e678.member_1, _e657.member_1);
                                                    phi_1373_ = type_16(1u, _e657.member);
                                                } else {
                                                    phi_1328_ = _e657;
                                                    phi_1373_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e684 = phi_1328_;
                                                let _e686 = phi_1373_;
                                                if (bitcast<i32>(_e686.member) != 0i) {
                                                    if (_e661 >= _e659) {
                                                        phi_1456_ = u32();
                                                        phi_1457_ = u32();
                                                        phi_1458_ = false;
                                                    } else {
                                                        let _e693 = (_e661 + ((_e659 - _e661) / 2u));
                                                        let _e695 = (_e655 + (3u * _e693));
                                                        let _e697 = bodies.member[_e695];
                                                        let _e700 = bodies.member[(_e695 + 1u)];
                                                        let _e703 = bodies.member[(_e695 + 2u)];
                                                        if (_e697 == 0u) {
                                                            if (_e700 < _e504.member_1) {
                                                                phi_1443_ = false;
                                                            } else {
                                                                if (_e700 == _e504.member_1) {
                                                                    if (_e703 < _e506.member_1) {
                                                                        phi_1441_ = false;
                                                                    } else {
                                                                        phi_1441_ = true;
                                                                    }
                                                                    let _e709 = phi_1441_;
                                                                    phi_1442_ = _e709;
                                                                } else {
                                                                    phi_1442_ = true;
                                                                }
                                                                let _e711 = phi_1442_;
                                                                phi_1443_ = _e711;
                                                            }
                                                            let _e713 = phi_1443_;
                                                            phi_1444_ = _e713;
                                                        } else {
                                                            phi_1444_ = true;
                                                        }
                                                        let _e715 = phi_1444_;
                                                        if _e715 {
                                                            phi_1448_ = false;
                                                        } else {
                                                            phi_1448_ = true;
                                                        }
                                                        let _e717 = phi_1448_;
                                                        if _e717 {
                                                            phi_1454_ = _e659;
                                                            phi_1455_ = (_e693 + 1u);
                                                        } else {
                                                            phi_1454_ = _e693;
                                                            phi_1455_ = _e661;
                                                        }
                                                        let _e720 = phi_1454_;
                                                        let _e722 = phi_1455_;
                                                        phi_1456_ = _e720;
                                                        phi_1457_ = _e722;
                                                        phi_1458_ = true;
                                                    }
                                                    let _e724 = phi_1456_;
                                                    let _e726 = phi_1457_;
                                                    let _e728 = phi_1458_;
                                                    phi_1331_ = _e724;
                                                    phi_1333_ = _e726;
                                                    phi_1459_ = _e728;
                                                } else {
                                                    phi_1331_ = u32();
                                                    phi_1333_ = u32();
                                                    phi_1459_ = false;
                                                }
                                                let _e730 = phi_1331_;
                                                let _e732 = phi_1333_;
                                                let _e734 = phi_1459_;
                                                continue;
                                                continuing {
                                                    phi_1327_ = _e684;
                                                    phi_1330_ = _e730;
                                                    phi_1332_ = _e732;
                                                    break if !(_e734);
                                                }
                                            }
                                            let _e737 = local_3;
                                            if (_e737 < _e651) {
                                                let _e740 = local_4;
                                                let _e742 = (_e655 + (3u * _e740));
                                                let _e744 = bodies.member[_e742];
                                                if (_e744 == 0u) {
                                                    let _e748 = bodies.member[(_e742 + 1u)];
                                                    if (_e748 == _e504.member_1) {
                                                        let _e752 = bodies.member[(_e742 + 2u)];
                                                        phi_1507_ = (_e752 == _e506.member_1);
                                                        phi_1508_ = false;
                                                    } else {
                                                        phi_1507_ = bool();
                                                        phi_1508_ = true;
                                                    }
                                                    let _e755 = phi_1507_;
                                                    let _e757 = phi_1508_;
                                                    phi_1509_ = _e755;
                                                    phi_1510_ = _e757;
                                                } else {
                                                    phi_1509_ = bool();
                                                    phi_1510_ = true;
                                                }
                                                let _e759 = phi_1509_;
                                                let _e761 = phi_1510_;
                                                if _e761 {
                                                    phi_1514_ = false;
                                                } else {
                                                    phi_1514_ = _e759;
                                                }
                                                let _e763 = phi_1514_;
                                                phi_1515_ = _e763;
                                            } else {
                                                phi_1515_ = false;
                                            }
                                            let _e765 = phi_1515_;
                                            phi_1519_ = _e765;
                                        } else {
                                            phi_1519_ = true;
                                        }
                                        let _e767 = phi_1519_;
                                        if _e767 {
                                            phi_1523_ = false;
                                        } else {
                                            phi_1523_ = true;
                                        }
                                        let _e769 = phi_1523_;
                                        phi_1524_ = _e769;
                                    } else {
                                        phi_1524_ = true;
                                    }
                                    let _e771 = phi_1524_;
                                    if _e771 {
                                        phi_1528_ = false;
                                    } else {
                                        phi_1528_ = true;
                                    }
                                    let _e773 = phi_1528_;
                                    phi_1529_ = _e773;
                                } else {
                                    phi_1529_ = true;
                                }
                                let _e775 = phi_1529_;
                                if _e775 {
                                    phi_1533_ = false;
                                } else {
                                    phi_1533_ = true;
                                }
                                let _e777 = phi_1533_;
                                phi_1534_ = _e777;
                            } else {
                                phi_1534_ = true;
                            }
                            let _e779 = phi_1534_;
                            if _e779 {
                                let _e781 = params.member.member.member_1;
                                if ((_e781 & 32u) != 0u) {
                                    let _e785 = params.member.member.member_6;
                                    let _e802 = (((((_e508.member_1.y - _e522.member.x) > _e785) && ((_e522.member_1.y - _e508.member.x) > _e785)) && (((_e508.member_2.x - _e522.member.y) > _e785) && ((_e522.member_2.x - _e508.member.y) > _e785))) && (((_e508.member_2.y - _e522.member_1.x) > _e785) && ((_e522.member_2.y - _e508.member_1.x) > _e785)));
                                    if _e802 {
                                        phi_2136_ = bool();
                                    } else {
                                        let _e806 = keys.member[_e504.member[0]];
                                        let _e811 = keys.member[_e504.member[1]];
                                        let _e813 = function_(_e806[0], _e811[0]);
                                        let _e817 = keys.member[_e504.member[2]];
                                        let _e819 = function_(_e813, _e817[0]);
                                        let _e823 = keys.member[_e506.member[0]];
                                        let _e828 = keys.member[_e506.member[1]];
                                        let _e830 = function_1(_e823[3], _e828[3]);
                                        let _e834 = keys.member[_e506.member[2]];
                                        let _e836 = function_1(_e830, _e834[3]);
                                        if (_e819[1] > _e836[1]) {
                                            phi_1659_ = true;
                                        } else {
                                            if (_e819[1] == _e836[1]) {
                                                phi_1658_ = (_e819[0] > _e836[0]);
                                            } else {
                                                phi_1658_ = false;
                                            }
                                            let _e847 = phi_1658_;
                                            phi_1659_ = _e847;
                                        }
                                        let _e849 = phi_1659_;
                                        let _e854 = keys.member[_e506.member[0]];
                                        let _e859 = keys.member[_e506.member[1]];
                                        let _e861 = function_(_e854[0], _e859[0]);
                                        let _e865 = keys.member[_e506.member[2]];
                                        let _e867 = function_(_e861, _e865[0]);
                                        let _e871 = keys.member[_e504.member[0]];
                                        let _e876 = keys.member[_e504.member[1]];
                                        let _e878 = function_1(_e871[3], _e876[3]);
                                        let _e882 = keys.member[_e504.member[2]];
                                        let _e884 = function_1(_e878, _e882[3]);
                                        if (_e867[1] > _e884[1]) {
                                            phi_1753_ = true;
                                        } else {
                                            if (_e867[1] == _e884[1]) {
                                                phi_1752_ = (_e867[0] > _e884[0]);
                                            } else {
                                                phi_1752_ = false;
                                            }
                                            let _e895 = phi_1752_;
                                            phi_1753_ = _e895;
                                        }
                                        let _e897 = phi_1753_;
                                        let _e903 = keys.member[_e504.member[0]];
                                        let _e908 = keys.member[_e504.member[1]];
                                        let _e910 = function_2(_e903[1], _e908[1]);
                                        let _e914 = keys.member[_e504.member[2]];
                                        let _e916 = function_2(_e910, _e914[1]);
                                        let _e920 = keys.member[_e506.member[0]];
                                        let _e925 = keys.member[_e506.member[1]];
                                        let _e927 = function_3(_e920[4], _e925[4]);
                                        let _e931 = keys.member[_e506.member[2]];
                                        let _e933 = function_3(_e927, _e931[4]);
                                        if (_e916[1] > _e933[1]) {
                                            phi_1848_ = true;
                                        } else {
                                            if (_e916[1] == _e933[1]) {
                                                phi_1847_ = (_e916[0] > _e933[0]);
                                            } else {
                                                phi_1847_ = false;
                                            }
                                            let _e944 = phi_1847_;
                                            phi_1848_ = _e944;
                                        }
                                        let _e946 = phi_1848_;
                                        let _e951 = keys.member[_e506.member[0]];
                                        let _e956 = keys.member[_e506.member[1]];
                                        let _e958 = function_2(_e951[1], _e956[1]);
                                        let _e962 = keys.member[_e506.member[2]];
                                        let _e964 = function_2(_e958, _e962[1]);
                                        let _e968 = keys.member[_e504.member[0]];
                                        let _e973 = keys.member[_e504.member[1]];
                                        let _e975 = function_3(_e968[4], _e973[4]);
                                        let _e979 = keys.member[_e504.member[2]];
                                        let _e981 = function_3(_e975, _e979[4]);
                                        if (_e964[1] > _e981[1]) {
                                            phi_1942_ = true;
                                        } else {
                                            if (_e964[1] == _e981[1]) {
                                                phi_1941_ = (_e964[0] > _e981[0]);
                                            } else {
                                                phi_1941_ = false;
                                            }
                                            let _e992 = phi_1941_;
                                            phi_1942_ = _e992;
                                        }
                                        let _e994 = phi_1942_;
                                        let _e1001 = keys.member[_e504.member[0]];
                                        let _e1006 = keys.member[_e504.member[1]];
                                        let _e1008 = function_4(_e1001[2], _e1006[2]);
                                        let _e1012 = keys.member[_e504.member[2]];
                                        let _e1014 = function_4(_e1008, _e1012[2]);
                                        let _e1018 = keys.member[_e506.member[0]];
                                        let _e1023 = keys.member[_e506.member[1]];
                                        let _e1025 = function_5(_e1018[5], _e1023[5]);
                                        let _e1029 = keys.member[_e506.member[2]];
                                        let _e1031 = function_5(_e1025, _e1029[5]);
                                        if (_e1014[1] > _e1031[1]) {
                                            phi_2038_ = true;
                                        } else {
                                            if (_e1014[1] == _e1031[1]) {
                                                phi_2037_ = (_e1014[0] > _e1031[0]);
                                            } else {
                                                phi_2037_ = false;
                                            }
                                            let _e1042 = phi_2037_;
                                            phi_2038_ = _e1042;
                                        }
                                        let _e1044 = phi_2038_;
                                        let _e1049 = keys.member[_e506.member[0]];
                                        let _e1054 = keys.member[_e506.member[1]];
                                        let _e1056 = function_4(_e1049[2], _e1054[2]);
                                        let _e1060 = keys.member[_e506.member[2]];
                                        let _e1062 = function_4(_e1056, _e1060[2]);
                                        let _e1066 = keys.member[_e504.member[0]];
                                        let _e1071 = keys.member[_e504.member[1]];
                                        let _e1073 = function_5(_e1066[5], _e1071[5]);
                                        let _e1077 = keys.member[_e504.member[2]];
                                        let _e1079 = function_5(_e1073, _e1077[5]);
                                        if (_e1062[1] > _e1079[1]) {
                                            phi_2132_ = true;
                                        } else {
                                            if (_e1062[1] == _e1079[1]) {
                                                phi_2131_ = (_e1062[0] > _e1079[0]);
                                            } else {
                                                phi_2131_ = false;
                                            }
                                            let _e1090 = phi_2131_;
                                            phi_2132_ = _e1090;
                                        }
                                        let _e1092 = phi_2132_;
                                        phi_2136_ = (((!(_e849) && !(_e897)) && (!(_e946) && !(_e994))) && (!(_e1044) && !(_e1092)));
                                    }
                                    let _e1097 = phi_2136_;
                                    phi_2137_ = _e1097;
                                    phi_2138_ = _e802;
                                } else {
                                    phi_2137_ = bool();
                                    phi_2138_ = true;
                                }
                                let _e1099 = phi_2137_;
                                let _e1101 = phi_2138_;
                                if _e1101 {
                                    phi_2142_ = false;
                                } else {
                                    phi_2142_ = true;
                                }
                                let _e1103 = phi_2142_;
                                phi_2143_ = _e1099;
                                phi_2144_ = _e1103;
                            } else {
                                phi_2143_ = false;
                                phi_2144_ = true;
                            }
                            let _e1105 = phi_2143_;
                            let _e1107 = phi_2144_;
                            phi_2145_ = _e1105;
                            phi_2146_ = _e1107;
                        } else {
                            phi_2145_ = false;
                            phi_2146_ = true;
                        }
                        let _e1109 = phi_2145_;
                        let _e1111 = phi_2146_;
                        if _e1111 {
                            phi_2150_ = _e1109;
                        } else {
                            phi_2150_ = true;
                        }
                        let _e1113 = phi_2150_;
                        if _e1113 {
                            let _e1118 = params.member.member_1.member_3;
                            let _e1120 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1120 + 1u) < _e1120) {
                                let _e1124 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1120 < _e1118) {
                                let _e1126 = (2u * _e1120);
                                atomicStore((&output.member[(4u + _e1126)]), _e504.member_1);
                                atomicStore((&output.member[(_e1126 + 5u)]), _e506.member_1);
                            }
                            let _e1132 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1132 + 1u) < _e1132) {
                                let _e1136 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_2212_ = (_e473 & (_e473 - 1u));
                        phi_2213_ = true;
                    }
                    let _e1138 = phi_2212_;
                    let _e1140 = phi_2213_;
                    phi_960_ = _e1138;
                    phi_2214_ = _e1140;
                } else {
                    phi_960_ = u32();
                    phi_2214_ = false;
                }
                let _e1142 = phi_960_;
                let _e1144 = phi_2214_;
                continue;
                continuing {
                    phi_956_ = _e485;
                    phi_959_ = _e1142;
                    break if !(_e1144);
                }
            }
            workgroupBarrier();
            let _e1147 = atomicLoad((&counters[4u]));
            if (2048u < _e1147) {
                phi_2221_ = 2048u;
            } else {
                phi_2221_ = _e1147;
            }
            let _e1150 = phi_2221_;
            phi_2224_ = type_9(0u, 16u);
            loop {
                let _e1152 = phi_2224_;
                if (_e1152.member < _e1152.member_1) {
                    phi_2225_ = type_9((_e1152.member + 1u), _e1152.member_1);
                    phi_2248_ = type_9(1u, _e1152.member);
                } else {
                    phi_2225_ = _e1152;
                    phi_2248_ = type_9(0u, type_9().member_1);
                }
                let _e1164 = phi_2225_;
                let _e1166 = phi_2248_;
                if (bitcast<i32>(_e1166.member) != 0i) {
                    let _e1172 = (_e71 + (_e1166.member_1 * 128u));
                    if (_e1172 >= _e1150) {
                        phi_8639_ = false;
                    } else {
                        let _e1175 = hits[_e1172];
                        let _e1178 = ((_e1175 >> bitcast<u32>(10i)) & 3u);
                        let _e1185 = firsts[(2u * _e1178)];
                        let _e1186 = (_e1185 + ((_e1175 >> bitcast<u32>(5i)) & 31u));
                        let _e1190 = firsts[((2u * _e1178) + 1u)];
                        let _e1191 = (_e1190 + (_e1175 & 31u));
                        let _e1193 = leaves.member[_e1186];
                        let _e1195 = leaves.member[_e1191];
                        let _e1197 = nodes.member[_e1186];
                        let _e1211 = nodes.member[_e1191];
                        let _e1226 = params.member.member.member_1;
                        if ((_e1226 & 1u) != 0u) {
                            if (_e1195.member[0] == _e1193.member[0]) {
                                phi_2350_ = true;
                            } else {
                                phi_2350_ = (_e1195.member[0] == _e1193.member[0]);
                            }
                            let _e1236 = phi_2350_;
                            if (_e1195.member[1] == _e1193.member[0]) {
                                phi_2357_ = true;
                            } else {
                                phi_2357_ = (_e1195.member[1] == _e1193.member[0]);
                            }
                            let _e1241 = phi_2357_;
                            if (_e1195.member[2] == _e1193.member[0]) {
                                phi_2365_ = true;
                            } else {
                                phi_2365_ = (_e1195.member[2] == _e1193.member[0]);
                            }
                            let _e1247 = phi_2365_;
                            if ((_e1236 || _e1241) || _e1247) {
                                phi_2388_ = false;
                            } else {
                                phi_2388_ = true;
                            }
                            let _e1250 = phi_2388_;
                            phi_2389_ = _e1250;
                        } else {
                            phi_2389_ = true;
                        }
                        let _e1252 = phi_2389_;
                        if _e1252 {
                            let _e1254 = params.member.member.member_1;
                            if ((_e1254 & 2u) != 0u) {
                                let _e1260 = bodies.member[_e1193.member[0]];
                                let _e1264 = bodies.member[_e1195.member[0]];
                                if ((_e1260 / 4u) != (_e1264 / 4u)) {
                                    phi_2434_ = true;
                                } else {
                                    if ((_e1260 & 2u) == 0u) {
                                        phi_2433_ = false;
                                    } else {
                                        phi_2433_ = true;
                                    }
                                    let _e1271 = phi_2433_;
                                    phi_2434_ = _e1271;
                                }
                                let _e1273 = phi_2434_;
                                if _e1273 {
                                    phi_2441_ = (((_e1260 & _e1264) & 1u) == 0u);
                                } else {
                                    phi_2441_ = false;
                                }
                                let _e1278 = phi_2441_;
                                if _e1278 {
                                    let _e1280 = params.member.member.member_1;
                                    if ((_e1280 & 4u) != 0u) {
                                        let _e1285 = params.member.member.member[0u];
                                        let _e1287 = bodies.member[_e1285];
                                        let _e1290 = bodies.member[(_e1285 + 1u)];
                                        let _e1295 = ((_e1285 + 4u) + (2u * (_e1260 >> bitcast<u32>(2i))));
                                        let _e1300 = ((_e1285 + 4u) + (2u * (_e1264 >> bitcast<u32>(2i))));
                                        let _e1302 = bodies.member[_e1295];
                                        let _e1304 = bodies.member[_e1300];
                                        let _e1313 = bodies.member[((((_e1285 + 4u) + (2u * _e1287)) + (_e1302 * _e1290)) + (_e1304 / 32u))];
                                        let _e1316 = bodies.member[(_e1295 + 1u)];
                                        let _e1319 = bodies.member[(_e1300 + 1u)];
                                        if (_e1316 == _e1319) {
                                            if (((_e1313 >> bitcast<u32>(((_e1304 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_2557_ = true;
                                            } else {
                                                phi_2557_ = ((_e1260 >> bitcast<u32>(2i)) == (_e1264 >> bitcast<u32>(2i)));
                                            }
                                            let _e1333 = phi_2557_;
                                            phi_2558_ = _e1333;
                                        } else {
                                            phi_2558_ = false;
                                        }
                                        let _e1335 = phi_2558_;
                                        if _e1335 {
                                            let _e1340 = bodies.member[(_e1285 + 2u)];
                                            let _e1343 = bodies.member[(_e1285 + 3u)];
                                            let _e1344 = (_e1343 + _e1285);
                                            phi_2601_ = type_15(0i, 32i);
                                            phi_2604_ = _e1340;
                                            phi_2606_ = 0u;
                                            loop {
                                                let _e1346 = phi_2601_;
                                                let _e1348 = phi_2604_;
                                                let _e1350 = phi_2606_;
                                                local_5 = _e1350;
                                                local_6 = _e1350;
                                                if (_e1346.member < _e1346.member_1) {
                                                    let _e1357 = (_e1346.member + 1i);
                                                    if ((false == (_e1357 > _e1346.member)) != false) {
                                                        phi_2627_ = true;
                                                    } else {
                                                        phi_2627_ = false;
                                                    }
                                                    let _e1362 = phi_2627_;
                                                    if _e1362 {
                                                        phi_2633_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_2633_ = type_16(1u, _e1357);
                                                    }
                                                    let _e1367 = phi_2633_;
                                                    phi_2602_ = type_15(_e1367.member_1, _e1346.member_1);
                                                    phi_2647_ = type_16(1u, _e1346.member);
                                                } else {
                                                    phi_2602_ = _e1346;
                                                    phi_2647_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e1373 = phi_2602_;
                                                let _e1375 = phi_2647_;
                                                if (bitcast<i32>(_e1375.member) != 0i) {
                                                    if (_e1350 >= _e1348) {
                                                        phi_2730_ = u32();
                                                        phi_2731_ = u32();
                                                        phi_2732_ = false;
                                                    } else {
                                                        let _e1382 = (_e1350 + ((_e1348 - _e1350) / 2u));
                                                        let _e1384 = (_e1344 + (3u * _e1382));
                                                        let _e1386 = bodies.member[_e1384];
                                                        let _e1389 = bodies.member[(_e1384 + 1u)];
                                                        let _e1392 = bodies.member[(_e1384 + 2u)];
                                                        if (_e1386 == 0u) {
                                                            if (_e1389 < _e1193.member_1) {
                                                                phi_2717_ = false;
                                                            } else {
                                                                if (_e1389 == _e1193.member_1) {
                                                                    if (_e1392 < _e1195.member_1) {
                                                                        phi_2715_ = false;
                                                                    } else {
                                                                        phi_2715_ = true;
                                                                    }
                                                                    let _e1398 = phi_2715_;
                                                                    phi_2716_ = _e1398;
                                                                } else {
                                                                    phi_2716_ = true;
                                                                }
                                                                let _e1400 = phi_2716_;
                                                                phi_2717_ = _e1400;
                                                            }
                                                            let _e1402 = phi_2717_;
                                                            phi_2718_ = _e1402;
                                                        } else {
                                                            phi_2718_ = true;
                                                        }
                                                        let _e1404 = phi_2718_;
                                                        if _e1404 {
                                                            phi_2722_ = false;
                                                        } else {
                                                            phi_2722_ = true;
                                                        }
                                                        let _e1406 = phi_2722_;
                                                        if _e1406 {
                                                            phi_2728_ = _e1348;
                                                            phi_2729_ = (_e1382 + 1u);
                                                        } else {
                                                            phi_2728_ = _e1382;
                                                            phi_2729_ = _e1350;
                                                        }
                                                        let _e1409 = phi_2728_;
                                                        let _e1411 = phi_2729_;
                                                        phi_2730_ = _e1409;
                                                        phi_2731_ = _e1411;
                                                        phi_2732_ = true;
                                                    }
                                                    let _e1413 = phi_2730_;
                                                    let _e1415 = phi_2731_;
                                                    let _e1417 = phi_2732_;
                                                    phi_2605_ = _e1413;
                                                    phi_2607_ = _e1415;
                                                    phi_2733_ = _e1417;
                                                } else {
                                                    phi_2605_ = u32();
                                                    phi_2607_ = u32();
                                                    phi_2733_ = false;
                                                }
                                                let _e1419 = phi_2605_;
                                                let _e1421 = phi_2607_;
                                                let _e1423 = phi_2733_;
                                                continue;
                                                continuing {
                                                    phi_2601_ = _e1373;
                                                    phi_2604_ = _e1419;
                                                    phi_2606_ = _e1421;
                                                    break if !(_e1423);
                                                }
                                            }
                                            let _e1426 = local_5;
                                            if (_e1426 < _e1340) {
                                                let _e1429 = local_6;
                                                let _e1431 = (_e1344 + (3u * _e1429));
                                                let _e1433 = bodies.member[_e1431];
                                                if (_e1433 == 0u) {
                                                    let _e1437 = bodies.member[(_e1431 + 1u)];
                                                    if (_e1437 == _e1193.member_1) {
                                                        let _e1441 = bodies.member[(_e1431 + 2u)];
                                                        phi_2781_ = (_e1441 == _e1195.member_1);
                                                        phi_2782_ = false;
                                                    } else {
                                                        phi_2781_ = bool();
                                                        phi_2782_ = true;
                                                    }
                                                    let _e1444 = phi_2781_;
                                                    let _e1446 = phi_2782_;
                                                    phi_2783_ = _e1444;
                                                    phi_2784_ = _e1446;
                                                } else {
                                                    phi_2783_ = bool();
                                                    phi_2784_ = true;
                                                }
                                                let _e1448 = phi_2783_;
                                                let _e1450 = phi_2784_;
                                                if _e1450 {
                                                    phi_2788_ = false;
                                                } else {
                                                    phi_2788_ = _e1448;
                                                }
                                                let _e1452 = phi_2788_;
                                                phi_2789_ = _e1452;
                                            } else {
                                                phi_2789_ = false;
                                            }
                                            let _e1454 = phi_2789_;
                                            phi_2793_ = _e1454;
                                        } else {
                                            phi_2793_ = true;
                                        }
                                        let _e1456 = phi_2793_;
                                        if _e1456 {
                                            phi_2797_ = false;
                                        } else {
                                            phi_2797_ = true;
                                        }
                                        let _e1458 = phi_2797_;
                                        phi_2798_ = _e1458;
                                    } else {
                                        phi_2798_ = true;
                                    }
                                    let _e1460 = phi_2798_;
                                    if _e1460 {
                                        phi_2802_ = false;
                                    } else {
                                        phi_2802_ = true;
                                    }
                                    let _e1462 = phi_2802_;
                                    phi_2803_ = _e1462;
                                } else {
                                    phi_2803_ = true;
                                }
                                let _e1464 = phi_2803_;
                                if _e1464 {
                                    phi_2807_ = false;
                                } else {
                                    phi_2807_ = true;
                                }
                                let _e1466 = phi_2807_;
                                phi_2808_ = _e1466;
                            } else {
                                phi_2808_ = true;
                            }
                            let _e1468 = phi_2808_;
                            if _e1468 {
                                let _e1470 = params.member.member.member_1;
                                if ((_e1470 & 32u) != 0u) {
                                    let _e1474 = params.member.member.member_6;
                                    let _e1491 = (((((_e1197.member_1.y - _e1211.member.x) > _e1474) && ((_e1211.member_1.y - _e1197.member.x) > _e1474)) && (((_e1197.member_2.x - _e1211.member.y) > _e1474) && ((_e1211.member_2.x - _e1197.member.y) > _e1474))) && (((_e1197.member_2.y - _e1211.member_1.x) > _e1474) && ((_e1211.member_2.y - _e1197.member_1.x) > _e1474)));
                                    if _e1491 {
                                        phi_3410_ = bool();
                                    } else {
                                        let _e1495 = keys.member[_e1193.member[0]];
                                        let _e1500 = keys.member[_e1193.member[1]];
                                        let _e1502 = function_(_e1495[0], _e1500[0]);
                                        let _e1506 = keys.member[_e1193.member[2]];
                                        let _e1508 = function_(_e1502, _e1506[0]);
                                        let _e1512 = keys.member[_e1195.member[0]];
                                        let _e1517 = keys.member[_e1195.member[1]];
                                        let _e1519 = function_1(_e1512[3], _e1517[3]);
                                        let _e1523 = keys.member[_e1195.member[2]];
                                        let _e1525 = function_1(_e1519, _e1523[3]);
                                        if (_e1508[1] > _e1525[1]) {
                                            phi_2933_ = true;
                                        } else {
                                            if (_e1508[1] == _e1525[1]) {
                                                phi_2932_ = (_e1508[0] > _e1525[0]);
                                            } else {
                                                phi_2932_ = false;
                                            }
                                            let _e1536 = phi_2932_;
                                            phi_2933_ = _e1536;
                                        }
                                        let _e1538 = phi_2933_;
                                        let _e1543 = keys.member[_e1195.member[0]];
                                        let _e1548 = keys.member[_e1195.member[1]];
                                        let _e1550 = function_(_e1543[0], _e1548[0]);
                                        let _e1554 = keys.member[_e1195.member[2]];
                                        let _e1556 = function_(_e1550, _e1554[0]);
                                        let _e1560 = keys.member[_e1193.member[0]];
                                        let _e1565 = keys.member[_e1193.member[1]];
                                        let _e1567 = function_1(_e1560[3], _e1565[3]);
                                        let _e1571 = keys.member[_e1193.member[2]];
                                        let _e1573 = function_1(_e1567, _e1571[3]);
                                        if (_e1556[1] > _e1573[1]) {
                                            phi_3027_ = true;
                                        } else {
                                            if (_e1556[1] == _e1573[1]) {
                                                phi_3026_ = (_e1556[0] > _e1573[0]);
                                            } else {
                                                phi_3026_ = false;
                                            }
                                            let _e1584 = phi_3026_;
                                            phi_3027_ = _e1584;
                                        }
                                        let _e1586 = phi_3027_;
                                        let _e1592 = keys.member[_e1193.member[0]];
                                        let _e1597 = keys.member[_e1193.member[1]];
                                        let _e1599 = function_2(_e1592[1], _e1597[1]);
                                        let _e1603 = keys.member[_e1193.member[2]];
                                        let _e1605 = function_2(_e1599, _e1603[1]);
                                        let _e1609 = keys.member[_e1195.member[0]];
                                        let _e1614 = keys.member[_e1195.member[1]];
                                        let _e1616 = function_3(_e1609[4], _e1614[4]);
                                        let _e1620 = keys.member[_e1195.member[2]];
                                        let _e1622 = function_3(_e1616, _e1620[4]);
                                        if (_e1605[1] > _e1622[1]) {
                                            phi_3122_ = true;
                                        } else {
                                            if (_e1605[1] == _e1622[1]) {
                                                phi_3121_ = (_e1605[0] > _e1622[0]);
                                            } else {
                                                phi_3121_ = false;
                                            }
                                            let _e1633 = phi_3121_;
                                            phi_3122_ = _e1633;
                                        }
                                        let _e1635 = phi_3122_;
                                        let _e1640 = keys.member[_e1195.member[0]];
                                        let _e1645 = keys.member[_e1195.member[1]];
                                        let _e1647 = function_2(_e1640[1], _e1645[1]);
                                        let _e1651 = keys.member[_e1195.member[2]];
                                        let _e1653 = function_2(_e1647, _e1651[1]);
                                        let _e1657 = keys.member[_e1193.member[0]];
                                        let _e1662 = keys.member[_e1193.member[1]];
                                        let _e1664 = function_3(_e1657[4], _e1662[4]);
                                        let _e1668 = keys.member[_e1193.member[2]];
                                        let _e1670 = function_3(_e1664, _e1668[4]);
                                        if (_e1653[1] > _e1670[1]) {
                                            phi_3216_ = true;
                                        } else {
                                            if (_e1653[1] == _e1670[1]) {
                                                phi_3215_ = (_e1653[0] > _e1670[0]);
                                            } else {
                                                phi_3215_ = false;
                                            }
                                            let _e1681 = phi_3215_;
                                            phi_3216_ = _e1681;
                                        }
                                        let _e1683 = phi_3216_;
                                        let _e1690 = keys.member[_e1193.member[0]];
                                        let _e1695 = keys.member[_e1193.member[1]];
                                        let _e1697 = function_4(_e1690[2], _e1695[2]);
                                        let _e1701 = keys.member[_e1193.member[2]];
                                        let _e1703 = function_4(_e1697, _e1701[2]);
                                        let _e1707 = keys.member[_e1195.member[0]];
                                        let _e1712 = keys.member[_e1195.member[1]];
                                        let _e1714 = function_5(_e1707[5], _e1712[5]);
                                        let _e1718 = keys.member[_e1195.member[2]];
                                        let _e1720 = function_5(_e1714, _e1718[5]);
                                        if (_e1703[1] > _e1720[1]) {
                                            phi_3312_ = true;
                                        } else {
                                            if (_e1703[1] == _e1720[1]) {
                                                phi_3311_ = (_e1703[0] > _e1720[0]);
                                            } else {
                                                phi_3311_ = false;
                                            }
                                            let _e1731 = phi_3311_;
                                            phi_3312_ = _e1731;
                                        }
                                        let _e1733 = phi_3312_;
                                        let _e1738 = keys.member[_e1195.member[0]];
                                        let _e1743 = keys.member[_e1195.member[1]];
                                        let _e1745 = function_4(_e1738[2], _e1743[2]);
                                        let _e1749 = keys.member[_e1195.member[2]];
                                        let _e1751 = function_4(_e1745, _e1749[2]);
                                        let _e1755 = keys.member[_e1193.member[0]];
                                        let _e1760 = keys.member[_e1193.member[1]];
                                        let _e1762 = function_5(_e1755[5], _e1760[5]);
                                        let _e1766 = keys.member[_e1193.member[2]];
                                        let _e1768 = function_5(_e1762, _e1766[5]);
                                        if (_e1751[1] > _e1768[1]) {
                                            phi_3406_ = true;
                                        } else {
                                            if (_e1751[1] == _e1768[1]) {
                                                phi_3405_ = (_e1751[0] > _e1768[0]);
                                            } else {
                                                phi_3405_ = false;
                                            }
                                            let _e1779 = phi_3405_;
                                            phi_3406_ = _e1779;
                                        }
                                        let _e1781 = phi_3406_;
                                        phi_3410_ = (((!(_e1538) && !(_e1586)) && (!(_e1635) && !(_e1683))) && (!(_e1733) && !(_e1781)));
                                    }
                                    let _e1786 = phi_3410_;
                                    phi_3411_ = _e1786;
                                    phi_3412_ = _e1491;
                                } else {
                                    phi_3411_ = bool();
                                    phi_3412_ = true;
                                }
                                let _e1788 = phi_3411_;
                                let _e1790 = phi_3412_;
                                if _e1790 {
                                    phi_3416_ = false;
                                } else {
                                    phi_3416_ = true;
                                }
                                let _e1792 = phi_3416_;
                                phi_3417_ = _e1788;
                                phi_3418_ = _e1792;
                            } else {
                                phi_3417_ = false;
                                phi_3418_ = true;
                            }
                            let _e1794 = phi_3417_;
                            let _e1796 = phi_3418_;
                            phi_3419_ = _e1794;
                            phi_3420_ = _e1796;
                        } else {
                            phi_3419_ = false;
                            phi_3420_ = true;
                        }
                        let _e1798 = phi_3419_;
                        let _e1800 = phi_3420_;
                        if _e1800 {
                            phi_3424_ = _e1798;
                        } else {
                            phi_3424_ = true;
                        }
                        let _e1802 = phi_3424_;
                        if _e1802 {
                            let _e1804 = atomicAdd((&counters[7u]), 1u);
                            let _e1815 = params.member.member.member_4;
                            let _e1817 = params.member.member.member_5;
                            let _e1819 = paths.member[_e1193.member[0]];
                            let _e1821 = paths.member[_e1195.member[0]];
                            let _e1827 = paths.member[_e1195.member[1]];
                            let _e1829 = paths.member[_e1195.member[2]];
                            local_2 = type_41(array<array<f32, 3>, 2>(array<f32, 3>((_e1819.member[0] - _e1821.member[0]), (_e1819.member[1] - _e1821.member[1]), (_e1819.member[2] - _e1821.member[2])), array<f32, 3>((_e1819.member_1[0] - _e1821.member_1[0]), (_e1819.member_1[1] - _e1821.member_1[1]), (_e1819.member_1[2] - _e1821.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1827.member[0] - _e1821.member[0]), (_e1827.member[1] - _e1821.member[1]), (_e1827.member[2] - _e1821.member[2])), array<f32, 3>((_e1827.member_1[0] - _e1821.member_1[0]), (_e1827.member_1[1] - _e1821.member_1[1]), (_e1827.member_1[2] - _e1821.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1829.member[0] - _e1821.member[0]), (_e1829.member[1] - _e1821.member[1]), (_e1829.member[2] - _e1821.member[2])), array<f32, 3>((_e1829.member_1[0] - _e1821.member_1[0]), (_e1829.member_1[1] - _e1821.member_1[1]), (_e1829.member_1[2] - _e1821.member_1[2]))), (_e1815 + _e1815));
                            let _e1889 = local_2.member_1[0u];
                            let _e1895 = local_2.member_2[0u];
                            let _e1901 = ((_e1889[1] * _e1895[2]) - (_e1889[2] * _e1895[1]));
                            let _e1904 = ((_e1889[2] * _e1895[0]) - (_e1889[0] * _e1895[2]));
                            let _e1907 = ((_e1889[0] * _e1895[1]) - (_e1889[1] * _e1895[0]));
                            let _e1910 = local_2.member_1[1u];
                            let _e1916 = local_2.member_2[1u];
                            let _e1922 = ((_e1910[1] * _e1916[2]) - (_e1910[2] * _e1916[1]));
                            let _e1925 = ((_e1910[2] * _e1916[0]) - (_e1910[0] * _e1916[2]));
                            let _e1928 = ((_e1910[0] * _e1916[1]) - (_e1910[1] * _e1916[0]));
                            let _e1931 = local_2.member_1[0u];
                            let _e1937 = local_2.member_2[1u];
                            let _e1952 = local_2.member_1[1u];
                            let _e1958 = local_2.member_2[0u];
                            let _e1971 = (((_e1931[1] * _e1937[2]) - (_e1931[2] * _e1937[1])) + ((_e1952[1] * _e1958[2]) - (_e1952[2] * _e1958[1])));
                            let _e1972 = (((_e1931[2] * _e1937[0]) - (_e1931[0] * _e1937[2])) + ((_e1952[2] * _e1958[0]) - (_e1952[0] * _e1958[2])));
                            let _e1973 = (((_e1931[0] * _e1937[1]) - (_e1931[1] * _e1937[0])) + ((_e1952[0] * _e1958[1]) - (_e1952[1] * _e1958[0])));
                            let _e1976 = local_2.member[0u];
                            let _e1987 = local_2.member[1u];
                            let _e1998 = local_2.member[0u];
                            let _e2007 = ((((_e1987[0] * _e1901) + (_e1987[1] * _e1904)) + (_e1987[2] * _e1907)) + (((_e1998[0] * _e1971) + (_e1998[1] * _e1972)) + (_e1998[2] * _e1973)));
                            let _e2010 = local_2.member[0u];
                            let _e2021 = local_2.member[1u];
                            let _e2030 = ((((_e2010[0] * _e1922) + (_e2010[1] * _e1925)) + (_e2010[2] * _e1928)) + (((_e2021[0] * _e1971) + (_e2021[1] * _e1972)) + (_e2021[2] * _e1973)));
                            let _e2033 = local_2.member[1u];
                            let _e2044 = local_2.member[0u];
                            if (_e2044[0] < 0f) {
                                phi_3853_ = -(_e2044[0]);
                            } else {
                                phi_3853_ = _e2044[0];
                            }
                            let _e2051 = phi_3853_;
                            if (_e2044[1] < 0f) {
                                phi_3860_ = -(_e2044[1]);
                            } else {
                                phi_3860_ = _e2044[1];
                            }
                            let _e2055 = phi_3860_;
                            if (_e2051 > _e2055) {
                                phi_3865_ = _e2051;
                            } else {
                                phi_3865_ = _e2055;
                            }
                            let _e2058 = phi_3865_;
                            if (_e2044[2] < 0f) {
                                phi_3872_ = -(_e2044[2]);
                            } else {
                                phi_3872_ = _e2044[2];
                            }
                            let _e2062 = phi_3872_;
                            if (_e2058 > _e2062) {
                                phi_3877_ = _e2058;
                            } else {
                                phi_3877_ = _e2062;
                            }
                            let _e2065 = phi_3877_;
                            let _e2068 = local_2.member[1u];
                            if (_e2068[0] < 0f) {
                                phi_3890_ = -(_e2068[0]);
                            } else {
                                phi_3890_ = _e2068[0];
                            }
                            let _e2075 = phi_3890_;
                            if (_e2068[1] < 0f) {
                                phi_3897_ = -(_e2068[1]);
                            } else {
                                phi_3897_ = _e2068[1];
                            }
                            let _e2079 = phi_3897_;
                            if (_e2075 > _e2079) {
                                phi_3902_ = _e2075;
                            } else {
                                phi_3902_ = _e2079;
                            }
                            let _e2082 = phi_3902_;
                            if (_e2068[2] < 0f) {
                                phi_3909_ = -(_e2068[2]);
                            } else {
                                phi_3909_ = _e2068[2];
                            }
                            let _e2086 = phi_3909_;
                            if (_e2082 > _e2086) {
                                phi_3914_ = _e2082;
                            } else {
                                phi_3914_ = _e2086;
                            }
                            let _e2089 = phi_3914_;
                            if (_e2065 > _e2089) {
                                phi_3919_ = _e2065;
                            } else {
                                phi_3919_ = _e2089;
                            }
                            let _e2092 = phi_3919_;
                            let _e2094 = local_2.member_3;
                            let _e2095 = (_e2092 + _e2094);
                            let _e2098 = local_2.member_1[0u];
                            if (_e2098[0] < 0f) {
                                phi_3936_ = -(_e2098[0]);
                            } else {
                                phi_3936_ = _e2098[0];
                            }
                            let _e2105 = phi_3936_;
                            if (_e2098[1] < 0f) {
                                phi_3943_ = -(_e2098[1]);
                            } else {
                                phi_3943_ = _e2098[1];
                            }
                            let _e2109 = phi_3943_;
                            if (_e2105 > _e2109) {
                                phi_3948_ = _e2105;
                            } else {
                                phi_3948_ = _e2109;
                            }
                            let _e2112 = phi_3948_;
                            if (_e2098[2] < 0f) {
                                phi_3955_ = -(_e2098[2]);
                            } else {
                                phi_3955_ = _e2098[2];
                            }
                            let _e2116 = phi_3955_;
                            if (_e2112 > _e2116) {
                                phi_3960_ = _e2112;
                            } else {
                                phi_3960_ = _e2116;
                            }
                            let _e2119 = phi_3960_;
                            let _e2122 = local_2.member_1[1u];
                            if (_e2122[0] < 0f) {
                                phi_3974_ = -(_e2122[0]);
                            } else {
                                phi_3974_ = _e2122[0];
                            }
                            let _e2129 = phi_3974_;
                            if (_e2122[1] < 0f) {
                                phi_3981_ = -(_e2122[1]);
                            } else {
                                phi_3981_ = _e2122[1];
                            }
                            let _e2133 = phi_3981_;
                            if (_e2129 > _e2133) {
                                phi_3986_ = _e2129;
                            } else {
                                phi_3986_ = _e2133;
                            }
                            let _e2136 = phi_3986_;
                            if (_e2122[2] < 0f) {
                                phi_3993_ = -(_e2122[2]);
                            } else {
                                phi_3993_ = _e2122[2];
                            }
                            let _e2140 = phi_3993_;
                            if (_e2136 > _e2140) {
                                phi_3998_ = _e2136;
                            } else {
                                phi_3998_ = _e2140;
                            }
                            let _e2143 = phi_3998_;
                            if (_e2119 > _e2143) {
                                phi_4003_ = _e2119;
                            } else {
                                phi_4003_ = _e2143;
                            }
                            let _e2146 = phi_4003_;
                            let _e2148 = local_2.member_3;
                            let _e2149 = (_e2146 + _e2148);
                            let _e2152 = local_2.member_2[0u];
                            if (_e2152[0] < 0f) {
                                phi_4020_ = -(_e2152[0]);
                            } else {
                                phi_4020_ = _e2152[0];
                            }
                            let _e2159 = phi_4020_;
                            if (_e2152[1] < 0f) {
                                phi_4027_ = -(_e2152[1]);
                            } else {
                                phi_4027_ = _e2152[1];
                            }
                            let _e2163 = phi_4027_;
                            if (_e2159 > _e2163) {
                                phi_4032_ = _e2159;
                            } else {
                                phi_4032_ = _e2163;
                            }
                            let _e2166 = phi_4032_;
                            if (_e2152[2] < 0f) {
                                phi_4039_ = -(_e2152[2]);
                            } else {
                                phi_4039_ = _e2152[2];
                            }
                            let _e2170 = phi_4039_;
                            if (_e2166 > _e2170) {
                                phi_4044_ = _e2166;
                            } else {
                                phi_4044_ = _e2170;
                            }
                            let _e2173 = phi_4044_;
                            let _e2176 = local_2.member_2[1u];
                            if (_e2176[0] < 0f) {
                                phi_4058_ = -(_e2176[0]);
                            } else {
                                phi_4058_ = _e2176[0];
                            }
                            let _e2183 = phi_4058_;
                            if (_e2176[1] < 0f) {
                                phi_4065_ = -(_e2176[1]);
                            } else {
                                phi_4065_ = _e2176[1];
                            }
                            let _e2187 = phi_4065_;
                            if (_e2183 > _e2187) {
                                phi_4070_ = _e2183;
                            } else {
                                phi_4070_ = _e2187;
                            }
                            let _e2190 = phi_4070_;
                            if (_e2176[2] < 0f) {
                                phi_4077_ = -(_e2176[2]);
                            } else {
                                phi_4077_ = _e2176[2];
                            }
                            let _e2194 = phi_4077_;
                            if (_e2190 > _e2194) {
                                phi_4082_ = _e2190;
                            } else {
                                phi_4082_ = _e2194;
                            }
                            let _e2197 = phi_4082_;
                            if (_e2173 > _e2197) {
                                phi_4087_ = _e2173;
                            } else {
                                phi_4087_ = _e2197;
                            }
                            let _e2200 = phi_4087_;
                            let _e2202 = local_2.member_3;
                            let _e2203 = (_e2200 + _e2202);
                            let _e2205 = ((_e2149 * 8f) * _e2203);
                            let _e2212 = local_2.member_3;
                            if (_e1901 < 0f) {
                                phi_4118_ = -(_e1901);
                            } else {
                                phi_4118_ = _e1901;
                            }
                            let _e2229 = phi_4118_;
                            if (_e1904 < 0f) {
                                phi_4124_ = -(_e1904);
                            } else {
                                phi_4124_ = _e1904;
                            }
                            let _e2233 = phi_4124_;
                            if (_e1907 < 0f) {
                                phi_4131_ = -(_e1907);
                            } else {
                                phi_4131_ = _e1907;
                            }
                            let _e2238 = phi_4131_;
                            let _e2239 = ((_e2229 + _e2233) + _e2238);
                            if (_e1922 < 0f) {
                                phi_4138_ = -(_e1922);
                            } else {
                                phi_4138_ = _e1922;
                            }
                            let _e2243 = phi_4138_;
                            if (_e1925 < 0f) {
                                phi_4144_ = -(_e1925);
                            } else {
                                phi_4144_ = _e1925;
                            }
                            let _e2247 = phi_4144_;
                            if (_e1928 < 0f) {
                                phi_4151_ = -(_e1928);
                            } else {
                                phi_4151_ = _e1928;
                            }
                            let _e2252 = phi_4151_;
                            let _e2253 = ((_e2243 + _e2247) + _e2252);
                            if (_e2239 > _e2253) {
                                phi_4157_ = _e2239;
                            } else {
                                phi_4157_ = _e2253;
                            }
                            let _e2256 = phi_4157_;
                            if (_e1971 < 0f) {
                                phi_4163_ = -(_e1971);
                            } else {
                                phi_4163_ = _e1971;
                            }
                            let _e2260 = phi_4163_;
                            if (_e1972 < 0f) {
                                phi_4169_ = -(_e1972);
                            } else {
                                phi_4169_ = _e1972;
                            }
                            let _e2264 = phi_4169_;
                            if (_e1973 < 0f) {
                                phi_4176_ = -(_e1973);
                            } else {
                                phi_4176_ = _e1973;
                            }
                            let _e2269 = phi_4176_;
                            let _e2271 = (((_e2260 + _e2264) + _e2269) * 0.5f);
                            if (_e2256 > _e2271) {
                                phi_4183_ = _e2256;
                            } else {
                                phi_4183_ = _e2271;
                            }
                            let _e2274 = phi_4183_;
                            let _e2279 = local_2.member_3;
                            let _e2292 = ((((_e1976[0] * _e1901) + (_e1976[1] * _e1904)) + (_e1976[2] * _e1907)) * 3f);
                            let _e2293 = ((((_e2033[0] * _e1922) + (_e2033[1] * _e1925)) + (_e2033[2] * _e1928)) * 3f);
                            if (_e2292 < _e2293) {
                                phi_4207_ = _e2292;
                            } else {
                                phi_4207_ = _e2293;
                            }
                            let _e2296 = phi_4207_;
                            if (_e2007 < _e2030) {
                                phi_4212_ = _e2007;
                            } else {
                                phi_4212_ = _e2030;
                            }
                            let _e2299 = phi_4212_;
                            if (_e2296 < _e2299) {
                                phi_4217_ = _e2296;
                            } else {
                                phi_4217_ = _e2299;
                            }
                            let _e2302 = phi_4217_;
                            if (_e2292 > _e2293) {
                                phi_4222_ = _e2292;
                            } else {
                                phi_4222_ = _e2293;
                            }
                            let _e2305 = phi_4222_;
                            if (_e2007 > _e2030) {
                                phi_4227_ = _e2007;
                            } else {
                                phi_4227_ = _e2030;
                            }
                            let _e2308 = phi_4227_;
                            if (_e2305 > _e2308) {
                                phi_4232_ = _e2305;
                            } else {
                                phi_4232_ = _e2308;
                            }
                            let _e2311 = phi_4232_;
                            let _e2316 = -(_e2311);
                            if (_e2302 > _e2316) {
                                phi_4242_ = _e2302;
                            } else {
                                phi_4242_ = _e2316;
                            }
                            let _e2319 = phi_4242_;
                            let _e2321 = ((_e2319 - ((((((_e2095 * 8f) * _e2205) * (0.000000059604645f * (524f / 64f))) + ((_e2212 * 19f) * ((_e2095 * (_e2149 + _e2203)) + (_e2149 * _e2203)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2095) * ((1f + _e2149) * (1f + _e2203))))) + ((_e1817 * (((_e2274 + (_e2205 * (0.000000059604645f * 8f))) + ((_e2279 * 6f) * (_e2149 + _e2203))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2149) * (1f + _e2203))))) * (3f * 1.0001f)))) > 0f);
                            if _e2321 {
                                phi_5211_ = _e2321;
                            } else {
                                let _e2324 = local_2.member_1[0u];
                                let _e2330 = local_2.member_1[1u];
                                let _e2334 = (_e2324[0] + _e2330[0]);
                                let _e2335 = (_e2324[1] + _e2330[1]);
                                let _e2336 = (_e2324[2] + _e2330[2]);
                                let _e2339 = local_2.member_2[0u];
                                let _e2345 = local_2.member_2[1u];
                                let _e2349 = (_e2339[0] + _e2345[0]);
                                let _e2350 = (_e2339[1] + _e2345[1]);
                                let _e2351 = (_e2339[2] + _e2345[2]);
                                let _e2354 = ((_e2335 * _e2351) - (_e2336 * _e2350));
                                let _e2357 = ((_e2336 * _e2349) - (_e2334 * _e2351));
                                let _e2360 = ((_e2334 * _e2350) - (_e2335 * _e2349));
                                let _e2363 = local_2.member[0u];
                                let _e2369 = local_2.member_1[0u];
                                let _e2375 = local_2.member_2[0u];
                                let _e2379 = (_e2363[0] - _e2369[0]);
                                let _e2380 = (_e2363[1] - _e2369[1]);
                                let _e2381 = (_e2363[2] - _e2369[2]);
                                let _e2382 = (_e2363[0] - _e2375[0]);
                                let _e2383 = (_e2363[1] - _e2375[1]);
                                let _e2384 = (_e2363[2] - _e2375[2]);
                                let _e2387 = local_2.member[1u];
                                let _e2393 = local_2.member_1[1u];
                                let _e2399 = local_2.member_2[1u];
                                let _e2403 = (_e2387[0] - _e2393[0]);
                                let _e2404 = (_e2387[1] - _e2393[1]);
                                let _e2405 = (_e2387[2] - _e2393[2]);
                                let _e2406 = (_e2387[0] - _e2399[0]);
                                let _e2407 = (_e2387[1] - _e2399[1]);
                                let _e2408 = (_e2387[2] - _e2399[2]);
                                let _e2411 = local_2.member[0u];
                                if (_e2411[0] < 0f) {
                                    phi_4445_ = -(_e2411[0]);
                                } else {
                                    phi_4445_ = _e2411[0];
                                }
                                let _e2418 = phi_4445_;
                                if (_e2411[1] < 0f) {
                                    phi_4452_ = -(_e2411[1]);
                                } else {
                                    phi_4452_ = _e2411[1];
                                }
                                let _e2422 = phi_4452_;
                                if (_e2418 > _e2422) {
                                    phi_4457_ = _e2418;
                                } else {
                                    phi_4457_ = _e2422;
                                }
                                let _e2425 = phi_4457_;
                                if (_e2411[2] < 0f) {
                                    phi_4464_ = -(_e2411[2]);
                                } else {
                                    phi_4464_ = _e2411[2];
                                }
                                let _e2429 = phi_4464_;
                                if (_e2425 > _e2429) {
                                    phi_4469_ = _e2425;
                                } else {
                                    phi_4469_ = _e2429;
                                }
                                let _e2432 = phi_4469_;
                                let _e2435 = local_2.member[1u];
                                if (_e2435[0] < 0f) {
                                    phi_4482_ = -(_e2435[0]);
                                } else {
                                    phi_4482_ = _e2435[0];
                                }
                                let _e2442 = phi_4482_;
                                if (_e2435[1] < 0f) {
                                    phi_4489_ = -(_e2435[1]);
                                } else {
                                    phi_4489_ = _e2435[1];
                                }
                                let _e2446 = phi_4489_;
                                if (_e2442 > _e2446) {
                                    phi_4494_ = _e2442;
                                } else {
                                    phi_4494_ = _e2446;
                                }
                                let _e2449 = phi_4494_;
                                if (_e2435[2] < 0f) {
                                    phi_4501_ = -(_e2435[2]);
                                } else {
                                    phi_4501_ = _e2435[2];
                                }
                                let _e2453 = phi_4501_;
                                if (_e2449 > _e2453) {
                                    phi_4506_ = _e2449;
                                } else {
                                    phi_4506_ = _e2453;
                                }
                                let _e2456 = phi_4506_;
                                if (_e2432 > _e2456) {
                                    phi_4511_ = _e2432;
                                } else {
                                    phi_4511_ = _e2456;
                                }
                                let _e2459 = phi_4511_;
                                let _e2461 = local_2.member_3;
                                let _e2465 = local_2.member_1[0u];
                                if (_e2465[0] < 0f) {
                                    phi_4528_ = -(_e2465[0]);
                                } else {
                                    phi_4528_ = _e2465[0];
                                }
                                let _e2472 = phi_4528_;
                                if (_e2465[1] < 0f) {
                                    phi_4535_ = -(_e2465[1]);
                                } else {
                                    phi_4535_ = _e2465[1];
                                }
                                let _e2476 = phi_4535_;
                                if (_e2472 > _e2476) {
                                    phi_4540_ = _e2472;
                                } else {
                                    phi_4540_ = _e2476;
                                }
                                let _e2479 = phi_4540_;
                                if (_e2465[2] < 0f) {
                                    phi_4547_ = -(_e2465[2]);
                                } else {
                                    phi_4547_ = _e2465[2];
                                }
                                let _e2483 = phi_4547_;
                                if (_e2479 > _e2483) {
                                    phi_4552_ = _e2479;
                                } else {
                                    phi_4552_ = _e2483;
                                }
                                let _e2486 = phi_4552_;
                                let _e2489 = local_2.member_1[1u];
                                if (_e2489[0] < 0f) {
                                    phi_4566_ = -(_e2489[0]);
                                } else {
                                    phi_4566_ = _e2489[0];
                                }
                                let _e2496 = phi_4566_;
                                if (_e2489[1] < 0f) {
                                    phi_4573_ = -(_e2489[1]);
                                } else {
                                    phi_4573_ = _e2489[1];
                                }
                                let _e2500 = phi_4573_;
                                if (_e2496 > _e2500) {
                                    phi_4578_ = _e2496;
                                } else {
                                    phi_4578_ = _e2500;
                                }
                                let _e2503 = phi_4578_;
                                if (_e2489[2] < 0f) {
                                    phi_4585_ = -(_e2489[2]);
                                } else {
                                    phi_4585_ = _e2489[2];
                                }
                                let _e2507 = phi_4585_;
                                if (_e2503 > _e2507) {
                                    phi_4590_ = _e2503;
                                } else {
                                    phi_4590_ = _e2507;
                                }
                                let _e2510 = phi_4590_;
                                if (_e2486 > _e2510) {
                                    phi_4595_ = _e2486;
                                } else {
                                    phi_4595_ = _e2510;
                                }
                                let _e2513 = phi_4595_;
                                let _e2515 = local_2.member_3;
                                let _e2519 = local_2.member_2[0u];
                                if (_e2519[0] < 0f) {
                                    phi_4612_ = -(_e2519[0]);
                                } else {
                                    phi_4612_ = _e2519[0];
                                }
                                let _e2526 = phi_4612_;
                                if (_e2519[1] < 0f) {
                                    phi_4619_ = -(_e2519[1]);
                                } else {
                                    phi_4619_ = _e2519[1];
                                }
                                let _e2530 = phi_4619_;
                                if (_e2526 > _e2530) {
                                    phi_4624_ = _e2526;
                                } else {
                                    phi_4624_ = _e2530;
                                }
                                let _e2533 = phi_4624_;
                                if (_e2519[2] < 0f) {
                                    phi_4631_ = -(_e2519[2]);
                                } else {
                                    phi_4631_ = _e2519[2];
                                }
                                let _e2537 = phi_4631_;
                                if (_e2533 > _e2537) {
                                    phi_4636_ = _e2533;
                                } else {
                                    phi_4636_ = _e2537;
                                }
                                let _e2540 = phi_4636_;
                                let _e2543 = local_2.member_2[1u];
                                if (_e2543[0] < 0f) {
                                    phi_4650_ = -(_e2543[0]);
                                } else {
                                    phi_4650_ = _e2543[0];
                                }
                                let _e2550 = phi_4650_;
                                if (_e2543[1] < 0f) {
                                    phi_4657_ = -(_e2543[1]);
                                } else {
                                    phi_4657_ = _e2543[1];
                                }
                                let _e2554 = phi_4657_;
                                if (_e2550 > _e2554) {
                                    phi_4662_ = _e2550;
                                } else {
                                    phi_4662_ = _e2554;
                                }
                                let _e2557 = phi_4662_;
                                if (_e2543[2] < 0f) {
                                    phi_4669_ = -(_e2543[2]);
                                } else {
                                    phi_4669_ = _e2543[2];
                                }
                                let _e2561 = phi_4669_;
                                if (_e2557 > _e2561) {
                                    phi_4674_ = _e2557;
                                } else {
                                    phi_4674_ = _e2561;
                                }
                                let _e2564 = phi_4674_;
                                if (_e2540 > _e2564) {
                                    phi_4679_ = _e2540;
                                } else {
                                    phi_4679_ = _e2564;
                                }
                                let _e2567 = phi_4679_;
                                let _e2569 = local_2.member_3;
                                let _e2573 = ((((_e2459 + _e2461) + (_e2513 + _e2515)) + (_e2567 + _e2569)) * 2f);
                                let _e2576 = local_2.member_3;
                                let _e2580 = (((_e1817 * 1.0001f) + (_e2576 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2583 = ((_e2357 * _e2336) - (_e2360 * _e2335));
                                let _e2586 = ((_e2360 * _e2334) - (_e2354 * _e2336));
                                let _e2589 = ((_e2354 * _e2335) - (_e2357 * _e2334));
                                let _e2594 = (((_e2583 * _e2363[0]) + (_e2586 * _e2363[1])) + (_e2589 * _e2363[2]));
                                let _e2599 = (((_e2583 * _e2379) + (_e2586 * _e2380)) + (_e2589 * _e2381));
                                let _e2604 = (((_e2583 * _e2382) + (_e2586 * _e2383)) + (_e2589 * _e2384));
                                let _e2609 = (((_e2583 * _e2363[0]) + (_e2586 * _e2363[1])) + (_e2589 * _e2363[2]));
                                let _e2614 = (((_e2583 * _e2387[0]) + (_e2586 * _e2387[1])) + (_e2589 * _e2387[2]));
                                let _e2619 = (((_e2583 * _e2403) + (_e2586 * _e2404)) + (_e2589 * _e2405));
                                let _e2624 = (((_e2583 * _e2406) + (_e2586 * _e2407)) + (_e2589 * _e2408));
                                let _e2629 = (((_e2583 * _e2387[0]) + (_e2586 * _e2387[1])) + (_e2589 * _e2387[2]));
                                if (_e2594 < _e2599) {
                                    phi_4758_ = _e2594;
                                } else {
                                    phi_4758_ = _e2599;
                                }
                                let _e2632 = phi_4758_;
                                if (_e2604 < _e2609) {
                                    phi_4763_ = _e2604;
                                } else {
                                    phi_4763_ = _e2609;
                                }
                                let _e2635 = phi_4763_;
                                if (_e2632 < _e2635) {
                                    phi_4768_ = _e2632;
                                } else {
                                    phi_4768_ = _e2635;
                                }
                                let _e2638 = phi_4768_;
                                if (_e2614 < _e2619) {
                                    phi_4773_ = _e2614;
                                } else {
                                    phi_4773_ = _e2619;
                                }
                                let _e2641 = phi_4773_;
                                if (_e2624 < _e2629) {
                                    phi_4778_ = _e2624;
                                } else {
                                    phi_4778_ = _e2629;
                                }
                                let _e2644 = phi_4778_;
                                if (_e2641 < _e2644) {
                                    phi_4783_ = _e2641;
                                } else {
                                    phi_4783_ = _e2644;
                                }
                                let _e2647 = phi_4783_;
                                if (_e2638 < _e2647) {
                                    phi_4788_ = _e2638;
                                } else {
                                    phi_4788_ = _e2647;
                                }
                                let _e2650 = phi_4788_;
                                if (_e2594 > _e2599) {
                                    phi_4793_ = _e2594;
                                } else {
                                    phi_4793_ = _e2599;
                                }
                                let _e2653 = phi_4793_;
                                if (_e2604 > _e2609) {
                                    phi_4798_ = _e2604;
                                } else {
                                    phi_4798_ = _e2609;
                                }
                                let _e2656 = phi_4798_;
                                if (_e2653 > _e2656) {
                                    phi_4803_ = _e2653;
                                } else {
                                    phi_4803_ = _e2656;
                                }
                                let _e2659 = phi_4803_;
                                if (_e2614 > _e2619) {
                                    phi_4808_ = _e2614;
                                } else {
                                    phi_4808_ = _e2619;
                                }
                                let _e2662 = phi_4808_;
                                if (_e2624 > _e2629) {
                                    phi_4813_ = _e2624;
                                } else {
                                    phi_4813_ = _e2629;
                                }
                                let _e2665 = phi_4813_;
                                if (_e2662 > _e2665) {
                                    phi_4818_ = _e2662;
                                } else {
                                    phi_4818_ = _e2665;
                                }
                                let _e2668 = phi_4818_;
                                if (_e2659 > _e2668) {
                                    phi_4823_ = _e2659;
                                } else {
                                    phi_4823_ = _e2668;
                                }
                                let _e2671 = phi_4823_;
                                if (_e2583 < 0f) {
                                    phi_4829_ = -(_e2583);
                                } else {
                                    phi_4829_ = _e2583;
                                }
                                let _e2675 = phi_4829_;
                                if (_e2586 < 0f) {
                                    phi_4835_ = -(_e2586);
                                } else {
                                    phi_4835_ = _e2586;
                                }
                                let _e2679 = phi_4835_;
                                if (_e2589 < 0f) {
                                    phi_4842_ = -(_e2589);
                                } else {
                                    phi_4842_ = _e2589;
                                }
                                let _e2684 = phi_4842_;
                                let _e2685 = ((_e2675 + _e2679) + _e2684);
                                let _e2690 = -(_e2671);
                                if (_e2650 > _e2690) {
                                    phi_4853_ = _e2650;
                                } else {
                                    phi_4853_ = _e2690;
                                }
                                let _e2693 = phi_4853_;
                                let _e2698 = (((_e2693 - ((_e2685 * _e2573) * (0.000000059604645f * (17f / 2f)))) - (_e2685 * _e2580)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2701 = ((_e2357 * _e2351) - (_e2360 * _e2350));
                                let _e2704 = ((_e2360 * _e2349) - (_e2354 * _e2351));
                                let _e2707 = ((_e2354 * _e2350) - (_e2357 * _e2349));
                                let _e2712 = (((_e2701 * _e2363[0]) + (_e2704 * _e2363[1])) + (_e2707 * _e2363[2]));
                                let _e2717 = (((_e2701 * _e2379) + (_e2704 * _e2380)) + (_e2707 * _e2381));
                                let _e2722 = (((_e2701 * _e2382) + (_e2704 * _e2383)) + (_e2707 * _e2384));
                                let _e2727 = (((_e2701 * _e2363[0]) + (_e2704 * _e2363[1])) + (_e2707 * _e2363[2]));
                                let _e2732 = (((_e2701 * _e2387[0]) + (_e2704 * _e2387[1])) + (_e2707 * _e2387[2]));
                                let _e2737 = (((_e2701 * _e2403) + (_e2704 * _e2404)) + (_e2707 * _e2405));
                                let _e2742 = (((_e2701 * _e2406) + (_e2704 * _e2407)) + (_e2707 * _e2408));
                                let _e2747 = (((_e2701 * _e2387[0]) + (_e2704 * _e2387[1])) + (_e2707 * _e2387[2]));
                                if (_e2712 < _e2717) {
                                    phi_4924_ = _e2712;
                                } else {
                                    phi_4924_ = _e2717;
                                }
                                let _e2750 = phi_4924_;
                                if (_e2722 < _e2727) {
                                    phi_4929_ = _e2722;
                                } else {
                                    phi_4929_ = _e2727;
                                }
                                let _e2753 = phi_4929_;
                                if (_e2750 < _e2753) {
                                    phi_4934_ = _e2750;
                                } else {
                                    phi_4934_ = _e2753;
                                }
                                let _e2756 = phi_4934_;
                                if (_e2732 < _e2737) {
                                    phi_4939_ = _e2732;
                                } else {
                                    phi_4939_ = _e2737;
                                }
                                let _e2759 = phi_4939_;
                                if (_e2742 < _e2747) {
                                    phi_4944_ = _e2742;
                                } else {
                                    phi_4944_ = _e2747;
                                }
                                let _e2762 = phi_4944_;
                                if (_e2759 < _e2762) {
                                    phi_4949_ = _e2759;
                                } else {
                                    phi_4949_ = _e2762;
                                }
                                let _e2765 = phi_4949_;
                                if (_e2756 < _e2765) {
                                    phi_4954_ = _e2756;
                                } else {
                                    phi_4954_ = _e2765;
                                }
                                let _e2768 = phi_4954_;
                                if (_e2712 > _e2717) {
                                    phi_4959_ = _e2712;
                                } else {
                                    phi_4959_ = _e2717;
                                }
                                let _e2771 = phi_4959_;
                                if (_e2722 > _e2727) {
                                    phi_4964_ = _e2722;
                                } else {
                                    phi_4964_ = _e2727;
                                }
                                let _e2774 = phi_4964_;
                                if (_e2771 > _e2774) {
                                    phi_4969_ = _e2771;
                                } else {
                                    phi_4969_ = _e2774;
                                }
                                let _e2777 = phi_4969_;
                                if (_e2732 > _e2737) {
                                    phi_4974_ = _e2732;
                                } else {
                                    phi_4974_ = _e2737;
                                }
                                let _e2780 = phi_4974_;
                                if (_e2742 > _e2747) {
                                    phi_4979_ = _e2742;
                                } else {
                                    phi_4979_ = _e2747;
                                }
                                let _e2783 = phi_4979_;
                                if (_e2780 > _e2783) {
                                    phi_4984_ = _e2780;
                                } else {
                                    phi_4984_ = _e2783;
                                }
                                let _e2786 = phi_4984_;
                                if (_e2777 > _e2786) {
                                    phi_4989_ = _e2777;
                                } else {
                                    phi_4989_ = _e2786;
                                }
                                let _e2789 = phi_4989_;
                                if (_e2701 < 0f) {
                                    phi_4995_ = -(_e2701);
                                } else {
                                    phi_4995_ = _e2701;
                                }
                                let _e2793 = phi_4995_;
                                if (_e2704 < 0f) {
                                    phi_5001_ = -(_e2704);
                                } else {
                                    phi_5001_ = _e2704;
                                }
                                let _e2797 = phi_5001_;
                                if (_e2707 < 0f) {
                                    phi_5008_ = -(_e2707);
                                } else {
                                    phi_5008_ = _e2707;
                                }
                                let _e2802 = phi_5008_;
                                let _e2803 = ((_e2793 + _e2797) + _e2802);
                                let _e2808 = -(_e2789);
                                if (_e2768 > _e2808) {
                                    phi_5019_ = _e2768;
                                } else {
                                    phi_5019_ = _e2808;
                                }
                                let _e2811 = phi_5019_;
                                let _e2816 = (((_e2811 - ((_e2803 * _e2573) * (0.000000059604645f * (17f / 2f)))) - (_e2803 * _e2580)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2698 > _e2816) {
                                    phi_5029_ = _e2698;
                                } else {
                                    phi_5029_ = _e2816;
                                }
                                let _e2819 = phi_5029_;
                                let _e2820 = (_e2349 - _e2334);
                                let _e2821 = (_e2350 - _e2335);
                                let _e2822 = (_e2351 - _e2336);
                                let _e2825 = ((_e2357 * _e2822) - (_e2360 * _e2821));
                                let _e2828 = ((_e2360 * _e2820) - (_e2354 * _e2822));
                                let _e2831 = ((_e2354 * _e2821) - (_e2357 * _e2820));
                                let _e2836 = (((_e2825 * _e2363[0]) + (_e2828 * _e2363[1])) + (_e2831 * _e2363[2]));
                                let _e2841 = (((_e2825 * _e2379) + (_e2828 * _e2380)) + (_e2831 * _e2381));
                                let _e2846 = (((_e2825 * _e2382) + (_e2828 * _e2383)) + (_e2831 * _e2384));
                                let _e2851 = (((_e2825 * _e2363[0]) + (_e2828 * _e2363[1])) + (_e2831 * _e2363[2]));
                                let _e2856 = (((_e2825 * _e2387[0]) + (_e2828 * _e2387[1])) + (_e2831 * _e2387[2]));
                                let _e2861 = (((_e2825 * _e2403) + (_e2828 * _e2404)) + (_e2831 * _e2405));
                                let _e2866 = (((_e2825 * _e2406) + (_e2828 * _e2407)) + (_e2831 * _e2408));
                                let _e2871 = (((_e2825 * _e2387[0]) + (_e2828 * _e2387[1])) + (_e2831 * _e2387[2]));
                                if (_e2836 < _e2841) {
                                    phi_5102_ = _e2836;
                                } else {
                                    phi_5102_ = _e2841;
                                }
                                let _e2874 = phi_5102_;
                                if (_e2846 < _e2851) {
                                    phi_5107_ = _e2846;
                                } else {
                                    phi_5107_ = _e2851;
                                }
                                let _e2877 = phi_5107_;
                                if (_e2874 < _e2877) {
                                    phi_5112_ = _e2874;
                                } else {
                                    phi_5112_ = _e2877;
                                }
                                let _e2880 = phi_5112_;
                                if (_e2856 < _e2861) {
                                    phi_5117_ = _e2856;
                                } else {
                                    phi_5117_ = _e2861;
                                }
                                let _e2883 = phi_5117_;
                                if (_e2866 < _e2871) {
                                    phi_5122_ = _e2866;
                                } else {
                                    phi_5122_ = _e2871;
                                }
                                let _e2886 = phi_5122_;
                                if (_e2883 < _e2886) {
                                    phi_5127_ = _e2883;
                                } else {
                                    phi_5127_ = _e2886;
                                }
                                let _e2889 = phi_5127_;
                                if (_e2880 < _e2889) {
                                    phi_5132_ = _e2880;
                                } else {
                                    phi_5132_ = _e2889;
                                }
                                let _e2892 = phi_5132_;
                                if (_e2836 > _e2841) {
                                    phi_5137_ = _e2836;
                                } else {
                                    phi_5137_ = _e2841;
                                }
                                let _e2895 = phi_5137_;
                                if (_e2846 > _e2851) {
                                    phi_5142_ = _e2846;
                                } else {
                                    phi_5142_ = _e2851;
                                }
                                let _e2898 = phi_5142_;
                                if (_e2895 > _e2898) {
                                    phi_5147_ = _e2895;
                                } else {
                                    phi_5147_ = _e2898;
                                }
                                let _e2901 = phi_5147_;
                                if (_e2856 > _e2861) {
                                    phi_5152_ = _e2856;
                                } else {
                                    phi_5152_ = _e2861;
                                }
                                let _e2904 = phi_5152_;
                                if (_e2866 > _e2871) {
                                    phi_5157_ = _e2866;
                                } else {
                                    phi_5157_ = _e2871;
                                }
                                let _e2907 = phi_5157_;
                                if (_e2904 > _e2907) {
                                    phi_5162_ = _e2904;
                                } else {
                                    phi_5162_ = _e2907;
                                }
                                let _e2910 = phi_5162_;
                                if (_e2901 > _e2910) {
                                    phi_5167_ = _e2901;
                                } else {
                                    phi_5167_ = _e2910;
                                }
                                let _e2913 = phi_5167_;
                                if (_e2825 < 0f) {
                                    phi_5173_ = -(_e2825);
                                } else {
                                    phi_5173_ = _e2825;
                                }
                                let _e2917 = phi_5173_;
                                if (_e2828 < 0f) {
                                    phi_5179_ = -(_e2828);
                                } else {
                                    phi_5179_ = _e2828;
                                }
                                let _e2921 = phi_5179_;
                                if (_e2831 < 0f) {
                                    phi_5186_ = -(_e2831);
                                } else {
                                    phi_5186_ = _e2831;
                                }
                                let _e2926 = phi_5186_;
                                let _e2927 = ((_e2917 + _e2921) + _e2926);
                                let _e2932 = -(_e2913);
                                if (_e2892 > _e2932) {
                                    phi_5197_ = _e2892;
                                } else {
                                    phi_5197_ = _e2932;
                                }
                                let _e2935 = phi_5197_;
                                let _e2940 = (((_e2935 - ((_e2927 * _e2573) * (0.000000059604645f * (17f / 2f)))) - (_e2927 * _e2580)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2819 > _e2940) {
                                    phi_5207_ = _e2819;
                                } else {
                                    phi_5207_ = _e2940;
                                }
                                let _e2943 = phi_5207_;
                                phi_5211_ = (_e2321 || (_e2943 > 0f));
                            }
                            let _e2947 = phi_5211_;
                            if _e2947 {
                                phi_8628_ = _e2947;
                            } else {
                                let _e2950 = local_2.member[0u];
                                let _e2956 = local_2.member[1u];
                                let _e2963 = ((_e2950[0] + _e2956[0]) * 0.5f);
                                let _e2964 = ((_e2950[1] + _e2956[1]) * 0.5f);
                                let _e2965 = ((_e2950[2] + _e2956[2]) * 0.5f);
                                let _e2968 = local_2.member_1[0u];
                                let _e2974 = local_2.member_1[1u];
                                let _e2981 = ((_e2968[0] + _e2974[0]) * 0.5f);
                                let _e2982 = ((_e2968[1] + _e2974[1]) * 0.5f);
                                let _e2983 = ((_e2968[2] + _e2974[2]) * 0.5f);
                                let _e2986 = local_2.member_2[0u];
                                let _e2992 = local_2.member_2[1u];
                                let _e2999 = ((_e2986[0] + _e2992[0]) * 0.5f);
                                let _e3000 = ((_e2986[1] + _e2992[1]) * 0.5f);
                                let _e3001 = ((_e2986[2] + _e2992[2]) * 0.5f);
                                let _e3004 = local_2.member[0u];
                                let _e3007 = local_2.member_1[0u];
                                let _e3010 = local_2.member_2[0u];
                                let _e3012 = local_2.member_3;
                                let _e3015 = local_2.member[1u];
                                let _e3018 = local_2.member_1[1u];
                                let _e3021 = local_2.member_2[1u];
                                let _e3023 = local_2.member_3;
                                local = type_41(array<array<f32, 3>, 2>(_e3004, array<f32, 3>(_e2963, _e2964, _e2965)), array<array<f32, 3>, 2>(_e3007, array<f32, 3>(_e2981, _e2982, _e2983)), array<array<f32, 3>, 2>(_e3010, array<f32, 3>(_e2999, _e3000, _e3001)), _e3012);
                                local_1 = type_41(array<array<f32, 3>, 2>(array<f32, 3>(_e2963, _e2964, _e2965), _e3015), array<array<f32, 3>, 2>(array<f32, 3>(_e2981, _e2982, _e2983), _e3018), array<array<f32, 3>, 2>(array<f32, 3>(_e2999, _e3000, _e3001), _e3021), _e3023);
                                let _e3040 = local.member_1[0u];
                                let _e3046 = local.member_2[0u];
                                let _e3052 = ((_e3040[1] * _e3046[2]) - (_e3040[2] * _e3046[1]));
                                let _e3055 = ((_e3040[2] * _e3046[0]) - (_e3040[0] * _e3046[2]));
                                let _e3058 = ((_e3040[0] * _e3046[1]) - (_e3040[1] * _e3046[0]));
                                let _e3061 = local.member_1[1u];
                                let _e3067 = local.member_2[1u];
                                let _e3073 = ((_e3061[1] * _e3067[2]) - (_e3061[2] * _e3067[1]));
                                let _e3076 = ((_e3061[2] * _e3067[0]) - (_e3061[0] * _e3067[2]));
                                let _e3079 = ((_e3061[0] * _e3067[1]) - (_e3061[1] * _e3067[0]));
                                let _e3082 = local.member_1[0u];
                                let _e3088 = local.member_2[1u];
                                let _e3103 = local.member_1[1u];
                                let _e3109 = local.member_2[0u];
                                let _e3122 = (((_e3082[1] * _e3088[2]) - (_e3082[2] * _e3088[1])) + ((_e3103[1] * _e3109[2]) - (_e3103[2] * _e3109[1])));
                                let _e3123 = (((_e3082[2] * _e3088[0]) - (_e3082[0] * _e3088[2])) + ((_e3103[2] * _e3109[0]) - (_e3103[0] * _e3109[2])));
                                let _e3124 = (((_e3082[0] * _e3088[1]) - (_e3082[1] * _e3088[0])) + ((_e3103[0] * _e3109[1]) - (_e3103[1] * _e3109[0])));
                                let _e3127 = local.member[0u];
                                let _e3138 = local.member[1u];
                                let _e3149 = local.member[0u];
                                let _e3158 = ((((_e3138[0] * _e3052) + (_e3138[1] * _e3055)) + (_e3138[2] * _e3058)) + (((_e3149[0] * _e3122) + (_e3149[1] * _e3123)) + (_e3149[2] * _e3124)));
                                let _e3161 = local.member[0u];
                                let _e3172 = local.member[1u];
                                let _e3181 = ((((_e3161[0] * _e3073) + (_e3161[1] * _e3076)) + (_e3161[2] * _e3079)) + (((_e3172[0] * _e3122) + (_e3172[1] * _e3123)) + (_e3172[2] * _e3124)));
                                let _e3184 = local.member[1u];
                                let _e3195 = local.member[0u];
                                if (_e3195[0] < 0f) {
                                    phi_5663_ = -(_e3195[0]);
                                } else {
                                    phi_5663_ = _e3195[0];
                                }
                                let _e3202 = phi_5663_;
                                if (_e3195[1] < 0f) {
                                    phi_5670_ = -(_e3195[1]);
                                } else {
                                    phi_5670_ = _e3195[1];
                                }
                                let _e3206 = phi_5670_;
                                if (_e3202 > _e3206) {
                                    phi_5675_ = _e3202;
                                } else {
                                    phi_5675_ = _e3206;
                                }
                                let _e3209 = phi_5675_;
                                if (_e3195[2] < 0f) {
                                    phi_5682_ = -(_e3195[2]);
                                } else {
                                    phi_5682_ = _e3195[2];
                                }
                                let _e3213 = phi_5682_;
                                if (_e3209 > _e3213) {
                                    phi_5687_ = _e3209;
                                } else {
                                    phi_5687_ = _e3213;
                                }
                                let _e3216 = phi_5687_;
                                let _e3219 = local.member[1u];
                                if (_e3219[0] < 0f) {
                                    phi_5700_ = -(_e3219[0]);
                                } else {
                                    phi_5700_ = _e3219[0];
                                }
                                let _e3226 = phi_5700_;
                                if (_e3219[1] < 0f) {
                                    phi_5707_ = -(_e3219[1]);
                                } else {
                                    phi_5707_ = _e3219[1];
                                }
                                let _e3230 = phi_5707_;
                                if (_e3226 > _e3230) {
                                    phi_5712_ = _e3226;
                                } else {
                                    phi_5712_ = _e3230;
                                }
                                let _e3233 = phi_5712_;
                                if (_e3219[2] < 0f) {
                                    phi_5719_ = -(_e3219[2]);
                                } else {
                                    phi_5719_ = _e3219[2];
                                }
                                let _e3237 = phi_5719_;
                                if (_e3233 > _e3237) {
                                    phi_5724_ = _e3233;
                                } else {
                                    phi_5724_ = _e3237;
                                }
                                let _e3240 = phi_5724_;
                                if (_e3216 > _e3240) {
                                    phi_5729_ = _e3216;
                                } else {
                                    phi_5729_ = _e3240;
                                }
                                let _e3243 = phi_5729_;
                                let _e3245 = local.member_3;
                                let _e3246 = (_e3243 + _e3245);
                                let _e3249 = local.member_1[0u];
                                if (_e3249[0] < 0f) {
                                    phi_5746_ = -(_e3249[0]);
                                } else {
                                    phi_5746_ = _e3249[0];
                                }
                                let _e3256 = phi_5746_;
                                if (_e3249[1] < 0f) {
                                    phi_5753_ = -(_e3249[1]);
                                } else {
                                    phi_5753_ = _e3249[1];
                                }
                                let _e3260 = phi_5753_;
                                if (_e3256 > _e3260) {
                                    phi_5758_ = _e3256;
                                } else {
                                    phi_5758_ = _e3260;
                                }
                                let _e3263 = phi_5758_;
                                if (_e3249[2] < 0f) {
                                    phi_5765_ = -(_e3249[2]);
                                } else {
                                    phi_5765_ = _e3249[2];
                                }
                                let _e3267 = phi_5765_;
                                if (_e3263 > _e3267) {
                                    phi_5770_ = _e3263;
                                } else {
                                    phi_5770_ = _e3267;
                                }
                                let _e3270 = phi_5770_;
                                let _e3273 = local.member_1[1u];
                                if (_e3273[0] < 0f) {
                                    phi_5784_ = -(_e3273[0]);
                                } else {
                                    phi_5784_ = _e3273[0];
                                }
                                let _e3280 = phi_5784_;
                                if (_e3273[1] < 0f) {
                                    phi_5791_ = -(_e3273[1]);
                                } else {
                                    phi_5791_ = _e3273[1];
                                }
                                let _e3284 = phi_5791_;
                                if (_e3280 > _e3284) {
                                    phi_5796_ = _e3280;
                                } else {
                                    phi_5796_ = _e3284;
                                }
                                let _e3287 = phi_5796_;
                                if (_e3273[2] < 0f) {
                                    phi_5803_ = -(_e3273[2]);
                                } else {
                                    phi_5803_ = _e3273[2];
                                }
                                let _e3291 = phi_5803_;
                                if (_e3287 > _e3291) {
                                    phi_5808_ = _e3287;
                                } else {
                                    phi_5808_ = _e3291;
                                }
                                let _e3294 = phi_5808_;
                                if (_e3270 > _e3294) {
                                    phi_5813_ = _e3270;
                                } else {
                                    phi_5813_ = _e3294;
                                }
                                let _e3297 = phi_5813_;
                                let _e3299 = local.member_3;
                                let _e3300 = (_e3297 + _e3299);
                                let _e3303 = local.member_2[0u];
                                if (_e3303[0] < 0f) {
                                    phi_5830_ = -(_e3303[0]);
                                } else {
                                    phi_5830_ = _e3303[0];
                                }
                                let _e3310 = phi_5830_;
                                if (_e3303[1] < 0f) {
                                    phi_5837_ = -(_e3303[1]);
                                } else {
                                    phi_5837_ = _e3303[1];
                                }
                                let _e3314 = phi_5837_;
                                if (_e3310 > _e3314) {
                                    phi_5842_ = _e3310;
                                } else {
                                    phi_5842_ = _e3314;
                                }
                                let _e3317 = phi_5842_;
                                if (_e3303[2] < 0f) {
                                    phi_5849_ = -(_e3303[2]);
                                } else {
                                    phi_5849_ = _e3303[2];
                                }
                                let _e3321 = phi_5849_;
                                if (_e3317 > _e3321) {
                                    phi_5854_ = _e3317;
                                } else {
                                    phi_5854_ = _e3321;
                                }
                                let _e3324 = phi_5854_;
                                let _e3327 = local.member_2[1u];
                                if (_e3327[0] < 0f) {
                                    phi_5868_ = -(_e3327[0]);
                                } else {
                                    phi_5868_ = _e3327[0];
                                }
                                let _e3334 = phi_5868_;
                                if (_e3327[1] < 0f) {
                                    phi_5875_ = -(_e3327[1]);
                                } else {
                                    phi_5875_ = _e3327[1];
                                }
                                let _e3338 = phi_5875_;
                                if (_e3334 > _e3338) {
                                    phi_5880_ = _e3334;
                                } else {
                                    phi_5880_ = _e3338;
                                }
                                let _e3341 = phi_5880_;
                                if (_e3327[2] < 0f) {
                                    phi_5887_ = -(_e3327[2]);
                                } else {
                                    phi_5887_ = _e3327[2];
                                }
                                let _e3345 = phi_5887_;
                                if (_e3341 > _e3345) {
                                    phi_5892_ = _e3341;
                                } else {
                                    phi_5892_ = _e3345;
                                }
                                let _e3348 = phi_5892_;
                                if (_e3324 > _e3348) {
                                    phi_5897_ = _e3324;
                                } else {
                                    phi_5897_ = _e3348;
                                }
                                let _e3351 = phi_5897_;
                                let _e3353 = local.member_3;
                                let _e3354 = (_e3351 + _e3353);
                                let _e3356 = ((_e3300 * 8f) * _e3354);
                                let _e3363 = local.member_3;
                                if (_e3052 < 0f) {
                                    phi_5928_ = -(_e3052);
                                } else {
                                    phi_5928_ = _e3052;
                                }
                                let _e3380 = phi_5928_;
                                if (_e3055 < 0f) {
                                    phi_5934_ = -(_e3055);
                                } else {
                                    phi_5934_ = _e3055;
                                }
                                let _e3384 = phi_5934_;
                                if (_e3058 < 0f) {
                                    phi_5941_ = -(_e3058);
                                } else {
                                    phi_5941_ = _e3058;
                                }
                                let _e3389 = phi_5941_;
                                let _e3390 = ((_e3380 + _e3384) + _e3389);
                                if (_e3073 < 0f) {
                                    phi_5948_ = -(_e3073);
                                } else {
                                    phi_5948_ = _e3073;
                                }
                                let _e3394 = phi_5948_;
                                if (_e3076 < 0f) {
                                    phi_5954_ = -(_e3076);
                                } else {
                                    phi_5954_ = _e3076;
                                }
                                let _e3398 = phi_5954_;
                                if (_e3079 < 0f) {
                                    phi_5961_ = -(_e3079);
                                } else {
                                    phi_5961_ = _e3079;
                                }
                                let _e3403 = phi_5961_;
                                let _e3404 = ((_e3394 + _e3398) + _e3403);
                                if (_e3390 > _e3404) {
                                    phi_5967_ = _e3390;
                                } else {
                                    phi_5967_ = _e3404;
                                }
                                let _e3407 = phi_5967_;
                                if (_e3122 < 0f) {
                                    phi_5973_ = -(_e3122);
                                } else {
                                    phi_5973_ = _e3122;
                                }
                                let _e3411 = phi_5973_;
                                if (_e3123 < 0f) {
                                    phi_5979_ = -(_e3123);
                                } else {
                                    phi_5979_ = _e3123;
                                }
                                let _e3415 = phi_5979_;
                                if (_e3124 < 0f) {
                                    phi_5986_ = -(_e3124);
                                } else {
                                    phi_5986_ = _e3124;
                                }
                                let _e3420 = phi_5986_;
                                let _e3422 = (((_e3411 + _e3415) + _e3420) * 0.5f);
                                if (_e3407 > _e3422) {
                                    phi_5993_ = _e3407;
                                } else {
                                    phi_5993_ = _e3422;
                                }
                                let _e3425 = phi_5993_;
                                let _e3430 = local.member_3;
                                let _e3443 = ((((_e3127[0] * _e3052) + (_e3127[1] * _e3055)) + (_e3127[2] * _e3058)) * 3f);
                                let _e3444 = ((((_e3184[0] * _e3073) + (_e3184[1] * _e3076)) + (_e3184[2] * _e3079)) * 3f);
                                if (_e3443 < _e3444) {
                                    phi_6017_ = _e3443;
                                } else {
                                    phi_6017_ = _e3444;
                                }
                                let _e3447 = phi_6017_;
                                if (_e3158 < _e3181) {
                                    phi_6022_ = _e3158;
                                } else {
                                    phi_6022_ = _e3181;
                                }
                                let _e3450 = phi_6022_;
                                if (_e3447 < _e3450) {
                                    phi_6027_ = _e3447;
                                } else {
                                    phi_6027_ = _e3450;
                                }
                                let _e3453 = phi_6027_;
                                if (_e3443 > _e3444) {
                                    phi_6032_ = _e3443;
                                } else {
                                    phi_6032_ = _e3444;
                                }
                                let _e3456 = phi_6032_;
                                if (_e3158 > _e3181) {
                                    phi_6037_ = _e3158;
                                } else {
                                    phi_6037_ = _e3181;
                                }
                                let _e3459 = phi_6037_;
                                if (_e3456 > _e3459) {
                                    phi_6042_ = _e3456;
                                } else {
                                    phi_6042_ = _e3459;
                                }
                                let _e3462 = phi_6042_;
                                let _e3467 = -(_e3462);
                                if (_e3453 > _e3467) {
                                    phi_6052_ = _e3453;
                                } else {
                                    phi_6052_ = _e3467;
                                }
                                let _e3470 = phi_6052_;
                                let _e3472 = ((_e3470 - ((((((_e3246 * 8f) * _e3356) * (0.000000059604645f * (524f / 64f))) + ((_e3363 * 19f) * ((_e3246 * (_e3300 + _e3354)) + (_e3300 * _e3354)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3246) * ((1f + _e3300) * (1f + _e3354))))) + ((_e1817 * (((_e3425 + (_e3356 * (0.000000059604645f * 8f))) + ((_e3430 * 6f) * (_e3300 + _e3354))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3300) * (1f + _e3354))))) * (3f * 1.0001f)))) > 0f);
                                if _e3472 {
                                    phi_7021_ = _e3472;
                                } else {
                                    let _e3475 = local.member_1[0u];
                                    let _e3481 = local.member_1[1u];
                                    let _e3485 = (_e3475[0] + _e3481[0]);
                                    let _e3486 = (_e3475[1] + _e3481[1]);
                                    let _e3487 = (_e3475[2] + _e3481[2]);
                                    let _e3490 = local.member_2[0u];
                                    let _e3496 = local.member_2[1u];
                                    let _e3500 = (_e3490[0] + _e3496[0]);
                                    let _e3501 = (_e3490[1] + _e3496[1]);
                                    let _e3502 = (_e3490[2] + _e3496[2]);
                                    let _e3505 = ((_e3486 * _e3502) - (_e3487 * _e3501));
                                    let _e3508 = ((_e3487 * _e3500) - (_e3485 * _e3502));
                                    let _e3511 = ((_e3485 * _e3501) - (_e3486 * _e3500));
                                    let _e3514 = local.member[0u];
                                    let _e3520 = local.member_1[0u];
                                    let _e3526 = local.member_2[0u];
                                    let _e3530 = (_e3514[0] - _e3520[0]);
                                    let _e3531 = (_e3514[1] - _e3520[1]);
                                    let _e3532 = (_e3514[2] - _e3520[2]);
                                    let _e3533 = (_e3514[0] - _e3526[0]);
                                    let _e3534 = (_e3514[1] - _e3526[1]);
                                    let _e3535 = (_e3514[2] - _e3526[2]);
                                    let _e3538 = local.member[1u];
                                    let _e3544 = local.member_1[1u];
                                    let _e3550 = local.member_2[1u];
                                    let _e3554 = (_e3538[0] - _e3544[0]);
                                    let _e3555 = (_e3538[1] - _e3544[1]);
                                    let _e3556 = (_e3538[2] - _e3544[2]);
                                    let _e3557 = (_e3538[0] - _e3550[0]);
                                    let _e3558 = (_e3538[1] - _e3550[1]);
                                    let _e3559 = (_e3538[2] - _e3550[2]);
                                    let _e3562 = local.member[0u];
                                    if (_e3562[0] < 0f) {
                                        phi_6255_ = -(_e3562[0]);
                                    } else {
                                        phi_6255_ = _e3562[0];
                                    }
                                    let _e3569 = phi_6255_;
                                    if (_e3562[1] < 0f) {
                                        phi_6262_ = -(_e3562[1]);
                                    } else {
                                        phi_6262_ = _e3562[1];
                                    }
                                    let _e3573 = phi_6262_;
                                    if (_e3569 > _e3573) {
                                        phi_6267_ = _e3569;
                                    } else {
                                        phi_6267_ = _e3573;
                                    }
                                    let _e3576 = phi_6267_;
                                    if (_e3562[2] < 0f) {
                                        phi_6274_ = -(_e3562[2]);
                                    } else {
                                        phi_6274_ = _e3562[2];
                                    }
                                    let _e3580 = phi_6274_;
                                    if (_e3576 > _e3580) {
                                        phi_6279_ = _e3576;
                                    } else {
                                        phi_6279_ = _e3580;
                                    }
                                    let _e3583 = phi_6279_;
                                    let _e3586 = local.member[1u];
                                    if (_e3586[0] < 0f) {
                                        phi_6292_ = -(_e3586[0]);
                                    } else {
                                        phi_6292_ = _e3586[0];
                                    }
                                    let _e3593 = phi_6292_;
                                    if (_e3586[1] < 0f) {
                                        phi_6299_ = -(_e3586[1]);
                                    } else {
                                        phi_6299_ = _e3586[1];
                                    }
                                    let _e3597 = phi_6299_;
                                    if (_e3593 > _e3597) {
                                        phi_6304_ = _e3593;
                                    } else {
                                        phi_6304_ = _e3597;
                                    }
                                    let _e3600 = phi_6304_;
                                    if (_e3586[2] < 0f) {
                                        phi_6311_ = -(_e3586[2]);
                                    } else {
                                        phi_6311_ = _e3586[2];
                                    }
                                    let _e3604 = phi_6311_;
                                    if (_e3600 > _e3604) {
                                        phi_6316_ = _e3600;
                                    } else {
                                        phi_6316_ = _e3604;
                                    }
                                    let _e3607 = phi_6316_;
                                    if (_e3583 > _e3607) {
                                        phi_6321_ = _e3583;
                                    } else {
                                        phi_6321_ = _e3607;
                                    }
                                    let _e3610 = phi_6321_;
                                    let _e3612 = local.member_3;
                                    let _e3616 = local.member_1[0u];
                                    if (_e3616[0] < 0f) {
                                        phi_6338_ = -(_e3616[0]);
                                    } else {
                                        phi_6338_ = _e3616[0];
                                    }
                                    let _e3623 = phi_6338_;
                                    if (_e3616[1] < 0f) {
                                        phi_6345_ = -(_e3616[1]);
                                    } else {
                                        phi_6345_ = _e3616[1];
                                    }
                                    let _e3627 = phi_6345_;
                                    if (_e3623 > _e3627) {
                                        phi_6350_ = _e3623;
                                    } else {
                                        phi_6350_ = _e3627;
                                    }
                                    let _e3630 = phi_6350_;
                                    if (_e3616[2] < 0f) {
                                        phi_6357_ = -(_e3616[2]);
                                    } else {
                                        phi_6357_ = _e3616[2];
                                    }
                                    let _e3634 = phi_6357_;
                                    if (_e3630 > _e3634) {
                                        phi_6362_ = _e3630;
                                    } else {
                                        phi_6362_ = _e3634;
                                    }
                                    let _e3637 = phi_6362_;
                                    let _e3640 = local.member_1[1u];
                                    if (_e3640[0] < 0f) {
                                        phi_6376_ = -(_e3640[0]);
                                    } else {
                                        phi_6376_ = _e3640[0];
                                    }
                                    let _e3647 = phi_6376_;
                                    if (_e3640[1] < 0f) {
                                        phi_6383_ = -(_e3640[1]);
                                    } else {
                                        phi_6383_ = _e3640[1];
                                    }
                                    let _e3651 = phi_6383_;
                                    if (_e3647 > _e3651) {
                                        phi_6388_ = _e3647;
                                    } else {
                                        phi_6388_ = _e3651;
                                    }
                                    let _e3654 = phi_6388_;
                                    if (_e3640[2] < 0f) {
                                        phi_6395_ = -(_e3640[2]);
                                    } else {
                                        phi_6395_ = _e3640[2];
                                    }
                                    let _e3658 = phi_6395_;
                                    if (_e3654 > _e3658) {
                                        phi_6400_ = _e3654;
                                    } else {
                                        phi_6400_ = _e3658;
                                    }
                                    let _e3661 = phi_6400_;
                                    if (_e3637 > _e3661) {
                                        phi_6405_ = _e3637;
                                    } else {
                                        phi_6405_ = _e3661;
                                    }
                                    let _e3664 = phi_6405_;
                                    let _e3666 = local.member_3;
                                    let _e3670 = local.member_2[0u];
                                    if (_e3670[0] < 0f) {
                                        phi_6422_ = -(_e3670[0]);
                                    } else {
                                        phi_6422_ = _e3670[0];
                                    }
                                    let _e3677 = phi_6422_;
                                    if (_e3670[1] < 0f) {
                                        phi_6429_ = -(_e3670[1]);
                                    } else {
                                        phi_6429_ = _e3670[1];
                                    }
                                    let _e3681 = phi_6429_;
                                    if (_e3677 > _e3681) {
                                        phi_6434_ = _e3677;
                                    } else {
                                        phi_6434_ = _e3681;
                                    }
                                    let _e3684 = phi_6434_;
                                    if (_e3670[2] < 0f) {
                                        phi_6441_ = -(_e3670[2]);
                                    } else {
                                        phi_6441_ = _e3670[2];
                                    }
                                    let _e3688 = phi_6441_;
                                    if (_e3684 > _e3688) {
                                        phi_6446_ = _e3684;
                                    } else {
                                        phi_6446_ = _e3688;
                                    }
                                    let _e3691 = phi_6446_;
                                    let _e3694 = local.member_2[1u];
                                    if (_e3694[0] < 0f) {
                                        phi_6460_ = -(_e3694[0]);
                                    } else {
                                        phi_6460_ = _e3694[0];
                                    }
                                    let _e3701 = phi_6460_;
                                    if (_e3694[1] < 0f) {
                                        phi_6467_ = -(_e3694[1]);
                                    } else {
                                        phi_6467_ = _e3694[1];
                                    }
                                    let _e3705 = phi_6467_;
                                    if (_e3701 > _e3705) {
                                        phi_6472_ = _e3701;
                                    } else {
                                        phi_6472_ = _e3705;
                                    }
                                    let _e3708 = phi_6472_;
                                    if (_e3694[2] < 0f) {
                                        phi_6479_ = -(_e3694[2]);
                                    } else {
                                        phi_6479_ = _e3694[2];
                                    }
                                    let _e3712 = phi_6479_;
                                    if (_e3708 > _e3712) {
                                        phi_6484_ = _e3708;
                                    } else {
                                        phi_6484_ = _e3712;
                                    }
                                    let _e3715 = phi_6484_;
                                    if (_e3691 > _e3715) {
                                        phi_6489_ = _e3691;
                                    } else {
                                        phi_6489_ = _e3715;
                                    }
                                    let _e3718 = phi_6489_;
                                    let _e3720 = local.member_3;
                                    let _e3724 = ((((_e3610 + _e3612) + (_e3664 + _e3666)) + (_e3718 + _e3720)) * 2f);
                                    let _e3727 = local.member_3;
                                    let _e3731 = (((_e1817 * 1.0001f) + (_e3727 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3734 = ((_e3508 * _e3487) - (_e3511 * _e3486));
                                    let _e3737 = ((_e3511 * _e3485) - (_e3505 * _e3487));
                                    let _e3740 = ((_e3505 * _e3486) - (_e3508 * _e3485));
                                    let _e3745 = (((_e3734 * _e3514[0]) + (_e3737 * _e3514[1])) + (_e3740 * _e3514[2]));
                                    let _e3750 = (((_e3734 * _e3530) + (_e3737 * _e3531)) + (_e3740 * _e3532));
                                    let _e3755 = (((_e3734 * _e3533) + (_e3737 * _e3534)) + (_e3740 * _e3535));
                                    let _e3760 = (((_e3734 * _e3514[0]) + (_e3737 * _e3514[1])) + (_e3740 * _e3514[2]));
                                    let _e3765 = (((_e3734 * _e3538[0]) + (_e3737 * _e3538[1])) + (_e3740 * _e3538[2]));
                                    let _e3770 = (((_e3734 * _e3554) + (_e3737 * _e3555)) + (_e3740 * _e3556));
                                    let _e3775 = (((_e3734 * _e3557) + (_e3737 * _e3558)) + (_e3740 * _e3559));
                                    let _e3780 = (((_e3734 * _e3538[0]) + (_e3737 * _e3538[1])) + (_e3740 * _e3538[2]));
                                    if (_e3745 < _e3750) {
                                        phi_6568_ = _e3745;
                                    } else {
                                        phi_6568_ = _e3750;
                                    }
                                    let _e3783 = phi_6568_;
                                    if (_e3755 < _e3760) {
                                        phi_6573_ = _e3755;
                                    } else {
                                        phi_6573_ = _e3760;
                                    }
                                    let _e3786 = phi_6573_;
                                    if (_e3783 < _e3786) {
                                        phi_6578_ = _e3783;
                                    } else {
                                        phi_6578_ = _e3786;
                                    }
                                    let _e3789 = phi_6578_;
                                    if (_e3765 < _e3770) {
                                        phi_6583_ = _e3765;
                                    } else {
                                        phi_6583_ = _e3770;
                                    }
                                    let _e3792 = phi_6583_;
                                    if (_e3775 < _e3780) {
                                        phi_6588_ = _e3775;
                                    } else {
                                        phi_6588_ = _e3780;
                                    }
                                    let _e3795 = phi_6588_;
                                    if (_e3792 < _e3795) {
                                        phi_6593_ = _e3792;
                                    } else {
                                        phi_6593_ = _e3795;
                                    }
                                    let _e3798 = phi_6593_;
                                    if (_e3789 < _e3798) {
                                        phi_6598_ = _e3789;
                                    } else {
                                        phi_6598_ = _e3798;
                                    }
                                    let _e3801 = phi_6598_;
                                    if (_e3745 > _e3750) {
                                        phi_6603_ = _e3745;
                                    } else {
                                        phi_6603_ = _e3750;
                                    }
                                    let _e3804 = phi_6603_;
                                    if (_e3755 > _e3760) {
                                        phi_6608_ = _e3755;
                                    } else {
                                        phi_6608_ = _e3760;
                                    }
                                    let _e3807 = phi_6608_;
                                    if (_e3804 > _e3807) {
                                        phi_6613_ = _e3804;
                                    } else {
                                        phi_6613_ = _e3807;
                                    }
                                    let _e3810 = phi_6613_;
                                    if (_e3765 > _e3770) {
                                        phi_6618_ = _e3765;
                                    } else {
                                        phi_6618_ = _e3770;
                                    }
                                    let _e3813 = phi_6618_;
                                    if (_e3775 > _e3780) {
                                        phi_6623_ = _e3775;
                                    } else {
                                        phi_6623_ = _e3780;
                                    }
                                    let _e3816 = phi_6623_;
                                    if (_e3813 > _e3816) {
                                        phi_6628_ = _e3813;
                                    } else {
                                        phi_6628_ = _e3816;
                                    }
                                    let _e3819 = phi_6628_;
                                    if (_e3810 > _e3819) {
                                        phi_6633_ = _e3810;
                                    } else {
                                        phi_6633_ = _e3819;
                                    }
                                    let _e3822 = phi_6633_;
                                    if (_e3734 < 0f) {
                                        phi_6639_ = -(_e3734);
                                    } else {
                                        phi_6639_ = _e3734;
                                    }
                                    let _e3826 = phi_6639_;
                                    if (_e3737 < 0f) {
                                        phi_6645_ = -(_e3737);
                                    } else {
                                        phi_6645_ = _e3737;
                                    }
                                    let _e3830 = phi_6645_;
                                    if (_e3740 < 0f) {
                                        phi_6652_ = -(_e3740);
                                    } else {
                                        phi_6652_ = _e3740;
                                    }
                                    let _e3835 = phi_6652_;
                                    let _e3836 = ((_e3826 + _e3830) + _e3835);
                                    let _e3841 = -(_e3822);
                                    if (_e3801 > _e3841) {
                                        phi_6663_ = _e3801;
                                    } else {
                                        phi_6663_ = _e3841;
                                    }
                                    let _e3844 = phi_6663_;
                                    let _e3849 = (((_e3844 - ((_e3836 * _e3724) * (0.000000059604645f * (17f / 2f)))) - (_e3836 * _e3731)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3852 = ((_e3508 * _e3502) - (_e3511 * _e3501));
                                    let _e3855 = ((_e3511 * _e3500) - (_e3505 * _e3502));
                                    let _e3858 = ((_e3505 * _e3501) - (_e3508 * _e3500));
                                    let _e3863 = (((_e3852 * _e3514[0]) + (_e3855 * _e3514[1])) + (_e3858 * _e3514[2]));
                                    let _e3868 = (((_e3852 * _e3530) + (_e3855 * _e3531)) + (_e3858 * _e3532));
                                    let _e3873 = (((_e3852 * _e3533) + (_e3855 * _e3534)) + (_e3858 * _e3535));
                                    let _e3878 = (((_e3852 * _e3514[0]) + (_e3855 * _e3514[1])) + (_e3858 * _e3514[2]));
                                    let _e3883 = (((_e3852 * _e3538[0]) + (_e3855 * _e3538[1])) + (_e3858 * _e3538[2]));
                                    let _e3888 = (((_e3852 * _e3554) + (_e3855 * _e3555)) + (_e3858 * _e3556));
                                    let _e3893 = (((_e3852 * _e3557) + (_e3855 * _e3558)) + (_e3858 * _e3559));
                                    let _e3898 = (((_e3852 * _e3538[0]) + (_e3855 * _e3538[1])) + (_e3858 * _e3538[2]));
                                    if (_e3863 < _e3868) {
                                        phi_6734_ = _e3863;
                                    } else {
                                        phi_6734_ = _e3868;
                                    }
                                    let _e3901 = phi_6734_;
                                    if (_e3873 < _e3878) {
                                        phi_6739_ = _e3873;
                                    } else {
                                        phi_6739_ = _e3878;
                                    }
                                    let _e3904 = phi_6739_;
                                    if (_e3901 < _e3904) {
                                        phi_6744_ = _e3901;
                                    } else {
                                        phi_6744_ = _e3904;
                                    }
                                    let _e3907 = phi_6744_;
                                    if (_e3883 < _e3888) {
                                        phi_6749_ = _e3883;
                                    } else {
                                        phi_6749_ = _e3888;
                                    }
                                    let _e3910 = phi_6749_;
                                    if (_e3893 < _e3898) {
                                        phi_6754_ = _e3893;
                                    } else {
                                        phi_6754_ = _e3898;
                                    }
                                    let _e3913 = phi_6754_;
                                    if (_e3910 < _e3913) {
                                        phi_6759_ = _e3910;
                                    } else {
                                        phi_6759_ = _e3913;
                                    }
                                    let _e3916 = phi_6759_;
                                    if (_e3907 < _e3916) {
                                        phi_6764_ = _e3907;
                                    } else {
                                        phi_6764_ = _e3916;
                                    }
                                    let _e3919 = phi_6764_;
                                    if (_e3863 > _e3868) {
                                        phi_6769_ = _e3863;
                                    } else {
                                        phi_6769_ = _e3868;
                                    }
                                    let _e3922 = phi_6769_;
                                    if (_e3873 > _e3878) {
                                        phi_6774_ = _e3873;
                                    } else {
                                        phi_6774_ = _e3878;
                                    }
                                    let _e3925 = phi_6774_;
                                    if (_e3922 > _e3925) {
                                        phi_6779_ = _e3922;
                                    } else {
                                        phi_6779_ = _e3925;
                                    }
                                    let _e3928 = phi_6779_;
                                    if (_e3883 > _e3888) {
                                        phi_6784_ = _e3883;
                                    } else {
                                        phi_6784_ = _e3888;
                                    }
                                    let _e3931 = phi_6784_;
                                    if (_e3893 > _e3898) {
                                        phi_6789_ = _e3893;
                                    } else {
                                        phi_6789_ = _e3898;
                                    }
                                    let _e3934 = phi_6789_;
                                    if (_e3931 > _e3934) {
                                        phi_6794_ = _e3931;
                                    } else {
                                        phi_6794_ = _e3934;
                                    }
                                    let _e3937 = phi_6794_;
                                    if (_e3928 > _e3937) {
                                        phi_6799_ = _e3928;
                                    } else {
                                        phi_6799_ = _e3937;
                                    }
                                    let _e3940 = phi_6799_;
                                    if (_e3852 < 0f) {
                                        phi_6805_ = -(_e3852);
                                    } else {
                                        phi_6805_ = _e3852;
                                    }
                                    let _e3944 = phi_6805_;
                                    if (_e3855 < 0f) {
                                        phi_6811_ = -(_e3855);
                                    } else {
                                        phi_6811_ = _e3855;
                                    }
                                    let _e3948 = phi_6811_;
                                    if (_e3858 < 0f) {
                                        phi_6818_ = -(_e3858);
                                    } else {
                                        phi_6818_ = _e3858;
                                    }
                                    let _e3953 = phi_6818_;
                                    let _e3954 = ((_e3944 + _e3948) + _e3953);
                                    let _e3959 = -(_e3940);
                                    if (_e3919 > _e3959) {
                                        phi_6829_ = _e3919;
                                    } else {
                                        phi_6829_ = _e3959;
                                    }
                                    let _e3962 = phi_6829_;
                                    let _e3967 = (((_e3962 - ((_e3954 * _e3724) * (0.000000059604645f * (17f / 2f)))) - (_e3954 * _e3731)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3849 > _e3967) {
                                        phi_6839_ = _e3849;
                                    } else {
                                        phi_6839_ = _e3967;
                                    }
                                    let _e3970 = phi_6839_;
                                    let _e3971 = (_e3500 - _e3485);
                                    let _e3972 = (_e3501 - _e3486);
                                    let _e3973 = (_e3502 - _e3487);
                                    let _e3976 = ((_e3508 * _e3973) - (_e3511 * _e3972));
                                    let _e3979 = ((_e3511 * _e3971) - (_e3505 * _e3973));
                                    let _e3982 = ((_e3505 * _e3972) - (_e3508 * _e3971));
                                    let _e3987 = (((_e3976 * _e3514[0]) + (_e3979 * _e3514[1])) + (_e3982 * _e3514[2]));
                                    let _e3992 = (((_e3976 * _e3530) + (_e3979 * _e3531)) + (_e3982 * _e3532));
                                    let _e3997 = (((_e3976 * _e3533) + (_e3979 * _e3534)) + (_e3982 * _e3535));
                                    let _e4002 = (((_e3976 * _e3514[0]) + (_e3979 * _e3514[1])) + (_e3982 * _e3514[2]));
                                    let _e4007 = (((_e3976 * _e3538[0]) + (_e3979 * _e3538[1])) + (_e3982 * _e3538[2]));
                                    let _e4012 = (((_e3976 * _e3554) + (_e3979 * _e3555)) + (_e3982 * _e3556));
                                    let _e4017 = (((_e3976 * _e3557) + (_e3979 * _e3558)) + (_e3982 * _e3559));
                                    let _e4022 = (((_e3976 * _e3538[0]) + (_e3979 * _e3538[1])) + (_e3982 * _e3538[2]));
                                    if (_e3987 < _e3992) {
                                        phi_6912_ = _e3987;
                                    } else {
                                        phi_6912_ = _e3992;
                                    }
                                    let _e4025 = phi_6912_;
                                    if (_e3997 < _e4002) {
                                        phi_6917_ = _e3997;
                                    } else {
                                        phi_6917_ = _e4002;
                                    }
                                    let _e4028 = phi_6917_;
                                    if (_e4025 < _e4028) {
                                        phi_6922_ = _e4025;
                                    } else {
                                        phi_6922_ = _e4028;
                                    }
                                    let _e4031 = phi_6922_;
                                    if (_e4007 < _e4012) {
                                        phi_6927_ = _e4007;
                                    } else {
                                        phi_6927_ = _e4012;
                                    }
                                    let _e4034 = phi_6927_;
                                    if (_e4017 < _e4022) {
                                        phi_6932_ = _e4017;
                                    } else {
                                        phi_6932_ = _e4022;
                                    }
                                    let _e4037 = phi_6932_;
                                    if (_e4034 < _e4037) {
                                        phi_6937_ = _e4034;
                                    } else {
                                        phi_6937_ = _e4037;
                                    }
                                    let _e4040 = phi_6937_;
                                    if (_e4031 < _e4040) {
                                        phi_6942_ = _e4031;
                                    } else {
                                        phi_6942_ = _e4040;
                                    }
                                    let _e4043 = phi_6942_;
                                    if (_e3987 > _e3992) {
                                        phi_6947_ = _e3987;
                                    } else {
                                        phi_6947_ = _e3992;
                                    }
                                    let _e4046 = phi_6947_;
                                    if (_e3997 > _e4002) {
                                        phi_6952_ = _e3997;
                                    } else {
                                        phi_6952_ = _e4002;
                                    }
                                    let _e4049 = phi_6952_;
                                    if (_e4046 > _e4049) {
                                        phi_6957_ = _e4046;
                                    } else {
                                        phi_6957_ = _e4049;
                                    }
                                    let _e4052 = phi_6957_;
                                    if (_e4007 > _e4012) {
                                        phi_6962_ = _e4007;
                                    } else {
                                        phi_6962_ = _e4012;
                                    }
                                    let _e4055 = phi_6962_;
                                    if (_e4017 > _e4022) {
                                        phi_6967_ = _e4017;
                                    } else {
                                        phi_6967_ = _e4022;
                                    }
                                    let _e4058 = phi_6967_;
                                    if (_e4055 > _e4058) {
                                        phi_6972_ = _e4055;
                                    } else {
                                        phi_6972_ = _e4058;
                                    }
                                    let _e4061 = phi_6972_;
                                    if (_e4052 > _e4061) {
                                        phi_6977_ = _e4052;
                                    } else {
                                        phi_6977_ = _e4061;
                                    }
                                    let _e4064 = phi_6977_;
                                    if (_e3976 < 0f) {
                                        phi_6983_ = -(_e3976);
                                    } else {
                                        phi_6983_ = _e3976;
                                    }
                                    let _e4068 = phi_6983_;
                                    if (_e3979 < 0f) {
                                        phi_6989_ = -(_e3979);
                                    } else {
                                        phi_6989_ = _e3979;
                                    }
                                    let _e4072 = phi_6989_;
                                    if (_e3982 < 0f) {
                                        phi_6996_ = -(_e3982);
                                    } else {
                                        phi_6996_ = _e3982;
                                    }
                                    let _e4077 = phi_6996_;
                                    let _e4078 = ((_e4068 + _e4072) + _e4077);
                                    let _e4083 = -(_e4064);
                                    if (_e4043 > _e4083) {
                                        phi_7007_ = _e4043;
                                    } else {
                                        phi_7007_ = _e4083;
                                    }
                                    let _e4086 = phi_7007_;
                                    let _e4091 = (((_e4086 - ((_e4078 * _e3724) * (0.000000059604645f * (17f / 2f)))) - (_e4078 * _e3731)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3970 > _e4091) {
                                        phi_7017_ = _e3970;
                                    } else {
                                        phi_7017_ = _e4091;
                                    }
                                    let _e4094 = phi_7017_;
                                    phi_7021_ = (_e3472 || (_e4094 > 0f));
                                }
                                let _e4098 = phi_7021_;
                                if _e4098 {
                                    let _e4101 = local_1.member_1[0u];
                                    let _e4107 = local_1.member_2[0u];
                                    let _e4113 = ((_e4101[1] * _e4107[2]) - (_e4101[2] * _e4107[1]));
                                    let _e4116 = ((_e4101[2] * _e4107[0]) - (_e4101[0] * _e4107[2]));
                                    let _e4119 = ((_e4101[0] * _e4107[1]) - (_e4101[1] * _e4107[0]));
                                    let _e4122 = local_1.member_1[1u];
                                    let _e4128 = local_1.member_2[1u];
                                    let _e4134 = ((_e4122[1] * _e4128[2]) - (_e4122[2] * _e4128[1]));
                                    let _e4137 = ((_e4122[2] * _e4128[0]) - (_e4122[0] * _e4128[2]));
                                    let _e4140 = ((_e4122[0] * _e4128[1]) - (_e4122[1] * _e4128[0]));
                                    let _e4143 = local_1.member_1[0u];
                                    let _e4149 = local_1.member_2[1u];
                                    let _e4164 = local_1.member_1[1u];
                                    let _e4170 = local_1.member_2[0u];
                                    let _e4183 = (((_e4143[1] * _e4149[2]) - (_e4143[2] * _e4149[1])) + ((_e4164[1] * _e4170[2]) - (_e4164[2] * _e4170[1])));
                                    let _e4184 = (((_e4143[2] * _e4149[0]) - (_e4143[0] * _e4149[2])) + ((_e4164[2] * _e4170[0]) - (_e4164[0] * _e4170[2])));
                                    let _e4185 = (((_e4143[0] * _e4149[1]) - (_e4143[1] * _e4149[0])) + ((_e4164[0] * _e4170[1]) - (_e4164[1] * _e4170[0])));
                                    let _e4188 = local_1.member[0u];
                                    let _e4199 = local_1.member[1u];
                                    let _e4210 = local_1.member[0u];
                                    let _e4219 = ((((_e4199[0] * _e4113) + (_e4199[1] * _e4116)) + (_e4199[2] * _e4119)) + (((_e4210[0] * _e4183) + (_e4210[1] * _e4184)) + (_e4210[2] * _e4185)));
                                    let _e4222 = local_1.member[0u];
                                    let _e4233 = local_1.member[1u];
                                    let _e4242 = ((((_e4222[0] * _e4134) + (_e4222[1] * _e4137)) + (_e4222[2] * _e4140)) + (((_e4233[0] * _e4183) + (_e4233[1] * _e4184)) + (_e4233[2] * _e4185)));
                                    let _e4245 = local_1.member[1u];
                                    let _e4256 = local_1.member[0u];
                                    if (_e4256[0] < 0f) {
                                        phi_7266_ = -(_e4256[0]);
                                    } else {
                                        phi_7266_ = _e4256[0];
                                    }
                                    let _e4263 = phi_7266_;
                                    if (_e4256[1] < 0f) {
                                        phi_7273_ = -(_e4256[1]);
                                    } else {
                                        phi_7273_ = _e4256[1];
                                    }
                                    let _e4267 = phi_7273_;
                                    if (_e4263 > _e4267) {
                                        phi_7278_ = _e4263;
                                    } else {
                                        phi_7278_ = _e4267;
                                    }
                                    let _e4270 = phi_7278_;
                                    if (_e4256[2] < 0f) {
                                        phi_7285_ = -(_e4256[2]);
                                    } else {
                                        phi_7285_ = _e4256[2];
                                    }
                                    let _e4274 = phi_7285_;
                                    if (_e4270 > _e4274) {
                                        phi_7290_ = _e4270;
                                    } else {
                                        phi_7290_ = _e4274;
                                    }
                                    let _e4277 = phi_7290_;
                                    let _e4280 = local_1.member[1u];
                                    if (_e4280[0] < 0f) {
                                        phi_7303_ = -(_e4280[0]);
                                    } else {
                                        phi_7303_ = _e4280[0];
                                    }
                                    let _e4287 = phi_7303_;
                                    if (_e4280[1] < 0f) {
                                        phi_7310_ = -(_e4280[1]);
                                    } else {
                                        phi_7310_ = _e4280[1];
                                    }
                                    let _e4291 = phi_7310_;
                                    if (_e4287 > _e4291) {
                                        phi_7315_ = _e4287;
                                    } else {
                                        phi_7315_ = _e4291;
                                    }
                                    let _e4294 = phi_7315_;
                                    if (_e4280[2] < 0f) {
                                        phi_7322_ = -(_e4280[2]);
                                    } else {
                                        phi_7322_ = _e4280[2];
                                    }
                                    let _e4298 = phi_7322_;
                                    if (_e4294 > _e4298) {
                                        phi_7327_ = _e4294;
                                    } else {
                                        phi_7327_ = _e4298;
                                    }
                                    let _e4301 = phi_7327_;
                                    if (_e4277 > _e4301) {
                                        phi_7332_ = _e4277;
                                    } else {
                                        phi_7332_ = _e4301;
                                    }
                                    let _e4304 = phi_7332_;
                                    let _e4306 = local_1.member_3;
                                    let _e4307 = (_e4304 + _e4306);
                                    let _e4310 = local_1.member_1[0u];
                                    if (_e4310[0] < 0f) {
                                        phi_7349_ = -(_e4310[0]);
                                    } else {
                                        phi_7349_ = _e4310[0];
                                    }
                                    let _e4317 = phi_7349_;
                                    if (_e4310[1] < 0f) {
                                        phi_7356_ = -(_e4310[1]);
                                    } else {
                                        phi_7356_ = _e4310[1];
                                    }
                                    let _e4321 = phi_7356_;
                                    if (_e4317 > _e4321) {
                                        phi_7361_ = _e4317;
                                    } else {
                                        phi_7361_ = _e4321;
                                    }
                                    let _e4324 = phi_7361_;
                                    if (_e4310[2] < 0f) {
                                        phi_7368_ = -(_e4310[2]);
                                    } else {
                                        phi_7368_ = _e4310[2];
                                    }
                                    let _e4328 = phi_7368_;
                                    if (_e4324 > _e4328) {
                                        phi_7373_ = _e4324;
                                    } else {
                                        phi_7373_ = _e4328;
                                    }
                                    let _e4331 = phi_7373_;
                                    let _e4334 = local_1.member_1[1u];
                                    if (_e4334[0] < 0f) {
                                        phi_7387_ = -(_e4334[0]);
                                    } else {
                                        phi_7387_ = _e4334[0];
                                    }
                                    let _e4341 = phi_7387_;
                                    if (_e4334[1] < 0f) {
                                        phi_7394_ = -(_e4334[1]);
                                    } else {
                                        phi_7394_ = _e4334[1];
                                    }
                                    let _e4345 = phi_7394_;
                                    if (_e4341 > _e4345) {
                                        phi_7399_ = _e4341;
                                    } else {
                                        phi_7399_ = _e4345;
                                    }
                                    let _e4348 = phi_7399_;
                                    if (_e4334[2] < 0f) {
                                        phi_7406_ = -(_e4334[2]);
                                    } else {
                                        phi_7406_ = _e4334[2];
                                    }
                                    let _e4352 = phi_7406_;
                                    if (_e4348 > _e4352) {
                                        phi_7411_ = _e4348;
                                    } else {
                                        phi_7411_ = _e4352;
                                    }
                                    let _e4355 = phi_7411_;
                                    if (_e4331 > _e4355) {
                                        phi_7416_ = _e4331;
                                    } else {
                                        phi_7416_ = _e4355;
                                    }
                                    let _e4358 = phi_7416_;
                                    let _e4360 = local_1.member_3;
                                    let _e4361 = (_e4358 + _e4360);
                                    let _e4364 = local_1.member_2[0u];
                                    if (_e4364[0] < 0f) {
                                        phi_7433_ = -(_e4364[0]);
                                    } else {
                                        phi_7433_ = _e4364[0];
                                    }
                                    let _e4371 = phi_7433_;
                                    if (_e4364[1] < 0f) {
                                        phi_7440_ = -(_e4364[1]);
                                    } else {
                                        phi_7440_ = _e4364[1];
                                    }
                                    let _e4375 = phi_7440_;
                                    if (_e4371 > _e4375) {
                                        phi_7445_ = _e4371;
                                    } else {
                                        phi_7445_ = _e4375;
                                    }
                                    let _e4378 = phi_7445_;
                                    if (_e4364[2] < 0f) {
                                        phi_7452_ = -(_e4364[2]);
                                    } else {
                                        phi_7452_ = _e4364[2];
                                    }
                                    let _e4382 = phi_7452_;
                                    if (_e4378 > _e4382) {
                                        phi_7457_ = _e4378;
                                    } else {
                                        phi_7457_ = _e4382;
                                    }
                                    let _e4385 = phi_7457_;
                                    let _e4388 = local_1.member_2[1u];
                                    if (_e4388[0] < 0f) {
                                        phi_7471_ = -(_e4388[0]);
                                    } else {
                                        phi_7471_ = _e4388[0];
                                    }
                                    let _e4395 = phi_7471_;
                                    if (_e4388[1] < 0f) {
                                        phi_7478_ = -(_e4388[1]);
                                    } else {
                                        phi_7478_ = _e4388[1];
                                    }
                                    let _e4399 = phi_7478_;
                                    if (_e4395 > _e4399) {
                                        phi_7483_ = _e4395;
                                    } else {
                                        phi_7483_ = _e4399;
                                    }
                                    let _e4402 = phi_7483_;
                                    if (_e4388[2] < 0f) {
                                        phi_7490_ = -(_e4388[2]);
                                    } else {
                                        phi_7490_ = _e4388[2];
                                    }
                                    let _e4406 = phi_7490_;
                                    if (_e4402 > _e4406) {
                                        phi_7495_ = _e4402;
                                    } else {
                                        phi_7495_ = _e4406;
                                    }
                                    let _e4409 = phi_7495_;
                                    if (_e4385 > _e4409) {
                                        phi_7500_ = _e4385;
                                    } else {
                                        phi_7500_ = _e4409;
                                    }
                                    let _e4412 = phi_7500_;
                                    let _e4414 = local_1.member_3;
                                    let _e4415 = (_e4412 + _e4414);
                                    let _e4417 = ((_e4361 * 8f) * _e4415);
                                    let _e4424 = local_1.member_3;
                                    if (_e4113 < 0f) {
                                        phi_7531_ = -(_e4113);
                                    } else {
                                        phi_7531_ = _e4113;
                                    }
                                    let _e4441 = phi_7531_;
                                    if (_e4116 < 0f) {
                                        phi_7537_ = -(_e4116);
                                    } else {
                                        phi_7537_ = _e4116;
                                    }
                                    let _e4445 = phi_7537_;
                                    if (_e4119 < 0f) {
                                        phi_7544_ = -(_e4119);
                                    } else {
                                        phi_7544_ = _e4119;
                                    }
                                    let _e4450 = phi_7544_;
                                    let _e4451 = ((_e4441 + _e4445) + _e4450);
                                    if (_e4134 < 0f) {
                                        phi_7551_ = -(_e4134);
                                    } else {
                                        phi_7551_ = _e4134;
                                    }
                                    let _e4455 = phi_7551_;
                                    if (_e4137 < 0f) {
                                        phi_7557_ = -(_e4137);
                                    } else {
                                        phi_7557_ = _e4137;
                                    }
                                    let _e4459 = phi_7557_;
                                    if (_e4140 < 0f) {
                                        phi_7564_ = -(_e4140);
                                    } else {
                                        phi_7564_ = _e4140;
                                    }
                                    let _e4464 = phi_7564_;
                                    let _e4465 = ((_e4455 + _e4459) + _e4464);
                                    if (_e4451 > _e4465) {
                                        phi_7570_ = _e4451;
                                    } else {
                                        phi_7570_ = _e4465;
                                    }
                                    let _e4468 = phi_7570_;
                                    if (_e4183 < 0f) {
                                        phi_7576_ = -(_e4183);
                                    } else {
                                        phi_7576_ = _e4183;
                                    }
                                    let _e4472 = phi_7576_;
                                    if (_e4184 < 0f) {
                                        phi_7582_ = -(_e4184);
                                    } else {
                                        phi_7582_ = _e4184;
                                    }
                                    let _e4476 = phi_7582_;
                                    if (_e4185 < 0f) {
                                        phi_7589_ = -(_e4185);
                                    } else {
                                        phi_7589_ = _e4185;
                                    }
                                    let _e4481 = phi_7589_;
                                    let _e4483 = (((_e4472 + _e4476) + _e4481) * 0.5f);
                                    if (_e4468 > _e4483) {
                                        phi_7596_ = _e4468;
                                    } else {
                                        phi_7596_ = _e4483;
                                    }
                                    let _e4486 = phi_7596_;
                                    let _e4491 = local_1.member_3;
                                    let _e4504 = ((((_e4188[0] * _e4113) + (_e4188[1] * _e4116)) + (_e4188[2] * _e4119)) * 3f);
                                    let _e4505 = ((((_e4245[0] * _e4134) + (_e4245[1] * _e4137)) + (_e4245[2] * _e4140)) * 3f);
                                    if (_e4504 < _e4505) {
                                        phi_7620_ = _e4504;
                                    } else {
                                        phi_7620_ = _e4505;
                                    }
                                    let _e4508 = phi_7620_;
                                    if (_e4219 < _e4242) {
                                        phi_7625_ = _e4219;
                                    } else {
                                        phi_7625_ = _e4242;
                                    }
                                    let _e4511 = phi_7625_;
                                    if (_e4508 < _e4511) {
                                        phi_7630_ = _e4508;
                                    } else {
                                        phi_7630_ = _e4511;
                                    }
                                    let _e4514 = phi_7630_;
                                    if (_e4504 > _e4505) {
                                        phi_7635_ = _e4504;
                                    } else {
                                        phi_7635_ = _e4505;
                                    }
                                    let _e4517 = phi_7635_;
                                    if (_e4219 > _e4242) {
                                        phi_7640_ = _e4219;
                                    } else {
                                        phi_7640_ = _e4242;
                                    }
                                    let _e4520 = phi_7640_;
                                    if (_e4517 > _e4520) {
                                        phi_7645_ = _e4517;
                                    } else {
                                        phi_7645_ = _e4520;
                                    }
                                    let _e4523 = phi_7645_;
                                    let _e4528 = -(_e4523);
                                    if (_e4514 > _e4528) {
                                        phi_7655_ = _e4514;
                                    } else {
                                        phi_7655_ = _e4528;
                                    }
                                    let _e4531 = phi_7655_;
                                    let _e4533 = ((_e4531 - ((((((_e4307 * 8f) * _e4417) * (0.000000059604645f * (524f / 64f))) + ((_e4424 * 19f) * ((_e4307 * (_e4361 + _e4415)) + (_e4361 * _e4415)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4307) * ((1f + _e4361) * (1f + _e4415))))) + ((_e1817 * (((_e4486 + (_e4417 * (0.000000059604645f * 8f))) + ((_e4491 * 6f) * (_e4361 + _e4415))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4361) * (1f + _e4415))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4533 {
                                        phi_8624_ = _e4533;
                                    } else {
                                        let _e4536 = local_1.member_1[0u];
                                        let _e4542 = local_1.member_1[1u];
                                        let _e4546 = (_e4536[0] + _e4542[0]);
                                        let _e4547 = (_e4536[1] + _e4542[1]);
                                        let _e4548 = (_e4536[2] + _e4542[2]);
                                        let _e4551 = local_1.member_2[0u];
                                        let _e4557 = local_1.member_2[1u];
                                        let _e4561 = (_e4551[0] + _e4557[0]);
                                        let _e4562 = (_e4551[1] + _e4557[1]);
                                        let _e4563 = (_e4551[2] + _e4557[2]);
                                        let _e4566 = ((_e4547 * _e4563) - (_e4548 * _e4562));
                                        let _e4569 = ((_e4548 * _e4561) - (_e4546 * _e4563));
                                        let _e4572 = ((_e4546 * _e4562) - (_e4547 * _e4561));
                                        let _e4575 = local_1.member[0u];
                                        let _e4581 = local_1.member_1[0u];
                                        let _e4587 = local_1.member_2[0u];
                                        let _e4591 = (_e4575[0] - _e4581[0]);
                                        let _e4592 = (_e4575[1] - _e4581[1]);
                                        let _e4593 = (_e4575[2] - _e4581[2]);
                                        let _e4594 = (_e4575[0] - _e4587[0]);
                                        let _e4595 = (_e4575[1] - _e4587[1]);
                                        let _e4596 = (_e4575[2] - _e4587[2]);
                                        let _e4599 = local_1.member[1u];
                                        let _e4605 = local_1.member_1[1u];
                                        let _e4611 = local_1.member_2[1u];
                                        let _e4615 = (_e4599[0] - _e4605[0]);
                                        let _e4616 = (_e4599[1] - _e4605[1]);
                                        let _e4617 = (_e4599[2] - _e4605[2]);
                                        let _e4618 = (_e4599[0] - _e4611[0]);
                                        let _e4619 = (_e4599[1] - _e4611[1]);
                                        let _e4620 = (_e4599[2] - _e4611[2]);
                                        let _e4623 = local_1.member[0u];
                                        if (_e4623[0] < 0f) {
                                            phi_7858_ = -(_e4623[0]);
                                        } else {
                                            phi_7858_ = _e4623[0];
                                        }
                                        let _e4630 = phi_7858_;
                                        if (_e4623[1] < 0f) {
                                            phi_7865_ = -(_e4623[1]);
                                        } else {
                                            phi_7865_ = _e4623[1];
                                        }
                                        let _e4634 = phi_7865_;
                                        if (_e4630 > _e4634) {
                                            phi_7870_ = _e4630;
                                        } else {
                                            phi_7870_ = _e4634;
                                        }
                                        let _e4637 = phi_7870_;
                                        if (_e4623[2] < 0f) {
                                            phi_7877_ = -(_e4623[2]);
                                        } else {
                                            phi_7877_ = _e4623[2];
                                        }
                                        let _e4641 = phi_7877_;
                                        if (_e4637 > _e4641) {
                                            phi_7882_ = _e4637;
                                        } else {
                                            phi_7882_ = _e4641;
                                        }
                                        let _e4644 = phi_7882_;
                                        let _e4647 = local_1.member[1u];
                                        if (_e4647[0] < 0f) {
                                            phi_7895_ = -(_e4647[0]);
                                        } else {
                                            phi_7895_ = _e4647[0];
                                        }
                                        let _e4654 = phi_7895_;
                                        if (_e4647[1] < 0f) {
                                            phi_7902_ = -(_e4647[1]);
                                        } else {
                                            phi_7902_ = _e4647[1];
                                        }
                                        let _e4658 = phi_7902_;
                                        if (_e4654 > _e4658) {
                                            phi_7907_ = _e4654;
                                        } else {
                                            phi_7907_ = _e4658;
                                        }
                                        let _e4661 = phi_7907_;
                                        if (_e4647[2] < 0f) {
                                            phi_7914_ = -(_e4647[2]);
                                        } else {
                                            phi_7914_ = _e4647[2];
                                        }
                                        let _e4665 = phi_7914_;
                                        if (_e4661 > _e4665) {
                                            phi_7919_ = _e4661;
                                        } else {
                                            phi_7919_ = _e4665;
                                        }
                                        let _e4668 = phi_7919_;
                                        if (_e4644 > _e4668) {
                                            phi_7924_ = _e4644;
                                        } else {
                                            phi_7924_ = _e4668;
                                        }
                                        let _e4671 = phi_7924_;
                                        let _e4673 = local_1.member_3;
                                        let _e4677 = local_1.member_1[0u];
                                        if (_e4677[0] < 0f) {
                                            phi_7941_ = -(_e4677[0]);
                                        } else {
                                            phi_7941_ = _e4677[0];
                                        }
                                        let _e4684 = phi_7941_;
                                        if (_e4677[1] < 0f) {
                                            phi_7948_ = -(_e4677[1]);
                                        } else {
                                            phi_7948_ = _e4677[1];
                                        }
                                        let _e4688 = phi_7948_;
                                        if (_e4684 > _e4688) {
                                            phi_7953_ = _e4684;
                                        } else {
                                            phi_7953_ = _e4688;
                                        }
                                        let _e4691 = phi_7953_;
                                        if (_e4677[2] < 0f) {
                                            phi_7960_ = -(_e4677[2]);
                                        } else {
                                            phi_7960_ = _e4677[2];
                                        }
                                        let _e4695 = phi_7960_;
                                        if (_e4691 > _e4695) {
                                            phi_7965_ = _e4691;
                                        } else {
                                            phi_7965_ = _e4695;
                                        }
                                        let _e4698 = phi_7965_;
                                        let _e4701 = local_1.member_1[1u];
                                        if (_e4701[0] < 0f) {
                                            phi_7979_ = -(_e4701[0]);
                                        } else {
                                            phi_7979_ = _e4701[0];
                                        }
                                        let _e4708 = phi_7979_;
                                        if (_e4701[1] < 0f) {
                                            phi_7986_ = -(_e4701[1]);
                                        } else {
                                            phi_7986_ = _e4701[1];
                                        }
                                        let _e4712 = phi_7986_;
                                        if (_e4708 > _e4712) {
                                            phi_7991_ = _e4708;
                                        } else {
                                            phi_7991_ = _e4712;
                                        }
                                        let _e4715 = phi_7991_;
                                        if (_e4701[2] < 0f) {
                                            phi_7998_ = -(_e4701[2]);
                                        } else {
                                            phi_7998_ = _e4701[2];
                                        }
                                        let _e4719 = phi_7998_;
                                        if (_e4715 > _e4719) {
                                            phi_8003_ = _e4715;
                                        } else {
                                            phi_8003_ = _e4719;
                                        }
                                        let _e4722 = phi_8003_;
                                        if (_e4698 > _e4722) {
                                            phi_8008_ = _e4698;
                                        } else {
                                            phi_8008_ = _e4722;
                                        }
                                        let _e4725 = phi_8008_;
                                        let _e4727 = local_1.member_3;
                                        let _e4731 = local_1.member_2[0u];
                                        if (_e4731[0] < 0f) {
                                            phi_8025_ = -(_e4731[0]);
                                        } else {
                                            phi_8025_ = _e4731[0];
                                        }
                                        let _e4738 = phi_8025_;
                                        if (_e4731[1] < 0f) {
                                            phi_8032_ = -(_e4731[1]);
                                        } else {
                                            phi_8032_ = _e4731[1];
                                        }
                                        let _e4742 = phi_8032_;
                                        if (_e4738 > _e4742) {
                                            phi_8037_ = _e4738;
                                        } else {
                                            phi_8037_ = _e4742;
                                        }
                                        let _e4745 = phi_8037_;
                                        if (_e4731[2] < 0f) {
                                            phi_8044_ = -(_e4731[2]);
                                        } else {
                                            phi_8044_ = _e4731[2];
                                        }
                                        let _e4749 = phi_8044_;
                                        if (_e4745 > _e4749) {
                                            phi_8049_ = _e4745;
                                        } else {
                                            phi_8049_ = _e4749;
                                        }
                                        let _e4752 = phi_8049_;
                                        let _e4755 = local_1.member_2[1u];
                                        if (_e4755[0] < 0f) {
                                            phi_8063_ = -(_e4755[0]);
                                        } else {
                                            phi_8063_ = _e4755[0];
                                        }
                                        let _e4762 = phi_8063_;
                                        if (_e4755[1] < 0f) {
                                            phi_8070_ = -(_e4755[1]);
                                        } else {
                                            phi_8070_ = _e4755[1];
                                        }
                                        let _e4766 = phi_8070_;
                                        if (_e4762 > _e4766) {
                                            phi_8075_ = _e4762;
                                        } else {
                                            phi_8075_ = _e4766;
                                        }
                                        let _e4769 = phi_8075_;
                                        if (_e4755[2] < 0f) {
                                            phi_8082_ = -(_e4755[2]);
                                        } else {
                                            phi_8082_ = _e4755[2];
                                        }
                                        let _e4773 = phi_8082_;
                                        if (_e4769 > _e4773) {
                                            phi_8087_ = _e4769;
                                        } else {
                                            phi_8087_ = _e4773;
                                        }
                                        let _e4776 = phi_8087_;
                                        if (_e4752 > _e4776) {
                                            phi_8092_ = _e4752;
                                        } else {
                                            phi_8092_ = _e4776;
                                        }
                                        let _e4779 = phi_8092_;
                                        let _e4781 = local_1.member_3;
                                        let _e4785 = ((((_e4671 + _e4673) + (_e4725 + _e4727)) + (_e4779 + _e4781)) * 2f);
                                        let _e4788 = local_1.member_3;
                                        let _e4792 = (((_e1817 * 1.0001f) + (_e4788 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4795 = ((_e4569 * _e4548) - (_e4572 * _e4547));
                                        let _e4798 = ((_e4572 * _e4546) - (_e4566 * _e4548));
                                        let _e4801 = ((_e4566 * _e4547) - (_e4569 * _e4546));
                                        let _e4806 = (((_e4795 * _e4575[0]) + (_e4798 * _e4575[1])) + (_e4801 * _e4575[2]));
                                        let _e4811 = (((_e4795 * _e4591) + (_e4798 * _e4592)) + (_e4801 * _e4593));
                                        let _e4816 = (((_e4795 * _e4594) + (_e4798 * _e4595)) + (_e4801 * _e4596));
                                        let _e4821 = (((_e4795 * _e4575[0]) + (_e4798 * _e4575[1])) + (_e4801 * _e4575[2]));
                                        let _e4826 = (((_e4795 * _e4599[0]) + (_e4798 * _e4599[1])) + (_e4801 * _e4599[2]));
                                        let _e4831 = (((_e4795 * _e4615) + (_e4798 * _e4616)) + (_e4801 * _e4617));
                                        let _e4836 = (((_e4795 * _e4618) + (_e4798 * _e4619)) + (_e4801 * _e4620));
                                        let _e4841 = (((_e4795 * _e4599[0]) + (_e4798 * _e4599[1])) + (_e4801 * _e4599[2]));
                                        if (_e4806 < _e4811) {
                                            phi_8171_ = _e4806;
                                        } else {
                                            phi_8171_ = _e4811;
                                        }
                                        let _e4844 = phi_8171_;
                                        if (_e4816 < _e4821) {
                                            phi_8176_ = _e4816;
                                        } else {
                                            phi_8176_ = _e4821;
                                        }
                                        let _e4847 = phi_8176_;
                                        if (_e4844 < _e4847) {
                                            phi_8181_ = _e4844;
                                        } else {
                                            phi_8181_ = _e4847;
                                        }
                                        let _e4850 = phi_8181_;
                                        if (_e4826 < _e4831) {
                                            phi_8186_ = _e4826;
                                        } else {
                                            phi_8186_ = _e4831;
                                        }
                                        let _e4853 = phi_8186_;
                                        if (_e4836 < _e4841) {
                                            phi_8191_ = _e4836;
                                        } else {
                                            phi_8191_ = _e4841;
                                        }
                                        let _e4856 = phi_8191_;
                                        if (_e4853 < _e4856) {
                                            phi_8196_ = _e4853;
                                        } else {
                                            phi_8196_ = _e4856;
                                        }
                                        let _e4859 = phi_8196_;
                                        if (_e4850 < _e4859) {
                                            phi_8201_ = _e4850;
                                        } else {
                                            phi_8201_ = _e4859;
                                        }
                                        let _e4862 = phi_8201_;
                                        if (_e4806 > _e4811) {
                                            phi_8206_ = _e4806;
                                        } else {
                                            phi_8206_ = _e4811;
                                        }
                                        let _e4865 = phi_8206_;
                                        if (_e4816 > _e4821) {
                                            phi_8211_ = _e4816;
                                        } else {
                                            phi_8211_ = _e4821;
                                        }
                                        let _e4868 = phi_8211_;
                                        if (_e4865 > _e4868) {
                                            phi_8216_ = _e4865;
                                        } else {
                                            phi_8216_ = _e4868;
                                        }
                                        let _e4871 = phi_8216_;
                                        if (_e4826 > _e4831) {
                                            phi_8221_ = _e4826;
                                        } else {
                                            phi_8221_ = _e4831;
                                        }
                                        let _e4874 = phi_8221_;
                                        if (_e4836 > _e4841) {
                                            phi_8226_ = _e4836;
                                        } else {
                                            phi_8226_ = _e4841;
                                        }
                                        let _e4877 = phi_8226_;
                                        if (_e4874 > _e4877) {
                                            phi_8231_ = _e4874;
                                        } else {
                                            phi_8231_ = _e4877;
                                        }
                                        let _e4880 = phi_8231_;
                                        if (_e4871 > _e4880) {
                                            phi_8236_ = _e4871;
                                        } else {
                                            phi_8236_ = _e4880;
                                        }
                                        let _e4883 = phi_8236_;
                                        if (_e4795 < 0f) {
                                            phi_8242_ = -(_e4795);
                                        } else {
                                            phi_8242_ = _e4795;
                                        }
                                        let _e4887 = phi_8242_;
                                        if (_e4798 < 0f) {
                                            phi_8248_ = -(_e4798);
                                        } else {
                                            phi_8248_ = _e4798;
                                        }
                                        let _e4891 = phi_8248_;
                                        if (_e4801 < 0f) {
                                            phi_8255_ = -(_e4801);
                                        } else {
                                            phi_8255_ = _e4801;
                                        }
                                        let _e4896 = phi_8255_;
                                        let _e4897 = ((_e4887 + _e4891) + _e4896);
                                        let _e4902 = -(_e4883);
                                        if (_e4862 > _e4902) {
                                            phi_8266_ = _e4862;
                                        } else {
                                            phi_8266_ = _e4902;
                                        }
                                        let _e4905 = phi_8266_;
                                        let _e4910 = (((_e4905 - ((_e4897 * _e4785) * (0.000000059604645f * (17f / 2f)))) - (_e4897 * _e4792)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4913 = ((_e4569 * _e4563) - (_e4572 * _e4562));
                                        let _e4916 = ((_e4572 * _e4561) - (_e4566 * _e4563));
                                        let _e4919 = ((_e4566 * _e4562) - (_e4569 * _e4561));
                                        let _e4924 = (((_e4913 * _e4575[0]) + (_e4916 * _e4575[1])) + (_e4919 * _e4575[2]));
                                        let _e4929 = (((_e4913 * _e4591) + (_e4916 * _e4592)) + (_e4919 * _e4593));
                                        let _e4934 = (((_e4913 * _e4594) + (_e4916 * _e4595)) + (_e4919 * _e4596));
                                        let _e4939 = (((_e4913 * _e4575[0]) + (_e4916 * _e4575[1])) + (_e4919 * _e4575[2]));
                                        let _e4944 = (((_e4913 * _e4599[0]) + (_e4916 * _e4599[1])) + (_e4919 * _e4599[2]));
                                        let _e4949 = (((_e4913 * _e4615) + (_e4916 * _e4616)) + (_e4919 * _e4617));
                                        let _e4954 = (((_e4913 * _e4618) + (_e4916 * _e4619)) + (_e4919 * _e4620));
                                        let _e4959 = (((_e4913 * _e4599[0]) + (_e4916 * _e4599[1])) + (_e4919 * _e4599[2]));
                                        if (_e4924 < _e4929) {
                                            phi_8337_ = _e4924;
                                        } else {
                                            phi_8337_ = _e4929;
                                        }
                                        let _e4962 = phi_8337_;
                                        if (_e4934 < _e4939) {
                                            phi_8342_ = _e4934;
                                        } else {
                                            phi_8342_ = _e4939;
                                        }
                                        let _e4965 = phi_8342_;
                                        if (_e4962 < _e4965) {
                                            phi_8347_ = _e4962;
                                        } else {
                                            phi_8347_ = _e4965;
                                        }
                                        let _e4968 = phi_8347_;
                                        if (_e4944 < _e4949) {
                                            phi_8352_ = _e4944;
                                        } else {
                                            phi_8352_ = _e4949;
                                        }
                                        let _e4971 = phi_8352_;
                                        if (_e4954 < _e4959) {
                                            phi_8357_ = _e4954;
                                        } else {
                                            phi_8357_ = _e4959;
                                        }
                                        let _e4974 = phi_8357_;
                                        if (_e4971 < _e4974) {
                                            phi_8362_ = _e4971;
                                        } else {
                                            phi_8362_ = _e4974;
                                        }
                                        let _e4977 = phi_8362_;
                                        if (_e4968 < _e4977) {
                                            phi_8367_ = _e4968;
                                        } else {
                                            phi_8367_ = _e4977;
                                        }
                                        let _e4980 = phi_8367_;
                                        if (_e4924 > _e4929) {
                                            phi_8372_ = _e4924;
                                        } else {
                                            phi_8372_ = _e4929;
                                        }
                                        let _e4983 = phi_8372_;
                                        if (_e4934 > _e4939) {
                                            phi_8377_ = _e4934;
                                        } else {
                                            phi_8377_ = _e4939;
                                        }
                                        let _e4986 = phi_8377_;
                                        if (_e4983 > _e4986) {
                                            phi_8382_ = _e4983;
                                        } else {
                                            phi_8382_ = _e4986;
                                        }
                                        let _e4989 = phi_8382_;
                                        if (_e4944 > _e4949) {
                                            phi_8387_ = _e4944;
                                        } else {
                                            phi_8387_ = _e4949;
                                        }
                                        let _e4992 = phi_8387_;
                                        if (_e4954 > _e4959) {
                                            phi_8392_ = _e4954;
                                        } else {
                                            phi_8392_ = _e4959;
                                        }
                                        let _e4995 = phi_8392_;
                                        if (_e4992 > _e4995) {
                                            phi_8397_ = _e4992;
                                        } else {
                                            phi_8397_ = _e4995;
                                        }
                                        let _e4998 = phi_8397_;
                                        if (_e4989 > _e4998) {
                                            phi_8402_ = _e4989;
                                        } else {
                                            phi_8402_ = _e4998;
                                        }
                                        let _e5001 = phi_8402_;
                                        if (_e4913 < 0f) {
                                            phi_8408_ = -(_e4913);
                                        } else {
                                            phi_8408_ = _e4913;
                                        }
                                        let _e5005 = phi_8408_;
                                        if (_e4916 < 0f) {
                                            phi_8414_ = -(_e4916);
                                        } else {
                                            phi_8414_ = _e4916;
                                        }
                                        let _e5009 = phi_8414_;
                                        if (_e4919 < 0f) {
                                            phi_8421_ = -(_e4919);
                                        } else {
                                            phi_8421_ = _e4919;
                                        }
                                        let _e5014 = phi_8421_;
                                        let _e5015 = ((_e5005 + _e5009) + _e5014);
                                        let _e5020 = -(_e5001);
                                        if (_e4980 > _e5020) {
                                            phi_8432_ = _e4980;
                                        } else {
                                            phi_8432_ = _e5020;
                                        }
                                        let _e5023 = phi_8432_;
                                        let _e5028 = (((_e5023 - ((_e5015 * _e4785) * (0.000000059604645f * (17f / 2f)))) - (_e5015 * _e4792)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4910 > _e5028) {
                                            phi_8442_ = _e4910;
                                        } else {
                                            phi_8442_ = _e5028;
                                        }
                                        let _e5031 = phi_8442_;
                                        let _e5032 = (_e4561 - _e4546);
                                        let _e5033 = (_e4562 - _e4547);
                                        let _e5034 = (_e4563 - _e4548);
                                        let _e5037 = ((_e4569 * _e5034) - (_e4572 * _e5033));
                                        let _e5040 = ((_e4572 * _e5032) - (_e4566 * _e5034));
                                        let _e5043 = ((_e4566 * _e5033) - (_e4569 * _e5032));
                                        let _e5048 = (((_e5037 * _e4575[0]) + (_e5040 * _e4575[1])) + (_e5043 * _e4575[2]));
                                        let _e5053 = (((_e5037 * _e4591) + (_e5040 * _e4592)) + (_e5043 * _e4593));
                                        let _e5058 = (((_e5037 * _e4594) + (_e5040 * _e4595)) + (_e5043 * _e4596));
                                        let _e5063 = (((_e5037 * _e4575[0]) + (_e5040 * _e4575[1])) + (_e5043 * _e4575[2]));
                                        let _e5068 = (((_e5037 * _e4599[0]) + (_e5040 * _e4599[1])) + (_e5043 * _e4599[2]));
                                        let _e5073 = (((_e5037 * _e4615) + (_e5040 * _e4616)) + (_e5043 * _e4617));
                                        let _e5078 = (((_e5037 * _e4618) + (_e5040 * _e4619)) + (_e5043 * _e4620));
                                        let _e5083 = (((_e5037 * _e4599[0]) + (_e5040 * _e4599[1])) + (_e5043 * _e4599[2]));
                                        if (_e5048 < _e5053) {
                                            phi_8515_ = _e5048;
                                        } else {
                                            phi_8515_ = _e5053;
                                        }
                                        let _e5086 = phi_8515_;
                                        if (_e5058 < _e5063) {
                                            phi_8520_ = _e5058;
                                        } else {
                                            phi_8520_ = _e5063;
                                        }
                                        let _e5089 = phi_8520_;
                                        if (_e5086 < _e5089) {
                                            phi_8525_ = _e5086;
                                        } else {
                                            phi_8525_ = _e5089;
                                        }
                                        let _e5092 = phi_8525_;
                                        if (_e5068 < _e5073) {
                                            phi_8530_ = _e5068;
                                        } else {
                                            phi_8530_ = _e5073;
                                        }
                                        let _e5095 = phi_8530_;
                                        if (_e5078 < _e5083) {
                                            phi_8535_ = _e5078;
                                        } else {
                                            phi_8535_ = _e5083;
                                        }
                                        let _e5098 = phi_8535_;
                                        if (_e5095 < _e5098) {
                                            phi_8540_ = _e5095;
                                        } else {
                                            phi_8540_ = _e5098;
                                        }
                                        let _e5101 = phi_8540_;
                                        if (_e5092 < _e5101) {
                                            phi_8545_ = _e5092;
                                        } else {
                                            phi_8545_ = _e5101;
                                        }
                                        let _e5104 = phi_8545_;
                                        if (_e5048 > _e5053) {
                                            phi_8550_ = _e5048;
                                        } else {
                                            phi_8550_ = _e5053;
                                        }
                                        let _e5107 = phi_8550_;
                                        if (_e5058 > _e5063) {
                                            phi_8555_ = _e5058;
                                        } else {
                                            phi_8555_ = _e5063;
                                        }
                                        let _e5110 = phi_8555_;
                                        if (_e5107 > _e5110) {
                                            phi_8560_ = _e5107;
                                        } else {
                                            phi_8560_ = _e5110;
                                        }
                                        let _e5113 = phi_8560_;
                                        if (_e5068 > _e5073) {
                                            phi_8565_ = _e5068;
                                        } else {
                                            phi_8565_ = _e5073;
                                        }
                                        let _e5116 = phi_8565_;
                                        if (_e5078 > _e5083) {
                                            phi_8570_ = _e5078;
                                        } else {
                                            phi_8570_ = _e5083;
                                        }
                                        let _e5119 = phi_8570_;
                                        if (_e5116 > _e5119) {
                                            phi_8575_ = _e5116;
                                        } else {
                                            phi_8575_ = _e5119;
                                        }
                                        let _e5122 = phi_8575_;
                                        if (_e5113 > _e5122) {
                                            phi_8580_ = _e5113;
                                        } else {
                                            phi_8580_ = _e5122;
                                        }
                                        let _e5125 = phi_8580_;
                                        if (_e5037 < 0f) {
                                            phi_8586_ = -(_e5037);
                                        } else {
                                            phi_8586_ = _e5037;
                                        }
                                        let _e5129 = phi_8586_;
                                        if (_e5040 < 0f) {
                                            phi_8592_ = -(_e5040);
                                        } else {
                                            phi_8592_ = _e5040;
                                        }
                                        let _e5133 = phi_8592_;
                                        if (_e5043 < 0f) {
                                            phi_8599_ = -(_e5043);
                                        } else {
                                            phi_8599_ = _e5043;
                                        }
                                        let _e5138 = phi_8599_;
                                        let _e5139 = ((_e5129 + _e5133) + _e5138);
                                        let _e5144 = -(_e5125);
                                        if (_e5104 > _e5144) {
                                            phi_8610_ = _e5104;
                                        } else {
                                            phi_8610_ = _e5144;
                                        }
                                        let _e5147 = phi_8610_;
                                        let _e5152 = (((_e5147 - ((_e5139 * _e4785) * (0.000000059604645f * (17f / 2f)))) - (_e5139 * _e4792)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5031 > _e5152) {
                                            phi_8620_ = _e5031;
                                        } else {
                                            phi_8620_ = _e5152;
                                        }
                                        let _e5155 = phi_8620_;
                                        phi_8624_ = (_e4533 || (_e5155 > 0f));
                                    }
                                    let _e5159 = phi_8624_;
                                    phi_8626_ = (_e4098 && _e5159);
                                } else {
                                    phi_8626_ = _e4098;
                                }
                                let _e5162 = phi_8626_;
                                phi_8628_ = (_e2947 || _e5162);
                            }
                            let _e5165 = phi_8628_;
                            if !(_e5165) {
                                let _e5168 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1172] = ((2147483648u | (_e5168 << bitcast<u32>(12i))) | _e1175);
                            }
                        }
                        phi_8639_ = true;
                    }
                    let _e5175 = phi_8639_;
                    phi_8640_ = _e5175;
                } else {
                    phi_8640_ = false;
                }
                let _e5177 = phi_8640_;
                continue;
                continuing {
                    phi_2224_ = _e1164;
                    break if !(_e5177);
                }
            }
            workgroupBarrier();
            if (_e71 == 0u) {
                let _e5181 = atomicLoad((&counters[5u]));
                if (_e5181 > 0u) {
                    let _e5184 = atomicAdd((&output.member[0u]), _e5181);
                    if ((_e5184 + _e5181) < _e5184) {
                        let _e5188 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e5184);
                }
            }
            workgroupBarrier();
            let _e5191 = atomicLoad((&counters[6u]));
            if (_e71 == 0u) {
                let _e5194 = atomicLoad((&counters[7u]));
                if (_e5194 > 0u) {
                    let _e5197 = atomicAdd((&output.member[1u]), _e5194);
                    if ((_e5197 + _e5194) < _e5197) {
                        let _e5201 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_8690_ = type_9(0u, 16u);
            loop {
                let _e5203 = phi_8690_;
                if (_e5203.member < _e5203.member_1) {
                    phi_8691_ = type_9((_e5203.member + 1u), _e5203.member_1);
                    phi_8714_ = type_9(1u, _e5203.member);
                } else {
                    phi_8691_ = _e5203;
                    phi_8714_ = type_9(0u, type_9().member_1);
                }
                let _e5215 = phi_8691_;
                let _e5217 = phi_8714_;
                if (bitcast<i32>(_e5217.member) != 0i) {
                    let _e5223 = (_e71 + (_e5217.member_1 * 128u));
                    if (_e5223 >= _e1150) {
                        phi_8811_ = false;
                    } else {
                        let _e5226 = hits[_e5223];
                        if ((_e5226 & 2147483648u) == 0u) {
                            phi_8737_ = 4294967295u;
                        } else {
                            phi_8737_ = ((_e5226 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e5233 = phi_8737_;
                        if (_e5233 != 4294967295u) {
                            let _e5237 = ((_e5226 >> bitcast<u32>(10i)) & 3u);
                            let _e5244 = firsts[(2u * _e5237)];
                            let _e5247 = leaves.member[(_e5244 + ((_e5226 >> bitcast<u32>(5i)) & 31u))];
                            let _e5251 = firsts[((2u * _e5237) + 1u)];
                            let _e5254 = leaves.member[(_e5251 + (_e5226 & 31u))];
                            let _e5259 = params.member.member_1.member_3;
                            let _e5260 = (_e5191 + _e5233);
                            if (_e5260 < _e5259) {
                                let _e5262 = (2u * _e5260);
                                atomicStore((&output.member[(4u + _e5262)]), _e5247.member_1);
                                atomicStore((&output.member[(_e5262 + 5u)]), _e5254.member_1);
                            }
                        }
                        phi_8811_ = true;
                    }
                    let _e5268 = phi_8811_;
                    phi_8812_ = _e5268;
                } else {
                    phi_8812_ = false;
                }
                let _e5270 = phi_8812_;
                continue;
                continuing {
                    phi_8690_ = _e5215;
                    break if !(_e5270);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_442_ = _e157;
            break if !(_e163);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
