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

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_15 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_24 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_26 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_27 {
    member: u32,
}

struct type_28 {
    member: type_7,
    member_1: type_8,
    member_2: type_27,
}

struct type_29 {
    member: type_28,
}

struct type_31 {
    member: array<array<u32, 3>>,
}

struct type_34 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> bodies: type_10;
@group(0) @binding(4) 
var<storage> keys: type_24;
@group(0) @binding(5) 
var<storage> paths: type_17;
@group(0) @binding(6) 
var<storage> input: type_10;
@group(0) @binding(7) 
var<storage, read_write> output: type_34;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_29;
@group(0) @binding(1) 
var<storage> boxes: type_21;
@group(0) @binding(2) 
var<storage> elements: type_31;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_138_: bool;
    var phi_139_: bool;
    var phi_143_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_139_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_138_ = (param[0] > param_1[0]);
        } else {
            phi_138_ = false;
        }
        let _e14 = phi_138_;
        phi_139_ = _e14;
    }
    let _e16 = phi_139_;
    if _e16 {
        phi_143_ = param_1;
    } else {
        phi_143_ = param;
    }
    let _e18 = phi_143_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_162_: bool;
    var phi_163_: bool;
    var phi_167_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_163_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_162_ = (param_3[0] > param_2[0]);
        } else {
            phi_162_ = false;
        }
        let _e14 = phi_162_;
        phi_163_ = _e14;
    }
    let _e16 = phi_163_;
    if _e16 {
        phi_167_ = param_3;
    } else {
        phi_167_ = param_2;
    }
    let _e18 = phi_167_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_186_: bool;
    var phi_187_: bool;
    var phi_191_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_187_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_186_ = (param_4[0] > param_5[0]);
        } else {
            phi_186_ = false;
        }
        let _e14 = phi_186_;
        phi_187_ = _e14;
    }
    let _e16 = phi_187_;
    if _e16 {
        phi_191_ = param_5;
    } else {
        phi_191_ = param_4;
    }
    let _e18 = phi_191_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_210_: bool;
    var phi_211_: bool;
    var phi_215_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_211_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_210_ = (param_7[0] > param_6[0]);
        } else {
            phi_210_ = false;
        }
        let _e14 = phi_210_;
        phi_211_ = _e14;
    }
    let _e16 = phi_211_;
    if _e16 {
        phi_215_ = param_7;
    } else {
        phi_215_ = param_6;
    }
    let _e18 = phi_215_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_234_: bool;
    var phi_235_: bool;
    var phi_239_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_235_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_234_ = (param_8[0] > param_9[0]);
        } else {
            phi_234_ = false;
        }
        let _e14 = phi_234_;
        phi_235_ = _e14;
    }
    let _e16 = phi_235_;
    if _e16 {
        phi_239_ = param_9;
    } else {
        phi_239_ = param_8;
    }
    let _e18 = phi_239_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_258_: bool;
    var phi_259_: bool;
    var phi_263_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_259_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_258_ = (param_11[0] > param_10[0]);
        } else {
            phi_258_ = false;
        }
        let _e14 = phi_258_;
        phi_259_ = _e14;
    }
    let _e16 = phi_259_;
    if _e16 {
        phi_263_ = param_11;
    } else {
        phi_263_ = param_10;
    }
    let _e18 = phi_263_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: type_26;
    var local_2: type_26;
    var phi_310_: u32;
    var phi_320_: u32;
    var phi_327_: u32;
    var phi_343_: u32;
    var phi_364_: u32;
    var phi_365_: u32;
    var phi_368_: type_12;
    var phi_369_: type_12;
    var phi_392_: type_12;
    var phi_513_: bool;
    var phi_520_: bool;
    var phi_528_: bool;
    var phi_549_: bool;
    var phi_550_: bool;
    var phi_595_: bool;
    var phi_602_: bool;
    var phi_606_: bool;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_922_: bool;
    var phi_923_: bool;
    var phi_1013_: bool;
    var phi_1014_: bool;
    var phi_1106_: bool;
    var phi_1107_: bool;
    var phi_1197_: bool;
    var phi_1198_: bool;
    var phi_1202_: bool;
    var phi_1203_: bool;
    var phi_1204_: bool;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1210_: bool;
    var phi_1211_: bool;
    var phi_1212_: bool;
    var phi_1216_: bool;
    var phi_1610_: f32;
    var phi_1617_: f32;
    var phi_1622_: f32;
    var phi_1629_: f32;
    var phi_1634_: f32;
    var phi_1647_: f32;
    var phi_1654_: f32;
    var phi_1659_: f32;
    var phi_1666_: f32;
    var phi_1671_: f32;
    var phi_1676_: f32;
    var phi_1693_: f32;
    var phi_1700_: f32;
    var phi_1705_: f32;
    var phi_1712_: f32;
    var phi_1717_: f32;
    var phi_1731_: f32;
    var phi_1738_: f32;
    var phi_1743_: f32;
    var phi_1750_: f32;
    var phi_1755_: f32;
    var phi_1760_: f32;
    var phi_1777_: f32;
    var phi_1784_: f32;
    var phi_1789_: f32;
    var phi_1796_: f32;
    var phi_1801_: f32;
    var phi_1815_: f32;
    var phi_1822_: f32;
    var phi_1827_: f32;
    var phi_1834_: f32;
    var phi_1839_: f32;
    var phi_1844_: f32;
    var phi_1875_: f32;
    var phi_1881_: f32;
    var phi_1888_: f32;
    var phi_1895_: f32;
    var phi_1901_: f32;
    var phi_1908_: f32;
    var phi_1914_: f32;
    var phi_1920_: f32;
    var phi_1926_: f32;
    var phi_1933_: f32;
    var phi_1940_: f32;
    var phi_1964_: f32;
    var phi_1969_: f32;
    var phi_1974_: f32;
    var phi_1979_: f32;
    var phi_1984_: f32;
    var phi_1989_: f32;
    var phi_1999_: f32;
    var phi_2202_: f32;
    var phi_2209_: f32;
    var phi_2214_: f32;
    var phi_2221_: f32;
    var phi_2226_: f32;
    var phi_2239_: f32;
    var phi_2246_: f32;
    var phi_2251_: f32;
    var phi_2258_: f32;
    var phi_2263_: f32;
    var phi_2268_: f32;
    var phi_2285_: f32;
    var phi_2292_: f32;
    var phi_2297_: f32;
    var phi_2304_: f32;
    var phi_2309_: f32;
    var phi_2323_: f32;
    var phi_2330_: f32;
    var phi_2335_: f32;
    var phi_2342_: f32;
    var phi_2347_: f32;
    var phi_2352_: f32;
    var phi_2369_: f32;
    var phi_2376_: f32;
    var phi_2381_: f32;
    var phi_2388_: f32;
    var phi_2393_: f32;
    var phi_2407_: f32;
    var phi_2414_: f32;
    var phi_2419_: f32;
    var phi_2426_: f32;
    var phi_2431_: f32;
    var phi_2436_: f32;
    var phi_2515_: f32;
    var phi_2520_: f32;
    var phi_2525_: f32;
    var phi_2530_: f32;
    var phi_2535_: f32;
    var phi_2540_: f32;
    var phi_2545_: f32;
    var phi_2550_: f32;
    var phi_2555_: f32;
    var phi_2560_: f32;
    var phi_2565_: f32;
    var phi_2570_: f32;
    var phi_2575_: f32;
    var phi_2580_: f32;
    var phi_2586_: f32;
    var phi_2592_: f32;
    var phi_2599_: f32;
    var phi_2610_: f32;
    var phi_2681_: f32;
    var phi_2686_: f32;
    var phi_2691_: f32;
    var phi_2696_: f32;
    var phi_2701_: f32;
    var phi_2706_: f32;
    var phi_2711_: f32;
    var phi_2716_: f32;
    var phi_2721_: f32;
    var phi_2726_: f32;
    var phi_2731_: f32;
    var phi_2736_: f32;
    var phi_2741_: f32;
    var phi_2746_: f32;
    var phi_2752_: f32;
    var phi_2758_: f32;
    var phi_2765_: f32;
    var phi_2776_: f32;
    var phi_2786_: f32;
    var phi_2859_: f32;
    var phi_2864_: f32;
    var phi_2869_: f32;
    var phi_2874_: f32;
    var phi_2879_: f32;
    var phi_2884_: f32;
    var phi_2889_: f32;
    var phi_2894_: f32;
    var phi_2899_: f32;
    var phi_2904_: f32;
    var phi_2909_: f32;
    var phi_2914_: f32;
    var phi_2919_: f32;
    var phi_2924_: f32;
    var phi_2930_: f32;
    var phi_2936_: f32;
    var phi_2943_: f32;
    var phi_2954_: f32;
    var phi_2964_: f32;
    var phi_2968_: bool;
    var phi_3420_: f32;
    var phi_3427_: f32;
    var phi_3432_: f32;
    var phi_3439_: f32;
    var phi_3444_: f32;
    var phi_3457_: f32;
    var phi_3464_: f32;
    var phi_3469_: f32;
    var phi_3476_: f32;
    var phi_3481_: f32;
    var phi_3486_: f32;
    var phi_3503_: f32;
    var phi_3510_: f32;
    var phi_3515_: f32;
    var phi_3522_: f32;
    var phi_3527_: f32;
    var phi_3541_: f32;
    var phi_3548_: f32;
    var phi_3553_: f32;
    var phi_3560_: f32;
    var phi_3565_: f32;
    var phi_3570_: f32;
    var phi_3587_: f32;
    var phi_3594_: f32;
    var phi_3599_: f32;
    var phi_3606_: f32;
    var phi_3611_: f32;
    var phi_3625_: f32;
    var phi_3632_: f32;
    var phi_3637_: f32;
    var phi_3644_: f32;
    var phi_3649_: f32;
    var phi_3654_: f32;
    var phi_3685_: f32;
    var phi_3691_: f32;
    var phi_3698_: f32;
    var phi_3705_: f32;
    var phi_3711_: f32;
    var phi_3718_: f32;
    var phi_3724_: f32;
    var phi_3730_: f32;
    var phi_3736_: f32;
    var phi_3743_: f32;
    var phi_3750_: f32;
    var phi_3774_: f32;
    var phi_3779_: f32;
    var phi_3784_: f32;
    var phi_3789_: f32;
    var phi_3794_: f32;
    var phi_3799_: f32;
    var phi_3809_: f32;
    var phi_4012_: f32;
    var phi_4019_: f32;
    var phi_4024_: f32;
    var phi_4031_: f32;
    var phi_4036_: f32;
    var phi_4049_: f32;
    var phi_4056_: f32;
    var phi_4061_: f32;
    var phi_4068_: f32;
    var phi_4073_: f32;
    var phi_4078_: f32;
    var phi_4095_: f32;
    var phi_4102_: f32;
    var phi_4107_: f32;
    var phi_4114_: f32;
    var phi_4119_: f32;
    var phi_4133_: f32;
    var phi_4140_: f32;
    var phi_4145_: f32;
    var phi_4152_: f32;
    var phi_4157_: f32;
    var phi_4162_: f32;
    var phi_4179_: f32;
    var phi_4186_: f32;
    var phi_4191_: f32;
    var phi_4198_: f32;
    var phi_4203_: f32;
    var phi_4217_: f32;
    var phi_4224_: f32;
    var phi_4229_: f32;
    var phi_4236_: f32;
    var phi_4241_: f32;
    var phi_4246_: f32;
    var phi_4325_: f32;
    var phi_4330_: f32;
    var phi_4335_: f32;
    var phi_4340_: f32;
    var phi_4345_: f32;
    var phi_4350_: f32;
    var phi_4355_: f32;
    var phi_4360_: f32;
    var phi_4365_: f32;
    var phi_4370_: f32;
    var phi_4375_: f32;
    var phi_4380_: f32;
    var phi_4385_: f32;
    var phi_4390_: f32;
    var phi_4396_: f32;
    var phi_4402_: f32;
    var phi_4409_: f32;
    var phi_4420_: f32;
    var phi_4491_: f32;
    var phi_4496_: f32;
    var phi_4501_: f32;
    var phi_4506_: f32;
    var phi_4511_: f32;
    var phi_4516_: f32;
    var phi_4521_: f32;
    var phi_4526_: f32;
    var phi_4531_: f32;
    var phi_4536_: f32;
    var phi_4541_: f32;
    var phi_4546_: f32;
    var phi_4551_: f32;
    var phi_4556_: f32;
    var phi_4562_: f32;
    var phi_4568_: f32;
    var phi_4575_: f32;
    var phi_4586_: f32;
    var phi_4596_: f32;
    var phi_4669_: f32;
    var phi_4674_: f32;
    var phi_4679_: f32;
    var phi_4684_: f32;
    var phi_4689_: f32;
    var phi_4694_: f32;
    var phi_4699_: f32;
    var phi_4704_: f32;
    var phi_4709_: f32;
    var phi_4714_: f32;
    var phi_4719_: f32;
    var phi_4724_: f32;
    var phi_4729_: f32;
    var phi_4734_: f32;
    var phi_4740_: f32;
    var phi_4746_: f32;
    var phi_4753_: f32;
    var phi_4764_: f32;
    var phi_4774_: f32;
    var phi_4778_: bool;
    var phi_5023_: f32;
    var phi_5030_: f32;
    var phi_5035_: f32;
    var phi_5042_: f32;
    var phi_5047_: f32;
    var phi_5060_: f32;
    var phi_5067_: f32;
    var phi_5072_: f32;
    var phi_5079_: f32;
    var phi_5084_: f32;
    var phi_5089_: f32;
    var phi_5106_: f32;
    var phi_5113_: f32;
    var phi_5118_: f32;
    var phi_5125_: f32;
    var phi_5130_: f32;
    var phi_5144_: f32;
    var phi_5151_: f32;
    var phi_5156_: f32;
    var phi_5163_: f32;
    var phi_5168_: f32;
    var phi_5173_: f32;
    var phi_5190_: f32;
    var phi_5197_: f32;
    var phi_5202_: f32;
    var phi_5209_: f32;
    var phi_5214_: f32;
    var phi_5228_: f32;
    var phi_5235_: f32;
    var phi_5240_: f32;
    var phi_5247_: f32;
    var phi_5252_: f32;
    var phi_5257_: f32;
    var phi_5288_: f32;
    var phi_5294_: f32;
    var phi_5301_: f32;
    var phi_5308_: f32;
    var phi_5314_: f32;
    var phi_5321_: f32;
    var phi_5327_: f32;
    var phi_5333_: f32;
    var phi_5339_: f32;
    var phi_5346_: f32;
    var phi_5353_: f32;
    var phi_5377_: f32;
    var phi_5382_: f32;
    var phi_5387_: f32;
    var phi_5392_: f32;
    var phi_5397_: f32;
    var phi_5402_: f32;
    var phi_5412_: f32;
    var phi_5615_: f32;
    var phi_5622_: f32;
    var phi_5627_: f32;
    var phi_5634_: f32;
    var phi_5639_: f32;
    var phi_5652_: f32;
    var phi_5659_: f32;
    var phi_5664_: f32;
    var phi_5671_: f32;
    var phi_5676_: f32;
    var phi_5681_: f32;
    var phi_5698_: f32;
    var phi_5705_: f32;
    var phi_5710_: f32;
    var phi_5717_: f32;
    var phi_5722_: f32;
    var phi_5736_: f32;
    var phi_5743_: f32;
    var phi_5748_: f32;
    var phi_5755_: f32;
    var phi_5760_: f32;
    var phi_5765_: f32;
    var phi_5782_: f32;
    var phi_5789_: f32;
    var phi_5794_: f32;
    var phi_5801_: f32;
    var phi_5806_: f32;
    var phi_5820_: f32;
    var phi_5827_: f32;
    var phi_5832_: f32;
    var phi_5839_: f32;
    var phi_5844_: f32;
    var phi_5849_: f32;
    var phi_5928_: f32;
    var phi_5933_: f32;
    var phi_5938_: f32;
    var phi_5943_: f32;
    var phi_5948_: f32;
    var phi_5953_: f32;
    var phi_5958_: f32;
    var phi_5963_: f32;
    var phi_5968_: f32;
    var phi_5973_: f32;
    var phi_5978_: f32;
    var phi_5983_: f32;
    var phi_5988_: f32;
    var phi_5993_: f32;
    var phi_5999_: f32;
    var phi_6005_: f32;
    var phi_6012_: f32;
    var phi_6023_: f32;
    var phi_6094_: f32;
    var phi_6099_: f32;
    var phi_6104_: f32;
    var phi_6109_: f32;
    var phi_6114_: f32;
    var phi_6119_: f32;
    var phi_6124_: f32;
    var phi_6129_: f32;
    var phi_6134_: f32;
    var phi_6139_: f32;
    var phi_6144_: f32;
    var phi_6149_: f32;
    var phi_6154_: f32;
    var phi_6159_: f32;
    var phi_6165_: f32;
    var phi_6171_: f32;
    var phi_6178_: f32;
    var phi_6189_: f32;
    var phi_6199_: f32;
    var phi_6272_: f32;
    var phi_6277_: f32;
    var phi_6282_: f32;
    var phi_6287_: f32;
    var phi_6292_: f32;
    var phi_6297_: f32;
    var phi_6302_: f32;
    var phi_6307_: f32;
    var phi_6312_: f32;
    var phi_6317_: f32;
    var phi_6322_: f32;
    var phi_6327_: f32;
    var phi_6332_: f32;
    var phi_6337_: f32;
    var phi_6343_: f32;
    var phi_6349_: f32;
    var phi_6356_: f32;
    var phi_6367_: f32;
    var phi_6377_: f32;
    var phi_6381_: bool;
    var phi_6383_: bool;
    var phi_6385_: bool;
    var phi_6392_: u32;
    var phi_6393_: u32;
    var phi_6394_: bool;
    var phi_6395_: u32;
    var phi_6396_: bool;
    var phi_6397_: type_12;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e45 = id_2;
    let _e46 = n_2;
    let _e47 = lane_2;
    let _e60 = ((_e45.y * _e46.x) + _e45.x);
    let _e63 = (_e46.x * _e46.y);
    let _e66 = params.member.member_1.member_2;
    let _e68 = input.member[0u];
    if (_e66 < _e68) {
        phi_310_ = _e66;
    } else {
        phi_310_ = _e68;
    }
    let _e71 = phi_310_;
    let _e73 = params.member.member_1.member_1;
    if (_e71 > _e73) {
        let _e76 = params.member.member_1.member_1;
        phi_320_ = (_e71 - _e76);
    } else {
        phi_320_ = 0u;
    }
    let _e79 = phi_320_;
    let _e81 = params.member.member_1.member;
    if (_e81 < _e79) {
        phi_327_ = _e81;
    } else {
        phi_327_ = _e79;
    }
    let _e84 = phi_327_;
    let _e85 = (_e84 / 128u);
    if ((_e84 % 128u) > 0u) {
        phi_343_ = (_e85 + 1u);
    } else {
        phi_343_ = _e85;
    }
    let _e90 = phi_343_;
    if (_e90 > _e60) {
        let _e92 = (_e90 - _e60);
        if (_e63 == 0u) {
            return;
        }
        let _e94 = (_e92 / _e63);
        if (_e63 == 0u) {
            return;
        }
        if ((_e92 % _e63) > 0u) {
            phi_364_ = (_e94 + 1u);
        } else {
            phi_364_ = _e94;
        }
        let _e100 = phi_364_;
        phi_365_ = _e100;
    } else {
        phi_365_ = 0u;
    }
    let _e102 = phi_365_;
    phi_368_ = type_12(0u, _e102);
    loop {
        let _e105 = phi_368_;
        if (_e105.member < _e105.member_1) {
            phi_369_ = type_12((_e105.member + 1u), _e105.member_1);
            phi_392_ = type_12(1u, _e105.member);
        } else {
            phi_369_ = _e105;
            phi_392_ = type_12(0u, type_12().member_1);
        }
        let _e117 = phi_369_;
        let _e119 = phi_392_;
        let _e123 = (bitcast<i32>(_e119.member) != 0i);
        if _e123 {
            let _e127 = (((_e60 + (_e119.member_1 * _e63)) * 128u) + _e47);
            if (_e47 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e127 < _e84) {
                let _e133 = params.member.member_1.member_1;
                let _e135 = (2u * (_e133 + _e127));
                let _e138 = input.member[(4u + _e135)];
                let _e141 = input.member[(_e135 + 5u)];
                let _e144 = elements.member[_e141];
                let _e148 = params.member.member.member_2[2u];
                let _e151 = boxes.member[_e138];
                let _e153 = boxes.member[(_e148 + _e141)];
                let _e156 = params.member.member.member_1;
                if ((_e156 & 1u) != 0u) {
                    if (_e144[0] == _e138) {
                        phi_513_ = true;
                    } else {
                        phi_513_ = (_e144[0] == _e138);
                    }
                    let _e163 = phi_513_;
                    if (_e144[1] == _e138) {
                        phi_520_ = true;
                    } else {
                        phi_520_ = (_e144[1] == _e138);
                    }
                    let _e168 = phi_520_;
                    if (_e144[2] == _e138) {
                        phi_528_ = true;
                    } else {
                        phi_528_ = (_e144[2] == _e138);
                    }
                    let _e174 = phi_528_;
                    if ((_e163 || _e168) || _e174) {
                        phi_549_ = false;
                    } else {
                        phi_549_ = true;
                    }
                    let _e177 = phi_549_;
                    phi_550_ = _e177;
                } else {
                    phi_550_ = true;
                }
                let _e179 = phi_550_;
                if _e179 {
                    let _e181 = params.member.member.member_1;
                    if ((_e181 & 2u) != 0u) {
                        let _e185 = params.member.member.member_1;
                        let _e189 = bodies.member[_e138];
                        let _e192 = bodies.member[_e144[0]];
                        if ((_e189 / 2u) != (_e192 / 2u)) {
                            phi_595_ = true;
                        } else {
                            phi_595_ = ((_e185 & 4u) != 0u);
                        }
                        let _e197 = phi_595_;
                        if _e197 {
                            phi_602_ = (((_e189 & _e192) & 1u) == 0u);
                        } else {
                            phi_602_ = false;
                        }
                        let _e202 = phi_602_;
                        phi_606_ = _e202;
                    } else {
                        phi_606_ = true;
                    }
                    let _e204 = phi_606_;
                    if _e204 {
                        let _e206 = params.member.member.member_1;
                        if ((_e206 & 32u) != 0u) {
                            let _e210 = params.member.member.member_6;
                            let _e251 = (((((_e151.member_1[0] - _e153.member[0]) > _e210) && ((_e153.member_1[0] - _e151.member[0]) > _e210)) && (((_e151.member_1[1] - _e153.member[1]) > _e210) && ((_e153.member_1[1] - _e151.member[1]) > _e210))) && (((_e151.member_1[2] - _e153.member[2]) > _e210) && ((_e153.member_1[2] - _e151.member[2]) > _e210)));
                            if _e251 {
                                phi_1202_ = bool();
                            } else {
                                let _e253 = keys.member[_e138];
                                let _e256 = keys.member[_e138];
                                let _e258 = function_(_e253[0], _e256[0]);
                                let _e260 = keys.member[_e138];
                                let _e262 = function_(_e258, _e260[0]);
                                let _e265 = keys.member[_e144[0]];
                                let _e269 = keys.member[_e144[1]];
                                let _e271 = function_1(_e265[3], _e269[3]);
                                let _e274 = keys.member[_e144[2]];
                                let _e276 = function_1(_e271, _e274[3]);
                                if (_e262[1] > _e276[1]) {
                                    phi_740_ = true;
                                } else {
                                    if (_e262[1] == _e276[1]) {
                                        phi_739_ = (_e262[0] > _e276[0]);
                                    } else {
                                        phi_739_ = false;
                                    }
                                    let _e287 = phi_739_;
                                    phi_740_ = _e287;
                                }
                                let _e289 = phi_740_;
                                let _e293 = keys.member[_e144[0]];
                                let _e297 = keys.member[_e144[1]];
                                let _e299 = function_(_e293[0], _e297[0]);
                                let _e302 = keys.member[_e144[2]];
                                let _e304 = function_(_e299, _e302[0]);
                                let _e306 = keys.member[_e138];
                                let _e309 = keys.member[_e138];
                                let _e311 = function_1(_e306[3], _e309[3]);
                                let _e313 = keys.member[_e138];
                                let _e315 = function_1(_e311, _e313[3]);
                                if (_e304[1] > _e315[1]) {
                                    phi_831_ = true;
                                } else {
                                    if (_e304[1] == _e315[1]) {
                                        phi_830_ = (_e304[0] > _e315[0]);
                                    } else {
                                        phi_830_ = false;
                                    }
                                    let _e326 = phi_830_;
                                    phi_831_ = _e326;
                                }
                                let _e328 = phi_831_;
                                let _e332 = keys.member[_e138];
                                let _e335 = keys.member[_e138];
                                let _e337 = function_2(_e332[1], _e335[1]);
                                let _e339 = keys.member[_e138];
                                let _e341 = function_2(_e337, _e339[1]);
                                let _e344 = keys.member[_e144[0]];
                                let _e348 = keys.member[_e144[1]];
                                let _e350 = function_3(_e344[4], _e348[4]);
                                let _e353 = keys.member[_e144[2]];
                                let _e355 = function_3(_e350, _e353[4]);
                                if (_e341[1] > _e355[1]) {
                                    phi_923_ = true;
                                } else {
                                    if (_e341[1] == _e355[1]) {
                                        phi_922_ = (_e341[0] > _e355[0]);
                                    } else {
                                        phi_922_ = false;
                                    }
                                    let _e366 = phi_922_;
                                    phi_923_ = _e366;
                                }
                                let _e368 = phi_923_;
                                let _e372 = keys.member[_e144[0]];
                                let _e376 = keys.member[_e144[1]];
                                let _e378 = function_2(_e372[1], _e376[1]);
                                let _e381 = keys.member[_e144[2]];
                                let _e383 = function_2(_e378, _e381[1]);
                                let _e385 = keys.member[_e138];
                                let _e388 = keys.member[_e138];
                                let _e390 = function_3(_e385[4], _e388[4]);
                                let _e392 = keys.member[_e138];
                                let _e394 = function_3(_e390, _e392[4]);
                                if (_e383[1] > _e394[1]) {
                                    phi_1014_ = true;
                                } else {
                                    if (_e383[1] == _e394[1]) {
                                        phi_1013_ = (_e383[0] > _e394[0]);
                                    } else {
                                        phi_1013_ = false;
                                    }
                                    let _e405 = phi_1013_;
                                    phi_1014_ = _e405;
                                }
                                let _e407 = phi_1014_;
                                let _e412 = keys.member[_e138];
                                let _e415 = keys.member[_e138];
                                let _e417 = function_4(_e412[2], _e415[2]);
                                let _e419 = keys.member[_e138];
                                let _e421 = function_4(_e417, _e419[2]);
                                let _e424 = keys.member[_e144[0]];
                                let _e428 = keys.member[_e144[1]];
                                let _e430 = function_5(_e424[5], _e428[5]);
                                let _e433 = keys.member[_e144[2]];
                                let _e435 = function_5(_e430, _e433[5]);
                                if (_e421[1] > _e435[1]) {
                                    phi_1107_ = true;
                                } else {
                                    if (_e421[1] == _e435[1]) {
                                        phi_1106_ = (_e421[0] > _e435[0]);
                                    } else {
                                        phi_1106_ = false;
                                    }
                                    let _e446 = phi_1106_;
                                    phi_1107_ = _e446;
                                }
                                let _e448 = phi_1107_;
                                let _e452 = keys.member[_e144[0]];
                                let _e456 = keys.member[_e144[1]];
                                let _e458 = function_4(_e452[2], _e456[2]);
                                let _e461 = keys.member[_e144[2]];
                                let _e463 = function_4(_e458, _e461[2]);
                                let _e465 = keys.member[_e138];
                                let _e468 = keys.member[_e138];
                                let _e470 = function_5(_e465[5], _e468[5]);
                                let _e472 = keys.member[_e138];
                                let _e474 = function_5(_e470, _e472[5]);
                                if (_e463[1] > _e474[1]) {
                                    phi_1198_ = true;
                                } else {
                                    if (_e463[1] == _e474[1]) {
                                        phi_1197_ = (_e463[0] > _e474[0]);
                                    } else {
                                        phi_1197_ = false;
                                    }
                                    let _e485 = phi_1197_;
                                    phi_1198_ = _e485;
                                }
                                let _e487 = phi_1198_;
                                phi_1202_ = (((!(_e289) && !(_e328)) && (!(_e368) && !(_e407))) && (!(_e448) && !(_e487)));
                            }
                            let _e492 = phi_1202_;
                            phi_1203_ = _e492;
                            phi_1204_ = _e251;
                        } else {
                            phi_1203_ = bool();
                            phi_1204_ = true;
                        }
                        let _e494 = phi_1203_;
                        let _e496 = phi_1204_;
                        if _e496 {
                            phi_1208_ = false;
                        } else {
                            phi_1208_ = true;
                        }
                        let _e498 = phi_1208_;
                        phi_1209_ = _e494;
                        phi_1210_ = _e498;
                    } else {
                        phi_1209_ = false;
                        phi_1210_ = true;
                    }
                    let _e500 = phi_1209_;
                    let _e502 = phi_1210_;
                    phi_1211_ = _e500;
                    phi_1212_ = _e502;
                } else {
                    phi_1211_ = false;
                    phi_1212_ = true;
                }
                let _e504 = phi_1211_;
                let _e506 = phi_1212_;
                if _e506 {
                    phi_1216_ = _e504;
                } else {
                    phi_1216_ = true;
                }
                let _e508 = phi_1216_;
                if _e508 {
                    let _e510 = atomicAdd((&counters[1u]), 1u);
                    let _e513 = params.member.member.member_4;
                    let _e515 = params.member.member.member_5;
                    let _e520 = paths.member[_e138];
                    let _e522 = paths.member[_e144[0]];
                    let _e528 = paths.member[_e144[1]];
                    let _e530 = paths.member[_e144[2]];
                    local_2 = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e520.member[0] - _e522.member[0]), (_e520.member[1] - _e522.member[1]), (_e520.member[2] - _e522.member[2])), array<f32, 3>((_e520.member_1[0] - _e522.member_1[0]), (_e520.member_1[1] - _e522.member_1[1]), (_e520.member_1[2] - _e522.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e528.member[0] - _e522.member[0]), (_e528.member[1] - _e522.member[1]), (_e528.member[2] - _e522.member[2])), array<f32, 3>((_e528.member_1[0] - _e522.member_1[0]), (_e528.member_1[1] - _e522.member_1[1]), (_e528.member_1[2] - _e522.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e530.member[0] - _e522.member[0]), (_e530.member[1] - _e522.member[1]), (_e530.member[2] - _e522.member[2])), array<f32, 3>((_e530.member_1[0] - _e522.member_1[0]), (_e530.member_1[1] - _e522.member_1[1]), (_e530.member_1[2] - _e522.member_1[2]))), (_e513 + _e513));
                    let _e590 = local_2.member_1[0u];
                    let _e596 = local_2.member_2[0u];
                    let _e602 = ((_e590[1] * _e596[2]) - (_e590[2] * _e596[1]));
                    let _e605 = ((_e590[2] * _e596[0]) - (_e590[0] * _e596[2]));
                    let _e608 = ((_e590[0] * _e596[1]) - (_e590[1] * _e596[0]));
                    let _e611 = local_2.member_1[1u];
                    let _e617 = local_2.member_2[1u];
                    let _e623 = ((_e611[1] * _e617[2]) - (_e611[2] * _e617[1]));
                    let _e626 = ((_e611[2] * _e617[0]) - (_e611[0] * _e617[2]));
                    let _e629 = ((_e611[0] * _e617[1]) - (_e611[1] * _e617[0]));
                    let _e632 = local_2.member_1[0u];
                    let _e638 = local_2.member_2[1u];
                    let _e653 = local_2.member_1[1u];
                    let _e659 = local_2.member_2[0u];
                    let _e672 = (((_e632[1] * _e638[2]) - (_e632[2] * _e638[1])) + ((_e653[1] * _e659[2]) - (_e653[2] * _e659[1])));
                    let _e673 = (((_e632[2] * _e638[0]) - (_e632[0] * _e638[2])) + ((_e653[2] * _e659[0]) - (_e653[0] * _e659[2])));
                    let _e674 = (((_e632[0] * _e638[1]) - (_e632[1] * _e638[0])) + ((_e653[0] * _e659[1]) - (_e653[1] * _e659[0])));
                    let _e677 = local_2.member[0u];
                    let _e688 = local_2.member[1u];
                    let _e699 = local_2.member[0u];
                    let _e708 = ((((_e688[0] * _e602) + (_e688[1] * _e605)) + (_e688[2] * _e608)) + (((_e699[0] * _e672) + (_e699[1] * _e673)) + (_e699[2] * _e674)));
                    let _e711 = local_2.member[0u];
                    let _e722 = local_2.member[1u];
                    let _e731 = ((((_e711[0] * _e623) + (_e711[1] * _e626)) + (_e711[2] * _e629)) + (((_e722[0] * _e672) + (_e722[1] * _e673)) + (_e722[2] * _e674)));
                    let _e734 = local_2.member[1u];
                    let _e745 = local_2.member[0u];
                    if (_e745[0] < 0f) {
                        phi_1610_ = -(_e745[0]);
                    } else {
                        phi_1610_ = _e745[0];
                    }
                    let _e752 = phi_1610_;
                    if (_e745[1] < 0f) {
                        phi_1617_ = -(_e745[1]);
                    } else {
                        phi_1617_ = _e745[1];
                    }
                    let _e756 = phi_1617_;
                    if (_e752 > _e756) {
                        phi_1622_ = _e752;
                    } else {
                        phi_1622_ = _e756;
                    }
                    let _e759 = phi_1622_;
                    if (_e745[2] < 0f) {
                        phi_1629_ = -(_e745[2]);
                    } else {
                        phi_1629_ = _e745[2];
                    }
                    let _e763 = phi_1629_;
                    if (_e759 > _e763) {
                        phi_1634_ = _e759;
                    } else {
                        phi_1634_ = _e763;
                    }
                    let _e766 = phi_1634_;
                    let _e769 = local_2.member[1u];
                    if (_e769[0] < 0f) {
                        phi_1647_ = -(_e769[0]);
                    } else {
                        phi_1647_ = _e769[0];
                    }
                    let _e776 = phi_1647_;
                    if (_e769[1] < 0f) {
                        phi_1654_ = -(_e769[1]);
                    } else {
                        phi_1654_ = _e769[1];
                    }
                    let _e780 = phi_1654_;
                    if (_e776 > _e780) {
                        phi_1659_ = _e776;
                    } else {
                        phi_1659_ = _e780;
                    }
                    let _e783 = phi_1659_;
                    if (_e769[2] < 0f) {
                        phi_1666_ = -(_e769[2]);
                    } else {
                        phi_1666_ = _e769[2];
                    }
                    let _e787 = phi_1666_;
                    if (_e783 > _e787) {
                        phi_1671_ = _e783;
                    } else {
                        phi_1671_ = _e787;
                    }
                    let _e790 = phi_1671_;
                    if (_e766 > _e790) {
                        phi_1676_ = _e766;
                    } else {
                        phi_1676_ = _e790;
                    }
                    let _e793 = phi_1676_;
                    let _e795 = local_2.member_3;
                    let _e796 = (_e793 + _e795);
                    let _e799 = local_2.member_1[0u];
                    if (_e799[0] < 0f) {
                        phi_1693_ = -(_e799[0]);
                    } else {
                        phi_1693_ = _e799[0];
                    }
                    let _e806 = phi_1693_;
                    if (_e799[1] < 0f) {
                        phi_1700_ = -(_e799[1]);
                    } else {
                        phi_1700_ = _e799[1];
                    }
                    let _e810 = phi_1700_;
                    if (_e806 > _e810) {
                        phi_1705_ = _e806;
                    } else {
                        phi_1705_ = _e810;
                    }
                    let _e813 = phi_1705_;
                    if (_e799[2] < 0f) {
                        phi_1712_ = -(_e799[2]);
                    } else {
                        phi_1712_ = _e799[2];
                    }
                    let _e817 = phi_1712_;
                    if (_e813 > _e817) {
                        phi_1717_ = _e813;
                    } else {
                        phi_1717_ = _e817;
                    }
                    let _e820 = phi_1717_;
                    let _e823 = local_2.member_1[1u];
                    if (_e823[0] < 0f) {
                        phi_1731_ = -(_e823[0]);
                    } else {
                        phi_1731_ = _e823[0];
                    }
                    let _e830 = phi_1731_;
                    if (_e823[1] < 0f) {
                        phi_1738_ = -(_e823[1]);
                    } else {
                        phi_1738_ = _e823[1];
                    }
                    let _e834 = phi_1738_;
                    if (_e830 > _e834) {
                        phi_1743_ = _e830;
                    } else {
                        phi_1743_ = _e834;
                    }
                    let _e837 = phi_1743_;
                    if (_e823[2] < 0f) {
                        phi_1750_ = -(_e823[2]);
                    } else {
                        phi_1750_ = _e823[2];
                    }
                    let _e841 = phi_1750_;
                    if (_e837 > _e841) {
                        phi_1755_ = _e837;
                    } else {
                        phi_1755_ = _e841;
                    }
                    let _e844 = phi_1755_;
                    if (_e820 > _e844) {
                        phi_1760_ = _e820;
                    } else {
                        phi_1760_ = _e844;
                    }
                    let _e847 = phi_1760_;
                    let _e849 = local_2.member_3;
                    let _e850 = (_e847 + _e849);
                    let _e853 = local_2.member_2[0u];
                    if (_e853[0] < 0f) {
                        phi_1777_ = -(_e853[0]);
                    } else {
                        phi_1777_ = _e853[0];
                    }
                    let _e860 = phi_1777_;
                    if (_e853[1] < 0f) {
                        phi_1784_ = -(_e853[1]);
                    } else {
                        phi_1784_ = _e853[1];
                    }
                    let _e864 = phi_1784_;
                    if (_e860 > _e864) {
                        phi_1789_ = _e860;
                    } else {
                        phi_1789_ = _e864;
                    }
                    let _e867 = phi_1789_;
                    if (_e853[2] < 0f) {
                        phi_1796_ = -(_e853[2]);
                    } else {
                        phi_1796_ = _e853[2];
                    }
                    let _e871 = phi_1796_;
                    if (_e867 > _e871) {
                        phi_1801_ = _e867;
                    } else {
                        phi_1801_ = _e871;
                    }
                    let _e874 = phi_1801_;
                    let _e877 = local_2.member_2[1u];
                    if (_e877[0] < 0f) {
                        phi_1815_ = -(_e877[0]);
                    } else {
                        phi_1815_ = _e877[0];
                    }
                    let _e884 = phi_1815_;
                    if (_e877[1] < 0f) {
                        phi_1822_ = -(_e877[1]);
                    } else {
                        phi_1822_ = _e877[1];
                    }
                    let _e888 = phi_1822_;
                    if (_e884 > _e888) {
                        phi_1827_ = _e884;
                    } else {
                        phi_1827_ = _e888;
                    }
                    let _e891 = phi_1827_;
                    if (_e877[2] < 0f) {
                        phi_1834_ = -(_e877[2]);
                    } else {
                        phi_1834_ = _e877[2];
                    }
                    let _e895 = phi_1834_;
                    if (_e891 > _e895) {
                        phi_1839_ = _e891;
                    } else {
                        phi_1839_ = _e895;
                    }
                    let _e898 = phi_1839_;
                    if (_e874 > _e898) {
                        phi_1844_ = _e874;
                    } else {
                        phi_1844_ = _e898;
                    }
                    let _e901 = phi_1844_;
                    let _e903 = local_2.member_3;
                    let _e904 = (_e901 + _e903);
                    let _e906 = ((_e850 * 8f) * _e904);
                    let _e913 = local_2.member_3;
                    if (_e602 < 0f) {
                        phi_1875_ = -(_e602);
                    } else {
                        phi_1875_ = _e602;
                    }
                    let _e930 = phi_1875_;
                    if (_e605 < 0f) {
                        phi_1881_ = -(_e605);
                    } else {
                        phi_1881_ = _e605;
                    }
                    let _e934 = phi_1881_;
                    if (_e608 < 0f) {
                        phi_1888_ = -(_e608);
                    } else {
                        phi_1888_ = _e608;
                    }
                    let _e939 = phi_1888_;
                    let _e940 = ((_e930 + _e934) + _e939);
                    if (_e623 < 0f) {
                        phi_1895_ = -(_e623);
                    } else {
                        phi_1895_ = _e623;
                    }
                    let _e944 = phi_1895_;
                    if (_e626 < 0f) {
                        phi_1901_ = -(_e626);
                    } else {
                        phi_1901_ = _e626;
                    }
                    let _e948 = phi_1901_;
                    if (_e629 < 0f) {
                        phi_1908_ = -(_e629);
                    } else {
                        phi_1908_ = _e629;
                    }
                    let _e953 = phi_1908_;
                    let _e954 = ((_e944 + _e948) + _e953);
                    if (_e940 > _e954) {
                        phi_1914_ = _e940;
                    } else {
                        phi_1914_ = _e954;
                    }
                    let _e957 = phi_1914_;
                    if (_e672 < 0f) {
                        phi_1920_ = -(_e672);
                    } else {
                        phi_1920_ = _e672;
                    }
                    let _e961 = phi_1920_;
                    if (_e673 < 0f) {
                        phi_1926_ = -(_e673);
                    } else {
                        phi_1926_ = _e673;
                    }
                    let _e965 = phi_1926_;
                    if (_e674 < 0f) {
                        phi_1933_ = -(_e674);
                    } else {
                        phi_1933_ = _e674;
                    }
                    let _e970 = phi_1933_;
                    let _e972 = (((_e961 + _e965) + _e970) * 0.5f);
                    if (_e957 > _e972) {
                        phi_1940_ = _e957;
                    } else {
                        phi_1940_ = _e972;
                    }
                    let _e975 = phi_1940_;
                    let _e980 = local_2.member_3;
                    let _e993 = ((((_e677[0] * _e602) + (_e677[1] * _e605)) + (_e677[2] * _e608)) * 3f);
                    let _e994 = ((((_e734[0] * _e623) + (_e734[1] * _e626)) + (_e734[2] * _e629)) * 3f);
                    if (_e993 < _e994) {
                        phi_1964_ = _e993;
                    } else {
                        phi_1964_ = _e994;
                    }
                    let _e997 = phi_1964_;
                    if (_e708 < _e731) {
                        phi_1969_ = _e708;
                    } else {
                        phi_1969_ = _e731;
                    }
                    let _e1000 = phi_1969_;
                    if (_e997 < _e1000) {
                        phi_1974_ = _e997;
                    } else {
                        phi_1974_ = _e1000;
                    }
                    let _e1003 = phi_1974_;
                    if (_e993 > _e994) {
                        phi_1979_ = _e993;
                    } else {
                        phi_1979_ = _e994;
                    }
                    let _e1006 = phi_1979_;
                    if (_e708 > _e731) {
                        phi_1984_ = _e708;
                    } else {
                        phi_1984_ = _e731;
                    }
                    let _e1009 = phi_1984_;
                    if (_e1006 > _e1009) {
                        phi_1989_ = _e1006;
                    } else {
                        phi_1989_ = _e1009;
                    }
                    let _e1012 = phi_1989_;
                    let _e1017 = -(_e1012);
                    if (_e1003 > _e1017) {
                        phi_1999_ = _e1003;
                    } else {
                        phi_1999_ = _e1017;
                    }
                    let _e1020 = phi_1999_;
                    let _e1022 = ((_e1020 - ((((((_e796 * 8f) * _e906) * (0.000000059604645f * (524f / 64f))) + ((_e913 * 19f) * ((_e796 * (_e850 + _e904)) + (_e850 * _e904)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e796) * ((1f + _e850) * (1f + _e904))))) + ((_e515 * (((_e975 + (_e906 * (0.000000059604645f * 8f))) + ((_e980 * 6f) * (_e850 + _e904))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e850) * (1f + _e904))))) * (3f * 1.0001f)))) > 0f);
                    if _e1022 {
                        phi_2968_ = _e1022;
                    } else {
                        let _e1025 = local_2.member_1[0u];
                        let _e1031 = local_2.member_1[1u];
                        let _e1035 = (_e1025[0] + _e1031[0]);
                        let _e1036 = (_e1025[1] + _e1031[1]);
                        let _e1037 = (_e1025[2] + _e1031[2]);
                        let _e1040 = local_2.member_2[0u];
                        let _e1046 = local_2.member_2[1u];
                        let _e1050 = (_e1040[0] + _e1046[0]);
                        let _e1051 = (_e1040[1] + _e1046[1]);
                        let _e1052 = (_e1040[2] + _e1046[2]);
                        let _e1055 = ((_e1036 * _e1052) - (_e1037 * _e1051));
                        let _e1058 = ((_e1037 * _e1050) - (_e1035 * _e1052));
                        let _e1061 = ((_e1035 * _e1051) - (_e1036 * _e1050));
                        let _e1064 = local_2.member[0u];
                        let _e1070 = local_2.member_1[0u];
                        let _e1076 = local_2.member_2[0u];
                        let _e1080 = (_e1064[0] - _e1070[0]);
                        let _e1081 = (_e1064[1] - _e1070[1]);
                        let _e1082 = (_e1064[2] - _e1070[2]);
                        let _e1083 = (_e1064[0] - _e1076[0]);
                        let _e1084 = (_e1064[1] - _e1076[1]);
                        let _e1085 = (_e1064[2] - _e1076[2]);
                        let _e1088 = local_2.member[1u];
                        let _e1094 = local_2.member_1[1u];
                        let _e1100 = local_2.member_2[1u];
                        let _e1104 = (_e1088[0] - _e1094[0]);
                        let _e1105 = (_e1088[1] - _e1094[1]);
                        let _e1106 = (_e1088[2] - _e1094[2]);
                        let _e1107 = (_e1088[0] - _e1100[0]);
                        let _e1108 = (_e1088[1] - _e1100[1]);
                        let _e1109 = (_e1088[2] - _e1100[2]);
                        let _e1112 = local_2.member[0u];
                        if (_e1112[0] < 0f) {
                            phi_2202_ = -(_e1112[0]);
                        } else {
                            phi_2202_ = _e1112[0];
                        }
                        let _e1119 = phi_2202_;
                        if (_e1112[1] < 0f) {
                            phi_2209_ = -(_e1112[1]);
                        } else {
                            phi_2209_ = _e1112[1];
                        }
                        let _e1123 = phi_2209_;
                        if (_e1119 > _e1123) {
                            phi_2214_ = _e1119;
                        } else {
                            phi_2214_ = _e1123;
                        }
                        let _e1126 = phi_2214_;
                        if (_e1112[2] < 0f) {
                            phi_2221_ = -(_e1112[2]);
                        } else {
                            phi_2221_ = _e1112[2];
                        }
                        let _e1130 = phi_2221_;
                        if (_e1126 > _e1130) {
                            phi_2226_ = _e1126;
                        } else {
                            phi_2226_ = _e1130;
                        }
                        let _e1133 = phi_2226_;
                        let _e1136 = local_2.member[1u];
                        if (_e1136[0] < 0f) {
                            phi_2239_ = -(_e1136[0]);
                        } else {
                            phi_2239_ = _e1136[0];
                        }
                        let _e1143 = phi_2239_;
                        if (_e1136[1] < 0f) {
                            phi_2246_ = -(_e1136[1]);
                        } else {
                            phi_2246_ = _e1136[1];
                        }
                        let _e1147 = phi_2246_;
                        if (_e1143 > _e1147) {
                            phi_2251_ = _e1143;
                        } else {
                            phi_2251_ = _e1147;
                        }
                        let _e1150 = phi_2251_;
                        if (_e1136[2] < 0f) {
                            phi_2258_ = -(_e1136[2]);
                        } else {
                            phi_2258_ = _e1136[2];
                        }
                        let _e1154 = phi_2258_;
                        if (_e1150 > _e1154) {
                            phi_2263_ = _e1150;
                        } else {
                            phi_2263_ = _e1154;
                        }
                        let _e1157 = phi_2263_;
                        if (_e1133 > _e1157) {
                            phi_2268_ = _e1133;
                        } else {
                            phi_2268_ = _e1157;
                        }
                        let _e1160 = phi_2268_;
                        let _e1162 = local_2.member_3;
                        let _e1166 = local_2.member_1[0u];
                        if (_e1166[0] < 0f) {
                            phi_2285_ = -(_e1166[0]);
                        } else {
                            phi_2285_ = _e1166[0];
                        }
                        let _e1173 = phi_2285_;
                        if (_e1166[1] < 0f) {
                            phi_2292_ = -(_e1166[1]);
                        } else {
                            phi_2292_ = _e1166[1];
                        }
                        let _e1177 = phi_2292_;
                        if (_e1173 > _e1177) {
                            phi_2297_ = _e1173;
                        } else {
                            phi_2297_ = _e1177;
                        }
                        let _e1180 = phi_2297_;
                        if (_e1166[2] < 0f) {
                            phi_2304_ = -(_e1166[2]);
                        } else {
                            phi_2304_ = _e1166[2];
                        }
                        let _e1184 = phi_2304_;
                        if (_e1180 > _e1184) {
                            phi_2309_ = _e1180;
                        } else {
                            phi_2309_ = _e1184;
                        }
                        let _e1187 = phi_2309_;
                        let _e1190 = local_2.member_1[1u];
                        if (_e1190[0] < 0f) {
                            phi_2323_ = -(_e1190[0]);
                        } else {
                            phi_2323_ = _e1190[0];
                        }
                        let _e1197 = phi_2323_;
                        if (_e1190[1] < 0f) {
                            phi_2330_ = -(_e1190[1]);
                        } else {
                            phi_2330_ = _e1190[1];
                        }
                        let _e1201 = phi_2330_;
                        if (_e1197 > _e1201) {
                            phi_2335_ = _e1197;
                        } else {
                            phi_2335_ = _e1201;
                        }
                        let _e1204 = phi_2335_;
                        if (_e1190[2] < 0f) {
                            phi_2342_ = -(_e1190[2]);
                        } else {
                            phi_2342_ = _e1190[2];
                        }
                        let _e1208 = phi_2342_;
                        if (_e1204 > _e1208) {
                            phi_2347_ = _e1204;
                        } else {
                            phi_2347_ = _e1208;
                        }
                        let _e1211 = phi_2347_;
                        if (_e1187 > _e1211) {
                            phi_2352_ = _e1187;
                        } else {
                            phi_2352_ = _e1211;
                        }
                        let _e1214 = phi_2352_;
                        let _e1216 = local_2.member_3;
                        let _e1220 = local_2.member_2[0u];
                        if (_e1220[0] < 0f) {
                            phi_2369_ = -(_e1220[0]);
                        } else {
                            phi_2369_ = _e1220[0];
                        }
                        let _e1227 = phi_2369_;
                        if (_e1220[1] < 0f) {
                            phi_2376_ = -(_e1220[1]);
                        } else {
                            phi_2376_ = _e1220[1];
                        }
                        let _e1231 = phi_2376_;
                        if (_e1227 > _e1231) {
                            phi_2381_ = _e1227;
                        } else {
                            phi_2381_ = _e1231;
                        }
                        let _e1234 = phi_2381_;
                        if (_e1220[2] < 0f) {
                            phi_2388_ = -(_e1220[2]);
                        } else {
                            phi_2388_ = _e1220[2];
                        }
                        let _e1238 = phi_2388_;
                        if (_e1234 > _e1238) {
                            phi_2393_ = _e1234;
                        } else {
                            phi_2393_ = _e1238;
                        }
                        let _e1241 = phi_2393_;
                        let _e1244 = local_2.member_2[1u];
                        if (_e1244[0] < 0f) {
                            phi_2407_ = -(_e1244[0]);
                        } else {
                            phi_2407_ = _e1244[0];
                        }
                        let _e1251 = phi_2407_;
                        if (_e1244[1] < 0f) {
                            phi_2414_ = -(_e1244[1]);
                        } else {
                            phi_2414_ = _e1244[1];
                        }
                        let _e1255 = phi_2414_;
                        if (_e1251 > _e1255) {
                            phi_2419_ = _e1251;
                        } else {
                            phi_2419_ = _e1255;
                        }
                        let _e1258 = phi_2419_;
                        if (_e1244[2] < 0f) {
                            phi_2426_ = -(_e1244[2]);
                        } else {
                            phi_2426_ = _e1244[2];
                        }
                        let _e1262 = phi_2426_;
                        if (_e1258 > _e1262) {
                            phi_2431_ = _e1258;
                        } else {
                            phi_2431_ = _e1262;
                        }
                        let _e1265 = phi_2431_;
                        if (_e1241 > _e1265) {
                            phi_2436_ = _e1241;
                        } else {
                            phi_2436_ = _e1265;
                        }
                        let _e1268 = phi_2436_;
                        let _e1270 = local_2.member_3;
                        let _e1274 = ((((_e1160 + _e1162) + (_e1214 + _e1216)) + (_e1268 + _e1270)) * 2f);
                        let _e1277 = local_2.member_3;
                        let _e1281 = (((_e515 * 1.0001f) + (_e1277 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                        let _e1284 = ((_e1058 * _e1037) - (_e1061 * _e1036));
                        let _e1287 = ((_e1061 * _e1035) - (_e1055 * _e1037));
                        let _e1290 = ((_e1055 * _e1036) - (_e1058 * _e1035));
                        let _e1295 = (((_e1284 * _e1064[0]) + (_e1287 * _e1064[1])) + (_e1290 * _e1064[2]));
                        let _e1300 = (((_e1284 * _e1080) + (_e1287 * _e1081)) + (_e1290 * _e1082));
                        let _e1305 = (((_e1284 * _e1083) + (_e1287 * _e1084)) + (_e1290 * _e1085));
                        let _e1310 = (((_e1284 * _e1064[0]) + (_e1287 * _e1064[1])) + (_e1290 * _e1064[2]));
                        let _e1315 = (((_e1284 * _e1088[0]) + (_e1287 * _e1088[1])) + (_e1290 * _e1088[2]));
                        let _e1320 = (((_e1284 * _e1104) + (_e1287 * _e1105)) + (_e1290 * _e1106));
                        let _e1325 = (((_e1284 * _e1107) + (_e1287 * _e1108)) + (_e1290 * _e1109));
                        let _e1330 = (((_e1284 * _e1088[0]) + (_e1287 * _e1088[1])) + (_e1290 * _e1088[2]));
                        if (_e1295 < _e1300) {
                            phi_2515_ = _e1295;
                        } else {
                            phi_2515_ = _e1300;
                        }
                        let _e1333 = phi_2515_;
                        if (_e1305 < _e1310) {
                            phi_2520_ = _e1305;
                        } else {
                            phi_2520_ = _e1310;
                        }
                        let _e1336 = phi_2520_;
                        if (_e1333 < _e1336) {
                            phi_2525_ = _e1333;
                        } else {
                            phi_2525_ = _e1336;
                        }
                        let _e1339 = phi_2525_;
                        if (_e1315 < _e1320) {
                            phi_2530_ = _e1315;
                        } else {
                            phi_2530_ = _e1320;
                        }
                        let _e1342 = phi_2530_;
                        if (_e1325 < _e1330) {
                            phi_2535_ = _e1325;
                        } else {
                            phi_2535_ = _e1330;
                        }
                        let _e1345 = phi_2535_;
                        if (_e1342 < _e1345) {
                            phi_2540_ = _e1342;
                        } else {
                            phi_2540_ = _e1345;
                        }
                        let _e1348 = phi_2540_;
                        if (_e1339 < _e1348) {
                            phi_2545_ = _e1339;
                        } else {
                            phi_2545_ = _e1348;
                        }
                        let _e1351 = phi_2545_;
                        if (_e1295 > _e1300) {
                            phi_2550_ = _e1295;
                        } else {
                            phi_2550_ = _e1300;
                        }
                        let _e1354 = phi_2550_;
                        if (_e1305 > _e1310) {
                            phi_2555_ = _e1305;
                        } else {
                            phi_2555_ = _e1310;
                        }
                        let _e1357 = phi_2555_;
                        if (_e1354 > _e1357) {
                            phi_2560_ = _e1354;
                        } else {
                            phi_2560_ = _e1357;
                        }
                        let _e1360 = phi_2560_;
                        if (_e1315 > _e1320) {
                            phi_2565_ = _e1315;
                        } else {
                            phi_2565_ = _e1320;
                        }
                        let _e1363 = phi_2565_;
                        if (_e1325 > _e1330) {
                            phi_2570_ = _e1325;
                        } else {
                            phi_2570_ = _e1330;
                        }
                        let _e1366 = phi_2570_;
                        if (_e1363 > _e1366) {
                            phi_2575_ = _e1363;
                        } else {
                            phi_2575_ = _e1366;
                        }
                        let _e1369 = phi_2575_;
                        if (_e1360 > _e1369) {
                            phi_2580_ = _e1360;
                        } else {
                            phi_2580_ = _e1369;
                        }
                        let _e1372 = phi_2580_;
                        if (_e1284 < 0f) {
                            phi_2586_ = -(_e1284);
                        } else {
                            phi_2586_ = _e1284;
                        }
                        let _e1376 = phi_2586_;
                        if (_e1287 < 0f) {
                            phi_2592_ = -(_e1287);
                        } else {
                            phi_2592_ = _e1287;
                        }
                        let _e1380 = phi_2592_;
                        if (_e1290 < 0f) {
                            phi_2599_ = -(_e1290);
                        } else {
                            phi_2599_ = _e1290;
                        }
                        let _e1385 = phi_2599_;
                        let _e1386 = ((_e1376 + _e1380) + _e1385);
                        let _e1391 = -(_e1372);
                        if (_e1351 > _e1391) {
                            phi_2610_ = _e1351;
                        } else {
                            phi_2610_ = _e1391;
                        }
                        let _e1394 = phi_2610_;
                        let _e1399 = (((_e1394 - ((_e1386 * _e1274) * (0.000000059604645f * (17f / 2f)))) - (_e1386 * _e1281)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        let _e1402 = ((_e1058 * _e1052) - (_e1061 * _e1051));
                        let _e1405 = ((_e1061 * _e1050) - (_e1055 * _e1052));
                        let _e1408 = ((_e1055 * _e1051) - (_e1058 * _e1050));
                        let _e1413 = (((_e1402 * _e1064[0]) + (_e1405 * _e1064[1])) + (_e1408 * _e1064[2]));
                        let _e1418 = (((_e1402 * _e1080) + (_e1405 * _e1081)) + (_e1408 * _e1082));
                        let _e1423 = (((_e1402 * _e1083) + (_e1405 * _e1084)) + (_e1408 * _e1085));
                        let _e1428 = (((_e1402 * _e1064[0]) + (_e1405 * _e1064[1])) + (_e1408 * _e1064[2]));
                        let _e1433 = (((_e1402 * _e1088[0]) + (_e1405 * _e1088[1])) + (_e1408 * _e1088[2]));
                        let _e1438 = (((_e1402 * _e1104) + (_e1405 * _e1105)) + (_e1408 * _e1106));
                        let _e1443 = (((_e1402 * _e1107) + (_e1405 * _e1108)) + (_e1408 * _e1109));
                        let _e1448 = (((_e1402 * _e1088[0]) + (_e1405 * _e1088[1])) + (_e1408 * _e1088[2]));
                        if (_e1413 < _e1418) {
                            phi_2681_ = _e1413;
                        } else {
                            phi_2681_ = _e1418;
                        }
                        let _e1451 = phi_2681_;
                        if (_e1423 < _e1428) {
                            phi_2686_ = _e1423;
                        } else {
                            phi_2686_ = _e1428;
                        }
                        let _e1454 = phi_2686_;
                        if (_e1451 < _e1454) {
                            phi_2691_ = _e1451;
                        } else {
                            phi_2691_ = _e1454;
                        }
                        let _e1457 = phi_2691_;
                        if (_e1433 < _e1438) {
                            phi_2696_ = _e1433;
                        } else {
                            phi_2696_ = _e1438;
                        }
                        let _e1460 = phi_2696_;
                        if (_e1443 < _e1448) {
                            phi_2701_ = _e1443;
                        } else {
                            phi_2701_ = _e1448;
                        }
                        let _e1463 = phi_2701_;
                        if (_e1460 < _e1463) {
                            phi_2706_ = _e1460;
                        } else {
                            phi_2706_ = _e1463;
                        }
                        let _e1466 = phi_2706_;
                        if (_e1457 < _e1466) {
                            phi_2711_ = _e1457;
                        } else {
                            phi_2711_ = _e1466;
                        }
                        let _e1469 = phi_2711_;
                        if (_e1413 > _e1418) {
                            phi_2716_ = _e1413;
                        } else {
                            phi_2716_ = _e1418;
                        }
                        let _e1472 = phi_2716_;
                        if (_e1423 > _e1428) {
                            phi_2721_ = _e1423;
                        } else {
                            phi_2721_ = _e1428;
                        }
                        let _e1475 = phi_2721_;
                        if (_e1472 > _e1475) {
                            phi_2726_ = _e1472;
                        } else {
                            phi_2726_ = _e1475;
                        }
                        let _e1478 = phi_2726_;
                        if (_e1433 > _e1438) {
                            phi_2731_ = _e1433;
                        } else {
                            phi_2731_ = _e1438;
                        }
                        let _e1481 = phi_2731_;
                        if (_e1443 > _e1448) {
                            phi_2736_ = _e1443;
                        } else {
                            phi_2736_ = _e1448;
                        }
                        let _e1484 = phi_2736_;
                        if (_e1481 > _e1484) {
                            phi_2741_ = _e1481;
                        } else {
                            phi_2741_ = _e1484;
                        }
                        let _e1487 = phi_2741_;
                        if (_e1478 > _e1487) {
                            phi_2746_ = _e1478;
                        } else {
                            phi_2746_ = _e1487;
                        }
                        let _e1490 = phi_2746_;
                        if (_e1402 < 0f) {
                            phi_2752_ = -(_e1402);
                        } else {
                            phi_2752_ = _e1402;
                        }
                        let _e1494 = phi_2752_;
                        if (_e1405 < 0f) {
                            phi_2758_ = -(_e1405);
                        } else {
                            phi_2758_ = _e1405;
                        }
                        let _e1498 = phi_2758_;
                        if (_e1408 < 0f) {
                            phi_2765_ = -(_e1408);
                        } else {
                            phi_2765_ = _e1408;
                        }
                        let _e1503 = phi_2765_;
                        let _e1504 = ((_e1494 + _e1498) + _e1503);
                        let _e1509 = -(_e1490);
                        if (_e1469 > _e1509) {
                            phi_2776_ = _e1469;
                        } else {
                            phi_2776_ = _e1509;
                        }
                        let _e1512 = phi_2776_;
                        let _e1517 = (((_e1512 - ((_e1504 * _e1274) * (0.000000059604645f * (17f / 2f)))) - (_e1504 * _e1281)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        if (_e1399 > _e1517) {
                            phi_2786_ = _e1399;
                        } else {
                            phi_2786_ = _e1517;
                        }
                        let _e1520 = phi_2786_;
                        let _e1521 = (_e1050 - _e1035);
                        let _e1522 = (_e1051 - _e1036);
                        let _e1523 = (_e1052 - _e1037);
                        let _e1526 = ((_e1058 * _e1523) - (_e1061 * _e1522));
                        let _e1529 = ((_e1061 * _e1521) - (_e1055 * _e1523));
                        let _e1532 = ((_e1055 * _e1522) - (_e1058 * _e1521));
                        let _e1537 = (((_e1526 * _e1064[0]) + (_e1529 * _e1064[1])) + (_e1532 * _e1064[2]));
                        let _e1542 = (((_e1526 * _e1080) + (_e1529 * _e1081)) + (_e1532 * _e1082));
                        let _e1547 = (((_e1526 * _e1083) + (_e1529 * _e1084)) + (_e1532 * _e1085));
                        let _e1552 = (((_e1526 * _e1064[0]) + (_e1529 * _e1064[1])) + (_e1532 * _e1064[2]));
                        let _e1557 = (((_e1526 * _e1088[0]) + (_e1529 * _e1088[1])) + (_e1532 * _e1088[2]));
                        let _e1562 = (((_e1526 * _e1104) + (_e1529 * _e1105)) + (_e1532 * _e1106));
                        let _e1567 = (((_e1526 * _e1107) + (_e1529 * _e1108)) + (_e1532 * _e1109));
                        let _e1572 = (((_e1526 * _e1088[0]) + (_e1529 * _e1088[1])) + (_e1532 * _e1088[2]));
                        if (_e1537 < _e1542) {
                            phi_2859_ = _e1537;
                        } else {
                            phi_2859_ = _e1542;
                        }
                        let _e1575 = phi_2859_;
                        if (_e1547 < _e1552) {
                            phi_2864_ = _e1547;
                        } else {
                            phi_2864_ = _e1552;
                        }
                        let _e1578 = phi_2864_;
                        if (_e1575 < _e1578) {
                            phi_2869_ = _e1575;
                        } else {
                            phi_2869_ = _e1578;
                        }
                        let _e1581 = phi_2869_;
                        if (_e1557 < _e1562) {
                            phi_2874_ = _e1557;
                        } else {
                            phi_2874_ = _e1562;
                        }
                        let _e1584 = phi_2874_;
                        if (_e1567 < _e1572) {
                            phi_2879_ = _e1567;
                        } else {
                            phi_2879_ = _e1572;
                        }
                        let _e1587 = phi_2879_;
                        if (_e1584 < _e1587) {
                            phi_2884_ = _e1584;
                        } else {
                            phi_2884_ = _e1587;
                        }
                        let _e1590 = phi_2884_;
                        if (_e1581 < _e1590) {
                            phi_2889_ = _e1581;
                        } else {
                            phi_2889_ = _e1590;
                        }
                        let _e1593 = phi_2889_;
                        if (_e1537 > _e1542) {
                            phi_2894_ = _e1537;
                        } else {
                            phi_2894_ = _e1542;
                        }
                        let _e1596 = phi_2894_;
                        if (_e1547 > _e1552) {
                            phi_2899_ = _e1547;
                        } else {
                            phi_2899_ = _e1552;
                        }
                        let _e1599 = phi_2899_;
                        if (_e1596 > _e1599) {
                            phi_2904_ = _e1596;
                        } else {
                            phi_2904_ = _e1599;
                        }
                        let _e1602 = phi_2904_;
                        if (_e1557 > _e1562) {
                            phi_2909_ = _e1557;
                        } else {
                            phi_2909_ = _e1562;
                        }
                        let _e1605 = phi_2909_;
                        if (_e1567 > _e1572) {
                            phi_2914_ = _e1567;
                        } else {
                            phi_2914_ = _e1572;
                        }
                        let _e1608 = phi_2914_;
                        if (_e1605 > _e1608) {
                            phi_2919_ = _e1605;
                        } else {
                            phi_2919_ = _e1608;
                        }
                        let _e1611 = phi_2919_;
                        if (_e1602 > _e1611) {
                            phi_2924_ = _e1602;
                        } else {
                            phi_2924_ = _e1611;
                        }
                        let _e1614 = phi_2924_;
                        if (_e1526 < 0f) {
                            phi_2930_ = -(_e1526);
                        } else {
                            phi_2930_ = _e1526;
                        }
                        let _e1618 = phi_2930_;
                        if (_e1529 < 0f) {
                            phi_2936_ = -(_e1529);
                        } else {
                            phi_2936_ = _e1529;
                        }
                        let _e1622 = phi_2936_;
                        if (_e1532 < 0f) {
                            phi_2943_ = -(_e1532);
                        } else {
                            phi_2943_ = _e1532;
                        }
                        let _e1627 = phi_2943_;
                        let _e1628 = ((_e1618 + _e1622) + _e1627);
                        let _e1633 = -(_e1614);
                        if (_e1593 > _e1633) {
                            phi_2954_ = _e1593;
                        } else {
                            phi_2954_ = _e1633;
                        }
                        let _e1636 = phi_2954_;
                        let _e1641 = (((_e1636 - ((_e1628 * _e1274) * (0.000000059604645f * (17f / 2f)))) - (_e1628 * _e1281)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        if (_e1520 > _e1641) {
                            phi_2964_ = _e1520;
                        } else {
                            phi_2964_ = _e1641;
                        }
                        let _e1644 = phi_2964_;
                        phi_2968_ = (_e1022 || (_e1644 > 0f));
                    }
                    let _e1648 = phi_2968_;
                    if _e1648 {
                        phi_6385_ = _e1648;
                    } else {
                        let _e1651 = local_2.member[0u];
                        let _e1657 = local_2.member[1u];
                        let _e1664 = ((_e1651[0] + _e1657[0]) * 0.5f);
                        let _e1665 = ((_e1651[1] + _e1657[1]) * 0.5f);
                        let _e1666 = ((_e1651[2] + _e1657[2]) * 0.5f);
                        let _e1669 = local_2.member_1[0u];
                        let _e1675 = local_2.member_1[1u];
                        let _e1682 = ((_e1669[0] + _e1675[0]) * 0.5f);
                        let _e1683 = ((_e1669[1] + _e1675[1]) * 0.5f);
                        let _e1684 = ((_e1669[2] + _e1675[2]) * 0.5f);
                        let _e1687 = local_2.member_2[0u];
                        let _e1693 = local_2.member_2[1u];
                        let _e1700 = ((_e1687[0] + _e1693[0]) * 0.5f);
                        let _e1701 = ((_e1687[1] + _e1693[1]) * 0.5f);
                        let _e1702 = ((_e1687[2] + _e1693[2]) * 0.5f);
                        let _e1705 = local_2.member[0u];
                        let _e1708 = local_2.member_1[0u];
                        let _e1711 = local_2.member_2[0u];
                        let _e1713 = local_2.member_3;
                        let _e1716 = local_2.member[1u];
                        let _e1719 = local_2.member_1[1u];
                        let _e1722 = local_2.member_2[1u];
                        let _e1724 = local_2.member_3;
                        local = type_26(array<array<f32, 3>, 2>(_e1705, array<f32, 3>(_e1664, _e1665, _e1666)), array<array<f32, 3>, 2>(_e1708, array<f32, 3>(_e1682, _e1683, _e1684)), array<array<f32, 3>, 2>(_e1711, array<f32, 3>(_e1700, _e1701, _e1702)), _e1713);
                        local_1 = type_26(array<array<f32, 3>, 2>(array<f32, 3>(_e1664, _e1665, _e1666), _e1716), array<array<f32, 3>, 2>(array<f32, 3>(_e1682, _e1683, _e1684), _e1719), array<array<f32, 3>, 2>(array<f32, 3>(_e1700, _e1701, _e1702), _e1722), _e1724);
                        let _e1741 = local.member_1[0u];
                        let _e1747 = local.member_2[0u];
                        let _e1753 = ((_e1741[1] * _e1747[2]) - (_e1741[2] * _e1747[1]));
                        let _e1756 = ((_e1741[2] * _e1747[0]) - (_e1741[0] * _e1747[2]));
                        let _e1759 = ((_e1741[0] * _e1747[1]) - (_e1741[1] * _e1747[0]));
                        let _e1762 = local.member_1[1u];
                        let _e1768 = local.member_2[1u];
                        let _e1774 = ((_e1762[1] * _e1768[2]) - (_e1762[2] * _e1768[1]));
                        let _e1777 = ((_e1762[2] * _e1768[0]) - (_e1762[0] * _e1768[2]));
                        let _e1780 = ((_e1762[0] * _e1768[1]) - (_e1762[1] * _e1768[0]));
                        let _e1783 = local.member_1[0u];
                        let _e1789 = local.member_2[1u];
                        let _e1804 = local.member_1[1u];
                        let _e1810 = local.member_2[0u];
                        let _e1823 = (((_e1783[1] * _e1789[2]) - (_e1783[2] * _e1789[1])) + ((_e1804[1] * _e1810[2]) - (_e1804[2] * _e1810[1])));
                        let _e1824 = (((_e1783[2] * _e1789[0]) - (_e1783[0] * _e1789[2])) + ((_e1804[2] * _e1810[0]) - (_e1804[0] * _e1810[2])));
                        let _e1825 = (((_e1783[0] * _e1789[1]) - (_e1783[1] * _e1789[0])) + ((_e1804[0] * _e1810[1]) - (_e1804[1] * _e1810[0])));
                        let _e1828 = local.member[0u];
                        let _e1839 = local.member[1u];
                        let _e1850 = local.member[0u];
                        let _e1859 = ((((_e1839[0] * _e1753) + (_e1839[1] * _e1756)) + (_e1839[2] * _e1759)) + (((_e1850[0] * _e1823) + (_e1850[1] * _e1824)) + (_e1850[2] * _e1825)));
                        let _e1862 = local.member[0u];
                        let _e1873 = local.member[1u];
                        let _e1882 = ((((_e1862[0] * _e1774) + (_e1862[1] * _e1777)) + (_e1862[2] * _e1780)) + (((_e1873[0] * _e1823) + (_e1873[1] * _e1824)) + (_e1873[2] * _e1825)));
                        let _e1885 = local.member[1u];
                        let _e1896 = local.member[0u];
                        if (_e1896[0] < 0f) {
                            phi_3420_ = -(_e1896[0]);
                        } else {
                            phi_3420_ = _e1896[0];
                        }
                        let _e1903 = phi_3420_;
                        if (_e1896[1] < 0f) {
                            phi_3427_ = -(_e1896[1]);
                        } else {
                            phi_3427_ = _e1896[1];
                        }
                        let _e1907 = phi_3427_;
                        if (_e1903 > _e1907) {
                            phi_3432_ = _e1903;
                        } else {
                            phi_3432_ = _e1907;
                        }
                        let _e1910 = phi_3432_;
                        if (_e1896[2] < 0f) {
                            phi_3439_ = -(_e1896[2]);
                        } else {
                            phi_3439_ = _e1896[2];
                        }
                        let _e1914 = phi_3439_;
                        if (_e1910 > _e1914) {
                            phi_3444_ = _e1910;
                        } else {
                            phi_3444_ = _e1914;
                        }
                        let _e1917 = phi_3444_;
                        let _e1920 = local.member[1u];
                        if (_e1920[0] < 0f) {
                            phi_3457_ = -(_e1920[0]);
                        } else {
                            phi_3457_ = _e1920[0];
                        }
                        let _e1927 = phi_3457_;
                        if (_e1920[1] < 0f) {
                            phi_3464_ = -(_e1920[1]);
                        } else {
                            phi_3464_ = _e1920[1];
                        }
                        let _e1931 = phi_3464_;
                        if (_e1927 > _e1931) {
                            phi_3469_ = _e1927;
                        } else {
                            phi_3469_ = _e1931;
                        }
                        let _e1934 = phi_3469_;
                        if (_e1920[2] < 0f) {
                            phi_3476_ = -(_e1920[2]);
                        } else {
                            phi_3476_ = _e1920[2];
                        }
                        let _e1938 = phi_3476_;
                        if (_e1934 > _e1938) {
                            phi_3481_ = _e1934;
                        } else {
                            phi_3481_ = _e1938;
                        }
                        let _e1941 = phi_3481_;
                        if (_e1917 > _e1941) {
                            phi_3486_ = _e1917;
                        } else {
                            phi_3486_ = _e1941;
                        }
                        let _e1944 = phi_3486_;
                        let _e1946 = local.member_3;
                        let _e1947 = (_e1944 + _e1946);
                        let _e1950 = local.member_1[0u];
                        if (_e1950[0] < 0f) {
                            phi_3503_ = -(_e1950[0]);
                        } else {
                            phi_3503_ = _e1950[0];
                        }
                        let _e1957 = phi_3503_;
                        if (_e1950[1] < 0f) {
                            phi_3510_ = -(_e1950[1]);
                        } else {
                            phi_3510_ = _e1950[1];
                        }
                        let _e1961 = phi_3510_;
                        if (_e1957 > _e1961) {
                            phi_3515_ = _e1957;
                        } else {
                            phi_3515_ = _e1961;
                        }
                        let _e1964 = phi_3515_;
                        if (_e1950[2] < 0f) {
                            phi_3522_ = -(_e1950[2]);
                        } else {
                            phi_3522_ = _e1950[2];
                        }
                        let _e1968 = phi_3522_;
                        if (_e1964 > _e1968) {
                            phi_3527_ = _e1964;
                        } else {
                            phi_3527_ = _e1968;
                        }
                        let _e1971 = phi_3527_;
                        let _e1974 = local.member_1[1u];
                        if (_e1974[0] < 0f) {
                            phi_3541_ = -(_e1974[0]);
                        } else {
                            phi_3541_ = _e1974[0];
                        }
                        let _e1981 = phi_3541_;
                        if (_e1974[1] < 0f) {
                            phi_3548_ = -(_e1974[1]);
                        } else {
                            phi_3548_ = _e1974[1];
                        }
                        let _e1985 = phi_3548_;
                        if (_e1981 > _e1985) {
                            phi_3553_ = _e1981;
                        } else {
                            phi_3553_ = _e1985;
                        }
                        let _e1988 = phi_3553_;
                        if (_e1974[2] < 0f) {
                            phi_3560_ = -(_e1974[2]);
                        } else {
                            phi_3560_ = _e1974[2];
                        }
                        let _e1992 = phi_3560_;
                        if (_e1988 > _e1992) {
                            phi_3565_ = _e1988;
                        } else {
                            phi_3565_ = _e1992;
                        }
                        let _e1995 = phi_3565_;
                        if (_e1971 > _e1995) {
                            phi_3570_ = _e1971;
                        } else {
                            phi_3570_ = _e1995;
                        }
                        let _e1998 = phi_3570_;
                        let _e2000 = local.member_3;
                        let _e2001 = (_e1998 + _e2000);
                        let _e2004 = local.member_2[0u];
                        if (_e2004[0] < 0f) {
                            phi_3587_ = -(_e2004[0]);
                        } else {
                            phi_3587_ = _e2004[0];
                        }
                        let _e2011 = phi_3587_;
                        if (_e2004[1] < 0f) {
                            phi_3594_ = -(_e2004[1]);
                        } else {
                            phi_3594_ = _e2004[1];
                        }
                        let _e2015 = phi_3594_;
                        if (_e2011 > _e2015) {
                            phi_3599_ = _e2011;
                        } else {
                            phi_3599_ = _e2015;
                        }
                        let _e2018 = phi_3599_;
                        if (_e2004[2] < 0f) {
                            phi_3606_ = -(_e2004[2]);
                        } else {
                            phi_3606_ = _e2004[2];
                        }
                        let _e2022 = phi_3606_;
                        if (_e2018 > _e2022) {
                            phi_3611_ = _e2018;
                        } else {
                            phi_3611_ = _e2022;
                        }
                        let _e2025 = phi_3611_;
                        let _e2028 = local.member_2[1u];
                        if (_e2028[0] < 0f) {
                            phi_3625_ = -(_e2028[0]);
                        } else {
                            phi_3625_ = _e2028[0];
                        }
                        let _e2035 = phi_3625_;
                        if (_e2028[1] < 0f) {
                            phi_3632_ = -(_e2028[1]);
                        } else {
                            phi_3632_ = _e2028[1];
                        }
                        let _e2039 = phi_3632_;
                        if (_e2035 > _e2039) {
                            phi_3637_ = _e2035;
                        } else {
                            phi_3637_ = _e2039;
                        }
                        let _e2042 = phi_3637_;
                        if (_e2028[2] < 0f) {
                            phi_3644_ = -(_e2028[2]);
                        } else {
                            phi_3644_ = _e2028[2];
                        }
                        let _e2046 = phi_3644_;
                        if (_e2042 > _e2046) {
                            phi_3649_ = _e2042;
                        } else {
                            phi_3649_ = _e2046;
                        }
                        let _e2049 = phi_3649_;
                        if (_e2025 > _e2049) {
                            phi_3654_ = _e2025;
                        } else {
                            phi_3654_ = _e2049;
                        }
                        let _e2052 = phi_3654_;
                        let _e2054 = local.member_3;
                        let _e2055 = (_e2052 + _e2054);
                        let _e2057 = ((_e2001 * 8f) * _e2055);
                        let _e2064 = local.member_3;
                        if (_e1753 < 0f) {
                            phi_3685_ = -(_e1753);
                        } else {
                            phi_3685_ = _e1753;
                        }
                        let _e2081 = phi_3685_;
                        if (_e1756 < 0f) {
                            phi_3691_ = -(_e1756);
                        } else {
                            phi_3691_ = _e1756;
                        }
                        let _e2085 = phi_3691_;
                        if (_e1759 < 0f) {
                            phi_3698_ = -(_e1759);
                        } else {
                            phi_3698_ = _e1759;
                        }
                        let _e2090 = phi_3698_;
                        let _e2091 = ((_e2081 + _e2085) + _e2090);
                        if (_e1774 < 0f) {
                            phi_3705_ = -(_e1774);
                        } else {
                            phi_3705_ = _e1774;
                        }
                        let _e2095 = phi_3705_;
                        if (_e1777 < 0f) {
                            phi_3711_ = -(_e1777);
                        } else {
                            phi_3711_ = _e1777;
                        }
                        let _e2099 = phi_3711_;
                        if (_e1780 < 0f) {
                            phi_3718_ = -(_e1780);
                        } else {
                            phi_3718_ = _e1780;
                        }
                        let _e2104 = phi_3718_;
                        let _e2105 = ((_e2095 + _e2099) + _e2104);
                        if (_e2091 > _e2105) {
                            phi_3724_ = _e2091;
                        } else {
                            phi_3724_ = _e2105;
                        }
                        let _e2108 = phi_3724_;
                        if (_e1823 < 0f) {
                            phi_3730_ = -(_e1823);
                        } else {
                            phi_3730_ = _e1823;
                        }
                        let _e2112 = phi_3730_;
                        if (_e1824 < 0f) {
                            phi_3736_ = -(_e1824);
                        } else {
                            phi_3736_ = _e1824;
                        }
                        let _e2116 = phi_3736_;
                        if (_e1825 < 0f) {
                            phi_3743_ = -(_e1825);
                        } else {
                            phi_3743_ = _e1825;
                        }
                        let _e2121 = phi_3743_;
                        let _e2123 = (((_e2112 + _e2116) + _e2121) * 0.5f);
                        if (_e2108 > _e2123) {
                            phi_3750_ = _e2108;
                        } else {
                            phi_3750_ = _e2123;
                        }
                        let _e2126 = phi_3750_;
                        let _e2131 = local.member_3;
                        let _e2144 = ((((_e1828[0] * _e1753) + (_e1828[1] * _e1756)) + (_e1828[2] * _e1759)) * 3f);
                        let _e2145 = ((((_e1885[0] * _e1774) + (_e1885[1] * _e1777)) + (_e1885[2] * _e1780)) * 3f);
                        if (_e2144 < _e2145) {
                            phi_3774_ = _e2144;
                        } else {
                            phi_3774_ = _e2145;
                        }
                        let _e2148 = phi_3774_;
                        if (_e1859 < _e1882) {
                            phi_3779_ = _e1859;
                        } else {
                            phi_3779_ = _e1882;
                        }
                        let _e2151 = phi_3779_;
                        if (_e2148 < _e2151) {
                            phi_3784_ = _e2148;
                        } else {
                            phi_3784_ = _e2151;
                        }
                        let _e2154 = phi_3784_;
                        if (_e2144 > _e2145) {
                            phi_3789_ = _e2144;
                        } else {
                            phi_3789_ = _e2145;
                        }
                        let _e2157 = phi_3789_;
                        if (_e1859 > _e1882) {
                            phi_3794_ = _e1859;
                        } else {
                            phi_3794_ = _e1882;
                        }
                        let _e2160 = phi_3794_;
                        if (_e2157 > _e2160) {
                            phi_3799_ = _e2157;
                        } else {
                            phi_3799_ = _e2160;
                        }
                        let _e2163 = phi_3799_;
                        let _e2168 = -(_e2163);
                        if (_e2154 > _e2168) {
                            phi_3809_ = _e2154;
                        } else {
                            phi_3809_ = _e2168;
                        }
                        let _e2171 = phi_3809_;
                        let _e2173 = ((_e2171 - ((((((_e1947 * 8f) * _e2057) * (0.000000059604645f * (524f / 64f))) + ((_e2064 * 19f) * ((_e1947 * (_e2001 + _e2055)) + (_e2001 * _e2055)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1947) * ((1f + _e2001) * (1f + _e2055))))) + ((_e515 * (((_e2126 + (_e2057 * (0.000000059604645f * 8f))) + ((_e2131 * 6f) * (_e2001 + _e2055))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2001) * (1f + _e2055))))) * (3f * 1.0001f)))) > 0f);
                        if _e2173 {
                            phi_4778_ = _e2173;
                        } else {
                            let _e2176 = local.member_1[0u];
                            let _e2182 = local.member_1[1u];
                            let _e2186 = (_e2176[0] + _e2182[0]);
                            let _e2187 = (_e2176[1] + _e2182[1]);
                            let _e2188 = (_e2176[2] + _e2182[2]);
                            let _e2191 = local.member_2[0u];
                            let _e2197 = local.member_2[1u];
                            let _e2201 = (_e2191[0] + _e2197[0]);
                            let _e2202 = (_e2191[1] + _e2197[1]);
                            let _e2203 = (_e2191[2] + _e2197[2]);
                            let _e2206 = ((_e2187 * _e2203) - (_e2188 * _e2202));
                            let _e2209 = ((_e2188 * _e2201) - (_e2186 * _e2203));
                            let _e2212 = ((_e2186 * _e2202) - (_e2187 * _e2201));
                            let _e2215 = local.member[0u];
                            let _e2221 = local.member_1[0u];
                            let _e2227 = local.member_2[0u];
                            let _e2231 = (_e2215[0] - _e2221[0]);
                            let _e2232 = (_e2215[1] - _e2221[1]);
                            let _e2233 = (_e2215[2] - _e2221[2]);
                            let _e2234 = (_e2215[0] - _e2227[0]);
                            let _e2235 = (_e2215[1] - _e2227[1]);
                            let _e2236 = (_e2215[2] - _e2227[2]);
                            let _e2239 = local.member[1u];
                            let _e2245 = local.member_1[1u];
                            let _e2251 = local.member_2[1u];
                            let _e2255 = (_e2239[0] - _e2245[0]);
                            let _e2256 = (_e2239[1] - _e2245[1]);
                            let _e2257 = (_e2239[2] - _e2245[2]);
                            let _e2258 = (_e2239[0] - _e2251[0]);
                            let _e2259 = (_e2239[1] - _e2251[1]);
                            let _e2260 = (_e2239[2] - _e2251[2]);
                            let _e2263 = local.member[0u];
                            if (_e2263[0] < 0f) {
                                phi_4012_ = -(_e2263[0]);
                            } else {
                                phi_4012_ = _e2263[0];
                            }
                            let _e2270 = phi_4012_;
                            if (_e2263[1] < 0f) {
                                phi_4019_ = -(_e2263[1]);
                            } else {
                                phi_4019_ = _e2263[1];
                            }
                            let _e2274 = phi_4019_;
                            if (_e2270 > _e2274) {
                                phi_4024_ = _e2270;
                            } else {
                                phi_4024_ = _e2274;
                            }
                            let _e2277 = phi_4024_;
                            if (_e2263[2] < 0f) {
                                phi_4031_ = -(_e2263[2]);
                            } else {
                                phi_4031_ = _e2263[2];
                            }
                            let _e2281 = phi_4031_;
                            if (_e2277 > _e2281) {
                                phi_4036_ = _e2277;
                            } else {
                                phi_4036_ = _e2281;
                            }
                            let _e2284 = phi_4036_;
                            let _e2287 = local.member[1u];
                            if (_e2287[0] < 0f) {
                                phi_4049_ = -(_e2287[0]);
                            } else {
                                phi_4049_ = _e2287[0];
                            }
                            let _e2294 = phi_4049_;
                            if (_e2287[1] < 0f) {
                                phi_4056_ = -(_e2287[1]);
                            } else {
                                phi_4056_ = _e2287[1];
                            }
                            let _e2298 = phi_4056_;
                            if (_e2294 > _e2298) {
                                phi_4061_ = _e2294;
                            } else {
                                phi_4061_ = _e2298;
                            }
                            let _e2301 = phi_4061_;
                            if (_e2287[2] < 0f) {
                                phi_4068_ = -(_e2287[2]);
                            } else {
                                phi_4068_ = _e2287[2];
                            }
                            let _e2305 = phi_4068_;
                            if (_e2301 > _e2305) {
                                phi_4073_ = _e2301;
                            } else {
                                phi_4073_ = _e2305;
                            }
                            let _e2308 = phi_4073_;
                            if (_e2284 > _e2308) {
                                phi_4078_ = _e2284;
                            } else {
                                phi_4078_ = _e2308;
                            }
                            let _e2311 = phi_4078_;
                            let _e2313 = local.member_3;
                            let _e2317 = local.member_1[0u];
                            if (_e2317[0] < 0f) {
                                phi_4095_ = -(_e2317[0]);
                            } else {
                                phi_4095_ = _e2317[0];
                            }
                            let _e2324 = phi_4095_;
                            if (_e2317[1] < 0f) {
                                phi_4102_ = -(_e2317[1]);
                            } else {
                                phi_4102_ = _e2317[1];
                            }
                            let _e2328 = phi_4102_;
                            if (_e2324 > _e2328) {
                                phi_4107_ = _e2324;
                            } else {
                                phi_4107_ = _e2328;
                            }
                            let _e2331 = phi_4107_;
                            if (_e2317[2] < 0f) {
                                phi_4114_ = -(_e2317[2]);
                            } else {
                                phi_4114_ = _e2317[2];
                            }
                            let _e2335 = phi_4114_;
                            if (_e2331 > _e2335) {
                                phi_4119_ = _e2331;
                            } else {
                                phi_4119_ = _e2335;
                            }
                            let _e2338 = phi_4119_;
                            let _e2341 = local.member_1[1u];
                            if (_e2341[0] < 0f) {
                                phi_4133_ = -(_e2341[0]);
                            } else {
                                phi_4133_ = _e2341[0];
                            }
                            let _e2348 = phi_4133_;
                            if (_e2341[1] < 0f) {
                                phi_4140_ = -(_e2341[1]);
                            } else {
                                phi_4140_ = _e2341[1];
                            }
                            let _e2352 = phi_4140_;
                            if (_e2348 > _e2352) {
                                phi_4145_ = _e2348;
                            } else {
                                phi_4145_ = _e2352;
                            }
                            let _e2355 = phi_4145_;
                            if (_e2341[2] < 0f) {
                                phi_4152_ = -(_e2341[2]);
                            } else {
                                phi_4152_ = _e2341[2];
                            }
                            let _e2359 = phi_4152_;
                            if (_e2355 > _e2359) {
                                phi_4157_ = _e2355;
                            } else {
                                phi_4157_ = _e2359;
                            }
                            let _e2362 = phi_4157_;
                            if (_e2338 > _e2362) {
                                phi_4162_ = _e2338;
                            } else {
                                phi_4162_ = _e2362;
                            }
                            let _e2365 = phi_4162_;
                            let _e2367 = local.member_3;
                            let _e2371 = local.member_2[0u];
                            if (_e2371[0] < 0f) {
                                phi_4179_ = -(_e2371[0]);
                            } else {
                                phi_4179_ = _e2371[0];
                            }
                            let _e2378 = phi_4179_;
                            if (_e2371[1] < 0f) {
                                phi_4186_ = -(_e2371[1]);
                            } else {
                                phi_4186_ = _e2371[1];
                            }
                            let _e2382 = phi_4186_;
                            if (_e2378 > _e2382) {
                                phi_4191_ = _e2378;
                            } else {
                                phi_4191_ = _e2382;
                            }
                            let _e2385 = phi_4191_;
                            if (_e2371[2] < 0f) {
                                phi_4198_ = -(_e2371[2]);
                            } else {
                                phi_4198_ = _e2371[2];
                            }
                            let _e2389 = phi_4198_;
                            if (_e2385 > _e2389) {
                                phi_4203_ = _e2385;
                            } else {
                                phi_4203_ = _e2389;
                            }
                            let _e2392 = phi_4203_;
                            let _e2395 = local.member_2[1u];
                            if (_e2395[0] < 0f) {
                                phi_4217_ = -(_e2395[0]);
                            } else {
                                phi_4217_ = _e2395[0];
                            }
                            let _e2402 = phi_4217_;
                            if (_e2395[1] < 0f) {
                                phi_4224_ = -(_e2395[1]);
                            } else {
                                phi_4224_ = _e2395[1];
                            }
                            let _e2406 = phi_4224_;
                            if (_e2402 > _e2406) {
                                phi_4229_ = _e2402;
                            } else {
                                phi_4229_ = _e2406;
                            }
                            let _e2409 = phi_4229_;
                            if (_e2395[2] < 0f) {
                                phi_4236_ = -(_e2395[2]);
                            } else {
                                phi_4236_ = _e2395[2];
                            }
                            let _e2413 = phi_4236_;
                            if (_e2409 > _e2413) {
                                phi_4241_ = _e2409;
                            } else {
                                phi_4241_ = _e2413;
                            }
                            let _e2416 = phi_4241_;
                            if (_e2392 > _e2416) {
                                phi_4246_ = _e2392;
                            } else {
                                phi_4246_ = _e2416;
                            }
                            let _e2419 = phi_4246_;
                            let _e2421 = local.member_3;
                            let _e2425 = ((((_e2311 + _e2313) + (_e2365 + _e2367)) + (_e2419 + _e2421)) * 2f);
                            let _e2428 = local.member_3;
                            let _e2432 = (((_e515 * 1.0001f) + (_e2428 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e2435 = ((_e2209 * _e2188) - (_e2212 * _e2187));
                            let _e2438 = ((_e2212 * _e2186) - (_e2206 * _e2188));
                            let _e2441 = ((_e2206 * _e2187) - (_e2209 * _e2186));
                            let _e2446 = (((_e2435 * _e2215[0]) + (_e2438 * _e2215[1])) + (_e2441 * _e2215[2]));
                            let _e2451 = (((_e2435 * _e2231) + (_e2438 * _e2232)) + (_e2441 * _e2233));
                            let _e2456 = (((_e2435 * _e2234) + (_e2438 * _e2235)) + (_e2441 * _e2236));
                            let _e2461 = (((_e2435 * _e2215[0]) + (_e2438 * _e2215[1])) + (_e2441 * _e2215[2]));
                            let _e2466 = (((_e2435 * _e2239[0]) + (_e2438 * _e2239[1])) + (_e2441 * _e2239[2]));
                            let _e2471 = (((_e2435 * _e2255) + (_e2438 * _e2256)) + (_e2441 * _e2257));
                            let _e2476 = (((_e2435 * _e2258) + (_e2438 * _e2259)) + (_e2441 * _e2260));
                            let _e2481 = (((_e2435 * _e2239[0]) + (_e2438 * _e2239[1])) + (_e2441 * _e2239[2]));
                            if (_e2446 < _e2451) {
                                phi_4325_ = _e2446;
                            } else {
                                phi_4325_ = _e2451;
                            }
                            let _e2484 = phi_4325_;
                            if (_e2456 < _e2461) {
                                phi_4330_ = _e2456;
                            } else {
                                phi_4330_ = _e2461;
                            }
                            let _e2487 = phi_4330_;
                            if (_e2484 < _e2487) {
                                phi_4335_ = _e2484;
                            } else {
                                phi_4335_ = _e2487;
                            }
                            let _e2490 = phi_4335_;
                            if (_e2466 < _e2471) {
                                phi_4340_ = _e2466;
                            } else {
                                phi_4340_ = _e2471;
                            }
                            let _e2493 = phi_4340_;
                            if (_e2476 < _e2481) {
                                phi_4345_ = _e2476;
                            } else {
                                phi_4345_ = _e2481;
                            }
                            let _e2496 = phi_4345_;
                            if (_e2493 < _e2496) {
                                phi_4350_ = _e2493;
                            } else {
                                phi_4350_ = _e2496;
                            }
                            let _e2499 = phi_4350_;
                            if (_e2490 < _e2499) {
                                phi_4355_ = _e2490;
                            } else {
                                phi_4355_ = _e2499;
                            }
                            let _e2502 = phi_4355_;
                            if (_e2446 > _e2451) {
                                phi_4360_ = _e2446;
                            } else {
                                phi_4360_ = _e2451;
                            }
                            let _e2505 = phi_4360_;
                            if (_e2456 > _e2461) {
                                phi_4365_ = _e2456;
                            } else {
                                phi_4365_ = _e2461;
                            }
                            let _e2508 = phi_4365_;
                            if (_e2505 > _e2508) {
                                phi_4370_ = _e2505;
                            } else {
                                phi_4370_ = _e2508;
                            }
                            let _e2511 = phi_4370_;
                            if (_e2466 > _e2471) {
                                phi_4375_ = _e2466;
                            } else {
                                phi_4375_ = _e2471;
                            }
                            let _e2514 = phi_4375_;
                            if (_e2476 > _e2481) {
                                phi_4380_ = _e2476;
                            } else {
                                phi_4380_ = _e2481;
                            }
                            let _e2517 = phi_4380_;
                            if (_e2514 > _e2517) {
                                phi_4385_ = _e2514;
                            } else {
                                phi_4385_ = _e2517;
                            }
                            let _e2520 = phi_4385_;
                            if (_e2511 > _e2520) {
                                phi_4390_ = _e2511;
                            } else {
                                phi_4390_ = _e2520;
                            }
                            let _e2523 = phi_4390_;
                            if (_e2435 < 0f) {
                                phi_4396_ = -(_e2435);
                            } else {
                                phi_4396_ = _e2435;
                            }
                            let _e2527 = phi_4396_;
                            if (_e2438 < 0f) {
                                phi_4402_ = -(_e2438);
                            } else {
                                phi_4402_ = _e2438;
                            }
                            let _e2531 = phi_4402_;
                            if (_e2441 < 0f) {
                                phi_4409_ = -(_e2441);
                            } else {
                                phi_4409_ = _e2441;
                            }
                            let _e2536 = phi_4409_;
                            let _e2537 = ((_e2527 + _e2531) + _e2536);
                            let _e2542 = -(_e2523);
                            if (_e2502 > _e2542) {
                                phi_4420_ = _e2502;
                            } else {
                                phi_4420_ = _e2542;
                            }
                            let _e2545 = phi_4420_;
                            let _e2550 = (((_e2545 - ((_e2537 * _e2425) * (0.000000059604645f * (17f / 2f)))) - (_e2537 * _e2432)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2553 = ((_e2209 * _e2203) - (_e2212 * _e2202));
                            let _e2556 = ((_e2212 * _e2201) - (_e2206 * _e2203));
                            let _e2559 = ((_e2206 * _e2202) - (_e2209 * _e2201));
                            let _e2564 = (((_e2553 * _e2215[0]) + (_e2556 * _e2215[1])) + (_e2559 * _e2215[2]));
                            let _e2569 = (((_e2553 * _e2231) + (_e2556 * _e2232)) + (_e2559 * _e2233));
                            let _e2574 = (((_e2553 * _e2234) + (_e2556 * _e2235)) + (_e2559 * _e2236));
                            let _e2579 = (((_e2553 * _e2215[0]) + (_e2556 * _e2215[1])) + (_e2559 * _e2215[2]));
                            let _e2584 = (((_e2553 * _e2239[0]) + (_e2556 * _e2239[1])) + (_e2559 * _e2239[2]));
                            let _e2589 = (((_e2553 * _e2255) + (_e2556 * _e2256)) + (_e2559 * _e2257));
                            let _e2594 = (((_e2553 * _e2258) + (_e2556 * _e2259)) + (_e2559 * _e2260));
                            let _e2599 = (((_e2553 * _e2239[0]) + (_e2556 * _e2239[1])) + (_e2559 * _e2239[2]));
                            if (_e2564 < _e2569) {
                                phi_4491_ = _e2564;
                            } else {
                                phi_4491_ = _e2569;
                            }
                            let _e2602 = phi_4491_;
                            if (_e2574 < _e2579) {
                                phi_4496_ = _e2574;
                            } else {
                                phi_4496_ = _e2579;
                            }
                            let _e2605 = phi_4496_;
                            if (_e2602 < _e2605) {
                                phi_4501_ = _e2602;
                            } else {
                                phi_4501_ = _e2605;
                            }
                            let _e2608 = phi_4501_;
                            if (_e2584 < _e2589) {
                                phi_4506_ = _e2584;
                            } else {
                                phi_4506_ = _e2589;
                            }
                            let _e2611 = phi_4506_;
                            if (_e2594 < _e2599) {
                                phi_4511_ = _e2594;
                            } else {
                                phi_4511_ = _e2599;
                            }
                            let _e2614 = phi_4511_;
                            if (_e2611 < _e2614) {
                                phi_4516_ = _e2611;
                            } else {
                                phi_4516_ = _e2614;
                            }
                            let _e2617 = phi_4516_;
                            if (_e2608 < _e2617) {
                                phi_4521_ = _e2608;
                            } else {
                                phi_4521_ = _e2617;
                            }
                            let _e2620 = phi_4521_;
                            if (_e2564 > _e2569) {
                                phi_4526_ = _e2564;
                            } else {
                                phi_4526_ = _e2569;
                            }
                            let _e2623 = phi_4526_;
                            if (_e2574 > _e2579) {
                                phi_4531_ = _e2574;
                            } else {
                                phi_4531_ = _e2579;
                            }
                            let _e2626 = phi_4531_;
                            if (_e2623 > _e2626) {
                                phi_4536_ = _e2623;
                            } else {
                                phi_4536_ = _e2626;
                            }
                            let _e2629 = phi_4536_;
                            if (_e2584 > _e2589) {
                                phi_4541_ = _e2584;
                            } else {
                                phi_4541_ = _e2589;
                            }
                            let _e2632 = phi_4541_;
                            if (_e2594 > _e2599) {
                                phi_4546_ = _e2594;
                            } else {
                                phi_4546_ = _e2599;
                            }
                            let _e2635 = phi_4546_;
                            if (_e2632 > _e2635) {
                                phi_4551_ = _e2632;
                            } else {
                                phi_4551_ = _e2635;
                            }
                            let _e2638 = phi_4551_;
                            if (_e2629 > _e2638) {
                                phi_4556_ = _e2629;
                            } else {
                                phi_4556_ = _e2638;
                            }
                            let _e2641 = phi_4556_;
                            if (_e2553 < 0f) {
                                phi_4562_ = -(_e2553);
                            } else {
                                phi_4562_ = _e2553;
                            }
                            let _e2645 = phi_4562_;
                            if (_e2556 < 0f) {
                                phi_4568_ = -(_e2556);
                            } else {
                                phi_4568_ = _e2556;
                            }
                            let _e2649 = phi_4568_;
                            if (_e2559 < 0f) {
                                phi_4575_ = -(_e2559);
                            } else {
                                phi_4575_ = _e2559;
                            }
                            let _e2654 = phi_4575_;
                            let _e2655 = ((_e2645 + _e2649) + _e2654);
                            let _e2660 = -(_e2641);
                            if (_e2620 > _e2660) {
                                phi_4586_ = _e2620;
                            } else {
                                phi_4586_ = _e2660;
                            }
                            let _e2663 = phi_4586_;
                            let _e2668 = (((_e2663 - ((_e2655 * _e2425) * (0.000000059604645f * (17f / 2f)))) - (_e2655 * _e2432)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e2550 > _e2668) {
                                phi_4596_ = _e2550;
                            } else {
                                phi_4596_ = _e2668;
                            }
                            let _e2671 = phi_4596_;
                            let _e2672 = (_e2201 - _e2186);
                            let _e2673 = (_e2202 - _e2187);
                            let _e2674 = (_e2203 - _e2188);
                            let _e2677 = ((_e2209 * _e2674) - (_e2212 * _e2673));
                            let _e2680 = ((_e2212 * _e2672) - (_e2206 * _e2674));
                            let _e2683 = ((_e2206 * _e2673) - (_e2209 * _e2672));
                            let _e2688 = (((_e2677 * _e2215[0]) + (_e2680 * _e2215[1])) + (_e2683 * _e2215[2]));
                            let _e2693 = (((_e2677 * _e2231) + (_e2680 * _e2232)) + (_e2683 * _e2233));
                            let _e2698 = (((_e2677 * _e2234) + (_e2680 * _e2235)) + (_e2683 * _e2236));
                            let _e2703 = (((_e2677 * _e2215[0]) + (_e2680 * _e2215[1])) + (_e2683 * _e2215[2]));
                            let _e2708 = (((_e2677 * _e2239[0]) + (_e2680 * _e2239[1])) + (_e2683 * _e2239[2]));
                            let _e2713 = (((_e2677 * _e2255) + (_e2680 * _e2256)) + (_e2683 * _e2257));
                            let _e2718 = (((_e2677 * _e2258) + (_e2680 * _e2259)) + (_e2683 * _e2260));
                            let _e2723 = (((_e2677 * _e2239[0]) + (_e2680 * _e2239[1])) + (_e2683 * _e2239[2]));
                            if (_e2688 < _e2693) {
                                phi_4669_ = _e2688;
                            } else {
                                phi_4669_ = _e2693;
                            }
                            let _e2726 = phi_4669_;
                            if (_e2698 < _e2703) {
                                phi_4674_ = _e2698;
                            } else {
                                phi_4674_ = _e2703;
                            }
                            let _e2729 = phi_4674_;
                            if (_e2726 < _e2729) {
                                phi_4679_ = _e2726;
                            } else {
                                phi_4679_ = _e2729;
                            }
                            let _e2732 = phi_4679_;
                            if (_e2708 < _e2713) {
                                phi_4684_ = _e2708;
                            } else {
                                phi_4684_ = _e2713;
                            }
                            let _e2735 = phi_4684_;
                            if (_e2718 < _e2723) {
                                phi_4689_ = _e2718;
                            } else {
                                phi_4689_ = _e2723;
                            }
                            let _e2738 = phi_4689_;
                            if (_e2735 < _e2738) {
                                phi_4694_ = _e2735;
                            } else {
                                phi_4694_ = _e2738;
                            }
                            let _e2741 = phi_4694_;
                            if (_e2732 < _e2741) {
                                phi_4699_ = _e2732;
                            } else {
                                phi_4699_ = _e2741;
                            }
                            let _e2744 = phi_4699_;
                            if (_e2688 > _e2693) {
                                phi_4704_ = _e2688;
                            } else {
                                phi_4704_ = _e2693;
                            }
                            let _e2747 = phi_4704_;
                            if (_e2698 > _e2703) {
                                phi_4709_ = _e2698;
                            } else {
                                phi_4709_ = _e2703;
                            }
                            let _e2750 = phi_4709_;
                            if (_e2747 > _e2750) {
                                phi_4714_ = _e2747;
                            } else {
                                phi_4714_ = _e2750;
                            }
                            let _e2753 = phi_4714_;
                            if (_e2708 > _e2713) {
                                phi_4719_ = _e2708;
                            } else {
                                phi_4719_ = _e2713;
                            }
                            let _e2756 = phi_4719_;
                            if (_e2718 > _e2723) {
                                phi_4724_ = _e2718;
                            } else {
                                phi_4724_ = _e2723;
                            }
                            let _e2759 = phi_4724_;
                            if (_e2756 > _e2759) {
                                phi_4729_ = _e2756;
                            } else {
                                phi_4729_ = _e2759;
                            }
                            let _e2762 = phi_4729_;
                            if (_e2753 > _e2762) {
                                phi_4734_ = _e2753;
                            } else {
                                phi_4734_ = _e2762;
                            }
                            let _e2765 = phi_4734_;
                            if (_e2677 < 0f) {
                                phi_4740_ = -(_e2677);
                            } else {
                                phi_4740_ = _e2677;
                            }
                            let _e2769 = phi_4740_;
                            if (_e2680 < 0f) {
                                phi_4746_ = -(_e2680);
                            } else {
                                phi_4746_ = _e2680;
                            }
                            let _e2773 = phi_4746_;
                            if (_e2683 < 0f) {
                                phi_4753_ = -(_e2683);
                            } else {
                                phi_4753_ = _e2683;
                            }
                            let _e2778 = phi_4753_;
                            let _e2779 = ((_e2769 + _e2773) + _e2778);
                            let _e2784 = -(_e2765);
                            if (_e2744 > _e2784) {
                                phi_4764_ = _e2744;
                            } else {
                                phi_4764_ = _e2784;
                            }
                            let _e2787 = phi_4764_;
                            let _e2792 = (((_e2787 - ((_e2779 * _e2425) * (0.000000059604645f * (17f / 2f)))) - (_e2779 * _e2432)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e2671 > _e2792) {
                                phi_4774_ = _e2671;
                            } else {
                                phi_4774_ = _e2792;
                            }
                            let _e2795 = phi_4774_;
                            phi_4778_ = (_e2173 || (_e2795 > 0f));
                        }
                        let _e2799 = phi_4778_;
                        if _e2799 {
                            let _e2802 = local_1.member_1[0u];
                            let _e2808 = local_1.member_2[0u];
                            let _e2814 = ((_e2802[1] * _e2808[2]) - (_e2802[2] * _e2808[1]));
                            let _e2817 = ((_e2802[2] * _e2808[0]) - (_e2802[0] * _e2808[2]));
                            let _e2820 = ((_e2802[0] * _e2808[1]) - (_e2802[1] * _e2808[0]));
                            let _e2823 = local_1.member_1[1u];
                            let _e2829 = local_1.member_2[1u];
                            let _e2835 = ((_e2823[1] * _e2829[2]) - (_e2823[2] * _e2829[1]));
                            let _e2838 = ((_e2823[2] * _e2829[0]) - (_e2823[0] * _e2829[2]));
                            let _e2841 = ((_e2823[0] * _e2829[1]) - (_e2823[1] * _e2829[0]));
                            let _e2844 = local_1.member_1[0u];
                            let _e2850 = local_1.member_2[1u];
                            let _e2865 = local_1.member_1[1u];
                            let _e2871 = local_1.member_2[0u];
                            let _e2884 = (((_e2844[1] * _e2850[2]) - (_e2844[2] * _e2850[1])) + ((_e2865[1] * _e2871[2]) - (_e2865[2] * _e2871[1])));
                            let _e2885 = (((_e2844[2] * _e2850[0]) - (_e2844[0] * _e2850[2])) + ((_e2865[2] * _e2871[0]) - (_e2865[0] * _e2871[2])));
                            let _e2886 = (((_e2844[0] * _e2850[1]) - (_e2844[1] * _e2850[0])) + ((_e2865[0] * _e2871[1]) - (_e2865[1] * _e2871[0])));
                            let _e2889 = local_1.member[0u];
                            let _e2900 = local_1.member[1u];
                            let _e2911 = local_1.member[0u];
                            let _e2920 = ((((_e2900[0] * _e2814) + (_e2900[1] * _e2817)) + (_e2900[2] * _e2820)) + (((_e2911[0] * _e2884) + (_e2911[1] * _e2885)) + (_e2911[2] * _e2886)));
                            let _e2923 = local_1.member[0u];
                            let _e2934 = local_1.member[1u];
                            let _e2943 = ((((_e2923[0] * _e2835) + (_e2923[1] * _e2838)) + (_e2923[2] * _e2841)) + (((_e2934[0] * _e2884) + (_e2934[1] * _e2885)) + (_e2934[2] * _e2886)));
                            let _e2946 = local_1.member[1u];
                            let _e2957 = local_1.member[0u];
                            if (_e2957[0] < 0f) {
                                phi_5023_ = -(_e2957[0]);
                            } else {
                                phi_5023_ = _e2957[0];
                            }
                            let _e2964 = phi_5023_;
                            if (_e2957[1] < 0f) {
                                phi_5030_ = -(_e2957[1]);
                            } else {
                                phi_5030_ = _e2957[1];
                            }
                            let _e2968 = phi_5030_;
                            if (_e2964 > _e2968) {
                                phi_5035_ = _e2964;
                            } else {
                                phi_5035_ = _e2968;
                            }
                            let _e2971 = phi_5035_;
                            if (_e2957[2] < 0f) {
                                phi_5042_ = -(_e2957[2]);
                            } else {
                                phi_5042_ = _e2957[2];
                            }
                            let _e2975 = phi_5042_;
                            if (_e2971 > _e2975) {
                                phi_5047_ = _e2971;
                            } else {
                                phi_5047_ = _e2975;
                            }
                            let _e2978 = phi_5047_;
                            let _e2981 = local_1.member[1u];
                            if (_e2981[0] < 0f) {
                                phi_5060_ = -(_e2981[0]);
                            } else {
                                phi_5060_ = _e2981[0];
                            }
                            let _e2988 = phi_5060_;
                            if (_e2981[1] < 0f) {
                                phi_5067_ = -(_e2981[1]);
                            } else {
                                phi_5067_ = _e2981[1];
                            }
                            let _e2992 = phi_5067_;
                            if (_e2988 > _e2992) {
                                phi_5072_ = _e2988;
                            } else {
                                phi_5072_ = _e2992;
                            }
                            let _e2995 = phi_5072_;
                            if (_e2981[2] < 0f) {
                                phi_5079_ = -(_e2981[2]);
                            } else {
                                phi_5079_ = _e2981[2];
                            }
                            let _e2999 = phi_5079_;
                            if (_e2995 > _e2999) {
                                phi_5084_ = _e2995;
                            } else {
                                phi_5084_ = _e2999;
                            }
                            let _e3002 = phi_5084_;
                            if (_e2978 > _e3002) {
                                phi_5089_ = _e2978;
                            } else {
                                phi_5089_ = _e3002;
                            }
                            let _e3005 = phi_5089_;
                            let _e3007 = local_1.member_3;
                            let _e3008 = (_e3005 + _e3007);
                            let _e3011 = local_1.member_1[0u];
                            if (_e3011[0] < 0f) {
                                phi_5106_ = -(_e3011[0]);
                            } else {
                                phi_5106_ = _e3011[0];
                            }
                            let _e3018 = phi_5106_;
                            if (_e3011[1] < 0f) {
                                phi_5113_ = -(_e3011[1]);
                            } else {
                                phi_5113_ = _e3011[1];
                            }
                            let _e3022 = phi_5113_;
                            if (_e3018 > _e3022) {
                                phi_5118_ = _e3018;
                            } else {
                                phi_5118_ = _e3022;
                            }
                            let _e3025 = phi_5118_;
                            if (_e3011[2] < 0f) {
                                phi_5125_ = -(_e3011[2]);
                            } else {
                                phi_5125_ = _e3011[2];
                            }
                            let _e3029 = phi_5125_;
                            if (_e3025 > _e3029) {
                                phi_5130_ = _e3025;
                            } else {
                                phi_5130_ = _e3029;
                            }
                            let _e3032 = phi_5130_;
                            let _e3035 = local_1.member_1[1u];
                            if (_e3035[0] < 0f) {
                                phi_5144_ = -(_e3035[0]);
                            } else {
                                phi_5144_ = _e3035[0];
                            }
                            let _e3042 = phi_5144_;
                            if (_e3035[1] < 0f) {
                                phi_5151_ = -(_e3035[1]);
                            } else {
                                phi_5151_ = _e3035[1];
                            }
                            let _e3046 = phi_5151_;
                            if (_e3042 > _e3046) {
                                phi_5156_ = _e3042;
                            } else {
                                phi_5156_ = _e3046;
                            }
                            let _e3049 = phi_5156_;
                            if (_e3035[2] < 0f) {
                                phi_5163_ = -(_e3035[2]);
                            } else {
                                phi_5163_ = _e3035[2];
                            }
                            let _e3053 = phi_5163_;
                            if (_e3049 > _e3053) {
                                phi_5168_ = _e3049;
                            } else {
                                phi_5168_ = _e3053;
                            }
                            let _e3056 = phi_5168_;
                            if (_e3032 > _e3056) {
                                phi_5173_ = _e3032;
                            } else {
                                phi_5173_ = _e3056;
                            }
                            let _e3059 = phi_5173_;
                            let _e3061 = local_1.member_3;
                            let _e3062 = (_e3059 + _e3061);
                            let _e3065 = local_1.member_2[0u];
                            if (_e3065[0] < 0f) {
                                phi_5190_ = -(_e3065[0]);
                            } else {
                                phi_5190_ = _e3065[0];
                            }
                            let _e3072 = phi_5190_;
                            if (_e3065[1] < 0f) {
                                phi_5197_ = -(_e3065[1]);
                            } else {
                                phi_5197_ = _e3065[1];
                            }
                            let _e3076 = phi_5197_;
                            if (_e3072 > _e3076) {
                                phi_5202_ = _e3072;
                            } else {
                                phi_5202_ = _e3076;
                            }
                            let _e3079 = phi_5202_;
                            if (_e3065[2] < 0f) {
                                phi_5209_ = -(_e3065[2]);
                            } else {
                                phi_5209_ = _e3065[2];
                            }
                            let _e3083 = phi_5209_;
                            if (_e3079 > _e3083) {
                                phi_5214_ = _e3079;
                            } else {
                                phi_5214_ = _e3083;
                            }
                            let _e3086 = phi_5214_;
                            let _e3089 = local_1.member_2[1u];
                            if (_e3089[0] < 0f) {
                                phi_5228_ = -(_e3089[0]);
                            } else {
                                phi_5228_ = _e3089[0];
                            }
                            let _e3096 = phi_5228_;
                            if (_e3089[1] < 0f) {
                                phi_5235_ = -(_e3089[1]);
                            } else {
                                phi_5235_ = _e3089[1];
                            }
                            let _e3100 = phi_5235_;
                            if (_e3096 > _e3100) {
                                phi_5240_ = _e3096;
                            } else {
                                phi_5240_ = _e3100;
                            }
                            let _e3103 = phi_5240_;
                            if (_e3089[2] < 0f) {
                                phi_5247_ = -(_e3089[2]);
                            } else {
                                phi_5247_ = _e3089[2];
                            }
                            let _e3107 = phi_5247_;
                            if (_e3103 > _e3107) {
                                phi_5252_ = _e3103;
                            } else {
                                phi_5252_ = _e3107;
                            }
                            let _e3110 = phi_5252_;
                            if (_e3086 > _e3110) {
                                phi_5257_ = _e3086;
                            } else {
                                phi_5257_ = _e3110;
                            }
                            let _e3113 = phi_5257_;
                            let _e3115 = local_1.member_3;
                            let _e3116 = (_e3113 + _e3115);
                            let _e3118 = ((_e3062 * 8f) * _e3116);
                            let _e3125 = local_1.member_3;
                            if (_e2814 < 0f) {
                                phi_5288_ = -(_e2814);
                            } else {
                                phi_5288_ = _e2814;
                            }
                            let _e3142 = phi_5288_;
                            if (_e2817 < 0f) {
                                phi_5294_ = -(_e2817);
                            } else {
                                phi_5294_ = _e2817;
                            }
                            let _e3146 = phi_5294_;
                            if (_e2820 < 0f) {
                                phi_5301_ = -(_e2820);
                            } else {
                                phi_5301_ = _e2820;
                            }
                            let _e3151 = phi_5301_;
                            let _e3152 = ((_e3142 + _e3146) + _e3151);
                            if (_e2835 < 0f) {
                                phi_5308_ = -(_e2835);
                            } else {
                                phi_5308_ = _e2835;
                            }
                            let _e3156 = phi_5308_;
                            if (_e2838 < 0f) {
                                phi_5314_ = -(_e2838);
                            } else {
                                phi_5314_ = _e2838;
                            }
                            let _e3160 = phi_5314_;
                            if (_e2841 < 0f) {
                                phi_5321_ = -(_e2841);
                            } else {
                                phi_5321_ = _e2841;
                            }
                            let _e3165 = phi_5321_;
                            let _e3166 = ((_e3156 + _e3160) + _e3165);
                            if (_e3152 > _e3166) {
                                phi_5327_ = _e3152;
                            } else {
                                phi_5327_ = _e3166;
                            }
                            let _e3169 = phi_5327_;
                            if (_e2884 < 0f) {
                                phi_5333_ = -(_e2884);
                            } else {
                                phi_5333_ = _e2884;
                            }
                            let _e3173 = phi_5333_;
                            if (_e2885 < 0f) {
                                phi_5339_ = -(_e2885);
                            } else {
                                phi_5339_ = _e2885;
                            }
                            let _e3177 = phi_5339_;
                            if (_e2886 < 0f) {
                                phi_5346_ = -(_e2886);
                            } else {
                                phi_5346_ = _e2886;
                            }
                            let _e3182 = phi_5346_;
                            let _e3184 = (((_e3173 + _e3177) + _e3182) * 0.5f);
                            if (_e3169 > _e3184) {
                                phi_5353_ = _e3169;
                            } else {
                                phi_5353_ = _e3184;
                            }
                            let _e3187 = phi_5353_;
                            let _e3192 = local_1.member_3;
                            let _e3205 = ((((_e2889[0] * _e2814) + (_e2889[1] * _e2817)) + (_e2889[2] * _e2820)) * 3f);
                            let _e3206 = ((((_e2946[0] * _e2835) + (_e2946[1] * _e2838)) + (_e2946[2] * _e2841)) * 3f);
                            if (_e3205 < _e3206) {
                                phi_5377_ = _e3205;
                            } else {
                                phi_5377_ = _e3206;
                            }
                            let _e3209 = phi_5377_;
                            if (_e2920 < _e2943) {
                                phi_5382_ = _e2920;
                            } else {
                                phi_5382_ = _e2943;
                            }
                            let _e3212 = phi_5382_;
                            if (_e3209 < _e3212) {
                                phi_5387_ = _e3209;
                            } else {
                                phi_5387_ = _e3212;
                            }
                            let _e3215 = phi_5387_;
                            if (_e3205 > _e3206) {
                                phi_5392_ = _e3205;
                            } else {
                                phi_5392_ = _e3206;
                            }
                            let _e3218 = phi_5392_;
                            if (_e2920 > _e2943) {
                                phi_5397_ = _e2920;
                            } else {
                                phi_5397_ = _e2943;
                            }
                            let _e3221 = phi_5397_;
                            if (_e3218 > _e3221) {
                                phi_5402_ = _e3218;
                            } else {
                                phi_5402_ = _e3221;
                            }
                            let _e3224 = phi_5402_;
                            let _e3229 = -(_e3224);
                            if (_e3215 > _e3229) {
                                phi_5412_ = _e3215;
                            } else {
                                phi_5412_ = _e3229;
                            }
                            let _e3232 = phi_5412_;
                            let _e3234 = ((_e3232 - ((((((_e3008 * 8f) * _e3118) * (0.000000059604645f * (524f / 64f))) + ((_e3125 * 19f) * ((_e3008 * (_e3062 + _e3116)) + (_e3062 * _e3116)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3008) * ((1f + _e3062) * (1f + _e3116))))) + ((_e515 * (((_e3187 + (_e3118 * (0.000000059604645f * 8f))) + ((_e3192 * 6f) * (_e3062 + _e3116))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3062) * (1f + _e3116))))) * (3f * 1.0001f)))) > 0f);
                            if _e3234 {
                                phi_6381_ = _e3234;
                            } else {
                                let _e3237 = local_1.member_1[0u];
                                let _e3243 = local_1.member_1[1u];
                                let _e3247 = (_e3237[0] + _e3243[0]);
                                let _e3248 = (_e3237[1] + _e3243[1]);
                                let _e3249 = (_e3237[2] + _e3243[2]);
                                let _e3252 = local_1.member_2[0u];
                                let _e3258 = local_1.member_2[1u];
                                let _e3262 = (_e3252[0] + _e3258[0]);
                                let _e3263 = (_e3252[1] + _e3258[1]);
                                let _e3264 = (_e3252[2] + _e3258[2]);
                                let _e3267 = ((_e3248 * _e3264) - (_e3249 * _e3263));
                                let _e3270 = ((_e3249 * _e3262) - (_e3247 * _e3264));
                                let _e3273 = ((_e3247 * _e3263) - (_e3248 * _e3262));
                                let _e3276 = local_1.member[0u];
                                let _e3282 = local_1.member_1[0u];
                                let _e3288 = local_1.member_2[0u];
                                let _e3292 = (_e3276[0] - _e3282[0]);
                                let _e3293 = (_e3276[1] - _e3282[1]);
                                let _e3294 = (_e3276[2] - _e3282[2]);
                                let _e3295 = (_e3276[0] - _e3288[0]);
                                let _e3296 = (_e3276[1] - _e3288[1]);
                                let _e3297 = (_e3276[2] - _e3288[2]);
                                let _e3300 = local_1.member[1u];
                                let _e3306 = local_1.member_1[1u];
                                let _e3312 = local_1.member_2[1u];
                                let _e3316 = (_e3300[0] - _e3306[0]);
                                let _e3317 = (_e3300[1] - _e3306[1]);
                                let _e3318 = (_e3300[2] - _e3306[2]);
                                let _e3319 = (_e3300[0] - _e3312[0]);
                                let _e3320 = (_e3300[1] - _e3312[1]);
                                let _e3321 = (_e3300[2] - _e3312[2]);
                                let _e3324 = local_1.member[0u];
                                if (_e3324[0] < 0f) {
                                    phi_5615_ = -(_e3324[0]);
                                } else {
                                    phi_5615_ = _e3324[0];
                                }
                                let _e3331 = phi_5615_;
                                if (_e3324[1] < 0f) {
                                    phi_5622_ = -(_e3324[1]);
                                } else {
                                    phi_5622_ = _e3324[1];
                                }
                                let _e3335 = phi_5622_;
                                if (_e3331 > _e3335) {
                                    phi_5627_ = _e3331;
                                } else {
                                    phi_5627_ = _e3335;
                                }
                                let _e3338 = phi_5627_;
                                if (_e3324[2] < 0f) {
                                    phi_5634_ = -(_e3324[2]);
                                } else {
                                    phi_5634_ = _e3324[2];
                                }
                                let _e3342 = phi_5634_;
                                if (_e3338 > _e3342) {
                                    phi_5639_ = _e3338;
                                } else {
                                    phi_5639_ = _e3342;
                                }
                                let _e3345 = phi_5639_;
                                let _e3348 = local_1.member[1u];
                                if (_e3348[0] < 0f) {
                                    phi_5652_ = -(_e3348[0]);
                                } else {
                                    phi_5652_ = _e3348[0];
                                }
                                let _e3355 = phi_5652_;
                                if (_e3348[1] < 0f) {
                                    phi_5659_ = -(_e3348[1]);
                                } else {
                                    phi_5659_ = _e3348[1];
                                }
                                let _e3359 = phi_5659_;
                                if (_e3355 > _e3359) {
                                    phi_5664_ = _e3355;
                                } else {
                                    phi_5664_ = _e3359;
                                }
                                let _e3362 = phi_5664_;
                                if (_e3348[2] < 0f) {
                                    phi_5671_ = -(_e3348[2]);
                                } else {
                                    phi_5671_ = _e3348[2];
                                }
                                let _e3366 = phi_5671_;
                                if (_e3362 > _e3366) {
                                    phi_5676_ = _e3362;
                                } else {
                                    phi_5676_ = _e3366;
                                }
                                let _e3369 = phi_5676_;
                                if (_e3345 > _e3369) {
                                    phi_5681_ = _e3345;
                                } else {
                                    phi_5681_ = _e3369;
                                }
                                let _e3372 = phi_5681_;
                                let _e3374 = local_1.member_3;
                                let _e3378 = local_1.member_1[0u];
                                if (_e3378[0] < 0f) {
                                    phi_5698_ = -(_e3378[0]);
                                } else {
                                    phi_5698_ = _e3378[0];
                                }
                                let _e3385 = phi_5698_;
                                if (_e3378[1] < 0f) {
                                    phi_5705_ = -(_e3378[1]);
                                } else {
                                    phi_5705_ = _e3378[1];
                                }
                                let _e3389 = phi_5705_;
                                if (_e3385 > _e3389) {
                                    phi_5710_ = _e3385;
                                } else {
                                    phi_5710_ = _e3389;
                                }
                                let _e3392 = phi_5710_;
                                if (_e3378[2] < 0f) {
                                    phi_5717_ = -(_e3378[2]);
                                } else {
                                    phi_5717_ = _e3378[2];
                                }
                                let _e3396 = phi_5717_;
                                if (_e3392 > _e3396) {
                                    phi_5722_ = _e3392;
                                } else {
                                    phi_5722_ = _e3396;
                                }
                                let _e3399 = phi_5722_;
                                let _e3402 = local_1.member_1[1u];
                                if (_e3402[0] < 0f) {
                                    phi_5736_ = -(_e3402[0]);
                                } else {
                                    phi_5736_ = _e3402[0];
                                }
                                let _e3409 = phi_5736_;
                                if (_e3402[1] < 0f) {
                                    phi_5743_ = -(_e3402[1]);
                                } else {
                                    phi_5743_ = _e3402[1];
                                }
                                let _e3413 = phi_5743_;
                                if (_e3409 > _e3413) {
                                    phi_5748_ = _e3409;
                                } else {
                                    phi_5748_ = _e3413;
                                }
                                let _e3416 = phi_5748_;
                                if (_e3402[2] < 0f) {
                                    phi_5755_ = -(_e3402[2]);
                                } else {
                                    phi_5755_ = _e3402[2];
                                }
                                let _e3420 = phi_5755_;
                                if (_e3416 > _e3420) {
                                    phi_5760_ = _e3416;
                                } else {
                                    phi_5760_ = _e3420;
                                }
                                let _e3423 = phi_5760_;
                                if (_e3399 > _e3423) {
                                    phi_5765_ = _e3399;
                                } else {
                                    phi_5765_ = _e3423;
                                }
                                let _e3426 = phi_5765_;
                                let _e3428 = local_1.member_3;
                                let _e3432 = local_1.member_2[0u];
                                if (_e3432[0] < 0f) {
                                    phi_5782_ = -(_e3432[0]);
                                } else {
                                    phi_5782_ = _e3432[0];
                                }
                                let _e3439 = phi_5782_;
                                if (_e3432[1] < 0f) {
                                    phi_5789_ = -(_e3432[1]);
                                } else {
                                    phi_5789_ = _e3432[1];
                                }
                                let _e3443 = phi_5789_;
                                if (_e3439 > _e3443) {
                                    phi_5794_ = _e3439;
                                } else {
                                    phi_5794_ = _e3443;
                                }
                                let _e3446 = phi_5794_;
                                if (_e3432[2] < 0f) {
                                    phi_5801_ = -(_e3432[2]);
                                } else {
                                    phi_5801_ = _e3432[2];
                                }
                                let _e3450 = phi_5801_;
                                if (_e3446 > _e3450) {
                                    phi_5806_ = _e3446;
                                } else {
                                    phi_5806_ = _e3450;
                                }
                                let _e3453 = phi_5806_;
                                let _e3456 = local_1.member_2[1u];
                                if (_e3456[0] < 0f) {
                                    phi_5820_ = -(_e3456[0]);
                                } else {
                                    phi_5820_ = _e3456[0];
                                }
                                let _e3463 = phi_5820_;
                                if (_e3456[1] < 0f) {
                                    phi_5827_ = -(_e3456[1]);
                                } else {
                                    phi_5827_ = _e3456[1];
                                }
                                let _e3467 = phi_5827_;
                                if (_e3463 > _e3467) {
                                    phi_5832_ = _e3463;
                                } else {
                                    phi_5832_ = _e3467;
                                }
                                let _e3470 = phi_5832_;
                                if (_e3456[2] < 0f) {
                                    phi_5839_ = -(_e3456[2]);
                                } else {
                                    phi_5839_ = _e3456[2];
                                }
                                let _e3474 = phi_5839_;
                                if (_e3470 > _e3474) {
                                    phi_5844_ = _e3470;
                                } else {
                                    phi_5844_ = _e3474;
                                }
                                let _e3477 = phi_5844_;
                                if (_e3453 > _e3477) {
                                    phi_5849_ = _e3453;
                                } else {
                                    phi_5849_ = _e3477;
                                }
                                let _e3480 = phi_5849_;
                                let _e3482 = local_1.member_3;
                                let _e3486 = ((((_e3372 + _e3374) + (_e3426 + _e3428)) + (_e3480 + _e3482)) * 2f);
                                let _e3489 = local_1.member_3;
                                let _e3493 = (((_e515 * 1.0001f) + (_e3489 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e3496 = ((_e3270 * _e3249) - (_e3273 * _e3248));
                                let _e3499 = ((_e3273 * _e3247) - (_e3267 * _e3249));
                                let _e3502 = ((_e3267 * _e3248) - (_e3270 * _e3247));
                                let _e3507 = (((_e3496 * _e3276[0]) + (_e3499 * _e3276[1])) + (_e3502 * _e3276[2]));
                                let _e3512 = (((_e3496 * _e3292) + (_e3499 * _e3293)) + (_e3502 * _e3294));
                                let _e3517 = (((_e3496 * _e3295) + (_e3499 * _e3296)) + (_e3502 * _e3297));
                                let _e3522 = (((_e3496 * _e3276[0]) + (_e3499 * _e3276[1])) + (_e3502 * _e3276[2]));
                                let _e3527 = (((_e3496 * _e3300[0]) + (_e3499 * _e3300[1])) + (_e3502 * _e3300[2]));
                                let _e3532 = (((_e3496 * _e3316) + (_e3499 * _e3317)) + (_e3502 * _e3318));
                                let _e3537 = (((_e3496 * _e3319) + (_e3499 * _e3320)) + (_e3502 * _e3321));
                                let _e3542 = (((_e3496 * _e3300[0]) + (_e3499 * _e3300[1])) + (_e3502 * _e3300[2]));
                                if (_e3507 < _e3512) {
                                    phi_5928_ = _e3507;
                                } else {
                                    phi_5928_ = _e3512;
                                }
                                let _e3545 = phi_5928_;
                                if (_e3517 < _e3522) {
                                    phi_5933_ = _e3517;
                                } else {
                                    phi_5933_ = _e3522;
                                }
                                let _e3548 = phi_5933_;
                                if (_e3545 < _e3548) {
                                    phi_5938_ = _e3545;
                                } else {
                                    phi_5938_ = _e3548;
                                }
                                let _e3551 = phi_5938_;
                                if (_e3527 < _e3532) {
                                    phi_5943_ = _e3527;
                                } else {
                                    phi_5943_ = _e3532;
                                }
                                let _e3554 = phi_5943_;
                                if (_e3537 < _e3542) {
                                    phi_5948_ = _e3537;
                                } else {
                                    phi_5948_ = _e3542;
                                }
                                let _e3557 = phi_5948_;
                                if (_e3554 < _e3557) {
                                    phi_5953_ = _e3554;
                                } else {
                                    phi_5953_ = _e3557;
                                }
                                let _e3560 = phi_5953_;
                                if (_e3551 < _e3560) {
                                    phi_5958_ = _e3551;
                                } else {
                                    phi_5958_ = _e3560;
                                }
                                let _e3563 = phi_5958_;
                                if (_e3507 > _e3512) {
                                    phi_5963_ = _e3507;
                                } else {
                                    phi_5963_ = _e3512;
                                }
                                let _e3566 = phi_5963_;
                                if (_e3517 > _e3522) {
                                    phi_5968_ = _e3517;
                                } else {
                                    phi_5968_ = _e3522;
                                }
                                let _e3569 = phi_5968_;
                                if (_e3566 > _e3569) {
                                    phi_5973_ = _e3566;
                                } else {
                                    phi_5973_ = _e3569;
                                }
                                let _e3572 = phi_5973_;
                                if (_e3527 > _e3532) {
                                    phi_5978_ = _e3527;
                                } else {
                                    phi_5978_ = _e3532;
                                }
                                let _e3575 = phi_5978_;
                                if (_e3537 > _e3542) {
                                    phi_5983_ = _e3537;
                                } else {
                                    phi_5983_ = _e3542;
                                }
                                let _e3578 = phi_5983_;
                                if (_e3575 > _e3578) {
                                    phi_5988_ = _e3575;
                                } else {
                                    phi_5988_ = _e3578;
                                }
                                let _e3581 = phi_5988_;
                                if (_e3572 > _e3581) {
                                    phi_5993_ = _e3572;
                                } else {
                                    phi_5993_ = _e3581;
                                }
                                let _e3584 = phi_5993_;
                                if (_e3496 < 0f) {
                                    phi_5999_ = -(_e3496);
                                } else {
                                    phi_5999_ = _e3496;
                                }
                                let _e3588 = phi_5999_;
                                if (_e3499 < 0f) {
                                    phi_6005_ = -(_e3499);
                                } else {
                                    phi_6005_ = _e3499;
                                }
                                let _e3592 = phi_6005_;
                                if (_e3502 < 0f) {
                                    phi_6012_ = -(_e3502);
                                } else {
                                    phi_6012_ = _e3502;
                                }
                                let _e3597 = phi_6012_;
                                let _e3598 = ((_e3588 + _e3592) + _e3597);
                                let _e3603 = -(_e3584);
                                if (_e3563 > _e3603) {
                                    phi_6023_ = _e3563;
                                } else {
                                    phi_6023_ = _e3603;
                                }
                                let _e3606 = phi_6023_;
                                let _e3611 = (((_e3606 - ((_e3598 * _e3486) * (0.000000059604645f * (17f / 2f)))) - (_e3598 * _e3493)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3614 = ((_e3270 * _e3264) - (_e3273 * _e3263));
                                let _e3617 = ((_e3273 * _e3262) - (_e3267 * _e3264));
                                let _e3620 = ((_e3267 * _e3263) - (_e3270 * _e3262));
                                let _e3625 = (((_e3614 * _e3276[0]) + (_e3617 * _e3276[1])) + (_e3620 * _e3276[2]));
                                let _e3630 = (((_e3614 * _e3292) + (_e3617 * _e3293)) + (_e3620 * _e3294));
                                let _e3635 = (((_e3614 * _e3295) + (_e3617 * _e3296)) + (_e3620 * _e3297));
                                let _e3640 = (((_e3614 * _e3276[0]) + (_e3617 * _e3276[1])) + (_e3620 * _e3276[2]));
                                let _e3645 = (((_e3614 * _e3300[0]) + (_e3617 * _e3300[1])) + (_e3620 * _e3300[2]));
                                let _e3650 = (((_e3614 * _e3316) + (_e3617 * _e3317)) + (_e3620 * _e3318));
                                let _e3655 = (((_e3614 * _e3319) + (_e3617 * _e3320)) + (_e3620 * _e3321));
                                let _e3660 = (((_e3614 * _e3300[0]) + (_e3617 * _e3300[1])) + (_e3620 * _e3300[2]));
                                if (_e3625 < _e3630) {
                                    phi_6094_ = _e3625;
                                } else {
                                    phi_6094_ = _e3630;
                                }
                                let _e3663 = phi_6094_;
                                if (_e3635 < _e3640) {
                                    phi_6099_ = _e3635;
                                } else {
                                    phi_6099_ = _e3640;
                                }
                                let _e3666 = phi_6099_;
                                if (_e3663 < _e3666) {
                                    phi_6104_ = _e3663;
                                } else {
                                    phi_6104_ = _e3666;
                                }
                                let _e3669 = phi_6104_;
                                if (_e3645 < _e3650) {
                                    phi_6109_ = _e3645;
                                } else {
                                    phi_6109_ = _e3650;
                                }
                                let _e3672 = phi_6109_;
                                if (_e3655 < _e3660) {
                                    phi_6114_ = _e3655;
                                } else {
                                    phi_6114_ = _e3660;
                                }
                                let _e3675 = phi_6114_;
                                if (_e3672 < _e3675) {
                                    phi_6119_ = _e3672;
                                } else {
                                    phi_6119_ = _e3675;
                                }
                                let _e3678 = phi_6119_;
                                if (_e3669 < _e3678) {
                                    phi_6124_ = _e3669;
                                } else {
                                    phi_6124_ = _e3678;
                                }
                                let _e3681 = phi_6124_;
                                if (_e3625 > _e3630) {
                                    phi_6129_ = _e3625;
                                } else {
                                    phi_6129_ = _e3630;
                                }
                                let _e3684 = phi_6129_;
                                if (_e3635 > _e3640) {
                                    phi_6134_ = _e3635;
                                } else {
                                    phi_6134_ = _e3640;
                                }
                                let _e3687 = phi_6134_;
                                if (_e3684 > _e3687) {
                                    phi_6139_ = _e3684;
                                } else {
                                    phi_6139_ = _e3687;
                                }
                                let _e3690 = phi_6139_;
                                if (_e3645 > _e3650) {
                                    phi_6144_ = _e3645;
                                } else {
                                    phi_6144_ = _e3650;
                                }
                                let _e3693 = phi_6144_;
                                if (_e3655 > _e3660) {
                                    phi_6149_ = _e3655;
                                } else {
                                    phi_6149_ = _e3660;
                                }
                                let _e3696 = phi_6149_;
                                if (_e3693 > _e3696) {
                                    phi_6154_ = _e3693;
                                } else {
                                    phi_6154_ = _e3696;
                                }
                                let _e3699 = phi_6154_;
                                if (_e3690 > _e3699) {
                                    phi_6159_ = _e3690;
                                } else {
                                    phi_6159_ = _e3699;
                                }
                                let _e3702 = phi_6159_;
                                if (_e3614 < 0f) {
                                    phi_6165_ = -(_e3614);
                                } else {
                                    phi_6165_ = _e3614;
                                }
                                let _e3706 = phi_6165_;
                                if (_e3617 < 0f) {
                                    phi_6171_ = -(_e3617);
                                } else {
                                    phi_6171_ = _e3617;
                                }
                                let _e3710 = phi_6171_;
                                if (_e3620 < 0f) {
                                    phi_6178_ = -(_e3620);
                                } else {
                                    phi_6178_ = _e3620;
                                }
                                let _e3715 = phi_6178_;
                                let _e3716 = ((_e3706 + _e3710) + _e3715);
                                let _e3721 = -(_e3702);
                                if (_e3681 > _e3721) {
                                    phi_6189_ = _e3681;
                                } else {
                                    phi_6189_ = _e3721;
                                }
                                let _e3724 = phi_6189_;
                                let _e3729 = (((_e3724 - ((_e3716 * _e3486) * (0.000000059604645f * (17f / 2f)))) - (_e3716 * _e3493)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3611 > _e3729) {
                                    phi_6199_ = _e3611;
                                } else {
                                    phi_6199_ = _e3729;
                                }
                                let _e3732 = phi_6199_;
                                let _e3733 = (_e3262 - _e3247);
                                let _e3734 = (_e3263 - _e3248);
                                let _e3735 = (_e3264 - _e3249);
                                let _e3738 = ((_e3270 * _e3735) - (_e3273 * _e3734));
                                let _e3741 = ((_e3273 * _e3733) - (_e3267 * _e3735));
                                let _e3744 = ((_e3267 * _e3734) - (_e3270 * _e3733));
                                let _e3749 = (((_e3738 * _e3276[0]) + (_e3741 * _e3276[1])) + (_e3744 * _e3276[2]));
                                let _e3754 = (((_e3738 * _e3292) + (_e3741 * _e3293)) + (_e3744 * _e3294));
                                let _e3759 = (((_e3738 * _e3295) + (_e3741 * _e3296)) + (_e3744 * _e3297));
                                let _e3764 = (((_e3738 * _e3276[0]) + (_e3741 * _e3276[1])) + (_e3744 * _e3276[2]));
                                let _e3769 = (((_e3738 * _e3300[0]) + (_e3741 * _e3300[1])) + (_e3744 * _e3300[2]));
                                let _e3774 = (((_e3738 * _e3316) + (_e3741 * _e3317)) + (_e3744 * _e3318));
                                let _e3779 = (((_e3738 * _e3319) + (_e3741 * _e3320)) + (_e3744 * _e3321));
                                let _e3784 = (((_e3738 * _e3300[0]) + (_e3741 * _e3300[1])) + (_e3744 * _e3300[2]));
                                if (_e3749 < _e3754) {
                                    phi_6272_ = _e3749;
                                } else {
                                    phi_6272_ = _e3754;
                                }
                                let _e3787 = phi_6272_;
                                if (_e3759 < _e3764) {
                                    phi_6277_ = _e3759;
                                } else {
                                    phi_6277_ = _e3764;
                                }
                                let _e3790 = phi_6277_;
                                if (_e3787 < _e3790) {
                                    phi_6282_ = _e3787;
                                } else {
                                    phi_6282_ = _e3790;
                                }
                                let _e3793 = phi_6282_;
                                if (_e3769 < _e3774) {
                                    phi_6287_ = _e3769;
                                } else {
                                    phi_6287_ = _e3774;
                                }
                                let _e3796 = phi_6287_;
                                if (_e3779 < _e3784) {
                                    phi_6292_ = _e3779;
                                } else {
                                    phi_6292_ = _e3784;
                                }
                                let _e3799 = phi_6292_;
                                if (_e3796 < _e3799) {
                                    phi_6297_ = _e3796;
                                } else {
                                    phi_6297_ = _e3799;
                                }
                                let _e3802 = phi_6297_;
                                if (_e3793 < _e3802) {
                                    phi_6302_ = _e3793;
                                } else {
                                    phi_6302_ = _e3802;
                                }
                                let _e3805 = phi_6302_;
                                if (_e3749 > _e3754) {
                                    phi_6307_ = _e3749;
                                } else {
                                    phi_6307_ = _e3754;
                                }
                                let _e3808 = phi_6307_;
                                if (_e3759 > _e3764) {
                                    phi_6312_ = _e3759;
                                } else {
                                    phi_6312_ = _e3764;
                                }
                                let _e3811 = phi_6312_;
                                if (_e3808 > _e3811) {
                                    phi_6317_ = _e3808;
                                } else {
                                    phi_6317_ = _e3811;
                                }
                                let _e3814 = phi_6317_;
                                if (_e3769 > _e3774) {
                                    phi_6322_ = _e3769;
                                } else {
                                    phi_6322_ = _e3774;
                                }
                                let _e3817 = phi_6322_;
                                if (_e3779 > _e3784) {
                                    phi_6327_ = _e3779;
                                } else {
                                    phi_6327_ = _e3784;
                                }
                                let _e3820 = phi_6327_;
                                if (_e3817 > _e3820) {
                                    phi_6332_ = _e3817;
                                } else {
                                    phi_6332_ = _e3820;
                                }
                                let _e3823 = phi_6332_;
                                if (_e3814 > _e3823) {
                                    phi_6337_ = _e3814;
                                } else {
                                    phi_6337_ = _e3823;
                                }
                                let _e3826 = phi_6337_;
                                if (_e3738 < 0f) {
                                    phi_6343_ = -(_e3738);
                                } else {
                                    phi_6343_ = _e3738;
                                }
                                let _e3830 = phi_6343_;
                                if (_e3741 < 0f) {
                                    phi_6349_ = -(_e3741);
                                } else {
                                    phi_6349_ = _e3741;
                                }
                                let _e3834 = phi_6349_;
                                if (_e3744 < 0f) {
                                    phi_6356_ = -(_e3744);
                                } else {
                                    phi_6356_ = _e3744;
                                }
                                let _e3839 = phi_6356_;
                                let _e3840 = ((_e3830 + _e3834) + _e3839);
                                let _e3845 = -(_e3826);
                                if (_e3805 > _e3845) {
                                    phi_6367_ = _e3805;
                                } else {
                                    phi_6367_ = _e3845;
                                }
                                let _e3848 = phi_6367_;
                                let _e3853 = (((_e3848 - ((_e3840 * _e3486) * (0.000000059604645f * (17f / 2f)))) - (_e3840 * _e3493)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3732 > _e3853) {
                                    phi_6377_ = _e3732;
                                } else {
                                    phi_6377_ = _e3853;
                                }
                                let _e3856 = phi_6377_;
                                phi_6381_ = (_e3234 || (_e3856 > 0f));
                            }
                            let _e3860 = phi_6381_;
                            phi_6383_ = (_e2799 && _e3860);
                        } else {
                            phi_6383_ = _e2799;
                        }
                        let _e3863 = phi_6383_;
                        phi_6385_ = (_e1648 || _e3863);
                    }
                    let _e3866 = phi_6385_;
                    let _e3867 = !(_e3866);
                    if _e3867 {
                        let _e3869 = atomicAdd((&counters[0u]), 1u);
                        phi_6392_ = _e3869;
                    } else {
                        phi_6392_ = 0u;
                    }
                    let _e3871 = phi_6392_;
                    phi_6393_ = _e3871;
                    phi_6394_ = _e3867;
                } else {
                    phi_6393_ = 0u;
                    phi_6394_ = false;
                }
                let _e3873 = phi_6393_;
                let _e3875 = phi_6394_;
                phi_6395_ = _e3873;
                phi_6396_ = _e3875;
                phi_6397_ = type_12(_e138, _e141);
            } else {
                phi_6395_ = 0u;
                phi_6396_ = false;
                phi_6397_ = type_12(0u, 0u);
            }
            let _e3877 = phi_6395_;
            let _e3879 = phi_6396_;
            let _e3881 = phi_6397_;
            workgroupBarrier();
            if (_e47 == 0u) {
                let _e3884 = atomicLoad((&counters[0u]));
                let _e3886 = atomicLoad((&counters[1u]));
                if (_e3884 > 0u) {
                    let _e3889 = atomicAdd((&output.member[0u]), _e3884);
                    if ((_e3889 + _e3884) < _e3889) {
                        let _e3893 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e3889);
                }
                if (_e3886 > 0u) {
                    let _e3897 = atomicAdd((&output.member[1u]), _e3886);
                    if ((_e3897 + _e3886) < _e3897) {
                        let _e3901 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e3879 {
                let _e3903 = params.member.member_1.member_3;
                let _e3905 = atomicLoad((&counters[2u]));
                let _e3906 = (_e3905 + _e3877);
                if (_e3906 < _e3903) {
                    let _e3910 = (2u * _e3906);
                    atomicStore((&output.member[(4u + _e3910)]), _e3881.member);
                    atomicStore((&output.member[(_e3910 + 5u)]), _e3881.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_368_ = _e117;
            break if !(_e123);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_listed_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
