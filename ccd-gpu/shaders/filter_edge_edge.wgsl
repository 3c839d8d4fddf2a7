struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<type_11>,
}

struct type_15 {
    member: array<u32>,
}

struct type_16 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_21 {
    member: u32,
    member_1: u32,
}

struct type_24 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_26 {
    member: array<type_24>,
}

struct type_29 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_34 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_38 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> nodes: type_13;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_11, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(2) 
var<storage> leaves: type_18;
@group(0) @binding(3) 
var<storage> bodies: type_15;
@group(0) @binding(4) 
var<storage> keys: type_29;
@group(0) @binding(5) 
var<storage> paths: type_26;
@group(0) @binding(6) 
var<storage> input: type_15;
@group(0) @binding(7) 
var<storage, read_write> output: type_38;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_171_: bool;
    var phi_172_: bool;
    var phi_176_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_172_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_171_ = (param[0] > param_1[0]);
        } else {
            phi_171_ = false;
        }
        let _e14 = phi_171_;
        phi_172_ = _e14;
    }
    let _e16 = phi_172_;
    if _e16 {
        phi_176_ = param_1;
    } else {
        phi_176_ = param;
    }
    let _e18 = phi_176_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_195_: bool;
    var phi_196_: bool;
    var phi_200_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_196_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_195_ = (param_3[0] > param_2[0]);
        } else {
            phi_195_ = false;
        }
        let _e14 = phi_195_;
        phi_196_ = _e14;
    }
    let _e16 = phi_196_;
    if _e16 {
        phi_200_ = param_3;
    } else {
        phi_200_ = param_2;
    }
    let _e18 = phi_200_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_219_: bool;
    var phi_220_: bool;
    var phi_224_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_220_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_219_ = (param_4[0] > param_5[0]);
        } else {
            phi_219_ = false;
        }
        let _e14 = phi_219_;
        phi_220_ = _e14;
    }
    let _e16 = phi_220_;
    if _e16 {
        phi_224_ = param_5;
    } else {
        phi_224_ = param_4;
    }
    let _e18 = phi_224_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_243_: bool;
    var phi_244_: bool;
    var phi_248_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_244_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_243_ = (param_7[0] > param_6[0]);
        } else {
            phi_243_ = false;
        }
        let _e14 = phi_243_;
        phi_244_ = _e14;
    }
    let _e16 = phi_244_;
    if _e16 {
        phi_248_ = param_7;
    } else {
        phi_248_ = param_6;
    }
    let _e18 = phi_248_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_267_: bool;
    var phi_268_: bool;
    var phi_272_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_268_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_267_ = (param_8[0] > param_9[0]);
        } else {
            phi_267_ = false;
        }
        let _e14 = phi_267_;
        phi_268_ = _e14;
    }
    let _e16 = phi_268_;
    if _e16 {
        phi_272_ = param_9;
    } else {
        phi_272_ = param_8;
    }
    let _e18 = phi_272_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_291_: bool;
    var phi_292_: bool;
    var phi_296_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_292_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_291_ = (param_11[0] > param_10[0]);
        } else {
            phi_291_ = false;
        }
        let _e14 = phi_291_;
        phi_292_ = _e14;
    }
    let _e16 = phi_292_;
    if _e16 {
        phi_296_ = param_11;
    } else {
        phi_296_ = param_10;
    }
    let _e18 = phi_296_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_34;
    var local_1: type_34;
    var local_2: type_34;
    var phi_342_: u32;
    var phi_380_: u32;
    var phi_381_: u32;
    var phi_388_: u32;
    var phi_404_: u32;
    var phi_425_: u32;
    var phi_426_: u32;
    var phi_429_: type_21;
    var phi_430_: type_21;
    var phi_453_: type_21;
    var phi_491_: u32;
    var phi_492_: u32;
    var phi_499_: u32;
    var phi_509_: u32;
    var phi_588_: array<u32, 2>;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_787_: type_11;
    var phi_800_: type_21;
    var phi_803_: u32;
    var phi_801_: type_21;
    var phi_826_: type_21;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_894_: bool;
    var phi_898_: bool;
    var phi_916_: u32;
    var phi_917_: u32;
    var phi_918_: u32;
    var phi_804_: u32;
    var phi_921_: type_21;
    var phi_924_: u32;
    var phi_922_: type_21;
    var phi_947_: type_21;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1073_: bool;
    var phi_1037_: bool;
    var phi_1038_: bool;
    var phi_1039_: bool;
    var phi_1043_: bool;
    var phi_1074_: bool;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1123_: bool;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1138_: bool;
    var phi_1139_: bool;
    var phi_1275_: bool;
    var phi_1276_: bool;
    var phi_1369_: bool;
    var phi_1370_: bool;
    var phi_1464_: bool;
    var phi_1465_: bool;
    var phi_1558_: bool;
    var phi_1559_: bool;
    var phi_1654_: bool;
    var phi_1655_: bool;
    var phi_1748_: bool;
    var phi_1749_: bool;
    var phi_1753_: bool;
    var phi_1754_: bool;
    var phi_1755_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1767_: bool;
    var phi_1785_: type_21;
    var phi_1830_: u32;
    var phi_1831_: bool;
    var phi_925_: u32;
    var phi_1832_: bool;
    var phi_1839_: u32;
    var phi_1842_: type_21;
    var phi_1843_: type_21;
    var phi_1866_: type_21;
    var phi_1992_: bool;
    var phi_1993_: bool;
    var phi_1994_: bool;
    var phi_1995_: bool;
    var phi_1996_: bool;
    var phi_2000_: bool;
    var phi_1964_: bool;
    var phi_1965_: bool;
    var phi_1966_: bool;
    var phi_1970_: bool;
    var phi_2001_: bool;
    var phi_2005_: bool;
    var phi_2006_: bool;
    var phi_2050_: bool;
    var phi_2060_: bool;
    var phi_2061_: bool;
    var phi_2065_: bool;
    var phi_2066_: bool;
    var phi_2202_: bool;
    var phi_2203_: bool;
    var phi_2296_: bool;
    var phi_2297_: bool;
    var phi_2391_: bool;
    var phi_2392_: bool;
    var phi_2485_: bool;
    var phi_2486_: bool;
    var phi_2581_: bool;
    var phi_2582_: bool;
    var phi_2675_: bool;
    var phi_2676_: bool;
    var phi_2680_: bool;
    var phi_2681_: bool;
    var phi_2682_: bool;
    var phi_2686_: bool;
    var phi_2687_: bool;
    var phi_2688_: bool;
    var phi_2689_: bool;
    var phi_2690_: bool;
    var phi_2694_: bool;
    var phi_2706_: type_16;
    var phi_2707_: type_16;
    var phi_3096_: f32;
    var phi_3103_: f32;
    var phi_3108_: f32;
    var phi_3115_: f32;
    var phi_3120_: f32;
    var phi_3133_: f32;
    var phi_3140_: f32;
    var phi_3145_: f32;
    var phi_3152_: f32;
    var phi_3157_: f32;
    var phi_3162_: f32;
    var phi_3179_: f32;
    var phi_3186_: f32;
    var phi_3191_: f32;
    var phi_3198_: f32;
    var phi_3203_: f32;
    var phi_3217_: f32;
    var phi_3224_: f32;
    var phi_3229_: f32;
    var phi_3236_: f32;
    var phi_3241_: f32;
    var phi_3246_: f32;
    var phi_3263_: f32;
    var phi_3270_: f32;
    var phi_3275_: f32;
    var phi_3282_: f32;
    var phi_3287_: f32;
    var phi_3301_: f32;
    var phi_3308_: f32;
    var phi_3313_: f32;
    var phi_3320_: f32;
    var phi_3325_: f32;
    var phi_3330_: f32;
    var phi_3361_: f32;
    var phi_3367_: f32;
    var phi_3374_: f32;
    var phi_3381_: f32;
    var phi_3387_: f32;
    var phi_3394_: f32;
    var phi_3400_: f32;
    var phi_3406_: f32;
    var phi_3412_: f32;
    var phi_3419_: f32;
    var phi_3426_: f32;
    var phi_3450_: f32;
    var phi_3455_: f32;
    var phi_3460_: f32;
    var phi_3465_: f32;
    var phi_3470_: f32;
    var phi_3475_: f32;
    var phi_3485_: f32;
    var phi_3688_: f32;
    var phi_3695_: f32;
    var phi_3700_: f32;
    var phi_3707_: f32;
    var phi_3712_: f32;
    var phi_3725_: f32;
    var phi_3732_: f32;
    var phi_3737_: f32;
    var phi_3744_: f32;
    var phi_3749_: f32;
    var phi_3754_: f32;
    var phi_3771_: f32;
    var phi_3778_: f32;
    var phi_3783_: f32;
    var phi_3790_: f32;
    var phi_3795_: f32;
    var phi_3809_: f32;
    var phi_3816_: f32;
    var phi_3821_: f32;
    var phi_3828_: f32;
    var phi_3833_: f32;
    var phi_3838_: f32;
    var phi_3855_: f32;
    var phi_3862_: f32;
    var phi_3867_: f32;
    var phi_3874_: f32;
    var phi_3879_: f32;
    var phi_3893_: f32;
    var phi_3900_: f32;
    var phi_3905_: f32;
    var phi_3912_: f32;
    var phi_3917_: f32;
    var phi_3922_: f32;
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
    var phi_4065_: f32;
    var phi_4071_: f32;
    var phi_4077_: f32;
    var phi_4084_: f32;
    var phi_4094_: f32;
    var phi_4165_: f32;
    var phi_4170_: f32;
    var phi_4175_: f32;
    var phi_4180_: f32;
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
    var phi_4236_: f32;
    var phi_4242_: f32;
    var phi_4249_: f32;
    var phi_4259_: f32;
    var phi_4269_: f32;
    var phi_4449_: bool;
    var phi_4901_: f32;
    var phi_4908_: f32;
    var phi_4913_: f32;
    var phi_4920_: f32;
    var phi_4925_: f32;
    var phi_4938_: f32;
    var phi_4945_: f32;
    var phi_4950_: f32;
    var phi_4957_: f32;
    var phi_4962_: f32;
    var phi_4967_: f32;
    var phi_4984_: f32;
    var phi_4991_: f32;
    var phi_4996_: f32;
    var phi_5003_: f32;
    var phi_5008_: f32;
    var phi_5022_: f32;
    var phi_5029_: f32;
    var phi_5034_: f32;
    var phi_5041_: f32;
    var phi_5046_: f32;
    var phi_5051_: f32;
    var phi_5068_: f32;
    var phi_5075_: f32;
    var phi_5080_: f32;
    var phi_5087_: f32;
    var phi_5092_: f32;
    var phi_5106_: f32;
    var phi_5113_: f32;
    var phi_5118_: f32;
    var phi_5125_: f32;
    var phi_5130_: f32;
    var phi_5135_: f32;
    var phi_5166_: f32;
    var phi_5172_: f32;
    var phi_5179_: f32;
    var phi_5186_: f32;
    var phi_5192_: f32;
    var phi_5199_: f32;
    var phi_5205_: f32;
    var phi_5211_: f32;
    var phi_5217_: f32;
    var phi_5224_: f32;
    var phi_5231_: f32;
    var phi_5255_: f32;
    var phi_5260_: f32;
    var phi_5265_: f32;
    var phi_5270_: f32;
    var phi_5275_: f32;
    var phi_5280_: f32;
    var phi_5290_: f32;
    var phi_5493_: f32;
    var phi_5500_: f32;
    var phi_5505_: f32;
    var phi_5512_: f32;
    var phi_5517_: f32;
    var phi_5530_: f32;
    var phi_5537_: f32;
    var phi_5542_: f32;
    var phi_5549_: f32;
    var phi_5554_: f32;
    var phi_5559_: f32;
    var phi_5576_: f32;
    var phi_5583_: f32;
    var phi_5588_: f32;
    var phi_5595_: f32;
    var phi_5600_: f32;
    var phi_5614_: f32;
    var phi_5621_: f32;
    var phi_5626_: f32;
    var phi_5633_: f32;
    var phi_5638_: f32;
    var phi_5643_: f32;
    var phi_5660_: f32;
    var phi_5667_: f32;
    var phi_5672_: f32;
    var phi_5679_: f32;
    var phi_5684_: f32;
    var phi_5698_: f32;
    var phi_5705_: f32;
    var phi_5710_: f32;
    var phi_5717_: f32;
    var phi_5722_: f32;
    var phi_5727_: f32;
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
    var phi_5899_: f32;
    var phi_5970_: f32;
    var phi_5975_: f32;
    var phi_5980_: f32;
    var phi_5985_: f32;
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
    var phi_6041_: f32;
    var phi_6047_: f32;
    var phi_6054_: f32;
    var phi_6064_: f32;
    var phi_6074_: f32;
    var phi_6254_: bool;
    var phi_6499_: f32;
    var phi_6506_: f32;
    var phi_6511_: f32;
    var phi_6518_: f32;
    var phi_6523_: f32;
    var phi_6536_: f32;
    var phi_6543_: f32;
    var phi_6548_: f32;
    var phi_6555_: f32;
    var phi_6560_: f32;
    var phi_6565_: f32;
    var phi_6582_: f32;
    var phi_6589_: f32;
    var phi_6594_: f32;
    var phi_6601_: f32;
    var phi_6606_: f32;
    var phi_6620_: f32;
    var phi_6627_: f32;
    var phi_6632_: f32;
    var phi_6639_: f32;
    var phi_6644_: f32;
    var phi_6649_: f32;
    var phi_6666_: f32;
    var phi_6673_: f32;
    var phi_6678_: f32;
    var phi_6685_: f32;
    var phi_6690_: f32;
    var phi_6704_: f32;
    var phi_6711_: f32;
    var phi_6716_: f32;
    var phi_6723_: f32;
    var phi_6728_: f32;
    var phi_6733_: f32;
    var phi_6764_: f32;
    var phi_6770_: f32;
    var phi_6777_: f32;
    var phi_6784_: f32;
    var phi_6790_: f32;
    var phi_6797_: f32;
    var phi_6803_: f32;
    var phi_6809_: f32;
    var phi_6815_: f32;
    var phi_6822_: f32;
    var phi_6829_: f32;
    var phi_6853_: f32;
    var phi_6858_: f32;
    var phi_6863_: f32;
    var phi_6868_: f32;
    var phi_6873_: f32;
    var phi_6878_: f32;
    var phi_6888_: f32;
    var phi_7091_: f32;
    var phi_7098_: f32;
    var phi_7103_: f32;
    var phi_7110_: f32;
    var phi_7115_: f32;
    var phi_7128_: f32;
    var phi_7135_: f32;
    var phi_7140_: f32;
    var phi_7147_: f32;
    var phi_7152_: f32;
    var phi_7157_: f32;
    var phi_7174_: f32;
    var phi_7181_: f32;
    var phi_7186_: f32;
    var phi_7193_: f32;
    var phi_7198_: f32;
    var phi_7212_: f32;
    var phi_7219_: f32;
    var phi_7224_: f32;
    var phi_7231_: f32;
    var phi_7236_: f32;
    var phi_7241_: f32;
    var phi_7258_: f32;
    var phi_7265_: f32;
    var phi_7270_: f32;
    var phi_7277_: f32;
    var phi_7282_: f32;
    var phi_7296_: f32;
    var phi_7303_: f32;
    var phi_7308_: f32;
    var phi_7315_: f32;
    var phi_7320_: f32;
    var phi_7325_: f32;
    var phi_7403_: f32;
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
    var phi_7474_: f32;
    var phi_7480_: f32;
    var phi_7487_: f32;
    var phi_7497_: f32;
    var phi_7568_: f32;
    var phi_7573_: f32;
    var phi_7578_: f32;
    var phi_7583_: f32;
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
    var phi_7639_: f32;
    var phi_7645_: f32;
    var phi_7652_: f32;
    var phi_7662_: f32;
    var phi_7672_: f32;
    var phi_7852_: bool;
    var phi_7853_: bool;
    var phi_7855_: bool;
    var phi_7865_: bool;
    var phi_7866_: bool;
    var phi_7916_: type_21;
    var phi_7917_: type_21;
    var phi_7940_: type_21;
    var phi_7963_: u32;
    var phi_8017_: type_21;
    var phi_8038_: bool;
    var phi_8039_: bool;
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
    let _e85 = params.member.member_15;
    let _e87 = input.member[0u];
    if (_e85 < _e87) {
        phi_342_ = _e85;
    } else {
        phi_342_ = _e87;
    }
    let _e90 = phi_342_;
    let _e91 = (_e67 / 32u);
    let _e92 = (_e67 % 32u);
    let _e94 = params.member.member_12;
    if (_e90 > _e94) {
        let _e97 = params.member.member_12;
        let _e98 = (_e90 - _e97);
        let _e100 = params.member.member_13;
        if (_e100 == 0u) {
            return;
        }
        let _e102 = (_e98 / _e100);
        if (_e100 == 0u) {
            return;
        }
        if ((_e98 % _e100) > 0u) {
            phi_380_ = (_e102 + 1u);
        } else {
            phi_380_ = _e102;
        }
        let _e108 = phi_380_;
        phi_381_ = _e108;
    } else {
        phi_381_ = 0u;
    }
    let _e110 = phi_381_;
    let _e112 = params.member.member_14;
    if (_e112 < _e110) {
        phi_388_ = _e112;
    } else {
        phi_388_ = _e110;
    }
    let _e115 = phi_388_;
    let _e116 = (_e115 / 4u);
    if ((_e115 % 4u) > 0u) {
        phi_404_ = (_e116 + 1u);
    } else {
        phi_404_ = _e116;
    }
    let _e121 = phi_404_;
    if (_e121 > _e80) {
        let _e123 = (_e121 - _e80);
        if (_e83 == 0u) {
            return;
        }
        let _e125 = (_e123 / _e83);
        if (_e83 == 0u) {
            return;
        }
        if ((_e123 % _e83) > 0u) {
            phi_425_ = (_e125 + 1u);
        } else {
            phi_425_ = _e125;
        }
        let _e131 = phi_425_;
        phi_426_ = _e131;
    } else {
        phi_426_ = 0u;
    }
    let _e133 = phi_426_;
    phi_429_ = type_21(0u, _e133);
    loop {
        let _e136 = phi_429_;
        if (_e136.member < _e136.member_1) {
            phi_430_ = type_21((_e136.member + 1u), _e136.member_1);
            phi_453_ = type_21(1u, _e136.member);
        } else {
            phi_430_ = _e136;
            phi_453_ = type_21(0u, type_21().member_1);
        }
        let _e148 = phi_430_;
        let _e150 = phi_453_;
        let _e154 = (bitcast<i32>(_e150.member) != 0i);
        if _e154 {
            let _e158 = (((_e80 + (_e150.member_1 * _e83)) * 4u) + _e91);
            let _e160 = params.member.member_12;
            if (_e90 > _e160) {
                let _e163 = params.member.member_12;
                let _e164 = (_e90 - _e163);
                let _e166 = params.member.member_13;
                if (_e166 == 0u) {
                    return;
                }
                let _e168 = (_e164 / _e166);
                if (_e166 == 0u) {
                    return;
                }
                if ((_e164 % _e166) > 0u) {
                    phi_491_ = (_e168 + 1u);
                } else {
                    phi_491_ = _e168;
                }
                let _e174 = phi_491_;
                phi_492_ = _e174;
            } else {
                phi_492_ = 0u;
            }
            let _e176 = phi_492_;
            let _e178 = params.member.member_14;
            if (_e178 < _e176) {
                phi_499_ = _e178;
            } else {
                phi_499_ = _e176;
            }
            let _e181 = phi_499_;
            let _e182 = (_e158 < _e181);
            let _e184 = params.member.member_12;
            if _e182 {
                let _e186 = params.member.member_13;
                phi_509_ = (_e158 * _e186);
            } else {
                phi_509_ = 0u;
            }
            let _e189 = phi_509_;
            let _e191 = (2u * (_e184 + _e189));
            let _e194 = input.member[(4u + _e191)];
            let _e197 = input.member[(_e191 + 5u)];
            if (_e67 < 8u) {
                atomicStore((&counters[_e67]), 0u);
            }
            workgroupBarrier();
            let _e204 = params.member.member_20[0u][1u];
            let _e205 = (_e204 + (_e194 * 32u));
            let _e210 = params.member.member_20[0u][1u];
            let _e211 = (_e210 + (_e197 * 32u));
            if (_e92 == 0u) {
                firsts[(2u * _e91)] = _e205;
                firsts[((2u * _e91) + 1u)] = _e211;
            }
            let _e219 = params.member.member_8;
            if (_e219 == 0u) {
                phi_588_ = array<u32, 2>(0u, 2u);
            } else {
                phi_588_ = array<u32, 2>(1u, 1u);
            }
            let _e222 = phi_588_;
            let _e225 = (_e67 / 32u);
            let _e226 = (_e67 % 32u);
            let _e228 = params.member.member_9;
            let _e232 = params.member.member_20[_e228][_e222[0]];
            let _e235 = nodes.member[(_e232 + _e194)];
            let _e237 = params.member.member_9;
            let _e241 = params.member.member_20[_e237][_e222[1]];
            let _e244 = nodes.member[(_e241 + _e197)];
            let _e246 = params.member.member_9;
            let _e253 = params.member.member_20[(_e246 - 1u)][_e222[0]];
            let _e256 = nodes.member[(_e253 + ((_e194 * 32u) + _e226))];
            let _e258 = params.member.member_9;
            let _e265 = params.member.member_20[(_e258 - 1u)][_e222[1]];
            let _e268 = nodes.member[(_e265 + ((_e197 * 32u) + _e226))];
            if _e182 {
                if ((((((_e268.member[0] <= _e235.member_1[0]) && (_e235.member[0] <= _e268.member_1[0])) && (_e268.member[1] <= _e235.member_1[1])) && (_e235.member[1] <= _e268.member_1[1])) && (_e268.member[2] <= _e235.member_1[2])) && (_e235.member[2] <= _e268.member_1[2])) {
                    let _e306 = atomicAdd((&counters[_e225]), 1u);
                    let _e307 = ((_e225 * 32u) + _e306);
                    columns[_e307] = type_11(array<f32, 3>(_e268.member[0], _e268.member[1], _e268.member[2]), array<f32, 3>(_e268.member_1[0], _e268.member_1[1], _e268.member_1[2]));
                    names[_e307] = _e226;
                }
            }
            workgroupBarrier();
            if _e182 {
                if ((((((_e256.member[0] <= _e244.member_1[0]) && (_e244.member[0] <= _e256.member_1[0])) && (_e256.member[1] <= _e244.member_1[1])) && (_e244.member[1] <= _e256.member_1[1])) && (_e256.member[2] <= _e244.member_1[2])) && (_e244.member[2] <= _e256.member_1[2])) {
                    phi_782_ = false;
                } else {
                    phi_782_ = true;
                }
                let _e357 = phi_782_;
                phi_783_ = _e357;
            } else {
                phi_783_ = true;
            }
            let _e359 = phi_783_;
            if _e359 {
                phi_787_ = type_11(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_787_ = _e256;
            }
            let _e361 = phi_787_;
            let _e363 = (_e67 / 32u);
            let _e364 = (_e67 % 32u);
            let _e366 = atomicLoad((&counters[_e363]));
            phi_800_ = type_21(0u, _e366);
            phi_803_ = 0u;
            loop {
                let _e369 = phi_800_;
                let _e371 = phi_803_;
                local_3 = _e371;
                if (_e369.member < _e369.member_1) {
                    phi_801_ = type_21((_e369.member + 1u), _e369.member_1);
                    phi_826_ = type_21(1u, _e369.member);
                } else {
                    phi_801_ = _e369;
                    phi_826_ = type_21(0u, type_21().member_1);
                }
                let _e383 = phi_801_;
                let _e385 = phi_826_;
                let _e389 = (bitcast<i32>(_e385.member) != 0i);
                if _e389 {
                    let _e393 = names[((_e363 * 32u) + _e385.member_1)];
                    let _e397 = columns[((_e363 * 32u) + _e385.member_1)];
                    if ((((((_e361.member[0] <= _e397.member_1[0]) && (_e397.member[0] <= _e361.member_1[0])) && (_e361.member[1] <= _e397.member_1[1])) && (_e397.member[1] <= _e361.member_1[1])) && (_e361.member[2] <= _e397.member_1[2])) && (_e397.member[2] <= _e361.member_1[2])) {
                        if (_e194 == _e197) {
                            let _e429 = (_e364 < _e393);
                            if _e429 {
                                phi_892_ = bool();
                            } else {
                                phi_892_ = false;
                            }
                            let _e431 = phi_892_;
                            phi_893_ = _e431;
                            phi_894_ = _e429;
                        } else {
                            phi_893_ = bool();
                            phi_894_ = true;
                        }
                        let _e433 = phi_893_;
                        let _e435 = phi_894_;
                        if _e435 {
                            phi_898_ = true;
                        } else {
                            phi_898_ = _e433;
                        }
                        let _e437 = phi_898_;
                        if _e437 {
                            let _e439 = atomicAdd((&counters[4u]), 1u);
                            if (_e439 < 2048u) {
                                hits[_e439] = (((_e363 << bitcast<u32>(10i)) | (_e364 << bitcast<u32>(5i))) | _e393);
                                phi_916_ = _e371;
                            } else {
                                phi_916_ = (_e371 | (1u << bitcast<u32>((_e385.member_1 & 31u))));
                            }
                            let _e453 = phi_916_;
                            phi_917_ = _e453;
                        } else {
                            phi_917_ = _e371;
                        }
                        let _e455 = phi_917_;
                        phi_918_ = _e455;
                    } else {
                        phi_918_ = _e371;
                    }
                    let _e457 = phi_918_;
                    phi_804_ = _e457;
                } else {
                    phi_804_ = u32();
                }
                let _e459 = phi_804_;
                continue;
                continuing {
                    phi_800_ = _e383;
                    phi_803_ = _e459;
                    break if !(_e389);
                }
            }
            phi_921_ = type_21(0u, 32u);
            let _e4661 = local_3;
            phi_924_ = _e4661;
            loop {
                let _e462 = phi_921_;
                let _e464 = phi_924_;
                if (_e462.member < _e462.member_1) {
                    phi_922_ = type_21((_e462.member + 1u), _e462.member_1);
                    phi_947_ = type_21(1u, _e462.member);
                } else {
                    phi_922_ = _e462;
                    phi_947_ = type_21(0u, type_21().member_1);
                }
                let _e476 = phi_922_;
                let _e478 = phi_947_;
                if (bitcast<i32>(_e478.member) != 0i) {
                    if (_e464 == 0u) {
                        phi_1830_ = u32();
                        phi_1831_ = false;
                    } else {
                        let _e489 = names[((_e91 * 32u) + select(firstTrailingBit(_e464), 32u, (_e464 == 0u)))];
                        let _e492 = (_e205 + _e92);
                        let _e493 = (_e211 + _e489);
                        let _e495 = leaves.member[_e492];
                        let _e497 = leaves.member[_e493];
                        let _e499 = nodes.member[_e492];
                        let _e501 = nodes.member[_e493];
                        let _e503 = params.member.member_1;
                        if ((_e503 & 1u) != 0u) {
                            let _e507 = params.member.member_8;
                            if (_e507 == 0u) {
                                if (_e495.member[0] == _e497.member[0]) {
                                    phi_1038_ = bool();
                                    phi_1039_ = true;
                                } else {
                                    let _e550 = (_e495.member[0] == _e497.member[1]);
                                    if _e550 {
                                        phi_1037_ = bool();
                                    } else {
                                        phi_1037_ = (_e495.member[0] == _e497.member[2]);
                                    }
                                    let _e557 = phi_1037_;
                                    phi_1038_ = _e557;
                                    phi_1039_ = _e550;
                                }
                                let _e559 = phi_1038_;
                                let _e561 = phi_1039_;
                                if _e561 {
                                    phi_1043_ = true;
                                } else {
                                    phi_1043_ = _e559;
                                }
                                let _e563 = phi_1043_;
                                phi_1074_ = _e563;
                            } else {
                                if (_e495.member[0] == _e497.member[0]) {
                                    phi_1068_ = bool();
                                    phi_1069_ = true;
                                } else {
                                    if (_e495.member[0] == _e497.member[1]) {
                                        phi_1066_ = bool();
                                        phi_1067_ = true;
                                    } else {
                                        let _e523 = (_e495.member[1] == _e497.member[0]);
                                        if _e523 {
                                            phi_1065_ = bool();
                                        } else {
                                            phi_1065_ = (_e495.member[1] == _e497.member[1]);
                                        }
                                        let _e530 = phi_1065_;
                                        phi_1066_ = _e530;
                                        phi_1067_ = _e523;
                                    }
                                    let _e532 = phi_1066_;
                                    let _e534 = phi_1067_;
                                    phi_1068_ = _e532;
                                    phi_1069_ = _e534;
                                }
                                let _e536 = phi_1068_;
                                let _e538 = phi_1069_;
                                if _e538 {
                                    phi_1073_ = true;
                                } else {
                                    phi_1073_ = _e536;
                                }
                                let _e540 = phi_1073_;
                                phi_1074_ = _e540;
                            }
                            let _e565 = phi_1074_;
                            if _e565 {
                                phi_1078_ = false;
                            } else {
                                phi_1078_ = true;
                            }
                            let _e567 = phi_1078_;
                            phi_1079_ = _e567;
                        } else {
                            phi_1079_ = true;
                        }
                        let _e569 = phi_1079_;
                        if _e569 {
                            let _e571 = params.member.member_1;
                            if ((_e571 & 2u) != 0u) {
                                let _e577 = bodies.member[_e495.member[0]];
                                let _e581 = bodies.member[_e497.member[0]];
                                if ((_e577 / 2u) == (_e581 / 2u)) {
                                    let _e586 = params.member.member_1;
                                    phi_1123_ = !(((_e586 & 4u) != 0u));
                                } else {
                                    phi_1123_ = false;
                                }
                                let _e591 = phi_1123_;
                                if _e591 {
                                    phi_1134_ = true;
                                } else {
                                    if (((_e577 & _e581) & 1u) == 0u) {
                                        phi_1133_ = false;
                                    } else {
                                        phi_1133_ = true;
                                    }
                                    let _e596 = phi_1133_;
                                    phi_1134_ = _e596;
                                }
                                let _e598 = phi_1134_;
                                if _e598 {
                                    phi_1138_ = false;
                                } else {
                                    phi_1138_ = true;
                                }
                                let _e600 = phi_1138_;
                                phi_1139_ = _e600;
                            } else {
                                phi_1139_ = true;
                            }
                            let _e602 = phi_1139_;
                            if _e602 {
                                let _e604 = params.member.member_1;
                                if ((_e604 & 32u) != 0u) {
                                    let _e608 = params.member.member_6;
                                    let _e649 = (((((((_e499.member_1[0] - _e501.member[0]) > _e608) && ((_e501.member_1[0] - _e499.member[0]) > _e608)) && ((_e499.member_1[1] - _e501.member[1]) > _e608)) && ((_e501.member_1[1] - _e499.member[1]) > _e608)) && ((_e499.member_1[2] - _e501.member[2]) > _e608)) && ((_e501.member_1[2] - _e499.member[2]) > _e608));
                                    if _e649 {
                                        phi_1753_ = bool();
                                    } else {
                                        let _e653 = keys.member[_e495.member[0]];
                                        let _e658 = keys.member[_e495.member[1]];
                                        let _e660 = function_(_e653[0], _e658[0]);
                                        let _e664 = keys.member[_e495.member[2]];
                                        let _e666 = function_(_e660, _e664[0]);
                                        let _e670 = keys.member[_e497.member[0]];
                                        let _e675 = keys.member[_e497.member[1]];
                                        let _e677 = function_1(_e670[3], _e675[3]);
                                        let _e681 = keys.member[_e497.member[2]];
                                        let _e683 = function_1(_e677, _e681[3]);
                                        if (_e666[1] > _e683[1]) {
                                            phi_1276_ = true;
                                        } else {
                                            if (_e666[1] == _e683[1]) {
                                                phi_1275_ = (_e666[0] > _e683[0]);
                                            } else {
                                                phi_1275_ = false;
                                            }
                                            let _e694 = phi_1275_;
                                            phi_1276_ = _e694;
                                        }
                                        let _e696 = phi_1276_;
                                        let _e701 = keys.member[_e497.member[0]];
                                        let _e706 = keys.member[_e497.member[1]];
                                        let _e708 = function_(_e701[0], _e706[0]);
                                        let _e712 = keys.member[_e497.member[2]];
                                        let _e714 = function_(_e708, _e712[0]);
                                        let _e718 = keys.member[_e495.member[0]];
                                        let _e723 = keys.member[_e495.member[1]];
                                        let _e725 = function_1(_e718[3], _e723[3]);
                                        let _e729 = keys.member[_e495.member[2]];
                                        let _e731 = function_1(_e725, _e729[3]);
                                        if (_e714[1] > _e731[1]) {
                                            phi_1370_ = true;
                                        } else {
                                            if (_e714[1] == _e731[1]) {
                                                phi_1369_ = (_e714[0] > _e731[0]);
                                            } else {
                                                phi_1369_ = false;
                                            }
                                            let _e742 = phi_1369_;
                                            phi_1370_ = _e742;
                                        }
                                        let _e744 = phi_1370_;
                                        let _e750 = keys.member[_e495.member[0]];
                                        let _e755 = keys.member[_e495.member[1]];
                                        let _e757 = function_2(_e750[1], _e755[1]);
                                        let _e761 = keys.member[_e495.member[2]];
                                        let _e763 = function_2(_e757, _e761[1]);
                                        let _e767 = keys.member[_e497.member[0]];
                                        let _e772 = keys.member[_e497.member[1]];
                                        let _e774 = function_3(_e767[4], _e772[4]);
                                        let _e778 = keys.member[_e497.member[2]];
                                        let _e780 = function_3(_e774, _e778[4]);
                                        if (_e763[1] > _e780[1]) {
                                            phi_1465_ = true;
                                        } else {
                                            if (_e763[1] == _e780[1]) {
                                                phi_1464_ = (_e763[0] > _e780[0]);
                                            } else {
                                                phi_1464_ = false;
                                            }
                                            let _e791 = phi_1464_;
                                            phi_1465_ = _e791;
                                        }
                                        let _e793 = phi_1465_;
                                        let _e798 = keys.member[_e497.member[0]];
                                        let _e803 = keys.member[_e497.member[1]];
                                        let _e805 = function_2(_e798[1], _e803[1]);
                                        let _e809 = keys.member[_e497.member[2]];
                                        let _e811 = function_2(_e805, _e809[1]);
                                        let _e815 = keys.member[_e495.member[0]];
                                        let _e820 = keys.member[_e495.member[1]];
                                        let _e822 = function_3(_e815[4], _e820[4]);
                                        let _e826 = keys.member[_e495.member[2]];
                                        let _e828 = function_3(_e822, _e826[4]);
                                        if (_e811[1] > _e828[1]) {
                                            phi_1559_ = true;
                                        } else {
                                            if (_e811[1] == _e828[1]) {
                                                phi_1558_ = (_e811[0] > _e828[0]);
                                            } else {
                                                phi_1558_ = false;
                                            }
                                            let _e839 = phi_1558_;
                                            phi_1559_ = _e839;
                                        }
                                        let _e841 = phi_1559_;
                                        let _e848 = keys.member[_e495.member[0]];
                                        let _e853 = keys.member[_e495.member[1]];
                                        let _e855 = function_4(_e848[2], _e853[2]);
                                        let _e859 = keys.member[_e495.member[2]];
                                        let _e861 = function_4(_e855, _e859[2]);
                                        let _e865 = keys.member[_e497.member[0]];
                                        let _e870 = keys.member[_e497.member[1]];
                                        let _e872 = function_5(_e865[5], _e870[5]);
                                        let _e876 = keys.member[_e497.member[2]];
                                        let _e878 = function_5(_e872, _e876[5]);
                                        if (_e861[1] > _e878[1]) {
                                            phi_1655_ = true;
                                        } else {
                                            if (_e861[1] == _e878[1]) {
                                                phi_1654_ = (_e861[0] > _e878[0]);
                                            } else {
                                                phi_1654_ = false;
                                            }
                                            let _e889 = phi_1654_;
                                            phi_1655_ = _e889;
                                        }
                                        let _e891 = phi_1655_;
                                        let _e896 = keys.member[_e497.member[0]];
                                        let _e901 = keys.member[_e497.member[1]];
                                        let _e903 = function_4(_e896[2], _e901[2]);
                                        let _e907 = keys.member[_e497.member[2]];
                                        let _e909 = function_4(_e903, _e907[2]);
                                        let _e913 = keys.member[_e495.member[0]];
                                        let _e918 = keys.member[_e495.member[1]];
                                        let _e920 = function_5(_e913[5], _e918[5]);
                                        let _e924 = keys.member[_e495.member[2]];
                                        let _e926 = function_5(_e920, _e924[5]);
                                        if (_e909[1] > _e926[1]) {
                                            phi_1749_ = true;
                                        } else {
                                            if (_e909[1] == _e926[1]) {
                                                phi_1748_ = (_e909[0] > _e926[0]);
                                            } else {
                                                phi_1748_ = false;
                                            }
                                            let _e937 = phi_1748_;
                                            phi_1749_ = _e937;
                                        }
                                        let _e939 = phi_1749_;
                                        phi_1753_ = (((!(_e696) && !(_e744)) && (!(_e793) && !(_e841))) && (!(_e891) && !(_e939)));
                                    }
                                    let _e944 = phi_1753_;
                                    phi_1754_ = _e944;
                                    phi_1755_ = _e649;
                                } else {
                                    phi_1754_ = bool();
                                    phi_1755_ = true;
                                }
                                let _e946 = phi_1754_;
                                let _e948 = phi_1755_;
                                if _e948 {
                                    phi_1759_ = false;
                                } else {
                                    phi_1759_ = true;
                                }
                                let _e950 = phi_1759_;
                                phi_1760_ = _e946;
                                phi_1761_ = _e950;
                            } else {
                                phi_1760_ = false;
                                phi_1761_ = true;
                            }
                            let _e952 = phi_1760_;
                            let _e954 = phi_1761_;
                            phi_1762_ = _e952;
                            phi_1763_ = _e954;
                        } else {
                            phi_1762_ = false;
                            phi_1763_ = true;
                        }
                        let _e956 = phi_1762_;
                        let _e958 = phi_1763_;
                        if _e958 {
                            phi_1767_ = _e956;
                        } else {
                            phi_1767_ = true;
                        }
                        let _e960 = phi_1767_;
                        if _e960 {
                            let _e962 = params.member.member_16;
                            if (_e495.member_1 < _e497.member_1) {
                                phi_1785_ = type_21(_e495.member_1, _e497.member_1);
                            } else {
                                phi_1785_ = type_21(_e497.member_1, _e495.member_1);
                            }
                            let _e969 = phi_1785_;
                            let _e973 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e973 + 1u) < _e973) {
                                let _e977 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e973 < _e962) {
                                atomicStore((&output.member[(4u + (2u * _e973))]), _e969.member);
                                atomicStore((&output.member[((2u * _e973) + 5u)]), _e969.member_1);
                            }
                            let _e986 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e986 + 1u) < _e986) {
                                let _e990 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1830_ = (_e464 & (_e464 - 1u));
                        phi_1831_ = true;
                    }
                    let _e992 = phi_1830_;
                    let _e994 = phi_1831_;
                    phi_925_ = _e992;
                    phi_1832_ = _e994;
                } else {
                    phi_925_ = u32();
                    phi_1832_ = false;
                }
                let _e996 = phi_925_;
                let _e998 = phi_1832_;
                continue;
                continuing {
                    phi_921_ = _e476;
                    phi_924_ = _e996;
                    break if !(_e998);
                }
            }
            workgroupBarrier();
            let _e1001 = atomicLoad((&counters[4u]));
            if (2048u < _e1001) {
                phi_1839_ = 2048u;
            } else {
                phi_1839_ = _e1001;
            }
            let _e1004 = phi_1839_;
            phi_1842_ = type_21(0u, 16u);
            loop {
                let _e1006 = phi_1842_;
                if (_e1006.member < _e1006.member_1) {
                    phi_1843_ = type_21((_e1006.member + 1u), _e1006.member_1);
                    phi_1866_ = type_21(1u, _e1006.member);
                } else {
                    phi_1843_ = _e1006;
                    phi_1866_ = type_21(0u, type_21().member_1);
                }
                let _e1018 = phi_1843_;
                let _e1020 = phi_1866_;
                if (bitcast<i32>(_e1020.member) != 0i) {
                    let _e1026 = (_e67 + (_e1020.member_1 * 128u));
                    if (_e1026 >= _e1004) {
                        phi_7865_ = false;
                    } else {
                        let _e1029 = hits[_e1026];
                        let _e1032 = ((_e1029 >> bitcast<u32>(10i)) & 3u);
                        let _e1039 = firsts[(2u * _e1032)];
                        let _e1040 = (_e1039 + ((_e1029 >> bitcast<u32>(5i)) & 31u));
                        let _e1044 = firsts[((2u * _e1032) + 1u)];
                        let _e1045 = (_e1044 + (_e1029 & 31u));
                        let _e1047 = leaves.member[_e1040];
                        let _e1049 = leaves.member[_e1045];
                        let _e1051 = nodes.member[_e1040];
                        let _e1053 = nodes.member[_e1045];
                        let _e1055 = params.member.member_1;
                        if ((_e1055 & 1u) != 0u) {
                            let _e1059 = params.member.member_8;
                            if (_e1059 == 0u) {
                                if (_e1047.member[0] == _e1049.member[0]) {
                                    phi_1965_ = bool();
                                    phi_1966_ = true;
                                } else {
                                    let _e1102 = (_e1047.member[0] == _e1049.member[1]);
                                    if _e1102 {
                                        phi_1964_ = bool();
                                    } else {
                                        phi_1964_ = (_e1047.member[0] == _e1049.member[2]);
                                    }
                                    let _e1109 = phi_1964_;
                                    phi_1965_ = _e1109;
                                    phi_1966_ = _e1102;
                                }
                                let _e1111 = phi_1965_;
                                let _e1113 = phi_1966_;
                                if _e1113 {
                                    phi_1970_ = true;
                                } else {
                                    phi_1970_ = _e1111;
                                }
                                let _e1115 = phi_1970_;
                                phi_2001_ = _e1115;
                            } else {
                                if (_e1047.member[0] == _e1049.member[0]) {
                                    phi_1995_ = bool();
                                    phi_1996_ = true;
                                } else {
                                    if (_e1047.member[0] == _e1049.member[1]) {
                                        phi_1993_ = bool();
                                        phi_1994_ = true;
                                    } else {
                                        let _e1075 = (_e1047.member[1] == _e1049.member[0]);
                                        if _e1075 {
                                            phi_1992_ = bool();
                                        } else {
                                            phi_1992_ = (_e1047.member[1] == _e1049.member[1]);
                                        }
                                        let _e1082 = phi_1992_;
                                        phi_1993_ = _e1082;
                                        phi_1994_ = _e1075;
                                    }
                                    let _e1084 = phi_1993_;
                                    let _e1086 = phi_1994_;
                                    phi_1995_ = _e1084;
                                    phi_1996_ = _e1086;
                                }
                                let _e1088 = phi_1995_;
                                let _e1090 = phi_1996_;
                                if _e1090 {
                                    phi_2000_ = true;
                                } else {
                                    phi_2000_ = _e1088;
                                }
                                let _e1092 = phi_2000_;
                                phi_2001_ = _e1092;
                            }
                            let _e1117 = phi_2001_;
                            if _e1117 {
                                phi_2005_ = false;
                            } else {
                                phi_2005_ = true;
                            }
                            let _e1119 = phi_2005_;
                            phi_2006_ = _e1119;
                        } else {
                            phi_2006_ = true;
                        }
                        let _e1121 = phi_2006_;
                        if _e1121 {
                            let _e1123 = params.member.member_1;
                            if ((_e1123 & 2u) != 0u) {
                                let _e1129 = bodies.member[_e1047.member[0]];
                                let _e1133 = bodies.member[_e1049.member[0]];
                                if ((_e1129 / 2u) == (_e1133 / 2u)) {
                                    let _e1138 = params.member.member_1;
                                    phi_2050_ = !(((_e1138 & 4u) != 0u));
                                } else {
                                    phi_2050_ = false;
                                }
                                let _e1143 = phi_2050_;
                                if _e1143 {
                                    phi_2061_ = true;
                                } else {
                                    if (((_e1129 & _e1133) & 1u) == 0u) {
                                        phi_2060_ = false;
                                    } else {
                                        phi_2060_ = true;
                                    }
                                    let _e1148 = phi_2060_;
                                    phi_2061_ = _e1148;
                                }
                                let _e1150 = phi_2061_;
                                if _e1150 {
                                    phi_2065_ = false;
                                } else {
                                    phi_2065_ = true;
                                }
                                let _e1152 = phi_2065_;
                                phi_2066_ = _e1152;
                            } else {
                                phi_2066_ = true;
                            }
                            let _e1154 = phi_2066_;
                            if _e1154 {
                                let _e1156 = params.member.member_1;
                                if ((_e1156 & 32u) != 0u) {
                                    let _e1160 = params.member.member_6;
                                    let _e1201 = (((((((_e1051.member_1[0] - _e1053.member[0]) > _e1160) && ((_e1053.member_1[0] - _e1051.member[0]) > _e1160)) && ((_e1051.member_1[1] - _e1053.member[1]) > _e1160)) && ((_e1053.member_1[1] - _e1051.member[1]) > _e1160)) && ((_e1051.member_1[2] - _e1053.member[2]) > _e1160)) && ((_e1053.member_1[2] - _e1051.member[2]) > _e1160));
                                    if _e1201 {
                                        phi_2680_ = bool();
                                    } else {
                                        let _e1205 = keys.member[_e1047.member[0]];
                                        let _e1210 = keys.member[_e1047.member[1]];
                                        let _e1212 = function_(_e1205[0], _e1210[0]);
                                        let _e1216 = keys.member[_e1047.member[2]];
                                        let _e1218 = function_(_e1212, _e1216[0]);
                                        let _e1222 = keys.member[_e1049.member[0]];
                                        let _e1227 = keys.member[_e1049.member[1]];
                                        let _e1229 = function_1(_e1222[3], _e1227[3]);
                                        let _e1233 = keys.member[_e1049.member[2]];
                                        let _e1235 = function_1(_e1229, _e1233[3]);
                                        if (_e1218[1] > _e1235[1]) {
                                            phi_2203_ = true;
                                        } else {
                                            if (_e1218[1] == _e1235[1]) {
                                                phi_2202_ = (_e1218[0] > _e1235[0]);
                                            } else {
                                                phi_2202_ = false;
                                            }
                                            let _e1246 = phi_2202_;
                                            phi_2203_ = _e1246;
                                        }
                                        let _e1248 = phi_2203_;
                                        let _e1253 = keys.member[_e1049.member[0]];
                                        let _e1258 = keys.member[_e1049.member[1]];
                                        let _e1260 = function_(_e1253[0], _e1258[0]);
                                        let _e1264 = keys.member[_e1049.member[2]];
                                        let _e1266 = function_(_e1260, _e1264[0]);
                                        let _e1270 = keys.member[_e1047.member[0]];
                                        let _e1275 = keys.member[_e1047.member[1]];
                                        let _e1277 = function_1(_e1270[3], _e1275[3]);
                                        let _e1281 = keys.member[_e1047.member[2]];
                                        let _e1283 = function_1(_e1277, _e1281[3]);
                                        if (_e1266[1] > _e1283[1]) {
                                            phi_2297_ = true;
                                        } else {
                                            if (_e1266[1] == _e1283[1]) {
                                                phi_2296_ = (_e1266[0] > _e1283[0]);
                                            } else {
                                                phi_2296_ = false;
                                            }
                                            let _e1294 = phi_2296_;
                                            phi_2297_ = _e1294;
                                        }
                                        let _e1296 = phi_2297_;
                                        let _e1302 = keys.member[_e1047.member[0]];
                                        let _e1307 = keys.member[_e1047.member[1]];
                                        let _e1309 = function_2(_e1302[1], _e1307[1]);
                                        let _e1313 = keys.member[_e1047.member[2]];
                                        let _e1315 = function_2(_e1309, _e1313[1]);
                                        let _e1319 = keys.member[_e1049.member[0]];
                                        let _e1324 = keys.member[_e1049.member[1]];
                                        let _e1326 = function_3(_e1319[4], _e1324[4]);
                                        let _e1330 = keys.member[_e1049.member[2]];
                                        let _e1332 = function_3(_e1326, _e1330[4]);
                                        if (_e1315[1] > _e1332[1]) {
                                            phi_2392_ = true;
                                        } else {
                                            if (_e1315[1] == _e1332[1]) {
                                                phi_2391_ = (_e1315[0] > _e1332[0]);
                                            } else {
                                                phi_2391_ = false;
                                            }
                                            let _e1343 = phi_2391_;
                                            phi_2392_ = _e1343;
                                        }
                                        let _e1345 = phi_2392_;
                                        let _e1350 = keys.member[_e1049.member[0]];
                                        let _e1355 = keys.member[_e1049.member[1]];
                                        let _e1357 = function_2(_e1350[1], _e1355[1]);
                                        let _e1361 = keys.member[_e1049.member[2]];
                                        let _e1363 = function_2(_e1357, _e1361[1]);
                                        let _e1367 = keys.member[_e1047.member[0]];
                                        let _e1372 = keys.member[_e1047.member[1]];
                                        let _e1374 = function_3(_e1367[4], _e1372[4]);
                                        let _e1378 = keys.member[_e1047.member[2]];
                                        let _e1380 = function_3(_e1374, _e1378[4]);
                                        if (_e1363[1] > _e1380[1]) {
                                            phi_2486_ = true;
                                        } else {
                                            if (_e1363[1] == _e1380[1]) {
                                                phi_2485_ = (_e1363[0] > _e1380[0]);
                                            } else {
                                                phi_2485_ = false;
                                            }
                                            let _e1391 = phi_2485_;
                                            phi_2486_ = _e1391;
                                        }
                                        let _e1393 = phi_2486_;
                                        let _e1400 = keys.member[_e1047.member[0]];
                                        let _e1405 = keys.member[_e1047.member[1]];
                                        let _e1407 = function_4(_e1400[2], _e1405[2]);
                                        let _e1411 = keys.member[_e1047.member[2]];
                                        let _e1413 = function_4(_e1407, _e1411[2]);
                                        let _e1417 = keys.member[_e1049.member[0]];
                                        let _e1422 = keys.member[_e1049.member[1]];
                                        let _e1424 = function_5(_e1417[5], _e1422[5]);
                                        let _e1428 = keys.member[_e1049.member[2]];
                                        let _e1430 = function_5(_e1424, _e1428[5]);
                                        if (_e1413[1] > _e1430[1]) {
                                            phi_2582_ = true;
                                        } else {
                                            if (_e1413[1] == _e1430[1]) {
                                                phi_2581_ = (_e1413[0] > _e1430[0]);
                                            } else {
                                                phi_2581_ = false;
                                            }
                                            let _e1441 = phi_2581_;
                                            phi_2582_ = _e1441;
                                        }
                                        let _e1443 = phi_2582_;
                                        let _e1448 = keys.member[_e1049.member[0]];
                                        let _e1453 = keys.member[_e1049.member[1]];
                                        let _e1455 = function_4(_e1448[2], _e1453[2]);
                                        let _e1459 = keys.member[_e1049.member[2]];
                                        let _e1461 = function_4(_e1455, _e1459[2]);
                                        let _e1465 = keys.member[_e1047.member[0]];
                                        let _e1470 = keys.member[_e1047.member[1]];
                                        let _e1472 = function_5(_e1465[5], _e1470[5]);
                                        let _e1476 = keys.member[_e1047.member[2]];
                                        let _e1478 = function_5(_e1472, _e1476[5]);
                                        if (_e1461[1] > _e1478[1]) {
                                            phi_2676_ = true;
                                        } else {
                                            if (_e1461[1] == _e1478[1]) {
                                                phi_2675_ = (_e1461[0] > _e1478[0]);
                                            } else {
                                                phi_2675_ = false;
                                            }
                                            let _e1489 = phi_2675_;
                                            phi_2676_ = _e1489;
                                        }
                                        let _e1491 = phi_2676_;
                                        phi_2680_ = (((!(_e1248) && !(_e1296)) && (!(_e1345) && !(_e1393))) && (!(_e1443) && !(_e1491)));
                                    }
                                    let _e1496 = phi_2680_;
                                    phi_2681_ = _e1496;
                                    phi_2682_ = _e1201;
                                } else {
                                    phi_2681_ = bool();
                                    phi_2682_ = true;
                                }
                                let _e1498 = phi_2681_;
                                let _e1500 = phi_2682_;
                                if _e1500 {
                                    phi_2686_ = false;
                                } else {
                                    phi_2686_ = true;
                                }
                                let _e1502 = phi_2686_;
                                phi_2687_ = _e1498;
                                phi_2688_ = _e1502;
                            } else {
                                phi_2687_ = false;
                                phi_2688_ = true;
                            }
                            let _e1504 = phi_2687_;
                            let _e1506 = phi_2688_;
                            phi_2689_ = _e1504;
                            phi_2690_ = _e1506;
                        } else {
                            phi_2689_ = false;
                            phi_2690_ = true;
                        }
                        let _e1508 = phi_2689_;
                        let _e1510 = phi_2690_;
                        if _e1510 {
                            phi_2694_ = _e1508;
                        } else {
                            phi_2694_ = true;
                        }
                        let _e1512 = phi_2694_;
                        if _e1512 {
                            let _e1514 = atomicAdd((&counters[7u]), 1u);
                            if (_e1047.member_1 < _e1049.member_1) {
                                phi_2706_ = _e1049;
                                phi_2707_ = _e1047;
                            } else {
                                phi_2706_ = _e1047;
                                phi_2707_ = _e1049;
                            }
                            let _e1519 = phi_2706_;
                            let _e1521 = phi_2707_;
                            let _e1523 = params.member.member_4;
                            let _e1525 = params.member.member_5;
                            let _e1535 = paths.member[_e1521.member[0]];
                            let _e1537 = paths.member[_e1521.member[1]];
                            let _e1543 = paths.member[_e1519.member[0]];
                            let _e1545 = paths.member[_e1519.member[1]];
                            local_2 = type_34(array<array<f32, 3>, 2>(array<f32, 3>((_e1543.member[0] - _e1535.member[0]), (_e1543.member[1] - _e1535.member[1]), (_e1543.member[2] - _e1535.member[2])), array<f32, 3>((_e1543.member_1[0] - _e1535.member_1[0]), (_e1543.member_1[1] - _e1535.member_1[1]), (_e1543.member_1[2] - _e1535.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1537.member[0] - _e1535.member[0]), (_e1537.member[1] - _e1535.member[1]), (_e1537.member[2] - _e1535.member[2])), array<f32, 3>((_e1537.member_1[0] - _e1535.member_1[0]), (_e1537.member_1[1] - _e1535.member_1[1]), (_e1537.member_1[2] - _e1535.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1543.member[0] - _e1545.member[0]), (_e1543.member[1] - _e1545.member[1]), (_e1543.member[2] - _e1545.member[2])), array<f32, 3>((_e1543.member_1[0] - _e1545.member_1[0]), (_e1543.member_1[1] - _e1545.member_1[1]), (_e1543.member_1[2] - _e1545.member_1[2]))), (_e1523 + _e1523));
                            let _e1605 = local_2.member_1[0u];
                            let _e1611 = local_2.member_2[0u];
                            let _e1617 = ((_e1605[1] * _e1611[2]) - (_e1605[2] * _e1611[1]));
                            let _e1620 = ((_e1605[2] * _e1611[0]) - (_e1605[0] * _e1611[2]));
                            let _e1623 = ((_e1605[0] * _e1611[1]) - (_e1605[1] * _e1611[0]));
                            let _e1626 = local_2.member_1[1u];
                            let _e1632 = local_2.member_2[1u];
                            let _e1638 = ((_e1626[1] * _e1632[2]) - (_e1626[2] * _e1632[1]));
                            let _e1641 = ((_e1626[2] * _e1632[0]) - (_e1626[0] * _e1632[2]));
                            let _e1644 = ((_e1626[0] * _e1632[1]) - (_e1626[1] * _e1632[0]));
                            let _e1647 = local_2.member_1[0u];
                            let _e1653 = local_2.member_2[1u];
                            let _e1668 = local_2.member_1[1u];
                            let _e1674 = local_2.member_2[0u];
                            let _e1687 = (((_e1647[1] * _e1653[2]) - (_e1647[2] * _e1653[1])) + ((_e1668[1] * _e1674[2]) - (_e1668[2] * _e1674[1])));
                            let _e1688 = (((_e1647[2] * _e1653[0]) - (_e1647[0] * _e1653[2])) + ((_e1668[2] * _e1674[0]) - (_e1668[0] * _e1674[2])));
                            let _e1689 = (((_e1647[0] * _e1653[1]) - (_e1647[1] * _e1653[0])) + ((_e1668[0] * _e1674[1]) - (_e1668[1] * _e1674[0])));
                            let _e1692 = local_2.member[0u];
                            let _e1703 = local_2.member[1u];
                            let _e1714 = local_2.member[0u];
                            let _e1723 = ((((_e1703[0] * _e1617) + (_e1703[1] * _e1620)) + (_e1703[2] * _e1623)) + (((_e1714[0] * _e1687) + (_e1714[1] * _e1688)) + (_e1714[2] * _e1689)));
                            let _e1726 = local_2.member[0u];
                            let _e1737 = local_2.member[1u];
                            let _e1746 = ((((_e1726[0] * _e1638) + (_e1726[1] * _e1641)) + (_e1726[2] * _e1644)) + (((_e1737[0] * _e1687) + (_e1737[1] * _e1688)) + (_e1737[2] * _e1689)));
                            let _e1749 = local_2.member[1u];
                            let _e1760 = local_2.member[0u];
                            if (_e1760[0] < 0f) {
                                phi_3096_ = -(_e1760[0]);
                            } else {
                                phi_3096_ = _e1760[0];
                            }
                            let _e1767 = phi_3096_;
                            if (_e1760[1] < 0f) {
                                phi_3103_ = -(_e1760[1]);
                            } else {
                                phi_3103_ = _e1760[1];
                            }
                            let _e1771 = phi_3103_;
                            if (_e1767 > _e1771) {
                                phi_3108_ = _e1767;
                            } else {
                                phi_3108_ = _e1771;
                            }
                            let _e1774 = phi_3108_;
                            if (_e1760[2] < 0f) {
                                phi_3115_ = -(_e1760[2]);
                            } else {
                                phi_3115_ = _e1760[2];
                            }
                            let _e1778 = phi_3115_;
                            if (_e1774 > _e1778) {
                                phi_3120_ = _e1774;
                            } else {
                                phi_3120_ = _e1778;
                            }
                            let _e1781 = phi_3120_;
                            let _e1784 = local_2.member[1u];
                            if (_e1784[0] < 0f) {
                                phi_3133_ = -(_e1784[0]);
                            } else {
                                phi_3133_ = _e1784[0];
                            }
                            let _e1791 = phi_3133_;
                            if (_e1784[1] < 0f) {
                                phi_3140_ = -(_e1784[1]);
                            } else {
                                phi_3140_ = _e1784[1];
                            }
                            let _e1795 = phi_3140_;
                            if (_e1791 > _e1795) {
                                phi_3145_ = _e1791;
                            } else {
                                phi_3145_ = _e1795;
                            }
                            let _e1798 = phi_3145_;
                            if (_e1784[2] < 0f) {
                                phi_3152_ = -(_e1784[2]);
                            } else {
                                phi_3152_ = _e1784[2];
                            }
                            let _e1802 = phi_3152_;
                            if (_e1798 > _e1802) {
                                phi_3157_ = _e1798;
                            } else {
                                phi_3157_ = _e1802;
                            }
                            let _e1805 = phi_3157_;
                            if (_e1781 > _e1805) {
                                phi_3162_ = _e1781;
                            } else {
                                phi_3162_ = _e1805;
                            }
                            let _e1808 = phi_3162_;
                            let _e1810 = local_2.member_3;
                            let _e1811 = (_e1808 + _e1810);
                            let _e1814 = local_2.member_1[0u];
                            if (_e1814[0] < 0f) {
                                phi_3179_ = -(_e1814[0]);
                            } else {
                                phi_3179_ = _e1814[0];
                            }
                            let _e1821 = phi_3179_;
                            if (_e1814[1] < 0f) {
                                phi_3186_ = -(_e1814[1]);
                            } else {
                                phi_3186_ = _e1814[1];
                            }
                            let _e1825 = phi_3186_;
                            if (_e1821 > _e1825) {
                                phi_3191_ = _e1821;
                            } else {
                                phi_3191_ = _e1825;
                            }
                            let _e1828 = phi_3191_;
                            if (_e1814[2] < 0f) {
                                phi_3198_ = -(_e1814[2]);
                            } else {
                                phi_3198_ = _e1814[2];
                            }
                            let _e1832 = phi_3198_;
                            if (_e1828 > _e1832) {
                                phi_3203_ = _e1828;
                            } else {
                                phi_3203_ = _e1832;
                            }
                            let _e1835 = phi_3203_;
                            let _e1838 = local_2.member_1[1u];
                            if (_e1838[0] < 0f) {
                                phi_3217_ = -(_e1838[0]);
                            } else {
                                phi_3217_ = _e1838[0];
                            }
                            let _e1845 = phi_3217_;
                            if (_e1838[1] < 0f) {
                                phi_3224_ = -(_e1838[1]);
                            } else {
                                phi_3224_ = _e1838[1];
                            }
                            let _e1849 = phi_3224_;
                            if (_e1845 > _e1849) {
                                phi_3229_ = _e1845;
                            } else {
                                phi_3229_ = _e1849;
                            }
                            let _e1852 = phi_3229_;
                            if (_e1838[2] < 0f) {
                                phi_3236_ = -(_e1838[2]);
                            } else {
                                phi_3236_ = _e1838[2];
                            }
                            let _e1856 = phi_3236_;
                            if (_e1852 > _e1856) {
                                phi_3241_ = _e1852;
                            } else {
                                phi_3241_ = _e1856;
                            }
                            let _e1859 = phi_3241_;
                            if (_e1835 > _e1859) {
                                phi_3246_ = _e1835;
                            } else {
                                phi_3246_ = _e1859;
                            }
                            let _e1862 = phi_3246_;
                            let _e1864 = local_2.member_3;
                            let _e1865 = (_e1862 + _e1864);
                            let _e1868 = local_2.member_2[0u];
                            if (_e1868[0] < 0f) {
                                phi_3263_ = -(_e1868[0]);
                            } else {
                                phi_3263_ = _e1868[0];
                            }
                            let _e1875 = phi_3263_;
                            if (_e1868[1] < 0f) {
                                phi_3270_ = -(_e1868[1]);
                            } else {
                                phi_3270_ = _e1868[1];
                            }
                            let _e1879 = phi_3270_;
                            if (_e1875 > _e1879) {
                                phi_3275_ = _e1875;
                            } else {
                                phi_3275_ = _e1879;
                            }
                            let _e1882 = phi_3275_;
                            if (_e1868[2] < 0f) {
                                phi_3282_ = -(_e1868[2]);
                            } else {
                                phi_3282_ = _e1868[2];
                            }
                            let _e1886 = phi_3282_;
                            if (_e1882 > _e1886) {
                                phi_3287_ = _e1882;
                            } else {
                                phi_3287_ = _e1886;
                            }
                            let _e1889 = phi_3287_;
                            let _e1892 = local_2.member_2[1u];
                            if (_e1892[0] < 0f) {
                                phi_3301_ = -(_e1892[0]);
                            } else {
                                phi_3301_ = _e1892[0];
                            }
                            let _e1899 = phi_3301_;
                            if (_e1892[1] < 0f) {
                                phi_3308_ = -(_e1892[1]);
                            } else {
                                phi_3308_ = _e1892[1];
                            }
                            let _e1903 = phi_3308_;
                            if (_e1899 > _e1903) {
                                phi_3313_ = _e1899;
                            } else {
                                phi_3313_ = _e1903;
                            }
                            let _e1906 = phi_3313_;
                            if (_e1892[2] < 0f) {
                                phi_3320_ = -(_e1892[2]);
                            } else {
                                phi_3320_ = _e1892[2];
                            }
                            let _e1910 = phi_3320_;
                            if (_e1906 > _e1910) {
                                phi_3325_ = _e1906;
                            } else {
                                phi_3325_ = _e1910;
                            }
                            let _e1913 = phi_3325_;
                            if (_e1889 > _e1913) {
                                phi_3330_ = _e1889;
                            } else {
                                phi_3330_ = _e1913;
                            }
                            let _e1916 = phi_3330_;
                            let _e1918 = local_2.member_3;
                            let _e1919 = (_e1916 + _e1918);
                            let _e1921 = ((_e1865 * 8f) * _e1919);
                            let _e1928 = local_2.member_3;
                            if (_e1617 < 0f) {
                                phi_3361_ = -(_e1617);
                            } else {
                                phi_3361_ = _e1617;
                            }
                            let _e1945 = phi_3361_;
                            if (_e1620 < 0f) {
                                phi_3367_ = -(_e1620);
                            } else {
                                phi_3367_ = _e1620;
                            }
                            let _e1949 = phi_3367_;
                            if (_e1623 < 0f) {
                                phi_3374_ = -(_e1623);
                            } else {
                                phi_3374_ = _e1623;
                            }
                            let _e1954 = phi_3374_;
                            let _e1955 = ((_e1945 + _e1949) + _e1954);
                            if (_e1638 < 0f) {
                                phi_3381_ = -(_e1638);
                            } else {
                                phi_3381_ = _e1638;
                            }
                            let _e1959 = phi_3381_;
                            if (_e1641 < 0f) {
                                phi_3387_ = -(_e1641);
                            } else {
                                phi_3387_ = _e1641;
                            }
                            let _e1963 = phi_3387_;
                            if (_e1644 < 0f) {
                                phi_3394_ = -(_e1644);
                            } else {
                                phi_3394_ = _e1644;
                            }
                            let _e1968 = phi_3394_;
                            let _e1969 = ((_e1959 + _e1963) + _e1968);
                            if (_e1955 > _e1969) {
                                phi_3400_ = _e1955;
                            } else {
                                phi_3400_ = _e1969;
                            }
                            let _e1972 = phi_3400_;
                            if (_e1687 < 0f) {
                                phi_3406_ = -(_e1687);
                            } else {
                                phi_3406_ = _e1687;
                            }
                            let _e1976 = phi_3406_;
                            if (_e1688 < 0f) {
                                phi_3412_ = -(_e1688);
                            } else {
                                phi_3412_ = _e1688;
                            }
                            let _e1980 = phi_3412_;
                            if (_e1689 < 0f) {
                                phi_3419_ = -(_e1689);
                            } else {
                                phi_3419_ = _e1689;
                            }
                            let _e1985 = phi_3419_;
                            let _e1987 = (((_e1976 + _e1980) + _e1985) * 0.5f);
                            if (_e1972 > _e1987) {
                                phi_3426_ = _e1972;
                            } else {
                                phi_3426_ = _e1987;
                            }
                            let _e1990 = phi_3426_;
                            let _e1995 = local_2.member_3;
                            let _e2008 = ((((_e1692[0] * _e1617) + (_e1692[1] * _e1620)) + (_e1692[2] * _e1623)) * 3f);
                            let _e2009 = ((((_e1749[0] * _e1638) + (_e1749[1] * _e1641)) + (_e1749[2] * _e1644)) * 3f);
                            if (_e2008 < _e2009) {
                                phi_3450_ = _e2008;
                            } else {
                                phi_3450_ = _e2009;
                            }
                            let _e2012 = phi_3450_;
                            if (_e1723 < _e1746) {
                                phi_3455_ = _e1723;
                            } else {
                                phi_3455_ = _e1746;
                            }
                            let _e2015 = phi_3455_;
                            if (_e2012 < _e2015) {
                                phi_3460_ = _e2012;
                            } else {
                                phi_3460_ = _e2015;
                            }
                            let _e2018 = phi_3460_;
                            if (_e2008 > _e2009) {
                                phi_3465_ = _e2008;
                            } else {
                                phi_3465_ = _e2009;
                            }
                            let _e2021 = phi_3465_;
                            if (_e1723 > _e1746) {
                                phi_3470_ = _e1723;
                            } else {
                                phi_3470_ = _e1746;
                            }
                            let _e2024 = phi_3470_;
                            if (_e2021 > _e2024) {
                                phi_3475_ = _e2021;
                            } else {
                                phi_3475_ = _e2024;
                            }
                            let _e2027 = phi_3475_;
                            let _e2032 = -(_e2027);
                            if (_e2018 > _e2032) {
                                phi_3485_ = _e2018;
                            } else {
                                phi_3485_ = _e2032;
                            }
                            let _e2035 = phi_3485_;
                            if ((_e2035 - ((((((_e1811 * 8f) * _e1921) * (0.000000059604645f * (490f / 64f))) + ((_e1928 * 19f) * ((_e1811 * (_e1865 + _e1919)) + (_e1865 * _e1919)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1811) * ((1f + _e1865) * (1f + _e1919))))) + ((_e1525 * (((_e1990 + (_e1921 * (0.000000059604645f * 4f))) + ((_e1995 * 6f) * (_e1865 + _e1919))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1865) * (1f + _e1919))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4449_ = true;
                            } else {
                                let _e2040 = local_2.member_1[0u];
                                let _e2046 = local_2.member_1[1u];
                                let _e2050 = (_e2040[0] + _e2046[0]);
                                let _e2051 = (_e2040[1] + _e2046[1]);
                                let _e2052 = (_e2040[2] + _e2046[2]);
                                let _e2055 = local_2.member_2[0u];
                                let _e2061 = local_2.member_2[1u];
                                let _e2065 = (_e2055[0] + _e2061[0]);
                                let _e2066 = (_e2055[1] + _e2061[1]);
                                let _e2067 = (_e2055[2] + _e2061[2]);
                                let _e2070 = ((_e2051 * _e2067) - (_e2052 * _e2066));
                                let _e2073 = ((_e2052 * _e2065) - (_e2050 * _e2067));
                                let _e2076 = ((_e2050 * _e2066) - (_e2051 * _e2065));
                                let _e2079 = local_2.member[0u];
                                let _e2085 = local_2.member_1[0u];
                                let _e2091 = local_2.member_2[0u];
                                let _e2095 = (_e2079[0] - _e2085[0]);
                                let _e2096 = (_e2079[1] - _e2085[1]);
                                let _e2097 = (_e2079[2] - _e2085[2]);
                                let _e2098 = (_e2095 - _e2091[0]);
                                let _e2099 = (_e2096 - _e2091[1]);
                                let _e2100 = (_e2097 - _e2091[2]);
                                let _e2101 = (_e2079[0] - _e2091[0]);
                                let _e2102 = (_e2079[1] - _e2091[1]);
                                let _e2103 = (_e2079[2] - _e2091[2]);
                                let _e2106 = local_2.member[1u];
                                let _e2112 = local_2.member_1[1u];
                                let _e2118 = local_2.member_2[1u];
                                let _e2122 = (_e2106[0] - _e2112[0]);
                                let _e2123 = (_e2106[1] - _e2112[1]);
                                let _e2124 = (_e2106[2] - _e2112[2]);
                                let _e2125 = (_e2122 - _e2118[0]);
                                let _e2126 = (_e2123 - _e2118[1]);
                                let _e2127 = (_e2124 - _e2118[2]);
                                let _e2128 = (_e2106[0] - _e2118[0]);
                                let _e2129 = (_e2106[1] - _e2118[1]);
                                let _e2130 = (_e2106[2] - _e2118[2]);
                                let _e2133 = local_2.member[0u];
                                if (_e2133[0] < 0f) {
                                    phi_3688_ = -(_e2133[0]);
                                } else {
                                    phi_3688_ = _e2133[0];
                                }
                                let _e2140 = phi_3688_;
                                if (_e2133[1] < 0f) {
                                    phi_3695_ = -(_e2133[1]);
                                } else {
                                    phi_3695_ = _e2133[1];
                                }
                                let _e2144 = phi_3695_;
                                if (_e2140 > _e2144) {
                                    phi_3700_ = _e2140;
                                } else {
                                    phi_3700_ = _e2144;
                                }
                                let _e2147 = phi_3700_;
                                if (_e2133[2] < 0f) {
                                    phi_3707_ = -(_e2133[2]);
                                } else {
                                    phi_3707_ = _e2133[2];
                                }
                                let _e2151 = phi_3707_;
                                if (_e2147 > _e2151) {
                                    phi_3712_ = _e2147;
                                } else {
                                    phi_3712_ = _e2151;
                                }
                                let _e2154 = phi_3712_;
                                let _e2157 = local_2.member[1u];
                                if (_e2157[0] < 0f) {
                                    phi_3725_ = -(_e2157[0]);
                                } else {
                                    phi_3725_ = _e2157[0];
                                }
                                let _e2164 = phi_3725_;
                                if (_e2157[1] < 0f) {
                                    phi_3732_ = -(_e2157[1]);
                                } else {
                                    phi_3732_ = _e2157[1];
                                }
                                let _e2168 = phi_3732_;
                                if (_e2164 > _e2168) {
                                    phi_3737_ = _e2164;
                                } else {
                                    phi_3737_ = _e2168;
                                }
                                let _e2171 = phi_3737_;
                                if (_e2157[2] < 0f) {
                                    phi_3744_ = -(_e2157[2]);
                                } else {
                                    phi_3744_ = _e2157[2];
                                }
                                let _e2175 = phi_3744_;
                                if (_e2171 > _e2175) {
                                    phi_3749_ = _e2171;
                                } else {
                                    phi_3749_ = _e2175;
                                }
                                let _e2178 = phi_3749_;
                                if (_e2154 > _e2178) {
                                    phi_3754_ = _e2154;
                                } else {
                                    phi_3754_ = _e2178;
                                }
                                let _e2181 = phi_3754_;
                                let _e2183 = local_2.member_3;
                                let _e2187 = local_2.member_1[0u];
                                if (_e2187[0] < 0f) {
                                    phi_3771_ = -(_e2187[0]);
                                } else {
                                    phi_3771_ = _e2187[0];
                                }
                                let _e2194 = phi_3771_;
                                if (_e2187[1] < 0f) {
                                    phi_3778_ = -(_e2187[1]);
                                } else {
                                    phi_3778_ = _e2187[1];
                                }
                                let _e2198 = phi_3778_;
                                if (_e2194 > _e2198) {
                                    phi_3783_ = _e2194;
                                } else {
                                    phi_3783_ = _e2198;
                                }
                                let _e2201 = phi_3783_;
                                if (_e2187[2] < 0f) {
                                    phi_3790_ = -(_e2187[2]);
                                } else {
                                    phi_3790_ = _e2187[2];
                                }
                                let _e2205 = phi_3790_;
                                if (_e2201 > _e2205) {
                                    phi_3795_ = _e2201;
                                } else {
                                    phi_3795_ = _e2205;
                                }
                                let _e2208 = phi_3795_;
                                let _e2211 = local_2.member_1[1u];
                                if (_e2211[0] < 0f) {
                                    phi_3809_ = -(_e2211[0]);
                                } else {
                                    phi_3809_ = _e2211[0];
                                }
                                let _e2218 = phi_3809_;
                                if (_e2211[1] < 0f) {
                                    phi_3816_ = -(_e2211[1]);
                                } else {
                                    phi_3816_ = _e2211[1];
                                }
                                let _e2222 = phi_3816_;
                                if (_e2218 > _e2222) {
                                    phi_3821_ = _e2218;
                                } else {
                                    phi_3821_ = _e2222;
                                }
                                let _e2225 = phi_3821_;
                                if (_e2211[2] < 0f) {
                                    phi_3828_ = -(_e2211[2]);
                                } else {
                                    phi_3828_ = _e2211[2];
                                }
                                let _e2229 = phi_3828_;
                                if (_e2225 > _e2229) {
                                    phi_3833_ = _e2225;
                                } else {
                                    phi_3833_ = _e2229;
                                }
                                let _e2232 = phi_3833_;
                                if (_e2208 > _e2232) {
                                    phi_3838_ = _e2208;
                                } else {
                                    phi_3838_ = _e2232;
                                }
                                let _e2235 = phi_3838_;
                                let _e2237 = local_2.member_3;
                                let _e2241 = local_2.member_2[0u];
                                if (_e2241[0] < 0f) {
                                    phi_3855_ = -(_e2241[0]);
                                } else {
                                    phi_3855_ = _e2241[0];
                                }
                                let _e2248 = phi_3855_;
                                if (_e2241[1] < 0f) {
                                    phi_3862_ = -(_e2241[1]);
                                } else {
                                    phi_3862_ = _e2241[1];
                                }
                                let _e2252 = phi_3862_;
                                if (_e2248 > _e2252) {
                                    phi_3867_ = _e2248;
                                } else {
                                    phi_3867_ = _e2252;
                                }
                                let _e2255 = phi_3867_;
                                if (_e2241[2] < 0f) {
                                    phi_3874_ = -(_e2241[2]);
                                } else {
                                    phi_3874_ = _e2241[2];
                                }
                                let _e2259 = phi_3874_;
                                if (_e2255 > _e2259) {
                                    phi_3879_ = _e2255;
                                } else {
                                    phi_3879_ = _e2259;
                                }
                                let _e2262 = phi_3879_;
                                let _e2265 = local_2.member_2[1u];
                                if (_e2265[0] < 0f) {
                                    phi_3893_ = -(_e2265[0]);
                                } else {
                                    phi_3893_ = _e2265[0];
                                }
                                let _e2272 = phi_3893_;
                                if (_e2265[1] < 0f) {
                                    phi_3900_ = -(_e2265[1]);
                                } else {
                                    phi_3900_ = _e2265[1];
                                }
                                let _e2276 = phi_3900_;
                                if (_e2272 > _e2276) {
                                    phi_3905_ = _e2272;
                                } else {
                                    phi_3905_ = _e2276;
                                }
                                let _e2279 = phi_3905_;
                                if (_e2265[2] < 0f) {
                                    phi_3912_ = -(_e2265[2]);
                                } else {
                                    phi_3912_ = _e2265[2];
                                }
                                let _e2283 = phi_3912_;
                                if (_e2279 > _e2283) {
                                    phi_3917_ = _e2279;
                                } else {
                                    phi_3917_ = _e2283;
                                }
                                let _e2286 = phi_3917_;
                                if (_e2262 > _e2286) {
                                    phi_3922_ = _e2262;
                                } else {
                                    phi_3922_ = _e2286;
                                }
                                let _e2289 = phi_3922_;
                                let _e2291 = local_2.member_3;
                                let _e2294 = (((_e2181 + _e2183) + (_e2235 + _e2237)) + (_e2289 + _e2291));
                                let _e2297 = local_2.member_3;
                                let _e2301 = (((_e1525 * 1.0001f) + (_e2297 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2304 = ((_e2073 * _e2052) - (_e2076 * _e2051));
                                let _e2307 = ((_e2076 * _e2050) - (_e2070 * _e2052));
                                let _e2310 = ((_e2070 * _e2051) - (_e2073 * _e2050));
                                let _e2315 = (((_e2304 * _e2079[0]) + (_e2307 * _e2079[1])) + (_e2310 * _e2079[2]));
                                let _e2320 = (((_e2304 * _e2095) + (_e2307 * _e2096)) + (_e2310 * _e2097));
                                let _e2325 = (((_e2304 * _e2101) + (_e2307 * _e2102)) + (_e2310 * _e2103));
                                let _e2330 = (((_e2304 * _e2098) + (_e2307 * _e2099)) + (_e2310 * _e2100));
                                let _e2335 = (((_e2304 * _e2106[0]) + (_e2307 * _e2106[1])) + (_e2310 * _e2106[2]));
                                let _e2340 = (((_e2304 * _e2122) + (_e2307 * _e2123)) + (_e2310 * _e2124));
                                let _e2345 = (((_e2304 * _e2128) + (_e2307 * _e2129)) + (_e2310 * _e2130));
                                let _e2350 = (((_e2304 * _e2125) + (_e2307 * _e2126)) + (_e2310 * _e2127));
                                if (_e2315 < _e2320) {
                                    phi_4000_ = _e2315;
                                } else {
                                    phi_4000_ = _e2320;
                                }
                                let _e2353 = phi_4000_;
                                if (_e2325 < _e2330) {
                                    phi_4005_ = _e2325;
                                } else {
                                    phi_4005_ = _e2330;
                                }
                                let _e2356 = phi_4005_;
                                if (_e2353 < _e2356) {
                                    phi_4010_ = _e2353;
                                } else {
                                    phi_4010_ = _e2356;
                                }
                                let _e2359 = phi_4010_;
                                if (_e2335 < _e2340) {
                                    phi_4015_ = _e2335;
                                } else {
                                    phi_4015_ = _e2340;
                                }
                                let _e2362 = phi_4015_;
                                if (_e2345 < _e2350) {
                                    phi_4020_ = _e2345;
                                } else {
                                    phi_4020_ = _e2350;
                                }
                                let _e2365 = phi_4020_;
                                if (_e2362 < _e2365) {
                                    phi_4025_ = _e2362;
                                } else {
                                    phi_4025_ = _e2365;
                                }
                                let _e2368 = phi_4025_;
                                if (_e2359 < _e2368) {
                                    phi_4030_ = _e2359;
                                } else {
                                    phi_4030_ = _e2368;
                                }
                                let _e2371 = phi_4030_;
                                if (_e2315 > _e2320) {
                                    phi_4035_ = _e2315;
                                } else {
                                    phi_4035_ = _e2320;
                                }
                                let _e2374 = phi_4035_;
                                if (_e2325 > _e2330) {
                                    phi_4040_ = _e2325;
                                } else {
                                    phi_4040_ = _e2330;
                                }
                                let _e2377 = phi_4040_;
                                if (_e2374 > _e2377) {
                                    phi_4045_ = _e2374;
                                } else {
                                    phi_4045_ = _e2377;
                                }
                                let _e2380 = phi_4045_;
                                if (_e2335 > _e2340) {
                                    phi_4050_ = _e2335;
                                } else {
                                    phi_4050_ = _e2340;
                                }
                                let _e2383 = phi_4050_;
                                if (_e2345 > _e2350) {
                                    phi_4055_ = _e2345;
                                } else {
                                    phi_4055_ = _e2350;
                                }
                                let _e2386 = phi_4055_;
                                if (_e2383 > _e2386) {
                                    phi_4060_ = _e2383;
                                } else {
                                    phi_4060_ = _e2386;
                                }
                                let _e2389 = phi_4060_;
                                if (_e2380 > _e2389) {
                                    phi_4065_ = _e2380;
                                } else {
                                    phi_4065_ = _e2389;
                                }
                                let _e2392 = phi_4065_;
                                if (_e2304 < 0f) {
                                    phi_4071_ = -(_e2304);
                                } else {
                                    phi_4071_ = _e2304;
                                }
                                let _e2396 = phi_4071_;
                                if (_e2307 < 0f) {
                                    phi_4077_ = -(_e2307);
                                } else {
                                    phi_4077_ = _e2307;
                                }
                                let _e2400 = phi_4077_;
                                if (_e2310 < 0f) {
                                    phi_4084_ = -(_e2310);
                                } else {
                                    phi_4084_ = _e2310;
                                }
                                let _e2405 = phi_4084_;
                                let _e2406 = ((_e2396 + _e2400) + _e2405);
                                let _e2410 = -(_e2392);
                                if (_e2371 > _e2410) {
                                    phi_4094_ = _e2371;
                                } else {
                                    phi_4094_ = _e2410;
                                }
                                let _e2413 = phi_4094_;
                                let _e2418 = (((_e2413 - ((_e2406 * _e2294) * (0.000000059604645f * 17f))) - (_e2406 * _e2301)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2421 = ((_e2073 * _e2067) - (_e2076 * _e2066));
                                let _e2424 = ((_e2076 * _e2065) - (_e2070 * _e2067));
                                let _e2427 = ((_e2070 * _e2066) - (_e2073 * _e2065));
                                let _e2432 = (((_e2421 * _e2079[0]) + (_e2424 * _e2079[1])) + (_e2427 * _e2079[2]));
                                let _e2437 = (((_e2421 * _e2095) + (_e2424 * _e2096)) + (_e2427 * _e2097));
                                let _e2442 = (((_e2421 * _e2101) + (_e2424 * _e2102)) + (_e2427 * _e2103));
                                let _e2447 = (((_e2421 * _e2098) + (_e2424 * _e2099)) + (_e2427 * _e2100));
                                let _e2452 = (((_e2421 * _e2106[0]) + (_e2424 * _e2106[1])) + (_e2427 * _e2106[2]));
                                let _e2457 = (((_e2421 * _e2122) + (_e2424 * _e2123)) + (_e2427 * _e2124));
                                let _e2462 = (((_e2421 * _e2128) + (_e2424 * _e2129)) + (_e2427 * _e2130));
                                let _e2467 = (((_e2421 * _e2125) + (_e2424 * _e2126)) + (_e2427 * _e2127));
                                if (_e2432 < _e2437) {
                                    phi_4165_ = _e2432;
                                } else {
                                    phi_4165_ = _e2437;
                                }
                                let _e2470 = phi_4165_;
                                if (_e2442 < _e2447) {
                                    phi_4170_ = _e2442;
                                } else {
                                    phi_4170_ = _e2447;
                                }
                                let _e2473 = phi_4170_;
                                if (_e2470 < _e2473) {
                                    phi_4175_ = _e2470;
                                } else {
                                    phi_4175_ = _e2473;
                                }
                                let _e2476 = phi_4175_;
                                if (_e2452 < _e2457) {
                                    phi_4180_ = _e2452;
                                } else {
                                    phi_4180_ = _e2457;
                                }
                                let _e2479 = phi_4180_;
                                if (_e2462 < _e2467) {
                                    phi_4185_ = _e2462;
                                } else {
                                    phi_4185_ = _e2467;
                                }
                                let _e2482 = phi_4185_;
                                if (_e2479 < _e2482) {
                                    phi_4190_ = _e2479;
                                } else {
                                    phi_4190_ = _e2482;
                                }
                                let _e2485 = phi_4190_;
                                if (_e2476 < _e2485) {
                                    phi_4195_ = _e2476;
                                } else {
                                    phi_4195_ = _e2485;
                                }
                                let _e2488 = phi_4195_;
                                if (_e2432 > _e2437) {
                                    phi_4200_ = _e2432;
                                } else {
                                    phi_4200_ = _e2437;
                                }
                                let _e2491 = phi_4200_;
                                if (_e2442 > _e2447) {
                                    phi_4205_ = _e2442;
                                } else {
                                    phi_4205_ = _e2447;
                                }
                                let _e2494 = phi_4205_;
                                if (_e2491 > _e2494) {
                                    phi_4210_ = _e2491;
                                } else {
                                    phi_4210_ = _e2494;
                                }
                                let _e2497 = phi_4210_;
                                if (_e2452 > _e2457) {
                                    phi_4215_ = _e2452;
                                } else {
                                    phi_4215_ = _e2457;
                                }
                                let _e2500 = phi_4215_;
                                if (_e2462 > _e2467) {
                                    phi_4220_ = _e2462;
                                } else {
                                    phi_4220_ = _e2467;
                                }
                                let _e2503 = phi_4220_;
                                if (_e2500 > _e2503) {
                                    phi_4225_ = _e2500;
                                } else {
                                    phi_4225_ = _e2503;
                                }
                                let _e2506 = phi_4225_;
                                if (_e2497 > _e2506) {
                                    phi_4230_ = _e2497;
                                } else {
                                    phi_4230_ = _e2506;
                                }
                                let _e2509 = phi_4230_;
                                if (_e2421 < 0f) {
                                    phi_4236_ = -(_e2421);
                                } else {
                                    phi_4236_ = _e2421;
                                }
                                let _e2513 = phi_4236_;
                                if (_e2424 < 0f) {
                                    phi_4242_ = -(_e2424);
                                } else {
                                    phi_4242_ = _e2424;
                                }
                                let _e2517 = phi_4242_;
                                if (_e2427 < 0f) {
                                    phi_4249_ = -(_e2427);
                                } else {
                                    phi_4249_ = _e2427;
                                }
                                let _e2522 = phi_4249_;
                                let _e2523 = ((_e2513 + _e2517) + _e2522);
                                let _e2527 = -(_e2509);
                                if (_e2488 > _e2527) {
                                    phi_4259_ = _e2488;
                                } else {
                                    phi_4259_ = _e2527;
                                }
                                let _e2530 = phi_4259_;
                                let _e2535 = (((_e2530 - ((_e2523 * _e2294) * (0.000000059604645f * 17f))) - (_e2523 * _e2301)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2418 > _e2535) {
                                    phi_4269_ = _e2418;
                                } else {
                                    phi_4269_ = _e2535;
                                }
                                let _e2538 = phi_4269_;
                                phi_4449_ = (_e2538 > 0f);
                            }
                            let _e2541 = phi_4449_;
                            if _e2541 {
                                phi_7855_ = false;
                            } else {
                                let _e2544 = local_2.member[0u];
                                let _e2550 = local_2.member[1u];
                                let _e2557 = ((_e2544[0] + _e2550[0]) * 0.5f);
                                let _e2558 = ((_e2544[1] + _e2550[1]) * 0.5f);
                                let _e2559 = ((_e2544[2] + _e2550[2]) * 0.5f);
                                let _e2562 = local_2.member_1[0u];
                                let _e2568 = local_2.member_1[1u];
                                let _e2575 = ((_e2562[0] + _e2568[0]) * 0.5f);
                                let _e2576 = ((_e2562[1] + _e2568[1]) * 0.5f);
                                let _e2577 = ((_e2562[2] + _e2568[2]) * 0.5f);
                                let _e2580 = local_2.member_2[0u];
                                let _e2586 = local_2.member_2[1u];
                                let _e2593 = ((_e2580[0] + _e2586[0]) * 0.5f);
                                let _e2594 = ((_e2580[1] + _e2586[1]) * 0.5f);
                                let _e2595 = ((_e2580[2] + _e2586[2]) * 0.5f);
                                let _e2598 = local_2.member[0u];
                                let _e2601 = local_2.member_1[0u];
                                let _e2604 = local_2.member_2[0u];
                                let _e2606 = local_2.member_3;
                                let _e2609 = local_2.member[1u];
                                let _e2612 = local_2.member_1[1u];
                                let _e2615 = local_2.member_2[1u];
                                let _e2617 = local_2.member_3;
                                local = type_34(array<array<f32, 3>, 2>(_e2598, array<f32, 3>(_e2557, _e2558, _e2559)), array<array<f32, 3>, 2>(_e2601, array<f32, 3>(_e2575, _e2576, _e2577)), array<array<f32, 3>, 2>(_e2604, array<f32, 3>(_e2593, _e2594, _e2595)), _e2606);
                                local_1 = type_34(array<array<f32, 3>, 2>(array<f32, 3>(_e2557, _e2558, _e2559), _e2609), array<array<f32, 3>, 2>(array<f32, 3>(_e2575, _e2576, _e2577), _e2612), array<array<f32, 3>, 2>(array<f32, 3>(_e2593, _e2594, _e2595), _e2615), _e2617);
                                let _e2634 = local.member_1[0u];
                                let _e2640 = local.member_2[0u];
                                let _e2646 = ((_e2634[1] * _e2640[2]) - (_e2634[2] * _e2640[1]));
                                let _e2649 = ((_e2634[2] * _e2640[0]) - (_e2634[0] * _e2640[2]));
                                let _e2652 = ((_e2634[0] * _e2640[1]) - (_e2634[1] * _e2640[0]));
                                let _e2655 = local.member_1[1u];
                                let _e2661 = local.member_2[1u];
                                let _e2667 = ((_e2655[1] * _e2661[2]) - (_e2655[2] * _e2661[1]));
                                let _e2670 = ((_e2655[2] * _e2661[0]) - (_e2655[0] * _e2661[2]));
                                let _e2673 = ((_e2655[0] * _e2661[1]) - (_e2655[1] * _e2661[0]));
                                let _e2676 = local.member_1[0u];
                                let _e2682 = local.member_2[1u];
                                let _e2697 = local.member_1[1u];
                                let _e2703 = local.member_2[0u];
                                let _e2716 = (((_e2676[1] * _e2682[2]) - (_e2676[2] * _e2682[1])) + ((_e2697[1] * _e2703[2]) - (_e2697[2] * _e2703[1])));
                                let _e2717 = (((_e2676[2] * _e2682[0]) - (_e2676[0] * _e2682[2])) + ((_e2697[2] * _e2703[0]) - (_e2697[0] * _e2703[2])));
                                let _e2718 = (((_e2676[0] * _e2682[1]) - (_e2676[1] * _e2682[0])) + ((_e2697[0] * _e2703[1]) - (_e2697[1] * _e2703[0])));
                                let _e2721 = local.member[0u];
                                let _e2732 = local.member[1u];
                                let _e2743 = local.member[0u];
                                let _e2752 = ((((_e2732[0] * _e2646) + (_e2732[1] * _e2649)) + (_e2732[2] * _e2652)) + (((_e2743[0] * _e2716) + (_e2743[1] * _e2717)) + (_e2743[2] * _e2718)));
                                let _e2755 = local.member[0u];
                                let _e2766 = local.member[1u];
                                let _e2775 = ((((_e2755[0] * _e2667) + (_e2755[1] * _e2670)) + (_e2755[2] * _e2673)) + (((_e2766[0] * _e2716) + (_e2766[1] * _e2717)) + (_e2766[2] * _e2718)));
                                let _e2778 = local.member[1u];
                                let _e2789 = local.member[0u];
                                if (_e2789[0] < 0f) {
                                    phi_4901_ = -(_e2789[0]);
                                } else {
                                    phi_4901_ = _e2789[0];
                                }
                                let _e2796 = phi_4901_;
                                if (_e2789[1] < 0f) {
                                    phi_4908_ = -(_e2789[1]);
                                } else {
                                    phi_4908_ = _e2789[1];
                                }
                                let _e2800 = phi_4908_;
                                if (_e2796 > _e2800) {
                                    phi_4913_ = _e2796;
                                } else {
                                    phi_4913_ = _e2800;
                                }
                                let _e2803 = phi_4913_;
                                if (_e2789[2] < 0f) {
                                    phi_4920_ = -(_e2789[2]);
                                } else {
                                    phi_4920_ = _e2789[2];
                                }
                                let _e2807 = phi_4920_;
                                if (_e2803 > _e2807) {
                                    phi_4925_ = _e2803;
                                } else {
                                    phi_4925_ = _e2807;
                                }
                                let _e2810 = phi_4925_;
                                let _e2813 = local.member[1u];
                                if (_e2813[0] < 0f) {
                                    phi_4938_ = -(_e2813[0]);
                                } else {
                                    phi_4938_ = _e2813[0];
                                }
                                let _e2820 = phi_4938_;
                                if (_e2813[1] < 0f) {
                                    phi_4945_ = -(_e2813[1]);
                                } else {
                                    phi_4945_ = _e2813[1];
                                }
                                let _e2824 = phi_4945_;
                                if (_e2820 > _e2824) {
                                    phi_4950_ = _e2820;
                                } else {
                                    phi_4950_ = _e2824;
                                }
                                let _e2827 = phi_4950_;
                                if (_e2813[2] < 0f) {
                                    phi_4957_ = -(_e2813[2]);
                                } else {
                                    phi_4957_ = _e2813[2];
                                }
                                let _e2831 = phi_4957_;
                                if (_e2827 > _e2831) {
                                    phi_4962_ = _e2827;
                                } else {
                                    phi_4962_ = _e2831;
                                }
                                let _e2834 = phi_4962_;
                                if (_e2810 > _e2834) {
                                    phi_4967_ = _e2810;
                                } else {
                                    phi_4967_ = _e2834;
                                }
                                let _e2837 = phi_4967_;
                                let _e2839 = local.member_3;
                                let _e2840 = (_e2837 + _e2839);
                                let _e2843 = local.member_1[0u];
                                if (_e2843[0] < 0f) {
                                    phi_4984_ = -(_e2843[0]);
                                } else {
                                    phi_4984_ = _e2843[0];
                                }
                                let _e2850 = phi_4984_;
                                if (_e2843[1] < 0f) {
                                    phi_4991_ = -(_e2843[1]);
                                } else {
                                    phi_4991_ = _e2843[1];
                                }
                                let _e2854 = phi_4991_;
                                if (_e2850 > _e2854) {
                                    phi_4996_ = _e2850;
                                } else {
                                    phi_4996_ = _e2854;
                                }
                                let _e2857 = phi_4996_;
                                if (_e2843[2] < 0f) {
                                    phi_5003_ = -(_e2843[2]);
                                } else {
                                    phi_5003_ = _e2843[2];
                                }
                                let _e2861 = phi_5003_;
                                if (_e2857 > _e2861) {
                                    phi_5008_ = _e2857;
                                } else {
                                    phi_5008_ = _e2861;
                                }
                                let _e2864 = phi_5008_;
                                let _e2867 = local.member_1[1u];
                                if (_e2867[0] < 0f) {
                                    phi_5022_ = -(_e2867[0]);
                                } else {
                                    phi_5022_ = _e2867[0];
                                }
                                let _e2874 = phi_5022_;
                                if (_e2867[1] < 0f) {
                                    phi_5029_ = -(_e2867[1]);
                                } else {
                                    phi_5029_ = _e2867[1];
                                }
                                let _e2878 = phi_5029_;
                                if (_e2874 > _e2878) {
                                    phi_5034_ = _e2874;
                                } else {
                                    phi_5034_ = _e2878;
                                }
                                let _e2881 = phi_5034_;
                                if (_e2867[2] < 0f) {
                                    phi_5041_ = -(_e2867[2]);
                                } else {
                                    phi_5041_ = _e2867[2];
                                }
                                let _e2885 = phi_5041_;
                                if (_e2881 > _e2885) {
                                    phi_5046_ = _e2881;
                                } else {
                                    phi_5046_ = _e2885;
                                }
                                let _e2888 = phi_5046_;
                                if (_e2864 > _e2888) {
                                    phi_5051_ = _e2864;
                                } else {
                                    phi_5051_ = _e2888;
                                }
                                let _e2891 = phi_5051_;
                                let _e2893 = local.member_3;
                                let _e2894 = (_e2891 + _e2893);
                                let _e2897 = local.member_2[0u];
                                if (_e2897[0] < 0f) {
                                    phi_5068_ = -(_e2897[0]);
                                } else {
                                    phi_5068_ = _e2897[0];
                                }
                                let _e2904 = phi_5068_;
                                if (_e2897[1] < 0f) {
                                    phi_5075_ = -(_e2897[1]);
                                } else {
                                    phi_5075_ = _e2897[1];
                                }
                                let _e2908 = phi_5075_;
                                if (_e2904 > _e2908) {
                                    phi_5080_ = _e2904;
                                } else {
                                    phi_5080_ = _e2908;
                                }
                                let _e2911 = phi_5080_;
                                if (_e2897[2] < 0f) {
                                    phi_5087_ = -(_e2897[2]);
                                } else {
                                    phi_5087_ = _e2897[2];
                                }
                                let _e2915 = phi_5087_;
                                if (_e2911 > _e2915) {
                                    phi_5092_ = _e2911;
                                } else {
                                    phi_5092_ = _e2915;
                                }
                                let _e2918 = phi_5092_;
                                let _e2921 = local.member_2[1u];
                                if (_e2921[0] < 0f) {
                                    phi_5106_ = -(_e2921[0]);
                                } else {
                                    phi_5106_ = _e2921[0];
                                }
                                let _e2928 = phi_5106_;
                                if (_e2921[1] < 0f) {
                                    phi_5113_ = -(_e2921[1]);
                                } else {
                                    phi_5113_ = _e2921[1];
                                }
                                let _e2932 = phi_5113_;
                                if (_e2928 > _e2932) {
                                    phi_5118_ = _e2928;
                                } else {
                                    phi_5118_ = _e2932;
                                }
                                let _e2935 = phi_5118_;
                                if (_e2921[2] < 0f) {
                                    phi_5125_ = -(_e2921[2]);
                                } else {
                                    phi_5125_ = _e2921[2];
                                }
                                let _e2939 = phi_5125_;
                                if (_e2935 > _e2939) {
                                    phi_5130_ = _e2935;
                                } else {
                                    phi_5130_ = _e2939;
                                }
                                let _e2942 = phi_5130_;
                                if (_e2918 > _e2942) {
                                    phi_5135_ = _e2918;
                                } else {
                                    phi_5135_ = _e2942;
                                }
                                let _e2945 = phi_5135_;
                                let _e2947 = local.member_3;
                                let _e2948 = (_e2945 + _e2947);
                                let _e2950 = ((_e2894 * 8f) * _e2948);
                                let _e2957 = local.member_3;
                                if (_e2646 < 0f) {
                                    phi_5166_ = -(_e2646);
                                } else {
                                    phi_5166_ = _e2646;
                                }
                                let _e2974 = phi_5166_;
                                if (_e2649 < 0f) {
                                    phi_5172_ = -(_e2649);
                                } else {
                                    phi_5172_ = _e2649;
                                }
                                let _e2978 = phi_5172_;
                                if (_e2652 < 0f) {
                                    phi_5179_ = -(_e2652);
                                } else {
                                    phi_5179_ = _e2652;
                                }
                                let _e2983 = phi_5179_;
                                let _e2984 = ((_e2974 + _e2978) + _e2983);
                                if (_e2667 < 0f) {
                                    phi_5186_ = -(_e2667);
                                } else {
                                    phi_5186_ = _e2667;
                                }
                                let _e2988 = phi_5186_;
                                if (_e2670 < 0f) {
                                    phi_5192_ = -(_e2670);
                                } else {
                                    phi_5192_ = _e2670;
                                }
                                let _e2992 = phi_5192_;
                                if (_e2673 < 0f) {
                                    phi_5199_ = -(_e2673);
                                } else {
                                    phi_5199_ = _e2673;
                                }
                                let _e2997 = phi_5199_;
                                let _e2998 = ((_e2988 + _e2992) + _e2997);
                                if (_e2984 > _e2998) {
                                    phi_5205_ = _e2984;
                                } else {
                                    phi_5205_ = _e2998;
                                }
                                let _e3001 = phi_5205_;
                                if (_e2716 < 0f) {
                                    phi_5211_ = -(_e2716);
                                } else {
                                    phi_5211_ = _e2716;
                                }
                                let _e3005 = phi_5211_;
                                if (_e2717 < 0f) {
                                    phi_5217_ = -(_e2717);
                                } else {
                                    phi_5217_ = _e2717;
                                }
                                let _e3009 = phi_5217_;
                                if (_e2718 < 0f) {
                                    phi_5224_ = -(_e2718);
                                } else {
                                    phi_5224_ = _e2718;
                                }
                                let _e3014 = phi_5224_;
                                let _e3016 = (((_e3005 + _e3009) + _e3014) * 0.5f);
                                if (_e3001 > _e3016) {
                                    phi_5231_ = _e3001;
                                } else {
                                    phi_5231_ = _e3016;
                                }
                                let _e3019 = phi_5231_;
                                let _e3024 = local.member_3;
                                let _e3037 = ((((_e2721[0] * _e2646) + (_e2721[1] * _e2649)) + (_e2721[2] * _e2652)) * 3f);
                                let _e3038 = ((((_e2778[0] * _e2667) + (_e2778[1] * _e2670)) + (_e2778[2] * _e2673)) * 3f);
                                if (_e3037 < _e3038) {
                                    phi_5255_ = _e3037;
                                } else {
                                    phi_5255_ = _e3038;
                                }
                                let _e3041 = phi_5255_;
                                if (_e2752 < _e2775) {
                                    phi_5260_ = _e2752;
                                } else {
                                    phi_5260_ = _e2775;
                                }
                                let _e3044 = phi_5260_;
                                if (_e3041 < _e3044) {
                                    phi_5265_ = _e3041;
                                } else {
                                    phi_5265_ = _e3044;
                                }
                                let _e3047 = phi_5265_;
                                if (_e3037 > _e3038) {
                                    phi_5270_ = _e3037;
                                } else {
                                    phi_5270_ = _e3038;
                                }
                                let _e3050 = phi_5270_;
                                if (_e2752 > _e2775) {
                                    phi_5275_ = _e2752;
                                } else {
                                    phi_5275_ = _e2775;
                                }
                                let _e3053 = phi_5275_;
                                if (_e3050 > _e3053) {
                                    phi_5280_ = _e3050;
                                } else {
                                    phi_5280_ = _e3053;
                                }
                                let _e3056 = phi_5280_;
                                let _e3061 = -(_e3056);
                                if (_e3047 > _e3061) {
                                    phi_5290_ = _e3047;
                                } else {
                                    phi_5290_ = _e3061;
                                }
                                let _e3064 = phi_5290_;
                                if ((_e3064 - ((((((_e2840 * 8f) * _e2950) * (0.000000059604645f * (490f / 64f))) + ((_e2957 * 19f) * ((_e2840 * (_e2894 + _e2948)) + (_e2894 * _e2948)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2840) * ((1f + _e2894) * (1f + _e2948))))) + ((_e1525 * (((_e3019 + (_e2950 * (0.000000059604645f * 4f))) + ((_e3024 * 6f) * (_e2894 + _e2948))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2894) * (1f + _e2948))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6254_ = true;
                                } else {
                                    let _e3069 = local.member_1[0u];
                                    let _e3075 = local.member_1[1u];
                                    let _e3079 = (_e3069[0] + _e3075[0]);
                                    let _e3080 = (_e3069[1] + _e3075[1]);
                                    let _e3081 = (_e3069[2] + _e3075[2]);
                                    let _e3084 = local.member_2[0u];
                                    let _e3090 = local.member_2[1u];
                                    let _e3094 = (_e3084[0] + _e3090[0]);
                                    let _e3095 = (_e3084[1] + _e3090[1]);
                                    let _e3096 = (_e3084[2] + _e3090[2]);
                                    let _e3099 = ((_e3080 * _e3096) - (_e3081 * _e3095));
                                    let _e3102 = ((_e3081 * _e3094) - (_e3079 * _e3096));
                                    let _e3105 = ((_e3079 * _e3095) - (_e3080 * _e3094));
                                    let _e3108 = local.member[0u];
                                    let _e3114 = local.member_1[0u];
                                    let _e3120 = local.member_2[0u];
                                    let _e3124 = (_e3108[0] - _e3114[0]);
                                    let _e3125 = (_e3108[1] - _e3114[1]);
                                    let _e3126 = (_e3108[2] - _e3114[2]);
                                    let _e3127 = (_e3124 - _e3120[0]);
                                    let _e3128 = (_e3125 - _e3120[1]);
                                    let _e3129 = (_e3126 - _e3120[2]);
                                    let _e3130 = (_e3108[0] - _e3120[0]);
                                    let _e3131 = (_e3108[1] - _e3120[1]);
                                    let _e3132 = (_e3108[2] - _e3120[2]);
                                    let _e3135 = local.member[1u];
                                    let _e3141 = local.member_1[1u];
                                    let _e3147 = local.member_2[1u];
                                    let _e3151 = (_e3135[0] - _e3141[0]);
                                    let _e3152 = (_e3135[1] - _e3141[1]);
                                    let _e3153 = (_e3135[2] - _e3141[2]);
                                    let _e3154 = (_e3151 - _e3147[0]);
                                    let _e3155 = (_e3152 - _e3147[1]);
                                    let _e3156 = (_e3153 - _e3147[2]);
                                    let _e3157 = (_e3135[0] - _e3147[0]);
                                    let _e3158 = (_e3135[1] - _e3147[1]);
                                    let _e3159 = (_e3135[2] - _e3147[2]);
                                    let _e3162 = local.member[0u];
                                    if (_e3162[0] < 0f) {
                                        phi_5493_ = -(_e3162[0]);
                                    } else {
                                        phi_5493_ = _e3162[0];
                                    }
                                    let _e3169 = phi_5493_;
                                    if (_e3162[1] < 0f) {
                                        phi_5500_ = -(_e3162[1]);
                                    } else {
                                        phi_5500_ = _e3162[1];
                                    }
                                    let _e3173 = phi_5500_;
                                    if (_e3169 > _e3173) {
                                        phi_5505_ = _e3169;
                                    } else {
                                        phi_5505_ = _e3173;
                                    }
                                    let _e3176 = phi_5505_;
                                    if (_e3162[2] < 0f) {
                                        phi_5512_ = -(_e3162[2]);
                                    } else {
                                        phi_5512_ = _e3162[2];
                                    }
                                    let _e3180 = phi_5512_;
                                    if (_e3176 > _e3180) {
                                        phi_5517_ = _e3176;
                                    } else {
                                        phi_5517_ = _e3180;
                                    }
                                    let _e3183 = phi_5517_;
                                    let _e3186 = local.member[1u];
                                    if (_e3186[0] < 0f) {
                                        phi_5530_ = -(_e3186[0]);
                                    } else {
                                        phi_5530_ = _e3186[0];
                                    }
                                    let _e3193 = phi_5530_;
                                    if (_e3186[1] < 0f) {
                                        phi_5537_ = -(_e3186[1]);
                                    } else {
                                        phi_5537_ = _e3186[1];
                                    }
                                    let _e3197 = phi_5537_;
                                    if (_e3193 > _e3197) {
                                        phi_5542_ = _e3193;
                                    } else {
                                        phi_5542_ = _e3197;
                                    }
                                    let _e3200 = phi_5542_;
                                    if (_e3186[2] < 0f) {
                                        phi_5549_ = -(_e3186[2]);
                                    } else {
                                        phi_5549_ = _e3186[2];
                                    }
                                    let _e3204 = phi_5549_;
                                    if (_e3200 > _e3204) {
                                        phi_5554_ = _e3200;
                                    } else {
                                        phi_5554_ = _e3204;
                                    }
                                    let _e3207 = phi_5554_;
                                    if (_e3183 > _e3207) {
                                        phi_5559_ = _e3183;
                                    } else {
                                        phi_5559_ = _e3207;
                                    }
                                    let _e3210 = phi_5559_;
                                    let _e3212 = local.member_3;
                                    let _e3216 = local.member_1[0u];
                                    if (_e3216[0] < 0f) {
                                        phi_5576_ = -(_e3216[0]);
                                    } else {
                                        phi_5576_ = _e3216[0];
                                    }
                                    let _e3223 = phi_5576_;
                                    if (_e3216[1] < 0f) {
                                        phi_5583_ = -(_e3216[1]);
                                    } else {
                                        phi_5583_ = _e3216[1];
                                    }
                                    let _e3227 = phi_5583_;
                                    if (_e3223 > _e3227) {
                                        phi_5588_ = _e3223;
                                    } else {
                                        phi_5588_ = _e3227;
                                    }
                                    let _e3230 = phi_5588_;
                                    if (_e3216[2] < 0f) {
                                        phi_5595_ = -(_e3216[2]);
                                    } else {
                                        phi_5595_ = _e3216[2];
                                    }
                                    let _e3234 = phi_5595_;
                                    if (_e3230 > _e3234) {
                                        phi_5600_ = _e3230;
                                    } else {
                                        phi_5600_ = _e3234;
                                    }
                                    let _e3237 = phi_5600_;
                                    let _e3240 = local.member_1[1u];
                                    if (_e3240[0] < 0f) {
                                        phi_5614_ = -(_e3240[0]);
                                    } else {
                                        phi_5614_ = _e3240[0];
                                    }
                                    let _e3247 = phi_5614_;
                                    if (_e3240[1] < 0f) {
                                        phi_5621_ = -(_e3240[1]);
                                    } else {
                                        phi_5621_ = _e3240[1];
                                    }
                                    let _e3251 = phi_5621_;
                                    if (_e3247 > _e3251) {
                                        phi_5626_ = _e3247;
                                    } else {
                                        phi_5626_ = _e3251;
                                    }
                                    let _e3254 = phi_5626_;
                                    if (_e3240[2] < 0f) {
                                        phi_5633_ = -(_e3240[2]);
                                    } else {
                                        phi_5633_ = _e3240[2];
                                    }
                                    let _e3258 = phi_5633_;
                                    if (_e3254 > _e3258) {
                                        phi_5638_ = _e3254;
                                    } else {
                                        phi_5638_ = _e3258;
                                    }
                                    let _e3261 = phi_5638_;
                                    if (_e3237 > _e3261) {
                                        phi_5643_ = _e3237;
                                    } else {
                                        phi_5643_ = _e3261;
                                    }
                                    let _e3264 = phi_5643_;
                                    let _e3266 = local.member_3;
                                    let _e3270 = local.member_2[0u];
                                    if (_e3270[0] < 0f) {
                                        phi_5660_ = -(_e3270[0]);
                                    } else {
                                        phi_5660_ = _e3270[0];
                                    }
                                    let _e3277 = phi_5660_;
                                    if (_e3270[1] < 0f) {
                                        phi_5667_ = -(_e3270[1]);
                                    } else {
                                        phi_5667_ = _e3270[1];
                                    }
                                    let _e3281 = phi_5667_;
                                    if (_e3277 > _e3281) {
                                        phi_5672_ = _e3277;
                                    } else {
                                        phi_5672_ = _e3281;
                                    }
                                    let _e3284 = phi_5672_;
                                    if (_e3270[2] < 0f) {
                                        phi_5679_ = -(_e3270[2]);
                                    } else {
                                        phi_5679_ = _e3270[2];
                                    }
                                    let _e3288 = phi_5679_;
                                    if (_e3284 > _e3288) {
                                        phi_5684_ = _e3284;
                                    } else {
                                        phi_5684_ = _e3288;
                                    }
                                    let _e3291 = phi_5684_;
                                    let _e3294 = local.member_2[1u];
                                    if (_e3294[0] < 0f) {
                                        phi_5698_ = -(_e3294[0]);
                                    } else {
                                        phi_5698_ = _e3294[0];
                                    }
                                    let _e3301 = phi_5698_;
                                    if (_e3294[1] < 0f) {
                                        phi_5705_ = -(_e3294[1]);
                                    } else {
                                        phi_5705_ = _e3294[1];
                                    }
                                    let _e3305 = phi_5705_;
                                    if (_e3301 > _e3305) {
                                        phi_5710_ = _e3301;
                                    } else {
                                        phi_5710_ = _e3305;
                                    }
                                    let _e3308 = phi_5710_;
                                    if (_e3294[2] < 0f) {
                                        phi_5717_ = -(_e3294[2]);
                                    } else {
                                        phi_5717_ = _e3294[2];
                                    }
                                    let _e3312 = phi_5717_;
                                    if (_e3308 > _e3312) {
                                        phi_5722_ = _e3308;
                                    } else {
                                        phi_5722_ = _e3312;
                                    }
                                    let _e3315 = phi_5722_;
                                    if (_e3291 > _e3315) {
                                        phi_5727_ = _e3291;
                                    } else {
                                        phi_5727_ = _e3315;
                                    }
                                    let _e3318 = phi_5727_;
                                    let _e3320 = local.member_3;
                                    let _e3323 = (((_e3210 + _e3212) + (_e3264 + _e3266)) + (_e3318 + _e3320));
                                    let _e3326 = local.member_3;
                                    let _e3330 = (((_e1525 * 1.0001f) + (_e3326 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3333 = ((_e3102 * _e3081) - (_e3105 * _e3080));
                                    let _e3336 = ((_e3105 * _e3079) - (_e3099 * _e3081));
                                    let _e3339 = ((_e3099 * _e3080) - (_e3102 * _e3079));
                                    let _e3344 = (((_e3333 * _e3108[0]) + (_e3336 * _e3108[1])) + (_e3339 * _e3108[2]));
                                    let _e3349 = (((_e3333 * _e3124) + (_e3336 * _e3125)) + (_e3339 * _e3126));
                                    let _e3354 = (((_e3333 * _e3130) + (_e3336 * _e3131)) + (_e3339 * _e3132));
                                    let _e3359 = (((_e3333 * _e3127) + (_e3336 * _e3128)) + (_e3339 * _e3129));
                                    let _e3364 = (((_e3333 * _e3135[0]) + (_e3336 * _e3135[1])) + (_e3339 * _e3135[2]));
                                    let _e3369 = (((_e3333 * _e3151) + (_e3336 * _e3152)) + (_e3339 * _e3153));
                                    let _e3374 = (((_e3333 * _e3157) + (_e3336 * _e3158)) + (_e3339 * _e3159));
                                    let _e3379 = (((_e3333 * _e3154) + (_e3336 * _e3155)) + (_e3339 * _e3156));
                                    if (_e3344 < _e3349) {
                                        phi_5805_ = _e3344;
                                    } else {
                                        phi_5805_ = _e3349;
                                    }
                                    let _e3382 = phi_5805_;
                                    if (_e3354 < _e3359) {
                                        phi_5810_ = _e3354;
                                    } else {
                                        phi_5810_ = _e3359;
                                    }
                                    let _e3385 = phi_5810_;
                                    if (_e3382 < _e3385) {
                                        phi_5815_ = _e3382;
                                    } else {
                                        phi_5815_ = _e3385;
                                    }
                                    let _e3388 = phi_5815_;
                                    if (_e3364 < _e3369) {
                                        phi_5820_ = _e3364;
                                    } else {
                                        phi_5820_ = _e3369;
                                    }
                                    let _e3391 = phi_5820_;
                                    if (_e3374 < _e3379) {
                                        phi_5825_ = _e3374;
                                    } else {
                                        phi_5825_ = _e3379;
                                    }
                                    let _e3394 = phi_5825_;
                                    if (_e3391 < _e3394) {
                                        phi_5830_ = _e3391;
                                    } else {
                                        phi_5830_ = _e3394;
                                    }
                                    let _e3397 = phi_5830_;
                                    if (_e3388 < _e3397) {
                                        phi_5835_ = _e3388;
                                    } else {
                                        phi_5835_ = _e3397;
                                    }
                                    let _e3400 = phi_5835_;
                                    if (_e3344 > _e3349) {
                                        phi_5840_ = _e3344;
                                    } else {
                                        phi_5840_ = _e3349;
                                    }
                                    let _e3403 = phi_5840_;
                                    if (_e3354 > _e3359) {
                                        phi_5845_ = _e3354;
                                    } else {
                                        phi_5845_ = _e3359;
                                    }
                                    let _e3406 = phi_5845_;
                                    if (_e3403 > _e3406) {
                                        phi_5850_ = _e3403;
                                    } else {
                                        phi_5850_ = _e3406;
                                    }
                                    let _e3409 = phi_5850_;
                                    if (_e3364 > _e3369) {
                                        phi_5855_ = _e3364;
                                    } else {
                                        phi_5855_ = _e3369;
                                    }
                                    let _e3412 = phi_5855_;
                                    if (_e3374 > _e3379) {
                                        phi_5860_ = _e3374;
                                    } else {
                                        phi_5860_ = _e3379;
                                    }
                                    let _e3415 = phi_5860_;
                                    if (_e3412 > _e3415) {
                                        phi_5865_ = _e3412;
                                    } else {
                                        phi_5865_ = _e3415;
                                    }
                                    let _e3418 = phi_5865_;
                                    if (_e3409 > _e3418) {
                                        phi_5870_ = _e3409;
                                    } else {
                                        phi_5870_ = _e3418;
                                    }
                                    let _e3421 = phi_5870_;
                                    if (_e3333 < 0f) {
                                        phi_5876_ = -(_e3333);
                                    } else {
                                        phi_5876_ = _e3333;
                                    }
                                    let _e3425 = phi_5876_;
                                    if (_e3336 < 0f) {
                                        phi_5882_ = -(_e3336);
                                    } else {
                                        phi_5882_ = _e3336;
                                    }
                                    let _e3429 = phi_5882_;
                                    if (_e3339 < 0f) {
                                        phi_5889_ = -(_e3339);
                                    } else {
                                        phi_5889_ = _e3339;
                                    }
                                    let _e3434 = phi_5889_;
                                    let _e3435 = ((_e3425 + _e3429) + _e3434);
                                    let _e3439 = -(_e3421);
                                    if (_e3400 > _e3439) {
                                        phi_5899_ = _e3400;
                                    } else {
                                        phi_5899_ = _e3439;
                                    }
                                    let _e3442 = phi_5899_;
                                    let _e3447 = (((_e3442 - ((_e3435 * _e3323) * (0.000000059604645f * 17f))) - (_e3435 * _e3330)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3450 = ((_e3102 * _e3096) - (_e3105 * _e3095));
                                    let _e3453 = ((_e3105 * _e3094) - (_e3099 * _e3096));
                                    let _e3456 = ((_e3099 * _e3095) - (_e3102 * _e3094));
                                    let _e3461 = (((_e3450 * _e3108[0]) + (_e3453 * _e3108[1])) + (_e3456 * _e3108[2]));
                                    let _e3466 = (((_e3450 * _e3124) + (_e3453 * _e3125)) + (_e3456 * _e3126));
                                    let _e3471 = (((_e3450 * _e3130) + (_e3453 * _e3131)) + (_e3456 * _e3132));
                                    let _e3476 = (((_e3450 * _e3127) + (_e3453 * _e3128)) + (_e3456 * _e3129));
                                    let _e3481 = (((_e3450 * _e3135[0]) + (_e3453 * _e3135[1])) + (_e3456 * _e3135[2]));
                                    let _e3486 = (((_e3450 * _e3151) + (_e3453 * _e3152)) + (_e3456 * _e3153));
                                    let _e3491 = (((_e3450 * _e3157) + (_e3453 * _e3158)) + (_e3456 * _e3159));
                                    let _e3496 = (((_e3450 * _e3154) + (_e3453 * _e3155)) + (_e3456 * _e3156));
                                    if (_e3461 < _e3466) {
                                        phi_5970_ = _e3461;
                                    } else {
                                        phi_5970_ = _e3466;
                                    }
                                    let _e3499 = phi_5970_;
                                    if (_e3471 < _e3476) {
                                        phi_5975_ = _e3471;
                                    } else {
                                        phi_5975_ = _e3476;
                                    }
                                    let _e3502 = phi_5975_;
                                    if (_e3499 < _e3502) {
                                        phi_5980_ = _e3499;
                                    } else {
                                        phi_5980_ = _e3502;
                                    }
                                    let _e3505 = phi_5980_;
                                    if (_e3481 < _e3486) {
                                        phi_5985_ = _e3481;
                                    } else {
                                        phi_5985_ = _e3486;
                                    }
                                    let _e3508 = phi_5985_;
                                    if (_e3491 < _e3496) {
                                        phi_5990_ = _e3491;
                                    } else {
                                        phi_5990_ = _e3496;
                                    }
                                    let _e3511 = phi_5990_;
                                    if (_e3508 < _e3511) {
                                        phi_5995_ = _e3508;
                                    } else {
                                        phi_5995_ = _e3511;
                                    }
                                    let _e3514 = phi_5995_;
                                    if (_e3505 < _e3514) {
                                        phi_6000_ = _e3505;
                                    } else {
                                        phi_6000_ = _e3514;
                                    }
                                    let _e3517 = phi_6000_;
                                    if (_e3461 > _e3466) {
                                        phi_6005_ = _e3461;
                                    } else {
                                        phi_6005_ = _e3466;
                                    }
                                    let _e3520 = phi_6005_;
                                    if (_e3471 > _e3476) {
                                        phi_6010_ = _e3471;
                                    } else {
                                        phi_6010_ = _e3476;
                                    }
                                    let _e3523 = phi_6010_;
                                    if (_e3520 > _e3523) {
                                        phi_6015_ = _e3520;
                                    } else {
                                        phi_6015_ = _e3523;
                                    }
                                    let _e3526 = phi_6015_;
                                    if (_e3481 > _e3486) {
                                        phi_6020_ = _e3481;
                                    } else {
                                        phi_6020_ = _e3486;
                                    }
                                    let _e3529 = phi_6020_;
                                    if (_e3491 > _e3496) {
                                        phi_6025_ = _e3491;
                                    } else {
                                        phi_6025_ = _e3496;
                                    }
                                    let _e3532 = phi_6025_;
                                    if (_e3529 > _e3532) {
                                        phi_6030_ = _e3529;
                                    } else {
                                        phi_6030_ = _e3532;
                                    }
                                    let _e3535 = phi_6030_;
                                    if (_e3526 > _e3535) {
                                        phi_6035_ = _e3526;
                                    } else {
                                        phi_6035_ = _e3535;
                                    }
                                    let _e3538 = phi_6035_;
                                    if (_e3450 < 0f) {
                                        phi_6041_ = -(_e3450);
                                    } else {
                                        phi_6041_ = _e3450;
                                    }
                                    let _e3542 = phi_6041_;
                                    if (_e3453 < 0f) {
                                        phi_6047_ = -(_e3453);
                                    } else {
                                        phi_6047_ = _e3453;
                                    }
                                    let _e3546 = phi_6047_;
                                    if (_e3456 < 0f) {
                                        phi_6054_ = -(_e3456);
                                    } else {
                                        phi_6054_ = _e3456;
                                    }
                                    let _e3551 = phi_6054_;
                                    let _e3552 = ((_e3542 + _e3546) + _e3551);
                                    let _e3556 = -(_e3538);
                                    if (_e3517 > _e3556) {
                                        phi_6064_ = _e3517;
                                    } else {
                                        phi_6064_ = _e3556;
                                    }
                                    let _e3559 = phi_6064_;
                                    let _e3564 = (((_e3559 - ((_e3552 * _e3323) * (0.000000059604645f * 17f))) - (_e3552 * _e3330)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3447 > _e3564) {
                                        phi_6074_ = _e3447;
                                    } else {
                                        phi_6074_ = _e3564;
                                    }
                                    let _e3567 = phi_6074_;
                                    phi_6254_ = (_e3567 > 0f);
                                }
                                let _e3570 = phi_6254_;
                                if _e3570 {
                                    let _e3573 = local_1.member_1[0u];
                                    let _e3579 = local_1.member_2[0u];
                                    let _e3585 = ((_e3573[1] * _e3579[2]) - (_e3573[2] * _e3579[1]));
                                    let _e3588 = ((_e3573[2] * _e3579[0]) - (_e3573[0] * _e3579[2]));
                                    let _e3591 = ((_e3573[0] * _e3579[1]) - (_e3573[1] * _e3579[0]));
                                    let _e3594 = local_1.member_1[1u];
                                    let _e3600 = local_1.member_2[1u];
                                    let _e3606 = ((_e3594[1] * _e3600[2]) - (_e3594[2] * _e3600[1]));
                                    let _e3609 = ((_e3594[2] * _e3600[0]) - (_e3594[0] * _e3600[2]));
                                    let _e3612 = ((_e3594[0] * _e3600[1]) - (_e3594[1] * _e3600[0]));
                                    let _e3615 = local_1.member_1[0u];
                                    let _e3621 = local_1.member_2[1u];
                                    let _e3636 = local_1.member_1[1u];
                                    let _e3642 = local_1.member_2[0u];
                                    let _e3655 = (((_e3615[1] * _e3621[2]) - (_e3615[2] * _e3621[1])) + ((_e3636[1] * _e3642[2]) - (_e3636[2] * _e3642[1])));
                                    let _e3656 = (((_e3615[2] * _e3621[0]) - (_e3615[0] * _e3621[2])) + ((_e3636[2] * _e3642[0]) - (_e3636[0] * _e3642[2])));
                                    let _e3657 = (((_e3615[0] * _e3621[1]) - (_e3615[1] * _e3621[0])) + ((_e3636[0] * _e3642[1]) - (_e3636[1] * _e3642[0])));
                                    let _e3660 = local_1.member[0u];
                                    let _e3671 = local_1.member[1u];
                                    let _e3682 = local_1.member[0u];
                                    let _e3691 = ((((_e3671[0] * _e3585) + (_e3671[1] * _e3588)) + (_e3671[2] * _e3591)) + (((_e3682[0] * _e3655) + (_e3682[1] * _e3656)) + (_e3682[2] * _e3657)));
                                    let _e3694 = local_1.member[0u];
                                    let _e3705 = local_1.member[1u];
                                    let _e3714 = ((((_e3694[0] * _e3606) + (_e3694[1] * _e3609)) + (_e3694[2] * _e3612)) + (((_e3705[0] * _e3655) + (_e3705[1] * _e3656)) + (_e3705[2] * _e3657)));
                                    let _e3717 = local_1.member[1u];
                                    let _e3728 = local_1.member[0u];
                                    if (_e3728[0] < 0f) {
                                        phi_6499_ = -(_e3728[0]);
                                    } else {
                                        phi_6499_ = _e3728[0];
                                    }
                                    let _e3735 = phi_6499_;
                                    if (_e3728[1] < 0f) {
                                        phi_6506_ = -(_e3728[1]);
                                    } else {
                                        phi_6506_ = _e3728[1];
                                    }
                                    let _e3739 = phi_6506_;
                                    if (_e3735 > _e3739) {
                                        phi_6511_ = _e3735;
                                    } else {
                                        phi_6511_ = _e3739;
                                    }
                                    let _e3742 = phi_6511_;
                                    if (_e3728[2] < 0f) {
                                        phi_6518_ = -(_e3728[2]);
                                    } else {
                                        phi_6518_ = _e3728[2];
                                    }
                                    let _e3746 = phi_6518_;
                                    if (_e3742 > _e3746) {
                                        phi_6523_ = _e3742;
                                    } else {
                                        phi_6523_ = _e3746;
                                    }
                                    let _e3749 = phi_6523_;
                                    let _e3752 = local_1.member[1u];
                                    if (_e3752[0] < 0f) {
                                        phi_6536_ = -(_e3752[0]);
                                    } else {
                                        phi_6536_ = _e3752[0];
                                    }
                                    let _e3759 = phi_6536_;
                                    if (_e3752[1] < 0f) {
                                        phi_6543_ = -(_e3752[1]);
                                    } else {
                                        phi_6543_ = _e3752[1];
                                    }
                                    let _e3763 = phi_6543_;
                                    if (_e3759 > _e3763) {
                                        phi_6548_ = _e3759;
                                    } else {
                                        phi_6548_ = _e3763;
                                    }
                                    let _e3766 = phi_6548_;
                                    if (_e3752[2] < 0f) {
                                        phi_6555_ = -(_e3752[2]);
                                    } else {
                                        phi_6555_ = _e3752[2];
                                    }
                                    let _e3770 = phi_6555_;
                                    if (_e3766 > _e3770) {
                                        phi_6560_ = _e3766;
                                    } else {
                                        phi_6560_ = _e3770;
                                    }
                                    let _e3773 = phi_6560_;
                                    if (_e3749 > _e3773) {
                                        phi_6565_ = _e3749;
                                    } else {
                                        phi_6565_ = _e3773;
                                    }
                                    let _e3776 = phi_6565_;
                                    let _e3778 = local_1.member_3;
                                    let _e3779 = (_e3776 + _e3778);
                                    let _e3782 = local_1.member_1[0u];
                                    if (_e3782[0] < 0f) {
                                        phi_6582_ = -(_e3782[0]);
                                    } else {
                                        phi_6582_ = _e3782[0];
                                    }
                                    let _e3789 = phi_6582_;
                                    if (_e3782[1] < 0f) {
                                        phi_6589_ = -(_e3782[1]);
                                    } else {
                                        phi_6589_ = _e3782[1];
                                    }
                                    let _e3793 = phi_6589_;
                                    if (_e3789 > _e3793) {
                                        phi_6594_ = _e3789;
                                    } else {
                                        phi_6594_ = _e3793;
                                    }
                                    let _e3796 = phi_6594_;
                                    if (_e3782[2] < 0f) {
                                        phi_6601_ = -(_e3782[2]);
                                    } else {
                                        phi_6601_ = _e3782[2];
                                    }
                                    let _e3800 = phi_6601_;
                                    if (_e3796 > _e3800) {
                                        phi_6606_ = _e3796;
                                    } else {
                                        phi_6606_ = _e3800;
                                    }
                                    let _e3803 = phi_6606_;
                                    let _e3806 = local_1.member_1[1u];
                                    if (_e3806[0] < 0f) {
                                        phi_6620_ = -(_e3806[0]);
                                    } else {
                                        phi_6620_ = _e3806[0];
                                    }
                                    let _e3813 = phi_6620_;
                                    if (_e3806[1] < 0f) {
                                        phi_6627_ = -(_e3806[1]);
                                    } else {
                                        phi_6627_ = _e3806[1];
                                    }
                                    let _e3817 = phi_6627_;
                                    if (_e3813 > _e3817) {
                                        phi_6632_ = _e3813;
                                    } else {
                                        phi_6632_ = _e3817;
                                    }
                                    let _e3820 = phi_6632_;
                                    if (_e3806[2] < 0f) {
                                        phi_6639_ = -(_e3806[2]);
                                    } else {
                                        phi_6639_ = _e3806[2];
                                    }
                                    let _e3824 = phi_6639_;
                                    if (_e3820 > _e3824) {
                                        phi_6644_ = _e3820;
                                    } else {
                                        phi_6644_ = _e3824;
                                    }
                                    let _e3827 = phi_6644_;
                                    if (_e3803 > _e3827) {
                                        phi_6649_ = _e3803;
                                    } else {
                                        phi_6649_ = _e3827;
                                    }
                                    let _e3830 = phi_6649_;
                                    let _e3832 = local_1.member_3;
                                    let _e3833 = (_e3830 + _e3832);
                                    let _e3836 = local_1.member_2[0u];
                                    if (_e3836[0] < 0f) {
                                        phi_6666_ = -(_e3836[0]);
                                    } else {
                                        phi_6666_ = _e3836[0];
                                    }
                                    let _e3843 = phi_6666_;
                                    if (_e3836[1] < 0f) {
                                        phi_6673_ = -(_e3836[1]);
                                    } else {
                                        phi_6673_ = _e3836[1];
                                    }
                                    let _e3847 = phi_6673_;
                                    if (_e3843 > _e3847) {
                                        phi_6678_ = _e3843;
                                    } else {
                                        phi_6678_ = _e3847;
                                    }
                                    let _e3850 = phi_6678_;
                                    if (_e3836[2] < 0f) {
                                        phi_6685_ = -(_e3836[2]);
                                    } else {
                                        phi_6685_ = _e3836[2];
                                    }
                                    let _e3854 = phi_6685_;
                                    if (_e3850 > _e3854) {
                                        phi_6690_ = _e3850;
                                    } else {
                                        phi_6690_ = _e3854;
                                    }
                                    let _e3857 = phi_6690_;
                                    let _e3860 = local_1.member_2[1u];
                                    if (_e3860[0] < 0f) {
                                        phi_6704_ = -(_e3860[0]);
                                    } else {
                                        phi_6704_ = _e3860[0];
                                    }
                                    let _e3867 = phi_6704_;
                                    if (_e3860[1] < 0f) {
                                        phi_6711_ = -(_e3860[1]);
                                    } else {
                                        phi_6711_ = _e3860[1];
                                    }
                                    let _e3871 = phi_6711_;
                                    if (_e3867 > _e3871) {
                                        phi_6716_ = _e3867;
                                    } else {
                                        phi_6716_ = _e3871;
                                    }
                                    let _e3874 = phi_6716_;
                                    if (_e3860[2] < 0f) {
                                        phi_6723_ = -(_e3860[2]);
                                    } else {
                                        phi_6723_ = _e3860[2];
                                    }
                                    let _e3878 = phi_6723_;
                                    if (_e3874 > _e3878) {
                                        phi_6728_ = _e3874;
                                    } else {
                                        phi_6728_ = _e3878;
                                    }
                                    let _e3881 = phi_6728_;
                                    if (_e3857 > _e3881) {
                                        phi_6733_ = _e3857;
                                    } else {
                                        phi_6733_ = _e3881;
                                    }
                                    let _e3884 = phi_6733_;
                                    let _e3886 = local_1.member_3;
                                    let _e3887 = (_e3884 + _e3886);
                                    let _e3889 = ((_e3833 * 8f) * _e3887);
                                    let _e3896 = local_1.member_3;
                                    if (_e3585 < 0f) {
                                        phi_6764_ = -(_e3585);
                                    } else {
                                        phi_6764_ = _e3585;
                                    }
                                    let _e3913 = phi_6764_;
                                    if (_e3588 < 0f) {
                                        phi_6770_ = -(_e3588);
                                    } else {
                                        phi_6770_ = _e3588;
                                    }
                                    let _e3917 = phi_6770_;
                                    if (_e3591 < 0f) {
                                        phi_6777_ = -(_e3591);
                                    } else {
                                        phi_6777_ = _e3591;
                                    }
                                    let _e3922 = phi_6777_;
                                    let _e3923 = ((_e3913 + _e3917) + _e3922);
                                    if (_e3606 < 0f) {
                                        phi_6784_ = -(_e3606);
                                    } else {
                                        phi_6784_ = _e3606;
                                    }
                                    let _e3927 = phi_6784_;
                                    if (_e3609 < 0f) {
                                        phi_6790_ = -(_e3609);
                                    } else {
                                        phi_6790_ = _e3609;
                                    }
                                    let _e3931 = phi_6790_;
                                    if (_e3612 < 0f) {
                                        phi_6797_ = -(_e3612);
                                    } else {
                                        phi_6797_ = _e3612;
                                    }
                                    let _e3936 = phi_6797_;
                                    let _e3937 = ((_e3927 + _e3931) + _e3936);
                                    if (_e3923 > _e3937) {
                                        phi_6803_ = _e3923;
                                    } else {
                                        phi_6803_ = _e3937;
                                    }
                                    let _e3940 = phi_6803_;
                                    if (_e3655 < 0f) {
                                        phi_6809_ = -(_e3655);
                                    } else {
                                        phi_6809_ = _e3655;
                                    }
                                    let _e3944 = phi_6809_;
                                    if (_e3656 < 0f) {
                                        phi_6815_ = -(_e3656);
                                    } else {
                                        phi_6815_ = _e3656;
                                    }
                                    let _e3948 = phi_6815_;
                                    if (_e3657 < 0f) {
                                        phi_6822_ = -(_e3657);
                                    } else {
                                        phi_6822_ = _e3657;
                                    }
                                    let _e3953 = phi_6822_;
                                    let _e3955 = (((_e3944 + _e3948) + _e3953) * 0.5f);
                                    if (_e3940 > _e3955) {
                                        phi_6829_ = _e3940;
                                    } else {
                                        phi_6829_ = _e3955;
                                    }
                                    let _e3958 = phi_6829_;
                                    let _e3963 = local_1.member_3;
                                    let _e3976 = ((((_e3660[0] * _e3585) + (_e3660[1] * _e3588)) + (_e3660[2] * _e3591)) * 3f);
                                    let _e3977 = ((((_e3717[0] * _e3606) + (_e3717[1] * _e3609)) + (_e3717[2] * _e3612)) * 3f);
                                    if (_e3976 < _e3977) {
                                        phi_6853_ = _e3976;
                                    } else {
                                        phi_6853_ = _e3977;
                                    }
                                    let _e3980 = phi_6853_;
                                    if (_e3691 < _e3714) {
                                        phi_6858_ = _e3691;
                                    } else {
                                        phi_6858_ = _e3714;
                                    }
                                    let _e3983 = phi_6858_;
                                    if (_e3980 < _e3983) {
                                        phi_6863_ = _e3980;
                                    } else {
                                        phi_6863_ = _e3983;
                                    }
                                    let _e3986 = phi_6863_;
                                    if (_e3976 > _e3977) {
                                        phi_6868_ = _e3976;
                                    } else {
                                        phi_6868_ = _e3977;
                                    }
                                    let _e3989 = phi_6868_;
                                    if (_e3691 > _e3714) {
                                        phi_6873_ = _e3691;
                                    } else {
                                        phi_6873_ = _e3714;
                                    }
                                    let _e3992 = phi_6873_;
                                    if (_e3989 > _e3992) {
                                        phi_6878_ = _e3989;
                                    } else {
                                        phi_6878_ = _e3992;
                                    }
                                    let _e3995 = phi_6878_;
                                    let _e4000 = -(_e3995);
                                    if (_e3986 > _e4000) {
                                        phi_6888_ = _e3986;
                                    } else {
                                        phi_6888_ = _e4000;
                                    }
                                    let _e4003 = phi_6888_;
                                    if ((_e4003 - ((((((_e3779 * 8f) * _e3889) * (0.000000059604645f * (490f / 64f))) + ((_e3896 * 19f) * ((_e3779 * (_e3833 + _e3887)) + (_e3833 * _e3887)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3779) * ((1f + _e3833) * (1f + _e3887))))) + ((_e1525 * (((_e3958 + (_e3889 * (0.000000059604645f * 4f))) + ((_e3963 * 6f) * (_e3833 + _e3887))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3833) * (1f + _e3887))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_7852_ = true;
                                    } else {
                                        let _e4008 = local_1.member_1[0u];
                                        let _e4014 = local_1.member_1[1u];
                                        let _e4018 = (_e4008[0] + _e4014[0]);
                                        let _e4019 = (_e4008[1] + _e4014[1]);
                                        let _e4020 = (_e4008[2] + _e4014[2]);
                                        let _e4023 = local_1.member_2[0u];
                                        let _e4029 = local_1.member_2[1u];
                                        let _e4033 = (_e4023[0] + _e4029[0]);
                                        let _e4034 = (_e4023[1] + _e4029[1]);
                                        let _e4035 = (_e4023[2] + _e4029[2]);
                                        let _e4038 = ((_e4019 * _e4035) - (_e4020 * _e4034));
                                        let _e4041 = ((_e4020 * _e4033) - (_e4018 * _e4035));
                                        let _e4044 = ((_e4018 * _e4034) - (_e4019 * _e4033));
                                        let _e4047 = local_1.member[0u];
                                        let _e4053 = local_1.member_1[0u];
                                        let _e4059 = local_1.member_2[0u];
                                        let _e4063 = (_e4047[0] - _e4053[0]);
                                        let _e4064 = (_e4047[1] - _e4053[1]);
                                        let _e4065 = (_e4047[2] - _e4053[2]);
                                        let _e4066 = (_e4063 - _e4059[0]);
                                        let _e4067 = (_e4064 - _e4059[1]);
                                        let _e4068 = (_e4065 - _e4059[2]);
                                        let _e4069 = (_e4047[0] - _e4059[0]);
                                        let _e4070 = (_e4047[1] - _e4059[1]);
                                        let _e4071 = (_e4047[2] - _e4059[2]);
                                        let _e4074 = local_1.member[1u];
                                        let _e4080 = local_1.member_1[1u];
                                        let _e4086 = local_1.member_2[1u];
                                        let _e4090 = (_e4074[0] - _e4080[0]);
                                        let _e4091 = (_e4074[1] - _e4080[1]);
                                        let _e4092 = (_e4074[2] - _e4080[2]);
                                        let _e4093 = (_e4090 - _e4086[0]);
                                        let _e4094 = (_e4091 - _e4086[1]);
                                        let _e4095 = (_e4092 - _e4086[2]);
                                        let _e4096 = (_e4074[0] - _e4086[0]);
                                        let _e4097 = (_e4074[1] - _e4086[1]);
                                        let _e4098 = (_e4074[2] - _e4086[2]);
                                        let _e4101 = local_1.member[0u];
                                        if (_e4101[0] < 0f) {
                                            phi_7091_ = -(_e4101[0]);
                                        } else {
                                            phi_7091_ = _e4101[0];
                                        }
                                        let _e4108 = phi_7091_;
                                        if (_e4101[1] < 0f) {
                                            phi_7098_ = -(_e4101[1]);
                                        } else {
                                            phi_7098_ = _e4101[1];
                                        }
                                        let _e4112 = phi_7098_;
                                        if (_e4108 > _e4112) {
                                            phi_7103_ = _e4108;
                                        } else {
                                            phi_7103_ = _e4112;
                                        }
                                        let _e4115 = phi_7103_;
                                        if (_e4101[2] < 0f) {
                                            phi_7110_ = -(_e4101[2]);
                                        } else {
                                            phi_7110_ = _e4101[2];
                                        }
                                        let _e4119 = phi_7110_;
                                        if (_e4115 > _e4119) {
                                            phi_7115_ = _e4115;
                                        } else {
                                            phi_7115_ = _e4119;
                                        }
                                        let _e4122 = phi_7115_;
                                        let _e4125 = local_1.member[1u];
                                        if (_e4125[0] < 0f) {
                                            phi_7128_ = -(_e4125[0]);
                                        } else {
                                            phi_7128_ = _e4125[0];
                                        }
                                        let _e4132 = phi_7128_;
                                        if (_e4125[1] < 0f) {
                                            phi_7135_ = -(_e4125[1]);
                                        } else {
                                            phi_7135_ = _e4125[1];
                                        }
                                        let _e4136 = phi_7135_;
                                        if (_e4132 > _e4136) {
                                            phi_7140_ = _e4132;
                                        } else {
                                            phi_7140_ = _e4136;
                                        }
                                        let _e4139 = phi_7140_;
                                        if (_e4125[2] < 0f) {
                                            phi_7147_ = -(_e4125[2]);
                                        } else {
                                            phi_7147_ = _e4125[2];
                                        }
                                        let _e4143 = phi_7147_;
                                        if (_e4139 > _e4143) {
                                            phi_7152_ = _e4139;
                                        } else {
                                            phi_7152_ = _e4143;
                                        }
                                        let _e4146 = phi_7152_;
                                        if (_e4122 > _e4146) {
                                            phi_7157_ = _e4122;
                                        } else {
                                            phi_7157_ = _e4146;
                                        }
                                        let _e4149 = phi_7157_;
                                        let _e4151 = local_1.member_3;
                                        let _e4155 = local_1.member_1[0u];
                                        if (_e4155[0] < 0f) {
                                            phi_7174_ = -(_e4155[0]);
                                        } else {
                                            phi_7174_ = _e4155[0];
                                        }
                                        let _e4162 = phi_7174_;
                                        if (_e4155[1] < 0f) {
                                            phi_7181_ = -(_e4155[1]);
                                        } else {
                                            phi_7181_ = _e4155[1];
                                        }
                                        let _e4166 = phi_7181_;
                                        if (_e4162 > _e4166) {
                                            phi_7186_ = _e4162;
                                        } else {
                                            phi_7186_ = _e4166;
                                        }
                                        let _e4169 = phi_7186_;
                                        if (_e4155[2] < 0f) {
                                            phi_7193_ = -(_e4155[2]);
                                        } else {
                                            phi_7193_ = _e4155[2];
                                        }
                                        let _e4173 = phi_7193_;
                                        if (_e4169 > _e4173) {
                                            phi_7198_ = _e4169;
                                        } else {
                                            phi_7198_ = _e4173;
                                        }
                                        let _e4176 = phi_7198_;
                                        let _e4179 = local_1.member_1[1u];
                                        if (_e4179[0] < 0f) {
                                            phi_7212_ = -(_e4179[0]);
                                        } else {
                                            phi_7212_ = _e4179[0];
                                        }
                                        let _e4186 = phi_7212_;
                                        if (_e4179[1] < 0f) {
                                            phi_7219_ = -(_e4179[1]);
                                        } else {
                                            phi_7219_ = _e4179[1];
                                        }
                                        let _e4190 = phi_7219_;
                                        if (_e4186 > _e4190) {
                                            phi_7224_ = _e4186;
                                        } else {
                                            phi_7224_ = _e4190;
                                        }
                                        let _e4193 = phi_7224_;
                                        if (_e4179[2] < 0f) {
                                            phi_7231_ = -(_e4179[2]);
                                        } else {
                                            phi_7231_ = _e4179[2];
                                        }
                                        let _e4197 = phi_7231_;
                                        if (_e4193 > _e4197) {
                                            phi_7236_ = _e4193;
                                        } else {
                                            phi_7236_ = _e4197;
                                        }
                                        let _e4200 = phi_7236_;
                                        if (_e4176 > _e4200) {
                                            phi_7241_ = _e4176;
                                        } else {
                                            phi_7241_ = _e4200;
                                        }
                                        let _e4203 = phi_7241_;
                                        let _e4205 = local_1.member_3;
                                        let _e4209 = local_1.member_2[0u];
                                        if (_e4209[0] < 0f) {
                                            phi_7258_ = -(_e4209[0]);
                                        } else {
                                            phi_7258_ = _e4209[0];
                                        }
                                        let _e4216 = phi_7258_;
                                        if (_e4209[1] < 0f) {
                                            phi_7265_ = -(_e4209[1]);
                                        } else {
                                            phi_7265_ = _e4209[1];
                                        }
                                        let _e4220 = phi_7265_;
                                        if (_e4216 > _e4220) {
                                            phi_7270_ = _e4216;
                                        } else {
                                            phi_7270_ = _e4220;
                                        }
                                        let _e4223 = phi_7270_;
                                        if (_e4209[2] < 0f) {
                                            phi_7277_ = -(_e4209[2]);
                                        } else {
                                            phi_7277_ = _e4209[2];
                                        }
                                        let _e4227 = phi_7277_;
                                        if (_e4223 > _e4227) {
                                            phi_7282_ = _e4223;
                                        } else {
                                            phi_7282_ = _e4227;
                                        }
                                        let _e4230 = phi_7282_;
                                        let _e4233 = local_1.member_2[1u];
                                        if (_e4233[0] < 0f) {
                                            phi_7296_ = -(_e4233[0]);
                                        } else {
                                            phi_7296_ = _e4233[0];
                                        }
                                        let _e4240 = phi_7296_;
                                        if (_e4233[1] < 0f) {
                                            phi_7303_ = -(_e4233[1]);
                                        } else {
                                            phi_7303_ = _e4233[1];
                                        }
                                        let _e4244 = phi_7303_;
                                        if (_e4240 > _e4244) {
                                            phi_7308_ = _e4240;
                                        } else {
                                            phi_7308_ = _e4244;
                                        }
                                        let _e4247 = phi_7308_;
                                        if (_e4233[2] < 0f) {
                                            phi_7315_ = -(_e4233[2]);
                                        } else {
                                            phi_7315_ = _e4233[2];
                                        }
                                        let _e4251 = phi_7315_;
                                        if (_e4247 > _e4251) {
                                            phi_7320_ = _e4247;
                                        } else {
                                            phi_7320_ = _e4251;
                                        }
                                        let _e4254 = phi_7320_;
                                        if (_e4230 > _e4254) {
                                            phi_7325_ = _e4230;
                                        } else {
                                            phi_7325_ = _e4254;
                                        }
                                        let _e4257 = phi_7325_;
                                        let _e4259 = local_1.member_3;
                                        let _e4262 = (((_e4149 + _e4151) + (_e4203 + _e4205)) + (_e4257 + _e4259));
                                        let _e4265 = local_1.member_3;
                                        let _e4269 = (((_e1525 * 1.0001f) + (_e4265 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4272 = ((_e4041 * _e4020) - (_e4044 * _e4019));
                                        let _e4275 = ((_e4044 * _e4018) - (_e4038 * _e4020));
                                        let _e4278 = ((_e4038 * _e4019) - (_e4041 * _e4018));
                                        let _e4283 = (((_e4272 * _e4047[0]) + (_e4275 * _e4047[1])) + (_e4278 * _e4047[2]));
                                        let _e4288 = (((_e4272 * _e4063) + (_e4275 * _e4064)) + (_e4278 * _e4065));
                                        let _e4293 = (((_e4272 * _e4069) + (_e4275 * _e4070)) + (_e4278 * _e4071));
                                        let _e4298 = (((_e4272 * _e4066) + (_e4275 * _e4067)) + (_e4278 * _e4068));
                                        let _e4303 = (((_e4272 * _e4074[0]) + (_e4275 * _e4074[1])) + (_e4278 * _e4074[2]));
                                        let _e4308 = (((_e4272 * _e4090) + (_e4275 * _e4091)) + (_e4278 * _e4092));
                                        let _e4313 = (((_e4272 * _e4096) + (_e4275 * _e4097)) + (_e4278 * _e4098));
                                        let _e4318 = (((_e4272 * _e4093) + (_e4275 * _e4094)) + (_e4278 * _e4095));
                                        if (_e4283 < _e4288) {
                                            phi_7403_ = _e4283;
                                        } else {
                                            phi_7403_ = _e4288;
                                        }
                                        let _e4321 = phi_7403_;
                                        if (_e4293 < _e4298) {
                                            phi_7408_ = _e4293;
                                        } else {
                                            phi_7408_ = _e4298;
                                        }
                                        let _e4324 = phi_7408_;
                                        if (_e4321 < _e4324) {
                                            phi_7413_ = _e4321;
                                        } else {
                                            phi_7413_ = _e4324;
                                        }
                                        let _e4327 = phi_7413_;
                                        if (_e4303 < _e4308) {
                                            phi_7418_ = _e4303;
                                        } else {
                                            phi_7418_ = _e4308;
                                        }
                                        let _e4330 = phi_7418_;
                                        if (_e4313 < _e4318) {
                                            phi_7423_ = _e4313;
                                        } else {
                                            phi_7423_ = _e4318;
                                        }
                                        let _e4333 = phi_7423_;
                                        if (_e4330 < _e4333) {
                                            phi_7428_ = _e4330;
                                        } else {
                                            phi_7428_ = _e4333;
                                        }
                                        let _e4336 = phi_7428_;
                                        if (_e4327 < _e4336) {
                                            phi_7433_ = _e4327;
                                        } else {
                                            phi_7433_ = _e4336;
                                        }
                                        let _e4339 = phi_7433_;
                                        if (_e4283 > _e4288) {
                                            phi_7438_ = _e4283;
                                        } else {
                                            phi_7438_ = _e4288;
                                        }
                                        let _e4342 = phi_7438_;
                                        if (_e4293 > _e4298) {
                                            phi_7443_ = _e4293;
                                        } else {
                                            phi_7443_ = _e4298;
                                        }
                                        let _e4345 = phi_7443_;
                                        if (_e4342 > _e4345) {
                                            phi_7448_ = _e4342;
                                        } else {
                                            phi_7448_ = _e4345;
                                        }
                                        let _e4348 = phi_7448_;
                                        if (_e4303 > _e4308) {
                                            phi_7453_ = _e4303;
                                        } else {
                                            phi_7453_ = _e4308;
                                        }
                                        let _e4351 = phi_7453_;
                                        if (_e4313 > _e4318) {
                                            phi_7458_ = _e4313;
                                        } else {
                                            phi_7458_ = _e4318;
                                        }
                                        let _e4354 = phi_7458_;
                                        if (_e4351 > _e4354) {
                                            phi_7463_ = _e4351;
                                        } else {
                                            phi_7463_ = _e4354;
                                        }
                                        let _e4357 = phi_7463_;
                                        if (_e4348 > _e4357) {
                                            phi_7468_ = _e4348;
                                        } else {
                                            phi_7468_ = _e4357;
                                        }
                                        let _e4360 = phi_7468_;
                                        if (_e4272 < 0f) {
                                            phi_7474_ = -(_e4272);
                                        } else {
                                            phi_7474_ = _e4272;
                                        }
                                        let _e4364 = phi_7474_;
                                        if (_e4275 < 0f) {
                                            phi_7480_ = -(_e4275);
                                        } else {
                                            phi_7480_ = _e4275;
                                        }
                                        let _e4368 = phi_7480_;
                                        if (_e4278 < 0f) {
                                            phi_7487_ = -(_e4278);
                                        } else {
                                            phi_7487_ = _e4278;
                                        }
                                        let _e4373 = phi_7487_;
                                        let _e4374 = ((_e4364 + _e4368) + _e4373);
                                        let _e4378 = -(_e4360);
                                        if (_e4339 > _e4378) {
                                            phi_7497_ = _e4339;
                                        } else {
                                            phi_7497_ = _e4378;
                                        }
                                        let _e4381 = phi_7497_;
                                        let _e4386 = (((_e4381 - ((_e4374 * _e4262) * (0.000000059604645f * 17f))) - (_e4374 * _e4269)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4389 = ((_e4041 * _e4035) - (_e4044 * _e4034));
                                        let _e4392 = ((_e4044 * _e4033) - (_e4038 * _e4035));
                                        let _e4395 = ((_e4038 * _e4034) - (_e4041 * _e4033));
                                        let _e4400 = (((_e4389 * _e4047[0]) + (_e4392 * _e4047[1])) + (_e4395 * _e4047[2]));
                                        let _e4405 = (((_e4389 * _e4063) + (_e4392 * _e4064)) + (_e4395 * _e4065));
                                        let _e4410 = (((_e4389 * _e4069) + (_e4392 * _e4070)) + (_e4395 * _e4071));
                                        let _e4415 = (((_e4389 * _e4066) + (_e4392 * _e4067)) + (_e4395 * _e4068));
                                        let _e4420 = (((_e4389 * _e4074[0]) + (_e4392 * _e4074[1])) + (_e4395 * _e4074[2]));
                                        let _e4425 = (((_e4389 * _e4090) + (_e4392 * _e4091)) + (_e4395 * _e4092));
                                        let _e4430 = (((_e4389 * _e4096) + (_e4392 * _e4097)) + (_e4395 * _e4098));
                                        let _e4435 = (((_e4389 * _e4093) + (_e4392 * _e4094)) + (_e4395 * _e4095));
                                        if (_e4400 < _e4405) {
                                            phi_7568_ = _e4400;
                                        } else {
                                            phi_7568_ = _e4405;
                                        }
                                        let _e4438 = phi_7568_;
                                        if (_e4410 < _e4415) {
                                            phi_7573_ = _e4410;
                                        } else {
                                            phi_7573_ = _e4415;
                                        }
                                        let _e4441 = phi_7573_;
                                        if (_e4438 < _e4441) {
                                            phi_7578_ = _e4438;
                                        } else {
                                            phi_7578_ = _e4441;
                                        }
                                        let _e4444 = phi_7578_;
                                        if (_e4420 < _e4425) {
                                            phi_7583_ = _e4420;
                                        } else {
                                            phi_7583_ = _e4425;
                                        }
                                        let _e4447 = phi_7583_;
                                        if (_e4430 < _e4435) {
                                            phi_7588_ = _e4430;
                                        } else {
                                            phi_7588_ = _e4435;
                                        }
                                        let _e4450 = phi_7588_;
                                        if (_e4447 < _e4450) {
                                            phi_7593_ = _e4447;
                                        } else {
                                            phi_7593_ = _e4450;
                                        }
                                        let _e4453 = phi_7593_;
                                        if (_e4444 < _e4453) {
                                            phi_7598_ = _e4444;
                                        } else {
                                            phi_7598_ = _e4453;
                                        }
                                        let _e4456 = phi_7598_;
                                        if (_e4400 > _e4405) {
                                            phi_7603_ = _e4400;
                                        } else {
                                            phi_7603_ = _e4405;
                                        }
                                        let _e4459 = phi_7603_;
                                        if (_e4410 > _e4415) {
                                            phi_7608_ = _e4410;
                                        } else {
                                            phi_7608_ = _e4415;
                                        }
                                        let _e4462 = phi_7608_;
                                        if (_e4459 > _e4462) {
                                            phi_7613_ = _e4459;
                                        } else {
                                            phi_7613_ = _e4462;
                                        }
                                        let _e4465 = phi_7613_;
                                        if (_e4420 > _e4425) {
                                            phi_7618_ = _e4420;
                                        } else {
                                            phi_7618_ = _e4425;
                                        }
                                        let _e4468 = phi_7618_;
                                        if (_e4430 > _e4435) {
                                            phi_7623_ = _e4430;
                                        } else {
                                            phi_7623_ = _e4435;
                                        }
                                        let _e4471 = phi_7623_;
                                        if (_e4468 > _e4471) {
                                            phi_7628_ = _e4468;
                                        } else {
                                            phi_7628_ = _e4471;
                                        }
                                        let _e4474 = phi_7628_;
                                        if (_e4465 > _e4474) {
                                            phi_7633_ = _e4465;
                                        } else {
                                            phi_7633_ = _e4474;
                                        }
                                        let _e4477 = phi_7633_;
                                        if (_e4389 < 0f) {
                                            phi_7639_ = -(_e4389);
                                        } else {
                                            phi_7639_ = _e4389;
                                        }
                                        let _e4481 = phi_7639_;
                                        if (_e4392 < 0f) {
                                            phi_7645_ = -(_e4392);
                                        } else {
                                            phi_7645_ = _e4392;
                                        }
                                        let _e4485 = phi_7645_;
                                        if (_e4395 < 0f) {
                                            phi_7652_ = -(_e4395);
                                        } else {
                                            phi_7652_ = _e4395;
                                        }
                                        let _e4490 = phi_7652_;
                                        let _e4491 = ((_e4481 + _e4485) + _e4490);
                                        let _e4495 = -(_e4477);
                                        if (_e4456 > _e4495) {
                                            phi_7662_ = _e4456;
                                        } else {
                                            phi_7662_ = _e4495;
                                        }
                                        let _e4498 = phi_7662_;
                                        let _e4503 = (((_e4498 - ((_e4491 * _e4262) * (0.000000059604645f * 17f))) - (_e4491 * _e4269)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4386 > _e4503) {
                                            phi_7672_ = _e4386;
                                        } else {
                                            phi_7672_ = _e4503;
                                        }
                                        let _e4506 = phi_7672_;
                                        phi_7852_ = (_e4506 > 0f);
                                    }
                                    let _e4509 = phi_7852_;
                                    phi_7853_ = _e4509;
                                } else {
                                    phi_7853_ = false;
                                }
                                let _e4511 = phi_7853_;
                                phi_7855_ = !(_e4511);
                            }
                            let _e4514 = phi_7855_;
                            if _e4514 {
                                let _e4516 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1026] = ((2147483648u | (_e4516 << bitcast<u32>(12i))) | _e1029);
                            }
                        }
                        phi_7865_ = true;
                    }
                    let _e4523 = phi_7865_;
                    phi_7866_ = _e4523;
                } else {
                    phi_7866_ = false;
                }
                let _e4525 = phi_7866_;
                continue;
                continuing {
                    phi_1842_ = _e1018;
                    break if !(_e4525);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4529 = atomicLoad((&counters[5u]));
                if (_e4529 > 0u) {
                    let _e4532 = atomicAdd((&output.member[0u]), _e4529);
                    if ((_e4532 + _e4529) < _e4532) {
                        let _e4536 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4532);
                }
            }
            workgroupBarrier();
            let _e4539 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4542 = atomicLoad((&counters[7u]));
                if (_e4542 > 0u) {
                    let _e4545 = atomicAdd((&output.member[1u]), _e4542);
                    if ((_e4545 + _e4542) < _e4545) {
                        let _e4549 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7916_ = type_21(0u, 16u);
            loop {
                let _e4551 = phi_7916_;
                if (_e4551.member < _e4551.member_1) {
                    phi_7917_ = type_21((_e4551.member + 1u), _e4551.member_1);
                    phi_7940_ = type_21(1u, _e4551.member);
                } else {
                    phi_7917_ = _e4551;
                    phi_7940_ = type_21(0u, type_21().member_1);
                }
                let _e4563 = phi_7917_;
                let _e4565 = phi_7940_;
                if (bitcast<i32>(_e4565.member) != 0i) {
                    let _e4571 = (_e67 + (_e4565.member_1 * 128u));
                    if (_e4571 >= _e1004) {
                        phi_8038_ = false;
                    } else {
                        let _e4574 = hits[_e4571];
                        if ((_e4574 & 2147483648u) == 0u) {
                            phi_7963_ = 4294967295u;
                        } else {
                            phi_7963_ = ((_e4574 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4581 = phi_7963_;
                        if (_e4581 != 4294967295u) {
                            let _e4585 = ((_e4574 >> bitcast<u32>(10i)) & 3u);
                            let _e4592 = firsts[(2u * _e4585)];
                            let _e4595 = leaves.member[(_e4592 + ((_e4574 >> bitcast<u32>(5i)) & 31u))];
                            let _e4599 = firsts[((2u * _e4585) + 1u)];
                            let _e4602 = leaves.member[(_e4599 + (_e4574 & 31u))];
                            let _e4606 = params.member.member_16;
                            let _e4607 = (_e4539 + _e4581);
                            if (_e4595.member_1 < _e4602.member_1) {
                                phi_8017_ = type_21(_e4595.member_1, _e4602.member_1);
                            } else {
                                phi_8017_ = type_21(_e4602.member_1, _e4595.member_1);
                            }
                            let _e4612 = phi_8017_;
                            if (_e4607 < _e4606) {
                                atomicStore((&output.member[(4u + (2u * _e4607))]), _e4612.member);
                                atomicStore((&output.member[((2u * _e4607) + 5u)]), _e4612.member_1);
                            }
                        }
                        phi_8038_ = true;
                    }
                    let _e4623 = phi_8038_;
                    phi_8039_ = _e4623;
                } else {
                    phi_8039_ = false;
                }
                let _e4625 = phi_8039_;
                continue;
                continuing {
                    phi_7916_ = _e4563;
                    break if !(_e4625);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_429_ = _e148;
            break if !(_e154);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
