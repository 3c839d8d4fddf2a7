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
    var phi_4021_: f32;
    var phi_4026_: f32;
    var phi_4031_: f32;
    var phi_4036_: f32;
    var phi_4041_: f32;
    var phi_4046_: f32;
    var phi_4051_: f32;
    var phi_4056_: f32;
    var phi_4061_: f32;
    var phi_4066_: f32;
    var phi_4071_: f32;
    var phi_4076_: f32;
    var phi_4081_: f32;
    var phi_4086_: f32;
    var phi_4092_: f32;
    var phi_4098_: f32;
    var phi_4105_: f32;
    var phi_4116_: f32;
    var phi_4187_: f32;
    var phi_4192_: f32;
    var phi_4197_: f32;
    var phi_4202_: f32;
    var phi_4207_: f32;
    var phi_4212_: f32;
    var phi_4217_: f32;
    var phi_4222_: f32;
    var phi_4227_: f32;
    var phi_4232_: f32;
    var phi_4237_: f32;
    var phi_4242_: f32;
    var phi_4247_: f32;
    var phi_4252_: f32;
    var phi_4258_: f32;
    var phi_4264_: f32;
    var phi_4271_: f32;
    var phi_4282_: f32;
    var phi_4292_: f32;
    var phi_4474_: bool;
    var phi_4926_: f32;
    var phi_4933_: f32;
    var phi_4938_: f32;
    var phi_4945_: f32;
    var phi_4950_: f32;
    var phi_4963_: f32;
    var phi_4970_: f32;
    var phi_4975_: f32;
    var phi_4982_: f32;
    var phi_4987_: f32;
    var phi_4992_: f32;
    var phi_5009_: f32;
    var phi_5016_: f32;
    var phi_5021_: f32;
    var phi_5028_: f32;
    var phi_5033_: f32;
    var phi_5047_: f32;
    var phi_5054_: f32;
    var phi_5059_: f32;
    var phi_5066_: f32;
    var phi_5071_: f32;
    var phi_5076_: f32;
    var phi_5093_: f32;
    var phi_5100_: f32;
    var phi_5105_: f32;
    var phi_5112_: f32;
    var phi_5117_: f32;
    var phi_5131_: f32;
    var phi_5138_: f32;
    var phi_5143_: f32;
    var phi_5150_: f32;
    var phi_5155_: f32;
    var phi_5160_: f32;
    var phi_5191_: f32;
    var phi_5197_: f32;
    var phi_5204_: f32;
    var phi_5211_: f32;
    var phi_5217_: f32;
    var phi_5224_: f32;
    var phi_5230_: f32;
    var phi_5236_: f32;
    var phi_5242_: f32;
    var phi_5249_: f32;
    var phi_5256_: f32;
    var phi_5280_: f32;
    var phi_5285_: f32;
    var phi_5290_: f32;
    var phi_5295_: f32;
    var phi_5300_: f32;
    var phi_5305_: f32;
    var phi_5315_: f32;
    var phi_5518_: f32;
    var phi_5525_: f32;
    var phi_5530_: f32;
    var phi_5537_: f32;
    var phi_5542_: f32;
    var phi_5555_: f32;
    var phi_5562_: f32;
    var phi_5567_: f32;
    var phi_5574_: f32;
    var phi_5579_: f32;
    var phi_5584_: f32;
    var phi_5601_: f32;
    var phi_5608_: f32;
    var phi_5613_: f32;
    var phi_5620_: f32;
    var phi_5625_: f32;
    var phi_5639_: f32;
    var phi_5646_: f32;
    var phi_5651_: f32;
    var phi_5658_: f32;
    var phi_5663_: f32;
    var phi_5668_: f32;
    var phi_5685_: f32;
    var phi_5692_: f32;
    var phi_5697_: f32;
    var phi_5704_: f32;
    var phi_5709_: f32;
    var phi_5723_: f32;
    var phi_5730_: f32;
    var phi_5735_: f32;
    var phi_5742_: f32;
    var phi_5747_: f32;
    var phi_5752_: f32;
    var phi_5831_: f32;
    var phi_5836_: f32;
    var phi_5841_: f32;
    var phi_5846_: f32;
    var phi_5851_: f32;
    var phi_5856_: f32;
    var phi_5861_: f32;
    var phi_5866_: f32;
    var phi_5871_: f32;
    var phi_5876_: f32;
    var phi_5881_: f32;
    var phi_5886_: f32;
    var phi_5891_: f32;
    var phi_5896_: f32;
    var phi_5902_: f32;
    var phi_5908_: f32;
    var phi_5915_: f32;
    var phi_5926_: f32;
    var phi_5997_: f32;
    var phi_6002_: f32;
    var phi_6007_: f32;
    var phi_6012_: f32;
    var phi_6017_: f32;
    var phi_6022_: f32;
    var phi_6027_: f32;
    var phi_6032_: f32;
    var phi_6037_: f32;
    var phi_6042_: f32;
    var phi_6047_: f32;
    var phi_6052_: f32;
    var phi_6057_: f32;
    var phi_6062_: f32;
    var phi_6068_: f32;
    var phi_6074_: f32;
    var phi_6081_: f32;
    var phi_6092_: f32;
    var phi_6102_: f32;
    var phi_6284_: bool;
    var phi_6529_: f32;
    var phi_6536_: f32;
    var phi_6541_: f32;
    var phi_6548_: f32;
    var phi_6553_: f32;
    var phi_6566_: f32;
    var phi_6573_: f32;
    var phi_6578_: f32;
    var phi_6585_: f32;
    var phi_6590_: f32;
    var phi_6595_: f32;
    var phi_6612_: f32;
    var phi_6619_: f32;
    var phi_6624_: f32;
    var phi_6631_: f32;
    var phi_6636_: f32;
    var phi_6650_: f32;
    var phi_6657_: f32;
    var phi_6662_: f32;
    var phi_6669_: f32;
    var phi_6674_: f32;
    var phi_6679_: f32;
    var phi_6696_: f32;
    var phi_6703_: f32;
    var phi_6708_: f32;
    var phi_6715_: f32;
    var phi_6720_: f32;
    var phi_6734_: f32;
    var phi_6741_: f32;
    var phi_6746_: f32;
    var phi_6753_: f32;
    var phi_6758_: f32;
    var phi_6763_: f32;
    var phi_6794_: f32;
    var phi_6800_: f32;
    var phi_6807_: f32;
    var phi_6814_: f32;
    var phi_6820_: f32;
    var phi_6827_: f32;
    var phi_6833_: f32;
    var phi_6839_: f32;
    var phi_6845_: f32;
    var phi_6852_: f32;
    var phi_6859_: f32;
    var phi_6883_: f32;
    var phi_6888_: f32;
    var phi_6893_: f32;
    var phi_6898_: f32;
    var phi_6903_: f32;
    var phi_6908_: f32;
    var phi_6918_: f32;
    var phi_7121_: f32;
    var phi_7128_: f32;
    var phi_7133_: f32;
    var phi_7140_: f32;
    var phi_7145_: f32;
    var phi_7158_: f32;
    var phi_7165_: f32;
    var phi_7170_: f32;
    var phi_7177_: f32;
    var phi_7182_: f32;
    var phi_7187_: f32;
    var phi_7204_: f32;
    var phi_7211_: f32;
    var phi_7216_: f32;
    var phi_7223_: f32;
    var phi_7228_: f32;
    var phi_7242_: f32;
    var phi_7249_: f32;
    var phi_7254_: f32;
    var phi_7261_: f32;
    var phi_7266_: f32;
    var phi_7271_: f32;
    var phi_7288_: f32;
    var phi_7295_: f32;
    var phi_7300_: f32;
    var phi_7307_: f32;
    var phi_7312_: f32;
    var phi_7326_: f32;
    var phi_7333_: f32;
    var phi_7338_: f32;
    var phi_7345_: f32;
    var phi_7350_: f32;
    var phi_7355_: f32;
    var phi_7434_: f32;
    var phi_7439_: f32;
    var phi_7444_: f32;
    var phi_7449_: f32;
    var phi_7454_: f32;
    var phi_7459_: f32;
    var phi_7464_: f32;
    var phi_7469_: f32;
    var phi_7474_: f32;
    var phi_7479_: f32;
    var phi_7484_: f32;
    var phi_7489_: f32;
    var phi_7494_: f32;
    var phi_7499_: f32;
    var phi_7505_: f32;
    var phi_7511_: f32;
    var phi_7518_: f32;
    var phi_7529_: f32;
    var phi_7600_: f32;
    var phi_7605_: f32;
    var phi_7610_: f32;
    var phi_7615_: f32;
    var phi_7620_: f32;
    var phi_7625_: f32;
    var phi_7630_: f32;
    var phi_7635_: f32;
    var phi_7640_: f32;
    var phi_7645_: f32;
    var phi_7650_: f32;
    var phi_7655_: f32;
    var phi_7660_: f32;
    var phi_7665_: f32;
    var phi_7671_: f32;
    var phi_7677_: f32;
    var phi_7684_: f32;
    var phi_7695_: f32;
    var phi_7705_: f32;
    var phi_7887_: bool;
    var phi_7889_: bool;
    var phi_7891_: bool;
    var phi_7902_: bool;
    var phi_7903_: bool;
    var phi_7953_: type_9;
    var phi_7954_: type_9;
    var phi_7977_: type_9;
    var phi_8000_: u32;
    var phi_8055_: type_9;
    var phi_8074_: bool;
    var phi_8075_: bool;
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
            let _e4644 = local_3;
            phi_946_ = _e4644;
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
                        phi_7902_ = false;
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
                            let _e2006 = ((_e2004 - ((((((_e1780 * 8f) * _e1890) * (0.000000059604645f * (524f / 64f))) + ((_e1897 * 19f) * ((_e1780 * (_e1834 + _e1888)) + (_e1834 * _e1888)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1780) * ((1f + _e1834) * (1f + _e1888))))) + ((_e1494 * (((_e1959 + (_e1890 * (0.000000059604645f * 8f))) + ((_e1964 * 6f) * (_e1834 + _e1888))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1834) * (1f + _e1888))))) * (3f * 1.0001f)))) > 0f);
                            if _e2006 {
                                phi_4474_ = _e2006;
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
                                let _e2264 = ((((_e2150 + _e2152) + (_e2204 + _e2206)) + (_e2258 + _e2260)) * 2f);
                                let _e2267 = local_2.member_3;
                                let _e2271 = (((_e1494 * 1.0001f) + (_e2267 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2274 = ((_e2042 * _e2021) - (_e2045 * _e2020));
                                let _e2277 = ((_e2045 * _e2019) - (_e2039 * _e2021));
                                let _e2280 = ((_e2039 * _e2020) - (_e2042 * _e2019));
                                let _e2285 = (((_e2274 * _e2048[0]) + (_e2277 * _e2048[1])) + (_e2280 * _e2048[2]));
                                let _e2290 = (((_e2274 * _e2064) + (_e2277 * _e2065)) + (_e2280 * _e2066));
                                let _e2295 = (((_e2274 * _e2070) + (_e2277 * _e2071)) + (_e2280 * _e2072));
                                let _e2300 = (((_e2274 * _e2067) + (_e2277 * _e2068)) + (_e2280 * _e2069));
                                let _e2305 = (((_e2274 * _e2075[0]) + (_e2277 * _e2075[1])) + (_e2280 * _e2075[2]));
                                let _e2310 = (((_e2274 * _e2091) + (_e2277 * _e2092)) + (_e2280 * _e2093));
                                let _e2315 = (((_e2274 * _e2097) + (_e2277 * _e2098)) + (_e2280 * _e2099));
                                let _e2320 = (((_e2274 * _e2094) + (_e2277 * _e2095)) + (_e2280 * _e2096));
                                if (_e2285 < _e2290) {
                                    phi_4021_ = _e2285;
                                } else {
                                    phi_4021_ = _e2290;
                                }
                                let _e2323 = phi_4021_;
                                if (_e2295 < _e2300) {
                                    phi_4026_ = _e2295;
                                } else {
                                    phi_4026_ = _e2300;
                                }
                                let _e2326 = phi_4026_;
                                if (_e2323 < _e2326) {
                                    phi_4031_ = _e2323;
                                } else {
                                    phi_4031_ = _e2326;
                                }
                                let _e2329 = phi_4031_;
                                if (_e2305 < _e2310) {
                                    phi_4036_ = _e2305;
                                } else {
                                    phi_4036_ = _e2310;
                                }
                                let _e2332 = phi_4036_;
                                if (_e2315 < _e2320) {
                                    phi_4041_ = _e2315;
                                } else {
                                    phi_4041_ = _e2320;
                                }
                                let _e2335 = phi_4041_;
                                if (_e2332 < _e2335) {
                                    phi_4046_ = _e2332;
                                } else {
                                    phi_4046_ = _e2335;
                                }
                                let _e2338 = phi_4046_;
                                if (_e2329 < _e2338) {
                                    phi_4051_ = _e2329;
                                } else {
                                    phi_4051_ = _e2338;
                                }
                                let _e2341 = phi_4051_;
                                if (_e2285 > _e2290) {
                                    phi_4056_ = _e2285;
                                } else {
                                    phi_4056_ = _e2290;
                                }
                                let _e2344 = phi_4056_;
                                if (_e2295 > _e2300) {
                                    phi_4061_ = _e2295;
                                } else {
                                    phi_4061_ = _e2300;
                                }
                                let _e2347 = phi_4061_;
                                if (_e2344 > _e2347) {
                                    phi_4066_ = _e2344;
                                } else {
                                    phi_4066_ = _e2347;
                                }
                                let _e2350 = phi_4066_;
                                if (_e2305 > _e2310) {
                                    phi_4071_ = _e2305;
                                } else {
                                    phi_4071_ = _e2310;
                                }
                                let _e2353 = phi_4071_;
                                if (_e2315 > _e2320) {
                                    phi_4076_ = _e2315;
                                } else {
                                    phi_4076_ = _e2320;
                                }
                                let _e2356 = phi_4076_;
                                if (_e2353 > _e2356) {
                                    phi_4081_ = _e2353;
                                } else {
                                    phi_4081_ = _e2356;
                                }
                                let _e2359 = phi_4081_;
                                if (_e2350 > _e2359) {
                                    phi_4086_ = _e2350;
                                } else {
                                    phi_4086_ = _e2359;
                                }
                                let _e2362 = phi_4086_;
                                if (_e2274 < 0f) {
                                    phi_4092_ = -(_e2274);
                                } else {
                                    phi_4092_ = _e2274;
                                }
                                let _e2366 = phi_4092_;
                                if (_e2277 < 0f) {
                                    phi_4098_ = -(_e2277);
                                } else {
                                    phi_4098_ = _e2277;
                                }
                                let _e2370 = phi_4098_;
                                if (_e2280 < 0f) {
                                    phi_4105_ = -(_e2280);
                                } else {
                                    phi_4105_ = _e2280;
                                }
                                let _e2375 = phi_4105_;
                                let _e2376 = ((_e2366 + _e2370) + _e2375);
                                let _e2381 = -(_e2362);
                                if (_e2341 > _e2381) {
                                    phi_4116_ = _e2341;
                                } else {
                                    phi_4116_ = _e2381;
                                }
                                let _e2384 = phi_4116_;
                                let _e2389 = (((_e2384 - ((_e2376 * _e2264) * (0.000000059604645f * (17f / 2f)))) - (_e2376 * _e2271)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2392 = ((_e2042 * _e2036) - (_e2045 * _e2035));
                                let _e2395 = ((_e2045 * _e2034) - (_e2039 * _e2036));
                                let _e2398 = ((_e2039 * _e2035) - (_e2042 * _e2034));
                                let _e2403 = (((_e2392 * _e2048[0]) + (_e2395 * _e2048[1])) + (_e2398 * _e2048[2]));
                                let _e2408 = (((_e2392 * _e2064) + (_e2395 * _e2065)) + (_e2398 * _e2066));
                                let _e2413 = (((_e2392 * _e2070) + (_e2395 * _e2071)) + (_e2398 * _e2072));
                                let _e2418 = (((_e2392 * _e2067) + (_e2395 * _e2068)) + (_e2398 * _e2069));
                                let _e2423 = (((_e2392 * _e2075[0]) + (_e2395 * _e2075[1])) + (_e2398 * _e2075[2]));
                                let _e2428 = (((_e2392 * _e2091) + (_e2395 * _e2092)) + (_e2398 * _e2093));
                                let _e2433 = (((_e2392 * _e2097) + (_e2395 * _e2098)) + (_e2398 * _e2099));
                                let _e2438 = (((_e2392 * _e2094) + (_e2395 * _e2095)) + (_e2398 * _e2096));
                                if (_e2403 < _e2408) {
                                    phi_4187_ = _e2403;
                                } else {
                                    phi_4187_ = _e2408;
                                }
                                let _e2441 = phi_4187_;
                                if (_e2413 < _e2418) {
                                    phi_4192_ = _e2413;
                                } else {
                                    phi_4192_ = _e2418;
                                }
                                let _e2444 = phi_4192_;
                                if (_e2441 < _e2444) {
                                    phi_4197_ = _e2441;
                                } else {
                                    phi_4197_ = _e2444;
                                }
                                let _e2447 = phi_4197_;
                                if (_e2423 < _e2428) {
                                    phi_4202_ = _e2423;
                                } else {
                                    phi_4202_ = _e2428;
                                }
                                let _e2450 = phi_4202_;
                                if (_e2433 < _e2438) {
                                    phi_4207_ = _e2433;
                                } else {
                                    phi_4207_ = _e2438;
                                }
                                let _e2453 = phi_4207_;
                                if (_e2450 < _e2453) {
                                    phi_4212_ = _e2450;
                                } else {
                                    phi_4212_ = _e2453;
                                }
                                let _e2456 = phi_4212_;
                                if (_e2447 < _e2456) {
                                    phi_4217_ = _e2447;
                                } else {
                                    phi_4217_ = _e2456;
                                }
                                let _e2459 = phi_4217_;
                                if (_e2403 > _e2408) {
                                    phi_4222_ = _e2403;
                                } else {
                                    phi_4222_ = _e2408;
                                }
                                let _e2462 = phi_4222_;
                                if (_e2413 > _e2418) {
                                    phi_4227_ = _e2413;
                                } else {
                                    phi_4227_ = _e2418;
                                }
                                let _e2465 = phi_4227_;
                                if (_e2462 > _e2465) {
                                    phi_4232_ = _e2462;
                                } else {
                                    phi_4232_ = _e2465;
                                }
                                let _e2468 = phi_4232_;
                                if (_e2423 > _e2428) {
                                    phi_4237_ = _e2423;
                                } else {
                                    phi_4237_ = _e2428;
                                }
                                let _e2471 = phi_4237_;
                                if (_e2433 > _e2438) {
                                    phi_4242_ = _e2433;
                                } else {
                                    phi_4242_ = _e2438;
                                }
                                let _e2474 = phi_4242_;
                                if (_e2471 > _e2474) {
                                    phi_4247_ = _e2471;
                                } else {
                                    phi_4247_ = _e2474;
                                }
                                let _e2477 = phi_4247_;
                                if (_e2468 > _e2477) {
                                    phi_4252_ = _e2468;
                                } else {
                                    phi_4252_ = _e2477;
                                }
                                let _e2480 = phi_4252_;
                                if (_e2392 < 0f) {
                                    phi_4258_ = -(_e2392);
                                } else {
                                    phi_4258_ = _e2392;
                                }
                                let _e2484 = phi_4258_;
                                if (_e2395 < 0f) {
                                    phi_4264_ = -(_e2395);
                                } else {
                                    phi_4264_ = _e2395;
                                }
                                let _e2488 = phi_4264_;
                                if (_e2398 < 0f) {
                                    phi_4271_ = -(_e2398);
                                } else {
                                    phi_4271_ = _e2398;
                                }
                                let _e2493 = phi_4271_;
                                let _e2494 = ((_e2484 + _e2488) + _e2493);
                                let _e2499 = -(_e2480);
                                if (_e2459 > _e2499) {
                                    phi_4282_ = _e2459;
                                } else {
                                    phi_4282_ = _e2499;
                                }
                                let _e2502 = phi_4282_;
                                let _e2507 = (((_e2502 - ((_e2494 * _e2264) * (0.000000059604645f * (17f / 2f)))) - (_e2494 * _e2271)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2389 > _e2507) {
                                    phi_4292_ = _e2389;
                                } else {
                                    phi_4292_ = _e2507;
                                }
                                let _e2510 = phi_4292_;
                                phi_4474_ = (_e2006 || (_e2510 > 0f));
                            }
                            let _e2514 = phi_4474_;
                            if _e2514 {
                                phi_7891_ = _e2514;
                            } else {
                                let _e2517 = local_2.member[0u];
                                let _e2523 = local_2.member[1u];
                                let _e2530 = ((_e2517[0] + _e2523[0]) * 0.5f);
                                let _e2531 = ((_e2517[1] + _e2523[1]) * 0.5f);
                                let _e2532 = ((_e2517[2] + _e2523[2]) * 0.5f);
                                let _e2535 = local_2.member_1[0u];
                                let _e2541 = local_2.member_1[1u];
                                let _e2548 = ((_e2535[0] + _e2541[0]) * 0.5f);
                                let _e2549 = ((_e2535[1] + _e2541[1]) * 0.5f);
                                let _e2550 = ((_e2535[2] + _e2541[2]) * 0.5f);
                                let _e2553 = local_2.member_2[0u];
                                let _e2559 = local_2.member_2[1u];
                                let _e2566 = ((_e2553[0] + _e2559[0]) * 0.5f);
                                let _e2567 = ((_e2553[1] + _e2559[1]) * 0.5f);
                                let _e2568 = ((_e2553[2] + _e2559[2]) * 0.5f);
                                let _e2571 = local_2.member[0u];
                                let _e2574 = local_2.member_1[0u];
                                let _e2577 = local_2.member_2[0u];
                                let _e2579 = local_2.member_3;
                                let _e2582 = local_2.member[1u];
                                let _e2585 = local_2.member_1[1u];
                                let _e2588 = local_2.member_2[1u];
                                let _e2590 = local_2.member_3;
                                local = type_37(array<array<f32, 3>, 2>(_e2571, array<f32, 3>(_e2530, _e2531, _e2532)), array<array<f32, 3>, 2>(_e2574, array<f32, 3>(_e2548, _e2549, _e2550)), array<array<f32, 3>, 2>(_e2577, array<f32, 3>(_e2566, _e2567, _e2568)), _e2579);
                                local_1 = type_37(array<array<f32, 3>, 2>(array<f32, 3>(_e2530, _e2531, _e2532), _e2582), array<array<f32, 3>, 2>(array<f32, 3>(_e2548, _e2549, _e2550), _e2585), array<array<f32, 3>, 2>(array<f32, 3>(_e2566, _e2567, _e2568), _e2588), _e2590);
                                let _e2607 = local.member_1[0u];
                                let _e2613 = local.member_2[0u];
                                let _e2619 = ((_e2607[1] * _e2613[2]) - (_e2607[2] * _e2613[1]));
                                let _e2622 = ((_e2607[2] * _e2613[0]) - (_e2607[0] * _e2613[2]));
                                let _e2625 = ((_e2607[0] * _e2613[1]) - (_e2607[1] * _e2613[0]));
                                let _e2628 = local.member_1[1u];
                                let _e2634 = local.member_2[1u];
                                let _e2640 = ((_e2628[1] * _e2634[2]) - (_e2628[2] * _e2634[1]));
                                let _e2643 = ((_e2628[2] * _e2634[0]) - (_e2628[0] * _e2634[2]));
                                let _e2646 = ((_e2628[0] * _e2634[1]) - (_e2628[1] * _e2634[0]));
                                let _e2649 = local.member_1[0u];
                                let _e2655 = local.member_2[1u];
                                let _e2670 = local.member_1[1u];
                                let _e2676 = local.member_2[0u];
                                let _e2689 = (((_e2649[1] * _e2655[2]) - (_e2649[2] * _e2655[1])) + ((_e2670[1] * _e2676[2]) - (_e2670[2] * _e2676[1])));
                                let _e2690 = (((_e2649[2] * _e2655[0]) - (_e2649[0] * _e2655[2])) + ((_e2670[2] * _e2676[0]) - (_e2670[0] * _e2676[2])));
                                let _e2691 = (((_e2649[0] * _e2655[1]) - (_e2649[1] * _e2655[0])) + ((_e2670[0] * _e2676[1]) - (_e2670[1] * _e2676[0])));
                                let _e2694 = local.member[0u];
                                let _e2705 = local.member[1u];
                                let _e2716 = local.member[0u];
                                let _e2725 = ((((_e2705[0] * _e2619) + (_e2705[1] * _e2622)) + (_e2705[2] * _e2625)) + (((_e2716[0] * _e2689) + (_e2716[1] * _e2690)) + (_e2716[2] * _e2691)));
                                let _e2728 = local.member[0u];
                                let _e2739 = local.member[1u];
                                let _e2748 = ((((_e2728[0] * _e2640) + (_e2728[1] * _e2643)) + (_e2728[2] * _e2646)) + (((_e2739[0] * _e2689) + (_e2739[1] * _e2690)) + (_e2739[2] * _e2691)));
                                let _e2751 = local.member[1u];
                                let _e2762 = local.member[0u];
                                if (_e2762[0] < 0f) {
                                    phi_4926_ = -(_e2762[0]);
                                } else {
                                    phi_4926_ = _e2762[0];
                                }
                                let _e2769 = phi_4926_;
                                if (_e2762[1] < 0f) {
                                    phi_4933_ = -(_e2762[1]);
                                } else {
                                    phi_4933_ = _e2762[1];
                                }
                                let _e2773 = phi_4933_;
                                if (_e2769 > _e2773) {
                                    phi_4938_ = _e2769;
                                } else {
                                    phi_4938_ = _e2773;
                                }
                                let _e2776 = phi_4938_;
                                if (_e2762[2] < 0f) {
                                    phi_4945_ = -(_e2762[2]);
                                } else {
                                    phi_4945_ = _e2762[2];
                                }
                                let _e2780 = phi_4945_;
                                if (_e2776 > _e2780) {
                                    phi_4950_ = _e2776;
                                } else {
                                    phi_4950_ = _e2780;
                                }
                                let _e2783 = phi_4950_;
                                let _e2786 = local.member[1u];
                                if (_e2786[0] < 0f) {
                                    phi_4963_ = -(_e2786[0]);
                                } else {
                                    phi_4963_ = _e2786[0];
                                }
                                let _e2793 = phi_4963_;
                                if (_e2786[1] < 0f) {
                                    phi_4970_ = -(_e2786[1]);
                                } else {
                                    phi_4970_ = _e2786[1];
                                }
                                let _e2797 = phi_4970_;
                                if (_e2793 > _e2797) {
                                    phi_4975_ = _e2793;
                                } else {
                                    phi_4975_ = _e2797;
                                }
                                let _e2800 = phi_4975_;
                                if (_e2786[2] < 0f) {
                                    phi_4982_ = -(_e2786[2]);
                                } else {
                                    phi_4982_ = _e2786[2];
                                }
                                let _e2804 = phi_4982_;
                                if (_e2800 > _e2804) {
                                    phi_4987_ = _e2800;
                                } else {
                                    phi_4987_ = _e2804;
                                }
                                let _e2807 = phi_4987_;
                                if (_e2783 > _e2807) {
                                    phi_4992_ = _e2783;
                                } else {
                                    phi_4992_ = _e2807;
                                }
                                let _e2810 = phi_4992_;
                                let _e2812 = local.member_3;
                                let _e2813 = (_e2810 + _e2812);
                                let _e2816 = local.member_1[0u];
                                if (_e2816[0] < 0f) {
                                    phi_5009_ = -(_e2816[0]);
                                } else {
                                    phi_5009_ = _e2816[0];
                                }
                                let _e2823 = phi_5009_;
                                if (_e2816[1] < 0f) {
                                    phi_5016_ = -(_e2816[1]);
                                } else {
                                    phi_5016_ = _e2816[1];
                                }
                                let _e2827 = phi_5016_;
                                if (_e2823 > _e2827) {
                                    phi_5021_ = _e2823;
                                } else {
                                    phi_5021_ = _e2827;
                                }
                                let _e2830 = phi_5021_;
                                if (_e2816[2] < 0f) {
                                    phi_5028_ = -(_e2816[2]);
                                } else {
                                    phi_5028_ = _e2816[2];
                                }
                                let _e2834 = phi_5028_;
                                if (_e2830 > _e2834) {
                                    phi_5033_ = _e2830;
                                } else {
                                    phi_5033_ = _e2834;
                                }
                                let _e2837 = phi_5033_;
                                let _e2840 = local.member_1[1u];
                                if (_e2840[0] < 0f) {
                                    phi_5047_ = -(_e2840[0]);
                                } else {
                                    phi_5047_ = _e2840[0];
                                }
                                let _e2847 = phi_5047_;
                                if (_e2840[1] < 0f) {
                                    phi_5054_ = -(_e2840[1]);
                                } else {
                                    phi_5054_ = _e2840[1];
                                }
                                let _e2851 = phi_5054_;
                                if (_e2847 > _e2851) {
                                    phi_5059_ = _e2847;
                                } else {
                                    phi_5059_ = _e2851;
                                }
                                let _e2854 = phi_5059_;
                                if (_e2840[2] < 0f) {
                                    phi_5066_ = -(_e2840[2]);
                                } else {
                                    phi_5066_ = _e2840[2];
                                }
                                let _e2858 = phi_5066_;
                                if (_e2854 > _e2858) {
                                    phi_5071_ = _e2854;
                                } else {
                                    phi_5071_ = _e2858;
                                }
                                let _e2861 = phi_5071_;
                                if (_e2837 > _e2861) {
                                    phi_5076_ = _e2837;
                                } else {
                                    phi_5076_ = _e2861;
                                }
                                let _e2864 = phi_5076_;
                                let _e2866 = local.member_3;
                                let _e2867 = (_e2864 + _e2866);
                                let _e2870 = local.member_2[0u];
                                if (_e2870[0] < 0f) {
                                    phi_5093_ = -(_e2870[0]);
                                } else {
                                    phi_5093_ = _e2870[0];
                                }
                                let _e2877 = phi_5093_;
                                if (_e2870[1] < 0f) {
                                    phi_5100_ = -(_e2870[1]);
                                } else {
                                    phi_5100_ = _e2870[1];
                                }
                                let _e2881 = phi_5100_;
                                if (_e2877 > _e2881) {
                                    phi_5105_ = _e2877;
                                } else {
                                    phi_5105_ = _e2881;
                                }
                                let _e2884 = phi_5105_;
                                if (_e2870[2] < 0f) {
                                    phi_5112_ = -(_e2870[2]);
                                } else {
                                    phi_5112_ = _e2870[2];
                                }
                                let _e2888 = phi_5112_;
                                if (_e2884 > _e2888) {
                                    phi_5117_ = _e2884;
                                } else {
                                    phi_5117_ = _e2888;
                                }
                                let _e2891 = phi_5117_;
                                let _e2894 = local.member_2[1u];
                                if (_e2894[0] < 0f) {
                                    phi_5131_ = -(_e2894[0]);
                                } else {
                                    phi_5131_ = _e2894[0];
                                }
                                let _e2901 = phi_5131_;
                                if (_e2894[1] < 0f) {
                                    phi_5138_ = -(_e2894[1]);
                                } else {
                                    phi_5138_ = _e2894[1];
                                }
                                let _e2905 = phi_5138_;
                                if (_e2901 > _e2905) {
                                    phi_5143_ = _e2901;
                                } else {
                                    phi_5143_ = _e2905;
                                }
                                let _e2908 = phi_5143_;
                                if (_e2894[2] < 0f) {
                                    phi_5150_ = -(_e2894[2]);
                                } else {
                                    phi_5150_ = _e2894[2];
                                }
                                let _e2912 = phi_5150_;
                                if (_e2908 > _e2912) {
                                    phi_5155_ = _e2908;
                                } else {
                                    phi_5155_ = _e2912;
                                }
                                let _e2915 = phi_5155_;
                                if (_e2891 > _e2915) {
                                    phi_5160_ = _e2891;
                                } else {
                                    phi_5160_ = _e2915;
                                }
                                let _e2918 = phi_5160_;
                                let _e2920 = local.member_3;
                                let _e2921 = (_e2918 + _e2920);
                                let _e2923 = ((_e2867 * 8f) * _e2921);
                                let _e2930 = local.member_3;
                                if (_e2619 < 0f) {
                                    phi_5191_ = -(_e2619);
                                } else {
                                    phi_5191_ = _e2619;
                                }
                                let _e2947 = phi_5191_;
                                if (_e2622 < 0f) {
                                    phi_5197_ = -(_e2622);
                                } else {
                                    phi_5197_ = _e2622;
                                }
                                let _e2951 = phi_5197_;
                                if (_e2625 < 0f) {
                                    phi_5204_ = -(_e2625);
                                } else {
                                    phi_5204_ = _e2625;
                                }
                                let _e2956 = phi_5204_;
                                let _e2957 = ((_e2947 + _e2951) + _e2956);
                                if (_e2640 < 0f) {
                                    phi_5211_ = -(_e2640);
                                } else {
                                    phi_5211_ = _e2640;
                                }
                                let _e2961 = phi_5211_;
                                if (_e2643 < 0f) {
                                    phi_5217_ = -(_e2643);
                                } else {
                                    phi_5217_ = _e2643;
                                }
                                let _e2965 = phi_5217_;
                                if (_e2646 < 0f) {
                                    phi_5224_ = -(_e2646);
                                } else {
                                    phi_5224_ = _e2646;
                                }
                                let _e2970 = phi_5224_;
                                let _e2971 = ((_e2961 + _e2965) + _e2970);
                                if (_e2957 > _e2971) {
                                    phi_5230_ = _e2957;
                                } else {
                                    phi_5230_ = _e2971;
                                }
                                let _e2974 = phi_5230_;
                                if (_e2689 < 0f) {
                                    phi_5236_ = -(_e2689);
                                } else {
                                    phi_5236_ = _e2689;
                                }
                                let _e2978 = phi_5236_;
                                if (_e2690 < 0f) {
                                    phi_5242_ = -(_e2690);
                                } else {
                                    phi_5242_ = _e2690;
                                }
                                let _e2982 = phi_5242_;
                                if (_e2691 < 0f) {
                                    phi_5249_ = -(_e2691);
                                } else {
                                    phi_5249_ = _e2691;
                                }
                                let _e2987 = phi_5249_;
                                let _e2989 = (((_e2978 + _e2982) + _e2987) * 0.5f);
                                if (_e2974 > _e2989) {
                                    phi_5256_ = _e2974;
                                } else {
                                    phi_5256_ = _e2989;
                                }
                                let _e2992 = phi_5256_;
                                let _e2997 = local.member_3;
                                let _e3010 = ((((_e2694[0] * _e2619) + (_e2694[1] * _e2622)) + (_e2694[2] * _e2625)) * 3f);
                                let _e3011 = ((((_e2751[0] * _e2640) + (_e2751[1] * _e2643)) + (_e2751[2] * _e2646)) * 3f);
                                if (_e3010 < _e3011) {
                                    phi_5280_ = _e3010;
                                } else {
                                    phi_5280_ = _e3011;
                                }
                                let _e3014 = phi_5280_;
                                if (_e2725 < _e2748) {
                                    phi_5285_ = _e2725;
                                } else {
                                    phi_5285_ = _e2748;
                                }
                                let _e3017 = phi_5285_;
                                if (_e3014 < _e3017) {
                                    phi_5290_ = _e3014;
                                } else {
                                    phi_5290_ = _e3017;
                                }
                                let _e3020 = phi_5290_;
                                if (_e3010 > _e3011) {
                                    phi_5295_ = _e3010;
                                } else {
                                    phi_5295_ = _e3011;
                                }
                                let _e3023 = phi_5295_;
                                if (_e2725 > _e2748) {
                                    phi_5300_ = _e2725;
                                } else {
                                    phi_5300_ = _e2748;
                                }
                                let _e3026 = phi_5300_;
                                if (_e3023 > _e3026) {
                                    phi_5305_ = _e3023;
                                } else {
                                    phi_5305_ = _e3026;
                                }
                                let _e3029 = phi_5305_;
                                let _e3034 = -(_e3029);
                                if (_e3020 > _e3034) {
                                    phi_5315_ = _e3020;
                                } else {
                                    phi_5315_ = _e3034;
                                }
                                let _e3037 = phi_5315_;
                                let _e3039 = ((_e3037 - ((((((_e2813 * 8f) * _e2923) * (0.000000059604645f * (524f / 64f))) + ((_e2930 * 19f) * ((_e2813 * (_e2867 + _e2921)) + (_e2867 * _e2921)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2813) * ((1f + _e2867) * (1f + _e2921))))) + ((_e1494 * (((_e2992 + (_e2923 * (0.000000059604645f * 8f))) + ((_e2997 * 6f) * (_e2867 + _e2921))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2867) * (1f + _e2921))))) * (3f * 1.0001f)))) > 0f);
                                if _e3039 {
                                    phi_6284_ = _e3039;
                                } else {
                                    let _e3042 = local.member_1[0u];
                                    let _e3048 = local.member_1[1u];
                                    let _e3052 = (_e3042[0] + _e3048[0]);
                                    let _e3053 = (_e3042[1] + _e3048[1]);
                                    let _e3054 = (_e3042[2] + _e3048[2]);
                                    let _e3057 = local.member_2[0u];
                                    let _e3063 = local.member_2[1u];
                                    let _e3067 = (_e3057[0] + _e3063[0]);
                                    let _e3068 = (_e3057[1] + _e3063[1]);
                                    let _e3069 = (_e3057[2] + _e3063[2]);
                                    let _e3072 = ((_e3053 * _e3069) - (_e3054 * _e3068));
                                    let _e3075 = ((_e3054 * _e3067) - (_e3052 * _e3069));
                                    let _e3078 = ((_e3052 * _e3068) - (_e3053 * _e3067));
                                    let _e3081 = local.member[0u];
                                    let _e3087 = local.member_1[0u];
                                    let _e3093 = local.member_2[0u];
                                    let _e3097 = (_e3081[0] - _e3087[0]);
                                    let _e3098 = (_e3081[1] - _e3087[1]);
                                    let _e3099 = (_e3081[2] - _e3087[2]);
                                    let _e3100 = (_e3097 - _e3093[0]);
                                    let _e3101 = (_e3098 - _e3093[1]);
                                    let _e3102 = (_e3099 - _e3093[2]);
                                    let _e3103 = (_e3081[0] - _e3093[0]);
                                    let _e3104 = (_e3081[1] - _e3093[1]);
                                    let _e3105 = (_e3081[2] - _e3093[2]);
                                    let _e3108 = local.member[1u];
                                    let _e3114 = local.member_1[1u];
                                    let _e3120 = local.member_2[1u];
                                    let _e3124 = (_e3108[0] - _e3114[0]);
                                    let _e3125 = (_e3108[1] - _e3114[1]);
                                    let _e3126 = (_e3108[2] - _e3114[2]);
                                    let _e3127 = (_e3124 - _e3120[0]);
                                    let _e3128 = (_e3125 - _e3120[1]);
                                    let _e3129 = (_e3126 - _e3120[2]);
                                    let _e3130 = (_e3108[0] - _e3120[0]);
                                    let _e3131 = (_e3108[1] - _e3120[1]);
                                    let _e3132 = (_e3108[2] - _e3120[2]);
                                    let _e3135 = local.member[0u];
                                    if (_e3135[0] < 0f) {
                                        phi_5518_ = -(_e3135[0]);
                                    } else {
                                        phi_5518_ = _e3135[0];
                                    }
                                    let _e3142 = phi_5518_;
                                    if (_e3135[1] < 0f) {
                                        phi_5525_ = -(_e3135[1]);
                                    } else {
                                        phi_5525_ = _e3135[1];
                                    }
                                    let _e3146 = phi_5525_;
                                    if (_e3142 > _e3146) {
                                        phi_5530_ = _e3142;
                                    } else {
                                        phi_5530_ = _e3146;
                                    }
                                    let _e3149 = phi_5530_;
                                    if (_e3135[2] < 0f) {
                                        phi_5537_ = -(_e3135[2]);
                                    } else {
                                        phi_5537_ = _e3135[2];
                                    }
                                    let _e3153 = phi_5537_;
                                    if (_e3149 > _e3153) {
                                        phi_5542_ = _e3149;
                                    } else {
                                        phi_5542_ = _e3153;
                                    }
                                    let _e3156 = phi_5542_;
                                    let _e3159 = local.member[1u];
                                    if (_e3159[0] < 0f) {
                                        phi_5555_ = -(_e3159[0]);
                                    } else {
                                        phi_5555_ = _e3159[0];
                                    }
                                    let _e3166 = phi_5555_;
                                    if (_e3159[1] < 0f) {
                                        phi_5562_ = -(_e3159[1]);
                                    } else {
                                        phi_5562_ = _e3159[1];
                                    }
                                    let _e3170 = phi_5562_;
                                    if (_e3166 > _e3170) {
                                        phi_5567_ = _e3166;
                                    } else {
                                        phi_5567_ = _e3170;
                                    }
                                    let _e3173 = phi_5567_;
                                    if (_e3159[2] < 0f) {
                                        phi_5574_ = -(_e3159[2]);
                                    } else {
                                        phi_5574_ = _e3159[2];
                                    }
                                    let _e3177 = phi_5574_;
                                    if (_e3173 > _e3177) {
                                        phi_5579_ = _e3173;
                                    } else {
                                        phi_5579_ = _e3177;
                                    }
                                    let _e3180 = phi_5579_;
                                    if (_e3156 > _e3180) {
                                        phi_5584_ = _e3156;
                                    } else {
                                        phi_5584_ = _e3180;
                                    }
                                    let _e3183 = phi_5584_;
                                    let _e3185 = local.member_3;
                                    let _e3189 = local.member_1[0u];
                                    if (_e3189[0] < 0f) {
                                        phi_5601_ = -(_e3189[0]);
                                    } else {
                                        phi_5601_ = _e3189[0];
                                    }
                                    let _e3196 = phi_5601_;
                                    if (_e3189[1] < 0f) {
                                        phi_5608_ = -(_e3189[1]);
                                    } else {
                                        phi_5608_ = _e3189[1];
                                    }
                                    let _e3200 = phi_5608_;
                                    if (_e3196 > _e3200) {
                                        phi_5613_ = _e3196;
                                    } else {
                                        phi_5613_ = _e3200;
                                    }
                                    let _e3203 = phi_5613_;
                                    if (_e3189[2] < 0f) {
                                        phi_5620_ = -(_e3189[2]);
                                    } else {
                                        phi_5620_ = _e3189[2];
                                    }
                                    let _e3207 = phi_5620_;
                                    if (_e3203 > _e3207) {
                                        phi_5625_ = _e3203;
                                    } else {
                                        phi_5625_ = _e3207;
                                    }
                                    let _e3210 = phi_5625_;
                                    let _e3213 = local.member_1[1u];
                                    if (_e3213[0] < 0f) {
                                        phi_5639_ = -(_e3213[0]);
                                    } else {
                                        phi_5639_ = _e3213[0];
                                    }
                                    let _e3220 = phi_5639_;
                                    if (_e3213[1] < 0f) {
                                        phi_5646_ = -(_e3213[1]);
                                    } else {
                                        phi_5646_ = _e3213[1];
                                    }
                                    let _e3224 = phi_5646_;
                                    if (_e3220 > _e3224) {
                                        phi_5651_ = _e3220;
                                    } else {
                                        phi_5651_ = _e3224;
                                    }
                                    let _e3227 = phi_5651_;
                                    if (_e3213[2] < 0f) {
                                        phi_5658_ = -(_e3213[2]);
                                    } else {
                                        phi_5658_ = _e3213[2];
                                    }
                                    let _e3231 = phi_5658_;
                                    if (_e3227 > _e3231) {
                                        phi_5663_ = _e3227;
                                    } else {
                                        phi_5663_ = _e3231;
                                    }
                                    let _e3234 = phi_5663_;
                                    if (_e3210 > _e3234) {
                                        phi_5668_ = _e3210;
                                    } else {
                                        phi_5668_ = _e3234;
                                    }
                                    let _e3237 = phi_5668_;
                                    let _e3239 = local.member_3;
                                    let _e3243 = local.member_2[0u];
                                    if (_e3243[0] < 0f) {
                                        phi_5685_ = -(_e3243[0]);
                                    } else {
                                        phi_5685_ = _e3243[0];
                                    }
                                    let _e3250 = phi_5685_;
                                    if (_e3243[1] < 0f) {
                                        phi_5692_ = -(_e3243[1]);
                                    } else {
                                        phi_5692_ = _e3243[1];
                                    }
                                    let _e3254 = phi_5692_;
                                    if (_e3250 > _e3254) {
                                        phi_5697_ = _e3250;
                                    } else {
                                        phi_5697_ = _e3254;
                                    }
                                    let _e3257 = phi_5697_;
                                    if (_e3243[2] < 0f) {
                                        phi_5704_ = -(_e3243[2]);
                                    } else {
                                        phi_5704_ = _e3243[2];
                                    }
                                    let _e3261 = phi_5704_;
                                    if (_e3257 > _e3261) {
                                        phi_5709_ = _e3257;
                                    } else {
                                        phi_5709_ = _e3261;
                                    }
                                    let _e3264 = phi_5709_;
                                    let _e3267 = local.member_2[1u];
                                    if (_e3267[0] < 0f) {
                                        phi_5723_ = -(_e3267[0]);
                                    } else {
                                        phi_5723_ = _e3267[0];
                                    }
                                    let _e3274 = phi_5723_;
                                    if (_e3267[1] < 0f) {
                                        phi_5730_ = -(_e3267[1]);
                                    } else {
                                        phi_5730_ = _e3267[1];
                                    }
                                    let _e3278 = phi_5730_;
                                    if (_e3274 > _e3278) {
                                        phi_5735_ = _e3274;
                                    } else {
                                        phi_5735_ = _e3278;
                                    }
                                    let _e3281 = phi_5735_;
                                    if (_e3267[2] < 0f) {
                                        phi_5742_ = -(_e3267[2]);
                                    } else {
                                        phi_5742_ = _e3267[2];
                                    }
                                    let _e3285 = phi_5742_;
                                    if (_e3281 > _e3285) {
                                        phi_5747_ = _e3281;
                                    } else {
                                        phi_5747_ = _e3285;
                                    }
                                    let _e3288 = phi_5747_;
                                    if (_e3264 > _e3288) {
                                        phi_5752_ = _e3264;
                                    } else {
                                        phi_5752_ = _e3288;
                                    }
                                    let _e3291 = phi_5752_;
                                    let _e3293 = local.member_3;
                                    let _e3297 = ((((_e3183 + _e3185) + (_e3237 + _e3239)) + (_e3291 + _e3293)) * 2f);
                                    let _e3300 = local.member_3;
                                    let _e3304 = (((_e1494 * 1.0001f) + (_e3300 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3307 = ((_e3075 * _e3054) - (_e3078 * _e3053));
                                    let _e3310 = ((_e3078 * _e3052) - (_e3072 * _e3054));
                                    let _e3313 = ((_e3072 * _e3053) - (_e3075 * _e3052));
                                    let _e3318 = (((_e3307 * _e3081[0]) + (_e3310 * _e3081[1])) + (_e3313 * _e3081[2]));
                                    let _e3323 = (((_e3307 * _e3097) + (_e3310 * _e3098)) + (_e3313 * _e3099));
                                    let _e3328 = (((_e3307 * _e3103) + (_e3310 * _e3104)) + (_e3313 * _e3105));
                                    let _e3333 = (((_e3307 * _e3100) + (_e3310 * _e3101)) + (_e3313 * _e3102));
                                    let _e3338 = (((_e3307 * _e3108[0]) + (_e3310 * _e3108[1])) + (_e3313 * _e3108[2]));
                                    let _e3343 = (((_e3307 * _e3124) + (_e3310 * _e3125)) + (_e3313 * _e3126));
                                    let _e3348 = (((_e3307 * _e3130) + (_e3310 * _e3131)) + (_e3313 * _e3132));
                                    let _e3353 = (((_e3307 * _e3127) + (_e3310 * _e3128)) + (_e3313 * _e3129));
                                    if (_e3318 < _e3323) {
                                        phi_5831_ = _e3318;
                                    } else {
                                        phi_5831_ = _e3323;
                                    }
                                    let _e3356 = phi_5831_;
                                    if (_e3328 < _e3333) {
                                        phi_5836_ = _e3328;
                                    } else {
                                        phi_5836_ = _e3333;
                                    }
                                    let _e3359 = phi_5836_;
                                    if (_e3356 < _e3359) {
                                        phi_5841_ = _e3356;
                                    } else {
                                        phi_5841_ = _e3359;
                                    }
                                    let _e3362 = phi_5841_;
                                    if (_e3338 < _e3343) {
                                        phi_5846_ = _e3338;
                                    } else {
                                        phi_5846_ = _e3343;
                                    }
                                    let _e3365 = phi_5846_;
                                    if (_e3348 < _e3353) {
                                        phi_5851_ = _e3348;
                                    } else {
                                        phi_5851_ = _e3353;
                                    }
                                    let _e3368 = phi_5851_;
                                    if (_e3365 < _e3368) {
                                        phi_5856_ = _e3365;
                                    } else {
                                        phi_5856_ = _e3368;
                                    }
                                    let _e3371 = phi_5856_;
                                    if (_e3362 < _e3371) {
                                        phi_5861_ = _e3362;
                                    } else {
                                        phi_5861_ = _e3371;
                                    }
                                    let _e3374 = phi_5861_;
                                    if (_e3318 > _e3323) {
                                        phi_5866_ = _e3318;
                                    } else {
                                        phi_5866_ = _e3323;
                                    }
                                    let _e3377 = phi_5866_;
                                    if (_e3328 > _e3333) {
                                        phi_5871_ = _e3328;
                                    } else {
                                        phi_5871_ = _e3333;
                                    }
                                    let _e3380 = phi_5871_;
                                    if (_e3377 > _e3380) {
                                        phi_5876_ = _e3377;
                                    } else {
                                        phi_5876_ = _e3380;
                                    }
                                    let _e3383 = phi_5876_;
                                    if (_e3338 > _e3343) {
                                        phi_5881_ = _e3338;
                                    } else {
                                        phi_5881_ = _e3343;
                                    }
                                    let _e3386 = phi_5881_;
                                    if (_e3348 > _e3353) {
                                        phi_5886_ = _e3348;
                                    } else {
                                        phi_5886_ = _e3353;
                                    }
                                    let _e3389 = phi_5886_;
                                    if (_e3386 > _e3389) {
                                        phi_5891_ = _e3386;
                                    } else {
                                        phi_5891_ = _e3389;
                                    }
                                    let _e3392 = phi_5891_;
                                    if (_e3383 > _e3392) {
                                        phi_5896_ = _e3383;
                                    } else {
                                        phi_5896_ = _e3392;
                                    }
                                    let _e3395 = phi_5896_;
                                    if (_e3307 < 0f) {
                                        phi_5902_ = -(_e3307);
                                    } else {
                                        phi_5902_ = _e3307;
                                    }
                                    let _e3399 = phi_5902_;
                                    if (_e3310 < 0f) {
                                        phi_5908_ = -(_e3310);
                                    } else {
                                        phi_5908_ = _e3310;
                                    }
                                    let _e3403 = phi_5908_;
                                    if (_e3313 < 0f) {
                                        phi_5915_ = -(_e3313);
                                    } else {
                                        phi_5915_ = _e3313;
                                    }
                                    let _e3408 = phi_5915_;
                                    let _e3409 = ((_e3399 + _e3403) + _e3408);
                                    let _e3414 = -(_e3395);
                                    if (_e3374 > _e3414) {
                                        phi_5926_ = _e3374;
                                    } else {
                                        phi_5926_ = _e3414;
                                    }
                                    let _e3417 = phi_5926_;
                                    let _e3422 = (((_e3417 - ((_e3409 * _e3297) * (0.000000059604645f * (17f / 2f)))) - (_e3409 * _e3304)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3425 = ((_e3075 * _e3069) - (_e3078 * _e3068));
                                    let _e3428 = ((_e3078 * _e3067) - (_e3072 * _e3069));
                                    let _e3431 = ((_e3072 * _e3068) - (_e3075 * _e3067));
                                    let _e3436 = (((_e3425 * _e3081[0]) + (_e3428 * _e3081[1])) + (_e3431 * _e3081[2]));
                                    let _e3441 = (((_e3425 * _e3097) + (_e3428 * _e3098)) + (_e3431 * _e3099));
                                    let _e3446 = (((_e3425 * _e3103) + (_e3428 * _e3104)) + (_e3431 * _e3105));
                                    let _e3451 = (((_e3425 * _e3100) + (_e3428 * _e3101)) + (_e3431 * _e3102));
                                    let _e3456 = (((_e3425 * _e3108[0]) + (_e3428 * _e3108[1])) + (_e3431 * _e3108[2]));
                                    let _e3461 = (((_e3425 * _e3124) + (_e3428 * _e3125)) + (_e3431 * _e3126));
                                    let _e3466 = (((_e3425 * _e3130) + (_e3428 * _e3131)) + (_e3431 * _e3132));
                                    let _e3471 = (((_e3425 * _e3127) + (_e3428 * _e3128)) + (_e3431 * _e3129));
                                    if (_e3436 < _e3441) {
                                        phi_5997_ = _e3436;
                                    } else {
                                        phi_5997_ = _e3441;
                                    }
                                    let _e3474 = phi_5997_;
                                    if (_e3446 < _e3451) {
                                        phi_6002_ = _e3446;
                                    } else {
                                        phi_6002_ = _e3451;
                                    }
                                    let _e3477 = phi_6002_;
                                    if (_e3474 < _e3477) {
                                        phi_6007_ = _e3474;
                                    } else {
                                        phi_6007_ = _e3477;
                                    }
                                    let _e3480 = phi_6007_;
                                    if (_e3456 < _e3461) {
                                        phi_6012_ = _e3456;
                                    } else {
                                        phi_6012_ = _e3461;
                                    }
                                    let _e3483 = phi_6012_;
                                    if (_e3466 < _e3471) {
                                        phi_6017_ = _e3466;
                                    } else {
                                        phi_6017_ = _e3471;
                                    }
                                    let _e3486 = phi_6017_;
                                    if (_e3483 < _e3486) {
                                        phi_6022_ = _e3483;
                                    } else {
                                        phi_6022_ = _e3486;
                                    }
                                    let _e3489 = phi_6022_;
                                    if (_e3480 < _e3489) {
                                        phi_6027_ = _e3480;
                                    } else {
                                        phi_6027_ = _e3489;
                                    }
                                    let _e3492 = phi_6027_;
                                    if (_e3436 > _e3441) {
                                        phi_6032_ = _e3436;
                                    } else {
                                        phi_6032_ = _e3441;
                                    }
                                    let _e3495 = phi_6032_;
                                    if (_e3446 > _e3451) {
                                        phi_6037_ = _e3446;
                                    } else {
                                        phi_6037_ = _e3451;
                                    }
                                    let _e3498 = phi_6037_;
                                    if (_e3495 > _e3498) {
                                        phi_6042_ = _e3495;
                                    } else {
                                        phi_6042_ = _e3498;
                                    }
                                    let _e3501 = phi_6042_;
                                    if (_e3456 > _e3461) {
                                        phi_6047_ = _e3456;
                                    } else {
                                        phi_6047_ = _e3461;
                                    }
                                    let _e3504 = phi_6047_;
                                    if (_e3466 > _e3471) {
                                        phi_6052_ = _e3466;
                                    } else {
                                        phi_6052_ = _e3471;
                                    }
                                    let _e3507 = phi_6052_;
                                    if (_e3504 > _e3507) {
                                        phi_6057_ = _e3504;
                                    } else {
                                        phi_6057_ = _e3507;
                                    }
                                    let _e3510 = phi_6057_;
                                    if (_e3501 > _e3510) {
                                        phi_6062_ = _e3501;
                                    } else {
                                        phi_6062_ = _e3510;
                                    }
                                    let _e3513 = phi_6062_;
                                    if (_e3425 < 0f) {
                                        phi_6068_ = -(_e3425);
                                    } else {
                                        phi_6068_ = _e3425;
                                    }
                                    let _e3517 = phi_6068_;
                                    if (_e3428 < 0f) {
                                        phi_6074_ = -(_e3428);
                                    } else {
                                        phi_6074_ = _e3428;
                                    }
                                    let _e3521 = phi_6074_;
                                    if (_e3431 < 0f) {
                                        phi_6081_ = -(_e3431);
                                    } else {
                                        phi_6081_ = _e3431;
                                    }
                                    let _e3526 = phi_6081_;
                                    let _e3527 = ((_e3517 + _e3521) + _e3526);
                                    let _e3532 = -(_e3513);
                                    if (_e3492 > _e3532) {
                                        phi_6092_ = _e3492;
                                    } else {
                                        phi_6092_ = _e3532;
                                    }
                                    let _e3535 = phi_6092_;
                                    let _e3540 = (((_e3535 - ((_e3527 * _e3297) * (0.000000059604645f * (17f / 2f)))) - (_e3527 * _e3304)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3422 > _e3540) {
                                        phi_6102_ = _e3422;
                                    } else {
                                        phi_6102_ = _e3540;
                                    }
                                    let _e3543 = phi_6102_;
                                    phi_6284_ = (_e3039 || (_e3543 > 0f));
                                }
                                let _e3547 = phi_6284_;
                                if _e3547 {
                                    let _e3550 = local_1.member_1[0u];
                                    let _e3556 = local_1.member_2[0u];
                                    let _e3562 = ((_e3550[1] * _e3556[2]) - (_e3550[2] * _e3556[1]));
                                    let _e3565 = ((_e3550[2] * _e3556[0]) - (_e3550[0] * _e3556[2]));
                                    let _e3568 = ((_e3550[0] * _e3556[1]) - (_e3550[1] * _e3556[0]));
                                    let _e3571 = local_1.member_1[1u];
                                    let _e3577 = local_1.member_2[1u];
                                    let _e3583 = ((_e3571[1] * _e3577[2]) - (_e3571[2] * _e3577[1]));
                                    let _e3586 = ((_e3571[2] * _e3577[0]) - (_e3571[0] * _e3577[2]));
                                    let _e3589 = ((_e3571[0] * _e3577[1]) - (_e3571[1] * _e3577[0]));
                                    let _e3592 = local_1.member_1[0u];
                                    let _e3598 = local_1.member_2[1u];
                                    let _e3613 = local_1.member_1[1u];
                                    let _e3619 = local_1.member_2[0u];
                                    let _e3632 = (((_e3592[1] * _e3598[2]) - (_e3592[2] * _e3598[1])) + ((_e3613[1] * _e3619[2]) - (_e3613[2] * _e3619[1])));
                                    let _e3633 = (((_e3592[2] * _e3598[0]) - (_e3592[0] * _e3598[2])) + ((_e3613[2] * _e3619[0]) - (_e3613[0] * _e3619[2])));
                                    let _e3634 = (((_e3592[0] * _e3598[1]) - (_e3592[1] * _e3598[0])) + ((_e3613[0] * _e3619[1]) - (_e3613[1] * _e3619[0])));
                                    let _e3637 = local_1.member[0u];
                                    let _e3648 = local_1.member[1u];
                                    let _e3659 = local_1.member[0u];
                                    let _e3668 = ((((_e3648[0] * _e3562) + (_e3648[1] * _e3565)) + (_e3648[2] * _e3568)) + (((_e3659[0] * _e3632) + (_e3659[1] * _e3633)) + (_e3659[2] * _e3634)));
                                    let _e3671 = local_1.member[0u];
                                    let _e3682 = local_1.member[1u];
                                    let _e3691 = ((((_e3671[0] * _e3583) + (_e3671[1] * _e3586)) + (_e3671[2] * _e3589)) + (((_e3682[0] * _e3632) + (_e3682[1] * _e3633)) + (_e3682[2] * _e3634)));
                                    let _e3694 = local_1.member[1u];
                                    let _e3705 = local_1.member[0u];
                                    if (_e3705[0] < 0f) {
                                        phi_6529_ = -(_e3705[0]);
                                    } else {
                                        phi_6529_ = _e3705[0];
                                    }
                                    let _e3712 = phi_6529_;
                                    if (_e3705[1] < 0f) {
                                        phi_6536_ = -(_e3705[1]);
                                    } else {
                                        phi_6536_ = _e3705[1];
                                    }
                                    let _e3716 = phi_6536_;
                                    if (_e3712 > _e3716) {
                                        phi_6541_ = _e3712;
                                    } else {
                                        phi_6541_ = _e3716;
                                    }
                                    let _e3719 = phi_6541_;
                                    if (_e3705[2] < 0f) {
                                        phi_6548_ = -(_e3705[2]);
                                    } else {
                                        phi_6548_ = _e3705[2];
                                    }
                                    let _e3723 = phi_6548_;
                                    if (_e3719 > _e3723) {
                                        phi_6553_ = _e3719;
                                    } else {
                                        phi_6553_ = _e3723;
                                    }
                                    let _e3726 = phi_6553_;
                                    let _e3729 = local_1.member[1u];
                                    if (_e3729[0] < 0f) {
                                        phi_6566_ = -(_e3729[0]);
                                    } else {
                                        phi_6566_ = _e3729[0];
                                    }
                                    let _e3736 = phi_6566_;
                                    if (_e3729[1] < 0f) {
                                        phi_6573_ = -(_e3729[1]);
                                    } else {
                                        phi_6573_ = _e3729[1];
                                    }
                                    let _e3740 = phi_6573_;
                                    if (_e3736 > _e3740) {
                                        phi_6578_ = _e3736;
                                    } else {
                                        phi_6578_ = _e3740;
                                    }
                                    let _e3743 = phi_6578_;
                                    if (_e3729[2] < 0f) {
                                        phi_6585_ = -(_e3729[2]);
                                    } else {
                                        phi_6585_ = _e3729[2];
                                    }
                                    let _e3747 = phi_6585_;
                                    if (_e3743 > _e3747) {
                                        phi_6590_ = _e3743;
                                    } else {
                                        phi_6590_ = _e3747;
                                    }
                                    let _e3750 = phi_6590_;
                                    if (_e3726 > _e3750) {
                                        phi_6595_ = _e3726;
                                    } else {
                                        phi_6595_ = _e3750;
                                    }
                                    let _e3753 = phi_6595_;
                                    let _e3755 = local_1.member_3;
                                    let _e3756 = (_e3753 + _e3755);
                                    let _e3759 = local_1.member_1[0u];
                                    if (_e3759[0] < 0f) {
                                        phi_6612_ = -(_e3759[0]);
                                    } else {
                                        phi_6612_ = _e3759[0];
                                    }
                                    let _e3766 = phi_6612_;
                                    if (_e3759[1] < 0f) {
                                        phi_6619_ = -(_e3759[1]);
                                    } else {
                                        phi_6619_ = _e3759[1];
                                    }
                                    let _e3770 = phi_6619_;
                                    if (_e3766 > _e3770) {
                                        phi_6624_ = _e3766;
                                    } else {
                                        phi_6624_ = _e3770;
                                    }
                                    let _e3773 = phi_6624_;
                                    if (_e3759[2] < 0f) {
                                        phi_6631_ = -(_e3759[2]);
                                    } else {
                                        phi_6631_ = _e3759[2];
                                    }
                                    let _e3777 = phi_6631_;
                                    if (_e3773 > _e3777) {
                                        phi_6636_ = _e3773;
                                    } else {
                                        phi_6636_ = _e3777;
                                    }
                                    let _e3780 = phi_6636_;
                                    let _e3783 = local_1.member_1[1u];
                                    if (_e3783[0] < 0f) {
                                        phi_6650_ = -(_e3783[0]);
                                    } else {
                                        phi_6650_ = _e3783[0];
                                    }
                                    let _e3790 = phi_6650_;
                                    if (_e3783[1] < 0f) {
                                        phi_6657_ = -(_e3783[1]);
                                    } else {
                                        phi_6657_ = _e3783[1];
                                    }
                                    let _e3794 = phi_6657_;
                                    if (_e3790 > _e3794) {
                                        phi_6662_ = _e3790;
                                    } else {
                                        phi_6662_ = _e3794;
                                    }
                                    let _e3797 = phi_6662_;
                                    if (_e3783[2] < 0f) {
                                        phi_6669_ = -(_e3783[2]);
                                    } else {
                                        phi_6669_ = _e3783[2];
                                    }
                                    let _e3801 = phi_6669_;
                                    if (_e3797 > _e3801) {
                                        phi_6674_ = _e3797;
                                    } else {
                                        phi_6674_ = _e3801;
                                    }
                                    let _e3804 = phi_6674_;
                                    if (_e3780 > _e3804) {
                                        phi_6679_ = _e3780;
                                    } else {
                                        phi_6679_ = _e3804;
                                    }
                                    let _e3807 = phi_6679_;
                                    let _e3809 = local_1.member_3;
                                    let _e3810 = (_e3807 + _e3809);
                                    let _e3813 = local_1.member_2[0u];
                                    if (_e3813[0] < 0f) {
                                        phi_6696_ = -(_e3813[0]);
                                    } else {
                                        phi_6696_ = _e3813[0];
                                    }
                                    let _e3820 = phi_6696_;
                                    if (_e3813[1] < 0f) {
                                        phi_6703_ = -(_e3813[1]);
                                    } else {
                                        phi_6703_ = _e3813[1];
                                    }
                                    let _e3824 = phi_6703_;
                                    if (_e3820 > _e3824) {
                                        phi_6708_ = _e3820;
                                    } else {
                                        phi_6708_ = _e3824;
                                    }
                                    let _e3827 = phi_6708_;
                                    if (_e3813[2] < 0f) {
                                        phi_6715_ = -(_e3813[2]);
                                    } else {
                                        phi_6715_ = _e3813[2];
                                    }
                                    let _e3831 = phi_6715_;
                                    if (_e3827 > _e3831) {
                                        phi_6720_ = _e3827;
                                    } else {
                                        phi_6720_ = _e3831;
                                    }
                                    let _e3834 = phi_6720_;
                                    let _e3837 = local_1.member_2[1u];
                                    if (_e3837[0] < 0f) {
                                        phi_6734_ = -(_e3837[0]);
                                    } else {
                                        phi_6734_ = _e3837[0];
                                    }
                                    let _e3844 = phi_6734_;
                                    if (_e3837[1] < 0f) {
                                        phi_6741_ = -(_e3837[1]);
                                    } else {
                                        phi_6741_ = _e3837[1];
                                    }
                                    let _e3848 = phi_6741_;
                                    if (_e3844 > _e3848) {
                                        phi_6746_ = _e3844;
                                    } else {
                                        phi_6746_ = _e3848;
                                    }
                                    let _e3851 = phi_6746_;
                                    if (_e3837[2] < 0f) {
                                        phi_6753_ = -(_e3837[2]);
                                    } else {
                                        phi_6753_ = _e3837[2];
                                    }
                                    let _e3855 = phi_6753_;
                                    if (_e3851 > _e3855) {
                                        phi_6758_ = _e3851;
                                    } else {
                                        phi_6758_ = _e3855;
                                    }
                                    let _e3858 = phi_6758_;
                                    if (_e3834 > _e3858) {
                                        phi_6763_ = _e3834;
                                    } else {
                                        phi_6763_ = _e3858;
                                    }
                                    let _e3861 = phi_6763_;
                                    let _e3863 = local_1.member_3;
                                    let _e3864 = (_e3861 + _e3863);
                                    let _e3866 = ((_e3810 * 8f) * _e3864);
                                    let _e3873 = local_1.member_3;
                                    if (_e3562 < 0f) {
                                        phi_6794_ = -(_e3562);
                                    } else {
                                        phi_6794_ = _e3562;
                                    }
                                    let _e3890 = phi_6794_;
                                    if (_e3565 < 0f) {
                                        phi_6800_ = -(_e3565);
                                    } else {
                                        phi_6800_ = _e3565;
                                    }
                                    let _e3894 = phi_6800_;
                                    if (_e3568 < 0f) {
                                        phi_6807_ = -(_e3568);
                                    } else {
                                        phi_6807_ = _e3568;
                                    }
                                    let _e3899 = phi_6807_;
                                    let _e3900 = ((_e3890 + _e3894) + _e3899);
                                    if (_e3583 < 0f) {
                                        phi_6814_ = -(_e3583);
                                    } else {
                                        phi_6814_ = _e3583;
                                    }
                                    let _e3904 = phi_6814_;
                                    if (_e3586 < 0f) {
                                        phi_6820_ = -(_e3586);
                                    } else {
                                        phi_6820_ = _e3586;
                                    }
                                    let _e3908 = phi_6820_;
                                    if (_e3589 < 0f) {
                                        phi_6827_ = -(_e3589);
                                    } else {
                                        phi_6827_ = _e3589;
                                    }
                                    let _e3913 = phi_6827_;
                                    let _e3914 = ((_e3904 + _e3908) + _e3913);
                                    if (_e3900 > _e3914) {
                                        phi_6833_ = _e3900;
                                    } else {
                                        phi_6833_ = _e3914;
                                    }
                                    let _e3917 = phi_6833_;
                                    if (_e3632 < 0f) {
                                        phi_6839_ = -(_e3632);
                                    } else {
                                        phi_6839_ = _e3632;
                                    }
                                    let _e3921 = phi_6839_;
                                    if (_e3633 < 0f) {
                                        phi_6845_ = -(_e3633);
                                    } else {
                                        phi_6845_ = _e3633;
                                    }
                                    let _e3925 = phi_6845_;
                                    if (_e3634 < 0f) {
                                        phi_6852_ = -(_e3634);
                                    } else {
                                        phi_6852_ = _e3634;
                                    }
                                    let _e3930 = phi_6852_;
                                    let _e3932 = (((_e3921 + _e3925) + _e3930) * 0.5f);
                                    if (_e3917 > _e3932) {
                                        phi_6859_ = _e3917;
                                    } else {
                                        phi_6859_ = _e3932;
                                    }
                                    let _e3935 = phi_6859_;
                                    let _e3940 = local_1.member_3;
                                    let _e3953 = ((((_e3637[0] * _e3562) + (_e3637[1] * _e3565)) + (_e3637[2] * _e3568)) * 3f);
                                    let _e3954 = ((((_e3694[0] * _e3583) + (_e3694[1] * _e3586)) + (_e3694[2] * _e3589)) * 3f);
                                    if (_e3953 < _e3954) {
                                        phi_6883_ = _e3953;
                                    } else {
                                        phi_6883_ = _e3954;
                                    }
                                    let _e3957 = phi_6883_;
                                    if (_e3668 < _e3691) {
                                        phi_6888_ = _e3668;
                                    } else {
                                        phi_6888_ = _e3691;
                                    }
                                    let _e3960 = phi_6888_;
                                    if (_e3957 < _e3960) {
                                        phi_6893_ = _e3957;
                                    } else {
                                        phi_6893_ = _e3960;
                                    }
                                    let _e3963 = phi_6893_;
                                    if (_e3953 > _e3954) {
                                        phi_6898_ = _e3953;
                                    } else {
                                        phi_6898_ = _e3954;
                                    }
                                    let _e3966 = phi_6898_;
                                    if (_e3668 > _e3691) {
                                        phi_6903_ = _e3668;
                                    } else {
                                        phi_6903_ = _e3691;
                                    }
                                    let _e3969 = phi_6903_;
                                    if (_e3966 > _e3969) {
                                        phi_6908_ = _e3966;
                                    } else {
                                        phi_6908_ = _e3969;
                                    }
                                    let _e3972 = phi_6908_;
                                    let _e3977 = -(_e3972);
                                    if (_e3963 > _e3977) {
                                        phi_6918_ = _e3963;
                                    } else {
                                        phi_6918_ = _e3977;
                                    }
                                    let _e3980 = phi_6918_;
                                    let _e3982 = ((_e3980 - ((((((_e3756 * 8f) * _e3866) * (0.000000059604645f * (524f / 64f))) + ((_e3873 * 19f) * ((_e3756 * (_e3810 + _e3864)) + (_e3810 * _e3864)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3756) * ((1f + _e3810) * (1f + _e3864))))) + ((_e1494 * (((_e3935 + (_e3866 * (0.000000059604645f * 8f))) + ((_e3940 * 6f) * (_e3810 + _e3864))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3810) * (1f + _e3864))))) * (3f * 1.0001f)))) > 0f);
                                    if _e3982 {
                                        phi_7887_ = _e3982;
                                    } else {
                                        let _e3985 = local_1.member_1[0u];
                                        let _e3991 = local_1.member_1[1u];
                                        let _e3995 = (_e3985[0] + _e3991[0]);
                                        let _e3996 = (_e3985[1] + _e3991[1]);
                                        let _e3997 = (_e3985[2] + _e3991[2]);
                                        let _e4000 = local_1.member_2[0u];
                                        let _e4006 = local_1.member_2[1u];
                                        let _e4010 = (_e4000[0] + _e4006[0]);
                                        let _e4011 = (_e4000[1] + _e4006[1]);
                                        let _e4012 = (_e4000[2] + _e4006[2]);
                                        let _e4015 = ((_e3996 * _e4012) - (_e3997 * _e4011));
                                        let _e4018 = ((_e3997 * _e4010) - (_e3995 * _e4012));
                                        let _e4021 = ((_e3995 * _e4011) - (_e3996 * _e4010));
                                        let _e4024 = local_1.member[0u];
                                        let _e4030 = local_1.member_1[0u];
                                        let _e4036 = local_1.member_2[0u];
                                        let _e4040 = (_e4024[0] - _e4030[0]);
                                        let _e4041 = (_e4024[1] - _e4030[1]);
                                        let _e4042 = (_e4024[2] - _e4030[2]);
                                        let _e4043 = (_e4040 - _e4036[0]);
                                        let _e4044 = (_e4041 - _e4036[1]);
                                        let _e4045 = (_e4042 - _e4036[2]);
                                        let _e4046 = (_e4024[0] - _e4036[0]);
                                        let _e4047 = (_e4024[1] - _e4036[1]);
                                        let _e4048 = (_e4024[2] - _e4036[2]);
                                        let _e4051 = local_1.member[1u];
                                        let _e4057 = local_1.member_1[1u];
                                        let _e4063 = local_1.member_2[1u];
                                        let _e4067 = (_e4051[0] - _e4057[0]);
                                        let _e4068 = (_e4051[1] - _e4057[1]);
                                        let _e4069 = (_e4051[2] - _e4057[2]);
                                        let _e4070 = (_e4067 - _e4063[0]);
                                        let _e4071 = (_e4068 - _e4063[1]);
                                        let _e4072 = (_e4069 - _e4063[2]);
                                        let _e4073 = (_e4051[0] - _e4063[0]);
                                        let _e4074 = (_e4051[1] - _e4063[1]);
                                        let _e4075 = (_e4051[2] - _e4063[2]);
                                        let _e4078 = local_1.member[0u];
                                        if (_e4078[0] < 0f) {
                                            phi_7121_ = -(_e4078[0]);
                                        } else {
                                            phi_7121_ = _e4078[0];
                                        }
                                        let _e4085 = phi_7121_;
                                        if (_e4078[1] < 0f) {
                                            phi_7128_ = -(_e4078[1]);
                                        } else {
                                            phi_7128_ = _e4078[1];
                                        }
                                        let _e4089 = phi_7128_;
                                        if (_e4085 > _e4089) {
                                            phi_7133_ = _e4085;
                                        } else {
                                            phi_7133_ = _e4089;
                                        }
                                        let _e4092 = phi_7133_;
                                        if (_e4078[2] < 0f) {
                                            phi_7140_ = -(_e4078[2]);
                                        } else {
                                            phi_7140_ = _e4078[2];
                                        }
                                        let _e4096 = phi_7140_;
                                        if (_e4092 > _e4096) {
                                            phi_7145_ = _e4092;
                                        } else {
                                            phi_7145_ = _e4096;
                                        }
                                        let _e4099 = phi_7145_;
                                        let _e4102 = local_1.member[1u];
                                        if (_e4102[0] < 0f) {
                                            phi_7158_ = -(_e4102[0]);
                                        } else {
                                            phi_7158_ = _e4102[0];
                                        }
                                        let _e4109 = phi_7158_;
                                        if (_e4102[1] < 0f) {
                                            phi_7165_ = -(_e4102[1]);
                                        } else {
                                            phi_7165_ = _e4102[1];
                                        }
                                        let _e4113 = phi_7165_;
                                        if (_e4109 > _e4113) {
                                            phi_7170_ = _e4109;
                                        } else {
                                            phi_7170_ = _e4113;
                                        }
                                        let _e4116 = phi_7170_;
                                        if (_e4102[2] < 0f) {
                                            phi_7177_ = -(_e4102[2]);
                                        } else {
                                            phi_7177_ = _e4102[2];
                                        }
                                        let _e4120 = phi_7177_;
                                        if (_e4116 > _e4120) {
                                            phi_7182_ = _e4116;
                                        } else {
                                            phi_7182_ = _e4120;
                                        }
                                        let _e4123 = phi_7182_;
                                        if (_e4099 > _e4123) {
                                            phi_7187_ = _e4099;
                                        } else {
                                            phi_7187_ = _e4123;
                                        }
                                        let _e4126 = phi_7187_;
                                        let _e4128 = local_1.member_3;
                                        let _e4132 = local_1.member_1[0u];
                                        if (_e4132[0] < 0f) {
                                            phi_7204_ = -(_e4132[0]);
                                        } else {
                                            phi_7204_ = _e4132[0];
                                        }
                                        let _e4139 = phi_7204_;
                                        if (_e4132[1] < 0f) {
                                            phi_7211_ = -(_e4132[1]);
                                        } else {
                                            phi_7211_ = _e4132[1];
                                        }
                                        let _e4143 = phi_7211_;
                                        if (_e4139 > _e4143) {
                                            phi_7216_ = _e4139;
                                        } else {
                                            phi_7216_ = _e4143;
                                        }
                                        let _e4146 = phi_7216_;
                                        if (_e4132[2] < 0f) {
                                            phi_7223_ = -(_e4132[2]);
                                        } else {
                                            phi_7223_ = _e4132[2];
                                        }
                                        let _e4150 = phi_7223_;
                                        if (_e4146 > _e4150) {
                                            phi_7228_ = _e4146;
                                        } else {
                                            phi_7228_ = _e4150;
                                        }
                                        let _e4153 = phi_7228_;
                                        let _e4156 = local_1.member_1[1u];
                                        if (_e4156[0] < 0f) {
                                            phi_7242_ = -(_e4156[0]);
                                        } else {
                                            phi_7242_ = _e4156[0];
                                        }
                                        let _e4163 = phi_7242_;
                                        if (_e4156[1] < 0f) {
                                            phi_7249_ = -(_e4156[1]);
                                        } else {
                                            phi_7249_ = _e4156[1];
                                        }
                                        let _e4167 = phi_7249_;
                                        if (_e4163 > _e4167) {
                                            phi_7254_ = _e4163;
                                        } else {
                                            phi_7254_ = _e4167;
                                        }
                                        let _e4170 = phi_7254_;
                                        if (_e4156[2] < 0f) {
                                            phi_7261_ = -(_e4156[2]);
                                        } else {
                                            phi_7261_ = _e4156[2];
                                        }
                                        let _e4174 = phi_7261_;
                                        if (_e4170 > _e4174) {
                                            phi_7266_ = _e4170;
                                        } else {
                                            phi_7266_ = _e4174;
                                        }
                                        let _e4177 = phi_7266_;
                                        if (_e4153 > _e4177) {
                                            phi_7271_ = _e4153;
                                        } else {
                                            phi_7271_ = _e4177;
                                        }
                                        let _e4180 = phi_7271_;
                                        let _e4182 = local_1.member_3;
                                        let _e4186 = local_1.member_2[0u];
                                        if (_e4186[0] < 0f) {
                                            phi_7288_ = -(_e4186[0]);
                                        } else {
                                            phi_7288_ = _e4186[0];
                                        }
                                        let _e4193 = phi_7288_;
                                        if (_e4186[1] < 0f) {
                                            phi_7295_ = -(_e4186[1]);
                                        } else {
                                            phi_7295_ = _e4186[1];
                                        }
                                        let _e4197 = phi_7295_;
                                        if (_e4193 > _e4197) {
                                            phi_7300_ = _e4193;
                                        } else {
                                            phi_7300_ = _e4197;
                                        }
                                        let _e4200 = phi_7300_;
                                        if (_e4186[2] < 0f) {
                                            phi_7307_ = -(_e4186[2]);
                                        } else {
                                            phi_7307_ = _e4186[2];
                                        }
                                        let _e4204 = phi_7307_;
                                        if (_e4200 > _e4204) {
                                            phi_7312_ = _e4200;
                                        } else {
                                            phi_7312_ = _e4204;
                                        }
                                        let _e4207 = phi_7312_;
                                        let _e4210 = local_1.member_2[1u];
                                        if (_e4210[0] < 0f) {
                                            phi_7326_ = -(_e4210[0]);
                                        } else {
                                            phi_7326_ = _e4210[0];
                                        }
                                        let _e4217 = phi_7326_;
                                        if (_e4210[1] < 0f) {
                                            phi_7333_ = -(_e4210[1]);
                                        } else {
                                            phi_7333_ = _e4210[1];
                                        }
                                        let _e4221 = phi_7333_;
                                        if (_e4217 > _e4221) {
                                            phi_7338_ = _e4217;
                                        } else {
                                            phi_7338_ = _e4221;
                                        }
                                        let _e4224 = phi_7338_;
                                        if (_e4210[2] < 0f) {
                                            phi_7345_ = -(_e4210[2]);
                                        } else {
                                            phi_7345_ = _e4210[2];
                                        }
                                        let _e4228 = phi_7345_;
                                        if (_e4224 > _e4228) {
                                            phi_7350_ = _e4224;
                                        } else {
                                            phi_7350_ = _e4228;
                                        }
                                        let _e4231 = phi_7350_;
                                        if (_e4207 > _e4231) {
                                            phi_7355_ = _e4207;
                                        } else {
                                            phi_7355_ = _e4231;
                                        }
                                        let _e4234 = phi_7355_;
                                        let _e4236 = local_1.member_3;
                                        let _e4240 = ((((_e4126 + _e4128) + (_e4180 + _e4182)) + (_e4234 + _e4236)) * 2f);
                                        let _e4243 = local_1.member_3;
                                        let _e4247 = (((_e1494 * 1.0001f) + (_e4243 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4250 = ((_e4018 * _e3997) - (_e4021 * _e3996));
                                        let _e4253 = ((_e4021 * _e3995) - (_e4015 * _e3997));
                                        let _e4256 = ((_e4015 * _e3996) - (_e4018 * _e3995));
                                        let _e4261 = (((_e4250 * _e4024[0]) + (_e4253 * _e4024[1])) + (_e4256 * _e4024[2]));
                                        let _e4266 = (((_e4250 * _e4040) + (_e4253 * _e4041)) + (_e4256 * _e4042));
                                        let _e4271 = (((_e4250 * _e4046) + (_e4253 * _e4047)) + (_e4256 * _e4048));
                                        let _e4276 = (((_e4250 * _e4043) + (_e4253 * _e4044)) + (_e4256 * _e4045));
                                        let _e4281 = (((_e4250 * _e4051[0]) + (_e4253 * _e4051[1])) + (_e4256 * _e4051[2]));
                                        let _e4286 = (((_e4250 * _e4067) + (_e4253 * _e4068)) + (_e4256 * _e4069));
                                        let _e4291 = (((_e4250 * _e4073) + (_e4253 * _e4074)) + (_e4256 * _e4075));
                                        let _e4296 = (((_e4250 * _e4070) + (_e4253 * _e4071)) + (_e4256 * _e4072));
                                        if (_e4261 < _e4266) {
                                            phi_7434_ = _e4261;
                                        } else {
                                            phi_7434_ = _e4266;
                                        }
                                        let _e4299 = phi_7434_;
                                        if (_e4271 < _e4276) {
                                            phi_7439_ = _e4271;
                                        } else {
                                            phi_7439_ = _e4276;
                                        }
                                        let _e4302 = phi_7439_;
                                        if (_e4299 < _e4302) {
                                            phi_7444_ = _e4299;
                                        } else {
                                            phi_7444_ = _e4302;
                                        }
                                        let _e4305 = phi_7444_;
                                        if (_e4281 < _e4286) {
                                            phi_7449_ = _e4281;
                                        } else {
                                            phi_7449_ = _e4286;
                                        }
                                        let _e4308 = phi_7449_;
                                        if (_e4291 < _e4296) {
                                            phi_7454_ = _e4291;
                                        } else {
                                            phi_7454_ = _e4296;
                                        }
                                        let _e4311 = phi_7454_;
                                        if (_e4308 < _e4311) {
                                            phi_7459_ = _e4308;
                                        } else {
                                            phi_7459_ = _e4311;
                                        }
                                        let _e4314 = phi_7459_;
                                        if (_e4305 < _e4314) {
                                            phi_7464_ = _e4305;
                                        } else {
                                            phi_7464_ = _e4314;
                                        }
                                        let _e4317 = phi_7464_;
                                        if (_e4261 > _e4266) {
                                            phi_7469_ = _e4261;
                                        } else {
                                            phi_7469_ = _e4266;
                                        }
                                        let _e4320 = phi_7469_;
                                        if (_e4271 > _e4276) {
                                            phi_7474_ = _e4271;
                                        } else {
                                            phi_7474_ = _e4276;
                                        }
                                        let _e4323 = phi_7474_;
                                        if (_e4320 > _e4323) {
                                            phi_7479_ = _e4320;
                                        } else {
                                            phi_7479_ = _e4323;
                                        }
                                        let _e4326 = phi_7479_;
                                        if (_e4281 > _e4286) {
                                            phi_7484_ = _e4281;
                                        } else {
                                            phi_7484_ = _e4286;
                                        }
                                        let _e4329 = phi_7484_;
                                        if (_e4291 > _e4296) {
                                            phi_7489_ = _e4291;
                                        } else {
                                            phi_7489_ = _e4296;
                                        }
                                        let _e4332 = phi_7489_;
                                        if (_e4329 > _e4332) {
                                            phi_7494_ = _e4329;
                                        } else {
                                            phi_7494_ = _e4332;
                                        }
                                        let _e4335 = phi_7494_;
                                        if (_e4326 > _e4335) {
                                            phi_7499_ = _e4326;
                                        } else {
                                            phi_7499_ = _e4335;
                                        }
                                        let _e4338 = phi_7499_;
                                        if (_e4250 < 0f) {
                                            phi_7505_ = -(_e4250);
                                        } else {
                                            phi_7505_ = _e4250;
                                        }
                                        let _e4342 = phi_7505_;
                                        if (_e4253 < 0f) {
                                            phi_7511_ = -(_e4253);
                                        } else {
                                            phi_7511_ = _e4253;
                                        }
                                        let _e4346 = phi_7511_;
                                        if (_e4256 < 0f) {
                                            phi_7518_ = -(_e4256);
                                        } else {
                                            phi_7518_ = _e4256;
                                        }
                                        let _e4351 = phi_7518_;
                                        let _e4352 = ((_e4342 + _e4346) + _e4351);
                                        let _e4357 = -(_e4338);
                                        if (_e4317 > _e4357) {
                                            phi_7529_ = _e4317;
                                        } else {
                                            phi_7529_ = _e4357;
                                        }
                                        let _e4360 = phi_7529_;
                                        let _e4365 = (((_e4360 - ((_e4352 * _e4240) * (0.000000059604645f * (17f / 2f)))) - (_e4352 * _e4247)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4368 = ((_e4018 * _e4012) - (_e4021 * _e4011));
                                        let _e4371 = ((_e4021 * _e4010) - (_e4015 * _e4012));
                                        let _e4374 = ((_e4015 * _e4011) - (_e4018 * _e4010));
                                        let _e4379 = (((_e4368 * _e4024[0]) + (_e4371 * _e4024[1])) + (_e4374 * _e4024[2]));
                                        let _e4384 = (((_e4368 * _e4040) + (_e4371 * _e4041)) + (_e4374 * _e4042));
                                        let _e4389 = (((_e4368 * _e4046) + (_e4371 * _e4047)) + (_e4374 * _e4048));
                                        let _e4394 = (((_e4368 * _e4043) + (_e4371 * _e4044)) + (_e4374 * _e4045));
                                        let _e4399 = (((_e4368 * _e4051[0]) + (_e4371 * _e4051[1])) + (_e4374 * _e4051[2]));
                                        let _e4404 = (((_e4368 * _e4067) + (_e4371 * _e4068)) + (_e4374 * _e4069));
                                        let _e4409 = (((_e4368 * _e4073) + (_e4371 * _e4074)) + (_e4374 * _e4075));
                                        let _e4414 = (((_e4368 * _e4070) + (_e4371 * _e4071)) + (_e4374 * _e4072));
                                        if (_e4379 < _e4384) {
                                            phi_7600_ = _e4379;
                                        } else {
                                            phi_7600_ = _e4384;
                                        }
                                        let _e4417 = phi_7600_;
                                        if (_e4389 < _e4394) {
                                            phi_7605_ = _e4389;
                                        } else {
                                            phi_7605_ = _e4394;
                                        }
                                        let _e4420 = phi_7605_;
                                        if (_e4417 < _e4420) {
                                            phi_7610_ = _e4417;
                                        } else {
                                            phi_7610_ = _e4420;
                                        }
                                        let _e4423 = phi_7610_;
                                        if (_e4399 < _e4404) {
                                            phi_7615_ = _e4399;
                                        } else {
                                            phi_7615_ = _e4404;
                                        }
                                        let _e4426 = phi_7615_;
                                        if (_e4409 < _e4414) {
                                            phi_7620_ = _e4409;
                                        } else {
                                            phi_7620_ = _e4414;
                                        }
                                        let _e4429 = phi_7620_;
                                        if (_e4426 < _e4429) {
                                            phi_7625_ = _e4426;
                                        } else {
                                            phi_7625_ = _e4429;
                                        }
                                        let _e4432 = phi_7625_;
                                        if (_e4423 < _e4432) {
                                            phi_7630_ = _e4423;
                                        } else {
                                            phi_7630_ = _e4432;
                                        }
                                        let _e4435 = phi_7630_;
                                        if (_e4379 > _e4384) {
                                            phi_7635_ = _e4379;
                                        } else {
                                            phi_7635_ = _e4384;
                                        }
                                        let _e4438 = phi_7635_;
                                        if (_e4389 > _e4394) {
                                            phi_7640_ = _e4389;
                                        } else {
                                            phi_7640_ = _e4394;
                                        }
                                        let _e4441 = phi_7640_;
                                        if (_e4438 > _e4441) {
                                            phi_7645_ = _e4438;
                                        } else {
                                            phi_7645_ = _e4441;
                                        }
                                        let _e4444 = phi_7645_;
                                        if (_e4399 > _e4404) {
                                            phi_7650_ = _e4399;
                                        } else {
                                            phi_7650_ = _e4404;
                                        }
                                        let _e4447 = phi_7650_;
                                        if (_e4409 > _e4414) {
                                            phi_7655_ = _e4409;
                                        } else {
                                            phi_7655_ = _e4414;
                                        }
                                        let _e4450 = phi_7655_;
                                        if (_e4447 > _e4450) {
                                            phi_7660_ = _e4447;
                                        } else {
                                            phi_7660_ = _e4450;
                                        }
                                        let _e4453 = phi_7660_;
                                        if (_e4444 > _e4453) {
                                            phi_7665_ = _e4444;
                                        } else {
                                            phi_7665_ = _e4453;
                                        }
                                        let _e4456 = phi_7665_;
                                        if (_e4368 < 0f) {
                                            phi_7671_ = -(_e4368);
                                        } else {
                                            phi_7671_ = _e4368;
                                        }
                                        let _e4460 = phi_7671_;
                                        if (_e4371 < 0f) {
                                            phi_7677_ = -(_e4371);
                                        } else {
                                            phi_7677_ = _e4371;
                                        }
                                        let _e4464 = phi_7677_;
                                        if (_e4374 < 0f) {
                                            phi_7684_ = -(_e4374);
                                        } else {
                                            phi_7684_ = _e4374;
                                        }
                                        let _e4469 = phi_7684_;
                                        let _e4470 = ((_e4460 + _e4464) + _e4469);
                                        let _e4475 = -(_e4456);
                                        if (_e4435 > _e4475) {
                                            phi_7695_ = _e4435;
                                        } else {
                                            phi_7695_ = _e4475;
                                        }
                                        let _e4478 = phi_7695_;
                                        let _e4483 = (((_e4478 - ((_e4470 * _e4240) * (0.000000059604645f * (17f / 2f)))) - (_e4470 * _e4247)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4365 > _e4483) {
                                            phi_7705_ = _e4365;
                                        } else {
                                            phi_7705_ = _e4483;
                                        }
                                        let _e4486 = phi_7705_;
                                        phi_7887_ = (_e3982 || (_e4486 > 0f));
                                    }
                                    let _e4490 = phi_7887_;
                                    phi_7889_ = (_e3547 && _e4490);
                                } else {
                                    phi_7889_ = _e3547;
                                }
                                let _e4493 = phi_7889_;
                                phi_7891_ = (_e2514 || _e4493);
                            }
                            let _e4496 = phi_7891_;
                            if !(_e4496) {
                                let _e4499 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1021] = ((2147483648u | (_e4499 << bitcast<u32>(12i))) | _e1024);
                            }
                        }
                        phi_7902_ = true;
                    }
                    let _e4506 = phi_7902_;
                    phi_7903_ = _e4506;
                } else {
                    phi_7903_ = false;
                }
                let _e4508 = phi_7903_;
                continue;
                continuing {
                    phi_1862_ = _e1013;
                    break if !(_e4508);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4512 = atomicLoad((&counters[5u]));
                if (_e4512 > 0u) {
                    let _e4515 = atomicAdd((&output.member[0u]), _e4512);
                    if ((_e4515 + _e4512) < _e4515) {
                        let _e4519 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4515);
                }
            }
            workgroupBarrier();
            let _e4522 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4525 = atomicLoad((&counters[7u]));
                if (_e4525 > 0u) {
                    let _e4528 = atomicAdd((&output.member[1u]), _e4525);
                    if ((_e4528 + _e4525) < _e4528) {
                        let _e4532 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7953_ = type_9(0u, 16u);
            loop {
                let _e4534 = phi_7953_;
                if (_e4534.member < _e4534.member_1) {
                    phi_7954_ = type_9((_e4534.member + 1u), _e4534.member_1);
                    phi_7977_ = type_9(1u, _e4534.member);
                } else {
                    phi_7954_ = _e4534;
                    phi_7977_ = type_9(0u, type_9().member_1);
                }
                let _e4546 = phi_7954_;
                let _e4548 = phi_7977_;
                if (bitcast<i32>(_e4548.member) != 0i) {
                    let _e4554 = (_e67 + (_e4548.member_1 * 128u));
                    if (_e4554 >= _e999) {
                        phi_8074_ = false;
                    } else {
                        let _e4557 = hits[_e4554];
                        if ((_e4557 & 2147483648u) == 0u) {
                            phi_8000_ = 4294967295u;
                        } else {
                            phi_8000_ = ((_e4557 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4564 = phi_8000_;
                        if (_e4564 != 4294967295u) {
                            let _e4568 = ((_e4557 >> bitcast<u32>(10i)) & 3u);
                            let _e4575 = firsts[(2u * _e4568)];
                            let _e4578 = leaves.member[(_e4575 + ((_e4557 >> bitcast<u32>(5i)) & 31u))];
                            let _e4582 = firsts[((2u * _e4568) + 1u)];
                            let _e4585 = leaves.member[(_e4582 + (_e4557 & 31u))];
                            let _e4590 = params.member.member_1.member_3;
                            let _e4591 = (_e4522 + _e4564);
                            if (_e4578.member_1 < _e4585.member_1) {
                                phi_8055_ = type_9(_e4578.member_1, _e4585.member_1);
                            } else {
                                phi_8055_ = type_9(_e4585.member_1, _e4578.member_1);
                            }
                            let _e4596 = phi_8055_;
                            if (_e4591 < _e4590) {
                                let _e4600 = (2u * _e4591);
                                atomicStore((&output.member[(4u + _e4600)]), _e4596.member);
                                atomicStore((&output.member[(_e4600 + 5u)]), _e4596.member_1);
                            }
                        }
                        phi_8074_ = true;
                    }
                    let _e4606 = phi_8074_;
                    phi_8075_ = _e4606;
                } else {
                    phi_8075_ = false;
                }
                let _e4608 = phi_8075_;
                continue;
                continuing {
                    phi_7953_ = _e4546;
                    break if !(_e4608);
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
