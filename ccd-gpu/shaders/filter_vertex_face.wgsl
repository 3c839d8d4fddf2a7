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
    var phi_3992_: f32;
    var phi_3997_: f32;
    var phi_4002_: f32;
    var phi_4007_: f32;
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
    var phi_4063_: f32;
    var phi_4069_: f32;
    var phi_4076_: f32;
    var phi_4086_: f32;
    var phi_4157_: f32;
    var phi_4162_: f32;
    var phi_4167_: f32;
    var phi_4172_: f32;
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
    var phi_4228_: f32;
    var phi_4234_: f32;
    var phi_4241_: f32;
    var phi_4251_: f32;
    var phi_4261_: f32;
    var phi_4334_: f32;
    var phi_4339_: f32;
    var phi_4344_: f32;
    var phi_4349_: f32;
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
    var phi_4405_: f32;
    var phi_4411_: f32;
    var phi_4418_: f32;
    var phi_4428_: f32;
    var phi_4438_: f32;
    var phi_4441_: bool;
    var phi_4893_: f32;
    var phi_4900_: f32;
    var phi_4905_: f32;
    var phi_4912_: f32;
    var phi_4917_: f32;
    var phi_4930_: f32;
    var phi_4937_: f32;
    var phi_4942_: f32;
    var phi_4949_: f32;
    var phi_4954_: f32;
    var phi_4959_: f32;
    var phi_4976_: f32;
    var phi_4983_: f32;
    var phi_4988_: f32;
    var phi_4995_: f32;
    var phi_5000_: f32;
    var phi_5014_: f32;
    var phi_5021_: f32;
    var phi_5026_: f32;
    var phi_5033_: f32;
    var phi_5038_: f32;
    var phi_5043_: f32;
    var phi_5060_: f32;
    var phi_5067_: f32;
    var phi_5072_: f32;
    var phi_5079_: f32;
    var phi_5084_: f32;
    var phi_5098_: f32;
    var phi_5105_: f32;
    var phi_5110_: f32;
    var phi_5117_: f32;
    var phi_5122_: f32;
    var phi_5127_: f32;
    var phi_5158_: f32;
    var phi_5164_: f32;
    var phi_5171_: f32;
    var phi_5178_: f32;
    var phi_5184_: f32;
    var phi_5191_: f32;
    var phi_5197_: f32;
    var phi_5203_: f32;
    var phi_5209_: f32;
    var phi_5216_: f32;
    var phi_5223_: f32;
    var phi_5247_: f32;
    var phi_5252_: f32;
    var phi_5257_: f32;
    var phi_5262_: f32;
    var phi_5267_: f32;
    var phi_5272_: f32;
    var phi_5282_: f32;
    var phi_5485_: f32;
    var phi_5492_: f32;
    var phi_5497_: f32;
    var phi_5504_: f32;
    var phi_5509_: f32;
    var phi_5522_: f32;
    var phi_5529_: f32;
    var phi_5534_: f32;
    var phi_5541_: f32;
    var phi_5546_: f32;
    var phi_5551_: f32;
    var phi_5568_: f32;
    var phi_5575_: f32;
    var phi_5580_: f32;
    var phi_5587_: f32;
    var phi_5592_: f32;
    var phi_5606_: f32;
    var phi_5613_: f32;
    var phi_5618_: f32;
    var phi_5625_: f32;
    var phi_5630_: f32;
    var phi_5635_: f32;
    var phi_5652_: f32;
    var phi_5659_: f32;
    var phi_5664_: f32;
    var phi_5671_: f32;
    var phi_5676_: f32;
    var phi_5690_: f32;
    var phi_5697_: f32;
    var phi_5702_: f32;
    var phi_5709_: f32;
    var phi_5714_: f32;
    var phi_5719_: f32;
    var phi_5797_: f32;
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
    var phi_5868_: f32;
    var phi_5874_: f32;
    var phi_5881_: f32;
    var phi_5891_: f32;
    var phi_5962_: f32;
    var phi_5967_: f32;
    var phi_5972_: f32;
    var phi_5977_: f32;
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
    var phi_6033_: f32;
    var phi_6039_: f32;
    var phi_6046_: f32;
    var phi_6056_: f32;
    var phi_6066_: f32;
    var phi_6139_: f32;
    var phi_6144_: f32;
    var phi_6149_: f32;
    var phi_6154_: f32;
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
    var phi_6210_: f32;
    var phi_6216_: f32;
    var phi_6223_: f32;
    var phi_6233_: f32;
    var phi_6243_: f32;
    var phi_6246_: bool;
    var phi_6491_: f32;
    var phi_6498_: f32;
    var phi_6503_: f32;
    var phi_6510_: f32;
    var phi_6515_: f32;
    var phi_6528_: f32;
    var phi_6535_: f32;
    var phi_6540_: f32;
    var phi_6547_: f32;
    var phi_6552_: f32;
    var phi_6557_: f32;
    var phi_6574_: f32;
    var phi_6581_: f32;
    var phi_6586_: f32;
    var phi_6593_: f32;
    var phi_6598_: f32;
    var phi_6612_: f32;
    var phi_6619_: f32;
    var phi_6624_: f32;
    var phi_6631_: f32;
    var phi_6636_: f32;
    var phi_6641_: f32;
    var phi_6658_: f32;
    var phi_6665_: f32;
    var phi_6670_: f32;
    var phi_6677_: f32;
    var phi_6682_: f32;
    var phi_6696_: f32;
    var phi_6703_: f32;
    var phi_6708_: f32;
    var phi_6715_: f32;
    var phi_6720_: f32;
    var phi_6725_: f32;
    var phi_6756_: f32;
    var phi_6762_: f32;
    var phi_6769_: f32;
    var phi_6776_: f32;
    var phi_6782_: f32;
    var phi_6789_: f32;
    var phi_6795_: f32;
    var phi_6801_: f32;
    var phi_6807_: f32;
    var phi_6814_: f32;
    var phi_6821_: f32;
    var phi_6845_: f32;
    var phi_6850_: f32;
    var phi_6855_: f32;
    var phi_6860_: f32;
    var phi_6865_: f32;
    var phi_6870_: f32;
    var phi_6880_: f32;
    var phi_7083_: f32;
    var phi_7090_: f32;
    var phi_7095_: f32;
    var phi_7102_: f32;
    var phi_7107_: f32;
    var phi_7120_: f32;
    var phi_7127_: f32;
    var phi_7132_: f32;
    var phi_7139_: f32;
    var phi_7144_: f32;
    var phi_7149_: f32;
    var phi_7166_: f32;
    var phi_7173_: f32;
    var phi_7178_: f32;
    var phi_7185_: f32;
    var phi_7190_: f32;
    var phi_7204_: f32;
    var phi_7211_: f32;
    var phi_7216_: f32;
    var phi_7223_: f32;
    var phi_7228_: f32;
    var phi_7233_: f32;
    var phi_7250_: f32;
    var phi_7257_: f32;
    var phi_7262_: f32;
    var phi_7269_: f32;
    var phi_7274_: f32;
    var phi_7288_: f32;
    var phi_7295_: f32;
    var phi_7300_: f32;
    var phi_7307_: f32;
    var phi_7312_: f32;
    var phi_7317_: f32;
    var phi_7395_: f32;
    var phi_7400_: f32;
    var phi_7405_: f32;
    var phi_7410_: f32;
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
    var phi_7466_: f32;
    var phi_7472_: f32;
    var phi_7479_: f32;
    var phi_7489_: f32;
    var phi_7560_: f32;
    var phi_7565_: f32;
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
    var phi_7631_: f32;
    var phi_7637_: f32;
    var phi_7644_: f32;
    var phi_7654_: f32;
    var phi_7664_: f32;
    var phi_7737_: f32;
    var phi_7742_: f32;
    var phi_7747_: f32;
    var phi_7752_: f32;
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
    var phi_7808_: f32;
    var phi_7814_: f32;
    var phi_7821_: f32;
    var phi_7831_: f32;
    var phi_7841_: f32;
    var phi_7844_: bool;
    var phi_7845_: bool;
    var phi_7847_: bool;
    var phi_7857_: bool;
    var phi_7858_: bool;
    var phi_7908_: type_21;
    var phi_7909_: type_21;
    var phi_7932_: type_21;
    var phi_7955_: u32;
    var phi_8030_: bool;
    var phi_8031_: bool;
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
            let _e4974 = local_3;
            phi_924_ = _e4974;
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
                        phi_7857_ = false;
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
                            if ((_e2009 - ((((((_e1785 * 8f) * _e1895) * (0.000000059604645f * (490f / 64f))) + ((_e1902 * 19f) * ((_e1785 * (_e1839 + _e1893)) + (_e1839 * _e1893)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1785) * ((1f + _e1839) * (1f + _e1893))))) + ((_e1499 * (((_e1964 + (_e1895 * (0.000000059604645f * 4f))) + ((_e1969 * 6f) * (_e1839 + _e1893))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1839) * (1f + _e1893))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4441_ = true;
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
                                let _e2262 = (((_e2149 + _e2151) + (_e2203 + _e2205)) + (_e2257 + _e2259));
                                let _e2265 = local_2.member_3;
                                let _e2269 = (((_e1499 * 1.0001f) + (_e2265 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2272 = ((_e2047 * _e2026) - (_e2050 * _e2025));
                                let _e2275 = ((_e2050 * _e2024) - (_e2044 * _e2026));
                                let _e2278 = ((_e2044 * _e2025) - (_e2047 * _e2024));
                                let _e2283 = (((_e2272 * _e2053[0]) + (_e2275 * _e2053[1])) + (_e2278 * _e2053[2]));
                                let _e2288 = (((_e2272 * _e2069) + (_e2275 * _e2070)) + (_e2278 * _e2071));
                                let _e2293 = (((_e2272 * _e2072) + (_e2275 * _e2073)) + (_e2278 * _e2074));
                                let _e2298 = (((_e2272 * _e2053[0]) + (_e2275 * _e2053[1])) + (_e2278 * _e2053[2]));
                                let _e2303 = (((_e2272 * _e2077[0]) + (_e2275 * _e2077[1])) + (_e2278 * _e2077[2]));
                                let _e2308 = (((_e2272 * _e2093) + (_e2275 * _e2094)) + (_e2278 * _e2095));
                                let _e2313 = (((_e2272 * _e2096) + (_e2275 * _e2097)) + (_e2278 * _e2098));
                                let _e2318 = (((_e2272 * _e2077[0]) + (_e2275 * _e2077[1])) + (_e2278 * _e2077[2]));
                                if (_e2283 < _e2288) {
                                    phi_3992_ = _e2283;
                                } else {
                                    phi_3992_ = _e2288;
                                }
                                let _e2321 = phi_3992_;
                                if (_e2293 < _e2298) {
                                    phi_3997_ = _e2293;
                                } else {
                                    phi_3997_ = _e2298;
                                }
                                let _e2324 = phi_3997_;
                                if (_e2321 < _e2324) {
                                    phi_4002_ = _e2321;
                                } else {
                                    phi_4002_ = _e2324;
                                }
                                let _e2327 = phi_4002_;
                                if (_e2303 < _e2308) {
                                    phi_4007_ = _e2303;
                                } else {
                                    phi_4007_ = _e2308;
                                }
                                let _e2330 = phi_4007_;
                                if (_e2313 < _e2318) {
                                    phi_4012_ = _e2313;
                                } else {
                                    phi_4012_ = _e2318;
                                }
                                let _e2333 = phi_4012_;
                                if (_e2330 < _e2333) {
                                    phi_4017_ = _e2330;
                                } else {
                                    phi_4017_ = _e2333;
                                }
                                let _e2336 = phi_4017_;
                                if (_e2327 < _e2336) {
                                    phi_4022_ = _e2327;
                                } else {
                                    phi_4022_ = _e2336;
                                }
                                let _e2339 = phi_4022_;
                                if (_e2283 > _e2288) {
                                    phi_4027_ = _e2283;
                                } else {
                                    phi_4027_ = _e2288;
                                }
                                let _e2342 = phi_4027_;
                                if (_e2293 > _e2298) {
                                    phi_4032_ = _e2293;
                                } else {
                                    phi_4032_ = _e2298;
                                }
                                let _e2345 = phi_4032_;
                                if (_e2342 > _e2345) {
                                    phi_4037_ = _e2342;
                                } else {
                                    phi_4037_ = _e2345;
                                }
                                let _e2348 = phi_4037_;
                                if (_e2303 > _e2308) {
                                    phi_4042_ = _e2303;
                                } else {
                                    phi_4042_ = _e2308;
                                }
                                let _e2351 = phi_4042_;
                                if (_e2313 > _e2318) {
                                    phi_4047_ = _e2313;
                                } else {
                                    phi_4047_ = _e2318;
                                }
                                let _e2354 = phi_4047_;
                                if (_e2351 > _e2354) {
                                    phi_4052_ = _e2351;
                                } else {
                                    phi_4052_ = _e2354;
                                }
                                let _e2357 = phi_4052_;
                                if (_e2348 > _e2357) {
                                    phi_4057_ = _e2348;
                                } else {
                                    phi_4057_ = _e2357;
                                }
                                let _e2360 = phi_4057_;
                                if (_e2272 < 0f) {
                                    phi_4063_ = -(_e2272);
                                } else {
                                    phi_4063_ = _e2272;
                                }
                                let _e2364 = phi_4063_;
                                if (_e2275 < 0f) {
                                    phi_4069_ = -(_e2275);
                                } else {
                                    phi_4069_ = _e2275;
                                }
                                let _e2368 = phi_4069_;
                                if (_e2278 < 0f) {
                                    phi_4076_ = -(_e2278);
                                } else {
                                    phi_4076_ = _e2278;
                                }
                                let _e2373 = phi_4076_;
                                let _e2374 = ((_e2364 + _e2368) + _e2373);
                                let _e2378 = -(_e2360);
                                if (_e2339 > _e2378) {
                                    phi_4086_ = _e2339;
                                } else {
                                    phi_4086_ = _e2378;
                                }
                                let _e2381 = phi_4086_;
                                let _e2386 = (((_e2381 - ((_e2374 * _e2262) * (0.000000059604645f * 17f))) - (_e2374 * _e2269)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2389 = ((_e2047 * _e2041) - (_e2050 * _e2040));
                                let _e2392 = ((_e2050 * _e2039) - (_e2044 * _e2041));
                                let _e2395 = ((_e2044 * _e2040) - (_e2047 * _e2039));
                                let _e2400 = (((_e2389 * _e2053[0]) + (_e2392 * _e2053[1])) + (_e2395 * _e2053[2]));
                                let _e2405 = (((_e2389 * _e2069) + (_e2392 * _e2070)) + (_e2395 * _e2071));
                                let _e2410 = (((_e2389 * _e2072) + (_e2392 * _e2073)) + (_e2395 * _e2074));
                                let _e2415 = (((_e2389 * _e2053[0]) + (_e2392 * _e2053[1])) + (_e2395 * _e2053[2]));
                                let _e2420 = (((_e2389 * _e2077[0]) + (_e2392 * _e2077[1])) + (_e2395 * _e2077[2]));
                                let _e2425 = (((_e2389 * _e2093) + (_e2392 * _e2094)) + (_e2395 * _e2095));
                                let _e2430 = (((_e2389 * _e2096) + (_e2392 * _e2097)) + (_e2395 * _e2098));
                                let _e2435 = (((_e2389 * _e2077[0]) + (_e2392 * _e2077[1])) + (_e2395 * _e2077[2]));
                                if (_e2400 < _e2405) {
                                    phi_4157_ = _e2400;
                                } else {
                                    phi_4157_ = _e2405;
                                }
                                let _e2438 = phi_4157_;
                                if (_e2410 < _e2415) {
                                    phi_4162_ = _e2410;
                                } else {
                                    phi_4162_ = _e2415;
                                }
                                let _e2441 = phi_4162_;
                                if (_e2438 < _e2441) {
                                    phi_4167_ = _e2438;
                                } else {
                                    phi_4167_ = _e2441;
                                }
                                let _e2444 = phi_4167_;
                                if (_e2420 < _e2425) {
                                    phi_4172_ = _e2420;
                                } else {
                                    phi_4172_ = _e2425;
                                }
                                let _e2447 = phi_4172_;
                                if (_e2430 < _e2435) {
                                    phi_4177_ = _e2430;
                                } else {
                                    phi_4177_ = _e2435;
                                }
                                let _e2450 = phi_4177_;
                                if (_e2447 < _e2450) {
                                    phi_4182_ = _e2447;
                                } else {
                                    phi_4182_ = _e2450;
                                }
                                let _e2453 = phi_4182_;
                                if (_e2444 < _e2453) {
                                    phi_4187_ = _e2444;
                                } else {
                                    phi_4187_ = _e2453;
                                }
                                let _e2456 = phi_4187_;
                                if (_e2400 > _e2405) {
                                    phi_4192_ = _e2400;
                                } else {
                                    phi_4192_ = _e2405;
                                }
                                let _e2459 = phi_4192_;
                                if (_e2410 > _e2415) {
                                    phi_4197_ = _e2410;
                                } else {
                                    phi_4197_ = _e2415;
                                }
                                let _e2462 = phi_4197_;
                                if (_e2459 > _e2462) {
                                    phi_4202_ = _e2459;
                                } else {
                                    phi_4202_ = _e2462;
                                }
                                let _e2465 = phi_4202_;
                                if (_e2420 > _e2425) {
                                    phi_4207_ = _e2420;
                                } else {
                                    phi_4207_ = _e2425;
                                }
                                let _e2468 = phi_4207_;
                                if (_e2430 > _e2435) {
                                    phi_4212_ = _e2430;
                                } else {
                                    phi_4212_ = _e2435;
                                }
                                let _e2471 = phi_4212_;
                                if (_e2468 > _e2471) {
                                    phi_4217_ = _e2468;
                                } else {
                                    phi_4217_ = _e2471;
                                }
                                let _e2474 = phi_4217_;
                                if (_e2465 > _e2474) {
                                    phi_4222_ = _e2465;
                                } else {
                                    phi_4222_ = _e2474;
                                }
                                let _e2477 = phi_4222_;
                                if (_e2389 < 0f) {
                                    phi_4228_ = -(_e2389);
                                } else {
                                    phi_4228_ = _e2389;
                                }
                                let _e2481 = phi_4228_;
                                if (_e2392 < 0f) {
                                    phi_4234_ = -(_e2392);
                                } else {
                                    phi_4234_ = _e2392;
                                }
                                let _e2485 = phi_4234_;
                                if (_e2395 < 0f) {
                                    phi_4241_ = -(_e2395);
                                } else {
                                    phi_4241_ = _e2395;
                                }
                                let _e2490 = phi_4241_;
                                let _e2491 = ((_e2481 + _e2485) + _e2490);
                                let _e2495 = -(_e2477);
                                if (_e2456 > _e2495) {
                                    phi_4251_ = _e2456;
                                } else {
                                    phi_4251_ = _e2495;
                                }
                                let _e2498 = phi_4251_;
                                let _e2503 = (((_e2498 - ((_e2491 * _e2262) * (0.000000059604645f * 17f))) - (_e2491 * _e2269)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2386 > _e2503) {
                                    phi_4261_ = _e2386;
                                } else {
                                    phi_4261_ = _e2503;
                                }
                                let _e2506 = phi_4261_;
                                let _e2507 = (_e2039 - _e2024);
                                let _e2508 = (_e2040 - _e2025);
                                let _e2509 = (_e2041 - _e2026);
                                let _e2512 = ((_e2047 * _e2509) - (_e2050 * _e2508));
                                let _e2515 = ((_e2050 * _e2507) - (_e2044 * _e2509));
                                let _e2518 = ((_e2044 * _e2508) - (_e2047 * _e2507));
                                let _e2523 = (((_e2512 * _e2053[0]) + (_e2515 * _e2053[1])) + (_e2518 * _e2053[2]));
                                let _e2528 = (((_e2512 * _e2069) + (_e2515 * _e2070)) + (_e2518 * _e2071));
                                let _e2533 = (((_e2512 * _e2072) + (_e2515 * _e2073)) + (_e2518 * _e2074));
                                let _e2538 = (((_e2512 * _e2053[0]) + (_e2515 * _e2053[1])) + (_e2518 * _e2053[2]));
                                let _e2543 = (((_e2512 * _e2077[0]) + (_e2515 * _e2077[1])) + (_e2518 * _e2077[2]));
                                let _e2548 = (((_e2512 * _e2093) + (_e2515 * _e2094)) + (_e2518 * _e2095));
                                let _e2553 = (((_e2512 * _e2096) + (_e2515 * _e2097)) + (_e2518 * _e2098));
                                let _e2558 = (((_e2512 * _e2077[0]) + (_e2515 * _e2077[1])) + (_e2518 * _e2077[2]));
                                if (_e2523 < _e2528) {
                                    phi_4334_ = _e2523;
                                } else {
                                    phi_4334_ = _e2528;
                                }
                                let _e2561 = phi_4334_;
                                if (_e2533 < _e2538) {
                                    phi_4339_ = _e2533;
                                } else {
                                    phi_4339_ = _e2538;
                                }
                                let _e2564 = phi_4339_;
                                if (_e2561 < _e2564) {
                                    phi_4344_ = _e2561;
                                } else {
                                    phi_4344_ = _e2564;
                                }
                                let _e2567 = phi_4344_;
                                if (_e2543 < _e2548) {
                                    phi_4349_ = _e2543;
                                } else {
                                    phi_4349_ = _e2548;
                                }
                                let _e2570 = phi_4349_;
                                if (_e2553 < _e2558) {
                                    phi_4354_ = _e2553;
                                } else {
                                    phi_4354_ = _e2558;
                                }
                                let _e2573 = phi_4354_;
                                if (_e2570 < _e2573) {
                                    phi_4359_ = _e2570;
                                } else {
                                    phi_4359_ = _e2573;
                                }
                                let _e2576 = phi_4359_;
                                if (_e2567 < _e2576) {
                                    phi_4364_ = _e2567;
                                } else {
                                    phi_4364_ = _e2576;
                                }
                                let _e2579 = phi_4364_;
                                if (_e2523 > _e2528) {
                                    phi_4369_ = _e2523;
                                } else {
                                    phi_4369_ = _e2528;
                                }
                                let _e2582 = phi_4369_;
                                if (_e2533 > _e2538) {
                                    phi_4374_ = _e2533;
                                } else {
                                    phi_4374_ = _e2538;
                                }
                                let _e2585 = phi_4374_;
                                if (_e2582 > _e2585) {
                                    phi_4379_ = _e2582;
                                } else {
                                    phi_4379_ = _e2585;
                                }
                                let _e2588 = phi_4379_;
                                if (_e2543 > _e2548) {
                                    phi_4384_ = _e2543;
                                } else {
                                    phi_4384_ = _e2548;
                                }
                                let _e2591 = phi_4384_;
                                if (_e2553 > _e2558) {
                                    phi_4389_ = _e2553;
                                } else {
                                    phi_4389_ = _e2558;
                                }
                                let _e2594 = phi_4389_;
                                if (_e2591 > _e2594) {
                                    phi_4394_ = _e2591;
                                } else {
                                    phi_4394_ = _e2594;
                                }
                                let _e2597 = phi_4394_;
                                if (_e2588 > _e2597) {
                                    phi_4399_ = _e2588;
                                } else {
                                    phi_4399_ = _e2597;
                                }
                                let _e2600 = phi_4399_;
                                if (_e2512 < 0f) {
                                    phi_4405_ = -(_e2512);
                                } else {
                                    phi_4405_ = _e2512;
                                }
                                let _e2604 = phi_4405_;
                                if (_e2515 < 0f) {
                                    phi_4411_ = -(_e2515);
                                } else {
                                    phi_4411_ = _e2515;
                                }
                                let _e2608 = phi_4411_;
                                if (_e2518 < 0f) {
                                    phi_4418_ = -(_e2518);
                                } else {
                                    phi_4418_ = _e2518;
                                }
                                let _e2613 = phi_4418_;
                                let _e2614 = ((_e2604 + _e2608) + _e2613);
                                let _e2618 = -(_e2600);
                                if (_e2579 > _e2618) {
                                    phi_4428_ = _e2579;
                                } else {
                                    phi_4428_ = _e2618;
                                }
                                let _e2621 = phi_4428_;
                                let _e2626 = (((_e2621 - ((_e2614 * _e2262) * (0.000000059604645f * 17f))) - (_e2614 * _e2269)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2506 > _e2626) {
                                    phi_4438_ = _e2506;
                                } else {
                                    phi_4438_ = _e2626;
                                }
                                let _e2629 = phi_4438_;
                                phi_4441_ = (_e2629 > 0f);
                            }
                            let _e2632 = phi_4441_;
                            if _e2632 {
                                phi_7847_ = false;
                            } else {
                                let _e2635 = local_2.member[0u];
                                let _e2641 = local_2.member[1u];
                                let _e2648 = ((_e2635[0] + _e2641[0]) * 0.5f);
                                let _e2649 = ((_e2635[1] + _e2641[1]) * 0.5f);
                                let _e2650 = ((_e2635[2] + _e2641[2]) * 0.5f);
                                let _e2653 = local_2.member_1[0u];
                                let _e2659 = local_2.member_1[1u];
                                let _e2666 = ((_e2653[0] + _e2659[0]) * 0.5f);
                                let _e2667 = ((_e2653[1] + _e2659[1]) * 0.5f);
                                let _e2668 = ((_e2653[2] + _e2659[2]) * 0.5f);
                                let _e2671 = local_2.member_2[0u];
                                let _e2677 = local_2.member_2[1u];
                                let _e2684 = ((_e2671[0] + _e2677[0]) * 0.5f);
                                let _e2685 = ((_e2671[1] + _e2677[1]) * 0.5f);
                                let _e2686 = ((_e2671[2] + _e2677[2]) * 0.5f);
                                let _e2689 = local_2.member[0u];
                                let _e2692 = local_2.member_1[0u];
                                let _e2695 = local_2.member_2[0u];
                                let _e2697 = local_2.member_3;
                                let _e2700 = local_2.member[1u];
                                let _e2703 = local_2.member_1[1u];
                                let _e2706 = local_2.member_2[1u];
                                let _e2708 = local_2.member_3;
                                local = type_34(array<array<f32, 3>, 2>(_e2689, array<f32, 3>(_e2648, _e2649, _e2650)), array<array<f32, 3>, 2>(_e2692, array<f32, 3>(_e2666, _e2667, _e2668)), array<array<f32, 3>, 2>(_e2695, array<f32, 3>(_e2684, _e2685, _e2686)), _e2697);
                                local_1 = type_34(array<array<f32, 3>, 2>(array<f32, 3>(_e2648, _e2649, _e2650), _e2700), array<array<f32, 3>, 2>(array<f32, 3>(_e2666, _e2667, _e2668), _e2703), array<array<f32, 3>, 2>(array<f32, 3>(_e2684, _e2685, _e2686), _e2706), _e2708);
                                let _e2725 = local.member_1[0u];
                                let _e2731 = local.member_2[0u];
                                let _e2737 = ((_e2725[1] * _e2731[2]) - (_e2725[2] * _e2731[1]));
                                let _e2740 = ((_e2725[2] * _e2731[0]) - (_e2725[0] * _e2731[2]));
                                let _e2743 = ((_e2725[0] * _e2731[1]) - (_e2725[1] * _e2731[0]));
                                let _e2746 = local.member_1[1u];
                                let _e2752 = local.member_2[1u];
                                let _e2758 = ((_e2746[1] * _e2752[2]) - (_e2746[2] * _e2752[1]));
                                let _e2761 = ((_e2746[2] * _e2752[0]) - (_e2746[0] * _e2752[2]));
                                let _e2764 = ((_e2746[0] * _e2752[1]) - (_e2746[1] * _e2752[0]));
                                let _e2767 = local.member_1[0u];
                                let _e2773 = local.member_2[1u];
                                let _e2788 = local.member_1[1u];
                                let _e2794 = local.member_2[0u];
                                let _e2807 = (((_e2767[1] * _e2773[2]) - (_e2767[2] * _e2773[1])) + ((_e2788[1] * _e2794[2]) - (_e2788[2] * _e2794[1])));
                                let _e2808 = (((_e2767[2] * _e2773[0]) - (_e2767[0] * _e2773[2])) + ((_e2788[2] * _e2794[0]) - (_e2788[0] * _e2794[2])));
                                let _e2809 = (((_e2767[0] * _e2773[1]) - (_e2767[1] * _e2773[0])) + ((_e2788[0] * _e2794[1]) - (_e2788[1] * _e2794[0])));
                                let _e2812 = local.member[0u];
                                let _e2823 = local.member[1u];
                                let _e2834 = local.member[0u];
                                let _e2843 = ((((_e2823[0] * _e2737) + (_e2823[1] * _e2740)) + (_e2823[2] * _e2743)) + (((_e2834[0] * _e2807) + (_e2834[1] * _e2808)) + (_e2834[2] * _e2809)));
                                let _e2846 = local.member[0u];
                                let _e2857 = local.member[1u];
                                let _e2866 = ((((_e2846[0] * _e2758) + (_e2846[1] * _e2761)) + (_e2846[2] * _e2764)) + (((_e2857[0] * _e2807) + (_e2857[1] * _e2808)) + (_e2857[2] * _e2809)));
                                let _e2869 = local.member[1u];
                                let _e2880 = local.member[0u];
                                if (_e2880[0] < 0f) {
                                    phi_4893_ = -(_e2880[0]);
                                } else {
                                    phi_4893_ = _e2880[0];
                                }
                                let _e2887 = phi_4893_;
                                if (_e2880[1] < 0f) {
                                    phi_4900_ = -(_e2880[1]);
                                } else {
                                    phi_4900_ = _e2880[1];
                                }
                                let _e2891 = phi_4900_;
                                if (_e2887 > _e2891) {
                                    phi_4905_ = _e2887;
                                } else {
                                    phi_4905_ = _e2891;
                                }
                                let _e2894 = phi_4905_;
                                if (_e2880[2] < 0f) {
                                    phi_4912_ = -(_e2880[2]);
                                } else {
                                    phi_4912_ = _e2880[2];
                                }
                                let _e2898 = phi_4912_;
                                if (_e2894 > _e2898) {
                                    phi_4917_ = _e2894;
                                } else {
                                    phi_4917_ = _e2898;
                                }
                                let _e2901 = phi_4917_;
                                let _e2904 = local.member[1u];
                                if (_e2904[0] < 0f) {
                                    phi_4930_ = -(_e2904[0]);
                                } else {
                                    phi_4930_ = _e2904[0];
                                }
                                let _e2911 = phi_4930_;
                                if (_e2904[1] < 0f) {
                                    phi_4937_ = -(_e2904[1]);
                                } else {
                                    phi_4937_ = _e2904[1];
                                }
                                let _e2915 = phi_4937_;
                                if (_e2911 > _e2915) {
                                    phi_4942_ = _e2911;
                                } else {
                                    phi_4942_ = _e2915;
                                }
                                let _e2918 = phi_4942_;
                                if (_e2904[2] < 0f) {
                                    phi_4949_ = -(_e2904[2]);
                                } else {
                                    phi_4949_ = _e2904[2];
                                }
                                let _e2922 = phi_4949_;
                                if (_e2918 > _e2922) {
                                    phi_4954_ = _e2918;
                                } else {
                                    phi_4954_ = _e2922;
                                }
                                let _e2925 = phi_4954_;
                                if (_e2901 > _e2925) {
                                    phi_4959_ = _e2901;
                                } else {
                                    phi_4959_ = _e2925;
                                }
                                let _e2928 = phi_4959_;
                                let _e2930 = local.member_3;
                                let _e2931 = (_e2928 + _e2930);
                                let _e2934 = local.member_1[0u];
                                if (_e2934[0] < 0f) {
                                    phi_4976_ = -(_e2934[0]);
                                } else {
                                    phi_4976_ = _e2934[0];
                                }
                                let _e2941 = phi_4976_;
                                if (_e2934[1] < 0f) {
                                    phi_4983_ = -(_e2934[1]);
                                } else {
                                    phi_4983_ = _e2934[1];
                                }
                                let _e2945 = phi_4983_;
                                if (_e2941 > _e2945) {
                                    phi_4988_ = _e2941;
                                } else {
                                    phi_4988_ = _e2945;
                                }
                                let _e2948 = phi_4988_;
                                if (_e2934[2] < 0f) {
                                    phi_4995_ = -(_e2934[2]);
                                } else {
                                    phi_4995_ = _e2934[2];
                                }
                                let _e2952 = phi_4995_;
                                if (_e2948 > _e2952) {
                                    phi_5000_ = _e2948;
                                } else {
                                    phi_5000_ = _e2952;
                                }
                                let _e2955 = phi_5000_;
                                let _e2958 = local.member_1[1u];
                                if (_e2958[0] < 0f) {
                                    phi_5014_ = -(_e2958[0]);
                                } else {
                                    phi_5014_ = _e2958[0];
                                }
                                let _e2965 = phi_5014_;
                                if (_e2958[1] < 0f) {
                                    phi_5021_ = -(_e2958[1]);
                                } else {
                                    phi_5021_ = _e2958[1];
                                }
                                let _e2969 = phi_5021_;
                                if (_e2965 > _e2969) {
                                    phi_5026_ = _e2965;
                                } else {
                                    phi_5026_ = _e2969;
                                }
                                let _e2972 = phi_5026_;
                                if (_e2958[2] < 0f) {
                                    phi_5033_ = -(_e2958[2]);
                                } else {
                                    phi_5033_ = _e2958[2];
                                }
                                let _e2976 = phi_5033_;
                                if (_e2972 > _e2976) {
                                    phi_5038_ = _e2972;
                                } else {
                                    phi_5038_ = _e2976;
                                }
                                let _e2979 = phi_5038_;
                                if (_e2955 > _e2979) {
                                    phi_5043_ = _e2955;
                                } else {
                                    phi_5043_ = _e2979;
                                }
                                let _e2982 = phi_5043_;
                                let _e2984 = local.member_3;
                                let _e2985 = (_e2982 + _e2984);
                                let _e2988 = local.member_2[0u];
                                if (_e2988[0] < 0f) {
                                    phi_5060_ = -(_e2988[0]);
                                } else {
                                    phi_5060_ = _e2988[0];
                                }
                                let _e2995 = phi_5060_;
                                if (_e2988[1] < 0f) {
                                    phi_5067_ = -(_e2988[1]);
                                } else {
                                    phi_5067_ = _e2988[1];
                                }
                                let _e2999 = phi_5067_;
                                if (_e2995 > _e2999) {
                                    phi_5072_ = _e2995;
                                } else {
                                    phi_5072_ = _e2999;
                                }
                                let _e3002 = phi_5072_;
                                if (_e2988[2] < 0f) {
                                    phi_5079_ = -(_e2988[2]);
                                } else {
                                    phi_5079_ = _e2988[2];
                                }
                                let _e3006 = phi_5079_;
                                if (_e3002 > _e3006) {
                                    phi_5084_ = _e3002;
                                } else {
                                    phi_5084_ = _e3006;
                                }
                                let _e3009 = phi_5084_;
                                let _e3012 = local.member_2[1u];
                                if (_e3012[0] < 0f) {
                                    phi_5098_ = -(_e3012[0]);
                                } else {
                                    phi_5098_ = _e3012[0];
                                }
                                let _e3019 = phi_5098_;
                                if (_e3012[1] < 0f) {
                                    phi_5105_ = -(_e3012[1]);
                                } else {
                                    phi_5105_ = _e3012[1];
                                }
                                let _e3023 = phi_5105_;
                                if (_e3019 > _e3023) {
                                    phi_5110_ = _e3019;
                                } else {
                                    phi_5110_ = _e3023;
                                }
                                let _e3026 = phi_5110_;
                                if (_e3012[2] < 0f) {
                                    phi_5117_ = -(_e3012[2]);
                                } else {
                                    phi_5117_ = _e3012[2];
                                }
                                let _e3030 = phi_5117_;
                                if (_e3026 > _e3030) {
                                    phi_5122_ = _e3026;
                                } else {
                                    phi_5122_ = _e3030;
                                }
                                let _e3033 = phi_5122_;
                                if (_e3009 > _e3033) {
                                    phi_5127_ = _e3009;
                                } else {
                                    phi_5127_ = _e3033;
                                }
                                let _e3036 = phi_5127_;
                                let _e3038 = local.member_3;
                                let _e3039 = (_e3036 + _e3038);
                                let _e3041 = ((_e2985 * 8f) * _e3039);
                                let _e3048 = local.member_3;
                                if (_e2737 < 0f) {
                                    phi_5158_ = -(_e2737);
                                } else {
                                    phi_5158_ = _e2737;
                                }
                                let _e3065 = phi_5158_;
                                if (_e2740 < 0f) {
                                    phi_5164_ = -(_e2740);
                                } else {
                                    phi_5164_ = _e2740;
                                }
                                let _e3069 = phi_5164_;
                                if (_e2743 < 0f) {
                                    phi_5171_ = -(_e2743);
                                } else {
                                    phi_5171_ = _e2743;
                                }
                                let _e3074 = phi_5171_;
                                let _e3075 = ((_e3065 + _e3069) + _e3074);
                                if (_e2758 < 0f) {
                                    phi_5178_ = -(_e2758);
                                } else {
                                    phi_5178_ = _e2758;
                                }
                                let _e3079 = phi_5178_;
                                if (_e2761 < 0f) {
                                    phi_5184_ = -(_e2761);
                                } else {
                                    phi_5184_ = _e2761;
                                }
                                let _e3083 = phi_5184_;
                                if (_e2764 < 0f) {
                                    phi_5191_ = -(_e2764);
                                } else {
                                    phi_5191_ = _e2764;
                                }
                                let _e3088 = phi_5191_;
                                let _e3089 = ((_e3079 + _e3083) + _e3088);
                                if (_e3075 > _e3089) {
                                    phi_5197_ = _e3075;
                                } else {
                                    phi_5197_ = _e3089;
                                }
                                let _e3092 = phi_5197_;
                                if (_e2807 < 0f) {
                                    phi_5203_ = -(_e2807);
                                } else {
                                    phi_5203_ = _e2807;
                                }
                                let _e3096 = phi_5203_;
                                if (_e2808 < 0f) {
                                    phi_5209_ = -(_e2808);
                                } else {
                                    phi_5209_ = _e2808;
                                }
                                let _e3100 = phi_5209_;
                                if (_e2809 < 0f) {
                                    phi_5216_ = -(_e2809);
                                } else {
                                    phi_5216_ = _e2809;
                                }
                                let _e3105 = phi_5216_;
                                let _e3107 = (((_e3096 + _e3100) + _e3105) * 0.5f);
                                if (_e3092 > _e3107) {
                                    phi_5223_ = _e3092;
                                } else {
                                    phi_5223_ = _e3107;
                                }
                                let _e3110 = phi_5223_;
                                let _e3115 = local.member_3;
                                let _e3128 = ((((_e2812[0] * _e2737) + (_e2812[1] * _e2740)) + (_e2812[2] * _e2743)) * 3f);
                                let _e3129 = ((((_e2869[0] * _e2758) + (_e2869[1] * _e2761)) + (_e2869[2] * _e2764)) * 3f);
                                if (_e3128 < _e3129) {
                                    phi_5247_ = _e3128;
                                } else {
                                    phi_5247_ = _e3129;
                                }
                                let _e3132 = phi_5247_;
                                if (_e2843 < _e2866) {
                                    phi_5252_ = _e2843;
                                } else {
                                    phi_5252_ = _e2866;
                                }
                                let _e3135 = phi_5252_;
                                if (_e3132 < _e3135) {
                                    phi_5257_ = _e3132;
                                } else {
                                    phi_5257_ = _e3135;
                                }
                                let _e3138 = phi_5257_;
                                if (_e3128 > _e3129) {
                                    phi_5262_ = _e3128;
                                } else {
                                    phi_5262_ = _e3129;
                                }
                                let _e3141 = phi_5262_;
                                if (_e2843 > _e2866) {
                                    phi_5267_ = _e2843;
                                } else {
                                    phi_5267_ = _e2866;
                                }
                                let _e3144 = phi_5267_;
                                if (_e3141 > _e3144) {
                                    phi_5272_ = _e3141;
                                } else {
                                    phi_5272_ = _e3144;
                                }
                                let _e3147 = phi_5272_;
                                let _e3152 = -(_e3147);
                                if (_e3138 > _e3152) {
                                    phi_5282_ = _e3138;
                                } else {
                                    phi_5282_ = _e3152;
                                }
                                let _e3155 = phi_5282_;
                                if ((_e3155 - ((((((_e2931 * 8f) * _e3041) * (0.000000059604645f * (490f / 64f))) + ((_e3048 * 19f) * ((_e2931 * (_e2985 + _e3039)) + (_e2985 * _e3039)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2931) * ((1f + _e2985) * (1f + _e3039))))) + ((_e1499 * (((_e3110 + (_e3041 * (0.000000059604645f * 4f))) + ((_e3115 * 6f) * (_e2985 + _e3039))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2985) * (1f + _e3039))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6246_ = true;
                                } else {
                                    let _e3160 = local.member_1[0u];
                                    let _e3166 = local.member_1[1u];
                                    let _e3170 = (_e3160[0] + _e3166[0]);
                                    let _e3171 = (_e3160[1] + _e3166[1]);
                                    let _e3172 = (_e3160[2] + _e3166[2]);
                                    let _e3175 = local.member_2[0u];
                                    let _e3181 = local.member_2[1u];
                                    let _e3185 = (_e3175[0] + _e3181[0]);
                                    let _e3186 = (_e3175[1] + _e3181[1]);
                                    let _e3187 = (_e3175[2] + _e3181[2]);
                                    let _e3190 = ((_e3171 * _e3187) - (_e3172 * _e3186));
                                    let _e3193 = ((_e3172 * _e3185) - (_e3170 * _e3187));
                                    let _e3196 = ((_e3170 * _e3186) - (_e3171 * _e3185));
                                    let _e3199 = local.member[0u];
                                    let _e3205 = local.member_1[0u];
                                    let _e3211 = local.member_2[0u];
                                    let _e3215 = (_e3199[0] - _e3205[0]);
                                    let _e3216 = (_e3199[1] - _e3205[1]);
                                    let _e3217 = (_e3199[2] - _e3205[2]);
                                    let _e3218 = (_e3199[0] - _e3211[0]);
                                    let _e3219 = (_e3199[1] - _e3211[1]);
                                    let _e3220 = (_e3199[2] - _e3211[2]);
                                    let _e3223 = local.member[1u];
                                    let _e3229 = local.member_1[1u];
                                    let _e3235 = local.member_2[1u];
                                    let _e3239 = (_e3223[0] - _e3229[0]);
                                    let _e3240 = (_e3223[1] - _e3229[1]);
                                    let _e3241 = (_e3223[2] - _e3229[2]);
                                    let _e3242 = (_e3223[0] - _e3235[0]);
                                    let _e3243 = (_e3223[1] - _e3235[1]);
                                    let _e3244 = (_e3223[2] - _e3235[2]);
                                    let _e3247 = local.member[0u];
                                    if (_e3247[0] < 0f) {
                                        phi_5485_ = -(_e3247[0]);
                                    } else {
                                        phi_5485_ = _e3247[0];
                                    }
                                    let _e3254 = phi_5485_;
                                    if (_e3247[1] < 0f) {
                                        phi_5492_ = -(_e3247[1]);
                                    } else {
                                        phi_5492_ = _e3247[1];
                                    }
                                    let _e3258 = phi_5492_;
                                    if (_e3254 > _e3258) {
                                        phi_5497_ = _e3254;
                                    } else {
                                        phi_5497_ = _e3258;
                                    }
                                    let _e3261 = phi_5497_;
                                    if (_e3247[2] < 0f) {
                                        phi_5504_ = -(_e3247[2]);
                                    } else {
                                        phi_5504_ = _e3247[2];
                                    }
                                    let _e3265 = phi_5504_;
                                    if (_e3261 > _e3265) {
                                        phi_5509_ = _e3261;
                                    } else {
                                        phi_5509_ = _e3265;
                                    }
                                    let _e3268 = phi_5509_;
                                    let _e3271 = local.member[1u];
                                    if (_e3271[0] < 0f) {
                                        phi_5522_ = -(_e3271[0]);
                                    } else {
                                        phi_5522_ = _e3271[0];
                                    }
                                    let _e3278 = phi_5522_;
                                    if (_e3271[1] < 0f) {
                                        phi_5529_ = -(_e3271[1]);
                                    } else {
                                        phi_5529_ = _e3271[1];
                                    }
                                    let _e3282 = phi_5529_;
                                    if (_e3278 > _e3282) {
                                        phi_5534_ = _e3278;
                                    } else {
                                        phi_5534_ = _e3282;
                                    }
                                    let _e3285 = phi_5534_;
                                    if (_e3271[2] < 0f) {
                                        phi_5541_ = -(_e3271[2]);
                                    } else {
                                        phi_5541_ = _e3271[2];
                                    }
                                    let _e3289 = phi_5541_;
                                    if (_e3285 > _e3289) {
                                        phi_5546_ = _e3285;
                                    } else {
                                        phi_5546_ = _e3289;
                                    }
                                    let _e3292 = phi_5546_;
                                    if (_e3268 > _e3292) {
                                        phi_5551_ = _e3268;
                                    } else {
                                        phi_5551_ = _e3292;
                                    }
                                    let _e3295 = phi_5551_;
                                    let _e3297 = local.member_3;
                                    let _e3301 = local.member_1[0u];
                                    if (_e3301[0] < 0f) {
                                        phi_5568_ = -(_e3301[0]);
                                    } else {
                                        phi_5568_ = _e3301[0];
                                    }
                                    let _e3308 = phi_5568_;
                                    if (_e3301[1] < 0f) {
                                        phi_5575_ = -(_e3301[1]);
                                    } else {
                                        phi_5575_ = _e3301[1];
                                    }
                                    let _e3312 = phi_5575_;
                                    if (_e3308 > _e3312) {
                                        phi_5580_ = _e3308;
                                    } else {
                                        phi_5580_ = _e3312;
                                    }
                                    let _e3315 = phi_5580_;
                                    if (_e3301[2] < 0f) {
                                        phi_5587_ = -(_e3301[2]);
                                    } else {
                                        phi_5587_ = _e3301[2];
                                    }
                                    let _e3319 = phi_5587_;
                                    if (_e3315 > _e3319) {
                                        phi_5592_ = _e3315;
                                    } else {
                                        phi_5592_ = _e3319;
                                    }
                                    let _e3322 = phi_5592_;
                                    let _e3325 = local.member_1[1u];
                                    if (_e3325[0] < 0f) {
                                        phi_5606_ = -(_e3325[0]);
                                    } else {
                                        phi_5606_ = _e3325[0];
                                    }
                                    let _e3332 = phi_5606_;
                                    if (_e3325[1] < 0f) {
                                        phi_5613_ = -(_e3325[1]);
                                    } else {
                                        phi_5613_ = _e3325[1];
                                    }
                                    let _e3336 = phi_5613_;
                                    if (_e3332 > _e3336) {
                                        phi_5618_ = _e3332;
                                    } else {
                                        phi_5618_ = _e3336;
                                    }
                                    let _e3339 = phi_5618_;
                                    if (_e3325[2] < 0f) {
                                        phi_5625_ = -(_e3325[2]);
                                    } else {
                                        phi_5625_ = _e3325[2];
                                    }
                                    let _e3343 = phi_5625_;
                                    if (_e3339 > _e3343) {
                                        phi_5630_ = _e3339;
                                    } else {
                                        phi_5630_ = _e3343;
                                    }
                                    let _e3346 = phi_5630_;
                                    if (_e3322 > _e3346) {
                                        phi_5635_ = _e3322;
                                    } else {
                                        phi_5635_ = _e3346;
                                    }
                                    let _e3349 = phi_5635_;
                                    let _e3351 = local.member_3;
                                    let _e3355 = local.member_2[0u];
                                    if (_e3355[0] < 0f) {
                                        phi_5652_ = -(_e3355[0]);
                                    } else {
                                        phi_5652_ = _e3355[0];
                                    }
                                    let _e3362 = phi_5652_;
                                    if (_e3355[1] < 0f) {
                                        phi_5659_ = -(_e3355[1]);
                                    } else {
                                        phi_5659_ = _e3355[1];
                                    }
                                    let _e3366 = phi_5659_;
                                    if (_e3362 > _e3366) {
                                        phi_5664_ = _e3362;
                                    } else {
                                        phi_5664_ = _e3366;
                                    }
                                    let _e3369 = phi_5664_;
                                    if (_e3355[2] < 0f) {
                                        phi_5671_ = -(_e3355[2]);
                                    } else {
                                        phi_5671_ = _e3355[2];
                                    }
                                    let _e3373 = phi_5671_;
                                    if (_e3369 > _e3373) {
                                        phi_5676_ = _e3369;
                                    } else {
                                        phi_5676_ = _e3373;
                                    }
                                    let _e3376 = phi_5676_;
                                    let _e3379 = local.member_2[1u];
                                    if (_e3379[0] < 0f) {
                                        phi_5690_ = -(_e3379[0]);
                                    } else {
                                        phi_5690_ = _e3379[0];
                                    }
                                    let _e3386 = phi_5690_;
                                    if (_e3379[1] < 0f) {
                                        phi_5697_ = -(_e3379[1]);
                                    } else {
                                        phi_5697_ = _e3379[1];
                                    }
                                    let _e3390 = phi_5697_;
                                    if (_e3386 > _e3390) {
                                        phi_5702_ = _e3386;
                                    } else {
                                        phi_5702_ = _e3390;
                                    }
                                    let _e3393 = phi_5702_;
                                    if (_e3379[2] < 0f) {
                                        phi_5709_ = -(_e3379[2]);
                                    } else {
                                        phi_5709_ = _e3379[2];
                                    }
                                    let _e3397 = phi_5709_;
                                    if (_e3393 > _e3397) {
                                        phi_5714_ = _e3393;
                                    } else {
                                        phi_5714_ = _e3397;
                                    }
                                    let _e3400 = phi_5714_;
                                    if (_e3376 > _e3400) {
                                        phi_5719_ = _e3376;
                                    } else {
                                        phi_5719_ = _e3400;
                                    }
                                    let _e3403 = phi_5719_;
                                    let _e3405 = local.member_3;
                                    let _e3408 = (((_e3295 + _e3297) + (_e3349 + _e3351)) + (_e3403 + _e3405));
                                    let _e3411 = local.member_3;
                                    let _e3415 = (((_e1499 * 1.0001f) + (_e3411 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3418 = ((_e3193 * _e3172) - (_e3196 * _e3171));
                                    let _e3421 = ((_e3196 * _e3170) - (_e3190 * _e3172));
                                    let _e3424 = ((_e3190 * _e3171) - (_e3193 * _e3170));
                                    let _e3429 = (((_e3418 * _e3199[0]) + (_e3421 * _e3199[1])) + (_e3424 * _e3199[2]));
                                    let _e3434 = (((_e3418 * _e3215) + (_e3421 * _e3216)) + (_e3424 * _e3217));
                                    let _e3439 = (((_e3418 * _e3218) + (_e3421 * _e3219)) + (_e3424 * _e3220));
                                    let _e3444 = (((_e3418 * _e3199[0]) + (_e3421 * _e3199[1])) + (_e3424 * _e3199[2]));
                                    let _e3449 = (((_e3418 * _e3223[0]) + (_e3421 * _e3223[1])) + (_e3424 * _e3223[2]));
                                    let _e3454 = (((_e3418 * _e3239) + (_e3421 * _e3240)) + (_e3424 * _e3241));
                                    let _e3459 = (((_e3418 * _e3242) + (_e3421 * _e3243)) + (_e3424 * _e3244));
                                    let _e3464 = (((_e3418 * _e3223[0]) + (_e3421 * _e3223[1])) + (_e3424 * _e3223[2]));
                                    if (_e3429 < _e3434) {
                                        phi_5797_ = _e3429;
                                    } else {
                                        phi_5797_ = _e3434;
                                    }
                                    let _e3467 = phi_5797_;
                                    if (_e3439 < _e3444) {
                                        phi_5802_ = _e3439;
                                    } else {
                                        phi_5802_ = _e3444;
                                    }
                                    let _e3470 = phi_5802_;
                                    if (_e3467 < _e3470) {
                                        phi_5807_ = _e3467;
                                    } else {
                                        phi_5807_ = _e3470;
                                    }
                                    let _e3473 = phi_5807_;
                                    if (_e3449 < _e3454) {
                                        phi_5812_ = _e3449;
                                    } else {
                                        phi_5812_ = _e3454;
                                    }
                                    let _e3476 = phi_5812_;
                                    if (_e3459 < _e3464) {
                                        phi_5817_ = _e3459;
                                    } else {
                                        phi_5817_ = _e3464;
                                    }
                                    let _e3479 = phi_5817_;
                                    if (_e3476 < _e3479) {
                                        phi_5822_ = _e3476;
                                    } else {
                                        phi_5822_ = _e3479;
                                    }
                                    let _e3482 = phi_5822_;
                                    if (_e3473 < _e3482) {
                                        phi_5827_ = _e3473;
                                    } else {
                                        phi_5827_ = _e3482;
                                    }
                                    let _e3485 = phi_5827_;
                                    if (_e3429 > _e3434) {
                                        phi_5832_ = _e3429;
                                    } else {
                                        phi_5832_ = _e3434;
                                    }
                                    let _e3488 = phi_5832_;
                                    if (_e3439 > _e3444) {
                                        phi_5837_ = _e3439;
                                    } else {
                                        phi_5837_ = _e3444;
                                    }
                                    let _e3491 = phi_5837_;
                                    if (_e3488 > _e3491) {
                                        phi_5842_ = _e3488;
                                    } else {
                                        phi_5842_ = _e3491;
                                    }
                                    let _e3494 = phi_5842_;
                                    if (_e3449 > _e3454) {
                                        phi_5847_ = _e3449;
                                    } else {
                                        phi_5847_ = _e3454;
                                    }
                                    let _e3497 = phi_5847_;
                                    if (_e3459 > _e3464) {
                                        phi_5852_ = _e3459;
                                    } else {
                                        phi_5852_ = _e3464;
                                    }
                                    let _e3500 = phi_5852_;
                                    if (_e3497 > _e3500) {
                                        phi_5857_ = _e3497;
                                    } else {
                                        phi_5857_ = _e3500;
                                    }
                                    let _e3503 = phi_5857_;
                                    if (_e3494 > _e3503) {
                                        phi_5862_ = _e3494;
                                    } else {
                                        phi_5862_ = _e3503;
                                    }
                                    let _e3506 = phi_5862_;
                                    if (_e3418 < 0f) {
                                        phi_5868_ = -(_e3418);
                                    } else {
                                        phi_5868_ = _e3418;
                                    }
                                    let _e3510 = phi_5868_;
                                    if (_e3421 < 0f) {
                                        phi_5874_ = -(_e3421);
                                    } else {
                                        phi_5874_ = _e3421;
                                    }
                                    let _e3514 = phi_5874_;
                                    if (_e3424 < 0f) {
                                        phi_5881_ = -(_e3424);
                                    } else {
                                        phi_5881_ = _e3424;
                                    }
                                    let _e3519 = phi_5881_;
                                    let _e3520 = ((_e3510 + _e3514) + _e3519);
                                    let _e3524 = -(_e3506);
                                    if (_e3485 > _e3524) {
                                        phi_5891_ = _e3485;
                                    } else {
                                        phi_5891_ = _e3524;
                                    }
                                    let _e3527 = phi_5891_;
                                    let _e3532 = (((_e3527 - ((_e3520 * _e3408) * (0.000000059604645f * 17f))) - (_e3520 * _e3415)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3535 = ((_e3193 * _e3187) - (_e3196 * _e3186));
                                    let _e3538 = ((_e3196 * _e3185) - (_e3190 * _e3187));
                                    let _e3541 = ((_e3190 * _e3186) - (_e3193 * _e3185));
                                    let _e3546 = (((_e3535 * _e3199[0]) + (_e3538 * _e3199[1])) + (_e3541 * _e3199[2]));
                                    let _e3551 = (((_e3535 * _e3215) + (_e3538 * _e3216)) + (_e3541 * _e3217));
                                    let _e3556 = (((_e3535 * _e3218) + (_e3538 * _e3219)) + (_e3541 * _e3220));
                                    let _e3561 = (((_e3535 * _e3199[0]) + (_e3538 * _e3199[1])) + (_e3541 * _e3199[2]));
                                    let _e3566 = (((_e3535 * _e3223[0]) + (_e3538 * _e3223[1])) + (_e3541 * _e3223[2]));
                                    let _e3571 = (((_e3535 * _e3239) + (_e3538 * _e3240)) + (_e3541 * _e3241));
                                    let _e3576 = (((_e3535 * _e3242) + (_e3538 * _e3243)) + (_e3541 * _e3244));
                                    let _e3581 = (((_e3535 * _e3223[0]) + (_e3538 * _e3223[1])) + (_e3541 * _e3223[2]));
                                    if (_e3546 < _e3551) {
                                        phi_5962_ = _e3546;
                                    } else {
                                        phi_5962_ = _e3551;
                                    }
                                    let _e3584 = phi_5962_;
                                    if (_e3556 < _e3561) {
                                        phi_5967_ = _e3556;
                                    } else {
                                        phi_5967_ = _e3561;
                                    }
                                    let _e3587 = phi_5967_;
                                    if (_e3584 < _e3587) {
                                        phi_5972_ = _e3584;
                                    } else {
                                        phi_5972_ = _e3587;
                                    }
                                    let _e3590 = phi_5972_;
                                    if (_e3566 < _e3571) {
                                        phi_5977_ = _e3566;
                                    } else {
                                        phi_5977_ = _e3571;
                                    }
                                    let _e3593 = phi_5977_;
                                    if (_e3576 < _e3581) {
                                        phi_5982_ = _e3576;
                                    } else {
                                        phi_5982_ = _e3581;
                                    }
                                    let _e3596 = phi_5982_;
                                    if (_e3593 < _e3596) {
                                        phi_5987_ = _e3593;
                                    } else {
                                        phi_5987_ = _e3596;
                                    }
                                    let _e3599 = phi_5987_;
                                    if (_e3590 < _e3599) {
                                        phi_5992_ = _e3590;
                                    } else {
                                        phi_5992_ = _e3599;
                                    }
                                    let _e3602 = phi_5992_;
                                    if (_e3546 > _e3551) {
                                        phi_5997_ = _e3546;
                                    } else {
                                        phi_5997_ = _e3551;
                                    }
                                    let _e3605 = phi_5997_;
                                    if (_e3556 > _e3561) {
                                        phi_6002_ = _e3556;
                                    } else {
                                        phi_6002_ = _e3561;
                                    }
                                    let _e3608 = phi_6002_;
                                    if (_e3605 > _e3608) {
                                        phi_6007_ = _e3605;
                                    } else {
                                        phi_6007_ = _e3608;
                                    }
                                    let _e3611 = phi_6007_;
                                    if (_e3566 > _e3571) {
                                        phi_6012_ = _e3566;
                                    } else {
                                        phi_6012_ = _e3571;
                                    }
                                    let _e3614 = phi_6012_;
                                    if (_e3576 > _e3581) {
                                        phi_6017_ = _e3576;
                                    } else {
                                        phi_6017_ = _e3581;
                                    }
                                    let _e3617 = phi_6017_;
                                    if (_e3614 > _e3617) {
                                        phi_6022_ = _e3614;
                                    } else {
                                        phi_6022_ = _e3617;
                                    }
                                    let _e3620 = phi_6022_;
                                    if (_e3611 > _e3620) {
                                        phi_6027_ = _e3611;
                                    } else {
                                        phi_6027_ = _e3620;
                                    }
                                    let _e3623 = phi_6027_;
                                    if (_e3535 < 0f) {
                                        phi_6033_ = -(_e3535);
                                    } else {
                                        phi_6033_ = _e3535;
                                    }
                                    let _e3627 = phi_6033_;
                                    if (_e3538 < 0f) {
                                        phi_6039_ = -(_e3538);
                                    } else {
                                        phi_6039_ = _e3538;
                                    }
                                    let _e3631 = phi_6039_;
                                    if (_e3541 < 0f) {
                                        phi_6046_ = -(_e3541);
                                    } else {
                                        phi_6046_ = _e3541;
                                    }
                                    let _e3636 = phi_6046_;
                                    let _e3637 = ((_e3627 + _e3631) + _e3636);
                                    let _e3641 = -(_e3623);
                                    if (_e3602 > _e3641) {
                                        phi_6056_ = _e3602;
                                    } else {
                                        phi_6056_ = _e3641;
                                    }
                                    let _e3644 = phi_6056_;
                                    let _e3649 = (((_e3644 - ((_e3637 * _e3408) * (0.000000059604645f * 17f))) - (_e3637 * _e3415)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3532 > _e3649) {
                                        phi_6066_ = _e3532;
                                    } else {
                                        phi_6066_ = _e3649;
                                    }
                                    let _e3652 = phi_6066_;
                                    let _e3653 = (_e3185 - _e3170);
                                    let _e3654 = (_e3186 - _e3171);
                                    let _e3655 = (_e3187 - _e3172);
                                    let _e3658 = ((_e3193 * _e3655) - (_e3196 * _e3654));
                                    let _e3661 = ((_e3196 * _e3653) - (_e3190 * _e3655));
                                    let _e3664 = ((_e3190 * _e3654) - (_e3193 * _e3653));
                                    let _e3669 = (((_e3658 * _e3199[0]) + (_e3661 * _e3199[1])) + (_e3664 * _e3199[2]));
                                    let _e3674 = (((_e3658 * _e3215) + (_e3661 * _e3216)) + (_e3664 * _e3217));
                                    let _e3679 = (((_e3658 * _e3218) + (_e3661 * _e3219)) + (_e3664 * _e3220));
                                    let _e3684 = (((_e3658 * _e3199[0]) + (_e3661 * _e3199[1])) + (_e3664 * _e3199[2]));
                                    let _e3689 = (((_e3658 * _e3223[0]) + (_e3661 * _e3223[1])) + (_e3664 * _e3223[2]));
                                    let _e3694 = (((_e3658 * _e3239) + (_e3661 * _e3240)) + (_e3664 * _e3241));
                                    let _e3699 = (((_e3658 * _e3242) + (_e3661 * _e3243)) + (_e3664 * _e3244));
                                    let _e3704 = (((_e3658 * _e3223[0]) + (_e3661 * _e3223[1])) + (_e3664 * _e3223[2]));
                                    if (_e3669 < _e3674) {
                                        phi_6139_ = _e3669;
                                    } else {
                                        phi_6139_ = _e3674;
                                    }
                                    let _e3707 = phi_6139_;
                                    if (_e3679 < _e3684) {
                                        phi_6144_ = _e3679;
                                    } else {
                                        phi_6144_ = _e3684;
                                    }
                                    let _e3710 = phi_6144_;
                                    if (_e3707 < _e3710) {
                                        phi_6149_ = _e3707;
                                    } else {
                                        phi_6149_ = _e3710;
                                    }
                                    let _e3713 = phi_6149_;
                                    if (_e3689 < _e3694) {
                                        phi_6154_ = _e3689;
                                    } else {
                                        phi_6154_ = _e3694;
                                    }
                                    let _e3716 = phi_6154_;
                                    if (_e3699 < _e3704) {
                                        phi_6159_ = _e3699;
                                    } else {
                                        phi_6159_ = _e3704;
                                    }
                                    let _e3719 = phi_6159_;
                                    if (_e3716 < _e3719) {
                                        phi_6164_ = _e3716;
                                    } else {
                                        phi_6164_ = _e3719;
                                    }
                                    let _e3722 = phi_6164_;
                                    if (_e3713 < _e3722) {
                                        phi_6169_ = _e3713;
                                    } else {
                                        phi_6169_ = _e3722;
                                    }
                                    let _e3725 = phi_6169_;
                                    if (_e3669 > _e3674) {
                                        phi_6174_ = _e3669;
                                    } else {
                                        phi_6174_ = _e3674;
                                    }
                                    let _e3728 = phi_6174_;
                                    if (_e3679 > _e3684) {
                                        phi_6179_ = _e3679;
                                    } else {
                                        phi_6179_ = _e3684;
                                    }
                                    let _e3731 = phi_6179_;
                                    if (_e3728 > _e3731) {
                                        phi_6184_ = _e3728;
                                    } else {
                                        phi_6184_ = _e3731;
                                    }
                                    let _e3734 = phi_6184_;
                                    if (_e3689 > _e3694) {
                                        phi_6189_ = _e3689;
                                    } else {
                                        phi_6189_ = _e3694;
                                    }
                                    let _e3737 = phi_6189_;
                                    if (_e3699 > _e3704) {
                                        phi_6194_ = _e3699;
                                    } else {
                                        phi_6194_ = _e3704;
                                    }
                                    let _e3740 = phi_6194_;
                                    if (_e3737 > _e3740) {
                                        phi_6199_ = _e3737;
                                    } else {
                                        phi_6199_ = _e3740;
                                    }
                                    let _e3743 = phi_6199_;
                                    if (_e3734 > _e3743) {
                                        phi_6204_ = _e3734;
                                    } else {
                                        phi_6204_ = _e3743;
                                    }
                                    let _e3746 = phi_6204_;
                                    if (_e3658 < 0f) {
                                        phi_6210_ = -(_e3658);
                                    } else {
                                        phi_6210_ = _e3658;
                                    }
                                    let _e3750 = phi_6210_;
                                    if (_e3661 < 0f) {
                                        phi_6216_ = -(_e3661);
                                    } else {
                                        phi_6216_ = _e3661;
                                    }
                                    let _e3754 = phi_6216_;
                                    if (_e3664 < 0f) {
                                        phi_6223_ = -(_e3664);
                                    } else {
                                        phi_6223_ = _e3664;
                                    }
                                    let _e3759 = phi_6223_;
                                    let _e3760 = ((_e3750 + _e3754) + _e3759);
                                    let _e3764 = -(_e3746);
                                    if (_e3725 > _e3764) {
                                        phi_6233_ = _e3725;
                                    } else {
                                        phi_6233_ = _e3764;
                                    }
                                    let _e3767 = phi_6233_;
                                    let _e3772 = (((_e3767 - ((_e3760 * _e3408) * (0.000000059604645f * 17f))) - (_e3760 * _e3415)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3652 > _e3772) {
                                        phi_6243_ = _e3652;
                                    } else {
                                        phi_6243_ = _e3772;
                                    }
                                    let _e3775 = phi_6243_;
                                    phi_6246_ = (_e3775 > 0f);
                                }
                                let _e3778 = phi_6246_;
                                if _e3778 {
                                    let _e3781 = local_1.member_1[0u];
                                    let _e3787 = local_1.member_2[0u];
                                    let _e3793 = ((_e3781[1] * _e3787[2]) - (_e3781[2] * _e3787[1]));
                                    let _e3796 = ((_e3781[2] * _e3787[0]) - (_e3781[0] * _e3787[2]));
                                    let _e3799 = ((_e3781[0] * _e3787[1]) - (_e3781[1] * _e3787[0]));
                                    let _e3802 = local_1.member_1[1u];
                                    let _e3808 = local_1.member_2[1u];
                                    let _e3814 = ((_e3802[1] * _e3808[2]) - (_e3802[2] * _e3808[1]));
                                    let _e3817 = ((_e3802[2] * _e3808[0]) - (_e3802[0] * _e3808[2]));
                                    let _e3820 = ((_e3802[0] * _e3808[1]) - (_e3802[1] * _e3808[0]));
                                    let _e3823 = local_1.member_1[0u];
                                    let _e3829 = local_1.member_2[1u];
                                    let _e3844 = local_1.member_1[1u];
                                    let _e3850 = local_1.member_2[0u];
                                    let _e3863 = (((_e3823[1] * _e3829[2]) - (_e3823[2] * _e3829[1])) + ((_e3844[1] * _e3850[2]) - (_e3844[2] * _e3850[1])));
                                    let _e3864 = (((_e3823[2] * _e3829[0]) - (_e3823[0] * _e3829[2])) + ((_e3844[2] * _e3850[0]) - (_e3844[0] * _e3850[2])));
                                    let _e3865 = (((_e3823[0] * _e3829[1]) - (_e3823[1] * _e3829[0])) + ((_e3844[0] * _e3850[1]) - (_e3844[1] * _e3850[0])));
                                    let _e3868 = local_1.member[0u];
                                    let _e3879 = local_1.member[1u];
                                    let _e3890 = local_1.member[0u];
                                    let _e3899 = ((((_e3879[0] * _e3793) + (_e3879[1] * _e3796)) + (_e3879[2] * _e3799)) + (((_e3890[0] * _e3863) + (_e3890[1] * _e3864)) + (_e3890[2] * _e3865)));
                                    let _e3902 = local_1.member[0u];
                                    let _e3913 = local_1.member[1u];
                                    let _e3922 = ((((_e3902[0] * _e3814) + (_e3902[1] * _e3817)) + (_e3902[2] * _e3820)) + (((_e3913[0] * _e3863) + (_e3913[1] * _e3864)) + (_e3913[2] * _e3865)));
                                    let _e3925 = local_1.member[1u];
                                    let _e3936 = local_1.member[0u];
                                    if (_e3936[0] < 0f) {
                                        phi_6491_ = -(_e3936[0]);
                                    } else {
                                        phi_6491_ = _e3936[0];
                                    }
                                    let _e3943 = phi_6491_;
                                    if (_e3936[1] < 0f) {
                                        phi_6498_ = -(_e3936[1]);
                                    } else {
                                        phi_6498_ = _e3936[1];
                                    }
                                    let _e3947 = phi_6498_;
                                    if (_e3943 > _e3947) {
                                        phi_6503_ = _e3943;
                                    } else {
                                        phi_6503_ = _e3947;
                                    }
                                    let _e3950 = phi_6503_;
                                    if (_e3936[2] < 0f) {
                                        phi_6510_ = -(_e3936[2]);
                                    } else {
                                        phi_6510_ = _e3936[2];
                                    }
                                    let _e3954 = phi_6510_;
                                    if (_e3950 > _e3954) {
                                        phi_6515_ = _e3950;
                                    } else {
                                        phi_6515_ = _e3954;
                                    }
                                    let _e3957 = phi_6515_;
                                    let _e3960 = local_1.member[1u];
                                    if (_e3960[0] < 0f) {
                                        phi_6528_ = -(_e3960[0]);
                                    } else {
                                        phi_6528_ = _e3960[0];
                                    }
                                    let _e3967 = phi_6528_;
                                    if (_e3960[1] < 0f) {
                                        phi_6535_ = -(_e3960[1]);
                                    } else {
                                        phi_6535_ = _e3960[1];
                                    }
                                    let _e3971 = phi_6535_;
                                    if (_e3967 > _e3971) {
                                        phi_6540_ = _e3967;
                                    } else {
                                        phi_6540_ = _e3971;
                                    }
                                    let _e3974 = phi_6540_;
                                    if (_e3960[2] < 0f) {
                                        phi_6547_ = -(_e3960[2]);
                                    } else {
                                        phi_6547_ = _e3960[2];
                                    }
                                    let _e3978 = phi_6547_;
                                    if (_e3974 > _e3978) {
                                        phi_6552_ = _e3974;
                                    } else {
                                        phi_6552_ = _e3978;
                                    }
                                    let _e3981 = phi_6552_;
                                    if (_e3957 > _e3981) {
                                        phi_6557_ = _e3957;
                                    } else {
                                        phi_6557_ = _e3981;
                                    }
                                    let _e3984 = phi_6557_;
                                    let _e3986 = local_1.member_3;
                                    let _e3987 = (_e3984 + _e3986);
                                    let _e3990 = local_1.member_1[0u];
                                    if (_e3990[0] < 0f) {
                                        phi_6574_ = -(_e3990[0]);
                                    } else {
                                        phi_6574_ = _e3990[0];
                                    }
                                    let _e3997 = phi_6574_;
                                    if (_e3990[1] < 0f) {
                                        phi_6581_ = -(_e3990[1]);
                                    } else {
                                        phi_6581_ = _e3990[1];
                                    }
                                    let _e4001 = phi_6581_;
                                    if (_e3997 > _e4001) {
                                        phi_6586_ = _e3997;
                                    } else {
                                        phi_6586_ = _e4001;
                                    }
                                    let _e4004 = phi_6586_;
                                    if (_e3990[2] < 0f) {
                                        phi_6593_ = -(_e3990[2]);
                                    } else {
                                        phi_6593_ = _e3990[2];
                                    }
                                    let _e4008 = phi_6593_;
                                    if (_e4004 > _e4008) {
                                        phi_6598_ = _e4004;
                                    } else {
                                        phi_6598_ = _e4008;
                                    }
                                    let _e4011 = phi_6598_;
                                    let _e4014 = local_1.member_1[1u];
                                    if (_e4014[0] < 0f) {
                                        phi_6612_ = -(_e4014[0]);
                                    } else {
                                        phi_6612_ = _e4014[0];
                                    }
                                    let _e4021 = phi_6612_;
                                    if (_e4014[1] < 0f) {
                                        phi_6619_ = -(_e4014[1]);
                                    } else {
                                        phi_6619_ = _e4014[1];
                                    }
                                    let _e4025 = phi_6619_;
                                    if (_e4021 > _e4025) {
                                        phi_6624_ = _e4021;
                                    } else {
                                        phi_6624_ = _e4025;
                                    }
                                    let _e4028 = phi_6624_;
                                    if (_e4014[2] < 0f) {
                                        phi_6631_ = -(_e4014[2]);
                                    } else {
                                        phi_6631_ = _e4014[2];
                                    }
                                    let _e4032 = phi_6631_;
                                    if (_e4028 > _e4032) {
                                        phi_6636_ = _e4028;
                                    } else {
                                        phi_6636_ = _e4032;
                                    }
                                    let _e4035 = phi_6636_;
                                    if (_e4011 > _e4035) {
                                        phi_6641_ = _e4011;
                                    } else {
                                        phi_6641_ = _e4035;
                                    }
                                    let _e4038 = phi_6641_;
                                    let _e4040 = local_1.member_3;
                                    let _e4041 = (_e4038 + _e4040);
                                    let _e4044 = local_1.member_2[0u];
                                    if (_e4044[0] < 0f) {
                                        phi_6658_ = -(_e4044[0]);
                                    } else {
                                        phi_6658_ = _e4044[0];
                                    }
                                    let _e4051 = phi_6658_;
                                    if (_e4044[1] < 0f) {
                                        phi_6665_ = -(_e4044[1]);
                                    } else {
                                        phi_6665_ = _e4044[1];
                                    }
                                    let _e4055 = phi_6665_;
                                    if (_e4051 > _e4055) {
                                        phi_6670_ = _e4051;
                                    } else {
                                        phi_6670_ = _e4055;
                                    }
                                    let _e4058 = phi_6670_;
                                    if (_e4044[2] < 0f) {
                                        phi_6677_ = -(_e4044[2]);
                                    } else {
                                        phi_6677_ = _e4044[2];
                                    }
                                    let _e4062 = phi_6677_;
                                    if (_e4058 > _e4062) {
                                        phi_6682_ = _e4058;
                                    } else {
                                        phi_6682_ = _e4062;
                                    }
                                    let _e4065 = phi_6682_;
                                    let _e4068 = local_1.member_2[1u];
                                    if (_e4068[0] < 0f) {
                                        phi_6696_ = -(_e4068[0]);
                                    } else {
                                        phi_6696_ = _e4068[0];
                                    }
                                    let _e4075 = phi_6696_;
                                    if (_e4068[1] < 0f) {
                                        phi_6703_ = -(_e4068[1]);
                                    } else {
                                        phi_6703_ = _e4068[1];
                                    }
                                    let _e4079 = phi_6703_;
                                    if (_e4075 > _e4079) {
                                        phi_6708_ = _e4075;
                                    } else {
                                        phi_6708_ = _e4079;
                                    }
                                    let _e4082 = phi_6708_;
                                    if (_e4068[2] < 0f) {
                                        phi_6715_ = -(_e4068[2]);
                                    } else {
                                        phi_6715_ = _e4068[2];
                                    }
                                    let _e4086 = phi_6715_;
                                    if (_e4082 > _e4086) {
                                        phi_6720_ = _e4082;
                                    } else {
                                        phi_6720_ = _e4086;
                                    }
                                    let _e4089 = phi_6720_;
                                    if (_e4065 > _e4089) {
                                        phi_6725_ = _e4065;
                                    } else {
                                        phi_6725_ = _e4089;
                                    }
                                    let _e4092 = phi_6725_;
                                    let _e4094 = local_1.member_3;
                                    let _e4095 = (_e4092 + _e4094);
                                    let _e4097 = ((_e4041 * 8f) * _e4095);
                                    let _e4104 = local_1.member_3;
                                    if (_e3793 < 0f) {
                                        phi_6756_ = -(_e3793);
                                    } else {
                                        phi_6756_ = _e3793;
                                    }
                                    let _e4121 = phi_6756_;
                                    if (_e3796 < 0f) {
                                        phi_6762_ = -(_e3796);
                                    } else {
                                        phi_6762_ = _e3796;
                                    }
                                    let _e4125 = phi_6762_;
                                    if (_e3799 < 0f) {
                                        phi_6769_ = -(_e3799);
                                    } else {
                                        phi_6769_ = _e3799;
                                    }
                                    let _e4130 = phi_6769_;
                                    let _e4131 = ((_e4121 + _e4125) + _e4130);
                                    if (_e3814 < 0f) {
                                        phi_6776_ = -(_e3814);
                                    } else {
                                        phi_6776_ = _e3814;
                                    }
                                    let _e4135 = phi_6776_;
                                    if (_e3817 < 0f) {
                                        phi_6782_ = -(_e3817);
                                    } else {
                                        phi_6782_ = _e3817;
                                    }
                                    let _e4139 = phi_6782_;
                                    if (_e3820 < 0f) {
                                        phi_6789_ = -(_e3820);
                                    } else {
                                        phi_6789_ = _e3820;
                                    }
                                    let _e4144 = phi_6789_;
                                    let _e4145 = ((_e4135 + _e4139) + _e4144);
                                    if (_e4131 > _e4145) {
                                        phi_6795_ = _e4131;
                                    } else {
                                        phi_6795_ = _e4145;
                                    }
                                    let _e4148 = phi_6795_;
                                    if (_e3863 < 0f) {
                                        phi_6801_ = -(_e3863);
                                    } else {
                                        phi_6801_ = _e3863;
                                    }
                                    let _e4152 = phi_6801_;
                                    if (_e3864 < 0f) {
                                        phi_6807_ = -(_e3864);
                                    } else {
                                        phi_6807_ = _e3864;
                                    }
                                    let _e4156 = phi_6807_;
                                    if (_e3865 < 0f) {
                                        phi_6814_ = -(_e3865);
                                    } else {
                                        phi_6814_ = _e3865;
                                    }
                                    let _e4161 = phi_6814_;
                                    let _e4163 = (((_e4152 + _e4156) + _e4161) * 0.5f);
                                    if (_e4148 > _e4163) {
                                        phi_6821_ = _e4148;
                                    } else {
                                        phi_6821_ = _e4163;
                                    }
                                    let _e4166 = phi_6821_;
                                    let _e4171 = local_1.member_3;
                                    let _e4184 = ((((_e3868[0] * _e3793) + (_e3868[1] * _e3796)) + (_e3868[2] * _e3799)) * 3f);
                                    let _e4185 = ((((_e3925[0] * _e3814) + (_e3925[1] * _e3817)) + (_e3925[2] * _e3820)) * 3f);
                                    if (_e4184 < _e4185) {
                                        phi_6845_ = _e4184;
                                    } else {
                                        phi_6845_ = _e4185;
                                    }
                                    let _e4188 = phi_6845_;
                                    if (_e3899 < _e3922) {
                                        phi_6850_ = _e3899;
                                    } else {
                                        phi_6850_ = _e3922;
                                    }
                                    let _e4191 = phi_6850_;
                                    if (_e4188 < _e4191) {
                                        phi_6855_ = _e4188;
                                    } else {
                                        phi_6855_ = _e4191;
                                    }
                                    let _e4194 = phi_6855_;
                                    if (_e4184 > _e4185) {
                                        phi_6860_ = _e4184;
                                    } else {
                                        phi_6860_ = _e4185;
                                    }
                                    let _e4197 = phi_6860_;
                                    if (_e3899 > _e3922) {
                                        phi_6865_ = _e3899;
                                    } else {
                                        phi_6865_ = _e3922;
                                    }
                                    let _e4200 = phi_6865_;
                                    if (_e4197 > _e4200) {
                                        phi_6870_ = _e4197;
                                    } else {
                                        phi_6870_ = _e4200;
                                    }
                                    let _e4203 = phi_6870_;
                                    let _e4208 = -(_e4203);
                                    if (_e4194 > _e4208) {
                                        phi_6880_ = _e4194;
                                    } else {
                                        phi_6880_ = _e4208;
                                    }
                                    let _e4211 = phi_6880_;
                                    if ((_e4211 - ((((((_e3987 * 8f) * _e4097) * (0.000000059604645f * (490f / 64f))) + ((_e4104 * 19f) * ((_e3987 * (_e4041 + _e4095)) + (_e4041 * _e4095)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3987) * ((1f + _e4041) * (1f + _e4095))))) + ((_e1499 * (((_e4166 + (_e4097 * (0.000000059604645f * 4f))) + ((_e4171 * 6f) * (_e4041 + _e4095))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4041) * (1f + _e4095))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_7844_ = true;
                                    } else {
                                        let _e4216 = local_1.member_1[0u];
                                        let _e4222 = local_1.member_1[1u];
                                        let _e4226 = (_e4216[0] + _e4222[0]);
                                        let _e4227 = (_e4216[1] + _e4222[1]);
                                        let _e4228 = (_e4216[2] + _e4222[2]);
                                        let _e4231 = local_1.member_2[0u];
                                        let _e4237 = local_1.member_2[1u];
                                        let _e4241 = (_e4231[0] + _e4237[0]);
                                        let _e4242 = (_e4231[1] + _e4237[1]);
                                        let _e4243 = (_e4231[2] + _e4237[2]);
                                        let _e4246 = ((_e4227 * _e4243) - (_e4228 * _e4242));
                                        let _e4249 = ((_e4228 * _e4241) - (_e4226 * _e4243));
                                        let _e4252 = ((_e4226 * _e4242) - (_e4227 * _e4241));
                                        let _e4255 = local_1.member[0u];
                                        let _e4261 = local_1.member_1[0u];
                                        let _e4267 = local_1.member_2[0u];
                                        let _e4271 = (_e4255[0] - _e4261[0]);
                                        let _e4272 = (_e4255[1] - _e4261[1]);
                                        let _e4273 = (_e4255[2] - _e4261[2]);
                                        let _e4274 = (_e4255[0] - _e4267[0]);
                                        let _e4275 = (_e4255[1] - _e4267[1]);
                                        let _e4276 = (_e4255[2] - _e4267[2]);
                                        let _e4279 = local_1.member[1u];
                                        let _e4285 = local_1.member_1[1u];
                                        let _e4291 = local_1.member_2[1u];
                                        let _e4295 = (_e4279[0] - _e4285[0]);
                                        let _e4296 = (_e4279[1] - _e4285[1]);
                                        let _e4297 = (_e4279[2] - _e4285[2]);
                                        let _e4298 = (_e4279[0] - _e4291[0]);
                                        let _e4299 = (_e4279[1] - _e4291[1]);
                                        let _e4300 = (_e4279[2] - _e4291[2]);
                                        let _e4303 = local_1.member[0u];
                                        if (_e4303[0] < 0f) {
                                            phi_7083_ = -(_e4303[0]);
                                        } else {
                                            phi_7083_ = _e4303[0];
                                        }
                                        let _e4310 = phi_7083_;
                                        if (_e4303[1] < 0f) {
                                            phi_7090_ = -(_e4303[1]);
                                        } else {
                                            phi_7090_ = _e4303[1];
                                        }
                                        let _e4314 = phi_7090_;
                                        if (_e4310 > _e4314) {
                                            phi_7095_ = _e4310;
                                        } else {
                                            phi_7095_ = _e4314;
                                        }
                                        let _e4317 = phi_7095_;
                                        if (_e4303[2] < 0f) {
                                            phi_7102_ = -(_e4303[2]);
                                        } else {
                                            phi_7102_ = _e4303[2];
                                        }
                                        let _e4321 = phi_7102_;
                                        if (_e4317 > _e4321) {
                                            phi_7107_ = _e4317;
                                        } else {
                                            phi_7107_ = _e4321;
                                        }
                                        let _e4324 = phi_7107_;
                                        let _e4327 = local_1.member[1u];
                                        if (_e4327[0] < 0f) {
                                            phi_7120_ = -(_e4327[0]);
                                        } else {
                                            phi_7120_ = _e4327[0];
                                        }
                                        let _e4334 = phi_7120_;
                                        if (_e4327[1] < 0f) {
                                            phi_7127_ = -(_e4327[1]);
                                        } else {
                                            phi_7127_ = _e4327[1];
                                        }
                                        let _e4338 = phi_7127_;
                                        if (_e4334 > _e4338) {
                                            phi_7132_ = _e4334;
                                        } else {
                                            phi_7132_ = _e4338;
                                        }
                                        let _e4341 = phi_7132_;
                                        if (_e4327[2] < 0f) {
                                            phi_7139_ = -(_e4327[2]);
                                        } else {
                                            phi_7139_ = _e4327[2];
                                        }
                                        let _e4345 = phi_7139_;
                                        if (_e4341 > _e4345) {
                                            phi_7144_ = _e4341;
                                        } else {
                                            phi_7144_ = _e4345;
                                        }
                                        let _e4348 = phi_7144_;
                                        if (_e4324 > _e4348) {
                                            phi_7149_ = _e4324;
                                        } else {
                                            phi_7149_ = _e4348;
                                        }
                                        let _e4351 = phi_7149_;
                                        let _e4353 = local_1.member_3;
                                        let _e4357 = local_1.member_1[0u];
                                        if (_e4357[0] < 0f) {
                                            phi_7166_ = -(_e4357[0]);
                                        } else {
                                            phi_7166_ = _e4357[0];
                                        }
                                        let _e4364 = phi_7166_;
                                        if (_e4357[1] < 0f) {
                                            phi_7173_ = -(_e4357[1]);
                                        } else {
                                            phi_7173_ = _e4357[1];
                                        }
                                        let _e4368 = phi_7173_;
                                        if (_e4364 > _e4368) {
                                            phi_7178_ = _e4364;
                                        } else {
                                            phi_7178_ = _e4368;
                                        }
                                        let _e4371 = phi_7178_;
                                        if (_e4357[2] < 0f) {
                                            phi_7185_ = -(_e4357[2]);
                                        } else {
                                            phi_7185_ = _e4357[2];
                                        }
                                        let _e4375 = phi_7185_;
                                        if (_e4371 > _e4375) {
                                            phi_7190_ = _e4371;
                                        } else {
                                            phi_7190_ = _e4375;
                                        }
                                        let _e4378 = phi_7190_;
                                        let _e4381 = local_1.member_1[1u];
                                        if (_e4381[0] < 0f) {
                                            phi_7204_ = -(_e4381[0]);
                                        } else {
                                            phi_7204_ = _e4381[0];
                                        }
                                        let _e4388 = phi_7204_;
                                        if (_e4381[1] < 0f) {
                                            phi_7211_ = -(_e4381[1]);
                                        } else {
                                            phi_7211_ = _e4381[1];
                                        }
                                        let _e4392 = phi_7211_;
                                        if (_e4388 > _e4392) {
                                            phi_7216_ = _e4388;
                                        } else {
                                            phi_7216_ = _e4392;
                                        }
                                        let _e4395 = phi_7216_;
                                        if (_e4381[2] < 0f) {
                                            phi_7223_ = -(_e4381[2]);
                                        } else {
                                            phi_7223_ = _e4381[2];
                                        }
                                        let _e4399 = phi_7223_;
                                        if (_e4395 > _e4399) {
                                            phi_7228_ = _e4395;
                                        } else {
                                            phi_7228_ = _e4399;
                                        }
                                        let _e4402 = phi_7228_;
                                        if (_e4378 > _e4402) {
                                            phi_7233_ = _e4378;
                                        } else {
                                            phi_7233_ = _e4402;
                                        }
                                        let _e4405 = phi_7233_;
                                        let _e4407 = local_1.member_3;
                                        let _e4411 = local_1.member_2[0u];
                                        if (_e4411[0] < 0f) {
                                            phi_7250_ = -(_e4411[0]);
                                        } else {
                                            phi_7250_ = _e4411[0];
                                        }
                                        let _e4418 = phi_7250_;
                                        if (_e4411[1] < 0f) {
                                            phi_7257_ = -(_e4411[1]);
                                        } else {
                                            phi_7257_ = _e4411[1];
                                        }
                                        let _e4422 = phi_7257_;
                                        if (_e4418 > _e4422) {
                                            phi_7262_ = _e4418;
                                        } else {
                                            phi_7262_ = _e4422;
                                        }
                                        let _e4425 = phi_7262_;
                                        if (_e4411[2] < 0f) {
                                            phi_7269_ = -(_e4411[2]);
                                        } else {
                                            phi_7269_ = _e4411[2];
                                        }
                                        let _e4429 = phi_7269_;
                                        if (_e4425 > _e4429) {
                                            phi_7274_ = _e4425;
                                        } else {
                                            phi_7274_ = _e4429;
                                        }
                                        let _e4432 = phi_7274_;
                                        let _e4435 = local_1.member_2[1u];
                                        if (_e4435[0] < 0f) {
                                            phi_7288_ = -(_e4435[0]);
                                        } else {
                                            phi_7288_ = _e4435[0];
                                        }
                                        let _e4442 = phi_7288_;
                                        if (_e4435[1] < 0f) {
                                            phi_7295_ = -(_e4435[1]);
                                        } else {
                                            phi_7295_ = _e4435[1];
                                        }
                                        let _e4446 = phi_7295_;
                                        if (_e4442 > _e4446) {
                                            phi_7300_ = _e4442;
                                        } else {
                                            phi_7300_ = _e4446;
                                        }
                                        let _e4449 = phi_7300_;
                                        if (_e4435[2] < 0f) {
                                            phi_7307_ = -(_e4435[2]);
                                        } else {
                                            phi_7307_ = _e4435[2];
                                        }
                                        let _e4453 = phi_7307_;
                                        if (_e4449 > _e4453) {
                                            phi_7312_ = _e4449;
                                        } else {
                                            phi_7312_ = _e4453;
                                        }
                                        let _e4456 = phi_7312_;
                                        if (_e4432 > _e4456) {
                                            phi_7317_ = _e4432;
                                        } else {
                                            phi_7317_ = _e4456;
                                        }
                                        let _e4459 = phi_7317_;
                                        let _e4461 = local_1.member_3;
                                        let _e4464 = (((_e4351 + _e4353) + (_e4405 + _e4407)) + (_e4459 + _e4461));
                                        let _e4467 = local_1.member_3;
                                        let _e4471 = (((_e1499 * 1.0001f) + (_e4467 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4474 = ((_e4249 * _e4228) - (_e4252 * _e4227));
                                        let _e4477 = ((_e4252 * _e4226) - (_e4246 * _e4228));
                                        let _e4480 = ((_e4246 * _e4227) - (_e4249 * _e4226));
                                        let _e4485 = (((_e4474 * _e4255[0]) + (_e4477 * _e4255[1])) + (_e4480 * _e4255[2]));
                                        let _e4490 = (((_e4474 * _e4271) + (_e4477 * _e4272)) + (_e4480 * _e4273));
                                        let _e4495 = (((_e4474 * _e4274) + (_e4477 * _e4275)) + (_e4480 * _e4276));
                                        let _e4500 = (((_e4474 * _e4255[0]) + (_e4477 * _e4255[1])) + (_e4480 * _e4255[2]));
                                        let _e4505 = (((_e4474 * _e4279[0]) + (_e4477 * _e4279[1])) + (_e4480 * _e4279[2]));
                                        let _e4510 = (((_e4474 * _e4295) + (_e4477 * _e4296)) + (_e4480 * _e4297));
                                        let _e4515 = (((_e4474 * _e4298) + (_e4477 * _e4299)) + (_e4480 * _e4300));
                                        let _e4520 = (((_e4474 * _e4279[0]) + (_e4477 * _e4279[1])) + (_e4480 * _e4279[2]));
                                        if (_e4485 < _e4490) {
                                            phi_7395_ = _e4485;
                                        } else {
                                            phi_7395_ = _e4490;
                                        }
                                        let _e4523 = phi_7395_;
                                        if (_e4495 < _e4500) {
                                            phi_7400_ = _e4495;
                                        } else {
                                            phi_7400_ = _e4500;
                                        }
                                        let _e4526 = phi_7400_;
                                        if (_e4523 < _e4526) {
                                            phi_7405_ = _e4523;
                                        } else {
                                            phi_7405_ = _e4526;
                                        }
                                        let _e4529 = phi_7405_;
                                        if (_e4505 < _e4510) {
                                            phi_7410_ = _e4505;
                                        } else {
                                            phi_7410_ = _e4510;
                                        }
                                        let _e4532 = phi_7410_;
                                        if (_e4515 < _e4520) {
                                            phi_7415_ = _e4515;
                                        } else {
                                            phi_7415_ = _e4520;
                                        }
                                        let _e4535 = phi_7415_;
                                        if (_e4532 < _e4535) {
                                            phi_7420_ = _e4532;
                                        } else {
                                            phi_7420_ = _e4535;
                                        }
                                        let _e4538 = phi_7420_;
                                        if (_e4529 < _e4538) {
                                            phi_7425_ = _e4529;
                                        } else {
                                            phi_7425_ = _e4538;
                                        }
                                        let _e4541 = phi_7425_;
                                        if (_e4485 > _e4490) {
                                            phi_7430_ = _e4485;
                                        } else {
                                            phi_7430_ = _e4490;
                                        }
                                        let _e4544 = phi_7430_;
                                        if (_e4495 > _e4500) {
                                            phi_7435_ = _e4495;
                                        } else {
                                            phi_7435_ = _e4500;
                                        }
                                        let _e4547 = phi_7435_;
                                        if (_e4544 > _e4547) {
                                            phi_7440_ = _e4544;
                                        } else {
                                            phi_7440_ = _e4547;
                                        }
                                        let _e4550 = phi_7440_;
                                        if (_e4505 > _e4510) {
                                            phi_7445_ = _e4505;
                                        } else {
                                            phi_7445_ = _e4510;
                                        }
                                        let _e4553 = phi_7445_;
                                        if (_e4515 > _e4520) {
                                            phi_7450_ = _e4515;
                                        } else {
                                            phi_7450_ = _e4520;
                                        }
                                        let _e4556 = phi_7450_;
                                        if (_e4553 > _e4556) {
                                            phi_7455_ = _e4553;
                                        } else {
                                            phi_7455_ = _e4556;
                                        }
                                        let _e4559 = phi_7455_;
                                        if (_e4550 > _e4559) {
                                            phi_7460_ = _e4550;
                                        } else {
                                            phi_7460_ = _e4559;
                                        }
                                        let _e4562 = phi_7460_;
                                        if (_e4474 < 0f) {
                                            phi_7466_ = -(_e4474);
                                        } else {
                                            phi_7466_ = _e4474;
                                        }
                                        let _e4566 = phi_7466_;
                                        if (_e4477 < 0f) {
                                            phi_7472_ = -(_e4477);
                                        } else {
                                            phi_7472_ = _e4477;
                                        }
                                        let _e4570 = phi_7472_;
                                        if (_e4480 < 0f) {
                                            phi_7479_ = -(_e4480);
                                        } else {
                                            phi_7479_ = _e4480;
                                        }
                                        let _e4575 = phi_7479_;
                                        let _e4576 = ((_e4566 + _e4570) + _e4575);
                                        let _e4580 = -(_e4562);
                                        if (_e4541 > _e4580) {
                                            phi_7489_ = _e4541;
                                        } else {
                                            phi_7489_ = _e4580;
                                        }
                                        let _e4583 = phi_7489_;
                                        let _e4588 = (((_e4583 - ((_e4576 * _e4464) * (0.000000059604645f * 17f))) - (_e4576 * _e4471)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4591 = ((_e4249 * _e4243) - (_e4252 * _e4242));
                                        let _e4594 = ((_e4252 * _e4241) - (_e4246 * _e4243));
                                        let _e4597 = ((_e4246 * _e4242) - (_e4249 * _e4241));
                                        let _e4602 = (((_e4591 * _e4255[0]) + (_e4594 * _e4255[1])) + (_e4597 * _e4255[2]));
                                        let _e4607 = (((_e4591 * _e4271) + (_e4594 * _e4272)) + (_e4597 * _e4273));
                                        let _e4612 = (((_e4591 * _e4274) + (_e4594 * _e4275)) + (_e4597 * _e4276));
                                        let _e4617 = (((_e4591 * _e4255[0]) + (_e4594 * _e4255[1])) + (_e4597 * _e4255[2]));
                                        let _e4622 = (((_e4591 * _e4279[0]) + (_e4594 * _e4279[1])) + (_e4597 * _e4279[2]));
                                        let _e4627 = (((_e4591 * _e4295) + (_e4594 * _e4296)) + (_e4597 * _e4297));
                                        let _e4632 = (((_e4591 * _e4298) + (_e4594 * _e4299)) + (_e4597 * _e4300));
                                        let _e4637 = (((_e4591 * _e4279[0]) + (_e4594 * _e4279[1])) + (_e4597 * _e4279[2]));
                                        if (_e4602 < _e4607) {
                                            phi_7560_ = _e4602;
                                        } else {
                                            phi_7560_ = _e4607;
                                        }
                                        let _e4640 = phi_7560_;
                                        if (_e4612 < _e4617) {
                                            phi_7565_ = _e4612;
                                        } else {
                                            phi_7565_ = _e4617;
                                        }
                                        let _e4643 = phi_7565_;
                                        if (_e4640 < _e4643) {
                                            phi_7570_ = _e4640;
                                        } else {
                                            phi_7570_ = _e4643;
                                        }
                                        let _e4646 = phi_7570_;
                                        if (_e4622 < _e4627) {
                                            phi_7575_ = _e4622;
                                        } else {
                                            phi_7575_ = _e4627;
                                        }
                                        let _e4649 = phi_7575_;
                                        if (_e4632 < _e4637) {
                                            phi_7580_ = _e4632;
                                        } else {
                                            phi_7580_ = _e4637;
                                        }
                                        let _e4652 = phi_7580_;
                                        if (_e4649 < _e4652) {
                                            phi_7585_ = _e4649;
                                        } else {
                                            phi_7585_ = _e4652;
                                        }
                                        let _e4655 = phi_7585_;
                                        if (_e4646 < _e4655) {
                                            phi_7590_ = _e4646;
                                        } else {
                                            phi_7590_ = _e4655;
                                        }
                                        let _e4658 = phi_7590_;
                                        if (_e4602 > _e4607) {
                                            phi_7595_ = _e4602;
                                        } else {
                                            phi_7595_ = _e4607;
                                        }
                                        let _e4661 = phi_7595_;
                                        if (_e4612 > _e4617) {
                                            phi_7600_ = _e4612;
                                        } else {
                                            phi_7600_ = _e4617;
                                        }
                                        let _e4664 = phi_7600_;
                                        if (_e4661 > _e4664) {
                                            phi_7605_ = _e4661;
                                        } else {
                                            phi_7605_ = _e4664;
                                        }
                                        let _e4667 = phi_7605_;
                                        if (_e4622 > _e4627) {
                                            phi_7610_ = _e4622;
                                        } else {
                                            phi_7610_ = _e4627;
                                        }
                                        let _e4670 = phi_7610_;
                                        if (_e4632 > _e4637) {
                                            phi_7615_ = _e4632;
                                        } else {
                                            phi_7615_ = _e4637;
                                        }
                                        let _e4673 = phi_7615_;
                                        if (_e4670 > _e4673) {
                                            phi_7620_ = _e4670;
                                        } else {
                                            phi_7620_ = _e4673;
                                        }
                                        let _e4676 = phi_7620_;
                                        if (_e4667 > _e4676) {
                                            phi_7625_ = _e4667;
                                        } else {
                                            phi_7625_ = _e4676;
                                        }
                                        let _e4679 = phi_7625_;
                                        if (_e4591 < 0f) {
                                            phi_7631_ = -(_e4591);
                                        } else {
                                            phi_7631_ = _e4591;
                                        }
                                        let _e4683 = phi_7631_;
                                        if (_e4594 < 0f) {
                                            phi_7637_ = -(_e4594);
                                        } else {
                                            phi_7637_ = _e4594;
                                        }
                                        let _e4687 = phi_7637_;
                                        if (_e4597 < 0f) {
                                            phi_7644_ = -(_e4597);
                                        } else {
                                            phi_7644_ = _e4597;
                                        }
                                        let _e4692 = phi_7644_;
                                        let _e4693 = ((_e4683 + _e4687) + _e4692);
                                        let _e4697 = -(_e4679);
                                        if (_e4658 > _e4697) {
                                            phi_7654_ = _e4658;
                                        } else {
                                            phi_7654_ = _e4697;
                                        }
                                        let _e4700 = phi_7654_;
                                        let _e4705 = (((_e4700 - ((_e4693 * _e4464) * (0.000000059604645f * 17f))) - (_e4693 * _e4471)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4588 > _e4705) {
                                            phi_7664_ = _e4588;
                                        } else {
                                            phi_7664_ = _e4705;
                                        }
                                        let _e4708 = phi_7664_;
                                        let _e4709 = (_e4241 - _e4226);
                                        let _e4710 = (_e4242 - _e4227);
                                        let _e4711 = (_e4243 - _e4228);
                                        let _e4714 = ((_e4249 * _e4711) - (_e4252 * _e4710));
                                        let _e4717 = ((_e4252 * _e4709) - (_e4246 * _e4711));
                                        let _e4720 = ((_e4246 * _e4710) - (_e4249 * _e4709));
                                        let _e4725 = (((_e4714 * _e4255[0]) + (_e4717 * _e4255[1])) + (_e4720 * _e4255[2]));
                                        let _e4730 = (((_e4714 * _e4271) + (_e4717 * _e4272)) + (_e4720 * _e4273));
                                        let _e4735 = (((_e4714 * _e4274) + (_e4717 * _e4275)) + (_e4720 * _e4276));
                                        let _e4740 = (((_e4714 * _e4255[0]) + (_e4717 * _e4255[1])) + (_e4720 * _e4255[2]));
                                        let _e4745 = (((_e4714 * _e4279[0]) + (_e4717 * _e4279[1])) + (_e4720 * _e4279[2]));
                                        let _e4750 = (((_e4714 * _e4295) + (_e4717 * _e4296)) + (_e4720 * _e4297));
                                        let _e4755 = (((_e4714 * _e4298) + (_e4717 * _e4299)) + (_e4720 * _e4300));
                                        let _e4760 = (((_e4714 * _e4279[0]) + (_e4717 * _e4279[1])) + (_e4720 * _e4279[2]));
                                        if (_e4725 < _e4730) {
                                            phi_7737_ = _e4725;
                                        } else {
                                            phi_7737_ = _e4730;
                                        }
                                        let _e4763 = phi_7737_;
                                        if (_e4735 < _e4740) {
                                            phi_7742_ = _e4735;
                                        } else {
                                            phi_7742_ = _e4740;
                                        }
                                        let _e4766 = phi_7742_;
                                        if (_e4763 < _e4766) {
                                            phi_7747_ = _e4763;
                                        } else {
                                            phi_7747_ = _e4766;
                                        }
                                        let _e4769 = phi_7747_;
                                        if (_e4745 < _e4750) {
                                            phi_7752_ = _e4745;
                                        } else {
                                            phi_7752_ = _e4750;
                                        }
                                        let _e4772 = phi_7752_;
                                        if (_e4755 < _e4760) {
                                            phi_7757_ = _e4755;
                                        } else {
                                            phi_7757_ = _e4760;
                                        }
                                        let _e4775 = phi_7757_;
                                        if (_e4772 < _e4775) {
                                            phi_7762_ = _e4772;
                                        } else {
                                            phi_7762_ = _e4775;
                                        }
                                        let _e4778 = phi_7762_;
                                        if (_e4769 < _e4778) {
                                            phi_7767_ = _e4769;
                                        } else {
                                            phi_7767_ = _e4778;
                                        }
                                        let _e4781 = phi_7767_;
                                        if (_e4725 > _e4730) {
                                            phi_7772_ = _e4725;
                                        } else {
                                            phi_7772_ = _e4730;
                                        }
                                        let _e4784 = phi_7772_;
                                        if (_e4735 > _e4740) {
                                            phi_7777_ = _e4735;
                                        } else {
                                            phi_7777_ = _e4740;
                                        }
                                        let _e4787 = phi_7777_;
                                        if (_e4784 > _e4787) {
                                            phi_7782_ = _e4784;
                                        } else {
                                            phi_7782_ = _e4787;
                                        }
                                        let _e4790 = phi_7782_;
                                        if (_e4745 > _e4750) {
                                            phi_7787_ = _e4745;
                                        } else {
                                            phi_7787_ = _e4750;
                                        }
                                        let _e4793 = phi_7787_;
                                        if (_e4755 > _e4760) {
                                            phi_7792_ = _e4755;
                                        } else {
                                            phi_7792_ = _e4760;
                                        }
                                        let _e4796 = phi_7792_;
                                        if (_e4793 > _e4796) {
                                            phi_7797_ = _e4793;
                                        } else {
                                            phi_7797_ = _e4796;
                                        }
                                        let _e4799 = phi_7797_;
                                        if (_e4790 > _e4799) {
                                            phi_7802_ = _e4790;
                                        } else {
                                            phi_7802_ = _e4799;
                                        }
                                        let _e4802 = phi_7802_;
                                        if (_e4714 < 0f) {
                                            phi_7808_ = -(_e4714);
                                        } else {
                                            phi_7808_ = _e4714;
                                        }
                                        let _e4806 = phi_7808_;
                                        if (_e4717 < 0f) {
                                            phi_7814_ = -(_e4717);
                                        } else {
                                            phi_7814_ = _e4717;
                                        }
                                        let _e4810 = phi_7814_;
                                        if (_e4720 < 0f) {
                                            phi_7821_ = -(_e4720);
                                        } else {
                                            phi_7821_ = _e4720;
                                        }
                                        let _e4815 = phi_7821_;
                                        let _e4816 = ((_e4806 + _e4810) + _e4815);
                                        let _e4820 = -(_e4802);
                                        if (_e4781 > _e4820) {
                                            phi_7831_ = _e4781;
                                        } else {
                                            phi_7831_ = _e4820;
                                        }
                                        let _e4823 = phi_7831_;
                                        let _e4828 = (((_e4823 - ((_e4816 * _e4464) * (0.000000059604645f * 17f))) - (_e4816 * _e4471)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4708 > _e4828) {
                                            phi_7841_ = _e4708;
                                        } else {
                                            phi_7841_ = _e4828;
                                        }
                                        let _e4831 = phi_7841_;
                                        phi_7844_ = (_e4831 > 0f);
                                    }
                                    let _e4834 = phi_7844_;
                                    phi_7845_ = _e4834;
                                } else {
                                    phi_7845_ = false;
                                }
                                let _e4836 = phi_7845_;
                                phi_7847_ = !(_e4836);
                            }
                            let _e4839 = phi_7847_;
                            if _e4839 {
                                let _e4841 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1007] = ((2147483648u | (_e4841 << bitcast<u32>(12i))) | _e1010);
                            }
                        }
                        phi_7857_ = true;
                    }
                    let _e4848 = phi_7857_;
                    phi_7858_ = _e4848;
                } else {
                    phi_7858_ = false;
                }
                let _e4850 = phi_7858_;
                continue;
                continuing {
                    phi_1842_ = _e999;
                    break if !(_e4850);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4854 = atomicLoad((&counters[5u]));
                if (_e4854 > 0u) {
                    let _e4857 = atomicAdd((&output.member[0u]), _e4854);
                    if ((_e4857 + _e4854) < _e4857) {
                        let _e4861 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4857);
                }
            }
            workgroupBarrier();
            let _e4864 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4867 = atomicLoad((&counters[7u]));
                if (_e4867 > 0u) {
                    let _e4870 = atomicAdd((&output.member[1u]), _e4867);
                    if ((_e4870 + _e4867) < _e4870) {
                        let _e4874 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7908_ = type_21(0u, 16u);
            loop {
                let _e4876 = phi_7908_;
                if (_e4876.member < _e4876.member_1) {
                    phi_7909_ = type_21((_e4876.member + 1u), _e4876.member_1);
                    phi_7932_ = type_21(1u, _e4876.member);
                } else {
                    phi_7909_ = _e4876;
                    phi_7932_ = type_21(0u, type_21().member_1);
                }
                let _e4888 = phi_7909_;
                let _e4890 = phi_7932_;
                if (bitcast<i32>(_e4890.member) != 0i) {
                    let _e4896 = (_e67 + (_e4890.member_1 * 128u));
                    if (_e4896 >= _e985) {
                        phi_8030_ = false;
                    } else {
                        let _e4899 = hits[_e4896];
                        if ((_e4899 & 2147483648u) == 0u) {
                            phi_7955_ = 4294967295u;
                        } else {
                            phi_7955_ = ((_e4899 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4906 = phi_7955_;
                        if (_e4906 != 4294967295u) {
                            let _e4910 = ((_e4899 >> bitcast<u32>(10i)) & 3u);
                            let _e4917 = firsts[(2u * _e4910)];
                            let _e4920 = leaves.member[(_e4917 + ((_e4899 >> bitcast<u32>(5i)) & 31u))];
                            let _e4924 = firsts[((2u * _e4910) + 1u)];
                            let _e4927 = leaves.member[(_e4924 + (_e4899 & 31u))];
                            let _e4931 = params.member.member_16;
                            let _e4932 = (_e4864 + _e4906);
                            if (_e4932 < _e4931) {
                                atomicStore((&output.member[(4u + (2u * _e4932))]), _e4920.member_1);
                                atomicStore((&output.member[((2u * _e4932) + 5u)]), _e4927.member_1);
                            }
                        }
                        phi_8030_ = true;
                    }
                    let _e4941 = phi_8030_;
                    phi_8031_ = _e4941;
                } else {
                    phi_8031_ = false;
                }
                let _e4943 = phi_8031_;
                continue;
                continuing {
                    phi_7908_ = _e4888;
                    break if !(_e4943);
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
