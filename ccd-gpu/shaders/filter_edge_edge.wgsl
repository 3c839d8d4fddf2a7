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

struct type_16 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_20 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_23 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_29 {
    member: array<type_27>,
}

struct type_35 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_37 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_41 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage> leaves: type_25;
@group(0) @binding(1) 
var<storage> nodes: type_29;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_27, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_35;
@group(0) @binding(5) 
var<storage> paths: type_22;
@group(0) @binding(6) 
var<storage> input: type_11;
@group(0) @binding(7) 
var<storage, read_write> output: type_41;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_172_: bool;
    var phi_173_: bool;
    var phi_177_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_173_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_172_ = (param[0] > param_1[0]);
        } else {
            phi_172_ = false;
        }
        let _e14 = phi_172_;
        phi_173_ = _e14;
    }
    let _e16 = phi_173_;
    if _e16 {
        phi_177_ = param_1;
    } else {
        phi_177_ = param;
    }
    let _e18 = phi_177_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_196_: bool;
    var phi_197_: bool;
    var phi_201_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_197_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_196_ = (param_3[0] > param_2[0]);
        } else {
            phi_196_ = false;
        }
        let _e14 = phi_196_;
        phi_197_ = _e14;
    }
    let _e16 = phi_197_;
    if _e16 {
        phi_201_ = param_3;
    } else {
        phi_201_ = param_2;
    }
    let _e18 = phi_201_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_220_: bool;
    var phi_221_: bool;
    var phi_225_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_221_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_220_ = (param_4[0] > param_5[0]);
        } else {
            phi_220_ = false;
        }
        let _e14 = phi_220_;
        phi_221_ = _e14;
    }
    let _e16 = phi_221_;
    if _e16 {
        phi_225_ = param_5;
    } else {
        phi_225_ = param_4;
    }
    let _e18 = phi_225_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_244_: bool;
    var phi_245_: bool;
    var phi_249_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_245_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_244_ = (param_7[0] > param_6[0]);
        } else {
            phi_244_ = false;
        }
        let _e14 = phi_244_;
        phi_245_ = _e14;
    }
    let _e16 = phi_245_;
    if _e16 {
        phi_249_ = param_7;
    } else {
        phi_249_ = param_6;
    }
    let _e18 = phi_249_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_268_: bool;
    var phi_269_: bool;
    var phi_273_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_269_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_268_ = (param_8[0] > param_9[0]);
        } else {
            phi_268_ = false;
        }
        let _e14 = phi_268_;
        phi_269_ = _e14;
    }
    let _e16 = phi_269_;
    if _e16 {
        phi_273_ = param_9;
    } else {
        phi_273_ = param_8;
    }
    let _e18 = phi_273_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_297_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_293_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_292_ = (param_11[0] > param_10[0]);
        } else {
            phi_292_ = false;
        }
        let _e14 = phi_292_;
        phi_293_ = _e14;
    }
    let _e16 = phi_293_;
    if _e16 {
        phi_297_ = param_11;
    } else {
        phi_297_ = param_10;
    }
    let _e18 = phi_297_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_37;
    var local_1: type_37;
    var local_2: type_37;
    var phi_344_: u32;
    var phi_385_: u32;
    var phi_386_: u32;
    var phi_394_: u32;
    var phi_410_: u32;
    var phi_431_: u32;
    var phi_432_: u32;
    var phi_435_: type_9;
    var phi_436_: type_9;
    var phi_459_: type_9;
    var phi_500_: u32;
    var phi_501_: u32;
    var phi_509_: u32;
    var phi_521_: u32;
    var phi_606_: array<u32, 2>;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_809_: type_27;
    var phi_822_: type_9;
    var phi_825_: u32;
    var phi_823_: type_9;
    var phi_848_: type_9;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_920_: bool;
    var phi_938_: u32;
    var phi_939_: u32;
    var phi_940_: u32;
    var phi_826_: u32;
    var phi_943_: type_9;
    var phi_946_: u32;
    var phi_944_: type_9;
    var phi_969_: type_9;
    var phi_1077_: bool;
    var phi_1083_: bool;
    var phi_1089_: bool;
    var phi_1090_: bool;
    var phi_1136_: bool;
    var phi_1143_: bool;
    var phi_1147_: bool;
    var phi_1283_: bool;
    var phi_1284_: bool;
    var phi_1377_: bool;
    var phi_1378_: bool;
    var phi_1472_: bool;
    var phi_1473_: bool;
    var phi_1566_: bool;
    var phi_1567_: bool;
    var phi_1662_: bool;
    var phi_1663_: bool;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1775_: bool;
    var phi_1794_: type_9;
    var phi_1837_: u32;
    var phi_1838_: bool;
    var phi_947_: u32;
    var phi_1839_: bool;
    var phi_1846_: u32;
    var phi_1849_: type_9;
    var phi_1850_: type_9;
    var phi_1873_: type_9;
    var phi_1989_: bool;
    var phi_1995_: bool;
    var phi_2001_: bool;
    var phi_2002_: bool;
    var phi_2048_: bool;
    var phi_2055_: bool;
    var phi_2059_: bool;
    var phi_2195_: bool;
    var phi_2196_: bool;
    var phi_2289_: bool;
    var phi_2290_: bool;
    var phi_2384_: bool;
    var phi_2385_: bool;
    var phi_2478_: bool;
    var phi_2479_: bool;
    var phi_2574_: bool;
    var phi_2575_: bool;
    var phi_2668_: bool;
    var phi_2669_: bool;
    var phi_2673_: bool;
    var phi_2674_: bool;
    var phi_2675_: bool;
    var phi_2679_: bool;
    var phi_2680_: bool;
    var phi_2681_: bool;
    var phi_2682_: bool;
    var phi_2683_: bool;
    var phi_2687_: bool;
    var phi_2700_: type_23;
    var phi_2701_: type_23;
    var phi_3090_: f32;
    var phi_3097_: f32;
    var phi_3102_: f32;
    var phi_3109_: f32;
    var phi_3114_: f32;
    var phi_3127_: f32;
    var phi_3134_: f32;
    var phi_3139_: f32;
    var phi_3146_: f32;
    var phi_3151_: f32;
    var phi_3156_: f32;
    var phi_3173_: f32;
    var phi_3180_: f32;
    var phi_3185_: f32;
    var phi_3192_: f32;
    var phi_3197_: f32;
    var phi_3211_: f32;
    var phi_3218_: f32;
    var phi_3223_: f32;
    var phi_3230_: f32;
    var phi_3235_: f32;
    var phi_3240_: f32;
    var phi_3257_: f32;
    var phi_3264_: f32;
    var phi_3269_: f32;
    var phi_3276_: f32;
    var phi_3281_: f32;
    var phi_3295_: f32;
    var phi_3302_: f32;
    var phi_3307_: f32;
    var phi_3314_: f32;
    var phi_3319_: f32;
    var phi_3324_: f32;
    var phi_3355_: f32;
    var phi_3361_: f32;
    var phi_3368_: f32;
    var phi_3375_: f32;
    var phi_3381_: f32;
    var phi_3388_: f32;
    var phi_3394_: f32;
    var phi_3400_: f32;
    var phi_3406_: f32;
    var phi_3413_: f32;
    var phi_3420_: f32;
    var phi_3444_: f32;
    var phi_3449_: f32;
    var phi_3454_: f32;
    var phi_3459_: f32;
    var phi_3464_: f32;
    var phi_3469_: f32;
    var phi_3479_: f32;
    var phi_3682_: f32;
    var phi_3689_: f32;
    var phi_3694_: f32;
    var phi_3701_: f32;
    var phi_3706_: f32;
    var phi_3719_: f32;
    var phi_3726_: f32;
    var phi_3731_: f32;
    var phi_3738_: f32;
    var phi_3743_: f32;
    var phi_3748_: f32;
    var phi_3765_: f32;
    var phi_3772_: f32;
    var phi_3777_: f32;
    var phi_3784_: f32;
    var phi_3789_: f32;
    var phi_3803_: f32;
    var phi_3810_: f32;
    var phi_3815_: f32;
    var phi_3822_: f32;
    var phi_3827_: f32;
    var phi_3832_: f32;
    var phi_3849_: f32;
    var phi_3856_: f32;
    var phi_3861_: f32;
    var phi_3868_: f32;
    var phi_3873_: f32;
    var phi_3887_: f32;
    var phi_3894_: f32;
    var phi_3899_: f32;
    var phi_3906_: f32;
    var phi_3911_: f32;
    var phi_3916_: f32;
    var phi_3995_: f32;
    var phi_4000_: f32;
    var phi_4005_: f32;
    var phi_4010_: f32;
    var phi_4015_: f32;
    var phi_4020_: f32;
    var phi_4025_: f32;
    var phi_4030_: f32;
    var phi_4035_: f32;
    var phi_4040_: f32;
    var phi_4045_: f32;
    var phi_4050_: f32;
    var phi_4055_: f32;
    var phi_4060_: f32;
    var phi_4066_: f32;
    var phi_4072_: f32;
    var phi_4079_: f32;
    var phi_4090_: f32;
    var phi_4161_: f32;
    var phi_4166_: f32;
    var phi_4171_: f32;
    var phi_4176_: f32;
    var phi_4181_: f32;
    var phi_4186_: f32;
    var phi_4191_: f32;
    var phi_4196_: f32;
    var phi_4201_: f32;
    var phi_4206_: f32;
    var phi_4211_: f32;
    var phi_4216_: f32;
    var phi_4221_: f32;
    var phi_4226_: f32;
    var phi_4232_: f32;
    var phi_4238_: f32;
    var phi_4245_: f32;
    var phi_4256_: f32;
    var phi_4266_: f32;
    var phi_4448_: bool;
    var phi_4900_: f32;
    var phi_4907_: f32;
    var phi_4912_: f32;
    var phi_4919_: f32;
    var phi_4924_: f32;
    var phi_4937_: f32;
    var phi_4944_: f32;
    var phi_4949_: f32;
    var phi_4956_: f32;
    var phi_4961_: f32;
    var phi_4966_: f32;
    var phi_4983_: f32;
    var phi_4990_: f32;
    var phi_4995_: f32;
    var phi_5002_: f32;
    var phi_5007_: f32;
    var phi_5021_: f32;
    var phi_5028_: f32;
    var phi_5033_: f32;
    var phi_5040_: f32;
    var phi_5045_: f32;
    var phi_5050_: f32;
    var phi_5067_: f32;
    var phi_5074_: f32;
    var phi_5079_: f32;
    var phi_5086_: f32;
    var phi_5091_: f32;
    var phi_5105_: f32;
    var phi_5112_: f32;
    var phi_5117_: f32;
    var phi_5124_: f32;
    var phi_5129_: f32;
    var phi_5134_: f32;
    var phi_5165_: f32;
    var phi_5171_: f32;
    var phi_5178_: f32;
    var phi_5185_: f32;
    var phi_5191_: f32;
    var phi_5198_: f32;
    var phi_5204_: f32;
    var phi_5210_: f32;
    var phi_5216_: f32;
    var phi_5223_: f32;
    var phi_5230_: f32;
    var phi_5254_: f32;
    var phi_5259_: f32;
    var phi_5264_: f32;
    var phi_5269_: f32;
    var phi_5274_: f32;
    var phi_5279_: f32;
    var phi_5289_: f32;
    var phi_5492_: f32;
    var phi_5499_: f32;
    var phi_5504_: f32;
    var phi_5511_: f32;
    var phi_5516_: f32;
    var phi_5529_: f32;
    var phi_5536_: f32;
    var phi_5541_: f32;
    var phi_5548_: f32;
    var phi_5553_: f32;
    var phi_5558_: f32;
    var phi_5575_: f32;
    var phi_5582_: f32;
    var phi_5587_: f32;
    var phi_5594_: f32;
    var phi_5599_: f32;
    var phi_5613_: f32;
    var phi_5620_: f32;
    var phi_5625_: f32;
    var phi_5632_: f32;
    var phi_5637_: f32;
    var phi_5642_: f32;
    var phi_5659_: f32;
    var phi_5666_: f32;
    var phi_5671_: f32;
    var phi_5678_: f32;
    var phi_5683_: f32;
    var phi_5697_: f32;
    var phi_5704_: f32;
    var phi_5709_: f32;
    var phi_5716_: f32;
    var phi_5721_: f32;
    var phi_5726_: f32;
    var phi_5805_: f32;
    var phi_5810_: f32;
    var phi_5815_: f32;
    var phi_5820_: f32;
    var phi_5825_: f32;
    var phi_5830_: f32;
    var phi_5835_: f32;
    var phi_5840_: f32;
    var phi_5845_: f32;
    var phi_5850_: f32;
    var phi_5855_: f32;
    var phi_5860_: f32;
    var phi_5865_: f32;
    var phi_5870_: f32;
    var phi_5876_: f32;
    var phi_5882_: f32;
    var phi_5889_: f32;
    var phi_5900_: f32;
    var phi_5971_: f32;
    var phi_5976_: f32;
    var phi_5981_: f32;
    var phi_5986_: f32;
    var phi_5991_: f32;
    var phi_5996_: f32;
    var phi_6001_: f32;
    var phi_6006_: f32;
    var phi_6011_: f32;
    var phi_6016_: f32;
    var phi_6021_: f32;
    var phi_6026_: f32;
    var phi_6031_: f32;
    var phi_6036_: f32;
    var phi_6042_: f32;
    var phi_6048_: f32;
    var phi_6055_: f32;
    var phi_6066_: f32;
    var phi_6076_: f32;
    var phi_6258_: bool;
    var phi_6503_: f32;
    var phi_6510_: f32;
    var phi_6515_: f32;
    var phi_6522_: f32;
    var phi_6527_: f32;
    var phi_6540_: f32;
    var phi_6547_: f32;
    var phi_6552_: f32;
    var phi_6559_: f32;
    var phi_6564_: f32;
    var phi_6569_: f32;
    var phi_6586_: f32;
    var phi_6593_: f32;
    var phi_6598_: f32;
    var phi_6605_: f32;
    var phi_6610_: f32;
    var phi_6624_: f32;
    var phi_6631_: f32;
    var phi_6636_: f32;
    var phi_6643_: f32;
    var phi_6648_: f32;
    var phi_6653_: f32;
    var phi_6670_: f32;
    var phi_6677_: f32;
    var phi_6682_: f32;
    var phi_6689_: f32;
    var phi_6694_: f32;
    var phi_6708_: f32;
    var phi_6715_: f32;
    var phi_6720_: f32;
    var phi_6727_: f32;
    var phi_6732_: f32;
    var phi_6737_: f32;
    var phi_6768_: f32;
    var phi_6774_: f32;
    var phi_6781_: f32;
    var phi_6788_: f32;
    var phi_6794_: f32;
    var phi_6801_: f32;
    var phi_6807_: f32;
    var phi_6813_: f32;
    var phi_6819_: f32;
    var phi_6826_: f32;
    var phi_6833_: f32;
    var phi_6857_: f32;
    var phi_6862_: f32;
    var phi_6867_: f32;
    var phi_6872_: f32;
    var phi_6877_: f32;
    var phi_6882_: f32;
    var phi_6892_: f32;
    var phi_7095_: f32;
    var phi_7102_: f32;
    var phi_7107_: f32;
    var phi_7114_: f32;
    var phi_7119_: f32;
    var phi_7132_: f32;
    var phi_7139_: f32;
    var phi_7144_: f32;
    var phi_7151_: f32;
    var phi_7156_: f32;
    var phi_7161_: f32;
    var phi_7178_: f32;
    var phi_7185_: f32;
    var phi_7190_: f32;
    var phi_7197_: f32;
    var phi_7202_: f32;
    var phi_7216_: f32;
    var phi_7223_: f32;
    var phi_7228_: f32;
    var phi_7235_: f32;
    var phi_7240_: f32;
    var phi_7245_: f32;
    var phi_7262_: f32;
    var phi_7269_: f32;
    var phi_7274_: f32;
    var phi_7281_: f32;
    var phi_7286_: f32;
    var phi_7300_: f32;
    var phi_7307_: f32;
    var phi_7312_: f32;
    var phi_7319_: f32;
    var phi_7324_: f32;
    var phi_7329_: f32;
    var phi_7408_: f32;
    var phi_7413_: f32;
    var phi_7418_: f32;
    var phi_7423_: f32;
    var phi_7428_: f32;
    var phi_7433_: f32;
    var phi_7438_: f32;
    var phi_7443_: f32;
    var phi_7448_: f32;
    var phi_7453_: f32;
    var phi_7458_: f32;
    var phi_7463_: f32;
    var phi_7468_: f32;
    var phi_7473_: f32;
    var phi_7479_: f32;
    var phi_7485_: f32;
    var phi_7492_: f32;
    var phi_7503_: f32;
    var phi_7574_: f32;
    var phi_7579_: f32;
    var phi_7584_: f32;
    var phi_7589_: f32;
    var phi_7594_: f32;
    var phi_7599_: f32;
    var phi_7604_: f32;
    var phi_7609_: f32;
    var phi_7614_: f32;
    var phi_7619_: f32;
    var phi_7624_: f32;
    var phi_7629_: f32;
    var phi_7634_: f32;
    var phi_7639_: f32;
    var phi_7645_: f32;
    var phi_7651_: f32;
    var phi_7658_: f32;
    var phi_7669_: f32;
    var phi_7679_: f32;
    var phi_7861_: bool;
    var phi_7863_: bool;
    var phi_7865_: bool;
    var phi_7876_: bool;
    var phi_7877_: bool;
    var phi_7927_: type_9;
    var phi_7928_: type_9;
    var phi_7951_: type_9;
    var phi_7974_: u32;
    var phi_8029_: type_9;
    var phi_8048_: bool;
    var phi_8049_: bool;
    var local_3: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e65 = id_2;
    let _e66 = n_2;
    let _e67 = lane_2;
    let _e80 = ((_e65.y * _e66.x) + _e65.x);
    let _e83 = (_e66.x * _e66.y);
    let _e86 = params.member.member_1.member_2;
    let _e88 = input.member[0u];
    if (_e86 < _e88) {
        phi_344_ = _e86;
    } else {
        phi_344_ = _e88;
    }
    let _e91 = phi_344_;
    let _e92 = (_e67 / 32u);
    let _e93 = (_e67 % 32u);
    let _e96 = params.member.member_1.member_1;
    if (_e91 > _e96) {
        let _e100 = params.member.member_1.member_1;
        let _e101 = (_e91 - _e100);
        let _e104 = params.member.member_2.member_3;
        if (_e104 == 0u) {
            return;
        }
        let _e106 = (_e101 / _e104);
        if (_e104 == 0u) {
            return;
        }
        if ((_e101 % _e104) > 0u) {
            phi_385_ = (_e106 + 1u);
        } else {
            phi_385_ = _e106;
        }
        let _e112 = phi_385_;
        phi_386_ = _e112;
    } else {
        phi_386_ = 0u;
    }
    let _e114 = phi_386_;
    let _e117 = params.member.member_2.member_4;
    if (_e117 < _e114) {
        phi_394_ = _e117;
    } else {
        phi_394_ = _e114;
    }
    let _e120 = phi_394_;
    let _e121 = (_e120 / 4u);
    if ((_e120 % 4u) > 0u) {
        phi_410_ = (_e121 + 1u);
    } else {
        phi_410_ = _e121;
    }
    let _e126 = phi_410_;
    if (_e126 > _e80) {
        let _e128 = (_e126 - _e80);
        if (_e83 == 0u) {
            return;
        }
        let _e130 = (_e128 / _e83);
        if (_e83 == 0u) {
            return;
        }
        if ((_e128 % _e83) > 0u) {
            phi_431_ = (_e130 + 1u);
        } else {
            phi_431_ = _e130;
        }
        let _e136 = phi_431_;
        phi_432_ = _e136;
    } else {
        phi_432_ = 0u;
    }
    let _e138 = phi_432_;
    phi_435_ = type_9(0u, _e138);
    loop {
        let _e141 = phi_435_;
        if (_e141.member < _e141.member_1) {
            phi_436_ = type_9((_e141.member + 1u), _e141.member_1);
            phi_459_ = type_9(1u, _e141.member);
        } else {
            phi_436_ = _e141;
            phi_459_ = type_9(0u, type_9().member_1);
        }
        let _e153 = phi_436_;
        let _e155 = phi_459_;
        let _e159 = (bitcast<i32>(_e155.member) != 0i);
        if _e159 {
            let _e163 = (((_e80 + (_e155.member_1 * _e83)) * 4u) + _e92);
            let _e166 = params.member.member_1.member_1;
            if (_e91 > _e166) {
                let _e170 = params.member.member_1.member_1;
                let _e171 = (_e91 - _e170);
                let _e174 = params.member.member_2.member_3;
                if (_e174 == 0u) {
                    return;
                }
                let _e176 = (_e171 / _e174);
                if (_e174 == 0u) {
                    return;
                }
                if ((_e171 % _e174) > 0u) {
                    phi_500_ = (_e176 + 1u);
                } else {
                    phi_500_ = _e176;
                }
                let _e182 = phi_500_;
                phi_501_ = _e182;
            } else {
                phi_501_ = 0u;
            }
            let _e184 = phi_501_;
            let _e187 = params.member.member_2.member_4;
            if (_e187 < _e184) {
                phi_509_ = _e187;
            } else {
                phi_509_ = _e184;
            }
            let _e190 = phi_509_;
            let _e191 = (_e163 < _e190);
            let _e194 = params.member.member_1.member_1;
            if _e191 {
                let _e197 = params.member.member_2.member_3;
                phi_521_ = (_e163 * _e197);
            } else {
                phi_521_ = 0u;
            }
            let _e200 = phi_521_;
            let _e202 = (2u * (_e194 + _e200));
            let _e205 = input.member[(4u + _e202)];
            let _e208 = input.member[(_e202 + 5u)];
            if (_e67 < 8u) {
                atomicStore((&counters[_e67]), 0u);
            }
            workgroupBarrier();
            let _e216 = params.member.member_2.member[0u][1u];
            let _e217 = (_e216 + (_e205 * 32u));
            let _e223 = params.member.member_2.member[0u][1u];
            let _e224 = (_e223 + (_e208 * 32u));
            if (_e93 == 0u) {
                firsts[(2u * _e92)] = _e217;
                firsts[((2u * _e92) + 1u)] = _e224;
            }
            let _e233 = params.member.member_2.member_1;
            if (_e233 == 0u) {
                phi_606_ = array<u32, 2>(0u, 2u);
            } else {
                phi_606_ = array<u32, 2>(1u, 1u);
            }
            let _e236 = phi_606_;
            let _e239 = (_e67 / 32u);
            let _e240 = (_e67 % 32u);
            let _e244 = params.member.member_2.member_2;
            let _e248 = params.member.member_2.member[_e244][_e236[0]];
            let _e251 = nodes.member[(_e248 + _e205)];
            let _e255 = params.member.member_2.member_2;
            let _e259 = params.member.member_2.member[_e255][_e236[1]];
            let _e262 = nodes.member[(_e259 + _e208)];
            let _e266 = params.member.member_2.member_2;
            let _e273 = params.member.member_2.member[(_e266 - 1u)][_e236[0]];
            let _e276 = nodes.member[(_e273 + ((_e205 * 32u) + _e240))];
            let _e280 = params.member.member_2.member_2;
            let _e287 = params.member.member_2.member[(_e280 - 1u)][_e236[1]];
            let _e290 = nodes.member[(_e287 + ((_e208 * 32u) + _e240))];
            if _e191 {
                if ((((((_e290.member[0] <= _e251.member_1[0]) && (_e251.member[0] <= _e290.member_1[0])) && (_e290.member[1] <= _e251.member_1[1])) && (_e251.member[1] <= _e290.member_1[1])) && (_e290.member[2] <= _e251.member_1[2])) && (_e251.member[2] <= _e290.member_1[2])) {
                    let _e328 = atomicAdd((&counters[_e239]), 1u);
                    let _e329 = ((_e239 * 32u) + _e328);
                    columns[_e329] = type_27(array<f32, 3>(_e290.member[0], _e290.member[1], _e290.member[2]), array<f32, 3>(_e290.member_1[0], _e290.member_1[1], _e290.member_1[2]));
                    names[_e329] = _e240;
                }
            }
            workgroupBarrier();
            if _e191 {
                if ((((((_e276.member[0] <= _e262.member_1[0]) && (_e262.member[0] <= _e276.member_1[0])) && (_e276.member[1] <= _e262.member_1[1])) && (_e262.member[1] <= _e276.member_1[1])) && (_e276.member[2] <= _e262.member_1[2])) && (_e262.member[2] <= _e276.member_1[2])) {
                    phi_804_ = false;
                } else {
                    phi_804_ = true;
                }
                let _e379 = phi_804_;
                phi_805_ = _e379;
            } else {
                phi_805_ = true;
            }
            let _e381 = phi_805_;
            if _e381 {
                phi_809_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_809_ = _e276;
            }
            let _e383 = phi_809_;
            let _e385 = (_e67 / 32u);
            let _e386 = (_e67 % 32u);
            let _e388 = atomicLoad((&counters[_e385]));
            phi_822_ = type_9(0u, _e388);
            phi_825_ = 0u;
            loop {
                let _e391 = phi_822_;
                let _e393 = phi_825_;
                local_3 = _e393;
                if (_e391.member < _e391.member_1) {
                    phi_823_ = type_9((_e391.member + 1u), _e391.member_1);
                    phi_848_ = type_9(1u, _e391.member);
                } else {
                    phi_823_ = _e391;
                    phi_848_ = type_9(0u, type_9().member_1);
                }
                let _e405 = phi_823_;
                let _e407 = phi_848_;
                let _e411 = (bitcast<i32>(_e407.member) != 0i);
                if _e411 {
                    let _e415 = names[((_e385 * 32u) + _e407.member_1)];
                    let _e419 = columns[((_e385 * 32u) + _e407.member_1)];
                    if ((((((_e383.member[0] <= _e419.member_1[0]) && (_e419.member[0] <= _e383.member_1[0])) && (_e383.member[1] <= _e419.member_1[1])) && (_e419.member[1] <= _e383.member_1[1])) && (_e383.member[2] <= _e419.member_1[2])) && (_e419.member[2] <= _e383.member_1[2])) {
                        if (_e205 == _e208) {
                            let _e451 = (_e386 < _e415);
                            if _e451 {
                                phi_914_ = bool();
                            } else {
                                phi_914_ = false;
                            }
                            let _e453 = phi_914_;
                            phi_915_ = _e453;
                            phi_916_ = _e451;
                        } else {
                            phi_915_ = bool();
                            phi_916_ = true;
                        }
                        let _e455 = phi_915_;
                        let _e457 = phi_916_;
                        if _e457 {
                            phi_920_ = true;
                        } else {
                            phi_920_ = _e455;
                        }
                        let _e459 = phi_920_;
                        if _e459 {
                            let _e461 = atomicAdd((&counters[4u]), 1u);
                            if (_e461 < 2048u) {
                                hits[_e461] = (((_e385 << bitcast<u32>(10i)) | (_e386 << bitcast<u32>(5i))) | _e415);
                                phi_938_ = _e393;
                            } else {
                                phi_938_ = (_e393 | (1u << bitcast<u32>((_e407.member_1 & 31u))));
                            }
                            let _e475 = phi_938_;
                            phi_939_ = _e475;
                        } else {
                            phi_939_ = _e393;
                        }
                        let _e477 = phi_939_;
                        phi_940_ = _e477;
                    } else {
                        phi_940_ = _e393;
                    }
                    let _e479 = phi_940_;
                    phi_826_ = _e479;
                } else {
                    phi_826_ = u32();
                }
                let _e481 = phi_826_;
                continue;
                continuing {
                    phi_822_ = _e405;
                    phi_825_ = _e481;
                    break if !(_e411);
                }
            }
            phi_943_ = type_9(0u, 32u);
            let _e4604 = local_3;
            phi_946_ = _e4604;
            loop {
                let _e484 = phi_943_;
                let _e486 = phi_946_;
                if (_e484.member < _e484.member_1) {
                    phi_944_ = type_9((_e484.member + 1u), _e484.member_1);
                    phi_969_ = type_9(1u, _e484.member);
                } else {
                    phi_944_ = _e484;
                    phi_969_ = type_9(0u, type_9().member_1);
                }
                let _e498 = phi_944_;
                let _e500 = phi_969_;
                if (bitcast<i32>(_e500.member) != 0i) {
                    if (_e486 == 0u) {
                        phi_1837_ = u32();
                        phi_1838_ = false;
                    } else {
                        let _e511 = names[((_e92 * 32u) + select(firstTrailingBit(_e486), 32u, (_e486 == 0u)))];
                        let _e514 = (_e217 + _e93);
                        let _e515 = (_e224 + _e511);
                        let _e517 = leaves.member[_e514];
                        let _e519 = leaves.member[_e515];
                        let _e521 = nodes.member[_e514];
                        let _e523 = nodes.member[_e515];
                        let _e526 = params.member.member.member_1;
                        if ((_e526 & 1u) != 0u) {
                            if (_e519.member[0] == _e517.member[0]) {
                                phi_1077_ = true;
                            } else {
                                phi_1077_ = (_e519.member[0] == _e517.member[1]);
                            }
                            let _e540 = phi_1077_;
                            if (_e519.member[1] == _e517.member[0]) {
                                phi_1083_ = true;
                            } else {
                                phi_1083_ = (_e519.member[1] == _e517.member[1]);
                            }
                            let _e544 = phi_1083_;
                            if (_e540 || _e544) {
                                phi_1089_ = false;
                            } else {
                                phi_1089_ = true;
                            }
                            let _e547 = phi_1089_;
                            phi_1090_ = _e547;
                        } else {
                            phi_1090_ = true;
                        }
                        let _e549 = phi_1090_;
                        if _e549 {
                            let _e551 = params.member.member.member_1;
                            if ((_e551 & 2u) != 0u) {
                                let _e555 = params.member.member.member_1;
                                let _e561 = bodies.member[_e517.member[0]];
                                let _e565 = bodies.member[_e519.member[0]];
                                if ((_e561 / 2u) != (_e565 / 2u)) {
                                    phi_1136_ = true;
                                } else {
                                    phi_1136_ = ((_e555 & 4u) != 0u);
                                }
                                let _e570 = phi_1136_;
                                if _e570 {
                                    phi_1143_ = (((_e561 & _e565) & 1u) == 0u);
                                } else {
                                    phi_1143_ = false;
                                }
                                let _e575 = phi_1143_;
                                phi_1147_ = _e575;
                            } else {
                                phi_1147_ = true;
                            }
                            let _e577 = phi_1147_;
                            if _e577 {
                                let _e579 = params.member.member.member_1;
                                if ((_e579 & 32u) != 0u) {
                                    let _e583 = params.member.member.member_6;
                                    let _e624 = (((((_e521.member_1[0] - _e523.member[0]) > _e583) && ((_e523.member_1[0] - _e521.member[0]) > _e583)) && (((_e521.member_1[1] - _e523.member[1]) > _e583) && ((_e523.member_1[1] - _e521.member[1]) > _e583))) && (((_e521.member_1[2] - _e523.member[2]) > _e583) && ((_e523.member_1[2] - _e521.member[2]) > _e583)));
                                    if _e624 {
                                        phi_1761_ = bool();
                                    } else {
                                        let _e628 = keys.member[_e517.member[0]];
                                        let _e633 = keys.member[_e517.member[1]];
                                        let _e635 = function_(_e628[0], _e633[0]);
                                        let _e639 = keys.member[_e517.member[2]];
                                        let _e641 = function_(_e635, _e639[0]);
                                        let _e645 = keys.member[_e519.member[0]];
                                        let _e650 = keys.member[_e519.member[1]];
                                        let _e652 = function_1(_e645[3], _e650[3]);
                                        let _e656 = keys.member[_e519.member[2]];
                                        let _e658 = function_1(_e652, _e656[3]);
                                        if (_e641[1] > _e658[1]) {
                                            phi_1284_ = true;
                                        } else {
                                            if (_e641[1] == _e658[1]) {
                                                phi_1283_ = (_e641[0] > _e658[0]);
                                            } else {
                                                phi_1283_ = false;
                                            }
                                            let _e669 = phi_1283_;
                                            phi_1284_ = _e669;
                                        }
                                        let _e671 = phi_1284_;
                                        let _e676 = keys.member[_e519.member[0]];
                                        let _e681 = keys.member[_e519.member[1]];
                                        let _e683 = function_(_e676[0], _e681[0]);
                                        let _e687 = keys.member[_e519.member[2]];
                                        let _e689 = function_(_e683, _e687[0]);
                                        let _e693 = keys.member[_e517.member[0]];
                                        let _e698 = keys.member[_e517.member[1]];
                                        let _e700 = function_1(_e693[3], _e698[3]);
                                        let _e704 = keys.member[_e517.member[2]];
                                        let _e706 = function_1(_e700, _e704[3]);
                                        if (_e689[1] > _e706[1]) {
                                            phi_1378_ = true;
                                        } else {
                                            if (_e689[1] == _e706[1]) {
                                                phi_1377_ = (_e689[0] > _e706[0]);
                                            } else {
                                                phi_1377_ = false;
                                            }
                                            let _e717 = phi_1377_;
                                            phi_1378_ = _e717;
                                        }
                                        let _e719 = phi_1378_;
                                        let _e725 = keys.member[_e517.member[0]];
                                        let _e730 = keys.member[_e517.member[1]];
                                        let _e732 = function_2(_e725[1], _e730[1]);
                                        let _e736 = keys.member[_e517.member[2]];
                                        let _e738 = function_2(_e732, _e736[1]);
                                        let _e742 = keys.member[_e519.member[0]];
                                        let _e747 = keys.member[_e519.member[1]];
                                        let _e749 = function_3(_e742[4], _e747[4]);
                                        let _e753 = keys.member[_e519.member[2]];
                                        let _e755 = function_3(_e749, _e753[4]);
                                        if (_e738[1] > _e755[1]) {
                                            phi_1473_ = true;
                                        } else {
                                            if (_e738[1] == _e755[1]) {
                                                phi_1472_ = (_e738[0] > _e755[0]);
                                            } else {
                                                phi_1472_ = false;
                                            }
                                            let _e766 = phi_1472_;
                                            phi_1473_ = _e766;
                                        }
                                        let _e768 = phi_1473_;
                                        let _e773 = keys.member[_e519.member[0]];
                                        let _e778 = keys.member[_e519.member[1]];
                                        let _e780 = function_2(_e773[1], _e778[1]);
                                        let _e784 = keys.member[_e519.member[2]];
                                        let _e786 = function_2(_e780, _e784[1]);
                                        let _e790 = keys.member[_e517.member[0]];
                                        let _e795 = keys.member[_e517.member[1]];
                                        let _e797 = function_3(_e790[4], _e795[4]);
                                        let _e801 = keys.member[_e517.member[2]];
                                        let _e803 = function_3(_e797, _e801[4]);
                                        if (_e786[1] > _e803[1]) {
                                            phi_1567_ = true;
                                        } else {
                                            if (_e786[1] == _e803[1]) {
                                                phi_1566_ = (_e786[0] > _e803[0]);
                                            } else {
                                                phi_1566_ = false;
                                            }
                                            let _e814 = phi_1566_;
                                            phi_1567_ = _e814;
                                        }
                                        let _e816 = phi_1567_;
                                        let _e823 = keys.member[_e517.member[0]];
                                        let _e828 = keys.member[_e517.member[1]];
                                        let _e830 = function_4(_e823[2], _e828[2]);
                                        let _e834 = keys.member[_e517.member[2]];
                                        let _e836 = function_4(_e830, _e834[2]);
                                        let _e840 = keys.member[_e519.member[0]];
                                        let _e845 = keys.member[_e519.member[1]];
                                        let _e847 = function_5(_e840[5], _e845[5]);
                                        let _e851 = keys.member[_e519.member[2]];
                                        let _e853 = function_5(_e847, _e851[5]);
                                        if (_e836[1] > _e853[1]) {
                                            phi_1663_ = true;
                                        } else {
                                            if (_e836[1] == _e853[1]) {
                                                phi_1662_ = (_e836[0] > _e853[0]);
                                            } else {
                                                phi_1662_ = false;
                                            }
                                            let _e864 = phi_1662_;
                                            phi_1663_ = _e864;
                                        }
                                        let _e866 = phi_1663_;
                                        let _e871 = keys.member[_e519.member[0]];
                                        let _e876 = keys.member[_e519.member[1]];
                                        let _e878 = function_4(_e871[2], _e876[2]);
                                        let _e882 = keys.member[_e519.member[2]];
                                        let _e884 = function_4(_e878, _e882[2]);
                                        let _e888 = keys.member[_e517.member[0]];
                                        let _e893 = keys.member[_e517.member[1]];
                                        let _e895 = function_5(_e888[5], _e893[5]);
                                        let _e899 = keys.member[_e517.member[2]];
                                        let _e901 = function_5(_e895, _e899[5]);
                                        if (_e884[1] > _e901[1]) {
                                            phi_1757_ = true;
                                        } else {
                                            if (_e884[1] == _e901[1]) {
                                                phi_1756_ = (_e884[0] > _e901[0]);
                                            } else {
                                                phi_1756_ = false;
                                            }
                                            let _e912 = phi_1756_;
                                            phi_1757_ = _e912;
                                        }
                                        let _e914 = phi_1757_;
                                        phi_1761_ = (((!(_e671) && !(_e719)) && (!(_e768) && !(_e816))) && (!(_e866) && !(_e914)));
                                    }
                                    let _e919 = phi_1761_;
                                    phi_1762_ = _e919;
                                    phi_1763_ = _e624;
                                } else {
                                    phi_1762_ = bool();
                                    phi_1763_ = true;
                                }
                                let _e921 = phi_1762_;
                                let _e923 = phi_1763_;
                                if _e923 {
                                    phi_1767_ = false;
                                } else {
                                    phi_1767_ = true;
                                }
                                let _e925 = phi_1767_;
                                phi_1768_ = _e921;
                                phi_1769_ = _e925;
                            } else {
                                phi_1768_ = false;
                                phi_1769_ = true;
                            }
                            let _e927 = phi_1768_;
                            let _e929 = phi_1769_;
                            phi_1770_ = _e927;
                            phi_1771_ = _e929;
                        } else {
                            phi_1770_ = false;
                            phi_1771_ = true;
                        }
                        let _e931 = phi_1770_;
                        let _e933 = phi_1771_;
                        if _e933 {
                            phi_1775_ = _e931;
                        } else {
                            phi_1775_ = true;
                        }
                        let _e935 = phi_1775_;
                        if _e935 {
                            let _e938 = params.member.member_1.member_3;
                            if (_e517.member_1 < _e519.member_1) {
                                phi_1794_ = type_9(_e517.member_1, _e519.member_1);
                            } else {
                                phi_1794_ = type_9(_e519.member_1, _e517.member_1);
                            }
                            let _e945 = phi_1794_;
                            let _e949 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e949 + 1u) < _e949) {
                                let _e953 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e949 < _e938) {
                                let _e955 = (2u * _e949);
                                atomicStore((&output.member[(4u + _e955)]), _e945.member);
                                atomicStore((&output.member[(_e955 + 5u)]), _e945.member_1);
                            }
                            let _e961 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e961 + 1u) < _e961) {
                                let _e965 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1837_ = (_e486 & (_e486 - 1u));
                        phi_1838_ = true;
                    }
                    let _e967 = phi_1837_;
                    let _e969 = phi_1838_;
                    phi_947_ = _e967;
                    phi_1839_ = _e969;
                } else {
                    phi_947_ = u32();
                    phi_1839_ = false;
                }
                let _e971 = phi_947_;
                let _e973 = phi_1839_;
                continue;
                continuing {
                    phi_943_ = _e498;
                    phi_946_ = _e971;
                    break if !(_e973);
                }
            }
            workgroupBarrier();
            let _e976 = atomicLoad((&counters[4u]));
            if (2048u < _e976) {
                phi_1846_ = 2048u;
            } else {
                phi_1846_ = _e976;
            }
            let _e979 = phi_1846_;
            phi_1849_ = type_9(0u, 16u);
            loop {
                let _e981 = phi_1849_;
                if (_e981.member < _e981.member_1) {
                    phi_1850_ = type_9((_e981.member + 1u), _e981.member_1);
                    phi_1873_ = type_9(1u, _e981.member);
                } else {
                    phi_1850_ = _e981;
                    phi_1873_ = type_9(0u, type_9().member_1);
                }
                let _e993 = phi_1850_;
                let _e995 = phi_1873_;
                if (bitcast<i32>(_e995.member) != 0i) {
                    let _e1001 = (_e67 + (_e995.member_1 * 128u));
                    if (_e1001 >= _e979) {
                        phi_7876_ = false;
                    } else {
                        let _e1004 = hits[_e1001];
                        let _e1007 = ((_e1004 >> bitcast<u32>(10i)) & 3u);
                        let _e1014 = firsts[(2u * _e1007)];
                        let _e1015 = (_e1014 + ((_e1004 >> bitcast<u32>(5i)) & 31u));
                        let _e1019 = firsts[((2u * _e1007) + 1u)];
                        let _e1020 = (_e1019 + (_e1004 & 31u));
                        let _e1022 = leaves.member[_e1015];
                        let _e1024 = leaves.member[_e1020];
                        let _e1026 = nodes.member[_e1015];
                        let _e1028 = nodes.member[_e1020];
                        let _e1031 = params.member.member.member_1;
                        if ((_e1031 & 1u) != 0u) {
                            if (_e1024.member[0] == _e1022.member[0]) {
                                phi_1989_ = true;
                            } else {
                                phi_1989_ = (_e1024.member[0] == _e1022.member[1]);
                            }
                            let _e1045 = phi_1989_;
                            if (_e1024.member[1] == _e1022.member[0]) {
                                phi_1995_ = true;
                            } else {
                                phi_1995_ = (_e1024.member[1] == _e1022.member[1]);
                            }
                            let _e1049 = phi_1995_;
                            if (_e1045 || _e1049) {
                                phi_2001_ = false;
                            } else {
                                phi_2001_ = true;
                            }
                            let _e1052 = phi_2001_;
                            phi_2002_ = _e1052;
                        } else {
                            phi_2002_ = true;
                        }
                        let _e1054 = phi_2002_;
                        if _e1054 {
                            let _e1056 = params.member.member.member_1;
                            if ((_e1056 & 2u) != 0u) {
                                let _e1060 = params.member.member.member_1;
                                let _e1066 = bodies.member[_e1022.member[0]];
                                let _e1070 = bodies.member[_e1024.member[0]];
                                if ((_e1066 / 2u) != (_e1070 / 2u)) {
                                    phi_2048_ = true;
                                } else {
                                    phi_2048_ = ((_e1060 & 4u) != 0u);
                                }
                                let _e1075 = phi_2048_;
                                if _e1075 {
                                    phi_2055_ = (((_e1066 & _e1070) & 1u) == 0u);
                                } else {
                                    phi_2055_ = false;
                                }
                                let _e1080 = phi_2055_;
                                phi_2059_ = _e1080;
                            } else {
                                phi_2059_ = true;
                            }
                            let _e1082 = phi_2059_;
                            if _e1082 {
                                let _e1084 = params.member.member.member_1;
                                if ((_e1084 & 32u) != 0u) {
                                    let _e1088 = params.member.member.member_6;
                                    let _e1129 = (((((_e1026.member_1[0] - _e1028.member[0]) > _e1088) && ((_e1028.member_1[0] - _e1026.member[0]) > _e1088)) && (((_e1026.member_1[1] - _e1028.member[1]) > _e1088) && ((_e1028.member_1[1] - _e1026.member[1]) > _e1088))) && (((_e1026.member_1[2] - _e1028.member[2]) > _e1088) && ((_e1028.member_1[2] - _e1026.member[2]) > _e1088)));
                                    if _e1129 {
                                        phi_2673_ = bool();
                                    } else {
                                        let _e1133 = keys.member[_e1022.member[0]];
                                        let _e1138 = keys.member[_e1022.member[1]];
                                        let _e1140 = function_(_e1133[0], _e1138[0]);
                                        let _e1144 = keys.member[_e1022.member[2]];
                                        let _e1146 = function_(_e1140, _e1144[0]);
                                        let _e1150 = keys.member[_e1024.member[0]];
                                        let _e1155 = keys.member[_e1024.member[1]];
                                        let _e1157 = function_1(_e1150[3], _e1155[3]);
                                        let _e1161 = keys.member[_e1024.member[2]];
                                        let _e1163 = function_1(_e1157, _e1161[3]);
                                        if (_e1146[1] > _e1163[1]) {
                                            phi_2196_ = true;
                                        } else {
                                            if (_e1146[1] == _e1163[1]) {
                                                phi_2195_ = (_e1146[0] > _e1163[0]);
                                            } else {
                                                phi_2195_ = false;
                                            }
                                            let _e1174 = phi_2195_;
                                            phi_2196_ = _e1174;
                                        }
                                        let _e1176 = phi_2196_;
                                        let _e1181 = keys.member[_e1024.member[0]];
                                        let _e1186 = keys.member[_e1024.member[1]];
                                        let _e1188 = function_(_e1181[0], _e1186[0]);
                                        let _e1192 = keys.member[_e1024.member[2]];
                                        let _e1194 = function_(_e1188, _e1192[0]);
                                        let _e1198 = keys.member[_e1022.member[0]];
                                        let _e1203 = keys.member[_e1022.member[1]];
                                        let _e1205 = function_1(_e1198[3], _e1203[3]);
                                        let _e1209 = keys.member[_e1022.member[2]];
                                        let _e1211 = function_1(_e1205, _e1209[3]);
                                        if (_e1194[1] > _e1211[1]) {
                                            phi_2290_ = true;
                                        } else {
                                            if (_e1194[1] == _e1211[1]) {
                                                phi_2289_ = (_e1194[0] > _e1211[0]);
                                            } else {
                                                phi_2289_ = false;
                                            }
                                            let _e1222 = phi_2289_;
                                            phi_2290_ = _e1222;
                                        }
                                        let _e1224 = phi_2290_;
                                        let _e1230 = keys.member[_e1022.member[0]];
                                        let _e1235 = keys.member[_e1022.member[1]];
                                        let _e1237 = function_2(_e1230[1], _e1235[1]);
                                        let _e1241 = keys.member[_e1022.member[2]];
                                        let _e1243 = function_2(_e1237, _e1241[1]);
                                        let _e1247 = keys.member[_e1024.member[0]];
                                        let _e1252 = keys.member[_e1024.member[1]];
                                        let _e1254 = function_3(_e1247[4], _e1252[4]);
                                        let _e1258 = keys.member[_e1024.member[2]];
                                        let _e1260 = function_3(_e1254, _e1258[4]);
                                        if (_e1243[1] > _e1260[1]) {
                                            phi_2385_ = true;
                                        } else {
                                            if (_e1243[1] == _e1260[1]) {
                                                phi_2384_ = (_e1243[0] > _e1260[0]);
                                            } else {
                                                phi_2384_ = false;
                                            }
                                            let _e1271 = phi_2384_;
                                            phi_2385_ = _e1271;
                                        }
                                        let _e1273 = phi_2385_;
                                        let _e1278 = keys.member[_e1024.member[0]];
                                        let _e1283 = keys.member[_e1024.member[1]];
                                        let _e1285 = function_2(_e1278[1], _e1283[1]);
                                        let _e1289 = keys.member[_e1024.member[2]];
                                        let _e1291 = function_2(_e1285, _e1289[1]);
                                        let _e1295 = keys.member[_e1022.member[0]];
                                        let _e1300 = keys.member[_e1022.member[1]];
                                        let _e1302 = function_3(_e1295[4], _e1300[4]);
                                        let _e1306 = keys.member[_e1022.member[2]];
                                        let _e1308 = function_3(_e1302, _e1306[4]);
                                        if (_e1291[1] > _e1308[1]) {
                                            phi_2479_ = true;
                                        } else {
                                            if (_e1291[1] == _e1308[1]) {
                                                phi_2478_ = (_e1291[0] > _e1308[0]);
                                            } else {
                                                phi_2478_ = false;
                                            }
                                            let _e1319 = phi_2478_;
                                            phi_2479_ = _e1319;
                                        }
                                        let _e1321 = phi_2479_;
                                        let _e1328 = keys.member[_e1022.member[0]];
                                        let _e1333 = keys.member[_e1022.member[1]];
                                        let _e1335 = function_4(_e1328[2], _e1333[2]);
                                        let _e1339 = keys.member[_e1022.member[2]];
                                        let _e1341 = function_4(_e1335, _e1339[2]);
                                        let _e1345 = keys.member[_e1024.member[0]];
                                        let _e1350 = keys.member[_e1024.member[1]];
                                        let _e1352 = function_5(_e1345[5], _e1350[5]);
                                        let _e1356 = keys.member[_e1024.member[2]];
                                        let _e1358 = function_5(_e1352, _e1356[5]);
                                        if (_e1341[1] > _e1358[1]) {
                                            phi_2575_ = true;
                                        } else {
                                            if (_e1341[1] == _e1358[1]) {
                                                phi_2574_ = (_e1341[0] > _e1358[0]);
                                            } else {
                                                phi_2574_ = false;
                                            }
                                            let _e1369 = phi_2574_;
                                            phi_2575_ = _e1369;
                                        }
                                        let _e1371 = phi_2575_;
                                        let _e1376 = keys.member[_e1024.member[0]];
                                        let _e1381 = keys.member[_e1024.member[1]];
                                        let _e1383 = function_4(_e1376[2], _e1381[2]);
                                        let _e1387 = keys.member[_e1024.member[2]];
                                        let _e1389 = function_4(_e1383, _e1387[2]);
                                        let _e1393 = keys.member[_e1022.member[0]];
                                        let _e1398 = keys.member[_e1022.member[1]];
                                        let _e1400 = function_5(_e1393[5], _e1398[5]);
                                        let _e1404 = keys.member[_e1022.member[2]];
                                        let _e1406 = function_5(_e1400, _e1404[5]);
                                        if (_e1389[1] > _e1406[1]) {
                                            phi_2669_ = true;
                                        } else {
                                            if (_e1389[1] == _e1406[1]) {
                                                phi_2668_ = (_e1389[0] > _e1406[0]);
                                            } else {
                                                phi_2668_ = false;
                                            }
                                            let _e1417 = phi_2668_;
                                            phi_2669_ = _e1417;
                                        }
                                        let _e1419 = phi_2669_;
                                        phi_2673_ = (((!(_e1176) && !(_e1224)) && (!(_e1273) && !(_e1321))) && (!(_e1371) && !(_e1419)));
                                    }
                                    let _e1424 = phi_2673_;
                                    phi_2674_ = _e1424;
                                    phi_2675_ = _e1129;
                                } else {
                                    phi_2674_ = bool();
                                    phi_2675_ = true;
                                }
                                let _e1426 = phi_2674_;
                                let _e1428 = phi_2675_;
                                if _e1428 {
                                    phi_2679_ = false;
                                } else {
                                    phi_2679_ = true;
                                }
                                let _e1430 = phi_2679_;
                                phi_2680_ = _e1426;
                                phi_2681_ = _e1430;
                            } else {
                                phi_2680_ = false;
                                phi_2681_ = true;
                            }
                            let _e1432 = phi_2680_;
                            let _e1434 = phi_2681_;
                            phi_2682_ = _e1432;
                            phi_2683_ = _e1434;
                        } else {
                            phi_2682_ = false;
                            phi_2683_ = true;
                        }
                        let _e1436 = phi_2682_;
                        let _e1438 = phi_2683_;
                        if _e1438 {
                            phi_2687_ = _e1436;
                        } else {
                            phi_2687_ = true;
                        }
                        let _e1440 = phi_2687_;
                        if _e1440 {
                            let _e1442 = atomicAdd((&counters[7u]), 1u);
                            if (_e1022.member_1 < _e1024.member_1) {
                                phi_2700_ = _e1024;
                                phi_2701_ = _e1022;
                            } else {
                                phi_2700_ = _e1022;
                                phi_2701_ = _e1024;
                            }
                            let _e1448 = phi_2700_;
                            let _e1450 = phi_2701_;
                            let _e1452 = params.member.member.member_4;
                            let _e1454 = params.member.member.member_5;
                            let _e1464 = paths.member[_e1450.member[0]];
                            let _e1466 = paths.member[_e1450.member[1]];
                            let _e1472 = paths.member[_e1448.member[0]];
                            let _e1474 = paths.member[_e1448.member[1]];
                            local_2 = type_37(array<array<f32, 3>, 2>(array<f32, 3>((_e1472.member[0] - _e1464.member[0]), (_e1472.member[1] - _e1464.member[1]), (_e1472.member[2] - _e1464.member[2])), array<f32, 3>((_e1472.member_1[0] - _e1464.member_1[0]), (_e1472.member_1[1] - _e1464.member_1[1]), (_e1472.member_1[2] - _e1464.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1466.member[0] - _e1464.member[0]), (_e1466.member[1] - _e1464.member[1]), (_e1466.member[2] - _e1464.member[2])), array<f32, 3>((_e1466.member_1[0] - _e1464.member_1[0]), (_e1466.member_1[1] - _e1464.member_1[1]), (_e1466.member_1[2] - _e1464.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1472.member[0] - _e1474.member[0]), (_e1472.member[1] - _e1474.member[1]), (_e1472.member[2] - _e1474.member[2])), array<f32, 3>((_e1472.member_1[0] - _e1474.member_1[0]), (_e1472.member_1[1] - _e1474.member_1[1]), (_e1472.member_1[2] - _e1474.member_1[2]))), (_e1452 + _e1452));
                            let _e1534 = local_2.member_1[0u];
                            let _e1540 = local_2.member_2[0u];
                            let _e1546 = ((_e1534[1] * _e1540[2]) - (_e1534[2] * _e1540[1]));
                            let _e1549 = ((_e1534[2] * _e1540[0]) - (_e1534[0] * _e1540[2]));
                            let _e1552 = ((_e1534[0] * _e1540[1]) - (_e1534[1] * _e1540[0]));
                            let _e1555 = local_2.member_1[1u];
                            let _e1561 = local_2.member_2[1u];
                            let _e1567 = ((_e1555[1] * _e1561[2]) - (_e1555[2] * _e1561[1]));
                            let _e1570 = ((_e1555[2] * _e1561[0]) - (_e1555[0] * _e1561[2]));
                            let _e1573 = ((_e1555[0] * _e1561[1]) - (_e1555[1] * _e1561[0]));
                            let _e1576 = local_2.member_1[0u];
                            let _e1582 = local_2.member_2[1u];
                            let _e1597 = local_2.member_1[1u];
                            let _e1603 = local_2.member_2[0u];
                            let _e1616 = (((_e1576[1] * _e1582[2]) - (_e1576[2] * _e1582[1])) + ((_e1597[1] * _e1603[2]) - (_e1597[2] * _e1603[1])));
                            let _e1617 = (((_e1576[2] * _e1582[0]) - (_e1576[0] * _e1582[2])) + ((_e1597[2] * _e1603[0]) - (_e1597[0] * _e1603[2])));
                            let _e1618 = (((_e1576[0] * _e1582[1]) - (_e1576[1] * _e1582[0])) + ((_e1597[0] * _e1603[1]) - (_e1597[1] * _e1603[0])));
                            let _e1621 = local_2.member[0u];
                            let _e1632 = local_2.member[1u];
                            let _e1643 = local_2.member[0u];
                            let _e1652 = ((((_e1632[0] * _e1546) + (_e1632[1] * _e1549)) + (_e1632[2] * _e1552)) + (((_e1643[0] * _e1616) + (_e1643[1] * _e1617)) + (_e1643[2] * _e1618)));
                            let _e1655 = local_2.member[0u];
                            let _e1666 = local_2.member[1u];
                            let _e1675 = ((((_e1655[0] * _e1567) + (_e1655[1] * _e1570)) + (_e1655[2] * _e1573)) + (((_e1666[0] * _e1616) + (_e1666[1] * _e1617)) + (_e1666[2] * _e1618)));
                            let _e1678 = local_2.member[1u];
                            let _e1689 = local_2.member[0u];
                            if (_e1689[0] < 0f) {
                                phi_3090_ = -(_e1689[0]);
                            } else {
                                phi_3090_ = _e1689[0];
                            }
                            let _e1696 = phi_3090_;
                            if (_e1689[1] < 0f) {
                                phi_3097_ = -(_e1689[1]);
                            } else {
                                phi_3097_ = _e1689[1];
                            }
                            let _e1700 = phi_3097_;
                            if (_e1696 > _e1700) {
                                phi_3102_ = _e1696;
                            } else {
                                phi_3102_ = _e1700;
                            }
                            let _e1703 = phi_3102_;
                            if (_e1689[2] < 0f) {
                                phi_3109_ = -(_e1689[2]);
                            } else {
                                phi_3109_ = _e1689[2];
                            }
                            let _e1707 = phi_3109_;
                            if (_e1703 > _e1707) {
                                phi_3114_ = _e1703;
                            } else {
                                phi_3114_ = _e1707;
                            }
                            let _e1710 = phi_3114_;
                            let _e1713 = local_2.member[1u];
                            if (_e1713[0] < 0f) {
                                phi_3127_ = -(_e1713[0]);
                            } else {
                                phi_3127_ = _e1713[0];
                            }
                            let _e1720 = phi_3127_;
                            if (_e1713[1] < 0f) {
                                phi_3134_ = -(_e1713[1]);
                            } else {
                                phi_3134_ = _e1713[1];
                            }
                            let _e1724 = phi_3134_;
                            if (_e1720 > _e1724) {
                                phi_3139_ = _e1720;
                            } else {
                                phi_3139_ = _e1724;
                            }
                            let _e1727 = phi_3139_;
                            if (_e1713[2] < 0f) {
                                phi_3146_ = -(_e1713[2]);
                            } else {
                                phi_3146_ = _e1713[2];
                            }
                            let _e1731 = phi_3146_;
                            if (_e1727 > _e1731) {
                                phi_3151_ = _e1727;
                            } else {
                                phi_3151_ = _e1731;
                            }
                            let _e1734 = phi_3151_;
                            if (_e1710 > _e1734) {
                                phi_3156_ = _e1710;
                            } else {
                                phi_3156_ = _e1734;
                            }
                            let _e1737 = phi_3156_;
                            let _e1739 = local_2.member_3;
                            let _e1740 = (_e1737 + _e1739);
                            let _e1743 = local_2.member_1[0u];
                            if (_e1743[0] < 0f) {
                                phi_3173_ = -(_e1743[0]);
                            } else {
                                phi_3173_ = _e1743[0];
                            }
                            let _e1750 = phi_3173_;
                            if (_e1743[1] < 0f) {
                                phi_3180_ = -(_e1743[1]);
                            } else {
                                phi_3180_ = _e1743[1];
                            }
                            let _e1754 = phi_3180_;
                            if (_e1750 > _e1754) {
                                phi_3185_ = _e1750;
                            } else {
                                phi_3185_ = _e1754;
                            }
                            let _e1757 = phi_3185_;
                            if (_e1743[2] < 0f) {
                                phi_3192_ = -(_e1743[2]);
                            } else {
                                phi_3192_ = _e1743[2];
                            }
                            let _e1761 = phi_3192_;
                            if (_e1757 > _e1761) {
                                phi_3197_ = _e1757;
                            } else {
                                phi_3197_ = _e1761;
                            }
                            let _e1764 = phi_3197_;
                            let _e1767 = local_2.member_1[1u];
                            if (_e1767[0] < 0f) {
                                phi_3211_ = -(_e1767[0]);
                            } else {
                                phi_3211_ = _e1767[0];
                            }
                            let _e1774 = phi_3211_;
                            if (_e1767[1] < 0f) {
                                phi_3218_ = -(_e1767[1]);
                            } else {
                                phi_3218_ = _e1767[1];
                            }
                            let _e1778 = phi_3218_;
                            if (_e1774 > _e1778) {
                                phi_3223_ = _e1774;
                            } else {
                                phi_3223_ = _e1778;
                            }
                            let _e1781 = phi_3223_;
                            if (_e1767[2] < 0f) {
                                phi_3230_ = -(_e1767[2]);
                            } else {
                                phi_3230_ = _e1767[2];
                            }
                            let _e1785 = phi_3230_;
                            if (_e1781 > _e1785) {
                                phi_3235_ = _e1781;
                            } else {
                                phi_3235_ = _e1785;
                            }
                            let _e1788 = phi_3235_;
                            if (_e1764 > _e1788) {
                                phi_3240_ = _e1764;
                            } else {
                                phi_3240_ = _e1788;
                            }
                            let _e1791 = phi_3240_;
                            let _e1793 = local_2.member_3;
                            let _e1794 = (_e1791 + _e1793);
                            let _e1797 = local_2.member_2[0u];
                            if (_e1797[0] < 0f) {
                                phi_3257_ = -(_e1797[0]);
                            } else {
                                phi_3257_ = _e1797[0];
                            }
                            let _e1804 = phi_3257_;
                            if (_e1797[1] < 0f) {
                                phi_3264_ = -(_e1797[1]);
                            } else {
                                phi_3264_ = _e1797[1];
                            }
                            let _e1808 = phi_3264_;
                            if (_e1804 > _e1808) {
                                phi_3269_ = _e1804;
                            } else {
                                phi_3269_ = _e1808;
                            }
                            let _e1811 = phi_3269_;
                            if (_e1797[2] < 0f) {
                                phi_3276_ = -(_e1797[2]);
                            } else {
                                phi_3276_ = _e1797[2];
                            }
                            let _e1815 = phi_3276_;
                            if (_e1811 > _e1815) {
                                phi_3281_ = _e1811;
                            } else {
                                phi_3281_ = _e1815;
                            }
                            let _e1818 = phi_3281_;
                            let _e1821 = local_2.member_2[1u];
                            if (_e1821[0] < 0f) {
                                phi_3295_ = -(_e1821[0]);
                            } else {
                                phi_3295_ = _e1821[0];
                            }
                            let _e1828 = phi_3295_;
                            if (_e1821[1] < 0f) {
                                phi_3302_ = -(_e1821[1]);
                            } else {
                                phi_3302_ = _e1821[1];
                            }
                            let _e1832 = phi_3302_;
                            if (_e1828 > _e1832) {
                                phi_3307_ = _e1828;
                            } else {
                                phi_3307_ = _e1832;
                            }
                            let _e1835 = phi_3307_;
                            if (_e1821[2] < 0f) {
                                phi_3314_ = -(_e1821[2]);
                            } else {
                                phi_3314_ = _e1821[2];
                            }
                            let _e1839 = phi_3314_;
                            if (_e1835 > _e1839) {
                                phi_3319_ = _e1835;
                            } else {
                                phi_3319_ = _e1839;
                            }
                            let _e1842 = phi_3319_;
                            if (_e1818 > _e1842) {
                                phi_3324_ = _e1818;
                            } else {
                                phi_3324_ = _e1842;
                            }
                            let _e1845 = phi_3324_;
                            let _e1847 = local_2.member_3;
                            let _e1848 = (_e1845 + _e1847);
                            let _e1850 = ((_e1794 * 8f) * _e1848);
                            let _e1857 = local_2.member_3;
                            if (_e1546 < 0f) {
                                phi_3355_ = -(_e1546);
                            } else {
                                phi_3355_ = _e1546;
                            }
                            let _e1874 = phi_3355_;
                            if (_e1549 < 0f) {
                                phi_3361_ = -(_e1549);
                            } else {
                                phi_3361_ = _e1549;
                            }
                            let _e1878 = phi_3361_;
                            if (_e1552 < 0f) {
                                phi_3368_ = -(_e1552);
                            } else {
                                phi_3368_ = _e1552;
                            }
                            let _e1883 = phi_3368_;
                            let _e1884 = ((_e1874 + _e1878) + _e1883);
                            if (_e1567 < 0f) {
                                phi_3375_ = -(_e1567);
                            } else {
                                phi_3375_ = _e1567;
                            }
                            let _e1888 = phi_3375_;
                            if (_e1570 < 0f) {
                                phi_3381_ = -(_e1570);
                            } else {
                                phi_3381_ = _e1570;
                            }
                            let _e1892 = phi_3381_;
                            if (_e1573 < 0f) {
                                phi_3388_ = -(_e1573);
                            } else {
                                phi_3388_ = _e1573;
                            }
                            let _e1897 = phi_3388_;
                            let _e1898 = ((_e1888 + _e1892) + _e1897);
                            if (_e1884 > _e1898) {
                                phi_3394_ = _e1884;
                            } else {
                                phi_3394_ = _e1898;
                            }
                            let _e1901 = phi_3394_;
                            if (_e1616 < 0f) {
                                phi_3400_ = -(_e1616);
                            } else {
                                phi_3400_ = _e1616;
                            }
                            let _e1905 = phi_3400_;
                            if (_e1617 < 0f) {
                                phi_3406_ = -(_e1617);
                            } else {
                                phi_3406_ = _e1617;
                            }
                            let _e1909 = phi_3406_;
                            if (_e1618 < 0f) {
                                phi_3413_ = -(_e1618);
                            } else {
                                phi_3413_ = _e1618;
                            }
                            let _e1914 = phi_3413_;
                            let _e1916 = (((_e1905 + _e1909) + _e1914) * 0.5f);
                            if (_e1901 > _e1916) {
                                phi_3420_ = _e1901;
                            } else {
                                phi_3420_ = _e1916;
                            }
                            let _e1919 = phi_3420_;
                            let _e1924 = local_2.member_3;
                            let _e1937 = ((((_e1621[0] * _e1546) + (_e1621[1] * _e1549)) + (_e1621[2] * _e1552)) * 3f);
                            let _e1938 = ((((_e1678[0] * _e1567) + (_e1678[1] * _e1570)) + (_e1678[2] * _e1573)) * 3f);
                            if (_e1937 < _e1938) {
                                phi_3444_ = _e1937;
                            } else {
                                phi_3444_ = _e1938;
                            }
                            let _e1941 = phi_3444_;
                            if (_e1652 < _e1675) {
                                phi_3449_ = _e1652;
                            } else {
                                phi_3449_ = _e1675;
                            }
                            let _e1944 = phi_3449_;
                            if (_e1941 < _e1944) {
                                phi_3454_ = _e1941;
                            } else {
                                phi_3454_ = _e1944;
                            }
                            let _e1947 = phi_3454_;
                            if (_e1937 > _e1938) {
                                phi_3459_ = _e1937;
                            } else {
                                phi_3459_ = _e1938;
                            }
                            let _e1950 = phi_3459_;
                            if (_e1652 > _e1675) {
                                phi_3464_ = _e1652;
                            } else {
                                phi_3464_ = _e1675;
                            }
                            let _e1953 = phi_3464_;
                            if (_e1950 > _e1953) {
                                phi_3469_ = _e1950;
                            } else {
                                phi_3469_ = _e1953;
                            }
                            let _e1956 = phi_3469_;
                            let _e1961 = -(_e1956);
                            if (_e1947 > _e1961) {
                                phi_3479_ = _e1947;
                            } else {
                                phi_3479_ = _e1961;
                            }
                            let _e1964 = phi_3479_;
                            let _e1966 = ((_e1964 - ((((((_e1740 * 8f) * _e1850) * (0.000000059604645f * (524f / 64f))) + ((_e1857 * 19f) * ((_e1740 * (_e1794 + _e1848)) + (_e1794 * _e1848)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1740) * ((1f + _e1794) * (1f + _e1848))))) + ((_e1454 * (((_e1919 + (_e1850 * (0.000000059604645f * 8f))) + ((_e1924 * 6f) * (_e1794 + _e1848))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1794) * (1f + _e1848))))) * (3f * 1.0001f)))) > 0f);
                            if _e1966 {
                                phi_4448_ = _e1966;
                            } else {
                                let _e1969 = local_2.member_1[0u];
                                let _e1975 = local_2.member_1[1u];
                                let _e1979 = (_e1969[0] + _e1975[0]);
                                let _e1980 = (_e1969[1] + _e1975[1]);
                                let _e1981 = (_e1969[2] + _e1975[2]);
                                let _e1984 = local_2.member_2[0u];
                                let _e1990 = local_2.member_2[1u];
                                let _e1994 = (_e1984[0] + _e1990[0]);
                                let _e1995 = (_e1984[1] + _e1990[1]);
                                let _e1996 = (_e1984[2] + _e1990[2]);
                                let _e1999 = ((_e1980 * _e1996) - (_e1981 * _e1995));
                                let _e2002 = ((_e1981 * _e1994) - (_e1979 * _e1996));
                                let _e2005 = ((_e1979 * _e1995) - (_e1980 * _e1994));
                                let _e2008 = local_2.member[0u];
                                let _e2014 = local_2.member_1[0u];
                                let _e2020 = local_2.member_2[0u];
                                let _e2024 = (_e2008[0] - _e2014[0]);
                                let _e2025 = (_e2008[1] - _e2014[1]);
                                let _e2026 = (_e2008[2] - _e2014[2]);
                                let _e2027 = (_e2024 - _e2020[0]);
                                let _e2028 = (_e2025 - _e2020[1]);
                                let _e2029 = (_e2026 - _e2020[2]);
                                let _e2030 = (_e2008[0] - _e2020[0]);
                                let _e2031 = (_e2008[1] - _e2020[1]);
                                let _e2032 = (_e2008[2] - _e2020[2]);
                                let _e2035 = local_2.member[1u];
                                let _e2041 = local_2.member_1[1u];
                                let _e2047 = local_2.member_2[1u];
                                let _e2051 = (_e2035[0] - _e2041[0]);
                                let _e2052 = (_e2035[1] - _e2041[1]);
                                let _e2053 = (_e2035[2] - _e2041[2]);
                                let _e2054 = (_e2051 - _e2047[0]);
                                let _e2055 = (_e2052 - _e2047[1]);
                                let _e2056 = (_e2053 - _e2047[2]);
                                let _e2057 = (_e2035[0] - _e2047[0]);
                                let _e2058 = (_e2035[1] - _e2047[1]);
                                let _e2059 = (_e2035[2] - _e2047[2]);
                                let _e2062 = local_2.member[0u];
                                if (_e2062[0] < 0f) {
                                    phi_3682_ = -(_e2062[0]);
                                } else {
                                    phi_3682_ = _e2062[0];
                                }
                                let _e2069 = phi_3682_;
                                if (_e2062[1] < 0f) {
                                    phi_3689_ = -(_e2062[1]);
                                } else {
                                    phi_3689_ = _e2062[1];
                                }
                                let _e2073 = phi_3689_;
                                if (_e2069 > _e2073) {
                                    phi_3694_ = _e2069;
                                } else {
                                    phi_3694_ = _e2073;
                                }
                                let _e2076 = phi_3694_;
                                if (_e2062[2] < 0f) {
                                    phi_3701_ = -(_e2062[2]);
                                } else {
                                    phi_3701_ = _e2062[2];
                                }
                                let _e2080 = phi_3701_;
                                if (_e2076 > _e2080) {
                                    phi_3706_ = _e2076;
                                } else {
                                    phi_3706_ = _e2080;
                                }
                                let _e2083 = phi_3706_;
                                let _e2086 = local_2.member[1u];
                                if (_e2086[0] < 0f) {
                                    phi_3719_ = -(_e2086[0]);
                                } else {
                                    phi_3719_ = _e2086[0];
                                }
                                let _e2093 = phi_3719_;
                                if (_e2086[1] < 0f) {
                                    phi_3726_ = -(_e2086[1]);
                                } else {
                                    phi_3726_ = _e2086[1];
                                }
                                let _e2097 = phi_3726_;
                                if (_e2093 > _e2097) {
                                    phi_3731_ = _e2093;
                                } else {
                                    phi_3731_ = _e2097;
                                }
                                let _e2100 = phi_3731_;
                                if (_e2086[2] < 0f) {
                                    phi_3738_ = -(_e2086[2]);
                                } else {
                                    phi_3738_ = _e2086[2];
                                }
                                let _e2104 = phi_3738_;
                                if (_e2100 > _e2104) {
                                    phi_3743_ = _e2100;
                                } else {
                                    phi_3743_ = _e2104;
                                }
                                let _e2107 = phi_3743_;
                                if (_e2083 > _e2107) {
                                    phi_3748_ = _e2083;
                                } else {
                                    phi_3748_ = _e2107;
                                }
                                let _e2110 = phi_3748_;
                                let _e2112 = local_2.member_3;
                                let _e2116 = local_2.member_1[0u];
                                if (_e2116[0] < 0f) {
                                    phi_3765_ = -(_e2116[0]);
                                } else {
                                    phi_3765_ = _e2116[0];
                                }
                                let _e2123 = phi_3765_;
                                if (_e2116[1] < 0f) {
                                    phi_3772_ = -(_e2116[1]);
                                } else {
                                    phi_3772_ = _e2116[1];
                                }
                                let _e2127 = phi_3772_;
                                if (_e2123 > _e2127) {
                                    phi_3777_ = _e2123;
                                } else {
                                    phi_3777_ = _e2127;
                                }
                                let _e2130 = phi_3777_;
                                if (_e2116[2] < 0f) {
                                    phi_3784_ = -(_e2116[2]);
                                } else {
                                    phi_3784_ = _e2116[2];
                                }
                                let _e2134 = phi_3784_;
                                if (_e2130 > _e2134) {
                                    phi_3789_ = _e2130;
                                } else {
                                    phi_3789_ = _e2134;
                                }
                                let _e2137 = phi_3789_;
                                let _e2140 = local_2.member_1[1u];
                                if (_e2140[0] < 0f) {
                                    phi_3803_ = -(_e2140[0]);
                                } else {
                                    phi_3803_ = _e2140[0];
                                }
                                let _e2147 = phi_3803_;
                                if (_e2140[1] < 0f) {
                                    phi_3810_ = -(_e2140[1]);
                                } else {
                                    phi_3810_ = _e2140[1];
                                }
                                let _e2151 = phi_3810_;
                                if (_e2147 > _e2151) {
                                    phi_3815_ = _e2147;
                                } else {
                                    phi_3815_ = _e2151;
                                }
                                let _e2154 = phi_3815_;
                                if (_e2140[2] < 0f) {
                                    phi_3822_ = -(_e2140[2]);
                                } else {
                                    phi_3822_ = _e2140[2];
                                }
                                let _e2158 = phi_3822_;
                                if (_e2154 > _e2158) {
                                    phi_3827_ = _e2154;
                                } else {
                                    phi_3827_ = _e2158;
                                }
                                let _e2161 = phi_3827_;
                                if (_e2137 > _e2161) {
                                    phi_3832_ = _e2137;
                                } else {
                                    phi_3832_ = _e2161;
                                }
                                let _e2164 = phi_3832_;
                                let _e2166 = local_2.member_3;
                                let _e2170 = local_2.member_2[0u];
                                if (_e2170[0] < 0f) {
                                    phi_3849_ = -(_e2170[0]);
                                } else {
                                    phi_3849_ = _e2170[0];
                                }
                                let _e2177 = phi_3849_;
                                if (_e2170[1] < 0f) {
                                    phi_3856_ = -(_e2170[1]);
                                } else {
                                    phi_3856_ = _e2170[1];
                                }
                                let _e2181 = phi_3856_;
                                if (_e2177 > _e2181) {
                                    phi_3861_ = _e2177;
                                } else {
                                    phi_3861_ = _e2181;
                                }
                                let _e2184 = phi_3861_;
                                if (_e2170[2] < 0f) {
                                    phi_3868_ = -(_e2170[2]);
                                } else {
                                    phi_3868_ = _e2170[2];
                                }
                                let _e2188 = phi_3868_;
                                if (_e2184 > _e2188) {
                                    phi_3873_ = _e2184;
                                } else {
                                    phi_3873_ = _e2188;
                                }
                                let _e2191 = phi_3873_;
                                let _e2194 = local_2.member_2[1u];
                                if (_e2194[0] < 0f) {
                                    phi_3887_ = -(_e2194[0]);
                                } else {
                                    phi_3887_ = _e2194[0];
                                }
                                let _e2201 = phi_3887_;
                                if (_e2194[1] < 0f) {
                                    phi_3894_ = -(_e2194[1]);
                                } else {
                                    phi_3894_ = _e2194[1];
                                }
                                let _e2205 = phi_3894_;
                                if (_e2201 > _e2205) {
                                    phi_3899_ = _e2201;
                                } else {
                                    phi_3899_ = _e2205;
                                }
                                let _e2208 = phi_3899_;
                                if (_e2194[2] < 0f) {
                                    phi_3906_ = -(_e2194[2]);
                                } else {
                                    phi_3906_ = _e2194[2];
                                }
                                let _e2212 = phi_3906_;
                                if (_e2208 > _e2212) {
                                    phi_3911_ = _e2208;
                                } else {
                                    phi_3911_ = _e2212;
                                }
                                let _e2215 = phi_3911_;
                                if (_e2191 > _e2215) {
                                    phi_3916_ = _e2191;
                                } else {
                                    phi_3916_ = _e2215;
                                }
                                let _e2218 = phi_3916_;
                                let _e2220 = local_2.member_3;
                                let _e2224 = ((((_e2110 + _e2112) + (_e2164 + _e2166)) + (_e2218 + _e2220)) * 2f);
                                let _e2227 = local_2.member_3;
                                let _e2231 = (((_e1454 * 1.0001f) + (_e2227 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2234 = ((_e2002 * _e1981) - (_e2005 * _e1980));
                                let _e2237 = ((_e2005 * _e1979) - (_e1999 * _e1981));
                                let _e2240 = ((_e1999 * _e1980) - (_e2002 * _e1979));
                                let _e2245 = (((_e2234 * _e2008[0]) + (_e2237 * _e2008[1])) + (_e2240 * _e2008[2]));
                                let _e2250 = (((_e2234 * _e2024) + (_e2237 * _e2025)) + (_e2240 * _e2026));
                                let _e2255 = (((_e2234 * _e2030) + (_e2237 * _e2031)) + (_e2240 * _e2032));
                                let _e2260 = (((_e2234 * _e2027) + (_e2237 * _e2028)) + (_e2240 * _e2029));
                                let _e2265 = (((_e2234 * _e2035[0]) + (_e2237 * _e2035[1])) + (_e2240 * _e2035[2]));
                                let _e2270 = (((_e2234 * _e2051) + (_e2237 * _e2052)) + (_e2240 * _e2053));
                                let _e2275 = (((_e2234 * _e2057) + (_e2237 * _e2058)) + (_e2240 * _e2059));
                                let _e2280 = (((_e2234 * _e2054) + (_e2237 * _e2055)) + (_e2240 * _e2056));
                                if (_e2245 < _e2250) {
                                    phi_3995_ = _e2245;
                                } else {
                                    phi_3995_ = _e2250;
                                }
                                let _e2283 = phi_3995_;
                                if (_e2255 < _e2260) {
                                    phi_4000_ = _e2255;
                                } else {
                                    phi_4000_ = _e2260;
                                }
                                let _e2286 = phi_4000_;
                                if (_e2283 < _e2286) {
                                    phi_4005_ = _e2283;
                                } else {
                                    phi_4005_ = _e2286;
                                }
                                let _e2289 = phi_4005_;
                                if (_e2265 < _e2270) {
                                    phi_4010_ = _e2265;
                                } else {
                                    phi_4010_ = _e2270;
                                }
                                let _e2292 = phi_4010_;
                                if (_e2275 < _e2280) {
                                    phi_4015_ = _e2275;
                                } else {
                                    phi_4015_ = _e2280;
                                }
                                let _e2295 = phi_4015_;
                                if (_e2292 < _e2295) {
                                    phi_4020_ = _e2292;
                                } else {
                                    phi_4020_ = _e2295;
                                }
                                let _e2298 = phi_4020_;
                                if (_e2289 < _e2298) {
                                    phi_4025_ = _e2289;
                                } else {
                                    phi_4025_ = _e2298;
                                }
                                let _e2301 = phi_4025_;
                                if (_e2245 > _e2250) {
                                    phi_4030_ = _e2245;
                                } else {
                                    phi_4030_ = _e2250;
                                }
                                let _e2304 = phi_4030_;
                                if (_e2255 > _e2260) {
                                    phi_4035_ = _e2255;
                                } else {
                                    phi_4035_ = _e2260;
                                }
                                let _e2307 = phi_4035_;
                                if (_e2304 > _e2307) {
                                    phi_4040_ = _e2304;
                                } else {
                                    phi_4040_ = _e2307;
                                }
                                let _e2310 = phi_4040_;
                                if (_e2265 > _e2270) {
                                    phi_4045_ = _e2265;
                                } else {
                                    phi_4045_ = _e2270;
                                }
                                let _e2313 = phi_4045_;
                                if (_e2275 > _e2280) {
                                    phi_4050_ = _e2275;
                                } else {
                                    phi_4050_ = _e2280;
                                }
                                let _e2316 = phi_4050_;
                                if (_e2313 > _e2316) {
                                    phi_4055_ = _e2313;
                                } else {
                                    phi_4055_ = _e2316;
                                }
                                let _e2319 = phi_4055_;
                                if (_e2310 > _e2319) {
                                    phi_4060_ = _e2310;
                                } else {
                                    phi_4060_ = _e2319;
                                }
                                let _e2322 = phi_4060_;
                                if (_e2234 < 0f) {
                                    phi_4066_ = -(_e2234);
                                } else {
                                    phi_4066_ = _e2234;
                                }
                                let _e2326 = phi_4066_;
                                if (_e2237 < 0f) {
                                    phi_4072_ = -(_e2237);
                                } else {
                                    phi_4072_ = _e2237;
                                }
                                let _e2330 = phi_4072_;
                                if (_e2240 < 0f) {
                                    phi_4079_ = -(_e2240);
                                } else {
                                    phi_4079_ = _e2240;
                                }
                                let _e2335 = phi_4079_;
                                let _e2336 = ((_e2326 + _e2330) + _e2335);
                                let _e2341 = -(_e2322);
                                if (_e2301 > _e2341) {
                                    phi_4090_ = _e2301;
                                } else {
                                    phi_4090_ = _e2341;
                                }
                                let _e2344 = phi_4090_;
                                let _e2349 = (((_e2344 - ((_e2336 * _e2224) * (0.000000059604645f * (17f / 2f)))) - (_e2336 * _e2231)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2352 = ((_e2002 * _e1996) - (_e2005 * _e1995));
                                let _e2355 = ((_e2005 * _e1994) - (_e1999 * _e1996));
                                let _e2358 = ((_e1999 * _e1995) - (_e2002 * _e1994));
                                let _e2363 = (((_e2352 * _e2008[0]) + (_e2355 * _e2008[1])) + (_e2358 * _e2008[2]));
                                let _e2368 = (((_e2352 * _e2024) + (_e2355 * _e2025)) + (_e2358 * _e2026));
                                let _e2373 = (((_e2352 * _e2030) + (_e2355 * _e2031)) + (_e2358 * _e2032));
                                let _e2378 = (((_e2352 * _e2027) + (_e2355 * _e2028)) + (_e2358 * _e2029));
                                let _e2383 = (((_e2352 * _e2035[0]) + (_e2355 * _e2035[1])) + (_e2358 * _e2035[2]));
                                let _e2388 = (((_e2352 * _e2051) + (_e2355 * _e2052)) + (_e2358 * _e2053));
                                let _e2393 = (((_e2352 * _e2057) + (_e2355 * _e2058)) + (_e2358 * _e2059));
                                let _e2398 = (((_e2352 * _e2054) + (_e2355 * _e2055)) + (_e2358 * _e2056));
                                if (_e2363 < _e2368) {
                                    phi_4161_ = _e2363;
                                } else {
                                    phi_4161_ = _e2368;
                                }
                                let _e2401 = phi_4161_;
                                if (_e2373 < _e2378) {
                                    phi_4166_ = _e2373;
                                } else {
                                    phi_4166_ = _e2378;
                                }
                                let _e2404 = phi_4166_;
                                if (_e2401 < _e2404) {
                                    phi_4171_ = _e2401;
                                } else {
                                    phi_4171_ = _e2404;
                                }
                                let _e2407 = phi_4171_;
                                if (_e2383 < _e2388) {
                                    phi_4176_ = _e2383;
                                } else {
                                    phi_4176_ = _e2388;
                                }
                                let _e2410 = phi_4176_;
                                if (_e2393 < _e2398) {
                                    phi_4181_ = _e2393;
                                } else {
                                    phi_4181_ = _e2398;
                                }
                                let _e2413 = phi_4181_;
                                if (_e2410 < _e2413) {
                                    phi_4186_ = _e2410;
                                } else {
                                    phi_4186_ = _e2413;
                                }
                                let _e2416 = phi_4186_;
                                if (_e2407 < _e2416) {
                                    phi_4191_ = _e2407;
                                } else {
                                    phi_4191_ = _e2416;
                                }
                                let _e2419 = phi_4191_;
                                if (_e2363 > _e2368) {
                                    phi_4196_ = _e2363;
                                } else {
                                    phi_4196_ = _e2368;
                                }
                                let _e2422 = phi_4196_;
                                if (_e2373 > _e2378) {
                                    phi_4201_ = _e2373;
                                } else {
                                    phi_4201_ = _e2378;
                                }
                                let _e2425 = phi_4201_;
                                if (_e2422 > _e2425) {
                                    phi_4206_ = _e2422;
                                } else {
                                    phi_4206_ = _e2425;
                                }
                                let _e2428 = phi_4206_;
                                if (_e2383 > _e2388) {
                                    phi_4211_ = _e2383;
                                } else {
                                    phi_4211_ = _e2388;
                                }
                                let _e2431 = phi_4211_;
                                if (_e2393 > _e2398) {
                                    phi_4216_ = _e2393;
                                } else {
                                    phi_4216_ = _e2398;
                                }
                                let _e2434 = phi_4216_;
                                if (_e2431 > _e2434) {
                                    phi_4221_ = _e2431;
                                } else {
                                    phi_4221_ = _e2434;
                                }
                                let _e2437 = phi_4221_;
                                if (_e2428 > _e2437) {
                                    phi_4226_ = _e2428;
                                } else {
                                    phi_4226_ = _e2437;
                                }
                                let _e2440 = phi_4226_;
                                if (_e2352 < 0f) {
                                    phi_4232_ = -(_e2352);
                                } else {
                                    phi_4232_ = _e2352;
                                }
                                let _e2444 = phi_4232_;
                                if (_e2355 < 0f) {
                                    phi_4238_ = -(_e2355);
                                } else {
                                    phi_4238_ = _e2355;
                                }
                                let _e2448 = phi_4238_;
                                if (_e2358 < 0f) {
                                    phi_4245_ = -(_e2358);
                                } else {
                                    phi_4245_ = _e2358;
                                }
                                let _e2453 = phi_4245_;
                                let _e2454 = ((_e2444 + _e2448) + _e2453);
                                let _e2459 = -(_e2440);
                                if (_e2419 > _e2459) {
                                    phi_4256_ = _e2419;
                                } else {
                                    phi_4256_ = _e2459;
                                }
                                let _e2462 = phi_4256_;
                                let _e2467 = (((_e2462 - ((_e2454 * _e2224) * (0.000000059604645f * (17f / 2f)))) - (_e2454 * _e2231)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2349 > _e2467) {
                                    phi_4266_ = _e2349;
                                } else {
                                    phi_4266_ = _e2467;
                                }
                                let _e2470 = phi_4266_;
                                phi_4448_ = (_e1966 || (_e2470 > 0f));
                            }
                            let _e2474 = phi_4448_;
                            if _e2474 {
                                phi_7865_ = _e2474;
                            } else {
                                let _e2477 = local_2.member[0u];
                                let _e2483 = local_2.member[1u];
                                let _e2490 = ((_e2477[0] + _e2483[0]) * 0.5f);
                                let _e2491 = ((_e2477[1] + _e2483[1]) * 0.5f);
                                let _e2492 = ((_e2477[2] + _e2483[2]) * 0.5f);
                                let _e2495 = local_2.member_1[0u];
                                let _e2501 = local_2.member_1[1u];
                                let _e2508 = ((_e2495[0] + _e2501[0]) * 0.5f);
                                let _e2509 = ((_e2495[1] + _e2501[1]) * 0.5f);
                                let _e2510 = ((_e2495[2] + _e2501[2]) * 0.5f);
                                let _e2513 = local_2.member_2[0u];
                                let _e2519 = local_2.member_2[1u];
                                let _e2526 = ((_e2513[0] + _e2519[0]) * 0.5f);
                                let _e2527 = ((_e2513[1] + _e2519[1]) * 0.5f);
                                let _e2528 = ((_e2513[2] + _e2519[2]) * 0.5f);
                                let _e2531 = local_2.member[0u];
                                let _e2534 = local_2.member_1[0u];
                                let _e2537 = local_2.member_2[0u];
                                let _e2539 = local_2.member_3;
                                let _e2542 = local_2.member[1u];
                                let _e2545 = local_2.member_1[1u];
                                let _e2548 = local_2.member_2[1u];
                                let _e2550 = local_2.member_3;
                                local = type_37(array<array<f32, 3>, 2>(_e2531, array<f32, 3>(_e2490, _e2491, _e2492)), array<array<f32, 3>, 2>(_e2534, array<f32, 3>(_e2508, _e2509, _e2510)), array<array<f32, 3>, 2>(_e2537, array<f32, 3>(_e2526, _e2527, _e2528)), _e2539);
                                local_1 = type_37(array<array<f32, 3>, 2>(array<f32, 3>(_e2490, _e2491, _e2492), _e2542), array<array<f32, 3>, 2>(array<f32, 3>(_e2508, _e2509, _e2510), _e2545), array<array<f32, 3>, 2>(array<f32, 3>(_e2526, _e2527, _e2528), _e2548), _e2550);
                                let _e2567 = local.member_1[0u];
                                let _e2573 = local.member_2[0u];
                                let _e2579 = ((_e2567[1] * _e2573[2]) - (_e2567[2] * _e2573[1]));
                                let _e2582 = ((_e2567[2] * _e2573[0]) - (_e2567[0] * _e2573[2]));
                                let _e2585 = ((_e2567[0] * _e2573[1]) - (_e2567[1] * _e2573[0]));
                                let _e2588 = local.member_1[1u];
                                let _e2594 = local.member_2[1u];
                                let _e2600 = ((_e2588[1] * _e2594[2]) - (_e2588[2] * _e2594[1]));
                                let _e2603 = ((_e2588[2] * _e2594[0]) - (_e2588[0] * _e2594[2]));
                                let _e2606 = ((_e2588[0] * _e2594[1]) - (_e2588[1] * _e2594[0]));
                                let _e2609 = local.member_1[0u];
                                let _e2615 = local.member_2[1u];
                                let _e2630 = local.member_1[1u];
                                let _e2636 = local.member_2[0u];
                                let _e2649 = (((_e2609[1] * _e2615[2]) - (_e2609[2] * _e2615[1])) + ((_e2630[1] * _e2636[2]) - (_e2630[2] * _e2636[1])));
                                let _e2650 = (((_e2609[2] * _e2615[0]) - (_e2609[0] * _e2615[2])) + ((_e2630[2] * _e2636[0]) - (_e2630[0] * _e2636[2])));
                                let _e2651 = (((_e2609[0] * _e2615[1]) - (_e2609[1] * _e2615[0])) + ((_e2630[0] * _e2636[1]) - (_e2630[1] * _e2636[0])));
                                let _e2654 = local.member[0u];
                                let _e2665 = local.member[1u];
                                let _e2676 = local.member[0u];
                                let _e2685 = ((((_e2665[0] * _e2579) + (_e2665[1] * _e2582)) + (_e2665[2] * _e2585)) + (((_e2676[0] * _e2649) + (_e2676[1] * _e2650)) + (_e2676[2] * _e2651)));
                                let _e2688 = local.member[0u];
                                let _e2699 = local.member[1u];
                                let _e2708 = ((((_e2688[0] * _e2600) + (_e2688[1] * _e2603)) + (_e2688[2] * _e2606)) + (((_e2699[0] * _e2649) + (_e2699[1] * _e2650)) + (_e2699[2] * _e2651)));
                                let _e2711 = local.member[1u];
                                let _e2722 = local.member[0u];
                                if (_e2722[0] < 0f) {
                                    phi_4900_ = -(_e2722[0]);
                                } else {
                                    phi_4900_ = _e2722[0];
                                }
                                let _e2729 = phi_4900_;
                                if (_e2722[1] < 0f) {
                                    phi_4907_ = -(_e2722[1]);
                                } else {
                                    phi_4907_ = _e2722[1];
                                }
                                let _e2733 = phi_4907_;
                                if (_e2729 > _e2733) {
                                    phi_4912_ = _e2729;
                                } else {
                                    phi_4912_ = _e2733;
                                }
                                let _e2736 = phi_4912_;
                                if (_e2722[2] < 0f) {
                                    phi_4919_ = -(_e2722[2]);
                                } else {
                                    phi_4919_ = _e2722[2];
                                }
                                let _e2740 = phi_4919_;
                                if (_e2736 > _e2740) {
                                    phi_4924_ = _e2736;
                                } else {
                                    phi_4924_ = _e2740;
                                }
                                let _e2743 = phi_4924_;
                                let _e2746 = local.member[1u];
                                if (_e2746[0] < 0f) {
                                    phi_4937_ = -(_e2746[0]);
                                } else {
                                    phi_4937_ = _e2746[0];
                                }
                                let _e2753 = phi_4937_;
                                if (_e2746[1] < 0f) {
                                    phi_4944_ = -(_e2746[1]);
                                } else {
                                    phi_4944_ = _e2746[1];
                                }
                                let _e2757 = phi_4944_;
                                if (_e2753 > _e2757) {
                                    phi_4949_ = _e2753;
                                } else {
                                    phi_4949_ = _e2757;
                                }
                                let _e2760 = phi_4949_;
                                if (_e2746[2] < 0f) {
                                    phi_4956_ = -(_e2746[2]);
                                } else {
                                    phi_4956_ = _e2746[2];
                                }
                                let _e2764 = phi_4956_;
                                if (_e2760 > _e2764) {
                                    phi_4961_ = _e2760;
                                } else {
                                    phi_4961_ = _e2764;
                                }
                                let _e2767 = phi_4961_;
                                if (_e2743 > _e2767) {
                                    phi_4966_ = _e2743;
                                } else {
                                    phi_4966_ = _e2767;
                                }
                                let _e2770 = phi_4966_;
                                let _e2772 = local.member_3;
                                let _e2773 = (_e2770 + _e2772);
                                let _e2776 = local.member_1[0u];
                                if (_e2776[0] < 0f) {
                                    phi_4983_ = -(_e2776[0]);
                                } else {
                                    phi_4983_ = _e2776[0];
                                }
                                let _e2783 = phi_4983_;
                                if (_e2776[1] < 0f) {
                                    phi_4990_ = -(_e2776[1]);
                                } else {
                                    phi_4990_ = _e2776[1];
                                }
                                let _e2787 = phi_4990_;
                                if (_e2783 > _e2787) {
                                    phi_4995_ = _e2783;
                                } else {
                                    phi_4995_ = _e2787;
                                }
                                let _e2790 = phi_4995_;
                                if (_e2776[2] < 0f) {
                                    phi_5002_ = -(_e2776[2]);
                                } else {
                                    phi_5002_ = _e2776[2];
                                }
                                let _e2794 = phi_5002_;
                                if (_e2790 > _e2794) {
                                    phi_5007_ = _e2790;
                                } else {
                                    phi_5007_ = _e2794;
                                }
                                let _e2797 = phi_5007_;
                                let _e2800 = local.member_1[1u];
                                if (_e2800[0] < 0f) {
                                    phi_5021_ = -(_e2800[0]);
                                } else {
                                    phi_5021_ = _e2800[0];
                                }
                                let _e2807 = phi_5021_;
                                if (_e2800[1] < 0f) {
                                    phi_5028_ = -(_e2800[1]);
                                } else {
                                    phi_5028_ = _e2800[1];
                                }
                                let _e2811 = phi_5028_;
                                if (_e2807 > _e2811) {
                                    phi_5033_ = _e2807;
                                } else {
                                    phi_5033_ = _e2811;
                                }
                                let _e2814 = phi_5033_;
                                if (_e2800[2] < 0f) {
                                    phi_5040_ = -(_e2800[2]);
                                } else {
                                    phi_5040_ = _e2800[2];
                                }
                                let _e2818 = phi_5040_;
                                if (_e2814 > _e2818) {
                                    phi_5045_ = _e2814;
                                } else {
                                    phi_5045_ = _e2818;
                                }
                                let _e2821 = phi_5045_;
                                if (_e2797 > _e2821) {
                                    phi_5050_ = _e2797;
                                } else {
                                    phi_5050_ = _e2821;
                                }
                                let _e2824 = phi_5050_;
                                let _e2826 = local.member_3;
                                let _e2827 = (_e2824 + _e2826);
                                let _e2830 = local.member_2[0u];
                                if (_e2830[0] < 0f) {
                                    phi_5067_ = -(_e2830[0]);
                                } else {
                                    phi_5067_ = _e2830[0];
                                }
                                let _e2837 = phi_5067_;
                                if (_e2830[1] < 0f) {
                                    phi_5074_ = -(_e2830[1]);
                                } else {
                                    phi_5074_ = _e2830[1];
                                }
                                let _e2841 = phi_5074_;
                                if (_e2837 > _e2841) {
                                    phi_5079_ = _e2837;
                                } else {
                                    phi_5079_ = _e2841;
                                }
                                let _e2844 = phi_5079_;
                                if (_e2830[2] < 0f) {
                                    phi_5086_ = -(_e2830[2]);
                                } else {
                                    phi_5086_ = _e2830[2];
                                }
                                let _e2848 = phi_5086_;
                                if (_e2844 > _e2848) {
                                    phi_5091_ = _e2844;
                                } else {
                                    phi_5091_ = _e2848;
                                }
                                let _e2851 = phi_5091_;
                                let _e2854 = local.member_2[1u];
                                if (_e2854[0] < 0f) {
                                    phi_5105_ = -(_e2854[0]);
                                } else {
                                    phi_5105_ = _e2854[0];
                                }
                                let _e2861 = phi_5105_;
                                if (_e2854[1] < 0f) {
                                    phi_5112_ = -(_e2854[1]);
                                } else {
                                    phi_5112_ = _e2854[1];
                                }
                                let _e2865 = phi_5112_;
                                if (_e2861 > _e2865) {
                                    phi_5117_ = _e2861;
                                } else {
                                    phi_5117_ = _e2865;
                                }
                                let _e2868 = phi_5117_;
                                if (_e2854[2] < 0f) {
                                    phi_5124_ = -(_e2854[2]);
                                } else {
                                    phi_5124_ = _e2854[2];
                                }
                                let _e2872 = phi_5124_;
                                if (_e2868 > _e2872) {
                                    phi_5129_ = _e2868;
                                } else {
                                    phi_5129_ = _e2872;
                                }
                                let _e2875 = phi_5129_;
                                if (_e2851 > _e2875) {
                                    phi_5134_ = _e2851;
                                } else {
                                    phi_5134_ = _e2875;
                                }
                                let _e2878 = phi_5134_;
                                let _e2880 = local.member_3;
                                let _e2881 = (_e2878 + _e2880);
                                let _e2883 = ((_e2827 * 8f) * _e2881);
                                let _e2890 = local.member_3;
                                if (_e2579 < 0f) {
                                    phi_5165_ = -(_e2579);
                                } else {
                                    phi_5165_ = _e2579;
                                }
                                let _e2907 = phi_5165_;
                                if (_e2582 < 0f) {
                                    phi_5171_ = -(_e2582);
                                } else {
                                    phi_5171_ = _e2582;
                                }
                                let _e2911 = phi_5171_;
                                if (_e2585 < 0f) {
                                    phi_5178_ = -(_e2585);
                                } else {
                                    phi_5178_ = _e2585;
                                }
                                let _e2916 = phi_5178_;
                                let _e2917 = ((_e2907 + _e2911) + _e2916);
                                if (_e2600 < 0f) {
                                    phi_5185_ = -(_e2600);
                                } else {
                                    phi_5185_ = _e2600;
                                }
                                let _e2921 = phi_5185_;
                                if (_e2603 < 0f) {
                                    phi_5191_ = -(_e2603);
                                } else {
                                    phi_5191_ = _e2603;
                                }
                                let _e2925 = phi_5191_;
                                if (_e2606 < 0f) {
                                    phi_5198_ = -(_e2606);
                                } else {
                                    phi_5198_ = _e2606;
                                }
                                let _e2930 = phi_5198_;
                                let _e2931 = ((_e2921 + _e2925) + _e2930);
                                if (_e2917 > _e2931) {
                                    phi_5204_ = _e2917;
                                } else {
                                    phi_5204_ = _e2931;
                                }
                                let _e2934 = phi_5204_;
                                if (_e2649 < 0f) {
                                    phi_5210_ = -(_e2649);
                                } else {
                                    phi_5210_ = _e2649;
                                }
                                let _e2938 = phi_5210_;
                                if (_e2650 < 0f) {
                                    phi_5216_ = -(_e2650);
                                } else {
                                    phi_5216_ = _e2650;
                                }
                                let _e2942 = phi_5216_;
                                if (_e2651 < 0f) {
                                    phi_5223_ = -(_e2651);
                                } else {
                                    phi_5223_ = _e2651;
                                }
                                let _e2947 = phi_5223_;
                                let _e2949 = (((_e2938 + _e2942) + _e2947) * 0.5f);
                                if (_e2934 > _e2949) {
                                    phi_5230_ = _e2934;
                                } else {
                                    phi_5230_ = _e2949;
                                }
                                let _e2952 = phi_5230_;
                                let _e2957 = local.member_3;
                                let _e2970 = ((((_e2654[0] * _e2579) + (_e2654[1] * _e2582)) + (_e2654[2] * _e2585)) * 3f);
                                let _e2971 = ((((_e2711[0] * _e2600) + (_e2711[1] * _e2603)) + (_e2711[2] * _e2606)) * 3f);
                                if (_e2970 < _e2971) {
                                    phi_5254_ = _e2970;
                                } else {
                                    phi_5254_ = _e2971;
                                }
                                let _e2974 = phi_5254_;
                                if (_e2685 < _e2708) {
                                    phi_5259_ = _e2685;
                                } else {
                                    phi_5259_ = _e2708;
                                }
                                let _e2977 = phi_5259_;
                                if (_e2974 < _e2977) {
                                    phi_5264_ = _e2974;
                                } else {
                                    phi_5264_ = _e2977;
                                }
                                let _e2980 = phi_5264_;
                                if (_e2970 > _e2971) {
                                    phi_5269_ = _e2970;
                                } else {
                                    phi_5269_ = _e2971;
                                }
                                let _e2983 = phi_5269_;
                                if (_e2685 > _e2708) {
                                    phi_5274_ = _e2685;
                                } else {
                                    phi_5274_ = _e2708;
                                }
                                let _e2986 = phi_5274_;
                                if (_e2983 > _e2986) {
                                    phi_5279_ = _e2983;
                                } else {
                                    phi_5279_ = _e2986;
                                }
                                let _e2989 = phi_5279_;
                                let _e2994 = -(_e2989);
                                if (_e2980 > _e2994) {
                                    phi_5289_ = _e2980;
                                } else {
                                    phi_5289_ = _e2994;
                                }
                                let _e2997 = phi_5289_;
                                let _e2999 = ((_e2997 - ((((((_e2773 * 8f) * _e2883) * (0.000000059604645f * (524f / 64f))) + ((_e2890 * 19f) * ((_e2773 * (_e2827 + _e2881)) + (_e2827 * _e2881)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2773) * ((1f + _e2827) * (1f + _e2881))))) + ((_e1454 * (((_e2952 + (_e2883 * (0.000000059604645f * 8f))) + ((_e2957 * 6f) * (_e2827 + _e2881))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2827) * (1f + _e2881))))) * (3f * 1.0001f)))) > 0f);
                                if _e2999 {
                                    phi_6258_ = _e2999;
                                } else {
                                    let _e3002 = local.member_1[0u];
                                    let _e3008 = local.member_1[1u];
                                    let _e3012 = (_e3002[0] + _e3008[0]);
                                    let _e3013 = (_e3002[1] + _e3008[1]);
                                    let _e3014 = (_e3002[2] + _e3008[2]);
                                    let _e3017 = local.member_2[0u];
                                    let _e3023 = local.member_2[1u];
                                    let _e3027 = (_e3017[0] + _e3023[0]);
                                    let _e3028 = (_e3017[1] + _e3023[1]);
                                    let _e3029 = (_e3017[2] + _e3023[2]);
                                    let _e3032 = ((_e3013 * _e3029) - (_e3014 * _e3028));
                                    let _e3035 = ((_e3014 * _e3027) - (_e3012 * _e3029));
                                    let _e3038 = ((_e3012 * _e3028) - (_e3013 * _e3027));
                                    let _e3041 = local.member[0u];
                                    let _e3047 = local.member_1[0u];
                                    let _e3053 = local.member_2[0u];
                                    let _e3057 = (_e3041[0] - _e3047[0]);
                                    let _e3058 = (_e3041[1] - _e3047[1]);
                                    let _e3059 = (_e3041[2] - _e3047[2]);
                                    let _e3060 = (_e3057 - _e3053[0]);
                                    let _e3061 = (_e3058 - _e3053[1]);
                                    let _e3062 = (_e3059 - _e3053[2]);
                                    let _e3063 = (_e3041[0] - _e3053[0]);
                                    let _e3064 = (_e3041[1] - _e3053[1]);
                                    let _e3065 = (_e3041[2] - _e3053[2]);
                                    let _e3068 = local.member[1u];
                                    let _e3074 = local.member_1[1u];
                                    let _e3080 = local.member_2[1u];
                                    let _e3084 = (_e3068[0] - _e3074[0]);
                                    let _e3085 = (_e3068[1] - _e3074[1]);
                                    let _e3086 = (_e3068[2] - _e3074[2]);
                                    let _e3087 = (_e3084 - _e3080[0]);
                                    let _e3088 = (_e3085 - _e3080[1]);
                                    let _e3089 = (_e3086 - _e3080[2]);
                                    let _e3090 = (_e3068[0] - _e3080[0]);
                                    let _e3091 = (_e3068[1] - _e3080[1]);
                                    let _e3092 = (_e3068[2] - _e3080[2]);
                                    let _e3095 = local.member[0u];
                                    if (_e3095[0] < 0f) {
                                        phi_5492_ = -(_e3095[0]);
                                    } else {
                                        phi_5492_ = _e3095[0];
                                    }
                                    let _e3102 = phi_5492_;
                                    if (_e3095[1] < 0f) {
                                        phi_5499_ = -(_e3095[1]);
                                    } else {
                                        phi_5499_ = _e3095[1];
                                    }
                                    let _e3106 = phi_5499_;
                                    if (_e3102 > _e3106) {
                                        phi_5504_ = _e3102;
                                    } else {
                                        phi_5504_ = _e3106;
                                    }
                                    let _e3109 = phi_5504_;
                                    if (_e3095[2] < 0f) {
                                        phi_5511_ = -(_e3095[2]);
                                    } else {
                                        phi_5511_ = _e3095[2];
                                    }
                                    let _e3113 = phi_5511_;
                                    if (_e3109 > _e3113) {
                                        phi_5516_ = _e3109;
                                    } else {
                                        phi_5516_ = _e3113;
                                    }
                                    let _e3116 = phi_5516_;
                                    let _e3119 = local.member[1u];
                                    if (_e3119[0] < 0f) {
                                        phi_5529_ = -(_e3119[0]);
                                    } else {
                                        phi_5529_ = _e3119[0];
                                    }
                                    let _e3126 = phi_5529_;
                                    if (_e3119[1] < 0f) {
                                        phi_5536_ = -(_e3119[1]);
                                    } else {
                                        phi_5536_ = _e3119[1];
                                    }
                                    let _e3130 = phi_5536_;
                                    if (_e3126 > _e3130) {
                                        phi_5541_ = _e3126;
                                    } else {
                                        phi_5541_ = _e3130;
                                    }
                                    let _e3133 = phi_5541_;
                                    if (_e3119[2] < 0f) {
                                        phi_5548_ = -(_e3119[2]);
                                    } else {
                                        phi_5548_ = _e3119[2];
                                    }
                                    let _e3137 = phi_5548_;
                                    if (_e3133 > _e3137) {
                                        phi_5553_ = _e3133;
                                    } else {
                                        phi_5553_ = _e3137;
                                    }
                                    let _e3140 = phi_5553_;
                                    if (_e3116 > _e3140) {
                                        phi_5558_ = _e3116;
                                    } else {
                                        phi_5558_ = _e3140;
                                    }
                                    let _e3143 = phi_5558_;
                                    let _e3145 = local.member_3;
                                    let _e3149 = local.member_1[0u];
                                    if (_e3149[0] < 0f) {
                                        phi_5575_ = -(_e3149[0]);
                                    } else {
                                        phi_5575_ = _e3149[0];
                                    }
                                    let _e3156 = phi_5575_;
                                    if (_e3149[1] < 0f) {
                                        phi_5582_ = -(_e3149[1]);
                                    } else {
                                        phi_5582_ = _e3149[1];
                                    }
                                    let _e3160 = phi_5582_;
                                    if (_e3156 > _e3160) {
                                        phi_5587_ = _e3156;
                                    } else {
                                        phi_5587_ = _e3160;
                                    }
                                    let _e3163 = phi_5587_;
                                    if (_e3149[2] < 0f) {
                                        phi_5594_ = -(_e3149[2]);
                                    } else {
                                        phi_5594_ = _e3149[2];
                                    }
                                    let _e3167 = phi_5594_;
                                    if (_e3163 > _e3167) {
                                        phi_5599_ = _e3163;
                                    } else {
                                        phi_5599_ = _e3167;
                                    }
                                    let _e3170 = phi_5599_;
                                    let _e3173 = local.member_1[1u];
                                    if (_e3173[0] < 0f) {
                                        phi_5613_ = -(_e3173[0]);
                                    } else {
                                        phi_5613_ = _e3173[0];
                                    }
                                    let _e3180 = phi_5613_;
                                    if (_e3173[1] < 0f) {
                                        phi_5620_ = -(_e3173[1]);
                                    } else {
                                        phi_5620_ = _e3173[1];
                                    }
                                    let _e3184 = phi_5620_;
                                    if (_e3180 > _e3184) {
                                        phi_5625_ = _e3180;
                                    } else {
                                        phi_5625_ = _e3184;
                                    }
                                    let _e3187 = phi_5625_;
                                    if (_e3173[2] < 0f) {
                                        phi_5632_ = -(_e3173[2]);
                                    } else {
                                        phi_5632_ = _e3173[2];
                                    }
                                    let _e3191 = phi_5632_;
                                    if (_e3187 > _e3191) {
                                        phi_5637_ = _e3187;
                                    } else {
                                        phi_5637_ = _e3191;
                                    }
                                    let _e3194 = phi_5637_;
                                    if (_e3170 > _e3194) {
                                        phi_5642_ = _e3170;
                                    } else {
                                        phi_5642_ = _e3194;
                                    }
                                    let _e3197 = phi_5642_;
                                    let _e3199 = local.member_3;
                                    let _e3203 = local.member_2[0u];
                                    if (_e3203[0] < 0f) {
                                        phi_5659_ = -(_e3203[0]);
                                    } else {
                                        phi_5659_ = _e3203[0];
                                    }
                                    let _e3210 = phi_5659_;
                                    if (_e3203[1] < 0f) {
                                        phi_5666_ = -(_e3203[1]);
                                    } else {
                                        phi_5666_ = _e3203[1];
                                    }
                                    let _e3214 = phi_5666_;
                                    if (_e3210 > _e3214) {
                                        phi_5671_ = _e3210;
                                    } else {
                                        phi_5671_ = _e3214;
                                    }
                                    let _e3217 = phi_5671_;
                                    if (_e3203[2] < 0f) {
                                        phi_5678_ = -(_e3203[2]);
                                    } else {
                                        phi_5678_ = _e3203[2];
                                    }
                                    let _e3221 = phi_5678_;
                                    if (_e3217 > _e3221) {
                                        phi_5683_ = _e3217;
                                    } else {
                                        phi_5683_ = _e3221;
                                    }
                                    let _e3224 = phi_5683_;
                                    let _e3227 = local.member_2[1u];
                                    if (_e3227[0] < 0f) {
                                        phi_5697_ = -(_e3227[0]);
                                    } else {
                                        phi_5697_ = _e3227[0];
                                    }
                                    let _e3234 = phi_5697_;
                                    if (_e3227[1] < 0f) {
                                        phi_5704_ = -(_e3227[1]);
                                    } else {
                                        phi_5704_ = _e3227[1];
                                    }
                                    let _e3238 = phi_5704_;
                                    if (_e3234 > _e3238) {
                                        phi_5709_ = _e3234;
                                    } else {
                                        phi_5709_ = _e3238;
                                    }
                                    let _e3241 = phi_5709_;
                                    if (_e3227[2] < 0f) {
                                        phi_5716_ = -(_e3227[2]);
                                    } else {
                                        phi_5716_ = _e3227[2];
                                    }
                                    let _e3245 = phi_5716_;
                                    if (_e3241 > _e3245) {
                                        phi_5721_ = _e3241;
                                    } else {
                                        phi_5721_ = _e3245;
                                    }
                                    let _e3248 = phi_5721_;
                                    if (_e3224 > _e3248) {
                                        phi_5726_ = _e3224;
                                    } else {
                                        phi_5726_ = _e3248;
                                    }
                                    let _e3251 = phi_5726_;
                                    let _e3253 = local.member_3;
                                    let _e3257 = ((((_e3143 + _e3145) + (_e3197 + _e3199)) + (_e3251 + _e3253)) * 2f);
                                    let _e3260 = local.member_3;
                                    let _e3264 = (((_e1454 * 1.0001f) + (_e3260 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3267 = ((_e3035 * _e3014) - (_e3038 * _e3013));
                                    let _e3270 = ((_e3038 * _e3012) - (_e3032 * _e3014));
                                    let _e3273 = ((_e3032 * _e3013) - (_e3035 * _e3012));
                                    let _e3278 = (((_e3267 * _e3041[0]) + (_e3270 * _e3041[1])) + (_e3273 * _e3041[2]));
                                    let _e3283 = (((_e3267 * _e3057) + (_e3270 * _e3058)) + (_e3273 * _e3059));
                                    let _e3288 = (((_e3267 * _e3063) + (_e3270 * _e3064)) + (_e3273 * _e3065));
                                    let _e3293 = (((_e3267 * _e3060) + (_e3270 * _e3061)) + (_e3273 * _e3062));
                                    let _e3298 = (((_e3267 * _e3068[0]) + (_e3270 * _e3068[1])) + (_e3273 * _e3068[2]));
                                    let _e3303 = (((_e3267 * _e3084) + (_e3270 * _e3085)) + (_e3273 * _e3086));
                                    let _e3308 = (((_e3267 * _e3090) + (_e3270 * _e3091)) + (_e3273 * _e3092));
                                    let _e3313 = (((_e3267 * _e3087) + (_e3270 * _e3088)) + (_e3273 * _e3089));
                                    if (_e3278 < _e3283) {
                                        phi_5805_ = _e3278;
                                    } else {
                                        phi_5805_ = _e3283;
                                    }
                                    let _e3316 = phi_5805_;
                                    if (_e3288 < _e3293) {
                                        phi_5810_ = _e3288;
                                    } else {
                                        phi_5810_ = _e3293;
                                    }
                                    let _e3319 = phi_5810_;
                                    if (_e3316 < _e3319) {
                                        phi_5815_ = _e3316;
                                    } else {
                                        phi_5815_ = _e3319;
                                    }
                                    let _e3322 = phi_5815_;
                                    if (_e3298 < _e3303) {
                                        phi_5820_ = _e3298;
                                    } else {
                                        phi_5820_ = _e3303;
                                    }
                                    let _e3325 = phi_5820_;
                                    if (_e3308 < _e3313) {
                                        phi_5825_ = _e3308;
                                    } else {
                                        phi_5825_ = _e3313;
                                    }
                                    let _e3328 = phi_5825_;
                                    if (_e3325 < _e3328) {
                                        phi_5830_ = _e3325;
                                    } else {
                                        phi_5830_ = _e3328;
                                    }
                                    let _e3331 = phi_5830_;
                                    if (_e3322 < _e3331) {
                                        phi_5835_ = _e3322;
                                    } else {
                                        phi_5835_ = _e3331;
                                    }
                                    let _e3334 = phi_5835_;
                                    if (_e3278 > _e3283) {
                                        phi_5840_ = _e3278;
                                    } else {
                                        phi_5840_ = _e3283;
                                    }
                                    let _e3337 = phi_5840_;
                                    if (_e3288 > _e3293) {
                                        phi_5845_ = _e3288;
                                    } else {
                                        phi_5845_ = _e3293;
                                    }
                                    let _e3340 = phi_5845_;
                                    if (_e3337 > _e3340) {
                                        phi_5850_ = _e3337;
                                    } else {
                                        phi_5850_ = _e3340;
                                    }
                                    let _e3343 = phi_5850_;
                                    if (_e3298 > _e3303) {
                                        phi_5855_ = _e3298;
                                    } else {
                                        phi_5855_ = _e3303;
                                    }
                                    let _e3346 = phi_5855_;
                                    if (_e3308 > _e3313) {
                                        phi_5860_ = _e3308;
                                    } else {
                                        phi_5860_ = _e3313;
                                    }
                                    let _e3349 = phi_5860_;
                                    if (_e3346 > _e3349) {
                                        phi_5865_ = _e3346;
                                    } else {
                                        phi_5865_ = _e3349;
                                    }
                                    let _e3352 = phi_5865_;
                                    if (_e3343 > _e3352) {
                                        phi_5870_ = _e3343;
                                    } else {
                                        phi_5870_ = _e3352;
                                    }
                                    let _e3355 = phi_5870_;
                                    if (_e3267 < 0f) {
                                        phi_5876_ = -(_e3267);
                                    } else {
                                        phi_5876_ = _e3267;
                                    }
                                    let _e3359 = phi_5876_;
                                    if (_e3270 < 0f) {
                                        phi_5882_ = -(_e3270);
                                    } else {
                                        phi_5882_ = _e3270;
                                    }
                                    let _e3363 = phi_5882_;
                                    if (_e3273 < 0f) {
                                        phi_5889_ = -(_e3273);
                                    } else {
                                        phi_5889_ = _e3273;
                                    }
                                    let _e3368 = phi_5889_;
                                    let _e3369 = ((_e3359 + _e3363) + _e3368);
                                    let _e3374 = -(_e3355);
                                    if (_e3334 > _e3374) {
                                        phi_5900_ = _e3334;
                                    } else {
                                        phi_5900_ = _e3374;
                                    }
                                    let _e3377 = phi_5900_;
                                    let _e3382 = (((_e3377 - ((_e3369 * _e3257) * (0.000000059604645f * (17f / 2f)))) - (_e3369 * _e3264)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3385 = ((_e3035 * _e3029) - (_e3038 * _e3028));
                                    let _e3388 = ((_e3038 * _e3027) - (_e3032 * _e3029));
                                    let _e3391 = ((_e3032 * _e3028) - (_e3035 * _e3027));
                                    let _e3396 = (((_e3385 * _e3041[0]) + (_e3388 * _e3041[1])) + (_e3391 * _e3041[2]));
                                    let _e3401 = (((_e3385 * _e3057) + (_e3388 * _e3058)) + (_e3391 * _e3059));
                                    let _e3406 = (((_e3385 * _e3063) + (_e3388 * _e3064)) + (_e3391 * _e3065));
                                    let _e3411 = (((_e3385 * _e3060) + (_e3388 * _e3061)) + (_e3391 * _e3062));
                                    let _e3416 = (((_e3385 * _e3068[0]) + (_e3388 * _e3068[1])) + (_e3391 * _e3068[2]));
                                    let _e3421 = (((_e3385 * _e3084) + (_e3388 * _e3085)) + (_e3391 * _e3086));
                                    let _e3426 = (((_e3385 * _e3090) + (_e3388 * _e3091)) + (_e3391 * _e3092));
                                    let _e3431 = (((_e3385 * _e3087) + (_e3388 * _e3088)) + (_e3391 * _e3089));
                                    if (_e3396 < _e3401) {
                                        phi_5971_ = _e3396;
                                    } else {
                                        phi_5971_ = _e3401;
                                    }
                                    let _e3434 = phi_5971_;
                                    if (_e3406 < _e3411) {
                                        phi_5976_ = _e3406;
                                    } else {
                                        phi_5976_ = _e3411;
                                    }
                                    let _e3437 = phi_5976_;
                                    if (_e3434 < _e3437) {
                                        phi_5981_ = _e3434;
                                    } else {
                                        phi_5981_ = _e3437;
                                    }
                                    let _e3440 = phi_5981_;
                                    if (_e3416 < _e3421) {
                                        phi_5986_ = _e3416;
                                    } else {
                                        phi_5986_ = _e3421;
                                    }
                                    let _e3443 = phi_5986_;
                                    if (_e3426 < _e3431) {
                                        phi_5991_ = _e3426;
                                    } else {
                                        phi_5991_ = _e3431;
                                    }
                                    let _e3446 = phi_5991_;
                                    if (_e3443 < _e3446) {
                                        phi_5996_ = _e3443;
                                    } else {
                                        phi_5996_ = _e3446;
                                    }
                                    let _e3449 = phi_5996_;
                                    if (_e3440 < _e3449) {
                                        phi_6001_ = _e3440;
                                    } else {
                                        phi_6001_ = _e3449;
                                    }
                                    let _e3452 = phi_6001_;
                                    if (_e3396 > _e3401) {
                                        phi_6006_ = _e3396;
                                    } else {
                                        phi_6006_ = _e3401;
                                    }
                                    let _e3455 = phi_6006_;
                                    if (_e3406 > _e3411) {
                                        phi_6011_ = _e3406;
                                    } else {
                                        phi_6011_ = _e3411;
                                    }
                                    let _e3458 = phi_6011_;
                                    if (_e3455 > _e3458) {
                                        phi_6016_ = _e3455;
                                    } else {
                                        phi_6016_ = _e3458;
                                    }
                                    let _e3461 = phi_6016_;
                                    if (_e3416 > _e3421) {
                                        phi_6021_ = _e3416;
                                    } else {
                                        phi_6021_ = _e3421;
                                    }
                                    let _e3464 = phi_6021_;
                                    if (_e3426 > _e3431) {
                                        phi_6026_ = _e3426;
                                    } else {
                                        phi_6026_ = _e3431;
                                    }
                                    let _e3467 = phi_6026_;
                                    if (_e3464 > _e3467) {
                                        phi_6031_ = _e3464;
                                    } else {
                                        phi_6031_ = _e3467;
                                    }
                                    let _e3470 = phi_6031_;
                                    if (_e3461 > _e3470) {
                                        phi_6036_ = _e3461;
                                    } else {
                                        phi_6036_ = _e3470;
                                    }
                                    let _e3473 = phi_6036_;
                                    if (_e3385 < 0f) {
                                        phi_6042_ = -(_e3385);
                                    } else {
                                        phi_6042_ = _e3385;
                                    }
                                    let _e3477 = phi_6042_;
                                    if (_e3388 < 0f) {
                                        phi_6048_ = -(_e3388);
                                    } else {
                                        phi_6048_ = _e3388;
                                    }
                                    let _e3481 = phi_6048_;
                                    if (_e3391 < 0f) {
                                        phi_6055_ = -(_e3391);
                                    } else {
                                        phi_6055_ = _e3391;
                                    }
                                    let _e3486 = phi_6055_;
                                    let _e3487 = ((_e3477 + _e3481) + _e3486);
                                    let _e3492 = -(_e3473);
                                    if (_e3452 > _e3492) {
                                        phi_6066_ = _e3452;
                                    } else {
                                        phi_6066_ = _e3492;
                                    }
                                    let _e3495 = phi_6066_;
                                    let _e3500 = (((_e3495 - ((_e3487 * _e3257) * (0.000000059604645f * (17f / 2f)))) - (_e3487 * _e3264)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3382 > _e3500) {
                                        phi_6076_ = _e3382;
                                    } else {
                                        phi_6076_ = _e3500;
                                    }
                                    let _e3503 = phi_6076_;
                                    phi_6258_ = (_e2999 || (_e3503 > 0f));
                                }
                                let _e3507 = phi_6258_;
                                if _e3507 {
                                    let _e3510 = local_1.member_1[0u];
                                    let _e3516 = local_1.member_2[0u];
                                    let _e3522 = ((_e3510[1] * _e3516[2]) - (_e3510[2] * _e3516[1]));
                                    let _e3525 = ((_e3510[2] * _e3516[0]) - (_e3510[0] * _e3516[2]));
                                    let _e3528 = ((_e3510[0] * _e3516[1]) - (_e3510[1] * _e3516[0]));
                                    let _e3531 = local_1.member_1[1u];
                                    let _e3537 = local_1.member_2[1u];
                                    let _e3543 = ((_e3531[1] * _e3537[2]) - (_e3531[2] * _e3537[1]));
                                    let _e3546 = ((_e3531[2] * _e3537[0]) - (_e3531[0] * _e3537[2]));
                                    let _e3549 = ((_e3531[0] * _e3537[1]) - (_e3531[1] * _e3537[0]));
                                    let _e3552 = local_1.member_1[0u];
                                    let _e3558 = local_1.member_2[1u];
                                    let _e3573 = local_1.member_1[1u];
                                    let _e3579 = local_1.member_2[0u];
                                    let _e3592 = (((_e3552[1] * _e3558[2]) - (_e3552[2] * _e3558[1])) + ((_e3573[1] * _e3579[2]) - (_e3573[2] * _e3579[1])));
                                    let _e3593 = (((_e3552[2] * _e3558[0]) - (_e3552[0] * _e3558[2])) + ((_e3573[2] * _e3579[0]) - (_e3573[0] * _e3579[2])));
                                    let _e3594 = (((_e3552[0] * _e3558[1]) - (_e3552[1] * _e3558[0])) + ((_e3573[0] * _e3579[1]) - (_e3573[1] * _e3579[0])));
                                    let _e3597 = local_1.member[0u];
                                    let _e3608 = local_1.member[1u];
                                    let _e3619 = local_1.member[0u];
                                    let _e3628 = ((((_e3608[0] * _e3522) + (_e3608[1] * _e3525)) + (_e3608[2] * _e3528)) + (((_e3619[0] * _e3592) + (_e3619[1] * _e3593)) + (_e3619[2] * _e3594)));
                                    let _e3631 = local_1.member[0u];
                                    let _e3642 = local_1.member[1u];
                                    let _e3651 = ((((_e3631[0] * _e3543) + (_e3631[1] * _e3546)) + (_e3631[2] * _e3549)) + (((_e3642[0] * _e3592) + (_e3642[1] * _e3593)) + (_e3642[2] * _e3594)));
                                    let _e3654 = local_1.member[1u];
                                    let _e3665 = local_1.member[0u];
                                    if (_e3665[0] < 0f) {
                                        phi_6503_ = -(_e3665[0]);
                                    } else {
                                        phi_6503_ = _e3665[0];
                                    }
                                    let _e3672 = phi_6503_;
                                    if (_e3665[1] < 0f) {
                                        phi_6510_ = -(_e3665[1]);
                                    } else {
                                        phi_6510_ = _e3665[1];
                                    }
                                    let _e3676 = phi_6510_;
                                    if (_e3672 > _e3676) {
                                        phi_6515_ = _e3672;
                                    } else {
                                        phi_6515_ = _e3676;
                                    }
                                    let _e3679 = phi_6515_;
                                    if (_e3665[2] < 0f) {
                                        phi_6522_ = -(_e3665[2]);
                                    } else {
                                        phi_6522_ = _e3665[2];
                                    }
                                    let _e3683 = phi_6522_;
                                    if (_e3679 > _e3683) {
                                        phi_6527_ = _e3679;
                                    } else {
                                        phi_6527_ = _e3683;
                                    }
                                    let _e3686 = phi_6527_;
                                    let _e3689 = local_1.member[1u];
                                    if (_e3689[0] < 0f) {
                                        phi_6540_ = -(_e3689[0]);
                                    } else {
                                        phi_6540_ = _e3689[0];
                                    }
                                    let _e3696 = phi_6540_;
                                    if (_e3689[1] < 0f) {
                                        phi_6547_ = -(_e3689[1]);
                                    } else {
                                        phi_6547_ = _e3689[1];
                                    }
                                    let _e3700 = phi_6547_;
                                    if (_e3696 > _e3700) {
                                        phi_6552_ = _e3696;
                                    } else {
                                        phi_6552_ = _e3700;
                                    }
                                    let _e3703 = phi_6552_;
                                    if (_e3689[2] < 0f) {
                                        phi_6559_ = -(_e3689[2]);
                                    } else {
                                        phi_6559_ = _e3689[2];
                                    }
                                    let _e3707 = phi_6559_;
                                    if (_e3703 > _e3707) {
                                        phi_6564_ = _e3703;
                                    } else {
                                        phi_6564_ = _e3707;
                                    }
                                    let _e3710 = phi_6564_;
                                    if (_e3686 > _e3710) {
                                        phi_6569_ = _e3686;
                                    } else {
                                        phi_6569_ = _e3710;
                                    }
                                    let _e3713 = phi_6569_;
                                    let _e3715 = local_1.member_3;
                                    let _e3716 = (_e3713 + _e3715);
                                    let _e3719 = local_1.member_1[0u];
                                    if (_e3719[0] < 0f) {
                                        phi_6586_ = -(_e3719[0]);
                                    } else {
                                        phi_6586_ = _e3719[0];
                                    }
                                    let _e3726 = phi_6586_;
                                    if (_e3719[1] < 0f) {
                                        phi_6593_ = -(_e3719[1]);
                                    } else {
                                        phi_6593_ = _e3719[1];
                                    }
                                    let _e3730 = phi_6593_;
                                    if (_e3726 > _e3730) {
                                        phi_6598_ = _e3726;
                                    } else {
                                        phi_6598_ = _e3730;
                                    }
                                    let _e3733 = phi_6598_;
                                    if (_e3719[2] < 0f) {
                                        phi_6605_ = -(_e3719[2]);
                                    } else {
                                        phi_6605_ = _e3719[2];
                                    }
                                    let _e3737 = phi_6605_;
                                    if (_e3733 > _e3737) {
                                        phi_6610_ = _e3733;
                                    } else {
                                        phi_6610_ = _e3737;
                                    }
                                    let _e3740 = phi_6610_;
                                    let _e3743 = local_1.member_1[1u];
                                    if (_e3743[0] < 0f) {
                                        phi_6624_ = -(_e3743[0]);
                                    } else {
                                        phi_6624_ = _e3743[0];
                                    }
                                    let _e3750 = phi_6624_;
                                    if (_e3743[1] < 0f) {
                                        phi_6631_ = -(_e3743[1]);
                                    } else {
                                        phi_6631_ = _e3743[1];
                                    }
                                    let _e3754 = phi_6631_;
                                    if (_e3750 > _e3754) {
                                        phi_6636_ = _e3750;
                                    } else {
                                        phi_6636_ = _e3754;
                                    }
                                    let _e3757 = phi_6636_;
                                    if (_e3743[2] < 0f) {
                                        phi_6643_ = -(_e3743[2]);
                                    } else {
                                        phi_6643_ = _e3743[2];
                                    }
                                    let _e3761 = phi_6643_;
                                    if (_e3757 > _e3761) {
                                        phi_6648_ = _e3757;
                                    } else {
                                        phi_6648_ = _e3761;
                                    }
                                    let _e3764 = phi_6648_;
                                    if (_e3740 > _e3764) {
                                        phi_6653_ = _e3740;
                                    } else {
                                        phi_6653_ = _e3764;
                                    }
                                    let _e3767 = phi_6653_;
                                    let _e3769 = local_1.member_3;
                                    let _e3770 = (_e3767 + _e3769);
                                    let _e3773 = local_1.member_2[0u];
                                    if (_e3773[0] < 0f) {
                                        phi_6670_ = -(_e3773[0]);
                                    } else {
                                        phi_6670_ = _e3773[0];
                                    }
                                    let _e3780 = phi_6670_;
                                    if (_e3773[1] < 0f) {
                                        phi_6677_ = -(_e3773[1]);
                                    } else {
                                        phi_6677_ = _e3773[1];
                                    }
                                    let _e3784 = phi_6677_;
                                    if (_e3780 > _e3784) {
                                        phi_6682_ = _e3780;
                                    } else {
                                        phi_6682_ = _e3784;
                                    }
                                    let _e3787 = phi_6682_;
                                    if (_e3773[2] < 0f) {
                                        phi_6689_ = -(_e3773[2]);
                                    } else {
                                        phi_6689_ = _e3773[2];
                                    }
                                    let _e3791 = phi_6689_;
                                    if (_e3787 > _e3791) {
                                        phi_6694_ = _e3787;
                                    } else {
                                        phi_6694_ = _e3791;
                                    }
                                    let _e3794 = phi_6694_;
                                    let _e3797 = local_1.member_2[1u];
                                    if (_e3797[0] < 0f) {
                                        phi_6708_ = -(_e3797[0]);
                                    } else {
                                        phi_6708_ = _e3797[0];
                                    }
                                    let _e3804 = phi_6708_;
                                    if (_e3797[1] < 0f) {
                                        phi_6715_ = -(_e3797[1]);
                                    } else {
                                        phi_6715_ = _e3797[1];
                                    }
                                    let _e3808 = phi_6715_;
                                    if (_e3804 > _e3808) {
                                        phi_6720_ = _e3804;
                                    } else {
                                        phi_6720_ = _e3808;
                                    }
                                    let _e3811 = phi_6720_;
                                    if (_e3797[2] < 0f) {
                                        phi_6727_ = -(_e3797[2]);
                                    } else {
                                        phi_6727_ = _e3797[2];
                                    }
                                    let _e3815 = phi_6727_;
                                    if (_e3811 > _e3815) {
                                        phi_6732_ = _e3811;
                                    } else {
                                        phi_6732_ = _e3815;
                                    }
                                    let _e3818 = phi_6732_;
                                    if (_e3794 > _e3818) {
                                        phi_6737_ = _e3794;
                                    } else {
                                        phi_6737_ = _e3818;
                                    }
                                    let _e3821 = phi_6737_;
                                    let _e3823 = local_1.member_3;
                                    let _e3824 = (_e3821 + _e3823);
                                    let _e3826 = ((_e3770 * 8f) * _e3824);
                                    let _e3833 = local_1.member_3;
                                    if (_e3522 < 0f) {
                                        phi_6768_ = -(_e3522);
                                    } else {
                                        phi_6768_ = _e3522;
                                    }
                                    let _e3850 = phi_6768_;
                                    if (_e3525 < 0f) {
                                        phi_6774_ = -(_e3525);
                                    } else {
                                        phi_6774_ = _e3525;
                                    }
                                    let _e3854 = phi_6774_;
                                    if (_e3528 < 0f) {
                                        phi_6781_ = -(_e3528);
                                    } else {
                                        phi_6781_ = _e3528;
                                    }
                                    let _e3859 = phi_6781_;
                                    let _e3860 = ((_e3850 + _e3854) + _e3859);
                                    if (_e3543 < 0f) {
                                        phi_6788_ = -(_e3543);
                                    } else {
                                        phi_6788_ = _e3543;
                                    }
                                    let _e3864 = phi_6788_;
                                    if (_e3546 < 0f) {
                                        phi_6794_ = -(_e3546);
                                    } else {
                                        phi_6794_ = _e3546;
                                    }
                                    let _e3868 = phi_6794_;
                                    if (_e3549 < 0f) {
                                        phi_6801_ = -(_e3549);
                                    } else {
                                        phi_6801_ = _e3549;
                                    }
                                    let _e3873 = phi_6801_;
                                    let _e3874 = ((_e3864 + _e3868) + _e3873);
                                    if (_e3860 > _e3874) {
                                        phi_6807_ = _e3860;
                                    } else {
                                        phi_6807_ = _e3874;
                                    }
                                    let _e3877 = phi_6807_;
                                    if (_e3592 < 0f) {
                                        phi_6813_ = -(_e3592);
                                    } else {
                                        phi_6813_ = _e3592;
                                    }
                                    let _e3881 = phi_6813_;
                                    if (_e3593 < 0f) {
                                        phi_6819_ = -(_e3593);
                                    } else {
                                        phi_6819_ = _e3593;
                                    }
                                    let _e3885 = phi_6819_;
                                    if (_e3594 < 0f) {
                                        phi_6826_ = -(_e3594);
                                    } else {
                                        phi_6826_ = _e3594;
                                    }
                                    let _e3890 = phi_6826_;
                                    let _e3892 = (((_e3881 + _e3885) + _e3890) * 0.5f);
                                    if (_e3877 > _e3892) {
                                        phi_6833_ = _e3877;
                                    } else {
                                        phi_6833_ = _e3892;
                                    }
                                    let _e3895 = phi_6833_;
                                    let _e3900 = local_1.member_3;
                                    let _e3913 = ((((_e3597[0] * _e3522) + (_e3597[1] * _e3525)) + (_e3597[2] * _e3528)) * 3f);
                                    let _e3914 = ((((_e3654[0] * _e3543) + (_e3654[1] * _e3546)) + (_e3654[2] * _e3549)) * 3f);
                                    if (_e3913 < _e3914) {
                                        phi_6857_ = _e3913;
                                    } else {
                                        phi_6857_ = _e3914;
                                    }
                                    let _e3917 = phi_6857_;
                                    if (_e3628 < _e3651) {
                                        phi_6862_ = _e3628;
                                    } else {
                                        phi_6862_ = _e3651;
                                    }
                                    let _e3920 = phi_6862_;
                                    if (_e3917 < _e3920) {
                                        phi_6867_ = _e3917;
                                    } else {
                                        phi_6867_ = _e3920;
                                    }
                                    let _e3923 = phi_6867_;
                                    if (_e3913 > _e3914) {
                                        phi_6872_ = _e3913;
                                    } else {
                                        phi_6872_ = _e3914;
                                    }
                                    let _e3926 = phi_6872_;
                                    if (_e3628 > _e3651) {
                                        phi_6877_ = _e3628;
                                    } else {
                                        phi_6877_ = _e3651;
                                    }
                                    let _e3929 = phi_6877_;
                                    if (_e3926 > _e3929) {
                                        phi_6882_ = _e3926;
                                    } else {
                                        phi_6882_ = _e3929;
                                    }
                                    let _e3932 = phi_6882_;
                                    let _e3937 = -(_e3932);
                                    if (_e3923 > _e3937) {
                                        phi_6892_ = _e3923;
                                    } else {
                                        phi_6892_ = _e3937;
                                    }
                                    let _e3940 = phi_6892_;
                                    let _e3942 = ((_e3940 - ((((((_e3716 * 8f) * _e3826) * (0.000000059604645f * (524f / 64f))) + ((_e3833 * 19f) * ((_e3716 * (_e3770 + _e3824)) + (_e3770 * _e3824)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3716) * ((1f + _e3770) * (1f + _e3824))))) + ((_e1454 * (((_e3895 + (_e3826 * (0.000000059604645f * 8f))) + ((_e3900 * 6f) * (_e3770 + _e3824))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3770) * (1f + _e3824))))) * (3f * 1.0001f)))) > 0f);
                                    if _e3942 {
                                        phi_7861_ = _e3942;
                                    } else {
                                        let _e3945 = local_1.member_1[0u];
                                        let _e3951 = local_1.member_1[1u];
                                        let _e3955 = (_e3945[0] + _e3951[0]);
                                        let _e3956 = (_e3945[1] + _e3951[1]);
                                        let _e3957 = (_e3945[2] + _e3951[2]);
                                        let _e3960 = local_1.member_2[0u];
                                        let _e3966 = local_1.member_2[1u];
                                        let _e3970 = (_e3960[0] + _e3966[0]);
                                        let _e3971 = (_e3960[1] + _e3966[1]);
                                        let _e3972 = (_e3960[2] + _e3966[2]);
                                        let _e3975 = ((_e3956 * _e3972) - (_e3957 * _e3971));
                                        let _e3978 = ((_e3957 * _e3970) - (_e3955 * _e3972));
                                        let _e3981 = ((_e3955 * _e3971) - (_e3956 * _e3970));
                                        let _e3984 = local_1.member[0u];
                                        let _e3990 = local_1.member_1[0u];
                                        let _e3996 = local_1.member_2[0u];
                                        let _e4000 = (_e3984[0] - _e3990[0]);
                                        let _e4001 = (_e3984[1] - _e3990[1]);
                                        let _e4002 = (_e3984[2] - _e3990[2]);
                                        let _e4003 = (_e4000 - _e3996[0]);
                                        let _e4004 = (_e4001 - _e3996[1]);
                                        let _e4005 = (_e4002 - _e3996[2]);
                                        let _e4006 = (_e3984[0] - _e3996[0]);
                                        let _e4007 = (_e3984[1] - _e3996[1]);
                                        let _e4008 = (_e3984[2] - _e3996[2]);
                                        let _e4011 = local_1.member[1u];
                                        let _e4017 = local_1.member_1[1u];
                                        let _e4023 = local_1.member_2[1u];
                                        let _e4027 = (_e4011[0] - _e4017[0]);
                                        let _e4028 = (_e4011[1] - _e4017[1]);
                                        let _e4029 = (_e4011[2] - _e4017[2]);
                                        let _e4030 = (_e4027 - _e4023[0]);
                                        let _e4031 = (_e4028 - _e4023[1]);
                                        let _e4032 = (_e4029 - _e4023[2]);
                                        let _e4033 = (_e4011[0] - _e4023[0]);
                                        let _e4034 = (_e4011[1] - _e4023[1]);
                                        let _e4035 = (_e4011[2] - _e4023[2]);
                                        let _e4038 = local_1.member[0u];
                                        if (_e4038[0] < 0f) {
                                            phi_7095_ = -(_e4038[0]);
                                        } else {
                                            phi_7095_ = _e4038[0];
                                        }
                                        let _e4045 = phi_7095_;
                                        if (_e4038[1] < 0f) {
                                            phi_7102_ = -(_e4038[1]);
                                        } else {
                                            phi_7102_ = _e4038[1];
                                        }
                                        let _e4049 = phi_7102_;
                                        if (_e4045 > _e4049) {
                                            phi_7107_ = _e4045;
                                        } else {
                                            phi_7107_ = _e4049;
                                        }
                                        let _e4052 = phi_7107_;
                                        if (_e4038[2] < 0f) {
                                            phi_7114_ = -(_e4038[2]);
                                        } else {
                                            phi_7114_ = _e4038[2];
                                        }
                                        let _e4056 = phi_7114_;
                                        if (_e4052 > _e4056) {
                                            phi_7119_ = _e4052;
                                        } else {
                                            phi_7119_ = _e4056;
                                        }
                                        let _e4059 = phi_7119_;
                                        let _e4062 = local_1.member[1u];
                                        if (_e4062[0] < 0f) {
                                            phi_7132_ = -(_e4062[0]);
                                        } else {
                                            phi_7132_ = _e4062[0];
                                        }
                                        let _e4069 = phi_7132_;
                                        if (_e4062[1] < 0f) {
                                            phi_7139_ = -(_e4062[1]);
                                        } else {
                                            phi_7139_ = _e4062[1];
                                        }
                                        let _e4073 = phi_7139_;
                                        if (_e4069 > _e4073) {
                                            phi_7144_ = _e4069;
                                        } else {
                                            phi_7144_ = _e4073;
                                        }
                                        let _e4076 = phi_7144_;
                                        if (_e4062[2] < 0f) {
                                            phi_7151_ = -(_e4062[2]);
                                        } else {
                                            phi_7151_ = _e4062[2];
                                        }
                                        let _e4080 = phi_7151_;
                                        if (_e4076 > _e4080) {
                                            phi_7156_ = _e4076;
                                        } else {
                                            phi_7156_ = _e4080;
                                        }
                                        let _e4083 = phi_7156_;
                                        if (_e4059 > _e4083) {
                                            phi_7161_ = _e4059;
                                        } else {
                                            phi_7161_ = _e4083;
                                        }
                                        let _e4086 = phi_7161_;
                                        let _e4088 = local_1.member_3;
                                        let _e4092 = local_1.member_1[0u];
                                        if (_e4092[0] < 0f) {
                                            phi_7178_ = -(_e4092[0]);
                                        } else {
                                            phi_7178_ = _e4092[0];
                                        }
                                        let _e4099 = phi_7178_;
                                        if (_e4092[1] < 0f) {
                                            phi_7185_ = -(_e4092[1]);
                                        } else {
                                            phi_7185_ = _e4092[1];
                                        }
                                        let _e4103 = phi_7185_;
                                        if (_e4099 > _e4103) {
                                            phi_7190_ = _e4099;
                                        } else {
                                            phi_7190_ = _e4103;
                                        }
                                        let _e4106 = phi_7190_;
                                        if (_e4092[2] < 0f) {
                                            phi_7197_ = -(_e4092[2]);
                                        } else {
                                            phi_7197_ = _e4092[2];
                                        }
                                        let _e4110 = phi_7197_;
                                        if (_e4106 > _e4110) {
                                            phi_7202_ = _e4106;
                                        } else {
                                            phi_7202_ = _e4110;
                                        }
                                        let _e4113 = phi_7202_;
                                        let _e4116 = local_1.member_1[1u];
                                        if (_e4116[0] < 0f) {
                                            phi_7216_ = -(_e4116[0]);
                                        } else {
                                            phi_7216_ = _e4116[0];
                                        }
                                        let _e4123 = phi_7216_;
                                        if (_e4116[1] < 0f) {
                                            phi_7223_ = -(_e4116[1]);
                                        } else {
                                            phi_7223_ = _e4116[1];
                                        }
                                        let _e4127 = phi_7223_;
                                        if (_e4123 > _e4127) {
                                            phi_7228_ = _e4123;
                                        } else {
                                            phi_7228_ = _e4127;
                                        }
                                        let _e4130 = phi_7228_;
                                        if (_e4116[2] < 0f) {
                                            phi_7235_ = -(_e4116[2]);
                                        } else {
                                            phi_7235_ = _e4116[2];
                                        }
                                        let _e4134 = phi_7235_;
                                        if (_e4130 > _e4134) {
                                            phi_7240_ = _e4130;
                                        } else {
                                            phi_7240_ = _e4134;
                                        }
                                        let _e4137 = phi_7240_;
                                        if (_e4113 > _e4137) {
                                            phi_7245_ = _e4113;
                                        } else {
                                            phi_7245_ = _e4137;
                                        }
                                        let _e4140 = phi_7245_;
                                        let _e4142 = local_1.member_3;
                                        let _e4146 = local_1.member_2[0u];
                                        if (_e4146[0] < 0f) {
                                            phi_7262_ = -(_e4146[0]);
                                        } else {
                                            phi_7262_ = _e4146[0];
                                        }
                                        let _e4153 = phi_7262_;
                                        if (_e4146[1] < 0f) {
                                            phi_7269_ = -(_e4146[1]);
                                        } else {
                                            phi_7269_ = _e4146[1];
                                        }
                                        let _e4157 = phi_7269_;
                                        if (_e4153 > _e4157) {
                                            phi_7274_ = _e4153;
                                        } else {
                                            phi_7274_ = _e4157;
                                        }
                                        let _e4160 = phi_7274_;
                                        if (_e4146[2] < 0f) {
                                            phi_7281_ = -(_e4146[2]);
                                        } else {
                                            phi_7281_ = _e4146[2];
                                        }
                                        let _e4164 = phi_7281_;
                                        if (_e4160 > _e4164) {
                                            phi_7286_ = _e4160;
                                        } else {
                                            phi_7286_ = _e4164;
                                        }
                                        let _e4167 = phi_7286_;
                                        let _e4170 = local_1.member_2[1u];
                                        if (_e4170[0] < 0f) {
                                            phi_7300_ = -(_e4170[0]);
                                        } else {
                                            phi_7300_ = _e4170[0];
                                        }
                                        let _e4177 = phi_7300_;
                                        if (_e4170[1] < 0f) {
                                            phi_7307_ = -(_e4170[1]);
                                        } else {
                                            phi_7307_ = _e4170[1];
                                        }
                                        let _e4181 = phi_7307_;
                                        if (_e4177 > _e4181) {
                                            phi_7312_ = _e4177;
                                        } else {
                                            phi_7312_ = _e4181;
                                        }
                                        let _e4184 = phi_7312_;
                                        if (_e4170[2] < 0f) {
                                            phi_7319_ = -(_e4170[2]);
                                        } else {
                                            phi_7319_ = _e4170[2];
                                        }
                                        let _e4188 = phi_7319_;
                                        if (_e4184 > _e4188) {
                                            phi_7324_ = _e4184;
                                        } else {
                                            phi_7324_ = _e4188;
                                        }
                                        let _e4191 = phi_7324_;
                                        if (_e4167 > _e4191) {
                                            phi_7329_ = _e4167;
                                        } else {
                                            phi_7329_ = _e4191;
                                        }
                                        let _e4194 = phi_7329_;
                                        let _e4196 = local_1.member_3;
                                        let _e4200 = ((((_e4086 + _e4088) + (_e4140 + _e4142)) + (_e4194 + _e4196)) * 2f);
                                        let _e4203 = local_1.member_3;
                                        let _e4207 = (((_e1454 * 1.0001f) + (_e4203 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4210 = ((_e3978 * _e3957) - (_e3981 * _e3956));
                                        let _e4213 = ((_e3981 * _e3955) - (_e3975 * _e3957));
                                        let _e4216 = ((_e3975 * _e3956) - (_e3978 * _e3955));
                                        let _e4221 = (((_e4210 * _e3984[0]) + (_e4213 * _e3984[1])) + (_e4216 * _e3984[2]));
                                        let _e4226 = (((_e4210 * _e4000) + (_e4213 * _e4001)) + (_e4216 * _e4002));
                                        let _e4231 = (((_e4210 * _e4006) + (_e4213 * _e4007)) + (_e4216 * _e4008));
                                        let _e4236 = (((_e4210 * _e4003) + (_e4213 * _e4004)) + (_e4216 * _e4005));
                                        let _e4241 = (((_e4210 * _e4011[0]) + (_e4213 * _e4011[1])) + (_e4216 * _e4011[2]));
                                        let _e4246 = (((_e4210 * _e4027) + (_e4213 * _e4028)) + (_e4216 * _e4029));
                                        let _e4251 = (((_e4210 * _e4033) + (_e4213 * _e4034)) + (_e4216 * _e4035));
                                        let _e4256 = (((_e4210 * _e4030) + (_e4213 * _e4031)) + (_e4216 * _e4032));
                                        if (_e4221 < _e4226) {
                                            phi_7408_ = _e4221;
                                        } else {
                                            phi_7408_ = _e4226;
                                        }
                                        let _e4259 = phi_7408_;
                                        if (_e4231 < _e4236) {
                                            phi_7413_ = _e4231;
                                        } else {
                                            phi_7413_ = _e4236;
                                        }
                                        let _e4262 = phi_7413_;
                                        if (_e4259 < _e4262) {
                                            phi_7418_ = _e4259;
                                        } else {
                                            phi_7418_ = _e4262;
                                        }
                                        let _e4265 = phi_7418_;
                                        if (_e4241 < _e4246) {
                                            phi_7423_ = _e4241;
                                        } else {
                                            phi_7423_ = _e4246;
                                        }
                                        let _e4268 = phi_7423_;
                                        if (_e4251 < _e4256) {
                                            phi_7428_ = _e4251;
                                        } else {
                                            phi_7428_ = _e4256;
                                        }
                                        let _e4271 = phi_7428_;
                                        if (_e4268 < _e4271) {
                                            phi_7433_ = _e4268;
                                        } else {
                                            phi_7433_ = _e4271;
                                        }
                                        let _e4274 = phi_7433_;
                                        if (_e4265 < _e4274) {
                                            phi_7438_ = _e4265;
                                        } else {
                                            phi_7438_ = _e4274;
                                        }
                                        let _e4277 = phi_7438_;
                                        if (_e4221 > _e4226) {
                                            phi_7443_ = _e4221;
                                        } else {
                                            phi_7443_ = _e4226;
                                        }
                                        let _e4280 = phi_7443_;
                                        if (_e4231 > _e4236) {
                                            phi_7448_ = _e4231;
                                        } else {
                                            phi_7448_ = _e4236;
                                        }
                                        let _e4283 = phi_7448_;
                                        if (_e4280 > _e4283) {
                                            phi_7453_ = _e4280;
                                        } else {
                                            phi_7453_ = _e4283;
                                        }
                                        let _e4286 = phi_7453_;
                                        if (_e4241 > _e4246) {
                                            phi_7458_ = _e4241;
                                        } else {
                                            phi_7458_ = _e4246;
                                        }
                                        let _e4289 = phi_7458_;
                                        if (_e4251 > _e4256) {
                                            phi_7463_ = _e4251;
                                        } else {
                                            phi_7463_ = _e4256;
                                        }
                                        let _e4292 = phi_7463_;
                                        if (_e4289 > _e4292) {
                                            phi_7468_ = _e4289;
                                        } else {
                                            phi_7468_ = _e4292;
                                        }
                                        let _e4295 = phi_7468_;
                                        if (_e4286 > _e4295) {
                                            phi_7473_ = _e4286;
                                        } else {
                                            phi_7473_ = _e4295;
                                        }
                                        let _e4298 = phi_7473_;
                                        if (_e4210 < 0f) {
                                            phi_7479_ = -(_e4210);
                                        } else {
                                            phi_7479_ = _e4210;
                                        }
                                        let _e4302 = phi_7479_;
                                        if (_e4213 < 0f) {
                                            phi_7485_ = -(_e4213);
                                        } else {
                                            phi_7485_ = _e4213;
                                        }
                                        let _e4306 = phi_7485_;
                                        if (_e4216 < 0f) {
                                            phi_7492_ = -(_e4216);
                                        } else {
                                            phi_7492_ = _e4216;
                                        }
                                        let _e4311 = phi_7492_;
                                        let _e4312 = ((_e4302 + _e4306) + _e4311);
                                        let _e4317 = -(_e4298);
                                        if (_e4277 > _e4317) {
                                            phi_7503_ = _e4277;
                                        } else {
                                            phi_7503_ = _e4317;
                                        }
                                        let _e4320 = phi_7503_;
                                        let _e4325 = (((_e4320 - ((_e4312 * _e4200) * (0.000000059604645f * (17f / 2f)))) - (_e4312 * _e4207)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4328 = ((_e3978 * _e3972) - (_e3981 * _e3971));
                                        let _e4331 = ((_e3981 * _e3970) - (_e3975 * _e3972));
                                        let _e4334 = ((_e3975 * _e3971) - (_e3978 * _e3970));
                                        let _e4339 = (((_e4328 * _e3984[0]) + (_e4331 * _e3984[1])) + (_e4334 * _e3984[2]));
                                        let _e4344 = (((_e4328 * _e4000) + (_e4331 * _e4001)) + (_e4334 * _e4002));
                                        let _e4349 = (((_e4328 * _e4006) + (_e4331 * _e4007)) + (_e4334 * _e4008));
                                        let _e4354 = (((_e4328 * _e4003) + (_e4331 * _e4004)) + (_e4334 * _e4005));
                                        let _e4359 = (((_e4328 * _e4011[0]) + (_e4331 * _e4011[1])) + (_e4334 * _e4011[2]));
                                        let _e4364 = (((_e4328 * _e4027) + (_e4331 * _e4028)) + (_e4334 * _e4029));
                                        let _e4369 = (((_e4328 * _e4033) + (_e4331 * _e4034)) + (_e4334 * _e4035));
                                        let _e4374 = (((_e4328 * _e4030) + (_e4331 * _e4031)) + (_e4334 * _e4032));
                                        if (_e4339 < _e4344) {
                                            phi_7574_ = _e4339;
                                        } else {
                                            phi_7574_ = _e4344;
                                        }
                                        let _e4377 = phi_7574_;
                                        if (_e4349 < _e4354) {
                                            phi_7579_ = _e4349;
                                        } else {
                                            phi_7579_ = _e4354;
                                        }
                                        let _e4380 = phi_7579_;
                                        if (_e4377 < _e4380) {
                                            phi_7584_ = _e4377;
                                        } else {
                                            phi_7584_ = _e4380;
                                        }
                                        let _e4383 = phi_7584_;
                                        if (_e4359 < _e4364) {
                                            phi_7589_ = _e4359;
                                        } else {
                                            phi_7589_ = _e4364;
                                        }
                                        let _e4386 = phi_7589_;
                                        if (_e4369 < _e4374) {
                                            phi_7594_ = _e4369;
                                        } else {
                                            phi_7594_ = _e4374;
                                        }
                                        let _e4389 = phi_7594_;
                                        if (_e4386 < _e4389) {
                                            phi_7599_ = _e4386;
                                        } else {
                                            phi_7599_ = _e4389;
                                        }
                                        let _e4392 = phi_7599_;
                                        if (_e4383 < _e4392) {
                                            phi_7604_ = _e4383;
                                        } else {
                                            phi_7604_ = _e4392;
                                        }
                                        let _e4395 = phi_7604_;
                                        if (_e4339 > _e4344) {
                                            phi_7609_ = _e4339;
                                        } else {
                                            phi_7609_ = _e4344;
                                        }
                                        let _e4398 = phi_7609_;
                                        if (_e4349 > _e4354) {
                                            phi_7614_ = _e4349;
                                        } else {
                                            phi_7614_ = _e4354;
                                        }
                                        let _e4401 = phi_7614_;
                                        if (_e4398 > _e4401) {
                                            phi_7619_ = _e4398;
                                        } else {
                                            phi_7619_ = _e4401;
                                        }
                                        let _e4404 = phi_7619_;
                                        if (_e4359 > _e4364) {
                                            phi_7624_ = _e4359;
                                        } else {
                                            phi_7624_ = _e4364;
                                        }
                                        let _e4407 = phi_7624_;
                                        if (_e4369 > _e4374) {
                                            phi_7629_ = _e4369;
                                        } else {
                                            phi_7629_ = _e4374;
                                        }
                                        let _e4410 = phi_7629_;
                                        if (_e4407 > _e4410) {
                                            phi_7634_ = _e4407;
                                        } else {
                                            phi_7634_ = _e4410;
                                        }
                                        let _e4413 = phi_7634_;
                                        if (_e4404 > _e4413) {
                                            phi_7639_ = _e4404;
                                        } else {
                                            phi_7639_ = _e4413;
                                        }
                                        let _e4416 = phi_7639_;
                                        if (_e4328 < 0f) {
                                            phi_7645_ = -(_e4328);
                                        } else {
                                            phi_7645_ = _e4328;
                                        }
                                        let _e4420 = phi_7645_;
                                        if (_e4331 < 0f) {
                                            phi_7651_ = -(_e4331);
                                        } else {
                                            phi_7651_ = _e4331;
                                        }
                                        let _e4424 = phi_7651_;
                                        if (_e4334 < 0f) {
                                            phi_7658_ = -(_e4334);
                                        } else {
                                            phi_7658_ = _e4334;
                                        }
                                        let _e4429 = phi_7658_;
                                        let _e4430 = ((_e4420 + _e4424) + _e4429);
                                        let _e4435 = -(_e4416);
                                        if (_e4395 > _e4435) {
                                            phi_7669_ = _e4395;
                                        } else {
                                            phi_7669_ = _e4435;
                                        }
                                        let _e4438 = phi_7669_;
                                        let _e4443 = (((_e4438 - ((_e4430 * _e4200) * (0.000000059604645f * (17f / 2f)))) - (_e4430 * _e4207)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4325 > _e4443) {
                                            phi_7679_ = _e4325;
                                        } else {
                                            phi_7679_ = _e4443;
                                        }
                                        let _e4446 = phi_7679_;
                                        phi_7861_ = (_e3942 || (_e4446 > 0f));
                                    }
                                    let _e4450 = phi_7861_;
                                    phi_7863_ = (_e3507 && _e4450);
                                } else {
                                    phi_7863_ = _e3507;
                                }
                                let _e4453 = phi_7863_;
                                phi_7865_ = (_e2474 || _e4453);
                            }
                            let _e4456 = phi_7865_;
                            if !(_e4456) {
                                let _e4459 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1001] = ((2147483648u | (_e4459 << bitcast<u32>(12i))) | _e1004);
                            }
                        }
                        phi_7876_ = true;
                    }
                    let _e4466 = phi_7876_;
                    phi_7877_ = _e4466;
                } else {
                    phi_7877_ = false;
                }
                let _e4468 = phi_7877_;
                continue;
                continuing {
                    phi_1849_ = _e993;
                    break if !(_e4468);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4472 = atomicLoad((&counters[5u]));
                if (_e4472 > 0u) {
                    let _e4475 = atomicAdd((&output.member[0u]), _e4472);
                    if ((_e4475 + _e4472) < _e4475) {
                        let _e4479 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4475);
                }
            }
            workgroupBarrier();
            let _e4482 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4485 = atomicLoad((&counters[7u]));
                if (_e4485 > 0u) {
                    let _e4488 = atomicAdd((&output.member[1u]), _e4485);
                    if ((_e4488 + _e4485) < _e4488) {
                        let _e4492 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7927_ = type_9(0u, 16u);
            loop {
                let _e4494 = phi_7927_;
                if (_e4494.member < _e4494.member_1) {
                    phi_7928_ = type_9((_e4494.member + 1u), _e4494.member_1);
                    phi_7951_ = type_9(1u, _e4494.member);
                } else {
                    phi_7928_ = _e4494;
                    phi_7951_ = type_9(0u, type_9().member_1);
                }
                let _e4506 = phi_7928_;
                let _e4508 = phi_7951_;
                if (bitcast<i32>(_e4508.member) != 0i) {
                    let _e4514 = (_e67 + (_e4508.member_1 * 128u));
                    if (_e4514 >= _e979) {
                        phi_8048_ = false;
                    } else {
                        let _e4517 = hits[_e4514];
                        if ((_e4517 & 2147483648u) == 0u) {
                            phi_7974_ = 4294967295u;
                        } else {
                            phi_7974_ = ((_e4517 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4524 = phi_7974_;
                        if (_e4524 != 4294967295u) {
                            let _e4528 = ((_e4517 >> bitcast<u32>(10i)) & 3u);
                            let _e4535 = firsts[(2u * _e4528)];
                            let _e4538 = leaves.member[(_e4535 + ((_e4517 >> bitcast<u32>(5i)) & 31u))];
                            let _e4542 = firsts[((2u * _e4528) + 1u)];
                            let _e4545 = leaves.member[(_e4542 + (_e4517 & 31u))];
                            let _e4550 = params.member.member_1.member_3;
                            let _e4551 = (_e4482 + _e4524);
                            if (_e4538.member_1 < _e4545.member_1) {
                                phi_8029_ = type_9(_e4538.member_1, _e4545.member_1);
                            } else {
                                phi_8029_ = type_9(_e4545.member_1, _e4538.member_1);
                            }
                            let _e4556 = phi_8029_;
                            if (_e4551 < _e4550) {
                                let _e4560 = (2u * _e4551);
                                atomicStore((&output.member[(4u + _e4560)]), _e4556.member);
                                atomicStore((&output.member[(_e4560 + 5u)]), _e4556.member_1);
                            }
                        }
                        phi_8048_ = true;
                    }
                    let _e4566 = phi_8048_;
                    phi_8049_ = _e4566;
                } else {
                    phi_8049_ = false;
                }
                let _e4568 = phi_8049_;
                continue;
                continuing {
                    phi_7927_ = _e4506;
                    break if !(_e4568);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_435_ = _e153;
            break if !(_e159);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
