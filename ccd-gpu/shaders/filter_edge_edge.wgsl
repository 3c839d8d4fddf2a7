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
    var phi_4001_: f32;
    var phi_4006_: f32;
    var phi_4011_: f32;
    var phi_4016_: f32;
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
    var phi_4072_: f32;
    var phi_4078_: f32;
    var phi_4085_: f32;
    var phi_4096_: f32;
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
    var phi_4227_: f32;
    var phi_4232_: f32;
    var phi_4238_: f32;
    var phi_4244_: f32;
    var phi_4251_: f32;
    var phi_4262_: f32;
    var phi_4272_: f32;
    var phi_4453_: bool;
    var phi_4905_: f32;
    var phi_4912_: f32;
    var phi_4917_: f32;
    var phi_4924_: f32;
    var phi_4929_: f32;
    var phi_4942_: f32;
    var phi_4949_: f32;
    var phi_4954_: f32;
    var phi_4961_: f32;
    var phi_4966_: f32;
    var phi_4971_: f32;
    var phi_4988_: f32;
    var phi_4995_: f32;
    var phi_5000_: f32;
    var phi_5007_: f32;
    var phi_5012_: f32;
    var phi_5026_: f32;
    var phi_5033_: f32;
    var phi_5038_: f32;
    var phi_5045_: f32;
    var phi_5050_: f32;
    var phi_5055_: f32;
    var phi_5072_: f32;
    var phi_5079_: f32;
    var phi_5084_: f32;
    var phi_5091_: f32;
    var phi_5096_: f32;
    var phi_5110_: f32;
    var phi_5117_: f32;
    var phi_5122_: f32;
    var phi_5129_: f32;
    var phi_5134_: f32;
    var phi_5139_: f32;
    var phi_5170_: f32;
    var phi_5176_: f32;
    var phi_5183_: f32;
    var phi_5190_: f32;
    var phi_5196_: f32;
    var phi_5203_: f32;
    var phi_5209_: f32;
    var phi_5215_: f32;
    var phi_5221_: f32;
    var phi_5228_: f32;
    var phi_5235_: f32;
    var phi_5259_: f32;
    var phi_5264_: f32;
    var phi_5269_: f32;
    var phi_5274_: f32;
    var phi_5279_: f32;
    var phi_5284_: f32;
    var phi_5294_: f32;
    var phi_5497_: f32;
    var phi_5504_: f32;
    var phi_5509_: f32;
    var phi_5516_: f32;
    var phi_5521_: f32;
    var phi_5534_: f32;
    var phi_5541_: f32;
    var phi_5546_: f32;
    var phi_5553_: f32;
    var phi_5558_: f32;
    var phi_5563_: f32;
    var phi_5580_: f32;
    var phi_5587_: f32;
    var phi_5592_: f32;
    var phi_5599_: f32;
    var phi_5604_: f32;
    var phi_5618_: f32;
    var phi_5625_: f32;
    var phi_5630_: f32;
    var phi_5637_: f32;
    var phi_5642_: f32;
    var phi_5647_: f32;
    var phi_5664_: f32;
    var phi_5671_: f32;
    var phi_5676_: f32;
    var phi_5683_: f32;
    var phi_5688_: f32;
    var phi_5702_: f32;
    var phi_5709_: f32;
    var phi_5714_: f32;
    var phi_5721_: f32;
    var phi_5726_: f32;
    var phi_5731_: f32;
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
    var phi_5875_: f32;
    var phi_5881_: f32;
    var phi_5887_: f32;
    var phi_5894_: f32;
    var phi_5905_: f32;
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
    var phi_6041_: f32;
    var phi_6047_: f32;
    var phi_6053_: f32;
    var phi_6060_: f32;
    var phi_6071_: f32;
    var phi_6081_: f32;
    var phi_6262_: bool;
    var phi_6507_: f32;
    var phi_6514_: f32;
    var phi_6519_: f32;
    var phi_6526_: f32;
    var phi_6531_: f32;
    var phi_6544_: f32;
    var phi_6551_: f32;
    var phi_6556_: f32;
    var phi_6563_: f32;
    var phi_6568_: f32;
    var phi_6573_: f32;
    var phi_6590_: f32;
    var phi_6597_: f32;
    var phi_6602_: f32;
    var phi_6609_: f32;
    var phi_6614_: f32;
    var phi_6628_: f32;
    var phi_6635_: f32;
    var phi_6640_: f32;
    var phi_6647_: f32;
    var phi_6652_: f32;
    var phi_6657_: f32;
    var phi_6674_: f32;
    var phi_6681_: f32;
    var phi_6686_: f32;
    var phi_6693_: f32;
    var phi_6698_: f32;
    var phi_6712_: f32;
    var phi_6719_: f32;
    var phi_6724_: f32;
    var phi_6731_: f32;
    var phi_6736_: f32;
    var phi_6741_: f32;
    var phi_6772_: f32;
    var phi_6778_: f32;
    var phi_6785_: f32;
    var phi_6792_: f32;
    var phi_6798_: f32;
    var phi_6805_: f32;
    var phi_6811_: f32;
    var phi_6817_: f32;
    var phi_6823_: f32;
    var phi_6830_: f32;
    var phi_6837_: f32;
    var phi_6861_: f32;
    var phi_6866_: f32;
    var phi_6871_: f32;
    var phi_6876_: f32;
    var phi_6881_: f32;
    var phi_6886_: f32;
    var phi_6896_: f32;
    var phi_7099_: f32;
    var phi_7106_: f32;
    var phi_7111_: f32;
    var phi_7118_: f32;
    var phi_7123_: f32;
    var phi_7136_: f32;
    var phi_7143_: f32;
    var phi_7148_: f32;
    var phi_7155_: f32;
    var phi_7160_: f32;
    var phi_7165_: f32;
    var phi_7182_: f32;
    var phi_7189_: f32;
    var phi_7194_: f32;
    var phi_7201_: f32;
    var phi_7206_: f32;
    var phi_7220_: f32;
    var phi_7227_: f32;
    var phi_7232_: f32;
    var phi_7239_: f32;
    var phi_7244_: f32;
    var phi_7249_: f32;
    var phi_7266_: f32;
    var phi_7273_: f32;
    var phi_7278_: f32;
    var phi_7285_: f32;
    var phi_7290_: f32;
    var phi_7304_: f32;
    var phi_7311_: f32;
    var phi_7316_: f32;
    var phi_7323_: f32;
    var phi_7328_: f32;
    var phi_7333_: f32;
    var phi_7412_: f32;
    var phi_7417_: f32;
    var phi_7422_: f32;
    var phi_7427_: f32;
    var phi_7432_: f32;
    var phi_7437_: f32;
    var phi_7442_: f32;
    var phi_7447_: f32;
    var phi_7452_: f32;
    var phi_7457_: f32;
    var phi_7462_: f32;
    var phi_7467_: f32;
    var phi_7472_: f32;
    var phi_7477_: f32;
    var phi_7483_: f32;
    var phi_7489_: f32;
    var phi_7496_: f32;
    var phi_7507_: f32;
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
    var phi_7638_: f32;
    var phi_7643_: f32;
    var phi_7649_: f32;
    var phi_7655_: f32;
    var phi_7662_: f32;
    var phi_7673_: f32;
    var phi_7683_: f32;
    var phi_7864_: bool;
    var phi_7865_: bool;
    var phi_7867_: bool;
    var phi_7877_: bool;
    var phi_7878_: bool;
    var phi_7928_: type_21;
    var phi_7929_: type_21;
    var phi_7952_: type_21;
    var phi_7975_: u32;
    var phi_8029_: type_21;
    var phi_8050_: bool;
    var phi_8051_: bool;
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
            let _e4670 = local_3;
            phi_924_ = _e4670;
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
                        phi_7877_ = false;
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
                            if ((_e2035 - ((((((_e1811 * 8f) * _e1921) * (0.000000059604645f * (524f / 64f))) + ((_e1928 * 19f) * ((_e1811 * (_e1865 + _e1919)) + (_e1865 * _e1919)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1811) * ((1f + _e1865) * (1f + _e1919))))) + ((_e1525 * (((_e1990 + (_e1921 * (0.000000059604645f * 8f))) + ((_e1995 * 6f) * (_e1865 + _e1919))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1865) * (1f + _e1919))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4453_ = true;
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
                                let _e2295 = ((((_e2181 + _e2183) + (_e2235 + _e2237)) + (_e2289 + _e2291)) * 2f);
                                let _e2298 = local_2.member_3;
                                let _e2302 = (((_e1525 * 1.0001f) + (_e2298 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2305 = ((_e2073 * _e2052) - (_e2076 * _e2051));
                                let _e2308 = ((_e2076 * _e2050) - (_e2070 * _e2052));
                                let _e2311 = ((_e2070 * _e2051) - (_e2073 * _e2050));
                                let _e2316 = (((_e2305 * _e2079[0]) + (_e2308 * _e2079[1])) + (_e2311 * _e2079[2]));
                                let _e2321 = (((_e2305 * _e2095) + (_e2308 * _e2096)) + (_e2311 * _e2097));
                                let _e2326 = (((_e2305 * _e2101) + (_e2308 * _e2102)) + (_e2311 * _e2103));
                                let _e2331 = (((_e2305 * _e2098) + (_e2308 * _e2099)) + (_e2311 * _e2100));
                                let _e2336 = (((_e2305 * _e2106[0]) + (_e2308 * _e2106[1])) + (_e2311 * _e2106[2]));
                                let _e2341 = (((_e2305 * _e2122) + (_e2308 * _e2123)) + (_e2311 * _e2124));
                                let _e2346 = (((_e2305 * _e2128) + (_e2308 * _e2129)) + (_e2311 * _e2130));
                                let _e2351 = (((_e2305 * _e2125) + (_e2308 * _e2126)) + (_e2311 * _e2127));
                                if (_e2316 < _e2321) {
                                    phi_4001_ = _e2316;
                                } else {
                                    phi_4001_ = _e2321;
                                }
                                let _e2354 = phi_4001_;
                                if (_e2326 < _e2331) {
                                    phi_4006_ = _e2326;
                                } else {
                                    phi_4006_ = _e2331;
                                }
                                let _e2357 = phi_4006_;
                                if (_e2354 < _e2357) {
                                    phi_4011_ = _e2354;
                                } else {
                                    phi_4011_ = _e2357;
                                }
                                let _e2360 = phi_4011_;
                                if (_e2336 < _e2341) {
                                    phi_4016_ = _e2336;
                                } else {
                                    phi_4016_ = _e2341;
                                }
                                let _e2363 = phi_4016_;
                                if (_e2346 < _e2351) {
                                    phi_4021_ = _e2346;
                                } else {
                                    phi_4021_ = _e2351;
                                }
                                let _e2366 = phi_4021_;
                                if (_e2363 < _e2366) {
                                    phi_4026_ = _e2363;
                                } else {
                                    phi_4026_ = _e2366;
                                }
                                let _e2369 = phi_4026_;
                                if (_e2360 < _e2369) {
                                    phi_4031_ = _e2360;
                                } else {
                                    phi_4031_ = _e2369;
                                }
                                let _e2372 = phi_4031_;
                                if (_e2316 > _e2321) {
                                    phi_4036_ = _e2316;
                                } else {
                                    phi_4036_ = _e2321;
                                }
                                let _e2375 = phi_4036_;
                                if (_e2326 > _e2331) {
                                    phi_4041_ = _e2326;
                                } else {
                                    phi_4041_ = _e2331;
                                }
                                let _e2378 = phi_4041_;
                                if (_e2375 > _e2378) {
                                    phi_4046_ = _e2375;
                                } else {
                                    phi_4046_ = _e2378;
                                }
                                let _e2381 = phi_4046_;
                                if (_e2336 > _e2341) {
                                    phi_4051_ = _e2336;
                                } else {
                                    phi_4051_ = _e2341;
                                }
                                let _e2384 = phi_4051_;
                                if (_e2346 > _e2351) {
                                    phi_4056_ = _e2346;
                                } else {
                                    phi_4056_ = _e2351;
                                }
                                let _e2387 = phi_4056_;
                                if (_e2384 > _e2387) {
                                    phi_4061_ = _e2384;
                                } else {
                                    phi_4061_ = _e2387;
                                }
                                let _e2390 = phi_4061_;
                                if (_e2381 > _e2390) {
                                    phi_4066_ = _e2381;
                                } else {
                                    phi_4066_ = _e2390;
                                }
                                let _e2393 = phi_4066_;
                                if (_e2305 < 0f) {
                                    phi_4072_ = -(_e2305);
                                } else {
                                    phi_4072_ = _e2305;
                                }
                                let _e2397 = phi_4072_;
                                if (_e2308 < 0f) {
                                    phi_4078_ = -(_e2308);
                                } else {
                                    phi_4078_ = _e2308;
                                }
                                let _e2401 = phi_4078_;
                                if (_e2311 < 0f) {
                                    phi_4085_ = -(_e2311);
                                } else {
                                    phi_4085_ = _e2311;
                                }
                                let _e2406 = phi_4085_;
                                let _e2407 = ((_e2397 + _e2401) + _e2406);
                                let _e2412 = -(_e2393);
                                if (_e2372 > _e2412) {
                                    phi_4096_ = _e2372;
                                } else {
                                    phi_4096_ = _e2412;
                                }
                                let _e2415 = phi_4096_;
                                let _e2420 = (((_e2415 - ((_e2407 * _e2295) * (0.000000059604645f * (17f / 2f)))) - (_e2407 * _e2302)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2423 = ((_e2073 * _e2067) - (_e2076 * _e2066));
                                let _e2426 = ((_e2076 * _e2065) - (_e2070 * _e2067));
                                let _e2429 = ((_e2070 * _e2066) - (_e2073 * _e2065));
                                let _e2434 = (((_e2423 * _e2079[0]) + (_e2426 * _e2079[1])) + (_e2429 * _e2079[2]));
                                let _e2439 = (((_e2423 * _e2095) + (_e2426 * _e2096)) + (_e2429 * _e2097));
                                let _e2444 = (((_e2423 * _e2101) + (_e2426 * _e2102)) + (_e2429 * _e2103));
                                let _e2449 = (((_e2423 * _e2098) + (_e2426 * _e2099)) + (_e2429 * _e2100));
                                let _e2454 = (((_e2423 * _e2106[0]) + (_e2426 * _e2106[1])) + (_e2429 * _e2106[2]));
                                let _e2459 = (((_e2423 * _e2122) + (_e2426 * _e2123)) + (_e2429 * _e2124));
                                let _e2464 = (((_e2423 * _e2128) + (_e2426 * _e2129)) + (_e2429 * _e2130));
                                let _e2469 = (((_e2423 * _e2125) + (_e2426 * _e2126)) + (_e2429 * _e2127));
                                if (_e2434 < _e2439) {
                                    phi_4167_ = _e2434;
                                } else {
                                    phi_4167_ = _e2439;
                                }
                                let _e2472 = phi_4167_;
                                if (_e2444 < _e2449) {
                                    phi_4172_ = _e2444;
                                } else {
                                    phi_4172_ = _e2449;
                                }
                                let _e2475 = phi_4172_;
                                if (_e2472 < _e2475) {
                                    phi_4177_ = _e2472;
                                } else {
                                    phi_4177_ = _e2475;
                                }
                                let _e2478 = phi_4177_;
                                if (_e2454 < _e2459) {
                                    phi_4182_ = _e2454;
                                } else {
                                    phi_4182_ = _e2459;
                                }
                                let _e2481 = phi_4182_;
                                if (_e2464 < _e2469) {
                                    phi_4187_ = _e2464;
                                } else {
                                    phi_4187_ = _e2469;
                                }
                                let _e2484 = phi_4187_;
                                if (_e2481 < _e2484) {
                                    phi_4192_ = _e2481;
                                } else {
                                    phi_4192_ = _e2484;
                                }
                                let _e2487 = phi_4192_;
                                if (_e2478 < _e2487) {
                                    phi_4197_ = _e2478;
                                } else {
                                    phi_4197_ = _e2487;
                                }
                                let _e2490 = phi_4197_;
                                if (_e2434 > _e2439) {
                                    phi_4202_ = _e2434;
                                } else {
                                    phi_4202_ = _e2439;
                                }
                                let _e2493 = phi_4202_;
                                if (_e2444 > _e2449) {
                                    phi_4207_ = _e2444;
                                } else {
                                    phi_4207_ = _e2449;
                                }
                                let _e2496 = phi_4207_;
                                if (_e2493 > _e2496) {
                                    phi_4212_ = _e2493;
                                } else {
                                    phi_4212_ = _e2496;
                                }
                                let _e2499 = phi_4212_;
                                if (_e2454 > _e2459) {
                                    phi_4217_ = _e2454;
                                } else {
                                    phi_4217_ = _e2459;
                                }
                                let _e2502 = phi_4217_;
                                if (_e2464 > _e2469) {
                                    phi_4222_ = _e2464;
                                } else {
                                    phi_4222_ = _e2469;
                                }
                                let _e2505 = phi_4222_;
                                if (_e2502 > _e2505) {
                                    phi_4227_ = _e2502;
                                } else {
                                    phi_4227_ = _e2505;
                                }
                                let _e2508 = phi_4227_;
                                if (_e2499 > _e2508) {
                                    phi_4232_ = _e2499;
                                } else {
                                    phi_4232_ = _e2508;
                                }
                                let _e2511 = phi_4232_;
                                if (_e2423 < 0f) {
                                    phi_4238_ = -(_e2423);
                                } else {
                                    phi_4238_ = _e2423;
                                }
                                let _e2515 = phi_4238_;
                                if (_e2426 < 0f) {
                                    phi_4244_ = -(_e2426);
                                } else {
                                    phi_4244_ = _e2426;
                                }
                                let _e2519 = phi_4244_;
                                if (_e2429 < 0f) {
                                    phi_4251_ = -(_e2429);
                                } else {
                                    phi_4251_ = _e2429;
                                }
                                let _e2524 = phi_4251_;
                                let _e2525 = ((_e2515 + _e2519) + _e2524);
                                let _e2530 = -(_e2511);
                                if (_e2490 > _e2530) {
                                    phi_4262_ = _e2490;
                                } else {
                                    phi_4262_ = _e2530;
                                }
                                let _e2533 = phi_4262_;
                                let _e2538 = (((_e2533 - ((_e2525 * _e2295) * (0.000000059604645f * (17f / 2f)))) - (_e2525 * _e2302)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2420 > _e2538) {
                                    phi_4272_ = _e2420;
                                } else {
                                    phi_4272_ = _e2538;
                                }
                                let _e2541 = phi_4272_;
                                phi_4453_ = (_e2541 > 0f);
                            }
                            let _e2544 = phi_4453_;
                            if _e2544 {
                                phi_7867_ = false;
                            } else {
                                let _e2547 = local_2.member[0u];
                                let _e2553 = local_2.member[1u];
                                let _e2560 = ((_e2547[0] + _e2553[0]) * 0.5f);
                                let _e2561 = ((_e2547[1] + _e2553[1]) * 0.5f);
                                let _e2562 = ((_e2547[2] + _e2553[2]) * 0.5f);
                                let _e2565 = local_2.member_1[0u];
                                let _e2571 = local_2.member_1[1u];
                                let _e2578 = ((_e2565[0] + _e2571[0]) * 0.5f);
                                let _e2579 = ((_e2565[1] + _e2571[1]) * 0.5f);
                                let _e2580 = ((_e2565[2] + _e2571[2]) * 0.5f);
                                let _e2583 = local_2.member_2[0u];
                                let _e2589 = local_2.member_2[1u];
                                let _e2596 = ((_e2583[0] + _e2589[0]) * 0.5f);
                                let _e2597 = ((_e2583[1] + _e2589[1]) * 0.5f);
                                let _e2598 = ((_e2583[2] + _e2589[2]) * 0.5f);
                                let _e2601 = local_2.member[0u];
                                let _e2604 = local_2.member_1[0u];
                                let _e2607 = local_2.member_2[0u];
                                let _e2609 = local_2.member_3;
                                let _e2612 = local_2.member[1u];
                                let _e2615 = local_2.member_1[1u];
                                let _e2618 = local_2.member_2[1u];
                                let _e2620 = local_2.member_3;
                                local = type_34(array<array<f32, 3>, 2>(_e2601, array<f32, 3>(_e2560, _e2561, _e2562)), array<array<f32, 3>, 2>(_e2604, array<f32, 3>(_e2578, _e2579, _e2580)), array<array<f32, 3>, 2>(_e2607, array<f32, 3>(_e2596, _e2597, _e2598)), _e2609);
                                local_1 = type_34(array<array<f32, 3>, 2>(array<f32, 3>(_e2560, _e2561, _e2562), _e2612), array<array<f32, 3>, 2>(array<f32, 3>(_e2578, _e2579, _e2580), _e2615), array<array<f32, 3>, 2>(array<f32, 3>(_e2596, _e2597, _e2598), _e2618), _e2620);
                                let _e2637 = local.member_1[0u];
                                let _e2643 = local.member_2[0u];
                                let _e2649 = ((_e2637[1] * _e2643[2]) - (_e2637[2] * _e2643[1]));
                                let _e2652 = ((_e2637[2] * _e2643[0]) - (_e2637[0] * _e2643[2]));
                                let _e2655 = ((_e2637[0] * _e2643[1]) - (_e2637[1] * _e2643[0]));
                                let _e2658 = local.member_1[1u];
                                let _e2664 = local.member_2[1u];
                                let _e2670 = ((_e2658[1] * _e2664[2]) - (_e2658[2] * _e2664[1]));
                                let _e2673 = ((_e2658[2] * _e2664[0]) - (_e2658[0] * _e2664[2]));
                                let _e2676 = ((_e2658[0] * _e2664[1]) - (_e2658[1] * _e2664[0]));
                                let _e2679 = local.member_1[0u];
                                let _e2685 = local.member_2[1u];
                                let _e2700 = local.member_1[1u];
                                let _e2706 = local.member_2[0u];
                                let _e2719 = (((_e2679[1] * _e2685[2]) - (_e2679[2] * _e2685[1])) + ((_e2700[1] * _e2706[2]) - (_e2700[2] * _e2706[1])));
                                let _e2720 = (((_e2679[2] * _e2685[0]) - (_e2679[0] * _e2685[2])) + ((_e2700[2] * _e2706[0]) - (_e2700[0] * _e2706[2])));
                                let _e2721 = (((_e2679[0] * _e2685[1]) - (_e2679[1] * _e2685[0])) + ((_e2700[0] * _e2706[1]) - (_e2700[1] * _e2706[0])));
                                let _e2724 = local.member[0u];
                                let _e2735 = local.member[1u];
                                let _e2746 = local.member[0u];
                                let _e2755 = ((((_e2735[0] * _e2649) + (_e2735[1] * _e2652)) + (_e2735[2] * _e2655)) + (((_e2746[0] * _e2719) + (_e2746[1] * _e2720)) + (_e2746[2] * _e2721)));
                                let _e2758 = local.member[0u];
                                let _e2769 = local.member[1u];
                                let _e2778 = ((((_e2758[0] * _e2670) + (_e2758[1] * _e2673)) + (_e2758[2] * _e2676)) + (((_e2769[0] * _e2719) + (_e2769[1] * _e2720)) + (_e2769[2] * _e2721)));
                                let _e2781 = local.member[1u];
                                let _e2792 = local.member[0u];
                                if (_e2792[0] < 0f) {
                                    phi_4905_ = -(_e2792[0]);
                                } else {
                                    phi_4905_ = _e2792[0];
                                }
                                let _e2799 = phi_4905_;
                                if (_e2792[1] < 0f) {
                                    phi_4912_ = -(_e2792[1]);
                                } else {
                                    phi_4912_ = _e2792[1];
                                }
                                let _e2803 = phi_4912_;
                                if (_e2799 > _e2803) {
                                    phi_4917_ = _e2799;
                                } else {
                                    phi_4917_ = _e2803;
                                }
                                let _e2806 = phi_4917_;
                                if (_e2792[2] < 0f) {
                                    phi_4924_ = -(_e2792[2]);
                                } else {
                                    phi_4924_ = _e2792[2];
                                }
                                let _e2810 = phi_4924_;
                                if (_e2806 > _e2810) {
                                    phi_4929_ = _e2806;
                                } else {
                                    phi_4929_ = _e2810;
                                }
                                let _e2813 = phi_4929_;
                                let _e2816 = local.member[1u];
                                if (_e2816[0] < 0f) {
                                    phi_4942_ = -(_e2816[0]);
                                } else {
                                    phi_4942_ = _e2816[0];
                                }
                                let _e2823 = phi_4942_;
                                if (_e2816[1] < 0f) {
                                    phi_4949_ = -(_e2816[1]);
                                } else {
                                    phi_4949_ = _e2816[1];
                                }
                                let _e2827 = phi_4949_;
                                if (_e2823 > _e2827) {
                                    phi_4954_ = _e2823;
                                } else {
                                    phi_4954_ = _e2827;
                                }
                                let _e2830 = phi_4954_;
                                if (_e2816[2] < 0f) {
                                    phi_4961_ = -(_e2816[2]);
                                } else {
                                    phi_4961_ = _e2816[2];
                                }
                                let _e2834 = phi_4961_;
                                if (_e2830 > _e2834) {
                                    phi_4966_ = _e2830;
                                } else {
                                    phi_4966_ = _e2834;
                                }
                                let _e2837 = phi_4966_;
                                if (_e2813 > _e2837) {
                                    phi_4971_ = _e2813;
                                } else {
                                    phi_4971_ = _e2837;
                                }
                                let _e2840 = phi_4971_;
                                let _e2842 = local.member_3;
                                let _e2843 = (_e2840 + _e2842);
                                let _e2846 = local.member_1[0u];
                                if (_e2846[0] < 0f) {
                                    phi_4988_ = -(_e2846[0]);
                                } else {
                                    phi_4988_ = _e2846[0];
                                }
                                let _e2853 = phi_4988_;
                                if (_e2846[1] < 0f) {
                                    phi_4995_ = -(_e2846[1]);
                                } else {
                                    phi_4995_ = _e2846[1];
                                }
                                let _e2857 = phi_4995_;
                                if (_e2853 > _e2857) {
                                    phi_5000_ = _e2853;
                                } else {
                                    phi_5000_ = _e2857;
                                }
                                let _e2860 = phi_5000_;
                                if (_e2846[2] < 0f) {
                                    phi_5007_ = -(_e2846[2]);
                                } else {
                                    phi_5007_ = _e2846[2];
                                }
                                let _e2864 = phi_5007_;
                                if (_e2860 > _e2864) {
                                    phi_5012_ = _e2860;
                                } else {
                                    phi_5012_ = _e2864;
                                }
                                let _e2867 = phi_5012_;
                                let _e2870 = local.member_1[1u];
                                if (_e2870[0] < 0f) {
                                    phi_5026_ = -(_e2870[0]);
                                } else {
                                    phi_5026_ = _e2870[0];
                                }
                                let _e2877 = phi_5026_;
                                if (_e2870[1] < 0f) {
                                    phi_5033_ = -(_e2870[1]);
                                } else {
                                    phi_5033_ = _e2870[1];
                                }
                                let _e2881 = phi_5033_;
                                if (_e2877 > _e2881) {
                                    phi_5038_ = _e2877;
                                } else {
                                    phi_5038_ = _e2881;
                                }
                                let _e2884 = phi_5038_;
                                if (_e2870[2] < 0f) {
                                    phi_5045_ = -(_e2870[2]);
                                } else {
                                    phi_5045_ = _e2870[2];
                                }
                                let _e2888 = phi_5045_;
                                if (_e2884 > _e2888) {
                                    phi_5050_ = _e2884;
                                } else {
                                    phi_5050_ = _e2888;
                                }
                                let _e2891 = phi_5050_;
                                if (_e2867 > _e2891) {
                                    phi_5055_ = _e2867;
                                } else {
                                    phi_5055_ = _e2891;
                                }
                                let _e2894 = phi_5055_;
                                let _e2896 = local.member_3;
                                let _e2897 = (_e2894 + _e2896);
                                let _e2900 = local.member_2[0u];
                                if (_e2900[0] < 0f) {
                                    phi_5072_ = -(_e2900[0]);
                                } else {
                                    phi_5072_ = _e2900[0];
                                }
                                let _e2907 = phi_5072_;
                                if (_e2900[1] < 0f) {
                                    phi_5079_ = -(_e2900[1]);
                                } else {
                                    phi_5079_ = _e2900[1];
                                }
                                let _e2911 = phi_5079_;
                                if (_e2907 > _e2911) {
                                    phi_5084_ = _e2907;
                                } else {
                                    phi_5084_ = _e2911;
                                }
                                let _e2914 = phi_5084_;
                                if (_e2900[2] < 0f) {
                                    phi_5091_ = -(_e2900[2]);
                                } else {
                                    phi_5091_ = _e2900[2];
                                }
                                let _e2918 = phi_5091_;
                                if (_e2914 > _e2918) {
                                    phi_5096_ = _e2914;
                                } else {
                                    phi_5096_ = _e2918;
                                }
                                let _e2921 = phi_5096_;
                                let _e2924 = local.member_2[1u];
                                if (_e2924[0] < 0f) {
                                    phi_5110_ = -(_e2924[0]);
                                } else {
                                    phi_5110_ = _e2924[0];
                                }
                                let _e2931 = phi_5110_;
                                if (_e2924[1] < 0f) {
                                    phi_5117_ = -(_e2924[1]);
                                } else {
                                    phi_5117_ = _e2924[1];
                                }
                                let _e2935 = phi_5117_;
                                if (_e2931 > _e2935) {
                                    phi_5122_ = _e2931;
                                } else {
                                    phi_5122_ = _e2935;
                                }
                                let _e2938 = phi_5122_;
                                if (_e2924[2] < 0f) {
                                    phi_5129_ = -(_e2924[2]);
                                } else {
                                    phi_5129_ = _e2924[2];
                                }
                                let _e2942 = phi_5129_;
                                if (_e2938 > _e2942) {
                                    phi_5134_ = _e2938;
                                } else {
                                    phi_5134_ = _e2942;
                                }
                                let _e2945 = phi_5134_;
                                if (_e2921 > _e2945) {
                                    phi_5139_ = _e2921;
                                } else {
                                    phi_5139_ = _e2945;
                                }
                                let _e2948 = phi_5139_;
                                let _e2950 = local.member_3;
                                let _e2951 = (_e2948 + _e2950);
                                let _e2953 = ((_e2897 * 8f) * _e2951);
                                let _e2960 = local.member_3;
                                if (_e2649 < 0f) {
                                    phi_5170_ = -(_e2649);
                                } else {
                                    phi_5170_ = _e2649;
                                }
                                let _e2977 = phi_5170_;
                                if (_e2652 < 0f) {
                                    phi_5176_ = -(_e2652);
                                } else {
                                    phi_5176_ = _e2652;
                                }
                                let _e2981 = phi_5176_;
                                if (_e2655 < 0f) {
                                    phi_5183_ = -(_e2655);
                                } else {
                                    phi_5183_ = _e2655;
                                }
                                let _e2986 = phi_5183_;
                                let _e2987 = ((_e2977 + _e2981) + _e2986);
                                if (_e2670 < 0f) {
                                    phi_5190_ = -(_e2670);
                                } else {
                                    phi_5190_ = _e2670;
                                }
                                let _e2991 = phi_5190_;
                                if (_e2673 < 0f) {
                                    phi_5196_ = -(_e2673);
                                } else {
                                    phi_5196_ = _e2673;
                                }
                                let _e2995 = phi_5196_;
                                if (_e2676 < 0f) {
                                    phi_5203_ = -(_e2676);
                                } else {
                                    phi_5203_ = _e2676;
                                }
                                let _e3000 = phi_5203_;
                                let _e3001 = ((_e2991 + _e2995) + _e3000);
                                if (_e2987 > _e3001) {
                                    phi_5209_ = _e2987;
                                } else {
                                    phi_5209_ = _e3001;
                                }
                                let _e3004 = phi_5209_;
                                if (_e2719 < 0f) {
                                    phi_5215_ = -(_e2719);
                                } else {
                                    phi_5215_ = _e2719;
                                }
                                let _e3008 = phi_5215_;
                                if (_e2720 < 0f) {
                                    phi_5221_ = -(_e2720);
                                } else {
                                    phi_5221_ = _e2720;
                                }
                                let _e3012 = phi_5221_;
                                if (_e2721 < 0f) {
                                    phi_5228_ = -(_e2721);
                                } else {
                                    phi_5228_ = _e2721;
                                }
                                let _e3017 = phi_5228_;
                                let _e3019 = (((_e3008 + _e3012) + _e3017) * 0.5f);
                                if (_e3004 > _e3019) {
                                    phi_5235_ = _e3004;
                                } else {
                                    phi_5235_ = _e3019;
                                }
                                let _e3022 = phi_5235_;
                                let _e3027 = local.member_3;
                                let _e3040 = ((((_e2724[0] * _e2649) + (_e2724[1] * _e2652)) + (_e2724[2] * _e2655)) * 3f);
                                let _e3041 = ((((_e2781[0] * _e2670) + (_e2781[1] * _e2673)) + (_e2781[2] * _e2676)) * 3f);
                                if (_e3040 < _e3041) {
                                    phi_5259_ = _e3040;
                                } else {
                                    phi_5259_ = _e3041;
                                }
                                let _e3044 = phi_5259_;
                                if (_e2755 < _e2778) {
                                    phi_5264_ = _e2755;
                                } else {
                                    phi_5264_ = _e2778;
                                }
                                let _e3047 = phi_5264_;
                                if (_e3044 < _e3047) {
                                    phi_5269_ = _e3044;
                                } else {
                                    phi_5269_ = _e3047;
                                }
                                let _e3050 = phi_5269_;
                                if (_e3040 > _e3041) {
                                    phi_5274_ = _e3040;
                                } else {
                                    phi_5274_ = _e3041;
                                }
                                let _e3053 = phi_5274_;
                                if (_e2755 > _e2778) {
                                    phi_5279_ = _e2755;
                                } else {
                                    phi_5279_ = _e2778;
                                }
                                let _e3056 = phi_5279_;
                                if (_e3053 > _e3056) {
                                    phi_5284_ = _e3053;
                                } else {
                                    phi_5284_ = _e3056;
                                }
                                let _e3059 = phi_5284_;
                                let _e3064 = -(_e3059);
                                if (_e3050 > _e3064) {
                                    phi_5294_ = _e3050;
                                } else {
                                    phi_5294_ = _e3064;
                                }
                                let _e3067 = phi_5294_;
                                if ((_e3067 - ((((((_e2843 * 8f) * _e2953) * (0.000000059604645f * (524f / 64f))) + ((_e2960 * 19f) * ((_e2843 * (_e2897 + _e2951)) + (_e2897 * _e2951)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2843) * ((1f + _e2897) * (1f + _e2951))))) + ((_e1525 * (((_e3022 + (_e2953 * (0.000000059604645f * 8f))) + ((_e3027 * 6f) * (_e2897 + _e2951))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2897) * (1f + _e2951))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6262_ = true;
                                } else {
                                    let _e3072 = local.member_1[0u];
                                    let _e3078 = local.member_1[1u];
                                    let _e3082 = (_e3072[0] + _e3078[0]);
                                    let _e3083 = (_e3072[1] + _e3078[1]);
                                    let _e3084 = (_e3072[2] + _e3078[2]);
                                    let _e3087 = local.member_2[0u];
                                    let _e3093 = local.member_2[1u];
                                    let _e3097 = (_e3087[0] + _e3093[0]);
                                    let _e3098 = (_e3087[1] + _e3093[1]);
                                    let _e3099 = (_e3087[2] + _e3093[2]);
                                    let _e3102 = ((_e3083 * _e3099) - (_e3084 * _e3098));
                                    let _e3105 = ((_e3084 * _e3097) - (_e3082 * _e3099));
                                    let _e3108 = ((_e3082 * _e3098) - (_e3083 * _e3097));
                                    let _e3111 = local.member[0u];
                                    let _e3117 = local.member_1[0u];
                                    let _e3123 = local.member_2[0u];
                                    let _e3127 = (_e3111[0] - _e3117[0]);
                                    let _e3128 = (_e3111[1] - _e3117[1]);
                                    let _e3129 = (_e3111[2] - _e3117[2]);
                                    let _e3130 = (_e3127 - _e3123[0]);
                                    let _e3131 = (_e3128 - _e3123[1]);
                                    let _e3132 = (_e3129 - _e3123[2]);
                                    let _e3133 = (_e3111[0] - _e3123[0]);
                                    let _e3134 = (_e3111[1] - _e3123[1]);
                                    let _e3135 = (_e3111[2] - _e3123[2]);
                                    let _e3138 = local.member[1u];
                                    let _e3144 = local.member_1[1u];
                                    let _e3150 = local.member_2[1u];
                                    let _e3154 = (_e3138[0] - _e3144[0]);
                                    let _e3155 = (_e3138[1] - _e3144[1]);
                                    let _e3156 = (_e3138[2] - _e3144[2]);
                                    let _e3157 = (_e3154 - _e3150[0]);
                                    let _e3158 = (_e3155 - _e3150[1]);
                                    let _e3159 = (_e3156 - _e3150[2]);
                                    let _e3160 = (_e3138[0] - _e3150[0]);
                                    let _e3161 = (_e3138[1] - _e3150[1]);
                                    let _e3162 = (_e3138[2] - _e3150[2]);
                                    let _e3165 = local.member[0u];
                                    if (_e3165[0] < 0f) {
                                        phi_5497_ = -(_e3165[0]);
                                    } else {
                                        phi_5497_ = _e3165[0];
                                    }
                                    let _e3172 = phi_5497_;
                                    if (_e3165[1] < 0f) {
                                        phi_5504_ = -(_e3165[1]);
                                    } else {
                                        phi_5504_ = _e3165[1];
                                    }
                                    let _e3176 = phi_5504_;
                                    if (_e3172 > _e3176) {
                                        phi_5509_ = _e3172;
                                    } else {
                                        phi_5509_ = _e3176;
                                    }
                                    let _e3179 = phi_5509_;
                                    if (_e3165[2] < 0f) {
                                        phi_5516_ = -(_e3165[2]);
                                    } else {
                                        phi_5516_ = _e3165[2];
                                    }
                                    let _e3183 = phi_5516_;
                                    if (_e3179 > _e3183) {
                                        phi_5521_ = _e3179;
                                    } else {
                                        phi_5521_ = _e3183;
                                    }
                                    let _e3186 = phi_5521_;
                                    let _e3189 = local.member[1u];
                                    if (_e3189[0] < 0f) {
                                        phi_5534_ = -(_e3189[0]);
                                    } else {
                                        phi_5534_ = _e3189[0];
                                    }
                                    let _e3196 = phi_5534_;
                                    if (_e3189[1] < 0f) {
                                        phi_5541_ = -(_e3189[1]);
                                    } else {
                                        phi_5541_ = _e3189[1];
                                    }
                                    let _e3200 = phi_5541_;
                                    if (_e3196 > _e3200) {
                                        phi_5546_ = _e3196;
                                    } else {
                                        phi_5546_ = _e3200;
                                    }
                                    let _e3203 = phi_5546_;
                                    if (_e3189[2] < 0f) {
                                        phi_5553_ = -(_e3189[2]);
                                    } else {
                                        phi_5553_ = _e3189[2];
                                    }
                                    let _e3207 = phi_5553_;
                                    if (_e3203 > _e3207) {
                                        phi_5558_ = _e3203;
                                    } else {
                                        phi_5558_ = _e3207;
                                    }
                                    let _e3210 = phi_5558_;
                                    if (_e3186 > _e3210) {
                                        phi_5563_ = _e3186;
                                    } else {
                                        phi_5563_ = _e3210;
                                    }
                                    let _e3213 = phi_5563_;
                                    let _e3215 = local.member_3;
                                    let _e3219 = local.member_1[0u];
                                    if (_e3219[0] < 0f) {
                                        phi_5580_ = -(_e3219[0]);
                                    } else {
                                        phi_5580_ = _e3219[0];
                                    }
                                    let _e3226 = phi_5580_;
                                    if (_e3219[1] < 0f) {
                                        phi_5587_ = -(_e3219[1]);
                                    } else {
                                        phi_5587_ = _e3219[1];
                                    }
                                    let _e3230 = phi_5587_;
                                    if (_e3226 > _e3230) {
                                        phi_5592_ = _e3226;
                                    } else {
                                        phi_5592_ = _e3230;
                                    }
                                    let _e3233 = phi_5592_;
                                    if (_e3219[2] < 0f) {
                                        phi_5599_ = -(_e3219[2]);
                                    } else {
                                        phi_5599_ = _e3219[2];
                                    }
                                    let _e3237 = phi_5599_;
                                    if (_e3233 > _e3237) {
                                        phi_5604_ = _e3233;
                                    } else {
                                        phi_5604_ = _e3237;
                                    }
                                    let _e3240 = phi_5604_;
                                    let _e3243 = local.member_1[1u];
                                    if (_e3243[0] < 0f) {
                                        phi_5618_ = -(_e3243[0]);
                                    } else {
                                        phi_5618_ = _e3243[0];
                                    }
                                    let _e3250 = phi_5618_;
                                    if (_e3243[1] < 0f) {
                                        phi_5625_ = -(_e3243[1]);
                                    } else {
                                        phi_5625_ = _e3243[1];
                                    }
                                    let _e3254 = phi_5625_;
                                    if (_e3250 > _e3254) {
                                        phi_5630_ = _e3250;
                                    } else {
                                        phi_5630_ = _e3254;
                                    }
                                    let _e3257 = phi_5630_;
                                    if (_e3243[2] < 0f) {
                                        phi_5637_ = -(_e3243[2]);
                                    } else {
                                        phi_5637_ = _e3243[2];
                                    }
                                    let _e3261 = phi_5637_;
                                    if (_e3257 > _e3261) {
                                        phi_5642_ = _e3257;
                                    } else {
                                        phi_5642_ = _e3261;
                                    }
                                    let _e3264 = phi_5642_;
                                    if (_e3240 > _e3264) {
                                        phi_5647_ = _e3240;
                                    } else {
                                        phi_5647_ = _e3264;
                                    }
                                    let _e3267 = phi_5647_;
                                    let _e3269 = local.member_3;
                                    let _e3273 = local.member_2[0u];
                                    if (_e3273[0] < 0f) {
                                        phi_5664_ = -(_e3273[0]);
                                    } else {
                                        phi_5664_ = _e3273[0];
                                    }
                                    let _e3280 = phi_5664_;
                                    if (_e3273[1] < 0f) {
                                        phi_5671_ = -(_e3273[1]);
                                    } else {
                                        phi_5671_ = _e3273[1];
                                    }
                                    let _e3284 = phi_5671_;
                                    if (_e3280 > _e3284) {
                                        phi_5676_ = _e3280;
                                    } else {
                                        phi_5676_ = _e3284;
                                    }
                                    let _e3287 = phi_5676_;
                                    if (_e3273[2] < 0f) {
                                        phi_5683_ = -(_e3273[2]);
                                    } else {
                                        phi_5683_ = _e3273[2];
                                    }
                                    let _e3291 = phi_5683_;
                                    if (_e3287 > _e3291) {
                                        phi_5688_ = _e3287;
                                    } else {
                                        phi_5688_ = _e3291;
                                    }
                                    let _e3294 = phi_5688_;
                                    let _e3297 = local.member_2[1u];
                                    if (_e3297[0] < 0f) {
                                        phi_5702_ = -(_e3297[0]);
                                    } else {
                                        phi_5702_ = _e3297[0];
                                    }
                                    let _e3304 = phi_5702_;
                                    if (_e3297[1] < 0f) {
                                        phi_5709_ = -(_e3297[1]);
                                    } else {
                                        phi_5709_ = _e3297[1];
                                    }
                                    let _e3308 = phi_5709_;
                                    if (_e3304 > _e3308) {
                                        phi_5714_ = _e3304;
                                    } else {
                                        phi_5714_ = _e3308;
                                    }
                                    let _e3311 = phi_5714_;
                                    if (_e3297[2] < 0f) {
                                        phi_5721_ = -(_e3297[2]);
                                    } else {
                                        phi_5721_ = _e3297[2];
                                    }
                                    let _e3315 = phi_5721_;
                                    if (_e3311 > _e3315) {
                                        phi_5726_ = _e3311;
                                    } else {
                                        phi_5726_ = _e3315;
                                    }
                                    let _e3318 = phi_5726_;
                                    if (_e3294 > _e3318) {
                                        phi_5731_ = _e3294;
                                    } else {
                                        phi_5731_ = _e3318;
                                    }
                                    let _e3321 = phi_5731_;
                                    let _e3323 = local.member_3;
                                    let _e3327 = ((((_e3213 + _e3215) + (_e3267 + _e3269)) + (_e3321 + _e3323)) * 2f);
                                    let _e3330 = local.member_3;
                                    let _e3334 = (((_e1525 * 1.0001f) + (_e3330 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3337 = ((_e3105 * _e3084) - (_e3108 * _e3083));
                                    let _e3340 = ((_e3108 * _e3082) - (_e3102 * _e3084));
                                    let _e3343 = ((_e3102 * _e3083) - (_e3105 * _e3082));
                                    let _e3348 = (((_e3337 * _e3111[0]) + (_e3340 * _e3111[1])) + (_e3343 * _e3111[2]));
                                    let _e3353 = (((_e3337 * _e3127) + (_e3340 * _e3128)) + (_e3343 * _e3129));
                                    let _e3358 = (((_e3337 * _e3133) + (_e3340 * _e3134)) + (_e3343 * _e3135));
                                    let _e3363 = (((_e3337 * _e3130) + (_e3340 * _e3131)) + (_e3343 * _e3132));
                                    let _e3368 = (((_e3337 * _e3138[0]) + (_e3340 * _e3138[1])) + (_e3343 * _e3138[2]));
                                    let _e3373 = (((_e3337 * _e3154) + (_e3340 * _e3155)) + (_e3343 * _e3156));
                                    let _e3378 = (((_e3337 * _e3160) + (_e3340 * _e3161)) + (_e3343 * _e3162));
                                    let _e3383 = (((_e3337 * _e3157) + (_e3340 * _e3158)) + (_e3343 * _e3159));
                                    if (_e3348 < _e3353) {
                                        phi_5810_ = _e3348;
                                    } else {
                                        phi_5810_ = _e3353;
                                    }
                                    let _e3386 = phi_5810_;
                                    if (_e3358 < _e3363) {
                                        phi_5815_ = _e3358;
                                    } else {
                                        phi_5815_ = _e3363;
                                    }
                                    let _e3389 = phi_5815_;
                                    if (_e3386 < _e3389) {
                                        phi_5820_ = _e3386;
                                    } else {
                                        phi_5820_ = _e3389;
                                    }
                                    let _e3392 = phi_5820_;
                                    if (_e3368 < _e3373) {
                                        phi_5825_ = _e3368;
                                    } else {
                                        phi_5825_ = _e3373;
                                    }
                                    let _e3395 = phi_5825_;
                                    if (_e3378 < _e3383) {
                                        phi_5830_ = _e3378;
                                    } else {
                                        phi_5830_ = _e3383;
                                    }
                                    let _e3398 = phi_5830_;
                                    if (_e3395 < _e3398) {
                                        phi_5835_ = _e3395;
                                    } else {
                                        phi_5835_ = _e3398;
                                    }
                                    let _e3401 = phi_5835_;
                                    if (_e3392 < _e3401) {
                                        phi_5840_ = _e3392;
                                    } else {
                                        phi_5840_ = _e3401;
                                    }
                                    let _e3404 = phi_5840_;
                                    if (_e3348 > _e3353) {
                                        phi_5845_ = _e3348;
                                    } else {
                                        phi_5845_ = _e3353;
                                    }
                                    let _e3407 = phi_5845_;
                                    if (_e3358 > _e3363) {
                                        phi_5850_ = _e3358;
                                    } else {
                                        phi_5850_ = _e3363;
                                    }
                                    let _e3410 = phi_5850_;
                                    if (_e3407 > _e3410) {
                                        phi_5855_ = _e3407;
                                    } else {
                                        phi_5855_ = _e3410;
                                    }
                                    let _e3413 = phi_5855_;
                                    if (_e3368 > _e3373) {
                                        phi_5860_ = _e3368;
                                    } else {
                                        phi_5860_ = _e3373;
                                    }
                                    let _e3416 = phi_5860_;
                                    if (_e3378 > _e3383) {
                                        phi_5865_ = _e3378;
                                    } else {
                                        phi_5865_ = _e3383;
                                    }
                                    let _e3419 = phi_5865_;
                                    if (_e3416 > _e3419) {
                                        phi_5870_ = _e3416;
                                    } else {
                                        phi_5870_ = _e3419;
                                    }
                                    let _e3422 = phi_5870_;
                                    if (_e3413 > _e3422) {
                                        phi_5875_ = _e3413;
                                    } else {
                                        phi_5875_ = _e3422;
                                    }
                                    let _e3425 = phi_5875_;
                                    if (_e3337 < 0f) {
                                        phi_5881_ = -(_e3337);
                                    } else {
                                        phi_5881_ = _e3337;
                                    }
                                    let _e3429 = phi_5881_;
                                    if (_e3340 < 0f) {
                                        phi_5887_ = -(_e3340);
                                    } else {
                                        phi_5887_ = _e3340;
                                    }
                                    let _e3433 = phi_5887_;
                                    if (_e3343 < 0f) {
                                        phi_5894_ = -(_e3343);
                                    } else {
                                        phi_5894_ = _e3343;
                                    }
                                    let _e3438 = phi_5894_;
                                    let _e3439 = ((_e3429 + _e3433) + _e3438);
                                    let _e3444 = -(_e3425);
                                    if (_e3404 > _e3444) {
                                        phi_5905_ = _e3404;
                                    } else {
                                        phi_5905_ = _e3444;
                                    }
                                    let _e3447 = phi_5905_;
                                    let _e3452 = (((_e3447 - ((_e3439 * _e3327) * (0.000000059604645f * (17f / 2f)))) - (_e3439 * _e3334)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3455 = ((_e3105 * _e3099) - (_e3108 * _e3098));
                                    let _e3458 = ((_e3108 * _e3097) - (_e3102 * _e3099));
                                    let _e3461 = ((_e3102 * _e3098) - (_e3105 * _e3097));
                                    let _e3466 = (((_e3455 * _e3111[0]) + (_e3458 * _e3111[1])) + (_e3461 * _e3111[2]));
                                    let _e3471 = (((_e3455 * _e3127) + (_e3458 * _e3128)) + (_e3461 * _e3129));
                                    let _e3476 = (((_e3455 * _e3133) + (_e3458 * _e3134)) + (_e3461 * _e3135));
                                    let _e3481 = (((_e3455 * _e3130) + (_e3458 * _e3131)) + (_e3461 * _e3132));
                                    let _e3486 = (((_e3455 * _e3138[0]) + (_e3458 * _e3138[1])) + (_e3461 * _e3138[2]));
                                    let _e3491 = (((_e3455 * _e3154) + (_e3458 * _e3155)) + (_e3461 * _e3156));
                                    let _e3496 = (((_e3455 * _e3160) + (_e3458 * _e3161)) + (_e3461 * _e3162));
                                    let _e3501 = (((_e3455 * _e3157) + (_e3458 * _e3158)) + (_e3461 * _e3159));
                                    if (_e3466 < _e3471) {
                                        phi_5976_ = _e3466;
                                    } else {
                                        phi_5976_ = _e3471;
                                    }
                                    let _e3504 = phi_5976_;
                                    if (_e3476 < _e3481) {
                                        phi_5981_ = _e3476;
                                    } else {
                                        phi_5981_ = _e3481;
                                    }
                                    let _e3507 = phi_5981_;
                                    if (_e3504 < _e3507) {
                                        phi_5986_ = _e3504;
                                    } else {
                                        phi_5986_ = _e3507;
                                    }
                                    let _e3510 = phi_5986_;
                                    if (_e3486 < _e3491) {
                                        phi_5991_ = _e3486;
                                    } else {
                                        phi_5991_ = _e3491;
                                    }
                                    let _e3513 = phi_5991_;
                                    if (_e3496 < _e3501) {
                                        phi_5996_ = _e3496;
                                    } else {
                                        phi_5996_ = _e3501;
                                    }
                                    let _e3516 = phi_5996_;
                                    if (_e3513 < _e3516) {
                                        phi_6001_ = _e3513;
                                    } else {
                                        phi_6001_ = _e3516;
                                    }
                                    let _e3519 = phi_6001_;
                                    if (_e3510 < _e3519) {
                                        phi_6006_ = _e3510;
                                    } else {
                                        phi_6006_ = _e3519;
                                    }
                                    let _e3522 = phi_6006_;
                                    if (_e3466 > _e3471) {
                                        phi_6011_ = _e3466;
                                    } else {
                                        phi_6011_ = _e3471;
                                    }
                                    let _e3525 = phi_6011_;
                                    if (_e3476 > _e3481) {
                                        phi_6016_ = _e3476;
                                    } else {
                                        phi_6016_ = _e3481;
                                    }
                                    let _e3528 = phi_6016_;
                                    if (_e3525 > _e3528) {
                                        phi_6021_ = _e3525;
                                    } else {
                                        phi_6021_ = _e3528;
                                    }
                                    let _e3531 = phi_6021_;
                                    if (_e3486 > _e3491) {
                                        phi_6026_ = _e3486;
                                    } else {
                                        phi_6026_ = _e3491;
                                    }
                                    let _e3534 = phi_6026_;
                                    if (_e3496 > _e3501) {
                                        phi_6031_ = _e3496;
                                    } else {
                                        phi_6031_ = _e3501;
                                    }
                                    let _e3537 = phi_6031_;
                                    if (_e3534 > _e3537) {
                                        phi_6036_ = _e3534;
                                    } else {
                                        phi_6036_ = _e3537;
                                    }
                                    let _e3540 = phi_6036_;
                                    if (_e3531 > _e3540) {
                                        phi_6041_ = _e3531;
                                    } else {
                                        phi_6041_ = _e3540;
                                    }
                                    let _e3543 = phi_6041_;
                                    if (_e3455 < 0f) {
                                        phi_6047_ = -(_e3455);
                                    } else {
                                        phi_6047_ = _e3455;
                                    }
                                    let _e3547 = phi_6047_;
                                    if (_e3458 < 0f) {
                                        phi_6053_ = -(_e3458);
                                    } else {
                                        phi_6053_ = _e3458;
                                    }
                                    let _e3551 = phi_6053_;
                                    if (_e3461 < 0f) {
                                        phi_6060_ = -(_e3461);
                                    } else {
                                        phi_6060_ = _e3461;
                                    }
                                    let _e3556 = phi_6060_;
                                    let _e3557 = ((_e3547 + _e3551) + _e3556);
                                    let _e3562 = -(_e3543);
                                    if (_e3522 > _e3562) {
                                        phi_6071_ = _e3522;
                                    } else {
                                        phi_6071_ = _e3562;
                                    }
                                    let _e3565 = phi_6071_;
                                    let _e3570 = (((_e3565 - ((_e3557 * _e3327) * (0.000000059604645f * (17f / 2f)))) - (_e3557 * _e3334)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3452 > _e3570) {
                                        phi_6081_ = _e3452;
                                    } else {
                                        phi_6081_ = _e3570;
                                    }
                                    let _e3573 = phi_6081_;
                                    phi_6262_ = (_e3573 > 0f);
                                }
                                let _e3576 = phi_6262_;
                                if _e3576 {
                                    let _e3579 = local_1.member_1[0u];
                                    let _e3585 = local_1.member_2[0u];
                                    let _e3591 = ((_e3579[1] * _e3585[2]) - (_e3579[2] * _e3585[1]));
                                    let _e3594 = ((_e3579[2] * _e3585[0]) - (_e3579[0] * _e3585[2]));
                                    let _e3597 = ((_e3579[0] * _e3585[1]) - (_e3579[1] * _e3585[0]));
                                    let _e3600 = local_1.member_1[1u];
                                    let _e3606 = local_1.member_2[1u];
                                    let _e3612 = ((_e3600[1] * _e3606[2]) - (_e3600[2] * _e3606[1]));
                                    let _e3615 = ((_e3600[2] * _e3606[0]) - (_e3600[0] * _e3606[2]));
                                    let _e3618 = ((_e3600[0] * _e3606[1]) - (_e3600[1] * _e3606[0]));
                                    let _e3621 = local_1.member_1[0u];
                                    let _e3627 = local_1.member_2[1u];
                                    let _e3642 = local_1.member_1[1u];
                                    let _e3648 = local_1.member_2[0u];
                                    let _e3661 = (((_e3621[1] * _e3627[2]) - (_e3621[2] * _e3627[1])) + ((_e3642[1] * _e3648[2]) - (_e3642[2] * _e3648[1])));
                                    let _e3662 = (((_e3621[2] * _e3627[0]) - (_e3621[0] * _e3627[2])) + ((_e3642[2] * _e3648[0]) - (_e3642[0] * _e3648[2])));
                                    let _e3663 = (((_e3621[0] * _e3627[1]) - (_e3621[1] * _e3627[0])) + ((_e3642[0] * _e3648[1]) - (_e3642[1] * _e3648[0])));
                                    let _e3666 = local_1.member[0u];
                                    let _e3677 = local_1.member[1u];
                                    let _e3688 = local_1.member[0u];
                                    let _e3697 = ((((_e3677[0] * _e3591) + (_e3677[1] * _e3594)) + (_e3677[2] * _e3597)) + (((_e3688[0] * _e3661) + (_e3688[1] * _e3662)) + (_e3688[2] * _e3663)));
                                    let _e3700 = local_1.member[0u];
                                    let _e3711 = local_1.member[1u];
                                    let _e3720 = ((((_e3700[0] * _e3612) + (_e3700[1] * _e3615)) + (_e3700[2] * _e3618)) + (((_e3711[0] * _e3661) + (_e3711[1] * _e3662)) + (_e3711[2] * _e3663)));
                                    let _e3723 = local_1.member[1u];
                                    let _e3734 = local_1.member[0u];
                                    if (_e3734[0] < 0f) {
                                        phi_6507_ = -(_e3734[0]);
                                    } else {
                                        phi_6507_ = _e3734[0];
                                    }
                                    let _e3741 = phi_6507_;
                                    if (_e3734[1] < 0f) {
                                        phi_6514_ = -(_e3734[1]);
                                    } else {
                                        phi_6514_ = _e3734[1];
                                    }
                                    let _e3745 = phi_6514_;
                                    if (_e3741 > _e3745) {
                                        phi_6519_ = _e3741;
                                    } else {
                                        phi_6519_ = _e3745;
                                    }
                                    let _e3748 = phi_6519_;
                                    if (_e3734[2] < 0f) {
                                        phi_6526_ = -(_e3734[2]);
                                    } else {
                                        phi_6526_ = _e3734[2];
                                    }
                                    let _e3752 = phi_6526_;
                                    if (_e3748 > _e3752) {
                                        phi_6531_ = _e3748;
                                    } else {
                                        phi_6531_ = _e3752;
                                    }
                                    let _e3755 = phi_6531_;
                                    let _e3758 = local_1.member[1u];
                                    if (_e3758[0] < 0f) {
                                        phi_6544_ = -(_e3758[0]);
                                    } else {
                                        phi_6544_ = _e3758[0];
                                    }
                                    let _e3765 = phi_6544_;
                                    if (_e3758[1] < 0f) {
                                        phi_6551_ = -(_e3758[1]);
                                    } else {
                                        phi_6551_ = _e3758[1];
                                    }
                                    let _e3769 = phi_6551_;
                                    if (_e3765 > _e3769) {
                                        phi_6556_ = _e3765;
                                    } else {
                                        phi_6556_ = _e3769;
                                    }
                                    let _e3772 = phi_6556_;
                                    if (_e3758[2] < 0f) {
                                        phi_6563_ = -(_e3758[2]);
                                    } else {
                                        phi_6563_ = _e3758[2];
                                    }
                                    let _e3776 = phi_6563_;
                                    if (_e3772 > _e3776) {
                                        phi_6568_ = _e3772;
                                    } else {
                                        phi_6568_ = _e3776;
                                    }
                                    let _e3779 = phi_6568_;
                                    if (_e3755 > _e3779) {
                                        phi_6573_ = _e3755;
                                    } else {
                                        phi_6573_ = _e3779;
                                    }
                                    let _e3782 = phi_6573_;
                                    let _e3784 = local_1.member_3;
                                    let _e3785 = (_e3782 + _e3784);
                                    let _e3788 = local_1.member_1[0u];
                                    if (_e3788[0] < 0f) {
                                        phi_6590_ = -(_e3788[0]);
                                    } else {
                                        phi_6590_ = _e3788[0];
                                    }
                                    let _e3795 = phi_6590_;
                                    if (_e3788[1] < 0f) {
                                        phi_6597_ = -(_e3788[1]);
                                    } else {
                                        phi_6597_ = _e3788[1];
                                    }
                                    let _e3799 = phi_6597_;
                                    if (_e3795 > _e3799) {
                                        phi_6602_ = _e3795;
                                    } else {
                                        phi_6602_ = _e3799;
                                    }
                                    let _e3802 = phi_6602_;
                                    if (_e3788[2] < 0f) {
                                        phi_6609_ = -(_e3788[2]);
                                    } else {
                                        phi_6609_ = _e3788[2];
                                    }
                                    let _e3806 = phi_6609_;
                                    if (_e3802 > _e3806) {
                                        phi_6614_ = _e3802;
                                    } else {
                                        phi_6614_ = _e3806;
                                    }
                                    let _e3809 = phi_6614_;
                                    let _e3812 = local_1.member_1[1u];
                                    if (_e3812[0] < 0f) {
                                        phi_6628_ = -(_e3812[0]);
                                    } else {
                                        phi_6628_ = _e3812[0];
                                    }
                                    let _e3819 = phi_6628_;
                                    if (_e3812[1] < 0f) {
                                        phi_6635_ = -(_e3812[1]);
                                    } else {
                                        phi_6635_ = _e3812[1];
                                    }
                                    let _e3823 = phi_6635_;
                                    if (_e3819 > _e3823) {
                                        phi_6640_ = _e3819;
                                    } else {
                                        phi_6640_ = _e3823;
                                    }
                                    let _e3826 = phi_6640_;
                                    if (_e3812[2] < 0f) {
                                        phi_6647_ = -(_e3812[2]);
                                    } else {
                                        phi_6647_ = _e3812[2];
                                    }
                                    let _e3830 = phi_6647_;
                                    if (_e3826 > _e3830) {
                                        phi_6652_ = _e3826;
                                    } else {
                                        phi_6652_ = _e3830;
                                    }
                                    let _e3833 = phi_6652_;
                                    if (_e3809 > _e3833) {
                                        phi_6657_ = _e3809;
                                    } else {
                                        phi_6657_ = _e3833;
                                    }
                                    let _e3836 = phi_6657_;
                                    let _e3838 = local_1.member_3;
                                    let _e3839 = (_e3836 + _e3838);
                                    let _e3842 = local_1.member_2[0u];
                                    if (_e3842[0] < 0f) {
                                        phi_6674_ = -(_e3842[0]);
                                    } else {
                                        phi_6674_ = _e3842[0];
                                    }
                                    let _e3849 = phi_6674_;
                                    if (_e3842[1] < 0f) {
                                        phi_6681_ = -(_e3842[1]);
                                    } else {
                                        phi_6681_ = _e3842[1];
                                    }
                                    let _e3853 = phi_6681_;
                                    if (_e3849 > _e3853) {
                                        phi_6686_ = _e3849;
                                    } else {
                                        phi_6686_ = _e3853;
                                    }
                                    let _e3856 = phi_6686_;
                                    if (_e3842[2] < 0f) {
                                        phi_6693_ = -(_e3842[2]);
                                    } else {
                                        phi_6693_ = _e3842[2];
                                    }
                                    let _e3860 = phi_6693_;
                                    if (_e3856 > _e3860) {
                                        phi_6698_ = _e3856;
                                    } else {
                                        phi_6698_ = _e3860;
                                    }
                                    let _e3863 = phi_6698_;
                                    let _e3866 = local_1.member_2[1u];
                                    if (_e3866[0] < 0f) {
                                        phi_6712_ = -(_e3866[0]);
                                    } else {
                                        phi_6712_ = _e3866[0];
                                    }
                                    let _e3873 = phi_6712_;
                                    if (_e3866[1] < 0f) {
                                        phi_6719_ = -(_e3866[1]);
                                    } else {
                                        phi_6719_ = _e3866[1];
                                    }
                                    let _e3877 = phi_6719_;
                                    if (_e3873 > _e3877) {
                                        phi_6724_ = _e3873;
                                    } else {
                                        phi_6724_ = _e3877;
                                    }
                                    let _e3880 = phi_6724_;
                                    if (_e3866[2] < 0f) {
                                        phi_6731_ = -(_e3866[2]);
                                    } else {
                                        phi_6731_ = _e3866[2];
                                    }
                                    let _e3884 = phi_6731_;
                                    if (_e3880 > _e3884) {
                                        phi_6736_ = _e3880;
                                    } else {
                                        phi_6736_ = _e3884;
                                    }
                                    let _e3887 = phi_6736_;
                                    if (_e3863 > _e3887) {
                                        phi_6741_ = _e3863;
                                    } else {
                                        phi_6741_ = _e3887;
                                    }
                                    let _e3890 = phi_6741_;
                                    let _e3892 = local_1.member_3;
                                    let _e3893 = (_e3890 + _e3892);
                                    let _e3895 = ((_e3839 * 8f) * _e3893);
                                    let _e3902 = local_1.member_3;
                                    if (_e3591 < 0f) {
                                        phi_6772_ = -(_e3591);
                                    } else {
                                        phi_6772_ = _e3591;
                                    }
                                    let _e3919 = phi_6772_;
                                    if (_e3594 < 0f) {
                                        phi_6778_ = -(_e3594);
                                    } else {
                                        phi_6778_ = _e3594;
                                    }
                                    let _e3923 = phi_6778_;
                                    if (_e3597 < 0f) {
                                        phi_6785_ = -(_e3597);
                                    } else {
                                        phi_6785_ = _e3597;
                                    }
                                    let _e3928 = phi_6785_;
                                    let _e3929 = ((_e3919 + _e3923) + _e3928);
                                    if (_e3612 < 0f) {
                                        phi_6792_ = -(_e3612);
                                    } else {
                                        phi_6792_ = _e3612;
                                    }
                                    let _e3933 = phi_6792_;
                                    if (_e3615 < 0f) {
                                        phi_6798_ = -(_e3615);
                                    } else {
                                        phi_6798_ = _e3615;
                                    }
                                    let _e3937 = phi_6798_;
                                    if (_e3618 < 0f) {
                                        phi_6805_ = -(_e3618);
                                    } else {
                                        phi_6805_ = _e3618;
                                    }
                                    let _e3942 = phi_6805_;
                                    let _e3943 = ((_e3933 + _e3937) + _e3942);
                                    if (_e3929 > _e3943) {
                                        phi_6811_ = _e3929;
                                    } else {
                                        phi_6811_ = _e3943;
                                    }
                                    let _e3946 = phi_6811_;
                                    if (_e3661 < 0f) {
                                        phi_6817_ = -(_e3661);
                                    } else {
                                        phi_6817_ = _e3661;
                                    }
                                    let _e3950 = phi_6817_;
                                    if (_e3662 < 0f) {
                                        phi_6823_ = -(_e3662);
                                    } else {
                                        phi_6823_ = _e3662;
                                    }
                                    let _e3954 = phi_6823_;
                                    if (_e3663 < 0f) {
                                        phi_6830_ = -(_e3663);
                                    } else {
                                        phi_6830_ = _e3663;
                                    }
                                    let _e3959 = phi_6830_;
                                    let _e3961 = (((_e3950 + _e3954) + _e3959) * 0.5f);
                                    if (_e3946 > _e3961) {
                                        phi_6837_ = _e3946;
                                    } else {
                                        phi_6837_ = _e3961;
                                    }
                                    let _e3964 = phi_6837_;
                                    let _e3969 = local_1.member_3;
                                    let _e3982 = ((((_e3666[0] * _e3591) + (_e3666[1] * _e3594)) + (_e3666[2] * _e3597)) * 3f);
                                    let _e3983 = ((((_e3723[0] * _e3612) + (_e3723[1] * _e3615)) + (_e3723[2] * _e3618)) * 3f);
                                    if (_e3982 < _e3983) {
                                        phi_6861_ = _e3982;
                                    } else {
                                        phi_6861_ = _e3983;
                                    }
                                    let _e3986 = phi_6861_;
                                    if (_e3697 < _e3720) {
                                        phi_6866_ = _e3697;
                                    } else {
                                        phi_6866_ = _e3720;
                                    }
                                    let _e3989 = phi_6866_;
                                    if (_e3986 < _e3989) {
                                        phi_6871_ = _e3986;
                                    } else {
                                        phi_6871_ = _e3989;
                                    }
                                    let _e3992 = phi_6871_;
                                    if (_e3982 > _e3983) {
                                        phi_6876_ = _e3982;
                                    } else {
                                        phi_6876_ = _e3983;
                                    }
                                    let _e3995 = phi_6876_;
                                    if (_e3697 > _e3720) {
                                        phi_6881_ = _e3697;
                                    } else {
                                        phi_6881_ = _e3720;
                                    }
                                    let _e3998 = phi_6881_;
                                    if (_e3995 > _e3998) {
                                        phi_6886_ = _e3995;
                                    } else {
                                        phi_6886_ = _e3998;
                                    }
                                    let _e4001 = phi_6886_;
                                    let _e4006 = -(_e4001);
                                    if (_e3992 > _e4006) {
                                        phi_6896_ = _e3992;
                                    } else {
                                        phi_6896_ = _e4006;
                                    }
                                    let _e4009 = phi_6896_;
                                    if ((_e4009 - ((((((_e3785 * 8f) * _e3895) * (0.000000059604645f * (524f / 64f))) + ((_e3902 * 19f) * ((_e3785 * (_e3839 + _e3893)) + (_e3839 * _e3893)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3785) * ((1f + _e3839) * (1f + _e3893))))) + ((_e1525 * (((_e3964 + (_e3895 * (0.000000059604645f * 8f))) + ((_e3969 * 6f) * (_e3839 + _e3893))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3839) * (1f + _e3893))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_7864_ = true;
                                    } else {
                                        let _e4014 = local_1.member_1[0u];
                                        let _e4020 = local_1.member_1[1u];
                                        let _e4024 = (_e4014[0] + _e4020[0]);
                                        let _e4025 = (_e4014[1] + _e4020[1]);
                                        let _e4026 = (_e4014[2] + _e4020[2]);
                                        let _e4029 = local_1.member_2[0u];
                                        let _e4035 = local_1.member_2[1u];
                                        let _e4039 = (_e4029[0] + _e4035[0]);
                                        let _e4040 = (_e4029[1] + _e4035[1]);
                                        let _e4041 = (_e4029[2] + _e4035[2]);
                                        let _e4044 = ((_e4025 * _e4041) - (_e4026 * _e4040));
                                        let _e4047 = ((_e4026 * _e4039) - (_e4024 * _e4041));
                                        let _e4050 = ((_e4024 * _e4040) - (_e4025 * _e4039));
                                        let _e4053 = local_1.member[0u];
                                        let _e4059 = local_1.member_1[0u];
                                        let _e4065 = local_1.member_2[0u];
                                        let _e4069 = (_e4053[0] - _e4059[0]);
                                        let _e4070 = (_e4053[1] - _e4059[1]);
                                        let _e4071 = (_e4053[2] - _e4059[2]);
                                        let _e4072 = (_e4069 - _e4065[0]);
                                        let _e4073 = (_e4070 - _e4065[1]);
                                        let _e4074 = (_e4071 - _e4065[2]);
                                        let _e4075 = (_e4053[0] - _e4065[0]);
                                        let _e4076 = (_e4053[1] - _e4065[1]);
                                        let _e4077 = (_e4053[2] - _e4065[2]);
                                        let _e4080 = local_1.member[1u];
                                        let _e4086 = local_1.member_1[1u];
                                        let _e4092 = local_1.member_2[1u];
                                        let _e4096 = (_e4080[0] - _e4086[0]);
                                        let _e4097 = (_e4080[1] - _e4086[1]);
                                        let _e4098 = (_e4080[2] - _e4086[2]);
                                        let _e4099 = (_e4096 - _e4092[0]);
                                        let _e4100 = (_e4097 - _e4092[1]);
                                        let _e4101 = (_e4098 - _e4092[2]);
                                        let _e4102 = (_e4080[0] - _e4092[0]);
                                        let _e4103 = (_e4080[1] - _e4092[1]);
                                        let _e4104 = (_e4080[2] - _e4092[2]);
                                        let _e4107 = local_1.member[0u];
                                        if (_e4107[0] < 0f) {
                                            phi_7099_ = -(_e4107[0]);
                                        } else {
                                            phi_7099_ = _e4107[0];
                                        }
                                        let _e4114 = phi_7099_;
                                        if (_e4107[1] < 0f) {
                                            phi_7106_ = -(_e4107[1]);
                                        } else {
                                            phi_7106_ = _e4107[1];
                                        }
                                        let _e4118 = phi_7106_;
                                        if (_e4114 > _e4118) {
                                            phi_7111_ = _e4114;
                                        } else {
                                            phi_7111_ = _e4118;
                                        }
                                        let _e4121 = phi_7111_;
                                        if (_e4107[2] < 0f) {
                                            phi_7118_ = -(_e4107[2]);
                                        } else {
                                            phi_7118_ = _e4107[2];
                                        }
                                        let _e4125 = phi_7118_;
                                        if (_e4121 > _e4125) {
                                            phi_7123_ = _e4121;
                                        } else {
                                            phi_7123_ = _e4125;
                                        }
                                        let _e4128 = phi_7123_;
                                        let _e4131 = local_1.member[1u];
                                        if (_e4131[0] < 0f) {
                                            phi_7136_ = -(_e4131[0]);
                                        } else {
                                            phi_7136_ = _e4131[0];
                                        }
                                        let _e4138 = phi_7136_;
                                        if (_e4131[1] < 0f) {
                                            phi_7143_ = -(_e4131[1]);
                                        } else {
                                            phi_7143_ = _e4131[1];
                                        }
                                        let _e4142 = phi_7143_;
                                        if (_e4138 > _e4142) {
                                            phi_7148_ = _e4138;
                                        } else {
                                            phi_7148_ = _e4142;
                                        }
                                        let _e4145 = phi_7148_;
                                        if (_e4131[2] < 0f) {
                                            phi_7155_ = -(_e4131[2]);
                                        } else {
                                            phi_7155_ = _e4131[2];
                                        }
                                        let _e4149 = phi_7155_;
                                        if (_e4145 > _e4149) {
                                            phi_7160_ = _e4145;
                                        } else {
                                            phi_7160_ = _e4149;
                                        }
                                        let _e4152 = phi_7160_;
                                        if (_e4128 > _e4152) {
                                            phi_7165_ = _e4128;
                                        } else {
                                            phi_7165_ = _e4152;
                                        }
                                        let _e4155 = phi_7165_;
                                        let _e4157 = local_1.member_3;
                                        let _e4161 = local_1.member_1[0u];
                                        if (_e4161[0] < 0f) {
                                            phi_7182_ = -(_e4161[0]);
                                        } else {
                                            phi_7182_ = _e4161[0];
                                        }
                                        let _e4168 = phi_7182_;
                                        if (_e4161[1] < 0f) {
                                            phi_7189_ = -(_e4161[1]);
                                        } else {
                                            phi_7189_ = _e4161[1];
                                        }
                                        let _e4172 = phi_7189_;
                                        if (_e4168 > _e4172) {
                                            phi_7194_ = _e4168;
                                        } else {
                                            phi_7194_ = _e4172;
                                        }
                                        let _e4175 = phi_7194_;
                                        if (_e4161[2] < 0f) {
                                            phi_7201_ = -(_e4161[2]);
                                        } else {
                                            phi_7201_ = _e4161[2];
                                        }
                                        let _e4179 = phi_7201_;
                                        if (_e4175 > _e4179) {
                                            phi_7206_ = _e4175;
                                        } else {
                                            phi_7206_ = _e4179;
                                        }
                                        let _e4182 = phi_7206_;
                                        let _e4185 = local_1.member_1[1u];
                                        if (_e4185[0] < 0f) {
                                            phi_7220_ = -(_e4185[0]);
                                        } else {
                                            phi_7220_ = _e4185[0];
                                        }
                                        let _e4192 = phi_7220_;
                                        if (_e4185[1] < 0f) {
                                            phi_7227_ = -(_e4185[1]);
                                        } else {
                                            phi_7227_ = _e4185[1];
                                        }
                                        let _e4196 = phi_7227_;
                                        if (_e4192 > _e4196) {
                                            phi_7232_ = _e4192;
                                        } else {
                                            phi_7232_ = _e4196;
                                        }
                                        let _e4199 = phi_7232_;
                                        if (_e4185[2] < 0f) {
                                            phi_7239_ = -(_e4185[2]);
                                        } else {
                                            phi_7239_ = _e4185[2];
                                        }
                                        let _e4203 = phi_7239_;
                                        if (_e4199 > _e4203) {
                                            phi_7244_ = _e4199;
                                        } else {
                                            phi_7244_ = _e4203;
                                        }
                                        let _e4206 = phi_7244_;
                                        if (_e4182 > _e4206) {
                                            phi_7249_ = _e4182;
                                        } else {
                                            phi_7249_ = _e4206;
                                        }
                                        let _e4209 = phi_7249_;
                                        let _e4211 = local_1.member_3;
                                        let _e4215 = local_1.member_2[0u];
                                        if (_e4215[0] < 0f) {
                                            phi_7266_ = -(_e4215[0]);
                                        } else {
                                            phi_7266_ = _e4215[0];
                                        }
                                        let _e4222 = phi_7266_;
                                        if (_e4215[1] < 0f) {
                                            phi_7273_ = -(_e4215[1]);
                                        } else {
                                            phi_7273_ = _e4215[1];
                                        }
                                        let _e4226 = phi_7273_;
                                        if (_e4222 > _e4226) {
                                            phi_7278_ = _e4222;
                                        } else {
                                            phi_7278_ = _e4226;
                                        }
                                        let _e4229 = phi_7278_;
                                        if (_e4215[2] < 0f) {
                                            phi_7285_ = -(_e4215[2]);
                                        } else {
                                            phi_7285_ = _e4215[2];
                                        }
                                        let _e4233 = phi_7285_;
                                        if (_e4229 > _e4233) {
                                            phi_7290_ = _e4229;
                                        } else {
                                            phi_7290_ = _e4233;
                                        }
                                        let _e4236 = phi_7290_;
                                        let _e4239 = local_1.member_2[1u];
                                        if (_e4239[0] < 0f) {
                                            phi_7304_ = -(_e4239[0]);
                                        } else {
                                            phi_7304_ = _e4239[0];
                                        }
                                        let _e4246 = phi_7304_;
                                        if (_e4239[1] < 0f) {
                                            phi_7311_ = -(_e4239[1]);
                                        } else {
                                            phi_7311_ = _e4239[1];
                                        }
                                        let _e4250 = phi_7311_;
                                        if (_e4246 > _e4250) {
                                            phi_7316_ = _e4246;
                                        } else {
                                            phi_7316_ = _e4250;
                                        }
                                        let _e4253 = phi_7316_;
                                        if (_e4239[2] < 0f) {
                                            phi_7323_ = -(_e4239[2]);
                                        } else {
                                            phi_7323_ = _e4239[2];
                                        }
                                        let _e4257 = phi_7323_;
                                        if (_e4253 > _e4257) {
                                            phi_7328_ = _e4253;
                                        } else {
                                            phi_7328_ = _e4257;
                                        }
                                        let _e4260 = phi_7328_;
                                        if (_e4236 > _e4260) {
                                            phi_7333_ = _e4236;
                                        } else {
                                            phi_7333_ = _e4260;
                                        }
                                        let _e4263 = phi_7333_;
                                        let _e4265 = local_1.member_3;
                                        let _e4269 = ((((_e4155 + _e4157) + (_e4209 + _e4211)) + (_e4263 + _e4265)) * 2f);
                                        let _e4272 = local_1.member_3;
                                        let _e4276 = (((_e1525 * 1.0001f) + (_e4272 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4279 = ((_e4047 * _e4026) - (_e4050 * _e4025));
                                        let _e4282 = ((_e4050 * _e4024) - (_e4044 * _e4026));
                                        let _e4285 = ((_e4044 * _e4025) - (_e4047 * _e4024));
                                        let _e4290 = (((_e4279 * _e4053[0]) + (_e4282 * _e4053[1])) + (_e4285 * _e4053[2]));
                                        let _e4295 = (((_e4279 * _e4069) + (_e4282 * _e4070)) + (_e4285 * _e4071));
                                        let _e4300 = (((_e4279 * _e4075) + (_e4282 * _e4076)) + (_e4285 * _e4077));
                                        let _e4305 = (((_e4279 * _e4072) + (_e4282 * _e4073)) + (_e4285 * _e4074));
                                        let _e4310 = (((_e4279 * _e4080[0]) + (_e4282 * _e4080[1])) + (_e4285 * _e4080[2]));
                                        let _e4315 = (((_e4279 * _e4096) + (_e4282 * _e4097)) + (_e4285 * _e4098));
                                        let _e4320 = (((_e4279 * _e4102) + (_e4282 * _e4103)) + (_e4285 * _e4104));
                                        let _e4325 = (((_e4279 * _e4099) + (_e4282 * _e4100)) + (_e4285 * _e4101));
                                        if (_e4290 < _e4295) {
                                            phi_7412_ = _e4290;
                                        } else {
                                            phi_7412_ = _e4295;
                                        }
                                        let _e4328 = phi_7412_;
                                        if (_e4300 < _e4305) {
                                            phi_7417_ = _e4300;
                                        } else {
                                            phi_7417_ = _e4305;
                                        }
                                        let _e4331 = phi_7417_;
                                        if (_e4328 < _e4331) {
                                            phi_7422_ = _e4328;
                                        } else {
                                            phi_7422_ = _e4331;
                                        }
                                        let _e4334 = phi_7422_;
                                        if (_e4310 < _e4315) {
                                            phi_7427_ = _e4310;
                                        } else {
                                            phi_7427_ = _e4315;
                                        }
                                        let _e4337 = phi_7427_;
                                        if (_e4320 < _e4325) {
                                            phi_7432_ = _e4320;
                                        } else {
                                            phi_7432_ = _e4325;
                                        }
                                        let _e4340 = phi_7432_;
                                        if (_e4337 < _e4340) {
                                            phi_7437_ = _e4337;
                                        } else {
                                            phi_7437_ = _e4340;
                                        }
                                        let _e4343 = phi_7437_;
                                        if (_e4334 < _e4343) {
                                            phi_7442_ = _e4334;
                                        } else {
                                            phi_7442_ = _e4343;
                                        }
                                        let _e4346 = phi_7442_;
                                        if (_e4290 > _e4295) {
                                            phi_7447_ = _e4290;
                                        } else {
                                            phi_7447_ = _e4295;
                                        }
                                        let _e4349 = phi_7447_;
                                        if (_e4300 > _e4305) {
                                            phi_7452_ = _e4300;
                                        } else {
                                            phi_7452_ = _e4305;
                                        }
                                        let _e4352 = phi_7452_;
                                        if (_e4349 > _e4352) {
                                            phi_7457_ = _e4349;
                                        } else {
                                            phi_7457_ = _e4352;
                                        }
                                        let _e4355 = phi_7457_;
                                        if (_e4310 > _e4315) {
                                            phi_7462_ = _e4310;
                                        } else {
                                            phi_7462_ = _e4315;
                                        }
                                        let _e4358 = phi_7462_;
                                        if (_e4320 > _e4325) {
                                            phi_7467_ = _e4320;
                                        } else {
                                            phi_7467_ = _e4325;
                                        }
                                        let _e4361 = phi_7467_;
                                        if (_e4358 > _e4361) {
                                            phi_7472_ = _e4358;
                                        } else {
                                            phi_7472_ = _e4361;
                                        }
                                        let _e4364 = phi_7472_;
                                        if (_e4355 > _e4364) {
                                            phi_7477_ = _e4355;
                                        } else {
                                            phi_7477_ = _e4364;
                                        }
                                        let _e4367 = phi_7477_;
                                        if (_e4279 < 0f) {
                                            phi_7483_ = -(_e4279);
                                        } else {
                                            phi_7483_ = _e4279;
                                        }
                                        let _e4371 = phi_7483_;
                                        if (_e4282 < 0f) {
                                            phi_7489_ = -(_e4282);
                                        } else {
                                            phi_7489_ = _e4282;
                                        }
                                        let _e4375 = phi_7489_;
                                        if (_e4285 < 0f) {
                                            phi_7496_ = -(_e4285);
                                        } else {
                                            phi_7496_ = _e4285;
                                        }
                                        let _e4380 = phi_7496_;
                                        let _e4381 = ((_e4371 + _e4375) + _e4380);
                                        let _e4386 = -(_e4367);
                                        if (_e4346 > _e4386) {
                                            phi_7507_ = _e4346;
                                        } else {
                                            phi_7507_ = _e4386;
                                        }
                                        let _e4389 = phi_7507_;
                                        let _e4394 = (((_e4389 - ((_e4381 * _e4269) * (0.000000059604645f * (17f / 2f)))) - (_e4381 * _e4276)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4397 = ((_e4047 * _e4041) - (_e4050 * _e4040));
                                        let _e4400 = ((_e4050 * _e4039) - (_e4044 * _e4041));
                                        let _e4403 = ((_e4044 * _e4040) - (_e4047 * _e4039));
                                        let _e4408 = (((_e4397 * _e4053[0]) + (_e4400 * _e4053[1])) + (_e4403 * _e4053[2]));
                                        let _e4413 = (((_e4397 * _e4069) + (_e4400 * _e4070)) + (_e4403 * _e4071));
                                        let _e4418 = (((_e4397 * _e4075) + (_e4400 * _e4076)) + (_e4403 * _e4077));
                                        let _e4423 = (((_e4397 * _e4072) + (_e4400 * _e4073)) + (_e4403 * _e4074));
                                        let _e4428 = (((_e4397 * _e4080[0]) + (_e4400 * _e4080[1])) + (_e4403 * _e4080[2]));
                                        let _e4433 = (((_e4397 * _e4096) + (_e4400 * _e4097)) + (_e4403 * _e4098));
                                        let _e4438 = (((_e4397 * _e4102) + (_e4400 * _e4103)) + (_e4403 * _e4104));
                                        let _e4443 = (((_e4397 * _e4099) + (_e4400 * _e4100)) + (_e4403 * _e4101));
                                        if (_e4408 < _e4413) {
                                            phi_7578_ = _e4408;
                                        } else {
                                            phi_7578_ = _e4413;
                                        }
                                        let _e4446 = phi_7578_;
                                        if (_e4418 < _e4423) {
                                            phi_7583_ = _e4418;
                                        } else {
                                            phi_7583_ = _e4423;
                                        }
                                        let _e4449 = phi_7583_;
                                        if (_e4446 < _e4449) {
                                            phi_7588_ = _e4446;
                                        } else {
                                            phi_7588_ = _e4449;
                                        }
                                        let _e4452 = phi_7588_;
                                        if (_e4428 < _e4433) {
                                            phi_7593_ = _e4428;
                                        } else {
                                            phi_7593_ = _e4433;
                                        }
                                        let _e4455 = phi_7593_;
                                        if (_e4438 < _e4443) {
                                            phi_7598_ = _e4438;
                                        } else {
                                            phi_7598_ = _e4443;
                                        }
                                        let _e4458 = phi_7598_;
                                        if (_e4455 < _e4458) {
                                            phi_7603_ = _e4455;
                                        } else {
                                            phi_7603_ = _e4458;
                                        }
                                        let _e4461 = phi_7603_;
                                        if (_e4452 < _e4461) {
                                            phi_7608_ = _e4452;
                                        } else {
                                            phi_7608_ = _e4461;
                                        }
                                        let _e4464 = phi_7608_;
                                        if (_e4408 > _e4413) {
                                            phi_7613_ = _e4408;
                                        } else {
                                            phi_7613_ = _e4413;
                                        }
                                        let _e4467 = phi_7613_;
                                        if (_e4418 > _e4423) {
                                            phi_7618_ = _e4418;
                                        } else {
                                            phi_7618_ = _e4423;
                                        }
                                        let _e4470 = phi_7618_;
                                        if (_e4467 > _e4470) {
                                            phi_7623_ = _e4467;
                                        } else {
                                            phi_7623_ = _e4470;
                                        }
                                        let _e4473 = phi_7623_;
                                        if (_e4428 > _e4433) {
                                            phi_7628_ = _e4428;
                                        } else {
                                            phi_7628_ = _e4433;
                                        }
                                        let _e4476 = phi_7628_;
                                        if (_e4438 > _e4443) {
                                            phi_7633_ = _e4438;
                                        } else {
                                            phi_7633_ = _e4443;
                                        }
                                        let _e4479 = phi_7633_;
                                        if (_e4476 > _e4479) {
                                            phi_7638_ = _e4476;
                                        } else {
                                            phi_7638_ = _e4479;
                                        }
                                        let _e4482 = phi_7638_;
                                        if (_e4473 > _e4482) {
                                            phi_7643_ = _e4473;
                                        } else {
                                            phi_7643_ = _e4482;
                                        }
                                        let _e4485 = phi_7643_;
                                        if (_e4397 < 0f) {
                                            phi_7649_ = -(_e4397);
                                        } else {
                                            phi_7649_ = _e4397;
                                        }
                                        let _e4489 = phi_7649_;
                                        if (_e4400 < 0f) {
                                            phi_7655_ = -(_e4400);
                                        } else {
                                            phi_7655_ = _e4400;
                                        }
                                        let _e4493 = phi_7655_;
                                        if (_e4403 < 0f) {
                                            phi_7662_ = -(_e4403);
                                        } else {
                                            phi_7662_ = _e4403;
                                        }
                                        let _e4498 = phi_7662_;
                                        let _e4499 = ((_e4489 + _e4493) + _e4498);
                                        let _e4504 = -(_e4485);
                                        if (_e4464 > _e4504) {
                                            phi_7673_ = _e4464;
                                        } else {
                                            phi_7673_ = _e4504;
                                        }
                                        let _e4507 = phi_7673_;
                                        let _e4512 = (((_e4507 - ((_e4499 * _e4269) * (0.000000059604645f * (17f / 2f)))) - (_e4499 * _e4276)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4394 > _e4512) {
                                            phi_7683_ = _e4394;
                                        } else {
                                            phi_7683_ = _e4512;
                                        }
                                        let _e4515 = phi_7683_;
                                        phi_7864_ = (_e4515 > 0f);
                                    }
                                    let _e4518 = phi_7864_;
                                    phi_7865_ = _e4518;
                                } else {
                                    phi_7865_ = false;
                                }
                                let _e4520 = phi_7865_;
                                phi_7867_ = !(_e4520);
                            }
                            let _e4523 = phi_7867_;
                            if _e4523 {
                                let _e4525 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1026] = ((2147483648u | (_e4525 << bitcast<u32>(12i))) | _e1029);
                            }
                        }
                        phi_7877_ = true;
                    }
                    let _e4532 = phi_7877_;
                    phi_7878_ = _e4532;
                } else {
                    phi_7878_ = false;
                }
                let _e4534 = phi_7878_;
                continue;
                continuing {
                    phi_1842_ = _e1018;
                    break if !(_e4534);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4538 = atomicLoad((&counters[5u]));
                if (_e4538 > 0u) {
                    let _e4541 = atomicAdd((&output.member[0u]), _e4538);
                    if ((_e4541 + _e4538) < _e4541) {
                        let _e4545 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4541);
                }
            }
            workgroupBarrier();
            let _e4548 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4551 = atomicLoad((&counters[7u]));
                if (_e4551 > 0u) {
                    let _e4554 = atomicAdd((&output.member[1u]), _e4551);
                    if ((_e4554 + _e4551) < _e4554) {
                        let _e4558 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7928_ = type_21(0u, 16u);
            loop {
                let _e4560 = phi_7928_;
                if (_e4560.member < _e4560.member_1) {
                    phi_7929_ = type_21((_e4560.member + 1u), _e4560.member_1);
                    phi_7952_ = type_21(1u, _e4560.member);
                } else {
                    phi_7929_ = _e4560;
                    phi_7952_ = type_21(0u, type_21().member_1);
                }
                let _e4572 = phi_7929_;
                let _e4574 = phi_7952_;
                if (bitcast<i32>(_e4574.member) != 0i) {
                    let _e4580 = (_e67 + (_e4574.member_1 * 128u));
                    if (_e4580 >= _e1004) {
                        phi_8050_ = false;
                    } else {
                        let _e4583 = hits[_e4580];
                        if ((_e4583 & 2147483648u) == 0u) {
                            phi_7975_ = 4294967295u;
                        } else {
                            phi_7975_ = ((_e4583 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4590 = phi_7975_;
                        if (_e4590 != 4294967295u) {
                            let _e4594 = ((_e4583 >> bitcast<u32>(10i)) & 3u);
                            let _e4601 = firsts[(2u * _e4594)];
                            let _e4604 = leaves.member[(_e4601 + ((_e4583 >> bitcast<u32>(5i)) & 31u))];
                            let _e4608 = firsts[((2u * _e4594) + 1u)];
                            let _e4611 = leaves.member[(_e4608 + (_e4583 & 31u))];
                            let _e4615 = params.member.member_16;
                            let _e4616 = (_e4548 + _e4590);
                            if (_e4604.member_1 < _e4611.member_1) {
                                phi_8029_ = type_21(_e4604.member_1, _e4611.member_1);
                            } else {
                                phi_8029_ = type_21(_e4611.member_1, _e4604.member_1);
                            }
                            let _e4621 = phi_8029_;
                            if (_e4616 < _e4615) {
                                atomicStore((&output.member[(4u + (2u * _e4616))]), _e4621.member);
                                atomicStore((&output.member[((2u * _e4616) + 5u)]), _e4621.member_1);
                            }
                        }
                        phi_8050_ = true;
                    }
                    let _e4632 = phi_8050_;
                    phi_8051_ = _e4632;
                } else {
                    phi_8051_ = false;
                }
                let _e4634 = phi_8051_;
                continue;
                continuing {
                    phi_7928_ = _e4572;
                    break if !(_e4634);
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
