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
    var phi_938_: u32;
    var phi_940_: u32;
    var phi_826_: u32;
    var phi_943_: type_9;
    var phi_946_: u32;
    var phi_944_: type_9;
    var phi_969_: type_9;
    var phi_1051_: bool;
    var phi_1058_: bool;
    var phi_1066_: bool;
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
    var phi_1837_: u32;
    var phi_1838_: bool;
    var phi_947_: u32;
    var phi_1839_: bool;
    var phi_1846_: u32;
    var phi_1849_: type_9;
    var phi_1850_: type_9;
    var phi_1873_: type_9;
    var phi_1963_: bool;
    var phi_1970_: bool;
    var phi_1978_: bool;
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
    var phi_3082_: f32;
    var phi_3089_: f32;
    var phi_3094_: f32;
    var phi_3101_: f32;
    var phi_3106_: f32;
    var phi_3119_: f32;
    var phi_3126_: f32;
    var phi_3131_: f32;
    var phi_3138_: f32;
    var phi_3143_: f32;
    var phi_3148_: f32;
    var phi_3165_: f32;
    var phi_3172_: f32;
    var phi_3177_: f32;
    var phi_3184_: f32;
    var phi_3189_: f32;
    var phi_3203_: f32;
    var phi_3210_: f32;
    var phi_3215_: f32;
    var phi_3222_: f32;
    var phi_3227_: f32;
    var phi_3232_: f32;
    var phi_3249_: f32;
    var phi_3256_: f32;
    var phi_3261_: f32;
    var phi_3268_: f32;
    var phi_3273_: f32;
    var phi_3287_: f32;
    var phi_3294_: f32;
    var phi_3299_: f32;
    var phi_3306_: f32;
    var phi_3311_: f32;
    var phi_3316_: f32;
    var phi_3347_: f32;
    var phi_3353_: f32;
    var phi_3360_: f32;
    var phi_3367_: f32;
    var phi_3373_: f32;
    var phi_3380_: f32;
    var phi_3386_: f32;
    var phi_3392_: f32;
    var phi_3398_: f32;
    var phi_3405_: f32;
    var phi_3412_: f32;
    var phi_3436_: f32;
    var phi_3441_: f32;
    var phi_3446_: f32;
    var phi_3451_: f32;
    var phi_3456_: f32;
    var phi_3461_: f32;
    var phi_3471_: f32;
    var phi_3674_: f32;
    var phi_3681_: f32;
    var phi_3686_: f32;
    var phi_3693_: f32;
    var phi_3698_: f32;
    var phi_3711_: f32;
    var phi_3718_: f32;
    var phi_3723_: f32;
    var phi_3730_: f32;
    var phi_3735_: f32;
    var phi_3740_: f32;
    var phi_3757_: f32;
    var phi_3764_: f32;
    var phi_3769_: f32;
    var phi_3776_: f32;
    var phi_3781_: f32;
    var phi_3795_: f32;
    var phi_3802_: f32;
    var phi_3807_: f32;
    var phi_3814_: f32;
    var phi_3819_: f32;
    var phi_3824_: f32;
    var phi_3841_: f32;
    var phi_3848_: f32;
    var phi_3853_: f32;
    var phi_3860_: f32;
    var phi_3865_: f32;
    var phi_3879_: f32;
    var phi_3886_: f32;
    var phi_3891_: f32;
    var phi_3898_: f32;
    var phi_3903_: f32;
    var phi_3908_: f32;
    var phi_3987_: f32;
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
    var phi_4058_: f32;
    var phi_4064_: f32;
    var phi_4071_: f32;
    var phi_4082_: f32;
    var phi_4153_: f32;
    var phi_4158_: f32;
    var phi_4163_: f32;
    var phi_4168_: f32;
    var phi_4173_: f32;
    var phi_4178_: f32;
    var phi_4183_: f32;
    var phi_4188_: f32;
    var phi_4193_: f32;
    var phi_4198_: f32;
    var phi_4203_: f32;
    var phi_4208_: f32;
    var phi_4213_: f32;
    var phi_4218_: f32;
    var phi_4224_: f32;
    var phi_4230_: f32;
    var phi_4237_: f32;
    var phi_4248_: f32;
    var phi_4258_: f32;
    var phi_4331_: f32;
    var phi_4336_: f32;
    var phi_4341_: f32;
    var phi_4346_: f32;
    var phi_4351_: f32;
    var phi_4356_: f32;
    var phi_4361_: f32;
    var phi_4366_: f32;
    var phi_4371_: f32;
    var phi_4376_: f32;
    var phi_4381_: f32;
    var phi_4386_: f32;
    var phi_4391_: f32;
    var phi_4396_: f32;
    var phi_4402_: f32;
    var phi_4408_: f32;
    var phi_4415_: f32;
    var phi_4426_: f32;
    var phi_4436_: f32;
    var phi_4440_: bool;
    var phi_4892_: f32;
    var phi_4899_: f32;
    var phi_4904_: f32;
    var phi_4911_: f32;
    var phi_4916_: f32;
    var phi_4929_: f32;
    var phi_4936_: f32;
    var phi_4941_: f32;
    var phi_4948_: f32;
    var phi_4953_: f32;
    var phi_4958_: f32;
    var phi_4975_: f32;
    var phi_4982_: f32;
    var phi_4987_: f32;
    var phi_4994_: f32;
    var phi_4999_: f32;
    var phi_5013_: f32;
    var phi_5020_: f32;
    var phi_5025_: f32;
    var phi_5032_: f32;
    var phi_5037_: f32;
    var phi_5042_: f32;
    var phi_5059_: f32;
    var phi_5066_: f32;
    var phi_5071_: f32;
    var phi_5078_: f32;
    var phi_5083_: f32;
    var phi_5097_: f32;
    var phi_5104_: f32;
    var phi_5109_: f32;
    var phi_5116_: f32;
    var phi_5121_: f32;
    var phi_5126_: f32;
    var phi_5157_: f32;
    var phi_5163_: f32;
    var phi_5170_: f32;
    var phi_5177_: f32;
    var phi_5183_: f32;
    var phi_5190_: f32;
    var phi_5196_: f32;
    var phi_5202_: f32;
    var phi_5208_: f32;
    var phi_5215_: f32;
    var phi_5222_: f32;
    var phi_5246_: f32;
    var phi_5251_: f32;
    var phi_5256_: f32;
    var phi_5261_: f32;
    var phi_5266_: f32;
    var phi_5271_: f32;
    var phi_5281_: f32;
    var phi_5484_: f32;
    var phi_5491_: f32;
    var phi_5496_: f32;
    var phi_5503_: f32;
    var phi_5508_: f32;
    var phi_5521_: f32;
    var phi_5528_: f32;
    var phi_5533_: f32;
    var phi_5540_: f32;
    var phi_5545_: f32;
    var phi_5550_: f32;
    var phi_5567_: f32;
    var phi_5574_: f32;
    var phi_5579_: f32;
    var phi_5586_: f32;
    var phi_5591_: f32;
    var phi_5605_: f32;
    var phi_5612_: f32;
    var phi_5617_: f32;
    var phi_5624_: f32;
    var phi_5629_: f32;
    var phi_5634_: f32;
    var phi_5651_: f32;
    var phi_5658_: f32;
    var phi_5663_: f32;
    var phi_5670_: f32;
    var phi_5675_: f32;
    var phi_5689_: f32;
    var phi_5696_: f32;
    var phi_5701_: f32;
    var phi_5708_: f32;
    var phi_5713_: f32;
    var phi_5718_: f32;
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
    var phi_5892_: f32;
    var phi_5963_: f32;
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
    var phi_6034_: f32;
    var phi_6040_: f32;
    var phi_6047_: f32;
    var phi_6058_: f32;
    var phi_6068_: f32;
    var phi_6141_: f32;
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
    var phi_6212_: f32;
    var phi_6218_: f32;
    var phi_6225_: f32;
    var phi_6236_: f32;
    var phi_6246_: f32;
    var phi_6250_: bool;
    var phi_6495_: f32;
    var phi_6502_: f32;
    var phi_6507_: f32;
    var phi_6514_: f32;
    var phi_6519_: f32;
    var phi_6532_: f32;
    var phi_6539_: f32;
    var phi_6544_: f32;
    var phi_6551_: f32;
    var phi_6556_: f32;
    var phi_6561_: f32;
    var phi_6578_: f32;
    var phi_6585_: f32;
    var phi_6590_: f32;
    var phi_6597_: f32;
    var phi_6602_: f32;
    var phi_6616_: f32;
    var phi_6623_: f32;
    var phi_6628_: f32;
    var phi_6635_: f32;
    var phi_6640_: f32;
    var phi_6645_: f32;
    var phi_6662_: f32;
    var phi_6669_: f32;
    var phi_6674_: f32;
    var phi_6681_: f32;
    var phi_6686_: f32;
    var phi_6700_: f32;
    var phi_6707_: f32;
    var phi_6712_: f32;
    var phi_6719_: f32;
    var phi_6724_: f32;
    var phi_6729_: f32;
    var phi_6760_: f32;
    var phi_6766_: f32;
    var phi_6773_: f32;
    var phi_6780_: f32;
    var phi_6786_: f32;
    var phi_6793_: f32;
    var phi_6799_: f32;
    var phi_6805_: f32;
    var phi_6811_: f32;
    var phi_6818_: f32;
    var phi_6825_: f32;
    var phi_6849_: f32;
    var phi_6854_: f32;
    var phi_6859_: f32;
    var phi_6864_: f32;
    var phi_6869_: f32;
    var phi_6874_: f32;
    var phi_6884_: f32;
    var phi_7087_: f32;
    var phi_7094_: f32;
    var phi_7099_: f32;
    var phi_7106_: f32;
    var phi_7111_: f32;
    var phi_7124_: f32;
    var phi_7131_: f32;
    var phi_7136_: f32;
    var phi_7143_: f32;
    var phi_7148_: f32;
    var phi_7153_: f32;
    var phi_7170_: f32;
    var phi_7177_: f32;
    var phi_7182_: f32;
    var phi_7189_: f32;
    var phi_7194_: f32;
    var phi_7208_: f32;
    var phi_7215_: f32;
    var phi_7220_: f32;
    var phi_7227_: f32;
    var phi_7232_: f32;
    var phi_7237_: f32;
    var phi_7254_: f32;
    var phi_7261_: f32;
    var phi_7266_: f32;
    var phi_7273_: f32;
    var phi_7278_: f32;
    var phi_7292_: f32;
    var phi_7299_: f32;
    var phi_7304_: f32;
    var phi_7311_: f32;
    var phi_7316_: f32;
    var phi_7321_: f32;
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
    var phi_7465_: f32;
    var phi_7471_: f32;
    var phi_7477_: f32;
    var phi_7484_: f32;
    var phi_7495_: f32;
    var phi_7566_: f32;
    var phi_7571_: f32;
    var phi_7576_: f32;
    var phi_7581_: f32;
    var phi_7586_: f32;
    var phi_7591_: f32;
    var phi_7596_: f32;
    var phi_7601_: f32;
    var phi_7606_: f32;
    var phi_7611_: f32;
    var phi_7616_: f32;
    var phi_7621_: f32;
    var phi_7626_: f32;
    var phi_7631_: f32;
    var phi_7637_: f32;
    var phi_7643_: f32;
    var phi_7650_: f32;
    var phi_7661_: f32;
    var phi_7671_: f32;
    var phi_7744_: f32;
    var phi_7749_: f32;
    var phi_7754_: f32;
    var phi_7759_: f32;
    var phi_7764_: f32;
    var phi_7769_: f32;
    var phi_7774_: f32;
    var phi_7779_: f32;
    var phi_7784_: f32;
    var phi_7789_: f32;
    var phi_7794_: f32;
    var phi_7799_: f32;
    var phi_7804_: f32;
    var phi_7809_: f32;
    var phi_7815_: f32;
    var phi_7821_: f32;
    var phi_7828_: f32;
    var phi_7839_: f32;
    var phi_7849_: f32;
    var phi_7853_: bool;
    var phi_7855_: bool;
    var phi_7857_: bool;
    var phi_7868_: bool;
    var phi_7869_: bool;
    var phi_7919_: type_9;
    var phi_7920_: type_9;
    var phi_7943_: type_9;
    var phi_7966_: u32;
    var phi_8040_: bool;
    var phi_8041_: bool;
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
            let _e4926 = local_3;
            phi_946_ = _e4926;
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
                        phi_1837_ = u32();
                        phi_1838_ = false;
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
                            if (_e507.member[0] == _e505.member[0]) {
                                phi_1051_ = true;
                            } else {
                                phi_1051_ = (_e507.member[0] == _e505.member[0]);
                            }
                            let _e524 = phi_1051_;
                            if (_e507.member[1] == _e505.member[0]) {
                                phi_1058_ = true;
                            } else {
                                phi_1058_ = (_e507.member[1] == _e505.member[0]);
                            }
                            let _e529 = phi_1058_;
                            if (_e507.member[2] == _e505.member[0]) {
                                phi_1066_ = true;
                            } else {
                                phi_1066_ = (_e507.member[2] == _e505.member[0]);
                            }
                            let _e535 = phi_1066_;
                            if ((_e524 || _e529) || _e535) {
                                phi_1089_ = false;
                            } else {
                                phi_1089_ = true;
                            }
                            let _e538 = phi_1089_;
                            phi_1090_ = _e538;
                        } else {
                            phi_1090_ = true;
                        }
                        let _e540 = phi_1090_;
                        if _e540 {
                            let _e542 = params.member.member.member_1;
                            if ((_e542 & 2u) != 0u) {
                                let _e546 = params.member.member.member_1;
                                let _e552 = bodies.member[_e505.member[0]];
                                let _e556 = bodies.member[_e507.member[0]];
                                if ((_e552 / 2u) != (_e556 / 2u)) {
                                    phi_1136_ = true;
                                } else {
                                    phi_1136_ = ((_e546 & 4u) != 0u);
                                }
                                let _e561 = phi_1136_;
                                if _e561 {
                                    phi_1143_ = (((_e552 & _e556) & 1u) == 0u);
                                } else {
                                    phi_1143_ = false;
                                }
                                let _e566 = phi_1143_;
                                phi_1147_ = _e566;
                            } else {
                                phi_1147_ = true;
                            }
                            let _e568 = phi_1147_;
                            if _e568 {
                                let _e570 = params.member.member.member_1;
                                if ((_e570 & 32u) != 0u) {
                                    let _e574 = params.member.member.member_6;
                                    let _e615 = (((((_e509.member_1[0] - _e511.member[0]) > _e574) && ((_e511.member_1[0] - _e509.member[0]) > _e574)) && (((_e509.member_1[1] - _e511.member[1]) > _e574) && ((_e511.member_1[1] - _e509.member[1]) > _e574))) && (((_e509.member_1[2] - _e511.member[2]) > _e574) && ((_e511.member_1[2] - _e509.member[2]) > _e574)));
                                    if _e615 {
                                        phi_1761_ = bool();
                                    } else {
                                        let _e619 = keys.member[_e505.member[0]];
                                        let _e624 = keys.member[_e505.member[1]];
                                        let _e626 = function_(_e619[0], _e624[0]);
                                        let _e630 = keys.member[_e505.member[2]];
                                        let _e632 = function_(_e626, _e630[0]);
                                        let _e636 = keys.member[_e507.member[0]];
                                        let _e641 = keys.member[_e507.member[1]];
                                        let _e643 = function_1(_e636[3], _e641[3]);
                                        let _e647 = keys.member[_e507.member[2]];
                                        let _e649 = function_1(_e643, _e647[3]);
                                        if (_e632[1] > _e649[1]) {
                                            phi_1284_ = true;
                                        } else {
                                            if (_e632[1] == _e649[1]) {
                                                phi_1283_ = (_e632[0] > _e649[0]);
                                            } else {
                                                phi_1283_ = false;
                                            }
                                            let _e660 = phi_1283_;
                                            phi_1284_ = _e660;
                                        }
                                        let _e662 = phi_1284_;
                                        let _e667 = keys.member[_e507.member[0]];
                                        let _e672 = keys.member[_e507.member[1]];
                                        let _e674 = function_(_e667[0], _e672[0]);
                                        let _e678 = keys.member[_e507.member[2]];
                                        let _e680 = function_(_e674, _e678[0]);
                                        let _e684 = keys.member[_e505.member[0]];
                                        let _e689 = keys.member[_e505.member[1]];
                                        let _e691 = function_1(_e684[3], _e689[3]);
                                        let _e695 = keys.member[_e505.member[2]];
                                        let _e697 = function_1(_e691, _e695[3]);
                                        if (_e680[1] > _e697[1]) {
                                            phi_1378_ = true;
                                        } else {
                                            if (_e680[1] == _e697[1]) {
                                                phi_1377_ = (_e680[0] > _e697[0]);
                                            } else {
                                                phi_1377_ = false;
                                            }
                                            let _e708 = phi_1377_;
                                            phi_1378_ = _e708;
                                        }
                                        let _e710 = phi_1378_;
                                        let _e716 = keys.member[_e505.member[0]];
                                        let _e721 = keys.member[_e505.member[1]];
                                        let _e723 = function_2(_e716[1], _e721[1]);
                                        let _e727 = keys.member[_e505.member[2]];
                                        let _e729 = function_2(_e723, _e727[1]);
                                        let _e733 = keys.member[_e507.member[0]];
                                        let _e738 = keys.member[_e507.member[1]];
                                        let _e740 = function_3(_e733[4], _e738[4]);
                                        let _e744 = keys.member[_e507.member[2]];
                                        let _e746 = function_3(_e740, _e744[4]);
                                        if (_e729[1] > _e746[1]) {
                                            phi_1473_ = true;
                                        } else {
                                            if (_e729[1] == _e746[1]) {
                                                phi_1472_ = (_e729[0] > _e746[0]);
                                            } else {
                                                phi_1472_ = false;
                                            }
                                            let _e757 = phi_1472_;
                                            phi_1473_ = _e757;
                                        }
                                        let _e759 = phi_1473_;
                                        let _e764 = keys.member[_e507.member[0]];
                                        let _e769 = keys.member[_e507.member[1]];
                                        let _e771 = function_2(_e764[1], _e769[1]);
                                        let _e775 = keys.member[_e507.member[2]];
                                        let _e777 = function_2(_e771, _e775[1]);
                                        let _e781 = keys.member[_e505.member[0]];
                                        let _e786 = keys.member[_e505.member[1]];
                                        let _e788 = function_3(_e781[4], _e786[4]);
                                        let _e792 = keys.member[_e505.member[2]];
                                        let _e794 = function_3(_e788, _e792[4]);
                                        if (_e777[1] > _e794[1]) {
                                            phi_1567_ = true;
                                        } else {
                                            if (_e777[1] == _e794[1]) {
                                                phi_1566_ = (_e777[0] > _e794[0]);
                                            } else {
                                                phi_1566_ = false;
                                            }
                                            let _e805 = phi_1566_;
                                            phi_1567_ = _e805;
                                        }
                                        let _e807 = phi_1567_;
                                        let _e814 = keys.member[_e505.member[0]];
                                        let _e819 = keys.member[_e505.member[1]];
                                        let _e821 = function_4(_e814[2], _e819[2]);
                                        let _e825 = keys.member[_e505.member[2]];
                                        let _e827 = function_4(_e821, _e825[2]);
                                        let _e831 = keys.member[_e507.member[0]];
                                        let _e836 = keys.member[_e507.member[1]];
                                        let _e838 = function_5(_e831[5], _e836[5]);
                                        let _e842 = keys.member[_e507.member[2]];
                                        let _e844 = function_5(_e838, _e842[5]);
                                        if (_e827[1] > _e844[1]) {
                                            phi_1663_ = true;
                                        } else {
                                            if (_e827[1] == _e844[1]) {
                                                phi_1662_ = (_e827[0] > _e844[0]);
                                            } else {
                                                phi_1662_ = false;
                                            }
                                            let _e855 = phi_1662_;
                                            phi_1663_ = _e855;
                                        }
                                        let _e857 = phi_1663_;
                                        let _e862 = keys.member[_e507.member[0]];
                                        let _e867 = keys.member[_e507.member[1]];
                                        let _e869 = function_4(_e862[2], _e867[2]);
                                        let _e873 = keys.member[_e507.member[2]];
                                        let _e875 = function_4(_e869, _e873[2]);
                                        let _e879 = keys.member[_e505.member[0]];
                                        let _e884 = keys.member[_e505.member[1]];
                                        let _e886 = function_5(_e879[5], _e884[5]);
                                        let _e890 = keys.member[_e505.member[2]];
                                        let _e892 = function_5(_e886, _e890[5]);
                                        if (_e875[1] > _e892[1]) {
                                            phi_1757_ = true;
                                        } else {
                                            if (_e875[1] == _e892[1]) {
                                                phi_1756_ = (_e875[0] > _e892[0]);
                                            } else {
                                                phi_1756_ = false;
                                            }
                                            let _e903 = phi_1756_;
                                            phi_1757_ = _e903;
                                        }
                                        let _e905 = phi_1757_;
                                        phi_1761_ = (((!(_e662) && !(_e710)) && (!(_e759) && !(_e807))) && (!(_e857) && !(_e905)));
                                    }
                                    let _e910 = phi_1761_;
                                    phi_1762_ = _e910;
                                    phi_1763_ = _e615;
                                } else {
                                    phi_1762_ = bool();
                                    phi_1763_ = true;
                                }
                                let _e912 = phi_1762_;
                                let _e914 = phi_1763_;
                                if _e914 {
                                    phi_1767_ = false;
                                } else {
                                    phi_1767_ = true;
                                }
                                let _e916 = phi_1767_;
                                phi_1768_ = _e912;
                                phi_1769_ = _e916;
                            } else {
                                phi_1768_ = false;
                                phi_1769_ = true;
                            }
                            let _e918 = phi_1768_;
                            let _e920 = phi_1769_;
                            phi_1770_ = _e918;
                            phi_1771_ = _e920;
                        } else {
                            phi_1770_ = false;
                            phi_1771_ = true;
                        }
                        let _e922 = phi_1770_;
                        let _e924 = phi_1771_;
                        if _e924 {
                            phi_1775_ = _e922;
                        } else {
                            phi_1775_ = true;
                        }
                        let _e926 = phi_1775_;
                        if _e926 {
                            let _e929 = params.member.member_1.member_3;
                            let _e933 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e933 + 1u) < _e933) {
                                let _e937 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e933 < _e929) {
                                let _e939 = (2u * _e933);
                                atomicStore((&output.member[(4u + _e939)]), _e505.member_1);
                                atomicStore((&output.member[(_e939 + 5u)]), _e507.member_1);
                            }
                            let _e945 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e945 + 1u) < _e945) {
                                let _e949 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1837_ = (_e474 & (_e474 - 1u));
                        phi_1838_ = true;
                    }
                    let _e951 = phi_1837_;
                    let _e953 = phi_1838_;
                    phi_947_ = _e951;
                    phi_1839_ = _e953;
                } else {
                    phi_947_ = u32();
                    phi_1839_ = false;
                }
                let _e955 = phi_947_;
                let _e957 = phi_1839_;
                continue;
                continuing {
                    phi_943_ = _e486;
                    phi_946_ = _e955;
                    break if !(_e957);
                }
            }
            workgroupBarrier();
            let _e960 = atomicLoad((&counters[4u]));
            if (2048u < _e960) {
                phi_1846_ = 2048u;
            } else {
                phi_1846_ = _e960;
            }
            let _e963 = phi_1846_;
            phi_1849_ = type_9(0u, 16u);
            loop {
                let _e965 = phi_1849_;
                if (_e965.member < _e965.member_1) {
                    phi_1850_ = type_9((_e965.member + 1u), _e965.member_1);
                    phi_1873_ = type_9(1u, _e965.member);
                } else {
                    phi_1850_ = _e965;
                    phi_1873_ = type_9(0u, type_9().member_1);
                }
                let _e977 = phi_1850_;
                let _e979 = phi_1873_;
                if (bitcast<i32>(_e979.member) != 0i) {
                    let _e985 = (_e67 + (_e979.member_1 * 128u));
                    if (_e985 >= _e963) {
                        phi_7868_ = false;
                    } else {
                        let _e988 = hits[_e985];
                        let _e991 = ((_e988 >> bitcast<u32>(10i)) & 3u);
                        let _e998 = firsts[(2u * _e991)];
                        let _e999 = (_e998 + ((_e988 >> bitcast<u32>(5i)) & 31u));
                        let _e1003 = firsts[((2u * _e991) + 1u)];
                        let _e1004 = (_e1003 + (_e988 & 31u));
                        let _e1006 = leaves.member[_e999];
                        let _e1008 = leaves.member[_e1004];
                        let _e1010 = nodes.member[_e999];
                        let _e1012 = nodes.member[_e1004];
                        let _e1015 = params.member.member.member_1;
                        if ((_e1015 & 1u) != 0u) {
                            if (_e1008.member[0] == _e1006.member[0]) {
                                phi_1963_ = true;
                            } else {
                                phi_1963_ = (_e1008.member[0] == _e1006.member[0]);
                            }
                            let _e1025 = phi_1963_;
                            if (_e1008.member[1] == _e1006.member[0]) {
                                phi_1970_ = true;
                            } else {
                                phi_1970_ = (_e1008.member[1] == _e1006.member[0]);
                            }
                            let _e1030 = phi_1970_;
                            if (_e1008.member[2] == _e1006.member[0]) {
                                phi_1978_ = true;
                            } else {
                                phi_1978_ = (_e1008.member[2] == _e1006.member[0]);
                            }
                            let _e1036 = phi_1978_;
                            if ((_e1025 || _e1030) || _e1036) {
                                phi_2001_ = false;
                            } else {
                                phi_2001_ = true;
                            }
                            let _e1039 = phi_2001_;
                            phi_2002_ = _e1039;
                        } else {
                            phi_2002_ = true;
                        }
                        let _e1041 = phi_2002_;
                        if _e1041 {
                            let _e1043 = params.member.member.member_1;
                            if ((_e1043 & 2u) != 0u) {
                                let _e1047 = params.member.member.member_1;
                                let _e1053 = bodies.member[_e1006.member[0]];
                                let _e1057 = bodies.member[_e1008.member[0]];
                                if ((_e1053 / 2u) != (_e1057 / 2u)) {
                                    phi_2048_ = true;
                                } else {
                                    phi_2048_ = ((_e1047 & 4u) != 0u);
                                }
                                let _e1062 = phi_2048_;
                                if _e1062 {
                                    phi_2055_ = (((_e1053 & _e1057) & 1u) == 0u);
                                } else {
                                    phi_2055_ = false;
                                }
                                let _e1067 = phi_2055_;
                                phi_2059_ = _e1067;
                            } else {
                                phi_2059_ = true;
                            }
                            let _e1069 = phi_2059_;
                            if _e1069 {
                                let _e1071 = params.member.member.member_1;
                                if ((_e1071 & 32u) != 0u) {
                                    let _e1075 = params.member.member.member_6;
                                    let _e1116 = (((((_e1010.member_1[0] - _e1012.member[0]) > _e1075) && ((_e1012.member_1[0] - _e1010.member[0]) > _e1075)) && (((_e1010.member_1[1] - _e1012.member[1]) > _e1075) && ((_e1012.member_1[1] - _e1010.member[1]) > _e1075))) && (((_e1010.member_1[2] - _e1012.member[2]) > _e1075) && ((_e1012.member_1[2] - _e1010.member[2]) > _e1075)));
                                    if _e1116 {
                                        phi_2673_ = bool();
                                    } else {
                                        let _e1120 = keys.member[_e1006.member[0]];
                                        let _e1125 = keys.member[_e1006.member[1]];
                                        let _e1127 = function_(_e1120[0], _e1125[0]);
                                        let _e1131 = keys.member[_e1006.member[2]];
                                        let _e1133 = function_(_e1127, _e1131[0]);
                                        let _e1137 = keys.member[_e1008.member[0]];
                                        let _e1142 = keys.member[_e1008.member[1]];
                                        let _e1144 = function_1(_e1137[3], _e1142[3]);
                                        let _e1148 = keys.member[_e1008.member[2]];
                                        let _e1150 = function_1(_e1144, _e1148[3]);
                                        if (_e1133[1] > _e1150[1]) {
                                            phi_2196_ = true;
                                        } else {
                                            if (_e1133[1] == _e1150[1]) {
                                                phi_2195_ = (_e1133[0] > _e1150[0]);
                                            } else {
                                                phi_2195_ = false;
                                            }
                                            let _e1161 = phi_2195_;
                                            phi_2196_ = _e1161;
                                        }
                                        let _e1163 = phi_2196_;
                                        let _e1168 = keys.member[_e1008.member[0]];
                                        let _e1173 = keys.member[_e1008.member[1]];
                                        let _e1175 = function_(_e1168[0], _e1173[0]);
                                        let _e1179 = keys.member[_e1008.member[2]];
                                        let _e1181 = function_(_e1175, _e1179[0]);
                                        let _e1185 = keys.member[_e1006.member[0]];
                                        let _e1190 = keys.member[_e1006.member[1]];
                                        let _e1192 = function_1(_e1185[3], _e1190[3]);
                                        let _e1196 = keys.member[_e1006.member[2]];
                                        let _e1198 = function_1(_e1192, _e1196[3]);
                                        if (_e1181[1] > _e1198[1]) {
                                            phi_2290_ = true;
                                        } else {
                                            if (_e1181[1] == _e1198[1]) {
                                                phi_2289_ = (_e1181[0] > _e1198[0]);
                                            } else {
                                                phi_2289_ = false;
                                            }
                                            let _e1209 = phi_2289_;
                                            phi_2290_ = _e1209;
                                        }
                                        let _e1211 = phi_2290_;
                                        let _e1217 = keys.member[_e1006.member[0]];
                                        let _e1222 = keys.member[_e1006.member[1]];
                                        let _e1224 = function_2(_e1217[1], _e1222[1]);
                                        let _e1228 = keys.member[_e1006.member[2]];
                                        let _e1230 = function_2(_e1224, _e1228[1]);
                                        let _e1234 = keys.member[_e1008.member[0]];
                                        let _e1239 = keys.member[_e1008.member[1]];
                                        let _e1241 = function_3(_e1234[4], _e1239[4]);
                                        let _e1245 = keys.member[_e1008.member[2]];
                                        let _e1247 = function_3(_e1241, _e1245[4]);
                                        if (_e1230[1] > _e1247[1]) {
                                            phi_2385_ = true;
                                        } else {
                                            if (_e1230[1] == _e1247[1]) {
                                                phi_2384_ = (_e1230[0] > _e1247[0]);
                                            } else {
                                                phi_2384_ = false;
                                            }
                                            let _e1258 = phi_2384_;
                                            phi_2385_ = _e1258;
                                        }
                                        let _e1260 = phi_2385_;
                                        let _e1265 = keys.member[_e1008.member[0]];
                                        let _e1270 = keys.member[_e1008.member[1]];
                                        let _e1272 = function_2(_e1265[1], _e1270[1]);
                                        let _e1276 = keys.member[_e1008.member[2]];
                                        let _e1278 = function_2(_e1272, _e1276[1]);
                                        let _e1282 = keys.member[_e1006.member[0]];
                                        let _e1287 = keys.member[_e1006.member[1]];
                                        let _e1289 = function_3(_e1282[4], _e1287[4]);
                                        let _e1293 = keys.member[_e1006.member[2]];
                                        let _e1295 = function_3(_e1289, _e1293[4]);
                                        if (_e1278[1] > _e1295[1]) {
                                            phi_2479_ = true;
                                        } else {
                                            if (_e1278[1] == _e1295[1]) {
                                                phi_2478_ = (_e1278[0] > _e1295[0]);
                                            } else {
                                                phi_2478_ = false;
                                            }
                                            let _e1306 = phi_2478_;
                                            phi_2479_ = _e1306;
                                        }
                                        let _e1308 = phi_2479_;
                                        let _e1315 = keys.member[_e1006.member[0]];
                                        let _e1320 = keys.member[_e1006.member[1]];
                                        let _e1322 = function_4(_e1315[2], _e1320[2]);
                                        let _e1326 = keys.member[_e1006.member[2]];
                                        let _e1328 = function_4(_e1322, _e1326[2]);
                                        let _e1332 = keys.member[_e1008.member[0]];
                                        let _e1337 = keys.member[_e1008.member[1]];
                                        let _e1339 = function_5(_e1332[5], _e1337[5]);
                                        let _e1343 = keys.member[_e1008.member[2]];
                                        let _e1345 = function_5(_e1339, _e1343[5]);
                                        if (_e1328[1] > _e1345[1]) {
                                            phi_2575_ = true;
                                        } else {
                                            if (_e1328[1] == _e1345[1]) {
                                                phi_2574_ = (_e1328[0] > _e1345[0]);
                                            } else {
                                                phi_2574_ = false;
                                            }
                                            let _e1356 = phi_2574_;
                                            phi_2575_ = _e1356;
                                        }
                                        let _e1358 = phi_2575_;
                                        let _e1363 = keys.member[_e1008.member[0]];
                                        let _e1368 = keys.member[_e1008.member[1]];
                                        let _e1370 = function_4(_e1363[2], _e1368[2]);
                                        let _e1374 = keys.member[_e1008.member[2]];
                                        let _e1376 = function_4(_e1370, _e1374[2]);
                                        let _e1380 = keys.member[_e1006.member[0]];
                                        let _e1385 = keys.member[_e1006.member[1]];
                                        let _e1387 = function_5(_e1380[5], _e1385[5]);
                                        let _e1391 = keys.member[_e1006.member[2]];
                                        let _e1393 = function_5(_e1387, _e1391[5]);
                                        if (_e1376[1] > _e1393[1]) {
                                            phi_2669_ = true;
                                        } else {
                                            if (_e1376[1] == _e1393[1]) {
                                                phi_2668_ = (_e1376[0] > _e1393[0]);
                                            } else {
                                                phi_2668_ = false;
                                            }
                                            let _e1404 = phi_2668_;
                                            phi_2669_ = _e1404;
                                        }
                                        let _e1406 = phi_2669_;
                                        phi_2673_ = (((!(_e1163) && !(_e1211)) && (!(_e1260) && !(_e1308))) && (!(_e1358) && !(_e1406)));
                                    }
                                    let _e1411 = phi_2673_;
                                    phi_2674_ = _e1411;
                                    phi_2675_ = _e1116;
                                } else {
                                    phi_2674_ = bool();
                                    phi_2675_ = true;
                                }
                                let _e1413 = phi_2674_;
                                let _e1415 = phi_2675_;
                                if _e1415 {
                                    phi_2679_ = false;
                                } else {
                                    phi_2679_ = true;
                                }
                                let _e1417 = phi_2679_;
                                phi_2680_ = _e1413;
                                phi_2681_ = _e1417;
                            } else {
                                phi_2680_ = false;
                                phi_2681_ = true;
                            }
                            let _e1419 = phi_2680_;
                            let _e1421 = phi_2681_;
                            phi_2682_ = _e1419;
                            phi_2683_ = _e1421;
                        } else {
                            phi_2682_ = false;
                            phi_2683_ = true;
                        }
                        let _e1423 = phi_2682_;
                        let _e1425 = phi_2683_;
                        if _e1425 {
                            phi_2687_ = _e1423;
                        } else {
                            phi_2687_ = true;
                        }
                        let _e1427 = phi_2687_;
                        if _e1427 {
                            let _e1429 = atomicAdd((&counters[7u]), 1u);
                            let _e1432 = params.member.member.member_4;
                            let _e1434 = params.member.member.member_5;
                            let _e1444 = paths.member[_e1006.member[0]];
                            let _e1446 = paths.member[_e1008.member[0]];
                            let _e1452 = paths.member[_e1008.member[1]];
                            let _e1454 = paths.member[_e1008.member[2]];
                            local_2 = type_37(array<array<f32, 3>, 2>(array<f32, 3>((_e1444.member[0] - _e1446.member[0]), (_e1444.member[1] - _e1446.member[1]), (_e1444.member[2] - _e1446.member[2])), array<f32, 3>((_e1444.member_1[0] - _e1446.member_1[0]), (_e1444.member_1[1] - _e1446.member_1[1]), (_e1444.member_1[2] - _e1446.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1452.member[0] - _e1446.member[0]), (_e1452.member[1] - _e1446.member[1]), (_e1452.member[2] - _e1446.member[2])), array<f32, 3>((_e1452.member_1[0] - _e1446.member_1[0]), (_e1452.member_1[1] - _e1446.member_1[1]), (_e1452.member_1[2] - _e1446.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1454.member[0] - _e1446.member[0]), (_e1454.member[1] - _e1446.member[1]), (_e1454.member[2] - _e1446.member[2])), array<f32, 3>((_e1454.member_1[0] - _e1446.member_1[0]), (_e1454.member_1[1] - _e1446.member_1[1]), (_e1454.member_1[2] - _e1446.member_1[2]))), (_e1432 + _e1432));
                            let _e1514 = local_2.member_1[0u];
                            let _e1520 = local_2.member_2[0u];
                            let _e1526 = ((_e1514[1] * _e1520[2]) - (_e1514[2] * _e1520[1]));
                            let _e1529 = ((_e1514[2] * _e1520[0]) - (_e1514[0] * _e1520[2]));
                            let _e1532 = ((_e1514[0] * _e1520[1]) - (_e1514[1] * _e1520[0]));
                            let _e1535 = local_2.member_1[1u];
                            let _e1541 = local_2.member_2[1u];
                            let _e1547 = ((_e1535[1] * _e1541[2]) - (_e1535[2] * _e1541[1]));
                            let _e1550 = ((_e1535[2] * _e1541[0]) - (_e1535[0] * _e1541[2]));
                            let _e1553 = ((_e1535[0] * _e1541[1]) - (_e1535[1] * _e1541[0]));
                            let _e1556 = local_2.member_1[0u];
                            let _e1562 = local_2.member_2[1u];
                            let _e1577 = local_2.member_1[1u];
                            let _e1583 = local_2.member_2[0u];
                            let _e1596 = (((_e1556[1] * _e1562[2]) - (_e1556[2] * _e1562[1])) + ((_e1577[1] * _e1583[2]) - (_e1577[2] * _e1583[1])));
                            let _e1597 = (((_e1556[2] * _e1562[0]) - (_e1556[0] * _e1562[2])) + ((_e1577[2] * _e1583[0]) - (_e1577[0] * _e1583[2])));
                            let _e1598 = (((_e1556[0] * _e1562[1]) - (_e1556[1] * _e1562[0])) + ((_e1577[0] * _e1583[1]) - (_e1577[1] * _e1583[0])));
                            let _e1601 = local_2.member[0u];
                            let _e1612 = local_2.member[1u];
                            let _e1623 = local_2.member[0u];
                            let _e1632 = ((((_e1612[0] * _e1526) + (_e1612[1] * _e1529)) + (_e1612[2] * _e1532)) + (((_e1623[0] * _e1596) + (_e1623[1] * _e1597)) + (_e1623[2] * _e1598)));
                            let _e1635 = local_2.member[0u];
                            let _e1646 = local_2.member[1u];
                            let _e1655 = ((((_e1635[0] * _e1547) + (_e1635[1] * _e1550)) + (_e1635[2] * _e1553)) + (((_e1646[0] * _e1596) + (_e1646[1] * _e1597)) + (_e1646[2] * _e1598)));
                            let _e1658 = local_2.member[1u];
                            let _e1669 = local_2.member[0u];
                            if (_e1669[0] < 0f) {
                                phi_3082_ = -(_e1669[0]);
                            } else {
                                phi_3082_ = _e1669[0];
                            }
                            let _e1676 = phi_3082_;
                            if (_e1669[1] < 0f) {
                                phi_3089_ = -(_e1669[1]);
                            } else {
                                phi_3089_ = _e1669[1];
                            }
                            let _e1680 = phi_3089_;
                            if (_e1676 > _e1680) {
                                phi_3094_ = _e1676;
                            } else {
                                phi_3094_ = _e1680;
                            }
                            let _e1683 = phi_3094_;
                            if (_e1669[2] < 0f) {
                                phi_3101_ = -(_e1669[2]);
                            } else {
                                phi_3101_ = _e1669[2];
                            }
                            let _e1687 = phi_3101_;
                            if (_e1683 > _e1687) {
                                phi_3106_ = _e1683;
                            } else {
                                phi_3106_ = _e1687;
                            }
                            let _e1690 = phi_3106_;
                            let _e1693 = local_2.member[1u];
                            if (_e1693[0] < 0f) {
                                phi_3119_ = -(_e1693[0]);
                            } else {
                                phi_3119_ = _e1693[0];
                            }
                            let _e1700 = phi_3119_;
                            if (_e1693[1] < 0f) {
                                phi_3126_ = -(_e1693[1]);
                            } else {
                                phi_3126_ = _e1693[1];
                            }
                            let _e1704 = phi_3126_;
                            if (_e1700 > _e1704) {
                                phi_3131_ = _e1700;
                            } else {
                                phi_3131_ = _e1704;
                            }
                            let _e1707 = phi_3131_;
                            if (_e1693[2] < 0f) {
                                phi_3138_ = -(_e1693[2]);
                            } else {
                                phi_3138_ = _e1693[2];
                            }
                            let _e1711 = phi_3138_;
                            if (_e1707 > _e1711) {
                                phi_3143_ = _e1707;
                            } else {
                                phi_3143_ = _e1711;
                            }
                            let _e1714 = phi_3143_;
                            if (_e1690 > _e1714) {
                                phi_3148_ = _e1690;
                            } else {
                                phi_3148_ = _e1714;
                            }
                            let _e1717 = phi_3148_;
                            let _e1719 = local_2.member_3;
                            let _e1720 = (_e1717 + _e1719);
                            let _e1723 = local_2.member_1[0u];
                            if (_e1723[0] < 0f) {
                                phi_3165_ = -(_e1723[0]);
                            } else {
                                phi_3165_ = _e1723[0];
                            }
                            let _e1730 = phi_3165_;
                            if (_e1723[1] < 0f) {
                                phi_3172_ = -(_e1723[1]);
                            } else {
                                phi_3172_ = _e1723[1];
                            }
                            let _e1734 = phi_3172_;
                            if (_e1730 > _e1734) {
                                phi_3177_ = _e1730;
                            } else {
                                phi_3177_ = _e1734;
                            }
                            let _e1737 = phi_3177_;
                            if (_e1723[2] < 0f) {
                                phi_3184_ = -(_e1723[2]);
                            } else {
                                phi_3184_ = _e1723[2];
                            }
                            let _e1741 = phi_3184_;
                            if (_e1737 > _e1741) {
                                phi_3189_ = _e1737;
                            } else {
                                phi_3189_ = _e1741;
                            }
                            let _e1744 = phi_3189_;
                            let _e1747 = local_2.member_1[1u];
                            if (_e1747[0] < 0f) {
                                phi_3203_ = -(_e1747[0]);
                            } else {
                                phi_3203_ = _e1747[0];
                            }
                            let _e1754 = phi_3203_;
                            if (_e1747[1] < 0f) {
                                phi_3210_ = -(_e1747[1]);
                            } else {
                                phi_3210_ = _e1747[1];
                            }
                            let _e1758 = phi_3210_;
                            if (_e1754 > _e1758) {
                                phi_3215_ = _e1754;
                            } else {
                                phi_3215_ = _e1758;
                            }
                            let _e1761 = phi_3215_;
                            if (_e1747[2] < 0f) {
                                phi_3222_ = -(_e1747[2]);
                            } else {
                                phi_3222_ = _e1747[2];
                            }
                            let _e1765 = phi_3222_;
                            if (_e1761 > _e1765) {
                                phi_3227_ = _e1761;
                            } else {
                                phi_3227_ = _e1765;
                            }
                            let _e1768 = phi_3227_;
                            if (_e1744 > _e1768) {
                                phi_3232_ = _e1744;
                            } else {
                                phi_3232_ = _e1768;
                            }
                            let _e1771 = phi_3232_;
                            let _e1773 = local_2.member_3;
                            let _e1774 = (_e1771 + _e1773);
                            let _e1777 = local_2.member_2[0u];
                            if (_e1777[0] < 0f) {
                                phi_3249_ = -(_e1777[0]);
                            } else {
                                phi_3249_ = _e1777[0];
                            }
                            let _e1784 = phi_3249_;
                            if (_e1777[1] < 0f) {
                                phi_3256_ = -(_e1777[1]);
                            } else {
                                phi_3256_ = _e1777[1];
                            }
                            let _e1788 = phi_3256_;
                            if (_e1784 > _e1788) {
                                phi_3261_ = _e1784;
                            } else {
                                phi_3261_ = _e1788;
                            }
                            let _e1791 = phi_3261_;
                            if (_e1777[2] < 0f) {
                                phi_3268_ = -(_e1777[2]);
                            } else {
                                phi_3268_ = _e1777[2];
                            }
                            let _e1795 = phi_3268_;
                            if (_e1791 > _e1795) {
                                phi_3273_ = _e1791;
                            } else {
                                phi_3273_ = _e1795;
                            }
                            let _e1798 = phi_3273_;
                            let _e1801 = local_2.member_2[1u];
                            if (_e1801[0] < 0f) {
                                phi_3287_ = -(_e1801[0]);
                            } else {
                                phi_3287_ = _e1801[0];
                            }
                            let _e1808 = phi_3287_;
                            if (_e1801[1] < 0f) {
                                phi_3294_ = -(_e1801[1]);
                            } else {
                                phi_3294_ = _e1801[1];
                            }
                            let _e1812 = phi_3294_;
                            if (_e1808 > _e1812) {
                                phi_3299_ = _e1808;
                            } else {
                                phi_3299_ = _e1812;
                            }
                            let _e1815 = phi_3299_;
                            if (_e1801[2] < 0f) {
                                phi_3306_ = -(_e1801[2]);
                            } else {
                                phi_3306_ = _e1801[2];
                            }
                            let _e1819 = phi_3306_;
                            if (_e1815 > _e1819) {
                                phi_3311_ = _e1815;
                            } else {
                                phi_3311_ = _e1819;
                            }
                            let _e1822 = phi_3311_;
                            if (_e1798 > _e1822) {
                                phi_3316_ = _e1798;
                            } else {
                                phi_3316_ = _e1822;
                            }
                            let _e1825 = phi_3316_;
                            let _e1827 = local_2.member_3;
                            let _e1828 = (_e1825 + _e1827);
                            let _e1830 = ((_e1774 * 8f) * _e1828);
                            let _e1837 = local_2.member_3;
                            if (_e1526 < 0f) {
                                phi_3347_ = -(_e1526);
                            } else {
                                phi_3347_ = _e1526;
                            }
                            let _e1854 = phi_3347_;
                            if (_e1529 < 0f) {
                                phi_3353_ = -(_e1529);
                            } else {
                                phi_3353_ = _e1529;
                            }
                            let _e1858 = phi_3353_;
                            if (_e1532 < 0f) {
                                phi_3360_ = -(_e1532);
                            } else {
                                phi_3360_ = _e1532;
                            }
                            let _e1863 = phi_3360_;
                            let _e1864 = ((_e1854 + _e1858) + _e1863);
                            if (_e1547 < 0f) {
                                phi_3367_ = -(_e1547);
                            } else {
                                phi_3367_ = _e1547;
                            }
                            let _e1868 = phi_3367_;
                            if (_e1550 < 0f) {
                                phi_3373_ = -(_e1550);
                            } else {
                                phi_3373_ = _e1550;
                            }
                            let _e1872 = phi_3373_;
                            if (_e1553 < 0f) {
                                phi_3380_ = -(_e1553);
                            } else {
                                phi_3380_ = _e1553;
                            }
                            let _e1877 = phi_3380_;
                            let _e1878 = ((_e1868 + _e1872) + _e1877);
                            if (_e1864 > _e1878) {
                                phi_3386_ = _e1864;
                            } else {
                                phi_3386_ = _e1878;
                            }
                            let _e1881 = phi_3386_;
                            if (_e1596 < 0f) {
                                phi_3392_ = -(_e1596);
                            } else {
                                phi_3392_ = _e1596;
                            }
                            let _e1885 = phi_3392_;
                            if (_e1597 < 0f) {
                                phi_3398_ = -(_e1597);
                            } else {
                                phi_3398_ = _e1597;
                            }
                            let _e1889 = phi_3398_;
                            if (_e1598 < 0f) {
                                phi_3405_ = -(_e1598);
                            } else {
                                phi_3405_ = _e1598;
                            }
                            let _e1894 = phi_3405_;
                            let _e1896 = (((_e1885 + _e1889) + _e1894) * 0.5f);
                            if (_e1881 > _e1896) {
                                phi_3412_ = _e1881;
                            } else {
                                phi_3412_ = _e1896;
                            }
                            let _e1899 = phi_3412_;
                            let _e1904 = local_2.member_3;
                            let _e1917 = ((((_e1601[0] * _e1526) + (_e1601[1] * _e1529)) + (_e1601[2] * _e1532)) * 3f);
                            let _e1918 = ((((_e1658[0] * _e1547) + (_e1658[1] * _e1550)) + (_e1658[2] * _e1553)) * 3f);
                            if (_e1917 < _e1918) {
                                phi_3436_ = _e1917;
                            } else {
                                phi_3436_ = _e1918;
                            }
                            let _e1921 = phi_3436_;
                            if (_e1632 < _e1655) {
                                phi_3441_ = _e1632;
                            } else {
                                phi_3441_ = _e1655;
                            }
                            let _e1924 = phi_3441_;
                            if (_e1921 < _e1924) {
                                phi_3446_ = _e1921;
                            } else {
                                phi_3446_ = _e1924;
                            }
                            let _e1927 = phi_3446_;
                            if (_e1917 > _e1918) {
                                phi_3451_ = _e1917;
                            } else {
                                phi_3451_ = _e1918;
                            }
                            let _e1930 = phi_3451_;
                            if (_e1632 > _e1655) {
                                phi_3456_ = _e1632;
                            } else {
                                phi_3456_ = _e1655;
                            }
                            let _e1933 = phi_3456_;
                            if (_e1930 > _e1933) {
                                phi_3461_ = _e1930;
                            } else {
                                phi_3461_ = _e1933;
                            }
                            let _e1936 = phi_3461_;
                            let _e1941 = -(_e1936);
                            if (_e1927 > _e1941) {
                                phi_3471_ = _e1927;
                            } else {
                                phi_3471_ = _e1941;
                            }
                            let _e1944 = phi_3471_;
                            let _e1946 = ((_e1944 - ((((((_e1720 * 8f) * _e1830) * (0.000000059604645f * (524f / 64f))) + ((_e1837 * 19f) * ((_e1720 * (_e1774 + _e1828)) + (_e1774 * _e1828)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1720) * ((1f + _e1774) * (1f + _e1828))))) + ((_e1434 * (((_e1899 + (_e1830 * (0.000000059604645f * 8f))) + ((_e1904 * 6f) * (_e1774 + _e1828))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1774) * (1f + _e1828))))) * (3f * 1.0001f)))) > 0f);
                            if _e1946 {
                                phi_4440_ = _e1946;
                            } else {
                                let _e1949 = local_2.member_1[0u];
                                let _e1955 = local_2.member_1[1u];
                                let _e1959 = (_e1949[0] + _e1955[0]);
                                let _e1960 = (_e1949[1] + _e1955[1]);
                                let _e1961 = (_e1949[2] + _e1955[2]);
                                let _e1964 = local_2.member_2[0u];
                                let _e1970 = local_2.member_2[1u];
                                let _e1974 = (_e1964[0] + _e1970[0]);
                                let _e1975 = (_e1964[1] + _e1970[1]);
                                let _e1976 = (_e1964[2] + _e1970[2]);
                                let _e1979 = ((_e1960 * _e1976) - (_e1961 * _e1975));
                                let _e1982 = ((_e1961 * _e1974) - (_e1959 * _e1976));
                                let _e1985 = ((_e1959 * _e1975) - (_e1960 * _e1974));
                                let _e1988 = local_2.member[0u];
                                let _e1994 = local_2.member_1[0u];
                                let _e2000 = local_2.member_2[0u];
                                let _e2004 = (_e1988[0] - _e1994[0]);
                                let _e2005 = (_e1988[1] - _e1994[1]);
                                let _e2006 = (_e1988[2] - _e1994[2]);
                                let _e2007 = (_e1988[0] - _e2000[0]);
                                let _e2008 = (_e1988[1] - _e2000[1]);
                                let _e2009 = (_e1988[2] - _e2000[2]);
                                let _e2012 = local_2.member[1u];
                                let _e2018 = local_2.member_1[1u];
                                let _e2024 = local_2.member_2[1u];
                                let _e2028 = (_e2012[0] - _e2018[0]);
                                let _e2029 = (_e2012[1] - _e2018[1]);
                                let _e2030 = (_e2012[2] - _e2018[2]);
                                let _e2031 = (_e2012[0] - _e2024[0]);
                                let _e2032 = (_e2012[1] - _e2024[1]);
                                let _e2033 = (_e2012[2] - _e2024[2]);
                                let _e2036 = local_2.member[0u];
                                if (_e2036[0] < 0f) {
                                    phi_3674_ = -(_e2036[0]);
                                } else {
                                    phi_3674_ = _e2036[0];
                                }
                                let _e2043 = phi_3674_;
                                if (_e2036[1] < 0f) {
                                    phi_3681_ = -(_e2036[1]);
                                } else {
                                    phi_3681_ = _e2036[1];
                                }
                                let _e2047 = phi_3681_;
                                if (_e2043 > _e2047) {
                                    phi_3686_ = _e2043;
                                } else {
                                    phi_3686_ = _e2047;
                                }
                                let _e2050 = phi_3686_;
                                if (_e2036[2] < 0f) {
                                    phi_3693_ = -(_e2036[2]);
                                } else {
                                    phi_3693_ = _e2036[2];
                                }
                                let _e2054 = phi_3693_;
                                if (_e2050 > _e2054) {
                                    phi_3698_ = _e2050;
                                } else {
                                    phi_3698_ = _e2054;
                                }
                                let _e2057 = phi_3698_;
                                let _e2060 = local_2.member[1u];
                                if (_e2060[0] < 0f) {
                                    phi_3711_ = -(_e2060[0]);
                                } else {
                                    phi_3711_ = _e2060[0];
                                }
                                let _e2067 = phi_3711_;
                                if (_e2060[1] < 0f) {
                                    phi_3718_ = -(_e2060[1]);
                                } else {
                                    phi_3718_ = _e2060[1];
                                }
                                let _e2071 = phi_3718_;
                                if (_e2067 > _e2071) {
                                    phi_3723_ = _e2067;
                                } else {
                                    phi_3723_ = _e2071;
                                }
                                let _e2074 = phi_3723_;
                                if (_e2060[2] < 0f) {
                                    phi_3730_ = -(_e2060[2]);
                                } else {
                                    phi_3730_ = _e2060[2];
                                }
                                let _e2078 = phi_3730_;
                                if (_e2074 > _e2078) {
                                    phi_3735_ = _e2074;
                                } else {
                                    phi_3735_ = _e2078;
                                }
                                let _e2081 = phi_3735_;
                                if (_e2057 > _e2081) {
                                    phi_3740_ = _e2057;
                                } else {
                                    phi_3740_ = _e2081;
                                }
                                let _e2084 = phi_3740_;
                                let _e2086 = local_2.member_3;
                                let _e2090 = local_2.member_1[0u];
                                if (_e2090[0] < 0f) {
                                    phi_3757_ = -(_e2090[0]);
                                } else {
                                    phi_3757_ = _e2090[0];
                                }
                                let _e2097 = phi_3757_;
                                if (_e2090[1] < 0f) {
                                    phi_3764_ = -(_e2090[1]);
                                } else {
                                    phi_3764_ = _e2090[1];
                                }
                                let _e2101 = phi_3764_;
                                if (_e2097 > _e2101) {
                                    phi_3769_ = _e2097;
                                } else {
                                    phi_3769_ = _e2101;
                                }
                                let _e2104 = phi_3769_;
                                if (_e2090[2] < 0f) {
                                    phi_3776_ = -(_e2090[2]);
                                } else {
                                    phi_3776_ = _e2090[2];
                                }
                                let _e2108 = phi_3776_;
                                if (_e2104 > _e2108) {
                                    phi_3781_ = _e2104;
                                } else {
                                    phi_3781_ = _e2108;
                                }
                                let _e2111 = phi_3781_;
                                let _e2114 = local_2.member_1[1u];
                                if (_e2114[0] < 0f) {
                                    phi_3795_ = -(_e2114[0]);
                                } else {
                                    phi_3795_ = _e2114[0];
                                }
                                let _e2121 = phi_3795_;
                                if (_e2114[1] < 0f) {
                                    phi_3802_ = -(_e2114[1]);
                                } else {
                                    phi_3802_ = _e2114[1];
                                }
                                let _e2125 = phi_3802_;
                                if (_e2121 > _e2125) {
                                    phi_3807_ = _e2121;
                                } else {
                                    phi_3807_ = _e2125;
                                }
                                let _e2128 = phi_3807_;
                                if (_e2114[2] < 0f) {
                                    phi_3814_ = -(_e2114[2]);
                                } else {
                                    phi_3814_ = _e2114[2];
                                }
                                let _e2132 = phi_3814_;
                                if (_e2128 > _e2132) {
                                    phi_3819_ = _e2128;
                                } else {
                                    phi_3819_ = _e2132;
                                }
                                let _e2135 = phi_3819_;
                                if (_e2111 > _e2135) {
                                    phi_3824_ = _e2111;
                                } else {
                                    phi_3824_ = _e2135;
                                }
                                let _e2138 = phi_3824_;
                                let _e2140 = local_2.member_3;
                                let _e2144 = local_2.member_2[0u];
                                if (_e2144[0] < 0f) {
                                    phi_3841_ = -(_e2144[0]);
                                } else {
                                    phi_3841_ = _e2144[0];
                                }
                                let _e2151 = phi_3841_;
                                if (_e2144[1] < 0f) {
                                    phi_3848_ = -(_e2144[1]);
                                } else {
                                    phi_3848_ = _e2144[1];
                                }
                                let _e2155 = phi_3848_;
                                if (_e2151 > _e2155) {
                                    phi_3853_ = _e2151;
                                } else {
                                    phi_3853_ = _e2155;
                                }
                                let _e2158 = phi_3853_;
                                if (_e2144[2] < 0f) {
                                    phi_3860_ = -(_e2144[2]);
                                } else {
                                    phi_3860_ = _e2144[2];
                                }
                                let _e2162 = phi_3860_;
                                if (_e2158 > _e2162) {
                                    phi_3865_ = _e2158;
                                } else {
                                    phi_3865_ = _e2162;
                                }
                                let _e2165 = phi_3865_;
                                let _e2168 = local_2.member_2[1u];
                                if (_e2168[0] < 0f) {
                                    phi_3879_ = -(_e2168[0]);
                                } else {
                                    phi_3879_ = _e2168[0];
                                }
                                let _e2175 = phi_3879_;
                                if (_e2168[1] < 0f) {
                                    phi_3886_ = -(_e2168[1]);
                                } else {
                                    phi_3886_ = _e2168[1];
                                }
                                let _e2179 = phi_3886_;
                                if (_e2175 > _e2179) {
                                    phi_3891_ = _e2175;
                                } else {
                                    phi_3891_ = _e2179;
                                }
                                let _e2182 = phi_3891_;
                                if (_e2168[2] < 0f) {
                                    phi_3898_ = -(_e2168[2]);
                                } else {
                                    phi_3898_ = _e2168[2];
                                }
                                let _e2186 = phi_3898_;
                                if (_e2182 > _e2186) {
                                    phi_3903_ = _e2182;
                                } else {
                                    phi_3903_ = _e2186;
                                }
                                let _e2189 = phi_3903_;
                                if (_e2165 > _e2189) {
                                    phi_3908_ = _e2165;
                                } else {
                                    phi_3908_ = _e2189;
                                }
                                let _e2192 = phi_3908_;
                                let _e2194 = local_2.member_3;
                                let _e2198 = ((((_e2084 + _e2086) + (_e2138 + _e2140)) + (_e2192 + _e2194)) * 2f);
                                let _e2201 = local_2.member_3;
                                let _e2205 = (((_e1434 * 1.0001f) + (_e2201 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2208 = ((_e1982 * _e1961) - (_e1985 * _e1960));
                                let _e2211 = ((_e1985 * _e1959) - (_e1979 * _e1961));
                                let _e2214 = ((_e1979 * _e1960) - (_e1982 * _e1959));
                                let _e2219 = (((_e2208 * _e1988[0]) + (_e2211 * _e1988[1])) + (_e2214 * _e1988[2]));
                                let _e2224 = (((_e2208 * _e2004) + (_e2211 * _e2005)) + (_e2214 * _e2006));
                                let _e2229 = (((_e2208 * _e2007) + (_e2211 * _e2008)) + (_e2214 * _e2009));
                                let _e2234 = (((_e2208 * _e1988[0]) + (_e2211 * _e1988[1])) + (_e2214 * _e1988[2]));
                                let _e2239 = (((_e2208 * _e2012[0]) + (_e2211 * _e2012[1])) + (_e2214 * _e2012[2]));
                                let _e2244 = (((_e2208 * _e2028) + (_e2211 * _e2029)) + (_e2214 * _e2030));
                                let _e2249 = (((_e2208 * _e2031) + (_e2211 * _e2032)) + (_e2214 * _e2033));
                                let _e2254 = (((_e2208 * _e2012[0]) + (_e2211 * _e2012[1])) + (_e2214 * _e2012[2]));
                                if (_e2219 < _e2224) {
                                    phi_3987_ = _e2219;
                                } else {
                                    phi_3987_ = _e2224;
                                }
                                let _e2257 = phi_3987_;
                                if (_e2229 < _e2234) {
                                    phi_3992_ = _e2229;
                                } else {
                                    phi_3992_ = _e2234;
                                }
                                let _e2260 = phi_3992_;
                                if (_e2257 < _e2260) {
                                    phi_3997_ = _e2257;
                                } else {
                                    phi_3997_ = _e2260;
                                }
                                let _e2263 = phi_3997_;
                                if (_e2239 < _e2244) {
                                    phi_4002_ = _e2239;
                                } else {
                                    phi_4002_ = _e2244;
                                }
                                let _e2266 = phi_4002_;
                                if (_e2249 < _e2254) {
                                    phi_4007_ = _e2249;
                                } else {
                                    phi_4007_ = _e2254;
                                }
                                let _e2269 = phi_4007_;
                                if (_e2266 < _e2269) {
                                    phi_4012_ = _e2266;
                                } else {
                                    phi_4012_ = _e2269;
                                }
                                let _e2272 = phi_4012_;
                                if (_e2263 < _e2272) {
                                    phi_4017_ = _e2263;
                                } else {
                                    phi_4017_ = _e2272;
                                }
                                let _e2275 = phi_4017_;
                                if (_e2219 > _e2224) {
                                    phi_4022_ = _e2219;
                                } else {
                                    phi_4022_ = _e2224;
                                }
                                let _e2278 = phi_4022_;
                                if (_e2229 > _e2234) {
                                    phi_4027_ = _e2229;
                                } else {
                                    phi_4027_ = _e2234;
                                }
                                let _e2281 = phi_4027_;
                                if (_e2278 > _e2281) {
                                    phi_4032_ = _e2278;
                                } else {
                                    phi_4032_ = _e2281;
                                }
                                let _e2284 = phi_4032_;
                                if (_e2239 > _e2244) {
                                    phi_4037_ = _e2239;
                                } else {
                                    phi_4037_ = _e2244;
                                }
                                let _e2287 = phi_4037_;
                                if (_e2249 > _e2254) {
                                    phi_4042_ = _e2249;
                                } else {
                                    phi_4042_ = _e2254;
                                }
                                let _e2290 = phi_4042_;
                                if (_e2287 > _e2290) {
                                    phi_4047_ = _e2287;
                                } else {
                                    phi_4047_ = _e2290;
                                }
                                let _e2293 = phi_4047_;
                                if (_e2284 > _e2293) {
                                    phi_4052_ = _e2284;
                                } else {
                                    phi_4052_ = _e2293;
                                }
                                let _e2296 = phi_4052_;
                                if (_e2208 < 0f) {
                                    phi_4058_ = -(_e2208);
                                } else {
                                    phi_4058_ = _e2208;
                                }
                                let _e2300 = phi_4058_;
                                if (_e2211 < 0f) {
                                    phi_4064_ = -(_e2211);
                                } else {
                                    phi_4064_ = _e2211;
                                }
                                let _e2304 = phi_4064_;
                                if (_e2214 < 0f) {
                                    phi_4071_ = -(_e2214);
                                } else {
                                    phi_4071_ = _e2214;
                                }
                                let _e2309 = phi_4071_;
                                let _e2310 = ((_e2300 + _e2304) + _e2309);
                                let _e2315 = -(_e2296);
                                if (_e2275 > _e2315) {
                                    phi_4082_ = _e2275;
                                } else {
                                    phi_4082_ = _e2315;
                                }
                                let _e2318 = phi_4082_;
                                let _e2323 = (((_e2318 - ((_e2310 * _e2198) * (0.000000059604645f * (17f / 2f)))) - (_e2310 * _e2205)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2326 = ((_e1982 * _e1976) - (_e1985 * _e1975));
                                let _e2329 = ((_e1985 * _e1974) - (_e1979 * _e1976));
                                let _e2332 = ((_e1979 * _e1975) - (_e1982 * _e1974));
                                let _e2337 = (((_e2326 * _e1988[0]) + (_e2329 * _e1988[1])) + (_e2332 * _e1988[2]));
                                let _e2342 = (((_e2326 * _e2004) + (_e2329 * _e2005)) + (_e2332 * _e2006));
                                let _e2347 = (((_e2326 * _e2007) + (_e2329 * _e2008)) + (_e2332 * _e2009));
                                let _e2352 = (((_e2326 * _e1988[0]) + (_e2329 * _e1988[1])) + (_e2332 * _e1988[2]));
                                let _e2357 = (((_e2326 * _e2012[0]) + (_e2329 * _e2012[1])) + (_e2332 * _e2012[2]));
                                let _e2362 = (((_e2326 * _e2028) + (_e2329 * _e2029)) + (_e2332 * _e2030));
                                let _e2367 = (((_e2326 * _e2031) + (_e2329 * _e2032)) + (_e2332 * _e2033));
                                let _e2372 = (((_e2326 * _e2012[0]) + (_e2329 * _e2012[1])) + (_e2332 * _e2012[2]));
                                if (_e2337 < _e2342) {
                                    phi_4153_ = _e2337;
                                } else {
                                    phi_4153_ = _e2342;
                                }
                                let _e2375 = phi_4153_;
                                if (_e2347 < _e2352) {
                                    phi_4158_ = _e2347;
                                } else {
                                    phi_4158_ = _e2352;
                                }
                                let _e2378 = phi_4158_;
                                if (_e2375 < _e2378) {
                                    phi_4163_ = _e2375;
                                } else {
                                    phi_4163_ = _e2378;
                                }
                                let _e2381 = phi_4163_;
                                if (_e2357 < _e2362) {
                                    phi_4168_ = _e2357;
                                } else {
                                    phi_4168_ = _e2362;
                                }
                                let _e2384 = phi_4168_;
                                if (_e2367 < _e2372) {
                                    phi_4173_ = _e2367;
                                } else {
                                    phi_4173_ = _e2372;
                                }
                                let _e2387 = phi_4173_;
                                if (_e2384 < _e2387) {
                                    phi_4178_ = _e2384;
                                } else {
                                    phi_4178_ = _e2387;
                                }
                                let _e2390 = phi_4178_;
                                if (_e2381 < _e2390) {
                                    phi_4183_ = _e2381;
                                } else {
                                    phi_4183_ = _e2390;
                                }
                                let _e2393 = phi_4183_;
                                if (_e2337 > _e2342) {
                                    phi_4188_ = _e2337;
                                } else {
                                    phi_4188_ = _e2342;
                                }
                                let _e2396 = phi_4188_;
                                if (_e2347 > _e2352) {
                                    phi_4193_ = _e2347;
                                } else {
                                    phi_4193_ = _e2352;
                                }
                                let _e2399 = phi_4193_;
                                if (_e2396 > _e2399) {
                                    phi_4198_ = _e2396;
                                } else {
                                    phi_4198_ = _e2399;
                                }
                                let _e2402 = phi_4198_;
                                if (_e2357 > _e2362) {
                                    phi_4203_ = _e2357;
                                } else {
                                    phi_4203_ = _e2362;
                                }
                                let _e2405 = phi_4203_;
                                if (_e2367 > _e2372) {
                                    phi_4208_ = _e2367;
                                } else {
                                    phi_4208_ = _e2372;
                                }
                                let _e2408 = phi_4208_;
                                if (_e2405 > _e2408) {
                                    phi_4213_ = _e2405;
                                } else {
                                    phi_4213_ = _e2408;
                                }
                                let _e2411 = phi_4213_;
                                if (_e2402 > _e2411) {
                                    phi_4218_ = _e2402;
                                } else {
                                    phi_4218_ = _e2411;
                                }
                                let _e2414 = phi_4218_;
                                if (_e2326 < 0f) {
                                    phi_4224_ = -(_e2326);
                                } else {
                                    phi_4224_ = _e2326;
                                }
                                let _e2418 = phi_4224_;
                                if (_e2329 < 0f) {
                                    phi_4230_ = -(_e2329);
                                } else {
                                    phi_4230_ = _e2329;
                                }
                                let _e2422 = phi_4230_;
                                if (_e2332 < 0f) {
                                    phi_4237_ = -(_e2332);
                                } else {
                                    phi_4237_ = _e2332;
                                }
                                let _e2427 = phi_4237_;
                                let _e2428 = ((_e2418 + _e2422) + _e2427);
                                let _e2433 = -(_e2414);
                                if (_e2393 > _e2433) {
                                    phi_4248_ = _e2393;
                                } else {
                                    phi_4248_ = _e2433;
                                }
                                let _e2436 = phi_4248_;
                                let _e2441 = (((_e2436 - ((_e2428 * _e2198) * (0.000000059604645f * (17f / 2f)))) - (_e2428 * _e2205)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2323 > _e2441) {
                                    phi_4258_ = _e2323;
                                } else {
                                    phi_4258_ = _e2441;
                                }
                                let _e2444 = phi_4258_;
                                let _e2445 = (_e1974 - _e1959);
                                let _e2446 = (_e1975 - _e1960);
                                let _e2447 = (_e1976 - _e1961);
                                let _e2450 = ((_e1982 * _e2447) - (_e1985 * _e2446));
                                let _e2453 = ((_e1985 * _e2445) - (_e1979 * _e2447));
                                let _e2456 = ((_e1979 * _e2446) - (_e1982 * _e2445));
                                let _e2461 = (((_e2450 * _e1988[0]) + (_e2453 * _e1988[1])) + (_e2456 * _e1988[2]));
                                let _e2466 = (((_e2450 * _e2004) + (_e2453 * _e2005)) + (_e2456 * _e2006));
                                let _e2471 = (((_e2450 * _e2007) + (_e2453 * _e2008)) + (_e2456 * _e2009));
                                let _e2476 = (((_e2450 * _e1988[0]) + (_e2453 * _e1988[1])) + (_e2456 * _e1988[2]));
                                let _e2481 = (((_e2450 * _e2012[0]) + (_e2453 * _e2012[1])) + (_e2456 * _e2012[2]));
                                let _e2486 = (((_e2450 * _e2028) + (_e2453 * _e2029)) + (_e2456 * _e2030));
                                let _e2491 = (((_e2450 * _e2031) + (_e2453 * _e2032)) + (_e2456 * _e2033));
                                let _e2496 = (((_e2450 * _e2012[0]) + (_e2453 * _e2012[1])) + (_e2456 * _e2012[2]));
                                if (_e2461 < _e2466) {
                                    phi_4331_ = _e2461;
                                } else {
                                    phi_4331_ = _e2466;
                                }
                                let _e2499 = phi_4331_;
                                if (_e2471 < _e2476) {
                                    phi_4336_ = _e2471;
                                } else {
                                    phi_4336_ = _e2476;
                                }
                                let _e2502 = phi_4336_;
                                if (_e2499 < _e2502) {
                                    phi_4341_ = _e2499;
                                } else {
                                    phi_4341_ = _e2502;
                                }
                                let _e2505 = phi_4341_;
                                if (_e2481 < _e2486) {
                                    phi_4346_ = _e2481;
                                } else {
                                    phi_4346_ = _e2486;
                                }
                                let _e2508 = phi_4346_;
                                if (_e2491 < _e2496) {
                                    phi_4351_ = _e2491;
                                } else {
                                    phi_4351_ = _e2496;
                                }
                                let _e2511 = phi_4351_;
                                if (_e2508 < _e2511) {
                                    phi_4356_ = _e2508;
                                } else {
                                    phi_4356_ = _e2511;
                                }
                                let _e2514 = phi_4356_;
                                if (_e2505 < _e2514) {
                                    phi_4361_ = _e2505;
                                } else {
                                    phi_4361_ = _e2514;
                                }
                                let _e2517 = phi_4361_;
                                if (_e2461 > _e2466) {
                                    phi_4366_ = _e2461;
                                } else {
                                    phi_4366_ = _e2466;
                                }
                                let _e2520 = phi_4366_;
                                if (_e2471 > _e2476) {
                                    phi_4371_ = _e2471;
                                } else {
                                    phi_4371_ = _e2476;
                                }
                                let _e2523 = phi_4371_;
                                if (_e2520 > _e2523) {
                                    phi_4376_ = _e2520;
                                } else {
                                    phi_4376_ = _e2523;
                                }
                                let _e2526 = phi_4376_;
                                if (_e2481 > _e2486) {
                                    phi_4381_ = _e2481;
                                } else {
                                    phi_4381_ = _e2486;
                                }
                                let _e2529 = phi_4381_;
                                if (_e2491 > _e2496) {
                                    phi_4386_ = _e2491;
                                } else {
                                    phi_4386_ = _e2496;
                                }
                                let _e2532 = phi_4386_;
                                if (_e2529 > _e2532) {
                                    phi_4391_ = _e2529;
                                } else {
                                    phi_4391_ = _e2532;
                                }
                                let _e2535 = phi_4391_;
                                if (_e2526 > _e2535) {
                                    phi_4396_ = _e2526;
                                } else {
                                    phi_4396_ = _e2535;
                                }
                                let _e2538 = phi_4396_;
                                if (_e2450 < 0f) {
                                    phi_4402_ = -(_e2450);
                                } else {
                                    phi_4402_ = _e2450;
                                }
                                let _e2542 = phi_4402_;
                                if (_e2453 < 0f) {
                                    phi_4408_ = -(_e2453);
                                } else {
                                    phi_4408_ = _e2453;
                                }
                                let _e2546 = phi_4408_;
                                if (_e2456 < 0f) {
                                    phi_4415_ = -(_e2456);
                                } else {
                                    phi_4415_ = _e2456;
                                }
                                let _e2551 = phi_4415_;
                                let _e2552 = ((_e2542 + _e2546) + _e2551);
                                let _e2557 = -(_e2538);
                                if (_e2517 > _e2557) {
                                    phi_4426_ = _e2517;
                                } else {
                                    phi_4426_ = _e2557;
                                }
                                let _e2560 = phi_4426_;
                                let _e2565 = (((_e2560 - ((_e2552 * _e2198) * (0.000000059604645f * (17f / 2f)))) - (_e2552 * _e2205)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2444 > _e2565) {
                                    phi_4436_ = _e2444;
                                } else {
                                    phi_4436_ = _e2565;
                                }
                                let _e2568 = phi_4436_;
                                phi_4440_ = (_e1946 || (_e2568 > 0f));
                            }
                            let _e2572 = phi_4440_;
                            if _e2572 {
                                phi_7857_ = _e2572;
                            } else {
                                let _e2575 = local_2.member[0u];
                                let _e2581 = local_2.member[1u];
                                let _e2588 = ((_e2575[0] + _e2581[0]) * 0.5f);
                                let _e2589 = ((_e2575[1] + _e2581[1]) * 0.5f);
                                let _e2590 = ((_e2575[2] + _e2581[2]) * 0.5f);
                                let _e2593 = local_2.member_1[0u];
                                let _e2599 = local_2.member_1[1u];
                                let _e2606 = ((_e2593[0] + _e2599[0]) * 0.5f);
                                let _e2607 = ((_e2593[1] + _e2599[1]) * 0.5f);
                                let _e2608 = ((_e2593[2] + _e2599[2]) * 0.5f);
                                let _e2611 = local_2.member_2[0u];
                                let _e2617 = local_2.member_2[1u];
                                let _e2624 = ((_e2611[0] + _e2617[0]) * 0.5f);
                                let _e2625 = ((_e2611[1] + _e2617[1]) * 0.5f);
                                let _e2626 = ((_e2611[2] + _e2617[2]) * 0.5f);
                                let _e2629 = local_2.member[0u];
                                let _e2632 = local_2.member_1[0u];
                                let _e2635 = local_2.member_2[0u];
                                let _e2637 = local_2.member_3;
                                let _e2640 = local_2.member[1u];
                                let _e2643 = local_2.member_1[1u];
                                let _e2646 = local_2.member_2[1u];
                                let _e2648 = local_2.member_3;
                                local = type_37(array<array<f32, 3>, 2>(_e2629, array<f32, 3>(_e2588, _e2589, _e2590)), array<array<f32, 3>, 2>(_e2632, array<f32, 3>(_e2606, _e2607, _e2608)), array<array<f32, 3>, 2>(_e2635, array<f32, 3>(_e2624, _e2625, _e2626)), _e2637);
                                local_1 = type_37(array<array<f32, 3>, 2>(array<f32, 3>(_e2588, _e2589, _e2590), _e2640), array<array<f32, 3>, 2>(array<f32, 3>(_e2606, _e2607, _e2608), _e2643), array<array<f32, 3>, 2>(array<f32, 3>(_e2624, _e2625, _e2626), _e2646), _e2648);
                                let _e2665 = local.member_1[0u];
                                let _e2671 = local.member_2[0u];
                                let _e2677 = ((_e2665[1] * _e2671[2]) - (_e2665[2] * _e2671[1]));
                                let _e2680 = ((_e2665[2] * _e2671[0]) - (_e2665[0] * _e2671[2]));
                                let _e2683 = ((_e2665[0] * _e2671[1]) - (_e2665[1] * _e2671[0]));
                                let _e2686 = local.member_1[1u];
                                let _e2692 = local.member_2[1u];
                                let _e2698 = ((_e2686[1] * _e2692[2]) - (_e2686[2] * _e2692[1]));
                                let _e2701 = ((_e2686[2] * _e2692[0]) - (_e2686[0] * _e2692[2]));
                                let _e2704 = ((_e2686[0] * _e2692[1]) - (_e2686[1] * _e2692[0]));
                                let _e2707 = local.member_1[0u];
                                let _e2713 = local.member_2[1u];
                                let _e2728 = local.member_1[1u];
                                let _e2734 = local.member_2[0u];
                                let _e2747 = (((_e2707[1] * _e2713[2]) - (_e2707[2] * _e2713[1])) + ((_e2728[1] * _e2734[2]) - (_e2728[2] * _e2734[1])));
                                let _e2748 = (((_e2707[2] * _e2713[0]) - (_e2707[0] * _e2713[2])) + ((_e2728[2] * _e2734[0]) - (_e2728[0] * _e2734[2])));
                                let _e2749 = (((_e2707[0] * _e2713[1]) - (_e2707[1] * _e2713[0])) + ((_e2728[0] * _e2734[1]) - (_e2728[1] * _e2734[0])));
                                let _e2752 = local.member[0u];
                                let _e2763 = local.member[1u];
                                let _e2774 = local.member[0u];
                                let _e2783 = ((((_e2763[0] * _e2677) + (_e2763[1] * _e2680)) + (_e2763[2] * _e2683)) + (((_e2774[0] * _e2747) + (_e2774[1] * _e2748)) + (_e2774[2] * _e2749)));
                                let _e2786 = local.member[0u];
                                let _e2797 = local.member[1u];
                                let _e2806 = ((((_e2786[0] * _e2698) + (_e2786[1] * _e2701)) + (_e2786[2] * _e2704)) + (((_e2797[0] * _e2747) + (_e2797[1] * _e2748)) + (_e2797[2] * _e2749)));
                                let _e2809 = local.member[1u];
                                let _e2820 = local.member[0u];
                                if (_e2820[0] < 0f) {
                                    phi_4892_ = -(_e2820[0]);
                                } else {
                                    phi_4892_ = _e2820[0];
                                }
                                let _e2827 = phi_4892_;
                                if (_e2820[1] < 0f) {
                                    phi_4899_ = -(_e2820[1]);
                                } else {
                                    phi_4899_ = _e2820[1];
                                }
                                let _e2831 = phi_4899_;
                                if (_e2827 > _e2831) {
                                    phi_4904_ = _e2827;
                                } else {
                                    phi_4904_ = _e2831;
                                }
                                let _e2834 = phi_4904_;
                                if (_e2820[2] < 0f) {
                                    phi_4911_ = -(_e2820[2]);
                                } else {
                                    phi_4911_ = _e2820[2];
                                }
                                let _e2838 = phi_4911_;
                                if (_e2834 > _e2838) {
                                    phi_4916_ = _e2834;
                                } else {
                                    phi_4916_ = _e2838;
                                }
                                let _e2841 = phi_4916_;
                                let _e2844 = local.member[1u];
                                if (_e2844[0] < 0f) {
                                    phi_4929_ = -(_e2844[0]);
                                } else {
                                    phi_4929_ = _e2844[0];
                                }
                                let _e2851 = phi_4929_;
                                if (_e2844[1] < 0f) {
                                    phi_4936_ = -(_e2844[1]);
                                } else {
                                    phi_4936_ = _e2844[1];
                                }
                                let _e2855 = phi_4936_;
                                if (_e2851 > _e2855) {
                                    phi_4941_ = _e2851;
                                } else {
                                    phi_4941_ = _e2855;
                                }
                                let _e2858 = phi_4941_;
                                if (_e2844[2] < 0f) {
                                    phi_4948_ = -(_e2844[2]);
                                } else {
                                    phi_4948_ = _e2844[2];
                                }
                                let _e2862 = phi_4948_;
                                if (_e2858 > _e2862) {
                                    phi_4953_ = _e2858;
                                } else {
                                    phi_4953_ = _e2862;
                                }
                                let _e2865 = phi_4953_;
                                if (_e2841 > _e2865) {
                                    phi_4958_ = _e2841;
                                } else {
                                    phi_4958_ = _e2865;
                                }
                                let _e2868 = phi_4958_;
                                let _e2870 = local.member_3;
                                let _e2871 = (_e2868 + _e2870);
                                let _e2874 = local.member_1[0u];
                                if (_e2874[0] < 0f) {
                                    phi_4975_ = -(_e2874[0]);
                                } else {
                                    phi_4975_ = _e2874[0];
                                }
                                let _e2881 = phi_4975_;
                                if (_e2874[1] < 0f) {
                                    phi_4982_ = -(_e2874[1]);
                                } else {
                                    phi_4982_ = _e2874[1];
                                }
                                let _e2885 = phi_4982_;
                                if (_e2881 > _e2885) {
                                    phi_4987_ = _e2881;
                                } else {
                                    phi_4987_ = _e2885;
                                }
                                let _e2888 = phi_4987_;
                                if (_e2874[2] < 0f) {
                                    phi_4994_ = -(_e2874[2]);
                                } else {
                                    phi_4994_ = _e2874[2];
                                }
                                let _e2892 = phi_4994_;
                                if (_e2888 > _e2892) {
                                    phi_4999_ = _e2888;
                                } else {
                                    phi_4999_ = _e2892;
                                }
                                let _e2895 = phi_4999_;
                                let _e2898 = local.member_1[1u];
                                if (_e2898[0] < 0f) {
                                    phi_5013_ = -(_e2898[0]);
                                } else {
                                    phi_5013_ = _e2898[0];
                                }
                                let _e2905 = phi_5013_;
                                if (_e2898[1] < 0f) {
                                    phi_5020_ = -(_e2898[1]);
                                } else {
                                    phi_5020_ = _e2898[1];
                                }
                                let _e2909 = phi_5020_;
                                if (_e2905 > _e2909) {
                                    phi_5025_ = _e2905;
                                } else {
                                    phi_5025_ = _e2909;
                                }
                                let _e2912 = phi_5025_;
                                if (_e2898[2] < 0f) {
                                    phi_5032_ = -(_e2898[2]);
                                } else {
                                    phi_5032_ = _e2898[2];
                                }
                                let _e2916 = phi_5032_;
                                if (_e2912 > _e2916) {
                                    phi_5037_ = _e2912;
                                } else {
                                    phi_5037_ = _e2916;
                                }
                                let _e2919 = phi_5037_;
                                if (_e2895 > _e2919) {
                                    phi_5042_ = _e2895;
                                } else {
                                    phi_5042_ = _e2919;
                                }
                                let _e2922 = phi_5042_;
                                let _e2924 = local.member_3;
                                let _e2925 = (_e2922 + _e2924);
                                let _e2928 = local.member_2[0u];
                                if (_e2928[0] < 0f) {
                                    phi_5059_ = -(_e2928[0]);
                                } else {
                                    phi_5059_ = _e2928[0];
                                }
                                let _e2935 = phi_5059_;
                                if (_e2928[1] < 0f) {
                                    phi_5066_ = -(_e2928[1]);
                                } else {
                                    phi_5066_ = _e2928[1];
                                }
                                let _e2939 = phi_5066_;
                                if (_e2935 > _e2939) {
                                    phi_5071_ = _e2935;
                                } else {
                                    phi_5071_ = _e2939;
                                }
                                let _e2942 = phi_5071_;
                                if (_e2928[2] < 0f) {
                                    phi_5078_ = -(_e2928[2]);
                                } else {
                                    phi_5078_ = _e2928[2];
                                }
                                let _e2946 = phi_5078_;
                                if (_e2942 > _e2946) {
                                    phi_5083_ = _e2942;
                                } else {
                                    phi_5083_ = _e2946;
                                }
                                let _e2949 = phi_5083_;
                                let _e2952 = local.member_2[1u];
                                if (_e2952[0] < 0f) {
                                    phi_5097_ = -(_e2952[0]);
                                } else {
                                    phi_5097_ = _e2952[0];
                                }
                                let _e2959 = phi_5097_;
                                if (_e2952[1] < 0f) {
                                    phi_5104_ = -(_e2952[1]);
                                } else {
                                    phi_5104_ = _e2952[1];
                                }
                                let _e2963 = phi_5104_;
                                if (_e2959 > _e2963) {
                                    phi_5109_ = _e2959;
                                } else {
                                    phi_5109_ = _e2963;
                                }
                                let _e2966 = phi_5109_;
                                if (_e2952[2] < 0f) {
                                    phi_5116_ = -(_e2952[2]);
                                } else {
                                    phi_5116_ = _e2952[2];
                                }
                                let _e2970 = phi_5116_;
                                if (_e2966 > _e2970) {
                                    phi_5121_ = _e2966;
                                } else {
                                    phi_5121_ = _e2970;
                                }
                                let _e2973 = phi_5121_;
                                if (_e2949 > _e2973) {
                                    phi_5126_ = _e2949;
                                } else {
                                    phi_5126_ = _e2973;
                                }
                                let _e2976 = phi_5126_;
                                let _e2978 = local.member_3;
                                let _e2979 = (_e2976 + _e2978);
                                let _e2981 = ((_e2925 * 8f) * _e2979);
                                let _e2988 = local.member_3;
                                if (_e2677 < 0f) {
                                    phi_5157_ = -(_e2677);
                                } else {
                                    phi_5157_ = _e2677;
                                }
                                let _e3005 = phi_5157_;
                                if (_e2680 < 0f) {
                                    phi_5163_ = -(_e2680);
                                } else {
                                    phi_5163_ = _e2680;
                                }
                                let _e3009 = phi_5163_;
                                if (_e2683 < 0f) {
                                    phi_5170_ = -(_e2683);
                                } else {
                                    phi_5170_ = _e2683;
                                }
                                let _e3014 = phi_5170_;
                                let _e3015 = ((_e3005 + _e3009) + _e3014);
                                if (_e2698 < 0f) {
                                    phi_5177_ = -(_e2698);
                                } else {
                                    phi_5177_ = _e2698;
                                }
                                let _e3019 = phi_5177_;
                                if (_e2701 < 0f) {
                                    phi_5183_ = -(_e2701);
                                } else {
                                    phi_5183_ = _e2701;
                                }
                                let _e3023 = phi_5183_;
                                if (_e2704 < 0f) {
                                    phi_5190_ = -(_e2704);
                                } else {
                                    phi_5190_ = _e2704;
                                }
                                let _e3028 = phi_5190_;
                                let _e3029 = ((_e3019 + _e3023) + _e3028);
                                if (_e3015 > _e3029) {
                                    phi_5196_ = _e3015;
                                } else {
                                    phi_5196_ = _e3029;
                                }
                                let _e3032 = phi_5196_;
                                if (_e2747 < 0f) {
                                    phi_5202_ = -(_e2747);
                                } else {
                                    phi_5202_ = _e2747;
                                }
                                let _e3036 = phi_5202_;
                                if (_e2748 < 0f) {
                                    phi_5208_ = -(_e2748);
                                } else {
                                    phi_5208_ = _e2748;
                                }
                                let _e3040 = phi_5208_;
                                if (_e2749 < 0f) {
                                    phi_5215_ = -(_e2749);
                                } else {
                                    phi_5215_ = _e2749;
                                }
                                let _e3045 = phi_5215_;
                                let _e3047 = (((_e3036 + _e3040) + _e3045) * 0.5f);
                                if (_e3032 > _e3047) {
                                    phi_5222_ = _e3032;
                                } else {
                                    phi_5222_ = _e3047;
                                }
                                let _e3050 = phi_5222_;
                                let _e3055 = local.member_3;
                                let _e3068 = ((((_e2752[0] * _e2677) + (_e2752[1] * _e2680)) + (_e2752[2] * _e2683)) * 3f);
                                let _e3069 = ((((_e2809[0] * _e2698) + (_e2809[1] * _e2701)) + (_e2809[2] * _e2704)) * 3f);
                                if (_e3068 < _e3069) {
                                    phi_5246_ = _e3068;
                                } else {
                                    phi_5246_ = _e3069;
                                }
                                let _e3072 = phi_5246_;
                                if (_e2783 < _e2806) {
                                    phi_5251_ = _e2783;
                                } else {
                                    phi_5251_ = _e2806;
                                }
                                let _e3075 = phi_5251_;
                                if (_e3072 < _e3075) {
                                    phi_5256_ = _e3072;
                                } else {
                                    phi_5256_ = _e3075;
                                }
                                let _e3078 = phi_5256_;
                                if (_e3068 > _e3069) {
                                    phi_5261_ = _e3068;
                                } else {
                                    phi_5261_ = _e3069;
                                }
                                let _e3081 = phi_5261_;
                                if (_e2783 > _e2806) {
                                    phi_5266_ = _e2783;
                                } else {
                                    phi_5266_ = _e2806;
                                }
                                let _e3084 = phi_5266_;
                                if (_e3081 > _e3084) {
                                    phi_5271_ = _e3081;
                                } else {
                                    phi_5271_ = _e3084;
                                }
                                let _e3087 = phi_5271_;
                                let _e3092 = -(_e3087);
                                if (_e3078 > _e3092) {
                                    phi_5281_ = _e3078;
                                } else {
                                    phi_5281_ = _e3092;
                                }
                                let _e3095 = phi_5281_;
                                let _e3097 = ((_e3095 - ((((((_e2871 * 8f) * _e2981) * (0.000000059604645f * (524f / 64f))) + ((_e2988 * 19f) * ((_e2871 * (_e2925 + _e2979)) + (_e2925 * _e2979)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2871) * ((1f + _e2925) * (1f + _e2979))))) + ((_e1434 * (((_e3050 + (_e2981 * (0.000000059604645f * 8f))) + ((_e3055 * 6f) * (_e2925 + _e2979))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2925) * (1f + _e2979))))) * (3f * 1.0001f)))) > 0f);
                                if _e3097 {
                                    phi_6250_ = _e3097;
                                } else {
                                    let _e3100 = local.member_1[0u];
                                    let _e3106 = local.member_1[1u];
                                    let _e3110 = (_e3100[0] + _e3106[0]);
                                    let _e3111 = (_e3100[1] + _e3106[1]);
                                    let _e3112 = (_e3100[2] + _e3106[2]);
                                    let _e3115 = local.member_2[0u];
                                    let _e3121 = local.member_2[1u];
                                    let _e3125 = (_e3115[0] + _e3121[0]);
                                    let _e3126 = (_e3115[1] + _e3121[1]);
                                    let _e3127 = (_e3115[2] + _e3121[2]);
                                    let _e3130 = ((_e3111 * _e3127) - (_e3112 * _e3126));
                                    let _e3133 = ((_e3112 * _e3125) - (_e3110 * _e3127));
                                    let _e3136 = ((_e3110 * _e3126) - (_e3111 * _e3125));
                                    let _e3139 = local.member[0u];
                                    let _e3145 = local.member_1[0u];
                                    let _e3151 = local.member_2[0u];
                                    let _e3155 = (_e3139[0] - _e3145[0]);
                                    let _e3156 = (_e3139[1] - _e3145[1]);
                                    let _e3157 = (_e3139[2] - _e3145[2]);
                                    let _e3158 = (_e3139[0] - _e3151[0]);
                                    let _e3159 = (_e3139[1] - _e3151[1]);
                                    let _e3160 = (_e3139[2] - _e3151[2]);
                                    let _e3163 = local.member[1u];
                                    let _e3169 = local.member_1[1u];
                                    let _e3175 = local.member_2[1u];
                                    let _e3179 = (_e3163[0] - _e3169[0]);
                                    let _e3180 = (_e3163[1] - _e3169[1]);
                                    let _e3181 = (_e3163[2] - _e3169[2]);
                                    let _e3182 = (_e3163[0] - _e3175[0]);
                                    let _e3183 = (_e3163[1] - _e3175[1]);
                                    let _e3184 = (_e3163[2] - _e3175[2]);
                                    let _e3187 = local.member[0u];
                                    if (_e3187[0] < 0f) {
                                        phi_5484_ = -(_e3187[0]);
                                    } else {
                                        phi_5484_ = _e3187[0];
                                    }
                                    let _e3194 = phi_5484_;
                                    if (_e3187[1] < 0f) {
                                        phi_5491_ = -(_e3187[1]);
                                    } else {
                                        phi_5491_ = _e3187[1];
                                    }
                                    let _e3198 = phi_5491_;
                                    if (_e3194 > _e3198) {
                                        phi_5496_ = _e3194;
                                    } else {
                                        phi_5496_ = _e3198;
                                    }
                                    let _e3201 = phi_5496_;
                                    if (_e3187[2] < 0f) {
                                        phi_5503_ = -(_e3187[2]);
                                    } else {
                                        phi_5503_ = _e3187[2];
                                    }
                                    let _e3205 = phi_5503_;
                                    if (_e3201 > _e3205) {
                                        phi_5508_ = _e3201;
                                    } else {
                                        phi_5508_ = _e3205;
                                    }
                                    let _e3208 = phi_5508_;
                                    let _e3211 = local.member[1u];
                                    if (_e3211[0] < 0f) {
                                        phi_5521_ = -(_e3211[0]);
                                    } else {
                                        phi_5521_ = _e3211[0];
                                    }
                                    let _e3218 = phi_5521_;
                                    if (_e3211[1] < 0f) {
                                        phi_5528_ = -(_e3211[1]);
                                    } else {
                                        phi_5528_ = _e3211[1];
                                    }
                                    let _e3222 = phi_5528_;
                                    if (_e3218 > _e3222) {
                                        phi_5533_ = _e3218;
                                    } else {
                                        phi_5533_ = _e3222;
                                    }
                                    let _e3225 = phi_5533_;
                                    if (_e3211[2] < 0f) {
                                        phi_5540_ = -(_e3211[2]);
                                    } else {
                                        phi_5540_ = _e3211[2];
                                    }
                                    let _e3229 = phi_5540_;
                                    if (_e3225 > _e3229) {
                                        phi_5545_ = _e3225;
                                    } else {
                                        phi_5545_ = _e3229;
                                    }
                                    let _e3232 = phi_5545_;
                                    if (_e3208 > _e3232) {
                                        phi_5550_ = _e3208;
                                    } else {
                                        phi_5550_ = _e3232;
                                    }
                                    let _e3235 = phi_5550_;
                                    let _e3237 = local.member_3;
                                    let _e3241 = local.member_1[0u];
                                    if (_e3241[0] < 0f) {
                                        phi_5567_ = -(_e3241[0]);
                                    } else {
                                        phi_5567_ = _e3241[0];
                                    }
                                    let _e3248 = phi_5567_;
                                    if (_e3241[1] < 0f) {
                                        phi_5574_ = -(_e3241[1]);
                                    } else {
                                        phi_5574_ = _e3241[1];
                                    }
                                    let _e3252 = phi_5574_;
                                    if (_e3248 > _e3252) {
                                        phi_5579_ = _e3248;
                                    } else {
                                        phi_5579_ = _e3252;
                                    }
                                    let _e3255 = phi_5579_;
                                    if (_e3241[2] < 0f) {
                                        phi_5586_ = -(_e3241[2]);
                                    } else {
                                        phi_5586_ = _e3241[2];
                                    }
                                    let _e3259 = phi_5586_;
                                    if (_e3255 > _e3259) {
                                        phi_5591_ = _e3255;
                                    } else {
                                        phi_5591_ = _e3259;
                                    }
                                    let _e3262 = phi_5591_;
                                    let _e3265 = local.member_1[1u];
                                    if (_e3265[0] < 0f) {
                                        phi_5605_ = -(_e3265[0]);
                                    } else {
                                        phi_5605_ = _e3265[0];
                                    }
                                    let _e3272 = phi_5605_;
                                    if (_e3265[1] < 0f) {
                                        phi_5612_ = -(_e3265[1]);
                                    } else {
                                        phi_5612_ = _e3265[1];
                                    }
                                    let _e3276 = phi_5612_;
                                    if (_e3272 > _e3276) {
                                        phi_5617_ = _e3272;
                                    } else {
                                        phi_5617_ = _e3276;
                                    }
                                    let _e3279 = phi_5617_;
                                    if (_e3265[2] < 0f) {
                                        phi_5624_ = -(_e3265[2]);
                                    } else {
                                        phi_5624_ = _e3265[2];
                                    }
                                    let _e3283 = phi_5624_;
                                    if (_e3279 > _e3283) {
                                        phi_5629_ = _e3279;
                                    } else {
                                        phi_5629_ = _e3283;
                                    }
                                    let _e3286 = phi_5629_;
                                    if (_e3262 > _e3286) {
                                        phi_5634_ = _e3262;
                                    } else {
                                        phi_5634_ = _e3286;
                                    }
                                    let _e3289 = phi_5634_;
                                    let _e3291 = local.member_3;
                                    let _e3295 = local.member_2[0u];
                                    if (_e3295[0] < 0f) {
                                        phi_5651_ = -(_e3295[0]);
                                    } else {
                                        phi_5651_ = _e3295[0];
                                    }
                                    let _e3302 = phi_5651_;
                                    if (_e3295[1] < 0f) {
                                        phi_5658_ = -(_e3295[1]);
                                    } else {
                                        phi_5658_ = _e3295[1];
                                    }
                                    let _e3306 = phi_5658_;
                                    if (_e3302 > _e3306) {
                                        phi_5663_ = _e3302;
                                    } else {
                                        phi_5663_ = _e3306;
                                    }
                                    let _e3309 = phi_5663_;
                                    if (_e3295[2] < 0f) {
                                        phi_5670_ = -(_e3295[2]);
                                    } else {
                                        phi_5670_ = _e3295[2];
                                    }
                                    let _e3313 = phi_5670_;
                                    if (_e3309 > _e3313) {
                                        phi_5675_ = _e3309;
                                    } else {
                                        phi_5675_ = _e3313;
                                    }
                                    let _e3316 = phi_5675_;
                                    let _e3319 = local.member_2[1u];
                                    if (_e3319[0] < 0f) {
                                        phi_5689_ = -(_e3319[0]);
                                    } else {
                                        phi_5689_ = _e3319[0];
                                    }
                                    let _e3326 = phi_5689_;
                                    if (_e3319[1] < 0f) {
                                        phi_5696_ = -(_e3319[1]);
                                    } else {
                                        phi_5696_ = _e3319[1];
                                    }
                                    let _e3330 = phi_5696_;
                                    if (_e3326 > _e3330) {
                                        phi_5701_ = _e3326;
                                    } else {
                                        phi_5701_ = _e3330;
                                    }
                                    let _e3333 = phi_5701_;
                                    if (_e3319[2] < 0f) {
                                        phi_5708_ = -(_e3319[2]);
                                    } else {
                                        phi_5708_ = _e3319[2];
                                    }
                                    let _e3337 = phi_5708_;
                                    if (_e3333 > _e3337) {
                                        phi_5713_ = _e3333;
                                    } else {
                                        phi_5713_ = _e3337;
                                    }
                                    let _e3340 = phi_5713_;
                                    if (_e3316 > _e3340) {
                                        phi_5718_ = _e3316;
                                    } else {
                                        phi_5718_ = _e3340;
                                    }
                                    let _e3343 = phi_5718_;
                                    let _e3345 = local.member_3;
                                    let _e3349 = ((((_e3235 + _e3237) + (_e3289 + _e3291)) + (_e3343 + _e3345)) * 2f);
                                    let _e3352 = local.member_3;
                                    let _e3356 = (((_e1434 * 1.0001f) + (_e3352 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3359 = ((_e3133 * _e3112) - (_e3136 * _e3111));
                                    let _e3362 = ((_e3136 * _e3110) - (_e3130 * _e3112));
                                    let _e3365 = ((_e3130 * _e3111) - (_e3133 * _e3110));
                                    let _e3370 = (((_e3359 * _e3139[0]) + (_e3362 * _e3139[1])) + (_e3365 * _e3139[2]));
                                    let _e3375 = (((_e3359 * _e3155) + (_e3362 * _e3156)) + (_e3365 * _e3157));
                                    let _e3380 = (((_e3359 * _e3158) + (_e3362 * _e3159)) + (_e3365 * _e3160));
                                    let _e3385 = (((_e3359 * _e3139[0]) + (_e3362 * _e3139[1])) + (_e3365 * _e3139[2]));
                                    let _e3390 = (((_e3359 * _e3163[0]) + (_e3362 * _e3163[1])) + (_e3365 * _e3163[2]));
                                    let _e3395 = (((_e3359 * _e3179) + (_e3362 * _e3180)) + (_e3365 * _e3181));
                                    let _e3400 = (((_e3359 * _e3182) + (_e3362 * _e3183)) + (_e3365 * _e3184));
                                    let _e3405 = (((_e3359 * _e3163[0]) + (_e3362 * _e3163[1])) + (_e3365 * _e3163[2]));
                                    if (_e3370 < _e3375) {
                                        phi_5797_ = _e3370;
                                    } else {
                                        phi_5797_ = _e3375;
                                    }
                                    let _e3408 = phi_5797_;
                                    if (_e3380 < _e3385) {
                                        phi_5802_ = _e3380;
                                    } else {
                                        phi_5802_ = _e3385;
                                    }
                                    let _e3411 = phi_5802_;
                                    if (_e3408 < _e3411) {
                                        phi_5807_ = _e3408;
                                    } else {
                                        phi_5807_ = _e3411;
                                    }
                                    let _e3414 = phi_5807_;
                                    if (_e3390 < _e3395) {
                                        phi_5812_ = _e3390;
                                    } else {
                                        phi_5812_ = _e3395;
                                    }
                                    let _e3417 = phi_5812_;
                                    if (_e3400 < _e3405) {
                                        phi_5817_ = _e3400;
                                    } else {
                                        phi_5817_ = _e3405;
                                    }
                                    let _e3420 = phi_5817_;
                                    if (_e3417 < _e3420) {
                                        phi_5822_ = _e3417;
                                    } else {
                                        phi_5822_ = _e3420;
                                    }
                                    let _e3423 = phi_5822_;
                                    if (_e3414 < _e3423) {
                                        phi_5827_ = _e3414;
                                    } else {
                                        phi_5827_ = _e3423;
                                    }
                                    let _e3426 = phi_5827_;
                                    if (_e3370 > _e3375) {
                                        phi_5832_ = _e3370;
                                    } else {
                                        phi_5832_ = _e3375;
                                    }
                                    let _e3429 = phi_5832_;
                                    if (_e3380 > _e3385) {
                                        phi_5837_ = _e3380;
                                    } else {
                                        phi_5837_ = _e3385;
                                    }
                                    let _e3432 = phi_5837_;
                                    if (_e3429 > _e3432) {
                                        phi_5842_ = _e3429;
                                    } else {
                                        phi_5842_ = _e3432;
                                    }
                                    let _e3435 = phi_5842_;
                                    if (_e3390 > _e3395) {
                                        phi_5847_ = _e3390;
                                    } else {
                                        phi_5847_ = _e3395;
                                    }
                                    let _e3438 = phi_5847_;
                                    if (_e3400 > _e3405) {
                                        phi_5852_ = _e3400;
                                    } else {
                                        phi_5852_ = _e3405;
                                    }
                                    let _e3441 = phi_5852_;
                                    if (_e3438 > _e3441) {
                                        phi_5857_ = _e3438;
                                    } else {
                                        phi_5857_ = _e3441;
                                    }
                                    let _e3444 = phi_5857_;
                                    if (_e3435 > _e3444) {
                                        phi_5862_ = _e3435;
                                    } else {
                                        phi_5862_ = _e3444;
                                    }
                                    let _e3447 = phi_5862_;
                                    if (_e3359 < 0f) {
                                        phi_5868_ = -(_e3359);
                                    } else {
                                        phi_5868_ = _e3359;
                                    }
                                    let _e3451 = phi_5868_;
                                    if (_e3362 < 0f) {
                                        phi_5874_ = -(_e3362);
                                    } else {
                                        phi_5874_ = _e3362;
                                    }
                                    let _e3455 = phi_5874_;
                                    if (_e3365 < 0f) {
                                        phi_5881_ = -(_e3365);
                                    } else {
                                        phi_5881_ = _e3365;
                                    }
                                    let _e3460 = phi_5881_;
                                    let _e3461 = ((_e3451 + _e3455) + _e3460);
                                    let _e3466 = -(_e3447);
                                    if (_e3426 > _e3466) {
                                        phi_5892_ = _e3426;
                                    } else {
                                        phi_5892_ = _e3466;
                                    }
                                    let _e3469 = phi_5892_;
                                    let _e3474 = (((_e3469 - ((_e3461 * _e3349) * (0.000000059604645f * (17f / 2f)))) - (_e3461 * _e3356)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3477 = ((_e3133 * _e3127) - (_e3136 * _e3126));
                                    let _e3480 = ((_e3136 * _e3125) - (_e3130 * _e3127));
                                    let _e3483 = ((_e3130 * _e3126) - (_e3133 * _e3125));
                                    let _e3488 = (((_e3477 * _e3139[0]) + (_e3480 * _e3139[1])) + (_e3483 * _e3139[2]));
                                    let _e3493 = (((_e3477 * _e3155) + (_e3480 * _e3156)) + (_e3483 * _e3157));
                                    let _e3498 = (((_e3477 * _e3158) + (_e3480 * _e3159)) + (_e3483 * _e3160));
                                    let _e3503 = (((_e3477 * _e3139[0]) + (_e3480 * _e3139[1])) + (_e3483 * _e3139[2]));
                                    let _e3508 = (((_e3477 * _e3163[0]) + (_e3480 * _e3163[1])) + (_e3483 * _e3163[2]));
                                    let _e3513 = (((_e3477 * _e3179) + (_e3480 * _e3180)) + (_e3483 * _e3181));
                                    let _e3518 = (((_e3477 * _e3182) + (_e3480 * _e3183)) + (_e3483 * _e3184));
                                    let _e3523 = (((_e3477 * _e3163[0]) + (_e3480 * _e3163[1])) + (_e3483 * _e3163[2]));
                                    if (_e3488 < _e3493) {
                                        phi_5963_ = _e3488;
                                    } else {
                                        phi_5963_ = _e3493;
                                    }
                                    let _e3526 = phi_5963_;
                                    if (_e3498 < _e3503) {
                                        phi_5968_ = _e3498;
                                    } else {
                                        phi_5968_ = _e3503;
                                    }
                                    let _e3529 = phi_5968_;
                                    if (_e3526 < _e3529) {
                                        phi_5973_ = _e3526;
                                    } else {
                                        phi_5973_ = _e3529;
                                    }
                                    let _e3532 = phi_5973_;
                                    if (_e3508 < _e3513) {
                                        phi_5978_ = _e3508;
                                    } else {
                                        phi_5978_ = _e3513;
                                    }
                                    let _e3535 = phi_5978_;
                                    if (_e3518 < _e3523) {
                                        phi_5983_ = _e3518;
                                    } else {
                                        phi_5983_ = _e3523;
                                    }
                                    let _e3538 = phi_5983_;
                                    if (_e3535 < _e3538) {
                                        phi_5988_ = _e3535;
                                    } else {
                                        phi_5988_ = _e3538;
                                    }
                                    let _e3541 = phi_5988_;
                                    if (_e3532 < _e3541) {
                                        phi_5993_ = _e3532;
                                    } else {
                                        phi_5993_ = _e3541;
                                    }
                                    let _e3544 = phi_5993_;
                                    if (_e3488 > _e3493) {
                                        phi_5998_ = _e3488;
                                    } else {
                                        phi_5998_ = _e3493;
                                    }
                                    let _e3547 = phi_5998_;
                                    if (_e3498 > _e3503) {
                                        phi_6003_ = _e3498;
                                    } else {
                                        phi_6003_ = _e3503;
                                    }
                                    let _e3550 = phi_6003_;
                                    if (_e3547 > _e3550) {
                                        phi_6008_ = _e3547;
                                    } else {
                                        phi_6008_ = _e3550;
                                    }
                                    let _e3553 = phi_6008_;
                                    if (_e3508 > _e3513) {
                                        phi_6013_ = _e3508;
                                    } else {
                                        phi_6013_ = _e3513;
                                    }
                                    let _e3556 = phi_6013_;
                                    if (_e3518 > _e3523) {
                                        phi_6018_ = _e3518;
                                    } else {
                                        phi_6018_ = _e3523;
                                    }
                                    let _e3559 = phi_6018_;
                                    if (_e3556 > _e3559) {
                                        phi_6023_ = _e3556;
                                    } else {
                                        phi_6023_ = _e3559;
                                    }
                                    let _e3562 = phi_6023_;
                                    if (_e3553 > _e3562) {
                                        phi_6028_ = _e3553;
                                    } else {
                                        phi_6028_ = _e3562;
                                    }
                                    let _e3565 = phi_6028_;
                                    if (_e3477 < 0f) {
                                        phi_6034_ = -(_e3477);
                                    } else {
                                        phi_6034_ = _e3477;
                                    }
                                    let _e3569 = phi_6034_;
                                    if (_e3480 < 0f) {
                                        phi_6040_ = -(_e3480);
                                    } else {
                                        phi_6040_ = _e3480;
                                    }
                                    let _e3573 = phi_6040_;
                                    if (_e3483 < 0f) {
                                        phi_6047_ = -(_e3483);
                                    } else {
                                        phi_6047_ = _e3483;
                                    }
                                    let _e3578 = phi_6047_;
                                    let _e3579 = ((_e3569 + _e3573) + _e3578);
                                    let _e3584 = -(_e3565);
                                    if (_e3544 > _e3584) {
                                        phi_6058_ = _e3544;
                                    } else {
                                        phi_6058_ = _e3584;
                                    }
                                    let _e3587 = phi_6058_;
                                    let _e3592 = (((_e3587 - ((_e3579 * _e3349) * (0.000000059604645f * (17f / 2f)))) - (_e3579 * _e3356)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3474 > _e3592) {
                                        phi_6068_ = _e3474;
                                    } else {
                                        phi_6068_ = _e3592;
                                    }
                                    let _e3595 = phi_6068_;
                                    let _e3596 = (_e3125 - _e3110);
                                    let _e3597 = (_e3126 - _e3111);
                                    let _e3598 = (_e3127 - _e3112);
                                    let _e3601 = ((_e3133 * _e3598) - (_e3136 * _e3597));
                                    let _e3604 = ((_e3136 * _e3596) - (_e3130 * _e3598));
                                    let _e3607 = ((_e3130 * _e3597) - (_e3133 * _e3596));
                                    let _e3612 = (((_e3601 * _e3139[0]) + (_e3604 * _e3139[1])) + (_e3607 * _e3139[2]));
                                    let _e3617 = (((_e3601 * _e3155) + (_e3604 * _e3156)) + (_e3607 * _e3157));
                                    let _e3622 = (((_e3601 * _e3158) + (_e3604 * _e3159)) + (_e3607 * _e3160));
                                    let _e3627 = (((_e3601 * _e3139[0]) + (_e3604 * _e3139[1])) + (_e3607 * _e3139[2]));
                                    let _e3632 = (((_e3601 * _e3163[0]) + (_e3604 * _e3163[1])) + (_e3607 * _e3163[2]));
                                    let _e3637 = (((_e3601 * _e3179) + (_e3604 * _e3180)) + (_e3607 * _e3181));
                                    let _e3642 = (((_e3601 * _e3182) + (_e3604 * _e3183)) + (_e3607 * _e3184));
                                    let _e3647 = (((_e3601 * _e3163[0]) + (_e3604 * _e3163[1])) + (_e3607 * _e3163[2]));
                                    if (_e3612 < _e3617) {
                                        phi_6141_ = _e3612;
                                    } else {
                                        phi_6141_ = _e3617;
                                    }
                                    let _e3650 = phi_6141_;
                                    if (_e3622 < _e3627) {
                                        phi_6146_ = _e3622;
                                    } else {
                                        phi_6146_ = _e3627;
                                    }
                                    let _e3653 = phi_6146_;
                                    if (_e3650 < _e3653) {
                                        phi_6151_ = _e3650;
                                    } else {
                                        phi_6151_ = _e3653;
                                    }
                                    let _e3656 = phi_6151_;
                                    if (_e3632 < _e3637) {
                                        phi_6156_ = _e3632;
                                    } else {
                                        phi_6156_ = _e3637;
                                    }
                                    let _e3659 = phi_6156_;
                                    if (_e3642 < _e3647) {
                                        phi_6161_ = _e3642;
                                    } else {
                                        phi_6161_ = _e3647;
                                    }
                                    let _e3662 = phi_6161_;
                                    if (_e3659 < _e3662) {
                                        phi_6166_ = _e3659;
                                    } else {
                                        phi_6166_ = _e3662;
                                    }
                                    let _e3665 = phi_6166_;
                                    if (_e3656 < _e3665) {
                                        phi_6171_ = _e3656;
                                    } else {
                                        phi_6171_ = _e3665;
                                    }
                                    let _e3668 = phi_6171_;
                                    if (_e3612 > _e3617) {
                                        phi_6176_ = _e3612;
                                    } else {
                                        phi_6176_ = _e3617;
                                    }
                                    let _e3671 = phi_6176_;
                                    if (_e3622 > _e3627) {
                                        phi_6181_ = _e3622;
                                    } else {
                                        phi_6181_ = _e3627;
                                    }
                                    let _e3674 = phi_6181_;
                                    if (_e3671 > _e3674) {
                                        phi_6186_ = _e3671;
                                    } else {
                                        phi_6186_ = _e3674;
                                    }
                                    let _e3677 = phi_6186_;
                                    if (_e3632 > _e3637) {
                                        phi_6191_ = _e3632;
                                    } else {
                                        phi_6191_ = _e3637;
                                    }
                                    let _e3680 = phi_6191_;
                                    if (_e3642 > _e3647) {
                                        phi_6196_ = _e3642;
                                    } else {
                                        phi_6196_ = _e3647;
                                    }
                                    let _e3683 = phi_6196_;
                                    if (_e3680 > _e3683) {
                                        phi_6201_ = _e3680;
                                    } else {
                                        phi_6201_ = _e3683;
                                    }
                                    let _e3686 = phi_6201_;
                                    if (_e3677 > _e3686) {
                                        phi_6206_ = _e3677;
                                    } else {
                                        phi_6206_ = _e3686;
                                    }
                                    let _e3689 = phi_6206_;
                                    if (_e3601 < 0f) {
                                        phi_6212_ = -(_e3601);
                                    } else {
                                        phi_6212_ = _e3601;
                                    }
                                    let _e3693 = phi_6212_;
                                    if (_e3604 < 0f) {
                                        phi_6218_ = -(_e3604);
                                    } else {
                                        phi_6218_ = _e3604;
                                    }
                                    let _e3697 = phi_6218_;
                                    if (_e3607 < 0f) {
                                        phi_6225_ = -(_e3607);
                                    } else {
                                        phi_6225_ = _e3607;
                                    }
                                    let _e3702 = phi_6225_;
                                    let _e3703 = ((_e3693 + _e3697) + _e3702);
                                    let _e3708 = -(_e3689);
                                    if (_e3668 > _e3708) {
                                        phi_6236_ = _e3668;
                                    } else {
                                        phi_6236_ = _e3708;
                                    }
                                    let _e3711 = phi_6236_;
                                    let _e3716 = (((_e3711 - ((_e3703 * _e3349) * (0.000000059604645f * (17f / 2f)))) - (_e3703 * _e3356)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3595 > _e3716) {
                                        phi_6246_ = _e3595;
                                    } else {
                                        phi_6246_ = _e3716;
                                    }
                                    let _e3719 = phi_6246_;
                                    phi_6250_ = (_e3097 || (_e3719 > 0f));
                                }
                                let _e3723 = phi_6250_;
                                if _e3723 {
                                    let _e3726 = local_1.member_1[0u];
                                    let _e3732 = local_1.member_2[0u];
                                    let _e3738 = ((_e3726[1] * _e3732[2]) - (_e3726[2] * _e3732[1]));
                                    let _e3741 = ((_e3726[2] * _e3732[0]) - (_e3726[0] * _e3732[2]));
                                    let _e3744 = ((_e3726[0] * _e3732[1]) - (_e3726[1] * _e3732[0]));
                                    let _e3747 = local_1.member_1[1u];
                                    let _e3753 = local_1.member_2[1u];
                                    let _e3759 = ((_e3747[1] * _e3753[2]) - (_e3747[2] * _e3753[1]));
                                    let _e3762 = ((_e3747[2] * _e3753[0]) - (_e3747[0] * _e3753[2]));
                                    let _e3765 = ((_e3747[0] * _e3753[1]) - (_e3747[1] * _e3753[0]));
                                    let _e3768 = local_1.member_1[0u];
                                    let _e3774 = local_1.member_2[1u];
                                    let _e3789 = local_1.member_1[1u];
                                    let _e3795 = local_1.member_2[0u];
                                    let _e3808 = (((_e3768[1] * _e3774[2]) - (_e3768[2] * _e3774[1])) + ((_e3789[1] * _e3795[2]) - (_e3789[2] * _e3795[1])));
                                    let _e3809 = (((_e3768[2] * _e3774[0]) - (_e3768[0] * _e3774[2])) + ((_e3789[2] * _e3795[0]) - (_e3789[0] * _e3795[2])));
                                    let _e3810 = (((_e3768[0] * _e3774[1]) - (_e3768[1] * _e3774[0])) + ((_e3789[0] * _e3795[1]) - (_e3789[1] * _e3795[0])));
                                    let _e3813 = local_1.member[0u];
                                    let _e3824 = local_1.member[1u];
                                    let _e3835 = local_1.member[0u];
                                    let _e3844 = ((((_e3824[0] * _e3738) + (_e3824[1] * _e3741)) + (_e3824[2] * _e3744)) + (((_e3835[0] * _e3808) + (_e3835[1] * _e3809)) + (_e3835[2] * _e3810)));
                                    let _e3847 = local_1.member[0u];
                                    let _e3858 = local_1.member[1u];
                                    let _e3867 = ((((_e3847[0] * _e3759) + (_e3847[1] * _e3762)) + (_e3847[2] * _e3765)) + (((_e3858[0] * _e3808) + (_e3858[1] * _e3809)) + (_e3858[2] * _e3810)));
                                    let _e3870 = local_1.member[1u];
                                    let _e3881 = local_1.member[0u];
                                    if (_e3881[0] < 0f) {
                                        phi_6495_ = -(_e3881[0]);
                                    } else {
                                        phi_6495_ = _e3881[0];
                                    }
                                    let _e3888 = phi_6495_;
                                    if (_e3881[1] < 0f) {
                                        phi_6502_ = -(_e3881[1]);
                                    } else {
                                        phi_6502_ = _e3881[1];
                                    }
                                    let _e3892 = phi_6502_;
                                    if (_e3888 > _e3892) {
                                        phi_6507_ = _e3888;
                                    } else {
                                        phi_6507_ = _e3892;
                                    }
                                    let _e3895 = phi_6507_;
                                    if (_e3881[2] < 0f) {
                                        phi_6514_ = -(_e3881[2]);
                                    } else {
                                        phi_6514_ = _e3881[2];
                                    }
                                    let _e3899 = phi_6514_;
                                    if (_e3895 > _e3899) {
                                        phi_6519_ = _e3895;
                                    } else {
                                        phi_6519_ = _e3899;
                                    }
                                    let _e3902 = phi_6519_;
                                    let _e3905 = local_1.member[1u];
                                    if (_e3905[0] < 0f) {
                                        phi_6532_ = -(_e3905[0]);
                                    } else {
                                        phi_6532_ = _e3905[0];
                                    }
                                    let _e3912 = phi_6532_;
                                    if (_e3905[1] < 0f) {
                                        phi_6539_ = -(_e3905[1]);
                                    } else {
                                        phi_6539_ = _e3905[1];
                                    }
                                    let _e3916 = phi_6539_;
                                    if (_e3912 > _e3916) {
                                        phi_6544_ = _e3912;
                                    } else {
                                        phi_6544_ = _e3916;
                                    }
                                    let _e3919 = phi_6544_;
                                    if (_e3905[2] < 0f) {
                                        phi_6551_ = -(_e3905[2]);
                                    } else {
                                        phi_6551_ = _e3905[2];
                                    }
                                    let _e3923 = phi_6551_;
                                    if (_e3919 > _e3923) {
                                        phi_6556_ = _e3919;
                                    } else {
                                        phi_6556_ = _e3923;
                                    }
                                    let _e3926 = phi_6556_;
                                    if (_e3902 > _e3926) {
                                        phi_6561_ = _e3902;
                                    } else {
                                        phi_6561_ = _e3926;
                                    }
                                    let _e3929 = phi_6561_;
                                    let _e3931 = local_1.member_3;
                                    let _e3932 = (_e3929 + _e3931);
                                    let _e3935 = local_1.member_1[0u];
                                    if (_e3935[0] < 0f) {
                                        phi_6578_ = -(_e3935[0]);
                                    } else {
                                        phi_6578_ = _e3935[0];
                                    }
                                    let _e3942 = phi_6578_;
                                    if (_e3935[1] < 0f) {
                                        phi_6585_ = -(_e3935[1]);
                                    } else {
                                        phi_6585_ = _e3935[1];
                                    }
                                    let _e3946 = phi_6585_;
                                    if (_e3942 > _e3946) {
                                        phi_6590_ = _e3942;
                                    } else {
                                        phi_6590_ = _e3946;
                                    }
                                    let _e3949 = phi_6590_;
                                    if (_e3935[2] < 0f) {
                                        phi_6597_ = -(_e3935[2]);
                                    } else {
                                        phi_6597_ = _e3935[2];
                                    }
                                    let _e3953 = phi_6597_;
                                    if (_e3949 > _e3953) {
                                        phi_6602_ = _e3949;
                                    } else {
                                        phi_6602_ = _e3953;
                                    }
                                    let _e3956 = phi_6602_;
                                    let _e3959 = local_1.member_1[1u];
                                    if (_e3959[0] < 0f) {
                                        phi_6616_ = -(_e3959[0]);
                                    } else {
                                        phi_6616_ = _e3959[0];
                                    }
                                    let _e3966 = phi_6616_;
                                    if (_e3959[1] < 0f) {
                                        phi_6623_ = -(_e3959[1]);
                                    } else {
                                        phi_6623_ = _e3959[1];
                                    }
                                    let _e3970 = phi_6623_;
                                    if (_e3966 > _e3970) {
                                        phi_6628_ = _e3966;
                                    } else {
                                        phi_6628_ = _e3970;
                                    }
                                    let _e3973 = phi_6628_;
                                    if (_e3959[2] < 0f) {
                                        phi_6635_ = -(_e3959[2]);
                                    } else {
                                        phi_6635_ = _e3959[2];
                                    }
                                    let _e3977 = phi_6635_;
                                    if (_e3973 > _e3977) {
                                        phi_6640_ = _e3973;
                                    } else {
                                        phi_6640_ = _e3977;
                                    }
                                    let _e3980 = phi_6640_;
                                    if (_e3956 > _e3980) {
                                        phi_6645_ = _e3956;
                                    } else {
                                        phi_6645_ = _e3980;
                                    }
                                    let _e3983 = phi_6645_;
                                    let _e3985 = local_1.member_3;
                                    let _e3986 = (_e3983 + _e3985);
                                    let _e3989 = local_1.member_2[0u];
                                    if (_e3989[0] < 0f) {
                                        phi_6662_ = -(_e3989[0]);
                                    } else {
                                        phi_6662_ = _e3989[0];
                                    }
                                    let _e3996 = phi_6662_;
                                    if (_e3989[1] < 0f) {
                                        phi_6669_ = -(_e3989[1]);
                                    } else {
                                        phi_6669_ = _e3989[1];
                                    }
                                    let _e4000 = phi_6669_;
                                    if (_e3996 > _e4000) {
                                        phi_6674_ = _e3996;
                                    } else {
                                        phi_6674_ = _e4000;
                                    }
                                    let _e4003 = phi_6674_;
                                    if (_e3989[2] < 0f) {
                                        phi_6681_ = -(_e3989[2]);
                                    } else {
                                        phi_6681_ = _e3989[2];
                                    }
                                    let _e4007 = phi_6681_;
                                    if (_e4003 > _e4007) {
                                        phi_6686_ = _e4003;
                                    } else {
                                        phi_6686_ = _e4007;
                                    }
                                    let _e4010 = phi_6686_;
                                    let _e4013 = local_1.member_2[1u];
                                    if (_e4013[0] < 0f) {
                                        phi_6700_ = -(_e4013[0]);
                                    } else {
                                        phi_6700_ = _e4013[0];
                                    }
                                    let _e4020 = phi_6700_;
                                    if (_e4013[1] < 0f) {
                                        phi_6707_ = -(_e4013[1]);
                                    } else {
                                        phi_6707_ = _e4013[1];
                                    }
                                    let _e4024 = phi_6707_;
                                    if (_e4020 > _e4024) {
                                        phi_6712_ = _e4020;
                                    } else {
                                        phi_6712_ = _e4024;
                                    }
                                    let _e4027 = phi_6712_;
                                    if (_e4013[2] < 0f) {
                                        phi_6719_ = -(_e4013[2]);
                                    } else {
                                        phi_6719_ = _e4013[2];
                                    }
                                    let _e4031 = phi_6719_;
                                    if (_e4027 > _e4031) {
                                        phi_6724_ = _e4027;
                                    } else {
                                        phi_6724_ = _e4031;
                                    }
                                    let _e4034 = phi_6724_;
                                    if (_e4010 > _e4034) {
                                        phi_6729_ = _e4010;
                                    } else {
                                        phi_6729_ = _e4034;
                                    }
                                    let _e4037 = phi_6729_;
                                    let _e4039 = local_1.member_3;
                                    let _e4040 = (_e4037 + _e4039);
                                    let _e4042 = ((_e3986 * 8f) * _e4040);
                                    let _e4049 = local_1.member_3;
                                    if (_e3738 < 0f) {
                                        phi_6760_ = -(_e3738);
                                    } else {
                                        phi_6760_ = _e3738;
                                    }
                                    let _e4066 = phi_6760_;
                                    if (_e3741 < 0f) {
                                        phi_6766_ = -(_e3741);
                                    } else {
                                        phi_6766_ = _e3741;
                                    }
                                    let _e4070 = phi_6766_;
                                    if (_e3744 < 0f) {
                                        phi_6773_ = -(_e3744);
                                    } else {
                                        phi_6773_ = _e3744;
                                    }
                                    let _e4075 = phi_6773_;
                                    let _e4076 = ((_e4066 + _e4070) + _e4075);
                                    if (_e3759 < 0f) {
                                        phi_6780_ = -(_e3759);
                                    } else {
                                        phi_6780_ = _e3759;
                                    }
                                    let _e4080 = phi_6780_;
                                    if (_e3762 < 0f) {
                                        phi_6786_ = -(_e3762);
                                    } else {
                                        phi_6786_ = _e3762;
                                    }
                                    let _e4084 = phi_6786_;
                                    if (_e3765 < 0f) {
                                        phi_6793_ = -(_e3765);
                                    } else {
                                        phi_6793_ = _e3765;
                                    }
                                    let _e4089 = phi_6793_;
                                    let _e4090 = ((_e4080 + _e4084) + _e4089);
                                    if (_e4076 > _e4090) {
                                        phi_6799_ = _e4076;
                                    } else {
                                        phi_6799_ = _e4090;
                                    }
                                    let _e4093 = phi_6799_;
                                    if (_e3808 < 0f) {
                                        phi_6805_ = -(_e3808);
                                    } else {
                                        phi_6805_ = _e3808;
                                    }
                                    let _e4097 = phi_6805_;
                                    if (_e3809 < 0f) {
                                        phi_6811_ = -(_e3809);
                                    } else {
                                        phi_6811_ = _e3809;
                                    }
                                    let _e4101 = phi_6811_;
                                    if (_e3810 < 0f) {
                                        phi_6818_ = -(_e3810);
                                    } else {
                                        phi_6818_ = _e3810;
                                    }
                                    let _e4106 = phi_6818_;
                                    let _e4108 = (((_e4097 + _e4101) + _e4106) * 0.5f);
                                    if (_e4093 > _e4108) {
                                        phi_6825_ = _e4093;
                                    } else {
                                        phi_6825_ = _e4108;
                                    }
                                    let _e4111 = phi_6825_;
                                    let _e4116 = local_1.member_3;
                                    let _e4129 = ((((_e3813[0] * _e3738) + (_e3813[1] * _e3741)) + (_e3813[2] * _e3744)) * 3f);
                                    let _e4130 = ((((_e3870[0] * _e3759) + (_e3870[1] * _e3762)) + (_e3870[2] * _e3765)) * 3f);
                                    if (_e4129 < _e4130) {
                                        phi_6849_ = _e4129;
                                    } else {
                                        phi_6849_ = _e4130;
                                    }
                                    let _e4133 = phi_6849_;
                                    if (_e3844 < _e3867) {
                                        phi_6854_ = _e3844;
                                    } else {
                                        phi_6854_ = _e3867;
                                    }
                                    let _e4136 = phi_6854_;
                                    if (_e4133 < _e4136) {
                                        phi_6859_ = _e4133;
                                    } else {
                                        phi_6859_ = _e4136;
                                    }
                                    let _e4139 = phi_6859_;
                                    if (_e4129 > _e4130) {
                                        phi_6864_ = _e4129;
                                    } else {
                                        phi_6864_ = _e4130;
                                    }
                                    let _e4142 = phi_6864_;
                                    if (_e3844 > _e3867) {
                                        phi_6869_ = _e3844;
                                    } else {
                                        phi_6869_ = _e3867;
                                    }
                                    let _e4145 = phi_6869_;
                                    if (_e4142 > _e4145) {
                                        phi_6874_ = _e4142;
                                    } else {
                                        phi_6874_ = _e4145;
                                    }
                                    let _e4148 = phi_6874_;
                                    let _e4153 = -(_e4148);
                                    if (_e4139 > _e4153) {
                                        phi_6884_ = _e4139;
                                    } else {
                                        phi_6884_ = _e4153;
                                    }
                                    let _e4156 = phi_6884_;
                                    let _e4158 = ((_e4156 - ((((((_e3932 * 8f) * _e4042) * (0.000000059604645f * (524f / 64f))) + ((_e4049 * 19f) * ((_e3932 * (_e3986 + _e4040)) + (_e3986 * _e4040)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3932) * ((1f + _e3986) * (1f + _e4040))))) + ((_e1434 * (((_e4111 + (_e4042 * (0.000000059604645f * 8f))) + ((_e4116 * 6f) * (_e3986 + _e4040))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3986) * (1f + _e4040))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4158 {
                                        phi_7853_ = _e4158;
                                    } else {
                                        let _e4161 = local_1.member_1[0u];
                                        let _e4167 = local_1.member_1[1u];
                                        let _e4171 = (_e4161[0] + _e4167[0]);
                                        let _e4172 = (_e4161[1] + _e4167[1]);
                                        let _e4173 = (_e4161[2] + _e4167[2]);
                                        let _e4176 = local_1.member_2[0u];
                                        let _e4182 = local_1.member_2[1u];
                                        let _e4186 = (_e4176[0] + _e4182[0]);
                                        let _e4187 = (_e4176[1] + _e4182[1]);
                                        let _e4188 = (_e4176[2] + _e4182[2]);
                                        let _e4191 = ((_e4172 * _e4188) - (_e4173 * _e4187));
                                        let _e4194 = ((_e4173 * _e4186) - (_e4171 * _e4188));
                                        let _e4197 = ((_e4171 * _e4187) - (_e4172 * _e4186));
                                        let _e4200 = local_1.member[0u];
                                        let _e4206 = local_1.member_1[0u];
                                        let _e4212 = local_1.member_2[0u];
                                        let _e4216 = (_e4200[0] - _e4206[0]);
                                        let _e4217 = (_e4200[1] - _e4206[1]);
                                        let _e4218 = (_e4200[2] - _e4206[2]);
                                        let _e4219 = (_e4200[0] - _e4212[0]);
                                        let _e4220 = (_e4200[1] - _e4212[1]);
                                        let _e4221 = (_e4200[2] - _e4212[2]);
                                        let _e4224 = local_1.member[1u];
                                        let _e4230 = local_1.member_1[1u];
                                        let _e4236 = local_1.member_2[1u];
                                        let _e4240 = (_e4224[0] - _e4230[0]);
                                        let _e4241 = (_e4224[1] - _e4230[1]);
                                        let _e4242 = (_e4224[2] - _e4230[2]);
                                        let _e4243 = (_e4224[0] - _e4236[0]);
                                        let _e4244 = (_e4224[1] - _e4236[1]);
                                        let _e4245 = (_e4224[2] - _e4236[2]);
                                        let _e4248 = local_1.member[0u];
                                        if (_e4248[0] < 0f) {
                                            phi_7087_ = -(_e4248[0]);
                                        } else {
                                            phi_7087_ = _e4248[0];
                                        }
                                        let _e4255 = phi_7087_;
                                        if (_e4248[1] < 0f) {
                                            phi_7094_ = -(_e4248[1]);
                                        } else {
                                            phi_7094_ = _e4248[1];
                                        }
                                        let _e4259 = phi_7094_;
                                        if (_e4255 > _e4259) {
                                            phi_7099_ = _e4255;
                                        } else {
                                            phi_7099_ = _e4259;
                                        }
                                        let _e4262 = phi_7099_;
                                        if (_e4248[2] < 0f) {
                                            phi_7106_ = -(_e4248[2]);
                                        } else {
                                            phi_7106_ = _e4248[2];
                                        }
                                        let _e4266 = phi_7106_;
                                        if (_e4262 > _e4266) {
                                            phi_7111_ = _e4262;
                                        } else {
                                            phi_7111_ = _e4266;
                                        }
                                        let _e4269 = phi_7111_;
                                        let _e4272 = local_1.member[1u];
                                        if (_e4272[0] < 0f) {
                                            phi_7124_ = -(_e4272[0]);
                                        } else {
                                            phi_7124_ = _e4272[0];
                                        }
                                        let _e4279 = phi_7124_;
                                        if (_e4272[1] < 0f) {
                                            phi_7131_ = -(_e4272[1]);
                                        } else {
                                            phi_7131_ = _e4272[1];
                                        }
                                        let _e4283 = phi_7131_;
                                        if (_e4279 > _e4283) {
                                            phi_7136_ = _e4279;
                                        } else {
                                            phi_7136_ = _e4283;
                                        }
                                        let _e4286 = phi_7136_;
                                        if (_e4272[2] < 0f) {
                                            phi_7143_ = -(_e4272[2]);
                                        } else {
                                            phi_7143_ = _e4272[2];
                                        }
                                        let _e4290 = phi_7143_;
                                        if (_e4286 > _e4290) {
                                            phi_7148_ = _e4286;
                                        } else {
                                            phi_7148_ = _e4290;
                                        }
                                        let _e4293 = phi_7148_;
                                        if (_e4269 > _e4293) {
                                            phi_7153_ = _e4269;
                                        } else {
                                            phi_7153_ = _e4293;
                                        }
                                        let _e4296 = phi_7153_;
                                        let _e4298 = local_1.member_3;
                                        let _e4302 = local_1.member_1[0u];
                                        if (_e4302[0] < 0f) {
                                            phi_7170_ = -(_e4302[0]);
                                        } else {
                                            phi_7170_ = _e4302[0];
                                        }
                                        let _e4309 = phi_7170_;
                                        if (_e4302[1] < 0f) {
                                            phi_7177_ = -(_e4302[1]);
                                        } else {
                                            phi_7177_ = _e4302[1];
                                        }
                                        let _e4313 = phi_7177_;
                                        if (_e4309 > _e4313) {
                                            phi_7182_ = _e4309;
                                        } else {
                                            phi_7182_ = _e4313;
                                        }
                                        let _e4316 = phi_7182_;
                                        if (_e4302[2] < 0f) {
                                            phi_7189_ = -(_e4302[2]);
                                        } else {
                                            phi_7189_ = _e4302[2];
                                        }
                                        let _e4320 = phi_7189_;
                                        if (_e4316 > _e4320) {
                                            phi_7194_ = _e4316;
                                        } else {
                                            phi_7194_ = _e4320;
                                        }
                                        let _e4323 = phi_7194_;
                                        let _e4326 = local_1.member_1[1u];
                                        if (_e4326[0] < 0f) {
                                            phi_7208_ = -(_e4326[0]);
                                        } else {
                                            phi_7208_ = _e4326[0];
                                        }
                                        let _e4333 = phi_7208_;
                                        if (_e4326[1] < 0f) {
                                            phi_7215_ = -(_e4326[1]);
                                        } else {
                                            phi_7215_ = _e4326[1];
                                        }
                                        let _e4337 = phi_7215_;
                                        if (_e4333 > _e4337) {
                                            phi_7220_ = _e4333;
                                        } else {
                                            phi_7220_ = _e4337;
                                        }
                                        let _e4340 = phi_7220_;
                                        if (_e4326[2] < 0f) {
                                            phi_7227_ = -(_e4326[2]);
                                        } else {
                                            phi_7227_ = _e4326[2];
                                        }
                                        let _e4344 = phi_7227_;
                                        if (_e4340 > _e4344) {
                                            phi_7232_ = _e4340;
                                        } else {
                                            phi_7232_ = _e4344;
                                        }
                                        let _e4347 = phi_7232_;
                                        if (_e4323 > _e4347) {
                                            phi_7237_ = _e4323;
                                        } else {
                                            phi_7237_ = _e4347;
                                        }
                                        let _e4350 = phi_7237_;
                                        let _e4352 = local_1.member_3;
                                        let _e4356 = local_1.member_2[0u];
                                        if (_e4356[0] < 0f) {
                                            phi_7254_ = -(_e4356[0]);
                                        } else {
                                            phi_7254_ = _e4356[0];
                                        }
                                        let _e4363 = phi_7254_;
                                        if (_e4356[1] < 0f) {
                                            phi_7261_ = -(_e4356[1]);
                                        } else {
                                            phi_7261_ = _e4356[1];
                                        }
                                        let _e4367 = phi_7261_;
                                        if (_e4363 > _e4367) {
                                            phi_7266_ = _e4363;
                                        } else {
                                            phi_7266_ = _e4367;
                                        }
                                        let _e4370 = phi_7266_;
                                        if (_e4356[2] < 0f) {
                                            phi_7273_ = -(_e4356[2]);
                                        } else {
                                            phi_7273_ = _e4356[2];
                                        }
                                        let _e4374 = phi_7273_;
                                        if (_e4370 > _e4374) {
                                            phi_7278_ = _e4370;
                                        } else {
                                            phi_7278_ = _e4374;
                                        }
                                        let _e4377 = phi_7278_;
                                        let _e4380 = local_1.member_2[1u];
                                        if (_e4380[0] < 0f) {
                                            phi_7292_ = -(_e4380[0]);
                                        } else {
                                            phi_7292_ = _e4380[0];
                                        }
                                        let _e4387 = phi_7292_;
                                        if (_e4380[1] < 0f) {
                                            phi_7299_ = -(_e4380[1]);
                                        } else {
                                            phi_7299_ = _e4380[1];
                                        }
                                        let _e4391 = phi_7299_;
                                        if (_e4387 > _e4391) {
                                            phi_7304_ = _e4387;
                                        } else {
                                            phi_7304_ = _e4391;
                                        }
                                        let _e4394 = phi_7304_;
                                        if (_e4380[2] < 0f) {
                                            phi_7311_ = -(_e4380[2]);
                                        } else {
                                            phi_7311_ = _e4380[2];
                                        }
                                        let _e4398 = phi_7311_;
                                        if (_e4394 > _e4398) {
                                            phi_7316_ = _e4394;
                                        } else {
                                            phi_7316_ = _e4398;
                                        }
                                        let _e4401 = phi_7316_;
                                        if (_e4377 > _e4401) {
                                            phi_7321_ = _e4377;
                                        } else {
                                            phi_7321_ = _e4401;
                                        }
                                        let _e4404 = phi_7321_;
                                        let _e4406 = local_1.member_3;
                                        let _e4410 = ((((_e4296 + _e4298) + (_e4350 + _e4352)) + (_e4404 + _e4406)) * 2f);
                                        let _e4413 = local_1.member_3;
                                        let _e4417 = (((_e1434 * 1.0001f) + (_e4413 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4420 = ((_e4194 * _e4173) - (_e4197 * _e4172));
                                        let _e4423 = ((_e4197 * _e4171) - (_e4191 * _e4173));
                                        let _e4426 = ((_e4191 * _e4172) - (_e4194 * _e4171));
                                        let _e4431 = (((_e4420 * _e4200[0]) + (_e4423 * _e4200[1])) + (_e4426 * _e4200[2]));
                                        let _e4436 = (((_e4420 * _e4216) + (_e4423 * _e4217)) + (_e4426 * _e4218));
                                        let _e4441 = (((_e4420 * _e4219) + (_e4423 * _e4220)) + (_e4426 * _e4221));
                                        let _e4446 = (((_e4420 * _e4200[0]) + (_e4423 * _e4200[1])) + (_e4426 * _e4200[2]));
                                        let _e4451 = (((_e4420 * _e4224[0]) + (_e4423 * _e4224[1])) + (_e4426 * _e4224[2]));
                                        let _e4456 = (((_e4420 * _e4240) + (_e4423 * _e4241)) + (_e4426 * _e4242));
                                        let _e4461 = (((_e4420 * _e4243) + (_e4423 * _e4244)) + (_e4426 * _e4245));
                                        let _e4466 = (((_e4420 * _e4224[0]) + (_e4423 * _e4224[1])) + (_e4426 * _e4224[2]));
                                        if (_e4431 < _e4436) {
                                            phi_7400_ = _e4431;
                                        } else {
                                            phi_7400_ = _e4436;
                                        }
                                        let _e4469 = phi_7400_;
                                        if (_e4441 < _e4446) {
                                            phi_7405_ = _e4441;
                                        } else {
                                            phi_7405_ = _e4446;
                                        }
                                        let _e4472 = phi_7405_;
                                        if (_e4469 < _e4472) {
                                            phi_7410_ = _e4469;
                                        } else {
                                            phi_7410_ = _e4472;
                                        }
                                        let _e4475 = phi_7410_;
                                        if (_e4451 < _e4456) {
                                            phi_7415_ = _e4451;
                                        } else {
                                            phi_7415_ = _e4456;
                                        }
                                        let _e4478 = phi_7415_;
                                        if (_e4461 < _e4466) {
                                            phi_7420_ = _e4461;
                                        } else {
                                            phi_7420_ = _e4466;
                                        }
                                        let _e4481 = phi_7420_;
                                        if (_e4478 < _e4481) {
                                            phi_7425_ = _e4478;
                                        } else {
                                            phi_7425_ = _e4481;
                                        }
                                        let _e4484 = phi_7425_;
                                        if (_e4475 < _e4484) {
                                            phi_7430_ = _e4475;
                                        } else {
                                            phi_7430_ = _e4484;
                                        }
                                        let _e4487 = phi_7430_;
                                        if (_e4431 > _e4436) {
                                            phi_7435_ = _e4431;
                                        } else {
                                            phi_7435_ = _e4436;
                                        }
                                        let _e4490 = phi_7435_;
                                        if (_e4441 > _e4446) {
                                            phi_7440_ = _e4441;
                                        } else {
                                            phi_7440_ = _e4446;
                                        }
                                        let _e4493 = phi_7440_;
                                        if (_e4490 > _e4493) {
                                            phi_7445_ = _e4490;
                                        } else {
                                            phi_7445_ = _e4493;
                                        }
                                        let _e4496 = phi_7445_;
                                        if (_e4451 > _e4456) {
                                            phi_7450_ = _e4451;
                                        } else {
                                            phi_7450_ = _e4456;
                                        }
                                        let _e4499 = phi_7450_;
                                        if (_e4461 > _e4466) {
                                            phi_7455_ = _e4461;
                                        } else {
                                            phi_7455_ = _e4466;
                                        }
                                        let _e4502 = phi_7455_;
                                        if (_e4499 > _e4502) {
                                            phi_7460_ = _e4499;
                                        } else {
                                            phi_7460_ = _e4502;
                                        }
                                        let _e4505 = phi_7460_;
                                        if (_e4496 > _e4505) {
                                            phi_7465_ = _e4496;
                                        } else {
                                            phi_7465_ = _e4505;
                                        }
                                        let _e4508 = phi_7465_;
                                        if (_e4420 < 0f) {
                                            phi_7471_ = -(_e4420);
                                        } else {
                                            phi_7471_ = _e4420;
                                        }
                                        let _e4512 = phi_7471_;
                                        if (_e4423 < 0f) {
                                            phi_7477_ = -(_e4423);
                                        } else {
                                            phi_7477_ = _e4423;
                                        }
                                        let _e4516 = phi_7477_;
                                        if (_e4426 < 0f) {
                                            phi_7484_ = -(_e4426);
                                        } else {
                                            phi_7484_ = _e4426;
                                        }
                                        let _e4521 = phi_7484_;
                                        let _e4522 = ((_e4512 + _e4516) + _e4521);
                                        let _e4527 = -(_e4508);
                                        if (_e4487 > _e4527) {
                                            phi_7495_ = _e4487;
                                        } else {
                                            phi_7495_ = _e4527;
                                        }
                                        let _e4530 = phi_7495_;
                                        let _e4535 = (((_e4530 - ((_e4522 * _e4410) * (0.000000059604645f * (17f / 2f)))) - (_e4522 * _e4417)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4538 = ((_e4194 * _e4188) - (_e4197 * _e4187));
                                        let _e4541 = ((_e4197 * _e4186) - (_e4191 * _e4188));
                                        let _e4544 = ((_e4191 * _e4187) - (_e4194 * _e4186));
                                        let _e4549 = (((_e4538 * _e4200[0]) + (_e4541 * _e4200[1])) + (_e4544 * _e4200[2]));
                                        let _e4554 = (((_e4538 * _e4216) + (_e4541 * _e4217)) + (_e4544 * _e4218));
                                        let _e4559 = (((_e4538 * _e4219) + (_e4541 * _e4220)) + (_e4544 * _e4221));
                                        let _e4564 = (((_e4538 * _e4200[0]) + (_e4541 * _e4200[1])) + (_e4544 * _e4200[2]));
                                        let _e4569 = (((_e4538 * _e4224[0]) + (_e4541 * _e4224[1])) + (_e4544 * _e4224[2]));
                                        let _e4574 = (((_e4538 * _e4240) + (_e4541 * _e4241)) + (_e4544 * _e4242));
                                        let _e4579 = (((_e4538 * _e4243) + (_e4541 * _e4244)) + (_e4544 * _e4245));
                                        let _e4584 = (((_e4538 * _e4224[0]) + (_e4541 * _e4224[1])) + (_e4544 * _e4224[2]));
                                        if (_e4549 < _e4554) {
                                            phi_7566_ = _e4549;
                                        } else {
                                            phi_7566_ = _e4554;
                                        }
                                        let _e4587 = phi_7566_;
                                        if (_e4559 < _e4564) {
                                            phi_7571_ = _e4559;
                                        } else {
                                            phi_7571_ = _e4564;
                                        }
                                        let _e4590 = phi_7571_;
                                        if (_e4587 < _e4590) {
                                            phi_7576_ = _e4587;
                                        } else {
                                            phi_7576_ = _e4590;
                                        }
                                        let _e4593 = phi_7576_;
                                        if (_e4569 < _e4574) {
                                            phi_7581_ = _e4569;
                                        } else {
                                            phi_7581_ = _e4574;
                                        }
                                        let _e4596 = phi_7581_;
                                        if (_e4579 < _e4584) {
                                            phi_7586_ = _e4579;
                                        } else {
                                            phi_7586_ = _e4584;
                                        }
                                        let _e4599 = phi_7586_;
                                        if (_e4596 < _e4599) {
                                            phi_7591_ = _e4596;
                                        } else {
                                            phi_7591_ = _e4599;
                                        }
                                        let _e4602 = phi_7591_;
                                        if (_e4593 < _e4602) {
                                            phi_7596_ = _e4593;
                                        } else {
                                            phi_7596_ = _e4602;
                                        }
                                        let _e4605 = phi_7596_;
                                        if (_e4549 > _e4554) {
                                            phi_7601_ = _e4549;
                                        } else {
                                            phi_7601_ = _e4554;
                                        }
                                        let _e4608 = phi_7601_;
                                        if (_e4559 > _e4564) {
                                            phi_7606_ = _e4559;
                                        } else {
                                            phi_7606_ = _e4564;
                                        }
                                        let _e4611 = phi_7606_;
                                        if (_e4608 > _e4611) {
                                            phi_7611_ = _e4608;
                                        } else {
                                            phi_7611_ = _e4611;
                                        }
                                        let _e4614 = phi_7611_;
                                        if (_e4569 > _e4574) {
                                            phi_7616_ = _e4569;
                                        } else {
                                            phi_7616_ = _e4574;
                                        }
                                        let _e4617 = phi_7616_;
                                        if (_e4579 > _e4584) {
                                            phi_7621_ = _e4579;
                                        } else {
                                            phi_7621_ = _e4584;
                                        }
                                        let _e4620 = phi_7621_;
                                        if (_e4617 > _e4620) {
                                            phi_7626_ = _e4617;
                                        } else {
                                            phi_7626_ = _e4620;
                                        }
                                        let _e4623 = phi_7626_;
                                        if (_e4614 > _e4623) {
                                            phi_7631_ = _e4614;
                                        } else {
                                            phi_7631_ = _e4623;
                                        }
                                        let _e4626 = phi_7631_;
                                        if (_e4538 < 0f) {
                                            phi_7637_ = -(_e4538);
                                        } else {
                                            phi_7637_ = _e4538;
                                        }
                                        let _e4630 = phi_7637_;
                                        if (_e4541 < 0f) {
                                            phi_7643_ = -(_e4541);
                                        } else {
                                            phi_7643_ = _e4541;
                                        }
                                        let _e4634 = phi_7643_;
                                        if (_e4544 < 0f) {
                                            phi_7650_ = -(_e4544);
                                        } else {
                                            phi_7650_ = _e4544;
                                        }
                                        let _e4639 = phi_7650_;
                                        let _e4640 = ((_e4630 + _e4634) + _e4639);
                                        let _e4645 = -(_e4626);
                                        if (_e4605 > _e4645) {
                                            phi_7661_ = _e4605;
                                        } else {
                                            phi_7661_ = _e4645;
                                        }
                                        let _e4648 = phi_7661_;
                                        let _e4653 = (((_e4648 - ((_e4640 * _e4410) * (0.000000059604645f * (17f / 2f)))) - (_e4640 * _e4417)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4535 > _e4653) {
                                            phi_7671_ = _e4535;
                                        } else {
                                            phi_7671_ = _e4653;
                                        }
                                        let _e4656 = phi_7671_;
                                        let _e4657 = (_e4186 - _e4171);
                                        let _e4658 = (_e4187 - _e4172);
                                        let _e4659 = (_e4188 - _e4173);
                                        let _e4662 = ((_e4194 * _e4659) - (_e4197 * _e4658));
                                        let _e4665 = ((_e4197 * _e4657) - (_e4191 * _e4659));
                                        let _e4668 = ((_e4191 * _e4658) - (_e4194 * _e4657));
                                        let _e4673 = (((_e4662 * _e4200[0]) + (_e4665 * _e4200[1])) + (_e4668 * _e4200[2]));
                                        let _e4678 = (((_e4662 * _e4216) + (_e4665 * _e4217)) + (_e4668 * _e4218));
                                        let _e4683 = (((_e4662 * _e4219) + (_e4665 * _e4220)) + (_e4668 * _e4221));
                                        let _e4688 = (((_e4662 * _e4200[0]) + (_e4665 * _e4200[1])) + (_e4668 * _e4200[2]));
                                        let _e4693 = (((_e4662 * _e4224[0]) + (_e4665 * _e4224[1])) + (_e4668 * _e4224[2]));
                                        let _e4698 = (((_e4662 * _e4240) + (_e4665 * _e4241)) + (_e4668 * _e4242));
                                        let _e4703 = (((_e4662 * _e4243) + (_e4665 * _e4244)) + (_e4668 * _e4245));
                                        let _e4708 = (((_e4662 * _e4224[0]) + (_e4665 * _e4224[1])) + (_e4668 * _e4224[2]));
                                        if (_e4673 < _e4678) {
                                            phi_7744_ = _e4673;
                                        } else {
                                            phi_7744_ = _e4678;
                                        }
                                        let _e4711 = phi_7744_;
                                        if (_e4683 < _e4688) {
                                            phi_7749_ = _e4683;
                                        } else {
                                            phi_7749_ = _e4688;
                                        }
                                        let _e4714 = phi_7749_;
                                        if (_e4711 < _e4714) {
                                            phi_7754_ = _e4711;
                                        } else {
                                            phi_7754_ = _e4714;
                                        }
                                        let _e4717 = phi_7754_;
                                        if (_e4693 < _e4698) {
                                            phi_7759_ = _e4693;
                                        } else {
                                            phi_7759_ = _e4698;
                                        }
                                        let _e4720 = phi_7759_;
                                        if (_e4703 < _e4708) {
                                            phi_7764_ = _e4703;
                                        } else {
                                            phi_7764_ = _e4708;
                                        }
                                        let _e4723 = phi_7764_;
                                        if (_e4720 < _e4723) {
                                            phi_7769_ = _e4720;
                                        } else {
                                            phi_7769_ = _e4723;
                                        }
                                        let _e4726 = phi_7769_;
                                        if (_e4717 < _e4726) {
                                            phi_7774_ = _e4717;
                                        } else {
                                            phi_7774_ = _e4726;
                                        }
                                        let _e4729 = phi_7774_;
                                        if (_e4673 > _e4678) {
                                            phi_7779_ = _e4673;
                                        } else {
                                            phi_7779_ = _e4678;
                                        }
                                        let _e4732 = phi_7779_;
                                        if (_e4683 > _e4688) {
                                            phi_7784_ = _e4683;
                                        } else {
                                            phi_7784_ = _e4688;
                                        }
                                        let _e4735 = phi_7784_;
                                        if (_e4732 > _e4735) {
                                            phi_7789_ = _e4732;
                                        } else {
                                            phi_7789_ = _e4735;
                                        }
                                        let _e4738 = phi_7789_;
                                        if (_e4693 > _e4698) {
                                            phi_7794_ = _e4693;
                                        } else {
                                            phi_7794_ = _e4698;
                                        }
                                        let _e4741 = phi_7794_;
                                        if (_e4703 > _e4708) {
                                            phi_7799_ = _e4703;
                                        } else {
                                            phi_7799_ = _e4708;
                                        }
                                        let _e4744 = phi_7799_;
                                        if (_e4741 > _e4744) {
                                            phi_7804_ = _e4741;
                                        } else {
                                            phi_7804_ = _e4744;
                                        }
                                        let _e4747 = phi_7804_;
                                        if (_e4738 > _e4747) {
                                            phi_7809_ = _e4738;
                                        } else {
                                            phi_7809_ = _e4747;
                                        }
                                        let _e4750 = phi_7809_;
                                        if (_e4662 < 0f) {
                                            phi_7815_ = -(_e4662);
                                        } else {
                                            phi_7815_ = _e4662;
                                        }
                                        let _e4754 = phi_7815_;
                                        if (_e4665 < 0f) {
                                            phi_7821_ = -(_e4665);
                                        } else {
                                            phi_7821_ = _e4665;
                                        }
                                        let _e4758 = phi_7821_;
                                        if (_e4668 < 0f) {
                                            phi_7828_ = -(_e4668);
                                        } else {
                                            phi_7828_ = _e4668;
                                        }
                                        let _e4763 = phi_7828_;
                                        let _e4764 = ((_e4754 + _e4758) + _e4763);
                                        let _e4769 = -(_e4750);
                                        if (_e4729 > _e4769) {
                                            phi_7839_ = _e4729;
                                        } else {
                                            phi_7839_ = _e4769;
                                        }
                                        let _e4772 = phi_7839_;
                                        let _e4777 = (((_e4772 - ((_e4764 * _e4410) * (0.000000059604645f * (17f / 2f)))) - (_e4764 * _e4417)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4656 > _e4777) {
                                            phi_7849_ = _e4656;
                                        } else {
                                            phi_7849_ = _e4777;
                                        }
                                        let _e4780 = phi_7849_;
                                        phi_7853_ = (_e4158 || (_e4780 > 0f));
                                    }
                                    let _e4784 = phi_7853_;
                                    phi_7855_ = (_e3723 && _e4784);
                                } else {
                                    phi_7855_ = _e3723;
                                }
                                let _e4787 = phi_7855_;
                                phi_7857_ = (_e2572 || _e4787);
                            }
                            let _e4790 = phi_7857_;
                            if !(_e4790) {
                                let _e4793 = atomicAdd((&counters[5u]), 1u);
                                hits[_e985] = ((2147483648u | (_e4793 << bitcast<u32>(12i))) | _e988);
                            }
                        }
                        phi_7868_ = true;
                    }
                    let _e4800 = phi_7868_;
                    phi_7869_ = _e4800;
                } else {
                    phi_7869_ = false;
                }
                let _e4802 = phi_7869_;
                continue;
                continuing {
                    phi_1849_ = _e977;
                    break if !(_e4802);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4806 = atomicLoad((&counters[5u]));
                if (_e4806 > 0u) {
                    let _e4809 = atomicAdd((&output.member[0u]), _e4806);
                    if ((_e4809 + _e4806) < _e4809) {
                        let _e4813 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4809);
                }
            }
            workgroupBarrier();
            let _e4816 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4819 = atomicLoad((&counters[7u]));
                if (_e4819 > 0u) {
                    let _e4822 = atomicAdd((&output.member[1u]), _e4819);
                    if ((_e4822 + _e4819) < _e4822) {
                        let _e4826 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7919_ = type_9(0u, 16u);
            loop {
                let _e4828 = phi_7919_;
                if (_e4828.member < _e4828.member_1) {
                    phi_7920_ = type_9((_e4828.member + 1u), _e4828.member_1);
                    phi_7943_ = type_9(1u, _e4828.member);
                } else {
                    phi_7920_ = _e4828;
                    phi_7943_ = type_9(0u, type_9().member_1);
                }
                let _e4840 = phi_7920_;
                let _e4842 = phi_7943_;
                if (bitcast<i32>(_e4842.member) != 0i) {
                    let _e4848 = (_e67 + (_e4842.member_1 * 128u));
                    if (_e4848 >= _e963) {
                        phi_8040_ = false;
                    } else {
                        let _e4851 = hits[_e4848];
                        if ((_e4851 & 2147483648u) == 0u) {
                            phi_7966_ = 4294967295u;
                        } else {
                            phi_7966_ = ((_e4851 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4858 = phi_7966_;
                        if (_e4858 != 4294967295u) {
                            let _e4862 = ((_e4851 >> bitcast<u32>(10i)) & 3u);
                            let _e4869 = firsts[(2u * _e4862)];
                            let _e4872 = leaves.member[(_e4869 + ((_e4851 >> bitcast<u32>(5i)) & 31u))];
                            let _e4876 = firsts[((2u * _e4862) + 1u)];
                            let _e4879 = leaves.member[(_e4876 + (_e4851 & 31u))];
                            let _e4884 = params.member.member_1.member_3;
                            let _e4885 = (_e4816 + _e4858);
                            if (_e4885 < _e4884) {
                                let _e4887 = (2u * _e4885);
                                atomicStore((&output.member[(4u + _e4887)]), _e4872.member_1);
                                atomicStore((&output.member[(_e4887 + 5u)]), _e4879.member_1);
                            }
                        }
                        phi_8040_ = true;
                    }
                    let _e4893 = phi_8040_;
                    phi_8041_ = _e4893;
                } else {
                    phi_8041_ = false;
                }
                let _e4895 = phi_8041_;
                continue;
                continuing {
                    phi_7919_ = _e4840;
                    break if !(_e4895);
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
