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

struct type_23 {
    member: array<vec4<u32>>,
}

struct type_25 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
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

struct type_40 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_42 {
    member: array<type_40>,
}

struct type_43 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_44 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
}

struct type_48 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> nodes: type_27;
var<workgroup> columns: array<type_29, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 10>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(2) 
var<storage> leaves: type_23;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_37;
@group(0) @binding(5) 
var<storage> paths: type_42;
@group(0) @binding(6) 
var<storage> input: type_11;
@group(0) @binding(7) 
var<storage, read_write> output: type_48;
var<workgroup> left: array<u32, 512>;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_198_: bool;
    var phi_199_: bool;
    var phi_203_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_199_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_198_ = (param[0] > param_1[0]);
        } else {
            phi_198_ = false;
        }
        let _e14 = phi_198_;
        phi_199_ = _e14;
    }
    let _e16 = phi_199_;
    if _e16 {
        phi_203_ = param_1;
    } else {
        phi_203_ = param;
    }
    let _e18 = phi_203_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_222_: bool;
    var phi_223_: bool;
    var phi_227_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_223_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_222_ = (param_3[0] > param_2[0]);
        } else {
            phi_222_ = false;
        }
        let _e14 = phi_222_;
        phi_223_ = _e14;
    }
    let _e16 = phi_223_;
    if _e16 {
        phi_227_ = param_3;
    } else {
        phi_227_ = param_2;
    }
    let _e18 = phi_227_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_246_: bool;
    var phi_247_: bool;
    var phi_251_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_247_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_246_ = (param_4[0] > param_5[0]);
        } else {
            phi_246_ = false;
        }
        let _e14 = phi_246_;
        phi_247_ = _e14;
    }
    let _e16 = phi_247_;
    if _e16 {
        phi_251_ = param_5;
    } else {
        phi_251_ = param_4;
    }
    let _e18 = phi_251_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_270_: bool;
    var phi_271_: bool;
    var phi_275_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_271_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_270_ = (param_7[0] > param_6[0]);
        } else {
            phi_270_ = false;
        }
        let _e14 = phi_270_;
        phi_271_ = _e14;
    }
    let _e16 = phi_271_;
    if _e16 {
        phi_275_ = param_7;
    } else {
        phi_275_ = param_6;
    }
    let _e18 = phi_275_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_299_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_295_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_294_ = (param_8[0] > param_9[0]);
        } else {
            phi_294_ = false;
        }
        let _e14 = phi_294_;
        phi_295_ = _e14;
    }
    let _e16 = phi_295_;
    if _e16 {
        phi_299_ = param_9;
    } else {
        phi_299_ = param_8;
    }
    let _e18 = phi_299_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_323_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_319_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_318_ = (param_11[0] > param_10[0]);
        } else {
            phi_318_ = false;
        }
        let _e14 = phi_318_;
        phi_319_ = _e14;
    }
    let _e16 = phi_319_;
    if _e16 {
        phi_323_ = param_11;
    } else {
        phi_323_ = param_10;
    }
    let _e18 = phi_323_;
    return _e18;
}

fn function_6(param_12: f32, param_13: f32) -> f32 {
    var phi_8498_: bool;
    var phi_8502_: f32;

    if (param_12 != param_12) {
        phi_8498_ = true;
    } else {
        phi_8498_ = (param_13 >= param_12);
    }
    let _e6 = phi_8498_;
    if _e6 {
        phi_8502_ = param_13;
    } else {
        phi_8502_ = param_12;
    }
    let _e8 = phi_8502_;
    return _e8;
}

fn function_7(param_14: f32, param_15: f32) -> f32 {
    var phi_8482_: bool;
    var phi_8486_: f32;

    if (param_14 != param_14) {
        phi_8482_ = true;
    } else {
        phi_8482_ = (param_15 <= param_14);
    }
    let _e6 = phi_8482_;
    if _e6 {
        phi_8486_ = param_15;
    } else {
        phi_8486_ = param_14;
    }
    let _e8 = phi_8486_;
    return _e8;
}

