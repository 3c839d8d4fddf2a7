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
    var phi_922_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_928_: bool;
    var phi_946_: u32;
    var phi_947_: u32;
    var phi_948_: u32;
    var phi_834_: u32;
    var phi_951_: type_13;
    var phi_954_: u32;
    var phi_952_: type_13;
    var phi_977_: type_13;
    var phi_1097_: bool;
    var phi_1103_: bool;
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
    var phi_1802_: type_13;
    var phi_1845_: u32;
    var phi_1846_: bool;
    var phi_955_: u32;
    var phi_1847_: bool;
    var phi_1854_: u32;
    var phi_1857_: type_13;
    var phi_1858_: type_13;
    var phi_1881_: type_13;
    var phi_2009_: bool;
    var phi_2015_: bool;
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
    var phi_2708_: type_24;
    var phi_2709_: type_24;
    var phi_3098_: f32;
    var phi_3105_: f32;
    var phi_3110_: f32;
    var phi_3117_: f32;
    var phi_3122_: f32;
    var phi_3135_: f32;
    var phi_3142_: f32;
    var phi_3147_: f32;
    var phi_3154_: f32;
    var phi_3159_: f32;
    var phi_3164_: f32;
    var phi_3181_: f32;
    var phi_3188_: f32;
    var phi_3193_: f32;
    var phi_3200_: f32;
    var phi_3205_: f32;
    var phi_3219_: f32;
    var phi_3226_: f32;
    var phi_3231_: f32;
    var phi_3238_: f32;
    var phi_3243_: f32;
    var phi_3248_: f32;
    var phi_3265_: f32;
    var phi_3272_: f32;
    var phi_3277_: f32;
    var phi_3284_: f32;
    var phi_3289_: f32;
    var phi_3303_: f32;
    var phi_3310_: f32;
    var phi_3315_: f32;
    var phi_3322_: f32;
    var phi_3327_: f32;
    var phi_3332_: f32;
    var phi_3363_: f32;
    var phi_3369_: f32;
    var phi_3376_: f32;
    var phi_3383_: f32;
    var phi_3389_: f32;
    var phi_3396_: f32;
    var phi_3402_: f32;
    var phi_3408_: f32;
    var phi_3414_: f32;
    var phi_3421_: f32;
    var phi_3428_: f32;
    var phi_3452_: f32;
    var phi_3457_: f32;
    var phi_3462_: f32;
    var phi_3467_: f32;
    var phi_3472_: f32;
    var phi_3477_: f32;
    var phi_3487_: f32;
    var phi_3690_: f32;
    var phi_3697_: f32;
    var phi_3702_: f32;
    var phi_3709_: f32;
    var phi_3714_: f32;
    var phi_3727_: f32;
    var phi_3734_: f32;
    var phi_3739_: f32;
    var phi_3746_: f32;
    var phi_3751_: f32;
    var phi_3756_: f32;
    var phi_3773_: f32;
    var phi_3780_: f32;
    var phi_3785_: f32;
    var phi_3792_: f32;
    var phi_3797_: f32;
    var phi_3811_: f32;
    var phi_3818_: f32;
    var phi_3823_: f32;
    var phi_3830_: f32;
    var phi_3835_: f32;
    var phi_3840_: f32;
    var phi_3857_: f32;
    var phi_3864_: f32;
    var phi_3869_: f32;
    var phi_3876_: f32;
    var phi_3881_: f32;
    var phi_3895_: f32;
    var phi_3902_: f32;
    var phi_3907_: f32;
    var phi_3914_: f32;
    var phi_3919_: f32;
    var phi_3924_: f32;
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
    var phi_4063_: f32;
    var phi_4068_: f32;
    var phi_4074_: f32;
    var phi_4080_: f32;
    var phi_4087_: f32;
    var phi_4098_: f32;
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
    var phi_4229_: f32;
    var phi_4234_: f32;
    var phi_4240_: f32;
    var phi_4246_: f32;
    var phi_4253_: f32;
    var phi_4264_: f32;
    var phi_4274_: f32;
    var phi_4456_: bool;
    var phi_4908_: f32;
    var phi_4915_: f32;
    var phi_4920_: f32;
    var phi_4927_: f32;
    var phi_4932_: f32;
    var phi_4945_: f32;
    var phi_4952_: f32;
    var phi_4957_: f32;
    var phi_4964_: f32;
    var phi_4969_: f32;
    var phi_4974_: f32;
    var phi_4991_: f32;
    var phi_4998_: f32;
    var phi_5003_: f32;
    var phi_5010_: f32;
    var phi_5015_: f32;
    var phi_5029_: f32;
    var phi_5036_: f32;
    var phi_5041_: f32;
    var phi_5048_: f32;
    var phi_5053_: f32;
    var phi_5058_: f32;
    var phi_5075_: f32;
    var phi_5082_: f32;
    var phi_5087_: f32;
    var phi_5094_: f32;
    var phi_5099_: f32;
    var phi_5113_: f32;
    var phi_5120_: f32;
    var phi_5125_: f32;
    var phi_5132_: f32;
    var phi_5137_: f32;
    var phi_5142_: f32;
    var phi_5173_: f32;
    var phi_5179_: f32;
    var phi_5186_: f32;
    var phi_5193_: f32;
    var phi_5199_: f32;
    var phi_5206_: f32;
    var phi_5212_: f32;
    var phi_5218_: f32;
    var phi_5224_: f32;
    var phi_5231_: f32;
    var phi_5238_: f32;
    var phi_5262_: f32;
    var phi_5267_: f32;
    var phi_5272_: f32;
    var phi_5277_: f32;
    var phi_5282_: f32;
    var phi_5287_: f32;
    var phi_5297_: f32;
    var phi_5500_: f32;
    var phi_5507_: f32;
    var phi_5512_: f32;
    var phi_5519_: f32;
    var phi_5524_: f32;
    var phi_5537_: f32;
    var phi_5544_: f32;
    var phi_5549_: f32;
    var phi_5556_: f32;
    var phi_5561_: f32;
    var phi_5566_: f32;
    var phi_5583_: f32;
    var phi_5590_: f32;
    var phi_5595_: f32;
    var phi_5602_: f32;
    var phi_5607_: f32;
    var phi_5621_: f32;
    var phi_5628_: f32;
    var phi_5633_: f32;
    var phi_5640_: f32;
    var phi_5645_: f32;
    var phi_5650_: f32;
    var phi_5667_: f32;
    var phi_5674_: f32;
    var phi_5679_: f32;
    var phi_5686_: f32;
    var phi_5691_: f32;
    var phi_5705_: f32;
    var phi_5712_: f32;
    var phi_5717_: f32;
    var phi_5724_: f32;
    var phi_5729_: f32;
    var phi_5734_: f32;
    var phi_5813_: f32;
    var phi_5818_: f32;
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
    var phi_5884_: f32;
    var phi_5890_: f32;
    var phi_5897_: f32;
    var phi_5908_: f32;
    var phi_5979_: f32;
    var phi_5984_: f32;
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
    var phi_6050_: f32;
    var phi_6056_: f32;
    var phi_6063_: f32;
    var phi_6074_: f32;
    var phi_6084_: f32;
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
    var phi_7416_: f32;
    var phi_7421_: f32;
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
    var phi_7487_: f32;
    var phi_7493_: f32;
    var phi_7500_: f32;
    var phi_7511_: f32;
    var phi_7582_: f32;
    var phi_7587_: f32;
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
    var phi_7653_: f32;
    var phi_7659_: f32;
    var phi_7666_: f32;
    var phi_7677_: f32;
    var phi_7687_: f32;
    var phi_7869_: bool;
    var phi_7871_: bool;
    var phi_7873_: bool;
    var phi_7884_: bool;
    var phi_7885_: bool;
    var phi_7935_: type_13;
    var phi_7936_: type_13;
    var phi_7959_: type_13;
    var phi_7982_: u32;
    var phi_8037_: type_13;
    var phi_8056_: bool;
    var phi_8057_: bool;
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
            let _e216 = params.member.member_2.member[0u][1u];
            let _e217 = (_e216 + (_e205 * 32u));
            let _e223 = params.member.member_2.member[0u][1u];
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
            let _e380 = (_e67 / 32u);
            let _e381 = (_e67 % 32u);
            let _e383 = atomicLoad((&counters[_e380]));
            phi_830_ = type_13(0u, _e383);
            phi_833_ = 0u;
            loop {
                let _e386 = phi_830_;
                let _e388 = phi_833_;
                local_3 = _e388;
                if (_e386.member < _e386.member_1) {
                    phi_831_ = type_13((_e386.member + 1u), _e386.member_1);
                    phi_856_ = type_13(1u, _e386.member);
                } else {
                    phi_831_ = _e386;
                    phi_856_ = type_13(0u, type_13().member_1);
                }
                let _e400 = phi_831_;
                let _e402 = phi_856_;
                let _e406 = (bitcast<i32>(_e402.member) != 0i);
                if _e406 {
                    let _e410 = names[((_e380 * 32u) + _e402.member_1)];
                    let _e414 = columns[((_e380 * 32u) + _e402.member_1)];
                    if ((((((_e378.member[0] <= _e414.member_1[0]) && (_e414.member[0] <= _e378.member_1[0])) && (_e378.member[1] <= _e414.member_1[1])) && (_e414.member[1] <= _e378.member_1[1])) && (_e378.member[2] <= _e414.member_1[2])) && (_e414.member[2] <= _e378.member_1[2])) {
                        if (_e205 == _e208) {
                            let _e446 = (_e381 < _e410);
                            if _e446 {
                                phi_922_ = bool();
                            } else {
                                phi_922_ = false;
                            }
                            let _e448 = phi_922_;
                            phi_923_ = _e448;
                            phi_924_ = _e446;
                        } else {
                            phi_923_ = bool();
                            phi_924_ = true;
                        }
                        let _e450 = phi_923_;
                        let _e452 = phi_924_;
                        if _e452 {
                            phi_928_ = true;
                        } else {
                            phi_928_ = _e450;
                        }
                        let _e454 = phi_928_;
                        if _e454 {
                            let _e456 = atomicAdd((&counters[4u]), 1u);
                            if (_e456 < 2048u) {
                                hits[_e456] = (((_e380 << bitcast<u32>(10i)) | (_e381 << bitcast<u32>(5i))) | _e410);
                                phi_946_ = _e388;
                            } else {
                                phi_946_ = (_e388 | (1u << bitcast<u32>((_e402.member_1 & 31u))));
                            }
                            let _e470 = phi_946_;
                            phi_947_ = _e470;
                        } else {
                            phi_947_ = _e388;
                        }
                        let _e472 = phi_947_;
                        phi_948_ = _e472;
                    } else {
                        phi_948_ = _e388;
                    }
                    let _e474 = phi_948_;
                    phi_834_ = _e474;
                } else {
                    phi_834_ = u32();
                }
                let _e476 = phi_834_;
                continue;
                continuing {
                    phi_830_ = _e400;
                    phi_833_ = _e476;
                    break if !(_e406);
                }
            }
            phi_951_ = type_13(0u, 32u);
            let _e4599 = local_3;
            phi_954_ = _e4599;
            loop {
                let _e479 = phi_951_;
                let _e481 = phi_954_;
                if (_e479.member < _e479.member_1) {
                    phi_952_ = type_13((_e479.member + 1u), _e479.member_1);
                    phi_977_ = type_13(1u, _e479.member);
                } else {
                    phi_952_ = _e479;
                    phi_977_ = type_13(0u, type_13().member_1);
                }
                let _e493 = phi_952_;
                let _e495 = phi_977_;
                if (bitcast<i32>(_e495.member) != 0i) {
                    if (_e481 == 0u) {
                        phi_1845_ = u32();
                        phi_1846_ = false;
                    } else {
                        let _e506 = names[((_e92 * 32u) + select(firstTrailingBit(_e481), 32u, (_e481 == 0u)))];
                        let _e509 = (_e217 + _e93);
                        let _e510 = (_e224 + _e506);
                        let _e512 = leaves.member[_e509];
                        let _e514 = leaves.member[_e510];
                        let _e516 = nodes.member[_e509];
                        let _e530 = nodes.member[_e510];
                        let _e545 = params.member.member.member_1;
                        if ((_e545 & 1u) != 0u) {
                            if (_e514.member[0] == _e512.member[0]) {
                                phi_1097_ = true;
                            } else {
                                phi_1097_ = (_e514.member[0] == _e512.member[1]);
                            }
                            let _e559 = phi_1097_;
                            if (_e514.member[1] == _e512.member[0]) {
                                phi_1103_ = true;
                            } else {
                                phi_1103_ = (_e514.member[1] == _e512.member[1]);
                            }
                            let _e563 = phi_1103_;
                            if (_e559 || _e563) {
                                phi_1109_ = false;
                            } else {
                                phi_1109_ = true;
                            }
                            let _e566 = phi_1109_;
                            phi_1110_ = _e566;
                        } else {
                            phi_1110_ = true;
                        }
                        let _e568 = phi_1110_;
                        if _e568 {
                            let _e570 = params.member.member.member_1;
                            if ((_e570 & 2u) != 0u) {
                                let _e574 = params.member.member.member_1;
                                let _e580 = bodies.member[_e512.member[0]];
                                let _e584 = bodies.member[_e514.member[0]];
                                if ((_e580 / 2u) != (_e584 / 2u)) {
                                    phi_1156_ = true;
                                } else {
                                    phi_1156_ = ((_e574 & 4u) != 0u);
                                }
                                let _e589 = phi_1156_;
                                if _e589 {
                                    phi_1163_ = (((_e580 & _e584) & 1u) == 0u);
                                } else {
                                    phi_1163_ = false;
                                }
                                let _e594 = phi_1163_;
                                phi_1167_ = _e594;
                            } else {
                                phi_1167_ = true;
                            }
                            let _e596 = phi_1167_;
                            if _e596 {
                                let _e598 = params.member.member.member_1;
                                if ((_e598 & 32u) != 0u) {
                                    let _e602 = params.member.member.member_6;
                                    let _e619 = (((((_e516.member_1.y - _e530.member.x) > _e602) && ((_e530.member_1.y - _e516.member.x) > _e602)) && (((_e516.member_2.x - _e530.member.y) > _e602) && ((_e530.member_2.x - _e516.member.y) > _e602))) && (((_e516.member_2.y - _e530.member_1.x) > _e602) && ((_e530.member_2.y - _e516.member_1.x) > _e602)));
                                    if _e619 {
                                        phi_1769_ = bool();
                                    } else {
                                        let _e623 = keys.member[_e512.member[0]];
                                        let _e628 = keys.member[_e512.member[1]];
                                        let _e630 = function_(_e623[0], _e628[0]);
                                        let _e634 = keys.member[_e512.member[2]];
                                        let _e636 = function_(_e630, _e634[0]);
                                        let _e640 = keys.member[_e514.member[0]];
                                        let _e645 = keys.member[_e514.member[1]];
                                        let _e647 = function_1(_e640[3], _e645[3]);
                                        let _e651 = keys.member[_e514.member[2]];
                                        let _e653 = function_1(_e647, _e651[3]);
                                        if (_e636[1] > _e653[1]) {
                                            phi_1292_ = true;
                                        } else {
                                            if (_e636[1] == _e653[1]) {
                                                phi_1291_ = (_e636[0] > _e653[0]);
                                            } else {
                                                phi_1291_ = false;
                                            }
                                            let _e664 = phi_1291_;
                                            phi_1292_ = _e664;
                                        }
                                        let _e666 = phi_1292_;
                                        let _e671 = keys.member[_e514.member[0]];
                                        let _e676 = keys.member[_e514.member[1]];
                                        let _e678 = function_(_e671[0], _e676[0]);
                                        let _e682 = keys.member[_e514.member[2]];
                                        let _e684 = function_(_e678, _e682[0]);
                                        let _e688 = keys.member[_e512.member[0]];
                                        let _e693 = keys.member[_e512.member[1]];
                                        let _e695 = function_1(_e688[3], _e693[3]);
                                        let _e699 = keys.member[_e512.member[2]];
                                        let _e701 = function_1(_e695, _e699[3]);
                                        if (_e684[1] > _e701[1]) {
                                            phi_1386_ = true;
                                        } else {
                                            if (_e684[1] == _e701[1]) {
                                                phi_1385_ = (_e684[0] > _e701[0]);
                                            } else {
                                                phi_1385_ = false;
                                            }
                                            let _e712 = phi_1385_;
                                            phi_1386_ = _e712;
                                        }
                                        let _e714 = phi_1386_;
                                        let _e720 = keys.member[_e512.member[0]];
                                        let _e725 = keys.member[_e512.member[1]];
                                        let _e727 = function_2(_e720[1], _e725[1]);
                                        let _e731 = keys.member[_e512.member[2]];
                                        let _e733 = function_2(_e727, _e731[1]);
                                        let _e737 = keys.member[_e514.member[0]];
                                        let _e742 = keys.member[_e514.member[1]];
                                        let _e744 = function_3(_e737[4], _e742[4]);
                                        let _e748 = keys.member[_e514.member[2]];
                                        let _e750 = function_3(_e744, _e748[4]);
                                        if (_e733[1] > _e750[1]) {
                                            phi_1481_ = true;
                                        } else {
                                            if (_e733[1] == _e750[1]) {
                                                phi_1480_ = (_e733[0] > _e750[0]);
                                            } else {
                                                phi_1480_ = false;
                                            }
                                            let _e761 = phi_1480_;
                                            phi_1481_ = _e761;
                                        }
                                        let _e763 = phi_1481_;
                                        let _e768 = keys.member[_e514.member[0]];
                                        let _e773 = keys.member[_e514.member[1]];
                                        let _e775 = function_2(_e768[1], _e773[1]);
                                        let _e779 = keys.member[_e514.member[2]];
                                        let _e781 = function_2(_e775, _e779[1]);
                                        let _e785 = keys.member[_e512.member[0]];
                                        let _e790 = keys.member[_e512.member[1]];
                                        let _e792 = function_3(_e785[4], _e790[4]);
                                        let _e796 = keys.member[_e512.member[2]];
                                        let _e798 = function_3(_e792, _e796[4]);
                                        if (_e781[1] > _e798[1]) {
                                            phi_1575_ = true;
                                        } else {
                                            if (_e781[1] == _e798[1]) {
                                                phi_1574_ = (_e781[0] > _e798[0]);
                                            } else {
                                                phi_1574_ = false;
                                            }
                                            let _e809 = phi_1574_;
                                            phi_1575_ = _e809;
                                        }
                                        let _e811 = phi_1575_;
                                        let _e818 = keys.member[_e512.member[0]];
                                        let _e823 = keys.member[_e512.member[1]];
                                        let _e825 = function_4(_e818[2], _e823[2]);
                                        let _e829 = keys.member[_e512.member[2]];
                                        let _e831 = function_4(_e825, _e829[2]);
                                        let _e835 = keys.member[_e514.member[0]];
                                        let _e840 = keys.member[_e514.member[1]];
                                        let _e842 = function_5(_e835[5], _e840[5]);
                                        let _e846 = keys.member[_e514.member[2]];
                                        let _e848 = function_5(_e842, _e846[5]);
                                        if (_e831[1] > _e848[1]) {
                                            phi_1671_ = true;
                                        } else {
                                            if (_e831[1] == _e848[1]) {
                                                phi_1670_ = (_e831[0] > _e848[0]);
                                            } else {
                                                phi_1670_ = false;
                                            }
                                            let _e859 = phi_1670_;
                                            phi_1671_ = _e859;
                                        }
                                        let _e861 = phi_1671_;
                                        let _e866 = keys.member[_e514.member[0]];
                                        let _e871 = keys.member[_e514.member[1]];
                                        let _e873 = function_4(_e866[2], _e871[2]);
                                        let _e877 = keys.member[_e514.member[2]];
                                        let _e879 = function_4(_e873, _e877[2]);
                                        let _e883 = keys.member[_e512.member[0]];
                                        let _e888 = keys.member[_e512.member[1]];
                                        let _e890 = function_5(_e883[5], _e888[5]);
                                        let _e894 = keys.member[_e512.member[2]];
                                        let _e896 = function_5(_e890, _e894[5]);
                                        if (_e879[1] > _e896[1]) {
                                            phi_1765_ = true;
                                        } else {
                                            if (_e879[1] == _e896[1]) {
                                                phi_1764_ = (_e879[0] > _e896[0]);
                                            } else {
                                                phi_1764_ = false;
                                            }
                                            let _e907 = phi_1764_;
                                            phi_1765_ = _e907;
                                        }
                                        let _e909 = phi_1765_;
                                        phi_1769_ = (((!(_e666) && !(_e714)) && (!(_e763) && !(_e811))) && (!(_e861) && !(_e909)));
                                    }
                                    let _e914 = phi_1769_;
                                    phi_1770_ = _e914;
                                    phi_1771_ = _e619;
                                } else {
                                    phi_1770_ = bool();
                                    phi_1771_ = true;
                                }
                                let _e916 = phi_1770_;
                                let _e918 = phi_1771_;
                                if _e918 {
                                    phi_1775_ = false;
                                } else {
                                    phi_1775_ = true;
                                }
                                let _e920 = phi_1775_;
                                phi_1776_ = _e916;
                                phi_1777_ = _e920;
                            } else {
                                phi_1776_ = false;
                                phi_1777_ = true;
                            }
                            let _e922 = phi_1776_;
                            let _e924 = phi_1777_;
                            phi_1778_ = _e922;
                            phi_1779_ = _e924;
                        } else {
                            phi_1778_ = false;
                            phi_1779_ = true;
                        }
                        let _e926 = phi_1778_;
                        let _e928 = phi_1779_;
                        if _e928 {
                            phi_1783_ = _e926;
                        } else {
                            phi_1783_ = true;
                        }
                        let _e930 = phi_1783_;
                        if _e930 {
                            let _e933 = params.member.member_1.member_3;
                            if (_e512.member_1 < _e514.member_1) {
                                phi_1802_ = type_13(_e512.member_1, _e514.member_1);
                            } else {
                                phi_1802_ = type_13(_e514.member_1, _e512.member_1);
                            }
                            let _e940 = phi_1802_;
                            let _e944 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e944 + 1u) < _e944) {
                                let _e948 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e944 < _e933) {
                                let _e950 = (2u * _e944);
                                atomicStore((&output.member[(4u + _e950)]), _e940.member);
                                atomicStore((&output.member[(_e950 + 5u)]), _e940.member_1);
                            }
                            let _e956 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e956 + 1u) < _e956) {
                                let _e960 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1845_ = (_e481 & (_e481 - 1u));
                        phi_1846_ = true;
                    }
                    let _e962 = phi_1845_;
                    let _e964 = phi_1846_;
                    phi_955_ = _e962;
                    phi_1847_ = _e964;
                } else {
                    phi_955_ = u32();
                    phi_1847_ = false;
                }
                let _e966 = phi_955_;
                let _e968 = phi_1847_;
                continue;
                continuing {
                    phi_951_ = _e493;
                    phi_954_ = _e966;
                    break if !(_e968);
                }
            }
            workgroupBarrier();
            let _e971 = atomicLoad((&counters[4u]));
            if (2048u < _e971) {
                phi_1854_ = 2048u;
            } else {
                phi_1854_ = _e971;
            }
            let _e974 = phi_1854_;
            phi_1857_ = type_13(0u, 16u);
            loop {
                let _e976 = phi_1857_;
                if (_e976.member < _e976.member_1) {
                    phi_1858_ = type_13((_e976.member + 1u), _e976.member_1);
                    phi_1881_ = type_13(1u, _e976.member);
                } else {
                    phi_1858_ = _e976;
                    phi_1881_ = type_13(0u, type_13().member_1);
                }
                let _e988 = phi_1858_;
                let _e990 = phi_1881_;
                if (bitcast<i32>(_e990.member) != 0i) {
                    let _e996 = (_e67 + (_e990.member_1 * 128u));
                    if (_e996 >= _e974) {
                        phi_7884_ = false;
                    } else {
                        let _e999 = hits[_e996];
                        let _e1002 = ((_e999 >> bitcast<u32>(10i)) & 3u);
                        let _e1009 = firsts[(2u * _e1002)];
                        let _e1010 = (_e1009 + ((_e999 >> bitcast<u32>(5i)) & 31u));
                        let _e1014 = firsts[((2u * _e1002) + 1u)];
                        let _e1015 = (_e1014 + (_e999 & 31u));
                        let _e1017 = leaves.member[_e1010];
                        let _e1019 = leaves.member[_e1015];
                        let _e1021 = nodes.member[_e1010];
                        let _e1035 = nodes.member[_e1015];
                        let _e1050 = params.member.member.member_1;
                        if ((_e1050 & 1u) != 0u) {
                            if (_e1019.member[0] == _e1017.member[0]) {
                                phi_2009_ = true;
                            } else {
                                phi_2009_ = (_e1019.member[0] == _e1017.member[1]);
                            }
                            let _e1064 = phi_2009_;
                            if (_e1019.member[1] == _e1017.member[0]) {
                                phi_2015_ = true;
                            } else {
                                phi_2015_ = (_e1019.member[1] == _e1017.member[1]);
                            }
                            let _e1068 = phi_2015_;
                            if (_e1064 || _e1068) {
                                phi_2021_ = false;
                            } else {
                                phi_2021_ = true;
                            }
                            let _e1071 = phi_2021_;
                            phi_2022_ = _e1071;
                        } else {
                            phi_2022_ = true;
                        }
                        let _e1073 = phi_2022_;
                        if _e1073 {
                            let _e1075 = params.member.member.member_1;
                            if ((_e1075 & 2u) != 0u) {
                                let _e1079 = params.member.member.member_1;
                                let _e1085 = bodies.member[_e1017.member[0]];
                                let _e1089 = bodies.member[_e1019.member[0]];
                                if ((_e1085 / 2u) != (_e1089 / 2u)) {
                                    phi_2068_ = true;
                                } else {
                                    phi_2068_ = ((_e1079 & 4u) != 0u);
                                }
                                let _e1094 = phi_2068_;
                                if _e1094 {
                                    phi_2075_ = (((_e1085 & _e1089) & 1u) == 0u);
                                } else {
                                    phi_2075_ = false;
                                }
                                let _e1099 = phi_2075_;
                                phi_2079_ = _e1099;
                            } else {
                                phi_2079_ = true;
                            }
                            let _e1101 = phi_2079_;
                            if _e1101 {
                                let _e1103 = params.member.member.member_1;
                                if ((_e1103 & 32u) != 0u) {
                                    let _e1107 = params.member.member.member_6;
                                    let _e1124 = (((((_e1021.member_1.y - _e1035.member.x) > _e1107) && ((_e1035.member_1.y - _e1021.member.x) > _e1107)) && (((_e1021.member_2.x - _e1035.member.y) > _e1107) && ((_e1035.member_2.x - _e1021.member.y) > _e1107))) && (((_e1021.member_2.y - _e1035.member_1.x) > _e1107) && ((_e1035.member_2.y - _e1021.member_1.x) > _e1107)));
                                    if _e1124 {
                                        phi_2681_ = bool();
                                    } else {
                                        let _e1128 = keys.member[_e1017.member[0]];
                                        let _e1133 = keys.member[_e1017.member[1]];
                                        let _e1135 = function_(_e1128[0], _e1133[0]);
                                        let _e1139 = keys.member[_e1017.member[2]];
                                        let _e1141 = function_(_e1135, _e1139[0]);
                                        let _e1145 = keys.member[_e1019.member[0]];
                                        let _e1150 = keys.member[_e1019.member[1]];
                                        let _e1152 = function_1(_e1145[3], _e1150[3]);
                                        let _e1156 = keys.member[_e1019.member[2]];
                                        let _e1158 = function_1(_e1152, _e1156[3]);
                                        if (_e1141[1] > _e1158[1]) {
                                            phi_2204_ = true;
                                        } else {
                                            if (_e1141[1] == _e1158[1]) {
                                                phi_2203_ = (_e1141[0] > _e1158[0]);
                                            } else {
                                                phi_2203_ = false;
                                            }
                                            let _e1169 = phi_2203_;
                                            phi_2204_ = _e1169;
                                        }
                                        let _e1171 = phi_2204_;
                                        let _e1176 = keys.member[_e1019.member[0]];
                                        let _e1181 = keys.member[_e1019.member[1]];
                                        let _e1183 = function_(_e1176[0], _e1181[0]);
                                        let _e1187 = keys.member[_e1019.member[2]];
                                        let _e1189 = function_(_e1183, _e1187[0]);
                                        let _e1193 = keys.member[_e1017.member[0]];
                                        let _e1198 = keys.member[_e1017.member[1]];
                                        let _e1200 = function_1(_e1193[3], _e1198[3]);
                                        let _e1204 = keys.member[_e1017.member[2]];
                                        let _e1206 = function_1(_e1200, _e1204[3]);
                                        if (_e1189[1] > _e1206[1]) {
                                            phi_2298_ = true;
                                        } else {
                                            if (_e1189[1] == _e1206[1]) {
                                                phi_2297_ = (_e1189[0] > _e1206[0]);
                                            } else {
                                                phi_2297_ = false;
                                            }
                                            let _e1217 = phi_2297_;
                                            phi_2298_ = _e1217;
                                        }
                                        let _e1219 = phi_2298_;
                                        let _e1225 = keys.member[_e1017.member[0]];
                                        let _e1230 = keys.member[_e1017.member[1]];
                                        let _e1232 = function_2(_e1225[1], _e1230[1]);
                                        let _e1236 = keys.member[_e1017.member[2]];
                                        let _e1238 = function_2(_e1232, _e1236[1]);
                                        let _e1242 = keys.member[_e1019.member[0]];
                                        let _e1247 = keys.member[_e1019.member[1]];
                                        let _e1249 = function_3(_e1242[4], _e1247[4]);
                                        let _e1253 = keys.member[_e1019.member[2]];
                                        let _e1255 = function_3(_e1249, _e1253[4]);
                                        if (_e1238[1] > _e1255[1]) {
                                            phi_2393_ = true;
                                        } else {
                                            if (_e1238[1] == _e1255[1]) {
                                                phi_2392_ = (_e1238[0] > _e1255[0]);
                                            } else {
                                                phi_2392_ = false;
                                            }
                                            let _e1266 = phi_2392_;
                                            phi_2393_ = _e1266;
                                        }
                                        let _e1268 = phi_2393_;
                                        let _e1273 = keys.member[_e1019.member[0]];
                                        let _e1278 = keys.member[_e1019.member[1]];
                                        let _e1280 = function_2(_e1273[1], _e1278[1]);
                                        let _e1284 = keys.member[_e1019.member[2]];
                                        let _e1286 = function_2(_e1280, _e1284[1]);
                                        let _e1290 = keys.member[_e1017.member[0]];
                                        let _e1295 = keys.member[_e1017.member[1]];
                                        let _e1297 = function_3(_e1290[4], _e1295[4]);
                                        let _e1301 = keys.member[_e1017.member[2]];
                                        let _e1303 = function_3(_e1297, _e1301[4]);
                                        if (_e1286[1] > _e1303[1]) {
                                            phi_2487_ = true;
                                        } else {
                                            if (_e1286[1] == _e1303[1]) {
                                                phi_2486_ = (_e1286[0] > _e1303[0]);
                                            } else {
                                                phi_2486_ = false;
                                            }
                                            let _e1314 = phi_2486_;
                                            phi_2487_ = _e1314;
                                        }
                                        let _e1316 = phi_2487_;
                                        let _e1323 = keys.member[_e1017.member[0]];
                                        let _e1328 = keys.member[_e1017.member[1]];
                                        let _e1330 = function_4(_e1323[2], _e1328[2]);
                                        let _e1334 = keys.member[_e1017.member[2]];
                                        let _e1336 = function_4(_e1330, _e1334[2]);
                                        let _e1340 = keys.member[_e1019.member[0]];
                                        let _e1345 = keys.member[_e1019.member[1]];
                                        let _e1347 = function_5(_e1340[5], _e1345[5]);
                                        let _e1351 = keys.member[_e1019.member[2]];
                                        let _e1353 = function_5(_e1347, _e1351[5]);
                                        if (_e1336[1] > _e1353[1]) {
                                            phi_2583_ = true;
                                        } else {
                                            if (_e1336[1] == _e1353[1]) {
                                                phi_2582_ = (_e1336[0] > _e1353[0]);
                                            } else {
                                                phi_2582_ = false;
                                            }
                                            let _e1364 = phi_2582_;
                                            phi_2583_ = _e1364;
                                        }
                                        let _e1366 = phi_2583_;
                                        let _e1371 = keys.member[_e1019.member[0]];
                                        let _e1376 = keys.member[_e1019.member[1]];
                                        let _e1378 = function_4(_e1371[2], _e1376[2]);
                                        let _e1382 = keys.member[_e1019.member[2]];
                                        let _e1384 = function_4(_e1378, _e1382[2]);
                                        let _e1388 = keys.member[_e1017.member[0]];
                                        let _e1393 = keys.member[_e1017.member[1]];
                                        let _e1395 = function_5(_e1388[5], _e1393[5]);
                                        let _e1399 = keys.member[_e1017.member[2]];
                                        let _e1401 = function_5(_e1395, _e1399[5]);
                                        if (_e1384[1] > _e1401[1]) {
                                            phi_2677_ = true;
                                        } else {
                                            if (_e1384[1] == _e1401[1]) {
                                                phi_2676_ = (_e1384[0] > _e1401[0]);
                                            } else {
                                                phi_2676_ = false;
                                            }
                                            let _e1412 = phi_2676_;
                                            phi_2677_ = _e1412;
                                        }
                                        let _e1414 = phi_2677_;
                                        phi_2681_ = (((!(_e1171) && !(_e1219)) && (!(_e1268) && !(_e1316))) && (!(_e1366) && !(_e1414)));
                                    }
                                    let _e1419 = phi_2681_;
                                    phi_2682_ = _e1419;
                                    phi_2683_ = _e1124;
                                } else {
                                    phi_2682_ = bool();
                                    phi_2683_ = true;
                                }
                                let _e1421 = phi_2682_;
                                let _e1423 = phi_2683_;
                                if _e1423 {
                                    phi_2687_ = false;
                                } else {
                                    phi_2687_ = true;
                                }
                                let _e1425 = phi_2687_;
                                phi_2688_ = _e1421;
                                phi_2689_ = _e1425;
                            } else {
                                phi_2688_ = false;
                                phi_2689_ = true;
                            }
                            let _e1427 = phi_2688_;
                            let _e1429 = phi_2689_;
                            phi_2690_ = _e1427;
                            phi_2691_ = _e1429;
                        } else {
                            phi_2690_ = false;
                            phi_2691_ = true;
                        }
                        let _e1431 = phi_2690_;
                        let _e1433 = phi_2691_;
                        if _e1433 {
                            phi_2695_ = _e1431;
                        } else {
                            phi_2695_ = true;
                        }
                        let _e1435 = phi_2695_;
                        if _e1435 {
                            let _e1437 = atomicAdd((&counters[7u]), 1u);
                            if (_e1017.member_1 < _e1019.member_1) {
                                phi_2708_ = _e1019;
                                phi_2709_ = _e1017;
                            } else {
                                phi_2708_ = _e1017;
                                phi_2709_ = _e1019;
                            }
                            let _e1443 = phi_2708_;
                            let _e1445 = phi_2709_;
                            let _e1447 = params.member.member.member_4;
                            let _e1449 = params.member.member.member_5;
                            let _e1459 = paths.member[_e1445.member[0]];
                            let _e1461 = paths.member[_e1445.member[1]];
                            let _e1467 = paths.member[_e1443.member[0]];
                            let _e1469 = paths.member[_e1443.member[1]];
                            local_2 = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1467.member[0] - _e1459.member[0]), (_e1467.member[1] - _e1459.member[1]), (_e1467.member[2] - _e1459.member[2])), array<f32, 3>((_e1467.member_1[0] - _e1459.member_1[0]), (_e1467.member_1[1] - _e1459.member_1[1]), (_e1467.member_1[2] - _e1459.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1461.member[0] - _e1459.member[0]), (_e1461.member[1] - _e1459.member[1]), (_e1461.member[2] - _e1459.member[2])), array<f32, 3>((_e1461.member_1[0] - _e1459.member_1[0]), (_e1461.member_1[1] - _e1459.member_1[1]), (_e1461.member_1[2] - _e1459.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1467.member[0] - _e1469.member[0]), (_e1467.member[1] - _e1469.member[1]), (_e1467.member[2] - _e1469.member[2])), array<f32, 3>((_e1467.member_1[0] - _e1469.member_1[0]), (_e1467.member_1[1] - _e1469.member_1[1]), (_e1467.member_1[2] - _e1469.member_1[2]))), (_e1447 + _e1447));
                            let _e1529 = local_2.member_1[0u];
                            let _e1535 = local_2.member_2[0u];
                            let _e1541 = ((_e1529[1] * _e1535[2]) - (_e1529[2] * _e1535[1]));
                            let _e1544 = ((_e1529[2] * _e1535[0]) - (_e1529[0] * _e1535[2]));
                            let _e1547 = ((_e1529[0] * _e1535[1]) - (_e1529[1] * _e1535[0]));
                            let _e1550 = local_2.member_1[1u];
                            let _e1556 = local_2.member_2[1u];
                            let _e1562 = ((_e1550[1] * _e1556[2]) - (_e1550[2] * _e1556[1]));
                            let _e1565 = ((_e1550[2] * _e1556[0]) - (_e1550[0] * _e1556[2]));
                            let _e1568 = ((_e1550[0] * _e1556[1]) - (_e1550[1] * _e1556[0]));
                            let _e1571 = local_2.member_1[0u];
                            let _e1577 = local_2.member_2[1u];
                            let _e1592 = local_2.member_1[1u];
                            let _e1598 = local_2.member_2[0u];
                            let _e1611 = (((_e1571[1] * _e1577[2]) - (_e1571[2] * _e1577[1])) + ((_e1592[1] * _e1598[2]) - (_e1592[2] * _e1598[1])));
                            let _e1612 = (((_e1571[2] * _e1577[0]) - (_e1571[0] * _e1577[2])) + ((_e1592[2] * _e1598[0]) - (_e1592[0] * _e1598[2])));
                            let _e1613 = (((_e1571[0] * _e1577[1]) - (_e1571[1] * _e1577[0])) + ((_e1592[0] * _e1598[1]) - (_e1592[1] * _e1598[0])));
                            let _e1616 = local_2.member[0u];
                            let _e1627 = local_2.member[1u];
                            let _e1638 = local_2.member[0u];
                            let _e1647 = ((((_e1627[0] * _e1541) + (_e1627[1] * _e1544)) + (_e1627[2] * _e1547)) + (((_e1638[0] * _e1611) + (_e1638[1] * _e1612)) + (_e1638[2] * _e1613)));
                            let _e1650 = local_2.member[0u];
                            let _e1661 = local_2.member[1u];
                            let _e1670 = ((((_e1650[0] * _e1562) + (_e1650[1] * _e1565)) + (_e1650[2] * _e1568)) + (((_e1661[0] * _e1611) + (_e1661[1] * _e1612)) + (_e1661[2] * _e1613)));
                            let _e1673 = local_2.member[1u];
                            let _e1684 = local_2.member[0u];
                            if (_e1684[0] < 0f) {
                                phi_3098_ = -(_e1684[0]);
                            } else {
                                phi_3098_ = _e1684[0];
                            }
                            let _e1691 = phi_3098_;
                            if (_e1684[1] < 0f) {
                                phi_3105_ = -(_e1684[1]);
                            } else {
                                phi_3105_ = _e1684[1];
                            }
                            let _e1695 = phi_3105_;
                            if (_e1691 > _e1695) {
                                phi_3110_ = _e1691;
                            } else {
                                phi_3110_ = _e1695;
                            }
                            let _e1698 = phi_3110_;
                            if (_e1684[2] < 0f) {
                                phi_3117_ = -(_e1684[2]);
                            } else {
                                phi_3117_ = _e1684[2];
                            }
                            let _e1702 = phi_3117_;
                            if (_e1698 > _e1702) {
                                phi_3122_ = _e1698;
                            } else {
                                phi_3122_ = _e1702;
                            }
                            let _e1705 = phi_3122_;
                            let _e1708 = local_2.member[1u];
                            if (_e1708[0] < 0f) {
                                phi_3135_ = -(_e1708[0]);
                            } else {
                                phi_3135_ = _e1708[0];
                            }
                            let _e1715 = phi_3135_;
                            if (_e1708[1] < 0f) {
                                phi_3142_ = -(_e1708[1]);
                            } else {
                                phi_3142_ = _e1708[1];
                            }
                            let _e1719 = phi_3142_;
                            if (_e1715 > _e1719) {
                                phi_3147_ = _e1715;
                            } else {
                                phi_3147_ = _e1719;
                            }
                            let _e1722 = phi_3147_;
                            if (_e1708[2] < 0f) {
                                phi_3154_ = -(_e1708[2]);
                            } else {
                                phi_3154_ = _e1708[2];
                            }
                            let _e1726 = phi_3154_;
                            if (_e1722 > _e1726) {
                                phi_3159_ = _e1722;
                            } else {
                                phi_3159_ = _e1726;
                            }
                            let _e1729 = phi_3159_;
                            if (_e1705 > _e1729) {
                                phi_3164_ = _e1705;
                            } else {
                                phi_3164_ = _e1729;
                            }
                            let _e1732 = phi_3164_;
                            let _e1734 = local_2.member_3;
                            let _e1735 = (_e1732 + _e1734);
                            let _e1738 = local_2.member_1[0u];
                            if (_e1738[0] < 0f) {
                                phi_3181_ = -(_e1738[0]);
                            } else {
                                phi_3181_ = _e1738[0];
                            }
                            let _e1745 = phi_3181_;
                            if (_e1738[1] < 0f) {
                                phi_3188_ = -(_e1738[1]);
                            } else {
                                phi_3188_ = _e1738[1];
                            }
                            let _e1749 = phi_3188_;
                            if (_e1745 > _e1749) {
                                phi_3193_ = _e1745;
                            } else {
                                phi_3193_ = _e1749;
                            }
                            let _e1752 = phi_3193_;
                            if (_e1738[2] < 0f) {
                                phi_3200_ = -(_e1738[2]);
                            } else {
                                phi_3200_ = _e1738[2];
                            }
                            let _e1756 = phi_3200_;
                            if (_e1752 > _e1756) {
                                phi_3205_ = _e1752;
                            } else {
                                phi_3205_ = _e1756;
                            }
                            let _e1759 = phi_3205_;
                            let _e1762 = local_2.member_1[1u];
                            if (_e1762[0] < 0f) {
                                phi_3219_ = -(_e1762[0]);
                            } else {
                                phi_3219_ = _e1762[0];
                            }
                            let _e1769 = phi_3219_;
                            if (_e1762[1] < 0f) {
                                phi_3226_ = -(_e1762[1]);
                            } else {
                                phi_3226_ = _e1762[1];
                            }
                            let _e1773 = phi_3226_;
                            if (_e1769 > _e1773) {
                                phi_3231_ = _e1769;
                            } else {
                                phi_3231_ = _e1773;
                            }
                            let _e1776 = phi_3231_;
                            if (_e1762[2] < 0f) {
                                phi_3238_ = -(_e1762[2]);
                            } else {
                                phi_3238_ = _e1762[2];
                            }
                            let _e1780 = phi_3238_;
                            if (_e1776 > _e1780) {
                                phi_3243_ = _e1776;
                            } else {
                                phi_3243_ = _e1780;
                            }
                            let _e1783 = phi_3243_;
                            if (_e1759 > _e1783) {
                                phi_3248_ = _e1759;
                            } else {
                                phi_3248_ = _e1783;
                            }
                            let _e1786 = phi_3248_;
                            let _e1788 = local_2.member_3;
                            let _e1789 = (_e1786 + _e1788);
                            let _e1792 = local_2.member_2[0u];
                            if (_e1792[0] < 0f) {
                                phi_3265_ = -(_e1792[0]);
                            } else {
                                phi_3265_ = _e1792[0];
                            }
                            let _e1799 = phi_3265_;
                            if (_e1792[1] < 0f) {
                                phi_3272_ = -(_e1792[1]);
                            } else {
                                phi_3272_ = _e1792[1];
                            }
                            let _e1803 = phi_3272_;
                            if (_e1799 > _e1803) {
                                phi_3277_ = _e1799;
                            } else {
                                phi_3277_ = _e1803;
                            }
                            let _e1806 = phi_3277_;
                            if (_e1792[2] < 0f) {
                                phi_3284_ = -(_e1792[2]);
                            } else {
                                phi_3284_ = _e1792[2];
                            }
                            let _e1810 = phi_3284_;
                            if (_e1806 > _e1810) {
                                phi_3289_ = _e1806;
                            } else {
                                phi_3289_ = _e1810;
                            }
                            let _e1813 = phi_3289_;
                            let _e1816 = local_2.member_2[1u];
                            if (_e1816[0] < 0f) {
                                phi_3303_ = -(_e1816[0]);
                            } else {
                                phi_3303_ = _e1816[0];
                            }
                            let _e1823 = phi_3303_;
                            if (_e1816[1] < 0f) {
                                phi_3310_ = -(_e1816[1]);
                            } else {
                                phi_3310_ = _e1816[1];
                            }
                            let _e1827 = phi_3310_;
                            if (_e1823 > _e1827) {
                                phi_3315_ = _e1823;
                            } else {
                                phi_3315_ = _e1827;
                            }
                            let _e1830 = phi_3315_;
                            if (_e1816[2] < 0f) {
                                phi_3322_ = -(_e1816[2]);
                            } else {
                                phi_3322_ = _e1816[2];
                            }
                            let _e1834 = phi_3322_;
                            if (_e1830 > _e1834) {
                                phi_3327_ = _e1830;
                            } else {
                                phi_3327_ = _e1834;
                            }
                            let _e1837 = phi_3327_;
                            if (_e1813 > _e1837) {
                                phi_3332_ = _e1813;
                            } else {
                                phi_3332_ = _e1837;
                            }
                            let _e1840 = phi_3332_;
                            let _e1842 = local_2.member_3;
                            let _e1843 = (_e1840 + _e1842);
                            let _e1845 = ((_e1789 * 8f) * _e1843);
                            let _e1852 = local_2.member_3;
                            if (_e1541 < 0f) {
                                phi_3363_ = -(_e1541);
                            } else {
                                phi_3363_ = _e1541;
                            }
                            let _e1869 = phi_3363_;
                            if (_e1544 < 0f) {
                                phi_3369_ = -(_e1544);
                            } else {
                                phi_3369_ = _e1544;
                            }
                            let _e1873 = phi_3369_;
                            if (_e1547 < 0f) {
                                phi_3376_ = -(_e1547);
                            } else {
                                phi_3376_ = _e1547;
                            }
                            let _e1878 = phi_3376_;
                            let _e1879 = ((_e1869 + _e1873) + _e1878);
                            if (_e1562 < 0f) {
                                phi_3383_ = -(_e1562);
                            } else {
                                phi_3383_ = _e1562;
                            }
                            let _e1883 = phi_3383_;
                            if (_e1565 < 0f) {
                                phi_3389_ = -(_e1565);
                            } else {
                                phi_3389_ = _e1565;
                            }
                            let _e1887 = phi_3389_;
                            if (_e1568 < 0f) {
                                phi_3396_ = -(_e1568);
                            } else {
                                phi_3396_ = _e1568;
                            }
                            let _e1892 = phi_3396_;
                            let _e1893 = ((_e1883 + _e1887) + _e1892);
                            if (_e1879 > _e1893) {
                                phi_3402_ = _e1879;
                            } else {
                                phi_3402_ = _e1893;
                            }
                            let _e1896 = phi_3402_;
                            if (_e1611 < 0f) {
                                phi_3408_ = -(_e1611);
                            } else {
                                phi_3408_ = _e1611;
                            }
                            let _e1900 = phi_3408_;
                            if (_e1612 < 0f) {
                                phi_3414_ = -(_e1612);
                            } else {
                                phi_3414_ = _e1612;
                            }
                            let _e1904 = phi_3414_;
                            if (_e1613 < 0f) {
                                phi_3421_ = -(_e1613);
                            } else {
                                phi_3421_ = _e1613;
                            }
                            let _e1909 = phi_3421_;
                            let _e1911 = (((_e1900 + _e1904) + _e1909) * 0.5f);
                            if (_e1896 > _e1911) {
                                phi_3428_ = _e1896;
                            } else {
                                phi_3428_ = _e1911;
                            }
                            let _e1914 = phi_3428_;
                            let _e1919 = local_2.member_3;
                            let _e1932 = ((((_e1616[0] * _e1541) + (_e1616[1] * _e1544)) + (_e1616[2] * _e1547)) * 3f);
                            let _e1933 = ((((_e1673[0] * _e1562) + (_e1673[1] * _e1565)) + (_e1673[2] * _e1568)) * 3f);
                            if (_e1932 < _e1933) {
                                phi_3452_ = _e1932;
                            } else {
                                phi_3452_ = _e1933;
                            }
                            let _e1936 = phi_3452_;
                            if (_e1647 < _e1670) {
                                phi_3457_ = _e1647;
                            } else {
                                phi_3457_ = _e1670;
                            }
                            let _e1939 = phi_3457_;
                            if (_e1936 < _e1939) {
                                phi_3462_ = _e1936;
                            } else {
                                phi_3462_ = _e1939;
                            }
                            let _e1942 = phi_3462_;
                            if (_e1932 > _e1933) {
                                phi_3467_ = _e1932;
                            } else {
                                phi_3467_ = _e1933;
                            }
                            let _e1945 = phi_3467_;
                            if (_e1647 > _e1670) {
                                phi_3472_ = _e1647;
                            } else {
                                phi_3472_ = _e1670;
                            }
                            let _e1948 = phi_3472_;
                            if (_e1945 > _e1948) {
                                phi_3477_ = _e1945;
                            } else {
                                phi_3477_ = _e1948;
                            }
                            let _e1951 = phi_3477_;
                            let _e1956 = -(_e1951);
                            if (_e1942 > _e1956) {
                                phi_3487_ = _e1942;
                            } else {
                                phi_3487_ = _e1956;
                            }
                            let _e1959 = phi_3487_;
                            let _e1961 = ((_e1959 - ((((((_e1735 * 8f) * _e1845) * (0.000000059604645f * (524f / 64f))) + ((_e1852 * 19f) * ((_e1735 * (_e1789 + _e1843)) + (_e1789 * _e1843)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1735) * ((1f + _e1789) * (1f + _e1843))))) + ((_e1449 * (((_e1914 + (_e1845 * (0.000000059604645f * 8f))) + ((_e1919 * 6f) * (_e1789 + _e1843))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1789) * (1f + _e1843))))) * (3f * 1.0001f)))) > 0f);
                            if _e1961 {
                                phi_4456_ = _e1961;
                            } else {
                                let _e1964 = local_2.member_1[0u];
                                let _e1970 = local_2.member_1[1u];
                                let _e1974 = (_e1964[0] + _e1970[0]);
                                let _e1975 = (_e1964[1] + _e1970[1]);
                                let _e1976 = (_e1964[2] + _e1970[2]);
                                let _e1979 = local_2.member_2[0u];
                                let _e1985 = local_2.member_2[1u];
                                let _e1989 = (_e1979[0] + _e1985[0]);
                                let _e1990 = (_e1979[1] + _e1985[1]);
                                let _e1991 = (_e1979[2] + _e1985[2]);
                                let _e1994 = ((_e1975 * _e1991) - (_e1976 * _e1990));
                                let _e1997 = ((_e1976 * _e1989) - (_e1974 * _e1991));
                                let _e2000 = ((_e1974 * _e1990) - (_e1975 * _e1989));
                                let _e2003 = local_2.member[0u];
                                let _e2009 = local_2.member_1[0u];
                                let _e2015 = local_2.member_2[0u];
                                let _e2019 = (_e2003[0] - _e2009[0]);
                                let _e2020 = (_e2003[1] - _e2009[1]);
                                let _e2021 = (_e2003[2] - _e2009[2]);
                                let _e2022 = (_e2019 - _e2015[0]);
                                let _e2023 = (_e2020 - _e2015[1]);
                                let _e2024 = (_e2021 - _e2015[2]);
                                let _e2025 = (_e2003[0] - _e2015[0]);
                                let _e2026 = (_e2003[1] - _e2015[1]);
                                let _e2027 = (_e2003[2] - _e2015[2]);
                                let _e2030 = local_2.member[1u];
                                let _e2036 = local_2.member_1[1u];
                                let _e2042 = local_2.member_2[1u];
                                let _e2046 = (_e2030[0] - _e2036[0]);
                                let _e2047 = (_e2030[1] - _e2036[1]);
                                let _e2048 = (_e2030[2] - _e2036[2]);
                                let _e2049 = (_e2046 - _e2042[0]);
                                let _e2050 = (_e2047 - _e2042[1]);
                                let _e2051 = (_e2048 - _e2042[2]);
                                let _e2052 = (_e2030[0] - _e2042[0]);
                                let _e2053 = (_e2030[1] - _e2042[1]);
                                let _e2054 = (_e2030[2] - _e2042[2]);
                                let _e2057 = local_2.member[0u];
                                if (_e2057[0] < 0f) {
                                    phi_3690_ = -(_e2057[0]);
                                } else {
                                    phi_3690_ = _e2057[0];
                                }
                                let _e2064 = phi_3690_;
                                if (_e2057[1] < 0f) {
                                    phi_3697_ = -(_e2057[1]);
                                } else {
                                    phi_3697_ = _e2057[1];
                                }
                                let _e2068 = phi_3697_;
                                if (_e2064 > _e2068) {
                                    phi_3702_ = _e2064;
                                } else {
                                    phi_3702_ = _e2068;
                                }
                                let _e2071 = phi_3702_;
                                if (_e2057[2] < 0f) {
                                    phi_3709_ = -(_e2057[2]);
                                } else {
                                    phi_3709_ = _e2057[2];
                                }
                                let _e2075 = phi_3709_;
                                if (_e2071 > _e2075) {
                                    phi_3714_ = _e2071;
                                } else {
                                    phi_3714_ = _e2075;
                                }
                                let _e2078 = phi_3714_;
                                let _e2081 = local_2.member[1u];
                                if (_e2081[0] < 0f) {
                                    phi_3727_ = -(_e2081[0]);
                                } else {
                                    phi_3727_ = _e2081[0];
                                }
                                let _e2088 = phi_3727_;
                                if (_e2081[1] < 0f) {
                                    phi_3734_ = -(_e2081[1]);
                                } else {
                                    phi_3734_ = _e2081[1];
                                }
                                let _e2092 = phi_3734_;
                                if (_e2088 > _e2092) {
                                    phi_3739_ = _e2088;
                                } else {
                                    phi_3739_ = _e2092;
                                }
                                let _e2095 = phi_3739_;
                                if (_e2081[2] < 0f) {
                                    phi_3746_ = -(_e2081[2]);
                                } else {
                                    phi_3746_ = _e2081[2];
                                }
                                let _e2099 = phi_3746_;
                                if (_e2095 > _e2099) {
                                    phi_3751_ = _e2095;
                                } else {
                                    phi_3751_ = _e2099;
                                }
                                let _e2102 = phi_3751_;
                                if (_e2078 > _e2102) {
                                    phi_3756_ = _e2078;
                                } else {
                                    phi_3756_ = _e2102;
                                }
                                let _e2105 = phi_3756_;
                                let _e2107 = local_2.member_3;
                                let _e2111 = local_2.member_1[0u];
                                if (_e2111[0] < 0f) {
                                    phi_3773_ = -(_e2111[0]);
                                } else {
                                    phi_3773_ = _e2111[0];
                                }
                                let _e2118 = phi_3773_;
                                if (_e2111[1] < 0f) {
                                    phi_3780_ = -(_e2111[1]);
                                } else {
                                    phi_3780_ = _e2111[1];
                                }
                                let _e2122 = phi_3780_;
                                if (_e2118 > _e2122) {
                                    phi_3785_ = _e2118;
                                } else {
                                    phi_3785_ = _e2122;
                                }
                                let _e2125 = phi_3785_;
                                if (_e2111[2] < 0f) {
                                    phi_3792_ = -(_e2111[2]);
                                } else {
                                    phi_3792_ = _e2111[2];
                                }
                                let _e2129 = phi_3792_;
                                if (_e2125 > _e2129) {
                                    phi_3797_ = _e2125;
                                } else {
                                    phi_3797_ = _e2129;
                                }
                                let _e2132 = phi_3797_;
                                let _e2135 = local_2.member_1[1u];
                                if (_e2135[0] < 0f) {
                                    phi_3811_ = -(_e2135[0]);
                                } else {
                                    phi_3811_ = _e2135[0];
                                }
                                let _e2142 = phi_3811_;
                                if (_e2135[1] < 0f) {
                                    phi_3818_ = -(_e2135[1]);
                                } else {
                                    phi_3818_ = _e2135[1];
                                }
                                let _e2146 = phi_3818_;
                                if (_e2142 > _e2146) {
                                    phi_3823_ = _e2142;
                                } else {
                                    phi_3823_ = _e2146;
                                }
                                let _e2149 = phi_3823_;
                                if (_e2135[2] < 0f) {
                                    phi_3830_ = -(_e2135[2]);
                                } else {
                                    phi_3830_ = _e2135[2];
                                }
                                let _e2153 = phi_3830_;
                                if (_e2149 > _e2153) {
                                    phi_3835_ = _e2149;
                                } else {
                                    phi_3835_ = _e2153;
                                }
                                let _e2156 = phi_3835_;
                                if (_e2132 > _e2156) {
                                    phi_3840_ = _e2132;
                                } else {
                                    phi_3840_ = _e2156;
                                }
                                let _e2159 = phi_3840_;
                                let _e2161 = local_2.member_3;
                                let _e2165 = local_2.member_2[0u];
                                if (_e2165[0] < 0f) {
                                    phi_3857_ = -(_e2165[0]);
                                } else {
                                    phi_3857_ = _e2165[0];
                                }
                                let _e2172 = phi_3857_;
                                if (_e2165[1] < 0f) {
                                    phi_3864_ = -(_e2165[1]);
                                } else {
                                    phi_3864_ = _e2165[1];
                                }
                                let _e2176 = phi_3864_;
                                if (_e2172 > _e2176) {
                                    phi_3869_ = _e2172;
                                } else {
                                    phi_3869_ = _e2176;
                                }
                                let _e2179 = phi_3869_;
                                if (_e2165[2] < 0f) {
                                    phi_3876_ = -(_e2165[2]);
                                } else {
                                    phi_3876_ = _e2165[2];
                                }
                                let _e2183 = phi_3876_;
                                if (_e2179 > _e2183) {
                                    phi_3881_ = _e2179;
                                } else {
                                    phi_3881_ = _e2183;
                                }
                                let _e2186 = phi_3881_;
                                let _e2189 = local_2.member_2[1u];
                                if (_e2189[0] < 0f) {
                                    phi_3895_ = -(_e2189[0]);
                                } else {
                                    phi_3895_ = _e2189[0];
                                }
                                let _e2196 = phi_3895_;
                                if (_e2189[1] < 0f) {
                                    phi_3902_ = -(_e2189[1]);
                                } else {
                                    phi_3902_ = _e2189[1];
                                }
                                let _e2200 = phi_3902_;
                                if (_e2196 > _e2200) {
                                    phi_3907_ = _e2196;
                                } else {
                                    phi_3907_ = _e2200;
                                }
                                let _e2203 = phi_3907_;
                                if (_e2189[2] < 0f) {
                                    phi_3914_ = -(_e2189[2]);
                                } else {
                                    phi_3914_ = _e2189[2];
                                }
                                let _e2207 = phi_3914_;
                                if (_e2203 > _e2207) {
                                    phi_3919_ = _e2203;
                                } else {
                                    phi_3919_ = _e2207;
                                }
                                let _e2210 = phi_3919_;
                                if (_e2186 > _e2210) {
                                    phi_3924_ = _e2186;
                                } else {
                                    phi_3924_ = _e2210;
                                }
                                let _e2213 = phi_3924_;
                                let _e2215 = local_2.member_3;
                                let _e2219 = ((((_e2105 + _e2107) + (_e2159 + _e2161)) + (_e2213 + _e2215)) * 2f);
                                let _e2222 = local_2.member_3;
                                let _e2226 = (((_e1449 * 1.0001f) + (_e2222 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2229 = ((_e1997 * _e1976) - (_e2000 * _e1975));
                                let _e2232 = ((_e2000 * _e1974) - (_e1994 * _e1976));
                                let _e2235 = ((_e1994 * _e1975) - (_e1997 * _e1974));
                                let _e2240 = (((_e2229 * _e2003[0]) + (_e2232 * _e2003[1])) + (_e2235 * _e2003[2]));
                                let _e2245 = (((_e2229 * _e2019) + (_e2232 * _e2020)) + (_e2235 * _e2021));
                                let _e2250 = (((_e2229 * _e2025) + (_e2232 * _e2026)) + (_e2235 * _e2027));
                                let _e2255 = (((_e2229 * _e2022) + (_e2232 * _e2023)) + (_e2235 * _e2024));
                                let _e2260 = (((_e2229 * _e2030[0]) + (_e2232 * _e2030[1])) + (_e2235 * _e2030[2]));
                                let _e2265 = (((_e2229 * _e2046) + (_e2232 * _e2047)) + (_e2235 * _e2048));
                                let _e2270 = (((_e2229 * _e2052) + (_e2232 * _e2053)) + (_e2235 * _e2054));
                                let _e2275 = (((_e2229 * _e2049) + (_e2232 * _e2050)) + (_e2235 * _e2051));
                                if (_e2240 < _e2245) {
                                    phi_4003_ = _e2240;
                                } else {
                                    phi_4003_ = _e2245;
                                }
                                let _e2278 = phi_4003_;
                                if (_e2250 < _e2255) {
                                    phi_4008_ = _e2250;
                                } else {
                                    phi_4008_ = _e2255;
                                }
                                let _e2281 = phi_4008_;
                                if (_e2278 < _e2281) {
                                    phi_4013_ = _e2278;
                                } else {
                                    phi_4013_ = _e2281;
                                }
                                let _e2284 = phi_4013_;
                                if (_e2260 < _e2265) {
                                    phi_4018_ = _e2260;
                                } else {
                                    phi_4018_ = _e2265;
                                }
                                let _e2287 = phi_4018_;
                                if (_e2270 < _e2275) {
                                    phi_4023_ = _e2270;
                                } else {
                                    phi_4023_ = _e2275;
                                }
                                let _e2290 = phi_4023_;
                                if (_e2287 < _e2290) {
                                    phi_4028_ = _e2287;
                                } else {
                                    phi_4028_ = _e2290;
                                }
                                let _e2293 = phi_4028_;
                                if (_e2284 < _e2293) {
                                    phi_4033_ = _e2284;
                                } else {
                                    phi_4033_ = _e2293;
                                }
                                let _e2296 = phi_4033_;
                                if (_e2240 > _e2245) {
                                    phi_4038_ = _e2240;
                                } else {
                                    phi_4038_ = _e2245;
                                }
                                let _e2299 = phi_4038_;
                                if (_e2250 > _e2255) {
                                    phi_4043_ = _e2250;
                                } else {
                                    phi_4043_ = _e2255;
                                }
                                let _e2302 = phi_4043_;
                                if (_e2299 > _e2302) {
                                    phi_4048_ = _e2299;
                                } else {
                                    phi_4048_ = _e2302;
                                }
                                let _e2305 = phi_4048_;
                                if (_e2260 > _e2265) {
                                    phi_4053_ = _e2260;
                                } else {
                                    phi_4053_ = _e2265;
                                }
                                let _e2308 = phi_4053_;
                                if (_e2270 > _e2275) {
                                    phi_4058_ = _e2270;
                                } else {
                                    phi_4058_ = _e2275;
                                }
                                let _e2311 = phi_4058_;
                                if (_e2308 > _e2311) {
                                    phi_4063_ = _e2308;
                                } else {
                                    phi_4063_ = _e2311;
                                }
                                let _e2314 = phi_4063_;
                                if (_e2305 > _e2314) {
                                    phi_4068_ = _e2305;
                                } else {
                                    phi_4068_ = _e2314;
                                }
                                let _e2317 = phi_4068_;
                                if (_e2229 < 0f) {
                                    phi_4074_ = -(_e2229);
                                } else {
                                    phi_4074_ = _e2229;
                                }
                                let _e2321 = phi_4074_;
                                if (_e2232 < 0f) {
                                    phi_4080_ = -(_e2232);
                                } else {
                                    phi_4080_ = _e2232;
                                }
                                let _e2325 = phi_4080_;
                                if (_e2235 < 0f) {
                                    phi_4087_ = -(_e2235);
                                } else {
                                    phi_4087_ = _e2235;
                                }
                                let _e2330 = phi_4087_;
                                let _e2331 = ((_e2321 + _e2325) + _e2330);
                                let _e2336 = -(_e2317);
                                if (_e2296 > _e2336) {
                                    phi_4098_ = _e2296;
                                } else {
                                    phi_4098_ = _e2336;
                                }
                                let _e2339 = phi_4098_;
                                let _e2344 = (((_e2339 - ((_e2331 * _e2219) * (0.000000059604645f * (17f / 2f)))) - (_e2331 * _e2226)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2347 = ((_e1997 * _e1991) - (_e2000 * _e1990));
                                let _e2350 = ((_e2000 * _e1989) - (_e1994 * _e1991));
                                let _e2353 = ((_e1994 * _e1990) - (_e1997 * _e1989));
                                let _e2358 = (((_e2347 * _e2003[0]) + (_e2350 * _e2003[1])) + (_e2353 * _e2003[2]));
                                let _e2363 = (((_e2347 * _e2019) + (_e2350 * _e2020)) + (_e2353 * _e2021));
                                let _e2368 = (((_e2347 * _e2025) + (_e2350 * _e2026)) + (_e2353 * _e2027));
                                let _e2373 = (((_e2347 * _e2022) + (_e2350 * _e2023)) + (_e2353 * _e2024));
                                let _e2378 = (((_e2347 * _e2030[0]) + (_e2350 * _e2030[1])) + (_e2353 * _e2030[2]));
                                let _e2383 = (((_e2347 * _e2046) + (_e2350 * _e2047)) + (_e2353 * _e2048));
                                let _e2388 = (((_e2347 * _e2052) + (_e2350 * _e2053)) + (_e2353 * _e2054));
                                let _e2393 = (((_e2347 * _e2049) + (_e2350 * _e2050)) + (_e2353 * _e2051));
                                if (_e2358 < _e2363) {
                                    phi_4169_ = _e2358;
                                } else {
                                    phi_4169_ = _e2363;
                                }
                                let _e2396 = phi_4169_;
                                if (_e2368 < _e2373) {
                                    phi_4174_ = _e2368;
                                } else {
                                    phi_4174_ = _e2373;
                                }
                                let _e2399 = phi_4174_;
                                if (_e2396 < _e2399) {
                                    phi_4179_ = _e2396;
                                } else {
                                    phi_4179_ = _e2399;
                                }
                                let _e2402 = phi_4179_;
                                if (_e2378 < _e2383) {
                                    phi_4184_ = _e2378;
                                } else {
                                    phi_4184_ = _e2383;
                                }
                                let _e2405 = phi_4184_;
                                if (_e2388 < _e2393) {
                                    phi_4189_ = _e2388;
                                } else {
                                    phi_4189_ = _e2393;
                                }
                                let _e2408 = phi_4189_;
                                if (_e2405 < _e2408) {
                                    phi_4194_ = _e2405;
                                } else {
                                    phi_4194_ = _e2408;
                                }
                                let _e2411 = phi_4194_;
                                if (_e2402 < _e2411) {
                                    phi_4199_ = _e2402;
                                } else {
                                    phi_4199_ = _e2411;
                                }
                                let _e2414 = phi_4199_;
                                if (_e2358 > _e2363) {
                                    phi_4204_ = _e2358;
                                } else {
                                    phi_4204_ = _e2363;
                                }
                                let _e2417 = phi_4204_;
                                if (_e2368 > _e2373) {
                                    phi_4209_ = _e2368;
                                } else {
                                    phi_4209_ = _e2373;
                                }
                                let _e2420 = phi_4209_;
                                if (_e2417 > _e2420) {
                                    phi_4214_ = _e2417;
                                } else {
                                    phi_4214_ = _e2420;
                                }
                                let _e2423 = phi_4214_;
                                if (_e2378 > _e2383) {
                                    phi_4219_ = _e2378;
                                } else {
                                    phi_4219_ = _e2383;
                                }
                                let _e2426 = phi_4219_;
                                if (_e2388 > _e2393) {
                                    phi_4224_ = _e2388;
                                } else {
                                    phi_4224_ = _e2393;
                                }
                                let _e2429 = phi_4224_;
                                if (_e2426 > _e2429) {
                                    phi_4229_ = _e2426;
                                } else {
                                    phi_4229_ = _e2429;
                                }
                                let _e2432 = phi_4229_;
                                if (_e2423 > _e2432) {
                                    phi_4234_ = _e2423;
                                } else {
                                    phi_4234_ = _e2432;
                                }
                                let _e2435 = phi_4234_;
                                if (_e2347 < 0f) {
                                    phi_4240_ = -(_e2347);
                                } else {
                                    phi_4240_ = _e2347;
                                }
                                let _e2439 = phi_4240_;
                                if (_e2350 < 0f) {
                                    phi_4246_ = -(_e2350);
                                } else {
                                    phi_4246_ = _e2350;
                                }
                                let _e2443 = phi_4246_;
                                if (_e2353 < 0f) {
                                    phi_4253_ = -(_e2353);
                                } else {
                                    phi_4253_ = _e2353;
                                }
                                let _e2448 = phi_4253_;
                                let _e2449 = ((_e2439 + _e2443) + _e2448);
                                let _e2454 = -(_e2435);
                                if (_e2414 > _e2454) {
                                    phi_4264_ = _e2414;
                                } else {
                                    phi_4264_ = _e2454;
                                }
                                let _e2457 = phi_4264_;
                                let _e2462 = (((_e2457 - ((_e2449 * _e2219) * (0.000000059604645f * (17f / 2f)))) - (_e2449 * _e2226)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2344 > _e2462) {
                                    phi_4274_ = _e2344;
                                } else {
                                    phi_4274_ = _e2462;
                                }
                                let _e2465 = phi_4274_;
                                phi_4456_ = (_e1961 || (_e2465 > 0f));
                            }
                            let _e2469 = phi_4456_;
                            if _e2469 {
                                phi_7873_ = _e2469;
                            } else {
                                let _e2472 = local_2.member[0u];
                                let _e2478 = local_2.member[1u];
                                let _e2485 = ((_e2472[0] + _e2478[0]) * 0.5f);
                                let _e2486 = ((_e2472[1] + _e2478[1]) * 0.5f);
                                let _e2487 = ((_e2472[2] + _e2478[2]) * 0.5f);
                                let _e2490 = local_2.member_1[0u];
                                let _e2496 = local_2.member_1[1u];
                                let _e2503 = ((_e2490[0] + _e2496[0]) * 0.5f);
                                let _e2504 = ((_e2490[1] + _e2496[1]) * 0.5f);
                                let _e2505 = ((_e2490[2] + _e2496[2]) * 0.5f);
                                let _e2508 = local_2.member_2[0u];
                                let _e2514 = local_2.member_2[1u];
                                let _e2521 = ((_e2508[0] + _e2514[0]) * 0.5f);
                                let _e2522 = ((_e2508[1] + _e2514[1]) * 0.5f);
                                let _e2523 = ((_e2508[2] + _e2514[2]) * 0.5f);
                                let _e2526 = local_2.member[0u];
                                let _e2529 = local_2.member_1[0u];
                                let _e2532 = local_2.member_2[0u];
                                let _e2534 = local_2.member_3;
                                let _e2537 = local_2.member[1u];
                                let _e2540 = local_2.member_1[1u];
                                let _e2543 = local_2.member_2[1u];
                                let _e2545 = local_2.member_3;
                                local = type_39(array<array<f32, 3>, 2>(_e2526, array<f32, 3>(_e2485, _e2486, _e2487)), array<array<f32, 3>, 2>(_e2529, array<f32, 3>(_e2503, _e2504, _e2505)), array<array<f32, 3>, 2>(_e2532, array<f32, 3>(_e2521, _e2522, _e2523)), _e2534);
                                local_1 = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e2485, _e2486, _e2487), _e2537), array<array<f32, 3>, 2>(array<f32, 3>(_e2503, _e2504, _e2505), _e2540), array<array<f32, 3>, 2>(array<f32, 3>(_e2521, _e2522, _e2523), _e2543), _e2545);
                                let _e2562 = local.member_1[0u];
                                let _e2568 = local.member_2[0u];
                                let _e2574 = ((_e2562[1] * _e2568[2]) - (_e2562[2] * _e2568[1]));
                                let _e2577 = ((_e2562[2] * _e2568[0]) - (_e2562[0] * _e2568[2]));
                                let _e2580 = ((_e2562[0] * _e2568[1]) - (_e2562[1] * _e2568[0]));
                                let _e2583 = local.member_1[1u];
                                let _e2589 = local.member_2[1u];
                                let _e2595 = ((_e2583[1] * _e2589[2]) - (_e2583[2] * _e2589[1]));
                                let _e2598 = ((_e2583[2] * _e2589[0]) - (_e2583[0] * _e2589[2]));
                                let _e2601 = ((_e2583[0] * _e2589[1]) - (_e2583[1] * _e2589[0]));
                                let _e2604 = local.member_1[0u];
                                let _e2610 = local.member_2[1u];
                                let _e2625 = local.member_1[1u];
                                let _e2631 = local.member_2[0u];
                                let _e2644 = (((_e2604[1] * _e2610[2]) - (_e2604[2] * _e2610[1])) + ((_e2625[1] * _e2631[2]) - (_e2625[2] * _e2631[1])));
                                let _e2645 = (((_e2604[2] * _e2610[0]) - (_e2604[0] * _e2610[2])) + ((_e2625[2] * _e2631[0]) - (_e2625[0] * _e2631[2])));
                                let _e2646 = (((_e2604[0] * _e2610[1]) - (_e2604[1] * _e2610[0])) + ((_e2625[0] * _e2631[1]) - (_e2625[1] * _e2631[0])));
                                let _e2649 = local.member[0u];
                                let _e2660 = local.member[1u];
                                let _e2671 = local.member[0u];
                                let _e2680 = ((((_e2660[0] * _e2574) + (_e2660[1] * _e2577)) + (_e2660[2] * _e2580)) + (((_e2671[0] * _e2644) + (_e2671[1] * _e2645)) + (_e2671[2] * _e2646)));
                                let _e2683 = local.member[0u];
                                let _e2694 = local.member[1u];
                                let _e2703 = ((((_e2683[0] * _e2595) + (_e2683[1] * _e2598)) + (_e2683[2] * _e2601)) + (((_e2694[0] * _e2644) + (_e2694[1] * _e2645)) + (_e2694[2] * _e2646)));
                                let _e2706 = local.member[1u];
                                let _e2717 = local.member[0u];
                                if (_e2717[0] < 0f) {
                                    phi_4908_ = -(_e2717[0]);
                                } else {
                                    phi_4908_ = _e2717[0];
                                }
                                let _e2724 = phi_4908_;
                                if (_e2717[1] < 0f) {
                                    phi_4915_ = -(_e2717[1]);
                                } else {
                                    phi_4915_ = _e2717[1];
                                }
                                let _e2728 = phi_4915_;
                                if (_e2724 > _e2728) {
                                    phi_4920_ = _e2724;
                                } else {
                                    phi_4920_ = _e2728;
                                }
                                let _e2731 = phi_4920_;
                                if (_e2717[2] < 0f) {
                                    phi_4927_ = -(_e2717[2]);
                                } else {
                                    phi_4927_ = _e2717[2];
                                }
                                let _e2735 = phi_4927_;
                                if (_e2731 > _e2735) {
                                    phi_4932_ = _e2731;
                                } else {
                                    phi_4932_ = _e2735;
                                }
                                let _e2738 = phi_4932_;
                                let _e2741 = local.member[1u];
                                if (_e2741[0] < 0f) {
                                    phi_4945_ = -(_e2741[0]);
                                } else {
                                    phi_4945_ = _e2741[0];
                                }
                                let _e2748 = phi_4945_;
                                if (_e2741[1] < 0f) {
                                    phi_4952_ = -(_e2741[1]);
                                } else {
                                    phi_4952_ = _e2741[1];
                                }
                                let _e2752 = phi_4952_;
                                if (_e2748 > _e2752) {
                                    phi_4957_ = _e2748;
                                } else {
                                    phi_4957_ = _e2752;
                                }
                                let _e2755 = phi_4957_;
                                if (_e2741[2] < 0f) {
                                    phi_4964_ = -(_e2741[2]);
                                } else {
                                    phi_4964_ = _e2741[2];
                                }
                                let _e2759 = phi_4964_;
                                if (_e2755 > _e2759) {
                                    phi_4969_ = _e2755;
                                } else {
                                    phi_4969_ = _e2759;
                                }
                                let _e2762 = phi_4969_;
                                if (_e2738 > _e2762) {
                                    phi_4974_ = _e2738;
                                } else {
                                    phi_4974_ = _e2762;
                                }
                                let _e2765 = phi_4974_;
                                let _e2767 = local.member_3;
                                let _e2768 = (_e2765 + _e2767);
                                let _e2771 = local.member_1[0u];
                                if (_e2771[0] < 0f) {
                                    phi_4991_ = -(_e2771[0]);
                                } else {
                                    phi_4991_ = _e2771[0];
                                }
                                let _e2778 = phi_4991_;
                                if (_e2771[1] < 0f) {
                                    phi_4998_ = -(_e2771[1]);
                                } else {
                                    phi_4998_ = _e2771[1];
                                }
                                let _e2782 = phi_4998_;
                                if (_e2778 > _e2782) {
                                    phi_5003_ = _e2778;
                                } else {
                                    phi_5003_ = _e2782;
                                }
                                let _e2785 = phi_5003_;
                                if (_e2771[2] < 0f) {
                                    phi_5010_ = -(_e2771[2]);
                                } else {
                                    phi_5010_ = _e2771[2];
                                }
                                let _e2789 = phi_5010_;
                                if (_e2785 > _e2789) {
                                    phi_5015_ = _e2785;
                                } else {
                                    phi_5015_ = _e2789;
                                }
                                let _e2792 = phi_5015_;
                                let _e2795 = local.member_1[1u];
                                if (_e2795[0] < 0f) {
                                    phi_5029_ = -(_e2795[0]);
                                } else {
                                    phi_5029_ = _e2795[0];
                                }
                                let _e2802 = phi_5029_;
                                if (_e2795[1] < 0f) {
                                    phi_5036_ = -(_e2795[1]);
                                } else {
                                    phi_5036_ = _e2795[1];
                                }
                                let _e2806 = phi_5036_;
                                if (_e2802 > _e2806) {
                                    phi_5041_ = _e2802;
                                } else {
                                    phi_5041_ = _e2806;
                                }
                                let _e2809 = phi_5041_;
                                if (_e2795[2] < 0f) {
                                    phi_5048_ = -(_e2795[2]);
                                } else {
                                    phi_5048_ = _e2795[2];
                                }
                                let _e2813 = phi_5048_;
                                if (_e2809 > _e2813) {
                                    phi_5053_ = _e2809;
                                } else {
                                    phi_5053_ = _e2813;
                                }
                                let _e2816 = phi_5053_;
                                if (_e2792 > _e2816) {
                                    phi_5058_ = _e2792;
                                } else {
                                    phi_5058_ = _e2816;
                                }
                                let _e2819 = phi_5058_;
                                let _e2821 = local.member_3;
                                let _e2822 = (_e2819 + _e2821);
                                let _e2825 = local.member_2[0u];
                                if (_e2825[0] < 0f) {
                                    phi_5075_ = -(_e2825[0]);
                                } else {
                                    phi_5075_ = _e2825[0];
                                }
                                let _e2832 = phi_5075_;
                                if (_e2825[1] < 0f) {
                                    phi_5082_ = -(_e2825[1]);
                                } else {
                                    phi_5082_ = _e2825[1];
                                }
                                let _e2836 = phi_5082_;
                                if (_e2832 > _e2836) {
                                    phi_5087_ = _e2832;
                                } else {
                                    phi_5087_ = _e2836;
                                }
                                let _e2839 = phi_5087_;
                                if (_e2825[2] < 0f) {
                                    phi_5094_ = -(_e2825[2]);
                                } else {
                                    phi_5094_ = _e2825[2];
                                }
                                let _e2843 = phi_5094_;
                                if (_e2839 > _e2843) {
                                    phi_5099_ = _e2839;
                                } else {
                                    phi_5099_ = _e2843;
                                }
                                let _e2846 = phi_5099_;
                                let _e2849 = local.member_2[1u];
                                if (_e2849[0] < 0f) {
                                    phi_5113_ = -(_e2849[0]);
                                } else {
                                    phi_5113_ = _e2849[0];
                                }
                                let _e2856 = phi_5113_;
                                if (_e2849[1] < 0f) {
                                    phi_5120_ = -(_e2849[1]);
                                } else {
                                    phi_5120_ = _e2849[1];
                                }
                                let _e2860 = phi_5120_;
                                if (_e2856 > _e2860) {
                                    phi_5125_ = _e2856;
                                } else {
                                    phi_5125_ = _e2860;
                                }
                                let _e2863 = phi_5125_;
                                if (_e2849[2] < 0f) {
                                    phi_5132_ = -(_e2849[2]);
                                } else {
                                    phi_5132_ = _e2849[2];
                                }
                                let _e2867 = phi_5132_;
                                if (_e2863 > _e2867) {
                                    phi_5137_ = _e2863;
                                } else {
                                    phi_5137_ = _e2867;
                                }
                                let _e2870 = phi_5137_;
                                if (_e2846 > _e2870) {
                                    phi_5142_ = _e2846;
                                } else {
                                    phi_5142_ = _e2870;
                                }
                                let _e2873 = phi_5142_;
                                let _e2875 = local.member_3;
                                let _e2876 = (_e2873 + _e2875);
                                let _e2878 = ((_e2822 * 8f) * _e2876);
                                let _e2885 = local.member_3;
                                if (_e2574 < 0f) {
                                    phi_5173_ = -(_e2574);
                                } else {
                                    phi_5173_ = _e2574;
                                }
                                let _e2902 = phi_5173_;
                                if (_e2577 < 0f) {
                                    phi_5179_ = -(_e2577);
                                } else {
                                    phi_5179_ = _e2577;
                                }
                                let _e2906 = phi_5179_;
                                if (_e2580 < 0f) {
                                    phi_5186_ = -(_e2580);
                                } else {
                                    phi_5186_ = _e2580;
                                }
                                let _e2911 = phi_5186_;
                                let _e2912 = ((_e2902 + _e2906) + _e2911);
                                if (_e2595 < 0f) {
                                    phi_5193_ = -(_e2595);
                                } else {
                                    phi_5193_ = _e2595;
                                }
                                let _e2916 = phi_5193_;
                                if (_e2598 < 0f) {
                                    phi_5199_ = -(_e2598);
                                } else {
                                    phi_5199_ = _e2598;
                                }
                                let _e2920 = phi_5199_;
                                if (_e2601 < 0f) {
                                    phi_5206_ = -(_e2601);
                                } else {
                                    phi_5206_ = _e2601;
                                }
                                let _e2925 = phi_5206_;
                                let _e2926 = ((_e2916 + _e2920) + _e2925);
                                if (_e2912 > _e2926) {
                                    phi_5212_ = _e2912;
                                } else {
                                    phi_5212_ = _e2926;
                                }
                                let _e2929 = phi_5212_;
                                if (_e2644 < 0f) {
                                    phi_5218_ = -(_e2644);
                                } else {
                                    phi_5218_ = _e2644;
                                }
                                let _e2933 = phi_5218_;
                                if (_e2645 < 0f) {
                                    phi_5224_ = -(_e2645);
                                } else {
                                    phi_5224_ = _e2645;
                                }
                                let _e2937 = phi_5224_;
                                if (_e2646 < 0f) {
                                    phi_5231_ = -(_e2646);
                                } else {
                                    phi_5231_ = _e2646;
                                }
                                let _e2942 = phi_5231_;
                                let _e2944 = (((_e2933 + _e2937) + _e2942) * 0.5f);
                                if (_e2929 > _e2944) {
                                    phi_5238_ = _e2929;
                                } else {
                                    phi_5238_ = _e2944;
                                }
                                let _e2947 = phi_5238_;
                                let _e2952 = local.member_3;
                                let _e2965 = ((((_e2649[0] * _e2574) + (_e2649[1] * _e2577)) + (_e2649[2] * _e2580)) * 3f);
                                let _e2966 = ((((_e2706[0] * _e2595) + (_e2706[1] * _e2598)) + (_e2706[2] * _e2601)) * 3f);
                                if (_e2965 < _e2966) {
                                    phi_5262_ = _e2965;
                                } else {
                                    phi_5262_ = _e2966;
                                }
                                let _e2969 = phi_5262_;
                                if (_e2680 < _e2703) {
                                    phi_5267_ = _e2680;
                                } else {
                                    phi_5267_ = _e2703;
                                }
                                let _e2972 = phi_5267_;
                                if (_e2969 < _e2972) {
                                    phi_5272_ = _e2969;
                                } else {
                                    phi_5272_ = _e2972;
                                }
                                let _e2975 = phi_5272_;
                                if (_e2965 > _e2966) {
                                    phi_5277_ = _e2965;
                                } else {
                                    phi_5277_ = _e2966;
                                }
                                let _e2978 = phi_5277_;
                                if (_e2680 > _e2703) {
                                    phi_5282_ = _e2680;
                                } else {
                                    phi_5282_ = _e2703;
                                }
                                let _e2981 = phi_5282_;
                                if (_e2978 > _e2981) {
                                    phi_5287_ = _e2978;
                                } else {
                                    phi_5287_ = _e2981;
                                }
                                let _e2984 = phi_5287_;
                                let _e2989 = -(_e2984);
                                if (_e2975 > _e2989) {
                                    phi_5297_ = _e2975;
                                } else {
                                    phi_5297_ = _e2989;
                                }
                                let _e2992 = phi_5297_;
                                let _e2994 = ((_e2992 - ((((((_e2768 * 8f) * _e2878) * (0.000000059604645f * (524f / 64f))) + ((_e2885 * 19f) * ((_e2768 * (_e2822 + _e2876)) + (_e2822 * _e2876)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2768) * ((1f + _e2822) * (1f + _e2876))))) + ((_e1449 * (((_e2947 + (_e2878 * (0.000000059604645f * 8f))) + ((_e2952 * 6f) * (_e2822 + _e2876))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2822) * (1f + _e2876))))) * (3f * 1.0001f)))) > 0f);
                                if _e2994 {
                                    phi_6266_ = _e2994;
                                } else {
                                    let _e2997 = local.member_1[0u];
                                    let _e3003 = local.member_1[1u];
                                    let _e3007 = (_e2997[0] + _e3003[0]);
                                    let _e3008 = (_e2997[1] + _e3003[1]);
                                    let _e3009 = (_e2997[2] + _e3003[2]);
                                    let _e3012 = local.member_2[0u];
                                    let _e3018 = local.member_2[1u];
                                    let _e3022 = (_e3012[0] + _e3018[0]);
                                    let _e3023 = (_e3012[1] + _e3018[1]);
                                    let _e3024 = (_e3012[2] + _e3018[2]);
                                    let _e3027 = ((_e3008 * _e3024) - (_e3009 * _e3023));
                                    let _e3030 = ((_e3009 * _e3022) - (_e3007 * _e3024));
                                    let _e3033 = ((_e3007 * _e3023) - (_e3008 * _e3022));
                                    let _e3036 = local.member[0u];
                                    let _e3042 = local.member_1[0u];
                                    let _e3048 = local.member_2[0u];
                                    let _e3052 = (_e3036[0] - _e3042[0]);
                                    let _e3053 = (_e3036[1] - _e3042[1]);
                                    let _e3054 = (_e3036[2] - _e3042[2]);
                                    let _e3055 = (_e3052 - _e3048[0]);
                                    let _e3056 = (_e3053 - _e3048[1]);
                                    let _e3057 = (_e3054 - _e3048[2]);
                                    let _e3058 = (_e3036[0] - _e3048[0]);
                                    let _e3059 = (_e3036[1] - _e3048[1]);
                                    let _e3060 = (_e3036[2] - _e3048[2]);
                                    let _e3063 = local.member[1u];
                                    let _e3069 = local.member_1[1u];
                                    let _e3075 = local.member_2[1u];
                                    let _e3079 = (_e3063[0] - _e3069[0]);
                                    let _e3080 = (_e3063[1] - _e3069[1]);
                                    let _e3081 = (_e3063[2] - _e3069[2]);
                                    let _e3082 = (_e3079 - _e3075[0]);
                                    let _e3083 = (_e3080 - _e3075[1]);
                                    let _e3084 = (_e3081 - _e3075[2]);
                                    let _e3085 = (_e3063[0] - _e3075[0]);
                                    let _e3086 = (_e3063[1] - _e3075[1]);
                                    let _e3087 = (_e3063[2] - _e3075[2]);
                                    let _e3090 = local.member[0u];
                                    if (_e3090[0] < 0f) {
                                        phi_5500_ = -(_e3090[0]);
                                    } else {
                                        phi_5500_ = _e3090[0];
                                    }
                                    let _e3097 = phi_5500_;
                                    if (_e3090[1] < 0f) {
                                        phi_5507_ = -(_e3090[1]);
                                    } else {
                                        phi_5507_ = _e3090[1];
                                    }
                                    let _e3101 = phi_5507_;
                                    if (_e3097 > _e3101) {
                                        phi_5512_ = _e3097;
                                    } else {
                                        phi_5512_ = _e3101;
                                    }
                                    let _e3104 = phi_5512_;
                                    if (_e3090[2] < 0f) {
                                        phi_5519_ = -(_e3090[2]);
                                    } else {
                                        phi_5519_ = _e3090[2];
                                    }
                                    let _e3108 = phi_5519_;
                                    if (_e3104 > _e3108) {
                                        phi_5524_ = _e3104;
                                    } else {
                                        phi_5524_ = _e3108;
                                    }
                                    let _e3111 = phi_5524_;
                                    let _e3114 = local.member[1u];
                                    if (_e3114[0] < 0f) {
                                        phi_5537_ = -(_e3114[0]);
                                    } else {
                                        phi_5537_ = _e3114[0];
                                    }
                                    let _e3121 = phi_5537_;
                                    if (_e3114[1] < 0f) {
                                        phi_5544_ = -(_e3114[1]);
                                    } else {
                                        phi_5544_ = _e3114[1];
                                    }
                                    let _e3125 = phi_5544_;
                                    if (_e3121 > _e3125) {
                                        phi_5549_ = _e3121;
                                    } else {
                                        phi_5549_ = _e3125;
                                    }
                                    let _e3128 = phi_5549_;
                                    if (_e3114[2] < 0f) {
                                        phi_5556_ = -(_e3114[2]);
                                    } else {
                                        phi_5556_ = _e3114[2];
                                    }
                                    let _e3132 = phi_5556_;
                                    if (_e3128 > _e3132) {
                                        phi_5561_ = _e3128;
                                    } else {
                                        phi_5561_ = _e3132;
                                    }
                                    let _e3135 = phi_5561_;
                                    if (_e3111 > _e3135) {
                                        phi_5566_ = _e3111;
                                    } else {
                                        phi_5566_ = _e3135;
                                    }
                                    let _e3138 = phi_5566_;
                                    let _e3140 = local.member_3;
                                    let _e3144 = local.member_1[0u];
                                    if (_e3144[0] < 0f) {
                                        phi_5583_ = -(_e3144[0]);
                                    } else {
                                        phi_5583_ = _e3144[0];
                                    }
                                    let _e3151 = phi_5583_;
                                    if (_e3144[1] < 0f) {
                                        phi_5590_ = -(_e3144[1]);
                                    } else {
                                        phi_5590_ = _e3144[1];
                                    }
                                    let _e3155 = phi_5590_;
                                    if (_e3151 > _e3155) {
                                        phi_5595_ = _e3151;
                                    } else {
                                        phi_5595_ = _e3155;
                                    }
                                    let _e3158 = phi_5595_;
                                    if (_e3144[2] < 0f) {
                                        phi_5602_ = -(_e3144[2]);
                                    } else {
                                        phi_5602_ = _e3144[2];
                                    }
                                    let _e3162 = phi_5602_;
                                    if (_e3158 > _e3162) {
                                        phi_5607_ = _e3158;
                                    } else {
                                        phi_5607_ = _e3162;
                                    }
                                    let _e3165 = phi_5607_;
                                    let _e3168 = local.member_1[1u];
                                    if (_e3168[0] < 0f) {
                                        phi_5621_ = -(_e3168[0]);
                                    } else {
                                        phi_5621_ = _e3168[0];
                                    }
                                    let _e3175 = phi_5621_;
                                    if (_e3168[1] < 0f) {
                                        phi_5628_ = -(_e3168[1]);
                                    } else {
                                        phi_5628_ = _e3168[1];
                                    }
                                    let _e3179 = phi_5628_;
                                    if (_e3175 > _e3179) {
                                        phi_5633_ = _e3175;
                                    } else {
                                        phi_5633_ = _e3179;
                                    }
                                    let _e3182 = phi_5633_;
                                    if (_e3168[2] < 0f) {
                                        phi_5640_ = -(_e3168[2]);
                                    } else {
                                        phi_5640_ = _e3168[2];
                                    }
                                    let _e3186 = phi_5640_;
                                    if (_e3182 > _e3186) {
                                        phi_5645_ = _e3182;
                                    } else {
                                        phi_5645_ = _e3186;
                                    }
                                    let _e3189 = phi_5645_;
                                    if (_e3165 > _e3189) {
                                        phi_5650_ = _e3165;
                                    } else {
                                        phi_5650_ = _e3189;
                                    }
                                    let _e3192 = phi_5650_;
                                    let _e3194 = local.member_3;
                                    let _e3198 = local.member_2[0u];
                                    if (_e3198[0] < 0f) {
                                        phi_5667_ = -(_e3198[0]);
                                    } else {
                                        phi_5667_ = _e3198[0];
                                    }
                                    let _e3205 = phi_5667_;
                                    if (_e3198[1] < 0f) {
                                        phi_5674_ = -(_e3198[1]);
                                    } else {
                                        phi_5674_ = _e3198[1];
                                    }
                                    let _e3209 = phi_5674_;
                                    if (_e3205 > _e3209) {
                                        phi_5679_ = _e3205;
                                    } else {
                                        phi_5679_ = _e3209;
                                    }
                                    let _e3212 = phi_5679_;
                                    if (_e3198[2] < 0f) {
                                        phi_5686_ = -(_e3198[2]);
                                    } else {
                                        phi_5686_ = _e3198[2];
                                    }
                                    let _e3216 = phi_5686_;
                                    if (_e3212 > _e3216) {
                                        phi_5691_ = _e3212;
                                    } else {
                                        phi_5691_ = _e3216;
                                    }
                                    let _e3219 = phi_5691_;
                                    let _e3222 = local.member_2[1u];
                                    if (_e3222[0] < 0f) {
                                        phi_5705_ = -(_e3222[0]);
                                    } else {
                                        phi_5705_ = _e3222[0];
                                    }
                                    let _e3229 = phi_5705_;
                                    if (_e3222[1] < 0f) {
                                        phi_5712_ = -(_e3222[1]);
                                    } else {
                                        phi_5712_ = _e3222[1];
                                    }
                                    let _e3233 = phi_5712_;
                                    if (_e3229 > _e3233) {
                                        phi_5717_ = _e3229;
                                    } else {
                                        phi_5717_ = _e3233;
                                    }
                                    let _e3236 = phi_5717_;
                                    if (_e3222[2] < 0f) {
                                        phi_5724_ = -(_e3222[2]);
                                    } else {
                                        phi_5724_ = _e3222[2];
                                    }
                                    let _e3240 = phi_5724_;
                                    if (_e3236 > _e3240) {
                                        phi_5729_ = _e3236;
                                    } else {
                                        phi_5729_ = _e3240;
                                    }
                                    let _e3243 = phi_5729_;
                                    if (_e3219 > _e3243) {
                                        phi_5734_ = _e3219;
                                    } else {
                                        phi_5734_ = _e3243;
                                    }
                                    let _e3246 = phi_5734_;
                                    let _e3248 = local.member_3;
                                    let _e3252 = ((((_e3138 + _e3140) + (_e3192 + _e3194)) + (_e3246 + _e3248)) * 2f);
                                    let _e3255 = local.member_3;
                                    let _e3259 = (((_e1449 * 1.0001f) + (_e3255 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3262 = ((_e3030 * _e3009) - (_e3033 * _e3008));
                                    let _e3265 = ((_e3033 * _e3007) - (_e3027 * _e3009));
                                    let _e3268 = ((_e3027 * _e3008) - (_e3030 * _e3007));
                                    let _e3273 = (((_e3262 * _e3036[0]) + (_e3265 * _e3036[1])) + (_e3268 * _e3036[2]));
                                    let _e3278 = (((_e3262 * _e3052) + (_e3265 * _e3053)) + (_e3268 * _e3054));
                                    let _e3283 = (((_e3262 * _e3058) + (_e3265 * _e3059)) + (_e3268 * _e3060));
                                    let _e3288 = (((_e3262 * _e3055) + (_e3265 * _e3056)) + (_e3268 * _e3057));
                                    let _e3293 = (((_e3262 * _e3063[0]) + (_e3265 * _e3063[1])) + (_e3268 * _e3063[2]));
                                    let _e3298 = (((_e3262 * _e3079) + (_e3265 * _e3080)) + (_e3268 * _e3081));
                                    let _e3303 = (((_e3262 * _e3085) + (_e3265 * _e3086)) + (_e3268 * _e3087));
                                    let _e3308 = (((_e3262 * _e3082) + (_e3265 * _e3083)) + (_e3268 * _e3084));
                                    if (_e3273 < _e3278) {
                                        phi_5813_ = _e3273;
                                    } else {
                                        phi_5813_ = _e3278;
                                    }
                                    let _e3311 = phi_5813_;
                                    if (_e3283 < _e3288) {
                                        phi_5818_ = _e3283;
                                    } else {
                                        phi_5818_ = _e3288;
                                    }
                                    let _e3314 = phi_5818_;
                                    if (_e3311 < _e3314) {
                                        phi_5823_ = _e3311;
                                    } else {
                                        phi_5823_ = _e3314;
                                    }
                                    let _e3317 = phi_5823_;
                                    if (_e3293 < _e3298) {
                                        phi_5828_ = _e3293;
                                    } else {
                                        phi_5828_ = _e3298;
                                    }
                                    let _e3320 = phi_5828_;
                                    if (_e3303 < _e3308) {
                                        phi_5833_ = _e3303;
                                    } else {
                                        phi_5833_ = _e3308;
                                    }
                                    let _e3323 = phi_5833_;
                                    if (_e3320 < _e3323) {
                                        phi_5838_ = _e3320;
                                    } else {
                                        phi_5838_ = _e3323;
                                    }
                                    let _e3326 = phi_5838_;
                                    if (_e3317 < _e3326) {
                                        phi_5843_ = _e3317;
                                    } else {
                                        phi_5843_ = _e3326;
                                    }
                                    let _e3329 = phi_5843_;
                                    if (_e3273 > _e3278) {
                                        phi_5848_ = _e3273;
                                    } else {
                                        phi_5848_ = _e3278;
                                    }
                                    let _e3332 = phi_5848_;
                                    if (_e3283 > _e3288) {
                                        phi_5853_ = _e3283;
                                    } else {
                                        phi_5853_ = _e3288;
                                    }
                                    let _e3335 = phi_5853_;
                                    if (_e3332 > _e3335) {
                                        phi_5858_ = _e3332;
                                    } else {
                                        phi_5858_ = _e3335;
                                    }
                                    let _e3338 = phi_5858_;
                                    if (_e3293 > _e3298) {
                                        phi_5863_ = _e3293;
                                    } else {
                                        phi_5863_ = _e3298;
                                    }
                                    let _e3341 = phi_5863_;
                                    if (_e3303 > _e3308) {
                                        phi_5868_ = _e3303;
                                    } else {
                                        phi_5868_ = _e3308;
                                    }
                                    let _e3344 = phi_5868_;
                                    if (_e3341 > _e3344) {
                                        phi_5873_ = _e3341;
                                    } else {
                                        phi_5873_ = _e3344;
                                    }
                                    let _e3347 = phi_5873_;
                                    if (_e3338 > _e3347) {
                                        phi_5878_ = _e3338;
                                    } else {
                                        phi_5878_ = _e3347;
                                    }
                                    let _e3350 = phi_5878_;
                                    if (_e3262 < 0f) {
                                        phi_5884_ = -(_e3262);
                                    } else {
                                        phi_5884_ = _e3262;
                                    }
                                    let _e3354 = phi_5884_;
                                    if (_e3265 < 0f) {
                                        phi_5890_ = -(_e3265);
                                    } else {
                                        phi_5890_ = _e3265;
                                    }
                                    let _e3358 = phi_5890_;
                                    if (_e3268 < 0f) {
                                        phi_5897_ = -(_e3268);
                                    } else {
                                        phi_5897_ = _e3268;
                                    }
                                    let _e3363 = phi_5897_;
                                    let _e3364 = ((_e3354 + _e3358) + _e3363);
                                    let _e3369 = -(_e3350);
                                    if (_e3329 > _e3369) {
                                        phi_5908_ = _e3329;
                                    } else {
                                        phi_5908_ = _e3369;
                                    }
                                    let _e3372 = phi_5908_;
                                    let _e3377 = (((_e3372 - ((_e3364 * _e3252) * (0.000000059604645f * (17f / 2f)))) - (_e3364 * _e3259)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3380 = ((_e3030 * _e3024) - (_e3033 * _e3023));
                                    let _e3383 = ((_e3033 * _e3022) - (_e3027 * _e3024));
                                    let _e3386 = ((_e3027 * _e3023) - (_e3030 * _e3022));
                                    let _e3391 = (((_e3380 * _e3036[0]) + (_e3383 * _e3036[1])) + (_e3386 * _e3036[2]));
                                    let _e3396 = (((_e3380 * _e3052) + (_e3383 * _e3053)) + (_e3386 * _e3054));
                                    let _e3401 = (((_e3380 * _e3058) + (_e3383 * _e3059)) + (_e3386 * _e3060));
                                    let _e3406 = (((_e3380 * _e3055) + (_e3383 * _e3056)) + (_e3386 * _e3057));
                                    let _e3411 = (((_e3380 * _e3063[0]) + (_e3383 * _e3063[1])) + (_e3386 * _e3063[2]));
                                    let _e3416 = (((_e3380 * _e3079) + (_e3383 * _e3080)) + (_e3386 * _e3081));
                                    let _e3421 = (((_e3380 * _e3085) + (_e3383 * _e3086)) + (_e3386 * _e3087));
                                    let _e3426 = (((_e3380 * _e3082) + (_e3383 * _e3083)) + (_e3386 * _e3084));
                                    if (_e3391 < _e3396) {
                                        phi_5979_ = _e3391;
                                    } else {
                                        phi_5979_ = _e3396;
                                    }
                                    let _e3429 = phi_5979_;
                                    if (_e3401 < _e3406) {
                                        phi_5984_ = _e3401;
                                    } else {
                                        phi_5984_ = _e3406;
                                    }
                                    let _e3432 = phi_5984_;
                                    if (_e3429 < _e3432) {
                                        phi_5989_ = _e3429;
                                    } else {
                                        phi_5989_ = _e3432;
                                    }
                                    let _e3435 = phi_5989_;
                                    if (_e3411 < _e3416) {
                                        phi_5994_ = _e3411;
                                    } else {
                                        phi_5994_ = _e3416;
                                    }
                                    let _e3438 = phi_5994_;
                                    if (_e3421 < _e3426) {
                                        phi_5999_ = _e3421;
                                    } else {
                                        phi_5999_ = _e3426;
                                    }
                                    let _e3441 = phi_5999_;
                                    if (_e3438 < _e3441) {
                                        phi_6004_ = _e3438;
                                    } else {
                                        phi_6004_ = _e3441;
                                    }
                                    let _e3444 = phi_6004_;
                                    if (_e3435 < _e3444) {
                                        phi_6009_ = _e3435;
                                    } else {
                                        phi_6009_ = _e3444;
                                    }
                                    let _e3447 = phi_6009_;
                                    if (_e3391 > _e3396) {
                                        phi_6014_ = _e3391;
                                    } else {
                                        phi_6014_ = _e3396;
                                    }
                                    let _e3450 = phi_6014_;
                                    if (_e3401 > _e3406) {
                                        phi_6019_ = _e3401;
                                    } else {
                                        phi_6019_ = _e3406;
                                    }
                                    let _e3453 = phi_6019_;
                                    if (_e3450 > _e3453) {
                                        phi_6024_ = _e3450;
                                    } else {
                                        phi_6024_ = _e3453;
                                    }
                                    let _e3456 = phi_6024_;
                                    if (_e3411 > _e3416) {
                                        phi_6029_ = _e3411;
                                    } else {
                                        phi_6029_ = _e3416;
                                    }
                                    let _e3459 = phi_6029_;
                                    if (_e3421 > _e3426) {
                                        phi_6034_ = _e3421;
                                    } else {
                                        phi_6034_ = _e3426;
                                    }
                                    let _e3462 = phi_6034_;
                                    if (_e3459 > _e3462) {
                                        phi_6039_ = _e3459;
                                    } else {
                                        phi_6039_ = _e3462;
                                    }
                                    let _e3465 = phi_6039_;
                                    if (_e3456 > _e3465) {
                                        phi_6044_ = _e3456;
                                    } else {
                                        phi_6044_ = _e3465;
                                    }
                                    let _e3468 = phi_6044_;
                                    if (_e3380 < 0f) {
                                        phi_6050_ = -(_e3380);
                                    } else {
                                        phi_6050_ = _e3380;
                                    }
                                    let _e3472 = phi_6050_;
                                    if (_e3383 < 0f) {
                                        phi_6056_ = -(_e3383);
                                    } else {
                                        phi_6056_ = _e3383;
                                    }
                                    let _e3476 = phi_6056_;
                                    if (_e3386 < 0f) {
                                        phi_6063_ = -(_e3386);
                                    } else {
                                        phi_6063_ = _e3386;
                                    }
                                    let _e3481 = phi_6063_;
                                    let _e3482 = ((_e3472 + _e3476) + _e3481);
                                    let _e3487 = -(_e3468);
                                    if (_e3447 > _e3487) {
                                        phi_6074_ = _e3447;
                                    } else {
                                        phi_6074_ = _e3487;
                                    }
                                    let _e3490 = phi_6074_;
                                    let _e3495 = (((_e3490 - ((_e3482 * _e3252) * (0.000000059604645f * (17f / 2f)))) - (_e3482 * _e3259)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3377 > _e3495) {
                                        phi_6084_ = _e3377;
                                    } else {
                                        phi_6084_ = _e3495;
                                    }
                                    let _e3498 = phi_6084_;
                                    phi_6266_ = (_e2994 || (_e3498 > 0f));
                                }
                                let _e3502 = phi_6266_;
                                if _e3502 {
                                    let _e3505 = local_1.member_1[0u];
                                    let _e3511 = local_1.member_2[0u];
                                    let _e3517 = ((_e3505[1] * _e3511[2]) - (_e3505[2] * _e3511[1]));
                                    let _e3520 = ((_e3505[2] * _e3511[0]) - (_e3505[0] * _e3511[2]));
                                    let _e3523 = ((_e3505[0] * _e3511[1]) - (_e3505[1] * _e3511[0]));
                                    let _e3526 = local_1.member_1[1u];
                                    let _e3532 = local_1.member_2[1u];
                                    let _e3538 = ((_e3526[1] * _e3532[2]) - (_e3526[2] * _e3532[1]));
                                    let _e3541 = ((_e3526[2] * _e3532[0]) - (_e3526[0] * _e3532[2]));
                                    let _e3544 = ((_e3526[0] * _e3532[1]) - (_e3526[1] * _e3532[0]));
                                    let _e3547 = local_1.member_1[0u];
                                    let _e3553 = local_1.member_2[1u];
                                    let _e3568 = local_1.member_1[1u];
                                    let _e3574 = local_1.member_2[0u];
                                    let _e3587 = (((_e3547[1] * _e3553[2]) - (_e3547[2] * _e3553[1])) + ((_e3568[1] * _e3574[2]) - (_e3568[2] * _e3574[1])));
                                    let _e3588 = (((_e3547[2] * _e3553[0]) - (_e3547[0] * _e3553[2])) + ((_e3568[2] * _e3574[0]) - (_e3568[0] * _e3574[2])));
                                    let _e3589 = (((_e3547[0] * _e3553[1]) - (_e3547[1] * _e3553[0])) + ((_e3568[0] * _e3574[1]) - (_e3568[1] * _e3574[0])));
                                    let _e3592 = local_1.member[0u];
                                    let _e3603 = local_1.member[1u];
                                    let _e3614 = local_1.member[0u];
                                    let _e3623 = ((((_e3603[0] * _e3517) + (_e3603[1] * _e3520)) + (_e3603[2] * _e3523)) + (((_e3614[0] * _e3587) + (_e3614[1] * _e3588)) + (_e3614[2] * _e3589)));
                                    let _e3626 = local_1.member[0u];
                                    let _e3637 = local_1.member[1u];
                                    let _e3646 = ((((_e3626[0] * _e3538) + (_e3626[1] * _e3541)) + (_e3626[2] * _e3544)) + (((_e3637[0] * _e3587) + (_e3637[1] * _e3588)) + (_e3637[2] * _e3589)));
                                    let _e3649 = local_1.member[1u];
                                    let _e3660 = local_1.member[0u];
                                    if (_e3660[0] < 0f) {
                                        phi_6511_ = -(_e3660[0]);
                                    } else {
                                        phi_6511_ = _e3660[0];
                                    }
                                    let _e3667 = phi_6511_;
                                    if (_e3660[1] < 0f) {
                                        phi_6518_ = -(_e3660[1]);
                                    } else {
                                        phi_6518_ = _e3660[1];
                                    }
                                    let _e3671 = phi_6518_;
                                    if (_e3667 > _e3671) {
                                        phi_6523_ = _e3667;
                                    } else {
                                        phi_6523_ = _e3671;
                                    }
                                    let _e3674 = phi_6523_;
                                    if (_e3660[2] < 0f) {
                                        phi_6530_ = -(_e3660[2]);
                                    } else {
                                        phi_6530_ = _e3660[2];
                                    }
                                    let _e3678 = phi_6530_;
                                    if (_e3674 > _e3678) {
                                        phi_6535_ = _e3674;
                                    } else {
                                        phi_6535_ = _e3678;
                                    }
                                    let _e3681 = phi_6535_;
                                    let _e3684 = local_1.member[1u];
                                    if (_e3684[0] < 0f) {
                                        phi_6548_ = -(_e3684[0]);
                                    } else {
                                        phi_6548_ = _e3684[0];
                                    }
                                    let _e3691 = phi_6548_;
                                    if (_e3684[1] < 0f) {
                                        phi_6555_ = -(_e3684[1]);
                                    } else {
                                        phi_6555_ = _e3684[1];
                                    }
                                    let _e3695 = phi_6555_;
                                    if (_e3691 > _e3695) {
                                        phi_6560_ = _e3691;
                                    } else {
                                        phi_6560_ = _e3695;
                                    }
                                    let _e3698 = phi_6560_;
                                    if (_e3684[2] < 0f) {
                                        phi_6567_ = -(_e3684[2]);
                                    } else {
                                        phi_6567_ = _e3684[2];
                                    }
                                    let _e3702 = phi_6567_;
                                    if (_e3698 > _e3702) {
                                        phi_6572_ = _e3698;
                                    } else {
                                        phi_6572_ = _e3702;
                                    }
                                    let _e3705 = phi_6572_;
                                    if (_e3681 > _e3705) {
                                        phi_6577_ = _e3681;
                                    } else {
                                        phi_6577_ = _e3705;
                                    }
                                    let _e3708 = phi_6577_;
                                    let _e3710 = local_1.member_3;
                                    let _e3711 = (_e3708 + _e3710);
                                    let _e3714 = local_1.member_1[0u];
                                    if (_e3714[0] < 0f) {
                                        phi_6594_ = -(_e3714[0]);
                                    } else {
                                        phi_6594_ = _e3714[0];
                                    }
                                    let _e3721 = phi_6594_;
                                    if (_e3714[1] < 0f) {
                                        phi_6601_ = -(_e3714[1]);
                                    } else {
                                        phi_6601_ = _e3714[1];
                                    }
                                    let _e3725 = phi_6601_;
                                    if (_e3721 > _e3725) {
                                        phi_6606_ = _e3721;
                                    } else {
                                        phi_6606_ = _e3725;
                                    }
                                    let _e3728 = phi_6606_;
                                    if (_e3714[2] < 0f) {
                                        phi_6613_ = -(_e3714[2]);
                                    } else {
                                        phi_6613_ = _e3714[2];
                                    }
                                    let _e3732 = phi_6613_;
                                    if (_e3728 > _e3732) {
                                        phi_6618_ = _e3728;
                                    } else {
                                        phi_6618_ = _e3732;
                                    }
                                    let _e3735 = phi_6618_;
                                    let _e3738 = local_1.member_1[1u];
                                    if (_e3738[0] < 0f) {
                                        phi_6632_ = -(_e3738[0]);
                                    } else {
                                        phi_6632_ = _e3738[0];
                                    }
                                    let _e3745 = phi_6632_;
                                    if (_e3738[1] < 0f) {
                                        phi_6639_ = -(_e3738[1]);
                                    } else {
                                        phi_6639_ = _e3738[1];
                                    }
                                    let _e3749 = phi_6639_;
                                    if (_e3745 > _e3749) {
                                        phi_6644_ = _e3745;
                                    } else {
                                        phi_6644_ = _e3749;
                                    }
                                    let _e3752 = phi_6644_;
                                    if (_e3738[2] < 0f) {
                                        phi_6651_ = -(_e3738[2]);
                                    } else {
                                        phi_6651_ = _e3738[2];
                                    }
                                    let _e3756 = phi_6651_;
                                    if (_e3752 > _e3756) {
                                        phi_6656_ = _e3752;
                                    } else {
                                        phi_6656_ = _e3756;
                                    }
                                    let _e3759 = phi_6656_;
                                    if (_e3735 > _e3759) {
                                        phi_6661_ = _e3735;
                                    } else {
                                        phi_6661_ = _e3759;
                                    }
                                    let _e3762 = phi_6661_;
                                    let _e3764 = local_1.member_3;
                                    let _e3765 = (_e3762 + _e3764);
                                    let _e3768 = local_1.member_2[0u];
                                    if (_e3768[0] < 0f) {
                                        phi_6678_ = -(_e3768[0]);
                                    } else {
                                        phi_6678_ = _e3768[0];
                                    }
                                    let _e3775 = phi_6678_;
                                    if (_e3768[1] < 0f) {
                                        phi_6685_ = -(_e3768[1]);
                                    } else {
                                        phi_6685_ = _e3768[1];
                                    }
                                    let _e3779 = phi_6685_;
                                    if (_e3775 > _e3779) {
                                        phi_6690_ = _e3775;
                                    } else {
                                        phi_6690_ = _e3779;
                                    }
                                    let _e3782 = phi_6690_;
                                    if (_e3768[2] < 0f) {
                                        phi_6697_ = -(_e3768[2]);
                                    } else {
                                        phi_6697_ = _e3768[2];
                                    }
                                    let _e3786 = phi_6697_;
                                    if (_e3782 > _e3786) {
                                        phi_6702_ = _e3782;
                                    } else {
                                        phi_6702_ = _e3786;
                                    }
                                    let _e3789 = phi_6702_;
                                    let _e3792 = local_1.member_2[1u];
                                    if (_e3792[0] < 0f) {
                                        phi_6716_ = -(_e3792[0]);
                                    } else {
                                        phi_6716_ = _e3792[0];
                                    }
                                    let _e3799 = phi_6716_;
                                    if (_e3792[1] < 0f) {
                                        phi_6723_ = -(_e3792[1]);
                                    } else {
                                        phi_6723_ = _e3792[1];
                                    }
                                    let _e3803 = phi_6723_;
                                    if (_e3799 > _e3803) {
                                        phi_6728_ = _e3799;
                                    } else {
                                        phi_6728_ = _e3803;
                                    }
                                    let _e3806 = phi_6728_;
                                    if (_e3792[2] < 0f) {
                                        phi_6735_ = -(_e3792[2]);
                                    } else {
                                        phi_6735_ = _e3792[2];
                                    }
                                    let _e3810 = phi_6735_;
                                    if (_e3806 > _e3810) {
                                        phi_6740_ = _e3806;
                                    } else {
                                        phi_6740_ = _e3810;
                                    }
                                    let _e3813 = phi_6740_;
                                    if (_e3789 > _e3813) {
                                        phi_6745_ = _e3789;
                                    } else {
                                        phi_6745_ = _e3813;
                                    }
                                    let _e3816 = phi_6745_;
                                    let _e3818 = local_1.member_3;
                                    let _e3819 = (_e3816 + _e3818);
                                    let _e3821 = ((_e3765 * 8f) * _e3819);
                                    let _e3828 = local_1.member_3;
                                    if (_e3517 < 0f) {
                                        phi_6776_ = -(_e3517);
                                    } else {
                                        phi_6776_ = _e3517;
                                    }
                                    let _e3845 = phi_6776_;
                                    if (_e3520 < 0f) {
                                        phi_6782_ = -(_e3520);
                                    } else {
                                        phi_6782_ = _e3520;
                                    }
                                    let _e3849 = phi_6782_;
                                    if (_e3523 < 0f) {
                                        phi_6789_ = -(_e3523);
                                    } else {
                                        phi_6789_ = _e3523;
                                    }
                                    let _e3854 = phi_6789_;
                                    let _e3855 = ((_e3845 + _e3849) + _e3854);
                                    if (_e3538 < 0f) {
                                        phi_6796_ = -(_e3538);
                                    } else {
                                        phi_6796_ = _e3538;
                                    }
                                    let _e3859 = phi_6796_;
                                    if (_e3541 < 0f) {
                                        phi_6802_ = -(_e3541);
                                    } else {
                                        phi_6802_ = _e3541;
                                    }
                                    let _e3863 = phi_6802_;
                                    if (_e3544 < 0f) {
                                        phi_6809_ = -(_e3544);
                                    } else {
                                        phi_6809_ = _e3544;
                                    }
                                    let _e3868 = phi_6809_;
                                    let _e3869 = ((_e3859 + _e3863) + _e3868);
                                    if (_e3855 > _e3869) {
                                        phi_6815_ = _e3855;
                                    } else {
                                        phi_6815_ = _e3869;
                                    }
                                    let _e3872 = phi_6815_;
                                    if (_e3587 < 0f) {
                                        phi_6821_ = -(_e3587);
                                    } else {
                                        phi_6821_ = _e3587;
                                    }
                                    let _e3876 = phi_6821_;
                                    if (_e3588 < 0f) {
                                        phi_6827_ = -(_e3588);
                                    } else {
                                        phi_6827_ = _e3588;
                                    }
                                    let _e3880 = phi_6827_;
                                    if (_e3589 < 0f) {
                                        phi_6834_ = -(_e3589);
                                    } else {
                                        phi_6834_ = _e3589;
                                    }
                                    let _e3885 = phi_6834_;
                                    let _e3887 = (((_e3876 + _e3880) + _e3885) * 0.5f);
                                    if (_e3872 > _e3887) {
                                        phi_6841_ = _e3872;
                                    } else {
                                        phi_6841_ = _e3887;
                                    }
                                    let _e3890 = phi_6841_;
                                    let _e3895 = local_1.member_3;
                                    let _e3908 = ((((_e3592[0] * _e3517) + (_e3592[1] * _e3520)) + (_e3592[2] * _e3523)) * 3f);
                                    let _e3909 = ((((_e3649[0] * _e3538) + (_e3649[1] * _e3541)) + (_e3649[2] * _e3544)) * 3f);
                                    if (_e3908 < _e3909) {
                                        phi_6865_ = _e3908;
                                    } else {
                                        phi_6865_ = _e3909;
                                    }
                                    let _e3912 = phi_6865_;
                                    if (_e3623 < _e3646) {
                                        phi_6870_ = _e3623;
                                    } else {
                                        phi_6870_ = _e3646;
                                    }
                                    let _e3915 = phi_6870_;
                                    if (_e3912 < _e3915) {
                                        phi_6875_ = _e3912;
                                    } else {
                                        phi_6875_ = _e3915;
                                    }
                                    let _e3918 = phi_6875_;
                                    if (_e3908 > _e3909) {
                                        phi_6880_ = _e3908;
                                    } else {
                                        phi_6880_ = _e3909;
                                    }
                                    let _e3921 = phi_6880_;
                                    if (_e3623 > _e3646) {
                                        phi_6885_ = _e3623;
                                    } else {
                                        phi_6885_ = _e3646;
                                    }
                                    let _e3924 = phi_6885_;
                                    if (_e3921 > _e3924) {
                                        phi_6890_ = _e3921;
                                    } else {
                                        phi_6890_ = _e3924;
                                    }
                                    let _e3927 = phi_6890_;
                                    let _e3932 = -(_e3927);
                                    if (_e3918 > _e3932) {
                                        phi_6900_ = _e3918;
                                    } else {
                                        phi_6900_ = _e3932;
                                    }
                                    let _e3935 = phi_6900_;
                                    let _e3937 = ((_e3935 - ((((((_e3711 * 8f) * _e3821) * (0.000000059604645f * (524f / 64f))) + ((_e3828 * 19f) * ((_e3711 * (_e3765 + _e3819)) + (_e3765 * _e3819)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3711) * ((1f + _e3765) * (1f + _e3819))))) + ((_e1449 * (((_e3890 + (_e3821 * (0.000000059604645f * 8f))) + ((_e3895 * 6f) * (_e3765 + _e3819))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3765) * (1f + _e3819))))) * (3f * 1.0001f)))) > 0f);
                                    if _e3937 {
                                        phi_7869_ = _e3937;
                                    } else {
                                        let _e3940 = local_1.member_1[0u];
                                        let _e3946 = local_1.member_1[1u];
                                        let _e3950 = (_e3940[0] + _e3946[0]);
                                        let _e3951 = (_e3940[1] + _e3946[1]);
                                        let _e3952 = (_e3940[2] + _e3946[2]);
                                        let _e3955 = local_1.member_2[0u];
                                        let _e3961 = local_1.member_2[1u];
                                        let _e3965 = (_e3955[0] + _e3961[0]);
                                        let _e3966 = (_e3955[1] + _e3961[1]);
                                        let _e3967 = (_e3955[2] + _e3961[2]);
                                        let _e3970 = ((_e3951 * _e3967) - (_e3952 * _e3966));
                                        let _e3973 = ((_e3952 * _e3965) - (_e3950 * _e3967));
                                        let _e3976 = ((_e3950 * _e3966) - (_e3951 * _e3965));
                                        let _e3979 = local_1.member[0u];
                                        let _e3985 = local_1.member_1[0u];
                                        let _e3991 = local_1.member_2[0u];
                                        let _e3995 = (_e3979[0] - _e3985[0]);
                                        let _e3996 = (_e3979[1] - _e3985[1]);
                                        let _e3997 = (_e3979[2] - _e3985[2]);
                                        let _e3998 = (_e3995 - _e3991[0]);
                                        let _e3999 = (_e3996 - _e3991[1]);
                                        let _e4000 = (_e3997 - _e3991[2]);
                                        let _e4001 = (_e3979[0] - _e3991[0]);
                                        let _e4002 = (_e3979[1] - _e3991[1]);
                                        let _e4003 = (_e3979[2] - _e3991[2]);
                                        let _e4006 = local_1.member[1u];
                                        let _e4012 = local_1.member_1[1u];
                                        let _e4018 = local_1.member_2[1u];
                                        let _e4022 = (_e4006[0] - _e4012[0]);
                                        let _e4023 = (_e4006[1] - _e4012[1]);
                                        let _e4024 = (_e4006[2] - _e4012[2]);
                                        let _e4025 = (_e4022 - _e4018[0]);
                                        let _e4026 = (_e4023 - _e4018[1]);
                                        let _e4027 = (_e4024 - _e4018[2]);
                                        let _e4028 = (_e4006[0] - _e4018[0]);
                                        let _e4029 = (_e4006[1] - _e4018[1]);
                                        let _e4030 = (_e4006[2] - _e4018[2]);
                                        let _e4033 = local_1.member[0u];
                                        if (_e4033[0] < 0f) {
                                            phi_7103_ = -(_e4033[0]);
                                        } else {
                                            phi_7103_ = _e4033[0];
                                        }
                                        let _e4040 = phi_7103_;
                                        if (_e4033[1] < 0f) {
                                            phi_7110_ = -(_e4033[1]);
                                        } else {
                                            phi_7110_ = _e4033[1];
                                        }
                                        let _e4044 = phi_7110_;
                                        if (_e4040 > _e4044) {
                                            phi_7115_ = _e4040;
                                        } else {
                                            phi_7115_ = _e4044;
                                        }
                                        let _e4047 = phi_7115_;
                                        if (_e4033[2] < 0f) {
                                            phi_7122_ = -(_e4033[2]);
                                        } else {
                                            phi_7122_ = _e4033[2];
                                        }
                                        let _e4051 = phi_7122_;
                                        if (_e4047 > _e4051) {
                                            phi_7127_ = _e4047;
                                        } else {
                                            phi_7127_ = _e4051;
                                        }
                                        let _e4054 = phi_7127_;
                                        let _e4057 = local_1.member[1u];
                                        if (_e4057[0] < 0f) {
                                            phi_7140_ = -(_e4057[0]);
                                        } else {
                                            phi_7140_ = _e4057[0];
                                        }
                                        let _e4064 = phi_7140_;
                                        if (_e4057[1] < 0f) {
                                            phi_7147_ = -(_e4057[1]);
                                        } else {
                                            phi_7147_ = _e4057[1];
                                        }
                                        let _e4068 = phi_7147_;
                                        if (_e4064 > _e4068) {
                                            phi_7152_ = _e4064;
                                        } else {
                                            phi_7152_ = _e4068;
                                        }
                                        let _e4071 = phi_7152_;
                                        if (_e4057[2] < 0f) {
                                            phi_7159_ = -(_e4057[2]);
                                        } else {
                                            phi_7159_ = _e4057[2];
                                        }
                                        let _e4075 = phi_7159_;
                                        if (_e4071 > _e4075) {
                                            phi_7164_ = _e4071;
                                        } else {
                                            phi_7164_ = _e4075;
                                        }
                                        let _e4078 = phi_7164_;
                                        if (_e4054 > _e4078) {
                                            phi_7169_ = _e4054;
                                        } else {
                                            phi_7169_ = _e4078;
                                        }
                                        let _e4081 = phi_7169_;
                                        let _e4083 = local_1.member_3;
                                        let _e4087 = local_1.member_1[0u];
                                        if (_e4087[0] < 0f) {
                                            phi_7186_ = -(_e4087[0]);
                                        } else {
                                            phi_7186_ = _e4087[0];
                                        }
                                        let _e4094 = phi_7186_;
                                        if (_e4087[1] < 0f) {
                                            phi_7193_ = -(_e4087[1]);
                                        } else {
                                            phi_7193_ = _e4087[1];
                                        }
                                        let _e4098 = phi_7193_;
                                        if (_e4094 > _e4098) {
                                            phi_7198_ = _e4094;
                                        } else {
                                            phi_7198_ = _e4098;
                                        }
                                        let _e4101 = phi_7198_;
                                        if (_e4087[2] < 0f) {
                                            phi_7205_ = -(_e4087[2]);
                                        } else {
                                            phi_7205_ = _e4087[2];
                                        }
                                        let _e4105 = phi_7205_;
                                        if (_e4101 > _e4105) {
                                            phi_7210_ = _e4101;
                                        } else {
                                            phi_7210_ = _e4105;
                                        }
                                        let _e4108 = phi_7210_;
                                        let _e4111 = local_1.member_1[1u];
                                        if (_e4111[0] < 0f) {
                                            phi_7224_ = -(_e4111[0]);
                                        } else {
                                            phi_7224_ = _e4111[0];
                                        }
                                        let _e4118 = phi_7224_;
                                        if (_e4111[1] < 0f) {
                                            phi_7231_ = -(_e4111[1]);
                                        } else {
                                            phi_7231_ = _e4111[1];
                                        }
                                        let _e4122 = phi_7231_;
                                        if (_e4118 > _e4122) {
                                            phi_7236_ = _e4118;
                                        } else {
                                            phi_7236_ = _e4122;
                                        }
                                        let _e4125 = phi_7236_;
                                        if (_e4111[2] < 0f) {
                                            phi_7243_ = -(_e4111[2]);
                                        } else {
                                            phi_7243_ = _e4111[2];
                                        }
                                        let _e4129 = phi_7243_;
                                        if (_e4125 > _e4129) {
                                            phi_7248_ = _e4125;
                                        } else {
                                            phi_7248_ = _e4129;
                                        }
                                        let _e4132 = phi_7248_;
                                        if (_e4108 > _e4132) {
                                            phi_7253_ = _e4108;
                                        } else {
                                            phi_7253_ = _e4132;
                                        }
                                        let _e4135 = phi_7253_;
                                        let _e4137 = local_1.member_3;
                                        let _e4141 = local_1.member_2[0u];
                                        if (_e4141[0] < 0f) {
                                            phi_7270_ = -(_e4141[0]);
                                        } else {
                                            phi_7270_ = _e4141[0];
                                        }
                                        let _e4148 = phi_7270_;
                                        if (_e4141[1] < 0f) {
                                            phi_7277_ = -(_e4141[1]);
                                        } else {
                                            phi_7277_ = _e4141[1];
                                        }
                                        let _e4152 = phi_7277_;
                                        if (_e4148 > _e4152) {
                                            phi_7282_ = _e4148;
                                        } else {
                                            phi_7282_ = _e4152;
                                        }
                                        let _e4155 = phi_7282_;
                                        if (_e4141[2] < 0f) {
                                            phi_7289_ = -(_e4141[2]);
                                        } else {
                                            phi_7289_ = _e4141[2];
                                        }
                                        let _e4159 = phi_7289_;
                                        if (_e4155 > _e4159) {
                                            phi_7294_ = _e4155;
                                        } else {
                                            phi_7294_ = _e4159;
                                        }
                                        let _e4162 = phi_7294_;
                                        let _e4165 = local_1.member_2[1u];
                                        if (_e4165[0] < 0f) {
                                            phi_7308_ = -(_e4165[0]);
                                        } else {
                                            phi_7308_ = _e4165[0];
                                        }
                                        let _e4172 = phi_7308_;
                                        if (_e4165[1] < 0f) {
                                            phi_7315_ = -(_e4165[1]);
                                        } else {
                                            phi_7315_ = _e4165[1];
                                        }
                                        let _e4176 = phi_7315_;
                                        if (_e4172 > _e4176) {
                                            phi_7320_ = _e4172;
                                        } else {
                                            phi_7320_ = _e4176;
                                        }
                                        let _e4179 = phi_7320_;
                                        if (_e4165[2] < 0f) {
                                            phi_7327_ = -(_e4165[2]);
                                        } else {
                                            phi_7327_ = _e4165[2];
                                        }
                                        let _e4183 = phi_7327_;
                                        if (_e4179 > _e4183) {
                                            phi_7332_ = _e4179;
                                        } else {
                                            phi_7332_ = _e4183;
                                        }
                                        let _e4186 = phi_7332_;
                                        if (_e4162 > _e4186) {
                                            phi_7337_ = _e4162;
                                        } else {
                                            phi_7337_ = _e4186;
                                        }
                                        let _e4189 = phi_7337_;
                                        let _e4191 = local_1.member_3;
                                        let _e4195 = ((((_e4081 + _e4083) + (_e4135 + _e4137)) + (_e4189 + _e4191)) * 2f);
                                        let _e4198 = local_1.member_3;
                                        let _e4202 = (((_e1449 * 1.0001f) + (_e4198 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4205 = ((_e3973 * _e3952) - (_e3976 * _e3951));
                                        let _e4208 = ((_e3976 * _e3950) - (_e3970 * _e3952));
                                        let _e4211 = ((_e3970 * _e3951) - (_e3973 * _e3950));
                                        let _e4216 = (((_e4205 * _e3979[0]) + (_e4208 * _e3979[1])) + (_e4211 * _e3979[2]));
                                        let _e4221 = (((_e4205 * _e3995) + (_e4208 * _e3996)) + (_e4211 * _e3997));
                                        let _e4226 = (((_e4205 * _e4001) + (_e4208 * _e4002)) + (_e4211 * _e4003));
                                        let _e4231 = (((_e4205 * _e3998) + (_e4208 * _e3999)) + (_e4211 * _e4000));
                                        let _e4236 = (((_e4205 * _e4006[0]) + (_e4208 * _e4006[1])) + (_e4211 * _e4006[2]));
                                        let _e4241 = (((_e4205 * _e4022) + (_e4208 * _e4023)) + (_e4211 * _e4024));
                                        let _e4246 = (((_e4205 * _e4028) + (_e4208 * _e4029)) + (_e4211 * _e4030));
                                        let _e4251 = (((_e4205 * _e4025) + (_e4208 * _e4026)) + (_e4211 * _e4027));
                                        if (_e4216 < _e4221) {
                                            phi_7416_ = _e4216;
                                        } else {
                                            phi_7416_ = _e4221;
                                        }
                                        let _e4254 = phi_7416_;
                                        if (_e4226 < _e4231) {
                                            phi_7421_ = _e4226;
                                        } else {
                                            phi_7421_ = _e4231;
                                        }
                                        let _e4257 = phi_7421_;
                                        if (_e4254 < _e4257) {
                                            phi_7426_ = _e4254;
                                        } else {
                                            phi_7426_ = _e4257;
                                        }
                                        let _e4260 = phi_7426_;
                                        if (_e4236 < _e4241) {
                                            phi_7431_ = _e4236;
                                        } else {
                                            phi_7431_ = _e4241;
                                        }
                                        let _e4263 = phi_7431_;
                                        if (_e4246 < _e4251) {
                                            phi_7436_ = _e4246;
                                        } else {
                                            phi_7436_ = _e4251;
                                        }
                                        let _e4266 = phi_7436_;
                                        if (_e4263 < _e4266) {
                                            phi_7441_ = _e4263;
                                        } else {
                                            phi_7441_ = _e4266;
                                        }
                                        let _e4269 = phi_7441_;
                                        if (_e4260 < _e4269) {
                                            phi_7446_ = _e4260;
                                        } else {
                                            phi_7446_ = _e4269;
                                        }
                                        let _e4272 = phi_7446_;
                                        if (_e4216 > _e4221) {
                                            phi_7451_ = _e4216;
                                        } else {
                                            phi_7451_ = _e4221;
                                        }
                                        let _e4275 = phi_7451_;
                                        if (_e4226 > _e4231) {
                                            phi_7456_ = _e4226;
                                        } else {
                                            phi_7456_ = _e4231;
                                        }
                                        let _e4278 = phi_7456_;
                                        if (_e4275 > _e4278) {
                                            phi_7461_ = _e4275;
                                        } else {
                                            phi_7461_ = _e4278;
                                        }
                                        let _e4281 = phi_7461_;
                                        if (_e4236 > _e4241) {
                                            phi_7466_ = _e4236;
                                        } else {
                                            phi_7466_ = _e4241;
                                        }
                                        let _e4284 = phi_7466_;
                                        if (_e4246 > _e4251) {
                                            phi_7471_ = _e4246;
                                        } else {
                                            phi_7471_ = _e4251;
                                        }
                                        let _e4287 = phi_7471_;
                                        if (_e4284 > _e4287) {
                                            phi_7476_ = _e4284;
                                        } else {
                                            phi_7476_ = _e4287;
                                        }
                                        let _e4290 = phi_7476_;
                                        if (_e4281 > _e4290) {
                                            phi_7481_ = _e4281;
                                        } else {
                                            phi_7481_ = _e4290;
                                        }
                                        let _e4293 = phi_7481_;
                                        if (_e4205 < 0f) {
                                            phi_7487_ = -(_e4205);
                                        } else {
                                            phi_7487_ = _e4205;
                                        }
                                        let _e4297 = phi_7487_;
                                        if (_e4208 < 0f) {
                                            phi_7493_ = -(_e4208);
                                        } else {
                                            phi_7493_ = _e4208;
                                        }
                                        let _e4301 = phi_7493_;
                                        if (_e4211 < 0f) {
                                            phi_7500_ = -(_e4211);
                                        } else {
                                            phi_7500_ = _e4211;
                                        }
                                        let _e4306 = phi_7500_;
                                        let _e4307 = ((_e4297 + _e4301) + _e4306);
                                        let _e4312 = -(_e4293);
                                        if (_e4272 > _e4312) {
                                            phi_7511_ = _e4272;
                                        } else {
                                            phi_7511_ = _e4312;
                                        }
                                        let _e4315 = phi_7511_;
                                        let _e4320 = (((_e4315 - ((_e4307 * _e4195) * (0.000000059604645f * (17f / 2f)))) - (_e4307 * _e4202)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4323 = ((_e3973 * _e3967) - (_e3976 * _e3966));
                                        let _e4326 = ((_e3976 * _e3965) - (_e3970 * _e3967));
                                        let _e4329 = ((_e3970 * _e3966) - (_e3973 * _e3965));
                                        let _e4334 = (((_e4323 * _e3979[0]) + (_e4326 * _e3979[1])) + (_e4329 * _e3979[2]));
                                        let _e4339 = (((_e4323 * _e3995) + (_e4326 * _e3996)) + (_e4329 * _e3997));
                                        let _e4344 = (((_e4323 * _e4001) + (_e4326 * _e4002)) + (_e4329 * _e4003));
                                        let _e4349 = (((_e4323 * _e3998) + (_e4326 * _e3999)) + (_e4329 * _e4000));
                                        let _e4354 = (((_e4323 * _e4006[0]) + (_e4326 * _e4006[1])) + (_e4329 * _e4006[2]));
                                        let _e4359 = (((_e4323 * _e4022) + (_e4326 * _e4023)) + (_e4329 * _e4024));
                                        let _e4364 = (((_e4323 * _e4028) + (_e4326 * _e4029)) + (_e4329 * _e4030));
                                        let _e4369 = (((_e4323 * _e4025) + (_e4326 * _e4026)) + (_e4329 * _e4027));
                                        if (_e4334 < _e4339) {
                                            phi_7582_ = _e4334;
                                        } else {
                                            phi_7582_ = _e4339;
                                        }
                                        let _e4372 = phi_7582_;
                                        if (_e4344 < _e4349) {
                                            phi_7587_ = _e4344;
                                        } else {
                                            phi_7587_ = _e4349;
                                        }
                                        let _e4375 = phi_7587_;
                                        if (_e4372 < _e4375) {
                                            phi_7592_ = _e4372;
                                        } else {
                                            phi_7592_ = _e4375;
                                        }
                                        let _e4378 = phi_7592_;
                                        if (_e4354 < _e4359) {
                                            phi_7597_ = _e4354;
                                        } else {
                                            phi_7597_ = _e4359;
                                        }
                                        let _e4381 = phi_7597_;
                                        if (_e4364 < _e4369) {
                                            phi_7602_ = _e4364;
                                        } else {
                                            phi_7602_ = _e4369;
                                        }
                                        let _e4384 = phi_7602_;
                                        if (_e4381 < _e4384) {
                                            phi_7607_ = _e4381;
                                        } else {
                                            phi_7607_ = _e4384;
                                        }
                                        let _e4387 = phi_7607_;
                                        if (_e4378 < _e4387) {
                                            phi_7612_ = _e4378;
                                        } else {
                                            phi_7612_ = _e4387;
                                        }
                                        let _e4390 = phi_7612_;
                                        if (_e4334 > _e4339) {
                                            phi_7617_ = _e4334;
                                        } else {
                                            phi_7617_ = _e4339;
                                        }
                                        let _e4393 = phi_7617_;
                                        if (_e4344 > _e4349) {
                                            phi_7622_ = _e4344;
                                        } else {
                                            phi_7622_ = _e4349;
                                        }
                                        let _e4396 = phi_7622_;
                                        if (_e4393 > _e4396) {
                                            phi_7627_ = _e4393;
                                        } else {
                                            phi_7627_ = _e4396;
                                        }
                                        let _e4399 = phi_7627_;
                                        if (_e4354 > _e4359) {
                                            phi_7632_ = _e4354;
                                        } else {
                                            phi_7632_ = _e4359;
                                        }
                                        let _e4402 = phi_7632_;
                                        if (_e4364 > _e4369) {
                                            phi_7637_ = _e4364;
                                        } else {
                                            phi_7637_ = _e4369;
                                        }
                                        let _e4405 = phi_7637_;
                                        if (_e4402 > _e4405) {
                                            phi_7642_ = _e4402;
                                        } else {
                                            phi_7642_ = _e4405;
                                        }
                                        let _e4408 = phi_7642_;
                                        if (_e4399 > _e4408) {
                                            phi_7647_ = _e4399;
                                        } else {
                                            phi_7647_ = _e4408;
                                        }
                                        let _e4411 = phi_7647_;
                                        if (_e4323 < 0f) {
                                            phi_7653_ = -(_e4323);
                                        } else {
                                            phi_7653_ = _e4323;
                                        }
                                        let _e4415 = phi_7653_;
                                        if (_e4326 < 0f) {
                                            phi_7659_ = -(_e4326);
                                        } else {
                                            phi_7659_ = _e4326;
                                        }
                                        let _e4419 = phi_7659_;
                                        if (_e4329 < 0f) {
                                            phi_7666_ = -(_e4329);
                                        } else {
                                            phi_7666_ = _e4329;
                                        }
                                        let _e4424 = phi_7666_;
                                        let _e4425 = ((_e4415 + _e4419) + _e4424);
                                        let _e4430 = -(_e4411);
                                        if (_e4390 > _e4430) {
                                            phi_7677_ = _e4390;
                                        } else {
                                            phi_7677_ = _e4430;
                                        }
                                        let _e4433 = phi_7677_;
                                        let _e4438 = (((_e4433 - ((_e4425 * _e4195) * (0.000000059604645f * (17f / 2f)))) - (_e4425 * _e4202)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4320 > _e4438) {
                                            phi_7687_ = _e4320;
                                        } else {
                                            phi_7687_ = _e4438;
                                        }
                                        let _e4441 = phi_7687_;
                                        phi_7869_ = (_e3937 || (_e4441 > 0f));
                                    }
                                    let _e4445 = phi_7869_;
                                    phi_7871_ = (_e3502 && _e4445);
                                } else {
                                    phi_7871_ = _e3502;
                                }
                                let _e4448 = phi_7871_;
                                phi_7873_ = (_e2469 || _e4448);
                            }
                            let _e4451 = phi_7873_;
                            if !(_e4451) {
                                let _e4454 = atomicAdd((&counters[5u]), 1u);
                                hits[_e996] = ((2147483648u | (_e4454 << bitcast<u32>(12i))) | _e999);
                            }
                        }
                        phi_7884_ = true;
                    }
                    let _e4461 = phi_7884_;
                    phi_7885_ = _e4461;
                } else {
                    phi_7885_ = false;
                }
                let _e4463 = phi_7885_;
                continue;
                continuing {
                    phi_1857_ = _e988;
                    break if !(_e4463);
                }
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                let _e4467 = atomicLoad((&counters[5u]));
                if (_e4467 > 0u) {
                    let _e4470 = atomicAdd((&output.member[0u]), _e4467);
                    if ((_e4470 + _e4467) < _e4470) {
                        let _e4474 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4470);
                }
            }
            workgroupBarrier();
            let _e4477 = atomicLoad((&counters[6u]));
            if (_e67 == 0u) {
                let _e4480 = atomicLoad((&counters[7u]));
                if (_e4480 > 0u) {
                    let _e4483 = atomicAdd((&output.member[1u]), _e4480);
                    if ((_e4483 + _e4480) < _e4483) {
                        let _e4487 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_7935_ = type_13(0u, 16u);
            loop {
                let _e4489 = phi_7935_;
                if (_e4489.member < _e4489.member_1) {
                    phi_7936_ = type_13((_e4489.member + 1u), _e4489.member_1);
                    phi_7959_ = type_13(1u, _e4489.member);
                } else {
                    phi_7936_ = _e4489;
                    phi_7959_ = type_13(0u, type_13().member_1);
                }
                let _e4501 = phi_7936_;
                let _e4503 = phi_7959_;
                if (bitcast<i32>(_e4503.member) != 0i) {
                    let _e4509 = (_e67 + (_e4503.member_1 * 128u));
                    if (_e4509 >= _e974) {
                        phi_8056_ = false;
                    } else {
                        let _e4512 = hits[_e4509];
                        if ((_e4512 & 2147483648u) == 0u) {
                            phi_7982_ = 4294967295u;
                        } else {
                            phi_7982_ = ((_e4512 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4519 = phi_7982_;
                        if (_e4519 != 4294967295u) {
                            let _e4523 = ((_e4512 >> bitcast<u32>(10i)) & 3u);
                            let _e4530 = firsts[(2u * _e4523)];
                            let _e4533 = leaves.member[(_e4530 + ((_e4512 >> bitcast<u32>(5i)) & 31u))];
                            let _e4537 = firsts[((2u * _e4523) + 1u)];
                            let _e4540 = leaves.member[(_e4537 + (_e4512 & 31u))];
                            let _e4545 = params.member.member_1.member_3;
                            let _e4546 = (_e4477 + _e4519);
                            if (_e4533.member_1 < _e4540.member_1) {
                                phi_8037_ = type_13(_e4533.member_1, _e4540.member_1);
                            } else {
                                phi_8037_ = type_13(_e4540.member_1, _e4533.member_1);
                            }
                            let _e4551 = phi_8037_;
                            if (_e4546 < _e4545) {
                                let _e4555 = (2u * _e4546);
                                atomicStore((&output.member[(4u + _e4555)]), _e4551.member);
                                atomicStore((&output.member[(_e4555 + 5u)]), _e4551.member_1);
                            }
                        }
                        phi_8056_ = true;
                    }
                    let _e4561 = phi_8056_;
                    phi_8057_ = _e4561;
                } else {
                    phi_8057_ = false;
                }
                let _e4563 = phi_8057_;
                continue;
                continuing {
                    phi_7935_ = _e4501;
                    break if !(_e4563);
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
fn filter_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
