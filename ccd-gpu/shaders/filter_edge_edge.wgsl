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
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_931_: bool;
    var phi_935_: bool;
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
    var phi_1128_: bool;
    var phi_1134_: bool;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_1193_: bool;
    var phi_1309_: bool;
    var phi_1310_: bool;
    var phi_1347_: u32;
    var phi_1348_: u32;
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
    var phi_1475_: bool;
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
    var phi_2192_: type_9;
    var phi_2238_: u32;
    var phi_2239_: bool;
    var phi_986_: u32;
    var phi_2240_: bool;
    var phi_2247_: u32;
    var phi_2250_: type_9;
    var phi_2251_: type_9;
    var phi_2274_: type_9;
    var phi_2402_: bool;
    var phi_2408_: bool;
    var phi_2414_: bool;
    var phi_2415_: bool;
    var phi_2459_: bool;
    var phi_2460_: bool;
    var phi_2467_: bool;
    var phi_2583_: bool;
    var phi_2584_: bool;
    var phi_2621_: u32;
    var phi_2622_: u32;
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
    var phi_2749_: bool;
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
    var phi_3467_: array<u32, 3>;
    var phi_3468_: array<u32, 3>;
    var phi_3891_: f32;
    var phi_3898_: f32;
    var phi_3903_: f32;
    var phi_3910_: f32;
    var phi_3915_: f32;
    var phi_3928_: f32;
    var phi_3935_: f32;
    var phi_3940_: f32;
    var phi_3947_: f32;
    var phi_3952_: f32;
    var phi_3957_: f32;
    var phi_3974_: f32;
    var phi_3981_: f32;
    var phi_3986_: f32;
    var phi_3993_: f32;
    var phi_3998_: f32;
    var phi_4012_: f32;
    var phi_4019_: f32;
    var phi_4024_: f32;
    var phi_4031_: f32;
    var phi_4036_: f32;
    var phi_4041_: f32;
    var phi_4058_: f32;
    var phi_4065_: f32;
    var phi_4070_: f32;
    var phi_4077_: f32;
    var phi_4082_: f32;
    var phi_4096_: f32;
    var phi_4103_: f32;
    var phi_4108_: f32;
    var phi_4115_: f32;
    var phi_4120_: f32;
    var phi_4125_: f32;
    var phi_4156_: f32;
    var phi_4162_: f32;
    var phi_4169_: f32;
    var phi_4176_: f32;
    var phi_4182_: f32;
    var phi_4189_: f32;
    var phi_4195_: f32;
    var phi_4201_: f32;
    var phi_4207_: f32;
    var phi_4214_: f32;
    var phi_4221_: f32;
    var phi_4245_: f32;
    var phi_4250_: f32;
    var phi_4255_: f32;
    var phi_4260_: f32;
    var phi_4265_: f32;
    var phi_4270_: f32;
    var phi_4280_: f32;
    var phi_4483_: f32;
    var phi_4490_: f32;
    var phi_4495_: f32;
    var phi_4502_: f32;
    var phi_4507_: f32;
    var phi_4520_: f32;
    var phi_4527_: f32;
    var phi_4532_: f32;
    var phi_4539_: f32;
    var phi_4544_: f32;
    var phi_4549_: f32;
    var phi_4566_: f32;
    var phi_4573_: f32;
    var phi_4578_: f32;
    var phi_4585_: f32;
    var phi_4590_: f32;
    var phi_4604_: f32;
    var phi_4611_: f32;
    var phi_4616_: f32;
    var phi_4623_: f32;
    var phi_4628_: f32;
    var phi_4633_: f32;
    var phi_4650_: f32;
    var phi_4657_: f32;
    var phi_4662_: f32;
    var phi_4669_: f32;
    var phi_4674_: f32;
    var phi_4688_: f32;
    var phi_4695_: f32;
    var phi_4700_: f32;
    var phi_4707_: f32;
    var phi_4712_: f32;
    var phi_4717_: f32;
    var phi_4796_: f32;
    var phi_4801_: f32;
    var phi_4806_: f32;
    var phi_4811_: f32;
    var phi_4816_: f32;
    var phi_4821_: f32;
    var phi_4826_: f32;
    var phi_4831_: f32;
    var phi_4836_: f32;
    var phi_4841_: f32;
    var phi_4846_: f32;
    var phi_4851_: f32;
    var phi_4856_: f32;
    var phi_4861_: f32;
    var phi_4867_: f32;
    var phi_4873_: f32;
    var phi_4880_: f32;
    var phi_4891_: f32;
    var phi_4962_: f32;
    var phi_4967_: f32;
    var phi_4972_: f32;
    var phi_4977_: f32;
    var phi_4982_: f32;
    var phi_4987_: f32;
    var phi_4992_: f32;
    var phi_4997_: f32;
    var phi_5002_: f32;
    var phi_5007_: f32;
    var phi_5012_: f32;
    var phi_5017_: f32;
    var phi_5022_: f32;
    var phi_5027_: f32;
    var phi_5033_: f32;
    var phi_5039_: f32;
    var phi_5046_: f32;
    var phi_5057_: f32;
    var phi_5067_: f32;
    var phi_5249_: bool;
    var phi_5701_: f32;
    var phi_5708_: f32;
    var phi_5713_: f32;
    var phi_5720_: f32;
    var phi_5725_: f32;
    var phi_5738_: f32;
    var phi_5745_: f32;
    var phi_5750_: f32;
    var phi_5757_: f32;
    var phi_5762_: f32;
    var phi_5767_: f32;
    var phi_5784_: f32;
    var phi_5791_: f32;
    var phi_5796_: f32;
    var phi_5803_: f32;
    var phi_5808_: f32;
    var phi_5822_: f32;
    var phi_5829_: f32;
    var phi_5834_: f32;
    var phi_5841_: f32;
    var phi_5846_: f32;
    var phi_5851_: f32;
    var phi_5868_: f32;
    var phi_5875_: f32;
    var phi_5880_: f32;
    var phi_5887_: f32;
    var phi_5892_: f32;
    var phi_5906_: f32;
    var phi_5913_: f32;
    var phi_5918_: f32;
    var phi_5925_: f32;
    var phi_5930_: f32;
    var phi_5935_: f32;
    var phi_5966_: f32;
    var phi_5972_: f32;
    var phi_5979_: f32;
    var phi_5986_: f32;
    var phi_5992_: f32;
    var phi_5999_: f32;
    var phi_6005_: f32;
    var phi_6011_: f32;
    var phi_6017_: f32;
    var phi_6024_: f32;
    var phi_6031_: f32;
    var phi_6055_: f32;
    var phi_6060_: f32;
    var phi_6065_: f32;
    var phi_6070_: f32;
    var phi_6075_: f32;
    var phi_6080_: f32;
    var phi_6090_: f32;
    var phi_6293_: f32;
    var phi_6300_: f32;
    var phi_6305_: f32;
    var phi_6312_: f32;
    var phi_6317_: f32;
    var phi_6330_: f32;
    var phi_6337_: f32;
    var phi_6342_: f32;
    var phi_6349_: f32;
    var phi_6354_: f32;
    var phi_6359_: f32;
    var phi_6376_: f32;
    var phi_6383_: f32;
    var phi_6388_: f32;
    var phi_6395_: f32;
    var phi_6400_: f32;
    var phi_6414_: f32;
    var phi_6421_: f32;
    var phi_6426_: f32;
    var phi_6433_: f32;
    var phi_6438_: f32;
    var phi_6443_: f32;
    var phi_6460_: f32;
    var phi_6467_: f32;
    var phi_6472_: f32;
    var phi_6479_: f32;
    var phi_6484_: f32;
    var phi_6498_: f32;
    var phi_6505_: f32;
    var phi_6510_: f32;
    var phi_6517_: f32;
    var phi_6522_: f32;
    var phi_6527_: f32;
    var phi_6606_: f32;
    var phi_6611_: f32;
    var phi_6616_: f32;
    var phi_6621_: f32;
    var phi_6626_: f32;
    var phi_6631_: f32;
    var phi_6636_: f32;
    var phi_6641_: f32;
    var phi_6646_: f32;
    var phi_6651_: f32;
    var phi_6656_: f32;
    var phi_6661_: f32;
    var phi_6666_: f32;
    var phi_6671_: f32;
    var phi_6677_: f32;
    var phi_6683_: f32;
    var phi_6690_: f32;
    var phi_6701_: f32;
    var phi_6772_: f32;
    var phi_6777_: f32;
    var phi_6782_: f32;
    var phi_6787_: f32;
    var phi_6792_: f32;
    var phi_6797_: f32;
    var phi_6802_: f32;
    var phi_6807_: f32;
    var phi_6812_: f32;
    var phi_6817_: f32;
    var phi_6822_: f32;
    var phi_6827_: f32;
    var phi_6832_: f32;
    var phi_6837_: f32;
    var phi_6843_: f32;
    var phi_6849_: f32;
    var phi_6856_: f32;
    var phi_6867_: f32;
    var phi_6877_: f32;
    var phi_7059_: bool;
    var phi_7304_: f32;
    var phi_7311_: f32;
    var phi_7316_: f32;
    var phi_7323_: f32;
    var phi_7328_: f32;
    var phi_7341_: f32;
    var phi_7348_: f32;
    var phi_7353_: f32;
    var phi_7360_: f32;
    var phi_7365_: f32;
    var phi_7370_: f32;
    var phi_7387_: f32;
    var phi_7394_: f32;
    var phi_7399_: f32;
    var phi_7406_: f32;
    var phi_7411_: f32;
    var phi_7425_: f32;
    var phi_7432_: f32;
    var phi_7437_: f32;
    var phi_7444_: f32;
    var phi_7449_: f32;
    var phi_7454_: f32;
    var phi_7471_: f32;
    var phi_7478_: f32;
    var phi_7483_: f32;
    var phi_7490_: f32;
    var phi_7495_: f32;
    var phi_7509_: f32;
    var phi_7516_: f32;
    var phi_7521_: f32;
    var phi_7528_: f32;
    var phi_7533_: f32;
    var phi_7538_: f32;
    var phi_7569_: f32;
    var phi_7575_: f32;
    var phi_7582_: f32;
    var phi_7589_: f32;
    var phi_7595_: f32;
    var phi_7602_: f32;
    var phi_7608_: f32;
    var phi_7614_: f32;
    var phi_7620_: f32;
    var phi_7627_: f32;
    var phi_7634_: f32;
    var phi_7658_: f32;
    var phi_7663_: f32;
    var phi_7668_: f32;
    var phi_7673_: f32;
    var phi_7678_: f32;
    var phi_7683_: f32;
    var phi_7693_: f32;
    var phi_7896_: f32;
    var phi_7903_: f32;
    var phi_7908_: f32;
    var phi_7915_: f32;
    var phi_7920_: f32;
    var phi_7933_: f32;
    var phi_7940_: f32;
    var phi_7945_: f32;
    var phi_7952_: f32;
    var phi_7957_: f32;
    var phi_7962_: f32;
    var phi_7979_: f32;
    var phi_7986_: f32;
    var phi_7991_: f32;
    var phi_7998_: f32;
    var phi_8003_: f32;
    var phi_8017_: f32;
    var phi_8024_: f32;
    var phi_8029_: f32;
    var phi_8036_: f32;
    var phi_8041_: f32;
    var phi_8046_: f32;
    var phi_8063_: f32;
    var phi_8070_: f32;
    var phi_8075_: f32;
    var phi_8082_: f32;
    var phi_8087_: f32;
    var phi_8101_: f32;
    var phi_8108_: f32;
    var phi_8113_: f32;
    var phi_8120_: f32;
    var phi_8125_: f32;
    var phi_8130_: f32;
    var phi_8209_: f32;
    var phi_8214_: f32;
    var phi_8219_: f32;
    var phi_8224_: f32;
    var phi_8229_: f32;
    var phi_8234_: f32;
    var phi_8239_: f32;
    var phi_8244_: f32;
    var phi_8249_: f32;
    var phi_8254_: f32;
    var phi_8259_: f32;
    var phi_8264_: f32;
    var phi_8269_: f32;
    var phi_8274_: f32;
    var phi_8280_: f32;
    var phi_8286_: f32;
    var phi_8293_: f32;
    var phi_8304_: f32;
    var phi_8375_: f32;
    var phi_8380_: f32;
    var phi_8385_: f32;
    var phi_8390_: f32;
    var phi_8395_: f32;
    var phi_8400_: f32;
    var phi_8405_: f32;
    var phi_8410_: f32;
    var phi_8415_: f32;
    var phi_8420_: f32;
    var phi_8425_: f32;
    var phi_8430_: f32;
    var phi_8435_: f32;
    var phi_8440_: f32;
    var phi_8446_: f32;
    var phi_8452_: f32;
    var phi_8459_: f32;
    var phi_8470_: f32;
    var phi_8480_: f32;
    var phi_8662_: bool;
    var phi_8664_: bool;
    var phi_8666_: bool;
    var phi_8677_: bool;
    var phi_8678_: bool;
    var phi_8728_: type_9;
    var phi_8729_: type_9;
    var phi_8752_: type_9;
    var phi_8775_: u32;
    var phi_8830_: type_9;
    var phi_8849_: bool;
    var phi_8850_: bool;
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
            let _e222 = params.member.member_2.member[0u][1u];
            let _e223 = (_e222 + (_e211 * 32u));
            let _e229 = params.member.member_2.member[0u][1u];
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
            let _e386 = (_e73 / 32u);
            let _e387 = (_e73 % 32u);
            let _e389 = atomicLoad((&counters[_e386]));
            phi_837_ = type_9(0u, _e389);
            phi_840_ = 0u;
            loop {
                let _e392 = phi_837_;
                let _e394 = phi_840_;
                local_7 = _e394;
                if (_e392.member < _e392.member_1) {
                    phi_838_ = type_9((_e392.member + 1u), _e392.member_1);
                    phi_863_ = type_9(1u, _e392.member);
                } else {
                    phi_838_ = _e392;
                    phi_863_ = type_9(0u, type_9().member_1);
                }
                let _e406 = phi_838_;
                let _e408 = phi_863_;
                let _e412 = (bitcast<i32>(_e408.member) != 0i);
                if _e412 {
                    let _e416 = names[((_e386 * 32u) + _e408.member_1)];
                    let _e420 = columns[((_e386 * 32u) + _e408.member_1)];
                    if ((((((_e384.member[0] <= _e420.member_1[0]) && (_e420.member[0] <= _e384.member_1[0])) && (_e384.member[1] <= _e420.member_1[1])) && (_e420.member[1] <= _e384.member_1[1])) && (_e384.member[2] <= _e420.member_1[2])) && (_e420.member[2] <= _e384.member_1[2])) {
                        if (_e211 == _e214) {
                            let _e452 = (_e387 < _e416);
                            if _e452 {
                                phi_929_ = bool();
                            } else {
                                phi_929_ = false;
                            }
                            let _e454 = phi_929_;
                            phi_930_ = _e454;
                            phi_931_ = _e452;
                        } else {
                            phi_930_ = bool();
                            phi_931_ = true;
                        }
                        let _e456 = phi_930_;
                        let _e458 = phi_931_;
                        if _e458 {
                            phi_935_ = true;
                        } else {
                            phi_935_ = _e456;
                        }
                        let _e460 = phi_935_;
                        phi_936_ = _e460;
                    } else {
                        phi_936_ = false;
                    }
                    let _e462 = phi_936_;
                    if false {
                        if _e462 {
                            let _e466 = firsts[((_e386 * 32u) + _e416)];
                            if ((u32() >> bitcast<u32>(16i)) <= (_e466 & 65535u)) {
                                phi_958_ = ((_e466 >> bitcast<u32>(16i)) <= (u32() & 65535u));
                            } else {
                                phi_958_ = false;
                            }
                            let _e476 = phi_958_;
                            phi_959_ = _e476;
                        } else {
                            phi_959_ = false;
                        }
                        let _e478 = phi_959_;
                        phi_960_ = _e478;
                    } else {
                        phi_960_ = _e462;
                    }
                    let _e480 = phi_960_;
                    if _e480 {
                        let _e482 = atomicAdd((&counters[4u]), 1u);
                        if (_e482 < 2048u) {
                            hits[_e482] = (((_e386 << bitcast<u32>(10i)) | (_e387 << bitcast<u32>(5i))) | _e416);
                            phi_978_ = _e394;
                        } else {
                            phi_978_ = (_e394 | (1u << bitcast<u32>((_e408.member_1 & 31u))));
                        }
                        let _e496 = phi_978_;
                        phi_979_ = _e496;
                    } else {
                        phi_979_ = _e394;
                    }
                    let _e498 = phi_979_;
                    phi_841_ = _e498;
                } else {
                    phi_841_ = u32();
                }
                let _e500 = phi_841_;
                continue;
                continuing {
                    phi_837_ = _e406;
                    phi_840_ = _e500;
                    break if !(_e412);
                }
            }
            phi_982_ = type_9(0u, 32u);
            let _e5018 = local_7;
            phi_985_ = _e5018;
            loop {
                let _e503 = phi_982_;
                let _e505 = phi_985_;
                if (_e503.member < _e503.member_1) {
                    phi_983_ = type_9((_e503.member + 1u), _e503.member_1);
                    phi_1008_ = type_9(1u, _e503.member);
                } else {
                    phi_983_ = _e503;
                    phi_1008_ = type_9(0u, type_9().member_1);
                }
                let _e517 = phi_983_;
                let _e519 = phi_1008_;
                if (bitcast<i32>(_e519.member) != 0i) {
                    if (_e505 == 0u) {
                        phi_2238_ = u32();
                        phi_2239_ = false;
                    } else {
                        let _e530 = names[((_e98 * 32u) + select(firstTrailingBit(_e505), 32u, (_e505 == 0u)))];
                        let _e533 = (_e223 + _e99);
                        let _e534 = (_e230 + _e530);
                        let _e536 = leaves.member[_e533];
                        let _e538 = leaves.member[_e534];
                        let _e540 = nodes.member[_e533];
                        let _e554 = nodes.member[_e534];
                        let _e569 = params.member.member.member_1;
                        if ((_e569 & 1u) != 0u) {
                            if (_e538.member[0] == _e536.member[0]) {
                                phi_1128_ = true;
                            } else {
                                phi_1128_ = (_e538.member[0] == _e536.member[1]);
                            }
                            let _e583 = phi_1128_;
                            if (_e538.member[1] == _e536.member[0]) {
                                phi_1134_ = true;
                            } else {
                                phi_1134_ = (_e538.member[1] == _e536.member[1]);
                            }
                            let _e587 = phi_1134_;
                            if (_e583 || _e587) {
                                phi_1140_ = false;
                            } else {
                                phi_1140_ = true;
                            }
                            let _e590 = phi_1140_;
                            phi_1141_ = _e590;
                        } else {
                            phi_1141_ = true;
                        }
                        let _e592 = phi_1141_;
                        if _e592 {
                            let _e594 = params.member.member.member_1;
                            if ((_e594 & 2u) != 0u) {
                                let _e600 = bodies.member[_e536.member[0]];
                                let _e604 = bodies.member[_e538.member[0]];
                                if ((_e600 / 4u) != (_e604 / 4u)) {
                                    phi_1186_ = true;
                                } else {
                                    if ((_e600 & 2u) == 0u) {
                                        phi_1185_ = false;
                                    } else {
                                        phi_1185_ = true;
                                    }
                                    let _e611 = phi_1185_;
                                    phi_1186_ = _e611;
                                }
                                let _e613 = phi_1186_;
                                if _e613 {
                                    phi_1193_ = (((_e600 & _e604) & 1u) == 0u);
                                } else {
                                    phi_1193_ = false;
                                }
                                let _e618 = phi_1193_;
                                if _e618 {
                                    let _e620 = params.member.member.member_1;
                                    if ((_e620 & 4u) != 0u) {
                                        let _e625 = params.member.member.member[0u];
                                        let _e627 = bodies.member[_e625];
                                        let _e630 = bodies.member[(_e625 + 1u)];
                                        let _e635 = ((_e625 + 4u) + (2u * (_e600 >> bitcast<u32>(2i))));
                                        let _e640 = ((_e625 + 4u) + (2u * (_e604 >> bitcast<u32>(2i))));
                                        let _e642 = bodies.member[_e635];
                                        let _e644 = bodies.member[_e640];
                                        let _e653 = bodies.member[((((_e625 + 4u) + (2u * _e627)) + (_e642 * _e630)) + (_e644 / 32u))];
                                        let _e656 = bodies.member[(_e635 + 1u)];
                                        let _e659 = bodies.member[(_e640 + 1u)];
                                        if (_e656 == _e659) {
                                            if (((_e653 >> bitcast<u32>(((_e644 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_1309_ = true;
                                            } else {
                                                phi_1309_ = ((_e600 >> bitcast<u32>(2i)) == (_e604 >> bitcast<u32>(2i)));
                                            }
                                            let _e673 = phi_1309_;
                                            phi_1310_ = _e673;
                                        } else {
                                            phi_1310_ = false;
                                        }
                                        let _e675 = phi_1310_;
                                        if _e675 {
                                            let _e680 = bodies.member[(_e625 + 2u)];
                                            let _e683 = bodies.member[(_e625 + 3u)];
                                            let _e684 = (_e683 + _e625);
                                            if (_e538.member_1 < _e536.member_1) {
                                                phi_1347_ = _e536.member_1;
                                                phi_1348_ = _e538.member_1;
                                            } else {
                                                phi_1347_ = _e538.member_1;
                                                phi_1348_ = _e536.member_1;
                                            }
                                            let _e687 = phi_1347_;
                                            let _e689 = phi_1348_;
                                            phi_1353_ = type_15(0i, 32i);
                                            phi_1356_ = _e680;
                                            phi_1358_ = 0u;
                                            loop {
                                                let _e691 = phi_1353_;
                                                let _e693 = phi_1356_;
                                                let _e695 = phi_1358_;
                                                local_3 = _e695;
                                                local_4 = _e695;
                                                if (_e691.member < _e691.member_1) {
                                                    let _e702 = (_e691.member + 1i);
                                                    if ((false == (_e702 > _e691.member)) != false) {
                                                        phi_1379_ = true;
                                                    } else {
                                                        phi_1379_ = false;
                                                    }
                                                    let _e707 = phi_1379_;
                                                    if _e707 {
                                                        phi_1385_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_1385_ = type_16(1u, _e702);
                                                    }
                                                    let _e712 = phi_1385_;
                                                    phi_1354_ = type_15(_e712.member_1, _e691.member_1);
                                                    phi_1399_ = type_16(1u, _e691.member);
                                                } else {
                                                    phi_1354_ = _e691;
                                                    phi_1399_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e718 = phi_1354_;
                                                let _e720 = phi_1399_;
                                                if (bitcast<i32>(_e720.member) != 0i) {
                                                    if (_e695 >= _e693) {
                                                        phi_1482_ = u32();
                                                        phi_1483_ = u32();
                                                        phi_1484_ = false;
                                                    } else {
                                                        let _e727 = (_e695 + ((_e693 - _e695) / 2u));
                                                        let _e729 = (_e684 + (3u * _e727));
                                                        let _e731 = bodies.member[_e729];
                                                        let _e734 = bodies.member[(_e729 + 1u)];
                                                        let _e737 = bodies.member[(_e729 + 2u)];
                                                        if (_e731 < 1u) {
                                                            phi_1475_ = true;
                                                        } else {
                                                            if (_e731 == 1u) {
                                                                if (_e734 < _e689) {
                                                                    phi_1469_ = false;
                                                                } else {
                                                                    if (_e734 == _e689) {
                                                                        if (_e737 < _e687) {
                                                                            phi_1467_ = false;
                                                                        } else {
                                                                            phi_1467_ = true;
                                                                        }
                                                                        let _e744 = phi_1467_;
                                                                        phi_1468_ = _e744;
                                                                    } else {
                                                                        phi_1468_ = true;
                                                                    }
                                                                    let _e746 = phi_1468_;
                                                                    phi_1469_ = _e746;
                                                                }
                                                                let _e748 = phi_1469_;
                                                                phi_1470_ = _e748;
                                                            } else {
                                                                phi_1470_ = true;
                                                            }
                                                            let _e750 = phi_1470_;
                                                            if _e750 {
                                                                phi_1474_ = false;
                                                            } else {
                                                                phi_1474_ = true;
                                                            }
                                                            let _e752 = phi_1474_;
                                                            phi_1475_ = _e752;
                                                        }
                                                        let _e754 = phi_1475_;
                                                        if _e754 {
                                                            phi_1480_ = _e693;
                                                            phi_1481_ = (_e727 + 1u);
                                                        } else {
                                                            phi_1480_ = _e727;
                                                            phi_1481_ = _e695;
                                                        }
                                                        let _e757 = phi_1480_;
                                                        let _e759 = phi_1481_;
                                                        phi_1482_ = _e757;
                                                        phi_1483_ = _e759;
                                                        phi_1484_ = true;
                                                    }
                                                    let _e761 = phi_1482_;
                                                    let _e763 = phi_1483_;
                                                    let _e765 = phi_1484_;
                                                    phi_1357_ = _e761;
                                                    phi_1359_ = _e763;
                                                    phi_1485_ = _e765;
                                                } else {
                                                    phi_1357_ = u32();
                                                    phi_1359_ = u32();
                                                    phi_1485_ = false;
                                                }
                                                let _e767 = phi_1357_;
                                                let _e769 = phi_1359_;
                                                let _e771 = phi_1485_;
                                                continue;
                                                continuing {
                                                    phi_1353_ = _e718;
                                                    phi_1356_ = _e767;
                                                    phi_1358_ = _e769;
                                                    break if !(_e771);
                                                }
                                            }
                                            let _e774 = local_3;
                                            if (_e774 < _e680) {
                                                let _e777 = local_4;
                                                let _e779 = (_e684 + (3u * _e777));
                                                let _e781 = bodies.member[_e779];
                                                if (_e781 == 1u) {
                                                    let _e785 = bodies.member[(_e779 + 1u)];
                                                    if (_e785 == _e689) {
                                                        let _e789 = bodies.member[(_e779 + 2u)];
                                                        phi_1533_ = (_e789 == _e687);
                                                        phi_1534_ = false;
                                                    } else {
                                                        phi_1533_ = bool();
                                                        phi_1534_ = true;
                                                    }
                                                    let _e792 = phi_1533_;
                                                    let _e794 = phi_1534_;
                                                    phi_1535_ = _e792;
                                                    phi_1536_ = _e794;
                                                } else {
                                                    phi_1535_ = bool();
                                                    phi_1536_ = true;
                                                }
                                                let _e796 = phi_1535_;
                                                let _e798 = phi_1536_;
                                                if _e798 {
                                                    phi_1540_ = false;
                                                } else {
                                                    phi_1540_ = _e796;
                                                }
                                                let _e800 = phi_1540_;
                                                phi_1541_ = _e800;
                                            } else {
                                                phi_1541_ = false;
                                            }
                                            let _e802 = phi_1541_;
                                            phi_1545_ = _e802;
                                        } else {
                                            phi_1545_ = true;
                                        }
                                        let _e804 = phi_1545_;
                                        if _e804 {
                                            phi_1549_ = false;
                                        } else {
                                            phi_1549_ = true;
                                        }
                                        let _e806 = phi_1549_;
                                        phi_1550_ = _e806;
                                    } else {
                                        phi_1550_ = true;
                                    }
                                    let _e808 = phi_1550_;
                                    if _e808 {
                                        phi_1554_ = false;
                                    } else {
                                        phi_1554_ = true;
                                    }
                                    let _e810 = phi_1554_;
                                    phi_1555_ = _e810;
                                } else {
                                    phi_1555_ = true;
                                }
                                let _e812 = phi_1555_;
                                if _e812 {
                                    phi_1559_ = false;
                                } else {
                                    phi_1559_ = true;
                                }
                                let _e814 = phi_1559_;
                                phi_1560_ = _e814;
                            } else {
                                phi_1560_ = true;
                            }
                            let _e816 = phi_1560_;
                            if _e816 {
                                let _e818 = params.member.member.member_1;
                                if ((_e818 & 32u) != 0u) {
                                    let _e822 = params.member.member.member_6;
                                    let _e839 = (((((_e540.member_1.y - _e554.member.x) > _e822) && ((_e554.member_1.y - _e540.member.x) > _e822)) && (((_e540.member_2.x - _e554.member.y) > _e822) && ((_e554.member_2.x - _e540.member.y) > _e822))) && (((_e540.member_2.y - _e554.member_1.x) > _e822) && ((_e554.member_2.y - _e540.member_1.x) > _e822)));
                                    if _e839 {
                                        phi_2162_ = bool();
                                    } else {
                                        let _e843 = keys.member[_e536.member[0]];
                                        let _e848 = keys.member[_e536.member[1]];
                                        let _e850 = function_(_e843[0], _e848[0]);
                                        let _e854 = keys.member[_e536.member[2]];
                                        let _e856 = function_(_e850, _e854[0]);
                                        let _e860 = keys.member[_e538.member[0]];
                                        let _e865 = keys.member[_e538.member[1]];
                                        let _e867 = function_1(_e860[3], _e865[3]);
                                        let _e871 = keys.member[_e538.member[2]];
                                        let _e873 = function_1(_e867, _e871[3]);
                                        if (_e856[1] > _e873[1]) {
                                            phi_1685_ = true;
                                        } else {
                                            if (_e856[1] == _e873[1]) {
                                                phi_1684_ = (_e856[0] > _e873[0]);
                                            } else {
                                                phi_1684_ = false;
                                            }
                                            let _e884 = phi_1684_;
                                            phi_1685_ = _e884;
                                        }
                                        let _e886 = phi_1685_;
                                        let _e891 = keys.member[_e538.member[0]];
                                        let _e896 = keys.member[_e538.member[1]];
                                        let _e898 = function_(_e891[0], _e896[0]);
                                        let _e902 = keys.member[_e538.member[2]];
                                        let _e904 = function_(_e898, _e902[0]);
                                        let _e908 = keys.member[_e536.member[0]];
                                        let _e913 = keys.member[_e536.member[1]];
                                        let _e915 = function_1(_e908[3], _e913[3]);
                                        let _e919 = keys.member[_e536.member[2]];
                                        let _e921 = function_1(_e915, _e919[3]);
                                        if (_e904[1] > _e921[1]) {
                                            phi_1779_ = true;
                                        } else {
                                            if (_e904[1] == _e921[1]) {
                                                phi_1778_ = (_e904[0] > _e921[0]);
                                            } else {
                                                phi_1778_ = false;
                                            }
                                            let _e932 = phi_1778_;
                                            phi_1779_ = _e932;
                                        }
                                        let _e934 = phi_1779_;
                                        let _e940 = keys.member[_e536.member[0]];
                                        let _e945 = keys.member[_e536.member[1]];
                                        let _e947 = function_2(_e940[1], _e945[1]);
                                        let _e951 = keys.member[_e536.member[2]];
                                        let _e953 = function_2(_e947, _e951[1]);
                                        let _e957 = keys.member[_e538.member[0]];
                                        let _e962 = keys.member[_e538.member[1]];
                                        let _e964 = function_3(_e957[4], _e962[4]);
                                        let _e968 = keys.member[_e538.member[2]];
                                        let _e970 = function_3(_e964, _e968[4]);
                                        if (_e953[1] > _e970[1]) {
                                            phi_1874_ = true;
                                        } else {
                                            if (_e953[1] == _e970[1]) {
                                                phi_1873_ = (_e953[0] > _e970[0]);
                                            } else {
                                                phi_1873_ = false;
                                            }
                                            let _e981 = phi_1873_;
                                            phi_1874_ = _e981;
                                        }
                                        let _e983 = phi_1874_;
                                        let _e988 = keys.member[_e538.member[0]];
                                        let _e993 = keys.member[_e538.member[1]];
                                        let _e995 = function_2(_e988[1], _e993[1]);
                                        let _e999 = keys.member[_e538.member[2]];
                                        let _e1001 = function_2(_e995, _e999[1]);
                                        let _e1005 = keys.member[_e536.member[0]];
                                        let _e1010 = keys.member[_e536.member[1]];
                                        let _e1012 = function_3(_e1005[4], _e1010[4]);
                                        let _e1016 = keys.member[_e536.member[2]];
                                        let _e1018 = function_3(_e1012, _e1016[4]);
                                        if (_e1001[1] > _e1018[1]) {
                                            phi_1968_ = true;
                                        } else {
                                            if (_e1001[1] == _e1018[1]) {
                                                phi_1967_ = (_e1001[0] > _e1018[0]);
                                            } else {
                                                phi_1967_ = false;
                                            }
                                            let _e1029 = phi_1967_;
                                            phi_1968_ = _e1029;
                                        }
                                        let _e1031 = phi_1968_;
                                        let _e1038 = keys.member[_e536.member[0]];
                                        let _e1043 = keys.member[_e536.member[1]];
                                        let _e1045 = function_4(_e1038[2], _e1043[2]);
                                        let _e1049 = keys.member[_e536.member[2]];
                                        let _e1051 = function_4(_e1045, _e1049[2]);
                                        let _e1055 = keys.member[_e538.member[0]];
                                        let _e1060 = keys.member[_e538.member[1]];
                                        let _e1062 = function_5(_e1055[5], _e1060[5]);
                                        let _e1066 = keys.member[_e538.member[2]];
                                        let _e1068 = function_5(_e1062, _e1066[5]);
                                        if (_e1051[1] > _e1068[1]) {
                                            phi_2064_ = true;
                                        } else {
                                            if (_e1051[1] == _e1068[1]) {
                                                phi_2063_ = (_e1051[0] > _e1068[0]);
                                            } else {
                                                phi_2063_ = false;
                                            }
                                            let _e1079 = phi_2063_;
                                            phi_2064_ = _e1079;
                                        }
                                        let _e1081 = phi_2064_;
                                        let _e1086 = keys.member[_e538.member[0]];
                                        let _e1091 = keys.member[_e538.member[1]];
                                        let _e1093 = function_4(_e1086[2], _e1091[2]);
                                        let _e1097 = keys.member[_e538.member[2]];
                                        let _e1099 = function_4(_e1093, _e1097[2]);
                                        let _e1103 = keys.member[_e536.member[0]];
                                        let _e1108 = keys.member[_e536.member[1]];
                                        let _e1110 = function_5(_e1103[5], _e1108[5]);
                                        let _e1114 = keys.member[_e536.member[2]];
                                        let _e1116 = function_5(_e1110, _e1114[5]);
                                        if (_e1099[1] > _e1116[1]) {
                                            phi_2158_ = true;
                                        } else {
                                            if (_e1099[1] == _e1116[1]) {
                                                phi_2157_ = (_e1099[0] > _e1116[0]);
                                            } else {
                                                phi_2157_ = false;
                                            }
                                            let _e1127 = phi_2157_;
                                            phi_2158_ = _e1127;
                                        }
                                        let _e1129 = phi_2158_;
                                        phi_2162_ = (((!(_e886) && !(_e934)) && (!(_e983) && !(_e1031))) && (!(_e1081) && !(_e1129)));
                                    }
                                    let _e1134 = phi_2162_;
                                    phi_2163_ = _e1134;
                                    phi_2164_ = _e839;
                                } else {
                                    phi_2163_ = bool();
                                    phi_2164_ = true;
                                }
                                let _e1136 = phi_2163_;
                                let _e1138 = phi_2164_;
                                if _e1138 {
                                    phi_2168_ = false;
                                } else {
                                    phi_2168_ = true;
                                }
                                let _e1140 = phi_2168_;
                                phi_2169_ = _e1136;
                                phi_2170_ = _e1140;
                            } else {
                                phi_2169_ = false;
                                phi_2170_ = true;
                            }
                            let _e1142 = phi_2169_;
                            let _e1144 = phi_2170_;
                            phi_2171_ = _e1142;
                            phi_2172_ = _e1144;
                        } else {
                            phi_2171_ = false;
                            phi_2172_ = true;
                        }
                        let _e1146 = phi_2171_;
                        let _e1148 = phi_2172_;
                        if _e1148 {
                            phi_2176_ = _e1146;
                        } else {
                            phi_2176_ = true;
                        }
                        let _e1150 = phi_2176_;
                        if _e1150 {
                            if (_e536.member_1 < _e538.member_1) {
                                phi_2192_ = type_9(_e536.member_1, _e538.member_1);
                            } else {
                                phi_2192_ = type_9(_e538.member_1, _e536.member_1);
                            }
                            let _e1157 = phi_2192_;
                            let _e1162 = params.member.member_1.member_3;
                            let _e1164 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1164 + 1u) < _e1164) {
                                let _e1168 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1164 < _e1162) {
                                let _e1170 = (2u * _e1164);
                                atomicStore((&output.member[(4u + _e1170)]), _e1157.member);
                                atomicStore((&output.member[(_e1170 + 5u)]), _e1157.member_1);
                            }
                            let _e1176 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1176 + 1u) < _e1176) {
                                let _e1180 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_2238_ = (_e505 & (_e505 - 1u));
                        phi_2239_ = true;
                    }
                    let _e1182 = phi_2238_;
                    let _e1184 = phi_2239_;
                    phi_986_ = _e1182;
                    phi_2240_ = _e1184;
                } else {
                    phi_986_ = u32();
                    phi_2240_ = false;
                }
                let _e1186 = phi_986_;
                let _e1188 = phi_2240_;
                continue;
                continuing {
                    phi_982_ = _e517;
                    phi_985_ = _e1186;
                    break if !(_e1188);
                }
            }
            workgroupBarrier();
            let _e1191 = atomicLoad((&counters[4u]));
            if (2048u < _e1191) {
                phi_2247_ = 2048u;
            } else {
                phi_2247_ = _e1191;
            }
            let _e1194 = phi_2247_;
            phi_2250_ = type_9(0u, 16u);
            loop {
                let _e1196 = phi_2250_;
                if (_e1196.member < _e1196.member_1) {
                    phi_2251_ = type_9((_e1196.member + 1u), _e1196.member_1);
                    phi_2274_ = type_9(1u, _e1196.member);
                } else {
                    phi_2251_ = _e1196;
                    phi_2274_ = type_9(0u, type_9().member_1);
                }
                let _e1208 = phi_2251_;
                let _e1210 = phi_2274_;
                if (bitcast<i32>(_e1210.member) != 0i) {
                    let _e1216 = (_e73 + (_e1210.member_1 * 128u));
                    if (_e1216 >= _e1194) {
                        phi_8677_ = false;
                    } else {
                        let _e1219 = hits[_e1216];
                        let _e1222 = ((_e1219 >> bitcast<u32>(10i)) & 3u);
                        let _e1229 = firsts[(2u * _e1222)];
                        let _e1230 = (_e1229 + ((_e1219 >> bitcast<u32>(5i)) & 31u));
                        let _e1234 = firsts[((2u * _e1222) + 1u)];
                        let _e1235 = (_e1234 + (_e1219 & 31u));
                        let _e1237 = leaves.member[_e1230];
                        let _e1239 = leaves.member[_e1235];
                        let _e1241 = nodes.member[_e1230];
                        let _e1255 = nodes.member[_e1235];
                        let _e1270 = params.member.member.member_1;
                        if ((_e1270 & 1u) != 0u) {
                            if (_e1239.member[0] == _e1237.member[0]) {
                                phi_2402_ = true;
                            } else {
                                phi_2402_ = (_e1239.member[0] == _e1237.member[1]);
                            }
                            let _e1284 = phi_2402_;
                            if (_e1239.member[1] == _e1237.member[0]) {
                                phi_2408_ = true;
                            } else {
                                phi_2408_ = (_e1239.member[1] == _e1237.member[1]);
                            }
                            let _e1288 = phi_2408_;
                            if (_e1284 || _e1288) {
                                phi_2414_ = false;
                            } else {
                                phi_2414_ = true;
                            }
                            let _e1291 = phi_2414_;
                            phi_2415_ = _e1291;
                        } else {
                            phi_2415_ = true;
                        }
                        let _e1293 = phi_2415_;
                        if _e1293 {
                            let _e1295 = params.member.member.member_1;
                            if ((_e1295 & 2u) != 0u) {
                                let _e1301 = bodies.member[_e1237.member[0]];
                                let _e1305 = bodies.member[_e1239.member[0]];
                                if ((_e1301 / 4u) != (_e1305 / 4u)) {
                                    phi_2460_ = true;
                                } else {
                                    if ((_e1301 & 2u) == 0u) {
                                        phi_2459_ = false;
                                    } else {
                                        phi_2459_ = true;
                                    }
                                    let _e1312 = phi_2459_;
                                    phi_2460_ = _e1312;
                                }
                                let _e1314 = phi_2460_;
                                if _e1314 {
                                    phi_2467_ = (((_e1301 & _e1305) & 1u) == 0u);
                                } else {
                                    phi_2467_ = false;
                                }
                                let _e1319 = phi_2467_;
                                if _e1319 {
                                    let _e1321 = params.member.member.member_1;
                                    if ((_e1321 & 4u) != 0u) {
                                        let _e1326 = params.member.member.member[0u];
                                        let _e1328 = bodies.member[_e1326];
                                        let _e1331 = bodies.member[(_e1326 + 1u)];
                                        let _e1336 = ((_e1326 + 4u) + (2u * (_e1301 >> bitcast<u32>(2i))));
                                        let _e1341 = ((_e1326 + 4u) + (2u * (_e1305 >> bitcast<u32>(2i))));
                                        let _e1343 = bodies.member[_e1336];
                                        let _e1345 = bodies.member[_e1341];
                                        let _e1354 = bodies.member[((((_e1326 + 4u) + (2u * _e1328)) + (_e1343 * _e1331)) + (_e1345 / 32u))];
                                        let _e1357 = bodies.member[(_e1336 + 1u)];
                                        let _e1360 = bodies.member[(_e1341 + 1u)];
                                        if (_e1357 == _e1360) {
                                            if (((_e1354 >> bitcast<u32>(((_e1345 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_2583_ = true;
                                            } else {
                                                phi_2583_ = ((_e1301 >> bitcast<u32>(2i)) == (_e1305 >> bitcast<u32>(2i)));
                                            }
                                            let _e1374 = phi_2583_;
                                            phi_2584_ = _e1374;
                                        } else {
                                            phi_2584_ = false;
                                        }
                                        let _e1376 = phi_2584_;
                                        if _e1376 {
                                            let _e1381 = bodies.member[(_e1326 + 2u)];
                                            let _e1384 = bodies.member[(_e1326 + 3u)];
                                            let _e1385 = (_e1384 + _e1326);
                                            if (_e1239.member_1 < _e1237.member_1) {
                                                phi_2621_ = _e1237.member_1;
                                                phi_2622_ = _e1239.member_1;
                                            } else {
                                                phi_2621_ = _e1239.member_1;
                                                phi_2622_ = _e1237.member_1;
                                            }
                                            let _e1388 = phi_2621_;
                                            let _e1390 = phi_2622_;
                                            phi_2627_ = type_15(0i, 32i);
                                            phi_2630_ = _e1381;
                                            phi_2632_ = 0u;
                                            loop {
                                                let _e1392 = phi_2627_;
                                                let _e1394 = phi_2630_;
                                                let _e1396 = phi_2632_;
                                                local_5 = _e1396;
                                                local_6 = _e1396;
                                                if (_e1392.member < _e1392.member_1) {
                                                    let _e1403 = (_e1392.member + 1i);
                                                    if ((false == (_e1403 > _e1392.member)) != false) {
                                                        phi_2653_ = true;
                                                    } else {
                                                        phi_2653_ = false;
                                                    }
                                                    let _e1408 = phi_2653_;
                                                    if _e1408 {
                                                        phi_2659_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_2659_ = type_16(1u, _e1403);
                                                    }
                                                    let _e1413 = phi_2659_;
                                                    phi_2628_ = type_15(_e1413.member_1, _e1392.member_1);
                                                    phi_2673_ = type_16(1u, _e1392.member);
                                                } else {
                                                    phi_2628_ = _e1392;
                                                    phi_2673_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e1419 = phi_2628_;
                                                let _e1421 = phi_2673_;
                                                if (bitcast<i32>(_e1421.member) != 0i) {
                                                    if (_e1396 >= _e1394) {
                                                        phi_2756_ = u32();
                                                        phi_2757_ = u32();
                                                        phi_2758_ = false;
                                                    } else {
                                                        let _e1428 = (_e1396 + ((_e1394 - _e1396) / 2u));
                                                        let _e1430 = (_e1385 + (3u * _e1428));
                                                        let _e1432 = bodies.member[_e1430];
                                                        let _e1435 = bodies.member[(_e1430 + 1u)];
                                                        let _e1438 = bodies.member[(_e1430 + 2u)];
                                                        if (_e1432 < 1u) {
                                                            phi_2749_ = true;
                                                        } else {
                                                            if (_e1432 == 1u) {
                                                                if (_e1435 < _e1390) {
                                                                    phi_2743_ = false;
                                                                } else {
                                                                    if (_e1435 == _e1390) {
                                                                        if (_e1438 < _e1388) {
                                                                            phi_2741_ = false;
                                                                        } else {
                                                                            phi_2741_ = true;
                                                                        }
                                                                        let _e1445 = phi_2741_;
                                                                        phi_2742_ = _e1445;
                                                                    } else {
                                                                        phi_2742_ = true;
                                                                    }
                                                                    let _e1447 = phi_2742_;
                                                                    phi_2743_ = _e1447;
                                                                }
                                                                let _e1449 = phi_2743_;
                                                                phi_2744_ = _e1449;
                                                            } else {
                                                                phi_2744_ = true;
                                                            }
                                                            let _e1451 = phi_2744_;
                                                            if _e1451 {
                                                                phi_2748_ = false;
                                                            } else {
                                                                phi_2748_ = true;
                                                            }
                                                            let _e1453 = phi_2748_;
                                                            phi_2749_ = _e1453;
                                                        }
                                                        let _e1455 = phi_2749_;
                                                        if _e1455 {
                                                            phi_2754_ = _e1394;
                                                            phi_2755_ = (_e1428 + 1u);
                                                        } else {
                                                            phi_2754_ = _e1428;
                                                            phi_2755_ = _e1396;
                                                        }
                                                        let _e1458 = phi_2754_;
                                                        let _e1460 = phi_2755_;
                                                        phi_2756_ = _e1458;
                                                        phi_2757_ = _e1460;
                                                        phi_2758_ = true;
                                                    }
                                                    let _e1462 = phi_2756_;
                                                    let _e1464 = phi_2757_;
                                                    let _e1466 = phi_2758_;
                                                    phi_2631_ = _e1462;
                                                    phi_2633_ = _e1464;
                                                    phi_2759_ = _e1466;
                                                } else {
                                                    phi_2631_ = u32();
                                                    phi_2633_ = u32();
                                                    phi_2759_ = false;
                                                }
                                                let _e1468 = phi_2631_;
                                                let _e1470 = phi_2633_;
                                                let _e1472 = phi_2759_;
                                                continue;
                                                continuing {
                                                    phi_2627_ = _e1419;
                                                    phi_2630_ = _e1468;
                                                    phi_2632_ = _e1470;
                                                    break if !(_e1472);
                                                }
                                            }
                                            let _e1475 = local_5;
                                            if (_e1475 < _e1381) {
                                                let _e1478 = local_6;
                                                let _e1480 = (_e1385 + (3u * _e1478));
                                                let _e1482 = bodies.member[_e1480];
                                                if (_e1482 == 1u) {
                                                    let _e1486 = bodies.member[(_e1480 + 1u)];
                                                    if (_e1486 == _e1390) {
                                                        let _e1490 = bodies.member[(_e1480 + 2u)];
                                                        phi_2807_ = (_e1490 == _e1388);
                                                        phi_2808_ = false;
                                                    } else {
                                                        phi_2807_ = bool();
                                                        phi_2808_ = true;
                                                    }
                                                    let _e1493 = phi_2807_;
                                                    let _e1495 = phi_2808_;
                                                    phi_2809_ = _e1493;
                                                    phi_2810_ = _e1495;
                                                } else {
                                                    phi_2809_ = bool();
                                                    phi_2810_ = true;
                                                }
                                                let _e1497 = phi_2809_;
                                                let _e1499 = phi_2810_;
                                                if _e1499 {
                                                    phi_2814_ = false;
                                                } else {
                                                    phi_2814_ = _e1497;
                                                }
                                                let _e1501 = phi_2814_;
                                                phi_2815_ = _e1501;
                                            } else {
                                                phi_2815_ = false;
                                            }
                                            let _e1503 = phi_2815_;
                                            phi_2819_ = _e1503;
                                        } else {
                                            phi_2819_ = true;
                                        }
                                        let _e1505 = phi_2819_;
                                        if _e1505 {
                                            phi_2823_ = false;
                                        } else {
                                            phi_2823_ = true;
                                        }
                                        let _e1507 = phi_2823_;
                                        phi_2824_ = _e1507;
                                    } else {
                                        phi_2824_ = true;
                                    }
                                    let _e1509 = phi_2824_;
                                    if _e1509 {
                                        phi_2828_ = false;
                                    } else {
                                        phi_2828_ = true;
                                    }
                                    let _e1511 = phi_2828_;
                                    phi_2829_ = _e1511;
                                } else {
                                    phi_2829_ = true;
                                }
                                let _e1513 = phi_2829_;
                                if _e1513 {
                                    phi_2833_ = false;
                                } else {
                                    phi_2833_ = true;
                                }
                                let _e1515 = phi_2833_;
                                phi_2834_ = _e1515;
                            } else {
                                phi_2834_ = true;
                            }
                            let _e1517 = phi_2834_;
                            if _e1517 {
                                let _e1519 = params.member.member.member_1;
                                if ((_e1519 & 32u) != 0u) {
                                    let _e1523 = params.member.member.member_6;
                                    let _e1540 = (((((_e1241.member_1.y - _e1255.member.x) > _e1523) && ((_e1255.member_1.y - _e1241.member.x) > _e1523)) && (((_e1241.member_2.x - _e1255.member.y) > _e1523) && ((_e1255.member_2.x - _e1241.member.y) > _e1523))) && (((_e1241.member_2.y - _e1255.member_1.x) > _e1523) && ((_e1255.member_2.y - _e1241.member_1.x) > _e1523)));
                                    if _e1540 {
                                        phi_3436_ = bool();
                                    } else {
                                        let _e1544 = keys.member[_e1237.member[0]];
                                        let _e1549 = keys.member[_e1237.member[1]];
                                        let _e1551 = function_(_e1544[0], _e1549[0]);
                                        let _e1555 = keys.member[_e1237.member[2]];
                                        let _e1557 = function_(_e1551, _e1555[0]);
                                        let _e1561 = keys.member[_e1239.member[0]];
                                        let _e1566 = keys.member[_e1239.member[1]];
                                        let _e1568 = function_1(_e1561[3], _e1566[3]);
                                        let _e1572 = keys.member[_e1239.member[2]];
                                        let _e1574 = function_1(_e1568, _e1572[3]);
                                        if (_e1557[1] > _e1574[1]) {
                                            phi_2959_ = true;
                                        } else {
                                            if (_e1557[1] == _e1574[1]) {
                                                phi_2958_ = (_e1557[0] > _e1574[0]);
                                            } else {
                                                phi_2958_ = false;
                                            }
                                            let _e1585 = phi_2958_;
                                            phi_2959_ = _e1585;
                                        }
                                        let _e1587 = phi_2959_;
                                        let _e1592 = keys.member[_e1239.member[0]];
                                        let _e1597 = keys.member[_e1239.member[1]];
                                        let _e1599 = function_(_e1592[0], _e1597[0]);
                                        let _e1603 = keys.member[_e1239.member[2]];
                                        let _e1605 = function_(_e1599, _e1603[0]);
                                        let _e1609 = keys.member[_e1237.member[0]];
                                        let _e1614 = keys.member[_e1237.member[1]];
                                        let _e1616 = function_1(_e1609[3], _e1614[3]);
                                        let _e1620 = keys.member[_e1237.member[2]];
                                        let _e1622 = function_1(_e1616, _e1620[3]);
                                        if (_e1605[1] > _e1622[1]) {
                                            phi_3053_ = true;
                                        } else {
                                            if (_e1605[1] == _e1622[1]) {
                                                phi_3052_ = (_e1605[0] > _e1622[0]);
                                            } else {
                                                phi_3052_ = false;
                                            }
                                            let _e1633 = phi_3052_;
                                            phi_3053_ = _e1633;
                                        }
                                        let _e1635 = phi_3053_;
                                        let _e1641 = keys.member[_e1237.member[0]];
                                        let _e1646 = keys.member[_e1237.member[1]];
                                        let _e1648 = function_2(_e1641[1], _e1646[1]);
                                        let _e1652 = keys.member[_e1237.member[2]];
                                        let _e1654 = function_2(_e1648, _e1652[1]);
                                        let _e1658 = keys.member[_e1239.member[0]];
                                        let _e1663 = keys.member[_e1239.member[1]];
                                        let _e1665 = function_3(_e1658[4], _e1663[4]);
                                        let _e1669 = keys.member[_e1239.member[2]];
                                        let _e1671 = function_3(_e1665, _e1669[4]);
                                        if (_e1654[1] > _e1671[1]) {
                                            phi_3148_ = true;
                                        } else {
                                            if (_e1654[1] == _e1671[1]) {
                                                phi_3147_ = (_e1654[0] > _e1671[0]);
                                            } else {
                                                phi_3147_ = false;
                                            }
                                            let _e1682 = phi_3147_;
                                            phi_3148_ = _e1682;
                                        }
                                        let _e1684 = phi_3148_;
                                        let _e1689 = keys.member[_e1239.member[0]];
                                        let _e1694 = keys.member[_e1239.member[1]];
                                        let _e1696 = function_2(_e1689[1], _e1694[1]);
                                        let _e1700 = keys.member[_e1239.member[2]];
                                        let _e1702 = function_2(_e1696, _e1700[1]);
                                        let _e1706 = keys.member[_e1237.member[0]];
                                        let _e1711 = keys.member[_e1237.member[1]];
                                        let _e1713 = function_3(_e1706[4], _e1711[4]);
                                        let _e1717 = keys.member[_e1237.member[2]];
                                        let _e1719 = function_3(_e1713, _e1717[4]);
                                        if (_e1702[1] > _e1719[1]) {
                                            phi_3242_ = true;
                                        } else {
                                            if (_e1702[1] == _e1719[1]) {
                                                phi_3241_ = (_e1702[0] > _e1719[0]);
                                            } else {
                                                phi_3241_ = false;
                                            }
                                            let _e1730 = phi_3241_;
                                            phi_3242_ = _e1730;
                                        }
                                        let _e1732 = phi_3242_;
                                        let _e1739 = keys.member[_e1237.member[0]];
                                        let _e1744 = keys.member[_e1237.member[1]];
                                        let _e1746 = function_4(_e1739[2], _e1744[2]);
                                        let _e1750 = keys.member[_e1237.member[2]];
                                        let _e1752 = function_4(_e1746, _e1750[2]);
                                        let _e1756 = keys.member[_e1239.member[0]];
                                        let _e1761 = keys.member[_e1239.member[1]];
                                        let _e1763 = function_5(_e1756[5], _e1761[5]);
                                        let _e1767 = keys.member[_e1239.member[2]];
                                        let _e1769 = function_5(_e1763, _e1767[5]);
                                        if (_e1752[1] > _e1769[1]) {
                                            phi_3338_ = true;
                                        } else {
                                            if (_e1752[1] == _e1769[1]) {
                                                phi_3337_ = (_e1752[0] > _e1769[0]);
                                            } else {
                                                phi_3337_ = false;
                                            }
                                            let _e1780 = phi_3337_;
                                            phi_3338_ = _e1780;
                                        }
                                        let _e1782 = phi_3338_;
                                        let _e1787 = keys.member[_e1239.member[0]];
                                        let _e1792 = keys.member[_e1239.member[1]];
                                        let _e1794 = function_4(_e1787[2], _e1792[2]);
                                        let _e1798 = keys.member[_e1239.member[2]];
                                        let _e1800 = function_4(_e1794, _e1798[2]);
                                        let _e1804 = keys.member[_e1237.member[0]];
                                        let _e1809 = keys.member[_e1237.member[1]];
                                        let _e1811 = function_5(_e1804[5], _e1809[5]);
                                        let _e1815 = keys.member[_e1237.member[2]];
                                        let _e1817 = function_5(_e1811, _e1815[5]);
                                        if (_e1800[1] > _e1817[1]) {
                                            phi_3432_ = true;
                                        } else {
                                            if (_e1800[1] == _e1817[1]) {
                                                phi_3431_ = (_e1800[0] > _e1817[0]);
                                            } else {
                                                phi_3431_ = false;
                                            }
                                            let _e1828 = phi_3431_;
                                            phi_3432_ = _e1828;
                                        }
                                        let _e1830 = phi_3432_;
                                        phi_3436_ = (((!(_e1587) && !(_e1635)) && (!(_e1684) && !(_e1732))) && (!(_e1782) && !(_e1830)));
                                    }
                                    let _e1835 = phi_3436_;
                                    phi_3437_ = _e1835;
                                    phi_3438_ = _e1540;
                                } else {
                                    phi_3437_ = bool();
                                    phi_3438_ = true;
                                }
                                let _e1837 = phi_3437_;
                                let _e1839 = phi_3438_;
                                if _e1839 {
                                    phi_3442_ = false;
                                } else {
                                    phi_3442_ = true;
                                }
                                let _e1841 = phi_3442_;
                                phi_3443_ = _e1837;
                                phi_3444_ = _e1841;
                            } else {
                                phi_3443_ = false;
                                phi_3444_ = true;
                            }
                            let _e1843 = phi_3443_;
                            let _e1845 = phi_3444_;
                            phi_3445_ = _e1843;
                            phi_3446_ = _e1845;
                        } else {
                            phi_3445_ = false;
                            phi_3446_ = true;
                        }
                        let _e1847 = phi_3445_;
                        let _e1849 = phi_3446_;
                        if _e1849 {
                            phi_3450_ = _e1847;
                        } else {
                            phi_3450_ = true;
                        }
                        let _e1851 = phi_3450_;
                        if _e1851 {
                            let _e1853 = atomicAdd((&counters[7u]), 1u);
                            if (_e1237.member_1 < _e1239.member_1) {
                                phi_3467_ = _e1239.member;
                                phi_3468_ = _e1237.member;
                            } else {
                                phi_3467_ = _e1237.member;
                                phi_3468_ = _e1239.member;
                            }
                            let _e1863 = phi_3467_;
                            let _e1865 = phi_3468_;
                            let _e1871 = params.member.member.member_4;
                            let _e1873 = params.member.member.member_5;
                            let _e1875 = paths.member[_e1865[0]];
                            let _e1877 = paths.member[_e1865[1]];
                            let _e1883 = paths.member[_e1863[0]];
                            let _e1885 = paths.member[_e1863[1]];
                            local_2 = type_41(array<array<f32, 3>, 2>(array<f32, 3>((_e1883.member[0] - _e1875.member[0]), (_e1883.member[1] - _e1875.member[1]), (_e1883.member[2] - _e1875.member[2])), array<f32, 3>((_e1883.member_1[0] - _e1875.member_1[0]), (_e1883.member_1[1] - _e1875.member_1[1]), (_e1883.member_1[2] - _e1875.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1877.member[0] - _e1875.member[0]), (_e1877.member[1] - _e1875.member[1]), (_e1877.member[2] - _e1875.member[2])), array<f32, 3>((_e1877.member_1[0] - _e1875.member_1[0]), (_e1877.member_1[1] - _e1875.member_1[1]), (_e1877.member_1[2] - _e1875.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1883.member[0] - _e1885.member[0]), (_e1883.member[1] - _e1885.member[1]), (_e1883.member[2] - _e1885.member[2])), array<f32, 3>((_e1883.member_1[0] - _e1885.member_1[0]), (_e1883.member_1[1] - _e1885.member_1[1]), (_e1883.member_1[2] - _e1885.member_1[2]))), (_e1871 + _e1871));
                            let _e1945 = local_2.member_1[0u];
                            let _e1951 = local_2.member_2[0u];
                            let _e1957 = ((_e1945[1] * _e1951[2]) - (_e1945[2] * _e1951[1]));
                            let _e1960 = ((_e1945[2] * _e1951[0]) - (_e1945[0] * _e1951[2]));
                            let _e1963 = ((_e1945[0] * _e1951[1]) - (_e1945[1] * _e1951[0]));
                            let _e1966 = local_2.member_1[1u];
                            let _e1972 = local_2.member_2[1u];
                            let _e1978 = ((_e1966[1] * _e1972[2]) - (_e1966[2] * _e1972[1]));
                            let _e1981 = ((_e1966[2] * _e1972[0]) - (_e1966[0] * _e1972[2]));
                            let _e1984 = ((_e1966[0] * _e1972[1]) - (_e1966[1] * _e1972[0]));
                            let _e1987 = local_2.member_1[0u];
                            let _e1993 = local_2.member_2[1u];
                            let _e2008 = local_2.member_1[1u];
                            let _e2014 = local_2.member_2[0u];
                            let _e2027 = (((_e1987[1] * _e1993[2]) - (_e1987[2] * _e1993[1])) + ((_e2008[1] * _e2014[2]) - (_e2008[2] * _e2014[1])));
                            let _e2028 = (((_e1987[2] * _e1993[0]) - (_e1987[0] * _e1993[2])) + ((_e2008[2] * _e2014[0]) - (_e2008[0] * _e2014[2])));
                            let _e2029 = (((_e1987[0] * _e1993[1]) - (_e1987[1] * _e1993[0])) + ((_e2008[0] * _e2014[1]) - (_e2008[1] * _e2014[0])));
                            let _e2032 = local_2.member[0u];
                            let _e2043 = local_2.member[1u];
                            let _e2054 = local_2.member[0u];
                            let _e2063 = ((((_e2043[0] * _e1957) + (_e2043[1] * _e1960)) + (_e2043[2] * _e1963)) + (((_e2054[0] * _e2027) + (_e2054[1] * _e2028)) + (_e2054[2] * _e2029)));
                            let _e2066 = local_2.member[0u];
                            let _e2077 = local_2.member[1u];
                            let _e2086 = ((((_e2066[0] * _e1978) + (_e2066[1] * _e1981)) + (_e2066[2] * _e1984)) + (((_e2077[0] * _e2027) + (_e2077[1] * _e2028)) + (_e2077[2] * _e2029)));
                            let _e2089 = local_2.member[1u];
                            let _e2100 = local_2.member[0u];
                            if (_e2100[0] < 0f) {
                                phi_3891_ = -(_e2100[0]);
                            } else {
                                phi_3891_ = _e2100[0];
                            }
                            let _e2107 = phi_3891_;
                            if (_e2100[1] < 0f) {
                                phi_3898_ = -(_e2100[1]);
                            } else {
                                phi_3898_ = _e2100[1];
                            }
                            let _e2111 = phi_3898_;
                            if (_e2107 > _e2111) {
                                phi_3903_ = _e2107;
                            } else {
                                phi_3903_ = _e2111;
                            }
                            let _e2114 = phi_3903_;
                            if (_e2100[2] < 0f) {
                                phi_3910_ = -(_e2100[2]);
                            } else {
                                phi_3910_ = _e2100[2];
                            }
                            let _e2118 = phi_3910_;
                            if (_e2114 > _e2118) {
                                phi_3915_ = _e2114;
                            } else {
                                phi_3915_ = _e2118;
                            }
                            let _e2121 = phi_3915_;
                            let _e2124 = local_2.member[1u];
                            if (_e2124[0] < 0f) {
                                phi_3928_ = -(_e2124[0]);
                            } else {
                                phi_3928_ = _e2124[0];
                            }
                            let _e2131 = phi_3928_;
                            if (_e2124[1] < 0f) {
                                phi_3935_ = -(_e2124[1]);
                            } else {
                                phi_3935_ = _e2124[1];
                            }
                            let _e2135 = phi_3935_;
                            if (_e2131 > _e2135) {
                                phi_3940_ = _e2131;
                            } else {
                                phi_3940_ = _e2135;
                            }
                            let _e2138 = phi_3940_;
                            if (_e2124[2] < 0f) {
                                phi_3947_ = -(_e2124[2]);
                            } else {
                                phi_3947_ = _e2124[2];
                            }
                            let _e2142 = phi_3947_;
                            if (_e2138 > _e2142) {
                                phi_3952_ = _e2138;
                            } else {
                                phi_3952_ = _e2142;
                            }
                            let _e2145 = phi_3952_;
                            if (_e2121 > _e2145) {
                                phi_3957_ = _e2121;
                            } else {
                                phi_3957_ = _e2145;
                            }
                            let _e2148 = phi_3957_;
                            let _e2150 = local_2.member_3;
                            let _e2151 = (_e2148 + _e2150);
                            let _e2154 = local_2.member_1[0u];
                            if (_e2154[0] < 0f) {
                                phi_3974_ = -(_e2154[0]);
                            } else {
                                phi_3974_ = _e2154[0];
                            }
                            let _e2161 = phi_3974_;
                            if (_e2154[1] < 0f) {
                                phi_3981_ = -(_e2154[1]);
                            } else {
                                phi_3981_ = _e2154[1];
                            }
                            let _e2165 = phi_3981_;
                            if (_e2161 > _e2165) {
                                phi_3986_ = _e2161;
                            } else {
                                phi_3986_ = _e2165;
                            }
                            let _e2168 = phi_3986_;
                            if (_e2154[2] < 0f) {
                                phi_3993_ = -(_e2154[2]);
                            } else {
                                phi_3993_ = _e2154[2];
                            }
                            let _e2172 = phi_3993_;
                            if (_e2168 > _e2172) {
                                phi_3998_ = _e2168;
                            } else {
                                phi_3998_ = _e2172;
                            }
                            let _e2175 = phi_3998_;
                            let _e2178 = local_2.member_1[1u];
                            if (_e2178[0] < 0f) {
                                phi_4012_ = -(_e2178[0]);
                            } else {
                                phi_4012_ = _e2178[0];
                            }
                            let _e2185 = phi_4012_;
                            if (_e2178[1] < 0f) {
                                phi_4019_ = -(_e2178[1]);
                            } else {
                                phi_4019_ = _e2178[1];
                            }
                            let _e2189 = phi_4019_;
                            if (_e2185 > _e2189) {
                                phi_4024_ = _e2185;
                            } else {
                                phi_4024_ = _e2189;
                            }
                            let _e2192 = phi_4024_;
                            if (_e2178[2] < 0f) {
                                phi_4031_ = -(_e2178[2]);
                            } else {
                                phi_4031_ = _e2178[2];
                            }
                            let _e2196 = phi_4031_;
                            if (_e2192 > _e2196) {
                                phi_4036_ = _e2192;
                            } else {
                                phi_4036_ = _e2196;
                            }
                            let _e2199 = phi_4036_;
                            if (_e2175 > _e2199) {
                                phi_4041_ = _e2175;
                            } else {
                                phi_4041_ = _e2199;
                            }
                            let _e2202 = phi_4041_;
                            let _e2204 = local_2.member_3;
                            let _e2205 = (_e2202 + _e2204);
                            let _e2208 = local_2.member_2[0u];
                            if (_e2208[0] < 0f) {
                                phi_4058_ = -(_e2208[0]);
                            } else {
                                phi_4058_ = _e2208[0];
                            }
                            let _e2215 = phi_4058_;
                            if (_e2208[1] < 0f) {
                                phi_4065_ = -(_e2208[1]);
                            } else {
                                phi_4065_ = _e2208[1];
                            }
                            let _e2219 = phi_4065_;
                            if (_e2215 > _e2219) {
                                phi_4070_ = _e2215;
                            } else {
                                phi_4070_ = _e2219;
                            }
                            let _e2222 = phi_4070_;
                            if (_e2208[2] < 0f) {
                                phi_4077_ = -(_e2208[2]);
                            } else {
                                phi_4077_ = _e2208[2];
                            }
                            let _e2226 = phi_4077_;
                            if (_e2222 > _e2226) {
                                phi_4082_ = _e2222;
                            } else {
                                phi_4082_ = _e2226;
                            }
                            let _e2229 = phi_4082_;
                            let _e2232 = local_2.member_2[1u];
                            if (_e2232[0] < 0f) {
                                phi_4096_ = -(_e2232[0]);
                            } else {
                                phi_4096_ = _e2232[0];
                            }
                            let _e2239 = phi_4096_;
                            if (_e2232[1] < 0f) {
                                phi_4103_ = -(_e2232[1]);
                            } else {
                                phi_4103_ = _e2232[1];
                            }
                            let _e2243 = phi_4103_;
                            if (_e2239 > _e2243) {
                                phi_4108_ = _e2239;
                            } else {
                                phi_4108_ = _e2243;
                            }
                            let _e2246 = phi_4108_;
                            if (_e2232[2] < 0f) {
                                phi_4115_ = -(_e2232[2]);
                            } else {
                                phi_4115_ = _e2232[2];
                            }
                            let _e2250 = phi_4115_;
                            if (_e2246 > _e2250) {
                                phi_4120_ = _e2246;
                            } else {
                                phi_4120_ = _e2250;
                            }
                            let _e2253 = phi_4120_;
                            if (_e2229 > _e2253) {
                                phi_4125_ = _e2229;
                            } else {
                                phi_4125_ = _e2253;
                            }
                            let _e2256 = phi_4125_;
                            let _e2258 = local_2.member_3;
                            let _e2259 = (_e2256 + _e2258);
                            let _e2261 = ((_e2205 * 8f) * _e2259);
                            let _e2268 = local_2.member_3;
                            if (_e1957 < 0f) {
                                phi_4156_ = -(_e1957);
                            } else {
                                phi_4156_ = _e1957;
                            }
                            let _e2285 = phi_4156_;
                            if (_e1960 < 0f) {
                                phi_4162_ = -(_e1960);
                            } else {
                                phi_4162_ = _e1960;
                            }
                            let _e2289 = phi_4162_;
                            if (_e1963 < 0f) {
                                phi_4169_ = -(_e1963);
                            } else {
                                phi_4169_ = _e1963;
                            }
                            let _e2294 = phi_4169_;
                            let _e2295 = ((_e2285 + _e2289) + _e2294);
                            if (_e1978 < 0f) {
                                phi_4176_ = -(_e1978);
                            } else {
                                phi_4176_ = _e1978;
                            }
                            let _e2299 = phi_4176_;
                            if (_e1981 < 0f) {
                                phi_4182_ = -(_e1981);
                            } else {
                                phi_4182_ = _e1981;
                            }
                            let _e2303 = phi_4182_;
                            if (_e1984 < 0f) {
                                phi_4189_ = -(_e1984);
                            } else {
                                phi_4189_ = _e1984;
                            }
                            let _e2308 = phi_4189_;
                            let _e2309 = ((_e2299 + _e2303) + _e2308);
                            if (_e2295 > _e2309) {
                                phi_4195_ = _e2295;
                            } else {
                                phi_4195_ = _e2309;
                            }
                            let _e2312 = phi_4195_;
                            if (_e2027 < 0f) {
                                phi_4201_ = -(_e2027);
                            } else {
                                phi_4201_ = _e2027;
                            }
                            let _e2316 = phi_4201_;
                            if (_e2028 < 0f) {
                                phi_4207_ = -(_e2028);
                            } else {
                                phi_4207_ = _e2028;
                            }
                            let _e2320 = phi_4207_;
                            if (_e2029 < 0f) {
                                phi_4214_ = -(_e2029);
                            } else {
                                phi_4214_ = _e2029;
                            }
                            let _e2325 = phi_4214_;
                            let _e2327 = (((_e2316 + _e2320) + _e2325) * 0.5f);
                            if (_e2312 > _e2327) {
                                phi_4221_ = _e2312;
                            } else {
                                phi_4221_ = _e2327;
                            }
                            let _e2330 = phi_4221_;
                            let _e2335 = local_2.member_3;
                            let _e2348 = ((((_e2032[0] * _e1957) + (_e2032[1] * _e1960)) + (_e2032[2] * _e1963)) * 3f);
                            let _e2349 = ((((_e2089[0] * _e1978) + (_e2089[1] * _e1981)) + (_e2089[2] * _e1984)) * 3f);
                            if (_e2348 < _e2349) {
                                phi_4245_ = _e2348;
                            } else {
                                phi_4245_ = _e2349;
                            }
                            let _e2352 = phi_4245_;
                            if (_e2063 < _e2086) {
                                phi_4250_ = _e2063;
                            } else {
                                phi_4250_ = _e2086;
                            }
                            let _e2355 = phi_4250_;
                            if (_e2352 < _e2355) {
                                phi_4255_ = _e2352;
                            } else {
                                phi_4255_ = _e2355;
                            }
                            let _e2358 = phi_4255_;
                            if (_e2348 > _e2349) {
                                phi_4260_ = _e2348;
                            } else {
                                phi_4260_ = _e2349;
                            }
                            let _e2361 = phi_4260_;
                            if (_e2063 > _e2086) {
                                phi_4265_ = _e2063;
                            } else {
                                phi_4265_ = _e2086;
                            }
                            let _e2364 = phi_4265_;
                            if (_e2361 > _e2364) {
                                phi_4270_ = _e2361;
                            } else {
                                phi_4270_ = _e2364;
                            }
                            let _e2367 = phi_4270_;
                            let _e2372 = -(_e2367);
                            if (_e2358 > _e2372) {
                                phi_4280_ = _e2358;
                            } else {
                                phi_4280_ = _e2372;
                            }
                            let _e2375 = phi_4280_;
                            let _e2377 = ((_e2375 - ((((((_e2151 * 8f) * _e2261) * (0.000000059604645f * (524f / 64f))) + ((_e2268 * 19f) * ((_e2151 * (_e2205 + _e2259)) + (_e2205 * _e2259)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2151) * ((1f + _e2205) * (1f + _e2259))))) + ((_e1873 * (((_e2330 + (_e2261 * (0.000000059604645f * 8f))) + ((_e2335 * 6f) * (_e2205 + _e2259))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2205) * (1f + _e2259))))) * (3f * 1.0001f)))) > 0f);
                            if _e2377 {
                                phi_5249_ = _e2377;
                            } else {
                                let _e2380 = local_2.member_1[0u];
                                let _e2386 = local_2.member_1[1u];
                                let _e2390 = (_e2380[0] + _e2386[0]);
                                let _e2391 = (_e2380[1] + _e2386[1]);
                                let _e2392 = (_e2380[2] + _e2386[2]);
                                let _e2395 = local_2.member_2[0u];
                                let _e2401 = local_2.member_2[1u];
                                let _e2405 = (_e2395[0] + _e2401[0]);
                                let _e2406 = (_e2395[1] + _e2401[1]);
                                let _e2407 = (_e2395[2] + _e2401[2]);
                                let _e2410 = ((_e2391 * _e2407) - (_e2392 * _e2406));
                                let _e2413 = ((_e2392 * _e2405) - (_e2390 * _e2407));
                                let _e2416 = ((_e2390 * _e2406) - (_e2391 * _e2405));
                                let _e2419 = local_2.member[0u];
                                let _e2425 = local_2.member_1[0u];
                                let _e2431 = local_2.member_2[0u];
                                let _e2435 = (_e2419[0] - _e2425[0]);
                                let _e2436 = (_e2419[1] - _e2425[1]);
                                let _e2437 = (_e2419[2] - _e2425[2]);
                                let _e2438 = (_e2435 - _e2431[0]);
                                let _e2439 = (_e2436 - _e2431[1]);
                                let _e2440 = (_e2437 - _e2431[2]);
                                let _e2441 = (_e2419[0] - _e2431[0]);
                                let _e2442 = (_e2419[1] - _e2431[1]);
                                let _e2443 = (_e2419[2] - _e2431[2]);
                                let _e2446 = local_2.member[1u];
                                let _e2452 = local_2.member_1[1u];
                                let _e2458 = local_2.member_2[1u];
                                let _e2462 = (_e2446[0] - _e2452[0]);
                                let _e2463 = (_e2446[1] - _e2452[1]);
                                let _e2464 = (_e2446[2] - _e2452[2]);
                                let _e2465 = (_e2462 - _e2458[0]);
                                let _e2466 = (_e2463 - _e2458[1]);
                                let _e2467 = (_e2464 - _e2458[2]);
                                let _e2468 = (_e2446[0] - _e2458[0]);
                                let _e2469 = (_e2446[1] - _e2458[1]);
                                let _e2470 = (_e2446[2] - _e2458[2]);
                                let _e2473 = local_2.member[0u];
                                if (_e2473[0] < 0f) {
                                    phi_4483_ = -(_e2473[0]);
                                } else {
                                    phi_4483_ = _e2473[0];
                                }
                                let _e2480 = phi_4483_;
                                if (_e2473[1] < 0f) {
                                    phi_4490_ = -(_e2473[1]);
                                } else {
                                    phi_4490_ = _e2473[1];
                                }
                                let _e2484 = phi_4490_;
                                if (_e2480 > _e2484) {
                                    phi_4495_ = _e2480;
                                } else {
                                    phi_4495_ = _e2484;
                                }
                                let _e2487 = phi_4495_;
                                if (_e2473[2] < 0f) {
                                    phi_4502_ = -(_e2473[2]);
                                } else {
                                    phi_4502_ = _e2473[2];
                                }
                                let _e2491 = phi_4502_;
                                if (_e2487 > _e2491) {
                                    phi_4507_ = _e2487;
                                } else {
                                    phi_4507_ = _e2491;
                                }
                                let _e2494 = phi_4507_;
                                let _e2497 = local_2.member[1u];
                                if (_e2497[0] < 0f) {
                                    phi_4520_ = -(_e2497[0]);
                                } else {
                                    phi_4520_ = _e2497[0];
                                }
                                let _e2504 = phi_4520_;
                                if (_e2497[1] < 0f) {
                                    phi_4527_ = -(_e2497[1]);
                                } else {
                                    phi_4527_ = _e2497[1];
                                }
                                let _e2508 = phi_4527_;
                                if (_e2504 > _e2508) {
                                    phi_4532_ = _e2504;
                                } else {
                                    phi_4532_ = _e2508;
                                }
                                let _e2511 = phi_4532_;
                                if (_e2497[2] < 0f) {
                                    phi_4539_ = -(_e2497[2]);
                                } else {
                                    phi_4539_ = _e2497[2];
                                }
                                let _e2515 = phi_4539_;
                                if (_e2511 > _e2515) {
                                    phi_4544_ = _e2511;
                                } else {
                                    phi_4544_ = _e2515;
                                }
                                let _e2518 = phi_4544_;
                                if (_e2494 > _e2518) {
                                    phi_4549_ = _e2494;
                                } else {
                                    phi_4549_ = _e2518;
                                }
                                let _e2521 = phi_4549_;
                                let _e2523 = local_2.member_3;
                                let _e2527 = local_2.member_1[0u];
                                if (_e2527[0] < 0f) {
                                    phi_4566_ = -(_e2527[0]);
                                } else {
                                    phi_4566_ = _e2527[0];
                                }
                                let _e2534 = phi_4566_;
                                if (_e2527[1] < 0f) {
                                    phi_4573_ = -(_e2527[1]);
                                } else {
                                    phi_4573_ = _e2527[1];
                                }
                                let _e2538 = phi_4573_;
                                if (_e2534 > _e2538) {
                                    phi_4578_ = _e2534;
                                } else {
                                    phi_4578_ = _e2538;
                                }
                                let _e2541 = phi_4578_;
                                if (_e2527[2] < 0f) {
                                    phi_4585_ = -(_e2527[2]);
                                } else {
                                    phi_4585_ = _e2527[2];
                                }
                                let _e2545 = phi_4585_;
                                if (_e2541 > _e2545) {
                                    phi_4590_ = _e2541;
                                } else {
                                    phi_4590_ = _e2545;
                                }
                                let _e2548 = phi_4590_;
                                let _e2551 = local_2.member_1[1u];
                                if (_e2551[0] < 0f) {
                                    phi_4604_ = -(_e2551[0]);
                                } else {
                                    phi_4604_ = _e2551[0];
                                }
                                let _e2558 = phi_4604_;
                                if (_e2551[1] < 0f) {
                                    phi_4611_ = -(_e2551[1]);
                                } else {
                                    phi_4611_ = _e2551[1];
                                }
                                let _e2562 = phi_4611_;
                                if (_e2558 > _e2562) {
                                    phi_4616_ = _e2558;
                                } else {
                                    phi_4616_ = _e2562;
                                }
                                let _e2565 = phi_4616_;
                                if (_e2551[2] < 0f) {
                                    phi_4623_ = -(_e2551[2]);
                                } else {
                                    phi_4623_ = _e2551[2];
                                }
                                let _e2569 = phi_4623_;
                                if (_e2565 > _e2569) {
                                    phi_4628_ = _e2565;
                                } else {
                                    phi_4628_ = _e2569;
                                }
                                let _e2572 = phi_4628_;
                                if (_e2548 > _e2572) {
                                    phi_4633_ = _e2548;
                                } else {
                                    phi_4633_ = _e2572;
                                }
                                let _e2575 = phi_4633_;
                                let _e2577 = local_2.member_3;
                                let _e2581 = local_2.member_2[0u];
                                if (_e2581[0] < 0f) {
                                    phi_4650_ = -(_e2581[0]);
                                } else {
                                    phi_4650_ = _e2581[0];
                                }
                                let _e2588 = phi_4650_;
                                if (_e2581[1] < 0f) {
                                    phi_4657_ = -(_e2581[1]);
                                } else {
                                    phi_4657_ = _e2581[1];
                                }
                                let _e2592 = phi_4657_;
                                if (_e2588 > _e2592) {
                                    phi_4662_ = _e2588;
                                } else {
                                    phi_4662_ = _e2592;
                                }
                                let _e2595 = phi_4662_;
                                if (_e2581[2] < 0f) {
                                    phi_4669_ = -(_e2581[2]);
                                } else {
                                    phi_4669_ = _e2581[2];
                                }
                                let _e2599 = phi_4669_;
                                if (_e2595 > _e2599) {
                                    phi_4674_ = _e2595;
                                } else {
                                    phi_4674_ = _e2599;
                                }
                                let _e2602 = phi_4674_;
                                let _e2605 = local_2.member_2[1u];
                                if (_e2605[0] < 0f) {
                                    phi_4688_ = -(_e2605[0]);
                                } else {
                                    phi_4688_ = _e2605[0];
                                }
                                let _e2612 = phi_4688_;
                                if (_e2605[1] < 0f) {
                                    phi_4695_ = -(_e2605[1]);
                                } else {
                                    phi_4695_ = _e2605[1];
                                }
                                let _e2616 = phi_4695_;
                                if (_e2612 > _e2616) {
                                    phi_4700_ = _e2612;
                                } else {
                                    phi_4700_ = _e2616;
                                }
                                let _e2619 = phi_4700_;
                                if (_e2605[2] < 0f) {
                                    phi_4707_ = -(_e2605[2]);
                                } else {
                                    phi_4707_ = _e2605[2];
                                }
                                let _e2623 = phi_4707_;
                                if (_e2619 > _e2623) {
                                    phi_4712_ = _e2619;
                                } else {
                                    phi_4712_ = _e2623;
                                }
                                let _e2626 = phi_4712_;
                                if (_e2602 > _e2626) {
                                    phi_4717_ = _e2602;
                                } else {
                                    phi_4717_ = _e2626;
                                }
                                let _e2629 = phi_4717_;
                                let _e2631 = local_2.member_3;
                                let _e2635 = ((((_e2521 + _e2523) + (_e2575 + _e2577)) + (_e2629 + _e2631)) * 2f);
                                let _e2638 = local_2.member_3;
                                let _e2642 = (((_e1873 * 1.0001f) + (_e2638 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2645 = ((_e2413 * _e2392) - (_e2416 * _e2391));
                                let _e2648 = ((_e2416 * _e2390) - (_e2410 * _e2392));
                                let _e2651 = ((_e2410 * _e2391) - (_e2413 * _e2390));
                                let _e2656 = (((_e2645 * _e2419[0]) + (_e2648 * _e2419[1])) + (_e2651 * _e2419[2]));
                                let _e2661 = (((_e2645 * _e2435) + (_e2648 * _e2436)) + (_e2651 * _e2437));
                                let _e2666 = (((_e2645 * _e2441) + (_e2648 * _e2442)) + (_e2651 * _e2443));
                                let _e2671 = (((_e2645 * _e2438) + (_e2648 * _e2439)) + (_e2651 * _e2440));
                                let _e2676 = (((_e2645 * _e2446[0]) + (_e2648 * _e2446[1])) + (_e2651 * _e2446[2]));
                                let _e2681 = (((_e2645 * _e2462) + (_e2648 * _e2463)) + (_e2651 * _e2464));
                                let _e2686 = (((_e2645 * _e2468) + (_e2648 * _e2469)) + (_e2651 * _e2470));
                                let _e2691 = (((_e2645 * _e2465) + (_e2648 * _e2466)) + (_e2651 * _e2467));
                                if (_e2656 < _e2661) {
                                    phi_4796_ = _e2656;
                                } else {
                                    phi_4796_ = _e2661;
                                }
                                let _e2694 = phi_4796_;
                                if (_e2666 < _e2671) {
                                    phi_4801_ = _e2666;
                                } else {
                                    phi_4801_ = _e2671;
                                }
                                let _e2697 = phi_4801_;
                                if (_e2694 < _e2697) {
                                    phi_4806_ = _e2694;
                                } else {
                                    phi_4806_ = _e2697;
                                }
                                let _e2700 = phi_4806_;
                                if (_e2676 < _e2681) {
                                    phi_4811_ = _e2676;
                                } else {
                                    phi_4811_ = _e2681;
                                }
                                let _e2703 = phi_4811_;
                                if (_e2686 < _e2691) {
                                    phi_4816_ = _e2686;
                                } else {
                                    phi_4816_ = _e2691;
                                }
                                let _e2706 = phi_4816_;
                                if (_e2703 < _e2706) {
                                    phi_4821_ = _e2703;
                                } else {
                                    phi_4821_ = _e2706;
                                }
                                let _e2709 = phi_4821_;
                                if (_e2700 < _e2709) {
                                    phi_4826_ = _e2700;
                                } else {
                                    phi_4826_ = _e2709;
                                }
                                let _e2712 = phi_4826_;
                                if (_e2656 > _e2661) {
                                    phi_4831_ = _e2656;
                                } else {
                                    phi_4831_ = _e2661;
                                }
                                let _e2715 = phi_4831_;
                                if (_e2666 > _e2671) {
                                    phi_4836_ = _e2666;
                                } else {
                                    phi_4836_ = _e2671;
                                }
                                let _e2718 = phi_4836_;
                                if (_e2715 > _e2718) {
                                    phi_4841_ = _e2715;
                                } else {
                                    phi_4841_ = _e2718;
                                }
                                let _e2721 = phi_4841_;
                                if (_e2676 > _e2681) {
                                    phi_4846_ = _e2676;
                                } else {
                                    phi_4846_ = _e2681;
                                }
                                let _e2724 = phi_4846_;
                                if (_e2686 > _e2691) {
                                    phi_4851_ = _e2686;
                                } else {
                                    phi_4851_ = _e2691;
                                }
                                let _e2727 = phi_4851_;
                                if (_e2724 > _e2727) {
                                    phi_4856_ = _e2724;
                                } else {
                                    phi_4856_ = _e2727;
                                }
                                let _e2730 = phi_4856_;
                                if (_e2721 > _e2730) {
                                    phi_4861_ = _e2721;
                                } else {
                                    phi_4861_ = _e2730;
                                }
                                let _e2733 = phi_4861_;
                                if (_e2645 < 0f) {
                                    phi_4867_ = -(_e2645);
                                } else {
                                    phi_4867_ = _e2645;
                                }
                                let _e2737 = phi_4867_;
                                if (_e2648 < 0f) {
                                    phi_4873_ = -(_e2648);
                                } else {
                                    phi_4873_ = _e2648;
                                }
                                let _e2741 = phi_4873_;
                                if (_e2651 < 0f) {
                                    phi_4880_ = -(_e2651);
                                } else {
                                    phi_4880_ = _e2651;
                                }
                                let _e2746 = phi_4880_;
                                let _e2747 = ((_e2737 + _e2741) + _e2746);
                                let _e2752 = -(_e2733);
                                if (_e2712 > _e2752) {
                                    phi_4891_ = _e2712;
                                } else {
                                    phi_4891_ = _e2752;
                                }
                                let _e2755 = phi_4891_;
                                let _e2760 = (((_e2755 - ((_e2747 * _e2635) * (0.000000059604645f * (17f / 2f)))) - (_e2747 * _e2642)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2763 = ((_e2413 * _e2407) - (_e2416 * _e2406));
                                let _e2766 = ((_e2416 * _e2405) - (_e2410 * _e2407));
                                let _e2769 = ((_e2410 * _e2406) - (_e2413 * _e2405));
                                let _e2774 = (((_e2763 * _e2419[0]) + (_e2766 * _e2419[1])) + (_e2769 * _e2419[2]));
                                let _e2779 = (((_e2763 * _e2435) + (_e2766 * _e2436)) + (_e2769 * _e2437));
                                let _e2784 = (((_e2763 * _e2441) + (_e2766 * _e2442)) + (_e2769 * _e2443));
                                let _e2789 = (((_e2763 * _e2438) + (_e2766 * _e2439)) + (_e2769 * _e2440));
                                let _e2794 = (((_e2763 * _e2446[0]) + (_e2766 * _e2446[1])) + (_e2769 * _e2446[2]));
                                let _e2799 = (((_e2763 * _e2462) + (_e2766 * _e2463)) + (_e2769 * _e2464));
                                let _e2804 = (((_e2763 * _e2468) + (_e2766 * _e2469)) + (_e2769 * _e2470));
                                let _e2809 = (((_e2763 * _e2465) + (_e2766 * _e2466)) + (_e2769 * _e2467));
                                if (_e2774 < _e2779) {
                                    phi_4962_ = _e2774;
                                } else {
                                    phi_4962_ = _e2779;
                                }
                                let _e2812 = phi_4962_;
                                if (_e2784 < _e2789) {
                                    phi_4967_ = _e2784;
                                } else {
                                    phi_4967_ = _e2789;
                                }
                                let _e2815 = phi_4967_;
                                if (_e2812 < _e2815) {
                                    phi_4972_ = _e2812;
                                } else {
                                    phi_4972_ = _e2815;
                                }
                                let _e2818 = phi_4972_;
                                if (_e2794 < _e2799) {
                                    phi_4977_ = _e2794;
                                } else {
                                    phi_4977_ = _e2799;
                                }
                                let _e2821 = phi_4977_;
                                if (_e2804 < _e2809) {
                                    phi_4982_ = _e2804;
                                } else {
                                    phi_4982_ = _e2809;
                                }
                                let _e2824 = phi_4982_;
                                if (_e2821 < _e2824) {
                                    phi_4987_ = _e2821;
                                } else {
                                    phi_4987_ = _e2824;
                                }
                                let _e2827 = phi_4987_;
                                if (_e2818 < _e2827) {
                                    phi_4992_ = _e2818;
                                } else {
                                    phi_4992_ = _e2827;
                                }
                                let _e2830 = phi_4992_;
                                if (_e2774 > _e2779) {
                                    phi_4997_ = _e2774;
                                } else {
                                    phi_4997_ = _e2779;
                                }
                                let _e2833 = phi_4997_;
                                if (_e2784 > _e2789) {
                                    phi_5002_ = _e2784;
                                } else {
                                    phi_5002_ = _e2789;
                                }
                                let _e2836 = phi_5002_;
                                if (_e2833 > _e2836) {
                                    phi_5007_ = _e2833;
                                } else {
                                    phi_5007_ = _e2836;
                                }
                                let _e2839 = phi_5007_;
                                if (_e2794 > _e2799) {
                                    phi_5012_ = _e2794;
                                } else {
                                    phi_5012_ = _e2799;
                                }
                                let _e2842 = phi_5012_;
                                if (_e2804 > _e2809) {
                                    phi_5017_ = _e2804;
                                } else {
                                    phi_5017_ = _e2809;
                                }
                                let _e2845 = phi_5017_;
                                if (_e2842 > _e2845) {
                                    phi_5022_ = _e2842;
                                } else {
                                    phi_5022_ = _e2845;
                                }
                                let _e2848 = phi_5022_;
                                if (_e2839 > _e2848) {
                                    phi_5027_ = _e2839;
                                } else {
                                    phi_5027_ = _e2848;
                                }
                                let _e2851 = phi_5027_;
                                if (_e2763 < 0f) {
                                    phi_5033_ = -(_e2763);
                                } else {
                                    phi_5033_ = _e2763;
                                }
                                let _e2855 = phi_5033_;
                                if (_e2766 < 0f) {
                                    phi_5039_ = -(_e2766);
                                } else {
                                    phi_5039_ = _e2766;
                                }
                                let _e2859 = phi_5039_;
                                if (_e2769 < 0f) {
                                    phi_5046_ = -(_e2769);
                                } else {
                                    phi_5046_ = _e2769;
                                }
                                let _e2864 = phi_5046_;
                                let _e2865 = ((_e2855 + _e2859) + _e2864);
                                let _e2870 = -(_e2851);
                                if (_e2830 > _e2870) {
                                    phi_5057_ = _e2830;
                                } else {
                                    phi_5057_ = _e2870;
                                }
                                let _e2873 = phi_5057_;
                                let _e2878 = (((_e2873 - ((_e2865 * _e2635) * (0.000000059604645f * (17f / 2f)))) - (_e2865 * _e2642)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2760 > _e2878) {
                                    phi_5067_ = _e2760;
                                } else {
                                    phi_5067_ = _e2878;
                                }
                                let _e2881 = phi_5067_;
                                phi_5249_ = (_e2377 || (_e2881 > 0f));
                            }
                            let _e2885 = phi_5249_;
                            if _e2885 {
                                phi_8666_ = _e2885;
                            } else {
                                let _e2888 = local_2.member[0u];
                                let _e2894 = local_2.member[1u];
                                let _e2901 = ((_e2888[0] + _e2894[0]) * 0.5f);
                                let _e2902 = ((_e2888[1] + _e2894[1]) * 0.5f);
                                let _e2903 = ((_e2888[2] + _e2894[2]) * 0.5f);
                                let _e2906 = local_2.member_1[0u];
                                let _e2912 = local_2.member_1[1u];
                                let _e2919 = ((_e2906[0] + _e2912[0]) * 0.5f);
                                let _e2920 = ((_e2906[1] + _e2912[1]) * 0.5f);
                                let _e2921 = ((_e2906[2] + _e2912[2]) * 0.5f);
                                let _e2924 = local_2.member_2[0u];
                                let _e2930 = local_2.member_2[1u];
                                let _e2937 = ((_e2924[0] + _e2930[0]) * 0.5f);
                                let _e2938 = ((_e2924[1] + _e2930[1]) * 0.5f);
                                let _e2939 = ((_e2924[2] + _e2930[2]) * 0.5f);
                                let _e2942 = local_2.member[0u];
                                let _e2945 = local_2.member_1[0u];
                                let _e2948 = local_2.member_2[0u];
                                let _e2950 = local_2.member_3;
                                let _e2953 = local_2.member[1u];
                                let _e2956 = local_2.member_1[1u];
                                let _e2959 = local_2.member_2[1u];
                                let _e2961 = local_2.member_3;
                                local = type_41(array<array<f32, 3>, 2>(_e2942, array<f32, 3>(_e2901, _e2902, _e2903)), array<array<f32, 3>, 2>(_e2945, array<f32, 3>(_e2919, _e2920, _e2921)), array<array<f32, 3>, 2>(_e2948, array<f32, 3>(_e2937, _e2938, _e2939)), _e2950);
                                local_1 = type_41(array<array<f32, 3>, 2>(array<f32, 3>(_e2901, _e2902, _e2903), _e2953), array<array<f32, 3>, 2>(array<f32, 3>(_e2919, _e2920, _e2921), _e2956), array<array<f32, 3>, 2>(array<f32, 3>(_e2937, _e2938, _e2939), _e2959), _e2961);
                                let _e2978 = local.member_1[0u];
                                let _e2984 = local.member_2[0u];
                                let _e2990 = ((_e2978[1] * _e2984[2]) - (_e2978[2] * _e2984[1]));
                                let _e2993 = ((_e2978[2] * _e2984[0]) - (_e2978[0] * _e2984[2]));
                                let _e2996 = ((_e2978[0] * _e2984[1]) - (_e2978[1] * _e2984[0]));
                                let _e2999 = local.member_1[1u];
                                let _e3005 = local.member_2[1u];
                                let _e3011 = ((_e2999[1] * _e3005[2]) - (_e2999[2] * _e3005[1]));
                                let _e3014 = ((_e2999[2] * _e3005[0]) - (_e2999[0] * _e3005[2]));
                                let _e3017 = ((_e2999[0] * _e3005[1]) - (_e2999[1] * _e3005[0]));
                                let _e3020 = local.member_1[0u];
                                let _e3026 = local.member_2[1u];
                                let _e3041 = local.member_1[1u];
                                let _e3047 = local.member_2[0u];
                                let _e3060 = (((_e3020[1] * _e3026[2]) - (_e3020[2] * _e3026[1])) + ((_e3041[1] * _e3047[2]) - (_e3041[2] * _e3047[1])));
                                let _e3061 = (((_e3020[2] * _e3026[0]) - (_e3020[0] * _e3026[2])) + ((_e3041[2] * _e3047[0]) - (_e3041[0] * _e3047[2])));
                                let _e3062 = (((_e3020[0] * _e3026[1]) - (_e3020[1] * _e3026[0])) + ((_e3041[0] * _e3047[1]) - (_e3041[1] * _e3047[0])));
                                let _e3065 = local.member[0u];
                                let _e3076 = local.member[1u];
                                let _e3087 = local.member[0u];
                                let _e3096 = ((((_e3076[0] * _e2990) + (_e3076[1] * _e2993)) + (_e3076[2] * _e2996)) + (((_e3087[0] * _e3060) + (_e3087[1] * _e3061)) + (_e3087[2] * _e3062)));
                                let _e3099 = local.member[0u];
                                let _e3110 = local.member[1u];
                                let _e3119 = ((((_e3099[0] * _e3011) + (_e3099[1] * _e3014)) + (_e3099[2] * _e3017)) + (((_e3110[0] * _e3060) + (_e3110[1] * _e3061)) + (_e3110[2] * _e3062)));
                                let _e3122 = local.member[1u];
                                let _e3133 = local.member[0u];
                                if (_e3133[0] < 0f) {
                                    phi_5701_ = -(_e3133[0]);
                                } else {
                                    phi_5701_ = _e3133[0];
                                }
                                let _e3140 = phi_5701_;
                                if (_e3133[1] < 0f) {
                                    phi_5708_ = -(_e3133[1]);
                                } else {
                                    phi_5708_ = _e3133[1];
                                }
                                let _e3144 = phi_5708_;
                                if (_e3140 > _e3144) {
                                    phi_5713_ = _e3140;
                                } else {
                                    phi_5713_ = _e3144;
                                }
                                let _e3147 = phi_5713_;
                                if (_e3133[2] < 0f) {
                                    phi_5720_ = -(_e3133[2]);
                                } else {
                                    phi_5720_ = _e3133[2];
                                }
                                let _e3151 = phi_5720_;
                                if (_e3147 > _e3151) {
                                    phi_5725_ = _e3147;
                                } else {
                                    phi_5725_ = _e3151;
                                }
                                let _e3154 = phi_5725_;
                                let _e3157 = local.member[1u];
                                if (_e3157[0] < 0f) {
                                    phi_5738_ = -(_e3157[0]);
                                } else {
                                    phi_5738_ = _e3157[0];
                                }
                                let _e3164 = phi_5738_;
                                if (_e3157[1] < 0f) {
                                    phi_5745_ = -(_e3157[1]);
                                } else {
                                    phi_5745_ = _e3157[1];
                                }
                                let _e3168 = phi_5745_;
                                if (_e3164 > _e3168) {
                                    phi_5750_ = _e3164;
                                } else {
                                    phi_5750_ = _e3168;
                                }
                                let _e3171 = phi_5750_;
                                if (_e3157[2] < 0f) {
                                    phi_5757_ = -(_e3157[2]);
                                } else {
                                    phi_5757_ = _e3157[2];
                                }
                                let _e3175 = phi_5757_;
                                if (_e3171 > _e3175) {
                                    phi_5762_ = _e3171;
                                } else {
                                    phi_5762_ = _e3175;
                                }
                                let _e3178 = phi_5762_;
                                if (_e3154 > _e3178) {
                                    phi_5767_ = _e3154;
                                } else {
                                    phi_5767_ = _e3178;
                                }
                                let _e3181 = phi_5767_;
                                let _e3183 = local.member_3;
                                let _e3184 = (_e3181 + _e3183);
                                let _e3187 = local.member_1[0u];
                                if (_e3187[0] < 0f) {
                                    phi_5784_ = -(_e3187[0]);
                                } else {
                                    phi_5784_ = _e3187[0];
                                }
                                let _e3194 = phi_5784_;
                                if (_e3187[1] < 0f) {
                                    phi_5791_ = -(_e3187[1]);
                                } else {
                                    phi_5791_ = _e3187[1];
                                }
                                let _e3198 = phi_5791_;
                                if (_e3194 > _e3198) {
                                    phi_5796_ = _e3194;
                                } else {
                                    phi_5796_ = _e3198;
                                }
                                let _e3201 = phi_5796_;
                                if (_e3187[2] < 0f) {
                                    phi_5803_ = -(_e3187[2]);
                                } else {
                                    phi_5803_ = _e3187[2];
                                }
                                let _e3205 = phi_5803_;
                                if (_e3201 > _e3205) {
                                    phi_5808_ = _e3201;
                                } else {
                                    phi_5808_ = _e3205;
                                }
                                let _e3208 = phi_5808_;
                                let _e3211 = local.member_1[1u];
                                if (_e3211[0] < 0f) {
                                    phi_5822_ = -(_e3211[0]);
                                } else {
                                    phi_5822_ = _e3211[0];
                                }
                                let _e3218 = phi_5822_;
                                if (_e3211[1] < 0f) {
                                    phi_5829_ = -(_e3211[1]);
                                } else {
                                    phi_5829_ = _e3211[1];
                                }
                                let _e3222 = phi_5829_;
                                if (_e3218 > _e3222) {
                                    phi_5834_ = _e3218;
                                } else {
                                    phi_5834_ = _e3222;
                                }
                                let _e3225 = phi_5834_;
                                if (_e3211[2] < 0f) {
                                    phi_5841_ = -(_e3211[2]);
                                } else {
                                    phi_5841_ = _e3211[2];
                                }
                                let _e3229 = phi_5841_;
                                if (_e3225 > _e3229) {
                                    phi_5846_ = _e3225;
                                } else {
                                    phi_5846_ = _e3229;
                                }
                                let _e3232 = phi_5846_;
                                if (_e3208 > _e3232) {
                                    phi_5851_ = _e3208;
                                } else {
                                    phi_5851_ = _e3232;
                                }
                                let _e3235 = phi_5851_;
                                let _e3237 = local.member_3;
                                let _e3238 = (_e3235 + _e3237);
                                let _e3241 = local.member_2[0u];
                                if (_e3241[0] < 0f) {
                                    phi_5868_ = -(_e3241[0]);
                                } else {
                                    phi_5868_ = _e3241[0];
                                }
                                let _e3248 = phi_5868_;
                                if (_e3241[1] < 0f) {
                                    phi_5875_ = -(_e3241[1]);
                                } else {
                                    phi_5875_ = _e3241[1];
                                }
                                let _e3252 = phi_5875_;
                                if (_e3248 > _e3252) {
                                    phi_5880_ = _e3248;
                                } else {
                                    phi_5880_ = _e3252;
                                }
                                let _e3255 = phi_5880_;
                                if (_e3241[2] < 0f) {
                                    phi_5887_ = -(_e3241[2]);
                                } else {
                                    phi_5887_ = _e3241[2];
                                }
                                let _e3259 = phi_5887_;
                                if (_e3255 > _e3259) {
                                    phi_5892_ = _e3255;
                                } else {
                                    phi_5892_ = _e3259;
                                }
                                let _e3262 = phi_5892_;
                                let _e3265 = local.member_2[1u];
                                if (_e3265[0] < 0f) {
                                    phi_5906_ = -(_e3265[0]);
                                } else {
                                    phi_5906_ = _e3265[0];
                                }
                                let _e3272 = phi_5906_;
                                if (_e3265[1] < 0f) {
                                    phi_5913_ = -(_e3265[1]);
                                } else {
                                    phi_5913_ = _e3265[1];
                                }
                                let _e3276 = phi_5913_;
                                if (_e3272 > _e3276) {
                                    phi_5918_ = _e3272;
                                } else {
                                    phi_5918_ = _e3276;
                                }
                                let _e3279 = phi_5918_;
                                if (_e3265[2] < 0f) {
                                    phi_5925_ = -(_e3265[2]);
                                } else {
                                    phi_5925_ = _e3265[2];
                                }
                                let _e3283 = phi_5925_;
                                if (_e3279 > _e3283) {
                                    phi_5930_ = _e3279;
                                } else {
                                    phi_5930_ = _e3283;
                                }
                                let _e3286 = phi_5930_;
                                if (_e3262 > _e3286) {
                                    phi_5935_ = _e3262;
                                } else {
                                    phi_5935_ = _e3286;
                                }
                                let _e3289 = phi_5935_;
                                let _e3291 = local.member_3;
                                let _e3292 = (_e3289 + _e3291);
                                let _e3294 = ((_e3238 * 8f) * _e3292);
                                let _e3301 = local.member_3;
                                if (_e2990 < 0f) {
                                    phi_5966_ = -(_e2990);
                                } else {
                                    phi_5966_ = _e2990;
                                }
                                let _e3318 = phi_5966_;
                                if (_e2993 < 0f) {
                                    phi_5972_ = -(_e2993);
                                } else {
                                    phi_5972_ = _e2993;
                                }
                                let _e3322 = phi_5972_;
                                if (_e2996 < 0f) {
                                    phi_5979_ = -(_e2996);
                                } else {
                                    phi_5979_ = _e2996;
                                }
                                let _e3327 = phi_5979_;
                                let _e3328 = ((_e3318 + _e3322) + _e3327);
                                if (_e3011 < 0f) {
                                    phi_5986_ = -(_e3011);
                                } else {
                                    phi_5986_ = _e3011;
                                }
                                let _e3332 = phi_5986_;
                                if (_e3014 < 0f) {
                                    phi_5992_ = -(_e3014);
                                } else {
                                    phi_5992_ = _e3014;
                                }
                                let _e3336 = phi_5992_;
                                if (_e3017 < 0f) {
                                    phi_5999_ = -(_e3017);
                                } else {
                                    phi_5999_ = _e3017;
                                }
                                let _e3341 = phi_5999_;
                                let _e3342 = ((_e3332 + _e3336) + _e3341);
                                if (_e3328 > _e3342) {
                                    phi_6005_ = _e3328;
                                } else {
                                    phi_6005_ = _e3342;
                                }
                                let _e3345 = phi_6005_;
                                if (_e3060 < 0f) {
                                    phi_6011_ = -(_e3060);
                                } else {
                                    phi_6011_ = _e3060;
                                }
                                let _e3349 = phi_6011_;
                                if (_e3061 < 0f) {
                                    phi_6017_ = -(_e3061);
                                } else {
                                    phi_6017_ = _e3061;
                                }
                                let _e3353 = phi_6017_;
                                if (_e3062 < 0f) {
                                    phi_6024_ = -(_e3062);
                                } else {
                                    phi_6024_ = _e3062;
                                }
                                let _e3358 = phi_6024_;
                                let _e3360 = (((_e3349 + _e3353) + _e3358) * 0.5f);
                                if (_e3345 > _e3360) {
                                    phi_6031_ = _e3345;
                                } else {
                                    phi_6031_ = _e3360;
                                }
                                let _e3363 = phi_6031_;
                                let _e3368 = local.member_3;
                                let _e3381 = ((((_e3065[0] * _e2990) + (_e3065[1] * _e2993)) + (_e3065[2] * _e2996)) * 3f);
                                let _e3382 = ((((_e3122[0] * _e3011) + (_e3122[1] * _e3014)) + (_e3122[2] * _e3017)) * 3f);
                                if (_e3381 < _e3382) {
                                    phi_6055_ = _e3381;
                                } else {
                                    phi_6055_ = _e3382;
                                }
                                let _e3385 = phi_6055_;
                                if (_e3096 < _e3119) {
                                    phi_6060_ = _e3096;
                                } else {
                                    phi_6060_ = _e3119;
                                }
                                let _e3388 = phi_6060_;
                                if (_e3385 < _e3388) {
                                    phi_6065_ = _e3385;
                                } else {
                                    phi_6065_ = _e3388;
                                }
                                let _e3391 = phi_6065_;
                                if (_e3381 > _e3382) {
                                    phi_6070_ = _e3381;
                                } else {
                                    phi_6070_ = _e3382;
                                }
                                let _e3394 = phi_6070_;
                                if (_e3096 > _e3119) {
                                    phi_6075_ = _e3096;
                                } else {
                                    phi_6075_ = _e3119;
                                }
                                let _e3397 = phi_6075_;
                                if (_e3394 > _e3397) {
                                    phi_6080_ = _e3394;
                                } else {
                                    phi_6080_ = _e3397;
                                }
                                let _e3400 = phi_6080_;
                                let _e3405 = -(_e3400);
                                if (_e3391 > _e3405) {
                                    phi_6090_ = _e3391;
                                } else {
                                    phi_6090_ = _e3405;
                                }
                                let _e3408 = phi_6090_;
                                let _e3410 = ((_e3408 - ((((((_e3184 * 8f) * _e3294) * (0.000000059604645f * (524f / 64f))) + ((_e3301 * 19f) * ((_e3184 * (_e3238 + _e3292)) + (_e3238 * _e3292)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3184) * ((1f + _e3238) * (1f + _e3292))))) + ((_e1873 * (((_e3363 + (_e3294 * (0.000000059604645f * 8f))) + ((_e3368 * 6f) * (_e3238 + _e3292))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3238) * (1f + _e3292))))) * (3f * 1.0001f)))) > 0f);
                                if _e3410 {
                                    phi_7059_ = _e3410;
                                } else {
                                    let _e3413 = local.member_1[0u];
                                    let _e3419 = local.member_1[1u];
                                    let _e3423 = (_e3413[0] + _e3419[0]);
                                    let _e3424 = (_e3413[1] + _e3419[1]);
                                    let _e3425 = (_e3413[2] + _e3419[2]);
                                    let _e3428 = local.member_2[0u];
                                    let _e3434 = local.member_2[1u];
                                    let _e3438 = (_e3428[0] + _e3434[0]);
                                    let _e3439 = (_e3428[1] + _e3434[1]);
                                    let _e3440 = (_e3428[2] + _e3434[2]);
                                    let _e3443 = ((_e3424 * _e3440) - (_e3425 * _e3439));
                                    let _e3446 = ((_e3425 * _e3438) - (_e3423 * _e3440));
                                    let _e3449 = ((_e3423 * _e3439) - (_e3424 * _e3438));
                                    let _e3452 = local.member[0u];
                                    let _e3458 = local.member_1[0u];
                                    let _e3464 = local.member_2[0u];
                                    let _e3468 = (_e3452[0] - _e3458[0]);
                                    let _e3469 = (_e3452[1] - _e3458[1]);
                                    let _e3470 = (_e3452[2] - _e3458[2]);
                                    let _e3471 = (_e3468 - _e3464[0]);
                                    let _e3472 = (_e3469 - _e3464[1]);
                                    let _e3473 = (_e3470 - _e3464[2]);
                                    let _e3474 = (_e3452[0] - _e3464[0]);
                                    let _e3475 = (_e3452[1] - _e3464[1]);
                                    let _e3476 = (_e3452[2] - _e3464[2]);
                                    let _e3479 = local.member[1u];
                                    let _e3485 = local.member_1[1u];
                                    let _e3491 = local.member_2[1u];
                                    let _e3495 = (_e3479[0] - _e3485[0]);
                                    let _e3496 = (_e3479[1] - _e3485[1]);
                                    let _e3497 = (_e3479[2] - _e3485[2]);
                                    let _e3498 = (_e3495 - _e3491[0]);
                                    let _e3499 = (_e3496 - _e3491[1]);
                                    let _e3500 = (_e3497 - _e3491[2]);
                                    let _e3501 = (_e3479[0] - _e3491[0]);
                                    let _e3502 = (_e3479[1] - _e3491[1]);
                                    let _e3503 = (_e3479[2] - _e3491[2]);
                                    let _e3506 = local.member[0u];
                                    if (_e3506[0] < 0f) {
                                        phi_6293_ = -(_e3506[0]);
                                    } else {
                                        phi_6293_ = _e3506[0];
                                    }
                                    let _e3513 = phi_6293_;
                                    if (_e3506[1] < 0f) {
                                        phi_6300_ = -(_e3506[1]);
                                    } else {
                                        phi_6300_ = _e3506[1];
                                    }
                                    let _e3517 = phi_6300_;
                                    if (_e3513 > _e3517) {
                                        phi_6305_ = _e3513;
                                    } else {
                                        phi_6305_ = _e3517;
                                    }
                                    let _e3520 = phi_6305_;
                                    if (_e3506[2] < 0f) {
                                        phi_6312_ = -(_e3506[2]);
                                    } else {
                                        phi_6312_ = _e3506[2];
                                    }
                                    let _e3524 = phi_6312_;
                                    if (_e3520 > _e3524) {
                                        phi_6317_ = _e3520;
                                    } else {
                                        phi_6317_ = _e3524;
                                    }
                                    let _e3527 = phi_6317_;
                                    let _e3530 = local.member[1u];
                                    if (_e3530[0] < 0f) {
                                        phi_6330_ = -(_e3530[0]);
                                    } else {
                                        phi_6330_ = _e3530[0];
                                    }
                                    let _e3537 = phi_6330_;
                                    if (_e3530[1] < 0f) {
                                        phi_6337_ = -(_e3530[1]);
                                    } else {
                                        phi_6337_ = _e3530[1];
                                    }
                                    let _e3541 = phi_6337_;
                                    if (_e3537 > _e3541) {
                                        phi_6342_ = _e3537;
                                    } else {
                                        phi_6342_ = _e3541;
                                    }
                                    let _e3544 = phi_6342_;
                                    if (_e3530[2] < 0f) {
                                        phi_6349_ = -(_e3530[2]);
                                    } else {
                                        phi_6349_ = _e3530[2];
                                    }
                                    let _e3548 = phi_6349_;
                                    if (_e3544 > _e3548) {
                                        phi_6354_ = _e3544;
                                    } else {
                                        phi_6354_ = _e3548;
                                    }
                                    let _e3551 = phi_6354_;
                                    if (_e3527 > _e3551) {
                                        phi_6359_ = _e3527;
                                    } else {
                                        phi_6359_ = _e3551;
                                    }
                                    let _e3554 = phi_6359_;
                                    let _e3556 = local.member_3;
                                    let _e3560 = local.member_1[0u];
                                    if (_e3560[0] < 0f) {
                                        phi_6376_ = -(_e3560[0]);
                                    } else {
                                        phi_6376_ = _e3560[0];
                                    }
                                    let _e3567 = phi_6376_;
                                    if (_e3560[1] < 0f) {
                                        phi_6383_ = -(_e3560[1]);
                                    } else {
                                        phi_6383_ = _e3560[1];
                                    }
                                    let _e3571 = phi_6383_;
                                    if (_e3567 > _e3571) {
                                        phi_6388_ = _e3567;
                                    } else {
                                        phi_6388_ = _e3571;
                                    }
                                    let _e3574 = phi_6388_;
                                    if (_e3560[2] < 0f) {
                                        phi_6395_ = -(_e3560[2]);
                                    } else {
                                        phi_6395_ = _e3560[2];
                                    }
                                    let _e3578 = phi_6395_;
                                    if (_e3574 > _e3578) {
                                        phi_6400_ = _e3574;
                                    } else {
                                        phi_6400_ = _e3578;
                                    }
                                    let _e3581 = phi_6400_;
                                    let _e3584 = local.member_1[1u];
                                    if (_e3584[0] < 0f) {
                                        phi_6414_ = -(_e3584[0]);
                                    } else {
                                        phi_6414_ = _e3584[0];
                                    }
                                    let _e3591 = phi_6414_;
                                    if (_e3584[1] < 0f) {
                                        phi_6421_ = -(_e3584[1]);
                                    } else {
                                        phi_6421_ = _e3584[1];
                                    }
                                    let _e3595 = phi_6421_;
                                    if (_e3591 > _e3595) {
                                        phi_6426_ = _e3591;
                                    } else {
                                        phi_6426_ = _e3595;
                                    }
                                    let _e3598 = phi_6426_;
                                    if (_e3584[2] < 0f) {
                                        phi_6433_ = -(_e3584[2]);
                                    } else {
                                        phi_6433_ = _e3584[2];
                                    }
                                    let _e3602 = phi_6433_;
                                    if (_e3598 > _e3602) {
                                        phi_6438_ = _e3598;
                                    } else {
                                        phi_6438_ = _e3602;
                                    }
                                    let _e3605 = phi_6438_;
                                    if (_e3581 > _e3605) {
                                        phi_6443_ = _e3581;
                                    } else {
                                        phi_6443_ = _e3605;
                                    }
                                    let _e3608 = phi_6443_;
                                    let _e3610 = local.member_3;
                                    let _e3614 = local.member_2[0u];
                                    if (_e3614[0] < 0f) {
                                        phi_6460_ = -(_e3614[0]);
                                    } else {
                                        phi_6460_ = _e3614[0];
                                    }
                                    let _e3621 = phi_6460_;
                                    if (_e3614[1] < 0f) {
                                        phi_6467_ = -(_e3614[1]);
                                    } else {
                                        phi_6467_ = _e3614[1];
                                    }
                                    let _e3625 = phi_6467_;
                                    if (_e3621 > _e3625) {
                                        phi_6472_ = _e3621;
                                    } else {
                                        phi_6472_ = _e3625;
                                    }
                                    let _e3628 = phi_6472_;
                                    if (_e3614[2] < 0f) {
                                        phi_6479_ = -(_e3614[2]);
                                    } else {
                                        phi_6479_ = _e3614[2];
                                    }
                                    let _e3632 = phi_6479_;
                                    if (_e3628 > _e3632) {
                                        phi_6484_ = _e3628;
                                    } else {
                                        phi_6484_ = _e3632;
                                    }
                                    let _e3635 = phi_6484_;
                                    let _e3638 = local.member_2[1u];
                                    if (_e3638[0] < 0f) {
                                        phi_6498_ = -(_e3638[0]);
                                    } else {
                                        phi_6498_ = _e3638[0];
                                    }
                                    let _e3645 = phi_6498_;
                                    if (_e3638[1] < 0f) {
                                        phi_6505_ = -(_e3638[1]);
                                    } else {
                                        phi_6505_ = _e3638[1];
                                    }
                                    let _e3649 = phi_6505_;
                                    if (_e3645 > _e3649) {
                                        phi_6510_ = _e3645;
                                    } else {
                                        phi_6510_ = _e3649;
                                    }
                                    let _e3652 = phi_6510_;
                                    if (_e3638[2] < 0f) {
                                        phi_6517_ = -(_e3638[2]);
                                    } else {
                                        phi_6517_ = _e3638[2];
                                    }
                                    let _e3656 = phi_6517_;
                                    if (_e3652 > _e3656) {
                                        phi_6522_ = _e3652;
                                    } else {
                                        phi_6522_ = _e3656;
                                    }
                                    let _e3659 = phi_6522_;
                                    if (_e3635 > _e3659) {
                                        phi_6527_ = _e3635;
                                    } else {
                                        phi_6527_ = _e3659;
                                    }
                                    let _e3662 = phi_6527_;
                                    let _e3664 = local.member_3;
                                    let _e3668 = ((((_e3554 + _e3556) + (_e3608 + _e3610)) + (_e3662 + _e3664)) * 2f);
                                    let _e3671 = local.member_3;
                                    let _e3675 = (((_e1873 * 1.0001f) + (_e3671 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3678 = ((_e3446 * _e3425) - (_e3449 * _e3424));
                                    let _e3681 = ((_e3449 * _e3423) - (_e3443 * _e3425));
                                    let _e3684 = ((_e3443 * _e3424) - (_e3446 * _e3423));
                                    let _e3689 = (((_e3678 * _e3452[0]) + (_e3681 * _e3452[1])) + (_e3684 * _e3452[2]));
                                    let _e3694 = (((_e3678 * _e3468) + (_e3681 * _e3469)) + (_e3684 * _e3470));
                                    let _e3699 = (((_e3678 * _e3474) + (_e3681 * _e3475)) + (_e3684 * _e3476));
                                    let _e3704 = (((_e3678 * _e3471) + (_e3681 * _e3472)) + (_e3684 * _e3473));
                                    let _e3709 = (((_e3678 * _e3479[0]) + (_e3681 * _e3479[1])) + (_e3684 * _e3479[2]));
                                    let _e3714 = (((_e3678 * _e3495) + (_e3681 * _e3496)) + (_e3684 * _e3497));
                                    let _e3719 = (((_e3678 * _e3501) + (_e3681 * _e3502)) + (_e3684 * _e3503));
                                    let _e3724 = (((_e3678 * _e3498) + (_e3681 * _e3499)) + (_e3684 * _e3500));
                                    if (_e3689 < _e3694) {
                                        phi_6606_ = _e3689;
                                    } else {
                                        phi_6606_ = _e3694;
                                    }
                                    let _e3727 = phi_6606_;
                                    if (_e3699 < _e3704) {
                                        phi_6611_ = _e3699;
                                    } else {
                                        phi_6611_ = _e3704;
                                    }
                                    let _e3730 = phi_6611_;
                                    if (_e3727 < _e3730) {
                                        phi_6616_ = _e3727;
                                    } else {
                                        phi_6616_ = _e3730;
                                    }
                                    let _e3733 = phi_6616_;
                                    if (_e3709 < _e3714) {
                                        phi_6621_ = _e3709;
                                    } else {
                                        phi_6621_ = _e3714;
                                    }
                                    let _e3736 = phi_6621_;
                                    if (_e3719 < _e3724) {
                                        phi_6626_ = _e3719;
                                    } else {
                                        phi_6626_ = _e3724;
                                    }
                                    let _e3739 = phi_6626_;
                                    if (_e3736 < _e3739) {
                                        phi_6631_ = _e3736;
                                    } else {
                                        phi_6631_ = _e3739;
                                    }
                                    let _e3742 = phi_6631_;
                                    if (_e3733 < _e3742) {
                                        phi_6636_ = _e3733;
                                    } else {
                                        phi_6636_ = _e3742;
                                    }
                                    let _e3745 = phi_6636_;
                                    if (_e3689 > _e3694) {
                                        phi_6641_ = _e3689;
                                    } else {
                                        phi_6641_ = _e3694;
                                    }
                                    let _e3748 = phi_6641_;
                                    if (_e3699 > _e3704) {
                                        phi_6646_ = _e3699;
                                    } else {
                                        phi_6646_ = _e3704;
                                    }
                                    let _e3751 = phi_6646_;
                                    if (_e3748 > _e3751) {
                                        phi_6651_ = _e3748;
                                    } else {
                                        phi_6651_ = _e3751;
                                    }
                                    let _e3754 = phi_6651_;
                                    if (_e3709 > _e3714) {
                                        phi_6656_ = _e3709;
                                    } else {
                                        phi_6656_ = _e3714;
                                    }
                                    let _e3757 = phi_6656_;
                                    if (_e3719 > _e3724) {
                                        phi_6661_ = _e3719;
                                    } else {
                                        phi_6661_ = _e3724;
                                    }
                                    let _e3760 = phi_6661_;
                                    if (_e3757 > _e3760) {
                                        phi_6666_ = _e3757;
                                    } else {
                                        phi_6666_ = _e3760;
                                    }
                                    let _e3763 = phi_6666_;
                                    if (_e3754 > _e3763) {
                                        phi_6671_ = _e3754;
                                    } else {
                                        phi_6671_ = _e3763;
                                    }
                                    let _e3766 = phi_6671_;
                                    if (_e3678 < 0f) {
                                        phi_6677_ = -(_e3678);
                                    } else {
                                        phi_6677_ = _e3678;
                                    }
                                    let _e3770 = phi_6677_;
                                    if (_e3681 < 0f) {
                                        phi_6683_ = -(_e3681);
                                    } else {
                                        phi_6683_ = _e3681;
                                    }
                                    let _e3774 = phi_6683_;
                                    if (_e3684 < 0f) {
                                        phi_6690_ = -(_e3684);
                                    } else {
                                        phi_6690_ = _e3684;
                                    }
                                    let _e3779 = phi_6690_;
                                    let _e3780 = ((_e3770 + _e3774) + _e3779);
                                    let _e3785 = -(_e3766);
                                    if (_e3745 > _e3785) {
                                        phi_6701_ = _e3745;
                                    } else {
                                        phi_6701_ = _e3785;
                                    }
                                    let _e3788 = phi_6701_;
                                    let _e3793 = (((_e3788 - ((_e3780 * _e3668) * (0.000000059604645f * (17f / 2f)))) - (_e3780 * _e3675)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3796 = ((_e3446 * _e3440) - (_e3449 * _e3439));
                                    let _e3799 = ((_e3449 * _e3438) - (_e3443 * _e3440));
                                    let _e3802 = ((_e3443 * _e3439) - (_e3446 * _e3438));
                                    let _e3807 = (((_e3796 * _e3452[0]) + (_e3799 * _e3452[1])) + (_e3802 * _e3452[2]));
                                    let _e3812 = (((_e3796 * _e3468) + (_e3799 * _e3469)) + (_e3802 * _e3470));
                                    let _e3817 = (((_e3796 * _e3474) + (_e3799 * _e3475)) + (_e3802 * _e3476));
                                    let _e3822 = (((_e3796 * _e3471) + (_e3799 * _e3472)) + (_e3802 * _e3473));
                                    let _e3827 = (((_e3796 * _e3479[0]) + (_e3799 * _e3479[1])) + (_e3802 * _e3479[2]));
                                    let _e3832 = (((_e3796 * _e3495) + (_e3799 * _e3496)) + (_e3802 * _e3497));
                                    let _e3837 = (((_e3796 * _e3501) + (_e3799 * _e3502)) + (_e3802 * _e3503));
                                    let _e3842 = (((_e3796 * _e3498) + (_e3799 * _e3499)) + (_e3802 * _e3500));
                                    if (_e3807 < _e3812) {
                                        phi_6772_ = _e3807;
                                    } else {
                                        phi_6772_ = _e3812;
                                    }
                                    let _e3845 = phi_6772_;
                                    if (_e3817 < _e3822) {
                                        phi_6777_ = _e3817;
                                    } else {
                                        phi_6777_ = _e3822;
                                    }
                                    let _e3848 = phi_6777_;
                                    if (_e3845 < _e3848) {
                                        phi_6782_ = _e3845;
                                    } else {
                                        phi_6782_ = _e3848;
                                    }
                                    let _e3851 = phi_6782_;
                                    if (_e3827 < _e3832) {
                                        phi_6787_ = _e3827;
                                    } else {
                                        phi_6787_ = _e3832;
                                    }
                                    let _e3854 = phi_6787_;
                                    if (_e3837 < _e3842) {
                                        phi_6792_ = _e3837;
                                    } else {
                                        phi_6792_ = _e3842;
                                    }
                                    let _e3857 = phi_6792_;
                                    if (_e3854 < _e3857) {
                                        phi_6797_ = _e3854;
                                    } else {
                                        phi_6797_ = _e3857;
                                    }
                                    let _e3860 = phi_6797_;
                                    if (_e3851 < _e3860) {
                                        phi_6802_ = _e3851;
                                    } else {
                                        phi_6802_ = _e3860;
                                    }
                                    let _e3863 = phi_6802_;
                                    if (_e3807 > _e3812) {
                                        phi_6807_ = _e3807;
                                    } else {
                                        phi_6807_ = _e3812;
                                    }
                                    let _e3866 = phi_6807_;
                                    if (_e3817 > _e3822) {
                                        phi_6812_ = _e3817;
                                    } else {
                                        phi_6812_ = _e3822;
                                    }
                                    let _e3869 = phi_6812_;
                                    if (_e3866 > _e3869) {
                                        phi_6817_ = _e3866;
                                    } else {
                                        phi_6817_ = _e3869;
                                    }
                                    let _e3872 = phi_6817_;
                                    if (_e3827 > _e3832) {
                                        phi_6822_ = _e3827;
                                    } else {
                                        phi_6822_ = _e3832;
                                    }
                                    let _e3875 = phi_6822_;
                                    if (_e3837 > _e3842) {
                                        phi_6827_ = _e3837;
                                    } else {
                                        phi_6827_ = _e3842;
                                    }
                                    let _e3878 = phi_6827_;
                                    if (_e3875 > _e3878) {
                                        phi_6832_ = _e3875;
                                    } else {
                                        phi_6832_ = _e3878;
                                    }
                                    let _e3881 = phi_6832_;
                                    if (_e3872 > _e3881) {
                                        phi_6837_ = _e3872;
                                    } else {
                                        phi_6837_ = _e3881;
                                    }
                                    let _e3884 = phi_6837_;
                                    if (_e3796 < 0f) {
                                        phi_6843_ = -(_e3796);
                                    } else {
                                        phi_6843_ = _e3796;
                                    }
                                    let _e3888 = phi_6843_;
                                    if (_e3799 < 0f) {
                                        phi_6849_ = -(_e3799);
                                    } else {
                                        phi_6849_ = _e3799;
                                    }
                                    let _e3892 = phi_6849_;
                                    if (_e3802 < 0f) {
                                        phi_6856_ = -(_e3802);
                                    } else {
                                        phi_6856_ = _e3802;
                                    }
                                    let _e3897 = phi_6856_;
                                    let _e3898 = ((_e3888 + _e3892) + _e3897);
                                    let _e3903 = -(_e3884);
                                    if (_e3863 > _e3903) {
                                        phi_6867_ = _e3863;
                                    } else {
                                        phi_6867_ = _e3903;
                                    }
                                    let _e3906 = phi_6867_;
                                    let _e3911 = (((_e3906 - ((_e3898 * _e3668) * (0.000000059604645f * (17f / 2f)))) - (_e3898 * _e3675)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3793 > _e3911) {
                                        phi_6877_ = _e3793;
                                    } else {
                                        phi_6877_ = _e3911;
                                    }
                                    let _e3914 = phi_6877_;
                                    phi_7059_ = (_e3410 || (_e3914 > 0f));
                                }
                                let _e3918 = phi_7059_;
                                if _e3918 {
                                    let _e3921 = local_1.member_1[0u];
                                    let _e3927 = local_1.member_2[0u];
                                    let _e3933 = ((_e3921[1] * _e3927[2]) - (_e3921[2] * _e3927[1]));
                                    let _e3936 = ((_e3921[2] * _e3927[0]) - (_e3921[0] * _e3927[2]));
                                    let _e3939 = ((_e3921[0] * _e3927[1]) - (_e3921[1] * _e3927[0]));
                                    let _e3942 = local_1.member_1[1u];
                                    let _e3948 = local_1.member_2[1u];
                                    let _e3954 = ((_e3942[1] * _e3948[2]) - (_e3942[2] * _e3948[1]));
                                    let _e3957 = ((_e3942[2] * _e3948[0]) - (_e3942[0] * _e3948[2]));
                                    let _e3960 = ((_e3942[0] * _e3948[1]) - (_e3942[1] * _e3948[0]));
                                    let _e3963 = local_1.member_1[0u];
                                    let _e3969 = local_1.member_2[1u];
                                    let _e3984 = local_1.member_1[1u];
                                    let _e3990 = local_1.member_2[0u];
                                    let _e4003 = (((_e3963[1] * _e3969[2]) - (_e3963[2] * _e3969[1])) + ((_e3984[1] * _e3990[2]) - (_e3984[2] * _e3990[1])));
                                    let _e4004 = (((_e3963[2] * _e3969[0]) - (_e3963[0] * _e3969[2])) + ((_e3984[2] * _e3990[0]) - (_e3984[0] * _e3990[2])));
                                    let _e4005 = (((_e3963[0] * _e3969[1]) - (_e3963[1] * _e3969[0])) + ((_e3984[0] * _e3990[1]) - (_e3984[1] * _e3990[0])));
                                    let _e4008 = local_1.member[0u];
                                    let _e4019 = local_1.member[1u];
                                    let _e4030 = local_1.member[0u];
                                    let _e4039 = ((((_e4019[0] * _e3933) + (_e4019[1] * _e3936)) + (_e4019[2] * _e3939)) + (((_e4030[0] * _e4003) + (_e4030[1] * _e4004)) + (_e4030[2] * _e4005)));
                                    let _e4042 = local_1.member[0u];
                                    let _e4053 = local_1.member[1u];
                                    let _e4062 = ((((_e4042[0] * _e3954) + (_e4042[1] * _e3957)) + (_e4042[2] * _e3960)) + (((_e4053[0] * _e4003) + (_e4053[1] * _e4004)) + (_e4053[2] * _e4005)));
                                    let _e4065 = local_1.member[1u];
                                    let _e4076 = local_1.member[0u];
                                    if (_e4076[0] < 0f) {
                                        phi_7304_ = -(_e4076[0]);
                                    } else {
                                        phi_7304_ = _e4076[0];
                                    }
                                    let _e4083 = phi_7304_;
                                    if (_e4076[1] < 0f) {
                                        phi_7311_ = -(_e4076[1]);
                                    } else {
                                        phi_7311_ = _e4076[1];
                                    }
                                    let _e4087 = phi_7311_;
                                    if (_e4083 > _e4087) {
                                        phi_7316_ = _e4083;
                                    } else {
                                        phi_7316_ = _e4087;
                                    }
                                    let _e4090 = phi_7316_;
                                    if (_e4076[2] < 0f) {
                                        phi_7323_ = -(_e4076[2]);
                                    } else {
                                        phi_7323_ = _e4076[2];
                                    }
                                    let _e4094 = phi_7323_;
                                    if (_e4090 > _e4094) {
                                        phi_7328_ = _e4090;
                                    } else {
                                        phi_7328_ = _e4094;
                                    }
                                    let _e4097 = phi_7328_;
                                    let _e4100 = local_1.member[1u];
                                    if (_e4100[0] < 0f) {
                                        phi_7341_ = -(_e4100[0]);
                                    } else {
                                        phi_7341_ = _e4100[0];
                                    }
                                    let _e4107 = phi_7341_;
                                    if (_e4100[1] < 0f) {
                                        phi_7348_ = -(_e4100[1]);
                                    } else {
                                        phi_7348_ = _e4100[1];
                                    }
                                    let _e4111 = phi_7348_;
                                    if (_e4107 > _e4111) {
                                        phi_7353_ = _e4107;
                                    } else {
                                        phi_7353_ = _e4111;
                                    }
                                    let _e4114 = phi_7353_;
                                    if (_e4100[2] < 0f) {
                                        phi_7360_ = -(_e4100[2]);
                                    } else {
                                        phi_7360_ = _e4100[2];
                                    }
                                    let _e4118 = phi_7360_;
                                    if (_e4114 > _e4118) {
                                        phi_7365_ = _e4114;
                                    } else {
                                        phi_7365_ = _e4118;
                                    }
                                    let _e4121 = phi_7365_;
                                    if (_e4097 > _e4121) {
                                        phi_7370_ = _e4097;
                                    } else {
                                        phi_7370_ = _e4121;
                                    }
                                    let _e4124 = phi_7370_;
                                    let _e4126 = local_1.member_3;
                                    let _e4127 = (_e4124 + _e4126);
                                    let _e4130 = local_1.member_1[0u];
                                    if (_e4130[0] < 0f) {
                                        phi_7387_ = -(_e4130[0]);
                                    } else {
                                        phi_7387_ = _e4130[0];
                                    }
                                    let _e4137 = phi_7387_;
                                    if (_e4130[1] < 0f) {
                                        phi_7394_ = -(_e4130[1]);
                                    } else {
                                        phi_7394_ = _e4130[1];
                                    }
                                    let _e4141 = phi_7394_;
                                    if (_e4137 > _e4141) {
                                        phi_7399_ = _e4137;
                                    } else {
                                        phi_7399_ = _e4141;
                                    }
                                    let _e4144 = phi_7399_;
                                    if (_e4130[2] < 0f) {
                                        phi_7406_ = -(_e4130[2]);
                                    } else {
                                        phi_7406_ = _e4130[2];
                                    }
                                    let _e4148 = phi_7406_;
                                    if (_e4144 > _e4148) {
                                        phi_7411_ = _e4144;
                                    } else {
                                        phi_7411_ = _e4148;
                                    }
                                    let _e4151 = phi_7411_;
                                    let _e4154 = local_1.member_1[1u];
                                    if (_e4154[0] < 0f) {
                                        phi_7425_ = -(_e4154[0]);
                                    } else {
                                        phi_7425_ = _e4154[0];
                                    }
                                    let _e4161 = phi_7425_;
                                    if (_e4154[1] < 0f) {
                                        phi_7432_ = -(_e4154[1]);
                                    } else {
                                        phi_7432_ = _e4154[1];
                                    }
                                    let _e4165 = phi_7432_;
                                    if (_e4161 > _e4165) {
                                        phi_7437_ = _e4161;
                                    } else {
                                        phi_7437_ = _e4165;
                                    }
                                    let _e4168 = phi_7437_;
                                    if (_e4154[2] < 0f) {
                                        phi_7444_ = -(_e4154[2]);
                                    } else {
                                        phi_7444_ = _e4154[2];
                                    }
                                    let _e4172 = phi_7444_;
                                    if (_e4168 > _e4172) {
                                        phi_7449_ = _e4168;
                                    } else {
                                        phi_7449_ = _e4172;
                                    }
                                    let _e4175 = phi_7449_;
                                    if (_e4151 > _e4175) {
                                        phi_7454_ = _e4151;
                                    } else {
                                        phi_7454_ = _e4175;
                                    }
                                    let _e4178 = phi_7454_;
                                    let _e4180 = local_1.member_3;
                                    let _e4181 = (_e4178 + _e4180);
                                    let _e4184 = local_1.member_2[0u];
                                    if (_e4184[0] < 0f) {
                                        phi_7471_ = -(_e4184[0]);
                                    } else {
                                        phi_7471_ = _e4184[0];
                                    }
                                    let _e4191 = phi_7471_;
                                    if (_e4184[1] < 0f) {
                                        phi_7478_ = -(_e4184[1]);
                                    } else {
                                        phi_7478_ = _e4184[1];
                                    }
                                    let _e4195 = phi_7478_;
                                    if (_e4191 > _e4195) {
                                        phi_7483_ = _e4191;
                                    } else {
                                        phi_7483_ = _e4195;
                                    }
                                    let _e4198 = phi_7483_;
                                    if (_e4184[2] < 0f) {
                                        phi_7490_ = -(_e4184[2]);
                                    } else {
                                        phi_7490_ = _e4184[2];
                                    }
                                    let _e4202 = phi_7490_;
                                    if (_e4198 > _e4202) {
                                        phi_7495_ = _e4198;
                                    } else {
                                        phi_7495_ = _e4202;
                                    }
                                    let _e4205 = phi_7495_;
                                    let _e4208 = local_1.member_2[1u];
                                    if (_e4208[0] < 0f) {
                                        phi_7509_ = -(_e4208[0]);
                                    } else {
                                        phi_7509_ = _e4208[0];
                                    }
                                    let _e4215 = phi_7509_;
                                    if (_e4208[1] < 0f) {
                                        phi_7516_ = -(_e4208[1]);
                                    } else {
                                        phi_7516_ = _e4208[1];
                                    }
                                    let _e4219 = phi_7516_;
                                    if (_e4215 > _e4219) {
                                        phi_7521_ = _e4215;
                                    } else {
                                        phi_7521_ = _e4219;
                                    }
                                    let _e4222 = phi_7521_;
                                    if (_e4208[2] < 0f) {
                                        phi_7528_ = -(_e4208[2]);
                                    } else {
                                        phi_7528_ = _e4208[2];
                                    }
                                    let _e4226 = phi_7528_;
                                    if (_e4222 > _e4226) {
                                        phi_7533_ = _e4222;
                                    } else {
                                        phi_7533_ = _e4226;
                                    }
                                    let _e4229 = phi_7533_;
                                    if (_e4205 > _e4229) {
                                        phi_7538_ = _e4205;
                                    } else {
                                        phi_7538_ = _e4229;
                                    }
                                    let _e4232 = phi_7538_;
                                    let _e4234 = local_1.member_3;
                                    let _e4235 = (_e4232 + _e4234);
                                    let _e4237 = ((_e4181 * 8f) * _e4235);
                                    let _e4244 = local_1.member_3;
                                    if (_e3933 < 0f) {
                                        phi_7569_ = -(_e3933);
                                    } else {
                                        phi_7569_ = _e3933;
                                    }
                                    let _e4261 = phi_7569_;
                                    if (_e3936 < 0f) {
                                        phi_7575_ = -(_e3936);
                                    } else {
                                        phi_7575_ = _e3936;
                                    }
                                    let _e4265 = phi_7575_;
                                    if (_e3939 < 0f) {
                                        phi_7582_ = -(_e3939);
                                    } else {
                                        phi_7582_ = _e3939;
                                    }
                                    let _e4270 = phi_7582_;
                                    let _e4271 = ((_e4261 + _e4265) + _e4270);
                                    if (_e3954 < 0f) {
                                        phi_7589_ = -(_e3954);
                                    } else {
                                        phi_7589_ = _e3954;
                                    }
                                    let _e4275 = phi_7589_;
                                    if (_e3957 < 0f) {
                                        phi_7595_ = -(_e3957);
                                    } else {
                                        phi_7595_ = _e3957;
                                    }
                                    let _e4279 = phi_7595_;
                                    if (_e3960 < 0f) {
                                        phi_7602_ = -(_e3960);
                                    } else {
                                        phi_7602_ = _e3960;
                                    }
                                    let _e4284 = phi_7602_;
                                    let _e4285 = ((_e4275 + _e4279) + _e4284);
                                    if (_e4271 > _e4285) {
                                        phi_7608_ = _e4271;
                                    } else {
                                        phi_7608_ = _e4285;
                                    }
                                    let _e4288 = phi_7608_;
                                    if (_e4003 < 0f) {
                                        phi_7614_ = -(_e4003);
                                    } else {
                                        phi_7614_ = _e4003;
                                    }
                                    let _e4292 = phi_7614_;
                                    if (_e4004 < 0f) {
                                        phi_7620_ = -(_e4004);
                                    } else {
                                        phi_7620_ = _e4004;
                                    }
                                    let _e4296 = phi_7620_;
                                    if (_e4005 < 0f) {
                                        phi_7627_ = -(_e4005);
                                    } else {
                                        phi_7627_ = _e4005;
                                    }
                                    let _e4301 = phi_7627_;
                                    let _e4303 = (((_e4292 + _e4296) + _e4301) * 0.5f);
                                    if (_e4288 > _e4303) {
                                        phi_7634_ = _e4288;
                                    } else {
                                        phi_7634_ = _e4303;
                                    }
                                    let _e4306 = phi_7634_;
                                    let _e4311 = local_1.member_3;
                                    let _e4324 = ((((_e4008[0] * _e3933) + (_e4008[1] * _e3936)) + (_e4008[2] * _e3939)) * 3f);
                                    let _e4325 = ((((_e4065[0] * _e3954) + (_e4065[1] * _e3957)) + (_e4065[2] * _e3960)) * 3f);
                                    if (_e4324 < _e4325) {
                                        phi_7658_ = _e4324;
                                    } else {
                                        phi_7658_ = _e4325;
                                    }
                                    let _e4328 = phi_7658_;
                                    if (_e4039 < _e4062) {
                                        phi_7663_ = _e4039;
                                    } else {
                                        phi_7663_ = _e4062;
                                    }
                                    let _e4331 = phi_7663_;
                                    if (_e4328 < _e4331) {
                                        phi_7668_ = _e4328;
                                    } else {
                                        phi_7668_ = _e4331;
                                    }
                                    let _e4334 = phi_7668_;
                                    if (_e4324 > _e4325) {
                                        phi_7673_ = _e4324;
                                    } else {
                                        phi_7673_ = _e4325;
                                    }
                                    let _e4337 = phi_7673_;
                                    if (_e4039 > _e4062) {
                                        phi_7678_ = _e4039;
                                    } else {
                                        phi_7678_ = _e4062;
                                    }
                                    let _e4340 = phi_7678_;
                                    if (_e4337 > _e4340) {
                                        phi_7683_ = _e4337;
                                    } else {
                                        phi_7683_ = _e4340;
                                    }
                                    let _e4343 = phi_7683_;
                                    let _e4348 = -(_e4343);
                                    if (_e4334 > _e4348) {
                                        phi_7693_ = _e4334;
                                    } else {
                                        phi_7693_ = _e4348;
                                    }
                                    let _e4351 = phi_7693_;
                                    let _e4353 = ((_e4351 - ((((((_e4127 * 8f) * _e4237) * (0.000000059604645f * (524f / 64f))) + ((_e4244 * 19f) * ((_e4127 * (_e4181 + _e4235)) + (_e4181 * _e4235)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4127) * ((1f + _e4181) * (1f + _e4235))))) + ((_e1873 * (((_e4306 + (_e4237 * (0.000000059604645f * 8f))) + ((_e4311 * 6f) * (_e4181 + _e4235))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4181) * (1f + _e4235))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4353 {
                                        phi_8662_ = _e4353;
                                    } else {
                                        let _e4356 = local_1.member_1[0u];
                                        let _e4362 = local_1.member_1[1u];
                                        let _e4366 = (_e4356[0] + _e4362[0]);
                                        let _e4367 = (_e4356[1] + _e4362[1]);
                                        let _e4368 = (_e4356[2] + _e4362[2]);
                                        let _e4371 = local_1.member_2[0u];
                                        let _e4377 = local_1.member_2[1u];
                                        let _e4381 = (_e4371[0] + _e4377[0]);
                                        let _e4382 = (_e4371[1] + _e4377[1]);
                                        let _e4383 = (_e4371[2] + _e4377[2]);
                                        let _e4386 = ((_e4367 * _e4383) - (_e4368 * _e4382));
                                        let _e4389 = ((_e4368 * _e4381) - (_e4366 * _e4383));
                                        let _e4392 = ((_e4366 * _e4382) - (_e4367 * _e4381));
                                        let _e4395 = local_1.member[0u];
                                        let _e4401 = local_1.member_1[0u];
                                        let _e4407 = local_1.member_2[0u];
                                        let _e4411 = (_e4395[0] - _e4401[0]);
                                        let _e4412 = (_e4395[1] - _e4401[1]);
                                        let _e4413 = (_e4395[2] - _e4401[2]);
                                        let _e4414 = (_e4411 - _e4407[0]);
                                        let _e4415 = (_e4412 - _e4407[1]);
                                        let _e4416 = (_e4413 - _e4407[2]);
                                        let _e4417 = (_e4395[0] - _e4407[0]);
                                        let _e4418 = (_e4395[1] - _e4407[1]);
                                        let _e4419 = (_e4395[2] - _e4407[2]);
                                        let _e4422 = local_1.member[1u];
                                        let _e4428 = local_1.member_1[1u];
                                        let _e4434 = local_1.member_2[1u];
                                        let _e4438 = (_e4422[0] - _e4428[0]);
                                        let _e4439 = (_e4422[1] - _e4428[1]);
                                        let _e4440 = (_e4422[2] - _e4428[2]);
                                        let _e4441 = (_e4438 - _e4434[0]);
                                        let _e4442 = (_e4439 - _e4434[1]);
                                        let _e4443 = (_e4440 - _e4434[2]);
                                        let _e4444 = (_e4422[0] - _e4434[0]);
                                        let _e4445 = (_e4422[1] - _e4434[1]);
                                        let _e4446 = (_e4422[2] - _e4434[2]);
                                        let _e4449 = local_1.member[0u];
                                        if (_e4449[0] < 0f) {
                                            phi_7896_ = -(_e4449[0]);
                                        } else {
                                            phi_7896_ = _e4449[0];
                                        }
                                        let _e4456 = phi_7896_;
                                        if (_e4449[1] < 0f) {
                                            phi_7903_ = -(_e4449[1]);
                                        } else {
                                            phi_7903_ = _e4449[1];
                                        }
                                        let _e4460 = phi_7903_;
                                        if (_e4456 > _e4460) {
                                            phi_7908_ = _e4456;
                                        } else {
                                            phi_7908_ = _e4460;
                                        }
                                        let _e4463 = phi_7908_;
                                        if (_e4449[2] < 0f) {
                                            phi_7915_ = -(_e4449[2]);
                                        } else {
                                            phi_7915_ = _e4449[2];
                                        }
                                        let _e4467 = phi_7915_;
                                        if (_e4463 > _e4467) {
                                            phi_7920_ = _e4463;
                                        } else {
                                            phi_7920_ = _e4467;
                                        }
                                        let _e4470 = phi_7920_;
                                        let _e4473 = local_1.member[1u];
                                        if (_e4473[0] < 0f) {
                                            phi_7933_ = -(_e4473[0]);
                                        } else {
                                            phi_7933_ = _e4473[0];
                                        }
                                        let _e4480 = phi_7933_;
                                        if (_e4473[1] < 0f) {
                                            phi_7940_ = -(_e4473[1]);
                                        } else {
                                            phi_7940_ = _e4473[1];
                                        }
                                        let _e4484 = phi_7940_;
                                        if (_e4480 > _e4484) {
                                            phi_7945_ = _e4480;
                                        } else {
                                            phi_7945_ = _e4484;
                                        }
                                        let _e4487 = phi_7945_;
                                        if (_e4473[2] < 0f) {
                                            phi_7952_ = -(_e4473[2]);
                                        } else {
                                            phi_7952_ = _e4473[2];
                                        }
                                        let _e4491 = phi_7952_;
                                        if (_e4487 > _e4491) {
                                            phi_7957_ = _e4487;
                                        } else {
                                            phi_7957_ = _e4491;
                                        }
                                        let _e4494 = phi_7957_;
                                        if (_e4470 > _e4494) {
                                            phi_7962_ = _e4470;
                                        } else {
                                            phi_7962_ = _e4494;
                                        }
                                        let _e4497 = phi_7962_;
                                        let _e4499 = local_1.member_3;
                                        let _e4503 = local_1.member_1[0u];
                                        if (_e4503[0] < 0f) {
                                            phi_7979_ = -(_e4503[0]);
                                        } else {
                                            phi_7979_ = _e4503[0];
                                        }
                                        let _e4510 = phi_7979_;
                                        if (_e4503[1] < 0f) {
                                            phi_7986_ = -(_e4503[1]);
                                        } else {
                                            phi_7986_ = _e4503[1];
                                        }
                                        let _e4514 = phi_7986_;
                                        if (_e4510 > _e4514) {
                                            phi_7991_ = _e4510;
                                        } else {
                                            phi_7991_ = _e4514;
                                        }
                                        let _e4517 = phi_7991_;
                                        if (_e4503[2] < 0f) {
                                            phi_7998_ = -(_e4503[2]);
                                        } else {
                                            phi_7998_ = _e4503[2];
                                        }
                                        let _e4521 = phi_7998_;
                                        if (_e4517 > _e4521) {
                                            phi_8003_ = _e4517;
                                        } else {
                                            phi_8003_ = _e4521;
                                        }
                                        let _e4524 = phi_8003_;
                                        let _e4527 = local_1.member_1[1u];
                                        if (_e4527[0] < 0f) {
                                            phi_8017_ = -(_e4527[0]);
                                        } else {
                                            phi_8017_ = _e4527[0];
                                        }
                                        let _e4534 = phi_8017_;
                                        if (_e4527[1] < 0f) {
                                            phi_8024_ = -(_e4527[1]);
                                        } else {
                                            phi_8024_ = _e4527[1];
                                        }
                                        let _e4538 = phi_8024_;
                                        if (_e4534 > _e4538) {
                                            phi_8029_ = _e4534;
                                        } else {
                                            phi_8029_ = _e4538;
                                        }
                                        let _e4541 = phi_8029_;
                                        if (_e4527[2] < 0f) {
                                            phi_8036_ = -(_e4527[2]);
                                        } else {
                                            phi_8036_ = _e4527[2];
                                        }
                                        let _e4545 = phi_8036_;
                                        if (_e4541 > _e4545) {
                                            phi_8041_ = _e4541;
                                        } else {
                                            phi_8041_ = _e4545;
                                        }
                                        let _e4548 = phi_8041_;
                                        if (_e4524 > _e4548) {
                                            phi_8046_ = _e4524;
                                        } else {
                                            phi_8046_ = _e4548;
                                        }
                                        let _e4551 = phi_8046_;
                                        let _e4553 = local_1.member_3;
                                        let _e4557 = local_1.member_2[0u];
                                        if (_e4557[0] < 0f) {
                                            phi_8063_ = -(_e4557[0]);
                                        } else {
                                            phi_8063_ = _e4557[0];
                                        }
                                        let _e4564 = phi_8063_;
                                        if (_e4557[1] < 0f) {
                                            phi_8070_ = -(_e4557[1]);
                                        } else {
                                            phi_8070_ = _e4557[1];
                                        }
                                        let _e4568 = phi_8070_;
                                        if (_e4564 > _e4568) {
                                            phi_8075_ = _e4564;
                                        } else {
                                            phi_8075_ = _e4568;
                                        }
                                        let _e4571 = phi_8075_;
                                        if (_e4557[2] < 0f) {
                                            phi_8082_ = -(_e4557[2]);
                                        } else {
                                            phi_8082_ = _e4557[2];
                                        }
                                        let _e4575 = phi_8082_;
                                        if (_e4571 > _e4575) {
                                            phi_8087_ = _e4571;
                                        } else {
                                            phi_8087_ = _e4575;
                                        }
                                        let _e4578 = phi_8087_;
                                        let _e4581 = local_1.member_2[1u];
                                        if (_e4581[0] < 0f) {
                                            phi_8101_ = -(_e4581[0]);
                                        } else {
                                            phi_8101_ = _e4581[0];
                                        }
                                        let _e4588 = phi_8101_;
                                        if (_e4581[1] < 0f) {
                                            phi_8108_ = -(_e4581[1]);
                                        } else {
                                            phi_8108_ = _e4581[1];
                                        }
                                        let _e4592 = phi_8108_;
                                        if (_e4588 > _e4592) {
                                            phi_8113_ = _e4588;
                                        } else {
                                            phi_8113_ = _e4592;
                                        }
                                        let _e4595 = phi_8113_;
                                        if (_e4581[2] < 0f) {
                                            phi_8120_ = -(_e4581[2]);
                                        } else {
                                            phi_8120_ = _e4581[2];
                                        }
                                        let _e4599 = phi_8120_;
                                        if (_e4595 > _e4599) {
                                            phi_8125_ = _e4595;
                                        } else {
                                            phi_8125_ = _e4599;
                                        }
                                        let _e4602 = phi_8125_;
                                        if (_e4578 > _e4602) {
                                            phi_8130_ = _e4578;
                                        } else {
                                            phi_8130_ = _e4602;
                                        }
                                        let _e4605 = phi_8130_;
                                        let _e4607 = local_1.member_3;
                                        let _e4611 = ((((_e4497 + _e4499) + (_e4551 + _e4553)) + (_e4605 + _e4607)) * 2f);
                                        let _e4614 = local_1.member_3;
                                        let _e4618 = (((_e1873 * 1.0001f) + (_e4614 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4621 = ((_e4389 * _e4368) - (_e4392 * _e4367));
                                        let _e4624 = ((_e4392 * _e4366) - (_e4386 * _e4368));
                                        let _e4627 = ((_e4386 * _e4367) - (_e4389 * _e4366));
                                        let _e4632 = (((_e4621 * _e4395[0]) + (_e4624 * _e4395[1])) + (_e4627 * _e4395[2]));
                                        let _e4637 = (((_e4621 * _e4411) + (_e4624 * _e4412)) + (_e4627 * _e4413));
                                        let _e4642 = (((_e4621 * _e4417) + (_e4624 * _e4418)) + (_e4627 * _e4419));
                                        let _e4647 = (((_e4621 * _e4414) + (_e4624 * _e4415)) + (_e4627 * _e4416));
                                        let _e4652 = (((_e4621 * _e4422[0]) + (_e4624 * _e4422[1])) + (_e4627 * _e4422[2]));
                                        let _e4657 = (((_e4621 * _e4438) + (_e4624 * _e4439)) + (_e4627 * _e4440));
                                        let _e4662 = (((_e4621 * _e4444) + (_e4624 * _e4445)) + (_e4627 * _e4446));
                                        let _e4667 = (((_e4621 * _e4441) + (_e4624 * _e4442)) + (_e4627 * _e4443));
                                        if (_e4632 < _e4637) {
                                            phi_8209_ = _e4632;
                                        } else {
                                            phi_8209_ = _e4637;
                                        }
                                        let _e4670 = phi_8209_;
                                        if (_e4642 < _e4647) {
                                            phi_8214_ = _e4642;
                                        } else {
                                            phi_8214_ = _e4647;
                                        }
                                        let _e4673 = phi_8214_;
                                        if (_e4670 < _e4673) {
                                            phi_8219_ = _e4670;
                                        } else {
                                            phi_8219_ = _e4673;
                                        }
                                        let _e4676 = phi_8219_;
                                        if (_e4652 < _e4657) {
                                            phi_8224_ = _e4652;
                                        } else {
                                            phi_8224_ = _e4657;
                                        }
                                        let _e4679 = phi_8224_;
                                        if (_e4662 < _e4667) {
                                            phi_8229_ = _e4662;
                                        } else {
                                            phi_8229_ = _e4667;
                                        }
                                        let _e4682 = phi_8229_;
                                        if (_e4679 < _e4682) {
                                            phi_8234_ = _e4679;
                                        } else {
                                            phi_8234_ = _e4682;
                                        }
                                        let _e4685 = phi_8234_;
                                        if (_e4676 < _e4685) {
                                            phi_8239_ = _e4676;
                                        } else {
                                            phi_8239_ = _e4685;
                                        }
                                        let _e4688 = phi_8239_;
                                        if (_e4632 > _e4637) {
                                            phi_8244_ = _e4632;
                                        } else {
                                            phi_8244_ = _e4637;
                                        }
                                        let _e4691 = phi_8244_;
                                        if (_e4642 > _e4647) {
                                            phi_8249_ = _e4642;
                                        } else {
                                            phi_8249_ = _e4647;
                                        }
                                        let _e4694 = phi_8249_;
                                        if (_e4691 > _e4694) {
                                            phi_8254_ = _e4691;
                                        } else {
                                            phi_8254_ = _e4694;
                                        }
                                        let _e4697 = phi_8254_;
                                        if (_e4652 > _e4657) {
                                            phi_8259_ = _e4652;
                                        } else {
                                            phi_8259_ = _e4657;
                                        }
                                        let _e4700 = phi_8259_;
                                        if (_e4662 > _e4667) {
                                            phi_8264_ = _e4662;
                                        } else {
                                            phi_8264_ = _e4667;
                                        }
                                        let _e4703 = phi_8264_;
                                        if (_e4700 > _e4703) {
                                            phi_8269_ = _e4700;
                                        } else {
                                            phi_8269_ = _e4703;
                                        }
                                        let _e4706 = phi_8269_;
                                        if (_e4697 > _e4706) {
                                            phi_8274_ = _e4697;
                                        } else {
                                            phi_8274_ = _e4706;
                                        }
                                        let _e4709 = phi_8274_;
                                        if (_e4621 < 0f) {
                                            phi_8280_ = -(_e4621);
                                        } else {
                                            phi_8280_ = _e4621;
                                        }
                                        let _e4713 = phi_8280_;
                                        if (_e4624 < 0f) {
                                            phi_8286_ = -(_e4624);
                                        } else {
                                            phi_8286_ = _e4624;
                                        }
                                        let _e4717 = phi_8286_;
                                        if (_e4627 < 0f) {
                                            phi_8293_ = -(_e4627);
                                        } else {
                                            phi_8293_ = _e4627;
                                        }
                                        let _e4722 = phi_8293_;
                                        let _e4723 = ((_e4713 + _e4717) + _e4722);
                                        let _e4728 = -(_e4709);
                                        if (_e4688 > _e4728) {
                                            phi_8304_ = _e4688;
                                        } else {
                                            phi_8304_ = _e4728;
                                        }
                                        let _e4731 = phi_8304_;
                                        let _e4736 = (((_e4731 - ((_e4723 * _e4611) * (0.000000059604645f * (17f / 2f)))) - (_e4723 * _e4618)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4739 = ((_e4389 * _e4383) - (_e4392 * _e4382));
                                        let _e4742 = ((_e4392 * _e4381) - (_e4386 * _e4383));
                                        let _e4745 = ((_e4386 * _e4382) - (_e4389 * _e4381));
                                        let _e4750 = (((_e4739 * _e4395[0]) + (_e4742 * _e4395[1])) + (_e4745 * _e4395[2]));
                                        let _e4755 = (((_e4739 * _e4411) + (_e4742 * _e4412)) + (_e4745 * _e4413));
                                        let _e4760 = (((_e4739 * _e4417) + (_e4742 * _e4418)) + (_e4745 * _e4419));
                                        let _e4765 = (((_e4739 * _e4414) + (_e4742 * _e4415)) + (_e4745 * _e4416));
                                        let _e4770 = (((_e4739 * _e4422[0]) + (_e4742 * _e4422[1])) + (_e4745 * _e4422[2]));
                                        let _e4775 = (((_e4739 * _e4438) + (_e4742 * _e4439)) + (_e4745 * _e4440));
                                        let _e4780 = (((_e4739 * _e4444) + (_e4742 * _e4445)) + (_e4745 * _e4446));
                                        let _e4785 = (((_e4739 * _e4441) + (_e4742 * _e4442)) + (_e4745 * _e4443));
                                        if (_e4750 < _e4755) {
                                            phi_8375_ = _e4750;
                                        } else {
                                            phi_8375_ = _e4755;
                                        }
                                        let _e4788 = phi_8375_;
                                        if (_e4760 < _e4765) {
                                            phi_8380_ = _e4760;
                                        } else {
                                            phi_8380_ = _e4765;
                                        }
                                        let _e4791 = phi_8380_;
                                        if (_e4788 < _e4791) {
                                            phi_8385_ = _e4788;
                                        } else {
                                            phi_8385_ = _e4791;
                                        }
                                        let _e4794 = phi_8385_;
                                        if (_e4770 < _e4775) {
                                            phi_8390_ = _e4770;
                                        } else {
                                            phi_8390_ = _e4775;
                                        }
                                        let _e4797 = phi_8390_;
                                        if (_e4780 < _e4785) {
                                            phi_8395_ = _e4780;
                                        } else {
                                            phi_8395_ = _e4785;
                                        }
                                        let _e4800 = phi_8395_;
                                        if (_e4797 < _e4800) {
                                            phi_8400_ = _e4797;
                                        } else {
                                            phi_8400_ = _e4800;
                                        }
                                        let _e4803 = phi_8400_;
                                        if (_e4794 < _e4803) {
                                            phi_8405_ = _e4794;
                                        } else {
                                            phi_8405_ = _e4803;
                                        }
                                        let _e4806 = phi_8405_;
                                        if (_e4750 > _e4755) {
                                            phi_8410_ = _e4750;
                                        } else {
                                            phi_8410_ = _e4755;
                                        }
                                        let _e4809 = phi_8410_;
                                        if (_e4760 > _e4765) {
                                            phi_8415_ = _e4760;
                                        } else {
                                            phi_8415_ = _e4765;
                                        }
                                        let _e4812 = phi_8415_;
                                        if (_e4809 > _e4812) {
                                            phi_8420_ = _e4809;
                                        } else {
                                            phi_8420_ = _e4812;
                                        }
                                        let _e4815 = phi_8420_;
                                        if (_e4770 > _e4775) {
                                            phi_8425_ = _e4770;
                                        } else {
                                            phi_8425_ = _e4775;
                                        }
                                        let _e4818 = phi_8425_;
                                        if (_e4780 > _e4785) {
                                            phi_8430_ = _e4780;
                                        } else {
                                            phi_8430_ = _e4785;
                                        }
                                        let _e4821 = phi_8430_;
                                        if (_e4818 > _e4821) {
                                            phi_8435_ = _e4818;
                                        } else {
                                            phi_8435_ = _e4821;
                                        }
                                        let _e4824 = phi_8435_;
                                        if (_e4815 > _e4824) {
                                            phi_8440_ = _e4815;
                                        } else {
                                            phi_8440_ = _e4824;
                                        }
                                        let _e4827 = phi_8440_;
                                        if (_e4739 < 0f) {
                                            phi_8446_ = -(_e4739);
                                        } else {
                                            phi_8446_ = _e4739;
                                        }
                                        let _e4831 = phi_8446_;
                                        if (_e4742 < 0f) {
                                            phi_8452_ = -(_e4742);
                                        } else {
                                            phi_8452_ = _e4742;
                                        }
                                        let _e4835 = phi_8452_;
                                        if (_e4745 < 0f) {
                                            phi_8459_ = -(_e4745);
                                        } else {
                                            phi_8459_ = _e4745;
                                        }
                                        let _e4840 = phi_8459_;
                                        let _e4841 = ((_e4831 + _e4835) + _e4840);
                                        let _e4846 = -(_e4827);
                                        if (_e4806 > _e4846) {
                                            phi_8470_ = _e4806;
                                        } else {
                                            phi_8470_ = _e4846;
                                        }
                                        let _e4849 = phi_8470_;
                                        let _e4854 = (((_e4849 - ((_e4841 * _e4611) * (0.000000059604645f * (17f / 2f)))) - (_e4841 * _e4618)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4736 > _e4854) {
                                            phi_8480_ = _e4736;
                                        } else {
                                            phi_8480_ = _e4854;
                                        }
                                        let _e4857 = phi_8480_;
                                        phi_8662_ = (_e4353 || (_e4857 > 0f));
                                    }
                                    let _e4861 = phi_8662_;
                                    phi_8664_ = (_e3918 && _e4861);
                                } else {
                                    phi_8664_ = _e3918;
                                }
                                let _e4864 = phi_8664_;
                                phi_8666_ = (_e2885 || _e4864);
                            }
                            let _e4867 = phi_8666_;
                            if !(_e4867) {
                                let _e4870 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1216] = ((2147483648u | (_e4870 << bitcast<u32>(12i))) | _e1219);
                            }
                        }
                        phi_8677_ = true;
                    }
                    let _e4877 = phi_8677_;
                    phi_8678_ = _e4877;
                } else {
                    phi_8678_ = false;
                }
                let _e4879 = phi_8678_;
                continue;
                continuing {
                    phi_2250_ = _e1208;
                    break if !(_e4879);
                }
            }
            workgroupBarrier();
            if (_e73 == 0u) {
                let _e4883 = atomicLoad((&counters[5u]));
                if (_e4883 > 0u) {
                    let _e4886 = atomicAdd((&output.member[0u]), _e4883);
                    if ((_e4886 + _e4883) < _e4886) {
                        let _e4890 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4886);
                }
            }
            workgroupBarrier();
            let _e4893 = atomicLoad((&counters[6u]));
            if (_e73 == 0u) {
                let _e4896 = atomicLoad((&counters[7u]));
                if (_e4896 > 0u) {
                    let _e4899 = atomicAdd((&output.member[1u]), _e4896);
                    if ((_e4899 + _e4896) < _e4899) {
                        let _e4903 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_8728_ = type_9(0u, 16u);
            loop {
                let _e4905 = phi_8728_;
                if (_e4905.member < _e4905.member_1) {
                    phi_8729_ = type_9((_e4905.member + 1u), _e4905.member_1);
                    phi_8752_ = type_9(1u, _e4905.member);
                } else {
                    phi_8729_ = _e4905;
                    phi_8752_ = type_9(0u, type_9().member_1);
                }
                let _e4917 = phi_8729_;
                let _e4919 = phi_8752_;
                if (bitcast<i32>(_e4919.member) != 0i) {
                    let _e4925 = (_e73 + (_e4919.member_1 * 128u));
                    if (_e4925 >= _e1194) {
                        phi_8849_ = false;
                    } else {
                        let _e4928 = hits[_e4925];
                        if ((_e4928 & 2147483648u) == 0u) {
                            phi_8775_ = 4294967295u;
                        } else {
                            phi_8775_ = ((_e4928 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4935 = phi_8775_;
                        if (_e4935 != 4294967295u) {
                            let _e4939 = ((_e4928 >> bitcast<u32>(10i)) & 3u);
                            let _e4946 = firsts[(2u * _e4939)];
                            let _e4949 = leaves.member[(_e4946 + ((_e4928 >> bitcast<u32>(5i)) & 31u))];
                            let _e4953 = firsts[((2u * _e4939) + 1u)];
                            let _e4956 = leaves.member[(_e4953 + (_e4928 & 31u))];
                            let _e4961 = params.member.member_1.member_3;
                            let _e4962 = (_e4893 + _e4935);
                            if (_e4949.member_1 < _e4956.member_1) {
                                phi_8830_ = type_9(_e4949.member_1, _e4956.member_1);
                            } else {
                                phi_8830_ = type_9(_e4956.member_1, _e4949.member_1);
                            }
                            let _e4967 = phi_8830_;
                            if (_e4962 < _e4961) {
                                let _e4971 = (2u * _e4962);
                                atomicStore((&output.member[(4u + _e4971)]), _e4967.member);
                                atomicStore((&output.member[(_e4971 + 5u)]), _e4967.member_1);
                            }
                        }
                        phi_8849_ = true;
                    }
                    let _e4977 = phi_8849_;
                    phi_8850_ = _e4977;
                } else {
                    phi_8850_ = false;
                }
                let _e4979 = phi_8850_;
                continue;
                continuing {
                    phi_8728_ = _e4917;
                    break if !(_e4979);
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
fn filter_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
