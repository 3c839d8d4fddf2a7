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
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
}

struct type_47 {
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
var<storage, read_write> output: type_47;
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
    var phi_335_: bool;
    var phi_339_: f32;

    if (param_12 != param_12) {
        phi_335_ = true;
    } else {
        phi_335_ = (param_13 <= param_12);
    }
    let _e6 = phi_335_;
    if _e6 {
        phi_339_ = param_13;
    } else {
        phi_339_ = param_12;
    }
    let _e8 = phi_339_;
    return _e8;
}

fn function_7(param_14: f32, param_15: f32) -> f32 {
    var phi_351_: bool;
    var phi_355_: f32;

    if (param_14 != param_14) {
        phi_351_ = true;
    } else {
        phi_351_ = (param_15 >= param_14);
    }
    let _e6 = phi_351_;
    if _e6 {
        phi_355_ = param_15;
    } else {
        phi_355_ = param_14;
    }
    let _e8 = phi_355_;
    return _e8;
}

fn function_8(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_39;
    var local_1: type_39;
    var local_2: type_39;
    var phi_409_: u32;
    var phi_458_: u32;
    var phi_459_: u32;
    var phi_467_: u32;
    var phi_483_: u32;
    var phi_506_: u32;
    var phi_507_: u32;
    var phi_510_: type_9;
    var phi_511_: type_9;
    var phi_536_: type_9;
    var phi_583_: u32;
    var phi_584_: u32;
    var phi_592_: u32;
    var phi_606_: u32;
    var phi_709_: array<u32, 2>;
    var phi_870_: bool;
    var phi_908_: type_29;
    var phi_937_: u32;
    var phi_940_: type_9;
    var phi_943_: u32;
    var phi_941_: type_9;
    var phi_966_: type_9;
    var phi_944_: u32;
    var local_3: u32;
    var phi_1155_: u32;
    var phi_1244_: type_9;
    var phi_1270_: u32;
    var phi_1273_: type_9;
    var phi_1276_: type_9;
    var phi_1274_: type_9;
    var phi_1301_: type_9;
    var phi_1318_: type_9;
    var phi_1321_: type_9;
    var phi_1322_: type_9;
    var phi_1344_: type_9;
    var phi_1378_: type_9;
    var phi_1379_: bool;
    var phi_1319_: type_9;
    var phi_1380_: bool;
    var phi_1388_: u32;
    var phi_1391_: type_9;
    var phi_1392_: type_9;
    var phi_1417_: type_9;
    var phi_1551_: bool;
    var phi_1558_: bool;
    var phi_1566_: bool;
    var phi_1585_: bool;
    var phi_1586_: bool;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1635_: bool;
    var phi_1749_: bool;
    var phi_1750_: bool;
    var phi_1791_: type_15;
    var phi_1794_: u32;
    var phi_1796_: u32;
    var phi_1817_: bool;
    var phi_1823_: type_16;
    var phi_1792_: type_15;
    var phi_1837_: type_16;
    var phi_1905_: bool;
    var phi_1906_: bool;
    var phi_1907_: bool;
    var phi_1908_: bool;
    var phi_1912_: bool;
    var phi_1918_: u32;
    var phi_1919_: u32;
    var phi_1920_: u32;
    var phi_1921_: u32;
    var phi_1922_: bool;
    var phi_1795_: u32;
    var phi_1797_: u32;
    var phi_1923_: bool;
    var local_4: u32;
    var local_5: u32;
    var phi_1971_: bool;
    var phi_1972_: bool;
    var phi_1973_: bool;
    var phi_1974_: bool;
    var phi_1978_: bool;
    var phi_1979_: bool;
    var phi_1983_: bool;
    var phi_1987_: bool;
    var phi_1988_: bool;
    var phi_1992_: bool;
    var phi_1993_: bool;
    var phi_1997_: bool;
    var phi_1998_: bool;
    var phi_2114_: bool;
    var phi_2115_: bool;
    var phi_2202_: bool;
    var phi_2203_: bool;
    var phi_2291_: bool;
    var phi_2292_: bool;
    var phi_2379_: bool;
    var phi_2380_: bool;
    var phi_2469_: bool;
    var phi_2470_: bool;
    var phi_2557_: bool;
    var phi_2558_: bool;
    var phi_2562_: bool;
    var phi_2563_: bool;
    var phi_2564_: bool;
    var phi_2568_: bool;
    var phi_2569_: bool;
    var phi_2570_: bool;
    var phi_2571_: bool;
    var phi_2572_: bool;
    var phi_2576_: bool;
    var phi_2736_: type_43;
    var phi_2783_: type_43;
    var phi_2855_: bool;
    var phi_2856_: bool;
    var phi_2861_: type_9;
    var phi_2862_: type_9;
    var phi_2885_: type_9;
    var phi_3090_: type_39;
    var phi_3370_: f32;
    var phi_3377_: f32;
    var phi_3382_: f32;
    var phi_3389_: f32;
    var phi_3394_: f32;
    var phi_3407_: f32;
    var phi_3414_: f32;
    var phi_3419_: f32;
    var phi_3426_: f32;
    var phi_3431_: f32;
    var phi_3436_: f32;
    var phi_3453_: f32;
    var phi_3460_: f32;
    var phi_3465_: f32;
    var phi_3472_: f32;
    var phi_3477_: f32;
    var phi_3491_: f32;
    var phi_3498_: f32;
    var phi_3503_: f32;
    var phi_3510_: f32;
    var phi_3515_: f32;
    var phi_3520_: f32;
    var phi_3537_: f32;
    var phi_3544_: f32;
    var phi_3549_: f32;
    var phi_3556_: f32;
    var phi_3561_: f32;
    var phi_3575_: f32;
    var phi_3582_: f32;
    var phi_3587_: f32;
    var phi_3594_: f32;
    var phi_3599_: f32;
    var phi_3604_: f32;
    var phi_3635_: f32;
    var phi_3641_: f32;
    var phi_3648_: f32;
    var phi_3655_: f32;
    var phi_3661_: f32;
    var phi_3668_: f32;
    var phi_3674_: f32;
    var phi_3680_: f32;
    var phi_3686_: f32;
    var phi_3693_: f32;
    var phi_3700_: f32;
    var phi_3724_: f32;
    var phi_3729_: f32;
    var phi_3734_: f32;
    var phi_3739_: f32;
    var phi_3744_: f32;
    var phi_3749_: f32;
    var phi_3759_: f32;
    var phi_3875_: array<f32, 3>;
    var phi_3940_: array<f32, 3>;
    var phi_3962_: f32;
    var phi_3969_: f32;
    var phi_3974_: f32;
    var phi_3981_: f32;
    var phi_3986_: f32;
    var phi_3999_: f32;
    var phi_4006_: f32;
    var phi_4011_: f32;
    var phi_4018_: f32;
    var phi_4023_: f32;
    var phi_4028_: f32;
    var phi_4045_: f32;
    var phi_4052_: f32;
    var phi_4057_: f32;
    var phi_4064_: f32;
    var phi_4069_: f32;
    var phi_4083_: f32;
    var phi_4090_: f32;
    var phi_4095_: f32;
    var phi_4102_: f32;
    var phi_4107_: f32;
    var phi_4112_: f32;
    var phi_4129_: f32;
    var phi_4136_: f32;
    var phi_4141_: f32;
    var phi_4148_: f32;
    var phi_4153_: f32;
    var phi_4167_: f32;
    var phi_4174_: f32;
    var phi_4179_: f32;
    var phi_4186_: f32;
    var phi_4191_: f32;
    var phi_4196_: f32;
    var phi_4275_: f32;
    var phi_4280_: f32;
    var phi_4285_: f32;
    var phi_4290_: f32;
    var phi_4295_: f32;
    var phi_4300_: f32;
    var phi_4305_: f32;
    var phi_4310_: f32;
    var phi_4315_: f32;
    var phi_4320_: f32;
    var phi_4325_: f32;
    var phi_4330_: f32;
    var phi_4335_: f32;
    var phi_4340_: f32;
    var phi_4346_: f32;
    var phi_4352_: f32;
    var phi_4359_: f32;
    var phi_4370_: f32;
    var phi_4441_: f32;
    var phi_4446_: f32;
    var phi_4451_: f32;
    var phi_4456_: f32;
    var phi_4461_: f32;
    var phi_4466_: f32;
    var phi_4471_: f32;
    var phi_4476_: f32;
    var phi_4481_: f32;
    var phi_4486_: f32;
    var phi_4491_: f32;
    var phi_4496_: f32;
    var phi_4501_: f32;
    var phi_4506_: f32;
    var phi_4512_: f32;
    var phi_4518_: f32;
    var phi_4525_: f32;
    var phi_4536_: f32;
    var phi_4546_: f32;
    var phi_4619_: f32;
    var phi_4624_: f32;
    var phi_4629_: f32;
    var phi_4634_: f32;
    var phi_4639_: f32;
    var phi_4644_: f32;
    var phi_4649_: f32;
    var phi_4654_: f32;
    var phi_4659_: f32;
    var phi_4664_: f32;
    var phi_4669_: f32;
    var phi_4674_: f32;
    var phi_4679_: f32;
    var phi_4684_: f32;
    var phi_4690_: f32;
    var phi_4696_: f32;
    var phi_4703_: f32;
    var phi_4714_: f32;
    var phi_4724_: f32;
    var phi_4725_: f32;
    var phi_4728_: bool;
    var phi_4735_: bool;
    var phi_4736_: bool;
    var phi_4741_: type_9;
    var phi_4742_: type_9;
    var phi_4765_: type_9;
    var phi_4970_: type_39;
    var phi_5349_: f32;
    var phi_5356_: f32;
    var phi_5361_: f32;
    var phi_5368_: f32;
    var phi_5373_: f32;
    var phi_5386_: f32;
    var phi_5393_: f32;
    var phi_5398_: f32;
    var phi_5405_: f32;
    var phi_5410_: f32;
    var phi_5415_: f32;
    var phi_5432_: f32;
    var phi_5439_: f32;
    var phi_5444_: f32;
    var phi_5451_: f32;
    var phi_5456_: f32;
    var phi_5470_: f32;
    var phi_5477_: f32;
    var phi_5482_: f32;
    var phi_5489_: f32;
    var phi_5494_: f32;
    var phi_5499_: f32;
    var phi_5516_: f32;
    var phi_5523_: f32;
    var phi_5528_: f32;
    var phi_5535_: f32;
    var phi_5540_: f32;
    var phi_5554_: f32;
    var phi_5561_: f32;
    var phi_5566_: f32;
    var phi_5573_: f32;
    var phi_5578_: f32;
    var phi_5583_: f32;
    var phi_5614_: f32;
    var phi_5620_: f32;
    var phi_5627_: f32;
    var phi_5634_: f32;
    var phi_5640_: f32;
    var phi_5647_: f32;
    var phi_5653_: f32;
    var phi_5659_: f32;
    var phi_5665_: f32;
    var phi_5672_: f32;
    var phi_5679_: f32;
    var phi_5703_: f32;
    var phi_5708_: f32;
    var phi_5713_: f32;
    var phi_5718_: f32;
    var phi_5723_: f32;
    var phi_5728_: f32;
    var phi_5738_: f32;
    var phi_5854_: array<f32, 3>;
    var phi_5919_: array<f32, 3>;
    var phi_5941_: f32;
    var phi_5948_: f32;
    var phi_5953_: f32;
    var phi_5960_: f32;
    var phi_5965_: f32;
    var phi_5978_: f32;
    var phi_5985_: f32;
    var phi_5990_: f32;
    var phi_5997_: f32;
    var phi_6002_: f32;
    var phi_6007_: f32;
    var phi_6024_: f32;
    var phi_6031_: f32;
    var phi_6036_: f32;
    var phi_6043_: f32;
    var phi_6048_: f32;
    var phi_6062_: f32;
    var phi_6069_: f32;
    var phi_6074_: f32;
    var phi_6081_: f32;
    var phi_6086_: f32;
    var phi_6091_: f32;
    var phi_6108_: f32;
    var phi_6115_: f32;
    var phi_6120_: f32;
    var phi_6127_: f32;
    var phi_6132_: f32;
    var phi_6146_: f32;
    var phi_6153_: f32;
    var phi_6158_: f32;
    var phi_6165_: f32;
    var phi_6170_: f32;
    var phi_6175_: f32;
    var phi_6254_: f32;
    var phi_6259_: f32;
    var phi_6264_: f32;
    var phi_6269_: f32;
    var phi_6274_: f32;
    var phi_6279_: f32;
    var phi_6284_: f32;
    var phi_6289_: f32;
    var phi_6294_: f32;
    var phi_6299_: f32;
    var phi_6304_: f32;
    var phi_6309_: f32;
    var phi_6314_: f32;
    var phi_6319_: f32;
    var phi_6325_: f32;
    var phi_6331_: f32;
    var phi_6338_: f32;
    var phi_6349_: f32;
    var phi_6420_: f32;
    var phi_6425_: f32;
    var phi_6430_: f32;
    var phi_6435_: f32;
    var phi_6440_: f32;
    var phi_6445_: f32;
    var phi_6450_: f32;
    var phi_6455_: f32;
    var phi_6460_: f32;
    var phi_6465_: f32;
    var phi_6470_: f32;
    var phi_6475_: f32;
    var phi_6480_: f32;
    var phi_6485_: f32;
    var phi_6491_: f32;
    var phi_6497_: f32;
    var phi_6504_: f32;
    var phi_6515_: f32;
    var phi_6525_: f32;
    var phi_6598_: f32;
    var phi_6603_: f32;
    var phi_6608_: f32;
    var phi_6613_: f32;
    var phi_6618_: f32;
    var phi_6623_: f32;
    var phi_6628_: f32;
    var phi_6633_: f32;
    var phi_6638_: f32;
    var phi_6643_: f32;
    var phi_6648_: f32;
    var phi_6653_: f32;
    var phi_6658_: f32;
    var phi_6663_: f32;
    var phi_6669_: f32;
    var phi_6675_: f32;
    var phi_6682_: f32;
    var phi_6693_: f32;
    var phi_6703_: f32;
    var phi_6704_: f32;
    var phi_6707_: bool;
    var phi_6952_: f32;
    var phi_6959_: f32;
    var phi_6964_: f32;
    var phi_6971_: f32;
    var phi_6976_: f32;
    var phi_6989_: f32;
    var phi_6996_: f32;
    var phi_7001_: f32;
    var phi_7008_: f32;
    var phi_7013_: f32;
    var phi_7018_: f32;
    var phi_7035_: f32;
    var phi_7042_: f32;
    var phi_7047_: f32;
    var phi_7054_: f32;
    var phi_7059_: f32;
    var phi_7073_: f32;
    var phi_7080_: f32;
    var phi_7085_: f32;
    var phi_7092_: f32;
    var phi_7097_: f32;
    var phi_7102_: f32;
    var phi_7119_: f32;
    var phi_7126_: f32;
    var phi_7131_: f32;
    var phi_7138_: f32;
    var phi_7143_: f32;
    var phi_7157_: f32;
    var phi_7164_: f32;
    var phi_7169_: f32;
    var phi_7176_: f32;
    var phi_7181_: f32;
    var phi_7186_: f32;
    var phi_7217_: f32;
    var phi_7223_: f32;
    var phi_7230_: f32;
    var phi_7237_: f32;
    var phi_7243_: f32;
    var phi_7250_: f32;
    var phi_7256_: f32;
    var phi_7262_: f32;
    var phi_7268_: f32;
    var phi_7275_: f32;
    var phi_7282_: f32;
    var phi_7306_: f32;
    var phi_7311_: f32;
    var phi_7316_: f32;
    var phi_7321_: f32;
    var phi_7326_: f32;
    var phi_7331_: f32;
    var phi_7341_: f32;
    var phi_7457_: array<f32, 3>;
    var phi_7522_: array<f32, 3>;
    var phi_7544_: f32;
    var phi_7551_: f32;
    var phi_7556_: f32;
    var phi_7563_: f32;
    var phi_7568_: f32;
    var phi_7581_: f32;
    var phi_7588_: f32;
    var phi_7593_: f32;
    var phi_7600_: f32;
    var phi_7605_: f32;
    var phi_7610_: f32;
    var phi_7627_: f32;
    var phi_7634_: f32;
    var phi_7639_: f32;
    var phi_7646_: f32;
    var phi_7651_: f32;
    var phi_7665_: f32;
    var phi_7672_: f32;
    var phi_7677_: f32;
    var phi_7684_: f32;
    var phi_7689_: f32;
    var phi_7694_: f32;
    var phi_7711_: f32;
    var phi_7718_: f32;
    var phi_7723_: f32;
    var phi_7730_: f32;
    var phi_7735_: f32;
    var phi_7749_: f32;
    var phi_7756_: f32;
    var phi_7761_: f32;
    var phi_7768_: f32;
    var phi_7773_: f32;
    var phi_7778_: f32;
    var phi_7857_: f32;
    var phi_7862_: f32;
    var phi_7867_: f32;
    var phi_7872_: f32;
    var phi_7877_: f32;
    var phi_7882_: f32;
    var phi_7887_: f32;
    var phi_7892_: f32;
    var phi_7897_: f32;
    var phi_7902_: f32;
    var phi_7907_: f32;
    var phi_7912_: f32;
    var phi_7917_: f32;
    var phi_7922_: f32;
    var phi_7928_: f32;
    var phi_7934_: f32;
    var phi_7941_: f32;
    var phi_7952_: f32;
    var phi_8023_: f32;
    var phi_8028_: f32;
    var phi_8033_: f32;
    var phi_8038_: f32;
    var phi_8043_: f32;
    var phi_8048_: f32;
    var phi_8053_: f32;
    var phi_8058_: f32;
    var phi_8063_: f32;
    var phi_8068_: f32;
    var phi_8073_: f32;
    var phi_8078_: f32;
    var phi_8083_: f32;
    var phi_8088_: f32;
    var phi_8094_: f32;
    var phi_8100_: f32;
    var phi_8107_: f32;
    var phi_8118_: f32;
    var phi_8128_: f32;
    var phi_8201_: f32;
    var phi_8206_: f32;
    var phi_8211_: f32;
    var phi_8216_: f32;
    var phi_8221_: f32;
    var phi_8226_: f32;
    var phi_8231_: f32;
    var phi_8236_: f32;
    var phi_8241_: f32;
    var phi_8246_: f32;
    var phi_8251_: f32;
    var phi_8256_: f32;
    var phi_8261_: f32;
    var phi_8266_: f32;
    var phi_8272_: f32;
    var phi_8278_: f32;
    var phi_8285_: f32;
    var phi_8296_: f32;
    var phi_8306_: f32;
    var phi_8307_: f32;
    var phi_8310_: bool;
    var phi_8312_: bool;
    var phi_8322_: bool;
    var phi_8323_: bool;
    var phi_8359_: type_9;
    var phi_8360_: type_9;
    var phi_8383_: type_9;
    var phi_8407_: u32;
    var phi_8478_: bool;
    var phi_8479_: bool;
    var phi_1277_: type_9;
    var local_6: u32;
    var local_7: type_9;
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
        phi_409_ = _e96;
    } else {
        phi_409_ = _e98;
    }
    let _e101 = phi_409_;
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
            phi_458_ = (_e116 + 1u);
        } else {
            phi_458_ = _e116;
        }
        let _e122 = phi_458_;
        phi_459_ = _e122;
    } else {
        phi_459_ = 0u;
    }
    let _e124 = phi_459_;
    let _e127 = params.member.member_2.member_4;
    if (_e127 < _e124) {
        phi_467_ = _e127;
    } else {
        phi_467_ = _e124;
    }
    let _e130 = phi_467_;
    let _e131 = (_e130 / 4u);
    if ((_e130 % 4u) > 0u) {
        phi_483_ = (_e131 + 1u);
    } else {
        phi_483_ = _e131;
    }
    let _e136 = phi_483_;
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
            phi_506_ = (_e140 + 1u);
        } else {
            phi_506_ = _e140;
        }
        let _e146 = phi_506_;
        phi_507_ = _e146;
    } else {
        phi_507_ = 0u;
    }
    let _e148 = phi_507_;
    phi_510_ = type_9(0u, _e148);
    loop {
        let _e151 = phi_510_;
        if (_e151.member < _e151.member_1) {
            phi_511_ = type_9((_e151.member + 1u), _e151.member_1);
            phi_536_ = type_9(1u, _e151.member);
        } else {
            phi_511_ = _e151;
            phi_536_ = type_9(0u, type_9().member_1);
        }
        let _e163 = phi_511_;
        let _e165 = phi_536_;
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
                    phi_583_ = (_e187 + 1u);
                } else {
                    phi_583_ = _e187;
                }
                let _e193 = phi_583_;
                phi_584_ = _e193;
            } else {
                phi_584_ = 0u;
            }
            let _e195 = phi_584_;
            let _e198 = params.member.member_2.member_4;
            if (_e198 < _e195) {
                phi_592_ = _e198;
            } else {
                phi_592_ = _e195;
            }
            let _e201 = phi_592_;
            let _e202 = (_e174 < _e201);
            let _e205 = params.member.member_1.member_1;
            let _e208 = params.member.member_2.member_3;
            if _e202 {
                phi_606_ = (_e174 * _e208);
            } else {
                phi_606_ = 0u;
            }
            let _e211 = phi_606_;
            let _e213 = (2u * (_e205 + _e211));
            let _e216 = input.member[(4u + _e213)];
            let _e219 = input.member[(_e213 + 5u)];
            if (_e73 <= 7u) {
                atomicStore((&counters[_e73]), 0u);
            }
            workgroupBarrier();
            if ((_e73 % 32u) == 0u) {
                let _e225 = (_e73 / 32u);
                let _e231 = params.member.member_2.member[0u][0u];
                firsts[(2u * _e225)] = (_e231 + (_e216 * 32u));
                let _e240 = params.member.member_2.member[0u][2u];
                firsts[((2u * _e225) + 1u)] = (_e240 + (_e219 * 32u));
            }
            let _e245 = params.member.member_2.member_1;
            if (_e245 == 0u) {
                phi_709_ = array<u32, 2>(0u, 2u);
            } else {
                phi_709_ = array<u32, 2>(1u, 1u);
            }
            let _e248 = phi_709_;
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
                phi_870_ = ((((((_e306.member.x <= _e282.member_1.y) && (_e282.member.x <= _e306.member_1.y)) && (_e306.member.y <= _e282.member_2.x)) && (_e282.member.y <= _e306.member_2.x)) && (_e306.member_1.x <= _e282.member_2.y)) && (_e282.member_1.x <= _e306.member_2.y));
            } else {
                phi_870_ = false;
            }
            let _e358 = phi_870_;
            if _e202 {
                if ((((((_e333.member.x <= _e261.member_1.y) && (_e261.member.x <= _e333.member_1.y)) && (_e333.member.y <= _e261.member_2.x)) && (_e261.member.y <= _e333.member_2.x)) && (_e333.member_1.x <= _e261.member_2.y)) && (_e261.member_1.x <= _e333.member_2.y)) {
                    let _e372 = atomicAdd((&counters[_e251]), 1u);
                    let _e373 = ((_e251 * 32u) + _e372);
                    columns[_e373] = type_29(array<f32, 3>(_e333.member.x, _e333.member.y, _e333.member_1.x), array<f32, 3>(_e333.member_1.y, _e333.member_2.x, _e333.member_2.y));
                    names[_e373] = _e252;
                }
            }
            if _e358 {
                phi_908_ = type_29(array<f32, 3>(_e306.member.x, _e306.member.y, _e306.member_1.x), array<f32, 3>(_e306.member_1.y, _e306.member_2.x, _e306.member_2.y));
            } else {
                phi_908_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e380 = phi_908_;
            workgroupBarrier();
            let _e381 = (_e73 / 32u);
            let _e382 = (_e381 * 32u);
            let _e384 = atomicLoad((&counters[_e381]));
            let _e385 = (_e384 / 4u);
            if ((_e384 % 4u) > 0u) {
                phi_937_ = (_e385 + 1u);
            } else {
                phi_937_ = _e385;
            }
            let _e390 = phi_937_;
            phi_940_ = type_9(0u, _e390);
            phi_943_ = 0u;
            loop {
                let _e393 = phi_940_;
                let _e395 = phi_943_;
                local_3 = _e395;
                local_6 = _e395;
                if (_e393.member < _e393.member_1) {
                    phi_941_ = type_9((_e393.member + 1u), _e393.member_1);
                    phi_966_ = type_9(1u, _e393.member);
                } else {
                    phi_941_ = _e393;
                    phi_966_ = type_9(0u, type_9().member_1);
                }
                let _e407 = phi_941_;
                let _e409 = phi_966_;
                let _e413 = (bitcast<i32>(_e409.member) != 0i);
                if _e413 {
                    let _e414 = (4u * _e409.member_1);
                    let _e417 = columns[(_e382 + _e414)];
                    let _e456 = columns[((_e382 + _e414) + 1u)];
                    let _e497 = columns[((_e382 + _e414) + 2u)];
                    let _e538 = columns[((_e382 + _e414) + 3u)];
                    phi_944_ = (_e395 | ((((select(0u, 1u, ((((((_e380.member[0] <= _e417.member_1[0]) && (_e417.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e417.member_1[1])) && (_e417.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e417.member_1[2])) && (_e417.member[2] <= _e380.member_1[2]))) << bitcast<u32>((_e414 & 31u))) | (select(0u, 1u, ((((((_e380.member[0] <= _e456.member_1[0]) && (_e456.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e456.member_1[1])) && (_e456.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e456.member_1[2])) && (_e456.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e414 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e380.member[0] <= _e497.member_1[0]) && (_e497.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e497.member_1[1])) && (_e497.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e497.member_1[2])) && (_e497.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e414 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e380.member[0] <= _e538.member_1[0]) && (_e538.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e538.member_1[1])) && (_e538.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e538.member_1[2])) && (_e538.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e414 + 3u) & 31u)))));
                } else {
                    phi_944_ = u32();
                }
                let _e578 = phi_944_;
                continue;
                continuing {
                    phi_940_ = _e407;
                    phi_943_ = _e578;
                    break if !(_e413);
                }
            }
            if (_e384 < 32u) {
                let _e586 = local_3;
                phi_1155_ = (_e586 & ((1u << bitcast<u32>((_e384 & 31u))) - 1u));
            } else {
                let _e5440 = local_6;
                phi_1155_ = _e5440;
            }
            let _e589 = phi_1155_;
            let _e591 = countOneBits(_e589);
            if (_e591 > 0u) {
                let _e594 = atomicAdd((&counters[4u]), _e591);
                phi_1244_ = type_9(_e589, _e594);
            } else {
                phi_1244_ = type_9(_e589, 0u);
            }
            let _e597 = phi_1244_;
            workgroupBarrier();
            if (_e73 == 0u) {
                let _e600 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e600;
            }
            let _e603 = workgroupUniformLoad((&n_hits[0u]));
            let _e604 = (_e603 / 512u);
            if ((_e603 % 512u) > 0u) {
                phi_1270_ = (_e604 + 1u);
            } else {
                phi_1270_ = _e604;
            }
            let _e609 = phi_1270_;
            phi_1273_ = type_9(0u, _e609);
            phi_1276_ = _e597;
            loop {
                let _e612 = phi_1273_;
                let _e614 = phi_1276_;
                if (_e612.member < _e612.member_1) {
                    phi_1274_ = type_9((_e612.member + 1u), _e612.member_1);
                    phi_1301_ = type_9(1u, _e612.member);
                } else {
                    phi_1274_ = _e612;
                    phi_1301_ = type_9(0u, type_9().member_1);
                }
                let _e626 = phi_1274_;
                let _e628 = phi_1301_;
                let _e632 = (bitcast<i32>(_e628.member) != 0i);
                if _e632 {
                    let _e633 = (_e73 / 32u);
                    let _e635 = (_e628.member_1 * 512u);
                    phi_1318_ = _e614;
                    phi_1321_ = type_9(0u, countOneBits(_e614.member));
                    loop {
                        let _e640 = phi_1318_;
                        let _e642 = phi_1321_;
                        local_7 = _e640;
                        if (_e642.member < _e642.member_1) {
                            phi_1322_ = type_9((_e642.member + 1u), _e642.member_1);
                            phi_1344_ = type_9(1u, _e642.member);
                        } else {
                            phi_1322_ = _e642;
                            phi_1344_ = type_9(0u, type_9().member_1);
                        }
                        let _e654 = phi_1322_;
                        let _e656 = phi_1344_;
                        if (bitcast<i32>(_e656.member) != 0i) {
                            let _e661 = (_e640.member_1 - _e635);
                            if (_e661 >= 512u) {
                                phi_1378_ = type_9();
                                phi_1379_ = false;
                            } else {
                                let _e670 = names[((_e633 * 32u) + select(firstTrailingBit(_e640.member), 32u, (_e640.member == 0u)))];
                                hits[_e661] = (((_e633 << bitcast<u32>(10i)) | ((_e73 % 32u) << bitcast<u32>(5i))) | _e670);
                                phi_1378_ = type_9((_e640.member & (_e640.member - 1u)), (_e640.member_1 + 1u));
                                phi_1379_ = true;
                            }
                            let _e686 = phi_1378_;
                            let _e688 = phi_1379_;
                            phi_1319_ = _e686;
                            phi_1380_ = _e688;
                        } else {
                            phi_1319_ = type_9();
                            phi_1380_ = false;
                        }
                        let _e690 = phi_1319_;
                        let _e692 = phi_1380_;
                        continue;
                        continuing {
                            phi_1318_ = _e690;
                            phi_1321_ = _e654;
                            break if !(_e692);
                        }
                    }
                    workgroupBarrier();
                    let _e695 = n_hits[0u];
                    let _e696 = (_e695 - _e635);
                    if (512u < _e696) {
                        phi_1388_ = 512u;
                    } else {
                        phi_1388_ = _e696;
                    }
                    let _e699 = phi_1388_;
                    phi_1391_ = type_9(0u, 4u);
                    loop {
                        let _e701 = phi_1391_;
                        if (_e701.member < _e701.member_1) {
                            phi_1392_ = type_9((_e701.member + 1u), _e701.member_1);
                            phi_1417_ = type_9(1u, _e701.member);
                        } else {
                            phi_1392_ = _e701;
                            phi_1417_ = type_9(0u, type_9().member_1);
                        }
                        let _e713 = phi_1392_;
                        let _e715 = phi_1417_;
                        if (bitcast<i32>(_e715.member) != 0i) {
                            let _e721 = (_e73 + (_e715.member_1 * 128u));
                            if (_e721 >= _e699) {
                                phi_2855_ = false;
                            } else {
                                let _e724 = hits[_e721];
                                let _e727 = ((_e724 >> bitcast<u32>(10i)) & 3u);
                                let _e734 = firsts[(2u * _e727)];
                                let _e739 = firsts[((2u * _e727) + 1u)];
                                let _e742 = leaves.member[(_e734 + ((_e724 >> bitcast<u32>(5i)) & 31u))];
                                let _e748 = leaves.member[(_e739 + (_e724 & 31u))];
                                let _e755 = ((_e724 >> bitcast<u32>(10i)) & 3u);
                                let _e762 = firsts[(2u * _e755)];
                                let _e767 = firsts[((2u * _e755) + 1u)];
                                let _e770 = nodes.member[(_e762 + ((_e724 >> bitcast<u32>(5i)) & 31u))];
                                let _e784 = nodes.member[(_e767 + (_e724 & 31u))];
                                if ((_e91.member_1 & 1u) != 0u) {
                                    if (_e748.x == _e742.x) {
                                        phi_1551_ = true;
                                    } else {
                                        phi_1551_ = (_e748.x == _e742.x);
                                    }
                                    let _e803 = phi_1551_;
                                    if (_e748.y == _e742.x) {
                                        phi_1558_ = true;
                                    } else {
                                        phi_1558_ = (_e748.y == _e742.x);
                                    }
                                    let _e807 = phi_1558_;
                                    if (_e748.z == _e742.x) {
                                        phi_1566_ = true;
                                    } else {
                                        phi_1566_ = (_e748.z == _e742.x);
                                    }
                                    let _e812 = phi_1566_;
                                    if ((_e803 || _e807) || _e812) {
                                        phi_1585_ = false;
                                    } else {
                                        phi_1585_ = true;
                                    }
                                    let _e815 = phi_1585_;
                                    phi_1586_ = _e815;
                                } else {
                                    phi_1586_ = true;
                                }
                                let _e817 = phi_1586_;
                                if _e817 {
                                    if ((_e91.member_1 & 2u) != 0u) {
                                        let _e822 = bodies.member[_e742.x];
                                        let _e824 = bodies.member[_e748.x];
                                        if ((_e822 / 4u) != (_e824 / 4u)) {
                                            phi_1628_ = true;
                                        } else {
                                            if ((_e822 & 2u) == 0u) {
                                                phi_1627_ = false;
                                            } else {
                                                phi_1627_ = true;
                                            }
                                            let _e831 = phi_1627_;
                                            phi_1628_ = _e831;
                                        }
                                        let _e833 = phi_1628_;
                                        if _e833 {
                                            phi_1635_ = (((_e822 & _e824) & 1u) == 0u);
                                        } else {
                                            phi_1635_ = false;
                                        }
                                        let _e838 = phi_1635_;
                                        if _e838 {
                                            if ((_e91.member_1 & 4u) != 0u) {
                                                let _e845 = bodies.member[_e91.member[0]];
                                                let _e848 = bodies.member[(_e91.member[0] + 1u)];
                                                let _e853 = ((_e91.member[0] + 4u) + (2u * (_e822 >> bitcast<u32>(2i))));
                                                let _e858 = ((_e91.member[0] + 4u) + (2u * (_e824 >> bitcast<u32>(2i))));
                                                let _e860 = bodies.member[_e853];
                                                let _e862 = bodies.member[_e858];
                                                let _e871 = bodies.member[((((_e91.member[0] + 4u) + (2u * _e845)) + (_e860 * _e848)) + (_e862 / 32u))];
                                                let _e874 = bodies.member[(_e853 + 1u)];
                                                let _e877 = bodies.member[(_e858 + 1u)];
                                                if (_e874 == _e877) {
                                                    if (((_e871 >> bitcast<u32>(((_e862 % 32u) & 31u))) & 1u) == 1u) {
                                                        phi_1749_ = true;
                                                    } else {
                                                        phi_1749_ = ((_e822 >> bitcast<u32>(2i)) == (_e824 >> bitcast<u32>(2i)));
                                                    }
                                                    let _e891 = phi_1749_;
                                                    phi_1750_ = _e891;
                                                } else {
                                                    phi_1750_ = false;
                                                }
                                                let _e893 = phi_1750_;
                                                if _e893 {
                                                    let _e896 = bodies.member[(_e91.member[0] + 2u)];
                                                    let _e899 = bodies.member[(_e91.member[0] + 3u)];
                                                    let _e900 = (_e899 + _e91.member[0]);
                                                    phi_1791_ = type_15(0i, 32i);
                                                    phi_1794_ = _e896;
                                                    phi_1796_ = 0u;
                                                    loop {
                                                        let _e902 = phi_1791_;
                                                        let _e904 = phi_1794_;
                                                        let _e906 = phi_1796_;
                                                        local_4 = _e906;
                                                        local_5 = _e906;
                                                        if (_e902.member < _e902.member_1) {
                                                            let _e913 = (_e902.member + 1i);
                                                            if ((false == (_e913 > _e902.member)) != false) {
                                                                phi_1817_ = true;
                                                            } else {
                                                                phi_1817_ = false;
                                                            }
                                                            let _e918 = phi_1817_;
                                                            if _e918 {
                                                                phi_1823_ = type_16(0u, type_16().member_1);
                                                            } else {
                                                                phi_1823_ = type_16(1u, _e913);
                                                            }
                                                            let _e923 = phi_1823_;
                                                            phi_1792_ = type_15(_e923.member_1, _e902.member_1);
                                                            phi_1837_ = type_16(1u, _e902.member);
                                                        } else {
                                                            phi_1792_ = _e902;
                                                            phi_1837_ = type_16(0u, type_16().member_1);
                                                        }
                                                        let _e929 = phi_1792_;
                                                        let _e931 = phi_1837_;
                                                        if (bitcast<i32>(_e931.member) != 0i) {
                                                            if (_e906 >= _e904) {
                                                                phi_1920_ = u32();
                                                                phi_1921_ = u32();
                                                                phi_1922_ = false;
                                                            } else {
                                                                let _e938 = (_e906 + ((_e904 - _e906) / 2u));
                                                                let _e940 = (_e900 + (3u * _e938));
                                                                let _e942 = bodies.member[_e940];
                                                                let _e945 = bodies.member[(_e940 + 1u)];
                                                                let _e948 = bodies.member[(_e940 + 2u)];
                                                                if (_e942 == 0u) {
                                                                    if (_e945 < _e742.w) {
                                                                        phi_1907_ = false;
                                                                    } else {
                                                                        if (_e945 == _e742.w) {
                                                                            if (_e948 < _e748.w) {
                                                                                phi_1905_ = false;
                                                                            } else {
                                                                                phi_1905_ = true;
                                                                            }
                                                                            let _e954 = phi_1905_;
                                                                            phi_1906_ = _e954;
                                                                        } else {
                                                                            phi_1906_ = true;
                                                                        }
                                                                        let _e956 = phi_1906_;
                                                                        phi_1907_ = _e956;
                                                                    }
                                                                    let _e958 = phi_1907_;
                                                                    phi_1908_ = _e958;
                                                                } else {
                                                                    phi_1908_ = true;
                                                                }
                                                                let _e960 = phi_1908_;
                                                                if _e960 {
                                                                    phi_1912_ = false;
                                                                } else {
                                                                    phi_1912_ = true;
                                                                }
                                                                let _e962 = phi_1912_;
                                                                if _e962 {
                                                                    phi_1918_ = _e904;
                                                                    phi_1919_ = (_e938 + 1u);
                                                                } else {
                                                                    phi_1918_ = _e938;
                                                                    phi_1919_ = _e906;
                                                                }
                                                                let _e965 = phi_1918_;
                                                                let _e967 = phi_1919_;
                                                                phi_1920_ = _e965;
                                                                phi_1921_ = _e967;
                                                                phi_1922_ = true;
                                                            }
                                                            let _e969 = phi_1920_;
                                                            let _e971 = phi_1921_;
                                                            let _e973 = phi_1922_;
                                                            phi_1795_ = _e969;
                                                            phi_1797_ = _e971;
                                                            phi_1923_ = _e973;
                                                        } else {
                                                            phi_1795_ = u32();
                                                            phi_1797_ = u32();
                                                            phi_1923_ = false;
                                                        }
                                                        let _e975 = phi_1795_;
                                                        let _e977 = phi_1797_;
                                                        let _e979 = phi_1923_;
                                                        continue;
                                                        continuing {
                                                            phi_1791_ = _e929;
                                                            phi_1794_ = _e975;
                                                            phi_1796_ = _e977;
                                                            break if !(_e979);
                                                        }
                                                    }
                                                    let _e982 = local_4;
                                                    if (_e982 < _e896) {
                                                        let _e985 = local_5;
                                                        let _e987 = (_e900 + (3u * _e985));
                                                        let _e989 = bodies.member[_e987];
                                                        if (_e989 == 0u) {
                                                            let _e993 = bodies.member[(_e987 + 1u)];
                                                            if (_e993 == _e742.w) {
                                                                let _e997 = bodies.member[(_e987 + 2u)];
                                                                phi_1971_ = (_e997 == _e748.w);
                                                                phi_1972_ = false;
                                                            } else {
                                                                phi_1971_ = bool();
                                                                phi_1972_ = true;
                                                            }
                                                            let _e1000 = phi_1971_;
                                                            let _e1002 = phi_1972_;
                                                            phi_1973_ = _e1000;
                                                            phi_1974_ = _e1002;
                                                        } else {
                                                            phi_1973_ = bool();
                                                            phi_1974_ = true;
                                                        }
                                                        let _e1004 = phi_1973_;
                                                        let _e1006 = phi_1974_;
                                                        if _e1006 {
                                                            phi_1978_ = false;
                                                        } else {
                                                            phi_1978_ = _e1004;
                                                        }
                                                        let _e1008 = phi_1978_;
                                                        phi_1979_ = _e1008;
                                                    } else {
                                                        phi_1979_ = false;
                                                    }
                                                    let _e1010 = phi_1979_;
                                                    phi_1983_ = _e1010;
                                                } else {
                                                    phi_1983_ = true;
                                                }
                                                let _e1012 = phi_1983_;
                                                if _e1012 {
                                                    phi_1987_ = false;
                                                } else {
                                                    phi_1987_ = true;
                                                }
                                                let _e1014 = phi_1987_;
                                                phi_1988_ = _e1014;
                                            } else {
                                                phi_1988_ = true;
                                            }
                                            let _e1016 = phi_1988_;
                                            if _e1016 {
                                                phi_1992_ = false;
                                            } else {
                                                phi_1992_ = true;
                                            }
                                            let _e1018 = phi_1992_;
                                            phi_1993_ = _e1018;
                                        } else {
                                            phi_1993_ = true;
                                        }
                                        let _e1020 = phi_1993_;
                                        if _e1020 {
                                            phi_1997_ = false;
                                        } else {
                                            phi_1997_ = true;
                                        }
                                        let _e1022 = phi_1997_;
                                        phi_1998_ = _e1022;
                                    } else {
                                        phi_1998_ = true;
                                    }
                                    let _e1024 = phi_1998_;
                                    if _e1024 {
                                        if ((_e91.member_1 & 32u) != 0u) {
                                            let _e1045 = (((((_e770.member_1.y - _e784.member.x) > _e91.member_6) && ((_e784.member_1.y - _e770.member.x) > _e91.member_6)) && (((_e770.member_2.x - _e784.member.y) > _e91.member_6) && ((_e784.member_2.x - _e770.member.y) > _e91.member_6))) && (((_e770.member_2.y - _e784.member_1.x) > _e91.member_6) && ((_e784.member_2.y - _e770.member_1.x) > _e91.member_6)));
                                            if _e1045 {
                                                phi_2562_ = bool();
                                            } else {
                                                let _e1047 = keys.member[_e742.x];
                                                let _e1050 = keys.member[_e742.y];
                                                let _e1052 = function_(_e1047[0], _e1050[0]);
                                                let _e1054 = keys.member[_e742.z];
                                                let _e1056 = function_(_e1052, _e1054[0]);
                                                let _e1058 = keys.member[_e748.x];
                                                let _e1061 = keys.member[_e748.y];
                                                let _e1063 = function_1(_e1058[3], _e1061[3]);
                                                let _e1065 = keys.member[_e748.z];
                                                let _e1067 = function_1(_e1063, _e1065[3]);
                                                if (_e1056[1] > _e1067[1]) {
                                                    phi_2115_ = true;
                                                } else {
                                                    if (_e1056[1] == _e1067[1]) {
                                                        phi_2114_ = (_e1056[0] > _e1067[0]);
                                                    } else {
                                                        phi_2114_ = false;
                                                    }
                                                    let _e1078 = phi_2114_;
                                                    phi_2115_ = _e1078;
                                                }
                                                let _e1080 = phi_2115_;
                                                let _e1083 = keys.member[_e748.x];
                                                let _e1086 = keys.member[_e748.y];
                                                let _e1088 = function_(_e1083[0], _e1086[0]);
                                                let _e1090 = keys.member[_e748.z];
                                                let _e1092 = function_(_e1088, _e1090[0]);
                                                let _e1094 = keys.member[_e742.x];
                                                let _e1097 = keys.member[_e742.y];
                                                let _e1099 = function_1(_e1094[3], _e1097[3]);
                                                let _e1101 = keys.member[_e742.z];
                                                let _e1103 = function_1(_e1099, _e1101[3]);
                                                if (_e1092[1] > _e1103[1]) {
                                                    phi_2203_ = true;
                                                } else {
                                                    if (_e1092[1] == _e1103[1]) {
                                                        phi_2202_ = (_e1092[0] > _e1103[0]);
                                                    } else {
                                                        phi_2202_ = false;
                                                    }
                                                    let _e1114 = phi_2202_;
                                                    phi_2203_ = _e1114;
                                                }
                                                let _e1116 = phi_2203_;
                                                let _e1120 = keys.member[_e742.x];
                                                let _e1123 = keys.member[_e742.y];
                                                let _e1125 = function_2(_e1120[1], _e1123[1]);
                                                let _e1127 = keys.member[_e742.z];
                                                let _e1129 = function_2(_e1125, _e1127[1]);
                                                let _e1131 = keys.member[_e748.x];
                                                let _e1134 = keys.member[_e748.y];
                                                let _e1136 = function_3(_e1131[4], _e1134[4]);
                                                let _e1138 = keys.member[_e748.z];
                                                let _e1140 = function_3(_e1136, _e1138[4]);
                                                if (_e1129[1] > _e1140[1]) {
                                                    phi_2292_ = true;
                                                } else {
                                                    if (_e1129[1] == _e1140[1]) {
                                                        phi_2291_ = (_e1129[0] > _e1140[0]);
                                                    } else {
                                                        phi_2291_ = false;
                                                    }
                                                    let _e1151 = phi_2291_;
                                                    phi_2292_ = _e1151;
                                                }
                                                let _e1153 = phi_2292_;
                                                let _e1156 = keys.member[_e748.x];
                                                let _e1159 = keys.member[_e748.y];
                                                let _e1161 = function_2(_e1156[1], _e1159[1]);
                                                let _e1163 = keys.member[_e748.z];
                                                let _e1165 = function_2(_e1161, _e1163[1]);
                                                let _e1167 = keys.member[_e742.x];
                                                let _e1170 = keys.member[_e742.y];
                                                let _e1172 = function_3(_e1167[4], _e1170[4]);
                                                let _e1174 = keys.member[_e742.z];
                                                let _e1176 = function_3(_e1172, _e1174[4]);
                                                if (_e1165[1] > _e1176[1]) {
                                                    phi_2380_ = true;
                                                } else {
                                                    if (_e1165[1] == _e1176[1]) {
                                                        phi_2379_ = (_e1165[0] > _e1176[0]);
                                                    } else {
                                                        phi_2379_ = false;
                                                    }
                                                    let _e1187 = phi_2379_;
                                                    phi_2380_ = _e1187;
                                                }
                                                let _e1189 = phi_2380_;
                                                let _e1194 = keys.member[_e742.x];
                                                let _e1197 = keys.member[_e742.y];
                                                let _e1199 = function_4(_e1194[2], _e1197[2]);
                                                let _e1201 = keys.member[_e742.z];
                                                let _e1203 = function_4(_e1199, _e1201[2]);
                                                let _e1205 = keys.member[_e748.x];
                                                let _e1208 = keys.member[_e748.y];
                                                let _e1210 = function_5(_e1205[5], _e1208[5]);
                                                let _e1212 = keys.member[_e748.z];
                                                let _e1214 = function_5(_e1210, _e1212[5]);
                                                if (_e1203[1] > _e1214[1]) {
                                                    phi_2470_ = true;
                                                } else {
                                                    if (_e1203[1] == _e1214[1]) {
                                                        phi_2469_ = (_e1203[0] > _e1214[0]);
                                                    } else {
                                                        phi_2469_ = false;
                                                    }
                                                    let _e1225 = phi_2469_;
                                                    phi_2470_ = _e1225;
                                                }
                                                let _e1227 = phi_2470_;
                                                let _e1230 = keys.member[_e748.x];
                                                let _e1233 = keys.member[_e748.y];
                                                let _e1235 = function_4(_e1230[2], _e1233[2]);
                                                let _e1237 = keys.member[_e748.z];
                                                let _e1239 = function_4(_e1235, _e1237[2]);
                                                let _e1241 = keys.member[_e742.x];
                                                let _e1244 = keys.member[_e742.y];
                                                let _e1246 = function_5(_e1241[5], _e1244[5]);
                                                let _e1248 = keys.member[_e742.z];
                                                let _e1250 = function_5(_e1246, _e1248[5]);
                                                if (_e1239[1] > _e1250[1]) {
                                                    phi_2558_ = true;
                                                } else {
                                                    if (_e1239[1] == _e1250[1]) {
                                                        phi_2557_ = (_e1239[0] > _e1250[0]);
                                                    } else {
                                                        phi_2557_ = false;
                                                    }
                                                    let _e1261 = phi_2557_;
                                                    phi_2558_ = _e1261;
                                                }
                                                let _e1263 = phi_2558_;
                                                phi_2562_ = (((!(_e1080) && !(_e1116)) && (!(_e1153) && !(_e1189))) && (!(_e1227) && !(_e1263)));
                                            }
                                            let _e1268 = phi_2562_;
                                            phi_2563_ = _e1268;
                                            phi_2564_ = _e1045;
                                        } else {
                                            phi_2563_ = bool();
                                            phi_2564_ = true;
                                        }
                                        let _e1270 = phi_2563_;
                                        let _e1272 = phi_2564_;
                                        if _e1272 {
                                            phi_2568_ = false;
                                        } else {
                                            phi_2568_ = true;
                                        }
                                        let _e1274 = phi_2568_;
                                        phi_2569_ = _e1270;
                                        phi_2570_ = _e1274;
                                    } else {
                                        phi_2569_ = false;
                                        phi_2570_ = true;
                                    }
                                    let _e1276 = phi_2569_;
                                    let _e1278 = phi_2570_;
                                    phi_2571_ = _e1276;
                                    phi_2572_ = _e1278;
                                } else {
                                    phi_2571_ = false;
                                    phi_2572_ = true;
                                }
                                let _e1280 = phi_2571_;
                                let _e1282 = phi_2572_;
                                if _e1282 {
                                    phi_2576_ = _e1280;
                                } else {
                                    phi_2576_ = true;
                                }
                                let _e1284 = phi_2576_;
                                if _e1284 {
                                    let _e1286 = atomicAdd((&counters[9u]), 1u);
                                }
                                if _e1284 {
                                    let _e1288 = paths.member[_e742.x];
                                    let _e1302 = paths.member[_e748.x];
                                    let _e1316 = paths.member[_e748.y];
                                    let _e1330 = paths.member[_e748.z];
                                    let _e1343 = array<f32, 3>(_e1288.member.x, _e1288.member.y, _e1288.member.z);
                                    let _e1344 = array<f32, 3>(_e1288.member_1.x, _e1288.member_1.y, _e1288.member_1.z);
                                    let _e1349 = (((_e91.member_5 + (2f * _e91.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                                    if false {
                                        let _e1373 = function_6(_e1288.member.x, _e1302.member.x);
                                        let _e1374 = function_6(_e1288.member.y, _e1302.member.y);
                                        let _e1375 = function_6(_e1288.member.z, _e1302.member.z);
                                        let _e1377 = function_7(_e1288.member.x, _e1302.member.x);
                                        let _e1378 = function_7(_e1288.member.y, _e1302.member.y);
                                        let _e1379 = function_7(_e1288.member.z, _e1302.member.z);
                                        let _e1382 = function_6(_e1316.member.x, _e1330.member.x);
                                        let _e1383 = function_6(_e1316.member.y, _e1330.member.y);
                                        let _e1384 = function_6(_e1316.member.z, _e1330.member.z);
                                        let _e1386 = function_7(_e1316.member.x, _e1330.member.x);
                                        let _e1387 = function_7(_e1316.member.y, _e1330.member.y);
                                        let _e1388 = function_7(_e1316.member.z, _e1330.member.z);
                                        phi_2736_ = type_43(array<array<f32, 3>, 2>(array<f32, 3>(_e1373, _e1374, _e1375), array<f32, 3>(_e1377, _e1378, _e1379)), array<array<f32, 3>, 2>(array<f32, 3>(_e1382, _e1383, _e1384), array<f32, 3>(_e1386, _e1387, _e1388)));
                                    } else {
                                        let _e1350 = function_6(_e1302.member.x, _e1316.member.x);
                                        let _e1351 = function_6(_e1302.member.y, _e1316.member.y);
                                        let _e1352 = function_6(_e1302.member.z, _e1316.member.z);
                                        let _e1353 = function_7(_e1302.member.x, _e1316.member.x);
                                        let _e1354 = function_7(_e1302.member.y, _e1316.member.y);
                                        let _e1355 = function_7(_e1302.member.z, _e1316.member.z);
                                        let _e1357 = function_6(_e1350, _e1330.member.x);
                                        let _e1358 = function_6(_e1351, _e1330.member.y);
                                        let _e1359 = function_6(_e1352, _e1330.member.z);
                                        let _e1361 = function_7(_e1350, _e1330.member.x);
                                        let _e1362 = function_7(_e1351, _e1330.member.y);
                                        let _e1363 = function_7(_e1352, _e1330.member.z);
                                        let _e1364 = function_6(_e1353, _e1330.member.x);
                                        let _e1365 = function_6(_e1354, _e1330.member.y);
                                        let _e1366 = function_6(_e1355, _e1330.member.z);
                                        let _e1367 = function_7(_e1353, _e1330.member.x);
                                        let _e1368 = function_7(_e1354, _e1330.member.y);
                                        let _e1369 = function_7(_e1355, _e1330.member.z);
                                        phi_2736_ = type_43(array<array<f32, 3>, 2>(_e1343, _e1343), array<array<f32, 3>, 2>(array<f32, 3>(_e1357, _e1358, _e1359), array<f32, 3>(_e1367, _e1368, _e1369)));
                                    }
                                    let _e1393 = phi_2736_;
                                    if false {
                                        let _e1417 = function_6(_e1288.member_1.x, _e1302.member_1.x);
                                        let _e1418 = function_6(_e1288.member_1.y, _e1302.member_1.y);
                                        let _e1419 = function_6(_e1288.member_1.z, _e1302.member_1.z);
                                        let _e1421 = function_7(_e1288.member_1.x, _e1302.member_1.x);
                                        let _e1422 = function_7(_e1288.member_1.y, _e1302.member_1.y);
                                        let _e1423 = function_7(_e1288.member_1.z, _e1302.member_1.z);
                                        let _e1426 = function_6(_e1316.member_1.x, _e1330.member_1.x);
                                        let _e1427 = function_6(_e1316.member_1.y, _e1330.member_1.y);
                                        let _e1428 = function_6(_e1316.member_1.z, _e1330.member_1.z);
                                        let _e1430 = function_7(_e1316.member_1.x, _e1330.member_1.x);
                                        let _e1431 = function_7(_e1316.member_1.y, _e1330.member_1.y);
                                        let _e1432 = function_7(_e1316.member_1.z, _e1330.member_1.z);
                                        phi_2783_ = type_43(array<array<f32, 3>, 2>(array<f32, 3>(_e1417, _e1418, _e1419), array<f32, 3>(_e1421, _e1422, _e1423)), array<array<f32, 3>, 2>(array<f32, 3>(_e1426, _e1427, _e1428), array<f32, 3>(_e1430, _e1431, _e1432)));
                                    } else {
                                        let _e1394 = function_6(_e1302.member_1.x, _e1316.member_1.x);
                                        let _e1395 = function_6(_e1302.member_1.y, _e1316.member_1.y);
                                        let _e1396 = function_6(_e1302.member_1.z, _e1316.member_1.z);
                                        let _e1397 = function_7(_e1302.member_1.x, _e1316.member_1.x);
                                        let _e1398 = function_7(_e1302.member_1.y, _e1316.member_1.y);
                                        let _e1399 = function_7(_e1302.member_1.z, _e1316.member_1.z);
                                        let _e1401 = function_6(_e1394, _e1330.member_1.x);
                                        let _e1402 = function_6(_e1395, _e1330.member_1.y);
                                        let _e1403 = function_6(_e1396, _e1330.member_1.z);
                                        let _e1405 = function_7(_e1394, _e1330.member_1.x);
                                        let _e1406 = function_7(_e1395, _e1330.member_1.y);
                                        let _e1407 = function_7(_e1396, _e1330.member_1.z);
                                        let _e1408 = function_6(_e1397, _e1330.member_1.x);
                                        let _e1409 = function_6(_e1398, _e1330.member_1.y);
                                        let _e1410 = function_6(_e1399, _e1330.member_1.z);
                                        let _e1411 = function_7(_e1397, _e1330.member_1.x);
                                        let _e1412 = function_7(_e1398, _e1330.member_1.y);
                                        let _e1413 = function_7(_e1399, _e1330.member_1.z);
                                        phi_2783_ = type_43(array<array<f32, 3>, 2>(_e1344, _e1344), array<array<f32, 3>, 2>(array<f32, 3>(_e1401, _e1402, _e1403), array<f32, 3>(_e1411, _e1412, _e1413)));
                                    }
                                    let _e1437 = phi_2783_;
                                    if !(((((((_e1393.member[0][0] - _e1393.member_1[1][0]) > _e1349) && ((_e1437.member[0][0] - _e1437.member_1[1][0]) > _e1349)) || (((_e1393.member_1[0][0] - _e1393.member[1][0]) > _e1349) && ((_e1437.member_1[0][0] - _e1437.member[1][0]) > _e1349))) || ((((_e1393.member[0][1] - _e1393.member_1[1][1]) > _e1349) && ((_e1437.member[0][1] - _e1437.member_1[1][1]) > _e1349)) || (((_e1393.member_1[0][1] - _e1393.member[1][1]) > _e1349) && ((_e1437.member_1[0][1] - _e1437.member[1][1]) > _e1349)))) || ((((_e1393.member[0][2] - _e1393.member_1[1][2]) > _e1349) && ((_e1437.member[0][2] - _e1437.member_1[1][2]) > _e1349)) || (((_e1393.member_1[0][2] - _e1393.member[1][2]) > _e1349) && ((_e1437.member_1[0][2] - _e1437.member[1][2]) > _e1349))))) {
                                        let _e1527 = atomicAdd((&counters[5u]), 1u);
                                        left[_e1527] = _e724;
                                    }
                                }
                                phi_2855_ = true;
                            }
                            let _e1530 = phi_2855_;
                            phi_2856_ = _e1530;
                        } else {
                            phi_2856_ = false;
                        }
                        let _e1532 = phi_2856_;
                        continue;
                        continuing {
                            phi_1391_ = _e713;
                            break if !(_e1532);
                        }
                    }
                    workgroupBarrier();
                    let _e1535 = atomicLoad((&counters[5u]));
                    phi_2861_ = type_9(0u, 4u);
                    loop {
                        let _e1537 = phi_2861_;
                        if (_e1537.member < _e1537.member_1) {
                            phi_2862_ = type_9((_e1537.member + 1u), _e1537.member_1);
                            phi_2885_ = type_9(1u, _e1537.member);
                        } else {
                            phi_2862_ = _e1537;
                            phi_2885_ = type_9(0u, type_9().member_1);
                        }
                        let _e1549 = phi_2862_;
                        let _e1551 = phi_2885_;
                        if (bitcast<i32>(_e1551.member) != 0i) {
                            let _e1557 = (_e73 + (_e1551.member_1 * 128u));
                            if (_e1557 >= _e1535) {
                                phi_4735_ = false;
                            } else {
                                let _e1560 = left[_e1557];
                                let _e1563 = ((_e1560 >> bitcast<u32>(10i)) & 3u);
                                let _e1570 = firsts[(2u * _e1563)];
                                let _e1575 = firsts[((2u * _e1563) + 1u)];
                                let _e1578 = leaves.member[(_e1570 + ((_e1560 >> bitcast<u32>(5i)) & 31u))];
                                let _e1581 = leaves.member[(_e1575 + (_e1560 & 31u))];
                                let _e1586 = paths.member[_e1578.x];
                                let _e1600 = paths.member[_e1581.x];
                                let _e1614 = paths.member[_e1581.y];
                                let _e1628 = paths.member[_e1581.z];
                                if false {
                                    phi_3090_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1614.member.x - _e1586.member.x), (_e1614.member.y - _e1586.member.y), (_e1614.member.z - _e1586.member.z)), array<f32, 3>((_e1614.member_1.x - _e1586.member_1.x), (_e1614.member_1.y - _e1586.member_1.y), (_e1614.member_1.z - _e1586.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1600.member.x - _e1586.member.x), (_e1600.member.y - _e1586.member.y), (_e1600.member.z - _e1586.member.z)), array<f32, 3>((_e1600.member_1.x - _e1586.member_1.x), (_e1600.member_1.y - _e1586.member_1.y), (_e1600.member_1.z - _e1586.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1614.member.x - _e1628.member.x), (_e1614.member.y - _e1628.member.y), (_e1614.member.z - _e1628.member.z)), array<f32, 3>((_e1614.member_1.x - _e1628.member_1.x), (_e1614.member_1.y - _e1628.member_1.y), (_e1614.member_1.z - _e1628.member_1.z))), (_e91.member_4 + _e91.member_4));
                                } else {
                                    phi_3090_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1586.member.x - _e1600.member.x), (_e1586.member.y - _e1600.member.y), (_e1586.member.z - _e1600.member.z)), array<f32, 3>((_e1586.member_1.x - _e1600.member_1.x), (_e1586.member_1.y - _e1600.member_1.y), (_e1586.member_1.z - _e1600.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1614.member.x - _e1600.member.x), (_e1614.member.y - _e1600.member.y), (_e1614.member.z - _e1600.member.z)), array<f32, 3>((_e1614.member_1.x - _e1600.member_1.x), (_e1614.member_1.y - _e1600.member_1.y), (_e1614.member_1.z - _e1600.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1628.member.x - _e1600.member.x), (_e1628.member.y - _e1600.member.y), (_e1628.member.z - _e1600.member.z)), array<f32, 3>((_e1628.member_1.x - _e1600.member_1.x), (_e1628.member_1.y - _e1600.member_1.y), (_e1628.member_1.z - _e1600.member_1.z))), (_e91.member_4 + _e91.member_4));
                                }
                                let _e1700 = phi_3090_;
                                local_2 = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e1700.member[0][0], _e1700.member[0][1], _e1700.member[0][2]), array<f32, 3>(_e1700.member[1][0], _e1700.member[1][1], _e1700.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1700.member_1[0][0], _e1700.member_1[0][1], _e1700.member_1[0][2]), array<f32, 3>(_e1700.member_1[1][0], _e1700.member_1[1][1], _e1700.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1700.member_2[0][0], _e1700.member_2[0][1], _e1700.member_2[0][2]), array<f32, 3>(_e1700.member_2[1][0], _e1700.member_2[1][1], _e1700.member_2[1][2])), _e1700.member_3);
                                let _e1741 = local_2.member_1[0u];
                                let _e1747 = local_2.member_2[0u];
                                let _e1753 = ((_e1741[1] * _e1747[2]) - (_e1741[2] * _e1747[1]));
                                let _e1756 = ((_e1741[2] * _e1747[0]) - (_e1741[0] * _e1747[2]));
                                let _e1759 = ((_e1741[0] * _e1747[1]) - (_e1741[1] * _e1747[0]));
                                let _e1762 = local_2.member_1[1u];
                                let _e1768 = local_2.member_2[1u];
                                let _e1774 = ((_e1762[1] * _e1768[2]) - (_e1762[2] * _e1768[1]));
                                let _e1777 = ((_e1762[2] * _e1768[0]) - (_e1762[0] * _e1768[2]));
                                let _e1780 = ((_e1762[0] * _e1768[1]) - (_e1762[1] * _e1768[0]));
                                let _e1783 = local_2.member_1[0u];
                                let _e1789 = local_2.member_2[1u];
                                let _e1804 = local_2.member_1[1u];
                                let _e1810 = local_2.member_2[0u];
                                let _e1823 = (((_e1783[1] * _e1789[2]) - (_e1783[2] * _e1789[1])) + ((_e1804[1] * _e1810[2]) - (_e1804[2] * _e1810[1])));
                                let _e1824 = (((_e1783[2] * _e1789[0]) - (_e1783[0] * _e1789[2])) + ((_e1804[2] * _e1810[0]) - (_e1804[0] * _e1810[2])));
                                let _e1825 = (((_e1783[0] * _e1789[1]) - (_e1783[1] * _e1789[0])) + ((_e1804[0] * _e1810[1]) - (_e1804[1] * _e1810[0])));
                                let _e1828 = local_2.member[0u];
                                let _e1839 = local_2.member[1u];
                                let _e1850 = local_2.member[0u];
                                let _e1859 = ((((_e1839[0] * _e1753) + (_e1839[1] * _e1756)) + (_e1839[2] * _e1759)) + (((_e1850[0] * _e1823) + (_e1850[1] * _e1824)) + (_e1850[2] * _e1825)));
                                let _e1862 = local_2.member[0u];
                                let _e1873 = local_2.member[1u];
                                let _e1882 = ((((_e1862[0] * _e1774) + (_e1862[1] * _e1777)) + (_e1862[2] * _e1780)) + (((_e1873[0] * _e1823) + (_e1873[1] * _e1824)) + (_e1873[2] * _e1825)));
                                let _e1885 = local_2.member[1u];
                                let _e1896 = local_2.member[0u];
                                if (_e1896[0] < 0f) {
                                    phi_3370_ = -(_e1896[0]);
                                } else {
                                    phi_3370_ = _e1896[0];
                                }
                                let _e1903 = phi_3370_;
                                if (_e1896[1] < 0f) {
                                    phi_3377_ = -(_e1896[1]);
                                } else {
                                    phi_3377_ = _e1896[1];
                                }
                                let _e1907 = phi_3377_;
                                if (_e1903 > _e1907) {
                                    phi_3382_ = _e1903;
                                } else {
                                    phi_3382_ = _e1907;
                                }
                                let _e1910 = phi_3382_;
                                if (_e1896[2] < 0f) {
                                    phi_3389_ = -(_e1896[2]);
                                } else {
                                    phi_3389_ = _e1896[2];
                                }
                                let _e1914 = phi_3389_;
                                if (_e1910 > _e1914) {
                                    phi_3394_ = _e1910;
                                } else {
                                    phi_3394_ = _e1914;
                                }
                                let _e1917 = phi_3394_;
                                let _e1920 = local_2.member[1u];
                                if (_e1920[0] < 0f) {
                                    phi_3407_ = -(_e1920[0]);
                                } else {
                                    phi_3407_ = _e1920[0];
                                }
                                let _e1927 = phi_3407_;
                                if (_e1920[1] < 0f) {
                                    phi_3414_ = -(_e1920[1]);
                                } else {
                                    phi_3414_ = _e1920[1];
                                }
                                let _e1931 = phi_3414_;
                                if (_e1927 > _e1931) {
                                    phi_3419_ = _e1927;
                                } else {
                                    phi_3419_ = _e1931;
                                }
                                let _e1934 = phi_3419_;
                                if (_e1920[2] < 0f) {
                                    phi_3426_ = -(_e1920[2]);
                                } else {
                                    phi_3426_ = _e1920[2];
                                }
                                let _e1938 = phi_3426_;
                                if (_e1934 > _e1938) {
                                    phi_3431_ = _e1934;
                                } else {
                                    phi_3431_ = _e1938;
                                }
                                let _e1941 = phi_3431_;
                                if (_e1917 > _e1941) {
                                    phi_3436_ = _e1917;
                                } else {
                                    phi_3436_ = _e1941;
                                }
                                let _e1944 = phi_3436_;
                                let _e1946 = local_2.member_3;
                                let _e1947 = (_e1944 + _e1946);
                                let _e1950 = local_2.member_1[0u];
                                if (_e1950[0] < 0f) {
                                    phi_3453_ = -(_e1950[0]);
                                } else {
                                    phi_3453_ = _e1950[0];
                                }
                                let _e1957 = phi_3453_;
                                if (_e1950[1] < 0f) {
                                    phi_3460_ = -(_e1950[1]);
                                } else {
                                    phi_3460_ = _e1950[1];
                                }
                                let _e1961 = phi_3460_;
                                if (_e1957 > _e1961) {
                                    phi_3465_ = _e1957;
                                } else {
                                    phi_3465_ = _e1961;
                                }
                                let _e1964 = phi_3465_;
                                if (_e1950[2] < 0f) {
                                    phi_3472_ = -(_e1950[2]);
                                } else {
                                    phi_3472_ = _e1950[2];
                                }
                                let _e1968 = phi_3472_;
                                if (_e1964 > _e1968) {
                                    phi_3477_ = _e1964;
                                } else {
                                    phi_3477_ = _e1968;
                                }
                                let _e1971 = phi_3477_;
                                let _e1974 = local_2.member_1[1u];
                                if (_e1974[0] < 0f) {
                                    phi_3491_ = -(_e1974[0]);
                                } else {
                                    phi_3491_ = _e1974[0];
                                }
                                let _e1981 = phi_3491_;
                                if (_e1974[1] < 0f) {
                                    phi_3498_ = -(_e1974[1]);
                                } else {
                                    phi_3498_ = _e1974[1];
                                }
                                let _e1985 = phi_3498_;
                                if (_e1981 > _e1985) {
                                    phi_3503_ = _e1981;
                                } else {
                                    phi_3503_ = _e1985;
                                }
                                let _e1988 = phi_3503_;
                                if (_e1974[2] < 0f) {
                                    phi_3510_ = -(_e1974[2]);
                                } else {
                                    phi_3510_ = _e1974[2];
                                }
                                let _e1992 = phi_3510_;
                                if (_e1988 > _e1992) {
                                    phi_3515_ = _e1988;
                                } else {
                                    phi_3515_ = _e1992;
                                }
                                let _e1995 = phi_3515_;
                                if (_e1971 > _e1995) {
                                    phi_3520_ = _e1971;
                                } else {
                                    phi_3520_ = _e1995;
                                }
                                let _e1998 = phi_3520_;
                                let _e2000 = local_2.member_3;
                                let _e2001 = (_e1998 + _e2000);
                                let _e2004 = local_2.member_2[0u];
                                if (_e2004[0] < 0f) {
                                    phi_3537_ = -(_e2004[0]);
                                } else {
                                    phi_3537_ = _e2004[0];
                                }
                                let _e2011 = phi_3537_;
                                if (_e2004[1] < 0f) {
                                    phi_3544_ = -(_e2004[1]);
                                } else {
                                    phi_3544_ = _e2004[1];
                                }
                                let _e2015 = phi_3544_;
                                if (_e2011 > _e2015) {
                                    phi_3549_ = _e2011;
                                } else {
                                    phi_3549_ = _e2015;
                                }
                                let _e2018 = phi_3549_;
                                if (_e2004[2] < 0f) {
                                    phi_3556_ = -(_e2004[2]);
                                } else {
                                    phi_3556_ = _e2004[2];
                                }
                                let _e2022 = phi_3556_;
                                if (_e2018 > _e2022) {
                                    phi_3561_ = _e2018;
                                } else {
                                    phi_3561_ = _e2022;
                                }
                                let _e2025 = phi_3561_;
                                let _e2028 = local_2.member_2[1u];
                                if (_e2028[0] < 0f) {
                                    phi_3575_ = -(_e2028[0]);
                                } else {
                                    phi_3575_ = _e2028[0];
                                }
                                let _e2035 = phi_3575_;
                                if (_e2028[1] < 0f) {
                                    phi_3582_ = -(_e2028[1]);
                                } else {
                                    phi_3582_ = _e2028[1];
                                }
                                let _e2039 = phi_3582_;
                                if (_e2035 > _e2039) {
                                    phi_3587_ = _e2035;
                                } else {
                                    phi_3587_ = _e2039;
                                }
                                let _e2042 = phi_3587_;
                                if (_e2028[2] < 0f) {
                                    phi_3594_ = -(_e2028[2]);
                                } else {
                                    phi_3594_ = _e2028[2];
                                }
                                let _e2046 = phi_3594_;
                                if (_e2042 > _e2046) {
                                    phi_3599_ = _e2042;
                                } else {
                                    phi_3599_ = _e2046;
                                }
                                let _e2049 = phi_3599_;
                                if (_e2025 > _e2049) {
                                    phi_3604_ = _e2025;
                                } else {
                                    phi_3604_ = _e2049;
                                }
                                let _e2052 = phi_3604_;
                                let _e2054 = local_2.member_3;
                                let _e2055 = (_e2052 + _e2054);
                                let _e2057 = ((_e2001 * 8f) * _e2055);
                                let _e2064 = local_2.member_3;
                                if (_e1753 < 0f) {
                                    phi_3635_ = -(_e1753);
                                } else {
                                    phi_3635_ = _e1753;
                                }
                                let _e2081 = phi_3635_;
                                if (_e1756 < 0f) {
                                    phi_3641_ = -(_e1756);
                                } else {
                                    phi_3641_ = _e1756;
                                }
                                let _e2085 = phi_3641_;
                                if (_e1759 < 0f) {
                                    phi_3648_ = -(_e1759);
                                } else {
                                    phi_3648_ = _e1759;
                                }
                                let _e2090 = phi_3648_;
                                let _e2091 = ((_e2081 + _e2085) + _e2090);
                                if (_e1774 < 0f) {
                                    phi_3655_ = -(_e1774);
                                } else {
                                    phi_3655_ = _e1774;
                                }
                                let _e2095 = phi_3655_;
                                if (_e1777 < 0f) {
                                    phi_3661_ = -(_e1777);
                                } else {
                                    phi_3661_ = _e1777;
                                }
                                let _e2099 = phi_3661_;
                                if (_e1780 < 0f) {
                                    phi_3668_ = -(_e1780);
                                } else {
                                    phi_3668_ = _e1780;
                                }
                                let _e2104 = phi_3668_;
                                let _e2105 = ((_e2095 + _e2099) + _e2104);
                                if (_e2091 > _e2105) {
                                    phi_3674_ = _e2091;
                                } else {
                                    phi_3674_ = _e2105;
                                }
                                let _e2108 = phi_3674_;
                                if (_e1823 < 0f) {
                                    phi_3680_ = -(_e1823);
                                } else {
                                    phi_3680_ = _e1823;
                                }
                                let _e2112 = phi_3680_;
                                if (_e1824 < 0f) {
                                    phi_3686_ = -(_e1824);
                                } else {
                                    phi_3686_ = _e1824;
                                }
                                let _e2116 = phi_3686_;
                                if (_e1825 < 0f) {
                                    phi_3693_ = -(_e1825);
                                } else {
                                    phi_3693_ = _e1825;
                                }
                                let _e2121 = phi_3693_;
                                let _e2123 = (((_e2112 + _e2116) + _e2121) * 0.5f);
                                if (_e2108 > _e2123) {
                                    phi_3700_ = _e2108;
                                } else {
                                    phi_3700_ = _e2123;
                                }
                                let _e2126 = phi_3700_;
                                let _e2131 = local_2.member_3;
                                let _e2144 = ((((_e1828[0] * _e1753) + (_e1828[1] * _e1756)) + (_e1828[2] * _e1759)) * 3f);
                                let _e2145 = ((((_e1885[0] * _e1774) + (_e1885[1] * _e1777)) + (_e1885[2] * _e1780)) * 3f);
                                if (_e2144 < _e2145) {
                                    phi_3724_ = _e2144;
                                } else {
                                    phi_3724_ = _e2145;
                                }
                                let _e2148 = phi_3724_;
                                if (_e1859 < _e1882) {
                                    phi_3729_ = _e1859;
                                } else {
                                    phi_3729_ = _e1882;
                                }
                                let _e2151 = phi_3729_;
                                if (_e2148 < _e2151) {
                                    phi_3734_ = _e2148;
                                } else {
                                    phi_3734_ = _e2151;
                                }
                                let _e2154 = phi_3734_;
                                if (_e2144 > _e2145) {
                                    phi_3739_ = _e2144;
                                } else {
                                    phi_3739_ = _e2145;
                                }
                                let _e2157 = phi_3739_;
                                if (_e1859 > _e1882) {
                                    phi_3744_ = _e1859;
                                } else {
                                    phi_3744_ = _e1882;
                                }
                                let _e2160 = phi_3744_;
                                if (_e2157 > _e2160) {
                                    phi_3749_ = _e2157;
                                } else {
                                    phi_3749_ = _e2160;
                                }
                                let _e2163 = phi_3749_;
                                let _e2168 = -(_e2163);
                                if (_e2154 > _e2168) {
                                    phi_3759_ = _e2154;
                                } else {
                                    phi_3759_ = _e2168;
                                }
                                let _e2171 = phi_3759_;
                                let _e2173 = ((_e2171 - ((((((_e1947 * 8f) * _e2057) * (0.000000059604645f * (524f / 64f))) + ((_e2064 * 19f) * ((_e1947 * (_e2001 + _e2055)) + (_e2001 * _e2055)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1947) * ((1f + _e2001) * (1f + _e2055))))) + ((_e91.member_5 * (((_e2126 + (_e2057 * (0.000000059604645f * 8f))) + ((_e2131 * 6f) * (_e2001 + _e2055))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2001) * (1f + _e2055))))) * (3f * 1.0001f)))) > 0f);
                                if _e2173 {
                                    phi_4728_ = _e2173;
                                } else {
                                    let _e2176 = local_2.member_1[0u];
                                    let _e2182 = local_2.member_1[1u];
                                    let _e2186 = (_e2176[0] + _e2182[0]);
                                    let _e2187 = (_e2176[1] + _e2182[1]);
                                    let _e2188 = (_e2176[2] + _e2182[2]);
                                    let _e2191 = local_2.member_2[0u];
                                    let _e2197 = local_2.member_2[1u];
                                    let _e2201 = (_e2191[0] + _e2197[0]);
                                    let _e2202 = (_e2191[1] + _e2197[1]);
                                    let _e2203 = (_e2191[2] + _e2197[2]);
                                    let _e2206 = ((_e2187 * _e2203) - (_e2188 * _e2202));
                                    let _e2209 = ((_e2188 * _e2201) - (_e2186 * _e2203));
                                    let _e2212 = ((_e2186 * _e2202) - (_e2187 * _e2201));
                                    let _e2215 = local_2.member[0u];
                                    let _e2222 = local_2.member_1[0u];
                                    let _e2228 = local_2.member_2[0u];
                                    let _e2232 = (_e2215[0] - _e2222[0]);
                                    let _e2233 = (_e2215[1] - _e2222[1]);
                                    let _e2234 = (_e2215[2] - _e2222[2]);
                                    if true {
                                        phi_3875_ = array<f32, 3>(_e2215[0], _e2215[1], _e2215[2]);
                                    } else {
                                        phi_3875_ = array<f32, 3>((_e2232 - _e2228[0]), (_e2233 - _e2228[1]), (_e2234 - _e2228[2]));
                                    }
                                    let _e2240 = phi_3875_;
                                    let _e2241 = (_e2215[0] - _e2228[0]);
                                    let _e2242 = (_e2215[1] - _e2228[1]);
                                    let _e2243 = (_e2215[2] - _e2228[2]);
                                    let _e2246 = local_2.member[1u];
                                    let _e2253 = local_2.member_1[1u];
                                    let _e2259 = local_2.member_2[1u];
                                    let _e2263 = (_e2246[0] - _e2253[0]);
                                    let _e2264 = (_e2246[1] - _e2253[1]);
                                    let _e2265 = (_e2246[2] - _e2253[2]);
                                    if true {
                                        phi_3940_ = array<f32, 3>(_e2246[0], _e2246[1], _e2246[2]);
                                    } else {
                                        phi_3940_ = array<f32, 3>((_e2263 - _e2259[0]), (_e2264 - _e2259[1]), (_e2265 - _e2259[2]));
                                    }
                                    let _e2271 = phi_3940_;
                                    let _e2272 = (_e2246[0] - _e2259[0]);
                                    let _e2273 = (_e2246[1] - _e2259[1]);
                                    let _e2274 = (_e2246[2] - _e2259[2]);
                                    let _e2277 = local_2.member[0u];
                                    if (_e2277[0] < 0f) {
                                        phi_3962_ = -(_e2277[0]);
                                    } else {
                                        phi_3962_ = _e2277[0];
                                    }
                                    let _e2284 = phi_3962_;
                                    if (_e2277[1] < 0f) {
                                        phi_3969_ = -(_e2277[1]);
                                    } else {
                                        phi_3969_ = _e2277[1];
                                    }
                                    let _e2288 = phi_3969_;
                                    if (_e2284 > _e2288) {
                                        phi_3974_ = _e2284;
                                    } else {
                                        phi_3974_ = _e2288;
                                    }
                                    let _e2291 = phi_3974_;
                                    if (_e2277[2] < 0f) {
                                        phi_3981_ = -(_e2277[2]);
                                    } else {
                                        phi_3981_ = _e2277[2];
                                    }
                                    let _e2295 = phi_3981_;
                                    if (_e2291 > _e2295) {
                                        phi_3986_ = _e2291;
                                    } else {
                                        phi_3986_ = _e2295;
                                    }
                                    let _e2298 = phi_3986_;
                                    let _e2301 = local_2.member[1u];
                                    if (_e2301[0] < 0f) {
                                        phi_3999_ = -(_e2301[0]);
                                    } else {
                                        phi_3999_ = _e2301[0];
                                    }
                                    let _e2308 = phi_3999_;
                                    if (_e2301[1] < 0f) {
                                        phi_4006_ = -(_e2301[1]);
                                    } else {
                                        phi_4006_ = _e2301[1];
                                    }
                                    let _e2312 = phi_4006_;
                                    if (_e2308 > _e2312) {
                                        phi_4011_ = _e2308;
                                    } else {
                                        phi_4011_ = _e2312;
                                    }
                                    let _e2315 = phi_4011_;
                                    if (_e2301[2] < 0f) {
                                        phi_4018_ = -(_e2301[2]);
                                    } else {
                                        phi_4018_ = _e2301[2];
                                    }
                                    let _e2319 = phi_4018_;
                                    if (_e2315 > _e2319) {
                                        phi_4023_ = _e2315;
                                    } else {
                                        phi_4023_ = _e2319;
                                    }
                                    let _e2322 = phi_4023_;
                                    if (_e2298 > _e2322) {
                                        phi_4028_ = _e2298;
                                    } else {
                                        phi_4028_ = _e2322;
                                    }
                                    let _e2325 = phi_4028_;
                                    let _e2327 = local_2.member_3;
                                    let _e2331 = local_2.member_1[0u];
                                    if (_e2331[0] < 0f) {
                                        phi_4045_ = -(_e2331[0]);
                                    } else {
                                        phi_4045_ = _e2331[0];
                                    }
                                    let _e2338 = phi_4045_;
                                    if (_e2331[1] < 0f) {
                                        phi_4052_ = -(_e2331[1]);
                                    } else {
                                        phi_4052_ = _e2331[1];
                                    }
                                    let _e2342 = phi_4052_;
                                    if (_e2338 > _e2342) {
                                        phi_4057_ = _e2338;
                                    } else {
                                        phi_4057_ = _e2342;
                                    }
                                    let _e2345 = phi_4057_;
                                    if (_e2331[2] < 0f) {
                                        phi_4064_ = -(_e2331[2]);
                                    } else {
                                        phi_4064_ = _e2331[2];
                                    }
                                    let _e2349 = phi_4064_;
                                    if (_e2345 > _e2349) {
                                        phi_4069_ = _e2345;
                                    } else {
                                        phi_4069_ = _e2349;
                                    }
                                    let _e2352 = phi_4069_;
                                    let _e2355 = local_2.member_1[1u];
                                    if (_e2355[0] < 0f) {
                                        phi_4083_ = -(_e2355[0]);
                                    } else {
                                        phi_4083_ = _e2355[0];
                                    }
                                    let _e2362 = phi_4083_;
                                    if (_e2355[1] < 0f) {
                                        phi_4090_ = -(_e2355[1]);
                                    } else {
                                        phi_4090_ = _e2355[1];
                                    }
                                    let _e2366 = phi_4090_;
                                    if (_e2362 > _e2366) {
                                        phi_4095_ = _e2362;
                                    } else {
                                        phi_4095_ = _e2366;
                                    }
                                    let _e2369 = phi_4095_;
                                    if (_e2355[2] < 0f) {
                                        phi_4102_ = -(_e2355[2]);
                                    } else {
                                        phi_4102_ = _e2355[2];
                                    }
                                    let _e2373 = phi_4102_;
                                    if (_e2369 > _e2373) {
                                        phi_4107_ = _e2369;
                                    } else {
                                        phi_4107_ = _e2373;
                                    }
                                    let _e2376 = phi_4107_;
                                    if (_e2352 > _e2376) {
                                        phi_4112_ = _e2352;
                                    } else {
                                        phi_4112_ = _e2376;
                                    }
                                    let _e2379 = phi_4112_;
                                    let _e2381 = local_2.member_3;
                                    let _e2385 = local_2.member_2[0u];
                                    if (_e2385[0] < 0f) {
                                        phi_4129_ = -(_e2385[0]);
                                    } else {
                                        phi_4129_ = _e2385[0];
                                    }
                                    let _e2392 = phi_4129_;
                                    if (_e2385[1] < 0f) {
                                        phi_4136_ = -(_e2385[1]);
                                    } else {
                                        phi_4136_ = _e2385[1];
                                    }
                                    let _e2396 = phi_4136_;
                                    if (_e2392 > _e2396) {
                                        phi_4141_ = _e2392;
                                    } else {
                                        phi_4141_ = _e2396;
                                    }
                                    let _e2399 = phi_4141_;
                                    if (_e2385[2] < 0f) {
                                        phi_4148_ = -(_e2385[2]);
                                    } else {
                                        phi_4148_ = _e2385[2];
                                    }
                                    let _e2403 = phi_4148_;
                                    if (_e2399 > _e2403) {
                                        phi_4153_ = _e2399;
                                    } else {
                                        phi_4153_ = _e2403;
                                    }
                                    let _e2406 = phi_4153_;
                                    let _e2409 = local_2.member_2[1u];
                                    if (_e2409[0] < 0f) {
                                        phi_4167_ = -(_e2409[0]);
                                    } else {
                                        phi_4167_ = _e2409[0];
                                    }
                                    let _e2416 = phi_4167_;
                                    if (_e2409[1] < 0f) {
                                        phi_4174_ = -(_e2409[1]);
                                    } else {
                                        phi_4174_ = _e2409[1];
                                    }
                                    let _e2420 = phi_4174_;
                                    if (_e2416 > _e2420) {
                                        phi_4179_ = _e2416;
                                    } else {
                                        phi_4179_ = _e2420;
                                    }
                                    let _e2423 = phi_4179_;
                                    if (_e2409[2] < 0f) {
                                        phi_4186_ = -(_e2409[2]);
                                    } else {
                                        phi_4186_ = _e2409[2];
                                    }
                                    let _e2427 = phi_4186_;
                                    if (_e2423 > _e2427) {
                                        phi_4191_ = _e2423;
                                    } else {
                                        phi_4191_ = _e2427;
                                    }
                                    let _e2430 = phi_4191_;
                                    if (_e2406 > _e2430) {
                                        phi_4196_ = _e2406;
                                    } else {
                                        phi_4196_ = _e2430;
                                    }
                                    let _e2433 = phi_4196_;
                                    let _e2435 = local_2.member_3;
                                    let _e2439 = ((((_e2325 + _e2327) + (_e2379 + _e2381)) + (_e2433 + _e2435)) * 2f);
                                    let _e2442 = local_2.member_3;
                                    let _e2446 = (((_e91.member_5 * 1.0001f) + (_e2442 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e2449 = ((_e2209 * _e2188) - (_e2212 * _e2187));
                                    let _e2452 = ((_e2212 * _e2186) - (_e2206 * _e2188));
                                    let _e2455 = ((_e2206 * _e2187) - (_e2209 * _e2186));
                                    let _e2460 = (((_e2449 * _e2215[0]) + (_e2452 * _e2215[1])) + (_e2455 * _e2215[2]));
                                    let _e2465 = (((_e2449 * _e2232) + (_e2452 * _e2233)) + (_e2455 * _e2234));
                                    let _e2470 = (((_e2449 * _e2241) + (_e2452 * _e2242)) + (_e2455 * _e2243));
                                    let _e2478 = (((_e2449 * _e2240[0]) + (_e2452 * _e2240[1])) + (_e2455 * _e2240[2]));
                                    let _e2483 = (((_e2449 * _e2246[0]) + (_e2452 * _e2246[1])) + (_e2455 * _e2246[2]));
                                    let _e2488 = (((_e2449 * _e2263) + (_e2452 * _e2264)) + (_e2455 * _e2265));
                                    let _e2493 = (((_e2449 * _e2272) + (_e2452 * _e2273)) + (_e2455 * _e2274));
                                    let _e2501 = (((_e2449 * _e2271[0]) + (_e2452 * _e2271[1])) + (_e2455 * _e2271[2]));
                                    if (_e2460 < _e2465) {
                                        phi_4275_ = _e2460;
                                    } else {
                                        phi_4275_ = _e2465;
                                    }
                                    let _e2504 = phi_4275_;
                                    if (_e2470 < _e2478) {
                                        phi_4280_ = _e2470;
                                    } else {
                                        phi_4280_ = _e2478;
                                    }
                                    let _e2507 = phi_4280_;
                                    if (_e2504 < _e2507) {
                                        phi_4285_ = _e2504;
                                    } else {
                                        phi_4285_ = _e2507;
                                    }
                                    let _e2510 = phi_4285_;
                                    if (_e2483 < _e2488) {
                                        phi_4290_ = _e2483;
                                    } else {
                                        phi_4290_ = _e2488;
                                    }
                                    let _e2513 = phi_4290_;
                                    if (_e2493 < _e2501) {
                                        phi_4295_ = _e2493;
                                    } else {
                                        phi_4295_ = _e2501;
                                    }
                                    let _e2516 = phi_4295_;
                                    if (_e2513 < _e2516) {
                                        phi_4300_ = _e2513;
                                    } else {
                                        phi_4300_ = _e2516;
                                    }
                                    let _e2519 = phi_4300_;
                                    if (_e2510 < _e2519) {
                                        phi_4305_ = _e2510;
                                    } else {
                                        phi_4305_ = _e2519;
                                    }
                                    let _e2522 = phi_4305_;
                                    if (_e2460 > _e2465) {
                                        phi_4310_ = _e2460;
                                    } else {
                                        phi_4310_ = _e2465;
                                    }
                                    let _e2525 = phi_4310_;
                                    if (_e2470 > _e2478) {
                                        phi_4315_ = _e2470;
                                    } else {
                                        phi_4315_ = _e2478;
                                    }
                                    let _e2528 = phi_4315_;
                                    if (_e2525 > _e2528) {
                                        phi_4320_ = _e2525;
                                    } else {
                                        phi_4320_ = _e2528;
                                    }
                                    let _e2531 = phi_4320_;
                                    if (_e2483 > _e2488) {
                                        phi_4325_ = _e2483;
                                    } else {
                                        phi_4325_ = _e2488;
                                    }
                                    let _e2534 = phi_4325_;
                                    if (_e2493 > _e2501) {
                                        phi_4330_ = _e2493;
                                    } else {
                                        phi_4330_ = _e2501;
                                    }
                                    let _e2537 = phi_4330_;
                                    if (_e2534 > _e2537) {
                                        phi_4335_ = _e2534;
                                    } else {
                                        phi_4335_ = _e2537;
                                    }
                                    let _e2540 = phi_4335_;
                                    if (_e2531 > _e2540) {
                                        phi_4340_ = _e2531;
                                    } else {
                                        phi_4340_ = _e2540;
                                    }
                                    let _e2543 = phi_4340_;
                                    if (_e2449 < 0f) {
                                        phi_4346_ = -(_e2449);
                                    } else {
                                        phi_4346_ = _e2449;
                                    }
                                    let _e2547 = phi_4346_;
                                    if (_e2452 < 0f) {
                                        phi_4352_ = -(_e2452);
                                    } else {
                                        phi_4352_ = _e2452;
                                    }
                                    let _e2551 = phi_4352_;
                                    if (_e2455 < 0f) {
                                        phi_4359_ = -(_e2455);
                                    } else {
                                        phi_4359_ = _e2455;
                                    }
                                    let _e2556 = phi_4359_;
                                    let _e2557 = ((_e2547 + _e2551) + _e2556);
                                    let _e2562 = -(_e2543);
                                    if (_e2522 > _e2562) {
                                        phi_4370_ = _e2522;
                                    } else {
                                        phi_4370_ = _e2562;
                                    }
                                    let _e2565 = phi_4370_;
                                    let _e2570 = (((_e2565 - ((_e2557 * _e2439) * (0.000000059604645f * (17f / 2f)))) - (_e2557 * _e2446)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e2573 = ((_e2209 * _e2203) - (_e2212 * _e2202));
                                    let _e2576 = ((_e2212 * _e2201) - (_e2206 * _e2203));
                                    let _e2579 = ((_e2206 * _e2202) - (_e2209 * _e2201));
                                    let _e2584 = (((_e2573 * _e2215[0]) + (_e2576 * _e2215[1])) + (_e2579 * _e2215[2]));
                                    let _e2589 = (((_e2573 * _e2232) + (_e2576 * _e2233)) + (_e2579 * _e2234));
                                    let _e2594 = (((_e2573 * _e2241) + (_e2576 * _e2242)) + (_e2579 * _e2243));
                                    let _e2602 = (((_e2573 * _e2240[0]) + (_e2576 * _e2240[1])) + (_e2579 * _e2240[2]));
                                    let _e2607 = (((_e2573 * _e2246[0]) + (_e2576 * _e2246[1])) + (_e2579 * _e2246[2]));
                                    let _e2612 = (((_e2573 * _e2263) + (_e2576 * _e2264)) + (_e2579 * _e2265));
                                    let _e2617 = (((_e2573 * _e2272) + (_e2576 * _e2273)) + (_e2579 * _e2274));
                                    let _e2625 = (((_e2573 * _e2271[0]) + (_e2576 * _e2271[1])) + (_e2579 * _e2271[2]));
                                    if (_e2584 < _e2589) {
                                        phi_4441_ = _e2584;
                                    } else {
                                        phi_4441_ = _e2589;
                                    }
                                    let _e2628 = phi_4441_;
                                    if (_e2594 < _e2602) {
                                        phi_4446_ = _e2594;
                                    } else {
                                        phi_4446_ = _e2602;
                                    }
                                    let _e2631 = phi_4446_;
                                    if (_e2628 < _e2631) {
                                        phi_4451_ = _e2628;
                                    } else {
                                        phi_4451_ = _e2631;
                                    }
                                    let _e2634 = phi_4451_;
                                    if (_e2607 < _e2612) {
                                        phi_4456_ = _e2607;
                                    } else {
                                        phi_4456_ = _e2612;
                                    }
                                    let _e2637 = phi_4456_;
                                    if (_e2617 < _e2625) {
                                        phi_4461_ = _e2617;
                                    } else {
                                        phi_4461_ = _e2625;
                                    }
                                    let _e2640 = phi_4461_;
                                    if (_e2637 < _e2640) {
                                        phi_4466_ = _e2637;
                                    } else {
                                        phi_4466_ = _e2640;
                                    }
                                    let _e2643 = phi_4466_;
                                    if (_e2634 < _e2643) {
                                        phi_4471_ = _e2634;
                                    } else {
                                        phi_4471_ = _e2643;
                                    }
                                    let _e2646 = phi_4471_;
                                    if (_e2584 > _e2589) {
                                        phi_4476_ = _e2584;
                                    } else {
                                        phi_4476_ = _e2589;
                                    }
                                    let _e2649 = phi_4476_;
                                    if (_e2594 > _e2602) {
                                        phi_4481_ = _e2594;
                                    } else {
                                        phi_4481_ = _e2602;
                                    }
                                    let _e2652 = phi_4481_;
                                    if (_e2649 > _e2652) {
                                        phi_4486_ = _e2649;
                                    } else {
                                        phi_4486_ = _e2652;
                                    }
                                    let _e2655 = phi_4486_;
                                    if (_e2607 > _e2612) {
                                        phi_4491_ = _e2607;
                                    } else {
                                        phi_4491_ = _e2612;
                                    }
                                    let _e2658 = phi_4491_;
                                    if (_e2617 > _e2625) {
                                        phi_4496_ = _e2617;
                                    } else {
                                        phi_4496_ = _e2625;
                                    }
                                    let _e2661 = phi_4496_;
                                    if (_e2658 > _e2661) {
                                        phi_4501_ = _e2658;
                                    } else {
                                        phi_4501_ = _e2661;
                                    }
                                    let _e2664 = phi_4501_;
                                    if (_e2655 > _e2664) {
                                        phi_4506_ = _e2655;
                                    } else {
                                        phi_4506_ = _e2664;
                                    }
                                    let _e2667 = phi_4506_;
                                    if (_e2573 < 0f) {
                                        phi_4512_ = -(_e2573);
                                    } else {
                                        phi_4512_ = _e2573;
                                    }
                                    let _e2671 = phi_4512_;
                                    if (_e2576 < 0f) {
                                        phi_4518_ = -(_e2576);
                                    } else {
                                        phi_4518_ = _e2576;
                                    }
                                    let _e2675 = phi_4518_;
                                    if (_e2579 < 0f) {
                                        phi_4525_ = -(_e2579);
                                    } else {
                                        phi_4525_ = _e2579;
                                    }
                                    let _e2680 = phi_4525_;
                                    let _e2681 = ((_e2671 + _e2675) + _e2680);
                                    let _e2686 = -(_e2667);
                                    if (_e2646 > _e2686) {
                                        phi_4536_ = _e2646;
                                    } else {
                                        phi_4536_ = _e2686;
                                    }
                                    let _e2689 = phi_4536_;
                                    let _e2694 = (((_e2689 - ((_e2681 * _e2439) * (0.000000059604645f * (17f / 2f)))) - (_e2681 * _e2446)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e2570 > _e2694) {
                                        phi_4546_ = _e2570;
                                    } else {
                                        phi_4546_ = _e2694;
                                    }
                                    let _e2697 = phi_4546_;
                                    if true {
                                        let _e2698 = (_e2201 - _e2186);
                                        let _e2699 = (_e2202 - _e2187);
                                        let _e2700 = (_e2203 - _e2188);
                                        let _e2703 = ((_e2209 * _e2700) - (_e2212 * _e2699));
                                        let _e2706 = ((_e2212 * _e2698) - (_e2206 * _e2700));
                                        let _e2709 = ((_e2206 * _e2699) - (_e2209 * _e2698));
                                        let _e2714 = (((_e2703 * _e2215[0]) + (_e2706 * _e2215[1])) + (_e2709 * _e2215[2]));
                                        let _e2719 = (((_e2703 * _e2232) + (_e2706 * _e2233)) + (_e2709 * _e2234));
                                        let _e2724 = (((_e2703 * _e2241) + (_e2706 * _e2242)) + (_e2709 * _e2243));
                                        let _e2732 = (((_e2703 * _e2240[0]) + (_e2706 * _e2240[1])) + (_e2709 * _e2240[2]));
                                        let _e2737 = (((_e2703 * _e2246[0]) + (_e2706 * _e2246[1])) + (_e2709 * _e2246[2]));
                                        let _e2742 = (((_e2703 * _e2263) + (_e2706 * _e2264)) + (_e2709 * _e2265));
                                        let _e2747 = (((_e2703 * _e2272) + (_e2706 * _e2273)) + (_e2709 * _e2274));
                                        let _e2755 = (((_e2703 * _e2271[0]) + (_e2706 * _e2271[1])) + (_e2709 * _e2271[2]));
                                        if (_e2714 < _e2719) {
                                            phi_4619_ = _e2714;
                                        } else {
                                            phi_4619_ = _e2719;
                                        }
                                        let _e2758 = phi_4619_;
                                        if (_e2724 < _e2732) {
                                            phi_4624_ = _e2724;
                                        } else {
                                            phi_4624_ = _e2732;
                                        }
                                        let _e2761 = phi_4624_;
                                        if (_e2758 < _e2761) {
                                            phi_4629_ = _e2758;
                                        } else {
                                            phi_4629_ = _e2761;
                                        }
                                        let _e2764 = phi_4629_;
                                        if (_e2737 < _e2742) {
                                            phi_4634_ = _e2737;
                                        } else {
                                            phi_4634_ = _e2742;
                                        }
                                        let _e2767 = phi_4634_;
                                        if (_e2747 < _e2755) {
                                            phi_4639_ = _e2747;
                                        } else {
                                            phi_4639_ = _e2755;
                                        }
                                        let _e2770 = phi_4639_;
                                        if (_e2767 < _e2770) {
                                            phi_4644_ = _e2767;
                                        } else {
                                            phi_4644_ = _e2770;
                                        }
                                        let _e2773 = phi_4644_;
                                        if (_e2764 < _e2773) {
                                            phi_4649_ = _e2764;
                                        } else {
                                            phi_4649_ = _e2773;
                                        }
                                        let _e2776 = phi_4649_;
                                        if (_e2714 > _e2719) {
                                            phi_4654_ = _e2714;
                                        } else {
                                            phi_4654_ = _e2719;
                                        }
                                        let _e2779 = phi_4654_;
                                        if (_e2724 > _e2732) {
                                            phi_4659_ = _e2724;
                                        } else {
                                            phi_4659_ = _e2732;
                                        }
                                        let _e2782 = phi_4659_;
                                        if (_e2779 > _e2782) {
                                            phi_4664_ = _e2779;
                                        } else {
                                            phi_4664_ = _e2782;
                                        }
                                        let _e2785 = phi_4664_;
                                        if (_e2737 > _e2742) {
                                            phi_4669_ = _e2737;
                                        } else {
                                            phi_4669_ = _e2742;
                                        }
                                        let _e2788 = phi_4669_;
                                        if (_e2747 > _e2755) {
                                            phi_4674_ = _e2747;
                                        } else {
                                            phi_4674_ = _e2755;
                                        }
                                        let _e2791 = phi_4674_;
                                        if (_e2788 > _e2791) {
                                            phi_4679_ = _e2788;
                                        } else {
                                            phi_4679_ = _e2791;
                                        }
                                        let _e2794 = phi_4679_;
                                        if (_e2785 > _e2794) {
                                            phi_4684_ = _e2785;
                                        } else {
                                            phi_4684_ = _e2794;
                                        }
                                        let _e2797 = phi_4684_;
                                        if (_e2703 < 0f) {
                                            phi_4690_ = -(_e2703);
                                        } else {
                                            phi_4690_ = _e2703;
                                        }
                                        let _e2801 = phi_4690_;
                                        if (_e2706 < 0f) {
                                            phi_4696_ = -(_e2706);
                                        } else {
                                            phi_4696_ = _e2706;
                                        }
                                        let _e2805 = phi_4696_;
                                        if (_e2709 < 0f) {
                                            phi_4703_ = -(_e2709);
                                        } else {
                                            phi_4703_ = _e2709;
                                        }
                                        let _e2810 = phi_4703_;
                                        let _e2811 = ((_e2801 + _e2805) + _e2810);
                                        let _e2816 = -(_e2797);
                                        if (_e2776 > _e2816) {
                                            phi_4714_ = _e2776;
                                        } else {
                                            phi_4714_ = _e2816;
                                        }
                                        let _e2819 = phi_4714_;
                                        let _e2824 = (((_e2819 - ((_e2811 * _e2439) * (0.000000059604645f * (17f / 2f)))) - (_e2811 * _e2446)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e2697 > _e2824) {
                                            phi_4724_ = _e2697;
                                        } else {
                                            phi_4724_ = _e2824;
                                        }
                                        let _e2827 = phi_4724_;
                                        phi_4725_ = _e2827;
                                    } else {
                                        phi_4725_ = _e2697;
                                    }
                                    let _e2829 = phi_4725_;
                                    phi_4728_ = (_e2173 || (_e2829 > 0f));
                                }
                                let _e2833 = phi_4728_;
                                if _e2833 {
                                } else {
                                    let _e2835 = atomicAdd((&counters[6u]), 1u);
                                    hits[_e2835] = _e1560;
                                }
                                phi_4735_ = true;
                            }
                            let _e2838 = phi_4735_;
                            phi_4736_ = _e2838;
                        } else {
                            phi_4736_ = false;
                        }
                        let _e2840 = phi_4736_;
                        continue;
                        continuing {
                            phi_2861_ = _e1549;
                            break if !(_e2840);
                        }
                    }
                    workgroupBarrier();
                    let _e2843 = atomicLoad((&counters[6u]));
                    phi_4741_ = type_9(0u, 4u);
                    loop {
                        let _e2845 = phi_4741_;
                        if (_e2845.member < _e2845.member_1) {
                            phi_4742_ = type_9((_e2845.member + 1u), _e2845.member_1);
                            phi_4765_ = type_9(1u, _e2845.member);
                        } else {
                            phi_4742_ = _e2845;
                            phi_4765_ = type_9(0u, type_9().member_1);
                        }
                        let _e2857 = phi_4742_;
                        let _e2859 = phi_4765_;
                        if (bitcast<i32>(_e2859.member) != 0i) {
                            let _e2865 = (_e73 + (_e2859.member_1 * 128u));
                            if (_e2865 >= _e2843) {
                                phi_8322_ = false;
                            } else {
                                let _e2868 = hits[_e2865];
                                let _e2871 = ((_e2868 >> bitcast<u32>(10i)) & 3u);
                                let _e2878 = firsts[(2u * _e2871)];
                                let _e2883 = firsts[((2u * _e2871) + 1u)];
                                let _e2886 = leaves.member[(_e2878 + ((_e2868 >> bitcast<u32>(5i)) & 31u))];
                                let _e2889 = leaves.member[(_e2883 + (_e2868 & 31u))];
                                let _e2894 = paths.member[_e2886.x];
                                let _e2908 = paths.member[_e2889.x];
                                let _e2922 = paths.member[_e2889.y];
                                let _e2936 = paths.member[_e2889.z];
                                if false {
                                    phi_4970_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e2922.member.x - _e2894.member.x), (_e2922.member.y - _e2894.member.y), (_e2922.member.z - _e2894.member.z)), array<f32, 3>((_e2922.member_1.x - _e2894.member_1.x), (_e2922.member_1.y - _e2894.member_1.y), (_e2922.member_1.z - _e2894.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2908.member.x - _e2894.member.x), (_e2908.member.y - _e2894.member.y), (_e2908.member.z - _e2894.member.z)), array<f32, 3>((_e2908.member_1.x - _e2894.member_1.x), (_e2908.member_1.y - _e2894.member_1.y), (_e2908.member_1.z - _e2894.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2922.member.x - _e2936.member.x), (_e2922.member.y - _e2936.member.y), (_e2922.member.z - _e2936.member.z)), array<f32, 3>((_e2922.member_1.x - _e2936.member_1.x), (_e2922.member_1.y - _e2936.member_1.y), (_e2922.member_1.z - _e2936.member_1.z))), (_e91.member_4 + _e91.member_4));
                                } else {
                                    phi_4970_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e2894.member.x - _e2908.member.x), (_e2894.member.y - _e2908.member.y), (_e2894.member.z - _e2908.member.z)), array<f32, 3>((_e2894.member_1.x - _e2908.member_1.x), (_e2894.member_1.y - _e2908.member_1.y), (_e2894.member_1.z - _e2908.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2922.member.x - _e2908.member.x), (_e2922.member.y - _e2908.member.y), (_e2922.member.z - _e2908.member.z)), array<f32, 3>((_e2922.member_1.x - _e2908.member_1.x), (_e2922.member_1.y - _e2908.member_1.y), (_e2922.member_1.z - _e2908.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2936.member.x - _e2908.member.x), (_e2936.member.y - _e2908.member.y), (_e2936.member.z - _e2908.member.z)), array<f32, 3>((_e2936.member_1.x - _e2908.member_1.x), (_e2936.member_1.y - _e2908.member_1.y), (_e2936.member_1.z - _e2908.member_1.z))), (_e91.member_4 + _e91.member_4));
                                }
                                let _e3008 = phi_4970_;
                                let _e3022 = ((_e3008.member[0][0] + _e3008.member[1][0]) * 0.5f);
                                let _e3023 = ((_e3008.member[0][1] + _e3008.member[1][1]) * 0.5f);
                                let _e3024 = ((_e3008.member[0][2] + _e3008.member[1][2]) * 0.5f);
                                let _e3038 = ((_e3008.member_1[0][0] + _e3008.member_1[1][0]) * 0.5f);
                                let _e3039 = ((_e3008.member_1[0][1] + _e3008.member_1[1][1]) * 0.5f);
                                let _e3040 = ((_e3008.member_1[0][2] + _e3008.member_1[1][2]) * 0.5f);
                                let _e3054 = ((_e3008.member_2[0][0] + _e3008.member_2[1][0]) * 0.5f);
                                let _e3055 = ((_e3008.member_2[0][1] + _e3008.member_2[1][1]) * 0.5f);
                                let _e3056 = ((_e3008.member_2[0][2] + _e3008.member_2[1][2]) * 0.5f);
                                local = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e3008.member[0][0], _e3008.member[0][1], _e3008.member[0][2]), array<f32, 3>(_e3022, _e3023, _e3024)), array<array<f32, 3>, 2>(array<f32, 3>(_e3008.member_1[0][0], _e3008.member_1[0][1], _e3008.member_1[0][2]), array<f32, 3>(_e3038, _e3039, _e3040)), array<array<f32, 3>, 2>(array<f32, 3>(_e3008.member_2[0][0], _e3008.member_2[0][1], _e3008.member_2[0][2]), array<f32, 3>(_e3054, _e3055, _e3056)), _e3008.member_3);
                                local_1 = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e3022, _e3023, _e3024), array<f32, 3>(_e3008.member[1][0], _e3008.member[1][1], _e3008.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e3038, _e3039, _e3040), array<f32, 3>(_e3008.member_1[1][0], _e3008.member_1[1][1], _e3008.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e3054, _e3055, _e3056), array<f32, 3>(_e3008.member_2[1][0], _e3008.member_2[1][1], _e3008.member_2[1][2])), _e3008.member_3);
                                let _e3111 = local.member_1[0u];
                                let _e3117 = local.member_2[0u];
                                let _e3123 = ((_e3111[1] * _e3117[2]) - (_e3111[2] * _e3117[1]));
                                let _e3126 = ((_e3111[2] * _e3117[0]) - (_e3111[0] * _e3117[2]));
                                let _e3129 = ((_e3111[0] * _e3117[1]) - (_e3111[1] * _e3117[0]));
                                let _e3132 = local.member_1[1u];
                                let _e3138 = local.member_2[1u];
                                let _e3144 = ((_e3132[1] * _e3138[2]) - (_e3132[2] * _e3138[1]));
                                let _e3147 = ((_e3132[2] * _e3138[0]) - (_e3132[0] * _e3138[2]));
                                let _e3150 = ((_e3132[0] * _e3138[1]) - (_e3132[1] * _e3138[0]));
                                let _e3153 = local.member_1[0u];
                                let _e3159 = local.member_2[1u];
                                let _e3174 = local.member_1[1u];
                                let _e3180 = local.member_2[0u];
                                let _e3193 = (((_e3153[1] * _e3159[2]) - (_e3153[2] * _e3159[1])) + ((_e3174[1] * _e3180[2]) - (_e3174[2] * _e3180[1])));
                                let _e3194 = (((_e3153[2] * _e3159[0]) - (_e3153[0] * _e3159[2])) + ((_e3174[2] * _e3180[0]) - (_e3174[0] * _e3180[2])));
                                let _e3195 = (((_e3153[0] * _e3159[1]) - (_e3153[1] * _e3159[0])) + ((_e3174[0] * _e3180[1]) - (_e3174[1] * _e3180[0])));
                                let _e3198 = local.member[0u];
                                let _e3209 = local.member[1u];
                                let _e3220 = local.member[0u];
                                let _e3229 = ((((_e3209[0] * _e3123) + (_e3209[1] * _e3126)) + (_e3209[2] * _e3129)) + (((_e3220[0] * _e3193) + (_e3220[1] * _e3194)) + (_e3220[2] * _e3195)));
                                let _e3232 = local.member[0u];
                                let _e3243 = local.member[1u];
                                let _e3252 = ((((_e3232[0] * _e3144) + (_e3232[1] * _e3147)) + (_e3232[2] * _e3150)) + (((_e3243[0] * _e3193) + (_e3243[1] * _e3194)) + (_e3243[2] * _e3195)));
                                let _e3255 = local.member[1u];
                                let _e3266 = local.member[0u];
                                if (_e3266[0] < 0f) {
                                    phi_5349_ = -(_e3266[0]);
                                } else {
                                    phi_5349_ = _e3266[0];
                                }
                                let _e3273 = phi_5349_;
                                if (_e3266[1] < 0f) {
                                    phi_5356_ = -(_e3266[1]);
                                } else {
                                    phi_5356_ = _e3266[1];
                                }
                                let _e3277 = phi_5356_;
                                if (_e3273 > _e3277) {
                                    phi_5361_ = _e3273;
                                } else {
                                    phi_5361_ = _e3277;
                                }
                                let _e3280 = phi_5361_;
                                if (_e3266[2] < 0f) {
                                    phi_5368_ = -(_e3266[2]);
                                } else {
                                    phi_5368_ = _e3266[2];
                                }
                                let _e3284 = phi_5368_;
                                if (_e3280 > _e3284) {
                                    phi_5373_ = _e3280;
                                } else {
                                    phi_5373_ = _e3284;
                                }
                                let _e3287 = phi_5373_;
                                let _e3290 = local.member[1u];
                                if (_e3290[0] < 0f) {
                                    phi_5386_ = -(_e3290[0]);
                                } else {
                                    phi_5386_ = _e3290[0];
                                }
                                let _e3297 = phi_5386_;
                                if (_e3290[1] < 0f) {
                                    phi_5393_ = -(_e3290[1]);
                                } else {
                                    phi_5393_ = _e3290[1];
                                }
                                let _e3301 = phi_5393_;
                                if (_e3297 > _e3301) {
                                    phi_5398_ = _e3297;
                                } else {
                                    phi_5398_ = _e3301;
                                }
                                let _e3304 = phi_5398_;
                                if (_e3290[2] < 0f) {
                                    phi_5405_ = -(_e3290[2]);
                                } else {
                                    phi_5405_ = _e3290[2];
                                }
                                let _e3308 = phi_5405_;
                                if (_e3304 > _e3308) {
                                    phi_5410_ = _e3304;
                                } else {
                                    phi_5410_ = _e3308;
                                }
                                let _e3311 = phi_5410_;
                                if (_e3287 > _e3311) {
                                    phi_5415_ = _e3287;
                                } else {
                                    phi_5415_ = _e3311;
                                }
                                let _e3314 = phi_5415_;
                                let _e3316 = local.member_3;
                                let _e3317 = (_e3314 + _e3316);
                                let _e3320 = local.member_1[0u];
                                if (_e3320[0] < 0f) {
                                    phi_5432_ = -(_e3320[0]);
                                } else {
                                    phi_5432_ = _e3320[0];
                                }
                                let _e3327 = phi_5432_;
                                if (_e3320[1] < 0f) {
                                    phi_5439_ = -(_e3320[1]);
                                } else {
                                    phi_5439_ = _e3320[1];
                                }
                                let _e3331 = phi_5439_;
                                if (_e3327 > _e3331) {
                                    phi_5444_ = _e3327;
                                } else {
                                    phi_5444_ = _e3331;
                                }
                                let _e3334 = phi_5444_;
                                if (_e3320[2] < 0f) {
                                    phi_5451_ = -(_e3320[2]);
                                } else {
                                    phi_5451_ = _e3320[2];
                                }
                                let _e3338 = phi_5451_;
                                if (_e3334 > _e3338) {
                                    phi_5456_ = _e3334;
                                } else {
                                    phi_5456_ = _e3338;
                                }
                                let _e3341 = phi_5456_;
                                let _e3344 = local.member_1[1u];
                                if (_e3344[0] < 0f) {
                                    phi_5470_ = -(_e3344[0]);
                                } else {
                                    phi_5470_ = _e3344[0];
                                }
                                let _e3351 = phi_5470_;
                                if (_e3344[1] < 0f) {
                                    phi_5477_ = -(_e3344[1]);
                                } else {
                                    phi_5477_ = _e3344[1];
                                }
                                let _e3355 = phi_5477_;
                                if (_e3351 > _e3355) {
                                    phi_5482_ = _e3351;
                                } else {
                                    phi_5482_ = _e3355;
                                }
                                let _e3358 = phi_5482_;
                                if (_e3344[2] < 0f) {
                                    phi_5489_ = -(_e3344[2]);
                                } else {
                                    phi_5489_ = _e3344[2];
                                }
                                let _e3362 = phi_5489_;
                                if (_e3358 > _e3362) {
                                    phi_5494_ = _e3358;
                                } else {
                                    phi_5494_ = _e3362;
                                }
                                let _e3365 = phi_5494_;
                                if (_e3341 > _e3365) {
                                    phi_5499_ = _e3341;
                                } else {
                                    phi_5499_ = _e3365;
                                }
                                let _e3368 = phi_5499_;
                                let _e3370 = local.member_3;
                                let _e3371 = (_e3368 + _e3370);
                                let _e3374 = local.member_2[0u];
                                if (_e3374[0] < 0f) {
                                    phi_5516_ = -(_e3374[0]);
                                } else {
                                    phi_5516_ = _e3374[0];
                                }
                                let _e3381 = phi_5516_;
                                if (_e3374[1] < 0f) {
                                    phi_5523_ = -(_e3374[1]);
                                } else {
                                    phi_5523_ = _e3374[1];
                                }
                                let _e3385 = phi_5523_;
                                if (_e3381 > _e3385) {
                                    phi_5528_ = _e3381;
                                } else {
                                    phi_5528_ = _e3385;
                                }
                                let _e3388 = phi_5528_;
                                if (_e3374[2] < 0f) {
                                    phi_5535_ = -(_e3374[2]);
                                } else {
                                    phi_5535_ = _e3374[2];
                                }
                                let _e3392 = phi_5535_;
                                if (_e3388 > _e3392) {
                                    phi_5540_ = _e3388;
                                } else {
                                    phi_5540_ = _e3392;
                                }
                                let _e3395 = phi_5540_;
                                let _e3398 = local.member_2[1u];
                                if (_e3398[0] < 0f) {
                                    phi_5554_ = -(_e3398[0]);
                                } else {
                                    phi_5554_ = _e3398[0];
                                }
                                let _e3405 = phi_5554_;
                                if (_e3398[1] < 0f) {
                                    phi_5561_ = -(_e3398[1]);
                                } else {
                                    phi_5561_ = _e3398[1];
                                }
                                let _e3409 = phi_5561_;
                                if (_e3405 > _e3409) {
                                    phi_5566_ = _e3405;
                                } else {
                                    phi_5566_ = _e3409;
                                }
                                let _e3412 = phi_5566_;
                                if (_e3398[2] < 0f) {
                                    phi_5573_ = -(_e3398[2]);
                                } else {
                                    phi_5573_ = _e3398[2];
                                }
                                let _e3416 = phi_5573_;
                                if (_e3412 > _e3416) {
                                    phi_5578_ = _e3412;
                                } else {
                                    phi_5578_ = _e3416;
                                }
                                let _e3419 = phi_5578_;
                                if (_e3395 > _e3419) {
                                    phi_5583_ = _e3395;
                                } else {
                                    phi_5583_ = _e3419;
                                }
                                let _e3422 = phi_5583_;
                                let _e3424 = local.member_3;
                                let _e3425 = (_e3422 + _e3424);
                                let _e3427 = ((_e3371 * 8f) * _e3425);
                                let _e3434 = local.member_3;
                                if (_e3123 < 0f) {
                                    phi_5614_ = -(_e3123);
                                } else {
                                    phi_5614_ = _e3123;
                                }
                                let _e3451 = phi_5614_;
                                if (_e3126 < 0f) {
                                    phi_5620_ = -(_e3126);
                                } else {
                                    phi_5620_ = _e3126;
                                }
                                let _e3455 = phi_5620_;
                                if (_e3129 < 0f) {
                                    phi_5627_ = -(_e3129);
                                } else {
                                    phi_5627_ = _e3129;
                                }
                                let _e3460 = phi_5627_;
                                let _e3461 = ((_e3451 + _e3455) + _e3460);
                                if (_e3144 < 0f) {
                                    phi_5634_ = -(_e3144);
                                } else {
                                    phi_5634_ = _e3144;
                                }
                                let _e3465 = phi_5634_;
                                if (_e3147 < 0f) {
                                    phi_5640_ = -(_e3147);
                                } else {
                                    phi_5640_ = _e3147;
                                }
                                let _e3469 = phi_5640_;
                                if (_e3150 < 0f) {
                                    phi_5647_ = -(_e3150);
                                } else {
                                    phi_5647_ = _e3150;
                                }
                                let _e3474 = phi_5647_;
                                let _e3475 = ((_e3465 + _e3469) + _e3474);
                                if (_e3461 > _e3475) {
                                    phi_5653_ = _e3461;
                                } else {
                                    phi_5653_ = _e3475;
                                }
                                let _e3478 = phi_5653_;
                                if (_e3193 < 0f) {
                                    phi_5659_ = -(_e3193);
                                } else {
                                    phi_5659_ = _e3193;
                                }
                                let _e3482 = phi_5659_;
                                if (_e3194 < 0f) {
                                    phi_5665_ = -(_e3194);
                                } else {
                                    phi_5665_ = _e3194;
                                }
                                let _e3486 = phi_5665_;
                                if (_e3195 < 0f) {
                                    phi_5672_ = -(_e3195);
                                } else {
                                    phi_5672_ = _e3195;
                                }
                                let _e3491 = phi_5672_;
                                let _e3493 = (((_e3482 + _e3486) + _e3491) * 0.5f);
                                if (_e3478 > _e3493) {
                                    phi_5679_ = _e3478;
                                } else {
                                    phi_5679_ = _e3493;
                                }
                                let _e3496 = phi_5679_;
                                let _e3501 = local.member_3;
                                let _e3514 = ((((_e3198[0] * _e3123) + (_e3198[1] * _e3126)) + (_e3198[2] * _e3129)) * 3f);
                                let _e3515 = ((((_e3255[0] * _e3144) + (_e3255[1] * _e3147)) + (_e3255[2] * _e3150)) * 3f);
                                if (_e3514 < _e3515) {
                                    phi_5703_ = _e3514;
                                } else {
                                    phi_5703_ = _e3515;
                                }
                                let _e3518 = phi_5703_;
                                if (_e3229 < _e3252) {
                                    phi_5708_ = _e3229;
                                } else {
                                    phi_5708_ = _e3252;
                                }
                                let _e3521 = phi_5708_;
                                if (_e3518 < _e3521) {
                                    phi_5713_ = _e3518;
                                } else {
                                    phi_5713_ = _e3521;
                                }
                                let _e3524 = phi_5713_;
                                if (_e3514 > _e3515) {
                                    phi_5718_ = _e3514;
                                } else {
                                    phi_5718_ = _e3515;
                                }
                                let _e3527 = phi_5718_;
                                if (_e3229 > _e3252) {
                                    phi_5723_ = _e3229;
                                } else {
                                    phi_5723_ = _e3252;
                                }
                                let _e3530 = phi_5723_;
                                if (_e3527 > _e3530) {
                                    phi_5728_ = _e3527;
                                } else {
                                    phi_5728_ = _e3530;
                                }
                                let _e3533 = phi_5728_;
                                let _e3538 = -(_e3533);
                                if (_e3524 > _e3538) {
                                    phi_5738_ = _e3524;
                                } else {
                                    phi_5738_ = _e3538;
                                }
                                let _e3541 = phi_5738_;
                                let _e3543 = ((_e3541 - ((((((_e3317 * 8f) * _e3427) * (0.000000059604645f * (524f / 64f))) + ((_e3434 * 19f) * ((_e3317 * (_e3371 + _e3425)) + (_e3371 * _e3425)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3317) * ((1f + _e3371) * (1f + _e3425))))) + ((_e91.member_5 * (((_e3496 + (_e3427 * (0.000000059604645f * 8f))) + ((_e3501 * 6f) * (_e3371 + _e3425))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3371) * (1f + _e3425))))) * (3f * 1.0001f)))) > 0f);
                                if _e3543 {
                                    phi_6707_ = _e3543;
                                } else {
                                    let _e3546 = local.member_1[0u];
                                    let _e3552 = local.member_1[1u];
                                    let _e3556 = (_e3546[0] + _e3552[0]);
                                    let _e3557 = (_e3546[1] + _e3552[1]);
                                    let _e3558 = (_e3546[2] + _e3552[2]);
                                    let _e3561 = local.member_2[0u];
                                    let _e3567 = local.member_2[1u];
                                    let _e3571 = (_e3561[0] + _e3567[0]);
                                    let _e3572 = (_e3561[1] + _e3567[1]);
                                    let _e3573 = (_e3561[2] + _e3567[2]);
                                    let _e3576 = ((_e3557 * _e3573) - (_e3558 * _e3572));
                                    let _e3579 = ((_e3558 * _e3571) - (_e3556 * _e3573));
                                    let _e3582 = ((_e3556 * _e3572) - (_e3557 * _e3571));
                                    let _e3585 = local.member[0u];
                                    let _e3592 = local.member_1[0u];
                                    let _e3598 = local.member_2[0u];
                                    let _e3602 = (_e3585[0] - _e3592[0]);
                                    let _e3603 = (_e3585[1] - _e3592[1]);
                                    let _e3604 = (_e3585[2] - _e3592[2]);
                                    if true {
                                        phi_5854_ = array<f32, 3>(_e3585[0], _e3585[1], _e3585[2]);
                                    } else {
                                        phi_5854_ = array<f32, 3>((_e3602 - _e3598[0]), (_e3603 - _e3598[1]), (_e3604 - _e3598[2]));
                                    }
                                    let _e3610 = phi_5854_;
                                    let _e3611 = (_e3585[0] - _e3598[0]);
                                    let _e3612 = (_e3585[1] - _e3598[1]);
                                    let _e3613 = (_e3585[2] - _e3598[2]);
                                    let _e3616 = local.member[1u];
                                    let _e3623 = local.member_1[1u];
                                    let _e3629 = local.member_2[1u];
                                    let _e3633 = (_e3616[0] - _e3623[0]);
                                    let _e3634 = (_e3616[1] - _e3623[1]);
                                    let _e3635 = (_e3616[2] - _e3623[2]);
                                    if true {
                                        phi_5919_ = array<f32, 3>(_e3616[0], _e3616[1], _e3616[2]);
                                    } else {
                                        phi_5919_ = array<f32, 3>((_e3633 - _e3629[0]), (_e3634 - _e3629[1]), (_e3635 - _e3629[2]));
                                    }
                                    let _e3641 = phi_5919_;
                                    let _e3642 = (_e3616[0] - _e3629[0]);
                                    let _e3643 = (_e3616[1] - _e3629[1]);
                                    let _e3644 = (_e3616[2] - _e3629[2]);
                                    let _e3647 = local.member[0u];
                                    if (_e3647[0] < 0f) {
                                        phi_5941_ = -(_e3647[0]);
                                    } else {
                                        phi_5941_ = _e3647[0];
                                    }
                                    let _e3654 = phi_5941_;
                                    if (_e3647[1] < 0f) {
                                        phi_5948_ = -(_e3647[1]);
                                    } else {
                                        phi_5948_ = _e3647[1];
                                    }
                                    let _e3658 = phi_5948_;
                                    if (_e3654 > _e3658) {
                                        phi_5953_ = _e3654;
                                    } else {
                                        phi_5953_ = _e3658;
                                    }
                                    let _e3661 = phi_5953_;
                                    if (_e3647[2] < 0f) {
                                        phi_5960_ = -(_e3647[2]);
                                    } else {
                                        phi_5960_ = _e3647[2];
                                    }
                                    let _e3665 = phi_5960_;
                                    if (_e3661 > _e3665) {
                                        phi_5965_ = _e3661;
                                    } else {
                                        phi_5965_ = _e3665;
                                    }
                                    let _e3668 = phi_5965_;
                                    let _e3671 = local.member[1u];
                                    if (_e3671[0] < 0f) {
                                        phi_5978_ = -(_e3671[0]);
                                    } else {
                                        phi_5978_ = _e3671[0];
                                    }
                                    let _e3678 = phi_5978_;
                                    if (_e3671[1] < 0f) {
                                        phi_5985_ = -(_e3671[1]);
                                    } else {
                                        phi_5985_ = _e3671[1];
                                    }
                                    let _e3682 = phi_5985_;
                                    if (_e3678 > _e3682) {
                                        phi_5990_ = _e3678;
                                    } else {
                                        phi_5990_ = _e3682;
                                    }
                                    let _e3685 = phi_5990_;
                                    if (_e3671[2] < 0f) {
                                        phi_5997_ = -(_e3671[2]);
                                    } else {
                                        phi_5997_ = _e3671[2];
                                    }
                                    let _e3689 = phi_5997_;
                                    if (_e3685 > _e3689) {
                                        phi_6002_ = _e3685;
                                    } else {
                                        phi_6002_ = _e3689;
                                    }
                                    let _e3692 = phi_6002_;
                                    if (_e3668 > _e3692) {
                                        phi_6007_ = _e3668;
                                    } else {
                                        phi_6007_ = _e3692;
                                    }
                                    let _e3695 = phi_6007_;
                                    let _e3697 = local.member_3;
                                    let _e3701 = local.member_1[0u];
                                    if (_e3701[0] < 0f) {
                                        phi_6024_ = -(_e3701[0]);
                                    } else {
                                        phi_6024_ = _e3701[0];
                                    }
                                    let _e3708 = phi_6024_;
                                    if (_e3701[1] < 0f) {
                                        phi_6031_ = -(_e3701[1]);
                                    } else {
                                        phi_6031_ = _e3701[1];
                                    }
                                    let _e3712 = phi_6031_;
                                    if (_e3708 > _e3712) {
                                        phi_6036_ = _e3708;
                                    } else {
                                        phi_6036_ = _e3712;
                                    }
                                    let _e3715 = phi_6036_;
                                    if (_e3701[2] < 0f) {
                                        phi_6043_ = -(_e3701[2]);
                                    } else {
                                        phi_6043_ = _e3701[2];
                                    }
                                    let _e3719 = phi_6043_;
                                    if (_e3715 > _e3719) {
                                        phi_6048_ = _e3715;
                                    } else {
                                        phi_6048_ = _e3719;
                                    }
                                    let _e3722 = phi_6048_;
                                    let _e3725 = local.member_1[1u];
                                    if (_e3725[0] < 0f) {
                                        phi_6062_ = -(_e3725[0]);
                                    } else {
                                        phi_6062_ = _e3725[0];
                                    }
                                    let _e3732 = phi_6062_;
                                    if (_e3725[1] < 0f) {
                                        phi_6069_ = -(_e3725[1]);
                                    } else {
                                        phi_6069_ = _e3725[1];
                                    }
                                    let _e3736 = phi_6069_;
                                    if (_e3732 > _e3736) {
                                        phi_6074_ = _e3732;
                                    } else {
                                        phi_6074_ = _e3736;
                                    }
                                    let _e3739 = phi_6074_;
                                    if (_e3725[2] < 0f) {
                                        phi_6081_ = -(_e3725[2]);
                                    } else {
                                        phi_6081_ = _e3725[2];
                                    }
                                    let _e3743 = phi_6081_;
                                    if (_e3739 > _e3743) {
                                        phi_6086_ = _e3739;
                                    } else {
                                        phi_6086_ = _e3743;
                                    }
                                    let _e3746 = phi_6086_;
                                    if (_e3722 > _e3746) {
                                        phi_6091_ = _e3722;
                                    } else {
                                        phi_6091_ = _e3746;
                                    }
                                    let _e3749 = phi_6091_;
                                    let _e3751 = local.member_3;
                                    let _e3755 = local.member_2[0u];
                                    if (_e3755[0] < 0f) {
                                        phi_6108_ = -(_e3755[0]);
                                    } else {
                                        phi_6108_ = _e3755[0];
                                    }
                                    let _e3762 = phi_6108_;
                                    if (_e3755[1] < 0f) {
                                        phi_6115_ = -(_e3755[1]);
                                    } else {
                                        phi_6115_ = _e3755[1];
                                    }
                                    let _e3766 = phi_6115_;
                                    if (_e3762 > _e3766) {
                                        phi_6120_ = _e3762;
                                    } else {
                                        phi_6120_ = _e3766;
                                    }
                                    let _e3769 = phi_6120_;
                                    if (_e3755[2] < 0f) {
                                        phi_6127_ = -(_e3755[2]);
                                    } else {
                                        phi_6127_ = _e3755[2];
                                    }
                                    let _e3773 = phi_6127_;
                                    if (_e3769 > _e3773) {
                                        phi_6132_ = _e3769;
                                    } else {
                                        phi_6132_ = _e3773;
                                    }
                                    let _e3776 = phi_6132_;
                                    let _e3779 = local.member_2[1u];
                                    if (_e3779[0] < 0f) {
                                        phi_6146_ = -(_e3779[0]);
                                    } else {
                                        phi_6146_ = _e3779[0];
                                    }
                                    let _e3786 = phi_6146_;
                                    if (_e3779[1] < 0f) {
                                        phi_6153_ = -(_e3779[1]);
                                    } else {
                                        phi_6153_ = _e3779[1];
                                    }
                                    let _e3790 = phi_6153_;
                                    if (_e3786 > _e3790) {
                                        phi_6158_ = _e3786;
                                    } else {
                                        phi_6158_ = _e3790;
                                    }
                                    let _e3793 = phi_6158_;
                                    if (_e3779[2] < 0f) {
                                        phi_6165_ = -(_e3779[2]);
                                    } else {
                                        phi_6165_ = _e3779[2];
                                    }
                                    let _e3797 = phi_6165_;
                                    if (_e3793 > _e3797) {
                                        phi_6170_ = _e3793;
                                    } else {
                                        phi_6170_ = _e3797;
                                    }
                                    let _e3800 = phi_6170_;
                                    if (_e3776 > _e3800) {
                                        phi_6175_ = _e3776;
                                    } else {
                                        phi_6175_ = _e3800;
                                    }
                                    let _e3803 = phi_6175_;
                                    let _e3805 = local.member_3;
                                    let _e3809 = ((((_e3695 + _e3697) + (_e3749 + _e3751)) + (_e3803 + _e3805)) * 2f);
                                    let _e3812 = local.member_3;
                                    let _e3816 = (((_e91.member_5 * 1.0001f) + (_e3812 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3819 = ((_e3579 * _e3558) - (_e3582 * _e3557));
                                    let _e3822 = ((_e3582 * _e3556) - (_e3576 * _e3558));
                                    let _e3825 = ((_e3576 * _e3557) - (_e3579 * _e3556));
                                    let _e3830 = (((_e3819 * _e3585[0]) + (_e3822 * _e3585[1])) + (_e3825 * _e3585[2]));
                                    let _e3835 = (((_e3819 * _e3602) + (_e3822 * _e3603)) + (_e3825 * _e3604));
                                    let _e3840 = (((_e3819 * _e3611) + (_e3822 * _e3612)) + (_e3825 * _e3613));
                                    let _e3848 = (((_e3819 * _e3610[0]) + (_e3822 * _e3610[1])) + (_e3825 * _e3610[2]));
                                    let _e3853 = (((_e3819 * _e3616[0]) + (_e3822 * _e3616[1])) + (_e3825 * _e3616[2]));
                                    let _e3858 = (((_e3819 * _e3633) + (_e3822 * _e3634)) + (_e3825 * _e3635));
                                    let _e3863 = (((_e3819 * _e3642) + (_e3822 * _e3643)) + (_e3825 * _e3644));
                                    let _e3871 = (((_e3819 * _e3641[0]) + (_e3822 * _e3641[1])) + (_e3825 * _e3641[2]));
                                    if (_e3830 < _e3835) {
                                        phi_6254_ = _e3830;
                                    } else {
                                        phi_6254_ = _e3835;
                                    }
                                    let _e3874 = phi_6254_;
                                    if (_e3840 < _e3848) {
                                        phi_6259_ = _e3840;
                                    } else {
                                        phi_6259_ = _e3848;
                                    }
                                    let _e3877 = phi_6259_;
                                    if (_e3874 < _e3877) {
                                        phi_6264_ = _e3874;
                                    } else {
                                        phi_6264_ = _e3877;
                                    }
                                    let _e3880 = phi_6264_;
                                    if (_e3853 < _e3858) {
                                        phi_6269_ = _e3853;
                                    } else {
                                        phi_6269_ = _e3858;
                                    }
                                    let _e3883 = phi_6269_;
                                    if (_e3863 < _e3871) {
                                        phi_6274_ = _e3863;
                                    } else {
                                        phi_6274_ = _e3871;
                                    }
                                    let _e3886 = phi_6274_;
                                    if (_e3883 < _e3886) {
                                        phi_6279_ = _e3883;
                                    } else {
                                        phi_6279_ = _e3886;
                                    }
                                    let _e3889 = phi_6279_;
                                    if (_e3880 < _e3889) {
                                        phi_6284_ = _e3880;
                                    } else {
                                        phi_6284_ = _e3889;
                                    }
                                    let _e3892 = phi_6284_;
                                    if (_e3830 > _e3835) {
                                        phi_6289_ = _e3830;
                                    } else {
                                        phi_6289_ = _e3835;
                                    }
                                    let _e3895 = phi_6289_;
                                    if (_e3840 > _e3848) {
                                        phi_6294_ = _e3840;
                                    } else {
                                        phi_6294_ = _e3848;
                                    }
                                    let _e3898 = phi_6294_;
                                    if (_e3895 > _e3898) {
                                        phi_6299_ = _e3895;
                                    } else {
                                        phi_6299_ = _e3898;
                                    }
                                    let _e3901 = phi_6299_;
                                    if (_e3853 > _e3858) {
                                        phi_6304_ = _e3853;
                                    } else {
                                        phi_6304_ = _e3858;
                                    }
                                    let _e3904 = phi_6304_;
                                    if (_e3863 > _e3871) {
                                        phi_6309_ = _e3863;
                                    } else {
                                        phi_6309_ = _e3871;
                                    }
                                    let _e3907 = phi_6309_;
                                    if (_e3904 > _e3907) {
                                        phi_6314_ = _e3904;
                                    } else {
                                        phi_6314_ = _e3907;
                                    }
                                    let _e3910 = phi_6314_;
                                    if (_e3901 > _e3910) {
                                        phi_6319_ = _e3901;
                                    } else {
                                        phi_6319_ = _e3910;
                                    }
                                    let _e3913 = phi_6319_;
                                    if (_e3819 < 0f) {
                                        phi_6325_ = -(_e3819);
                                    } else {
                                        phi_6325_ = _e3819;
                                    }
                                    let _e3917 = phi_6325_;
                                    if (_e3822 < 0f) {
                                        phi_6331_ = -(_e3822);
                                    } else {
                                        phi_6331_ = _e3822;
                                    }
                                    let _e3921 = phi_6331_;
                                    if (_e3825 < 0f) {
                                        phi_6338_ = -(_e3825);
                                    } else {
                                        phi_6338_ = _e3825;
                                    }
                                    let _e3926 = phi_6338_;
                                    let _e3927 = ((_e3917 + _e3921) + _e3926);
                                    let _e3932 = -(_e3913);
                                    if (_e3892 > _e3932) {
                                        phi_6349_ = _e3892;
                                    } else {
                                        phi_6349_ = _e3932;
                                    }
                                    let _e3935 = phi_6349_;
                                    let _e3940 = (((_e3935 - ((_e3927 * _e3809) * (0.000000059604645f * (17f / 2f)))) - (_e3927 * _e3816)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3943 = ((_e3579 * _e3573) - (_e3582 * _e3572));
                                    let _e3946 = ((_e3582 * _e3571) - (_e3576 * _e3573));
                                    let _e3949 = ((_e3576 * _e3572) - (_e3579 * _e3571));
                                    let _e3954 = (((_e3943 * _e3585[0]) + (_e3946 * _e3585[1])) + (_e3949 * _e3585[2]));
                                    let _e3959 = (((_e3943 * _e3602) + (_e3946 * _e3603)) + (_e3949 * _e3604));
                                    let _e3964 = (((_e3943 * _e3611) + (_e3946 * _e3612)) + (_e3949 * _e3613));
                                    let _e3972 = (((_e3943 * _e3610[0]) + (_e3946 * _e3610[1])) + (_e3949 * _e3610[2]));
                                    let _e3977 = (((_e3943 * _e3616[0]) + (_e3946 * _e3616[1])) + (_e3949 * _e3616[2]));
                                    let _e3982 = (((_e3943 * _e3633) + (_e3946 * _e3634)) + (_e3949 * _e3635));
                                    let _e3987 = (((_e3943 * _e3642) + (_e3946 * _e3643)) + (_e3949 * _e3644));
                                    let _e3995 = (((_e3943 * _e3641[0]) + (_e3946 * _e3641[1])) + (_e3949 * _e3641[2]));
                                    if (_e3954 < _e3959) {
                                        phi_6420_ = _e3954;
                                    } else {
                                        phi_6420_ = _e3959;
                                    }
                                    let _e3998 = phi_6420_;
                                    if (_e3964 < _e3972) {
                                        phi_6425_ = _e3964;
                                    } else {
                                        phi_6425_ = _e3972;
                                    }
                                    let _e4001 = phi_6425_;
                                    if (_e3998 < _e4001) {
                                        phi_6430_ = _e3998;
                                    } else {
                                        phi_6430_ = _e4001;
                                    }
                                    let _e4004 = phi_6430_;
                                    if (_e3977 < _e3982) {
                                        phi_6435_ = _e3977;
                                    } else {
                                        phi_6435_ = _e3982;
                                    }
                                    let _e4007 = phi_6435_;
                                    if (_e3987 < _e3995) {
                                        phi_6440_ = _e3987;
                                    } else {
                                        phi_6440_ = _e3995;
                                    }
                                    let _e4010 = phi_6440_;
                                    if (_e4007 < _e4010) {
                                        phi_6445_ = _e4007;
                                    } else {
                                        phi_6445_ = _e4010;
                                    }
                                    let _e4013 = phi_6445_;
                                    if (_e4004 < _e4013) {
                                        phi_6450_ = _e4004;
                                    } else {
                                        phi_6450_ = _e4013;
                                    }
                                    let _e4016 = phi_6450_;
                                    if (_e3954 > _e3959) {
                                        phi_6455_ = _e3954;
                                    } else {
                                        phi_6455_ = _e3959;
                                    }
                                    let _e4019 = phi_6455_;
                                    if (_e3964 > _e3972) {
                                        phi_6460_ = _e3964;
                                    } else {
                                        phi_6460_ = _e3972;
                                    }
                                    let _e4022 = phi_6460_;
                                    if (_e4019 > _e4022) {
                                        phi_6465_ = _e4019;
                                    } else {
                                        phi_6465_ = _e4022;
                                    }
                                    let _e4025 = phi_6465_;
                                    if (_e3977 > _e3982) {
                                        phi_6470_ = _e3977;
                                    } else {
                                        phi_6470_ = _e3982;
                                    }
                                    let _e4028 = phi_6470_;
                                    if (_e3987 > _e3995) {
                                        phi_6475_ = _e3987;
                                    } else {
                                        phi_6475_ = _e3995;
                                    }
                                    let _e4031 = phi_6475_;
                                    if (_e4028 > _e4031) {
                                        phi_6480_ = _e4028;
                                    } else {
                                        phi_6480_ = _e4031;
                                    }
                                    let _e4034 = phi_6480_;
                                    if (_e4025 > _e4034) {
                                        phi_6485_ = _e4025;
                                    } else {
                                        phi_6485_ = _e4034;
                                    }
                                    let _e4037 = phi_6485_;
                                    if (_e3943 < 0f) {
                                        phi_6491_ = -(_e3943);
                                    } else {
                                        phi_6491_ = _e3943;
                                    }
                                    let _e4041 = phi_6491_;
                                    if (_e3946 < 0f) {
                                        phi_6497_ = -(_e3946);
                                    } else {
                                        phi_6497_ = _e3946;
                                    }
                                    let _e4045 = phi_6497_;
                                    if (_e3949 < 0f) {
                                        phi_6504_ = -(_e3949);
                                    } else {
                                        phi_6504_ = _e3949;
                                    }
                                    let _e4050 = phi_6504_;
                                    let _e4051 = ((_e4041 + _e4045) + _e4050);
                                    let _e4056 = -(_e4037);
                                    if (_e4016 > _e4056) {
                                        phi_6515_ = _e4016;
                                    } else {
                                        phi_6515_ = _e4056;
                                    }
                                    let _e4059 = phi_6515_;
                                    let _e4064 = (((_e4059 - ((_e4051 * _e3809) * (0.000000059604645f * (17f / 2f)))) - (_e4051 * _e3816)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3940 > _e4064) {
                                        phi_6525_ = _e3940;
                                    } else {
                                        phi_6525_ = _e4064;
                                    }
                                    let _e4067 = phi_6525_;
                                    if true {
                                        let _e4068 = (_e3571 - _e3556);
                                        let _e4069 = (_e3572 - _e3557);
                                        let _e4070 = (_e3573 - _e3558);
                                        let _e4073 = ((_e3579 * _e4070) - (_e3582 * _e4069));
                                        let _e4076 = ((_e3582 * _e4068) - (_e3576 * _e4070));
                                        let _e4079 = ((_e3576 * _e4069) - (_e3579 * _e4068));
                                        let _e4084 = (((_e4073 * _e3585[0]) + (_e4076 * _e3585[1])) + (_e4079 * _e3585[2]));
                                        let _e4089 = (((_e4073 * _e3602) + (_e4076 * _e3603)) + (_e4079 * _e3604));
                                        let _e4094 = (((_e4073 * _e3611) + (_e4076 * _e3612)) + (_e4079 * _e3613));
                                        let _e4102 = (((_e4073 * _e3610[0]) + (_e4076 * _e3610[1])) + (_e4079 * _e3610[2]));
                                        let _e4107 = (((_e4073 * _e3616[0]) + (_e4076 * _e3616[1])) + (_e4079 * _e3616[2]));
                                        let _e4112 = (((_e4073 * _e3633) + (_e4076 * _e3634)) + (_e4079 * _e3635));
                                        let _e4117 = (((_e4073 * _e3642) + (_e4076 * _e3643)) + (_e4079 * _e3644));
                                        let _e4125 = (((_e4073 * _e3641[0]) + (_e4076 * _e3641[1])) + (_e4079 * _e3641[2]));
                                        if (_e4084 < _e4089) {
                                            phi_6598_ = _e4084;
                                        } else {
                                            phi_6598_ = _e4089;
                                        }
                                        let _e4128 = phi_6598_;
                                        if (_e4094 < _e4102) {
                                            phi_6603_ = _e4094;
                                        } else {
                                            phi_6603_ = _e4102;
                                        }
                                        let _e4131 = phi_6603_;
                                        if (_e4128 < _e4131) {
                                            phi_6608_ = _e4128;
                                        } else {
                                            phi_6608_ = _e4131;
                                        }
                                        let _e4134 = phi_6608_;
                                        if (_e4107 < _e4112) {
                                            phi_6613_ = _e4107;
                                        } else {
                                            phi_6613_ = _e4112;
                                        }
                                        let _e4137 = phi_6613_;
                                        if (_e4117 < _e4125) {
                                            phi_6618_ = _e4117;
                                        } else {
                                            phi_6618_ = _e4125;
                                        }
                                        let _e4140 = phi_6618_;
                                        if (_e4137 < _e4140) {
                                            phi_6623_ = _e4137;
                                        } else {
                                            phi_6623_ = _e4140;
                                        }
                                        let _e4143 = phi_6623_;
                                        if (_e4134 < _e4143) {
                                            phi_6628_ = _e4134;
                                        } else {
                                            phi_6628_ = _e4143;
                                        }
                                        let _e4146 = phi_6628_;
                                        if (_e4084 > _e4089) {
                                            phi_6633_ = _e4084;
                                        } else {
                                            phi_6633_ = _e4089;
                                        }
                                        let _e4149 = phi_6633_;
                                        if (_e4094 > _e4102) {
                                            phi_6638_ = _e4094;
                                        } else {
                                            phi_6638_ = _e4102;
                                        }
                                        let _e4152 = phi_6638_;
                                        if (_e4149 > _e4152) {
                                            phi_6643_ = _e4149;
                                        } else {
                                            phi_6643_ = _e4152;
                                        }
                                        let _e4155 = phi_6643_;
                                        if (_e4107 > _e4112) {
                                            phi_6648_ = _e4107;
                                        } else {
                                            phi_6648_ = _e4112;
                                        }
                                        let _e4158 = phi_6648_;
                                        if (_e4117 > _e4125) {
                                            phi_6653_ = _e4117;
                                        } else {
                                            phi_6653_ = _e4125;
                                        }
                                        let _e4161 = phi_6653_;
                                        if (_e4158 > _e4161) {
                                            phi_6658_ = _e4158;
                                        } else {
                                            phi_6658_ = _e4161;
                                        }
                                        let _e4164 = phi_6658_;
                                        if (_e4155 > _e4164) {
                                            phi_6663_ = _e4155;
                                        } else {
                                            phi_6663_ = _e4164;
                                        }
                                        let _e4167 = phi_6663_;
                                        if (_e4073 < 0f) {
                                            phi_6669_ = -(_e4073);
                                        } else {
                                            phi_6669_ = _e4073;
                                        }
                                        let _e4171 = phi_6669_;
                                        if (_e4076 < 0f) {
                                            phi_6675_ = -(_e4076);
                                        } else {
                                            phi_6675_ = _e4076;
                                        }
                                        let _e4175 = phi_6675_;
                                        if (_e4079 < 0f) {
                                            phi_6682_ = -(_e4079);
                                        } else {
                                            phi_6682_ = _e4079;
                                        }
                                        let _e4180 = phi_6682_;
                                        let _e4181 = ((_e4171 + _e4175) + _e4180);
                                        let _e4186 = -(_e4167);
                                        if (_e4146 > _e4186) {
                                            phi_6693_ = _e4146;
                                        } else {
                                            phi_6693_ = _e4186;
                                        }
                                        let _e4189 = phi_6693_;
                                        let _e4194 = (((_e4189 - ((_e4181 * _e3809) * (0.000000059604645f * (17f / 2f)))) - (_e4181 * _e3816)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4067 > _e4194) {
                                            phi_6703_ = _e4067;
                                        } else {
                                            phi_6703_ = _e4194;
                                        }
                                        let _e4197 = phi_6703_;
                                        phi_6704_ = _e4197;
                                    } else {
                                        phi_6704_ = _e4067;
                                    }
                                    let _e4199 = phi_6704_;
                                    phi_6707_ = (_e3543 || (_e4199 > 0f));
                                }
                                let _e4203 = phi_6707_;
                                if _e4203 {
                                    let _e4206 = local_1.member_1[0u];
                                    let _e4212 = local_1.member_2[0u];
                                    let _e4218 = ((_e4206[1] * _e4212[2]) - (_e4206[2] * _e4212[1]));
                                    let _e4221 = ((_e4206[2] * _e4212[0]) - (_e4206[0] * _e4212[2]));
                                    let _e4224 = ((_e4206[0] * _e4212[1]) - (_e4206[1] * _e4212[0]));
                                    let _e4227 = local_1.member_1[1u];
                                    let _e4233 = local_1.member_2[1u];
                                    let _e4239 = ((_e4227[1] * _e4233[2]) - (_e4227[2] * _e4233[1]));
                                    let _e4242 = ((_e4227[2] * _e4233[0]) - (_e4227[0] * _e4233[2]));
                                    let _e4245 = ((_e4227[0] * _e4233[1]) - (_e4227[1] * _e4233[0]));
                                    let _e4248 = local_1.member_1[0u];
                                    let _e4254 = local_1.member_2[1u];
                                    let _e4269 = local_1.member_1[1u];
                                    let _e4275 = local_1.member_2[0u];
                                    let _e4288 = (((_e4248[1] * _e4254[2]) - (_e4248[2] * _e4254[1])) + ((_e4269[1] * _e4275[2]) - (_e4269[2] * _e4275[1])));
                                    let _e4289 = (((_e4248[2] * _e4254[0]) - (_e4248[0] * _e4254[2])) + ((_e4269[2] * _e4275[0]) - (_e4269[0] * _e4275[2])));
                                    let _e4290 = (((_e4248[0] * _e4254[1]) - (_e4248[1] * _e4254[0])) + ((_e4269[0] * _e4275[1]) - (_e4269[1] * _e4275[0])));
                                    let _e4293 = local_1.member[0u];
                                    let _e4304 = local_1.member[1u];
                                    let _e4315 = local_1.member[0u];
                                    let _e4324 = ((((_e4304[0] * _e4218) + (_e4304[1] * _e4221)) + (_e4304[2] * _e4224)) + (((_e4315[0] * _e4288) + (_e4315[1] * _e4289)) + (_e4315[2] * _e4290)));
                                    let _e4327 = local_1.member[0u];
                                    let _e4338 = local_1.member[1u];
                                    let _e4347 = ((((_e4327[0] * _e4239) + (_e4327[1] * _e4242)) + (_e4327[2] * _e4245)) + (((_e4338[0] * _e4288) + (_e4338[1] * _e4289)) + (_e4338[2] * _e4290)));
                                    let _e4350 = local_1.member[1u];
                                    let _e4361 = local_1.member[0u];
                                    if (_e4361[0] < 0f) {
                                        phi_6952_ = -(_e4361[0]);
                                    } else {
                                        phi_6952_ = _e4361[0];
                                    }
                                    let _e4368 = phi_6952_;
                                    if (_e4361[1] < 0f) {
                                        phi_6959_ = -(_e4361[1]);
                                    } else {
                                        phi_6959_ = _e4361[1];
                                    }
                                    let _e4372 = phi_6959_;
                                    if (_e4368 > _e4372) {
                                        phi_6964_ = _e4368;
                                    } else {
                                        phi_6964_ = _e4372;
                                    }
                                    let _e4375 = phi_6964_;
                                    if (_e4361[2] < 0f) {
                                        phi_6971_ = -(_e4361[2]);
                                    } else {
                                        phi_6971_ = _e4361[2];
                                    }
                                    let _e4379 = phi_6971_;
                                    if (_e4375 > _e4379) {
                                        phi_6976_ = _e4375;
                                    } else {
                                        phi_6976_ = _e4379;
                                    }
                                    let _e4382 = phi_6976_;
                                    let _e4385 = local_1.member[1u];
                                    if (_e4385[0] < 0f) {
                                        phi_6989_ = -(_e4385[0]);
                                    } else {
                                        phi_6989_ = _e4385[0];
                                    }
                                    let _e4392 = phi_6989_;
                                    if (_e4385[1] < 0f) {
                                        phi_6996_ = -(_e4385[1]);
                                    } else {
                                        phi_6996_ = _e4385[1];
                                    }
                                    let _e4396 = phi_6996_;
                                    if (_e4392 > _e4396) {
                                        phi_7001_ = _e4392;
                                    } else {
                                        phi_7001_ = _e4396;
                                    }
                                    let _e4399 = phi_7001_;
                                    if (_e4385[2] < 0f) {
                                        phi_7008_ = -(_e4385[2]);
                                    } else {
                                        phi_7008_ = _e4385[2];
                                    }
                                    let _e4403 = phi_7008_;
                                    if (_e4399 > _e4403) {
                                        phi_7013_ = _e4399;
                                    } else {
                                        phi_7013_ = _e4403;
                                    }
                                    let _e4406 = phi_7013_;
                                    if (_e4382 > _e4406) {
                                        phi_7018_ = _e4382;
                                    } else {
                                        phi_7018_ = _e4406;
                                    }
                                    let _e4409 = phi_7018_;
                                    let _e4411 = local_1.member_3;
                                    let _e4412 = (_e4409 + _e4411);
                                    let _e4415 = local_1.member_1[0u];
                                    if (_e4415[0] < 0f) {
                                        phi_7035_ = -(_e4415[0]);
                                    } else {
                                        phi_7035_ = _e4415[0];
                                    }
                                    let _e4422 = phi_7035_;
                                    if (_e4415[1] < 0f) {
                                        phi_7042_ = -(_e4415[1]);
                                    } else {
                                        phi_7042_ = _e4415[1];
                                    }
                                    let _e4426 = phi_7042_;
                                    if (_e4422 > _e4426) {
                                        phi_7047_ = _e4422;
                                    } else {
                                        phi_7047_ = _e4426;
                                    }
                                    let _e4429 = phi_7047_;
                                    if (_e4415[2] < 0f) {
                                        phi_7054_ = -(_e4415[2]);
                                    } else {
                                        phi_7054_ = _e4415[2];
                                    }
                                    let _e4433 = phi_7054_;
                                    if (_e4429 > _e4433) {
                                        phi_7059_ = _e4429;
                                    } else {
                                        phi_7059_ = _e4433;
                                    }
                                    let _e4436 = phi_7059_;
                                    let _e4439 = local_1.member_1[1u];
                                    if (_e4439[0] < 0f) {
                                        phi_7073_ = -(_e4439[0]);
                                    } else {
                                        phi_7073_ = _e4439[0];
                                    }
                                    let _e4446 = phi_7073_;
                                    if (_e4439[1] < 0f) {
                                        phi_7080_ = -(_e4439[1]);
                                    } else {
                                        phi_7080_ = _e4439[1];
                                    }
                                    let _e4450 = phi_7080_;
                                    if (_e4446 > _e4450) {
                                        phi_7085_ = _e4446;
                                    } else {
                                        phi_7085_ = _e4450;
                                    }
                                    let _e4453 = phi_7085_;
                                    if (_e4439[2] < 0f) {
                                        phi_7092_ = -(_e4439[2]);
                                    } else {
                                        phi_7092_ = _e4439[2];
                                    }
                                    let _e4457 = phi_7092_;
                                    if (_e4453 > _e4457) {
                                        phi_7097_ = _e4453;
                                    } else {
                                        phi_7097_ = _e4457;
                                    }
                                    let _e4460 = phi_7097_;
                                    if (_e4436 > _e4460) {
                                        phi_7102_ = _e4436;
                                    } else {
                                        phi_7102_ = _e4460;
                                    }
                                    let _e4463 = phi_7102_;
                                    let _e4465 = local_1.member_3;
                                    let _e4466 = (_e4463 + _e4465);
                                    let _e4469 = local_1.member_2[0u];
                                    if (_e4469[0] < 0f) {
                                        phi_7119_ = -(_e4469[0]);
                                    } else {
                                        phi_7119_ = _e4469[0];
                                    }
                                    let _e4476 = phi_7119_;
                                    if (_e4469[1] < 0f) {
                                        phi_7126_ = -(_e4469[1]);
                                    } else {
                                        phi_7126_ = _e4469[1];
                                    }
                                    let _e4480 = phi_7126_;
                                    if (_e4476 > _e4480) {
                                        phi_7131_ = _e4476;
                                    } else {
                                        phi_7131_ = _e4480;
                                    }
                                    let _e4483 = phi_7131_;
                                    if (_e4469[2] < 0f) {
                                        phi_7138_ = -(_e4469[2]);
                                    } else {
                                        phi_7138_ = _e4469[2];
                                    }
                                    let _e4487 = phi_7138_;
                                    if (_e4483 > _e4487) {
                                        phi_7143_ = _e4483;
                                    } else {
                                        phi_7143_ = _e4487;
                                    }
                                    let _e4490 = phi_7143_;
                                    let _e4493 = local_1.member_2[1u];
                                    if (_e4493[0] < 0f) {
                                        phi_7157_ = -(_e4493[0]);
                                    } else {
                                        phi_7157_ = _e4493[0];
                                    }
                                    let _e4500 = phi_7157_;
                                    if (_e4493[1] < 0f) {
                                        phi_7164_ = -(_e4493[1]);
                                    } else {
                                        phi_7164_ = _e4493[1];
                                    }
                                    let _e4504 = phi_7164_;
                                    if (_e4500 > _e4504) {
                                        phi_7169_ = _e4500;
                                    } else {
                                        phi_7169_ = _e4504;
                                    }
                                    let _e4507 = phi_7169_;
                                    if (_e4493[2] < 0f) {
                                        phi_7176_ = -(_e4493[2]);
                                    } else {
                                        phi_7176_ = _e4493[2];
                                    }
                                    let _e4511 = phi_7176_;
                                    if (_e4507 > _e4511) {
                                        phi_7181_ = _e4507;
                                    } else {
                                        phi_7181_ = _e4511;
                                    }
                                    let _e4514 = phi_7181_;
                                    if (_e4490 > _e4514) {
                                        phi_7186_ = _e4490;
                                    } else {
                                        phi_7186_ = _e4514;
                                    }
                                    let _e4517 = phi_7186_;
                                    let _e4519 = local_1.member_3;
                                    let _e4520 = (_e4517 + _e4519);
                                    let _e4522 = ((_e4466 * 8f) * _e4520);
                                    let _e4529 = local_1.member_3;
                                    if (_e4218 < 0f) {
                                        phi_7217_ = -(_e4218);
                                    } else {
                                        phi_7217_ = _e4218;
                                    }
                                    let _e4546 = phi_7217_;
                                    if (_e4221 < 0f) {
                                        phi_7223_ = -(_e4221);
                                    } else {
                                        phi_7223_ = _e4221;
                                    }
                                    let _e4550 = phi_7223_;
                                    if (_e4224 < 0f) {
                                        phi_7230_ = -(_e4224);
                                    } else {
                                        phi_7230_ = _e4224;
                                    }
                                    let _e4555 = phi_7230_;
                                    let _e4556 = ((_e4546 + _e4550) + _e4555);
                                    if (_e4239 < 0f) {
                                        phi_7237_ = -(_e4239);
                                    } else {
                                        phi_7237_ = _e4239;
                                    }
                                    let _e4560 = phi_7237_;
                                    if (_e4242 < 0f) {
                                        phi_7243_ = -(_e4242);
                                    } else {
                                        phi_7243_ = _e4242;
                                    }
                                    let _e4564 = phi_7243_;
                                    if (_e4245 < 0f) {
                                        phi_7250_ = -(_e4245);
                                    } else {
                                        phi_7250_ = _e4245;
                                    }
                                    let _e4569 = phi_7250_;
                                    let _e4570 = ((_e4560 + _e4564) + _e4569);
                                    if (_e4556 > _e4570) {
                                        phi_7256_ = _e4556;
                                    } else {
                                        phi_7256_ = _e4570;
                                    }
                                    let _e4573 = phi_7256_;
                                    if (_e4288 < 0f) {
                                        phi_7262_ = -(_e4288);
                                    } else {
                                        phi_7262_ = _e4288;
                                    }
                                    let _e4577 = phi_7262_;
                                    if (_e4289 < 0f) {
                                        phi_7268_ = -(_e4289);
                                    } else {
                                        phi_7268_ = _e4289;
                                    }
                                    let _e4581 = phi_7268_;
                                    if (_e4290 < 0f) {
                                        phi_7275_ = -(_e4290);
                                    } else {
                                        phi_7275_ = _e4290;
                                    }
                                    let _e4586 = phi_7275_;
                                    let _e4588 = (((_e4577 + _e4581) + _e4586) * 0.5f);
                                    if (_e4573 > _e4588) {
                                        phi_7282_ = _e4573;
                                    } else {
                                        phi_7282_ = _e4588;
                                    }
                                    let _e4591 = phi_7282_;
                                    let _e4596 = local_1.member_3;
                                    let _e4609 = ((((_e4293[0] * _e4218) + (_e4293[1] * _e4221)) + (_e4293[2] * _e4224)) * 3f);
                                    let _e4610 = ((((_e4350[0] * _e4239) + (_e4350[1] * _e4242)) + (_e4350[2] * _e4245)) * 3f);
                                    if (_e4609 < _e4610) {
                                        phi_7306_ = _e4609;
                                    } else {
                                        phi_7306_ = _e4610;
                                    }
                                    let _e4613 = phi_7306_;
                                    if (_e4324 < _e4347) {
                                        phi_7311_ = _e4324;
                                    } else {
                                        phi_7311_ = _e4347;
                                    }
                                    let _e4616 = phi_7311_;
                                    if (_e4613 < _e4616) {
                                        phi_7316_ = _e4613;
                                    } else {
                                        phi_7316_ = _e4616;
                                    }
                                    let _e4619 = phi_7316_;
                                    if (_e4609 > _e4610) {
                                        phi_7321_ = _e4609;
                                    } else {
                                        phi_7321_ = _e4610;
                                    }
                                    let _e4622 = phi_7321_;
                                    if (_e4324 > _e4347) {
                                        phi_7326_ = _e4324;
                                    } else {
                                        phi_7326_ = _e4347;
                                    }
                                    let _e4625 = phi_7326_;
                                    if (_e4622 > _e4625) {
                                        phi_7331_ = _e4622;
                                    } else {
                                        phi_7331_ = _e4625;
                                    }
                                    let _e4628 = phi_7331_;
                                    let _e4633 = -(_e4628);
                                    if (_e4619 > _e4633) {
                                        phi_7341_ = _e4619;
                                    } else {
                                        phi_7341_ = _e4633;
                                    }
                                    let _e4636 = phi_7341_;
                                    let _e4638 = ((_e4636 - ((((((_e4412 * 8f) * _e4522) * (0.000000059604645f * (524f / 64f))) + ((_e4529 * 19f) * ((_e4412 * (_e4466 + _e4520)) + (_e4466 * _e4520)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4412) * ((1f + _e4466) * (1f + _e4520))))) + ((_e91.member_5 * (((_e4591 + (_e4522 * (0.000000059604645f * 8f))) + ((_e4596 * 6f) * (_e4466 + _e4520))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4466) * (1f + _e4520))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4638 {
                                        phi_8310_ = _e4638;
                                    } else {
                                        let _e4641 = local_1.member_1[0u];
                                        let _e4647 = local_1.member_1[1u];
                                        let _e4651 = (_e4641[0] + _e4647[0]);
                                        let _e4652 = (_e4641[1] + _e4647[1]);
                                        let _e4653 = (_e4641[2] + _e4647[2]);
                                        let _e4656 = local_1.member_2[0u];
                                        let _e4662 = local_1.member_2[1u];
                                        let _e4666 = (_e4656[0] + _e4662[0]);
                                        let _e4667 = (_e4656[1] + _e4662[1]);
                                        let _e4668 = (_e4656[2] + _e4662[2]);
                                        let _e4671 = ((_e4652 * _e4668) - (_e4653 * _e4667));
                                        let _e4674 = ((_e4653 * _e4666) - (_e4651 * _e4668));
                                        let _e4677 = ((_e4651 * _e4667) - (_e4652 * _e4666));
                                        let _e4680 = local_1.member[0u];
                                        let _e4687 = local_1.member_1[0u];
                                        let _e4693 = local_1.member_2[0u];
                                        let _e4697 = (_e4680[0] - _e4687[0]);
                                        let _e4698 = (_e4680[1] - _e4687[1]);
                                        let _e4699 = (_e4680[2] - _e4687[2]);
                                        if true {
                                            phi_7457_ = array<f32, 3>(_e4680[0], _e4680[1], _e4680[2]);
                                        } else {
                                            phi_7457_ = array<f32, 3>((_e4697 - _e4693[0]), (_e4698 - _e4693[1]), (_e4699 - _e4693[2]));
                                        }
                                        let _e4705 = phi_7457_;
                                        let _e4706 = (_e4680[0] - _e4693[0]);
                                        let _e4707 = (_e4680[1] - _e4693[1]);
                                        let _e4708 = (_e4680[2] - _e4693[2]);
                                        let _e4711 = local_1.member[1u];
                                        let _e4718 = local_1.member_1[1u];
                                        let _e4724 = local_1.member_2[1u];
                                        let _e4728 = (_e4711[0] - _e4718[0]);
                                        let _e4729 = (_e4711[1] - _e4718[1]);
                                        let _e4730 = (_e4711[2] - _e4718[2]);
                                        if true {
                                            phi_7522_ = array<f32, 3>(_e4711[0], _e4711[1], _e4711[2]);
                                        } else {
                                            phi_7522_ = array<f32, 3>((_e4728 - _e4724[0]), (_e4729 - _e4724[1]), (_e4730 - _e4724[2]));
                                        }
                                        let _e4736 = phi_7522_;
                                        let _e4737 = (_e4711[0] - _e4724[0]);
                                        let _e4738 = (_e4711[1] - _e4724[1]);
                                        let _e4739 = (_e4711[2] - _e4724[2]);
                                        let _e4742 = local_1.member[0u];
                                        if (_e4742[0] < 0f) {
                                            phi_7544_ = -(_e4742[0]);
                                        } else {
                                            phi_7544_ = _e4742[0];
                                        }
                                        let _e4749 = phi_7544_;
                                        if (_e4742[1] < 0f) {
                                            phi_7551_ = -(_e4742[1]);
                                        } else {
                                            phi_7551_ = _e4742[1];
                                        }
                                        let _e4753 = phi_7551_;
                                        if (_e4749 > _e4753) {
                                            phi_7556_ = _e4749;
                                        } else {
                                            phi_7556_ = _e4753;
                                        }
                                        let _e4756 = phi_7556_;
                                        if (_e4742[2] < 0f) {
                                            phi_7563_ = -(_e4742[2]);
                                        } else {
                                            phi_7563_ = _e4742[2];
                                        }
                                        let _e4760 = phi_7563_;
                                        if (_e4756 > _e4760) {
                                            phi_7568_ = _e4756;
                                        } else {
                                            phi_7568_ = _e4760;
                                        }
                                        let _e4763 = phi_7568_;
                                        let _e4766 = local_1.member[1u];
                                        if (_e4766[0] < 0f) {
                                            phi_7581_ = -(_e4766[0]);
                                        } else {
                                            phi_7581_ = _e4766[0];
                                        }
                                        let _e4773 = phi_7581_;
                                        if (_e4766[1] < 0f) {
                                            phi_7588_ = -(_e4766[1]);
                                        } else {
                                            phi_7588_ = _e4766[1];
                                        }
                                        let _e4777 = phi_7588_;
                                        if (_e4773 > _e4777) {
                                            phi_7593_ = _e4773;
                                        } else {
                                            phi_7593_ = _e4777;
                                        }
                                        let _e4780 = phi_7593_;
                                        if (_e4766[2] < 0f) {
                                            phi_7600_ = -(_e4766[2]);
                                        } else {
                                            phi_7600_ = _e4766[2];
                                        }
                                        let _e4784 = phi_7600_;
                                        if (_e4780 > _e4784) {
                                            phi_7605_ = _e4780;
                                        } else {
                                            phi_7605_ = _e4784;
                                        }
                                        let _e4787 = phi_7605_;
                                        if (_e4763 > _e4787) {
                                            phi_7610_ = _e4763;
                                        } else {
                                            phi_7610_ = _e4787;
                                        }
                                        let _e4790 = phi_7610_;
                                        let _e4792 = local_1.member_3;
                                        let _e4796 = local_1.member_1[0u];
                                        if (_e4796[0] < 0f) {
                                            phi_7627_ = -(_e4796[0]);
                                        } else {
                                            phi_7627_ = _e4796[0];
                                        }
                                        let _e4803 = phi_7627_;
                                        if (_e4796[1] < 0f) {
                                            phi_7634_ = -(_e4796[1]);
                                        } else {
                                            phi_7634_ = _e4796[1];
                                        }
                                        let _e4807 = phi_7634_;
                                        if (_e4803 > _e4807) {
                                            phi_7639_ = _e4803;
                                        } else {
                                            phi_7639_ = _e4807;
                                        }
                                        let _e4810 = phi_7639_;
                                        if (_e4796[2] < 0f) {
                                            phi_7646_ = -(_e4796[2]);
                                        } else {
                                            phi_7646_ = _e4796[2];
                                        }
                                        let _e4814 = phi_7646_;
                                        if (_e4810 > _e4814) {
                                            phi_7651_ = _e4810;
                                        } else {
                                            phi_7651_ = _e4814;
                                        }
                                        let _e4817 = phi_7651_;
                                        let _e4820 = local_1.member_1[1u];
                                        if (_e4820[0] < 0f) {
                                            phi_7665_ = -(_e4820[0]);
                                        } else {
                                            phi_7665_ = _e4820[0];
                                        }
                                        let _e4827 = phi_7665_;
                                        if (_e4820[1] < 0f) {
                                            phi_7672_ = -(_e4820[1]);
                                        } else {
                                            phi_7672_ = _e4820[1];
                                        }
                                        let _e4831 = phi_7672_;
                                        if (_e4827 > _e4831) {
                                            phi_7677_ = _e4827;
                                        } else {
                                            phi_7677_ = _e4831;
                                        }
                                        let _e4834 = phi_7677_;
                                        if (_e4820[2] < 0f) {
                                            phi_7684_ = -(_e4820[2]);
                                        } else {
                                            phi_7684_ = _e4820[2];
                                        }
                                        let _e4838 = phi_7684_;
                                        if (_e4834 > _e4838) {
                                            phi_7689_ = _e4834;
                                        } else {
                                            phi_7689_ = _e4838;
                                        }
                                        let _e4841 = phi_7689_;
                                        if (_e4817 > _e4841) {
                                            phi_7694_ = _e4817;
                                        } else {
                                            phi_7694_ = _e4841;
                                        }
                                        let _e4844 = phi_7694_;
                                        let _e4846 = local_1.member_3;
                                        let _e4850 = local_1.member_2[0u];
                                        if (_e4850[0] < 0f) {
                                            phi_7711_ = -(_e4850[0]);
                                        } else {
                                            phi_7711_ = _e4850[0];
                                        }
                                        let _e4857 = phi_7711_;
                                        if (_e4850[1] < 0f) {
                                            phi_7718_ = -(_e4850[1]);
                                        } else {
                                            phi_7718_ = _e4850[1];
                                        }
                                        let _e4861 = phi_7718_;
                                        if (_e4857 > _e4861) {
                                            phi_7723_ = _e4857;
                                        } else {
                                            phi_7723_ = _e4861;
                                        }
                                        let _e4864 = phi_7723_;
                                        if (_e4850[2] < 0f) {
                                            phi_7730_ = -(_e4850[2]);
                                        } else {
                                            phi_7730_ = _e4850[2];
                                        }
                                        let _e4868 = phi_7730_;
                                        if (_e4864 > _e4868) {
                                            phi_7735_ = _e4864;
                                        } else {
                                            phi_7735_ = _e4868;
                                        }
                                        let _e4871 = phi_7735_;
                                        let _e4874 = local_1.member_2[1u];
                                        if (_e4874[0] < 0f) {
                                            phi_7749_ = -(_e4874[0]);
                                        } else {
                                            phi_7749_ = _e4874[0];
                                        }
                                        let _e4881 = phi_7749_;
                                        if (_e4874[1] < 0f) {
                                            phi_7756_ = -(_e4874[1]);
                                        } else {
                                            phi_7756_ = _e4874[1];
                                        }
                                        let _e4885 = phi_7756_;
                                        if (_e4881 > _e4885) {
                                            phi_7761_ = _e4881;
                                        } else {
                                            phi_7761_ = _e4885;
                                        }
                                        let _e4888 = phi_7761_;
                                        if (_e4874[2] < 0f) {
                                            phi_7768_ = -(_e4874[2]);
                                        } else {
                                            phi_7768_ = _e4874[2];
                                        }
                                        let _e4892 = phi_7768_;
                                        if (_e4888 > _e4892) {
                                            phi_7773_ = _e4888;
                                        } else {
                                            phi_7773_ = _e4892;
                                        }
                                        let _e4895 = phi_7773_;
                                        if (_e4871 > _e4895) {
                                            phi_7778_ = _e4871;
                                        } else {
                                            phi_7778_ = _e4895;
                                        }
                                        let _e4898 = phi_7778_;
                                        let _e4900 = local_1.member_3;
                                        let _e4904 = ((((_e4790 + _e4792) + (_e4844 + _e4846)) + (_e4898 + _e4900)) * 2f);
                                        let _e4907 = local_1.member_3;
                                        let _e4911 = (((_e91.member_5 * 1.0001f) + (_e4907 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4914 = ((_e4674 * _e4653) - (_e4677 * _e4652));
                                        let _e4917 = ((_e4677 * _e4651) - (_e4671 * _e4653));
                                        let _e4920 = ((_e4671 * _e4652) - (_e4674 * _e4651));
                                        let _e4925 = (((_e4914 * _e4680[0]) + (_e4917 * _e4680[1])) + (_e4920 * _e4680[2]));
                                        let _e4930 = (((_e4914 * _e4697) + (_e4917 * _e4698)) + (_e4920 * _e4699));
                                        let _e4935 = (((_e4914 * _e4706) + (_e4917 * _e4707)) + (_e4920 * _e4708));
                                        let _e4943 = (((_e4914 * _e4705[0]) + (_e4917 * _e4705[1])) + (_e4920 * _e4705[2]));
                                        let _e4948 = (((_e4914 * _e4711[0]) + (_e4917 * _e4711[1])) + (_e4920 * _e4711[2]));
                                        let _e4953 = (((_e4914 * _e4728) + (_e4917 * _e4729)) + (_e4920 * _e4730));
                                        let _e4958 = (((_e4914 * _e4737) + (_e4917 * _e4738)) + (_e4920 * _e4739));
                                        let _e4966 = (((_e4914 * _e4736[0]) + (_e4917 * _e4736[1])) + (_e4920 * _e4736[2]));
                                        if (_e4925 < _e4930) {
                                            phi_7857_ = _e4925;
                                        } else {
                                            phi_7857_ = _e4930;
                                        }
                                        let _e4969 = phi_7857_;
                                        if (_e4935 < _e4943) {
                                            phi_7862_ = _e4935;
                                        } else {
                                            phi_7862_ = _e4943;
                                        }
                                        let _e4972 = phi_7862_;
                                        if (_e4969 < _e4972) {
                                            phi_7867_ = _e4969;
                                        } else {
                                            phi_7867_ = _e4972;
                                        }
                                        let _e4975 = phi_7867_;
                                        if (_e4948 < _e4953) {
                                            phi_7872_ = _e4948;
                                        } else {
                                            phi_7872_ = _e4953;
                                        }
                                        let _e4978 = phi_7872_;
                                        if (_e4958 < _e4966) {
                                            phi_7877_ = _e4958;
                                        } else {
                                            phi_7877_ = _e4966;
                                        }
                                        let _e4981 = phi_7877_;
                                        if (_e4978 < _e4981) {
                                            phi_7882_ = _e4978;
                                        } else {
                                            phi_7882_ = _e4981;
                                        }
                                        let _e4984 = phi_7882_;
                                        if (_e4975 < _e4984) {
                                            phi_7887_ = _e4975;
                                        } else {
                                            phi_7887_ = _e4984;
                                        }
                                        let _e4987 = phi_7887_;
                                        if (_e4925 > _e4930) {
                                            phi_7892_ = _e4925;
                                        } else {
                                            phi_7892_ = _e4930;
                                        }
                                        let _e4990 = phi_7892_;
                                        if (_e4935 > _e4943) {
                                            phi_7897_ = _e4935;
                                        } else {
                                            phi_7897_ = _e4943;
                                        }
                                        let _e4993 = phi_7897_;
                                        if (_e4990 > _e4993) {
                                            phi_7902_ = _e4990;
                                        } else {
                                            phi_7902_ = _e4993;
                                        }
                                        let _e4996 = phi_7902_;
                                        if (_e4948 > _e4953) {
                                            phi_7907_ = _e4948;
                                        } else {
                                            phi_7907_ = _e4953;
                                        }
                                        let _e4999 = phi_7907_;
                                        if (_e4958 > _e4966) {
                                            phi_7912_ = _e4958;
                                        } else {
                                            phi_7912_ = _e4966;
                                        }
                                        let _e5002 = phi_7912_;
                                        if (_e4999 > _e5002) {
                                            phi_7917_ = _e4999;
                                        } else {
                                            phi_7917_ = _e5002;
                                        }
                                        let _e5005 = phi_7917_;
                                        if (_e4996 > _e5005) {
                                            phi_7922_ = _e4996;
                                        } else {
                                            phi_7922_ = _e5005;
                                        }
                                        let _e5008 = phi_7922_;
                                        if (_e4914 < 0f) {
                                            phi_7928_ = -(_e4914);
                                        } else {
                                            phi_7928_ = _e4914;
                                        }
                                        let _e5012 = phi_7928_;
                                        if (_e4917 < 0f) {
                                            phi_7934_ = -(_e4917);
                                        } else {
                                            phi_7934_ = _e4917;
                                        }
                                        let _e5016 = phi_7934_;
                                        if (_e4920 < 0f) {
                                            phi_7941_ = -(_e4920);
                                        } else {
                                            phi_7941_ = _e4920;
                                        }
                                        let _e5021 = phi_7941_;
                                        let _e5022 = ((_e5012 + _e5016) + _e5021);
                                        let _e5027 = -(_e5008);
                                        if (_e4987 > _e5027) {
                                            phi_7952_ = _e4987;
                                        } else {
                                            phi_7952_ = _e5027;
                                        }
                                        let _e5030 = phi_7952_;
                                        let _e5035 = (((_e5030 - ((_e5022 * _e4904) * (0.000000059604645f * (17f / 2f)))) - (_e5022 * _e4911)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e5038 = ((_e4674 * _e4668) - (_e4677 * _e4667));
                                        let _e5041 = ((_e4677 * _e4666) - (_e4671 * _e4668));
                                        let _e5044 = ((_e4671 * _e4667) - (_e4674 * _e4666));
                                        let _e5049 = (((_e5038 * _e4680[0]) + (_e5041 * _e4680[1])) + (_e5044 * _e4680[2]));
                                        let _e5054 = (((_e5038 * _e4697) + (_e5041 * _e4698)) + (_e5044 * _e4699));
                                        let _e5059 = (((_e5038 * _e4706) + (_e5041 * _e4707)) + (_e5044 * _e4708));
                                        let _e5067 = (((_e5038 * _e4705[0]) + (_e5041 * _e4705[1])) + (_e5044 * _e4705[2]));
                                        let _e5072 = (((_e5038 * _e4711[0]) + (_e5041 * _e4711[1])) + (_e5044 * _e4711[2]));
                                        let _e5077 = (((_e5038 * _e4728) + (_e5041 * _e4729)) + (_e5044 * _e4730));
                                        let _e5082 = (((_e5038 * _e4737) + (_e5041 * _e4738)) + (_e5044 * _e4739));
                                        let _e5090 = (((_e5038 * _e4736[0]) + (_e5041 * _e4736[1])) + (_e5044 * _e4736[2]));
                                        if (_e5049 < _e5054) {
                                            phi_8023_ = _e5049;
                                        } else {
                                            phi_8023_ = _e5054;
                                        }
                                        let _e5093 = phi_8023_;
                                        if (_e5059 < _e5067) {
                                            phi_8028_ = _e5059;
                                        } else {
                                            phi_8028_ = _e5067;
                                        }
                                        let _e5096 = phi_8028_;
                                        if (_e5093 < _e5096) {
                                            phi_8033_ = _e5093;
                                        } else {
                                            phi_8033_ = _e5096;
                                        }
                                        let _e5099 = phi_8033_;
                                        if (_e5072 < _e5077) {
                                            phi_8038_ = _e5072;
                                        } else {
                                            phi_8038_ = _e5077;
                                        }
                                        let _e5102 = phi_8038_;
                                        if (_e5082 < _e5090) {
                                            phi_8043_ = _e5082;
                                        } else {
                                            phi_8043_ = _e5090;
                                        }
                                        let _e5105 = phi_8043_;
                                        if (_e5102 < _e5105) {
                                            phi_8048_ = _e5102;
                                        } else {
                                            phi_8048_ = _e5105;
                                        }
                                        let _e5108 = phi_8048_;
                                        if (_e5099 < _e5108) {
                                            phi_8053_ = _e5099;
                                        } else {
                                            phi_8053_ = _e5108;
                                        }
                                        let _e5111 = phi_8053_;
                                        if (_e5049 > _e5054) {
                                            phi_8058_ = _e5049;
                                        } else {
                                            phi_8058_ = _e5054;
                                        }
                                        let _e5114 = phi_8058_;
                                        if (_e5059 > _e5067) {
                                            phi_8063_ = _e5059;
                                        } else {
                                            phi_8063_ = _e5067;
                                        }
                                        let _e5117 = phi_8063_;
                                        if (_e5114 > _e5117) {
                                            phi_8068_ = _e5114;
                                        } else {
                                            phi_8068_ = _e5117;
                                        }
                                        let _e5120 = phi_8068_;
                                        if (_e5072 > _e5077) {
                                            phi_8073_ = _e5072;
                                        } else {
                                            phi_8073_ = _e5077;
                                        }
                                        let _e5123 = phi_8073_;
                                        if (_e5082 > _e5090) {
                                            phi_8078_ = _e5082;
                                        } else {
                                            phi_8078_ = _e5090;
                                        }
                                        let _e5126 = phi_8078_;
                                        if (_e5123 > _e5126) {
                                            phi_8083_ = _e5123;
                                        } else {
                                            phi_8083_ = _e5126;
                                        }
                                        let _e5129 = phi_8083_;
                                        if (_e5120 > _e5129) {
                                            phi_8088_ = _e5120;
                                        } else {
                                            phi_8088_ = _e5129;
                                        }
                                        let _e5132 = phi_8088_;
                                        if (_e5038 < 0f) {
                                            phi_8094_ = -(_e5038);
                                        } else {
                                            phi_8094_ = _e5038;
                                        }
                                        let _e5136 = phi_8094_;
                                        if (_e5041 < 0f) {
                                            phi_8100_ = -(_e5041);
                                        } else {
                                            phi_8100_ = _e5041;
                                        }
                                        let _e5140 = phi_8100_;
                                        if (_e5044 < 0f) {
                                            phi_8107_ = -(_e5044);
                                        } else {
                                            phi_8107_ = _e5044;
                                        }
                                        let _e5145 = phi_8107_;
                                        let _e5146 = ((_e5136 + _e5140) + _e5145);
                                        let _e5151 = -(_e5132);
                                        if (_e5111 > _e5151) {
                                            phi_8118_ = _e5111;
                                        } else {
                                            phi_8118_ = _e5151;
                                        }
                                        let _e5154 = phi_8118_;
                                        let _e5159 = (((_e5154 - ((_e5146 * _e4904) * (0.000000059604645f * (17f / 2f)))) - (_e5146 * _e4911)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5035 > _e5159) {
                                            phi_8128_ = _e5035;
                                        } else {
                                            phi_8128_ = _e5159;
                                        }
                                        let _e5162 = phi_8128_;
                                        if true {
                                            let _e5163 = (_e4666 - _e4651);
                                            let _e5164 = (_e4667 - _e4652);
                                            let _e5165 = (_e4668 - _e4653);
                                            let _e5168 = ((_e4674 * _e5165) - (_e4677 * _e5164));
                                            let _e5171 = ((_e4677 * _e5163) - (_e4671 * _e5165));
                                            let _e5174 = ((_e4671 * _e5164) - (_e4674 * _e5163));
                                            let _e5179 = (((_e5168 * _e4680[0]) + (_e5171 * _e4680[1])) + (_e5174 * _e4680[2]));
                                            let _e5184 = (((_e5168 * _e4697) + (_e5171 * _e4698)) + (_e5174 * _e4699));
                                            let _e5189 = (((_e5168 * _e4706) + (_e5171 * _e4707)) + (_e5174 * _e4708));
                                            let _e5197 = (((_e5168 * _e4705[0]) + (_e5171 * _e4705[1])) + (_e5174 * _e4705[2]));
                                            let _e5202 = (((_e5168 * _e4711[0]) + (_e5171 * _e4711[1])) + (_e5174 * _e4711[2]));
                                            let _e5207 = (((_e5168 * _e4728) + (_e5171 * _e4729)) + (_e5174 * _e4730));
                                            let _e5212 = (((_e5168 * _e4737) + (_e5171 * _e4738)) + (_e5174 * _e4739));
                                            let _e5220 = (((_e5168 * _e4736[0]) + (_e5171 * _e4736[1])) + (_e5174 * _e4736[2]));
                                            if (_e5179 < _e5184) {
                                                phi_8201_ = _e5179;
                                            } else {
                                                phi_8201_ = _e5184;
                                            }
                                            let _e5223 = phi_8201_;
                                            if (_e5189 < _e5197) {
                                                phi_8206_ = _e5189;
                                            } else {
                                                phi_8206_ = _e5197;
                                            }
                                            let _e5226 = phi_8206_;
                                            if (_e5223 < _e5226) {
                                                phi_8211_ = _e5223;
                                            } else {
                                                phi_8211_ = _e5226;
                                            }
                                            let _e5229 = phi_8211_;
                                            if (_e5202 < _e5207) {
                                                phi_8216_ = _e5202;
                                            } else {
                                                phi_8216_ = _e5207;
                                            }
                                            let _e5232 = phi_8216_;
                                            if (_e5212 < _e5220) {
                                                phi_8221_ = _e5212;
                                            } else {
                                                phi_8221_ = _e5220;
                                            }
                                            let _e5235 = phi_8221_;
                                            if (_e5232 < _e5235) {
                                                phi_8226_ = _e5232;
                                            } else {
                                                phi_8226_ = _e5235;
                                            }
                                            let _e5238 = phi_8226_;
                                            if (_e5229 < _e5238) {
                                                phi_8231_ = _e5229;
                                            } else {
                                                phi_8231_ = _e5238;
                                            }
                                            let _e5241 = phi_8231_;
                                            if (_e5179 > _e5184) {
                                                phi_8236_ = _e5179;
                                            } else {
                                                phi_8236_ = _e5184;
                                            }
                                            let _e5244 = phi_8236_;
                                            if (_e5189 > _e5197) {
                                                phi_8241_ = _e5189;
                                            } else {
                                                phi_8241_ = _e5197;
                                            }
                                            let _e5247 = phi_8241_;
                                            if (_e5244 > _e5247) {
                                                phi_8246_ = _e5244;
                                            } else {
                                                phi_8246_ = _e5247;
                                            }
                                            let _e5250 = phi_8246_;
                                            if (_e5202 > _e5207) {
                                                phi_8251_ = _e5202;
                                            } else {
                                                phi_8251_ = _e5207;
                                            }
                                            let _e5253 = phi_8251_;
                                            if (_e5212 > _e5220) {
                                                phi_8256_ = _e5212;
                                            } else {
                                                phi_8256_ = _e5220;
                                            }
                                            let _e5256 = phi_8256_;
                                            if (_e5253 > _e5256) {
                                                phi_8261_ = _e5253;
                                            } else {
                                                phi_8261_ = _e5256;
                                            }
                                            let _e5259 = phi_8261_;
                                            if (_e5250 > _e5259) {
                                                phi_8266_ = _e5250;
                                            } else {
                                                phi_8266_ = _e5259;
                                            }
                                            let _e5262 = phi_8266_;
                                            if (_e5168 < 0f) {
                                                phi_8272_ = -(_e5168);
                                            } else {
                                                phi_8272_ = _e5168;
                                            }
                                            let _e5266 = phi_8272_;
                                            if (_e5171 < 0f) {
                                                phi_8278_ = -(_e5171);
                                            } else {
                                                phi_8278_ = _e5171;
                                            }
                                            let _e5270 = phi_8278_;
                                            if (_e5174 < 0f) {
                                                phi_8285_ = -(_e5174);
                                            } else {
                                                phi_8285_ = _e5174;
                                            }
                                            let _e5275 = phi_8285_;
                                            let _e5276 = ((_e5266 + _e5270) + _e5275);
                                            let _e5281 = -(_e5262);
                                            if (_e5241 > _e5281) {
                                                phi_8296_ = _e5241;
                                            } else {
                                                phi_8296_ = _e5281;
                                            }
                                            let _e5284 = phi_8296_;
                                            let _e5289 = (((_e5284 - ((_e5276 * _e4904) * (0.000000059604645f * (17f / 2f)))) - (_e5276 * _e4911)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                            if (_e5162 > _e5289) {
                                                phi_8306_ = _e5162;
                                            } else {
                                                phi_8306_ = _e5289;
                                            }
                                            let _e5292 = phi_8306_;
                                            phi_8307_ = _e5292;
                                        } else {
                                            phi_8307_ = _e5162;
                                        }
                                        let _e5294 = phi_8307_;
                                        phi_8310_ = (_e4638 || (_e5294 > 0f));
                                    }
                                    let _e5298 = phi_8310_;
                                    phi_8312_ = (_e4203 && _e5298);
                                } else {
                                    phi_8312_ = _e4203;
                                }
                                let _e5301 = phi_8312_;
                                if _e5301 {
                                } else {
                                    let _e5303 = atomicAdd((&counters[7u]), 1u);
                                    hits[_e2865] = ((2147483648u | (_e5303 << bitcast<u32>(12i))) | _e2868);
                                }
                                phi_8322_ = true;
                            }
                            let _e5310 = phi_8322_;
                            phi_8323_ = _e5310;
                        } else {
                            phi_8323_ = false;
                        }
                        let _e5312 = phi_8323_;
                        continue;
                        continuing {
                            phi_4741_ = _e2857;
                            break if !(_e5312);
                        }
                    }
                    let _e5316 = params.member.member_1.member_3;
                    workgroupBarrier();
                    if (_e73 == 0u) {
                        let _e5319 = atomicLoad((&counters[7u]));
                        if (_e5319 > 0u) {
                            let _e5322 = atomicAdd((&output.member[0u]), _e5319);
                            if ((_e5322 + _e5319) < _e5322) {
                                let _e5326 = atomicAdd((&output.member[2u]), 1u);
                            }
                            atomicStore((&counters[8u]), _e5322);
                        }
                        atomicStore((&counters[5u]), 0u);
                        atomicStore((&counters[6u]), 0u);
                        atomicStore((&counters[7u]), 0u);
                    }
                    workgroupBarrier();
                    let _e5332 = atomicLoad((&counters[8u]));
                    phi_8359_ = type_9(0u, 4u);
                    loop {
                        let _e5334 = phi_8359_;
                        if (_e5334.member < _e5334.member_1) {
                            phi_8360_ = type_9((_e5334.member + 1u), _e5334.member_1);
                            phi_8383_ = type_9(1u, _e5334.member);
                        } else {
                            phi_8360_ = _e5334;
                            phi_8383_ = type_9(0u, type_9().member_1);
                        }
                        let _e5346 = phi_8360_;
                        let _e5348 = phi_8383_;
                        if (bitcast<i32>(_e5348.member) != 0i) {
                            let _e5354 = (_e73 + (_e5348.member_1 * 128u));
                            if (_e5354 >= _e2843) {
                                phi_8478_ = false;
                            } else {
                                let _e5357 = hits[_e5354];
                                if ((_e5357 & 2147483648u) == 0u) {
                                    phi_8407_ = 4294967295u;
                                } else {
                                    phi_8407_ = ((_e5357 & 2147483647u) >> bitcast<u32>(12i));
                                }
                                let _e5364 = phi_8407_;
                                if (_e5364 != 4294967295u) {
                                    let _e5368 = ((_e5357 >> bitcast<u32>(10i)) & 3u);
                                    let _e5375 = firsts[(2u * _e5368)];
                                    let _e5380 = firsts[((2u * _e5368) + 1u)];
                                    let _e5383 = leaves.member[(_e5375 + ((_e5357 >> bitcast<u32>(5i)) & 31u))];
                                    let _e5386 = leaves.member[(_e5380 + (_e5357 & 31u))];
                                    let _e5388 = (_e5332 + _e5364);
                                    if (_e5388 < _e5316) {
                                        let _e5390 = (2u * _e5388);
                                        atomicStore((&output.member[(4u + _e5390)]), _e5383.w);
                                        atomicStore((&output.member[(_e5390 + 5u)]), _e5386.w);
                                    }
                                }
                                phi_8478_ = true;
                            }
                            let _e5396 = phi_8478_;
                            phi_8479_ = _e5396;
                        } else {
                            phi_8479_ = false;
                        }
                        let _e5398 = phi_8479_;
                        continue;
                        continuing {
                            phi_8359_ = _e5346;
                            break if !(_e5398);
                        }
                    }
                    workgroupBarrier();
                    let _e5982 = local_7;
                    phi_1277_ = _e5982;
                } else {
                    phi_1277_ = type_9();
                }
                let _e5401 = phi_1277_;
                continue;
                continuing {
                    phi_1273_ = _e626;
                    phi_1276_ = _e5401;
                    break if !(_e632);
                }
            }
        }
        continue;
        continuing {
            phi_510_ = _e163;
            break if !(_e169);
        }
    }
    if (_e73 == 0u) {
        let _e5406 = atomicLoad((&counters[9u]));
        if (_e5406 > 0u) {
            let _e5409 = atomicAdd((&output.member[1u]), _e5406);
            if ((_e5409 + _e5406) < _e5409) {
                let _e5413 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_8(id, n, lane);
}
