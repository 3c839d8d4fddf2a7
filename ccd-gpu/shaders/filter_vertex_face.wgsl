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

struct type_10 {
    member: array<u32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
}

struct type_17 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_21 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_24 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_28 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_37 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_39 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_43 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(2) 
var<storage> leaves: type_26;
@group(0) @binding(1) 
var<storage> nodes: type_30;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_32, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(3) 
var<storage> bodies: type_10;
@group(0) @binding(4) 
var<storage> keys: type_37;
@group(0) @binding(5) 
var<storage> paths: type_23;
@group(0) @binding(6) 
var<storage> input: type_10;
@group(0) @binding(7) 
var<storage, read_write> output: type_43;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_174_: bool;
    var phi_175_: bool;
    var phi_179_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_175_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_174_ = (param[0] > param_1[0]);
        } else {
            phi_174_ = false;
        }
        let _e14 = phi_174_;
        phi_175_ = _e14;
    }
    let _e16 = phi_175_;
    if _e16 {
        phi_179_ = param_1;
    } else {
        phi_179_ = param;
    }
    let _e18 = phi_179_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_198_: bool;
    var phi_199_: bool;
    var phi_203_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_199_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_198_ = (param_3[0] > param_2[0]);
        } else {
            phi_198_ = false;
        }
        let _e14 = phi_198_;
        phi_199_ = _e14;
    }
    let _e16 = phi_199_;
    if _e16 {
        phi_203_ = param_3;
    } else {
        phi_203_ = param_2;
    }
    let _e18 = phi_203_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_222_: bool;
    var phi_223_: bool;
    var phi_227_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_223_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_222_ = (param_4[0] > param_5[0]);
        } else {
            phi_222_ = false;
        }
        let _e14 = phi_222_;
        phi_223_ = _e14;
    }
    let _e16 = phi_223_;
    if _e16 {
        phi_227_ = param_5;
    } else {
        phi_227_ = param_4;
    }
    let _e18 = phi_227_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_246_: bool;
    var phi_247_: bool;
    var phi_251_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_247_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_246_ = (param_7[0] > param_6[0]);
        } else {
            phi_246_ = false;
        }
        let _e14 = phi_246_;
        phi_247_ = _e14;
    }
    let _e16 = phi_247_;
    if _e16 {
        phi_251_ = param_7;
    } else {
        phi_251_ = param_6;
    }
    let _e18 = phi_251_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_270_: bool;
    var phi_271_: bool;
    var phi_275_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_271_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_270_ = (param_8[0] > param_9[0]);
        } else {
            phi_270_ = false;
        }
        let _e14 = phi_270_;
        phi_271_ = _e14;
    }
    let _e16 = phi_271_;
    if _e16 {
        phi_275_ = param_9;
    } else {
        phi_275_ = param_8;
    }
    let _e18 = phi_275_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_299_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_295_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_294_ = (param_11[0] > param_10[0]);
        } else {
            phi_294_ = false;
        }
        let _e14 = phi_294_;
        phi_295_ = _e14;
    }
    let _e16 = phi_295_;
    if _e16 {
        phi_299_ = param_11;
    } else {
        phi_299_ = param_10;
    }
    let _e18 = phi_299_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_39;
    var local_1: type_39;
    var local_2: type_39;
    var phi_346_: u32;
    var phi_387_: u32;
    var phi_388_: u32;
    var phi_396_: u32;
    var phi_412_: u32;
    var phi_433_: u32;
    var phi_434_: u32;
    var phi_437_: type_13;
    var phi_438_: type_13;
    var phi_461_: type_13;
    var phi_502_: u32;
    var phi_503_: u32;
    var phi_511_: u32;
    var phi_523_: u32;
    var phi_608_: array<u32, 2>;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_817_: type_32;
    var phi_830_: type_13;
    var phi_833_: u32;
    var phi_831_: type_13;
    var phi_856_: type_13;
    var phi_946_: u32;
    var phi_948_: u32;
    var phi_834_: u32;
    var phi_951_: type_13;
    var phi_954_: u32;
    var phi_952_: type_13;
    var phi_977_: type_13;
    var phi_1071_: bool;
    var phi_1078_: bool;
    var phi_1086_: bool;
    var phi_1109_: bool;
    var phi_1110_: bool;
    var phi_1156_: bool;
    var phi_1163_: bool;
    var phi_1167_: bool;
    var phi_1291_: bool;
    var phi_1292_: bool;
    var phi_1385_: bool;
    var phi_1386_: bool;
    var phi_1480_: bool;
    var phi_1481_: bool;
    var phi_1574_: bool;
    var phi_1575_: bool;
    var phi_1670_: bool;
    var phi_1671_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1783_: bool;
    var phi_1845_: u32;
    var phi_1846_: bool;
    var phi_955_: u32;
    var phi_1847_: bool;
    var phi_1854_: u32;
    var phi_1857_: type_13;
    var phi_1858_: type_13;
    var phi_1881_: type_13;
    var phi_1983_: bool;
    var phi_1990_: bool;
    var phi_1998_: bool;
    var phi_2021_: bool;
    var phi_2022_: bool;
    var phi_2068_: bool;
    var phi_2075_: bool;
    var phi_2079_: bool;
    var phi_2203_: bool;
    var phi_2204_: bool;
    var phi_2297_: bool;
    var phi_2298_: bool;
    var phi_2392_: bool;
    var phi_2393_: bool;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2582_: bool;
    var phi_2583_: bool;
    var phi_2676_: bool;
    var phi_2677_: bool;
    var phi_2681_: bool;
    var phi_2682_: bool;
    var phi_2683_: bool;
    var phi_2687_: bool;
    var phi_2688_: bool;
    var phi_2689_: bool;
    var phi_2690_: bool;
    var phi_2691_: bool;
    var phi_2695_: bool;
    var phi_3090_: f32;
    var phi_3097_: f32;
    var phi_3102_: f32;
    var phi_3109_: f32;
    var phi_3114_: f32;
    var phi_3127_: f32;
    var phi_3134_: f32;
    var phi_3139_: f32;
    var phi_3146_: f32;
    var phi_3151_: f32;
    var phi_3156_: f32;
    var phi_3173_: f32;
    var phi_3180_: f32;
    var phi_3185_: f32;
    var phi_3192_: f32;
    var phi_3197_: f32;
    var phi_3211_: f32;
    var phi_3218_: f32;
    var phi_3223_: f32;
    var phi_3230_: f32;
    var phi_3235_: f32;
    var phi_3240_: f32;
    var phi_3257_: f32;
    var phi_3264_: f32;
    var phi_3269_: f32;
    var phi_3276_: f32;
    var phi_3281_: f32;
    var phi_3295_: f32;
    var phi_3302_: f32;
    var phi_3307_: f32;
    var phi_3314_: f32;
    var phi_3319_: f32;
    var phi_3324_: f32;
    var phi_3355_: f32;
    var phi_3361_: f32;
    var phi_3368_: f32;
    var phi_3375_: f32;
    var phi_3381_: f32;
    var phi_3388_: f32;
    var phi_3394_: f32;
    var phi_3400_: f32;
    var phi_3406_: f32;
    var phi_3413_: f32;
    var phi_3420_: f32;
    var phi_3444_: f32;
    var phi_3449_: f32;
    var phi_3454_: f32;
    var phi_3459_: f32;
    var phi_3464_: f32;
    var phi_3469_: f32;
    var phi_3479_: f32;
    var phi_3682_: f32;
    var phi_3689_: f32;
    var phi_3694_: f32;
    var phi_3701_: f32;
    var phi_3706_: f32;
    var phi_3719_: f32;
    var phi_3726_: f32;
    var phi_3731_: f32;
    var phi_3738_: f32;
    var phi_3743_: f32;
    var phi_3748_: f32;
    var phi_3765_: f32;
    var phi_3772_: f32;
    var phi_3777_: f32;
    var phi_3784_: f32;
    var phi_3789_: f32;
    var phi_3803_: f32;
    var phi_3810_: f32;
    var phi_3815_: f32;
    var phi_3822_: f32;
    var phi_3827_: f32;
    var phi_3832_: f32;
    var phi_3849_: f32;
    var phi_3856_: f32;
    var phi_3861_: f32;
    var phi_3868_: f32;
    var phi_3873_: f32;
    var phi_3887_: f32;
    var phi_3894_: f32;
    var phi_3899_: f32;
    var phi_3906_: f32;
    var phi_3911_: f32;
    var phi_3916_: f32;
    var phi_3995_: f32;
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
    var phi_4066_: f32;
    var phi_4072_: f32;
    var phi_4079_: f32;
    var phi_4090_: f32;
    var phi_4161_: f32;
    var phi_4166_: f32;
    var phi_4171_: f32;
    var phi_4176_: f32;
    var phi_4181_: f32;
    var phi_4186_: f32;
    var phi_4191_: f32;
    var phi_4196_: f32;
    var phi_4201_: f32;
    var phi_4206_: f32;
    var phi_4211_: f32;
    var phi_4216_: f32;
    var phi_4221_: f32;
    var phi_4226_: f32;
    var phi_4232_: f32;
    var phi_4238_: f32;
    var phi_4245_: f32;
    var phi_4256_: f32;
    var phi_4266_: f32;
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
    var phi_4404_: f32;
    var phi_4410_: f32;
    var phi_4416_: f32;
    var phi_4423_: f32;
    var phi_4434_: f32;
    var phi_4444_: f32;
    var phi_4448_: bool;
    var phi_4900_: f32;
    var phi_4907_: f32;
    var phi_4912_: f32;
    var phi_4919_: f32;
    var phi_4924_: f32;
    var phi_4937_: f32;
    var phi_4944_: f32;
    var phi_4949_: f32;
    var phi_4956_: f32;
    var phi_4961_: f32;
    var phi_4966_: f32;
    var phi_4983_: f32;
    var phi_4990_: f32;
    var phi_4995_: f32;
    var phi_5002_: f32;
    var phi_5007_: f32;
    var phi_5021_: f32;
    var phi_5028_: f32;
    var phi_5033_: f32;
    var phi_5040_: f32;
    var phi_5045_: f32;
    var phi_5050_: f32;
    var phi_5067_: f32;
    var phi_5074_: f32;
    var phi_5079_: f32;
    var phi_5086_: f32;
    var phi_5091_: f32;
    var phi_5105_: f32;
    var phi_5112_: f32;
    var phi_5117_: f32;
    var phi_5124_: f32;
    var phi_5129_: f32;
    var phi_5134_: f32;
    var phi_5165_: f32;
    var phi_5171_: f32;
    var phi_5178_: f32;
    var phi_5185_: f32;
    var phi_5191_: f32;
    var phi_5198_: f32;
    var phi_5204_: f32;
    var phi_5210_: f32;
    var phi_5216_: f32;
    var phi_5223_: f32;
    var phi_5230_: f32;
    var phi_5254_: f32;
    var phi_5259_: f32;
    var phi_5264_: f32;
    var phi_5269_: f32;
    var phi_5274_: f32;
    var phi_5279_: f32;
    var phi_5289_: f32;
    var phi_5492_: f32;
    var phi_5499_: f32;
    var phi_5504_: f32;
    var phi_5511_: f32;
    var phi_5516_: f32;
    var phi_5529_: f32;
    var phi_5536_: f32;
    var phi_5541_: f32;
    var phi_5548_: f32;
    var phi_5553_: f32;
    var phi_5558_: f32;
    var phi_5575_: f32;
    var phi_5582_: f32;
    var phi_5587_: f32;
    var phi_5594_: f32;
    var phi_5599_: f32;
    var phi_5613_: f32;
    var phi_5620_: f32;
    var phi_5625_: f32;
    var phi_5632_: f32;
    var phi_5637_: f32;
    var phi_5642_: f32;
    var phi_5659_: f32;
    var phi_5666_: f32;
    var phi_5671_: f32;
    var phi_5678_: f32;
    var phi_5683_: f32;
    var phi_5697_: f32;
    var phi_5704_: f32;
    var phi_5709_: f32;
    var phi_5716_: f32;
    var phi_5721_: f32;
    var phi_5726_: f32;
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
    var phi_5900_: f32;
    var phi_5971_: f32;
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
    var phi_6042_: f32;
    var phi_6048_: f32;
    var phi_6055_: f32;
    var phi_6066_: f32;
    var phi_6076_: f32;
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
    var phi_6209_: f32;
    var phi_6214_: f32;
    var phi_6220_: f32;
    var phi_6226_: f32;
    var phi_6233_: f32;
    var phi_6244_: f32;
    var phi_6254_: f32;
    var phi_6258_: bool;
    var phi_6503_: f32;
    var phi_6510_: f32;
    var phi_6515_: f32;
    var phi_6522_: f32;
    var phi_6527_: f32;
    var phi_6540_: f32;
    var phi_6547_: f32;
    var phi_6552_: f32;
    var phi_6559_: f32;
    var phi_6564_: f32;
    var phi_6569_: f32;
    var phi_6586_: f32;
    var phi_6593_: f32;
    var phi_6598_: f32;
    var phi_6605_: f32;
    var phi_6610_: f32;
    var phi_6624_: f32;
    var phi_6631_: f32;
    var phi_6636_: f32;
    var phi_6643_: f32;
    var phi_6648_: f32;
    var phi_6653_: f32;
    var phi_6670_: f32;
    var phi_6677_: f32;
    var phi_6682_: f32;
    var phi_6689_: f32;
    var phi_6694_: f32;
    var phi_6708_: f32;
    var phi_6715_: f32;
    var phi_6720_: f32;
    var phi_6727_: f32;
    var phi_6732_: f32;
    var phi_6737_: f32;
    var phi_6768_: f32;
    var phi_6774_: f32;
    var phi_6781_: f32;
    var phi_6788_: f32;
    var phi_6794_: f32;
    var phi_6801_: f32;
    var phi_6807_: f32;
    var phi_6813_: f32;
    var phi_6819_: f32;
    var phi_6826_: f32;
    var phi_6833_: f32;
    var phi_6857_: f32;
    var phi_6862_: f32;
    var phi_6867_: f32;
    var phi_6872_: f32;
    var phi_6877_: f32;
    var phi_6882_: f32;
    var phi_6892_: f32;
    var phi_7095_: f32;
    var phi_7102_: f32;
    var phi_7107_: f32;
    var phi_7114_: f32;
    var phi_7119_: f32;
    var phi_7132_: f32;
    var phi_7139_: f32;
    var phi_7144_: f32;
    var phi_7151_: f32;
    var phi_7156_: f32;
    var phi_7161_: f32;
    var phi_7178_: f32;
    var phi_7185_: f32;
    var phi_7190_: f32;
    var phi_7197_: f32;
    var phi_7202_: f32;
    var phi_7216_: f32;
    var phi_7223_: f32;
    var phi_7228_: f32;
    var phi_7235_: f32;
    var phi_7240_: f32;
    var phi_7245_: f32;
    var phi_7262_: f32;
    var phi_7269_: f32;
    var phi_7274_: f32;
    var phi_7281_: f32;
    var phi_7286_: f32;
    var phi_7300_: f32;
    var phi_7307_: f32;
    var phi_7312_: f32;
    var phi_7319_: f32;
    var phi_7324_: f32;
    var phi_7329_: f32;
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
    var phi_7473_: f32;
    var phi_7479_: f32;
    var phi_7485_: f32;
    var phi_7492_: f32;
    var phi_7503_: f32;
    var phi_7574_: f32;
    var phi_7579_: f32;
    var phi_7584_: f32;
    var phi_7589_: f32;
    var phi_7594_: f32;
    var phi_7599_: f32;
    var phi_7604_: f32;
    var phi_7609_: f32;
    var phi_7614_: f32;
    var phi_7619_: f32;
    var phi_7624_: f32;
    var phi_7629_: f32;
    var phi_7634_: f32;
    var phi_7639_: f32;
    var phi_7645_: f32;
    var phi_7651_: f32;
    var phi_7658_: f32;
    var phi_7669_: f32;
    var phi_7679_: f32;
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
    var phi_7807_: f32;
    var phi_7812_: f32;
    var phi_7817_: f32;
    var phi_7823_: f32;
    var phi_7829_: f32;
    var phi_7836_: f32;
    var phi_7847_: f32;
    var phi_7857_: f32;
    var phi_7861_: bool;
    var phi_7863_: bool;
    var phi_7865_: bool;
    var phi_7876_: bool;
    var phi_7877_: bool;
    var phi_7927_: type_13;
    var phi_7928_: type_13;
    var phi_7951_: type_13;
    var phi_7974_: u32;
    var phi_8048_: bool;
    var phi_8049_: bool;
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
        phi_346_ = _e86;
    } else {
        phi_346_ = _e88;
    }
    let _e91 = phi_346_;
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
            phi_387_ = (_e106 + 1u);
        } else {
            phi_387_ = _e106;
        }
        let _e112 = phi_387_;
        phi_388_ = _e112;
    } else {
        phi_388_ = 0u;
    }
    let _e114 = phi_388_;
    let _e117 = params.member.member_2.member_4;
    if (_e117 < _e114) {
        phi_396_ = _e117;
    } else {
        phi_396_ = _e114;
    }
    let _e120 = phi_396_;
    let _e121 = (_e120 / 4u);
    if ((_e120 % 4u) > 0u) {
        phi_412_ = (_e121 + 1u);
    } else {
        phi_412_ = _e121;
    }
    let _e126 = phi_412_;
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
            phi_433_ = (_e130 + 1u);
        } else {
            phi_433_ = _e130;
        }
        let _e136 = phi_433_;
        phi_434_ = _e136;
    } else {
        phi_434_ = 0u;
    }
    let _e138 = phi_434_;
    phi_437_ = type_13(0u, _e138);
    loop {
        let _e141 = phi_437_;
        if (_e141.member < _e141.member_1) {
            phi_438_ = type_13((_e141.member + 1u), _e141.member_1);
            phi_461_ = type_13(1u, _e141.member);
        } else {
            phi_438_ = _e141;
            phi_461_ = type_13(0u, type_13().member_1);
        }
        let _e153 = phi_438_;
        let _e155 = phi_461_;
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
                    phi_502_ = (_e176 + 1u);
                } else {
                    phi_502_ = _e176;
                }
                let _e182 = phi_502_;
                phi_503_ = _e182;
            } else {
                phi_503_ = 0u;
            }
            let _e184 = phi_503_;
            let _e187 = params.member.member_2.member_4;
            if (_e187 < _e184) {
                phi_511_ = _e187;
            } else {
                phi_511_ = _e184;
            }
            let _e190 = phi_511_;
            let _e191 = (_e163 < _e190);
            let _e194 = params.member.member_1.member_1;
            if _e191 {
                let _e197 = params.member.member_2.member_3;
                phi_523_ = (_e163 * _e197);
            } else {
                phi_523_ = 0u;
            }
            let _e200 = phi_523_;
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
                phi_608_ = array<u32, 2>(0u, 2u);
            } else {
                phi_608_ = array<u32, 2>(1u, 1u);
            }
            let _e236 = phi_608_;
            let _e239 = (_e67 / 32u);
            let _e240 = (_e67 % 32u);
            let _e244 = params.member.member_2.member_2;
            let _e248 = params.member.member_2.member[_e244][_e236[0]];
            let _e251 = nodes.member[(_e248 + _e205)];
            let _e267 = params.member.member_2.member_2;
            let _e271 = params.member.member_2.member[_e267][_e236[1]];
            let _e274 = nodes.member[(_e271 + _e208)];
            let _e290 = params.member.member_2.member_2;
            let _e297 = params.member.member_2.member[(_e290 - 1u)][_e236[0]];
            let _e300 = nodes.member[(_e297 + ((_e205 * 32u) + _e240))];
            let _e319 = params.member.member_2.member_2;
            let _e326 = params.member.member_2.member[(_e319 - 1u)][_e236[1]];
            let _e329 = nodes.member[(_e326 + ((_e208 * 32u) + _e240))];
            if _e191 {
                if ((((((_e329.member.x <= _e251.member_1.y) && (_e251.member.x <= _e329.member_1.y)) && (_e329.member.y <= _e251.member_2.x)) && (_e251.member.y <= _e329.member_2.x)) && (_e329.member_1.x <= _e251.member_2.y)) && (_e251.member_1.x <= _e329.member_2.y)) {
                    let _e355 = atomicAdd((&counters[_e239]), 1u);
                    let _e356 = ((_e239 * 32u) + _e355);
                    columns[_e356] = type_32(array<f32, 3>(_e329.member.x, _e329.member.y, _e329.member_1.x), array<f32, 3>(_e329.member_1.y, _e329.member_2.x, _e329.member_2.y));
                    names[_e356] = _e240;
                }
            }
            workgroupBarrier();
            if _e191 {
                if ((((((_e300.member.x <= _e274.member_1.y) && (_e274.member.x <= _e300.member_1.y)) && (_e300.member.y <= _e274.member_2.x)) && (_e274.member.y <= _e300.member_2.x)) && (_e300.member_1.x <= _e274.member_2.y)) && (_e274.member_1.x <= _e300.member_2.y)) {
                    phi_812_ = false;
                } else {
                    phi_812_ = true;
                }
                let _e374 = phi_812_;
                phi_813_ = _e374;
            } else {
                phi_813_ = true;
            }
            let _e376 = phi_813_;
            if _e376 {
                phi_817_ = type_32(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_817_ = type_32(array<f32, 3>(_e300.member.x, _e300.member.y, _e300.member_1.x), array<f32, 3>(_e300.member_1.y, _e300.member_2.x, _e300.member_2.y));
            }
            let _e378 = phi_817_;
            let _e379 = (_e67 / 32u);
            let _e382 = atomicLoad((&counters[_e379]));
            phi_830_ = type_13(0u, _e382);
            phi_833_ = 0u;
            loop {
                let _e385 = phi_830_;
                let _e387 = phi_833_;
                local_3 = _e387;
                if (_e385.member < _e385.member_1) {
                    phi_831_ = type_13((_e385.member + 1u), _e385.member_1);
                    phi_856_ = type_13(1u, _e385.member);
                } else {
                    phi_831_ = _e385;
                    phi_856_ = type_13(0u, type_13().member_1);
                }
                let _e399 = phi_831_;
                let _e401 = phi_856_;
                let _e405 = (bitcast<i32>(_e401.member) != 0i);
                if _e405 {
                    let _e409 = names[((_e379 * 32u) + _e401.member_1)];
                    let _e413 = columns[((_e379 * 32u) + _e401.member_1)];
                    if ((((((_e378.member[0] <= _e413.member_1[0]) && (_e413.member[0] <= _e378.member_1[0])) && (_e378.member[1] <= _e413.member_1[1])) && (_e413.member[1] <= _e378.member_1[1])) && (_e378.member[2] <= _e413.member_1[2])) && (_e413.member[2] <= _e378.member_1[2])) {
                        let _e446 = atomicAdd((&counters[4u]), 1u);
                        if (_e446 < 2048u) {
                            hits[_e446] = (((_e379 << bitcast<u32>(10i)) | ((_e67 % 32u) << bitcast<u32>(5i))) | _e409);
                            phi_946_ = _e387;
                        } else {
                            phi_946_ = (_e387 | (1u << bitcast<u32>((_e401.member_1 & 31u))));
                        }
                        let _e460 = phi_946_;
                        phi_948_ = _e460;
                    } else {
                        phi_948_ = _e387;
                    }
                    let _e462 = phi_948_;
                    phi_834_ = _e462;
                } else {
                    phi_834_ = u32();
                }
                let _e464 = phi_834_;
                continue;
                continuing {
                    phi_830_ = _e399;
                    phi_833_ = _e464;
                    break if !(_e405);
                }
            }
            phi_951_ = type_13(0u, 32u);
            let _e4921 = local_3;
            phi_954_ = _e4921;
            loop {
                let _e467 = phi_951_;
                let _e469 = phi_954_;
                if (_e467.member < _e467.member_1) {
                    phi_952_ = type_13((_e467.member + 1u), _e467.member_1);
                    phi_977_ = type_13(1u, _e467.member);
                } else {
                    phi_952_ = _e467;
                    phi_977_ = type_13(0u, type_13().member_1);
                }
                let _e481 = phi_952_;
                let _e483 = phi_977_;
                if (bitcast<i32>(_e483.member) != 0i) {
                    if (_e469 == 0u) {
                        phi_1845_ = u32();
                        phi_1846_ = false;
                    } else {
                        let _e494 = names[((_e92 * 32u) + select(firstTrailingBit(_e469), 32u, (_e469 == 0u)))];
                        let _e497 = (_e217 + _e93);
                        let _e498 = (_e224 + _e494);
                        let _e500 = leaves.member[_e497];
                        let _e502 = leaves.member[_e498];
                        let _e504 = nodes.member[_e497];
                        let _e518 = nodes.member[_e498];
                        let _e533 = params.member.member.member_1;
                        if ((_e533 & 1u) != 0u) {
                            if (_e502.member[0] == _e500.member[0]) {
                                phi_1071_ = true;
                            } else {
                                phi_1071_ = (_e502.member[0] == _e500.member[0]);
                            }
                            let _e543 = phi_1071_;
                            if (_e502.member[1] == _e500.member[0]) {
                                phi_1078_ = true;
                            } else {
                                phi_1078_ = (_e502.member[1] == _e500.member[0]);
                            }
                            let _e548 = phi_1078_;
                            if (_e502.member[2] == _e500.member[0]) {
                                phi_1086_ = true;
                            } else {
                                phi_1086_ = (_e502.member[2] == _e500.member[0]);
                            }
                            let _e554 = phi_1086_;
                            if ((_e543 || _e548) || _e554) {
                                phi_1109_ = false;
                            } else {
                                phi_1109_ = true;
                            }
                            let _e557 = phi_1109_;
                            phi_1110_ = _e557;
                        } else {
                            phi_1110_ = true;
                        }
                        let _e559 = phi_1110_;
                        if _e559 {
                            let _e561 = params.member.member.member_1;
                            if ((_e561 & 2u) != 0u) {
                                let _e565 = params.member.member.member_1;
                                let _e571 = bodies.member[_e500.member[0]];
                                let _e575 = bodies.member[_e502.member[0]];
                                if ((_e571 / 2u) != (_e575 / 2u)) {
                                    phi_1156_ = true;
                                } else {
                                    phi_1156_ = ((_e565 & 4u) != 0u);
                                }
                                let _e580 = phi_1156_;
                                if _e580 {
                                    phi_1163_ = (((_e571 & _e575) & 1u) == 0u);
                                } else {
                                    phi_1163_ = false;
                                }
                                let _e585 = phi_1163_;
                                phi_1167_ = _e585;
                            } else {
                                phi_1167_ = true;
                            }
                            let _e587 = phi_1167_;
                            if _e587 {
                                let _e589 = params.member.member.member_1;
                                if ((_e589 & 32u) != 0u) {
                                    let _e593 = params.member.member.member_6;
                                    let _e610 = (((((_e504.member_1.y - _e518.member.x) > _e593) && ((_e518.member_1.y - _e504.member.x) > _e593)) && (((_e504.member_2.x - _e518.member.y) > _e593) && ((_e518.member_2.x - _e504.member.y) > _e593))) && (((_e504.member_2.y - _e518.member_1.x) > _e593) && ((_e518.member_2.y - _e504.member_1.x) > _e593)));
                                    if _e610 {
                                        phi_1769_ = bool();
                                    } else {
                                        let _e614 = keys.member[_e500.member[0]];
                                        let _e619 = keys.member[_e500.member[1]];
                                        let _e621 = function_(_e614[0], _e619[0]);
                                        let _e625 = keys.member[_e500.member[2]];
                                        let _e627 = function_(_e621, _e625[0]);
                                        let _e631 = keys.member[_e502.member[0]];
                                        let _e636 = keys.member[_e502.member[1]];
                                        let _e638 = function_1(_e631[3], _e636[3]);
                                        let _e642 = keys.member[_e502.member[2]];
                                        let _e644 = function_1(_e638, _e642[3]);
                                        if (_e627[1] > _e644[1]) {
                                            phi_1292_ = true;
                                        } else {
                                            if (_e627[1] == _e644[1]) {
                                                phi_1291_ = (_e627[0] > _e644[0]);
                                            } else {
                                                phi_1291_ = false;
                                            }
                                            let _e655 = phi_1291_;
                                            phi_1292_ = _e655;
                                        }
                                        let _e657 = phi_1292_;
                                        let _e662 = keys.member[_e502.member[0]];
                                        let _e667 = keys.member[_e502.member[1]];
                                        let _e669 = function_(_e662[0], _e667[0]);
                                        let _e673 = keys.member[_e502.member[2]];
                                        let _e675 = function_(_e669, _e673[0]);
                                        let _e679 = keys.member[_e500.member[0]];
                                        let _e684 = keys.member[_e500.member[1]];
                                        let _e686 = function_1(_e679[3], _e684[3]);
                                        let _e690 = keys.member[_e500.member[2]];
                                        let _e692 = function_1(_e686, _e690[3]);
                                        if (_e675[1] > _e692[1]) {
                                            phi_1386_ = true;
                                        } else {
                                            if (_e675[1] == _e692[1]) {
                                                phi_1385_ = (_e675[0] > _e692[0]);
                                            } else {
                                                phi_1385_ = false;
                                            }
                                            let _e703 = phi_1385_;
                                            phi_1386_ = _e703;
                                        }
                                        let _e705 = phi_1386_;
                                        let _e711 = keys.member[_e500.member[0]];
                                        let _e716 = keys.member[_e500.member[1]];
                                        let _e718 = function_2(_e711[1], _e716[1]);
                                        let _e722 = keys.member[_e500.member[2]];
                                        let _e724 = function_2(_e718, _e722[1]);
                                        let _e728 = keys.member[_e502.member[0]];
                                        let _e733 = keys.member[_e502.member[1]];
                                        let _e735 = function_3(_e728[4], _e733[4]);
                                        let _e739 = keys.member[_e502.member[2]];
                                        let _e741 = function_3(_e735, _e739[4]);
                                        if (_e724[1] > _e741[1]) {
                                            phi_1481_ = true;
                                        } else {
                                            if (_e724[1] == _e741[1]) {
                                                phi_1480_ = (_e724[0] > _e741[0]);
                                            } else {
                                                phi_1480_ = false;
                                            }
                                            let _e752 = phi_1480_;
                                            phi_1481_ = _e752;
                                        }
                                        let _e754 = phi_1481_;
                                        let _e759 = keys.member[_e502.member[0]];
                                        let _e764 = keys.member[_e502.member[1]];
                                        let _e766 = function_2(_e759[1], _e764[1]);
                                        let _e770 = keys.member[_e502.member[2]];
                                        let _e772 = function_2(_e766, _e770[1]);
                                        let _e776 = keys.member[_e500.member[0]];
                                        let _e781 = keys.member[_e500.member[1]];
                                        let _e783 = function_3(_e776[4], _e781[4]);
                                        let _e787 = keys.member[_e500.member[2]];
                                        let _e789 = function_3(_e783, _e787[4]);
                                        if (_e772[1] > _e789[1]) {
                                            phi_1575_ = true;
                                        } else {
                                            if (_e772[1] == _e789[1]) {
                                                phi_1574_ = (_e772[0] > _e789[0]);
                                            } else {
                                                phi_1574_ = false;
                                            }
                                            let _e800 = phi_1574_;
                                            phi_1575_ = _e800;
                                        }
                                        let _e802 = phi_1575_;
                                        let _e809 = keys.member[_e500.member[0]];
                                        let _e814 = keys.member[_e500.member[1]];
                                        let _e816 = function_4(_e809[2], _e814[2]);
                                        let _e820 = keys.member[_e500.member[2]];
                                        let _e822 = function_4(_e816, _e820[2]);
                                        let _e826 = keys.member[_e502.member[0]];
                                        let _e831 = keys.member[_e502.member[1]];
                                        let _e833 = function_5(_e826[5], _e831[5]);
                                        let _e837 = keys.member[_e502.member[2]];
                                        let _e839 = function_5(_e833, _e837[5]);
                                        if (_e822[1] > _e839[1]) {
                                            phi_1671_ = true;
                                        } else {
                                            if (_e822[1] == _e839[1]) {
                                                phi_1670_ = (_e822[0] > _e839[0]);
                                            } else {
                                                phi_1670_ = false;
                                            }
                                            let _e850 = phi_1670_;
                                            phi_1671_ = _e850;
                                        }
                                        let _e852 = phi_1671_;
                                        let _e857 = keys.member[_e502.member[0]];
                                        let _e862 = keys.member[_e502.member[1]];
                                        let _e864 = function_4(_e857[2], _e862[2]);
                                        let _e868 = keys.member[_e502.member[2]];
                                        let _e870 = function_4(_e864, _e868[2]);
                                        let _e874 = keys.member[_e500.member[0]];
                                        let _e879 = keys.member[_e500.member[1]];
                                        let _e881 = function_5(_e874[5], _e879[5]);
                                        let _e885 = keys.member[_e500.member[2]];
                                        let _e887 = function_5(_e881, _e885[5]);
                                        if (_e870[1] > _e887[1]) {
                                            phi_1765_ = true;
                                        } else {
                                            if (_e870[1] == _e887[1]) {
                                                phi_1764_ = (_e870[0] > _e887[0]);
                                            } else {
                                                phi_1764_ = false;
                                            }
                                            let _e898 = phi_1764_;
                                            phi_1765_ = _e898;
                                        }
                                        let _e900 = phi_1765_;
                                        phi_1769_ = (((!(_e657) && !(_e705)) && (!(_e754) && !(_e802))) && (!(_e852) && !(_e900)));
                                    }
                                    let _e905 = phi_1769_;
                                    phi_1770_ = _e905;
                                    phi_1771_ = _e610;
                                } else {
                                    phi_1770_ = bool();
                                    phi_1771_ = true;
                                }
                                let _e907 = phi_1770_;
                                let _e909 = phi_1771_;
                                if _e909 {
                                    phi_1775_ = false;
                                } else {
                                    phi_1775_ = true;
                                }
                                let _e911 = phi_1775_;
                                phi_1776_ = _e907;
                                phi_1777_ = _e911;
                            } else {
                                phi_1776_ = false;
                                phi_1777_ = true;
                            }
                            let _e913 = phi_1776_;
                            let _e915 = phi_1777_;
                            phi_1778_ = _e913;
                            phi_1779_ = _e915;
                        } else {
                            phi_1778_ = false;
                            phi_1779_ = true;
                        }
                        let _e917 = phi_1778_;
                        let _e919 = phi_1779_;
                        if _e919 {
                            phi_1783_ = _e917;
                        } else {
                            phi_1783_ = true;
                        }
                        let _e921 = phi_1783_;
                        if _e921 {
                            let _e924 = params.member.member_1.member_3;
                            let _e928 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e928 + 1u) < _e928) {
                                let _e932 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e928 < _e924) {
                                let _e934 = (2u * _e928);
                                atomicStore((&output.member[(4u + _e934)]), _e500.member_1);
                                atomicStore((&output.member[(_e934 + 5u)]), _e502.member_1);
                            }
                            let _e940 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e940 + 1u) < _e940) {
                                let _e944 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1845_ = (_e469 & (_e469 - 1u));
                        phi_1846_ = true;
                    }
                    let _e946 = phi_1845_;
                    let _e948 = phi_1846_;
                    phi_955_ = _e946;
                    phi_1847_ = _e948;
                } else {
                    phi_955_ = u32();
                    phi_1847_ = false;
                }
                let _e950 = phi_955_;
                let _e952 = phi_1847_;
                continue;
                continuing {
                    phi_951_ = _e481;
                    phi_954_ = _e950;
                    break if !(_e952);
                }
            }
            workgroupBarrier();
            let _e955 = atomicLoad((&counters[4u]));
            if (2048u < _e955) {
                phi_1854_ = 2048u;
            } else {
                phi_1854_ = _e955;
            }
            let _e958 = phi_1854_;
            phi_1857_ = type_13(0u, 16u);
            loop {
                let _e960 = phi_1857_;
                if (_e960.member < _e960.member_1) {
                    phi_1858_ = type_13((_e960.member + 1u), _e960.member_1);
                    phi_1881_ = type_13(1u, _e960.member);
                } else {
                    phi_1858_ = _e960;
                    phi_1881_ = type_13(0u, type_13().member_1);
                }
                let _e972 = phi_1858_;
                let _e974 = phi_1881_;
                if (bitcast<i32>(_e974.member) != 0i) {
                    let _e980 = (_e67 + (_e974.member_1 * 128u));
                    if (_e980 >= _e958) {
                        phi_7876_ = false;
                    } else {
                        let _e983 = hits[_e980];
                        let _e986 = ((_e983 >> bitcast<u32>(10i)) & 3u);
                        let _e993 = firsts[(2u * _e986)];
                        let _e994 = (_e993 + ((_e983 >> bitcast<u32>(5i)) & 31u));
                        let _e998 = firsts[((2u * _e986) + 1u)];
                        let _e999 = (_e998 + (_e983 & 31u));
                        let _e1001 = leaves.member[_e994];
                        let _e1003 = leaves.member[_e999];
                        let _e1005 = nodes.member[_e994];
                        let _e1019 = nodes.member[_e999];
                        let _e1034 = params.member.member.member_1;
                        if ((_e1034 & 1u) != 0u) {
                            if (_e1003.member[0] == _e1001.member[0]) {
                                phi_1983_ = true;
                            } else {
                                phi_1983_ = (_e1003.member[0] == _e1001.member[0]);
                            }
                            let _e1044 = phi_1983_;
                            if (_e1003.member[1] == _e1001.member[0]) {
                                phi_1990_ = true;
                            } else {
                                phi_1990_ = (_e1003.member[1] == _e1001.member[0]);
                            }
                            let _e1049 = phi_1990_;
                            if (_e1003.member[2] == _e1001.member[0]) {
                                phi_1998_ = true;
                            } else {
                                phi_1998_ = (_e1003.member[2] == _e1001.member[0]);
                            }
                            let _e1055 = phi_1998_;
                            if ((_e1044 || _e1049) || _e1055) {
                                phi_2021_ = false;
                            } else {
                                phi_2021_ = true;
                            }
                            let _e1058 = phi_2021_;
                            phi_2022_ = _e1058;
                        } else {
                            phi_2022_ = true;
                        }
                        let _e1060 = phi_2022_;
                        if _e1060 {
                            let _e1062 = params.member.member.member_1;
                            if ((_e1062 & 2u) != 0u) {
                                let _e1066 = params.member.member.member_1;
                                let _e1072 = bodies.member[_e1001.member[0]];
                                let _e1076 = bodies.member[_e1003.member[0]];
                                if ((_e1072 / 2u) != (_e1076 / 2u)) {
                                    phi_2068_ = true;
                                } else {
                                    phi_2068_ = ((_e1066 & 4u) != 0u);
                                }
                                let _e1081 = phi_2068_;
                                if _e1081 {
                                    phi_2075_ = (((_e1072 & _e1076) & 1u) == 0u);
                                } else {
                                    phi_2075_ = false;
                                }
                                let _e1086 = phi_2075_;
                                phi_2079_ = _e1086;
                            } else {
                                phi_2079_ = true;
                            }
                            let _e1088 = phi_2079_;
                            if _e1088 {
                                let _e1090 = params.member.member.member_1;
                                if ((_e1090 & 32u) != 0u) {
                                    let _e1094 = params.member.member.member_6;
                                    let _e1111 = (((((_e1005.member_1.y - _e1019.member.x) > _e1094) && ((_e1019.member_1.y - _e1005.member.x) > _e1094)) && (((_e1005.member_2.x - _e1019.member.y) > _e1094) && ((_e1019.member_2.x - _e1005.member.y) > _e1094))) && (((_e1005.member_2.y - _e1019.member_1.x) > _e1094) && ((_e1019.member_2.y - _e1005.member_1.x) > _e1094)));
                                    if _e1111 {
                                        phi_2681_ = bool();
                                    } else {
                                        let _e1115 = keys.member[_e1001.member[0]];
                                        let _e1120 = keys.member[_e1001.member[1]];
                                        let _e1122 = function_(_e1115[0], _e1120[0]);
                                        let _e1126 = keys.member[_e1001.member[2]];
                                        let _e1128 = function_(_e1122, _e1126[0]);
                                        let _e1132 = keys.member[_e1003.member[0]];
                                        let _e1137 = keys.member[_e1003.member[1]];
                                        let _e1139 = function_1(_e1132[3], _e1137[3]);
                                        let _e1143 = keys.member[_e1003.member[2]];
                                        let _e1145 = function_1(_e1139, _e1143[3]);
                                        if (_e1128[1] > _e1145[1]) {
                                            phi_2204_ = true;
                                        } else {
                                            if (_e1128[1] == _e1145[1]) {
                                                phi_2203_ = (_e1128[0] > _e1145[0]);
                                            } else {
                                                phi_2203_ = false;
                                            }
                                            let _e1156 = phi_2203_;
                                            phi_2204_ = _e1156;
                                        }
                                        let _e1158 = phi_2204_;
                                        let _e1163 = keys.member[_e1003.member[0]];
                                        let _e1168 = keys.member[_e1003.member[1]];
                                        let _e1170 = function_(_e1163[0], _e1168[0]);
                                        let _e1174 = keys.member[_e1003.member[2]];
                                        let _e1176 = function_(_e1170, _e1174[0]);
                                        let _e1180 = keys.member[_e1001.member[0]];
                                        let _e1185 = keys.member[_e1001.member[1]];
                                        let _e1187 = function_1(_e1180[3], _e1185[3]);
                                        let _e1191 = keys.member[_e1001.member[2]];
                                        let _e1193 = function_1(_e1187, _e1191[3]);
                                        if (_e1176[1] > _e1193[1]) {
                                            phi_2298_ = true;
                                        } else {
                                            if (_e1176[1] == _e1193[1]) {
                                                phi_2297_ = (_e1176[0] > _e1193[0]);
                                            } else {
                                                phi_2297_ = false;
                                            }
                                            let _e1204 = phi_2297_;
                                            phi_2298_ = _e1204;
                                        }
                                        let _e1206 = phi_2298_;
                                        let _e1212 = keys.member[_e1001.member[0]];
                                        let _e1217 = keys.member[_e1001.member[1]];
                                        let _e1219 = function_2(_e1212[1], _e1217[1]);
                                        let _e1223 = keys.member[_e1001.member[2]];
                                        let _e1225 = function_2(_e1219, _e1223[1]);
                                        let _e1229 = keys.member[_e1003.member[0]];
                                        let _e1234 = keys.member[_e1003.member[1]];
                                        let _e1236 = function_3(_e1229[4], _e1234[4]);
                                        let _e1240 = keys.member[_e1003.member[2]];
                                        let _e1242 = function_3(_e1236, _e1240[4]);
                                        if (_e1225[1] > _e1242[1]) {
                                            phi_2393_ = true;
                                        } else {
                                            if (_e1225[1] == _e1242[1]) {
                                                phi_2392_ = (_e1225[0] > _e1242[0]);
                                            } else {
                                                phi_2392_ = false;
                                            }
                                            let _e1253 = phi_2392_;
                                            phi_2393_ = _e1253;
                                        }
                                        let _e1255 = phi_2393_;
                                        let _e1260 = keys.member[_e1003.member[0]];
                                        let _e1265 = keys.member[_e1003.member[1]];
                                        let _e1267 = function_2(_e1260[1], _e1265[1]);
                                        let _e1271 = keys.member[_e1003.member[2]];
                                        let _e1273 = function_2(_e1267, _e1271[1]);
                                        let _e1277 = keys.member[_e1001.member[0]];
                                        let _e1282 = keys.member[_e1001.member[1]];
                                        let _e1284 = function_3(_e1277[4], _e1282[4]);
                                        let _e1288 = keys.member[_e1001.member[2]];
                                        let _e1290 = function_3(_e1284, _e1288[4]);
                                        if (_e1273[1] > _e1290[1]) {
                                            phi_2487_ = true;
                                        } else {
                                            if (_e1273[1] == _e1290[1]) {
                                                phi_2486_ = (_e1273[0] > _e1290[0]);
                                            } else {
                                                phi_2486_ = false;
                                            }
                                            let _e1301 = phi_2486_;
                                            phi_2487_ = _e1301;
                                        }
                                        let _e1303 = phi_2487_;
                                        let _e1310 = keys.member[_e1001.member[0]];
                                        let _e1315 = keys.member[_e1001.member[1]];
                                        let _e1317 = function_4(_e1310[2], _e1315[2]);
                                        let _e1321 = keys.member[_e1001.member[2]];
                                        let _e1323 = function_4(_e1317, _e1321[2]);
                                        let _e1327 = keys.member[_e1003.member[0]];
                                        let _e1332 = keys.member[_e1003.member[1]];
                                        let _e1334 = function_5(_e1327[5], _e1332[5]);
                                        let _e1338 = keys.member[_e1003.member[2]];
                                        let _e1340 = function_5(_e1334, _e1338[5]);
                                        if (_e1323[1] > _e1340[1]) {
                                            phi_2583_ = true;
                                        } else {
                                            if (_e1323[1] == _e1340[1]) {
                                                phi_2582_ = (_e1323[0] > _e1340[0]);
                                            } else {
                                                phi_2582_ = false;
                                            }
                                            let _e1351 = phi_2582_;
                                            phi_2583_ = _e1351;
                                        }
                                        let _e1353 = phi_2583_;
                                        let _e1358 = keys.member[_e1003.member[0]];
                                        let _e1363 = keys.member[_e1003.member[1]];
                                        let _e1365 = function_4(_e1358[2], _e1363[2]);
                                        let _e1369 = keys.member[_e1003.member[2]];
                                        let _e1371 = function_4(_e1365, _e1369[2]);
                                        let _e1375 = keys.member[_e1001.member[0]];
                                        let _e1380 = keys.member[_e1001.member[1]];
                                        let _e1382 = function_5(_e1375[5], _e1380[5]);
                                        let _e1386 = keys.member[_e1001.member[2]];
                                        let _e1388 = function_5(_e1382, _e1386[5]);
                                        if (_e1371[1] > _e1388[1]) {
                                            phi_2677_ = true;
                                        } else {
                                            if (_e1371[1] == _e1388[1]) {
                                                phi_2676_ = (_e1371[0] > _e1388[0]);
                                            } else {
                                                phi_2676_ = false;
                                            }
                                            let _e1399 = phi_2676_;
                                            phi_2677_ = _e1399;
                                        }
                                        let _e1401 = phi_2677_;
                                        phi_2681_ = (((!(_e1158) && !(_e1206)) && (!(_e1255) && !(_e1303))) && (!(_e1353) && !(_e1401)));
                                    }
                                    let _e1406 = phi_2681_;
                                    phi_2682_ = _e1406;
                                    phi_2683_ = _e1111;
                                } else {
                                    phi_2682_ = bool();
                                    phi_2683_ = true;
                                }
                                let _e1408 = phi_2682_;
                                let _e1410 = phi_2683_;
                                if _e1410 {
                                    phi_2687_ = false;
                                } else {
                                    phi_2687_ = true;
                                }
                                let _e1412 = phi_2687_;
                                phi_2688_ = _e1408;
                                phi_2689_ = _e1412;
                            } else {
                                phi_2688_ = false;
                                phi_2689_ = true;
                            }
                            let _e1414 = phi_2688_;
                            let _e1416 = phi_2689_;
                            phi_2690_ = _e1414;
                            phi_2691_ = _e1416;
                        } else {
                            phi_2690_ = false;
                            phi_2691_ = true;
                        }
                        let _e1418 = phi_2690_;
                        let _e1420 = phi_2691_;
                        if _e1420 {
                            phi_2695_ = _e1418;
                        } else {
                            phi_2695_ = true;
                        }
                        let _e1422 = phi_2695_;
                        if _e1422 {
                            let _e1424 = atomicAdd((&counters[7u]), 1u);
                            let _e1427 = params.member.member.member_4;
                            let _e1429 = params.member.member.member_5;
                            let _e1439 = paths.member[_e1001.member[0]];
                            let _e1441 = paths.member[_e1003.member[0]];
                            let _e1447 = paths.member[_e1003.member[1]];
                            let _e1449 = paths.member[_e1003.member[2]];
                            local_2 = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1439.member[0] - _e1441.member[0]), (_e1439.member[1] - _e1441.member[1]), (_e1439.member[2] - _e1441.member[2])), array<f32, 3>((_e1439.member_1[0] - _e1441.member_1[0]), (_e1439.member_1[1] - _e1441.member_1[1]), (_e1439.member_1[2] - _e1441.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1447.member[0] - _e1441.member[0]), (_e1447.member[1] - _e1441.member[1]), (_e1447.member[2] - _e1441.member[2])), array<f32, 3>((_e1447.member_1[0] - _e1441.member_1[0]), (_e1447.member_1[1] - _e1441.member_1[1]), (_e1447.member_1[2] - _e1441.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1449.member[0] - _e1441.member[0]), (_e1449.member[1] - _e1441.member[1]), (_e1449.member[2] - _e1441.member[2])), array<f32, 3>((_e1449.member_1[0] - _e1441.member_1[0]), (_e1449.member_1[1] - _e1441.member_1[1]), (_e1449.member_1[2] - _e1441.member_1[2]))), (_e1427 + _e1427));
                            let _e1509 = local_2.member_1[0u];
                            let _e1515 = local_2.member_2[0u];
                            let _e1521 = ((_e1509[1] * _e1515[2]) - (_e1509[2] * _e1515[1]));
                            let _e1524 = ((_e1509[2] * _e1515[0]) - (_e1509[0] * _e1515[2]));
                            let _e1527 = ((_e1509[0] * _e1515[1]) - (_e1509[1] * _e1515[0]));
                            let _e1530 = local_2.member_1[1u];
                            let _e1536 = local_2.member_2[1u];
                            let _e1542 = ((_e1530[1] * _e1536[2]) - (_e1530[2] * _e1536[1]));
                            let _e1545 = ((_e1530[2] * _e1536[0]) - (_e1530[0] * _e1536[2]));
                            let _e1548 = ((_e1530[0] * _e1536[1]) - (_e1530[1] * _e1536[0]));
                            let _e1551 = local_2.member_1[0u];
                            let _e1557 = local_2.member_2[1u];
                            let _e1572 = local_2.member_1[1u];
                            let _e1578 = local_2.member_2[0u];
                            let _e1591 = (((_e1551[1] * _e1557[2]) - (_e1551[2] * _e1557[1])) + ((_e1572[1] * _e1578[2]) - (_e1572[2] * _e1578[1])));
                            let _e1592 = (((_e1551[2] * _e1557[0]) - (_e1551[0] * _e1557[2])) + ((_e1572[2] * _e1578[0]) - (_e1572[0] * _e1578[2])));
                            let _e1593 = (((_e1551[0] * _e1557[1]) - (_e1551[1] * _e1557[0])) + ((_e1572[0] * _e1578[1]) - (_e1572[1] * _e1578[0])));
                            let _e1596 = local_2.member[0u];
                            let _e1607 = local_2.member[1u];
                            let _e1618 = local_2.member[0u];
                            let _e1627 = ((((_e1607[0] * _e1521) + (_e1607[1] * _e1524)) + (_e1607[2] * _e1527)) + (((_e1618[0] * _e1591) + (_e1618[1] * _e1592)) + (_e1618[2] * _e1593)));
                            let _e1630 = local_2.member[0u];
                            let _e1641 = local_2.member[1u];
                            let _e1650 = ((((_e1630[0] * _e1542) + (_e1630[1] * _e1545)) + (_e1630[2] * _e1548)) + (((_e1641[0] * _e1591) + (_e1641[1] * _e1592)) + (_e1641[2] * _e1593)));
                            let _e1653 = local_2.member[1u];
                            let _e1664 = local_2.member[0u];
                            if (_e1664[0] < 0f) {
                                phi_3090_ = -(_e1664[0]);
                            } else {
                                phi_3090_ = _e1664[0];
                            }
                            let _e1671 = phi_3090_;
                            if (_e1664[1] < 0f) {
                                phi_3097_ = -(_e1664[1]);
                            } else {
                                phi_3097_ = _e1664[1];
                            }
                            let _e1675 = phi_3097_;
                            if (_e1671 > _e1675) {
                                phi_3102_ = _e1671;
                            } else {
                                phi_3102_ = _e1675;
                            }
                            let _e1678 = phi_3102_;
                            if (_e1664[2] < 0f) {
                                phi_3109_ = -(_e1664[2]);
                            } else {
                                phi_3109_ = _e1664[2];
                            }
                            let _e1682 = phi_3109_;
                            if (_e1678 > _e1682) {
                                phi_3114_ = _e1678;
                            } else {
                                phi_3114_ = _e1682;
                            }
                            let _e1685 = phi_3114_;
                            let _e1688 = local_2.member[1u];
                            if (_e1688[0] < 0f) {
                                phi_3127_ = -(_e1688[0]);
                            } else {
                                phi_3127_ = _e1688[0];
                            }
                            let _e1695 = phi_3127_;
                            if (_e1688[1] < 0f) {
                                phi_3134_ = -(_e1688[1]);
                            } else {
                                phi_3134_ = _e1688[1];
                            }
                            let _e1699 = phi_3134_;
                            if (_e1695 > _e1699) {
                                phi_3139_ = _e1695;
                            } else {
                                phi_3139_ = _e1699;
                            }
                            let _e1702 = phi_3139_;
                            if (_e1688[2] < 0f) {
                                phi_3146_ = -(_e1688[2]);
                            } else {
                                phi_3146_ = _e1688[2];
                            }
                            let _e1706 = phi_3146_;
                            if (_e1702 > _e1706) {
                                phi_3151_ = _e1702;
                            } else {
                                phi_3151_ = _e1706;
                            }
                            let _e1709 = phi_3151_;
                            if (_e1685 > _e1709) {
                                phi_3156_ = _e1685;
                            } else {
                                phi_3156_ = _e1709;
                            }
                            let _e1712 = phi_3156_;
                            let _e1714 = local_2.member_3;
                            let _e1715 = (_e1712 + _e1714);
                            let _e1718 = local_2.member_1[0u];
                            if (_e1718[0] < 0f) {
                                phi_3173_ = -(_e1718[0]);
                            } else {
                                phi_3173_ = _e1718[0];
                            }
                            let _e1725 = phi_3173_;
                            if (_e1718[1] < 0f) {
                                phi_3180_ = -(_e1718[1]);
                            } else {
                                phi_3180_ = _e1718[1];
                            }
                            let _e1729 = phi_3180_;
                            if (_e1725 > _e1729) {
                                phi_3185_ = _e1725;
                            } else {
                                phi_3185_ = _e1729;
                            }
                            let _e1732 = phi_3185_;
                            if (_e1718[2] < 0f) {
                                phi_3192_ = -(_e1718[2]);
                            } else {
                                phi_3192_ = _e1718[2];
                            }
                            let _e1736 = phi_3192_;
                            if (_e1732 > _e1736) {
                                phi_3197_ = _e1732;
                            } else {
                                phi_3197_ = _e1736;
                            }
                            let _e1739 = phi_3197_;
                            let _e1742 = local_2.member_1[1u];
                            if (_e1742[0] < 0f) {
                                phi_3211_ = -(_e1742[0]);
                            } else {
                                phi_3211_ = _e1742[0];
                            }
                            let _e1749 = phi_3211_;
                            if (_e1742[1] < 0f) {
                                phi_3218_ = -(_e1742[1]);
                            } else {
                                phi_3218_ = _e1742[1];
                            }
                            let _e1753 = phi_3218_;
                            if (_e1749 > _e1753) {
                                phi_3223_ = _e1749;
                            } else {
                                phi_3223_ = _e1753;
                            }
                            let _e1756 = phi_3223_;
                            if (_e1742[2] < 0f) {
                                phi_3230_ = -(_e1742[2]);
                            } else {
                                phi_3230_ = _e1742[2];
                            }
                            let _e1760 = phi_3230_;
                            if (_e1756 > _e1760) {
                                phi_3235_ = _e1756;
                            } else {
                                phi_3235_ = _e1760;
                            }
                            let _e1763 = phi_3235_;
                            if (_e1739 > _e1763) {
                                phi_3240_ = _e1739;
                            } else {
                                phi_3240_ = _e1763;
                            }
                            let _e1766 = phi_3240_;
                            let _e1768 = local_2.member_3;
                            let _e1769 = (_e1766 + _e1768);
                            let _e1772 = local_2.member_2[0u];
                            if (_e1772[0] < 0f) {
                                phi_3257_ = -(_e1772[0]);
                            } else {
                                phi_3257_ = _e1772[0];
                            }
                            let _e1779 = phi_3257_;
                            if (_e1772[1] < 0f) {
                                phi_3264_ = -(_e1772[1]);
                            } else {
                                phi_3264_ = _e1772[1];
                            }
                            let _e1783 = phi_3264_;
                            if (_e1779 > _e1783) {
                                phi_3269_ = _e1779;
                            } else {
                                phi_3269_ = _e1783;
                            }
                            let _e1786 = phi_3269_;
                            if (_e1772[2] < 0f) {
                                phi_3276_ = -(_e1772[2]);
                            } else {
                                phi_3276_ = _e1772[2];
                            }
                            let _e1790 = phi_3276_;
                            if (_e1786 > _e1790) {
                                phi_3281_ = _e1786;
                            } else {
                                phi_3281_ = _e1790;
                            }
                            let _e1793 = phi_3281_;
                            let _e1796 = local_2.member_2[1u];
                            if (_e1796[0] < 0f) {
                                phi_3295_ = -(_e1796[0]);
                            } else {
                                phi_3295_ = _e1796[0];
                            }
                            let _e1803 = phi_3295_;
                            if (_e1796[1] < 0f) {
                                phi_3302_ = -(_e1796[1]);
                            } else {
                                phi_3302_ = _e1796[1];
                            }
                            let _e1807 = phi_3302_;
                            if (_e1803 > _e1807) {
                                phi_3307_ = _e1803;
                            } else {
                                phi_3307_ = _e1807;
                            }
                            let _e1810 = phi_3307_;
                            if (_e1796[2] < 0f) {
                                phi_3314_ = -(_e1796[2]);
                            } else {
                                phi_3314_ = _e1796[2];
                            }
                            let _e1814 = phi_3314_;
                            if (_e1810 > _e1814) {
                                phi_3319_ = _e1810;
                            } else {
                                phi_3319_ = _e1814;
                            }
                            let _e1817 = phi_3319_;
                            if (_e1793 > _e1817) {
                                phi_3324_ = _e1793;
                            } else {
                                phi_3324_ = _e1817;
                            }
                            let _e1820 = phi_3324_;
                            let _e1822 = local_2.member_3;
                            let _e1823 = (_e1820 + _e1822);
                            let _e1825 = ((_e1769 * 8f) * _e1823);
                            let _e1832 = local_2.member_3;
                            if (_e1521 < 0f) {
                                phi_3355_ = -(_e1521);
                            } else {
                                phi_3355_ = _e1521;
                            }
                            let _e1849 = phi_3355_;
                            if (_e1524 < 0f) {
                                phi_3361_ = -(_e1524);
                            } else {
                                phi_3361_ = _e1524;
                            }
                            let _e1853 = phi_3361_;
                            if (_e1527 < 0f) {
                                phi_3368_ = -(_e1527);
                            } else {
                                phi_3368_ = _e1527;
                            }
                            let _e1858 = phi_3368_;
                            let _e1859 = ((_e1849 + _e1853) + _e1858);
                            if (_e1542 < 0f) {
                                phi_3375_ = -(_e1542);
                            } else {
                                phi_3375_ = _e1542;
                            }
                            let _e1863 = phi_3375_;
                            if (_e1545 < 0f) {
                                phi_3381_ = -(_e1545);
                            } else {
                                phi_3381_ = _e1545;
                            }
                            let _e1867 = phi_3381_;
                            if (_e1548 < 0f) {
                                phi_3388_ = -(_e1548);
                            } else {
                                phi_3388_ = _e1548;
                            }
                            let _e1872 = phi_3388_;
                            let _e1873 = ((_e1863 + _e1867) + _e1872);
                            if (_e1859 > _e1873) {
                                phi_3394_ = _e1859;
                            } else {
                                phi_3394_ = _e1873;
                            }
                            let _e1876 = phi_3394_;
                            if (_e1591 < 0f) {
                                phi_3400_ = -(_e1591);
                            } else {
                                phi_3400_ = _e1591;
                            }
                            let _e1880 = phi_3400_;
                            if (_e1592 < 0f) {
                                phi_3406_ = -(_e1592);
                            } else {
                                phi_3406_ = _e1592;
                            }
                            let _e1884 = phi_3406_;
                            if (_e1593 < 0f) {
                                phi_3413_ = -(_e1593);
                            } else {
                                phi_3413_ = _e1593;
                            }
                            let _e1889 = phi_3413_;
                            let _e1891 = (((_e1880 + _e1884) + _e1889) * 0.5f);
                            if (_e1876 > _e1891) {
                                phi_3420_ = _e1876;
                            } else {
                                phi_3420_ = _e1891;
                            }
                            let _e1894 = phi_3420_;
                            let _e1899 = local_2.member_3;
                            let _e1912 = ((((_e1596[0] * _e1521) + (_e1596[1] * _e1524)) + (_e1596[2] * _e1527)) * 3f);
                            let _e1913 = ((((_e1653[0] * _e1542) + (_e1653[1] * _e1545)) + (_e1653[2] * _e1548)) * 3f);
                            if (_e1912 < _e1913) {
                                phi_3444_ = _e1912;
                            } else {
                                phi_3444_ = _e1913;
                            }
                            let _e1916 = phi_3444_;
                            if (_e1627 < _e1650) {
                                phi_3449_ = _e1627;
                            } else {
                                phi_3449_ = _e1650;
                            }
                            let _e1919 = phi_3449_;
                            if (_e1916 < _e1919) {
                                phi_3454_ = _e1916;
                            } else {
                                phi_3454_ = _e1919;
                            }
                            let _e1922 = phi_3454_;
                            if (_e1912 > _e1913) {
                                phi_3459_ = _e1912;
                            } else {
                                phi_3459_ = _e1913;
                            }
                            let _e1925 = phi_3459_;
                            if (_e1627 > _e1650) {
                                phi_3464_ = _e1627;
                            } else {
                                phi_3464_ = _e1650;
                            }
                            let _e1928 = phi_3464_;
                            if (_e1925 > _e1928) {
                                phi_3469_ = _e1925;
                            } else {
                                phi_3469_ = _e1928;
                            }
                            let _e1931 = phi_3469_;
                            let _e1936 = -(_e1931);
                            if (_e1922 > _e1936) {
                                phi_3479_ = _e1922;
                            } else {
                                phi_3479_ = _e1936;
                            }
                            let _e1939 = phi_3479_;
                            let _e1941 = ((_e1939 - ((((((_e1715 * 8f) * _e1825) * (0.000000059604645f * (524f / 64f))) + ((_e1832 * 19f) * ((_e1715 * (_e1769 + _e1823)) + (_e1769 * _e1823)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1715) * ((1f + _e1769) * (1f + _e1823))))) + ((_e1429 * (((_e1894 + (_e1825 * (0.000000059604645f * 8f))) + ((_e1899 * 6f) * (_e1769 + _e1823))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1769) * (1f + _e1823))))) * (3f * 1.0001f)))) > 0f);
                            if _e1941 {
                                phi_4448_ = _e1941;
                            } else {
                                let _e1944 = local_2.member_1[0u];
                                let _e1950 = local_2.member_1[1u];
                                let _e1954 = (_e1944[0] + _e1950[0]);
                                let _e1955 = (_e1944[1] + _e1950[1]);
                                let _e1956 = (_e1944[2] + _e1950[2]);
                                let _e1959 = local_2.member_2[0u];
                                let _e1965 = local_2.member_2[1u];
                                let _e1969 = (_e1959[0] + _e1965[0]);
                                let _e1970 = (_e1959[1] + _e1965[1]);
                                let _e1971 = (_e1959[2] + _e1965[2]);
                                let _e1974 = ((_e1955 * _e1971) - (_e1956 * _e1970));
                                let _e1977 = ((_e1956 * _e1969) - (_e1954 * _e1971));
                                let _e1980 = ((_e1954 * _e1970) - (_e1955 * _e1969));
                                let _e1983 = local_2.member[0u];
                                let _e1989 = local_2.member_1[0u];
                                let _e1995 = local_2.member_2[0u];
                                let _e1999 = (_e1983[0] - _e1989[0]);
                                let _e2000 = (_e1983[1] - _e1989[1]);
                                let _e2001 = (_e1983[2] - _e1989[2]);
                                let _e2002 = (_e1983[0] - _e1995[0]);
                                let _e2003 = (_e1983[1] - _e1995[1]);
                                let _e2004 = (_e1983[2] - _e1995[2]);
                                let _e2007 = local_2.member[1u];
                                let _e2013 = local_2.member_1[1u];
                                let _e2019 = local_2.member_2[1u];
                                let _e2023 = (_e2007[0] - _e2013[0]);
                                let _e2024 = (_e2007[1] - _e2013[1]);
                                let _e2025 = (_e2007[2] - _e2013[2]);
                                let _e2026 = (_e2007[0] - _e2019[0]);
                                let _e2027 = (_e2007[1] - _e2019[1]);
                                let _e2028 = (_e2007[2] - _e2019[2]);
                                let _e2031 = local_2.member[0u];
                                if (_e2031[0] < 0f) {
                                    phi_3682_ = -(_e2031[0]);
                                } else {
                                    phi_3682_ = _e2031[0];
                                }
                                let _e2038 = phi_3682_;
                                if (_e2031[1] < 0f) {
                                    phi_3689_ = -(_e2031[1]);
                                } else {
                                    phi_3689_ = _e2031[1];
                                }
                                let _e2042 = phi_3689_;
                                if (_e2038 > _e2042) {
                                    phi_3694_ = _e2038;
                                } else {
                                    phi_3694_ = _e2042;
                                }
                                let _e2045 = phi_3694_;
                                if (_e2031[2] < 0f) {
                                    phi_3701_ = -(_e2031[2]);
                                } else {
                                    phi_3701_ = _e2031[2];
                                }
                                let _e2049 = phi_3701_;
                                if (_e2045 > _e2049) {
                                    phi_3706_ = _e2045;
                                } else {
                                    phi_3706_ = _e2049;
                                }
                                let _e2052 = phi_3706_;
                                let _e2055 = local_2.member[1u];
                                if (_e2055[0] < 0f) {
                                    phi_3719_ = -(_e2055[0]);
                                } else {
                                    phi_3719_ = _e2055[0];
                                }
                                let _e2062 = phi_3719_;
                                if (_e2055[1] < 0f) {
                                    phi_3726_ = -(_e2055[1]);
                                } else {
                                    phi_3726_ = _e2055[1];
                                }
                                let _e2066 = phi_3726_;
                                if (_e2062 > _e2066) {
                                    phi_3731_ = _e2062;
                                } else {
                                    phi_3731_ = _e2066;
                                }
                                let _e2069 = phi_3731_;
                                if (_e2055[2] < 0f) {
                                    phi_3738_ = -(_e2055[2]);
                                } else {
                                    phi_3738_ = _e2055[2];
                                }
                                let _e2073 = phi_3738_;
                                if (_e2069 > _e2073) {
                                    phi_3743_ = _e2069;
                                } else {
                                    phi_3743_ = _e2073;
                                }
                                let _e2076 = phi_3743_;
                                if (_e2052 > _e2076) {
                                    phi_3748_ = _e2052;
                                } else {
                                    phi_3748_ = _e2076;
                                }
                                let _e2079 = phi_3748_;
                                let _e2081 = local_2.member_3;
                                let _e2085 = local_2.member_1[0u];
                                if (_e2085[0] < 0f) {
                                    phi_3765_ = -(_e2085[0]);
                                } else {
                                    phi_3765_ = _e2085[0];
                                }
                                let _e2092 = phi_3765_;
                                if (_e2085[1] < 0f) {
                                    phi_3772_ = -(_e2085[1]);
                                } else {
                                    phi_3772_ = _e2085[1];
                                }
                                let _e2096 = phi_3772_;
                                if (_e2092 > _e2096) {
                                    phi_3777_ = _e2092;
                                } else {
                                    phi_3777_ = _e2096;
                                }
                                let _e2099 = phi_3777_;
                                if (_e2085[2] < 0f) {
                                    phi_3784_ = -(_e2085[2]);
                                } else {
                                    phi_3784_ = _e2085[2];
                                }
                                let _e2103 = phi_3784_;
                                if (_e2099 > _e2103) {
                                    phi_3789_ = _e2099;
                                } else {
                                    phi_3789_ = _e2103;
                                }
                                let _e2106 = phi_3789_;
                                let _e2109 = local_2.member_1[1u];
                                if (_e2109[0] < 0f) {
                                    phi_3803_ = -(_e2109[0]);
                                } else {
                                    phi_3803_ = _e2109[0];
                                }
                                let _e2116 = phi_3803_;
                                if (_e2109[1] < 0f) {
                                    phi_3810_ = -(_e2109[1]);
                                } else {
                                    phi_3810_ = _e2109[1];
                                }
                                let _e2120 = phi_3810_;
                                if (_e2116 > _e2120) {
                                    phi_3815_ = _e2116;
                                } else {
                                    phi_3815_ = _e2120;
                                }
                                let _e2123 = phi_3815_;
                                if (_e2109[2] < 0f) {
                                    phi_3822_ = -(_e2109[2]);
                                } else {
                                    phi_3822_ = _e2109[2];
                                }
                                let _e2127 = phi_3822_;
                                if (_e2123 > _e2127) {
                                    phi_3827_ = _e2123;
                                } else {
                                    phi_3827_ = _e2127;
                                }
                                let _e2130 = phi_3827_;
                                if (_e2106 > _e2130) {
                                    phi_3832_ = _e2106;
                                } else {
                                    phi_3832_ = _e2130;
                                }
                                let _e2133 = phi_3832_;
                                let _e2135 = local_2.member_3;
                                let _e2139 = local_2.member_2[0u];
                                if (_e2139[0] < 0f) {
                                    phi_3849_ = -(_e2139[0]);
                                } else {
                                    phi_3849_ = _e2139[0];
                                }
                                let _e2146 = phi_3849_;
                                if (_e2139[1] < 0f) {
                                    phi_3856_ = -(_e2139[1]);
                                } else {
                                    phi_3856_ = _e2139[1];
                                }
                                let _e2150 = phi_3856_;
                                if (_e2146 > _e2150) {
                                    phi_3861_ = _e2146;
                                } else {
                                    phi_3861_ = _e2150;
                                }
                                let _e2153 = phi_3861_;
                                if (_e2139[2] < 0f) {
                                    phi_3868_ = -(_e2139[2]);
                                } else {
                                    phi_3868_ = _e2139[2];
                                }
                                let _e2157 = phi_3868_;
                                if (_e2153 > _e2157) {
                                    phi_3873_ = _e2153;
                                } else {
                                    phi_3873_ = _e2157;
                                }
                                let _e2160 = phi_3873_;
                                let _e2163 = local_2.member_2[1u];
                                if (_e2163[0] < 0f) {
                                    phi_3887_ = -(_e2163[0]);
                                } else {
                                    phi_3887_ = _e2163[0];
                                }
                                let _e2170 = phi_3887_;
                                if (_e2163[1] < 0f) {
                                    phi_3894_ = -(_e2163[1]);
                                } else {
                                    phi_3894_ = _e2163[1];
                                }
                                let _e2174 = phi_3894_;
                                if (_e2170 > _e2174) {
                                    phi_3899_ = _e2170;
                                } else {
                                    phi_3899_ = _e2174;
                                }
                                let _e2177 = phi_3899_;
                                if (_e2163[2] < 0f) {
                                    phi_3906_ = -(_e2163[2]);
                                } else {
                                    phi_3906_ = _e2163[2];
                                }
                                let _e2181 = phi_3906_;
                                if (_e2177 > _e2181) {
                                    phi_3911_ = _e2177;
                                } else {
                                    phi_3911_ = _e2181;
                                }
                                let _e2184 = phi_3911_;
                                if (_e2160 > _e2184) {
                                    phi_3916_ = _e2160;
                                } else {
                                    phi_3916_ = _e2184;
                                }
                                let _e2187 = phi_3916_;
                                let _e2189 = local_2.member_3;
                                let _e2193 = ((((_e2079 + _e2081) + (_e2133 + _e2135)) + (_e2187 + _e2189)) * 2f);
                                let _e2196 = local_2.member_3;
                                let _e2200 = (((_e1429 * 1.0001f) + (_e2196 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2203 = ((_e1977 * _e1956) - (_e1980 * _e1955));
                                let _e2206 = ((_e1980 * _e1954) - (_e1974 * _e1956));
                                let _e2209 = ((_e1974 * _e1955) - (_e1977 * _e1954));
                                let _e2214 = (((_e2203 * _e1983[0]) + (_e2206 * _e1983[1])) + (_e2209 * _e1983[2]));
                                let _e2219 = (((_e2203 * _e1999) + (_e2206 * _e2000)) + (_e2209 * _e2001));
                                let _e2224 = (((_e2203 * _e2002) + (_e2206 * _e2003)) + (_e2209 * _e2004));
                                let _e2229 = (((_e2203 * _e1983[0]) + (_e2206 * _e1983[1])) + (_e2209 * _e1983[2]));
                                let _e2234 = (((_e2203 * _e2007[0]) + (_e2206 * _e2007[1])) + (_e2209 * _e2007[2]));
                                let _e2239 = (((_e2203 * _e2023) + (_e2206 * _e2024)) + (_e2209 * _e2025));
                                let _e2244 = (((_e2203 * _e2026) + (_e2206 * _e2027)) + (_e2209 * _e2028));
                                let _e2249 = (((_e2203 * _e2007[0]) + (_e2206 * _e2007[1])) + (_e2209 * _e2007[2]));
                                if (_e2214 < _e2219) {
                                    phi_3995_ = _e2214;
                                } else {
                                    phi_3995_ = _e2219;
                                }
                                let _e2252 = phi_3995_;
                                if (_e2224 < _e2229) {
                                    phi_4000_ = _e2224;
                                } else {
                                    phi_4000_ = _e2229;
                                }
                                let _e2255 = phi_4000_;
                                if (_e2252 < _e2255) {
                                    phi_4005_ = _e2252;
                                } else {
                                    phi_4005_ = _e2255;
                                }
                                let _e2258 = phi_4005_;
                                if (_e2234 < _e2239) {
                                    phi_4010_ = _e2234;
                                } else {
                                    phi_4010_ = _e2239;
                                }
                                let _e2261 = phi_4010_;
                                if (_e2244 < _e2249) {
                                    phi_4015_ = _e2244;
                                } else {
                                    phi_4015_ = _e2249;
                                }
                                let _e2264 = phi_4015_;
                                if (_e2261 < _e2264) {
                                    phi_4020_ = _e2261;
                                } else {
                                    phi_4020_ = _e2264;
                                }
                                let _e2267 = phi_4020_;
                                if (_e2258 < _e2267) {
                                    phi_4025_ = _e2258;
                                } else {
                                    phi_4025_ = _e2267;
                                }
                                let _e2270 = phi_4025_;
                                if (_e2214 > _e2219) {
                                    phi_4030_ = _e2214;
                                } else {
                                    phi_4030_ = _e2219;
                                }
                                let _e2273 = phi_4030_;
                                if (_e2224 > _e2229) {
                                    phi_4035_ = _e2224;
                                } else {
                                    phi_4035_ = _e2229;
                                }
                                let _e2276 = phi_4035_;
                                if (_e2273 > _e2276) {
                                    phi_4040_ = _e2273;
                                } else {
                                    phi_4040_ = _e2276;
                                }
                                let _e2279 = phi_4040_;
                                if (_e2234 > _e2239) {
                                    phi_4045_ = _e2234;
                                } else {
                                    phi_4045_ = _e2239;
                                }
                                let _e2282 = phi_4045_;
                                if (_e2244 > _e2249) {
                                    phi_4050_ = _e2244;
                                } else {
                                    phi_4050_ = _e2249;
                                }
                                let _e2285 = phi_4050_;
                                if (_e2282 > _e2285) {
                                    phi_4055_ = _e2282;
                                } else {
                                    phi_4055_ = _e2285;
                                }
                                let _e2288 = phi_4055_;
                                if (_e2279 > _e2288) {
                                    phi_4060_ = _e2279;
                                } else {
                                    phi_4060_ = _e2288;
                                }
                                let _e2291 = phi_4060_;
                                if (_e2203 < 0f) {
                                    phi_4066_ = -(_e2203);
                                } else {
                                    phi_4066_ = _e2203;
                                }
                                let _e2295 = phi_4066_;
                                if (_e2206 < 0f) {
                                    phi_4072_ = -(_e2206);
                                } else {
                                    phi_4072_ = _e2206;
                                }
                                let _e2299 = phi_4072_;
                                if (_e2209 < 0f) {
                                    phi_4079_ = -(_e2209);
                                } else {
                                    phi_4079_ = _e2209;
                                }
                                let _e2304 = phi_4079_;
                                let _e2305 = ((_e2295 + _e2299) + _e2304);
                                let _e2310 = -(_e2291);
                                if (_e2270 > _e2310) {
                                    phi_4090_ = _e2270;
                                } else {
                                    phi_4090_ = _e2310;
                                }
                                let _e2313 = phi_4090_;
                                let _e2318 = (((_e2313 - ((_e2305 * _e2193) * (0.000000059604645f * (17f / 2f)))) - (_e2305 * _e2200)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2321 = ((_e1977 * _e1971) - (_e1980 * _e1970));
                                let _e2324 = ((_e1980 * _e1969) - (_e1974 * _e1971));
                                let _e2327 = ((_e1974 * _e1970) - (_e1977 * _e1969));
                                let _e2332 = (((_e2321 * _e1983[0]) + (_e2324 * _e1983[1])) + (_e2327 * _e1983[2]));
                                let _e2337 = (((_e2321 * _e1999) + (_e2324 * _e2000)) + (_e2327 * _e2001));
                                let _e2342 = (((_e2321 * _e2002) + (_e2324 * _e2003)) + (_e2327 * _e2004));
                                let _e2347 = (((_e2321 * _e1983[0]) + (_e2324 * _e1983[1])) + (_e2327 * _e1983[2]));
                                let _e2352 = (((_e2321 * _e2007[0]) + (_e2324 * _e2007[1])) + (_e2327 * _e2007[2]));
                                let _e2357 = (((_e2321 * _e2023) + (_e2324 * _e2024)) + (_e2327 * _e2025));
                                let _e2362 = (((_e2321 * _e2026) + (_e2324 * _e2027)) + (_e2327 * _e2028));
                                let _e2367 = (((_e2321 * _e2007[0]) + (_e2324 * _e2007[1])) + (_e2327 * _e2007[2]));
                                if (_e2332 < _e2337) {
                                    phi_4161_ = _e2332;
                                } else {
                                    phi_4161_ = _e2337;
                                }
                                let _e2370 = phi_4161_;
                                if (_e2342 < _e2347) {
                                    phi_4166_ = _e2342;
                                } else {
                                    phi_4166_ = _e2347;
                                }
                                let _e2373 = phi_4166_;
                                if (_e2370 < _e2373) {
                                    phi_4171_ = _e2370;
                                } else {
                                    phi_4171_ = _e2373;
                                }
                                let _e2376 = phi_4171_;
                                if (_e2352 < _e2357) {
                                    phi_4176_ = _e2352;
                                } else {
                                    phi_4176_ = _e2357;
                                }
                                let _e2379 = phi_4176_;
                                if (_e2362 < _e2367) {
                                    phi_4181_ = _e2362;
                                } else {
                                    phi_4181_ = _e2367;
                                }
                                let _e2382 = phi_4181_;
                                if (_e2379 < _e2382) {
                                    phi_4186_ = _e2379;
                                } else {
                                    phi_4186_ = _e2382;
                                }
                                let _e2385 = phi_4186_;
                                if (_e2376 < _e2385) {
                                    phi_4191_ = _e2376;
                                } else {
                                    phi_4191_ = _e2385;
                                }
                                let _e2388 = phi_4191_;
                                if (_e2332 > _e2337) {
                                    phi_4196_ = _e2332;
                                } else {
                                    phi_4196_ = _e2337;
                                }
                                let _e2391 = phi_4196_;
                                if (_e2342 > _e2347) {
                                    phi_4201_ = _e2342;
                                } else {
                                    phi_4201_ = _e2347;
                                }
                                let _e2394 = phi_4201_;
                                if (_e2391 > _e2394) {
                                    phi_4206_ = _e2391;
                                } else {
                                    phi_4206_ = _e2394;
                                }
                                let _e2397 = phi_4206_;
                                if (_e2352 > _e2357) {
                                    phi_4211_ = _e2352;
                                } else {
                                    phi_4211_ = _e2357;
                                }
                                let _e2400 = phi_4211_;
                                if (_e2362 > _e2367) {
                                    phi_4216_ = _e2362;
                                } else {
                                    phi_4216_ = _e2367;
                                }
                                let _e2403 = phi_4216_;
                                if (_e2400 > _e2403) {
                                    phi_4221_ = _e2400;
                                } else {
                                    phi_4221_ = _e2403;
                                }
                                let _e2406 = phi_4221_;
                                if (_e2397 > _e2406) {
                                    phi_4226_ = _e2397;
                                } else {
                                    phi_4226_ = _e2406;
                                }
                                let _e2409 = phi_4226_;
                                if (_e2321 < 0f) {
                                    phi_4232_ = -(_e2321);
                                } else {
                                    phi_4232_ = _e2321;
                                }
                                let _e2413 = phi_4232_;
                                if (_e2324 < 0f) {
                                    phi_4238_ = -(_e2324);
                                } else {
                                    phi_4238_ = _e2324;
                                }
                                let _e2417 = phi_4238_;
                                if (_e2327 < 0f) {
                                    phi_4245_ = -(_e2327);
                                } else {
                                    phi_4245_ = _e2327;
                                }
                                let _e2422 = phi_4245_;
                                let _e2423 = ((_e2413 + _e2417) + _e2422);
                                let _e2428 = -(_e2409);
                                if (_e2388 > _e2428) {
                                    phi_4256_ = _e2388;
                                } else {
                                    phi_4256_ = _e2428;
                                }
                                let _e2431 = phi_4256_;
                                let _e2436 = (((_e2431 - ((_e2423 * _e2193) * (0.000000059604645f * (17f / 2f)))) - (_e2423 * _e2200)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2318 > _e2436) {
                                    phi_4266_ = _e2318;
                                } else {
                                    phi_4266_ = _e2436;
                                }
                                let _e2439 = phi_4266_;
                                let _e2440 = (_e1969 - _e1954);
                                let _e2441 = (_e1970 - _e1955);
                                let _e2442 = (_e1971 - _e1956);
                                let _e2445 = ((_e1977 * _e2442) - (_e1980 * _e2441));
                                let _e2448 = ((_e1980 * _e2440) - (_e1974 * _e2442));
                                let _e2451 = ((_e1974 * _e2441) - (_e1977 * _e2440));
                                let _e2456 = (((_e2445 * _e1983[0]) + (_e2448 * _e1983[1])) + (_e2451 * _e1983[2]));
                                let _e2461 = (((_e2445 * _e1999) + (_e2448 * _e2000)) + (_e2451 * _e2001));
                                let _e2466 = (((_e2445 * _e2002) + (_e2448 * _e2003)) + (_e2451 * _e2004));
                                let _e2471 = (((_e2445 * _e1983[0]) + (_e2448 * _e1983[1])) + (_e2451 * _e1983[2]));
                                let _e2476 = (((_e2445 * _e2007[0]) + (_e2448 * _e2007[1])) + (_e2451 * _e2007[2]));
                                let _e2481 = (((_e2445 * _e2023) + (_e2448 * _e2024)) + (_e2451 * _e2025));
                                let _e2486 = (((_e2445 * _e2026) + (_e2448 * _e2027)) + (_e2451 * _e2028));
                                let _e2491 = (((_e2445 * _e2007[0]) + (_e2448 * _e2007[1])) + (_e2451 * _e2007[2]));
                                if (_e2456 < _e2461) {
                                    phi_4339_ = _e2456;
                                } else {
                                    phi_4339_ = _e2461;
                                }
                                let _e2494 = phi_4339_;
                                if (_e2466 < _e2471) {
                                    phi_4344_ = _e2466;
                                } else {
                                    phi_4344_ = _e2471;
                                }
                                let _e2497 = phi_4344_;
                                if (_e2494 < _e2497) {
                                    phi_4349_ = _e2494;
                                } else {
                                    phi_4349_ = _e2497;
                                }
                                let _e2500 = phi_4349_;
                                if (_e2476 < _e2481) {
                                    phi_4354_ = _e2476;
                                } else {
                                    phi_4354_ = _e2481;
                                }
                                let _e2503 = phi_4354_;
                                if (_e2486 < _e2491) {
                                    phi_4359_ = _e2486;
                                } else {
                                    phi_4359_ = _e2491;
                                }
                                let _e2506 = phi_4359_;
                                if (_e2503 < _e2506) {
                                    phi_4364_ = _e2503;
                                } else {
                                    phi_4364_ = _e2506;
                                }
                                let _e2509 = phi_4364_;
                                if (_e2500 < _e2509) {
                                    phi_4369_ = _e2500;
                                } else {
                                    phi_4369_ = _e2509;
                                }
                                let _e2512 = phi_4369_;
                                if (_e2456 > _e2461) {
                                    phi_4374_ = _e2456;
                                } else {
                                    phi_4374_ = _e2461;
                                }
                                let _e2515 = phi_4374_;
                                if (_e2466 > _e2471) {
                                    phi_4379_ = _e2466;
                                } else {
                                    phi_4379_ = _e2471;
                                }
                                let _e2518 = phi_4379_;
                                if (_e2515 > _e2518) {
                                    phi_4384_ = _e2515;
                                } else {
                                    phi_4384_ = _e2518;
                                }
                                let _e2521 = phi_4384_;
                                if (_e2476 > _e2481) {
                                    phi_4389_ = _e2476;
                                } else {
                                    phi_4389_ = _e2481;
                                }
                                let _e2524 = phi_4389_;
                                if (_e2486 > _e2491) {
                                    phi_4394_ = _e2486;
                                } else {
                                    phi_4394_ = _e2491;
                                }
                                let _e2527 = phi_4394_;
                                if (_e2524 > _e2527) {
                                    phi_4399_ = _e2524;
                                } else {
                                    phi_4399_ = _e2527;
                                }
                                let _e2530 = phi_4399_;
                                if (_e2521 > _e2530) {
                                    phi_4404_ = _e2521;
                                } else {
                                    phi_4404_ = _e2530;
                                }
                                let _e2533 = phi_4404_;
                                if (_e2445 < 0f) {
                                    phi_4410_ = -(_e2445);
                                } else {
                                    phi_4410_ = _e2445;
                                }
                                let _e2537 = phi_4410_;
                                if (_e2448 < 0f) {
                                    phi_4416_ = -(_e2448);
                                } else {
                                    phi_4416_ = _e2448;
                                }
                                let _e2541 = phi_4416_;
                                if (_e2451 < 0f) {
                                    phi_4423_ = -(_e2451);
                                } else {
                                    phi_4423_ = _e2451;
                                }
                                let _e2546 = phi_4423_;
                                let _e2547 = ((_e2537 + _e2541) + _e2546);
                                let _e2552 = -(_e2533);
                                if (_e2512 > _e2552) {
                                    phi_4434_ = _e2512;
                                } else {
                                    phi_4434_ = _e2552;
                                }
                                let _e2555 = phi_4434_;
                                let _e2560 = (((_e2555 - ((_e2547 * _e2193) * (0.000000059604645f * (17f / 2f)))) - (_e2547 * _e2200)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2439 > _e2560) {
                                    phi_4444_ = _e2439;
                                } else {
                                    phi_4444_ = _e2560;
                                }
                                let _e2563 = phi_4444_;
                                phi_4448_ = (_e1941 || (_e2563 > 0f));
                            }
                            let _e2567 = phi_4448_;
                            if _e2567 {
                                phi_7865_ = _e2567;
                            } else {
                                let _e2570 = local_2.member[0u];
                                let _e2576 = local_2.member[1u];
                                let _e2583 = ((_e2570[0] + _e2576[0]) * 0.5f);
                                let _e2584 = ((_e2570[1] + _e2576[1]) * 0.5f);
                                let _e2585 = ((_e2570[2] + _e2576[2]) * 0.5f);
                                let _e2588 = local_2.member_1[0u];
                                let _e2594 = local_2.member_1[1u];
                                let _e2601 = ((_e2588[0] + _e2594[0]) * 0.5f);
                                let _e2602 = ((_e2588[1] + _e2594[1]) * 0.5f);
                                let _e2603 = ((_e2588[2] + _e2594[2]) * 0.5f);
                                let _e2606 = local_2.member_2[0u];
                                let _e2612 = local_2.member_2[1u];
                                let _e2619 = ((_e2606[0] + _e2612[0]) * 0.5f);
                                let _e2620 = ((_e2606[1] + _e2612[1]) * 0.5f);
                                let _e2621 = ((_e2606[2] + _e2612[2]) * 0.5f);
                                let _e2624 = local_2.member[0u];
                                let _e2627 = local_2.member_1[0u];
                                let _e2630 = local_2.member_2[0u];
                                let _e2632 = local_2.member_3;
                                let _e2635 = local_2.member[1u];
                                let _e2638 = local_2.member_1[1u];
                                let _e2641 = local_2.member_2[1u];
                                let _e2643 = local_2.member_3;
                                local = type_39(array<array<f32, 3>, 2>(_e2624, array<f32, 3>(_e2583, _e2584, _e2585)), array<array<f32, 3>, 2>(_e2627, array<f32, 3>(_e2601, _e2602, _e2603)), array<array<f32, 3>, 2>(_e2630, array<f32, 3>(_e2619, _e2620, _e2621)), _e2632);
                                local_1 = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e2583, _e2584, _e2585), _e2635), array<array<f32, 3>, 2>(array<f32, 3>(_e2601, _e2602, _e2603), _e2638), array<array<f32, 3>, 2>(array<f32, 3>(_e2619, _e2620, _e2621), _e2641), _e2643);
                                let _e2660 = local.member_1[0u];
                                let _e2666 = local.member_2[0u];
                                let _e2672 = ((_e2660[1] * _e2666[2]) - (_e2660[2] * _e2666[1]));
                                let _e2675 = ((_e2660[2] * _e2666[0]) - (_e2660[0] * _e2666[2]));
                                let _e2678 = ((_e2660[0] * _e2666[1]) - (_e2660[1] * _e2666[0]));
                                let _e2681 = local.member_1[1u];
                                let _e2687 = local.member_2[1u];
                                let _e2693 = ((_e2681[1] * _e2687[2]) - (_e2681[2] * _e2687[1]));
                                let _e2696 = ((_e2681[2] * _e2687[0]) - (_e2681[0] * _e2687[2]));
                                let _e2699 = ((_e2681[0] * _e2687[1]) - (_e2681[1] * _e2687[0]));
                                let _e2702 = local.member_1[0u];
                                let _e2708 = local.member_2[1u];
                                let _e2723 = local.member_1[1u];
                                let _e2729 = local.member_2[0u];
                                let _e2742 = (((_e2702[1] * _e2708[2]) - (_e2702[2] * _e2708[1])) + ((_e2723[1] * _e2729[2]) - (_e2723[2] * _e2729[1])));
                                let _e2743 = (((_e2702[2] * _e2708[0]) - (_e2702[0] * _e2708[2])) + ((_e2723[2] * _e2729[0]) - (_e2723[0] * _e2729[2])));
                                let _e2744 = (((_e2702[0] * _e2708[1]) - (_e2702[1] * _e2708[0])) + ((_e2723[0] * _e2729[1]) - (_e2723[1] * _e2729[0])));
                                let _e2747 = local.member[0u];
                                let _e2758 = local.member[1u];
                                let _e2769 = local.member[0u];
                                let _e2778 = ((((_e2758[0] * _e2672) + (_e2758[1] * _e2675)) + (_e2758[2] * _e2678)) + (((_e2769[0] * _e2742) + (_e2769[1] * _e2743)) + (_e2769[2] * _e2744)));
                                let _e2781 = local.member[0u];
                                let _e2792 = local.member[1u];
                                let _e2801 = ((((_e2781[0] * _e2693) + (_e2781[1] * _e2696)) + (_e2781[2] * _e2699)) + (((_e2792[0] * _e2742) + (_e2792[1] * _e2743)) + (_e2792[2] * _e2744)));
                                let _e2804 = local.member[1u];
                                let _e2815 = local.member[0u];
                                if (_e2815[0] < 0f) {
                                    phi_4900_ = -(_e2815[0]);
                                } else {
                                    phi_4900_ = _e2815[0];
                                }
                                let _e2822 = phi_4900_;
                                if (_e2815[1] < 0f) {
                                    phi_4907_ = -(_e2815[1]);
                                } else {
                                    phi_4907_ = _e2815[1];
                                }
                                let _e2826 = phi_4907_;
                                if (_e2822 > _e2826) {
                                    phi_4912_ = _e2822;
                                } else {
                                    phi_4912_ = _e2826;
                                }
                                let _e2829 = phi_4912_;
                                if (_e2815[2] < 0f) {
                                    phi_4919_ = -(_e2815[2]);
                                } else {
                                    phi_4919_ = _e2815[2];
                                }
                                let _e2833 = phi_4919_;
                                if (_e2829 > _e2833) {
                                    phi_4924_ = _e2829;
                                } else {
                                    phi_4924_ = _e2833;
                                }
                                let _e2836 = phi_4924_;
                                let _e2839 = local.member[1u];
                                if (_e2839[0] < 0f) {
                                    phi_4937_ = -(_e2839[0]);
                                } else {
                                    phi_4937_ = _e2839[0];
                                }
                                let _e2846 = phi_4937_;
                                if (_e2839[1] < 0f) {
                                    phi_4944_ = -(_e2839[1]);
                                } else {
                                    phi_4944_ = _e2839[1];
                                }
                                let _e2850 = phi_4944_;
                                if (_e2846 > _e2850) {
                                    phi_4949_ = _e2846;
                                } else {
                                    phi_4949_ = _e2850;
                                }
                                let _e2853 = phi_4949_;
                                if (_e2839[2] < 0f) {
                                    phi_4956_ = -(_e2839[2]);
                                } else {
                                    phi_4956_ = _e2839[2];
                                }
                                let _e2857 = phi_4956_;
                                if (_e2853 > _e2857) {
                                    phi_4961_ = _e2853;
                                } else {
                                    phi_4961_ = _e2857;
                                }
                                let _e2860 = phi_4961_;
                                if (_e2836 > _e2860) {
                                    phi_4966_ = _e2836;
                                } else {
                                    phi_4966_ = _e2860;
                                }
                                let _e2863 = phi_4966_;
                                let _e2865 = local.member_3;
                                let _e2866 = (_e2863 + _e2865);
                                let _e2869 = local.member_1[0u];
                                if (_e2869[0] < 0f) {
                                    phi_4983_ = -(_e2869[0]);
                                } else {
                                    phi_4983_ = _e2869[0];
                                }
                                let _e2876 = phi_4983_;
                                if (_e2869[1] < 0f) {
                                    phi_4990_ = -(_e2869[1]);
                                } else {
                                    phi_4990_ = _e2869[1];
                                }
                                let _e2880 = phi_4990_;
                                if (_e2876 > _e2880) {
                                    phi_4995_ = _e2876;
                                } else {
                                    phi_4995_ = _e2880;
                                }
                                let _e2883 = phi_4995_;
                                if (_e2869[2] < 0f) {
                                    phi_5002_ = -(_e2869[2]);
                                } else {
                                    phi_5002_ = _e2869[2];
                                }
                                let _e2887 = phi_5002_;
                                if (_e2883 > _e2887) {
                                    phi_5007_ = _e2883;
                                } else {
                                    phi_5007_ = _e2887;
                                }
                                let _e2890 = phi_5007_;
                                let _e2893 = local.member_1[1u];
                                if (_e2893[0] < 0f) {
                                    phi_5021_ = -(_e2893[0]);
                                } else {
                                    phi_5021_ = _e2893[0];
                                }
                                let _e2900 = phi_5021_;
                                if (_e2893[1] < 0f) {
                                    phi_5028_ = -(_e2893[1]);
                                } else {
                                    phi_5028_ = _e2893[1];
                                }
                                let _e2904 = phi_5028_;
                                if (_e2900 > _e2904) {
                                    phi_5033_ = _e2900;
                                } else {
                                    phi_5033_ = _e2904;
                                }
                                let _e2907 = phi_5033_;
                                if (_e2893[2] < 0f) {
                                    phi_5040_ = -(_e2893[2]);
                                } else {
                                    phi_5040_ = _e2893[2];
                                }
                                let _e2911 = phi_5040_;
                                if (_e2907 > _e2911) {
                                    phi_5045_ = _e2907;
                                } else {
                                    phi_5045_ = _e2911;
                                }
                                let _e2914 = phi_5045_;
                                if (_e2890 > _e2914) {
                                    phi_5050_ = _e2890;
                                } else {
                                    phi_5050_ = _e2914;
                                }
                                let _e2917 = phi_5050_;
                                let _e2919 = local.member_3;
                                let _e2920 = (_e2917 + _e2919);
                                let _e2923 = local.member_2[0u];
                                if (_e2923[0] < 0f) {
                                    phi_5067_ = -(_e2923[0]);
                                } else {
                                    phi_5067_ = _e2923[0];
                                }
                                let _e2930 = phi_5067_;
                                if (_e2923[1] < 0f) {
                                    phi_5074_ = -(_e2923[1]);
                                } else {
                                    phi_5074_ = _e2923[1];
                                }
                                let _e2934 = phi_5074_;
                                if (_e2930 > _e2934) {
                                    phi_5079_ = _e2930;
                                } else {
                                    phi_5079_ = _e2934;
                                }
                                let _e2937 = phi_5079_;
                                if (_e2923[2] < 0f) {
                                    phi_5086_ = -(_e2923[2]);
                                } else {
                                    phi_5086_ = _e2923[2];
                                }
                                let _e2941 = phi_5086_;
                                if (_e2937 > _e2941) {
                                    phi_5091_ = _e2937;
                                } else {
                                    phi_5091_ = _e2941;
                                }
                                let _e2944 = phi_5091_;
                                let _e2947 = local.member_2[1u];
                                if (_e2947[0] < 0f) {
                                    phi_5105_ = -(_e2947[0]);
                                } else {
                                    phi_5105_ = _e2947[0];
                                }
                                let _e2954 = phi_5105_;
                                if (_e2947[1] < 0f) {
                                    phi_5112_ = -(_e2947[1]);
                                } else {
                                    phi_5112_ = _e2947[1];
                                }
                                let _e2958 = phi_5112_;
                                if (_e2954 > _e2958) {
                                    phi_5117_ = _e2954;
                                } else {
                                    phi_5117_ = _e2958;
                                }
                                let _e2961 = phi_5117_;
                                if (_e2947[2] < 0f) {
                                    phi_5124_ = -(_e2947[2]);
                                } else {
                                    phi_5124_ = _e2947[2];
                                }
                                let _e2965 = phi_5124_;
                                if (_e2961 > _e2965) {
                                    phi_5129_ = _e2961;
                                } else {
                                    phi_5129_ = _e2965;
                                }
                                let _e2968 = phi_5129_;
                                if (_e2944 > _e2968) {
                                    phi_5134_ = _e2944;
                                } else {
                                    phi_5134_ = _e2968;
                                }
                                let _e2971 = phi_5134_;
                                let _e2973 = local.member_3;
                                let _e2974 = (_e2971 + _e2973);
                                let _e2976 = ((_e2920 * 8f) * _e2974);
                                let _e2983 = local.member_3;
                                if (_e2672 < 0f) {
                                    phi_5165_ = -(_e2672);
                                } else {
                                    phi_5165_ = _e2672;
                                }
                                let _e3000 = phi_5165_;
                                if (_e2675 < 0f) {
                                    phi_5171_ = -(_e2675);
                                } else {
                                    phi_5171_ = _e2675;
                                }
                                let _e3004 = phi_5171_;
                                if (_e2678 < 0f) {
                                    phi_5178_ = -(_e2678);
                                } else {
                                    phi_5178_ = _e2678;
                                }
                                let _e3009 = phi_5178_;
                                let _e3010 = ((_e3000 + _e3004) + _e3009);
                                if (_e2693 < 0f) {
                                    phi_5185_ = -(_e2693);
                                } else {
                                    phi_5185_ = _e2693;
                                }
                                let _e3014 = phi_5185_;
                                if (_e2696 < 0f) {
                                    phi_5191_ = -(_e2696);
                                } else {
                                    phi_5191_ = _e2696;
                                }
                                let _e3018 = phi_5191_;
                                if (_e2699 < 0f) {
                                    phi_5198_ = -(_e2699);
                                } else {
                                    phi_5198_ = _e2699;
                                }
                                let _e3023 = phi_5198_;
                                let _e3024 = ((_e3014 + _e3018) + _e3023);
                                if (_e3010 > _e3024) {
                                    phi_5204_ = _e3010;
                                } else {
                                    phi_5204_ = _e3024;
                                }
                                let _e3027 = phi_5204_;
                                if (_e2742 < 0f) {
                                    phi_5210_ = -(_e2742);
                                } else {
                                    phi_5210_ = _e2742;
                                }
                                let _e3031 = phi_5210_;
                                if (_e2743 < 0f) {
                                    phi_5216_ = -(_e2743);
                                } else {
                                    phi_5216_ = _e2743;
                                }
                                let _e3035 = phi_5216_;
                                if (_e2744 < 0f) {
                                    phi_5223_ = -(_e2744);
                                } else {
                                    phi_5223_ = _e2744;
                                }
                                let _e3040 = phi_5223_;
                                let _e3042 = (((_e3031 + _e3035) + _e3040) * 0.5f);
                                if (_e3027 > _e3042) {
                                    phi_5230_ = _e3027;
                                } else {
                                    phi_5230_ = _e3042;
                                }
                                let _e3045 = phi_5230_;
                                let _e3050 = local.member_3;
                                let _e3063 = ((((_e2747[0] * _e2672) + (_e2747[1] * _e2675)) + (_e2747[2] * _e2678)) * 3f);
                                let _e3064 = ((((_e2804[0] * _e2693) + (_e2804[1] * _e2696)) + (_e2804[2] * _e2699)) * 3f);
                                if (_e3063 < _e3064) {
                                    phi_5254_ = _e3063;
                                } else {
                                    phi_5254_ = _e3064;
                                }
                                let _e3067 = phi_5254_;
                                if (_e2778 < _e2801) {
                                    phi_5259_ = _e2778;
                                } else {
                                    phi_5259_ = _e2801;
                                }
                                let _e3070 = phi_5259_;
                                if (_e3067 < _e3070) {
                                    phi_5264_ = _e3067;
                                } else {
                                    phi_5264_ = _e3070;
                                }
                                let _e3073 = phi_5264_;
                                if (_e3063 > _e3064) {
                                    phi_5269_ = _e3063;
                                } else {
                                    phi_5269_ = _e3064;
                                }
                                let _e3076 = phi_5269_;
                                if (_e2778 > _e2801) {
                                    phi_5274_ = _e2778;
                                } else {
                                    phi_5274_ = _e2801;
                                }
                                let _e3079 = phi_5274_;
                                if (_e3076 > _e3079) {
                                    phi_5279_ = _e3076;
                                } else {
                                    phi_5279_ = _e3079;
                                }
                                let _e3082 = phi_5279_;
                                let _e3087 = -(_e3082);
                                if (_e3073 > _e3087) {
                                    phi_5289_ = _e3073;
                                } else {
                                    phi_5289_ = _e3087;
                                }
                                let _e3090 = phi_5289_;
                                let _e3092 = ((_e3090 - ((((((_e2866 * 8f) * _e2976) * (0.000000059604645f * (524f / 64f))) + ((_e2983 * 19f) * ((_e2866 * (_e2920 + _e2974)) + (_e2920 * _e2974)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2866) * ((1f + _e2920) * (1f + _e2974))))) + ((_e1429 * (((_e3045 + (_e2976 * (0.000000059604645f * 8f))) + ((_e3050 * 6f) * (_e2920 + _e2974))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2920) * (1f + _e2974))))) * (3f * 1.0001f)))) > 0f);
                                if _e3092 {
                                    phi_6258_ = _e3092;
                                } else {
                                    let _e3095 = local.member_1[0u];
                                    let _e3101 = local.member_1[1u];
                                    let _e3105 = (_e3095[0] + _e3101[0]);
                                    let _e3106 = (_e3095[1] + _e3101[1]);
                                    let _e3107 = (_e3095[2] + _e3101[2]);
                                    let _e3110 = local.member_2[0u];
                                    let _e3116 = local.member_2[1u];
                                    let _e3120 = (_e3110[0] + _e3116[0]);
                                    let _e3121 = (_e3110[1] + _e3116[1]);
                                    let _e3122 = (_e3110[2] + _e3116[2]);
                                    let _e3125 = ((_e3106 * _e3122) - (_e3107 * _e3121));
                                    let _e3128 = ((_e3107 * _e3120) - (_e3105 * _e3122));
                                    let _e3131 = ((_e3105 * _e3121) - (_e3106 * _e3120));
                                    let _e3134 = local.member[0u];
                                    let _e3140 = local.member_1[0u];
                                    let _e3146 = local.member_2[0u];
                                    let _e3150 = (_e3134[0] - _e3140[0]);
                                    let _e3151 = (_e3134[1] - _e3140[1]);
                                    let _e3152 = (_e3134[2] - _e3140[2]);
                                    let _e3153 = (_e3134[0] - _e3146[0]);
                                    let _e3154 = (_e3134[1] - _e3146[1]);
                                    let _e3155 = (_e3134[2] - _e3146[2]);
                                    let _e3158 = local.member[1u];
                                    let _e3164 = local.member_1[1u];
                                    let _e3170 = local.member_2[1u];
                                    let _e3174 = (_e3158[0] - _e3164[0]);
                                    let _e3175 = (_e3158[1] - _e3164[1]);
                                    let _e3176 = (_e3158[2] - _e3164[2]);
                                    let _e3177 = (_e3158[0] - _e3170[0]);
                                    let _e3178 = (_e3158[1] - _e3170[1]);
                                    let _e3179 = (_e3158[2] - _e3170[2]);
                                    let _e3182 = local.member[0u];
                                    if (_e3182[0] < 0f) {
                                        phi_5492_ = -(_e3182[0]);
                                    } else {
                                        phi_5492_ = _e3182[0];
                                    }
                                    let _e3189 = phi_5492_;
                                    if (_e3182[1] < 0f) {
                                        phi_5499_ = -(_e3182[1]);
                                    } else {
                                        phi_5499_ = _e3182[1];
                                    }
                                    let _e3193 = phi_5499_;
                                    if (_e3189 > _e3193) {
                                        phi_5504_ = _e3189;
                                    } else {
                                        phi_5504_ = _e3193;
                                    }
                                    let _e3196 = phi_5504_;
                                    if (_e3182[2] < 0f) {
                                        phi_5511_ = -(_e3182[2]);
                                    } else {
                                        phi_5511_ = _e3182[2];
                                    }
                                    let _e3200 = phi_5511_;
                                    if (_e3196 > _e3200) {
                                        phi_5516_ = _e3196;
                                    } else {
                                        phi_5516_ = _e3200;
                                    }
                                    let _e3203 = phi_5516_;
                                    let _e3206 = local.member[1u];
                                    if (_e3206[0] < 0f) {
                                        phi_5529_ = -(_e3206[0]);
                                    } else {
                                        phi_5529_ = _e3206[0];
                                    }
                                    let _e3213 = phi_5529_;
                                    if (_e3206[1] < 0f) {
                                        phi_5536_ = -(_e3206[1]);
                                    } else {
                                        phi_5536_ = _e3206[1];
                                    }
                                    let _e3217 = phi_5536_;
                                    if (_e3213 > _e3217) {
                                        phi_5541_ = _e3213;
                                    } else {
                                        phi_5541_ = _e3217;
                                    }
                                    let _e3220 = phi_5541_;
                                    if (_e3206[2] < 0f) {
                                        phi_5548_ = -(_e3206[2]);
                                    } else {
                                        phi_5548_ = _e3206[2];
                                    }
                                    let _e3224 = phi_5548_;
                                    if (_e3220 > _e3224) {
                                        phi_5553_ = _e3220;
                                    } else {
                                        phi_5553_ = _e3224;
                                    }
                                    let _e3227 = phi_5553_;
                                    if (_e3203 > _e3227) {
                                        phi_5558_ = _e3203;
                                    } else {
                                        phi_5558_ = _e3227;
                                    }
                                    let _e3230 = phi_5558_;
                                    let _e3232 = local.member_3;
                                    let _e3236 = local.member_1[0u];
                                    if (_e3236[0] < 0f) {
                                        phi_5575_ = -(_e3236[0]);
                                    } else {
                                        phi_5575_ = _e3236[0];
                                    }
                                    let _e3243 = phi_5575_;
                                    if (_e3236[1] < 0f) {
                                        phi_5582_ = -(_e3236[1]);
                                    } else {
                                        phi_5582_ = _e3236[1];
                                    }
                                    let _e3247 = phi_5582_;
                                    if (_e3243 > _e3247) {
                                        phi_5587_ = _e3243;
                                    } else {
                                        phi_5587_ = _e3247;
                                    }
                                    let _e3250 = phi_5587_;
                                    if (_e3236[2] < 0f) {
                                        phi_5594_ = -(_e3236[2]);
                                    } else {
                                        phi_5594_ = _e3236[2];
                                    }
                                    let _e3254 = phi_5594_;
                                    if (_e3250 > _e3254) {
                                        phi_5599_ = _e3250;
                                    } else {
                                        phi_5599_ = _e3254;
                                    }
                                    let _e3257 = phi_5599_;
                                    let _e3260 = local.member_1[1u];
                                    if (_e3260[0] < 0f) {
                                        phi_5613_ = -(_e3260[0]);
                                    } else {
                                        phi_5613_ = _e3260[0];
                                    }
                                    let _e3267 = phi_5613_;
                                    if (_e3260[1] < 0f) {
                                        phi_5620_ = -(_e3260[1]);
                                    } else {
                                        phi_5620_ = _e3260[1];
                                    }
                                    let _e3271 = phi_5620_;
                                    if (_e3267 > _e3271) {
                                        phi_5625_ = _e3267;
                                    } else {
                                        phi_5625_ = _e3271;
                                    }
                                    let _e3274 = phi_5625_;
                                    if (_e3260[2] < 0f) {
                                        phi_5632_ = -(_e3260[2]);
                                    } else {
                                        phi_5632_ = _e3260[2];
                                    }
                                    let _e3278 = phi_5632_;
                                    if (_e3274 > _e3278) {
                                        phi_5637_ = _e3274;
                                    } else {
                                        phi_5637_ = _e3278;
                                    }
                                    let _e3281 = phi_5637_;
                                    if (_e3257 > _e3281) {
                                        phi_5642_ = _e3257;
                                    } else {
                                        phi_5642_ = _e3281;
                                    }
                                    let _e3284 = phi_5642_;
                                    let _e3286 = local.member_3;
                                    let _e3290 = local.member_2[0u];
                                    if (_e3290[0] < 0f) {
                                        phi_5659_ = -(_e3290[0]);
                                    } else {
                                        phi_5659_ = _e3290[0];
                                    }
                                    let _e3297 = phi_5659_;
                                    if (_e3290[1] < 0f) {
                                        phi_5666_ = -(_e3290[1]);
                                    } else {
                                        phi_5666_ = _e3290[1];
                                    }
                                    let _e3301 = phi_5666_;
                                    if (_e3297 > _e3301) {
                                        phi_5671_ = _e3297;
                                    } else {
                                        phi_5671_ = _e3301;
                                    }
                                    let _e3304 = phi_5671_;
                                    if (_e3290[2] < 0f) {
                                        phi_5678_ = -(_e3290[2]);
                                    } else {
                                        phi_5678_ = _e3290[2];
                                    }
                                    let _e3308 = phi_5678_;
                                    if (_e3304 > _e3308) {
                                        phi_5683_ = _e3304;
                                    } else {
                                        phi_5683_ = _e3308;
                                    }
                                    let _e3311 = phi_5683_;
                                    let _e3314 = local.member_2[1u];
                                    if (_e3314[0] < 0f) {
                                        phi_5697_ = -(_e3314[0]);
                                    } else {
                                        phi_5697_ = _e3314[0];
                                    }
                                    let _e3321 = phi_5697_;
                                    if (_e3314[1] < 0f) {
                                        phi_5704_ = -(_e3314[1]);
                                    } else {
                                        phi_5704_ = _e3314[1];
                                    }
                                    let _e3325 = phi_5704_;
                                    if (_e3321 > _e3325) {
                                        phi_5709_ = _e3321;
                                    } else {
                                        phi_5709_ = _e3325;
                                    }
                                    let _e3328 = phi_5709_;
                                    if (_e3314[2] < 0f) {
                                        phi_5716_ = -(_e3314[2]);
                                    } else {
                                        phi_5716_ = _e3314[2];
                                    }
                                    let _e3332 = phi_5716_;
                                    if (_e3328 > _e3332) {
                                        phi_5721_ = _e3328;
                                    } else {
                                        phi_5721_ = _e3332;
                                    }
                                    let _e3335 = phi_5721_;
                                    if (_e3311 > _e3335) {
                                        phi_5726_ = _e3311;
                                    } else {
                                        phi_5726_ = _e3335;
                                    }
                                    let _e3338 = phi_5726_;
                                    let _e3340 = local.member_3;
                                    let _e3344 = ((((_e3230 + _e3232) + (_e3284 + _e3286)) + (_e3338 + _e3340)) * 2f);
                                    let _e3347 = local.member_3;
                                    let _e3351 = (((_e1429 * 1.0001f) + (_e3347 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3354 = ((_e3128 * _e3107) - (_e3131 * _e3106));
                                    let _e3357 = ((_e3131 * _e3105) - (_e3125 * _e3107));
                                    let _e3360 = ((_e3125 * _e3106) - (_e3128 * _e3105));
                                    let _e3365 = (((_e3354 * _e3134[0]) + (_e3357 * _e3134[1])) + (_e3360 * _e3134[2]));
                                    let _e3370 = (((_e3354 * _e3150) + (_e3357 * _e3151)) + (_e3360 * _e3152));
                                    let _e3375 = (((_e3354 * _e3153) + (_e3357 * _e3154)) + (_e3360 * _e3155));
                                    let _e3380 = (((_e3354 * _e3134[0]) + (_e3357 * _e3134[1])) + (_e3360 * _e3134[2]));
                                    let _e3385 = (((_e3354 * _e3158[0]) + (_e3357 * _e3158[1])) + (_e3360 * _e3158[2]));
                                    let _e3390 = (((_e3354 * _e3174) + (_e3357 * _e3175)) + (_e3360 * _e3176));
                                    let _e3395 = (((_e3354 * _e3177) + (_e3357 * _e3178)) + (_e3360 * _e3179));
                                    let _e3400 = (((_e3354 * _e3158[0]) + (_e3357 * _e3158[1])) + (_e3360 * _e3158[2]));
                                    if (_e3365 < _e3370) {
                                        phi_5805_ = _e3365;
                                    } else {
                                        phi_5805_ = _e3370;
                                    }
                                    let _e3403 = phi_5805_;
                                    if (_e3375 < _e3380) {
                                        phi_5810_ = _e3375;
                                    } else {
                                        phi_5810_ = _e3380;
                                    }
                                    let _e3406 = phi_5810_;
                                    if (_e3403 < _e3406) {
                                        phi_5815_ = _e3403;
                                    } else {
                                        phi_5815_ = _e3406;
                                    }
                                    let _e3409 = phi_5815_;
                                    if (_e3385 < _e3390) {
                                        phi_5820_ = _e3385;
                                    } else {
                                        phi_5820_ = _e3390;
                                    }
                                    let _e3412 = phi_5820_;
                                    if (_e3395 < _e3400) {
                                        phi_5825_ = _e3395;
                                    } else {
                                        phi_5825_ = _e3400;
                                    }
                                    let _e3415 = phi_5825_;
                                    if (_e3412 < _e3415) {
                                        phi_5830_ = _e3412;
                                    } else {
                                        phi_5830_ = _e3415;
                                    }
                                    let _e3418 = phi_5830_;
                                    if (_e3409 < _e3418) {
                                        phi_5835_ = _e3409;
                                    } else {
                                        phi_5835_ = _e3418;
                                    }
                                    let _e3421 = phi_5835_;
                                    if (_e3365 > _e3370) {
                                        phi_5840_ = _e3365;
                                    } else {
                                        phi_5840_ = _e3370;
                                    }
                                    let _e3424 = phi_5840_;
                                    if (_e3375 > _e3380) {
                                        phi_5845_ = _e3375;
                                    } else {
                                        phi_5845_ = _e3380;
                                    }
                                    let _e3427 = phi_5845_;
                                    if (_e3424 > _e3427) {
                                        phi_5850_ = _e3424;
                                    } else {
                                        phi_5850_ = _e3427;
                                    }
                                    let _e3430 = phi_5850_;
                                    if (_e3385 > _e3390) {
                                        phi_5855_ = _e3385;
                                    } else {
                                        phi_5855_ = _e3390;
                                    }
                                    let _e3433 = phi_5855_;
                                    if (_e3395 > _e3400) {
                                        phi_5860_ = _e3395;
                                    } else {
                                        phi_5860_ = _e3400;
                                    }
                                    let _e3436 = phi_5860_;
                                    if (_e3433 > _e3436) {
                                        phi_5865_ = _e3433;
                                    } else {
                                        phi_5865_ = _e3436;
                                    }
                                    let _e3439 = phi_5865_;
                                    if (_e3430 > _e3439) {
                                        phi_5870_ = _e3430;
                                    } else {
                                        phi_5870_ = _e3439;
                                    }
                                    let _e3442 = phi_5870_;
                                    if (_e3354 < 0f) {
                                        phi_5876_ = -(_e3354);
                                    } else {
                                        phi_5876_ = _e3354;
                                    }
                                    let _e3446 = phi_5876_;
                                    if (_e3357 < 0f) {
                                        phi_5882_ = -(_e3357);
                                    } else {
                                        phi_5882_ = _e3357;
                                    }
                                    let _e3450 = phi_5882_;
                                    if (_e3360 < 0f) {
                                        phi_5889_ = -(_e3360);
                                    } else {
                                        phi_5889_ = _e3360;
                                    }
                                    let _e3455 = phi_5889_;
                                    let _e3456 = ((_e3446 + _e3450) + _e3455);
                                    let _e3461 = -(_e3442);
                                    if (_e3421 > _e3461) {
                                        phi_5900_ = _e3421;
                                    } else {
                                        phi_5900_ = _e3461;
                                    }
                                    let _e3464 = phi_5900_;
                                    let _e3469 = (((_e3464 - ((_e3456 * _e3344) * (0.000000059604645f * (17f / 2f)))) - (_e3456 * _e3351)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3472 = ((_e3128 * _e3122) - (_e3131 * _e3121));
                                    let _e3475 = ((_e3131 * _e3120) - (_e3125 * _e3122));
                                    let _e3478 = ((_e3125 * _e3121) - (_e3128 * _e3120));
                                    let _e3483 = (((_e3472 * _e3134[0]) + (_e3475 * _e3134[1])) + (_e3478 * _e3134[2]));
                                    let _e3488 = (((_e3472 * _e3150) + (_e3475 * _e3151)) + (_e3478 * _e3152));
                                    let _e3493 = (((_e3472 * _e3153) + (_e3475 * _e3154)) + (_e3478 * _e3155));
                                    let _e3498 = (((_e3472 * _e3134[0]) + (_e3475 * _e3134[1])) + (_e3478 * _e3134[2]));
                                    let _e3503 = (((_e3472 * _e3158[0]) + (_e3475 * _e3158[1])) + (_e3478 * _e3158[2]));
                                    let _e3508 = (((_e3472 * _e3174) + (_e3475 * _e3175)) + (_e3478 * _e3176));
                                    let _e3513 = (((_e3472 * _e3177) + (_e3475 * _e3178)) + (_e3478 * _e3179));
                                    let _e3518 = (((_e3472 * _e3158[0]) + (_e3475 * _e3158[1])) + (_e3478 * _e3158[2]));
                                    if (_e3483 < _e3488) {
                                        phi_5971_ = _e3483;
                                    } else {
                                        phi_5971_ = _e3488;
                                    }
                                    let _e3521 = phi_5971_;
                                    if (_e3493 < _e3498) {
                                        phi_5976_ = _e3493;
                                    } else {
                                        phi_5976_ = _e3498;
                                    }
                                    let _e3524 = phi_5976_;
                                    if (_e3521 < _e3524) {
                                        phi_5981_ = _e3521;
                                    } else {
                                        phi_5981_ = _e3524;
                                    }
                                    let _e3527 = phi_5981_;
                                    if (_e3503 < _e3508) {
                                        phi_5986_ = _e3503;
                                    } else {
                                        phi_5986_ = _e3508;
                                    }
                                    let _e3530 = phi_5986_;
                                    if (_e3513 < _e3518) {
                                        phi_5991_ = _e3513;
                                    } else {
                                        phi_5991_ = _e3518;
                                    }
                                    let _e3533 = phi_5991_;
                                    if (_e3530 < _e3533) {
                                        phi_5996_ = _e3530;
                                    } else {
                                        phi_5996_ = _e3533;
                                    }
                                    let _e3536 = phi_5996_;
                                    if (_e3527 < _e3536) {
                                        phi_6001_ = _e3527;
                                    } else {
                                        phi_6001_ = _e3536;
                                    }
                                    let _e3539 = phi_6001_;
                                    if (_e3483 > _e3488) {
                                        phi_6006_ = _e3483;
                                    } else {
                                        phi_6006_ = _e3488;
                                    }
                                    let _e3542 = phi_6006_;
                                    if (_e3493 > _e3498) {
                                        phi_6011_ = _e3493;
                                    } else {
                                        phi_6011_ = _e3498;
                                    }
                                    let _e3545 = phi_6011_;
                                    if (_e3542 > _e3545) {
                                        phi_6016_ = _e3542;
                                    } else {
                                        phi_6016_ = _e3545;
                                    }
                                    let _e3548 = phi_6016_;
                                    if (_e3503 > _e3508) {
                                        phi_6021_ = _e3503;
                                    } else {
                                        phi_6021_ = _e3508;
                                    }
                                    let _e3551 = phi_6021_;
                                    if (_e3513 > _e3518) {
                                        phi_6026_ = _e3513;
                                    } else {
                                        phi_6026_ = _e3518;
                                    }
                                    let _e3554 = phi_6026_;
                                    if (_e3551 > _e3554) {
                                        phi_6031_ = _e3551;
                                    } else {
                                        phi_6031_ = _e3554;
                                    }
                                    let _e3557 = phi_6031_;
                                    if (_e3548 > _e3557) {
                                        phi_6036_ = _e3548;
                                    } else {
                                        phi_6036_ = _e3557;
                                    }
                                    let _e3560 = phi_6036_;
                                    if (_e3472 < 0f) {
                                        phi_6042_ = -(_e3472);
                                    } else {
                                        phi_6042_ = _e3472;
                                    }
                                    let _e3564 = phi_6042_;
                                    if (_e3475 < 0f) {
                                        phi_6048_ = -(_e3475);
                                    } else {
                                        phi_6048_ = _e3475;
                                    }
                                    let _e3568 = phi_6048_;
                                    if (_e3478 < 0f) {
                                        phi_6055_ = -(_e3478);
                                    } else {
                                        phi_6055_ = _e3478;
                                    }
                                    let _e3573 = phi_6055_;
                                    let _e3574 = ((_e3564 + _e3568) + _e3573);
                                    let _e3579 = -(_e3560);
                                    if (_e3539 > _e3579) {
                                        phi_6066_ = _e3539;
                                    } else {
                                        phi_6066_ = _e3579;
                                    }
                                    let _e3582 = phi_6066_;
                                    let _e3587 = (((_e3582 - ((_e3574 * _e3344) * (0.000000059604645f * (17f / 2f)))) - (_e3574 * _e3351)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3469 > _e3587) {
                                        phi_6076_ = _e3469;
                                    } else {
                                        phi_6076_ = _e3587;
                                    }
                                    let _e3590 = phi_6076_;
                                    let _e3591 = (_e3120 - _e3105);
                                    let _e3592 = (_e3121 - _e3106);
                                    let _e3593 = (_e3122 - _e3107);
                                    let _e3596 = ((_e3128 * _e3593) - (_e3131 * _e3592));
                                    let _e3599 = ((_e3131 * _e3591) - (_e3125 * _e3593));
                                    let _e3602 = ((_e3125 * _e3592) - (_e3128 * _e3591));
                                    let _e3607 = (((_e3596 * _e3134[0]) + (_e3599 * _e3134[1])) + (_e3602 * _e3134[2]));
                                    let _e3612 = (((_e3596 * _e3150) + (_e3599 * _e3151)) + (_e3602 * _e3152));
                                    let _e3617 = (((_e3596 * _e3153) + (_e3599 * _e3154)) + (_e3602 * _e3155));
                                    let _e3622 = (((_e3596 * _e3134[0]) + (_e3599 * _e3134[1])) + (_e3602 * _e3134[2]));
                                    let _e3627 = (((_e3596 * _e3158[0]) + (_e3599 * _e3158[1])) + (_e3602 * _e3158[2]));
                                    let _e3632 = (((_e3596 * _e3174) + (_e3599 * _e3175)) + (_e3602 * _e3176));
                                    let _e3637 = (((_e3596 * _e3177) + (_e3599 * _e3178)) + (_e3602 * _e3179));
                                    let _e3642 = (((_e3596 * _e3158[0]) + (_e3599 * _e3158[1])) + (_e3602 * _e3158[2]));
                                    if (_e3607 < _e3612) {
                                        phi_6149_ = _e3607;
                                    } else {
                                        phi_6149_ = _e3612;
                                    }
                                    let _e3645 = phi_6149_;
                                    if (_e3617 < _e3622) {
                                        phi_6154_ = _e3617;
                                    } else {
                                        phi_6154_ = _e3622;
                                    }
                                    let _e3648 = phi_6154_;
                                    if (_e3645 < _e3648) {
                                        phi_6159_ = _e3645;
                                    } else {
                                        phi_6159_ = _e3648;
                                    }
                                    let _e3651 = phi_6159_;
                                    if (_e3627 < _e3632) {
                                        phi_6164_ = _e3627;
                                    } else {
                                        phi_6164_ = _e3632;
                                    }
                                    let _e3654 = phi_6164_;
                                    if (_e3637 < _e3642) {
                                        phi_6169_ = _e3637;
                                    } else {
                                        phi_6169_ = _e3642;
                                    }
                                    let _e3657 = phi_6169_;
                                    if (_e3654 < _e3657) {
                                        phi_6174_ = _e3654;
                                    } else {
                                        phi_6174_ = _e3657;
                                    }
                                    let _e3660 = phi_6174_;
                                    if (_e3651 < _e3660) {
                                        phi_6179_ = _e3651;
                                    } else {
                                        phi_6179_ = _e3660;
                                    }
                                    let _e3663 = phi_6179_;
                                    if (_e3607 > _e3612) {
                                        phi_6184_ = _e3607;
                                    } else {
                                        phi_6184_ = _e3612;
                                    }
                                    let _e3666 = phi_6184_;
                                    if (_e3617 > _e3622) {
                                        phi_6189_ = _e3617;
                                    } else {
                                        phi_6189_ = _e3622;
                                    }
                                    let _e3669 = phi_6189_;
                                    if (_e3666 > _e3669) {
                                        phi_6194_ = _e3666;
                                    } else {
                                        phi_6194_ = _e3669;
                                    }
                                    let _e3672 = phi_6194_;
                                    if (_e3627 > _e3632) {
                                        phi_6199_ = _e3627;
                                    } else {
                                        phi_6199_ = _e3632;
                                    }
                                    let _e3675 = phi_6199_;
                                    if (_e3637 > _e3642) {
                                        phi_6204_ = _e3637;
                                    } else {
                                        phi_6204_ = _e3642;
                                    }
                                    let _e3678 = phi_6204_;
                                    if (_e3675 > _e3678) {
                                        phi_6209_ = _e3675;
                                    } else {
                                        phi_6209_ = _e3678;
                                    }
                                    let _e3681 = phi_6209_;
                                    if (_e3672 > _e3681) {
                                        phi_6214_ = _e3672;
                                    } else {
                                        phi_6214_ = _e3681;
                                    }
                                    let _e3684 = phi_6214_;
                                    if (_e3596 < 0f) {
                                        phi_6220_ = -(_e3596);
                                    } else {
                                        phi_6220_ = _e3596;
                                    }
                                    let _e3688 = phi_6220_;
                                    if (_e3599 < 0f) {
                                        phi_6226_ = -(_e3599);
                                    } else {
                                        phi_6226_ = _e3599;
                                    }
                                    let _e3692 = phi_6226_;
                                    if (_e3602 < 0f) {
                                        phi_6233_ = -(_e3602);
                                    } else {
                                        phi_6233_ = _e3602;
                                    }
                                    let _e3697 = phi_6233_;
                                    let _e3698 = ((_e3688 + _e3692) + _e3697);
                                    let _e3703 = -(_e3684);
                                    if (_e3663 > _e3703) {
                                        phi_6244_ = _e3663;
                                    } else {
                                        phi_6244_ = _e3703;
                                    }
                                    let _e3706 = phi_6244_;
                                    let _e3711 = (((_e3706 - ((_e3698 * _e3344) * (0.000000059604645f * (17f / 2f)))) - (_e3698 * _e3351)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3590 > _e3711) {
                                        phi_6254_ = _e3590;
                                    } else {
                                        phi_6254_ = _e3711;
                                    }
                                    let _e3714 = phi_6254_;
                                    phi_6258_ = (_e3092 || (_e3714 > 0f));
                                }
                                let _e3718 = phi_6258_;
                                if _e3718 {
                                    let _e3721 = local_1.member_1[0u];
                                    let _e3727 = local_1.member_2[0u];
                                    let _e3733 = ((_e3721[1] * _e3727[2]) - (_e3721[2] * _e3727[1]));
                                    let _e3736 = ((_e3721[2] * _e3727[0]) - (_e3721[0] * _e3727[2]));
                                    let _e3739 = ((_e3721[0] * _e3727[1]) - (_e3721[1] * _e3727[0]));
                                    let _e3742 = local_1.member_1[1u];
                                    let _e3748 = local_1.member_2[1u];
                                    let _e3754 = ((_e3742[1] * _e3748[2]) - (_e3742[2] * _e3748[1]));
                                    let _e3757 = ((_e3742[2] * _e3748[0]) - (_e3742[0] * _e3748[2]));
                                    let _e3760 = ((_e3742[0] * _e3748[1]) - (_e3742[1] * _e3748[0]));
                                    let _e3763 = local_1.member_1[0u];
                                    let _e3769 = local_1.member_2[1u];
                                    let _e3784 = local_1.member_1[1u];
                                    let _e3790 = local_1.member_2[0u];
                                    let _e3803 = (((_e3763[1] * _e3769[2]) - (_e3763[2] * _e3769[1])) + ((_e3784[1] * _e3790[2]) - (_e3784[2] * _e3790[1])));
                                    let _e3804 = (((_e3763[2] * _e3769[0]) - (_e3763[0] * _e3769[2])) + ((_e3784[2] * _e3790[0]) - (_e3784[0] * _e3790[2])));
                                    let _e3805 = (((_e3763[0] * _e3769[1]) - (_e3763[1] * _e3769[0])) + ((_e3784[0] * _e3790[1]) - (_e3784[1] * _e3790[0])));
                                    let _e3808 = local_1.member[0u];
                                    let _e3819 = local_1.member[1u];
                                    let _e3830 = local_1.member[0u];
                                    let _e3839 = ((((_e3819[0] * _e3733) + (_e3819[1] * _e3736)) + (_e3819[2] * _e3739)) + (((_e3830[0] * _e3803) + (_e3830[1] * _e3804)) + (_e3830[2] * _e3805)));
                                    let _e3842 = local_1.member[0u];
                                    let _e3853 = local_1.member[1u];
                                    let _e3862 = ((((_e3842[0] * _e3754) + (_e3842[1] * _e3757)) + (_e3842[2] * _e3760)) + (((_e3853[0] * _e3803) + (_e3853[1] * _e3804)) + (_e3853[2] * _e3805)));
                                    let _e3865 = local_1.member[1u];
                                    let _e3876 = local_1.member[0u];
                                    if (_e3876[0] < 0f) {
                                        phi_6503_ = -(_e3876[0]);
                                    } else {
                                        phi_6503_ = _e3876[0];
                                    }
                                    let _e3883 = phi_6503_;
                                    if (_e3876[1] < 0f) {
                                        phi_6510_ = -(_e3876[1]);
                                    } else {
                                        phi_6510_ = _e3876[1];
                                    }
                                    let _e3887 = phi_6510_;
                                    if (_e3883 > _e3887) {
                                        phi_6515_ = _e3883;
                                    } else {
                                        phi_6515_ = _e3887;
                                    }
                                    let _e3890 = phi_6515_;
                                    if (_e3876[2] < 0f) {
                                        phi_6522_ = -(_e3876[2]);
                                    } else {
                                        phi_6522_ = _e3876[2];
                                    }
                                    let _e3894 = phi_6522_;
                                    if (_e3890 > _e3894) {
                                        phi_6527_ = _e3890;
                                    } else {
                                        phi_6527_ = _e3894;
                                    }
                                    let _e3897 = phi_6527_;
                                    let _e3900 = local_1.member[1u];
                                    if (_e3900[0] < 0f) {
                                        phi_6540_ = -(_e3900[0]);
                                    } else {
                                        phi_6540_ = _e3900[0];
                                    }
                                    let _e3907 = phi_6540_;
                                    if (_e3900[1] < 0f) {
                                        phi_6547_ = -(_e3900[1]);
                                    } else {
                                        phi_6547_ = _e3900[1];
                                    }
                                    let _e3911 = phi_6547_;
                                    if (_e3907 > _e3911) {
                                        phi_6552_ = _e3907;
                                    } else {
                                        phi_6552_ = _e3911;
                                    }
                                    let _e3914 = phi_6552_;
                                    if (_e3900[2] < 0f) {
                                        phi_6559_ = -(_e3900[2]);
                                    } else {
                                        phi_6559_ = _e3900[2];
                                    }
                                    let _e3918 = phi_6559_;
                                    if (_e3914 > _e3918) {
                                        phi_6564_ = _e3914;
                                    } else {
                                        phi_6564_ = _e3918;
                                    }
                                    let _e3921 = phi_6564_;
                                    if (_e3897 > _e3921) {
                                        phi_6569_ = _e3897;
                                    } else {
                                        phi_6569_ = _e3921;
                                    }
                                    let _e3924 = phi_6569_;
                                    let _e3926 = local_1.member_3;
                                    let _e3927 = (_e3924 + _e3926);
                                    let _e3930 = local_1.member_1[0u];
                                    if (_e3930[0] < 0f) {
                                        phi_6586_ = -(_e3930[0]);
                                    } else {
                                        phi_6586_ = _e3930[0];
                                    }
                                    let _e3937 = phi_6586_;
                                    if (_e3930[1] < 0f) {
                                        phi_6593_ = -(_e3930[1]);
                                    } else {
                                        phi_6593_ = _e3930[1];
                                    }
                                    let _e3941 = phi_6593_;
                                    if (_e3937 > _e3941) {
                                        phi_6598_ = _e3937;
                                    } else {
                                        phi_6598_ = _e3941;
                                    }
                                    let _e3944 = phi_6598_;
                                    if (_e3930[2] < 0f) {
                                        phi_6605_ = -(_e3930[2]);
                                    } else {
                                        phi_6605_ = _e3930[2];
                                    }
                                    let _e3948 = phi_6605_;
                                    if (_e3944 > _e3948) {
                                        phi_6610_ = _e3944;
                                    } else {
                                        phi_6610_ = _e3948;
                                    }
                                    let _e3951 = phi_6610_;
                                    let _e3954 = local_1.member_1[1u];
                                    if (_e3954[0] < 0f) {
                                        phi_6624_ = -(_e3954[0]);
                                    } else {
                                        phi_6624_ = _e3954[0];
                                    }
                                    let _e3961 = phi_6624_;
                                    if (_e3954[1] < 0f) {
                                        phi_6631_ = -(_e3954[1]);
                                    } else {
                                        phi_6631_ = _e3954[1];
                                    }
                                    let _e3965 = phi_6631_;
                                    if (_e3961 > _e3965) {
                                        phi_6636_ = _e3961;
                                    } else {
                                        phi_6636_ = _e3965;
                                    }
                                    let _e3968 = phi_6636_;
                                    if (_e3954[2] < 0f) {
                                        phi_6643_ = -(_e3954[2]);
                                    } else {
                                        phi_6643_ = _e3954[2];
                                    }
                                    let _e3972 = phi_6643_;
                                    if (_e3968 > _e3972) {
                                        phi_6648_ = _e3968;
                                    } else {
                                        phi_6648_ = _e3972;
                                    }
                                    let _e3975 = phi_6648_;
                                    if (_e3951 > _e3975) {
                                        phi_6653_ = _e3951;
                                    } else {
                                        phi_6653_ = _e3975;
                                    }
                                    let _e3978 = phi_6653_;
                                    let _e3980 = local_1.member_3;
                                    let _e3981 = (_e3978 + _e3980);
                                    let _e3984 = local_1.member_2[0u];
                                    if (_e3984[0] < 0f) {
                                        phi_6670_ = -(_e3984[0]);
                                    } else {
                                        phi_6670_ = _e3984[0];
                                    }
                                    let _e3991 = phi_6670_;
                                    if (_e3984[1] < 0f) {
                                        phi_6677_ = -(_e3984[1]);
                                    } else {
                                        phi_6677_ = _e3984[1];
                                    }
                                    let _e3995 = phi_6677_;
                                    if (_e3991 > _e3995) {
                                        phi_6682_ = _e3991;
                                    } else {
                                        phi_6682_ = _e3995;
                                    }
                                    let _e3998 = phi_6682_;
                                    if (_e3984[2] < 0f) {
                                        phi_6689_ = -(_e3984[2]);
                                    } else {
                                        phi_6689_ = _e3984[2];
                                    }
                                    let _e4002 = phi_6689_;
                                    if (_e3998 > _e4002) {
                                        phi_6694_ = _e3998;
                                    } else {
                                        phi_6694_ = _e4002;
                                    }
                                    let _e4005 = phi_6694_;
                                    let _e4008 = local_1.member_2[1u];
                                    if (_e4008[0] < 0f) {
                                        phi_6708_ = -(_e4008[0]);
                                    } else {
                                        phi_6708_ = _e4008[0];
                                    }
                                    let _e4015 = phi_6708_;
                                    if (_e4008[1] < 0f) {
                                        phi_6715_ = -(_e4008[1]);
                                    } else {
                                        phi_6715_ = _e4008[1];
                                    }
                                    let _e4019 = phi_6715_;
                                    if (_e4015 > _e4019) {
                                        phi_6720_ = _e4015;
                                    } else {
                                        phi_6720_ = _e4019;
                                    }
                                    let _e4022 = phi_6720_;
                                    if (_e4008[2] < 0f) {
                                        phi_6727_ = -(_e4008[2]);
                                    } else {
                                        phi_6727_ = _e4008[2];
                                    }
                                    let _e4026 = phi_6727_;
                                    if (_e4022 > _e4026) {
                                        phi_6732_ = _e4022;
                                    } else {
                                        phi_6732_ = _e4026;
                                    }
                                    let _e4029 = phi_6732_;
                                    if (_e4005 > _e4029) {
                                        phi_6737_ = _e4005;
                                    } else {
                                        phi_6737_ = _e4029;
                                    }
                                    let _e4032 = phi_6737_;
                                    let _e4034 = local_1.member_3;
                                    let _e4035 = (_e4032 + _e4034);
                                    let _e4037 = ((_e3981 * 8f) * _e4035);
                                    let _e4044 = local_1.member_3;
                                    if (_e3733 < 0f) {
                                        phi_6768_ = -(_e3733);
                                    } else {
                                        phi_6768_ = _e3733;
                                    }
                                    let _e4061 = phi_6768_;
                                    if (_e3736 < 0f) {
                                        phi_6774_ = -(_e3736);
                                    } else {
                                        phi_6774_ = _e3736;
                                    }
                                    let _e4065 = phi_6774_;
                                    if (_e3739 < 0f) {
                                        phi_6781_ = -(_e3739);
                                    } else {
                                        phi_6781_ = _e3739;
                                    }
                                    let _e4070 = phi_6781_;
                                    let _e4071 = ((_e4061 + _e4065) + _e4070);
                                    if (_e3754 < 0f) {
                                        phi_6788_ = -(_e3754);
                                    } else {
                                        phi_6788_ = _e3754;
                                    }
                                    let _e4075 = phi_6788_;
                                    if (_e3757 < 0f) {
                                        phi_6794_ = -(_e3757);
                                    } else {
                                        phi_6794_ = _e3757;
                                    }
                                    let _e4079 = phi_6794_;
                                    if (_e3760 < 0f) {
                                        phi_6801_ = -(_e3760);
                                    } else {
                                        phi_6801_ = _e3760;
                                    }
                                    let _e4084 = phi_6801_;
                                    let _e4085 = ((_e4075 + _e4079) + _e4084);
                                    if (_e4071 > _e4085) {
                                        phi_6807_ = _e4071;
                                    } else {
                                        phi_6807_ = _e4085;
                                    }
                                    let _e4088 = phi_6807_;
                                    if (_e3803 < 0f) {
                                        phi_6813_ = -(_e3803);
                                    } else {
                                        phi_6813_ = _e3803;
                                    }
                                    let _e4092 = phi_6813_;
                                    if (_e3804 < 0f) {
                                        phi_6819_ = -(_e3804);
                                    } else {
                                        phi_6819_ = _e3804;
                                    }
                                    let _e4096 = phi_6819_;
                                    if (_e3805 < 0f) {
                                        phi_6826_ = -(_e3805);
                                    } else {
                                        phi_6826_ = _e3805;
                                    }
                                    let _e4101 = phi_6826_;
                                    let _e4103 = (((_e4092 + _e4096) + _e4101) * 0.5f);
                                    if (_e4088 > _e4103) {
                                        phi_6833_ = _e4088;
                                    } else {
                                        phi_6833_ = _e4103;
                                    }
                                    let _e4106 = phi_6833_;
                                    let _e4111 = local_1.member_3;
                                    let _e4124 = ((((_e3808[0] * _e3733) + (_e3808[1] * _e3736)) + (_e3808[2] * _e3739)) * 3f);
                                    let _e4125 = ((((_e3865[0] * _e3754) + (_e3865[1] * _e3757)) + (_e3865[2] * _e3760)) * 3f);
                                    if (_e4124 < _e4125) {
                                        phi_6857_ = _e4124;
                                    } else {
                                        phi_6857_ = _e4125;
                                    }
                                    let _e4128 = phi_6857_;
                                    if (_e3839 < _e3862) {
                                        phi_6862_ = _e3839;
                                    } else {
                                        phi_6862_ = _e3862;
                                    }
                                    let _e4131 = phi_6862_;
                                    if (_e4128 < _e4131) {
                                        phi_6867_ = _e4128;
                                    } else {
                                        phi_6867_ = _e4131;
                                    }
                                    let _e4134 = phi_6867_;
                                    if (_e4124 > _e4125) {
                                        phi_6872_ = _e4124;
                                    } else {
                                        phi_6872_ = _e4125;
                                    }
                                    let _e4137 = phi_6872_;
                                    if (_e3839 > _e3862) {
                                        phi_6877_ = _e3839;
                                    } else {
                                        phi_6877_ = _e3862;
                                    }
                                    let _e4140 = phi_6877_;
                                    if (_e4137 > _e4140) {
                                        phi_6882_ = _e4137;
                                    } else {
                                        phi_6882_ = _e4140;
                                    }
                                    let _e4143 = phi_6882_;
                                    let _e4148 = -(_e4143);
                                    if (_e4134 > _e4148) {
                                        phi_6892_ = _e4134;
                                    } else {
                                        phi_6892_ = _e4148;
                                    }
                                    let _e4151 = phi_6892_;
                                    let _e4153 = ((_e4151 - ((((((_e3927 * 8f) * _e4037) * (0.000000059604645f * (524f / 64f))) + ((_e4044 * 19f) * ((_e3927 * (_e3981 + _e4035)) + (_e3981 * _e4035)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3927) * ((1f + _e3981) * (1f + _e4035))))) + ((_e1429 * (((_e4106 + (_e4037 * (0.000000059604645f * 8f))) + ((_e4111 * 6f) * (_e3981 + _e4035))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3981) * (1f + _e4035))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4153 {
                                        phi_7861_ = _e4153;
                                    } else {
                                        let _e4156 = local_1.member_1[0u];
                                        let _e4162 = local_1.member_1[1u];
                                        let _e4166 = (_e4156[0] + _e4162[0]);
                                        let _e4167 = (_e4156[1] + _e4162[1]);
                                        let _e4168 = (_e4156[2] + _e4162[2]);
                                        let _e4171 = local_1.member_2[0u];
                                        let _e4177 = local_1.member_2[1u];
                                        let _e4181 = (_e4171[0] + _e4177[0]);
                                        let _e4182 = (_e4171[1] + _e4177[1]);
                                        let _e4183 = (_e4171[2] + _e4177[2]);
                                        let _e4186 = ((_e4167 * _e4183) - (_e4168 * _e4182));
                                        let _e4189 = ((_e4168 * _e4181) - (_e4166 * _e4183));
                                        let _e4192 = ((_e4166 * _e4182) - (_e4167 * _e4181));
                                        let _e4195 = local_1.member[0u];
                                        let _e4201 = local_1.member_1[0u];
                                        let _e4207 = local_1.member_2[0u];
                                        let _e4211 = (_e4195[0] - _e4201[0]);
                                        let _e4212 = (_e4195[1] - _e4201[1]);
                                        let _e4213 = (_e4195[2] - _e4201[2]);
                                        let _e4214 = (_e4195[0] - _e4207[0]);
                                        let _e4215 = (_e4195[1] - _e4207[1]);
                                        let _e4216 = (_e4195[2] - _e4207[2]);
                                        let _e4219 = local_1.member[1u];
                                        let _e4225 = local_1.member_1[1u];
                                        let _e4231 = local_1.member_2[1u];
                                        let _e4235 = (_e4219[0] - _e4225[0]);
                                        let _e4236 = (_e4219[1] - _e4225[1]);
                                        let _e4237 = (_e4219[2] - _e4225[2]);
                                        let _e4238 = (_e4219[0] - _e4231[0]);
                                        let _e4239 = (_e4219[1] - _e4231[1]);
                                        let _e4240 = (_e4219[2] - _e4231[2]);
                                        let _e4243 = local_1.member[0u];
                                        if (_e4243[0] < 0f) {
                                            phi_7095_ = -(_e4243[0]);
                                        } else {
                                            phi_7095_ = _e4243[0];
                                        }
                                        let _e4250 = phi_7095_;
                                        if (_e4243[1] < 0f) {
                                            phi_7102_ = -(_e4243[1]);
                                        } else {
                                            phi_7102_ = _e4243[1];
                                        }
                                        let _e4254 = phi_7102_;
                                        if (_e4250 > _e4254) {
                                            phi_7107_ = _e4250;
                                        } else {
                                            phi_7107_ = _e4254;
                                        }
                                        let _e4257 = phi_7107_;
                                        if (_e4243[2] < 0f) {
                                            phi_7114_ = -(_e4243[2]);
                                        } else {
                                            phi_7114_ = _e4243[2];
                                        }
                                        let _e4261 = phi_7114_;
                                        if (_e4257 > _e4261) {
                                            phi_7119_ = _e4257;
                                        } else {
                                            phi_7119_ = _e4261;
                                        }
                                        let _e4264 = phi_7119_;
                                        let _e4267 = local_1.member[1u];
                                        if (_e4267[0] < 0f) {
                                            phi_7132_ = -(_e4267[0]);
                                        } else {
                                            phi_7132_ = _e4267[0];
                                        }
                                        let _e4274 = phi_7132_;
                                        if (_e4267[1] < 0f) {
                                            phi_7139_ = -(_e4267[1]);
                                        } else {
                                            phi_7139_ = _e4267[1];
                                        }
                                        let _e4278 = phi_7139_;
                                        if (_e4274 > _e4278) {
                                            phi_7144_ = _e4274;
                                        } else {
                                            phi_7144_ = _e4278;
                                        }
                                        let _e4281 = phi_7144_;
                                        if (_e4267[2] < 0f) {
                                            phi_7151_ = -(_e4267[2]);
                                        } else {
                                            phi_7151_ = _e4267[2];
                                        }
                                        let _e4285 = phi_7151_;
                                        if (_e4281 > _e4285) {
                                            phi_7156_ = _e4281;
                                        } else {
                                            phi_7156_ = _e4285;
                                        }
                                        let _e4288 = phi_7156_;
                                        if (_e4264 > _e4288) {
                                            phi_7161_ = _e4264;
                                        } else {
                                            phi_7161_ = _e4288;
                                        }
                                        let _e4291 = phi_7161_;
                                        let _e4293 = local_1.member_3;
                                        let _e4297 = local_1.member_1[0u];
                                        if (_e4297[0] < 0f) {
                                            phi_7178_ = -(_e4297[0]);
                                        } else {
                                            phi_7178_ = _e4297[0];
                                        }
                                        let _e4304 = phi_7178_;
                                        if (_e4297[1] < 0f) {
                                            phi_7185_ = -(_e4297[1]);
                                        } else {
                                            phi_7185_ = _e4297[1];
                                        }
                                        let _e4308 = phi_7185_;
                                        if (_e4304 > _e4308) {
                                            phi_7190_ = _e4304;
                                        } else {
                                            phi_7190_ = _e4308;
                                        }
                                        let _e4311 = phi_7190_;
                                        if (_e4297[2] < 0f) {
                                            phi_7197_ = -(_e4297[2]);
                                        } else {
                                            phi_7197_ = _e4297[2];
                                        }
                                        let _e4315 = phi_7197_;
                                        if (_e4311 > _e4315) {
                                            phi_7202_ = _e4311;
                                        } else {
                                            phi_7202_ = _e4315;
                                        }
                                        let _e4318 = phi_7202_;
                                        let _e4321 = local_1.member_1[1u];
                                        if (_e4321[0] < 0f) {
                                            phi_7216_ = -(_e4321[0]);
                                        } else {
                                            phi_7216_ = _e4321[0];
                                        }
                                        let _e4328 = phi_7216_;
                                        if (_e4321[1] < 0f) {
                                            phi_7223_ = -(_e4321[1]);
                                        } else {
                                            phi_7223_ = _e4321[1];
                                        }
                                        let _e4332 = phi_7223_;
                                        if (_e4328 > _e4332) {
                                            phi_7228_ = _e4328;
                                        } else {
                                            phi_7228_ = _e4332;
                                        }
                                        let _e4335 = phi_7228_;
                                        if (_e4321[2] < 0f) {
                                            phi_7235_ = -(_e4321[2]);
                                        } else {
                                            phi_7235_ = _e4321[2];
                                        }
                                        let _e4339 = phi_7235_;
                                        if (_e4335 > _e4339) {
                                            phi_7240_ = _e4335;
                                        } else {
                                            phi_7240_ = _e4339;
                                        }
                                        let _e4342 = phi_7240_;
                                        if (_e4318 > _e4342) {
                                            phi_7245_ = _e4318;
                                        } else {
                                            phi_7245_ = _e4342;
                                        }
                                        let _e4345 = phi_7245_;
                                        let _e4347 = local_1.member_3;
                                        let _e4351 = local_1.member_2[0u];
                                        if (_e4351[0] < 0f) {
                                            phi_7262_ = -(_e4351[0]);
                                        } else {
                                            phi_7262_ = _e4351[0];
                                        }
                                        let _e4358 = phi_7262_;
                                        if (_e4351[1] < 0f) {
                                            phi_7269_ = -(_e4351[1]);
                                        } else {
                                            phi_7269_ = _e4351[1];
                                        }
                                        let _e4362 = phi_7269_;
                                        if (_e4358 > _e4362) {
                                            phi_7274_ = _e4358;
                                        } else {
                                            phi_7274_ = _e4362;
                                        }
                                        let _e4365 = phi_7274_;
                                        if (_e4351[2] < 0f) {
                                            phi_7281_ = -(_e4351[2]);
                                        } else {
                                            phi_7281_ = _e4351[2];
                                        }
                                        let _e4369 = phi_7281_;
                                        if (_e4365 > _e4369) {
                                            phi_7286_ = _e4365;
                                        } else {
                                            phi_7286_ = _e4369;
                                        }
                                        let _e4372 = phi_7286_;
                                        let _e4375 = local_1.member_2[1u];
                                        if (_e4375[0] < 0f) {
                                            phi_7300_ = -(_e4375[0]);
                                        } else {
                                            phi_7300_ = _e4375[0];
                                        }
                                        let _e4382 = phi_7300_;
                                        if (_e4375[1] < 0f) {
                                            phi_7307_ = -(_e4375[1]);
                                        } else {
                                            phi_7307_ = _e4375[1];
                                        }
                                        let _e4386 = phi_7307_;
                                        if (_e4382 > _e4386) {
                                            phi_7312_ = _e4382;
                                        } else {
                                            phi_7312_ = _e4386;
                                        }
                                        let _e4389 = phi_7312_;
                                        if (_e4375[2] < 0f) {
                                            phi_7319_ = -(_e4375[2]);
                                        } else {
                                            phi_7319_ = _e4375[2];
                                        }
                                        let _e4393 = phi_7319_;
                                        if (_e4389 > _e4393) {
                                            phi_7324_ = _e4389;
                                        } else {
                                            phi_7324_ = _e4393;
                                        }
                                        let _e4396 = phi_7324_;
                                        if (_e4372 > _e4396) {
                                            phi_7329_ = _e4372;
                                        } else {
                                            phi_7329_ = _e4396;
                                        }
                                        let _e4399 = phi_7329_;
                                        let _e4401 = local_1.member_3;
                                        let _e4405 = ((((_e4291 + _e4293) + (_e4345 + _e4347)) + (_e4399 + _e4401)) * 2f);
                                        let _e4408 = local_1.member_3;
                                        let _e4412 = (((_e1429 * 1.0001f) + (_e4408 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4415 = ((_e4189 * _e4168) - (_e4192 * _e4167));
                                        let _e4418 = ((_e4192 * _e4166) - (_e4186 * _e4168));
                                        let _e4421 = ((_e4186 * _e4167) - (_e4189 * _e4166));
                                        let _e4426 = (((_e4415 * _e4195[0]) + (_e4418 * _e4195[1])) + (_e4421 * _e4195[2]));
                                        let _e4431 = (((_e4415 * _e4211) + (_e4418 * _e4212)) + (_e4421 * _e4213));
                                        let _e4436 = (((_e4415 * _e4214) + (_e4418 * _e4215)) + (_e4421 * _e4216));
                                        let _e4441 = (((_e4415 * _e4195[0]) + (_e4418 * _e4195[1])) + (_e4421 * _e4195[2]));
                                        let _e4446 = (((_e4415 * _e4219[0]) + (_e4418 * _e4219[1])) + (_e4421 * _e4219[2]));
                                        let _e4451 = (((_e4415 * _e4235) + (_e4418 * _e4236)) + (_e4421 * _e4237));
                                        let _e4456 = (((_e4415 * _e4238) + (_e4418 * _e4239)) + (_e4421 * _e4240));
                                        let _e4461 = (((_e4415 * _e4219[0]) + (_e4418 * _e4219[1])) + (_e4421 * _e4219[2]));
                                        if (_e4426 < _e4431) {
                                            phi_7408_ = _e4426;
                                        } else {
                                            phi_7408_ = _e4431;
                                        }
                                        let _e4464 = phi_7408_;
                                        if (_e4436 < _e4441) {
                                            phi_7413_ = _e4436;
                                        } else {
                                            phi_7413_ = _e4441;
                                        }
                                        let _e4467 = phi_7413_;
                                        if (_e4464 < _e4467) {
                                            phi_7418_ = _e4464;
                                        } else {
                                            phi_7418_ = _e4467;
                                        }
                                        let _e4470 = phi_7418_;
                                        if (_e4446 < _e4451) {
                                            phi_7423_ = _e4446;
                                        } else {
                                            phi_7423_ = _e4451;
                                        }
                                        let _e4473 = phi_7423_;
                                        if (_e4456 < _e4461) {
                                            phi_7428_ = _e4456;
                                        } else {
                                            phi_7428_ = _e4461;
                                        }
                                        let _e4476 = phi_7428_;
                                        if (_e4473 < _e4476) {
                                            phi_7433_ = _e4473;
                                        } else {
                                            phi_7433_ = _e4476;
                                        }
                                        let _e4479 = phi_7433_;
                                        if (_e4470 < _e4479) {
                                            phi_7438_ = _e4470;
                                        } else {
                                            phi_7438_ = _e4479;
                                        }
                                        let _e4482 = phi_7438_;
                                        if (_e4426 > _e4431) {
                                            phi_7443_ = _e4426;
                                        } else {
                                            phi_7443_ = _e4431;
                                        }
                                        let _e4485 = phi_7443_;
                                        if (_e4436 > _e4441) {
                                            phi_7448_ = _e4436;
                                        } else {
                                            phi_7448_ = _e4441;
                                        }
                                        let _e4488 = phi_7448_;
                                        if (_e4485 > _e4488) {
                                            phi_7453_ = _e4485;
                                        } else {
                                            phi_7453_ = _e4488;
                                        }
                                        let _e4491 = phi_7453_;
                                        if (_e4446 > _e4451) {
                                            phi_7458_ = _e4446;
                                        } else {
                                            phi_7458_ = _e4451;
                                        }
                                        let _e4494 = phi_7458_;
                                        if (_e4456 > _e4461) {
                                            phi_7463_ = _e4456;
                                        } else {
                                            phi_7463_ = _e4461;
                                        }
                                        let _e4497 = phi_7463_;
                                        if (_e4494 > _e4497) {
                                            phi_7468_ = _e4494;
                                        } else {
                                            phi_7468_ = _e4497;
                                        }
                                        let _e4500 = phi_7468_;
                                        if (_e4491 > _e4500) {
                                            phi_7473_ = _e4491;
                                        } else {
                                            phi_7473_ = _e4500;
                                        }
                                        let _e4503 = phi_7473_;
                                        if (_e4415 < 0f) {
                                            phi_7479_ = -(_e4415);
                                        } else {
                                            phi_7479_ = _e4415;
                                        }
                                        let _e4507 = phi_7479_;
                                        if (_e4418 < 0f) {
                                            phi_7485_ = -(_e4418);
                                        } else {
                                            phi_7485_ = _e4418;
                                        }
                                        let _e4511 = phi_7485_;
                                        if (_e4421 < 0f) {
                                            phi_7492_ = -(_e4421);
                                        } else {
                                            phi_7492_ = _e4421;
                                        }
                                        let _e4516 = phi_7492_;
                                        let _e4517 = ((_e4507 + _e4511) + _e4516);
                                        let _e4522 = -(_e4503);
                                        if (_e4482 > _e4522) {
                                            phi_7503_ = _e4482;
                                        } else {
                                            phi_7503_ = _e4522;
                                        }
                                        let _e4525 = phi_7503_;
                                        let _e4530 = (((_e4525 - ((_e4517 * _e4405) * (0.000000059604645f * (17f / 2f)))) - (_e4517 * _e4412)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4533 = ((_e4189 * _e4183) - (_e4192 * _e4182));
                                        let _e4536 = ((_e4192 * _e4181) - (_e4186 * _e4183));
                                        let _e4539 = ((_e4186 * _e4182) - (_e4189 * _e4181));
                                        let _e4544 = (((_e4533 * _e4195[0]) + (_e4536 * _e4195[1])) + (_e4539 * _e4195[2]));
                                        let _e4549 = (((_e4533 * _e4211) + (_e4536 * _e4212)) + (_e4539 * _e4213));
                                        let _e4554 = (((_e4533 * _e4214) + (_e4536 * _e4215)) + (_e4539 * _e4216));
                                        let _e4559 = (((_e4533 * _e4195[0]) + (_e4536 * _e4195[1])) + (_e4539 * _e4195[2]));
                                        let _e4564 = (((_e4533 * _e4219[0]) + (_e4536 * _e4219[1])) + (_e4539 * _e4219[2]));
                                        let _e4569 = (((_e4533 * _e4235) + (_e4536 * _e4236)) + (_e4539 * _e4237));
                                        let _e4574 = (((_e4533 * _e4238) + (_e4536 * _e4239)) + (_e4539 * _e4240));
                                        let _e4579 = (((_e4533 * _e4219[0]) + (_e4536 * _e4219[1])) + (_e4539 * _e4219[2]));
                                        if (_e4544 < _e4549) {
                                            phi_7574_ = _e4544;
                                        } else {
                                            phi_7574_ = _e4549;
                                        }
                                        let _e4582 = phi_7574_;
                                        if (_e4554 < _e4559) {
                                            phi_7579_ = _e4554;
                                        } else {
                                            phi_7579_ = _e4559;
                                        }
                                        let _e4585 = phi_7579_;
                                        if (_e4582 < _e4585) {
                                            phi_7584_ = _e4582;
                                        } else {
                                            phi_7584_ = _e4585;
                                        }
                                        let _e4588 = phi_7584_;
                                        if (_e4564 < _e4569) {
                                            phi_7589_ = _e4564;
                                        } else {
                                            phi_7589_ = _e4569;
                                        }
                                        let _e4591 = phi_7589_;
                                        if (_e4574 < _e4579) {
                                            phi_7594_ = _e4574;
                                        } else {
                                            phi_7594_ = _e4579;
                                        }
                                        let _e4594 = phi_7594_;
                                        if (_e4591 < _e4594) {
                                            phi_7599_ = _e4591;
                                        } else {
                                            phi_7599_ = _e4594;
                                        }
                                        let _e4597 = phi_7599_;
                                        if (_e4588 < _e4597) {
                                            phi_7604_ = _e4588;
                                        } else {
                                            phi_7604_ = _e4597;
                                        }
                                        let _e4600 = phi_7604_;
                                        if (_e4544 > _e4549) {
                                            phi_7609_ = _e4544;
                                        } else {
                                            phi_7609_ = _e4549;
                                        }
                                        let _e4603 = phi_7609_;
                                        if (_e4554 > _e4559) {
                                            phi_7614_ = _e4554;
                                        } else {
                                            phi_7614_ = _e4559;
                                        }
                                        let _e4606 = phi_7614_;
                                        if (_e4603 > _e4606) {
                                            phi_7619_ = _e4603;
                                        } else {
                                            phi_7619_ = _e4606;
                                        }
                                        let _e4609 = phi_7619_;
                                        if (_e4564 > _e4569) {
                                            phi_7624_ = _e4564;
                                        } else {
                                            phi_7624_ = _e4569;
                                        }
                                        let _e4612 = phi_7624_;
                                        if (_e4574 > _e4579) {
                                            phi_7629_ = _e4574;
                                        } else {
                                            phi_7629_ = _e4579;
                                        }
                                        let _e4615 = phi_7629_;
                                        if (_e4612 > _e4615) {
                                            phi_7634_ = _e4612;
                                        } else {
                                            phi_7634_ = _e4615;
                                        }
                                        let _e4618 = phi_7634_;
                                        if (_e4609 > _e4618) {
                                            phi_7639_ = _e4609;
                                        } else {
                                            phi_7639_ = _e4618;
                                        }
                                        let _e4621 = phi_7639_;
                                        if (_e4533 < 0f) {
                                            phi_7645_ = -(_e4533);
                                        } else {
                                            phi_7645_ = _e4533;
                                        }
                                        let _e4625 = phi_7645_;
                                        if (_e4536 < 0f) {
                                            phi_7651_ = -(_e4536);
                                        } else {
                                            phi_7651_ = _e4536;
                                        }
                                        let _e4629 = phi_7651_;
                                        if (_e4539 < 0f) {
                                            phi_7658_ = -(_e4539);
                                        } else {
                                            phi_7658_ = _e4539;
                                        }
                                        let _e4634 = phi_7658_;
                                        let _e4635 = ((_e4625 + _e4629) + _e4634);
                                        let _e4640 = -(_e4621);
                                        if (_e4600 > _e4640) {
                                            phi_7669_ = _e4600;
                                        } else {
                                            phi_7669_ = _e4640;
                                        }
                                        let _e4643 = phi_7669_;
                                        let _e4648 = (((_e4643 - ((_e4635 * _e4405) * (0.000000059604645f * (17f / 2f)))) - (_e4635 * _e4412)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4530 > _e4648) {
                                            phi_7679_ = _e4530;
                                        } else {
                                            phi_7679_ = _e4648;
                                        }
                                        let _e4651 = phi_7679_;
                                        let _e4652 = (_e4181 - _e4166);
                                        let _e4653 = (_e4182 - _e4167);
                                        let _e4654 = (_e4183 - _e4168);
                                        let _e4657 = ((_e4189 * _e4654) - (_e4192 * _e4653));
                                        let _e4660 = ((_e4192 * _e4652) - (_e4186 * _e4654));
                                        let _e4663 = ((_e4186 * _e4653) - (_e4189 * _e4652));
                                        let _e4668 = (((_e4657 * _e4195[0]) + (_e4660 * _e4195[1])) + (_e4663 * _e4195[2]));
                                        let _e4673 = (((_e4657 * _e4211) + (_e4660 * _e4212)) + (_e4663 * _e4213));
                                        let _e4678 = (((_e4657 * _e4214) + (_e4660 * _e4215)) + (_e4663 * _e4216));
                                        let _e4683 = (((_e4657 * _e4195[0]) + (_e4660 * _e4195[1])) + (_e4663 * _e4195[2]));
                                        let _e4688 = (((_e4657 * _e4219[0]) + (_e4660 * _e4219[1])) + (_e4663 * _e4219[2]));
                                        let _e4693 = (((_e4657 * _e4235) + (_e4660 * _e4236)) + (_e4663 * _e4237));
                                        let _e4698 = (((_e4657 * _e4238) + (_e4660 * _e4239)) + (_e4663 * _e4240));
                                        let _e4703 = (((_e4657 * _e4219[0]) + (_e4660 * _e4219[1])) + (_e4663 * _e4219[2]));
                                        if (_e4668 < _e4673) {
                                            phi_7752_ = _e4668;
                                        } else {
                                            phi_7752_ = _e4673;
                                        }
                                        let _e4706 = phi_7752_;
                                        if (_e4678 < _e4683) {
                                            phi_7757_ = _e4678;
                                        } else {
                                            phi_7757_ = _e4683;
                                        }
                                        let _e4709 = phi_7757_;
                                        if (_e4706 < _e4709) {
                                            phi_7762_ = _e4706;
                                        } else {
                                            phi_7762_ = _e4709;
                                        }
                                        let _e4712 = phi_7762_;
                                        if (_e4688 < _e4693) {
                                            phi_7767_ = _e4688;
                                        } else {
                                            phi_7767_ = _e4693;
                                        }
                                        let _e4715 = phi_7767_;
                                        if (_e4698 < _e4703) {
                                            phi_7772_ = _e4698;
                                        } else {
                                            phi_7772_ = _e4703;
                                        }
                                        let _e4718 = phi_7772_;
                                        if (_e4715 < _e4718) {
                                            phi_7777_ = _e4715;
                                        } else {
                                            phi_7777_ = _e4718;
                                        }
                                        let _e4721 = phi_7777_;
                                        if (_e4712 < _e4721) {
                                            phi_7782_ = _e4712;
                                        } else {
                                            phi_7782_ = _e4721;
                                        }
                                        let _e4724 = phi_7782_;
                                        if (_e4668 > _e4673) {
                                            phi_7787_ = _e4668;
                                        } else {
                                            phi_7787_ = _e4673;
                                        }
                                        let _e4727 = phi_7787_;
                                        if (_e4678 > _e4683) {
                                            phi_7792_ = _e4678;
                                        } else {
                                            phi_7792_ = _e4683;
                                        }
                                        let _e4730 = phi_7792_;
                                        if (_e4727 > _e4730) {
                                            phi_7797_ = _e4727;
                                        } else {
                                            phi_7797_ = _e4730;
                                        }
                                        let _e4733 = phi_7797_;
                                        if (_e4688 > _e4693) {
                                            phi_7802_ = _e4688;
                                        } else {
                                            phi_7802_ = _e4693;
                                        }
                                        let _e4736 = phi_7802_;
                                        if (_e4698 > _e4703) {
                                            phi_7807_ = _e4698;
                                        } else {
                                            phi_7807_ = _e4703;
                                        }
                                        let _e4739 = phi_7807_;
                                        if (_e4736 > _e4739) {
                                            phi_7812_ = _e4736;
                                        } else {
                                            phi_7812_ = _e4739;
                                        }
                                        let _e4742 = phi_7812_;
                                        if (_e4733 > _e4742) {
                                            phi_7817_ = _e4733;
                                        } else {
                                            phi_7817_ = _e4742;
                                        }
                                        let _e4745 = phi_7817_;
                                        if (_e4657 < 0f) {
                                            phi_7823_ = -(_e4657);
                                        } else {
                                            phi_7823_ = _e4657;
                                        }
                                        let _e4749 = phi_7823_;
                                        if (_e4660 < 0f) {
                                            phi_7829_ = -(_e4660);
                                        } else {
                                            phi_7829_ = _e4660;
                                        }
                                        let _e4753 = phi_7829_;
                                        if (_e4663 < 0f) {
                                            phi_7836_ = -(_e4663);
                                        } else {
                                            phi_7836_ = _e4663;
                                        }
                                        let _e4758 = phi_7836_;
                                        let _e4759 = ((_e4749 + _e4753) + _e4758);
                                        let _e4764 = -(_e4745);
                                        if (_e4724 > _e4764) {
                                            phi_7847_ = _e4724;
                                        } else {
                                            phi_7847_ = _e4764;
                                        }
                                        let _e4767 = phi_7847_;
                                        let _e4772 = (((_e4767 - ((_e4759 * _e4405) * (0.000000059604645f * (17f / 2f)))) - (_e4759 * _e4412)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4651 > _e4772) {
                                            phi_7857_ = _e4651;
                                        } else {
                                            phi_7857_ = _e4772;
                                        }
                                        let _e4775 = phi_7857_;
                                        phi_7861_ = (_e4153 || (_e4775 > 0f));
                                    }
                                    let _e4779 = phi_7861_;
                                    phi_7863_ = (_e3718 && _e4779);
                                } else {
                                    phi_7863_ = _e3718;
                                }
                                let _e4782 = phi_7863_;
                                phi_7865_ = (_e2567 || _e4782);
                            }
                            let _e4785 = phi_7865_;
                            if !(_e4785) {
                                let _e4788 = atomicAdd((&counters[5u]), 1u);
                                hits[_e980] = ((2147483648u | (_e4788 << bitcast<u32>(12i))) | _e983);
                            }
                        }
                        phi_7876_ = true;
                    }
                    let _e4795 = phi_7876_;
                    phi_7877_ = _e4795;
                } else {
                    phi_7877_ = false;
                }
                let _e4797 = phi_7877_;
                continue;
                continuing {
                    phi_1857_ = _e972;
                    break if !(_e4797);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4801 = atomicLoad((&counters[5u]));
                if (_e4801 > 0u) {
                    let _e4804 = atomicAdd((&output.member[0u]), _e4801);
                    if ((_e4804 + _e4801) < _e4804) {
                        let _e4808 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4804);
                }
            }
            workgroupBarrier();
            let _e4811 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4814 = atomicLoad((&counters[7u]));
                if (_e4814 > 0u) {
                    let _e4817 = atomicAdd((&output.member[1u]), _e4814);
                    if ((_e4817 + _e4814) < _e4817) {
                        let _e4821 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7927_ = type_13(0u, 16u);
            loop {
                let _e4823 = phi_7927_;
                if (_e4823.member < _e4823.member_1) {
                    phi_7928_ = type_13((_e4823.member + 1u), _e4823.member_1);
                    phi_7951_ = type_13(1u, _e4823.member);
                } else {
                    phi_7928_ = _e4823;
                    phi_7951_ = type_13(0u, type_13().member_1);
                }
                let _e4835 = phi_7928_;
                let _e4837 = phi_7951_;
                if (bitcast<i32>(_e4837.member) != 0i) {
                    let _e4843 = (_e67 + (_e4837.member_1 * 128u));
                    if (_e4843 >= _e958) {
                        phi_8048_ = false;
                    } else {
                        let _e4846 = hits[_e4843];
                        if ((_e4846 & 2147483648u) == 0u) {
                            phi_7974_ = 4294967295u;
                        } else {
                            phi_7974_ = ((_e4846 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4853 = phi_7974_;
                        if (_e4853 != 4294967295u) {
                            let _e4857 = ((_e4846 >> bitcast<u32>(10i)) & 3u);
                            let _e4864 = firsts[(2u * _e4857)];
                            let _e4867 = leaves.member[(_e4864 + ((_e4846 >> bitcast<u32>(5i)) & 31u))];
                            let _e4871 = firsts[((2u * _e4857) + 1u)];
                            let _e4874 = leaves.member[(_e4871 + (_e4846 & 31u))];
                            let _e4879 = params.member.member_1.member_3;
                            let _e4880 = (_e4811 + _e4853);
                            if (_e4880 < _e4879) {
                                let _e4882 = (2u * _e4880);
                                atomicStore((&output.member[(4u + _e4882)]), _e4867.member_1);
                                atomicStore((&output.member[(_e4882 + 5u)]), _e4874.member_1);
                            }
                        }
                        phi_8048_ = true;
                    }
                    let _e4888 = phi_8048_;
                    phi_8049_ = _e4888;
                } else {
                    phi_8049_ = false;
                }
                let _e4890 = phi_8049_;
                continue;
                continuing {
                    phi_7927_ = _e4835;
                    break if !(_e4890);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_437_ = _e153;
            break if !(_e159);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
