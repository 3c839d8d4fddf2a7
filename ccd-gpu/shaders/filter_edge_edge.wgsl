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
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: array<u32, 2>,
    member_15: array<u32, 2>,
    member_16: array<u32, 2>,
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

struct type_15 {
    member: i32,
    member_1: i32,
}

struct type_16 {
    member: u32,
    member_1: i32,
}

struct type_18 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_22 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_25 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_31 {
    member: array<type_29>,
}

struct type_33 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_39 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_41 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_45 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(2) 
var<storage> leaves: type_27;
@group(0) @binding(1) 
var<storage> nodes: type_31;
var<workgroup> columns: array<type_33, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> hits: array<u32, 2048>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_39;
@group(0) @binding(5) 
var<storage> paths: type_24;
@group(0) @binding(6) 
var<storage> input: type_11;
@group(0) @binding(7) 
var<storage, read_write> output: type_45;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_185_: bool;
    var phi_186_: bool;
    var phi_190_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_186_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_185_ = (param[0] > param_1[0]);
        } else {
            phi_185_ = false;
        }
        let _e14 = phi_185_;
        phi_186_ = _e14;
    }
    let _e16 = phi_186_;
    if _e16 {
        phi_190_ = param_1;
    } else {
        phi_190_ = param;
    }
    let _e18 = phi_190_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_209_: bool;
    var phi_210_: bool;
    var phi_214_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_210_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_209_ = (param_3[0] > param_2[0]);
        } else {
            phi_209_ = false;
        }
        let _e14 = phi_209_;
        phi_210_ = _e14;
    }
    let _e16 = phi_210_;
    if _e16 {
        phi_214_ = param_3;
    } else {
        phi_214_ = param_2;
    }
    let _e18 = phi_214_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_233_: bool;
    var phi_234_: bool;
    var phi_238_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_234_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_233_ = (param_4[0] > param_5[0]);
        } else {
            phi_233_ = false;
        }
        let _e14 = phi_233_;
        phi_234_ = _e14;
    }
    let _e16 = phi_234_;
    if _e16 {
        phi_238_ = param_5;
    } else {
        phi_238_ = param_4;
    }
    let _e18 = phi_238_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_257_: bool;
    var phi_258_: bool;
    var phi_262_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_258_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_257_ = (param_7[0] > param_6[0]);
        } else {
            phi_257_ = false;
        }
        let _e14 = phi_257_;
        phi_258_ = _e14;
    }
    let _e16 = phi_258_;
    if _e16 {
        phi_262_ = param_7;
    } else {
        phi_262_ = param_6;
    }
    let _e18 = phi_262_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_286_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_282_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_281_ = (param_8[0] > param_9[0]);
        } else {
            phi_281_ = false;
        }
        let _e14 = phi_281_;
        phi_282_ = _e14;
    }
    let _e16 = phi_282_;
    if _e16 {
        phi_286_ = param_9;
    } else {
        phi_286_ = param_8;
    }
    let _e18 = phi_286_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_305_: bool;
    var phi_306_: bool;
    var phi_310_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_306_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_305_ = (param_11[0] > param_10[0]);
        } else {
            phi_305_ = false;
        }
        let _e14 = phi_305_;
        phi_306_ = _e14;
    }
    let _e16 = phi_306_;
    if _e16 {
        phi_310_ = param_11;
    } else {
        phi_310_ = param_10;
    }
    let _e18 = phi_310_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_41;
    var local_1: type_41;
    var local_2: type_41;
    var phi_363_: u32;
    var phi_416_: u32;
    var phi_417_: u32;
    var phi_425_: u32;
    var phi_441_: u32;
    var phi_464_: u32;
    var phi_465_: u32;
    var phi_468_: type_9;
    var phi_469_: type_9;
    var phi_492_: type_9;
    var phi_539_: u32;
    var phi_540_: u32;
    var phi_548_: u32;
    var phi_562_: u32;
    var phi_652_: array<u32, 2>;
    var phi_850_: bool;
    var phi_851_: bool;
    var phi_855_: type_33;
    var phi_870_: type_9;
    var phi_873_: u32;
    var phi_871_: type_9;
    var phi_896_: type_9;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_968_: bool;
    var phi_986_: u32;
    var phi_987_: u32;
    var phi_988_: u32;
    var phi_874_: u32;
    var phi_991_: type_9;
    var phi_994_: u32;
    var phi_992_: type_9;
    var phi_1017_: type_9;
    var phi_1137_: bool;
    var phi_1143_: bool;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1194_: bool;
    var phi_1195_: bool;
    var phi_1202_: bool;
    var phi_1318_: bool;
    var phi_1319_: bool;
    var phi_1356_: u32;
    var phi_1357_: u32;
    var phi_1362_: type_15;
    var phi_1365_: u32;
    var phi_1367_: u32;
    var phi_1388_: bool;
    var phi_1394_: type_16;
    var phi_1363_: type_15;
    var phi_1408_: type_16;
    var phi_1476_: bool;
    var phi_1477_: bool;
    var phi_1478_: bool;
    var phi_1479_: bool;
    var phi_1483_: bool;
    var phi_1484_: bool;
    var phi_1489_: u32;
    var phi_1490_: u32;
    var phi_1491_: u32;
    var phi_1492_: u32;
    var phi_1493_: bool;
    var phi_1366_: u32;
    var phi_1368_: u32;
    var phi_1494_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1542_: bool;
    var phi_1543_: bool;
    var phi_1544_: bool;
    var phi_1545_: bool;
    var phi_1549_: bool;
    var phi_1550_: bool;
    var phi_1554_: bool;
    var phi_1558_: bool;
    var phi_1559_: bool;
    var phi_1563_: bool;
    var phi_1564_: bool;
    var phi_1568_: bool;
    var phi_1569_: bool;
    var phi_1693_: bool;
    var phi_1694_: bool;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var phi_1882_: bool;
    var phi_1883_: bool;
    var phi_1976_: bool;
    var phi_1977_: bool;
    var phi_2072_: bool;
    var phi_2073_: bool;
    var phi_2166_: bool;
    var phi_2167_: bool;
    var phi_2171_: bool;
    var phi_2172_: bool;
    var phi_2173_: bool;
    var phi_2177_: bool;
    var phi_2178_: bool;
    var phi_2179_: bool;
    var phi_2180_: bool;
    var phi_2181_: bool;
    var phi_2185_: bool;
    var phi_2201_: type_9;
    var phi_2244_: u32;
    var phi_2245_: bool;
    var phi_995_: u32;
    var phi_2246_: bool;
    var phi_2253_: u32;
    var phi_2256_: type_9;
    var phi_2257_: type_9;
    var phi_2280_: type_9;
    var phi_2408_: bool;
    var phi_2414_: bool;
    var phi_2420_: bool;
    var phi_2421_: bool;
    var phi_2465_: bool;
    var phi_2466_: bool;
    var phi_2473_: bool;
    var phi_2589_: bool;
    var phi_2590_: bool;
    var phi_2627_: u32;
    var phi_2628_: u32;
    var phi_2633_: type_15;
    var phi_2636_: u32;
    var phi_2638_: u32;
    var phi_2659_: bool;
    var phi_2665_: type_16;
    var phi_2634_: type_15;
    var phi_2679_: type_16;
    var phi_2747_: bool;
    var phi_2748_: bool;
    var phi_2749_: bool;
    var phi_2750_: bool;
    var phi_2754_: bool;
    var phi_2755_: bool;
    var phi_2760_: u32;
    var phi_2761_: u32;
    var phi_2762_: u32;
    var phi_2763_: u32;
    var phi_2764_: bool;
    var phi_2637_: u32;
    var phi_2639_: u32;
    var phi_2765_: bool;
    var local_5: u32;
    var local_6: u32;
    var phi_2813_: bool;
    var phi_2814_: bool;
    var phi_2815_: bool;
    var phi_2816_: bool;
    var phi_2820_: bool;
    var phi_2821_: bool;
    var phi_2825_: bool;
    var phi_2829_: bool;
    var phi_2830_: bool;
    var phi_2834_: bool;
    var phi_2835_: bool;
    var phi_2839_: bool;
    var phi_2840_: bool;
    var phi_2964_: bool;
    var phi_2965_: bool;
    var phi_3058_: bool;
    var phi_3059_: bool;
    var phi_3153_: bool;
    var phi_3154_: bool;
    var phi_3247_: bool;
    var phi_3248_: bool;
    var phi_3343_: bool;
    var phi_3344_: bool;
    var phi_3437_: bool;
    var phi_3438_: bool;
    var phi_3442_: bool;
    var phi_3443_: bool;
    var phi_3444_: bool;
    var phi_3448_: bool;
    var phi_3449_: bool;
    var phi_3450_: bool;
    var phi_3451_: bool;
    var phi_3452_: bool;
    var phi_3456_: bool;
    var phi_3473_: array<u32, 3>;
    var phi_3474_: array<u32, 3>;
    var phi_3897_: f32;
    var phi_3904_: f32;
    var phi_3909_: f32;
    var phi_3916_: f32;
    var phi_3921_: f32;
    var phi_3934_: f32;
    var phi_3941_: f32;
    var phi_3946_: f32;
    var phi_3953_: f32;
    var phi_3958_: f32;
    var phi_3963_: f32;
    var phi_3980_: f32;
    var phi_3987_: f32;
    var phi_3992_: f32;
    var phi_3999_: f32;
    var phi_4004_: f32;
    var phi_4018_: f32;
    var phi_4025_: f32;
    var phi_4030_: f32;
    var phi_4037_: f32;
    var phi_4042_: f32;
    var phi_4047_: f32;
    var phi_4064_: f32;
    var phi_4071_: f32;
    var phi_4076_: f32;
    var phi_4083_: f32;
    var phi_4088_: f32;
    var phi_4102_: f32;
    var phi_4109_: f32;
    var phi_4114_: f32;
    var phi_4121_: f32;
    var phi_4126_: f32;
    var phi_4131_: f32;
    var phi_4162_: f32;
    var phi_4168_: f32;
    var phi_4175_: f32;
    var phi_4182_: f32;
    var phi_4188_: f32;
    var phi_4195_: f32;
    var phi_4201_: f32;
    var phi_4207_: f32;
    var phi_4213_: f32;
    var phi_4220_: f32;
    var phi_4227_: f32;
    var phi_4251_: f32;
    var phi_4256_: f32;
    var phi_4261_: f32;
    var phi_4266_: f32;
    var phi_4271_: f32;
    var phi_4276_: f32;
    var phi_4286_: f32;
    var phi_4489_: f32;
    var phi_4496_: f32;
    var phi_4501_: f32;
    var phi_4508_: f32;
    var phi_4513_: f32;
    var phi_4526_: f32;
    var phi_4533_: f32;
    var phi_4538_: f32;
    var phi_4545_: f32;
    var phi_4550_: f32;
    var phi_4555_: f32;
    var phi_4572_: f32;
    var phi_4579_: f32;
    var phi_4584_: f32;
    var phi_4591_: f32;
    var phi_4596_: f32;
    var phi_4610_: f32;
    var phi_4617_: f32;
    var phi_4622_: f32;
    var phi_4629_: f32;
    var phi_4634_: f32;
    var phi_4639_: f32;
    var phi_4656_: f32;
    var phi_4663_: f32;
    var phi_4668_: f32;
    var phi_4675_: f32;
    var phi_4680_: f32;
    var phi_4694_: f32;
    var phi_4701_: f32;
    var phi_4706_: f32;
    var phi_4713_: f32;
    var phi_4718_: f32;
    var phi_4723_: f32;
    var phi_4802_: f32;
    var phi_4807_: f32;
    var phi_4812_: f32;
    var phi_4817_: f32;
    var phi_4822_: f32;
    var phi_4827_: f32;
    var phi_4832_: f32;
    var phi_4837_: f32;
    var phi_4842_: f32;
    var phi_4847_: f32;
    var phi_4852_: f32;
    var phi_4857_: f32;
    var phi_4862_: f32;
    var phi_4867_: f32;
    var phi_4873_: f32;
    var phi_4879_: f32;
    var phi_4886_: f32;
    var phi_4897_: f32;
    var phi_4968_: f32;
    var phi_4973_: f32;
    var phi_4978_: f32;
    var phi_4983_: f32;
    var phi_4988_: f32;
    var phi_4993_: f32;
    var phi_4998_: f32;
    var phi_5003_: f32;
    var phi_5008_: f32;
    var phi_5013_: f32;
    var phi_5018_: f32;
    var phi_5023_: f32;
    var phi_5028_: f32;
    var phi_5033_: f32;
    var phi_5039_: f32;
    var phi_5045_: f32;
    var phi_5052_: f32;
    var phi_5063_: f32;
    var phi_5073_: f32;
    var phi_5255_: bool;
    var phi_5707_: f32;
    var phi_5714_: f32;
    var phi_5719_: f32;
    var phi_5726_: f32;
    var phi_5731_: f32;
    var phi_5744_: f32;
    var phi_5751_: f32;
    var phi_5756_: f32;
    var phi_5763_: f32;
    var phi_5768_: f32;
    var phi_5773_: f32;
    var phi_5790_: f32;
    var phi_5797_: f32;
    var phi_5802_: f32;
    var phi_5809_: f32;
    var phi_5814_: f32;
    var phi_5828_: f32;
    var phi_5835_: f32;
    var phi_5840_: f32;
    var phi_5847_: f32;
    var phi_5852_: f32;
    var phi_5857_: f32;
    var phi_5874_: f32;
    var phi_5881_: f32;
    var phi_5886_: f32;
    var phi_5893_: f32;
    var phi_5898_: f32;
    var phi_5912_: f32;
    var phi_5919_: f32;
    var phi_5924_: f32;
    var phi_5931_: f32;
    var phi_5936_: f32;
    var phi_5941_: f32;
    var phi_5972_: f32;
    var phi_5978_: f32;
    var phi_5985_: f32;
    var phi_5992_: f32;
    var phi_5998_: f32;
    var phi_6005_: f32;
    var phi_6011_: f32;
    var phi_6017_: f32;
    var phi_6023_: f32;
    var phi_6030_: f32;
    var phi_6037_: f32;
    var phi_6061_: f32;
    var phi_6066_: f32;
    var phi_6071_: f32;
    var phi_6076_: f32;
    var phi_6081_: f32;
    var phi_6086_: f32;
    var phi_6096_: f32;
    var phi_6299_: f32;
    var phi_6306_: f32;
    var phi_6311_: f32;
    var phi_6318_: f32;
    var phi_6323_: f32;
    var phi_6336_: f32;
    var phi_6343_: f32;
    var phi_6348_: f32;
    var phi_6355_: f32;
    var phi_6360_: f32;
    var phi_6365_: f32;
    var phi_6382_: f32;
    var phi_6389_: f32;
    var phi_6394_: f32;
    var phi_6401_: f32;
    var phi_6406_: f32;
    var phi_6420_: f32;
    var phi_6427_: f32;
    var phi_6432_: f32;
    var phi_6439_: f32;
    var phi_6444_: f32;
    var phi_6449_: f32;
    var phi_6466_: f32;
    var phi_6473_: f32;
    var phi_6478_: f32;
    var phi_6485_: f32;
    var phi_6490_: f32;
    var phi_6504_: f32;
    var phi_6511_: f32;
    var phi_6516_: f32;
    var phi_6523_: f32;
    var phi_6528_: f32;
    var phi_6533_: f32;
    var phi_6612_: f32;
    var phi_6617_: f32;
    var phi_6622_: f32;
    var phi_6627_: f32;
    var phi_6632_: f32;
    var phi_6637_: f32;
    var phi_6642_: f32;
    var phi_6647_: f32;
    var phi_6652_: f32;
    var phi_6657_: f32;
    var phi_6662_: f32;
    var phi_6667_: f32;
    var phi_6672_: f32;
    var phi_6677_: f32;
    var phi_6683_: f32;
    var phi_6689_: f32;
    var phi_6696_: f32;
    var phi_6707_: f32;
    var phi_6778_: f32;
    var phi_6783_: f32;
    var phi_6788_: f32;
    var phi_6793_: f32;
    var phi_6798_: f32;
    var phi_6803_: f32;
    var phi_6808_: f32;
    var phi_6813_: f32;
    var phi_6818_: f32;
    var phi_6823_: f32;
    var phi_6828_: f32;
    var phi_6833_: f32;
    var phi_6838_: f32;
    var phi_6843_: f32;
    var phi_6849_: f32;
    var phi_6855_: f32;
    var phi_6862_: f32;
    var phi_6873_: f32;
    var phi_6883_: f32;
    var phi_7065_: bool;
    var phi_7310_: f32;
    var phi_7317_: f32;
    var phi_7322_: f32;
    var phi_7329_: f32;
    var phi_7334_: f32;
    var phi_7347_: f32;
    var phi_7354_: f32;
    var phi_7359_: f32;
    var phi_7366_: f32;
    var phi_7371_: f32;
    var phi_7376_: f32;
    var phi_7393_: f32;
    var phi_7400_: f32;
    var phi_7405_: f32;
    var phi_7412_: f32;
    var phi_7417_: f32;
    var phi_7431_: f32;
    var phi_7438_: f32;
    var phi_7443_: f32;
    var phi_7450_: f32;
    var phi_7455_: f32;
    var phi_7460_: f32;
    var phi_7477_: f32;
    var phi_7484_: f32;
    var phi_7489_: f32;
    var phi_7496_: f32;
    var phi_7501_: f32;
    var phi_7515_: f32;
    var phi_7522_: f32;
    var phi_7527_: f32;
    var phi_7534_: f32;
    var phi_7539_: f32;
    var phi_7544_: f32;
    var phi_7575_: f32;
    var phi_7581_: f32;
    var phi_7588_: f32;
    var phi_7595_: f32;
    var phi_7601_: f32;
    var phi_7608_: f32;
    var phi_7614_: f32;
    var phi_7620_: f32;
    var phi_7626_: f32;
    var phi_7633_: f32;
    var phi_7640_: f32;
    var phi_7664_: f32;
    var phi_7669_: f32;
    var phi_7674_: f32;
    var phi_7679_: f32;
    var phi_7684_: f32;
    var phi_7689_: f32;
    var phi_7699_: f32;
    var phi_7902_: f32;
    var phi_7909_: f32;
    var phi_7914_: f32;
    var phi_7921_: f32;
    var phi_7926_: f32;
    var phi_7939_: f32;
    var phi_7946_: f32;
    var phi_7951_: f32;
    var phi_7958_: f32;
    var phi_7963_: f32;
    var phi_7968_: f32;
    var phi_7985_: f32;
    var phi_7992_: f32;
    var phi_7997_: f32;
    var phi_8004_: f32;
    var phi_8009_: f32;
    var phi_8023_: f32;
    var phi_8030_: f32;
    var phi_8035_: f32;
    var phi_8042_: f32;
    var phi_8047_: f32;
    var phi_8052_: f32;
    var phi_8069_: f32;
    var phi_8076_: f32;
    var phi_8081_: f32;
    var phi_8088_: f32;
    var phi_8093_: f32;
    var phi_8107_: f32;
    var phi_8114_: f32;
    var phi_8119_: f32;
    var phi_8126_: f32;
    var phi_8131_: f32;
    var phi_8136_: f32;
    var phi_8215_: f32;
    var phi_8220_: f32;
    var phi_8225_: f32;
    var phi_8230_: f32;
    var phi_8235_: f32;
    var phi_8240_: f32;
    var phi_8245_: f32;
    var phi_8250_: f32;
    var phi_8255_: f32;
    var phi_8260_: f32;
    var phi_8265_: f32;
    var phi_8270_: f32;
    var phi_8275_: f32;
    var phi_8280_: f32;
    var phi_8286_: f32;
    var phi_8292_: f32;
    var phi_8299_: f32;
    var phi_8310_: f32;
    var phi_8381_: f32;
    var phi_8386_: f32;
    var phi_8391_: f32;
    var phi_8396_: f32;
    var phi_8401_: f32;
    var phi_8406_: f32;
    var phi_8411_: f32;
    var phi_8416_: f32;
    var phi_8421_: f32;
    var phi_8426_: f32;
    var phi_8431_: f32;
    var phi_8436_: f32;
    var phi_8441_: f32;
    var phi_8446_: f32;
    var phi_8452_: f32;
    var phi_8458_: f32;
    var phi_8465_: f32;
    var phi_8476_: f32;
    var phi_8486_: f32;
    var phi_8668_: bool;
    var phi_8670_: bool;
    var phi_8672_: bool;
    var phi_8683_: bool;
    var phi_8684_: bool;
    var phi_8735_: type_9;
    var phi_8736_: type_9;
    var phi_8759_: type_9;
    var phi_8782_: u32;
    var phi_8833_: type_9;
    var phi_8853_: bool;
    var phi_8854_: bool;
    var local_7: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e69 = id_2;
    let _e70 = n_2;
    let _e71 = lane_2;
    let _e84 = ((_e69.y * _e70.x) + _e69.x);
    let _e87 = (_e70.x * _e70.y);
    let _e90 = params.member.member_1.member_3;
    let _e93 = params.member.member_1.member_2;
    let _e95 = input.member[0u];
    if (_e93 < _e95) {
        phi_363_ = _e93;
    } else {
        phi_363_ = _e95;
    }
    let _e98 = phi_363_;
    let _e99 = (_e71 / 32u);
    let _e100 = (_e71 % 32u);
    let _e103 = params.member.member_1.member_1;
    if (_e98 > _e103) {
        let _e107 = params.member.member_1.member_1;
        let _e108 = (_e98 - _e107);
        let _e111 = params.member.member_2.member_3;
        if (_e111 == 0u) {
            return;
        }
        let _e113 = (_e108 / _e111);
        if (_e111 == 0u) {
            return;
        }
        if ((_e108 % _e111) > 0u) {
            phi_416_ = (_e113 + 1u);
        } else {
            phi_416_ = _e113;
        }
        let _e119 = phi_416_;
        phi_417_ = _e119;
    } else {
        phi_417_ = 0u;
    }
    let _e121 = phi_417_;
    let _e124 = params.member.member_2.member_4;
    if (_e124 < _e121) {
        phi_425_ = _e124;
    } else {
        phi_425_ = _e121;
    }
    let _e127 = phi_425_;
    let _e128 = (_e127 / 4u);
    if ((_e127 % 4u) > 0u) {
        phi_441_ = (_e128 + 1u);
    } else {
        phi_441_ = _e128;
    }
    let _e133 = phi_441_;
    if (_e133 > _e84) {
        let _e135 = (_e133 - _e84);
        if (_e87 == 0u) {
            return;
        }
        let _e137 = (_e135 / _e87);
        if (_e87 == 0u) {
            return;
        }
        if ((_e135 % _e87) > 0u) {
            phi_464_ = (_e137 + 1u);
        } else {
            phi_464_ = _e137;
        }
        let _e143 = phi_464_;
        phi_465_ = _e143;
    } else {
        phi_465_ = 0u;
    }
    let _e145 = phi_465_;
    phi_468_ = type_9(0u, _e145);
    loop {
        let _e148 = phi_468_;
        if (_e148.member < _e148.member_1) {
            phi_469_ = type_9((_e148.member + 1u), _e148.member_1);
            phi_492_ = type_9(1u, _e148.member);
        } else {
            phi_469_ = _e148;
            phi_492_ = type_9(0u, type_9().member_1);
        }
        let _e160 = phi_469_;
        let _e162 = phi_492_;
        let _e166 = (bitcast<i32>(_e162.member) != 0i);
        if _e166 {
            let _e171 = (((_e84 + (_e162.member_1 * _e87)) * 4u) + (_e71 / 32u));
            let _e174 = params.member.member_1.member_1;
            if (_e98 > _e174) {
                let _e178 = params.member.member_1.member_1;
                let _e179 = (_e98 - _e178);
                let _e182 = params.member.member_2.member_3;
                if (_e182 == 0u) {
                    return;
                }
                let _e184 = (_e179 / _e182);
                if (_e182 == 0u) {
                    return;
                }
                if ((_e179 % _e182) > 0u) {
                    phi_539_ = (_e184 + 1u);
                } else {
                    phi_539_ = _e184;
                }
                let _e190 = phi_539_;
                phi_540_ = _e190;
            } else {
                phi_540_ = 0u;
            }
            let _e192 = phi_540_;
            let _e195 = params.member.member_2.member_4;
            if (_e195 < _e192) {
                phi_548_ = _e195;
            } else {
                phi_548_ = _e192;
            }
            let _e198 = phi_548_;
            let _e199 = (_e171 < _e198);
            let _e202 = params.member.member_1.member_1;
            let _e205 = params.member.member_2.member_3;
            if _e199 {
                phi_562_ = (_e171 * _e205);
            } else {
                phi_562_ = 0u;
            }
            let _e208 = phi_562_;
            let _e210 = (2u * (_e202 + _e208));
            let _e213 = input.member[(4u + _e210)];
            let _e216 = input.member[(_e210 + 5u)];
            if (_e71 < 8u) {
                atomicStore((&counters[_e71]), 0u);
            }
            workgroupBarrier();
            let _e224 = params.member.member_2.member[0u][1u];
            let _e225 = (_e224 + (_e213 * 32u));
            let _e231 = params.member.member_2.member[0u][1u];
            let _e232 = (_e231 + (_e216 * 32u));
            if (_e100 == 0u) {
                firsts[(2u * _e99)] = _e225;
                firsts[((2u * _e99) + 1u)] = _e232;
            }
            let _e241 = params.member.member_2.member_1;
            if (_e241 == 0u) {
                phi_652_ = array<u32, 2>(0u, 2u);
            } else {
                phi_652_ = array<u32, 2>(1u, 1u);
            }
            let _e244 = phi_652_;
            let _e247 = (_e71 / 32u);
            let _e248 = (_e71 % 32u);
            let _e250 = params.member.member_2.member_2;
            let _e254 = params.member.member_2.member[_e250][_e244[0]];
            let _e257 = nodes.member[(_e254 + _e213)];
            let _e271 = params.member.member_2.member_2;
            let _e275 = params.member.member_2.member[_e271][_e244[1]];
            let _e278 = nodes.member[(_e275 + _e216)];
            let _e292 = params.member.member_2.member_2;
            let _e299 = params.member.member_2.member[(_e292 - 1u)][_e244[0]];
            let _e302 = nodes.member[(_e299 + ((_e213 * 32u) + _e248))];
            let _e319 = params.member.member_2.member_2;
            let _e326 = params.member.member_2.member[(_e319 - 1u)][_e244[1]];
            let _e329 = nodes.member[(_e326 + ((_e216 * 32u) + _e248))];
            if _e199 {
                if ((((((_e329.member.x <= _e257.member_1.y) && (_e257.member.x <= _e329.member_1.y)) && (_e329.member.y <= _e257.member_2.x)) && (_e257.member.y <= _e329.member_2.x)) && (_e329.member_1.x <= _e257.member_2.y)) && (_e257.member_1.x <= _e329.member_2.y)) {
                    let _e355 = atomicAdd((&counters[_e247]), 1u);
                    let _e356 = ((_e247 * 32u) + _e355);
                    columns[_e356] = type_33(array<f32, 3>(_e329.member.x, _e329.member.y, _e329.member_1.x), array<f32, 3>(_e329.member_1.y, _e329.member_2.x, _e329.member_2.y));
                    names[_e356] = _e248;
                }
            }
            workgroupBarrier();
            if _e199 {
                if ((((((_e302.member.x <= _e278.member_1.y) && (_e278.member.x <= _e302.member_1.y)) && (_e302.member.y <= _e278.member_2.x)) && (_e278.member.y <= _e302.member_2.x)) && (_e302.member_1.x <= _e278.member_2.y)) && (_e278.member_1.x <= _e302.member_2.y)) {
                    phi_850_ = false;
                } else {
                    phi_850_ = true;
                }
                let _e374 = phi_850_;
                phi_851_ = _e374;
            } else {
                phi_851_ = true;
            }
            let _e376 = phi_851_;
            if _e376 {
                phi_855_ = type_33(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_855_ = type_33(array<f32, 3>(_e302.member.x, _e302.member.y, _e302.member_1.x), array<f32, 3>(_e302.member_1.y, _e302.member_2.x, _e302.member_2.y));
            }
            let _e378 = phi_855_;
            let _e380 = (_e71 / 32u);
            let _e381 = (_e71 % 32u);
            let _e383 = atomicLoad((&counters[_e380]));
            phi_870_ = type_9(0u, _e383);
            phi_873_ = 0u;
            loop {
                let _e386 = phi_870_;
                let _e388 = phi_873_;
                local_7 = _e388;
                if (_e386.member < _e386.member_1) {
                    phi_871_ = type_9((_e386.member + 1u), _e386.member_1);
                    phi_896_ = type_9(1u, _e386.member);
                } else {
                    phi_871_ = _e386;
                    phi_896_ = type_9(0u, type_9().member_1);
                }
                let _e400 = phi_871_;
                let _e402 = phi_896_;
                let _e406 = (bitcast<i32>(_e402.member) != 0i);
                if _e406 {
                    let _e410 = names[((_e380 * 32u) + _e402.member_1)];
                    let _e414 = columns[((_e380 * 32u) + _e402.member_1)];
                    if ((((((_e378.member[0] <= _e414.member_1[0]) && (_e414.member[0] <= _e378.member_1[0])) && (_e378.member[1] <= _e414.member_1[1])) && (_e414.member[1] <= _e378.member_1[1])) && (_e378.member[2] <= _e414.member_1[2])) && (_e414.member[2] <= _e378.member_1[2])) {
                        if (_e213 == _e216) {
                            let _e446 = (_e381 < _e410);
                            if _e446 {
                                phi_962_ = bool();
                            } else {
                                phi_962_ = false;
                            }
                            let _e448 = phi_962_;
                            phi_963_ = _e448;
                            phi_964_ = _e446;
                        } else {
                            phi_963_ = bool();
                            phi_964_ = true;
                        }
                        let _e450 = phi_963_;
                        let _e452 = phi_964_;
                        if _e452 {
                            phi_968_ = true;
                        } else {
                            phi_968_ = _e450;
                        }
                        let _e454 = phi_968_;
                        if _e454 {
                            let _e456 = atomicAdd((&counters[4u]), 1u);
                            if (_e456 < 2048u) {
                                hits[_e456] = (((_e380 << bitcast<u32>(10i)) | (_e381 << bitcast<u32>(5i))) | _e410);
                                phi_986_ = _e388;
                            } else {
                                phi_986_ = (_e388 | (1u << bitcast<u32>((_e402.member_1 & 31u))));
                            }
                            let _e470 = phi_986_;
                            phi_987_ = _e470;
                        } else {
                            phi_987_ = _e388;
                        }
                        let _e472 = phi_987_;
                        phi_988_ = _e472;
                    } else {
                        phi_988_ = _e388;
                    }
                    let _e474 = phi_988_;
                    phi_874_ = _e474;
                } else {
                    phi_874_ = u32();
                }
                let _e476 = phi_874_;
                continue;
                continuing {
                    phi_870_ = _e400;
                    phi_873_ = _e476;
                    break if !(_e406);
                }
            }
            phi_991_ = type_9(0u, 32u);
            let _e4985 = local_7;
            phi_994_ = _e4985;
            loop {
                let _e479 = phi_991_;
                let _e481 = phi_994_;
                if (_e479.member < _e479.member_1) {
                    phi_992_ = type_9((_e479.member + 1u), _e479.member_1);
                    phi_1017_ = type_9(1u, _e479.member);
                } else {
                    phi_992_ = _e479;
                    phi_1017_ = type_9(0u, type_9().member_1);
                }
                let _e493 = phi_992_;
                let _e495 = phi_1017_;
                if (bitcast<i32>(_e495.member) != 0i) {
                    if (_e481 == 0u) {
                        phi_2244_ = u32();
                        phi_2245_ = false;
                    } else {
                        let _e506 = names[((_e99 * 32u) + select(firstTrailingBit(_e481), 32u, (_e481 == 0u)))];
                        let _e509 = (_e225 + _e100);
                        let _e510 = (_e232 + _e506);
                        let _e512 = leaves.member[_e509];
                        let _e514 = leaves.member[_e510];
                        let _e516 = nodes.member[_e509];
                        let _e530 = nodes.member[_e510];
                        let _e545 = params.member.member.member_1;
                        if ((_e545 & 1u) != 0u) {
                            if (_e514.member[0] == _e512.member[0]) {
                                phi_1137_ = true;
                            } else {
                                phi_1137_ = (_e514.member[0] == _e512.member[1]);
                            }
                            let _e559 = phi_1137_;
                            if (_e514.member[1] == _e512.member[0]) {
                                phi_1143_ = true;
                            } else {
                                phi_1143_ = (_e514.member[1] == _e512.member[1]);
                            }
                            let _e563 = phi_1143_;
                            if (_e559 || _e563) {
                                phi_1149_ = false;
                            } else {
                                phi_1149_ = true;
                            }
                            let _e566 = phi_1149_;
                            phi_1150_ = _e566;
                        } else {
                            phi_1150_ = true;
                        }
                        let _e568 = phi_1150_;
                        if _e568 {
                            let _e570 = params.member.member.member_1;
                            if ((_e570 & 2u) != 0u) {
                                let _e576 = bodies.member[_e512.member[0]];
                                let _e580 = bodies.member[_e514.member[0]];
                                if ((_e576 / 4u) != (_e580 / 4u)) {
                                    phi_1195_ = true;
                                } else {
                                    if ((_e576 & 2u) == 0u) {
                                        phi_1194_ = false;
                                    } else {
                                        phi_1194_ = true;
                                    }
                                    let _e587 = phi_1194_;
                                    phi_1195_ = _e587;
                                }
                                let _e589 = phi_1195_;
                                if _e589 {
                                    phi_1202_ = (((_e576 & _e580) & 1u) == 0u);
                                } else {
                                    phi_1202_ = false;
                                }
                                let _e594 = phi_1202_;
                                if _e594 {
                                    let _e596 = params.member.member.member_1;
                                    if ((_e596 & 4u) != 0u) {
                                        let _e601 = params.member.member.member[0u];
                                        let _e603 = bodies.member[_e601];
                                        let _e606 = bodies.member[(_e601 + 1u)];
                                        let _e611 = ((_e601 + 4u) + (2u * (_e576 >> bitcast<u32>(2i))));
                                        let _e616 = ((_e601 + 4u) + (2u * (_e580 >> bitcast<u32>(2i))));
                                        let _e618 = bodies.member[_e611];
                                        let _e620 = bodies.member[_e616];
                                        let _e629 = bodies.member[((((_e601 + 4u) + (2u * _e603)) + (_e618 * _e606)) + (_e620 / 32u))];
                                        let _e632 = bodies.member[(_e611 + 1u)];
                                        let _e635 = bodies.member[(_e616 + 1u)];
                                        if (_e632 == _e635) {
                                            if (((_e629 >> bitcast<u32>(((_e620 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_1318_ = true;
                                            } else {
                                                phi_1318_ = ((_e576 >> bitcast<u32>(2i)) == (_e580 >> bitcast<u32>(2i)));
                                            }
                                            let _e649 = phi_1318_;
                                            phi_1319_ = _e649;
                                        } else {
                                            phi_1319_ = false;
                                        }
                                        let _e651 = phi_1319_;
                                        if _e651 {
                                            let _e656 = bodies.member[(_e601 + 2u)];
                                            let _e659 = bodies.member[(_e601 + 3u)];
                                            let _e660 = (_e659 + _e601);
                                            if (_e514.member_1 < _e512.member_1) {
                                                phi_1356_ = _e512.member_1;
                                                phi_1357_ = _e514.member_1;
                                            } else {
                                                phi_1356_ = _e514.member_1;
                                                phi_1357_ = _e512.member_1;
                                            }
                                            let _e663 = phi_1356_;
                                            let _e665 = phi_1357_;
                                            phi_1362_ = type_15(0i, 32i);
                                            phi_1365_ = _e656;
                                            phi_1367_ = 0u;
                                            loop {
                                                let _e667 = phi_1362_;
                                                let _e669 = phi_1365_;
                                                let _e671 = phi_1367_;
                                                local_3 = _e671;
                                                local_4 = _e671;
                                                if (_e667.member < _e667.member_1) {
                                                    let _e678 = (_e667.member + 1i);
                                                    if ((false == (_e678 > _e667.member)) != false) {
                                                        phi_1388_ = true;
                                                    } else {
                                                        phi_1388_ = false;
                                                    }
                                                    let _e683 = phi_1388_;
                                                    if _e683 {
                                                        phi_1394_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_1394_ = type_16(1u, _e678);
                                                    }
                                                    let _e688 = phi_1394_;
                                                    phi_1363_ = type_15(_e688.member_1, _e667.member_1);
                                                    phi_1408_ = type_16(1u, _e667.member);
                                                } else {
                                                    phi_1363_ = _e667;
                                                    phi_1408_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e694 = phi_1363_;
                                                let _e696 = phi_1408_;
                                                if (bitcast<i32>(_e696.member) != 0i) {
                                                    if (_e671 >= _e669) {
                                                        phi_1491_ = u32();
                                                        phi_1492_ = u32();
                                                        phi_1493_ = false;
                                                    } else {
                                                        let _e703 = (_e671 + ((_e669 - _e671) / 2u));
                                                        let _e705 = (_e660 + (3u * _e703));
                                                        let _e707 = bodies.member[_e705];
                                                        let _e710 = bodies.member[(_e705 + 1u)];
                                                        let _e713 = bodies.member[(_e705 + 2u)];
                                                        if (_e707 < 1u) {
                                                            phi_1484_ = true;
                                                        } else {
                                                            if (_e707 == 1u) {
                                                                if (_e710 < _e665) {
                                                                    phi_1478_ = false;
                                                                } else {
                                                                    if (_e710 == _e665) {
                                                                        if (_e713 < _e663) {
                                                                            phi_1476_ = false;
                                                                        } else {
                                                                            phi_1476_ = true;
                                                                        }
                                                                        let _e720 = phi_1476_;
                                                                        phi_1477_ = _e720;
                                                                    } else {
                                                                        phi_1477_ = true;
                                                                    }
                                                                    let _e722 = phi_1477_;
                                                                    phi_1478_ = _e722;
                                                                }
                                                                let _e724 = phi_1478_;
                                                                phi_1479_ = _e724;
                                                            } else {
                                                                phi_1479_ = true;
                                                            }
                                                            let _e726 = phi_1479_;
                                                            if _e726 {
                                                                phi_1483_ = false;
                                                            } else {
                                                                phi_1483_ = true;
                                                            }
                                                            let _e728 = phi_1483_;
                                                            phi_1484_ = _e728;
                                                        }
                                                        let _e730 = phi_1484_;
                                                        if _e730 {
                                                            phi_1489_ = _e669;
                                                            phi_1490_ = (_e703 + 1u);
                                                        } else {
                                                            phi_1489_ = _e703;
                                                            phi_1490_ = _e671;
                                                        }
                                                        let _e733 = phi_1489_;
                                                        let _e735 = phi_1490_;
                                                        phi_1491_ = _e733;
                                                        phi_1492_ = _e735;
                                                        phi_1493_ = true;
                                                    }
                                                    let _e737 = phi_1491_;
                                                    let _e739 = phi_1492_;
                                                    let _e741 = phi_1493_;
                                                    phi_1366_ = _e737;
                                                    phi_1368_ = _e739;
                                                    phi_1494_ = _e741;
                                                } else {
                                                    phi_1366_ = u32();
                                                    phi_1368_ = u32();
                                                    phi_1494_ = false;
                                                }
                                                let _e743 = phi_1366_;
                                                let _e745 = phi_1368_;
                                                let _e747 = phi_1494_;
                                                continue;
                                                continuing {
                                                    phi_1362_ = _e694;
                                                    phi_1365_ = _e743;
                                                    phi_1367_ = _e745;
                                                    break if !(_e747);
                                                }
                                            }
                                            let _e750 = local_3;
                                            if (_e750 < _e656) {
                                                let _e753 = local_4;
                                                let _e755 = (_e660 + (3u * _e753));
                                                let _e757 = bodies.member[_e755];
                                                if (_e757 == 1u) {
                                                    let _e761 = bodies.member[(_e755 + 1u)];
                                                    if (_e761 == _e665) {
                                                        let _e765 = bodies.member[(_e755 + 2u)];
                                                        phi_1542_ = (_e765 == _e663);
                                                        phi_1543_ = false;
                                                    } else {
                                                        phi_1542_ = bool();
                                                        phi_1543_ = true;
                                                    }
                                                    let _e768 = phi_1542_;
                                                    let _e770 = phi_1543_;
                                                    phi_1544_ = _e768;
                                                    phi_1545_ = _e770;
                                                } else {
                                                    phi_1544_ = bool();
                                                    phi_1545_ = true;
                                                }
                                                let _e772 = phi_1544_;
                                                let _e774 = phi_1545_;
                                                if _e774 {
                                                    phi_1549_ = false;
                                                } else {
                                                    phi_1549_ = _e772;
                                                }
                                                let _e776 = phi_1549_;
                                                phi_1550_ = _e776;
                                            } else {
                                                phi_1550_ = false;
                                            }
                                            let _e778 = phi_1550_;
                                            phi_1554_ = _e778;
                                        } else {
                                            phi_1554_ = true;
                                        }
                                        let _e780 = phi_1554_;
                                        if _e780 {
                                            phi_1558_ = false;
                                        } else {
                                            phi_1558_ = true;
                                        }
                                        let _e782 = phi_1558_;
                                        phi_1559_ = _e782;
                                    } else {
                                        phi_1559_ = true;
                                    }
                                    let _e784 = phi_1559_;
                                    if _e784 {
                                        phi_1563_ = false;
                                    } else {
                                        phi_1563_ = true;
                                    }
                                    let _e786 = phi_1563_;
                                    phi_1564_ = _e786;
                                } else {
                                    phi_1564_ = true;
                                }
                                let _e788 = phi_1564_;
                                if _e788 {
                                    phi_1568_ = false;
                                } else {
                                    phi_1568_ = true;
                                }
                                let _e790 = phi_1568_;
                                phi_1569_ = _e790;
                            } else {
                                phi_1569_ = true;
                            }
                            let _e792 = phi_1569_;
                            if _e792 {
                                let _e794 = params.member.member.member_1;
                                if ((_e794 & 32u) != 0u) {
                                    let _e798 = params.member.member.member_6;
                                    let _e815 = (((((_e516.member_1.y - _e530.member.x) > _e798) && ((_e530.member_1.y - _e516.member.x) > _e798)) && (((_e516.member_2.x - _e530.member.y) > _e798) && ((_e530.member_2.x - _e516.member.y) > _e798))) && (((_e516.member_2.y - _e530.member_1.x) > _e798) && ((_e530.member_2.y - _e516.member_1.x) > _e798)));
                                    if _e815 {
                                        phi_2171_ = bool();
                                    } else {
                                        let _e819 = keys.member[_e512.member[0]];
                                        let _e824 = keys.member[_e512.member[1]];
                                        let _e826 = function_(_e819[0], _e824[0]);
                                        let _e830 = keys.member[_e512.member[2]];
                                        let _e832 = function_(_e826, _e830[0]);
                                        let _e836 = keys.member[_e514.member[0]];
                                        let _e841 = keys.member[_e514.member[1]];
                                        let _e843 = function_1(_e836[3], _e841[3]);
                                        let _e847 = keys.member[_e514.member[2]];
                                        let _e849 = function_1(_e843, _e847[3]);
                                        if (_e832[1] > _e849[1]) {
                                            phi_1694_ = true;
                                        } else {
                                            if (_e832[1] == _e849[1]) {
                                                phi_1693_ = (_e832[0] > _e849[0]);
                                            } else {
                                                phi_1693_ = false;
                                            }
                                            let _e860 = phi_1693_;
                                            phi_1694_ = _e860;
                                        }
                                        let _e862 = phi_1694_;
                                        let _e867 = keys.member[_e514.member[0]];
                                        let _e872 = keys.member[_e514.member[1]];
                                        let _e874 = function_(_e867[0], _e872[0]);
                                        let _e878 = keys.member[_e514.member[2]];
                                        let _e880 = function_(_e874, _e878[0]);
                                        let _e884 = keys.member[_e512.member[0]];
                                        let _e889 = keys.member[_e512.member[1]];
                                        let _e891 = function_1(_e884[3], _e889[3]);
                                        let _e895 = keys.member[_e512.member[2]];
                                        let _e897 = function_1(_e891, _e895[3]);
                                        if (_e880[1] > _e897[1]) {
                                            phi_1788_ = true;
                                        } else {
                                            if (_e880[1] == _e897[1]) {
                                                phi_1787_ = (_e880[0] > _e897[0]);
                                            } else {
                                                phi_1787_ = false;
                                            }
                                            let _e908 = phi_1787_;
                                            phi_1788_ = _e908;
                                        }
                                        let _e910 = phi_1788_;
                                        let _e916 = keys.member[_e512.member[0]];
                                        let _e921 = keys.member[_e512.member[1]];
                                        let _e923 = function_2(_e916[1], _e921[1]);
                                        let _e927 = keys.member[_e512.member[2]];
                                        let _e929 = function_2(_e923, _e927[1]);
                                        let _e933 = keys.member[_e514.member[0]];
                                        let _e938 = keys.member[_e514.member[1]];
                                        let _e940 = function_3(_e933[4], _e938[4]);
                                        let _e944 = keys.member[_e514.member[2]];
                                        let _e946 = function_3(_e940, _e944[4]);
                                        if (_e929[1] > _e946[1]) {
                                            phi_1883_ = true;
                                        } else {
                                            if (_e929[1] == _e946[1]) {
                                                phi_1882_ = (_e929[0] > _e946[0]);
                                            } else {
                                                phi_1882_ = false;
                                            }
                                            let _e957 = phi_1882_;
                                            phi_1883_ = _e957;
                                        }
                                        let _e959 = phi_1883_;
                                        let _e964 = keys.member[_e514.member[0]];
                                        let _e969 = keys.member[_e514.member[1]];
                                        let _e971 = function_2(_e964[1], _e969[1]);
                                        let _e975 = keys.member[_e514.member[2]];
                                        let _e977 = function_2(_e971, _e975[1]);
                                        let _e981 = keys.member[_e512.member[0]];
                                        let _e986 = keys.member[_e512.member[1]];
                                        let _e988 = function_3(_e981[4], _e986[4]);
                                        let _e992 = keys.member[_e512.member[2]];
                                        let _e994 = function_3(_e988, _e992[4]);
                                        if (_e977[1] > _e994[1]) {
                                            phi_1977_ = true;
                                        } else {
                                            if (_e977[1] == _e994[1]) {
                                                phi_1976_ = (_e977[0] > _e994[0]);
                                            } else {
                                                phi_1976_ = false;
                                            }
                                            let _e1005 = phi_1976_;
                                            phi_1977_ = _e1005;
                                        }
                                        let _e1007 = phi_1977_;
                                        let _e1014 = keys.member[_e512.member[0]];
                                        let _e1019 = keys.member[_e512.member[1]];
                                        let _e1021 = function_4(_e1014[2], _e1019[2]);
                                        let _e1025 = keys.member[_e512.member[2]];
                                        let _e1027 = function_4(_e1021, _e1025[2]);
                                        let _e1031 = keys.member[_e514.member[0]];
                                        let _e1036 = keys.member[_e514.member[1]];
                                        let _e1038 = function_5(_e1031[5], _e1036[5]);
                                        let _e1042 = keys.member[_e514.member[2]];
                                        let _e1044 = function_5(_e1038, _e1042[5]);
                                        if (_e1027[1] > _e1044[1]) {
                                            phi_2073_ = true;
                                        } else {
                                            if (_e1027[1] == _e1044[1]) {
                                                phi_2072_ = (_e1027[0] > _e1044[0]);
                                            } else {
                                                phi_2072_ = false;
                                            }
                                            let _e1055 = phi_2072_;
                                            phi_2073_ = _e1055;
                                        }
                                        let _e1057 = phi_2073_;
                                        let _e1062 = keys.member[_e514.member[0]];
                                        let _e1067 = keys.member[_e514.member[1]];
                                        let _e1069 = function_4(_e1062[2], _e1067[2]);
                                        let _e1073 = keys.member[_e514.member[2]];
                                        let _e1075 = function_4(_e1069, _e1073[2]);
                                        let _e1079 = keys.member[_e512.member[0]];
                                        let _e1084 = keys.member[_e512.member[1]];
                                        let _e1086 = function_5(_e1079[5], _e1084[5]);
                                        let _e1090 = keys.member[_e512.member[2]];
                                        let _e1092 = function_5(_e1086, _e1090[5]);
                                        if (_e1075[1] > _e1092[1]) {
                                            phi_2167_ = true;
                                        } else {
                                            if (_e1075[1] == _e1092[1]) {
                                                phi_2166_ = (_e1075[0] > _e1092[0]);
                                            } else {
                                                phi_2166_ = false;
                                            }
                                            let _e1103 = phi_2166_;
                                            phi_2167_ = _e1103;
                                        }
                                        let _e1105 = phi_2167_;
                                        phi_2171_ = (((!(_e862) && !(_e910)) && (!(_e959) && !(_e1007))) && (!(_e1057) && !(_e1105)));
                                    }
                                    let _e1110 = phi_2171_;
                                    phi_2172_ = _e1110;
                                    phi_2173_ = _e815;
                                } else {
                                    phi_2172_ = bool();
                                    phi_2173_ = true;
                                }
                                let _e1112 = phi_2172_;
                                let _e1114 = phi_2173_;
                                if _e1114 {
                                    phi_2177_ = false;
                                } else {
                                    phi_2177_ = true;
                                }
                                let _e1116 = phi_2177_;
                                phi_2178_ = _e1112;
                                phi_2179_ = _e1116;
                            } else {
                                phi_2178_ = false;
                                phi_2179_ = true;
                            }
                            let _e1118 = phi_2178_;
                            let _e1120 = phi_2179_;
                            phi_2180_ = _e1118;
                            phi_2181_ = _e1120;
                        } else {
                            phi_2180_ = false;
                            phi_2181_ = true;
                        }
                        let _e1122 = phi_2180_;
                        let _e1124 = phi_2181_;
                        if _e1124 {
                            phi_2185_ = _e1122;
                        } else {
                            phi_2185_ = true;
                        }
                        let _e1126 = phi_2185_;
                        if _e1126 {
                            if (_e512.member_1 < _e514.member_1) {
                                phi_2201_ = type_9(_e512.member_1, _e514.member_1);
                            } else {
                                phi_2201_ = type_9(_e514.member_1, _e512.member_1);
                            }
                            let _e1133 = phi_2201_;
                            let _e1137 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1137 + 1u) < _e1137) {
                                let _e1141 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1137 < _e90) {
                                let _e1143 = (2u * _e1137);
                                atomicStore((&output.member[(4u + _e1143)]), _e1133.member);
                                atomicStore((&output.member[(_e1143 + 5u)]), _e1133.member_1);
                            }
                            let _e1149 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1149 + 1u) < _e1149) {
                                let _e1153 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_2244_ = (_e481 & (_e481 - 1u));
                        phi_2245_ = true;
                    }
                    let _e1155 = phi_2244_;
                    let _e1157 = phi_2245_;
                    phi_995_ = _e1155;
                    phi_2246_ = _e1157;
                } else {
                    phi_995_ = u32();
                    phi_2246_ = false;
                }
                let _e1159 = phi_995_;
                let _e1161 = phi_2246_;
                continue;
                continuing {
                    phi_991_ = _e493;
                    phi_994_ = _e1159;
                    break if !(_e1161);
                }
            }
            workgroupBarrier();
            let _e1164 = atomicLoad((&counters[4u]));
            if (2048u < _e1164) {
                phi_2253_ = 2048u;
            } else {
                phi_2253_ = _e1164;
            }
            let _e1167 = phi_2253_;
            phi_2256_ = type_9(0u, 16u);
            loop {
                let _e1169 = phi_2256_;
                if (_e1169.member < _e1169.member_1) {
                    phi_2257_ = type_9((_e1169.member + 1u), _e1169.member_1);
                    phi_2280_ = type_9(1u, _e1169.member);
                } else {
                    phi_2257_ = _e1169;
                    phi_2280_ = type_9(0u, type_9().member_1);
                }
                let _e1181 = phi_2257_;
                let _e1183 = phi_2280_;
                if (bitcast<i32>(_e1183.member) != 0i) {
                    let _e1189 = (_e71 + (_e1183.member_1 * 128u));
                    if (_e1189 >= _e1167) {
                        phi_8683_ = false;
                    } else {
                        let _e1192 = hits[_e1189];
                        let _e1195 = ((_e1192 >> bitcast<u32>(10i)) & 3u);
                        let _e1202 = firsts[(2u * _e1195)];
                        let _e1203 = (_e1202 + ((_e1192 >> bitcast<u32>(5i)) & 31u));
                        let _e1207 = firsts[((2u * _e1195) + 1u)];
                        let _e1208 = (_e1207 + (_e1192 & 31u));
                        let _e1210 = leaves.member[_e1203];
                        let _e1212 = leaves.member[_e1208];
                        let _e1214 = nodes.member[_e1203];
                        let _e1228 = nodes.member[_e1208];
                        let _e1243 = params.member.member.member_1;
                        if ((_e1243 & 1u) != 0u) {
                            if (_e1212.member[0] == _e1210.member[0]) {
                                phi_2408_ = true;
                            } else {
                                phi_2408_ = (_e1212.member[0] == _e1210.member[1]);
                            }
                            let _e1257 = phi_2408_;
                            if (_e1212.member[1] == _e1210.member[0]) {
                                phi_2414_ = true;
                            } else {
                                phi_2414_ = (_e1212.member[1] == _e1210.member[1]);
                            }
                            let _e1261 = phi_2414_;
                            if (_e1257 || _e1261) {
                                phi_2420_ = false;
                            } else {
                                phi_2420_ = true;
                            }
                            let _e1264 = phi_2420_;
                            phi_2421_ = _e1264;
                        } else {
                            phi_2421_ = true;
                        }
                        let _e1266 = phi_2421_;
                        if _e1266 {
                            let _e1268 = params.member.member.member_1;
                            if ((_e1268 & 2u) != 0u) {
                                let _e1274 = bodies.member[_e1210.member[0]];
                                let _e1278 = bodies.member[_e1212.member[0]];
                                if ((_e1274 / 4u) != (_e1278 / 4u)) {
                                    phi_2466_ = true;
                                } else {
                                    if ((_e1274 & 2u) == 0u) {
                                        phi_2465_ = false;
                                    } else {
                                        phi_2465_ = true;
                                    }
                                    let _e1285 = phi_2465_;
                                    phi_2466_ = _e1285;
                                }
                                let _e1287 = phi_2466_;
                                if _e1287 {
                                    phi_2473_ = (((_e1274 & _e1278) & 1u) == 0u);
                                } else {
                                    phi_2473_ = false;
                                }
                                let _e1292 = phi_2473_;
                                if _e1292 {
                                    let _e1294 = params.member.member.member_1;
                                    if ((_e1294 & 4u) != 0u) {
                                        let _e1299 = params.member.member.member[0u];
                                        let _e1301 = bodies.member[_e1299];
                                        let _e1304 = bodies.member[(_e1299 + 1u)];
                                        let _e1309 = ((_e1299 + 4u) + (2u * (_e1274 >> bitcast<u32>(2i))));
                                        let _e1314 = ((_e1299 + 4u) + (2u * (_e1278 >> bitcast<u32>(2i))));
                                        let _e1316 = bodies.member[_e1309];
                                        let _e1318 = bodies.member[_e1314];
                                        let _e1327 = bodies.member[((((_e1299 + 4u) + (2u * _e1301)) + (_e1316 * _e1304)) + (_e1318 / 32u))];
                                        let _e1330 = bodies.member[(_e1309 + 1u)];
                                        let _e1333 = bodies.member[(_e1314 + 1u)];
                                        if (_e1330 == _e1333) {
                                            if (((_e1327 >> bitcast<u32>(((_e1318 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_2589_ = true;
                                            } else {
                                                phi_2589_ = ((_e1274 >> bitcast<u32>(2i)) == (_e1278 >> bitcast<u32>(2i)));
                                            }
                                            let _e1347 = phi_2589_;
                                            phi_2590_ = _e1347;
                                        } else {
                                            phi_2590_ = false;
                                        }
                                        let _e1349 = phi_2590_;
                                        if _e1349 {
                                            let _e1354 = bodies.member[(_e1299 + 2u)];
                                            let _e1357 = bodies.member[(_e1299 + 3u)];
                                            let _e1358 = (_e1357 + _e1299);
                                            if (_e1212.member_1 < _e1210.member_1) {
                                                phi_2627_ = _e1210.member_1;
                                                phi_2628_ = _e1212.member_1;
                                            } else {
                                                phi_2627_ = _e1212.member_1;
                                                phi_2628_ = _e1210.member_1;
                                            }
                                            let _e1361 = phi_2627_;
                                            let _e1363 = phi_2628_;
                                            phi_2633_ = type_15(0i, 32i);
                                            phi_2636_ = _e1354;
                                            phi_2638_ = 0u;
                                            loop {
                                                let _e1365 = phi_2633_;
                                                let _e1367 = phi_2636_;
                                                let _e1369 = phi_2638_;
                                                local_5 = _e1369;
                                                local_6 = _e1369;
                                                if (_e1365.member < _e1365.member_1) {
                                                    let _e1376 = (_e1365.member + 1i);
                                                    if ((false == (_e1376 > _e1365.member)) != false) {
                                                        phi_2659_ = true;
                                                    } else {
                                                        phi_2659_ = false;
                                                    }
                                                    let _e1381 = phi_2659_;
                                                    if _e1381 {
                                                        phi_2665_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_2665_ = type_16(1u, _e1376);
                                                    }
                                                    let _e1386 = phi_2665_;
                                                    phi_2634_ = type_15(_e1386.member_1, _e1365.member_1);
                                                    phi_2679_ = type_16(1u, _e1365.member);
                                                } else {
                                                    phi_2634_ = _e1365;
                                                    phi_2679_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e1392 = phi_2634_;
                                                let _e1394 = phi_2679_;
                                                if (bitcast<i32>(_e1394.member) != 0i) {
                                                    if (_e1369 >= _e1367) {
                                                        phi_2762_ = u32();
                                                        phi_2763_ = u32();
                                                        phi_2764_ = false;
                                                    } else {
                                                        let _e1401 = (_e1369 + ((_e1367 - _e1369) / 2u));
                                                        let _e1403 = (_e1358 + (3u * _e1401));
                                                        let _e1405 = bodies.member[_e1403];
                                                        let _e1408 = bodies.member[(_e1403 + 1u)];
                                                        let _e1411 = bodies.member[(_e1403 + 2u)];
                                                        if (_e1405 < 1u) {
                                                            phi_2755_ = true;
                                                        } else {
                                                            if (_e1405 == 1u) {
                                                                if (_e1408 < _e1363) {
                                                                    phi_2749_ = false;
                                                                } else {
                                                                    if (_e1408 == _e1363) {
                                                                        if (_e1411 < _e1361) {
                                                                            phi_2747_ = false;
                                                                        } else {
                                                                            phi_2747_ = true;
                                                                        }
                                                                        let _e1418 = phi_2747_;
                                                                        phi_2748_ = _e1418;
                                                                    } else {
                                                                        phi_2748_ = true;
                                                                    }
                                                                    let _e1420 = phi_2748_;
                                                                    phi_2749_ = _e1420;
                                                                }
                                                                let _e1422 = phi_2749_;
                                                                phi_2750_ = _e1422;
                                                            } else {
                                                                phi_2750_ = true;
                                                            }
                                                            let _e1424 = phi_2750_;
                                                            if _e1424 {
                                                                phi_2754_ = false;
                                                            } else {
                                                                phi_2754_ = true;
                                                            }
                                                            let _e1426 = phi_2754_;
                                                            phi_2755_ = _e1426;
                                                        }
                                                        let _e1428 = phi_2755_;
                                                        if _e1428 {
                                                            phi_2760_ = _e1367;
                                                            phi_2761_ = (_e1401 + 1u);
                                                        } else {
                                                            phi_2760_ = _e1401;
                                                            phi_2761_ = _e1369;
                                                        }
                                                        let _e1431 = phi_2760_;
                                                        let _e1433 = phi_2761_;
                                                        phi_2762_ = _e1431;
                                                        phi_2763_ = _e1433;
                                                        phi_2764_ = true;
                                                    }
                                                    let _e1435 = phi_2762_;
                                                    let _e1437 = phi_2763_;
                                                    let _e1439 = phi_2764_;
                                                    phi_2637_ = _e1435;
                                                    phi_2639_ = _e1437;
                                                    phi_2765_ = _e1439;
                                                } else {
                                                    phi_2637_ = u32();
                                                    phi_2639_ = u32();
                                                    phi_2765_ = false;
                                                }
                                                let _e1441 = phi_2637_;
                                                let _e1443 = phi_2639_;
                                                let _e1445 = phi_2765_;
                                                continue;
                                                continuing {
                                                    phi_2633_ = _e1392;
                                                    phi_2636_ = _e1441;
                                                    phi_2638_ = _e1443;
                                                    break if !(_e1445);
                                                }
                                            }
                                            let _e1448 = local_5;
                                            if (_e1448 < _e1354) {
                                                let _e1451 = local_6;
                                                let _e1453 = (_e1358 + (3u * _e1451));
                                                let _e1455 = bodies.member[_e1453];
                                                if (_e1455 == 1u) {
                                                    let _e1459 = bodies.member[(_e1453 + 1u)];
                                                    if (_e1459 == _e1363) {
                                                        let _e1463 = bodies.member[(_e1453 + 2u)];
                                                        phi_2813_ = (_e1463 == _e1361);
                                                        phi_2814_ = false;
                                                    } else {
                                                        phi_2813_ = bool();
                                                        phi_2814_ = true;
                                                    }
                                                    let _e1466 = phi_2813_;
                                                    let _e1468 = phi_2814_;
                                                    phi_2815_ = _e1466;
                                                    phi_2816_ = _e1468;
                                                } else {
                                                    phi_2815_ = bool();
                                                    phi_2816_ = true;
                                                }
                                                let _e1470 = phi_2815_;
                                                let _e1472 = phi_2816_;
                                                if _e1472 {
                                                    phi_2820_ = false;
                                                } else {
                                                    phi_2820_ = _e1470;
                                                }
                                                let _e1474 = phi_2820_;
                                                phi_2821_ = _e1474;
                                            } else {
                                                phi_2821_ = false;
                                            }
                                            let _e1476 = phi_2821_;
                                            phi_2825_ = _e1476;
                                        } else {
                                            phi_2825_ = true;
                                        }
                                        let _e1478 = phi_2825_;
                                        if _e1478 {
                                            phi_2829_ = false;
                                        } else {
                                            phi_2829_ = true;
                                        }
                                        let _e1480 = phi_2829_;
                                        phi_2830_ = _e1480;
                                    } else {
                                        phi_2830_ = true;
                                    }
                                    let _e1482 = phi_2830_;
                                    if _e1482 {
                                        phi_2834_ = false;
                                    } else {
                                        phi_2834_ = true;
                                    }
                                    let _e1484 = phi_2834_;
                                    phi_2835_ = _e1484;
                                } else {
                                    phi_2835_ = true;
                                }
                                let _e1486 = phi_2835_;
                                if _e1486 {
                                    phi_2839_ = false;
                                } else {
                                    phi_2839_ = true;
                                }
                                let _e1488 = phi_2839_;
                                phi_2840_ = _e1488;
                            } else {
                                phi_2840_ = true;
                            }
                            let _e1490 = phi_2840_;
                            if _e1490 {
                                let _e1492 = params.member.member.member_1;
                                if ((_e1492 & 32u) != 0u) {
                                    let _e1496 = params.member.member.member_6;
                                    let _e1513 = (((((_e1214.member_1.y - _e1228.member.x) > _e1496) && ((_e1228.member_1.y - _e1214.member.x) > _e1496)) && (((_e1214.member_2.x - _e1228.member.y) > _e1496) && ((_e1228.member_2.x - _e1214.member.y) > _e1496))) && (((_e1214.member_2.y - _e1228.member_1.x) > _e1496) && ((_e1228.member_2.y - _e1214.member_1.x) > _e1496)));
                                    if _e1513 {
                                        phi_3442_ = bool();
                                    } else {
                                        let _e1517 = keys.member[_e1210.member[0]];
                                        let _e1522 = keys.member[_e1210.member[1]];
                                        let _e1524 = function_(_e1517[0], _e1522[0]);
                                        let _e1528 = keys.member[_e1210.member[2]];
                                        let _e1530 = function_(_e1524, _e1528[0]);
                                        let _e1534 = keys.member[_e1212.member[0]];
                                        let _e1539 = keys.member[_e1212.member[1]];
                                        let _e1541 = function_1(_e1534[3], _e1539[3]);
                                        let _e1545 = keys.member[_e1212.member[2]];
                                        let _e1547 = function_1(_e1541, _e1545[3]);
                                        if (_e1530[1] > _e1547[1]) {
                                            phi_2965_ = true;
                                        } else {
                                            if (_e1530[1] == _e1547[1]) {
                                                phi_2964_ = (_e1530[0] > _e1547[0]);
                                            } else {
                                                phi_2964_ = false;
                                            }
                                            let _e1558 = phi_2964_;
                                            phi_2965_ = _e1558;
                                        }
                                        let _e1560 = phi_2965_;
                                        let _e1565 = keys.member[_e1212.member[0]];
                                        let _e1570 = keys.member[_e1212.member[1]];
                                        let _e1572 = function_(_e1565[0], _e1570[0]);
                                        let _e1576 = keys.member[_e1212.member[2]];
                                        let _e1578 = function_(_e1572, _e1576[0]);
                                        let _e1582 = keys.member[_e1210.member[0]];
                                        let _e1587 = keys.member[_e1210.member[1]];
                                        let _e1589 = function_1(_e1582[3], _e1587[3]);
                                        let _e1593 = keys.member[_e1210.member[2]];
                                        let _e1595 = function_1(_e1589, _e1593[3]);
                                        if (_e1578[1] > _e1595[1]) {
                                            phi_3059_ = true;
                                        } else {
                                            if (_e1578[1] == _e1595[1]) {
                                                phi_3058_ = (_e1578[0] > _e1595[0]);
                                            } else {
                                                phi_3058_ = false;
                                            }
                                            let _e1606 = phi_3058_;
                                            phi_3059_ = _e1606;
                                        }
                                        let _e1608 = phi_3059_;
                                        let _e1614 = keys.member[_e1210.member[0]];
                                        let _e1619 = keys.member[_e1210.member[1]];
                                        let _e1621 = function_2(_e1614[1], _e1619[1]);
                                        let _e1625 = keys.member[_e1210.member[2]];
                                        let _e1627 = function_2(_e1621, _e1625[1]);
                                        let _e1631 = keys.member[_e1212.member[0]];
                                        let _e1636 = keys.member[_e1212.member[1]];
                                        let _e1638 = function_3(_e1631[4], _e1636[4]);
                                        let _e1642 = keys.member[_e1212.member[2]];
                                        let _e1644 = function_3(_e1638, _e1642[4]);
                                        if (_e1627[1] > _e1644[1]) {
                                            phi_3154_ = true;
                                        } else {
                                            if (_e1627[1] == _e1644[1]) {
                                                phi_3153_ = (_e1627[0] > _e1644[0]);
                                            } else {
                                                phi_3153_ = false;
                                            }
                                            let _e1655 = phi_3153_;
                                            phi_3154_ = _e1655;
                                        }
                                        let _e1657 = phi_3154_;
                                        let _e1662 = keys.member[_e1212.member[0]];
                                        let _e1667 = keys.member[_e1212.member[1]];
                                        let _e1669 = function_2(_e1662[1], _e1667[1]);
                                        let _e1673 = keys.member[_e1212.member[2]];
                                        let _e1675 = function_2(_e1669, _e1673[1]);
                                        let _e1679 = keys.member[_e1210.member[0]];
                                        let _e1684 = keys.member[_e1210.member[1]];
                                        let _e1686 = function_3(_e1679[4], _e1684[4]);
                                        let _e1690 = keys.member[_e1210.member[2]];
                                        let _e1692 = function_3(_e1686, _e1690[4]);
                                        if (_e1675[1] > _e1692[1]) {
                                            phi_3248_ = true;
                                        } else {
                                            if (_e1675[1] == _e1692[1]) {
                                                phi_3247_ = (_e1675[0] > _e1692[0]);
                                            } else {
                                                phi_3247_ = false;
                                            }
                                            let _e1703 = phi_3247_;
                                            phi_3248_ = _e1703;
                                        }
                                        let _e1705 = phi_3248_;
                                        let _e1712 = keys.member[_e1210.member[0]];
                                        let _e1717 = keys.member[_e1210.member[1]];
                                        let _e1719 = function_4(_e1712[2], _e1717[2]);
                                        let _e1723 = keys.member[_e1210.member[2]];
                                        let _e1725 = function_4(_e1719, _e1723[2]);
                                        let _e1729 = keys.member[_e1212.member[0]];
                                        let _e1734 = keys.member[_e1212.member[1]];
                                        let _e1736 = function_5(_e1729[5], _e1734[5]);
                                        let _e1740 = keys.member[_e1212.member[2]];
                                        let _e1742 = function_5(_e1736, _e1740[5]);
                                        if (_e1725[1] > _e1742[1]) {
                                            phi_3344_ = true;
                                        } else {
                                            if (_e1725[1] == _e1742[1]) {
                                                phi_3343_ = (_e1725[0] > _e1742[0]);
                                            } else {
                                                phi_3343_ = false;
                                            }
                                            let _e1753 = phi_3343_;
                                            phi_3344_ = _e1753;
                                        }
                                        let _e1755 = phi_3344_;
                                        let _e1760 = keys.member[_e1212.member[0]];
                                        let _e1765 = keys.member[_e1212.member[1]];
                                        let _e1767 = function_4(_e1760[2], _e1765[2]);
                                        let _e1771 = keys.member[_e1212.member[2]];
                                        let _e1773 = function_4(_e1767, _e1771[2]);
                                        let _e1777 = keys.member[_e1210.member[0]];
                                        let _e1782 = keys.member[_e1210.member[1]];
                                        let _e1784 = function_5(_e1777[5], _e1782[5]);
                                        let _e1788 = keys.member[_e1210.member[2]];
                                        let _e1790 = function_5(_e1784, _e1788[5]);
                                        if (_e1773[1] > _e1790[1]) {
                                            phi_3438_ = true;
                                        } else {
                                            if (_e1773[1] == _e1790[1]) {
                                                phi_3437_ = (_e1773[0] > _e1790[0]);
                                            } else {
                                                phi_3437_ = false;
                                            }
                                            let _e1801 = phi_3437_;
                                            phi_3438_ = _e1801;
                                        }
                                        let _e1803 = phi_3438_;
                                        phi_3442_ = (((!(_e1560) && !(_e1608)) && (!(_e1657) && !(_e1705))) && (!(_e1755) && !(_e1803)));
                                    }
                                    let _e1808 = phi_3442_;
                                    phi_3443_ = _e1808;
                                    phi_3444_ = _e1513;
                                } else {
                                    phi_3443_ = bool();
                                    phi_3444_ = true;
                                }
                                let _e1810 = phi_3443_;
                                let _e1812 = phi_3444_;
                                if _e1812 {
                                    phi_3448_ = false;
                                } else {
                                    phi_3448_ = true;
                                }
                                let _e1814 = phi_3448_;
                                phi_3449_ = _e1810;
                                phi_3450_ = _e1814;
                            } else {
                                phi_3449_ = false;
                                phi_3450_ = true;
                            }
                            let _e1816 = phi_3449_;
                            let _e1818 = phi_3450_;
                            phi_3451_ = _e1816;
                            phi_3452_ = _e1818;
                        } else {
                            phi_3451_ = false;
                            phi_3452_ = true;
                        }
                        let _e1820 = phi_3451_;
                        let _e1822 = phi_3452_;
                        if _e1822 {
                            phi_3456_ = _e1820;
                        } else {
                            phi_3456_ = true;
                        }
                        let _e1824 = phi_3456_;
                        if _e1824 {
                            let _e1826 = atomicAdd((&counters[7u]), 1u);
                            if (_e1210.member_1 < _e1212.member_1) {
                                phi_3473_ = _e1212.member;
                                phi_3474_ = _e1210.member;
                            } else {
                                phi_3473_ = _e1210.member;
                                phi_3474_ = _e1212.member;
                            }
                            let _e1836 = phi_3473_;
                            let _e1838 = phi_3474_;
                            let _e1844 = params.member.member.member_4;
                            let _e1846 = params.member.member.member_5;
                            let _e1848 = paths.member[_e1838[0]];
                            let _e1850 = paths.member[_e1838[1]];
                            let _e1856 = paths.member[_e1836[0]];
                            let _e1858 = paths.member[_e1836[1]];
                            local_2 = type_41(array<array<f32, 3>, 2>(array<f32, 3>((_e1856.member[0] - _e1848.member[0]), (_e1856.member[1] - _e1848.member[1]), (_e1856.member[2] - _e1848.member[2])), array<f32, 3>((_e1856.member_1[0] - _e1848.member_1[0]), (_e1856.member_1[1] - _e1848.member_1[1]), (_e1856.member_1[2] - _e1848.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1850.member[0] - _e1848.member[0]), (_e1850.member[1] - _e1848.member[1]), (_e1850.member[2] - _e1848.member[2])), array<f32, 3>((_e1850.member_1[0] - _e1848.member_1[0]), (_e1850.member_1[1] - _e1848.member_1[1]), (_e1850.member_1[2] - _e1848.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1856.member[0] - _e1858.member[0]), (_e1856.member[1] - _e1858.member[1]), (_e1856.member[2] - _e1858.member[2])), array<f32, 3>((_e1856.member_1[0] - _e1858.member_1[0]), (_e1856.member_1[1] - _e1858.member_1[1]), (_e1856.member_1[2] - _e1858.member_1[2]))), (_e1844 + _e1844));
                            let _e1918 = local_2.member_1[0u];
                            let _e1924 = local_2.member_2[0u];
                            let _e1930 = ((_e1918[1] * _e1924[2]) - (_e1918[2] * _e1924[1]));
                            let _e1933 = ((_e1918[2] * _e1924[0]) - (_e1918[0] * _e1924[2]));
                            let _e1936 = ((_e1918[0] * _e1924[1]) - (_e1918[1] * _e1924[0]));
                            let _e1939 = local_2.member_1[1u];
                            let _e1945 = local_2.member_2[1u];
                            let _e1951 = ((_e1939[1] * _e1945[2]) - (_e1939[2] * _e1945[1]));
                            let _e1954 = ((_e1939[2] * _e1945[0]) - (_e1939[0] * _e1945[2]));
                            let _e1957 = ((_e1939[0] * _e1945[1]) - (_e1939[1] * _e1945[0]));
                            let _e1960 = local_2.member_1[0u];
                            let _e1966 = local_2.member_2[1u];
                            let _e1981 = local_2.member_1[1u];
                            let _e1987 = local_2.member_2[0u];
                            let _e2000 = (((_e1960[1] * _e1966[2]) - (_e1960[2] * _e1966[1])) + ((_e1981[1] * _e1987[2]) - (_e1981[2] * _e1987[1])));
                            let _e2001 = (((_e1960[2] * _e1966[0]) - (_e1960[0] * _e1966[2])) + ((_e1981[2] * _e1987[0]) - (_e1981[0] * _e1987[2])));
                            let _e2002 = (((_e1960[0] * _e1966[1]) - (_e1960[1] * _e1966[0])) + ((_e1981[0] * _e1987[1]) - (_e1981[1] * _e1987[0])));
                            let _e2005 = local_2.member[0u];
                            let _e2016 = local_2.member[1u];
                            let _e2027 = local_2.member[0u];
                            let _e2036 = ((((_e2016[0] * _e1930) + (_e2016[1] * _e1933)) + (_e2016[2] * _e1936)) + (((_e2027[0] * _e2000) + (_e2027[1] * _e2001)) + (_e2027[2] * _e2002)));
                            let _e2039 = local_2.member[0u];
                            let _e2050 = local_2.member[1u];
                            let _e2059 = ((((_e2039[0] * _e1951) + (_e2039[1] * _e1954)) + (_e2039[2] * _e1957)) + (((_e2050[0] * _e2000) + (_e2050[1] * _e2001)) + (_e2050[2] * _e2002)));
                            let _e2062 = local_2.member[1u];
                            let _e2073 = local_2.member[0u];
                            if (_e2073[0] < 0f) {
                                phi_3897_ = -(_e2073[0]);
                            } else {
                                phi_3897_ = _e2073[0];
                            }
                            let _e2080 = phi_3897_;
                            if (_e2073[1] < 0f) {
                                phi_3904_ = -(_e2073[1]);
                            } else {
                                phi_3904_ = _e2073[1];
                            }
                            let _e2084 = phi_3904_;
                            if (_e2080 > _e2084) {
                                phi_3909_ = _e2080;
                            } else {
                                phi_3909_ = _e2084;
                            }
                            let _e2087 = phi_3909_;
                            if (_e2073[2] < 0f) {
                                phi_3916_ = -(_e2073[2]);
                            } else {
                                phi_3916_ = _e2073[2];
                            }
                            let _e2091 = phi_3916_;
                            if (_e2087 > _e2091) {
                                phi_3921_ = _e2087;
                            } else {
                                phi_3921_ = _e2091;
                            }
                            let _e2094 = phi_3921_;
                            let _e2097 = local_2.member[1u];
                            if (_e2097[0] < 0f) {
                                phi_3934_ = -(_e2097[0]);
                            } else {
                                phi_3934_ = _e2097[0];
                            }
                            let _e2104 = phi_3934_;
                            if (_e2097[1] < 0f) {
                                phi_3941_ = -(_e2097[1]);
                            } else {
                                phi_3941_ = _e2097[1];
                            }
                            let _e2108 = phi_3941_;
                            if (_e2104 > _e2108) {
                                phi_3946_ = _e2104;
                            } else {
                                phi_3946_ = _e2108;
                            }
                            let _e2111 = phi_3946_;
                            if (_e2097[2] < 0f) {
                                phi_3953_ = -(_e2097[2]);
                            } else {
                                phi_3953_ = _e2097[2];
                            }
                            let _e2115 = phi_3953_;
                            if (_e2111 > _e2115) {
                                phi_3958_ = _e2111;
                            } else {
                                phi_3958_ = _e2115;
                            }
                            let _e2118 = phi_3958_;
                            if (_e2094 > _e2118) {
                                phi_3963_ = _e2094;
                            } else {
                                phi_3963_ = _e2118;
                            }
                            let _e2121 = phi_3963_;
                            let _e2123 = local_2.member_3;
                            let _e2124 = (_e2121 + _e2123);
                            let _e2127 = local_2.member_1[0u];
                            if (_e2127[0] < 0f) {
                                phi_3980_ = -(_e2127[0]);
                            } else {
                                phi_3980_ = _e2127[0];
                            }
                            let _e2134 = phi_3980_;
                            if (_e2127[1] < 0f) {
                                phi_3987_ = -(_e2127[1]);
                            } else {
                                phi_3987_ = _e2127[1];
                            }
                            let _e2138 = phi_3987_;
                            if (_e2134 > _e2138) {
                                phi_3992_ = _e2134;
                            } else {
                                phi_3992_ = _e2138;
                            }
                            let _e2141 = phi_3992_;
                            if (_e2127[2] < 0f) {
                                phi_3999_ = -(_e2127[2]);
                            } else {
                                phi_3999_ = _e2127[2];
                            }
                            let _e2145 = phi_3999_;
                            if (_e2141 > _e2145) {
                                phi_4004_ = _e2141;
                            } else {
                                phi_4004_ = _e2145;
                            }
                            let _e2148 = phi_4004_;
                            let _e2151 = local_2.member_1[1u];
                            if (_e2151[0] < 0f) {
                                phi_4018_ = -(_e2151[0]);
                            } else {
                                phi_4018_ = _e2151[0];
                            }
                            let _e2158 = phi_4018_;
                            if (_e2151[1] < 0f) {
                                phi_4025_ = -(_e2151[1]);
                            } else {
                                phi_4025_ = _e2151[1];
                            }
                            let _e2162 = phi_4025_;
                            if (_e2158 > _e2162) {
                                phi_4030_ = _e2158;
                            } else {
                                phi_4030_ = _e2162;
                            }
                            let _e2165 = phi_4030_;
                            if (_e2151[2] < 0f) {
                                phi_4037_ = -(_e2151[2]);
                            } else {
                                phi_4037_ = _e2151[2];
                            }
                            let _e2169 = phi_4037_;
                            if (_e2165 > _e2169) {
                                phi_4042_ = _e2165;
                            } else {
                                phi_4042_ = _e2169;
                            }
                            let _e2172 = phi_4042_;
                            if (_e2148 > _e2172) {
                                phi_4047_ = _e2148;
                            } else {
                                phi_4047_ = _e2172;
                            }
                            let _e2175 = phi_4047_;
                            let _e2177 = local_2.member_3;
                            let _e2178 = (_e2175 + _e2177);
                            let _e2181 = local_2.member_2[0u];
                            if (_e2181[0] < 0f) {
                                phi_4064_ = -(_e2181[0]);
                            } else {
                                phi_4064_ = _e2181[0];
                            }
                            let _e2188 = phi_4064_;
                            if (_e2181[1] < 0f) {
                                phi_4071_ = -(_e2181[1]);
                            } else {
                                phi_4071_ = _e2181[1];
                            }
                            let _e2192 = phi_4071_;
                            if (_e2188 > _e2192) {
                                phi_4076_ = _e2188;
                            } else {
                                phi_4076_ = _e2192;
                            }
                            let _e2195 = phi_4076_;
                            if (_e2181[2] < 0f) {
                                phi_4083_ = -(_e2181[2]);
                            } else {
                                phi_4083_ = _e2181[2];
                            }
                            let _e2199 = phi_4083_;
                            if (_e2195 > _e2199) {
                                phi_4088_ = _e2195;
                            } else {
                                phi_4088_ = _e2199;
                            }
                            let _e2202 = phi_4088_;
                            let _e2205 = local_2.member_2[1u];
                            if (_e2205[0] < 0f) {
                                phi_4102_ = -(_e2205[0]);
                            } else {
                                phi_4102_ = _e2205[0];
                            }
                            let _e2212 = phi_4102_;
                            if (_e2205[1] < 0f) {
                                phi_4109_ = -(_e2205[1]);
                            } else {
                                phi_4109_ = _e2205[1];
                            }
                            let _e2216 = phi_4109_;
                            if (_e2212 > _e2216) {
                                phi_4114_ = _e2212;
                            } else {
                                phi_4114_ = _e2216;
                            }
                            let _e2219 = phi_4114_;
                            if (_e2205[2] < 0f) {
                                phi_4121_ = -(_e2205[2]);
                            } else {
                                phi_4121_ = _e2205[2];
                            }
                            let _e2223 = phi_4121_;
                            if (_e2219 > _e2223) {
                                phi_4126_ = _e2219;
                            } else {
                                phi_4126_ = _e2223;
                            }
                            let _e2226 = phi_4126_;
                            if (_e2202 > _e2226) {
                                phi_4131_ = _e2202;
                            } else {
                                phi_4131_ = _e2226;
                            }
                            let _e2229 = phi_4131_;
                            let _e2231 = local_2.member_3;
                            let _e2232 = (_e2229 + _e2231);
                            let _e2234 = ((_e2178 * 8f) * _e2232);
                            let _e2241 = local_2.member_3;
                            if (_e1930 < 0f) {
                                phi_4162_ = -(_e1930);
                            } else {
                                phi_4162_ = _e1930;
                            }
                            let _e2258 = phi_4162_;
                            if (_e1933 < 0f) {
                                phi_4168_ = -(_e1933);
                            } else {
                                phi_4168_ = _e1933;
                            }
                            let _e2262 = phi_4168_;
                            if (_e1936 < 0f) {
                                phi_4175_ = -(_e1936);
                            } else {
                                phi_4175_ = _e1936;
                            }
                            let _e2267 = phi_4175_;
                            let _e2268 = ((_e2258 + _e2262) + _e2267);
                            if (_e1951 < 0f) {
                                phi_4182_ = -(_e1951);
                            } else {
                                phi_4182_ = _e1951;
                            }
                            let _e2272 = phi_4182_;
                            if (_e1954 < 0f) {
                                phi_4188_ = -(_e1954);
                            } else {
                                phi_4188_ = _e1954;
                            }
                            let _e2276 = phi_4188_;
                            if (_e1957 < 0f) {
                                phi_4195_ = -(_e1957);
                            } else {
                                phi_4195_ = _e1957;
                            }
                            let _e2281 = phi_4195_;
                            let _e2282 = ((_e2272 + _e2276) + _e2281);
                            if (_e2268 > _e2282) {
                                phi_4201_ = _e2268;
                            } else {
                                phi_4201_ = _e2282;
                            }
                            let _e2285 = phi_4201_;
                            if (_e2000 < 0f) {
                                phi_4207_ = -(_e2000);
                            } else {
                                phi_4207_ = _e2000;
                            }
                            let _e2289 = phi_4207_;
                            if (_e2001 < 0f) {
                                phi_4213_ = -(_e2001);
                            } else {
                                phi_4213_ = _e2001;
                            }
                            let _e2293 = phi_4213_;
                            if (_e2002 < 0f) {
                                phi_4220_ = -(_e2002);
                            } else {
                                phi_4220_ = _e2002;
                            }
                            let _e2298 = phi_4220_;
                            let _e2300 = (((_e2289 + _e2293) + _e2298) * 0.5f);
                            if (_e2285 > _e2300) {
                                phi_4227_ = _e2285;
                            } else {
                                phi_4227_ = _e2300;
                            }
                            let _e2303 = phi_4227_;
                            let _e2308 = local_2.member_3;
                            let _e2321 = ((((_e2005[0] * _e1930) + (_e2005[1] * _e1933)) + (_e2005[2] * _e1936)) * 3f);
                            let _e2322 = ((((_e2062[0] * _e1951) + (_e2062[1] * _e1954)) + (_e2062[2] * _e1957)) * 3f);
                            if (_e2321 < _e2322) {
                                phi_4251_ = _e2321;
                            } else {
                                phi_4251_ = _e2322;
                            }
                            let _e2325 = phi_4251_;
                            if (_e2036 < _e2059) {
                                phi_4256_ = _e2036;
                            } else {
                                phi_4256_ = _e2059;
                            }
                            let _e2328 = phi_4256_;
                            if (_e2325 < _e2328) {
                                phi_4261_ = _e2325;
                            } else {
                                phi_4261_ = _e2328;
                            }
                            let _e2331 = phi_4261_;
                            if (_e2321 > _e2322) {
                                phi_4266_ = _e2321;
                            } else {
                                phi_4266_ = _e2322;
                            }
                            let _e2334 = phi_4266_;
                            if (_e2036 > _e2059) {
                                phi_4271_ = _e2036;
                            } else {
                                phi_4271_ = _e2059;
                            }
                            let _e2337 = phi_4271_;
                            if (_e2334 > _e2337) {
                                phi_4276_ = _e2334;
                            } else {
                                phi_4276_ = _e2337;
                            }
                            let _e2340 = phi_4276_;
                            let _e2345 = -(_e2340);
                            if (_e2331 > _e2345) {
                                phi_4286_ = _e2331;
                            } else {
                                phi_4286_ = _e2345;
                            }
                            let _e2348 = phi_4286_;
                            let _e2350 = ((_e2348 - ((((((_e2124 * 8f) * _e2234) * (0.000000059604645f * (524f / 64f))) + ((_e2241 * 19f) * ((_e2124 * (_e2178 + _e2232)) + (_e2178 * _e2232)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2124) * ((1f + _e2178) * (1f + _e2232))))) + ((_e1846 * (((_e2303 + (_e2234 * (0.000000059604645f * 8f))) + ((_e2308 * 6f) * (_e2178 + _e2232))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2178) * (1f + _e2232))))) * (3f * 1.0001f)))) > 0f);
                            if _e2350 {
                                phi_5255_ = _e2350;
                            } else {
                                let _e2353 = local_2.member_1[0u];
                                let _e2359 = local_2.member_1[1u];
                                let _e2363 = (_e2353[0] + _e2359[0]);
                                let _e2364 = (_e2353[1] + _e2359[1]);
                                let _e2365 = (_e2353[2] + _e2359[2]);
                                let _e2368 = local_2.member_2[0u];
                                let _e2374 = local_2.member_2[1u];
                                let _e2378 = (_e2368[0] + _e2374[0]);
                                let _e2379 = (_e2368[1] + _e2374[1]);
                                let _e2380 = (_e2368[2] + _e2374[2]);
                                let _e2383 = ((_e2364 * _e2380) - (_e2365 * _e2379));
                                let _e2386 = ((_e2365 * _e2378) - (_e2363 * _e2380));
                                let _e2389 = ((_e2363 * _e2379) - (_e2364 * _e2378));
                                let _e2392 = local_2.member[0u];
                                let _e2398 = local_2.member_1[0u];
                                let _e2404 = local_2.member_2[0u];
                                let _e2408 = (_e2392[0] - _e2398[0]);
                                let _e2409 = (_e2392[1] - _e2398[1]);
                                let _e2410 = (_e2392[2] - _e2398[2]);
                                let _e2411 = (_e2408 - _e2404[0]);
                                let _e2412 = (_e2409 - _e2404[1]);
                                let _e2413 = (_e2410 - _e2404[2]);
                                let _e2414 = (_e2392[0] - _e2404[0]);
                                let _e2415 = (_e2392[1] - _e2404[1]);
                                let _e2416 = (_e2392[2] - _e2404[2]);
                                let _e2419 = local_2.member[1u];
                                let _e2425 = local_2.member_1[1u];
                                let _e2431 = local_2.member_2[1u];
                                let _e2435 = (_e2419[0] - _e2425[0]);
                                let _e2436 = (_e2419[1] - _e2425[1]);
                                let _e2437 = (_e2419[2] - _e2425[2]);
                                let _e2438 = (_e2435 - _e2431[0]);
                                let _e2439 = (_e2436 - _e2431[1]);
                                let _e2440 = (_e2437 - _e2431[2]);
                                let _e2441 = (_e2419[0] - _e2431[0]);
                                let _e2442 = (_e2419[1] - _e2431[1]);
                                let _e2443 = (_e2419[2] - _e2431[2]);
                                let _e2446 = local_2.member[0u];
                                if (_e2446[0] < 0f) {
                                    phi_4489_ = -(_e2446[0]);
                                } else {
                                    phi_4489_ = _e2446[0];
                                }
                                let _e2453 = phi_4489_;
                                if (_e2446[1] < 0f) {
                                    phi_4496_ = -(_e2446[1]);
                                } else {
                                    phi_4496_ = _e2446[1];
                                }
                                let _e2457 = phi_4496_;
                                if (_e2453 > _e2457) {
                                    phi_4501_ = _e2453;
                                } else {
                                    phi_4501_ = _e2457;
                                }
                                let _e2460 = phi_4501_;
                                if (_e2446[2] < 0f) {
                                    phi_4508_ = -(_e2446[2]);
                                } else {
                                    phi_4508_ = _e2446[2];
                                }
                                let _e2464 = phi_4508_;
                                if (_e2460 > _e2464) {
                                    phi_4513_ = _e2460;
                                } else {
                                    phi_4513_ = _e2464;
                                }
                                let _e2467 = phi_4513_;
                                let _e2470 = local_2.member[1u];
                                if (_e2470[0] < 0f) {
                                    phi_4526_ = -(_e2470[0]);
                                } else {
                                    phi_4526_ = _e2470[0];
                                }
                                let _e2477 = phi_4526_;
                                if (_e2470[1] < 0f) {
                                    phi_4533_ = -(_e2470[1]);
                                } else {
                                    phi_4533_ = _e2470[1];
                                }
                                let _e2481 = phi_4533_;
                                if (_e2477 > _e2481) {
                                    phi_4538_ = _e2477;
                                } else {
                                    phi_4538_ = _e2481;
                                }
                                let _e2484 = phi_4538_;
                                if (_e2470[2] < 0f) {
                                    phi_4545_ = -(_e2470[2]);
                                } else {
                                    phi_4545_ = _e2470[2];
                                }
                                let _e2488 = phi_4545_;
                                if (_e2484 > _e2488) {
                                    phi_4550_ = _e2484;
                                } else {
                                    phi_4550_ = _e2488;
                                }
                                let _e2491 = phi_4550_;
                                if (_e2467 > _e2491) {
                                    phi_4555_ = _e2467;
                                } else {
                                    phi_4555_ = _e2491;
                                }
                                let _e2494 = phi_4555_;
                                let _e2496 = local_2.member_3;
                                let _e2500 = local_2.member_1[0u];
                                if (_e2500[0] < 0f) {
                                    phi_4572_ = -(_e2500[0]);
                                } else {
                                    phi_4572_ = _e2500[0];
                                }
                                let _e2507 = phi_4572_;
                                if (_e2500[1] < 0f) {
                                    phi_4579_ = -(_e2500[1]);
                                } else {
                                    phi_4579_ = _e2500[1];
                                }
                                let _e2511 = phi_4579_;
                                if (_e2507 > _e2511) {
                                    phi_4584_ = _e2507;
                                } else {
                                    phi_4584_ = _e2511;
                                }
                                let _e2514 = phi_4584_;
                                if (_e2500[2] < 0f) {
                                    phi_4591_ = -(_e2500[2]);
                                } else {
                                    phi_4591_ = _e2500[2];
                                }
                                let _e2518 = phi_4591_;
                                if (_e2514 > _e2518) {
                                    phi_4596_ = _e2514;
                                } else {
                                    phi_4596_ = _e2518;
                                }
                                let _e2521 = phi_4596_;
                                let _e2524 = local_2.member_1[1u];
                                if (_e2524[0] < 0f) {
                                    phi_4610_ = -(_e2524[0]);
                                } else {
                                    phi_4610_ = _e2524[0];
                                }
                                let _e2531 = phi_4610_;
                                if (_e2524[1] < 0f) {
                                    phi_4617_ = -(_e2524[1]);
                                } else {
                                    phi_4617_ = _e2524[1];
                                }
                                let _e2535 = phi_4617_;
                                if (_e2531 > _e2535) {
                                    phi_4622_ = _e2531;
                                } else {
                                    phi_4622_ = _e2535;
                                }
                                let _e2538 = phi_4622_;
                                if (_e2524[2] < 0f) {
                                    phi_4629_ = -(_e2524[2]);
                                } else {
                                    phi_4629_ = _e2524[2];
                                }
                                let _e2542 = phi_4629_;
                                if (_e2538 > _e2542) {
                                    phi_4634_ = _e2538;
                                } else {
                                    phi_4634_ = _e2542;
                                }
                                let _e2545 = phi_4634_;
                                if (_e2521 > _e2545) {
                                    phi_4639_ = _e2521;
                                } else {
                                    phi_4639_ = _e2545;
                                }
                                let _e2548 = phi_4639_;
                                let _e2550 = local_2.member_3;
                                let _e2554 = local_2.member_2[0u];
                                if (_e2554[0] < 0f) {
                                    phi_4656_ = -(_e2554[0]);
                                } else {
                                    phi_4656_ = _e2554[0];
                                }
                                let _e2561 = phi_4656_;
                                if (_e2554[1] < 0f) {
                                    phi_4663_ = -(_e2554[1]);
                                } else {
                                    phi_4663_ = _e2554[1];
                                }
                                let _e2565 = phi_4663_;
                                if (_e2561 > _e2565) {
                                    phi_4668_ = _e2561;
                                } else {
                                    phi_4668_ = _e2565;
                                }
                                let _e2568 = phi_4668_;
                                if (_e2554[2] < 0f) {
                                    phi_4675_ = -(_e2554[2]);
                                } else {
                                    phi_4675_ = _e2554[2];
                                }
                                let _e2572 = phi_4675_;
                                if (_e2568 > _e2572) {
                                    phi_4680_ = _e2568;
                                } else {
                                    phi_4680_ = _e2572;
                                }
                                let _e2575 = phi_4680_;
                                let _e2578 = local_2.member_2[1u];
                                if (_e2578[0] < 0f) {
                                    phi_4694_ = -(_e2578[0]);
                                } else {
                                    phi_4694_ = _e2578[0];
                                }
                                let _e2585 = phi_4694_;
                                if (_e2578[1] < 0f) {
                                    phi_4701_ = -(_e2578[1]);
                                } else {
                                    phi_4701_ = _e2578[1];
                                }
                                let _e2589 = phi_4701_;
                                if (_e2585 > _e2589) {
                                    phi_4706_ = _e2585;
                                } else {
                                    phi_4706_ = _e2589;
                                }
                                let _e2592 = phi_4706_;
                                if (_e2578[2] < 0f) {
                                    phi_4713_ = -(_e2578[2]);
                                } else {
                                    phi_4713_ = _e2578[2];
                                }
                                let _e2596 = phi_4713_;
                                if (_e2592 > _e2596) {
                                    phi_4718_ = _e2592;
                                } else {
                                    phi_4718_ = _e2596;
                                }
                                let _e2599 = phi_4718_;
                                if (_e2575 > _e2599) {
                                    phi_4723_ = _e2575;
                                } else {
                                    phi_4723_ = _e2599;
                                }
                                let _e2602 = phi_4723_;
                                let _e2604 = local_2.member_3;
                                let _e2608 = ((((_e2494 + _e2496) + (_e2548 + _e2550)) + (_e2602 + _e2604)) * 2f);
                                let _e2611 = local_2.member_3;
                                let _e2615 = (((_e1846 * 1.0001f) + (_e2611 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2618 = ((_e2386 * _e2365) - (_e2389 * _e2364));
                                let _e2621 = ((_e2389 * _e2363) - (_e2383 * _e2365));
                                let _e2624 = ((_e2383 * _e2364) - (_e2386 * _e2363));
                                let _e2629 = (((_e2618 * _e2392[0]) + (_e2621 * _e2392[1])) + (_e2624 * _e2392[2]));
                                let _e2634 = (((_e2618 * _e2408) + (_e2621 * _e2409)) + (_e2624 * _e2410));
                                let _e2639 = (((_e2618 * _e2414) + (_e2621 * _e2415)) + (_e2624 * _e2416));
                                let _e2644 = (((_e2618 * _e2411) + (_e2621 * _e2412)) + (_e2624 * _e2413));
                                let _e2649 = (((_e2618 * _e2419[0]) + (_e2621 * _e2419[1])) + (_e2624 * _e2419[2]));
                                let _e2654 = (((_e2618 * _e2435) + (_e2621 * _e2436)) + (_e2624 * _e2437));
                                let _e2659 = (((_e2618 * _e2441) + (_e2621 * _e2442)) + (_e2624 * _e2443));
                                let _e2664 = (((_e2618 * _e2438) + (_e2621 * _e2439)) + (_e2624 * _e2440));
                                if (_e2629 < _e2634) {
                                    phi_4802_ = _e2629;
                                } else {
                                    phi_4802_ = _e2634;
                                }
                                let _e2667 = phi_4802_;
                                if (_e2639 < _e2644) {
                                    phi_4807_ = _e2639;
                                } else {
                                    phi_4807_ = _e2644;
                                }
                                let _e2670 = phi_4807_;
                                if (_e2667 < _e2670) {
                                    phi_4812_ = _e2667;
                                } else {
                                    phi_4812_ = _e2670;
                                }
                                let _e2673 = phi_4812_;
                                if (_e2649 < _e2654) {
                                    phi_4817_ = _e2649;
                                } else {
                                    phi_4817_ = _e2654;
                                }
                                let _e2676 = phi_4817_;
                                if (_e2659 < _e2664) {
                                    phi_4822_ = _e2659;
                                } else {
                                    phi_4822_ = _e2664;
                                }
                                let _e2679 = phi_4822_;
                                if (_e2676 < _e2679) {
                                    phi_4827_ = _e2676;
                                } else {
                                    phi_4827_ = _e2679;
                                }
                                let _e2682 = phi_4827_;
                                if (_e2673 < _e2682) {
                                    phi_4832_ = _e2673;
                                } else {
                                    phi_4832_ = _e2682;
                                }
                                let _e2685 = phi_4832_;
                                if (_e2629 > _e2634) {
                                    phi_4837_ = _e2629;
                                } else {
                                    phi_4837_ = _e2634;
                                }
                                let _e2688 = phi_4837_;
                                if (_e2639 > _e2644) {
                                    phi_4842_ = _e2639;
                                } else {
                                    phi_4842_ = _e2644;
                                }
                                let _e2691 = phi_4842_;
                                if (_e2688 > _e2691) {
                                    phi_4847_ = _e2688;
                                } else {
                                    phi_4847_ = _e2691;
                                }
                                let _e2694 = phi_4847_;
                                if (_e2649 > _e2654) {
                                    phi_4852_ = _e2649;
                                } else {
                                    phi_4852_ = _e2654;
                                }
                                let _e2697 = phi_4852_;
                                if (_e2659 > _e2664) {
                                    phi_4857_ = _e2659;
                                } else {
                                    phi_4857_ = _e2664;
                                }
                                let _e2700 = phi_4857_;
                                if (_e2697 > _e2700) {
                                    phi_4862_ = _e2697;
                                } else {
                                    phi_4862_ = _e2700;
                                }
                                let _e2703 = phi_4862_;
                                if (_e2694 > _e2703) {
                                    phi_4867_ = _e2694;
                                } else {
                                    phi_4867_ = _e2703;
                                }
                                let _e2706 = phi_4867_;
                                if (_e2618 < 0f) {
                                    phi_4873_ = -(_e2618);
                                } else {
                                    phi_4873_ = _e2618;
                                }
                                let _e2710 = phi_4873_;
                                if (_e2621 < 0f) {
                                    phi_4879_ = -(_e2621);
                                } else {
                                    phi_4879_ = _e2621;
                                }
                                let _e2714 = phi_4879_;
                                if (_e2624 < 0f) {
                                    phi_4886_ = -(_e2624);
                                } else {
                                    phi_4886_ = _e2624;
                                }
                                let _e2719 = phi_4886_;
                                let _e2720 = ((_e2710 + _e2714) + _e2719);
                                let _e2725 = -(_e2706);
                                if (_e2685 > _e2725) {
                                    phi_4897_ = _e2685;
                                } else {
                                    phi_4897_ = _e2725;
                                }
                                let _e2728 = phi_4897_;
                                let _e2733 = (((_e2728 - ((_e2720 * _e2608) * (0.000000059604645f * (17f / 2f)))) - (_e2720 * _e2615)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2736 = ((_e2386 * _e2380) - (_e2389 * _e2379));
                                let _e2739 = ((_e2389 * _e2378) - (_e2383 * _e2380));
                                let _e2742 = ((_e2383 * _e2379) - (_e2386 * _e2378));
                                let _e2747 = (((_e2736 * _e2392[0]) + (_e2739 * _e2392[1])) + (_e2742 * _e2392[2]));
                                let _e2752 = (((_e2736 * _e2408) + (_e2739 * _e2409)) + (_e2742 * _e2410));
                                let _e2757 = (((_e2736 * _e2414) + (_e2739 * _e2415)) + (_e2742 * _e2416));
                                let _e2762 = (((_e2736 * _e2411) + (_e2739 * _e2412)) + (_e2742 * _e2413));
                                let _e2767 = (((_e2736 * _e2419[0]) + (_e2739 * _e2419[1])) + (_e2742 * _e2419[2]));
                                let _e2772 = (((_e2736 * _e2435) + (_e2739 * _e2436)) + (_e2742 * _e2437));
                                let _e2777 = (((_e2736 * _e2441) + (_e2739 * _e2442)) + (_e2742 * _e2443));
                                let _e2782 = (((_e2736 * _e2438) + (_e2739 * _e2439)) + (_e2742 * _e2440));
                                if (_e2747 < _e2752) {
                                    phi_4968_ = _e2747;
                                } else {
                                    phi_4968_ = _e2752;
                                }
                                let _e2785 = phi_4968_;
                                if (_e2757 < _e2762) {
                                    phi_4973_ = _e2757;
                                } else {
                                    phi_4973_ = _e2762;
                                }
                                let _e2788 = phi_4973_;
                                if (_e2785 < _e2788) {
                                    phi_4978_ = _e2785;
                                } else {
                                    phi_4978_ = _e2788;
                                }
                                let _e2791 = phi_4978_;
                                if (_e2767 < _e2772) {
                                    phi_4983_ = _e2767;
                                } else {
                                    phi_4983_ = _e2772;
                                }
                                let _e2794 = phi_4983_;
                                if (_e2777 < _e2782) {
                                    phi_4988_ = _e2777;
                                } else {
                                    phi_4988_ = _e2782;
                                }
                                let _e2797 = phi_4988_;
                                if (_e2794 < _e2797) {
                                    phi_4993_ = _e2794;
                                } else {
                                    phi_4993_ = _e2797;
                                }
                                let _e2800 = phi_4993_;
                                if (_e2791 < _e2800) {
                                    phi_4998_ = _e2791;
                                } else {
                                    phi_4998_ = _e2800;
                                }
                                let _e2803 = phi_4998_;
                                if (_e2747 > _e2752) {
                                    phi_5003_ = _e2747;
                                } else {
                                    phi_5003_ = _e2752;
                                }
                                let _e2806 = phi_5003_;
                                if (_e2757 > _e2762) {
                                    phi_5008_ = _e2757;
                                } else {
                                    phi_5008_ = _e2762;
                                }
                                let _e2809 = phi_5008_;
                                if (_e2806 > _e2809) {
                                    phi_5013_ = _e2806;
                                } else {
                                    phi_5013_ = _e2809;
                                }
                                let _e2812 = phi_5013_;
                                if (_e2767 > _e2772) {
                                    phi_5018_ = _e2767;
                                } else {
                                    phi_5018_ = _e2772;
                                }
                                let _e2815 = phi_5018_;
                                if (_e2777 > _e2782) {
                                    phi_5023_ = _e2777;
                                } else {
                                    phi_5023_ = _e2782;
                                }
                                let _e2818 = phi_5023_;
                                if (_e2815 > _e2818) {
                                    phi_5028_ = _e2815;
                                } else {
                                    phi_5028_ = _e2818;
                                }
                                let _e2821 = phi_5028_;
                                if (_e2812 > _e2821) {
                                    phi_5033_ = _e2812;
                                } else {
                                    phi_5033_ = _e2821;
                                }
                                let _e2824 = phi_5033_;
                                if (_e2736 < 0f) {
                                    phi_5039_ = -(_e2736);
                                } else {
                                    phi_5039_ = _e2736;
                                }
                                let _e2828 = phi_5039_;
                                if (_e2739 < 0f) {
                                    phi_5045_ = -(_e2739);
                                } else {
                                    phi_5045_ = _e2739;
                                }
                                let _e2832 = phi_5045_;
                                if (_e2742 < 0f) {
                                    phi_5052_ = -(_e2742);
                                } else {
                                    phi_5052_ = _e2742;
                                }
                                let _e2837 = phi_5052_;
                                let _e2838 = ((_e2828 + _e2832) + _e2837);
                                let _e2843 = -(_e2824);
                                if (_e2803 > _e2843) {
                                    phi_5063_ = _e2803;
                                } else {
                                    phi_5063_ = _e2843;
                                }
                                let _e2846 = phi_5063_;
                                let _e2851 = (((_e2846 - ((_e2838 * _e2608) * (0.000000059604645f * (17f / 2f)))) - (_e2838 * _e2615)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2733 > _e2851) {
                                    phi_5073_ = _e2733;
                                } else {
                                    phi_5073_ = _e2851;
                                }
                                let _e2854 = phi_5073_;
                                phi_5255_ = (_e2350 || (_e2854 > 0f));
                            }
                            let _e2858 = phi_5255_;
                            if _e2858 {
                                phi_8672_ = _e2858;
                            } else {
                                let _e2861 = local_2.member[0u];
                                let _e2867 = local_2.member[1u];
                                let _e2874 = ((_e2861[0] + _e2867[0]) * 0.5f);
                                let _e2875 = ((_e2861[1] + _e2867[1]) * 0.5f);
                                let _e2876 = ((_e2861[2] + _e2867[2]) * 0.5f);
                                let _e2879 = local_2.member_1[0u];
                                let _e2885 = local_2.member_1[1u];
                                let _e2892 = ((_e2879[0] + _e2885[0]) * 0.5f);
                                let _e2893 = ((_e2879[1] + _e2885[1]) * 0.5f);
                                let _e2894 = ((_e2879[2] + _e2885[2]) * 0.5f);
                                let _e2897 = local_2.member_2[0u];
                                let _e2903 = local_2.member_2[1u];
                                let _e2910 = ((_e2897[0] + _e2903[0]) * 0.5f);
                                let _e2911 = ((_e2897[1] + _e2903[1]) * 0.5f);
                                let _e2912 = ((_e2897[2] + _e2903[2]) * 0.5f);
                                let _e2915 = local_2.member[0u];
                                let _e2918 = local_2.member_1[0u];
                                let _e2921 = local_2.member_2[0u];
                                let _e2923 = local_2.member_3;
                                let _e2926 = local_2.member[1u];
                                let _e2929 = local_2.member_1[1u];
                                let _e2932 = local_2.member_2[1u];
                                let _e2934 = local_2.member_3;
                                local = type_41(array<array<f32, 3>, 2>(_e2915, array<f32, 3>(_e2874, _e2875, _e2876)), array<array<f32, 3>, 2>(_e2918, array<f32, 3>(_e2892, _e2893, _e2894)), array<array<f32, 3>, 2>(_e2921, array<f32, 3>(_e2910, _e2911, _e2912)), _e2923);
                                local_1 = type_41(array<array<f32, 3>, 2>(array<f32, 3>(_e2874, _e2875, _e2876), _e2926), array<array<f32, 3>, 2>(array<f32, 3>(_e2892, _e2893, _e2894), _e2929), array<array<f32, 3>, 2>(array<f32, 3>(_e2910, _e2911, _e2912), _e2932), _e2934);
                                let _e2951 = local.member_1[0u];
                                let _e2957 = local.member_2[0u];
                                let _e2963 = ((_e2951[1] * _e2957[2]) - (_e2951[2] * _e2957[1]));
                                let _e2966 = ((_e2951[2] * _e2957[0]) - (_e2951[0] * _e2957[2]));
                                let _e2969 = ((_e2951[0] * _e2957[1]) - (_e2951[1] * _e2957[0]));
                                let _e2972 = local.member_1[1u];
                                let _e2978 = local.member_2[1u];
                                let _e2984 = ((_e2972[1] * _e2978[2]) - (_e2972[2] * _e2978[1]));
                                let _e2987 = ((_e2972[2] * _e2978[0]) - (_e2972[0] * _e2978[2]));
                                let _e2990 = ((_e2972[0] * _e2978[1]) - (_e2972[1] * _e2978[0]));
                                let _e2993 = local.member_1[0u];
                                let _e2999 = local.member_2[1u];
                                let _e3014 = local.member_1[1u];
                                let _e3020 = local.member_2[0u];
                                let _e3033 = (((_e2993[1] * _e2999[2]) - (_e2993[2] * _e2999[1])) + ((_e3014[1] * _e3020[2]) - (_e3014[2] * _e3020[1])));
                                let _e3034 = (((_e2993[2] * _e2999[0]) - (_e2993[0] * _e2999[2])) + ((_e3014[2] * _e3020[0]) - (_e3014[0] * _e3020[2])));
                                let _e3035 = (((_e2993[0] * _e2999[1]) - (_e2993[1] * _e2999[0])) + ((_e3014[0] * _e3020[1]) - (_e3014[1] * _e3020[0])));
                                let _e3038 = local.member[0u];
                                let _e3049 = local.member[1u];
                                let _e3060 = local.member[0u];
                                let _e3069 = ((((_e3049[0] * _e2963) + (_e3049[1] * _e2966)) + (_e3049[2] * _e2969)) + (((_e3060[0] * _e3033) + (_e3060[1] * _e3034)) + (_e3060[2] * _e3035)));
                                let _e3072 = local.member[0u];
                                let _e3083 = local.member[1u];
                                let _e3092 = ((((_e3072[0] * _e2984) + (_e3072[1] * _e2987)) + (_e3072[2] * _e2990)) + (((_e3083[0] * _e3033) + (_e3083[1] * _e3034)) + (_e3083[2] * _e3035)));
                                let _e3095 = local.member[1u];
                                let _e3106 = local.member[0u];
                                if (_e3106[0] < 0f) {
                                    phi_5707_ = -(_e3106[0]);
                                } else {
                                    phi_5707_ = _e3106[0];
                                }
                                let _e3113 = phi_5707_;
                                if (_e3106[1] < 0f) {
                                    phi_5714_ = -(_e3106[1]);
                                } else {
                                    phi_5714_ = _e3106[1];
                                }
                                let _e3117 = phi_5714_;
                                if (_e3113 > _e3117) {
                                    phi_5719_ = _e3113;
                                } else {
                                    phi_5719_ = _e3117;
                                }
                                let _e3120 = phi_5719_;
                                if (_e3106[2] < 0f) {
                                    phi_5726_ = -(_e3106[2]);
                                } else {
                                    phi_5726_ = _e3106[2];
                                }
                                let _e3124 = phi_5726_;
                                if (_e3120 > _e3124) {
                                    phi_5731_ = _e3120;
                                } else {
                                    phi_5731_ = _e3124;
                                }
                                let _e3127 = phi_5731_;
                                let _e3130 = local.member[1u];
                                if (_e3130[0] < 0f) {
                                    phi_5744_ = -(_e3130[0]);
                                } else {
                                    phi_5744_ = _e3130[0];
                                }
                                let _e3137 = phi_5744_;
                                if (_e3130[1] < 0f) {
                                    phi_5751_ = -(_e3130[1]);
                                } else {
                                    phi_5751_ = _e3130[1];
                                }
                                let _e3141 = phi_5751_;
                                if (_e3137 > _e3141) {
                                    phi_5756_ = _e3137;
                                } else {
                                    phi_5756_ = _e3141;
                                }
                                let _e3144 = phi_5756_;
                                if (_e3130[2] < 0f) {
                                    phi_5763_ = -(_e3130[2]);
                                } else {
                                    phi_5763_ = _e3130[2];
                                }
                                let _e3148 = phi_5763_;
                                if (_e3144 > _e3148) {
                                    phi_5768_ = _e3144;
                                } else {
                                    phi_5768_ = _e3148;
                                }
                                let _e3151 = phi_5768_;
                                if (_e3127 > _e3151) {
                                    phi_5773_ = _e3127;
                                } else {
                                    phi_5773_ = _e3151;
                                }
                                let _e3154 = phi_5773_;
                                let _e3156 = local.member_3;
                                let _e3157 = (_e3154 + _e3156);
                                let _e3160 = local.member_1[0u];
                                if (_e3160[0] < 0f) {
                                    phi_5790_ = -(_e3160[0]);
                                } else {
                                    phi_5790_ = _e3160[0];
                                }
                                let _e3167 = phi_5790_;
                                if (_e3160[1] < 0f) {
                                    phi_5797_ = -(_e3160[1]);
                                } else {
                                    phi_5797_ = _e3160[1];
                                }
                                let _e3171 = phi_5797_;
                                if (_e3167 > _e3171) {
                                    phi_5802_ = _e3167;
                                } else {
                                    phi_5802_ = _e3171;
                                }
                                let _e3174 = phi_5802_;
                                if (_e3160[2] < 0f) {
                                    phi_5809_ = -(_e3160[2]);
                                } else {
                                    phi_5809_ = _e3160[2];
                                }
                                let _e3178 = phi_5809_;
                                if (_e3174 > _e3178) {
                                    phi_5814_ = _e3174;
                                } else {
                                    phi_5814_ = _e3178;
                                }
                                let _e3181 = phi_5814_;
                                let _e3184 = local.member_1[1u];
                                if (_e3184[0] < 0f) {
                                    phi_5828_ = -(_e3184[0]);
                                } else {
                                    phi_5828_ = _e3184[0];
                                }
                                let _e3191 = phi_5828_;
                                if (_e3184[1] < 0f) {
                                    phi_5835_ = -(_e3184[1]);
                                } else {
                                    phi_5835_ = _e3184[1];
                                }
                                let _e3195 = phi_5835_;
                                if (_e3191 > _e3195) {
                                    phi_5840_ = _e3191;
                                } else {
                                    phi_5840_ = _e3195;
                                }
                                let _e3198 = phi_5840_;
                                if (_e3184[2] < 0f) {
                                    phi_5847_ = -(_e3184[2]);
                                } else {
                                    phi_5847_ = _e3184[2];
                                }
                                let _e3202 = phi_5847_;
                                if (_e3198 > _e3202) {
                                    phi_5852_ = _e3198;
                                } else {
                                    phi_5852_ = _e3202;
                                }
                                let _e3205 = phi_5852_;
                                if (_e3181 > _e3205) {
                                    phi_5857_ = _e3181;
                                } else {
                                    phi_5857_ = _e3205;
                                }
                                let _e3208 = phi_5857_;
                                let _e3210 = local.member_3;
                                let _e3211 = (_e3208 + _e3210);
                                let _e3214 = local.member_2[0u];
                                if (_e3214[0] < 0f) {
                                    phi_5874_ = -(_e3214[0]);
                                } else {
                                    phi_5874_ = _e3214[0];
                                }
                                let _e3221 = phi_5874_;
                                if (_e3214[1] < 0f) {
                                    phi_5881_ = -(_e3214[1]);
                                } else {
                                    phi_5881_ = _e3214[1];
                                }
                                let _e3225 = phi_5881_;
                                if (_e3221 > _e3225) {
                                    phi_5886_ = _e3221;
                                } else {
                                    phi_5886_ = _e3225;
                                }
                                let _e3228 = phi_5886_;
                                if (_e3214[2] < 0f) {
                                    phi_5893_ = -(_e3214[2]);
                                } else {
                                    phi_5893_ = _e3214[2];
                                }
                                let _e3232 = phi_5893_;
                                if (_e3228 > _e3232) {
                                    phi_5898_ = _e3228;
                                } else {
                                    phi_5898_ = _e3232;
                                }
                                let _e3235 = phi_5898_;
                                let _e3238 = local.member_2[1u];
                                if (_e3238[0] < 0f) {
                                    phi_5912_ = -(_e3238[0]);
                                } else {
                                    phi_5912_ = _e3238[0];
                                }
                                let _e3245 = phi_5912_;
                                if (_e3238[1] < 0f) {
                                    phi_5919_ = -(_e3238[1]);
                                } else {
                                    phi_5919_ = _e3238[1];
                                }
                                let _e3249 = phi_5919_;
                                if (_e3245 > _e3249) {
                                    phi_5924_ = _e3245;
                                } else {
                                    phi_5924_ = _e3249;
                                }
                                let _e3252 = phi_5924_;
                                if (_e3238[2] < 0f) {
                                    phi_5931_ = -(_e3238[2]);
                                } else {
                                    phi_5931_ = _e3238[2];
                                }
                                let _e3256 = phi_5931_;
                                if (_e3252 > _e3256) {
                                    phi_5936_ = _e3252;
                                } else {
                                    phi_5936_ = _e3256;
                                }
                                let _e3259 = phi_5936_;
                                if (_e3235 > _e3259) {
                                    phi_5941_ = _e3235;
                                } else {
                                    phi_5941_ = _e3259;
                                }
                                let _e3262 = phi_5941_;
                                let _e3264 = local.member_3;
                                let _e3265 = (_e3262 + _e3264);
                                let _e3267 = ((_e3211 * 8f) * _e3265);
                                let _e3274 = local.member_3;
                                if (_e2963 < 0f) {
                                    phi_5972_ = -(_e2963);
                                } else {
                                    phi_5972_ = _e2963;
                                }
                                let _e3291 = phi_5972_;
                                if (_e2966 < 0f) {
                                    phi_5978_ = -(_e2966);
                                } else {
                                    phi_5978_ = _e2966;
                                }
                                let _e3295 = phi_5978_;
                                if (_e2969 < 0f) {
                                    phi_5985_ = -(_e2969);
                                } else {
                                    phi_5985_ = _e2969;
                                }
                                let _e3300 = phi_5985_;
                                let _e3301 = ((_e3291 + _e3295) + _e3300);
                                if (_e2984 < 0f) {
                                    phi_5992_ = -(_e2984);
                                } else {
                                    phi_5992_ = _e2984;
                                }
                                let _e3305 = phi_5992_;
                                if (_e2987 < 0f) {
                                    phi_5998_ = -(_e2987);
                                } else {
                                    phi_5998_ = _e2987;
                                }
                                let _e3309 = phi_5998_;
                                if (_e2990 < 0f) {
                                    phi_6005_ = -(_e2990);
                                } else {
                                    phi_6005_ = _e2990;
                                }
                                let _e3314 = phi_6005_;
                                let _e3315 = ((_e3305 + _e3309) + _e3314);
                                if (_e3301 > _e3315) {
                                    phi_6011_ = _e3301;
                                } else {
                                    phi_6011_ = _e3315;
                                }
                                let _e3318 = phi_6011_;
                                if (_e3033 < 0f) {
                                    phi_6017_ = -(_e3033);
                                } else {
                                    phi_6017_ = _e3033;
                                }
                                let _e3322 = phi_6017_;
                                if (_e3034 < 0f) {
                                    phi_6023_ = -(_e3034);
                                } else {
                                    phi_6023_ = _e3034;
                                }
                                let _e3326 = phi_6023_;
                                if (_e3035 < 0f) {
                                    phi_6030_ = -(_e3035);
                                } else {
                                    phi_6030_ = _e3035;
                                }
                                let _e3331 = phi_6030_;
                                let _e3333 = (((_e3322 + _e3326) + _e3331) * 0.5f);
                                if (_e3318 > _e3333) {
                                    phi_6037_ = _e3318;
                                } else {
                                    phi_6037_ = _e3333;
                                }
                                let _e3336 = phi_6037_;
                                let _e3341 = local.member_3;
                                let _e3354 = ((((_e3038[0] * _e2963) + (_e3038[1] * _e2966)) + (_e3038[2] * _e2969)) * 3f);
                                let _e3355 = ((((_e3095[0] * _e2984) + (_e3095[1] * _e2987)) + (_e3095[2] * _e2990)) * 3f);
                                if (_e3354 < _e3355) {
                                    phi_6061_ = _e3354;
                                } else {
                                    phi_6061_ = _e3355;
                                }
                                let _e3358 = phi_6061_;
                                if (_e3069 < _e3092) {
                                    phi_6066_ = _e3069;
                                } else {
                                    phi_6066_ = _e3092;
                                }
                                let _e3361 = phi_6066_;
                                if (_e3358 < _e3361) {
                                    phi_6071_ = _e3358;
                                } else {
                                    phi_6071_ = _e3361;
                                }
                                let _e3364 = phi_6071_;
                                if (_e3354 > _e3355) {
                                    phi_6076_ = _e3354;
                                } else {
                                    phi_6076_ = _e3355;
                                }
                                let _e3367 = phi_6076_;
                                if (_e3069 > _e3092) {
                                    phi_6081_ = _e3069;
                                } else {
                                    phi_6081_ = _e3092;
                                }
                                let _e3370 = phi_6081_;
                                if (_e3367 > _e3370) {
                                    phi_6086_ = _e3367;
                                } else {
                                    phi_6086_ = _e3370;
                                }
                                let _e3373 = phi_6086_;
                                let _e3378 = -(_e3373);
                                if (_e3364 > _e3378) {
                                    phi_6096_ = _e3364;
                                } else {
                                    phi_6096_ = _e3378;
                                }
                                let _e3381 = phi_6096_;
                                let _e3383 = ((_e3381 - ((((((_e3157 * 8f) * _e3267) * (0.000000059604645f * (524f / 64f))) + ((_e3274 * 19f) * ((_e3157 * (_e3211 + _e3265)) + (_e3211 * _e3265)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3157) * ((1f + _e3211) * (1f + _e3265))))) + ((_e1846 * (((_e3336 + (_e3267 * (0.000000059604645f * 8f))) + ((_e3341 * 6f) * (_e3211 + _e3265))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3211) * (1f + _e3265))))) * (3f * 1.0001f)))) > 0f);
                                if _e3383 {
                                    phi_7065_ = _e3383;
                                } else {
                                    let _e3386 = local.member_1[0u];
                                    let _e3392 = local.member_1[1u];
                                    let _e3396 = (_e3386[0] + _e3392[0]);
                                    let _e3397 = (_e3386[1] + _e3392[1]);
                                    let _e3398 = (_e3386[2] + _e3392[2]);
                                    let _e3401 = local.member_2[0u];
                                    let _e3407 = local.member_2[1u];
                                    let _e3411 = (_e3401[0] + _e3407[0]);
                                    let _e3412 = (_e3401[1] + _e3407[1]);
                                    let _e3413 = (_e3401[2] + _e3407[2]);
                                    let _e3416 = ((_e3397 * _e3413) - (_e3398 * _e3412));
                                    let _e3419 = ((_e3398 * _e3411) - (_e3396 * _e3413));
                                    let _e3422 = ((_e3396 * _e3412) - (_e3397 * _e3411));
                                    let _e3425 = local.member[0u];
                                    let _e3431 = local.member_1[0u];
                                    let _e3437 = local.member_2[0u];
                                    let _e3441 = (_e3425[0] - _e3431[0]);
                                    let _e3442 = (_e3425[1] - _e3431[1]);
                                    let _e3443 = (_e3425[2] - _e3431[2]);
                                    let _e3444 = (_e3441 - _e3437[0]);
                                    let _e3445 = (_e3442 - _e3437[1]);
                                    let _e3446 = (_e3443 - _e3437[2]);
                                    let _e3447 = (_e3425[0] - _e3437[0]);
                                    let _e3448 = (_e3425[1] - _e3437[1]);
                                    let _e3449 = (_e3425[2] - _e3437[2]);
                                    let _e3452 = local.member[1u];
                                    let _e3458 = local.member_1[1u];
                                    let _e3464 = local.member_2[1u];
                                    let _e3468 = (_e3452[0] - _e3458[0]);
                                    let _e3469 = (_e3452[1] - _e3458[1]);
                                    let _e3470 = (_e3452[2] - _e3458[2]);
                                    let _e3471 = (_e3468 - _e3464[0]);
                                    let _e3472 = (_e3469 - _e3464[1]);
                                    let _e3473 = (_e3470 - _e3464[2]);
                                    let _e3474 = (_e3452[0] - _e3464[0]);
                                    let _e3475 = (_e3452[1] - _e3464[1]);
                                    let _e3476 = (_e3452[2] - _e3464[2]);
                                    let _e3479 = local.member[0u];
                                    if (_e3479[0] < 0f) {
                                        phi_6299_ = -(_e3479[0]);
                                    } else {
                                        phi_6299_ = _e3479[0];
                                    }
                                    let _e3486 = phi_6299_;
                                    if (_e3479[1] < 0f) {
                                        phi_6306_ = -(_e3479[1]);
                                    } else {
                                        phi_6306_ = _e3479[1];
                                    }
                                    let _e3490 = phi_6306_;
                                    if (_e3486 > _e3490) {
                                        phi_6311_ = _e3486;
                                    } else {
                                        phi_6311_ = _e3490;
                                    }
                                    let _e3493 = phi_6311_;
                                    if (_e3479[2] < 0f) {
                                        phi_6318_ = -(_e3479[2]);
                                    } else {
                                        phi_6318_ = _e3479[2];
                                    }
                                    let _e3497 = phi_6318_;
                                    if (_e3493 > _e3497) {
                                        phi_6323_ = _e3493;
                                    } else {
                                        phi_6323_ = _e3497;
                                    }
                                    let _e3500 = phi_6323_;
                                    let _e3503 = local.member[1u];
                                    if (_e3503[0] < 0f) {
                                        phi_6336_ = -(_e3503[0]);
                                    } else {
                                        phi_6336_ = _e3503[0];
                                    }
                                    let _e3510 = phi_6336_;
                                    if (_e3503[1] < 0f) {
                                        phi_6343_ = -(_e3503[1]);
                                    } else {
                                        phi_6343_ = _e3503[1];
                                    }
                                    let _e3514 = phi_6343_;
                                    if (_e3510 > _e3514) {
                                        phi_6348_ = _e3510;
                                    } else {
                                        phi_6348_ = _e3514;
                                    }
                                    let _e3517 = phi_6348_;
                                    if (_e3503[2] < 0f) {
                                        phi_6355_ = -(_e3503[2]);
                                    } else {
                                        phi_6355_ = _e3503[2];
                                    }
                                    let _e3521 = phi_6355_;
                                    if (_e3517 > _e3521) {
                                        phi_6360_ = _e3517;
                                    } else {
                                        phi_6360_ = _e3521;
                                    }
                                    let _e3524 = phi_6360_;
                                    if (_e3500 > _e3524) {
                                        phi_6365_ = _e3500;
                                    } else {
                                        phi_6365_ = _e3524;
                                    }
                                    let _e3527 = phi_6365_;
                                    let _e3529 = local.member_3;
                                    let _e3533 = local.member_1[0u];
                                    if (_e3533[0] < 0f) {
                                        phi_6382_ = -(_e3533[0]);
                                    } else {
                                        phi_6382_ = _e3533[0];
                                    }
                                    let _e3540 = phi_6382_;
                                    if (_e3533[1] < 0f) {
                                        phi_6389_ = -(_e3533[1]);
                                    } else {
                                        phi_6389_ = _e3533[1];
                                    }
                                    let _e3544 = phi_6389_;
                                    if (_e3540 > _e3544) {
                                        phi_6394_ = _e3540;
                                    } else {
                                        phi_6394_ = _e3544;
                                    }
                                    let _e3547 = phi_6394_;
                                    if (_e3533[2] < 0f) {
                                        phi_6401_ = -(_e3533[2]);
                                    } else {
                                        phi_6401_ = _e3533[2];
                                    }
                                    let _e3551 = phi_6401_;
                                    if (_e3547 > _e3551) {
                                        phi_6406_ = _e3547;
                                    } else {
                                        phi_6406_ = _e3551;
                                    }
                                    let _e3554 = phi_6406_;
                                    let _e3557 = local.member_1[1u];
                                    if (_e3557[0] < 0f) {
                                        phi_6420_ = -(_e3557[0]);
                                    } else {
                                        phi_6420_ = _e3557[0];
                                    }
                                    let _e3564 = phi_6420_;
                                    if (_e3557[1] < 0f) {
                                        phi_6427_ = -(_e3557[1]);
                                    } else {
                                        phi_6427_ = _e3557[1];
                                    }
                                    let _e3568 = phi_6427_;
                                    if (_e3564 > _e3568) {
                                        phi_6432_ = _e3564;
                                    } else {
                                        phi_6432_ = _e3568;
                                    }
                                    let _e3571 = phi_6432_;
                                    if (_e3557[2] < 0f) {
                                        phi_6439_ = -(_e3557[2]);
                                    } else {
                                        phi_6439_ = _e3557[2];
                                    }
                                    let _e3575 = phi_6439_;
                                    if (_e3571 > _e3575) {
                                        phi_6444_ = _e3571;
                                    } else {
                                        phi_6444_ = _e3575;
                                    }
                                    let _e3578 = phi_6444_;
                                    if (_e3554 > _e3578) {
                                        phi_6449_ = _e3554;
                                    } else {
                                        phi_6449_ = _e3578;
                                    }
                                    let _e3581 = phi_6449_;
                                    let _e3583 = local.member_3;
                                    let _e3587 = local.member_2[0u];
                                    if (_e3587[0] < 0f) {
                                        phi_6466_ = -(_e3587[0]);
                                    } else {
                                        phi_6466_ = _e3587[0];
                                    }
                                    let _e3594 = phi_6466_;
                                    if (_e3587[1] < 0f) {
                                        phi_6473_ = -(_e3587[1]);
                                    } else {
                                        phi_6473_ = _e3587[1];
                                    }
                                    let _e3598 = phi_6473_;
                                    if (_e3594 > _e3598) {
                                        phi_6478_ = _e3594;
                                    } else {
                                        phi_6478_ = _e3598;
                                    }
                                    let _e3601 = phi_6478_;
                                    if (_e3587[2] < 0f) {
                                        phi_6485_ = -(_e3587[2]);
                                    } else {
                                        phi_6485_ = _e3587[2];
                                    }
                                    let _e3605 = phi_6485_;
                                    if (_e3601 > _e3605) {
                                        phi_6490_ = _e3601;
                                    } else {
                                        phi_6490_ = _e3605;
                                    }
                                    let _e3608 = phi_6490_;
                                    let _e3611 = local.member_2[1u];
                                    if (_e3611[0] < 0f) {
                                        phi_6504_ = -(_e3611[0]);
                                    } else {
                                        phi_6504_ = _e3611[0];
                                    }
                                    let _e3618 = phi_6504_;
                                    if (_e3611[1] < 0f) {
                                        phi_6511_ = -(_e3611[1]);
                                    } else {
                                        phi_6511_ = _e3611[1];
                                    }
                                    let _e3622 = phi_6511_;
                                    if (_e3618 > _e3622) {
                                        phi_6516_ = _e3618;
                                    } else {
                                        phi_6516_ = _e3622;
                                    }
                                    let _e3625 = phi_6516_;
                                    if (_e3611[2] < 0f) {
                                        phi_6523_ = -(_e3611[2]);
                                    } else {
                                        phi_6523_ = _e3611[2];
                                    }
                                    let _e3629 = phi_6523_;
                                    if (_e3625 > _e3629) {
                                        phi_6528_ = _e3625;
                                    } else {
                                        phi_6528_ = _e3629;
                                    }
                                    let _e3632 = phi_6528_;
                                    if (_e3608 > _e3632) {
                                        phi_6533_ = _e3608;
                                    } else {
                                        phi_6533_ = _e3632;
                                    }
                                    let _e3635 = phi_6533_;
                                    let _e3637 = local.member_3;
                                    let _e3641 = ((((_e3527 + _e3529) + (_e3581 + _e3583)) + (_e3635 + _e3637)) * 2f);
                                    let _e3644 = local.member_3;
                                    let _e3648 = (((_e1846 * 1.0001f) + (_e3644 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3651 = ((_e3419 * _e3398) - (_e3422 * _e3397));
                                    let _e3654 = ((_e3422 * _e3396) - (_e3416 * _e3398));
                                    let _e3657 = ((_e3416 * _e3397) - (_e3419 * _e3396));
                                    let _e3662 = (((_e3651 * _e3425[0]) + (_e3654 * _e3425[1])) + (_e3657 * _e3425[2]));
                                    let _e3667 = (((_e3651 * _e3441) + (_e3654 * _e3442)) + (_e3657 * _e3443));
                                    let _e3672 = (((_e3651 * _e3447) + (_e3654 * _e3448)) + (_e3657 * _e3449));
                                    let _e3677 = (((_e3651 * _e3444) + (_e3654 * _e3445)) + (_e3657 * _e3446));
                                    let _e3682 = (((_e3651 * _e3452[0]) + (_e3654 * _e3452[1])) + (_e3657 * _e3452[2]));
                                    let _e3687 = (((_e3651 * _e3468) + (_e3654 * _e3469)) + (_e3657 * _e3470));
                                    let _e3692 = (((_e3651 * _e3474) + (_e3654 * _e3475)) + (_e3657 * _e3476));
                                    let _e3697 = (((_e3651 * _e3471) + (_e3654 * _e3472)) + (_e3657 * _e3473));
                                    if (_e3662 < _e3667) {
                                        phi_6612_ = _e3662;
                                    } else {
                                        phi_6612_ = _e3667;
                                    }
                                    let _e3700 = phi_6612_;
                                    if (_e3672 < _e3677) {
                                        phi_6617_ = _e3672;
                                    } else {
                                        phi_6617_ = _e3677;
                                    }
                                    let _e3703 = phi_6617_;
                                    if (_e3700 < _e3703) {
                                        phi_6622_ = _e3700;
                                    } else {
                                        phi_6622_ = _e3703;
                                    }
                                    let _e3706 = phi_6622_;
                                    if (_e3682 < _e3687) {
                                        phi_6627_ = _e3682;
                                    } else {
                                        phi_6627_ = _e3687;
                                    }
                                    let _e3709 = phi_6627_;
                                    if (_e3692 < _e3697) {
                                        phi_6632_ = _e3692;
                                    } else {
                                        phi_6632_ = _e3697;
                                    }
                                    let _e3712 = phi_6632_;
                                    if (_e3709 < _e3712) {
                                        phi_6637_ = _e3709;
                                    } else {
                                        phi_6637_ = _e3712;
                                    }
                                    let _e3715 = phi_6637_;
                                    if (_e3706 < _e3715) {
                                        phi_6642_ = _e3706;
                                    } else {
                                        phi_6642_ = _e3715;
                                    }
                                    let _e3718 = phi_6642_;
                                    if (_e3662 > _e3667) {
                                        phi_6647_ = _e3662;
                                    } else {
                                        phi_6647_ = _e3667;
                                    }
                                    let _e3721 = phi_6647_;
                                    if (_e3672 > _e3677) {
                                        phi_6652_ = _e3672;
                                    } else {
                                        phi_6652_ = _e3677;
                                    }
                                    let _e3724 = phi_6652_;
                                    if (_e3721 > _e3724) {
                                        phi_6657_ = _e3721;
                                    } else {
                                        phi_6657_ = _e3724;
                                    }
                                    let _e3727 = phi_6657_;
                                    if (_e3682 > _e3687) {
                                        phi_6662_ = _e3682;
                                    } else {
                                        phi_6662_ = _e3687;
                                    }
                                    let _e3730 = phi_6662_;
                                    if (_e3692 > _e3697) {
                                        phi_6667_ = _e3692;
                                    } else {
                                        phi_6667_ = _e3697;
                                    }
                                    let _e3733 = phi_6667_;
                                    if (_e3730 > _e3733) {
                                        phi_6672_ = _e3730;
                                    } else {
                                        phi_6672_ = _e3733;
                                    }
                                    let _e3736 = phi_6672_;
                                    if (_e3727 > _e3736) {
                                        phi_6677_ = _e3727;
                                    } else {
                                        phi_6677_ = _e3736;
                                    }
                                    let _e3739 = phi_6677_;
                                    if (_e3651 < 0f) {
                                        phi_6683_ = -(_e3651);
                                    } else {
                                        phi_6683_ = _e3651;
                                    }
                                    let _e3743 = phi_6683_;
                                    if (_e3654 < 0f) {
                                        phi_6689_ = -(_e3654);
                                    } else {
                                        phi_6689_ = _e3654;
                                    }
                                    let _e3747 = phi_6689_;
                                    if (_e3657 < 0f) {
                                        phi_6696_ = -(_e3657);
                                    } else {
                                        phi_6696_ = _e3657;
                                    }
                                    let _e3752 = phi_6696_;
                                    let _e3753 = ((_e3743 + _e3747) + _e3752);
                                    let _e3758 = -(_e3739);
                                    if (_e3718 > _e3758) {
                                        phi_6707_ = _e3718;
                                    } else {
                                        phi_6707_ = _e3758;
                                    }
                                    let _e3761 = phi_6707_;
                                    let _e3766 = (((_e3761 - ((_e3753 * _e3641) * (0.000000059604645f * (17f / 2f)))) - (_e3753 * _e3648)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3769 = ((_e3419 * _e3413) - (_e3422 * _e3412));
                                    let _e3772 = ((_e3422 * _e3411) - (_e3416 * _e3413));
                                    let _e3775 = ((_e3416 * _e3412) - (_e3419 * _e3411));
                                    let _e3780 = (((_e3769 * _e3425[0]) + (_e3772 * _e3425[1])) + (_e3775 * _e3425[2]));
                                    let _e3785 = (((_e3769 * _e3441) + (_e3772 * _e3442)) + (_e3775 * _e3443));
                                    let _e3790 = (((_e3769 * _e3447) + (_e3772 * _e3448)) + (_e3775 * _e3449));
                                    let _e3795 = (((_e3769 * _e3444) + (_e3772 * _e3445)) + (_e3775 * _e3446));
                                    let _e3800 = (((_e3769 * _e3452[0]) + (_e3772 * _e3452[1])) + (_e3775 * _e3452[2]));
                                    let _e3805 = (((_e3769 * _e3468) + (_e3772 * _e3469)) + (_e3775 * _e3470));
                                    let _e3810 = (((_e3769 * _e3474) + (_e3772 * _e3475)) + (_e3775 * _e3476));
                                    let _e3815 = (((_e3769 * _e3471) + (_e3772 * _e3472)) + (_e3775 * _e3473));
                                    if (_e3780 < _e3785) {
                                        phi_6778_ = _e3780;
                                    } else {
                                        phi_6778_ = _e3785;
                                    }
                                    let _e3818 = phi_6778_;
                                    if (_e3790 < _e3795) {
                                        phi_6783_ = _e3790;
                                    } else {
                                        phi_6783_ = _e3795;
                                    }
                                    let _e3821 = phi_6783_;
                                    if (_e3818 < _e3821) {
                                        phi_6788_ = _e3818;
                                    } else {
                                        phi_6788_ = _e3821;
                                    }
                                    let _e3824 = phi_6788_;
                                    if (_e3800 < _e3805) {
                                        phi_6793_ = _e3800;
                                    } else {
                                        phi_6793_ = _e3805;
                                    }
                                    let _e3827 = phi_6793_;
                                    if (_e3810 < _e3815) {
                                        phi_6798_ = _e3810;
                                    } else {
                                        phi_6798_ = _e3815;
                                    }
                                    let _e3830 = phi_6798_;
                                    if (_e3827 < _e3830) {
                                        phi_6803_ = _e3827;
                                    } else {
                                        phi_6803_ = _e3830;
                                    }
                                    let _e3833 = phi_6803_;
                                    if (_e3824 < _e3833) {
                                        phi_6808_ = _e3824;
                                    } else {
                                        phi_6808_ = _e3833;
                                    }
                                    let _e3836 = phi_6808_;
                                    if (_e3780 > _e3785) {
                                        phi_6813_ = _e3780;
                                    } else {
                                        phi_6813_ = _e3785;
                                    }
                                    let _e3839 = phi_6813_;
                                    if (_e3790 > _e3795) {
                                        phi_6818_ = _e3790;
                                    } else {
                                        phi_6818_ = _e3795;
                                    }
                                    let _e3842 = phi_6818_;
                                    if (_e3839 > _e3842) {
                                        phi_6823_ = _e3839;
                                    } else {
                                        phi_6823_ = _e3842;
                                    }
                                    let _e3845 = phi_6823_;
                                    if (_e3800 > _e3805) {
                                        phi_6828_ = _e3800;
                                    } else {
                                        phi_6828_ = _e3805;
                                    }
                                    let _e3848 = phi_6828_;
                                    if (_e3810 > _e3815) {
                                        phi_6833_ = _e3810;
                                    } else {
                                        phi_6833_ = _e3815;
                                    }
                                    let _e3851 = phi_6833_;
                                    if (_e3848 > _e3851) {
                                        phi_6838_ = _e3848;
                                    } else {
                                        phi_6838_ = _e3851;
                                    }
                                    let _e3854 = phi_6838_;
                                    if (_e3845 > _e3854) {
                                        phi_6843_ = _e3845;
                                    } else {
                                        phi_6843_ = _e3854;
                                    }
                                    let _e3857 = phi_6843_;
                                    if (_e3769 < 0f) {
                                        phi_6849_ = -(_e3769);
                                    } else {
                                        phi_6849_ = _e3769;
                                    }
                                    let _e3861 = phi_6849_;
                                    if (_e3772 < 0f) {
                                        phi_6855_ = -(_e3772);
                                    } else {
                                        phi_6855_ = _e3772;
                                    }
                                    let _e3865 = phi_6855_;
                                    if (_e3775 < 0f) {
                                        phi_6862_ = -(_e3775);
                                    } else {
                                        phi_6862_ = _e3775;
                                    }
                                    let _e3870 = phi_6862_;
                                    let _e3871 = ((_e3861 + _e3865) + _e3870);
                                    let _e3876 = -(_e3857);
                                    if (_e3836 > _e3876) {
                                        phi_6873_ = _e3836;
                                    } else {
                                        phi_6873_ = _e3876;
                                    }
                                    let _e3879 = phi_6873_;
                                    let _e3884 = (((_e3879 - ((_e3871 * _e3641) * (0.000000059604645f * (17f / 2f)))) - (_e3871 * _e3648)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3766 > _e3884) {
                                        phi_6883_ = _e3766;
                                    } else {
                                        phi_6883_ = _e3884;
                                    }
                                    let _e3887 = phi_6883_;
                                    phi_7065_ = (_e3383 || (_e3887 > 0f));
                                }
                                let _e3891 = phi_7065_;
                                if _e3891 {
                                    let _e3894 = local_1.member_1[0u];
                                    let _e3900 = local_1.member_2[0u];
                                    let _e3906 = ((_e3894[1] * _e3900[2]) - (_e3894[2] * _e3900[1]));
                                    let _e3909 = ((_e3894[2] * _e3900[0]) - (_e3894[0] * _e3900[2]));
                                    let _e3912 = ((_e3894[0] * _e3900[1]) - (_e3894[1] * _e3900[0]));
                                    let _e3915 = local_1.member_1[1u];
                                    let _e3921 = local_1.member_2[1u];
                                    let _e3927 = ((_e3915[1] * _e3921[2]) - (_e3915[2] * _e3921[1]));
                                    let _e3930 = ((_e3915[2] * _e3921[0]) - (_e3915[0] * _e3921[2]));
                                    let _e3933 = ((_e3915[0] * _e3921[1]) - (_e3915[1] * _e3921[0]));
                                    let _e3936 = local_1.member_1[0u];
                                    let _e3942 = local_1.member_2[1u];
                                    let _e3957 = local_1.member_1[1u];
                                    let _e3963 = local_1.member_2[0u];
                                    let _e3976 = (((_e3936[1] * _e3942[2]) - (_e3936[2] * _e3942[1])) + ((_e3957[1] * _e3963[2]) - (_e3957[2] * _e3963[1])));
                                    let _e3977 = (((_e3936[2] * _e3942[0]) - (_e3936[0] * _e3942[2])) + ((_e3957[2] * _e3963[0]) - (_e3957[0] * _e3963[2])));
                                    let _e3978 = (((_e3936[0] * _e3942[1]) - (_e3936[1] * _e3942[0])) + ((_e3957[0] * _e3963[1]) - (_e3957[1] * _e3963[0])));
                                    let _e3981 = local_1.member[0u];
                                    let _e3992 = local_1.member[1u];
                                    let _e4003 = local_1.member[0u];
                                    let _e4012 = ((((_e3992[0] * _e3906) + (_e3992[1] * _e3909)) + (_e3992[2] * _e3912)) + (((_e4003[0] * _e3976) + (_e4003[1] * _e3977)) + (_e4003[2] * _e3978)));
                                    let _e4015 = local_1.member[0u];
                                    let _e4026 = local_1.member[1u];
                                    let _e4035 = ((((_e4015[0] * _e3927) + (_e4015[1] * _e3930)) + (_e4015[2] * _e3933)) + (((_e4026[0] * _e3976) + (_e4026[1] * _e3977)) + (_e4026[2] * _e3978)));
                                    let _e4038 = local_1.member[1u];
                                    let _e4049 = local_1.member[0u];
                                    if (_e4049[0] < 0f) {
                                        phi_7310_ = -(_e4049[0]);
                                    } else {
                                        phi_7310_ = _e4049[0];
                                    }
                                    let _e4056 = phi_7310_;
                                    if (_e4049[1] < 0f) {
                                        phi_7317_ = -(_e4049[1]);
                                    } else {
                                        phi_7317_ = _e4049[1];
                                    }
                                    let _e4060 = phi_7317_;
                                    if (_e4056 > _e4060) {
                                        phi_7322_ = _e4056;
                                    } else {
                                        phi_7322_ = _e4060;
                                    }
                                    let _e4063 = phi_7322_;
                                    if (_e4049[2] < 0f) {
                                        phi_7329_ = -(_e4049[2]);
                                    } else {
                                        phi_7329_ = _e4049[2];
                                    }
                                    let _e4067 = phi_7329_;
                                    if (_e4063 > _e4067) {
                                        phi_7334_ = _e4063;
                                    } else {
                                        phi_7334_ = _e4067;
                                    }
                                    let _e4070 = phi_7334_;
                                    let _e4073 = local_1.member[1u];
                                    if (_e4073[0] < 0f) {
                                        phi_7347_ = -(_e4073[0]);
                                    } else {
                                        phi_7347_ = _e4073[0];
                                    }
                                    let _e4080 = phi_7347_;
                                    if (_e4073[1] < 0f) {
                                        phi_7354_ = -(_e4073[1]);
                                    } else {
                                        phi_7354_ = _e4073[1];
                                    }
                                    let _e4084 = phi_7354_;
                                    if (_e4080 > _e4084) {
                                        phi_7359_ = _e4080;
                                    } else {
                                        phi_7359_ = _e4084;
                                    }
                                    let _e4087 = phi_7359_;
                                    if (_e4073[2] < 0f) {
                                        phi_7366_ = -(_e4073[2]);
                                    } else {
                                        phi_7366_ = _e4073[2];
                                    }
                                    let _e4091 = phi_7366_;
                                    if (_e4087 > _e4091) {
                                        phi_7371_ = _e4087;
                                    } else {
                                        phi_7371_ = _e4091;
                                    }
                                    let _e4094 = phi_7371_;
                                    if (_e4070 > _e4094) {
                                        phi_7376_ = _e4070;
                                    } else {
                                        phi_7376_ = _e4094;
                                    }
                                    let _e4097 = phi_7376_;
                                    let _e4099 = local_1.member_3;
                                    let _e4100 = (_e4097 + _e4099);
                                    let _e4103 = local_1.member_1[0u];
                                    if (_e4103[0] < 0f) {
                                        phi_7393_ = -(_e4103[0]);
                                    } else {
                                        phi_7393_ = _e4103[0];
                                    }
                                    let _e4110 = phi_7393_;
                                    if (_e4103[1] < 0f) {
                                        phi_7400_ = -(_e4103[1]);
                                    } else {
                                        phi_7400_ = _e4103[1];
                                    }
                                    let _e4114 = phi_7400_;
                                    if (_e4110 > _e4114) {
                                        phi_7405_ = _e4110;
                                    } else {
                                        phi_7405_ = _e4114;
                                    }
                                    let _e4117 = phi_7405_;
                                    if (_e4103[2] < 0f) {
                                        phi_7412_ = -(_e4103[2]);
                                    } else {
                                        phi_7412_ = _e4103[2];
                                    }
                                    let _e4121 = phi_7412_;
                                    if (_e4117 > _e4121) {
                                        phi_7417_ = _e4117;
                                    } else {
                                        phi_7417_ = _e4121;
                                    }
                                    let _e4124 = phi_7417_;
                                    let _e4127 = local_1.member_1[1u];
                                    if (_e4127[0] < 0f) {
                                        phi_7431_ = -(_e4127[0]);
                                    } else {
                                        phi_7431_ = _e4127[0];
                                    }
                                    let _e4134 = phi_7431_;
                                    if (_e4127[1] < 0f) {
                                        phi_7438_ = -(_e4127[1]);
                                    } else {
                                        phi_7438_ = _e4127[1];
                                    }
                                    let _e4138 = phi_7438_;
                                    if (_e4134 > _e4138) {
                                        phi_7443_ = _e4134;
                                    } else {
                                        phi_7443_ = _e4138;
                                    }
                                    let _e4141 = phi_7443_;
                                    if (_e4127[2] < 0f) {
                                        phi_7450_ = -(_e4127[2]);
                                    } else {
                                        phi_7450_ = _e4127[2];
                                    }
                                    let _e4145 = phi_7450_;
                                    if (_e4141 > _e4145) {
                                        phi_7455_ = _e4141;
                                    } else {
                                        phi_7455_ = _e4145;
                                    }
                                    let _e4148 = phi_7455_;
                                    if (_e4124 > _e4148) {
                                        phi_7460_ = _e4124;
                                    } else {
                                        phi_7460_ = _e4148;
                                    }
                                    let _e4151 = phi_7460_;
                                    let _e4153 = local_1.member_3;
                                    let _e4154 = (_e4151 + _e4153);
                                    let _e4157 = local_1.member_2[0u];
                                    if (_e4157[0] < 0f) {
                                        phi_7477_ = -(_e4157[0]);
                                    } else {
                                        phi_7477_ = _e4157[0];
                                    }
                                    let _e4164 = phi_7477_;
                                    if (_e4157[1] < 0f) {
                                        phi_7484_ = -(_e4157[1]);
                                    } else {
                                        phi_7484_ = _e4157[1];
                                    }
                                    let _e4168 = phi_7484_;
                                    if (_e4164 > _e4168) {
                                        phi_7489_ = _e4164;
                                    } else {
                                        phi_7489_ = _e4168;
                                    }
                                    let _e4171 = phi_7489_;
                                    if (_e4157[2] < 0f) {
                                        phi_7496_ = -(_e4157[2]);
                                    } else {
                                        phi_7496_ = _e4157[2];
                                    }
                                    let _e4175 = phi_7496_;
                                    if (_e4171 > _e4175) {
                                        phi_7501_ = _e4171;
                                    } else {
                                        phi_7501_ = _e4175;
                                    }
                                    let _e4178 = phi_7501_;
                                    let _e4181 = local_1.member_2[1u];
                                    if (_e4181[0] < 0f) {
                                        phi_7515_ = -(_e4181[0]);
                                    } else {
                                        phi_7515_ = _e4181[0];
                                    }
                                    let _e4188 = phi_7515_;
                                    if (_e4181[1] < 0f) {
                                        phi_7522_ = -(_e4181[1]);
                                    } else {
                                        phi_7522_ = _e4181[1];
                                    }
                                    let _e4192 = phi_7522_;
                                    if (_e4188 > _e4192) {
                                        phi_7527_ = _e4188;
                                    } else {
                                        phi_7527_ = _e4192;
                                    }
                                    let _e4195 = phi_7527_;
                                    if (_e4181[2] < 0f) {
                                        phi_7534_ = -(_e4181[2]);
                                    } else {
                                        phi_7534_ = _e4181[2];
                                    }
                                    let _e4199 = phi_7534_;
                                    if (_e4195 > _e4199) {
                                        phi_7539_ = _e4195;
                                    } else {
                                        phi_7539_ = _e4199;
                                    }
                                    let _e4202 = phi_7539_;
                                    if (_e4178 > _e4202) {
                                        phi_7544_ = _e4178;
                                    } else {
                                        phi_7544_ = _e4202;
                                    }
                                    let _e4205 = phi_7544_;
                                    let _e4207 = local_1.member_3;
                                    let _e4208 = (_e4205 + _e4207);
                                    let _e4210 = ((_e4154 * 8f) * _e4208);
                                    let _e4217 = local_1.member_3;
                                    if (_e3906 < 0f) {
                                        phi_7575_ = -(_e3906);
                                    } else {
                                        phi_7575_ = _e3906;
                                    }
                                    let _e4234 = phi_7575_;
                                    if (_e3909 < 0f) {
                                        phi_7581_ = -(_e3909);
                                    } else {
                                        phi_7581_ = _e3909;
                                    }
                                    let _e4238 = phi_7581_;
                                    if (_e3912 < 0f) {
                                        phi_7588_ = -(_e3912);
                                    } else {
                                        phi_7588_ = _e3912;
                                    }
                                    let _e4243 = phi_7588_;
                                    let _e4244 = ((_e4234 + _e4238) + _e4243);
                                    if (_e3927 < 0f) {
                                        phi_7595_ = -(_e3927);
                                    } else {
                                        phi_7595_ = _e3927;
                                    }
                                    let _e4248 = phi_7595_;
                                    if (_e3930 < 0f) {
                                        phi_7601_ = -(_e3930);
                                    } else {
                                        phi_7601_ = _e3930;
                                    }
                                    let _e4252 = phi_7601_;
                                    if (_e3933 < 0f) {
                                        phi_7608_ = -(_e3933);
                                    } else {
                                        phi_7608_ = _e3933;
                                    }
                                    let _e4257 = phi_7608_;
                                    let _e4258 = ((_e4248 + _e4252) + _e4257);
                                    if (_e4244 > _e4258) {
                                        phi_7614_ = _e4244;
                                    } else {
                                        phi_7614_ = _e4258;
                                    }
                                    let _e4261 = phi_7614_;
                                    if (_e3976 < 0f) {
                                        phi_7620_ = -(_e3976);
                                    } else {
                                        phi_7620_ = _e3976;
                                    }
                                    let _e4265 = phi_7620_;
                                    if (_e3977 < 0f) {
                                        phi_7626_ = -(_e3977);
                                    } else {
                                        phi_7626_ = _e3977;
                                    }
                                    let _e4269 = phi_7626_;
                                    if (_e3978 < 0f) {
                                        phi_7633_ = -(_e3978);
                                    } else {
                                        phi_7633_ = _e3978;
                                    }
                                    let _e4274 = phi_7633_;
                                    let _e4276 = (((_e4265 + _e4269) + _e4274) * 0.5f);
                                    if (_e4261 > _e4276) {
                                        phi_7640_ = _e4261;
                                    } else {
                                        phi_7640_ = _e4276;
                                    }
                                    let _e4279 = phi_7640_;
                                    let _e4284 = local_1.member_3;
                                    let _e4297 = ((((_e3981[0] * _e3906) + (_e3981[1] * _e3909)) + (_e3981[2] * _e3912)) * 3f);
                                    let _e4298 = ((((_e4038[0] * _e3927) + (_e4038[1] * _e3930)) + (_e4038[2] * _e3933)) * 3f);
                                    if (_e4297 < _e4298) {
                                        phi_7664_ = _e4297;
                                    } else {
                                        phi_7664_ = _e4298;
                                    }
                                    let _e4301 = phi_7664_;
                                    if (_e4012 < _e4035) {
                                        phi_7669_ = _e4012;
                                    } else {
                                        phi_7669_ = _e4035;
                                    }
                                    let _e4304 = phi_7669_;
                                    if (_e4301 < _e4304) {
                                        phi_7674_ = _e4301;
                                    } else {
                                        phi_7674_ = _e4304;
                                    }
                                    let _e4307 = phi_7674_;
                                    if (_e4297 > _e4298) {
                                        phi_7679_ = _e4297;
                                    } else {
                                        phi_7679_ = _e4298;
                                    }
                                    let _e4310 = phi_7679_;
                                    if (_e4012 > _e4035) {
                                        phi_7684_ = _e4012;
                                    } else {
                                        phi_7684_ = _e4035;
                                    }
                                    let _e4313 = phi_7684_;
                                    if (_e4310 > _e4313) {
                                        phi_7689_ = _e4310;
                                    } else {
                                        phi_7689_ = _e4313;
                                    }
                                    let _e4316 = phi_7689_;
                                    let _e4321 = -(_e4316);
                                    if (_e4307 > _e4321) {
                                        phi_7699_ = _e4307;
                                    } else {
                                        phi_7699_ = _e4321;
                                    }
                                    let _e4324 = phi_7699_;
                                    let _e4326 = ((_e4324 - ((((((_e4100 * 8f) * _e4210) * (0.000000059604645f * (524f / 64f))) + ((_e4217 * 19f) * ((_e4100 * (_e4154 + _e4208)) + (_e4154 * _e4208)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4100) * ((1f + _e4154) * (1f + _e4208))))) + ((_e1846 * (((_e4279 + (_e4210 * (0.000000059604645f * 8f))) + ((_e4284 * 6f) * (_e4154 + _e4208))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4154) * (1f + _e4208))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4326 {
                                        phi_8668_ = _e4326;
                                    } else {
                                        let _e4329 = local_1.member_1[0u];
                                        let _e4335 = local_1.member_1[1u];
                                        let _e4339 = (_e4329[0] + _e4335[0]);
                                        let _e4340 = (_e4329[1] + _e4335[1]);
                                        let _e4341 = (_e4329[2] + _e4335[2]);
                                        let _e4344 = local_1.member_2[0u];
                                        let _e4350 = local_1.member_2[1u];
                                        let _e4354 = (_e4344[0] + _e4350[0]);
                                        let _e4355 = (_e4344[1] + _e4350[1]);
                                        let _e4356 = (_e4344[2] + _e4350[2]);
                                        let _e4359 = ((_e4340 * _e4356) - (_e4341 * _e4355));
                                        let _e4362 = ((_e4341 * _e4354) - (_e4339 * _e4356));
                                        let _e4365 = ((_e4339 * _e4355) - (_e4340 * _e4354));
                                        let _e4368 = local_1.member[0u];
                                        let _e4374 = local_1.member_1[0u];
                                        let _e4380 = local_1.member_2[0u];
                                        let _e4384 = (_e4368[0] - _e4374[0]);
                                        let _e4385 = (_e4368[1] - _e4374[1]);
                                        let _e4386 = (_e4368[2] - _e4374[2]);
                                        let _e4387 = (_e4384 - _e4380[0]);
                                        let _e4388 = (_e4385 - _e4380[1]);
                                        let _e4389 = (_e4386 - _e4380[2]);
                                        let _e4390 = (_e4368[0] - _e4380[0]);
                                        let _e4391 = (_e4368[1] - _e4380[1]);
                                        let _e4392 = (_e4368[2] - _e4380[2]);
                                        let _e4395 = local_1.member[1u];
                                        let _e4401 = local_1.member_1[1u];
                                        let _e4407 = local_1.member_2[1u];
                                        let _e4411 = (_e4395[0] - _e4401[0]);
                                        let _e4412 = (_e4395[1] - _e4401[1]);
                                        let _e4413 = (_e4395[2] - _e4401[2]);
                                        let _e4414 = (_e4411 - _e4407[0]);
                                        let _e4415 = (_e4412 - _e4407[1]);
                                        let _e4416 = (_e4413 - _e4407[2]);
                                        let _e4417 = (_e4395[0] - _e4407[0]);
                                        let _e4418 = (_e4395[1] - _e4407[1]);
                                        let _e4419 = (_e4395[2] - _e4407[2]);
                                        let _e4422 = local_1.member[0u];
                                        if (_e4422[0] < 0f) {
                                            phi_7902_ = -(_e4422[0]);
                                        } else {
                                            phi_7902_ = _e4422[0];
                                        }
                                        let _e4429 = phi_7902_;
                                        if (_e4422[1] < 0f) {
                                            phi_7909_ = -(_e4422[1]);
                                        } else {
                                            phi_7909_ = _e4422[1];
                                        }
                                        let _e4433 = phi_7909_;
                                        if (_e4429 > _e4433) {
                                            phi_7914_ = _e4429;
                                        } else {
                                            phi_7914_ = _e4433;
                                        }
                                        let _e4436 = phi_7914_;
                                        if (_e4422[2] < 0f) {
                                            phi_7921_ = -(_e4422[2]);
                                        } else {
                                            phi_7921_ = _e4422[2];
                                        }
                                        let _e4440 = phi_7921_;
                                        if (_e4436 > _e4440) {
                                            phi_7926_ = _e4436;
                                        } else {
                                            phi_7926_ = _e4440;
                                        }
                                        let _e4443 = phi_7926_;
                                        let _e4446 = local_1.member[1u];
                                        if (_e4446[0] < 0f) {
                                            phi_7939_ = -(_e4446[0]);
                                        } else {
                                            phi_7939_ = _e4446[0];
                                        }
                                        let _e4453 = phi_7939_;
                                        if (_e4446[1] < 0f) {
                                            phi_7946_ = -(_e4446[1]);
                                        } else {
                                            phi_7946_ = _e4446[1];
                                        }
                                        let _e4457 = phi_7946_;
                                        if (_e4453 > _e4457) {
                                            phi_7951_ = _e4453;
                                        } else {
                                            phi_7951_ = _e4457;
                                        }
                                        let _e4460 = phi_7951_;
                                        if (_e4446[2] < 0f) {
                                            phi_7958_ = -(_e4446[2]);
                                        } else {
                                            phi_7958_ = _e4446[2];
                                        }
                                        let _e4464 = phi_7958_;
                                        if (_e4460 > _e4464) {
                                            phi_7963_ = _e4460;
                                        } else {
                                            phi_7963_ = _e4464;
                                        }
                                        let _e4467 = phi_7963_;
                                        if (_e4443 > _e4467) {
                                            phi_7968_ = _e4443;
                                        } else {
                                            phi_7968_ = _e4467;
                                        }
                                        let _e4470 = phi_7968_;
                                        let _e4472 = local_1.member_3;
                                        let _e4476 = local_1.member_1[0u];
                                        if (_e4476[0] < 0f) {
                                            phi_7985_ = -(_e4476[0]);
                                        } else {
                                            phi_7985_ = _e4476[0];
                                        }
                                        let _e4483 = phi_7985_;
                                        if (_e4476[1] < 0f) {
                                            phi_7992_ = -(_e4476[1]);
                                        } else {
                                            phi_7992_ = _e4476[1];
                                        }
                                        let _e4487 = phi_7992_;
                                        if (_e4483 > _e4487) {
                                            phi_7997_ = _e4483;
                                        } else {
                                            phi_7997_ = _e4487;
                                        }
                                        let _e4490 = phi_7997_;
                                        if (_e4476[2] < 0f) {
                                            phi_8004_ = -(_e4476[2]);
                                        } else {
                                            phi_8004_ = _e4476[2];
                                        }
                                        let _e4494 = phi_8004_;
                                        if (_e4490 > _e4494) {
                                            phi_8009_ = _e4490;
                                        } else {
                                            phi_8009_ = _e4494;
                                        }
                                        let _e4497 = phi_8009_;
                                        let _e4500 = local_1.member_1[1u];
                                        if (_e4500[0] < 0f) {
                                            phi_8023_ = -(_e4500[0]);
                                        } else {
                                            phi_8023_ = _e4500[0];
                                        }
                                        let _e4507 = phi_8023_;
                                        if (_e4500[1] < 0f) {
                                            phi_8030_ = -(_e4500[1]);
                                        } else {
                                            phi_8030_ = _e4500[1];
                                        }
                                        let _e4511 = phi_8030_;
                                        if (_e4507 > _e4511) {
                                            phi_8035_ = _e4507;
                                        } else {
                                            phi_8035_ = _e4511;
                                        }
                                        let _e4514 = phi_8035_;
                                        if (_e4500[2] < 0f) {
                                            phi_8042_ = -(_e4500[2]);
                                        } else {
                                            phi_8042_ = _e4500[2];
                                        }
                                        let _e4518 = phi_8042_;
                                        if (_e4514 > _e4518) {
                                            phi_8047_ = _e4514;
                                        } else {
                                            phi_8047_ = _e4518;
                                        }
                                        let _e4521 = phi_8047_;
                                        if (_e4497 > _e4521) {
                                            phi_8052_ = _e4497;
                                        } else {
                                            phi_8052_ = _e4521;
                                        }
                                        let _e4524 = phi_8052_;
                                        let _e4526 = local_1.member_3;
                                        let _e4530 = local_1.member_2[0u];
                                        if (_e4530[0] < 0f) {
                                            phi_8069_ = -(_e4530[0]);
                                        } else {
                                            phi_8069_ = _e4530[0];
                                        }
                                        let _e4537 = phi_8069_;
                                        if (_e4530[1] < 0f) {
                                            phi_8076_ = -(_e4530[1]);
                                        } else {
                                            phi_8076_ = _e4530[1];
                                        }
                                        let _e4541 = phi_8076_;
                                        if (_e4537 > _e4541) {
                                            phi_8081_ = _e4537;
                                        } else {
                                            phi_8081_ = _e4541;
                                        }
                                        let _e4544 = phi_8081_;
                                        if (_e4530[2] < 0f) {
                                            phi_8088_ = -(_e4530[2]);
                                        } else {
                                            phi_8088_ = _e4530[2];
                                        }
                                        let _e4548 = phi_8088_;
                                        if (_e4544 > _e4548) {
                                            phi_8093_ = _e4544;
                                        } else {
                                            phi_8093_ = _e4548;
                                        }
                                        let _e4551 = phi_8093_;
                                        let _e4554 = local_1.member_2[1u];
                                        if (_e4554[0] < 0f) {
                                            phi_8107_ = -(_e4554[0]);
                                        } else {
                                            phi_8107_ = _e4554[0];
                                        }
                                        let _e4561 = phi_8107_;
                                        if (_e4554[1] < 0f) {
                                            phi_8114_ = -(_e4554[1]);
                                        } else {
                                            phi_8114_ = _e4554[1];
                                        }
                                        let _e4565 = phi_8114_;
                                        if (_e4561 > _e4565) {
                                            phi_8119_ = _e4561;
                                        } else {
                                            phi_8119_ = _e4565;
                                        }
                                        let _e4568 = phi_8119_;
                                        if (_e4554[2] < 0f) {
                                            phi_8126_ = -(_e4554[2]);
                                        } else {
                                            phi_8126_ = _e4554[2];
                                        }
                                        let _e4572 = phi_8126_;
                                        if (_e4568 > _e4572) {
                                            phi_8131_ = _e4568;
                                        } else {
                                            phi_8131_ = _e4572;
                                        }
                                        let _e4575 = phi_8131_;
                                        if (_e4551 > _e4575) {
                                            phi_8136_ = _e4551;
                                        } else {
                                            phi_8136_ = _e4575;
                                        }
                                        let _e4578 = phi_8136_;
                                        let _e4580 = local_1.member_3;
                                        let _e4584 = ((((_e4470 + _e4472) + (_e4524 + _e4526)) + (_e4578 + _e4580)) * 2f);
                                        let _e4587 = local_1.member_3;
                                        let _e4591 = (((_e1846 * 1.0001f) + (_e4587 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4594 = ((_e4362 * _e4341) - (_e4365 * _e4340));
                                        let _e4597 = ((_e4365 * _e4339) - (_e4359 * _e4341));
                                        let _e4600 = ((_e4359 * _e4340) - (_e4362 * _e4339));
                                        let _e4605 = (((_e4594 * _e4368[0]) + (_e4597 * _e4368[1])) + (_e4600 * _e4368[2]));
                                        let _e4610 = (((_e4594 * _e4384) + (_e4597 * _e4385)) + (_e4600 * _e4386));
                                        let _e4615 = (((_e4594 * _e4390) + (_e4597 * _e4391)) + (_e4600 * _e4392));
                                        let _e4620 = (((_e4594 * _e4387) + (_e4597 * _e4388)) + (_e4600 * _e4389));
                                        let _e4625 = (((_e4594 * _e4395[0]) + (_e4597 * _e4395[1])) + (_e4600 * _e4395[2]));
                                        let _e4630 = (((_e4594 * _e4411) + (_e4597 * _e4412)) + (_e4600 * _e4413));
                                        let _e4635 = (((_e4594 * _e4417) + (_e4597 * _e4418)) + (_e4600 * _e4419));
                                        let _e4640 = (((_e4594 * _e4414) + (_e4597 * _e4415)) + (_e4600 * _e4416));
                                        if (_e4605 < _e4610) {
                                            phi_8215_ = _e4605;
                                        } else {
                                            phi_8215_ = _e4610;
                                        }
                                        let _e4643 = phi_8215_;
                                        if (_e4615 < _e4620) {
                                            phi_8220_ = _e4615;
                                        } else {
                                            phi_8220_ = _e4620;
                                        }
                                        let _e4646 = phi_8220_;
                                        if (_e4643 < _e4646) {
                                            phi_8225_ = _e4643;
                                        } else {
                                            phi_8225_ = _e4646;
                                        }
                                        let _e4649 = phi_8225_;
                                        if (_e4625 < _e4630) {
                                            phi_8230_ = _e4625;
                                        } else {
                                            phi_8230_ = _e4630;
                                        }
                                        let _e4652 = phi_8230_;
                                        if (_e4635 < _e4640) {
                                            phi_8235_ = _e4635;
                                        } else {
                                            phi_8235_ = _e4640;
                                        }
                                        let _e4655 = phi_8235_;
                                        if (_e4652 < _e4655) {
                                            phi_8240_ = _e4652;
                                        } else {
                                            phi_8240_ = _e4655;
                                        }
                                        let _e4658 = phi_8240_;
                                        if (_e4649 < _e4658) {
                                            phi_8245_ = _e4649;
                                        } else {
                                            phi_8245_ = _e4658;
                                        }
                                        let _e4661 = phi_8245_;
                                        if (_e4605 > _e4610) {
                                            phi_8250_ = _e4605;
                                        } else {
                                            phi_8250_ = _e4610;
                                        }
                                        let _e4664 = phi_8250_;
                                        if (_e4615 > _e4620) {
                                            phi_8255_ = _e4615;
                                        } else {
                                            phi_8255_ = _e4620;
                                        }
                                        let _e4667 = phi_8255_;
                                        if (_e4664 > _e4667) {
                                            phi_8260_ = _e4664;
                                        } else {
                                            phi_8260_ = _e4667;
                                        }
                                        let _e4670 = phi_8260_;
                                        if (_e4625 > _e4630) {
                                            phi_8265_ = _e4625;
                                        } else {
                                            phi_8265_ = _e4630;
                                        }
                                        let _e4673 = phi_8265_;
                                        if (_e4635 > _e4640) {
                                            phi_8270_ = _e4635;
                                        } else {
                                            phi_8270_ = _e4640;
                                        }
                                        let _e4676 = phi_8270_;
                                        if (_e4673 > _e4676) {
                                            phi_8275_ = _e4673;
                                        } else {
                                            phi_8275_ = _e4676;
                                        }
                                        let _e4679 = phi_8275_;
                                        if (_e4670 > _e4679) {
                                            phi_8280_ = _e4670;
                                        } else {
                                            phi_8280_ = _e4679;
                                        }
                                        let _e4682 = phi_8280_;
                                        if (_e4594 < 0f) {
                                            phi_8286_ = -(_e4594);
                                        } else {
                                            phi_8286_ = _e4594;
                                        }
                                        let _e4686 = phi_8286_;
                                        if (_e4597 < 0f) {
                                            phi_8292_ = -(_e4597);
                                        } else {
                                            phi_8292_ = _e4597;
                                        }
                                        let _e4690 = phi_8292_;
                                        if (_e4600 < 0f) {
                                            phi_8299_ = -(_e4600);
                                        } else {
                                            phi_8299_ = _e4600;
                                        }
                                        let _e4695 = phi_8299_;
                                        let _e4696 = ((_e4686 + _e4690) + _e4695);
                                        let _e4701 = -(_e4682);
                                        if (_e4661 > _e4701) {
                                            phi_8310_ = _e4661;
                                        } else {
                                            phi_8310_ = _e4701;
                                        }
                                        let _e4704 = phi_8310_;
                                        let _e4709 = (((_e4704 - ((_e4696 * _e4584) * (0.000000059604645f * (17f / 2f)))) - (_e4696 * _e4591)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4712 = ((_e4362 * _e4356) - (_e4365 * _e4355));
                                        let _e4715 = ((_e4365 * _e4354) - (_e4359 * _e4356));
                                        let _e4718 = ((_e4359 * _e4355) - (_e4362 * _e4354));
                                        let _e4723 = (((_e4712 * _e4368[0]) + (_e4715 * _e4368[1])) + (_e4718 * _e4368[2]));
                                        let _e4728 = (((_e4712 * _e4384) + (_e4715 * _e4385)) + (_e4718 * _e4386));
                                        let _e4733 = (((_e4712 * _e4390) + (_e4715 * _e4391)) + (_e4718 * _e4392));
                                        let _e4738 = (((_e4712 * _e4387) + (_e4715 * _e4388)) + (_e4718 * _e4389));
                                        let _e4743 = (((_e4712 * _e4395[0]) + (_e4715 * _e4395[1])) + (_e4718 * _e4395[2]));
                                        let _e4748 = (((_e4712 * _e4411) + (_e4715 * _e4412)) + (_e4718 * _e4413));
                                        let _e4753 = (((_e4712 * _e4417) + (_e4715 * _e4418)) + (_e4718 * _e4419));
                                        let _e4758 = (((_e4712 * _e4414) + (_e4715 * _e4415)) + (_e4718 * _e4416));
                                        if (_e4723 < _e4728) {
                                            phi_8381_ = _e4723;
                                        } else {
                                            phi_8381_ = _e4728;
                                        }
                                        let _e4761 = phi_8381_;
                                        if (_e4733 < _e4738) {
                                            phi_8386_ = _e4733;
                                        } else {
                                            phi_8386_ = _e4738;
                                        }
                                        let _e4764 = phi_8386_;
                                        if (_e4761 < _e4764) {
                                            phi_8391_ = _e4761;
                                        } else {
                                            phi_8391_ = _e4764;
                                        }
                                        let _e4767 = phi_8391_;
                                        if (_e4743 < _e4748) {
                                            phi_8396_ = _e4743;
                                        } else {
                                            phi_8396_ = _e4748;
                                        }
                                        let _e4770 = phi_8396_;
                                        if (_e4753 < _e4758) {
                                            phi_8401_ = _e4753;
                                        } else {
                                            phi_8401_ = _e4758;
                                        }
                                        let _e4773 = phi_8401_;
                                        if (_e4770 < _e4773) {
                                            phi_8406_ = _e4770;
                                        } else {
                                            phi_8406_ = _e4773;
                                        }
                                        let _e4776 = phi_8406_;
                                        if (_e4767 < _e4776) {
                                            phi_8411_ = _e4767;
                                        } else {
                                            phi_8411_ = _e4776;
                                        }
                                        let _e4779 = phi_8411_;
                                        if (_e4723 > _e4728) {
                                            phi_8416_ = _e4723;
                                        } else {
                                            phi_8416_ = _e4728;
                                        }
                                        let _e4782 = phi_8416_;
                                        if (_e4733 > _e4738) {
                                            phi_8421_ = _e4733;
                                        } else {
                                            phi_8421_ = _e4738;
                                        }
                                        let _e4785 = phi_8421_;
                                        if (_e4782 > _e4785) {
                                            phi_8426_ = _e4782;
                                        } else {
                                            phi_8426_ = _e4785;
                                        }
                                        let _e4788 = phi_8426_;
                                        if (_e4743 > _e4748) {
                                            phi_8431_ = _e4743;
                                        } else {
                                            phi_8431_ = _e4748;
                                        }
                                        let _e4791 = phi_8431_;
                                        if (_e4753 > _e4758) {
                                            phi_8436_ = _e4753;
                                        } else {
                                            phi_8436_ = _e4758;
                                        }
                                        let _e4794 = phi_8436_;
                                        if (_e4791 > _e4794) {
                                            phi_8441_ = _e4791;
                                        } else {
                                            phi_8441_ = _e4794;
                                        }
                                        let _e4797 = phi_8441_;
                                        if (_e4788 > _e4797) {
                                            phi_8446_ = _e4788;
                                        } else {
                                            phi_8446_ = _e4797;
                                        }
                                        let _e4800 = phi_8446_;
                                        if (_e4712 < 0f) {
                                            phi_8452_ = -(_e4712);
                                        } else {
                                            phi_8452_ = _e4712;
                                        }
                                        let _e4804 = phi_8452_;
                                        if (_e4715 < 0f) {
                                            phi_8458_ = -(_e4715);
                                        } else {
                                            phi_8458_ = _e4715;
                                        }
                                        let _e4808 = phi_8458_;
                                        if (_e4718 < 0f) {
                                            phi_8465_ = -(_e4718);
                                        } else {
                                            phi_8465_ = _e4718;
                                        }
                                        let _e4813 = phi_8465_;
                                        let _e4814 = ((_e4804 + _e4808) + _e4813);
                                        let _e4819 = -(_e4800);
                                        if (_e4779 > _e4819) {
                                            phi_8476_ = _e4779;
                                        } else {
                                            phi_8476_ = _e4819;
                                        }
                                        let _e4822 = phi_8476_;
                                        let _e4827 = (((_e4822 - ((_e4814 * _e4584) * (0.000000059604645f * (17f / 2f)))) - (_e4814 * _e4591)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4709 > _e4827) {
                                            phi_8486_ = _e4709;
                                        } else {
                                            phi_8486_ = _e4827;
                                        }
                                        let _e4830 = phi_8486_;
                                        phi_8668_ = (_e4326 || (_e4830 > 0f));
                                    }
                                    let _e4834 = phi_8668_;
                                    phi_8670_ = (_e3891 && _e4834);
                                } else {
                                    phi_8670_ = _e3891;
                                }
                                let _e4837 = phi_8670_;
                                phi_8672_ = (_e2858 || _e4837);
                            }
                            let _e4840 = phi_8672_;
                            if !(_e4840) {
                                let _e4843 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1189] = ((2147483648u | (_e4843 << bitcast<u32>(12i))) | _e1192);
                            }
                        }
                        phi_8683_ = true;
                    }
                    let _e4850 = phi_8683_;
                    phi_8684_ = _e4850;
                } else {
                    phi_8684_ = false;
                }
                let _e4852 = phi_8684_;
                continue;
                continuing {
                    phi_2256_ = _e1181;
                    break if !(_e4852);
                }
            }
            workgroupBarrier();
            if (_e71 == 0u) {
                let _e4856 = atomicLoad((&counters[5u]));
                if (_e4856 > 0u) {
                    let _e4859 = atomicAdd((&output.member[0u]), _e4856);
                    if ((_e4859 + _e4856) < _e4859) {
                        let _e4863 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4859);
                }
            }
            workgroupBarrier();
            let _e4866 = atomicLoad((&counters[6u]));
            if (_e71 == 0u) {
                let _e4869 = atomicLoad((&counters[7u]));
                if (_e4869 > 0u) {
                    let _e4872 = atomicAdd((&output.member[1u]), _e4869);
                    if ((_e4872 + _e4869) < _e4872) {
                        let _e4876 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_8735_ = type_9(0u, 16u);
            loop {
                let _e4878 = phi_8735_;
                if (_e4878.member < _e4878.member_1) {
                    phi_8736_ = type_9((_e4878.member + 1u), _e4878.member_1);
                    phi_8759_ = type_9(1u, _e4878.member);
                } else {
                    phi_8736_ = _e4878;
                    phi_8759_ = type_9(0u, type_9().member_1);
                }
                let _e4890 = phi_8736_;
                let _e4892 = phi_8759_;
                if (bitcast<i32>(_e4892.member) != 0i) {
                    let _e4898 = (_e71 + (_e4892.member_1 * 128u));
                    if (_e4898 >= _e1167) {
                        phi_8853_ = false;
                    } else {
                        let _e4901 = hits[_e4898];
                        if ((_e4901 & 2147483648u) == 0u) {
                            phi_8782_ = 4294967295u;
                        } else {
                            phi_8782_ = ((_e4901 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4908 = phi_8782_;
                        if (_e4908 != 4294967295u) {
                            let _e4912 = ((_e4901 >> bitcast<u32>(10i)) & 3u);
                            let _e4919 = firsts[(2u * _e4912)];
                            let _e4924 = firsts[((2u * _e4912) + 1u)];
                            let _e4927 = leaves.member[(_e4919 + ((_e4901 >> bitcast<u32>(5i)) & 31u))];
                            let _e4929 = leaves.member[(_e4924 + (_e4901 & 31u))];
                            if (_e4927.member_1 < _e4929.member_1) {
                                phi_8833_ = type_9(_e4927.member_1, _e4929.member_1);
                            } else {
                                phi_8833_ = type_9(_e4929.member_1, _e4927.member_1);
                            }
                            let _e4936 = phi_8833_;
                            let _e4939 = (_e4866 + _e4908);
                            if (_e4939 < _e90) {
                                let _e4941 = (2u * _e4939);
                                atomicStore((&output.member[(4u + _e4941)]), _e4936.member);
                                atomicStore((&output.member[(_e4941 + 5u)]), _e4936.member_1);
                            }
                        }
                        phi_8853_ = true;
                    }
                    let _e4947 = phi_8853_;
                    phi_8854_ = _e4947;
                } else {
                    phi_8854_ = false;
                }
                let _e4949 = phi_8854_;
                continue;
                continuing {
                    phi_8735_ = _e4890;
                    break if !(_e4949);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_468_ = _e160;
            break if !(_e166);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
