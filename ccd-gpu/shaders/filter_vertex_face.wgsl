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

struct type_13 {
    member: u32,
    member_1: u32,
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
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_23 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_26 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_32 {
    member: array<type_30>,
}

struct type_34 {
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
var<storage> params: type_21;
@group(0) @binding(2) 
var<storage> leaves: type_28;
@group(0) @binding(1) 
var<storage> nodes: type_32;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_34, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(3) 
var<storage> bodies: type_10;
@group(0) @binding(4) 
var<storage> keys: type_39;
@group(0) @binding(5) 
var<storage> paths: type_25;
@group(0) @binding(6) 
var<storage> input: type_10;
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
    var phi_442_: type_13;
    var phi_443_: type_13;
    var phi_466_: type_13;
    var phi_507_: u32;
    var phi_508_: u32;
    var phi_516_: u32;
    var phi_528_: u32;
    var phi_613_: array<u32, 2>;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_822_: type_34;
    var phi_835_: type_13;
    var phi_838_: u32;
    var phi_836_: type_13;
    var phi_861_: type_13;
    var phi_951_: u32;
    var phi_953_: u32;
    var phi_839_: u32;
    var phi_956_: type_13;
    var phi_959_: u32;
    var phi_957_: type_13;
    var phi_982_: type_13;
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
    var phi_1327_: type_16;
    var phi_1330_: u32;
    var phi_1332_: u32;
    var phi_1353_: bool;
    var phi_1359_: type_17;
    var phi_1328_: type_16;
    var phi_1373_: type_17;
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
    var phi_2224_: type_13;
    var phi_2225_: type_13;
    var phi_2248_: type_13;
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
    var phi_2601_: type_16;
    var phi_2604_: u32;
    var phi_2606_: u32;
    var phi_2627_: bool;
    var phi_2633_: type_17;
    var phi_2602_: type_16;
    var phi_2647_: type_17;
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
    var phi_3819_: f32;
    var phi_3826_: f32;
    var phi_3831_: f32;
    var phi_3838_: f32;
    var phi_3843_: f32;
    var phi_3856_: f32;
    var phi_3863_: f32;
    var phi_3868_: f32;
    var phi_3875_: f32;
    var phi_3880_: f32;
    var phi_3885_: f32;
    var phi_3902_: f32;
    var phi_3909_: f32;
    var phi_3914_: f32;
    var phi_3921_: f32;
    var phi_3926_: f32;
    var phi_3940_: f32;
    var phi_3947_: f32;
    var phi_3952_: f32;
    var phi_3959_: f32;
    var phi_3964_: f32;
    var phi_3969_: f32;
    var phi_3986_: f32;
    var phi_3993_: f32;
    var phi_3998_: f32;
    var phi_4005_: f32;
    var phi_4010_: f32;
    var phi_4024_: f32;
    var phi_4031_: f32;
    var phi_4036_: f32;
    var phi_4043_: f32;
    var phi_4048_: f32;
    var phi_4053_: f32;
    var phi_4084_: f32;
    var phi_4090_: f32;
    var phi_4097_: f32;
    var phi_4104_: f32;
    var phi_4110_: f32;
    var phi_4117_: f32;
    var phi_4123_: f32;
    var phi_4129_: f32;
    var phi_4135_: f32;
    var phi_4142_: f32;
    var phi_4149_: f32;
    var phi_4173_: f32;
    var phi_4178_: f32;
    var phi_4183_: f32;
    var phi_4188_: f32;
    var phi_4193_: f32;
    var phi_4198_: f32;
    var phi_4208_: f32;
    var phi_4411_: f32;
    var phi_4418_: f32;
    var phi_4423_: f32;
    var phi_4430_: f32;
    var phi_4435_: f32;
    var phi_4448_: f32;
    var phi_4455_: f32;
    var phi_4460_: f32;
    var phi_4467_: f32;
    var phi_4472_: f32;
    var phi_4477_: f32;
    var phi_4494_: f32;
    var phi_4501_: f32;
    var phi_4506_: f32;
    var phi_4513_: f32;
    var phi_4518_: f32;
    var phi_4532_: f32;
    var phi_4539_: f32;
    var phi_4544_: f32;
    var phi_4551_: f32;
    var phi_4556_: f32;
    var phi_4561_: f32;
    var phi_4578_: f32;
    var phi_4585_: f32;
    var phi_4590_: f32;
    var phi_4597_: f32;
    var phi_4602_: f32;
    var phi_4616_: f32;
    var phi_4623_: f32;
    var phi_4628_: f32;
    var phi_4635_: f32;
    var phi_4640_: f32;
    var phi_4645_: f32;
    var phi_4724_: f32;
    var phi_4729_: f32;
    var phi_4734_: f32;
    var phi_4739_: f32;
    var phi_4744_: f32;
    var phi_4749_: f32;
    var phi_4754_: f32;
    var phi_4759_: f32;
    var phi_4764_: f32;
    var phi_4769_: f32;
    var phi_4774_: f32;
    var phi_4779_: f32;
    var phi_4784_: f32;
    var phi_4789_: f32;
    var phi_4795_: f32;
    var phi_4801_: f32;
    var phi_4808_: f32;
    var phi_4819_: f32;
    var phi_4890_: f32;
    var phi_4895_: f32;
    var phi_4900_: f32;
    var phi_4905_: f32;
    var phi_4910_: f32;
    var phi_4915_: f32;
    var phi_4920_: f32;
    var phi_4925_: f32;
    var phi_4930_: f32;
    var phi_4935_: f32;
    var phi_4940_: f32;
    var phi_4945_: f32;
    var phi_4950_: f32;
    var phi_4955_: f32;
    var phi_4961_: f32;
    var phi_4967_: f32;
    var phi_4974_: f32;
    var phi_4985_: f32;
    var phi_4995_: f32;
    var phi_5068_: f32;
    var phi_5073_: f32;
    var phi_5078_: f32;
    var phi_5083_: f32;
    var phi_5088_: f32;
    var phi_5093_: f32;
    var phi_5098_: f32;
    var phi_5103_: f32;
    var phi_5108_: f32;
    var phi_5113_: f32;
    var phi_5118_: f32;
    var phi_5123_: f32;
    var phi_5128_: f32;
    var phi_5133_: f32;
    var phi_5139_: f32;
    var phi_5145_: f32;
    var phi_5152_: f32;
    var phi_5163_: f32;
    var phi_5173_: f32;
    var phi_5177_: bool;
    var phi_5629_: f32;
    var phi_5636_: f32;
    var phi_5641_: f32;
    var phi_5648_: f32;
    var phi_5653_: f32;
    var phi_5666_: f32;
    var phi_5673_: f32;
    var phi_5678_: f32;
    var phi_5685_: f32;
    var phi_5690_: f32;
    var phi_5695_: f32;
    var phi_5712_: f32;
    var phi_5719_: f32;
    var phi_5724_: f32;
    var phi_5731_: f32;
    var phi_5736_: f32;
    var phi_5750_: f32;
    var phi_5757_: f32;
    var phi_5762_: f32;
    var phi_5769_: f32;
    var phi_5774_: f32;
    var phi_5779_: f32;
    var phi_5796_: f32;
    var phi_5803_: f32;
    var phi_5808_: f32;
    var phi_5815_: f32;
    var phi_5820_: f32;
    var phi_5834_: f32;
    var phi_5841_: f32;
    var phi_5846_: f32;
    var phi_5853_: f32;
    var phi_5858_: f32;
    var phi_5863_: f32;
    var phi_5894_: f32;
    var phi_5900_: f32;
    var phi_5907_: f32;
    var phi_5914_: f32;
    var phi_5920_: f32;
    var phi_5927_: f32;
    var phi_5933_: f32;
    var phi_5939_: f32;
    var phi_5945_: f32;
    var phi_5952_: f32;
    var phi_5959_: f32;
    var phi_5983_: f32;
    var phi_5988_: f32;
    var phi_5993_: f32;
    var phi_5998_: f32;
    var phi_6003_: f32;
    var phi_6008_: f32;
    var phi_6018_: f32;
    var phi_6221_: f32;
    var phi_6228_: f32;
    var phi_6233_: f32;
    var phi_6240_: f32;
    var phi_6245_: f32;
    var phi_6258_: f32;
    var phi_6265_: f32;
    var phi_6270_: f32;
    var phi_6277_: f32;
    var phi_6282_: f32;
    var phi_6287_: f32;
    var phi_6304_: f32;
    var phi_6311_: f32;
    var phi_6316_: f32;
    var phi_6323_: f32;
    var phi_6328_: f32;
    var phi_6342_: f32;
    var phi_6349_: f32;
    var phi_6354_: f32;
    var phi_6361_: f32;
    var phi_6366_: f32;
    var phi_6371_: f32;
    var phi_6388_: f32;
    var phi_6395_: f32;
    var phi_6400_: f32;
    var phi_6407_: f32;
    var phi_6412_: f32;
    var phi_6426_: f32;
    var phi_6433_: f32;
    var phi_6438_: f32;
    var phi_6445_: f32;
    var phi_6450_: f32;
    var phi_6455_: f32;
    var phi_6534_: f32;
    var phi_6539_: f32;
    var phi_6544_: f32;
    var phi_6549_: f32;
    var phi_6554_: f32;
    var phi_6559_: f32;
    var phi_6564_: f32;
    var phi_6569_: f32;
    var phi_6574_: f32;
    var phi_6579_: f32;
    var phi_6584_: f32;
    var phi_6589_: f32;
    var phi_6594_: f32;
    var phi_6599_: f32;
    var phi_6605_: f32;
    var phi_6611_: f32;
    var phi_6618_: f32;
    var phi_6629_: f32;
    var phi_6700_: f32;
    var phi_6705_: f32;
    var phi_6710_: f32;
    var phi_6715_: f32;
    var phi_6720_: f32;
    var phi_6725_: f32;
    var phi_6730_: f32;
    var phi_6735_: f32;
    var phi_6740_: f32;
    var phi_6745_: f32;
    var phi_6750_: f32;
    var phi_6755_: f32;
    var phi_6760_: f32;
    var phi_6765_: f32;
    var phi_6771_: f32;
    var phi_6777_: f32;
    var phi_6784_: f32;
    var phi_6795_: f32;
    var phi_6805_: f32;
    var phi_6878_: f32;
    var phi_6883_: f32;
    var phi_6888_: f32;
    var phi_6893_: f32;
    var phi_6898_: f32;
    var phi_6903_: f32;
    var phi_6908_: f32;
    var phi_6913_: f32;
    var phi_6918_: f32;
    var phi_6923_: f32;
    var phi_6928_: f32;
    var phi_6933_: f32;
    var phi_6938_: f32;
    var phi_6943_: f32;
    var phi_6949_: f32;
    var phi_6955_: f32;
    var phi_6962_: f32;
    var phi_6973_: f32;
    var phi_6983_: f32;
    var phi_6987_: bool;
    var phi_7232_: f32;
    var phi_7239_: f32;
    var phi_7244_: f32;
    var phi_7251_: f32;
    var phi_7256_: f32;
    var phi_7269_: f32;
    var phi_7276_: f32;
    var phi_7281_: f32;
    var phi_7288_: f32;
    var phi_7293_: f32;
    var phi_7298_: f32;
    var phi_7315_: f32;
    var phi_7322_: f32;
    var phi_7327_: f32;
    var phi_7334_: f32;
    var phi_7339_: f32;
    var phi_7353_: f32;
    var phi_7360_: f32;
    var phi_7365_: f32;
    var phi_7372_: f32;
    var phi_7377_: f32;
    var phi_7382_: f32;
    var phi_7399_: f32;
    var phi_7406_: f32;
    var phi_7411_: f32;
    var phi_7418_: f32;
    var phi_7423_: f32;
    var phi_7437_: f32;
    var phi_7444_: f32;
    var phi_7449_: f32;
    var phi_7456_: f32;
    var phi_7461_: f32;
    var phi_7466_: f32;
    var phi_7497_: f32;
    var phi_7503_: f32;
    var phi_7510_: f32;
    var phi_7517_: f32;
    var phi_7523_: f32;
    var phi_7530_: f32;
    var phi_7536_: f32;
    var phi_7542_: f32;
    var phi_7548_: f32;
    var phi_7555_: f32;
    var phi_7562_: f32;
    var phi_7586_: f32;
    var phi_7591_: f32;
    var phi_7596_: f32;
    var phi_7601_: f32;
    var phi_7606_: f32;
    var phi_7611_: f32;
    var phi_7621_: f32;
    var phi_7824_: f32;
    var phi_7831_: f32;
    var phi_7836_: f32;
    var phi_7843_: f32;
    var phi_7848_: f32;
    var phi_7861_: f32;
    var phi_7868_: f32;
    var phi_7873_: f32;
    var phi_7880_: f32;
    var phi_7885_: f32;
    var phi_7890_: f32;
    var phi_7907_: f32;
    var phi_7914_: f32;
    var phi_7919_: f32;
    var phi_7926_: f32;
    var phi_7931_: f32;
    var phi_7945_: f32;
    var phi_7952_: f32;
    var phi_7957_: f32;
    var phi_7964_: f32;
    var phi_7969_: f32;
    var phi_7974_: f32;
    var phi_7991_: f32;
    var phi_7998_: f32;
    var phi_8003_: f32;
    var phi_8010_: f32;
    var phi_8015_: f32;
    var phi_8029_: f32;
    var phi_8036_: f32;
    var phi_8041_: f32;
    var phi_8048_: f32;
    var phi_8053_: f32;
    var phi_8058_: f32;
    var phi_8137_: f32;
    var phi_8142_: f32;
    var phi_8147_: f32;
    var phi_8152_: f32;
    var phi_8157_: f32;
    var phi_8162_: f32;
    var phi_8167_: f32;
    var phi_8172_: f32;
    var phi_8177_: f32;
    var phi_8182_: f32;
    var phi_8187_: f32;
    var phi_8192_: f32;
    var phi_8197_: f32;
    var phi_8202_: f32;
    var phi_8208_: f32;
    var phi_8214_: f32;
    var phi_8221_: f32;
    var phi_8232_: f32;
    var phi_8303_: f32;
    var phi_8308_: f32;
    var phi_8313_: f32;
    var phi_8318_: f32;
    var phi_8323_: f32;
    var phi_8328_: f32;
    var phi_8333_: f32;
    var phi_8338_: f32;
    var phi_8343_: f32;
    var phi_8348_: f32;
    var phi_8353_: f32;
    var phi_8358_: f32;
    var phi_8363_: f32;
    var phi_8368_: f32;
    var phi_8374_: f32;
    var phi_8380_: f32;
    var phi_8387_: f32;
    var phi_8398_: f32;
    var phi_8408_: f32;
    var phi_8481_: f32;
    var phi_8486_: f32;
    var phi_8491_: f32;
    var phi_8496_: f32;
    var phi_8501_: f32;
    var phi_8506_: f32;
    var phi_8511_: f32;
    var phi_8516_: f32;
    var phi_8521_: f32;
    var phi_8526_: f32;
    var phi_8531_: f32;
    var phi_8536_: f32;
    var phi_8541_: f32;
    var phi_8546_: f32;
    var phi_8552_: f32;
    var phi_8558_: f32;
    var phi_8565_: f32;
    var phi_8576_: f32;
    var phi_8586_: f32;
    var phi_8590_: bool;
    var phi_8592_: bool;
    var phi_8594_: bool;
    var phi_8605_: bool;
    var phi_8606_: bool;
    var phi_8656_: type_13;
    var phi_8657_: type_13;
    var phi_8680_: type_13;
    var phi_8703_: u32;
    var phi_8777_: bool;
    var phi_8778_: bool;
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
    phi_442_ = type_13(0u, _e142);
    loop {
        let _e145 = phi_442_;
        if (_e145.member < _e145.member_1) {
            phi_443_ = type_13((_e145.member + 1u), _e145.member_1);
            phi_466_ = type_13(1u, _e145.member);
        } else {
            phi_443_ = _e145;
            phi_466_ = type_13(0u, type_13().member_1);
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
                    columns[_e360] = type_34(array<f32, 3>(_e333.member.x, _e333.member.y, _e333.member_1.x), array<f32, 3>(_e333.member_1.y, _e333.member_2.x, _e333.member_2.y));
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
                phi_822_ = type_34(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_822_ = type_34(array<f32, 3>(_e304.member.x, _e304.member.y, _e304.member_1.x), array<f32, 3>(_e304.member_1.y, _e304.member_2.x, _e304.member_2.y));
            }
            let _e382 = phi_822_;
            let _e383 = (_e71 / 32u);
            let _e386 = atomicLoad((&counters[_e383]));
            phi_835_ = type_13(0u, _e386);
            phi_838_ = 0u;
            loop {
                let _e389 = phi_835_;
                let _e391 = phi_838_;
                local_7 = _e391;
                if (_e389.member < _e389.member_1) {
                    phi_836_ = type_13((_e389.member + 1u), _e389.member_1);
                    phi_861_ = type_13(1u, _e389.member);
                } else {
                    phi_836_ = _e389;
                    phi_861_ = type_13(0u, type_13().member_1);
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
            phi_956_ = type_13(0u, 32u);
            let _e5301 = local_7;
            phi_959_ = _e5301;
            loop {
                let _e471 = phi_956_;
                let _e473 = phi_959_;
                if (_e471.member < _e471.member_1) {
                    phi_957_ = type_13((_e471.member + 1u), _e471.member_1);
                    phi_982_ = type_13(1u, _e471.member);
                } else {
                    phi_957_ = _e471;
                    phi_982_ = type_13(0u, type_13().member_1);
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
                                            phi_1327_ = type_16(0i, 32i);
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
                                                        phi_1359_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_1359_ = type_17(1u, _e668);
                                                    }
                                                    let _e678 = phi_1359_;
                                                    phi_1328_ = type_16(_e678.member_1, _e657.member_1);
                                                    phi_1373_ = type_17(1u, _e657.member);
                                                } else {
                                                    phi_1328_ = _e657;
                                                    phi_1373_ = type_17(0u, type_17().member_1);
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
                            let _e1116 = params.member.member_1.member_3;
                            let _e1120 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1120 + 1u) < _e1120) {
                                let _e1124 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1120 < _e1116) {
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
            phi_2224_ = type_13(0u, 16u);
            loop {
                let _e1152 = phi_2224_;
                if (_e1152.member < _e1152.member_1) {
                    phi_2225_ = type_13((_e1152.member + 1u), _e1152.member_1);
                    phi_2248_ = type_13(1u, _e1152.member);
                } else {
                    phi_2225_ = _e1152;
                    phi_2248_ = type_13(0u, type_13().member_1);
                }
                let _e1164 = phi_2225_;
                let _e1166 = phi_2248_;
                if (bitcast<i32>(_e1166.member) != 0i) {
                    let _e1172 = (_e71 + (_e1166.member_1 * 128u));
                    if (_e1172 >= _e1150) {
                        phi_8605_ = false;
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
                                            phi_2601_ = type_16(0i, 32i);
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
                                                        phi_2633_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_2633_ = type_17(1u, _e1357);
                                                    }
                                                    let _e1367 = phi_2633_;
                                                    phi_2602_ = type_16(_e1367.member_1, _e1346.member_1);
                                                    phi_2647_ = type_17(1u, _e1346.member);
                                                } else {
                                                    phi_2602_ = _e1346;
                                                    phi_2647_ = type_17(0u, type_17().member_1);
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
                            let _e1807 = params.member.member.member_4;
                            let _e1809 = params.member.member.member_5;
                            let _e1819 = paths.member[_e1193.member[0]];
                            let _e1821 = paths.member[_e1195.member[0]];
                            let _e1827 = paths.member[_e1195.member[1]];
                            let _e1829 = paths.member[_e1195.member[2]];
                            local_2 = type_41(array<array<f32, 3>, 2>(array<f32, 3>((_e1819.member[0] - _e1821.member[0]), (_e1819.member[1] - _e1821.member[1]), (_e1819.member[2] - _e1821.member[2])), array<f32, 3>((_e1819.member_1[0] - _e1821.member_1[0]), (_e1819.member_1[1] - _e1821.member_1[1]), (_e1819.member_1[2] - _e1821.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1827.member[0] - _e1821.member[0]), (_e1827.member[1] - _e1821.member[1]), (_e1827.member[2] - _e1821.member[2])), array<f32, 3>((_e1827.member_1[0] - _e1821.member_1[0]), (_e1827.member_1[1] - _e1821.member_1[1]), (_e1827.member_1[2] - _e1821.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1829.member[0] - _e1821.member[0]), (_e1829.member[1] - _e1821.member[1]), (_e1829.member[2] - _e1821.member[2])), array<f32, 3>((_e1829.member_1[0] - _e1821.member_1[0]), (_e1829.member_1[1] - _e1821.member_1[1]), (_e1829.member_1[2] - _e1821.member_1[2]))), (_e1807 + _e1807));
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
                                phi_3819_ = -(_e2044[0]);
                            } else {
                                phi_3819_ = _e2044[0];
                            }
                            let _e2051 = phi_3819_;
                            if (_e2044[1] < 0f) {
                                phi_3826_ = -(_e2044[1]);
                            } else {
                                phi_3826_ = _e2044[1];
                            }
                            let _e2055 = phi_3826_;
                            if (_e2051 > _e2055) {
                                phi_3831_ = _e2051;
                            } else {
                                phi_3831_ = _e2055;
                            }
                            let _e2058 = phi_3831_;
                            if (_e2044[2] < 0f) {
                                phi_3838_ = -(_e2044[2]);
                            } else {
                                phi_3838_ = _e2044[2];
                            }
                            let _e2062 = phi_3838_;
                            if (_e2058 > _e2062) {
                                phi_3843_ = _e2058;
                            } else {
                                phi_3843_ = _e2062;
                            }
                            let _e2065 = phi_3843_;
                            let _e2068 = local_2.member[1u];
                            if (_e2068[0] < 0f) {
                                phi_3856_ = -(_e2068[0]);
                            } else {
                                phi_3856_ = _e2068[0];
                            }
                            let _e2075 = phi_3856_;
                            if (_e2068[1] < 0f) {
                                phi_3863_ = -(_e2068[1]);
                            } else {
                                phi_3863_ = _e2068[1];
                            }
                            let _e2079 = phi_3863_;
                            if (_e2075 > _e2079) {
                                phi_3868_ = _e2075;
                            } else {
                                phi_3868_ = _e2079;
                            }
                            let _e2082 = phi_3868_;
                            if (_e2068[2] < 0f) {
                                phi_3875_ = -(_e2068[2]);
                            } else {
                                phi_3875_ = _e2068[2];
                            }
                            let _e2086 = phi_3875_;
                            if (_e2082 > _e2086) {
                                phi_3880_ = _e2082;
                            } else {
                                phi_3880_ = _e2086;
                            }
                            let _e2089 = phi_3880_;
                            if (_e2065 > _e2089) {
                                phi_3885_ = _e2065;
                            } else {
                                phi_3885_ = _e2089;
                            }
                            let _e2092 = phi_3885_;
                            let _e2094 = local_2.member_3;
                            let _e2095 = (_e2092 + _e2094);
                            let _e2098 = local_2.member_1[0u];
                            if (_e2098[0] < 0f) {
                                phi_3902_ = -(_e2098[0]);
                            } else {
                                phi_3902_ = _e2098[0];
                            }
                            let _e2105 = phi_3902_;
                            if (_e2098[1] < 0f) {
                                phi_3909_ = -(_e2098[1]);
                            } else {
                                phi_3909_ = _e2098[1];
                            }
                            let _e2109 = phi_3909_;
                            if (_e2105 > _e2109) {
                                phi_3914_ = _e2105;
                            } else {
                                phi_3914_ = _e2109;
                            }
                            let _e2112 = phi_3914_;
                            if (_e2098[2] < 0f) {
                                phi_3921_ = -(_e2098[2]);
                            } else {
                                phi_3921_ = _e2098[2];
                            }
                            let _e2116 = phi_3921_;
                            if (_e2112 > _e2116) {
                                phi_3926_ = _e2112;
                            } else {
                                phi_3926_ = _e2116;
                            }
                            let _e2119 = phi_3926_;
                            let _e2122 = local_2.member_1[1u];
                            if (_e2122[0] < 0f) {
                                phi_3940_ = -(_e2122[0]);
                            } else {
                                phi_3940_ = _e2122[0];
                            }
                            let _e2129 = phi_3940_;
                            if (_e2122[1] < 0f) {
                                phi_3947_ = -(_e2122[1]);
                            } else {
                                phi_3947_ = _e2122[1];
                            }
                            let _e2133 = phi_3947_;
                            if (_e2129 > _e2133) {
                                phi_3952_ = _e2129;
                            } else {
                                phi_3952_ = _e2133;
                            }
                            let _e2136 = phi_3952_;
                            if (_e2122[2] < 0f) {
                                phi_3959_ = -(_e2122[2]);
                            } else {
                                phi_3959_ = _e2122[2];
                            }
                            let _e2140 = phi_3959_;
                            if (_e2136 > _e2140) {
                                phi_3964_ = _e2136;
                            } else {
                                phi_3964_ = _e2140;
                            }
                            let _e2143 = phi_3964_;
                            if (_e2119 > _e2143) {
                                phi_3969_ = _e2119;
                            } else {
                                phi_3969_ = _e2143;
                            }
                            let _e2146 = phi_3969_;
                            let _e2148 = local_2.member_3;
                            let _e2149 = (_e2146 + _e2148);
                            let _e2152 = local_2.member_2[0u];
                            if (_e2152[0] < 0f) {
                                phi_3986_ = -(_e2152[0]);
                            } else {
                                phi_3986_ = _e2152[0];
                            }
                            let _e2159 = phi_3986_;
                            if (_e2152[1] < 0f) {
                                phi_3993_ = -(_e2152[1]);
                            } else {
                                phi_3993_ = _e2152[1];
                            }
                            let _e2163 = phi_3993_;
                            if (_e2159 > _e2163) {
                                phi_3998_ = _e2159;
                            } else {
                                phi_3998_ = _e2163;
                            }
                            let _e2166 = phi_3998_;
                            if (_e2152[2] < 0f) {
                                phi_4005_ = -(_e2152[2]);
                            } else {
                                phi_4005_ = _e2152[2];
                            }
                            let _e2170 = phi_4005_;
                            if (_e2166 > _e2170) {
                                phi_4010_ = _e2166;
                            } else {
                                phi_4010_ = _e2170;
                            }
                            let _e2173 = phi_4010_;
                            let _e2176 = local_2.member_2[1u];
                            if (_e2176[0] < 0f) {
                                phi_4024_ = -(_e2176[0]);
                            } else {
                                phi_4024_ = _e2176[0];
                            }
                            let _e2183 = phi_4024_;
                            if (_e2176[1] < 0f) {
                                phi_4031_ = -(_e2176[1]);
                            } else {
                                phi_4031_ = _e2176[1];
                            }
                            let _e2187 = phi_4031_;
                            if (_e2183 > _e2187) {
                                phi_4036_ = _e2183;
                            } else {
                                phi_4036_ = _e2187;
                            }
                            let _e2190 = phi_4036_;
                            if (_e2176[2] < 0f) {
                                phi_4043_ = -(_e2176[2]);
                            } else {
                                phi_4043_ = _e2176[2];
                            }
                            let _e2194 = phi_4043_;
                            if (_e2190 > _e2194) {
                                phi_4048_ = _e2190;
                            } else {
                                phi_4048_ = _e2194;
                            }
                            let _e2197 = phi_4048_;
                            if (_e2173 > _e2197) {
                                phi_4053_ = _e2173;
                            } else {
                                phi_4053_ = _e2197;
                            }
                            let _e2200 = phi_4053_;
                            let _e2202 = local_2.member_3;
                            let _e2203 = (_e2200 + _e2202);
                            let _e2205 = ((_e2149 * 8f) * _e2203);
                            let _e2212 = local_2.member_3;
                            if (_e1901 < 0f) {
                                phi_4084_ = -(_e1901);
                            } else {
                                phi_4084_ = _e1901;
                            }
                            let _e2229 = phi_4084_;
                            if (_e1904 < 0f) {
                                phi_4090_ = -(_e1904);
                            } else {
                                phi_4090_ = _e1904;
                            }
                            let _e2233 = phi_4090_;
                            if (_e1907 < 0f) {
                                phi_4097_ = -(_e1907);
                            } else {
                                phi_4097_ = _e1907;
                            }
                            let _e2238 = phi_4097_;
                            let _e2239 = ((_e2229 + _e2233) + _e2238);
                            if (_e1922 < 0f) {
                                phi_4104_ = -(_e1922);
                            } else {
                                phi_4104_ = _e1922;
                            }
                            let _e2243 = phi_4104_;
                            if (_e1925 < 0f) {
                                phi_4110_ = -(_e1925);
                            } else {
                                phi_4110_ = _e1925;
                            }
                            let _e2247 = phi_4110_;
                            if (_e1928 < 0f) {
                                phi_4117_ = -(_e1928);
                            } else {
                                phi_4117_ = _e1928;
                            }
                            let _e2252 = phi_4117_;
                            let _e2253 = ((_e2243 + _e2247) + _e2252);
                            if (_e2239 > _e2253) {
                                phi_4123_ = _e2239;
                            } else {
                                phi_4123_ = _e2253;
                            }
                            let _e2256 = phi_4123_;
                            if (_e1971 < 0f) {
                                phi_4129_ = -(_e1971);
                            } else {
                                phi_4129_ = _e1971;
                            }
                            let _e2260 = phi_4129_;
                            if (_e1972 < 0f) {
                                phi_4135_ = -(_e1972);
                            } else {
                                phi_4135_ = _e1972;
                            }
                            let _e2264 = phi_4135_;
                            if (_e1973 < 0f) {
                                phi_4142_ = -(_e1973);
                            } else {
                                phi_4142_ = _e1973;
                            }
                            let _e2269 = phi_4142_;
                            let _e2271 = (((_e2260 + _e2264) + _e2269) * 0.5f);
                            if (_e2256 > _e2271) {
                                phi_4149_ = _e2256;
                            } else {
                                phi_4149_ = _e2271;
                            }
                            let _e2274 = phi_4149_;
                            let _e2279 = local_2.member_3;
                            let _e2292 = ((((_e1976[0] * _e1901) + (_e1976[1] * _e1904)) + (_e1976[2] * _e1907)) * 3f);
                            let _e2293 = ((((_e2033[0] * _e1922) + (_e2033[1] * _e1925)) + (_e2033[2] * _e1928)) * 3f);
                            if (_e2292 < _e2293) {
                                phi_4173_ = _e2292;
                            } else {
                                phi_4173_ = _e2293;
                            }
                            let _e2296 = phi_4173_;
                            if (_e2007 < _e2030) {
                                phi_4178_ = _e2007;
                            } else {
                                phi_4178_ = _e2030;
                            }
                            let _e2299 = phi_4178_;
                            if (_e2296 < _e2299) {
                                phi_4183_ = _e2296;
                            } else {
                                phi_4183_ = _e2299;
                            }
                            let _e2302 = phi_4183_;
                            if (_e2292 > _e2293) {
                                phi_4188_ = _e2292;
                            } else {
                                phi_4188_ = _e2293;
                            }
                            let _e2305 = phi_4188_;
                            if (_e2007 > _e2030) {
                                phi_4193_ = _e2007;
                            } else {
                                phi_4193_ = _e2030;
                            }
                            let _e2308 = phi_4193_;
                            if (_e2305 > _e2308) {
                                phi_4198_ = _e2305;
                            } else {
                                phi_4198_ = _e2308;
                            }
                            let _e2311 = phi_4198_;
                            let _e2316 = -(_e2311);
                            if (_e2302 > _e2316) {
                                phi_4208_ = _e2302;
                            } else {
                                phi_4208_ = _e2316;
                            }
                            let _e2319 = phi_4208_;
                            let _e2321 = ((_e2319 - ((((((_e2095 * 8f) * _e2205) * (0.000000059604645f * (524f / 64f))) + ((_e2212 * 19f) * ((_e2095 * (_e2149 + _e2203)) + (_e2149 * _e2203)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2095) * ((1f + _e2149) * (1f + _e2203))))) + ((_e1809 * (((_e2274 + (_e2205 * (0.000000059604645f * 8f))) + ((_e2279 * 6f) * (_e2149 + _e2203))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2149) * (1f + _e2203))))) * (3f * 1.0001f)))) > 0f);
                            if _e2321 {
                                phi_5177_ = _e2321;
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
                                    phi_4411_ = -(_e2411[0]);
                                } else {
                                    phi_4411_ = _e2411[0];
                                }
                                let _e2418 = phi_4411_;
                                if (_e2411[1] < 0f) {
                                    phi_4418_ = -(_e2411[1]);
                                } else {
                                    phi_4418_ = _e2411[1];
                                }
                                let _e2422 = phi_4418_;
                                if (_e2418 > _e2422) {
                                    phi_4423_ = _e2418;
                                } else {
                                    phi_4423_ = _e2422;
                                }
                                let _e2425 = phi_4423_;
                                if (_e2411[2] < 0f) {
                                    phi_4430_ = -(_e2411[2]);
                                } else {
                                    phi_4430_ = _e2411[2];
                                }
                                let _e2429 = phi_4430_;
                                if (_e2425 > _e2429) {
                                    phi_4435_ = _e2425;
                                } else {
                                    phi_4435_ = _e2429;
                                }
                                let _e2432 = phi_4435_;
                                let _e2435 = local_2.member[1u];
                                if (_e2435[0] < 0f) {
                                    phi_4448_ = -(_e2435[0]);
                                } else {
                                    phi_4448_ = _e2435[0];
                                }
                                let _e2442 = phi_4448_;
                                if (_e2435[1] < 0f) {
                                    phi_4455_ = -(_e2435[1]);
                                } else {
                                    phi_4455_ = _e2435[1];
                                }
                                let _e2446 = phi_4455_;
                                if (_e2442 > _e2446) {
                                    phi_4460_ = _e2442;
                                } else {
                                    phi_4460_ = _e2446;
                                }
                                let _e2449 = phi_4460_;
                                if (_e2435[2] < 0f) {
                                    phi_4467_ = -(_e2435[2]);
                                } else {
                                    phi_4467_ = _e2435[2];
                                }
                                let _e2453 = phi_4467_;
                                if (_e2449 > _e2453) {
                                    phi_4472_ = _e2449;
                                } else {
                                    phi_4472_ = _e2453;
                                }
                                let _e2456 = phi_4472_;
                                if (_e2432 > _e2456) {
                                    phi_4477_ = _e2432;
                                } else {
                                    phi_4477_ = _e2456;
                                }
                                let _e2459 = phi_4477_;
                                let _e2461 = local_2.member_3;
                                let _e2465 = local_2.member_1[0u];
                                if (_e2465[0] < 0f) {
                                    phi_4494_ = -(_e2465[0]);
                                } else {
                                    phi_4494_ = _e2465[0];
                                }
                                let _e2472 = phi_4494_;
                                if (_e2465[1] < 0f) {
                                    phi_4501_ = -(_e2465[1]);
                                } else {
                                    phi_4501_ = _e2465[1];
                                }
                                let _e2476 = phi_4501_;
                                if (_e2472 > _e2476) {
                                    phi_4506_ = _e2472;
                                } else {
                                    phi_4506_ = _e2476;
                                }
                                let _e2479 = phi_4506_;
                                if (_e2465[2] < 0f) {
                                    phi_4513_ = -(_e2465[2]);
                                } else {
                                    phi_4513_ = _e2465[2];
                                }
                                let _e2483 = phi_4513_;
                                if (_e2479 > _e2483) {
                                    phi_4518_ = _e2479;
                                } else {
                                    phi_4518_ = _e2483;
                                }
                                let _e2486 = phi_4518_;
                                let _e2489 = local_2.member_1[1u];
                                if (_e2489[0] < 0f) {
                                    phi_4532_ = -(_e2489[0]);
                                } else {
                                    phi_4532_ = _e2489[0];
                                }
                                let _e2496 = phi_4532_;
                                if (_e2489[1] < 0f) {
                                    phi_4539_ = -(_e2489[1]);
                                } else {
                                    phi_4539_ = _e2489[1];
                                }
                                let _e2500 = phi_4539_;
                                if (_e2496 > _e2500) {
                                    phi_4544_ = _e2496;
                                } else {
                                    phi_4544_ = _e2500;
                                }
                                let _e2503 = phi_4544_;
                                if (_e2489[2] < 0f) {
                                    phi_4551_ = -(_e2489[2]);
                                } else {
                                    phi_4551_ = _e2489[2];
                                }
                                let _e2507 = phi_4551_;
                                if (_e2503 > _e2507) {
                                    phi_4556_ = _e2503;
                                } else {
                                    phi_4556_ = _e2507;
                                }
                                let _e2510 = phi_4556_;
                                if (_e2486 > _e2510) {
                                    phi_4561_ = _e2486;
                                } else {
                                    phi_4561_ = _e2510;
                                }
                                let _e2513 = phi_4561_;
                                let _e2515 = local_2.member_3;
                                let _e2519 = local_2.member_2[0u];
                                if (_e2519[0] < 0f) {
                                    phi_4578_ = -(_e2519[0]);
                                } else {
                                    phi_4578_ = _e2519[0];
                                }
                                let _e2526 = phi_4578_;
                                if (_e2519[1] < 0f) {
                                    phi_4585_ = -(_e2519[1]);
                                } else {
                                    phi_4585_ = _e2519[1];
                                }
                                let _e2530 = phi_4585_;
                                if (_e2526 > _e2530) {
                                    phi_4590_ = _e2526;
                                } else {
                                    phi_4590_ = _e2530;
                                }
                                let _e2533 = phi_4590_;
                                if (_e2519[2] < 0f) {
                                    phi_4597_ = -(_e2519[2]);
                                } else {
                                    phi_4597_ = _e2519[2];
                                }
                                let _e2537 = phi_4597_;
                                if (_e2533 > _e2537) {
                                    phi_4602_ = _e2533;
                                } else {
                                    phi_4602_ = _e2537;
                                }
                                let _e2540 = phi_4602_;
                                let _e2543 = local_2.member_2[1u];
                                if (_e2543[0] < 0f) {
                                    phi_4616_ = -(_e2543[0]);
                                } else {
                                    phi_4616_ = _e2543[0];
                                }
                                let _e2550 = phi_4616_;
                                if (_e2543[1] < 0f) {
                                    phi_4623_ = -(_e2543[1]);
                                } else {
                                    phi_4623_ = _e2543[1];
                                }
                                let _e2554 = phi_4623_;
                                if (_e2550 > _e2554) {
                                    phi_4628_ = _e2550;
                                } else {
                                    phi_4628_ = _e2554;
                                }
                                let _e2557 = phi_4628_;
                                if (_e2543[2] < 0f) {
                                    phi_4635_ = -(_e2543[2]);
                                } else {
                                    phi_4635_ = _e2543[2];
                                }
                                let _e2561 = phi_4635_;
                                if (_e2557 > _e2561) {
                                    phi_4640_ = _e2557;
                                } else {
                                    phi_4640_ = _e2561;
                                }
                                let _e2564 = phi_4640_;
                                if (_e2540 > _e2564) {
                                    phi_4645_ = _e2540;
                                } else {
                                    phi_4645_ = _e2564;
                                }
                                let _e2567 = phi_4645_;
                                let _e2569 = local_2.member_3;
                                let _e2573 = ((((_e2459 + _e2461) + (_e2513 + _e2515)) + (_e2567 + _e2569)) * 2f);
                                let _e2576 = local_2.member_3;
                                let _e2580 = (((_e1809 * 1.0001f) + (_e2576 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
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
                                    phi_4724_ = _e2594;
                                } else {
                                    phi_4724_ = _e2599;
                                }
                                let _e2632 = phi_4724_;
                                if (_e2604 < _e2609) {
                                    phi_4729_ = _e2604;
                                } else {
                                    phi_4729_ = _e2609;
                                }
                                let _e2635 = phi_4729_;
                                if (_e2632 < _e2635) {
                                    phi_4734_ = _e2632;
                                } else {
                                    phi_4734_ = _e2635;
                                }
                                let _e2638 = phi_4734_;
                                if (_e2614 < _e2619) {
                                    phi_4739_ = _e2614;
                                } else {
                                    phi_4739_ = _e2619;
                                }
                                let _e2641 = phi_4739_;
                                if (_e2624 < _e2629) {
                                    phi_4744_ = _e2624;
                                } else {
                                    phi_4744_ = _e2629;
                                }
                                let _e2644 = phi_4744_;
                                if (_e2641 < _e2644) {
                                    phi_4749_ = _e2641;
                                } else {
                                    phi_4749_ = _e2644;
                                }
                                let _e2647 = phi_4749_;
                                if (_e2638 < _e2647) {
                                    phi_4754_ = _e2638;
                                } else {
                                    phi_4754_ = _e2647;
                                }
                                let _e2650 = phi_4754_;
                                if (_e2594 > _e2599) {
                                    phi_4759_ = _e2594;
                                } else {
                                    phi_4759_ = _e2599;
                                }
                                let _e2653 = phi_4759_;
                                if (_e2604 > _e2609) {
                                    phi_4764_ = _e2604;
                                } else {
                                    phi_4764_ = _e2609;
                                }
                                let _e2656 = phi_4764_;
                                if (_e2653 > _e2656) {
                                    phi_4769_ = _e2653;
                                } else {
                                    phi_4769_ = _e2656;
                                }
                                let _e2659 = phi_4769_;
                                if (_e2614 > _e2619) {
                                    phi_4774_ = _e2614;
                                } else {
                                    phi_4774_ = _e2619;
                                }
                                let _e2662 = phi_4774_;
                                if (_e2624 > _e2629) {
                                    phi_4779_ = _e2624;
                                } else {
                                    phi_4779_ = _e2629;
                                }
                                let _e2665 = phi_4779_;
                                if (_e2662 > _e2665) {
                                    phi_4784_ = _e2662;
                                } else {
                                    phi_4784_ = _e2665;
                                }
                                let _e2668 = phi_4784_;
                                if (_e2659 > _e2668) {
                                    phi_4789_ = _e2659;
                                } else {
                                    phi_4789_ = _e2668;
                                }
                                let _e2671 = phi_4789_;
                                if (_e2583 < 0f) {
                                    phi_4795_ = -(_e2583);
                                } else {
                                    phi_4795_ = _e2583;
                                }
                                let _e2675 = phi_4795_;
                                if (_e2586 < 0f) {
                                    phi_4801_ = -(_e2586);
                                } else {
                                    phi_4801_ = _e2586;
                                }
                                let _e2679 = phi_4801_;
                                if (_e2589 < 0f) {
                                    phi_4808_ = -(_e2589);
                                } else {
                                    phi_4808_ = _e2589;
                                }
                                let _e2684 = phi_4808_;
                                let _e2685 = ((_e2675 + _e2679) + _e2684);
                                let _e2690 = -(_e2671);
                                if (_e2650 > _e2690) {
                                    phi_4819_ = _e2650;
                                } else {
                                    phi_4819_ = _e2690;
                                }
                                let _e2693 = phi_4819_;
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
                                    phi_4890_ = _e2712;
                                } else {
                                    phi_4890_ = _e2717;
                                }
                                let _e2750 = phi_4890_;
                                if (_e2722 < _e2727) {
                                    phi_4895_ = _e2722;
                                } else {
                                    phi_4895_ = _e2727;
                                }
                                let _e2753 = phi_4895_;
                                if (_e2750 < _e2753) {
                                    phi_4900_ = _e2750;
                                } else {
                                    phi_4900_ = _e2753;
                                }
                                let _e2756 = phi_4900_;
                                if (_e2732 < _e2737) {
                                    phi_4905_ = _e2732;
                                } else {
                                    phi_4905_ = _e2737;
                                }
                                let _e2759 = phi_4905_;
                                if (_e2742 < _e2747) {
                                    phi_4910_ = _e2742;
                                } else {
                                    phi_4910_ = _e2747;
                                }
                                let _e2762 = phi_4910_;
                                if (_e2759 < _e2762) {
                                    phi_4915_ = _e2759;
                                } else {
                                    phi_4915_ = _e2762;
                                }
                                let _e2765 = phi_4915_;
                                if (_e2756 < _e2765) {
                                    phi_4920_ = _e2756;
                                } else {
                                    phi_4920_ = _e2765;
                                }
                                let _e2768 = phi_4920_;
                                if (_e2712 > _e2717) {
                                    phi_4925_ = _e2712;
                                } else {
                                    phi_4925_ = _e2717;
                                }
                                let _e2771 = phi_4925_;
                                if (_e2722 > _e2727) {
                                    phi_4930_ = _e2722;
                                } else {
                                    phi_4930_ = _e2727;
                                }
                                let _e2774 = phi_4930_;
                                if (_e2771 > _e2774) {
                                    phi_4935_ = _e2771;
                                } else {
                                    phi_4935_ = _e2774;
                                }
                                let _e2777 = phi_4935_;
                                if (_e2732 > _e2737) {
                                    phi_4940_ = _e2732;
                                } else {
                                    phi_4940_ = _e2737;
                                }
                                let _e2780 = phi_4940_;
                                if (_e2742 > _e2747) {
                                    phi_4945_ = _e2742;
                                } else {
                                    phi_4945_ = _e2747;
                                }
                                let _e2783 = phi_4945_;
                                if (_e2780 > _e2783) {
                                    phi_4950_ = _e2780;
                                } else {
                                    phi_4950_ = _e2783;
                                }
                                let _e2786 = phi_4950_;
                                if (_e2777 > _e2786) {
                                    phi_4955_ = _e2777;
                                } else {
                                    phi_4955_ = _e2786;
                                }
                                let _e2789 = phi_4955_;
                                if (_e2701 < 0f) {
                                    phi_4961_ = -(_e2701);
                                } else {
                                    phi_4961_ = _e2701;
                                }
                                let _e2793 = phi_4961_;
                                if (_e2704 < 0f) {
                                    phi_4967_ = -(_e2704);
                                } else {
                                    phi_4967_ = _e2704;
                                }
                                let _e2797 = phi_4967_;
                                if (_e2707 < 0f) {
                                    phi_4974_ = -(_e2707);
                                } else {
                                    phi_4974_ = _e2707;
                                }
                                let _e2802 = phi_4974_;
                                let _e2803 = ((_e2793 + _e2797) + _e2802);
                                let _e2808 = -(_e2789);
                                if (_e2768 > _e2808) {
                                    phi_4985_ = _e2768;
                                } else {
                                    phi_4985_ = _e2808;
                                }
                                let _e2811 = phi_4985_;
                                let _e2816 = (((_e2811 - ((_e2803 * _e2573) * (0.000000059604645f * (17f / 2f)))) - (_e2803 * _e2580)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2698 > _e2816) {
                                    phi_4995_ = _e2698;
                                } else {
                                    phi_4995_ = _e2816;
                                }
                                let _e2819 = phi_4995_;
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
                                    phi_5068_ = _e2836;
                                } else {
                                    phi_5068_ = _e2841;
                                }
                                let _e2874 = phi_5068_;
                                if (_e2846 < _e2851) {
                                    phi_5073_ = _e2846;
                                } else {
                                    phi_5073_ = _e2851;
                                }
                                let _e2877 = phi_5073_;
                                if (_e2874 < _e2877) {
                                    phi_5078_ = _e2874;
                                } else {
                                    phi_5078_ = _e2877;
                                }
                                let _e2880 = phi_5078_;
                                if (_e2856 < _e2861) {
                                    phi_5083_ = _e2856;
                                } else {
                                    phi_5083_ = _e2861;
                                }
                                let _e2883 = phi_5083_;
                                if (_e2866 < _e2871) {
                                    phi_5088_ = _e2866;
                                } else {
                                    phi_5088_ = _e2871;
                                }
                                let _e2886 = phi_5088_;
                                if (_e2883 < _e2886) {
                                    phi_5093_ = _e2883;
                                } else {
                                    phi_5093_ = _e2886;
                                }
                                let _e2889 = phi_5093_;
                                if (_e2880 < _e2889) {
                                    phi_5098_ = _e2880;
                                } else {
                                    phi_5098_ = _e2889;
                                }
                                let _e2892 = phi_5098_;
                                if (_e2836 > _e2841) {
                                    phi_5103_ = _e2836;
                                } else {
                                    phi_5103_ = _e2841;
                                }
                                let _e2895 = phi_5103_;
                                if (_e2846 > _e2851) {
                                    phi_5108_ = _e2846;
                                } else {
                                    phi_5108_ = _e2851;
                                }
                                let _e2898 = phi_5108_;
                                if (_e2895 > _e2898) {
                                    phi_5113_ = _e2895;
                                } else {
                                    phi_5113_ = _e2898;
                                }
                                let _e2901 = phi_5113_;
                                if (_e2856 > _e2861) {
                                    phi_5118_ = _e2856;
                                } else {
                                    phi_5118_ = _e2861;
                                }
                                let _e2904 = phi_5118_;
                                if (_e2866 > _e2871) {
                                    phi_5123_ = _e2866;
                                } else {
                                    phi_5123_ = _e2871;
                                }
                                let _e2907 = phi_5123_;
                                if (_e2904 > _e2907) {
                                    phi_5128_ = _e2904;
                                } else {
                                    phi_5128_ = _e2907;
                                }
                                let _e2910 = phi_5128_;
                                if (_e2901 > _e2910) {
                                    phi_5133_ = _e2901;
                                } else {
                                    phi_5133_ = _e2910;
                                }
                                let _e2913 = phi_5133_;
                                if (_e2825 < 0f) {
                                    phi_5139_ = -(_e2825);
                                } else {
                                    phi_5139_ = _e2825;
                                }
                                let _e2917 = phi_5139_;
                                if (_e2828 < 0f) {
                                    phi_5145_ = -(_e2828);
                                } else {
                                    phi_5145_ = _e2828;
                                }
                                let _e2921 = phi_5145_;
                                if (_e2831 < 0f) {
                                    phi_5152_ = -(_e2831);
                                } else {
                                    phi_5152_ = _e2831;
                                }
                                let _e2926 = phi_5152_;
                                let _e2927 = ((_e2917 + _e2921) + _e2926);
                                let _e2932 = -(_e2913);
                                if (_e2892 > _e2932) {
                                    phi_5163_ = _e2892;
                                } else {
                                    phi_5163_ = _e2932;
                                }
                                let _e2935 = phi_5163_;
                                let _e2940 = (((_e2935 - ((_e2927 * _e2573) * (0.000000059604645f * (17f / 2f)))) - (_e2927 * _e2580)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2819 > _e2940) {
                                    phi_5173_ = _e2819;
                                } else {
                                    phi_5173_ = _e2940;
                                }
                                let _e2943 = phi_5173_;
                                phi_5177_ = (_e2321 || (_e2943 > 0f));
                            }
                            let _e2947 = phi_5177_;
                            if _e2947 {
                                phi_8594_ = _e2947;
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
                                    phi_5629_ = -(_e3195[0]);
                                } else {
                                    phi_5629_ = _e3195[0];
                                }
                                let _e3202 = phi_5629_;
                                if (_e3195[1] < 0f) {
                                    phi_5636_ = -(_e3195[1]);
                                } else {
                                    phi_5636_ = _e3195[1];
                                }
                                let _e3206 = phi_5636_;
                                if (_e3202 > _e3206) {
                                    phi_5641_ = _e3202;
                                } else {
                                    phi_5641_ = _e3206;
                                }
                                let _e3209 = phi_5641_;
                                if (_e3195[2] < 0f) {
                                    phi_5648_ = -(_e3195[2]);
                                } else {
                                    phi_5648_ = _e3195[2];
                                }
                                let _e3213 = phi_5648_;
                                if (_e3209 > _e3213) {
                                    phi_5653_ = _e3209;
                                } else {
                                    phi_5653_ = _e3213;
                                }
                                let _e3216 = phi_5653_;
                                let _e3219 = local.member[1u];
                                if (_e3219[0] < 0f) {
                                    phi_5666_ = -(_e3219[0]);
                                } else {
                                    phi_5666_ = _e3219[0];
                                }
                                let _e3226 = phi_5666_;
                                if (_e3219[1] < 0f) {
                                    phi_5673_ = -(_e3219[1]);
                                } else {
                                    phi_5673_ = _e3219[1];
                                }
                                let _e3230 = phi_5673_;
                                if (_e3226 > _e3230) {
                                    phi_5678_ = _e3226;
                                } else {
                                    phi_5678_ = _e3230;
                                }
                                let _e3233 = phi_5678_;
                                if (_e3219[2] < 0f) {
                                    phi_5685_ = -(_e3219[2]);
                                } else {
                                    phi_5685_ = _e3219[2];
                                }
                                let _e3237 = phi_5685_;
                                if (_e3233 > _e3237) {
                                    phi_5690_ = _e3233;
                                } else {
                                    phi_5690_ = _e3237;
                                }
                                let _e3240 = phi_5690_;
                                if (_e3216 > _e3240) {
                                    phi_5695_ = _e3216;
                                } else {
                                    phi_5695_ = _e3240;
                                }
                                let _e3243 = phi_5695_;
                                let _e3245 = local.member_3;
                                let _e3246 = (_e3243 + _e3245);
                                let _e3249 = local.member_1[0u];
                                if (_e3249[0] < 0f) {
                                    phi_5712_ = -(_e3249[0]);
                                } else {
                                    phi_5712_ = _e3249[0];
                                }
                                let _e3256 = phi_5712_;
                                if (_e3249[1] < 0f) {
                                    phi_5719_ = -(_e3249[1]);
                                } else {
                                    phi_5719_ = _e3249[1];
                                }
                                let _e3260 = phi_5719_;
                                if (_e3256 > _e3260) {
                                    phi_5724_ = _e3256;
                                } else {
                                    phi_5724_ = _e3260;
                                }
                                let _e3263 = phi_5724_;
                                if (_e3249[2] < 0f) {
                                    phi_5731_ = -(_e3249[2]);
                                } else {
                                    phi_5731_ = _e3249[2];
                                }
                                let _e3267 = phi_5731_;
                                if (_e3263 > _e3267) {
                                    phi_5736_ = _e3263;
                                } else {
                                    phi_5736_ = _e3267;
                                }
                                let _e3270 = phi_5736_;
                                let _e3273 = local.member_1[1u];
                                if (_e3273[0] < 0f) {
                                    phi_5750_ = -(_e3273[0]);
                                } else {
                                    phi_5750_ = _e3273[0];
                                }
                                let _e3280 = phi_5750_;
                                if (_e3273[1] < 0f) {
                                    phi_5757_ = -(_e3273[1]);
                                } else {
                                    phi_5757_ = _e3273[1];
                                }
                                let _e3284 = phi_5757_;
                                if (_e3280 > _e3284) {
                                    phi_5762_ = _e3280;
                                } else {
                                    phi_5762_ = _e3284;
                                }
                                let _e3287 = phi_5762_;
                                if (_e3273[2] < 0f) {
                                    phi_5769_ = -(_e3273[2]);
                                } else {
                                    phi_5769_ = _e3273[2];
                                }
                                let _e3291 = phi_5769_;
                                if (_e3287 > _e3291) {
                                    phi_5774_ = _e3287;
                                } else {
                                    phi_5774_ = _e3291;
                                }
                                let _e3294 = phi_5774_;
                                if (_e3270 > _e3294) {
                                    phi_5779_ = _e3270;
                                } else {
                                    phi_5779_ = _e3294;
                                }
                                let _e3297 = phi_5779_;
                                let _e3299 = local.member_3;
                                let _e3300 = (_e3297 + _e3299);
                                let _e3303 = local.member_2[0u];
                                if (_e3303[0] < 0f) {
                                    phi_5796_ = -(_e3303[0]);
                                } else {
                                    phi_5796_ = _e3303[0];
                                }
                                let _e3310 = phi_5796_;
                                if (_e3303[1] < 0f) {
                                    phi_5803_ = -(_e3303[1]);
                                } else {
                                    phi_5803_ = _e3303[1];
                                }
                                let _e3314 = phi_5803_;
                                if (_e3310 > _e3314) {
                                    phi_5808_ = _e3310;
                                } else {
                                    phi_5808_ = _e3314;
                                }
                                let _e3317 = phi_5808_;
                                if (_e3303[2] < 0f) {
                                    phi_5815_ = -(_e3303[2]);
                                } else {
                                    phi_5815_ = _e3303[2];
                                }
                                let _e3321 = phi_5815_;
                                if (_e3317 > _e3321) {
                                    phi_5820_ = _e3317;
                                } else {
                                    phi_5820_ = _e3321;
                                }
                                let _e3324 = phi_5820_;
                                let _e3327 = local.member_2[1u];
                                if (_e3327[0] < 0f) {
                                    phi_5834_ = -(_e3327[0]);
                                } else {
                                    phi_5834_ = _e3327[0];
                                }
                                let _e3334 = phi_5834_;
                                if (_e3327[1] < 0f) {
                                    phi_5841_ = -(_e3327[1]);
                                } else {
                                    phi_5841_ = _e3327[1];
                                }
                                let _e3338 = phi_5841_;
                                if (_e3334 > _e3338) {
                                    phi_5846_ = _e3334;
                                } else {
                                    phi_5846_ = _e3338;
                                }
                                let _e3341 = phi_5846_;
                                if (_e3327[2] < 0f) {
                                    phi_5853_ = -(_e3327[2]);
                                } else {
                                    phi_5853_ = _e3327[2];
                                }
                                let _e3345 = phi_5853_;
                                if (_e3341 > _e3345) {
                                    phi_5858_ = _e3341;
                                } else {
                                    phi_5858_ = _e3345;
                                }
                                let _e3348 = phi_5858_;
                                if (_e3324 > _e3348) {
                                    phi_5863_ = _e3324;
                                } else {
                                    phi_5863_ = _e3348;
                                }
                                let _e3351 = phi_5863_;
                                let _e3353 = local.member_3;
                                let _e3354 = (_e3351 + _e3353);
                                let _e3356 = ((_e3300 * 8f) * _e3354);
                                let _e3363 = local.member_3;
                                if (_e3052 < 0f) {
                                    phi_5894_ = -(_e3052);
                                } else {
                                    phi_5894_ = _e3052;
                                }
                                let _e3380 = phi_5894_;
                                if (_e3055 < 0f) {
                                    phi_5900_ = -(_e3055);
                                } else {
                                    phi_5900_ = _e3055;
                                }
                                let _e3384 = phi_5900_;
                                if (_e3058 < 0f) {
                                    phi_5907_ = -(_e3058);
                                } else {
                                    phi_5907_ = _e3058;
                                }
                                let _e3389 = phi_5907_;
                                let _e3390 = ((_e3380 + _e3384) + _e3389);
                                if (_e3073 < 0f) {
                                    phi_5914_ = -(_e3073);
                                } else {
                                    phi_5914_ = _e3073;
                                }
                                let _e3394 = phi_5914_;
                                if (_e3076 < 0f) {
                                    phi_5920_ = -(_e3076);
                                } else {
                                    phi_5920_ = _e3076;
                                }
                                let _e3398 = phi_5920_;
                                if (_e3079 < 0f) {
                                    phi_5927_ = -(_e3079);
                                } else {
                                    phi_5927_ = _e3079;
                                }
                                let _e3403 = phi_5927_;
                                let _e3404 = ((_e3394 + _e3398) + _e3403);
                                if (_e3390 > _e3404) {
                                    phi_5933_ = _e3390;
                                } else {
                                    phi_5933_ = _e3404;
                                }
                                let _e3407 = phi_5933_;
                                if (_e3122 < 0f) {
                                    phi_5939_ = -(_e3122);
                                } else {
                                    phi_5939_ = _e3122;
                                }
                                let _e3411 = phi_5939_;
                                if (_e3123 < 0f) {
                                    phi_5945_ = -(_e3123);
                                } else {
                                    phi_5945_ = _e3123;
                                }
                                let _e3415 = phi_5945_;
                                if (_e3124 < 0f) {
                                    phi_5952_ = -(_e3124);
                                } else {
                                    phi_5952_ = _e3124;
                                }
                                let _e3420 = phi_5952_;
                                let _e3422 = (((_e3411 + _e3415) + _e3420) * 0.5f);
                                if (_e3407 > _e3422) {
                                    phi_5959_ = _e3407;
                                } else {
                                    phi_5959_ = _e3422;
                                }
                                let _e3425 = phi_5959_;
                                let _e3430 = local.member_3;
                                let _e3443 = ((((_e3127[0] * _e3052) + (_e3127[1] * _e3055)) + (_e3127[2] * _e3058)) * 3f);
                                let _e3444 = ((((_e3184[0] * _e3073) + (_e3184[1] * _e3076)) + (_e3184[2] * _e3079)) * 3f);
                                if (_e3443 < _e3444) {
                                    phi_5983_ = _e3443;
                                } else {
                                    phi_5983_ = _e3444;
                                }
                                let _e3447 = phi_5983_;
                                if (_e3158 < _e3181) {
                                    phi_5988_ = _e3158;
                                } else {
                                    phi_5988_ = _e3181;
                                }
                                let _e3450 = phi_5988_;
                                if (_e3447 < _e3450) {
                                    phi_5993_ = _e3447;
                                } else {
                                    phi_5993_ = _e3450;
                                }
                                let _e3453 = phi_5993_;
                                if (_e3443 > _e3444) {
                                    phi_5998_ = _e3443;
                                } else {
                                    phi_5998_ = _e3444;
                                }
                                let _e3456 = phi_5998_;
                                if (_e3158 > _e3181) {
                                    phi_6003_ = _e3158;
                                } else {
                                    phi_6003_ = _e3181;
                                }
                                let _e3459 = phi_6003_;
                                if (_e3456 > _e3459) {
                                    phi_6008_ = _e3456;
                                } else {
                                    phi_6008_ = _e3459;
                                }
                                let _e3462 = phi_6008_;
                                let _e3467 = -(_e3462);
                                if (_e3453 > _e3467) {
                                    phi_6018_ = _e3453;
                                } else {
                                    phi_6018_ = _e3467;
                                }
                                let _e3470 = phi_6018_;
                                let _e3472 = ((_e3470 - ((((((_e3246 * 8f) * _e3356) * (0.000000059604645f * (524f / 64f))) + ((_e3363 * 19f) * ((_e3246 * (_e3300 + _e3354)) + (_e3300 * _e3354)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3246) * ((1f + _e3300) * (1f + _e3354))))) + ((_e1809 * (((_e3425 + (_e3356 * (0.000000059604645f * 8f))) + ((_e3430 * 6f) * (_e3300 + _e3354))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3300) * (1f + _e3354))))) * (3f * 1.0001f)))) > 0f);
                                if _e3472 {
                                    phi_6987_ = _e3472;
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
                                        phi_6221_ = -(_e3562[0]);
                                    } else {
                                        phi_6221_ = _e3562[0];
                                    }
                                    let _e3569 = phi_6221_;
                                    if (_e3562[1] < 0f) {
                                        phi_6228_ = -(_e3562[1]);
                                    } else {
                                        phi_6228_ = _e3562[1];
                                    }
                                    let _e3573 = phi_6228_;
                                    if (_e3569 > _e3573) {
                                        phi_6233_ = _e3569;
                                    } else {
                                        phi_6233_ = _e3573;
                                    }
                                    let _e3576 = phi_6233_;
                                    if (_e3562[2] < 0f) {
                                        phi_6240_ = -(_e3562[2]);
                                    } else {
                                        phi_6240_ = _e3562[2];
                                    }
                                    let _e3580 = phi_6240_;
                                    if (_e3576 > _e3580) {
                                        phi_6245_ = _e3576;
                                    } else {
                                        phi_6245_ = _e3580;
                                    }
                                    let _e3583 = phi_6245_;
                                    let _e3586 = local.member[1u];
                                    if (_e3586[0] < 0f) {
                                        phi_6258_ = -(_e3586[0]);
                                    } else {
                                        phi_6258_ = _e3586[0];
                                    }
                                    let _e3593 = phi_6258_;
                                    if (_e3586[1] < 0f) {
                                        phi_6265_ = -(_e3586[1]);
                                    } else {
                                        phi_6265_ = _e3586[1];
                                    }
                                    let _e3597 = phi_6265_;
                                    if (_e3593 > _e3597) {
                                        phi_6270_ = _e3593;
                                    } else {
                                        phi_6270_ = _e3597;
                                    }
                                    let _e3600 = phi_6270_;
                                    if (_e3586[2] < 0f) {
                                        phi_6277_ = -(_e3586[2]);
                                    } else {
                                        phi_6277_ = _e3586[2];
                                    }
                                    let _e3604 = phi_6277_;
                                    if (_e3600 > _e3604) {
                                        phi_6282_ = _e3600;
                                    } else {
                                        phi_6282_ = _e3604;
                                    }
                                    let _e3607 = phi_6282_;
                                    if (_e3583 > _e3607) {
                                        phi_6287_ = _e3583;
                                    } else {
                                        phi_6287_ = _e3607;
                                    }
                                    let _e3610 = phi_6287_;
                                    let _e3612 = local.member_3;
                                    let _e3616 = local.member_1[0u];
                                    if (_e3616[0] < 0f) {
                                        phi_6304_ = -(_e3616[0]);
                                    } else {
                                        phi_6304_ = _e3616[0];
                                    }
                                    let _e3623 = phi_6304_;
                                    if (_e3616[1] < 0f) {
                                        phi_6311_ = -(_e3616[1]);
                                    } else {
                                        phi_6311_ = _e3616[1];
                                    }
                                    let _e3627 = phi_6311_;
                                    if (_e3623 > _e3627) {
                                        phi_6316_ = _e3623;
                                    } else {
                                        phi_6316_ = _e3627;
                                    }
                                    let _e3630 = phi_6316_;
                                    if (_e3616[2] < 0f) {
                                        phi_6323_ = -(_e3616[2]);
                                    } else {
                                        phi_6323_ = _e3616[2];
                                    }
                                    let _e3634 = phi_6323_;
                                    if (_e3630 > _e3634) {
                                        phi_6328_ = _e3630;
                                    } else {
                                        phi_6328_ = _e3634;
                                    }
                                    let _e3637 = phi_6328_;
                                    let _e3640 = local.member_1[1u];
                                    if (_e3640[0] < 0f) {
                                        phi_6342_ = -(_e3640[0]);
                                    } else {
                                        phi_6342_ = _e3640[0];
                                    }
                                    let _e3647 = phi_6342_;
                                    if (_e3640[1] < 0f) {
                                        phi_6349_ = -(_e3640[1]);
                                    } else {
                                        phi_6349_ = _e3640[1];
                                    }
                                    let _e3651 = phi_6349_;
                                    if (_e3647 > _e3651) {
                                        phi_6354_ = _e3647;
                                    } else {
                                        phi_6354_ = _e3651;
                                    }
                                    let _e3654 = phi_6354_;
                                    if (_e3640[2] < 0f) {
                                        phi_6361_ = -(_e3640[2]);
                                    } else {
                                        phi_6361_ = _e3640[2];
                                    }
                                    let _e3658 = phi_6361_;
                                    if (_e3654 > _e3658) {
                                        phi_6366_ = _e3654;
                                    } else {
                                        phi_6366_ = _e3658;
                                    }
                                    let _e3661 = phi_6366_;
                                    if (_e3637 > _e3661) {
                                        phi_6371_ = _e3637;
                                    } else {
                                        phi_6371_ = _e3661;
                                    }
                                    let _e3664 = phi_6371_;
                                    let _e3666 = local.member_3;
                                    let _e3670 = local.member_2[0u];
                                    if (_e3670[0] < 0f) {
                                        phi_6388_ = -(_e3670[0]);
                                    } else {
                                        phi_6388_ = _e3670[0];
                                    }
                                    let _e3677 = phi_6388_;
                                    if (_e3670[1] < 0f) {
                                        phi_6395_ = -(_e3670[1]);
                                    } else {
                                        phi_6395_ = _e3670[1];
                                    }
                                    let _e3681 = phi_6395_;
                                    if (_e3677 > _e3681) {
                                        phi_6400_ = _e3677;
                                    } else {
                                        phi_6400_ = _e3681;
                                    }
                                    let _e3684 = phi_6400_;
                                    if (_e3670[2] < 0f) {
                                        phi_6407_ = -(_e3670[2]);
                                    } else {
                                        phi_6407_ = _e3670[2];
                                    }
                                    let _e3688 = phi_6407_;
                                    if (_e3684 > _e3688) {
                                        phi_6412_ = _e3684;
                                    } else {
                                        phi_6412_ = _e3688;
                                    }
                                    let _e3691 = phi_6412_;
                                    let _e3694 = local.member_2[1u];
                                    if (_e3694[0] < 0f) {
                                        phi_6426_ = -(_e3694[0]);
                                    } else {
                                        phi_6426_ = _e3694[0];
                                    }
                                    let _e3701 = phi_6426_;
                                    if (_e3694[1] < 0f) {
                                        phi_6433_ = -(_e3694[1]);
                                    } else {
                                        phi_6433_ = _e3694[1];
                                    }
                                    let _e3705 = phi_6433_;
                                    if (_e3701 > _e3705) {
                                        phi_6438_ = _e3701;
                                    } else {
                                        phi_6438_ = _e3705;
                                    }
                                    let _e3708 = phi_6438_;
                                    if (_e3694[2] < 0f) {
                                        phi_6445_ = -(_e3694[2]);
                                    } else {
                                        phi_6445_ = _e3694[2];
                                    }
                                    let _e3712 = phi_6445_;
                                    if (_e3708 > _e3712) {
                                        phi_6450_ = _e3708;
                                    } else {
                                        phi_6450_ = _e3712;
                                    }
                                    let _e3715 = phi_6450_;
                                    if (_e3691 > _e3715) {
                                        phi_6455_ = _e3691;
                                    } else {
                                        phi_6455_ = _e3715;
                                    }
                                    let _e3718 = phi_6455_;
                                    let _e3720 = local.member_3;
                                    let _e3724 = ((((_e3610 + _e3612) + (_e3664 + _e3666)) + (_e3718 + _e3720)) * 2f);
                                    let _e3727 = local.member_3;
                                    let _e3731 = (((_e1809 * 1.0001f) + (_e3727 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
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
                                        phi_6534_ = _e3745;
                                    } else {
                                        phi_6534_ = _e3750;
                                    }
                                    let _e3783 = phi_6534_;
                                    if (_e3755 < _e3760) {
                                        phi_6539_ = _e3755;
                                    } else {
                                        phi_6539_ = _e3760;
                                    }
                                    let _e3786 = phi_6539_;
                                    if (_e3783 < _e3786) {
                                        phi_6544_ = _e3783;
                                    } else {
                                        phi_6544_ = _e3786;
                                    }
                                    let _e3789 = phi_6544_;
                                    if (_e3765 < _e3770) {
                                        phi_6549_ = _e3765;
                                    } else {
                                        phi_6549_ = _e3770;
                                    }
                                    let _e3792 = phi_6549_;
                                    if (_e3775 < _e3780) {
                                        phi_6554_ = _e3775;
                                    } else {
                                        phi_6554_ = _e3780;
                                    }
                                    let _e3795 = phi_6554_;
                                    if (_e3792 < _e3795) {
                                        phi_6559_ = _e3792;
                                    } else {
                                        phi_6559_ = _e3795;
                                    }
                                    let _e3798 = phi_6559_;
                                    if (_e3789 < _e3798) {
                                        phi_6564_ = _e3789;
                                    } else {
                                        phi_6564_ = _e3798;
                                    }
                                    let _e3801 = phi_6564_;
                                    if (_e3745 > _e3750) {
                                        phi_6569_ = _e3745;
                                    } else {
                                        phi_6569_ = _e3750;
                                    }
                                    let _e3804 = phi_6569_;
                                    if (_e3755 > _e3760) {
                                        phi_6574_ = _e3755;
                                    } else {
                                        phi_6574_ = _e3760;
                                    }
                                    let _e3807 = phi_6574_;
                                    if (_e3804 > _e3807) {
                                        phi_6579_ = _e3804;
                                    } else {
                                        phi_6579_ = _e3807;
                                    }
                                    let _e3810 = phi_6579_;
                                    if (_e3765 > _e3770) {
                                        phi_6584_ = _e3765;
                                    } else {
                                        phi_6584_ = _e3770;
                                    }
                                    let _e3813 = phi_6584_;
                                    if (_e3775 > _e3780) {
                                        phi_6589_ = _e3775;
                                    } else {
                                        phi_6589_ = _e3780;
                                    }
                                    let _e3816 = phi_6589_;
                                    if (_e3813 > _e3816) {
                                        phi_6594_ = _e3813;
                                    } else {
                                        phi_6594_ = _e3816;
                                    }
                                    let _e3819 = phi_6594_;
                                    if (_e3810 > _e3819) {
                                        phi_6599_ = _e3810;
                                    } else {
                                        phi_6599_ = _e3819;
                                    }
                                    let _e3822 = phi_6599_;
                                    if (_e3734 < 0f) {
                                        phi_6605_ = -(_e3734);
                                    } else {
                                        phi_6605_ = _e3734;
                                    }
                                    let _e3826 = phi_6605_;
                                    if (_e3737 < 0f) {
                                        phi_6611_ = -(_e3737);
                                    } else {
                                        phi_6611_ = _e3737;
                                    }
                                    let _e3830 = phi_6611_;
                                    if (_e3740 < 0f) {
                                        phi_6618_ = -(_e3740);
                                    } else {
                                        phi_6618_ = _e3740;
                                    }
                                    let _e3835 = phi_6618_;
                                    let _e3836 = ((_e3826 + _e3830) + _e3835);
                                    let _e3841 = -(_e3822);
                                    if (_e3801 > _e3841) {
                                        phi_6629_ = _e3801;
                                    } else {
                                        phi_6629_ = _e3841;
                                    }
                                    let _e3844 = phi_6629_;
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
                                        phi_6700_ = _e3863;
                                    } else {
                                        phi_6700_ = _e3868;
                                    }
                                    let _e3901 = phi_6700_;
                                    if (_e3873 < _e3878) {
                                        phi_6705_ = _e3873;
                                    } else {
                                        phi_6705_ = _e3878;
                                    }
                                    let _e3904 = phi_6705_;
                                    if (_e3901 < _e3904) {
                                        phi_6710_ = _e3901;
                                    } else {
                                        phi_6710_ = _e3904;
                                    }
                                    let _e3907 = phi_6710_;
                                    if (_e3883 < _e3888) {
                                        phi_6715_ = _e3883;
                                    } else {
                                        phi_6715_ = _e3888;
                                    }
                                    let _e3910 = phi_6715_;
                                    if (_e3893 < _e3898) {
                                        phi_6720_ = _e3893;
                                    } else {
                                        phi_6720_ = _e3898;
                                    }
                                    let _e3913 = phi_6720_;
                                    if (_e3910 < _e3913) {
                                        phi_6725_ = _e3910;
                                    } else {
                                        phi_6725_ = _e3913;
                                    }
                                    let _e3916 = phi_6725_;
                                    if (_e3907 < _e3916) {
                                        phi_6730_ = _e3907;
                                    } else {
                                        phi_6730_ = _e3916;
                                    }
                                    let _e3919 = phi_6730_;
                                    if (_e3863 > _e3868) {
                                        phi_6735_ = _e3863;
                                    } else {
                                        phi_6735_ = _e3868;
                                    }
                                    let _e3922 = phi_6735_;
                                    if (_e3873 > _e3878) {
                                        phi_6740_ = _e3873;
                                    } else {
                                        phi_6740_ = _e3878;
                                    }
                                    let _e3925 = phi_6740_;
                                    if (_e3922 > _e3925) {
                                        phi_6745_ = _e3922;
                                    } else {
                                        phi_6745_ = _e3925;
                                    }
                                    let _e3928 = phi_6745_;
                                    if (_e3883 > _e3888) {
                                        phi_6750_ = _e3883;
                                    } else {
                                        phi_6750_ = _e3888;
                                    }
                                    let _e3931 = phi_6750_;
                                    if (_e3893 > _e3898) {
                                        phi_6755_ = _e3893;
                                    } else {
                                        phi_6755_ = _e3898;
                                    }
                                    let _e3934 = phi_6755_;
                                    if (_e3931 > _e3934) {
                                        phi_6760_ = _e3931;
                                    } else {
                                        phi_6760_ = _e3934;
                                    }
                                    let _e3937 = phi_6760_;
                                    if (_e3928 > _e3937) {
                                        phi_6765_ = _e3928;
                                    } else {
                                        phi_6765_ = _e3937;
                                    }
                                    let _e3940 = phi_6765_;
                                    if (_e3852 < 0f) {
                                        phi_6771_ = -(_e3852);
                                    } else {
                                        phi_6771_ = _e3852;
                                    }
                                    let _e3944 = phi_6771_;
                                    if (_e3855 < 0f) {
                                        phi_6777_ = -(_e3855);
                                    } else {
                                        phi_6777_ = _e3855;
                                    }
                                    let _e3948 = phi_6777_;
                                    if (_e3858 < 0f) {
                                        phi_6784_ = -(_e3858);
                                    } else {
                                        phi_6784_ = _e3858;
                                    }
                                    let _e3953 = phi_6784_;
                                    let _e3954 = ((_e3944 + _e3948) + _e3953);
                                    let _e3959 = -(_e3940);
                                    if (_e3919 > _e3959) {
                                        phi_6795_ = _e3919;
                                    } else {
                                        phi_6795_ = _e3959;
                                    }
                                    let _e3962 = phi_6795_;
                                    let _e3967 = (((_e3962 - ((_e3954 * _e3724) * (0.000000059604645f * (17f / 2f)))) - (_e3954 * _e3731)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3849 > _e3967) {
                                        phi_6805_ = _e3849;
                                    } else {
                                        phi_6805_ = _e3967;
                                    }
                                    let _e3970 = phi_6805_;
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
                                        phi_6878_ = _e3987;
                                    } else {
                                        phi_6878_ = _e3992;
                                    }
                                    let _e4025 = phi_6878_;
                                    if (_e3997 < _e4002) {
                                        phi_6883_ = _e3997;
                                    } else {
                                        phi_6883_ = _e4002;
                                    }
                                    let _e4028 = phi_6883_;
                                    if (_e4025 < _e4028) {
                                        phi_6888_ = _e4025;
                                    } else {
                                        phi_6888_ = _e4028;
                                    }
                                    let _e4031 = phi_6888_;
                                    if (_e4007 < _e4012) {
                                        phi_6893_ = _e4007;
                                    } else {
                                        phi_6893_ = _e4012;
                                    }
                                    let _e4034 = phi_6893_;
                                    if (_e4017 < _e4022) {
                                        phi_6898_ = _e4017;
                                    } else {
                                        phi_6898_ = _e4022;
                                    }
                                    let _e4037 = phi_6898_;
                                    if (_e4034 < _e4037) {
                                        phi_6903_ = _e4034;
                                    } else {
                                        phi_6903_ = _e4037;
                                    }
                                    let _e4040 = phi_6903_;
                                    if (_e4031 < _e4040) {
                                        phi_6908_ = _e4031;
                                    } else {
                                        phi_6908_ = _e4040;
                                    }
                                    let _e4043 = phi_6908_;
                                    if (_e3987 > _e3992) {
                                        phi_6913_ = _e3987;
                                    } else {
                                        phi_6913_ = _e3992;
                                    }
                                    let _e4046 = phi_6913_;
                                    if (_e3997 > _e4002) {
                                        phi_6918_ = _e3997;
                                    } else {
                                        phi_6918_ = _e4002;
                                    }
                                    let _e4049 = phi_6918_;
                                    if (_e4046 > _e4049) {
                                        phi_6923_ = _e4046;
                                    } else {
                                        phi_6923_ = _e4049;
                                    }
                                    let _e4052 = phi_6923_;
                                    if (_e4007 > _e4012) {
                                        phi_6928_ = _e4007;
                                    } else {
                                        phi_6928_ = _e4012;
                                    }
                                    let _e4055 = phi_6928_;
                                    if (_e4017 > _e4022) {
                                        phi_6933_ = _e4017;
                                    } else {
                                        phi_6933_ = _e4022;
                                    }
                                    let _e4058 = phi_6933_;
                                    if (_e4055 > _e4058) {
                                        phi_6938_ = _e4055;
                                    } else {
                                        phi_6938_ = _e4058;
                                    }
                                    let _e4061 = phi_6938_;
                                    if (_e4052 > _e4061) {
                                        phi_6943_ = _e4052;
                                    } else {
                                        phi_6943_ = _e4061;
                                    }
                                    let _e4064 = phi_6943_;
                                    if (_e3976 < 0f) {
                                        phi_6949_ = -(_e3976);
                                    } else {
                                        phi_6949_ = _e3976;
                                    }
                                    let _e4068 = phi_6949_;
                                    if (_e3979 < 0f) {
                                        phi_6955_ = -(_e3979);
                                    } else {
                                        phi_6955_ = _e3979;
                                    }
                                    let _e4072 = phi_6955_;
                                    if (_e3982 < 0f) {
                                        phi_6962_ = -(_e3982);
                                    } else {
                                        phi_6962_ = _e3982;
                                    }
                                    let _e4077 = phi_6962_;
                                    let _e4078 = ((_e4068 + _e4072) + _e4077);
                                    let _e4083 = -(_e4064);
                                    if (_e4043 > _e4083) {
                                        phi_6973_ = _e4043;
                                    } else {
                                        phi_6973_ = _e4083;
                                    }
                                    let _e4086 = phi_6973_;
                                    let _e4091 = (((_e4086 - ((_e4078 * _e3724) * (0.000000059604645f * (17f / 2f)))) - (_e4078 * _e3731)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3970 > _e4091) {
                                        phi_6983_ = _e3970;
                                    } else {
                                        phi_6983_ = _e4091;
                                    }
                                    let _e4094 = phi_6983_;
                                    phi_6987_ = (_e3472 || (_e4094 > 0f));
                                }
                                let _e4098 = phi_6987_;
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
                                        phi_7232_ = -(_e4256[0]);
                                    } else {
                                        phi_7232_ = _e4256[0];
                                    }
                                    let _e4263 = phi_7232_;
                                    if (_e4256[1] < 0f) {
                                        phi_7239_ = -(_e4256[1]);
                                    } else {
                                        phi_7239_ = _e4256[1];
                                    }
                                    let _e4267 = phi_7239_;
                                    if (_e4263 > _e4267) {
                                        phi_7244_ = _e4263;
                                    } else {
                                        phi_7244_ = _e4267;
                                    }
                                    let _e4270 = phi_7244_;
                                    if (_e4256[2] < 0f) {
                                        phi_7251_ = -(_e4256[2]);
                                    } else {
                                        phi_7251_ = _e4256[2];
                                    }
                                    let _e4274 = phi_7251_;
                                    if (_e4270 > _e4274) {
                                        phi_7256_ = _e4270;
                                    } else {
                                        phi_7256_ = _e4274;
                                    }
                                    let _e4277 = phi_7256_;
                                    let _e4280 = local_1.member[1u];
                                    if (_e4280[0] < 0f) {
                                        phi_7269_ = -(_e4280[0]);
                                    } else {
                                        phi_7269_ = _e4280[0];
                                    }
                                    let _e4287 = phi_7269_;
                                    if (_e4280[1] < 0f) {
                                        phi_7276_ = -(_e4280[1]);
                                    } else {
                                        phi_7276_ = _e4280[1];
                                    }
                                    let _e4291 = phi_7276_;
                                    if (_e4287 > _e4291) {
                                        phi_7281_ = _e4287;
                                    } else {
                                        phi_7281_ = _e4291;
                                    }
                                    let _e4294 = phi_7281_;
                                    if (_e4280[2] < 0f) {
                                        phi_7288_ = -(_e4280[2]);
                                    } else {
                                        phi_7288_ = _e4280[2];
                                    }
                                    let _e4298 = phi_7288_;
                                    if (_e4294 > _e4298) {
                                        phi_7293_ = _e4294;
                                    } else {
                                        phi_7293_ = _e4298;
                                    }
                                    let _e4301 = phi_7293_;
                                    if (_e4277 > _e4301) {
                                        phi_7298_ = _e4277;
                                    } else {
                                        phi_7298_ = _e4301;
                                    }
                                    let _e4304 = phi_7298_;
                                    let _e4306 = local_1.member_3;
                                    let _e4307 = (_e4304 + _e4306);
                                    let _e4310 = local_1.member_1[0u];
                                    if (_e4310[0] < 0f) {
                                        phi_7315_ = -(_e4310[0]);
                                    } else {
                                        phi_7315_ = _e4310[0];
                                    }
                                    let _e4317 = phi_7315_;
                                    if (_e4310[1] < 0f) {
                                        phi_7322_ = -(_e4310[1]);
                                    } else {
                                        phi_7322_ = _e4310[1];
                                    }
                                    let _e4321 = phi_7322_;
                                    if (_e4317 > _e4321) {
                                        phi_7327_ = _e4317;
                                    } else {
                                        phi_7327_ = _e4321;
                                    }
                                    let _e4324 = phi_7327_;
                                    if (_e4310[2] < 0f) {
                                        phi_7334_ = -(_e4310[2]);
                                    } else {
                                        phi_7334_ = _e4310[2];
                                    }
                                    let _e4328 = phi_7334_;
                                    if (_e4324 > _e4328) {
                                        phi_7339_ = _e4324;
                                    } else {
                                        phi_7339_ = _e4328;
                                    }
                                    let _e4331 = phi_7339_;
                                    let _e4334 = local_1.member_1[1u];
                                    if (_e4334[0] < 0f) {
                                        phi_7353_ = -(_e4334[0]);
                                    } else {
                                        phi_7353_ = _e4334[0];
                                    }
                                    let _e4341 = phi_7353_;
                                    if (_e4334[1] < 0f) {
                                        phi_7360_ = -(_e4334[1]);
                                    } else {
                                        phi_7360_ = _e4334[1];
                                    }
                                    let _e4345 = phi_7360_;
                                    if (_e4341 > _e4345) {
                                        phi_7365_ = _e4341;
                                    } else {
                                        phi_7365_ = _e4345;
                                    }
                                    let _e4348 = phi_7365_;
                                    if (_e4334[2] < 0f) {
                                        phi_7372_ = -(_e4334[2]);
                                    } else {
                                        phi_7372_ = _e4334[2];
                                    }
                                    let _e4352 = phi_7372_;
                                    if (_e4348 > _e4352) {
                                        phi_7377_ = _e4348;
                                    } else {
                                        phi_7377_ = _e4352;
                                    }
                                    let _e4355 = phi_7377_;
                                    if (_e4331 > _e4355) {
                                        phi_7382_ = _e4331;
                                    } else {
                                        phi_7382_ = _e4355;
                                    }
                                    let _e4358 = phi_7382_;
                                    let _e4360 = local_1.member_3;
                                    let _e4361 = (_e4358 + _e4360);
                                    let _e4364 = local_1.member_2[0u];
                                    if (_e4364[0] < 0f) {
                                        phi_7399_ = -(_e4364[0]);
                                    } else {
                                        phi_7399_ = _e4364[0];
                                    }
                                    let _e4371 = phi_7399_;
                                    if (_e4364[1] < 0f) {
                                        phi_7406_ = -(_e4364[1]);
                                    } else {
                                        phi_7406_ = _e4364[1];
                                    }
                                    let _e4375 = phi_7406_;
                                    if (_e4371 > _e4375) {
                                        phi_7411_ = _e4371;
                                    } else {
                                        phi_7411_ = _e4375;
                                    }
                                    let _e4378 = phi_7411_;
                                    if (_e4364[2] < 0f) {
                                        phi_7418_ = -(_e4364[2]);
                                    } else {
                                        phi_7418_ = _e4364[2];
                                    }
                                    let _e4382 = phi_7418_;
                                    if (_e4378 > _e4382) {
                                        phi_7423_ = _e4378;
                                    } else {
                                        phi_7423_ = _e4382;
                                    }
                                    let _e4385 = phi_7423_;
                                    let _e4388 = local_1.member_2[1u];
                                    if (_e4388[0] < 0f) {
                                        phi_7437_ = -(_e4388[0]);
                                    } else {
                                        phi_7437_ = _e4388[0];
                                    }
                                    let _e4395 = phi_7437_;
                                    if (_e4388[1] < 0f) {
                                        phi_7444_ = -(_e4388[1]);
                                    } else {
                                        phi_7444_ = _e4388[1];
                                    }
                                    let _e4399 = phi_7444_;
                                    if (_e4395 > _e4399) {
                                        phi_7449_ = _e4395;
                                    } else {
                                        phi_7449_ = _e4399;
                                    }
                                    let _e4402 = phi_7449_;
                                    if (_e4388[2] < 0f) {
                                        phi_7456_ = -(_e4388[2]);
                                    } else {
                                        phi_7456_ = _e4388[2];
                                    }
                                    let _e4406 = phi_7456_;
                                    if (_e4402 > _e4406) {
                                        phi_7461_ = _e4402;
                                    } else {
                                        phi_7461_ = _e4406;
                                    }
                                    let _e4409 = phi_7461_;
                                    if (_e4385 > _e4409) {
                                        phi_7466_ = _e4385;
                                    } else {
                                        phi_7466_ = _e4409;
                                    }
                                    let _e4412 = phi_7466_;
                                    let _e4414 = local_1.member_3;
                                    let _e4415 = (_e4412 + _e4414);
                                    let _e4417 = ((_e4361 * 8f) * _e4415);
                                    let _e4424 = local_1.member_3;
                                    if (_e4113 < 0f) {
                                        phi_7497_ = -(_e4113);
                                    } else {
                                        phi_7497_ = _e4113;
                                    }
                                    let _e4441 = phi_7497_;
                                    if (_e4116 < 0f) {
                                        phi_7503_ = -(_e4116);
                                    } else {
                                        phi_7503_ = _e4116;
                                    }
                                    let _e4445 = phi_7503_;
                                    if (_e4119 < 0f) {
                                        phi_7510_ = -(_e4119);
                                    } else {
                                        phi_7510_ = _e4119;
                                    }
                                    let _e4450 = phi_7510_;
                                    let _e4451 = ((_e4441 + _e4445) + _e4450);
                                    if (_e4134 < 0f) {
                                        phi_7517_ = -(_e4134);
                                    } else {
                                        phi_7517_ = _e4134;
                                    }
                                    let _e4455 = phi_7517_;
                                    if (_e4137 < 0f) {
                                        phi_7523_ = -(_e4137);
                                    } else {
                                        phi_7523_ = _e4137;
                                    }
                                    let _e4459 = phi_7523_;
                                    if (_e4140 < 0f) {
                                        phi_7530_ = -(_e4140);
                                    } else {
                                        phi_7530_ = _e4140;
                                    }
                                    let _e4464 = phi_7530_;
                                    let _e4465 = ((_e4455 + _e4459) + _e4464);
                                    if (_e4451 > _e4465) {
                                        phi_7536_ = _e4451;
                                    } else {
                                        phi_7536_ = _e4465;
                                    }
                                    let _e4468 = phi_7536_;
                                    if (_e4183 < 0f) {
                                        phi_7542_ = -(_e4183);
                                    } else {
                                        phi_7542_ = _e4183;
                                    }
                                    let _e4472 = phi_7542_;
                                    if (_e4184 < 0f) {
                                        phi_7548_ = -(_e4184);
                                    } else {
                                        phi_7548_ = _e4184;
                                    }
                                    let _e4476 = phi_7548_;
                                    if (_e4185 < 0f) {
                                        phi_7555_ = -(_e4185);
                                    } else {
                                        phi_7555_ = _e4185;
                                    }
                                    let _e4481 = phi_7555_;
                                    let _e4483 = (((_e4472 + _e4476) + _e4481) * 0.5f);
                                    if (_e4468 > _e4483) {
                                        phi_7562_ = _e4468;
                                    } else {
                                        phi_7562_ = _e4483;
                                    }
                                    let _e4486 = phi_7562_;
                                    let _e4491 = local_1.member_3;
                                    let _e4504 = ((((_e4188[0] * _e4113) + (_e4188[1] * _e4116)) + (_e4188[2] * _e4119)) * 3f);
                                    let _e4505 = ((((_e4245[0] * _e4134) + (_e4245[1] * _e4137)) + (_e4245[2] * _e4140)) * 3f);
                                    if (_e4504 < _e4505) {
                                        phi_7586_ = _e4504;
                                    } else {
                                        phi_7586_ = _e4505;
                                    }
                                    let _e4508 = phi_7586_;
                                    if (_e4219 < _e4242) {
                                        phi_7591_ = _e4219;
                                    } else {
                                        phi_7591_ = _e4242;
                                    }
                                    let _e4511 = phi_7591_;
                                    if (_e4508 < _e4511) {
                                        phi_7596_ = _e4508;
                                    } else {
                                        phi_7596_ = _e4511;
                                    }
                                    let _e4514 = phi_7596_;
                                    if (_e4504 > _e4505) {
                                        phi_7601_ = _e4504;
                                    } else {
                                        phi_7601_ = _e4505;
                                    }
                                    let _e4517 = phi_7601_;
                                    if (_e4219 > _e4242) {
                                        phi_7606_ = _e4219;
                                    } else {
                                        phi_7606_ = _e4242;
                                    }
                                    let _e4520 = phi_7606_;
                                    if (_e4517 > _e4520) {
                                        phi_7611_ = _e4517;
                                    } else {
                                        phi_7611_ = _e4520;
                                    }
                                    let _e4523 = phi_7611_;
                                    let _e4528 = -(_e4523);
                                    if (_e4514 > _e4528) {
                                        phi_7621_ = _e4514;
                                    } else {
                                        phi_7621_ = _e4528;
                                    }
                                    let _e4531 = phi_7621_;
                                    let _e4533 = ((_e4531 - ((((((_e4307 * 8f) * _e4417) * (0.000000059604645f * (524f / 64f))) + ((_e4424 * 19f) * ((_e4307 * (_e4361 + _e4415)) + (_e4361 * _e4415)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4307) * ((1f + _e4361) * (1f + _e4415))))) + ((_e1809 * (((_e4486 + (_e4417 * (0.000000059604645f * 8f))) + ((_e4491 * 6f) * (_e4361 + _e4415))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4361) * (1f + _e4415))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4533 {
                                        phi_8590_ = _e4533;
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
                                            phi_7824_ = -(_e4623[0]);
                                        } else {
                                            phi_7824_ = _e4623[0];
                                        }
                                        let _e4630 = phi_7824_;
                                        if (_e4623[1] < 0f) {
                                            phi_7831_ = -(_e4623[1]);
                                        } else {
                                            phi_7831_ = _e4623[1];
                                        }
                                        let _e4634 = phi_7831_;
                                        if (_e4630 > _e4634) {
                                            phi_7836_ = _e4630;
                                        } else {
                                            phi_7836_ = _e4634;
                                        }
                                        let _e4637 = phi_7836_;
                                        if (_e4623[2] < 0f) {
                                            phi_7843_ = -(_e4623[2]);
                                        } else {
                                            phi_7843_ = _e4623[2];
                                        }
                                        let _e4641 = phi_7843_;
                                        if (_e4637 > _e4641) {
                                            phi_7848_ = _e4637;
                                        } else {
                                            phi_7848_ = _e4641;
                                        }
                                        let _e4644 = phi_7848_;
                                        let _e4647 = local_1.member[1u];
                                        if (_e4647[0] < 0f) {
                                            phi_7861_ = -(_e4647[0]);
                                        } else {
                                            phi_7861_ = _e4647[0];
                                        }
                                        let _e4654 = phi_7861_;
                                        if (_e4647[1] < 0f) {
                                            phi_7868_ = -(_e4647[1]);
                                        } else {
                                            phi_7868_ = _e4647[1];
                                        }
                                        let _e4658 = phi_7868_;
                                        if (_e4654 > _e4658) {
                                            phi_7873_ = _e4654;
                                        } else {
                                            phi_7873_ = _e4658;
                                        }
                                        let _e4661 = phi_7873_;
                                        if (_e4647[2] < 0f) {
                                            phi_7880_ = -(_e4647[2]);
                                        } else {
                                            phi_7880_ = _e4647[2];
                                        }
                                        let _e4665 = phi_7880_;
                                        if (_e4661 > _e4665) {
                                            phi_7885_ = _e4661;
                                        } else {
                                            phi_7885_ = _e4665;
                                        }
                                        let _e4668 = phi_7885_;
                                        if (_e4644 > _e4668) {
                                            phi_7890_ = _e4644;
                                        } else {
                                            phi_7890_ = _e4668;
                                        }
                                        let _e4671 = phi_7890_;
                                        let _e4673 = local_1.member_3;
                                        let _e4677 = local_1.member_1[0u];
                                        if (_e4677[0] < 0f) {
                                            phi_7907_ = -(_e4677[0]);
                                        } else {
                                            phi_7907_ = _e4677[0];
                                        }
                                        let _e4684 = phi_7907_;
                                        if (_e4677[1] < 0f) {
                                            phi_7914_ = -(_e4677[1]);
                                        } else {
                                            phi_7914_ = _e4677[1];
                                        }
                                        let _e4688 = phi_7914_;
                                        if (_e4684 > _e4688) {
                                            phi_7919_ = _e4684;
                                        } else {
                                            phi_7919_ = _e4688;
                                        }
                                        let _e4691 = phi_7919_;
                                        if (_e4677[2] < 0f) {
                                            phi_7926_ = -(_e4677[2]);
                                        } else {
                                            phi_7926_ = _e4677[2];
                                        }
                                        let _e4695 = phi_7926_;
                                        if (_e4691 > _e4695) {
                                            phi_7931_ = _e4691;
                                        } else {
                                            phi_7931_ = _e4695;
                                        }
                                        let _e4698 = phi_7931_;
                                        let _e4701 = local_1.member_1[1u];
                                        if (_e4701[0] < 0f) {
                                            phi_7945_ = -(_e4701[0]);
                                        } else {
                                            phi_7945_ = _e4701[0];
                                        }
                                        let _e4708 = phi_7945_;
                                        if (_e4701[1] < 0f) {
                                            phi_7952_ = -(_e4701[1]);
                                        } else {
                                            phi_7952_ = _e4701[1];
                                        }
                                        let _e4712 = phi_7952_;
                                        if (_e4708 > _e4712) {
                                            phi_7957_ = _e4708;
                                        } else {
                                            phi_7957_ = _e4712;
                                        }
                                        let _e4715 = phi_7957_;
                                        if (_e4701[2] < 0f) {
                                            phi_7964_ = -(_e4701[2]);
                                        } else {
                                            phi_7964_ = _e4701[2];
                                        }
                                        let _e4719 = phi_7964_;
                                        if (_e4715 > _e4719) {
                                            phi_7969_ = _e4715;
                                        } else {
                                            phi_7969_ = _e4719;
                                        }
                                        let _e4722 = phi_7969_;
                                        if (_e4698 > _e4722) {
                                            phi_7974_ = _e4698;
                                        } else {
                                            phi_7974_ = _e4722;
                                        }
                                        let _e4725 = phi_7974_;
                                        let _e4727 = local_1.member_3;
                                        let _e4731 = local_1.member_2[0u];
                                        if (_e4731[0] < 0f) {
                                            phi_7991_ = -(_e4731[0]);
                                        } else {
                                            phi_7991_ = _e4731[0];
                                        }
                                        let _e4738 = phi_7991_;
                                        if (_e4731[1] < 0f) {
                                            phi_7998_ = -(_e4731[1]);
                                        } else {
                                            phi_7998_ = _e4731[1];
                                        }
                                        let _e4742 = phi_7998_;
                                        if (_e4738 > _e4742) {
                                            phi_8003_ = _e4738;
                                        } else {
                                            phi_8003_ = _e4742;
                                        }
                                        let _e4745 = phi_8003_;
                                        if (_e4731[2] < 0f) {
                                            phi_8010_ = -(_e4731[2]);
                                        } else {
                                            phi_8010_ = _e4731[2];
                                        }
                                        let _e4749 = phi_8010_;
                                        if (_e4745 > _e4749) {
                                            phi_8015_ = _e4745;
                                        } else {
                                            phi_8015_ = _e4749;
                                        }
                                        let _e4752 = phi_8015_;
                                        let _e4755 = local_1.member_2[1u];
                                        if (_e4755[0] < 0f) {
                                            phi_8029_ = -(_e4755[0]);
                                        } else {
                                            phi_8029_ = _e4755[0];
                                        }
                                        let _e4762 = phi_8029_;
                                        if (_e4755[1] < 0f) {
                                            phi_8036_ = -(_e4755[1]);
                                        } else {
                                            phi_8036_ = _e4755[1];
                                        }
                                        let _e4766 = phi_8036_;
                                        if (_e4762 > _e4766) {
                                            phi_8041_ = _e4762;
                                        } else {
                                            phi_8041_ = _e4766;
                                        }
                                        let _e4769 = phi_8041_;
                                        if (_e4755[2] < 0f) {
                                            phi_8048_ = -(_e4755[2]);
                                        } else {
                                            phi_8048_ = _e4755[2];
                                        }
                                        let _e4773 = phi_8048_;
                                        if (_e4769 > _e4773) {
                                            phi_8053_ = _e4769;
                                        } else {
                                            phi_8053_ = _e4773;
                                        }
                                        let _e4776 = phi_8053_;
                                        if (_e4752 > _e4776) {
                                            phi_8058_ = _e4752;
                                        } else {
                                            phi_8058_ = _e4776;
                                        }
                                        let _e4779 = phi_8058_;
                                        let _e4781 = local_1.member_3;
                                        let _e4785 = ((((_e4671 + _e4673) + (_e4725 + _e4727)) + (_e4779 + _e4781)) * 2f);
                                        let _e4788 = local_1.member_3;
                                        let _e4792 = (((_e1809 * 1.0001f) + (_e4788 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
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
                                            phi_8137_ = _e4806;
                                        } else {
                                            phi_8137_ = _e4811;
                                        }
                                        let _e4844 = phi_8137_;
                                        if (_e4816 < _e4821) {
                                            phi_8142_ = _e4816;
                                        } else {
                                            phi_8142_ = _e4821;
                                        }
                                        let _e4847 = phi_8142_;
                                        if (_e4844 < _e4847) {
                                            phi_8147_ = _e4844;
                                        } else {
                                            phi_8147_ = _e4847;
                                        }
                                        let _e4850 = phi_8147_;
                                        if (_e4826 < _e4831) {
                                            phi_8152_ = _e4826;
                                        } else {
                                            phi_8152_ = _e4831;
                                        }
                                        let _e4853 = phi_8152_;
                                        if (_e4836 < _e4841) {
                                            phi_8157_ = _e4836;
                                        } else {
                                            phi_8157_ = _e4841;
                                        }
                                        let _e4856 = phi_8157_;
                                        if (_e4853 < _e4856) {
                                            phi_8162_ = _e4853;
                                        } else {
                                            phi_8162_ = _e4856;
                                        }
                                        let _e4859 = phi_8162_;
                                        if (_e4850 < _e4859) {
                                            phi_8167_ = _e4850;
                                        } else {
                                            phi_8167_ = _e4859;
                                        }
                                        let _e4862 = phi_8167_;
                                        if (_e4806 > _e4811) {
                                            phi_8172_ = _e4806;
                                        } else {
                                            phi_8172_ = _e4811;
                                        }
                                        let _e4865 = phi_8172_;
                                        if (_e4816 > _e4821) {
                                            phi_8177_ = _e4816;
                                        } else {
                                            phi_8177_ = _e4821;
                                        }
                                        let _e4868 = phi_8177_;
                                        if (_e4865 > _e4868) {
                                            phi_8182_ = _e4865;
                                        } else {
                                            phi_8182_ = _e4868;
                                        }
                                        let _e4871 = phi_8182_;
                                        if (_e4826 > _e4831) {
                                            phi_8187_ = _e4826;
                                        } else {
                                            phi_8187_ = _e4831;
                                        }
                                        let _e4874 = phi_8187_;
                                        if (_e4836 > _e4841) {
                                            phi_8192_ = _e4836;
                                        } else {
                                            phi_8192_ = _e4841;
                                        }
                                        let _e4877 = phi_8192_;
                                        if (_e4874 > _e4877) {
                                            phi_8197_ = _e4874;
                                        } else {
                                            phi_8197_ = _e4877;
                                        }
                                        let _e4880 = phi_8197_;
                                        if (_e4871 > _e4880) {
                                            phi_8202_ = _e4871;
                                        } else {
                                            phi_8202_ = _e4880;
                                        }
                                        let _e4883 = phi_8202_;
                                        if (_e4795 < 0f) {
                                            phi_8208_ = -(_e4795);
                                        } else {
                                            phi_8208_ = _e4795;
                                        }
                                        let _e4887 = phi_8208_;
                                        if (_e4798 < 0f) {
                                            phi_8214_ = -(_e4798);
                                        } else {
                                            phi_8214_ = _e4798;
                                        }
                                        let _e4891 = phi_8214_;
                                        if (_e4801 < 0f) {
                                            phi_8221_ = -(_e4801);
                                        } else {
                                            phi_8221_ = _e4801;
                                        }
                                        let _e4896 = phi_8221_;
                                        let _e4897 = ((_e4887 + _e4891) + _e4896);
                                        let _e4902 = -(_e4883);
                                        if (_e4862 > _e4902) {
                                            phi_8232_ = _e4862;
                                        } else {
                                            phi_8232_ = _e4902;
                                        }
                                        let _e4905 = phi_8232_;
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
                                            phi_8303_ = _e4924;
                                        } else {
                                            phi_8303_ = _e4929;
                                        }
                                        let _e4962 = phi_8303_;
                                        if (_e4934 < _e4939) {
                                            phi_8308_ = _e4934;
                                        } else {
                                            phi_8308_ = _e4939;
                                        }
                                        let _e4965 = phi_8308_;
                                        if (_e4962 < _e4965) {
                                            phi_8313_ = _e4962;
                                        } else {
                                            phi_8313_ = _e4965;
                                        }
                                        let _e4968 = phi_8313_;
                                        if (_e4944 < _e4949) {
                                            phi_8318_ = _e4944;
                                        } else {
                                            phi_8318_ = _e4949;
                                        }
                                        let _e4971 = phi_8318_;
                                        if (_e4954 < _e4959) {
                                            phi_8323_ = _e4954;
                                        } else {
                                            phi_8323_ = _e4959;
                                        }
                                        let _e4974 = phi_8323_;
                                        if (_e4971 < _e4974) {
                                            phi_8328_ = _e4971;
                                        } else {
                                            phi_8328_ = _e4974;
                                        }
                                        let _e4977 = phi_8328_;
                                        if (_e4968 < _e4977) {
                                            phi_8333_ = _e4968;
                                        } else {
                                            phi_8333_ = _e4977;
                                        }
                                        let _e4980 = phi_8333_;
                                        if (_e4924 > _e4929) {
                                            phi_8338_ = _e4924;
                                        } else {
                                            phi_8338_ = _e4929;
                                        }
                                        let _e4983 = phi_8338_;
                                        if (_e4934 > _e4939) {
                                            phi_8343_ = _e4934;
                                        } else {
                                            phi_8343_ = _e4939;
                                        }
                                        let _e4986 = phi_8343_;
                                        if (_e4983 > _e4986) {
                                            phi_8348_ = _e4983;
                                        } else {
                                            phi_8348_ = _e4986;
                                        }
                                        let _e4989 = phi_8348_;
                                        if (_e4944 > _e4949) {
                                            phi_8353_ = _e4944;
                                        } else {
                                            phi_8353_ = _e4949;
                                        }
                                        let _e4992 = phi_8353_;
                                        if (_e4954 > _e4959) {
                                            phi_8358_ = _e4954;
                                        } else {
                                            phi_8358_ = _e4959;
                                        }
                                        let _e4995 = phi_8358_;
                                        if (_e4992 > _e4995) {
                                            phi_8363_ = _e4992;
                                        } else {
                                            phi_8363_ = _e4995;
                                        }
                                        let _e4998 = phi_8363_;
                                        if (_e4989 > _e4998) {
                                            phi_8368_ = _e4989;
                                        } else {
                                            phi_8368_ = _e4998;
                                        }
                                        let _e5001 = phi_8368_;
                                        if (_e4913 < 0f) {
                                            phi_8374_ = -(_e4913);
                                        } else {
                                            phi_8374_ = _e4913;
                                        }
                                        let _e5005 = phi_8374_;
                                        if (_e4916 < 0f) {
                                            phi_8380_ = -(_e4916);
                                        } else {
                                            phi_8380_ = _e4916;
                                        }
                                        let _e5009 = phi_8380_;
                                        if (_e4919 < 0f) {
                                            phi_8387_ = -(_e4919);
                                        } else {
                                            phi_8387_ = _e4919;
                                        }
                                        let _e5014 = phi_8387_;
                                        let _e5015 = ((_e5005 + _e5009) + _e5014);
                                        let _e5020 = -(_e5001);
                                        if (_e4980 > _e5020) {
                                            phi_8398_ = _e4980;
                                        } else {
                                            phi_8398_ = _e5020;
                                        }
                                        let _e5023 = phi_8398_;
                                        let _e5028 = (((_e5023 - ((_e5015 * _e4785) * (0.000000059604645f * (17f / 2f)))) - (_e5015 * _e4792)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4910 > _e5028) {
                                            phi_8408_ = _e4910;
                                        } else {
                                            phi_8408_ = _e5028;
                                        }
                                        let _e5031 = phi_8408_;
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
                                            phi_8481_ = _e5048;
                                        } else {
                                            phi_8481_ = _e5053;
                                        }
                                        let _e5086 = phi_8481_;
                                        if (_e5058 < _e5063) {
                                            phi_8486_ = _e5058;
                                        } else {
                                            phi_8486_ = _e5063;
                                        }
                                        let _e5089 = phi_8486_;
                                        if (_e5086 < _e5089) {
                                            phi_8491_ = _e5086;
                                        } else {
                                            phi_8491_ = _e5089;
                                        }
                                        let _e5092 = phi_8491_;
                                        if (_e5068 < _e5073) {
                                            phi_8496_ = _e5068;
                                        } else {
                                            phi_8496_ = _e5073;
                                        }
                                        let _e5095 = phi_8496_;
                                        if (_e5078 < _e5083) {
                                            phi_8501_ = _e5078;
                                        } else {
                                            phi_8501_ = _e5083;
                                        }
                                        let _e5098 = phi_8501_;
                                        if (_e5095 < _e5098) {
                                            phi_8506_ = _e5095;
                                        } else {
                                            phi_8506_ = _e5098;
                                        }
                                        let _e5101 = phi_8506_;
                                        if (_e5092 < _e5101) {
                                            phi_8511_ = _e5092;
                                        } else {
                                            phi_8511_ = _e5101;
                                        }
                                        let _e5104 = phi_8511_;
                                        if (_e5048 > _e5053) {
                                            phi_8516_ = _e5048;
                                        } else {
                                            phi_8516_ = _e5053;
                                        }
                                        let _e5107 = phi_8516_;
                                        if (_e5058 > _e5063) {
                                            phi_8521_ = _e5058;
                                        } else {
                                            phi_8521_ = _e5063;
                                        }
                                        let _e5110 = phi_8521_;
                                        if (_e5107 > _e5110) {
                                            phi_8526_ = _e5107;
                                        } else {
                                            phi_8526_ = _e5110;
                                        }
                                        let _e5113 = phi_8526_;
                                        if (_e5068 > _e5073) {
                                            phi_8531_ = _e5068;
                                        } else {
                                            phi_8531_ = _e5073;
                                        }
                                        let _e5116 = phi_8531_;
                                        if (_e5078 > _e5083) {
                                            phi_8536_ = _e5078;
                                        } else {
                                            phi_8536_ = _e5083;
                                        }
                                        let _e5119 = phi_8536_;
                                        if (_e5116 > _e5119) {
                                            phi_8541_ = _e5116;
                                        } else {
                                            phi_8541_ = _e5119;
                                        }
                                        let _e5122 = phi_8541_;
                                        if (_e5113 > _e5122) {
                                            phi_8546_ = _e5113;
                                        } else {
                                            phi_8546_ = _e5122;
                                        }
                                        let _e5125 = phi_8546_;
                                        if (_e5037 < 0f) {
                                            phi_8552_ = -(_e5037);
                                        } else {
                                            phi_8552_ = _e5037;
                                        }
                                        let _e5129 = phi_8552_;
                                        if (_e5040 < 0f) {
                                            phi_8558_ = -(_e5040);
                                        } else {
                                            phi_8558_ = _e5040;
                                        }
                                        let _e5133 = phi_8558_;
                                        if (_e5043 < 0f) {
                                            phi_8565_ = -(_e5043);
                                        } else {
                                            phi_8565_ = _e5043;
                                        }
                                        let _e5138 = phi_8565_;
                                        let _e5139 = ((_e5129 + _e5133) + _e5138);
                                        let _e5144 = -(_e5125);
                                        if (_e5104 > _e5144) {
                                            phi_8576_ = _e5104;
                                        } else {
                                            phi_8576_ = _e5144;
                                        }
                                        let _e5147 = phi_8576_;
                                        let _e5152 = (((_e5147 - ((_e5139 * _e4785) * (0.000000059604645f * (17f / 2f)))) - (_e5139 * _e4792)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5031 > _e5152) {
                                            phi_8586_ = _e5031;
                                        } else {
                                            phi_8586_ = _e5152;
                                        }
                                        let _e5155 = phi_8586_;
                                        phi_8590_ = (_e4533 || (_e5155 > 0f));
                                    }
                                    let _e5159 = phi_8590_;
                                    phi_8592_ = (_e4098 && _e5159);
                                } else {
                                    phi_8592_ = _e4098;
                                }
                                let _e5162 = phi_8592_;
                                phi_8594_ = (_e2947 || _e5162);
                            }
                            let _e5165 = phi_8594_;
                            if !(_e5165) {
                                let _e5168 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1172] = ((2147483648u | (_e5168 << bitcast<u32>(12i))) | _e1175);
                            }
                        }
                        phi_8605_ = true;
                    }
                    let _e5175 = phi_8605_;
                    phi_8606_ = _e5175;
                } else {
                    phi_8606_ = false;
                }
                let _e5177 = phi_8606_;
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
            phi_8656_ = type_13(0u, 16u);
            loop {
                let _e5203 = phi_8656_;
                if (_e5203.member < _e5203.member_1) {
                    phi_8657_ = type_13((_e5203.member + 1u), _e5203.member_1);
                    phi_8680_ = type_13(1u, _e5203.member);
                } else {
                    phi_8657_ = _e5203;
                    phi_8680_ = type_13(0u, type_13().member_1);
                }
                let _e5215 = phi_8657_;
                let _e5217 = phi_8680_;
                if (bitcast<i32>(_e5217.member) != 0i) {
                    let _e5223 = (_e71 + (_e5217.member_1 * 128u));
                    if (_e5223 >= _e1150) {
                        phi_8777_ = false;
                    } else {
                        let _e5226 = hits[_e5223];
                        if ((_e5226 & 2147483648u) == 0u) {
                            phi_8703_ = 4294967295u;
                        } else {
                            phi_8703_ = ((_e5226 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e5233 = phi_8703_;
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
                        phi_8777_ = true;
                    }
                    let _e5268 = phi_8777_;
                    phi_8778_ = _e5268;
                } else {
                    phi_8778_ = false;
                }
                let _e5270 = phi_8778_;
                continue;
                continuing {
                    phi_8656_ = _e5215;
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