fn function_8(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_39;
    var local_1: type_39;
    var local_2: type_39;
    var phi_377_: u32;
    var phi_426_: u32;
    var phi_427_: u32;
    var phi_435_: u32;
    var phi_451_: u32;
    var phi_474_: u32;
    var phi_475_: u32;
    var phi_478_: type_9;
    var phi_479_: type_9;
    var phi_504_: type_9;
    var phi_551_: u32;
    var phi_552_: u32;
    var phi_560_: u32;
    var phi_574_: u32;
    var phi_677_: array<u32, 2>;
    var phi_838_: bool;
    var phi_876_: type_29;
    var phi_905_: u32;
    var phi_908_: type_9;
    var phi_911_: u32;
    var phi_909_: type_9;
    var phi_934_: type_9;
    var phi_912_: u32;
    var local_3: u32;
    var phi_1123_: u32;
    var phi_1129_: type_9;
    var phi_1132_: u32;
    var phi_1130_: type_9;
    var phi_1155_: type_9;
    var phi_1179_: bool;
    var phi_1180_: bool;
    var phi_1181_: bool;
    var phi_1185_: bool;
    var phi_1193_: bool;
    var phi_1201_: u32;
    var phi_1133_: u32;
    var phi_1202_: u32;
    var phi_1212_: type_9;
    var phi_1238_: u32;
    var phi_1241_: type_9;
    var phi_1244_: type_9;
    var phi_1242_: type_9;
    var phi_1269_: type_9;
    var phi_1286_: type_9;
    var phi_1289_: type_9;
    var phi_1290_: type_9;
    var phi_1312_: type_9;
    var phi_1346_: type_9;
    var phi_1347_: bool;
    var phi_1287_: type_9;
    var phi_1348_: bool;
    var phi_1356_: u32;
    var phi_1359_: type_9;
    var phi_1360_: type_9;
    var phi_1385_: type_9;
    var phi_1541_: bool;
    var phi_1547_: bool;
    var phi_1553_: bool;
    var phi_1554_: bool;
    var phi_1595_: bool;
    var phi_1596_: bool;
    var phi_1603_: bool;
    var phi_1717_: bool;
    var phi_1718_: bool;
    var phi_1753_: u32;
    var phi_1754_: u32;
    var phi_1759_: type_15;
    var phi_1762_: u32;
    var phi_1764_: u32;
    var phi_1785_: bool;
    var phi_1791_: type_16;
    var phi_1760_: type_15;
    var phi_1805_: type_16;
    var phi_1873_: bool;
    var phi_1874_: bool;
    var phi_1875_: bool;
    var phi_1876_: bool;
    var phi_1880_: bool;
    var phi_1881_: bool;
    var phi_1886_: u32;
    var phi_1887_: u32;
    var phi_1888_: u32;
    var phi_1889_: u32;
    var phi_1890_: bool;
    var phi_1763_: u32;
    var phi_1765_: u32;
    var phi_1891_: bool;
    var local_4: u32;
    var local_5: u32;
    var phi_1939_: bool;
    var phi_1940_: bool;
    var phi_1941_: bool;
    var phi_1942_: bool;
    var phi_1946_: bool;
    var phi_1947_: bool;
    var phi_1951_: bool;
    var phi_1955_: bool;
    var phi_1956_: bool;
    var phi_1960_: bool;
    var phi_1961_: bool;
    var phi_1965_: bool;
    var phi_1966_: bool;
    var phi_2082_: bool;
    var phi_2083_: bool;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2259_: bool;
    var phi_2260_: bool;
    var phi_2347_: bool;
    var phi_2348_: bool;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_2540_: bool;
    var phi_2544_: bool;
    var phi_2579_: type_43;
    var phi_2704_: type_44;
    var phi_2751_: type_44;
    var phi_2823_: bool;
    var phi_2824_: bool;
    var phi_2829_: type_9;
    var phi_2830_: type_9;
    var phi_2853_: type_9;
    var phi_2924_: type_43;
    var phi_3058_: type_39;
    var phi_3338_: f32;
    var phi_3345_: f32;
    var phi_3350_: f32;
    var phi_3357_: f32;
    var phi_3362_: f32;
    var phi_3375_: f32;
    var phi_3382_: f32;
    var phi_3387_: f32;
    var phi_3394_: f32;
    var phi_3399_: f32;
    var phi_3404_: f32;
    var phi_3421_: f32;
    var phi_3428_: f32;
    var phi_3433_: f32;
    var phi_3440_: f32;
    var phi_3445_: f32;
    var phi_3459_: f32;
    var phi_3466_: f32;
    var phi_3471_: f32;
    var phi_3478_: f32;
    var phi_3483_: f32;
    var phi_3488_: f32;
    var phi_3505_: f32;
    var phi_3512_: f32;
    var phi_3517_: f32;
    var phi_3524_: f32;
    var phi_3529_: f32;
    var phi_3543_: f32;
    var phi_3550_: f32;
    var phi_3555_: f32;
    var phi_3562_: f32;
    var phi_3567_: f32;
    var phi_3572_: f32;
    var phi_3603_: f32;
    var phi_3609_: f32;
    var phi_3616_: f32;
    var phi_3623_: f32;
    var phi_3629_: f32;
    var phi_3636_: f32;
    var phi_3642_: f32;
    var phi_3648_: f32;
    var phi_3654_: f32;
    var phi_3661_: f32;
    var phi_3668_: f32;
    var phi_3692_: f32;
    var phi_3697_: f32;
    var phi_3702_: f32;
    var phi_3707_: f32;
    var phi_3712_: f32;
    var phi_3717_: f32;
    var phi_3727_: f32;
    var phi_3843_: array<f32, 3>;
    var phi_3908_: array<f32, 3>;
    var phi_3930_: f32;
    var phi_3937_: f32;
    var phi_3942_: f32;
    var phi_3949_: f32;
    var phi_3954_: f32;
    var phi_3967_: f32;
    var phi_3974_: f32;
    var phi_3979_: f32;
    var phi_3986_: f32;
    var phi_3991_: f32;
    var phi_3996_: f32;
    var phi_4013_: f32;
    var phi_4020_: f32;
    var phi_4025_: f32;
    var phi_4032_: f32;
    var phi_4037_: f32;
    var phi_4051_: f32;
    var phi_4058_: f32;
    var phi_4063_: f32;
    var phi_4070_: f32;
    var phi_4075_: f32;
    var phi_4080_: f32;
    var phi_4097_: f32;
    var phi_4104_: f32;
    var phi_4109_: f32;
    var phi_4116_: f32;
    var phi_4121_: f32;
    var phi_4135_: f32;
    var phi_4142_: f32;
    var phi_4147_: f32;
    var phi_4154_: f32;
    var phi_4159_: f32;
    var phi_4164_: f32;
    var phi_4243_: f32;
    var phi_4248_: f32;
    var phi_4253_: f32;
    var phi_4258_: f32;
    var phi_4263_: f32;
    var phi_4268_: f32;
    var phi_4273_: f32;
    var phi_4278_: f32;
    var phi_4283_: f32;
    var phi_4288_: f32;
    var phi_4293_: f32;
    var phi_4298_: f32;
    var phi_4303_: f32;
    var phi_4308_: f32;
    var phi_4314_: f32;
    var phi_4320_: f32;
    var phi_4327_: f32;
    var phi_4338_: f32;
    var phi_4409_: f32;
    var phi_4414_: f32;
    var phi_4419_: f32;
    var phi_4424_: f32;
    var phi_4429_: f32;
    var phi_4434_: f32;
    var phi_4439_: f32;
    var phi_4444_: f32;
    var phi_4449_: f32;
    var phi_4454_: f32;
    var phi_4459_: f32;
    var phi_4464_: f32;
    var phi_4469_: f32;
    var phi_4474_: f32;
    var phi_4480_: f32;
    var phi_4486_: f32;
    var phi_4493_: f32;
    var phi_4504_: f32;
    var phi_4514_: f32;
    var phi_4587_: f32;
    var phi_4592_: f32;
    var phi_4597_: f32;
    var phi_4602_: f32;
    var phi_4607_: f32;
    var phi_4612_: f32;
    var phi_4617_: f32;
    var phi_4622_: f32;
    var phi_4627_: f32;
    var phi_4632_: f32;
    var phi_4637_: f32;
    var phi_4642_: f32;
    var phi_4647_: f32;
    var phi_4652_: f32;
    var phi_4658_: f32;
    var phi_4664_: f32;
    var phi_4671_: f32;
    var phi_4682_: f32;
    var phi_4692_: f32;
    var phi_4693_: f32;
    var phi_4696_: bool;
    var phi_4703_: bool;
    var phi_4704_: bool;
    var phi_4709_: type_9;
    var phi_4710_: type_9;
    var phi_4733_: type_9;
    var phi_4804_: type_43;
    var phi_4938_: type_39;
    var phi_5317_: f32;
    var phi_5324_: f32;
    var phi_5329_: f32;
    var phi_5336_: f32;
    var phi_5341_: f32;
    var phi_5354_: f32;
    var phi_5361_: f32;
    var phi_5366_: f32;
    var phi_5373_: f32;
    var phi_5378_: f32;
    var phi_5383_: f32;
    var phi_5400_: f32;
    var phi_5407_: f32;
    var phi_5412_: f32;
    var phi_5419_: f32;
    var phi_5424_: f32;
    var phi_5438_: f32;
    var phi_5445_: f32;
    var phi_5450_: f32;
    var phi_5457_: f32;
    var phi_5462_: f32;
    var phi_5467_: f32;
    var phi_5484_: f32;
    var phi_5491_: f32;
    var phi_5496_: f32;
    var phi_5503_: f32;
    var phi_5508_: f32;
    var phi_5522_: f32;
    var phi_5529_: f32;
    var phi_5534_: f32;
    var phi_5541_: f32;
    var phi_5546_: f32;
    var phi_5551_: f32;
    var phi_5582_: f32;
    var phi_5588_: f32;
    var phi_5595_: f32;
    var phi_5602_: f32;
    var phi_5608_: f32;
    var phi_5615_: f32;
    var phi_5621_: f32;
    var phi_5627_: f32;
    var phi_5633_: f32;
    var phi_5640_: f32;
    var phi_5647_: f32;
    var phi_5671_: f32;
    var phi_5676_: f32;
    var phi_5681_: f32;
    var phi_5686_: f32;
    var phi_5691_: f32;
    var phi_5696_: f32;
    var phi_5706_: f32;
    var phi_5822_: array<f32, 3>;
    var phi_5887_: array<f32, 3>;
    var phi_5909_: f32;
    var phi_5916_: f32;
    var phi_5921_: f32;
    var phi_5928_: f32;
    var phi_5933_: f32;
    var phi_5946_: f32;
    var phi_5953_: f32;
    var phi_5958_: f32;
    var phi_5965_: f32;
    var phi_5970_: f32;
    var phi_5975_: f32;
    var phi_5992_: f32;
    var phi_5999_: f32;
    var phi_6004_: f32;
    var phi_6011_: f32;
    var phi_6016_: f32;
    var phi_6030_: f32;
    var phi_6037_: f32;
    var phi_6042_: f32;
    var phi_6049_: f32;
    var phi_6054_: f32;
    var phi_6059_: f32;
    var phi_6076_: f32;
    var phi_6083_: f32;
    var phi_6088_: f32;
    var phi_6095_: f32;
    var phi_6100_: f32;
    var phi_6114_: f32;
    var phi_6121_: f32;
    var phi_6126_: f32;
    var phi_6133_: f32;
    var phi_6138_: f32;
    var phi_6143_: f32;
    var phi_6222_: f32;
    var phi_6227_: f32;
    var phi_6232_: f32;
    var phi_6237_: f32;
    var phi_6242_: f32;
    var phi_6247_: f32;
    var phi_6252_: f32;
    var phi_6257_: f32;
    var phi_6262_: f32;
    var phi_6267_: f32;
    var phi_6272_: f32;
    var phi_6277_: f32;
    var phi_6282_: f32;
    var phi_6287_: f32;
    var phi_6293_: f32;
    var phi_6299_: f32;
    var phi_6306_: f32;
    var phi_6317_: f32;
    var phi_6388_: f32;
    var phi_6393_: f32;
    var phi_6398_: f32;
    var phi_6403_: f32;
    var phi_6408_: f32;
    var phi_6413_: f32;
    var phi_6418_: f32;
    var phi_6423_: f32;
    var phi_6428_: f32;
    var phi_6433_: f32;
    var phi_6438_: f32;
    var phi_6443_: f32;
    var phi_6448_: f32;
    var phi_6453_: f32;
    var phi_6459_: f32;
    var phi_6465_: f32;
    var phi_6472_: f32;
    var phi_6483_: f32;
    var phi_6493_: f32;
    var phi_6566_: f32;
    var phi_6571_: f32;
    var phi_6576_: f32;
    var phi_6581_: f32;
    var phi_6586_: f32;
    var phi_6591_: f32;
    var phi_6596_: f32;
    var phi_6601_: f32;
    var phi_6606_: f32;
    var phi_6611_: f32;
    var phi_6616_: f32;
    var phi_6621_: f32;
    var phi_6626_: f32;
    var phi_6631_: f32;
    var phi_6637_: f32;
    var phi_6643_: f32;
    var phi_6650_: f32;
    var phi_6661_: f32;
    var phi_6671_: f32;
    var phi_6672_: f32;
    var phi_6675_: bool;
    var phi_6920_: f32;
    var phi_6927_: f32;
    var phi_6932_: f32;
    var phi_6939_: f32;
    var phi_6944_: f32;
    var phi_6957_: f32;
    var phi_6964_: f32;
    var phi_6969_: f32;
    var phi_6976_: f32;
    var phi_6981_: f32;
    var phi_6986_: f32;
    var phi_7003_: f32;
    var phi_7010_: f32;
    var phi_7015_: f32;
    var phi_7022_: f32;
    var phi_7027_: f32;
    var phi_7041_: f32;
    var phi_7048_: f32;
    var phi_7053_: f32;
    var phi_7060_: f32;
    var phi_7065_: f32;
    var phi_7070_: f32;
    var phi_7087_: f32;
    var phi_7094_: f32;
    var phi_7099_: f32;
    var phi_7106_: f32;
    var phi_7111_: f32;
    var phi_7125_: f32;
    var phi_7132_: f32;
    var phi_7137_: f32;
    var phi_7144_: f32;
    var phi_7149_: f32;
    var phi_7154_: f32;
    var phi_7185_: f32;
    var phi_7191_: f32;
    var phi_7198_: f32;
    var phi_7205_: f32;
    var phi_7211_: f32;
    var phi_7218_: f32;
    var phi_7224_: f32;
    var phi_7230_: f32;
    var phi_7236_: f32;
    var phi_7243_: f32;
    var phi_7250_: f32;
    var phi_7274_: f32;
    var phi_7279_: f32;
    var phi_7284_: f32;
    var phi_7289_: f32;
    var phi_7294_: f32;
    var phi_7299_: f32;
    var phi_7309_: f32;
    var phi_7425_: array<f32, 3>;
    var phi_7490_: array<f32, 3>;
    var phi_7512_: f32;
    var phi_7519_: f32;
    var phi_7524_: f32;
    var phi_7531_: f32;
    var phi_7536_: f32;
    var phi_7549_: f32;
    var phi_7556_: f32;
    var phi_7561_: f32;
    var phi_7568_: f32;
    var phi_7573_: f32;
    var phi_7578_: f32;
    var phi_7595_: f32;
    var phi_7602_: f32;
    var phi_7607_: f32;
    var phi_7614_: f32;
    var phi_7619_: f32;
    var phi_7633_: f32;
    var phi_7640_: f32;
    var phi_7645_: f32;
    var phi_7652_: f32;
    var phi_7657_: f32;
    var phi_7662_: f32;
    var phi_7679_: f32;
    var phi_7686_: f32;
    var phi_7691_: f32;
    var phi_7698_: f32;
    var phi_7703_: f32;
    var phi_7717_: f32;
    var phi_7724_: f32;
    var phi_7729_: f32;
    var phi_7736_: f32;
    var phi_7741_: f32;
    var phi_7746_: f32;
    var phi_7825_: f32;
    var phi_7830_: f32;
    var phi_7835_: f32;
    var phi_7840_: f32;
    var phi_7845_: f32;
    var phi_7850_: f32;
    var phi_7855_: f32;
    var phi_7860_: f32;
    var phi_7865_: f32;
    var phi_7870_: f32;
    var phi_7875_: f32;
    var phi_7880_: f32;
    var phi_7885_: f32;
    var phi_7890_: f32;
    var phi_7896_: f32;
    var phi_7902_: f32;
    var phi_7909_: f32;
    var phi_7920_: f32;
    var phi_7991_: f32;
    var phi_7996_: f32;
    var phi_8001_: f32;
    var phi_8006_: f32;
    var phi_8011_: f32;
    var phi_8016_: f32;
    var phi_8021_: f32;
    var phi_8026_: f32;
    var phi_8031_: f32;
    var phi_8036_: f32;
    var phi_8041_: f32;
    var phi_8046_: f32;
    var phi_8051_: f32;
    var phi_8056_: f32;
    var phi_8062_: f32;
    var phi_8068_: f32;
    var phi_8075_: f32;
    var phi_8086_: f32;
    var phi_8096_: f32;
    var phi_8169_: f32;
    var phi_8174_: f32;
    var phi_8179_: f32;
    var phi_8184_: f32;
    var phi_8189_: f32;
    var phi_8194_: f32;
    var phi_8199_: f32;
    var phi_8204_: f32;
    var phi_8209_: f32;
    var phi_8214_: f32;
    var phi_8219_: f32;
    var phi_8224_: f32;
    var phi_8229_: f32;
    var phi_8234_: f32;
    var phi_8240_: f32;
    var phi_8246_: f32;
    var phi_8253_: f32;
    var phi_8264_: f32;
    var phi_8274_: f32;
    var phi_8275_: f32;
    var phi_8278_: bool;
    var phi_8280_: bool;
    var phi_8290_: bool;
    var phi_8291_: bool;
    var phi_8327_: type_9;
    var phi_8328_: type_9;
    var phi_8351_: type_9;
    var phi_8375_: u32;
    var phi_8427_: type_9;
    var phi_8446_: bool;
    var phi_8447_: bool;
    var phi_1245_: type_9;
    var local_6: u32;
    var local_7: u32;
    var local_8: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e71 = id_2;
    let _e72 = n_2;
    let _e73 = lane_2;
    let _e86 = ((_e71.y * _e72.x) + _e71.x);
    let _e89 = (_e72.x * _e72.y);
    let _e91 = params.member.member;
    let _e96 = params.member.member_1.member_2;
    let _e98 = input.member[0u];
    if (_e96 < _e98) {
        phi_377_ = _e96;
    } else {
        phi_377_ = _e98;
    }
    let _e101 = phi_377_;
    if (_e73 == 0u) {
        atomicStore((&counters[9u]), 0u);
    }
    let _e106 = params.member.member_1.member_1;
    if (_e101 > _e106) {
        let _e110 = params.member.member_1.member_1;
        let _e111 = (_e101 - _e110);
        let _e114 = params.member.member_2.member_3;
        if (_e114 == 0u) {
            return;
        }
        let _e116 = (_e111 / _e114);
        if (_e114 == 0u) {
            return;
        }
        if ((_e111 % _e114) > 0u) {
            phi_426_ = (_e116 + 1u);
        } else {
            phi_426_ = _e116;
        }
        let _e122 = phi_426_;
        phi_427_ = _e122;
    } else {
        phi_427_ = 0u;
    }
    let _e124 = phi_427_;
    let _e127 = params.member.member_2.member_4;
    if (_e127 < _e124) {
        phi_435_ = _e127;
    } else {
        phi_435_ = _e124;
    }
    let _e130 = phi_435_;
    let _e131 = (_e130 / 4u);
    if ((_e130 % 4u) > 0u) {
        phi_451_ = (_e131 + 1u);
    } else {
        phi_451_ = _e131;
    }
    let _e136 = phi_451_;
    if (_e136 > _e86) {
        let _e138 = (_e136 - _e86);
        if (_e89 == 0u) {
            return;
        }
        let _e140 = (_e138 / _e89);
        if (_e89 == 0u) {
            return;
        }
        if ((_e138 % _e89) > 0u) {
            phi_474_ = (_e140 + 1u);
        } else {
            phi_474_ = _e140;
        }
        let _e146 = phi_474_;
        phi_475_ = _e146;
    } else {
        phi_475_ = 0u;
    }
    let _e148 = phi_475_;
    phi_478_ = type_9(0u, _e148);
    loop {
        let _e151 = phi_478_;
        if (_e151.member < _e151.member_1) {
            phi_479_ = type_9((_e151.member + 1u), _e151.member_1);
            phi_504_ = type_9(1u, _e151.member);
        } else {
            phi_479_ = _e151;
            phi_504_ = type_9(0u, type_9().member_1);
        }
        let _e163 = phi_479_;
        let _e165 = phi_504_;
        let _e169 = (bitcast<i32>(_e165.member) != 0i);
        if _e169 {
            let _e174 = (((_e86 + (_e165.member_1 * _e89)) * 4u) + (_e73 / 32u));
            let _e177 = params.member.member_1.member_1;
            if (_e101 > _e177) {
                let _e181 = params.member.member_1.member_1;
                let _e182 = (_e101 - _e181);
                let _e185 = params.member.member_2.member_3;
                if (_e185 == 0u) {
                    return;
                }
                let _e187 = (_e182 / _e185);
                if (_e185 == 0u) {
                    return;
                }
                if ((_e182 % _e185) > 0u) {
                    phi_551_ = (_e187 + 1u);
                } else {
                    phi_551_ = _e187;
                }
                let _e193 = phi_551_;
                phi_552_ = _e193;
            } else {
                phi_552_ = 0u;
            }
            let _e195 = phi_552_;
            let _e198 = params.member.member_2.member_4;
            if (_e198 < _e195) {
                phi_560_ = _e198;
            } else {
                phi_560_ = _e195;
            }
            let _e201 = phi_560_;
            let _e202 = (_e174 < _e201);
            let _e205 = params.member.member_1.member_1;
            let _e208 = params.member.member_2.member_3;
            if _e202 {
                phi_574_ = (_e174 * _e208);
            } else {
                phi_574_ = 0u;
            }
            let _e211 = phi_574_;
            let _e213 = (2u * (_e205 + _e211));
            let _e216 = input.member[(4u + _e213)];
            let _e219 = input.member[(_e213 + 5u)];
            if (_e73 <= 7u) {
                atomicStore((&counters[_e73]), 0u);
            }
            workgroupBarrier();
            if ((_e73 % 32u) == 0u) {
                let _e225 = (_e73 / 32u);
                let _e231 = params.member.member_2.member[0u][1u];
                firsts[(2u * _e225)] = (_e231 + (_e216 * 32u));
                let _e240 = params.member.member_2.member[0u][1u];
                firsts[((2u * _e225) + 1u)] = (_e240 + (_e219 * 32u));
            }
            let _e245 = params.member.member_2.member_1;
            if (_e245 == 0u) {
                phi_677_ = array<u32, 2>(0u, 2u);
            } else {
                phi_677_ = array<u32, 2>(1u, 1u);
            }
            let _e248 = phi_677_;
            let _e251 = (_e73 / 32u);
            let _e252 = (_e73 % 32u);
            let _e254 = params.member.member_2.member_2;
            let _e258 = params.member.member_2.member[_e254][_e248[0]];
            let _e261 = nodes.member[(_e258 + _e216)];
            let _e275 = params.member.member_2.member_2;
            let _e279 = params.member.member_2.member[_e275][_e248[1]];
            let _e282 = nodes.member[(_e279 + _e219)];
            let _e296 = params.member.member_2.member_2;
            let _e303 = params.member.member_2.member[(_e296 - 1u)][_e248[0]];
            let _e306 = nodes.member[(_e303 + ((_e216 * 32u) + _e252))];
            let _e323 = params.member.member_2.member_2;
            let _e330 = params.member.member_2.member[(_e323 - 1u)][_e248[1]];
            let _e333 = nodes.member[(_e330 + ((_e219 * 32u) + _e252))];
            if _e202 {
                phi_838_ = ((((((_e306.member.x <= _e282.member_1.y) && (_e282.member.x <= _e306.member_1.y)) && (_e306.member.y <= _e282.member_2.x)) && (_e282.member.y <= _e306.member_2.x)) && (_e306.member_1.x <= _e282.member_2.y)) && (_e282.member_1.x <= _e306.member_2.y));
            } else {
                phi_838_ = false;
            }
            let _e358 = phi_838_;
            if _e202 {
                if ((((((_e333.member.x <= _e261.member_1.y) && (_e261.member.x <= _e333.member_1.y)) && (_e333.member.y <= _e261.member_2.x)) && (_e261.member.y <= _e333.member_2.x)) && (_e333.member_1.x <= _e261.member_2.y)) && (_e261.member_1.x <= _e333.member_2.y)) {
                    let _e372 = atomicAdd((&counters[_e251]), 1u);
                    let _e373 = ((_e251 * 32u) + _e372);
                    columns[_e373] = type_29(array<f32, 3>(_e333.member.x, _e333.member.y, _e333.member_1.x), array<f32, 3>(_e333.member_1.y, _e333.member_2.x, _e333.member_2.y));
                    names[_e373] = _e252;
                }
            }
            if _e358 {
                phi_876_ = type_29(array<f32, 3>(_e306.member.x, _e306.member.y, _e306.member_1.x), array<f32, 3>(_e306.member_1.y, _e306.member_2.x, _e306.member_2.y));
            } else {
                phi_876_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e380 = phi_876_;
            workgroupBarrier();
            let _e381 = (_e216 == _e219);
            let _e382 = (_e73 / 32u);
            let _e384 = (_e382 * 32u);
            let _e386 = atomicLoad((&counters[_e382]));
            let _e387 = (_e386 / 4u);
            if ((_e386 % 4u) > 0u) {
                phi_905_ = (_e387 + 1u);
            } else {
                phi_905_ = _e387;
            }
            let _e392 = phi_905_;
            phi_908_ = type_9(0u, _e392);
            phi_911_ = 0u;
            loop {
                let _e395 = phi_908_;
                let _e397 = phi_911_;
                local_3 = _e397;
                local_6 = _e397;
                if (_e395.member < _e395.member_1) {
                    phi_909_ = type_9((_e395.member + 1u), _e395.member_1);
                    phi_934_ = type_9(1u, _e395.member);
                } else {
                    phi_909_ = _e395;
                    phi_934_ = type_9(0u, type_9().member_1);
                }
                let _e409 = phi_909_;
                let _e411 = phi_934_;
                let _e415 = (bitcast<i32>(_e411.member) != 0i);
                if _e415 {
                    let _e416 = (4u * _e411.member_1);
                    let _e419 = columns[(_e384 + _e416)];
                    let _e458 = columns[((_e384 + _e416) + 1u)];
                    let _e499 = columns[((_e384 + _e416) + 2u)];
                    let _e540 = columns[((_e384 + _e416) + 3u)];
                    phi_912_ = (_e397 | ((((select(0u, 1u, ((((((_e380.member[0] <= _e419.member_1[0]) && (_e419.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e419.member_1[1])) && (_e419.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e419.member_1[2])) && (_e419.member[2] <= _e380.member_1[2]))) << bitcast<u32>((_e416 & 31u))) | (select(0u, 1u, ((((((_e380.member[0] <= _e458.member_1[0]) && (_e458.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e458.member_1[1])) && (_e458.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e458.member_1[2])) && (_e458.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e416 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e380.member[0] <= _e499.member_1[0]) && (_e499.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e499.member_1[1])) && (_e499.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e499.member_1[2])) && (_e499.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e416 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e380.member[0] <= _e540.member_1[0]) && (_e540.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e540.member_1[1])) && (_e540.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e540.member_1[2])) && (_e540.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e416 + 3u) & 31u)))));
                } else {
                    phi_912_ = u32();
                }
                let _e580 = phi_912_;
                continue;
                continuing {
                    phi_908_ = _e409;
                    phi_911_ = _e580;
                    break if !(_e415);
                }
            }
            if (_e386 < 32u) {
                let _e588 = local_3;
                phi_1123_ = (_e588 & ((1u << bitcast<u32>((_e386 & 31u))) - 1u));
            } else {
                let _e5557 = local_6;
                phi_1123_ = _e5557;
            }
            let _e591 = phi_1123_;
            if _e381 {
                phi_1129_ = type_9(0u, _e386);
                phi_1132_ = _e591;
                loop {
                    let _e594 = phi_1129_;
                    let _e596 = phi_1132_;
                    local_7 = _e596;
                    if (_e594.member < _e594.member_1) {
                        phi_1130_ = type_9((_e594.member + 1u), _e594.member_1);
                        phi_1155_ = type_9(1u, _e594.member);
                    } else {
                        phi_1130_ = _e594;
                        phi_1155_ = type_9(0u, type_9().member_1);
                    }
                    let _e608 = phi_1130_;
                    let _e610 = phi_1155_;
                    let _e614 = (bitcast<i32>(_e610.member) != 0i);
                    if _e614 {
                        let _e617 = names[(_e384 + _e610.member_1)];
                        if _e381 {
                            let _e618 = ((_e73 % 32u) < _e617);
                            if _e618 {
                                phi_1179_ = bool();
                            } else {
                                phi_1179_ = false;
                            }
                            let _e620 = phi_1179_;
                            phi_1180_ = _e620;
                            phi_1181_ = _e618;
                        } else {
                            phi_1180_ = bool();
                            phi_1181_ = true;
                        }
                        let _e622 = phi_1180_;
                        let _e624 = phi_1181_;
                        if _e624 {
                            phi_1185_ = true;
                        } else {
                            phi_1185_ = _e622;
                        }
                        let _e626 = phi_1185_;
                        if _e626 {
                            phi_1193_ = false;
                        } else {
                            phi_1193_ = true;
                        }
                        let _e628 = phi_1193_;
                        if _e628 {
                            phi_1201_ = (_e596 & ~((1u << bitcast<u32>((_e610.member_1 & 31u)))));
                        } else {
                            phi_1201_ = _e596;
                        }
                        let _e635 = phi_1201_;
                        phi_1133_ = _e635;
                    } else {
                        phi_1133_ = u32();
                    }
                    let _e637 = phi_1133_;
                    continue;
                    continuing {
                        phi_1129_ = _e608;
                        phi_1132_ = _e637;
                        break if !(_e614);
                    }
                }
                let _e5571 = local_7;
                phi_1202_ = _e5571;
            } else {
                phi_1202_ = _e591;
            }
            let _e640 = phi_1202_;
            let _e642 = countOneBits(_e640);
            if (_e642 > 0u) {
                let _e645 = atomicAdd((&counters[4u]), _e642);
                phi_1212_ = type_9(_e640, _e645);
            } else {
                phi_1212_ = type_9(_e640, 0u);
            }
            let _e648 = phi_1212_;
            workgroupBarrier();
            if (_e73 == 0u) {
                let _e651 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e651;
            }
            let _e654 = workgroupUniformLoad((&n_hits[0u]));
            let _e655 = (_e654 / 512u);
            if ((_e654 % 512u) > 0u) {
                phi_1238_ = (_e655 + 1u);
            } else {
                phi_1238_ = _e655;
            }
            let _e660 = phi_1238_;
            phi_1241_ = type_9(0u, _e660);
            phi_1244_ = _e648;
            loop {
                let _e663 = phi_1241_;
                let _e665 = phi_1244_;
                if (_e663.member < _e663.member_1) {
                    phi_1242_ = type_9((_e663.member + 1u), _e663.member_1);
                    phi_1269_ = type_9(1u, _e663.member);
                } else {
                    phi_1242_ = _e663;
                    phi_1269_ = type_9(0u, type_9().member_1);
                }
                let _e677 = phi_1242_;
                let _e679 = phi_1269_;
                let _e683 = (bitcast<i32>(_e679.member) != 0i);
                if _e683 {
                    let _e684 = (_e73 / 32u);
                    let _e686 = (_e679.member_1 * 512u);
                    phi_1286_ = _e665;
                    phi_1289_ = type_9(0u, countOneBits(_e665.member));
                    loop {
                        let _e691 = phi_1286_;
                        let _e693 = phi_1289_;
                        local_8 = _e691;
                        if (_e693.member < _e693.member_1) {
                            phi_1290_ = type_9((_e693.member + 1u), _e693.member_1);
                            phi_1312_ = type_9(1u, _e693.member);
                        } else {
                            phi_1290_ = _e693;
                            phi_1312_ = type_9(0u, type_9().member_1);
                        }
                        let _e705 = phi_1290_;
                        let _e707 = phi_1312_;
                        if (bitcast<i32>(_e707.member) != 0i) {
                            let _e712 = (_e691.member_1 - _e686);
                            if (_e712 >= 512u) {
                                phi_1346_ = type_9();
                                phi_1347_ = false;
                            } else {
                                let _e721 = names[((_e684 * 32u) + select(firstTrailingBit(_e691.member), 32u, (_e691.member == 0u)))];
                                hits[_e712] = (((_e684 << bitcast<u32>(10i)) | ((_e73 % 32u) << bitcast<u32>(5i))) | _e721);
                                phi_1346_ = type_9((_e691.member & (_e691.member - 1u)), (_e691.member_1 + 1u));
                                phi_1347_ = true;
                            }
                            let _e737 = phi_1346_;
                            let _e739 = phi_1347_;
                            phi_1287_ = _e737;
                            phi_1348_ = _e739;
                        } else {
                            phi_1287_ = type_9();
                            phi_1348_ = false;
                        }
                        let _e741 = phi_1287_;
                        let _e743 = phi_1348_;
                        continue;
                        continuing {
                            phi_1286_ = _e741;
                            phi_1289_ = _e705;
                            break if !(_e743);
                        }
                    }
                    workgroupBarrier();
                    let _e746 = n_hits[0u];
                    let _e747 = (_e746 - _e686);
                    if (512u < _e747) {
                        phi_1356_ = 512u;
                    } else {
                        phi_1356_ = _e747;
                    }
                    let _e750 = phi_1356_;
                    phi_1359_ = type_9(0u, 4u);
                    loop {
                        let _e752 = phi_1359_;
                        if (_e752.member < _e752.member_1) {
                            phi_1360_ = type_9((_e752.member + 1u), _e752.member_1);
                            phi_1385_ = type_9(1u, _e752.member);
                        } else {
                            phi_1360_ = _e752;
                            phi_1385_ = type_9(0u, type_9().member_1);
                        }
                        let _e764 = phi_1360_;
                        let _e766 = phi_1385_;
                        if (bitcast<i32>(_e766.member) != 0i) {
                            let _e772 = (_e73 + (_e766.member_1 * 128u));
                            if (_e772 >= _e750) {
                                phi_2823_ = false;
                            } else {
                                let _e775 = hits[_e772];
                                let _e778 = ((_e775 >> bitcast<u32>(10i)) & 3u);
                                let _e785 = firsts[(2u * _e778)];
                                let _e790 = firsts[((2u * _e778) + 1u)];
                                let _e793 = leaves.member[(_e785 + ((_e775 >> bitcast<u32>(5i)) & 31u))];
                                let _e799 = leaves.member[(_e790 + (_e775 & 31u))];
                                let _e806 = ((_e775 >> bitcast<u32>(10i)) & 3u);
                                let _e813 = firsts[(2u * _e806)];
                                let _e818 = firsts[((2u * _e806) + 1u)];
                                let _e821 = nodes.member[(_e813 + ((_e775 >> bitcast<u32>(5i)) & 31u))];
                                let _e835 = nodes.member[(_e818 + (_e775 & 31u))];
                                if ((_e91.member_1 & 1u) != 0u) {
                                    if (_e799.x == _e793.x) {
                                        phi_1541_ = true;
                                    } else {
                                        phi_1541_ = (_e799.x == _e793.y);
                                    }
                                    let _e854 = phi_1541_;
                                    if (_e799.y == _e793.x) {
                                        phi_1547_ = true;
                                    } else {
                                        phi_1547_ = (_e799.y == _e793.y);
                                    }
                                    let _e858 = phi_1547_;
                                    if (_e854 || _e858) {
                                        phi_1553_ = false;
                                    } else {
                                        phi_1553_ = true;
                                    }
                                    let _e861 = phi_1553_;
                                    phi_1554_ = _e861;
                                } else {
                                    phi_1554_ = true;
                                }
                                let _e863 = phi_1554_;
                                if _e863 {
                                    if ((_e91.member_1 & 2u) != 0u) {
                                        let _e868 = bodies.member[_e793.x];
                                        let _e870 = bodies.member[_e799.x];
                                        if ((_e868 / 4u) != (_e870 / 4u)) {
                                            phi_1596_ = true;
                                        } else {
                                            if ((_e868 & 2u) == 0u) {
                                                phi_1595_ = false;
                                            } else {
                                                phi_1595_ = true;
                                            }
                                            let _e877 = phi_1595_;
                                            phi_1596_ = _e877;
                                        }
                                        let _e879 = phi_1596_;
                                        if _e879 {
                                            phi_1603_ = (((_e868 & _e870) & 1u) == 0u);
                                        } else {
                                            phi_1603_ = false;
                                        }
                                        let _e884 = phi_1603_;
                                        if _e884 {
                                            if ((_e91.member_1 & 4u) != 0u) {
                                                let _e891 = bodies.member[_e91.member[0]];
                                                let _e894 = bodies.member[(_e91.member[0] + 1u)];
                                                let _e899 = ((_e91.member[0] + 4u) + (2u * (_e868 >> bitcast<u32>(2i))));
                                                let _e904 = ((_e91.member[0] + 4u) + (2u * (_e870 >> bitcast<u32>(2i))));
                                                let _e906 = bodies.member[_e899];
                                                let _e908 = bodies.member[_e904];
                                                let _e917 = bodies.member[((((_e91.member[0] + 4u) + (2u * _e891)) + (_e906 * _e894)) + (_e908 / 32u))];
                                                let _e920 = bodies.member[(_e899 + 1u)];
                                                let _e923 = bodies.member[(_e904 + 1u)];
                                                if (_e920 == _e923) {
                                                    if (((_e917 >> bitcast<u32>(((_e908 % 32u) & 31u))) & 1u) == 1u) {
                                                        phi_1717_ = true;
                                                    } else {
                                                        phi_1717_ = ((_e868 >> bitcast<u32>(2i)) == (_e870 >> bitcast<u32>(2i)));
                                                    }
                                                    let _e937 = phi_1717_;
                                                    phi_1718_ = _e937;
                                                } else {
                                                    phi_1718_ = false;
                                                }
                                                let _e939 = phi_1718_;
                                                if _e939 {
                                                    let _e942 = bodies.member[(_e91.member[0] + 2u)];
                                                    let _e945 = bodies.member[(_e91.member[0] + 3u)];
                                                    let _e946 = (_e945 + _e91.member[0]);
                                                    if (_e799.w < _e793.w) {
                                                        phi_1753_ = _e793.w;
                                                        phi_1754_ = _e799.w;
                                                    } else {
                                                        phi_1753_ = _e799.w;
                                                        phi_1754_ = _e793.w;
                                                    }
                                                    let _e949 = phi_1753_;
                                                    let _e951 = phi_1754_;
                                                    phi_1759_ = type_15(0i, 32i);
                                                    phi_1762_ = _e942;
                                                    phi_1764_ = 0u;
                                                    loop {
                                                        let _e953 = phi_1759_;
                                                        let _e955 = phi_1762_;
                                                        let _e957 = phi_1764_;
                                                        local_4 = _e957;
                                                        local_5 = _e957;
                                                        if (_e953.member < _e953.member_1) {
                                                            let _e964 = (_e953.member + 1i);
                                                            if ((false == (_e964 > _e953.member)) != false) {
                                                                phi_1785_ = true;
                                                            } else {
                                                                phi_1785_ = false;
                                                            }
                                                            let _e969 = phi_1785_;
                                                            if _e969 {
                                                                phi_1791_ = type_16(0u, type_16().member_1);
                                                            } else {
                                                                phi_1791_ = type_16(1u, _e964);
                                                            }
                                                            let _e974 = phi_1791_;
                                                            phi_1760_ = type_15(_e974.member_1, _e953.member_1);
                                                            phi_1805_ = type_16(1u, _e953.member);
                                                        } else {
                                                            phi_1760_ = _e953;
                                                            phi_1805_ = type_16(0u, type_16().member_1);
                                                        }
                                                        let _e980 = phi_1760_;
                                                        let _e982 = phi_1805_;
                                                        if (bitcast<i32>(_e982.member) != 0i) {
                                                            if (_e957 >= _e955) {
                                                                phi_1888_ = u32();
                                                                phi_1889_ = u32();
                                                                phi_1890_ = false;
                                                            } else {
                                                                let _e989 = (_e957 + ((_e955 - _e957) / 2u));
                                                                let _e991 = (_e946 + (3u * _e989));
                                                                let _e993 = bodies.member[_e991];
                                                                let _e996 = bodies.member[(_e991 + 1u)];
                                                                let _e999 = bodies.member[(_e991 + 2u)];
                                                                if (_e993 < 1u) {
                                                                    phi_1881_ = true;
                                                                } else {
                                                                    if (_e993 == 1u) {
                                                                        if (_e996 < _e951) {
                                                                            phi_1875_ = false;
                                                                        } else {
                                                                            if (_e996 == _e951) {
                                                                                if (_e999 < _e949) {
                                                                                    phi_1873_ = false;
                                                                                } else {
                                                                                    phi_1873_ = true;
                                                                                }
                                                                                let _e1006 = phi_1873_;
                                                                                phi_1874_ = _e1006;
                                                                            } else {
                                                                                phi_1874_ = true;
                                                                            }
                                                                            let _e1008 = phi_1874_;
                                                                            phi_1875_ = _e1008;
                                                                        }
                                                                        let _e1010 = phi_1875_;
                                                                        phi_1876_ = _e1010;
                                                                    } else {
                                                                        phi_1876_ = true;
                                                                    }
                                                                    let _e1012 = phi_1876_;
                                                                    if _e1012 {
                                                                        phi_1880_ = false;
                                                                    } else {
                                                                        phi_1880_ = true;
                                                                    }
                                                                    let _e1014 = phi_1880_;
                                                                    phi_1881_ = _e1014;
                                                                }
                                                                let _e1016 = phi_1881_;
                                                                if _e1016 {
                                                                    phi_1886_ = _e955;
                                                                    phi_1887_ = (_e989 + 1u);
                                                                } else {
                                                                    phi_1886_ = _e989;
                                                                    phi_1887_ = _e957;
                                                                }
                                                                let _e1019 = phi_1886_;
                                                                let _e1021 = phi_1887_;
                                                                phi_1888_ = _e1019;
                                                                phi_1889_ = _e1021;
                                                                phi_1890_ = true;
                                                            }
                                                            let _e1023 = phi_1888_;
                                                            let _e1025 = phi_1889_;
                                                            let _e1027 = phi_1890_;
                                                            phi_1763_ = _e1023;
                                                            phi_1765_ = _e1025;
                                                            phi_1891_ = _e1027;
                                                        } else {
                                                            phi_1763_ = u32();
                                                            phi_1765_ = u32();
                                                            phi_1891_ = false;
                                                        }
                                                        let _e1029 = phi_1763_;
                                                        let _e1031 = phi_1765_;
                                                        let _e1033 = phi_1891_;
                                                        continue;
                                                        continuing {
                                                            phi_1759_ = _e980;
                                                            phi_1762_ = _e1029;
                                                            phi_1764_ = _e1031;
                                                            break if !(_e1033);
                                                        }
                                                    }
                                                    let _e1036 = local_4;
                                                    if (_e1036 < _e942) {
                                                        let _e1039 = local_5;
                                                        let _e1041 = (_e946 + (3u * _e1039));
                                                        let _e1043 = bodies.member[_e1041];
                                                        if (_e1043 == 1u) {
                                                            let _e1047 = bodies.member[(_e1041 + 1u)];
                                                            if (_e1047 == _e951) {
                                                                let _e1051 = bodies.member[(_e1041 + 2u)];
                                                                phi_1939_ = (_e1051 == _e949);
                                                                phi_1940_ = false;
                                                            } else {
                                                                phi_1939_ = bool();
                                                                phi_1940_ = true;
                                                            }
                                                            let _e1054 = phi_1939_;
                                                            let _e1056 = phi_1940_;
                                                            phi_1941_ = _e1054;
                                                            phi_1942_ = _e1056;
                                                        } else {
                                                            phi_1941_ = bool();
                                                            phi_1942_ = true;
                                                        }
                                                        let _e1058 = phi_1941_;
                                                        let _e1060 = phi_1942_;
                                                        if _e1060 {
                                                            phi_1946_ = false;
                                                        } else {
                                                            phi_1946_ = _e1058;
                                                        }
                                                        let _e1062 = phi_1946_;
                                                        phi_1947_ = _e1062;
                                                    } else {
                                                        phi_1947_ = false;
                                                    }
                                                    let _e1064 = phi_1947_;
                                                    phi_1951_ = _e1064;
                                                } else {
                                                    phi_1951_ = true;
                                                }
                                                let _e1066 = phi_1951_;
                                                if _e1066 {
                                                    phi_1955_ = false;
                                                } else {
                                                    phi_1955_ = true;
                                                }
                                                let _e1068 = phi_1955_;
                                                phi_1956_ = _e1068;
                                            } else {
                                                phi_1956_ = true;
                                            }
                                            let _e1070 = phi_1956_;
                                            if _e1070 {
                                                phi_1960_ = false;
                                            } else {
                                                phi_1960_ = true;
                                            }
                                            let _e1072 = phi_1960_;
                                            phi_1961_ = _e1072;
                                        } else {
                                            phi_1961_ = true;
                                        }
                                        let _e1074 = phi_1961_;
                                        if _e1074 {
                                            phi_1965_ = false;
                                        } else {
                                            phi_1965_ = true;
                                        }
                                        let _e1076 = phi_1965_;
                                        phi_1966_ = _e1076;
                                    } else {
                                        phi_1966_ = true;
                                    }
                                    let _e1078 = phi_1966_;
                                    if _e1078 {
                                        if ((_e91.member_1 & 32u) != 0u) {
                                            let _e1099 = (((((_e821.member_1.y - _e835.member.x) > _e91.member_6) && ((_e835.member_1.y - _e821.member.x) > _e91.member_6)) && (((_e821.member_2.x - _e835.member.y) > _e91.member_6) && ((_e835.member_2.x - _e821.member.y) > _e91.member_6))) && (((_e821.member_2.y - _e835.member_1.x) > _e91.member_6) && ((_e835.member_2.y - _e821.member_1.x) > _e91.member_6)));
                                            if _e1099 {
                                                phi_2530_ = bool();
                                            } else {
                                                let _e1101 = keys.member[_e793.x];
                                                let _e1104 = keys.member[_e793.y];
                                                let _e1106 = function_(_e1101[0], _e1104[0]);
                                                let _e1108 = keys.member[_e793.z];
                                                let _e1110 = function_(_e1106, _e1108[0]);
                                                let _e1112 = keys.member[_e799.x];
                                                let _e1115 = keys.member[_e799.y];
                                                let _e1117 = function_1(_e1112[3], _e1115[3]);
                                                let _e1119 = keys.member[_e799.z];
                                                let _e1121 = function_1(_e1117, _e1119[3]);
                                                if (_e1110[1] > _e1121[1]) {
                                                    phi_2083_ = true;
                                                } else {
                                                    if (_e1110[1] == _e1121[1]) {
                                                        phi_2082_ = (_e1110[0] > _e1121[0]);
                                                    } else {
                                                        phi_2082_ = false;
                                                    }
                                                    let _e1132 = phi_2082_;
                                                    phi_2083_ = _e1132;
                                                }
                                                let _e1134 = phi_2083_;
                                                let _e1137 = keys.member[_e799.x];
                                                let _e1140 = keys.member[_e799.y];
                                                let _e1142 = function_(_e1137[0], _e1140[0]);
                                                let _e1144 = keys.member[_e799.z];
                                                let _e1146 = function_(_e1142, _e1144[0]);
                                                let _e1148 = keys.member[_e793.x];
                                                let _e1151 = keys.member[_e793.y];
                                                let _e1153 = function_1(_e1148[3], _e1151[3]);
                                                let _e1155 = keys.member[_e793.z];
                                                let _e1157 = function_1(_e1153, _e1155[3]);
                                                if (_e1146[1] > _e1157[1]) {
                                                    phi_2171_ = true;
                                                } else {
                                                    if (_e1146[1] == _e1157[1]) {
                                                        phi_2170_ = (_e1146[0] > _e1157[0]);
                                                    } else {
                                                        phi_2170_ = false;
                                                    }
                                                    let _e1168 = phi_2170_;
                                                    phi_2171_ = _e1168;
                                                }
                                                let _e1170 = phi_2171_;
                                                let _e1174 = keys.member[_e793.x];
                                                let _e1177 = keys.member[_e793.y];
                                                let _e1179 = function_2(_e1174[1], _e1177[1]);
                                                let _e1181 = keys.member[_e793.z];
                                                let _e1183 = function_2(_e1179, _e1181[1]);
                                                let _e1185 = keys.member[_e799.x];
                                                let _e1188 = keys.member[_e799.y];
                                                let _e1190 = function_3(_e1185[4], _e1188[4]);
                                                let _e1192 = keys.member[_e799.z];
                                                let _e1194 = function_3(_e1190, _e1192[4]);
                                                if (_e1183[1] > _e1194[1]) {
                                                    phi_2260_ = true;
                                                } else {
                                                    if (_e1183[1] == _e1194[1]) {
                                                        phi_2259_ = (_e1183[0] > _e1194[0]);
                                                    } else {
                                                        phi_2259_ = false;
                                                    }
                                                    let _e1205 = phi_2259_;
                                                    phi_2260_ = _e1205;
                                                }
                                                let _e1207 = phi_2260_;
                                                let _e1210 = keys.member[_e799.x];
                                                let _e1213 = keys.member[_e799.y];
                                                let _e1215 = function_2(_e1210[1], _e1213[1]);
                                                let _e1217 = keys.member[_e799.z];
                                                let _e1219 = function_2(_e1215, _e1217[1]);
                                                let _e1221 = keys.member[_e793.x];
                                                let _e1224 = keys.member[_e793.y];
                                                let _e1226 = function_3(_e1221[4], _e1224[4]);
                                                let _e1228 = keys.member[_e793.z];
                                                let _e1230 = function_3(_e1226, _e1228[4]);
                                                if (_e1219[1] > _e1230[1]) {
                                                    phi_2348_ = true;
                                                } else {
                                                    if (_e1219[1] == _e1230[1]) {
                                                        phi_2347_ = (_e1219[0] > _e1230[0]);
                                                    } else {
                                                        phi_2347_ = false;
                                                    }
                                                    let _e1241 = phi_2347_;
                                                    phi_2348_ = _e1241;
                                                }
                                                let _e1243 = phi_2348_;
                                                let _e1248 = keys.member[_e793.x];
                                                let _e1251 = keys.member[_e793.y];
                                                let _e1253 = function_4(_e1248[2], _e1251[2]);
                                                let _e1255 = keys.member[_e793.z];
                                                let _e1257 = function_4(_e1253, _e1255[2]);
                                                let _e1259 = keys.member[_e799.x];
                                                let _e1262 = keys.member[_e799.y];
                                                let _e1264 = function_5(_e1259[5], _e1262[5]);
                                                let _e1266 = keys.member[_e799.z];
                                                let _e1268 = function_5(_e1264, _e1266[5]);
                                                if (_e1257[1] > _e1268[1]) {
                                                    phi_2438_ = true;
                                                } else {
                                                    if (_e1257[1] == _e1268[1]) {
                                                        phi_2437_ = (_e1257[0] > _e1268[0]);
                                                    } else {
                                                        phi_2437_ = false;
                                                    }
                                                    let _e1279 = phi_2437_;
                                                    phi_2438_ = _e1279;
                                                }
                                                let _e1281 = phi_2438_;
                                                let _e1284 = keys.member[_e799.x];
                                                let _e1287 = keys.member[_e799.y];
                                                let _e1289 = function_4(_e1284[2], _e1287[2]);
                                                let _e1291 = keys.member[_e799.z];
                                                let _e1293 = function_4(_e1289, _e1291[2]);
                                                let _e1295 = keys.member[_e793.x];
                                                let _e1298 = keys.member[_e793.y];
                                                let _e1300 = function_5(_e1295[5], _e1298[5]);
                                                let _e1302 = keys.member[_e793.z];
                                                let _e1304 = function_5(_e1300, _e1302[5]);
                                                if (_e1293[1] > _e1304[1]) {
                                                    phi_2526_ = true;
                                                } else {
                                                    if (_e1293[1] == _e1304[1]) {
                                                        phi_2525_ = (_e1293[0] > _e1304[0]);
                                                    } else {
                                                        phi_2525_ = false;
                                                    }
                                                    let _e1315 = phi_2525_;
                                                    phi_2526_ = _e1315;
                                                }
                                                let _e1317 = phi_2526_;
                                                phi_2530_ = (((!(_e1134) && !(_e1170)) && (!(_e1207) && !(_e1243))) && (!(_e1281) && !(_e1317)));
                                            }
                                            let _e1322 = phi_2530_;
                                            phi_2531_ = _e1322;
                                            phi_2532_ = _e1099;
                                        } else {
                                            phi_2531_ = bool();
                                            phi_2532_ = true;
                                        }
                                        let _e1324 = phi_2531_;
                                        let _e1326 = phi_2532_;
                                        if _e1326 {
                                            phi_2536_ = false;
                                        } else {
                                            phi_2536_ = true;
                                        }
                                        let _e1328 = phi_2536_;
                                        phi_2537_ = _e1324;
                                        phi_2538_ = _e1328;
                                    } else {
                                        phi_2537_ = false;
                                        phi_2538_ = true;
                                    }
                                    let _e1330 = phi_2537_;
                                    let _e1332 = phi_2538_;
                                    phi_2539_ = _e1330;
                                    phi_2540_ = _e1332;
                                } else {
                                    phi_2539_ = false;
                                    phi_2540_ = true;
                                }
                                let _e1334 = phi_2539_;
                                let _e1336 = phi_2540_;
                                if _e1336 {
                                    phi_2544_ = _e1334;
                                } else {
                                    phi_2544_ = true;
                                }
                                let _e1338 = phi_2544_;
                                if _e1338 {
                                    let _e1340 = atomicAdd((&counters[9u]), 1u);
                                }
                                if _e1338 {
                                    if (_e793.w < _e799.w) {
                                        phi_2579_ = type_43(1u, array<u32, 4>(_e793.x, _e793.y, _e799.x, _e799.y));
                                    } else {
                                        phi_2579_ = type_43(1u, array<u32, 4>(_e799.x, _e799.y, _e793.x, _e793.y));
                                    }
                                    let _e1347 = phi_2579_;
                                    let _e1352 = paths.member[_e1347.member_1[0]];
                                    let _e1367 = paths.member[_e1347.member_1[1]];
                                    let _e1382 = paths.member[_e1347.member_1[2]];
                                    let _e1397 = paths.member[_e1347.member_1[3]];
                                    let _e1410 = array<f32, 3>(_e1352.member.x, _e1352.member.y, _e1352.member.z);
                                    let _e1411 = array<f32, 3>(_e1352.member_1.x, _e1352.member_1.y, _e1352.member_1.z);
                                    let _e1416 = (((_e91.member_5 + (2f * _e91.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                                    if (_e1347.member != 0u) {
                                        let _e1441 = function_7(_e1352.member.x, _e1367.member.x);
                                        let _e1442 = function_7(_e1352.member.y, _e1367.member.y);
                                        let _e1443 = function_7(_e1352.member.z, _e1367.member.z);
                                        let _e1445 = function_6(_e1352.member.x, _e1367.member.x);
                                        let _e1446 = function_6(_e1352.member.y, _e1367.member.y);
                                        let _e1447 = function_6(_e1352.member.z, _e1367.member.z);
                                        let _e1450 = function_7(_e1382.member.x, _e1397.member.x);
                                        let _e1451 = function_7(_e1382.member.y, _e1397.member.y);
                                        let _e1452 = function_7(_e1382.member.z, _e1397.member.z);
                                        let _e1454 = function_6(_e1382.member.x, _e1397.member.x);
                                        let _e1455 = function_6(_e1382.member.y, _e1397.member.y);
                                        let _e1456 = function_6(_e1382.member.z, _e1397.member.z);
                                        phi_2704_ = type_44(array<array<f32, 3>, 2>(array<f32, 3>(_e1441, _e1442, _e1443), array<f32, 3>(_e1445, _e1446, _e1447)), array<array<f32, 3>, 2>(array<f32, 3>(_e1450, _e1451, _e1452), array<f32, 3>(_e1454, _e1455, _e1456)));
                                    } else {
                                        let _e1418 = function_7(_e1367.member.x, _e1382.member.x);
                                        let _e1419 = function_7(_e1367.member.y, _e1382.member.y);
                                        let _e1420 = function_7(_e1367.member.z, _e1382.member.z);
                                        let _e1421 = function_6(_e1367.member.x, _e1382.member.x);
                                        let _e1422 = function_6(_e1367.member.y, _e1382.member.y);
                                        let _e1423 = function_6(_e1367.member.z, _e1382.member.z);
                                        let _e1425 = function_7(_e1418, _e1397.member.x);
                                        let _e1426 = function_7(_e1419, _e1397.member.y);
                                        let _e1427 = function_7(_e1420, _e1397.member.z);
                                        let _e1429 = function_6(_e1418, _e1397.member.x);
                                        let _e1430 = function_6(_e1419, _e1397.member.y);
                                        let _e1431 = function_6(_e1420, _e1397.member.z);
                                        let _e1432 = function_7(_e1421, _e1397.member.x);
                                        let _e1433 = function_7(_e1422, _e1397.member.y);
                                        let _e1434 = function_7(_e1423, _e1397.member.z);
                                        let _e1435 = function_6(_e1421, _e1397.member.x);
                                        let _e1436 = function_6(_e1422, _e1397.member.y);
                                        let _e1437 = function_6(_e1423, _e1397.member.z);
                                        phi_2704_ = type_44(array<array<f32, 3>, 2>(_e1410, _e1410), array<array<f32, 3>, 2>(array<f32, 3>(_e1425, _e1426, _e1427), array<f32, 3>(_e1435, _e1436, _e1437)));
                                    }
                                    let _e1461 = phi_2704_;
                                    if (_e1347.member != 0u) {
                                        let _e1486 = function_7(_e1352.member_1.x, _e1367.member_1.x);
                                        let _e1487 = function_7(_e1352.member_1.y, _e1367.member_1.y);
                                        let _e1488 = function_7(_e1352.member_1.z, _e1367.member_1.z);
                                        let _e1490 = function_6(_e1352.member_1.x, _e1367.member_1.x);
                                        let _e1491 = function_6(_e1352.member_1.y, _e1367.member_1.y);
                                        let _e1492 = function_6(_e1352.member_1.z, _e1367.member_1.z);
                                        let _e1495 = function_7(_e1382.member_1.x, _e1397.member_1.x);
                                        let _e1496 = function_7(_e1382.member_1.y, _e1397.member_1.y);
                                        let _e1497 = function_7(_e1382.member_1.z, _e1397.member_1.z);
                                        let _e1499 = function_6(_e1382.member_1.x, _e1397.member_1.x);
                                        let _e1500 = function_6(_e1382.member_1.y, _e1397.member_1.y);
                                        let _e1501 = function_6(_e1382.member_1.z, _e1397.member_1.z);
                                        phi_2751_ = type_44(array<array<f32, 3>, 2>(array<f32, 3>(_e1486, _e1487, _e1488), array<f32, 3>(_e1490, _e1491, _e1492)), array<array<f32, 3>, 2>(array<f32, 3>(_e1495, _e1496, _e1497), array<f32, 3>(_e1499, _e1500, _e1501)));
                                    } else {
                                        let _e1463 = function_7(_e1367.member_1.x, _e1382.member_1.x);
                                        let _e1464 = function_7(_e1367.member_1.y, _e1382.member_1.y);
                                        let _e1465 = function_7(_e1367.member_1.z, _e1382.member_1.z);
                                        let _e1466 = function_6(_e1367.member_1.x, _e1382.member_1.x);
                                        let _e1467 = function_6(_e1367.member_1.y, _e1382.member_1.y);
                                        let _e1468 = function_6(_e1367.member_1.z, _e1382.member_1.z);
                                        let _e1470 = function_7(_e1463, _e1397.member_1.x);
                                        let _e1471 = function_7(_e1464, _e1397.member_1.y);
                                        let _e1472 = function_7(_e1465, _e1397.member_1.z);
                                        let _e1474 = function_6(_e1463, _e1397.member_1.x);
                                        let _e1475 = function_6(_e1464, _e1397.member_1.y);
                                        let _e1476 = function_6(_e1465, _e1397.member_1.z);
                                        let _e1477 = function_7(_e1466, _e1397.member_1.x);
                                        let _e1478 = function_7(_e1467, _e1397.member_1.y);
                                        let _e1479 = function_7(_e1468, _e1397.member_1.z);
                                        let _e1480 = function_6(_e1466, _e1397.member_1.x);
                                        let _e1481 = function_6(_e1467, _e1397.member_1.y);
                                        let _e1482 = function_6(_e1468, _e1397.member_1.z);
                                        phi_2751_ = type_44(array<array<f32, 3>, 2>(_e1411, _e1411), array<array<f32, 3>, 2>(array<f32, 3>(_e1470, _e1471, _e1472), array<f32, 3>(_e1480, _e1481, _e1482)));
                                    }
                                    let _e1506 = phi_2751_;
                                    if !(((((((_e1461.member[0][0] - _e1461.member_1[1][0]) > _e1416) && ((_e1506.member[0][0] - _e1506.member_1[1][0]) > _e1416)) || (((_e1461.member_1[0][0] - _e1461.member[1][0]) > _e1416) && ((_e1506.member_1[0][0] - _e1506.member[1][0]) > _e1416))) || ((((_e1461.member[0][1] - _e1461.member_1[1][1]) > _e1416) && ((_e1506.member[0][1] - _e1506.member_1[1][1]) > _e1416)) || (((_e1461.member_1[0][1] - _e1461.member[1][1]) > _e1416) && ((_e1506.member_1[0][1] - _e1506.member[1][1]) > _e1416)))) || ((((_e1461.member[0][2] - _e1461.member_1[1][2]) > _e1416) && ((_e1506.member[0][2] - _e1506.member_1[1][2]) > _e1416)) || (((_e1461.member_1[0][2] - _e1461.member[1][2]) > _e1416) && ((_e1506.member_1[0][2] - _e1506.member[1][2]) > _e1416))))) {
                                        let _e1596 = atomicAdd((&counters[5u]), 1u);
                                        left[_e1596] = _e775;
                                    }
                                }
                                phi_2823_ = true;
                            }
                            let _e1599 = phi_2823_;
                            phi_2824_ = _e1599;
                        } else {
                            phi_2824_ = false;
                        }
                        let _e1601 = phi_2824_;
                        continue;
                        continuing {
                            phi_1359_ = _e764;
                            break if !(_e1601);
                        }
                    }
                    workgroupBarrier();
                    let _e1604 = atomicLoad((&counters[5u]));
                    phi_2829_ = type_9(0u, 4u);
                    loop {
                        let _e1606 = phi_2829_;
                        if (_e1606.member < _e1606.member_1) {
                            phi_2830_ = type_9((_e1606.member + 1u), _e1606.member_1);
                            phi_2853_ = type_9(1u, _e1606.member);
                        } else {
                            phi_2830_ = _e1606;
                            phi_2853_ = type_9(0u, type_9().member_1);
                        }
                        let _e1618 = phi_2830_;
                        let _e1620 = phi_2853_;
                        if (bitcast<i32>(_e1620.member) != 0i) {
                            let _e1626 = (_e73 + (_e1620.member_1 * 128u));
                            if (_e1626 >= _e1604) {
                                phi_4703_ = false;
                            } else {
                                let _e1629 = left[_e1626];
                                let _e1632 = ((_e1629 >> bitcast<u32>(10i)) & 3u);
                                let _e1639 = firsts[(2u * _e1632)];
                                let _e1644 = firsts[((2u * _e1632) + 1u)];
                                let _e1647 = leaves.member[(_e1639 + ((_e1629 >> bitcast<u32>(5i)) & 31u))];
                                let _e1652 = leaves.member[(_e1644 + (_e1629 & 31u))];
                                if (_e1647.w < _e1652.w) {
                                    phi_2924_ = type_43(1u, array<u32, 4>(_e1647.x, _e1647.y, _e1652.x, _e1652.y));
                                } else {
                                    phi_2924_ = type_43(1u, array<u32, 4>(_e1652.x, _e1652.y, _e1647.x, _e1647.y));
                                }
                                let _e1662 = phi_2924_;
                                let _e1667 = paths.member[_e1662.member_1[0]];
                                let _e1682 = paths.member[_e1662.member_1[1]];
                                let _e1697 = paths.member[_e1662.member_1[2]];
                                let _e1712 = paths.member[_e1662.member_1[3]];
                                if (_e1662.member != 0u) {
                                    phi_3058_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1697.member.x - _e1667.member.x), (_e1697.member.y - _e1667.member.y), (_e1697.member.z - _e1667.member.z)), array<f32, 3>((_e1697.member_1.x - _e1667.member_1.x), (_e1697.member_1.y - _e1667.member_1.y), (_e1697.member_1.z - _e1667.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1682.member.x - _e1667.member.x), (_e1682.member.y - _e1667.member.y), (_e1682.member.z - _e1667.member.z)), array<f32, 3>((_e1682.member_1.x - _e1667.member_1.x), (_e1682.member_1.y - _e1667.member_1.y), (_e1682.member_1.z - _e1667.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1697.member.x - _e1712.member.x), (_e1697.member.y - _e1712.member.y), (_e1697.member.z - _e1712.member.z)), array<f32, 3>((_e1697.member_1.x - _e1712.member_1.x), (_e1697.member_1.y - _e1712.member_1.y), (_e1697.member_1.z - _e1712.member_1.z))), (_e91.member_4 + _e91.member_4));
                                } else {
                                    phi_3058_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1667.member.x - _e1682.member.x), (_e1667.member.y - _e1682.member.y), (_e1667.member.z - _e1682.member.z)), array<f32, 3>((_e1667.member_1.x - _e1682.member_1.x), (_e1667.member_1.y - _e1682.member_1.y), (_e1667.member_1.z - _e1682.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1697.member.x - _e1682.member.x), (_e1697.member.y - _e1682.member.y), (_e1697.member.z - _e1682.member.z)), array<f32, 3>((_e1697.member_1.x - _e1682.member_1.x), (_e1697.member_1.y - _e1682.member_1.y), (_e1697.member_1.z - _e1682.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1712.member.x - _e1682.member.x), (_e1712.member.y - _e1682.member.y), (_e1712.member.z - _e1682.member.z)), array<f32, 3>((_e1712.member_1.x - _e1682.member_1.x), (_e1712.member_1.y - _e1682.member_1.y), (_e1712.member_1.z - _e1682.member_1.z))), (_e91.member_4 + _e91.member_4));
                                }
                                let _e1785 = phi_3058_;
                                local_2 = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e1785.member[0][0], _e1785.member[0][1], _e1785.member[0][2]), array<f32, 3>(_e1785.member[1][0], _e1785.member[1][1], _e1785.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1785.member_1[0][0], _e1785.member_1[0][1], _e1785.member_1[0][2]), array<f32, 3>(_e1785.member_1[1][0], _e1785.member_1[1][1], _e1785.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1785.member_2[0][0], _e1785.member_2[0][1], _e1785.member_2[0][2]), array<f32, 3>(_e1785.member_2[1][0], _e1785.member_2[1][1], _e1785.member_2[1][2])), _e1785.member_3);
                                let _e1826 = local_2.member_1[0u];
                                let _e1832 = local_2.member_2[0u];
                                let _e1838 = ((_e1826[1] * _e1832[2]) - (_e1826[2] * _e1832[1]));
                                let _e1841 = ((_e1826[2] * _e1832[0]) - (_e1826[0] * _e1832[2]));
                                let _e1844 = ((_e1826[0] * _e1832[1]) - (_e1826[1] * _e1832[0]));
                                let _e1847 = local_2.member_1[1u];
                                let _e1853 = local_2.member_2[1u];
                                let _e1859 = ((_e1847[1] * _e1853[2]) - (_e1847[2] * _e1853[1]));
                                let _e1862 = ((_e1847[2] * _e1853[0]) - (_e1847[0] * _e1853[2]));
                                let _e1865 = ((_e1847[0] * _e1853[1]) - (_e1847[1] * _e1853[0]));
                                let _e1868 = local_2.member_1[0u];
                                let _e1874 = local_2.member_2[1u];
                                let _e1889 = local_2.member_1[1u];
                                let _e1895 = local_2.member_2[0u];
                                let _e1908 = (((_e1868[1] * _e1874[2]) - (_e1868[2] * _e1874[1])) + ((_e1889[1] * _e1895[2]) - (_e1889[2] * _e1895[1])));
                                let _e1909 = (((_e1868[2] * _e1874[0]) - (_e1868[0] * _e1874[2])) + ((_e1889[2] * _e1895[0]) - (_e1889[0] * _e1895[2])));
                                let _e1910 = (((_e1868[0] * _e1874[1]) - (_e1868[1] * _e1874[0])) + ((_e1889[0] * _e1895[1]) - (_e1889[1] * _e1895[0])));
                                let _e1913 = local_2.member[0u];
                                let _e1924 = local_2.member[1u];
                                let _e1935 = local_2.member[0u];
                                let _e1944 = ((((_e1924[0] * _e1838) + (_e1924[1] * _e1841)) + (_e1924[2] * _e1844)) + (((_e1935[0] * _e1908) + (_e1935[1] * _e1909)) + (_e1935[2] * _e1910)));
                                let _e1947 = local_2.member[0u];
                                let _e1958 = local_2.member[1u];
                                let _e1967 = ((((_e1947[0] * _e1859) + (_e1947[1] * _e1862)) + (_e1947[2] * _e1865)) + (((_e1958[0] * _e1908) + (_e1958[1] * _e1909)) + (_e1958[2] * _e1910)));
                                let _e1970 = local_2.member[1u];
                                let _e1981 = local_2.member[0u];
                                if (_e1981[0] < 0f) {
                                    phi_3338_ = -(_e1981[0]);
                                } else {
                                    phi_3338_ = _e1981[0];
                                }
                                let _e1988 = phi_3338_;
                                if (_e1981[1] < 0f) {
                                    phi_3345_ = -(_e1981[1]);
                                } else {
                                    phi_3345_ = _e1981[1];
                                }
                                let _e1992 = phi_3345_;
                                if (_e1988 > _e1992) {
                                    phi_3350_ = _e1988;
                                } else {
                                    phi_3350_ = _e1992;
                                }
                                let _e1995 = phi_3350_;
                                if (_e1981[2] < 0f) {
                                    phi_3357_ = -(_e1981[2]);
                                } else {
                                    phi_3357_ = _e1981[2];
                                }
                                let _e1999 = phi_3357_;
                                if (_e1995 > _e1999) {
                                    phi_3362_ = _e1995;
                                } else {
                                    phi_3362_ = _e1999;
                                }
                                let _e2002 = phi_3362_;
                                let _e2005 = local_2.member[1u];
                                if (_e2005[0] < 0f) {
                                    phi_3375_ = -(_e2005[0]);
                                } else {
                                    phi_3375_ = _e2005[0];
                                }
                                let _e2012 = phi_3375_;
                                if (_e2005[1] < 0f) {
                                    phi_3382_ = -(_e2005[1]);
                                } else {
                                    phi_3382_ = _e2005[1];
                                }
                                let _e2016 = phi_3382_;
                                if (_e2012 > _e2016) {
                                    phi_3387_ = _e2012;
                                } else {
                                    phi_3387_ = _e2016;
                                }
                                let _e2019 = phi_3387_;
                                if (_e2005[2] < 0f) {
                                    phi_3394_ = -(_e2005[2]);
                                } else {
                                    phi_3394_ = _e2005[2];
                                }
                                let _e2023 = phi_3394_;
                                if (_e2019 > _e2023) {
                                    phi_3399_ = _e2019;
                                } else {
                                    phi_3399_ = _e2023;
                                }
                                let _e2026 = phi_3399_;
                                if (_e2002 > _e2026) {
                                    phi_3404_ = _e2002;
                                } else {
                                    phi_3404_ = _e2026;
                                }
                                let _e2029 = phi_3404_;
                                let _e2031 = local_2.member_3;
                                let _e2032 = (_e2029 + _e2031);
                                let _e2035 = local_2.member_1[0u];
                                if (_e2035[0] < 0f) {
                                    phi_3421_ = -(_e2035[0]);
                                } else {
                                    phi_3421_ = _e2035[0];
                                }
                                let _e2042 = phi_3421_;
                                if (_e2035[1] < 0f) {
                                    phi_3428_ = -(_e2035[1]);
                                } else {
                                    phi_3428_ = _e2035[1];
                                }
                                let _e2046 = phi_3428_;
                                if (_e2042 > _e2046) {
                                    phi_3433_ = _e2042;
                                } else {
                                    phi_3433_ = _e2046;
                                }
                                let _e2049 = phi_3433_;
                                if (_e2035[2] < 0f) {
                                    phi_3440_ = -(_e2035[2]);
                                } else {
                                    phi_3440_ = _e2035[2];
                                }
                                let _e2053 = phi_3440_;
                                if (_e2049 > _e2053) {
                                    phi_3445_ = _e2049;
                                } else {
                                    phi_3445_ = _e2053;
                                }
                                let _e2056 = phi_3445_;
                                let _e2059 = local_2.member_1[1u];
                                if (_e2059[0] < 0f) {
                                    phi_3459_ = -(_e2059[0]);
                                } else {
                                    phi_3459_ = _e2059[0];
                                }
                                let _e2066 = phi_3459_;
                                if (_e2059[1] < 0f) {
                                    phi_3466_ = -(_e2059[1]);
                                } else {
                                    phi_3466_ = _e2059[1];
                                }
                                let _e2070 = phi_3466_;
                                if (_e2066 > _e2070) {
                                    phi_3471_ = _e2066;
                                } else {
                                    phi_3471_ = _e2070;
                                }
                                let _e2073 = phi_3471_;
                                if (_e2059[2] < 0f) {
                                    phi_3478_ = -(_e2059[2]);
                                } else {
                                    phi_3478_ = _e2059[2];
                                }
                                let _e2077 = phi_3478_;
                                if (_e2073 > _e2077) {
                                    phi_3483_ = _e2073;
                                } else {
                                    phi_3483_ = _e2077;
                                }
                                let _e2080 = phi_3483_;
                                if (_e2056 > _e2080) {
                                    phi_3488_ = _e2056;
                                } else {
                                    phi_3488_ = _e2080;
                                }
                                let _e2083 = phi_3488_;
                                let _e2085 = local_2.member_3;
                                let _e2086 = (_e2083 + _e2085);
                                let _e2089 = local_2.member_2[0u];
                                if (_e2089[0] < 0f) {
                                    phi_3505_ = -(_e2089[0]);
                                } else {
                                    phi_3505_ = _e2089[0];
                                }
                                let _e2096 = phi_3505_;
                                if (_e2089[1] < 0f) {
                                    phi_3512_ = -(_e2089[1]);
                                } else {
                                    phi_3512_ = _e2089[1];
                                }
                                let _e2100 = phi_3512_;
                                if (_e2096 > _e2100) {
                                    phi_3517_ = _e2096;
                                } else {
                                    phi_3517_ = _e2100;
                                }
                                let _e2103 = phi_3517_;
                                if (_e2089[2] < 0f) {
                                    phi_3524_ = -(_e2089[2]);
                                } else {
                                    phi_3524_ = _e2089[2];
                                }
                                let _e2107 = phi_3524_;
                                if (_e2103 > _e2107) {
                                    phi_3529_ = _e2103;
                                } else {
                                    phi_3529_ = _e2107;
                                }
                                let _e2110 = phi_3529_;
                                let _e2113 = local_2.member_2[1u];
                                if (_e2113[0] < 0f) {
                                    phi_3543_ = -(_e2113[0]);
                                } else {
                                    phi_3543_ = _e2113[0];
                                }
                                let _e2120 = phi_3543_;
                                if (_e2113[1] < 0f) {
                                    phi_3550_ = -(_e2113[1]);
                                } else {
                                    phi_3550_ = _e2113[1];
                                }
                                let _e2124 = phi_3550_;
                                if (_e2120 > _e2124) {
                                    phi_3555_ = _e2120;
                                } else {
                                    phi_3555_ = _e2124;
                                }
                                let _e2127 = phi_3555_;
                                if (_e2113[2] < 0f) {
                                    phi_3562_ = -(_e2113[2]);
                                } else {
                                    phi_3562_ = _e2113[2];
                                }
                                let _e2131 = phi_3562_;
                                if (_e2127 > _e2131) {
                                    phi_3567_ = _e2127;
                                } else {
                                    phi_3567_ = _e2131;
                                }
                                let _e2134 = phi_3567_;
                                if (_e2110 > _e2134) {
                                    phi_3572_ = _e2110;
                                } else {
                                    phi_3572_ = _e2134;
                                }
                                let _e2137 = phi_3572_;
                                let _e2139 = local_2.member_3;
                                let _e2140 = (_e2137 + _e2139);
                                let _e2142 = ((_e2086 * 8f) * _e2140);
                                let _e2149 = local_2.member_3;
                                if (_e1838 < 0f) {
                                    phi_3603_ = -(_e1838);
                                } else {
                                    phi_3603_ = _e1838;
                                }
                                let _e2166 = phi_3603_;
                                if (_e1841 < 0f) {
                                    phi_3609_ = -(_e1841);
                                } else {
                                    phi_3609_ = _e1841;
                                }
                                let _e2170 = phi_3609_;
                                if (_e1844 < 0f) {
                                    phi_3616_ = -(_e1844);
                                } else {
                                    phi_3616_ = _e1844;
                                }
                                let _e2175 = phi_3616_;
                                let _e2176 = ((_e2166 + _e2170) + _e2175);
                                if (_e1859 < 0f) {
                                    phi_3623_ = -(_e1859);
                                } else {
                                    phi_3623_ = _e1859;
                                }
                                let _e2180 = phi_3623_;
                                if (_e1862 < 0f) {
                                    phi_3629_ = -(_e1862);
                                } else {
                                    phi_3629_ = _e1862;
                                }
                                let _e2184 = phi_3629_;
                                if (_e1865 < 0f) {
                                    phi_3636_ = -(_e1865);
                                } else {
                                    phi_3636_ = _e1865;
                                }
                                let _e2189 = phi_3636_;
                                let _e2190 = ((_e2180 + _e2184) + _e2189);
                                if (_e2176 > _e2190) {
                                    phi_3642_ = _e2176;
                                } else {
                                    phi_3642_ = _e2190;
                                }
                                let _e2193 = phi_3642_;
                                if (_e1908 < 0f) {
                                    phi_3648_ = -(_e1908);
                                } else {
                                    phi_3648_ = _e1908;
                                }
                                let _e2197 = phi_3648_;
                                if (_e1909 < 0f) {
                                    phi_3654_ = -(_e1909);
                                } else {
                                    phi_3654_ = _e1909;
                                }
                                let _e2201 = phi_3654_;
                                if (_e1910 < 0f) {
                                    phi_3661_ = -(_e1910);
                                } else {
                                    phi_3661_ = _e1910;
                                }
                                let _e2206 = phi_3661_;
                                let _e2208 = (((_e2197 + _e2201) + _e2206) * 0.5f);
                                if (_e2193 > _e2208) {
                                    phi_3668_ = _e2193;
                                } else {
                                    phi_3668_ = _e2208;
                                }
                                let _e2211 = phi_3668_;
                                let _e2216 = local_2.member_3;
                                let _e2229 = ((((_e1913[0] * _e1838) + (_e1913[1] * _e1841)) + (_e1913[2] * _e1844)) * 3f);
                                let _e2230 = ((((_e1970[0] * _e1859) + (_e1970[1] * _e1862)) + (_e1970[2] * _e1865)) * 3f);
                                if (_e2229 < _e2230) {
                                    phi_3692_ = _e2229;
                                } else {
                                    phi_3692_ = _e2230;
                                }
                                let _e2233 = phi_3692_;
                                if (_e1944 < _e1967) {
                                    phi_3697_ = _e1944;
                                } else {
                                    phi_3697_ = _e1967;
                                }
                                let _e2236 = phi_3697_;
                                if (_e2233 < _e2236) {
                                    phi_3702_ = _e2233;
                                } else {
                                    phi_3702_ = _e2236;
                                }
                                let _e2239 = phi_3702_;
                                if (_e2229 > _e2230) {
                                    phi_3707_ = _e2229;
                                } else {
                                    phi_3707_ = _e2230;
                                }
                                let _e2242 = phi_3707_;
                                if (_e1944 > _e1967) {
                                    phi_3712_ = _e1944;
                                } else {
                                    phi_3712_ = _e1967;
                                }
                                let _e2245 = phi_3712_;
                                if (_e2242 > _e2245) {
                                    phi_3717_ = _e2242;
                                } else {
                                    phi_3717_ = _e2245;
                                }
                                let _e2248 = phi_3717_;
                                let _e2253 = -(_e2248);
                                if (_e2239 > _e2253) {
                                    phi_3727_ = _e2239;
                                } else {
                                    phi_3727_ = _e2253;
                                }
                                let _e2256 = phi_3727_;
                                let _e2258 = ((_e2256 - ((((((_e2032 * 8f) * _e2142) * (0.000000059604645f * (524f / 64f))) + ((_e2149 * 19f) * ((_e2032 * (_e2086 + _e2140)) + (_e2086 * _e2140)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2032) * ((1f + _e2086) * (1f + _e2140))))) + ((_e91.member_5 * (((_e2211 + (_e2142 * (0.000000059604645f * 8f))) + ((_e2216 * 6f) * (_e2086 + _e2140))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2086) * (1f + _e2140))))) * (3f * 1.0001f)))) > 0f);
                                if _e2258 {
                                    phi_4696_ = _e2258;
                                } else {
                                    let _e2261 = local_2.member_1[0u];
                                    let _e2267 = local_2.member_1[1u];
                                    let _e2271 = (_e2261[0] + _e2267[0]);
                                    let _e2272 = (_e2261[1] + _e2267[1]);
                                    let _e2273 = (_e2261[2] + _e2267[2]);
                                    let _e2276 = local_2.member_2[0u];
                                    let _e2282 = local_2.member_2[1u];
                                    let _e2286 = (_e2276[0] + _e2282[0]);
                                    let _e2287 = (_e2276[1] + _e2282[1]);
                                    let _e2288 = (_e2276[2] + _e2282[2]);
                                    let _e2291 = ((_e2272 * _e2288) - (_e2273 * _e2287));
                                    let _e2294 = ((_e2273 * _e2286) - (_e2271 * _e2288));
                                    let _e2297 = ((_e2271 * _e2287) - (_e2272 * _e2286));
                                    let _e2300 = local_2.member[0u];
                                    let _e2307 = local_2.member_1[0u];
                                    let _e2313 = local_2.member_2[0u];
                                    let _e2317 = (_e2300[0] - _e2307[0]);
                                    let _e2318 = (_e2300[1] - _e2307[1]);
                                    let _e2319 = (_e2300[2] - _e2307[2]);
                                    if (_e1662.member == 0u) {
                                        phi_3843_ = array<f32, 3>(_e2300[0], _e2300[1], _e2300[2]);
                                    } else {
                                        phi_3843_ = array<f32, 3>((_e2317 - _e2313[0]), (_e2318 - _e2313[1]), (_e2319 - _e2313[2]));
                                    }
                                    let _e2326 = phi_3843_;
                                    let _e2327 = (_e2300[0] - _e2313[0]);
                                    let _e2328 = (_e2300[1] - _e2313[1]);
                                    let _e2329 = (_e2300[2] - _e2313[2]);
                                    let _e2332 = local_2.member[1u];
                                    let _e2339 = local_2.member_1[1u];
                                    let _e2345 = local_2.member_2[1u];
                                    let _e2349 = (_e2332[0] - _e2339[0]);
                                    let _e2350 = (_e2332[1] - _e2339[1]);
                                    let _e2351 = (_e2332[2] - _e2339[2]);
                                    if (_e1662.member == 0u) {
                                        phi_3908_ = array<f32, 3>(_e2332[0], _e2332[1], _e2332[2]);
                                    } else {
                                        phi_3908_ = array<f32, 3>((_e2349 - _e2345[0]), (_e2350 - _e2345[1]), (_e2351 - _e2345[2]));
                                    }
                                    let _e2358 = phi_3908_;
                                    let _e2359 = (_e2332[0] - _e2345[0]);
                                    let _e2360 = (_e2332[1] - _e2345[1]);
                                    let _e2361 = (_e2332[2] - _e2345[2]);
                                    let _e2364 = local_2.member[0u];
                                    if (_e2364[0] < 0f) {
                                        phi_3930_ = -(_e2364[0]);
                                    } else {
                                        phi_3930_ = _e2364[0];
                                    }
                                    let _e2371 = phi_3930_;
                                    if (_e2364[1] < 0f) {
                                        phi_3937_ = -(_e2364[1]);
                                    } else {
                                        phi_3937_ = _e2364[1];
                                    }
                                    let _e2375 = phi_3937_;
                                    if (_e2371 > _e2375) {
                                        phi_3942_ = _e2371;
                                    } else {
                                        phi_3942_ = _e2375;
                                    }
                                    let _e2378 = phi_3942_;
                                    if (_e2364[2] < 0f) {
                                        phi_3949_ = -(_e2364[2]);
                                    } else {
                                        phi_3949_ = _e2364[2];
                                    }
                                    let _e2382 = phi_3949_;
                                    if (_e2378 > _e2382) {
                                        phi_3954_ = _e2378;
                                    } else {
                                        phi_3954_ = _e2382;
                                    }
                                    let _e2385 = phi_3954_;
                                    let _e2388 = local_2.member[1u];
                                    if (_e2388[0] < 0f) {
                                        phi_3967_ = -(_e2388[0]);
                                    } else {
                                        phi_3967_ = _e2388[0];
                                    }
                                    let _e2395 = phi_3967_;
                                    if (_e2388[1] < 0f) {
                                        phi_3974_ = -(_e2388[1]);
                                    } else {
                                        phi_3974_ = _e2388[1];
                                    }
                                    let _e2399 = phi_3974_;
                                    if (_e2395 > _e2399) {
                                        phi_3979_ = _e2395;
                                    } else {
                                        phi_3979_ = _e2399;
                                    }
                                    let _e2402 = phi_3979_;
                                    if (_e2388[2] < 0f) {
                                        phi_3986_ = -(_e2388[2]);
                                    } else {
                                        phi_3986_ = _e2388[2];
                                    }
                                    let _e2406 = phi_3986_;
                                    if (_e2402 > _e2406) {
                                        phi_3991_ = _e2402;
                                    } else {
                                        phi_3991_ = _e2406;
                                    }
                                    let _e2409 = phi_3991_;
                                    if (_e2385 > _e2409) {
                                        phi_3996_ = _e2385;
                                    } else {
                                        phi_3996_ = _e2409;
                                    }
                                    let _e2412 = phi_3996_;
                                    let _e2414 = local_2.member_3;
                                    let _e2418 = local_2.member_1[0u];
                                    if (_e2418[0] < 0f) {
                                        phi_4013_ = -(_e2418[0]);
                                    } else {
                                        phi_4013_ = _e2418[0];
                                    }
                                    let _e2425 = phi_4013_;
                                    if (_e2418[1] < 0f) {
                                        phi_4020_ = -(_e2418[1]);
                                    } else {
                                        phi_4020_ = _e2418[1];
                                    }
                                    let _e2429 = phi_4020_;
                                    if (_e2425 > _e2429) {
                                        phi_4025_ = _e2425;
                                    } else {
                                        phi_4025_ = _e2429;
                                    }
                                    let _e2432 = phi_4025_;
                                    if (_e2418[2] < 0f) {
                                        phi_4032_ = -(_e2418[2]);
                                    } else {
                                        phi_4032_ = _e2418[2];
                                    }
                                    let _e2436 = phi_4032_;
                                    if (_e2432 > _e2436) {
                                        phi_4037_ = _e2432;
                                    } else {
                                        phi_4037_ = _e2436;
                                    }
                                    let _e2439 = phi_4037_;
                                    let _e2442 = local_2.member_1[1u];
                                    if (_e2442[0] < 0f) {
                                        phi_4051_ = -(_e2442[0]);
                                    } else {
                                        phi_4051_ = _e2442[0];
                                    }
                                    let _e2449 = phi_4051_;
                                    if (_e2442[1] < 0f) {
                                        phi_4058_ = -(_e2442[1]);
                                    } else {
                                        phi_4058_ = _e2442[1];
                                    }
                                    let _e2453 = phi_4058_;
                                    if (_e2449 > _e2453) {
                                        phi_4063_ = _e2449;
                                    } else {
                                        phi_4063_ = _e2453;
                                    }
                                    let _e2456 = phi_4063_;
                                    if (_e2442[2] < 0f) {
                                        phi_4070_ = -(_e2442[2]);
                                    } else {
                                        phi_4070_ = _e2442[2];
                                    }
                                    let _e2460 = phi_4070_;
                                    if (_e2456 > _e2460) {
                                        phi_4075_ = _e2456;
                                    } else {
                                        phi_4075_ = _e2460;
                                    }
                                    let _e2463 = phi_4075_;
                                    if (_e2439 > _e2463) {
                                        phi_4080_ = _e2439;
                                    } else {
                                        phi_4080_ = _e2463;
                                    }
                                    let _e2466 = phi_4080_;
                                    let _e2468 = local_2.member_3;
                                    let _e2472 = local_2.member_2[0u];
                                    if (_e2472[0] < 0f) {
                                        phi_4097_ = -(_e2472[0]);
                                    } else {
                                        phi_4097_ = _e2472[0];
                                    }
                                    let _e2479 = phi_4097_;
                                    if (_e2472[1] < 0f) {
                                        phi_4104_ = -(_e2472[1]);
                                    } else {
                                        phi_4104_ = _e2472[1];
                                    }
                                    let _e2483 = phi_4104_;
                                    if (_e2479 > _e2483) {
                                        phi_4109_ = _e2479;
                                    } else {
                                        phi_4109_ = _e2483;
                                    }
                                    let _e2486 = phi_4109_;
                                    if (_e2472[2] < 0f) {
                                        phi_4116_ = -(_e2472[2]);
                                    } else {
                                        phi_4116_ = _e2472[2];
                                    }
                                    let _e2490 = phi_4116_;
                                    if (_e2486 > _e2490) {
                                        phi_4121_ = _e2486;
                                    } else {
                                        phi_4121_ = _e2490;
                                    }
                                    let _e2493 = phi_4121_;
                                    let _e2496 = local_2.member_2[1u];
                                    if (_e2496[0] < 0f) {
                                        phi_4135_ = -(_e2496[0]);
                                    } else {
                                        phi_4135_ = _e2496[0];
                                    }
                                    let _e2503 = phi_4135_;
                                    if (_e2496[1] < 0f) {
                                        phi_4142_ = -(_e2496[1]);
                                    } else {
                                        phi_4142_ = _e2496[1];
                                    }
                                    let _e2507 = phi_4142_;
                                    if (_e2503 > _e2507) {
                                        phi_4147_ = _e2503;
                                    } else {
                                        phi_4147_ = _e2507;
                                    }
                                    let _e2510 = phi_4147_;
                                    if (_e2496[2] < 0f) {
                                        phi_4154_ = -(_e2496[2]);
                                    } else {
                                        phi_4154_ = _e2496[2];
                                    }
                                    let _e2514 = phi_4154_;
                                    if (_e2510 > _e2514) {
                                        phi_4159_ = _e2510;
                                    } else {
                                        phi_4159_ = _e2514;
                                    }
                                    let _e2517 = phi_4159_;
                                    if (_e2493 > _e2517) {
                                        phi_4164_ = _e2493;
                                    } else {
                                        phi_4164_ = _e2517;
                                    }
                                    let _e2520 = phi_4164_;
                                    let _e2522 = local_2.member_3;
                                    let _e2526 = ((((_e2412 + _e2414) + (_e2466 + _e2468)) + (_e2520 + _e2522)) * 2f);
                                    let _e2529 = local_2.member_3;
                                    let _e2533 = (((_e91.member_5 * 1.0001f) + (_e2529 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e2536 = ((_e2294 * _e2273) - (_e2297 * _e2272));
                                    let _e2539 = ((_e2297 * _e2271) - (_e2291 * _e2273));
                                    let _e2542 = ((_e2291 * _e2272) - (_e2294 * _e2271));
                                    let _e2547 = (((_e2536 * _e2300[0]) + (_e2539 * _e2300[1])) + (_e2542 * _e2300[2]));
                                    let _e2552 = (((_e2536 * _e2317) + (_e2539 * _e2318)) + (_e2542 * _e2319));
                                    let _e2557 = (((_e2536 * _e2327) + (_e2539 * _e2328)) + (_e2542 * _e2329));
                                    let _e2565 = (((_e2536 * _e2326[0]) + (_e2539 * _e2326[1])) + (_e2542 * _e2326[2]));
                                    let _e2570 = (((_e2536 * _e2332[0]) + (_e2539 * _e2332[1])) + (_e2542 * _e2332[2]));
                                    let _e2575 = (((_e2536 * _e2349) + (_e2539 * _e2350)) + (_e2542 * _e2351));
                                    let _e2580 = (((_e2536 * _e2359) + (_e2539 * _e2360)) + (_e2542 * _e2361));
                                    let _e2588 = (((_e2536 * _e2358[0]) + (_e2539 * _e2358[1])) + (_e2542 * _e2358[2]));
                                    if (_e2547 < _e2552) {
                                        phi_4243_ = _e2547;
                                    } else {
                                        phi_4243_ = _e2552;
                                    }
                                    let _e2591 = phi_4243_;
                                    if (_e2557 < _e2565) {
                                        phi_4248_ = _e2557;
                                    } else {
                                        phi_4248_ = _e2565;
                                    }
                                    let _e2594 = phi_4248_;
                                    if (_e2591 < _e2594) {
                                        phi_4253_ = _e2591;
                                    } else {
                                        phi_4253_ = _e2594;
                                    }
                                    let _e2597 = phi_4253_;
                                    if (_e2570 < _e2575) {
                                        phi_4258_ = _e2570;
                                    } else {
                                        phi_4258_ = _e2575;
                                    }
                                    let _e2600 = phi_4258_;
                                    if (_e2580 < _e2588) {
                                        phi_4263_ = _e2580;
                                    } else {
                                        phi_4263_ = _e2588;
                                    }
                                    let _e2603 = phi_4263_;
                                    if (_e2600 < _e2603) {
                                        phi_4268_ = _e2600;
                                    } else {
                                        phi_4268_ = _e2603;
                                    }
                                    let _e2606 = phi_4268_;
                                    if (_e2597 < _e2606) {
                                        phi_4273_ = _e2597;
                                    } else {
                                        phi_4273_ = _e2606;
                                    }
                                    let _e2609 = phi_4273_;
                                    if (_e2547 > _e2552) {
                                        phi_4278_ = _e2547;
                                    } else {
                                        phi_4278_ = _e2552;
                                    }
                                    let _e2612 = phi_4278_;
                                    if (_e2557 > _e2565) {
                                        phi_4283_ = _e2557;
                                    } else {
                                        phi_4283_ = _e2565;
                                    }
                                    let _e2615 = phi_4283_;
                                    if (_e2612 > _e2615) {
                                        phi_4288_ = _e2612;
                                    } else {
                                        phi_4288_ = _e2615;
                                    }
                                    let _e2618 = phi_4288_;
                                    if (_e2570 > _e2575) {
                                        phi_4293_ = _e2570;
                                    } else {
                                        phi_4293_ = _e2575;
                                    }
                                    let _e2621 = phi_4293_;
                                    if (_e2580 > _e2588) {
                                        phi_4298_ = _e2580;
                                    } else {
                                        phi_4298_ = _e2588;
                                    }
                                    let _e2624 = phi_4298_;
                                    if (_e2621 > _e2624) {
                                        phi_4303_ = _e2621;
                                    } else {
                                        phi_4303_ = _e2624;
                                    }
                                    let _e2627 = phi_4303_;
                                    if (_e2618 > _e2627) {
                                        phi_4308_ = _e2618;
                                    } else {
                                        phi_4308_ = _e2627;
                                    }
                                    let _e2630 = phi_4308_;
                                    if (_e2536 < 0f) {
                                        phi_4314_ = -(_e2536);
                                    } else {
                                        phi_4314_ = _e2536;
                                    }
                                    let _e2634 = phi_4314_;
                                    if (_e2539 < 0f) {
                                        phi_4320_ = -(_e2539);
                                    } else {
                                        phi_4320_ = _e2539;
                                    }
                                    let _e2638 = phi_4320_;
                                    if (_e2542 < 0f) {
                                        phi_4327_ = -(_e2542);
                                    } else {
                                        phi_4327_ = _e2542;
                                    }
                                    let _e2643 = phi_4327_;
                                    let _e2644 = ((_e2634 + _e2638) + _e2643);
                                    let _e2649 = -(_e2630);
                                    if (_e2609 > _e2649) {
                                        phi_4338_ = _e2609;
                                    } else {
                                        phi_4338_ = _e2649;
                                    }
                                    let _e2652 = phi_4338_;
                                    let _e2657 = (((_e2652 - ((_e2644 * _e2526) * (0.000000059604645f * (17f / 2f)))) - (_e2644 * _e2533)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e2660 = ((_e2294 * _e2288) - (_e2297 * _e2287));
                                    let _e2663 = ((_e2297 * _e2286) - (_e2291 * _e2288));
                                    let _e2666 = ((_e2291 * _e2287) - (_e2294 * _e2286));
                                    let _e2671 = (((_e2660 * _e2300[0]) + (_e2663 * _e2300[1])) + (_e2666 * _e2300[2]));
                                    let _e2676 = (((_e2660 * _e2317) + (_e2663 * _e2318)) + (_e2666 * _e2319));
                                    let _e2681 = (((_e2660 * _e2327) + (_e2663 * _e2328)) + (_e2666 * _e2329));
                                    let _e2689 = (((_e2660 * _e2326[0]) + (_e2663 * _e2326[1])) + (_e2666 * _e2326[2]));
                                    let _e2694 = (((_e2660 * _e2332[0]) + (_e2663 * _e2332[1])) + (_e2666 * _e2332[2]));
                                    let _e2699 = (((_e2660 * _e2349) + (_e2663 * _e2350)) + (_e2666 * _e2351));
                                    let _e2704 = (((_e2660 * _e2359) + (_e2663 * _e2360)) + (_e2666 * _e2361));
                                    let _e2712 = (((_e2660 * _e2358[0]) + (_e2663 * _e2358[1])) + (_e2666 * _e2358[2]));
                                    if (_e2671 < _e2676) {
                                        phi_4409_ = _e2671;
                                    } else {
                                        phi_4409_ = _e2676;
                                    }
                                    let _e2715 = phi_4409_;
                                    if (_e2681 < _e2689) {
                                        phi_4414_ = _e2681;
                                    } else {
                                        phi_4414_ = _e2689;
                                    }
                                    let _e2718 = phi_4414_;
                                    if (_e2715 < _e2718) {
                                        phi_4419_ = _e2715;
                                    } else {
                                        phi_4419_ = _e2718;
                                    }
                                    let _e2721 = phi_4419_;
                                    if (_e2694 < _e2699) {
                                        phi_4424_ = _e2694;
                                    } else {
                                        phi_4424_ = _e2699;
                                    }
                                    let _e2724 = phi_4424_;
                                    if (_e2704 < _e2712) {
                                        phi_4429_ = _e2704;
                                    } else {
                                        phi_4429_ = _e2712;
                                    }
                                    let _e2727 = phi_4429_;
                                    if (_e2724 < _e2727) {
                                        phi_4434_ = _e2724;
                                    } else {
                                        phi_4434_ = _e2727;
                                    }
                                    let _e2730 = phi_4434_;
                                    if (_e2721 < _e2730) {
                                        phi_4439_ = _e2721;
                                    } else {
                                        phi_4439_ = _e2730;
                                    }
                                    let _e2733 = phi_4439_;
                                    if (_e2671 > _e2676) {
                                        phi_4444_ = _e2671;
                                    } else {
                                        phi_4444_ = _e2676;
                                    }
                                    let _e2736 = phi_4444_;
                                    if (_e2681 > _e2689) {
                                        phi_4449_ = _e2681;
                                    } else {
                                        phi_4449_ = _e2689;
                                    }
                                    let _e2739 = phi_4449_;
                                    if (_e2736 > _e2739) {
                                        phi_4454_ = _e2736;
                                    } else {
                                        phi_4454_ = _e2739;
                                    }
                                    let _e2742 = phi_4454_;
                                    if (_e2694 > _e2699) {
                                        phi_4459_ = _e2694;
                                    } else {
                                        phi_4459_ = _e2699;
                                    }
                                    let _e2745 = phi_4459_;
                                    if (_e2704 > _e2712) {
                                        phi_4464_ = _e2704;
                                    } else {
                                        phi_4464_ = _e2712;
                                    }
                                    let _e2748 = phi_4464_;
                                    if (_e2745 > _e2748) {
                                        phi_4469_ = _e2745;
                                    } else {
                                        phi_4469_ = _e2748;
                                    }
                                    let _e2751 = phi_4469_;
                                    if (_e2742 > _e2751) {
                                        phi_4474_ = _e2742;
                                    } else {
                                        phi_4474_ = _e2751;
                                    }
                                    let _e2754 = phi_4474_;
                                    if (_e2660 < 0f) {
                                        phi_4480_ = -(_e2660);
                                    } else {
                                        phi_4480_ = _e2660;
                                    }
                                    let _e2758 = phi_4480_;
                                    if (_e2663 < 0f) {
                                        phi_4486_ = -(_e2663);
                                    } else {
                                        phi_4486_ = _e2663;
                                    }
                                    let _e2762 = phi_4486_;
                                    if (_e2666 < 0f) {
                                        phi_4493_ = -(_e2666);
                                    } else {
                                        phi_4493_ = _e2666;
                                    }
                                    let _e2767 = phi_4493_;
                                    let _e2768 = ((_e2758 + _e2762) + _e2767);
                                    let _e2773 = -(_e2754);
                                    if (_e2733 > _e2773) {
                                        phi_4504_ = _e2733;
                                    } else {
                                        phi_4504_ = _e2773;
                                    }
                                    let _e2776 = phi_4504_;
                                    let _e2781 = (((_e2776 - ((_e2768 * _e2526) * (0.000000059604645f * (17f / 2f)))) - (_e2768 * _e2533)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e2657 > _e2781) {
                                        phi_4514_ = _e2657;
                                    } else {
                                        phi_4514_ = _e2781;
                                    }
                                    let _e2784 = phi_4514_;
                                    if (_e1662.member == 0u) {
                                        let _e2786 = (_e2286 - _e2271);
                                        let _e2787 = (_e2287 - _e2272);
                                        let _e2788 = (_e2288 - _e2273);
                                        let _e2791 = ((_e2294 * _e2788) - (_e2297 * _e2787));
                                        let _e2794 = ((_e2297 * _e2786) - (_e2291 * _e2788));
                                        let _e2797 = ((_e2291 * _e2787) - (_e2294 * _e2786));
                                        let _e2802 = (((_e2791 * _e2300[0]) + (_e2794 * _e2300[1])) + (_e2797 * _e2300[2]));
                                        let _e2807 = (((_e2791 * _e2317) + (_e2794 * _e2318)) + (_e2797 * _e2319));
                                        let _e2812 = (((_e2791 * _e2327) + (_e2794 * _e2328)) + (_e2797 * _e2329));
                                        let _e2820 = (((_e2791 * _e2326[0]) + (_e2794 * _e2326[1])) + (_e2797 * _e2326[2]));
                                        let _e2825 = (((_e2791 * _e2332[0]) + (_e2794 * _e2332[1])) + (_e2797 * _e2332[2]));
                                        let _e2830 = (((_e2791 * _e2349) + (_e2794 * _e2350)) + (_e2797 * _e2351));
                                        let _e2835 = (((_e2791 * _e2359) + (_e2794 * _e2360)) + (_e2797 * _e2361));
                                        let _e2843 = (((_e2791 * _e2358[0]) + (_e2794 * _e2358[1])) + (_e2797 * _e2358[2]));
                                        if (_e2802 < _e2807) {
                                            phi_4587_ = _e2802;
                                        } else {
                                            phi_4587_ = _e2807;
                                        }
                                        let _e2846 = phi_4587_;
                                        if (_e2812 < _e2820) {
                                            phi_4592_ = _e2812;
                                        } else {
                                            phi_4592_ = _e2820;
                                        }
                                        let _e2849 = phi_4592_;
                                        if (_e2846 < _e2849) {
                                            phi_4597_ = _e2846;
                                        } else {
                                            phi_4597_ = _e2849;
                                        }
                                        let _e2852 = phi_4597_;
                                        if (_e2825 < _e2830) {
                                            phi_4602_ = _e2825;
                                        } else {
                                            phi_4602_ = _e2830;
                                        }
                                        let _e2855 = phi_4602_;
                                        if (_e2835 < _e2843) {
                                            phi_4607_ = _e2835;
                                        } else {
                                            phi_4607_ = _e2843;
                                        }
                                        let _e2858 = phi_4607_;
                                        if (_e2855 < _e2858) {
                                            phi_4612_ = _e2855;
                                        } else {
                                            phi_4612_ = _e2858;
                                        }
                                        let _e2861 = phi_4612_;
                                        if (_e2852 < _e2861) {
                                            phi_4617_ = _e2852;
                                        } else {
                                            phi_4617_ = _e2861;
                                        }
                                        let _e2864 = phi_4617_;
                                        if (_e2802 > _e2807) {
                                            phi_4622_ = _e2802;
                                        } else {
                                            phi_4622_ = _e2807;
                                        }
                                        let _e2867 = phi_4622_;
                                        if (_e2812 > _e2820) {
                                            phi_4627_ = _e2812;
                                        } else {
                                            phi_4627_ = _e2820;
                                        }
                                        let _e2870 = phi_4627_;
                                        if (_e2867 > _e2870) {
                                            phi_4632_ = _e2867;
                                        } else {
                                            phi_4632_ = _e2870;
                                        }
                                        let _e2873 = phi_4632_;
                                        if (_e2825 > _e2830) {
                                            phi_4637_ = _e2825;
                                        } else {
                                            phi_4637_ = _e2830;
                                        }
                                        let _e2876 = phi_4637_;
                                        if (_e2835 > _e2843) {
                                            phi_4642_ = _e2835;
                                        } else {
                                            phi_4642_ = _e2843;
                                        }
                                        let _e2879 = phi_4642_;
                                        if (_e2876 > _e2879) {
                                            phi_4647_ = _e2876;
                                        } else {
                                            phi_4647_ = _e2879;
                                        }
                                        let _e2882 = phi_4647_;
                                        if (_e2873 > _e2882) {
                                            phi_4652_ = _e2873;
                                        } else {
                                            phi_4652_ = _e2882;
                                        }
                                        let _e2885 = phi_4652_;
                                        if (_e2791 < 0f) {
                                            phi_4658_ = -(_e2791);
                                        } else {
                                            phi_4658_ = _e2791;
                                        }
                                        let _e2889 = phi_4658_;
                                        if (_e2794 < 0f) {
                                            phi_4664_ = -(_e2794);
                                        } else {
                                            phi_4664_ = _e2794;
                                        }
                                        let _e2893 = phi_4664_;
                                        if (_e2797 < 0f) {
                                            phi_4671_ = -(_e2797);
                                        } else {
                                            phi_4671_ = _e2797;
                                        }
                                        let _e2898 = phi_4671_;
                                        let _e2899 = ((_e2889 + _e2893) + _e2898);
                                        let _e2904 = -(_e2885);
                                        if (_e2864 > _e2904) {
                                            phi_4682_ = _e2864;
                                        } else {
                                            phi_4682_ = _e2904;
                                        }
                                        let _e2907 = phi_4682_;
                                        let _e2912 = (((_e2907 - ((_e2899 * _e2526) * (0.000000059604645f * (17f / 2f)))) - (_e2899 * _e2533)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e2784 > _e2912) {
                                            phi_4692_ = _e2784;
                                        } else {
                                            phi_4692_ = _e2912;
                                        }
                                        let _e2915 = phi_4692_;
                                        phi_4693_ = _e2915;
                                    } else {
                                        phi_4693_ = _e2784;
                                    }
                                    let _e2917 = phi_4693_;
                                    phi_4696_ = (_e2258 || (_e2917 > 0f));
                                }
                                let _e2921 = phi_4696_;
                                if _e2921 {
                                } else {
                                    let _e2923 = atomicAdd((&counters[6u]), 1u);
                                    hits[_e2923] = _e1629;
                                }
                                phi_4703_ = true;
                            }
                            let _e2926 = phi_4703_;
                            phi_4704_ = _e2926;
                        } else {
                            phi_4704_ = false;
                        }
                        let _e2928 = phi_4704_;
                        continue;
                        continuing {
                            phi_2829_ = _e1618;
                            break if !(_e2928);
                        }
                    }
                    workgroupBarrier();
                    let _e2931 = atomicLoad((&counters[6u]));
                    phi_4709_ = type_9(0u, 4u);
                    loop {
                        let _e2933 = phi_4709_;
                        if (_e2933.member < _e2933.member_1) {
                            phi_4710_ = type_9((_e2933.member + 1u), _e2933.member_1);
                            phi_4733_ = type_9(1u, _e2933.member);
                        } else {
                            phi_4710_ = _e2933;
                            phi_4733_ = type_9(0u, type_9().member_1);
                        }
                        let _e2945 = phi_4710_;
                        let _e2947 = phi_4733_;
                        if (bitcast<i32>(_e2947.member) != 0i) {
                            let _e2953 = (_e73 + (_e2947.member_1 * 128u));
                            if (_e2953 >= _e2931) {
                                phi_8290_ = false;
                            } else {
                                let _e2956 = hits[_e2953];
                                let _e2959 = ((_e2956 >> bitcast<u32>(10i)) & 3u);
                                let _e2966 = firsts[(2u * _e2959)];
                                let _e2971 = firsts[((2u * _e2959) + 1u)];
                                let _e2974 = leaves.member[(_e2966 + ((_e2956 >> bitcast<u32>(5i)) & 31u))];
                                let _e2979 = leaves.member[(_e2971 + (_e2956 & 31u))];
                                if (_e2974.w < _e2979.w) {
                                    phi_4804_ = type_43(1u, array<u32, 4>(_e2974.x, _e2974.y, _e2979.x, _e2979.y));
                                } else {
                                    phi_4804_ = type_43(1u, array<u32, 4>(_e2979.x, _e2979.y, _e2974.x, _e2974.y));
                                }
                                let _e2989 = phi_4804_;
                                let _e2994 = paths.member[_e2989.member_1[0]];
                                let _e3009 = paths.member[_e2989.member_1[1]];
                                let _e3024 = paths.member[_e2989.member_1[2]];
                                let _e3039 = paths.member[_e2989.member_1[3]];
                                if (_e2989.member != 0u) {
                                    phi_4938_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e3024.member.x - _e2994.member.x), (_e3024.member.y - _e2994.member.y), (_e3024.member.z - _e2994.member.z)), array<f32, 3>((_e3024.member_1.x - _e2994.member_1.x), (_e3024.member_1.y - _e2994.member_1.y), (_e3024.member_1.z - _e2994.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3009.member.x - _e2994.member.x), (_e3009.member.y - _e2994.member.y), (_e3009.member.z - _e2994.member.z)), array<f32, 3>((_e3009.member_1.x - _e2994.member_1.x), (_e3009.member_1.y - _e2994.member_1.y), (_e3009.member_1.z - _e2994.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3024.member.x - _e3039.member.x), (_e3024.member.y - _e3039.member.y), (_e3024.member.z - _e3039.member.z)), array<f32, 3>((_e3024.member_1.x - _e3039.member_1.x), (_e3024.member_1.y - _e3039.member_1.y), (_e3024.member_1.z - _e3039.member_1.z))), (_e91.member_4 + _e91.member_4));
                                } else {
                                    phi_4938_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e2994.member.x - _e3009.member.x), (_e2994.member.y - _e3009.member.y), (_e2994.member.z - _e3009.member.z)), array<f32, 3>((_e2994.member_1.x - _e3009.member_1.x), (_e2994.member_1.y - _e3009.member_1.y), (_e2994.member_1.z - _e3009.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3024.member.x - _e3009.member.x), (_e3024.member.y - _e3009.member.y), (_e3024.member.z - _e3009.member.z)), array<f32, 3>((_e3024.member_1.x - _e3009.member_1.x), (_e3024.member_1.y - _e3009.member_1.y), (_e3024.member_1.z - _e3009.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3039.member.x - _e3009.member.x), (_e3039.member.y - _e3009.member.y), (_e3039.member.z - _e3009.member.z)), array<f32, 3>((_e3039.member_1.x - _e3009.member_1.x), (_e3039.member_1.y - _e3009.member_1.y), (_e3039.member_1.z - _e3009.member_1.z))), (_e91.member_4 + _e91.member_4));
                                }
                                let _e3112 = phi_4938_;
                                let _e3126 = ((_e3112.member[0][0] + _e3112.member[1][0]) * 0.5f);
                                let _e3127 = ((_e3112.member[0][1] + _e3112.member[1][1]) * 0.5f);
                                let _e3128 = ((_e3112.member[0][2] + _e3112.member[1][2]) * 0.5f);
                                let _e3142 = ((_e3112.member_1[0][0] + _e3112.member_1[1][0]) * 0.5f);
                                let _e3143 = ((_e3112.member_1[0][1] + _e3112.member_1[1][1]) * 0.5f);
                                let _e3144 = ((_e3112.member_1[0][2] + _e3112.member_1[1][2]) * 0.5f);
                                let _e3158 = ((_e3112.member_2[0][0] + _e3112.member_2[1][0]) * 0.5f);
                                let _e3159 = ((_e3112.member_2[0][1] + _e3112.member_2[1][1]) * 0.5f);
                                let _e3160 = ((_e3112.member_2[0][2] + _e3112.member_2[1][2]) * 0.5f);
                                local = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e3112.member[0][0], _e3112.member[0][1], _e3112.member[0][2]), array<f32, 3>(_e3126, _e3127, _e3128)), array<array<f32, 3>, 2>(array<f32, 3>(_e3112.member_1[0][0], _e3112.member_1[0][1], _e3112.member_1[0][2]), array<f32, 3>(_e3142, _e3143, _e3144)), array<array<f32, 3>, 2>(array<f32, 3>(_e3112.member_2[0][0], _e3112.member_2[0][1], _e3112.member_2[0][2]), array<f32, 3>(_e3158, _e3159, _e3160)), _e3112.member_3);
                                local_1 = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e3126, _e3127, _e3128), array<f32, 3>(_e3112.member[1][0], _e3112.member[1][1], _e3112.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e3142, _e3143, _e3144), array<f32, 3>(_e3112.member_1[1][0], _e3112.member_1[1][1], _e3112.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e3158, _e3159, _e3160), array<f32, 3>(_e3112.member_2[1][0], _e3112.member_2[1][1], _e3112.member_2[1][2])), _e3112.member_3);
                                let _e3215 = local.member_1[0u];
                                let _e3221 = local.member_2[0u];
                                let _e3227 = ((_e3215[1] * _e3221[2]) - (_e3215[2] * _e3221[1]));
                                let _e3230 = ((_e3215[2] * _e3221[0]) - (_e3215[0] * _e3221[2]));
                                let _e3233 = ((_e3215[0] * _e3221[1]) - (_e3215[1] * _e3221[0]));
                                let _e3236 = local.member_1[1u];
                                let _e3242 = local.member_2[1u];
                                let _e3248 = ((_e3236[1] * _e3242[2]) - (_e3236[2] * _e3242[1]));
                                let _e3251 = ((_e3236[2] * _e3242[0]) - (_e3236[0] * _e3242[2]));
                                let _e3254 = ((_e3236[0] * _e3242[1]) - (_e3236[1] * _e3242[0]));
                                let _e3257 = local.member_1[0u];
                                let _e3263 = local.member_2[1u];
                                let _e3278 = local.member_1[1u];
                                let _e3284 = local.member_2[0u];
                                let _e3297 = (((_e3257[1] * _e3263[2]) - (_e3257[2] * _e3263[1])) + ((_e3278[1] * _e3284[2]) - (_e3278[2] * _e3284[1])));
                                let _e3298 = (((_e3257[2] * _e3263[0]) - (_e3257[0] * _e3263[2])) + ((_e3278[2] * _e3284[0]) - (_e3278[0] * _e3284[2])));
                                let _e3299 = (((_e3257[0] * _e3263[1]) - (_e3257[1] * _e3263[0])) + ((_e3278[0] * _e3284[1]) - (_e3278[1] * _e3284[0])));
                                let _e3302 = local.member[0u];
                                let _e3313 = local.member[1u];
                                let _e3324 = local.member[0u];
                                let _e3333 = ((((_e3313[0] * _e3227) + (_e3313[1] * _e3230)) + (_e3313[2] * _e3233)) + (((_e3324[0] * _e3297) + (_e3324[1] * _e3298)) + (_e3324[2] * _e3299)));
                                let _e3336 = local.member[0u];
                                let _e3347 = local.member[1u];
                                let _e3356 = ((((_e3336[0] * _e3248) + (_e3336[1] * _e3251)) + (_e3336[2] * _e3254)) + (((_e3347[0] * _e3297) + (_e3347[1] * _e3298)) + (_e3347[2] * _e3299)));
                                let _e3359 = local.member[1u];
                                let _e3370 = local.member[0u];
                                if (_e3370[0] < 0f) {
                                    phi_5317_ = -(_e3370[0]);
                                } else {
                                    phi_5317_ = _e3370[0];
                                }
                                let _e3377 = phi_5317_;
                                if (_e3370[1] < 0f) {
                                    phi_5324_ = -(_e3370[1]);
                                } else {
                                    phi_5324_ = _e3370[1];
                                }
                                let _e3381 = phi_5324_;
                                if (_e3377 > _e3381) {
                                    phi_5329_ = _e3377;
                                } else {
                                    phi_5329_ = _e3381;
                                }
                                let _e3384 = phi_5329_;
                                if (_e3370[2] < 0f) {
                                    phi_5336_ = -(_e3370[2]);
                                } else {
                                    phi_5336_ = _e3370[2];
                                }
                                let _e3388 = phi_5336_;
                                if (_e3384 > _e3388) {
                                    phi_5341_ = _e3384;
                                } else {
                                    phi_5341_ = _e3388;
                                }
                                let _e3391 = phi_5341_;
                                let _e3394 = local.member[1u];
                                if (_e3394[0] < 0f) {
                                    phi_5354_ = -(_e3394[0]);
                                } else {
                                    phi_5354_ = _e3394[0];
                                }
                                let _e3401 = phi_5354_;
                                if (_e3394[1] < 0f) {
                                    phi_5361_ = -(_e3394[1]);
                                } else {
                                    phi_5361_ = _e3394[1];
                                }
                                let _e3405 = phi_5361_;
                                if (_e3401 > _e3405) {
                                    phi_5366_ = _e3401;
                                } else {
                                    phi_5366_ = _e3405;
                                }
                                let _e3408 = phi_5366_;
                                if (_e3394[2] < 0f) {
                                    phi_5373_ = -(_e3394[2]);
                                } else {
                                    phi_5373_ = _e3394[2];
                                }
                                let _e3412 = phi_5373_;
                                if (_e3408 > _e3412) {
                                    phi_5378_ = _e3408;
                                } else {
                                    phi_5378_ = _e3412;
                                }
                                let _e3415 = phi_5378_;
                                if (_e3391 > _e3415) {
                                    phi_5383_ = _e3391;
                                } else {
                                    phi_5383_ = _e3415;
                                }
                                let _e3418 = phi_5383_;
                                let _e3420 = local.member_3;
                                let _e3421 = (_e3418 + _e3420);
                                let _e3424 = local.member_1[0u];
                                if (_e3424[0] < 0f) {
                                    phi_5400_ = -(_e3424[0]);
                                } else {
                                    phi_5400_ = _e3424[0];
                                }
                                let _e3431 = phi_5400_;
                                if (_e3424[1] < 0f) {
                                    phi_5407_ = -(_e3424[1]);
                                } else {
                                    phi_5407_ = _e3424[1];
                                }
                                let _e3435 = phi_5407_;
                                if (_e3431 > _e3435) {
                                    phi_5412_ = _e3431;
                                } else {
                                    phi_5412_ = _e3435;
                                }
                                let _e3438 = phi_5412_;
                                if (_e3424[2] < 0f) {
                                    phi_5419_ = -(_e3424[2]);
                                } else {
                                    phi_5419_ = _e3424[2];
                                }
                                let _e3442 = phi_5419_;
                                if (_e3438 > _e3442) {
                                    phi_5424_ = _e3438;
                                } else {
                                    phi_5424_ = _e3442;
                                }
                                let _e3445 = phi_5424_;
                                let _e3448 = local.member_1[1u];
                                if (_e3448[0] < 0f) {
                                    phi_5438_ = -(_e3448[0]);
                                } else {
                                    phi_5438_ = _e3448[0];
                                }
                                let _e3455 = phi_5438_;
                                if (_e3448[1] < 0f) {
                                    phi_5445_ = -(_e3448[1]);
                                } else {
                                    phi_5445_ = _e3448[1];
                                }
                                let _e3459 = phi_5445_;
                                if (_e3455 > _e3459) {
                                    phi_5450_ = _e3455;
                                } else {
                                    phi_5450_ = _e3459;
                                }
                                let _e3462 = phi_5450_;
                                if (_e3448[2] < 0f) {
                                    phi_5457_ = -(_e3448[2]);
                                } else {
                                    phi_5457_ = _e3448[2];
                                }
                                let _e3466 = phi_5457_;
                                if (_e3462 > _e3466) {
                                    phi_5462_ = _e3462;
                                } else {
                                    phi_5462_ = _e3466;
                                }
                                let _e3469 = phi_5462_;
                                if (_e3445 > _e3469) {
                                    phi_5467_ = _e3445;
                                } else {
                                    phi_5467_ = _e3469;
                                }
                                let _e3472 = phi_5467_;
                                let _e3474 = local.member_3;
                                let _e3475 = (_e3472 + _e3474);
                                let _e3478 = local.member_2[0u];
                                if (_e3478[0] < 0f) {
                                    phi_5484_ = -(_e3478[0]);
                                } else {
                                    phi_5484_ = _e3478[0];
                                }
                                let _e3485 = phi_5484_;
                                if (_e3478[1] < 0f) {
                                    phi_5491_ = -(_e3478[1]);
                                } else {
                                    phi_5491_ = _e3478[1];
                                }
                                let _e3489 = phi_5491_;
                                if (_e3485 > _e3489) {
                                    phi_5496_ = _e3485;
                                } else {
                                    phi_5496_ = _e3489;
                                }
                                let _e3492 = phi_5496_;
                                if (_e3478[2] < 0f) {
                                    phi_5503_ = -(_e3478[2]);
                                } else {
                                    phi_5503_ = _e3478[2];
                                }
                                let _e3496 = phi_5503_;
                                if (_e3492 > _e3496) {
                                    phi_5508_ = _e3492;
                                } else {
                                    phi_5508_ = _e3496;
                                }
                                let _e3499 = phi_5508_;
                                let _e3502 = local.member_2[1u];
                                if (_e3502[0] < 0f) {
                                    phi_5522_ = -(_e3502[0]);
                                } else {
                                    phi_5522_ = _e3502[0];
                                }
                                let _e3509 = phi_5522_;
                                if (_e3502[1] < 0f) {
                                    phi_5529_ = -(_e3502[1]);
                                } else {
                                    phi_5529_ = _e3502[1];
                                }
                                let _e3513 = phi_5529_;
                                if (_e3509 > _e3513) {
                                    phi_5534_ = _e3509;
                                } else {
                                    phi_5534_ = _e3513;
                                }
                                let _e3516 = phi_5534_;
                                if (_e3502[2] < 0f) {
                                    phi_5541_ = -(_e3502[2]);
                                } else {
                                    phi_5541_ = _e3502[2];
                                }
                                let _e3520 = phi_5541_;
                                if (_e3516 > _e3520) {
                                    phi_5546_ = _e3516;
                                } else {
                                    phi_5546_ = _e3520;
                                }
                                let _e3523 = phi_5546_;
                                if (_e3499 > _e3523) {
                                    phi_5551_ = _e3499;
                                } else {
                                    phi_5551_ = _e3523;
                                }
                                let _e3526 = phi_5551_;
                                let _e3528 = local.member_3;
                                let _e3529 = (_e3526 + _e3528);
                                let _e3531 = ((_e3475 * 8f) * _e3529);
                                let _e3538 = local.member_3;
                                if (_e3227 < 0f) {
                                    phi_5582_ = -(_e3227);
                                } else {
                                    phi_5582_ = _e3227;
                                }
                                let _e3555 = phi_5582_;
                                if (_e3230 < 0f) {
                                    phi_5588_ = -(_e3230);
                                } else {
                                    phi_5588_ = _e3230;
                                }
                                let _e3559 = phi_5588_;
                                if (_e3233 < 0f) {
                                    phi_5595_ = -(_e3233);
                                } else {
                                    phi_5595_ = _e3233;
                                }
                                let _e3564 = phi_5595_;
                                let _e3565 = ((_e3555 + _e3559) + _e3564);
                                if (_e3248 < 0f) {
                                    phi_5602_ = -(_e3248);
                                } else {
                                    phi_5602_ = _e3248;
                                }
                                let _e3569 = phi_5602_;
                                if (_e3251 < 0f) {
                                    phi_5608_ = -(_e3251);
                                } else {
                                    phi_5608_ = _e3251;
                                }
                                let _e3573 = phi_5608_;
                                if (_e3254 < 0f) {
                                    phi_5615_ = -(_e3254);
                                } else {
                                    phi_5615_ = _e3254;
                                }
                                let _e3578 = phi_5615_;
                                let _e3579 = ((_e3569 + _e3573) + _e3578);
                                if (_e3565 > _e3579) {
                                    phi_5621_ = _e3565;
                                } else {
                                    phi_5621_ = _e3579;
                                }
                                let _e3582 = phi_5621_;
                                if (_e3297 < 0f) {
                                    phi_5627_ = -(_e3297);
                                } else {
                                    phi_5627_ = _e3297;
                                }
                                let _e3586 = phi_5627_;
                                if (_e3298 < 0f) {
                                    phi_5633_ = -(_e3298);
                                } else {
                                    phi_5633_ = _e3298;
                                }
                                let _e3590 = phi_5633_;
                                if (_e3299 < 0f) {
                                    phi_5640_ = -(_e3299);
                                } else {
                                    phi_5640_ = _e3299;
                                }
                                let _e3595 = phi_5640_;
                                let _e3597 = (((_e3586 + _e3590) + _e3595) * 0.5f);
                                if (_e3582 > _e3597) {
                                    phi_5647_ = _e3582;
                                } else {
                                    phi_5647_ = _e3597;
                                }
                                let _e3600 = phi_5647_;
                                let _e3605 = local.member_3;
                                let _e3618 = ((((_e3302[0] * _e3227) + (_e3302[1] * _e3230)) + (_e3302[2] * _e3233)) * 3f);
                                let _e3619 = ((((_e3359[0] * _e3248) + (_e3359[1] * _e3251)) + (_e3359[2] * _e3254)) * 3f);
                                if (_e3618 < _e3619) {
                                    phi_5671_ = _e3618;
                                } else {
                                    phi_5671_ = _e3619;
                                }
                                let _e3622 = phi_5671_;
                                if (_e3333 < _e3356) {
                                    phi_5676_ = _e3333;
                                } else {
                                    phi_5676_ = _e3356;
                                }
                                let _e3625 = phi_5676_;
                                if (_e3622 < _e3625) {
                                    phi_5681_ = _e3622;
                                } else {
                                    phi_5681_ = _e3625;
                                }
                                let _e3628 = phi_5681_;
                                if (_e3618 > _e3619) {
                                    phi_5686_ = _e3618;
                                } else {
                                    phi_5686_ = _e3619;
                                }
                                let _e3631 = phi_5686_;
                                if (_e3333 > _e3356) {
                                    phi_5691_ = _e3333;
                                } else {
                                    phi_5691_ = _e3356;
                                }
                                let _e3634 = phi_5691_;
                                if (_e3631 > _e3634) {
                                    phi_5696_ = _e3631;
                                } else {
                                    phi_5696_ = _e3634;
                                }
                                let _e3637 = phi_5696_;
                                let _e3642 = -(_e3637);
                                if (_e3628 > _e3642) {
                                    phi_5706_ = _e3628;
                                } else {
                                    phi_5706_ = _e3642;
                                }
                                let _e3645 = phi_5706_;
                                let _e3647 = ((_e3645 - ((((((_e3421 * 8f) * _e3531) * (0.000000059604645f * (524f / 64f))) + ((_e3538 * 19f) * ((_e3421 * (_e3475 + _e3529)) + (_e3475 * _e3529)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3421) * ((1f + _e3475) * (1f + _e3529))))) + ((_e91.member_5 * (((_e3600 + (_e3531 * (0.000000059604645f * 8f))) + ((_e3605 * 6f) * (_e3475 + _e3529))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3475) * (1f + _e3529))))) * (3f * 1.0001f)))) > 0f);
                                if _e3647 {
                                    phi_6675_ = _e3647;
                                } else {
                                    let _e3650 = local.member_1[0u];
                                    let _e3656 = local.member_1[1u];
                                    let _e3660 = (_e3650[0] + _e3656[0]);
                                    let _e3661 = (_e3650[1] + _e3656[1]);
                                    let _e3662 = (_e3650[2] + _e3656[2]);
                                    let _e3665 = local.member_2[0u];
                                    let _e3671 = local.member_2[1u];
                                    let _e3675 = (_e3665[0] + _e3671[0]);
                                    let _e3676 = (_e3665[1] + _e3671[1]);
                                    let _e3677 = (_e3665[2] + _e3671[2]);
                                    let _e3680 = ((_e3661 * _e3677) - (_e3662 * _e3676));
                                    let _e3683 = ((_e3662 * _e3675) - (_e3660 * _e3677));
                                    let _e3686 = ((_e3660 * _e3676) - (_e3661 * _e3675));
                                    let _e3689 = local.member[0u];
                                    let _e3696 = local.member_1[0u];
                                    let _e3702 = local.member_2[0u];
                                    let _e3706 = (_e3689[0] - _e3696[0]);
                                    let _e3707 = (_e3689[1] - _e3696[1]);
                                    let _e3708 = (_e3689[2] - _e3696[2]);
                                    if (_e2989.member == 0u) {
                                        phi_5822_ = array<f32, 3>(_e3689[0], _e3689[1], _e3689[2]);
                                    } else {
                                        phi_5822_ = array<f32, 3>((_e3706 - _e3702[0]), (_e3707 - _e3702[1]), (_e3708 - _e3702[2]));
                                    }
                                    let _e3715 = phi_5822_;
                                    let _e3716 = (_e3689[0] - _e3702[0]);
                                    let _e3717 = (_e3689[1] - _e3702[1]);
                                    let _e3718 = (_e3689[2] - _e3702[2]);
                                    let _e3721 = local.member[1u];
                                    let _e3728 = local.member_1[1u];
                                    let _e3734 = local.member_2[1u];
                                    let _e3738 = (_e3721[0] - _e3728[0]);
                                    let _e3739 = (_e3721[1] - _e3728[1]);
                                    let _e3740 = (_e3721[2] - _e3728[2]);
                                    if (_e2989.member == 0u) {
                                        phi_5887_ = array<f32, 3>(_e3721[0], _e3721[1], _e3721[2]);
                                    } else {
                                        phi_5887_ = array<f32, 3>((_e3738 - _e3734[0]), (_e3739 - _e3734[1]), (_e3740 - _e3734[2]));
                                    }
                                    let _e3747 = phi_5887_;
                                    let _e3748 = (_e3721[0] - _e3734[0]);
                                    let _e3749 = (_e3721[1] - _e3734[1]);
                                    let _e3750 = (_e3721[2] - _e3734[2]);
                                    let _e3753 = local.member[0u];
                                    if (_e3753[0] < 0f) {
                                        phi_5909_ = -(_e3753[0]);
                                    } else {
                                        phi_5909_ = _e3753[0];
                                    }
                                    let _e3760 = phi_5909_;
                                    if (_e3753[1] < 0f) {
                                        phi_5916_ = -(_e3753[1]);
                                    } else {
                                        phi_5916_ = _e3753[1];
                                    }
                                    let _e3764 = phi_5916_;
                                    if (_e3760 > _e3764) {
                                        phi_5921_ = _e3760;
                                    } else {
                                        phi_5921_ = _e3764;
                                    }
                                    let _e3767 = phi_5921_;
                                    if (_e3753[2] < 0f) {
                                        phi_5928_ = -(_e3753[2]);
                                    } else {
                                        phi_5928_ = _e3753[2];
                                    }
                                    let _e3771 = phi_5928_;
                                    if (_e3767 > _e3771) {
                                        phi_5933_ = _e3767;
                                    } else {
                                        phi_5933_ = _e3771;
                                    }
                                    let _e3774 = phi_5933_;
                                    let _e3777 = local.member[1u];
                                    if (_e3777[0] < 0f) {
                                        phi_5946_ = -(_e3777[0]);
                                    } else {
                                        phi_5946_ = _e3777[0];
                                    }
                                    let _e3784 = phi_5946_;
                                    if (_e3777[1] < 0f) {
                                        phi_5953_ = -(_e3777[1]);
                                    } else {
                                        phi_5953_ = _e3777[1];
                                    }
                                    let _e3788 = phi_5953_;
                                    if (_e3784 > _e3788) {
                                        phi_5958_ = _e3784;
                                    } else {
                                        phi_5958_ = _e3788;
                                    }
                                    let _e3791 = phi_5958_;
                                    if (_e3777[2] < 0f) {
                                        phi_5965_ = -(_e3777[2]);
                                    } else {
                                        phi_5965_ = _e3777[2];
                                    }
                                    let _e3795 = phi_5965_;
                                    if (_e3791 > _e3795) {
                                        phi_5970_ = _e3791;
                                    } else {
                                        phi_5970_ = _e3795;
                                    }
                                    let _e3798 = phi_5970_;
                                    if (_e3774 > _e3798) {
                                        phi_5975_ = _e3774;
                                    } else {
                                        phi_5975_ = _e3798;
                                    }
                                    let _e3801 = phi_5975_;
                                    let _e3803 = local.member_3;
                                    let _e3807 = local.member_1[0u];
                                    if (_e3807[0] < 0f) {
                                        phi_5992_ = -(_e3807[0]);
                                    } else {
                                        phi_5992_ = _e3807[0];
                                    }
                                    let _e3814 = phi_5992_;
                                    if (_e3807[1] < 0f) {
                                        phi_5999_ = -(_e3807[1]);
                                    } else {
                                        phi_5999_ = _e3807[1];
                                    }
                                    let _e3818 = phi_5999_;
                                    if (_e3814 > _e3818) {
                                        phi_6004_ = _e3814;
                                    } else {
                                        phi_6004_ = _e3818;
                                    }
                                    let _e3821 = phi_6004_;
                                    if (_e3807[2] < 0f) {
                                        phi_6011_ = -(_e3807[2]);
                                    } else {
                                        phi_6011_ = _e3807[2];
                                    }
                                    let _e3825 = phi_6011_;
                                    if (_e3821 > _e3825) {
                                        phi_6016_ = _e3821;
                                    } else {
                                        phi_6016_ = _e3825;
                                    }
                                    let _e3828 = phi_6016_;
                                    let _e3831 = local.member_1[1u];
                                    if (_e3831[0] < 0f) {
                                        phi_6030_ = -(_e3831[0]);
                                    } else {
                                        phi_6030_ = _e3831[0];
                                    }
                                    let _e3838 = phi_6030_;
                                    if (_e3831[1] < 0f) {
                                        phi_6037_ = -(_e3831[1]);
                                    } else {
                                        phi_6037_ = _e3831[1];
                                    }
                                    let _e3842 = phi_6037_;
                                    if (_e3838 > _e3842) {
                                        phi_6042_ = _e3838;
                                    } else {
                                        phi_6042_ = _e3842;
                                    }
                                    let _e3845 = phi_6042_;
                                    if (_e3831[2] < 0f) {
                                        phi_6049_ = -(_e3831[2]);
                                    } else {
                                        phi_6049_ = _e3831[2];
                                    }
                                    let _e3849 = phi_6049_;
                                    if (_e3845 > _e3849) {
                                        phi_6054_ = _e3845;
                                    } else {
                                        phi_6054_ = _e3849;
                                    }
                                    let _e3852 = phi_6054_;
                                    if (_e3828 > _e3852) {
                                        phi_6059_ = _e3828;
                                    } else {
                                        phi_6059_ = _e3852;
                                    }
                                    let _e3855 = phi_6059_;
                                    let _e3857 = local.member_3;
                                    let _e3861 = local.member_2[0u];
                                    if (_e3861[0] < 0f) {
                                        phi_6076_ = -(_e3861[0]);
                                    } else {
                                        phi_6076_ = _e3861[0];
                                    }
                                    let _e3868 = phi_6076_;
                                    if (_e3861[1] < 0f) {
                                        phi_6083_ = -(_e3861[1]);
                                    } else {
                                        phi_6083_ = _e3861[1];
                                    }
                                    let _e3872 = phi_6083_;
                                    if (_e3868 > _e3872) {
                                        phi_6088_ = _e3868;
                                    } else {
                                        phi_6088_ = _e3872;
                                    }
                                    let _e3875 = phi_6088_;
                                    if (_e3861[2] < 0f) {
                                        phi_6095_ = -(_e3861[2]);
                                    } else {
                                        phi_6095_ = _e3861[2];
                                    }
                                    let _e3879 = phi_6095_;
                                    if (_e3875 > _e3879) {
                                        phi_6100_ = _e3875;
                                    } else {
                                        phi_6100_ = _e3879;
                                    }
                                    let _e3882 = phi_6100_;
                                    let _e3885 = local.member_2[1u];
                                    if (_e3885[0] < 0f) {
                                        phi_6114_ = -(_e3885[0]);
                                    } else {
                                        phi_6114_ = _e3885[0];
                                    }
                                    let _e3892 = phi_6114_;
                                    if (_e3885[1] < 0f) {
                                        phi_6121_ = -(_e3885[1]);
                                    } else {
                                        phi_6121_ = _e3885[1];
                                    }
                                    let _e3896 = phi_6121_;
                                    if (_e3892 > _e3896) {
                                        phi_6126_ = _e3892;
                                    } else {
                                        phi_6126_ = _e3896;
                                    }
                                    let _e3899 = phi_6126_;
                                    if (_e3885[2] < 0f) {
                                        phi_6133_ = -(_e3885[2]);
                                    } else {
                                        phi_6133_ = _e3885[2];
                                    }
                                    let _e3903 = phi_6133_;
                                    if (_e3899 > _e3903) {
                                        phi_6138_ = _e3899;
                                    } else {
                                        phi_6138_ = _e3903;
                                    }
                                    let _e3906 = phi_6138_;
                                    if (_e3882 > _e3906) {
                                        phi_6143_ = _e3882;
                                    } else {
                                        phi_6143_ = _e3906;
                                    }
                                    let _e3909 = phi_6143_;
                                    let _e3911 = local.member_3;
                                    let _e3915 = ((((_e3801 + _e3803) + (_e3855 + _e3857)) + (_e3909 + _e3911)) * 2f);
                                    let _e3918 = local.member_3;
                                    let _e3922 = (((_e91.member_5 * 1.0001f) + (_e3918 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3925 = ((_e3683 * _e3662) - (_e3686 * _e3661));
                                    let _e3928 = ((_e3686 * _e3660) - (_e3680 * _e3662));
                                    let _e3931 = ((_e3680 * _e3661) - (_e3683 * _e3660));
                                    let _e3936 = (((_e3925 * _e3689[0]) + (_e3928 * _e3689[1])) + (_e3931 * _e3689[2]));
                                    let _e3941 = (((_e3925 * _e3706) + (_e3928 * _e3707)) + (_e3931 * _e3708));
                                    let _e3946 = (((_e3925 * _e3716) + (_e3928 * _e3717)) + (_e3931 * _e3718));
                                    let _e3954 = (((_e3925 * _e3715[0]) + (_e3928 * _e3715[1])) + (_e3931 * _e3715[2]));
                                    let _e3959 = (((_e3925 * _e3721[0]) + (_e3928 * _e3721[1])) + (_e3931 * _e3721[2]));
                                    let _e3964 = (((_e3925 * _e3738) + (_e3928 * _e3739)) + (_e3931 * _e3740));
                                    let _e3969 = (((_e3925 * _e3748) + (_e3928 * _e3749)) + (_e3931 * _e3750));
                                    let _e3977 = (((_e3925 * _e3747[0]) + (_e3928 * _e3747[1])) + (_e3931 * _e3747[2]));
                                    if (_e3936 < _e3941) {
                                        phi_6222_ = _e3936;
                                    } else {
                                        phi_6222_ = _e3941;
                                    }
                                    let _e3980 = phi_6222_;
                                    if (_e3946 < _e3954) {
                                        phi_6227_ = _e3946;
                                    } else {
                                        phi_6227_ = _e3954;
                                    }
                                    let _e3983 = phi_6227_;
                                    if (_e3980 < _e3983) {
                                        phi_6232_ = _e3980;
                                    } else {
                                        phi_6232_ = _e3983;
                                    }
                                    let _e3986 = phi_6232_;
                                    if (_e3959 < _e3964) {
                                        phi_6237_ = _e3959;
                                    } else {
                                        phi_6237_ = _e3964;
                                    }
                                    let _e3989 = phi_6237_;
                                    if (_e3969 < _e3977) {
                                        phi_6242_ = _e3969;
                                    } else {
                                        phi_6242_ = _e3977;
                                    }
                                    let _e3992 = phi_6242_;
                                    if (_e3989 < _e3992) {
                                        phi_6247_ = _e3989;
                                    } else {
                                        phi_6247_ = _e3992;
                                    }
                                    let _e3995 = phi_6247_;
                                    if (_e3986 < _e3995) {
                                        phi_6252_ = _e3986;
                                    } else {
                                        phi_6252_ = _e3995;
                                    }
                                    let _e3998 = phi_6252_;
                                    if (_e3936 > _e3941) {
                                        phi_6257_ = _e3936;
                                    } else {
                                        phi_6257_ = _e3941;
                                    }
                                    let _e4001 = phi_6257_;
                                    if (_e3946 > _e3954) {
                                        phi_6262_ = _e3946;
                                    } else {
                                        phi_6262_ = _e3954;
                                    }
                                    let _e4004 = phi_6262_;
                                    if (_e4001 > _e4004) {
                                        phi_6267_ = _e4001;
                                    } else {
                                        phi_6267_ = _e4004;
                                    }
                                    let _e4007 = phi_6267_;
                                    if (_e3959 > _e3964) {
                                        phi_6272_ = _e3959;
                                    } else {
                                        phi_6272_ = _e3964;
                                    }
                                    let _e4010 = phi_6272_;
                                    if (_e3969 > _e3977) {
                                        phi_6277_ = _e3969;
                                    } else {
                                        phi_6277_ = _e3977;
                                    }
                                    let _e4013 = phi_6277_;
                                    if (_e4010 > _e4013) {
                                        phi_6282_ = _e4010;
                                    } else {
                                        phi_6282_ = _e4013;
                                    }
                                    let _e4016 = phi_6282_;
                                    if (_e4007 > _e4016) {
                                        phi_6287_ = _e4007;
                                    } else {
                                        phi_6287_ = _e4016;
                                    }
                                    let _e4019 = phi_6287_;
                                    if (_e3925 < 0f) {
                                        phi_6293_ = -(_e3925);
                                    } else {
                                        phi_6293_ = _e3925;
                                    }
                                    let _e4023 = phi_6293_;
                                    if (_e3928 < 0f) {
                                        phi_6299_ = -(_e3928);
                                    } else {
                                        phi_6299_ = _e3928;
                                    }
                                    let _e4027 = phi_6299_;
                                    if (_e3931 < 0f) {
                                        phi_6306_ = -(_e3931);
                                    } else {
                                        phi_6306_ = _e3931;
                                    }
                                    let _e4032 = phi_6306_;
                                    let _e4033 = ((_e4023 + _e4027) + _e4032);
                                    let _e4038 = -(_e4019);
                                    if (_e3998 > _e4038) {
                                        phi_6317_ = _e3998;
                                    } else {
                                        phi_6317_ = _e4038;
                                    }
                                    let _e4041 = phi_6317_;
                                    let _e4046 = (((_e4041 - ((_e4033 * _e3915) * (0.000000059604645f * (17f / 2f)))) - (_e4033 * _e3922)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e4049 = ((_e3683 * _e3677) - (_e3686 * _e3676));
                                    let _e4052 = ((_e3686 * _e3675) - (_e3680 * _e3677));
                                    let _e4055 = ((_e3680 * _e3676) - (_e3683 * _e3675));
                                    let _e4060 = (((_e4049 * _e3689[0]) + (_e4052 * _e3689[1])) + (_e4055 * _e3689[2]));
                                    let _e4065 = (((_e4049 * _e3706) + (_e4052 * _e3707)) + (_e4055 * _e3708));
                                    let _e4070 = (((_e4049 * _e3716) + (_e4052 * _e3717)) + (_e4055 * _e3718));
                                    let _e4078 = (((_e4049 * _e3715[0]) + (_e4052 * _e3715[1])) + (_e4055 * _e3715[2]));
                                    let _e4083 = (((_e4049 * _e3721[0]) + (_e4052 * _e3721[1])) + (_e4055 * _e3721[2]));
                                    let _e4088 = (((_e4049 * _e3738) + (_e4052 * _e3739)) + (_e4055 * _e3740));
                                    let _e4093 = (((_e4049 * _e3748) + (_e4052 * _e3749)) + (_e4055 * _e3750));
                                    let _e4101 = (((_e4049 * _e3747[0]) + (_e4052 * _e3747[1])) + (_e4055 * _e3747[2]));
                                    if (_e4060 < _e4065) {
                                        phi_6388_ = _e4060;
                                    } else {
                                        phi_6388_ = _e4065;
                                    }
                                    let _e4104 = phi_6388_;
                                    if (_e4070 < _e4078) {
                                        phi_6393_ = _e4070;
                                    } else {
                                        phi_6393_ = _e4078;
                                    }
                                    let _e4107 = phi_6393_;
                                    if (_e4104 < _e4107) {
                                        phi_6398_ = _e4104;
                                    } else {
                                        phi_6398_ = _e4107;
                                    }
                                    let _e4110 = phi_6398_;
                                    if (_e4083 < _e4088) {
                                        phi_6403_ = _e4083;
                                    } else {
                                        phi_6403_ = _e4088;
                                    }
                                    let _e4113 = phi_6403_;
                                    if (_e4093 < _e4101) {
                                        phi_6408_ = _e4093;
                                    } else {
                                        phi_6408_ = _e4101;
                                    }
                                    let _e4116 = phi_6408_;
                                    if (_e4113 < _e4116) {
                                        phi_6413_ = _e4113;
                                    } else {
                                        phi_6413_ = _e4116;
                                    }
                                    let _e4119 = phi_6413_;
                                    if (_e4110 < _e4119) {
                                        phi_6418_ = _e4110;
                                    } else {
                                        phi_6418_ = _e4119;
                                    }
                                    let _e4122 = phi_6418_;
                                    if (_e4060 > _e4065) {
                                        phi_6423_ = _e4060;
                                    } else {
                                        phi_6423_ = _e4065;
                                    }
                                    let _e4125 = phi_6423_;
                                    if (_e4070 > _e4078) {
                                        phi_6428_ = _e4070;
                                    } else {
                                        phi_6428_ = _e4078;
                                    }
                                    let _e4128 = phi_6428_;
                                    if (_e4125 > _e4128) {
                                        phi_6433_ = _e4125;
                                    } else {
                                        phi_6433_ = _e4128;
                                    }
                                    let _e4131 = phi_6433_;
                                    if (_e4083 > _e4088) {
                                        phi_6438_ = _e4083;
                                    } else {
                                        phi_6438_ = _e4088;
                                    }
                                    let _e4134 = phi_6438_;
                                    if (_e4093 > _e4101) {
                                        phi_6443_ = _e4093;
                                    } else {
                                        phi_6443_ = _e4101;
                                    }
                                    let _e4137 = phi_6443_;
                                    if (_e4134 > _e4137) {
                                        phi_6448_ = _e4134;
                                    } else {
                                        phi_6448_ = _e4137;
                                    }
                                    let _e4140 = phi_6448_;
                                    if (_e4131 > _e4140) {
                                        phi_6453_ = _e4131;
                                    } else {
                                        phi_6453_ = _e4140;
                                    }
                                    let _e4143 = phi_6453_;
                                    if (_e4049 < 0f) {
                                        phi_6459_ = -(_e4049);
                                    } else {
                                        phi_6459_ = _e4049;
                                    }
                                    let _e4147 = phi_6459_;
                                    if (_e4052 < 0f) {
                                        phi_6465_ = -(_e4052);
                                    } else {
                                        phi_6465_ = _e4052;
                                    }
                                    let _e4151 = phi_6465_;
                                    if (_e4055 < 0f) {
                                        phi_6472_ = -(_e4055);
                                    } else {
                                        phi_6472_ = _e4055;
                                    }
                                    let _e4156 = phi_6472_;
                                    let _e4157 = ((_e4147 + _e4151) + _e4156);
                                    let _e4162 = -(_e4143);
                                    if (_e4122 > _e4162) {
                                        phi_6483_ = _e4122;
                                    } else {
                                        phi_6483_ = _e4162;
                                    }
                                    let _e4165 = phi_6483_;
                                    let _e4170 = (((_e4165 - ((_e4157 * _e3915) * (0.000000059604645f * (17f / 2f)))) - (_e4157 * _e3922)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4046 > _e4170) {
                                        phi_6493_ = _e4046;
                                    } else {
                                        phi_6493_ = _e4170;
                                    }
                                    let _e4173 = phi_6493_;
                                    if (_e2989.member == 0u) {
                                        let _e4175 = (_e3675 - _e3660);
                                        let _e4176 = (_e3676 - _e3661);
                                        let _e4177 = (_e3677 - _e3662);
                                        let _e4180 = ((_e3683 * _e4177) - (_e3686 * _e4176));
                                        let _e4183 = ((_e3686 * _e4175) - (_e3680 * _e4177));
                                        let _e4186 = ((_e3680 * _e4176) - (_e3683 * _e4175));
                                        let _e4191 = (((_e4180 * _e3689[0]) + (_e4183 * _e3689[1])) + (_e4186 * _e3689[2]));
                                        let _e4196 = (((_e4180 * _e3706) + (_e4183 * _e3707)) + (_e4186 * _e3708));
                                        let _e4201 = (((_e4180 * _e3716) + (_e4183 * _e3717)) + (_e4186 * _e3718));
                                        let _e4209 = (((_e4180 * _e3715[0]) + (_e4183 * _e3715[1])) + (_e4186 * _e3715[2]));
                                        let _e4214 = (((_e4180 * _e3721[0]) + (_e4183 * _e3721[1])) + (_e4186 * _e3721[2]));
                                        let _e4219 = (((_e4180 * _e3738) + (_e4183 * _e3739)) + (_e4186 * _e3740));
                                        let _e4224 = (((_e4180 * _e3748) + (_e4183 * _e3749)) + (_e4186 * _e3750));
                                        let _e4232 = (((_e4180 * _e3747[0]) + (_e4183 * _e3747[1])) + (_e4186 * _e3747[2]));
                                        if (_e4191 < _e4196) {
                                            phi_6566_ = _e4191;
                                        } else {
                                            phi_6566_ = _e4196;
                                        }
                                        let _e4235 = phi_6566_;
                                        if (_e4201 < _e4209) {
                                            phi_6571_ = _e4201;
                                        } else {
                                            phi_6571_ = _e4209;
                                        }
                                        let _e4238 = phi_6571_;
                                        if (_e4235 < _e4238) {
                                            phi_6576_ = _e4235;
                                        } else {
                                            phi_6576_ = _e4238;
                                        }
                                        let _e4241 = phi_6576_;
                                        if (_e4214 < _e4219) {
                                            phi_6581_ = _e4214;
                                        } else {
                                            phi_6581_ = _e4219;
                                        }
                                        let _e4244 = phi_6581_;
                                        if (_e4224 < _e4232) {
                                            phi_6586_ = _e4224;
                                        } else {
                                            phi_6586_ = _e4232;
                                        }
                                        let _e4247 = phi_6586_;
                                        if (_e4244 < _e4247) {
                                            phi_6591_ = _e4244;
                                        } else {
                                            phi_6591_ = _e4247;
                                        }
                                        let _e4250 = phi_6591_;
                                        if (_e4241 < _e4250) {
                                            phi_6596_ = _e4241;
                                        } else {
                                            phi_6596_ = _e4250;
                                        }
                                        let _e4253 = phi_6596_;
                                        if (_e4191 > _e4196) {
                                            phi_6601_ = _e4191;
                                        } else {
                                            phi_6601_ = _e4196;
                                        }
                                        let _e4256 = phi_6601_;
                                        if (_e4201 > _e4209) {
                                            phi_6606_ = _e4201;
                                        } else {
                                            phi_6606_ = _e4209;
                                        }
                                        let _e4259 = phi_6606_;
                                        if (_e4256 > _e4259) {
                                            phi_6611_ = _e4256;
                                        } else {
                                            phi_6611_ = _e4259;
                                        }
                                        let _e4262 = phi_6611_;
                                        if (_e4214 > _e4219) {
                                            phi_6616_ = _e4214;
                                        } else {
                                            phi_6616_ = _e4219;
                                        }
                                        let _e4265 = phi_6616_;
                                        if (_e4224 > _e4232) {
                                            phi_6621_ = _e4224;
                                        } else {
                                            phi_6621_ = _e4232;
                                        }
                                        let _e4268 = phi_6621_;
                                        if (_e4265 > _e4268) {
                                            phi_6626_ = _e4265;
                                        } else {
                                            phi_6626_ = _e4268;
                                        }
                                        let _e4271 = phi_6626_;
                                        if (_e4262 > _e4271) {
                                            phi_6631_ = _e4262;
                                        } else {
                                            phi_6631_ = _e4271;
                                        }
                                        let _e4274 = phi_6631_;
                                        if (_e4180 < 0f) {
                                            phi_6637_ = -(_e4180);
                                        } else {
                                            phi_6637_ = _e4180;
                                        }
                                        let _e4278 = phi_6637_;
                                        if (_e4183 < 0f) {
                                            phi_6643_ = -(_e4183);
                                        } else {
                                            phi_6643_ = _e4183;
                                        }
                                        let _e4282 = phi_6643_;
                                        if (_e4186 < 0f) {
                                            phi_6650_ = -(_e4186);
                                        } else {
                                            phi_6650_ = _e4186;
                                        }
                                        let _e4287 = phi_6650_;
                                        let _e4288 = ((_e4278 + _e4282) + _e4287);
                                        let _e4293 = -(_e4274);
                                        if (_e4253 > _e4293) {
                                            phi_6661_ = _e4253;
                                        } else {
                                            phi_6661_ = _e4293;
                                        }
                                        let _e4296 = phi_6661_;
                                        let _e4301 = (((_e4296 - ((_e4288 * _e3915) * (0.000000059604645f * (17f / 2f)))) - (_e4288 * _e3922)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4173 > _e4301) {
                                            phi_6671_ = _e4173;
                                        } else {
                                            phi_6671_ = _e4301;
                                        }
                                        let _e4304 = phi_6671_;
                                        phi_6672_ = _e4304;
                                    } else {
                                        phi_6672_ = _e4173;
                                    }
                                    let _e4306 = phi_6672_;
                                    phi_6675_ = (_e3647 || (_e4306 > 0f));
                                }
                                let _e4310 = phi_6675_;
                                if _e4310 {
                                    let _e4313 = local_1.member_1[0u];
                                    let _e4319 = local_1.member_2[0u];
                                    let _e4325 = ((_e4313[1] * _e4319[2]) - (_e4313[2] * _e4319[1]));
                                    let _e4328 = ((_e4313[2] * _e4319[0]) - (_e4313[0] * _e4319[2]));
                                    let _e4331 = ((_e4313[0] * _e4319[1]) - (_e4313[1] * _e4319[0]));
                                    let _e4334 = local_1.member_1[1u];
                                    let _e4340 = local_1.member_2[1u];
                                    let _e4346 = ((_e4334[1] * _e4340[2]) - (_e4334[2] * _e4340[1]));
                                    let _e4349 = ((_e4334[2] * _e4340[0]) - (_e4334[0] * _e4340[2]));
                                    let _e4352 = ((_e4334[0] * _e4340[1]) - (_e4334[1] * _e4340[0]));
                                    let _e4355 = local_1.member_1[0u];
                                    let _e4361 = local_1.member_2[1u];
                                    let _e4376 = local_1.member_1[1u];
                                    let _e4382 = local_1.member_2[0u];
                                    let _e4395 = (((_e4355[1] * _e4361[2]) - (_e4355[2] * _e4361[1])) + ((_e4376[1] * _e4382[2]) - (_e4376[2] * _e4382[1])));
                                    let _e4396 = (((_e4355[2] * _e4361[0]) - (_e4355[0] * _e4361[2])) + ((_e4376[2] * _e4382[0]) - (_e4376[0] * _e4382[2])));
                                    let _e4397 = (((_e4355[0] * _e4361[1]) - (_e4355[1] * _e4361[0])) + ((_e4376[0] * _e4382[1]) - (_e4376[1] * _e4382[0])));
                                    let _e4400 = local_1.member[0u];
                                    let _e4411 = local_1.member[1u];
                                    let _e4422 = local_1.member[0u];
                                    let _e4431 = ((((_e4411[0] * _e4325) + (_e4411[1] * _e4328)) + (_e4411[2] * _e4331)) + (((_e4422[0] * _e4395) + (_e4422[1] * _e4396)) + (_e4422[2] * _e4397)));
                                    let _e4434 = local_1.member[0u];
                                    let _e4445 = local_1.member[1u];
                                    let _e4454 = ((((_e4434[0] * _e4346) + (_e4434[1] * _e4349)) + (_e4434[2] * _e4352)) + (((_e4445[0] * _e4395) + (_e4445[1] * _e4396)) + (_e4445[2] * _e4397)));
                                    let _e4457 = local_1.member[1u];
                                    let _e4468 = local_1.member[0u];
                                    if (_e4468[0] < 0f) {
                                        phi_6920_ = -(_e4468[0]);
                                    } else {
                                        phi_6920_ = _e4468[0];
                                    }
                                    let _e4475 = phi_6920_;
                                    if (_e4468[1] < 0f) {
                                        phi_6927_ = -(_e4468[1]);
                                    } else {
                                        phi_6927_ = _e4468[1];
                                    }
                                    let _e4479 = phi_6927_;
                                    if (_e4475 > _e4479) {
                                        phi_6932_ = _e4475;
                                    } else {
                                        phi_6932_ = _e4479;
                                    }
                                    let _e4482 = phi_6932_;
                                    if (_e4468[2] < 0f) {
                                        phi_6939_ = -(_e4468[2]);
                                    } else {
                                        phi_6939_ = _e4468[2];
                                    }
                                    let _e4486 = phi_6939_;
                                    if (_e4482 > _e4486) {
                                        phi_6944_ = _e4482;
                                    } else {
                                        phi_6944_ = _e4486;
                                    }
                                    let _e4489 = phi_6944_;
                                    let _e4492 = local_1.member[1u];
                                    if (_e4492[0] < 0f) {
                                        phi_6957_ = -(_e4492[0]);
                                    } else {
                                        phi_6957_ = _e4492[0];
                                    }
                                    let _e4499 = phi_6957_;
                                    if (_e4492[1] < 0f) {
                                        phi_6964_ = -(_e4492[1]);
                                    } else {
                                        phi_6964_ = _e4492[1];
                                    }
                                    let _e4503 = phi_6964_;
                                    if (_e4499 > _e4503) {
                                        phi_6969_ = _e4499;
                                    } else {
                                        phi_6969_ = _e4503;
                                    }
                                    let _e4506 = phi_6969_;
                                    if (_e4492[2] < 0f) {
                                        phi_6976_ = -(_e4492[2]);
                                    } else {
                                        phi_6976_ = _e4492[2];
                                    }
                                    let _e4510 = phi_6976_;
                                    if (_e4506 > _e4510) {
                                        phi_6981_ = _e4506;
                                    } else {
                                        phi_6981_ = _e4510;
                                    }
                                    let _e4513 = phi_6981_;
                                    if (_e4489 > _e4513) {
                                        phi_6986_ = _e4489;
                                    } else {
                                        phi_6986_ = _e4513;
                                    }
                                    let _e4516 = phi_6986_;
                                    let _e4518 = local_1.member_3;
                                    let _e4519 = (_e4516 + _e4518);
                                    let _e4522 = local_1.member_1[0u];
                                    if (_e4522[0] < 0f) {
                                        phi_7003_ = -(_e4522[0]);
                                    } else {
                                        phi_7003_ = _e4522[0];
                                    }
                                    let _e4529 = phi_7003_;
                                    if (_e4522[1] < 0f) {
                                        phi_7010_ = -(_e4522[1]);
                                    } else {
                                        phi_7010_ = _e4522[1];
                                    }
                                    let _e4533 = phi_7010_;
                                    if (_e4529 > _e4533) {
                                        phi_7015_ = _e4529;
                                    } else {
                                        phi_7015_ = _e4533;
                                    }
                                    let _e4536 = phi_7015_;
                                    if (_e4522[2] < 0f) {
                                        phi_7022_ = -(_e4522[2]);
                                    } else {
                                        phi_7022_ = _e4522[2];
                                    }
                                    let _e4540 = phi_7022_;
                                    if (_e4536 > _e4540) {
                                        phi_7027_ = _e4536;
                                    } else {
                                        phi_7027_ = _e4540;
                                    }
                                    let _e4543 = phi_7027_;
                                    let _e4546 = local_1.member_1[1u];
                                    if (_e4546[0] < 0f) {
                                        phi_7041_ = -(_e4546[0]);
                                    } else {
                                        phi_7041_ = _e4546[0];
                                    }
                                    let _e4553 = phi_7041_;
                                    if (_e4546[1] < 0f) {
                                        phi_7048_ = -(_e4546[1]);
                                    } else {
                                        phi_7048_ = _e4546[1];
                                    }
                                    let _e4557 = phi_7048_;
                                    if (_e4553 > _e4557) {
                                        phi_7053_ = _e4553;
                                    } else {
                                        phi_7053_ = _e4557;
                                    }
                                    let _e4560 = phi_7053_;
                                    if (_e4546[2] < 0f) {
                                        phi_7060_ = -(_e4546[2]);
                                    } else {
                                        phi_7060_ = _e4546[2];
                                    }
                                    let _e4564 = phi_7060_;
                                    if (_e4560 > _e4564) {
                                        phi_7065_ = _e4560;
                                    } else {
                                        phi_7065_ = _e4564;
                                    }
                                    let _e4567 = phi_7065_;
                                    if (_e4543 > _e4567) {
                                        phi_7070_ = _e4543;
                                    } else {
                                        phi_7070_ = _e4567;
                                    }
                                    let _e4570 = phi_7070_;
                                    let _e4572 = local_1.member_3;
                                    let _e4573 = (_e4570 + _e4572);
                                    let _e4576 = local_1.member_2[0u];
                                    if (_e4576[0] < 0f) {
                                        phi_7087_ = -(_e4576[0]);
                                    } else {
                                        phi_7087_ = _e4576[0];
                                    }
                                    let _e4583 = phi_7087_;
                                    if (_e4576[1] < 0f) {
                                        phi_7094_ = -(_e4576[1]);
                                    } else {
                                        phi_7094_ = _e4576[1];
                                    }
                                    let _e4587 = phi_7094_;
                                    if (_e4583 > _e4587) {
                                        phi_7099_ = _e4583;
                                    } else {
                                        phi_7099_ = _e4587;
                                    }
                                    let _e4590 = phi_7099_;
                                    if (_e4576[2] < 0f) {
                                        phi_7106_ = -(_e4576[2]);
                                    } else {
                                        phi_7106_ = _e4576[2];
                                    }
                                    let _e4594 = phi_7106_;
                                    if (_e4590 > _e4594) {
                                        phi_7111_ = _e4590;
                                    } else {
                                        phi_7111_ = _e4594;
                                    }
                                    let _e4597 = phi_7111_;
                                    let _e4600 = local_1.member_2[1u];
                                    if (_e4600[0] < 0f) {
                                        phi_7125_ = -(_e4600[0]);
                                    } else {
                                        phi_7125_ = _e4600[0];
                                    }
                                    let _e4607 = phi_7125_;
                                    if (_e4600[1] < 0f) {
                                        phi_7132_ = -(_e4600[1]);
                                    } else {
                                        phi_7132_ = _e4600[1];
                                    }
                                    let _e4611 = phi_7132_;
                                    if (_e4607 > _e4611) {
                                        phi_7137_ = _e4607;
                                    } else {
                                        phi_7137_ = _e4611;
                                    }
                                    let _e4614 = phi_7137_;
                                    if (_e4600[2] < 0f) {
                                        phi_7144_ = -(_e4600[2]);
                                    } else {
                                        phi_7144_ = _e4600[2];
                                    }
                                    let _e4618 = phi_7144_;
                                    if (_e4614 > _e4618) {
                                        phi_7149_ = _e4614;
                                    } else {
                                        phi_7149_ = _e4618;
                                    }
                                    let _e4621 = phi_7149_;
                                    if (_e4597 > _e4621) {
                                        phi_7154_ = _e4597;
                                    } else {
                                        phi_7154_ = _e4621;
                                    }
                                    let _e4624 = phi_7154_;
                                    let _e4626 = local_1.member_3;
                                    let _e4627 = (_e4624 + _e4626);
                                    let _e4629 = ((_e4573 * 8f) * _e4627);
                                    let _e4636 = local_1.member_3;
                                    if (_e4325 < 0f) {
                                        phi_7185_ = -(_e4325);
                                    } else {
                                        phi_7185_ = _e4325;
                                    }
                                    let _e4653 = phi_7185_;
                                    if (_e4328 < 0f) {
                                        phi_7191_ = -(_e4328);
                                    } else {
                                        phi_7191_ = _e4328;
                                    }
                                    let _e4657 = phi_7191_;
                                    if (_e4331 < 0f) {
                                        phi_7198_ = -(_e4331);
                                    } else {
                                        phi_7198_ = _e4331;
                                    }
                                    let _e4662 = phi_7198_;
                                    let _e4663 = ((_e4653 + _e4657) + _e4662);
                                    if (_e4346 < 0f) {
                                        phi_7205_ = -(_e4346);
                                    } else {
                                        phi_7205_ = _e4346;
                                    }
                                    let _e4667 = phi_7205_;
                                    if (_e4349 < 0f) {
                                        phi_7211_ = -(_e4349);
                                    } else {
                                        phi_7211_ = _e4349;
                                    }
                                    let _e4671 = phi_7211_;
                                    if (_e4352 < 0f) {
                                        phi_7218_ = -(_e4352);
                                    } else {
                                        phi_7218_ = _e4352;
                                    }
                                    let _e4676 = phi_7218_;
                                    let _e4677 = ((_e4667 + _e4671) + _e4676);
                                    if (_e4663 > _e4677) {
                                        phi_7224_ = _e4663;
                                    } else {
                                        phi_7224_ = _e4677;
                                    }
                                    let _e4680 = phi_7224_;
                                    if (_e4395 < 0f) {
                                        phi_7230_ = -(_e4395);
                                    } else {
                                        phi_7230_ = _e4395;
                                    }
                                    let _e4684 = phi_7230_;
                                    if (_e4396 < 0f) {
                                        phi_7236_ = -(_e4396);
                                    } else {
                                        phi_7236_ = _e4396;
                                    }
                                    let _e4688 = phi_7236_;
                                    if (_e4397 < 0f) {
                                        phi_7243_ = -(_e4397);
                                    } else {
                                        phi_7243_ = _e4397;
                                    }
                                    let _e4693 = phi_7243_;
                                    let _e4695 = (((_e4684 + _e4688) + _e4693) * 0.5f);
                                    if (_e4680 > _e4695) {
                                        phi_7250_ = _e4680;
                                    } else {
                                        phi_7250_ = _e4695;
                                    }
                                    let _e4698 = phi_7250_;
                                    let _e4703 = local_1.member_3;
                                    let _e4716 = ((((_e4400[0] * _e4325) + (_e4400[1] * _e4328)) + (_e4400[2] * _e4331)) * 3f);
                                    let _e4717 = ((((_e4457[0] * _e4346) + (_e4457[1] * _e4349)) + (_e4457[2] * _e4352)) * 3f);
                                    if (_e4716 < _e4717) {
                                        phi_7274_ = _e4716;
                                    } else {
                                        phi_7274_ = _e4717;
                                    }
                                    let _e4720 = phi_7274_;
                                    if (_e4431 < _e4454) {
                                        phi_7279_ = _e4431;
                                    } else {
                                        phi_7279_ = _e4454;
                                    }
                                    let _e4723 = phi_7279_;
                                    if (_e4720 < _e4723) {
                                        phi_7284_ = _e4720;
                                    } else {
                                        phi_7284_ = _e4723;
                                    }
                                    let _e4726 = phi_7284_;
                                    if (_e4716 > _e4717) {
                                        phi_7289_ = _e4716;
                                    } else {
                                        phi_7289_ = _e4717;
                                    }
                                    let _e4729 = phi_7289_;
                                    if (_e4431 > _e4454) {
                                        phi_7294_ = _e4431;
                                    } else {
                                        phi_7294_ = _e4454;
                                    }
                                    let _e4732 = phi_7294_;
                                    if (_e4729 > _e4732) {
                                        phi_7299_ = _e4729;
                                    } else {
                                        phi_7299_ = _e4732;
                                    }
                                    let _e4735 = phi_7299_;
                                    let _e4740 = -(_e4735);
                                    if (_e4726 > _e4740) {
                                        phi_7309_ = _e4726;
                                    } else {
                                        phi_7309_ = _e4740;
                                    }
                                    let _e4743 = phi_7309_;
                                    let _e4745 = ((_e4743 - ((((((_e4519 * 8f) * _e4629) * (0.000000059604645f * (524f / 64f))) + ((_e4636 * 19f) * ((_e4519 * (_e4573 + _e4627)) + (_e4573 * _e4627)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4519) * ((1f + _e4573) * (1f + _e4627))))) + ((_e91.member_5 * (((_e4698 + (_e4629 * (0.000000059604645f * 8f))) + ((_e4703 * 6f) * (_e4573 + _e4627))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4573) * (1f + _e4627))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4745 {
                                        phi_8278_ = _e4745;
                                    } else {
                                        let _e4748 = local_1.member_1[0u];
                                        let _e4754 = local_1.member_1[1u];
                                        let _e4758 = (_e4748[0] + _e4754[0]);
                                        let _e4759 = (_e4748[1] + _e4754[1]);
                                        let _e4760 = (_e4748[2] + _e4754[2]);
                                        let _e4763 = local_1.member_2[0u];
                                        let _e4769 = local_1.member_2[1u];
                                        let _e4773 = (_e4763[0] + _e4769[0]);
                                        let _e4774 = (_e4763[1] + _e4769[1]);
                                        let _e4775 = (_e4763[2] + _e4769[2]);
                                        let _e4778 = ((_e4759 * _e4775) - (_e4760 * _e4774));
                                        let _e4781 = ((_e4760 * _e4773) - (_e4758 * _e4775));
                                        let _e4784 = ((_e4758 * _e4774) - (_e4759 * _e4773));
                                        let _e4787 = local_1.member[0u];
                                        let _e4794 = local_1.member_1[0u];
                                        let _e4800 = local_1.member_2[0u];
                                        let _e4804 = (_e4787[0] - _e4794[0]);
                                        let _e4805 = (_e4787[1] - _e4794[1]);
                                        let _e4806 = (_e4787[2] - _e4794[2]);
                                        if (_e2989.member == 0u) {
                                            phi_7425_ = array<f32, 3>(_e4787[0], _e4787[1], _e4787[2]);
                                        } else {
                                            phi_7425_ = array<f32, 3>((_e4804 - _e4800[0]), (_e4805 - _e4800[1]), (_e4806 - _e4800[2]));
                                        }
                                        let _e4813 = phi_7425_;
                                        let _e4814 = (_e4787[0] - _e4800[0]);
                                        let _e4815 = (_e4787[1] - _e4800[1]);
                                        let _e4816 = (_e4787[2] - _e4800[2]);
                                        let _e4819 = local_1.member[1u];
                                        let _e4826 = local_1.member_1[1u];
                                        let _e4832 = local_1.member_2[1u];
                                        let _e4836 = (_e4819[0] - _e4826[0]);
                                        let _e4837 = (_e4819[1] - _e4826[1]);
                                        let _e4838 = (_e4819[2] - _e4826[2]);
                                        if (_e2989.member == 0u) {
                                            phi_7490_ = array<f32, 3>(_e4819[0], _e4819[1], _e4819[2]);
                                        } else {
                                            phi_7490_ = array<f32, 3>((_e4836 - _e4832[0]), (_e4837 - _e4832[1]), (_e4838 - _e4832[2]));
                                        }
                                        let _e4845 = phi_7490_;
                                        let _e4846 = (_e4819[0] - _e4832[0]);
                                        let _e4847 = (_e4819[1] - _e4832[1]);
                                        let _e4848 = (_e4819[2] - _e4832[2]);
                                        let _e4851 = local_1.member[0u];
                                        if (_e4851[0] < 0f) {
                                            phi_7512_ = -(_e4851[0]);
                                        } else {
                                            phi_7512_ = _e4851[0];
                                        }
                                        let _e4858 = phi_7512_;
                                        if (_e4851[1] < 0f) {
                                            phi_7519_ = -(_e4851[1]);
                                        } else {
                                            phi_7519_ = _e4851[1];
                                        }
                                        let _e4862 = phi_7519_;
                                        if (_e4858 > _e4862) {
                                            phi_7524_ = _e4858;
                                        } else {
                                            phi_7524_ = _e4862;
                                        }
                                        let _e4865 = phi_7524_;
                                        if (_e4851[2] < 0f) {
                                            phi_7531_ = -(_e4851[2]);
                                        } else {
                                            phi_7531_ = _e4851[2];
                                        }
                                        let _e4869 = phi_7531_;
                                        if (_e4865 > _e4869) {
                                            phi_7536_ = _e4865;
                                        } else {
                                            phi_7536_ = _e4869;
                                        }
                                        let _e4872 = phi_7536_;
                                        let _e4875 = local_1.member[1u];
                                        if (_e4875[0] < 0f) {
                                            phi_7549_ = -(_e4875[0]);
                                        } else {
                                            phi_7549_ = _e4875[0];
                                        }
                                        let _e4882 = phi_7549_;
                                        if (_e4875[1] < 0f) {
                                            phi_7556_ = -(_e4875[1]);
                                        } else {
                                            phi_7556_ = _e4875[1];
                                        }
                                        let _e4886 = phi_7556_;
                                        if (_e4882 > _e4886) {
                                            phi_7561_ = _e4882;
                                        } else {
                                            phi_7561_ = _e4886;
                                        }
                                        let _e4889 = phi_7561_;
                                        if (_e4875[2] < 0f) {
                                            phi_7568_ = -(_e4875[2]);
                                        } else {
                                            phi_7568_ = _e4875[2];
                                        }
                                        let _e4893 = phi_7568_;
                                        if (_e4889 > _e4893) {
                                            phi_7573_ = _e4889;
                                        } else {
                                            phi_7573_ = _e4893;
                                        }
                                        let _e4896 = phi_7573_;
                                        if (_e4872 > _e4896) {
                                            phi_7578_ = _e4872;
                                        } else {
                                            phi_7578_ = _e4896;
                                        }
                                        let _e4899 = phi_7578_;
                                        let _e4901 = local_1.member_3;
                                        let _e4905 = local_1.member_1[0u];
                                        if (_e4905[0] < 0f) {
                                            phi_7595_ = -(_e4905[0]);
                                        } else {
                                            phi_7595_ = _e4905[0];
                                        }
                                        let _e4912 = phi_7595_;
                                        if (_e4905[1] < 0f) {
                                            phi_7602_ = -(_e4905[1]);
                                        } else {
                                            phi_7602_ = _e4905[1];
                                        }
                                        let _e4916 = phi_7602_;
                                        if (_e4912 > _e4916) {
                                            phi_7607_ = _e4912;
                                        } else {
                                            phi_7607_ = _e4916;
                                        }
                                        let _e4919 = phi_7607_;
                                        if (_e4905[2] < 0f) {
                                            phi_7614_ = -(_e4905[2]);
                                        } else {
                                            phi_7614_ = _e4905[2];
                                        }
                                        let _e4923 = phi_7614_;
                                        if (_e4919 > _e4923) {
                                            phi_7619_ = _e4919;
                                        } else {
                                            phi_7619_ = _e4923;
                                        }
                                        let _e4926 = phi_7619_;
                                        let _e4929 = local_1.member_1[1u];
                                        if (_e4929[0] < 0f) {
                                            phi_7633_ = -(_e4929[0]);
                                        } else {
                                            phi_7633_ = _e4929[0];
                                        }
                                        let _e4936 = phi_7633_;
                                        if (_e4929[1] < 0f) {
                                            phi_7640_ = -(_e4929[1]);
                                        } else {
                                            phi_7640_ = _e4929[1];
                                        }
                                        let _e4940 = phi_7640_;
                                        if (_e4936 > _e4940) {
                                            phi_7645_ = _e4936;
                                        } else {
                                            phi_7645_ = _e4940;
                                        }
                                        let _e4943 = phi_7645_;
                                        if (_e4929[2] < 0f) {
                                            phi_7652_ = -(_e4929[2]);
                                        } else {
                                            phi_7652_ = _e4929[2];
                                        }
                                        let _e4947 = phi_7652_;
                                        if (_e4943 > _e4947) {
                                            phi_7657_ = _e4943;
                                        } else {
                                            phi_7657_ = _e4947;
                                        }
                                        let _e4950 = phi_7657_;
                                        if (_e4926 > _e4950) {
                                            phi_7662_ = _e4926;
                                        } else {
                                            phi_7662_ = _e4950;
                                        }
                                        let _e4953 = phi_7662_;
                                        let _e4955 = local_1.member_3;
                                        let _e4959 = local_1.member_2[0u];
                                        if (_e4959[0] < 0f) {
                                            phi_7679_ = -(_e4959[0]);
                                        } else {
                                            phi_7679_ = _e4959[0];
                                        }
                                        let _e4966 = phi_7679_;
                                        if (_e4959[1] < 0f) {
                                            phi_7686_ = -(_e4959[1]);
                                        } else {
                                            phi_7686_ = _e4959[1];
                                        }
                                        let _e4970 = phi_7686_;
                                        if (_e4966 > _e4970) {
                                            phi_7691_ = _e4966;
                                        } else {
                                            phi_7691_ = _e4970;
                                        }
                                        let _e4973 = phi_7691_;
                                        if (_e4959[2] < 0f) {
                                            phi_7698_ = -(_e4959[2]);
                                        } else {
                                            phi_7698_ = _e4959[2];
                                        }
                                        let _e4977 = phi_7698_;
                                        if (_e4973 > _e4977) {
                                            phi_7703_ = _e4973;
                                        } else {
                                            phi_7703_ = _e4977;
                                        }
                                        let _e4980 = phi_7703_;
                                        let _e4983 = local_1.member_2[1u];
                                        if (_e4983[0] < 0f) {
                                            phi_7717_ = -(_e4983[0]);
                                        } else {
                                            phi_7717_ = _e4983[0];
                                        }
                                        let _e4990 = phi_7717_;
                                        if (_e4983[1] < 0f) {
                                            phi_7724_ = -(_e4983[1]);
                                        } else {
                                            phi_7724_ = _e4983[1];
                                        }
                                        let _e4994 = phi_7724_;
                                        if (_e4990 > _e4994) {
                                            phi_7729_ = _e4990;
                                        } else {
                                            phi_7729_ = _e4994;
                                        }
                                        let _e4997 = phi_7729_;
                                        if (_e4983[2] < 0f) {
                                            phi_7736_ = -(_e4983[2]);
                                        } else {
                                            phi_7736_ = _e4983[2];
                                        }
                                        let _e5001 = phi_7736_;
                                        if (_e4997 > _e5001) {
                                            phi_7741_ = _e4997;
                                        } else {
                                            phi_7741_ = _e5001;
                                        }
                                        let _e5004 = phi_7741_;
                                        if (_e4980 > _e5004) {
                                            phi_7746_ = _e4980;
                                        } else {
                                            phi_7746_ = _e5004;
                                        }
                                        let _e5007 = phi_7746_;
                                        let _e5009 = local_1.member_3;
                                        let _e5013 = ((((_e4899 + _e4901) + (_e4953 + _e4955)) + (_e5007 + _e5009)) * 2f);
                                        let _e5016 = local_1.member_3;
                                        let _e5020 = (((_e91.member_5 * 1.0001f) + (_e5016 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e5023 = ((_e4781 * _e4760) - (_e4784 * _e4759));
                                        let _e5026 = ((_e4784 * _e4758) - (_e4778 * _e4760));
                                        let _e5029 = ((_e4778 * _e4759) - (_e4781 * _e4758));
                                        let _e5034 = (((_e5023 * _e4787[0]) + (_e5026 * _e4787[1])) + (_e5029 * _e4787[2]));
                                        let _e5039 = (((_e5023 * _e4804) + (_e5026 * _e4805)) + (_e5029 * _e4806));
                                        let _e5044 = (((_e5023 * _e4814) + (_e5026 * _e4815)) + (_e5029 * _e4816));
                                        let _e5052 = (((_e5023 * _e4813[0]) + (_e5026 * _e4813[1])) + (_e5029 * _e4813[2]));
                                        let _e5057 = (((_e5023 * _e4819[0]) + (_e5026 * _e4819[1])) + (_e5029 * _e4819[2]));
                                        let _e5062 = (((_e5023 * _e4836) + (_e5026 * _e4837)) + (_e5029 * _e4838));
                                        let _e5067 = (((_e5023 * _e4846) + (_e5026 * _e4847)) + (_e5029 * _e4848));
                                        let _e5075 = (((_e5023 * _e4845[0]) + (_e5026 * _e4845[1])) + (_e5029 * _e4845[2]));
                                        if (_e5034 < _e5039) {
                                            phi_7825_ = _e5034;
                                        } else {
                                            phi_7825_ = _e5039;
                                        }
                                        let _e5078 = phi_7825_;
                                        if (_e5044 < _e5052) {
                                            phi_7830_ = _e5044;
                                        } else {
                                            phi_7830_ = _e5052;
                                        }
                                        let _e5081 = phi_7830_;
                                        if (_e5078 < _e5081) {
                                            phi_7835_ = _e5078;
                                        } else {
                                            phi_7835_ = _e5081;
                                        }
                                        let _e5084 = phi_7835_;
                                        if (_e5057 < _e5062) {
                                            phi_7840_ = _e5057;
                                        } else {
                                            phi_7840_ = _e5062;
                                        }
                                        let _e5087 = phi_7840_;
                                        if (_e5067 < _e5075) {
                                            phi_7845_ = _e5067;
                                        } else {
                                            phi_7845_ = _e5075;
                                        }
                                        let _e5090 = phi_7845_;
                                        if (_e5087 < _e5090) {
                                            phi_7850_ = _e5087;
                                        } else {
                                            phi_7850_ = _e5090;
                                        }
                                        let _e5093 = phi_7850_;
                                        if (_e5084 < _e5093) {
                                            phi_7855_ = _e5084;
                                        } else {
                                            phi_7855_ = _e5093;
                                        }
                                        let _e5096 = phi_7855_;
                                        if (_e5034 > _e5039) {
                                            phi_7860_ = _e5034;
                                        } else {
                                            phi_7860_ = _e5039;
                                        }
                                        let _e5099 = phi_7860_;
                                        if (_e5044 > _e5052) {
                                            phi_7865_ = _e5044;
                                        } else {
                                            phi_7865_ = _e5052;
                                        }
                                        let _e5102 = phi_7865_;
                                        if (_e5099 > _e5102) {
                                            phi_7870_ = _e5099;
                                        } else {
                                            phi_7870_ = _e5102;
                                        }
                                        let _e5105 = phi_7870_;
                                        if (_e5057 > _e5062) {
                                            phi_7875_ = _e5057;
                                        } else {
                                            phi_7875_ = _e5062;
                                        }
                                        let _e5108 = phi_7875_;
                                        if (_e5067 > _e5075) {
                                            phi_7880_ = _e5067;
                                        } else {
                                            phi_7880_ = _e5075;
                                        }
                                        let _e5111 = phi_7880_;
                                        if (_e5108 > _e5111) {
                                            phi_7885_ = _e5108;
                                        } else {
                                            phi_7885_ = _e5111;
                                        }
                                        let _e5114 = phi_7885_;
                                        if (_e5105 > _e5114) {
                                            phi_7890_ = _e5105;
                                        } else {
                                            phi_7890_ = _e5114;
                                        }
                                        let _e5117 = phi_7890_;
                                        if (_e5023 < 0f) {
                                            phi_7896_ = -(_e5023);
                                        } else {
                                            phi_7896_ = _e5023;
                                        }
                                        let _e5121 = phi_7896_;
                                        if (_e5026 < 0f) {
                                            phi_7902_ = -(_e5026);
                                        } else {
                                            phi_7902_ = _e5026;
                                        }
                                        let _e5125 = phi_7902_;
                                        if (_e5029 < 0f) {
                                            phi_7909_ = -(_e5029);
                                        } else {
                                            phi_7909_ = _e5029;
                                        }
                                        let _e5130 = phi_7909_;
                                        let _e5131 = ((_e5121 + _e5125) + _e5130);
                                        let _e5136 = -(_e5117);
                                        if (_e5096 > _e5136) {
                                            phi_7920_ = _e5096;
                                        } else {
                                            phi_7920_ = _e5136;
                                        }
                                        let _e5139 = phi_7920_;
                                        let _e5144 = (((_e5139 - ((_e5131 * _e5013) * (0.000000059604645f * (17f / 2f)))) - (_e5131 * _e5020)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e5147 = ((_e4781 * _e4775) - (_e4784 * _e4774));
                                        let _e5150 = ((_e4784 * _e4773) - (_e4778 * _e4775));
                                        let _e5153 = ((_e4778 * _e4774) - (_e4781 * _e4773));
                                        let _e5158 = (((_e5147 * _e4787[0]) + (_e5150 * _e4787[1])) + (_e5153 * _e4787[2]));
                                        let _e5163 = (((_e5147 * _e4804) + (_e5150 * _e4805)) + (_e5153 * _e4806));
                                        let _e5168 = (((_e5147 * _e4814) + (_e5150 * _e4815)) + (_e5153 * _e4816));
                                        let _e5176 = (((_e5147 * _e4813[0]) + (_e5150 * _e4813[1])) + (_e5153 * _e4813[2]));
                                        let _e5181 = (((_e5147 * _e4819[0]) + (_e5150 * _e4819[1])) + (_e5153 * _e4819[2]));
                                        let _e5186 = (((_e5147 * _e4836) + (_e5150 * _e4837)) + (_e5153 * _e4838));
                                        let _e5191 = (((_e5147 * _e4846) + (_e5150 * _e4847)) + (_e5153 * _e4848));
                                        let _e5199 = (((_e5147 * _e4845[0]) + (_e5150 * _e4845[1])) + (_e5153 * _e4845[2]));
                                        if (_e5158 < _e5163) {
                                            phi_7991_ = _e5158;
                                        } else {
                                            phi_7991_ = _e5163;
                                        }
                                        let _e5202 = phi_7991_;
                                        if (_e5168 < _e5176) {
                                            phi_7996_ = _e5168;
                                        } else {
                                            phi_7996_ = _e5176;
                                        }
                                        let _e5205 = phi_7996_;
                                        if (_e5202 < _e5205) {
                                            phi_8001_ = _e5202;
                                        } else {
                                            phi_8001_ = _e5205;
                                        }
                                        let _e5208 = phi_8001_;
                                        if (_e5181 < _e5186) {
                                            phi_8006_ = _e5181;
                                        } else {
                                            phi_8006_ = _e5186;
                                        }
                                        let _e5211 = phi_8006_;
                                        if (_e5191 < _e5199) {
                                            phi_8011_ = _e5191;
                                        } else {
                                            phi_8011_ = _e5199;
                                        }
                                        let _e5214 = phi_8011_;
                                        if (_e5211 < _e5214) {
                                            phi_8016_ = _e5211;
                                        } else {
                                            phi_8016_ = _e5214;
                                        }
                                        let _e5217 = phi_8016_;
                                        if (_e5208 < _e5217) {
                                            phi_8021_ = _e5208;
                                        } else {
                                            phi_8021_ = _e5217;
                                        }
                                        let _e5220 = phi_8021_;
                                        if (_e5158 > _e5163) {
                                            phi_8026_ = _e5158;
                                        } else {
                                            phi_8026_ = _e5163;
                                        }
                                        let _e5223 = phi_8026_;
                                        if (_e5168 > _e5176) {
                                            phi_8031_ = _e5168;
                                        } else {
                                            phi_8031_ = _e5176;
                                        }
                                        let _e5226 = phi_8031_;
                                        if (_e5223 > _e5226) {
                                            phi_8036_ = _e5223;
                                        } else {
                                            phi_8036_ = _e5226;
                                        }
                                        let _e5229 = phi_8036_;
                                        if (_e5181 > _e5186) {
                                            phi_8041_ = _e5181;
                                        } else {
                                            phi_8041_ = _e5186;
                                        }
                                        let _e5232 = phi_8041_;
                                        if (_e5191 > _e5199) {
                                            phi_8046_ = _e5191;
                                        } else {
                                            phi_8046_ = _e5199;
                                        }
                                        let _e5235 = phi_8046_;
                                        if (_e5232 > _e5235) {
                                            phi_8051_ = _e5232;
                                        } else {
                                            phi_8051_ = _e5235;
                                        }
                                        let _e5238 = phi_8051_;
                                        if (_e5229 > _e5238) {
                                            phi_8056_ = _e5229;
                                        } else {
                                            phi_8056_ = _e5238;
                                        }
                                        let _e5241 = phi_8056_;
                                        if (_e5147 < 0f) {
                                            phi_8062_ = -(_e5147);
                                        } else {
                                            phi_8062_ = _e5147;
                                        }
                                        let _e5245 = phi_8062_;
                                        if (_e5150 < 0f) {
                                            phi_8068_ = -(_e5150);
                                        } else {
                                            phi_8068_ = _e5150;
                                        }
                                        let _e5249 = phi_8068_;
                                        if (_e5153 < 0f) {
                                            phi_8075_ = -(_e5153);
                                        } else {
                                            phi_8075_ = _e5153;
                                        }
                                        let _e5254 = phi_8075_;
                                        let _e5255 = ((_e5245 + _e5249) + _e5254);
                                        let _e5260 = -(_e5241);
                                        if (_e5220 > _e5260) {
                                            phi_8086_ = _e5220;
                                        } else {
                                            phi_8086_ = _e5260;
                                        }
                                        let _e5263 = phi_8086_;
                                        let _e5268 = (((_e5263 - ((_e5255 * _e5013) * (0.000000059604645f * (17f / 2f)))) - (_e5255 * _e5020)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5144 > _e5268) {
                                            phi_8096_ = _e5144;
                                        } else {
                                            phi_8096_ = _e5268;
                                        }
                                        let _e5271 = phi_8096_;
                                        if (_e2989.member == 0u) {
                                            let _e5273 = (_e4773 - _e4758);
                                            let _e5274 = (_e4774 - _e4759);
                                            let _e5275 = (_e4775 - _e4760);
                                            let _e5278 = ((_e4781 * _e5275) - (_e4784 * _e5274));
                                            let _e5281 = ((_e4784 * _e5273) - (_e4778 * _e5275));
                                            let _e5284 = ((_e4778 * _e5274) - (_e4781 * _e5273));
                                            let _e5289 = (((_e5278 * _e4787[0]) + (_e5281 * _e4787[1])) + (_e5284 * _e4787[2]));
                                            let _e5294 = (((_e5278 * _e4804) + (_e5281 * _e4805)) + (_e5284 * _e4806));
                                            let _e5299 = (((_e5278 * _e4814) + (_e5281 * _e4815)) + (_e5284 * _e4816));
                                            let _e5307 = (((_e5278 * _e4813[0]) + (_e5281 * _e4813[1])) + (_e5284 * _e4813[2]));
                                            let _e5312 = (((_e5278 * _e4819[0]) + (_e5281 * _e4819[1])) + (_e5284 * _e4819[2]));
                                            let _e5317 = (((_e5278 * _e4836) + (_e5281 * _e4837)) + (_e5284 * _e4838));
                                            let _e5322 = (((_e5278 * _e4846) + (_e5281 * _e4847)) + (_e5284 * _e4848));
                                            let _e5330 = (((_e5278 * _e4845[0]) + (_e5281 * _e4845[1])) + (_e5284 * _e4845[2]));
                                            if (_e5289 < _e5294) {
                                                phi_8169_ = _e5289;
                                            } else {
                                                phi_8169_ = _e5294;
                                            }
                                            let _e5333 = phi_8169_;
                                            if (_e5299 < _e5307) {
                                                phi_8174_ = _e5299;
                                            } else {
                                                phi_8174_ = _e5307;
                                            }
                                            let _e5336 = phi_8174_;
                                            if (_e5333 < _e5336) {
                                                phi_8179_ = _e5333;
                                            } else {
                                                phi_8179_ = _e5336;
                                            }
                                            let _e5339 = phi_8179_;
                                            if (_e5312 < _e5317) {
                                                phi_8184_ = _e5312;
                                            } else {
                                                phi_8184_ = _e5317;
                                            }
                                            let _e5342 = phi_8184_;
                                            if (_e5322 < _e5330) {
                                                phi_8189_ = _e5322;
                                            } else {
                                                phi_8189_ = _e5330;
                                            }
                                            let _e5345 = phi_8189_;
                                            if (_e5342 < _e5345) {
                                                phi_8194_ = _e5342;
                                            } else {
                                                phi_8194_ = _e5345;
                                            }
                                            let _e5348 = phi_8194_;
                                            if (_e5339 < _e5348) {
                                                phi_8199_ = _e5339;
                                            } else {
                                                phi_8199_ = _e5348;
                                            }
                                            let _e5351 = phi_8199_;
                                            if (_e5289 > _e5294) {
                                                phi_8204_ = _e5289;
                                            } else {
                                                phi_8204_ = _e5294;
                                            }
                                            let _e5354 = phi_8204_;
                                            if (_e5299 > _e5307) {
                                                phi_8209_ = _e5299;
                                            } else {
                                                phi_8209_ = _e5307;
                                            }
                                            let _e5357 = phi_8209_;
                                            if (_e5354 > _e5357) {
                                                phi_8214_ = _e5354;
                                            } else {
                                                phi_8214_ = _e5357;
                                            }
                                            let _e5360 = phi_8214_;
                                            if (_e5312 > _e5317) {
                                                phi_8219_ = _e5312;
                                            } else {
                                                phi_8219_ = _e5317;
                                            }
                                            let _e5363 = phi_8219_;
                                            if (_e5322 > _e5330) {
                                                phi_8224_ = _e5322;
                                            } else {
                                                phi_8224_ = _e5330;
                                            }
                                            let _e5366 = phi_8224_;
                                            if (_e5363 > _e5366) {
                                                phi_8229_ = _e5363;
                                            } else {
                                                phi_8229_ = _e5366;
                                            }
                                            let _e5369 = phi_8229_;
                                            if (_e5360 > _e5369) {
                                                phi_8234_ = _e5360;
                                            } else {
                                                phi_8234_ = _e5369;
                                            }
                                            let _e5372 = phi_8234_;
                                            if (_e5278 < 0f) {
                                                phi_8240_ = -(_e5278);
                                            } else {
                                                phi_8240_ = _e5278;
                                            }
                                            let _e5376 = phi_8240_;
                                            if (_e5281 < 0f) {
                                                phi_8246_ = -(_e5281);
                                            } else {
                                                phi_8246_ = _e5281;
                                            }
                                            let _e5380 = phi_8246_;
                                            if (_e5284 < 0f) {
                                                phi_8253_ = -(_e5284);
                                            } else {
                                                phi_8253_ = _e5284;
                                            }
                                            let _e5385 = phi_8253_;
                                            let _e5386 = ((_e5376 + _e5380) + _e5385);
                                            let _e5391 = -(_e5372);
                                            if (_e5351 > _e5391) {
                                                phi_8264_ = _e5351;
                                            } else {
                                                phi_8264_ = _e5391;
                                            }
                                            let _e5394 = phi_8264_;
                                            let _e5399 = (((_e5394 - ((_e5386 * _e5013) * (0.000000059604645f * (17f / 2f)))) - (_e5386 * _e5020)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                            if (_e5271 > _e5399) {
                                                phi_8274_ = _e5271;
                                            } else {
                                                phi_8274_ = _e5399;
                                            }
                                            let _e5402 = phi_8274_;
                                            phi_8275_ = _e5402;
                                        } else {
                                            phi_8275_ = _e5271;
                                        }
                                        let _e5404 = phi_8275_;
                                        phi_8278_ = (_e4745 || (_e5404 > 0f));
                                    }
                                    let _e5408 = phi_8278_;
                                    phi_8280_ = (_e4310 && _e5408);
                                } else {
                                    phi_8280_ = _e4310;
                                }
                                let _e5411 = phi_8280_;
                                if _e5411 {
                                } else {
                                    let _e5413 = atomicAdd((&counters[7u]), 1u);
                                    hits[_e2953] = ((2147483648u | (_e5413 << bitcast<u32>(12i))) | _e2956);
                                }
                                phi_8290_ = true;
                            }
                            let _e5420 = phi_8290_;
                            phi_8291_ = _e5420;
                        } else {
                            phi_8291_ = false;
                        }
                        let _e5422 = phi_8291_;
                        continue;
                        continuing {
                            phi_4709_ = _e2945;
                            break if !(_e5422);
                        }
                    }
                    let _e5426 = params.member.member_1.member_3;
                    workgroupBarrier();
                    if (_e73 == 0u) {
                        let _e5429 = atomicLoad((&counters[7u]));
                        if (_e5429 > 0u) {
                            let _e5432 = atomicAdd((&output.member[0u]), _e5429);
                            if ((_e5432 + _e5429) < _e5432) {
                                let _e5436 = atomicAdd((&output.member[2u]), 1u);
                            }
                            atomicStore((&counters[8u]), _e5432);
                        }
                        atomicStore((&counters[5u]), 0u);
                        atomicStore((&counters[6u]), 0u);
                        atomicStore((&counters[7u]), 0u);
                    }
                    workgroupBarrier();
                    let _e5442 = atomicLoad((&counters[8u]));
                    phi_8327_ = type_9(0u, 4u);
                    loop {
                        let _e5444 = phi_8327_;
                        if (_e5444.member < _e5444.member_1) {
                            phi_8328_ = type_9((_e5444.member + 1u), _e5444.member_1);
                            phi_8351_ = type_9(1u, _e5444.member);
                        } else {
                            phi_8328_ = _e5444;
                            phi_8351_ = type_9(0u, type_9().member_1);
                        }
                        let _e5456 = phi_8328_;
                        let _e5458 = phi_8351_;
                        if (bitcast<i32>(_e5458.member) != 0i) {
                            let _e5464 = (_e73 + (_e5458.member_1 * 128u));
                            if (_e5464 >= _e2931) {
                                phi_8446_ = false;
                            } else {
                                let _e5467 = hits[_e5464];
                                if ((_e5467 & 2147483648u) == 0u) {
                                    phi_8375_ = 4294967295u;
                                } else {
                                    phi_8375_ = ((_e5467 & 2147483647u) >> bitcast<u32>(12i));
                                }
                                let _e5474 = phi_8375_;
                                if (_e5474 != 4294967295u) {
                                    let _e5478 = ((_e5467 >> bitcast<u32>(10i)) & 3u);
                                    let _e5485 = firsts[(2u * _e5478)];
                                    let _e5490 = firsts[((2u * _e5478) + 1u)];
                                    let _e5493 = leaves.member[(_e5485 + ((_e5467 >> bitcast<u32>(5i)) & 31u))];
                                    let _e5496 = leaves.member[(_e5490 + (_e5467 & 31u))];
                                    let _e5498 = (_e5442 + _e5474);
                                    if (_e5493.w < _e5496.w) {
                                        phi_8427_ = type_9(_e5493.w, _e5496.w);
                                    } else {
                                        phi_8427_ = type_9(_e5496.w, _e5493.w);
                                    }
                                    let _e5503 = phi_8427_;
                                    if (_e5498 < _e5426) {
                                        let _e5507 = (2u * _e5498);
                                        atomicStore((&output.member[(4u + _e5507)]), _e5503.member);
                                        atomicStore((&output.member[(_e5507 + 5u)]), _e5503.member_1);
                                    }
                                }
                                phi_8446_ = true;
                            }
                            let _e5513 = phi_8446_;
                            phi_8447_ = _e5513;
                        } else {
                            phi_8447_ = false;
                        }
                        let _e5515 = phi_8447_;
                        continue;
                        continuing {
                            phi_8327_ = _e5456;
                            break if !(_e5515);
                        }
                    }
                    workgroupBarrier();
                    let _e6119 = local_8;
                    phi_1245_ = _e6119;
                } else {
                    phi_1245_ = type_9();
                }
                let _e5518 = phi_1245_;
                continue;
                continuing {
                    phi_1241_ = _e677;
                    phi_1244_ = _e5518;
                    break if !(_e683);
                }
            }
        }
        continue;
        continuing {
            phi_478_ = _e163;
            break if !(_e169);
        }
    }
    if (_e73 == 0u) {
        let _e5523 = atomicLoad((&counters[9u]));
        if (_e5523 > 0u) {
            let _e5526 = atomicAdd((&output.member[1u]), _e5523);
            if ((_e5526 + _e5523) < _e5526) {
                let _e5530 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_8(id, n, lane);
}
