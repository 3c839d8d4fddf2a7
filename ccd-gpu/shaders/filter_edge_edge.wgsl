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
    var phi_1086_: bool;
    var phi_1087_: bool;
    var phi_1088_: bool;
    var phi_1089_: bool;
    var phi_1090_: bool;
    var phi_1094_: bool;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1144_: bool;
    var phi_1154_: bool;
    var phi_1155_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1296_: bool;
    var phi_1297_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1485_: bool;
    var phi_1486_: bool;
    var phi_1579_: bool;
    var phi_1580_: bool;
    var phi_1675_: bool;
    var phi_1676_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1774_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1782_: bool;
    var phi_1783_: bool;
    var phi_1784_: bool;
    var phi_1788_: bool;
    var phi_1807_: type_9;
    var phi_1850_: u32;
    var phi_1851_: bool;
    var phi_947_: u32;
    var phi_1852_: bool;
    var phi_1859_: u32;
    var phi_1862_: type_9;
    var phi_1863_: type_9;
    var phi_1886_: type_9;
    var phi_2011_: bool;
    var phi_2012_: bool;
    var phi_2013_: bool;
    var phi_2014_: bool;
    var phi_2015_: bool;
    var phi_2019_: bool;
    var phi_2024_: bool;
    var phi_2025_: bool;
    var phi_2069_: bool;
    var phi_2079_: bool;
    var phi_2080_: bool;
    var phi_2084_: bool;
    var phi_2085_: bool;
    var phi_2221_: bool;
    var phi_2222_: bool;
    var phi_2315_: bool;
    var phi_2316_: bool;
    var phi_2410_: bool;
    var phi_2411_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2600_: bool;
    var phi_2601_: bool;
    var phi_2694_: bool;
    var phi_2695_: bool;
    var phi_2699_: bool;
    var phi_2700_: bool;
    var phi_2701_: bool;
    var phi_2705_: bool;
    var phi_2706_: bool;
    var phi_2707_: bool;
    var phi_2708_: bool;
    var phi_2709_: bool;
    var phi_2713_: bool;
    var phi_2726_: type_23;
    var phi_2727_: type_23;
    var phi_3116_: f32;
    var phi_3123_: f32;
    var phi_3128_: f32;
    var phi_3135_: f32;
    var phi_3140_: f32;
    var phi_3153_: f32;
    var phi_3160_: f32;
    var phi_3165_: f32;
    var phi_3172_: f32;
    var phi_3177_: f32;
    var phi_3182_: f32;
    var phi_3199_: f32;
    var phi_3206_: f32;
    var phi_3211_: f32;
    var phi_3218_: f32;
    var phi_3223_: f32;
    var phi_3237_: f32;
    var phi_3244_: f32;
    var phi_3249_: f32;
    var phi_3256_: f32;
    var phi_3261_: f32;
    var phi_3266_: f32;
    var phi_3283_: f32;
    var phi_3290_: f32;
    var phi_3295_: f32;
    var phi_3302_: f32;
    var phi_3307_: f32;
    var phi_3321_: f32;
    var phi_3328_: f32;
    var phi_3333_: f32;
    var phi_3340_: f32;
    var phi_3345_: f32;
    var phi_3350_: f32;
    var phi_3381_: f32;
    var phi_3387_: f32;
    var phi_3394_: f32;
    var phi_3401_: f32;
    var phi_3407_: f32;
    var phi_3414_: f32;
    var phi_3420_: f32;
    var phi_3426_: f32;
    var phi_3432_: f32;
    var phi_3439_: f32;
    var phi_3446_: f32;
    var phi_3470_: f32;
    var phi_3475_: f32;
    var phi_3480_: f32;
    var phi_3485_: f32;
    var phi_3490_: f32;
    var phi_3495_: f32;
    var phi_3505_: f32;
    var phi_3708_: f32;
    var phi_3715_: f32;
    var phi_3720_: f32;
    var phi_3727_: f32;
    var phi_3732_: f32;
    var phi_3745_: f32;
    var phi_3752_: f32;
    var phi_3757_: f32;
    var phi_3764_: f32;
    var phi_3769_: f32;
    var phi_3774_: f32;
    var phi_3791_: f32;
    var phi_3798_: f32;
    var phi_3803_: f32;
    var phi_3810_: f32;
    var phi_3815_: f32;
    var phi_3829_: f32;
    var phi_3836_: f32;
    var phi_3841_: f32;
    var phi_3848_: f32;
    var phi_3853_: f32;
    var phi_3858_: f32;
    var phi_3875_: f32;
    var phi_3882_: f32;
    var phi_3887_: f32;
    var phi_3894_: f32;
    var phi_3899_: f32;
    var phi_3913_: f32;
    var phi_3920_: f32;
    var phi_3925_: f32;
    var phi_3932_: f32;
    var phi_3937_: f32;
    var phi_3942_: f32;
    var phi_4020_: f32;
    var phi_4025_: f32;
    var phi_4030_: f32;
    var phi_4035_: f32;
    var phi_4040_: f32;
    var phi_4045_: f32;
    var phi_4050_: f32;
    var phi_4055_: f32;
    var phi_4060_: f32;
    var phi_4065_: f32;
    var phi_4070_: f32;
    var phi_4075_: f32;
    var phi_4080_: f32;
    var phi_4085_: f32;
    var phi_4091_: f32;
    var phi_4097_: f32;
    var phi_4104_: f32;
    var phi_4114_: f32;
    var phi_4185_: f32;
    var phi_4190_: f32;
    var phi_4195_: f32;
    var phi_4200_: f32;
    var phi_4205_: f32;
    var phi_4210_: f32;
    var phi_4215_: f32;
    var phi_4220_: f32;
    var phi_4225_: f32;
    var phi_4230_: f32;
    var phi_4235_: f32;
    var phi_4240_: f32;
    var phi_4245_: f32;
    var phi_4250_: f32;
    var phi_4256_: f32;
    var phi_4262_: f32;
    var phi_4269_: f32;
    var phi_4279_: f32;
    var phi_4289_: f32;
    var phi_4469_: bool;
    var phi_4921_: f32;
    var phi_4928_: f32;
    var phi_4933_: f32;
    var phi_4940_: f32;
    var phi_4945_: f32;
    var phi_4958_: f32;
    var phi_4965_: f32;
    var phi_4970_: f32;
    var phi_4977_: f32;
    var phi_4982_: f32;
    var phi_4987_: f32;
    var phi_5004_: f32;
    var phi_5011_: f32;
    var phi_5016_: f32;
    var phi_5023_: f32;
    var phi_5028_: f32;
    var phi_5042_: f32;
    var phi_5049_: f32;
    var phi_5054_: f32;
    var phi_5061_: f32;
    var phi_5066_: f32;
    var phi_5071_: f32;
    var phi_5088_: f32;
    var phi_5095_: f32;
    var phi_5100_: f32;
    var phi_5107_: f32;
    var phi_5112_: f32;
    var phi_5126_: f32;
    var phi_5133_: f32;
    var phi_5138_: f32;
    var phi_5145_: f32;
    var phi_5150_: f32;
    var phi_5155_: f32;
    var phi_5186_: f32;
    var phi_5192_: f32;
    var phi_5199_: f32;
    var phi_5206_: f32;
    var phi_5212_: f32;
    var phi_5219_: f32;
    var phi_5225_: f32;
    var phi_5231_: f32;
    var phi_5237_: f32;
    var phi_5244_: f32;
    var phi_5251_: f32;
    var phi_5275_: f32;
    var phi_5280_: f32;
    var phi_5285_: f32;
    var phi_5290_: f32;
    var phi_5295_: f32;
    var phi_5300_: f32;
    var phi_5310_: f32;
    var phi_5513_: f32;
    var phi_5520_: f32;
    var phi_5525_: f32;
    var phi_5532_: f32;
    var phi_5537_: f32;
    var phi_5550_: f32;
    var phi_5557_: f32;
    var phi_5562_: f32;
    var phi_5569_: f32;
    var phi_5574_: f32;
    var phi_5579_: f32;
    var phi_5596_: f32;
    var phi_5603_: f32;
    var phi_5608_: f32;
    var phi_5615_: f32;
    var phi_5620_: f32;
    var phi_5634_: f32;
    var phi_5641_: f32;
    var phi_5646_: f32;
    var phi_5653_: f32;
    var phi_5658_: f32;
    var phi_5663_: f32;
    var phi_5680_: f32;
    var phi_5687_: f32;
    var phi_5692_: f32;
    var phi_5699_: f32;
    var phi_5704_: f32;
    var phi_5718_: f32;
    var phi_5725_: f32;
    var phi_5730_: f32;
    var phi_5737_: f32;
    var phi_5742_: f32;
    var phi_5747_: f32;
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
    var phi_5875_: f32;
    var phi_5880_: f32;
    var phi_5885_: f32;
    var phi_5890_: f32;
    var phi_5896_: f32;
    var phi_5902_: f32;
    var phi_5909_: f32;
    var phi_5919_: f32;
    var phi_5990_: f32;
    var phi_5995_: f32;
    var phi_6000_: f32;
    var phi_6005_: f32;
    var phi_6010_: f32;
    var phi_6015_: f32;
    var phi_6020_: f32;
    var phi_6025_: f32;
    var phi_6030_: f32;
    var phi_6035_: f32;
    var phi_6040_: f32;
    var phi_6045_: f32;
    var phi_6050_: f32;
    var phi_6055_: f32;
    var phi_6061_: f32;
    var phi_6067_: f32;
    var phi_6074_: f32;
    var phi_6084_: f32;
    var phi_6094_: f32;
    var phi_6274_: bool;
    var phi_6519_: f32;
    var phi_6526_: f32;
    var phi_6531_: f32;
    var phi_6538_: f32;
    var phi_6543_: f32;
    var phi_6556_: f32;
    var phi_6563_: f32;
    var phi_6568_: f32;
    var phi_6575_: f32;
    var phi_6580_: f32;
    var phi_6585_: f32;
    var phi_6602_: f32;
    var phi_6609_: f32;
    var phi_6614_: f32;
    var phi_6621_: f32;
    var phi_6626_: f32;
    var phi_6640_: f32;
    var phi_6647_: f32;
    var phi_6652_: f32;
    var phi_6659_: f32;
    var phi_6664_: f32;
    var phi_6669_: f32;
    var phi_6686_: f32;
    var phi_6693_: f32;
    var phi_6698_: f32;
    var phi_6705_: f32;
    var phi_6710_: f32;
    var phi_6724_: f32;
    var phi_6731_: f32;
    var phi_6736_: f32;
    var phi_6743_: f32;
    var phi_6748_: f32;
    var phi_6753_: f32;
    var phi_6784_: f32;
    var phi_6790_: f32;
    var phi_6797_: f32;
    var phi_6804_: f32;
    var phi_6810_: f32;
    var phi_6817_: f32;
    var phi_6823_: f32;
    var phi_6829_: f32;
    var phi_6835_: f32;
    var phi_6842_: f32;
    var phi_6849_: f32;
    var phi_6873_: f32;
    var phi_6878_: f32;
    var phi_6883_: f32;
    var phi_6888_: f32;
    var phi_6893_: f32;
    var phi_6898_: f32;
    var phi_6908_: f32;
    var phi_7111_: f32;
    var phi_7118_: f32;
    var phi_7123_: f32;
    var phi_7130_: f32;
    var phi_7135_: f32;
    var phi_7148_: f32;
    var phi_7155_: f32;
    var phi_7160_: f32;
    var phi_7167_: f32;
    var phi_7172_: f32;
    var phi_7177_: f32;
    var phi_7194_: f32;
    var phi_7201_: f32;
    var phi_7206_: f32;
    var phi_7213_: f32;
    var phi_7218_: f32;
    var phi_7232_: f32;
    var phi_7239_: f32;
    var phi_7244_: f32;
    var phi_7251_: f32;
    var phi_7256_: f32;
    var phi_7261_: f32;
    var phi_7278_: f32;
    var phi_7285_: f32;
    var phi_7290_: f32;
    var phi_7297_: f32;
    var phi_7302_: f32;
    var phi_7316_: f32;
    var phi_7323_: f32;
    var phi_7328_: f32;
    var phi_7335_: f32;
    var phi_7340_: f32;
    var phi_7345_: f32;
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
    var phi_7478_: f32;
    var phi_7483_: f32;
    var phi_7488_: f32;
    var phi_7494_: f32;
    var phi_7500_: f32;
    var phi_7507_: f32;
    var phi_7517_: f32;
    var phi_7588_: f32;
    var phi_7593_: f32;
    var phi_7598_: f32;
    var phi_7603_: f32;
    var phi_7608_: f32;
    var phi_7613_: f32;
    var phi_7618_: f32;
    var phi_7623_: f32;
    var phi_7628_: f32;
    var phi_7633_: f32;
    var phi_7638_: f32;
    var phi_7643_: f32;
    var phi_7648_: f32;
    var phi_7653_: f32;
    var phi_7659_: f32;
    var phi_7665_: f32;
    var phi_7672_: f32;
    var phi_7682_: f32;
    var phi_7692_: f32;
    var phi_7872_: bool;
    var phi_7873_: bool;
    var phi_7875_: bool;
    var phi_7885_: bool;
    var phi_7886_: bool;
    var phi_7936_: type_9;
    var phi_7937_: type_9;
    var phi_7960_: type_9;
    var phi_7983_: u32;
    var phi_8038_: type_9;
    var phi_8057_: bool;
    var phi_8058_: bool;
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
            let _e4630 = local_3;
            phi_946_ = _e4630;
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
                        phi_1850_ = u32();
                        phi_1851_ = false;
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
                            if (_e517.member[0] == _e519.member[0]) {
                                phi_1089_ = bool();
                                phi_1090_ = true;
                            } else {
                                if (_e517.member[0] == _e519.member[1]) {
                                    phi_1087_ = bool();
                                    phi_1088_ = true;
                                } else {
                                    let _e543 = (_e517.member[1] == _e519.member[0]);
                                    if _e543 {
                                        phi_1086_ = bool();
                                    } else {
                                        phi_1086_ = (_e517.member[1] == _e519.member[1]);
                                    }
                                    let _e550 = phi_1086_;
                                    phi_1087_ = _e550;
                                    phi_1088_ = _e543;
                                }
                                let _e552 = phi_1087_;
                                let _e554 = phi_1088_;
                                phi_1089_ = _e552;
                                phi_1090_ = _e554;
                            }
                            let _e556 = phi_1089_;
                            let _e558 = phi_1090_;
                            if _e558 {
                                phi_1094_ = true;
                            } else {
                                phi_1094_ = _e556;
                            }
                            let _e560 = phi_1094_;
                            if _e560 {
                                phi_1099_ = false;
                            } else {
                                phi_1099_ = true;
                            }
                            let _e562 = phi_1099_;
                            phi_1100_ = _e562;
                        } else {
                            phi_1100_ = true;
                        }
                        let _e564 = phi_1100_;
                        if _e564 {
                            let _e566 = params.member.member.member_1;
                            if ((_e566 & 2u) != 0u) {
                                let _e572 = bodies.member[_e517.member[0]];
                                let _e576 = bodies.member[_e519.member[0]];
                                if ((_e572 / 2u) == (_e576 / 2u)) {
                                    let _e581 = params.member.member.member_1;
                                    phi_1144_ = !(((_e581 & 4u) != 0u));
                                } else {
                                    phi_1144_ = false;
                                }
                                let _e586 = phi_1144_;
                                if _e586 {
                                    phi_1155_ = true;
                                } else {
                                    if (((_e572 & _e576) & 1u) == 0u) {
                                        phi_1154_ = false;
                                    } else {
                                        phi_1154_ = true;
                                    }
                                    let _e591 = phi_1154_;
                                    phi_1155_ = _e591;
                                }
                                let _e593 = phi_1155_;
                                if _e593 {
                                    phi_1159_ = false;
                                } else {
                                    phi_1159_ = true;
                                }
                                let _e595 = phi_1159_;
                                phi_1160_ = _e595;
                            } else {
                                phi_1160_ = true;
                            }
                            let _e597 = phi_1160_;
                            if _e597 {
                                let _e599 = params.member.member.member_1;
                                if ((_e599 & 32u) != 0u) {
                                    let _e603 = params.member.member.member_6;
                                    let _e644 = (((((((_e521.member_1[0] - _e523.member[0]) > _e603) && ((_e523.member_1[0] - _e521.member[0]) > _e603)) && ((_e521.member_1[1] - _e523.member[1]) > _e603)) && ((_e523.member_1[1] - _e521.member[1]) > _e603)) && ((_e521.member_1[2] - _e523.member[2]) > _e603)) && ((_e523.member_1[2] - _e521.member[2]) > _e603));
                                    if _e644 {
                                        phi_1774_ = bool();
                                    } else {
                                        let _e648 = keys.member[_e517.member[0]];
                                        let _e653 = keys.member[_e517.member[1]];
                                        let _e655 = function_(_e648[0], _e653[0]);
                                        let _e659 = keys.member[_e517.member[2]];
                                        let _e661 = function_(_e655, _e659[0]);
                                        let _e665 = keys.member[_e519.member[0]];
                                        let _e670 = keys.member[_e519.member[1]];
                                        let _e672 = function_1(_e665[3], _e670[3]);
                                        let _e676 = keys.member[_e519.member[2]];
                                        let _e678 = function_1(_e672, _e676[3]);
                                        if (_e661[1] > _e678[1]) {
                                            phi_1297_ = true;
                                        } else {
                                            if (_e661[1] == _e678[1]) {
                                                phi_1296_ = (_e661[0] > _e678[0]);
                                            } else {
                                                phi_1296_ = false;
                                            }
                                            let _e689 = phi_1296_;
                                            phi_1297_ = _e689;
                                        }
                                        let _e691 = phi_1297_;
                                        let _e696 = keys.member[_e519.member[0]];
                                        let _e701 = keys.member[_e519.member[1]];
                                        let _e703 = function_(_e696[0], _e701[0]);
                                        let _e707 = keys.member[_e519.member[2]];
                                        let _e709 = function_(_e703, _e707[0]);
                                        let _e713 = keys.member[_e517.member[0]];
                                        let _e718 = keys.member[_e517.member[1]];
                                        let _e720 = function_1(_e713[3], _e718[3]);
                                        let _e724 = keys.member[_e517.member[2]];
                                        let _e726 = function_1(_e720, _e724[3]);
                                        if (_e709[1] > _e726[1]) {
                                            phi_1391_ = true;
                                        } else {
                                            if (_e709[1] == _e726[1]) {
                                                phi_1390_ = (_e709[0] > _e726[0]);
                                            } else {
                                                phi_1390_ = false;
                                            }
                                            let _e737 = phi_1390_;
                                            phi_1391_ = _e737;
                                        }
                                        let _e739 = phi_1391_;
                                        let _e745 = keys.member[_e517.member[0]];
                                        let _e750 = keys.member[_e517.member[1]];
                                        let _e752 = function_2(_e745[1], _e750[1]);
                                        let _e756 = keys.member[_e517.member[2]];
                                        let _e758 = function_2(_e752, _e756[1]);
                                        let _e762 = keys.member[_e519.member[0]];
                                        let _e767 = keys.member[_e519.member[1]];
                                        let _e769 = function_3(_e762[4], _e767[4]);
                                        let _e773 = keys.member[_e519.member[2]];
                                        let _e775 = function_3(_e769, _e773[4]);
                                        if (_e758[1] > _e775[1]) {
                                            phi_1486_ = true;
                                        } else {
                                            if (_e758[1] == _e775[1]) {
                                                phi_1485_ = (_e758[0] > _e775[0]);
                                            } else {
                                                phi_1485_ = false;
                                            }
                                            let _e786 = phi_1485_;
                                            phi_1486_ = _e786;
                                        }
                                        let _e788 = phi_1486_;
                                        let _e793 = keys.member[_e519.member[0]];
                                        let _e798 = keys.member[_e519.member[1]];
                                        let _e800 = function_2(_e793[1], _e798[1]);
                                        let _e804 = keys.member[_e519.member[2]];
                                        let _e806 = function_2(_e800, _e804[1]);
                                        let _e810 = keys.member[_e517.member[0]];
                                        let _e815 = keys.member[_e517.member[1]];
                                        let _e817 = function_3(_e810[4], _e815[4]);
                                        let _e821 = keys.member[_e517.member[2]];
                                        let _e823 = function_3(_e817, _e821[4]);
                                        if (_e806[1] > _e823[1]) {
                                            phi_1580_ = true;
                                        } else {
                                            if (_e806[1] == _e823[1]) {
                                                phi_1579_ = (_e806[0] > _e823[0]);
                                            } else {
                                                phi_1579_ = false;
                                            }
                                            let _e834 = phi_1579_;
                                            phi_1580_ = _e834;
                                        }
                                        let _e836 = phi_1580_;
                                        let _e843 = keys.member[_e517.member[0]];
                                        let _e848 = keys.member[_e517.member[1]];
                                        let _e850 = function_4(_e843[2], _e848[2]);
                                        let _e854 = keys.member[_e517.member[2]];
                                        let _e856 = function_4(_e850, _e854[2]);
                                        let _e860 = keys.member[_e519.member[0]];
                                        let _e865 = keys.member[_e519.member[1]];
                                        let _e867 = function_5(_e860[5], _e865[5]);
                                        let _e871 = keys.member[_e519.member[2]];
                                        let _e873 = function_5(_e867, _e871[5]);
                                        if (_e856[1] > _e873[1]) {
                                            phi_1676_ = true;
                                        } else {
                                            if (_e856[1] == _e873[1]) {
                                                phi_1675_ = (_e856[0] > _e873[0]);
                                            } else {
                                                phi_1675_ = false;
                                            }
                                            let _e884 = phi_1675_;
                                            phi_1676_ = _e884;
                                        }
                                        let _e886 = phi_1676_;
                                        let _e891 = keys.member[_e519.member[0]];
                                        let _e896 = keys.member[_e519.member[1]];
                                        let _e898 = function_4(_e891[2], _e896[2]);
                                        let _e902 = keys.member[_e519.member[2]];
                                        let _e904 = function_4(_e898, _e902[2]);
                                        let _e908 = keys.member[_e517.member[0]];
                                        let _e913 = keys.member[_e517.member[1]];
                                        let _e915 = function_5(_e908[5], _e913[5]);
                                        let _e919 = keys.member[_e517.member[2]];
                                        let _e921 = function_5(_e915, _e919[5]);
                                        if (_e904[1] > _e921[1]) {
                                            phi_1770_ = true;
                                        } else {
                                            if (_e904[1] == _e921[1]) {
                                                phi_1769_ = (_e904[0] > _e921[0]);
                                            } else {
                                                phi_1769_ = false;
                                            }
                                            let _e932 = phi_1769_;
                                            phi_1770_ = _e932;
                                        }
                                        let _e934 = phi_1770_;
                                        phi_1774_ = (((!(_e691) && !(_e739)) && (!(_e788) && !(_e836))) && (!(_e886) && !(_e934)));
                                    }
                                    let _e939 = phi_1774_;
                                    phi_1775_ = _e939;
                                    phi_1776_ = _e644;
                                } else {
                                    phi_1775_ = bool();
                                    phi_1776_ = true;
                                }
                                let _e941 = phi_1775_;
                                let _e943 = phi_1776_;
                                if _e943 {
                                    phi_1780_ = false;
                                } else {
                                    phi_1780_ = true;
                                }
                                let _e945 = phi_1780_;
                                phi_1781_ = _e941;
                                phi_1782_ = _e945;
                            } else {
                                phi_1781_ = false;
                                phi_1782_ = true;
                            }
                            let _e947 = phi_1781_;
                            let _e949 = phi_1782_;
                            phi_1783_ = _e947;
                            phi_1784_ = _e949;
                        } else {
                            phi_1783_ = false;
                            phi_1784_ = true;
                        }
                        let _e951 = phi_1783_;
                        let _e953 = phi_1784_;
                        if _e953 {
                            phi_1788_ = _e951;
                        } else {
                            phi_1788_ = true;
                        }
                        let _e955 = phi_1788_;
                        if _e955 {
                            let _e958 = params.member.member_1.member_3;
                            if (_e517.member_1 < _e519.member_1) {
                                phi_1807_ = type_9(_e517.member_1, _e519.member_1);
                            } else {
                                phi_1807_ = type_9(_e519.member_1, _e517.member_1);
                            }
                            let _e965 = phi_1807_;
                            let _e969 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e969 + 1u) < _e969) {
                                let _e973 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e969 < _e958) {
                                let _e975 = (2u * _e969);
                                atomicStore((&output.member[(4u + _e975)]), _e965.member);
                                atomicStore((&output.member[(_e975 + 5u)]), _e965.member_1);
                            }
                            let _e981 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e981 + 1u) < _e981) {
                                let _e985 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1850_ = (_e486 & (_e486 - 1u));
                        phi_1851_ = true;
                    }
                    let _e987 = phi_1850_;
                    let _e989 = phi_1851_;
                    phi_947_ = _e987;
                    phi_1852_ = _e989;
                } else {
                    phi_947_ = u32();
                    phi_1852_ = false;
                }
                let _e991 = phi_947_;
                let _e993 = phi_1852_;
                continue;
                continuing {
                    phi_943_ = _e498;
                    phi_946_ = _e991;
                    break if !(_e993);
                }
            }
            workgroupBarrier();
            let _e996 = atomicLoad((&counters[4u]));
            if (2048u < _e996) {
                phi_1859_ = 2048u;
            } else {
                phi_1859_ = _e996;
            }
            let _e999 = phi_1859_;
            phi_1862_ = type_9(0u, 16u);
            loop {
                let _e1001 = phi_1862_;
                if (_e1001.member < _e1001.member_1) {
                    phi_1863_ = type_9((_e1001.member + 1u), _e1001.member_1);
                    phi_1886_ = type_9(1u, _e1001.member);
                } else {
                    phi_1863_ = _e1001;
                    phi_1886_ = type_9(0u, type_9().member_1);
                }
                let _e1013 = phi_1863_;
                let _e1015 = phi_1886_;
                if (bitcast<i32>(_e1015.member) != 0i) {
                    let _e1021 = (_e67 + (_e1015.member_1 * 128u));
                    if (_e1021 >= _e999) {
                        phi_7885_ = false;
                    } else {
                        let _e1024 = hits[_e1021];
                        let _e1027 = ((_e1024 >> bitcast<u32>(10i)) & 3u);
                        let _e1034 = firsts[(2u * _e1027)];
                        let _e1035 = (_e1034 + ((_e1024 >> bitcast<u32>(5i)) & 31u));
                        let _e1039 = firsts[((2u * _e1027) + 1u)];
                        let _e1040 = (_e1039 + (_e1024 & 31u));
                        let _e1042 = leaves.member[_e1035];
                        let _e1044 = leaves.member[_e1040];
                        let _e1046 = nodes.member[_e1035];
                        let _e1048 = nodes.member[_e1040];
                        let _e1051 = params.member.member.member_1;
                        if ((_e1051 & 1u) != 0u) {
                            if (_e1042.member[0] == _e1044.member[0]) {
                                phi_2014_ = bool();
                                phi_2015_ = true;
                            } else {
                                if (_e1042.member[0] == _e1044.member[1]) {
                                    phi_2012_ = bool();
                                    phi_2013_ = true;
                                } else {
                                    let _e1068 = (_e1042.member[1] == _e1044.member[0]);
                                    if _e1068 {
                                        phi_2011_ = bool();
                                    } else {
                                        phi_2011_ = (_e1042.member[1] == _e1044.member[1]);
                                    }
                                    let _e1075 = phi_2011_;
                                    phi_2012_ = _e1075;
                                    phi_2013_ = _e1068;
                                }
                                let _e1077 = phi_2012_;
                                let _e1079 = phi_2013_;
                                phi_2014_ = _e1077;
                                phi_2015_ = _e1079;
                            }
                            let _e1081 = phi_2014_;
                            let _e1083 = phi_2015_;
                            if _e1083 {
                                phi_2019_ = true;
                            } else {
                                phi_2019_ = _e1081;
                            }
                            let _e1085 = phi_2019_;
                            if _e1085 {
                                phi_2024_ = false;
                            } else {
                                phi_2024_ = true;
                            }
                            let _e1087 = phi_2024_;
                            phi_2025_ = _e1087;
                        } else {
                            phi_2025_ = true;
                        }
                        let _e1089 = phi_2025_;
                        if _e1089 {
                            let _e1091 = params.member.member.member_1;
                            if ((_e1091 & 2u) != 0u) {
                                let _e1097 = bodies.member[_e1042.member[0]];
                                let _e1101 = bodies.member[_e1044.member[0]];
                                if ((_e1097 / 2u) == (_e1101 / 2u)) {
                                    let _e1106 = params.member.member.member_1;
                                    phi_2069_ = !(((_e1106 & 4u) != 0u));
                                } else {
                                    phi_2069_ = false;
                                }
                                let _e1111 = phi_2069_;
                                if _e1111 {
                                    phi_2080_ = true;
                                } else {
                                    if (((_e1097 & _e1101) & 1u) == 0u) {
                                        phi_2079_ = false;
                                    } else {
                                        phi_2079_ = true;
                                    }
                                    let _e1116 = phi_2079_;
                                    phi_2080_ = _e1116;
                                }
                                let _e1118 = phi_2080_;
                                if _e1118 {
                                    phi_2084_ = false;
                                } else {
                                    phi_2084_ = true;
                                }
                                let _e1120 = phi_2084_;
                                phi_2085_ = _e1120;
                            } else {
                                phi_2085_ = true;
                            }
                            let _e1122 = phi_2085_;
                            if _e1122 {
                                let _e1124 = params.member.member.member_1;
                                if ((_e1124 & 32u) != 0u) {
                                    let _e1128 = params.member.member.member_6;
                                    let _e1169 = (((((((_e1046.member_1[0] - _e1048.member[0]) > _e1128) && ((_e1048.member_1[0] - _e1046.member[0]) > _e1128)) && ((_e1046.member_1[1] - _e1048.member[1]) > _e1128)) && ((_e1048.member_1[1] - _e1046.member[1]) > _e1128)) && ((_e1046.member_1[2] - _e1048.member[2]) > _e1128)) && ((_e1048.member_1[2] - _e1046.member[2]) > _e1128));
                                    if _e1169 {
                                        phi_2699_ = bool();
                                    } else {
                                        let _e1173 = keys.member[_e1042.member[0]];
                                        let _e1178 = keys.member[_e1042.member[1]];
                                        let _e1180 = function_(_e1173[0], _e1178[0]);
                                        let _e1184 = keys.member[_e1042.member[2]];
                                        let _e1186 = function_(_e1180, _e1184[0]);
                                        let _e1190 = keys.member[_e1044.member[0]];
                                        let _e1195 = keys.member[_e1044.member[1]];
                                        let _e1197 = function_1(_e1190[3], _e1195[3]);
                                        let _e1201 = keys.member[_e1044.member[2]];
                                        let _e1203 = function_1(_e1197, _e1201[3]);
                                        if (_e1186[1] > _e1203[1]) {
                                            phi_2222_ = true;
                                        } else {
                                            if (_e1186[1] == _e1203[1]) {
                                                phi_2221_ = (_e1186[0] > _e1203[0]);
                                            } else {
                                                phi_2221_ = false;
                                            }
                                            let _e1214 = phi_2221_;
                                            phi_2222_ = _e1214;
                                        }
                                        let _e1216 = phi_2222_;
                                        let _e1221 = keys.member[_e1044.member[0]];
                                        let _e1226 = keys.member[_e1044.member[1]];
                                        let _e1228 = function_(_e1221[0], _e1226[0]);
                                        let _e1232 = keys.member[_e1044.member[2]];
                                        let _e1234 = function_(_e1228, _e1232[0]);
                                        let _e1238 = keys.member[_e1042.member[0]];
                                        let _e1243 = keys.member[_e1042.member[1]];
                                        let _e1245 = function_1(_e1238[3], _e1243[3]);
                                        let _e1249 = keys.member[_e1042.member[2]];
                                        let _e1251 = function_1(_e1245, _e1249[3]);
                                        if (_e1234[1] > _e1251[1]) {
                                            phi_2316_ = true;
                                        } else {
                                            if (_e1234[1] == _e1251[1]) {
                                                phi_2315_ = (_e1234[0] > _e1251[0]);
                                            } else {
                                                phi_2315_ = false;
                                            }
                                            let _e1262 = phi_2315_;
                                            phi_2316_ = _e1262;
                                        }
                                        let _e1264 = phi_2316_;
                                        let _e1270 = keys.member[_e1042.member[0]];
                                        let _e1275 = keys.member[_e1042.member[1]];
                                        let _e1277 = function_2(_e1270[1], _e1275[1]);
                                        let _e1281 = keys.member[_e1042.member[2]];
                                        let _e1283 = function_2(_e1277, _e1281[1]);
                                        let _e1287 = keys.member[_e1044.member[0]];
                                        let _e1292 = keys.member[_e1044.member[1]];
                                        let _e1294 = function_3(_e1287[4], _e1292[4]);
                                        let _e1298 = keys.member[_e1044.member[2]];
                                        let _e1300 = function_3(_e1294, _e1298[4]);
                                        if (_e1283[1] > _e1300[1]) {
                                            phi_2411_ = true;
                                        } else {
                                            if (_e1283[1] == _e1300[1]) {
                                                phi_2410_ = (_e1283[0] > _e1300[0]);
                                            } else {
                                                phi_2410_ = false;
                                            }
                                            let _e1311 = phi_2410_;
                                            phi_2411_ = _e1311;
                                        }
                                        let _e1313 = phi_2411_;
                                        let _e1318 = keys.member[_e1044.member[0]];
                                        let _e1323 = keys.member[_e1044.member[1]];
                                        let _e1325 = function_2(_e1318[1], _e1323[1]);
                                        let _e1329 = keys.member[_e1044.member[2]];
                                        let _e1331 = function_2(_e1325, _e1329[1]);
                                        let _e1335 = keys.member[_e1042.member[0]];
                                        let _e1340 = keys.member[_e1042.member[1]];
                                        let _e1342 = function_3(_e1335[4], _e1340[4]);
                                        let _e1346 = keys.member[_e1042.member[2]];
                                        let _e1348 = function_3(_e1342, _e1346[4]);
                                        if (_e1331[1] > _e1348[1]) {
                                            phi_2505_ = true;
                                        } else {
                                            if (_e1331[1] == _e1348[1]) {
                                                phi_2504_ = (_e1331[0] > _e1348[0]);
                                            } else {
                                                phi_2504_ = false;
                                            }
                                            let _e1359 = phi_2504_;
                                            phi_2505_ = _e1359;
                                        }
                                        let _e1361 = phi_2505_;
                                        let _e1368 = keys.member[_e1042.member[0]];
                                        let _e1373 = keys.member[_e1042.member[1]];
                                        let _e1375 = function_4(_e1368[2], _e1373[2]);
                                        let _e1379 = keys.member[_e1042.member[2]];
                                        let _e1381 = function_4(_e1375, _e1379[2]);
                                        let _e1385 = keys.member[_e1044.member[0]];
                                        let _e1390 = keys.member[_e1044.member[1]];
                                        let _e1392 = function_5(_e1385[5], _e1390[5]);
                                        let _e1396 = keys.member[_e1044.member[2]];
                                        let _e1398 = function_5(_e1392, _e1396[5]);
                                        if (_e1381[1] > _e1398[1]) {
                                            phi_2601_ = true;
                                        } else {
                                            if (_e1381[1] == _e1398[1]) {
                                                phi_2600_ = (_e1381[0] > _e1398[0]);
                                            } else {
                                                phi_2600_ = false;
                                            }
                                            let _e1409 = phi_2600_;
                                            phi_2601_ = _e1409;
                                        }
                                        let _e1411 = phi_2601_;
                                        let _e1416 = keys.member[_e1044.member[0]];
                                        let _e1421 = keys.member[_e1044.member[1]];
                                        let _e1423 = function_4(_e1416[2], _e1421[2]);
                                        let _e1427 = keys.member[_e1044.member[2]];
                                        let _e1429 = function_4(_e1423, _e1427[2]);
                                        let _e1433 = keys.member[_e1042.member[0]];
                                        let _e1438 = keys.member[_e1042.member[1]];
                                        let _e1440 = function_5(_e1433[5], _e1438[5]);
                                        let _e1444 = keys.member[_e1042.member[2]];
                                        let _e1446 = function_5(_e1440, _e1444[5]);
                                        if (_e1429[1] > _e1446[1]) {
                                            phi_2695_ = true;
                                        } else {
                                            if (_e1429[1] == _e1446[1]) {
                                                phi_2694_ = (_e1429[0] > _e1446[0]);
                                            } else {
                                                phi_2694_ = false;
                                            }
                                            let _e1457 = phi_2694_;
                                            phi_2695_ = _e1457;
                                        }
                                        let _e1459 = phi_2695_;
                                        phi_2699_ = (((!(_e1216) && !(_e1264)) && (!(_e1313) && !(_e1361))) && (!(_e1411) && !(_e1459)));
                                    }
                                    let _e1464 = phi_2699_;
                                    phi_2700_ = _e1464;
                                    phi_2701_ = _e1169;
                                } else {
                                    phi_2700_ = bool();
                                    phi_2701_ = true;
                                }
                                let _e1466 = phi_2700_;
                                let _e1468 = phi_2701_;
                                if _e1468 {
                                    phi_2705_ = false;
                                } else {
                                    phi_2705_ = true;
                                }
                                let _e1470 = phi_2705_;
                                phi_2706_ = _e1466;
                                phi_2707_ = _e1470;
                            } else {
                                phi_2706_ = false;
                                phi_2707_ = true;
                            }
                            let _e1472 = phi_2706_;
                            let _e1474 = phi_2707_;
                            phi_2708_ = _e1472;
                            phi_2709_ = _e1474;
                        } else {
                            phi_2708_ = false;
                            phi_2709_ = true;
                        }
                        let _e1476 = phi_2708_;
                        let _e1478 = phi_2709_;
                        if _e1478 {
                            phi_2713_ = _e1476;
                        } else {
                            phi_2713_ = true;
                        }
                        let _e1480 = phi_2713_;
                        if _e1480 {
                            let _e1482 = atomicAdd((&counters[7u]), 1u);
                            if (_e1042.member_1 < _e1044.member_1) {
                                phi_2726_ = _e1044;
                                phi_2727_ = _e1042;
                            } else {
                                phi_2726_ = _e1042;
                                phi_2727_ = _e1044;
                            }
                            let _e1488 = phi_2726_;
                            let _e1490 = phi_2727_;
                            let _e1492 = params.member.member.member_4;
                            let _e1494 = params.member.member.member_5;
                            let _e1504 = paths.member[_e1490.member[0]];
                            let _e1506 = paths.member[_e1490.member[1]];
                            let _e1512 = paths.member[_e1488.member[0]];
                            let _e1514 = paths.member[_e1488.member[1]];
                            local_2 = type_37(array<array<f32, 3>, 2>(array<f32, 3>((_e1512.member[0] - _e1504.member[0]), (_e1512.member[1] - _e1504.member[1]), (_e1512.member[2] - _e1504.member[2])), array<f32, 3>((_e1512.member_1[0] - _e1504.member_1[0]), (_e1512.member_1[1] - _e1504.member_1[1]), (_e1512.member_1[2] - _e1504.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1506.member[0] - _e1504.member[0]), (_e1506.member[1] - _e1504.member[1]), (_e1506.member[2] - _e1504.member[2])), array<f32, 3>((_e1506.member_1[0] - _e1504.member_1[0]), (_e1506.member_1[1] - _e1504.member_1[1]), (_e1506.member_1[2] - _e1504.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1512.member[0] - _e1514.member[0]), (_e1512.member[1] - _e1514.member[1]), (_e1512.member[2] - _e1514.member[2])), array<f32, 3>((_e1512.member_1[0] - _e1514.member_1[0]), (_e1512.member_1[1] - _e1514.member_1[1]), (_e1512.member_1[2] - _e1514.member_1[2]))), (_e1492 + _e1492));
                            let _e1574 = local_2.member_1[0u];
                            let _e1580 = local_2.member_2[0u];
                            let _e1586 = ((_e1574[1] * _e1580[2]) - (_e1574[2] * _e1580[1]));
                            let _e1589 = ((_e1574[2] * _e1580[0]) - (_e1574[0] * _e1580[2]));
                            let _e1592 = ((_e1574[0] * _e1580[1]) - (_e1574[1] * _e1580[0]));
                            let _e1595 = local_2.member_1[1u];
                            let _e1601 = local_2.member_2[1u];
                            let _e1607 = ((_e1595[1] * _e1601[2]) - (_e1595[2] * _e1601[1]));
                            let _e1610 = ((_e1595[2] * _e1601[0]) - (_e1595[0] * _e1601[2]));
                            let _e1613 = ((_e1595[0] * _e1601[1]) - (_e1595[1] * _e1601[0]));
                            let _e1616 = local_2.member_1[0u];
                            let _e1622 = local_2.member_2[1u];
                            let _e1637 = local_2.member_1[1u];
                            let _e1643 = local_2.member_2[0u];
                            let _e1656 = (((_e1616[1] * _e1622[2]) - (_e1616[2] * _e1622[1])) + ((_e1637[1] * _e1643[2]) - (_e1637[2] * _e1643[1])));
                            let _e1657 = (((_e1616[2] * _e1622[0]) - (_e1616[0] * _e1622[2])) + ((_e1637[2] * _e1643[0]) - (_e1637[0] * _e1643[2])));
                            let _e1658 = (((_e1616[0] * _e1622[1]) - (_e1616[1] * _e1622[0])) + ((_e1637[0] * _e1643[1]) - (_e1637[1] * _e1643[0])));
                            let _e1661 = local_2.member[0u];
                            let _e1672 = local_2.member[1u];
                            let _e1683 = local_2.member[0u];
                            let _e1692 = ((((_e1672[0] * _e1586) + (_e1672[1] * _e1589)) + (_e1672[2] * _e1592)) + (((_e1683[0] * _e1656) + (_e1683[1] * _e1657)) + (_e1683[2] * _e1658)));
                            let _e1695 = local_2.member[0u];
                            let _e1706 = local_2.member[1u];
                            let _e1715 = ((((_e1695[0] * _e1607) + (_e1695[1] * _e1610)) + (_e1695[2] * _e1613)) + (((_e1706[0] * _e1656) + (_e1706[1] * _e1657)) + (_e1706[2] * _e1658)));
                            let _e1718 = local_2.member[1u];
                            let _e1729 = local_2.member[0u];
                            if (_e1729[0] < 0f) {
                                phi_3116_ = -(_e1729[0]);
                            } else {
                                phi_3116_ = _e1729[0];
                            }
                            let _e1736 = phi_3116_;
                            if (_e1729[1] < 0f) {
                                phi_3123_ = -(_e1729[1]);
                            } else {
                                phi_3123_ = _e1729[1];
                            }
                            let _e1740 = phi_3123_;
                            if (_e1736 > _e1740) {
                                phi_3128_ = _e1736;
                            } else {
                                phi_3128_ = _e1740;
                            }
                            let _e1743 = phi_3128_;
                            if (_e1729[2] < 0f) {
                                phi_3135_ = -(_e1729[2]);
                            } else {
                                phi_3135_ = _e1729[2];
                            }
                            let _e1747 = phi_3135_;
                            if (_e1743 > _e1747) {
                                phi_3140_ = _e1743;
                            } else {
                                phi_3140_ = _e1747;
                            }
                            let _e1750 = phi_3140_;
                            let _e1753 = local_2.member[1u];
                            if (_e1753[0] < 0f) {
                                phi_3153_ = -(_e1753[0]);
                            } else {
                                phi_3153_ = _e1753[0];
                            }
                            let _e1760 = phi_3153_;
                            if (_e1753[1] < 0f) {
                                phi_3160_ = -(_e1753[1]);
                            } else {
                                phi_3160_ = _e1753[1];
                            }
                            let _e1764 = phi_3160_;
                            if (_e1760 > _e1764) {
                                phi_3165_ = _e1760;
                            } else {
                                phi_3165_ = _e1764;
                            }
                            let _e1767 = phi_3165_;
                            if (_e1753[2] < 0f) {
                                phi_3172_ = -(_e1753[2]);
                            } else {
                                phi_3172_ = _e1753[2];
                            }
                            let _e1771 = phi_3172_;
                            if (_e1767 > _e1771) {
                                phi_3177_ = _e1767;
                            } else {
                                phi_3177_ = _e1771;
                            }
                            let _e1774 = phi_3177_;
                            if (_e1750 > _e1774) {
                                phi_3182_ = _e1750;
                            } else {
                                phi_3182_ = _e1774;
                            }
                            let _e1777 = phi_3182_;
                            let _e1779 = local_2.member_3;
                            let _e1780 = (_e1777 + _e1779);
                            let _e1783 = local_2.member_1[0u];
                            if (_e1783[0] < 0f) {
                                phi_3199_ = -(_e1783[0]);
                            } else {
                                phi_3199_ = _e1783[0];
                            }
                            let _e1790 = phi_3199_;
                            if (_e1783[1] < 0f) {
                                phi_3206_ = -(_e1783[1]);
                            } else {
                                phi_3206_ = _e1783[1];
                            }
                            let _e1794 = phi_3206_;
                            if (_e1790 > _e1794) {
                                phi_3211_ = _e1790;
                            } else {
                                phi_3211_ = _e1794;
                            }
                            let _e1797 = phi_3211_;
                            if (_e1783[2] < 0f) {
                                phi_3218_ = -(_e1783[2]);
                            } else {
                                phi_3218_ = _e1783[2];
                            }
                            let _e1801 = phi_3218_;
                            if (_e1797 > _e1801) {
                                phi_3223_ = _e1797;
                            } else {
                                phi_3223_ = _e1801;
                            }
                            let _e1804 = phi_3223_;
                            let _e1807 = local_2.member_1[1u];
                            if (_e1807[0] < 0f) {
                                phi_3237_ = -(_e1807[0]);
                            } else {
                                phi_3237_ = _e1807[0];
                            }
                            let _e1814 = phi_3237_;
                            if (_e1807[1] < 0f) {
                                phi_3244_ = -(_e1807[1]);
                            } else {
                                phi_3244_ = _e1807[1];
                            }
                            let _e1818 = phi_3244_;
                            if (_e1814 > _e1818) {
                                phi_3249_ = _e1814;
                            } else {
                                phi_3249_ = _e1818;
                            }
                            let _e1821 = phi_3249_;
                            if (_e1807[2] < 0f) {
                                phi_3256_ = -(_e1807[2]);
                            } else {
                                phi_3256_ = _e1807[2];
                            }
                            let _e1825 = phi_3256_;
                            if (_e1821 > _e1825) {
                                phi_3261_ = _e1821;
                            } else {
                                phi_3261_ = _e1825;
                            }
                            let _e1828 = phi_3261_;
                            if (_e1804 > _e1828) {
                                phi_3266_ = _e1804;
                            } else {
                                phi_3266_ = _e1828;
                            }
                            let _e1831 = phi_3266_;
                            let _e1833 = local_2.member_3;
                            let _e1834 = (_e1831 + _e1833);
                            let _e1837 = local_2.member_2[0u];
                            if (_e1837[0] < 0f) {
                                phi_3283_ = -(_e1837[0]);
                            } else {
                                phi_3283_ = _e1837[0];
                            }
                            let _e1844 = phi_3283_;
                            if (_e1837[1] < 0f) {
                                phi_3290_ = -(_e1837[1]);
                            } else {
                                phi_3290_ = _e1837[1];
                            }
                            let _e1848 = phi_3290_;
                            if (_e1844 > _e1848) {
                                phi_3295_ = _e1844;
                            } else {
                                phi_3295_ = _e1848;
                            }
                            let _e1851 = phi_3295_;
                            if (_e1837[2] < 0f) {
                                phi_3302_ = -(_e1837[2]);
                            } else {
                                phi_3302_ = _e1837[2];
                            }
                            let _e1855 = phi_3302_;
                            if (_e1851 > _e1855) {
                                phi_3307_ = _e1851;
                            } else {
                                phi_3307_ = _e1855;
                            }
                            let _e1858 = phi_3307_;
                            let _e1861 = local_2.member_2[1u];
                            if (_e1861[0] < 0f) {
                                phi_3321_ = -(_e1861[0]);
                            } else {
                                phi_3321_ = _e1861[0];
                            }
                            let _e1868 = phi_3321_;
                            if (_e1861[1] < 0f) {
                                phi_3328_ = -(_e1861[1]);
                            } else {
                                phi_3328_ = _e1861[1];
                            }
                            let _e1872 = phi_3328_;
                            if (_e1868 > _e1872) {
                                phi_3333_ = _e1868;
                            } else {
                                phi_3333_ = _e1872;
                            }
                            let _e1875 = phi_3333_;
                            if (_e1861[2] < 0f) {
                                phi_3340_ = -(_e1861[2]);
                            } else {
                                phi_3340_ = _e1861[2];
                            }
                            let _e1879 = phi_3340_;
                            if (_e1875 > _e1879) {
                                phi_3345_ = _e1875;
                            } else {
                                phi_3345_ = _e1879;
                            }
                            let _e1882 = phi_3345_;
                            if (_e1858 > _e1882) {
                                phi_3350_ = _e1858;
                            } else {
                                phi_3350_ = _e1882;
                            }
                            let _e1885 = phi_3350_;
                            let _e1887 = local_2.member_3;
                            let _e1888 = (_e1885 + _e1887);
                            let _e1890 = ((_e1834 * 8f) * _e1888);
                            let _e1897 = local_2.member_3;
                            if (_e1586 < 0f) {
                                phi_3381_ = -(_e1586);
                            } else {
                                phi_3381_ = _e1586;
                            }
                            let _e1914 = phi_3381_;
                            if (_e1589 < 0f) {
                                phi_3387_ = -(_e1589);
                            } else {
                                phi_3387_ = _e1589;
                            }
                            let _e1918 = phi_3387_;
                            if (_e1592 < 0f) {
                                phi_3394_ = -(_e1592);
                            } else {
                                phi_3394_ = _e1592;
                            }
                            let _e1923 = phi_3394_;
                            let _e1924 = ((_e1914 + _e1918) + _e1923);
                            if (_e1607 < 0f) {
                                phi_3401_ = -(_e1607);
                            } else {
                                phi_3401_ = _e1607;
                            }
                            let _e1928 = phi_3401_;
                            if (_e1610 < 0f) {
                                phi_3407_ = -(_e1610);
                            } else {
                                phi_3407_ = _e1610;
                            }
                            let _e1932 = phi_3407_;
                            if (_e1613 < 0f) {
                                phi_3414_ = -(_e1613);
                            } else {
                                phi_3414_ = _e1613;
                            }
                            let _e1937 = phi_3414_;
                            let _e1938 = ((_e1928 + _e1932) + _e1937);
                            if (_e1924 > _e1938) {
                                phi_3420_ = _e1924;
                            } else {
                                phi_3420_ = _e1938;
                            }
                            let _e1941 = phi_3420_;
                            if (_e1656 < 0f) {
                                phi_3426_ = -(_e1656);
                            } else {
                                phi_3426_ = _e1656;
                            }
                            let _e1945 = phi_3426_;
                            if (_e1657 < 0f) {
                                phi_3432_ = -(_e1657);
                            } else {
                                phi_3432_ = _e1657;
                            }
                            let _e1949 = phi_3432_;
                            if (_e1658 < 0f) {
                                phi_3439_ = -(_e1658);
                            } else {
                                phi_3439_ = _e1658;
                            }
                            let _e1954 = phi_3439_;
                            let _e1956 = (((_e1945 + _e1949) + _e1954) * 0.5f);
                            if (_e1941 > _e1956) {
                                phi_3446_ = _e1941;
                            } else {
                                phi_3446_ = _e1956;
                            }
                            let _e1959 = phi_3446_;
                            let _e1964 = local_2.member_3;
                            let _e1977 = ((((_e1661[0] * _e1586) + (_e1661[1] * _e1589)) + (_e1661[2] * _e1592)) * 3f);
                            let _e1978 = ((((_e1718[0] * _e1607) + (_e1718[1] * _e1610)) + (_e1718[2] * _e1613)) * 3f);
                            if (_e1977 < _e1978) {
                                phi_3470_ = _e1977;
                            } else {
                                phi_3470_ = _e1978;
                            }
                            let _e1981 = phi_3470_;
                            if (_e1692 < _e1715) {
                                phi_3475_ = _e1692;
                            } else {
                                phi_3475_ = _e1715;
                            }
                            let _e1984 = phi_3475_;
                            if (_e1981 < _e1984) {
                                phi_3480_ = _e1981;
                            } else {
                                phi_3480_ = _e1984;
                            }
                            let _e1987 = phi_3480_;
                            if (_e1977 > _e1978) {
                                phi_3485_ = _e1977;
                            } else {
                                phi_3485_ = _e1978;
                            }
                            let _e1990 = phi_3485_;
                            if (_e1692 > _e1715) {
                                phi_3490_ = _e1692;
                            } else {
                                phi_3490_ = _e1715;
                            }
                            let _e1993 = phi_3490_;
                            if (_e1990 > _e1993) {
                                phi_3495_ = _e1990;
                            } else {
                                phi_3495_ = _e1993;
                            }
                            let _e1996 = phi_3495_;
                            let _e2001 = -(_e1996);
                            if (_e1987 > _e2001) {
                                phi_3505_ = _e1987;
                            } else {
                                phi_3505_ = _e2001;
                            }
                            let _e2004 = phi_3505_;
                            if ((_e2004 - ((((((_e1780 * 8f) * _e1890) * (0.000000059604645f * (490f / 64f))) + ((_e1897 * 19f) * ((_e1780 * (_e1834 + _e1888)) + (_e1834 * _e1888)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1780) * ((1f + _e1834) * (1f + _e1888))))) + ((_e1494 * (((_e1959 + (_e1890 * (0.000000059604645f * 4f))) + ((_e1964 * 6f) * (_e1834 + _e1888))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1834) * (1f + _e1888))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4469_ = true;
                            } else {
                                let _e2009 = local_2.member_1[0u];
                                let _e2015 = local_2.member_1[1u];
                                let _e2019 = (_e2009[0] + _e2015[0]);
                                let _e2020 = (_e2009[1] + _e2015[1]);
                                let _e2021 = (_e2009[2] + _e2015[2]);
                                let _e2024 = local_2.member_2[0u];
                                let _e2030 = local_2.member_2[1u];
                                let _e2034 = (_e2024[0] + _e2030[0]);
                                let _e2035 = (_e2024[1] + _e2030[1]);
                                let _e2036 = (_e2024[2] + _e2030[2]);
                                let _e2039 = ((_e2020 * _e2036) - (_e2021 * _e2035));
                                let _e2042 = ((_e2021 * _e2034) - (_e2019 * _e2036));
                                let _e2045 = ((_e2019 * _e2035) - (_e2020 * _e2034));
                                let _e2048 = local_2.member[0u];
                                let _e2054 = local_2.member_1[0u];
                                let _e2060 = local_2.member_2[0u];
                                let _e2064 = (_e2048[0] - _e2054[0]);
                                let _e2065 = (_e2048[1] - _e2054[1]);
                                let _e2066 = (_e2048[2] - _e2054[2]);
                                let _e2067 = (_e2064 - _e2060[0]);
                                let _e2068 = (_e2065 - _e2060[1]);
                                let _e2069 = (_e2066 - _e2060[2]);
                                let _e2070 = (_e2048[0] - _e2060[0]);
                                let _e2071 = (_e2048[1] - _e2060[1]);
                                let _e2072 = (_e2048[2] - _e2060[2]);
                                let _e2075 = local_2.member[1u];
                                let _e2081 = local_2.member_1[1u];
                                let _e2087 = local_2.member_2[1u];
                                let _e2091 = (_e2075[0] - _e2081[0]);
                                let _e2092 = (_e2075[1] - _e2081[1]);
                                let _e2093 = (_e2075[2] - _e2081[2]);
                                let _e2094 = (_e2091 - _e2087[0]);
                                let _e2095 = (_e2092 - _e2087[1]);
                                let _e2096 = (_e2093 - _e2087[2]);
                                let _e2097 = (_e2075[0] - _e2087[0]);
                                let _e2098 = (_e2075[1] - _e2087[1]);
                                let _e2099 = (_e2075[2] - _e2087[2]);
                                let _e2102 = local_2.member[0u];
                                if (_e2102[0] < 0f) {
                                    phi_3708_ = -(_e2102[0]);
                                } else {
                                    phi_3708_ = _e2102[0];
                                }
                                let _e2109 = phi_3708_;
                                if (_e2102[1] < 0f) {
                                    phi_3715_ = -(_e2102[1]);
                                } else {
                                    phi_3715_ = _e2102[1];
                                }
                                let _e2113 = phi_3715_;
                                if (_e2109 > _e2113) {
                                    phi_3720_ = _e2109;
                                } else {
                                    phi_3720_ = _e2113;
                                }
                                let _e2116 = phi_3720_;
                                if (_e2102[2] < 0f) {
                                    phi_3727_ = -(_e2102[2]);
                                } else {
                                    phi_3727_ = _e2102[2];
                                }
                                let _e2120 = phi_3727_;
                                if (_e2116 > _e2120) {
                                    phi_3732_ = _e2116;
                                } else {
                                    phi_3732_ = _e2120;
                                }
                                let _e2123 = phi_3732_;
                                let _e2126 = local_2.member[1u];
                                if (_e2126[0] < 0f) {
                                    phi_3745_ = -(_e2126[0]);
                                } else {
                                    phi_3745_ = _e2126[0];
                                }
                                let _e2133 = phi_3745_;
                                if (_e2126[1] < 0f) {
                                    phi_3752_ = -(_e2126[1]);
                                } else {
                                    phi_3752_ = _e2126[1];
                                }
                                let _e2137 = phi_3752_;
                                if (_e2133 > _e2137) {
                                    phi_3757_ = _e2133;
                                } else {
                                    phi_3757_ = _e2137;
                                }
                                let _e2140 = phi_3757_;
                                if (_e2126[2] < 0f) {
                                    phi_3764_ = -(_e2126[2]);
                                } else {
                                    phi_3764_ = _e2126[2];
                                }
                                let _e2144 = phi_3764_;
                                if (_e2140 > _e2144) {
                                    phi_3769_ = _e2140;
                                } else {
                                    phi_3769_ = _e2144;
                                }
                                let _e2147 = phi_3769_;
                                if (_e2123 > _e2147) {
                                    phi_3774_ = _e2123;
                                } else {
                                    phi_3774_ = _e2147;
                                }
                                let _e2150 = phi_3774_;
                                let _e2152 = local_2.member_3;
                                let _e2156 = local_2.member_1[0u];
                                if (_e2156[0] < 0f) {
                                    phi_3791_ = -(_e2156[0]);
                                } else {
                                    phi_3791_ = _e2156[0];
                                }
                                let _e2163 = phi_3791_;
                                if (_e2156[1] < 0f) {
                                    phi_3798_ = -(_e2156[1]);
                                } else {
                                    phi_3798_ = _e2156[1];
                                }
                                let _e2167 = phi_3798_;
                                if (_e2163 > _e2167) {
                                    phi_3803_ = _e2163;
                                } else {
                                    phi_3803_ = _e2167;
                                }
                                let _e2170 = phi_3803_;
                                if (_e2156[2] < 0f) {
                                    phi_3810_ = -(_e2156[2]);
                                } else {
                                    phi_3810_ = _e2156[2];
                                }
                                let _e2174 = phi_3810_;
                                if (_e2170 > _e2174) {
                                    phi_3815_ = _e2170;
                                } else {
                                    phi_3815_ = _e2174;
                                }
                                let _e2177 = phi_3815_;
                                let _e2180 = local_2.member_1[1u];
                                if (_e2180[0] < 0f) {
                                    phi_3829_ = -(_e2180[0]);
                                } else {
                                    phi_3829_ = _e2180[0];
                                }
                                let _e2187 = phi_3829_;
                                if (_e2180[1] < 0f) {
                                    phi_3836_ = -(_e2180[1]);
                                } else {
                                    phi_3836_ = _e2180[1];
                                }
                                let _e2191 = phi_3836_;
                                if (_e2187 > _e2191) {
                                    phi_3841_ = _e2187;
                                } else {
                                    phi_3841_ = _e2191;
                                }
                                let _e2194 = phi_3841_;
                                if (_e2180[2] < 0f) {
                                    phi_3848_ = -(_e2180[2]);
                                } else {
                                    phi_3848_ = _e2180[2];
                                }
                                let _e2198 = phi_3848_;
                                if (_e2194 > _e2198) {
                                    phi_3853_ = _e2194;
                                } else {
                                    phi_3853_ = _e2198;
                                }
                                let _e2201 = phi_3853_;
                                if (_e2177 > _e2201) {
                                    phi_3858_ = _e2177;
                                } else {
                                    phi_3858_ = _e2201;
                                }
                                let _e2204 = phi_3858_;
                                let _e2206 = local_2.member_3;
                                let _e2210 = local_2.member_2[0u];
                                if (_e2210[0] < 0f) {
                                    phi_3875_ = -(_e2210[0]);
                                } else {
                                    phi_3875_ = _e2210[0];
                                }
                                let _e2217 = phi_3875_;
                                if (_e2210[1] < 0f) {
                                    phi_3882_ = -(_e2210[1]);
                                } else {
                                    phi_3882_ = _e2210[1];
                                }
                                let _e2221 = phi_3882_;
                                if (_e2217 > _e2221) {
                                    phi_3887_ = _e2217;
                                } else {
                                    phi_3887_ = _e2221;
                                }
                                let _e2224 = phi_3887_;
                                if (_e2210[2] < 0f) {
                                    phi_3894_ = -(_e2210[2]);
                                } else {
                                    phi_3894_ = _e2210[2];
                                }
                                let _e2228 = phi_3894_;
                                if (_e2224 > _e2228) {
                                    phi_3899_ = _e2224;
                                } else {
                                    phi_3899_ = _e2228;
                                }
                                let _e2231 = phi_3899_;
                                let _e2234 = local_2.member_2[1u];
                                if (_e2234[0] < 0f) {
                                    phi_3913_ = -(_e2234[0]);
                                } else {
                                    phi_3913_ = _e2234[0];
                                }
                                let _e2241 = phi_3913_;
                                if (_e2234[1] < 0f) {
                                    phi_3920_ = -(_e2234[1]);
                                } else {
                                    phi_3920_ = _e2234[1];
                                }
                                let _e2245 = phi_3920_;
                                if (_e2241 > _e2245) {
                                    phi_3925_ = _e2241;
                                } else {
                                    phi_3925_ = _e2245;
                                }
                                let _e2248 = phi_3925_;
                                if (_e2234[2] < 0f) {
                                    phi_3932_ = -(_e2234[2]);
                                } else {
                                    phi_3932_ = _e2234[2];
                                }
                                let _e2252 = phi_3932_;
                                if (_e2248 > _e2252) {
                                    phi_3937_ = _e2248;
                                } else {
                                    phi_3937_ = _e2252;
                                }
                                let _e2255 = phi_3937_;
                                if (_e2231 > _e2255) {
                                    phi_3942_ = _e2231;
                                } else {
                                    phi_3942_ = _e2255;
                                }
                                let _e2258 = phi_3942_;
                                let _e2260 = local_2.member_3;
                                let _e2263 = (((_e2150 + _e2152) + (_e2204 + _e2206)) + (_e2258 + _e2260));
                                let _e2266 = local_2.member_3;
                                let _e2270 = (((_e1494 * 1.0001f) + (_e2266 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2273 = ((_e2042 * _e2021) - (_e2045 * _e2020));
                                let _e2276 = ((_e2045 * _e2019) - (_e2039 * _e2021));
                                let _e2279 = ((_e2039 * _e2020) - (_e2042 * _e2019));
                                let _e2284 = (((_e2273 * _e2048[0]) + (_e2276 * _e2048[1])) + (_e2279 * _e2048[2]));
                                let _e2289 = (((_e2273 * _e2064) + (_e2276 * _e2065)) + (_e2279 * _e2066));
                                let _e2294 = (((_e2273 * _e2070) + (_e2276 * _e2071)) + (_e2279 * _e2072));
                                let _e2299 = (((_e2273 * _e2067) + (_e2276 * _e2068)) + (_e2279 * _e2069));
                                let _e2304 = (((_e2273 * _e2075[0]) + (_e2276 * _e2075[1])) + (_e2279 * _e2075[2]));
                                let _e2309 = (((_e2273 * _e2091) + (_e2276 * _e2092)) + (_e2279 * _e2093));
                                let _e2314 = (((_e2273 * _e2097) + (_e2276 * _e2098)) + (_e2279 * _e2099));
                                let _e2319 = (((_e2273 * _e2094) + (_e2276 * _e2095)) + (_e2279 * _e2096));
                                if (_e2284 < _e2289) {
                                    phi_4020_ = _e2284;
                                } else {
                                    phi_4020_ = _e2289;
                                }
                                let _e2322 = phi_4020_;
                                if (_e2294 < _e2299) {
                                    phi_4025_ = _e2294;
                                } else {
                                    phi_4025_ = _e2299;
                                }
                                let _e2325 = phi_4025_;
                                if (_e2322 < _e2325) {
                                    phi_4030_ = _e2322;
                                } else {
                                    phi_4030_ = _e2325;
                                }
                                let _e2328 = phi_4030_;
                                if (_e2304 < _e2309) {
                                    phi_4035_ = _e2304;
                                } else {
                                    phi_4035_ = _e2309;
                                }
                                let _e2331 = phi_4035_;
                                if (_e2314 < _e2319) {
                                    phi_4040_ = _e2314;
                                } else {
                                    phi_4040_ = _e2319;
                                }
                                let _e2334 = phi_4040_;
                                if (_e2331 < _e2334) {
                                    phi_4045_ = _e2331;
                                } else {
                                    phi_4045_ = _e2334;
                                }
                                let _e2337 = phi_4045_;
                                if (_e2328 < _e2337) {
                                    phi_4050_ = _e2328;
                                } else {
                                    phi_4050_ = _e2337;
                                }
                                let _e2340 = phi_4050_;
                                if (_e2284 > _e2289) {
                                    phi_4055_ = _e2284;
                                } else {
                                    phi_4055_ = _e2289;
                                }
                                let _e2343 = phi_4055_;
                                if (_e2294 > _e2299) {
                                    phi_4060_ = _e2294;
                                } else {
                                    phi_4060_ = _e2299;
                                }
                                let _e2346 = phi_4060_;
                                if (_e2343 > _e2346) {
                                    phi_4065_ = _e2343;
                                } else {
                                    phi_4065_ = _e2346;
                                }
                                let _e2349 = phi_4065_;
                                if (_e2304 > _e2309) {
                                    phi_4070_ = _e2304;
                                } else {
                                    phi_4070_ = _e2309;
                                }
                                let _e2352 = phi_4070_;
                                if (_e2314 > _e2319) {
                                    phi_4075_ = _e2314;
                                } else {
                                    phi_4075_ = _e2319;
                                }
                                let _e2355 = phi_4075_;
                                if (_e2352 > _e2355) {
                                    phi_4080_ = _e2352;
                                } else {
                                    phi_4080_ = _e2355;
                                }
                                let _e2358 = phi_4080_;
                                if (_e2349 > _e2358) {
                                    phi_4085_ = _e2349;
                                } else {
                                    phi_4085_ = _e2358;
                                }
                                let _e2361 = phi_4085_;
                                if (_e2273 < 0f) {
                                    phi_4091_ = -(_e2273);
                                } else {
                                    phi_4091_ = _e2273;
                                }
                                let _e2365 = phi_4091_;
                                if (_e2276 < 0f) {
                                    phi_4097_ = -(_e2276);
                                } else {
                                    phi_4097_ = _e2276;
                                }
                                let _e2369 = phi_4097_;
                                if (_e2279 < 0f) {
                                    phi_4104_ = -(_e2279);
                                } else {
                                    phi_4104_ = _e2279;
                                }
                                let _e2374 = phi_4104_;
                                let _e2375 = ((_e2365 + _e2369) + _e2374);
                                let _e2379 = -(_e2361);
                                if (_e2340 > _e2379) {
                                    phi_4114_ = _e2340;
                                } else {
                                    phi_4114_ = _e2379;
                                }
                                let _e2382 = phi_4114_;
                                let _e2387 = (((_e2382 - ((_e2375 * _e2263) * (0.000000059604645f * 17f))) - (_e2375 * _e2270)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2390 = ((_e2042 * _e2036) - (_e2045 * _e2035));
                                let _e2393 = ((_e2045 * _e2034) - (_e2039 * _e2036));
                                let _e2396 = ((_e2039 * _e2035) - (_e2042 * _e2034));
                                let _e2401 = (((_e2390 * _e2048[0]) + (_e2393 * _e2048[1])) + (_e2396 * _e2048[2]));
                                let _e2406 = (((_e2390 * _e2064) + (_e2393 * _e2065)) + (_e2396 * _e2066));
                                let _e2411 = (((_e2390 * _e2070) + (_e2393 * _e2071)) + (_e2396 * _e2072));
                                let _e2416 = (((_e2390 * _e2067) + (_e2393 * _e2068)) + (_e2396 * _e2069));
                                let _e2421 = (((_e2390 * _e2075[0]) + (_e2393 * _e2075[1])) + (_e2396 * _e2075[2]));
                                let _e2426 = (((_e2390 * _e2091) + (_e2393 * _e2092)) + (_e2396 * _e2093));
                                let _e2431 = (((_e2390 * _e2097) + (_e2393 * _e2098)) + (_e2396 * _e2099));
                                let _e2436 = (((_e2390 * _e2094) + (_e2393 * _e2095)) + (_e2396 * _e2096));
                                if (_e2401 < _e2406) {
                                    phi_4185_ = _e2401;
                                } else {
                                    phi_4185_ = _e2406;
                                }
                                let _e2439 = phi_4185_;
                                if (_e2411 < _e2416) {
                                    phi_4190_ = _e2411;
                                } else {
                                    phi_4190_ = _e2416;
                                }
                                let _e2442 = phi_4190_;
                                if (_e2439 < _e2442) {
                                    phi_4195_ = _e2439;
                                } else {
                                    phi_4195_ = _e2442;
                                }
                                let _e2445 = phi_4195_;
                                if (_e2421 < _e2426) {
                                    phi_4200_ = _e2421;
                                } else {
                                    phi_4200_ = _e2426;
                                }
                                let _e2448 = phi_4200_;
                                if (_e2431 < _e2436) {
                                    phi_4205_ = _e2431;
                                } else {
                                    phi_4205_ = _e2436;
                                }
                                let _e2451 = phi_4205_;
                                if (_e2448 < _e2451) {
                                    phi_4210_ = _e2448;
                                } else {
                                    phi_4210_ = _e2451;
                                }
                                let _e2454 = phi_4210_;
                                if (_e2445 < _e2454) {
                                    phi_4215_ = _e2445;
                                } else {
                                    phi_4215_ = _e2454;
                                }
                                let _e2457 = phi_4215_;
                                if (_e2401 > _e2406) {
                                    phi_4220_ = _e2401;
                                } else {
                                    phi_4220_ = _e2406;
                                }
                                let _e2460 = phi_4220_;
                                if (_e2411 > _e2416) {
                                    phi_4225_ = _e2411;
                                } else {
                                    phi_4225_ = _e2416;
                                }
                                let _e2463 = phi_4225_;
                                if (_e2460 > _e2463) {
                                    phi_4230_ = _e2460;
                                } else {
                                    phi_4230_ = _e2463;
                                }
                                let _e2466 = phi_4230_;
                                if (_e2421 > _e2426) {
                                    phi_4235_ = _e2421;
                                } else {
                                    phi_4235_ = _e2426;
                                }
                                let _e2469 = phi_4235_;
                                if (_e2431 > _e2436) {
                                    phi_4240_ = _e2431;
                                } else {
                                    phi_4240_ = _e2436;
                                }
                                let _e2472 = phi_4240_;
                                if (_e2469 > _e2472) {
                                    phi_4245_ = _e2469;
                                } else {
                                    phi_4245_ = _e2472;
                                }
                                let _e2475 = phi_4245_;
                                if (_e2466 > _e2475) {
                                    phi_4250_ = _e2466;
                                } else {
                                    phi_4250_ = _e2475;
                                }
                                let _e2478 = phi_4250_;
                                if (_e2390 < 0f) {
                                    phi_4256_ = -(_e2390);
                                } else {
                                    phi_4256_ = _e2390;
                                }
                                let _e2482 = phi_4256_;
                                if (_e2393 < 0f) {
                                    phi_4262_ = -(_e2393);
                                } else {
                                    phi_4262_ = _e2393;
                                }
                                let _e2486 = phi_4262_;
                                if (_e2396 < 0f) {
                                    phi_4269_ = -(_e2396);
                                } else {
                                    phi_4269_ = _e2396;
                                }
                                let _e2491 = phi_4269_;
                                let _e2492 = ((_e2482 + _e2486) + _e2491);
                                let _e2496 = -(_e2478);
                                if (_e2457 > _e2496) {
                                    phi_4279_ = _e2457;
                                } else {
                                    phi_4279_ = _e2496;
                                }
                                let _e2499 = phi_4279_;
                                let _e2504 = (((_e2499 - ((_e2492 * _e2263) * (0.000000059604645f * 17f))) - (_e2492 * _e2270)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2387 > _e2504) {
                                    phi_4289_ = _e2387;
                                } else {
                                    phi_4289_ = _e2504;
                                }
                                let _e2507 = phi_4289_;
                                phi_4469_ = (_e2507 > 0f);
                            }
                            let _e2510 = phi_4469_;
                            if _e2510 {
                                phi_7875_ = false;
                            } else {
                                let _e2513 = local_2.member[0u];
                                let _e2519 = local_2.member[1u];
                                let _e2526 = ((_e2513[0] + _e2519[0]) * 0.5f);
                                let _e2527 = ((_e2513[1] + _e2519[1]) * 0.5f);
                                let _e2528 = ((_e2513[2] + _e2519[2]) * 0.5f);
                                let _e2531 = local_2.member_1[0u];
                                let _e2537 = local_2.member_1[1u];
                                let _e2544 = ((_e2531[0] + _e2537[0]) * 0.5f);
                                let _e2545 = ((_e2531[1] + _e2537[1]) * 0.5f);
                                let _e2546 = ((_e2531[2] + _e2537[2]) * 0.5f);
                                let _e2549 = local_2.member_2[0u];
                                let _e2555 = local_2.member_2[1u];
                                let _e2562 = ((_e2549[0] + _e2555[0]) * 0.5f);
                                let _e2563 = ((_e2549[1] + _e2555[1]) * 0.5f);
                                let _e2564 = ((_e2549[2] + _e2555[2]) * 0.5f);
                                let _e2567 = local_2.member[0u];
                                let _e2570 = local_2.member_1[0u];
                                let _e2573 = local_2.member_2[0u];
                                let _e2575 = local_2.member_3;
                                let _e2578 = local_2.member[1u];
                                let _e2581 = local_2.member_1[1u];
                                let _e2584 = local_2.member_2[1u];
                                let _e2586 = local_2.member_3;
                                local = type_37(array<array<f32, 3>, 2>(_e2567, array<f32, 3>(_e2526, _e2527, _e2528)), array<array<f32, 3>, 2>(_e2570, array<f32, 3>(_e2544, _e2545, _e2546)), array<array<f32, 3>, 2>(_e2573, array<f32, 3>(_e2562, _e2563, _e2564)), _e2575);
                                local_1 = type_37(array<array<f32, 3>, 2>(array<f32, 3>(_e2526, _e2527, _e2528), _e2578), array<array<f32, 3>, 2>(array<f32, 3>(_e2544, _e2545, _e2546), _e2581), array<array<f32, 3>, 2>(array<f32, 3>(_e2562, _e2563, _e2564), _e2584), _e2586);
                                let _e2603 = local.member_1[0u];
                                let _e2609 = local.member_2[0u];
                                let _e2615 = ((_e2603[1] * _e2609[2]) - (_e2603[2] * _e2609[1]));
                                let _e2618 = ((_e2603[2] * _e2609[0]) - (_e2603[0] * _e2609[2]));
                                let _e2621 = ((_e2603[0] * _e2609[1]) - (_e2603[1] * _e2609[0]));
                                let _e2624 = local.member_1[1u];
                                let _e2630 = local.member_2[1u];
                                let _e2636 = ((_e2624[1] * _e2630[2]) - (_e2624[2] * _e2630[1]));
                                let _e2639 = ((_e2624[2] * _e2630[0]) - (_e2624[0] * _e2630[2]));
                                let _e2642 = ((_e2624[0] * _e2630[1]) - (_e2624[1] * _e2630[0]));
                                let _e2645 = local.member_1[0u];
                                let _e2651 = local.member_2[1u];
                                let _e2666 = local.member_1[1u];
                                let _e2672 = local.member_2[0u];
                                let _e2685 = (((_e2645[1] * _e2651[2]) - (_e2645[2] * _e2651[1])) + ((_e2666[1] * _e2672[2]) - (_e2666[2] * _e2672[1])));
                                let _e2686 = (((_e2645[2] * _e2651[0]) - (_e2645[0] * _e2651[2])) + ((_e2666[2] * _e2672[0]) - (_e2666[0] * _e2672[2])));
                                let _e2687 = (((_e2645[0] * _e2651[1]) - (_e2645[1] * _e2651[0])) + ((_e2666[0] * _e2672[1]) - (_e2666[1] * _e2672[0])));
                                let _e2690 = local.member[0u];
                                let _e2701 = local.member[1u];
                                let _e2712 = local.member[0u];
                                let _e2721 = ((((_e2701[0] * _e2615) + (_e2701[1] * _e2618)) + (_e2701[2] * _e2621)) + (((_e2712[0] * _e2685) + (_e2712[1] * _e2686)) + (_e2712[2] * _e2687)));
                                let _e2724 = local.member[0u];
                                let _e2735 = local.member[1u];
                                let _e2744 = ((((_e2724[0] * _e2636) + (_e2724[1] * _e2639)) + (_e2724[2] * _e2642)) + (((_e2735[0] * _e2685) + (_e2735[1] * _e2686)) + (_e2735[2] * _e2687)));
                                let _e2747 = local.member[1u];
                                let _e2758 = local.member[0u];
                                if (_e2758[0] < 0f) {
                                    phi_4921_ = -(_e2758[0]);
                                } else {
                                    phi_4921_ = _e2758[0];
                                }
                                let _e2765 = phi_4921_;
                                if (_e2758[1] < 0f) {
                                    phi_4928_ = -(_e2758[1]);
                                } else {
                                    phi_4928_ = _e2758[1];
                                }
                                let _e2769 = phi_4928_;
                                if (_e2765 > _e2769) {
                                    phi_4933_ = _e2765;
                                } else {
                                    phi_4933_ = _e2769;
                                }
                                let _e2772 = phi_4933_;
                                if (_e2758[2] < 0f) {
                                    phi_4940_ = -(_e2758[2]);
                                } else {
                                    phi_4940_ = _e2758[2];
                                }
                                let _e2776 = phi_4940_;
                                if (_e2772 > _e2776) {
                                    phi_4945_ = _e2772;
                                } else {
                                    phi_4945_ = _e2776;
                                }
                                let _e2779 = phi_4945_;
                                let _e2782 = local.member[1u];
                                if (_e2782[0] < 0f) {
                                    phi_4958_ = -(_e2782[0]);
                                } else {
                                    phi_4958_ = _e2782[0];
                                }
                                let _e2789 = phi_4958_;
                                if (_e2782[1] < 0f) {
                                    phi_4965_ = -(_e2782[1]);
                                } else {
                                    phi_4965_ = _e2782[1];
                                }
                                let _e2793 = phi_4965_;
                                if (_e2789 > _e2793) {
                                    phi_4970_ = _e2789;
                                } else {
                                    phi_4970_ = _e2793;
                                }
                                let _e2796 = phi_4970_;
                                if (_e2782[2] < 0f) {
                                    phi_4977_ = -(_e2782[2]);
                                } else {
                                    phi_4977_ = _e2782[2];
                                }
                                let _e2800 = phi_4977_;
                                if (_e2796 > _e2800) {
                                    phi_4982_ = _e2796;
                                } else {
                                    phi_4982_ = _e2800;
                                }
                                let _e2803 = phi_4982_;
                                if (_e2779 > _e2803) {
                                    phi_4987_ = _e2779;
                                } else {
                                    phi_4987_ = _e2803;
                                }
                                let _e2806 = phi_4987_;
                                let _e2808 = local.member_3;
                                let _e2809 = (_e2806 + _e2808);
                                let _e2812 = local.member_1[0u];
                                if (_e2812[0] < 0f) {
                                    phi_5004_ = -(_e2812[0]);
                                } else {
                                    phi_5004_ = _e2812[0];
                                }
                                let _e2819 = phi_5004_;
                                if (_e2812[1] < 0f) {
                                    phi_5011_ = -(_e2812[1]);
                                } else {
                                    phi_5011_ = _e2812[1];
                                }
                                let _e2823 = phi_5011_;
                                if (_e2819 > _e2823) {
                                    phi_5016_ = _e2819;
                                } else {
                                    phi_5016_ = _e2823;
                                }
                                let _e2826 = phi_5016_;
                                if (_e2812[2] < 0f) {
                                    phi_5023_ = -(_e2812[2]);
                                } else {
                                    phi_5023_ = _e2812[2];
                                }
                                let _e2830 = phi_5023_;
                                if (_e2826 > _e2830) {
                                    phi_5028_ = _e2826;
                                } else {
                                    phi_5028_ = _e2830;
                                }
                                let _e2833 = phi_5028_;
                                let _e2836 = local.member_1[1u];
                                if (_e2836[0] < 0f) {
                                    phi_5042_ = -(_e2836[0]);
                                } else {
                                    phi_5042_ = _e2836[0];
                                }
                                let _e2843 = phi_5042_;
                                if (_e2836[1] < 0f) {
                                    phi_5049_ = -(_e2836[1]);
                                } else {
                                    phi_5049_ = _e2836[1];
                                }
                                let _e2847 = phi_5049_;
                                if (_e2843 > _e2847) {
                                    phi_5054_ = _e2843;
                                } else {
                                    phi_5054_ = _e2847;
                                }
                                let _e2850 = phi_5054_;
                                if (_e2836[2] < 0f) {
                                    phi_5061_ = -(_e2836[2]);
                                } else {
                                    phi_5061_ = _e2836[2];
                                }
                                let _e2854 = phi_5061_;
                                if (_e2850 > _e2854) {
                                    phi_5066_ = _e2850;
                                } else {
                                    phi_5066_ = _e2854;
                                }
                                let _e2857 = phi_5066_;
                                if (_e2833 > _e2857) {
                                    phi_5071_ = _e2833;
                                } else {
                                    phi_5071_ = _e2857;
                                }
                                let _e2860 = phi_5071_;
                                let _e2862 = local.member_3;
                                let _e2863 = (_e2860 + _e2862);
                                let _e2866 = local.member_2[0u];
                                if (_e2866[0] < 0f) {
                                    phi_5088_ = -(_e2866[0]);
                                } else {
                                    phi_5088_ = _e2866[0];
                                }
                                let _e2873 = phi_5088_;
                                if (_e2866[1] < 0f) {
                                    phi_5095_ = -(_e2866[1]);
                                } else {
                                    phi_5095_ = _e2866[1];
                                }
                                let _e2877 = phi_5095_;
                                if (_e2873 > _e2877) {
                                    phi_5100_ = _e2873;
                                } else {
                                    phi_5100_ = _e2877;
                                }
                                let _e2880 = phi_5100_;
                                if (_e2866[2] < 0f) {
                                    phi_5107_ = -(_e2866[2]);
                                } else {
                                    phi_5107_ = _e2866[2];
                                }
                                let _e2884 = phi_5107_;
                                if (_e2880 > _e2884) {
                                    phi_5112_ = _e2880;
                                } else {
                                    phi_5112_ = _e2884;
                                }
                                let _e2887 = phi_5112_;
                                let _e2890 = local.member_2[1u];
                                if (_e2890[0] < 0f) {
                                    phi_5126_ = -(_e2890[0]);
                                } else {
                                    phi_5126_ = _e2890[0];
                                }
                                let _e2897 = phi_5126_;
                                if (_e2890[1] < 0f) {
                                    phi_5133_ = -(_e2890[1]);
                                } else {
                                    phi_5133_ = _e2890[1];
                                }
                                let _e2901 = phi_5133_;
                                if (_e2897 > _e2901) {
                                    phi_5138_ = _e2897;
                                } else {
                                    phi_5138_ = _e2901;
                                }
                                let _e2904 = phi_5138_;
                                if (_e2890[2] < 0f) {
                                    phi_5145_ = -(_e2890[2]);
                                } else {
                                    phi_5145_ = _e2890[2];
                                }
                                let _e2908 = phi_5145_;
                                if (_e2904 > _e2908) {
                                    phi_5150_ = _e2904;
                                } else {
                                    phi_5150_ = _e2908;
                                }
                                let _e2911 = phi_5150_;
                                if (_e2887 > _e2911) {
                                    phi_5155_ = _e2887;
                                } else {
                                    phi_5155_ = _e2911;
                                }
                                let _e2914 = phi_5155_;
                                let _e2916 = local.member_3;
                                let _e2917 = (_e2914 + _e2916);
                                let _e2919 = ((_e2863 * 8f) * _e2917);
                                let _e2926 = local.member_3;
                                if (_e2615 < 0f) {
                                    phi_5186_ = -(_e2615);
                                } else {
                                    phi_5186_ = _e2615;
                                }
                                let _e2943 = phi_5186_;
                                if (_e2618 < 0f) {
                                    phi_5192_ = -(_e2618);
                                } else {
                                    phi_5192_ = _e2618;
                                }
                                let _e2947 = phi_5192_;
                                if (_e2621 < 0f) {
                                    phi_5199_ = -(_e2621);
                                } else {
                                    phi_5199_ = _e2621;
                                }
                                let _e2952 = phi_5199_;
                                let _e2953 = ((_e2943 + _e2947) + _e2952);
                                if (_e2636 < 0f) {
                                    phi_5206_ = -(_e2636);
                                } else {
                                    phi_5206_ = _e2636;
                                }
                                let _e2957 = phi_5206_;
                                if (_e2639 < 0f) {
                                    phi_5212_ = -(_e2639);
                                } else {
                                    phi_5212_ = _e2639;
                                }
                                let _e2961 = phi_5212_;
                                if (_e2642 < 0f) {
                                    phi_5219_ = -(_e2642);
                                } else {
                                    phi_5219_ = _e2642;
                                }
                                let _e2966 = phi_5219_;
                                let _e2967 = ((_e2957 + _e2961) + _e2966);
                                if (_e2953 > _e2967) {
                                    phi_5225_ = _e2953;
                                } else {
                                    phi_5225_ = _e2967;
                                }
                                let _e2970 = phi_5225_;
                                if (_e2685 < 0f) {
                                    phi_5231_ = -(_e2685);
                                } else {
                                    phi_5231_ = _e2685;
                                }
                                let _e2974 = phi_5231_;
                                if (_e2686 < 0f) {
                                    phi_5237_ = -(_e2686);
                                } else {
                                    phi_5237_ = _e2686;
                                }
                                let _e2978 = phi_5237_;
                                if (_e2687 < 0f) {
                                    phi_5244_ = -(_e2687);
                                } else {
                                    phi_5244_ = _e2687;
                                }
                                let _e2983 = phi_5244_;
                                let _e2985 = (((_e2974 + _e2978) + _e2983) * 0.5f);
                                if (_e2970 > _e2985) {
                                    phi_5251_ = _e2970;
                                } else {
                                    phi_5251_ = _e2985;
                                }
                                let _e2988 = phi_5251_;
                                let _e2993 = local.member_3;
                                let _e3006 = ((((_e2690[0] * _e2615) + (_e2690[1] * _e2618)) + (_e2690[2] * _e2621)) * 3f);
                                let _e3007 = ((((_e2747[0] * _e2636) + (_e2747[1] * _e2639)) + (_e2747[2] * _e2642)) * 3f);
                                if (_e3006 < _e3007) {
                                    phi_5275_ = _e3006;
                                } else {
                                    phi_5275_ = _e3007;
                                }
                                let _e3010 = phi_5275_;
                                if (_e2721 < _e2744) {
                                    phi_5280_ = _e2721;
                                } else {
                                    phi_5280_ = _e2744;
                                }
                                let _e3013 = phi_5280_;
                                if (_e3010 < _e3013) {
                                    phi_5285_ = _e3010;
                                } else {
                                    phi_5285_ = _e3013;
                                }
                                let _e3016 = phi_5285_;
                                if (_e3006 > _e3007) {
                                    phi_5290_ = _e3006;
                                } else {
                                    phi_5290_ = _e3007;
                                }
                                let _e3019 = phi_5290_;
                                if (_e2721 > _e2744) {
                                    phi_5295_ = _e2721;
                                } else {
                                    phi_5295_ = _e2744;
                                }
                                let _e3022 = phi_5295_;
                                if (_e3019 > _e3022) {
                                    phi_5300_ = _e3019;
                                } else {
                                    phi_5300_ = _e3022;
                                }
                                let _e3025 = phi_5300_;
                                let _e3030 = -(_e3025);
                                if (_e3016 > _e3030) {
                                    phi_5310_ = _e3016;
                                } else {
                                    phi_5310_ = _e3030;
                                }
                                let _e3033 = phi_5310_;
                                if ((_e3033 - ((((((_e2809 * 8f) * _e2919) * (0.000000059604645f * (490f / 64f))) + ((_e2926 * 19f) * ((_e2809 * (_e2863 + _e2917)) + (_e2863 * _e2917)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2809) * ((1f + _e2863) * (1f + _e2917))))) + ((_e1494 * (((_e2988 + (_e2919 * (0.000000059604645f * 4f))) + ((_e2993 * 6f) * (_e2863 + _e2917))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2863) * (1f + _e2917))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6274_ = true;
                                } else {
                                    let _e3038 = local.member_1[0u];
                                    let _e3044 = local.member_1[1u];
                                    let _e3048 = (_e3038[0] + _e3044[0]);
                                    let _e3049 = (_e3038[1] + _e3044[1]);
                                    let _e3050 = (_e3038[2] + _e3044[2]);
                                    let _e3053 = local.member_2[0u];
                                    let _e3059 = local.member_2[1u];
                                    let _e3063 = (_e3053[0] + _e3059[0]);
                                    let _e3064 = (_e3053[1] + _e3059[1]);
                                    let _e3065 = (_e3053[2] + _e3059[2]);
                                    let _e3068 = ((_e3049 * _e3065) - (_e3050 * _e3064));
                                    let _e3071 = ((_e3050 * _e3063) - (_e3048 * _e3065));
                                    let _e3074 = ((_e3048 * _e3064) - (_e3049 * _e3063));
                                    let _e3077 = local.member[0u];
                                    let _e3083 = local.member_1[0u];
                                    let _e3089 = local.member_2[0u];
                                    let _e3093 = (_e3077[0] - _e3083[0]);
                                    let _e3094 = (_e3077[1] - _e3083[1]);
                                    let _e3095 = (_e3077[2] - _e3083[2]);
                                    let _e3096 = (_e3093 - _e3089[0]);
                                    let _e3097 = (_e3094 - _e3089[1]);
                                    let _e3098 = (_e3095 - _e3089[2]);
                                    let _e3099 = (_e3077[0] - _e3089[0]);
                                    let _e3100 = (_e3077[1] - _e3089[1]);
                                    let _e3101 = (_e3077[2] - _e3089[2]);
                                    let _e3104 = local.member[1u];
                                    let _e3110 = local.member_1[1u];
                                    let _e3116 = local.member_2[1u];
                                    let _e3120 = (_e3104[0] - _e3110[0]);
                                    let _e3121 = (_e3104[1] - _e3110[1]);
                                    let _e3122 = (_e3104[2] - _e3110[2]);
                                    let _e3123 = (_e3120 - _e3116[0]);
                                    let _e3124 = (_e3121 - _e3116[1]);
                                    let _e3125 = (_e3122 - _e3116[2]);
                                    let _e3126 = (_e3104[0] - _e3116[0]);
                                    let _e3127 = (_e3104[1] - _e3116[1]);
                                    let _e3128 = (_e3104[2] - _e3116[2]);
                                    let _e3131 = local.member[0u];
                                    if (_e3131[0] < 0f) {
                                        phi_5513_ = -(_e3131[0]);
                                    } else {
                                        phi_5513_ = _e3131[0];
                                    }
                                    let _e3138 = phi_5513_;
                                    if (_e3131[1] < 0f) {
                                        phi_5520_ = -(_e3131[1]);
                                    } else {
                                        phi_5520_ = _e3131[1];
                                    }
                                    let _e3142 = phi_5520_;
                                    if (_e3138 > _e3142) {
                                        phi_5525_ = _e3138;
                                    } else {
                                        phi_5525_ = _e3142;
                                    }
                                    let _e3145 = phi_5525_;
                                    if (_e3131[2] < 0f) {
                                        phi_5532_ = -(_e3131[2]);
                                    } else {
                                        phi_5532_ = _e3131[2];
                                    }
                                    let _e3149 = phi_5532_;
                                    if (_e3145 > _e3149) {
                                        phi_5537_ = _e3145;
                                    } else {
                                        phi_5537_ = _e3149;
                                    }
                                    let _e3152 = phi_5537_;
                                    let _e3155 = local.member[1u];
                                    if (_e3155[0] < 0f) {
                                        phi_5550_ = -(_e3155[0]);
                                    } else {
                                        phi_5550_ = _e3155[0];
                                    }
                                    let _e3162 = phi_5550_;
                                    if (_e3155[1] < 0f) {
                                        phi_5557_ = -(_e3155[1]);
                                    } else {
                                        phi_5557_ = _e3155[1];
                                    }
                                    let _e3166 = phi_5557_;
                                    if (_e3162 > _e3166) {
                                        phi_5562_ = _e3162;
                                    } else {
                                        phi_5562_ = _e3166;
                                    }
                                    let _e3169 = phi_5562_;
                                    if (_e3155[2] < 0f) {
                                        phi_5569_ = -(_e3155[2]);
                                    } else {
                                        phi_5569_ = _e3155[2];
                                    }
                                    let _e3173 = phi_5569_;
                                    if (_e3169 > _e3173) {
                                        phi_5574_ = _e3169;
                                    } else {
                                        phi_5574_ = _e3173;
                                    }
                                    let _e3176 = phi_5574_;
                                    if (_e3152 > _e3176) {
                                        phi_5579_ = _e3152;
                                    } else {
                                        phi_5579_ = _e3176;
                                    }
                                    let _e3179 = phi_5579_;
                                    let _e3181 = local.member_3;
                                    let _e3185 = local.member_1[0u];
                                    if (_e3185[0] < 0f) {
                                        phi_5596_ = -(_e3185[0]);
                                    } else {
                                        phi_5596_ = _e3185[0];
                                    }
                                    let _e3192 = phi_5596_;
                                    if (_e3185[1] < 0f) {
                                        phi_5603_ = -(_e3185[1]);
                                    } else {
                                        phi_5603_ = _e3185[1];
                                    }
                                    let _e3196 = phi_5603_;
                                    if (_e3192 > _e3196) {
                                        phi_5608_ = _e3192;
                                    } else {
                                        phi_5608_ = _e3196;
                                    }
                                    let _e3199 = phi_5608_;
                                    if (_e3185[2] < 0f) {
                                        phi_5615_ = -(_e3185[2]);
                                    } else {
                                        phi_5615_ = _e3185[2];
                                    }
                                    let _e3203 = phi_5615_;
                                    if (_e3199 > _e3203) {
                                        phi_5620_ = _e3199;
                                    } else {
                                        phi_5620_ = _e3203;
                                    }
                                    let _e3206 = phi_5620_;
                                    let _e3209 = local.member_1[1u];
                                    if (_e3209[0] < 0f) {
                                        phi_5634_ = -(_e3209[0]);
                                    } else {
                                        phi_5634_ = _e3209[0];
                                    }
                                    let _e3216 = phi_5634_;
                                    if (_e3209[1] < 0f) {
                                        phi_5641_ = -(_e3209[1]);
                                    } else {
                                        phi_5641_ = _e3209[1];
                                    }
                                    let _e3220 = phi_5641_;
                                    if (_e3216 > _e3220) {
                                        phi_5646_ = _e3216;
                                    } else {
                                        phi_5646_ = _e3220;
                                    }
                                    let _e3223 = phi_5646_;
                                    if (_e3209[2] < 0f) {
                                        phi_5653_ = -(_e3209[2]);
                                    } else {
                                        phi_5653_ = _e3209[2];
                                    }
                                    let _e3227 = phi_5653_;
                                    if (_e3223 > _e3227) {
                                        phi_5658_ = _e3223;
                                    } else {
                                        phi_5658_ = _e3227;
                                    }
                                    let _e3230 = phi_5658_;
                                    if (_e3206 > _e3230) {
                                        phi_5663_ = _e3206;
                                    } else {
                                        phi_5663_ = _e3230;
                                    }
                                    let _e3233 = phi_5663_;
                                    let _e3235 = local.member_3;
                                    let _e3239 = local.member_2[0u];
                                    if (_e3239[0] < 0f) {
                                        phi_5680_ = -(_e3239[0]);
                                    } else {
                                        phi_5680_ = _e3239[0];
                                    }
                                    let _e3246 = phi_5680_;
                                    if (_e3239[1] < 0f) {
                                        phi_5687_ = -(_e3239[1]);
                                    } else {
                                        phi_5687_ = _e3239[1];
                                    }
                                    let _e3250 = phi_5687_;
                                    if (_e3246 > _e3250) {
                                        phi_5692_ = _e3246;
                                    } else {
                                        phi_5692_ = _e3250;
                                    }
                                    let _e3253 = phi_5692_;
                                    if (_e3239[2] < 0f) {
                                        phi_5699_ = -(_e3239[2]);
                                    } else {
                                        phi_5699_ = _e3239[2];
                                    }
                                    let _e3257 = phi_5699_;
                                    if (_e3253 > _e3257) {
                                        phi_5704_ = _e3253;
                                    } else {
                                        phi_5704_ = _e3257;
                                    }
                                    let _e3260 = phi_5704_;
                                    let _e3263 = local.member_2[1u];
                                    if (_e3263[0] < 0f) {
                                        phi_5718_ = -(_e3263[0]);
                                    } else {
                                        phi_5718_ = _e3263[0];
                                    }
                                    let _e3270 = phi_5718_;
                                    if (_e3263[1] < 0f) {
                                        phi_5725_ = -(_e3263[1]);
                                    } else {
                                        phi_5725_ = _e3263[1];
                                    }
                                    let _e3274 = phi_5725_;
                                    if (_e3270 > _e3274) {
                                        phi_5730_ = _e3270;
                                    } else {
                                        phi_5730_ = _e3274;
                                    }
                                    let _e3277 = phi_5730_;
                                    if (_e3263[2] < 0f) {
                                        phi_5737_ = -(_e3263[2]);
                                    } else {
                                        phi_5737_ = _e3263[2];
                                    }
                                    let _e3281 = phi_5737_;
                                    if (_e3277 > _e3281) {
                                        phi_5742_ = _e3277;
                                    } else {
                                        phi_5742_ = _e3281;
                                    }
                                    let _e3284 = phi_5742_;
                                    if (_e3260 > _e3284) {
                                        phi_5747_ = _e3260;
                                    } else {
                                        phi_5747_ = _e3284;
                                    }
                                    let _e3287 = phi_5747_;
                                    let _e3289 = local.member_3;
                                    let _e3292 = (((_e3179 + _e3181) + (_e3233 + _e3235)) + (_e3287 + _e3289));
                                    let _e3295 = local.member_3;
                                    let _e3299 = (((_e1494 * 1.0001f) + (_e3295 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3302 = ((_e3071 * _e3050) - (_e3074 * _e3049));
                                    let _e3305 = ((_e3074 * _e3048) - (_e3068 * _e3050));
                                    let _e3308 = ((_e3068 * _e3049) - (_e3071 * _e3048));
                                    let _e3313 = (((_e3302 * _e3077[0]) + (_e3305 * _e3077[1])) + (_e3308 * _e3077[2]));
                                    let _e3318 = (((_e3302 * _e3093) + (_e3305 * _e3094)) + (_e3308 * _e3095));
                                    let _e3323 = (((_e3302 * _e3099) + (_e3305 * _e3100)) + (_e3308 * _e3101));
                                    let _e3328 = (((_e3302 * _e3096) + (_e3305 * _e3097)) + (_e3308 * _e3098));
                                    let _e3333 = (((_e3302 * _e3104[0]) + (_e3305 * _e3104[1])) + (_e3308 * _e3104[2]));
                                    let _e3338 = (((_e3302 * _e3120) + (_e3305 * _e3121)) + (_e3308 * _e3122));
                                    let _e3343 = (((_e3302 * _e3126) + (_e3305 * _e3127)) + (_e3308 * _e3128));
                                    let _e3348 = (((_e3302 * _e3123) + (_e3305 * _e3124)) + (_e3308 * _e3125));
                                    if (_e3313 < _e3318) {
                                        phi_5825_ = _e3313;
                                    } else {
                                        phi_5825_ = _e3318;
                                    }
                                    let _e3351 = phi_5825_;
                                    if (_e3323 < _e3328) {
                                        phi_5830_ = _e3323;
                                    } else {
                                        phi_5830_ = _e3328;
                                    }
                                    let _e3354 = phi_5830_;
                                    if (_e3351 < _e3354) {
                                        phi_5835_ = _e3351;
                                    } else {
                                        phi_5835_ = _e3354;
                                    }
                                    let _e3357 = phi_5835_;
                                    if (_e3333 < _e3338) {
                                        phi_5840_ = _e3333;
                                    } else {
                                        phi_5840_ = _e3338;
                                    }
                                    let _e3360 = phi_5840_;
                                    if (_e3343 < _e3348) {
                                        phi_5845_ = _e3343;
                                    } else {
                                        phi_5845_ = _e3348;
                                    }
                                    let _e3363 = phi_5845_;
                                    if (_e3360 < _e3363) {
                                        phi_5850_ = _e3360;
                                    } else {
                                        phi_5850_ = _e3363;
                                    }
                                    let _e3366 = phi_5850_;
                                    if (_e3357 < _e3366) {
                                        phi_5855_ = _e3357;
                                    } else {
                                        phi_5855_ = _e3366;
                                    }
                                    let _e3369 = phi_5855_;
                                    if (_e3313 > _e3318) {
                                        phi_5860_ = _e3313;
                                    } else {
                                        phi_5860_ = _e3318;
                                    }
                                    let _e3372 = phi_5860_;
                                    if (_e3323 > _e3328) {
                                        phi_5865_ = _e3323;
                                    } else {
                                        phi_5865_ = _e3328;
                                    }
                                    let _e3375 = phi_5865_;
                                    if (_e3372 > _e3375) {
                                        phi_5870_ = _e3372;
                                    } else {
                                        phi_5870_ = _e3375;
                                    }
                                    let _e3378 = phi_5870_;
                                    if (_e3333 > _e3338) {
                                        phi_5875_ = _e3333;
                                    } else {
                                        phi_5875_ = _e3338;
                                    }
                                    let _e3381 = phi_5875_;
                                    if (_e3343 > _e3348) {
                                        phi_5880_ = _e3343;
                                    } else {
                                        phi_5880_ = _e3348;
                                    }
                                    let _e3384 = phi_5880_;
                                    if (_e3381 > _e3384) {
                                        phi_5885_ = _e3381;
                                    } else {
                                        phi_5885_ = _e3384;
                                    }
                                    let _e3387 = phi_5885_;
                                    if (_e3378 > _e3387) {
                                        phi_5890_ = _e3378;
                                    } else {
                                        phi_5890_ = _e3387;
                                    }
                                    let _e3390 = phi_5890_;
                                    if (_e3302 < 0f) {
                                        phi_5896_ = -(_e3302);
                                    } else {
                                        phi_5896_ = _e3302;
                                    }
                                    let _e3394 = phi_5896_;
                                    if (_e3305 < 0f) {
                                        phi_5902_ = -(_e3305);
                                    } else {
                                        phi_5902_ = _e3305;
                                    }
                                    let _e3398 = phi_5902_;
                                    if (_e3308 < 0f) {
                                        phi_5909_ = -(_e3308);
                                    } else {
                                        phi_5909_ = _e3308;
                                    }
                                    let _e3403 = phi_5909_;
                                    let _e3404 = ((_e3394 + _e3398) + _e3403);
                                    let _e3408 = -(_e3390);
                                    if (_e3369 > _e3408) {
                                        phi_5919_ = _e3369;
                                    } else {
                                        phi_5919_ = _e3408;
                                    }
                                    let _e3411 = phi_5919_;
                                    let _e3416 = (((_e3411 - ((_e3404 * _e3292) * (0.000000059604645f * 17f))) - (_e3404 * _e3299)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3419 = ((_e3071 * _e3065) - (_e3074 * _e3064));
                                    let _e3422 = ((_e3074 * _e3063) - (_e3068 * _e3065));
                                    let _e3425 = ((_e3068 * _e3064) - (_e3071 * _e3063));
                                    let _e3430 = (((_e3419 * _e3077[0]) + (_e3422 * _e3077[1])) + (_e3425 * _e3077[2]));
                                    let _e3435 = (((_e3419 * _e3093) + (_e3422 * _e3094)) + (_e3425 * _e3095));
                                    let _e3440 = (((_e3419 * _e3099) + (_e3422 * _e3100)) + (_e3425 * _e3101));
                                    let _e3445 = (((_e3419 * _e3096) + (_e3422 * _e3097)) + (_e3425 * _e3098));
                                    let _e3450 = (((_e3419 * _e3104[0]) + (_e3422 * _e3104[1])) + (_e3425 * _e3104[2]));
                                    let _e3455 = (((_e3419 * _e3120) + (_e3422 * _e3121)) + (_e3425 * _e3122));
                                    let _e3460 = (((_e3419 * _e3126) + (_e3422 * _e3127)) + (_e3425 * _e3128));
                                    let _e3465 = (((_e3419 * _e3123) + (_e3422 * _e3124)) + (_e3425 * _e3125));
                                    if (_e3430 < _e3435) {
                                        phi_5990_ = _e3430;
                                    } else {
                                        phi_5990_ = _e3435;
                                    }
                                    let _e3468 = phi_5990_;
                                    if (_e3440 < _e3445) {
                                        phi_5995_ = _e3440;
                                    } else {
                                        phi_5995_ = _e3445;
                                    }
                                    let _e3471 = phi_5995_;
                                    if (_e3468 < _e3471) {
                                        phi_6000_ = _e3468;
                                    } else {
                                        phi_6000_ = _e3471;
                                    }
                                    let _e3474 = phi_6000_;
                                    if (_e3450 < _e3455) {
                                        phi_6005_ = _e3450;
                                    } else {
                                        phi_6005_ = _e3455;
                                    }
                                    let _e3477 = phi_6005_;
                                    if (_e3460 < _e3465) {
                                        phi_6010_ = _e3460;
                                    } else {
                                        phi_6010_ = _e3465;
                                    }
                                    let _e3480 = phi_6010_;
                                    if (_e3477 < _e3480) {
                                        phi_6015_ = _e3477;
                                    } else {
                                        phi_6015_ = _e3480;
                                    }
                                    let _e3483 = phi_6015_;
                                    if (_e3474 < _e3483) {
                                        phi_6020_ = _e3474;
                                    } else {
                                        phi_6020_ = _e3483;
                                    }
                                    let _e3486 = phi_6020_;
                                    if (_e3430 > _e3435) {
                                        phi_6025_ = _e3430;
                                    } else {
                                        phi_6025_ = _e3435;
                                    }
                                    let _e3489 = phi_6025_;
                                    if (_e3440 > _e3445) {
                                        phi_6030_ = _e3440;
                                    } else {
                                        phi_6030_ = _e3445;
                                    }
                                    let _e3492 = phi_6030_;
                                    if (_e3489 > _e3492) {
                                        phi_6035_ = _e3489;
                                    } else {
                                        phi_6035_ = _e3492;
                                    }
                                    let _e3495 = phi_6035_;
                                    if (_e3450 > _e3455) {
                                        phi_6040_ = _e3450;
                                    } else {
                                        phi_6040_ = _e3455;
                                    }
                                    let _e3498 = phi_6040_;
                                    if (_e3460 > _e3465) {
                                        phi_6045_ = _e3460;
                                    } else {
                                        phi_6045_ = _e3465;
                                    }
                                    let _e3501 = phi_6045_;
                                    if (_e3498 > _e3501) {
                                        phi_6050_ = _e3498;
                                    } else {
                                        phi_6050_ = _e3501;
                                    }
                                    let _e3504 = phi_6050_;
                                    if (_e3495 > _e3504) {
                                        phi_6055_ = _e3495;
                                    } else {
                                        phi_6055_ = _e3504;
                                    }
                                    let _e3507 = phi_6055_;
                                    if (_e3419 < 0f) {
                                        phi_6061_ = -(_e3419);
                                    } else {
                                        phi_6061_ = _e3419;
                                    }
                                    let _e3511 = phi_6061_;
                                    if (_e3422 < 0f) {
                                        phi_6067_ = -(_e3422);
                                    } else {
                                        phi_6067_ = _e3422;
                                    }
                                    let _e3515 = phi_6067_;
                                    if (_e3425 < 0f) {
                                        phi_6074_ = -(_e3425);
                                    } else {
                                        phi_6074_ = _e3425;
                                    }
                                    let _e3520 = phi_6074_;
                                    let _e3521 = ((_e3511 + _e3515) + _e3520);
                                    let _e3525 = -(_e3507);
                                    if (_e3486 > _e3525) {
                                        phi_6084_ = _e3486;
                                    } else {
                                        phi_6084_ = _e3525;
                                    }
                                    let _e3528 = phi_6084_;
                                    let _e3533 = (((_e3528 - ((_e3521 * _e3292) * (0.000000059604645f * 17f))) - (_e3521 * _e3299)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3416 > _e3533) {
                                        phi_6094_ = _e3416;
                                    } else {
                                        phi_6094_ = _e3533;
                                    }
                                    let _e3536 = phi_6094_;
                                    phi_6274_ = (_e3536 > 0f);
                                }
                                let _e3539 = phi_6274_;
                                if _e3539 {
                                    let _e3542 = local_1.member_1[0u];
                                    let _e3548 = local_1.member_2[0u];
                                    let _e3554 = ((_e3542[1] * _e3548[2]) - (_e3542[2] * _e3548[1]));
                                    let _e3557 = ((_e3542[2] * _e3548[0]) - (_e3542[0] * _e3548[2]));
                                    let _e3560 = ((_e3542[0] * _e3548[1]) - (_e3542[1] * _e3548[0]));
                                    let _e3563 = local_1.member_1[1u];
                                    let _e3569 = local_1.member_2[1u];
                                    let _e3575 = ((_e3563[1] * _e3569[2]) - (_e3563[2] * _e3569[1]));
                                    let _e3578 = ((_e3563[2] * _e3569[0]) - (_e3563[0] * _e3569[2]));
                                    let _e3581 = ((_e3563[0] * _e3569[1]) - (_e3563[1] * _e3569[0]));
                                    let _e3584 = local_1.member_1[0u];
                                    let _e3590 = local_1.member_2[1u];
                                    let _e3605 = local_1.member_1[1u];
                                    let _e3611 = local_1.member_2[0u];
                                    let _e3624 = (((_e3584[1] * _e3590[2]) - (_e3584[2] * _e3590[1])) + ((_e3605[1] * _e3611[2]) - (_e3605[2] * _e3611[1])));
                                    let _e3625 = (((_e3584[2] * _e3590[0]) - (_e3584[0] * _e3590[2])) + ((_e3605[2] * _e3611[0]) - (_e3605[0] * _e3611[2])));
                                    let _e3626 = (((_e3584[0] * _e3590[1]) - (_e3584[1] * _e3590[0])) + ((_e3605[0] * _e3611[1]) - (_e3605[1] * _e3611[0])));
                                    let _e3629 = local_1.member[0u];
                                    let _e3640 = local_1.member[1u];
                                    let _e3651 = local_1.member[0u];
                                    let _e3660 = ((((_e3640[0] * _e3554) + (_e3640[1] * _e3557)) + (_e3640[2] * _e3560)) + (((_e3651[0] * _e3624) + (_e3651[1] * _e3625)) + (_e3651[2] * _e3626)));
                                    let _e3663 = local_1.member[0u];
                                    let _e3674 = local_1.member[1u];
                                    let _e3683 = ((((_e3663[0] * _e3575) + (_e3663[1] * _e3578)) + (_e3663[2] * _e3581)) + (((_e3674[0] * _e3624) + (_e3674[1] * _e3625)) + (_e3674[2] * _e3626)));
                                    let _e3686 = local_1.member[1u];
                                    let _e3697 = local_1.member[0u];
                                    if (_e3697[0] < 0f) {
                                        phi_6519_ = -(_e3697[0]);
                                    } else {
                                        phi_6519_ = _e3697[0];
                                    }
                                    let _e3704 = phi_6519_;
                                    if (_e3697[1] < 0f) {
                                        phi_6526_ = -(_e3697[1]);
                                    } else {
                                        phi_6526_ = _e3697[1];
                                    }
                                    let _e3708 = phi_6526_;
                                    if (_e3704 > _e3708) {
                                        phi_6531_ = _e3704;
                                    } else {
                                        phi_6531_ = _e3708;
                                    }
                                    let _e3711 = phi_6531_;
                                    if (_e3697[2] < 0f) {
                                        phi_6538_ = -(_e3697[2]);
                                    } else {
                                        phi_6538_ = _e3697[2];
                                    }
                                    let _e3715 = phi_6538_;
                                    if (_e3711 > _e3715) {
                                        phi_6543_ = _e3711;
                                    } else {
                                        phi_6543_ = _e3715;
                                    }
                                    let _e3718 = phi_6543_;
                                    let _e3721 = local_1.member[1u];
                                    if (_e3721[0] < 0f) {
                                        phi_6556_ = -(_e3721[0]);
                                    } else {
                                        phi_6556_ = _e3721[0];
                                    }
                                    let _e3728 = phi_6556_;
                                    if (_e3721[1] < 0f) {
                                        phi_6563_ = -(_e3721[1]);
                                    } else {
                                        phi_6563_ = _e3721[1];
                                    }
                                    let _e3732 = phi_6563_;
                                    if (_e3728 > _e3732) {
                                        phi_6568_ = _e3728;
                                    } else {
                                        phi_6568_ = _e3732;
                                    }
                                    let _e3735 = phi_6568_;
                                    if (_e3721[2] < 0f) {
                                        phi_6575_ = -(_e3721[2]);
                                    } else {
                                        phi_6575_ = _e3721[2];
                                    }
                                    let _e3739 = phi_6575_;
                                    if (_e3735 > _e3739) {
                                        phi_6580_ = _e3735;
                                    } else {
                                        phi_6580_ = _e3739;
                                    }
                                    let _e3742 = phi_6580_;
                                    if (_e3718 > _e3742) {
                                        phi_6585_ = _e3718;
                                    } else {
                                        phi_6585_ = _e3742;
                                    }
                                    let _e3745 = phi_6585_;
                                    let _e3747 = local_1.member_3;
                                    let _e3748 = (_e3745 + _e3747);
                                    let _e3751 = local_1.member_1[0u];
                                    if (_e3751[0] < 0f) {
                                        phi_6602_ = -(_e3751[0]);
                                    } else {
                                        phi_6602_ = _e3751[0];
                                    }
                                    let _e3758 = phi_6602_;
                                    if (_e3751[1] < 0f) {
                                        phi_6609_ = -(_e3751[1]);
                                    } else {
                                        phi_6609_ = _e3751[1];
                                    }
                                    let _e3762 = phi_6609_;
                                    if (_e3758 > _e3762) {
                                        phi_6614_ = _e3758;
                                    } else {
                                        phi_6614_ = _e3762;
                                    }
                                    let _e3765 = phi_6614_;
                                    if (_e3751[2] < 0f) {
                                        phi_6621_ = -(_e3751[2]);
                                    } else {
                                        phi_6621_ = _e3751[2];
                                    }
                                    let _e3769 = phi_6621_;
                                    if (_e3765 > _e3769) {
                                        phi_6626_ = _e3765;
                                    } else {
                                        phi_6626_ = _e3769;
                                    }
                                    let _e3772 = phi_6626_;
                                    let _e3775 = local_1.member_1[1u];
                                    if (_e3775[0] < 0f) {
                                        phi_6640_ = -(_e3775[0]);
                                    } else {
                                        phi_6640_ = _e3775[0];
                                    }
                                    let _e3782 = phi_6640_;
                                    if (_e3775[1] < 0f) {
                                        phi_6647_ = -(_e3775[1]);
                                    } else {
                                        phi_6647_ = _e3775[1];
                                    }
                                    let _e3786 = phi_6647_;
                                    if (_e3782 > _e3786) {
                                        phi_6652_ = _e3782;
                                    } else {
                                        phi_6652_ = _e3786;
                                    }
                                    let _e3789 = phi_6652_;
                                    if (_e3775[2] < 0f) {
                                        phi_6659_ = -(_e3775[2]);
                                    } else {
                                        phi_6659_ = _e3775[2];
                                    }
                                    let _e3793 = phi_6659_;
                                    if (_e3789 > _e3793) {
                                        phi_6664_ = _e3789;
                                    } else {
                                        phi_6664_ = _e3793;
                                    }
                                    let _e3796 = phi_6664_;
                                    if (_e3772 > _e3796) {
                                        phi_6669_ = _e3772;
                                    } else {
                                        phi_6669_ = _e3796;
                                    }
                                    let _e3799 = phi_6669_;
                                    let _e3801 = local_1.member_3;
                                    let _e3802 = (_e3799 + _e3801);
                                    let _e3805 = local_1.member_2[0u];
                                    if (_e3805[0] < 0f) {
                                        phi_6686_ = -(_e3805[0]);
                                    } else {
                                        phi_6686_ = _e3805[0];
                                    }
                                    let _e3812 = phi_6686_;
                                    if (_e3805[1] < 0f) {
                                        phi_6693_ = -(_e3805[1]);
                                    } else {
                                        phi_6693_ = _e3805[1];
                                    }
                                    let _e3816 = phi_6693_;
                                    if (_e3812 > _e3816) {
                                        phi_6698_ = _e3812;
                                    } else {
                                        phi_6698_ = _e3816;
                                    }
                                    let _e3819 = phi_6698_;
                                    if (_e3805[2] < 0f) {
                                        phi_6705_ = -(_e3805[2]);
                                    } else {
                                        phi_6705_ = _e3805[2];
                                    }
                                    let _e3823 = phi_6705_;
                                    if (_e3819 > _e3823) {
                                        phi_6710_ = _e3819;
                                    } else {
                                        phi_6710_ = _e3823;
                                    }
                                    let _e3826 = phi_6710_;
                                    let _e3829 = local_1.member_2[1u];
                                    if (_e3829[0] < 0f) {
                                        phi_6724_ = -(_e3829[0]);
                                    } else {
                                        phi_6724_ = _e3829[0];
                                    }
                                    let _e3836 = phi_6724_;
                                    if (_e3829[1] < 0f) {
                                        phi_6731_ = -(_e3829[1]);
                                    } else {
                                        phi_6731_ = _e3829[1];
                                    }
                                    let _e3840 = phi_6731_;
                                    if (_e3836 > _e3840) {
                                        phi_6736_ = _e3836;
                                    } else {
                                        phi_6736_ = _e3840;
                                    }
                                    let _e3843 = phi_6736_;
                                    if (_e3829[2] < 0f) {
                                        phi_6743_ = -(_e3829[2]);
                                    } else {
                                        phi_6743_ = _e3829[2];
                                    }
                                    let _e3847 = phi_6743_;
                                    if (_e3843 > _e3847) {
                                        phi_6748_ = _e3843;
                                    } else {
                                        phi_6748_ = _e3847;
                                    }
                                    let _e3850 = phi_6748_;
                                    if (_e3826 > _e3850) {
                                        phi_6753_ = _e3826;
                                    } else {
                                        phi_6753_ = _e3850;
                                    }
                                    let _e3853 = phi_6753_;
                                    let _e3855 = local_1.member_3;
                                    let _e3856 = (_e3853 + _e3855);
                                    let _e3858 = ((_e3802 * 8f) * _e3856);
                                    let _e3865 = local_1.member_3;
                                    if (_e3554 < 0f) {
                                        phi_6784_ = -(_e3554);
                                    } else {
                                        phi_6784_ = _e3554;
                                    }
                                    let _e3882 = phi_6784_;
                                    if (_e3557 < 0f) {
                                        phi_6790_ = -(_e3557);
                                    } else {
                                        phi_6790_ = _e3557;
                                    }
                                    let _e3886 = phi_6790_;
                                    if (_e3560 < 0f) {
                                        phi_6797_ = -(_e3560);
                                    } else {
                                        phi_6797_ = _e3560;
                                    }
                                    let _e3891 = phi_6797_;
                                    let _e3892 = ((_e3882 + _e3886) + _e3891);
                                    if (_e3575 < 0f) {
                                        phi_6804_ = -(_e3575);
                                    } else {
                                        phi_6804_ = _e3575;
                                    }
                                    let _e3896 = phi_6804_;
                                    if (_e3578 < 0f) {
                                        phi_6810_ = -(_e3578);
                                    } else {
                                        phi_6810_ = _e3578;
                                    }
                                    let _e3900 = phi_6810_;
                                    if (_e3581 < 0f) {
                                        phi_6817_ = -(_e3581);
                                    } else {
                                        phi_6817_ = _e3581;
                                    }
                                    let _e3905 = phi_6817_;
                                    let _e3906 = ((_e3896 + _e3900) + _e3905);
                                    if (_e3892 > _e3906) {
                                        phi_6823_ = _e3892;
                                    } else {
                                        phi_6823_ = _e3906;
                                    }
                                    let _e3909 = phi_6823_;
                                    if (_e3624 < 0f) {
                                        phi_6829_ = -(_e3624);
                                    } else {
                                        phi_6829_ = _e3624;
                                    }
                                    let _e3913 = phi_6829_;
                                    if (_e3625 < 0f) {
                                        phi_6835_ = -(_e3625);
                                    } else {
                                        phi_6835_ = _e3625;
                                    }
                                    let _e3917 = phi_6835_;
                                    if (_e3626 < 0f) {
                                        phi_6842_ = -(_e3626);
                                    } else {
                                        phi_6842_ = _e3626;
                                    }
                                    let _e3922 = phi_6842_;
                                    let _e3924 = (((_e3913 + _e3917) + _e3922) * 0.5f);
                                    if (_e3909 > _e3924) {
                                        phi_6849_ = _e3909;
                                    } else {
                                        phi_6849_ = _e3924;
                                    }
                                    let _e3927 = phi_6849_;
                                    let _e3932 = local_1.member_3;
                                    let _e3945 = ((((_e3629[0] * _e3554) + (_e3629[1] * _e3557)) + (_e3629[2] * _e3560)) * 3f);
                                    let _e3946 = ((((_e3686[0] * _e3575) + (_e3686[1] * _e3578)) + (_e3686[2] * _e3581)) * 3f);
                                    if (_e3945 < _e3946) {
                                        phi_6873_ = _e3945;
                                    } else {
                                        phi_6873_ = _e3946;
                                    }
                                    let _e3949 = phi_6873_;
                                    if (_e3660 < _e3683) {
                                        phi_6878_ = _e3660;
                                    } else {
                                        phi_6878_ = _e3683;
                                    }
                                    let _e3952 = phi_6878_;
                                    if (_e3949 < _e3952) {
                                        phi_6883_ = _e3949;
                                    } else {
                                        phi_6883_ = _e3952;
                                    }
                                    let _e3955 = phi_6883_;
                                    if (_e3945 > _e3946) {
                                        phi_6888_ = _e3945;
                                    } else {
                                        phi_6888_ = _e3946;
                                    }
                                    let _e3958 = phi_6888_;
                                    if (_e3660 > _e3683) {
                                        phi_6893_ = _e3660;
                                    } else {
                                        phi_6893_ = _e3683;
                                    }
                                    let _e3961 = phi_6893_;
                                    if (_e3958 > _e3961) {
                                        phi_6898_ = _e3958;
                                    } else {
                                        phi_6898_ = _e3961;
                                    }
                                    let _e3964 = phi_6898_;
                                    let _e3969 = -(_e3964);
                                    if (_e3955 > _e3969) {
                                        phi_6908_ = _e3955;
                                    } else {
                                        phi_6908_ = _e3969;
                                    }
                                    let _e3972 = phi_6908_;
                                    if ((_e3972 - ((((((_e3748 * 8f) * _e3858) * (0.000000059604645f * (490f / 64f))) + ((_e3865 * 19f) * ((_e3748 * (_e3802 + _e3856)) + (_e3802 * _e3856)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3748) * ((1f + _e3802) * (1f + _e3856))))) + ((_e1494 * (((_e3927 + (_e3858 * (0.000000059604645f * 4f))) + ((_e3932 * 6f) * (_e3802 + _e3856))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3802) * (1f + _e3856))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_7872_ = true;
                                    } else {
                                        let _e3977 = local_1.member_1[0u];
                                        let _e3983 = local_1.member_1[1u];
                                        let _e3987 = (_e3977[0] + _e3983[0]);
                                        let _e3988 = (_e3977[1] + _e3983[1]);
                                        let _e3989 = (_e3977[2] + _e3983[2]);
                                        let _e3992 = local_1.member_2[0u];
                                        let _e3998 = local_1.member_2[1u];
                                        let _e4002 = (_e3992[0] + _e3998[0]);
                                        let _e4003 = (_e3992[1] + _e3998[1]);
                                        let _e4004 = (_e3992[2] + _e3998[2]);
                                        let _e4007 = ((_e3988 * _e4004) - (_e3989 * _e4003));
                                        let _e4010 = ((_e3989 * _e4002) - (_e3987 * _e4004));
                                        let _e4013 = ((_e3987 * _e4003) - (_e3988 * _e4002));
                                        let _e4016 = local_1.member[0u];
                                        let _e4022 = local_1.member_1[0u];
                                        let _e4028 = local_1.member_2[0u];
                                        let _e4032 = (_e4016[0] - _e4022[0]);
                                        let _e4033 = (_e4016[1] - _e4022[1]);
                                        let _e4034 = (_e4016[2] - _e4022[2]);
                                        let _e4035 = (_e4032 - _e4028[0]);
                                        let _e4036 = (_e4033 - _e4028[1]);
                                        let _e4037 = (_e4034 - _e4028[2]);
                                        let _e4038 = (_e4016[0] - _e4028[0]);
                                        let _e4039 = (_e4016[1] - _e4028[1]);
                                        let _e4040 = (_e4016[2] - _e4028[2]);
                                        let _e4043 = local_1.member[1u];
                                        let _e4049 = local_1.member_1[1u];
                                        let _e4055 = local_1.member_2[1u];
                                        let _e4059 = (_e4043[0] - _e4049[0]);
                                        let _e4060 = (_e4043[1] - _e4049[1]);
                                        let _e4061 = (_e4043[2] - _e4049[2]);
                                        let _e4062 = (_e4059 - _e4055[0]);
                                        let _e4063 = (_e4060 - _e4055[1]);
                                        let _e4064 = (_e4061 - _e4055[2]);
                                        let _e4065 = (_e4043[0] - _e4055[0]);
                                        let _e4066 = (_e4043[1] - _e4055[1]);
                                        let _e4067 = (_e4043[2] - _e4055[2]);
                                        let _e4070 = local_1.member[0u];
                                        if (_e4070[0] < 0f) {
                                            phi_7111_ = -(_e4070[0]);
                                        } else {
                                            phi_7111_ = _e4070[0];
                                        }
                                        let _e4077 = phi_7111_;
                                        if (_e4070[1] < 0f) {
                                            phi_7118_ = -(_e4070[1]);
                                        } else {
                                            phi_7118_ = _e4070[1];
                                        }
                                        let _e4081 = phi_7118_;
                                        if (_e4077 > _e4081) {
                                            phi_7123_ = _e4077;
                                        } else {
                                            phi_7123_ = _e4081;
                                        }
                                        let _e4084 = phi_7123_;
                                        if (_e4070[2] < 0f) {
                                            phi_7130_ = -(_e4070[2]);
                                        } else {
                                            phi_7130_ = _e4070[2];
                                        }
                                        let _e4088 = phi_7130_;
                                        if (_e4084 > _e4088) {
                                            phi_7135_ = _e4084;
                                        } else {
                                            phi_7135_ = _e4088;
                                        }
                                        let _e4091 = phi_7135_;
                                        let _e4094 = local_1.member[1u];
                                        if (_e4094[0] < 0f) {
                                            phi_7148_ = -(_e4094[0]);
                                        } else {
                                            phi_7148_ = _e4094[0];
                                        }
                                        let _e4101 = phi_7148_;
                                        if (_e4094[1] < 0f) {
                                            phi_7155_ = -(_e4094[1]);
                                        } else {
                                            phi_7155_ = _e4094[1];
                                        }
                                        let _e4105 = phi_7155_;
                                        if (_e4101 > _e4105) {
                                            phi_7160_ = _e4101;
                                        } else {
                                            phi_7160_ = _e4105;
                                        }
                                        let _e4108 = phi_7160_;
                                        if (_e4094[2] < 0f) {
                                            phi_7167_ = -(_e4094[2]);
                                        } else {
                                            phi_7167_ = _e4094[2];
                                        }
                                        let _e4112 = phi_7167_;
                                        if (_e4108 > _e4112) {
                                            phi_7172_ = _e4108;
                                        } else {
                                            phi_7172_ = _e4112;
                                        }
                                        let _e4115 = phi_7172_;
                                        if (_e4091 > _e4115) {
                                            phi_7177_ = _e4091;
                                        } else {
                                            phi_7177_ = _e4115;
                                        }
                                        let _e4118 = phi_7177_;
                                        let _e4120 = local_1.member_3;
                                        let _e4124 = local_1.member_1[0u];
                                        if (_e4124[0] < 0f) {
                                            phi_7194_ = -(_e4124[0]);
                                        } else {
                                            phi_7194_ = _e4124[0];
                                        }
                                        let _e4131 = phi_7194_;
                                        if (_e4124[1] < 0f) {
                                            phi_7201_ = -(_e4124[1]);
                                        } else {
                                            phi_7201_ = _e4124[1];
                                        }
                                        let _e4135 = phi_7201_;
                                        if (_e4131 > _e4135) {
                                            phi_7206_ = _e4131;
                                        } else {
                                            phi_7206_ = _e4135;
                                        }
                                        let _e4138 = phi_7206_;
                                        if (_e4124[2] < 0f) {
                                            phi_7213_ = -(_e4124[2]);
                                        } else {
                                            phi_7213_ = _e4124[2];
                                        }
                                        let _e4142 = phi_7213_;
                                        if (_e4138 > _e4142) {
                                            phi_7218_ = _e4138;
                                        } else {
                                            phi_7218_ = _e4142;
                                        }
                                        let _e4145 = phi_7218_;
                                        let _e4148 = local_1.member_1[1u];
                                        if (_e4148[0] < 0f) {
                                            phi_7232_ = -(_e4148[0]);
                                        } else {
                                            phi_7232_ = _e4148[0];
                                        }
                                        let _e4155 = phi_7232_;
                                        if (_e4148[1] < 0f) {
                                            phi_7239_ = -(_e4148[1]);
                                        } else {
                                            phi_7239_ = _e4148[1];
                                        }
                                        let _e4159 = phi_7239_;
                                        if (_e4155 > _e4159) {
                                            phi_7244_ = _e4155;
                                        } else {
                                            phi_7244_ = _e4159;
                                        }
                                        let _e4162 = phi_7244_;
                                        if (_e4148[2] < 0f) {
                                            phi_7251_ = -(_e4148[2]);
                                        } else {
                                            phi_7251_ = _e4148[2];
                                        }
                                        let _e4166 = phi_7251_;
                                        if (_e4162 > _e4166) {
                                            phi_7256_ = _e4162;
                                        } else {
                                            phi_7256_ = _e4166;
                                        }
                                        let _e4169 = phi_7256_;
                                        if (_e4145 > _e4169) {
                                            phi_7261_ = _e4145;
                                        } else {
                                            phi_7261_ = _e4169;
                                        }
                                        let _e4172 = phi_7261_;
                                        let _e4174 = local_1.member_3;
                                        let _e4178 = local_1.member_2[0u];
                                        if (_e4178[0] < 0f) {
                                            phi_7278_ = -(_e4178[0]);
                                        } else {
                                            phi_7278_ = _e4178[0];
                                        }
                                        let _e4185 = phi_7278_;
                                        if (_e4178[1] < 0f) {
                                            phi_7285_ = -(_e4178[1]);
                                        } else {
                                            phi_7285_ = _e4178[1];
                                        }
                                        let _e4189 = phi_7285_;
                                        if (_e4185 > _e4189) {
                                            phi_7290_ = _e4185;
                                        } else {
                                            phi_7290_ = _e4189;
                                        }
                                        let _e4192 = phi_7290_;
                                        if (_e4178[2] < 0f) {
                                            phi_7297_ = -(_e4178[2]);
                                        } else {
                                            phi_7297_ = _e4178[2];
                                        }
                                        let _e4196 = phi_7297_;
                                        if (_e4192 > _e4196) {
                                            phi_7302_ = _e4192;
                                        } else {
                                            phi_7302_ = _e4196;
                                        }
                                        let _e4199 = phi_7302_;
                                        let _e4202 = local_1.member_2[1u];
                                        if (_e4202[0] < 0f) {
                                            phi_7316_ = -(_e4202[0]);
                                        } else {
                                            phi_7316_ = _e4202[0];
                                        }
                                        let _e4209 = phi_7316_;
                                        if (_e4202[1] < 0f) {
                                            phi_7323_ = -(_e4202[1]);
                                        } else {
                                            phi_7323_ = _e4202[1];
                                        }
                                        let _e4213 = phi_7323_;
                                        if (_e4209 > _e4213) {
                                            phi_7328_ = _e4209;
                                        } else {
                                            phi_7328_ = _e4213;
                                        }
                                        let _e4216 = phi_7328_;
                                        if (_e4202[2] < 0f) {
                                            phi_7335_ = -(_e4202[2]);
                                        } else {
                                            phi_7335_ = _e4202[2];
                                        }
                                        let _e4220 = phi_7335_;
                                        if (_e4216 > _e4220) {
                                            phi_7340_ = _e4216;
                                        } else {
                                            phi_7340_ = _e4220;
                                        }
                                        let _e4223 = phi_7340_;
                                        if (_e4199 > _e4223) {
                                            phi_7345_ = _e4199;
                                        } else {
                                            phi_7345_ = _e4223;
                                        }
                                        let _e4226 = phi_7345_;
                                        let _e4228 = local_1.member_3;
                                        let _e4231 = (((_e4118 + _e4120) + (_e4172 + _e4174)) + (_e4226 + _e4228));
                                        let _e4234 = local_1.member_3;
                                        let _e4238 = (((_e1494 * 1.0001f) + (_e4234 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4241 = ((_e4010 * _e3989) - (_e4013 * _e3988));
                                        let _e4244 = ((_e4013 * _e3987) - (_e4007 * _e3989));
                                        let _e4247 = ((_e4007 * _e3988) - (_e4010 * _e3987));
                                        let _e4252 = (((_e4241 * _e4016[0]) + (_e4244 * _e4016[1])) + (_e4247 * _e4016[2]));
                                        let _e4257 = (((_e4241 * _e4032) + (_e4244 * _e4033)) + (_e4247 * _e4034));
                                        let _e4262 = (((_e4241 * _e4038) + (_e4244 * _e4039)) + (_e4247 * _e4040));
                                        let _e4267 = (((_e4241 * _e4035) + (_e4244 * _e4036)) + (_e4247 * _e4037));
                                        let _e4272 = (((_e4241 * _e4043[0]) + (_e4244 * _e4043[1])) + (_e4247 * _e4043[2]));
                                        let _e4277 = (((_e4241 * _e4059) + (_e4244 * _e4060)) + (_e4247 * _e4061));
                                        let _e4282 = (((_e4241 * _e4065) + (_e4244 * _e4066)) + (_e4247 * _e4067));
                                        let _e4287 = (((_e4241 * _e4062) + (_e4244 * _e4063)) + (_e4247 * _e4064));
                                        if (_e4252 < _e4257) {
                                            phi_7423_ = _e4252;
                                        } else {
                                            phi_7423_ = _e4257;
                                        }
                                        let _e4290 = phi_7423_;
                                        if (_e4262 < _e4267) {
                                            phi_7428_ = _e4262;
                                        } else {
                                            phi_7428_ = _e4267;
                                        }
                                        let _e4293 = phi_7428_;
                                        if (_e4290 < _e4293) {
                                            phi_7433_ = _e4290;
                                        } else {
                                            phi_7433_ = _e4293;
                                        }
                                        let _e4296 = phi_7433_;
                                        if (_e4272 < _e4277) {
                                            phi_7438_ = _e4272;
                                        } else {
                                            phi_7438_ = _e4277;
                                        }
                                        let _e4299 = phi_7438_;
                                        if (_e4282 < _e4287) {
                                            phi_7443_ = _e4282;
                                        } else {
                                            phi_7443_ = _e4287;
                                        }
                                        let _e4302 = phi_7443_;
                                        if (_e4299 < _e4302) {
                                            phi_7448_ = _e4299;
                                        } else {
                                            phi_7448_ = _e4302;
                                        }
                                        let _e4305 = phi_7448_;
                                        if (_e4296 < _e4305) {
                                            phi_7453_ = _e4296;
                                        } else {
                                            phi_7453_ = _e4305;
                                        }
                                        let _e4308 = phi_7453_;
                                        if (_e4252 > _e4257) {
                                            phi_7458_ = _e4252;
                                        } else {
                                            phi_7458_ = _e4257;
                                        }
                                        let _e4311 = phi_7458_;
                                        if (_e4262 > _e4267) {
                                            phi_7463_ = _e4262;
                                        } else {
                                            phi_7463_ = _e4267;
                                        }
                                        let _e4314 = phi_7463_;
                                        if (_e4311 > _e4314) {
                                            phi_7468_ = _e4311;
                                        } else {
                                            phi_7468_ = _e4314;
                                        }
                                        let _e4317 = phi_7468_;
                                        if (_e4272 > _e4277) {
                                            phi_7473_ = _e4272;
                                        } else {
                                            phi_7473_ = _e4277;
                                        }
                                        let _e4320 = phi_7473_;
                                        if (_e4282 > _e4287) {
                                            phi_7478_ = _e4282;
                                        } else {
                                            phi_7478_ = _e4287;
                                        }
                                        let _e4323 = phi_7478_;
                                        if (_e4320 > _e4323) {
                                            phi_7483_ = _e4320;
                                        } else {
                                            phi_7483_ = _e4323;
                                        }
                                        let _e4326 = phi_7483_;
                                        if (_e4317 > _e4326) {
                                            phi_7488_ = _e4317;
                                        } else {
                                            phi_7488_ = _e4326;
                                        }
                                        let _e4329 = phi_7488_;
                                        if (_e4241 < 0f) {
                                            phi_7494_ = -(_e4241);
                                        } else {
                                            phi_7494_ = _e4241;
                                        }
                                        let _e4333 = phi_7494_;
                                        if (_e4244 < 0f) {
                                            phi_7500_ = -(_e4244);
                                        } else {
                                            phi_7500_ = _e4244;
                                        }
                                        let _e4337 = phi_7500_;
                                        if (_e4247 < 0f) {
                                            phi_7507_ = -(_e4247);
                                        } else {
                                            phi_7507_ = _e4247;
                                        }
                                        let _e4342 = phi_7507_;
                                        let _e4343 = ((_e4333 + _e4337) + _e4342);
                                        let _e4347 = -(_e4329);
                                        if (_e4308 > _e4347) {
                                            phi_7517_ = _e4308;
                                        } else {
                                            phi_7517_ = _e4347;
                                        }
                                        let _e4350 = phi_7517_;
                                        let _e4355 = (((_e4350 - ((_e4343 * _e4231) * (0.000000059604645f * 17f))) - (_e4343 * _e4238)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4358 = ((_e4010 * _e4004) - (_e4013 * _e4003));
                                        let _e4361 = ((_e4013 * _e4002) - (_e4007 * _e4004));
                                        let _e4364 = ((_e4007 * _e4003) - (_e4010 * _e4002));
                                        let _e4369 = (((_e4358 * _e4016[0]) + (_e4361 * _e4016[1])) + (_e4364 * _e4016[2]));
                                        let _e4374 = (((_e4358 * _e4032) + (_e4361 * _e4033)) + (_e4364 * _e4034));
                                        let _e4379 = (((_e4358 * _e4038) + (_e4361 * _e4039)) + (_e4364 * _e4040));
                                        let _e4384 = (((_e4358 * _e4035) + (_e4361 * _e4036)) + (_e4364 * _e4037));
                                        let _e4389 = (((_e4358 * _e4043[0]) + (_e4361 * _e4043[1])) + (_e4364 * _e4043[2]));
                                        let _e4394 = (((_e4358 * _e4059) + (_e4361 * _e4060)) + (_e4364 * _e4061));
                                        let _e4399 = (((_e4358 * _e4065) + (_e4361 * _e4066)) + (_e4364 * _e4067));
                                        let _e4404 = (((_e4358 * _e4062) + (_e4361 * _e4063)) + (_e4364 * _e4064));
                                        if (_e4369 < _e4374) {
                                            phi_7588_ = _e4369;
                                        } else {
                                            phi_7588_ = _e4374;
                                        }
                                        let _e4407 = phi_7588_;
                                        if (_e4379 < _e4384) {
                                            phi_7593_ = _e4379;
                                        } else {
                                            phi_7593_ = _e4384;
                                        }
                                        let _e4410 = phi_7593_;
                                        if (_e4407 < _e4410) {
                                            phi_7598_ = _e4407;
                                        } else {
                                            phi_7598_ = _e4410;
                                        }
                                        let _e4413 = phi_7598_;
                                        if (_e4389 < _e4394) {
                                            phi_7603_ = _e4389;
                                        } else {
                                            phi_7603_ = _e4394;
                                        }
                                        let _e4416 = phi_7603_;
                                        if (_e4399 < _e4404) {
                                            phi_7608_ = _e4399;
                                        } else {
                                            phi_7608_ = _e4404;
                                        }
                                        let _e4419 = phi_7608_;
                                        if (_e4416 < _e4419) {
                                            phi_7613_ = _e4416;
                                        } else {
                                            phi_7613_ = _e4419;
                                        }
                                        let _e4422 = phi_7613_;
                                        if (_e4413 < _e4422) {
                                            phi_7618_ = _e4413;
                                        } else {
                                            phi_7618_ = _e4422;
                                        }
                                        let _e4425 = phi_7618_;
                                        if (_e4369 > _e4374) {
                                            phi_7623_ = _e4369;
                                        } else {
                                            phi_7623_ = _e4374;
                                        }
                                        let _e4428 = phi_7623_;
                                        if (_e4379 > _e4384) {
                                            phi_7628_ = _e4379;
                                        } else {
                                            phi_7628_ = _e4384;
                                        }
                                        let _e4431 = phi_7628_;
                                        if (_e4428 > _e4431) {
                                            phi_7633_ = _e4428;
                                        } else {
                                            phi_7633_ = _e4431;
                                        }
                                        let _e4434 = phi_7633_;
                                        if (_e4389 > _e4394) {
                                            phi_7638_ = _e4389;
                                        } else {
                                            phi_7638_ = _e4394;
                                        }
                                        let _e4437 = phi_7638_;
                                        if (_e4399 > _e4404) {
                                            phi_7643_ = _e4399;
                                        } else {
                                            phi_7643_ = _e4404;
                                        }
                                        let _e4440 = phi_7643_;
                                        if (_e4437 > _e4440) {
                                            phi_7648_ = _e4437;
                                        } else {
                                            phi_7648_ = _e4440;
                                        }
                                        let _e4443 = phi_7648_;
                                        if (_e4434 > _e4443) {
                                            phi_7653_ = _e4434;
                                        } else {
                                            phi_7653_ = _e4443;
                                        }
                                        let _e4446 = phi_7653_;
                                        if (_e4358 < 0f) {
                                            phi_7659_ = -(_e4358);
                                        } else {
                                            phi_7659_ = _e4358;
                                        }
                                        let _e4450 = phi_7659_;
                                        if (_e4361 < 0f) {
                                            phi_7665_ = -(_e4361);
                                        } else {
                                            phi_7665_ = _e4361;
                                        }
                                        let _e4454 = phi_7665_;
                                        if (_e4364 < 0f) {
                                            phi_7672_ = -(_e4364);
                                        } else {
                                            phi_7672_ = _e4364;
                                        }
                                        let _e4459 = phi_7672_;
                                        let _e4460 = ((_e4450 + _e4454) + _e4459);
                                        let _e4464 = -(_e4446);
                                        if (_e4425 > _e4464) {
                                            phi_7682_ = _e4425;
                                        } else {
                                            phi_7682_ = _e4464;
                                        }
                                        let _e4467 = phi_7682_;
                                        let _e4472 = (((_e4467 - ((_e4460 * _e4231) * (0.000000059604645f * 17f))) - (_e4460 * _e4238)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4355 > _e4472) {
                                            phi_7692_ = _e4355;
                                        } else {
                                            phi_7692_ = _e4472;
                                        }
                                        let _e4475 = phi_7692_;
                                        phi_7872_ = (_e4475 > 0f);
                                    }
                                    let _e4478 = phi_7872_;
                                    phi_7873_ = _e4478;
                                } else {
                                    phi_7873_ = false;
                                }
                                let _e4480 = phi_7873_;
                                phi_7875_ = !(_e4480);
                            }
                            let _e4483 = phi_7875_;
                            if _e4483 {
                                let _e4485 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1021] = ((2147483648u | (_e4485 << bitcast<u32>(12i))) | _e1024);
                            }
                        }
                        phi_7885_ = true;
                    }
                    let _e4492 = phi_7885_;
                    phi_7886_ = _e4492;
                } else {
                    phi_7886_ = false;
                }
                let _e4494 = phi_7886_;
                continue;
                continuing {
                    phi_1862_ = _e1013;
                    break if !(_e4494);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4498 = atomicLoad((&counters[5u]));
                if (_e4498 > 0u) {
                    let _e4501 = atomicAdd((&output.member[0u]), _e4498);
                    if ((_e4501 + _e4498) < _e4501) {
                        let _e4505 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4501);
                }
            }
            workgroupBarrier();
            let _e4508 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4511 = atomicLoad((&counters[7u]));
                if (_e4511 > 0u) {
                    let _e4514 = atomicAdd((&output.member[1u]), _e4511);
                    if ((_e4514 + _e4511) < _e4514) {
                        let _e4518 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7936_ = type_9(0u, 16u);
            loop {
                let _e4520 = phi_7936_;
                if (_e4520.member < _e4520.member_1) {
                    phi_7937_ = type_9((_e4520.member + 1u), _e4520.member_1);
                    phi_7960_ = type_9(1u, _e4520.member);
                } else {
                    phi_7937_ = _e4520;
                    phi_7960_ = type_9(0u, type_9().member_1);
                }
                let _e4532 = phi_7937_;
                let _e4534 = phi_7960_;
                if (bitcast<i32>(_e4534.member) != 0i) {
                    let _e4540 = (_e67 + (_e4534.member_1 * 128u));
                    if (_e4540 >= _e999) {
                        phi_8057_ = false;
                    } else {
                        let _e4543 = hits[_e4540];
                        if ((_e4543 & 2147483648u) == 0u) {
                            phi_7983_ = 4294967295u;
                        } else {
                            phi_7983_ = ((_e4543 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4550 = phi_7983_;
                        if (_e4550 != 4294967295u) {
                            let _e4554 = ((_e4543 >> bitcast<u32>(10i)) & 3u);
                            let _e4561 = firsts[(2u * _e4554)];
                            let _e4564 = leaves.member[(_e4561 + ((_e4543 >> bitcast<u32>(5i)) & 31u))];
                            let _e4568 = firsts[((2u * _e4554) + 1u)];
                            let _e4571 = leaves.member[(_e4568 + (_e4543 & 31u))];
                            let _e4576 = params.member.member_1.member_3;
                            let _e4577 = (_e4508 + _e4550);
                            if (_e4564.member_1 < _e4571.member_1) {
                                phi_8038_ = type_9(_e4564.member_1, _e4571.member_1);
                            } else {
                                phi_8038_ = type_9(_e4571.member_1, _e4564.member_1);
                            }
                            let _e4582 = phi_8038_;
                            if (_e4577 < _e4576) {
                                let _e4586 = (2u * _e4577);
                                atomicStore((&output.member[(4u + _e4586)]), _e4582.member);
                                atomicStore((&output.member[(_e4586 + 5u)]), _e4582.member_1);
                            }
                        }
                        phi_8057_ = true;
                    }
                    let _e4592 = phi_8057_;
                    phi_8058_ = _e4592;
                } else {
                    phi_8058_ = false;
                }
                let _e4594 = phi_8058_;
                continue;
                continuing {
                    phi_7936_ = _e4532;
                    break if !(_e4594);
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
