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
    var phi_4013_: f32;
    var phi_4018_: f32;
    var phi_4023_: f32;
    var phi_4028_: f32;
    var phi_4033_: f32;
    var phi_4038_: f32;
    var phi_4043_: f32;
    var phi_4048_: f32;
    var phi_4053_: f32;
    var phi_4058_: f32;
    var phi_4063_: f32;
    var phi_4068_: f32;
    var phi_4073_: f32;
    var phi_4078_: f32;
    var phi_4084_: f32;
    var phi_4090_: f32;
    var phi_4097_: f32;
    var phi_4108_: f32;
    var phi_4179_: f32;
    var phi_4184_: f32;
    var phi_4189_: f32;
    var phi_4194_: f32;
    var phi_4199_: f32;
    var phi_4204_: f32;
    var phi_4209_: f32;
    var phi_4214_: f32;
    var phi_4219_: f32;
    var phi_4224_: f32;
    var phi_4229_: f32;
    var phi_4234_: f32;
    var phi_4239_: f32;
    var phi_4244_: f32;
    var phi_4250_: f32;
    var phi_4256_: f32;
    var phi_4263_: f32;
    var phi_4274_: f32;
    var phi_4284_: f32;
    var phi_4357_: f32;
    var phi_4362_: f32;
    var phi_4367_: f32;
    var phi_4372_: f32;
    var phi_4377_: f32;
    var phi_4382_: f32;
    var phi_4387_: f32;
    var phi_4392_: f32;
    var phi_4397_: f32;
    var phi_4402_: f32;
    var phi_4407_: f32;
    var phi_4412_: f32;
    var phi_4417_: f32;
    var phi_4422_: f32;
    var phi_4428_: f32;
    var phi_4434_: f32;
    var phi_4441_: f32;
    var phi_4452_: f32;
    var phi_4462_: f32;
    var phi_4466_: bool;
    var phi_4918_: f32;
    var phi_4925_: f32;
    var phi_4930_: f32;
    var phi_4937_: f32;
    var phi_4942_: f32;
    var phi_4955_: f32;
    var phi_4962_: f32;
    var phi_4967_: f32;
    var phi_4974_: f32;
    var phi_4979_: f32;
    var phi_4984_: f32;
    var phi_5001_: f32;
    var phi_5008_: f32;
    var phi_5013_: f32;
    var phi_5020_: f32;
    var phi_5025_: f32;
    var phi_5039_: f32;
    var phi_5046_: f32;
    var phi_5051_: f32;
    var phi_5058_: f32;
    var phi_5063_: f32;
    var phi_5068_: f32;
    var phi_5085_: f32;
    var phi_5092_: f32;
    var phi_5097_: f32;
    var phi_5104_: f32;
    var phi_5109_: f32;
    var phi_5123_: f32;
    var phi_5130_: f32;
    var phi_5135_: f32;
    var phi_5142_: f32;
    var phi_5147_: f32;
    var phi_5152_: f32;
    var phi_5183_: f32;
    var phi_5189_: f32;
    var phi_5196_: f32;
    var phi_5203_: f32;
    var phi_5209_: f32;
    var phi_5216_: f32;
    var phi_5222_: f32;
    var phi_5228_: f32;
    var phi_5234_: f32;
    var phi_5241_: f32;
    var phi_5248_: f32;
    var phi_5272_: f32;
    var phi_5277_: f32;
    var phi_5282_: f32;
    var phi_5287_: f32;
    var phi_5292_: f32;
    var phi_5297_: f32;
    var phi_5307_: f32;
    var phi_5510_: f32;
    var phi_5517_: f32;
    var phi_5522_: f32;
    var phi_5529_: f32;
    var phi_5534_: f32;
    var phi_5547_: f32;
    var phi_5554_: f32;
    var phi_5559_: f32;
    var phi_5566_: f32;
    var phi_5571_: f32;
    var phi_5576_: f32;
    var phi_5593_: f32;
    var phi_5600_: f32;
    var phi_5605_: f32;
    var phi_5612_: f32;
    var phi_5617_: f32;
    var phi_5631_: f32;
    var phi_5638_: f32;
    var phi_5643_: f32;
    var phi_5650_: f32;
    var phi_5655_: f32;
    var phi_5660_: f32;
    var phi_5677_: f32;
    var phi_5684_: f32;
    var phi_5689_: f32;
    var phi_5696_: f32;
    var phi_5701_: f32;
    var phi_5715_: f32;
    var phi_5722_: f32;
    var phi_5727_: f32;
    var phi_5734_: f32;
    var phi_5739_: f32;
    var phi_5744_: f32;
    var phi_5823_: f32;
    var phi_5828_: f32;
    var phi_5833_: f32;
    var phi_5838_: f32;
    var phi_5843_: f32;
    var phi_5848_: f32;
    var phi_5853_: f32;
    var phi_5858_: f32;
    var phi_5863_: f32;
    var phi_5868_: f32;
    var phi_5873_: f32;
    var phi_5878_: f32;
    var phi_5883_: f32;
    var phi_5888_: f32;
    var phi_5894_: f32;
    var phi_5900_: f32;
    var phi_5907_: f32;
    var phi_5918_: f32;
    var phi_5989_: f32;
    var phi_5994_: f32;
    var phi_5999_: f32;
    var phi_6004_: f32;
    var phi_6009_: f32;
    var phi_6014_: f32;
    var phi_6019_: f32;
    var phi_6024_: f32;
    var phi_6029_: f32;
    var phi_6034_: f32;
    var phi_6039_: f32;
    var phi_6044_: f32;
    var phi_6049_: f32;
    var phi_6054_: f32;
    var phi_6060_: f32;
    var phi_6066_: f32;
    var phi_6073_: f32;
    var phi_6084_: f32;
    var phi_6094_: f32;
    var phi_6167_: f32;
    var phi_6172_: f32;
    var phi_6177_: f32;
    var phi_6182_: f32;
    var phi_6187_: f32;
    var phi_6192_: f32;
    var phi_6197_: f32;
    var phi_6202_: f32;
    var phi_6207_: f32;
    var phi_6212_: f32;
    var phi_6217_: f32;
    var phi_6222_: f32;
    var phi_6227_: f32;
    var phi_6232_: f32;
    var phi_6238_: f32;
    var phi_6244_: f32;
    var phi_6251_: f32;
    var phi_6262_: f32;
    var phi_6272_: f32;
    var phi_6276_: bool;
    var phi_6521_: f32;
    var phi_6528_: f32;
    var phi_6533_: f32;
    var phi_6540_: f32;
    var phi_6545_: f32;
    var phi_6558_: f32;
    var phi_6565_: f32;
    var phi_6570_: f32;
    var phi_6577_: f32;
    var phi_6582_: f32;
    var phi_6587_: f32;
    var phi_6604_: f32;
    var phi_6611_: f32;
    var phi_6616_: f32;
    var phi_6623_: f32;
    var phi_6628_: f32;
    var phi_6642_: f32;
    var phi_6649_: f32;
    var phi_6654_: f32;
    var phi_6661_: f32;
    var phi_6666_: f32;
    var phi_6671_: f32;
    var phi_6688_: f32;
    var phi_6695_: f32;
    var phi_6700_: f32;
    var phi_6707_: f32;
    var phi_6712_: f32;
    var phi_6726_: f32;
    var phi_6733_: f32;
    var phi_6738_: f32;
    var phi_6745_: f32;
    var phi_6750_: f32;
    var phi_6755_: f32;
    var phi_6786_: f32;
    var phi_6792_: f32;
    var phi_6799_: f32;
    var phi_6806_: f32;
    var phi_6812_: f32;
    var phi_6819_: f32;
    var phi_6825_: f32;
    var phi_6831_: f32;
    var phi_6837_: f32;
    var phi_6844_: f32;
    var phi_6851_: f32;
    var phi_6875_: f32;
    var phi_6880_: f32;
    var phi_6885_: f32;
    var phi_6890_: f32;
    var phi_6895_: f32;
    var phi_6900_: f32;
    var phi_6910_: f32;
    var phi_7113_: f32;
    var phi_7120_: f32;
    var phi_7125_: f32;
    var phi_7132_: f32;
    var phi_7137_: f32;
    var phi_7150_: f32;
    var phi_7157_: f32;
    var phi_7162_: f32;
    var phi_7169_: f32;
    var phi_7174_: f32;
    var phi_7179_: f32;
    var phi_7196_: f32;
    var phi_7203_: f32;
    var phi_7208_: f32;
    var phi_7215_: f32;
    var phi_7220_: f32;
    var phi_7234_: f32;
    var phi_7241_: f32;
    var phi_7246_: f32;
    var phi_7253_: f32;
    var phi_7258_: f32;
    var phi_7263_: f32;
    var phi_7280_: f32;
    var phi_7287_: f32;
    var phi_7292_: f32;
    var phi_7299_: f32;
    var phi_7304_: f32;
    var phi_7318_: f32;
    var phi_7325_: f32;
    var phi_7330_: f32;
    var phi_7337_: f32;
    var phi_7342_: f32;
    var phi_7347_: f32;
    var phi_7426_: f32;
    var phi_7431_: f32;
    var phi_7436_: f32;
    var phi_7441_: f32;
    var phi_7446_: f32;
    var phi_7451_: f32;
    var phi_7456_: f32;
    var phi_7461_: f32;
    var phi_7466_: f32;
    var phi_7471_: f32;
    var phi_7476_: f32;
    var phi_7481_: f32;
    var phi_7486_: f32;
    var phi_7491_: f32;
    var phi_7497_: f32;
    var phi_7503_: f32;
    var phi_7510_: f32;
    var phi_7521_: f32;
    var phi_7592_: f32;
    var phi_7597_: f32;
    var phi_7602_: f32;
    var phi_7607_: f32;
    var phi_7612_: f32;
    var phi_7617_: f32;
    var phi_7622_: f32;
    var phi_7627_: f32;
    var phi_7632_: f32;
    var phi_7637_: f32;
    var phi_7642_: f32;
    var phi_7647_: f32;
    var phi_7652_: f32;
    var phi_7657_: f32;
    var phi_7663_: f32;
    var phi_7669_: f32;
    var phi_7676_: f32;
    var phi_7687_: f32;
    var phi_7697_: f32;
    var phi_7770_: f32;
    var phi_7775_: f32;
    var phi_7780_: f32;
    var phi_7785_: f32;
    var phi_7790_: f32;
    var phi_7795_: f32;
    var phi_7800_: f32;
    var phi_7805_: f32;
    var phi_7810_: f32;
    var phi_7815_: f32;
    var phi_7820_: f32;
    var phi_7825_: f32;
    var phi_7830_: f32;
    var phi_7835_: f32;
    var phi_7841_: f32;
    var phi_7847_: f32;
    var phi_7854_: f32;
    var phi_7865_: f32;
    var phi_7875_: f32;
    var phi_7879_: bool;
    var phi_7881_: bool;
    var phi_7883_: bool;
    var phi_7894_: bool;
    var phi_7895_: bool;
    var phi_7945_: type_9;
    var phi_7946_: type_9;
    var phi_7969_: type_9;
    var phi_7992_: u32;
    var phi_8066_: bool;
    var phi_8067_: bool;
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
            let _e4942 = local_3;
            phi_946_ = _e4942;
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
                        phi_7894_ = false;
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
                            let _e1962 = ((_e1960 - ((((((_e1736 * 8f) * _e1846) * (0.000000059604645f * (524f / 64f))) + ((_e1853 * 19f) * ((_e1736 * (_e1790 + _e1844)) + (_e1790 * _e1844)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1736) * ((1f + _e1790) * (1f + _e1844))))) + ((_e1450 * (((_e1915 + (_e1846 * (0.000000059604645f * 8f))) + ((_e1920 * 6f) * (_e1790 + _e1844))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1790) * (1f + _e1844))))) * (3f * 1.0001f)))) > 0f);
                            if _e1962 {
                                phi_4466_ = _e1962;
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
                                let _e2214 = ((((_e2100 + _e2102) + (_e2154 + _e2156)) + (_e2208 + _e2210)) * 2f);
                                let _e2217 = local_2.member_3;
                                let _e2221 = (((_e1450 * 1.0001f) + (_e2217 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2224 = ((_e1998 * _e1977) - (_e2001 * _e1976));
                                let _e2227 = ((_e2001 * _e1975) - (_e1995 * _e1977));
                                let _e2230 = ((_e1995 * _e1976) - (_e1998 * _e1975));
                                let _e2235 = (((_e2224 * _e2004[0]) + (_e2227 * _e2004[1])) + (_e2230 * _e2004[2]));
                                let _e2240 = (((_e2224 * _e2020) + (_e2227 * _e2021)) + (_e2230 * _e2022));
                                let _e2245 = (((_e2224 * _e2023) + (_e2227 * _e2024)) + (_e2230 * _e2025));
                                let _e2250 = (((_e2224 * _e2004[0]) + (_e2227 * _e2004[1])) + (_e2230 * _e2004[2]));
                                let _e2255 = (((_e2224 * _e2028[0]) + (_e2227 * _e2028[1])) + (_e2230 * _e2028[2]));
                                let _e2260 = (((_e2224 * _e2044) + (_e2227 * _e2045)) + (_e2230 * _e2046));
                                let _e2265 = (((_e2224 * _e2047) + (_e2227 * _e2048)) + (_e2230 * _e2049));
                                let _e2270 = (((_e2224 * _e2028[0]) + (_e2227 * _e2028[1])) + (_e2230 * _e2028[2]));
                                if (_e2235 < _e2240) {
                                    phi_4013_ = _e2235;
                                } else {
                                    phi_4013_ = _e2240;
                                }
                                let _e2273 = phi_4013_;
                                if (_e2245 < _e2250) {
                                    phi_4018_ = _e2245;
                                } else {
                                    phi_4018_ = _e2250;
                                }
                                let _e2276 = phi_4018_;
                                if (_e2273 < _e2276) {
                                    phi_4023_ = _e2273;
                                } else {
                                    phi_4023_ = _e2276;
                                }
                                let _e2279 = phi_4023_;
                                if (_e2255 < _e2260) {
                                    phi_4028_ = _e2255;
                                } else {
                                    phi_4028_ = _e2260;
                                }
                                let _e2282 = phi_4028_;
                                if (_e2265 < _e2270) {
                                    phi_4033_ = _e2265;
                                } else {
                                    phi_4033_ = _e2270;
                                }
                                let _e2285 = phi_4033_;
                                if (_e2282 < _e2285) {
                                    phi_4038_ = _e2282;
                                } else {
                                    phi_4038_ = _e2285;
                                }
                                let _e2288 = phi_4038_;
                                if (_e2279 < _e2288) {
                                    phi_4043_ = _e2279;
                                } else {
                                    phi_4043_ = _e2288;
                                }
                                let _e2291 = phi_4043_;
                                if (_e2235 > _e2240) {
                                    phi_4048_ = _e2235;
                                } else {
                                    phi_4048_ = _e2240;
                                }
                                let _e2294 = phi_4048_;
                                if (_e2245 > _e2250) {
                                    phi_4053_ = _e2245;
                                } else {
                                    phi_4053_ = _e2250;
                                }
                                let _e2297 = phi_4053_;
                                if (_e2294 > _e2297) {
                                    phi_4058_ = _e2294;
                                } else {
                                    phi_4058_ = _e2297;
                                }
                                let _e2300 = phi_4058_;
                                if (_e2255 > _e2260) {
                                    phi_4063_ = _e2255;
                                } else {
                                    phi_4063_ = _e2260;
                                }
                                let _e2303 = phi_4063_;
                                if (_e2265 > _e2270) {
                                    phi_4068_ = _e2265;
                                } else {
                                    phi_4068_ = _e2270;
                                }
                                let _e2306 = phi_4068_;
                                if (_e2303 > _e2306) {
                                    phi_4073_ = _e2303;
                                } else {
                                    phi_4073_ = _e2306;
                                }
                                let _e2309 = phi_4073_;
                                if (_e2300 > _e2309) {
                                    phi_4078_ = _e2300;
                                } else {
                                    phi_4078_ = _e2309;
                                }
                                let _e2312 = phi_4078_;
                                if (_e2224 < 0f) {
                                    phi_4084_ = -(_e2224);
                                } else {
                                    phi_4084_ = _e2224;
                                }
                                let _e2316 = phi_4084_;
                                if (_e2227 < 0f) {
                                    phi_4090_ = -(_e2227);
                                } else {
                                    phi_4090_ = _e2227;
                                }
                                let _e2320 = phi_4090_;
                                if (_e2230 < 0f) {
                                    phi_4097_ = -(_e2230);
                                } else {
                                    phi_4097_ = _e2230;
                                }
                                let _e2325 = phi_4097_;
                                let _e2326 = ((_e2316 + _e2320) + _e2325);
                                let _e2331 = -(_e2312);
                                if (_e2291 > _e2331) {
                                    phi_4108_ = _e2291;
                                } else {
                                    phi_4108_ = _e2331;
                                }
                                let _e2334 = phi_4108_;
                                let _e2339 = (((_e2334 - ((_e2326 * _e2214) * (0.000000059604645f * (17f / 2f)))) - (_e2326 * _e2221)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2342 = ((_e1998 * _e1992) - (_e2001 * _e1991));
                                let _e2345 = ((_e2001 * _e1990) - (_e1995 * _e1992));
                                let _e2348 = ((_e1995 * _e1991) - (_e1998 * _e1990));
                                let _e2353 = (((_e2342 * _e2004[0]) + (_e2345 * _e2004[1])) + (_e2348 * _e2004[2]));
                                let _e2358 = (((_e2342 * _e2020) + (_e2345 * _e2021)) + (_e2348 * _e2022));
                                let _e2363 = (((_e2342 * _e2023) + (_e2345 * _e2024)) + (_e2348 * _e2025));
                                let _e2368 = (((_e2342 * _e2004[0]) + (_e2345 * _e2004[1])) + (_e2348 * _e2004[2]));
                                let _e2373 = (((_e2342 * _e2028[0]) + (_e2345 * _e2028[1])) + (_e2348 * _e2028[2]));
                                let _e2378 = (((_e2342 * _e2044) + (_e2345 * _e2045)) + (_e2348 * _e2046));
                                let _e2383 = (((_e2342 * _e2047) + (_e2345 * _e2048)) + (_e2348 * _e2049));
                                let _e2388 = (((_e2342 * _e2028[0]) + (_e2345 * _e2028[1])) + (_e2348 * _e2028[2]));
                                if (_e2353 < _e2358) {
                                    phi_4179_ = _e2353;
                                } else {
                                    phi_4179_ = _e2358;
                                }
                                let _e2391 = phi_4179_;
                                if (_e2363 < _e2368) {
                                    phi_4184_ = _e2363;
                                } else {
                                    phi_4184_ = _e2368;
                                }
                                let _e2394 = phi_4184_;
                                if (_e2391 < _e2394) {
                                    phi_4189_ = _e2391;
                                } else {
                                    phi_4189_ = _e2394;
                                }
                                let _e2397 = phi_4189_;
                                if (_e2373 < _e2378) {
                                    phi_4194_ = _e2373;
                                } else {
                                    phi_4194_ = _e2378;
                                }
                                let _e2400 = phi_4194_;
                                if (_e2383 < _e2388) {
                                    phi_4199_ = _e2383;
                                } else {
                                    phi_4199_ = _e2388;
                                }
                                let _e2403 = phi_4199_;
                                if (_e2400 < _e2403) {
                                    phi_4204_ = _e2400;
                                } else {
                                    phi_4204_ = _e2403;
                                }
                                let _e2406 = phi_4204_;
                                if (_e2397 < _e2406) {
                                    phi_4209_ = _e2397;
                                } else {
                                    phi_4209_ = _e2406;
                                }
                                let _e2409 = phi_4209_;
                                if (_e2353 > _e2358) {
                                    phi_4214_ = _e2353;
                                } else {
                                    phi_4214_ = _e2358;
                                }
                                let _e2412 = phi_4214_;
                                if (_e2363 > _e2368) {
                                    phi_4219_ = _e2363;
                                } else {
                                    phi_4219_ = _e2368;
                                }
                                let _e2415 = phi_4219_;
                                if (_e2412 > _e2415) {
                                    phi_4224_ = _e2412;
                                } else {
                                    phi_4224_ = _e2415;
                                }
                                let _e2418 = phi_4224_;
                                if (_e2373 > _e2378) {
                                    phi_4229_ = _e2373;
                                } else {
                                    phi_4229_ = _e2378;
                                }
                                let _e2421 = phi_4229_;
                                if (_e2383 > _e2388) {
                                    phi_4234_ = _e2383;
                                } else {
                                    phi_4234_ = _e2388;
                                }
                                let _e2424 = phi_4234_;
                                if (_e2421 > _e2424) {
                                    phi_4239_ = _e2421;
                                } else {
                                    phi_4239_ = _e2424;
                                }
                                let _e2427 = phi_4239_;
                                if (_e2418 > _e2427) {
                                    phi_4244_ = _e2418;
                                } else {
                                    phi_4244_ = _e2427;
                                }
                                let _e2430 = phi_4244_;
                                if (_e2342 < 0f) {
                                    phi_4250_ = -(_e2342);
                                } else {
                                    phi_4250_ = _e2342;
                                }
                                let _e2434 = phi_4250_;
                                if (_e2345 < 0f) {
                                    phi_4256_ = -(_e2345);
                                } else {
                                    phi_4256_ = _e2345;
                                }
                                let _e2438 = phi_4256_;
                                if (_e2348 < 0f) {
                                    phi_4263_ = -(_e2348);
                                } else {
                                    phi_4263_ = _e2348;
                                }
                                let _e2443 = phi_4263_;
                                let _e2444 = ((_e2434 + _e2438) + _e2443);
                                let _e2449 = -(_e2430);
                                if (_e2409 > _e2449) {
                                    phi_4274_ = _e2409;
                                } else {
                                    phi_4274_ = _e2449;
                                }
                                let _e2452 = phi_4274_;
                                let _e2457 = (((_e2452 - ((_e2444 * _e2214) * (0.000000059604645f * (17f / 2f)))) - (_e2444 * _e2221)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2339 > _e2457) {
                                    phi_4284_ = _e2339;
                                } else {
                                    phi_4284_ = _e2457;
                                }
                                let _e2460 = phi_4284_;
                                let _e2461 = (_e1990 - _e1975);
                                let _e2462 = (_e1991 - _e1976);
                                let _e2463 = (_e1992 - _e1977);
                                let _e2466 = ((_e1998 * _e2463) - (_e2001 * _e2462));
                                let _e2469 = ((_e2001 * _e2461) - (_e1995 * _e2463));
                                let _e2472 = ((_e1995 * _e2462) - (_e1998 * _e2461));
                                let _e2477 = (((_e2466 * _e2004[0]) + (_e2469 * _e2004[1])) + (_e2472 * _e2004[2]));
                                let _e2482 = (((_e2466 * _e2020) + (_e2469 * _e2021)) + (_e2472 * _e2022));
                                let _e2487 = (((_e2466 * _e2023) + (_e2469 * _e2024)) + (_e2472 * _e2025));
                                let _e2492 = (((_e2466 * _e2004[0]) + (_e2469 * _e2004[1])) + (_e2472 * _e2004[2]));
                                let _e2497 = (((_e2466 * _e2028[0]) + (_e2469 * _e2028[1])) + (_e2472 * _e2028[2]));
                                let _e2502 = (((_e2466 * _e2044) + (_e2469 * _e2045)) + (_e2472 * _e2046));
                                let _e2507 = (((_e2466 * _e2047) + (_e2469 * _e2048)) + (_e2472 * _e2049));
                                let _e2512 = (((_e2466 * _e2028[0]) + (_e2469 * _e2028[1])) + (_e2472 * _e2028[2]));
                                if (_e2477 < _e2482) {
                                    phi_4357_ = _e2477;
                                } else {
                                    phi_4357_ = _e2482;
                                }
                                let _e2515 = phi_4357_;
                                if (_e2487 < _e2492) {
                                    phi_4362_ = _e2487;
                                } else {
                                    phi_4362_ = _e2492;
                                }
                                let _e2518 = phi_4362_;
                                if (_e2515 < _e2518) {
                                    phi_4367_ = _e2515;
                                } else {
                                    phi_4367_ = _e2518;
                                }
                                let _e2521 = phi_4367_;
                                if (_e2497 < _e2502) {
                                    phi_4372_ = _e2497;
                                } else {
                                    phi_4372_ = _e2502;
                                }
                                let _e2524 = phi_4372_;
                                if (_e2507 < _e2512) {
                                    phi_4377_ = _e2507;
                                } else {
                                    phi_4377_ = _e2512;
                                }
                                let _e2527 = phi_4377_;
                                if (_e2524 < _e2527) {
                                    phi_4382_ = _e2524;
                                } else {
                                    phi_4382_ = _e2527;
                                }
                                let _e2530 = phi_4382_;
                                if (_e2521 < _e2530) {
                                    phi_4387_ = _e2521;
                                } else {
                                    phi_4387_ = _e2530;
                                }
                                let _e2533 = phi_4387_;
                                if (_e2477 > _e2482) {
                                    phi_4392_ = _e2477;
                                } else {
                                    phi_4392_ = _e2482;
                                }
                                let _e2536 = phi_4392_;
                                if (_e2487 > _e2492) {
                                    phi_4397_ = _e2487;
                                } else {
                                    phi_4397_ = _e2492;
                                }
                                let _e2539 = phi_4397_;
                                if (_e2536 > _e2539) {
                                    phi_4402_ = _e2536;
                                } else {
                                    phi_4402_ = _e2539;
                                }
                                let _e2542 = phi_4402_;
                                if (_e2497 > _e2502) {
                                    phi_4407_ = _e2497;
                                } else {
                                    phi_4407_ = _e2502;
                                }
                                let _e2545 = phi_4407_;
                                if (_e2507 > _e2512) {
                                    phi_4412_ = _e2507;
                                } else {
                                    phi_4412_ = _e2512;
                                }
                                let _e2548 = phi_4412_;
                                if (_e2545 > _e2548) {
                                    phi_4417_ = _e2545;
                                } else {
                                    phi_4417_ = _e2548;
                                }
                                let _e2551 = phi_4417_;
                                if (_e2542 > _e2551) {
                                    phi_4422_ = _e2542;
                                } else {
                                    phi_4422_ = _e2551;
                                }
                                let _e2554 = phi_4422_;
                                if (_e2466 < 0f) {
                                    phi_4428_ = -(_e2466);
                                } else {
                                    phi_4428_ = _e2466;
                                }
                                let _e2558 = phi_4428_;
                                if (_e2469 < 0f) {
                                    phi_4434_ = -(_e2469);
                                } else {
                                    phi_4434_ = _e2469;
                                }
                                let _e2562 = phi_4434_;
                                if (_e2472 < 0f) {
                                    phi_4441_ = -(_e2472);
                                } else {
                                    phi_4441_ = _e2472;
                                }
                                let _e2567 = phi_4441_;
                                let _e2568 = ((_e2558 + _e2562) + _e2567);
                                let _e2573 = -(_e2554);
                                if (_e2533 > _e2573) {
                                    phi_4452_ = _e2533;
                                } else {
                                    phi_4452_ = _e2573;
                                }
                                let _e2576 = phi_4452_;
                                let _e2581 = (((_e2576 - ((_e2568 * _e2214) * (0.000000059604645f * (17f / 2f)))) - (_e2568 * _e2221)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2460 > _e2581) {
                                    phi_4462_ = _e2460;
                                } else {
                                    phi_4462_ = _e2581;
                                }
                                let _e2584 = phi_4462_;
                                phi_4466_ = (_e1962 || (_e2584 > 0f));
                            }
                            let _e2588 = phi_4466_;
                            if _e2588 {
                                phi_7883_ = _e2588;
                            } else {
                                let _e2591 = local_2.member[0u];
                                let _e2597 = local_2.member[1u];
                                let _e2604 = ((_e2591[0] + _e2597[0]) * 0.5f);
                                let _e2605 = ((_e2591[1] + _e2597[1]) * 0.5f);
                                let _e2606 = ((_e2591[2] + _e2597[2]) * 0.5f);
                                let _e2609 = local_2.member_1[0u];
                                let _e2615 = local_2.member_1[1u];
                                let _e2622 = ((_e2609[0] + _e2615[0]) * 0.5f);
                                let _e2623 = ((_e2609[1] + _e2615[1]) * 0.5f);
                                let _e2624 = ((_e2609[2] + _e2615[2]) * 0.5f);
                                let _e2627 = local_2.member_2[0u];
                                let _e2633 = local_2.member_2[1u];
                                let _e2640 = ((_e2627[0] + _e2633[0]) * 0.5f);
                                let _e2641 = ((_e2627[1] + _e2633[1]) * 0.5f);
                                let _e2642 = ((_e2627[2] + _e2633[2]) * 0.5f);
                                let _e2645 = local_2.member[0u];
                                let _e2648 = local_2.member_1[0u];
                                let _e2651 = local_2.member_2[0u];
                                let _e2653 = local_2.member_3;
                                let _e2656 = local_2.member[1u];
                                let _e2659 = local_2.member_1[1u];
                                let _e2662 = local_2.member_2[1u];
                                let _e2664 = local_2.member_3;
                                local = type_37(array<array<f32, 3>, 2>(_e2645, array<f32, 3>(_e2604, _e2605, _e2606)), array<array<f32, 3>, 2>(_e2648, array<f32, 3>(_e2622, _e2623, _e2624)), array<array<f32, 3>, 2>(_e2651, array<f32, 3>(_e2640, _e2641, _e2642)), _e2653);
                                local_1 = type_37(array<array<f32, 3>, 2>(array<f32, 3>(_e2604, _e2605, _e2606), _e2656), array<array<f32, 3>, 2>(array<f32, 3>(_e2622, _e2623, _e2624), _e2659), array<array<f32, 3>, 2>(array<f32, 3>(_e2640, _e2641, _e2642), _e2662), _e2664);
                                let _e2681 = local.member_1[0u];
                                let _e2687 = local.member_2[0u];
                                let _e2693 = ((_e2681[1] * _e2687[2]) - (_e2681[2] * _e2687[1]));
                                let _e2696 = ((_e2681[2] * _e2687[0]) - (_e2681[0] * _e2687[2]));
                                let _e2699 = ((_e2681[0] * _e2687[1]) - (_e2681[1] * _e2687[0]));
                                let _e2702 = local.member_1[1u];
                                let _e2708 = local.member_2[1u];
                                let _e2714 = ((_e2702[1] * _e2708[2]) - (_e2702[2] * _e2708[1]));
                                let _e2717 = ((_e2702[2] * _e2708[0]) - (_e2702[0] * _e2708[2]));
                                let _e2720 = ((_e2702[0] * _e2708[1]) - (_e2702[1] * _e2708[0]));
                                let _e2723 = local.member_1[0u];
                                let _e2729 = local.member_2[1u];
                                let _e2744 = local.member_1[1u];
                                let _e2750 = local.member_2[0u];
                                let _e2763 = (((_e2723[1] * _e2729[2]) - (_e2723[2] * _e2729[1])) + ((_e2744[1] * _e2750[2]) - (_e2744[2] * _e2750[1])));
                                let _e2764 = (((_e2723[2] * _e2729[0]) - (_e2723[0] * _e2729[2])) + ((_e2744[2] * _e2750[0]) - (_e2744[0] * _e2750[2])));
                                let _e2765 = (((_e2723[0] * _e2729[1]) - (_e2723[1] * _e2729[0])) + ((_e2744[0] * _e2750[1]) - (_e2744[1] * _e2750[0])));
                                let _e2768 = local.member[0u];
                                let _e2779 = local.member[1u];
                                let _e2790 = local.member[0u];
                                let _e2799 = ((((_e2779[0] * _e2693) + (_e2779[1] * _e2696)) + (_e2779[2] * _e2699)) + (((_e2790[0] * _e2763) + (_e2790[1] * _e2764)) + (_e2790[2] * _e2765)));
                                let _e2802 = local.member[0u];
                                let _e2813 = local.member[1u];
                                let _e2822 = ((((_e2802[0] * _e2714) + (_e2802[1] * _e2717)) + (_e2802[2] * _e2720)) + (((_e2813[0] * _e2763) + (_e2813[1] * _e2764)) + (_e2813[2] * _e2765)));
                                let _e2825 = local.member[1u];
                                let _e2836 = local.member[0u];
                                if (_e2836[0] < 0f) {
                                    phi_4918_ = -(_e2836[0]);
                                } else {
                                    phi_4918_ = _e2836[0];
                                }
                                let _e2843 = phi_4918_;
                                if (_e2836[1] < 0f) {
                                    phi_4925_ = -(_e2836[1]);
                                } else {
                                    phi_4925_ = _e2836[1];
                                }
                                let _e2847 = phi_4925_;
                                if (_e2843 > _e2847) {
                                    phi_4930_ = _e2843;
                                } else {
                                    phi_4930_ = _e2847;
                                }
                                let _e2850 = phi_4930_;
                                if (_e2836[2] < 0f) {
                                    phi_4937_ = -(_e2836[2]);
                                } else {
                                    phi_4937_ = _e2836[2];
                                }
                                let _e2854 = phi_4937_;
                                if (_e2850 > _e2854) {
                                    phi_4942_ = _e2850;
                                } else {
                                    phi_4942_ = _e2854;
                                }
                                let _e2857 = phi_4942_;
                                let _e2860 = local.member[1u];
                                if (_e2860[0] < 0f) {
                                    phi_4955_ = -(_e2860[0]);
                                } else {
                                    phi_4955_ = _e2860[0];
                                }
                                let _e2867 = phi_4955_;
                                if (_e2860[1] < 0f) {
                                    phi_4962_ = -(_e2860[1]);
                                } else {
                                    phi_4962_ = _e2860[1];
                                }
                                let _e2871 = phi_4962_;
                                if (_e2867 > _e2871) {
                                    phi_4967_ = _e2867;
                                } else {
                                    phi_4967_ = _e2871;
                                }
                                let _e2874 = phi_4967_;
                                if (_e2860[2] < 0f) {
                                    phi_4974_ = -(_e2860[2]);
                                } else {
                                    phi_4974_ = _e2860[2];
                                }
                                let _e2878 = phi_4974_;
                                if (_e2874 > _e2878) {
                                    phi_4979_ = _e2874;
                                } else {
                                    phi_4979_ = _e2878;
                                }
                                let _e2881 = phi_4979_;
                                if (_e2857 > _e2881) {
                                    phi_4984_ = _e2857;
                                } else {
                                    phi_4984_ = _e2881;
                                }
                                let _e2884 = phi_4984_;
                                let _e2886 = local.member_3;
                                let _e2887 = (_e2884 + _e2886);
                                let _e2890 = local.member_1[0u];
                                if (_e2890[0] < 0f) {
                                    phi_5001_ = -(_e2890[0]);
                                } else {
                                    phi_5001_ = _e2890[0];
                                }
                                let _e2897 = phi_5001_;
                                if (_e2890[1] < 0f) {
                                    phi_5008_ = -(_e2890[1]);
                                } else {
                                    phi_5008_ = _e2890[1];
                                }
                                let _e2901 = phi_5008_;
                                if (_e2897 > _e2901) {
                                    phi_5013_ = _e2897;
                                } else {
                                    phi_5013_ = _e2901;
                                }
                                let _e2904 = phi_5013_;
                                if (_e2890[2] < 0f) {
                                    phi_5020_ = -(_e2890[2]);
                                } else {
                                    phi_5020_ = _e2890[2];
                                }
                                let _e2908 = phi_5020_;
                                if (_e2904 > _e2908) {
                                    phi_5025_ = _e2904;
                                } else {
                                    phi_5025_ = _e2908;
                                }
                                let _e2911 = phi_5025_;
                                let _e2914 = local.member_1[1u];
                                if (_e2914[0] < 0f) {
                                    phi_5039_ = -(_e2914[0]);
                                } else {
                                    phi_5039_ = _e2914[0];
                                }
                                let _e2921 = phi_5039_;
                                if (_e2914[1] < 0f) {
                                    phi_5046_ = -(_e2914[1]);
                                } else {
                                    phi_5046_ = _e2914[1];
                                }
                                let _e2925 = phi_5046_;
                                if (_e2921 > _e2925) {
                                    phi_5051_ = _e2921;
                                } else {
                                    phi_5051_ = _e2925;
                                }
                                let _e2928 = phi_5051_;
                                if (_e2914[2] < 0f) {
                                    phi_5058_ = -(_e2914[2]);
                                } else {
                                    phi_5058_ = _e2914[2];
                                }
                                let _e2932 = phi_5058_;
                                if (_e2928 > _e2932) {
                                    phi_5063_ = _e2928;
                                } else {
                                    phi_5063_ = _e2932;
                                }
                                let _e2935 = phi_5063_;
                                if (_e2911 > _e2935) {
                                    phi_5068_ = _e2911;
                                } else {
                                    phi_5068_ = _e2935;
                                }
                                let _e2938 = phi_5068_;
                                let _e2940 = local.member_3;
                                let _e2941 = (_e2938 + _e2940);
                                let _e2944 = local.member_2[0u];
                                if (_e2944[0] < 0f) {
                                    phi_5085_ = -(_e2944[0]);
                                } else {
                                    phi_5085_ = _e2944[0];
                                }
                                let _e2951 = phi_5085_;
                                if (_e2944[1] < 0f) {
                                    phi_5092_ = -(_e2944[1]);
                                } else {
                                    phi_5092_ = _e2944[1];
                                }
                                let _e2955 = phi_5092_;
                                if (_e2951 > _e2955) {
                                    phi_5097_ = _e2951;
                                } else {
                                    phi_5097_ = _e2955;
                                }
                                let _e2958 = phi_5097_;
                                if (_e2944[2] < 0f) {
                                    phi_5104_ = -(_e2944[2]);
                                } else {
                                    phi_5104_ = _e2944[2];
                                }
                                let _e2962 = phi_5104_;
                                if (_e2958 > _e2962) {
                                    phi_5109_ = _e2958;
                                } else {
                                    phi_5109_ = _e2962;
                                }
                                let _e2965 = phi_5109_;
                                let _e2968 = local.member_2[1u];
                                if (_e2968[0] < 0f) {
                                    phi_5123_ = -(_e2968[0]);
                                } else {
                                    phi_5123_ = _e2968[0];
                                }
                                let _e2975 = phi_5123_;
                                if (_e2968[1] < 0f) {
                                    phi_5130_ = -(_e2968[1]);
                                } else {
                                    phi_5130_ = _e2968[1];
                                }
                                let _e2979 = phi_5130_;
                                if (_e2975 > _e2979) {
                                    phi_5135_ = _e2975;
                                } else {
                                    phi_5135_ = _e2979;
                                }
                                let _e2982 = phi_5135_;
                                if (_e2968[2] < 0f) {
                                    phi_5142_ = -(_e2968[2]);
                                } else {
                                    phi_5142_ = _e2968[2];
                                }
                                let _e2986 = phi_5142_;
                                if (_e2982 > _e2986) {
                                    phi_5147_ = _e2982;
                                } else {
                                    phi_5147_ = _e2986;
                                }
                                let _e2989 = phi_5147_;
                                if (_e2965 > _e2989) {
                                    phi_5152_ = _e2965;
                                } else {
                                    phi_5152_ = _e2989;
                                }
                                let _e2992 = phi_5152_;
                                let _e2994 = local.member_3;
                                let _e2995 = (_e2992 + _e2994);
                                let _e2997 = ((_e2941 * 8f) * _e2995);
                                let _e3004 = local.member_3;
                                if (_e2693 < 0f) {
                                    phi_5183_ = -(_e2693);
                                } else {
                                    phi_5183_ = _e2693;
                                }
                                let _e3021 = phi_5183_;
                                if (_e2696 < 0f) {
                                    phi_5189_ = -(_e2696);
                                } else {
                                    phi_5189_ = _e2696;
                                }
                                let _e3025 = phi_5189_;
                                if (_e2699 < 0f) {
                                    phi_5196_ = -(_e2699);
                                } else {
                                    phi_5196_ = _e2699;
                                }
                                let _e3030 = phi_5196_;
                                let _e3031 = ((_e3021 + _e3025) + _e3030);
                                if (_e2714 < 0f) {
                                    phi_5203_ = -(_e2714);
                                } else {
                                    phi_5203_ = _e2714;
                                }
                                let _e3035 = phi_5203_;
                                if (_e2717 < 0f) {
                                    phi_5209_ = -(_e2717);
                                } else {
                                    phi_5209_ = _e2717;
                                }
                                let _e3039 = phi_5209_;
                                if (_e2720 < 0f) {
                                    phi_5216_ = -(_e2720);
                                } else {
                                    phi_5216_ = _e2720;
                                }
                                let _e3044 = phi_5216_;
                                let _e3045 = ((_e3035 + _e3039) + _e3044);
                                if (_e3031 > _e3045) {
                                    phi_5222_ = _e3031;
                                } else {
                                    phi_5222_ = _e3045;
                                }
                                let _e3048 = phi_5222_;
                                if (_e2763 < 0f) {
                                    phi_5228_ = -(_e2763);
                                } else {
                                    phi_5228_ = _e2763;
                                }
                                let _e3052 = phi_5228_;
                                if (_e2764 < 0f) {
                                    phi_5234_ = -(_e2764);
                                } else {
                                    phi_5234_ = _e2764;
                                }
                                let _e3056 = phi_5234_;
                                if (_e2765 < 0f) {
                                    phi_5241_ = -(_e2765);
                                } else {
                                    phi_5241_ = _e2765;
                                }
                                let _e3061 = phi_5241_;
                                let _e3063 = (((_e3052 + _e3056) + _e3061) * 0.5f);
                                if (_e3048 > _e3063) {
                                    phi_5248_ = _e3048;
                                } else {
                                    phi_5248_ = _e3063;
                                }
                                let _e3066 = phi_5248_;
                                let _e3071 = local.member_3;
                                let _e3084 = ((((_e2768[0] * _e2693) + (_e2768[1] * _e2696)) + (_e2768[2] * _e2699)) * 3f);
                                let _e3085 = ((((_e2825[0] * _e2714) + (_e2825[1] * _e2717)) + (_e2825[2] * _e2720)) * 3f);
                                if (_e3084 < _e3085) {
                                    phi_5272_ = _e3084;
                                } else {
                                    phi_5272_ = _e3085;
                                }
                                let _e3088 = phi_5272_;
                                if (_e2799 < _e2822) {
                                    phi_5277_ = _e2799;
                                } else {
                                    phi_5277_ = _e2822;
                                }
                                let _e3091 = phi_5277_;
                                if (_e3088 < _e3091) {
                                    phi_5282_ = _e3088;
                                } else {
                                    phi_5282_ = _e3091;
                                }
                                let _e3094 = phi_5282_;
                                if (_e3084 > _e3085) {
                                    phi_5287_ = _e3084;
                                } else {
                                    phi_5287_ = _e3085;
                                }
                                let _e3097 = phi_5287_;
                                if (_e2799 > _e2822) {
                                    phi_5292_ = _e2799;
                                } else {
                                    phi_5292_ = _e2822;
                                }
                                let _e3100 = phi_5292_;
                                if (_e3097 > _e3100) {
                                    phi_5297_ = _e3097;
                                } else {
                                    phi_5297_ = _e3100;
                                }
                                let _e3103 = phi_5297_;
                                let _e3108 = -(_e3103);
                                if (_e3094 > _e3108) {
                                    phi_5307_ = _e3094;
                                } else {
                                    phi_5307_ = _e3108;
                                }
                                let _e3111 = phi_5307_;
                                let _e3113 = ((_e3111 - ((((((_e2887 * 8f) * _e2997) * (0.000000059604645f * (524f / 64f))) + ((_e3004 * 19f) * ((_e2887 * (_e2941 + _e2995)) + (_e2941 * _e2995)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2887) * ((1f + _e2941) * (1f + _e2995))))) + ((_e1450 * (((_e3066 + (_e2997 * (0.000000059604645f * 8f))) + ((_e3071 * 6f) * (_e2941 + _e2995))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2941) * (1f + _e2995))))) * (3f * 1.0001f)))) > 0f);
                                if _e3113 {
                                    phi_6276_ = _e3113;
                                } else {
                                    let _e3116 = local.member_1[0u];
                                    let _e3122 = local.member_1[1u];
                                    let _e3126 = (_e3116[0] + _e3122[0]);
                                    let _e3127 = (_e3116[1] + _e3122[1]);
                                    let _e3128 = (_e3116[2] + _e3122[2]);
                                    let _e3131 = local.member_2[0u];
                                    let _e3137 = local.member_2[1u];
                                    let _e3141 = (_e3131[0] + _e3137[0]);
                                    let _e3142 = (_e3131[1] + _e3137[1]);
                                    let _e3143 = (_e3131[2] + _e3137[2]);
                                    let _e3146 = ((_e3127 * _e3143) - (_e3128 * _e3142));
                                    let _e3149 = ((_e3128 * _e3141) - (_e3126 * _e3143));
                                    let _e3152 = ((_e3126 * _e3142) - (_e3127 * _e3141));
                                    let _e3155 = local.member[0u];
                                    let _e3161 = local.member_1[0u];
                                    let _e3167 = local.member_2[0u];
                                    let _e3171 = (_e3155[0] - _e3161[0]);
                                    let _e3172 = (_e3155[1] - _e3161[1]);
                                    let _e3173 = (_e3155[2] - _e3161[2]);
                                    let _e3174 = (_e3155[0] - _e3167[0]);
                                    let _e3175 = (_e3155[1] - _e3167[1]);
                                    let _e3176 = (_e3155[2] - _e3167[2]);
                                    let _e3179 = local.member[1u];
                                    let _e3185 = local.member_1[1u];
                                    let _e3191 = local.member_2[1u];
                                    let _e3195 = (_e3179[0] - _e3185[0]);
                                    let _e3196 = (_e3179[1] - _e3185[1]);
                                    let _e3197 = (_e3179[2] - _e3185[2]);
                                    let _e3198 = (_e3179[0] - _e3191[0]);
                                    let _e3199 = (_e3179[1] - _e3191[1]);
                                    let _e3200 = (_e3179[2] - _e3191[2]);
                                    let _e3203 = local.member[0u];
                                    if (_e3203[0] < 0f) {
                                        phi_5510_ = -(_e3203[0]);
                                    } else {
                                        phi_5510_ = _e3203[0];
                                    }
                                    let _e3210 = phi_5510_;
                                    if (_e3203[1] < 0f) {
                                        phi_5517_ = -(_e3203[1]);
                                    } else {
                                        phi_5517_ = _e3203[1];
                                    }
                                    let _e3214 = phi_5517_;
                                    if (_e3210 > _e3214) {
                                        phi_5522_ = _e3210;
                                    } else {
                                        phi_5522_ = _e3214;
                                    }
                                    let _e3217 = phi_5522_;
                                    if (_e3203[2] < 0f) {
                                        phi_5529_ = -(_e3203[2]);
                                    } else {
                                        phi_5529_ = _e3203[2];
                                    }
                                    let _e3221 = phi_5529_;
                                    if (_e3217 > _e3221) {
                                        phi_5534_ = _e3217;
                                    } else {
                                        phi_5534_ = _e3221;
                                    }
                                    let _e3224 = phi_5534_;
                                    let _e3227 = local.member[1u];
                                    if (_e3227[0] < 0f) {
                                        phi_5547_ = -(_e3227[0]);
                                    } else {
                                        phi_5547_ = _e3227[0];
                                    }
                                    let _e3234 = phi_5547_;
                                    if (_e3227[1] < 0f) {
                                        phi_5554_ = -(_e3227[1]);
                                    } else {
                                        phi_5554_ = _e3227[1];
                                    }
                                    let _e3238 = phi_5554_;
                                    if (_e3234 > _e3238) {
                                        phi_5559_ = _e3234;
                                    } else {
                                        phi_5559_ = _e3238;
                                    }
                                    let _e3241 = phi_5559_;
                                    if (_e3227[2] < 0f) {
                                        phi_5566_ = -(_e3227[2]);
                                    } else {
                                        phi_5566_ = _e3227[2];
                                    }
                                    let _e3245 = phi_5566_;
                                    if (_e3241 > _e3245) {
                                        phi_5571_ = _e3241;
                                    } else {
                                        phi_5571_ = _e3245;
                                    }
                                    let _e3248 = phi_5571_;
                                    if (_e3224 > _e3248) {
                                        phi_5576_ = _e3224;
                                    } else {
                                        phi_5576_ = _e3248;
                                    }
                                    let _e3251 = phi_5576_;
                                    let _e3253 = local.member_3;
                                    let _e3257 = local.member_1[0u];
                                    if (_e3257[0] < 0f) {
                                        phi_5593_ = -(_e3257[0]);
                                    } else {
                                        phi_5593_ = _e3257[0];
                                    }
                                    let _e3264 = phi_5593_;
                                    if (_e3257[1] < 0f) {
                                        phi_5600_ = -(_e3257[1]);
                                    } else {
                                        phi_5600_ = _e3257[1];
                                    }
                                    let _e3268 = phi_5600_;
                                    if (_e3264 > _e3268) {
                                        phi_5605_ = _e3264;
                                    } else {
                                        phi_5605_ = _e3268;
                                    }
                                    let _e3271 = phi_5605_;
                                    if (_e3257[2] < 0f) {
                                        phi_5612_ = -(_e3257[2]);
                                    } else {
                                        phi_5612_ = _e3257[2];
                                    }
                                    let _e3275 = phi_5612_;
                                    if (_e3271 > _e3275) {
                                        phi_5617_ = _e3271;
                                    } else {
                                        phi_5617_ = _e3275;
                                    }
                                    let _e3278 = phi_5617_;
                                    let _e3281 = local.member_1[1u];
                                    if (_e3281[0] < 0f) {
                                        phi_5631_ = -(_e3281[0]);
                                    } else {
                                        phi_5631_ = _e3281[0];
                                    }
                                    let _e3288 = phi_5631_;
                                    if (_e3281[1] < 0f) {
                                        phi_5638_ = -(_e3281[1]);
                                    } else {
                                        phi_5638_ = _e3281[1];
                                    }
                                    let _e3292 = phi_5638_;
                                    if (_e3288 > _e3292) {
                                        phi_5643_ = _e3288;
                                    } else {
                                        phi_5643_ = _e3292;
                                    }
                                    let _e3295 = phi_5643_;
                                    if (_e3281[2] < 0f) {
                                        phi_5650_ = -(_e3281[2]);
                                    } else {
                                        phi_5650_ = _e3281[2];
                                    }
                                    let _e3299 = phi_5650_;
                                    if (_e3295 > _e3299) {
                                        phi_5655_ = _e3295;
                                    } else {
                                        phi_5655_ = _e3299;
                                    }
                                    let _e3302 = phi_5655_;
                                    if (_e3278 > _e3302) {
                                        phi_5660_ = _e3278;
                                    } else {
                                        phi_5660_ = _e3302;
                                    }
                                    let _e3305 = phi_5660_;
                                    let _e3307 = local.member_3;
                                    let _e3311 = local.member_2[0u];
                                    if (_e3311[0] < 0f) {
                                        phi_5677_ = -(_e3311[0]);
                                    } else {
                                        phi_5677_ = _e3311[0];
                                    }
                                    let _e3318 = phi_5677_;
                                    if (_e3311[1] < 0f) {
                                        phi_5684_ = -(_e3311[1]);
                                    } else {
                                        phi_5684_ = _e3311[1];
                                    }
                                    let _e3322 = phi_5684_;
                                    if (_e3318 > _e3322) {
                                        phi_5689_ = _e3318;
                                    } else {
                                        phi_5689_ = _e3322;
                                    }
                                    let _e3325 = phi_5689_;
                                    if (_e3311[2] < 0f) {
                                        phi_5696_ = -(_e3311[2]);
                                    } else {
                                        phi_5696_ = _e3311[2];
                                    }
                                    let _e3329 = phi_5696_;
                                    if (_e3325 > _e3329) {
                                        phi_5701_ = _e3325;
                                    } else {
                                        phi_5701_ = _e3329;
                                    }
                                    let _e3332 = phi_5701_;
                                    let _e3335 = local.member_2[1u];
                                    if (_e3335[0] < 0f) {
                                        phi_5715_ = -(_e3335[0]);
                                    } else {
                                        phi_5715_ = _e3335[0];
                                    }
                                    let _e3342 = phi_5715_;
                                    if (_e3335[1] < 0f) {
                                        phi_5722_ = -(_e3335[1]);
                                    } else {
                                        phi_5722_ = _e3335[1];
                                    }
                                    let _e3346 = phi_5722_;
                                    if (_e3342 > _e3346) {
                                        phi_5727_ = _e3342;
                                    } else {
                                        phi_5727_ = _e3346;
                                    }
                                    let _e3349 = phi_5727_;
                                    if (_e3335[2] < 0f) {
                                        phi_5734_ = -(_e3335[2]);
                                    } else {
                                        phi_5734_ = _e3335[2];
                                    }
                                    let _e3353 = phi_5734_;
                                    if (_e3349 > _e3353) {
                                        phi_5739_ = _e3349;
                                    } else {
                                        phi_5739_ = _e3353;
                                    }
                                    let _e3356 = phi_5739_;
                                    if (_e3332 > _e3356) {
                                        phi_5744_ = _e3332;
                                    } else {
                                        phi_5744_ = _e3356;
                                    }
                                    let _e3359 = phi_5744_;
                                    let _e3361 = local.member_3;
                                    let _e3365 = ((((_e3251 + _e3253) + (_e3305 + _e3307)) + (_e3359 + _e3361)) * 2f);
                                    let _e3368 = local.member_3;
                                    let _e3372 = (((_e1450 * 1.0001f) + (_e3368 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3375 = ((_e3149 * _e3128) - (_e3152 * _e3127));
                                    let _e3378 = ((_e3152 * _e3126) - (_e3146 * _e3128));
                                    let _e3381 = ((_e3146 * _e3127) - (_e3149 * _e3126));
                                    let _e3386 = (((_e3375 * _e3155[0]) + (_e3378 * _e3155[1])) + (_e3381 * _e3155[2]));
                                    let _e3391 = (((_e3375 * _e3171) + (_e3378 * _e3172)) + (_e3381 * _e3173));
                                    let _e3396 = (((_e3375 * _e3174) + (_e3378 * _e3175)) + (_e3381 * _e3176));
                                    let _e3401 = (((_e3375 * _e3155[0]) + (_e3378 * _e3155[1])) + (_e3381 * _e3155[2]));
                                    let _e3406 = (((_e3375 * _e3179[0]) + (_e3378 * _e3179[1])) + (_e3381 * _e3179[2]));
                                    let _e3411 = (((_e3375 * _e3195) + (_e3378 * _e3196)) + (_e3381 * _e3197));
                                    let _e3416 = (((_e3375 * _e3198) + (_e3378 * _e3199)) + (_e3381 * _e3200));
                                    let _e3421 = (((_e3375 * _e3179[0]) + (_e3378 * _e3179[1])) + (_e3381 * _e3179[2]));
                                    if (_e3386 < _e3391) {
                                        phi_5823_ = _e3386;
                                    } else {
                                        phi_5823_ = _e3391;
                                    }
                                    let _e3424 = phi_5823_;
                                    if (_e3396 < _e3401) {
                                        phi_5828_ = _e3396;
                                    } else {
                                        phi_5828_ = _e3401;
                                    }
                                    let _e3427 = phi_5828_;
                                    if (_e3424 < _e3427) {
                                        phi_5833_ = _e3424;
                                    } else {
                                        phi_5833_ = _e3427;
                                    }
                                    let _e3430 = phi_5833_;
                                    if (_e3406 < _e3411) {
                                        phi_5838_ = _e3406;
                                    } else {
                                        phi_5838_ = _e3411;
                                    }
                                    let _e3433 = phi_5838_;
                                    if (_e3416 < _e3421) {
                                        phi_5843_ = _e3416;
                                    } else {
                                        phi_5843_ = _e3421;
                                    }
                                    let _e3436 = phi_5843_;
                                    if (_e3433 < _e3436) {
                                        phi_5848_ = _e3433;
                                    } else {
                                        phi_5848_ = _e3436;
                                    }
                                    let _e3439 = phi_5848_;
                                    if (_e3430 < _e3439) {
                                        phi_5853_ = _e3430;
                                    } else {
                                        phi_5853_ = _e3439;
                                    }
                                    let _e3442 = phi_5853_;
                                    if (_e3386 > _e3391) {
                                        phi_5858_ = _e3386;
                                    } else {
                                        phi_5858_ = _e3391;
                                    }
                                    let _e3445 = phi_5858_;
                                    if (_e3396 > _e3401) {
                                        phi_5863_ = _e3396;
                                    } else {
                                        phi_5863_ = _e3401;
                                    }
                                    let _e3448 = phi_5863_;
                                    if (_e3445 > _e3448) {
                                        phi_5868_ = _e3445;
                                    } else {
                                        phi_5868_ = _e3448;
                                    }
                                    let _e3451 = phi_5868_;
                                    if (_e3406 > _e3411) {
                                        phi_5873_ = _e3406;
                                    } else {
                                        phi_5873_ = _e3411;
                                    }
                                    let _e3454 = phi_5873_;
                                    if (_e3416 > _e3421) {
                                        phi_5878_ = _e3416;
                                    } else {
                                        phi_5878_ = _e3421;
                                    }
                                    let _e3457 = phi_5878_;
                                    if (_e3454 > _e3457) {
                                        phi_5883_ = _e3454;
                                    } else {
                                        phi_5883_ = _e3457;
                                    }
                                    let _e3460 = phi_5883_;
                                    if (_e3451 > _e3460) {
                                        phi_5888_ = _e3451;
                                    } else {
                                        phi_5888_ = _e3460;
                                    }
                                    let _e3463 = phi_5888_;
                                    if (_e3375 < 0f) {
                                        phi_5894_ = -(_e3375);
                                    } else {
                                        phi_5894_ = _e3375;
                                    }
                                    let _e3467 = phi_5894_;
                                    if (_e3378 < 0f) {
                                        phi_5900_ = -(_e3378);
                                    } else {
                                        phi_5900_ = _e3378;
                                    }
                                    let _e3471 = phi_5900_;
                                    if (_e3381 < 0f) {
                                        phi_5907_ = -(_e3381);
                                    } else {
                                        phi_5907_ = _e3381;
                                    }
                                    let _e3476 = phi_5907_;
                                    let _e3477 = ((_e3467 + _e3471) + _e3476);
                                    let _e3482 = -(_e3463);
                                    if (_e3442 > _e3482) {
                                        phi_5918_ = _e3442;
                                    } else {
                                        phi_5918_ = _e3482;
                                    }
                                    let _e3485 = phi_5918_;
                                    let _e3490 = (((_e3485 - ((_e3477 * _e3365) * (0.000000059604645f * (17f / 2f)))) - (_e3477 * _e3372)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3493 = ((_e3149 * _e3143) - (_e3152 * _e3142));
                                    let _e3496 = ((_e3152 * _e3141) - (_e3146 * _e3143));
                                    let _e3499 = ((_e3146 * _e3142) - (_e3149 * _e3141));
                                    let _e3504 = (((_e3493 * _e3155[0]) + (_e3496 * _e3155[1])) + (_e3499 * _e3155[2]));
                                    let _e3509 = (((_e3493 * _e3171) + (_e3496 * _e3172)) + (_e3499 * _e3173));
                                    let _e3514 = (((_e3493 * _e3174) + (_e3496 * _e3175)) + (_e3499 * _e3176));
                                    let _e3519 = (((_e3493 * _e3155[0]) + (_e3496 * _e3155[1])) + (_e3499 * _e3155[2]));
                                    let _e3524 = (((_e3493 * _e3179[0]) + (_e3496 * _e3179[1])) + (_e3499 * _e3179[2]));
                                    let _e3529 = (((_e3493 * _e3195) + (_e3496 * _e3196)) + (_e3499 * _e3197));
                                    let _e3534 = (((_e3493 * _e3198) + (_e3496 * _e3199)) + (_e3499 * _e3200));
                                    let _e3539 = (((_e3493 * _e3179[0]) + (_e3496 * _e3179[1])) + (_e3499 * _e3179[2]));
                                    if (_e3504 < _e3509) {
                                        phi_5989_ = _e3504;
                                    } else {
                                        phi_5989_ = _e3509;
                                    }
                                    let _e3542 = phi_5989_;
                                    if (_e3514 < _e3519) {
                                        phi_5994_ = _e3514;
                                    } else {
                                        phi_5994_ = _e3519;
                                    }
                                    let _e3545 = phi_5994_;
                                    if (_e3542 < _e3545) {
                                        phi_5999_ = _e3542;
                                    } else {
                                        phi_5999_ = _e3545;
                                    }
                                    let _e3548 = phi_5999_;
                                    if (_e3524 < _e3529) {
                                        phi_6004_ = _e3524;
                                    } else {
                                        phi_6004_ = _e3529;
                                    }
                                    let _e3551 = phi_6004_;
                                    if (_e3534 < _e3539) {
                                        phi_6009_ = _e3534;
                                    } else {
                                        phi_6009_ = _e3539;
                                    }
                                    let _e3554 = phi_6009_;
                                    if (_e3551 < _e3554) {
                                        phi_6014_ = _e3551;
                                    } else {
                                        phi_6014_ = _e3554;
                                    }
                                    let _e3557 = phi_6014_;
                                    if (_e3548 < _e3557) {
                                        phi_6019_ = _e3548;
                                    } else {
                                        phi_6019_ = _e3557;
                                    }
                                    let _e3560 = phi_6019_;
                                    if (_e3504 > _e3509) {
                                        phi_6024_ = _e3504;
                                    } else {
                                        phi_6024_ = _e3509;
                                    }
                                    let _e3563 = phi_6024_;
                                    if (_e3514 > _e3519) {
                                        phi_6029_ = _e3514;
                                    } else {
                                        phi_6029_ = _e3519;
                                    }
                                    let _e3566 = phi_6029_;
                                    if (_e3563 > _e3566) {
                                        phi_6034_ = _e3563;
                                    } else {
                                        phi_6034_ = _e3566;
                                    }
                                    let _e3569 = phi_6034_;
                                    if (_e3524 > _e3529) {
                                        phi_6039_ = _e3524;
                                    } else {
                                        phi_6039_ = _e3529;
                                    }
                                    let _e3572 = phi_6039_;
                                    if (_e3534 > _e3539) {
                                        phi_6044_ = _e3534;
                                    } else {
                                        phi_6044_ = _e3539;
                                    }
                                    let _e3575 = phi_6044_;
                                    if (_e3572 > _e3575) {
                                        phi_6049_ = _e3572;
                                    } else {
                                        phi_6049_ = _e3575;
                                    }
                                    let _e3578 = phi_6049_;
                                    if (_e3569 > _e3578) {
                                        phi_6054_ = _e3569;
                                    } else {
                                        phi_6054_ = _e3578;
                                    }
                                    let _e3581 = phi_6054_;
                                    if (_e3493 < 0f) {
                                        phi_6060_ = -(_e3493);
                                    } else {
                                        phi_6060_ = _e3493;
                                    }
                                    let _e3585 = phi_6060_;
                                    if (_e3496 < 0f) {
                                        phi_6066_ = -(_e3496);
                                    } else {
                                        phi_6066_ = _e3496;
                                    }
                                    let _e3589 = phi_6066_;
                                    if (_e3499 < 0f) {
                                        phi_6073_ = -(_e3499);
                                    } else {
                                        phi_6073_ = _e3499;
                                    }
                                    let _e3594 = phi_6073_;
                                    let _e3595 = ((_e3585 + _e3589) + _e3594);
                                    let _e3600 = -(_e3581);
                                    if (_e3560 > _e3600) {
                                        phi_6084_ = _e3560;
                                    } else {
                                        phi_6084_ = _e3600;
                                    }
                                    let _e3603 = phi_6084_;
                                    let _e3608 = (((_e3603 - ((_e3595 * _e3365) * (0.000000059604645f * (17f / 2f)))) - (_e3595 * _e3372)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3490 > _e3608) {
                                        phi_6094_ = _e3490;
                                    } else {
                                        phi_6094_ = _e3608;
                                    }
                                    let _e3611 = phi_6094_;
                                    let _e3612 = (_e3141 - _e3126);
                                    let _e3613 = (_e3142 - _e3127);
                                    let _e3614 = (_e3143 - _e3128);
                                    let _e3617 = ((_e3149 * _e3614) - (_e3152 * _e3613));
                                    let _e3620 = ((_e3152 * _e3612) - (_e3146 * _e3614));
                                    let _e3623 = ((_e3146 * _e3613) - (_e3149 * _e3612));
                                    let _e3628 = (((_e3617 * _e3155[0]) + (_e3620 * _e3155[1])) + (_e3623 * _e3155[2]));
                                    let _e3633 = (((_e3617 * _e3171) + (_e3620 * _e3172)) + (_e3623 * _e3173));
                                    let _e3638 = (((_e3617 * _e3174) + (_e3620 * _e3175)) + (_e3623 * _e3176));
                                    let _e3643 = (((_e3617 * _e3155[0]) + (_e3620 * _e3155[1])) + (_e3623 * _e3155[2]));
                                    let _e3648 = (((_e3617 * _e3179[0]) + (_e3620 * _e3179[1])) + (_e3623 * _e3179[2]));
                                    let _e3653 = (((_e3617 * _e3195) + (_e3620 * _e3196)) + (_e3623 * _e3197));
                                    let _e3658 = (((_e3617 * _e3198) + (_e3620 * _e3199)) + (_e3623 * _e3200));
                                    let _e3663 = (((_e3617 * _e3179[0]) + (_e3620 * _e3179[1])) + (_e3623 * _e3179[2]));
                                    if (_e3628 < _e3633) {
                                        phi_6167_ = _e3628;
                                    } else {
                                        phi_6167_ = _e3633;
                                    }
                                    let _e3666 = phi_6167_;
                                    if (_e3638 < _e3643) {
                                        phi_6172_ = _e3638;
                                    } else {
                                        phi_6172_ = _e3643;
                                    }
                                    let _e3669 = phi_6172_;
                                    if (_e3666 < _e3669) {
                                        phi_6177_ = _e3666;
                                    } else {
                                        phi_6177_ = _e3669;
                                    }
                                    let _e3672 = phi_6177_;
                                    if (_e3648 < _e3653) {
                                        phi_6182_ = _e3648;
                                    } else {
                                        phi_6182_ = _e3653;
                                    }
                                    let _e3675 = phi_6182_;
                                    if (_e3658 < _e3663) {
                                        phi_6187_ = _e3658;
                                    } else {
                                        phi_6187_ = _e3663;
                                    }
                                    let _e3678 = phi_6187_;
                                    if (_e3675 < _e3678) {
                                        phi_6192_ = _e3675;
                                    } else {
                                        phi_6192_ = _e3678;
                                    }
                                    let _e3681 = phi_6192_;
                                    if (_e3672 < _e3681) {
                                        phi_6197_ = _e3672;
                                    } else {
                                        phi_6197_ = _e3681;
                                    }
                                    let _e3684 = phi_6197_;
                                    if (_e3628 > _e3633) {
                                        phi_6202_ = _e3628;
                                    } else {
                                        phi_6202_ = _e3633;
                                    }
                                    let _e3687 = phi_6202_;
                                    if (_e3638 > _e3643) {
                                        phi_6207_ = _e3638;
                                    } else {
                                        phi_6207_ = _e3643;
                                    }
                                    let _e3690 = phi_6207_;
                                    if (_e3687 > _e3690) {
                                        phi_6212_ = _e3687;
                                    } else {
                                        phi_6212_ = _e3690;
                                    }
                                    let _e3693 = phi_6212_;
                                    if (_e3648 > _e3653) {
                                        phi_6217_ = _e3648;
                                    } else {
                                        phi_6217_ = _e3653;
                                    }
                                    let _e3696 = phi_6217_;
                                    if (_e3658 > _e3663) {
                                        phi_6222_ = _e3658;
                                    } else {
                                        phi_6222_ = _e3663;
                                    }
                                    let _e3699 = phi_6222_;
                                    if (_e3696 > _e3699) {
                                        phi_6227_ = _e3696;
                                    } else {
                                        phi_6227_ = _e3699;
                                    }
                                    let _e3702 = phi_6227_;
                                    if (_e3693 > _e3702) {
                                        phi_6232_ = _e3693;
                                    } else {
                                        phi_6232_ = _e3702;
                                    }
                                    let _e3705 = phi_6232_;
                                    if (_e3617 < 0f) {
                                        phi_6238_ = -(_e3617);
                                    } else {
                                        phi_6238_ = _e3617;
                                    }
                                    let _e3709 = phi_6238_;
                                    if (_e3620 < 0f) {
                                        phi_6244_ = -(_e3620);
                                    } else {
                                        phi_6244_ = _e3620;
                                    }
                                    let _e3713 = phi_6244_;
                                    if (_e3623 < 0f) {
                                        phi_6251_ = -(_e3623);
                                    } else {
                                        phi_6251_ = _e3623;
                                    }
                                    let _e3718 = phi_6251_;
                                    let _e3719 = ((_e3709 + _e3713) + _e3718);
                                    let _e3724 = -(_e3705);
                                    if (_e3684 > _e3724) {
                                        phi_6262_ = _e3684;
                                    } else {
                                        phi_6262_ = _e3724;
                                    }
                                    let _e3727 = phi_6262_;
                                    let _e3732 = (((_e3727 - ((_e3719 * _e3365) * (0.000000059604645f * (17f / 2f)))) - (_e3719 * _e3372)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3611 > _e3732) {
                                        phi_6272_ = _e3611;
                                    } else {
                                        phi_6272_ = _e3732;
                                    }
                                    let _e3735 = phi_6272_;
                                    phi_6276_ = (_e3113 || (_e3735 > 0f));
                                }
                                let _e3739 = phi_6276_;
                                if _e3739 {
                                    let _e3742 = local_1.member_1[0u];
                                    let _e3748 = local_1.member_2[0u];
                                    let _e3754 = ((_e3742[1] * _e3748[2]) - (_e3742[2] * _e3748[1]));
                                    let _e3757 = ((_e3742[2] * _e3748[0]) - (_e3742[0] * _e3748[2]));
                                    let _e3760 = ((_e3742[0] * _e3748[1]) - (_e3742[1] * _e3748[0]));
                                    let _e3763 = local_1.member_1[1u];
                                    let _e3769 = local_1.member_2[1u];
                                    let _e3775 = ((_e3763[1] * _e3769[2]) - (_e3763[2] * _e3769[1]));
                                    let _e3778 = ((_e3763[2] * _e3769[0]) - (_e3763[0] * _e3769[2]));
                                    let _e3781 = ((_e3763[0] * _e3769[1]) - (_e3763[1] * _e3769[0]));
                                    let _e3784 = local_1.member_1[0u];
                                    let _e3790 = local_1.member_2[1u];
                                    let _e3805 = local_1.member_1[1u];
                                    let _e3811 = local_1.member_2[0u];
                                    let _e3824 = (((_e3784[1] * _e3790[2]) - (_e3784[2] * _e3790[1])) + ((_e3805[1] * _e3811[2]) - (_e3805[2] * _e3811[1])));
                                    let _e3825 = (((_e3784[2] * _e3790[0]) - (_e3784[0] * _e3790[2])) + ((_e3805[2] * _e3811[0]) - (_e3805[0] * _e3811[2])));
                                    let _e3826 = (((_e3784[0] * _e3790[1]) - (_e3784[1] * _e3790[0])) + ((_e3805[0] * _e3811[1]) - (_e3805[1] * _e3811[0])));
                                    let _e3829 = local_1.member[0u];
                                    let _e3840 = local_1.member[1u];
                                    let _e3851 = local_1.member[0u];
                                    let _e3860 = ((((_e3840[0] * _e3754) + (_e3840[1] * _e3757)) + (_e3840[2] * _e3760)) + (((_e3851[0] * _e3824) + (_e3851[1] * _e3825)) + (_e3851[2] * _e3826)));
                                    let _e3863 = local_1.member[0u];
                                    let _e3874 = local_1.member[1u];
                                    let _e3883 = ((((_e3863[0] * _e3775) + (_e3863[1] * _e3778)) + (_e3863[2] * _e3781)) + (((_e3874[0] * _e3824) + (_e3874[1] * _e3825)) + (_e3874[2] * _e3826)));
                                    let _e3886 = local_1.member[1u];
                                    let _e3897 = local_1.member[0u];
                                    if (_e3897[0] < 0f) {
                                        phi_6521_ = -(_e3897[0]);
                                    } else {
                                        phi_6521_ = _e3897[0];
                                    }
                                    let _e3904 = phi_6521_;
                                    if (_e3897[1] < 0f) {
                                        phi_6528_ = -(_e3897[1]);
                                    } else {
                                        phi_6528_ = _e3897[1];
                                    }
                                    let _e3908 = phi_6528_;
                                    if (_e3904 > _e3908) {
                                        phi_6533_ = _e3904;
                                    } else {
                                        phi_6533_ = _e3908;
                                    }
                                    let _e3911 = phi_6533_;
                                    if (_e3897[2] < 0f) {
                                        phi_6540_ = -(_e3897[2]);
                                    } else {
                                        phi_6540_ = _e3897[2];
                                    }
                                    let _e3915 = phi_6540_;
                                    if (_e3911 > _e3915) {
                                        phi_6545_ = _e3911;
                                    } else {
                                        phi_6545_ = _e3915;
                                    }
                                    let _e3918 = phi_6545_;
                                    let _e3921 = local_1.member[1u];
                                    if (_e3921[0] < 0f) {
                                        phi_6558_ = -(_e3921[0]);
                                    } else {
                                        phi_6558_ = _e3921[0];
                                    }
                                    let _e3928 = phi_6558_;
                                    if (_e3921[1] < 0f) {
                                        phi_6565_ = -(_e3921[1]);
                                    } else {
                                        phi_6565_ = _e3921[1];
                                    }
                                    let _e3932 = phi_6565_;
                                    if (_e3928 > _e3932) {
                                        phi_6570_ = _e3928;
                                    } else {
                                        phi_6570_ = _e3932;
                                    }
                                    let _e3935 = phi_6570_;
                                    if (_e3921[2] < 0f) {
                                        phi_6577_ = -(_e3921[2]);
                                    } else {
                                        phi_6577_ = _e3921[2];
                                    }
                                    let _e3939 = phi_6577_;
                                    if (_e3935 > _e3939) {
                                        phi_6582_ = _e3935;
                                    } else {
                                        phi_6582_ = _e3939;
                                    }
                                    let _e3942 = phi_6582_;
                                    if (_e3918 > _e3942) {
                                        phi_6587_ = _e3918;
                                    } else {
                                        phi_6587_ = _e3942;
                                    }
                                    let _e3945 = phi_6587_;
                                    let _e3947 = local_1.member_3;
                                    let _e3948 = (_e3945 + _e3947);
                                    let _e3951 = local_1.member_1[0u];
                                    if (_e3951[0] < 0f) {
                                        phi_6604_ = -(_e3951[0]);
                                    } else {
                                        phi_6604_ = _e3951[0];
                                    }
                                    let _e3958 = phi_6604_;
                                    if (_e3951[1] < 0f) {
                                        phi_6611_ = -(_e3951[1]);
                                    } else {
                                        phi_6611_ = _e3951[1];
                                    }
                                    let _e3962 = phi_6611_;
                                    if (_e3958 > _e3962) {
                                        phi_6616_ = _e3958;
                                    } else {
                                        phi_6616_ = _e3962;
                                    }
                                    let _e3965 = phi_6616_;
                                    if (_e3951[2] < 0f) {
                                        phi_6623_ = -(_e3951[2]);
                                    } else {
                                        phi_6623_ = _e3951[2];
                                    }
                                    let _e3969 = phi_6623_;
                                    if (_e3965 > _e3969) {
                                        phi_6628_ = _e3965;
                                    } else {
                                        phi_6628_ = _e3969;
                                    }
                                    let _e3972 = phi_6628_;
                                    let _e3975 = local_1.member_1[1u];
                                    if (_e3975[0] < 0f) {
                                        phi_6642_ = -(_e3975[0]);
                                    } else {
                                        phi_6642_ = _e3975[0];
                                    }
                                    let _e3982 = phi_6642_;
                                    if (_e3975[1] < 0f) {
                                        phi_6649_ = -(_e3975[1]);
                                    } else {
                                        phi_6649_ = _e3975[1];
                                    }
                                    let _e3986 = phi_6649_;
                                    if (_e3982 > _e3986) {
                                        phi_6654_ = _e3982;
                                    } else {
                                        phi_6654_ = _e3986;
                                    }
                                    let _e3989 = phi_6654_;
                                    if (_e3975[2] < 0f) {
                                        phi_6661_ = -(_e3975[2]);
                                    } else {
                                        phi_6661_ = _e3975[2];
                                    }
                                    let _e3993 = phi_6661_;
                                    if (_e3989 > _e3993) {
                                        phi_6666_ = _e3989;
                                    } else {
                                        phi_6666_ = _e3993;
                                    }
                                    let _e3996 = phi_6666_;
                                    if (_e3972 > _e3996) {
                                        phi_6671_ = _e3972;
                                    } else {
                                        phi_6671_ = _e3996;
                                    }
                                    let _e3999 = phi_6671_;
                                    let _e4001 = local_1.member_3;
                                    let _e4002 = (_e3999 + _e4001);
                                    let _e4005 = local_1.member_2[0u];
                                    if (_e4005[0] < 0f) {
                                        phi_6688_ = -(_e4005[0]);
                                    } else {
                                        phi_6688_ = _e4005[0];
                                    }
                                    let _e4012 = phi_6688_;
                                    if (_e4005[1] < 0f) {
                                        phi_6695_ = -(_e4005[1]);
                                    } else {
                                        phi_6695_ = _e4005[1];
                                    }
                                    let _e4016 = phi_6695_;
                                    if (_e4012 > _e4016) {
                                        phi_6700_ = _e4012;
                                    } else {
                                        phi_6700_ = _e4016;
                                    }
                                    let _e4019 = phi_6700_;
                                    if (_e4005[2] < 0f) {
                                        phi_6707_ = -(_e4005[2]);
                                    } else {
                                        phi_6707_ = _e4005[2];
                                    }
                                    let _e4023 = phi_6707_;
                                    if (_e4019 > _e4023) {
                                        phi_6712_ = _e4019;
                                    } else {
                                        phi_6712_ = _e4023;
                                    }
                                    let _e4026 = phi_6712_;
                                    let _e4029 = local_1.member_2[1u];
                                    if (_e4029[0] < 0f) {
                                        phi_6726_ = -(_e4029[0]);
                                    } else {
                                        phi_6726_ = _e4029[0];
                                    }
                                    let _e4036 = phi_6726_;
                                    if (_e4029[1] < 0f) {
                                        phi_6733_ = -(_e4029[1]);
                                    } else {
                                        phi_6733_ = _e4029[1];
                                    }
                                    let _e4040 = phi_6733_;
                                    if (_e4036 > _e4040) {
                                        phi_6738_ = _e4036;
                                    } else {
                                        phi_6738_ = _e4040;
                                    }
                                    let _e4043 = phi_6738_;
                                    if (_e4029[2] < 0f) {
                                        phi_6745_ = -(_e4029[2]);
                                    } else {
                                        phi_6745_ = _e4029[2];
                                    }
                                    let _e4047 = phi_6745_;
                                    if (_e4043 > _e4047) {
                                        phi_6750_ = _e4043;
                                    } else {
                                        phi_6750_ = _e4047;
                                    }
                                    let _e4050 = phi_6750_;
                                    if (_e4026 > _e4050) {
                                        phi_6755_ = _e4026;
                                    } else {
                                        phi_6755_ = _e4050;
                                    }
                                    let _e4053 = phi_6755_;
                                    let _e4055 = local_1.member_3;
                                    let _e4056 = (_e4053 + _e4055);
                                    let _e4058 = ((_e4002 * 8f) * _e4056);
                                    let _e4065 = local_1.member_3;
                                    if (_e3754 < 0f) {
                                        phi_6786_ = -(_e3754);
                                    } else {
                                        phi_6786_ = _e3754;
                                    }
                                    let _e4082 = phi_6786_;
                                    if (_e3757 < 0f) {
                                        phi_6792_ = -(_e3757);
                                    } else {
                                        phi_6792_ = _e3757;
                                    }
                                    let _e4086 = phi_6792_;
                                    if (_e3760 < 0f) {
                                        phi_6799_ = -(_e3760);
                                    } else {
                                        phi_6799_ = _e3760;
                                    }
                                    let _e4091 = phi_6799_;
                                    let _e4092 = ((_e4082 + _e4086) + _e4091);
                                    if (_e3775 < 0f) {
                                        phi_6806_ = -(_e3775);
                                    } else {
                                        phi_6806_ = _e3775;
                                    }
                                    let _e4096 = phi_6806_;
                                    if (_e3778 < 0f) {
                                        phi_6812_ = -(_e3778);
                                    } else {
                                        phi_6812_ = _e3778;
                                    }
                                    let _e4100 = phi_6812_;
                                    if (_e3781 < 0f) {
                                        phi_6819_ = -(_e3781);
                                    } else {
                                        phi_6819_ = _e3781;
                                    }
                                    let _e4105 = phi_6819_;
                                    let _e4106 = ((_e4096 + _e4100) + _e4105);
                                    if (_e4092 > _e4106) {
                                        phi_6825_ = _e4092;
                                    } else {
                                        phi_6825_ = _e4106;
                                    }
                                    let _e4109 = phi_6825_;
                                    if (_e3824 < 0f) {
                                        phi_6831_ = -(_e3824);
                                    } else {
                                        phi_6831_ = _e3824;
                                    }
                                    let _e4113 = phi_6831_;
                                    if (_e3825 < 0f) {
                                        phi_6837_ = -(_e3825);
                                    } else {
                                        phi_6837_ = _e3825;
                                    }
                                    let _e4117 = phi_6837_;
                                    if (_e3826 < 0f) {
                                        phi_6844_ = -(_e3826);
                                    } else {
                                        phi_6844_ = _e3826;
                                    }
                                    let _e4122 = phi_6844_;
                                    let _e4124 = (((_e4113 + _e4117) + _e4122) * 0.5f);
                                    if (_e4109 > _e4124) {
                                        phi_6851_ = _e4109;
                                    } else {
                                        phi_6851_ = _e4124;
                                    }
                                    let _e4127 = phi_6851_;
                                    let _e4132 = local_1.member_3;
                                    let _e4145 = ((((_e3829[0] * _e3754) + (_e3829[1] * _e3757)) + (_e3829[2] * _e3760)) * 3f);
                                    let _e4146 = ((((_e3886[0] * _e3775) + (_e3886[1] * _e3778)) + (_e3886[2] * _e3781)) * 3f);
                                    if (_e4145 < _e4146) {
                                        phi_6875_ = _e4145;
                                    } else {
                                        phi_6875_ = _e4146;
                                    }
                                    let _e4149 = phi_6875_;
                                    if (_e3860 < _e3883) {
                                        phi_6880_ = _e3860;
                                    } else {
                                        phi_6880_ = _e3883;
                                    }
                                    let _e4152 = phi_6880_;
                                    if (_e4149 < _e4152) {
                                        phi_6885_ = _e4149;
                                    } else {
                                        phi_6885_ = _e4152;
                                    }
                                    let _e4155 = phi_6885_;
                                    if (_e4145 > _e4146) {
                                        phi_6890_ = _e4145;
                                    } else {
                                        phi_6890_ = _e4146;
                                    }
                                    let _e4158 = phi_6890_;
                                    if (_e3860 > _e3883) {
                                        phi_6895_ = _e3860;
                                    } else {
                                        phi_6895_ = _e3883;
                                    }
                                    let _e4161 = phi_6895_;
                                    if (_e4158 > _e4161) {
                                        phi_6900_ = _e4158;
                                    } else {
                                        phi_6900_ = _e4161;
                                    }
                                    let _e4164 = phi_6900_;
                                    let _e4169 = -(_e4164);
                                    if (_e4155 > _e4169) {
                                        phi_6910_ = _e4155;
                                    } else {
                                        phi_6910_ = _e4169;
                                    }
                                    let _e4172 = phi_6910_;
                                    let _e4174 = ((_e4172 - ((((((_e3948 * 8f) * _e4058) * (0.000000059604645f * (524f / 64f))) + ((_e4065 * 19f) * ((_e3948 * (_e4002 + _e4056)) + (_e4002 * _e4056)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3948) * ((1f + _e4002) * (1f + _e4056))))) + ((_e1450 * (((_e4127 + (_e4058 * (0.000000059604645f * 8f))) + ((_e4132 * 6f) * (_e4002 + _e4056))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4002) * (1f + _e4056))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4174 {
                                        phi_7879_ = _e4174;
                                    } else {
                                        let _e4177 = local_1.member_1[0u];
                                        let _e4183 = local_1.member_1[1u];
                                        let _e4187 = (_e4177[0] + _e4183[0]);
                                        let _e4188 = (_e4177[1] + _e4183[1]);
                                        let _e4189 = (_e4177[2] + _e4183[2]);
                                        let _e4192 = local_1.member_2[0u];
                                        let _e4198 = local_1.member_2[1u];
                                        let _e4202 = (_e4192[0] + _e4198[0]);
                                        let _e4203 = (_e4192[1] + _e4198[1]);
                                        let _e4204 = (_e4192[2] + _e4198[2]);
                                        let _e4207 = ((_e4188 * _e4204) - (_e4189 * _e4203));
                                        let _e4210 = ((_e4189 * _e4202) - (_e4187 * _e4204));
                                        let _e4213 = ((_e4187 * _e4203) - (_e4188 * _e4202));
                                        let _e4216 = local_1.member[0u];
                                        let _e4222 = local_1.member_1[0u];
                                        let _e4228 = local_1.member_2[0u];
                                        let _e4232 = (_e4216[0] - _e4222[0]);
                                        let _e4233 = (_e4216[1] - _e4222[1]);
                                        let _e4234 = (_e4216[2] - _e4222[2]);
                                        let _e4235 = (_e4216[0] - _e4228[0]);
                                        let _e4236 = (_e4216[1] - _e4228[1]);
                                        let _e4237 = (_e4216[2] - _e4228[2]);
                                        let _e4240 = local_1.member[1u];
                                        let _e4246 = local_1.member_1[1u];
                                        let _e4252 = local_1.member_2[1u];
                                        let _e4256 = (_e4240[0] - _e4246[0]);
                                        let _e4257 = (_e4240[1] - _e4246[1]);
                                        let _e4258 = (_e4240[2] - _e4246[2]);
                                        let _e4259 = (_e4240[0] - _e4252[0]);
                                        let _e4260 = (_e4240[1] - _e4252[1]);
                                        let _e4261 = (_e4240[2] - _e4252[2]);
                                        let _e4264 = local_1.member[0u];
                                        if (_e4264[0] < 0f) {
                                            phi_7113_ = -(_e4264[0]);
                                        } else {
                                            phi_7113_ = _e4264[0];
                                        }
                                        let _e4271 = phi_7113_;
                                        if (_e4264[1] < 0f) {
                                            phi_7120_ = -(_e4264[1]);
                                        } else {
                                            phi_7120_ = _e4264[1];
                                        }
                                        let _e4275 = phi_7120_;
                                        if (_e4271 > _e4275) {
                                            phi_7125_ = _e4271;
                                        } else {
                                            phi_7125_ = _e4275;
                                        }
                                        let _e4278 = phi_7125_;
                                        if (_e4264[2] < 0f) {
                                            phi_7132_ = -(_e4264[2]);
                                        } else {
                                            phi_7132_ = _e4264[2];
                                        }
                                        let _e4282 = phi_7132_;
                                        if (_e4278 > _e4282) {
                                            phi_7137_ = _e4278;
                                        } else {
                                            phi_7137_ = _e4282;
                                        }
                                        let _e4285 = phi_7137_;
                                        let _e4288 = local_1.member[1u];
                                        if (_e4288[0] < 0f) {
                                            phi_7150_ = -(_e4288[0]);
                                        } else {
                                            phi_7150_ = _e4288[0];
                                        }
                                        let _e4295 = phi_7150_;
                                        if (_e4288[1] < 0f) {
                                            phi_7157_ = -(_e4288[1]);
                                        } else {
                                            phi_7157_ = _e4288[1];
                                        }
                                        let _e4299 = phi_7157_;
                                        if (_e4295 > _e4299) {
                                            phi_7162_ = _e4295;
                                        } else {
                                            phi_7162_ = _e4299;
                                        }
                                        let _e4302 = phi_7162_;
                                        if (_e4288[2] < 0f) {
                                            phi_7169_ = -(_e4288[2]);
                                        } else {
                                            phi_7169_ = _e4288[2];
                                        }
                                        let _e4306 = phi_7169_;
                                        if (_e4302 > _e4306) {
                                            phi_7174_ = _e4302;
                                        } else {
                                            phi_7174_ = _e4306;
                                        }
                                        let _e4309 = phi_7174_;
                                        if (_e4285 > _e4309) {
                                            phi_7179_ = _e4285;
                                        } else {
                                            phi_7179_ = _e4309;
                                        }
                                        let _e4312 = phi_7179_;
                                        let _e4314 = local_1.member_3;
                                        let _e4318 = local_1.member_1[0u];
                                        if (_e4318[0] < 0f) {
                                            phi_7196_ = -(_e4318[0]);
                                        } else {
                                            phi_7196_ = _e4318[0];
                                        }
                                        let _e4325 = phi_7196_;
                                        if (_e4318[1] < 0f) {
                                            phi_7203_ = -(_e4318[1]);
                                        } else {
                                            phi_7203_ = _e4318[1];
                                        }
                                        let _e4329 = phi_7203_;
                                        if (_e4325 > _e4329) {
                                            phi_7208_ = _e4325;
                                        } else {
                                            phi_7208_ = _e4329;
                                        }
                                        let _e4332 = phi_7208_;
                                        if (_e4318[2] < 0f) {
                                            phi_7215_ = -(_e4318[2]);
                                        } else {
                                            phi_7215_ = _e4318[2];
                                        }
                                        let _e4336 = phi_7215_;
                                        if (_e4332 > _e4336) {
                                            phi_7220_ = _e4332;
                                        } else {
                                            phi_7220_ = _e4336;
                                        }
                                        let _e4339 = phi_7220_;
                                        let _e4342 = local_1.member_1[1u];
                                        if (_e4342[0] < 0f) {
                                            phi_7234_ = -(_e4342[0]);
                                        } else {
                                            phi_7234_ = _e4342[0];
                                        }
                                        let _e4349 = phi_7234_;
                                        if (_e4342[1] < 0f) {
                                            phi_7241_ = -(_e4342[1]);
                                        } else {
                                            phi_7241_ = _e4342[1];
                                        }
                                        let _e4353 = phi_7241_;
                                        if (_e4349 > _e4353) {
                                            phi_7246_ = _e4349;
                                        } else {
                                            phi_7246_ = _e4353;
                                        }
                                        let _e4356 = phi_7246_;
                                        if (_e4342[2] < 0f) {
                                            phi_7253_ = -(_e4342[2]);
                                        } else {
                                            phi_7253_ = _e4342[2];
                                        }
                                        let _e4360 = phi_7253_;
                                        if (_e4356 > _e4360) {
                                            phi_7258_ = _e4356;
                                        } else {
                                            phi_7258_ = _e4360;
                                        }
                                        let _e4363 = phi_7258_;
                                        if (_e4339 > _e4363) {
                                            phi_7263_ = _e4339;
                                        } else {
                                            phi_7263_ = _e4363;
                                        }
                                        let _e4366 = phi_7263_;
                                        let _e4368 = local_1.member_3;
                                        let _e4372 = local_1.member_2[0u];
                                        if (_e4372[0] < 0f) {
                                            phi_7280_ = -(_e4372[0]);
                                        } else {
                                            phi_7280_ = _e4372[0];
                                        }
                                        let _e4379 = phi_7280_;
                                        if (_e4372[1] < 0f) {
                                            phi_7287_ = -(_e4372[1]);
                                        } else {
                                            phi_7287_ = _e4372[1];
                                        }
                                        let _e4383 = phi_7287_;
                                        if (_e4379 > _e4383) {
                                            phi_7292_ = _e4379;
                                        } else {
                                            phi_7292_ = _e4383;
                                        }
                                        let _e4386 = phi_7292_;
                                        if (_e4372[2] < 0f) {
                                            phi_7299_ = -(_e4372[2]);
                                        } else {
                                            phi_7299_ = _e4372[2];
                                        }
                                        let _e4390 = phi_7299_;
                                        if (_e4386 > _e4390) {
                                            phi_7304_ = _e4386;
                                        } else {
                                            phi_7304_ = _e4390;
                                        }
                                        let _e4393 = phi_7304_;
                                        let _e4396 = local_1.member_2[1u];
                                        if (_e4396[0] < 0f) {
                                            phi_7318_ = -(_e4396[0]);
                                        } else {
                                            phi_7318_ = _e4396[0];
                                        }
                                        let _e4403 = phi_7318_;
                                        if (_e4396[1] < 0f) {
                                            phi_7325_ = -(_e4396[1]);
                                        } else {
                                            phi_7325_ = _e4396[1];
                                        }
                                        let _e4407 = phi_7325_;
                                        if (_e4403 > _e4407) {
                                            phi_7330_ = _e4403;
                                        } else {
                                            phi_7330_ = _e4407;
                                        }
                                        let _e4410 = phi_7330_;
                                        if (_e4396[2] < 0f) {
                                            phi_7337_ = -(_e4396[2]);
                                        } else {
                                            phi_7337_ = _e4396[2];
                                        }
                                        let _e4414 = phi_7337_;
                                        if (_e4410 > _e4414) {
                                            phi_7342_ = _e4410;
                                        } else {
                                            phi_7342_ = _e4414;
                                        }
                                        let _e4417 = phi_7342_;
                                        if (_e4393 > _e4417) {
                                            phi_7347_ = _e4393;
                                        } else {
                                            phi_7347_ = _e4417;
                                        }
                                        let _e4420 = phi_7347_;
                                        let _e4422 = local_1.member_3;
                                        let _e4426 = ((((_e4312 + _e4314) + (_e4366 + _e4368)) + (_e4420 + _e4422)) * 2f);
                                        let _e4429 = local_1.member_3;
                                        let _e4433 = (((_e1450 * 1.0001f) + (_e4429 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4436 = ((_e4210 * _e4189) - (_e4213 * _e4188));
                                        let _e4439 = ((_e4213 * _e4187) - (_e4207 * _e4189));
                                        let _e4442 = ((_e4207 * _e4188) - (_e4210 * _e4187));
                                        let _e4447 = (((_e4436 * _e4216[0]) + (_e4439 * _e4216[1])) + (_e4442 * _e4216[2]));
                                        let _e4452 = (((_e4436 * _e4232) + (_e4439 * _e4233)) + (_e4442 * _e4234));
                                        let _e4457 = (((_e4436 * _e4235) + (_e4439 * _e4236)) + (_e4442 * _e4237));
                                        let _e4462 = (((_e4436 * _e4216[0]) + (_e4439 * _e4216[1])) + (_e4442 * _e4216[2]));
                                        let _e4467 = (((_e4436 * _e4240[0]) + (_e4439 * _e4240[1])) + (_e4442 * _e4240[2]));
                                        let _e4472 = (((_e4436 * _e4256) + (_e4439 * _e4257)) + (_e4442 * _e4258));
                                        let _e4477 = (((_e4436 * _e4259) + (_e4439 * _e4260)) + (_e4442 * _e4261));
                                        let _e4482 = (((_e4436 * _e4240[0]) + (_e4439 * _e4240[1])) + (_e4442 * _e4240[2]));
                                        if (_e4447 < _e4452) {
                                            phi_7426_ = _e4447;
                                        } else {
                                            phi_7426_ = _e4452;
                                        }
                                        let _e4485 = phi_7426_;
                                        if (_e4457 < _e4462) {
                                            phi_7431_ = _e4457;
                                        } else {
                                            phi_7431_ = _e4462;
                                        }
                                        let _e4488 = phi_7431_;
                                        if (_e4485 < _e4488) {
                                            phi_7436_ = _e4485;
                                        } else {
                                            phi_7436_ = _e4488;
                                        }
                                        let _e4491 = phi_7436_;
                                        if (_e4467 < _e4472) {
                                            phi_7441_ = _e4467;
                                        } else {
                                            phi_7441_ = _e4472;
                                        }
                                        let _e4494 = phi_7441_;
                                        if (_e4477 < _e4482) {
                                            phi_7446_ = _e4477;
                                        } else {
                                            phi_7446_ = _e4482;
                                        }
                                        let _e4497 = phi_7446_;
                                        if (_e4494 < _e4497) {
                                            phi_7451_ = _e4494;
                                        } else {
                                            phi_7451_ = _e4497;
                                        }
                                        let _e4500 = phi_7451_;
                                        if (_e4491 < _e4500) {
                                            phi_7456_ = _e4491;
                                        } else {
                                            phi_7456_ = _e4500;
                                        }
                                        let _e4503 = phi_7456_;
                                        if (_e4447 > _e4452) {
                                            phi_7461_ = _e4447;
                                        } else {
                                            phi_7461_ = _e4452;
                                        }
                                        let _e4506 = phi_7461_;
                                        if (_e4457 > _e4462) {
                                            phi_7466_ = _e4457;
                                        } else {
                                            phi_7466_ = _e4462;
                                        }
                                        let _e4509 = phi_7466_;
                                        if (_e4506 > _e4509) {
                                            phi_7471_ = _e4506;
                                        } else {
                                            phi_7471_ = _e4509;
                                        }
                                        let _e4512 = phi_7471_;
                                        if (_e4467 > _e4472) {
                                            phi_7476_ = _e4467;
                                        } else {
                                            phi_7476_ = _e4472;
                                        }
                                        let _e4515 = phi_7476_;
                                        if (_e4477 > _e4482) {
                                            phi_7481_ = _e4477;
                                        } else {
                                            phi_7481_ = _e4482;
                                        }
                                        let _e4518 = phi_7481_;
                                        if (_e4515 > _e4518) {
                                            phi_7486_ = _e4515;
                                        } else {
                                            phi_7486_ = _e4518;
                                        }
                                        let _e4521 = phi_7486_;
                                        if (_e4512 > _e4521) {
                                            phi_7491_ = _e4512;
                                        } else {
                                            phi_7491_ = _e4521;
                                        }
                                        let _e4524 = phi_7491_;
                                        if (_e4436 < 0f) {
                                            phi_7497_ = -(_e4436);
                                        } else {
                                            phi_7497_ = _e4436;
                                        }
                                        let _e4528 = phi_7497_;
                                        if (_e4439 < 0f) {
                                            phi_7503_ = -(_e4439);
                                        } else {
                                            phi_7503_ = _e4439;
                                        }
                                        let _e4532 = phi_7503_;
                                        if (_e4442 < 0f) {
                                            phi_7510_ = -(_e4442);
                                        } else {
                                            phi_7510_ = _e4442;
                                        }
                                        let _e4537 = phi_7510_;
                                        let _e4538 = ((_e4528 + _e4532) + _e4537);
                                        let _e4543 = -(_e4524);
                                        if (_e4503 > _e4543) {
                                            phi_7521_ = _e4503;
                                        } else {
                                            phi_7521_ = _e4543;
                                        }
                                        let _e4546 = phi_7521_;
                                        let _e4551 = (((_e4546 - ((_e4538 * _e4426) * (0.000000059604645f * (17f / 2f)))) - (_e4538 * _e4433)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4554 = ((_e4210 * _e4204) - (_e4213 * _e4203));
                                        let _e4557 = ((_e4213 * _e4202) - (_e4207 * _e4204));
                                        let _e4560 = ((_e4207 * _e4203) - (_e4210 * _e4202));
                                        let _e4565 = (((_e4554 * _e4216[0]) + (_e4557 * _e4216[1])) + (_e4560 * _e4216[2]));
                                        let _e4570 = (((_e4554 * _e4232) + (_e4557 * _e4233)) + (_e4560 * _e4234));
                                        let _e4575 = (((_e4554 * _e4235) + (_e4557 * _e4236)) + (_e4560 * _e4237));
                                        let _e4580 = (((_e4554 * _e4216[0]) + (_e4557 * _e4216[1])) + (_e4560 * _e4216[2]));
                                        let _e4585 = (((_e4554 * _e4240[0]) + (_e4557 * _e4240[1])) + (_e4560 * _e4240[2]));
                                        let _e4590 = (((_e4554 * _e4256) + (_e4557 * _e4257)) + (_e4560 * _e4258));
                                        let _e4595 = (((_e4554 * _e4259) + (_e4557 * _e4260)) + (_e4560 * _e4261));
                                        let _e4600 = (((_e4554 * _e4240[0]) + (_e4557 * _e4240[1])) + (_e4560 * _e4240[2]));
                                        if (_e4565 < _e4570) {
                                            phi_7592_ = _e4565;
                                        } else {
                                            phi_7592_ = _e4570;
                                        }
                                        let _e4603 = phi_7592_;
                                        if (_e4575 < _e4580) {
                                            phi_7597_ = _e4575;
                                        } else {
                                            phi_7597_ = _e4580;
                                        }
                                        let _e4606 = phi_7597_;
                                        if (_e4603 < _e4606) {
                                            phi_7602_ = _e4603;
                                        } else {
                                            phi_7602_ = _e4606;
                                        }
                                        let _e4609 = phi_7602_;
                                        if (_e4585 < _e4590) {
                                            phi_7607_ = _e4585;
                                        } else {
                                            phi_7607_ = _e4590;
                                        }
                                        let _e4612 = phi_7607_;
                                        if (_e4595 < _e4600) {
                                            phi_7612_ = _e4595;
                                        } else {
                                            phi_7612_ = _e4600;
                                        }
                                        let _e4615 = phi_7612_;
                                        if (_e4612 < _e4615) {
                                            phi_7617_ = _e4612;
                                        } else {
                                            phi_7617_ = _e4615;
                                        }
                                        let _e4618 = phi_7617_;
                                        if (_e4609 < _e4618) {
                                            phi_7622_ = _e4609;
                                        } else {
                                            phi_7622_ = _e4618;
                                        }
                                        let _e4621 = phi_7622_;
                                        if (_e4565 > _e4570) {
                                            phi_7627_ = _e4565;
                                        } else {
                                            phi_7627_ = _e4570;
                                        }
                                        let _e4624 = phi_7627_;
                                        if (_e4575 > _e4580) {
                                            phi_7632_ = _e4575;
                                        } else {
                                            phi_7632_ = _e4580;
                                        }
                                        let _e4627 = phi_7632_;
                                        if (_e4624 > _e4627) {
                                            phi_7637_ = _e4624;
                                        } else {
                                            phi_7637_ = _e4627;
                                        }
                                        let _e4630 = phi_7637_;
                                        if (_e4585 > _e4590) {
                                            phi_7642_ = _e4585;
                                        } else {
                                            phi_7642_ = _e4590;
                                        }
                                        let _e4633 = phi_7642_;
                                        if (_e4595 > _e4600) {
                                            phi_7647_ = _e4595;
                                        } else {
                                            phi_7647_ = _e4600;
                                        }
                                        let _e4636 = phi_7647_;
                                        if (_e4633 > _e4636) {
                                            phi_7652_ = _e4633;
                                        } else {
                                            phi_7652_ = _e4636;
                                        }
                                        let _e4639 = phi_7652_;
                                        if (_e4630 > _e4639) {
                                            phi_7657_ = _e4630;
                                        } else {
                                            phi_7657_ = _e4639;
                                        }
                                        let _e4642 = phi_7657_;
                                        if (_e4554 < 0f) {
                                            phi_7663_ = -(_e4554);
                                        } else {
                                            phi_7663_ = _e4554;
                                        }
                                        let _e4646 = phi_7663_;
                                        if (_e4557 < 0f) {
                                            phi_7669_ = -(_e4557);
                                        } else {
                                            phi_7669_ = _e4557;
                                        }
                                        let _e4650 = phi_7669_;
                                        if (_e4560 < 0f) {
                                            phi_7676_ = -(_e4560);
                                        } else {
                                            phi_7676_ = _e4560;
                                        }
                                        let _e4655 = phi_7676_;
                                        let _e4656 = ((_e4646 + _e4650) + _e4655);
                                        let _e4661 = -(_e4642);
                                        if (_e4621 > _e4661) {
                                            phi_7687_ = _e4621;
                                        } else {
                                            phi_7687_ = _e4661;
                                        }
                                        let _e4664 = phi_7687_;
                                        let _e4669 = (((_e4664 - ((_e4656 * _e4426) * (0.000000059604645f * (17f / 2f)))) - (_e4656 * _e4433)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4551 > _e4669) {
                                            phi_7697_ = _e4551;
                                        } else {
                                            phi_7697_ = _e4669;
                                        }
                                        let _e4672 = phi_7697_;
                                        let _e4673 = (_e4202 - _e4187);
                                        let _e4674 = (_e4203 - _e4188);
                                        let _e4675 = (_e4204 - _e4189);
                                        let _e4678 = ((_e4210 * _e4675) - (_e4213 * _e4674));
                                        let _e4681 = ((_e4213 * _e4673) - (_e4207 * _e4675));
                                        let _e4684 = ((_e4207 * _e4674) - (_e4210 * _e4673));
                                        let _e4689 = (((_e4678 * _e4216[0]) + (_e4681 * _e4216[1])) + (_e4684 * _e4216[2]));
                                        let _e4694 = (((_e4678 * _e4232) + (_e4681 * _e4233)) + (_e4684 * _e4234));
                                        let _e4699 = (((_e4678 * _e4235) + (_e4681 * _e4236)) + (_e4684 * _e4237));
                                        let _e4704 = (((_e4678 * _e4216[0]) + (_e4681 * _e4216[1])) + (_e4684 * _e4216[2]));
                                        let _e4709 = (((_e4678 * _e4240[0]) + (_e4681 * _e4240[1])) + (_e4684 * _e4240[2]));
                                        let _e4714 = (((_e4678 * _e4256) + (_e4681 * _e4257)) + (_e4684 * _e4258));
                                        let _e4719 = (((_e4678 * _e4259) + (_e4681 * _e4260)) + (_e4684 * _e4261));
                                        let _e4724 = (((_e4678 * _e4240[0]) + (_e4681 * _e4240[1])) + (_e4684 * _e4240[2]));
                                        if (_e4689 < _e4694) {
                                            phi_7770_ = _e4689;
                                        } else {
                                            phi_7770_ = _e4694;
                                        }
                                        let _e4727 = phi_7770_;
                                        if (_e4699 < _e4704) {
                                            phi_7775_ = _e4699;
                                        } else {
                                            phi_7775_ = _e4704;
                                        }
                                        let _e4730 = phi_7775_;
                                        if (_e4727 < _e4730) {
                                            phi_7780_ = _e4727;
                                        } else {
                                            phi_7780_ = _e4730;
                                        }
                                        let _e4733 = phi_7780_;
                                        if (_e4709 < _e4714) {
                                            phi_7785_ = _e4709;
                                        } else {
                                            phi_7785_ = _e4714;
                                        }
                                        let _e4736 = phi_7785_;
                                        if (_e4719 < _e4724) {
                                            phi_7790_ = _e4719;
                                        } else {
                                            phi_7790_ = _e4724;
                                        }
                                        let _e4739 = phi_7790_;
                                        if (_e4736 < _e4739) {
                                            phi_7795_ = _e4736;
                                        } else {
                                            phi_7795_ = _e4739;
                                        }
                                        let _e4742 = phi_7795_;
                                        if (_e4733 < _e4742) {
                                            phi_7800_ = _e4733;
                                        } else {
                                            phi_7800_ = _e4742;
                                        }
                                        let _e4745 = phi_7800_;
                                        if (_e4689 > _e4694) {
                                            phi_7805_ = _e4689;
                                        } else {
                                            phi_7805_ = _e4694;
                                        }
                                        let _e4748 = phi_7805_;
                                        if (_e4699 > _e4704) {
                                            phi_7810_ = _e4699;
                                        } else {
                                            phi_7810_ = _e4704;
                                        }
                                        let _e4751 = phi_7810_;
                                        if (_e4748 > _e4751) {
                                            phi_7815_ = _e4748;
                                        } else {
                                            phi_7815_ = _e4751;
                                        }
                                        let _e4754 = phi_7815_;
                                        if (_e4709 > _e4714) {
                                            phi_7820_ = _e4709;
                                        } else {
                                            phi_7820_ = _e4714;
                                        }
                                        let _e4757 = phi_7820_;
                                        if (_e4719 > _e4724) {
                                            phi_7825_ = _e4719;
                                        } else {
                                            phi_7825_ = _e4724;
                                        }
                                        let _e4760 = phi_7825_;
                                        if (_e4757 > _e4760) {
                                            phi_7830_ = _e4757;
                                        } else {
                                            phi_7830_ = _e4760;
                                        }
                                        let _e4763 = phi_7830_;
                                        if (_e4754 > _e4763) {
                                            phi_7835_ = _e4754;
                                        } else {
                                            phi_7835_ = _e4763;
                                        }
                                        let _e4766 = phi_7835_;
                                        if (_e4678 < 0f) {
                                            phi_7841_ = -(_e4678);
                                        } else {
                                            phi_7841_ = _e4678;
                                        }
                                        let _e4770 = phi_7841_;
                                        if (_e4681 < 0f) {
                                            phi_7847_ = -(_e4681);
                                        } else {
                                            phi_7847_ = _e4681;
                                        }
                                        let _e4774 = phi_7847_;
                                        if (_e4684 < 0f) {
                                            phi_7854_ = -(_e4684);
                                        } else {
                                            phi_7854_ = _e4684;
                                        }
                                        let _e4779 = phi_7854_;
                                        let _e4780 = ((_e4770 + _e4774) + _e4779);
                                        let _e4785 = -(_e4766);
                                        if (_e4745 > _e4785) {
                                            phi_7865_ = _e4745;
                                        } else {
                                            phi_7865_ = _e4785;
                                        }
                                        let _e4788 = phi_7865_;
                                        let _e4793 = (((_e4788 - ((_e4780 * _e4426) * (0.000000059604645f * (17f / 2f)))) - (_e4780 * _e4433)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4672 > _e4793) {
                                            phi_7875_ = _e4672;
                                        } else {
                                            phi_7875_ = _e4793;
                                        }
                                        let _e4796 = phi_7875_;
                                        phi_7879_ = (_e4174 || (_e4796 > 0f));
                                    }
                                    let _e4800 = phi_7879_;
                                    phi_7881_ = (_e3739 && _e4800);
                                } else {
                                    phi_7881_ = _e3739;
                                }
                                let _e4803 = phi_7881_;
                                phi_7883_ = (_e2588 || _e4803);
                            }
                            let _e4806 = phi_7883_;
                            if !(_e4806) {
                                let _e4809 = atomicAdd((&counters[5u]), 1u);
                                hits[_e993] = ((2147483648u | (_e4809 << bitcast<u32>(12i))) | _e996);
                            }
                        }
                        phi_7894_ = true;
                    }
                    let _e4816 = phi_7894_;
                    phi_7895_ = _e4816;
                } else {
                    phi_7895_ = false;
                }
                let _e4818 = phi_7895_;
                continue;
                continuing {
                    phi_1862_ = _e985;
                    break if !(_e4818);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4822 = atomicLoad((&counters[5u]));
                if (_e4822 > 0u) {
                    let _e4825 = atomicAdd((&output.member[0u]), _e4822);
                    if ((_e4825 + _e4822) < _e4825) {
                        let _e4829 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4825);
                }
            }
            workgroupBarrier();
            let _e4832 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4835 = atomicLoad((&counters[7u]));
                if (_e4835 > 0u) {
                    let _e4838 = atomicAdd((&output.member[1u]), _e4835);
                    if ((_e4838 + _e4835) < _e4838) {
                        let _e4842 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7945_ = type_9(0u, 16u);
            loop {
                let _e4844 = phi_7945_;
                if (_e4844.member < _e4844.member_1) {
                    phi_7946_ = type_9((_e4844.member + 1u), _e4844.member_1);
                    phi_7969_ = type_9(1u, _e4844.member);
                } else {
                    phi_7946_ = _e4844;
                    phi_7969_ = type_9(0u, type_9().member_1);
                }
                let _e4856 = phi_7946_;
                let _e4858 = phi_7969_;
                if (bitcast<i32>(_e4858.member) != 0i) {
                    let _e4864 = (_e67 + (_e4858.member_1 * 128u));
                    if (_e4864 >= _e971) {
                        phi_8066_ = false;
                    } else {
                        let _e4867 = hits[_e4864];
                        if ((_e4867 & 2147483648u) == 0u) {
                            phi_7992_ = 4294967295u;
                        } else {
                            phi_7992_ = ((_e4867 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4874 = phi_7992_;
                        if (_e4874 != 4294967295u) {
                            let _e4878 = ((_e4867 >> bitcast<u32>(10i)) & 3u);
                            let _e4885 = firsts[(2u * _e4878)];
                            let _e4888 = leaves.member[(_e4885 + ((_e4867 >> bitcast<u32>(5i)) & 31u))];
                            let _e4892 = firsts[((2u * _e4878) + 1u)];
                            let _e4895 = leaves.member[(_e4892 + (_e4867 & 31u))];
                            let _e4900 = params.member.member_1.member_3;
                            let _e4901 = (_e4832 + _e4874);
                            if (_e4901 < _e4900) {
                                let _e4903 = (2u * _e4901);
                                atomicStore((&output.member[(4u + _e4903)]), _e4888.member_1);
                                atomicStore((&output.member[(_e4903 + 5u)]), _e4895.member_1);
                            }
                        }
                        phi_8066_ = true;
                    }
                    let _e4909 = phi_8066_;
                    phi_8067_ = _e4909;
                } else {
                    phi_8067_ = false;
                }
                let _e4911 = phi_8067_;
                continue;
                continuing {
                    phi_7945_ = _e4856;
                    break if !(_e4911);
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
