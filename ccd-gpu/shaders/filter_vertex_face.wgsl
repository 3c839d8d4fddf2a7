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
    var phi_916_: u32;
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
    var phi_3088_: f32;
    var phi_3095_: f32;
    var phi_3100_: f32;
    var phi_3107_: f32;
    var phi_3112_: f32;
    var phi_3125_: f32;
    var phi_3132_: f32;
    var phi_3137_: f32;
    var phi_3144_: f32;
    var phi_3149_: f32;
    var phi_3154_: f32;
    var phi_3171_: f32;
    var phi_3178_: f32;
    var phi_3183_: f32;
    var phi_3190_: f32;
    var phi_3195_: f32;
    var phi_3209_: f32;
    var phi_3216_: f32;
    var phi_3221_: f32;
    var phi_3228_: f32;
    var phi_3233_: f32;
    var phi_3238_: f32;
    var phi_3255_: f32;
    var phi_3262_: f32;
    var phi_3267_: f32;
    var phi_3274_: f32;
    var phi_3279_: f32;
    var phi_3293_: f32;
    var phi_3300_: f32;
    var phi_3305_: f32;
    var phi_3312_: f32;
    var phi_3317_: f32;
    var phi_3322_: f32;
    var phi_3353_: f32;
    var phi_3359_: f32;
    var phi_3366_: f32;
    var phi_3373_: f32;
    var phi_3379_: f32;
    var phi_3386_: f32;
    var phi_3392_: f32;
    var phi_3398_: f32;
    var phi_3404_: f32;
    var phi_3411_: f32;
    var phi_3418_: f32;
    var phi_3442_: f32;
    var phi_3447_: f32;
    var phi_3452_: f32;
    var phi_3457_: f32;
    var phi_3462_: f32;
    var phi_3467_: f32;
    var phi_3477_: f32;
    var phi_3680_: f32;
    var phi_3687_: f32;
    var phi_3692_: f32;
    var phi_3699_: f32;
    var phi_3704_: f32;
    var phi_3717_: f32;
    var phi_3724_: f32;
    var phi_3729_: f32;
    var phi_3736_: f32;
    var phi_3741_: f32;
    var phi_3746_: f32;
    var phi_3763_: f32;
    var phi_3770_: f32;
    var phi_3775_: f32;
    var phi_3782_: f32;
    var phi_3787_: f32;
    var phi_3801_: f32;
    var phi_3808_: f32;
    var phi_3813_: f32;
    var phi_3820_: f32;
    var phi_3825_: f32;
    var phi_3830_: f32;
    var phi_3847_: f32;
    var phi_3854_: f32;
    var phi_3859_: f32;
    var phi_3866_: f32;
    var phi_3871_: f32;
    var phi_3885_: f32;
    var phi_3892_: f32;
    var phi_3897_: f32;
    var phi_3904_: f32;
    var phi_3909_: f32;
    var phi_3914_: f32;
    var phi_3993_: f32;
    var phi_3998_: f32;
    var phi_4003_: f32;
    var phi_4008_: f32;
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
    var phi_4064_: f32;
    var phi_4070_: f32;
    var phi_4077_: f32;
    var phi_4088_: f32;
    var phi_4159_: f32;
    var phi_4164_: f32;
    var phi_4169_: f32;
    var phi_4174_: f32;
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
    var phi_4230_: f32;
    var phi_4236_: f32;
    var phi_4243_: f32;
    var phi_4254_: f32;
    var phi_4264_: f32;
    var phi_4337_: f32;
    var phi_4342_: f32;
    var phi_4347_: f32;
    var phi_4352_: f32;
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
    var phi_4408_: f32;
    var phi_4414_: f32;
    var phi_4421_: f32;
    var phi_4432_: f32;
    var phi_4442_: f32;
    var phi_4445_: bool;
    var phi_4897_: f32;
    var phi_4904_: f32;
    var phi_4909_: f32;
    var phi_4916_: f32;
    var phi_4921_: f32;
    var phi_4934_: f32;
    var phi_4941_: f32;
    var phi_4946_: f32;
    var phi_4953_: f32;
    var phi_4958_: f32;
    var phi_4963_: f32;
    var phi_4980_: f32;
    var phi_4987_: f32;
    var phi_4992_: f32;
    var phi_4999_: f32;
    var phi_5004_: f32;
    var phi_5018_: f32;
    var phi_5025_: f32;
    var phi_5030_: f32;
    var phi_5037_: f32;
    var phi_5042_: f32;
    var phi_5047_: f32;
    var phi_5064_: f32;
    var phi_5071_: f32;
    var phi_5076_: f32;
    var phi_5083_: f32;
    var phi_5088_: f32;
    var phi_5102_: f32;
    var phi_5109_: f32;
    var phi_5114_: f32;
    var phi_5121_: f32;
    var phi_5126_: f32;
    var phi_5131_: f32;
    var phi_5162_: f32;
    var phi_5168_: f32;
    var phi_5175_: f32;
    var phi_5182_: f32;
    var phi_5188_: f32;
    var phi_5195_: f32;
    var phi_5201_: f32;
    var phi_5207_: f32;
    var phi_5213_: f32;
    var phi_5220_: f32;
    var phi_5227_: f32;
    var phi_5251_: f32;
    var phi_5256_: f32;
    var phi_5261_: f32;
    var phi_5266_: f32;
    var phi_5271_: f32;
    var phi_5276_: f32;
    var phi_5286_: f32;
    var phi_5489_: f32;
    var phi_5496_: f32;
    var phi_5501_: f32;
    var phi_5508_: f32;
    var phi_5513_: f32;
    var phi_5526_: f32;
    var phi_5533_: f32;
    var phi_5538_: f32;
    var phi_5545_: f32;
    var phi_5550_: f32;
    var phi_5555_: f32;
    var phi_5572_: f32;
    var phi_5579_: f32;
    var phi_5584_: f32;
    var phi_5591_: f32;
    var phi_5596_: f32;
    var phi_5610_: f32;
    var phi_5617_: f32;
    var phi_5622_: f32;
    var phi_5629_: f32;
    var phi_5634_: f32;
    var phi_5639_: f32;
    var phi_5656_: f32;
    var phi_5663_: f32;
    var phi_5668_: f32;
    var phi_5675_: f32;
    var phi_5680_: f32;
    var phi_5694_: f32;
    var phi_5701_: f32;
    var phi_5706_: f32;
    var phi_5713_: f32;
    var phi_5718_: f32;
    var phi_5723_: f32;
    var phi_5802_: f32;
    var phi_5807_: f32;
    var phi_5812_: f32;
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
    var phi_5873_: f32;
    var phi_5879_: f32;
    var phi_5886_: f32;
    var phi_5897_: f32;
    var phi_5968_: f32;
    var phi_5973_: f32;
    var phi_5978_: f32;
    var phi_5983_: f32;
    var phi_5988_: f32;
    var phi_5993_: f32;
    var phi_5998_: f32;
    var phi_6003_: f32;
    var phi_6008_: f32;
    var phi_6013_: f32;
    var phi_6018_: f32;
    var phi_6023_: f32;
    var phi_6028_: f32;
    var phi_6033_: f32;
    var phi_6039_: f32;
    var phi_6045_: f32;
    var phi_6052_: f32;
    var phi_6063_: f32;
    var phi_6073_: f32;
    var phi_6146_: f32;
    var phi_6151_: f32;
    var phi_6156_: f32;
    var phi_6161_: f32;
    var phi_6166_: f32;
    var phi_6171_: f32;
    var phi_6176_: f32;
    var phi_6181_: f32;
    var phi_6186_: f32;
    var phi_6191_: f32;
    var phi_6196_: f32;
    var phi_6201_: f32;
    var phi_6206_: f32;
    var phi_6211_: f32;
    var phi_6217_: f32;
    var phi_6223_: f32;
    var phi_6230_: f32;
    var phi_6241_: f32;
    var phi_6251_: f32;
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
    var phi_7404_: f32;
    var phi_7409_: f32;
    var phi_7414_: f32;
    var phi_7419_: f32;
    var phi_7424_: f32;
    var phi_7429_: f32;
    var phi_7434_: f32;
    var phi_7439_: f32;
    var phi_7444_: f32;
    var phi_7449_: f32;
    var phi_7454_: f32;
    var phi_7459_: f32;
    var phi_7464_: f32;
    var phi_7469_: f32;
    var phi_7475_: f32;
    var phi_7481_: f32;
    var phi_7488_: f32;
    var phi_7499_: f32;
    var phi_7570_: f32;
    var phi_7575_: f32;
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
    var phi_7641_: f32;
    var phi_7647_: f32;
    var phi_7654_: f32;
    var phi_7665_: f32;
    var phi_7675_: f32;
    var phi_7748_: f32;
    var phi_7753_: f32;
    var phi_7758_: f32;
    var phi_7763_: f32;
    var phi_7768_: f32;
    var phi_7773_: f32;
    var phi_7778_: f32;
    var phi_7783_: f32;
    var phi_7788_: f32;
    var phi_7793_: f32;
    var phi_7798_: f32;
    var phi_7803_: f32;
    var phi_7808_: f32;
    var phi_7813_: f32;
    var phi_7819_: f32;
    var phi_7825_: f32;
    var phi_7832_: f32;
    var phi_7843_: f32;
    var phi_7853_: f32;
    var phi_7856_: bool;
    var phi_7857_: bool;
    var phi_7859_: bool;
    var phi_7869_: bool;
    var phi_7870_: bool;
    var phi_7920_: type_21;
    var phi_7921_: type_21;
    var phi_7944_: type_21;
    var phi_7967_: u32;
    var phi_8042_: bool;
    var phi_8043_: bool;
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
            let _e204 = params.member.member_20[0u][0u];
            let _e205 = (_e204 + (_e194 * 32u));
            let _e210 = params.member.member_20[0u][2u];
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
            let _e362 = (_e67 / 32u);
            let _e365 = atomicLoad((&counters[_e362]));
            phi_800_ = type_21(0u, _e365);
            phi_803_ = 0u;
            loop {
                let _e368 = phi_800_;
                let _e370 = phi_803_;
                local_3 = _e370;
                if (_e368.member < _e368.member_1) {
                    phi_801_ = type_21((_e368.member + 1u), _e368.member_1);
                    phi_826_ = type_21(1u, _e368.member);
                } else {
                    phi_801_ = _e368;
                    phi_826_ = type_21(0u, type_21().member_1);
                }
                let _e382 = phi_801_;
                let _e384 = phi_826_;
                let _e388 = (bitcast<i32>(_e384.member) != 0i);
                if _e388 {
                    let _e392 = names[((_e362 * 32u) + _e384.member_1)];
                    let _e396 = columns[((_e362 * 32u) + _e384.member_1)];
                    if ((((((_e361.member[0] <= _e396.member_1[0]) && (_e396.member[0] <= _e361.member_1[0])) && (_e361.member[1] <= _e396.member_1[1])) && (_e396.member[1] <= _e361.member_1[1])) && (_e361.member[2] <= _e396.member_1[2])) && (_e396.member[2] <= _e361.member_1[2])) {
                        let _e429 = atomicAdd((&counters[4u]), 1u);
                        if (_e429 < 2048u) {
                            hits[_e429] = (((_e362 << bitcast<u32>(10i)) | ((_e67 % 32u) << bitcast<u32>(5i))) | _e392);
                            phi_916_ = _e370;
                        } else {
                            phi_916_ = (_e370 | (1u << bitcast<u32>((_e384.member_1 & 31u))));
                        }
                        let _e443 = phi_916_;
                        phi_918_ = _e443;
                    } else {
                        phi_918_ = _e370;
                    }
                    let _e445 = phi_918_;
                    phi_804_ = _e445;
                } else {
                    phi_804_ = u32();
                }
                let _e447 = phi_804_;
                continue;
                continuing {
                    phi_800_ = _e382;
                    phi_803_ = _e447;
                    break if !(_e388);
                }
            }
            phi_921_ = type_21(0u, 32u);
            let _e4986 = local_3;
            phi_924_ = _e4986;
            loop {
                let _e450 = phi_921_;
                let _e452 = phi_924_;
                if (_e450.member < _e450.member_1) {
                    phi_922_ = type_21((_e450.member + 1u), _e450.member_1);
                    phi_947_ = type_21(1u, _e450.member);
                } else {
                    phi_922_ = _e450;
                    phi_947_ = type_21(0u, type_21().member_1);
                }
                let _e464 = phi_922_;
                let _e466 = phi_947_;
                if (bitcast<i32>(_e466.member) != 0i) {
                    if (_e452 == 0u) {
                        phi_1830_ = u32();
                        phi_1831_ = false;
                    } else {
                        let _e477 = names[((_e91 * 32u) + select(firstTrailingBit(_e452), 32u, (_e452 == 0u)))];
                        let _e480 = (_e205 + _e92);
                        let _e481 = (_e211 + _e477);
                        let _e483 = leaves.member[_e480];
                        let _e485 = leaves.member[_e481];
                        let _e487 = nodes.member[_e480];
                        let _e489 = nodes.member[_e481];
                        let _e491 = params.member.member_1;
                        if ((_e491 & 1u) != 0u) {
                            let _e495 = params.member.member_8;
                            if (_e495 == 0u) {
                                if (_e483.member[0] == _e485.member[0]) {
                                    phi_1038_ = bool();
                                    phi_1039_ = true;
                                } else {
                                    let _e538 = (_e483.member[0] == _e485.member[1]);
                                    if _e538 {
                                        phi_1037_ = bool();
                                    } else {
                                        phi_1037_ = (_e483.member[0] == _e485.member[2]);
                                    }
                                    let _e545 = phi_1037_;
                                    phi_1038_ = _e545;
                                    phi_1039_ = _e538;
                                }
                                let _e547 = phi_1038_;
                                let _e549 = phi_1039_;
                                if _e549 {
                                    phi_1043_ = true;
                                } else {
                                    phi_1043_ = _e547;
                                }
                                let _e551 = phi_1043_;
                                phi_1074_ = _e551;
                            } else {
                                if (_e483.member[0] == _e485.member[0]) {
                                    phi_1068_ = bool();
                                    phi_1069_ = true;
                                } else {
                                    if (_e483.member[0] == _e485.member[1]) {
                                        phi_1066_ = bool();
                                        phi_1067_ = true;
                                    } else {
                                        let _e511 = (_e483.member[1] == _e485.member[0]);
                                        if _e511 {
                                            phi_1065_ = bool();
                                        } else {
                                            phi_1065_ = (_e483.member[1] == _e485.member[1]);
                                        }
                                        let _e518 = phi_1065_;
                                        phi_1066_ = _e518;
                                        phi_1067_ = _e511;
                                    }
                                    let _e520 = phi_1066_;
                                    let _e522 = phi_1067_;
                                    phi_1068_ = _e520;
                                    phi_1069_ = _e522;
                                }
                                let _e524 = phi_1068_;
                                let _e526 = phi_1069_;
                                if _e526 {
                                    phi_1073_ = true;
                                } else {
                                    phi_1073_ = _e524;
                                }
                                let _e528 = phi_1073_;
                                phi_1074_ = _e528;
                            }
                            let _e553 = phi_1074_;
                            if _e553 {
                                phi_1078_ = false;
                            } else {
                                phi_1078_ = true;
                            }
                            let _e555 = phi_1078_;
                            phi_1079_ = _e555;
                        } else {
                            phi_1079_ = true;
                        }
                        let _e557 = phi_1079_;
                        if _e557 {
                            let _e559 = params.member.member_1;
                            if ((_e559 & 2u) != 0u) {
                                let _e565 = bodies.member[_e483.member[0]];
                                let _e569 = bodies.member[_e485.member[0]];
                                if ((_e565 / 2u) == (_e569 / 2u)) {
                                    let _e574 = params.member.member_1;
                                    phi_1123_ = !(((_e574 & 4u) != 0u));
                                } else {
                                    phi_1123_ = false;
                                }
                                let _e579 = phi_1123_;
                                if _e579 {
                                    phi_1134_ = true;
                                } else {
                                    if (((_e565 & _e569) & 1u) == 0u) {
                                        phi_1133_ = false;
                                    } else {
                                        phi_1133_ = true;
                                    }
                                    let _e584 = phi_1133_;
                                    phi_1134_ = _e584;
                                }
                                let _e586 = phi_1134_;
                                if _e586 {
                                    phi_1138_ = false;
                                } else {
                                    phi_1138_ = true;
                                }
                                let _e588 = phi_1138_;
                                phi_1139_ = _e588;
                            } else {
                                phi_1139_ = true;
                            }
                            let _e590 = phi_1139_;
                            if _e590 {
                                let _e592 = params.member.member_1;
                                if ((_e592 & 32u) != 0u) {
                                    let _e596 = params.member.member_6;
                                    let _e637 = (((((((_e487.member_1[0] - _e489.member[0]) > _e596) && ((_e489.member_1[0] - _e487.member[0]) > _e596)) && ((_e487.member_1[1] - _e489.member[1]) > _e596)) && ((_e489.member_1[1] - _e487.member[1]) > _e596)) && ((_e487.member_1[2] - _e489.member[2]) > _e596)) && ((_e489.member_1[2] - _e487.member[2]) > _e596));
                                    if _e637 {
                                        phi_1753_ = bool();
                                    } else {
                                        let _e641 = keys.member[_e483.member[0]];
                                        let _e646 = keys.member[_e483.member[1]];
                                        let _e648 = function_(_e641[0], _e646[0]);
                                        let _e652 = keys.member[_e483.member[2]];
                                        let _e654 = function_(_e648, _e652[0]);
                                        let _e658 = keys.member[_e485.member[0]];
                                        let _e663 = keys.member[_e485.member[1]];
                                        let _e665 = function_1(_e658[3], _e663[3]);
                                        let _e669 = keys.member[_e485.member[2]];
                                        let _e671 = function_1(_e665, _e669[3]);
                                        if (_e654[1] > _e671[1]) {
                                            phi_1276_ = true;
                                        } else {
                                            if (_e654[1] == _e671[1]) {
                                                phi_1275_ = (_e654[0] > _e671[0]);
                                            } else {
                                                phi_1275_ = false;
                                            }
                                            let _e682 = phi_1275_;
                                            phi_1276_ = _e682;
                                        }
                                        let _e684 = phi_1276_;
                                        let _e689 = keys.member[_e485.member[0]];
                                        let _e694 = keys.member[_e485.member[1]];
                                        let _e696 = function_(_e689[0], _e694[0]);
                                        let _e700 = keys.member[_e485.member[2]];
                                        let _e702 = function_(_e696, _e700[0]);
                                        let _e706 = keys.member[_e483.member[0]];
                                        let _e711 = keys.member[_e483.member[1]];
                                        let _e713 = function_1(_e706[3], _e711[3]);
                                        let _e717 = keys.member[_e483.member[2]];
                                        let _e719 = function_1(_e713, _e717[3]);
                                        if (_e702[1] > _e719[1]) {
                                            phi_1370_ = true;
                                        } else {
                                            if (_e702[1] == _e719[1]) {
                                                phi_1369_ = (_e702[0] > _e719[0]);
                                            } else {
                                                phi_1369_ = false;
                                            }
                                            let _e730 = phi_1369_;
                                            phi_1370_ = _e730;
                                        }
                                        let _e732 = phi_1370_;
                                        let _e738 = keys.member[_e483.member[0]];
                                        let _e743 = keys.member[_e483.member[1]];
                                        let _e745 = function_2(_e738[1], _e743[1]);
                                        let _e749 = keys.member[_e483.member[2]];
                                        let _e751 = function_2(_e745, _e749[1]);
                                        let _e755 = keys.member[_e485.member[0]];
                                        let _e760 = keys.member[_e485.member[1]];
                                        let _e762 = function_3(_e755[4], _e760[4]);
                                        let _e766 = keys.member[_e485.member[2]];
                                        let _e768 = function_3(_e762, _e766[4]);
                                        if (_e751[1] > _e768[1]) {
                                            phi_1465_ = true;
                                        } else {
                                            if (_e751[1] == _e768[1]) {
                                                phi_1464_ = (_e751[0] > _e768[0]);
                                            } else {
                                                phi_1464_ = false;
                                            }
                                            let _e779 = phi_1464_;
                                            phi_1465_ = _e779;
                                        }
                                        let _e781 = phi_1465_;
                                        let _e786 = keys.member[_e485.member[0]];
                                        let _e791 = keys.member[_e485.member[1]];
                                        let _e793 = function_2(_e786[1], _e791[1]);
                                        let _e797 = keys.member[_e485.member[2]];
                                        let _e799 = function_2(_e793, _e797[1]);
                                        let _e803 = keys.member[_e483.member[0]];
                                        let _e808 = keys.member[_e483.member[1]];
                                        let _e810 = function_3(_e803[4], _e808[4]);
                                        let _e814 = keys.member[_e483.member[2]];
                                        let _e816 = function_3(_e810, _e814[4]);
                                        if (_e799[1] > _e816[1]) {
                                            phi_1559_ = true;
                                        } else {
                                            if (_e799[1] == _e816[1]) {
                                                phi_1558_ = (_e799[0] > _e816[0]);
                                            } else {
                                                phi_1558_ = false;
                                            }
                                            let _e827 = phi_1558_;
                                            phi_1559_ = _e827;
                                        }
                                        let _e829 = phi_1559_;
                                        let _e836 = keys.member[_e483.member[0]];
                                        let _e841 = keys.member[_e483.member[1]];
                                        let _e843 = function_4(_e836[2], _e841[2]);
                                        let _e847 = keys.member[_e483.member[2]];
                                        let _e849 = function_4(_e843, _e847[2]);
                                        let _e853 = keys.member[_e485.member[0]];
                                        let _e858 = keys.member[_e485.member[1]];
                                        let _e860 = function_5(_e853[5], _e858[5]);
                                        let _e864 = keys.member[_e485.member[2]];
                                        let _e866 = function_5(_e860, _e864[5]);
                                        if (_e849[1] > _e866[1]) {
                                            phi_1655_ = true;
                                        } else {
                                            if (_e849[1] == _e866[1]) {
                                                phi_1654_ = (_e849[0] > _e866[0]);
                                            } else {
                                                phi_1654_ = false;
                                            }
                                            let _e877 = phi_1654_;
                                            phi_1655_ = _e877;
                                        }
                                        let _e879 = phi_1655_;
                                        let _e884 = keys.member[_e485.member[0]];
                                        let _e889 = keys.member[_e485.member[1]];
                                        let _e891 = function_4(_e884[2], _e889[2]);
                                        let _e895 = keys.member[_e485.member[2]];
                                        let _e897 = function_4(_e891, _e895[2]);
                                        let _e901 = keys.member[_e483.member[0]];
                                        let _e906 = keys.member[_e483.member[1]];
                                        let _e908 = function_5(_e901[5], _e906[5]);
                                        let _e912 = keys.member[_e483.member[2]];
                                        let _e914 = function_5(_e908, _e912[5]);
                                        if (_e897[1] > _e914[1]) {
                                            phi_1749_ = true;
                                        } else {
                                            if (_e897[1] == _e914[1]) {
                                                phi_1748_ = (_e897[0] > _e914[0]);
                                            } else {
                                                phi_1748_ = false;
                                            }
                                            let _e925 = phi_1748_;
                                            phi_1749_ = _e925;
                                        }
                                        let _e927 = phi_1749_;
                                        phi_1753_ = (((!(_e684) && !(_e732)) && (!(_e781) && !(_e829))) && (!(_e879) && !(_e927)));
                                    }
                                    let _e932 = phi_1753_;
                                    phi_1754_ = _e932;
                                    phi_1755_ = _e637;
                                } else {
                                    phi_1754_ = bool();
                                    phi_1755_ = true;
                                }
                                let _e934 = phi_1754_;
                                let _e936 = phi_1755_;
                                if _e936 {
                                    phi_1759_ = false;
                                } else {
                                    phi_1759_ = true;
                                }
                                let _e938 = phi_1759_;
                                phi_1760_ = _e934;
                                phi_1761_ = _e938;
                            } else {
                                phi_1760_ = false;
                                phi_1761_ = true;
                            }
                            let _e940 = phi_1760_;
                            let _e942 = phi_1761_;
                            phi_1762_ = _e940;
                            phi_1763_ = _e942;
                        } else {
                            phi_1762_ = false;
                            phi_1763_ = true;
                        }
                        let _e944 = phi_1762_;
                        let _e946 = phi_1763_;
                        if _e946 {
                            phi_1767_ = _e944;
                        } else {
                            phi_1767_ = true;
                        }
                        let _e948 = phi_1767_;
                        if _e948 {
                            let _e950 = params.member.member_16;
                            let _e954 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e954 + 1u) < _e954) {
                                let _e958 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e954 < _e950) {
                                atomicStore((&output.member[(4u + (2u * _e954))]), _e483.member_1);
                                atomicStore((&output.member[((2u * _e954) + 5u)]), _e485.member_1);
                            }
                            let _e967 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e967 + 1u) < _e967) {
                                let _e971 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1830_ = (_e452 & (_e452 - 1u));
                        phi_1831_ = true;
                    }
                    let _e973 = phi_1830_;
                    let _e975 = phi_1831_;
                    phi_925_ = _e973;
                    phi_1832_ = _e975;
                } else {
                    phi_925_ = u32();
                    phi_1832_ = false;
                }
                let _e977 = phi_925_;
                let _e979 = phi_1832_;
                continue;
                continuing {
                    phi_921_ = _e464;
                    phi_924_ = _e977;
                    break if !(_e979);
                }
            }
            workgroupBarrier();
            let _e982 = atomicLoad((&counters[4u]));
            if (2048u < _e982) {
                phi_1839_ = 2048u;
            } else {
                phi_1839_ = _e982;
            }
            let _e985 = phi_1839_;
            phi_1842_ = type_21(0u, 16u);
            loop {
                let _e987 = phi_1842_;
                if (_e987.member < _e987.member_1) {
                    phi_1843_ = type_21((_e987.member + 1u), _e987.member_1);
                    phi_1866_ = type_21(1u, _e987.member);
                } else {
                    phi_1843_ = _e987;
                    phi_1866_ = type_21(0u, type_21().member_1);
                }
                let _e999 = phi_1843_;
                let _e1001 = phi_1866_;
                if (bitcast<i32>(_e1001.member) != 0i) {
                    let _e1007 = (_e67 + (_e1001.member_1 * 128u));
                    if (_e1007 >= _e985) {
                        phi_7869_ = false;
                    } else {
                        let _e1010 = hits[_e1007];
                        let _e1013 = ((_e1010 >> bitcast<u32>(10i)) & 3u);
                        let _e1020 = firsts[(2u * _e1013)];
                        let _e1021 = (_e1020 + ((_e1010 >> bitcast<u32>(5i)) & 31u));
                        let _e1025 = firsts[((2u * _e1013) + 1u)];
                        let _e1026 = (_e1025 + (_e1010 & 31u));
                        let _e1028 = leaves.member[_e1021];
                        let _e1030 = leaves.member[_e1026];
                        let _e1032 = nodes.member[_e1021];
                        let _e1034 = nodes.member[_e1026];
                        let _e1036 = params.member.member_1;
                        if ((_e1036 & 1u) != 0u) {
                            let _e1040 = params.member.member_8;
                            if (_e1040 == 0u) {
                                if (_e1028.member[0] == _e1030.member[0]) {
                                    phi_1965_ = bool();
                                    phi_1966_ = true;
                                } else {
                                    let _e1083 = (_e1028.member[0] == _e1030.member[1]);
                                    if _e1083 {
                                        phi_1964_ = bool();
                                    } else {
                                        phi_1964_ = (_e1028.member[0] == _e1030.member[2]);
                                    }
                                    let _e1090 = phi_1964_;
                                    phi_1965_ = _e1090;
                                    phi_1966_ = _e1083;
                                }
                                let _e1092 = phi_1965_;
                                let _e1094 = phi_1966_;
                                if _e1094 {
                                    phi_1970_ = true;
                                } else {
                                    phi_1970_ = _e1092;
                                }
                                let _e1096 = phi_1970_;
                                phi_2001_ = _e1096;
                            } else {
                                if (_e1028.member[0] == _e1030.member[0]) {
                                    phi_1995_ = bool();
                                    phi_1996_ = true;
                                } else {
                                    if (_e1028.member[0] == _e1030.member[1]) {
                                        phi_1993_ = bool();
                                        phi_1994_ = true;
                                    } else {
                                        let _e1056 = (_e1028.member[1] == _e1030.member[0]);
                                        if _e1056 {
                                            phi_1992_ = bool();
                                        } else {
                                            phi_1992_ = (_e1028.member[1] == _e1030.member[1]);
                                        }
                                        let _e1063 = phi_1992_;
                                        phi_1993_ = _e1063;
                                        phi_1994_ = _e1056;
                                    }
                                    let _e1065 = phi_1993_;
                                    let _e1067 = phi_1994_;
                                    phi_1995_ = _e1065;
                                    phi_1996_ = _e1067;
                                }
                                let _e1069 = phi_1995_;
                                let _e1071 = phi_1996_;
                                if _e1071 {
                                    phi_2000_ = true;
                                } else {
                                    phi_2000_ = _e1069;
                                }
                                let _e1073 = phi_2000_;
                                phi_2001_ = _e1073;
                            }
                            let _e1098 = phi_2001_;
                            if _e1098 {
                                phi_2005_ = false;
                            } else {
                                phi_2005_ = true;
                            }
                            let _e1100 = phi_2005_;
                            phi_2006_ = _e1100;
                        } else {
                            phi_2006_ = true;
                        }
                        let _e1102 = phi_2006_;
                        if _e1102 {
                            let _e1104 = params.member.member_1;
                            if ((_e1104 & 2u) != 0u) {
                                let _e1110 = bodies.member[_e1028.member[0]];
                                let _e1114 = bodies.member[_e1030.member[0]];
                                if ((_e1110 / 2u) == (_e1114 / 2u)) {
                                    let _e1119 = params.member.member_1;
                                    phi_2050_ = !(((_e1119 & 4u) != 0u));
                                } else {
                                    phi_2050_ = false;
                                }
                                let _e1124 = phi_2050_;
                                if _e1124 {
                                    phi_2061_ = true;
                                } else {
                                    if (((_e1110 & _e1114) & 1u) == 0u) {
                                        phi_2060_ = false;
                                    } else {
                                        phi_2060_ = true;
                                    }
                                    let _e1129 = phi_2060_;
                                    phi_2061_ = _e1129;
                                }
                                let _e1131 = phi_2061_;
                                if _e1131 {
                                    phi_2065_ = false;
                                } else {
                                    phi_2065_ = true;
                                }
                                let _e1133 = phi_2065_;
                                phi_2066_ = _e1133;
                            } else {
                                phi_2066_ = true;
                            }
                            let _e1135 = phi_2066_;
                            if _e1135 {
                                let _e1137 = params.member.member_1;
                                if ((_e1137 & 32u) != 0u) {
                                    let _e1141 = params.member.member_6;
                                    let _e1182 = (((((((_e1032.member_1[0] - _e1034.member[0]) > _e1141) && ((_e1034.member_1[0] - _e1032.member[0]) > _e1141)) && ((_e1032.member_1[1] - _e1034.member[1]) > _e1141)) && ((_e1034.member_1[1] - _e1032.member[1]) > _e1141)) && ((_e1032.member_1[2] - _e1034.member[2]) > _e1141)) && ((_e1034.member_1[2] - _e1032.member[2]) > _e1141));
                                    if _e1182 {
                                        phi_2680_ = bool();
                                    } else {
                                        let _e1186 = keys.member[_e1028.member[0]];
                                        let _e1191 = keys.member[_e1028.member[1]];
                                        let _e1193 = function_(_e1186[0], _e1191[0]);
                                        let _e1197 = keys.member[_e1028.member[2]];
                                        let _e1199 = function_(_e1193, _e1197[0]);
                                        let _e1203 = keys.member[_e1030.member[0]];
                                        let _e1208 = keys.member[_e1030.member[1]];
                                        let _e1210 = function_1(_e1203[3], _e1208[3]);
                                        let _e1214 = keys.member[_e1030.member[2]];
                                        let _e1216 = function_1(_e1210, _e1214[3]);
                                        if (_e1199[1] > _e1216[1]) {
                                            phi_2203_ = true;
                                        } else {
                                            if (_e1199[1] == _e1216[1]) {
                                                phi_2202_ = (_e1199[0] > _e1216[0]);
                                            } else {
                                                phi_2202_ = false;
                                            }
                                            let _e1227 = phi_2202_;
                                            phi_2203_ = _e1227;
                                        }
                                        let _e1229 = phi_2203_;
                                        let _e1234 = keys.member[_e1030.member[0]];
                                        let _e1239 = keys.member[_e1030.member[1]];
                                        let _e1241 = function_(_e1234[0], _e1239[0]);
                                        let _e1245 = keys.member[_e1030.member[2]];
                                        let _e1247 = function_(_e1241, _e1245[0]);
                                        let _e1251 = keys.member[_e1028.member[0]];
                                        let _e1256 = keys.member[_e1028.member[1]];
                                        let _e1258 = function_1(_e1251[3], _e1256[3]);
                                        let _e1262 = keys.member[_e1028.member[2]];
                                        let _e1264 = function_1(_e1258, _e1262[3]);
                                        if (_e1247[1] > _e1264[1]) {
                                            phi_2297_ = true;
                                        } else {
                                            if (_e1247[1] == _e1264[1]) {
                                                phi_2296_ = (_e1247[0] > _e1264[0]);
                                            } else {
                                                phi_2296_ = false;
                                            }
                                            let _e1275 = phi_2296_;
                                            phi_2297_ = _e1275;
                                        }
                                        let _e1277 = phi_2297_;
                                        let _e1283 = keys.member[_e1028.member[0]];
                                        let _e1288 = keys.member[_e1028.member[1]];
                                        let _e1290 = function_2(_e1283[1], _e1288[1]);
                                        let _e1294 = keys.member[_e1028.member[2]];
                                        let _e1296 = function_2(_e1290, _e1294[1]);
                                        let _e1300 = keys.member[_e1030.member[0]];
                                        let _e1305 = keys.member[_e1030.member[1]];
                                        let _e1307 = function_3(_e1300[4], _e1305[4]);
                                        let _e1311 = keys.member[_e1030.member[2]];
                                        let _e1313 = function_3(_e1307, _e1311[4]);
                                        if (_e1296[1] > _e1313[1]) {
                                            phi_2392_ = true;
                                        } else {
                                            if (_e1296[1] == _e1313[1]) {
                                                phi_2391_ = (_e1296[0] > _e1313[0]);
                                            } else {
                                                phi_2391_ = false;
                                            }
                                            let _e1324 = phi_2391_;
                                            phi_2392_ = _e1324;
                                        }
                                        let _e1326 = phi_2392_;
                                        let _e1331 = keys.member[_e1030.member[0]];
                                        let _e1336 = keys.member[_e1030.member[1]];
                                        let _e1338 = function_2(_e1331[1], _e1336[1]);
                                        let _e1342 = keys.member[_e1030.member[2]];
                                        let _e1344 = function_2(_e1338, _e1342[1]);
                                        let _e1348 = keys.member[_e1028.member[0]];
                                        let _e1353 = keys.member[_e1028.member[1]];
                                        let _e1355 = function_3(_e1348[4], _e1353[4]);
                                        let _e1359 = keys.member[_e1028.member[2]];
                                        let _e1361 = function_3(_e1355, _e1359[4]);
                                        if (_e1344[1] > _e1361[1]) {
                                            phi_2486_ = true;
                                        } else {
                                            if (_e1344[1] == _e1361[1]) {
                                                phi_2485_ = (_e1344[0] > _e1361[0]);
                                            } else {
                                                phi_2485_ = false;
                                            }
                                            let _e1372 = phi_2485_;
                                            phi_2486_ = _e1372;
                                        }
                                        let _e1374 = phi_2486_;
                                        let _e1381 = keys.member[_e1028.member[0]];
                                        let _e1386 = keys.member[_e1028.member[1]];
                                        let _e1388 = function_4(_e1381[2], _e1386[2]);
                                        let _e1392 = keys.member[_e1028.member[2]];
                                        let _e1394 = function_4(_e1388, _e1392[2]);
                                        let _e1398 = keys.member[_e1030.member[0]];
                                        let _e1403 = keys.member[_e1030.member[1]];
                                        let _e1405 = function_5(_e1398[5], _e1403[5]);
                                        let _e1409 = keys.member[_e1030.member[2]];
                                        let _e1411 = function_5(_e1405, _e1409[5]);
                                        if (_e1394[1] > _e1411[1]) {
                                            phi_2582_ = true;
                                        } else {
                                            if (_e1394[1] == _e1411[1]) {
                                                phi_2581_ = (_e1394[0] > _e1411[0]);
                                            } else {
                                                phi_2581_ = false;
                                            }
                                            let _e1422 = phi_2581_;
                                            phi_2582_ = _e1422;
                                        }
                                        let _e1424 = phi_2582_;
                                        let _e1429 = keys.member[_e1030.member[0]];
                                        let _e1434 = keys.member[_e1030.member[1]];
                                        let _e1436 = function_4(_e1429[2], _e1434[2]);
                                        let _e1440 = keys.member[_e1030.member[2]];
                                        let _e1442 = function_4(_e1436, _e1440[2]);
                                        let _e1446 = keys.member[_e1028.member[0]];
                                        let _e1451 = keys.member[_e1028.member[1]];
                                        let _e1453 = function_5(_e1446[5], _e1451[5]);
                                        let _e1457 = keys.member[_e1028.member[2]];
                                        let _e1459 = function_5(_e1453, _e1457[5]);
                                        if (_e1442[1] > _e1459[1]) {
                                            phi_2676_ = true;
                                        } else {
                                            if (_e1442[1] == _e1459[1]) {
                                                phi_2675_ = (_e1442[0] > _e1459[0]);
                                            } else {
                                                phi_2675_ = false;
                                            }
                                            let _e1470 = phi_2675_;
                                            phi_2676_ = _e1470;
                                        }
                                        let _e1472 = phi_2676_;
                                        phi_2680_ = (((!(_e1229) && !(_e1277)) && (!(_e1326) && !(_e1374))) && (!(_e1424) && !(_e1472)));
                                    }
                                    let _e1477 = phi_2680_;
                                    phi_2681_ = _e1477;
                                    phi_2682_ = _e1182;
                                } else {
                                    phi_2681_ = bool();
                                    phi_2682_ = true;
                                }
                                let _e1479 = phi_2681_;
                                let _e1481 = phi_2682_;
                                if _e1481 {
                                    phi_2686_ = false;
                                } else {
                                    phi_2686_ = true;
                                }
                                let _e1483 = phi_2686_;
                                phi_2687_ = _e1479;
                                phi_2688_ = _e1483;
                            } else {
                                phi_2687_ = false;
                                phi_2688_ = true;
                            }
                            let _e1485 = phi_2687_;
                            let _e1487 = phi_2688_;
                            phi_2689_ = _e1485;
                            phi_2690_ = _e1487;
                        } else {
                            phi_2689_ = false;
                            phi_2690_ = true;
                        }
                        let _e1489 = phi_2689_;
                        let _e1491 = phi_2690_;
                        if _e1491 {
                            phi_2694_ = _e1489;
                        } else {
                            phi_2694_ = true;
                        }
                        let _e1493 = phi_2694_;
                        if _e1493 {
                            let _e1495 = atomicAdd((&counters[7u]), 1u);
                            let _e1497 = params.member.member_4;
                            let _e1499 = params.member.member_5;
                            let _e1509 = paths.member[_e1028.member[0]];
                            let _e1511 = paths.member[_e1030.member[0]];
                            let _e1517 = paths.member[_e1030.member[1]];
                            let _e1519 = paths.member[_e1030.member[2]];
                            local_2 = type_34(array<array<f32, 3>, 2>(array<f32, 3>((_e1509.member[0] - _e1511.member[0]), (_e1509.member[1] - _e1511.member[1]), (_e1509.member[2] - _e1511.member[2])), array<f32, 3>((_e1509.member_1[0] - _e1511.member_1[0]), (_e1509.member_1[1] - _e1511.member_1[1]), (_e1509.member_1[2] - _e1511.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1517.member[0] - _e1511.member[0]), (_e1517.member[1] - _e1511.member[1]), (_e1517.member[2] - _e1511.member[2])), array<f32, 3>((_e1517.member_1[0] - _e1511.member_1[0]), (_e1517.member_1[1] - _e1511.member_1[1]), (_e1517.member_1[2] - _e1511.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1519.member[0] - _e1511.member[0]), (_e1519.member[1] - _e1511.member[1]), (_e1519.member[2] - _e1511.member[2])), array<f32, 3>((_e1519.member_1[0] - _e1511.member_1[0]), (_e1519.member_1[1] - _e1511.member_1[1]), (_e1519.member_1[2] - _e1511.member_1[2]))), (_e1497 + _e1497));
                            let _e1579 = local_2.member_1[0u];
                            let _e1585 = local_2.member_2[0u];
                            let _e1591 = ((_e1579[1] * _e1585[2]) - (_e1579[2] * _e1585[1]));
                            let _e1594 = ((_e1579[2] * _e1585[0]) - (_e1579[0] * _e1585[2]));
                            let _e1597 = ((_e1579[0] * _e1585[1]) - (_e1579[1] * _e1585[0]));
                            let _e1600 = local_2.member_1[1u];
                            let _e1606 = local_2.member_2[1u];
                            let _e1612 = ((_e1600[1] * _e1606[2]) - (_e1600[2] * _e1606[1]));
                            let _e1615 = ((_e1600[2] * _e1606[0]) - (_e1600[0] * _e1606[2]));
                            let _e1618 = ((_e1600[0] * _e1606[1]) - (_e1600[1] * _e1606[0]));
                            let _e1621 = local_2.member_1[0u];
                            let _e1627 = local_2.member_2[1u];
                            let _e1642 = local_2.member_1[1u];
                            let _e1648 = local_2.member_2[0u];
                            let _e1661 = (((_e1621[1] * _e1627[2]) - (_e1621[2] * _e1627[1])) + ((_e1642[1] * _e1648[2]) - (_e1642[2] * _e1648[1])));
                            let _e1662 = (((_e1621[2] * _e1627[0]) - (_e1621[0] * _e1627[2])) + ((_e1642[2] * _e1648[0]) - (_e1642[0] * _e1648[2])));
                            let _e1663 = (((_e1621[0] * _e1627[1]) - (_e1621[1] * _e1627[0])) + ((_e1642[0] * _e1648[1]) - (_e1642[1] * _e1648[0])));
                            let _e1666 = local_2.member[0u];
                            let _e1677 = local_2.member[1u];
                            let _e1688 = local_2.member[0u];
                            let _e1697 = ((((_e1677[0] * _e1591) + (_e1677[1] * _e1594)) + (_e1677[2] * _e1597)) + (((_e1688[0] * _e1661) + (_e1688[1] * _e1662)) + (_e1688[2] * _e1663)));
                            let _e1700 = local_2.member[0u];
                            let _e1711 = local_2.member[1u];
                            let _e1720 = ((((_e1700[0] * _e1612) + (_e1700[1] * _e1615)) + (_e1700[2] * _e1618)) + (((_e1711[0] * _e1661) + (_e1711[1] * _e1662)) + (_e1711[2] * _e1663)));
                            let _e1723 = local_2.member[1u];
                            let _e1734 = local_2.member[0u];
                            if (_e1734[0] < 0f) {
                                phi_3088_ = -(_e1734[0]);
                            } else {
                                phi_3088_ = _e1734[0];
                            }
                            let _e1741 = phi_3088_;
                            if (_e1734[1] < 0f) {
                                phi_3095_ = -(_e1734[1]);
                            } else {
                                phi_3095_ = _e1734[1];
                            }
                            let _e1745 = phi_3095_;
                            if (_e1741 > _e1745) {
                                phi_3100_ = _e1741;
                            } else {
                                phi_3100_ = _e1745;
                            }
                            let _e1748 = phi_3100_;
                            if (_e1734[2] < 0f) {
                                phi_3107_ = -(_e1734[2]);
                            } else {
                                phi_3107_ = _e1734[2];
                            }
                            let _e1752 = phi_3107_;
                            if (_e1748 > _e1752) {
                                phi_3112_ = _e1748;
                            } else {
                                phi_3112_ = _e1752;
                            }
                            let _e1755 = phi_3112_;
                            let _e1758 = local_2.member[1u];
                            if (_e1758[0] < 0f) {
                                phi_3125_ = -(_e1758[0]);
                            } else {
                                phi_3125_ = _e1758[0];
                            }
                            let _e1765 = phi_3125_;
                            if (_e1758[1] < 0f) {
                                phi_3132_ = -(_e1758[1]);
                            } else {
                                phi_3132_ = _e1758[1];
                            }
                            let _e1769 = phi_3132_;
                            if (_e1765 > _e1769) {
                                phi_3137_ = _e1765;
                            } else {
                                phi_3137_ = _e1769;
                            }
                            let _e1772 = phi_3137_;
                            if (_e1758[2] < 0f) {
                                phi_3144_ = -(_e1758[2]);
                            } else {
                                phi_3144_ = _e1758[2];
                            }
                            let _e1776 = phi_3144_;
                            if (_e1772 > _e1776) {
                                phi_3149_ = _e1772;
                            } else {
                                phi_3149_ = _e1776;
                            }
                            let _e1779 = phi_3149_;
                            if (_e1755 > _e1779) {
                                phi_3154_ = _e1755;
                            } else {
                                phi_3154_ = _e1779;
                            }
                            let _e1782 = phi_3154_;
                            let _e1784 = local_2.member_3;
                            let _e1785 = (_e1782 + _e1784);
                            let _e1788 = local_2.member_1[0u];
                            if (_e1788[0] < 0f) {
                                phi_3171_ = -(_e1788[0]);
                            } else {
                                phi_3171_ = _e1788[0];
                            }
                            let _e1795 = phi_3171_;
                            if (_e1788[1] < 0f) {
                                phi_3178_ = -(_e1788[1]);
                            } else {
                                phi_3178_ = _e1788[1];
                            }
                            let _e1799 = phi_3178_;
                            if (_e1795 > _e1799) {
                                phi_3183_ = _e1795;
                            } else {
                                phi_3183_ = _e1799;
                            }
                            let _e1802 = phi_3183_;
                            if (_e1788[2] < 0f) {
                                phi_3190_ = -(_e1788[2]);
                            } else {
                                phi_3190_ = _e1788[2];
                            }
                            let _e1806 = phi_3190_;
                            if (_e1802 > _e1806) {
                                phi_3195_ = _e1802;
                            } else {
                                phi_3195_ = _e1806;
                            }
                            let _e1809 = phi_3195_;
                            let _e1812 = local_2.member_1[1u];
                            if (_e1812[0] < 0f) {
                                phi_3209_ = -(_e1812[0]);
                            } else {
                                phi_3209_ = _e1812[0];
                            }
                            let _e1819 = phi_3209_;
                            if (_e1812[1] < 0f) {
                                phi_3216_ = -(_e1812[1]);
                            } else {
                                phi_3216_ = _e1812[1];
                            }
                            let _e1823 = phi_3216_;
                            if (_e1819 > _e1823) {
                                phi_3221_ = _e1819;
                            } else {
                                phi_3221_ = _e1823;
                            }
                            let _e1826 = phi_3221_;
                            if (_e1812[2] < 0f) {
                                phi_3228_ = -(_e1812[2]);
                            } else {
                                phi_3228_ = _e1812[2];
                            }
                            let _e1830 = phi_3228_;
                            if (_e1826 > _e1830) {
                                phi_3233_ = _e1826;
                            } else {
                                phi_3233_ = _e1830;
                            }
                            let _e1833 = phi_3233_;
                            if (_e1809 > _e1833) {
                                phi_3238_ = _e1809;
                            } else {
                                phi_3238_ = _e1833;
                            }
                            let _e1836 = phi_3238_;
                            let _e1838 = local_2.member_3;
                            let _e1839 = (_e1836 + _e1838);
                            let _e1842 = local_2.member_2[0u];
                            if (_e1842[0] < 0f) {
                                phi_3255_ = -(_e1842[0]);
                            } else {
                                phi_3255_ = _e1842[0];
                            }
                            let _e1849 = phi_3255_;
                            if (_e1842[1] < 0f) {
                                phi_3262_ = -(_e1842[1]);
                            } else {
                                phi_3262_ = _e1842[1];
                            }
                            let _e1853 = phi_3262_;
                            if (_e1849 > _e1853) {
                                phi_3267_ = _e1849;
                            } else {
                                phi_3267_ = _e1853;
                            }
                            let _e1856 = phi_3267_;
                            if (_e1842[2] < 0f) {
                                phi_3274_ = -(_e1842[2]);
                            } else {
                                phi_3274_ = _e1842[2];
                            }
                            let _e1860 = phi_3274_;
                            if (_e1856 > _e1860) {
                                phi_3279_ = _e1856;
                            } else {
                                phi_3279_ = _e1860;
                            }
                            let _e1863 = phi_3279_;
                            let _e1866 = local_2.member_2[1u];
                            if (_e1866[0] < 0f) {
                                phi_3293_ = -(_e1866[0]);
                            } else {
                                phi_3293_ = _e1866[0];
                            }
                            let _e1873 = phi_3293_;
                            if (_e1866[1] < 0f) {
                                phi_3300_ = -(_e1866[1]);
                            } else {
                                phi_3300_ = _e1866[1];
                            }
                            let _e1877 = phi_3300_;
                            if (_e1873 > _e1877) {
                                phi_3305_ = _e1873;
                            } else {
                                phi_3305_ = _e1877;
                            }
                            let _e1880 = phi_3305_;
                            if (_e1866[2] < 0f) {
                                phi_3312_ = -(_e1866[2]);
                            } else {
                                phi_3312_ = _e1866[2];
                            }
                            let _e1884 = phi_3312_;
                            if (_e1880 > _e1884) {
                                phi_3317_ = _e1880;
                            } else {
                                phi_3317_ = _e1884;
                            }
                            let _e1887 = phi_3317_;
                            if (_e1863 > _e1887) {
                                phi_3322_ = _e1863;
                            } else {
                                phi_3322_ = _e1887;
                            }
                            let _e1890 = phi_3322_;
                            let _e1892 = local_2.member_3;
                            let _e1893 = (_e1890 + _e1892);
                            let _e1895 = ((_e1839 * 8f) * _e1893);
                            let _e1902 = local_2.member_3;
                            if (_e1591 < 0f) {
                                phi_3353_ = -(_e1591);
                            } else {
                                phi_3353_ = _e1591;
                            }
                            let _e1919 = phi_3353_;
                            if (_e1594 < 0f) {
                                phi_3359_ = -(_e1594);
                            } else {
                                phi_3359_ = _e1594;
                            }
                            let _e1923 = phi_3359_;
                            if (_e1597 < 0f) {
                                phi_3366_ = -(_e1597);
                            } else {
                                phi_3366_ = _e1597;
                            }
                            let _e1928 = phi_3366_;
                            let _e1929 = ((_e1919 + _e1923) + _e1928);
                            if (_e1612 < 0f) {
                                phi_3373_ = -(_e1612);
                            } else {
                                phi_3373_ = _e1612;
                            }
                            let _e1933 = phi_3373_;
                            if (_e1615 < 0f) {
                                phi_3379_ = -(_e1615);
                            } else {
                                phi_3379_ = _e1615;
                            }
                            let _e1937 = phi_3379_;
                            if (_e1618 < 0f) {
                                phi_3386_ = -(_e1618);
                            } else {
                                phi_3386_ = _e1618;
                            }
                            let _e1942 = phi_3386_;
                            let _e1943 = ((_e1933 + _e1937) + _e1942);
                            if (_e1929 > _e1943) {
                                phi_3392_ = _e1929;
                            } else {
                                phi_3392_ = _e1943;
                            }
                            let _e1946 = phi_3392_;
                            if (_e1661 < 0f) {
                                phi_3398_ = -(_e1661);
                            } else {
                                phi_3398_ = _e1661;
                            }
                            let _e1950 = phi_3398_;
                            if (_e1662 < 0f) {
                                phi_3404_ = -(_e1662);
                            } else {
                                phi_3404_ = _e1662;
                            }
                            let _e1954 = phi_3404_;
                            if (_e1663 < 0f) {
                                phi_3411_ = -(_e1663);
                            } else {
                                phi_3411_ = _e1663;
                            }
                            let _e1959 = phi_3411_;
                            let _e1961 = (((_e1950 + _e1954) + _e1959) * 0.5f);
                            if (_e1946 > _e1961) {
                                phi_3418_ = _e1946;
                            } else {
                                phi_3418_ = _e1961;
                            }
                            let _e1964 = phi_3418_;
                            let _e1969 = local_2.member_3;
                            let _e1982 = ((((_e1666[0] * _e1591) + (_e1666[1] * _e1594)) + (_e1666[2] * _e1597)) * 3f);
                            let _e1983 = ((((_e1723[0] * _e1612) + (_e1723[1] * _e1615)) + (_e1723[2] * _e1618)) * 3f);
                            if (_e1982 < _e1983) {
                                phi_3442_ = _e1982;
                            } else {
                                phi_3442_ = _e1983;
                            }
                            let _e1986 = phi_3442_;
                            if (_e1697 < _e1720) {
                                phi_3447_ = _e1697;
                            } else {
                                phi_3447_ = _e1720;
                            }
                            let _e1989 = phi_3447_;
                            if (_e1986 < _e1989) {
                                phi_3452_ = _e1986;
                            } else {
                                phi_3452_ = _e1989;
                            }
                            let _e1992 = phi_3452_;
                            if (_e1982 > _e1983) {
                                phi_3457_ = _e1982;
                            } else {
                                phi_3457_ = _e1983;
                            }
                            let _e1995 = phi_3457_;
                            if (_e1697 > _e1720) {
                                phi_3462_ = _e1697;
                            } else {
                                phi_3462_ = _e1720;
                            }
                            let _e1998 = phi_3462_;
                            if (_e1995 > _e1998) {
                                phi_3467_ = _e1995;
                            } else {
                                phi_3467_ = _e1998;
                            }
                            let _e2001 = phi_3467_;
                            let _e2006 = -(_e2001);
                            if (_e1992 > _e2006) {
                                phi_3477_ = _e1992;
                            } else {
                                phi_3477_ = _e2006;
                            }
                            let _e2009 = phi_3477_;
                            if ((_e2009 - ((((((_e1785 * 8f) * _e1895) * (0.000000059604645f * (524f / 64f))) + ((_e1902 * 19f) * ((_e1785 * (_e1839 + _e1893)) + (_e1839 * _e1893)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1785) * ((1f + _e1839) * (1f + _e1893))))) + ((_e1499 * (((_e1964 + (_e1895 * (0.000000059604645f * 8f))) + ((_e1969 * 6f) * (_e1839 + _e1893))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1839) * (1f + _e1893))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4445_ = true;
                            } else {
                                let _e2014 = local_2.member_1[0u];
                                let _e2020 = local_2.member_1[1u];
                                let _e2024 = (_e2014[0] + _e2020[0]);
                                let _e2025 = (_e2014[1] + _e2020[1]);
                                let _e2026 = (_e2014[2] + _e2020[2]);
                                let _e2029 = local_2.member_2[0u];
                                let _e2035 = local_2.member_2[1u];
                                let _e2039 = (_e2029[0] + _e2035[0]);
                                let _e2040 = (_e2029[1] + _e2035[1]);
                                let _e2041 = (_e2029[2] + _e2035[2]);
                                let _e2044 = ((_e2025 * _e2041) - (_e2026 * _e2040));
                                let _e2047 = ((_e2026 * _e2039) - (_e2024 * _e2041));
                                let _e2050 = ((_e2024 * _e2040) - (_e2025 * _e2039));
                                let _e2053 = local_2.member[0u];
                                let _e2059 = local_2.member_1[0u];
                                let _e2065 = local_2.member_2[0u];
                                let _e2069 = (_e2053[0] - _e2059[0]);
                                let _e2070 = (_e2053[1] - _e2059[1]);
                                let _e2071 = (_e2053[2] - _e2059[2]);
                                let _e2072 = (_e2053[0] - _e2065[0]);
                                let _e2073 = (_e2053[1] - _e2065[1]);
                                let _e2074 = (_e2053[2] - _e2065[2]);
                                let _e2077 = local_2.member[1u];
                                let _e2083 = local_2.member_1[1u];
                                let _e2089 = local_2.member_2[1u];
                                let _e2093 = (_e2077[0] - _e2083[0]);
                                let _e2094 = (_e2077[1] - _e2083[1]);
                                let _e2095 = (_e2077[2] - _e2083[2]);
                                let _e2096 = (_e2077[0] - _e2089[0]);
                                let _e2097 = (_e2077[1] - _e2089[1]);
                                let _e2098 = (_e2077[2] - _e2089[2]);
                                let _e2101 = local_2.member[0u];
                                if (_e2101[0] < 0f) {
                                    phi_3680_ = -(_e2101[0]);
                                } else {
                                    phi_3680_ = _e2101[0];
                                }
                                let _e2108 = phi_3680_;
                                if (_e2101[1] < 0f) {
                                    phi_3687_ = -(_e2101[1]);
                                } else {
                                    phi_3687_ = _e2101[1];
                                }
                                let _e2112 = phi_3687_;
                                if (_e2108 > _e2112) {
                                    phi_3692_ = _e2108;
                                } else {
                                    phi_3692_ = _e2112;
                                }
                                let _e2115 = phi_3692_;
                                if (_e2101[2] < 0f) {
                                    phi_3699_ = -(_e2101[2]);
                                } else {
                                    phi_3699_ = _e2101[2];
                                }
                                let _e2119 = phi_3699_;
                                if (_e2115 > _e2119) {
                                    phi_3704_ = _e2115;
                                } else {
                                    phi_3704_ = _e2119;
                                }
                                let _e2122 = phi_3704_;
                                let _e2125 = local_2.member[1u];
                                if (_e2125[0] < 0f) {
                                    phi_3717_ = -(_e2125[0]);
                                } else {
                                    phi_3717_ = _e2125[0];
                                }
                                let _e2132 = phi_3717_;
                                if (_e2125[1] < 0f) {
                                    phi_3724_ = -(_e2125[1]);
                                } else {
                                    phi_3724_ = _e2125[1];
                                }
                                let _e2136 = phi_3724_;
                                if (_e2132 > _e2136) {
                                    phi_3729_ = _e2132;
                                } else {
                                    phi_3729_ = _e2136;
                                }
                                let _e2139 = phi_3729_;
                                if (_e2125[2] < 0f) {
                                    phi_3736_ = -(_e2125[2]);
                                } else {
                                    phi_3736_ = _e2125[2];
                                }
                                let _e2143 = phi_3736_;
                                if (_e2139 > _e2143) {
                                    phi_3741_ = _e2139;
                                } else {
                                    phi_3741_ = _e2143;
                                }
                                let _e2146 = phi_3741_;
                                if (_e2122 > _e2146) {
                                    phi_3746_ = _e2122;
                                } else {
                                    phi_3746_ = _e2146;
                                }
                                let _e2149 = phi_3746_;
                                let _e2151 = local_2.member_3;
                                let _e2155 = local_2.member_1[0u];
                                if (_e2155[0] < 0f) {
                                    phi_3763_ = -(_e2155[0]);
                                } else {
                                    phi_3763_ = _e2155[0];
                                }
                                let _e2162 = phi_3763_;
                                if (_e2155[1] < 0f) {
                                    phi_3770_ = -(_e2155[1]);
                                } else {
                                    phi_3770_ = _e2155[1];
                                }
                                let _e2166 = phi_3770_;
                                if (_e2162 > _e2166) {
                                    phi_3775_ = _e2162;
                                } else {
                                    phi_3775_ = _e2166;
                                }
                                let _e2169 = phi_3775_;
                                if (_e2155[2] < 0f) {
                                    phi_3782_ = -(_e2155[2]);
                                } else {
                                    phi_3782_ = _e2155[2];
                                }
                                let _e2173 = phi_3782_;
                                if (_e2169 > _e2173) {
                                    phi_3787_ = _e2169;
                                } else {
                                    phi_3787_ = _e2173;
                                }
                                let _e2176 = phi_3787_;
                                let _e2179 = local_2.member_1[1u];
                                if (_e2179[0] < 0f) {
                                    phi_3801_ = -(_e2179[0]);
                                } else {
                                    phi_3801_ = _e2179[0];
                                }
                                let _e2186 = phi_3801_;
                                if (_e2179[1] < 0f) {
                                    phi_3808_ = -(_e2179[1]);
                                } else {
                                    phi_3808_ = _e2179[1];
                                }
                                let _e2190 = phi_3808_;
                                if (_e2186 > _e2190) {
                                    phi_3813_ = _e2186;
                                } else {
                                    phi_3813_ = _e2190;
                                }
                                let _e2193 = phi_3813_;
                                if (_e2179[2] < 0f) {
                                    phi_3820_ = -(_e2179[2]);
                                } else {
                                    phi_3820_ = _e2179[2];
                                }
                                let _e2197 = phi_3820_;
                                if (_e2193 > _e2197) {
                                    phi_3825_ = _e2193;
                                } else {
                                    phi_3825_ = _e2197;
                                }
                                let _e2200 = phi_3825_;
                                if (_e2176 > _e2200) {
                                    phi_3830_ = _e2176;
                                } else {
                                    phi_3830_ = _e2200;
                                }
                                let _e2203 = phi_3830_;
                                let _e2205 = local_2.member_3;
                                let _e2209 = local_2.member_2[0u];
                                if (_e2209[0] < 0f) {
                                    phi_3847_ = -(_e2209[0]);
                                } else {
                                    phi_3847_ = _e2209[0];
                                }
                                let _e2216 = phi_3847_;
                                if (_e2209[1] < 0f) {
                                    phi_3854_ = -(_e2209[1]);
                                } else {
                                    phi_3854_ = _e2209[1];
                                }
                                let _e2220 = phi_3854_;
                                if (_e2216 > _e2220) {
                                    phi_3859_ = _e2216;
                                } else {
                                    phi_3859_ = _e2220;
                                }
                                let _e2223 = phi_3859_;
                                if (_e2209[2] < 0f) {
                                    phi_3866_ = -(_e2209[2]);
                                } else {
                                    phi_3866_ = _e2209[2];
                                }
                                let _e2227 = phi_3866_;
                                if (_e2223 > _e2227) {
                                    phi_3871_ = _e2223;
                                } else {
                                    phi_3871_ = _e2227;
                                }
                                let _e2230 = phi_3871_;
                                let _e2233 = local_2.member_2[1u];
                                if (_e2233[0] < 0f) {
                                    phi_3885_ = -(_e2233[0]);
                                } else {
                                    phi_3885_ = _e2233[0];
                                }
                                let _e2240 = phi_3885_;
                                if (_e2233[1] < 0f) {
                                    phi_3892_ = -(_e2233[1]);
                                } else {
                                    phi_3892_ = _e2233[1];
                                }
                                let _e2244 = phi_3892_;
                                if (_e2240 > _e2244) {
                                    phi_3897_ = _e2240;
                                } else {
                                    phi_3897_ = _e2244;
                                }
                                let _e2247 = phi_3897_;
                                if (_e2233[2] < 0f) {
                                    phi_3904_ = -(_e2233[2]);
                                } else {
                                    phi_3904_ = _e2233[2];
                                }
                                let _e2251 = phi_3904_;
                                if (_e2247 > _e2251) {
                                    phi_3909_ = _e2247;
                                } else {
                                    phi_3909_ = _e2251;
                                }
                                let _e2254 = phi_3909_;
                                if (_e2230 > _e2254) {
                                    phi_3914_ = _e2230;
                                } else {
                                    phi_3914_ = _e2254;
                                }
                                let _e2257 = phi_3914_;
                                let _e2259 = local_2.member_3;
                                let _e2263 = ((((_e2149 + _e2151) + (_e2203 + _e2205)) + (_e2257 + _e2259)) * 2f);
                                let _e2266 = local_2.member_3;
                                let _e2270 = (((_e1499 * 1.0001f) + (_e2266 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2273 = ((_e2047 * _e2026) - (_e2050 * _e2025));
                                let _e2276 = ((_e2050 * _e2024) - (_e2044 * _e2026));
                                let _e2279 = ((_e2044 * _e2025) - (_e2047 * _e2024));
                                let _e2284 = (((_e2273 * _e2053[0]) + (_e2276 * _e2053[1])) + (_e2279 * _e2053[2]));
                                let _e2289 = (((_e2273 * _e2069) + (_e2276 * _e2070)) + (_e2279 * _e2071));
                                let _e2294 = (((_e2273 * _e2072) + (_e2276 * _e2073)) + (_e2279 * _e2074));
                                let _e2299 = (((_e2273 * _e2053[0]) + (_e2276 * _e2053[1])) + (_e2279 * _e2053[2]));
                                let _e2304 = (((_e2273 * _e2077[0]) + (_e2276 * _e2077[1])) + (_e2279 * _e2077[2]));
                                let _e2309 = (((_e2273 * _e2093) + (_e2276 * _e2094)) + (_e2279 * _e2095));
                                let _e2314 = (((_e2273 * _e2096) + (_e2276 * _e2097)) + (_e2279 * _e2098));
                                let _e2319 = (((_e2273 * _e2077[0]) + (_e2276 * _e2077[1])) + (_e2279 * _e2077[2]));
                                if (_e2284 < _e2289) {
                                    phi_3993_ = _e2284;
                                } else {
                                    phi_3993_ = _e2289;
                                }
                                let _e2322 = phi_3993_;
                                if (_e2294 < _e2299) {
                                    phi_3998_ = _e2294;
                                } else {
                                    phi_3998_ = _e2299;
                                }
                                let _e2325 = phi_3998_;
                                if (_e2322 < _e2325) {
                                    phi_4003_ = _e2322;
                                } else {
                                    phi_4003_ = _e2325;
                                }
                                let _e2328 = phi_4003_;
                                if (_e2304 < _e2309) {
                                    phi_4008_ = _e2304;
                                } else {
                                    phi_4008_ = _e2309;
                                }
                                let _e2331 = phi_4008_;
                                if (_e2314 < _e2319) {
                                    phi_4013_ = _e2314;
                                } else {
                                    phi_4013_ = _e2319;
                                }
                                let _e2334 = phi_4013_;
                                if (_e2331 < _e2334) {
                                    phi_4018_ = _e2331;
                                } else {
                                    phi_4018_ = _e2334;
                                }
                                let _e2337 = phi_4018_;
                                if (_e2328 < _e2337) {
                                    phi_4023_ = _e2328;
                                } else {
                                    phi_4023_ = _e2337;
                                }
                                let _e2340 = phi_4023_;
                                if (_e2284 > _e2289) {
                                    phi_4028_ = _e2284;
                                } else {
                                    phi_4028_ = _e2289;
                                }
                                let _e2343 = phi_4028_;
                                if (_e2294 > _e2299) {
                                    phi_4033_ = _e2294;
                                } else {
                                    phi_4033_ = _e2299;
                                }
                                let _e2346 = phi_4033_;
                                if (_e2343 > _e2346) {
                                    phi_4038_ = _e2343;
                                } else {
                                    phi_4038_ = _e2346;
                                }
                                let _e2349 = phi_4038_;
                                if (_e2304 > _e2309) {
                                    phi_4043_ = _e2304;
                                } else {
                                    phi_4043_ = _e2309;
                                }
                                let _e2352 = phi_4043_;
                                if (_e2314 > _e2319) {
                                    phi_4048_ = _e2314;
                                } else {
                                    phi_4048_ = _e2319;
                                }
                                let _e2355 = phi_4048_;
                                if (_e2352 > _e2355) {
                                    phi_4053_ = _e2352;
                                } else {
                                    phi_4053_ = _e2355;
                                }
                                let _e2358 = phi_4053_;
                                if (_e2349 > _e2358) {
                                    phi_4058_ = _e2349;
                                } else {
                                    phi_4058_ = _e2358;
                                }
                                let _e2361 = phi_4058_;
                                if (_e2273 < 0f) {
                                    phi_4064_ = -(_e2273);
                                } else {
                                    phi_4064_ = _e2273;
                                }
                                let _e2365 = phi_4064_;
                                if (_e2276 < 0f) {
                                    phi_4070_ = -(_e2276);
                                } else {
                                    phi_4070_ = _e2276;
                                }
                                let _e2369 = phi_4070_;
                                if (_e2279 < 0f) {
                                    phi_4077_ = -(_e2279);
                                } else {
                                    phi_4077_ = _e2279;
                                }
                                let _e2374 = phi_4077_;
                                let _e2375 = ((_e2365 + _e2369) + _e2374);
                                let _e2380 = -(_e2361);
                                if (_e2340 > _e2380) {
                                    phi_4088_ = _e2340;
                                } else {
                                    phi_4088_ = _e2380;
                                }
                                let _e2383 = phi_4088_;
                                let _e2388 = (((_e2383 - ((_e2375 * _e2263) * (0.000000059604645f * (17f / 2f)))) - (_e2375 * _e2270)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2391 = ((_e2047 * _e2041) - (_e2050 * _e2040));
                                let _e2394 = ((_e2050 * _e2039) - (_e2044 * _e2041));
                                let _e2397 = ((_e2044 * _e2040) - (_e2047 * _e2039));
                                let _e2402 = (((_e2391 * _e2053[0]) + (_e2394 * _e2053[1])) + (_e2397 * _e2053[2]));
                                let _e2407 = (((_e2391 * _e2069) + (_e2394 * _e2070)) + (_e2397 * _e2071));
                                let _e2412 = (((_e2391 * _e2072) + (_e2394 * _e2073)) + (_e2397 * _e2074));
                                let _e2417 = (((_e2391 * _e2053[0]) + (_e2394 * _e2053[1])) + (_e2397 * _e2053[2]));
                                let _e2422 = (((_e2391 * _e2077[0]) + (_e2394 * _e2077[1])) + (_e2397 * _e2077[2]));
                                let _e2427 = (((_e2391 * _e2093) + (_e2394 * _e2094)) + (_e2397 * _e2095));
                                let _e2432 = (((_e2391 * _e2096) + (_e2394 * _e2097)) + (_e2397 * _e2098));
                                let _e2437 = (((_e2391 * _e2077[0]) + (_e2394 * _e2077[1])) + (_e2397 * _e2077[2]));
                                if (_e2402 < _e2407) {
                                    phi_4159_ = _e2402;
                                } else {
                                    phi_4159_ = _e2407;
                                }
                                let _e2440 = phi_4159_;
                                if (_e2412 < _e2417) {
                                    phi_4164_ = _e2412;
                                } else {
                                    phi_4164_ = _e2417;
                                }
                                let _e2443 = phi_4164_;
                                if (_e2440 < _e2443) {
                                    phi_4169_ = _e2440;
                                } else {
                                    phi_4169_ = _e2443;
                                }
                                let _e2446 = phi_4169_;
                                if (_e2422 < _e2427) {
                                    phi_4174_ = _e2422;
                                } else {
                                    phi_4174_ = _e2427;
                                }
                                let _e2449 = phi_4174_;
                                if (_e2432 < _e2437) {
                                    phi_4179_ = _e2432;
                                } else {
                                    phi_4179_ = _e2437;
                                }
                                let _e2452 = phi_4179_;
                                if (_e2449 < _e2452) {
                                    phi_4184_ = _e2449;
                                } else {
                                    phi_4184_ = _e2452;
                                }
                                let _e2455 = phi_4184_;
                                if (_e2446 < _e2455) {
                                    phi_4189_ = _e2446;
                                } else {
                                    phi_4189_ = _e2455;
                                }
                                let _e2458 = phi_4189_;
                                if (_e2402 > _e2407) {
                                    phi_4194_ = _e2402;
                                } else {
                                    phi_4194_ = _e2407;
                                }
                                let _e2461 = phi_4194_;
                                if (_e2412 > _e2417) {
                                    phi_4199_ = _e2412;
                                } else {
                                    phi_4199_ = _e2417;
                                }
                                let _e2464 = phi_4199_;
                                if (_e2461 > _e2464) {
                                    phi_4204_ = _e2461;
                                } else {
                                    phi_4204_ = _e2464;
                                }
                                let _e2467 = phi_4204_;
                                if (_e2422 > _e2427) {
                                    phi_4209_ = _e2422;
                                } else {
                                    phi_4209_ = _e2427;
                                }
                                let _e2470 = phi_4209_;
                                if (_e2432 > _e2437) {
                                    phi_4214_ = _e2432;
                                } else {
                                    phi_4214_ = _e2437;
                                }
                                let _e2473 = phi_4214_;
                                if (_e2470 > _e2473) {
                                    phi_4219_ = _e2470;
                                } else {
                                    phi_4219_ = _e2473;
                                }
                                let _e2476 = phi_4219_;
                                if (_e2467 > _e2476) {
                                    phi_4224_ = _e2467;
                                } else {
                                    phi_4224_ = _e2476;
                                }
                                let _e2479 = phi_4224_;
                                if (_e2391 < 0f) {
                                    phi_4230_ = -(_e2391);
                                } else {
                                    phi_4230_ = _e2391;
                                }
                                let _e2483 = phi_4230_;
                                if (_e2394 < 0f) {
                                    phi_4236_ = -(_e2394);
                                } else {
                                    phi_4236_ = _e2394;
                                }
                                let _e2487 = phi_4236_;
                                if (_e2397 < 0f) {
                                    phi_4243_ = -(_e2397);
                                } else {
                                    phi_4243_ = _e2397;
                                }
                                let _e2492 = phi_4243_;
                                let _e2493 = ((_e2483 + _e2487) + _e2492);
                                let _e2498 = -(_e2479);
                                if (_e2458 > _e2498) {
                                    phi_4254_ = _e2458;
                                } else {
                                    phi_4254_ = _e2498;
                                }
                                let _e2501 = phi_4254_;
                                let _e2506 = (((_e2501 - ((_e2493 * _e2263) * (0.000000059604645f * (17f / 2f)))) - (_e2493 * _e2270)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2388 > _e2506) {
                                    phi_4264_ = _e2388;
                                } else {
                                    phi_4264_ = _e2506;
                                }
                                let _e2509 = phi_4264_;
                                let _e2510 = (_e2039 - _e2024);
                                let _e2511 = (_e2040 - _e2025);
                                let _e2512 = (_e2041 - _e2026);
                                let _e2515 = ((_e2047 * _e2512) - (_e2050 * _e2511));
                                let _e2518 = ((_e2050 * _e2510) - (_e2044 * _e2512));
                                let _e2521 = ((_e2044 * _e2511) - (_e2047 * _e2510));
                                let _e2526 = (((_e2515 * _e2053[0]) + (_e2518 * _e2053[1])) + (_e2521 * _e2053[2]));
                                let _e2531 = (((_e2515 * _e2069) + (_e2518 * _e2070)) + (_e2521 * _e2071));
                                let _e2536 = (((_e2515 * _e2072) + (_e2518 * _e2073)) + (_e2521 * _e2074));
                                let _e2541 = (((_e2515 * _e2053[0]) + (_e2518 * _e2053[1])) + (_e2521 * _e2053[2]));
                                let _e2546 = (((_e2515 * _e2077[0]) + (_e2518 * _e2077[1])) + (_e2521 * _e2077[2]));
                                let _e2551 = (((_e2515 * _e2093) + (_e2518 * _e2094)) + (_e2521 * _e2095));
                                let _e2556 = (((_e2515 * _e2096) + (_e2518 * _e2097)) + (_e2521 * _e2098));
                                let _e2561 = (((_e2515 * _e2077[0]) + (_e2518 * _e2077[1])) + (_e2521 * _e2077[2]));
                                if (_e2526 < _e2531) {
                                    phi_4337_ = _e2526;
                                } else {
                                    phi_4337_ = _e2531;
                                }
                                let _e2564 = phi_4337_;
                                if (_e2536 < _e2541) {
                                    phi_4342_ = _e2536;
                                } else {
                                    phi_4342_ = _e2541;
                                }
                                let _e2567 = phi_4342_;
                                if (_e2564 < _e2567) {
                                    phi_4347_ = _e2564;
                                } else {
                                    phi_4347_ = _e2567;
                                }
                                let _e2570 = phi_4347_;
                                if (_e2546 < _e2551) {
                                    phi_4352_ = _e2546;
                                } else {
                                    phi_4352_ = _e2551;
                                }
                                let _e2573 = phi_4352_;
                                if (_e2556 < _e2561) {
                                    phi_4357_ = _e2556;
                                } else {
                                    phi_4357_ = _e2561;
                                }
                                let _e2576 = phi_4357_;
                                if (_e2573 < _e2576) {
                                    phi_4362_ = _e2573;
                                } else {
                                    phi_4362_ = _e2576;
                                }
                                let _e2579 = phi_4362_;
                                if (_e2570 < _e2579) {
                                    phi_4367_ = _e2570;
                                } else {
                                    phi_4367_ = _e2579;
                                }
                                let _e2582 = phi_4367_;
                                if (_e2526 > _e2531) {
                                    phi_4372_ = _e2526;
                                } else {
                                    phi_4372_ = _e2531;
                                }
                                let _e2585 = phi_4372_;
                                if (_e2536 > _e2541) {
                                    phi_4377_ = _e2536;
                                } else {
                                    phi_4377_ = _e2541;
                                }
                                let _e2588 = phi_4377_;
                                if (_e2585 > _e2588) {
                                    phi_4382_ = _e2585;
                                } else {
                                    phi_4382_ = _e2588;
                                }
                                let _e2591 = phi_4382_;
                                if (_e2546 > _e2551) {
                                    phi_4387_ = _e2546;
                                } else {
                                    phi_4387_ = _e2551;
                                }
                                let _e2594 = phi_4387_;
                                if (_e2556 > _e2561) {
                                    phi_4392_ = _e2556;
                                } else {
                                    phi_4392_ = _e2561;
                                }
                                let _e2597 = phi_4392_;
                                if (_e2594 > _e2597) {
                                    phi_4397_ = _e2594;
                                } else {
                                    phi_4397_ = _e2597;
                                }
                                let _e2600 = phi_4397_;
                                if (_e2591 > _e2600) {
                                    phi_4402_ = _e2591;
                                } else {
                                    phi_4402_ = _e2600;
                                }
                                let _e2603 = phi_4402_;
                                if (_e2515 < 0f) {
                                    phi_4408_ = -(_e2515);
                                } else {
                                    phi_4408_ = _e2515;
                                }
                                let _e2607 = phi_4408_;
                                if (_e2518 < 0f) {
                                    phi_4414_ = -(_e2518);
                                } else {
                                    phi_4414_ = _e2518;
                                }
                                let _e2611 = phi_4414_;
                                if (_e2521 < 0f) {
                                    phi_4421_ = -(_e2521);
                                } else {
                                    phi_4421_ = _e2521;
                                }
                                let _e2616 = phi_4421_;
                                let _e2617 = ((_e2607 + _e2611) + _e2616);
                                let _e2622 = -(_e2603);
                                if (_e2582 > _e2622) {
                                    phi_4432_ = _e2582;
                                } else {
                                    phi_4432_ = _e2622;
                                }
                                let _e2625 = phi_4432_;
                                let _e2630 = (((_e2625 - ((_e2617 * _e2263) * (0.000000059604645f * (17f / 2f)))) - (_e2617 * _e2270)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2509 > _e2630) {
                                    phi_4442_ = _e2509;
                                } else {
                                    phi_4442_ = _e2630;
                                }
                                let _e2633 = phi_4442_;
                                phi_4445_ = (_e2633 > 0f);
                            }
                            let _e2636 = phi_4445_;
                            if _e2636 {
                                phi_7859_ = false;
                            } else {
                                let _e2639 = local_2.member[0u];
                                let _e2645 = local_2.member[1u];
                                let _e2652 = ((_e2639[0] + _e2645[0]) * 0.5f);
                                let _e2653 = ((_e2639[1] + _e2645[1]) * 0.5f);
                                let _e2654 = ((_e2639[2] + _e2645[2]) * 0.5f);
                                let _e2657 = local_2.member_1[0u];
                                let _e2663 = local_2.member_1[1u];
                                let _e2670 = ((_e2657[0] + _e2663[0]) * 0.5f);
                                let _e2671 = ((_e2657[1] + _e2663[1]) * 0.5f);
                                let _e2672 = ((_e2657[2] + _e2663[2]) * 0.5f);
                                let _e2675 = local_2.member_2[0u];
                                let _e2681 = local_2.member_2[1u];
                                let _e2688 = ((_e2675[0] + _e2681[0]) * 0.5f);
                                let _e2689 = ((_e2675[1] + _e2681[1]) * 0.5f);
                                let _e2690 = ((_e2675[2] + _e2681[2]) * 0.5f);
                                let _e2693 = local_2.member[0u];
                                let _e2696 = local_2.member_1[0u];
                                let _e2699 = local_2.member_2[0u];
                                let _e2701 = local_2.member_3;
                                let _e2704 = local_2.member[1u];
                                let _e2707 = local_2.member_1[1u];
                                let _e2710 = local_2.member_2[1u];
                                let _e2712 = local_2.member_3;
                                local = type_34(array<array<f32, 3>, 2>(_e2693, array<f32, 3>(_e2652, _e2653, _e2654)), array<array<f32, 3>, 2>(_e2696, array<f32, 3>(_e2670, _e2671, _e2672)), array<array<f32, 3>, 2>(_e2699, array<f32, 3>(_e2688, _e2689, _e2690)), _e2701);
                                local_1 = type_34(array<array<f32, 3>, 2>(array<f32, 3>(_e2652, _e2653, _e2654), _e2704), array<array<f32, 3>, 2>(array<f32, 3>(_e2670, _e2671, _e2672), _e2707), array<array<f32, 3>, 2>(array<f32, 3>(_e2688, _e2689, _e2690), _e2710), _e2712);
                                let _e2729 = local.member_1[0u];
                                let _e2735 = local.member_2[0u];
                                let _e2741 = ((_e2729[1] * _e2735[2]) - (_e2729[2] * _e2735[1]));
                                let _e2744 = ((_e2729[2] * _e2735[0]) - (_e2729[0] * _e2735[2]));
                                let _e2747 = ((_e2729[0] * _e2735[1]) - (_e2729[1] * _e2735[0]));
                                let _e2750 = local.member_1[1u];
                                let _e2756 = local.member_2[1u];
                                let _e2762 = ((_e2750[1] * _e2756[2]) - (_e2750[2] * _e2756[1]));
                                let _e2765 = ((_e2750[2] * _e2756[0]) - (_e2750[0] * _e2756[2]));
                                let _e2768 = ((_e2750[0] * _e2756[1]) - (_e2750[1] * _e2756[0]));
                                let _e2771 = local.member_1[0u];
                                let _e2777 = local.member_2[1u];
                                let _e2792 = local.member_1[1u];
                                let _e2798 = local.member_2[0u];
                                let _e2811 = (((_e2771[1] * _e2777[2]) - (_e2771[2] * _e2777[1])) + ((_e2792[1] * _e2798[2]) - (_e2792[2] * _e2798[1])));
                                let _e2812 = (((_e2771[2] * _e2777[0]) - (_e2771[0] * _e2777[2])) + ((_e2792[2] * _e2798[0]) - (_e2792[0] * _e2798[2])));
                                let _e2813 = (((_e2771[0] * _e2777[1]) - (_e2771[1] * _e2777[0])) + ((_e2792[0] * _e2798[1]) - (_e2792[1] * _e2798[0])));
                                let _e2816 = local.member[0u];
                                let _e2827 = local.member[1u];
                                let _e2838 = local.member[0u];
                                let _e2847 = ((((_e2827[0] * _e2741) + (_e2827[1] * _e2744)) + (_e2827[2] * _e2747)) + (((_e2838[0] * _e2811) + (_e2838[1] * _e2812)) + (_e2838[2] * _e2813)));
                                let _e2850 = local.member[0u];
                                let _e2861 = local.member[1u];
                                let _e2870 = ((((_e2850[0] * _e2762) + (_e2850[1] * _e2765)) + (_e2850[2] * _e2768)) + (((_e2861[0] * _e2811) + (_e2861[1] * _e2812)) + (_e2861[2] * _e2813)));
                                let _e2873 = local.member[1u];
                                let _e2884 = local.member[0u];
                                if (_e2884[0] < 0f) {
                                    phi_4897_ = -(_e2884[0]);
                                } else {
                                    phi_4897_ = _e2884[0];
                                }
                                let _e2891 = phi_4897_;
                                if (_e2884[1] < 0f) {
                                    phi_4904_ = -(_e2884[1]);
                                } else {
                                    phi_4904_ = _e2884[1];
                                }
                                let _e2895 = phi_4904_;
                                if (_e2891 > _e2895) {
                                    phi_4909_ = _e2891;
                                } else {
                                    phi_4909_ = _e2895;
                                }
                                let _e2898 = phi_4909_;
                                if (_e2884[2] < 0f) {
                                    phi_4916_ = -(_e2884[2]);
                                } else {
                                    phi_4916_ = _e2884[2];
                                }
                                let _e2902 = phi_4916_;
                                if (_e2898 > _e2902) {
                                    phi_4921_ = _e2898;
                                } else {
                                    phi_4921_ = _e2902;
                                }
                                let _e2905 = phi_4921_;
                                let _e2908 = local.member[1u];
                                if (_e2908[0] < 0f) {
                                    phi_4934_ = -(_e2908[0]);
                                } else {
                                    phi_4934_ = _e2908[0];
                                }
                                let _e2915 = phi_4934_;
                                if (_e2908[1] < 0f) {
                                    phi_4941_ = -(_e2908[1]);
                                } else {
                                    phi_4941_ = _e2908[1];
                                }
                                let _e2919 = phi_4941_;
                                if (_e2915 > _e2919) {
                                    phi_4946_ = _e2915;
                                } else {
                                    phi_4946_ = _e2919;
                                }
                                let _e2922 = phi_4946_;
                                if (_e2908[2] < 0f) {
                                    phi_4953_ = -(_e2908[2]);
                                } else {
                                    phi_4953_ = _e2908[2];
                                }
                                let _e2926 = phi_4953_;
                                if (_e2922 > _e2926) {
                                    phi_4958_ = _e2922;
                                } else {
                                    phi_4958_ = _e2926;
                                }
                                let _e2929 = phi_4958_;
                                if (_e2905 > _e2929) {
                                    phi_4963_ = _e2905;
                                } else {
                                    phi_4963_ = _e2929;
                                }
                                let _e2932 = phi_4963_;
                                let _e2934 = local.member_3;
                                let _e2935 = (_e2932 + _e2934);
                                let _e2938 = local.member_1[0u];
                                if (_e2938[0] < 0f) {
                                    phi_4980_ = -(_e2938[0]);
                                } else {
                                    phi_4980_ = _e2938[0];
                                }
                                let _e2945 = phi_4980_;
                                if (_e2938[1] < 0f) {
                                    phi_4987_ = -(_e2938[1]);
                                } else {
                                    phi_4987_ = _e2938[1];
                                }
                                let _e2949 = phi_4987_;
                                if (_e2945 > _e2949) {
                                    phi_4992_ = _e2945;
                                } else {
                                    phi_4992_ = _e2949;
                                }
                                let _e2952 = phi_4992_;
                                if (_e2938[2] < 0f) {
                                    phi_4999_ = -(_e2938[2]);
                                } else {
                                    phi_4999_ = _e2938[2];
                                }
                                let _e2956 = phi_4999_;
                                if (_e2952 > _e2956) {
                                    phi_5004_ = _e2952;
                                } else {
                                    phi_5004_ = _e2956;
                                }
                                let _e2959 = phi_5004_;
                                let _e2962 = local.member_1[1u];
                                if (_e2962[0] < 0f) {
                                    phi_5018_ = -(_e2962[0]);
                                } else {
                                    phi_5018_ = _e2962[0];
                                }
                                let _e2969 = phi_5018_;
                                if (_e2962[1] < 0f) {
                                    phi_5025_ = -(_e2962[1]);
                                } else {
                                    phi_5025_ = _e2962[1];
                                }
                                let _e2973 = phi_5025_;
                                if (_e2969 > _e2973) {
                                    phi_5030_ = _e2969;
                                } else {
                                    phi_5030_ = _e2973;
                                }
                                let _e2976 = phi_5030_;
                                if (_e2962[2] < 0f) {
                                    phi_5037_ = -(_e2962[2]);
                                } else {
                                    phi_5037_ = _e2962[2];
                                }
                                let _e2980 = phi_5037_;
                                if (_e2976 > _e2980) {
                                    phi_5042_ = _e2976;
                                } else {
                                    phi_5042_ = _e2980;
                                }
                                let _e2983 = phi_5042_;
                                if (_e2959 > _e2983) {
                                    phi_5047_ = _e2959;
                                } else {
                                    phi_5047_ = _e2983;
                                }
                                let _e2986 = phi_5047_;
                                let _e2988 = local.member_3;
                                let _e2989 = (_e2986 + _e2988);
                                let _e2992 = local.member_2[0u];
                                if (_e2992[0] < 0f) {
                                    phi_5064_ = -(_e2992[0]);
                                } else {
                                    phi_5064_ = _e2992[0];
                                }
                                let _e2999 = phi_5064_;
                                if (_e2992[1] < 0f) {
                                    phi_5071_ = -(_e2992[1]);
                                } else {
                                    phi_5071_ = _e2992[1];
                                }
                                let _e3003 = phi_5071_;
                                if (_e2999 > _e3003) {
                                    phi_5076_ = _e2999;
                                } else {
                                    phi_5076_ = _e3003;
                                }
                                let _e3006 = phi_5076_;
                                if (_e2992[2] < 0f) {
                                    phi_5083_ = -(_e2992[2]);
                                } else {
                                    phi_5083_ = _e2992[2];
                                }
                                let _e3010 = phi_5083_;
                                if (_e3006 > _e3010) {
                                    phi_5088_ = _e3006;
                                } else {
                                    phi_5088_ = _e3010;
                                }
                                let _e3013 = phi_5088_;
                                let _e3016 = local.member_2[1u];
                                if (_e3016[0] < 0f) {
                                    phi_5102_ = -(_e3016[0]);
                                } else {
                                    phi_5102_ = _e3016[0];
                                }
                                let _e3023 = phi_5102_;
                                if (_e3016[1] < 0f) {
                                    phi_5109_ = -(_e3016[1]);
                                } else {
                                    phi_5109_ = _e3016[1];
                                }
                                let _e3027 = phi_5109_;
                                if (_e3023 > _e3027) {
                                    phi_5114_ = _e3023;
                                } else {
                                    phi_5114_ = _e3027;
                                }
                                let _e3030 = phi_5114_;
                                if (_e3016[2] < 0f) {
                                    phi_5121_ = -(_e3016[2]);
                                } else {
                                    phi_5121_ = _e3016[2];
                                }
                                let _e3034 = phi_5121_;
                                if (_e3030 > _e3034) {
                                    phi_5126_ = _e3030;
                                } else {
                                    phi_5126_ = _e3034;
                                }
                                let _e3037 = phi_5126_;
                                if (_e3013 > _e3037) {
                                    phi_5131_ = _e3013;
                                } else {
                                    phi_5131_ = _e3037;
                                }
                                let _e3040 = phi_5131_;
                                let _e3042 = local.member_3;
                                let _e3043 = (_e3040 + _e3042);
                                let _e3045 = ((_e2989 * 8f) * _e3043);
                                let _e3052 = local.member_3;
                                if (_e2741 < 0f) {
                                    phi_5162_ = -(_e2741);
                                } else {
                                    phi_5162_ = _e2741;
                                }
                                let _e3069 = phi_5162_;
                                if (_e2744 < 0f) {
                                    phi_5168_ = -(_e2744);
                                } else {
                                    phi_5168_ = _e2744;
                                }
                                let _e3073 = phi_5168_;
                                if (_e2747 < 0f) {
                                    phi_5175_ = -(_e2747);
                                } else {
                                    phi_5175_ = _e2747;
                                }
                                let _e3078 = phi_5175_;
                                let _e3079 = ((_e3069 + _e3073) + _e3078);
                                if (_e2762 < 0f) {
                                    phi_5182_ = -(_e2762);
                                } else {
                                    phi_5182_ = _e2762;
                                }
                                let _e3083 = phi_5182_;
                                if (_e2765 < 0f) {
                                    phi_5188_ = -(_e2765);
                                } else {
                                    phi_5188_ = _e2765;
                                }
                                let _e3087 = phi_5188_;
                                if (_e2768 < 0f) {
                                    phi_5195_ = -(_e2768);
                                } else {
                                    phi_5195_ = _e2768;
                                }
                                let _e3092 = phi_5195_;
                                let _e3093 = ((_e3083 + _e3087) + _e3092);
                                if (_e3079 > _e3093) {
                                    phi_5201_ = _e3079;
                                } else {
                                    phi_5201_ = _e3093;
                                }
                                let _e3096 = phi_5201_;
                                if (_e2811 < 0f) {
                                    phi_5207_ = -(_e2811);
                                } else {
                                    phi_5207_ = _e2811;
                                }
                                let _e3100 = phi_5207_;
                                if (_e2812 < 0f) {
                                    phi_5213_ = -(_e2812);
                                } else {
                                    phi_5213_ = _e2812;
                                }
                                let _e3104 = phi_5213_;
                                if (_e2813 < 0f) {
                                    phi_5220_ = -(_e2813);
                                } else {
                                    phi_5220_ = _e2813;
                                }
                                let _e3109 = phi_5220_;
                                let _e3111 = (((_e3100 + _e3104) + _e3109) * 0.5f);
                                if (_e3096 > _e3111) {
                                    phi_5227_ = _e3096;
                                } else {
                                    phi_5227_ = _e3111;
                                }
                                let _e3114 = phi_5227_;
                                let _e3119 = local.member_3;
                                let _e3132 = ((((_e2816[0] * _e2741) + (_e2816[1] * _e2744)) + (_e2816[2] * _e2747)) * 3f);
                                let _e3133 = ((((_e2873[0] * _e2762) + (_e2873[1] * _e2765)) + (_e2873[2] * _e2768)) * 3f);
                                if (_e3132 < _e3133) {
                                    phi_5251_ = _e3132;
                                } else {
                                    phi_5251_ = _e3133;
                                }
                                let _e3136 = phi_5251_;
                                if (_e2847 < _e2870) {
                                    phi_5256_ = _e2847;
                                } else {
                                    phi_5256_ = _e2870;
                                }
                                let _e3139 = phi_5256_;
                                if (_e3136 < _e3139) {
                                    phi_5261_ = _e3136;
                                } else {
                                    phi_5261_ = _e3139;
                                }
                                let _e3142 = phi_5261_;
                                if (_e3132 > _e3133) {
                                    phi_5266_ = _e3132;
                                } else {
                                    phi_5266_ = _e3133;
                                }
                                let _e3145 = phi_5266_;
                                if (_e2847 > _e2870) {
                                    phi_5271_ = _e2847;
                                } else {
                                    phi_5271_ = _e2870;
                                }
                                let _e3148 = phi_5271_;
                                if (_e3145 > _e3148) {
                                    phi_5276_ = _e3145;
                                } else {
                                    phi_5276_ = _e3148;
                                }
                                let _e3151 = phi_5276_;
                                let _e3156 = -(_e3151);
                                if (_e3142 > _e3156) {
                                    phi_5286_ = _e3142;
                                } else {
                                    phi_5286_ = _e3156;
                                }
                                let _e3159 = phi_5286_;
                                if ((_e3159 - ((((((_e2935 * 8f) * _e3045) * (0.000000059604645f * (524f / 64f))) + ((_e3052 * 19f) * ((_e2935 * (_e2989 + _e3043)) + (_e2989 * _e3043)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2935) * ((1f + _e2989) * (1f + _e3043))))) + ((_e1499 * (((_e3114 + (_e3045 * (0.000000059604645f * 8f))) + ((_e3119 * 6f) * (_e2989 + _e3043))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2989) * (1f + _e3043))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6254_ = true;
                                } else {
                                    let _e3164 = local.member_1[0u];
                                    let _e3170 = local.member_1[1u];
                                    let _e3174 = (_e3164[0] + _e3170[0]);
                                    let _e3175 = (_e3164[1] + _e3170[1]);
                                    let _e3176 = (_e3164[2] + _e3170[2]);
                                    let _e3179 = local.member_2[0u];
                                    let _e3185 = local.member_2[1u];
                                    let _e3189 = (_e3179[0] + _e3185[0]);
                                    let _e3190 = (_e3179[1] + _e3185[1]);
                                    let _e3191 = (_e3179[2] + _e3185[2]);
                                    let _e3194 = ((_e3175 * _e3191) - (_e3176 * _e3190));
                                    let _e3197 = ((_e3176 * _e3189) - (_e3174 * _e3191));
                                    let _e3200 = ((_e3174 * _e3190) - (_e3175 * _e3189));
                                    let _e3203 = local.member[0u];
                                    let _e3209 = local.member_1[0u];
                                    let _e3215 = local.member_2[0u];
                                    let _e3219 = (_e3203[0] - _e3209[0]);
                                    let _e3220 = (_e3203[1] - _e3209[1]);
                                    let _e3221 = (_e3203[2] - _e3209[2]);
                                    let _e3222 = (_e3203[0] - _e3215[0]);
                                    let _e3223 = (_e3203[1] - _e3215[1]);
                                    let _e3224 = (_e3203[2] - _e3215[2]);
                                    let _e3227 = local.member[1u];
                                    let _e3233 = local.member_1[1u];
                                    let _e3239 = local.member_2[1u];
                                    let _e3243 = (_e3227[0] - _e3233[0]);
                                    let _e3244 = (_e3227[1] - _e3233[1]);
                                    let _e3245 = (_e3227[2] - _e3233[2]);
                                    let _e3246 = (_e3227[0] - _e3239[0]);
                                    let _e3247 = (_e3227[1] - _e3239[1]);
                                    let _e3248 = (_e3227[2] - _e3239[2]);
                                    let _e3251 = local.member[0u];
                                    if (_e3251[0] < 0f) {
                                        phi_5489_ = -(_e3251[0]);
                                    } else {
                                        phi_5489_ = _e3251[0];
                                    }
                                    let _e3258 = phi_5489_;
                                    if (_e3251[1] < 0f) {
                                        phi_5496_ = -(_e3251[1]);
                                    } else {
                                        phi_5496_ = _e3251[1];
                                    }
                                    let _e3262 = phi_5496_;
                                    if (_e3258 > _e3262) {
                                        phi_5501_ = _e3258;
                                    } else {
                                        phi_5501_ = _e3262;
                                    }
                                    let _e3265 = phi_5501_;
                                    if (_e3251[2] < 0f) {
                                        phi_5508_ = -(_e3251[2]);
                                    } else {
                                        phi_5508_ = _e3251[2];
                                    }
                                    let _e3269 = phi_5508_;
                                    if (_e3265 > _e3269) {
                                        phi_5513_ = _e3265;
                                    } else {
                                        phi_5513_ = _e3269;
                                    }
                                    let _e3272 = phi_5513_;
                                    let _e3275 = local.member[1u];
                                    if (_e3275[0] < 0f) {
                                        phi_5526_ = -(_e3275[0]);
                                    } else {
                                        phi_5526_ = _e3275[0];
                                    }
                                    let _e3282 = phi_5526_;
                                    if (_e3275[1] < 0f) {
                                        phi_5533_ = -(_e3275[1]);
                                    } else {
                                        phi_5533_ = _e3275[1];
                                    }
                                    let _e3286 = phi_5533_;
                                    if (_e3282 > _e3286) {
                                        phi_5538_ = _e3282;
                                    } else {
                                        phi_5538_ = _e3286;
                                    }
                                    let _e3289 = phi_5538_;
                                    if (_e3275[2] < 0f) {
                                        phi_5545_ = -(_e3275[2]);
                                    } else {
                                        phi_5545_ = _e3275[2];
                                    }
                                    let _e3293 = phi_5545_;
                                    if (_e3289 > _e3293) {
                                        phi_5550_ = _e3289;
                                    } else {
                                        phi_5550_ = _e3293;
                                    }
                                    let _e3296 = phi_5550_;
                                    if (_e3272 > _e3296) {
                                        phi_5555_ = _e3272;
                                    } else {
                                        phi_5555_ = _e3296;
                                    }
                                    let _e3299 = phi_5555_;
                                    let _e3301 = local.member_3;
                                    let _e3305 = local.member_1[0u];
                                    if (_e3305[0] < 0f) {
                                        phi_5572_ = -(_e3305[0]);
                                    } else {
                                        phi_5572_ = _e3305[0];
                                    }
                                    let _e3312 = phi_5572_;
                                    if (_e3305[1] < 0f) {
                                        phi_5579_ = -(_e3305[1]);
                                    } else {
                                        phi_5579_ = _e3305[1];
                                    }
                                    let _e3316 = phi_5579_;
                                    if (_e3312 > _e3316) {
                                        phi_5584_ = _e3312;
                                    } else {
                                        phi_5584_ = _e3316;
                                    }
                                    let _e3319 = phi_5584_;
                                    if (_e3305[2] < 0f) {
                                        phi_5591_ = -(_e3305[2]);
                                    } else {
                                        phi_5591_ = _e3305[2];
                                    }
                                    let _e3323 = phi_5591_;
                                    if (_e3319 > _e3323) {
                                        phi_5596_ = _e3319;
                                    } else {
                                        phi_5596_ = _e3323;
                                    }
                                    let _e3326 = phi_5596_;
                                    let _e3329 = local.member_1[1u];
                                    if (_e3329[0] < 0f) {
                                        phi_5610_ = -(_e3329[0]);
                                    } else {
                                        phi_5610_ = _e3329[0];
                                    }
                                    let _e3336 = phi_5610_;
                                    if (_e3329[1] < 0f) {
                                        phi_5617_ = -(_e3329[1]);
                                    } else {
                                        phi_5617_ = _e3329[1];
                                    }
                                    let _e3340 = phi_5617_;
                                    if (_e3336 > _e3340) {
                                        phi_5622_ = _e3336;
                                    } else {
                                        phi_5622_ = _e3340;
                                    }
                                    let _e3343 = phi_5622_;
                                    if (_e3329[2] < 0f) {
                                        phi_5629_ = -(_e3329[2]);
                                    } else {
                                        phi_5629_ = _e3329[2];
                                    }
                                    let _e3347 = phi_5629_;
                                    if (_e3343 > _e3347) {
                                        phi_5634_ = _e3343;
                                    } else {
                                        phi_5634_ = _e3347;
                                    }
                                    let _e3350 = phi_5634_;
                                    if (_e3326 > _e3350) {
                                        phi_5639_ = _e3326;
                                    } else {
                                        phi_5639_ = _e3350;
                                    }
                                    let _e3353 = phi_5639_;
                                    let _e3355 = local.member_3;
                                    let _e3359 = local.member_2[0u];
                                    if (_e3359[0] < 0f) {
                                        phi_5656_ = -(_e3359[0]);
                                    } else {
                                        phi_5656_ = _e3359[0];
                                    }
                                    let _e3366 = phi_5656_;
                                    if (_e3359[1] < 0f) {
                                        phi_5663_ = -(_e3359[1]);
                                    } else {
                                        phi_5663_ = _e3359[1];
                                    }
                                    let _e3370 = phi_5663_;
                                    if (_e3366 > _e3370) {
                                        phi_5668_ = _e3366;
                                    } else {
                                        phi_5668_ = _e3370;
                                    }
                                    let _e3373 = phi_5668_;
                                    if (_e3359[2] < 0f) {
                                        phi_5675_ = -(_e3359[2]);
                                    } else {
                                        phi_5675_ = _e3359[2];
                                    }
                                    let _e3377 = phi_5675_;
                                    if (_e3373 > _e3377) {
                                        phi_5680_ = _e3373;
                                    } else {
                                        phi_5680_ = _e3377;
                                    }
                                    let _e3380 = phi_5680_;
                                    let _e3383 = local.member_2[1u];
                                    if (_e3383[0] < 0f) {
                                        phi_5694_ = -(_e3383[0]);
                                    } else {
                                        phi_5694_ = _e3383[0];
                                    }
                                    let _e3390 = phi_5694_;
                                    if (_e3383[1] < 0f) {
                                        phi_5701_ = -(_e3383[1]);
                                    } else {
                                        phi_5701_ = _e3383[1];
                                    }
                                    let _e3394 = phi_5701_;
                                    if (_e3390 > _e3394) {
                                        phi_5706_ = _e3390;
                                    } else {
                                        phi_5706_ = _e3394;
                                    }
                                    let _e3397 = phi_5706_;
                                    if (_e3383[2] < 0f) {
                                        phi_5713_ = -(_e3383[2]);
                                    } else {
                                        phi_5713_ = _e3383[2];
                                    }
                                    let _e3401 = phi_5713_;
                                    if (_e3397 > _e3401) {
                                        phi_5718_ = _e3397;
                                    } else {
                                        phi_5718_ = _e3401;
                                    }
                                    let _e3404 = phi_5718_;
                                    if (_e3380 > _e3404) {
                                        phi_5723_ = _e3380;
                                    } else {
                                        phi_5723_ = _e3404;
                                    }
                                    let _e3407 = phi_5723_;
                                    let _e3409 = local.member_3;
                                    let _e3413 = ((((_e3299 + _e3301) + (_e3353 + _e3355)) + (_e3407 + _e3409)) * 2f);
                                    let _e3416 = local.member_3;
                                    let _e3420 = (((_e1499 * 1.0001f) + (_e3416 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3423 = ((_e3197 * _e3176) - (_e3200 * _e3175));
                                    let _e3426 = ((_e3200 * _e3174) - (_e3194 * _e3176));
                                    let _e3429 = ((_e3194 * _e3175) - (_e3197 * _e3174));
                                    let _e3434 = (((_e3423 * _e3203[0]) + (_e3426 * _e3203[1])) + (_e3429 * _e3203[2]));
                                    let _e3439 = (((_e3423 * _e3219) + (_e3426 * _e3220)) + (_e3429 * _e3221));
                                    let _e3444 = (((_e3423 * _e3222) + (_e3426 * _e3223)) + (_e3429 * _e3224));
                                    let _e3449 = (((_e3423 * _e3203[0]) + (_e3426 * _e3203[1])) + (_e3429 * _e3203[2]));
                                    let _e3454 = (((_e3423 * _e3227[0]) + (_e3426 * _e3227[1])) + (_e3429 * _e3227[2]));
                                    let _e3459 = (((_e3423 * _e3243) + (_e3426 * _e3244)) + (_e3429 * _e3245));
                                    let _e3464 = (((_e3423 * _e3246) + (_e3426 * _e3247)) + (_e3429 * _e3248));
                                    let _e3469 = (((_e3423 * _e3227[0]) + (_e3426 * _e3227[1])) + (_e3429 * _e3227[2]));
                                    if (_e3434 < _e3439) {
                                        phi_5802_ = _e3434;
                                    } else {
                                        phi_5802_ = _e3439;
                                    }
                                    let _e3472 = phi_5802_;
                                    if (_e3444 < _e3449) {
                                        phi_5807_ = _e3444;
                                    } else {
                                        phi_5807_ = _e3449;
                                    }
                                    let _e3475 = phi_5807_;
                                    if (_e3472 < _e3475) {
                                        phi_5812_ = _e3472;
                                    } else {
                                        phi_5812_ = _e3475;
                                    }
                                    let _e3478 = phi_5812_;
                                    if (_e3454 < _e3459) {
                                        phi_5817_ = _e3454;
                                    } else {
                                        phi_5817_ = _e3459;
                                    }
                                    let _e3481 = phi_5817_;
                                    if (_e3464 < _e3469) {
                                        phi_5822_ = _e3464;
                                    } else {
                                        phi_5822_ = _e3469;
                                    }
                                    let _e3484 = phi_5822_;
                                    if (_e3481 < _e3484) {
                                        phi_5827_ = _e3481;
                                    } else {
                                        phi_5827_ = _e3484;
                                    }
                                    let _e3487 = phi_5827_;
                                    if (_e3478 < _e3487) {
                                        phi_5832_ = _e3478;
                                    } else {
                                        phi_5832_ = _e3487;
                                    }
                                    let _e3490 = phi_5832_;
                                    if (_e3434 > _e3439) {
                                        phi_5837_ = _e3434;
                                    } else {
                                        phi_5837_ = _e3439;
                                    }
                                    let _e3493 = phi_5837_;
                                    if (_e3444 > _e3449) {
                                        phi_5842_ = _e3444;
                                    } else {
                                        phi_5842_ = _e3449;
                                    }
                                    let _e3496 = phi_5842_;
                                    if (_e3493 > _e3496) {
                                        phi_5847_ = _e3493;
                                    } else {
                                        phi_5847_ = _e3496;
                                    }
                                    let _e3499 = phi_5847_;
                                    if (_e3454 > _e3459) {
                                        phi_5852_ = _e3454;
                                    } else {
                                        phi_5852_ = _e3459;
                                    }
                                    let _e3502 = phi_5852_;
                                    if (_e3464 > _e3469) {
                                        phi_5857_ = _e3464;
                                    } else {
                                        phi_5857_ = _e3469;
                                    }
                                    let _e3505 = phi_5857_;
                                    if (_e3502 > _e3505) {
                                        phi_5862_ = _e3502;
                                    } else {
                                        phi_5862_ = _e3505;
                                    }
                                    let _e3508 = phi_5862_;
                                    if (_e3499 > _e3508) {
                                        phi_5867_ = _e3499;
                                    } else {
                                        phi_5867_ = _e3508;
                                    }
                                    let _e3511 = phi_5867_;
                                    if (_e3423 < 0f) {
                                        phi_5873_ = -(_e3423);
                                    } else {
                                        phi_5873_ = _e3423;
                                    }
                                    let _e3515 = phi_5873_;
                                    if (_e3426 < 0f) {
                                        phi_5879_ = -(_e3426);
                                    } else {
                                        phi_5879_ = _e3426;
                                    }
                                    let _e3519 = phi_5879_;
                                    if (_e3429 < 0f) {
                                        phi_5886_ = -(_e3429);
                                    } else {
                                        phi_5886_ = _e3429;
                                    }
                                    let _e3524 = phi_5886_;
                                    let _e3525 = ((_e3515 + _e3519) + _e3524);
                                    let _e3530 = -(_e3511);
                                    if (_e3490 > _e3530) {
                                        phi_5897_ = _e3490;
                                    } else {
                                        phi_5897_ = _e3530;
                                    }
                                    let _e3533 = phi_5897_;
                                    let _e3538 = (((_e3533 - ((_e3525 * _e3413) * (0.000000059604645f * (17f / 2f)))) - (_e3525 * _e3420)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3541 = ((_e3197 * _e3191) - (_e3200 * _e3190));
                                    let _e3544 = ((_e3200 * _e3189) - (_e3194 * _e3191));
                                    let _e3547 = ((_e3194 * _e3190) - (_e3197 * _e3189));
                                    let _e3552 = (((_e3541 * _e3203[0]) + (_e3544 * _e3203[1])) + (_e3547 * _e3203[2]));
                                    let _e3557 = (((_e3541 * _e3219) + (_e3544 * _e3220)) + (_e3547 * _e3221));
                                    let _e3562 = (((_e3541 * _e3222) + (_e3544 * _e3223)) + (_e3547 * _e3224));
                                    let _e3567 = (((_e3541 * _e3203[0]) + (_e3544 * _e3203[1])) + (_e3547 * _e3203[2]));
                                    let _e3572 = (((_e3541 * _e3227[0]) + (_e3544 * _e3227[1])) + (_e3547 * _e3227[2]));
                                    let _e3577 = (((_e3541 * _e3243) + (_e3544 * _e3244)) + (_e3547 * _e3245));
                                    let _e3582 = (((_e3541 * _e3246) + (_e3544 * _e3247)) + (_e3547 * _e3248));
                                    let _e3587 = (((_e3541 * _e3227[0]) + (_e3544 * _e3227[1])) + (_e3547 * _e3227[2]));
                                    if (_e3552 < _e3557) {
                                        phi_5968_ = _e3552;
                                    } else {
                                        phi_5968_ = _e3557;
                                    }
                                    let _e3590 = phi_5968_;
                                    if (_e3562 < _e3567) {
                                        phi_5973_ = _e3562;
                                    } else {
                                        phi_5973_ = _e3567;
                                    }
                                    let _e3593 = phi_5973_;
                                    if (_e3590 < _e3593) {
                                        phi_5978_ = _e3590;
                                    } else {
                                        phi_5978_ = _e3593;
                                    }
                                    let _e3596 = phi_5978_;
                                    if (_e3572 < _e3577) {
                                        phi_5983_ = _e3572;
                                    } else {
                                        phi_5983_ = _e3577;
                                    }
                                    let _e3599 = phi_5983_;
                                    if (_e3582 < _e3587) {
                                        phi_5988_ = _e3582;
                                    } else {
                                        phi_5988_ = _e3587;
                                    }
                                    let _e3602 = phi_5988_;
                                    if (_e3599 < _e3602) {
                                        phi_5993_ = _e3599;
                                    } else {
                                        phi_5993_ = _e3602;
                                    }
                                    let _e3605 = phi_5993_;
                                    if (_e3596 < _e3605) {
                                        phi_5998_ = _e3596;
                                    } else {
                                        phi_5998_ = _e3605;
                                    }
                                    let _e3608 = phi_5998_;
                                    if (_e3552 > _e3557) {
                                        phi_6003_ = _e3552;
                                    } else {
                                        phi_6003_ = _e3557;
                                    }
                                    let _e3611 = phi_6003_;
                                    if (_e3562 > _e3567) {
                                        phi_6008_ = _e3562;
                                    } else {
                                        phi_6008_ = _e3567;
                                    }
                                    let _e3614 = phi_6008_;
                                    if (_e3611 > _e3614) {
                                        phi_6013_ = _e3611;
                                    } else {
                                        phi_6013_ = _e3614;
                                    }
                                    let _e3617 = phi_6013_;
                                    if (_e3572 > _e3577) {
                                        phi_6018_ = _e3572;
                                    } else {
                                        phi_6018_ = _e3577;
                                    }
                                    let _e3620 = phi_6018_;
                                    if (_e3582 > _e3587) {
                                        phi_6023_ = _e3582;
                                    } else {
                                        phi_6023_ = _e3587;
                                    }
                                    let _e3623 = phi_6023_;
                                    if (_e3620 > _e3623) {
                                        phi_6028_ = _e3620;
                                    } else {
                                        phi_6028_ = _e3623;
                                    }
                                    let _e3626 = phi_6028_;
                                    if (_e3617 > _e3626) {
                                        phi_6033_ = _e3617;
                                    } else {
                                        phi_6033_ = _e3626;
                                    }
                                    let _e3629 = phi_6033_;
                                    if (_e3541 < 0f) {
                                        phi_6039_ = -(_e3541);
                                    } else {
                                        phi_6039_ = _e3541;
                                    }
                                    let _e3633 = phi_6039_;
                                    if (_e3544 < 0f) {
                                        phi_6045_ = -(_e3544);
                                    } else {
                                        phi_6045_ = _e3544;
                                    }
                                    let _e3637 = phi_6045_;
                                    if (_e3547 < 0f) {
                                        phi_6052_ = -(_e3547);
                                    } else {
                                        phi_6052_ = _e3547;
                                    }
                                    let _e3642 = phi_6052_;
                                    let _e3643 = ((_e3633 + _e3637) + _e3642);
                                    let _e3648 = -(_e3629);
                                    if (_e3608 > _e3648) {
                                        phi_6063_ = _e3608;
                                    } else {
                                        phi_6063_ = _e3648;
                                    }
                                    let _e3651 = phi_6063_;
                                    let _e3656 = (((_e3651 - ((_e3643 * _e3413) * (0.000000059604645f * (17f / 2f)))) - (_e3643 * _e3420)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3538 > _e3656) {
                                        phi_6073_ = _e3538;
                                    } else {
                                        phi_6073_ = _e3656;
                                    }
                                    let _e3659 = phi_6073_;
                                    let _e3660 = (_e3189 - _e3174);
                                    let _e3661 = (_e3190 - _e3175);
                                    let _e3662 = (_e3191 - _e3176);
                                    let _e3665 = ((_e3197 * _e3662) - (_e3200 * _e3661));
                                    let _e3668 = ((_e3200 * _e3660) - (_e3194 * _e3662));
                                    let _e3671 = ((_e3194 * _e3661) - (_e3197 * _e3660));
                                    let _e3676 = (((_e3665 * _e3203[0]) + (_e3668 * _e3203[1])) + (_e3671 * _e3203[2]));
                                    let _e3681 = (((_e3665 * _e3219) + (_e3668 * _e3220)) + (_e3671 * _e3221));
                                    let _e3686 = (((_e3665 * _e3222) + (_e3668 * _e3223)) + (_e3671 * _e3224));
                                    let _e3691 = (((_e3665 * _e3203[0]) + (_e3668 * _e3203[1])) + (_e3671 * _e3203[2]));
                                    let _e3696 = (((_e3665 * _e3227[0]) + (_e3668 * _e3227[1])) + (_e3671 * _e3227[2]));
                                    let _e3701 = (((_e3665 * _e3243) + (_e3668 * _e3244)) + (_e3671 * _e3245));
                                    let _e3706 = (((_e3665 * _e3246) + (_e3668 * _e3247)) + (_e3671 * _e3248));
                                    let _e3711 = (((_e3665 * _e3227[0]) + (_e3668 * _e3227[1])) + (_e3671 * _e3227[2]));
                                    if (_e3676 < _e3681) {
                                        phi_6146_ = _e3676;
                                    } else {
                                        phi_6146_ = _e3681;
                                    }
                                    let _e3714 = phi_6146_;
                                    if (_e3686 < _e3691) {
                                        phi_6151_ = _e3686;
                                    } else {
                                        phi_6151_ = _e3691;
                                    }
                                    let _e3717 = phi_6151_;
                                    if (_e3714 < _e3717) {
                                        phi_6156_ = _e3714;
                                    } else {
                                        phi_6156_ = _e3717;
                                    }
                                    let _e3720 = phi_6156_;
                                    if (_e3696 < _e3701) {
                                        phi_6161_ = _e3696;
                                    } else {
                                        phi_6161_ = _e3701;
                                    }
                                    let _e3723 = phi_6161_;
                                    if (_e3706 < _e3711) {
                                        phi_6166_ = _e3706;
                                    } else {
                                        phi_6166_ = _e3711;
                                    }
                                    let _e3726 = phi_6166_;
                                    if (_e3723 < _e3726) {
                                        phi_6171_ = _e3723;
                                    } else {
                                        phi_6171_ = _e3726;
                                    }
                                    let _e3729 = phi_6171_;
                                    if (_e3720 < _e3729) {
                                        phi_6176_ = _e3720;
                                    } else {
                                        phi_6176_ = _e3729;
                                    }
                                    let _e3732 = phi_6176_;
                                    if (_e3676 > _e3681) {
                                        phi_6181_ = _e3676;
                                    } else {
                                        phi_6181_ = _e3681;
                                    }
                                    let _e3735 = phi_6181_;
                                    if (_e3686 > _e3691) {
                                        phi_6186_ = _e3686;
                                    } else {
                                        phi_6186_ = _e3691;
                                    }
                                    let _e3738 = phi_6186_;
                                    if (_e3735 > _e3738) {
                                        phi_6191_ = _e3735;
                                    } else {
                                        phi_6191_ = _e3738;
                                    }
                                    let _e3741 = phi_6191_;
                                    if (_e3696 > _e3701) {
                                        phi_6196_ = _e3696;
                                    } else {
                                        phi_6196_ = _e3701;
                                    }
                                    let _e3744 = phi_6196_;
                                    if (_e3706 > _e3711) {
                                        phi_6201_ = _e3706;
                                    } else {
                                        phi_6201_ = _e3711;
                                    }
                                    let _e3747 = phi_6201_;
                                    if (_e3744 > _e3747) {
                                        phi_6206_ = _e3744;
                                    } else {
                                        phi_6206_ = _e3747;
                                    }
                                    let _e3750 = phi_6206_;
                                    if (_e3741 > _e3750) {
                                        phi_6211_ = _e3741;
                                    } else {
                                        phi_6211_ = _e3750;
                                    }
                                    let _e3753 = phi_6211_;
                                    if (_e3665 < 0f) {
                                        phi_6217_ = -(_e3665);
                                    } else {
                                        phi_6217_ = _e3665;
                                    }
                                    let _e3757 = phi_6217_;
                                    if (_e3668 < 0f) {
                                        phi_6223_ = -(_e3668);
                                    } else {
                                        phi_6223_ = _e3668;
                                    }
                                    let _e3761 = phi_6223_;
                                    if (_e3671 < 0f) {
                                        phi_6230_ = -(_e3671);
                                    } else {
                                        phi_6230_ = _e3671;
                                    }
                                    let _e3766 = phi_6230_;
                                    let _e3767 = ((_e3757 + _e3761) + _e3766);
                                    let _e3772 = -(_e3753);
                                    if (_e3732 > _e3772) {
                                        phi_6241_ = _e3732;
                                    } else {
                                        phi_6241_ = _e3772;
                                    }
                                    let _e3775 = phi_6241_;
                                    let _e3780 = (((_e3775 - ((_e3767 * _e3413) * (0.000000059604645f * (17f / 2f)))) - (_e3767 * _e3420)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3659 > _e3780) {
                                        phi_6251_ = _e3659;
                                    } else {
                                        phi_6251_ = _e3780;
                                    }
                                    let _e3783 = phi_6251_;
                                    phi_6254_ = (_e3783 > 0f);
                                }
                                let _e3786 = phi_6254_;
                                if _e3786 {
                                    let _e3789 = local_1.member_1[0u];
                                    let _e3795 = local_1.member_2[0u];
                                    let _e3801 = ((_e3789[1] * _e3795[2]) - (_e3789[2] * _e3795[1]));
                                    let _e3804 = ((_e3789[2] * _e3795[0]) - (_e3789[0] * _e3795[2]));
                                    let _e3807 = ((_e3789[0] * _e3795[1]) - (_e3789[1] * _e3795[0]));
                                    let _e3810 = local_1.member_1[1u];
                                    let _e3816 = local_1.member_2[1u];
                                    let _e3822 = ((_e3810[1] * _e3816[2]) - (_e3810[2] * _e3816[1]));
                                    let _e3825 = ((_e3810[2] * _e3816[0]) - (_e3810[0] * _e3816[2]));
                                    let _e3828 = ((_e3810[0] * _e3816[1]) - (_e3810[1] * _e3816[0]));
                                    let _e3831 = local_1.member_1[0u];
                                    let _e3837 = local_1.member_2[1u];
                                    let _e3852 = local_1.member_1[1u];
                                    let _e3858 = local_1.member_2[0u];
                                    let _e3871 = (((_e3831[1] * _e3837[2]) - (_e3831[2] * _e3837[1])) + ((_e3852[1] * _e3858[2]) - (_e3852[2] * _e3858[1])));
                                    let _e3872 = (((_e3831[2] * _e3837[0]) - (_e3831[0] * _e3837[2])) + ((_e3852[2] * _e3858[0]) - (_e3852[0] * _e3858[2])));
                                    let _e3873 = (((_e3831[0] * _e3837[1]) - (_e3831[1] * _e3837[0])) + ((_e3852[0] * _e3858[1]) - (_e3852[1] * _e3858[0])));
                                    let _e3876 = local_1.member[0u];
                                    let _e3887 = local_1.member[1u];
                                    let _e3898 = local_1.member[0u];
                                    let _e3907 = ((((_e3887[0] * _e3801) + (_e3887[1] * _e3804)) + (_e3887[2] * _e3807)) + (((_e3898[0] * _e3871) + (_e3898[1] * _e3872)) + (_e3898[2] * _e3873)));
                                    let _e3910 = local_1.member[0u];
                                    let _e3921 = local_1.member[1u];
                                    let _e3930 = ((((_e3910[0] * _e3822) + (_e3910[1] * _e3825)) + (_e3910[2] * _e3828)) + (((_e3921[0] * _e3871) + (_e3921[1] * _e3872)) + (_e3921[2] * _e3873)));
                                    let _e3933 = local_1.member[1u];
                                    let _e3944 = local_1.member[0u];
                                    if (_e3944[0] < 0f) {
                                        phi_6499_ = -(_e3944[0]);
                                    } else {
                                        phi_6499_ = _e3944[0];
                                    }
                                    let _e3951 = phi_6499_;
                                    if (_e3944[1] < 0f) {
                                        phi_6506_ = -(_e3944[1]);
                                    } else {
                                        phi_6506_ = _e3944[1];
                                    }
                                    let _e3955 = phi_6506_;
                                    if (_e3951 > _e3955) {
                                        phi_6511_ = _e3951;
                                    } else {
                                        phi_6511_ = _e3955;
                                    }
                                    let _e3958 = phi_6511_;
                                    if (_e3944[2] < 0f) {
                                        phi_6518_ = -(_e3944[2]);
                                    } else {
                                        phi_6518_ = _e3944[2];
                                    }
                                    let _e3962 = phi_6518_;
                                    if (_e3958 > _e3962) {
                                        phi_6523_ = _e3958;
                                    } else {
                                        phi_6523_ = _e3962;
                                    }
                                    let _e3965 = phi_6523_;
                                    let _e3968 = local_1.member[1u];
                                    if (_e3968[0] < 0f) {
                                        phi_6536_ = -(_e3968[0]);
                                    } else {
                                        phi_6536_ = _e3968[0];
                                    }
                                    let _e3975 = phi_6536_;
                                    if (_e3968[1] < 0f) {
                                        phi_6543_ = -(_e3968[1]);
                                    } else {
                                        phi_6543_ = _e3968[1];
                                    }
                                    let _e3979 = phi_6543_;
                                    if (_e3975 > _e3979) {
                                        phi_6548_ = _e3975;
                                    } else {
                                        phi_6548_ = _e3979;
                                    }
                                    let _e3982 = phi_6548_;
                                    if (_e3968[2] < 0f) {
                                        phi_6555_ = -(_e3968[2]);
                                    } else {
                                        phi_6555_ = _e3968[2];
                                    }
                                    let _e3986 = phi_6555_;
                                    if (_e3982 > _e3986) {
                                        phi_6560_ = _e3982;
                                    } else {
                                        phi_6560_ = _e3986;
                                    }
                                    let _e3989 = phi_6560_;
                                    if (_e3965 > _e3989) {
                                        phi_6565_ = _e3965;
                                    } else {
                                        phi_6565_ = _e3989;
                                    }
                                    let _e3992 = phi_6565_;
                                    let _e3994 = local_1.member_3;
                                    let _e3995 = (_e3992 + _e3994);
                                    let _e3998 = local_1.member_1[0u];
                                    if (_e3998[0] < 0f) {
                                        phi_6582_ = -(_e3998[0]);
                                    } else {
                                        phi_6582_ = _e3998[0];
                                    }
                                    let _e4005 = phi_6582_;
                                    if (_e3998[1] < 0f) {
                                        phi_6589_ = -(_e3998[1]);
                                    } else {
                                        phi_6589_ = _e3998[1];
                                    }
                                    let _e4009 = phi_6589_;
                                    if (_e4005 > _e4009) {
                                        phi_6594_ = _e4005;
                                    } else {
                                        phi_6594_ = _e4009;
                                    }
                                    let _e4012 = phi_6594_;
                                    if (_e3998[2] < 0f) {
                                        phi_6601_ = -(_e3998[2]);
                                    } else {
                                        phi_6601_ = _e3998[2];
                                    }
                                    let _e4016 = phi_6601_;
                                    if (_e4012 > _e4016) {
                                        phi_6606_ = _e4012;
                                    } else {
                                        phi_6606_ = _e4016;
                                    }
                                    let _e4019 = phi_6606_;
                                    let _e4022 = local_1.member_1[1u];
                                    if (_e4022[0] < 0f) {
                                        phi_6620_ = -(_e4022[0]);
                                    } else {
                                        phi_6620_ = _e4022[0];
                                    }
                                    let _e4029 = phi_6620_;
                                    if (_e4022[1] < 0f) {
                                        phi_6627_ = -(_e4022[1]);
                                    } else {
                                        phi_6627_ = _e4022[1];
                                    }
                                    let _e4033 = phi_6627_;
                                    if (_e4029 > _e4033) {
                                        phi_6632_ = _e4029;
                                    } else {
                                        phi_6632_ = _e4033;
                                    }
                                    let _e4036 = phi_6632_;
                                    if (_e4022[2] < 0f) {
                                        phi_6639_ = -(_e4022[2]);
                                    } else {
                                        phi_6639_ = _e4022[2];
                                    }
                                    let _e4040 = phi_6639_;
                                    if (_e4036 > _e4040) {
                                        phi_6644_ = _e4036;
                                    } else {
                                        phi_6644_ = _e4040;
                                    }
                                    let _e4043 = phi_6644_;
                                    if (_e4019 > _e4043) {
                                        phi_6649_ = _e4019;
                                    } else {
                                        phi_6649_ = _e4043;
                                    }
                                    let _e4046 = phi_6649_;
                                    let _e4048 = local_1.member_3;
                                    let _e4049 = (_e4046 + _e4048);
                                    let _e4052 = local_1.member_2[0u];
                                    if (_e4052[0] < 0f) {
                                        phi_6666_ = -(_e4052[0]);
                                    } else {
                                        phi_6666_ = _e4052[0];
                                    }
                                    let _e4059 = phi_6666_;
                                    if (_e4052[1] < 0f) {
                                        phi_6673_ = -(_e4052[1]);
                                    } else {
                                        phi_6673_ = _e4052[1];
                                    }
                                    let _e4063 = phi_6673_;
                                    if (_e4059 > _e4063) {
                                        phi_6678_ = _e4059;
                                    } else {
                                        phi_6678_ = _e4063;
                                    }
                                    let _e4066 = phi_6678_;
                                    if (_e4052[2] < 0f) {
                                        phi_6685_ = -(_e4052[2]);
                                    } else {
                                        phi_6685_ = _e4052[2];
                                    }
                                    let _e4070 = phi_6685_;
                                    if (_e4066 > _e4070) {
                                        phi_6690_ = _e4066;
                                    } else {
                                        phi_6690_ = _e4070;
                                    }
                                    let _e4073 = phi_6690_;
                                    let _e4076 = local_1.member_2[1u];
                                    if (_e4076[0] < 0f) {
                                        phi_6704_ = -(_e4076[0]);
                                    } else {
                                        phi_6704_ = _e4076[0];
                                    }
                                    let _e4083 = phi_6704_;
                                    if (_e4076[1] < 0f) {
                                        phi_6711_ = -(_e4076[1]);
                                    } else {
                                        phi_6711_ = _e4076[1];
                                    }
                                    let _e4087 = phi_6711_;
                                    if (_e4083 > _e4087) {
                                        phi_6716_ = _e4083;
                                    } else {
                                        phi_6716_ = _e4087;
                                    }
                                    let _e4090 = phi_6716_;
                                    if (_e4076[2] < 0f) {
                                        phi_6723_ = -(_e4076[2]);
                                    } else {
                                        phi_6723_ = _e4076[2];
                                    }
                                    let _e4094 = phi_6723_;
                                    if (_e4090 > _e4094) {
                                        phi_6728_ = _e4090;
                                    } else {
                                        phi_6728_ = _e4094;
                                    }
                                    let _e4097 = phi_6728_;
                                    if (_e4073 > _e4097) {
                                        phi_6733_ = _e4073;
                                    } else {
                                        phi_6733_ = _e4097;
                                    }
                                    let _e4100 = phi_6733_;
                                    let _e4102 = local_1.member_3;
                                    let _e4103 = (_e4100 + _e4102);
                                    let _e4105 = ((_e4049 * 8f) * _e4103);
                                    let _e4112 = local_1.member_3;
                                    if (_e3801 < 0f) {
                                        phi_6764_ = -(_e3801);
                                    } else {
                                        phi_6764_ = _e3801;
                                    }
                                    let _e4129 = phi_6764_;
                                    if (_e3804 < 0f) {
                                        phi_6770_ = -(_e3804);
                                    } else {
                                        phi_6770_ = _e3804;
                                    }
                                    let _e4133 = phi_6770_;
                                    if (_e3807 < 0f) {
                                        phi_6777_ = -(_e3807);
                                    } else {
                                        phi_6777_ = _e3807;
                                    }
                                    let _e4138 = phi_6777_;
                                    let _e4139 = ((_e4129 + _e4133) + _e4138);
                                    if (_e3822 < 0f) {
                                        phi_6784_ = -(_e3822);
                                    } else {
                                        phi_6784_ = _e3822;
                                    }
                                    let _e4143 = phi_6784_;
                                    if (_e3825 < 0f) {
                                        phi_6790_ = -(_e3825);
                                    } else {
                                        phi_6790_ = _e3825;
                                    }
                                    let _e4147 = phi_6790_;
                                    if (_e3828 < 0f) {
                                        phi_6797_ = -(_e3828);
                                    } else {
                                        phi_6797_ = _e3828;
                                    }
                                    let _e4152 = phi_6797_;
                                    let _e4153 = ((_e4143 + _e4147) + _e4152);
                                    if (_e4139 > _e4153) {
                                        phi_6803_ = _e4139;
                                    } else {
                                        phi_6803_ = _e4153;
                                    }
                                    let _e4156 = phi_6803_;
                                    if (_e3871 < 0f) {
                                        phi_6809_ = -(_e3871);
                                    } else {
                                        phi_6809_ = _e3871;
                                    }
                                    let _e4160 = phi_6809_;
                                    if (_e3872 < 0f) {
                                        phi_6815_ = -(_e3872);
                                    } else {
                                        phi_6815_ = _e3872;
                                    }
                                    let _e4164 = phi_6815_;
                                    if (_e3873 < 0f) {
                                        phi_6822_ = -(_e3873);
                                    } else {
                                        phi_6822_ = _e3873;
                                    }
                                    let _e4169 = phi_6822_;
                                    let _e4171 = (((_e4160 + _e4164) + _e4169) * 0.5f);
                                    if (_e4156 > _e4171) {
                                        phi_6829_ = _e4156;
                                    } else {
                                        phi_6829_ = _e4171;
                                    }
                                    let _e4174 = phi_6829_;
                                    let _e4179 = local_1.member_3;
                                    let _e4192 = ((((_e3876[0] * _e3801) + (_e3876[1] * _e3804)) + (_e3876[2] * _e3807)) * 3f);
                                    let _e4193 = ((((_e3933[0] * _e3822) + (_e3933[1] * _e3825)) + (_e3933[2] * _e3828)) * 3f);
                                    if (_e4192 < _e4193) {
                                        phi_6853_ = _e4192;
                                    } else {
                                        phi_6853_ = _e4193;
                                    }
                                    let _e4196 = phi_6853_;
                                    if (_e3907 < _e3930) {
                                        phi_6858_ = _e3907;
                                    } else {
                                        phi_6858_ = _e3930;
                                    }
                                    let _e4199 = phi_6858_;
                                    if (_e4196 < _e4199) {
                                        phi_6863_ = _e4196;
                                    } else {
                                        phi_6863_ = _e4199;
                                    }
                                    let _e4202 = phi_6863_;
                                    if (_e4192 > _e4193) {
                                        phi_6868_ = _e4192;
                                    } else {
                                        phi_6868_ = _e4193;
                                    }
                                    let _e4205 = phi_6868_;
                                    if (_e3907 > _e3930) {
                                        phi_6873_ = _e3907;
                                    } else {
                                        phi_6873_ = _e3930;
                                    }
                                    let _e4208 = phi_6873_;
                                    if (_e4205 > _e4208) {
                                        phi_6878_ = _e4205;
                                    } else {
                                        phi_6878_ = _e4208;
                                    }
                                    let _e4211 = phi_6878_;
                                    let _e4216 = -(_e4211);
                                    if (_e4202 > _e4216) {
                                        phi_6888_ = _e4202;
                                    } else {
                                        phi_6888_ = _e4216;
                                    }
                                    let _e4219 = phi_6888_;
                                    if ((_e4219 - ((((((_e3995 * 8f) * _e4105) * (0.000000059604645f * (524f / 64f))) + ((_e4112 * 19f) * ((_e3995 * (_e4049 + _e4103)) + (_e4049 * _e4103)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3995) * ((1f + _e4049) * (1f + _e4103))))) + ((_e1499 * (((_e4174 + (_e4105 * (0.000000059604645f * 8f))) + ((_e4179 * 6f) * (_e4049 + _e4103))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4049) * (1f + _e4103))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_7856_ = true;
                                    } else {
                                        let _e4224 = local_1.member_1[0u];
                                        let _e4230 = local_1.member_1[1u];
                                        let _e4234 = (_e4224[0] + _e4230[0]);
                                        let _e4235 = (_e4224[1] + _e4230[1]);
                                        let _e4236 = (_e4224[2] + _e4230[2]);
                                        let _e4239 = local_1.member_2[0u];
                                        let _e4245 = local_1.member_2[1u];
                                        let _e4249 = (_e4239[0] + _e4245[0]);
                                        let _e4250 = (_e4239[1] + _e4245[1]);
                                        let _e4251 = (_e4239[2] + _e4245[2]);
                                        let _e4254 = ((_e4235 * _e4251) - (_e4236 * _e4250));
                                        let _e4257 = ((_e4236 * _e4249) - (_e4234 * _e4251));
                                        let _e4260 = ((_e4234 * _e4250) - (_e4235 * _e4249));
                                        let _e4263 = local_1.member[0u];
                                        let _e4269 = local_1.member_1[0u];
                                        let _e4275 = local_1.member_2[0u];
                                        let _e4279 = (_e4263[0] - _e4269[0]);
                                        let _e4280 = (_e4263[1] - _e4269[1]);
                                        let _e4281 = (_e4263[2] - _e4269[2]);
                                        let _e4282 = (_e4263[0] - _e4275[0]);
                                        let _e4283 = (_e4263[1] - _e4275[1]);
                                        let _e4284 = (_e4263[2] - _e4275[2]);
                                        let _e4287 = local_1.member[1u];
                                        let _e4293 = local_1.member_1[1u];
                                        let _e4299 = local_1.member_2[1u];
                                        let _e4303 = (_e4287[0] - _e4293[0]);
                                        let _e4304 = (_e4287[1] - _e4293[1]);
                                        let _e4305 = (_e4287[2] - _e4293[2]);
                                        let _e4306 = (_e4287[0] - _e4299[0]);
                                        let _e4307 = (_e4287[1] - _e4299[1]);
                                        let _e4308 = (_e4287[2] - _e4299[2]);
                                        let _e4311 = local_1.member[0u];
                                        if (_e4311[0] < 0f) {
                                            phi_7091_ = -(_e4311[0]);
                                        } else {
                                            phi_7091_ = _e4311[0];
                                        }
                                        let _e4318 = phi_7091_;
                                        if (_e4311[1] < 0f) {
                                            phi_7098_ = -(_e4311[1]);
                                        } else {
                                            phi_7098_ = _e4311[1];
                                        }
                                        let _e4322 = phi_7098_;
                                        if (_e4318 > _e4322) {
                                            phi_7103_ = _e4318;
                                        } else {
                                            phi_7103_ = _e4322;
                                        }
                                        let _e4325 = phi_7103_;
                                        if (_e4311[2] < 0f) {
                                            phi_7110_ = -(_e4311[2]);
                                        } else {
                                            phi_7110_ = _e4311[2];
                                        }
                                        let _e4329 = phi_7110_;
                                        if (_e4325 > _e4329) {
                                            phi_7115_ = _e4325;
                                        } else {
                                            phi_7115_ = _e4329;
                                        }
                                        let _e4332 = phi_7115_;
                                        let _e4335 = local_1.member[1u];
                                        if (_e4335[0] < 0f) {
                                            phi_7128_ = -(_e4335[0]);
                                        } else {
                                            phi_7128_ = _e4335[0];
                                        }
                                        let _e4342 = phi_7128_;
                                        if (_e4335[1] < 0f) {
                                            phi_7135_ = -(_e4335[1]);
                                        } else {
                                            phi_7135_ = _e4335[1];
                                        }
                                        let _e4346 = phi_7135_;
                                        if (_e4342 > _e4346) {
                                            phi_7140_ = _e4342;
                                        } else {
                                            phi_7140_ = _e4346;
                                        }
                                        let _e4349 = phi_7140_;
                                        if (_e4335[2] < 0f) {
                                            phi_7147_ = -(_e4335[2]);
                                        } else {
                                            phi_7147_ = _e4335[2];
                                        }
                                        let _e4353 = phi_7147_;
                                        if (_e4349 > _e4353) {
                                            phi_7152_ = _e4349;
                                        } else {
                                            phi_7152_ = _e4353;
                                        }
                                        let _e4356 = phi_7152_;
                                        if (_e4332 > _e4356) {
                                            phi_7157_ = _e4332;
                                        } else {
                                            phi_7157_ = _e4356;
                                        }
                                        let _e4359 = phi_7157_;
                                        let _e4361 = local_1.member_3;
                                        let _e4365 = local_1.member_1[0u];
                                        if (_e4365[0] < 0f) {
                                            phi_7174_ = -(_e4365[0]);
                                        } else {
                                            phi_7174_ = _e4365[0];
                                        }
                                        let _e4372 = phi_7174_;
                                        if (_e4365[1] < 0f) {
                                            phi_7181_ = -(_e4365[1]);
                                        } else {
                                            phi_7181_ = _e4365[1];
                                        }
                                        let _e4376 = phi_7181_;
                                        if (_e4372 > _e4376) {
                                            phi_7186_ = _e4372;
                                        } else {
                                            phi_7186_ = _e4376;
                                        }
                                        let _e4379 = phi_7186_;
                                        if (_e4365[2] < 0f) {
                                            phi_7193_ = -(_e4365[2]);
                                        } else {
                                            phi_7193_ = _e4365[2];
                                        }
                                        let _e4383 = phi_7193_;
                                        if (_e4379 > _e4383) {
                                            phi_7198_ = _e4379;
                                        } else {
                                            phi_7198_ = _e4383;
                                        }
                                        let _e4386 = phi_7198_;
                                        let _e4389 = local_1.member_1[1u];
                                        if (_e4389[0] < 0f) {
                                            phi_7212_ = -(_e4389[0]);
                                        } else {
                                            phi_7212_ = _e4389[0];
                                        }
                                        let _e4396 = phi_7212_;
                                        if (_e4389[1] < 0f) {
                                            phi_7219_ = -(_e4389[1]);
                                        } else {
                                            phi_7219_ = _e4389[1];
                                        }
                                        let _e4400 = phi_7219_;
                                        if (_e4396 > _e4400) {
                                            phi_7224_ = _e4396;
                                        } else {
                                            phi_7224_ = _e4400;
                                        }
                                        let _e4403 = phi_7224_;
                                        if (_e4389[2] < 0f) {
                                            phi_7231_ = -(_e4389[2]);
                                        } else {
                                            phi_7231_ = _e4389[2];
                                        }
                                        let _e4407 = phi_7231_;
                                        if (_e4403 > _e4407) {
                                            phi_7236_ = _e4403;
                                        } else {
                                            phi_7236_ = _e4407;
                                        }
                                        let _e4410 = phi_7236_;
                                        if (_e4386 > _e4410) {
                                            phi_7241_ = _e4386;
                                        } else {
                                            phi_7241_ = _e4410;
                                        }
                                        let _e4413 = phi_7241_;
                                        let _e4415 = local_1.member_3;
                                        let _e4419 = local_1.member_2[0u];
                                        if (_e4419[0] < 0f) {
                                            phi_7258_ = -(_e4419[0]);
                                        } else {
                                            phi_7258_ = _e4419[0];
                                        }
                                        let _e4426 = phi_7258_;
                                        if (_e4419[1] < 0f) {
                                            phi_7265_ = -(_e4419[1]);
                                        } else {
                                            phi_7265_ = _e4419[1];
                                        }
                                        let _e4430 = phi_7265_;
                                        if (_e4426 > _e4430) {
                                            phi_7270_ = _e4426;
                                        } else {
                                            phi_7270_ = _e4430;
                                        }
                                        let _e4433 = phi_7270_;
                                        if (_e4419[2] < 0f) {
                                            phi_7277_ = -(_e4419[2]);
                                        } else {
                                            phi_7277_ = _e4419[2];
                                        }
                                        let _e4437 = phi_7277_;
                                        if (_e4433 > _e4437) {
                                            phi_7282_ = _e4433;
                                        } else {
                                            phi_7282_ = _e4437;
                                        }
                                        let _e4440 = phi_7282_;
                                        let _e4443 = local_1.member_2[1u];
                                        if (_e4443[0] < 0f) {
                                            phi_7296_ = -(_e4443[0]);
                                        } else {
                                            phi_7296_ = _e4443[0];
                                        }
                                        let _e4450 = phi_7296_;
                                        if (_e4443[1] < 0f) {
                                            phi_7303_ = -(_e4443[1]);
                                        } else {
                                            phi_7303_ = _e4443[1];
                                        }
                                        let _e4454 = phi_7303_;
                                        if (_e4450 > _e4454) {
                                            phi_7308_ = _e4450;
                                        } else {
                                            phi_7308_ = _e4454;
                                        }
                                        let _e4457 = phi_7308_;
                                        if (_e4443[2] < 0f) {
                                            phi_7315_ = -(_e4443[2]);
                                        } else {
                                            phi_7315_ = _e4443[2];
                                        }
                                        let _e4461 = phi_7315_;
                                        if (_e4457 > _e4461) {
                                            phi_7320_ = _e4457;
                                        } else {
                                            phi_7320_ = _e4461;
                                        }
                                        let _e4464 = phi_7320_;
                                        if (_e4440 > _e4464) {
                                            phi_7325_ = _e4440;
                                        } else {
                                            phi_7325_ = _e4464;
                                        }
                                        let _e4467 = phi_7325_;
                                        let _e4469 = local_1.member_3;
                                        let _e4473 = ((((_e4359 + _e4361) + (_e4413 + _e4415)) + (_e4467 + _e4469)) * 2f);
                                        let _e4476 = local_1.member_3;
                                        let _e4480 = (((_e1499 * 1.0001f) + (_e4476 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4483 = ((_e4257 * _e4236) - (_e4260 * _e4235));
                                        let _e4486 = ((_e4260 * _e4234) - (_e4254 * _e4236));
                                        let _e4489 = ((_e4254 * _e4235) - (_e4257 * _e4234));
                                        let _e4494 = (((_e4483 * _e4263[0]) + (_e4486 * _e4263[1])) + (_e4489 * _e4263[2]));
                                        let _e4499 = (((_e4483 * _e4279) + (_e4486 * _e4280)) + (_e4489 * _e4281));
                                        let _e4504 = (((_e4483 * _e4282) + (_e4486 * _e4283)) + (_e4489 * _e4284));
                                        let _e4509 = (((_e4483 * _e4263[0]) + (_e4486 * _e4263[1])) + (_e4489 * _e4263[2]));
                                        let _e4514 = (((_e4483 * _e4287[0]) + (_e4486 * _e4287[1])) + (_e4489 * _e4287[2]));
                                        let _e4519 = (((_e4483 * _e4303) + (_e4486 * _e4304)) + (_e4489 * _e4305));
                                        let _e4524 = (((_e4483 * _e4306) + (_e4486 * _e4307)) + (_e4489 * _e4308));
                                        let _e4529 = (((_e4483 * _e4287[0]) + (_e4486 * _e4287[1])) + (_e4489 * _e4287[2]));
                                        if (_e4494 < _e4499) {
                                            phi_7404_ = _e4494;
                                        } else {
                                            phi_7404_ = _e4499;
                                        }
                                        let _e4532 = phi_7404_;
                                        if (_e4504 < _e4509) {
                                            phi_7409_ = _e4504;
                                        } else {
                                            phi_7409_ = _e4509;
                                        }
                                        let _e4535 = phi_7409_;
                                        if (_e4532 < _e4535) {
                                            phi_7414_ = _e4532;
                                        } else {
                                            phi_7414_ = _e4535;
                                        }
                                        let _e4538 = phi_7414_;
                                        if (_e4514 < _e4519) {
                                            phi_7419_ = _e4514;
                                        } else {
                                            phi_7419_ = _e4519;
                                        }
                                        let _e4541 = phi_7419_;
                                        if (_e4524 < _e4529) {
                                            phi_7424_ = _e4524;
                                        } else {
                                            phi_7424_ = _e4529;
                                        }
                                        let _e4544 = phi_7424_;
                                        if (_e4541 < _e4544) {
                                            phi_7429_ = _e4541;
                                        } else {
                                            phi_7429_ = _e4544;
                                        }
                                        let _e4547 = phi_7429_;
                                        if (_e4538 < _e4547) {
                                            phi_7434_ = _e4538;
                                        } else {
                                            phi_7434_ = _e4547;
                                        }
                                        let _e4550 = phi_7434_;
                                        if (_e4494 > _e4499) {
                                            phi_7439_ = _e4494;
                                        } else {
                                            phi_7439_ = _e4499;
                                        }
                                        let _e4553 = phi_7439_;
                                        if (_e4504 > _e4509) {
                                            phi_7444_ = _e4504;
                                        } else {
                                            phi_7444_ = _e4509;
                                        }
                                        let _e4556 = phi_7444_;
                                        if (_e4553 > _e4556) {
                                            phi_7449_ = _e4553;
                                        } else {
                                            phi_7449_ = _e4556;
                                        }
                                        let _e4559 = phi_7449_;
                                        if (_e4514 > _e4519) {
                                            phi_7454_ = _e4514;
                                        } else {
                                            phi_7454_ = _e4519;
                                        }
                                        let _e4562 = phi_7454_;
                                        if (_e4524 > _e4529) {
                                            phi_7459_ = _e4524;
                                        } else {
                                            phi_7459_ = _e4529;
                                        }
                                        let _e4565 = phi_7459_;
                                        if (_e4562 > _e4565) {
                                            phi_7464_ = _e4562;
                                        } else {
                                            phi_7464_ = _e4565;
                                        }
                                        let _e4568 = phi_7464_;
                                        if (_e4559 > _e4568) {
                                            phi_7469_ = _e4559;
                                        } else {
                                            phi_7469_ = _e4568;
                                        }
                                        let _e4571 = phi_7469_;
                                        if (_e4483 < 0f) {
                                            phi_7475_ = -(_e4483);
                                        } else {
                                            phi_7475_ = _e4483;
                                        }
                                        let _e4575 = phi_7475_;
                                        if (_e4486 < 0f) {
                                            phi_7481_ = -(_e4486);
                                        } else {
                                            phi_7481_ = _e4486;
                                        }
                                        let _e4579 = phi_7481_;
                                        if (_e4489 < 0f) {
                                            phi_7488_ = -(_e4489);
                                        } else {
                                            phi_7488_ = _e4489;
                                        }
                                        let _e4584 = phi_7488_;
                                        let _e4585 = ((_e4575 + _e4579) + _e4584);
                                        let _e4590 = -(_e4571);
                                        if (_e4550 > _e4590) {
                                            phi_7499_ = _e4550;
                                        } else {
                                            phi_7499_ = _e4590;
                                        }
                                        let _e4593 = phi_7499_;
                                        let _e4598 = (((_e4593 - ((_e4585 * _e4473) * (0.000000059604645f * (17f / 2f)))) - (_e4585 * _e4480)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4601 = ((_e4257 * _e4251) - (_e4260 * _e4250));
                                        let _e4604 = ((_e4260 * _e4249) - (_e4254 * _e4251));
                                        let _e4607 = ((_e4254 * _e4250) - (_e4257 * _e4249));
                                        let _e4612 = (((_e4601 * _e4263[0]) + (_e4604 * _e4263[1])) + (_e4607 * _e4263[2]));
                                        let _e4617 = (((_e4601 * _e4279) + (_e4604 * _e4280)) + (_e4607 * _e4281));
                                        let _e4622 = (((_e4601 * _e4282) + (_e4604 * _e4283)) + (_e4607 * _e4284));
                                        let _e4627 = (((_e4601 * _e4263[0]) + (_e4604 * _e4263[1])) + (_e4607 * _e4263[2]));
                                        let _e4632 = (((_e4601 * _e4287[0]) + (_e4604 * _e4287[1])) + (_e4607 * _e4287[2]));
                                        let _e4637 = (((_e4601 * _e4303) + (_e4604 * _e4304)) + (_e4607 * _e4305));
                                        let _e4642 = (((_e4601 * _e4306) + (_e4604 * _e4307)) + (_e4607 * _e4308));
                                        let _e4647 = (((_e4601 * _e4287[0]) + (_e4604 * _e4287[1])) + (_e4607 * _e4287[2]));
                                        if (_e4612 < _e4617) {
                                            phi_7570_ = _e4612;
                                        } else {
                                            phi_7570_ = _e4617;
                                        }
                                        let _e4650 = phi_7570_;
                                        if (_e4622 < _e4627) {
                                            phi_7575_ = _e4622;
                                        } else {
                                            phi_7575_ = _e4627;
                                        }
                                        let _e4653 = phi_7575_;
                                        if (_e4650 < _e4653) {
                                            phi_7580_ = _e4650;
                                        } else {
                                            phi_7580_ = _e4653;
                                        }
                                        let _e4656 = phi_7580_;
                                        if (_e4632 < _e4637) {
                                            phi_7585_ = _e4632;
                                        } else {
                                            phi_7585_ = _e4637;
                                        }
                                        let _e4659 = phi_7585_;
                                        if (_e4642 < _e4647) {
                                            phi_7590_ = _e4642;
                                        } else {
                                            phi_7590_ = _e4647;
                                        }
                                        let _e4662 = phi_7590_;
                                        if (_e4659 < _e4662) {
                                            phi_7595_ = _e4659;
                                        } else {
                                            phi_7595_ = _e4662;
                                        }
                                        let _e4665 = phi_7595_;
                                        if (_e4656 < _e4665) {
                                            phi_7600_ = _e4656;
                                        } else {
                                            phi_7600_ = _e4665;
                                        }
                                        let _e4668 = phi_7600_;
                                        if (_e4612 > _e4617) {
                                            phi_7605_ = _e4612;
                                        } else {
                                            phi_7605_ = _e4617;
                                        }
                                        let _e4671 = phi_7605_;
                                        if (_e4622 > _e4627) {
                                            phi_7610_ = _e4622;
                                        } else {
                                            phi_7610_ = _e4627;
                                        }
                                        let _e4674 = phi_7610_;
                                        if (_e4671 > _e4674) {
                                            phi_7615_ = _e4671;
                                        } else {
                                            phi_7615_ = _e4674;
                                        }
                                        let _e4677 = phi_7615_;
                                        if (_e4632 > _e4637) {
                                            phi_7620_ = _e4632;
                                        } else {
                                            phi_7620_ = _e4637;
                                        }
                                        let _e4680 = phi_7620_;
                                        if (_e4642 > _e4647) {
                                            phi_7625_ = _e4642;
                                        } else {
                                            phi_7625_ = _e4647;
                                        }
                                        let _e4683 = phi_7625_;
                                        if (_e4680 > _e4683) {
                                            phi_7630_ = _e4680;
                                        } else {
                                            phi_7630_ = _e4683;
                                        }
                                        let _e4686 = phi_7630_;
                                        if (_e4677 > _e4686) {
                                            phi_7635_ = _e4677;
                                        } else {
                                            phi_7635_ = _e4686;
                                        }
                                        let _e4689 = phi_7635_;
                                        if (_e4601 < 0f) {
                                            phi_7641_ = -(_e4601);
                                        } else {
                                            phi_7641_ = _e4601;
                                        }
                                        let _e4693 = phi_7641_;
                                        if (_e4604 < 0f) {
                                            phi_7647_ = -(_e4604);
                                        } else {
                                            phi_7647_ = _e4604;
                                        }
                                        let _e4697 = phi_7647_;
                                        if (_e4607 < 0f) {
                                            phi_7654_ = -(_e4607);
                                        } else {
                                            phi_7654_ = _e4607;
                                        }
                                        let _e4702 = phi_7654_;
                                        let _e4703 = ((_e4693 + _e4697) + _e4702);
                                        let _e4708 = -(_e4689);
                                        if (_e4668 > _e4708) {
                                            phi_7665_ = _e4668;
                                        } else {
                                            phi_7665_ = _e4708;
                                        }
                                        let _e4711 = phi_7665_;
                                        let _e4716 = (((_e4711 - ((_e4703 * _e4473) * (0.000000059604645f * (17f / 2f)))) - (_e4703 * _e4480)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4598 > _e4716) {
                                            phi_7675_ = _e4598;
                                        } else {
                                            phi_7675_ = _e4716;
                                        }
                                        let _e4719 = phi_7675_;
                                        let _e4720 = (_e4249 - _e4234);
                                        let _e4721 = (_e4250 - _e4235);
                                        let _e4722 = (_e4251 - _e4236);
                                        let _e4725 = ((_e4257 * _e4722) - (_e4260 * _e4721));
                                        let _e4728 = ((_e4260 * _e4720) - (_e4254 * _e4722));
                                        let _e4731 = ((_e4254 * _e4721) - (_e4257 * _e4720));
                                        let _e4736 = (((_e4725 * _e4263[0]) + (_e4728 * _e4263[1])) + (_e4731 * _e4263[2]));
                                        let _e4741 = (((_e4725 * _e4279) + (_e4728 * _e4280)) + (_e4731 * _e4281));
                                        let _e4746 = (((_e4725 * _e4282) + (_e4728 * _e4283)) + (_e4731 * _e4284));
                                        let _e4751 = (((_e4725 * _e4263[0]) + (_e4728 * _e4263[1])) + (_e4731 * _e4263[2]));
                                        let _e4756 = (((_e4725 * _e4287[0]) + (_e4728 * _e4287[1])) + (_e4731 * _e4287[2]));
                                        let _e4761 = (((_e4725 * _e4303) + (_e4728 * _e4304)) + (_e4731 * _e4305));
                                        let _e4766 = (((_e4725 * _e4306) + (_e4728 * _e4307)) + (_e4731 * _e4308));
                                        let _e4771 = (((_e4725 * _e4287[0]) + (_e4728 * _e4287[1])) + (_e4731 * _e4287[2]));
                                        if (_e4736 < _e4741) {
                                            phi_7748_ = _e4736;
                                        } else {
                                            phi_7748_ = _e4741;
                                        }
                                        let _e4774 = phi_7748_;
                                        if (_e4746 < _e4751) {
                                            phi_7753_ = _e4746;
                                        } else {
                                            phi_7753_ = _e4751;
                                        }
                                        let _e4777 = phi_7753_;
                                        if (_e4774 < _e4777) {
                                            phi_7758_ = _e4774;
                                        } else {
                                            phi_7758_ = _e4777;
                                        }
                                        let _e4780 = phi_7758_;
                                        if (_e4756 < _e4761) {
                                            phi_7763_ = _e4756;
                                        } else {
                                            phi_7763_ = _e4761;
                                        }
                                        let _e4783 = phi_7763_;
                                        if (_e4766 < _e4771) {
                                            phi_7768_ = _e4766;
                                        } else {
                                            phi_7768_ = _e4771;
                                        }
                                        let _e4786 = phi_7768_;
                                        if (_e4783 < _e4786) {
                                            phi_7773_ = _e4783;
                                        } else {
                                            phi_7773_ = _e4786;
                                        }
                                        let _e4789 = phi_7773_;
                                        if (_e4780 < _e4789) {
                                            phi_7778_ = _e4780;
                                        } else {
                                            phi_7778_ = _e4789;
                                        }
                                        let _e4792 = phi_7778_;
                                        if (_e4736 > _e4741) {
                                            phi_7783_ = _e4736;
                                        } else {
                                            phi_7783_ = _e4741;
                                        }
                                        let _e4795 = phi_7783_;
                                        if (_e4746 > _e4751) {
                                            phi_7788_ = _e4746;
                                        } else {
                                            phi_7788_ = _e4751;
                                        }
                                        let _e4798 = phi_7788_;
                                        if (_e4795 > _e4798) {
                                            phi_7793_ = _e4795;
                                        } else {
                                            phi_7793_ = _e4798;
                                        }
                                        let _e4801 = phi_7793_;
                                        if (_e4756 > _e4761) {
                                            phi_7798_ = _e4756;
                                        } else {
                                            phi_7798_ = _e4761;
                                        }
                                        let _e4804 = phi_7798_;
                                        if (_e4766 > _e4771) {
                                            phi_7803_ = _e4766;
                                        } else {
                                            phi_7803_ = _e4771;
                                        }
                                        let _e4807 = phi_7803_;
                                        if (_e4804 > _e4807) {
                                            phi_7808_ = _e4804;
                                        } else {
                                            phi_7808_ = _e4807;
                                        }
                                        let _e4810 = phi_7808_;
                                        if (_e4801 > _e4810) {
                                            phi_7813_ = _e4801;
                                        } else {
                                            phi_7813_ = _e4810;
                                        }
                                        let _e4813 = phi_7813_;
                                        if (_e4725 < 0f) {
                                            phi_7819_ = -(_e4725);
                                        } else {
                                            phi_7819_ = _e4725;
                                        }
                                        let _e4817 = phi_7819_;
                                        if (_e4728 < 0f) {
                                            phi_7825_ = -(_e4728);
                                        } else {
                                            phi_7825_ = _e4728;
                                        }
                                        let _e4821 = phi_7825_;
                                        if (_e4731 < 0f) {
                                            phi_7832_ = -(_e4731);
                                        } else {
                                            phi_7832_ = _e4731;
                                        }
                                        let _e4826 = phi_7832_;
                                        let _e4827 = ((_e4817 + _e4821) + _e4826);
                                        let _e4832 = -(_e4813);
                                        if (_e4792 > _e4832) {
                                            phi_7843_ = _e4792;
                                        } else {
                                            phi_7843_ = _e4832;
                                        }
                                        let _e4835 = phi_7843_;
                                        let _e4840 = (((_e4835 - ((_e4827 * _e4473) * (0.000000059604645f * (17f / 2f)))) - (_e4827 * _e4480)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4719 > _e4840) {
                                            phi_7853_ = _e4719;
                                        } else {
                                            phi_7853_ = _e4840;
                                        }
                                        let _e4843 = phi_7853_;
                                        phi_7856_ = (_e4843 > 0f);
                                    }
                                    let _e4846 = phi_7856_;
                                    phi_7857_ = _e4846;
                                } else {
                                    phi_7857_ = false;
                                }
                                let _e4848 = phi_7857_;
                                phi_7859_ = !(_e4848);
                            }
                            let _e4851 = phi_7859_;
                            if _e4851 {
                                let _e4853 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1007] = ((2147483648u | (_e4853 << bitcast<u32>(12i))) | _e1010);
                            }
                        }
                        phi_7869_ = true;
                    }
                    let _e4860 = phi_7869_;
                    phi_7870_ = _e4860;
                } else {
                    phi_7870_ = false;
                }
                let _e4862 = phi_7870_;
                continue;
                continuing {
                    phi_1842_ = _e999;
                    break if !(_e4862);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4866 = atomicLoad((&counters[5u]));
                if (_e4866 > 0u) {
                    let _e4869 = atomicAdd((&output.member[0u]), _e4866);
                    if ((_e4869 + _e4866) < _e4869) {
                        let _e4873 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4869);
                }
            }
            workgroupBarrier();
            let _e4876 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4879 = atomicLoad((&counters[7u]));
                if (_e4879 > 0u) {
                    let _e4882 = atomicAdd((&output.member[1u]), _e4879);
                    if ((_e4882 + _e4879) < _e4882) {
                        let _e4886 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7920_ = type_21(0u, 16u);
            loop {
                let _e4888 = phi_7920_;
                if (_e4888.member < _e4888.member_1) {
                    phi_7921_ = type_21((_e4888.member + 1u), _e4888.member_1);
                    phi_7944_ = type_21(1u, _e4888.member);
                } else {
                    phi_7921_ = _e4888;
                    phi_7944_ = type_21(0u, type_21().member_1);
                }
                let _e4900 = phi_7921_;
                let _e4902 = phi_7944_;
                if (bitcast<i32>(_e4902.member) != 0i) {
                    let _e4908 = (_e67 + (_e4902.member_1 * 128u));
                    if (_e4908 >= _e985) {
                        phi_8042_ = false;
                    } else {
                        let _e4911 = hits[_e4908];
                        if ((_e4911 & 2147483648u) == 0u) {
                            phi_7967_ = 4294967295u;
                        } else {
                            phi_7967_ = ((_e4911 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4918 = phi_7967_;
                        if (_e4918 != 4294967295u) {
                            let _e4922 = ((_e4911 >> bitcast<u32>(10i)) & 3u);
                            let _e4929 = firsts[(2u * _e4922)];
                            let _e4932 = leaves.member[(_e4929 + ((_e4911 >> bitcast<u32>(5i)) & 31u))];
                            let _e4936 = firsts[((2u * _e4922) + 1u)];
                            let _e4939 = leaves.member[(_e4936 + (_e4911 & 31u))];
                            let _e4943 = params.member.member_16;
                            let _e4944 = (_e4876 + _e4918);
                            if (_e4944 < _e4943) {
                                atomicStore((&output.member[(4u + (2u * _e4944))]), _e4932.member_1);
                                atomicStore((&output.member[((2u * _e4944) + 5u)]), _e4939.member_1);
                            }
                        }
                        phi_8042_ = true;
                    }
                    let _e4953 = phi_8042_;
                    phi_8043_ = _e4953;
                } else {
                    phi_8043_ = false;
                }
                let _e4955 = phi_8043_;
                continue;
                continuing {
                    phi_7920_ = _e4900;
                    break if !(_e4955);
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
fn filter_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
