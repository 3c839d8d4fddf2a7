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
    var phi_938_: u32;
    var phi_940_: u32;
    var phi_826_: u32;
    var phi_943_: type_9;
    var phi_946_: u32;
    var phi_944_: type_9;
    var phi_969_: type_9;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1060_: bool;
    var phi_1064_: bool;
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
    var phi_1850_: u32;
    var phi_1851_: bool;
    var phi_947_: u32;
    var phi_1852_: bool;
    var phi_1859_: u32;
    var phi_1862_: type_9;
    var phi_1863_: type_9;
    var phi_1886_: type_9;
    var phi_1983_: bool;
    var phi_1984_: bool;
    var phi_1985_: bool;
    var phi_1989_: bool;
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
    var phi_3108_: f32;
    var phi_3115_: f32;
    var phi_3120_: f32;
    var phi_3127_: f32;
    var phi_3132_: f32;
    var phi_3145_: f32;
    var phi_3152_: f32;
    var phi_3157_: f32;
    var phi_3164_: f32;
    var phi_3169_: f32;
    var phi_3174_: f32;
    var phi_3191_: f32;
    var phi_3198_: f32;
    var phi_3203_: f32;
    var phi_3210_: f32;
    var phi_3215_: f32;
    var phi_3229_: f32;
    var phi_3236_: f32;
    var phi_3241_: f32;
    var phi_3248_: f32;
    var phi_3253_: f32;
    var phi_3258_: f32;
    var phi_3275_: f32;
    var phi_3282_: f32;
    var phi_3287_: f32;
    var phi_3294_: f32;
    var phi_3299_: f32;
    var phi_3313_: f32;
    var phi_3320_: f32;
    var phi_3325_: f32;
    var phi_3332_: f32;
    var phi_3337_: f32;
    var phi_3342_: f32;
    var phi_3373_: f32;
    var phi_3379_: f32;
    var phi_3386_: f32;
    var phi_3393_: f32;
    var phi_3399_: f32;
    var phi_3406_: f32;
    var phi_3412_: f32;
    var phi_3418_: f32;
    var phi_3424_: f32;
    var phi_3431_: f32;
    var phi_3438_: f32;
    var phi_3462_: f32;
    var phi_3467_: f32;
    var phi_3472_: f32;
    var phi_3477_: f32;
    var phi_3482_: f32;
    var phi_3487_: f32;
    var phi_3497_: f32;
    var phi_3700_: f32;
    var phi_3707_: f32;
    var phi_3712_: f32;
    var phi_3719_: f32;
    var phi_3724_: f32;
    var phi_3737_: f32;
    var phi_3744_: f32;
    var phi_3749_: f32;
    var phi_3756_: f32;
    var phi_3761_: f32;
    var phi_3766_: f32;
    var phi_3783_: f32;
    var phi_3790_: f32;
    var phi_3795_: f32;
    var phi_3802_: f32;
    var phi_3807_: f32;
    var phi_3821_: f32;
    var phi_3828_: f32;
    var phi_3833_: f32;
    var phi_3840_: f32;
    var phi_3845_: f32;
    var phi_3850_: f32;
    var phi_3867_: f32;
    var phi_3874_: f32;
    var phi_3879_: f32;
    var phi_3886_: f32;
    var phi_3891_: f32;
    var phi_3905_: f32;
    var phi_3912_: f32;
    var phi_3917_: f32;
    var phi_3924_: f32;
    var phi_3929_: f32;
    var phi_3934_: f32;
    var phi_4012_: f32;
    var phi_4017_: f32;
    var phi_4022_: f32;
    var phi_4027_: f32;
    var phi_4032_: f32;
    var phi_4037_: f32;
    var phi_4042_: f32;
    var phi_4047_: f32;
    var phi_4052_: f32;
    var phi_4057_: f32;
    var phi_4062_: f32;
    var phi_4067_: f32;
    var phi_4072_: f32;
    var phi_4077_: f32;
    var phi_4083_: f32;
    var phi_4089_: f32;
    var phi_4096_: f32;
    var phi_4106_: f32;
    var phi_4177_: f32;
    var phi_4182_: f32;
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
    var phi_4248_: f32;
    var phi_4254_: f32;
    var phi_4261_: f32;
    var phi_4271_: f32;
    var phi_4281_: f32;
    var phi_4354_: f32;
    var phi_4359_: f32;
    var phi_4364_: f32;
    var phi_4369_: f32;
    var phi_4374_: f32;
    var phi_4379_: f32;
    var phi_4384_: f32;
    var phi_4389_: f32;
    var phi_4394_: f32;
    var phi_4399_: f32;
    var phi_4404_: f32;
    var phi_4409_: f32;
    var phi_4414_: f32;
    var phi_4419_: f32;
    var phi_4425_: f32;
    var phi_4431_: f32;
    var phi_4438_: f32;
    var phi_4448_: f32;
    var phi_4458_: f32;
    var phi_4461_: bool;
    var phi_4913_: f32;
    var phi_4920_: f32;
    var phi_4925_: f32;
    var phi_4932_: f32;
    var phi_4937_: f32;
    var phi_4950_: f32;
    var phi_4957_: f32;
    var phi_4962_: f32;
    var phi_4969_: f32;
    var phi_4974_: f32;
    var phi_4979_: f32;
    var phi_4996_: f32;
    var phi_5003_: f32;
    var phi_5008_: f32;
    var phi_5015_: f32;
    var phi_5020_: f32;
    var phi_5034_: f32;
    var phi_5041_: f32;
    var phi_5046_: f32;
    var phi_5053_: f32;
    var phi_5058_: f32;
    var phi_5063_: f32;
    var phi_5080_: f32;
    var phi_5087_: f32;
    var phi_5092_: f32;
    var phi_5099_: f32;
    var phi_5104_: f32;
    var phi_5118_: f32;
    var phi_5125_: f32;
    var phi_5130_: f32;
    var phi_5137_: f32;
    var phi_5142_: f32;
    var phi_5147_: f32;
    var phi_5178_: f32;
    var phi_5184_: f32;
    var phi_5191_: f32;
    var phi_5198_: f32;
    var phi_5204_: f32;
    var phi_5211_: f32;
    var phi_5217_: f32;
    var phi_5223_: f32;
    var phi_5229_: f32;
    var phi_5236_: f32;
    var phi_5243_: f32;
    var phi_5267_: f32;
    var phi_5272_: f32;
    var phi_5277_: f32;
    var phi_5282_: f32;
    var phi_5287_: f32;
    var phi_5292_: f32;
    var phi_5302_: f32;
    var phi_5505_: f32;
    var phi_5512_: f32;
    var phi_5517_: f32;
    var phi_5524_: f32;
    var phi_5529_: f32;
    var phi_5542_: f32;
    var phi_5549_: f32;
    var phi_5554_: f32;
    var phi_5561_: f32;
    var phi_5566_: f32;
    var phi_5571_: f32;
    var phi_5588_: f32;
    var phi_5595_: f32;
    var phi_5600_: f32;
    var phi_5607_: f32;
    var phi_5612_: f32;
    var phi_5626_: f32;
    var phi_5633_: f32;
    var phi_5638_: f32;
    var phi_5645_: f32;
    var phi_5650_: f32;
    var phi_5655_: f32;
    var phi_5672_: f32;
    var phi_5679_: f32;
    var phi_5684_: f32;
    var phi_5691_: f32;
    var phi_5696_: f32;
    var phi_5710_: f32;
    var phi_5717_: f32;
    var phi_5722_: f32;
    var phi_5729_: f32;
    var phi_5734_: f32;
    var phi_5739_: f32;
    var phi_5817_: f32;
    var phi_5822_: f32;
    var phi_5827_: f32;
    var phi_5832_: f32;
    var phi_5837_: f32;
    var phi_5842_: f32;
    var phi_5847_: f32;
    var phi_5852_: f32;
    var phi_5857_: f32;
    var phi_5862_: f32;
    var phi_5867_: f32;
    var phi_5872_: f32;
    var phi_5877_: f32;
    var phi_5882_: f32;
    var phi_5888_: f32;
    var phi_5894_: f32;
    var phi_5901_: f32;
    var phi_5911_: f32;
    var phi_5982_: f32;
    var phi_5987_: f32;
    var phi_5992_: f32;
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
    var phi_6053_: f32;
    var phi_6059_: f32;
    var phi_6066_: f32;
    var phi_6076_: f32;
    var phi_6086_: f32;
    var phi_6159_: f32;
    var phi_6164_: f32;
    var phi_6169_: f32;
    var phi_6174_: f32;
    var phi_6179_: f32;
    var phi_6184_: f32;
    var phi_6189_: f32;
    var phi_6194_: f32;
    var phi_6199_: f32;
    var phi_6204_: f32;
    var phi_6209_: f32;
    var phi_6214_: f32;
    var phi_6219_: f32;
    var phi_6224_: f32;
    var phi_6230_: f32;
    var phi_6236_: f32;
    var phi_6243_: f32;
    var phi_6253_: f32;
    var phi_6263_: f32;
    var phi_6266_: bool;
    var phi_6511_: f32;
    var phi_6518_: f32;
    var phi_6523_: f32;
    var phi_6530_: f32;
    var phi_6535_: f32;
    var phi_6548_: f32;
    var phi_6555_: f32;
    var phi_6560_: f32;
    var phi_6567_: f32;
    var phi_6572_: f32;
    var phi_6577_: f32;
    var phi_6594_: f32;
    var phi_6601_: f32;
    var phi_6606_: f32;
    var phi_6613_: f32;
    var phi_6618_: f32;
    var phi_6632_: f32;
    var phi_6639_: f32;
    var phi_6644_: f32;
    var phi_6651_: f32;
    var phi_6656_: f32;
    var phi_6661_: f32;
    var phi_6678_: f32;
    var phi_6685_: f32;
    var phi_6690_: f32;
    var phi_6697_: f32;
    var phi_6702_: f32;
    var phi_6716_: f32;
    var phi_6723_: f32;
    var phi_6728_: f32;
    var phi_6735_: f32;
    var phi_6740_: f32;
    var phi_6745_: f32;
    var phi_6776_: f32;
    var phi_6782_: f32;
    var phi_6789_: f32;
    var phi_6796_: f32;
    var phi_6802_: f32;
    var phi_6809_: f32;
    var phi_6815_: f32;
    var phi_6821_: f32;
    var phi_6827_: f32;
    var phi_6834_: f32;
    var phi_6841_: f32;
    var phi_6865_: f32;
    var phi_6870_: f32;
    var phi_6875_: f32;
    var phi_6880_: f32;
    var phi_6885_: f32;
    var phi_6890_: f32;
    var phi_6900_: f32;
    var phi_7103_: f32;
    var phi_7110_: f32;
    var phi_7115_: f32;
    var phi_7122_: f32;
    var phi_7127_: f32;
    var phi_7140_: f32;
    var phi_7147_: f32;
    var phi_7152_: f32;
    var phi_7159_: f32;
    var phi_7164_: f32;
    var phi_7169_: f32;
    var phi_7186_: f32;
    var phi_7193_: f32;
    var phi_7198_: f32;
    var phi_7205_: f32;
    var phi_7210_: f32;
    var phi_7224_: f32;
    var phi_7231_: f32;
    var phi_7236_: f32;
    var phi_7243_: f32;
    var phi_7248_: f32;
    var phi_7253_: f32;
    var phi_7270_: f32;
    var phi_7277_: f32;
    var phi_7282_: f32;
    var phi_7289_: f32;
    var phi_7294_: f32;
    var phi_7308_: f32;
    var phi_7315_: f32;
    var phi_7320_: f32;
    var phi_7327_: f32;
    var phi_7332_: f32;
    var phi_7337_: f32;
    var phi_7415_: f32;
    var phi_7420_: f32;
    var phi_7425_: f32;
    var phi_7430_: f32;
    var phi_7435_: f32;
    var phi_7440_: f32;
    var phi_7445_: f32;
    var phi_7450_: f32;
    var phi_7455_: f32;
    var phi_7460_: f32;
    var phi_7465_: f32;
    var phi_7470_: f32;
    var phi_7475_: f32;
    var phi_7480_: f32;
    var phi_7486_: f32;
    var phi_7492_: f32;
    var phi_7499_: f32;
    var phi_7509_: f32;
    var phi_7580_: f32;
    var phi_7585_: f32;
    var phi_7590_: f32;
    var phi_7595_: f32;
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
    var phi_7651_: f32;
    var phi_7657_: f32;
    var phi_7664_: f32;
    var phi_7674_: f32;
    var phi_7684_: f32;
    var phi_7757_: f32;
    var phi_7762_: f32;
    var phi_7767_: f32;
    var phi_7772_: f32;
    var phi_7777_: f32;
    var phi_7782_: f32;
    var phi_7787_: f32;
    var phi_7792_: f32;
    var phi_7797_: f32;
    var phi_7802_: f32;
    var phi_7807_: f32;
    var phi_7812_: f32;
    var phi_7817_: f32;
    var phi_7822_: f32;
    var phi_7828_: f32;
    var phi_7834_: f32;
    var phi_7841_: f32;
    var phi_7851_: f32;
    var phi_7861_: f32;
    var phi_7864_: bool;
    var phi_7865_: bool;
    var phi_7867_: bool;
    var phi_7877_: bool;
    var phi_7878_: bool;
    var phi_7928_: type_9;
    var phi_7929_: type_9;
    var phi_7952_: type_9;
    var phi_7975_: u32;
    var phi_8049_: bool;
    var phi_8050_: bool;
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
            let _e216 = params.member.member_2.member[0u][0u];
            let _e217 = (_e216 + (_e205 * 32u));
            let _e223 = params.member.member_2.member[0u][2u];
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
            let _e384 = (_e67 / 32u);
            let _e387 = atomicLoad((&counters[_e384]));
            phi_822_ = type_9(0u, _e387);
            phi_825_ = 0u;
            loop {
                let _e390 = phi_822_;
                let _e392 = phi_825_;
                local_3 = _e392;
                if (_e390.member < _e390.member_1) {
                    phi_823_ = type_9((_e390.member + 1u), _e390.member_1);
                    phi_848_ = type_9(1u, _e390.member);
                } else {
                    phi_823_ = _e390;
                    phi_848_ = type_9(0u, type_9().member_1);
                }
                let _e404 = phi_823_;
                let _e406 = phi_848_;
                let _e410 = (bitcast<i32>(_e406.member) != 0i);
                if _e410 {
                    let _e414 = names[((_e384 * 32u) + _e406.member_1)];
                    let _e418 = columns[((_e384 * 32u) + _e406.member_1)];
                    if ((((((_e383.member[0] <= _e418.member_1[0]) && (_e418.member[0] <= _e383.member_1[0])) && (_e383.member[1] <= _e418.member_1[1])) && (_e418.member[1] <= _e383.member_1[1])) && (_e383.member[2] <= _e418.member_1[2])) && (_e418.member[2] <= _e383.member_1[2])) {
                        let _e451 = atomicAdd((&counters[4u]), 1u);
                        if (_e451 < 2048u) {
                            hits[_e451] = (((_e384 << bitcast<u32>(10i)) | ((_e67 % 32u) << bitcast<u32>(5i))) | _e414);
                            phi_938_ = _e392;
                        } else {
                            phi_938_ = (_e392 | (1u << bitcast<u32>((_e406.member_1 & 31u))));
                        }
                        let _e465 = phi_938_;
                        phi_940_ = _e465;
                    } else {
                        phi_940_ = _e392;
                    }
                    let _e467 = phi_940_;
                    phi_826_ = _e467;
                } else {
                    phi_826_ = u32();
                }
                let _e469 = phi_826_;
                continue;
                continuing {
                    phi_822_ = _e404;
                    phi_825_ = _e469;
                    break if !(_e410);
                }
            }
            phi_943_ = type_9(0u, 32u);
            let _e4925 = local_3;
            phi_946_ = _e4925;
            loop {
                let _e472 = phi_943_;
                let _e474 = phi_946_;
                if (_e472.member < _e472.member_1) {
                    phi_944_ = type_9((_e472.member + 1u), _e472.member_1);
                    phi_969_ = type_9(1u, _e472.member);
                } else {
                    phi_944_ = _e472;
                    phi_969_ = type_9(0u, type_9().member_1);
                }
                let _e486 = phi_944_;
                let _e488 = phi_969_;
                if (bitcast<i32>(_e488.member) != 0i) {
                    if (_e474 == 0u) {
                        phi_1850_ = u32();
                        phi_1851_ = false;
                    } else {
                        let _e499 = names[((_e92 * 32u) + select(firstTrailingBit(_e474), 32u, (_e474 == 0u)))];
                        let _e502 = (_e217 + _e93);
                        let _e503 = (_e224 + _e499);
                        let _e505 = leaves.member[_e502];
                        let _e507 = leaves.member[_e503];
                        let _e509 = nodes.member[_e502];
                        let _e511 = nodes.member[_e503];
                        let _e514 = params.member.member.member_1;
                        if ((_e514 & 1u) != 0u) {
                            if (_e505.member[0] == _e507.member[0]) {
                                phi_1059_ = bool();
                                phi_1060_ = true;
                            } else {
                                let _e526 = (_e505.member[0] == _e507.member[1]);
                                if _e526 {
                                    phi_1058_ = bool();
                                } else {
                                    phi_1058_ = (_e505.member[0] == _e507.member[2]);
                                }
                                let _e533 = phi_1058_;
                                phi_1059_ = _e533;
                                phi_1060_ = _e526;
                            }
                            let _e535 = phi_1059_;
                            let _e537 = phi_1060_;
                            if _e537 {
                                phi_1064_ = true;
                            } else {
                                phi_1064_ = _e535;
                            }
                            let _e539 = phi_1064_;
                            if _e539 {
                                phi_1099_ = false;
                            } else {
                                phi_1099_ = true;
                            }
                            let _e541 = phi_1099_;
                            phi_1100_ = _e541;
                        } else {
                            phi_1100_ = true;
                        }
                        let _e543 = phi_1100_;
                        if _e543 {
                            let _e545 = params.member.member.member_1;
                            if ((_e545 & 2u) != 0u) {
                                let _e551 = bodies.member[_e505.member[0]];
                                let _e555 = bodies.member[_e507.member[0]];
                                if ((_e551 / 2u) == (_e555 / 2u)) {
                                    let _e560 = params.member.member.member_1;
                                    phi_1144_ = !(((_e560 & 4u) != 0u));
                                } else {
                                    phi_1144_ = false;
                                }
                                let _e565 = phi_1144_;
                                if _e565 {
                                    phi_1155_ = true;
                                } else {
                                    if (((_e551 & _e555) & 1u) == 0u) {
                                        phi_1154_ = false;
                                    } else {
                                        phi_1154_ = true;
                                    }
                                    let _e570 = phi_1154_;
                                    phi_1155_ = _e570;
                                }
                                let _e572 = phi_1155_;
                                if _e572 {
                                    phi_1159_ = false;
                                } else {
                                    phi_1159_ = true;
                                }
                                let _e574 = phi_1159_;
                                phi_1160_ = _e574;
                            } else {
                                phi_1160_ = true;
                            }
                            let _e576 = phi_1160_;
                            if _e576 {
                                let _e578 = params.member.member.member_1;
                                if ((_e578 & 32u) != 0u) {
                                    let _e582 = params.member.member.member_6;
                                    let _e623 = (((((((_e509.member_1[0] - _e511.member[0]) > _e582) && ((_e511.member_1[0] - _e509.member[0]) > _e582)) && ((_e509.member_1[1] - _e511.member[1]) > _e582)) && ((_e511.member_1[1] - _e509.member[1]) > _e582)) && ((_e509.member_1[2] - _e511.member[2]) > _e582)) && ((_e511.member_1[2] - _e509.member[2]) > _e582));
                                    if _e623 {
                                        phi_1774_ = bool();
                                    } else {
                                        let _e627 = keys.member[_e505.member[0]];
                                        let _e632 = keys.member[_e505.member[1]];
                                        let _e634 = function_(_e627[0], _e632[0]);
                                        let _e638 = keys.member[_e505.member[2]];
                                        let _e640 = function_(_e634, _e638[0]);
                                        let _e644 = keys.member[_e507.member[0]];
                                        let _e649 = keys.member[_e507.member[1]];
                                        let _e651 = function_1(_e644[3], _e649[3]);
                                        let _e655 = keys.member[_e507.member[2]];
                                        let _e657 = function_1(_e651, _e655[3]);
                                        if (_e640[1] > _e657[1]) {
                                            phi_1297_ = true;
                                        } else {
                                            if (_e640[1] == _e657[1]) {
                                                phi_1296_ = (_e640[0] > _e657[0]);
                                            } else {
                                                phi_1296_ = false;
                                            }
                                            let _e668 = phi_1296_;
                                            phi_1297_ = _e668;
                                        }
                                        let _e670 = phi_1297_;
                                        let _e675 = keys.member[_e507.member[0]];
                                        let _e680 = keys.member[_e507.member[1]];
                                        let _e682 = function_(_e675[0], _e680[0]);
                                        let _e686 = keys.member[_e507.member[2]];
                                        let _e688 = function_(_e682, _e686[0]);
                                        let _e692 = keys.member[_e505.member[0]];
                                        let _e697 = keys.member[_e505.member[1]];
                                        let _e699 = function_1(_e692[3], _e697[3]);
                                        let _e703 = keys.member[_e505.member[2]];
                                        let _e705 = function_1(_e699, _e703[3]);
                                        if (_e688[1] > _e705[1]) {
                                            phi_1391_ = true;
                                        } else {
                                            if (_e688[1] == _e705[1]) {
                                                phi_1390_ = (_e688[0] > _e705[0]);
                                            } else {
                                                phi_1390_ = false;
                                            }
                                            let _e716 = phi_1390_;
                                            phi_1391_ = _e716;
                                        }
                                        let _e718 = phi_1391_;
                                        let _e724 = keys.member[_e505.member[0]];
                                        let _e729 = keys.member[_e505.member[1]];
                                        let _e731 = function_2(_e724[1], _e729[1]);
                                        let _e735 = keys.member[_e505.member[2]];
                                        let _e737 = function_2(_e731, _e735[1]);
                                        let _e741 = keys.member[_e507.member[0]];
                                        let _e746 = keys.member[_e507.member[1]];
                                        let _e748 = function_3(_e741[4], _e746[4]);
                                        let _e752 = keys.member[_e507.member[2]];
                                        let _e754 = function_3(_e748, _e752[4]);
                                        if (_e737[1] > _e754[1]) {
                                            phi_1486_ = true;
                                        } else {
                                            if (_e737[1] == _e754[1]) {
                                                phi_1485_ = (_e737[0] > _e754[0]);
                                            } else {
                                                phi_1485_ = false;
                                            }
                                            let _e765 = phi_1485_;
                                            phi_1486_ = _e765;
                                        }
                                        let _e767 = phi_1486_;
                                        let _e772 = keys.member[_e507.member[0]];
                                        let _e777 = keys.member[_e507.member[1]];
                                        let _e779 = function_2(_e772[1], _e777[1]);
                                        let _e783 = keys.member[_e507.member[2]];
                                        let _e785 = function_2(_e779, _e783[1]);
                                        let _e789 = keys.member[_e505.member[0]];
                                        let _e794 = keys.member[_e505.member[1]];
                                        let _e796 = function_3(_e789[4], _e794[4]);
                                        let _e800 = keys.member[_e505.member[2]];
                                        let _e802 = function_3(_e796, _e800[4]);
                                        if (_e785[1] > _e802[1]) {
                                            phi_1580_ = true;
                                        } else {
                                            if (_e785[1] == _e802[1]) {
                                                phi_1579_ = (_e785[0] > _e802[0]);
                                            } else {
                                                phi_1579_ = false;
                                            }
                                            let _e813 = phi_1579_;
                                            phi_1580_ = _e813;
                                        }
                                        let _e815 = phi_1580_;
                                        let _e822 = keys.member[_e505.member[0]];
                                        let _e827 = keys.member[_e505.member[1]];
                                        let _e829 = function_4(_e822[2], _e827[2]);
                                        let _e833 = keys.member[_e505.member[2]];
                                        let _e835 = function_4(_e829, _e833[2]);
                                        let _e839 = keys.member[_e507.member[0]];
                                        let _e844 = keys.member[_e507.member[1]];
                                        let _e846 = function_5(_e839[5], _e844[5]);
                                        let _e850 = keys.member[_e507.member[2]];
                                        let _e852 = function_5(_e846, _e850[5]);
                                        if (_e835[1] > _e852[1]) {
                                            phi_1676_ = true;
                                        } else {
                                            if (_e835[1] == _e852[1]) {
                                                phi_1675_ = (_e835[0] > _e852[0]);
                                            } else {
                                                phi_1675_ = false;
                                            }
                                            let _e863 = phi_1675_;
                                            phi_1676_ = _e863;
                                        }
                                        let _e865 = phi_1676_;
                                        let _e870 = keys.member[_e507.member[0]];
                                        let _e875 = keys.member[_e507.member[1]];
                                        let _e877 = function_4(_e870[2], _e875[2]);
                                        let _e881 = keys.member[_e507.member[2]];
                                        let _e883 = function_4(_e877, _e881[2]);
                                        let _e887 = keys.member[_e505.member[0]];
                                        let _e892 = keys.member[_e505.member[1]];
                                        let _e894 = function_5(_e887[5], _e892[5]);
                                        let _e898 = keys.member[_e505.member[2]];
                                        let _e900 = function_5(_e894, _e898[5]);
                                        if (_e883[1] > _e900[1]) {
                                            phi_1770_ = true;
                                        } else {
                                            if (_e883[1] == _e900[1]) {
                                                phi_1769_ = (_e883[0] > _e900[0]);
                                            } else {
                                                phi_1769_ = false;
                                            }
                                            let _e911 = phi_1769_;
                                            phi_1770_ = _e911;
                                        }
                                        let _e913 = phi_1770_;
                                        phi_1774_ = (((!(_e670) && !(_e718)) && (!(_e767) && !(_e815))) && (!(_e865) && !(_e913)));
                                    }
                                    let _e918 = phi_1774_;
                                    phi_1775_ = _e918;
                                    phi_1776_ = _e623;
                                } else {
                                    phi_1775_ = bool();
                                    phi_1776_ = true;
                                }
                                let _e920 = phi_1775_;
                                let _e922 = phi_1776_;
                                if _e922 {
                                    phi_1780_ = false;
                                } else {
                                    phi_1780_ = true;
                                }
                                let _e924 = phi_1780_;
                                phi_1781_ = _e920;
                                phi_1782_ = _e924;
                            } else {
                                phi_1781_ = false;
                                phi_1782_ = true;
                            }
                            let _e926 = phi_1781_;
                            let _e928 = phi_1782_;
                            phi_1783_ = _e926;
                            phi_1784_ = _e928;
                        } else {
                            phi_1783_ = false;
                            phi_1784_ = true;
                        }
                        let _e930 = phi_1783_;
                        let _e932 = phi_1784_;
                        if _e932 {
                            phi_1788_ = _e930;
                        } else {
                            phi_1788_ = true;
                        }
                        let _e934 = phi_1788_;
                        if _e934 {
                            let _e937 = params.member.member_1.member_3;
                            let _e941 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e941 + 1u) < _e941) {
                                let _e945 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e941 < _e937) {
                                let _e947 = (2u * _e941);
                                atomicStore((&output.member[(4u + _e947)]), _e505.member_1);
                                atomicStore((&output.member[(_e947 + 5u)]), _e507.member_1);
                            }
                            let _e953 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e953 + 1u) < _e953) {
                                let _e957 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1850_ = (_e474 & (_e474 - 1u));
                        phi_1851_ = true;
                    }
                    let _e959 = phi_1850_;
                    let _e961 = phi_1851_;
                    phi_947_ = _e959;
                    phi_1852_ = _e961;
                } else {
                    phi_947_ = u32();
                    phi_1852_ = false;
                }
                let _e963 = phi_947_;
                let _e965 = phi_1852_;
                continue;
                continuing {
                    phi_943_ = _e486;
                    phi_946_ = _e963;
                    break if !(_e965);
                }
            }
            workgroupBarrier();
            let _e968 = atomicLoad((&counters[4u]));
            if (2048u < _e968) {
                phi_1859_ = 2048u;
            } else {
                phi_1859_ = _e968;
            }
            let _e971 = phi_1859_;
            phi_1862_ = type_9(0u, 16u);
            loop {
                let _e973 = phi_1862_;
                if (_e973.member < _e973.member_1) {
                    phi_1863_ = type_9((_e973.member + 1u), _e973.member_1);
                    phi_1886_ = type_9(1u, _e973.member);
                } else {
                    phi_1863_ = _e973;
                    phi_1886_ = type_9(0u, type_9().member_1);
                }
                let _e985 = phi_1863_;
                let _e987 = phi_1886_;
                if (bitcast<i32>(_e987.member) != 0i) {
                    let _e993 = (_e67 + (_e987.member_1 * 128u));
                    if (_e993 >= _e971) {
                        phi_7877_ = false;
                    } else {
                        let _e996 = hits[_e993];
                        let _e999 = ((_e996 >> bitcast<u32>(10i)) & 3u);
                        let _e1006 = firsts[(2u * _e999)];
                        let _e1007 = (_e1006 + ((_e996 >> bitcast<u32>(5i)) & 31u));
                        let _e1011 = firsts[((2u * _e999) + 1u)];
                        let _e1012 = (_e1011 + (_e996 & 31u));
                        let _e1014 = leaves.member[_e1007];
                        let _e1016 = leaves.member[_e1012];
                        let _e1018 = nodes.member[_e1007];
                        let _e1020 = nodes.member[_e1012];
                        let _e1023 = params.member.member.member_1;
                        if ((_e1023 & 1u) != 0u) {
                            if (_e1014.member[0] == _e1016.member[0]) {
                                phi_1984_ = bool();
                                phi_1985_ = true;
                            } else {
                                let _e1035 = (_e1014.member[0] == _e1016.member[1]);
                                if _e1035 {
                                    phi_1983_ = bool();
                                } else {
                                    phi_1983_ = (_e1014.member[0] == _e1016.member[2]);
                                }
                                let _e1042 = phi_1983_;
                                phi_1984_ = _e1042;
                                phi_1985_ = _e1035;
                            }
                            let _e1044 = phi_1984_;
                            let _e1046 = phi_1985_;
                            if _e1046 {
                                phi_1989_ = true;
                            } else {
                                phi_1989_ = _e1044;
                            }
                            let _e1048 = phi_1989_;
                            if _e1048 {
                                phi_2024_ = false;
                            } else {
                                phi_2024_ = true;
                            }
                            let _e1050 = phi_2024_;
                            phi_2025_ = _e1050;
                        } else {
                            phi_2025_ = true;
                        }
                        let _e1052 = phi_2025_;
                        if _e1052 {
                            let _e1054 = params.member.member.member_1;
                            if ((_e1054 & 2u) != 0u) {
                                let _e1060 = bodies.member[_e1014.member[0]];
                                let _e1064 = bodies.member[_e1016.member[0]];
                                if ((_e1060 / 2u) == (_e1064 / 2u)) {
                                    let _e1069 = params.member.member.member_1;
                                    phi_2069_ = !(((_e1069 & 4u) != 0u));
                                } else {
                                    phi_2069_ = false;
                                }
                                let _e1074 = phi_2069_;
                                if _e1074 {
                                    phi_2080_ = true;
                                } else {
                                    if (((_e1060 & _e1064) & 1u) == 0u) {
                                        phi_2079_ = false;
                                    } else {
                                        phi_2079_ = true;
                                    }
                                    let _e1079 = phi_2079_;
                                    phi_2080_ = _e1079;
                                }
                                let _e1081 = phi_2080_;
                                if _e1081 {
                                    phi_2084_ = false;
                                } else {
                                    phi_2084_ = true;
                                }
                                let _e1083 = phi_2084_;
                                phi_2085_ = _e1083;
                            } else {
                                phi_2085_ = true;
                            }
                            let _e1085 = phi_2085_;
                            if _e1085 {
                                let _e1087 = params.member.member.member_1;
                                if ((_e1087 & 32u) != 0u) {
                                    let _e1091 = params.member.member.member_6;
                                    let _e1132 = (((((((_e1018.member_1[0] - _e1020.member[0]) > _e1091) && ((_e1020.member_1[0] - _e1018.member[0]) > _e1091)) && ((_e1018.member_1[1] - _e1020.member[1]) > _e1091)) && ((_e1020.member_1[1] - _e1018.member[1]) > _e1091)) && ((_e1018.member_1[2] - _e1020.member[2]) > _e1091)) && ((_e1020.member_1[2] - _e1018.member[2]) > _e1091));
                                    if _e1132 {
                                        phi_2699_ = bool();
                                    } else {
                                        let _e1136 = keys.member[_e1014.member[0]];
                                        let _e1141 = keys.member[_e1014.member[1]];
                                        let _e1143 = function_(_e1136[0], _e1141[0]);
                                        let _e1147 = keys.member[_e1014.member[2]];
                                        let _e1149 = function_(_e1143, _e1147[0]);
                                        let _e1153 = keys.member[_e1016.member[0]];
                                        let _e1158 = keys.member[_e1016.member[1]];
                                        let _e1160 = function_1(_e1153[3], _e1158[3]);
                                        let _e1164 = keys.member[_e1016.member[2]];
                                        let _e1166 = function_1(_e1160, _e1164[3]);
                                        if (_e1149[1] > _e1166[1]) {
                                            phi_2222_ = true;
                                        } else {
                                            if (_e1149[1] == _e1166[1]) {
                                                phi_2221_ = (_e1149[0] > _e1166[0]);
                                            } else {
                                                phi_2221_ = false;
                                            }
                                            let _e1177 = phi_2221_;
                                            phi_2222_ = _e1177;
                                        }
                                        let _e1179 = phi_2222_;
                                        let _e1184 = keys.member[_e1016.member[0]];
                                        let _e1189 = keys.member[_e1016.member[1]];
                                        let _e1191 = function_(_e1184[0], _e1189[0]);
                                        let _e1195 = keys.member[_e1016.member[2]];
                                        let _e1197 = function_(_e1191, _e1195[0]);
                                        let _e1201 = keys.member[_e1014.member[0]];
                                        let _e1206 = keys.member[_e1014.member[1]];
                                        let _e1208 = function_1(_e1201[3], _e1206[3]);
                                        let _e1212 = keys.member[_e1014.member[2]];
                                        let _e1214 = function_1(_e1208, _e1212[3]);
                                        if (_e1197[1] > _e1214[1]) {
                                            phi_2316_ = true;
                                        } else {
                                            if (_e1197[1] == _e1214[1]) {
                                                phi_2315_ = (_e1197[0] > _e1214[0]);
                                            } else {
                                                phi_2315_ = false;
                                            }
                                            let _e1225 = phi_2315_;
                                            phi_2316_ = _e1225;
                                        }
                                        let _e1227 = phi_2316_;
                                        let _e1233 = keys.member[_e1014.member[0]];
                                        let _e1238 = keys.member[_e1014.member[1]];
                                        let _e1240 = function_2(_e1233[1], _e1238[1]);
                                        let _e1244 = keys.member[_e1014.member[2]];
                                        let _e1246 = function_2(_e1240, _e1244[1]);
                                        let _e1250 = keys.member[_e1016.member[0]];
                                        let _e1255 = keys.member[_e1016.member[1]];
                                        let _e1257 = function_3(_e1250[4], _e1255[4]);
                                        let _e1261 = keys.member[_e1016.member[2]];
                                        let _e1263 = function_3(_e1257, _e1261[4]);
                                        if (_e1246[1] > _e1263[1]) {
                                            phi_2411_ = true;
                                        } else {
                                            if (_e1246[1] == _e1263[1]) {
                                                phi_2410_ = (_e1246[0] > _e1263[0]);
                                            } else {
                                                phi_2410_ = false;
                                            }
                                            let _e1274 = phi_2410_;
                                            phi_2411_ = _e1274;
                                        }
                                        let _e1276 = phi_2411_;
                                        let _e1281 = keys.member[_e1016.member[0]];
                                        let _e1286 = keys.member[_e1016.member[1]];
                                        let _e1288 = function_2(_e1281[1], _e1286[1]);
                                        let _e1292 = keys.member[_e1016.member[2]];
                                        let _e1294 = function_2(_e1288, _e1292[1]);
                                        let _e1298 = keys.member[_e1014.member[0]];
                                        let _e1303 = keys.member[_e1014.member[1]];
                                        let _e1305 = function_3(_e1298[4], _e1303[4]);
                                        let _e1309 = keys.member[_e1014.member[2]];
                                        let _e1311 = function_3(_e1305, _e1309[4]);
                                        if (_e1294[1] > _e1311[1]) {
                                            phi_2505_ = true;
                                        } else {
                                            if (_e1294[1] == _e1311[1]) {
                                                phi_2504_ = (_e1294[0] > _e1311[0]);
                                            } else {
                                                phi_2504_ = false;
                                            }
                                            let _e1322 = phi_2504_;
                                            phi_2505_ = _e1322;
                                        }
                                        let _e1324 = phi_2505_;
                                        let _e1331 = keys.member[_e1014.member[0]];
                                        let _e1336 = keys.member[_e1014.member[1]];
                                        let _e1338 = function_4(_e1331[2], _e1336[2]);
                                        let _e1342 = keys.member[_e1014.member[2]];
                                        let _e1344 = function_4(_e1338, _e1342[2]);
                                        let _e1348 = keys.member[_e1016.member[0]];
                                        let _e1353 = keys.member[_e1016.member[1]];
                                        let _e1355 = function_5(_e1348[5], _e1353[5]);
                                        let _e1359 = keys.member[_e1016.member[2]];
                                        let _e1361 = function_5(_e1355, _e1359[5]);
                                        if (_e1344[1] > _e1361[1]) {
                                            phi_2601_ = true;
                                        } else {
                                            if (_e1344[1] == _e1361[1]) {
                                                phi_2600_ = (_e1344[0] > _e1361[0]);
                                            } else {
                                                phi_2600_ = false;
                                            }
                                            let _e1372 = phi_2600_;
                                            phi_2601_ = _e1372;
                                        }
                                        let _e1374 = phi_2601_;
                                        let _e1379 = keys.member[_e1016.member[0]];
                                        let _e1384 = keys.member[_e1016.member[1]];
                                        let _e1386 = function_4(_e1379[2], _e1384[2]);
                                        let _e1390 = keys.member[_e1016.member[2]];
                                        let _e1392 = function_4(_e1386, _e1390[2]);
                                        let _e1396 = keys.member[_e1014.member[0]];
                                        let _e1401 = keys.member[_e1014.member[1]];
                                        let _e1403 = function_5(_e1396[5], _e1401[5]);
                                        let _e1407 = keys.member[_e1014.member[2]];
                                        let _e1409 = function_5(_e1403, _e1407[5]);
                                        if (_e1392[1] > _e1409[1]) {
                                            phi_2695_ = true;
                                        } else {
                                            if (_e1392[1] == _e1409[1]) {
                                                phi_2694_ = (_e1392[0] > _e1409[0]);
                                            } else {
                                                phi_2694_ = false;
                                            }
                                            let _e1420 = phi_2694_;
                                            phi_2695_ = _e1420;
                                        }
                                        let _e1422 = phi_2695_;
                                        phi_2699_ = (((!(_e1179) && !(_e1227)) && (!(_e1276) && !(_e1324))) && (!(_e1374) && !(_e1422)));
                                    }
                                    let _e1427 = phi_2699_;
                                    phi_2700_ = _e1427;
                                    phi_2701_ = _e1132;
                                } else {
                                    phi_2700_ = bool();
                                    phi_2701_ = true;
                                }
                                let _e1429 = phi_2700_;
                                let _e1431 = phi_2701_;
                                if _e1431 {
                                    phi_2705_ = false;
                                } else {
                                    phi_2705_ = true;
                                }
                                let _e1433 = phi_2705_;
                                phi_2706_ = _e1429;
                                phi_2707_ = _e1433;
                            } else {
                                phi_2706_ = false;
                                phi_2707_ = true;
                            }
                            let _e1435 = phi_2706_;
                            let _e1437 = phi_2707_;
                            phi_2708_ = _e1435;
                            phi_2709_ = _e1437;
                        } else {
                            phi_2708_ = false;
                            phi_2709_ = true;
                        }
                        let _e1439 = phi_2708_;
                        let _e1441 = phi_2709_;
                        if _e1441 {
                            phi_2713_ = _e1439;
                        } else {
                            phi_2713_ = true;
                        }
                        let _e1443 = phi_2713_;
                        if _e1443 {
                            let _e1445 = atomicAdd((&counters[7u]), 1u);
                            let _e1448 = params.member.member.member_4;
                            let _e1450 = params.member.member.member_5;
                            let _e1460 = paths.member[_e1014.member[0]];
                            let _e1462 = paths.member[_e1016.member[0]];
                            let _e1468 = paths.member[_e1016.member[1]];
                            let _e1470 = paths.member[_e1016.member[2]];
                            local_2 = type_37(array<array<f32, 3>, 2>(array<f32, 3>((_e1460.member[0] - _e1462.member[0]), (_e1460.member[1] - _e1462.member[1]), (_e1460.member[2] - _e1462.member[2])), array<f32, 3>((_e1460.member_1[0] - _e1462.member_1[0]), (_e1460.member_1[1] - _e1462.member_1[1]), (_e1460.member_1[2] - _e1462.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1468.member[0] - _e1462.member[0]), (_e1468.member[1] - _e1462.member[1]), (_e1468.member[2] - _e1462.member[2])), array<f32, 3>((_e1468.member_1[0] - _e1462.member_1[0]), (_e1468.member_1[1] - _e1462.member_1[1]), (_e1468.member_1[2] - _e1462.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1470.member[0] - _e1462.member[0]), (_e1470.member[1] - _e1462.member[1]), (_e1470.member[2] - _e1462.member[2])), array<f32, 3>((_e1470.member_1[0] - _e1462.member_1[0]), (_e1470.member_1[1] - _e1462.member_1[1]), (_e1470.member_1[2] - _e1462.member_1[2]))), (_e1448 + _e1448));
                            let _e1530 = local_2.member_1[0u];
                            let _e1536 = local_2.member_2[0u];
                            let _e1542 = ((_e1530[1] * _e1536[2]) - (_e1530[2] * _e1536[1]));
                            let _e1545 = ((_e1530[2] * _e1536[0]) - (_e1530[0] * _e1536[2]));
                            let _e1548 = ((_e1530[0] * _e1536[1]) - (_e1530[1] * _e1536[0]));
                            let _e1551 = local_2.member_1[1u];
                            let _e1557 = local_2.member_2[1u];
                            let _e1563 = ((_e1551[1] * _e1557[2]) - (_e1551[2] * _e1557[1]));
                            let _e1566 = ((_e1551[2] * _e1557[0]) - (_e1551[0] * _e1557[2]));
                            let _e1569 = ((_e1551[0] * _e1557[1]) - (_e1551[1] * _e1557[0]));
                            let _e1572 = local_2.member_1[0u];
                            let _e1578 = local_2.member_2[1u];
                            let _e1593 = local_2.member_1[1u];
                            let _e1599 = local_2.member_2[0u];
                            let _e1612 = (((_e1572[1] * _e1578[2]) - (_e1572[2] * _e1578[1])) + ((_e1593[1] * _e1599[2]) - (_e1593[2] * _e1599[1])));
                            let _e1613 = (((_e1572[2] * _e1578[0]) - (_e1572[0] * _e1578[2])) + ((_e1593[2] * _e1599[0]) - (_e1593[0] * _e1599[2])));
                            let _e1614 = (((_e1572[0] * _e1578[1]) - (_e1572[1] * _e1578[0])) + ((_e1593[0] * _e1599[1]) - (_e1593[1] * _e1599[0])));
                            let _e1617 = local_2.member[0u];
                            let _e1628 = local_2.member[1u];
                            let _e1639 = local_2.member[0u];
                            let _e1648 = ((((_e1628[0] * _e1542) + (_e1628[1] * _e1545)) + (_e1628[2] * _e1548)) + (((_e1639[0] * _e1612) + (_e1639[1] * _e1613)) + (_e1639[2] * _e1614)));
                            let _e1651 = local_2.member[0u];
                            let _e1662 = local_2.member[1u];
                            let _e1671 = ((((_e1651[0] * _e1563) + (_e1651[1] * _e1566)) + (_e1651[2] * _e1569)) + (((_e1662[0] * _e1612) + (_e1662[1] * _e1613)) + (_e1662[2] * _e1614)));
                            let _e1674 = local_2.member[1u];
                            let _e1685 = local_2.member[0u];
                            if (_e1685[0] < 0f) {
                                phi_3108_ = -(_e1685[0]);
                            } else {
                                phi_3108_ = _e1685[0];
                            }
                            let _e1692 = phi_3108_;
                            if (_e1685[1] < 0f) {
                                phi_3115_ = -(_e1685[1]);
                            } else {
                                phi_3115_ = _e1685[1];
                            }
                            let _e1696 = phi_3115_;
                            if (_e1692 > _e1696) {
                                phi_3120_ = _e1692;
                            } else {
                                phi_3120_ = _e1696;
                            }
                            let _e1699 = phi_3120_;
                            if (_e1685[2] < 0f) {
                                phi_3127_ = -(_e1685[2]);
                            } else {
                                phi_3127_ = _e1685[2];
                            }
                            let _e1703 = phi_3127_;
                            if (_e1699 > _e1703) {
                                phi_3132_ = _e1699;
                            } else {
                                phi_3132_ = _e1703;
                            }
                            let _e1706 = phi_3132_;
                            let _e1709 = local_2.member[1u];
                            if (_e1709[0] < 0f) {
                                phi_3145_ = -(_e1709[0]);
                            } else {
                                phi_3145_ = _e1709[0];
                            }
                            let _e1716 = phi_3145_;
                            if (_e1709[1] < 0f) {
                                phi_3152_ = -(_e1709[1]);
                            } else {
                                phi_3152_ = _e1709[1];
                            }
                            let _e1720 = phi_3152_;
                            if (_e1716 > _e1720) {
                                phi_3157_ = _e1716;
                            } else {
                                phi_3157_ = _e1720;
                            }
                            let _e1723 = phi_3157_;
                            if (_e1709[2] < 0f) {
                                phi_3164_ = -(_e1709[2]);
                            } else {
                                phi_3164_ = _e1709[2];
                            }
                            let _e1727 = phi_3164_;
                            if (_e1723 > _e1727) {
                                phi_3169_ = _e1723;
                            } else {
                                phi_3169_ = _e1727;
                            }
                            let _e1730 = phi_3169_;
                            if (_e1706 > _e1730) {
                                phi_3174_ = _e1706;
                            } else {
                                phi_3174_ = _e1730;
                            }
                            let _e1733 = phi_3174_;
                            let _e1735 = local_2.member_3;
                            let _e1736 = (_e1733 + _e1735);
                            let _e1739 = local_2.member_1[0u];
                            if (_e1739[0] < 0f) {
                                phi_3191_ = -(_e1739[0]);
                            } else {
                                phi_3191_ = _e1739[0];
                            }
                            let _e1746 = phi_3191_;
                            if (_e1739[1] < 0f) {
                                phi_3198_ = -(_e1739[1]);
                            } else {
                                phi_3198_ = _e1739[1];
                            }
                            let _e1750 = phi_3198_;
                            if (_e1746 > _e1750) {
                                phi_3203_ = _e1746;
                            } else {
                                phi_3203_ = _e1750;
                            }
                            let _e1753 = phi_3203_;
                            if (_e1739[2] < 0f) {
                                phi_3210_ = -(_e1739[2]);
                            } else {
                                phi_3210_ = _e1739[2];
                            }
                            let _e1757 = phi_3210_;
                            if (_e1753 > _e1757) {
                                phi_3215_ = _e1753;
                            } else {
                                phi_3215_ = _e1757;
                            }
                            let _e1760 = phi_3215_;
                            let _e1763 = local_2.member_1[1u];
                            if (_e1763[0] < 0f) {
                                phi_3229_ = -(_e1763[0]);
                            } else {
                                phi_3229_ = _e1763[0];
                            }
                            let _e1770 = phi_3229_;
                            if (_e1763[1] < 0f) {
                                phi_3236_ = -(_e1763[1]);
                            } else {
                                phi_3236_ = _e1763[1];
                            }
                            let _e1774 = phi_3236_;
                            if (_e1770 > _e1774) {
                                phi_3241_ = _e1770;
                            } else {
                                phi_3241_ = _e1774;
                            }
                            let _e1777 = phi_3241_;
                            if (_e1763[2] < 0f) {
                                phi_3248_ = -(_e1763[2]);
                            } else {
                                phi_3248_ = _e1763[2];
                            }
                            let _e1781 = phi_3248_;
                            if (_e1777 > _e1781) {
                                phi_3253_ = _e1777;
                            } else {
                                phi_3253_ = _e1781;
                            }
                            let _e1784 = phi_3253_;
                            if (_e1760 > _e1784) {
                                phi_3258_ = _e1760;
                            } else {
                                phi_3258_ = _e1784;
                            }
                            let _e1787 = phi_3258_;
                            let _e1789 = local_2.member_3;
                            let _e1790 = (_e1787 + _e1789);
                            let _e1793 = local_2.member_2[0u];
                            if (_e1793[0] < 0f) {
                                phi_3275_ = -(_e1793[0]);
                            } else {
                                phi_3275_ = _e1793[0];
                            }
                            let _e1800 = phi_3275_;
                            if (_e1793[1] < 0f) {
                                phi_3282_ = -(_e1793[1]);
                            } else {
                                phi_3282_ = _e1793[1];
                            }
                            let _e1804 = phi_3282_;
                            if (_e1800 > _e1804) {
                                phi_3287_ = _e1800;
                            } else {
                                phi_3287_ = _e1804;
                            }
                            let _e1807 = phi_3287_;
                            if (_e1793[2] < 0f) {
                                phi_3294_ = -(_e1793[2]);
                            } else {
                                phi_3294_ = _e1793[2];
                            }
                            let _e1811 = phi_3294_;
                            if (_e1807 > _e1811) {
                                phi_3299_ = _e1807;
                            } else {
                                phi_3299_ = _e1811;
                            }
                            let _e1814 = phi_3299_;
                            let _e1817 = local_2.member_2[1u];
                            if (_e1817[0] < 0f) {
                                phi_3313_ = -(_e1817[0]);
                            } else {
                                phi_3313_ = _e1817[0];
                            }
                            let _e1824 = phi_3313_;
                            if (_e1817[1] < 0f) {
                                phi_3320_ = -(_e1817[1]);
                            } else {
                                phi_3320_ = _e1817[1];
                            }
                            let _e1828 = phi_3320_;
                            if (_e1824 > _e1828) {
                                phi_3325_ = _e1824;
                            } else {
                                phi_3325_ = _e1828;
                            }
                            let _e1831 = phi_3325_;
                            if (_e1817[2] < 0f) {
                                phi_3332_ = -(_e1817[2]);
                            } else {
                                phi_3332_ = _e1817[2];
                            }
                            let _e1835 = phi_3332_;
                            if (_e1831 > _e1835) {
                                phi_3337_ = _e1831;
                            } else {
                                phi_3337_ = _e1835;
                            }
                            let _e1838 = phi_3337_;
                            if (_e1814 > _e1838) {
                                phi_3342_ = _e1814;
                            } else {
                                phi_3342_ = _e1838;
                            }
                            let _e1841 = phi_3342_;
                            let _e1843 = local_2.member_3;
                            let _e1844 = (_e1841 + _e1843);
                            let _e1846 = ((_e1790 * 8f) * _e1844);
                            let _e1853 = local_2.member_3;
                            if (_e1542 < 0f) {
                                phi_3373_ = -(_e1542);
                            } else {
                                phi_3373_ = _e1542;
                            }
                            let _e1870 = phi_3373_;
                            if (_e1545 < 0f) {
                                phi_3379_ = -(_e1545);
                            } else {
                                phi_3379_ = _e1545;
                            }
                            let _e1874 = phi_3379_;
                            if (_e1548 < 0f) {
                                phi_3386_ = -(_e1548);
                            } else {
                                phi_3386_ = _e1548;
                            }
                            let _e1879 = phi_3386_;
                            let _e1880 = ((_e1870 + _e1874) + _e1879);
                            if (_e1563 < 0f) {
                                phi_3393_ = -(_e1563);
                            } else {
                                phi_3393_ = _e1563;
                            }
                            let _e1884 = phi_3393_;
                            if (_e1566 < 0f) {
                                phi_3399_ = -(_e1566);
                            } else {
                                phi_3399_ = _e1566;
                            }
                            let _e1888 = phi_3399_;
                            if (_e1569 < 0f) {
                                phi_3406_ = -(_e1569);
                            } else {
                                phi_3406_ = _e1569;
                            }
                            let _e1893 = phi_3406_;
                            let _e1894 = ((_e1884 + _e1888) + _e1893);
                            if (_e1880 > _e1894) {
                                phi_3412_ = _e1880;
                            } else {
                                phi_3412_ = _e1894;
                            }
                            let _e1897 = phi_3412_;
                            if (_e1612 < 0f) {
                                phi_3418_ = -(_e1612);
                            } else {
                                phi_3418_ = _e1612;
                            }
                            let _e1901 = phi_3418_;
                            if (_e1613 < 0f) {
                                phi_3424_ = -(_e1613);
                            } else {
                                phi_3424_ = _e1613;
                            }
                            let _e1905 = phi_3424_;
                            if (_e1614 < 0f) {
                                phi_3431_ = -(_e1614);
                            } else {
                                phi_3431_ = _e1614;
                            }
                            let _e1910 = phi_3431_;
                            let _e1912 = (((_e1901 + _e1905) + _e1910) * 0.5f);
                            if (_e1897 > _e1912) {
                                phi_3438_ = _e1897;
                            } else {
                                phi_3438_ = _e1912;
                            }
                            let _e1915 = phi_3438_;
                            let _e1920 = local_2.member_3;
                            let _e1933 = ((((_e1617[0] * _e1542) + (_e1617[1] * _e1545)) + (_e1617[2] * _e1548)) * 3f);
                            let _e1934 = ((((_e1674[0] * _e1563) + (_e1674[1] * _e1566)) + (_e1674[2] * _e1569)) * 3f);
                            if (_e1933 < _e1934) {
                                phi_3462_ = _e1933;
                            } else {
                                phi_3462_ = _e1934;
                            }
                            let _e1937 = phi_3462_;
                            if (_e1648 < _e1671) {
                                phi_3467_ = _e1648;
                            } else {
                                phi_3467_ = _e1671;
                            }
                            let _e1940 = phi_3467_;
                            if (_e1937 < _e1940) {
                                phi_3472_ = _e1937;
                            } else {
                                phi_3472_ = _e1940;
                            }
                            let _e1943 = phi_3472_;
                            if (_e1933 > _e1934) {
                                phi_3477_ = _e1933;
                            } else {
                                phi_3477_ = _e1934;
                            }
                            let _e1946 = phi_3477_;
                            if (_e1648 > _e1671) {
                                phi_3482_ = _e1648;
                            } else {
                                phi_3482_ = _e1671;
                            }
                            let _e1949 = phi_3482_;
                            if (_e1946 > _e1949) {
                                phi_3487_ = _e1946;
                            } else {
                                phi_3487_ = _e1949;
                            }
                            let _e1952 = phi_3487_;
                            let _e1957 = -(_e1952);
                            if (_e1943 > _e1957) {
                                phi_3497_ = _e1943;
                            } else {
                                phi_3497_ = _e1957;
                            }
                            let _e1960 = phi_3497_;
                            if ((_e1960 - ((((((_e1736 * 8f) * _e1846) * (0.000000059604645f * (490f / 64f))) + ((_e1853 * 19f) * ((_e1736 * (_e1790 + _e1844)) + (_e1790 * _e1844)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1736) * ((1f + _e1790) * (1f + _e1844))))) + ((_e1450 * (((_e1915 + (_e1846 * (0.000000059604645f * 4f))) + ((_e1920 * 6f) * (_e1790 + _e1844))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1790) * (1f + _e1844))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4461_ = true;
                            } else {
                                let _e1965 = local_2.member_1[0u];
                                let _e1971 = local_2.member_1[1u];
                                let _e1975 = (_e1965[0] + _e1971[0]);
                                let _e1976 = (_e1965[1] + _e1971[1]);
                                let _e1977 = (_e1965[2] + _e1971[2]);
                                let _e1980 = local_2.member_2[0u];
                                let _e1986 = local_2.member_2[1u];
                                let _e1990 = (_e1980[0] + _e1986[0]);
                                let _e1991 = (_e1980[1] + _e1986[1]);
                                let _e1992 = (_e1980[2] + _e1986[2]);
                                let _e1995 = ((_e1976 * _e1992) - (_e1977 * _e1991));
                                let _e1998 = ((_e1977 * _e1990) - (_e1975 * _e1992));
                                let _e2001 = ((_e1975 * _e1991) - (_e1976 * _e1990));
                                let _e2004 = local_2.member[0u];
                                let _e2010 = local_2.member_1[0u];
                                let _e2016 = local_2.member_2[0u];
                                let _e2020 = (_e2004[0] - _e2010[0]);
                                let _e2021 = (_e2004[1] - _e2010[1]);
                                let _e2022 = (_e2004[2] - _e2010[2]);
                                let _e2023 = (_e2004[0] - _e2016[0]);
                                let _e2024 = (_e2004[1] - _e2016[1]);
                                let _e2025 = (_e2004[2] - _e2016[2]);
                                let _e2028 = local_2.member[1u];
                                let _e2034 = local_2.member_1[1u];
                                let _e2040 = local_2.member_2[1u];
                                let _e2044 = (_e2028[0] - _e2034[0]);
                                let _e2045 = (_e2028[1] - _e2034[1]);
                                let _e2046 = (_e2028[2] - _e2034[2]);
                                let _e2047 = (_e2028[0] - _e2040[0]);
                                let _e2048 = (_e2028[1] - _e2040[1]);
                                let _e2049 = (_e2028[2] - _e2040[2]);
                                let _e2052 = local_2.member[0u];
                                if (_e2052[0] < 0f) {
                                    phi_3700_ = -(_e2052[0]);
                                } else {
                                    phi_3700_ = _e2052[0];
                                }
                                let _e2059 = phi_3700_;
                                if (_e2052[1] < 0f) {
                                    phi_3707_ = -(_e2052[1]);
                                } else {
                                    phi_3707_ = _e2052[1];
                                }
                                let _e2063 = phi_3707_;
                                if (_e2059 > _e2063) {
                                    phi_3712_ = _e2059;
                                } else {
                                    phi_3712_ = _e2063;
                                }
                                let _e2066 = phi_3712_;
                                if (_e2052[2] < 0f) {
                                    phi_3719_ = -(_e2052[2]);
                                } else {
                                    phi_3719_ = _e2052[2];
                                }
                                let _e2070 = phi_3719_;
                                if (_e2066 > _e2070) {
                                    phi_3724_ = _e2066;
                                } else {
                                    phi_3724_ = _e2070;
                                }
                                let _e2073 = phi_3724_;
                                let _e2076 = local_2.member[1u];
                                if (_e2076[0] < 0f) {
                                    phi_3737_ = -(_e2076[0]);
                                } else {
                                    phi_3737_ = _e2076[0];
                                }
                                let _e2083 = phi_3737_;
                                if (_e2076[1] < 0f) {
                                    phi_3744_ = -(_e2076[1]);
                                } else {
                                    phi_3744_ = _e2076[1];
                                }
                                let _e2087 = phi_3744_;
                                if (_e2083 > _e2087) {
                                    phi_3749_ = _e2083;
                                } else {
                                    phi_3749_ = _e2087;
                                }
                                let _e2090 = phi_3749_;
                                if (_e2076[2] < 0f) {
                                    phi_3756_ = -(_e2076[2]);
                                } else {
                                    phi_3756_ = _e2076[2];
                                }
                                let _e2094 = phi_3756_;
                                if (_e2090 > _e2094) {
                                    phi_3761_ = _e2090;
                                } else {
                                    phi_3761_ = _e2094;
                                }
                                let _e2097 = phi_3761_;
                                if (_e2073 > _e2097) {
                                    phi_3766_ = _e2073;
                                } else {
                                    phi_3766_ = _e2097;
                                }
                                let _e2100 = phi_3766_;
                                let _e2102 = local_2.member_3;
                                let _e2106 = local_2.member_1[0u];
                                if (_e2106[0] < 0f) {
                                    phi_3783_ = -(_e2106[0]);
                                } else {
                                    phi_3783_ = _e2106[0];
                                }
                                let _e2113 = phi_3783_;
                                if (_e2106[1] < 0f) {
                                    phi_3790_ = -(_e2106[1]);
                                } else {
                                    phi_3790_ = _e2106[1];
                                }
                                let _e2117 = phi_3790_;
                                if (_e2113 > _e2117) {
                                    phi_3795_ = _e2113;
                                } else {
                                    phi_3795_ = _e2117;
                                }
                                let _e2120 = phi_3795_;
                                if (_e2106[2] < 0f) {
                                    phi_3802_ = -(_e2106[2]);
                                } else {
                                    phi_3802_ = _e2106[2];
                                }
                                let _e2124 = phi_3802_;
                                if (_e2120 > _e2124) {
                                    phi_3807_ = _e2120;
                                } else {
                                    phi_3807_ = _e2124;
                                }
                                let _e2127 = phi_3807_;
                                let _e2130 = local_2.member_1[1u];
                                if (_e2130[0] < 0f) {
                                    phi_3821_ = -(_e2130[0]);
                                } else {
                                    phi_3821_ = _e2130[0];
                                }
                                let _e2137 = phi_3821_;
                                if (_e2130[1] < 0f) {
                                    phi_3828_ = -(_e2130[1]);
                                } else {
                                    phi_3828_ = _e2130[1];
                                }
                                let _e2141 = phi_3828_;
                                if (_e2137 > _e2141) {
                                    phi_3833_ = _e2137;
                                } else {
                                    phi_3833_ = _e2141;
                                }
                                let _e2144 = phi_3833_;
                                if (_e2130[2] < 0f) {
                                    phi_3840_ = -(_e2130[2]);
                                } else {
                                    phi_3840_ = _e2130[2];
                                }
                                let _e2148 = phi_3840_;
                                if (_e2144 > _e2148) {
                                    phi_3845_ = _e2144;
                                } else {
                                    phi_3845_ = _e2148;
                                }
                                let _e2151 = phi_3845_;
                                if (_e2127 > _e2151) {
                                    phi_3850_ = _e2127;
                                } else {
                                    phi_3850_ = _e2151;
                                }
                                let _e2154 = phi_3850_;
                                let _e2156 = local_2.member_3;
                                let _e2160 = local_2.member_2[0u];
                                if (_e2160[0] < 0f) {
                                    phi_3867_ = -(_e2160[0]);
                                } else {
                                    phi_3867_ = _e2160[0];
                                }
                                let _e2167 = phi_3867_;
                                if (_e2160[1] < 0f) {
                                    phi_3874_ = -(_e2160[1]);
                                } else {
                                    phi_3874_ = _e2160[1];
                                }
                                let _e2171 = phi_3874_;
                                if (_e2167 > _e2171) {
                                    phi_3879_ = _e2167;
                                } else {
                                    phi_3879_ = _e2171;
                                }
                                let _e2174 = phi_3879_;
                                if (_e2160[2] < 0f) {
                                    phi_3886_ = -(_e2160[2]);
                                } else {
                                    phi_3886_ = _e2160[2];
                                }
                                let _e2178 = phi_3886_;
                                if (_e2174 > _e2178) {
                                    phi_3891_ = _e2174;
                                } else {
                                    phi_3891_ = _e2178;
                                }
                                let _e2181 = phi_3891_;
                                let _e2184 = local_2.member_2[1u];
                                if (_e2184[0] < 0f) {
                                    phi_3905_ = -(_e2184[0]);
                                } else {
                                    phi_3905_ = _e2184[0];
                                }
                                let _e2191 = phi_3905_;
                                if (_e2184[1] < 0f) {
                                    phi_3912_ = -(_e2184[1]);
                                } else {
                                    phi_3912_ = _e2184[1];
                                }
                                let _e2195 = phi_3912_;
                                if (_e2191 > _e2195) {
                                    phi_3917_ = _e2191;
                                } else {
                                    phi_3917_ = _e2195;
                                }
                                let _e2198 = phi_3917_;
                                if (_e2184[2] < 0f) {
                                    phi_3924_ = -(_e2184[2]);
                                } else {
                                    phi_3924_ = _e2184[2];
                                }
                                let _e2202 = phi_3924_;
                                if (_e2198 > _e2202) {
                                    phi_3929_ = _e2198;
                                } else {
                                    phi_3929_ = _e2202;
                                }
                                let _e2205 = phi_3929_;
                                if (_e2181 > _e2205) {
                                    phi_3934_ = _e2181;
                                } else {
                                    phi_3934_ = _e2205;
                                }
                                let _e2208 = phi_3934_;
                                let _e2210 = local_2.member_3;
                                let _e2213 = (((_e2100 + _e2102) + (_e2154 + _e2156)) + (_e2208 + _e2210));
                                let _e2216 = local_2.member_3;
                                let _e2220 = (((_e1450 * 1.0001f) + (_e2216 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2223 = ((_e1998 * _e1977) - (_e2001 * _e1976));
                                let _e2226 = ((_e2001 * _e1975) - (_e1995 * _e1977));
                                let _e2229 = ((_e1995 * _e1976) - (_e1998 * _e1975));
                                let _e2234 = (((_e2223 * _e2004[0]) + (_e2226 * _e2004[1])) + (_e2229 * _e2004[2]));
                                let _e2239 = (((_e2223 * _e2020) + (_e2226 * _e2021)) + (_e2229 * _e2022));
                                let _e2244 = (((_e2223 * _e2023) + (_e2226 * _e2024)) + (_e2229 * _e2025));
                                let _e2249 = (((_e2223 * _e2004[0]) + (_e2226 * _e2004[1])) + (_e2229 * _e2004[2]));
                                let _e2254 = (((_e2223 * _e2028[0]) + (_e2226 * _e2028[1])) + (_e2229 * _e2028[2]));
                                let _e2259 = (((_e2223 * _e2044) + (_e2226 * _e2045)) + (_e2229 * _e2046));
                                let _e2264 = (((_e2223 * _e2047) + (_e2226 * _e2048)) + (_e2229 * _e2049));
                                let _e2269 = (((_e2223 * _e2028[0]) + (_e2226 * _e2028[1])) + (_e2229 * _e2028[2]));
                                if (_e2234 < _e2239) {
                                    phi_4012_ = _e2234;
                                } else {
                                    phi_4012_ = _e2239;
                                }
                                let _e2272 = phi_4012_;
                                if (_e2244 < _e2249) {
                                    phi_4017_ = _e2244;
                                } else {
                                    phi_4017_ = _e2249;
                                }
                                let _e2275 = phi_4017_;
                                if (_e2272 < _e2275) {
                                    phi_4022_ = _e2272;
                                } else {
                                    phi_4022_ = _e2275;
                                }
                                let _e2278 = phi_4022_;
                                if (_e2254 < _e2259) {
                                    phi_4027_ = _e2254;
                                } else {
                                    phi_4027_ = _e2259;
                                }
                                let _e2281 = phi_4027_;
                                if (_e2264 < _e2269) {
                                    phi_4032_ = _e2264;
                                } else {
                                    phi_4032_ = _e2269;
                                }
                                let _e2284 = phi_4032_;
                                if (_e2281 < _e2284) {
                                    phi_4037_ = _e2281;
                                } else {
                                    phi_4037_ = _e2284;
                                }
                                let _e2287 = phi_4037_;
                                if (_e2278 < _e2287) {
                                    phi_4042_ = _e2278;
                                } else {
                                    phi_4042_ = _e2287;
                                }
                                let _e2290 = phi_4042_;
                                if (_e2234 > _e2239) {
                                    phi_4047_ = _e2234;
                                } else {
                                    phi_4047_ = _e2239;
                                }
                                let _e2293 = phi_4047_;
                                if (_e2244 > _e2249) {
                                    phi_4052_ = _e2244;
                                } else {
                                    phi_4052_ = _e2249;
                                }
                                let _e2296 = phi_4052_;
                                if (_e2293 > _e2296) {
                                    phi_4057_ = _e2293;
                                } else {
                                    phi_4057_ = _e2296;
                                }
                                let _e2299 = phi_4057_;
                                if (_e2254 > _e2259) {
                                    phi_4062_ = _e2254;
                                } else {
                                    phi_4062_ = _e2259;
                                }
                                let _e2302 = phi_4062_;
                                if (_e2264 > _e2269) {
                                    phi_4067_ = _e2264;
                                } else {
                                    phi_4067_ = _e2269;
                                }
                                let _e2305 = phi_4067_;
                                if (_e2302 > _e2305) {
                                    phi_4072_ = _e2302;
                                } else {
                                    phi_4072_ = _e2305;
                                }
                                let _e2308 = phi_4072_;
                                if (_e2299 > _e2308) {
                                    phi_4077_ = _e2299;
                                } else {
                                    phi_4077_ = _e2308;
                                }
                                let _e2311 = phi_4077_;
                                if (_e2223 < 0f) {
                                    phi_4083_ = -(_e2223);
                                } else {
                                    phi_4083_ = _e2223;
                                }
                                let _e2315 = phi_4083_;
                                if (_e2226 < 0f) {
                                    phi_4089_ = -(_e2226);
                                } else {
                                    phi_4089_ = _e2226;
                                }
                                let _e2319 = phi_4089_;
                                if (_e2229 < 0f) {
                                    phi_4096_ = -(_e2229);
                                } else {
                                    phi_4096_ = _e2229;
                                }
                                let _e2324 = phi_4096_;
                                let _e2325 = ((_e2315 + _e2319) + _e2324);
                                let _e2329 = -(_e2311);
                                if (_e2290 > _e2329) {
                                    phi_4106_ = _e2290;
                                } else {
                                    phi_4106_ = _e2329;
                                }
                                let _e2332 = phi_4106_;
                                let _e2337 = (((_e2332 - ((_e2325 * _e2213) * (0.000000059604645f * 17f))) - (_e2325 * _e2220)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2340 = ((_e1998 * _e1992) - (_e2001 * _e1991));
                                let _e2343 = ((_e2001 * _e1990) - (_e1995 * _e1992));
                                let _e2346 = ((_e1995 * _e1991) - (_e1998 * _e1990));
                                let _e2351 = (((_e2340 * _e2004[0]) + (_e2343 * _e2004[1])) + (_e2346 * _e2004[2]));
                                let _e2356 = (((_e2340 * _e2020) + (_e2343 * _e2021)) + (_e2346 * _e2022));
                                let _e2361 = (((_e2340 * _e2023) + (_e2343 * _e2024)) + (_e2346 * _e2025));
                                let _e2366 = (((_e2340 * _e2004[0]) + (_e2343 * _e2004[1])) + (_e2346 * _e2004[2]));
                                let _e2371 = (((_e2340 * _e2028[0]) + (_e2343 * _e2028[1])) + (_e2346 * _e2028[2]));
                                let _e2376 = (((_e2340 * _e2044) + (_e2343 * _e2045)) + (_e2346 * _e2046));
                                let _e2381 = (((_e2340 * _e2047) + (_e2343 * _e2048)) + (_e2346 * _e2049));
                                let _e2386 = (((_e2340 * _e2028[0]) + (_e2343 * _e2028[1])) + (_e2346 * _e2028[2]));
                                if (_e2351 < _e2356) {
                                    phi_4177_ = _e2351;
                                } else {
                                    phi_4177_ = _e2356;
                                }
                                let _e2389 = phi_4177_;
                                if (_e2361 < _e2366) {
                                    phi_4182_ = _e2361;
                                } else {
                                    phi_4182_ = _e2366;
                                }
                                let _e2392 = phi_4182_;
                                if (_e2389 < _e2392) {
                                    phi_4187_ = _e2389;
                                } else {
                                    phi_4187_ = _e2392;
                                }
                                let _e2395 = phi_4187_;
                                if (_e2371 < _e2376) {
                                    phi_4192_ = _e2371;
                                } else {
                                    phi_4192_ = _e2376;
                                }
                                let _e2398 = phi_4192_;
                                if (_e2381 < _e2386) {
                                    phi_4197_ = _e2381;
                                } else {
                                    phi_4197_ = _e2386;
                                }
                                let _e2401 = phi_4197_;
                                if (_e2398 < _e2401) {
                                    phi_4202_ = _e2398;
                                } else {
                                    phi_4202_ = _e2401;
                                }
                                let _e2404 = phi_4202_;
                                if (_e2395 < _e2404) {
                                    phi_4207_ = _e2395;
                                } else {
                                    phi_4207_ = _e2404;
                                }
                                let _e2407 = phi_4207_;
                                if (_e2351 > _e2356) {
                                    phi_4212_ = _e2351;
                                } else {
                                    phi_4212_ = _e2356;
                                }
                                let _e2410 = phi_4212_;
                                if (_e2361 > _e2366) {
                                    phi_4217_ = _e2361;
                                } else {
                                    phi_4217_ = _e2366;
                                }
                                let _e2413 = phi_4217_;
                                if (_e2410 > _e2413) {
                                    phi_4222_ = _e2410;
                                } else {
                                    phi_4222_ = _e2413;
                                }
                                let _e2416 = phi_4222_;
                                if (_e2371 > _e2376) {
                                    phi_4227_ = _e2371;
                                } else {
                                    phi_4227_ = _e2376;
                                }
                                let _e2419 = phi_4227_;
                                if (_e2381 > _e2386) {
                                    phi_4232_ = _e2381;
                                } else {
                                    phi_4232_ = _e2386;
                                }
                                let _e2422 = phi_4232_;
                                if (_e2419 > _e2422) {
                                    phi_4237_ = _e2419;
                                } else {
                                    phi_4237_ = _e2422;
                                }
                                let _e2425 = phi_4237_;
                                if (_e2416 > _e2425) {
                                    phi_4242_ = _e2416;
                                } else {
                                    phi_4242_ = _e2425;
                                }
                                let _e2428 = phi_4242_;
                                if (_e2340 < 0f) {
                                    phi_4248_ = -(_e2340);
                                } else {
                                    phi_4248_ = _e2340;
                                }
                                let _e2432 = phi_4248_;
                                if (_e2343 < 0f) {
                                    phi_4254_ = -(_e2343);
                                } else {
                                    phi_4254_ = _e2343;
                                }
                                let _e2436 = phi_4254_;
                                if (_e2346 < 0f) {
                                    phi_4261_ = -(_e2346);
                                } else {
                                    phi_4261_ = _e2346;
                                }
                                let _e2441 = phi_4261_;
                                let _e2442 = ((_e2432 + _e2436) + _e2441);
                                let _e2446 = -(_e2428);
                                if (_e2407 > _e2446) {
                                    phi_4271_ = _e2407;
                                } else {
                                    phi_4271_ = _e2446;
                                }
                                let _e2449 = phi_4271_;
                                let _e2454 = (((_e2449 - ((_e2442 * _e2213) * (0.000000059604645f * 17f))) - (_e2442 * _e2220)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2337 > _e2454) {
                                    phi_4281_ = _e2337;
                                } else {
                                    phi_4281_ = _e2454;
                                }
                                let _e2457 = phi_4281_;
                                let _e2458 = (_e1990 - _e1975);
                                let _e2459 = (_e1991 - _e1976);
                                let _e2460 = (_e1992 - _e1977);
                                let _e2463 = ((_e1998 * _e2460) - (_e2001 * _e2459));
                                let _e2466 = ((_e2001 * _e2458) - (_e1995 * _e2460));
                                let _e2469 = ((_e1995 * _e2459) - (_e1998 * _e2458));
                                let _e2474 = (((_e2463 * _e2004[0]) + (_e2466 * _e2004[1])) + (_e2469 * _e2004[2]));
                                let _e2479 = (((_e2463 * _e2020) + (_e2466 * _e2021)) + (_e2469 * _e2022));
                                let _e2484 = (((_e2463 * _e2023) + (_e2466 * _e2024)) + (_e2469 * _e2025));
                                let _e2489 = (((_e2463 * _e2004[0]) + (_e2466 * _e2004[1])) + (_e2469 * _e2004[2]));
                                let _e2494 = (((_e2463 * _e2028[0]) + (_e2466 * _e2028[1])) + (_e2469 * _e2028[2]));
                                let _e2499 = (((_e2463 * _e2044) + (_e2466 * _e2045)) + (_e2469 * _e2046));
                                let _e2504 = (((_e2463 * _e2047) + (_e2466 * _e2048)) + (_e2469 * _e2049));
                                let _e2509 = (((_e2463 * _e2028[0]) + (_e2466 * _e2028[1])) + (_e2469 * _e2028[2]));
                                if (_e2474 < _e2479) {
                                    phi_4354_ = _e2474;
                                } else {
                                    phi_4354_ = _e2479;
                                }
                                let _e2512 = phi_4354_;
                                if (_e2484 < _e2489) {
                                    phi_4359_ = _e2484;
                                } else {
                                    phi_4359_ = _e2489;
                                }
                                let _e2515 = phi_4359_;
                                if (_e2512 < _e2515) {
                                    phi_4364_ = _e2512;
                                } else {
                                    phi_4364_ = _e2515;
                                }
                                let _e2518 = phi_4364_;
                                if (_e2494 < _e2499) {
                                    phi_4369_ = _e2494;
                                } else {
                                    phi_4369_ = _e2499;
                                }
                                let _e2521 = phi_4369_;
                                if (_e2504 < _e2509) {
                                    phi_4374_ = _e2504;
                                } else {
                                    phi_4374_ = _e2509;
                                }
                                let _e2524 = phi_4374_;
                                if (_e2521 < _e2524) {
                                    phi_4379_ = _e2521;
                                } else {
                                    phi_4379_ = _e2524;
                                }
                                let _e2527 = phi_4379_;
                                if (_e2518 < _e2527) {
                                    phi_4384_ = _e2518;
                                } else {
                                    phi_4384_ = _e2527;
                                }
                                let _e2530 = phi_4384_;
                                if (_e2474 > _e2479) {
                                    phi_4389_ = _e2474;
                                } else {
                                    phi_4389_ = _e2479;
                                }
                                let _e2533 = phi_4389_;
                                if (_e2484 > _e2489) {
                                    phi_4394_ = _e2484;
                                } else {
                                    phi_4394_ = _e2489;
                                }
                                let _e2536 = phi_4394_;
                                if (_e2533 > _e2536) {
                                    phi_4399_ = _e2533;
                                } else {
                                    phi_4399_ = _e2536;
                                }
                                let _e2539 = phi_4399_;
                                if (_e2494 > _e2499) {
                                    phi_4404_ = _e2494;
                                } else {
                                    phi_4404_ = _e2499;
                                }
                                let _e2542 = phi_4404_;
                                if (_e2504 > _e2509) {
                                    phi_4409_ = _e2504;
                                } else {
                                    phi_4409_ = _e2509;
                                }
                                let _e2545 = phi_4409_;
                                if (_e2542 > _e2545) {
                                    phi_4414_ = _e2542;
                                } else {
                                    phi_4414_ = _e2545;
                                }
                                let _e2548 = phi_4414_;
                                if (_e2539 > _e2548) {
                                    phi_4419_ = _e2539;
                                } else {
                                    phi_4419_ = _e2548;
                                }
                                let _e2551 = phi_4419_;
                                if (_e2463 < 0f) {
                                    phi_4425_ = -(_e2463);
                                } else {
                                    phi_4425_ = _e2463;
                                }
                                let _e2555 = phi_4425_;
                                if (_e2466 < 0f) {
                                    phi_4431_ = -(_e2466);
                                } else {
                                    phi_4431_ = _e2466;
                                }
                                let _e2559 = phi_4431_;
                                if (_e2469 < 0f) {
                                    phi_4438_ = -(_e2469);
                                } else {
                                    phi_4438_ = _e2469;
                                }
                                let _e2564 = phi_4438_;
                                let _e2565 = ((_e2555 + _e2559) + _e2564);
                                let _e2569 = -(_e2551);
                                if (_e2530 > _e2569) {
                                    phi_4448_ = _e2530;
                                } else {
                                    phi_4448_ = _e2569;
                                }
                                let _e2572 = phi_4448_;
                                let _e2577 = (((_e2572 - ((_e2565 * _e2213) * (0.000000059604645f * 17f))) - (_e2565 * _e2220)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2457 > _e2577) {
                                    phi_4458_ = _e2457;
                                } else {
                                    phi_4458_ = _e2577;
                                }
                                let _e2580 = phi_4458_;
                                phi_4461_ = (_e2580 > 0f);
                            }
                            let _e2583 = phi_4461_;
                            if _e2583 {
                                phi_7867_ = false;
                            } else {
                                let _e2586 = local_2.member[0u];
                                let _e2592 = local_2.member[1u];
                                let _e2599 = ((_e2586[0] + _e2592[0]) * 0.5f);
                                let _e2600 = ((_e2586[1] + _e2592[1]) * 0.5f);
                                let _e2601 = ((_e2586[2] + _e2592[2]) * 0.5f);
                                let _e2604 = local_2.member_1[0u];
                                let _e2610 = local_2.member_1[1u];
                                let _e2617 = ((_e2604[0] + _e2610[0]) * 0.5f);
                                let _e2618 = ((_e2604[1] + _e2610[1]) * 0.5f);
                                let _e2619 = ((_e2604[2] + _e2610[2]) * 0.5f);
                                let _e2622 = local_2.member_2[0u];
                                let _e2628 = local_2.member_2[1u];
                                let _e2635 = ((_e2622[0] + _e2628[0]) * 0.5f);
                                let _e2636 = ((_e2622[1] + _e2628[1]) * 0.5f);
                                let _e2637 = ((_e2622[2] + _e2628[2]) * 0.5f);
                                let _e2640 = local_2.member[0u];
                                let _e2643 = local_2.member_1[0u];
                                let _e2646 = local_2.member_2[0u];
                                let _e2648 = local_2.member_3;
                                let _e2651 = local_2.member[1u];
                                let _e2654 = local_2.member_1[1u];
                                let _e2657 = local_2.member_2[1u];
                                let _e2659 = local_2.member_3;
                                local = type_37(array<array<f32, 3>, 2>(_e2640, array<f32, 3>(_e2599, _e2600, _e2601)), array<array<f32, 3>, 2>(_e2643, array<f32, 3>(_e2617, _e2618, _e2619)), array<array<f32, 3>, 2>(_e2646, array<f32, 3>(_e2635, _e2636, _e2637)), _e2648);
                                local_1 = type_37(array<array<f32, 3>, 2>(array<f32, 3>(_e2599, _e2600, _e2601), _e2651), array<array<f32, 3>, 2>(array<f32, 3>(_e2617, _e2618, _e2619), _e2654), array<array<f32, 3>, 2>(array<f32, 3>(_e2635, _e2636, _e2637), _e2657), _e2659);
                                let _e2676 = local.member_1[0u];
                                let _e2682 = local.member_2[0u];
                                let _e2688 = ((_e2676[1] * _e2682[2]) - (_e2676[2] * _e2682[1]));
                                let _e2691 = ((_e2676[2] * _e2682[0]) - (_e2676[0] * _e2682[2]));
                                let _e2694 = ((_e2676[0] * _e2682[1]) - (_e2676[1] * _e2682[0]));
                                let _e2697 = local.member_1[1u];
                                let _e2703 = local.member_2[1u];
                                let _e2709 = ((_e2697[1] * _e2703[2]) - (_e2697[2] * _e2703[1]));
                                let _e2712 = ((_e2697[2] * _e2703[0]) - (_e2697[0] * _e2703[2]));
                                let _e2715 = ((_e2697[0] * _e2703[1]) - (_e2697[1] * _e2703[0]));
                                let _e2718 = local.member_1[0u];
                                let _e2724 = local.member_2[1u];
                                let _e2739 = local.member_1[1u];
                                let _e2745 = local.member_2[0u];
                                let _e2758 = (((_e2718[1] * _e2724[2]) - (_e2718[2] * _e2724[1])) + ((_e2739[1] * _e2745[2]) - (_e2739[2] * _e2745[1])));
                                let _e2759 = (((_e2718[2] * _e2724[0]) - (_e2718[0] * _e2724[2])) + ((_e2739[2] * _e2745[0]) - (_e2739[0] * _e2745[2])));
                                let _e2760 = (((_e2718[0] * _e2724[1]) - (_e2718[1] * _e2724[0])) + ((_e2739[0] * _e2745[1]) - (_e2739[1] * _e2745[0])));
                                let _e2763 = local.member[0u];
                                let _e2774 = local.member[1u];
                                let _e2785 = local.member[0u];
                                let _e2794 = ((((_e2774[0] * _e2688) + (_e2774[1] * _e2691)) + (_e2774[2] * _e2694)) + (((_e2785[0] * _e2758) + (_e2785[1] * _e2759)) + (_e2785[2] * _e2760)));
                                let _e2797 = local.member[0u];
                                let _e2808 = local.member[1u];
                                let _e2817 = ((((_e2797[0] * _e2709) + (_e2797[1] * _e2712)) + (_e2797[2] * _e2715)) + (((_e2808[0] * _e2758) + (_e2808[1] * _e2759)) + (_e2808[2] * _e2760)));
                                let _e2820 = local.member[1u];
                                let _e2831 = local.member[0u];
                                if (_e2831[0] < 0f) {
                                    phi_4913_ = -(_e2831[0]);
                                } else {
                                    phi_4913_ = _e2831[0];
                                }
                                let _e2838 = phi_4913_;
                                if (_e2831[1] < 0f) {
                                    phi_4920_ = -(_e2831[1]);
                                } else {
                                    phi_4920_ = _e2831[1];
                                }
                                let _e2842 = phi_4920_;
                                if (_e2838 > _e2842) {
                                    phi_4925_ = _e2838;
                                } else {
                                    phi_4925_ = _e2842;
                                }
                                let _e2845 = phi_4925_;
                                if (_e2831[2] < 0f) {
                                    phi_4932_ = -(_e2831[2]);
                                } else {
                                    phi_4932_ = _e2831[2];
                                }
                                let _e2849 = phi_4932_;
                                if (_e2845 > _e2849) {
                                    phi_4937_ = _e2845;
                                } else {
                                    phi_4937_ = _e2849;
                                }
                                let _e2852 = phi_4937_;
                                let _e2855 = local.member[1u];
                                if (_e2855[0] < 0f) {
                                    phi_4950_ = -(_e2855[0]);
                                } else {
                                    phi_4950_ = _e2855[0];
                                }
                                let _e2862 = phi_4950_;
                                if (_e2855[1] < 0f) {
                                    phi_4957_ = -(_e2855[1]);
                                } else {
                                    phi_4957_ = _e2855[1];
                                }
                                let _e2866 = phi_4957_;
                                if (_e2862 > _e2866) {
                                    phi_4962_ = _e2862;
                                } else {
                                    phi_4962_ = _e2866;
                                }
                                let _e2869 = phi_4962_;
                                if (_e2855[2] < 0f) {
                                    phi_4969_ = -(_e2855[2]);
                                } else {
                                    phi_4969_ = _e2855[2];
                                }
                                let _e2873 = phi_4969_;
                                if (_e2869 > _e2873) {
                                    phi_4974_ = _e2869;
                                } else {
                                    phi_4974_ = _e2873;
                                }
                                let _e2876 = phi_4974_;
                                if (_e2852 > _e2876) {
                                    phi_4979_ = _e2852;
                                } else {
                                    phi_4979_ = _e2876;
                                }
                                let _e2879 = phi_4979_;
                                let _e2881 = local.member_3;
                                let _e2882 = (_e2879 + _e2881);
                                let _e2885 = local.member_1[0u];
                                if (_e2885[0] < 0f) {
                                    phi_4996_ = -(_e2885[0]);
                                } else {
                                    phi_4996_ = _e2885[0];
                                }
                                let _e2892 = phi_4996_;
                                if (_e2885[1] < 0f) {
                                    phi_5003_ = -(_e2885[1]);
                                } else {
                                    phi_5003_ = _e2885[1];
                                }
                                let _e2896 = phi_5003_;
                                if (_e2892 > _e2896) {
                                    phi_5008_ = _e2892;
                                } else {
                                    phi_5008_ = _e2896;
                                }
                                let _e2899 = phi_5008_;
                                if (_e2885[2] < 0f) {
                                    phi_5015_ = -(_e2885[2]);
                                } else {
                                    phi_5015_ = _e2885[2];
                                }
                                let _e2903 = phi_5015_;
                                if (_e2899 > _e2903) {
                                    phi_5020_ = _e2899;
                                } else {
                                    phi_5020_ = _e2903;
                                }
                                let _e2906 = phi_5020_;
                                let _e2909 = local.member_1[1u];
                                if (_e2909[0] < 0f) {
                                    phi_5034_ = -(_e2909[0]);
                                } else {
                                    phi_5034_ = _e2909[0];
                                }
                                let _e2916 = phi_5034_;
                                if (_e2909[1] < 0f) {
                                    phi_5041_ = -(_e2909[1]);
                                } else {
                                    phi_5041_ = _e2909[1];
                                }
                                let _e2920 = phi_5041_;
                                if (_e2916 > _e2920) {
                                    phi_5046_ = _e2916;
                                } else {
                                    phi_5046_ = _e2920;
                                }
                                let _e2923 = phi_5046_;
                                if (_e2909[2] < 0f) {
                                    phi_5053_ = -(_e2909[2]);
                                } else {
                                    phi_5053_ = _e2909[2];
                                }
                                let _e2927 = phi_5053_;
                                if (_e2923 > _e2927) {
                                    phi_5058_ = _e2923;
                                } else {
                                    phi_5058_ = _e2927;
                                }
                                let _e2930 = phi_5058_;
                                if (_e2906 > _e2930) {
                                    phi_5063_ = _e2906;
                                } else {
                                    phi_5063_ = _e2930;
                                }
                                let _e2933 = phi_5063_;
                                let _e2935 = local.member_3;
                                let _e2936 = (_e2933 + _e2935);
                                let _e2939 = local.member_2[0u];
                                if (_e2939[0] < 0f) {
                                    phi_5080_ = -(_e2939[0]);
                                } else {
                                    phi_5080_ = _e2939[0];
                                }
                                let _e2946 = phi_5080_;
                                if (_e2939[1] < 0f) {
                                    phi_5087_ = -(_e2939[1]);
                                } else {
                                    phi_5087_ = _e2939[1];
                                }
                                let _e2950 = phi_5087_;
                                if (_e2946 > _e2950) {
                                    phi_5092_ = _e2946;
                                } else {
                                    phi_5092_ = _e2950;
                                }
                                let _e2953 = phi_5092_;
                                if (_e2939[2] < 0f) {
                                    phi_5099_ = -(_e2939[2]);
                                } else {
                                    phi_5099_ = _e2939[2];
                                }
                                let _e2957 = phi_5099_;
                                if (_e2953 > _e2957) {
                                    phi_5104_ = _e2953;
                                } else {
                                    phi_5104_ = _e2957;
                                }
                                let _e2960 = phi_5104_;
                                let _e2963 = local.member_2[1u];
                                if (_e2963[0] < 0f) {
                                    phi_5118_ = -(_e2963[0]);
                                } else {
                                    phi_5118_ = _e2963[0];
                                }
                                let _e2970 = phi_5118_;
                                if (_e2963[1] < 0f) {
                                    phi_5125_ = -(_e2963[1]);
                                } else {
                                    phi_5125_ = _e2963[1];
                                }
                                let _e2974 = phi_5125_;
                                if (_e2970 > _e2974) {
                                    phi_5130_ = _e2970;
                                } else {
                                    phi_5130_ = _e2974;
                                }
                                let _e2977 = phi_5130_;
                                if (_e2963[2] < 0f) {
                                    phi_5137_ = -(_e2963[2]);
                                } else {
                                    phi_5137_ = _e2963[2];
                                }
                                let _e2981 = phi_5137_;
                                if (_e2977 > _e2981) {
                                    phi_5142_ = _e2977;
                                } else {
                                    phi_5142_ = _e2981;
                                }
                                let _e2984 = phi_5142_;
                                if (_e2960 > _e2984) {
                                    phi_5147_ = _e2960;
                                } else {
                                    phi_5147_ = _e2984;
                                }
                                let _e2987 = phi_5147_;
                                let _e2989 = local.member_3;
                                let _e2990 = (_e2987 + _e2989);
                                let _e2992 = ((_e2936 * 8f) * _e2990);
                                let _e2999 = local.member_3;
                                if (_e2688 < 0f) {
                                    phi_5178_ = -(_e2688);
                                } else {
                                    phi_5178_ = _e2688;
                                }
                                let _e3016 = phi_5178_;
                                if (_e2691 < 0f) {
                                    phi_5184_ = -(_e2691);
                                } else {
                                    phi_5184_ = _e2691;
                                }
                                let _e3020 = phi_5184_;
                                if (_e2694 < 0f) {
                                    phi_5191_ = -(_e2694);
                                } else {
                                    phi_5191_ = _e2694;
                                }
                                let _e3025 = phi_5191_;
                                let _e3026 = ((_e3016 + _e3020) + _e3025);
                                if (_e2709 < 0f) {
                                    phi_5198_ = -(_e2709);
                                } else {
                                    phi_5198_ = _e2709;
                                }
                                let _e3030 = phi_5198_;
                                if (_e2712 < 0f) {
                                    phi_5204_ = -(_e2712);
                                } else {
                                    phi_5204_ = _e2712;
                                }
                                let _e3034 = phi_5204_;
                                if (_e2715 < 0f) {
                                    phi_5211_ = -(_e2715);
                                } else {
                                    phi_5211_ = _e2715;
                                }
                                let _e3039 = phi_5211_;
                                let _e3040 = ((_e3030 + _e3034) + _e3039);
                                if (_e3026 > _e3040) {
                                    phi_5217_ = _e3026;
                                } else {
                                    phi_5217_ = _e3040;
                                }
                                let _e3043 = phi_5217_;
                                if (_e2758 < 0f) {
                                    phi_5223_ = -(_e2758);
                                } else {
                                    phi_5223_ = _e2758;
                                }
                                let _e3047 = phi_5223_;
                                if (_e2759 < 0f) {
                                    phi_5229_ = -(_e2759);
                                } else {
                                    phi_5229_ = _e2759;
                                }
                                let _e3051 = phi_5229_;
                                if (_e2760 < 0f) {
                                    phi_5236_ = -(_e2760);
                                } else {
                                    phi_5236_ = _e2760;
                                }
                                let _e3056 = phi_5236_;
                                let _e3058 = (((_e3047 + _e3051) + _e3056) * 0.5f);
                                if (_e3043 > _e3058) {
                                    phi_5243_ = _e3043;
                                } else {
                                    phi_5243_ = _e3058;
                                }
                                let _e3061 = phi_5243_;
                                let _e3066 = local.member_3;
                                let _e3079 = ((((_e2763[0] * _e2688) + (_e2763[1] * _e2691)) + (_e2763[2] * _e2694)) * 3f);
                                let _e3080 = ((((_e2820[0] * _e2709) + (_e2820[1] * _e2712)) + (_e2820[2] * _e2715)) * 3f);
                                if (_e3079 < _e3080) {
                                    phi_5267_ = _e3079;
                                } else {
                                    phi_5267_ = _e3080;
                                }
                                let _e3083 = phi_5267_;
                                if (_e2794 < _e2817) {
                                    phi_5272_ = _e2794;
                                } else {
                                    phi_5272_ = _e2817;
                                }
                                let _e3086 = phi_5272_;
                                if (_e3083 < _e3086) {
                                    phi_5277_ = _e3083;
                                } else {
                                    phi_5277_ = _e3086;
                                }
                                let _e3089 = phi_5277_;
                                if (_e3079 > _e3080) {
                                    phi_5282_ = _e3079;
                                } else {
                                    phi_5282_ = _e3080;
                                }
                                let _e3092 = phi_5282_;
                                if (_e2794 > _e2817) {
                                    phi_5287_ = _e2794;
                                } else {
                                    phi_5287_ = _e2817;
                                }
                                let _e3095 = phi_5287_;
                                if (_e3092 > _e3095) {
                                    phi_5292_ = _e3092;
                                } else {
                                    phi_5292_ = _e3095;
                                }
                                let _e3098 = phi_5292_;
                                let _e3103 = -(_e3098);
                                if (_e3089 > _e3103) {
                                    phi_5302_ = _e3089;
                                } else {
                                    phi_5302_ = _e3103;
                                }
                                let _e3106 = phi_5302_;
                                if ((_e3106 - ((((((_e2882 * 8f) * _e2992) * (0.000000059604645f * (490f / 64f))) + ((_e2999 * 19f) * ((_e2882 * (_e2936 + _e2990)) + (_e2936 * _e2990)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2882) * ((1f + _e2936) * (1f + _e2990))))) + ((_e1450 * (((_e3061 + (_e2992 * (0.000000059604645f * 4f))) + ((_e3066 * 6f) * (_e2936 + _e2990))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2936) * (1f + _e2990))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6266_ = true;
                                } else {
                                    let _e3111 = local.member_1[0u];
                                    let _e3117 = local.member_1[1u];
                                    let _e3121 = (_e3111[0] + _e3117[0]);
                                    let _e3122 = (_e3111[1] + _e3117[1]);
                                    let _e3123 = (_e3111[2] + _e3117[2]);
                                    let _e3126 = local.member_2[0u];
                                    let _e3132 = local.member_2[1u];
                                    let _e3136 = (_e3126[0] + _e3132[0]);
                                    let _e3137 = (_e3126[1] + _e3132[1]);
                                    let _e3138 = (_e3126[2] + _e3132[2]);
                                    let _e3141 = ((_e3122 * _e3138) - (_e3123 * _e3137));
                                    let _e3144 = ((_e3123 * _e3136) - (_e3121 * _e3138));
                                    let _e3147 = ((_e3121 * _e3137) - (_e3122 * _e3136));
                                    let _e3150 = local.member[0u];
                                    let _e3156 = local.member_1[0u];
                                    let _e3162 = local.member_2[0u];
                                    let _e3166 = (_e3150[0] - _e3156[0]);
                                    let _e3167 = (_e3150[1] - _e3156[1]);
                                    let _e3168 = (_e3150[2] - _e3156[2]);
                                    let _e3169 = (_e3150[0] - _e3162[0]);
                                    let _e3170 = (_e3150[1] - _e3162[1]);
                                    let _e3171 = (_e3150[2] - _e3162[2]);
                                    let _e3174 = local.member[1u];
                                    let _e3180 = local.member_1[1u];
                                    let _e3186 = local.member_2[1u];
                                    let _e3190 = (_e3174[0] - _e3180[0]);
                                    let _e3191 = (_e3174[1] - _e3180[1]);
                                    let _e3192 = (_e3174[2] - _e3180[2]);
                                    let _e3193 = (_e3174[0] - _e3186[0]);
                                    let _e3194 = (_e3174[1] - _e3186[1]);
                                    let _e3195 = (_e3174[2] - _e3186[2]);
                                    let _e3198 = local.member[0u];
                                    if (_e3198[0] < 0f) {
                                        phi_5505_ = -(_e3198[0]);
                                    } else {
                                        phi_5505_ = _e3198[0];
                                    }
                                    let _e3205 = phi_5505_;
                                    if (_e3198[1] < 0f) {
                                        phi_5512_ = -(_e3198[1]);
                                    } else {
                                        phi_5512_ = _e3198[1];
                                    }
                                    let _e3209 = phi_5512_;
                                    if (_e3205 > _e3209) {
                                        phi_5517_ = _e3205;
                                    } else {
                                        phi_5517_ = _e3209;
                                    }
                                    let _e3212 = phi_5517_;
                                    if (_e3198[2] < 0f) {
                                        phi_5524_ = -(_e3198[2]);
                                    } else {
                                        phi_5524_ = _e3198[2];
                                    }
                                    let _e3216 = phi_5524_;
                                    if (_e3212 > _e3216) {
                                        phi_5529_ = _e3212;
                                    } else {
                                        phi_5529_ = _e3216;
                                    }
                                    let _e3219 = phi_5529_;
                                    let _e3222 = local.member[1u];
                                    if (_e3222[0] < 0f) {
                                        phi_5542_ = -(_e3222[0]);
                                    } else {
                                        phi_5542_ = _e3222[0];
                                    }
                                    let _e3229 = phi_5542_;
                                    if (_e3222[1] < 0f) {
                                        phi_5549_ = -(_e3222[1]);
                                    } else {
                                        phi_5549_ = _e3222[1];
                                    }
                                    let _e3233 = phi_5549_;
                                    if (_e3229 > _e3233) {
                                        phi_5554_ = _e3229;
                                    } else {
                                        phi_5554_ = _e3233;
                                    }
                                    let _e3236 = phi_5554_;
                                    if (_e3222[2] < 0f) {
                                        phi_5561_ = -(_e3222[2]);
                                    } else {
                                        phi_5561_ = _e3222[2];
                                    }
                                    let _e3240 = phi_5561_;
                                    if (_e3236 > _e3240) {
                                        phi_5566_ = _e3236;
                                    } else {
                                        phi_5566_ = _e3240;
                                    }
                                    let _e3243 = phi_5566_;
                                    if (_e3219 > _e3243) {
                                        phi_5571_ = _e3219;
                                    } else {
                                        phi_5571_ = _e3243;
                                    }
                                    let _e3246 = phi_5571_;
                                    let _e3248 = local.member_3;
                                    let _e3252 = local.member_1[0u];
                                    if (_e3252[0] < 0f) {
                                        phi_5588_ = -(_e3252[0]);
                                    } else {
                                        phi_5588_ = _e3252[0];
                                    }
                                    let _e3259 = phi_5588_;
                                    if (_e3252[1] < 0f) {
                                        phi_5595_ = -(_e3252[1]);
                                    } else {
                                        phi_5595_ = _e3252[1];
                                    }
                                    let _e3263 = phi_5595_;
                                    if (_e3259 > _e3263) {
                                        phi_5600_ = _e3259;
                                    } else {
                                        phi_5600_ = _e3263;
                                    }
                                    let _e3266 = phi_5600_;
                                    if (_e3252[2] < 0f) {
                                        phi_5607_ = -(_e3252[2]);
                                    } else {
                                        phi_5607_ = _e3252[2];
                                    }
                                    let _e3270 = phi_5607_;
                                    if (_e3266 > _e3270) {
                                        phi_5612_ = _e3266;
                                    } else {
                                        phi_5612_ = _e3270;
                                    }
                                    let _e3273 = phi_5612_;
                                    let _e3276 = local.member_1[1u];
                                    if (_e3276[0] < 0f) {
                                        phi_5626_ = -(_e3276[0]);
                                    } else {
                                        phi_5626_ = _e3276[0];
                                    }
                                    let _e3283 = phi_5626_;
                                    if (_e3276[1] < 0f) {
                                        phi_5633_ = -(_e3276[1]);
                                    } else {
                                        phi_5633_ = _e3276[1];
                                    }
                                    let _e3287 = phi_5633_;
                                    if (_e3283 > _e3287) {
                                        phi_5638_ = _e3283;
                                    } else {
                                        phi_5638_ = _e3287;
                                    }
                                    let _e3290 = phi_5638_;
                                    if (_e3276[2] < 0f) {
                                        phi_5645_ = -(_e3276[2]);
                                    } else {
                                        phi_5645_ = _e3276[2];
                                    }
                                    let _e3294 = phi_5645_;
                                    if (_e3290 > _e3294) {
                                        phi_5650_ = _e3290;
                                    } else {
                                        phi_5650_ = _e3294;
                                    }
                                    let _e3297 = phi_5650_;
                                    if (_e3273 > _e3297) {
                                        phi_5655_ = _e3273;
                                    } else {
                                        phi_5655_ = _e3297;
                                    }
                                    let _e3300 = phi_5655_;
                                    let _e3302 = local.member_3;
                                    let _e3306 = local.member_2[0u];
                                    if (_e3306[0] < 0f) {
                                        phi_5672_ = -(_e3306[0]);
                                    } else {
                                        phi_5672_ = _e3306[0];
                                    }
                                    let _e3313 = phi_5672_;
                                    if (_e3306[1] < 0f) {
                                        phi_5679_ = -(_e3306[1]);
                                    } else {
                                        phi_5679_ = _e3306[1];
                                    }
                                    let _e3317 = phi_5679_;
                                    if (_e3313 > _e3317) {
                                        phi_5684_ = _e3313;
                                    } else {
                                        phi_5684_ = _e3317;
                                    }
                                    let _e3320 = phi_5684_;
                                    if (_e3306[2] < 0f) {
                                        phi_5691_ = -(_e3306[2]);
                                    } else {
                                        phi_5691_ = _e3306[2];
                                    }
                                    let _e3324 = phi_5691_;
                                    if (_e3320 > _e3324) {
                                        phi_5696_ = _e3320;
                                    } else {
                                        phi_5696_ = _e3324;
                                    }
                                    let _e3327 = phi_5696_;
                                    let _e3330 = local.member_2[1u];
                                    if (_e3330[0] < 0f) {
                                        phi_5710_ = -(_e3330[0]);
                                    } else {
                                        phi_5710_ = _e3330[0];
                                    }
                                    let _e3337 = phi_5710_;
                                    if (_e3330[1] < 0f) {
                                        phi_5717_ = -(_e3330[1]);
                                    } else {
                                        phi_5717_ = _e3330[1];
                                    }
                                    let _e3341 = phi_5717_;
                                    if (_e3337 > _e3341) {
                                        phi_5722_ = _e3337;
                                    } else {
                                        phi_5722_ = _e3341;
                                    }
                                    let _e3344 = phi_5722_;
                                    if (_e3330[2] < 0f) {
                                        phi_5729_ = -(_e3330[2]);
                                    } else {
                                        phi_5729_ = _e3330[2];
                                    }
                                    let _e3348 = phi_5729_;
                                    if (_e3344 > _e3348) {
                                        phi_5734_ = _e3344;
                                    } else {
                                        phi_5734_ = _e3348;
                                    }
                                    let _e3351 = phi_5734_;
                                    if (_e3327 > _e3351) {
                                        phi_5739_ = _e3327;
                                    } else {
                                        phi_5739_ = _e3351;
                                    }
                                    let _e3354 = phi_5739_;
                                    let _e3356 = local.member_3;
                                    let _e3359 = (((_e3246 + _e3248) + (_e3300 + _e3302)) + (_e3354 + _e3356));
                                    let _e3362 = local.member_3;
                                    let _e3366 = (((_e1450 * 1.0001f) + (_e3362 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3369 = ((_e3144 * _e3123) - (_e3147 * _e3122));
                                    let _e3372 = ((_e3147 * _e3121) - (_e3141 * _e3123));
                                    let _e3375 = ((_e3141 * _e3122) - (_e3144 * _e3121));
                                    let _e3380 = (((_e3369 * _e3150[0]) + (_e3372 * _e3150[1])) + (_e3375 * _e3150[2]));
                                    let _e3385 = (((_e3369 * _e3166) + (_e3372 * _e3167)) + (_e3375 * _e3168));
                                    let _e3390 = (((_e3369 * _e3169) + (_e3372 * _e3170)) + (_e3375 * _e3171));
                                    let _e3395 = (((_e3369 * _e3150[0]) + (_e3372 * _e3150[1])) + (_e3375 * _e3150[2]));
                                    let _e3400 = (((_e3369 * _e3174[0]) + (_e3372 * _e3174[1])) + (_e3375 * _e3174[2]));
                                    let _e3405 = (((_e3369 * _e3190) + (_e3372 * _e3191)) + (_e3375 * _e3192));
                                    let _e3410 = (((_e3369 * _e3193) + (_e3372 * _e3194)) + (_e3375 * _e3195));
                                    let _e3415 = (((_e3369 * _e3174[0]) + (_e3372 * _e3174[1])) + (_e3375 * _e3174[2]));
                                    if (_e3380 < _e3385) {
                                        phi_5817_ = _e3380;
                                    } else {
                                        phi_5817_ = _e3385;
                                    }
                                    let _e3418 = phi_5817_;
                                    if (_e3390 < _e3395) {
                                        phi_5822_ = _e3390;
                                    } else {
                                        phi_5822_ = _e3395;
                                    }
                                    let _e3421 = phi_5822_;
                                    if (_e3418 < _e3421) {
                                        phi_5827_ = _e3418;
                                    } else {
                                        phi_5827_ = _e3421;
                                    }
                                    let _e3424 = phi_5827_;
                                    if (_e3400 < _e3405) {
                                        phi_5832_ = _e3400;
                                    } else {
                                        phi_5832_ = _e3405;
                                    }
                                    let _e3427 = phi_5832_;
                                    if (_e3410 < _e3415) {
                                        phi_5837_ = _e3410;
                                    } else {
                                        phi_5837_ = _e3415;
                                    }
                                    let _e3430 = phi_5837_;
                                    if (_e3427 < _e3430) {
                                        phi_5842_ = _e3427;
                                    } else {
                                        phi_5842_ = _e3430;
                                    }
                                    let _e3433 = phi_5842_;
                                    if (_e3424 < _e3433) {
                                        phi_5847_ = _e3424;
                                    } else {
                                        phi_5847_ = _e3433;
                                    }
                                    let _e3436 = phi_5847_;
                                    if (_e3380 > _e3385) {
                                        phi_5852_ = _e3380;
                                    } else {
                                        phi_5852_ = _e3385;
                                    }
                                    let _e3439 = phi_5852_;
                                    if (_e3390 > _e3395) {
                                        phi_5857_ = _e3390;
                                    } else {
                                        phi_5857_ = _e3395;
                                    }
                                    let _e3442 = phi_5857_;
                                    if (_e3439 > _e3442) {
                                        phi_5862_ = _e3439;
                                    } else {
                                        phi_5862_ = _e3442;
                                    }
                                    let _e3445 = phi_5862_;
                                    if (_e3400 > _e3405) {
                                        phi_5867_ = _e3400;
                                    } else {
                                        phi_5867_ = _e3405;
                                    }
                                    let _e3448 = phi_5867_;
                                    if (_e3410 > _e3415) {
                                        phi_5872_ = _e3410;
                                    } else {
                                        phi_5872_ = _e3415;
                                    }
                                    let _e3451 = phi_5872_;
                                    if (_e3448 > _e3451) {
                                        phi_5877_ = _e3448;
                                    } else {
                                        phi_5877_ = _e3451;
                                    }
                                    let _e3454 = phi_5877_;
                                    if (_e3445 > _e3454) {
                                        phi_5882_ = _e3445;
                                    } else {
                                        phi_5882_ = _e3454;
                                    }
                                    let _e3457 = phi_5882_;
                                    if (_e3369 < 0f) {
                                        phi_5888_ = -(_e3369);
                                    } else {
                                        phi_5888_ = _e3369;
                                    }
                                    let _e3461 = phi_5888_;
                                    if (_e3372 < 0f) {
                                        phi_5894_ = -(_e3372);
                                    } else {
                                        phi_5894_ = _e3372;
                                    }
                                    let _e3465 = phi_5894_;
                                    if (_e3375 < 0f) {
                                        phi_5901_ = -(_e3375);
                                    } else {
                                        phi_5901_ = _e3375;
                                    }
                                    let _e3470 = phi_5901_;
                                    let _e3471 = ((_e3461 + _e3465) + _e3470);
                                    let _e3475 = -(_e3457);
                                    if (_e3436 > _e3475) {
                                        phi_5911_ = _e3436;
                                    } else {
                                        phi_5911_ = _e3475;
                                    }
                                    let _e3478 = phi_5911_;
                                    let _e3483 = (((_e3478 - ((_e3471 * _e3359) * (0.000000059604645f * 17f))) - (_e3471 * _e3366)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3486 = ((_e3144 * _e3138) - (_e3147 * _e3137));
                                    let _e3489 = ((_e3147 * _e3136) - (_e3141 * _e3138));
                                    let _e3492 = ((_e3141 * _e3137) - (_e3144 * _e3136));
                                    let _e3497 = (((_e3486 * _e3150[0]) + (_e3489 * _e3150[1])) + (_e3492 * _e3150[2]));
                                    let _e3502 = (((_e3486 * _e3166) + (_e3489 * _e3167)) + (_e3492 * _e3168));
                                    let _e3507 = (((_e3486 * _e3169) + (_e3489 * _e3170)) + (_e3492 * _e3171));
                                    let _e3512 = (((_e3486 * _e3150[0]) + (_e3489 * _e3150[1])) + (_e3492 * _e3150[2]));
                                    let _e3517 = (((_e3486 * _e3174[0]) + (_e3489 * _e3174[1])) + (_e3492 * _e3174[2]));
                                    let _e3522 = (((_e3486 * _e3190) + (_e3489 * _e3191)) + (_e3492 * _e3192));
                                    let _e3527 = (((_e3486 * _e3193) + (_e3489 * _e3194)) + (_e3492 * _e3195));
                                    let _e3532 = (((_e3486 * _e3174[0]) + (_e3489 * _e3174[1])) + (_e3492 * _e3174[2]));
                                    if (_e3497 < _e3502) {
                                        phi_5982_ = _e3497;
                                    } else {
                                        phi_5982_ = _e3502;
                                    }
                                    let _e3535 = phi_5982_;
                                    if (_e3507 < _e3512) {
                                        phi_5987_ = _e3507;
                                    } else {
                                        phi_5987_ = _e3512;
                                    }
                                    let _e3538 = phi_5987_;
                                    if (_e3535 < _e3538) {
                                        phi_5992_ = _e3535;
                                    } else {
                                        phi_5992_ = _e3538;
                                    }
                                    let _e3541 = phi_5992_;
                                    if (_e3517 < _e3522) {
                                        phi_5997_ = _e3517;
                                    } else {
                                        phi_5997_ = _e3522;
                                    }
                                    let _e3544 = phi_5997_;
                                    if (_e3527 < _e3532) {
                                        phi_6002_ = _e3527;
                                    } else {
                                        phi_6002_ = _e3532;
                                    }
                                    let _e3547 = phi_6002_;
                                    if (_e3544 < _e3547) {
                                        phi_6007_ = _e3544;
                                    } else {
                                        phi_6007_ = _e3547;
                                    }
                                    let _e3550 = phi_6007_;
                                    if (_e3541 < _e3550) {
                                        phi_6012_ = _e3541;
                                    } else {
                                        phi_6012_ = _e3550;
                                    }
                                    let _e3553 = phi_6012_;
                                    if (_e3497 > _e3502) {
                                        phi_6017_ = _e3497;
                                    } else {
                                        phi_6017_ = _e3502;
                                    }
                                    let _e3556 = phi_6017_;
                                    if (_e3507 > _e3512) {
                                        phi_6022_ = _e3507;
                                    } else {
                                        phi_6022_ = _e3512;
                                    }
                                    let _e3559 = phi_6022_;
                                    if (_e3556 > _e3559) {
                                        phi_6027_ = _e3556;
                                    } else {
                                        phi_6027_ = _e3559;
                                    }
                                    let _e3562 = phi_6027_;
                                    if (_e3517 > _e3522) {
                                        phi_6032_ = _e3517;
                                    } else {
                                        phi_6032_ = _e3522;
                                    }
                                    let _e3565 = phi_6032_;
                                    if (_e3527 > _e3532) {
                                        phi_6037_ = _e3527;
                                    } else {
                                        phi_6037_ = _e3532;
                                    }
                                    let _e3568 = phi_6037_;
                                    if (_e3565 > _e3568) {
                                        phi_6042_ = _e3565;
                                    } else {
                                        phi_6042_ = _e3568;
                                    }
                                    let _e3571 = phi_6042_;
                                    if (_e3562 > _e3571) {
                                        phi_6047_ = _e3562;
                                    } else {
                                        phi_6047_ = _e3571;
                                    }
                                    let _e3574 = phi_6047_;
                                    if (_e3486 < 0f) {
                                        phi_6053_ = -(_e3486);
                                    } else {
                                        phi_6053_ = _e3486;
                                    }
                                    let _e3578 = phi_6053_;
                                    if (_e3489 < 0f) {
                                        phi_6059_ = -(_e3489);
                                    } else {
                                        phi_6059_ = _e3489;
                                    }
                                    let _e3582 = phi_6059_;
                                    if (_e3492 < 0f) {
                                        phi_6066_ = -(_e3492);
                                    } else {
                                        phi_6066_ = _e3492;
                                    }
                                    let _e3587 = phi_6066_;
                                    let _e3588 = ((_e3578 + _e3582) + _e3587);
                                    let _e3592 = -(_e3574);
                                    if (_e3553 > _e3592) {
                                        phi_6076_ = _e3553;
                                    } else {
                                        phi_6076_ = _e3592;
                                    }
                                    let _e3595 = phi_6076_;
                                    let _e3600 = (((_e3595 - ((_e3588 * _e3359) * (0.000000059604645f * 17f))) - (_e3588 * _e3366)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3483 > _e3600) {
                                        phi_6086_ = _e3483;
                                    } else {
                                        phi_6086_ = _e3600;
                                    }
                                    let _e3603 = phi_6086_;
                                    let _e3604 = (_e3136 - _e3121);
                                    let _e3605 = (_e3137 - _e3122);
                                    let _e3606 = (_e3138 - _e3123);
                                    let _e3609 = ((_e3144 * _e3606) - (_e3147 * _e3605));
                                    let _e3612 = ((_e3147 * _e3604) - (_e3141 * _e3606));
                                    let _e3615 = ((_e3141 * _e3605) - (_e3144 * _e3604));
                                    let _e3620 = (((_e3609 * _e3150[0]) + (_e3612 * _e3150[1])) + (_e3615 * _e3150[2]));
                                    let _e3625 = (((_e3609 * _e3166) + (_e3612 * _e3167)) + (_e3615 * _e3168));
                                    let _e3630 = (((_e3609 * _e3169) + (_e3612 * _e3170)) + (_e3615 * _e3171));
                                    let _e3635 = (((_e3609 * _e3150[0]) + (_e3612 * _e3150[1])) + (_e3615 * _e3150[2]));
                                    let _e3640 = (((_e3609 * _e3174[0]) + (_e3612 * _e3174[1])) + (_e3615 * _e3174[2]));
                                    let _e3645 = (((_e3609 * _e3190) + (_e3612 * _e3191)) + (_e3615 * _e3192));
                                    let _e3650 = (((_e3609 * _e3193) + (_e3612 * _e3194)) + (_e3615 * _e3195));
                                    let _e3655 = (((_e3609 * _e3174[0]) + (_e3612 * _e3174[1])) + (_e3615 * _e3174[2]));
                                    if (_e3620 < _e3625) {
                                        phi_6159_ = _e3620;
                                    } else {
                                        phi_6159_ = _e3625;
                                    }
                                    let _e3658 = phi_6159_;
                                    if (_e3630 < _e3635) {
                                        phi_6164_ = _e3630;
                                    } else {
                                        phi_6164_ = _e3635;
                                    }
                                    let _e3661 = phi_6164_;
                                    if (_e3658 < _e3661) {
                                        phi_6169_ = _e3658;
                                    } else {
                                        phi_6169_ = _e3661;
                                    }
                                    let _e3664 = phi_6169_;
                                    if (_e3640 < _e3645) {
                                        phi_6174_ = _e3640;
                                    } else {
                                        phi_6174_ = _e3645;
                                    }
                                    let _e3667 = phi_6174_;
                                    if (_e3650 < _e3655) {
                                        phi_6179_ = _e3650;
                                    } else {
                                        phi_6179_ = _e3655;
                                    }
                                    let _e3670 = phi_6179_;
                                    if (_e3667 < _e3670) {
                                        phi_6184_ = _e3667;
                                    } else {
                                        phi_6184_ = _e3670;
                                    }
                                    let _e3673 = phi_6184_;
                                    if (_e3664 < _e3673) {
                                        phi_6189_ = _e3664;
                                    } else {
                                        phi_6189_ = _e3673;
                                    }
                                    let _e3676 = phi_6189_;
                                    if (_e3620 > _e3625) {
                                        phi_6194_ = _e3620;
                                    } else {
                                        phi_6194_ = _e3625;
                                    }
                                    let _e3679 = phi_6194_;
                                    if (_e3630 > _e3635) {
                                        phi_6199_ = _e3630;
                                    } else {
                                        phi_6199_ = _e3635;
                                    }
                                    let _e3682 = phi_6199_;
                                    if (_e3679 > _e3682) {
                                        phi_6204_ = _e3679;
                                    } else {
                                        phi_6204_ = _e3682;
                                    }
                                    let _e3685 = phi_6204_;
                                    if (_e3640 > _e3645) {
                                        phi_6209_ = _e3640;
                                    } else {
                                        phi_6209_ = _e3645;
                                    }
                                    let _e3688 = phi_6209_;
                                    if (_e3650 > _e3655) {
                                        phi_6214_ = _e3650;
                                    } else {
                                        phi_6214_ = _e3655;
                                    }
                                    let _e3691 = phi_6214_;
                                    if (_e3688 > _e3691) {
                                        phi_6219_ = _e3688;
                                    } else {
                                        phi_6219_ = _e3691;
                                    }
                                    let _e3694 = phi_6219_;
                                    if (_e3685 > _e3694) {
                                        phi_6224_ = _e3685;
                                    } else {
                                        phi_6224_ = _e3694;
                                    }
                                    let _e3697 = phi_6224_;
                                    if (_e3609 < 0f) {
                                        phi_6230_ = -(_e3609);
                                    } else {
                                        phi_6230_ = _e3609;
                                    }
                                    let _e3701 = phi_6230_;
                                    if (_e3612 < 0f) {
                                        phi_6236_ = -(_e3612);
                                    } else {
                                        phi_6236_ = _e3612;
                                    }
                                    let _e3705 = phi_6236_;
                                    if (_e3615 < 0f) {
                                        phi_6243_ = -(_e3615);
                                    } else {
                                        phi_6243_ = _e3615;
                                    }
                                    let _e3710 = phi_6243_;
                                    let _e3711 = ((_e3701 + _e3705) + _e3710);
                                    let _e3715 = -(_e3697);
                                    if (_e3676 > _e3715) {
                                        phi_6253_ = _e3676;
                                    } else {
                                        phi_6253_ = _e3715;
                                    }
                                    let _e3718 = phi_6253_;
                                    let _e3723 = (((_e3718 - ((_e3711 * _e3359) * (0.000000059604645f * 17f))) - (_e3711 * _e3366)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3603 > _e3723) {
                                        phi_6263_ = _e3603;
                                    } else {
                                        phi_6263_ = _e3723;
                                    }
                                    let _e3726 = phi_6263_;
                                    phi_6266_ = (_e3726 > 0f);
                                }
                                let _e3729 = phi_6266_;
                                if _e3729 {
                                    let _e3732 = local_1.member_1[0u];
                                    let _e3738 = local_1.member_2[0u];
                                    let _e3744 = ((_e3732[1] * _e3738[2]) - (_e3732[2] * _e3738[1]));
                                    let _e3747 = ((_e3732[2] * _e3738[0]) - (_e3732[0] * _e3738[2]));
                                    let _e3750 = ((_e3732[0] * _e3738[1]) - (_e3732[1] * _e3738[0]));
                                    let _e3753 = local_1.member_1[1u];
                                    let _e3759 = local_1.member_2[1u];
                                    let _e3765 = ((_e3753[1] * _e3759[2]) - (_e3753[2] * _e3759[1]));
                                    let _e3768 = ((_e3753[2] * _e3759[0]) - (_e3753[0] * _e3759[2]));
                                    let _e3771 = ((_e3753[0] * _e3759[1]) - (_e3753[1] * _e3759[0]));
                                    let _e3774 = local_1.member_1[0u];
                                    let _e3780 = local_1.member_2[1u];
                                    let _e3795 = local_1.member_1[1u];
                                    let _e3801 = local_1.member_2[0u];
                                    let _e3814 = (((_e3774[1] * _e3780[2]) - (_e3774[2] * _e3780[1])) + ((_e3795[1] * _e3801[2]) - (_e3795[2] * _e3801[1])));
                                    let _e3815 = (((_e3774[2] * _e3780[0]) - (_e3774[0] * _e3780[2])) + ((_e3795[2] * _e3801[0]) - (_e3795[0] * _e3801[2])));
                                    let _e3816 = (((_e3774[0] * _e3780[1]) - (_e3774[1] * _e3780[0])) + ((_e3795[0] * _e3801[1]) - (_e3795[1] * _e3801[0])));
                                    let _e3819 = local_1.member[0u];
                                    let _e3830 = local_1.member[1u];
                                    let _e3841 = local_1.member[0u];
                                    let _e3850 = ((((_e3830[0] * _e3744) + (_e3830[1] * _e3747)) + (_e3830[2] * _e3750)) + (((_e3841[0] * _e3814) + (_e3841[1] * _e3815)) + (_e3841[2] * _e3816)));
                                    let _e3853 = local_1.member[0u];
                                    let _e3864 = local_1.member[1u];
                                    let _e3873 = ((((_e3853[0] * _e3765) + (_e3853[1] * _e3768)) + (_e3853[2] * _e3771)) + (((_e3864[0] * _e3814) + (_e3864[1] * _e3815)) + (_e3864[2] * _e3816)));
                                    let _e3876 = local_1.member[1u];
                                    let _e3887 = local_1.member[0u];
                                    if (_e3887[0] < 0f) {
                                        phi_6511_ = -(_e3887[0]);
                                    } else {
                                        phi_6511_ = _e3887[0];
                                    }
                                    let _e3894 = phi_6511_;
                                    if (_e3887[1] < 0f) {
                                        phi_6518_ = -(_e3887[1]);
                                    } else {
                                        phi_6518_ = _e3887[1];
                                    }
                                    let _e3898 = phi_6518_;
                                    if (_e3894 > _e3898) {
                                        phi_6523_ = _e3894;
                                    } else {
                                        phi_6523_ = _e3898;
                                    }
                                    let _e3901 = phi_6523_;
                                    if (_e3887[2] < 0f) {
                                        phi_6530_ = -(_e3887[2]);
                                    } else {
                                        phi_6530_ = _e3887[2];
                                    }
                                    let _e3905 = phi_6530_;
                                    if (_e3901 > _e3905) {
                                        phi_6535_ = _e3901;
                                    } else {
                                        phi_6535_ = _e3905;
                                    }
                                    let _e3908 = phi_6535_;
                                    let _e3911 = local_1.member[1u];
                                    if (_e3911[0] < 0f) {
                                        phi_6548_ = -(_e3911[0]);
                                    } else {
                                        phi_6548_ = _e3911[0];
                                    }
                                    let _e3918 = phi_6548_;
                                    if (_e3911[1] < 0f) {
                                        phi_6555_ = -(_e3911[1]);
                                    } else {
                                        phi_6555_ = _e3911[1];
                                    }
                                    let _e3922 = phi_6555_;
                                    if (_e3918 > _e3922) {
                                        phi_6560_ = _e3918;
                                    } else {
                                        phi_6560_ = _e3922;
                                    }
                                    let _e3925 = phi_6560_;
                                    if (_e3911[2] < 0f) {
                                        phi_6567_ = -(_e3911[2]);
                                    } else {
                                        phi_6567_ = _e3911[2];
                                    }
                                    let _e3929 = phi_6567_;
                                    if (_e3925 > _e3929) {
                                        phi_6572_ = _e3925;
                                    } else {
                                        phi_6572_ = _e3929;
                                    }
                                    let _e3932 = phi_6572_;
                                    if (_e3908 > _e3932) {
                                        phi_6577_ = _e3908;
                                    } else {
                                        phi_6577_ = _e3932;
                                    }
                                    let _e3935 = phi_6577_;
                                    let _e3937 = local_1.member_3;
                                    let _e3938 = (_e3935 + _e3937);
                                    let _e3941 = local_1.member_1[0u];
                                    if (_e3941[0] < 0f) {
                                        phi_6594_ = -(_e3941[0]);
                                    } else {
                                        phi_6594_ = _e3941[0];
                                    }
                                    let _e3948 = phi_6594_;
                                    if (_e3941[1] < 0f) {
                                        phi_6601_ = -(_e3941[1]);
                                    } else {
                                        phi_6601_ = _e3941[1];
                                    }
                                    let _e3952 = phi_6601_;
                                    if (_e3948 > _e3952) {
                                        phi_6606_ = _e3948;
                                    } else {
                                        phi_6606_ = _e3952;
                                    }
                                    let _e3955 = phi_6606_;
                                    if (_e3941[2] < 0f) {
                                        phi_6613_ = -(_e3941[2]);
                                    } else {
                                        phi_6613_ = _e3941[2];
                                    }
                                    let _e3959 = phi_6613_;
                                    if (_e3955 > _e3959) {
                                        phi_6618_ = _e3955;
                                    } else {
                                        phi_6618_ = _e3959;
                                    }
                                    let _e3962 = phi_6618_;
                                    let _e3965 = local_1.member_1[1u];
                                    if (_e3965[0] < 0f) {
                                        phi_6632_ = -(_e3965[0]);
                                    } else {
                                        phi_6632_ = _e3965[0];
                                    }
                                    let _e3972 = phi_6632_;
                                    if (_e3965[1] < 0f) {
                                        phi_6639_ = -(_e3965[1]);
                                    } else {
                                        phi_6639_ = _e3965[1];
                                    }
                                    let _e3976 = phi_6639_;
                                    if (_e3972 > _e3976) {
                                        phi_6644_ = _e3972;
                                    } else {
                                        phi_6644_ = _e3976;
                                    }
                                    let _e3979 = phi_6644_;
                                    if (_e3965[2] < 0f) {
                                        phi_6651_ = -(_e3965[2]);
                                    } else {
                                        phi_6651_ = _e3965[2];
                                    }
                                    let _e3983 = phi_6651_;
                                    if (_e3979 > _e3983) {
                                        phi_6656_ = _e3979;
                                    } else {
                                        phi_6656_ = _e3983;
                                    }
                                    let _e3986 = phi_6656_;
                                    if (_e3962 > _e3986) {
                                        phi_6661_ = _e3962;
                                    } else {
                                        phi_6661_ = _e3986;
                                    }
                                    let _e3989 = phi_6661_;
                                    let _e3991 = local_1.member_3;
                                    let _e3992 = (_e3989 + _e3991);
                                    let _e3995 = local_1.member_2[0u];
                                    if (_e3995[0] < 0f) {
                                        phi_6678_ = -(_e3995[0]);
                                    } else {
                                        phi_6678_ = _e3995[0];
                                    }
                                    let _e4002 = phi_6678_;
                                    if (_e3995[1] < 0f) {
                                        phi_6685_ = -(_e3995[1]);
                                    } else {
                                        phi_6685_ = _e3995[1];
                                    }
                                    let _e4006 = phi_6685_;
                                    if (_e4002 > _e4006) {
                                        phi_6690_ = _e4002;
                                    } else {
                                        phi_6690_ = _e4006;
                                    }
                                    let _e4009 = phi_6690_;
                                    if (_e3995[2] < 0f) {
                                        phi_6697_ = -(_e3995[2]);
                                    } else {
                                        phi_6697_ = _e3995[2];
                                    }
                                    let _e4013 = phi_6697_;
                                    if (_e4009 > _e4013) {
                                        phi_6702_ = _e4009;
                                    } else {
                                        phi_6702_ = _e4013;
                                    }
                                    let _e4016 = phi_6702_;
                                    let _e4019 = local_1.member_2[1u];
                                    if (_e4019[0] < 0f) {
                                        phi_6716_ = -(_e4019[0]);
                                    } else {
                                        phi_6716_ = _e4019[0];
                                    }
                                    let _e4026 = phi_6716_;
                                    if (_e4019[1] < 0f) {
                                        phi_6723_ = -(_e4019[1]);
                                    } else {
                                        phi_6723_ = _e4019[1];
                                    }
                                    let _e4030 = phi_6723_;
                                    if (_e4026 > _e4030) {
                                        phi_6728_ = _e4026;
                                    } else {
                                        phi_6728_ = _e4030;
                                    }
                                    let _e4033 = phi_6728_;
                                    if (_e4019[2] < 0f) {
                                        phi_6735_ = -(_e4019[2]);
                                    } else {
                                        phi_6735_ = _e4019[2];
                                    }
                                    let _e4037 = phi_6735_;
                                    if (_e4033 > _e4037) {
                                        phi_6740_ = _e4033;
                                    } else {
                                        phi_6740_ = _e4037;
                                    }
                                    let _e4040 = phi_6740_;
                                    if (_e4016 > _e4040) {
                                        phi_6745_ = _e4016;
                                    } else {
                                        phi_6745_ = _e4040;
                                    }
                                    let _e4043 = phi_6745_;
                                    let _e4045 = local_1.member_3;
                                    let _e4046 = (_e4043 + _e4045);
                                    let _e4048 = ((_e3992 * 8f) * _e4046);
                                    let _e4055 = local_1.member_3;
                                    if (_e3744 < 0f) {
                                        phi_6776_ = -(_e3744);
                                    } else {
                                        phi_6776_ = _e3744;
                                    }
                                    let _e4072 = phi_6776_;
                                    if (_e3747 < 0f) {
                                        phi_6782_ = -(_e3747);
                                    } else {
                                        phi_6782_ = _e3747;
                                    }
                                    let _e4076 = phi_6782_;
                                    if (_e3750 < 0f) {
                                        phi_6789_ = -(_e3750);
                                    } else {
                                        phi_6789_ = _e3750;
                                    }
                                    let _e4081 = phi_6789_;
                                    let _e4082 = ((_e4072 + _e4076) + _e4081);
                                    if (_e3765 < 0f) {
                                        phi_6796_ = -(_e3765);
                                    } else {
                                        phi_6796_ = _e3765;
                                    }
                                    let _e4086 = phi_6796_;
                                    if (_e3768 < 0f) {
                                        phi_6802_ = -(_e3768);
                                    } else {
                                        phi_6802_ = _e3768;
                                    }
                                    let _e4090 = phi_6802_;
                                    if (_e3771 < 0f) {
                                        phi_6809_ = -(_e3771);
                                    } else {
                                        phi_6809_ = _e3771;
                                    }
                                    let _e4095 = phi_6809_;
                                    let _e4096 = ((_e4086 + _e4090) + _e4095);
                                    if (_e4082 > _e4096) {
                                        phi_6815_ = _e4082;
                                    } else {
                                        phi_6815_ = _e4096;
                                    }
                                    let _e4099 = phi_6815_;
                                    if (_e3814 < 0f) {
                                        phi_6821_ = -(_e3814);
                                    } else {
                                        phi_6821_ = _e3814;
                                    }
                                    let _e4103 = phi_6821_;
                                    if (_e3815 < 0f) {
                                        phi_6827_ = -(_e3815);
                                    } else {
                                        phi_6827_ = _e3815;
                                    }
                                    let _e4107 = phi_6827_;
                                    if (_e3816 < 0f) {
                                        phi_6834_ = -(_e3816);
                                    } else {
                                        phi_6834_ = _e3816;
                                    }
                                    let _e4112 = phi_6834_;
                                    let _e4114 = (((_e4103 + _e4107) + _e4112) * 0.5f);
                                    if (_e4099 > _e4114) {
                                        phi_6841_ = _e4099;
                                    } else {
                                        phi_6841_ = _e4114;
                                    }
                                    let _e4117 = phi_6841_;
                                    let _e4122 = local_1.member_3;
                                    let _e4135 = ((((_e3819[0] * _e3744) + (_e3819[1] * _e3747)) + (_e3819[2] * _e3750)) * 3f);
                                    let _e4136 = ((((_e3876[0] * _e3765) + (_e3876[1] * _e3768)) + (_e3876[2] * _e3771)) * 3f);
                                    if (_e4135 < _e4136) {
                                        phi_6865_ = _e4135;
                                    } else {
                                        phi_6865_ = _e4136;
                                    }
                                    let _e4139 = phi_6865_;
                                    if (_e3850 < _e3873) {
                                        phi_6870_ = _e3850;
                                    } else {
                                        phi_6870_ = _e3873;
                                    }
                                    let _e4142 = phi_6870_;
                                    if (_e4139 < _e4142) {
                                        phi_6875_ = _e4139;
                                    } else {
                                        phi_6875_ = _e4142;
                                    }
                                    let _e4145 = phi_6875_;
                                    if (_e4135 > _e4136) {
                                        phi_6880_ = _e4135;
                                    } else {
                                        phi_6880_ = _e4136;
                                    }
                                    let _e4148 = phi_6880_;
                                    if (_e3850 > _e3873) {
                                        phi_6885_ = _e3850;
                                    } else {
                                        phi_6885_ = _e3873;
                                    }
                                    let _e4151 = phi_6885_;
                                    if (_e4148 > _e4151) {
                                        phi_6890_ = _e4148;
                                    } else {
                                        phi_6890_ = _e4151;
                                    }
                                    let _e4154 = phi_6890_;
                                    let _e4159 = -(_e4154);
                                    if (_e4145 > _e4159) {
                                        phi_6900_ = _e4145;
                                    } else {
                                        phi_6900_ = _e4159;
                                    }
                                    let _e4162 = phi_6900_;
                                    if ((_e4162 - ((((((_e3938 * 8f) * _e4048) * (0.000000059604645f * (490f / 64f))) + ((_e4055 * 19f) * ((_e3938 * (_e3992 + _e4046)) + (_e3992 * _e4046)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3938) * ((1f + _e3992) * (1f + _e4046))))) + ((_e1450 * (((_e4117 + (_e4048 * (0.000000059604645f * 4f))) + ((_e4122 * 6f) * (_e3992 + _e4046))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3992) * (1f + _e4046))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_7864_ = true;
                                    } else {
                                        let _e4167 = local_1.member_1[0u];
                                        let _e4173 = local_1.member_1[1u];
                                        let _e4177 = (_e4167[0] + _e4173[0]);
                                        let _e4178 = (_e4167[1] + _e4173[1]);
                                        let _e4179 = (_e4167[2] + _e4173[2]);
                                        let _e4182 = local_1.member_2[0u];
                                        let _e4188 = local_1.member_2[1u];
                                        let _e4192 = (_e4182[0] + _e4188[0]);
                                        let _e4193 = (_e4182[1] + _e4188[1]);
                                        let _e4194 = (_e4182[2] + _e4188[2]);
                                        let _e4197 = ((_e4178 * _e4194) - (_e4179 * _e4193));
                                        let _e4200 = ((_e4179 * _e4192) - (_e4177 * _e4194));
                                        let _e4203 = ((_e4177 * _e4193) - (_e4178 * _e4192));
                                        let _e4206 = local_1.member[0u];
                                        let _e4212 = local_1.member_1[0u];
                                        let _e4218 = local_1.member_2[0u];
                                        let _e4222 = (_e4206[0] - _e4212[0]);
                                        let _e4223 = (_e4206[1] - _e4212[1]);
                                        let _e4224 = (_e4206[2] - _e4212[2]);
                                        let _e4225 = (_e4206[0] - _e4218[0]);
                                        let _e4226 = (_e4206[1] - _e4218[1]);
                                        let _e4227 = (_e4206[2] - _e4218[2]);
                                        let _e4230 = local_1.member[1u];
                                        let _e4236 = local_1.member_1[1u];
                                        let _e4242 = local_1.member_2[1u];
                                        let _e4246 = (_e4230[0] - _e4236[0]);
                                        let _e4247 = (_e4230[1] - _e4236[1]);
                                        let _e4248 = (_e4230[2] - _e4236[2]);
                                        let _e4249 = (_e4230[0] - _e4242[0]);
                                        let _e4250 = (_e4230[1] - _e4242[1]);
                                        let _e4251 = (_e4230[2] - _e4242[2]);
                                        let _e4254 = local_1.member[0u];
                                        if (_e4254[0] < 0f) {
                                            phi_7103_ = -(_e4254[0]);
                                        } else {
                                            phi_7103_ = _e4254[0];
                                        }
                                        let _e4261 = phi_7103_;
                                        if (_e4254[1] < 0f) {
                                            phi_7110_ = -(_e4254[1]);
                                        } else {
                                            phi_7110_ = _e4254[1];
                                        }
                                        let _e4265 = phi_7110_;
                                        if (_e4261 > _e4265) {
                                            phi_7115_ = _e4261;
                                        } else {
                                            phi_7115_ = _e4265;
                                        }
                                        let _e4268 = phi_7115_;
                                        if (_e4254[2] < 0f) {
                                            phi_7122_ = -(_e4254[2]);
                                        } else {
                                            phi_7122_ = _e4254[2];
                                        }
                                        let _e4272 = phi_7122_;
                                        if (_e4268 > _e4272) {
                                            phi_7127_ = _e4268;
                                        } else {
                                            phi_7127_ = _e4272;
                                        }
                                        let _e4275 = phi_7127_;
                                        let _e4278 = local_1.member[1u];
                                        if (_e4278[0] < 0f) {
                                            phi_7140_ = -(_e4278[0]);
                                        } else {
                                            phi_7140_ = _e4278[0];
                                        }
                                        let _e4285 = phi_7140_;
                                        if (_e4278[1] < 0f) {
                                            phi_7147_ = -(_e4278[1]);
                                        } else {
                                            phi_7147_ = _e4278[1];
                                        }
                                        let _e4289 = phi_7147_;
                                        if (_e4285 > _e4289) {
                                            phi_7152_ = _e4285;
                                        } else {
                                            phi_7152_ = _e4289;
                                        }
                                        let _e4292 = phi_7152_;
                                        if (_e4278[2] < 0f) {
                                            phi_7159_ = -(_e4278[2]);
                                        } else {
                                            phi_7159_ = _e4278[2];
                                        }
                                        let _e4296 = phi_7159_;
                                        if (_e4292 > _e4296) {
                                            phi_7164_ = _e4292;
                                        } else {
                                            phi_7164_ = _e4296;
                                        }
                                        let _e4299 = phi_7164_;
                                        if (_e4275 > _e4299) {
                                            phi_7169_ = _e4275;
                                        } else {
                                            phi_7169_ = _e4299;
                                        }
                                        let _e4302 = phi_7169_;
                                        let _e4304 = local_1.member_3;
                                        let _e4308 = local_1.member_1[0u];
                                        if (_e4308[0] < 0f) {
                                            phi_7186_ = -(_e4308[0]);
                                        } else {
                                            phi_7186_ = _e4308[0];
                                        }
                                        let _e4315 = phi_7186_;
                                        if (_e4308[1] < 0f) {
                                            phi_7193_ = -(_e4308[1]);
                                        } else {
                                            phi_7193_ = _e4308[1];
                                        }
                                        let _e4319 = phi_7193_;
                                        if (_e4315 > _e4319) {
                                            phi_7198_ = _e4315;
                                        } else {
                                            phi_7198_ = _e4319;
                                        }
                                        let _e4322 = phi_7198_;
                                        if (_e4308[2] < 0f) {
                                            phi_7205_ = -(_e4308[2]);
                                        } else {
                                            phi_7205_ = _e4308[2];
                                        }
                                        let _e4326 = phi_7205_;
                                        if (_e4322 > _e4326) {
                                            phi_7210_ = _e4322;
                                        } else {
                                            phi_7210_ = _e4326;
                                        }
                                        let _e4329 = phi_7210_;
                                        let _e4332 = local_1.member_1[1u];
                                        if (_e4332[0] < 0f) {
                                            phi_7224_ = -(_e4332[0]);
                                        } else {
                                            phi_7224_ = _e4332[0];
                                        }
                                        let _e4339 = phi_7224_;
                                        if (_e4332[1] < 0f) {
                                            phi_7231_ = -(_e4332[1]);
                                        } else {
                                            phi_7231_ = _e4332[1];
                                        }
                                        let _e4343 = phi_7231_;
                                        if (_e4339 > _e4343) {
                                            phi_7236_ = _e4339;
                                        } else {
                                            phi_7236_ = _e4343;
                                        }
                                        let _e4346 = phi_7236_;
                                        if (_e4332[2] < 0f) {
                                            phi_7243_ = -(_e4332[2]);
                                        } else {
                                            phi_7243_ = _e4332[2];
                                        }
                                        let _e4350 = phi_7243_;
                                        if (_e4346 > _e4350) {
                                            phi_7248_ = _e4346;
                                        } else {
                                            phi_7248_ = _e4350;
                                        }
                                        let _e4353 = phi_7248_;
                                        if (_e4329 > _e4353) {
                                            phi_7253_ = _e4329;
                                        } else {
                                            phi_7253_ = _e4353;
                                        }
                                        let _e4356 = phi_7253_;
                                        let _e4358 = local_1.member_3;
                                        let _e4362 = local_1.member_2[0u];
                                        if (_e4362[0] < 0f) {
                                            phi_7270_ = -(_e4362[0]);
                                        } else {
                                            phi_7270_ = _e4362[0];
                                        }
                                        let _e4369 = phi_7270_;
                                        if (_e4362[1] < 0f) {
                                            phi_7277_ = -(_e4362[1]);
                                        } else {
                                            phi_7277_ = _e4362[1];
                                        }
                                        let _e4373 = phi_7277_;
                                        if (_e4369 > _e4373) {
                                            phi_7282_ = _e4369;
                                        } else {
                                            phi_7282_ = _e4373;
                                        }
                                        let _e4376 = phi_7282_;
                                        if (_e4362[2] < 0f) {
                                            phi_7289_ = -(_e4362[2]);
                                        } else {
                                            phi_7289_ = _e4362[2];
                                        }
                                        let _e4380 = phi_7289_;
                                        if (_e4376 > _e4380) {
                                            phi_7294_ = _e4376;
                                        } else {
                                            phi_7294_ = _e4380;
                                        }
                                        let _e4383 = phi_7294_;
                                        let _e4386 = local_1.member_2[1u];
                                        if (_e4386[0] < 0f) {
                                            phi_7308_ = -(_e4386[0]);
                                        } else {
                                            phi_7308_ = _e4386[0];
                                        }
                                        let _e4393 = phi_7308_;
                                        if (_e4386[1] < 0f) {
                                            phi_7315_ = -(_e4386[1]);
                                        } else {
                                            phi_7315_ = _e4386[1];
                                        }
                                        let _e4397 = phi_7315_;
                                        if (_e4393 > _e4397) {
                                            phi_7320_ = _e4393;
                                        } else {
                                            phi_7320_ = _e4397;
                                        }
                                        let _e4400 = phi_7320_;
                                        if (_e4386[2] < 0f) {
                                            phi_7327_ = -(_e4386[2]);
                                        } else {
                                            phi_7327_ = _e4386[2];
                                        }
                                        let _e4404 = phi_7327_;
                                        if (_e4400 > _e4404) {
                                            phi_7332_ = _e4400;
                                        } else {
                                            phi_7332_ = _e4404;
                                        }
                                        let _e4407 = phi_7332_;
                                        if (_e4383 > _e4407) {
                                            phi_7337_ = _e4383;
                                        } else {
                                            phi_7337_ = _e4407;
                                        }
                                        let _e4410 = phi_7337_;
                                        let _e4412 = local_1.member_3;
                                        let _e4415 = (((_e4302 + _e4304) + (_e4356 + _e4358)) + (_e4410 + _e4412));
                                        let _e4418 = local_1.member_3;
                                        let _e4422 = (((_e1450 * 1.0001f) + (_e4418 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4425 = ((_e4200 * _e4179) - (_e4203 * _e4178));
                                        let _e4428 = ((_e4203 * _e4177) - (_e4197 * _e4179));
                                        let _e4431 = ((_e4197 * _e4178) - (_e4200 * _e4177));
                                        let _e4436 = (((_e4425 * _e4206[0]) + (_e4428 * _e4206[1])) + (_e4431 * _e4206[2]));
                                        let _e4441 = (((_e4425 * _e4222) + (_e4428 * _e4223)) + (_e4431 * _e4224));
                                        let _e4446 = (((_e4425 * _e4225) + (_e4428 * _e4226)) + (_e4431 * _e4227));
                                        let _e4451 = (((_e4425 * _e4206[0]) + (_e4428 * _e4206[1])) + (_e4431 * _e4206[2]));
                                        let _e4456 = (((_e4425 * _e4230[0]) + (_e4428 * _e4230[1])) + (_e4431 * _e4230[2]));
                                        let _e4461 = (((_e4425 * _e4246) + (_e4428 * _e4247)) + (_e4431 * _e4248));
                                        let _e4466 = (((_e4425 * _e4249) + (_e4428 * _e4250)) + (_e4431 * _e4251));
                                        let _e4471 = (((_e4425 * _e4230[0]) + (_e4428 * _e4230[1])) + (_e4431 * _e4230[2]));
                                        if (_e4436 < _e4441) {
                                            phi_7415_ = _e4436;
                                        } else {
                                            phi_7415_ = _e4441;
                                        }
                                        let _e4474 = phi_7415_;
                                        if (_e4446 < _e4451) {
                                            phi_7420_ = _e4446;
                                        } else {
                                            phi_7420_ = _e4451;
                                        }
                                        let _e4477 = phi_7420_;
                                        if (_e4474 < _e4477) {
                                            phi_7425_ = _e4474;
                                        } else {
                                            phi_7425_ = _e4477;
                                        }
                                        let _e4480 = phi_7425_;
                                        if (_e4456 < _e4461) {
                                            phi_7430_ = _e4456;
                                        } else {
                                            phi_7430_ = _e4461;
                                        }
                                        let _e4483 = phi_7430_;
                                        if (_e4466 < _e4471) {
                                            phi_7435_ = _e4466;
                                        } else {
                                            phi_7435_ = _e4471;
                                        }
                                        let _e4486 = phi_7435_;
                                        if (_e4483 < _e4486) {
                                            phi_7440_ = _e4483;
                                        } else {
                                            phi_7440_ = _e4486;
                                        }
                                        let _e4489 = phi_7440_;
                                        if (_e4480 < _e4489) {
                                            phi_7445_ = _e4480;
                                        } else {
                                            phi_7445_ = _e4489;
                                        }
                                        let _e4492 = phi_7445_;
                                        if (_e4436 > _e4441) {
                                            phi_7450_ = _e4436;
                                        } else {
                                            phi_7450_ = _e4441;
                                        }
                                        let _e4495 = phi_7450_;
                                        if (_e4446 > _e4451) {
                                            phi_7455_ = _e4446;
                                        } else {
                                            phi_7455_ = _e4451;
                                        }
                                        let _e4498 = phi_7455_;
                                        if (_e4495 > _e4498) {
                                            phi_7460_ = _e4495;
                                        } else {
                                            phi_7460_ = _e4498;
                                        }
                                        let _e4501 = phi_7460_;
                                        if (_e4456 > _e4461) {
                                            phi_7465_ = _e4456;
                                        } else {
                                            phi_7465_ = _e4461;
                                        }
                                        let _e4504 = phi_7465_;
                                        if (_e4466 > _e4471) {
                                            phi_7470_ = _e4466;
                                        } else {
                                            phi_7470_ = _e4471;
                                        }
                                        let _e4507 = phi_7470_;
                                        if (_e4504 > _e4507) {
                                            phi_7475_ = _e4504;
                                        } else {
                                            phi_7475_ = _e4507;
                                        }
                                        let _e4510 = phi_7475_;
                                        if (_e4501 > _e4510) {
                                            phi_7480_ = _e4501;
                                        } else {
                                            phi_7480_ = _e4510;
                                        }
                                        let _e4513 = phi_7480_;
                                        if (_e4425 < 0f) {
                                            phi_7486_ = -(_e4425);
                                        } else {
                                            phi_7486_ = _e4425;
                                        }
                                        let _e4517 = phi_7486_;
                                        if (_e4428 < 0f) {
                                            phi_7492_ = -(_e4428);
                                        } else {
                                            phi_7492_ = _e4428;
                                        }
                                        let _e4521 = phi_7492_;
                                        if (_e4431 < 0f) {
                                            phi_7499_ = -(_e4431);
                                        } else {
                                            phi_7499_ = _e4431;
                                        }
                                        let _e4526 = phi_7499_;
                                        let _e4527 = ((_e4517 + _e4521) + _e4526);
                                        let _e4531 = -(_e4513);
                                        if (_e4492 > _e4531) {
                                            phi_7509_ = _e4492;
                                        } else {
                                            phi_7509_ = _e4531;
                                        }
                                        let _e4534 = phi_7509_;
                                        let _e4539 = (((_e4534 - ((_e4527 * _e4415) * (0.000000059604645f * 17f))) - (_e4527 * _e4422)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4542 = ((_e4200 * _e4194) - (_e4203 * _e4193));
                                        let _e4545 = ((_e4203 * _e4192) - (_e4197 * _e4194));
                                        let _e4548 = ((_e4197 * _e4193) - (_e4200 * _e4192));
                                        let _e4553 = (((_e4542 * _e4206[0]) + (_e4545 * _e4206[1])) + (_e4548 * _e4206[2]));
                                        let _e4558 = (((_e4542 * _e4222) + (_e4545 * _e4223)) + (_e4548 * _e4224));
                                        let _e4563 = (((_e4542 * _e4225) + (_e4545 * _e4226)) + (_e4548 * _e4227));
                                        let _e4568 = (((_e4542 * _e4206[0]) + (_e4545 * _e4206[1])) + (_e4548 * _e4206[2]));
                                        let _e4573 = (((_e4542 * _e4230[0]) + (_e4545 * _e4230[1])) + (_e4548 * _e4230[2]));
                                        let _e4578 = (((_e4542 * _e4246) + (_e4545 * _e4247)) + (_e4548 * _e4248));
                                        let _e4583 = (((_e4542 * _e4249) + (_e4545 * _e4250)) + (_e4548 * _e4251));
                                        let _e4588 = (((_e4542 * _e4230[0]) + (_e4545 * _e4230[1])) + (_e4548 * _e4230[2]));
                                        if (_e4553 < _e4558) {
                                            phi_7580_ = _e4553;
                                        } else {
                                            phi_7580_ = _e4558;
                                        }
                                        let _e4591 = phi_7580_;
                                        if (_e4563 < _e4568) {
                                            phi_7585_ = _e4563;
                                        } else {
                                            phi_7585_ = _e4568;
                                        }
                                        let _e4594 = phi_7585_;
                                        if (_e4591 < _e4594) {
                                            phi_7590_ = _e4591;
                                        } else {
                                            phi_7590_ = _e4594;
                                        }
                                        let _e4597 = phi_7590_;
                                        if (_e4573 < _e4578) {
                                            phi_7595_ = _e4573;
                                        } else {
                                            phi_7595_ = _e4578;
                                        }
                                        let _e4600 = phi_7595_;
                                        if (_e4583 < _e4588) {
                                            phi_7600_ = _e4583;
                                        } else {
                                            phi_7600_ = _e4588;
                                        }
                                        let _e4603 = phi_7600_;
                                        if (_e4600 < _e4603) {
                                            phi_7605_ = _e4600;
                                        } else {
                                            phi_7605_ = _e4603;
                                        }
                                        let _e4606 = phi_7605_;
                                        if (_e4597 < _e4606) {
                                            phi_7610_ = _e4597;
                                        } else {
                                            phi_7610_ = _e4606;
                                        }
                                        let _e4609 = phi_7610_;
                                        if (_e4553 > _e4558) {
                                            phi_7615_ = _e4553;
                                        } else {
                                            phi_7615_ = _e4558;
                                        }
                                        let _e4612 = phi_7615_;
                                        if (_e4563 > _e4568) {
                                            phi_7620_ = _e4563;
                                        } else {
                                            phi_7620_ = _e4568;
                                        }
                                        let _e4615 = phi_7620_;
                                        if (_e4612 > _e4615) {
                                            phi_7625_ = _e4612;
                                        } else {
                                            phi_7625_ = _e4615;
                                        }
                                        let _e4618 = phi_7625_;
                                        if (_e4573 > _e4578) {
                                            phi_7630_ = _e4573;
                                        } else {
                                            phi_7630_ = _e4578;
                                        }
                                        let _e4621 = phi_7630_;
                                        if (_e4583 > _e4588) {
                                            phi_7635_ = _e4583;
                                        } else {
                                            phi_7635_ = _e4588;
                                        }
                                        let _e4624 = phi_7635_;
                                        if (_e4621 > _e4624) {
                                            phi_7640_ = _e4621;
                                        } else {
                                            phi_7640_ = _e4624;
                                        }
                                        let _e4627 = phi_7640_;
                                        if (_e4618 > _e4627) {
                                            phi_7645_ = _e4618;
                                        } else {
                                            phi_7645_ = _e4627;
                                        }
                                        let _e4630 = phi_7645_;
                                        if (_e4542 < 0f) {
                                            phi_7651_ = -(_e4542);
                                        } else {
                                            phi_7651_ = _e4542;
                                        }
                                        let _e4634 = phi_7651_;
                                        if (_e4545 < 0f) {
                                            phi_7657_ = -(_e4545);
                                        } else {
                                            phi_7657_ = _e4545;
                                        }
                                        let _e4638 = phi_7657_;
                                        if (_e4548 < 0f) {
                                            phi_7664_ = -(_e4548);
                                        } else {
                                            phi_7664_ = _e4548;
                                        }
                                        let _e4643 = phi_7664_;
                                        let _e4644 = ((_e4634 + _e4638) + _e4643);
                                        let _e4648 = -(_e4630);
                                        if (_e4609 > _e4648) {
                                            phi_7674_ = _e4609;
                                        } else {
                                            phi_7674_ = _e4648;
                                        }
                                        let _e4651 = phi_7674_;
                                        let _e4656 = (((_e4651 - ((_e4644 * _e4415) * (0.000000059604645f * 17f))) - (_e4644 * _e4422)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4539 > _e4656) {
                                            phi_7684_ = _e4539;
                                        } else {
                                            phi_7684_ = _e4656;
                                        }
                                        let _e4659 = phi_7684_;
                                        let _e4660 = (_e4192 - _e4177);
                                        let _e4661 = (_e4193 - _e4178);
                                        let _e4662 = (_e4194 - _e4179);
                                        let _e4665 = ((_e4200 * _e4662) - (_e4203 * _e4661));
                                        let _e4668 = ((_e4203 * _e4660) - (_e4197 * _e4662));
                                        let _e4671 = ((_e4197 * _e4661) - (_e4200 * _e4660));
                                        let _e4676 = (((_e4665 * _e4206[0]) + (_e4668 * _e4206[1])) + (_e4671 * _e4206[2]));
                                        let _e4681 = (((_e4665 * _e4222) + (_e4668 * _e4223)) + (_e4671 * _e4224));
                                        let _e4686 = (((_e4665 * _e4225) + (_e4668 * _e4226)) + (_e4671 * _e4227));
                                        let _e4691 = (((_e4665 * _e4206[0]) + (_e4668 * _e4206[1])) + (_e4671 * _e4206[2]));
                                        let _e4696 = (((_e4665 * _e4230[0]) + (_e4668 * _e4230[1])) + (_e4671 * _e4230[2]));
                                        let _e4701 = (((_e4665 * _e4246) + (_e4668 * _e4247)) + (_e4671 * _e4248));
                                        let _e4706 = (((_e4665 * _e4249) + (_e4668 * _e4250)) + (_e4671 * _e4251));
                                        let _e4711 = (((_e4665 * _e4230[0]) + (_e4668 * _e4230[1])) + (_e4671 * _e4230[2]));
                                        if (_e4676 < _e4681) {
                                            phi_7757_ = _e4676;
                                        } else {
                                            phi_7757_ = _e4681;
                                        }
                                        let _e4714 = phi_7757_;
                                        if (_e4686 < _e4691) {
                                            phi_7762_ = _e4686;
                                        } else {
                                            phi_7762_ = _e4691;
                                        }
                                        let _e4717 = phi_7762_;
                                        if (_e4714 < _e4717) {
                                            phi_7767_ = _e4714;
                                        } else {
                                            phi_7767_ = _e4717;
                                        }
                                        let _e4720 = phi_7767_;
                                        if (_e4696 < _e4701) {
                                            phi_7772_ = _e4696;
                                        } else {
                                            phi_7772_ = _e4701;
                                        }
                                        let _e4723 = phi_7772_;
                                        if (_e4706 < _e4711) {
                                            phi_7777_ = _e4706;
                                        } else {
                                            phi_7777_ = _e4711;
                                        }
                                        let _e4726 = phi_7777_;
                                        if (_e4723 < _e4726) {
                                            phi_7782_ = _e4723;
                                        } else {
                                            phi_7782_ = _e4726;
                                        }
                                        let _e4729 = phi_7782_;
                                        if (_e4720 < _e4729) {
                                            phi_7787_ = _e4720;
                                        } else {
                                            phi_7787_ = _e4729;
                                        }
                                        let _e4732 = phi_7787_;
                                        if (_e4676 > _e4681) {
                                            phi_7792_ = _e4676;
                                        } else {
                                            phi_7792_ = _e4681;
                                        }
                                        let _e4735 = phi_7792_;
                                        if (_e4686 > _e4691) {
                                            phi_7797_ = _e4686;
                                        } else {
                                            phi_7797_ = _e4691;
                                        }
                                        let _e4738 = phi_7797_;
                                        if (_e4735 > _e4738) {
                                            phi_7802_ = _e4735;
                                        } else {
                                            phi_7802_ = _e4738;
                                        }
                                        let _e4741 = phi_7802_;
                                        if (_e4696 > _e4701) {
                                            phi_7807_ = _e4696;
                                        } else {
                                            phi_7807_ = _e4701;
                                        }
                                        let _e4744 = phi_7807_;
                                        if (_e4706 > _e4711) {
                                            phi_7812_ = _e4706;
                                        } else {
                                            phi_7812_ = _e4711;
                                        }
                                        let _e4747 = phi_7812_;
                                        if (_e4744 > _e4747) {
                                            phi_7817_ = _e4744;
                                        } else {
                                            phi_7817_ = _e4747;
                                        }
                                        let _e4750 = phi_7817_;
                                        if (_e4741 > _e4750) {
                                            phi_7822_ = _e4741;
                                        } else {
                                            phi_7822_ = _e4750;
                                        }
                                        let _e4753 = phi_7822_;
                                        if (_e4665 < 0f) {
                                            phi_7828_ = -(_e4665);
                                        } else {
                                            phi_7828_ = _e4665;
                                        }
                                        let _e4757 = phi_7828_;
                                        if (_e4668 < 0f) {
                                            phi_7834_ = -(_e4668);
                                        } else {
                                            phi_7834_ = _e4668;
                                        }
                                        let _e4761 = phi_7834_;
                                        if (_e4671 < 0f) {
                                            phi_7841_ = -(_e4671);
                                        } else {
                                            phi_7841_ = _e4671;
                                        }
                                        let _e4766 = phi_7841_;
                                        let _e4767 = ((_e4757 + _e4761) + _e4766);
                                        let _e4771 = -(_e4753);
                                        if (_e4732 > _e4771) {
                                            phi_7851_ = _e4732;
                                        } else {
                                            phi_7851_ = _e4771;
                                        }
                                        let _e4774 = phi_7851_;
                                        let _e4779 = (((_e4774 - ((_e4767 * _e4415) * (0.000000059604645f * 17f))) - (_e4767 * _e4422)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4659 > _e4779) {
                                            phi_7861_ = _e4659;
                                        } else {
                                            phi_7861_ = _e4779;
                                        }
                                        let _e4782 = phi_7861_;
                                        phi_7864_ = (_e4782 > 0f);
                                    }
                                    let _e4785 = phi_7864_;
                                    phi_7865_ = _e4785;
                                } else {
                                    phi_7865_ = false;
                                }
                                let _e4787 = phi_7865_;
                                phi_7867_ = !(_e4787);
                            }
                            let _e4790 = phi_7867_;
                            if _e4790 {
                                let _e4792 = atomicAdd((&counters[5u]), 1u);
                                hits[_e993] = ((2147483648u | (_e4792 << bitcast<u32>(12i))) | _e996);
                            }
                        }
                        phi_7877_ = true;
                    }
                    let _e4799 = phi_7877_;
                    phi_7878_ = _e4799;
                } else {
                    phi_7878_ = false;
                }
                let _e4801 = phi_7878_;
                continue;
                continuing {
                    phi_1862_ = _e985;
                    break if !(_e4801);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4805 = atomicLoad((&counters[5u]));
                if (_e4805 > 0u) {
                    let _e4808 = atomicAdd((&output.member[0u]), _e4805);
                    if ((_e4808 + _e4805) < _e4808) {
                        let _e4812 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4808);
                }
            }
            workgroupBarrier();
            let _e4815 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4818 = atomicLoad((&counters[7u]));
                if (_e4818 > 0u) {
                    let _e4821 = atomicAdd((&output.member[1u]), _e4818);
                    if ((_e4821 + _e4818) < _e4821) {
                        let _e4825 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7928_ = type_9(0u, 16u);
            loop {
                let _e4827 = phi_7928_;
                if (_e4827.member < _e4827.member_1) {
                    phi_7929_ = type_9((_e4827.member + 1u), _e4827.member_1);
                    phi_7952_ = type_9(1u, _e4827.member);
                } else {
                    phi_7929_ = _e4827;
                    phi_7952_ = type_9(0u, type_9().member_1);
                }
                let _e4839 = phi_7929_;
                let _e4841 = phi_7952_;
                if (bitcast<i32>(_e4841.member) != 0i) {
                    let _e4847 = (_e67 + (_e4841.member_1 * 128u));
                    if (_e4847 >= _e971) {
                        phi_8049_ = false;
                    } else {
                        let _e4850 = hits[_e4847];
                        if ((_e4850 & 2147483648u) == 0u) {
                            phi_7975_ = 4294967295u;
                        } else {
                            phi_7975_ = ((_e4850 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4857 = phi_7975_;
                        if (_e4857 != 4294967295u) {
                            let _e4861 = ((_e4850 >> bitcast<u32>(10i)) & 3u);
                            let _e4868 = firsts[(2u * _e4861)];
                            let _e4871 = leaves.member[(_e4868 + ((_e4850 >> bitcast<u32>(5i)) & 31u))];
                            let _e4875 = firsts[((2u * _e4861) + 1u)];
                            let _e4878 = leaves.member[(_e4875 + (_e4850 & 31u))];
                            let _e4883 = params.member.member_1.member_3;
                            let _e4884 = (_e4815 + _e4857);
                            if (_e4884 < _e4883) {
                                let _e4886 = (2u * _e4884);
                                atomicStore((&output.member[(4u + _e4886)]), _e4871.member_1);
                                atomicStore((&output.member[(_e4886 + 5u)]), _e4878.member_1);
                            }
                        }
                        phi_8049_ = true;
                    }
                    let _e4892 = phi_8049_;
                    phi_8050_ = _e4892;
                } else {
                    phi_8050_ = false;
                }
                let _e4894 = phi_8050_;
                continue;
                continuing {
                    phi_7928_ = _e4839;
                    break if !(_e4894);
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
fn filter_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
