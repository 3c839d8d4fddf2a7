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
    var phi_181_: bool;
    var phi_182_: bool;
    var phi_186_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_182_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_181_ = (param[0] > param_1[0]);
        } else {
            phi_181_ = false;
        }
        let _e14 = phi_181_;
        phi_182_ = _e14;
    }
    let _e16 = phi_182_;
    if _e16 {
        phi_186_ = param_1;
    } else {
        phi_186_ = param;
    }
    let _e18 = phi_186_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_205_: bool;
    var phi_206_: bool;
    var phi_210_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_206_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_205_ = (param_3[0] > param_2[0]);
        } else {
            phi_205_ = false;
        }
        let _e14 = phi_205_;
        phi_206_ = _e14;
    }
    let _e16 = phi_206_;
    if _e16 {
        phi_210_ = param_3;
    } else {
        phi_210_ = param_2;
    }
    let _e18 = phi_210_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_229_: bool;
    var phi_230_: bool;
    var phi_234_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_230_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_229_ = (param_4[0] > param_5[0]);
        } else {
            phi_229_ = false;
        }
        let _e14 = phi_229_;
        phi_230_ = _e14;
    }
    let _e16 = phi_230_;
    if _e16 {
        phi_234_ = param_5;
    } else {
        phi_234_ = param_4;
    }
    let _e18 = phi_234_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_253_: bool;
    var phi_254_: bool;
    var phi_258_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_254_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_253_ = (param_7[0] > param_6[0]);
        } else {
            phi_253_ = false;
        }
        let _e14 = phi_253_;
        phi_254_ = _e14;
    }
    let _e16 = phi_254_;
    if _e16 {
        phi_258_ = param_7;
    } else {
        phi_258_ = param_6;
    }
    let _e18 = phi_258_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_277_: bool;
    var phi_278_: bool;
    var phi_282_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_278_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_277_ = (param_8[0] > param_9[0]);
        } else {
            phi_277_ = false;
        }
        let _e14 = phi_277_;
        phi_278_ = _e14;
    }
    let _e16 = phi_278_;
    if _e16 {
        phi_282_ = param_9;
    } else {
        phi_282_ = param_8;
    }
    let _e18 = phi_282_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_306_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_302_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_301_ = (param_11[0] > param_10[0]);
        } else {
            phi_301_ = false;
        }
        let _e14 = phi_301_;
        phi_302_ = _e14;
    }
    let _e16 = phi_302_;
    if _e16 {
        phi_306_ = param_11;
    } else {
        phi_306_ = param_10;
    }
    let _e18 = phi_306_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_41;
    var local_1: type_41;
    var local_2: type_41;
    var phi_353_: u32;
    var phi_394_: u32;
    var phi_395_: u32;
    var phi_403_: u32;
    var phi_419_: u32;
    var phi_440_: u32;
    var phi_441_: u32;
    var phi_444_: type_9;
    var phi_445_: type_9;
    var phi_468_: type_9;
    var phi_509_: u32;
    var phi_510_: u32;
    var phi_518_: u32;
    var phi_530_: u32;
    var phi_615_: array<u32, 2>;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_824_: type_33;
    var phi_837_: type_9;
    var phi_840_: u32;
    var phi_838_: type_9;
    var phi_863_: type_9;
    var phi_936_: bool;
    var phi_958_: bool;
    var phi_959_: bool;
    var phi_960_: bool;
    var phi_978_: u32;
    var phi_979_: u32;
    var phi_841_: u32;
    var phi_982_: type_9;
    var phi_985_: u32;
    var phi_983_: type_9;
    var phi_1008_: type_9;
    var phi_1102_: bool;
    var phi_1109_: bool;
    var phi_1117_: bool;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_1193_: bool;
    var phi_1309_: bool;
    var phi_1310_: bool;
    var phi_1353_: type_15;
    var phi_1356_: u32;
    var phi_1358_: u32;
    var phi_1379_: bool;
    var phi_1385_: type_16;
    var phi_1354_: type_15;
    var phi_1399_: type_16;
    var phi_1467_: bool;
    var phi_1468_: bool;
    var phi_1469_: bool;
    var phi_1470_: bool;
    var phi_1474_: bool;
    var phi_1480_: u32;
    var phi_1481_: u32;
    var phi_1482_: u32;
    var phi_1483_: u32;
    var phi_1484_: bool;
    var phi_1357_: u32;
    var phi_1359_: u32;
    var phi_1485_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1533_: bool;
    var phi_1534_: bool;
    var phi_1535_: bool;
    var phi_1536_: bool;
    var phi_1540_: bool;
    var phi_1541_: bool;
    var phi_1545_: bool;
    var phi_1549_: bool;
    var phi_1550_: bool;
    var phi_1554_: bool;
    var phi_1555_: bool;
    var phi_1559_: bool;
    var phi_1560_: bool;
    var phi_1684_: bool;
    var phi_1685_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1873_: bool;
    var phi_1874_: bool;
    var phi_1967_: bool;
    var phi_1968_: bool;
    var phi_2063_: bool;
    var phi_2064_: bool;
    var phi_2157_: bool;
    var phi_2158_: bool;
    var phi_2162_: bool;
    var phi_2163_: bool;
    var phi_2164_: bool;
    var phi_2168_: bool;
    var phi_2169_: bool;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2172_: bool;
    var phi_2176_: bool;
    var phi_2238_: u32;
    var phi_2239_: bool;
    var phi_986_: u32;
    var phi_2240_: bool;
    var phi_2247_: u32;
    var phi_2250_: type_9;
    var phi_2251_: type_9;
    var phi_2274_: type_9;
    var phi_2376_: bool;
    var phi_2383_: bool;
    var phi_2391_: bool;
    var phi_2414_: bool;
    var phi_2415_: bool;
    var phi_2459_: bool;
    var phi_2460_: bool;
    var phi_2467_: bool;
    var phi_2583_: bool;
    var phi_2584_: bool;
    var phi_2627_: type_15;
    var phi_2630_: u32;
    var phi_2632_: u32;
    var phi_2653_: bool;
    var phi_2659_: type_16;
    var phi_2628_: type_15;
    var phi_2673_: type_16;
    var phi_2741_: bool;
    var phi_2742_: bool;
    var phi_2743_: bool;
    var phi_2744_: bool;
    var phi_2748_: bool;
    var phi_2754_: u32;
    var phi_2755_: u32;
    var phi_2756_: u32;
    var phi_2757_: u32;
    var phi_2758_: bool;
    var phi_2631_: u32;
    var phi_2633_: u32;
    var phi_2759_: bool;
    var local_5: u32;
    var local_6: u32;
    var phi_2807_: bool;
    var phi_2808_: bool;
    var phi_2809_: bool;
    var phi_2810_: bool;
    var phi_2814_: bool;
    var phi_2815_: bool;
    var phi_2819_: bool;
    var phi_2823_: bool;
    var phi_2824_: bool;
    var phi_2828_: bool;
    var phi_2829_: bool;
    var phi_2833_: bool;
    var phi_2834_: bool;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_3052_: bool;
    var phi_3053_: bool;
    var phi_3147_: bool;
    var phi_3148_: bool;
    var phi_3241_: bool;
    var phi_3242_: bool;
    var phi_3337_: bool;
    var phi_3338_: bool;
    var phi_3431_: bool;
    var phi_3432_: bool;
    var phi_3436_: bool;
    var phi_3437_: bool;
    var phi_3438_: bool;
    var phi_3442_: bool;
    var phi_3443_: bool;
    var phi_3444_: bool;
    var phi_3445_: bool;
    var phi_3446_: bool;
    var phi_3450_: bool;
    var phi_3879_: f32;
    var phi_3886_: f32;
    var phi_3891_: f32;
    var phi_3898_: f32;
    var phi_3903_: f32;
    var phi_3916_: f32;
    var phi_3923_: f32;
    var phi_3928_: f32;
    var phi_3935_: f32;
    var phi_3940_: f32;
    var phi_3945_: f32;
    var phi_3962_: f32;
    var phi_3969_: f32;
    var phi_3974_: f32;
    var phi_3981_: f32;
    var phi_3986_: f32;
    var phi_4000_: f32;
    var phi_4007_: f32;
    var phi_4012_: f32;
    var phi_4019_: f32;
    var phi_4024_: f32;
    var phi_4029_: f32;
    var phi_4046_: f32;
    var phi_4053_: f32;
    var phi_4058_: f32;
    var phi_4065_: f32;
    var phi_4070_: f32;
    var phi_4084_: f32;
    var phi_4091_: f32;
    var phi_4096_: f32;
    var phi_4103_: f32;
    var phi_4108_: f32;
    var phi_4113_: f32;
    var phi_4144_: f32;
    var phi_4150_: f32;
    var phi_4157_: f32;
    var phi_4164_: f32;
    var phi_4170_: f32;
    var phi_4177_: f32;
    var phi_4183_: f32;
    var phi_4189_: f32;
    var phi_4195_: f32;
    var phi_4202_: f32;
    var phi_4209_: f32;
    var phi_4233_: f32;
    var phi_4238_: f32;
    var phi_4243_: f32;
    var phi_4248_: f32;
    var phi_4253_: f32;
    var phi_4258_: f32;
    var phi_4268_: f32;
    var phi_4471_: f32;
    var phi_4478_: f32;
    var phi_4483_: f32;
    var phi_4490_: f32;
    var phi_4495_: f32;
    var phi_4508_: f32;
    var phi_4515_: f32;
    var phi_4520_: f32;
    var phi_4527_: f32;
    var phi_4532_: f32;
    var phi_4537_: f32;
    var phi_4554_: f32;
    var phi_4561_: f32;
    var phi_4566_: f32;
    var phi_4573_: f32;
    var phi_4578_: f32;
    var phi_4592_: f32;
    var phi_4599_: f32;
    var phi_4604_: f32;
    var phi_4611_: f32;
    var phi_4616_: f32;
    var phi_4621_: f32;
    var phi_4638_: f32;
    var phi_4645_: f32;
    var phi_4650_: f32;
    var phi_4657_: f32;
    var phi_4662_: f32;
    var phi_4676_: f32;
    var phi_4683_: f32;
    var phi_4688_: f32;
    var phi_4695_: f32;
    var phi_4700_: f32;
    var phi_4705_: f32;
    var phi_4784_: f32;
    var phi_4789_: f32;
    var phi_4794_: f32;
    var phi_4799_: f32;
    var phi_4804_: f32;
    var phi_4809_: f32;
    var phi_4814_: f32;
    var phi_4819_: f32;
    var phi_4824_: f32;
    var phi_4829_: f32;
    var phi_4834_: f32;
    var phi_4839_: f32;
    var phi_4844_: f32;
    var phi_4849_: f32;
    var phi_4855_: f32;
    var phi_4861_: f32;
    var phi_4868_: f32;
    var phi_4879_: f32;
    var phi_4950_: f32;
    var phi_4955_: f32;
    var phi_4960_: f32;
    var phi_4965_: f32;
    var phi_4970_: f32;
    var phi_4975_: f32;
    var phi_4980_: f32;
    var phi_4985_: f32;
    var phi_4990_: f32;
    var phi_4995_: f32;
    var phi_5000_: f32;
    var phi_5005_: f32;
    var phi_5010_: f32;
    var phi_5015_: f32;
    var phi_5021_: f32;
    var phi_5027_: f32;
    var phi_5034_: f32;
    var phi_5045_: f32;
    var phi_5055_: f32;
    var phi_5128_: f32;
    var phi_5133_: f32;
    var phi_5138_: f32;
    var phi_5143_: f32;
    var phi_5148_: f32;
    var phi_5153_: f32;
    var phi_5158_: f32;
    var phi_5163_: f32;
    var phi_5168_: f32;
    var phi_5173_: f32;
    var phi_5178_: f32;
    var phi_5183_: f32;
    var phi_5188_: f32;
    var phi_5193_: f32;
    var phi_5199_: f32;
    var phi_5205_: f32;
    var phi_5212_: f32;
    var phi_5223_: f32;
    var phi_5233_: f32;
    var phi_5237_: bool;
    var phi_5689_: f32;
    var phi_5696_: f32;
    var phi_5701_: f32;
    var phi_5708_: f32;
    var phi_5713_: f32;
    var phi_5726_: f32;
    var phi_5733_: f32;
    var phi_5738_: f32;
    var phi_5745_: f32;
    var phi_5750_: f32;
    var phi_5755_: f32;
    var phi_5772_: f32;
    var phi_5779_: f32;
    var phi_5784_: f32;
    var phi_5791_: f32;
    var phi_5796_: f32;
    var phi_5810_: f32;
    var phi_5817_: f32;
    var phi_5822_: f32;
    var phi_5829_: f32;
    var phi_5834_: f32;
    var phi_5839_: f32;
    var phi_5856_: f32;
    var phi_5863_: f32;
    var phi_5868_: f32;
    var phi_5875_: f32;
    var phi_5880_: f32;
    var phi_5894_: f32;
    var phi_5901_: f32;
    var phi_5906_: f32;
    var phi_5913_: f32;
    var phi_5918_: f32;
    var phi_5923_: f32;
    var phi_5954_: f32;
    var phi_5960_: f32;
    var phi_5967_: f32;
    var phi_5974_: f32;
    var phi_5980_: f32;
    var phi_5987_: f32;
    var phi_5993_: f32;
    var phi_5999_: f32;
    var phi_6005_: f32;
    var phi_6012_: f32;
    var phi_6019_: f32;
    var phi_6043_: f32;
    var phi_6048_: f32;
    var phi_6053_: f32;
    var phi_6058_: f32;
    var phi_6063_: f32;
    var phi_6068_: f32;
    var phi_6078_: f32;
    var phi_6281_: f32;
    var phi_6288_: f32;
    var phi_6293_: f32;
    var phi_6300_: f32;
    var phi_6305_: f32;
    var phi_6318_: f32;
    var phi_6325_: f32;
    var phi_6330_: f32;
    var phi_6337_: f32;
    var phi_6342_: f32;
    var phi_6347_: f32;
    var phi_6364_: f32;
    var phi_6371_: f32;
    var phi_6376_: f32;
    var phi_6383_: f32;
    var phi_6388_: f32;
    var phi_6402_: f32;
    var phi_6409_: f32;
    var phi_6414_: f32;
    var phi_6421_: f32;
    var phi_6426_: f32;
    var phi_6431_: f32;
    var phi_6448_: f32;
    var phi_6455_: f32;
    var phi_6460_: f32;
    var phi_6467_: f32;
    var phi_6472_: f32;
    var phi_6486_: f32;
    var phi_6493_: f32;
    var phi_6498_: f32;
    var phi_6505_: f32;
    var phi_6510_: f32;
    var phi_6515_: f32;
    var phi_6594_: f32;
    var phi_6599_: f32;
    var phi_6604_: f32;
    var phi_6609_: f32;
    var phi_6614_: f32;
    var phi_6619_: f32;
    var phi_6624_: f32;
    var phi_6629_: f32;
    var phi_6634_: f32;
    var phi_6639_: f32;
    var phi_6644_: f32;
    var phi_6649_: f32;
    var phi_6654_: f32;
    var phi_6659_: f32;
    var phi_6665_: f32;
    var phi_6671_: f32;
    var phi_6678_: f32;
    var phi_6689_: f32;
    var phi_6760_: f32;
    var phi_6765_: f32;
    var phi_6770_: f32;
    var phi_6775_: f32;
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
    var phi_6831_: f32;
    var phi_6837_: f32;
    var phi_6844_: f32;
    var phi_6855_: f32;
    var phi_6865_: f32;
    var phi_6938_: f32;
    var phi_6943_: f32;
    var phi_6948_: f32;
    var phi_6953_: f32;
    var phi_6958_: f32;
    var phi_6963_: f32;
    var phi_6968_: f32;
    var phi_6973_: f32;
    var phi_6978_: f32;
    var phi_6983_: f32;
    var phi_6988_: f32;
    var phi_6993_: f32;
    var phi_6998_: f32;
    var phi_7003_: f32;
    var phi_7009_: f32;
    var phi_7015_: f32;
    var phi_7022_: f32;
    var phi_7033_: f32;
    var phi_7043_: f32;
    var phi_7047_: bool;
    var phi_7292_: f32;
    var phi_7299_: f32;
    var phi_7304_: f32;
    var phi_7311_: f32;
    var phi_7316_: f32;
    var phi_7329_: f32;
    var phi_7336_: f32;
    var phi_7341_: f32;
    var phi_7348_: f32;
    var phi_7353_: f32;
    var phi_7358_: f32;
    var phi_7375_: f32;
    var phi_7382_: f32;
    var phi_7387_: f32;
    var phi_7394_: f32;
    var phi_7399_: f32;
    var phi_7413_: f32;
    var phi_7420_: f32;
    var phi_7425_: f32;
    var phi_7432_: f32;
    var phi_7437_: f32;
    var phi_7442_: f32;
    var phi_7459_: f32;
    var phi_7466_: f32;
    var phi_7471_: f32;
    var phi_7478_: f32;
    var phi_7483_: f32;
    var phi_7497_: f32;
    var phi_7504_: f32;
    var phi_7509_: f32;
    var phi_7516_: f32;
    var phi_7521_: f32;
    var phi_7526_: f32;
    var phi_7557_: f32;
    var phi_7563_: f32;
    var phi_7570_: f32;
    var phi_7577_: f32;
    var phi_7583_: f32;
    var phi_7590_: f32;
    var phi_7596_: f32;
    var phi_7602_: f32;
    var phi_7608_: f32;
    var phi_7615_: f32;
    var phi_7622_: f32;
    var phi_7646_: f32;
    var phi_7651_: f32;
    var phi_7656_: f32;
    var phi_7661_: f32;
    var phi_7666_: f32;
    var phi_7671_: f32;
    var phi_7681_: f32;
    var phi_7884_: f32;
    var phi_7891_: f32;
    var phi_7896_: f32;
    var phi_7903_: f32;
    var phi_7908_: f32;
    var phi_7921_: f32;
    var phi_7928_: f32;
    var phi_7933_: f32;
    var phi_7940_: f32;
    var phi_7945_: f32;
    var phi_7950_: f32;
    var phi_7967_: f32;
    var phi_7974_: f32;
    var phi_7979_: f32;
    var phi_7986_: f32;
    var phi_7991_: f32;
    var phi_8005_: f32;
    var phi_8012_: f32;
    var phi_8017_: f32;
    var phi_8024_: f32;
    var phi_8029_: f32;
    var phi_8034_: f32;
    var phi_8051_: f32;
    var phi_8058_: f32;
    var phi_8063_: f32;
    var phi_8070_: f32;
    var phi_8075_: f32;
    var phi_8089_: f32;
    var phi_8096_: f32;
    var phi_8101_: f32;
    var phi_8108_: f32;
    var phi_8113_: f32;
    var phi_8118_: f32;
    var phi_8197_: f32;
    var phi_8202_: f32;
    var phi_8207_: f32;
    var phi_8212_: f32;
    var phi_8217_: f32;
    var phi_8222_: f32;
    var phi_8227_: f32;
    var phi_8232_: f32;
    var phi_8237_: f32;
    var phi_8242_: f32;
    var phi_8247_: f32;
    var phi_8252_: f32;
    var phi_8257_: f32;
    var phi_8262_: f32;
    var phi_8268_: f32;
    var phi_8274_: f32;
    var phi_8281_: f32;
    var phi_8292_: f32;
    var phi_8363_: f32;
    var phi_8368_: f32;
    var phi_8373_: f32;
    var phi_8378_: f32;
    var phi_8383_: f32;
    var phi_8388_: f32;
    var phi_8393_: f32;
    var phi_8398_: f32;
    var phi_8403_: f32;
    var phi_8408_: f32;
    var phi_8413_: f32;
    var phi_8418_: f32;
    var phi_8423_: f32;
    var phi_8428_: f32;
    var phi_8434_: f32;
    var phi_8440_: f32;
    var phi_8447_: f32;
    var phi_8458_: f32;
    var phi_8468_: f32;
    var phi_8541_: f32;
    var phi_8546_: f32;
    var phi_8551_: f32;
    var phi_8556_: f32;
    var phi_8561_: f32;
    var phi_8566_: f32;
    var phi_8571_: f32;
    var phi_8576_: f32;
    var phi_8581_: f32;
    var phi_8586_: f32;
    var phi_8591_: f32;
    var phi_8596_: f32;
    var phi_8601_: f32;
    var phi_8606_: f32;
    var phi_8612_: f32;
    var phi_8618_: f32;
    var phi_8625_: f32;
    var phi_8636_: f32;
    var phi_8646_: f32;
    var phi_8650_: bool;
    var phi_8652_: bool;
    var phi_8654_: bool;
    var phi_8665_: bool;
    var phi_8666_: bool;
    var phi_8716_: type_9;
    var phi_8717_: type_9;
    var phi_8740_: type_9;
    var phi_8763_: u32;
    var phi_8837_: bool;
    var phi_8838_: bool;
    var local_7: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e71 = id_2;
    let _e72 = n_2;
    let _e73 = lane_2;
    let _e86 = ((_e71.y * _e72.x) + _e71.x);
    let _e89 = (_e72.x * _e72.y);
    let _e92 = params.member.member_1.member_2;
    let _e94 = input.member[0u];
    if (_e92 < _e94) {
        phi_353_ = _e92;
    } else {
        phi_353_ = _e94;
    }
    let _e97 = phi_353_;
    let _e98 = (_e73 / 32u);
    let _e99 = (_e73 % 32u);
    let _e102 = params.member.member_1.member_1;
    if (_e97 > _e102) {
        let _e106 = params.member.member_1.member_1;
        let _e107 = (_e97 - _e106);
        let _e110 = params.member.member_2.member_3;
        if (_e110 == 0u) {
            return;
        }
        let _e112 = (_e107 / _e110);
        if (_e110 == 0u) {
            return;
        }
        if ((_e107 % _e110) > 0u) {
            phi_394_ = (_e112 + 1u);
        } else {
            phi_394_ = _e112;
        }
        let _e118 = phi_394_;
        phi_395_ = _e118;
    } else {
        phi_395_ = 0u;
    }
    let _e120 = phi_395_;
    let _e123 = params.member.member_2.member_4;
    if (_e123 < _e120) {
        phi_403_ = _e123;
    } else {
        phi_403_ = _e120;
    }
    let _e126 = phi_403_;
    let _e127 = (_e126 / 4u);
    if ((_e126 % 4u) > 0u) {
        phi_419_ = (_e127 + 1u);
    } else {
        phi_419_ = _e127;
    }
    let _e132 = phi_419_;
    if (_e132 > _e86) {
        let _e134 = (_e132 - _e86);
        if (_e89 == 0u) {
            return;
        }
        let _e136 = (_e134 / _e89);
        if (_e89 == 0u) {
            return;
        }
        if ((_e134 % _e89) > 0u) {
            phi_440_ = (_e136 + 1u);
        } else {
            phi_440_ = _e136;
        }
        let _e142 = phi_440_;
        phi_441_ = _e142;
    } else {
        phi_441_ = 0u;
    }
    let _e144 = phi_441_;
    phi_444_ = type_9(0u, _e144);
    loop {
        let _e147 = phi_444_;
        if (_e147.member < _e147.member_1) {
            phi_445_ = type_9((_e147.member + 1u), _e147.member_1);
            phi_468_ = type_9(1u, _e147.member);
        } else {
            phi_445_ = _e147;
            phi_468_ = type_9(0u, type_9().member_1);
        }
        let _e159 = phi_445_;
        let _e161 = phi_468_;
        let _e165 = (bitcast<i32>(_e161.member) != 0i);
        if _e165 {
            let _e169 = (((_e86 + (_e161.member_1 * _e89)) * 4u) + _e98);
            let _e172 = params.member.member_1.member_1;
            if (_e97 > _e172) {
                let _e176 = params.member.member_1.member_1;
                let _e177 = (_e97 - _e176);
                let _e180 = params.member.member_2.member_3;
                if (_e180 == 0u) {
                    return;
                }
                let _e182 = (_e177 / _e180);
                if (_e180 == 0u) {
                    return;
                }
                if ((_e177 % _e180) > 0u) {
                    phi_509_ = (_e182 + 1u);
                } else {
                    phi_509_ = _e182;
                }
                let _e188 = phi_509_;
                phi_510_ = _e188;
            } else {
                phi_510_ = 0u;
            }
            let _e190 = phi_510_;
            let _e193 = params.member.member_2.member_4;
            if (_e193 < _e190) {
                phi_518_ = _e193;
            } else {
                phi_518_ = _e190;
            }
            let _e196 = phi_518_;
            let _e197 = (_e169 < _e196);
            let _e200 = params.member.member_1.member_1;
            if _e197 {
                let _e203 = params.member.member_2.member_3;
                phi_530_ = (_e169 * _e203);
            } else {
                phi_530_ = 0u;
            }
            let _e206 = phi_530_;
            let _e208 = (2u * (_e200 + _e206));
            let _e211 = input.member[(4u + _e208)];
            let _e214 = input.member[(_e208 + 5u)];
            if (_e73 < 8u) {
                atomicStore((&counters[_e73]), 0u);
            }
            workgroupBarrier();
            let _e222 = params.member.member_2.member[0u][0u];
            let _e223 = (_e222 + (_e211 * 32u));
            let _e229 = params.member.member_2.member[0u][2u];
            let _e230 = (_e229 + (_e214 * 32u));
            if (_e99 == 0u) {
                firsts[(2u * _e98)] = _e223;
                firsts[((2u * _e98) + 1u)] = _e230;
            }
            let _e239 = params.member.member_2.member_1;
            if (_e239 == 0u) {
                phi_615_ = array<u32, 2>(0u, 2u);
            } else {
                phi_615_ = array<u32, 2>(1u, 1u);
            }
            let _e242 = phi_615_;
            let _e245 = (_e73 / 32u);
            let _e246 = (_e73 % 32u);
            let _e250 = params.member.member_2.member_2;
            let _e254 = params.member.member_2.member[_e250][_e242[0]];
            let _e257 = nodes.member[(_e254 + _e211)];
            let _e273 = params.member.member_2.member_2;
            let _e277 = params.member.member_2.member[_e273][_e242[1]];
            let _e280 = nodes.member[(_e277 + _e214)];
            let _e296 = params.member.member_2.member_2;
            let _e303 = params.member.member_2.member[(_e296 - 1u)][_e242[0]];
            let _e306 = nodes.member[(_e303 + ((_e211 * 32u) + _e246))];
            let _e325 = params.member.member_2.member_2;
            let _e332 = params.member.member_2.member[(_e325 - 1u)][_e242[1]];
            let _e335 = nodes.member[(_e332 + ((_e214 * 32u) + _e246))];
            if _e197 {
                if ((((((_e335.member.x <= _e257.member_1.y) && (_e257.member.x <= _e335.member_1.y)) && (_e335.member.y <= _e257.member_2.x)) && (_e257.member.y <= _e335.member_2.x)) && (_e335.member_1.x <= _e257.member_2.y)) && (_e257.member_1.x <= _e335.member_2.y)) {
                    let _e361 = atomicAdd((&counters[_e245]), 1u);
                    let _e362 = ((_e245 * 32u) + _e361);
                    columns[_e362] = type_33(array<f32, 3>(_e335.member.x, _e335.member.y, _e335.member_1.x), array<f32, 3>(_e335.member_1.y, _e335.member_2.x, _e335.member_2.y));
                    names[_e362] = _e246;
                }
            }
            workgroupBarrier();
            if _e197 {
                if ((((((_e306.member.x <= _e280.member_1.y) && (_e280.member.x <= _e306.member_1.y)) && (_e306.member.y <= _e280.member_2.x)) && (_e280.member.y <= _e306.member_2.x)) && (_e306.member_1.x <= _e280.member_2.y)) && (_e280.member_1.x <= _e306.member_2.y)) {
                    phi_819_ = false;
                } else {
                    phi_819_ = true;
                }
                let _e380 = phi_819_;
                phi_820_ = _e380;
            } else {
                phi_820_ = true;
            }
            let _e382 = phi_820_;
            if _e382 {
                phi_824_ = type_33(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_824_ = type_33(array<f32, 3>(_e306.member.x, _e306.member.y, _e306.member_1.x), array<f32, 3>(_e306.member_1.y, _e306.member_2.x, _e306.member_2.y));
            }
            let _e384 = phi_824_;
            let _e385 = (_e73 / 32u);
            let _e388 = atomicLoad((&counters[_e385]));
            phi_837_ = type_9(0u, _e388);
            phi_840_ = 0u;
            loop {
                let _e391 = phi_837_;
                let _e393 = phi_840_;
                local_7 = _e393;
                if (_e391.member < _e391.member_1) {
                    phi_838_ = type_9((_e391.member + 1u), _e391.member_1);
                    phi_863_ = type_9(1u, _e391.member);
                } else {
                    phi_838_ = _e391;
                    phi_863_ = type_9(0u, type_9().member_1);
                }
                let _e405 = phi_838_;
                let _e407 = phi_863_;
                let _e411 = (bitcast<i32>(_e407.member) != 0i);
                if _e411 {
                    let _e415 = names[((_e385 * 32u) + _e407.member_1)];
                    let _e419 = columns[((_e385 * 32u) + _e407.member_1)];
                    if ((((((_e384.member[0] <= _e419.member_1[0]) && (_e419.member[0] <= _e384.member_1[0])) && (_e384.member[1] <= _e419.member_1[1])) && (_e419.member[1] <= _e384.member_1[1])) && (_e384.member[2] <= _e419.member_1[2])) && (_e419.member[2] <= _e384.member_1[2])) {
                        phi_936_ = true;
                    } else {
                        phi_936_ = false;
                    }
                    let _e452 = phi_936_;
                    if false {
                        if _e452 {
                            let _e456 = firsts[((_e385 * 32u) + _e415)];
                            if ((u32() >> bitcast<u32>(16i)) <= (_e456 & 65535u)) {
                                phi_958_ = ((_e456 >> bitcast<u32>(16i)) <= (u32() & 65535u));
                            } else {
                                phi_958_ = false;
                            }
                            let _e466 = phi_958_;
                            phi_959_ = _e466;
                        } else {
                            phi_959_ = false;
                        }
                        let _e468 = phi_959_;
                        phi_960_ = _e468;
                    } else {
                        phi_960_ = _e452;
                    }
                    let _e470 = phi_960_;
                    if _e470 {
                        let _e472 = atomicAdd((&counters[4u]), 1u);
                        if (_e472 < 2048u) {
                            hits[_e472] = (((_e385 << bitcast<u32>(10i)) | ((_e73 % 32u) << bitcast<u32>(5i))) | _e415);
                            phi_978_ = _e393;
                        } else {
                            phi_978_ = (_e393 | (1u << bitcast<u32>((_e407.member_1 & 31u))));
                        }
                        let _e486 = phi_978_;
                        phi_979_ = _e486;
                    } else {
                        phi_979_ = _e393;
                    }
                    let _e488 = phi_979_;
                    phi_841_ = _e488;
                } else {
                    phi_841_ = u32();
                }
                let _e490 = phi_841_;
                continue;
                continuing {
                    phi_837_ = _e405;
                    phi_840_ = _e490;
                    break if !(_e411);
                }
            }
            phi_982_ = type_9(0u, 32u);
            let _e5327 = local_7;
            phi_985_ = _e5327;
            loop {
                let _e493 = phi_982_;
                let _e495 = phi_985_;
                if (_e493.member < _e493.member_1) {
                    phi_983_ = type_9((_e493.member + 1u), _e493.member_1);
                    phi_1008_ = type_9(1u, _e493.member);
                } else {
                    phi_983_ = _e493;
                    phi_1008_ = type_9(0u, type_9().member_1);
                }
                let _e507 = phi_983_;
                let _e509 = phi_1008_;
                if (bitcast<i32>(_e509.member) != 0i) {
                    if (_e495 == 0u) {
                        phi_2238_ = u32();
                        phi_2239_ = false;
                    } else {
                        let _e520 = names[((_e98 * 32u) + select(firstTrailingBit(_e495), 32u, (_e495 == 0u)))];
                        let _e523 = (_e223 + _e99);
                        let _e524 = (_e230 + _e520);
                        let _e526 = leaves.member[_e523];
                        let _e528 = leaves.member[_e524];
                        let _e530 = nodes.member[_e523];
                        let _e544 = nodes.member[_e524];
                        let _e559 = params.member.member.member_1;
                        if ((_e559 & 1u) != 0u) {
                            if (_e528.member[0] == _e526.member[0]) {
                                phi_1102_ = true;
                            } else {
                                phi_1102_ = (_e528.member[0] == _e526.member[0]);
                            }
                            let _e569 = phi_1102_;
                            if (_e528.member[1] == _e526.member[0]) {
                                phi_1109_ = true;
                            } else {
                                phi_1109_ = (_e528.member[1] == _e526.member[0]);
                            }
                            let _e574 = phi_1109_;
                            if (_e528.member[2] == _e526.member[0]) {
                                phi_1117_ = true;
                            } else {
                                phi_1117_ = (_e528.member[2] == _e526.member[0]);
                            }
                            let _e580 = phi_1117_;
                            if ((_e569 || _e574) || _e580) {
                                phi_1140_ = false;
                            } else {
                                phi_1140_ = true;
                            }
                            let _e583 = phi_1140_;
                            phi_1141_ = _e583;
                        } else {
                            phi_1141_ = true;
                        }
                        let _e585 = phi_1141_;
                        if _e585 {
                            let _e587 = params.member.member.member_1;
                            if ((_e587 & 2u) != 0u) {
                                let _e593 = bodies.member[_e526.member[0]];
                                let _e597 = bodies.member[_e528.member[0]];
                                if ((_e593 / 4u) != (_e597 / 4u)) {
                                    phi_1186_ = true;
                                } else {
                                    if ((_e593 & 2u) == 0u) {
                                        phi_1185_ = false;
                                    } else {
                                        phi_1185_ = true;
                                    }
                                    let _e604 = phi_1185_;
                                    phi_1186_ = _e604;
                                }
                                let _e606 = phi_1186_;
                                if _e606 {
                                    phi_1193_ = (((_e593 & _e597) & 1u) == 0u);
                                } else {
                                    phi_1193_ = false;
                                }
                                let _e611 = phi_1193_;
                                if _e611 {
                                    let _e613 = params.member.member.member_1;
                                    if ((_e613 & 4u) != 0u) {
                                        let _e618 = params.member.member.member[0u];
                                        let _e620 = bodies.member[_e618];
                                        let _e623 = bodies.member[(_e618 + 1u)];
                                        let _e628 = ((_e618 + 4u) + (2u * (_e593 >> bitcast<u32>(2i))));
                                        let _e633 = ((_e618 + 4u) + (2u * (_e597 >> bitcast<u32>(2i))));
                                        let _e635 = bodies.member[_e628];
                                        let _e637 = bodies.member[_e633];
                                        let _e646 = bodies.member[((((_e618 + 4u) + (2u * _e620)) + (_e635 * _e623)) + (_e637 / 32u))];
                                        let _e649 = bodies.member[(_e628 + 1u)];
                                        let _e652 = bodies.member[(_e633 + 1u)];
                                        if (_e649 == _e652) {
                                            if (((_e646 >> bitcast<u32>(((_e637 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_1309_ = true;
                                            } else {
                                                phi_1309_ = ((_e593 >> bitcast<u32>(2i)) == (_e597 >> bitcast<u32>(2i)));
                                            }
                                            let _e666 = phi_1309_;
                                            phi_1310_ = _e666;
                                        } else {
                                            phi_1310_ = false;
                                        }
                                        let _e668 = phi_1310_;
                                        if _e668 {
                                            let _e673 = bodies.member[(_e618 + 2u)];
                                            let _e676 = bodies.member[(_e618 + 3u)];
                                            let _e677 = (_e676 + _e618);
                                            phi_1353_ = type_15(0i, 32i);
                                            phi_1356_ = _e673;
                                            phi_1358_ = 0u;
                                            loop {
                                                let _e679 = phi_1353_;
                                                let _e681 = phi_1356_;
                                                let _e683 = phi_1358_;
                                                local_3 = _e683;
                                                local_4 = _e683;
                                                if (_e679.member < _e679.member_1) {
                                                    let _e690 = (_e679.member + 1i);
                                                    if ((false == (_e690 > _e679.member)) != false) {
                                                        phi_1379_ = true;
                                                    } else {
                                                        phi_1379_ = false;
                                                    }
                                                    let _e695 = phi_1379_;
                                                    if _e695 {
                                                        phi_1385_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_1385_ = type_16(1u, _e690);
                                                    }
                                                    let _e700 = phi_1385_;
                                                    phi_1354_ = type_15(_e700.member_1, _e679.member_1);
                                                    phi_1399_ = type_16(1u, _e679.member);
                                                } else {
                                                    phi_1354_ = _e679;
                                                    phi_1399_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e706 = phi_1354_;
                                                let _e708 = phi_1399_;
                                                if (bitcast<i32>(_e708.member) != 0i) {
                                                    if (_e683 >= _e681) {
                                                        phi_1482_ = u32();
                                                        phi_1483_ = u32();
                                                        phi_1484_ = false;
                                                    } else {
                                                        let _e715 = (_e683 + ((_e681 - _e683) / 2u));
                                                        let _e717 = (_e677 + (3u * _e715));
                                                        let _e719 = bodies.member[_e717];
                                                        let _e722 = bodies.member[(_e717 + 1u)];
                                                        let _e725 = bodies.member[(_e717 + 2u)];
                                                        if (_e719 == 0u) {
                                                            if (_e722 < _e526.member_1) {
                                                                phi_1469_ = false;
                                                            } else {
                                                                if (_e722 == _e526.member_1) {
                                                                    if (_e725 < _e528.member_1) {
                                                                        phi_1467_ = false;
                                                                    } else {
                                                                        phi_1467_ = true;
                                                                    }
                                                                    let _e731 = phi_1467_;
                                                                    phi_1468_ = _e731;
                                                                } else {
                                                                    phi_1468_ = true;
                                                                }
                                                                let _e733 = phi_1468_;
                                                                phi_1469_ = _e733;
                                                            }
                                                            let _e735 = phi_1469_;
                                                            phi_1470_ = _e735;
                                                        } else {
                                                            phi_1470_ = true;
                                                        }
                                                        let _e737 = phi_1470_;
                                                        if _e737 {
                                                            phi_1474_ = false;
                                                        } else {
                                                            phi_1474_ = true;
                                                        }
                                                        let _e739 = phi_1474_;
                                                        if _e739 {
                                                            phi_1480_ = _e681;
                                                            phi_1481_ = (_e715 + 1u);
                                                        } else {
                                                            phi_1480_ = _e715;
                                                            phi_1481_ = _e683;
                                                        }
                                                        let _e742 = phi_1480_;
                                                        let _e744 = phi_1481_;
                                                        phi_1482_ = _e742;
                                                        phi_1483_ = _e744;
                                                        phi_1484_ = true;
                                                    }
                                                    let _e746 = phi_1482_;
                                                    let _e748 = phi_1483_;
                                                    let _e750 = phi_1484_;
                                                    phi_1357_ = _e746;
                                                    phi_1359_ = _e748;
                                                    phi_1485_ = _e750;
                                                } else {
                                                    phi_1357_ = u32();
                                                    phi_1359_ = u32();
                                                    phi_1485_ = false;
                                                }
                                                let _e752 = phi_1357_;
                                                let _e754 = phi_1359_;
                                                let _e756 = phi_1485_;
                                                continue;
                                                continuing {
                                                    phi_1353_ = _e706;
                                                    phi_1356_ = _e752;
                                                    phi_1358_ = _e754;
                                                    break if !(_e756);
                                                }
                                            }
                                            let _e759 = local_3;
                                            if (_e759 < _e673) {
                                                let _e762 = local_4;
                                                let _e764 = (_e677 + (3u * _e762));
                                                let _e766 = bodies.member[_e764];
                                                if (_e766 == 0u) {
                                                    let _e770 = bodies.member[(_e764 + 1u)];
                                                    if (_e770 == _e526.member_1) {
                                                        let _e774 = bodies.member[(_e764 + 2u)];
                                                        phi_1533_ = (_e774 == _e528.member_1);
                                                        phi_1534_ = false;
                                                    } else {
                                                        phi_1533_ = bool();
                                                        phi_1534_ = true;
                                                    }
                                                    let _e777 = phi_1533_;
                                                    let _e779 = phi_1534_;
                                                    phi_1535_ = _e777;
                                                    phi_1536_ = _e779;
                                                } else {
                                                    phi_1535_ = bool();
                                                    phi_1536_ = true;
                                                }
                                                let _e781 = phi_1535_;
                                                let _e783 = phi_1536_;
                                                if _e783 {
                                                    phi_1540_ = false;
                                                } else {
                                                    phi_1540_ = _e781;
                                                }
                                                let _e785 = phi_1540_;
                                                phi_1541_ = _e785;
                                            } else {
                                                phi_1541_ = false;
                                            }
                                            let _e787 = phi_1541_;
                                            phi_1545_ = _e787;
                                        } else {
                                            phi_1545_ = true;
                                        }
                                        let _e789 = phi_1545_;
                                        if _e789 {
                                            phi_1549_ = false;
                                        } else {
                                            phi_1549_ = true;
                                        }
                                        let _e791 = phi_1549_;
                                        phi_1550_ = _e791;
                                    } else {
                                        phi_1550_ = true;
                                    }
                                    let _e793 = phi_1550_;
                                    if _e793 {
                                        phi_1554_ = false;
                                    } else {
                                        phi_1554_ = true;
                                    }
                                    let _e795 = phi_1554_;
                                    phi_1555_ = _e795;
                                } else {
                                    phi_1555_ = true;
                                }
                                let _e797 = phi_1555_;
                                if _e797 {
                                    phi_1559_ = false;
                                } else {
                                    phi_1559_ = true;
                                }
                                let _e799 = phi_1559_;
                                phi_1560_ = _e799;
                            } else {
                                phi_1560_ = true;
                            }
                            let _e801 = phi_1560_;
                            if _e801 {
                                let _e803 = params.member.member.member_1;
                                if ((_e803 & 32u) != 0u) {
                                    let _e807 = params.member.member.member_6;
                                    let _e824 = (((((_e530.member_1.y - _e544.member.x) > _e807) && ((_e544.member_1.y - _e530.member.x) > _e807)) && (((_e530.member_2.x - _e544.member.y) > _e807) && ((_e544.member_2.x - _e530.member.y) > _e807))) && (((_e530.member_2.y - _e544.member_1.x) > _e807) && ((_e544.member_2.y - _e530.member_1.x) > _e807)));
                                    if _e824 {
                                        phi_2162_ = bool();
                                    } else {
                                        let _e828 = keys.member[_e526.member[0]];
                                        let _e833 = keys.member[_e526.member[1]];
                                        let _e835 = function_(_e828[0], _e833[0]);
                                        let _e839 = keys.member[_e526.member[2]];
                                        let _e841 = function_(_e835, _e839[0]);
                                        let _e845 = keys.member[_e528.member[0]];
                                        let _e850 = keys.member[_e528.member[1]];
                                        let _e852 = function_1(_e845[3], _e850[3]);
                                        let _e856 = keys.member[_e528.member[2]];
                                        let _e858 = function_1(_e852, _e856[3]);
                                        if (_e841[1] > _e858[1]) {
                                            phi_1685_ = true;
                                        } else {
                                            if (_e841[1] == _e858[1]) {
                                                phi_1684_ = (_e841[0] > _e858[0]);
                                            } else {
                                                phi_1684_ = false;
                                            }
                                            let _e869 = phi_1684_;
                                            phi_1685_ = _e869;
                                        }
                                        let _e871 = phi_1685_;
                                        let _e876 = keys.member[_e528.member[0]];
                                        let _e881 = keys.member[_e528.member[1]];
                                        let _e883 = function_(_e876[0], _e881[0]);
                                        let _e887 = keys.member[_e528.member[2]];
                                        let _e889 = function_(_e883, _e887[0]);
                                        let _e893 = keys.member[_e526.member[0]];
                                        let _e898 = keys.member[_e526.member[1]];
                                        let _e900 = function_1(_e893[3], _e898[3]);
                                        let _e904 = keys.member[_e526.member[2]];
                                        let _e906 = function_1(_e900, _e904[3]);
                                        if (_e889[1] > _e906[1]) {
                                            phi_1779_ = true;
                                        } else {
                                            if (_e889[1] == _e906[1]) {
                                                phi_1778_ = (_e889[0] > _e906[0]);
                                            } else {
                                                phi_1778_ = false;
                                            }
                                            let _e917 = phi_1778_;
                                            phi_1779_ = _e917;
                                        }
                                        let _e919 = phi_1779_;
                                        let _e925 = keys.member[_e526.member[0]];
                                        let _e930 = keys.member[_e526.member[1]];
                                        let _e932 = function_2(_e925[1], _e930[1]);
                                        let _e936 = keys.member[_e526.member[2]];
                                        let _e938 = function_2(_e932, _e936[1]);
                                        let _e942 = keys.member[_e528.member[0]];
                                        let _e947 = keys.member[_e528.member[1]];
                                        let _e949 = function_3(_e942[4], _e947[4]);
                                        let _e953 = keys.member[_e528.member[2]];
                                        let _e955 = function_3(_e949, _e953[4]);
                                        if (_e938[1] > _e955[1]) {
                                            phi_1874_ = true;
                                        } else {
                                            if (_e938[1] == _e955[1]) {
                                                phi_1873_ = (_e938[0] > _e955[0]);
                                            } else {
                                                phi_1873_ = false;
                                            }
                                            let _e966 = phi_1873_;
                                            phi_1874_ = _e966;
                                        }
                                        let _e968 = phi_1874_;
                                        let _e973 = keys.member[_e528.member[0]];
                                        let _e978 = keys.member[_e528.member[1]];
                                        let _e980 = function_2(_e973[1], _e978[1]);
                                        let _e984 = keys.member[_e528.member[2]];
                                        let _e986 = function_2(_e980, _e984[1]);
                                        let _e990 = keys.member[_e526.member[0]];
                                        let _e995 = keys.member[_e526.member[1]];
                                        let _e997 = function_3(_e990[4], _e995[4]);
                                        let _e1001 = keys.member[_e526.member[2]];
                                        let _e1003 = function_3(_e997, _e1001[4]);
                                        if (_e986[1] > _e1003[1]) {
                                            phi_1968_ = true;
                                        } else {
                                            if (_e986[1] == _e1003[1]) {
                                                phi_1967_ = (_e986[0] > _e1003[0]);
                                            } else {
                                                phi_1967_ = false;
                                            }
                                            let _e1014 = phi_1967_;
                                            phi_1968_ = _e1014;
                                        }
                                        let _e1016 = phi_1968_;
                                        let _e1023 = keys.member[_e526.member[0]];
                                        let _e1028 = keys.member[_e526.member[1]];
                                        let _e1030 = function_4(_e1023[2], _e1028[2]);
                                        let _e1034 = keys.member[_e526.member[2]];
                                        let _e1036 = function_4(_e1030, _e1034[2]);
                                        let _e1040 = keys.member[_e528.member[0]];
                                        let _e1045 = keys.member[_e528.member[1]];
                                        let _e1047 = function_5(_e1040[5], _e1045[5]);
                                        let _e1051 = keys.member[_e528.member[2]];
                                        let _e1053 = function_5(_e1047, _e1051[5]);
                                        if (_e1036[1] > _e1053[1]) {
                                            phi_2064_ = true;
                                        } else {
                                            if (_e1036[1] == _e1053[1]) {
                                                phi_2063_ = (_e1036[0] > _e1053[0]);
                                            } else {
                                                phi_2063_ = false;
                                            }
                                            let _e1064 = phi_2063_;
                                            phi_2064_ = _e1064;
                                        }
                                        let _e1066 = phi_2064_;
                                        let _e1071 = keys.member[_e528.member[0]];
                                        let _e1076 = keys.member[_e528.member[1]];
                                        let _e1078 = function_4(_e1071[2], _e1076[2]);
                                        let _e1082 = keys.member[_e528.member[2]];
                                        let _e1084 = function_4(_e1078, _e1082[2]);
                                        let _e1088 = keys.member[_e526.member[0]];
                                        let _e1093 = keys.member[_e526.member[1]];
                                        let _e1095 = function_5(_e1088[5], _e1093[5]);
                                        let _e1099 = keys.member[_e526.member[2]];
                                        let _e1101 = function_5(_e1095, _e1099[5]);
                                        if (_e1084[1] > _e1101[1]) {
                                            phi_2158_ = true;
                                        } else {
                                            if (_e1084[1] == _e1101[1]) {
                                                phi_2157_ = (_e1084[0] > _e1101[0]);
                                            } else {
                                                phi_2157_ = false;
                                            }
                                            let _e1112 = phi_2157_;
                                            phi_2158_ = _e1112;
                                        }
                                        let _e1114 = phi_2158_;
                                        phi_2162_ = (((!(_e871) && !(_e919)) && (!(_e968) && !(_e1016))) && (!(_e1066) && !(_e1114)));
                                    }
                                    let _e1119 = phi_2162_;
                                    phi_2163_ = _e1119;
                                    phi_2164_ = _e824;
                                } else {
                                    phi_2163_ = bool();
                                    phi_2164_ = true;
                                }
                                let _e1121 = phi_2163_;
                                let _e1123 = phi_2164_;
                                if _e1123 {
                                    phi_2168_ = false;
                                } else {
                                    phi_2168_ = true;
                                }
                                let _e1125 = phi_2168_;
                                phi_2169_ = _e1121;
                                phi_2170_ = _e1125;
                            } else {
                                phi_2169_ = false;
                                phi_2170_ = true;
                            }
                            let _e1127 = phi_2169_;
                            let _e1129 = phi_2170_;
                            phi_2171_ = _e1127;
                            phi_2172_ = _e1129;
                        } else {
                            phi_2171_ = false;
                            phi_2172_ = true;
                        }
                        let _e1131 = phi_2171_;
                        let _e1133 = phi_2172_;
                        if _e1133 {
                            phi_2176_ = _e1131;
                        } else {
                            phi_2176_ = true;
                        }
                        let _e1135 = phi_2176_;
                        if _e1135 {
                            let _e1140 = params.member.member_1.member_3;
                            let _e1142 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1142 + 1u) < _e1142) {
                                let _e1146 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1142 < _e1140) {
                                let _e1148 = (2u * _e1142);
                                atomicStore((&output.member[(4u + _e1148)]), _e526.member_1);
                                atomicStore((&output.member[(_e1148 + 5u)]), _e528.member_1);
                            }
                            let _e1154 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1154 + 1u) < _e1154) {
                                let _e1158 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_2238_ = (_e495 & (_e495 - 1u));
                        phi_2239_ = true;
                    }
                    let _e1160 = phi_2238_;
                    let _e1162 = phi_2239_;
                    phi_986_ = _e1160;
                    phi_2240_ = _e1162;
                } else {
                    phi_986_ = u32();
                    phi_2240_ = false;
                }
                let _e1164 = phi_986_;
                let _e1166 = phi_2240_;
                continue;
                continuing {
                    phi_982_ = _e507;
                    phi_985_ = _e1164;
                    break if !(_e1166);
                }
            }
            workgroupBarrier();
            let _e1169 = atomicLoad((&counters[4u]));
            if (2048u < _e1169) {
                phi_2247_ = 2048u;
            } else {
                phi_2247_ = _e1169;
            }
            let _e1172 = phi_2247_;
            phi_2250_ = type_9(0u, 16u);
            loop {
                let _e1174 = phi_2250_;
                if (_e1174.member < _e1174.member_1) {
                    phi_2251_ = type_9((_e1174.member + 1u), _e1174.member_1);
                    phi_2274_ = type_9(1u, _e1174.member);
                } else {
                    phi_2251_ = _e1174;
                    phi_2274_ = type_9(0u, type_9().member_1);
                }
                let _e1186 = phi_2251_;
                let _e1188 = phi_2274_;
                if (bitcast<i32>(_e1188.member) != 0i) {
                    let _e1194 = (_e73 + (_e1188.member_1 * 128u));
                    if (_e1194 >= _e1172) {
                        phi_8665_ = false;
                    } else {
                        let _e1197 = hits[_e1194];
                        let _e1200 = ((_e1197 >> bitcast<u32>(10i)) & 3u);
                        let _e1207 = firsts[(2u * _e1200)];
                        let _e1208 = (_e1207 + ((_e1197 >> bitcast<u32>(5i)) & 31u));
                        let _e1212 = firsts[((2u * _e1200) + 1u)];
                        let _e1213 = (_e1212 + (_e1197 & 31u));
                        let _e1215 = leaves.member[_e1208];
                        let _e1217 = leaves.member[_e1213];
                        let _e1219 = nodes.member[_e1208];
                        let _e1233 = nodes.member[_e1213];
                        let _e1248 = params.member.member.member_1;
                        if ((_e1248 & 1u) != 0u) {
                            if (_e1217.member[0] == _e1215.member[0]) {
                                phi_2376_ = true;
                            } else {
                                phi_2376_ = (_e1217.member[0] == _e1215.member[0]);
                            }
                            let _e1258 = phi_2376_;
                            if (_e1217.member[1] == _e1215.member[0]) {
                                phi_2383_ = true;
                            } else {
                                phi_2383_ = (_e1217.member[1] == _e1215.member[0]);
                            }
                            let _e1263 = phi_2383_;
                            if (_e1217.member[2] == _e1215.member[0]) {
                                phi_2391_ = true;
                            } else {
                                phi_2391_ = (_e1217.member[2] == _e1215.member[0]);
                            }
                            let _e1269 = phi_2391_;
                            if ((_e1258 || _e1263) || _e1269) {
                                phi_2414_ = false;
                            } else {
                                phi_2414_ = true;
                            }
                            let _e1272 = phi_2414_;
                            phi_2415_ = _e1272;
                        } else {
                            phi_2415_ = true;
                        }
                        let _e1274 = phi_2415_;
                        if _e1274 {
                            let _e1276 = params.member.member.member_1;
                            if ((_e1276 & 2u) != 0u) {
                                let _e1282 = bodies.member[_e1215.member[0]];
                                let _e1286 = bodies.member[_e1217.member[0]];
                                if ((_e1282 / 4u) != (_e1286 / 4u)) {
                                    phi_2460_ = true;
                                } else {
                                    if ((_e1282 & 2u) == 0u) {
                                        phi_2459_ = false;
                                    } else {
                                        phi_2459_ = true;
                                    }
                                    let _e1293 = phi_2459_;
                                    phi_2460_ = _e1293;
                                }
                                let _e1295 = phi_2460_;
                                if _e1295 {
                                    phi_2467_ = (((_e1282 & _e1286) & 1u) == 0u);
                                } else {
                                    phi_2467_ = false;
                                }
                                let _e1300 = phi_2467_;
                                if _e1300 {
                                    let _e1302 = params.member.member.member_1;
                                    if ((_e1302 & 4u) != 0u) {
                                        let _e1307 = params.member.member.member[0u];
                                        let _e1309 = bodies.member[_e1307];
                                        let _e1312 = bodies.member[(_e1307 + 1u)];
                                        let _e1317 = ((_e1307 + 4u) + (2u * (_e1282 >> bitcast<u32>(2i))));
                                        let _e1322 = ((_e1307 + 4u) + (2u * (_e1286 >> bitcast<u32>(2i))));
                                        let _e1324 = bodies.member[_e1317];
                                        let _e1326 = bodies.member[_e1322];
                                        let _e1335 = bodies.member[((((_e1307 + 4u) + (2u * _e1309)) + (_e1324 * _e1312)) + (_e1326 / 32u))];
                                        let _e1338 = bodies.member[(_e1317 + 1u)];
                                        let _e1341 = bodies.member[(_e1322 + 1u)];
                                        if (_e1338 == _e1341) {
                                            if (((_e1335 >> bitcast<u32>(((_e1326 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_2583_ = true;
                                            } else {
                                                phi_2583_ = ((_e1282 >> bitcast<u32>(2i)) == (_e1286 >> bitcast<u32>(2i)));
                                            }
                                            let _e1355 = phi_2583_;
                                            phi_2584_ = _e1355;
                                        } else {
                                            phi_2584_ = false;
                                        }
                                        let _e1357 = phi_2584_;
                                        if _e1357 {
                                            let _e1362 = bodies.member[(_e1307 + 2u)];
                                            let _e1365 = bodies.member[(_e1307 + 3u)];
                                            let _e1366 = (_e1365 + _e1307);
                                            phi_2627_ = type_15(0i, 32i);
                                            phi_2630_ = _e1362;
                                            phi_2632_ = 0u;
                                            loop {
                                                let _e1368 = phi_2627_;
                                                let _e1370 = phi_2630_;
                                                let _e1372 = phi_2632_;
                                                local_5 = _e1372;
                                                local_6 = _e1372;
                                                if (_e1368.member < _e1368.member_1) {
                                                    let _e1379 = (_e1368.member + 1i);
                                                    if ((false == (_e1379 > _e1368.member)) != false) {
                                                        phi_2653_ = true;
                                                    } else {
                                                        phi_2653_ = false;
                                                    }
                                                    let _e1384 = phi_2653_;
                                                    if _e1384 {
                                                        phi_2659_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_2659_ = type_16(1u, _e1379);
                                                    }
                                                    let _e1389 = phi_2659_;
                                                    phi_2628_ = type_15(_e1389.member_1, _e1368.member_1);
                                                    phi_2673_ = type_16(1u, _e1368.member);
                                                } else {
                                                    phi_2628_ = _e1368;
                                                    phi_2673_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e1395 = phi_2628_;
                                                let _e1397 = phi_2673_;
                                                if (bitcast<i32>(_e1397.member) != 0i) {
                                                    if (_e1372 >= _e1370) {
                                                        phi_2756_ = u32();
                                                        phi_2757_ = u32();
                                                        phi_2758_ = false;
                                                    } else {
                                                        let _e1404 = (_e1372 + ((_e1370 - _e1372) / 2u));
                                                        let _e1406 = (_e1366 + (3u * _e1404));
                                                        let _e1408 = bodies.member[_e1406];
                                                        let _e1411 = bodies.member[(_e1406 + 1u)];
                                                        let _e1414 = bodies.member[(_e1406 + 2u)];
                                                        if (_e1408 == 0u) {
                                                            if (_e1411 < _e1215.member_1) {
                                                                phi_2743_ = false;
                                                            } else {
                                                                if (_e1411 == _e1215.member_1) {
                                                                    if (_e1414 < _e1217.member_1) {
                                                                        phi_2741_ = false;
                                                                    } else {
                                                                        phi_2741_ = true;
                                                                    }
                                                                    let _e1420 = phi_2741_;
                                                                    phi_2742_ = _e1420;
                                                                } else {
                                                                    phi_2742_ = true;
                                                                }
                                                                let _e1422 = phi_2742_;
                                                                phi_2743_ = _e1422;
                                                            }
                                                            let _e1424 = phi_2743_;
                                                            phi_2744_ = _e1424;
                                                        } else {
                                                            phi_2744_ = true;
                                                        }
                                                        let _e1426 = phi_2744_;
                                                        if _e1426 {
                                                            phi_2748_ = false;
                                                        } else {
                                                            phi_2748_ = true;
                                                        }
                                                        let _e1428 = phi_2748_;
                                                        if _e1428 {
                                                            phi_2754_ = _e1370;
                                                            phi_2755_ = (_e1404 + 1u);
                                                        } else {
                                                            phi_2754_ = _e1404;
                                                            phi_2755_ = _e1372;
                                                        }
                                                        let _e1431 = phi_2754_;
                                                        let _e1433 = phi_2755_;
                                                        phi_2756_ = _e1431;
                                                        phi_2757_ = _e1433;
                                                        phi_2758_ = true;
                                                    }
                                                    let _e1435 = phi_2756_;
                                                    let _e1437 = phi_2757_;
                                                    let _e1439 = phi_2758_;
                                                    phi_2631_ = _e1435;
                                                    phi_2633_ = _e1437;
                                                    phi_2759_ = _e1439;
                                                } else {
                                                    phi_2631_ = u32();
                                                    phi_2633_ = u32();
                                                    phi_2759_ = false;
                                                }
                                                let _e1441 = phi_2631_;
                                                let _e1443 = phi_2633_;
                                                let _e1445 = phi_2759_;
                                                continue;
                                                continuing {
                                                    phi_2627_ = _e1395;
                                                    phi_2630_ = _e1441;
                                                    phi_2632_ = _e1443;
                                                    break if !(_e1445);
                                                }
                                            }
                                            let _e1448 = local_5;
                                            if (_e1448 < _e1362) {
                                                let _e1451 = local_6;
                                                let _e1453 = (_e1366 + (3u * _e1451));
                                                let _e1455 = bodies.member[_e1453];
                                                if (_e1455 == 0u) {
                                                    let _e1459 = bodies.member[(_e1453 + 1u)];
                                                    if (_e1459 == _e1215.member_1) {
                                                        let _e1463 = bodies.member[(_e1453 + 2u)];
                                                        phi_2807_ = (_e1463 == _e1217.member_1);
                                                        phi_2808_ = false;
                                                    } else {
                                                        phi_2807_ = bool();
                                                        phi_2808_ = true;
                                                    }
                                                    let _e1466 = phi_2807_;
                                                    let _e1468 = phi_2808_;
                                                    phi_2809_ = _e1466;
                                                    phi_2810_ = _e1468;
                                                } else {
                                                    phi_2809_ = bool();
                                                    phi_2810_ = true;
                                                }
                                                let _e1470 = phi_2809_;
                                                let _e1472 = phi_2810_;
                                                if _e1472 {
                                                    phi_2814_ = false;
                                                } else {
                                                    phi_2814_ = _e1470;
                                                }
                                                let _e1474 = phi_2814_;
                                                phi_2815_ = _e1474;
                                            } else {
                                                phi_2815_ = false;
                                            }
                                            let _e1476 = phi_2815_;
                                            phi_2819_ = _e1476;
                                        } else {
                                            phi_2819_ = true;
                                        }
                                        let _e1478 = phi_2819_;
                                        if _e1478 {
                                            phi_2823_ = false;
                                        } else {
                                            phi_2823_ = true;
                                        }
                                        let _e1480 = phi_2823_;
                                        phi_2824_ = _e1480;
                                    } else {
                                        phi_2824_ = true;
                                    }
                                    let _e1482 = phi_2824_;
                                    if _e1482 {
                                        phi_2828_ = false;
                                    } else {
                                        phi_2828_ = true;
                                    }
                                    let _e1484 = phi_2828_;
                                    phi_2829_ = _e1484;
                                } else {
                                    phi_2829_ = true;
                                }
                                let _e1486 = phi_2829_;
                                if _e1486 {
                                    phi_2833_ = false;
                                } else {
                                    phi_2833_ = true;
                                }
                                let _e1488 = phi_2833_;
                                phi_2834_ = _e1488;
                            } else {
                                phi_2834_ = true;
                            }
                            let _e1490 = phi_2834_;
                            if _e1490 {
                                let _e1492 = params.member.member.member_1;
                                if ((_e1492 & 32u) != 0u) {
                                    let _e1496 = params.member.member.member_6;
                                    let _e1513 = (((((_e1219.member_1.y - _e1233.member.x) > _e1496) && ((_e1233.member_1.y - _e1219.member.x) > _e1496)) && (((_e1219.member_2.x - _e1233.member.y) > _e1496) && ((_e1233.member_2.x - _e1219.member.y) > _e1496))) && (((_e1219.member_2.y - _e1233.member_1.x) > _e1496) && ((_e1233.member_2.y - _e1219.member_1.x) > _e1496)));
                                    if _e1513 {
                                        phi_3436_ = bool();
                                    } else {
                                        let _e1517 = keys.member[_e1215.member[0]];
                                        let _e1522 = keys.member[_e1215.member[1]];
                                        let _e1524 = function_(_e1517[0], _e1522[0]);
                                        let _e1528 = keys.member[_e1215.member[2]];
                                        let _e1530 = function_(_e1524, _e1528[0]);
                                        let _e1534 = keys.member[_e1217.member[0]];
                                        let _e1539 = keys.member[_e1217.member[1]];
                                        let _e1541 = function_1(_e1534[3], _e1539[3]);
                                        let _e1545 = keys.member[_e1217.member[2]];
                                        let _e1547 = function_1(_e1541, _e1545[3]);
                                        if (_e1530[1] > _e1547[1]) {
                                            phi_2959_ = true;
                                        } else {
                                            if (_e1530[1] == _e1547[1]) {
                                                phi_2958_ = (_e1530[0] > _e1547[0]);
                                            } else {
                                                phi_2958_ = false;
                                            }
                                            let _e1558 = phi_2958_;
                                            phi_2959_ = _e1558;
                                        }
                                        let _e1560 = phi_2959_;
                                        let _e1565 = keys.member[_e1217.member[0]];
                                        let _e1570 = keys.member[_e1217.member[1]];
                                        let _e1572 = function_(_e1565[0], _e1570[0]);
                                        let _e1576 = keys.member[_e1217.member[2]];
                                        let _e1578 = function_(_e1572, _e1576[0]);
                                        let _e1582 = keys.member[_e1215.member[0]];
                                        let _e1587 = keys.member[_e1215.member[1]];
                                        let _e1589 = function_1(_e1582[3], _e1587[3]);
                                        let _e1593 = keys.member[_e1215.member[2]];
                                        let _e1595 = function_1(_e1589, _e1593[3]);
                                        if (_e1578[1] > _e1595[1]) {
                                            phi_3053_ = true;
                                        } else {
                                            if (_e1578[1] == _e1595[1]) {
                                                phi_3052_ = (_e1578[0] > _e1595[0]);
                                            } else {
                                                phi_3052_ = false;
                                            }
                                            let _e1606 = phi_3052_;
                                            phi_3053_ = _e1606;
                                        }
                                        let _e1608 = phi_3053_;
                                        let _e1614 = keys.member[_e1215.member[0]];
                                        let _e1619 = keys.member[_e1215.member[1]];
                                        let _e1621 = function_2(_e1614[1], _e1619[1]);
                                        let _e1625 = keys.member[_e1215.member[2]];
                                        let _e1627 = function_2(_e1621, _e1625[1]);
                                        let _e1631 = keys.member[_e1217.member[0]];
                                        let _e1636 = keys.member[_e1217.member[1]];
                                        let _e1638 = function_3(_e1631[4], _e1636[4]);
                                        let _e1642 = keys.member[_e1217.member[2]];
                                        let _e1644 = function_3(_e1638, _e1642[4]);
                                        if (_e1627[1] > _e1644[1]) {
                                            phi_3148_ = true;
                                        } else {
                                            if (_e1627[1] == _e1644[1]) {
                                                phi_3147_ = (_e1627[0] > _e1644[0]);
                                            } else {
                                                phi_3147_ = false;
                                            }
                                            let _e1655 = phi_3147_;
                                            phi_3148_ = _e1655;
                                        }
                                        let _e1657 = phi_3148_;
                                        let _e1662 = keys.member[_e1217.member[0]];
                                        let _e1667 = keys.member[_e1217.member[1]];
                                        let _e1669 = function_2(_e1662[1], _e1667[1]);
                                        let _e1673 = keys.member[_e1217.member[2]];
                                        let _e1675 = function_2(_e1669, _e1673[1]);
                                        let _e1679 = keys.member[_e1215.member[0]];
                                        let _e1684 = keys.member[_e1215.member[1]];
                                        let _e1686 = function_3(_e1679[4], _e1684[4]);
                                        let _e1690 = keys.member[_e1215.member[2]];
                                        let _e1692 = function_3(_e1686, _e1690[4]);
                                        if (_e1675[1] > _e1692[1]) {
                                            phi_3242_ = true;
                                        } else {
                                            if (_e1675[1] == _e1692[1]) {
                                                phi_3241_ = (_e1675[0] > _e1692[0]);
                                            } else {
                                                phi_3241_ = false;
                                            }
                                            let _e1703 = phi_3241_;
                                            phi_3242_ = _e1703;
                                        }
                                        let _e1705 = phi_3242_;
                                        let _e1712 = keys.member[_e1215.member[0]];
                                        let _e1717 = keys.member[_e1215.member[1]];
                                        let _e1719 = function_4(_e1712[2], _e1717[2]);
                                        let _e1723 = keys.member[_e1215.member[2]];
                                        let _e1725 = function_4(_e1719, _e1723[2]);
                                        let _e1729 = keys.member[_e1217.member[0]];
                                        let _e1734 = keys.member[_e1217.member[1]];
                                        let _e1736 = function_5(_e1729[5], _e1734[5]);
                                        let _e1740 = keys.member[_e1217.member[2]];
                                        let _e1742 = function_5(_e1736, _e1740[5]);
                                        if (_e1725[1] > _e1742[1]) {
                                            phi_3338_ = true;
                                        } else {
                                            if (_e1725[1] == _e1742[1]) {
                                                phi_3337_ = (_e1725[0] > _e1742[0]);
                                            } else {
                                                phi_3337_ = false;
                                            }
                                            let _e1753 = phi_3337_;
                                            phi_3338_ = _e1753;
                                        }
                                        let _e1755 = phi_3338_;
                                        let _e1760 = keys.member[_e1217.member[0]];
                                        let _e1765 = keys.member[_e1217.member[1]];
                                        let _e1767 = function_4(_e1760[2], _e1765[2]);
                                        let _e1771 = keys.member[_e1217.member[2]];
                                        let _e1773 = function_4(_e1767, _e1771[2]);
                                        let _e1777 = keys.member[_e1215.member[0]];
                                        let _e1782 = keys.member[_e1215.member[1]];
                                        let _e1784 = function_5(_e1777[5], _e1782[5]);
                                        let _e1788 = keys.member[_e1215.member[2]];
                                        let _e1790 = function_5(_e1784, _e1788[5]);
                                        if (_e1773[1] > _e1790[1]) {
                                            phi_3432_ = true;
                                        } else {
                                            if (_e1773[1] == _e1790[1]) {
                                                phi_3431_ = (_e1773[0] > _e1790[0]);
                                            } else {
                                                phi_3431_ = false;
                                            }
                                            let _e1801 = phi_3431_;
                                            phi_3432_ = _e1801;
                                        }
                                        let _e1803 = phi_3432_;
                                        phi_3436_ = (((!(_e1560) && !(_e1608)) && (!(_e1657) && !(_e1705))) && (!(_e1755) && !(_e1803)));
                                    }
                                    let _e1808 = phi_3436_;
                                    phi_3437_ = _e1808;
                                    phi_3438_ = _e1513;
                                } else {
                                    phi_3437_ = bool();
                                    phi_3438_ = true;
                                }
                                let _e1810 = phi_3437_;
                                let _e1812 = phi_3438_;
                                if _e1812 {
                                    phi_3442_ = false;
                                } else {
                                    phi_3442_ = true;
                                }
                                let _e1814 = phi_3442_;
                                phi_3443_ = _e1810;
                                phi_3444_ = _e1814;
                            } else {
                                phi_3443_ = false;
                                phi_3444_ = true;
                            }
                            let _e1816 = phi_3443_;
                            let _e1818 = phi_3444_;
                            phi_3445_ = _e1816;
                            phi_3446_ = _e1818;
                        } else {
                            phi_3445_ = false;
                            phi_3446_ = true;
                        }
                        let _e1820 = phi_3445_;
                        let _e1822 = phi_3446_;
                        if _e1822 {
                            phi_3450_ = _e1820;
                        } else {
                            phi_3450_ = true;
                        }
                        let _e1824 = phi_3450_;
                        if _e1824 {
                            let _e1826 = atomicAdd((&counters[7u]), 1u);
                            let _e1837 = params.member.member.member_4;
                            let _e1839 = params.member.member.member_5;
                            let _e1841 = paths.member[_e1215.member[0]];
                            let _e1843 = paths.member[_e1217.member[0]];
                            let _e1849 = paths.member[_e1217.member[1]];
                            let _e1851 = paths.member[_e1217.member[2]];
                            local_2 = type_41(array<array<f32, 3>, 2>(array<f32, 3>((_e1841.member[0] - _e1843.member[0]), (_e1841.member[1] - _e1843.member[1]), (_e1841.member[2] - _e1843.member[2])), array<f32, 3>((_e1841.member_1[0] - _e1843.member_1[0]), (_e1841.member_1[1] - _e1843.member_1[1]), (_e1841.member_1[2] - _e1843.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1849.member[0] - _e1843.member[0]), (_e1849.member[1] - _e1843.member[1]), (_e1849.member[2] - _e1843.member[2])), array<f32, 3>((_e1849.member_1[0] - _e1843.member_1[0]), (_e1849.member_1[1] - _e1843.member_1[1]), (_e1849.member_1[2] - _e1843.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1851.member[0] - _e1843.member[0]), (_e1851.member[1] - _e1843.member[1]), (_e1851.member[2] - _e1843.member[2])), array<f32, 3>((_e1851.member_1[0] - _e1843.member_1[0]), (_e1851.member_1[1] - _e1843.member_1[1]), (_e1851.member_1[2] - _e1843.member_1[2]))), (_e1837 + _e1837));
                            let _e1911 = local_2.member_1[0u];
                            let _e1917 = local_2.member_2[0u];
                            let _e1923 = ((_e1911[1] * _e1917[2]) - (_e1911[2] * _e1917[1]));
                            let _e1926 = ((_e1911[2] * _e1917[0]) - (_e1911[0] * _e1917[2]));
                            let _e1929 = ((_e1911[0] * _e1917[1]) - (_e1911[1] * _e1917[0]));
                            let _e1932 = local_2.member_1[1u];
                            let _e1938 = local_2.member_2[1u];
                            let _e1944 = ((_e1932[1] * _e1938[2]) - (_e1932[2] * _e1938[1]));
                            let _e1947 = ((_e1932[2] * _e1938[0]) - (_e1932[0] * _e1938[2]));
                            let _e1950 = ((_e1932[0] * _e1938[1]) - (_e1932[1] * _e1938[0]));
                            let _e1953 = local_2.member_1[0u];
                            let _e1959 = local_2.member_2[1u];
                            let _e1974 = local_2.member_1[1u];
                            let _e1980 = local_2.member_2[0u];
                            let _e1993 = (((_e1953[1] * _e1959[2]) - (_e1953[2] * _e1959[1])) + ((_e1974[1] * _e1980[2]) - (_e1974[2] * _e1980[1])));
                            let _e1994 = (((_e1953[2] * _e1959[0]) - (_e1953[0] * _e1959[2])) + ((_e1974[2] * _e1980[0]) - (_e1974[0] * _e1980[2])));
                            let _e1995 = (((_e1953[0] * _e1959[1]) - (_e1953[1] * _e1959[0])) + ((_e1974[0] * _e1980[1]) - (_e1974[1] * _e1980[0])));
                            let _e1998 = local_2.member[0u];
                            let _e2009 = local_2.member[1u];
                            let _e2020 = local_2.member[0u];
                            let _e2029 = ((((_e2009[0] * _e1923) + (_e2009[1] * _e1926)) + (_e2009[2] * _e1929)) + (((_e2020[0] * _e1993) + (_e2020[1] * _e1994)) + (_e2020[2] * _e1995)));
                            let _e2032 = local_2.member[0u];
                            let _e2043 = local_2.member[1u];
                            let _e2052 = ((((_e2032[0] * _e1944) + (_e2032[1] * _e1947)) + (_e2032[2] * _e1950)) + (((_e2043[0] * _e1993) + (_e2043[1] * _e1994)) + (_e2043[2] * _e1995)));
                            let _e2055 = local_2.member[1u];
                            let _e2066 = local_2.member[0u];
                            if (_e2066[0] < 0f) {
                                phi_3879_ = -(_e2066[0]);
                            } else {
                                phi_3879_ = _e2066[0];
                            }
                            let _e2073 = phi_3879_;
                            if (_e2066[1] < 0f) {
                                phi_3886_ = -(_e2066[1]);
                            } else {
                                phi_3886_ = _e2066[1];
                            }
                            let _e2077 = phi_3886_;
                            if (_e2073 > _e2077) {
                                phi_3891_ = _e2073;
                            } else {
                                phi_3891_ = _e2077;
                            }
                            let _e2080 = phi_3891_;
                            if (_e2066[2] < 0f) {
                                phi_3898_ = -(_e2066[2]);
                            } else {
                                phi_3898_ = _e2066[2];
                            }
                            let _e2084 = phi_3898_;
                            if (_e2080 > _e2084) {
                                phi_3903_ = _e2080;
                            } else {
                                phi_3903_ = _e2084;
                            }
                            let _e2087 = phi_3903_;
                            let _e2090 = local_2.member[1u];
                            if (_e2090[0] < 0f) {
                                phi_3916_ = -(_e2090[0]);
                            } else {
                                phi_3916_ = _e2090[0];
                            }
                            let _e2097 = phi_3916_;
                            if (_e2090[1] < 0f) {
                                phi_3923_ = -(_e2090[1]);
                            } else {
                                phi_3923_ = _e2090[1];
                            }
                            let _e2101 = phi_3923_;
                            if (_e2097 > _e2101) {
                                phi_3928_ = _e2097;
                            } else {
                                phi_3928_ = _e2101;
                            }
                            let _e2104 = phi_3928_;
                            if (_e2090[2] < 0f) {
                                phi_3935_ = -(_e2090[2]);
                            } else {
                                phi_3935_ = _e2090[2];
                            }
                            let _e2108 = phi_3935_;
                            if (_e2104 > _e2108) {
                                phi_3940_ = _e2104;
                            } else {
                                phi_3940_ = _e2108;
                            }
                            let _e2111 = phi_3940_;
                            if (_e2087 > _e2111) {
                                phi_3945_ = _e2087;
                            } else {
                                phi_3945_ = _e2111;
                            }
                            let _e2114 = phi_3945_;
                            let _e2116 = local_2.member_3;
                            let _e2117 = (_e2114 + _e2116);
                            let _e2120 = local_2.member_1[0u];
                            if (_e2120[0] < 0f) {
                                phi_3962_ = -(_e2120[0]);
                            } else {
                                phi_3962_ = _e2120[0];
                            }
                            let _e2127 = phi_3962_;
                            if (_e2120[1] < 0f) {
                                phi_3969_ = -(_e2120[1]);
                            } else {
                                phi_3969_ = _e2120[1];
                            }
                            let _e2131 = phi_3969_;
                            if (_e2127 > _e2131) {
                                phi_3974_ = _e2127;
                            } else {
                                phi_3974_ = _e2131;
                            }
                            let _e2134 = phi_3974_;
                            if (_e2120[2] < 0f) {
                                phi_3981_ = -(_e2120[2]);
                            } else {
                                phi_3981_ = _e2120[2];
                            }
                            let _e2138 = phi_3981_;
                            if (_e2134 > _e2138) {
                                phi_3986_ = _e2134;
                            } else {
                                phi_3986_ = _e2138;
                            }
                            let _e2141 = phi_3986_;
                            let _e2144 = local_2.member_1[1u];
                            if (_e2144[0] < 0f) {
                                phi_4000_ = -(_e2144[0]);
                            } else {
                                phi_4000_ = _e2144[0];
                            }
                            let _e2151 = phi_4000_;
                            if (_e2144[1] < 0f) {
                                phi_4007_ = -(_e2144[1]);
                            } else {
                                phi_4007_ = _e2144[1];
                            }
                            let _e2155 = phi_4007_;
                            if (_e2151 > _e2155) {
                                phi_4012_ = _e2151;
                            } else {
                                phi_4012_ = _e2155;
                            }
                            let _e2158 = phi_4012_;
                            if (_e2144[2] < 0f) {
                                phi_4019_ = -(_e2144[2]);
                            } else {
                                phi_4019_ = _e2144[2];
                            }
                            let _e2162 = phi_4019_;
                            if (_e2158 > _e2162) {
                                phi_4024_ = _e2158;
                            } else {
                                phi_4024_ = _e2162;
                            }
                            let _e2165 = phi_4024_;
                            if (_e2141 > _e2165) {
                                phi_4029_ = _e2141;
                            } else {
                                phi_4029_ = _e2165;
                            }
                            let _e2168 = phi_4029_;
                            let _e2170 = local_2.member_3;
                            let _e2171 = (_e2168 + _e2170);
                            let _e2174 = local_2.member_2[0u];
                            if (_e2174[0] < 0f) {
                                phi_4046_ = -(_e2174[0]);
                            } else {
                                phi_4046_ = _e2174[0];
                            }
                            let _e2181 = phi_4046_;
                            if (_e2174[1] < 0f) {
                                phi_4053_ = -(_e2174[1]);
                            } else {
                                phi_4053_ = _e2174[1];
                            }
                            let _e2185 = phi_4053_;
                            if (_e2181 > _e2185) {
                                phi_4058_ = _e2181;
                            } else {
                                phi_4058_ = _e2185;
                            }
                            let _e2188 = phi_4058_;
                            if (_e2174[2] < 0f) {
                                phi_4065_ = -(_e2174[2]);
                            } else {
                                phi_4065_ = _e2174[2];
                            }
                            let _e2192 = phi_4065_;
                            if (_e2188 > _e2192) {
                                phi_4070_ = _e2188;
                            } else {
                                phi_4070_ = _e2192;
                            }
                            let _e2195 = phi_4070_;
                            let _e2198 = local_2.member_2[1u];
                            if (_e2198[0] < 0f) {
                                phi_4084_ = -(_e2198[0]);
                            } else {
                                phi_4084_ = _e2198[0];
                            }
                            let _e2205 = phi_4084_;
                            if (_e2198[1] < 0f) {
                                phi_4091_ = -(_e2198[1]);
                            } else {
                                phi_4091_ = _e2198[1];
                            }
                            let _e2209 = phi_4091_;
                            if (_e2205 > _e2209) {
                                phi_4096_ = _e2205;
                            } else {
                                phi_4096_ = _e2209;
                            }
                            let _e2212 = phi_4096_;
                            if (_e2198[2] < 0f) {
                                phi_4103_ = -(_e2198[2]);
                            } else {
                                phi_4103_ = _e2198[2];
                            }
                            let _e2216 = phi_4103_;
                            if (_e2212 > _e2216) {
                                phi_4108_ = _e2212;
                            } else {
                                phi_4108_ = _e2216;
                            }
                            let _e2219 = phi_4108_;
                            if (_e2195 > _e2219) {
                                phi_4113_ = _e2195;
                            } else {
                                phi_4113_ = _e2219;
                            }
                            let _e2222 = phi_4113_;
                            let _e2224 = local_2.member_3;
                            let _e2225 = (_e2222 + _e2224);
                            let _e2227 = ((_e2171 * 8f) * _e2225);
                            let _e2234 = local_2.member_3;
                            if (_e1923 < 0f) {
                                phi_4144_ = -(_e1923);
                            } else {
                                phi_4144_ = _e1923;
                            }
                            let _e2251 = phi_4144_;
                            if (_e1926 < 0f) {
                                phi_4150_ = -(_e1926);
                            } else {
                                phi_4150_ = _e1926;
                            }
                            let _e2255 = phi_4150_;
                            if (_e1929 < 0f) {
                                phi_4157_ = -(_e1929);
                            } else {
                                phi_4157_ = _e1929;
                            }
                            let _e2260 = phi_4157_;
                            let _e2261 = ((_e2251 + _e2255) + _e2260);
                            if (_e1944 < 0f) {
                                phi_4164_ = -(_e1944);
                            } else {
                                phi_4164_ = _e1944;
                            }
                            let _e2265 = phi_4164_;
                            if (_e1947 < 0f) {
                                phi_4170_ = -(_e1947);
                            } else {
                                phi_4170_ = _e1947;
                            }
                            let _e2269 = phi_4170_;
                            if (_e1950 < 0f) {
                                phi_4177_ = -(_e1950);
                            } else {
                                phi_4177_ = _e1950;
                            }
                            let _e2274 = phi_4177_;
                            let _e2275 = ((_e2265 + _e2269) + _e2274);
                            if (_e2261 > _e2275) {
                                phi_4183_ = _e2261;
                            } else {
                                phi_4183_ = _e2275;
                            }
                            let _e2278 = phi_4183_;
                            if (_e1993 < 0f) {
                                phi_4189_ = -(_e1993);
                            } else {
                                phi_4189_ = _e1993;
                            }
                            let _e2282 = phi_4189_;
                            if (_e1994 < 0f) {
                                phi_4195_ = -(_e1994);
                            } else {
                                phi_4195_ = _e1994;
                            }
                            let _e2286 = phi_4195_;
                            if (_e1995 < 0f) {
                                phi_4202_ = -(_e1995);
                            } else {
                                phi_4202_ = _e1995;
                            }
                            let _e2291 = phi_4202_;
                            let _e2293 = (((_e2282 + _e2286) + _e2291) * 0.5f);
                            if (_e2278 > _e2293) {
                                phi_4209_ = _e2278;
                            } else {
                                phi_4209_ = _e2293;
                            }
                            let _e2296 = phi_4209_;
                            let _e2301 = local_2.member_3;
                            let _e2314 = ((((_e1998[0] * _e1923) + (_e1998[1] * _e1926)) + (_e1998[2] * _e1929)) * 3f);
                            let _e2315 = ((((_e2055[0] * _e1944) + (_e2055[1] * _e1947)) + (_e2055[2] * _e1950)) * 3f);
                            if (_e2314 < _e2315) {
                                phi_4233_ = _e2314;
                            } else {
                                phi_4233_ = _e2315;
                            }
                            let _e2318 = phi_4233_;
                            if (_e2029 < _e2052) {
                                phi_4238_ = _e2029;
                            } else {
                                phi_4238_ = _e2052;
                            }
                            let _e2321 = phi_4238_;
                            if (_e2318 < _e2321) {
                                phi_4243_ = _e2318;
                            } else {
                                phi_4243_ = _e2321;
                            }
                            let _e2324 = phi_4243_;
                            if (_e2314 > _e2315) {
                                phi_4248_ = _e2314;
                            } else {
                                phi_4248_ = _e2315;
                            }
                            let _e2327 = phi_4248_;
                            if (_e2029 > _e2052) {
                                phi_4253_ = _e2029;
                            } else {
                                phi_4253_ = _e2052;
                            }
                            let _e2330 = phi_4253_;
                            if (_e2327 > _e2330) {
                                phi_4258_ = _e2327;
                            } else {
                                phi_4258_ = _e2330;
                            }
                            let _e2333 = phi_4258_;
                            let _e2338 = -(_e2333);
                            if (_e2324 > _e2338) {
                                phi_4268_ = _e2324;
                            } else {
                                phi_4268_ = _e2338;
                            }
                            let _e2341 = phi_4268_;
                            let _e2343 = ((_e2341 - ((((((_e2117 * 8f) * _e2227) * (0.000000059604645f * (524f / 64f))) + ((_e2234 * 19f) * ((_e2117 * (_e2171 + _e2225)) + (_e2171 * _e2225)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2117) * ((1f + _e2171) * (1f + _e2225))))) + ((_e1839 * (((_e2296 + (_e2227 * (0.000000059604645f * 8f))) + ((_e2301 * 6f) * (_e2171 + _e2225))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2171) * (1f + _e2225))))) * (3f * 1.0001f)))) > 0f);
                            if _e2343 {
                                phi_5237_ = _e2343;
                            } else {
                                let _e2346 = local_2.member_1[0u];
                                let _e2352 = local_2.member_1[1u];
                                let _e2356 = (_e2346[0] + _e2352[0]);
                                let _e2357 = (_e2346[1] + _e2352[1]);
                                let _e2358 = (_e2346[2] + _e2352[2]);
                                let _e2361 = local_2.member_2[0u];
                                let _e2367 = local_2.member_2[1u];
                                let _e2371 = (_e2361[0] + _e2367[0]);
                                let _e2372 = (_e2361[1] + _e2367[1]);
                                let _e2373 = (_e2361[2] + _e2367[2]);
                                let _e2376 = ((_e2357 * _e2373) - (_e2358 * _e2372));
                                let _e2379 = ((_e2358 * _e2371) - (_e2356 * _e2373));
                                let _e2382 = ((_e2356 * _e2372) - (_e2357 * _e2371));
                                let _e2385 = local_2.member[0u];
                                let _e2391 = local_2.member_1[0u];
                                let _e2397 = local_2.member_2[0u];
                                let _e2401 = (_e2385[0] - _e2391[0]);
                                let _e2402 = (_e2385[1] - _e2391[1]);
                                let _e2403 = (_e2385[2] - _e2391[2]);
                                let _e2404 = (_e2385[0] - _e2397[0]);
                                let _e2405 = (_e2385[1] - _e2397[1]);
                                let _e2406 = (_e2385[2] - _e2397[2]);
                                let _e2409 = local_2.member[1u];
                                let _e2415 = local_2.member_1[1u];
                                let _e2421 = local_2.member_2[1u];
                                let _e2425 = (_e2409[0] - _e2415[0]);
                                let _e2426 = (_e2409[1] - _e2415[1]);
                                let _e2427 = (_e2409[2] - _e2415[2]);
                                let _e2428 = (_e2409[0] - _e2421[0]);
                                let _e2429 = (_e2409[1] - _e2421[1]);
                                let _e2430 = (_e2409[2] - _e2421[2]);
                                let _e2433 = local_2.member[0u];
                                if (_e2433[0] < 0f) {
                                    phi_4471_ = -(_e2433[0]);
                                } else {
                                    phi_4471_ = _e2433[0];
                                }
                                let _e2440 = phi_4471_;
                                if (_e2433[1] < 0f) {
                                    phi_4478_ = -(_e2433[1]);
                                } else {
                                    phi_4478_ = _e2433[1];
                                }
                                let _e2444 = phi_4478_;
                                if (_e2440 > _e2444) {
                                    phi_4483_ = _e2440;
                                } else {
                                    phi_4483_ = _e2444;
                                }
                                let _e2447 = phi_4483_;
                                if (_e2433[2] < 0f) {
                                    phi_4490_ = -(_e2433[2]);
                                } else {
                                    phi_4490_ = _e2433[2];
                                }
                                let _e2451 = phi_4490_;
                                if (_e2447 > _e2451) {
                                    phi_4495_ = _e2447;
                                } else {
                                    phi_4495_ = _e2451;
                                }
                                let _e2454 = phi_4495_;
                                let _e2457 = local_2.member[1u];
                                if (_e2457[0] < 0f) {
                                    phi_4508_ = -(_e2457[0]);
                                } else {
                                    phi_4508_ = _e2457[0];
                                }
                                let _e2464 = phi_4508_;
                                if (_e2457[1] < 0f) {
                                    phi_4515_ = -(_e2457[1]);
                                } else {
                                    phi_4515_ = _e2457[1];
                                }
                                let _e2468 = phi_4515_;
                                if (_e2464 > _e2468) {
                                    phi_4520_ = _e2464;
                                } else {
                                    phi_4520_ = _e2468;
                                }
                                let _e2471 = phi_4520_;
                                if (_e2457[2] < 0f) {
                                    phi_4527_ = -(_e2457[2]);
                                } else {
                                    phi_4527_ = _e2457[2];
                                }
                                let _e2475 = phi_4527_;
                                if (_e2471 > _e2475) {
                                    phi_4532_ = _e2471;
                                } else {
                                    phi_4532_ = _e2475;
                                }
                                let _e2478 = phi_4532_;
                                if (_e2454 > _e2478) {
                                    phi_4537_ = _e2454;
                                } else {
                                    phi_4537_ = _e2478;
                                }
                                let _e2481 = phi_4537_;
                                let _e2483 = local_2.member_3;
                                let _e2487 = local_2.member_1[0u];
                                if (_e2487[0] < 0f) {
                                    phi_4554_ = -(_e2487[0]);
                                } else {
                                    phi_4554_ = _e2487[0];
                                }
                                let _e2494 = phi_4554_;
                                if (_e2487[1] < 0f) {
                                    phi_4561_ = -(_e2487[1]);
                                } else {
                                    phi_4561_ = _e2487[1];
                                }
                                let _e2498 = phi_4561_;
                                if (_e2494 > _e2498) {
                                    phi_4566_ = _e2494;
                                } else {
                                    phi_4566_ = _e2498;
                                }
                                let _e2501 = phi_4566_;
                                if (_e2487[2] < 0f) {
                                    phi_4573_ = -(_e2487[2]);
                                } else {
                                    phi_4573_ = _e2487[2];
                                }
                                let _e2505 = phi_4573_;
                                if (_e2501 > _e2505) {
                                    phi_4578_ = _e2501;
                                } else {
                                    phi_4578_ = _e2505;
                                }
                                let _e2508 = phi_4578_;
                                let _e2511 = local_2.member_1[1u];
                                if (_e2511[0] < 0f) {
                                    phi_4592_ = -(_e2511[0]);
                                } else {
                                    phi_4592_ = _e2511[0];
                                }
                                let _e2518 = phi_4592_;
                                if (_e2511[1] < 0f) {
                                    phi_4599_ = -(_e2511[1]);
                                } else {
                                    phi_4599_ = _e2511[1];
                                }
                                let _e2522 = phi_4599_;
                                if (_e2518 > _e2522) {
                                    phi_4604_ = _e2518;
                                } else {
                                    phi_4604_ = _e2522;
                                }
                                let _e2525 = phi_4604_;
                                if (_e2511[2] < 0f) {
                                    phi_4611_ = -(_e2511[2]);
                                } else {
                                    phi_4611_ = _e2511[2];
                                }
                                let _e2529 = phi_4611_;
                                if (_e2525 > _e2529) {
                                    phi_4616_ = _e2525;
                                } else {
                                    phi_4616_ = _e2529;
                                }
                                let _e2532 = phi_4616_;
                                if (_e2508 > _e2532) {
                                    phi_4621_ = _e2508;
                                } else {
                                    phi_4621_ = _e2532;
                                }
                                let _e2535 = phi_4621_;
                                let _e2537 = local_2.member_3;
                                let _e2541 = local_2.member_2[0u];
                                if (_e2541[0] < 0f) {
                                    phi_4638_ = -(_e2541[0]);
                                } else {
                                    phi_4638_ = _e2541[0];
                                }
                                let _e2548 = phi_4638_;
                                if (_e2541[1] < 0f) {
                                    phi_4645_ = -(_e2541[1]);
                                } else {
                                    phi_4645_ = _e2541[1];
                                }
                                let _e2552 = phi_4645_;
                                if (_e2548 > _e2552) {
                                    phi_4650_ = _e2548;
                                } else {
                                    phi_4650_ = _e2552;
                                }
                                let _e2555 = phi_4650_;
                                if (_e2541[2] < 0f) {
                                    phi_4657_ = -(_e2541[2]);
                                } else {
                                    phi_4657_ = _e2541[2];
                                }
                                let _e2559 = phi_4657_;
                                if (_e2555 > _e2559) {
                                    phi_4662_ = _e2555;
                                } else {
                                    phi_4662_ = _e2559;
                                }
                                let _e2562 = phi_4662_;
                                let _e2565 = local_2.member_2[1u];
                                if (_e2565[0] < 0f) {
                                    phi_4676_ = -(_e2565[0]);
                                } else {
                                    phi_4676_ = _e2565[0];
                                }
                                let _e2572 = phi_4676_;
                                if (_e2565[1] < 0f) {
                                    phi_4683_ = -(_e2565[1]);
                                } else {
                                    phi_4683_ = _e2565[1];
                                }
                                let _e2576 = phi_4683_;
                                if (_e2572 > _e2576) {
                                    phi_4688_ = _e2572;
                                } else {
                                    phi_4688_ = _e2576;
                                }
                                let _e2579 = phi_4688_;
                                if (_e2565[2] < 0f) {
                                    phi_4695_ = -(_e2565[2]);
                                } else {
                                    phi_4695_ = _e2565[2];
                                }
                                let _e2583 = phi_4695_;
                                if (_e2579 > _e2583) {
                                    phi_4700_ = _e2579;
                                } else {
                                    phi_4700_ = _e2583;
                                }
                                let _e2586 = phi_4700_;
                                if (_e2562 > _e2586) {
                                    phi_4705_ = _e2562;
                                } else {
                                    phi_4705_ = _e2586;
                                }
                                let _e2589 = phi_4705_;
                                let _e2591 = local_2.member_3;
                                let _e2595 = ((((_e2481 + _e2483) + (_e2535 + _e2537)) + (_e2589 + _e2591)) * 2f);
                                let _e2598 = local_2.member_3;
                                let _e2602 = (((_e1839 * 1.0001f) + (_e2598 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2605 = ((_e2379 * _e2358) - (_e2382 * _e2357));
                                let _e2608 = ((_e2382 * _e2356) - (_e2376 * _e2358));
                                let _e2611 = ((_e2376 * _e2357) - (_e2379 * _e2356));
                                let _e2616 = (((_e2605 * _e2385[0]) + (_e2608 * _e2385[1])) + (_e2611 * _e2385[2]));
                                let _e2621 = (((_e2605 * _e2401) + (_e2608 * _e2402)) + (_e2611 * _e2403));
                                let _e2626 = (((_e2605 * _e2404) + (_e2608 * _e2405)) + (_e2611 * _e2406));
                                let _e2631 = (((_e2605 * _e2385[0]) + (_e2608 * _e2385[1])) + (_e2611 * _e2385[2]));
                                let _e2636 = (((_e2605 * _e2409[0]) + (_e2608 * _e2409[1])) + (_e2611 * _e2409[2]));
                                let _e2641 = (((_e2605 * _e2425) + (_e2608 * _e2426)) + (_e2611 * _e2427));
                                let _e2646 = (((_e2605 * _e2428) + (_e2608 * _e2429)) + (_e2611 * _e2430));
                                let _e2651 = (((_e2605 * _e2409[0]) + (_e2608 * _e2409[1])) + (_e2611 * _e2409[2]));
                                if (_e2616 < _e2621) {
                                    phi_4784_ = _e2616;
                                } else {
                                    phi_4784_ = _e2621;
                                }
                                let _e2654 = phi_4784_;
                                if (_e2626 < _e2631) {
                                    phi_4789_ = _e2626;
                                } else {
                                    phi_4789_ = _e2631;
                                }
                                let _e2657 = phi_4789_;
                                if (_e2654 < _e2657) {
                                    phi_4794_ = _e2654;
                                } else {
                                    phi_4794_ = _e2657;
                                }
                                let _e2660 = phi_4794_;
                                if (_e2636 < _e2641) {
                                    phi_4799_ = _e2636;
                                } else {
                                    phi_4799_ = _e2641;
                                }
                                let _e2663 = phi_4799_;
                                if (_e2646 < _e2651) {
                                    phi_4804_ = _e2646;
                                } else {
                                    phi_4804_ = _e2651;
                                }
                                let _e2666 = phi_4804_;
                                if (_e2663 < _e2666) {
                                    phi_4809_ = _e2663;
                                } else {
                                    phi_4809_ = _e2666;
                                }
                                let _e2669 = phi_4809_;
                                if (_e2660 < _e2669) {
                                    phi_4814_ = _e2660;
                                } else {
                                    phi_4814_ = _e2669;
                                }
                                let _e2672 = phi_4814_;
                                if (_e2616 > _e2621) {
                                    phi_4819_ = _e2616;
                                } else {
                                    phi_4819_ = _e2621;
                                }
                                let _e2675 = phi_4819_;
                                if (_e2626 > _e2631) {
                                    phi_4824_ = _e2626;
                                } else {
                                    phi_4824_ = _e2631;
                                }
                                let _e2678 = phi_4824_;
                                if (_e2675 > _e2678) {
                                    phi_4829_ = _e2675;
                                } else {
                                    phi_4829_ = _e2678;
                                }
                                let _e2681 = phi_4829_;
                                if (_e2636 > _e2641) {
                                    phi_4834_ = _e2636;
                                } else {
                                    phi_4834_ = _e2641;
                                }
                                let _e2684 = phi_4834_;
                                if (_e2646 > _e2651) {
                                    phi_4839_ = _e2646;
                                } else {
                                    phi_4839_ = _e2651;
                                }
                                let _e2687 = phi_4839_;
                                if (_e2684 > _e2687) {
                                    phi_4844_ = _e2684;
                                } else {
                                    phi_4844_ = _e2687;
                                }
                                let _e2690 = phi_4844_;
                                if (_e2681 > _e2690) {
                                    phi_4849_ = _e2681;
                                } else {
                                    phi_4849_ = _e2690;
                                }
                                let _e2693 = phi_4849_;
                                if (_e2605 < 0f) {
                                    phi_4855_ = -(_e2605);
                                } else {
                                    phi_4855_ = _e2605;
                                }
                                let _e2697 = phi_4855_;
                                if (_e2608 < 0f) {
                                    phi_4861_ = -(_e2608);
                                } else {
                                    phi_4861_ = _e2608;
                                }
                                let _e2701 = phi_4861_;
                                if (_e2611 < 0f) {
                                    phi_4868_ = -(_e2611);
                                } else {
                                    phi_4868_ = _e2611;
                                }
                                let _e2706 = phi_4868_;
                                let _e2707 = ((_e2697 + _e2701) + _e2706);
                                let _e2712 = -(_e2693);
                                if (_e2672 > _e2712) {
                                    phi_4879_ = _e2672;
                                } else {
                                    phi_4879_ = _e2712;
                                }
                                let _e2715 = phi_4879_;
                                let _e2720 = (((_e2715 - ((_e2707 * _e2595) * (0.000000059604645f * (17f / 2f)))) - (_e2707 * _e2602)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2723 = ((_e2379 * _e2373) - (_e2382 * _e2372));
                                let _e2726 = ((_e2382 * _e2371) - (_e2376 * _e2373));
                                let _e2729 = ((_e2376 * _e2372) - (_e2379 * _e2371));
                                let _e2734 = (((_e2723 * _e2385[0]) + (_e2726 * _e2385[1])) + (_e2729 * _e2385[2]));
                                let _e2739 = (((_e2723 * _e2401) + (_e2726 * _e2402)) + (_e2729 * _e2403));
                                let _e2744 = (((_e2723 * _e2404) + (_e2726 * _e2405)) + (_e2729 * _e2406));
                                let _e2749 = (((_e2723 * _e2385[0]) + (_e2726 * _e2385[1])) + (_e2729 * _e2385[2]));
                                let _e2754 = (((_e2723 * _e2409[0]) + (_e2726 * _e2409[1])) + (_e2729 * _e2409[2]));
                                let _e2759 = (((_e2723 * _e2425) + (_e2726 * _e2426)) + (_e2729 * _e2427));
                                let _e2764 = (((_e2723 * _e2428) + (_e2726 * _e2429)) + (_e2729 * _e2430));
                                let _e2769 = (((_e2723 * _e2409[0]) + (_e2726 * _e2409[1])) + (_e2729 * _e2409[2]));
                                if (_e2734 < _e2739) {
                                    phi_4950_ = _e2734;
                                } else {
                                    phi_4950_ = _e2739;
                                }
                                let _e2772 = phi_4950_;
                                if (_e2744 < _e2749) {
                                    phi_4955_ = _e2744;
                                } else {
                                    phi_4955_ = _e2749;
                                }
                                let _e2775 = phi_4955_;
                                if (_e2772 < _e2775) {
                                    phi_4960_ = _e2772;
                                } else {
                                    phi_4960_ = _e2775;
                                }
                                let _e2778 = phi_4960_;
                                if (_e2754 < _e2759) {
                                    phi_4965_ = _e2754;
                                } else {
                                    phi_4965_ = _e2759;
                                }
                                let _e2781 = phi_4965_;
                                if (_e2764 < _e2769) {
                                    phi_4970_ = _e2764;
                                } else {
                                    phi_4970_ = _e2769;
                                }
                                let _e2784 = phi_4970_;
                                if (_e2781 < _e2784) {
                                    phi_4975_ = _e2781;
                                } else {
                                    phi_4975_ = _e2784;
                                }
                                let _e2787 = phi_4975_;
                                if (_e2778 < _e2787) {
                                    phi_4980_ = _e2778;
                                } else {
                                    phi_4980_ = _e2787;
                                }
                                let _e2790 = phi_4980_;
                                if (_e2734 > _e2739) {
                                    phi_4985_ = _e2734;
                                } else {
                                    phi_4985_ = _e2739;
                                }
                                let _e2793 = phi_4985_;
                                if (_e2744 > _e2749) {
                                    phi_4990_ = _e2744;
                                } else {
                                    phi_4990_ = _e2749;
                                }
                                let _e2796 = phi_4990_;
                                if (_e2793 > _e2796) {
                                    phi_4995_ = _e2793;
                                } else {
                                    phi_4995_ = _e2796;
                                }
                                let _e2799 = phi_4995_;
                                if (_e2754 > _e2759) {
                                    phi_5000_ = _e2754;
                                } else {
                                    phi_5000_ = _e2759;
                                }
                                let _e2802 = phi_5000_;
                                if (_e2764 > _e2769) {
                                    phi_5005_ = _e2764;
                                } else {
                                    phi_5005_ = _e2769;
                                }
                                let _e2805 = phi_5005_;
                                if (_e2802 > _e2805) {
                                    phi_5010_ = _e2802;
                                } else {
                                    phi_5010_ = _e2805;
                                }
                                let _e2808 = phi_5010_;
                                if (_e2799 > _e2808) {
                                    phi_5015_ = _e2799;
                                } else {
                                    phi_5015_ = _e2808;
                                }
                                let _e2811 = phi_5015_;
                                if (_e2723 < 0f) {
                                    phi_5021_ = -(_e2723);
                                } else {
                                    phi_5021_ = _e2723;
                                }
                                let _e2815 = phi_5021_;
                                if (_e2726 < 0f) {
                                    phi_5027_ = -(_e2726);
                                } else {
                                    phi_5027_ = _e2726;
                                }
                                let _e2819 = phi_5027_;
                                if (_e2729 < 0f) {
                                    phi_5034_ = -(_e2729);
                                } else {
                                    phi_5034_ = _e2729;
                                }
                                let _e2824 = phi_5034_;
                                let _e2825 = ((_e2815 + _e2819) + _e2824);
                                let _e2830 = -(_e2811);
                                if (_e2790 > _e2830) {
                                    phi_5045_ = _e2790;
                                } else {
                                    phi_5045_ = _e2830;
                                }
                                let _e2833 = phi_5045_;
                                let _e2838 = (((_e2833 - ((_e2825 * _e2595) * (0.000000059604645f * (17f / 2f)))) - (_e2825 * _e2602)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2720 > _e2838) {
                                    phi_5055_ = _e2720;
                                } else {
                                    phi_5055_ = _e2838;
                                }
                                let _e2841 = phi_5055_;
                                let _e2842 = (_e2371 - _e2356);
                                let _e2843 = (_e2372 - _e2357);
                                let _e2844 = (_e2373 - _e2358);
                                let _e2847 = ((_e2379 * _e2844) - (_e2382 * _e2843));
                                let _e2850 = ((_e2382 * _e2842) - (_e2376 * _e2844));
                                let _e2853 = ((_e2376 * _e2843) - (_e2379 * _e2842));
                                let _e2858 = (((_e2847 * _e2385[0]) + (_e2850 * _e2385[1])) + (_e2853 * _e2385[2]));
                                let _e2863 = (((_e2847 * _e2401) + (_e2850 * _e2402)) + (_e2853 * _e2403));
                                let _e2868 = (((_e2847 * _e2404) + (_e2850 * _e2405)) + (_e2853 * _e2406));
                                let _e2873 = (((_e2847 * _e2385[0]) + (_e2850 * _e2385[1])) + (_e2853 * _e2385[2]));
                                let _e2878 = (((_e2847 * _e2409[0]) + (_e2850 * _e2409[1])) + (_e2853 * _e2409[2]));
                                let _e2883 = (((_e2847 * _e2425) + (_e2850 * _e2426)) + (_e2853 * _e2427));
                                let _e2888 = (((_e2847 * _e2428) + (_e2850 * _e2429)) + (_e2853 * _e2430));
                                let _e2893 = (((_e2847 * _e2409[0]) + (_e2850 * _e2409[1])) + (_e2853 * _e2409[2]));
                                if (_e2858 < _e2863) {
                                    phi_5128_ = _e2858;
                                } else {
                                    phi_5128_ = _e2863;
                                }
                                let _e2896 = phi_5128_;
                                if (_e2868 < _e2873) {
                                    phi_5133_ = _e2868;
                                } else {
                                    phi_5133_ = _e2873;
                                }
                                let _e2899 = phi_5133_;
                                if (_e2896 < _e2899) {
                                    phi_5138_ = _e2896;
                                } else {
                                    phi_5138_ = _e2899;
                                }
                                let _e2902 = phi_5138_;
                                if (_e2878 < _e2883) {
                                    phi_5143_ = _e2878;
                                } else {
                                    phi_5143_ = _e2883;
                                }
                                let _e2905 = phi_5143_;
                                if (_e2888 < _e2893) {
                                    phi_5148_ = _e2888;
                                } else {
                                    phi_5148_ = _e2893;
                                }
                                let _e2908 = phi_5148_;
                                if (_e2905 < _e2908) {
                                    phi_5153_ = _e2905;
                                } else {
                                    phi_5153_ = _e2908;
                                }
                                let _e2911 = phi_5153_;
                                if (_e2902 < _e2911) {
                                    phi_5158_ = _e2902;
                                } else {
                                    phi_5158_ = _e2911;
                                }
                                let _e2914 = phi_5158_;
                                if (_e2858 > _e2863) {
                                    phi_5163_ = _e2858;
                                } else {
                                    phi_5163_ = _e2863;
                                }
                                let _e2917 = phi_5163_;
                                if (_e2868 > _e2873) {
                                    phi_5168_ = _e2868;
                                } else {
                                    phi_5168_ = _e2873;
                                }
                                let _e2920 = phi_5168_;
                                if (_e2917 > _e2920) {
                                    phi_5173_ = _e2917;
                                } else {
                                    phi_5173_ = _e2920;
                                }
                                let _e2923 = phi_5173_;
                                if (_e2878 > _e2883) {
                                    phi_5178_ = _e2878;
                                } else {
                                    phi_5178_ = _e2883;
                                }
                                let _e2926 = phi_5178_;
                                if (_e2888 > _e2893) {
                                    phi_5183_ = _e2888;
                                } else {
                                    phi_5183_ = _e2893;
                                }
                                let _e2929 = phi_5183_;
                                if (_e2926 > _e2929) {
                                    phi_5188_ = _e2926;
                                } else {
                                    phi_5188_ = _e2929;
                                }
                                let _e2932 = phi_5188_;
                                if (_e2923 > _e2932) {
                                    phi_5193_ = _e2923;
                                } else {
                                    phi_5193_ = _e2932;
                                }
                                let _e2935 = phi_5193_;
                                if (_e2847 < 0f) {
                                    phi_5199_ = -(_e2847);
                                } else {
                                    phi_5199_ = _e2847;
                                }
                                let _e2939 = phi_5199_;
                                if (_e2850 < 0f) {
                                    phi_5205_ = -(_e2850);
                                } else {
                                    phi_5205_ = _e2850;
                                }
                                let _e2943 = phi_5205_;
                                if (_e2853 < 0f) {
                                    phi_5212_ = -(_e2853);
                                } else {
                                    phi_5212_ = _e2853;
                                }
                                let _e2948 = phi_5212_;
                                let _e2949 = ((_e2939 + _e2943) + _e2948);
                                let _e2954 = -(_e2935);
                                if (_e2914 > _e2954) {
                                    phi_5223_ = _e2914;
                                } else {
                                    phi_5223_ = _e2954;
                                }
                                let _e2957 = phi_5223_;
                                let _e2962 = (((_e2957 - ((_e2949 * _e2595) * (0.000000059604645f * (17f / 2f)))) - (_e2949 * _e2602)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2841 > _e2962) {
                                    phi_5233_ = _e2841;
                                } else {
                                    phi_5233_ = _e2962;
                                }
                                let _e2965 = phi_5233_;
                                phi_5237_ = (_e2343 || (_e2965 > 0f));
                            }
                            let _e2969 = phi_5237_;
                            if _e2969 {
                                phi_8654_ = _e2969;
                            } else {
                                let _e2972 = local_2.member[0u];
                                let _e2978 = local_2.member[1u];
                                let _e2985 = ((_e2972[0] + _e2978[0]) * 0.5f);
                                let _e2986 = ((_e2972[1] + _e2978[1]) * 0.5f);
                                let _e2987 = ((_e2972[2] + _e2978[2]) * 0.5f);
                                let _e2990 = local_2.member_1[0u];
                                let _e2996 = local_2.member_1[1u];
                                let _e3003 = ((_e2990[0] + _e2996[0]) * 0.5f);
                                let _e3004 = ((_e2990[1] + _e2996[1]) * 0.5f);
                                let _e3005 = ((_e2990[2] + _e2996[2]) * 0.5f);
                                let _e3008 = local_2.member_2[0u];
                                let _e3014 = local_2.member_2[1u];
                                let _e3021 = ((_e3008[0] + _e3014[0]) * 0.5f);
                                let _e3022 = ((_e3008[1] + _e3014[1]) * 0.5f);
                                let _e3023 = ((_e3008[2] + _e3014[2]) * 0.5f);
                                let _e3026 = local_2.member[0u];
                                let _e3029 = local_2.member_1[0u];
                                let _e3032 = local_2.member_2[0u];
                                let _e3034 = local_2.member_3;
                                let _e3037 = local_2.member[1u];
                                let _e3040 = local_2.member_1[1u];
                                let _e3043 = local_2.member_2[1u];
                                let _e3045 = local_2.member_3;
                                local = type_41(array<array<f32, 3>, 2>(_e3026, array<f32, 3>(_e2985, _e2986, _e2987)), array<array<f32, 3>, 2>(_e3029, array<f32, 3>(_e3003, _e3004, _e3005)), array<array<f32, 3>, 2>(_e3032, array<f32, 3>(_e3021, _e3022, _e3023)), _e3034);
                                local_1 = type_41(array<array<f32, 3>, 2>(array<f32, 3>(_e2985, _e2986, _e2987), _e3037), array<array<f32, 3>, 2>(array<f32, 3>(_e3003, _e3004, _e3005), _e3040), array<array<f32, 3>, 2>(array<f32, 3>(_e3021, _e3022, _e3023), _e3043), _e3045);
                                let _e3062 = local.member_1[0u];
                                let _e3068 = local.member_2[0u];
                                let _e3074 = ((_e3062[1] * _e3068[2]) - (_e3062[2] * _e3068[1]));
                                let _e3077 = ((_e3062[2] * _e3068[0]) - (_e3062[0] * _e3068[2]));
                                let _e3080 = ((_e3062[0] * _e3068[1]) - (_e3062[1] * _e3068[0]));
                                let _e3083 = local.member_1[1u];
                                let _e3089 = local.member_2[1u];
                                let _e3095 = ((_e3083[1] * _e3089[2]) - (_e3083[2] * _e3089[1]));
                                let _e3098 = ((_e3083[2] * _e3089[0]) - (_e3083[0] * _e3089[2]));
                                let _e3101 = ((_e3083[0] * _e3089[1]) - (_e3083[1] * _e3089[0]));
                                let _e3104 = local.member_1[0u];
                                let _e3110 = local.member_2[1u];
                                let _e3125 = local.member_1[1u];
                                let _e3131 = local.member_2[0u];
                                let _e3144 = (((_e3104[1] * _e3110[2]) - (_e3104[2] * _e3110[1])) + ((_e3125[1] * _e3131[2]) - (_e3125[2] * _e3131[1])));
                                let _e3145 = (((_e3104[2] * _e3110[0]) - (_e3104[0] * _e3110[2])) + ((_e3125[2] * _e3131[0]) - (_e3125[0] * _e3131[2])));
                                let _e3146 = (((_e3104[0] * _e3110[1]) - (_e3104[1] * _e3110[0])) + ((_e3125[0] * _e3131[1]) - (_e3125[1] * _e3131[0])));
                                let _e3149 = local.member[0u];
                                let _e3160 = local.member[1u];
                                let _e3171 = local.member[0u];
                                let _e3180 = ((((_e3160[0] * _e3074) + (_e3160[1] * _e3077)) + (_e3160[2] * _e3080)) + (((_e3171[0] * _e3144) + (_e3171[1] * _e3145)) + (_e3171[2] * _e3146)));
                                let _e3183 = local.member[0u];
                                let _e3194 = local.member[1u];
                                let _e3203 = ((((_e3183[0] * _e3095) + (_e3183[1] * _e3098)) + (_e3183[2] * _e3101)) + (((_e3194[0] * _e3144) + (_e3194[1] * _e3145)) + (_e3194[2] * _e3146)));
                                let _e3206 = local.member[1u];
                                let _e3217 = local.member[0u];
                                if (_e3217[0] < 0f) {
                                    phi_5689_ = -(_e3217[0]);
                                } else {
                                    phi_5689_ = _e3217[0];
                                }
                                let _e3224 = phi_5689_;
                                if (_e3217[1] < 0f) {
                                    phi_5696_ = -(_e3217[1]);
                                } else {
                                    phi_5696_ = _e3217[1];
                                }
                                let _e3228 = phi_5696_;
                                if (_e3224 > _e3228) {
                                    phi_5701_ = _e3224;
                                } else {
                                    phi_5701_ = _e3228;
                                }
                                let _e3231 = phi_5701_;
                                if (_e3217[2] < 0f) {
                                    phi_5708_ = -(_e3217[2]);
                                } else {
                                    phi_5708_ = _e3217[2];
                                }
                                let _e3235 = phi_5708_;
                                if (_e3231 > _e3235) {
                                    phi_5713_ = _e3231;
                                } else {
                                    phi_5713_ = _e3235;
                                }
                                let _e3238 = phi_5713_;
                                let _e3241 = local.member[1u];
                                if (_e3241[0] < 0f) {
                                    phi_5726_ = -(_e3241[0]);
                                } else {
                                    phi_5726_ = _e3241[0];
                                }
                                let _e3248 = phi_5726_;
                                if (_e3241[1] < 0f) {
                                    phi_5733_ = -(_e3241[1]);
                                } else {
                                    phi_5733_ = _e3241[1];
                                }
                                let _e3252 = phi_5733_;
                                if (_e3248 > _e3252) {
                                    phi_5738_ = _e3248;
                                } else {
                                    phi_5738_ = _e3252;
                                }
                                let _e3255 = phi_5738_;
                                if (_e3241[2] < 0f) {
                                    phi_5745_ = -(_e3241[2]);
                                } else {
                                    phi_5745_ = _e3241[2];
                                }
                                let _e3259 = phi_5745_;
                                if (_e3255 > _e3259) {
                                    phi_5750_ = _e3255;
                                } else {
                                    phi_5750_ = _e3259;
                                }
                                let _e3262 = phi_5750_;
                                if (_e3238 > _e3262) {
                                    phi_5755_ = _e3238;
                                } else {
                                    phi_5755_ = _e3262;
                                }
                                let _e3265 = phi_5755_;
                                let _e3267 = local.member_3;
                                let _e3268 = (_e3265 + _e3267);
                                let _e3271 = local.member_1[0u];
                                if (_e3271[0] < 0f) {
                                    phi_5772_ = -(_e3271[0]);
                                } else {
                                    phi_5772_ = _e3271[0];
                                }
                                let _e3278 = phi_5772_;
                                if (_e3271[1] < 0f) {
                                    phi_5779_ = -(_e3271[1]);
                                } else {
                                    phi_5779_ = _e3271[1];
                                }
                                let _e3282 = phi_5779_;
                                if (_e3278 > _e3282) {
                                    phi_5784_ = _e3278;
                                } else {
                                    phi_5784_ = _e3282;
                                }
                                let _e3285 = phi_5784_;
                                if (_e3271[2] < 0f) {
                                    phi_5791_ = -(_e3271[2]);
                                } else {
                                    phi_5791_ = _e3271[2];
                                }
                                let _e3289 = phi_5791_;
                                if (_e3285 > _e3289) {
                                    phi_5796_ = _e3285;
                                } else {
                                    phi_5796_ = _e3289;
                                }
                                let _e3292 = phi_5796_;
                                let _e3295 = local.member_1[1u];
                                if (_e3295[0] < 0f) {
                                    phi_5810_ = -(_e3295[0]);
                                } else {
                                    phi_5810_ = _e3295[0];
                                }
                                let _e3302 = phi_5810_;
                                if (_e3295[1] < 0f) {
                                    phi_5817_ = -(_e3295[1]);
                                } else {
                                    phi_5817_ = _e3295[1];
                                }
                                let _e3306 = phi_5817_;
                                if (_e3302 > _e3306) {
                                    phi_5822_ = _e3302;
                                } else {
                                    phi_5822_ = _e3306;
                                }
                                let _e3309 = phi_5822_;
                                if (_e3295[2] < 0f) {
                                    phi_5829_ = -(_e3295[2]);
                                } else {
                                    phi_5829_ = _e3295[2];
                                }
                                let _e3313 = phi_5829_;
                                if (_e3309 > _e3313) {
                                    phi_5834_ = _e3309;
                                } else {
                                    phi_5834_ = _e3313;
                                }
                                let _e3316 = phi_5834_;
                                if (_e3292 > _e3316) {
                                    phi_5839_ = _e3292;
                                } else {
                                    phi_5839_ = _e3316;
                                }
                                let _e3319 = phi_5839_;
                                let _e3321 = local.member_3;
                                let _e3322 = (_e3319 + _e3321);
                                let _e3325 = local.member_2[0u];
                                if (_e3325[0] < 0f) {
                                    phi_5856_ = -(_e3325[0]);
                                } else {
                                    phi_5856_ = _e3325[0];
                                }
                                let _e3332 = phi_5856_;
                                if (_e3325[1] < 0f) {
                                    phi_5863_ = -(_e3325[1]);
                                } else {
                                    phi_5863_ = _e3325[1];
                                }
                                let _e3336 = phi_5863_;
                                if (_e3332 > _e3336) {
                                    phi_5868_ = _e3332;
                                } else {
                                    phi_5868_ = _e3336;
                                }
                                let _e3339 = phi_5868_;
                                if (_e3325[2] < 0f) {
                                    phi_5875_ = -(_e3325[2]);
                                } else {
                                    phi_5875_ = _e3325[2];
                                }
                                let _e3343 = phi_5875_;
                                if (_e3339 > _e3343) {
                                    phi_5880_ = _e3339;
                                } else {
                                    phi_5880_ = _e3343;
                                }
                                let _e3346 = phi_5880_;
                                let _e3349 = local.member_2[1u];
                                if (_e3349[0] < 0f) {
                                    phi_5894_ = -(_e3349[0]);
                                } else {
                                    phi_5894_ = _e3349[0];
                                }
                                let _e3356 = phi_5894_;
                                if (_e3349[1] < 0f) {
                                    phi_5901_ = -(_e3349[1]);
                                } else {
                                    phi_5901_ = _e3349[1];
                                }
                                let _e3360 = phi_5901_;
                                if (_e3356 > _e3360) {
                                    phi_5906_ = _e3356;
                                } else {
                                    phi_5906_ = _e3360;
                                }
                                let _e3363 = phi_5906_;
                                if (_e3349[2] < 0f) {
                                    phi_5913_ = -(_e3349[2]);
                                } else {
                                    phi_5913_ = _e3349[2];
                                }
                                let _e3367 = phi_5913_;
                                if (_e3363 > _e3367) {
                                    phi_5918_ = _e3363;
                                } else {
                                    phi_5918_ = _e3367;
                                }
                                let _e3370 = phi_5918_;
                                if (_e3346 > _e3370) {
                                    phi_5923_ = _e3346;
                                } else {
                                    phi_5923_ = _e3370;
                                }
                                let _e3373 = phi_5923_;
                                let _e3375 = local.member_3;
                                let _e3376 = (_e3373 + _e3375);
                                let _e3378 = ((_e3322 * 8f) * _e3376);
                                let _e3385 = local.member_3;
                                if (_e3074 < 0f) {
                                    phi_5954_ = -(_e3074);
                                } else {
                                    phi_5954_ = _e3074;
                                }
                                let _e3402 = phi_5954_;
                                if (_e3077 < 0f) {
                                    phi_5960_ = -(_e3077);
                                } else {
                                    phi_5960_ = _e3077;
                                }
                                let _e3406 = phi_5960_;
                                if (_e3080 < 0f) {
                                    phi_5967_ = -(_e3080);
                                } else {
                                    phi_5967_ = _e3080;
                                }
                                let _e3411 = phi_5967_;
                                let _e3412 = ((_e3402 + _e3406) + _e3411);
                                if (_e3095 < 0f) {
                                    phi_5974_ = -(_e3095);
                                } else {
                                    phi_5974_ = _e3095;
                                }
                                let _e3416 = phi_5974_;
                                if (_e3098 < 0f) {
                                    phi_5980_ = -(_e3098);
                                } else {
                                    phi_5980_ = _e3098;
                                }
                                let _e3420 = phi_5980_;
                                if (_e3101 < 0f) {
                                    phi_5987_ = -(_e3101);
                                } else {
                                    phi_5987_ = _e3101;
                                }
                                let _e3425 = phi_5987_;
                                let _e3426 = ((_e3416 + _e3420) + _e3425);
                                if (_e3412 > _e3426) {
                                    phi_5993_ = _e3412;
                                } else {
                                    phi_5993_ = _e3426;
                                }
                                let _e3429 = phi_5993_;
                                if (_e3144 < 0f) {
                                    phi_5999_ = -(_e3144);
                                } else {
                                    phi_5999_ = _e3144;
                                }
                                let _e3433 = phi_5999_;
                                if (_e3145 < 0f) {
                                    phi_6005_ = -(_e3145);
                                } else {
                                    phi_6005_ = _e3145;
                                }
                                let _e3437 = phi_6005_;
                                if (_e3146 < 0f) {
                                    phi_6012_ = -(_e3146);
                                } else {
                                    phi_6012_ = _e3146;
                                }
                                let _e3442 = phi_6012_;
                                let _e3444 = (((_e3433 + _e3437) + _e3442) * 0.5f);
                                if (_e3429 > _e3444) {
                                    phi_6019_ = _e3429;
                                } else {
                                    phi_6019_ = _e3444;
                                }
                                let _e3447 = phi_6019_;
                                let _e3452 = local.member_3;
                                let _e3465 = ((((_e3149[0] * _e3074) + (_e3149[1] * _e3077)) + (_e3149[2] * _e3080)) * 3f);
                                let _e3466 = ((((_e3206[0] * _e3095) + (_e3206[1] * _e3098)) + (_e3206[2] * _e3101)) * 3f);
                                if (_e3465 < _e3466) {
                                    phi_6043_ = _e3465;
                                } else {
                                    phi_6043_ = _e3466;
                                }
                                let _e3469 = phi_6043_;
                                if (_e3180 < _e3203) {
                                    phi_6048_ = _e3180;
                                } else {
                                    phi_6048_ = _e3203;
                                }
                                let _e3472 = phi_6048_;
                                if (_e3469 < _e3472) {
                                    phi_6053_ = _e3469;
                                } else {
                                    phi_6053_ = _e3472;
                                }
                                let _e3475 = phi_6053_;
                                if (_e3465 > _e3466) {
                                    phi_6058_ = _e3465;
                                } else {
                                    phi_6058_ = _e3466;
                                }
                                let _e3478 = phi_6058_;
                                if (_e3180 > _e3203) {
                                    phi_6063_ = _e3180;
                                } else {
                                    phi_6063_ = _e3203;
                                }
                                let _e3481 = phi_6063_;
                                if (_e3478 > _e3481) {
                                    phi_6068_ = _e3478;
                                } else {
                                    phi_6068_ = _e3481;
                                }
                                let _e3484 = phi_6068_;
                                let _e3489 = -(_e3484);
                                if (_e3475 > _e3489) {
                                    phi_6078_ = _e3475;
                                } else {
                                    phi_6078_ = _e3489;
                                }
                                let _e3492 = phi_6078_;
                                let _e3494 = ((_e3492 - ((((((_e3268 * 8f) * _e3378) * (0.000000059604645f * (524f / 64f))) + ((_e3385 * 19f) * ((_e3268 * (_e3322 + _e3376)) + (_e3322 * _e3376)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3268) * ((1f + _e3322) * (1f + _e3376))))) + ((_e1839 * (((_e3447 + (_e3378 * (0.000000059604645f * 8f))) + ((_e3452 * 6f) * (_e3322 + _e3376))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3322) * (1f + _e3376))))) * (3f * 1.0001f)))) > 0f);
                                if _e3494 {
                                    phi_7047_ = _e3494;
                                } else {
                                    let _e3497 = local.member_1[0u];
                                    let _e3503 = local.member_1[1u];
                                    let _e3507 = (_e3497[0] + _e3503[0]);
                                    let _e3508 = (_e3497[1] + _e3503[1]);
                                    let _e3509 = (_e3497[2] + _e3503[2]);
                                    let _e3512 = local.member_2[0u];
                                    let _e3518 = local.member_2[1u];
                                    let _e3522 = (_e3512[0] + _e3518[0]);
                                    let _e3523 = (_e3512[1] + _e3518[1]);
                                    let _e3524 = (_e3512[2] + _e3518[2]);
                                    let _e3527 = ((_e3508 * _e3524) - (_e3509 * _e3523));
                                    let _e3530 = ((_e3509 * _e3522) - (_e3507 * _e3524));
                                    let _e3533 = ((_e3507 * _e3523) - (_e3508 * _e3522));
                                    let _e3536 = local.member[0u];
                                    let _e3542 = local.member_1[0u];
                                    let _e3548 = local.member_2[0u];
                                    let _e3552 = (_e3536[0] - _e3542[0]);
                                    let _e3553 = (_e3536[1] - _e3542[1]);
                                    let _e3554 = (_e3536[2] - _e3542[2]);
                                    let _e3555 = (_e3536[0] - _e3548[0]);
                                    let _e3556 = (_e3536[1] - _e3548[1]);
                                    let _e3557 = (_e3536[2] - _e3548[2]);
                                    let _e3560 = local.member[1u];
                                    let _e3566 = local.member_1[1u];
                                    let _e3572 = local.member_2[1u];
                                    let _e3576 = (_e3560[0] - _e3566[0]);
                                    let _e3577 = (_e3560[1] - _e3566[1]);
                                    let _e3578 = (_e3560[2] - _e3566[2]);
                                    let _e3579 = (_e3560[0] - _e3572[0]);
                                    let _e3580 = (_e3560[1] - _e3572[1]);
                                    let _e3581 = (_e3560[2] - _e3572[2]);
                                    let _e3584 = local.member[0u];
                                    if (_e3584[0] < 0f) {
                                        phi_6281_ = -(_e3584[0]);
                                    } else {
                                        phi_6281_ = _e3584[0];
                                    }
                                    let _e3591 = phi_6281_;
                                    if (_e3584[1] < 0f) {
                                        phi_6288_ = -(_e3584[1]);
                                    } else {
                                        phi_6288_ = _e3584[1];
                                    }
                                    let _e3595 = phi_6288_;
                                    if (_e3591 > _e3595) {
                                        phi_6293_ = _e3591;
                                    } else {
                                        phi_6293_ = _e3595;
                                    }
                                    let _e3598 = phi_6293_;
                                    if (_e3584[2] < 0f) {
                                        phi_6300_ = -(_e3584[2]);
                                    } else {
                                        phi_6300_ = _e3584[2];
                                    }
                                    let _e3602 = phi_6300_;
                                    if (_e3598 > _e3602) {
                                        phi_6305_ = _e3598;
                                    } else {
                                        phi_6305_ = _e3602;
                                    }
                                    let _e3605 = phi_6305_;
                                    let _e3608 = local.member[1u];
                                    if (_e3608[0] < 0f) {
                                        phi_6318_ = -(_e3608[0]);
                                    } else {
                                        phi_6318_ = _e3608[0];
                                    }
                                    let _e3615 = phi_6318_;
                                    if (_e3608[1] < 0f) {
                                        phi_6325_ = -(_e3608[1]);
                                    } else {
                                        phi_6325_ = _e3608[1];
                                    }
                                    let _e3619 = phi_6325_;
                                    if (_e3615 > _e3619) {
                                        phi_6330_ = _e3615;
                                    } else {
                                        phi_6330_ = _e3619;
                                    }
                                    let _e3622 = phi_6330_;
                                    if (_e3608[2] < 0f) {
                                        phi_6337_ = -(_e3608[2]);
                                    } else {
                                        phi_6337_ = _e3608[2];
                                    }
                                    let _e3626 = phi_6337_;
                                    if (_e3622 > _e3626) {
                                        phi_6342_ = _e3622;
                                    } else {
                                        phi_6342_ = _e3626;
                                    }
                                    let _e3629 = phi_6342_;
                                    if (_e3605 > _e3629) {
                                        phi_6347_ = _e3605;
                                    } else {
                                        phi_6347_ = _e3629;
                                    }
                                    let _e3632 = phi_6347_;
                                    let _e3634 = local.member_3;
                                    let _e3638 = local.member_1[0u];
                                    if (_e3638[0] < 0f) {
                                        phi_6364_ = -(_e3638[0]);
                                    } else {
                                        phi_6364_ = _e3638[0];
                                    }
                                    let _e3645 = phi_6364_;
                                    if (_e3638[1] < 0f) {
                                        phi_6371_ = -(_e3638[1]);
                                    } else {
                                        phi_6371_ = _e3638[1];
                                    }
                                    let _e3649 = phi_6371_;
                                    if (_e3645 > _e3649) {
                                        phi_6376_ = _e3645;
                                    } else {
                                        phi_6376_ = _e3649;
                                    }
                                    let _e3652 = phi_6376_;
                                    if (_e3638[2] < 0f) {
                                        phi_6383_ = -(_e3638[2]);
                                    } else {
                                        phi_6383_ = _e3638[2];
                                    }
                                    let _e3656 = phi_6383_;
                                    if (_e3652 > _e3656) {
                                        phi_6388_ = _e3652;
                                    } else {
                                        phi_6388_ = _e3656;
                                    }
                                    let _e3659 = phi_6388_;
                                    let _e3662 = local.member_1[1u];
                                    if (_e3662[0] < 0f) {
                                        phi_6402_ = -(_e3662[0]);
                                    } else {
                                        phi_6402_ = _e3662[0];
                                    }
                                    let _e3669 = phi_6402_;
                                    if (_e3662[1] < 0f) {
                                        phi_6409_ = -(_e3662[1]);
                                    } else {
                                        phi_6409_ = _e3662[1];
                                    }
                                    let _e3673 = phi_6409_;
                                    if (_e3669 > _e3673) {
                                        phi_6414_ = _e3669;
                                    } else {
                                        phi_6414_ = _e3673;
                                    }
                                    let _e3676 = phi_6414_;
                                    if (_e3662[2] < 0f) {
                                        phi_6421_ = -(_e3662[2]);
                                    } else {
                                        phi_6421_ = _e3662[2];
                                    }
                                    let _e3680 = phi_6421_;
                                    if (_e3676 > _e3680) {
                                        phi_6426_ = _e3676;
                                    } else {
                                        phi_6426_ = _e3680;
                                    }
                                    let _e3683 = phi_6426_;
                                    if (_e3659 > _e3683) {
                                        phi_6431_ = _e3659;
                                    } else {
                                        phi_6431_ = _e3683;
                                    }
                                    let _e3686 = phi_6431_;
                                    let _e3688 = local.member_3;
                                    let _e3692 = local.member_2[0u];
                                    if (_e3692[0] < 0f) {
                                        phi_6448_ = -(_e3692[0]);
                                    } else {
                                        phi_6448_ = _e3692[0];
                                    }
                                    let _e3699 = phi_6448_;
                                    if (_e3692[1] < 0f) {
                                        phi_6455_ = -(_e3692[1]);
                                    } else {
                                        phi_6455_ = _e3692[1];
                                    }
                                    let _e3703 = phi_6455_;
                                    if (_e3699 > _e3703) {
                                        phi_6460_ = _e3699;
                                    } else {
                                        phi_6460_ = _e3703;
                                    }
                                    let _e3706 = phi_6460_;
                                    if (_e3692[2] < 0f) {
                                        phi_6467_ = -(_e3692[2]);
                                    } else {
                                        phi_6467_ = _e3692[2];
                                    }
                                    let _e3710 = phi_6467_;
                                    if (_e3706 > _e3710) {
                                        phi_6472_ = _e3706;
                                    } else {
                                        phi_6472_ = _e3710;
                                    }
                                    let _e3713 = phi_6472_;
                                    let _e3716 = local.member_2[1u];
                                    if (_e3716[0] < 0f) {
                                        phi_6486_ = -(_e3716[0]);
                                    } else {
                                        phi_6486_ = _e3716[0];
                                    }
                                    let _e3723 = phi_6486_;
                                    if (_e3716[1] < 0f) {
                                        phi_6493_ = -(_e3716[1]);
                                    } else {
                                        phi_6493_ = _e3716[1];
                                    }
                                    let _e3727 = phi_6493_;
                                    if (_e3723 > _e3727) {
                                        phi_6498_ = _e3723;
                                    } else {
                                        phi_6498_ = _e3727;
                                    }
                                    let _e3730 = phi_6498_;
                                    if (_e3716[2] < 0f) {
                                        phi_6505_ = -(_e3716[2]);
                                    } else {
                                        phi_6505_ = _e3716[2];
                                    }
                                    let _e3734 = phi_6505_;
                                    if (_e3730 > _e3734) {
                                        phi_6510_ = _e3730;
                                    } else {
                                        phi_6510_ = _e3734;
                                    }
                                    let _e3737 = phi_6510_;
                                    if (_e3713 > _e3737) {
                                        phi_6515_ = _e3713;
                                    } else {
                                        phi_6515_ = _e3737;
                                    }
                                    let _e3740 = phi_6515_;
                                    let _e3742 = local.member_3;
                                    let _e3746 = ((((_e3632 + _e3634) + (_e3686 + _e3688)) + (_e3740 + _e3742)) * 2f);
                                    let _e3749 = local.member_3;
                                    let _e3753 = (((_e1839 * 1.0001f) + (_e3749 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3756 = ((_e3530 * _e3509) - (_e3533 * _e3508));
                                    let _e3759 = ((_e3533 * _e3507) - (_e3527 * _e3509));
                                    let _e3762 = ((_e3527 * _e3508) - (_e3530 * _e3507));
                                    let _e3767 = (((_e3756 * _e3536[0]) + (_e3759 * _e3536[1])) + (_e3762 * _e3536[2]));
                                    let _e3772 = (((_e3756 * _e3552) + (_e3759 * _e3553)) + (_e3762 * _e3554));
                                    let _e3777 = (((_e3756 * _e3555) + (_e3759 * _e3556)) + (_e3762 * _e3557));
                                    let _e3782 = (((_e3756 * _e3536[0]) + (_e3759 * _e3536[1])) + (_e3762 * _e3536[2]));
                                    let _e3787 = (((_e3756 * _e3560[0]) + (_e3759 * _e3560[1])) + (_e3762 * _e3560[2]));
                                    let _e3792 = (((_e3756 * _e3576) + (_e3759 * _e3577)) + (_e3762 * _e3578));
                                    let _e3797 = (((_e3756 * _e3579) + (_e3759 * _e3580)) + (_e3762 * _e3581));
                                    let _e3802 = (((_e3756 * _e3560[0]) + (_e3759 * _e3560[1])) + (_e3762 * _e3560[2]));
                                    if (_e3767 < _e3772) {
                                        phi_6594_ = _e3767;
                                    } else {
                                        phi_6594_ = _e3772;
                                    }
                                    let _e3805 = phi_6594_;
                                    if (_e3777 < _e3782) {
                                        phi_6599_ = _e3777;
                                    } else {
                                        phi_6599_ = _e3782;
                                    }
                                    let _e3808 = phi_6599_;
                                    if (_e3805 < _e3808) {
                                        phi_6604_ = _e3805;
                                    } else {
                                        phi_6604_ = _e3808;
                                    }
                                    let _e3811 = phi_6604_;
                                    if (_e3787 < _e3792) {
                                        phi_6609_ = _e3787;
                                    } else {
                                        phi_6609_ = _e3792;
                                    }
                                    let _e3814 = phi_6609_;
                                    if (_e3797 < _e3802) {
                                        phi_6614_ = _e3797;
                                    } else {
                                        phi_6614_ = _e3802;
                                    }
                                    let _e3817 = phi_6614_;
                                    if (_e3814 < _e3817) {
                                        phi_6619_ = _e3814;
                                    } else {
                                        phi_6619_ = _e3817;
                                    }
                                    let _e3820 = phi_6619_;
                                    if (_e3811 < _e3820) {
                                        phi_6624_ = _e3811;
                                    } else {
                                        phi_6624_ = _e3820;
                                    }
                                    let _e3823 = phi_6624_;
                                    if (_e3767 > _e3772) {
                                        phi_6629_ = _e3767;
                                    } else {
                                        phi_6629_ = _e3772;
                                    }
                                    let _e3826 = phi_6629_;
                                    if (_e3777 > _e3782) {
                                        phi_6634_ = _e3777;
                                    } else {
                                        phi_6634_ = _e3782;
                                    }
                                    let _e3829 = phi_6634_;
                                    if (_e3826 > _e3829) {
                                        phi_6639_ = _e3826;
                                    } else {
                                        phi_6639_ = _e3829;
                                    }
                                    let _e3832 = phi_6639_;
                                    if (_e3787 > _e3792) {
                                        phi_6644_ = _e3787;
                                    } else {
                                        phi_6644_ = _e3792;
                                    }
                                    let _e3835 = phi_6644_;
                                    if (_e3797 > _e3802) {
                                        phi_6649_ = _e3797;
                                    } else {
                                        phi_6649_ = _e3802;
                                    }
                                    let _e3838 = phi_6649_;
                                    if (_e3835 > _e3838) {
                                        phi_6654_ = _e3835;
                                    } else {
                                        phi_6654_ = _e3838;
                                    }
                                    let _e3841 = phi_6654_;
                                    if (_e3832 > _e3841) {
                                        phi_6659_ = _e3832;
                                    } else {
                                        phi_6659_ = _e3841;
                                    }
                                    let _e3844 = phi_6659_;
                                    if (_e3756 < 0f) {
                                        phi_6665_ = -(_e3756);
                                    } else {
                                        phi_6665_ = _e3756;
                                    }
                                    let _e3848 = phi_6665_;
                                    if (_e3759 < 0f) {
                                        phi_6671_ = -(_e3759);
                                    } else {
                                        phi_6671_ = _e3759;
                                    }
                                    let _e3852 = phi_6671_;
                                    if (_e3762 < 0f) {
                                        phi_6678_ = -(_e3762);
                                    } else {
                                        phi_6678_ = _e3762;
                                    }
                                    let _e3857 = phi_6678_;
                                    let _e3858 = ((_e3848 + _e3852) + _e3857);
                                    let _e3863 = -(_e3844);
                                    if (_e3823 > _e3863) {
                                        phi_6689_ = _e3823;
                                    } else {
                                        phi_6689_ = _e3863;
                                    }
                                    let _e3866 = phi_6689_;
                                    let _e3871 = (((_e3866 - ((_e3858 * _e3746) * (0.000000059604645f * (17f / 2f)))) - (_e3858 * _e3753)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3874 = ((_e3530 * _e3524) - (_e3533 * _e3523));
                                    let _e3877 = ((_e3533 * _e3522) - (_e3527 * _e3524));
                                    let _e3880 = ((_e3527 * _e3523) - (_e3530 * _e3522));
                                    let _e3885 = (((_e3874 * _e3536[0]) + (_e3877 * _e3536[1])) + (_e3880 * _e3536[2]));
                                    let _e3890 = (((_e3874 * _e3552) + (_e3877 * _e3553)) + (_e3880 * _e3554));
                                    let _e3895 = (((_e3874 * _e3555) + (_e3877 * _e3556)) + (_e3880 * _e3557));
                                    let _e3900 = (((_e3874 * _e3536[0]) + (_e3877 * _e3536[1])) + (_e3880 * _e3536[2]));
                                    let _e3905 = (((_e3874 * _e3560[0]) + (_e3877 * _e3560[1])) + (_e3880 * _e3560[2]));
                                    let _e3910 = (((_e3874 * _e3576) + (_e3877 * _e3577)) + (_e3880 * _e3578));
                                    let _e3915 = (((_e3874 * _e3579) + (_e3877 * _e3580)) + (_e3880 * _e3581));
                                    let _e3920 = (((_e3874 * _e3560[0]) + (_e3877 * _e3560[1])) + (_e3880 * _e3560[2]));
                                    if (_e3885 < _e3890) {
                                        phi_6760_ = _e3885;
                                    } else {
                                        phi_6760_ = _e3890;
                                    }
                                    let _e3923 = phi_6760_;
                                    if (_e3895 < _e3900) {
                                        phi_6765_ = _e3895;
                                    } else {
                                        phi_6765_ = _e3900;
                                    }
                                    let _e3926 = phi_6765_;
                                    if (_e3923 < _e3926) {
                                        phi_6770_ = _e3923;
                                    } else {
                                        phi_6770_ = _e3926;
                                    }
                                    let _e3929 = phi_6770_;
                                    if (_e3905 < _e3910) {
                                        phi_6775_ = _e3905;
                                    } else {
                                        phi_6775_ = _e3910;
                                    }
                                    let _e3932 = phi_6775_;
                                    if (_e3915 < _e3920) {
                                        phi_6780_ = _e3915;
                                    } else {
                                        phi_6780_ = _e3920;
                                    }
                                    let _e3935 = phi_6780_;
                                    if (_e3932 < _e3935) {
                                        phi_6785_ = _e3932;
                                    } else {
                                        phi_6785_ = _e3935;
                                    }
                                    let _e3938 = phi_6785_;
                                    if (_e3929 < _e3938) {
                                        phi_6790_ = _e3929;
                                    } else {
                                        phi_6790_ = _e3938;
                                    }
                                    let _e3941 = phi_6790_;
                                    if (_e3885 > _e3890) {
                                        phi_6795_ = _e3885;
                                    } else {
                                        phi_6795_ = _e3890;
                                    }
                                    let _e3944 = phi_6795_;
                                    if (_e3895 > _e3900) {
                                        phi_6800_ = _e3895;
                                    } else {
                                        phi_6800_ = _e3900;
                                    }
                                    let _e3947 = phi_6800_;
                                    if (_e3944 > _e3947) {
                                        phi_6805_ = _e3944;
                                    } else {
                                        phi_6805_ = _e3947;
                                    }
                                    let _e3950 = phi_6805_;
                                    if (_e3905 > _e3910) {
                                        phi_6810_ = _e3905;
                                    } else {
                                        phi_6810_ = _e3910;
                                    }
                                    let _e3953 = phi_6810_;
                                    if (_e3915 > _e3920) {
                                        phi_6815_ = _e3915;
                                    } else {
                                        phi_6815_ = _e3920;
                                    }
                                    let _e3956 = phi_6815_;
                                    if (_e3953 > _e3956) {
                                        phi_6820_ = _e3953;
                                    } else {
                                        phi_6820_ = _e3956;
                                    }
                                    let _e3959 = phi_6820_;
                                    if (_e3950 > _e3959) {
                                        phi_6825_ = _e3950;
                                    } else {
                                        phi_6825_ = _e3959;
                                    }
                                    let _e3962 = phi_6825_;
                                    if (_e3874 < 0f) {
                                        phi_6831_ = -(_e3874);
                                    } else {
                                        phi_6831_ = _e3874;
                                    }
                                    let _e3966 = phi_6831_;
                                    if (_e3877 < 0f) {
                                        phi_6837_ = -(_e3877);
                                    } else {
                                        phi_6837_ = _e3877;
                                    }
                                    let _e3970 = phi_6837_;
                                    if (_e3880 < 0f) {
                                        phi_6844_ = -(_e3880);
                                    } else {
                                        phi_6844_ = _e3880;
                                    }
                                    let _e3975 = phi_6844_;
                                    let _e3976 = ((_e3966 + _e3970) + _e3975);
                                    let _e3981 = -(_e3962);
                                    if (_e3941 > _e3981) {
                                        phi_6855_ = _e3941;
                                    } else {
                                        phi_6855_ = _e3981;
                                    }
                                    let _e3984 = phi_6855_;
                                    let _e3989 = (((_e3984 - ((_e3976 * _e3746) * (0.000000059604645f * (17f / 2f)))) - (_e3976 * _e3753)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3871 > _e3989) {
                                        phi_6865_ = _e3871;
                                    } else {
                                        phi_6865_ = _e3989;
                                    }
                                    let _e3992 = phi_6865_;
                                    let _e3993 = (_e3522 - _e3507);
                                    let _e3994 = (_e3523 - _e3508);
                                    let _e3995 = (_e3524 - _e3509);
                                    let _e3998 = ((_e3530 * _e3995) - (_e3533 * _e3994));
                                    let _e4001 = ((_e3533 * _e3993) - (_e3527 * _e3995));
                                    let _e4004 = ((_e3527 * _e3994) - (_e3530 * _e3993));
                                    let _e4009 = (((_e3998 * _e3536[0]) + (_e4001 * _e3536[1])) + (_e4004 * _e3536[2]));
                                    let _e4014 = (((_e3998 * _e3552) + (_e4001 * _e3553)) + (_e4004 * _e3554));
                                    let _e4019 = (((_e3998 * _e3555) + (_e4001 * _e3556)) + (_e4004 * _e3557));
                                    let _e4024 = (((_e3998 * _e3536[0]) + (_e4001 * _e3536[1])) + (_e4004 * _e3536[2]));
                                    let _e4029 = (((_e3998 * _e3560[0]) + (_e4001 * _e3560[1])) + (_e4004 * _e3560[2]));
                                    let _e4034 = (((_e3998 * _e3576) + (_e4001 * _e3577)) + (_e4004 * _e3578));
                                    let _e4039 = (((_e3998 * _e3579) + (_e4001 * _e3580)) + (_e4004 * _e3581));
                                    let _e4044 = (((_e3998 * _e3560[0]) + (_e4001 * _e3560[1])) + (_e4004 * _e3560[2]));
                                    if (_e4009 < _e4014) {
                                        phi_6938_ = _e4009;
                                    } else {
                                        phi_6938_ = _e4014;
                                    }
                                    let _e4047 = phi_6938_;
                                    if (_e4019 < _e4024) {
                                        phi_6943_ = _e4019;
                                    } else {
                                        phi_6943_ = _e4024;
                                    }
                                    let _e4050 = phi_6943_;
                                    if (_e4047 < _e4050) {
                                        phi_6948_ = _e4047;
                                    } else {
                                        phi_6948_ = _e4050;
                                    }
                                    let _e4053 = phi_6948_;
                                    if (_e4029 < _e4034) {
                                        phi_6953_ = _e4029;
                                    } else {
                                        phi_6953_ = _e4034;
                                    }
                                    let _e4056 = phi_6953_;
                                    if (_e4039 < _e4044) {
                                        phi_6958_ = _e4039;
                                    } else {
                                        phi_6958_ = _e4044;
                                    }
                                    let _e4059 = phi_6958_;
                                    if (_e4056 < _e4059) {
                                        phi_6963_ = _e4056;
                                    } else {
                                        phi_6963_ = _e4059;
                                    }
                                    let _e4062 = phi_6963_;
                                    if (_e4053 < _e4062) {
                                        phi_6968_ = _e4053;
                                    } else {
                                        phi_6968_ = _e4062;
                                    }
                                    let _e4065 = phi_6968_;
                                    if (_e4009 > _e4014) {
                                        phi_6973_ = _e4009;
                                    } else {
                                        phi_6973_ = _e4014;
                                    }
                                    let _e4068 = phi_6973_;
                                    if (_e4019 > _e4024) {
                                        phi_6978_ = _e4019;
                                    } else {
                                        phi_6978_ = _e4024;
                                    }
                                    let _e4071 = phi_6978_;
                                    if (_e4068 > _e4071) {
                                        phi_6983_ = _e4068;
                                    } else {
                                        phi_6983_ = _e4071;
                                    }
                                    let _e4074 = phi_6983_;
                                    if (_e4029 > _e4034) {
                                        phi_6988_ = _e4029;
                                    } else {
                                        phi_6988_ = _e4034;
                                    }
                                    let _e4077 = phi_6988_;
                                    if (_e4039 > _e4044) {
                                        phi_6993_ = _e4039;
                                    } else {
                                        phi_6993_ = _e4044;
                                    }
                                    let _e4080 = phi_6993_;
                                    if (_e4077 > _e4080) {
                                        phi_6998_ = _e4077;
                                    } else {
                                        phi_6998_ = _e4080;
                                    }
                                    let _e4083 = phi_6998_;
                                    if (_e4074 > _e4083) {
                                        phi_7003_ = _e4074;
                                    } else {
                                        phi_7003_ = _e4083;
                                    }
                                    let _e4086 = phi_7003_;
                                    if (_e3998 < 0f) {
                                        phi_7009_ = -(_e3998);
                                    } else {
                                        phi_7009_ = _e3998;
                                    }
                                    let _e4090 = phi_7009_;
                                    if (_e4001 < 0f) {
                                        phi_7015_ = -(_e4001);
                                    } else {
                                        phi_7015_ = _e4001;
                                    }
                                    let _e4094 = phi_7015_;
                                    if (_e4004 < 0f) {
                                        phi_7022_ = -(_e4004);
                                    } else {
                                        phi_7022_ = _e4004;
                                    }
                                    let _e4099 = phi_7022_;
                                    let _e4100 = ((_e4090 + _e4094) + _e4099);
                                    let _e4105 = -(_e4086);
                                    if (_e4065 > _e4105) {
                                        phi_7033_ = _e4065;
                                    } else {
                                        phi_7033_ = _e4105;
                                    }
                                    let _e4108 = phi_7033_;
                                    let _e4113 = (((_e4108 - ((_e4100 * _e3746) * (0.000000059604645f * (17f / 2f)))) - (_e4100 * _e3753)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3992 > _e4113) {
                                        phi_7043_ = _e3992;
                                    } else {
                                        phi_7043_ = _e4113;
                                    }
                                    let _e4116 = phi_7043_;
                                    phi_7047_ = (_e3494 || (_e4116 > 0f));
                                }
                                let _e4120 = phi_7047_;
                                if _e4120 {
                                    let _e4123 = local_1.member_1[0u];
                                    let _e4129 = local_1.member_2[0u];
                                    let _e4135 = ((_e4123[1] * _e4129[2]) - (_e4123[2] * _e4129[1]));
                                    let _e4138 = ((_e4123[2] * _e4129[0]) - (_e4123[0] * _e4129[2]));
                                    let _e4141 = ((_e4123[0] * _e4129[1]) - (_e4123[1] * _e4129[0]));
                                    let _e4144 = local_1.member_1[1u];
                                    let _e4150 = local_1.member_2[1u];
                                    let _e4156 = ((_e4144[1] * _e4150[2]) - (_e4144[2] * _e4150[1]));
                                    let _e4159 = ((_e4144[2] * _e4150[0]) - (_e4144[0] * _e4150[2]));
                                    let _e4162 = ((_e4144[0] * _e4150[1]) - (_e4144[1] * _e4150[0]));
                                    let _e4165 = local_1.member_1[0u];
                                    let _e4171 = local_1.member_2[1u];
                                    let _e4186 = local_1.member_1[1u];
                                    let _e4192 = local_1.member_2[0u];
                                    let _e4205 = (((_e4165[1] * _e4171[2]) - (_e4165[2] * _e4171[1])) + ((_e4186[1] * _e4192[2]) - (_e4186[2] * _e4192[1])));
                                    let _e4206 = (((_e4165[2] * _e4171[0]) - (_e4165[0] * _e4171[2])) + ((_e4186[2] * _e4192[0]) - (_e4186[0] * _e4192[2])));
                                    let _e4207 = (((_e4165[0] * _e4171[1]) - (_e4165[1] * _e4171[0])) + ((_e4186[0] * _e4192[1]) - (_e4186[1] * _e4192[0])));
                                    let _e4210 = local_1.member[0u];
                                    let _e4221 = local_1.member[1u];
                                    let _e4232 = local_1.member[0u];
                                    let _e4241 = ((((_e4221[0] * _e4135) + (_e4221[1] * _e4138)) + (_e4221[2] * _e4141)) + (((_e4232[0] * _e4205) + (_e4232[1] * _e4206)) + (_e4232[2] * _e4207)));
                                    let _e4244 = local_1.member[0u];
                                    let _e4255 = local_1.member[1u];
                                    let _e4264 = ((((_e4244[0] * _e4156) + (_e4244[1] * _e4159)) + (_e4244[2] * _e4162)) + (((_e4255[0] * _e4205) + (_e4255[1] * _e4206)) + (_e4255[2] * _e4207)));
                                    let _e4267 = local_1.member[1u];
                                    let _e4278 = local_1.member[0u];
                                    if (_e4278[0] < 0f) {
                                        phi_7292_ = -(_e4278[0]);
                                    } else {
                                        phi_7292_ = _e4278[0];
                                    }
                                    let _e4285 = phi_7292_;
                                    if (_e4278[1] < 0f) {
                                        phi_7299_ = -(_e4278[1]);
                                    } else {
                                        phi_7299_ = _e4278[1];
                                    }
                                    let _e4289 = phi_7299_;
                                    if (_e4285 > _e4289) {
                                        phi_7304_ = _e4285;
                                    } else {
                                        phi_7304_ = _e4289;
                                    }
                                    let _e4292 = phi_7304_;
                                    if (_e4278[2] < 0f) {
                                        phi_7311_ = -(_e4278[2]);
                                    } else {
                                        phi_7311_ = _e4278[2];
                                    }
                                    let _e4296 = phi_7311_;
                                    if (_e4292 > _e4296) {
                                        phi_7316_ = _e4292;
                                    } else {
                                        phi_7316_ = _e4296;
                                    }
                                    let _e4299 = phi_7316_;
                                    let _e4302 = local_1.member[1u];
                                    if (_e4302[0] < 0f) {
                                        phi_7329_ = -(_e4302[0]);
                                    } else {
                                        phi_7329_ = _e4302[0];
                                    }
                                    let _e4309 = phi_7329_;
                                    if (_e4302[1] < 0f) {
                                        phi_7336_ = -(_e4302[1]);
                                    } else {
                                        phi_7336_ = _e4302[1];
                                    }
                                    let _e4313 = phi_7336_;
                                    if (_e4309 > _e4313) {
                                        phi_7341_ = _e4309;
                                    } else {
                                        phi_7341_ = _e4313;
                                    }
                                    let _e4316 = phi_7341_;
                                    if (_e4302[2] < 0f) {
                                        phi_7348_ = -(_e4302[2]);
                                    } else {
                                        phi_7348_ = _e4302[2];
                                    }
                                    let _e4320 = phi_7348_;
                                    if (_e4316 > _e4320) {
                                        phi_7353_ = _e4316;
                                    } else {
                                        phi_7353_ = _e4320;
                                    }
                                    let _e4323 = phi_7353_;
                                    if (_e4299 > _e4323) {
                                        phi_7358_ = _e4299;
                                    } else {
                                        phi_7358_ = _e4323;
                                    }
                                    let _e4326 = phi_7358_;
                                    let _e4328 = local_1.member_3;
                                    let _e4329 = (_e4326 + _e4328);
                                    let _e4332 = local_1.member_1[0u];
                                    if (_e4332[0] < 0f) {
                                        phi_7375_ = -(_e4332[0]);
                                    } else {
                                        phi_7375_ = _e4332[0];
                                    }
                                    let _e4339 = phi_7375_;
                                    if (_e4332[1] < 0f) {
                                        phi_7382_ = -(_e4332[1]);
                                    } else {
                                        phi_7382_ = _e4332[1];
                                    }
                                    let _e4343 = phi_7382_;
                                    if (_e4339 > _e4343) {
                                        phi_7387_ = _e4339;
                                    } else {
                                        phi_7387_ = _e4343;
                                    }
                                    let _e4346 = phi_7387_;
                                    if (_e4332[2] < 0f) {
                                        phi_7394_ = -(_e4332[2]);
                                    } else {
                                        phi_7394_ = _e4332[2];
                                    }
                                    let _e4350 = phi_7394_;
                                    if (_e4346 > _e4350) {
                                        phi_7399_ = _e4346;
                                    } else {
                                        phi_7399_ = _e4350;
                                    }
                                    let _e4353 = phi_7399_;
                                    let _e4356 = local_1.member_1[1u];
                                    if (_e4356[0] < 0f) {
                                        phi_7413_ = -(_e4356[0]);
                                    } else {
                                        phi_7413_ = _e4356[0];
                                    }
                                    let _e4363 = phi_7413_;
                                    if (_e4356[1] < 0f) {
                                        phi_7420_ = -(_e4356[1]);
                                    } else {
                                        phi_7420_ = _e4356[1];
                                    }
                                    let _e4367 = phi_7420_;
                                    if (_e4363 > _e4367) {
                                        phi_7425_ = _e4363;
                                    } else {
                                        phi_7425_ = _e4367;
                                    }
                                    let _e4370 = phi_7425_;
                                    if (_e4356[2] < 0f) {
                                        phi_7432_ = -(_e4356[2]);
                                    } else {
                                        phi_7432_ = _e4356[2];
                                    }
                                    let _e4374 = phi_7432_;
                                    if (_e4370 > _e4374) {
                                        phi_7437_ = _e4370;
                                    } else {
                                        phi_7437_ = _e4374;
                                    }
                                    let _e4377 = phi_7437_;
                                    if (_e4353 > _e4377) {
                                        phi_7442_ = _e4353;
                                    } else {
                                        phi_7442_ = _e4377;
                                    }
                                    let _e4380 = phi_7442_;
                                    let _e4382 = local_1.member_3;
                                    let _e4383 = (_e4380 + _e4382);
                                    let _e4386 = local_1.member_2[0u];
                                    if (_e4386[0] < 0f) {
                                        phi_7459_ = -(_e4386[0]);
                                    } else {
                                        phi_7459_ = _e4386[0];
                                    }
                                    let _e4393 = phi_7459_;
                                    if (_e4386[1] < 0f) {
                                        phi_7466_ = -(_e4386[1]);
                                    } else {
                                        phi_7466_ = _e4386[1];
                                    }
                                    let _e4397 = phi_7466_;
                                    if (_e4393 > _e4397) {
                                        phi_7471_ = _e4393;
                                    } else {
                                        phi_7471_ = _e4397;
                                    }
                                    let _e4400 = phi_7471_;
                                    if (_e4386[2] < 0f) {
                                        phi_7478_ = -(_e4386[2]);
                                    } else {
                                        phi_7478_ = _e4386[2];
                                    }
                                    let _e4404 = phi_7478_;
                                    if (_e4400 > _e4404) {
                                        phi_7483_ = _e4400;
                                    } else {
                                        phi_7483_ = _e4404;
                                    }
                                    let _e4407 = phi_7483_;
                                    let _e4410 = local_1.member_2[1u];
                                    if (_e4410[0] < 0f) {
                                        phi_7497_ = -(_e4410[0]);
                                    } else {
                                        phi_7497_ = _e4410[0];
                                    }
                                    let _e4417 = phi_7497_;
                                    if (_e4410[1] < 0f) {
                                        phi_7504_ = -(_e4410[1]);
                                    } else {
                                        phi_7504_ = _e4410[1];
                                    }
                                    let _e4421 = phi_7504_;
                                    if (_e4417 > _e4421) {
                                        phi_7509_ = _e4417;
                                    } else {
                                        phi_7509_ = _e4421;
                                    }
                                    let _e4424 = phi_7509_;
                                    if (_e4410[2] < 0f) {
                                        phi_7516_ = -(_e4410[2]);
                                    } else {
                                        phi_7516_ = _e4410[2];
                                    }
                                    let _e4428 = phi_7516_;
                                    if (_e4424 > _e4428) {
                                        phi_7521_ = _e4424;
                                    } else {
                                        phi_7521_ = _e4428;
                                    }
                                    let _e4431 = phi_7521_;
                                    if (_e4407 > _e4431) {
                                        phi_7526_ = _e4407;
                                    } else {
                                        phi_7526_ = _e4431;
                                    }
                                    let _e4434 = phi_7526_;
                                    let _e4436 = local_1.member_3;
                                    let _e4437 = (_e4434 + _e4436);
                                    let _e4439 = ((_e4383 * 8f) * _e4437);
                                    let _e4446 = local_1.member_3;
                                    if (_e4135 < 0f) {
                                        phi_7557_ = -(_e4135);
                                    } else {
                                        phi_7557_ = _e4135;
                                    }
                                    let _e4463 = phi_7557_;
                                    if (_e4138 < 0f) {
                                        phi_7563_ = -(_e4138);
                                    } else {
                                        phi_7563_ = _e4138;
                                    }
                                    let _e4467 = phi_7563_;
                                    if (_e4141 < 0f) {
                                        phi_7570_ = -(_e4141);
                                    } else {
                                        phi_7570_ = _e4141;
                                    }
                                    let _e4472 = phi_7570_;
                                    let _e4473 = ((_e4463 + _e4467) + _e4472);
                                    if (_e4156 < 0f) {
                                        phi_7577_ = -(_e4156);
                                    } else {
                                        phi_7577_ = _e4156;
                                    }
                                    let _e4477 = phi_7577_;
                                    if (_e4159 < 0f) {
                                        phi_7583_ = -(_e4159);
                                    } else {
                                        phi_7583_ = _e4159;
                                    }
                                    let _e4481 = phi_7583_;
                                    if (_e4162 < 0f) {
                                        phi_7590_ = -(_e4162);
                                    } else {
                                        phi_7590_ = _e4162;
                                    }
                                    let _e4486 = phi_7590_;
                                    let _e4487 = ((_e4477 + _e4481) + _e4486);
                                    if (_e4473 > _e4487) {
                                        phi_7596_ = _e4473;
                                    } else {
                                        phi_7596_ = _e4487;
                                    }
                                    let _e4490 = phi_7596_;
                                    if (_e4205 < 0f) {
                                        phi_7602_ = -(_e4205);
                                    } else {
                                        phi_7602_ = _e4205;
                                    }
                                    let _e4494 = phi_7602_;
                                    if (_e4206 < 0f) {
                                        phi_7608_ = -(_e4206);
                                    } else {
                                        phi_7608_ = _e4206;
                                    }
                                    let _e4498 = phi_7608_;
                                    if (_e4207 < 0f) {
                                        phi_7615_ = -(_e4207);
                                    } else {
                                        phi_7615_ = _e4207;
                                    }
                                    let _e4503 = phi_7615_;
                                    let _e4505 = (((_e4494 + _e4498) + _e4503) * 0.5f);
                                    if (_e4490 > _e4505) {
                                        phi_7622_ = _e4490;
                                    } else {
                                        phi_7622_ = _e4505;
                                    }
                                    let _e4508 = phi_7622_;
                                    let _e4513 = local_1.member_3;
                                    let _e4526 = ((((_e4210[0] * _e4135) + (_e4210[1] * _e4138)) + (_e4210[2] * _e4141)) * 3f);
                                    let _e4527 = ((((_e4267[0] * _e4156) + (_e4267[1] * _e4159)) + (_e4267[2] * _e4162)) * 3f);
                                    if (_e4526 < _e4527) {
                                        phi_7646_ = _e4526;
                                    } else {
                                        phi_7646_ = _e4527;
                                    }
                                    let _e4530 = phi_7646_;
                                    if (_e4241 < _e4264) {
                                        phi_7651_ = _e4241;
                                    } else {
                                        phi_7651_ = _e4264;
                                    }
                                    let _e4533 = phi_7651_;
                                    if (_e4530 < _e4533) {
                                        phi_7656_ = _e4530;
                                    } else {
                                        phi_7656_ = _e4533;
                                    }
                                    let _e4536 = phi_7656_;
                                    if (_e4526 > _e4527) {
                                        phi_7661_ = _e4526;
                                    } else {
                                        phi_7661_ = _e4527;
                                    }
                                    let _e4539 = phi_7661_;
                                    if (_e4241 > _e4264) {
                                        phi_7666_ = _e4241;
                                    } else {
                                        phi_7666_ = _e4264;
                                    }
                                    let _e4542 = phi_7666_;
                                    if (_e4539 > _e4542) {
                                        phi_7671_ = _e4539;
                                    } else {
                                        phi_7671_ = _e4542;
                                    }
                                    let _e4545 = phi_7671_;
                                    let _e4550 = -(_e4545);
                                    if (_e4536 > _e4550) {
                                        phi_7681_ = _e4536;
                                    } else {
                                        phi_7681_ = _e4550;
                                    }
                                    let _e4553 = phi_7681_;
                                    let _e4555 = ((_e4553 - ((((((_e4329 * 8f) * _e4439) * (0.000000059604645f * (524f / 64f))) + ((_e4446 * 19f) * ((_e4329 * (_e4383 + _e4437)) + (_e4383 * _e4437)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4329) * ((1f + _e4383) * (1f + _e4437))))) + ((_e1839 * (((_e4508 + (_e4439 * (0.000000059604645f * 8f))) + ((_e4513 * 6f) * (_e4383 + _e4437))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4383) * (1f + _e4437))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4555 {
                                        phi_8650_ = _e4555;
                                    } else {
                                        let _e4558 = local_1.member_1[0u];
                                        let _e4564 = local_1.member_1[1u];
                                        let _e4568 = (_e4558[0] + _e4564[0]);
                                        let _e4569 = (_e4558[1] + _e4564[1]);
                                        let _e4570 = (_e4558[2] + _e4564[2]);
                                        let _e4573 = local_1.member_2[0u];
                                        let _e4579 = local_1.member_2[1u];
                                        let _e4583 = (_e4573[0] + _e4579[0]);
                                        let _e4584 = (_e4573[1] + _e4579[1]);
                                        let _e4585 = (_e4573[2] + _e4579[2]);
                                        let _e4588 = ((_e4569 * _e4585) - (_e4570 * _e4584));
                                        let _e4591 = ((_e4570 * _e4583) - (_e4568 * _e4585));
                                        let _e4594 = ((_e4568 * _e4584) - (_e4569 * _e4583));
                                        let _e4597 = local_1.member[0u];
                                        let _e4603 = local_1.member_1[0u];
                                        let _e4609 = local_1.member_2[0u];
                                        let _e4613 = (_e4597[0] - _e4603[0]);
                                        let _e4614 = (_e4597[1] - _e4603[1]);
                                        let _e4615 = (_e4597[2] - _e4603[2]);
                                        let _e4616 = (_e4597[0] - _e4609[0]);
                                        let _e4617 = (_e4597[1] - _e4609[1]);
                                        let _e4618 = (_e4597[2] - _e4609[2]);
                                        let _e4621 = local_1.member[1u];
                                        let _e4627 = local_1.member_1[1u];
                                        let _e4633 = local_1.member_2[1u];
                                        let _e4637 = (_e4621[0] - _e4627[0]);
                                        let _e4638 = (_e4621[1] - _e4627[1]);
                                        let _e4639 = (_e4621[2] - _e4627[2]);
                                        let _e4640 = (_e4621[0] - _e4633[0]);
                                        let _e4641 = (_e4621[1] - _e4633[1]);
                                        let _e4642 = (_e4621[2] - _e4633[2]);
                                        let _e4645 = local_1.member[0u];
                                        if (_e4645[0] < 0f) {
                                            phi_7884_ = -(_e4645[0]);
                                        } else {
                                            phi_7884_ = _e4645[0];
                                        }
                                        let _e4652 = phi_7884_;
                                        if (_e4645[1] < 0f) {
                                            phi_7891_ = -(_e4645[1]);
                                        } else {
                                            phi_7891_ = _e4645[1];
                                        }
                                        let _e4656 = phi_7891_;
                                        if (_e4652 > _e4656) {
                                            phi_7896_ = _e4652;
                                        } else {
                                            phi_7896_ = _e4656;
                                        }
                                        let _e4659 = phi_7896_;
                                        if (_e4645[2] < 0f) {
                                            phi_7903_ = -(_e4645[2]);
                                        } else {
                                            phi_7903_ = _e4645[2];
                                        }
                                        let _e4663 = phi_7903_;
                                        if (_e4659 > _e4663) {
                                            phi_7908_ = _e4659;
                                        } else {
                                            phi_7908_ = _e4663;
                                        }
                                        let _e4666 = phi_7908_;
                                        let _e4669 = local_1.member[1u];
                                        if (_e4669[0] < 0f) {
                                            phi_7921_ = -(_e4669[0]);
                                        } else {
                                            phi_7921_ = _e4669[0];
                                        }
                                        let _e4676 = phi_7921_;
                                        if (_e4669[1] < 0f) {
                                            phi_7928_ = -(_e4669[1]);
                                        } else {
                                            phi_7928_ = _e4669[1];
                                        }
                                        let _e4680 = phi_7928_;
                                        if (_e4676 > _e4680) {
                                            phi_7933_ = _e4676;
                                        } else {
                                            phi_7933_ = _e4680;
                                        }
                                        let _e4683 = phi_7933_;
                                        if (_e4669[2] < 0f) {
                                            phi_7940_ = -(_e4669[2]);
                                        } else {
                                            phi_7940_ = _e4669[2];
                                        }
                                        let _e4687 = phi_7940_;
                                        if (_e4683 > _e4687) {
                                            phi_7945_ = _e4683;
                                        } else {
                                            phi_7945_ = _e4687;
                                        }
                                        let _e4690 = phi_7945_;
                                        if (_e4666 > _e4690) {
                                            phi_7950_ = _e4666;
                                        } else {
                                            phi_7950_ = _e4690;
                                        }
                                        let _e4693 = phi_7950_;
                                        let _e4695 = local_1.member_3;
                                        let _e4699 = local_1.member_1[0u];
                                        if (_e4699[0] < 0f) {
                                            phi_7967_ = -(_e4699[0]);
                                        } else {
                                            phi_7967_ = _e4699[0];
                                        }
                                        let _e4706 = phi_7967_;
                                        if (_e4699[1] < 0f) {
                                            phi_7974_ = -(_e4699[1]);
                                        } else {
                                            phi_7974_ = _e4699[1];
                                        }
                                        let _e4710 = phi_7974_;
                                        if (_e4706 > _e4710) {
                                            phi_7979_ = _e4706;
                                        } else {
                                            phi_7979_ = _e4710;
                                        }
                                        let _e4713 = phi_7979_;
                                        if (_e4699[2] < 0f) {
                                            phi_7986_ = -(_e4699[2]);
                                        } else {
                                            phi_7986_ = _e4699[2];
                                        }
                                        let _e4717 = phi_7986_;
                                        if (_e4713 > _e4717) {
                                            phi_7991_ = _e4713;
                                        } else {
                                            phi_7991_ = _e4717;
                                        }
                                        let _e4720 = phi_7991_;
                                        let _e4723 = local_1.member_1[1u];
                                        if (_e4723[0] < 0f) {
                                            phi_8005_ = -(_e4723[0]);
                                        } else {
                                            phi_8005_ = _e4723[0];
                                        }
                                        let _e4730 = phi_8005_;
                                        if (_e4723[1] < 0f) {
                                            phi_8012_ = -(_e4723[1]);
                                        } else {
                                            phi_8012_ = _e4723[1];
                                        }
                                        let _e4734 = phi_8012_;
                                        if (_e4730 > _e4734) {
                                            phi_8017_ = _e4730;
                                        } else {
                                            phi_8017_ = _e4734;
                                        }
                                        let _e4737 = phi_8017_;
                                        if (_e4723[2] < 0f) {
                                            phi_8024_ = -(_e4723[2]);
                                        } else {
                                            phi_8024_ = _e4723[2];
                                        }
                                        let _e4741 = phi_8024_;
                                        if (_e4737 > _e4741) {
                                            phi_8029_ = _e4737;
                                        } else {
                                            phi_8029_ = _e4741;
                                        }
                                        let _e4744 = phi_8029_;
                                        if (_e4720 > _e4744) {
                                            phi_8034_ = _e4720;
                                        } else {
                                            phi_8034_ = _e4744;
                                        }
                                        let _e4747 = phi_8034_;
                                        let _e4749 = local_1.member_3;
                                        let _e4753 = local_1.member_2[0u];
                                        if (_e4753[0] < 0f) {
                                            phi_8051_ = -(_e4753[0]);
                                        } else {
                                            phi_8051_ = _e4753[0];
                                        }
                                        let _e4760 = phi_8051_;
                                        if (_e4753[1] < 0f) {
                                            phi_8058_ = -(_e4753[1]);
                                        } else {
                                            phi_8058_ = _e4753[1];
                                        }
                                        let _e4764 = phi_8058_;
                                        if (_e4760 > _e4764) {
                                            phi_8063_ = _e4760;
                                        } else {
                                            phi_8063_ = _e4764;
                                        }
                                        let _e4767 = phi_8063_;
                                        if (_e4753[2] < 0f) {
                                            phi_8070_ = -(_e4753[2]);
                                        } else {
                                            phi_8070_ = _e4753[2];
                                        }
                                        let _e4771 = phi_8070_;
                                        if (_e4767 > _e4771) {
                                            phi_8075_ = _e4767;
                                        } else {
                                            phi_8075_ = _e4771;
                                        }
                                        let _e4774 = phi_8075_;
                                        let _e4777 = local_1.member_2[1u];
                                        if (_e4777[0] < 0f) {
                                            phi_8089_ = -(_e4777[0]);
                                        } else {
                                            phi_8089_ = _e4777[0];
                                        }
                                        let _e4784 = phi_8089_;
                                        if (_e4777[1] < 0f) {
                                            phi_8096_ = -(_e4777[1]);
                                        } else {
                                            phi_8096_ = _e4777[1];
                                        }
                                        let _e4788 = phi_8096_;
                                        if (_e4784 > _e4788) {
                                            phi_8101_ = _e4784;
                                        } else {
                                            phi_8101_ = _e4788;
                                        }
                                        let _e4791 = phi_8101_;
                                        if (_e4777[2] < 0f) {
                                            phi_8108_ = -(_e4777[2]);
                                        } else {
                                            phi_8108_ = _e4777[2];
                                        }
                                        let _e4795 = phi_8108_;
                                        if (_e4791 > _e4795) {
                                            phi_8113_ = _e4791;
                                        } else {
                                            phi_8113_ = _e4795;
                                        }
                                        let _e4798 = phi_8113_;
                                        if (_e4774 > _e4798) {
                                            phi_8118_ = _e4774;
                                        } else {
                                            phi_8118_ = _e4798;
                                        }
                                        let _e4801 = phi_8118_;
                                        let _e4803 = local_1.member_3;
                                        let _e4807 = ((((_e4693 + _e4695) + (_e4747 + _e4749)) + (_e4801 + _e4803)) * 2f);
                                        let _e4810 = local_1.member_3;
                                        let _e4814 = (((_e1839 * 1.0001f) + (_e4810 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4817 = ((_e4591 * _e4570) - (_e4594 * _e4569));
                                        let _e4820 = ((_e4594 * _e4568) - (_e4588 * _e4570));
                                        let _e4823 = ((_e4588 * _e4569) - (_e4591 * _e4568));
                                        let _e4828 = (((_e4817 * _e4597[0]) + (_e4820 * _e4597[1])) + (_e4823 * _e4597[2]));
                                        let _e4833 = (((_e4817 * _e4613) + (_e4820 * _e4614)) + (_e4823 * _e4615));
                                        let _e4838 = (((_e4817 * _e4616) + (_e4820 * _e4617)) + (_e4823 * _e4618));
                                        let _e4843 = (((_e4817 * _e4597[0]) + (_e4820 * _e4597[1])) + (_e4823 * _e4597[2]));
                                        let _e4848 = (((_e4817 * _e4621[0]) + (_e4820 * _e4621[1])) + (_e4823 * _e4621[2]));
                                        let _e4853 = (((_e4817 * _e4637) + (_e4820 * _e4638)) + (_e4823 * _e4639));
                                        let _e4858 = (((_e4817 * _e4640) + (_e4820 * _e4641)) + (_e4823 * _e4642));
                                        let _e4863 = (((_e4817 * _e4621[0]) + (_e4820 * _e4621[1])) + (_e4823 * _e4621[2]));
                                        if (_e4828 < _e4833) {
                                            phi_8197_ = _e4828;
                                        } else {
                                            phi_8197_ = _e4833;
                                        }
                                        let _e4866 = phi_8197_;
                                        if (_e4838 < _e4843) {
                                            phi_8202_ = _e4838;
                                        } else {
                                            phi_8202_ = _e4843;
                                        }
                                        let _e4869 = phi_8202_;
                                        if (_e4866 < _e4869) {
                                            phi_8207_ = _e4866;
                                        } else {
                                            phi_8207_ = _e4869;
                                        }
                                        let _e4872 = phi_8207_;
                                        if (_e4848 < _e4853) {
                                            phi_8212_ = _e4848;
                                        } else {
                                            phi_8212_ = _e4853;
                                        }
                                        let _e4875 = phi_8212_;
                                        if (_e4858 < _e4863) {
                                            phi_8217_ = _e4858;
                                        } else {
                                            phi_8217_ = _e4863;
                                        }
                                        let _e4878 = phi_8217_;
                                        if (_e4875 < _e4878) {
                                            phi_8222_ = _e4875;
                                        } else {
                                            phi_8222_ = _e4878;
                                        }
                                        let _e4881 = phi_8222_;
                                        if (_e4872 < _e4881) {
                                            phi_8227_ = _e4872;
                                        } else {
                                            phi_8227_ = _e4881;
                                        }
                                        let _e4884 = phi_8227_;
                                        if (_e4828 > _e4833) {
                                            phi_8232_ = _e4828;
                                        } else {
                                            phi_8232_ = _e4833;
                                        }
                                        let _e4887 = phi_8232_;
                                        if (_e4838 > _e4843) {
                                            phi_8237_ = _e4838;
                                        } else {
                                            phi_8237_ = _e4843;
                                        }
                                        let _e4890 = phi_8237_;
                                        if (_e4887 > _e4890) {
                                            phi_8242_ = _e4887;
                                        } else {
                                            phi_8242_ = _e4890;
                                        }
                                        let _e4893 = phi_8242_;
                                        if (_e4848 > _e4853) {
                                            phi_8247_ = _e4848;
                                        } else {
                                            phi_8247_ = _e4853;
                                        }
                                        let _e4896 = phi_8247_;
                                        if (_e4858 > _e4863) {
                                            phi_8252_ = _e4858;
                                        } else {
                                            phi_8252_ = _e4863;
                                        }
                                        let _e4899 = phi_8252_;
                                        if (_e4896 > _e4899) {
                                            phi_8257_ = _e4896;
                                        } else {
                                            phi_8257_ = _e4899;
                                        }
                                        let _e4902 = phi_8257_;
                                        if (_e4893 > _e4902) {
                                            phi_8262_ = _e4893;
                                        } else {
                                            phi_8262_ = _e4902;
                                        }
                                        let _e4905 = phi_8262_;
                                        if (_e4817 < 0f) {
                                            phi_8268_ = -(_e4817);
                                        } else {
                                            phi_8268_ = _e4817;
                                        }
                                        let _e4909 = phi_8268_;
                                        if (_e4820 < 0f) {
                                            phi_8274_ = -(_e4820);
                                        } else {
                                            phi_8274_ = _e4820;
                                        }
                                        let _e4913 = phi_8274_;
                                        if (_e4823 < 0f) {
                                            phi_8281_ = -(_e4823);
                                        } else {
                                            phi_8281_ = _e4823;
                                        }
                                        let _e4918 = phi_8281_;
                                        let _e4919 = ((_e4909 + _e4913) + _e4918);
                                        let _e4924 = -(_e4905);
                                        if (_e4884 > _e4924) {
                                            phi_8292_ = _e4884;
                                        } else {
                                            phi_8292_ = _e4924;
                                        }
                                        let _e4927 = phi_8292_;
                                        let _e4932 = (((_e4927 - ((_e4919 * _e4807) * (0.000000059604645f * (17f / 2f)))) - (_e4919 * _e4814)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4935 = ((_e4591 * _e4585) - (_e4594 * _e4584));
                                        let _e4938 = ((_e4594 * _e4583) - (_e4588 * _e4585));
                                        let _e4941 = ((_e4588 * _e4584) - (_e4591 * _e4583));
                                        let _e4946 = (((_e4935 * _e4597[0]) + (_e4938 * _e4597[1])) + (_e4941 * _e4597[2]));
                                        let _e4951 = (((_e4935 * _e4613) + (_e4938 * _e4614)) + (_e4941 * _e4615));
                                        let _e4956 = (((_e4935 * _e4616) + (_e4938 * _e4617)) + (_e4941 * _e4618));
                                        let _e4961 = (((_e4935 * _e4597[0]) + (_e4938 * _e4597[1])) + (_e4941 * _e4597[2]));
                                        let _e4966 = (((_e4935 * _e4621[0]) + (_e4938 * _e4621[1])) + (_e4941 * _e4621[2]));
                                        let _e4971 = (((_e4935 * _e4637) + (_e4938 * _e4638)) + (_e4941 * _e4639));
                                        let _e4976 = (((_e4935 * _e4640) + (_e4938 * _e4641)) + (_e4941 * _e4642));
                                        let _e4981 = (((_e4935 * _e4621[0]) + (_e4938 * _e4621[1])) + (_e4941 * _e4621[2]));
                                        if (_e4946 < _e4951) {
                                            phi_8363_ = _e4946;
                                        } else {
                                            phi_8363_ = _e4951;
                                        }
                                        let _e4984 = phi_8363_;
                                        if (_e4956 < _e4961) {
                                            phi_8368_ = _e4956;
                                        } else {
                                            phi_8368_ = _e4961;
                                        }
                                        let _e4987 = phi_8368_;
                                        if (_e4984 < _e4987) {
                                            phi_8373_ = _e4984;
                                        } else {
                                            phi_8373_ = _e4987;
                                        }
                                        let _e4990 = phi_8373_;
                                        if (_e4966 < _e4971) {
                                            phi_8378_ = _e4966;
                                        } else {
                                            phi_8378_ = _e4971;
                                        }
                                        let _e4993 = phi_8378_;
                                        if (_e4976 < _e4981) {
                                            phi_8383_ = _e4976;
                                        } else {
                                            phi_8383_ = _e4981;
                                        }
                                        let _e4996 = phi_8383_;
                                        if (_e4993 < _e4996) {
                                            phi_8388_ = _e4993;
                                        } else {
                                            phi_8388_ = _e4996;
                                        }
                                        let _e4999 = phi_8388_;
                                        if (_e4990 < _e4999) {
                                            phi_8393_ = _e4990;
                                        } else {
                                            phi_8393_ = _e4999;
                                        }
                                        let _e5002 = phi_8393_;
                                        if (_e4946 > _e4951) {
                                            phi_8398_ = _e4946;
                                        } else {
                                            phi_8398_ = _e4951;
                                        }
                                        let _e5005 = phi_8398_;
                                        if (_e4956 > _e4961) {
                                            phi_8403_ = _e4956;
                                        } else {
                                            phi_8403_ = _e4961;
                                        }
                                        let _e5008 = phi_8403_;
                                        if (_e5005 > _e5008) {
                                            phi_8408_ = _e5005;
                                        } else {
                                            phi_8408_ = _e5008;
                                        }
                                        let _e5011 = phi_8408_;
                                        if (_e4966 > _e4971) {
                                            phi_8413_ = _e4966;
                                        } else {
                                            phi_8413_ = _e4971;
                                        }
                                        let _e5014 = phi_8413_;
                                        if (_e4976 > _e4981) {
                                            phi_8418_ = _e4976;
                                        } else {
                                            phi_8418_ = _e4981;
                                        }
                                        let _e5017 = phi_8418_;
                                        if (_e5014 > _e5017) {
                                            phi_8423_ = _e5014;
                                        } else {
                                            phi_8423_ = _e5017;
                                        }
                                        let _e5020 = phi_8423_;
                                        if (_e5011 > _e5020) {
                                            phi_8428_ = _e5011;
                                        } else {
                                            phi_8428_ = _e5020;
                                        }
                                        let _e5023 = phi_8428_;
                                        if (_e4935 < 0f) {
                                            phi_8434_ = -(_e4935);
                                        } else {
                                            phi_8434_ = _e4935;
                                        }
                                        let _e5027 = phi_8434_;
                                        if (_e4938 < 0f) {
                                            phi_8440_ = -(_e4938);
                                        } else {
                                            phi_8440_ = _e4938;
                                        }
                                        let _e5031 = phi_8440_;
                                        if (_e4941 < 0f) {
                                            phi_8447_ = -(_e4941);
                                        } else {
                                            phi_8447_ = _e4941;
                                        }
                                        let _e5036 = phi_8447_;
                                        let _e5037 = ((_e5027 + _e5031) + _e5036);
                                        let _e5042 = -(_e5023);
                                        if (_e5002 > _e5042) {
                                            phi_8458_ = _e5002;
                                        } else {
                                            phi_8458_ = _e5042;
                                        }
                                        let _e5045 = phi_8458_;
                                        let _e5050 = (((_e5045 - ((_e5037 * _e4807) * (0.000000059604645f * (17f / 2f)))) - (_e5037 * _e4814)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4932 > _e5050) {
                                            phi_8468_ = _e4932;
                                        } else {
                                            phi_8468_ = _e5050;
                                        }
                                        let _e5053 = phi_8468_;
                                        let _e5054 = (_e4583 - _e4568);
                                        let _e5055 = (_e4584 - _e4569);
                                        let _e5056 = (_e4585 - _e4570);
                                        let _e5059 = ((_e4591 * _e5056) - (_e4594 * _e5055));
                                        let _e5062 = ((_e4594 * _e5054) - (_e4588 * _e5056));
                                        let _e5065 = ((_e4588 * _e5055) - (_e4591 * _e5054));
                                        let _e5070 = (((_e5059 * _e4597[0]) + (_e5062 * _e4597[1])) + (_e5065 * _e4597[2]));
                                        let _e5075 = (((_e5059 * _e4613) + (_e5062 * _e4614)) + (_e5065 * _e4615));
                                        let _e5080 = (((_e5059 * _e4616) + (_e5062 * _e4617)) + (_e5065 * _e4618));
                                        let _e5085 = (((_e5059 * _e4597[0]) + (_e5062 * _e4597[1])) + (_e5065 * _e4597[2]));
                                        let _e5090 = (((_e5059 * _e4621[0]) + (_e5062 * _e4621[1])) + (_e5065 * _e4621[2]));
                                        let _e5095 = (((_e5059 * _e4637) + (_e5062 * _e4638)) + (_e5065 * _e4639));
                                        let _e5100 = (((_e5059 * _e4640) + (_e5062 * _e4641)) + (_e5065 * _e4642));
                                        let _e5105 = (((_e5059 * _e4621[0]) + (_e5062 * _e4621[1])) + (_e5065 * _e4621[2]));
                                        if (_e5070 < _e5075) {
                                            phi_8541_ = _e5070;
                                        } else {
                                            phi_8541_ = _e5075;
                                        }
                                        let _e5108 = phi_8541_;
                                        if (_e5080 < _e5085) {
                                            phi_8546_ = _e5080;
                                        } else {
                                            phi_8546_ = _e5085;
                                        }
                                        let _e5111 = phi_8546_;
                                        if (_e5108 < _e5111) {
                                            phi_8551_ = _e5108;
                                        } else {
                                            phi_8551_ = _e5111;
                                        }
                                        let _e5114 = phi_8551_;
                                        if (_e5090 < _e5095) {
                                            phi_8556_ = _e5090;
                                        } else {
                                            phi_8556_ = _e5095;
                                        }
                                        let _e5117 = phi_8556_;
                                        if (_e5100 < _e5105) {
                                            phi_8561_ = _e5100;
                                        } else {
                                            phi_8561_ = _e5105;
                                        }
                                        let _e5120 = phi_8561_;
                                        if (_e5117 < _e5120) {
                                            phi_8566_ = _e5117;
                                        } else {
                                            phi_8566_ = _e5120;
                                        }
                                        let _e5123 = phi_8566_;
                                        if (_e5114 < _e5123) {
                                            phi_8571_ = _e5114;
                                        } else {
                                            phi_8571_ = _e5123;
                                        }
                                        let _e5126 = phi_8571_;
                                        if (_e5070 > _e5075) {
                                            phi_8576_ = _e5070;
                                        } else {
                                            phi_8576_ = _e5075;
                                        }
                                        let _e5129 = phi_8576_;
                                        if (_e5080 > _e5085) {
                                            phi_8581_ = _e5080;
                                        } else {
                                            phi_8581_ = _e5085;
                                        }
                                        let _e5132 = phi_8581_;
                                        if (_e5129 > _e5132) {
                                            phi_8586_ = _e5129;
                                        } else {
                                            phi_8586_ = _e5132;
                                        }
                                        let _e5135 = phi_8586_;
                                        if (_e5090 > _e5095) {
                                            phi_8591_ = _e5090;
                                        } else {
                                            phi_8591_ = _e5095;
                                        }
                                        let _e5138 = phi_8591_;
                                        if (_e5100 > _e5105) {
                                            phi_8596_ = _e5100;
                                        } else {
                                            phi_8596_ = _e5105;
                                        }
                                        let _e5141 = phi_8596_;
                                        if (_e5138 > _e5141) {
                                            phi_8601_ = _e5138;
                                        } else {
                                            phi_8601_ = _e5141;
                                        }
                                        let _e5144 = phi_8601_;
                                        if (_e5135 > _e5144) {
                                            phi_8606_ = _e5135;
                                        } else {
                                            phi_8606_ = _e5144;
                                        }
                                        let _e5147 = phi_8606_;
                                        if (_e5059 < 0f) {
                                            phi_8612_ = -(_e5059);
                                        } else {
                                            phi_8612_ = _e5059;
                                        }
                                        let _e5151 = phi_8612_;
                                        if (_e5062 < 0f) {
                                            phi_8618_ = -(_e5062);
                                        } else {
                                            phi_8618_ = _e5062;
                                        }
                                        let _e5155 = phi_8618_;
                                        if (_e5065 < 0f) {
                                            phi_8625_ = -(_e5065);
                                        } else {
                                            phi_8625_ = _e5065;
                                        }
                                        let _e5160 = phi_8625_;
                                        let _e5161 = ((_e5151 + _e5155) + _e5160);
                                        let _e5166 = -(_e5147);
                                        if (_e5126 > _e5166) {
                                            phi_8636_ = _e5126;
                                        } else {
                                            phi_8636_ = _e5166;
                                        }
                                        let _e5169 = phi_8636_;
                                        let _e5174 = (((_e5169 - ((_e5161 * _e4807) * (0.000000059604645f * (17f / 2f)))) - (_e5161 * _e4814)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5053 > _e5174) {
                                            phi_8646_ = _e5053;
                                        } else {
                                            phi_8646_ = _e5174;
                                        }
                                        let _e5177 = phi_8646_;
                                        phi_8650_ = (_e4555 || (_e5177 > 0f));
                                    }
                                    let _e5181 = phi_8650_;
                                    phi_8652_ = (_e4120 && _e5181);
                                } else {
                                    phi_8652_ = _e4120;
                                }
                                let _e5184 = phi_8652_;
                                phi_8654_ = (_e2969 || _e5184);
                            }
                            let _e5187 = phi_8654_;
                            if !(_e5187) {
                                let _e5190 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1194] = ((2147483648u | (_e5190 << bitcast<u32>(12i))) | _e1197);
                            }
                        }
                        phi_8665_ = true;
                    }
                    let _e5197 = phi_8665_;
                    phi_8666_ = _e5197;
                } else {
                    phi_8666_ = false;
                }
                let _e5199 = phi_8666_;
                continue;
                continuing {
                    phi_2250_ = _e1186;
                    break if !(_e5199);
                }
            }
            workgroupBarrier();
            if (_e73 == 0u) {
                let _e5203 = atomicLoad((&counters[5u]));
                if (_e5203 > 0u) {
                    let _e5206 = atomicAdd((&output.member[0u]), _e5203);
                    if ((_e5206 + _e5203) < _e5206) {
                        let _e5210 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e5206);
                }
            }
            workgroupBarrier();
            let _e5213 = atomicLoad((&counters[6u]));
            if (_e73 == 0u) {
                let _e5216 = atomicLoad((&counters[7u]));
                if (_e5216 > 0u) {
                    let _e5219 = atomicAdd((&output.member[1u]), _e5216);
                    if ((_e5219 + _e5216) < _e5219) {
                        let _e5223 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_8716_ = type_9(0u, 16u);
            loop {
                let _e5225 = phi_8716_;
                if (_e5225.member < _e5225.member_1) {
                    phi_8717_ = type_9((_e5225.member + 1u), _e5225.member_1);
                    phi_8740_ = type_9(1u, _e5225.member);
                } else {
                    phi_8717_ = _e5225;
                    phi_8740_ = type_9(0u, type_9().member_1);
                }
                let _e5237 = phi_8717_;
                let _e5239 = phi_8740_;
                if (bitcast<i32>(_e5239.member) != 0i) {
                    let _e5245 = (_e73 + (_e5239.member_1 * 128u));
                    if (_e5245 >= _e1172) {
                        phi_8837_ = false;
                    } else {
                        let _e5248 = hits[_e5245];
                        if ((_e5248 & 2147483648u) == 0u) {
                            phi_8763_ = 4294967295u;
                        } else {
                            phi_8763_ = ((_e5248 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e5255 = phi_8763_;
                        if (_e5255 != 4294967295u) {
                            let _e5259 = ((_e5248 >> bitcast<u32>(10i)) & 3u);
                            let _e5266 = firsts[(2u * _e5259)];
                            let _e5269 = leaves.member[(_e5266 + ((_e5248 >> bitcast<u32>(5i)) & 31u))];
                            let _e5273 = firsts[((2u * _e5259) + 1u)];
                            let _e5276 = leaves.member[(_e5273 + (_e5248 & 31u))];
                            let _e5281 = params.member.member_1.member_3;
                            let _e5282 = (_e5213 + _e5255);
                            if (_e5282 < _e5281) {
                                let _e5284 = (2u * _e5282);
                                atomicStore((&output.member[(4u + _e5284)]), _e5269.member_1);
                                atomicStore((&output.member[(_e5284 + 5u)]), _e5276.member_1);
                            }
                        }
                        phi_8837_ = true;
                    }
                    let _e5290 = phi_8837_;
                    phi_8838_ = _e5290;
                } else {
                    phi_8838_ = false;
                }
                let _e5292 = phi_8838_;
                continue;
                continuing {
                    phi_8716_ = _e5237;
                    break if !(_e5292);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_444_ = _e159;
            break if !(_e165);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
