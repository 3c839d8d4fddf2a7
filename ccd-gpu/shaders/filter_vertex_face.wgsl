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
    var phi_986_: u32;
    var phi_988_: u32;
    var phi_874_: u32;
    var phi_991_: type_9;
    var phi_994_: u32;
    var phi_992_: type_9;
    var phi_1017_: type_9;
    var phi_1111_: bool;
    var phi_1118_: bool;
    var phi_1126_: bool;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1194_: bool;
    var phi_1195_: bool;
    var phi_1202_: bool;
    var phi_1318_: bool;
    var phi_1319_: bool;
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
    var phi_2244_: u32;
    var phi_2245_: bool;
    var phi_995_: u32;
    var phi_2246_: bool;
    var phi_2253_: u32;
    var phi_2256_: type_9;
    var phi_2257_: type_9;
    var phi_2280_: type_9;
    var phi_2382_: bool;
    var phi_2389_: bool;
    var phi_2397_: bool;
    var phi_2420_: bool;
    var phi_2421_: bool;
    var phi_2465_: bool;
    var phi_2466_: bool;
    var phi_2473_: bool;
    var phi_2589_: bool;
    var phi_2590_: bool;
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
    var phi_3885_: f32;
    var phi_3892_: f32;
    var phi_3897_: f32;
    var phi_3904_: f32;
    var phi_3909_: f32;
    var phi_3922_: f32;
    var phi_3929_: f32;
    var phi_3934_: f32;
    var phi_3941_: f32;
    var phi_3946_: f32;
    var phi_3951_: f32;
    var phi_3968_: f32;
    var phi_3975_: f32;
    var phi_3980_: f32;
    var phi_3987_: f32;
    var phi_3992_: f32;
    var phi_4006_: f32;
    var phi_4013_: f32;
    var phi_4018_: f32;
    var phi_4025_: f32;
    var phi_4030_: f32;
    var phi_4035_: f32;
    var phi_4052_: f32;
    var phi_4059_: f32;
    var phi_4064_: f32;
    var phi_4071_: f32;
    var phi_4076_: f32;
    var phi_4090_: f32;
    var phi_4097_: f32;
    var phi_4102_: f32;
    var phi_4109_: f32;
    var phi_4114_: f32;
    var phi_4119_: f32;
    var phi_4150_: f32;
    var phi_4156_: f32;
    var phi_4163_: f32;
    var phi_4170_: f32;
    var phi_4176_: f32;
    var phi_4183_: f32;
    var phi_4189_: f32;
    var phi_4195_: f32;
    var phi_4201_: f32;
    var phi_4208_: f32;
    var phi_4215_: f32;
    var phi_4239_: f32;
    var phi_4244_: f32;
    var phi_4249_: f32;
    var phi_4254_: f32;
    var phi_4259_: f32;
    var phi_4264_: f32;
    var phi_4274_: f32;
    var phi_4477_: f32;
    var phi_4484_: f32;
    var phi_4489_: f32;
    var phi_4496_: f32;
    var phi_4501_: f32;
    var phi_4514_: f32;
    var phi_4521_: f32;
    var phi_4526_: f32;
    var phi_4533_: f32;
    var phi_4538_: f32;
    var phi_4543_: f32;
    var phi_4560_: f32;
    var phi_4567_: f32;
    var phi_4572_: f32;
    var phi_4579_: f32;
    var phi_4584_: f32;
    var phi_4598_: f32;
    var phi_4605_: f32;
    var phi_4610_: f32;
    var phi_4617_: f32;
    var phi_4622_: f32;
    var phi_4627_: f32;
    var phi_4644_: f32;
    var phi_4651_: f32;
    var phi_4656_: f32;
    var phi_4663_: f32;
    var phi_4668_: f32;
    var phi_4682_: f32;
    var phi_4689_: f32;
    var phi_4694_: f32;
    var phi_4701_: f32;
    var phi_4706_: f32;
    var phi_4711_: f32;
    var phi_4790_: f32;
    var phi_4795_: f32;
    var phi_4800_: f32;
    var phi_4805_: f32;
    var phi_4810_: f32;
    var phi_4815_: f32;
    var phi_4820_: f32;
    var phi_4825_: f32;
    var phi_4830_: f32;
    var phi_4835_: f32;
    var phi_4840_: f32;
    var phi_4845_: f32;
    var phi_4850_: f32;
    var phi_4855_: f32;
    var phi_4861_: f32;
    var phi_4867_: f32;
    var phi_4874_: f32;
    var phi_4885_: f32;
    var phi_4956_: f32;
    var phi_4961_: f32;
    var phi_4966_: f32;
    var phi_4971_: f32;
    var phi_4976_: f32;
    var phi_4981_: f32;
    var phi_4986_: f32;
    var phi_4991_: f32;
    var phi_4996_: f32;
    var phi_5001_: f32;
    var phi_5006_: f32;
    var phi_5011_: f32;
    var phi_5016_: f32;
    var phi_5021_: f32;
    var phi_5027_: f32;
    var phi_5033_: f32;
    var phi_5040_: f32;
    var phi_5051_: f32;
    var phi_5061_: f32;
    var phi_5134_: f32;
    var phi_5139_: f32;
    var phi_5144_: f32;
    var phi_5149_: f32;
    var phi_5154_: f32;
    var phi_5159_: f32;
    var phi_5164_: f32;
    var phi_5169_: f32;
    var phi_5174_: f32;
    var phi_5179_: f32;
    var phi_5184_: f32;
    var phi_5189_: f32;
    var phi_5194_: f32;
    var phi_5199_: f32;
    var phi_5205_: f32;
    var phi_5211_: f32;
    var phi_5218_: f32;
    var phi_5229_: f32;
    var phi_5239_: f32;
    var phi_5243_: bool;
    var phi_5695_: f32;
    var phi_5702_: f32;
    var phi_5707_: f32;
    var phi_5714_: f32;
    var phi_5719_: f32;
    var phi_5732_: f32;
    var phi_5739_: f32;
    var phi_5744_: f32;
    var phi_5751_: f32;
    var phi_5756_: f32;
    var phi_5761_: f32;
    var phi_5778_: f32;
    var phi_5785_: f32;
    var phi_5790_: f32;
    var phi_5797_: f32;
    var phi_5802_: f32;
    var phi_5816_: f32;
    var phi_5823_: f32;
    var phi_5828_: f32;
    var phi_5835_: f32;
    var phi_5840_: f32;
    var phi_5845_: f32;
    var phi_5862_: f32;
    var phi_5869_: f32;
    var phi_5874_: f32;
    var phi_5881_: f32;
    var phi_5886_: f32;
    var phi_5900_: f32;
    var phi_5907_: f32;
    var phi_5912_: f32;
    var phi_5919_: f32;
    var phi_5924_: f32;
    var phi_5929_: f32;
    var phi_5960_: f32;
    var phi_5966_: f32;
    var phi_5973_: f32;
    var phi_5980_: f32;
    var phi_5986_: f32;
    var phi_5993_: f32;
    var phi_5999_: f32;
    var phi_6005_: f32;
    var phi_6011_: f32;
    var phi_6018_: f32;
    var phi_6025_: f32;
    var phi_6049_: f32;
    var phi_6054_: f32;
    var phi_6059_: f32;
    var phi_6064_: f32;
    var phi_6069_: f32;
    var phi_6074_: f32;
    var phi_6084_: f32;
    var phi_6287_: f32;
    var phi_6294_: f32;
    var phi_6299_: f32;
    var phi_6306_: f32;
    var phi_6311_: f32;
    var phi_6324_: f32;
    var phi_6331_: f32;
    var phi_6336_: f32;
    var phi_6343_: f32;
    var phi_6348_: f32;
    var phi_6353_: f32;
    var phi_6370_: f32;
    var phi_6377_: f32;
    var phi_6382_: f32;
    var phi_6389_: f32;
    var phi_6394_: f32;
    var phi_6408_: f32;
    var phi_6415_: f32;
    var phi_6420_: f32;
    var phi_6427_: f32;
    var phi_6432_: f32;
    var phi_6437_: f32;
    var phi_6454_: f32;
    var phi_6461_: f32;
    var phi_6466_: f32;
    var phi_6473_: f32;
    var phi_6478_: f32;
    var phi_6492_: f32;
    var phi_6499_: f32;
    var phi_6504_: f32;
    var phi_6511_: f32;
    var phi_6516_: f32;
    var phi_6521_: f32;
    var phi_6600_: f32;
    var phi_6605_: f32;
    var phi_6610_: f32;
    var phi_6615_: f32;
    var phi_6620_: f32;
    var phi_6625_: f32;
    var phi_6630_: f32;
    var phi_6635_: f32;
    var phi_6640_: f32;
    var phi_6645_: f32;
    var phi_6650_: f32;
    var phi_6655_: f32;
    var phi_6660_: f32;
    var phi_6665_: f32;
    var phi_6671_: f32;
    var phi_6677_: f32;
    var phi_6684_: f32;
    var phi_6695_: f32;
    var phi_6766_: f32;
    var phi_6771_: f32;
    var phi_6776_: f32;
    var phi_6781_: f32;
    var phi_6786_: f32;
    var phi_6791_: f32;
    var phi_6796_: f32;
    var phi_6801_: f32;
    var phi_6806_: f32;
    var phi_6811_: f32;
    var phi_6816_: f32;
    var phi_6821_: f32;
    var phi_6826_: f32;
    var phi_6831_: f32;
    var phi_6837_: f32;
    var phi_6843_: f32;
    var phi_6850_: f32;
    var phi_6861_: f32;
    var phi_6871_: f32;
    var phi_6944_: f32;
    var phi_6949_: f32;
    var phi_6954_: f32;
    var phi_6959_: f32;
    var phi_6964_: f32;
    var phi_6969_: f32;
    var phi_6974_: f32;
    var phi_6979_: f32;
    var phi_6984_: f32;
    var phi_6989_: f32;
    var phi_6994_: f32;
    var phi_6999_: f32;
    var phi_7004_: f32;
    var phi_7009_: f32;
    var phi_7015_: f32;
    var phi_7021_: f32;
    var phi_7028_: f32;
    var phi_7039_: f32;
    var phi_7049_: f32;
    var phi_7053_: bool;
    var phi_7298_: f32;
    var phi_7305_: f32;
    var phi_7310_: f32;
    var phi_7317_: f32;
    var phi_7322_: f32;
    var phi_7335_: f32;
    var phi_7342_: f32;
    var phi_7347_: f32;
    var phi_7354_: f32;
    var phi_7359_: f32;
    var phi_7364_: f32;
    var phi_7381_: f32;
    var phi_7388_: f32;
    var phi_7393_: f32;
    var phi_7400_: f32;
    var phi_7405_: f32;
    var phi_7419_: f32;
    var phi_7426_: f32;
    var phi_7431_: f32;
    var phi_7438_: f32;
    var phi_7443_: f32;
    var phi_7448_: f32;
    var phi_7465_: f32;
    var phi_7472_: f32;
    var phi_7477_: f32;
    var phi_7484_: f32;
    var phi_7489_: f32;
    var phi_7503_: f32;
    var phi_7510_: f32;
    var phi_7515_: f32;
    var phi_7522_: f32;
    var phi_7527_: f32;
    var phi_7532_: f32;
    var phi_7563_: f32;
    var phi_7569_: f32;
    var phi_7576_: f32;
    var phi_7583_: f32;
    var phi_7589_: f32;
    var phi_7596_: f32;
    var phi_7602_: f32;
    var phi_7608_: f32;
    var phi_7614_: f32;
    var phi_7621_: f32;
    var phi_7628_: f32;
    var phi_7652_: f32;
    var phi_7657_: f32;
    var phi_7662_: f32;
    var phi_7667_: f32;
    var phi_7672_: f32;
    var phi_7677_: f32;
    var phi_7687_: f32;
    var phi_7890_: f32;
    var phi_7897_: f32;
    var phi_7902_: f32;
    var phi_7909_: f32;
    var phi_7914_: f32;
    var phi_7927_: f32;
    var phi_7934_: f32;
    var phi_7939_: f32;
    var phi_7946_: f32;
    var phi_7951_: f32;
    var phi_7956_: f32;
    var phi_7973_: f32;
    var phi_7980_: f32;
    var phi_7985_: f32;
    var phi_7992_: f32;
    var phi_7997_: f32;
    var phi_8011_: f32;
    var phi_8018_: f32;
    var phi_8023_: f32;
    var phi_8030_: f32;
    var phi_8035_: f32;
    var phi_8040_: f32;
    var phi_8057_: f32;
    var phi_8064_: f32;
    var phi_8069_: f32;
    var phi_8076_: f32;
    var phi_8081_: f32;
    var phi_8095_: f32;
    var phi_8102_: f32;
    var phi_8107_: f32;
    var phi_8114_: f32;
    var phi_8119_: f32;
    var phi_8124_: f32;
    var phi_8203_: f32;
    var phi_8208_: f32;
    var phi_8213_: f32;
    var phi_8218_: f32;
    var phi_8223_: f32;
    var phi_8228_: f32;
    var phi_8233_: f32;
    var phi_8238_: f32;
    var phi_8243_: f32;
    var phi_8248_: f32;
    var phi_8253_: f32;
    var phi_8258_: f32;
    var phi_8263_: f32;
    var phi_8268_: f32;
    var phi_8274_: f32;
    var phi_8280_: f32;
    var phi_8287_: f32;
    var phi_8298_: f32;
    var phi_8369_: f32;
    var phi_8374_: f32;
    var phi_8379_: f32;
    var phi_8384_: f32;
    var phi_8389_: f32;
    var phi_8394_: f32;
    var phi_8399_: f32;
    var phi_8404_: f32;
    var phi_8409_: f32;
    var phi_8414_: f32;
    var phi_8419_: f32;
    var phi_8424_: f32;
    var phi_8429_: f32;
    var phi_8434_: f32;
    var phi_8440_: f32;
    var phi_8446_: f32;
    var phi_8453_: f32;
    var phi_8464_: f32;
    var phi_8474_: f32;
    var phi_8547_: f32;
    var phi_8552_: f32;
    var phi_8557_: f32;
    var phi_8562_: f32;
    var phi_8567_: f32;
    var phi_8572_: f32;
    var phi_8577_: f32;
    var phi_8582_: f32;
    var phi_8587_: f32;
    var phi_8592_: f32;
    var phi_8597_: f32;
    var phi_8602_: f32;
    var phi_8607_: f32;
    var phi_8612_: f32;
    var phi_8618_: f32;
    var phi_8624_: f32;
    var phi_8631_: f32;
    var phi_8642_: f32;
    var phi_8652_: f32;
    var phi_8656_: bool;
    var phi_8658_: bool;
    var phi_8660_: bool;
    var phi_8671_: bool;
    var phi_8672_: bool;
    var phi_8723_: type_9;
    var phi_8724_: type_9;
    var phi_8747_: type_9;
    var phi_8770_: u32;
    var phi_8841_: bool;
    var phi_8842_: bool;
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
            let _e224 = params.member.member_2.member[0u][0u];
            let _e225 = (_e224 + (_e213 * 32u));
            let _e231 = params.member.member_2.member[0u][2u];
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
            let _e379 = (_e71 / 32u);
            let _e382 = atomicLoad((&counters[_e379]));
            phi_870_ = type_9(0u, _e382);
            phi_873_ = 0u;
            loop {
                let _e385 = phi_870_;
                let _e387 = phi_873_;
                local_7 = _e387;
                if (_e385.member < _e385.member_1) {
                    phi_871_ = type_9((_e385.member + 1u), _e385.member_1);
                    phi_896_ = type_9(1u, _e385.member);
                } else {
                    phi_871_ = _e385;
                    phi_896_ = type_9(0u, type_9().member_1);
                }
                let _e399 = phi_871_;
                let _e401 = phi_896_;
                let _e405 = (bitcast<i32>(_e401.member) != 0i);
                if _e405 {
                    let _e409 = names[((_e379 * 32u) + _e401.member_1)];
                    let _e413 = columns[((_e379 * 32u) + _e401.member_1)];
                    if ((((((_e378.member[0] <= _e413.member_1[0]) && (_e413.member[0] <= _e378.member_1[0])) && (_e378.member[1] <= _e413.member_1[1])) && (_e413.member[1] <= _e378.member_1[1])) && (_e378.member[2] <= _e413.member_1[2])) && (_e413.member[2] <= _e378.member_1[2])) {
                        let _e446 = atomicAdd((&counters[4u]), 1u);
                        if (_e446 < 2048u) {
                            hits[_e446] = (((_e379 << bitcast<u32>(10i)) | ((_e71 % 32u) << bitcast<u32>(5i))) | _e409);
                            phi_986_ = _e387;
                        } else {
                            phi_986_ = (_e387 | (1u << bitcast<u32>((_e401.member_1 & 31u))));
                        }
                        let _e460 = phi_986_;
                        phi_988_ = _e460;
                    } else {
                        phi_988_ = _e387;
                    }
                    let _e462 = phi_988_;
                    phi_874_ = _e462;
                } else {
                    phi_874_ = u32();
                }
                let _e464 = phi_874_;
                continue;
                continuing {
                    phi_870_ = _e399;
                    phi_873_ = _e464;
                    break if !(_e405);
                }
            }
            phi_991_ = type_9(0u, 32u);
            let _e5291 = local_7;
            phi_994_ = _e5291;
            loop {
                let _e467 = phi_991_;
                let _e469 = phi_994_;
                if (_e467.member < _e467.member_1) {
                    phi_992_ = type_9((_e467.member + 1u), _e467.member_1);
                    phi_1017_ = type_9(1u, _e467.member);
                } else {
                    phi_992_ = _e467;
                    phi_1017_ = type_9(0u, type_9().member_1);
                }
                let _e481 = phi_992_;
                let _e483 = phi_1017_;
                if (bitcast<i32>(_e483.member) != 0i) {
                    if (_e469 == 0u) {
                        phi_2244_ = u32();
                        phi_2245_ = false;
                    } else {
                        let _e494 = names[((_e99 * 32u) + select(firstTrailingBit(_e469), 32u, (_e469 == 0u)))];
                        let _e497 = (_e225 + _e100);
                        let _e498 = (_e232 + _e494);
                        let _e500 = leaves.member[_e497];
                        let _e502 = leaves.member[_e498];
                        let _e504 = nodes.member[_e497];
                        let _e518 = nodes.member[_e498];
                        let _e533 = params.member.member.member_1;
                        if ((_e533 & 1u) != 0u) {
                            if (_e502.member[0] == _e500.member[0]) {
                                phi_1111_ = true;
                            } else {
                                phi_1111_ = (_e502.member[0] == _e500.member[0]);
                            }
                            let _e543 = phi_1111_;
                            if (_e502.member[1] == _e500.member[0]) {
                                phi_1118_ = true;
                            } else {
                                phi_1118_ = (_e502.member[1] == _e500.member[0]);
                            }
                            let _e548 = phi_1118_;
                            if (_e502.member[2] == _e500.member[0]) {
                                phi_1126_ = true;
                            } else {
                                phi_1126_ = (_e502.member[2] == _e500.member[0]);
                            }
                            let _e554 = phi_1126_;
                            if ((_e543 || _e548) || _e554) {
                                phi_1149_ = false;
                            } else {
                                phi_1149_ = true;
                            }
                            let _e557 = phi_1149_;
                            phi_1150_ = _e557;
                        } else {
                            phi_1150_ = true;
                        }
                        let _e559 = phi_1150_;
                        if _e559 {
                            let _e561 = params.member.member.member_1;
                            if ((_e561 & 2u) != 0u) {
                                let _e567 = bodies.member[_e500.member[0]];
                                let _e571 = bodies.member[_e502.member[0]];
                                if ((_e567 / 4u) != (_e571 / 4u)) {
                                    phi_1195_ = true;
                                } else {
                                    if ((_e567 & 2u) == 0u) {
                                        phi_1194_ = false;
                                    } else {
                                        phi_1194_ = true;
                                    }
                                    let _e578 = phi_1194_;
                                    phi_1195_ = _e578;
                                }
                                let _e580 = phi_1195_;
                                if _e580 {
                                    phi_1202_ = (((_e567 & _e571) & 1u) == 0u);
                                } else {
                                    phi_1202_ = false;
                                }
                                let _e585 = phi_1202_;
                                if _e585 {
                                    let _e587 = params.member.member.member_1;
                                    if ((_e587 & 4u) != 0u) {
                                        let _e592 = params.member.member.member[0u];
                                        let _e594 = bodies.member[_e592];
                                        let _e597 = bodies.member[(_e592 + 1u)];
                                        let _e602 = ((_e592 + 4u) + (2u * (_e567 >> bitcast<u32>(2i))));
                                        let _e607 = ((_e592 + 4u) + (2u * (_e571 >> bitcast<u32>(2i))));
                                        let _e609 = bodies.member[_e602];
                                        let _e611 = bodies.member[_e607];
                                        let _e620 = bodies.member[((((_e592 + 4u) + (2u * _e594)) + (_e609 * _e597)) + (_e611 / 32u))];
                                        let _e623 = bodies.member[(_e602 + 1u)];
                                        let _e626 = bodies.member[(_e607 + 1u)];
                                        if (_e623 == _e626) {
                                            if (((_e620 >> bitcast<u32>(((_e611 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_1318_ = true;
                                            } else {
                                                phi_1318_ = ((_e567 >> bitcast<u32>(2i)) == (_e571 >> bitcast<u32>(2i)));
                                            }
                                            let _e640 = phi_1318_;
                                            phi_1319_ = _e640;
                                        } else {
                                            phi_1319_ = false;
                                        }
                                        let _e642 = phi_1319_;
                                        if _e642 {
                                            let _e647 = bodies.member[(_e592 + 2u)];
                                            let _e650 = bodies.member[(_e592 + 3u)];
                                            let _e651 = (_e650 + _e592);
                                            phi_1362_ = type_15(0i, 32i);
                                            phi_1365_ = _e647;
                                            phi_1367_ = 0u;
                                            loop {
                                                let _e653 = phi_1362_;
                                                let _e655 = phi_1365_;
                                                let _e657 = phi_1367_;
                                                local_3 = _e657;
                                                local_4 = _e657;
                                                if (_e653.member < _e653.member_1) {
                                                    let _e664 = (_e653.member + 1i);
                                                    if ((false == (_e664 > _e653.member)) != false) {
                                                        phi_1388_ = true;
                                                    } else {
                                                        phi_1388_ = false;
                                                    }
                                                    let _e669 = phi_1388_;
                                                    if _e669 {
                                                        phi_1394_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_1394_ = type_16(1u, _e664);
                                                    }
                                                    let _e674 = phi_1394_;
                                                    phi_1363_ = type_15(_e674.member_1, _e653.member_1);
                                                    phi_1408_ = type_16(1u, _e653.member);
                                                } else {
                                                    phi_1363_ = _e653;
                                                    phi_1408_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e680 = phi_1363_;
                                                let _e682 = phi_1408_;
                                                if (bitcast<i32>(_e682.member) != 0i) {
                                                    if (_e657 >= _e655) {
                                                        phi_1491_ = u32();
                                                        phi_1492_ = u32();
                                                        phi_1493_ = false;
                                                    } else {
                                                        let _e689 = (_e657 + ((_e655 - _e657) / 2u));
                                                        let _e691 = (_e651 + (3u * _e689));
                                                        let _e693 = bodies.member[_e691];
                                                        let _e696 = bodies.member[(_e691 + 1u)];
                                                        let _e699 = bodies.member[(_e691 + 2u)];
                                                        if (_e693 == 0u) {
                                                            if (_e696 < _e500.member_1) {
                                                                phi_1478_ = false;
                                                            } else {
                                                                if (_e696 == _e500.member_1) {
                                                                    if (_e699 < _e502.member_1) {
                                                                        phi_1476_ = false;
                                                                    } else {
                                                                        phi_1476_ = true;
                                                                    }
                                                                    let _e705 = phi_1476_;
                                                                    phi_1477_ = _e705;
                                                                } else {
                                                                    phi_1477_ = true;
                                                                }
                                                                let _e707 = phi_1477_;
                                                                phi_1478_ = _e707;
                                                            }
                                                            let _e709 = phi_1478_;
                                                            phi_1479_ = _e709;
                                                        } else {
                                                            phi_1479_ = true;
                                                        }
                                                        let _e711 = phi_1479_;
                                                        if _e711 {
                                                            phi_1483_ = false;
                                                        } else {
                                                            phi_1483_ = true;
                                                        }
                                                        let _e713 = phi_1483_;
                                                        if _e713 {
                                                            phi_1489_ = _e655;
                                                            phi_1490_ = (_e689 + 1u);
                                                        } else {
                                                            phi_1489_ = _e689;
                                                            phi_1490_ = _e657;
                                                        }
                                                        let _e716 = phi_1489_;
                                                        let _e718 = phi_1490_;
                                                        phi_1491_ = _e716;
                                                        phi_1492_ = _e718;
                                                        phi_1493_ = true;
                                                    }
                                                    let _e720 = phi_1491_;
                                                    let _e722 = phi_1492_;
                                                    let _e724 = phi_1493_;
                                                    phi_1366_ = _e720;
                                                    phi_1368_ = _e722;
                                                    phi_1494_ = _e724;
                                                } else {
                                                    phi_1366_ = u32();
                                                    phi_1368_ = u32();
                                                    phi_1494_ = false;
                                                }
                                                let _e726 = phi_1366_;
                                                let _e728 = phi_1368_;
                                                let _e730 = phi_1494_;
                                                continue;
                                                continuing {
                                                    phi_1362_ = _e680;
                                                    phi_1365_ = _e726;
                                                    phi_1367_ = _e728;
                                                    break if !(_e730);
                                                }
                                            }
                                            let _e733 = local_3;
                                            if (_e733 < _e647) {
                                                let _e736 = local_4;
                                                let _e738 = (_e651 + (3u * _e736));
                                                let _e740 = bodies.member[_e738];
                                                if (_e740 == 0u) {
                                                    let _e744 = bodies.member[(_e738 + 1u)];
                                                    if (_e744 == _e500.member_1) {
                                                        let _e748 = bodies.member[(_e738 + 2u)];
                                                        phi_1542_ = (_e748 == _e502.member_1);
                                                        phi_1543_ = false;
                                                    } else {
                                                        phi_1542_ = bool();
                                                        phi_1543_ = true;
                                                    }
                                                    let _e751 = phi_1542_;
                                                    let _e753 = phi_1543_;
                                                    phi_1544_ = _e751;
                                                    phi_1545_ = _e753;
                                                } else {
                                                    phi_1544_ = bool();
                                                    phi_1545_ = true;
                                                }
                                                let _e755 = phi_1544_;
                                                let _e757 = phi_1545_;
                                                if _e757 {
                                                    phi_1549_ = false;
                                                } else {
                                                    phi_1549_ = _e755;
                                                }
                                                let _e759 = phi_1549_;
                                                phi_1550_ = _e759;
                                            } else {
                                                phi_1550_ = false;
                                            }
                                            let _e761 = phi_1550_;
                                            phi_1554_ = _e761;
                                        } else {
                                            phi_1554_ = true;
                                        }
                                        let _e763 = phi_1554_;
                                        if _e763 {
                                            phi_1558_ = false;
                                        } else {
                                            phi_1558_ = true;
                                        }
                                        let _e765 = phi_1558_;
                                        phi_1559_ = _e765;
                                    } else {
                                        phi_1559_ = true;
                                    }
                                    let _e767 = phi_1559_;
                                    if _e767 {
                                        phi_1563_ = false;
                                    } else {
                                        phi_1563_ = true;
                                    }
                                    let _e769 = phi_1563_;
                                    phi_1564_ = _e769;
                                } else {
                                    phi_1564_ = true;
                                }
                                let _e771 = phi_1564_;
                                if _e771 {
                                    phi_1568_ = false;
                                } else {
                                    phi_1568_ = true;
                                }
                                let _e773 = phi_1568_;
                                phi_1569_ = _e773;
                            } else {
                                phi_1569_ = true;
                            }
                            let _e775 = phi_1569_;
                            if _e775 {
                                let _e777 = params.member.member.member_1;
                                if ((_e777 & 32u) != 0u) {
                                    let _e781 = params.member.member.member_6;
                                    let _e798 = (((((_e504.member_1.y - _e518.member.x) > _e781) && ((_e518.member_1.y - _e504.member.x) > _e781)) && (((_e504.member_2.x - _e518.member.y) > _e781) && ((_e518.member_2.x - _e504.member.y) > _e781))) && (((_e504.member_2.y - _e518.member_1.x) > _e781) && ((_e518.member_2.y - _e504.member_1.x) > _e781)));
                                    if _e798 {
                                        phi_2171_ = bool();
                                    } else {
                                        let _e802 = keys.member[_e500.member[0]];
                                        let _e807 = keys.member[_e500.member[1]];
                                        let _e809 = function_(_e802[0], _e807[0]);
                                        let _e813 = keys.member[_e500.member[2]];
                                        let _e815 = function_(_e809, _e813[0]);
                                        let _e819 = keys.member[_e502.member[0]];
                                        let _e824 = keys.member[_e502.member[1]];
                                        let _e826 = function_1(_e819[3], _e824[3]);
                                        let _e830 = keys.member[_e502.member[2]];
                                        let _e832 = function_1(_e826, _e830[3]);
                                        if (_e815[1] > _e832[1]) {
                                            phi_1694_ = true;
                                        } else {
                                            if (_e815[1] == _e832[1]) {
                                                phi_1693_ = (_e815[0] > _e832[0]);
                                            } else {
                                                phi_1693_ = false;
                                            }
                                            let _e843 = phi_1693_;
                                            phi_1694_ = _e843;
                                        }
                                        let _e845 = phi_1694_;
                                        let _e850 = keys.member[_e502.member[0]];
                                        let _e855 = keys.member[_e502.member[1]];
                                        let _e857 = function_(_e850[0], _e855[0]);
                                        let _e861 = keys.member[_e502.member[2]];
                                        let _e863 = function_(_e857, _e861[0]);
                                        let _e867 = keys.member[_e500.member[0]];
                                        let _e872 = keys.member[_e500.member[1]];
                                        let _e874 = function_1(_e867[3], _e872[3]);
                                        let _e878 = keys.member[_e500.member[2]];
                                        let _e880 = function_1(_e874, _e878[3]);
                                        if (_e863[1] > _e880[1]) {
                                            phi_1788_ = true;
                                        } else {
                                            if (_e863[1] == _e880[1]) {
                                                phi_1787_ = (_e863[0] > _e880[0]);
                                            } else {
                                                phi_1787_ = false;
                                            }
                                            let _e891 = phi_1787_;
                                            phi_1788_ = _e891;
                                        }
                                        let _e893 = phi_1788_;
                                        let _e899 = keys.member[_e500.member[0]];
                                        let _e904 = keys.member[_e500.member[1]];
                                        let _e906 = function_2(_e899[1], _e904[1]);
                                        let _e910 = keys.member[_e500.member[2]];
                                        let _e912 = function_2(_e906, _e910[1]);
                                        let _e916 = keys.member[_e502.member[0]];
                                        let _e921 = keys.member[_e502.member[1]];
                                        let _e923 = function_3(_e916[4], _e921[4]);
                                        let _e927 = keys.member[_e502.member[2]];
                                        let _e929 = function_3(_e923, _e927[4]);
                                        if (_e912[1] > _e929[1]) {
                                            phi_1883_ = true;
                                        } else {
                                            if (_e912[1] == _e929[1]) {
                                                phi_1882_ = (_e912[0] > _e929[0]);
                                            } else {
                                                phi_1882_ = false;
                                            }
                                            let _e940 = phi_1882_;
                                            phi_1883_ = _e940;
                                        }
                                        let _e942 = phi_1883_;
                                        let _e947 = keys.member[_e502.member[0]];
                                        let _e952 = keys.member[_e502.member[1]];
                                        let _e954 = function_2(_e947[1], _e952[1]);
                                        let _e958 = keys.member[_e502.member[2]];
                                        let _e960 = function_2(_e954, _e958[1]);
                                        let _e964 = keys.member[_e500.member[0]];
                                        let _e969 = keys.member[_e500.member[1]];
                                        let _e971 = function_3(_e964[4], _e969[4]);
                                        let _e975 = keys.member[_e500.member[2]];
                                        let _e977 = function_3(_e971, _e975[4]);
                                        if (_e960[1] > _e977[1]) {
                                            phi_1977_ = true;
                                        } else {
                                            if (_e960[1] == _e977[1]) {
                                                phi_1976_ = (_e960[0] > _e977[0]);
                                            } else {
                                                phi_1976_ = false;
                                            }
                                            let _e988 = phi_1976_;
                                            phi_1977_ = _e988;
                                        }
                                        let _e990 = phi_1977_;
                                        let _e997 = keys.member[_e500.member[0]];
                                        let _e1002 = keys.member[_e500.member[1]];
                                        let _e1004 = function_4(_e997[2], _e1002[2]);
                                        let _e1008 = keys.member[_e500.member[2]];
                                        let _e1010 = function_4(_e1004, _e1008[2]);
                                        let _e1014 = keys.member[_e502.member[0]];
                                        let _e1019 = keys.member[_e502.member[1]];
                                        let _e1021 = function_5(_e1014[5], _e1019[5]);
                                        let _e1025 = keys.member[_e502.member[2]];
                                        let _e1027 = function_5(_e1021, _e1025[5]);
                                        if (_e1010[1] > _e1027[1]) {
                                            phi_2073_ = true;
                                        } else {
                                            if (_e1010[1] == _e1027[1]) {
                                                phi_2072_ = (_e1010[0] > _e1027[0]);
                                            } else {
                                                phi_2072_ = false;
                                            }
                                            let _e1038 = phi_2072_;
                                            phi_2073_ = _e1038;
                                        }
                                        let _e1040 = phi_2073_;
                                        let _e1045 = keys.member[_e502.member[0]];
                                        let _e1050 = keys.member[_e502.member[1]];
                                        let _e1052 = function_4(_e1045[2], _e1050[2]);
                                        let _e1056 = keys.member[_e502.member[2]];
                                        let _e1058 = function_4(_e1052, _e1056[2]);
                                        let _e1062 = keys.member[_e500.member[0]];
                                        let _e1067 = keys.member[_e500.member[1]];
                                        let _e1069 = function_5(_e1062[5], _e1067[5]);
                                        let _e1073 = keys.member[_e500.member[2]];
                                        let _e1075 = function_5(_e1069, _e1073[5]);
                                        if (_e1058[1] > _e1075[1]) {
                                            phi_2167_ = true;
                                        } else {
                                            if (_e1058[1] == _e1075[1]) {
                                                phi_2166_ = (_e1058[0] > _e1075[0]);
                                            } else {
                                                phi_2166_ = false;
                                            }
                                            let _e1086 = phi_2166_;
                                            phi_2167_ = _e1086;
                                        }
                                        let _e1088 = phi_2167_;
                                        phi_2171_ = (((!(_e845) && !(_e893)) && (!(_e942) && !(_e990))) && (!(_e1040) && !(_e1088)));
                                    }
                                    let _e1093 = phi_2171_;
                                    phi_2172_ = _e1093;
                                    phi_2173_ = _e798;
                                } else {
                                    phi_2172_ = bool();
                                    phi_2173_ = true;
                                }
                                let _e1095 = phi_2172_;
                                let _e1097 = phi_2173_;
                                if _e1097 {
                                    phi_2177_ = false;
                                } else {
                                    phi_2177_ = true;
                                }
                                let _e1099 = phi_2177_;
                                phi_2178_ = _e1095;
                                phi_2179_ = _e1099;
                            } else {
                                phi_2178_ = false;
                                phi_2179_ = true;
                            }
                            let _e1101 = phi_2178_;
                            let _e1103 = phi_2179_;
                            phi_2180_ = _e1101;
                            phi_2181_ = _e1103;
                        } else {
                            phi_2180_ = false;
                            phi_2181_ = true;
                        }
                        let _e1105 = phi_2180_;
                        let _e1107 = phi_2181_;
                        if _e1107 {
                            phi_2185_ = _e1105;
                        } else {
                            phi_2185_ = true;
                        }
                        let _e1109 = phi_2185_;
                        if _e1109 {
                            let _e1113 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1113 + 1u) < _e1113) {
                                let _e1117 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1113 < _e90) {
                                let _e1119 = (2u * _e1113);
                                atomicStore((&output.member[(4u + _e1119)]), _e500.member_1);
                                atomicStore((&output.member[(_e1119 + 5u)]), _e502.member_1);
                            }
                            let _e1125 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1125 + 1u) < _e1125) {
                                let _e1129 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_2244_ = (_e469 & (_e469 - 1u));
                        phi_2245_ = true;
                    }
                    let _e1131 = phi_2244_;
                    let _e1133 = phi_2245_;
                    phi_995_ = _e1131;
                    phi_2246_ = _e1133;
                } else {
                    phi_995_ = u32();
                    phi_2246_ = false;
                }
                let _e1135 = phi_995_;
                let _e1137 = phi_2246_;
                continue;
                continuing {
                    phi_991_ = _e481;
                    phi_994_ = _e1135;
                    break if !(_e1137);
                }
            }
            workgroupBarrier();
            let _e1140 = atomicLoad((&counters[4u]));
            if (2048u < _e1140) {
                phi_2253_ = 2048u;
            } else {
                phi_2253_ = _e1140;
            }
            let _e1143 = phi_2253_;
            phi_2256_ = type_9(0u, 16u);
            loop {
                let _e1145 = phi_2256_;
                if (_e1145.member < _e1145.member_1) {
                    phi_2257_ = type_9((_e1145.member + 1u), _e1145.member_1);
                    phi_2280_ = type_9(1u, _e1145.member);
                } else {
                    phi_2257_ = _e1145;
                    phi_2280_ = type_9(0u, type_9().member_1);
                }
                let _e1157 = phi_2257_;
                let _e1159 = phi_2280_;
                if (bitcast<i32>(_e1159.member) != 0i) {
                    let _e1165 = (_e71 + (_e1159.member_1 * 128u));
                    if (_e1165 >= _e1143) {
                        phi_8671_ = false;
                    } else {
                        let _e1168 = hits[_e1165];
                        let _e1171 = ((_e1168 >> bitcast<u32>(10i)) & 3u);
                        let _e1178 = firsts[(2u * _e1171)];
                        let _e1179 = (_e1178 + ((_e1168 >> bitcast<u32>(5i)) & 31u));
                        let _e1183 = firsts[((2u * _e1171) + 1u)];
                        let _e1184 = (_e1183 + (_e1168 & 31u));
                        let _e1186 = leaves.member[_e1179];
                        let _e1188 = leaves.member[_e1184];
                        let _e1190 = nodes.member[_e1179];
                        let _e1204 = nodes.member[_e1184];
                        let _e1219 = params.member.member.member_1;
                        if ((_e1219 & 1u) != 0u) {
                            if (_e1188.member[0] == _e1186.member[0]) {
                                phi_2382_ = true;
                            } else {
                                phi_2382_ = (_e1188.member[0] == _e1186.member[0]);
                            }
                            let _e1229 = phi_2382_;
                            if (_e1188.member[1] == _e1186.member[0]) {
                                phi_2389_ = true;
                            } else {
                                phi_2389_ = (_e1188.member[1] == _e1186.member[0]);
                            }
                            let _e1234 = phi_2389_;
                            if (_e1188.member[2] == _e1186.member[0]) {
                                phi_2397_ = true;
                            } else {
                                phi_2397_ = (_e1188.member[2] == _e1186.member[0]);
                            }
                            let _e1240 = phi_2397_;
                            if ((_e1229 || _e1234) || _e1240) {
                                phi_2420_ = false;
                            } else {
                                phi_2420_ = true;
                            }
                            let _e1243 = phi_2420_;
                            phi_2421_ = _e1243;
                        } else {
                            phi_2421_ = true;
                        }
                        let _e1245 = phi_2421_;
                        if _e1245 {
                            let _e1247 = params.member.member.member_1;
                            if ((_e1247 & 2u) != 0u) {
                                let _e1253 = bodies.member[_e1186.member[0]];
                                let _e1257 = bodies.member[_e1188.member[0]];
                                if ((_e1253 / 4u) != (_e1257 / 4u)) {
                                    phi_2466_ = true;
                                } else {
                                    if ((_e1253 & 2u) == 0u) {
                                        phi_2465_ = false;
                                    } else {
                                        phi_2465_ = true;
                                    }
                                    let _e1264 = phi_2465_;
                                    phi_2466_ = _e1264;
                                }
                                let _e1266 = phi_2466_;
                                if _e1266 {
                                    phi_2473_ = (((_e1253 & _e1257) & 1u) == 0u);
                                } else {
                                    phi_2473_ = false;
                                }
                                let _e1271 = phi_2473_;
                                if _e1271 {
                                    let _e1273 = params.member.member.member_1;
                                    if ((_e1273 & 4u) != 0u) {
                                        let _e1278 = params.member.member.member[0u];
                                        let _e1280 = bodies.member[_e1278];
                                        let _e1283 = bodies.member[(_e1278 + 1u)];
                                        let _e1288 = ((_e1278 + 4u) + (2u * (_e1253 >> bitcast<u32>(2i))));
                                        let _e1293 = ((_e1278 + 4u) + (2u * (_e1257 >> bitcast<u32>(2i))));
                                        let _e1295 = bodies.member[_e1288];
                                        let _e1297 = bodies.member[_e1293];
                                        let _e1306 = bodies.member[((((_e1278 + 4u) + (2u * _e1280)) + (_e1295 * _e1283)) + (_e1297 / 32u))];
                                        let _e1309 = bodies.member[(_e1288 + 1u)];
                                        let _e1312 = bodies.member[(_e1293 + 1u)];
                                        if (_e1309 == _e1312) {
                                            if (((_e1306 >> bitcast<u32>(((_e1297 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_2589_ = true;
                                            } else {
                                                phi_2589_ = ((_e1253 >> bitcast<u32>(2i)) == (_e1257 >> bitcast<u32>(2i)));
                                            }
                                            let _e1326 = phi_2589_;
                                            phi_2590_ = _e1326;
                                        } else {
                                            phi_2590_ = false;
                                        }
                                        let _e1328 = phi_2590_;
                                        if _e1328 {
                                            let _e1333 = bodies.member[(_e1278 + 2u)];
                                            let _e1336 = bodies.member[(_e1278 + 3u)];
                                            let _e1337 = (_e1336 + _e1278);
                                            phi_2633_ = type_15(0i, 32i);
                                            phi_2636_ = _e1333;
                                            phi_2638_ = 0u;
                                            loop {
                                                let _e1339 = phi_2633_;
                                                let _e1341 = phi_2636_;
                                                let _e1343 = phi_2638_;
                                                local_5 = _e1343;
                                                local_6 = _e1343;
                                                if (_e1339.member < _e1339.member_1) {
                                                    let _e1350 = (_e1339.member + 1i);
                                                    if ((false == (_e1350 > _e1339.member)) != false) {
                                                        phi_2659_ = true;
                                                    } else {
                                                        phi_2659_ = false;
                                                    }
                                                    let _e1355 = phi_2659_;
                                                    if _e1355 {
                                                        phi_2665_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_2665_ = type_16(1u, _e1350);
                                                    }
                                                    let _e1360 = phi_2665_;
                                                    phi_2634_ = type_15(_e1360.member_1, _e1339.member_1);
                                                    phi_2679_ = type_16(1u, _e1339.member);
                                                } else {
                                                    phi_2634_ = _e1339;
                                                    phi_2679_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e1366 = phi_2634_;
                                                let _e1368 = phi_2679_;
                                                if (bitcast<i32>(_e1368.member) != 0i) {
                                                    if (_e1343 >= _e1341) {
                                                        phi_2762_ = u32();
                                                        phi_2763_ = u32();
                                                        phi_2764_ = false;
                                                    } else {
                                                        let _e1375 = (_e1343 + ((_e1341 - _e1343) / 2u));
                                                        let _e1377 = (_e1337 + (3u * _e1375));
                                                        let _e1379 = bodies.member[_e1377];
                                                        let _e1382 = bodies.member[(_e1377 + 1u)];
                                                        let _e1385 = bodies.member[(_e1377 + 2u)];
                                                        if (_e1379 == 0u) {
                                                            if (_e1382 < _e1186.member_1) {
                                                                phi_2749_ = false;
                                                            } else {
                                                                if (_e1382 == _e1186.member_1) {
                                                                    if (_e1385 < _e1188.member_1) {
                                                                        phi_2747_ = false;
                                                                    } else {
                                                                        phi_2747_ = true;
                                                                    }
                                                                    let _e1391 = phi_2747_;
                                                                    phi_2748_ = _e1391;
                                                                } else {
                                                                    phi_2748_ = true;
                                                                }
                                                                let _e1393 = phi_2748_;
                                                                phi_2749_ = _e1393;
                                                            }
                                                            let _e1395 = phi_2749_;
                                                            phi_2750_ = _e1395;
                                                        } else {
                                                            phi_2750_ = true;
                                                        }
                                                        let _e1397 = phi_2750_;
                                                        if _e1397 {
                                                            phi_2754_ = false;
                                                        } else {
                                                            phi_2754_ = true;
                                                        }
                                                        let _e1399 = phi_2754_;
                                                        if _e1399 {
                                                            phi_2760_ = _e1341;
                                                            phi_2761_ = (_e1375 + 1u);
                                                        } else {
                                                            phi_2760_ = _e1375;
                                                            phi_2761_ = _e1343;
                                                        }
                                                        let _e1402 = phi_2760_;
                                                        let _e1404 = phi_2761_;
                                                        phi_2762_ = _e1402;
                                                        phi_2763_ = _e1404;
                                                        phi_2764_ = true;
                                                    }
                                                    let _e1406 = phi_2762_;
                                                    let _e1408 = phi_2763_;
                                                    let _e1410 = phi_2764_;
                                                    phi_2637_ = _e1406;
                                                    phi_2639_ = _e1408;
                                                    phi_2765_ = _e1410;
                                                } else {
                                                    phi_2637_ = u32();
                                                    phi_2639_ = u32();
                                                    phi_2765_ = false;
                                                }
                                                let _e1412 = phi_2637_;
                                                let _e1414 = phi_2639_;
                                                let _e1416 = phi_2765_;
                                                continue;
                                                continuing {
                                                    phi_2633_ = _e1366;
                                                    phi_2636_ = _e1412;
                                                    phi_2638_ = _e1414;
                                                    break if !(_e1416);
                                                }
                                            }
                                            let _e1419 = local_5;
                                            if (_e1419 < _e1333) {
                                                let _e1422 = local_6;
                                                let _e1424 = (_e1337 + (3u * _e1422));
                                                let _e1426 = bodies.member[_e1424];
                                                if (_e1426 == 0u) {
                                                    let _e1430 = bodies.member[(_e1424 + 1u)];
                                                    if (_e1430 == _e1186.member_1) {
                                                        let _e1434 = bodies.member[(_e1424 + 2u)];
                                                        phi_2813_ = (_e1434 == _e1188.member_1);
                                                        phi_2814_ = false;
                                                    } else {
                                                        phi_2813_ = bool();
                                                        phi_2814_ = true;
                                                    }
                                                    let _e1437 = phi_2813_;
                                                    let _e1439 = phi_2814_;
                                                    phi_2815_ = _e1437;
                                                    phi_2816_ = _e1439;
                                                } else {
                                                    phi_2815_ = bool();
                                                    phi_2816_ = true;
                                                }
                                                let _e1441 = phi_2815_;
                                                let _e1443 = phi_2816_;
                                                if _e1443 {
                                                    phi_2820_ = false;
                                                } else {
                                                    phi_2820_ = _e1441;
                                                }
                                                let _e1445 = phi_2820_;
                                                phi_2821_ = _e1445;
                                            } else {
                                                phi_2821_ = false;
                                            }
                                            let _e1447 = phi_2821_;
                                            phi_2825_ = _e1447;
                                        } else {
                                            phi_2825_ = true;
                                        }
                                        let _e1449 = phi_2825_;
                                        if _e1449 {
                                            phi_2829_ = false;
                                        } else {
                                            phi_2829_ = true;
                                        }
                                        let _e1451 = phi_2829_;
                                        phi_2830_ = _e1451;
                                    } else {
                                        phi_2830_ = true;
                                    }
                                    let _e1453 = phi_2830_;
                                    if _e1453 {
                                        phi_2834_ = false;
                                    } else {
                                        phi_2834_ = true;
                                    }
                                    let _e1455 = phi_2834_;
                                    phi_2835_ = _e1455;
                                } else {
                                    phi_2835_ = true;
                                }
                                let _e1457 = phi_2835_;
                                if _e1457 {
                                    phi_2839_ = false;
                                } else {
                                    phi_2839_ = true;
                                }
                                let _e1459 = phi_2839_;
                                phi_2840_ = _e1459;
                            } else {
                                phi_2840_ = true;
                            }
                            let _e1461 = phi_2840_;
                            if _e1461 {
                                let _e1463 = params.member.member.member_1;
                                if ((_e1463 & 32u) != 0u) {
                                    let _e1467 = params.member.member.member_6;
                                    let _e1484 = (((((_e1190.member_1.y - _e1204.member.x) > _e1467) && ((_e1204.member_1.y - _e1190.member.x) > _e1467)) && (((_e1190.member_2.x - _e1204.member.y) > _e1467) && ((_e1204.member_2.x - _e1190.member.y) > _e1467))) && (((_e1190.member_2.y - _e1204.member_1.x) > _e1467) && ((_e1204.member_2.y - _e1190.member_1.x) > _e1467)));
                                    if _e1484 {
                                        phi_3442_ = bool();
                                    } else {
                                        let _e1488 = keys.member[_e1186.member[0]];
                                        let _e1493 = keys.member[_e1186.member[1]];
                                        let _e1495 = function_(_e1488[0], _e1493[0]);
                                        let _e1499 = keys.member[_e1186.member[2]];
                                        let _e1501 = function_(_e1495, _e1499[0]);
                                        let _e1505 = keys.member[_e1188.member[0]];
                                        let _e1510 = keys.member[_e1188.member[1]];
                                        let _e1512 = function_1(_e1505[3], _e1510[3]);
                                        let _e1516 = keys.member[_e1188.member[2]];
                                        let _e1518 = function_1(_e1512, _e1516[3]);
                                        if (_e1501[1] > _e1518[1]) {
                                            phi_2965_ = true;
                                        } else {
                                            if (_e1501[1] == _e1518[1]) {
                                                phi_2964_ = (_e1501[0] > _e1518[0]);
                                            } else {
                                                phi_2964_ = false;
                                            }
                                            let _e1529 = phi_2964_;
                                            phi_2965_ = _e1529;
                                        }
                                        let _e1531 = phi_2965_;
                                        let _e1536 = keys.member[_e1188.member[0]];
                                        let _e1541 = keys.member[_e1188.member[1]];
                                        let _e1543 = function_(_e1536[0], _e1541[0]);
                                        let _e1547 = keys.member[_e1188.member[2]];
                                        let _e1549 = function_(_e1543, _e1547[0]);
                                        let _e1553 = keys.member[_e1186.member[0]];
                                        let _e1558 = keys.member[_e1186.member[1]];
                                        let _e1560 = function_1(_e1553[3], _e1558[3]);
                                        let _e1564 = keys.member[_e1186.member[2]];
                                        let _e1566 = function_1(_e1560, _e1564[3]);
                                        if (_e1549[1] > _e1566[1]) {
                                            phi_3059_ = true;
                                        } else {
                                            if (_e1549[1] == _e1566[1]) {
                                                phi_3058_ = (_e1549[0] > _e1566[0]);
                                            } else {
                                                phi_3058_ = false;
                                            }
                                            let _e1577 = phi_3058_;
                                            phi_3059_ = _e1577;
                                        }
                                        let _e1579 = phi_3059_;
                                        let _e1585 = keys.member[_e1186.member[0]];
                                        let _e1590 = keys.member[_e1186.member[1]];
                                        let _e1592 = function_2(_e1585[1], _e1590[1]);
                                        let _e1596 = keys.member[_e1186.member[2]];
                                        let _e1598 = function_2(_e1592, _e1596[1]);
                                        let _e1602 = keys.member[_e1188.member[0]];
                                        let _e1607 = keys.member[_e1188.member[1]];
                                        let _e1609 = function_3(_e1602[4], _e1607[4]);
                                        let _e1613 = keys.member[_e1188.member[2]];
                                        let _e1615 = function_3(_e1609, _e1613[4]);
                                        if (_e1598[1] > _e1615[1]) {
                                            phi_3154_ = true;
                                        } else {
                                            if (_e1598[1] == _e1615[1]) {
                                                phi_3153_ = (_e1598[0] > _e1615[0]);
                                            } else {
                                                phi_3153_ = false;
                                            }
                                            let _e1626 = phi_3153_;
                                            phi_3154_ = _e1626;
                                        }
                                        let _e1628 = phi_3154_;
                                        let _e1633 = keys.member[_e1188.member[0]];
                                        let _e1638 = keys.member[_e1188.member[1]];
                                        let _e1640 = function_2(_e1633[1], _e1638[1]);
                                        let _e1644 = keys.member[_e1188.member[2]];
                                        let _e1646 = function_2(_e1640, _e1644[1]);
                                        let _e1650 = keys.member[_e1186.member[0]];
                                        let _e1655 = keys.member[_e1186.member[1]];
                                        let _e1657 = function_3(_e1650[4], _e1655[4]);
                                        let _e1661 = keys.member[_e1186.member[2]];
                                        let _e1663 = function_3(_e1657, _e1661[4]);
                                        if (_e1646[1] > _e1663[1]) {
                                            phi_3248_ = true;
                                        } else {
                                            if (_e1646[1] == _e1663[1]) {
                                                phi_3247_ = (_e1646[0] > _e1663[0]);
                                            } else {
                                                phi_3247_ = false;
                                            }
                                            let _e1674 = phi_3247_;
                                            phi_3248_ = _e1674;
                                        }
                                        let _e1676 = phi_3248_;
                                        let _e1683 = keys.member[_e1186.member[0]];
                                        let _e1688 = keys.member[_e1186.member[1]];
                                        let _e1690 = function_4(_e1683[2], _e1688[2]);
                                        let _e1694 = keys.member[_e1186.member[2]];
                                        let _e1696 = function_4(_e1690, _e1694[2]);
                                        let _e1700 = keys.member[_e1188.member[0]];
                                        let _e1705 = keys.member[_e1188.member[1]];
                                        let _e1707 = function_5(_e1700[5], _e1705[5]);
                                        let _e1711 = keys.member[_e1188.member[2]];
                                        let _e1713 = function_5(_e1707, _e1711[5]);
                                        if (_e1696[1] > _e1713[1]) {
                                            phi_3344_ = true;
                                        } else {
                                            if (_e1696[1] == _e1713[1]) {
                                                phi_3343_ = (_e1696[0] > _e1713[0]);
                                            } else {
                                                phi_3343_ = false;
                                            }
                                            let _e1724 = phi_3343_;
                                            phi_3344_ = _e1724;
                                        }
                                        let _e1726 = phi_3344_;
                                        let _e1731 = keys.member[_e1188.member[0]];
                                        let _e1736 = keys.member[_e1188.member[1]];
                                        let _e1738 = function_4(_e1731[2], _e1736[2]);
                                        let _e1742 = keys.member[_e1188.member[2]];
                                        let _e1744 = function_4(_e1738, _e1742[2]);
                                        let _e1748 = keys.member[_e1186.member[0]];
                                        let _e1753 = keys.member[_e1186.member[1]];
                                        let _e1755 = function_5(_e1748[5], _e1753[5]);
                                        let _e1759 = keys.member[_e1186.member[2]];
                                        let _e1761 = function_5(_e1755, _e1759[5]);
                                        if (_e1744[1] > _e1761[1]) {
                                            phi_3438_ = true;
                                        } else {
                                            if (_e1744[1] == _e1761[1]) {
                                                phi_3437_ = (_e1744[0] > _e1761[0]);
                                            } else {
                                                phi_3437_ = false;
                                            }
                                            let _e1772 = phi_3437_;
                                            phi_3438_ = _e1772;
                                        }
                                        let _e1774 = phi_3438_;
                                        phi_3442_ = (((!(_e1531) && !(_e1579)) && (!(_e1628) && !(_e1676))) && (!(_e1726) && !(_e1774)));
                                    }
                                    let _e1779 = phi_3442_;
                                    phi_3443_ = _e1779;
                                    phi_3444_ = _e1484;
                                } else {
                                    phi_3443_ = bool();
                                    phi_3444_ = true;
                                }
                                let _e1781 = phi_3443_;
                                let _e1783 = phi_3444_;
                                if _e1783 {
                                    phi_3448_ = false;
                                } else {
                                    phi_3448_ = true;
                                }
                                let _e1785 = phi_3448_;
                                phi_3449_ = _e1781;
                                phi_3450_ = _e1785;
                            } else {
                                phi_3449_ = false;
                                phi_3450_ = true;
                            }
                            let _e1787 = phi_3449_;
                            let _e1789 = phi_3450_;
                            phi_3451_ = _e1787;
                            phi_3452_ = _e1789;
                        } else {
                            phi_3451_ = false;
                            phi_3452_ = true;
                        }
                        let _e1791 = phi_3451_;
                        let _e1793 = phi_3452_;
                        if _e1793 {
                            phi_3456_ = _e1791;
                        } else {
                            phi_3456_ = true;
                        }
                        let _e1795 = phi_3456_;
                        if _e1795 {
                            let _e1797 = atomicAdd((&counters[7u]), 1u);
                            let _e1808 = params.member.member.member_4;
                            let _e1810 = params.member.member.member_5;
                            let _e1812 = paths.member[_e1186.member[0]];
                            let _e1814 = paths.member[_e1188.member[0]];
                            let _e1820 = paths.member[_e1188.member[1]];
                            let _e1822 = paths.member[_e1188.member[2]];
                            local_2 = type_41(array<array<f32, 3>, 2>(array<f32, 3>((_e1812.member[0] - _e1814.member[0]), (_e1812.member[1] - _e1814.member[1]), (_e1812.member[2] - _e1814.member[2])), array<f32, 3>((_e1812.member_1[0] - _e1814.member_1[0]), (_e1812.member_1[1] - _e1814.member_1[1]), (_e1812.member_1[2] - _e1814.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1820.member[0] - _e1814.member[0]), (_e1820.member[1] - _e1814.member[1]), (_e1820.member[2] - _e1814.member[2])), array<f32, 3>((_e1820.member_1[0] - _e1814.member_1[0]), (_e1820.member_1[1] - _e1814.member_1[1]), (_e1820.member_1[2] - _e1814.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1822.member[0] - _e1814.member[0]), (_e1822.member[1] - _e1814.member[1]), (_e1822.member[2] - _e1814.member[2])), array<f32, 3>((_e1822.member_1[0] - _e1814.member_1[0]), (_e1822.member_1[1] - _e1814.member_1[1]), (_e1822.member_1[2] - _e1814.member_1[2]))), (_e1808 + _e1808));
                            let _e1882 = local_2.member_1[0u];
                            let _e1888 = local_2.member_2[0u];
                            let _e1894 = ((_e1882[1] * _e1888[2]) - (_e1882[2] * _e1888[1]));
                            let _e1897 = ((_e1882[2] * _e1888[0]) - (_e1882[0] * _e1888[2]));
                            let _e1900 = ((_e1882[0] * _e1888[1]) - (_e1882[1] * _e1888[0]));
                            let _e1903 = local_2.member_1[1u];
                            let _e1909 = local_2.member_2[1u];
                            let _e1915 = ((_e1903[1] * _e1909[2]) - (_e1903[2] * _e1909[1]));
                            let _e1918 = ((_e1903[2] * _e1909[0]) - (_e1903[0] * _e1909[2]));
                            let _e1921 = ((_e1903[0] * _e1909[1]) - (_e1903[1] * _e1909[0]));
                            let _e1924 = local_2.member_1[0u];
                            let _e1930 = local_2.member_2[1u];
                            let _e1945 = local_2.member_1[1u];
                            let _e1951 = local_2.member_2[0u];
                            let _e1964 = (((_e1924[1] * _e1930[2]) - (_e1924[2] * _e1930[1])) + ((_e1945[1] * _e1951[2]) - (_e1945[2] * _e1951[1])));
                            let _e1965 = (((_e1924[2] * _e1930[0]) - (_e1924[0] * _e1930[2])) + ((_e1945[2] * _e1951[0]) - (_e1945[0] * _e1951[2])));
                            let _e1966 = (((_e1924[0] * _e1930[1]) - (_e1924[1] * _e1930[0])) + ((_e1945[0] * _e1951[1]) - (_e1945[1] * _e1951[0])));
                            let _e1969 = local_2.member[0u];
                            let _e1980 = local_2.member[1u];
                            let _e1991 = local_2.member[0u];
                            let _e2000 = ((((_e1980[0] * _e1894) + (_e1980[1] * _e1897)) + (_e1980[2] * _e1900)) + (((_e1991[0] * _e1964) + (_e1991[1] * _e1965)) + (_e1991[2] * _e1966)));
                            let _e2003 = local_2.member[0u];
                            let _e2014 = local_2.member[1u];
                            let _e2023 = ((((_e2003[0] * _e1915) + (_e2003[1] * _e1918)) + (_e2003[2] * _e1921)) + (((_e2014[0] * _e1964) + (_e2014[1] * _e1965)) + (_e2014[2] * _e1966)));
                            let _e2026 = local_2.member[1u];
                            let _e2037 = local_2.member[0u];
                            if (_e2037[0] < 0f) {
                                phi_3885_ = -(_e2037[0]);
                            } else {
                                phi_3885_ = _e2037[0];
                            }
                            let _e2044 = phi_3885_;
                            if (_e2037[1] < 0f) {
                                phi_3892_ = -(_e2037[1]);
                            } else {
                                phi_3892_ = _e2037[1];
                            }
                            let _e2048 = phi_3892_;
                            if (_e2044 > _e2048) {
                                phi_3897_ = _e2044;
                            } else {
                                phi_3897_ = _e2048;
                            }
                            let _e2051 = phi_3897_;
                            if (_e2037[2] < 0f) {
                                phi_3904_ = -(_e2037[2]);
                            } else {
                                phi_3904_ = _e2037[2];
                            }
                            let _e2055 = phi_3904_;
                            if (_e2051 > _e2055) {
                                phi_3909_ = _e2051;
                            } else {
                                phi_3909_ = _e2055;
                            }
                            let _e2058 = phi_3909_;
                            let _e2061 = local_2.member[1u];
                            if (_e2061[0] < 0f) {
                                phi_3922_ = -(_e2061[0]);
                            } else {
                                phi_3922_ = _e2061[0];
                            }
                            let _e2068 = phi_3922_;
                            if (_e2061[1] < 0f) {
                                phi_3929_ = -(_e2061[1]);
                            } else {
                                phi_3929_ = _e2061[1];
                            }
                            let _e2072 = phi_3929_;
                            if (_e2068 > _e2072) {
                                phi_3934_ = _e2068;
                            } else {
                                phi_3934_ = _e2072;
                            }
                            let _e2075 = phi_3934_;
                            if (_e2061[2] < 0f) {
                                phi_3941_ = -(_e2061[2]);
                            } else {
                                phi_3941_ = _e2061[2];
                            }
                            let _e2079 = phi_3941_;
                            if (_e2075 > _e2079) {
                                phi_3946_ = _e2075;
                            } else {
                                phi_3946_ = _e2079;
                            }
                            let _e2082 = phi_3946_;
                            if (_e2058 > _e2082) {
                                phi_3951_ = _e2058;
                            } else {
                                phi_3951_ = _e2082;
                            }
                            let _e2085 = phi_3951_;
                            let _e2087 = local_2.member_3;
                            let _e2088 = (_e2085 + _e2087);
                            let _e2091 = local_2.member_1[0u];
                            if (_e2091[0] < 0f) {
                                phi_3968_ = -(_e2091[0]);
                            } else {
                                phi_3968_ = _e2091[0];
                            }
                            let _e2098 = phi_3968_;
                            if (_e2091[1] < 0f) {
                                phi_3975_ = -(_e2091[1]);
                            } else {
                                phi_3975_ = _e2091[1];
                            }
                            let _e2102 = phi_3975_;
                            if (_e2098 > _e2102) {
                                phi_3980_ = _e2098;
                            } else {
                                phi_3980_ = _e2102;
                            }
                            let _e2105 = phi_3980_;
                            if (_e2091[2] < 0f) {
                                phi_3987_ = -(_e2091[2]);
                            } else {
                                phi_3987_ = _e2091[2];
                            }
                            let _e2109 = phi_3987_;
                            if (_e2105 > _e2109) {
                                phi_3992_ = _e2105;
                            } else {
                                phi_3992_ = _e2109;
                            }
                            let _e2112 = phi_3992_;
                            let _e2115 = local_2.member_1[1u];
                            if (_e2115[0] < 0f) {
                                phi_4006_ = -(_e2115[0]);
                            } else {
                                phi_4006_ = _e2115[0];
                            }
                            let _e2122 = phi_4006_;
                            if (_e2115[1] < 0f) {
                                phi_4013_ = -(_e2115[1]);
                            } else {
                                phi_4013_ = _e2115[1];
                            }
                            let _e2126 = phi_4013_;
                            if (_e2122 > _e2126) {
                                phi_4018_ = _e2122;
                            } else {
                                phi_4018_ = _e2126;
                            }
                            let _e2129 = phi_4018_;
                            if (_e2115[2] < 0f) {
                                phi_4025_ = -(_e2115[2]);
                            } else {
                                phi_4025_ = _e2115[2];
                            }
                            let _e2133 = phi_4025_;
                            if (_e2129 > _e2133) {
                                phi_4030_ = _e2129;
                            } else {
                                phi_4030_ = _e2133;
                            }
                            let _e2136 = phi_4030_;
                            if (_e2112 > _e2136) {
                                phi_4035_ = _e2112;
                            } else {
                                phi_4035_ = _e2136;
                            }
                            let _e2139 = phi_4035_;
                            let _e2141 = local_2.member_3;
                            let _e2142 = (_e2139 + _e2141);
                            let _e2145 = local_2.member_2[0u];
                            if (_e2145[0] < 0f) {
                                phi_4052_ = -(_e2145[0]);
                            } else {
                                phi_4052_ = _e2145[0];
                            }
                            let _e2152 = phi_4052_;
                            if (_e2145[1] < 0f) {
                                phi_4059_ = -(_e2145[1]);
                            } else {
                                phi_4059_ = _e2145[1];
                            }
                            let _e2156 = phi_4059_;
                            if (_e2152 > _e2156) {
                                phi_4064_ = _e2152;
                            } else {
                                phi_4064_ = _e2156;
                            }
                            let _e2159 = phi_4064_;
                            if (_e2145[2] < 0f) {
                                phi_4071_ = -(_e2145[2]);
                            } else {
                                phi_4071_ = _e2145[2];
                            }
                            let _e2163 = phi_4071_;
                            if (_e2159 > _e2163) {
                                phi_4076_ = _e2159;
                            } else {
                                phi_4076_ = _e2163;
                            }
                            let _e2166 = phi_4076_;
                            let _e2169 = local_2.member_2[1u];
                            if (_e2169[0] < 0f) {
                                phi_4090_ = -(_e2169[0]);
                            } else {
                                phi_4090_ = _e2169[0];
                            }
                            let _e2176 = phi_4090_;
                            if (_e2169[1] < 0f) {
                                phi_4097_ = -(_e2169[1]);
                            } else {
                                phi_4097_ = _e2169[1];
                            }
                            let _e2180 = phi_4097_;
                            if (_e2176 > _e2180) {
                                phi_4102_ = _e2176;
                            } else {
                                phi_4102_ = _e2180;
                            }
                            let _e2183 = phi_4102_;
                            if (_e2169[2] < 0f) {
                                phi_4109_ = -(_e2169[2]);
                            } else {
                                phi_4109_ = _e2169[2];
                            }
                            let _e2187 = phi_4109_;
                            if (_e2183 > _e2187) {
                                phi_4114_ = _e2183;
                            } else {
                                phi_4114_ = _e2187;
                            }
                            let _e2190 = phi_4114_;
                            if (_e2166 > _e2190) {
                                phi_4119_ = _e2166;
                            } else {
                                phi_4119_ = _e2190;
                            }
                            let _e2193 = phi_4119_;
                            let _e2195 = local_2.member_3;
                            let _e2196 = (_e2193 + _e2195);
                            let _e2198 = ((_e2142 * 8f) * _e2196);
                            let _e2205 = local_2.member_3;
                            if (_e1894 < 0f) {
                                phi_4150_ = -(_e1894);
                            } else {
                                phi_4150_ = _e1894;
                            }
                            let _e2222 = phi_4150_;
                            if (_e1897 < 0f) {
                                phi_4156_ = -(_e1897);
                            } else {
                                phi_4156_ = _e1897;
                            }
                            let _e2226 = phi_4156_;
                            if (_e1900 < 0f) {
                                phi_4163_ = -(_e1900);
                            } else {
                                phi_4163_ = _e1900;
                            }
                            let _e2231 = phi_4163_;
                            let _e2232 = ((_e2222 + _e2226) + _e2231);
                            if (_e1915 < 0f) {
                                phi_4170_ = -(_e1915);
                            } else {
                                phi_4170_ = _e1915;
                            }
                            let _e2236 = phi_4170_;
                            if (_e1918 < 0f) {
                                phi_4176_ = -(_e1918);
                            } else {
                                phi_4176_ = _e1918;
                            }
                            let _e2240 = phi_4176_;
                            if (_e1921 < 0f) {
                                phi_4183_ = -(_e1921);
                            } else {
                                phi_4183_ = _e1921;
                            }
                            let _e2245 = phi_4183_;
                            let _e2246 = ((_e2236 + _e2240) + _e2245);
                            if (_e2232 > _e2246) {
                                phi_4189_ = _e2232;
                            } else {
                                phi_4189_ = _e2246;
                            }
                            let _e2249 = phi_4189_;
                            if (_e1964 < 0f) {
                                phi_4195_ = -(_e1964);
                            } else {
                                phi_4195_ = _e1964;
                            }
                            let _e2253 = phi_4195_;
                            if (_e1965 < 0f) {
                                phi_4201_ = -(_e1965);
                            } else {
                                phi_4201_ = _e1965;
                            }
                            let _e2257 = phi_4201_;
                            if (_e1966 < 0f) {
                                phi_4208_ = -(_e1966);
                            } else {
                                phi_4208_ = _e1966;
                            }
                            let _e2262 = phi_4208_;
                            let _e2264 = (((_e2253 + _e2257) + _e2262) * 0.5f);
                            if (_e2249 > _e2264) {
                                phi_4215_ = _e2249;
                            } else {
                                phi_4215_ = _e2264;
                            }
                            let _e2267 = phi_4215_;
                            let _e2272 = local_2.member_3;
                            let _e2285 = ((((_e1969[0] * _e1894) + (_e1969[1] * _e1897)) + (_e1969[2] * _e1900)) * 3f);
                            let _e2286 = ((((_e2026[0] * _e1915) + (_e2026[1] * _e1918)) + (_e2026[2] * _e1921)) * 3f);
                            if (_e2285 < _e2286) {
                                phi_4239_ = _e2285;
                            } else {
                                phi_4239_ = _e2286;
                            }
                            let _e2289 = phi_4239_;
                            if (_e2000 < _e2023) {
                                phi_4244_ = _e2000;
                            } else {
                                phi_4244_ = _e2023;
                            }
                            let _e2292 = phi_4244_;
                            if (_e2289 < _e2292) {
                                phi_4249_ = _e2289;
                            } else {
                                phi_4249_ = _e2292;
                            }
                            let _e2295 = phi_4249_;
                            if (_e2285 > _e2286) {
                                phi_4254_ = _e2285;
                            } else {
                                phi_4254_ = _e2286;
                            }
                            let _e2298 = phi_4254_;
                            if (_e2000 > _e2023) {
                                phi_4259_ = _e2000;
                            } else {
                                phi_4259_ = _e2023;
                            }
                            let _e2301 = phi_4259_;
                            if (_e2298 > _e2301) {
                                phi_4264_ = _e2298;
                            } else {
                                phi_4264_ = _e2301;
                            }
                            let _e2304 = phi_4264_;
                            let _e2309 = -(_e2304);
                            if (_e2295 > _e2309) {
                                phi_4274_ = _e2295;
                            } else {
                                phi_4274_ = _e2309;
                            }
                            let _e2312 = phi_4274_;
                            let _e2314 = ((_e2312 - ((((((_e2088 * 8f) * _e2198) * (0.000000059604645f * (524f / 64f))) + ((_e2205 * 19f) * ((_e2088 * (_e2142 + _e2196)) + (_e2142 * _e2196)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2088) * ((1f + _e2142) * (1f + _e2196))))) + ((_e1810 * (((_e2267 + (_e2198 * (0.000000059604645f * 8f))) + ((_e2272 * 6f) * (_e2142 + _e2196))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2142) * (1f + _e2196))))) * (3f * 1.0001f)))) > 0f);
                            if _e2314 {
                                phi_5243_ = _e2314;
                            } else {
                                let _e2317 = local_2.member_1[0u];
                                let _e2323 = local_2.member_1[1u];
                                let _e2327 = (_e2317[0] + _e2323[0]);
                                let _e2328 = (_e2317[1] + _e2323[1]);
                                let _e2329 = (_e2317[2] + _e2323[2]);
                                let _e2332 = local_2.member_2[0u];
                                let _e2338 = local_2.member_2[1u];
                                let _e2342 = (_e2332[0] + _e2338[0]);
                                let _e2343 = (_e2332[1] + _e2338[1]);
                                let _e2344 = (_e2332[2] + _e2338[2]);
                                let _e2347 = ((_e2328 * _e2344) - (_e2329 * _e2343));
                                let _e2350 = ((_e2329 * _e2342) - (_e2327 * _e2344));
                                let _e2353 = ((_e2327 * _e2343) - (_e2328 * _e2342));
                                let _e2356 = local_2.member[0u];
                                let _e2362 = local_2.member_1[0u];
                                let _e2368 = local_2.member_2[0u];
                                let _e2372 = (_e2356[0] - _e2362[0]);
                                let _e2373 = (_e2356[1] - _e2362[1]);
                                let _e2374 = (_e2356[2] - _e2362[2]);
                                let _e2375 = (_e2356[0] - _e2368[0]);
                                let _e2376 = (_e2356[1] - _e2368[1]);
                                let _e2377 = (_e2356[2] - _e2368[2]);
                                let _e2380 = local_2.member[1u];
                                let _e2386 = local_2.member_1[1u];
                                let _e2392 = local_2.member_2[1u];
                                let _e2396 = (_e2380[0] - _e2386[0]);
                                let _e2397 = (_e2380[1] - _e2386[1]);
                                let _e2398 = (_e2380[2] - _e2386[2]);
                                let _e2399 = (_e2380[0] - _e2392[0]);
                                let _e2400 = (_e2380[1] - _e2392[1]);
                                let _e2401 = (_e2380[2] - _e2392[2]);
                                let _e2404 = local_2.member[0u];
                                if (_e2404[0] < 0f) {
                                    phi_4477_ = -(_e2404[0]);
                                } else {
                                    phi_4477_ = _e2404[0];
                                }
                                let _e2411 = phi_4477_;
                                if (_e2404[1] < 0f) {
                                    phi_4484_ = -(_e2404[1]);
                                } else {
                                    phi_4484_ = _e2404[1];
                                }
                                let _e2415 = phi_4484_;
                                if (_e2411 > _e2415) {
                                    phi_4489_ = _e2411;
                                } else {
                                    phi_4489_ = _e2415;
                                }
                                let _e2418 = phi_4489_;
                                if (_e2404[2] < 0f) {
                                    phi_4496_ = -(_e2404[2]);
                                } else {
                                    phi_4496_ = _e2404[2];
                                }
                                let _e2422 = phi_4496_;
                                if (_e2418 > _e2422) {
                                    phi_4501_ = _e2418;
                                } else {
                                    phi_4501_ = _e2422;
                                }
                                let _e2425 = phi_4501_;
                                let _e2428 = local_2.member[1u];
                                if (_e2428[0] < 0f) {
                                    phi_4514_ = -(_e2428[0]);
                                } else {
                                    phi_4514_ = _e2428[0];
                                }
                                let _e2435 = phi_4514_;
                                if (_e2428[1] < 0f) {
                                    phi_4521_ = -(_e2428[1]);
                                } else {
                                    phi_4521_ = _e2428[1];
                                }
                                let _e2439 = phi_4521_;
                                if (_e2435 > _e2439) {
                                    phi_4526_ = _e2435;
                                } else {
                                    phi_4526_ = _e2439;
                                }
                                let _e2442 = phi_4526_;
                                if (_e2428[2] < 0f) {
                                    phi_4533_ = -(_e2428[2]);
                                } else {
                                    phi_4533_ = _e2428[2];
                                }
                                let _e2446 = phi_4533_;
                                if (_e2442 > _e2446) {
                                    phi_4538_ = _e2442;
                                } else {
                                    phi_4538_ = _e2446;
                                }
                                let _e2449 = phi_4538_;
                                if (_e2425 > _e2449) {
                                    phi_4543_ = _e2425;
                                } else {
                                    phi_4543_ = _e2449;
                                }
                                let _e2452 = phi_4543_;
                                let _e2454 = local_2.member_3;
                                let _e2458 = local_2.member_1[0u];
                                if (_e2458[0] < 0f) {
                                    phi_4560_ = -(_e2458[0]);
                                } else {
                                    phi_4560_ = _e2458[0];
                                }
                                let _e2465 = phi_4560_;
                                if (_e2458[1] < 0f) {
                                    phi_4567_ = -(_e2458[1]);
                                } else {
                                    phi_4567_ = _e2458[1];
                                }
                                let _e2469 = phi_4567_;
                                if (_e2465 > _e2469) {
                                    phi_4572_ = _e2465;
                                } else {
                                    phi_4572_ = _e2469;
                                }
                                let _e2472 = phi_4572_;
                                if (_e2458[2] < 0f) {
                                    phi_4579_ = -(_e2458[2]);
                                } else {
                                    phi_4579_ = _e2458[2];
                                }
                                let _e2476 = phi_4579_;
                                if (_e2472 > _e2476) {
                                    phi_4584_ = _e2472;
                                } else {
                                    phi_4584_ = _e2476;
                                }
                                let _e2479 = phi_4584_;
                                let _e2482 = local_2.member_1[1u];
                                if (_e2482[0] < 0f) {
                                    phi_4598_ = -(_e2482[0]);
                                } else {
                                    phi_4598_ = _e2482[0];
                                }
                                let _e2489 = phi_4598_;
                                if (_e2482[1] < 0f) {
                                    phi_4605_ = -(_e2482[1]);
                                } else {
                                    phi_4605_ = _e2482[1];
                                }
                                let _e2493 = phi_4605_;
                                if (_e2489 > _e2493) {
                                    phi_4610_ = _e2489;
                                } else {
                                    phi_4610_ = _e2493;
                                }
                                let _e2496 = phi_4610_;
                                if (_e2482[2] < 0f) {
                                    phi_4617_ = -(_e2482[2]);
                                } else {
                                    phi_4617_ = _e2482[2];
                                }
                                let _e2500 = phi_4617_;
                                if (_e2496 > _e2500) {
                                    phi_4622_ = _e2496;
                                } else {
                                    phi_4622_ = _e2500;
                                }
                                let _e2503 = phi_4622_;
                                if (_e2479 > _e2503) {
                                    phi_4627_ = _e2479;
                                } else {
                                    phi_4627_ = _e2503;
                                }
                                let _e2506 = phi_4627_;
                                let _e2508 = local_2.member_3;
                                let _e2512 = local_2.member_2[0u];
                                if (_e2512[0] < 0f) {
                                    phi_4644_ = -(_e2512[0]);
                                } else {
                                    phi_4644_ = _e2512[0];
                                }
                                let _e2519 = phi_4644_;
                                if (_e2512[1] < 0f) {
                                    phi_4651_ = -(_e2512[1]);
                                } else {
                                    phi_4651_ = _e2512[1];
                                }
                                let _e2523 = phi_4651_;
                                if (_e2519 > _e2523) {
                                    phi_4656_ = _e2519;
                                } else {
                                    phi_4656_ = _e2523;
                                }
                                let _e2526 = phi_4656_;
                                if (_e2512[2] < 0f) {
                                    phi_4663_ = -(_e2512[2]);
                                } else {
                                    phi_4663_ = _e2512[2];
                                }
                                let _e2530 = phi_4663_;
                                if (_e2526 > _e2530) {
                                    phi_4668_ = _e2526;
                                } else {
                                    phi_4668_ = _e2530;
                                }
                                let _e2533 = phi_4668_;
                                let _e2536 = local_2.member_2[1u];
                                if (_e2536[0] < 0f) {
                                    phi_4682_ = -(_e2536[0]);
                                } else {
                                    phi_4682_ = _e2536[0];
                                }
                                let _e2543 = phi_4682_;
                                if (_e2536[1] < 0f) {
                                    phi_4689_ = -(_e2536[1]);
                                } else {
                                    phi_4689_ = _e2536[1];
                                }
                                let _e2547 = phi_4689_;
                                if (_e2543 > _e2547) {
                                    phi_4694_ = _e2543;
                                } else {
                                    phi_4694_ = _e2547;
                                }
                                let _e2550 = phi_4694_;
                                if (_e2536[2] < 0f) {
                                    phi_4701_ = -(_e2536[2]);
                                } else {
                                    phi_4701_ = _e2536[2];
                                }
                                let _e2554 = phi_4701_;
                                if (_e2550 > _e2554) {
                                    phi_4706_ = _e2550;
                                } else {
                                    phi_4706_ = _e2554;
                                }
                                let _e2557 = phi_4706_;
                                if (_e2533 > _e2557) {
                                    phi_4711_ = _e2533;
                                } else {
                                    phi_4711_ = _e2557;
                                }
                                let _e2560 = phi_4711_;
                                let _e2562 = local_2.member_3;
                                let _e2566 = ((((_e2452 + _e2454) + (_e2506 + _e2508)) + (_e2560 + _e2562)) * 2f);
                                let _e2569 = local_2.member_3;
                                let _e2573 = (((_e1810 * 1.0001f) + (_e2569 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2576 = ((_e2350 * _e2329) - (_e2353 * _e2328));
                                let _e2579 = ((_e2353 * _e2327) - (_e2347 * _e2329));
                                let _e2582 = ((_e2347 * _e2328) - (_e2350 * _e2327));
                                let _e2587 = (((_e2576 * _e2356[0]) + (_e2579 * _e2356[1])) + (_e2582 * _e2356[2]));
                                let _e2592 = (((_e2576 * _e2372) + (_e2579 * _e2373)) + (_e2582 * _e2374));
                                let _e2597 = (((_e2576 * _e2375) + (_e2579 * _e2376)) + (_e2582 * _e2377));
                                let _e2602 = (((_e2576 * _e2356[0]) + (_e2579 * _e2356[1])) + (_e2582 * _e2356[2]));
                                let _e2607 = (((_e2576 * _e2380[0]) + (_e2579 * _e2380[1])) + (_e2582 * _e2380[2]));
                                let _e2612 = (((_e2576 * _e2396) + (_e2579 * _e2397)) + (_e2582 * _e2398));
                                let _e2617 = (((_e2576 * _e2399) + (_e2579 * _e2400)) + (_e2582 * _e2401));
                                let _e2622 = (((_e2576 * _e2380[0]) + (_e2579 * _e2380[1])) + (_e2582 * _e2380[2]));
                                if (_e2587 < _e2592) {
                                    phi_4790_ = _e2587;
                                } else {
                                    phi_4790_ = _e2592;
                                }
                                let _e2625 = phi_4790_;
                                if (_e2597 < _e2602) {
                                    phi_4795_ = _e2597;
                                } else {
                                    phi_4795_ = _e2602;
                                }
                                let _e2628 = phi_4795_;
                                if (_e2625 < _e2628) {
                                    phi_4800_ = _e2625;
                                } else {
                                    phi_4800_ = _e2628;
                                }
                                let _e2631 = phi_4800_;
                                if (_e2607 < _e2612) {
                                    phi_4805_ = _e2607;
                                } else {
                                    phi_4805_ = _e2612;
                                }
                                let _e2634 = phi_4805_;
                                if (_e2617 < _e2622) {
                                    phi_4810_ = _e2617;
                                } else {
                                    phi_4810_ = _e2622;
                                }
                                let _e2637 = phi_4810_;
                                if (_e2634 < _e2637) {
                                    phi_4815_ = _e2634;
                                } else {
                                    phi_4815_ = _e2637;
                                }
                                let _e2640 = phi_4815_;
                                if (_e2631 < _e2640) {
                                    phi_4820_ = _e2631;
                                } else {
                                    phi_4820_ = _e2640;
                                }
                                let _e2643 = phi_4820_;
                                if (_e2587 > _e2592) {
                                    phi_4825_ = _e2587;
                                } else {
                                    phi_4825_ = _e2592;
                                }
                                let _e2646 = phi_4825_;
                                if (_e2597 > _e2602) {
                                    phi_4830_ = _e2597;
                                } else {
                                    phi_4830_ = _e2602;
                                }
                                let _e2649 = phi_4830_;
                                if (_e2646 > _e2649) {
                                    phi_4835_ = _e2646;
                                } else {
                                    phi_4835_ = _e2649;
                                }
                                let _e2652 = phi_4835_;
                                if (_e2607 > _e2612) {
                                    phi_4840_ = _e2607;
                                } else {
                                    phi_4840_ = _e2612;
                                }
                                let _e2655 = phi_4840_;
                                if (_e2617 > _e2622) {
                                    phi_4845_ = _e2617;
                                } else {
                                    phi_4845_ = _e2622;
                                }
                                let _e2658 = phi_4845_;
                                if (_e2655 > _e2658) {
                                    phi_4850_ = _e2655;
                                } else {
                                    phi_4850_ = _e2658;
                                }
                                let _e2661 = phi_4850_;
                                if (_e2652 > _e2661) {
                                    phi_4855_ = _e2652;
                                } else {
                                    phi_4855_ = _e2661;
                                }
                                let _e2664 = phi_4855_;
                                if (_e2576 < 0f) {
                                    phi_4861_ = -(_e2576);
                                } else {
                                    phi_4861_ = _e2576;
                                }
                                let _e2668 = phi_4861_;
                                if (_e2579 < 0f) {
                                    phi_4867_ = -(_e2579);
                                } else {
                                    phi_4867_ = _e2579;
                                }
                                let _e2672 = phi_4867_;
                                if (_e2582 < 0f) {
                                    phi_4874_ = -(_e2582);
                                } else {
                                    phi_4874_ = _e2582;
                                }
                                let _e2677 = phi_4874_;
                                let _e2678 = ((_e2668 + _e2672) + _e2677);
                                let _e2683 = -(_e2664);
                                if (_e2643 > _e2683) {
                                    phi_4885_ = _e2643;
                                } else {
                                    phi_4885_ = _e2683;
                                }
                                let _e2686 = phi_4885_;
                                let _e2691 = (((_e2686 - ((_e2678 * _e2566) * (0.000000059604645f * (17f / 2f)))) - (_e2678 * _e2573)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2694 = ((_e2350 * _e2344) - (_e2353 * _e2343));
                                let _e2697 = ((_e2353 * _e2342) - (_e2347 * _e2344));
                                let _e2700 = ((_e2347 * _e2343) - (_e2350 * _e2342));
                                let _e2705 = (((_e2694 * _e2356[0]) + (_e2697 * _e2356[1])) + (_e2700 * _e2356[2]));
                                let _e2710 = (((_e2694 * _e2372) + (_e2697 * _e2373)) + (_e2700 * _e2374));
                                let _e2715 = (((_e2694 * _e2375) + (_e2697 * _e2376)) + (_e2700 * _e2377));
                                let _e2720 = (((_e2694 * _e2356[0]) + (_e2697 * _e2356[1])) + (_e2700 * _e2356[2]));
                                let _e2725 = (((_e2694 * _e2380[0]) + (_e2697 * _e2380[1])) + (_e2700 * _e2380[2]));
                                let _e2730 = (((_e2694 * _e2396) + (_e2697 * _e2397)) + (_e2700 * _e2398));
                                let _e2735 = (((_e2694 * _e2399) + (_e2697 * _e2400)) + (_e2700 * _e2401));
                                let _e2740 = (((_e2694 * _e2380[0]) + (_e2697 * _e2380[1])) + (_e2700 * _e2380[2]));
                                if (_e2705 < _e2710) {
                                    phi_4956_ = _e2705;
                                } else {
                                    phi_4956_ = _e2710;
                                }
                                let _e2743 = phi_4956_;
                                if (_e2715 < _e2720) {
                                    phi_4961_ = _e2715;
                                } else {
                                    phi_4961_ = _e2720;
                                }
                                let _e2746 = phi_4961_;
                                if (_e2743 < _e2746) {
                                    phi_4966_ = _e2743;
                                } else {
                                    phi_4966_ = _e2746;
                                }
                                let _e2749 = phi_4966_;
                                if (_e2725 < _e2730) {
                                    phi_4971_ = _e2725;
                                } else {
                                    phi_4971_ = _e2730;
                                }
                                let _e2752 = phi_4971_;
                                if (_e2735 < _e2740) {
                                    phi_4976_ = _e2735;
                                } else {
                                    phi_4976_ = _e2740;
                                }
                                let _e2755 = phi_4976_;
                                if (_e2752 < _e2755) {
                                    phi_4981_ = _e2752;
                                } else {
                                    phi_4981_ = _e2755;
                                }
                                let _e2758 = phi_4981_;
                                if (_e2749 < _e2758) {
                                    phi_4986_ = _e2749;
                                } else {
                                    phi_4986_ = _e2758;
                                }
                                let _e2761 = phi_4986_;
                                if (_e2705 > _e2710) {
                                    phi_4991_ = _e2705;
                                } else {
                                    phi_4991_ = _e2710;
                                }
                                let _e2764 = phi_4991_;
                                if (_e2715 > _e2720) {
                                    phi_4996_ = _e2715;
                                } else {
                                    phi_4996_ = _e2720;
                                }
                                let _e2767 = phi_4996_;
                                if (_e2764 > _e2767) {
                                    phi_5001_ = _e2764;
                                } else {
                                    phi_5001_ = _e2767;
                                }
                                let _e2770 = phi_5001_;
                                if (_e2725 > _e2730) {
                                    phi_5006_ = _e2725;
                                } else {
                                    phi_5006_ = _e2730;
                                }
                                let _e2773 = phi_5006_;
                                if (_e2735 > _e2740) {
                                    phi_5011_ = _e2735;
                                } else {
                                    phi_5011_ = _e2740;
                                }
                                let _e2776 = phi_5011_;
                                if (_e2773 > _e2776) {
                                    phi_5016_ = _e2773;
                                } else {
                                    phi_5016_ = _e2776;
                                }
                                let _e2779 = phi_5016_;
                                if (_e2770 > _e2779) {
                                    phi_5021_ = _e2770;
                                } else {
                                    phi_5021_ = _e2779;
                                }
                                let _e2782 = phi_5021_;
                                if (_e2694 < 0f) {
                                    phi_5027_ = -(_e2694);
                                } else {
                                    phi_5027_ = _e2694;
                                }
                                let _e2786 = phi_5027_;
                                if (_e2697 < 0f) {
                                    phi_5033_ = -(_e2697);
                                } else {
                                    phi_5033_ = _e2697;
                                }
                                let _e2790 = phi_5033_;
                                if (_e2700 < 0f) {
                                    phi_5040_ = -(_e2700);
                                } else {
                                    phi_5040_ = _e2700;
                                }
                                let _e2795 = phi_5040_;
                                let _e2796 = ((_e2786 + _e2790) + _e2795);
                                let _e2801 = -(_e2782);
                                if (_e2761 > _e2801) {
                                    phi_5051_ = _e2761;
                                } else {
                                    phi_5051_ = _e2801;
                                }
                                let _e2804 = phi_5051_;
                                let _e2809 = (((_e2804 - ((_e2796 * _e2566) * (0.000000059604645f * (17f / 2f)))) - (_e2796 * _e2573)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2691 > _e2809) {
                                    phi_5061_ = _e2691;
                                } else {
                                    phi_5061_ = _e2809;
                                }
                                let _e2812 = phi_5061_;
                                let _e2813 = (_e2342 - _e2327);
                                let _e2814 = (_e2343 - _e2328);
                                let _e2815 = (_e2344 - _e2329);
                                let _e2818 = ((_e2350 * _e2815) - (_e2353 * _e2814));
                                let _e2821 = ((_e2353 * _e2813) - (_e2347 * _e2815));
                                let _e2824 = ((_e2347 * _e2814) - (_e2350 * _e2813));
                                let _e2829 = (((_e2818 * _e2356[0]) + (_e2821 * _e2356[1])) + (_e2824 * _e2356[2]));
                                let _e2834 = (((_e2818 * _e2372) + (_e2821 * _e2373)) + (_e2824 * _e2374));
                                let _e2839 = (((_e2818 * _e2375) + (_e2821 * _e2376)) + (_e2824 * _e2377));
                                let _e2844 = (((_e2818 * _e2356[0]) + (_e2821 * _e2356[1])) + (_e2824 * _e2356[2]));
                                let _e2849 = (((_e2818 * _e2380[0]) + (_e2821 * _e2380[1])) + (_e2824 * _e2380[2]));
                                let _e2854 = (((_e2818 * _e2396) + (_e2821 * _e2397)) + (_e2824 * _e2398));
                                let _e2859 = (((_e2818 * _e2399) + (_e2821 * _e2400)) + (_e2824 * _e2401));
                                let _e2864 = (((_e2818 * _e2380[0]) + (_e2821 * _e2380[1])) + (_e2824 * _e2380[2]));
                                if (_e2829 < _e2834) {
                                    phi_5134_ = _e2829;
                                } else {
                                    phi_5134_ = _e2834;
                                }
                                let _e2867 = phi_5134_;
                                if (_e2839 < _e2844) {
                                    phi_5139_ = _e2839;
                                } else {
                                    phi_5139_ = _e2844;
                                }
                                let _e2870 = phi_5139_;
                                if (_e2867 < _e2870) {
                                    phi_5144_ = _e2867;
                                } else {
                                    phi_5144_ = _e2870;
                                }
                                let _e2873 = phi_5144_;
                                if (_e2849 < _e2854) {
                                    phi_5149_ = _e2849;
                                } else {
                                    phi_5149_ = _e2854;
                                }
                                let _e2876 = phi_5149_;
                                if (_e2859 < _e2864) {
                                    phi_5154_ = _e2859;
                                } else {
                                    phi_5154_ = _e2864;
                                }
                                let _e2879 = phi_5154_;
                                if (_e2876 < _e2879) {
                                    phi_5159_ = _e2876;
                                } else {
                                    phi_5159_ = _e2879;
                                }
                                let _e2882 = phi_5159_;
                                if (_e2873 < _e2882) {
                                    phi_5164_ = _e2873;
                                } else {
                                    phi_5164_ = _e2882;
                                }
                                let _e2885 = phi_5164_;
                                if (_e2829 > _e2834) {
                                    phi_5169_ = _e2829;
                                } else {
                                    phi_5169_ = _e2834;
                                }
                                let _e2888 = phi_5169_;
                                if (_e2839 > _e2844) {
                                    phi_5174_ = _e2839;
                                } else {
                                    phi_5174_ = _e2844;
                                }
                                let _e2891 = phi_5174_;
                                if (_e2888 > _e2891) {
                                    phi_5179_ = _e2888;
                                } else {
                                    phi_5179_ = _e2891;
                                }
                                let _e2894 = phi_5179_;
                                if (_e2849 > _e2854) {
                                    phi_5184_ = _e2849;
                                } else {
                                    phi_5184_ = _e2854;
                                }
                                let _e2897 = phi_5184_;
                                if (_e2859 > _e2864) {
                                    phi_5189_ = _e2859;
                                } else {
                                    phi_5189_ = _e2864;
                                }
                                let _e2900 = phi_5189_;
                                if (_e2897 > _e2900) {
                                    phi_5194_ = _e2897;
                                } else {
                                    phi_5194_ = _e2900;
                                }
                                let _e2903 = phi_5194_;
                                if (_e2894 > _e2903) {
                                    phi_5199_ = _e2894;
                                } else {
                                    phi_5199_ = _e2903;
                                }
                                let _e2906 = phi_5199_;
                                if (_e2818 < 0f) {
                                    phi_5205_ = -(_e2818);
                                } else {
                                    phi_5205_ = _e2818;
                                }
                                let _e2910 = phi_5205_;
                                if (_e2821 < 0f) {
                                    phi_5211_ = -(_e2821);
                                } else {
                                    phi_5211_ = _e2821;
                                }
                                let _e2914 = phi_5211_;
                                if (_e2824 < 0f) {
                                    phi_5218_ = -(_e2824);
                                } else {
                                    phi_5218_ = _e2824;
                                }
                                let _e2919 = phi_5218_;
                                let _e2920 = ((_e2910 + _e2914) + _e2919);
                                let _e2925 = -(_e2906);
                                if (_e2885 > _e2925) {
                                    phi_5229_ = _e2885;
                                } else {
                                    phi_5229_ = _e2925;
                                }
                                let _e2928 = phi_5229_;
                                let _e2933 = (((_e2928 - ((_e2920 * _e2566) * (0.000000059604645f * (17f / 2f)))) - (_e2920 * _e2573)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2812 > _e2933) {
                                    phi_5239_ = _e2812;
                                } else {
                                    phi_5239_ = _e2933;
                                }
                                let _e2936 = phi_5239_;
                                phi_5243_ = (_e2314 || (_e2936 > 0f));
                            }
                            let _e2940 = phi_5243_;
                            if _e2940 {
                                phi_8660_ = _e2940;
                            } else {
                                let _e2943 = local_2.member[0u];
                                let _e2949 = local_2.member[1u];
                                let _e2956 = ((_e2943[0] + _e2949[0]) * 0.5f);
                                let _e2957 = ((_e2943[1] + _e2949[1]) * 0.5f);
                                let _e2958 = ((_e2943[2] + _e2949[2]) * 0.5f);
                                let _e2961 = local_2.member_1[0u];
                                let _e2967 = local_2.member_1[1u];
                                let _e2974 = ((_e2961[0] + _e2967[0]) * 0.5f);
                                let _e2975 = ((_e2961[1] + _e2967[1]) * 0.5f);
                                let _e2976 = ((_e2961[2] + _e2967[2]) * 0.5f);
                                let _e2979 = local_2.member_2[0u];
                                let _e2985 = local_2.member_2[1u];
                                let _e2992 = ((_e2979[0] + _e2985[0]) * 0.5f);
                                let _e2993 = ((_e2979[1] + _e2985[1]) * 0.5f);
                                let _e2994 = ((_e2979[2] + _e2985[2]) * 0.5f);
                                let _e2997 = local_2.member[0u];
                                let _e3000 = local_2.member_1[0u];
                                let _e3003 = local_2.member_2[0u];
                                let _e3005 = local_2.member_3;
                                let _e3008 = local_2.member[1u];
                                let _e3011 = local_2.member_1[1u];
                                let _e3014 = local_2.member_2[1u];
                                let _e3016 = local_2.member_3;
                                local = type_41(array<array<f32, 3>, 2>(_e2997, array<f32, 3>(_e2956, _e2957, _e2958)), array<array<f32, 3>, 2>(_e3000, array<f32, 3>(_e2974, _e2975, _e2976)), array<array<f32, 3>, 2>(_e3003, array<f32, 3>(_e2992, _e2993, _e2994)), _e3005);
                                local_1 = type_41(array<array<f32, 3>, 2>(array<f32, 3>(_e2956, _e2957, _e2958), _e3008), array<array<f32, 3>, 2>(array<f32, 3>(_e2974, _e2975, _e2976), _e3011), array<array<f32, 3>, 2>(array<f32, 3>(_e2992, _e2993, _e2994), _e3014), _e3016);
                                let _e3033 = local.member_1[0u];
                                let _e3039 = local.member_2[0u];
                                let _e3045 = ((_e3033[1] * _e3039[2]) - (_e3033[2] * _e3039[1]));
                                let _e3048 = ((_e3033[2] * _e3039[0]) - (_e3033[0] * _e3039[2]));
                                let _e3051 = ((_e3033[0] * _e3039[1]) - (_e3033[1] * _e3039[0]));
                                let _e3054 = local.member_1[1u];
                                let _e3060 = local.member_2[1u];
                                let _e3066 = ((_e3054[1] * _e3060[2]) - (_e3054[2] * _e3060[1]));
                                let _e3069 = ((_e3054[2] * _e3060[0]) - (_e3054[0] * _e3060[2]));
                                let _e3072 = ((_e3054[0] * _e3060[1]) - (_e3054[1] * _e3060[0]));
                                let _e3075 = local.member_1[0u];
                                let _e3081 = local.member_2[1u];
                                let _e3096 = local.member_1[1u];
                                let _e3102 = local.member_2[0u];
                                let _e3115 = (((_e3075[1] * _e3081[2]) - (_e3075[2] * _e3081[1])) + ((_e3096[1] * _e3102[2]) - (_e3096[2] * _e3102[1])));
                                let _e3116 = (((_e3075[2] * _e3081[0]) - (_e3075[0] * _e3081[2])) + ((_e3096[2] * _e3102[0]) - (_e3096[0] * _e3102[2])));
                                let _e3117 = (((_e3075[0] * _e3081[1]) - (_e3075[1] * _e3081[0])) + ((_e3096[0] * _e3102[1]) - (_e3096[1] * _e3102[0])));
                                let _e3120 = local.member[0u];
                                let _e3131 = local.member[1u];
                                let _e3142 = local.member[0u];
                                let _e3151 = ((((_e3131[0] * _e3045) + (_e3131[1] * _e3048)) + (_e3131[2] * _e3051)) + (((_e3142[0] * _e3115) + (_e3142[1] * _e3116)) + (_e3142[2] * _e3117)));
                                let _e3154 = local.member[0u];
                                let _e3165 = local.member[1u];
                                let _e3174 = ((((_e3154[0] * _e3066) + (_e3154[1] * _e3069)) + (_e3154[2] * _e3072)) + (((_e3165[0] * _e3115) + (_e3165[1] * _e3116)) + (_e3165[2] * _e3117)));
                                let _e3177 = local.member[1u];
                                let _e3188 = local.member[0u];
                                if (_e3188[0] < 0f) {
                                    phi_5695_ = -(_e3188[0]);
                                } else {
                                    phi_5695_ = _e3188[0];
                                }
                                let _e3195 = phi_5695_;
                                if (_e3188[1] < 0f) {
                                    phi_5702_ = -(_e3188[1]);
                                } else {
                                    phi_5702_ = _e3188[1];
                                }
                                let _e3199 = phi_5702_;
                                if (_e3195 > _e3199) {
                                    phi_5707_ = _e3195;
                                } else {
                                    phi_5707_ = _e3199;
                                }
                                let _e3202 = phi_5707_;
                                if (_e3188[2] < 0f) {
                                    phi_5714_ = -(_e3188[2]);
                                } else {
                                    phi_5714_ = _e3188[2];
                                }
                                let _e3206 = phi_5714_;
                                if (_e3202 > _e3206) {
                                    phi_5719_ = _e3202;
                                } else {
                                    phi_5719_ = _e3206;
                                }
                                let _e3209 = phi_5719_;
                                let _e3212 = local.member[1u];
                                if (_e3212[0] < 0f) {
                                    phi_5732_ = -(_e3212[0]);
                                } else {
                                    phi_5732_ = _e3212[0];
                                }
                                let _e3219 = phi_5732_;
                                if (_e3212[1] < 0f) {
                                    phi_5739_ = -(_e3212[1]);
                                } else {
                                    phi_5739_ = _e3212[1];
                                }
                                let _e3223 = phi_5739_;
                                if (_e3219 > _e3223) {
                                    phi_5744_ = _e3219;
                                } else {
                                    phi_5744_ = _e3223;
                                }
                                let _e3226 = phi_5744_;
                                if (_e3212[2] < 0f) {
                                    phi_5751_ = -(_e3212[2]);
                                } else {
                                    phi_5751_ = _e3212[2];
                                }
                                let _e3230 = phi_5751_;
                                if (_e3226 > _e3230) {
                                    phi_5756_ = _e3226;
                                } else {
                                    phi_5756_ = _e3230;
                                }
                                let _e3233 = phi_5756_;
                                if (_e3209 > _e3233) {
                                    phi_5761_ = _e3209;
                                } else {
                                    phi_5761_ = _e3233;
                                }
                                let _e3236 = phi_5761_;
                                let _e3238 = local.member_3;
                                let _e3239 = (_e3236 + _e3238);
                                let _e3242 = local.member_1[0u];
                                if (_e3242[0] < 0f) {
                                    phi_5778_ = -(_e3242[0]);
                                } else {
                                    phi_5778_ = _e3242[0];
                                }
                                let _e3249 = phi_5778_;
                                if (_e3242[1] < 0f) {
                                    phi_5785_ = -(_e3242[1]);
                                } else {
                                    phi_5785_ = _e3242[1];
                                }
                                let _e3253 = phi_5785_;
                                if (_e3249 > _e3253) {
                                    phi_5790_ = _e3249;
                                } else {
                                    phi_5790_ = _e3253;
                                }
                                let _e3256 = phi_5790_;
                                if (_e3242[2] < 0f) {
                                    phi_5797_ = -(_e3242[2]);
                                } else {
                                    phi_5797_ = _e3242[2];
                                }
                                let _e3260 = phi_5797_;
                                if (_e3256 > _e3260) {
                                    phi_5802_ = _e3256;
                                } else {
                                    phi_5802_ = _e3260;
                                }
                                let _e3263 = phi_5802_;
                                let _e3266 = local.member_1[1u];
                                if (_e3266[0] < 0f) {
                                    phi_5816_ = -(_e3266[0]);
                                } else {
                                    phi_5816_ = _e3266[0];
                                }
                                let _e3273 = phi_5816_;
                                if (_e3266[1] < 0f) {
                                    phi_5823_ = -(_e3266[1]);
                                } else {
                                    phi_5823_ = _e3266[1];
                                }
                                let _e3277 = phi_5823_;
                                if (_e3273 > _e3277) {
                                    phi_5828_ = _e3273;
                                } else {
                                    phi_5828_ = _e3277;
                                }
                                let _e3280 = phi_5828_;
                                if (_e3266[2] < 0f) {
                                    phi_5835_ = -(_e3266[2]);
                                } else {
                                    phi_5835_ = _e3266[2];
                                }
                                let _e3284 = phi_5835_;
                                if (_e3280 > _e3284) {
                                    phi_5840_ = _e3280;
                                } else {
                                    phi_5840_ = _e3284;
                                }
                                let _e3287 = phi_5840_;
                                if (_e3263 > _e3287) {
                                    phi_5845_ = _e3263;
                                } else {
                                    phi_5845_ = _e3287;
                                }
                                let _e3290 = phi_5845_;
                                let _e3292 = local.member_3;
                                let _e3293 = (_e3290 + _e3292);
                                let _e3296 = local.member_2[0u];
                                if (_e3296[0] < 0f) {
                                    phi_5862_ = -(_e3296[0]);
                                } else {
                                    phi_5862_ = _e3296[0];
                                }
                                let _e3303 = phi_5862_;
                                if (_e3296[1] < 0f) {
                                    phi_5869_ = -(_e3296[1]);
                                } else {
                                    phi_5869_ = _e3296[1];
                                }
                                let _e3307 = phi_5869_;
                                if (_e3303 > _e3307) {
                                    phi_5874_ = _e3303;
                                } else {
                                    phi_5874_ = _e3307;
                                }
                                let _e3310 = phi_5874_;
                                if (_e3296[2] < 0f) {
                                    phi_5881_ = -(_e3296[2]);
                                } else {
                                    phi_5881_ = _e3296[2];
                                }
                                let _e3314 = phi_5881_;
                                if (_e3310 > _e3314) {
                                    phi_5886_ = _e3310;
                                } else {
                                    phi_5886_ = _e3314;
                                }
                                let _e3317 = phi_5886_;
                                let _e3320 = local.member_2[1u];
                                if (_e3320[0] < 0f) {
                                    phi_5900_ = -(_e3320[0]);
                                } else {
                                    phi_5900_ = _e3320[0];
                                }
                                let _e3327 = phi_5900_;
                                if (_e3320[1] < 0f) {
                                    phi_5907_ = -(_e3320[1]);
                                } else {
                                    phi_5907_ = _e3320[1];
                                }
                                let _e3331 = phi_5907_;
                                if (_e3327 > _e3331) {
                                    phi_5912_ = _e3327;
                                } else {
                                    phi_5912_ = _e3331;
                                }
                                let _e3334 = phi_5912_;
                                if (_e3320[2] < 0f) {
                                    phi_5919_ = -(_e3320[2]);
                                } else {
                                    phi_5919_ = _e3320[2];
                                }
                                let _e3338 = phi_5919_;
                                if (_e3334 > _e3338) {
                                    phi_5924_ = _e3334;
                                } else {
                                    phi_5924_ = _e3338;
                                }
                                let _e3341 = phi_5924_;
                                if (_e3317 > _e3341) {
                                    phi_5929_ = _e3317;
                                } else {
                                    phi_5929_ = _e3341;
                                }
                                let _e3344 = phi_5929_;
                                let _e3346 = local.member_3;
                                let _e3347 = (_e3344 + _e3346);
                                let _e3349 = ((_e3293 * 8f) * _e3347);
                                let _e3356 = local.member_3;
                                if (_e3045 < 0f) {
                                    phi_5960_ = -(_e3045);
                                } else {
                                    phi_5960_ = _e3045;
                                }
                                let _e3373 = phi_5960_;
                                if (_e3048 < 0f) {
                                    phi_5966_ = -(_e3048);
                                } else {
                                    phi_5966_ = _e3048;
                                }
                                let _e3377 = phi_5966_;
                                if (_e3051 < 0f) {
                                    phi_5973_ = -(_e3051);
                                } else {
                                    phi_5973_ = _e3051;
                                }
                                let _e3382 = phi_5973_;
                                let _e3383 = ((_e3373 + _e3377) + _e3382);
                                if (_e3066 < 0f) {
                                    phi_5980_ = -(_e3066);
                                } else {
                                    phi_5980_ = _e3066;
                                }
                                let _e3387 = phi_5980_;
                                if (_e3069 < 0f) {
                                    phi_5986_ = -(_e3069);
                                } else {
                                    phi_5986_ = _e3069;
                                }
                                let _e3391 = phi_5986_;
                                if (_e3072 < 0f) {
                                    phi_5993_ = -(_e3072);
                                } else {
                                    phi_5993_ = _e3072;
                                }
                                let _e3396 = phi_5993_;
                                let _e3397 = ((_e3387 + _e3391) + _e3396);
                                if (_e3383 > _e3397) {
                                    phi_5999_ = _e3383;
                                } else {
                                    phi_5999_ = _e3397;
                                }
                                let _e3400 = phi_5999_;
                                if (_e3115 < 0f) {
                                    phi_6005_ = -(_e3115);
                                } else {
                                    phi_6005_ = _e3115;
                                }
                                let _e3404 = phi_6005_;
                                if (_e3116 < 0f) {
                                    phi_6011_ = -(_e3116);
                                } else {
                                    phi_6011_ = _e3116;
                                }
                                let _e3408 = phi_6011_;
                                if (_e3117 < 0f) {
                                    phi_6018_ = -(_e3117);
                                } else {
                                    phi_6018_ = _e3117;
                                }
                                let _e3413 = phi_6018_;
                                let _e3415 = (((_e3404 + _e3408) + _e3413) * 0.5f);
                                if (_e3400 > _e3415) {
                                    phi_6025_ = _e3400;
                                } else {
                                    phi_6025_ = _e3415;
                                }
                                let _e3418 = phi_6025_;
                                let _e3423 = local.member_3;
                                let _e3436 = ((((_e3120[0] * _e3045) + (_e3120[1] * _e3048)) + (_e3120[2] * _e3051)) * 3f);
                                let _e3437 = ((((_e3177[0] * _e3066) + (_e3177[1] * _e3069)) + (_e3177[2] * _e3072)) * 3f);
                                if (_e3436 < _e3437) {
                                    phi_6049_ = _e3436;
                                } else {
                                    phi_6049_ = _e3437;
                                }
                                let _e3440 = phi_6049_;
                                if (_e3151 < _e3174) {
                                    phi_6054_ = _e3151;
                                } else {
                                    phi_6054_ = _e3174;
                                }
                                let _e3443 = phi_6054_;
                                if (_e3440 < _e3443) {
                                    phi_6059_ = _e3440;
                                } else {
                                    phi_6059_ = _e3443;
                                }
                                let _e3446 = phi_6059_;
                                if (_e3436 > _e3437) {
                                    phi_6064_ = _e3436;
                                } else {
                                    phi_6064_ = _e3437;
                                }
                                let _e3449 = phi_6064_;
                                if (_e3151 > _e3174) {
                                    phi_6069_ = _e3151;
                                } else {
                                    phi_6069_ = _e3174;
                                }
                                let _e3452 = phi_6069_;
                                if (_e3449 > _e3452) {
                                    phi_6074_ = _e3449;
                                } else {
                                    phi_6074_ = _e3452;
                                }
                                let _e3455 = phi_6074_;
                                let _e3460 = -(_e3455);
                                if (_e3446 > _e3460) {
                                    phi_6084_ = _e3446;
                                } else {
                                    phi_6084_ = _e3460;
                                }
                                let _e3463 = phi_6084_;
                                let _e3465 = ((_e3463 - ((((((_e3239 * 8f) * _e3349) * (0.000000059604645f * (524f / 64f))) + ((_e3356 * 19f) * ((_e3239 * (_e3293 + _e3347)) + (_e3293 * _e3347)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3239) * ((1f + _e3293) * (1f + _e3347))))) + ((_e1810 * (((_e3418 + (_e3349 * (0.000000059604645f * 8f))) + ((_e3423 * 6f) * (_e3293 + _e3347))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3293) * (1f + _e3347))))) * (3f * 1.0001f)))) > 0f);
                                if _e3465 {
                                    phi_7053_ = _e3465;
                                } else {
                                    let _e3468 = local.member_1[0u];
                                    let _e3474 = local.member_1[1u];
                                    let _e3478 = (_e3468[0] + _e3474[0]);
                                    let _e3479 = (_e3468[1] + _e3474[1]);
                                    let _e3480 = (_e3468[2] + _e3474[2]);
                                    let _e3483 = local.member_2[0u];
                                    let _e3489 = local.member_2[1u];
                                    let _e3493 = (_e3483[0] + _e3489[0]);
                                    let _e3494 = (_e3483[1] + _e3489[1]);
                                    let _e3495 = (_e3483[2] + _e3489[2]);
                                    let _e3498 = ((_e3479 * _e3495) - (_e3480 * _e3494));
                                    let _e3501 = ((_e3480 * _e3493) - (_e3478 * _e3495));
                                    let _e3504 = ((_e3478 * _e3494) - (_e3479 * _e3493));
                                    let _e3507 = local.member[0u];
                                    let _e3513 = local.member_1[0u];
                                    let _e3519 = local.member_2[0u];
                                    let _e3523 = (_e3507[0] - _e3513[0]);
                                    let _e3524 = (_e3507[1] - _e3513[1]);
                                    let _e3525 = (_e3507[2] - _e3513[2]);
                                    let _e3526 = (_e3507[0] - _e3519[0]);
                                    let _e3527 = (_e3507[1] - _e3519[1]);
                                    let _e3528 = (_e3507[2] - _e3519[2]);
                                    let _e3531 = local.member[1u];
                                    let _e3537 = local.member_1[1u];
                                    let _e3543 = local.member_2[1u];
                                    let _e3547 = (_e3531[0] - _e3537[0]);
                                    let _e3548 = (_e3531[1] - _e3537[1]);
                                    let _e3549 = (_e3531[2] - _e3537[2]);
                                    let _e3550 = (_e3531[0] - _e3543[0]);
                                    let _e3551 = (_e3531[1] - _e3543[1]);
                                    let _e3552 = (_e3531[2] - _e3543[2]);
                                    let _e3555 = local.member[0u];
                                    if (_e3555[0] < 0f) {
                                        phi_6287_ = -(_e3555[0]);
                                    } else {
                                        phi_6287_ = _e3555[0];
                                    }
                                    let _e3562 = phi_6287_;
                                    if (_e3555[1] < 0f) {
                                        phi_6294_ = -(_e3555[1]);
                                    } else {
                                        phi_6294_ = _e3555[1];
                                    }
                                    let _e3566 = phi_6294_;
                                    if (_e3562 > _e3566) {
                                        phi_6299_ = _e3562;
                                    } else {
                                        phi_6299_ = _e3566;
                                    }
                                    let _e3569 = phi_6299_;
                                    if (_e3555[2] < 0f) {
                                        phi_6306_ = -(_e3555[2]);
                                    } else {
                                        phi_6306_ = _e3555[2];
                                    }
                                    let _e3573 = phi_6306_;
                                    if (_e3569 > _e3573) {
                                        phi_6311_ = _e3569;
                                    } else {
                                        phi_6311_ = _e3573;
                                    }
                                    let _e3576 = phi_6311_;
                                    let _e3579 = local.member[1u];
                                    if (_e3579[0] < 0f) {
                                        phi_6324_ = -(_e3579[0]);
                                    } else {
                                        phi_6324_ = _e3579[0];
                                    }
                                    let _e3586 = phi_6324_;
                                    if (_e3579[1] < 0f) {
                                        phi_6331_ = -(_e3579[1]);
                                    } else {
                                        phi_6331_ = _e3579[1];
                                    }
                                    let _e3590 = phi_6331_;
                                    if (_e3586 > _e3590) {
                                        phi_6336_ = _e3586;
                                    } else {
                                        phi_6336_ = _e3590;
                                    }
                                    let _e3593 = phi_6336_;
                                    if (_e3579[2] < 0f) {
                                        phi_6343_ = -(_e3579[2]);
                                    } else {
                                        phi_6343_ = _e3579[2];
                                    }
                                    let _e3597 = phi_6343_;
                                    if (_e3593 > _e3597) {
                                        phi_6348_ = _e3593;
                                    } else {
                                        phi_6348_ = _e3597;
                                    }
                                    let _e3600 = phi_6348_;
                                    if (_e3576 > _e3600) {
                                        phi_6353_ = _e3576;
                                    } else {
                                        phi_6353_ = _e3600;
                                    }
                                    let _e3603 = phi_6353_;
                                    let _e3605 = local.member_3;
                                    let _e3609 = local.member_1[0u];
                                    if (_e3609[0] < 0f) {
                                        phi_6370_ = -(_e3609[0]);
                                    } else {
                                        phi_6370_ = _e3609[0];
                                    }
                                    let _e3616 = phi_6370_;
                                    if (_e3609[1] < 0f) {
                                        phi_6377_ = -(_e3609[1]);
                                    } else {
                                        phi_6377_ = _e3609[1];
                                    }
                                    let _e3620 = phi_6377_;
                                    if (_e3616 > _e3620) {
                                        phi_6382_ = _e3616;
                                    } else {
                                        phi_6382_ = _e3620;
                                    }
                                    let _e3623 = phi_6382_;
                                    if (_e3609[2] < 0f) {
                                        phi_6389_ = -(_e3609[2]);
                                    } else {
                                        phi_6389_ = _e3609[2];
                                    }
                                    let _e3627 = phi_6389_;
                                    if (_e3623 > _e3627) {
                                        phi_6394_ = _e3623;
                                    } else {
                                        phi_6394_ = _e3627;
                                    }
                                    let _e3630 = phi_6394_;
                                    let _e3633 = local.member_1[1u];
                                    if (_e3633[0] < 0f) {
                                        phi_6408_ = -(_e3633[0]);
                                    } else {
                                        phi_6408_ = _e3633[0];
                                    }
                                    let _e3640 = phi_6408_;
                                    if (_e3633[1] < 0f) {
                                        phi_6415_ = -(_e3633[1]);
                                    } else {
                                        phi_6415_ = _e3633[1];
                                    }
                                    let _e3644 = phi_6415_;
                                    if (_e3640 > _e3644) {
                                        phi_6420_ = _e3640;
                                    } else {
                                        phi_6420_ = _e3644;
                                    }
                                    let _e3647 = phi_6420_;
                                    if (_e3633[2] < 0f) {
                                        phi_6427_ = -(_e3633[2]);
                                    } else {
                                        phi_6427_ = _e3633[2];
                                    }
                                    let _e3651 = phi_6427_;
                                    if (_e3647 > _e3651) {
                                        phi_6432_ = _e3647;
                                    } else {
                                        phi_6432_ = _e3651;
                                    }
                                    let _e3654 = phi_6432_;
                                    if (_e3630 > _e3654) {
                                        phi_6437_ = _e3630;
                                    } else {
                                        phi_6437_ = _e3654;
                                    }
                                    let _e3657 = phi_6437_;
                                    let _e3659 = local.member_3;
                                    let _e3663 = local.member_2[0u];
                                    if (_e3663[0] < 0f) {
                                        phi_6454_ = -(_e3663[0]);
                                    } else {
                                        phi_6454_ = _e3663[0];
                                    }
                                    let _e3670 = phi_6454_;
                                    if (_e3663[1] < 0f) {
                                        phi_6461_ = -(_e3663[1]);
                                    } else {
                                        phi_6461_ = _e3663[1];
                                    }
                                    let _e3674 = phi_6461_;
                                    if (_e3670 > _e3674) {
                                        phi_6466_ = _e3670;
                                    } else {
                                        phi_6466_ = _e3674;
                                    }
                                    let _e3677 = phi_6466_;
                                    if (_e3663[2] < 0f) {
                                        phi_6473_ = -(_e3663[2]);
                                    } else {
                                        phi_6473_ = _e3663[2];
                                    }
                                    let _e3681 = phi_6473_;
                                    if (_e3677 > _e3681) {
                                        phi_6478_ = _e3677;
                                    } else {
                                        phi_6478_ = _e3681;
                                    }
                                    let _e3684 = phi_6478_;
                                    let _e3687 = local.member_2[1u];
                                    if (_e3687[0] < 0f) {
                                        phi_6492_ = -(_e3687[0]);
                                    } else {
                                        phi_6492_ = _e3687[0];
                                    }
                                    let _e3694 = phi_6492_;
                                    if (_e3687[1] < 0f) {
                                        phi_6499_ = -(_e3687[1]);
                                    } else {
                                        phi_6499_ = _e3687[1];
                                    }
                                    let _e3698 = phi_6499_;
                                    if (_e3694 > _e3698) {
                                        phi_6504_ = _e3694;
                                    } else {
                                        phi_6504_ = _e3698;
                                    }
                                    let _e3701 = phi_6504_;
                                    if (_e3687[2] < 0f) {
                                        phi_6511_ = -(_e3687[2]);
                                    } else {
                                        phi_6511_ = _e3687[2];
                                    }
                                    let _e3705 = phi_6511_;
                                    if (_e3701 > _e3705) {
                                        phi_6516_ = _e3701;
                                    } else {
                                        phi_6516_ = _e3705;
                                    }
                                    let _e3708 = phi_6516_;
                                    if (_e3684 > _e3708) {
                                        phi_6521_ = _e3684;
                                    } else {
                                        phi_6521_ = _e3708;
                                    }
                                    let _e3711 = phi_6521_;
                                    let _e3713 = local.member_3;
                                    let _e3717 = ((((_e3603 + _e3605) + (_e3657 + _e3659)) + (_e3711 + _e3713)) * 2f);
                                    let _e3720 = local.member_3;
                                    let _e3724 = (((_e1810 * 1.0001f) + (_e3720 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3727 = ((_e3501 * _e3480) - (_e3504 * _e3479));
                                    let _e3730 = ((_e3504 * _e3478) - (_e3498 * _e3480));
                                    let _e3733 = ((_e3498 * _e3479) - (_e3501 * _e3478));
                                    let _e3738 = (((_e3727 * _e3507[0]) + (_e3730 * _e3507[1])) + (_e3733 * _e3507[2]));
                                    let _e3743 = (((_e3727 * _e3523) + (_e3730 * _e3524)) + (_e3733 * _e3525));
                                    let _e3748 = (((_e3727 * _e3526) + (_e3730 * _e3527)) + (_e3733 * _e3528));
                                    let _e3753 = (((_e3727 * _e3507[0]) + (_e3730 * _e3507[1])) + (_e3733 * _e3507[2]));
                                    let _e3758 = (((_e3727 * _e3531[0]) + (_e3730 * _e3531[1])) + (_e3733 * _e3531[2]));
                                    let _e3763 = (((_e3727 * _e3547) + (_e3730 * _e3548)) + (_e3733 * _e3549));
                                    let _e3768 = (((_e3727 * _e3550) + (_e3730 * _e3551)) + (_e3733 * _e3552));
                                    let _e3773 = (((_e3727 * _e3531[0]) + (_e3730 * _e3531[1])) + (_e3733 * _e3531[2]));
                                    if (_e3738 < _e3743) {
                                        phi_6600_ = _e3738;
                                    } else {
                                        phi_6600_ = _e3743;
                                    }
                                    let _e3776 = phi_6600_;
                                    if (_e3748 < _e3753) {
                                        phi_6605_ = _e3748;
                                    } else {
                                        phi_6605_ = _e3753;
                                    }
                                    let _e3779 = phi_6605_;
                                    if (_e3776 < _e3779) {
                                        phi_6610_ = _e3776;
                                    } else {
                                        phi_6610_ = _e3779;
                                    }
                                    let _e3782 = phi_6610_;
                                    if (_e3758 < _e3763) {
                                        phi_6615_ = _e3758;
                                    } else {
                                        phi_6615_ = _e3763;
                                    }
                                    let _e3785 = phi_6615_;
                                    if (_e3768 < _e3773) {
                                        phi_6620_ = _e3768;
                                    } else {
                                        phi_6620_ = _e3773;
                                    }
                                    let _e3788 = phi_6620_;
                                    if (_e3785 < _e3788) {
                                        phi_6625_ = _e3785;
                                    } else {
                                        phi_6625_ = _e3788;
                                    }
                                    let _e3791 = phi_6625_;
                                    if (_e3782 < _e3791) {
                                        phi_6630_ = _e3782;
                                    } else {
                                        phi_6630_ = _e3791;
                                    }
                                    let _e3794 = phi_6630_;
                                    if (_e3738 > _e3743) {
                                        phi_6635_ = _e3738;
                                    } else {
                                        phi_6635_ = _e3743;
                                    }
                                    let _e3797 = phi_6635_;
                                    if (_e3748 > _e3753) {
                                        phi_6640_ = _e3748;
                                    } else {
                                        phi_6640_ = _e3753;
                                    }
                                    let _e3800 = phi_6640_;
                                    if (_e3797 > _e3800) {
                                        phi_6645_ = _e3797;
                                    } else {
                                        phi_6645_ = _e3800;
                                    }
                                    let _e3803 = phi_6645_;
                                    if (_e3758 > _e3763) {
                                        phi_6650_ = _e3758;
                                    } else {
                                        phi_6650_ = _e3763;
                                    }
                                    let _e3806 = phi_6650_;
                                    if (_e3768 > _e3773) {
                                        phi_6655_ = _e3768;
                                    } else {
                                        phi_6655_ = _e3773;
                                    }
                                    let _e3809 = phi_6655_;
                                    if (_e3806 > _e3809) {
                                        phi_6660_ = _e3806;
                                    } else {
                                        phi_6660_ = _e3809;
                                    }
                                    let _e3812 = phi_6660_;
                                    if (_e3803 > _e3812) {
                                        phi_6665_ = _e3803;
                                    } else {
                                        phi_6665_ = _e3812;
                                    }
                                    let _e3815 = phi_6665_;
                                    if (_e3727 < 0f) {
                                        phi_6671_ = -(_e3727);
                                    } else {
                                        phi_6671_ = _e3727;
                                    }
                                    let _e3819 = phi_6671_;
                                    if (_e3730 < 0f) {
                                        phi_6677_ = -(_e3730);
                                    } else {
                                        phi_6677_ = _e3730;
                                    }
                                    let _e3823 = phi_6677_;
                                    if (_e3733 < 0f) {
                                        phi_6684_ = -(_e3733);
                                    } else {
                                        phi_6684_ = _e3733;
                                    }
                                    let _e3828 = phi_6684_;
                                    let _e3829 = ((_e3819 + _e3823) + _e3828);
                                    let _e3834 = -(_e3815);
                                    if (_e3794 > _e3834) {
                                        phi_6695_ = _e3794;
                                    } else {
                                        phi_6695_ = _e3834;
                                    }
                                    let _e3837 = phi_6695_;
                                    let _e3842 = (((_e3837 - ((_e3829 * _e3717) * (0.000000059604645f * (17f / 2f)))) - (_e3829 * _e3724)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3845 = ((_e3501 * _e3495) - (_e3504 * _e3494));
                                    let _e3848 = ((_e3504 * _e3493) - (_e3498 * _e3495));
                                    let _e3851 = ((_e3498 * _e3494) - (_e3501 * _e3493));
                                    let _e3856 = (((_e3845 * _e3507[0]) + (_e3848 * _e3507[1])) + (_e3851 * _e3507[2]));
                                    let _e3861 = (((_e3845 * _e3523) + (_e3848 * _e3524)) + (_e3851 * _e3525));
                                    let _e3866 = (((_e3845 * _e3526) + (_e3848 * _e3527)) + (_e3851 * _e3528));
                                    let _e3871 = (((_e3845 * _e3507[0]) + (_e3848 * _e3507[1])) + (_e3851 * _e3507[2]));
                                    let _e3876 = (((_e3845 * _e3531[0]) + (_e3848 * _e3531[1])) + (_e3851 * _e3531[2]));
                                    let _e3881 = (((_e3845 * _e3547) + (_e3848 * _e3548)) + (_e3851 * _e3549));
                                    let _e3886 = (((_e3845 * _e3550) + (_e3848 * _e3551)) + (_e3851 * _e3552));
                                    let _e3891 = (((_e3845 * _e3531[0]) + (_e3848 * _e3531[1])) + (_e3851 * _e3531[2]));
                                    if (_e3856 < _e3861) {
                                        phi_6766_ = _e3856;
                                    } else {
                                        phi_6766_ = _e3861;
                                    }
                                    let _e3894 = phi_6766_;
                                    if (_e3866 < _e3871) {
                                        phi_6771_ = _e3866;
                                    } else {
                                        phi_6771_ = _e3871;
                                    }
                                    let _e3897 = phi_6771_;
                                    if (_e3894 < _e3897) {
                                        phi_6776_ = _e3894;
                                    } else {
                                        phi_6776_ = _e3897;
                                    }
                                    let _e3900 = phi_6776_;
                                    if (_e3876 < _e3881) {
                                        phi_6781_ = _e3876;
                                    } else {
                                        phi_6781_ = _e3881;
                                    }
                                    let _e3903 = phi_6781_;
                                    if (_e3886 < _e3891) {
                                        phi_6786_ = _e3886;
                                    } else {
                                        phi_6786_ = _e3891;
                                    }
                                    let _e3906 = phi_6786_;
                                    if (_e3903 < _e3906) {
                                        phi_6791_ = _e3903;
                                    } else {
                                        phi_6791_ = _e3906;
                                    }
                                    let _e3909 = phi_6791_;
                                    if (_e3900 < _e3909) {
                                        phi_6796_ = _e3900;
                                    } else {
                                        phi_6796_ = _e3909;
                                    }
                                    let _e3912 = phi_6796_;
                                    if (_e3856 > _e3861) {
                                        phi_6801_ = _e3856;
                                    } else {
                                        phi_6801_ = _e3861;
                                    }
                                    let _e3915 = phi_6801_;
                                    if (_e3866 > _e3871) {
                                        phi_6806_ = _e3866;
                                    } else {
                                        phi_6806_ = _e3871;
                                    }
                                    let _e3918 = phi_6806_;
                                    if (_e3915 > _e3918) {
                                        phi_6811_ = _e3915;
                                    } else {
                                        phi_6811_ = _e3918;
                                    }
                                    let _e3921 = phi_6811_;
                                    if (_e3876 > _e3881) {
                                        phi_6816_ = _e3876;
                                    } else {
                                        phi_6816_ = _e3881;
                                    }
                                    let _e3924 = phi_6816_;
                                    if (_e3886 > _e3891) {
                                        phi_6821_ = _e3886;
                                    } else {
                                        phi_6821_ = _e3891;
                                    }
                                    let _e3927 = phi_6821_;
                                    if (_e3924 > _e3927) {
                                        phi_6826_ = _e3924;
                                    } else {
                                        phi_6826_ = _e3927;
                                    }
                                    let _e3930 = phi_6826_;
                                    if (_e3921 > _e3930) {
                                        phi_6831_ = _e3921;
                                    } else {
                                        phi_6831_ = _e3930;
                                    }
                                    let _e3933 = phi_6831_;
                                    if (_e3845 < 0f) {
                                        phi_6837_ = -(_e3845);
                                    } else {
                                        phi_6837_ = _e3845;
                                    }
                                    let _e3937 = phi_6837_;
                                    if (_e3848 < 0f) {
                                        phi_6843_ = -(_e3848);
                                    } else {
                                        phi_6843_ = _e3848;
                                    }
                                    let _e3941 = phi_6843_;
                                    if (_e3851 < 0f) {
                                        phi_6850_ = -(_e3851);
                                    } else {
                                        phi_6850_ = _e3851;
                                    }
                                    let _e3946 = phi_6850_;
                                    let _e3947 = ((_e3937 + _e3941) + _e3946);
                                    let _e3952 = -(_e3933);
                                    if (_e3912 > _e3952) {
                                        phi_6861_ = _e3912;
                                    } else {
                                        phi_6861_ = _e3952;
                                    }
                                    let _e3955 = phi_6861_;
                                    let _e3960 = (((_e3955 - ((_e3947 * _e3717) * (0.000000059604645f * (17f / 2f)))) - (_e3947 * _e3724)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3842 > _e3960) {
                                        phi_6871_ = _e3842;
                                    } else {
                                        phi_6871_ = _e3960;
                                    }
                                    let _e3963 = phi_6871_;
                                    let _e3964 = (_e3493 - _e3478);
                                    let _e3965 = (_e3494 - _e3479);
                                    let _e3966 = (_e3495 - _e3480);
                                    let _e3969 = ((_e3501 * _e3966) - (_e3504 * _e3965));
                                    let _e3972 = ((_e3504 * _e3964) - (_e3498 * _e3966));
                                    let _e3975 = ((_e3498 * _e3965) - (_e3501 * _e3964));
                                    let _e3980 = (((_e3969 * _e3507[0]) + (_e3972 * _e3507[1])) + (_e3975 * _e3507[2]));
                                    let _e3985 = (((_e3969 * _e3523) + (_e3972 * _e3524)) + (_e3975 * _e3525));
                                    let _e3990 = (((_e3969 * _e3526) + (_e3972 * _e3527)) + (_e3975 * _e3528));
                                    let _e3995 = (((_e3969 * _e3507[0]) + (_e3972 * _e3507[1])) + (_e3975 * _e3507[2]));
                                    let _e4000 = (((_e3969 * _e3531[0]) + (_e3972 * _e3531[1])) + (_e3975 * _e3531[2]));
                                    let _e4005 = (((_e3969 * _e3547) + (_e3972 * _e3548)) + (_e3975 * _e3549));
                                    let _e4010 = (((_e3969 * _e3550) + (_e3972 * _e3551)) + (_e3975 * _e3552));
                                    let _e4015 = (((_e3969 * _e3531[0]) + (_e3972 * _e3531[1])) + (_e3975 * _e3531[2]));
                                    if (_e3980 < _e3985) {
                                        phi_6944_ = _e3980;
                                    } else {
                                        phi_6944_ = _e3985;
                                    }
                                    let _e4018 = phi_6944_;
                                    if (_e3990 < _e3995) {
                                        phi_6949_ = _e3990;
                                    } else {
                                        phi_6949_ = _e3995;
                                    }
                                    let _e4021 = phi_6949_;
                                    if (_e4018 < _e4021) {
                                        phi_6954_ = _e4018;
                                    } else {
                                        phi_6954_ = _e4021;
                                    }
                                    let _e4024 = phi_6954_;
                                    if (_e4000 < _e4005) {
                                        phi_6959_ = _e4000;
                                    } else {
                                        phi_6959_ = _e4005;
                                    }
                                    let _e4027 = phi_6959_;
                                    if (_e4010 < _e4015) {
                                        phi_6964_ = _e4010;
                                    } else {
                                        phi_6964_ = _e4015;
                                    }
                                    let _e4030 = phi_6964_;
                                    if (_e4027 < _e4030) {
                                        phi_6969_ = _e4027;
                                    } else {
                                        phi_6969_ = _e4030;
                                    }
                                    let _e4033 = phi_6969_;
                                    if (_e4024 < _e4033) {
                                        phi_6974_ = _e4024;
                                    } else {
                                        phi_6974_ = _e4033;
                                    }
                                    let _e4036 = phi_6974_;
                                    if (_e3980 > _e3985) {
                                        phi_6979_ = _e3980;
                                    } else {
                                        phi_6979_ = _e3985;
                                    }
                                    let _e4039 = phi_6979_;
                                    if (_e3990 > _e3995) {
                                        phi_6984_ = _e3990;
                                    } else {
                                        phi_6984_ = _e3995;
                                    }
                                    let _e4042 = phi_6984_;
                                    if (_e4039 > _e4042) {
                                        phi_6989_ = _e4039;
                                    } else {
                                        phi_6989_ = _e4042;
                                    }
                                    let _e4045 = phi_6989_;
                                    if (_e4000 > _e4005) {
                                        phi_6994_ = _e4000;
                                    } else {
                                        phi_6994_ = _e4005;
                                    }
                                    let _e4048 = phi_6994_;
                                    if (_e4010 > _e4015) {
                                        phi_6999_ = _e4010;
                                    } else {
                                        phi_6999_ = _e4015;
                                    }
                                    let _e4051 = phi_6999_;
                                    if (_e4048 > _e4051) {
                                        phi_7004_ = _e4048;
                                    } else {
                                        phi_7004_ = _e4051;
                                    }
                                    let _e4054 = phi_7004_;
                                    if (_e4045 > _e4054) {
                                        phi_7009_ = _e4045;
                                    } else {
                                        phi_7009_ = _e4054;
                                    }
                                    let _e4057 = phi_7009_;
                                    if (_e3969 < 0f) {
                                        phi_7015_ = -(_e3969);
                                    } else {
                                        phi_7015_ = _e3969;
                                    }
                                    let _e4061 = phi_7015_;
                                    if (_e3972 < 0f) {
                                        phi_7021_ = -(_e3972);
                                    } else {
                                        phi_7021_ = _e3972;
                                    }
                                    let _e4065 = phi_7021_;
                                    if (_e3975 < 0f) {
                                        phi_7028_ = -(_e3975);
                                    } else {
                                        phi_7028_ = _e3975;
                                    }
                                    let _e4070 = phi_7028_;
                                    let _e4071 = ((_e4061 + _e4065) + _e4070);
                                    let _e4076 = -(_e4057);
                                    if (_e4036 > _e4076) {
                                        phi_7039_ = _e4036;
                                    } else {
                                        phi_7039_ = _e4076;
                                    }
                                    let _e4079 = phi_7039_;
                                    let _e4084 = (((_e4079 - ((_e4071 * _e3717) * (0.000000059604645f * (17f / 2f)))) - (_e4071 * _e3724)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3963 > _e4084) {
                                        phi_7049_ = _e3963;
                                    } else {
                                        phi_7049_ = _e4084;
                                    }
                                    let _e4087 = phi_7049_;
                                    phi_7053_ = (_e3465 || (_e4087 > 0f));
                                }
                                let _e4091 = phi_7053_;
                                if _e4091 {
                                    let _e4094 = local_1.member_1[0u];
                                    let _e4100 = local_1.member_2[0u];
                                    let _e4106 = ((_e4094[1] * _e4100[2]) - (_e4094[2] * _e4100[1]));
                                    let _e4109 = ((_e4094[2] * _e4100[0]) - (_e4094[0] * _e4100[2]));
                                    let _e4112 = ((_e4094[0] * _e4100[1]) - (_e4094[1] * _e4100[0]));
                                    let _e4115 = local_1.member_1[1u];
                                    let _e4121 = local_1.member_2[1u];
                                    let _e4127 = ((_e4115[1] * _e4121[2]) - (_e4115[2] * _e4121[1]));
                                    let _e4130 = ((_e4115[2] * _e4121[0]) - (_e4115[0] * _e4121[2]));
                                    let _e4133 = ((_e4115[0] * _e4121[1]) - (_e4115[1] * _e4121[0]));
                                    let _e4136 = local_1.member_1[0u];
                                    let _e4142 = local_1.member_2[1u];
                                    let _e4157 = local_1.member_1[1u];
                                    let _e4163 = local_1.member_2[0u];
                                    let _e4176 = (((_e4136[1] * _e4142[2]) - (_e4136[2] * _e4142[1])) + ((_e4157[1] * _e4163[2]) - (_e4157[2] * _e4163[1])));
                                    let _e4177 = (((_e4136[2] * _e4142[0]) - (_e4136[0] * _e4142[2])) + ((_e4157[2] * _e4163[0]) - (_e4157[0] * _e4163[2])));
                                    let _e4178 = (((_e4136[0] * _e4142[1]) - (_e4136[1] * _e4142[0])) + ((_e4157[0] * _e4163[1]) - (_e4157[1] * _e4163[0])));
                                    let _e4181 = local_1.member[0u];
                                    let _e4192 = local_1.member[1u];
                                    let _e4203 = local_1.member[0u];
                                    let _e4212 = ((((_e4192[0] * _e4106) + (_e4192[1] * _e4109)) + (_e4192[2] * _e4112)) + (((_e4203[0] * _e4176) + (_e4203[1] * _e4177)) + (_e4203[2] * _e4178)));
                                    let _e4215 = local_1.member[0u];
                                    let _e4226 = local_1.member[1u];
                                    let _e4235 = ((((_e4215[0] * _e4127) + (_e4215[1] * _e4130)) + (_e4215[2] * _e4133)) + (((_e4226[0] * _e4176) + (_e4226[1] * _e4177)) + (_e4226[2] * _e4178)));
                                    let _e4238 = local_1.member[1u];
                                    let _e4249 = local_1.member[0u];
                                    if (_e4249[0] < 0f) {
                                        phi_7298_ = -(_e4249[0]);
                                    } else {
                                        phi_7298_ = _e4249[0];
                                    }
                                    let _e4256 = phi_7298_;
                                    if (_e4249[1] < 0f) {
                                        phi_7305_ = -(_e4249[1]);
                                    } else {
                                        phi_7305_ = _e4249[1];
                                    }
                                    let _e4260 = phi_7305_;
                                    if (_e4256 > _e4260) {
                                        phi_7310_ = _e4256;
                                    } else {
                                        phi_7310_ = _e4260;
                                    }
                                    let _e4263 = phi_7310_;
                                    if (_e4249[2] < 0f) {
                                        phi_7317_ = -(_e4249[2]);
                                    } else {
                                        phi_7317_ = _e4249[2];
                                    }
                                    let _e4267 = phi_7317_;
                                    if (_e4263 > _e4267) {
                                        phi_7322_ = _e4263;
                                    } else {
                                        phi_7322_ = _e4267;
                                    }
                                    let _e4270 = phi_7322_;
                                    let _e4273 = local_1.member[1u];
                                    if (_e4273[0] < 0f) {
                                        phi_7335_ = -(_e4273[0]);
                                    } else {
                                        phi_7335_ = _e4273[0];
                                    }
                                    let _e4280 = phi_7335_;
                                    if (_e4273[1] < 0f) {
                                        phi_7342_ = -(_e4273[1]);
                                    } else {
                                        phi_7342_ = _e4273[1];
                                    }
                                    let _e4284 = phi_7342_;
                                    if (_e4280 > _e4284) {
                                        phi_7347_ = _e4280;
                                    } else {
                                        phi_7347_ = _e4284;
                                    }
                                    let _e4287 = phi_7347_;
                                    if (_e4273[2] < 0f) {
                                        phi_7354_ = -(_e4273[2]);
                                    } else {
                                        phi_7354_ = _e4273[2];
                                    }
                                    let _e4291 = phi_7354_;
                                    if (_e4287 > _e4291) {
                                        phi_7359_ = _e4287;
                                    } else {
                                        phi_7359_ = _e4291;
                                    }
                                    let _e4294 = phi_7359_;
                                    if (_e4270 > _e4294) {
                                        phi_7364_ = _e4270;
                                    } else {
                                        phi_7364_ = _e4294;
                                    }
                                    let _e4297 = phi_7364_;
                                    let _e4299 = local_1.member_3;
                                    let _e4300 = (_e4297 + _e4299);
                                    let _e4303 = local_1.member_1[0u];
                                    if (_e4303[0] < 0f) {
                                        phi_7381_ = -(_e4303[0]);
                                    } else {
                                        phi_7381_ = _e4303[0];
                                    }
                                    let _e4310 = phi_7381_;
                                    if (_e4303[1] < 0f) {
                                        phi_7388_ = -(_e4303[1]);
                                    } else {
                                        phi_7388_ = _e4303[1];
                                    }
                                    let _e4314 = phi_7388_;
                                    if (_e4310 > _e4314) {
                                        phi_7393_ = _e4310;
                                    } else {
                                        phi_7393_ = _e4314;
                                    }
                                    let _e4317 = phi_7393_;
                                    if (_e4303[2] < 0f) {
                                        phi_7400_ = -(_e4303[2]);
                                    } else {
                                        phi_7400_ = _e4303[2];
                                    }
                                    let _e4321 = phi_7400_;
                                    if (_e4317 > _e4321) {
                                        phi_7405_ = _e4317;
                                    } else {
                                        phi_7405_ = _e4321;
                                    }
                                    let _e4324 = phi_7405_;
                                    let _e4327 = local_1.member_1[1u];
                                    if (_e4327[0] < 0f) {
                                        phi_7419_ = -(_e4327[0]);
                                    } else {
                                        phi_7419_ = _e4327[0];
                                    }
                                    let _e4334 = phi_7419_;
                                    if (_e4327[1] < 0f) {
                                        phi_7426_ = -(_e4327[1]);
                                    } else {
                                        phi_7426_ = _e4327[1];
                                    }
                                    let _e4338 = phi_7426_;
                                    if (_e4334 > _e4338) {
                                        phi_7431_ = _e4334;
                                    } else {
                                        phi_7431_ = _e4338;
                                    }
                                    let _e4341 = phi_7431_;
                                    if (_e4327[2] < 0f) {
                                        phi_7438_ = -(_e4327[2]);
                                    } else {
                                        phi_7438_ = _e4327[2];
                                    }
                                    let _e4345 = phi_7438_;
                                    if (_e4341 > _e4345) {
                                        phi_7443_ = _e4341;
                                    } else {
                                        phi_7443_ = _e4345;
                                    }
                                    let _e4348 = phi_7443_;
                                    if (_e4324 > _e4348) {
                                        phi_7448_ = _e4324;
                                    } else {
                                        phi_7448_ = _e4348;
                                    }
                                    let _e4351 = phi_7448_;
                                    let _e4353 = local_1.member_3;
                                    let _e4354 = (_e4351 + _e4353);
                                    let _e4357 = local_1.member_2[0u];
                                    if (_e4357[0] < 0f) {
                                        phi_7465_ = -(_e4357[0]);
                                    } else {
                                        phi_7465_ = _e4357[0];
                                    }
                                    let _e4364 = phi_7465_;
                                    if (_e4357[1] < 0f) {
                                        phi_7472_ = -(_e4357[1]);
                                    } else {
                                        phi_7472_ = _e4357[1];
                                    }
                                    let _e4368 = phi_7472_;
                                    if (_e4364 > _e4368) {
                                        phi_7477_ = _e4364;
                                    } else {
                                        phi_7477_ = _e4368;
                                    }
                                    let _e4371 = phi_7477_;
                                    if (_e4357[2] < 0f) {
                                        phi_7484_ = -(_e4357[2]);
                                    } else {
                                        phi_7484_ = _e4357[2];
                                    }
                                    let _e4375 = phi_7484_;
                                    if (_e4371 > _e4375) {
                                        phi_7489_ = _e4371;
                                    } else {
                                        phi_7489_ = _e4375;
                                    }
                                    let _e4378 = phi_7489_;
                                    let _e4381 = local_1.member_2[1u];
                                    if (_e4381[0] < 0f) {
                                        phi_7503_ = -(_e4381[0]);
                                    } else {
                                        phi_7503_ = _e4381[0];
                                    }
                                    let _e4388 = phi_7503_;
                                    if (_e4381[1] < 0f) {
                                        phi_7510_ = -(_e4381[1]);
                                    } else {
                                        phi_7510_ = _e4381[1];
                                    }
                                    let _e4392 = phi_7510_;
                                    if (_e4388 > _e4392) {
                                        phi_7515_ = _e4388;
                                    } else {
                                        phi_7515_ = _e4392;
                                    }
                                    let _e4395 = phi_7515_;
                                    if (_e4381[2] < 0f) {
                                        phi_7522_ = -(_e4381[2]);
                                    } else {
                                        phi_7522_ = _e4381[2];
                                    }
                                    let _e4399 = phi_7522_;
                                    if (_e4395 > _e4399) {
                                        phi_7527_ = _e4395;
                                    } else {
                                        phi_7527_ = _e4399;
                                    }
                                    let _e4402 = phi_7527_;
                                    if (_e4378 > _e4402) {
                                        phi_7532_ = _e4378;
                                    } else {
                                        phi_7532_ = _e4402;
                                    }
                                    let _e4405 = phi_7532_;
                                    let _e4407 = local_1.member_3;
                                    let _e4408 = (_e4405 + _e4407);
                                    let _e4410 = ((_e4354 * 8f) * _e4408);
                                    let _e4417 = local_1.member_3;
                                    if (_e4106 < 0f) {
                                        phi_7563_ = -(_e4106);
                                    } else {
                                        phi_7563_ = _e4106;
                                    }
                                    let _e4434 = phi_7563_;
                                    if (_e4109 < 0f) {
                                        phi_7569_ = -(_e4109);
                                    } else {
                                        phi_7569_ = _e4109;
                                    }
                                    let _e4438 = phi_7569_;
                                    if (_e4112 < 0f) {
                                        phi_7576_ = -(_e4112);
                                    } else {
                                        phi_7576_ = _e4112;
                                    }
                                    let _e4443 = phi_7576_;
                                    let _e4444 = ((_e4434 + _e4438) + _e4443);
                                    if (_e4127 < 0f) {
                                        phi_7583_ = -(_e4127);
                                    } else {
                                        phi_7583_ = _e4127;
                                    }
                                    let _e4448 = phi_7583_;
                                    if (_e4130 < 0f) {
                                        phi_7589_ = -(_e4130);
                                    } else {
                                        phi_7589_ = _e4130;
                                    }
                                    let _e4452 = phi_7589_;
                                    if (_e4133 < 0f) {
                                        phi_7596_ = -(_e4133);
                                    } else {
                                        phi_7596_ = _e4133;
                                    }
                                    let _e4457 = phi_7596_;
                                    let _e4458 = ((_e4448 + _e4452) + _e4457);
                                    if (_e4444 > _e4458) {
                                        phi_7602_ = _e4444;
                                    } else {
                                        phi_7602_ = _e4458;
                                    }
                                    let _e4461 = phi_7602_;
                                    if (_e4176 < 0f) {
                                        phi_7608_ = -(_e4176);
                                    } else {
                                        phi_7608_ = _e4176;
                                    }
                                    let _e4465 = phi_7608_;
                                    if (_e4177 < 0f) {
                                        phi_7614_ = -(_e4177);
                                    } else {
                                        phi_7614_ = _e4177;
                                    }
                                    let _e4469 = phi_7614_;
                                    if (_e4178 < 0f) {
                                        phi_7621_ = -(_e4178);
                                    } else {
                                        phi_7621_ = _e4178;
                                    }
                                    let _e4474 = phi_7621_;
                                    let _e4476 = (((_e4465 + _e4469) + _e4474) * 0.5f);
                                    if (_e4461 > _e4476) {
                                        phi_7628_ = _e4461;
                                    } else {
                                        phi_7628_ = _e4476;
                                    }
                                    let _e4479 = phi_7628_;
                                    let _e4484 = local_1.member_3;
                                    let _e4497 = ((((_e4181[0] * _e4106) + (_e4181[1] * _e4109)) + (_e4181[2] * _e4112)) * 3f);
                                    let _e4498 = ((((_e4238[0] * _e4127) + (_e4238[1] * _e4130)) + (_e4238[2] * _e4133)) * 3f);
                                    if (_e4497 < _e4498) {
                                        phi_7652_ = _e4497;
                                    } else {
                                        phi_7652_ = _e4498;
                                    }
                                    let _e4501 = phi_7652_;
                                    if (_e4212 < _e4235) {
                                        phi_7657_ = _e4212;
                                    } else {
                                        phi_7657_ = _e4235;
                                    }
                                    let _e4504 = phi_7657_;
                                    if (_e4501 < _e4504) {
                                        phi_7662_ = _e4501;
                                    } else {
                                        phi_7662_ = _e4504;
                                    }
                                    let _e4507 = phi_7662_;
                                    if (_e4497 > _e4498) {
                                        phi_7667_ = _e4497;
                                    } else {
                                        phi_7667_ = _e4498;
                                    }
                                    let _e4510 = phi_7667_;
                                    if (_e4212 > _e4235) {
                                        phi_7672_ = _e4212;
                                    } else {
                                        phi_7672_ = _e4235;
                                    }
                                    let _e4513 = phi_7672_;
                                    if (_e4510 > _e4513) {
                                        phi_7677_ = _e4510;
                                    } else {
                                        phi_7677_ = _e4513;
                                    }
                                    let _e4516 = phi_7677_;
                                    let _e4521 = -(_e4516);
                                    if (_e4507 > _e4521) {
                                        phi_7687_ = _e4507;
                                    } else {
                                        phi_7687_ = _e4521;
                                    }
                                    let _e4524 = phi_7687_;
                                    let _e4526 = ((_e4524 - ((((((_e4300 * 8f) * _e4410) * (0.000000059604645f * (524f / 64f))) + ((_e4417 * 19f) * ((_e4300 * (_e4354 + _e4408)) + (_e4354 * _e4408)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4300) * ((1f + _e4354) * (1f + _e4408))))) + ((_e1810 * (((_e4479 + (_e4410 * (0.000000059604645f * 8f))) + ((_e4484 * 6f) * (_e4354 + _e4408))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4354) * (1f + _e4408))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4526 {
                                        phi_8656_ = _e4526;
                                    } else {
                                        let _e4529 = local_1.member_1[0u];
                                        let _e4535 = local_1.member_1[1u];
                                        let _e4539 = (_e4529[0] + _e4535[0]);
                                        let _e4540 = (_e4529[1] + _e4535[1]);
                                        let _e4541 = (_e4529[2] + _e4535[2]);
                                        let _e4544 = local_1.member_2[0u];
                                        let _e4550 = local_1.member_2[1u];
                                        let _e4554 = (_e4544[0] + _e4550[0]);
                                        let _e4555 = (_e4544[1] + _e4550[1]);
                                        let _e4556 = (_e4544[2] + _e4550[2]);
                                        let _e4559 = ((_e4540 * _e4556) - (_e4541 * _e4555));
                                        let _e4562 = ((_e4541 * _e4554) - (_e4539 * _e4556));
                                        let _e4565 = ((_e4539 * _e4555) - (_e4540 * _e4554));
                                        let _e4568 = local_1.member[0u];
                                        let _e4574 = local_1.member_1[0u];
                                        let _e4580 = local_1.member_2[0u];
                                        let _e4584 = (_e4568[0] - _e4574[0]);
                                        let _e4585 = (_e4568[1] - _e4574[1]);
                                        let _e4586 = (_e4568[2] - _e4574[2]);
                                        let _e4587 = (_e4568[0] - _e4580[0]);
                                        let _e4588 = (_e4568[1] - _e4580[1]);
                                        let _e4589 = (_e4568[2] - _e4580[2]);
                                        let _e4592 = local_1.member[1u];
                                        let _e4598 = local_1.member_1[1u];
                                        let _e4604 = local_1.member_2[1u];
                                        let _e4608 = (_e4592[0] - _e4598[0]);
                                        let _e4609 = (_e4592[1] - _e4598[1]);
                                        let _e4610 = (_e4592[2] - _e4598[2]);
                                        let _e4611 = (_e4592[0] - _e4604[0]);
                                        let _e4612 = (_e4592[1] - _e4604[1]);
                                        let _e4613 = (_e4592[2] - _e4604[2]);
                                        let _e4616 = local_1.member[0u];
                                        if (_e4616[0] < 0f) {
                                            phi_7890_ = -(_e4616[0]);
                                        } else {
                                            phi_7890_ = _e4616[0];
                                        }
                                        let _e4623 = phi_7890_;
                                        if (_e4616[1] < 0f) {
                                            phi_7897_ = -(_e4616[1]);
                                        } else {
                                            phi_7897_ = _e4616[1];
                                        }
                                        let _e4627 = phi_7897_;
                                        if (_e4623 > _e4627) {
                                            phi_7902_ = _e4623;
                                        } else {
                                            phi_7902_ = _e4627;
                                        }
                                        let _e4630 = phi_7902_;
                                        if (_e4616[2] < 0f) {
                                            phi_7909_ = -(_e4616[2]);
                                        } else {
                                            phi_7909_ = _e4616[2];
                                        }
                                        let _e4634 = phi_7909_;
                                        if (_e4630 > _e4634) {
                                            phi_7914_ = _e4630;
                                        } else {
                                            phi_7914_ = _e4634;
                                        }
                                        let _e4637 = phi_7914_;
                                        let _e4640 = local_1.member[1u];
                                        if (_e4640[0] < 0f) {
                                            phi_7927_ = -(_e4640[0]);
                                        } else {
                                            phi_7927_ = _e4640[0];
                                        }
                                        let _e4647 = phi_7927_;
                                        if (_e4640[1] < 0f) {
                                            phi_7934_ = -(_e4640[1]);
                                        } else {
                                            phi_7934_ = _e4640[1];
                                        }
                                        let _e4651 = phi_7934_;
                                        if (_e4647 > _e4651) {
                                            phi_7939_ = _e4647;
                                        } else {
                                            phi_7939_ = _e4651;
                                        }
                                        let _e4654 = phi_7939_;
                                        if (_e4640[2] < 0f) {
                                            phi_7946_ = -(_e4640[2]);
                                        } else {
                                            phi_7946_ = _e4640[2];
                                        }
                                        let _e4658 = phi_7946_;
                                        if (_e4654 > _e4658) {
                                            phi_7951_ = _e4654;
                                        } else {
                                            phi_7951_ = _e4658;
                                        }
                                        let _e4661 = phi_7951_;
                                        if (_e4637 > _e4661) {
                                            phi_7956_ = _e4637;
                                        } else {
                                            phi_7956_ = _e4661;
                                        }
                                        let _e4664 = phi_7956_;
                                        let _e4666 = local_1.member_3;
                                        let _e4670 = local_1.member_1[0u];
                                        if (_e4670[0] < 0f) {
                                            phi_7973_ = -(_e4670[0]);
                                        } else {
                                            phi_7973_ = _e4670[0];
                                        }
                                        let _e4677 = phi_7973_;
                                        if (_e4670[1] < 0f) {
                                            phi_7980_ = -(_e4670[1]);
                                        } else {
                                            phi_7980_ = _e4670[1];
                                        }
                                        let _e4681 = phi_7980_;
                                        if (_e4677 > _e4681) {
                                            phi_7985_ = _e4677;
                                        } else {
                                            phi_7985_ = _e4681;
                                        }
                                        let _e4684 = phi_7985_;
                                        if (_e4670[2] < 0f) {
                                            phi_7992_ = -(_e4670[2]);
                                        } else {
                                            phi_7992_ = _e4670[2];
                                        }
                                        let _e4688 = phi_7992_;
                                        if (_e4684 > _e4688) {
                                            phi_7997_ = _e4684;
                                        } else {
                                            phi_7997_ = _e4688;
                                        }
                                        let _e4691 = phi_7997_;
                                        let _e4694 = local_1.member_1[1u];
                                        if (_e4694[0] < 0f) {
                                            phi_8011_ = -(_e4694[0]);
                                        } else {
                                            phi_8011_ = _e4694[0];
                                        }
                                        let _e4701 = phi_8011_;
                                        if (_e4694[1] < 0f) {
                                            phi_8018_ = -(_e4694[1]);
                                        } else {
                                            phi_8018_ = _e4694[1];
                                        }
                                        let _e4705 = phi_8018_;
                                        if (_e4701 > _e4705) {
                                            phi_8023_ = _e4701;
                                        } else {
                                            phi_8023_ = _e4705;
                                        }
                                        let _e4708 = phi_8023_;
                                        if (_e4694[2] < 0f) {
                                            phi_8030_ = -(_e4694[2]);
                                        } else {
                                            phi_8030_ = _e4694[2];
                                        }
                                        let _e4712 = phi_8030_;
                                        if (_e4708 > _e4712) {
                                            phi_8035_ = _e4708;
                                        } else {
                                            phi_8035_ = _e4712;
                                        }
                                        let _e4715 = phi_8035_;
                                        if (_e4691 > _e4715) {
                                            phi_8040_ = _e4691;
                                        } else {
                                            phi_8040_ = _e4715;
                                        }
                                        let _e4718 = phi_8040_;
                                        let _e4720 = local_1.member_3;
                                        let _e4724 = local_1.member_2[0u];
                                        if (_e4724[0] < 0f) {
                                            phi_8057_ = -(_e4724[0]);
                                        } else {
                                            phi_8057_ = _e4724[0];
                                        }
                                        let _e4731 = phi_8057_;
                                        if (_e4724[1] < 0f) {
                                            phi_8064_ = -(_e4724[1]);
                                        } else {
                                            phi_8064_ = _e4724[1];
                                        }
                                        let _e4735 = phi_8064_;
                                        if (_e4731 > _e4735) {
                                            phi_8069_ = _e4731;
                                        } else {
                                            phi_8069_ = _e4735;
                                        }
                                        let _e4738 = phi_8069_;
                                        if (_e4724[2] < 0f) {
                                            phi_8076_ = -(_e4724[2]);
                                        } else {
                                            phi_8076_ = _e4724[2];
                                        }
                                        let _e4742 = phi_8076_;
                                        if (_e4738 > _e4742) {
                                            phi_8081_ = _e4738;
                                        } else {
                                            phi_8081_ = _e4742;
                                        }
                                        let _e4745 = phi_8081_;
                                        let _e4748 = local_1.member_2[1u];
                                        if (_e4748[0] < 0f) {
                                            phi_8095_ = -(_e4748[0]);
                                        } else {
                                            phi_8095_ = _e4748[0];
                                        }
                                        let _e4755 = phi_8095_;
                                        if (_e4748[1] < 0f) {
                                            phi_8102_ = -(_e4748[1]);
                                        } else {
                                            phi_8102_ = _e4748[1];
                                        }
                                        let _e4759 = phi_8102_;
                                        if (_e4755 > _e4759) {
                                            phi_8107_ = _e4755;
                                        } else {
                                            phi_8107_ = _e4759;
                                        }
                                        let _e4762 = phi_8107_;
                                        if (_e4748[2] < 0f) {
                                            phi_8114_ = -(_e4748[2]);
                                        } else {
                                            phi_8114_ = _e4748[2];
                                        }
                                        let _e4766 = phi_8114_;
                                        if (_e4762 > _e4766) {
                                            phi_8119_ = _e4762;
                                        } else {
                                            phi_8119_ = _e4766;
                                        }
                                        let _e4769 = phi_8119_;
                                        if (_e4745 > _e4769) {
                                            phi_8124_ = _e4745;
                                        } else {
                                            phi_8124_ = _e4769;
                                        }
                                        let _e4772 = phi_8124_;
                                        let _e4774 = local_1.member_3;
                                        let _e4778 = ((((_e4664 + _e4666) + (_e4718 + _e4720)) + (_e4772 + _e4774)) * 2f);
                                        let _e4781 = local_1.member_3;
                                        let _e4785 = (((_e1810 * 1.0001f) + (_e4781 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4788 = ((_e4562 * _e4541) - (_e4565 * _e4540));
                                        let _e4791 = ((_e4565 * _e4539) - (_e4559 * _e4541));
                                        let _e4794 = ((_e4559 * _e4540) - (_e4562 * _e4539));
                                        let _e4799 = (((_e4788 * _e4568[0]) + (_e4791 * _e4568[1])) + (_e4794 * _e4568[2]));
                                        let _e4804 = (((_e4788 * _e4584) + (_e4791 * _e4585)) + (_e4794 * _e4586));
                                        let _e4809 = (((_e4788 * _e4587) + (_e4791 * _e4588)) + (_e4794 * _e4589));
                                        let _e4814 = (((_e4788 * _e4568[0]) + (_e4791 * _e4568[1])) + (_e4794 * _e4568[2]));
                                        let _e4819 = (((_e4788 * _e4592[0]) + (_e4791 * _e4592[1])) + (_e4794 * _e4592[2]));
                                        let _e4824 = (((_e4788 * _e4608) + (_e4791 * _e4609)) + (_e4794 * _e4610));
                                        let _e4829 = (((_e4788 * _e4611) + (_e4791 * _e4612)) + (_e4794 * _e4613));
                                        let _e4834 = (((_e4788 * _e4592[0]) + (_e4791 * _e4592[1])) + (_e4794 * _e4592[2]));
                                        if (_e4799 < _e4804) {
                                            phi_8203_ = _e4799;
                                        } else {
                                            phi_8203_ = _e4804;
                                        }
                                        let _e4837 = phi_8203_;
                                        if (_e4809 < _e4814) {
                                            phi_8208_ = _e4809;
                                        } else {
                                            phi_8208_ = _e4814;
                                        }
                                        let _e4840 = phi_8208_;
                                        if (_e4837 < _e4840) {
                                            phi_8213_ = _e4837;
                                        } else {
                                            phi_8213_ = _e4840;
                                        }
                                        let _e4843 = phi_8213_;
                                        if (_e4819 < _e4824) {
                                            phi_8218_ = _e4819;
                                        } else {
                                            phi_8218_ = _e4824;
                                        }
                                        let _e4846 = phi_8218_;
                                        if (_e4829 < _e4834) {
                                            phi_8223_ = _e4829;
                                        } else {
                                            phi_8223_ = _e4834;
                                        }
                                        let _e4849 = phi_8223_;
                                        if (_e4846 < _e4849) {
                                            phi_8228_ = _e4846;
                                        } else {
                                            phi_8228_ = _e4849;
                                        }
                                        let _e4852 = phi_8228_;
                                        if (_e4843 < _e4852) {
                                            phi_8233_ = _e4843;
                                        } else {
                                            phi_8233_ = _e4852;
                                        }
                                        let _e4855 = phi_8233_;
                                        if (_e4799 > _e4804) {
                                            phi_8238_ = _e4799;
                                        } else {
                                            phi_8238_ = _e4804;
                                        }
                                        let _e4858 = phi_8238_;
                                        if (_e4809 > _e4814) {
                                            phi_8243_ = _e4809;
                                        } else {
                                            phi_8243_ = _e4814;
                                        }
                                        let _e4861 = phi_8243_;
                                        if (_e4858 > _e4861) {
                                            phi_8248_ = _e4858;
                                        } else {
                                            phi_8248_ = _e4861;
                                        }
                                        let _e4864 = phi_8248_;
                                        if (_e4819 > _e4824) {
                                            phi_8253_ = _e4819;
                                        } else {
                                            phi_8253_ = _e4824;
                                        }
                                        let _e4867 = phi_8253_;
                                        if (_e4829 > _e4834) {
                                            phi_8258_ = _e4829;
                                        } else {
                                            phi_8258_ = _e4834;
                                        }
                                        let _e4870 = phi_8258_;
                                        if (_e4867 > _e4870) {
                                            phi_8263_ = _e4867;
                                        } else {
                                            phi_8263_ = _e4870;
                                        }
                                        let _e4873 = phi_8263_;
                                        if (_e4864 > _e4873) {
                                            phi_8268_ = _e4864;
                                        } else {
                                            phi_8268_ = _e4873;
                                        }
                                        let _e4876 = phi_8268_;
                                        if (_e4788 < 0f) {
                                            phi_8274_ = -(_e4788);
                                        } else {
                                            phi_8274_ = _e4788;
                                        }
                                        let _e4880 = phi_8274_;
                                        if (_e4791 < 0f) {
                                            phi_8280_ = -(_e4791);
                                        } else {
                                            phi_8280_ = _e4791;
                                        }
                                        let _e4884 = phi_8280_;
                                        if (_e4794 < 0f) {
                                            phi_8287_ = -(_e4794);
                                        } else {
                                            phi_8287_ = _e4794;
                                        }
                                        let _e4889 = phi_8287_;
                                        let _e4890 = ((_e4880 + _e4884) + _e4889);
                                        let _e4895 = -(_e4876);
                                        if (_e4855 > _e4895) {
                                            phi_8298_ = _e4855;
                                        } else {
                                            phi_8298_ = _e4895;
                                        }
                                        let _e4898 = phi_8298_;
                                        let _e4903 = (((_e4898 - ((_e4890 * _e4778) * (0.000000059604645f * (17f / 2f)))) - (_e4890 * _e4785)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4906 = ((_e4562 * _e4556) - (_e4565 * _e4555));
                                        let _e4909 = ((_e4565 * _e4554) - (_e4559 * _e4556));
                                        let _e4912 = ((_e4559 * _e4555) - (_e4562 * _e4554));
                                        let _e4917 = (((_e4906 * _e4568[0]) + (_e4909 * _e4568[1])) + (_e4912 * _e4568[2]));
                                        let _e4922 = (((_e4906 * _e4584) + (_e4909 * _e4585)) + (_e4912 * _e4586));
                                        let _e4927 = (((_e4906 * _e4587) + (_e4909 * _e4588)) + (_e4912 * _e4589));
                                        let _e4932 = (((_e4906 * _e4568[0]) + (_e4909 * _e4568[1])) + (_e4912 * _e4568[2]));
                                        let _e4937 = (((_e4906 * _e4592[0]) + (_e4909 * _e4592[1])) + (_e4912 * _e4592[2]));
                                        let _e4942 = (((_e4906 * _e4608) + (_e4909 * _e4609)) + (_e4912 * _e4610));
                                        let _e4947 = (((_e4906 * _e4611) + (_e4909 * _e4612)) + (_e4912 * _e4613));
                                        let _e4952 = (((_e4906 * _e4592[0]) + (_e4909 * _e4592[1])) + (_e4912 * _e4592[2]));
                                        if (_e4917 < _e4922) {
                                            phi_8369_ = _e4917;
                                        } else {
                                            phi_8369_ = _e4922;
                                        }
                                        let _e4955 = phi_8369_;
                                        if (_e4927 < _e4932) {
                                            phi_8374_ = _e4927;
                                        } else {
                                            phi_8374_ = _e4932;
                                        }
                                        let _e4958 = phi_8374_;
                                        if (_e4955 < _e4958) {
                                            phi_8379_ = _e4955;
                                        } else {
                                            phi_8379_ = _e4958;
                                        }
                                        let _e4961 = phi_8379_;
                                        if (_e4937 < _e4942) {
                                            phi_8384_ = _e4937;
                                        } else {
                                            phi_8384_ = _e4942;
                                        }
                                        let _e4964 = phi_8384_;
                                        if (_e4947 < _e4952) {
                                            phi_8389_ = _e4947;
                                        } else {
                                            phi_8389_ = _e4952;
                                        }
                                        let _e4967 = phi_8389_;
                                        if (_e4964 < _e4967) {
                                            phi_8394_ = _e4964;
                                        } else {
                                            phi_8394_ = _e4967;
                                        }
                                        let _e4970 = phi_8394_;
                                        if (_e4961 < _e4970) {
                                            phi_8399_ = _e4961;
                                        } else {
                                            phi_8399_ = _e4970;
                                        }
                                        let _e4973 = phi_8399_;
                                        if (_e4917 > _e4922) {
                                            phi_8404_ = _e4917;
                                        } else {
                                            phi_8404_ = _e4922;
                                        }
                                        let _e4976 = phi_8404_;
                                        if (_e4927 > _e4932) {
                                            phi_8409_ = _e4927;
                                        } else {
                                            phi_8409_ = _e4932;
                                        }
                                        let _e4979 = phi_8409_;
                                        if (_e4976 > _e4979) {
                                            phi_8414_ = _e4976;
                                        } else {
                                            phi_8414_ = _e4979;
                                        }
                                        let _e4982 = phi_8414_;
                                        if (_e4937 > _e4942) {
                                            phi_8419_ = _e4937;
                                        } else {
                                            phi_8419_ = _e4942;
                                        }
                                        let _e4985 = phi_8419_;
                                        if (_e4947 > _e4952) {
                                            phi_8424_ = _e4947;
                                        } else {
                                            phi_8424_ = _e4952;
                                        }
                                        let _e4988 = phi_8424_;
                                        if (_e4985 > _e4988) {
                                            phi_8429_ = _e4985;
                                        } else {
                                            phi_8429_ = _e4988;
                                        }
                                        let _e4991 = phi_8429_;
                                        if (_e4982 > _e4991) {
                                            phi_8434_ = _e4982;
                                        } else {
                                            phi_8434_ = _e4991;
                                        }
                                        let _e4994 = phi_8434_;
                                        if (_e4906 < 0f) {
                                            phi_8440_ = -(_e4906);
                                        } else {
                                            phi_8440_ = _e4906;
                                        }
                                        let _e4998 = phi_8440_;
                                        if (_e4909 < 0f) {
                                            phi_8446_ = -(_e4909);
                                        } else {
                                            phi_8446_ = _e4909;
                                        }
                                        let _e5002 = phi_8446_;
                                        if (_e4912 < 0f) {
                                            phi_8453_ = -(_e4912);
                                        } else {
                                            phi_8453_ = _e4912;
                                        }
                                        let _e5007 = phi_8453_;
                                        let _e5008 = ((_e4998 + _e5002) + _e5007);
                                        let _e5013 = -(_e4994);
                                        if (_e4973 > _e5013) {
                                            phi_8464_ = _e4973;
                                        } else {
                                            phi_8464_ = _e5013;
                                        }
                                        let _e5016 = phi_8464_;
                                        let _e5021 = (((_e5016 - ((_e5008 * _e4778) * (0.000000059604645f * (17f / 2f)))) - (_e5008 * _e4785)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4903 > _e5021) {
                                            phi_8474_ = _e4903;
                                        } else {
                                            phi_8474_ = _e5021;
                                        }
                                        let _e5024 = phi_8474_;
                                        let _e5025 = (_e4554 - _e4539);
                                        let _e5026 = (_e4555 - _e4540);
                                        let _e5027 = (_e4556 - _e4541);
                                        let _e5030 = ((_e4562 * _e5027) - (_e4565 * _e5026));
                                        let _e5033 = ((_e4565 * _e5025) - (_e4559 * _e5027));
                                        let _e5036 = ((_e4559 * _e5026) - (_e4562 * _e5025));
                                        let _e5041 = (((_e5030 * _e4568[0]) + (_e5033 * _e4568[1])) + (_e5036 * _e4568[2]));
                                        let _e5046 = (((_e5030 * _e4584) + (_e5033 * _e4585)) + (_e5036 * _e4586));
                                        let _e5051 = (((_e5030 * _e4587) + (_e5033 * _e4588)) + (_e5036 * _e4589));
                                        let _e5056 = (((_e5030 * _e4568[0]) + (_e5033 * _e4568[1])) + (_e5036 * _e4568[2]));
                                        let _e5061 = (((_e5030 * _e4592[0]) + (_e5033 * _e4592[1])) + (_e5036 * _e4592[2]));
                                        let _e5066 = (((_e5030 * _e4608) + (_e5033 * _e4609)) + (_e5036 * _e4610));
                                        let _e5071 = (((_e5030 * _e4611) + (_e5033 * _e4612)) + (_e5036 * _e4613));
                                        let _e5076 = (((_e5030 * _e4592[0]) + (_e5033 * _e4592[1])) + (_e5036 * _e4592[2]));
                                        if (_e5041 < _e5046) {
                                            phi_8547_ = _e5041;
                                        } else {
                                            phi_8547_ = _e5046;
                                        }
                                        let _e5079 = phi_8547_;
                                        if (_e5051 < _e5056) {
                                            phi_8552_ = _e5051;
                                        } else {
                                            phi_8552_ = _e5056;
                                        }
                                        let _e5082 = phi_8552_;
                                        if (_e5079 < _e5082) {
                                            phi_8557_ = _e5079;
                                        } else {
                                            phi_8557_ = _e5082;
                                        }
                                        let _e5085 = phi_8557_;
                                        if (_e5061 < _e5066) {
                                            phi_8562_ = _e5061;
                                        } else {
                                            phi_8562_ = _e5066;
                                        }
                                        let _e5088 = phi_8562_;
                                        if (_e5071 < _e5076) {
                                            phi_8567_ = _e5071;
                                        } else {
                                            phi_8567_ = _e5076;
                                        }
                                        let _e5091 = phi_8567_;
                                        if (_e5088 < _e5091) {
                                            phi_8572_ = _e5088;
                                        } else {
                                            phi_8572_ = _e5091;
                                        }
                                        let _e5094 = phi_8572_;
                                        if (_e5085 < _e5094) {
                                            phi_8577_ = _e5085;
                                        } else {
                                            phi_8577_ = _e5094;
                                        }
                                        let _e5097 = phi_8577_;
                                        if (_e5041 > _e5046) {
                                            phi_8582_ = _e5041;
                                        } else {
                                            phi_8582_ = _e5046;
                                        }
                                        let _e5100 = phi_8582_;
                                        if (_e5051 > _e5056) {
                                            phi_8587_ = _e5051;
                                        } else {
                                            phi_8587_ = _e5056;
                                        }
                                        let _e5103 = phi_8587_;
                                        if (_e5100 > _e5103) {
                                            phi_8592_ = _e5100;
                                        } else {
                                            phi_8592_ = _e5103;
                                        }
                                        let _e5106 = phi_8592_;
                                        if (_e5061 > _e5066) {
                                            phi_8597_ = _e5061;
                                        } else {
                                            phi_8597_ = _e5066;
                                        }
                                        let _e5109 = phi_8597_;
                                        if (_e5071 > _e5076) {
                                            phi_8602_ = _e5071;
                                        } else {
                                            phi_8602_ = _e5076;
                                        }
                                        let _e5112 = phi_8602_;
                                        if (_e5109 > _e5112) {
                                            phi_8607_ = _e5109;
                                        } else {
                                            phi_8607_ = _e5112;
                                        }
                                        let _e5115 = phi_8607_;
                                        if (_e5106 > _e5115) {
                                            phi_8612_ = _e5106;
                                        } else {
                                            phi_8612_ = _e5115;
                                        }
                                        let _e5118 = phi_8612_;
                                        if (_e5030 < 0f) {
                                            phi_8618_ = -(_e5030);
                                        } else {
                                            phi_8618_ = _e5030;
                                        }
                                        let _e5122 = phi_8618_;
                                        if (_e5033 < 0f) {
                                            phi_8624_ = -(_e5033);
                                        } else {
                                            phi_8624_ = _e5033;
                                        }
                                        let _e5126 = phi_8624_;
                                        if (_e5036 < 0f) {
                                            phi_8631_ = -(_e5036);
                                        } else {
                                            phi_8631_ = _e5036;
                                        }
                                        let _e5131 = phi_8631_;
                                        let _e5132 = ((_e5122 + _e5126) + _e5131);
                                        let _e5137 = -(_e5118);
                                        if (_e5097 > _e5137) {
                                            phi_8642_ = _e5097;
                                        } else {
                                            phi_8642_ = _e5137;
                                        }
                                        let _e5140 = phi_8642_;
                                        let _e5145 = (((_e5140 - ((_e5132 * _e4778) * (0.000000059604645f * (17f / 2f)))) - (_e5132 * _e4785)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5024 > _e5145) {
                                            phi_8652_ = _e5024;
                                        } else {
                                            phi_8652_ = _e5145;
                                        }
                                        let _e5148 = phi_8652_;
                                        phi_8656_ = (_e4526 || (_e5148 > 0f));
                                    }
                                    let _e5152 = phi_8656_;
                                    phi_8658_ = (_e4091 && _e5152);
                                } else {
                                    phi_8658_ = _e4091;
                                }
                                let _e5155 = phi_8658_;
                                phi_8660_ = (_e2940 || _e5155);
                            }
                            let _e5158 = phi_8660_;
                            if !(_e5158) {
                                let _e5161 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1165] = ((2147483648u | (_e5161 << bitcast<u32>(12i))) | _e1168);
                            }
                        }
                        phi_8671_ = true;
                    }
                    let _e5168 = phi_8671_;
                    phi_8672_ = _e5168;
                } else {
                    phi_8672_ = false;
                }
                let _e5170 = phi_8672_;
                continue;
                continuing {
                    phi_2256_ = _e1157;
                    break if !(_e5170);
                }
            }
            workgroupBarrier();
            if (_e71 == 0u) {
                let _e5174 = atomicLoad((&counters[5u]));
                if (_e5174 > 0u) {
                    let _e5177 = atomicAdd((&output.member[0u]), _e5174);
                    if ((_e5177 + _e5174) < _e5177) {
                        let _e5181 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e5177);
                }
            }
            workgroupBarrier();
            let _e5184 = atomicLoad((&counters[6u]));
            if (_e71 == 0u) {
                let _e5187 = atomicLoad((&counters[7u]));
                if (_e5187 > 0u) {
                    let _e5190 = atomicAdd((&output.member[1u]), _e5187);
                    if ((_e5190 + _e5187) < _e5190) {
                        let _e5194 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_8723_ = type_9(0u, 16u);
            loop {
                let _e5196 = phi_8723_;
                if (_e5196.member < _e5196.member_1) {
                    phi_8724_ = type_9((_e5196.member + 1u), _e5196.member_1);
                    phi_8747_ = type_9(1u, _e5196.member);
                } else {
                    phi_8724_ = _e5196;
                    phi_8747_ = type_9(0u, type_9().member_1);
                }
                let _e5208 = phi_8724_;
                let _e5210 = phi_8747_;
                if (bitcast<i32>(_e5210.member) != 0i) {
                    let _e5216 = (_e71 + (_e5210.member_1 * 128u));
                    if (_e5216 >= _e1143) {
                        phi_8841_ = false;
                    } else {
                        let _e5219 = hits[_e5216];
                        if ((_e5219 & 2147483648u) == 0u) {
                            phi_8770_ = 4294967295u;
                        } else {
                            phi_8770_ = ((_e5219 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e5226 = phi_8770_;
                        if (_e5226 != 4294967295u) {
                            let _e5230 = ((_e5219 >> bitcast<u32>(10i)) & 3u);
                            let _e5237 = firsts[(2u * _e5230)];
                            let _e5242 = firsts[((2u * _e5230) + 1u)];
                            let _e5245 = leaves.member[(_e5237 + ((_e5219 >> bitcast<u32>(5i)) & 31u))];
                            let _e5247 = leaves.member[(_e5242 + (_e5219 & 31u))];
                            let _e5250 = (_e5184 + _e5226);
                            if (_e5250 < _e90) {
                                let _e5252 = (2u * _e5250);
                                atomicStore((&output.member[(4u + _e5252)]), _e5245.member_1);
                                atomicStore((&output.member[(_e5252 + 5u)]), _e5247.member_1);
                            }
                        }
                        phi_8841_ = true;
                    }
                    let _e5258 = phi_8841_;
                    phi_8842_ = _e5258;
                } else {
                    phi_8842_ = false;
                }
                let _e5260 = phi_8842_;
                continue;
                continuing {
                    phi_8723_ = _e5208;
                    break if !(_e5260);
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
fn filter_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
