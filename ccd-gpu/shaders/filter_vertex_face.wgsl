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
    var phi_4736_: bool;
    var phi_4737_: bool;
    var phi_4742_: type_9;
    var phi_4743_: type_9;
    var phi_4766_: type_9;
    var phi_4971_: type_39;
    var phi_5350_: f32;
    var phi_5357_: f32;
    var phi_5362_: f32;
    var phi_5369_: f32;
    var phi_5374_: f32;
    var phi_5387_: f32;
    var phi_5394_: f32;
    var phi_5399_: f32;
    var phi_5406_: f32;
    var phi_5411_: f32;
    var phi_5416_: f32;
    var phi_5433_: f32;
    var phi_5440_: f32;
    var phi_5445_: f32;
    var phi_5452_: f32;
    var phi_5457_: f32;
    var phi_5471_: f32;
    var phi_5478_: f32;
    var phi_5483_: f32;
    var phi_5490_: f32;
    var phi_5495_: f32;
    var phi_5500_: f32;
    var phi_5517_: f32;
    var phi_5524_: f32;
    var phi_5529_: f32;
    var phi_5536_: f32;
    var phi_5541_: f32;
    var phi_5555_: f32;
    var phi_5562_: f32;
    var phi_5567_: f32;
    var phi_5574_: f32;
    var phi_5579_: f32;
    var phi_5584_: f32;
    var phi_5615_: f32;
    var phi_5621_: f32;
    var phi_5628_: f32;
    var phi_5635_: f32;
    var phi_5641_: f32;
    var phi_5648_: f32;
    var phi_5654_: f32;
    var phi_5660_: f32;
    var phi_5666_: f32;
    var phi_5673_: f32;
    var phi_5680_: f32;
    var phi_5704_: f32;
    var phi_5709_: f32;
    var phi_5714_: f32;
    var phi_5719_: f32;
    var phi_5724_: f32;
    var phi_5729_: f32;
    var phi_5739_: f32;
    var phi_5855_: array<f32, 3>;
    var phi_5920_: array<f32, 3>;
    var phi_5942_: f32;
    var phi_5949_: f32;
    var phi_5954_: f32;
    var phi_5961_: f32;
    var phi_5966_: f32;
    var phi_5979_: f32;
    var phi_5986_: f32;
    var phi_5991_: f32;
    var phi_5998_: f32;
    var phi_6003_: f32;
    var phi_6008_: f32;
    var phi_6025_: f32;
    var phi_6032_: f32;
    var phi_6037_: f32;
    var phi_6044_: f32;
    var phi_6049_: f32;
    var phi_6063_: f32;
    var phi_6070_: f32;
    var phi_6075_: f32;
    var phi_6082_: f32;
    var phi_6087_: f32;
    var phi_6092_: f32;
    var phi_6109_: f32;
    var phi_6116_: f32;
    var phi_6121_: f32;
    var phi_6128_: f32;
    var phi_6133_: f32;
    var phi_6147_: f32;
    var phi_6154_: f32;
    var phi_6159_: f32;
    var phi_6166_: f32;
    var phi_6171_: f32;
    var phi_6176_: f32;
    var phi_6255_: f32;
    var phi_6260_: f32;
    var phi_6265_: f32;
    var phi_6270_: f32;
    var phi_6275_: f32;
    var phi_6280_: f32;
    var phi_6285_: f32;
    var phi_6290_: f32;
    var phi_6295_: f32;
    var phi_6300_: f32;
    var phi_6305_: f32;
    var phi_6310_: f32;
    var phi_6315_: f32;
    var phi_6320_: f32;
    var phi_6326_: f32;
    var phi_6332_: f32;
    var phi_6339_: f32;
    var phi_6350_: f32;
    var phi_6421_: f32;
    var phi_6426_: f32;
    var phi_6431_: f32;
    var phi_6436_: f32;
    var phi_6441_: f32;
    var phi_6446_: f32;
    var phi_6451_: f32;
    var phi_6456_: f32;
    var phi_6461_: f32;
    var phi_6466_: f32;
    var phi_6471_: f32;
    var phi_6476_: f32;
    var phi_6481_: f32;
    var phi_6486_: f32;
    var phi_6492_: f32;
    var phi_6498_: f32;
    var phi_6505_: f32;
    var phi_6516_: f32;
    var phi_6526_: f32;
    var phi_6599_: f32;
    var phi_6604_: f32;
    var phi_6609_: f32;
    var phi_6614_: f32;
    var phi_6619_: f32;
    var phi_6624_: f32;
    var phi_6629_: f32;
    var phi_6634_: f32;
    var phi_6639_: f32;
    var phi_6644_: f32;
    var phi_6649_: f32;
    var phi_6654_: f32;
    var phi_6659_: f32;
    var phi_6664_: f32;
    var phi_6670_: f32;
    var phi_6676_: f32;
    var phi_6683_: f32;
    var phi_6694_: f32;
    var phi_6704_: f32;
    var phi_6705_: f32;
    var phi_6708_: bool;
    var phi_6953_: f32;
    var phi_6960_: f32;
    var phi_6965_: f32;
    var phi_6972_: f32;
    var phi_6977_: f32;
    var phi_6990_: f32;
    var phi_6997_: f32;
    var phi_7002_: f32;
    var phi_7009_: f32;
    var phi_7014_: f32;
    var phi_7019_: f32;
    var phi_7036_: f32;
    var phi_7043_: f32;
    var phi_7048_: f32;
    var phi_7055_: f32;
    var phi_7060_: f32;
    var phi_7074_: f32;
    var phi_7081_: f32;
    var phi_7086_: f32;
    var phi_7093_: f32;
    var phi_7098_: f32;
    var phi_7103_: f32;
    var phi_7120_: f32;
    var phi_7127_: f32;
    var phi_7132_: f32;
    var phi_7139_: f32;
    var phi_7144_: f32;
    var phi_7158_: f32;
    var phi_7165_: f32;
    var phi_7170_: f32;
    var phi_7177_: f32;
    var phi_7182_: f32;
    var phi_7187_: f32;
    var phi_7218_: f32;
    var phi_7224_: f32;
    var phi_7231_: f32;
    var phi_7238_: f32;
    var phi_7244_: f32;
    var phi_7251_: f32;
    var phi_7257_: f32;
    var phi_7263_: f32;
    var phi_7269_: f32;
    var phi_7276_: f32;
    var phi_7283_: f32;
    var phi_7307_: f32;
    var phi_7312_: f32;
    var phi_7317_: f32;
    var phi_7322_: f32;
    var phi_7327_: f32;
    var phi_7332_: f32;
    var phi_7342_: f32;
    var phi_7458_: array<f32, 3>;
    var phi_7523_: array<f32, 3>;
    var phi_7545_: f32;
    var phi_7552_: f32;
    var phi_7557_: f32;
    var phi_7564_: f32;
    var phi_7569_: f32;
    var phi_7582_: f32;
    var phi_7589_: f32;
    var phi_7594_: f32;
    var phi_7601_: f32;
    var phi_7606_: f32;
    var phi_7611_: f32;
    var phi_7628_: f32;
    var phi_7635_: f32;
    var phi_7640_: f32;
    var phi_7647_: f32;
    var phi_7652_: f32;
    var phi_7666_: f32;
    var phi_7673_: f32;
    var phi_7678_: f32;
    var phi_7685_: f32;
    var phi_7690_: f32;
    var phi_7695_: f32;
    var phi_7712_: f32;
    var phi_7719_: f32;
    var phi_7724_: f32;
    var phi_7731_: f32;
    var phi_7736_: f32;
    var phi_7750_: f32;
    var phi_7757_: f32;
    var phi_7762_: f32;
    var phi_7769_: f32;
    var phi_7774_: f32;
    var phi_7779_: f32;
    var phi_7858_: f32;
    var phi_7863_: f32;
    var phi_7868_: f32;
    var phi_7873_: f32;
    var phi_7878_: f32;
    var phi_7883_: f32;
    var phi_7888_: f32;
    var phi_7893_: f32;
    var phi_7898_: f32;
    var phi_7903_: f32;
    var phi_7908_: f32;
    var phi_7913_: f32;
    var phi_7918_: f32;
    var phi_7923_: f32;
    var phi_7929_: f32;
    var phi_7935_: f32;
    var phi_7942_: f32;
    var phi_7953_: f32;
    var phi_8024_: f32;
    var phi_8029_: f32;
    var phi_8034_: f32;
    var phi_8039_: f32;
    var phi_8044_: f32;
    var phi_8049_: f32;
    var phi_8054_: f32;
    var phi_8059_: f32;
    var phi_8064_: f32;
    var phi_8069_: f32;
    var phi_8074_: f32;
    var phi_8079_: f32;
    var phi_8084_: f32;
    var phi_8089_: f32;
    var phi_8095_: f32;
    var phi_8101_: f32;
    var phi_8108_: f32;
    var phi_8119_: f32;
    var phi_8129_: f32;
    var phi_8202_: f32;
    var phi_8207_: f32;
    var phi_8212_: f32;
    var phi_8217_: f32;
    var phi_8222_: f32;
    var phi_8227_: f32;
    var phi_8232_: f32;
    var phi_8237_: f32;
    var phi_8242_: f32;
    var phi_8247_: f32;
    var phi_8252_: f32;
    var phi_8257_: f32;
    var phi_8262_: f32;
    var phi_8267_: f32;
    var phi_8273_: f32;
    var phi_8279_: f32;
    var phi_8286_: f32;
    var phi_8297_: f32;
    var phi_8307_: f32;
    var phi_8308_: f32;
    var phi_8311_: bool;
    var phi_8313_: bool;
    var phi_8324_: bool;
    var phi_8325_: bool;
    var phi_8361_: type_9;
    var phi_8362_: type_9;
    var phi_8385_: type_9;
    var phi_8409_: u32;
    var phi_8480_: bool;
    var phi_8481_: bool;
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
                let _e5442 = local_6;
                phi_1155_ = _e5442;
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
                                phi_4736_ = false;
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
                                if !(_e2833) {
                                    let _e2836 = atomicAdd((&counters[6u]), 1u);
                                    hits[_e2836] = _e1560;
                                }
                                phi_4736_ = true;
                            }
                            let _e2839 = phi_4736_;
                            phi_4737_ = _e2839;
                        } else {
                            phi_4737_ = false;
                        }
                        let _e2841 = phi_4737_;
                        continue;
                        continuing {
                            phi_2861_ = _e1549;
                            break if !(_e2841);
                        }
                    }
                    workgroupBarrier();
                    let _e2844 = atomicLoad((&counters[6u]));
                    phi_4742_ = type_9(0u, 4u);
                    loop {
                        let _e2846 = phi_4742_;
                        if (_e2846.member < _e2846.member_1) {
                            phi_4743_ = type_9((_e2846.member + 1u), _e2846.member_1);
                            phi_4766_ = type_9(1u, _e2846.member);
                        } else {
                            phi_4743_ = _e2846;
                            phi_4766_ = type_9(0u, type_9().member_1);
                        }
                        let _e2858 = phi_4743_;
                        let _e2860 = phi_4766_;
                        if (bitcast<i32>(_e2860.member) != 0i) {
                            let _e2866 = (_e73 + (_e2860.member_1 * 128u));
                            if (_e2866 >= _e2844) {
                                phi_8324_ = false;
                            } else {
                                let _e2869 = hits[_e2866];
                                let _e2872 = ((_e2869 >> bitcast<u32>(10i)) & 3u);
                                let _e2879 = firsts[(2u * _e2872)];
                                let _e2884 = firsts[((2u * _e2872) + 1u)];
                                let _e2887 = leaves.member[(_e2879 + ((_e2869 >> bitcast<u32>(5i)) & 31u))];
                                let _e2890 = leaves.member[(_e2884 + (_e2869 & 31u))];
                                let _e2895 = paths.member[_e2887.x];
                                let _e2909 = paths.member[_e2890.x];
                                let _e2923 = paths.member[_e2890.y];
                                let _e2937 = paths.member[_e2890.z];
                                if false {
                                    phi_4971_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e2923.member.x - _e2895.member.x), (_e2923.member.y - _e2895.member.y), (_e2923.member.z - _e2895.member.z)), array<f32, 3>((_e2923.member_1.x - _e2895.member_1.x), (_e2923.member_1.y - _e2895.member_1.y), (_e2923.member_1.z - _e2895.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2909.member.x - _e2895.member.x), (_e2909.member.y - _e2895.member.y), (_e2909.member.z - _e2895.member.z)), array<f32, 3>((_e2909.member_1.x - _e2895.member_1.x), (_e2909.member_1.y - _e2895.member_1.y), (_e2909.member_1.z - _e2895.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2923.member.x - _e2937.member.x), (_e2923.member.y - _e2937.member.y), (_e2923.member.z - _e2937.member.z)), array<f32, 3>((_e2923.member_1.x - _e2937.member_1.x), (_e2923.member_1.y - _e2937.member_1.y), (_e2923.member_1.z - _e2937.member_1.z))), (_e91.member_4 + _e91.member_4));
                                } else {
                                    phi_4971_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e2895.member.x - _e2909.member.x), (_e2895.member.y - _e2909.member.y), (_e2895.member.z - _e2909.member.z)), array<f32, 3>((_e2895.member_1.x - _e2909.member_1.x), (_e2895.member_1.y - _e2909.member_1.y), (_e2895.member_1.z - _e2909.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2923.member.x - _e2909.member.x), (_e2923.member.y - _e2909.member.y), (_e2923.member.z - _e2909.member.z)), array<f32, 3>((_e2923.member_1.x - _e2909.member_1.x), (_e2923.member_1.y - _e2909.member_1.y), (_e2923.member_1.z - _e2909.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2937.member.x - _e2909.member.x), (_e2937.member.y - _e2909.member.y), (_e2937.member.z - _e2909.member.z)), array<f32, 3>((_e2937.member_1.x - _e2909.member_1.x), (_e2937.member_1.y - _e2909.member_1.y), (_e2937.member_1.z - _e2909.member_1.z))), (_e91.member_4 + _e91.member_4));
                                }
                                let _e3009 = phi_4971_;
                                let _e3023 = ((_e3009.member[0][0] + _e3009.member[1][0]) * 0.5f);
                                let _e3024 = ((_e3009.member[0][1] + _e3009.member[1][1]) * 0.5f);
                                let _e3025 = ((_e3009.member[0][2] + _e3009.member[1][2]) * 0.5f);
                                let _e3039 = ((_e3009.member_1[0][0] + _e3009.member_1[1][0]) * 0.5f);
                                let _e3040 = ((_e3009.member_1[0][1] + _e3009.member_1[1][1]) * 0.5f);
                                let _e3041 = ((_e3009.member_1[0][2] + _e3009.member_1[1][2]) * 0.5f);
                                let _e3055 = ((_e3009.member_2[0][0] + _e3009.member_2[1][0]) * 0.5f);
                                let _e3056 = ((_e3009.member_2[0][1] + _e3009.member_2[1][1]) * 0.5f);
                                let _e3057 = ((_e3009.member_2[0][2] + _e3009.member_2[1][2]) * 0.5f);
                                local = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e3009.member[0][0], _e3009.member[0][1], _e3009.member[0][2]), array<f32, 3>(_e3023, _e3024, _e3025)), array<array<f32, 3>, 2>(array<f32, 3>(_e3009.member_1[0][0], _e3009.member_1[0][1], _e3009.member_1[0][2]), array<f32, 3>(_e3039, _e3040, _e3041)), array<array<f32, 3>, 2>(array<f32, 3>(_e3009.member_2[0][0], _e3009.member_2[0][1], _e3009.member_2[0][2]), array<f32, 3>(_e3055, _e3056, _e3057)), _e3009.member_3);
                                local_1 = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e3023, _e3024, _e3025), array<f32, 3>(_e3009.member[1][0], _e3009.member[1][1], _e3009.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e3039, _e3040, _e3041), array<f32, 3>(_e3009.member_1[1][0], _e3009.member_1[1][1], _e3009.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e3055, _e3056, _e3057), array<f32, 3>(_e3009.member_2[1][0], _e3009.member_2[1][1], _e3009.member_2[1][2])), _e3009.member_3);
                                let _e3112 = local.member_1[0u];
                                let _e3118 = local.member_2[0u];
                                let _e3124 = ((_e3112[1] * _e3118[2]) - (_e3112[2] * _e3118[1]));
                                let _e3127 = ((_e3112[2] * _e3118[0]) - (_e3112[0] * _e3118[2]));
                                let _e3130 = ((_e3112[0] * _e3118[1]) - (_e3112[1] * _e3118[0]));
                                let _e3133 = local.member_1[1u];
                                let _e3139 = local.member_2[1u];
                                let _e3145 = ((_e3133[1] * _e3139[2]) - (_e3133[2] * _e3139[1]));
                                let _e3148 = ((_e3133[2] * _e3139[0]) - (_e3133[0] * _e3139[2]));
                                let _e3151 = ((_e3133[0] * _e3139[1]) - (_e3133[1] * _e3139[0]));
                                let _e3154 = local.member_1[0u];
                                let _e3160 = local.member_2[1u];
                                let _e3175 = local.member_1[1u];
                                let _e3181 = local.member_2[0u];
                                let _e3194 = (((_e3154[1] * _e3160[2]) - (_e3154[2] * _e3160[1])) + ((_e3175[1] * _e3181[2]) - (_e3175[2] * _e3181[1])));
                                let _e3195 = (((_e3154[2] * _e3160[0]) - (_e3154[0] * _e3160[2])) + ((_e3175[2] * _e3181[0]) - (_e3175[0] * _e3181[2])));
                                let _e3196 = (((_e3154[0] * _e3160[1]) - (_e3154[1] * _e3160[0])) + ((_e3175[0] * _e3181[1]) - (_e3175[1] * _e3181[0])));
                                let _e3199 = local.member[0u];
                                let _e3210 = local.member[1u];
                                let _e3221 = local.member[0u];
                                let _e3230 = ((((_e3210[0] * _e3124) + (_e3210[1] * _e3127)) + (_e3210[2] * _e3130)) + (((_e3221[0] * _e3194) + (_e3221[1] * _e3195)) + (_e3221[2] * _e3196)));
                                let _e3233 = local.member[0u];
                                let _e3244 = local.member[1u];
                                let _e3253 = ((((_e3233[0] * _e3145) + (_e3233[1] * _e3148)) + (_e3233[2] * _e3151)) + (((_e3244[0] * _e3194) + (_e3244[1] * _e3195)) + (_e3244[2] * _e3196)));
                                let _e3256 = local.member[1u];
                                let _e3267 = local.member[0u];
                                if (_e3267[0] < 0f) {
                                    phi_5350_ = -(_e3267[0]);
                                } else {
                                    phi_5350_ = _e3267[0];
                                }
                                let _e3274 = phi_5350_;
                                if (_e3267[1] < 0f) {
                                    phi_5357_ = -(_e3267[1]);
                                } else {
                                    phi_5357_ = _e3267[1];
                                }
                                let _e3278 = phi_5357_;
                                if (_e3274 > _e3278) {
                                    phi_5362_ = _e3274;
                                } else {
                                    phi_5362_ = _e3278;
                                }
                                let _e3281 = phi_5362_;
                                if (_e3267[2] < 0f) {
                                    phi_5369_ = -(_e3267[2]);
                                } else {
                                    phi_5369_ = _e3267[2];
                                }
                                let _e3285 = phi_5369_;
                                if (_e3281 > _e3285) {
                                    phi_5374_ = _e3281;
                                } else {
                                    phi_5374_ = _e3285;
                                }
                                let _e3288 = phi_5374_;
                                let _e3291 = local.member[1u];
                                if (_e3291[0] < 0f) {
                                    phi_5387_ = -(_e3291[0]);
                                } else {
                                    phi_5387_ = _e3291[0];
                                }
                                let _e3298 = phi_5387_;
                                if (_e3291[1] < 0f) {
                                    phi_5394_ = -(_e3291[1]);
                                } else {
                                    phi_5394_ = _e3291[1];
                                }
                                let _e3302 = phi_5394_;
                                if (_e3298 > _e3302) {
                                    phi_5399_ = _e3298;
                                } else {
                                    phi_5399_ = _e3302;
                                }
                                let _e3305 = phi_5399_;
                                if (_e3291[2] < 0f) {
                                    phi_5406_ = -(_e3291[2]);
                                } else {
                                    phi_5406_ = _e3291[2];
                                }
                                let _e3309 = phi_5406_;
                                if (_e3305 > _e3309) {
                                    phi_5411_ = _e3305;
                                } else {
                                    phi_5411_ = _e3309;
                                }
                                let _e3312 = phi_5411_;
                                if (_e3288 > _e3312) {
                                    phi_5416_ = _e3288;
                                } else {
                                    phi_5416_ = _e3312;
                                }
                                let _e3315 = phi_5416_;
                                let _e3317 = local.member_3;
                                let _e3318 = (_e3315 + _e3317);
                                let _e3321 = local.member_1[0u];
                                if (_e3321[0] < 0f) {
                                    phi_5433_ = -(_e3321[0]);
                                } else {
                                    phi_5433_ = _e3321[0];
                                }
                                let _e3328 = phi_5433_;
                                if (_e3321[1] < 0f) {
                                    phi_5440_ = -(_e3321[1]);
                                } else {
                                    phi_5440_ = _e3321[1];
                                }
                                let _e3332 = phi_5440_;
                                if (_e3328 > _e3332) {
                                    phi_5445_ = _e3328;
                                } else {
                                    phi_5445_ = _e3332;
                                }
                                let _e3335 = phi_5445_;
                                if (_e3321[2] < 0f) {
                                    phi_5452_ = -(_e3321[2]);
                                } else {
                                    phi_5452_ = _e3321[2];
                                }
                                let _e3339 = phi_5452_;
                                if (_e3335 > _e3339) {
                                    phi_5457_ = _e3335;
                                } else {
                                    phi_5457_ = _e3339;
                                }
                                let _e3342 = phi_5457_;
                                let _e3345 = local.member_1[1u];
                                if (_e3345[0] < 0f) {
                                    phi_5471_ = -(_e3345[0]);
                                } else {
                                    phi_5471_ = _e3345[0];
                                }
                                let _e3352 = phi_5471_;
                                if (_e3345[1] < 0f) {
                                    phi_5478_ = -(_e3345[1]);
                                } else {
                                    phi_5478_ = _e3345[1];
                                }
                                let _e3356 = phi_5478_;
                                if (_e3352 > _e3356) {
                                    phi_5483_ = _e3352;
                                } else {
                                    phi_5483_ = _e3356;
                                }
                                let _e3359 = phi_5483_;
                                if (_e3345[2] < 0f) {
                                    phi_5490_ = -(_e3345[2]);
                                } else {
                                    phi_5490_ = _e3345[2];
                                }
                                let _e3363 = phi_5490_;
                                if (_e3359 > _e3363) {
                                    phi_5495_ = _e3359;
                                } else {
                                    phi_5495_ = _e3363;
                                }
                                let _e3366 = phi_5495_;
                                if (_e3342 > _e3366) {
                                    phi_5500_ = _e3342;
                                } else {
                                    phi_5500_ = _e3366;
                                }
                                let _e3369 = phi_5500_;
                                let _e3371 = local.member_3;
                                let _e3372 = (_e3369 + _e3371);
                                let _e3375 = local.member_2[0u];
                                if (_e3375[0] < 0f) {
                                    phi_5517_ = -(_e3375[0]);
                                } else {
                                    phi_5517_ = _e3375[0];
                                }
                                let _e3382 = phi_5517_;
                                if (_e3375[1] < 0f) {
                                    phi_5524_ = -(_e3375[1]);
                                } else {
                                    phi_5524_ = _e3375[1];
                                }
                                let _e3386 = phi_5524_;
                                if (_e3382 > _e3386) {
                                    phi_5529_ = _e3382;
                                } else {
                                    phi_5529_ = _e3386;
                                }
                                let _e3389 = phi_5529_;
                                if (_e3375[2] < 0f) {
                                    phi_5536_ = -(_e3375[2]);
                                } else {
                                    phi_5536_ = _e3375[2];
                                }
                                let _e3393 = phi_5536_;
                                if (_e3389 > _e3393) {
                                    phi_5541_ = _e3389;
                                } else {
                                    phi_5541_ = _e3393;
                                }
                                let _e3396 = phi_5541_;
                                let _e3399 = local.member_2[1u];
                                if (_e3399[0] < 0f) {
                                    phi_5555_ = -(_e3399[0]);
                                } else {
                                    phi_5555_ = _e3399[0];
                                }
                                let _e3406 = phi_5555_;
                                if (_e3399[1] < 0f) {
                                    phi_5562_ = -(_e3399[1]);
                                } else {
                                    phi_5562_ = _e3399[1];
                                }
                                let _e3410 = phi_5562_;
                                if (_e3406 > _e3410) {
                                    phi_5567_ = _e3406;
                                } else {
                                    phi_5567_ = _e3410;
                                }
                                let _e3413 = phi_5567_;
                                if (_e3399[2] < 0f) {
                                    phi_5574_ = -(_e3399[2]);
                                } else {
                                    phi_5574_ = _e3399[2];
                                }
                                let _e3417 = phi_5574_;
                                if (_e3413 > _e3417) {
                                    phi_5579_ = _e3413;
                                } else {
                                    phi_5579_ = _e3417;
                                }
                                let _e3420 = phi_5579_;
                                if (_e3396 > _e3420) {
                                    phi_5584_ = _e3396;
                                } else {
                                    phi_5584_ = _e3420;
                                }
                                let _e3423 = phi_5584_;
                                let _e3425 = local.member_3;
                                let _e3426 = (_e3423 + _e3425);
                                let _e3428 = ((_e3372 * 8f) * _e3426);
                                let _e3435 = local.member_3;
                                if (_e3124 < 0f) {
                                    phi_5615_ = -(_e3124);
                                } else {
                                    phi_5615_ = _e3124;
                                }
                                let _e3452 = phi_5615_;
                                if (_e3127 < 0f) {
                                    phi_5621_ = -(_e3127);
                                } else {
                                    phi_5621_ = _e3127;
                                }
                                let _e3456 = phi_5621_;
                                if (_e3130 < 0f) {
                                    phi_5628_ = -(_e3130);
                                } else {
                                    phi_5628_ = _e3130;
                                }
                                let _e3461 = phi_5628_;
                                let _e3462 = ((_e3452 + _e3456) + _e3461);
                                if (_e3145 < 0f) {
                                    phi_5635_ = -(_e3145);
                                } else {
                                    phi_5635_ = _e3145;
                                }
                                let _e3466 = phi_5635_;
                                if (_e3148 < 0f) {
                                    phi_5641_ = -(_e3148);
                                } else {
                                    phi_5641_ = _e3148;
                                }
                                let _e3470 = phi_5641_;
                                if (_e3151 < 0f) {
                                    phi_5648_ = -(_e3151);
                                } else {
                                    phi_5648_ = _e3151;
                                }
                                let _e3475 = phi_5648_;
                                let _e3476 = ((_e3466 + _e3470) + _e3475);
                                if (_e3462 > _e3476) {
                                    phi_5654_ = _e3462;
                                } else {
                                    phi_5654_ = _e3476;
                                }
                                let _e3479 = phi_5654_;
                                if (_e3194 < 0f) {
                                    phi_5660_ = -(_e3194);
                                } else {
                                    phi_5660_ = _e3194;
                                }
                                let _e3483 = phi_5660_;
                                if (_e3195 < 0f) {
                                    phi_5666_ = -(_e3195);
                                } else {
                                    phi_5666_ = _e3195;
                                }
                                let _e3487 = phi_5666_;
                                if (_e3196 < 0f) {
                                    phi_5673_ = -(_e3196);
                                } else {
                                    phi_5673_ = _e3196;
                                }
                                let _e3492 = phi_5673_;
                                let _e3494 = (((_e3483 + _e3487) + _e3492) * 0.5f);
                                if (_e3479 > _e3494) {
                                    phi_5680_ = _e3479;
                                } else {
                                    phi_5680_ = _e3494;
                                }
                                let _e3497 = phi_5680_;
                                let _e3502 = local.member_3;
                                let _e3515 = ((((_e3199[0] * _e3124) + (_e3199[1] * _e3127)) + (_e3199[2] * _e3130)) * 3f);
                                let _e3516 = ((((_e3256[0] * _e3145) + (_e3256[1] * _e3148)) + (_e3256[2] * _e3151)) * 3f);
                                if (_e3515 < _e3516) {
                                    phi_5704_ = _e3515;
                                } else {
                                    phi_5704_ = _e3516;
                                }
                                let _e3519 = phi_5704_;
                                if (_e3230 < _e3253) {
                                    phi_5709_ = _e3230;
                                } else {
                                    phi_5709_ = _e3253;
                                }
                                let _e3522 = phi_5709_;
                                if (_e3519 < _e3522) {
                                    phi_5714_ = _e3519;
                                } else {
                                    phi_5714_ = _e3522;
                                }
                                let _e3525 = phi_5714_;
                                if (_e3515 > _e3516) {
                                    phi_5719_ = _e3515;
                                } else {
                                    phi_5719_ = _e3516;
                                }
                                let _e3528 = phi_5719_;
                                if (_e3230 > _e3253) {
                                    phi_5724_ = _e3230;
                                } else {
                                    phi_5724_ = _e3253;
                                }
                                let _e3531 = phi_5724_;
                                if (_e3528 > _e3531) {
                                    phi_5729_ = _e3528;
                                } else {
                                    phi_5729_ = _e3531;
                                }
                                let _e3534 = phi_5729_;
                                let _e3539 = -(_e3534);
                                if (_e3525 > _e3539) {
                                    phi_5739_ = _e3525;
                                } else {
                                    phi_5739_ = _e3539;
                                }
                                let _e3542 = phi_5739_;
                                let _e3544 = ((_e3542 - ((((((_e3318 * 8f) * _e3428) * (0.000000059604645f * (524f / 64f))) + ((_e3435 * 19f) * ((_e3318 * (_e3372 + _e3426)) + (_e3372 * _e3426)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3318) * ((1f + _e3372) * (1f + _e3426))))) + ((_e91.member_5 * (((_e3497 + (_e3428 * (0.000000059604645f * 8f))) + ((_e3502 * 6f) * (_e3372 + _e3426))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3372) * (1f + _e3426))))) * (3f * 1.0001f)))) > 0f);
                                if _e3544 {
                                    phi_6708_ = _e3544;
                                } else {
                                    let _e3547 = local.member_1[0u];
                                    let _e3553 = local.member_1[1u];
                                    let _e3557 = (_e3547[0] + _e3553[0]);
                                    let _e3558 = (_e3547[1] + _e3553[1]);
                                    let _e3559 = (_e3547[2] + _e3553[2]);
                                    let _e3562 = local.member_2[0u];
                                    let _e3568 = local.member_2[1u];
                                    let _e3572 = (_e3562[0] + _e3568[0]);
                                    let _e3573 = (_e3562[1] + _e3568[1]);
                                    let _e3574 = (_e3562[2] + _e3568[2]);
                                    let _e3577 = ((_e3558 * _e3574) - (_e3559 * _e3573));
                                    let _e3580 = ((_e3559 * _e3572) - (_e3557 * _e3574));
                                    let _e3583 = ((_e3557 * _e3573) - (_e3558 * _e3572));
                                    let _e3586 = local.member[0u];
                                    let _e3593 = local.member_1[0u];
                                    let _e3599 = local.member_2[0u];
                                    let _e3603 = (_e3586[0] - _e3593[0]);
                                    let _e3604 = (_e3586[1] - _e3593[1]);
                                    let _e3605 = (_e3586[2] - _e3593[2]);
                                    if true {
                                        phi_5855_ = array<f32, 3>(_e3586[0], _e3586[1], _e3586[2]);
                                    } else {
                                        phi_5855_ = array<f32, 3>((_e3603 - _e3599[0]), (_e3604 - _e3599[1]), (_e3605 - _e3599[2]));
                                    }
                                    let _e3611 = phi_5855_;
                                    let _e3612 = (_e3586[0] - _e3599[0]);
                                    let _e3613 = (_e3586[1] - _e3599[1]);
                                    let _e3614 = (_e3586[2] - _e3599[2]);
                                    let _e3617 = local.member[1u];
                                    let _e3624 = local.member_1[1u];
                                    let _e3630 = local.member_2[1u];
                                    let _e3634 = (_e3617[0] - _e3624[0]);
                                    let _e3635 = (_e3617[1] - _e3624[1]);
                                    let _e3636 = (_e3617[2] - _e3624[2]);
                                    if true {
                                        phi_5920_ = array<f32, 3>(_e3617[0], _e3617[1], _e3617[2]);
                                    } else {
                                        phi_5920_ = array<f32, 3>((_e3634 - _e3630[0]), (_e3635 - _e3630[1]), (_e3636 - _e3630[2]));
                                    }
                                    let _e3642 = phi_5920_;
                                    let _e3643 = (_e3617[0] - _e3630[0]);
                                    let _e3644 = (_e3617[1] - _e3630[1]);
                                    let _e3645 = (_e3617[2] - _e3630[2]);
                                    let _e3648 = local.member[0u];
                                    if (_e3648[0] < 0f) {
                                        phi_5942_ = -(_e3648[0]);
                                    } else {
                                        phi_5942_ = _e3648[0];
                                    }
                                    let _e3655 = phi_5942_;
                                    if (_e3648[1] < 0f) {
                                        phi_5949_ = -(_e3648[1]);
                                    } else {
                                        phi_5949_ = _e3648[1];
                                    }
                                    let _e3659 = phi_5949_;
                                    if (_e3655 > _e3659) {
                                        phi_5954_ = _e3655;
                                    } else {
                                        phi_5954_ = _e3659;
                                    }
                                    let _e3662 = phi_5954_;
                                    if (_e3648[2] < 0f) {
                                        phi_5961_ = -(_e3648[2]);
                                    } else {
                                        phi_5961_ = _e3648[2];
                                    }
                                    let _e3666 = phi_5961_;
                                    if (_e3662 > _e3666) {
                                        phi_5966_ = _e3662;
                                    } else {
                                        phi_5966_ = _e3666;
                                    }
                                    let _e3669 = phi_5966_;
                                    let _e3672 = local.member[1u];
                                    if (_e3672[0] < 0f) {
                                        phi_5979_ = -(_e3672[0]);
                                    } else {
                                        phi_5979_ = _e3672[0];
                                    }
                                    let _e3679 = phi_5979_;
                                    if (_e3672[1] < 0f) {
                                        phi_5986_ = -(_e3672[1]);
                                    } else {
                                        phi_5986_ = _e3672[1];
                                    }
                                    let _e3683 = phi_5986_;
                                    if (_e3679 > _e3683) {
                                        phi_5991_ = _e3679;
                                    } else {
                                        phi_5991_ = _e3683;
                                    }
                                    let _e3686 = phi_5991_;
                                    if (_e3672[2] < 0f) {
                                        phi_5998_ = -(_e3672[2]);
                                    } else {
                                        phi_5998_ = _e3672[2];
                                    }
                                    let _e3690 = phi_5998_;
                                    if (_e3686 > _e3690) {
                                        phi_6003_ = _e3686;
                                    } else {
                                        phi_6003_ = _e3690;
                                    }
                                    let _e3693 = phi_6003_;
                                    if (_e3669 > _e3693) {
                                        phi_6008_ = _e3669;
                                    } else {
                                        phi_6008_ = _e3693;
                                    }
                                    let _e3696 = phi_6008_;
                                    let _e3698 = local.member_3;
                                    let _e3702 = local.member_1[0u];
                                    if (_e3702[0] < 0f) {
                                        phi_6025_ = -(_e3702[0]);
                                    } else {
                                        phi_6025_ = _e3702[0];
                                    }
                                    let _e3709 = phi_6025_;
                                    if (_e3702[1] < 0f) {
                                        phi_6032_ = -(_e3702[1]);
                                    } else {
                                        phi_6032_ = _e3702[1];
                                    }
                                    let _e3713 = phi_6032_;
                                    if (_e3709 > _e3713) {
                                        phi_6037_ = _e3709;
                                    } else {
                                        phi_6037_ = _e3713;
                                    }
                                    let _e3716 = phi_6037_;
                                    if (_e3702[2] < 0f) {
                                        phi_6044_ = -(_e3702[2]);
                                    } else {
                                        phi_6044_ = _e3702[2];
                                    }
                                    let _e3720 = phi_6044_;
                                    if (_e3716 > _e3720) {
                                        phi_6049_ = _e3716;
                                    } else {
                                        phi_6049_ = _e3720;
                                    }
                                    let _e3723 = phi_6049_;
                                    let _e3726 = local.member_1[1u];
                                    if (_e3726[0] < 0f) {
                                        phi_6063_ = -(_e3726[0]);
                                    } else {
                                        phi_6063_ = _e3726[0];
                                    }
                                    let _e3733 = phi_6063_;
                                    if (_e3726[1] < 0f) {
                                        phi_6070_ = -(_e3726[1]);
                                    } else {
                                        phi_6070_ = _e3726[1];
                                    }
                                    let _e3737 = phi_6070_;
                                    if (_e3733 > _e3737) {
                                        phi_6075_ = _e3733;
                                    } else {
                                        phi_6075_ = _e3737;
                                    }
                                    let _e3740 = phi_6075_;
                                    if (_e3726[2] < 0f) {
                                        phi_6082_ = -(_e3726[2]);
                                    } else {
                                        phi_6082_ = _e3726[2];
                                    }
                                    let _e3744 = phi_6082_;
                                    if (_e3740 > _e3744) {
                                        phi_6087_ = _e3740;
                                    } else {
                                        phi_6087_ = _e3744;
                                    }
                                    let _e3747 = phi_6087_;
                                    if (_e3723 > _e3747) {
                                        phi_6092_ = _e3723;
                                    } else {
                                        phi_6092_ = _e3747;
                                    }
                                    let _e3750 = phi_6092_;
                                    let _e3752 = local.member_3;
                                    let _e3756 = local.member_2[0u];
                                    if (_e3756[0] < 0f) {
                                        phi_6109_ = -(_e3756[0]);
                                    } else {
                                        phi_6109_ = _e3756[0];
                                    }
                                    let _e3763 = phi_6109_;
                                    if (_e3756[1] < 0f) {
                                        phi_6116_ = -(_e3756[1]);
                                    } else {
                                        phi_6116_ = _e3756[1];
                                    }
                                    let _e3767 = phi_6116_;
                                    if (_e3763 > _e3767) {
                                        phi_6121_ = _e3763;
                                    } else {
                                        phi_6121_ = _e3767;
                                    }
                                    let _e3770 = phi_6121_;
                                    if (_e3756[2] < 0f) {
                                        phi_6128_ = -(_e3756[2]);
                                    } else {
                                        phi_6128_ = _e3756[2];
                                    }
                                    let _e3774 = phi_6128_;
                                    if (_e3770 > _e3774) {
                                        phi_6133_ = _e3770;
                                    } else {
                                        phi_6133_ = _e3774;
                                    }
                                    let _e3777 = phi_6133_;
                                    let _e3780 = local.member_2[1u];
                                    if (_e3780[0] < 0f) {
                                        phi_6147_ = -(_e3780[0]);
                                    } else {
                                        phi_6147_ = _e3780[0];
                                    }
                                    let _e3787 = phi_6147_;
                                    if (_e3780[1] < 0f) {
                                        phi_6154_ = -(_e3780[1]);
                                    } else {
                                        phi_6154_ = _e3780[1];
                                    }
                                    let _e3791 = phi_6154_;
                                    if (_e3787 > _e3791) {
                                        phi_6159_ = _e3787;
                                    } else {
                                        phi_6159_ = _e3791;
                                    }
                                    let _e3794 = phi_6159_;
                                    if (_e3780[2] < 0f) {
                                        phi_6166_ = -(_e3780[2]);
                                    } else {
                                        phi_6166_ = _e3780[2];
                                    }
                                    let _e3798 = phi_6166_;
                                    if (_e3794 > _e3798) {
                                        phi_6171_ = _e3794;
                                    } else {
                                        phi_6171_ = _e3798;
                                    }
                                    let _e3801 = phi_6171_;
                                    if (_e3777 > _e3801) {
                                        phi_6176_ = _e3777;
                                    } else {
                                        phi_6176_ = _e3801;
                                    }
                                    let _e3804 = phi_6176_;
                                    let _e3806 = local.member_3;
                                    let _e3810 = ((((_e3696 + _e3698) + (_e3750 + _e3752)) + (_e3804 + _e3806)) * 2f);
                                    let _e3813 = local.member_3;
                                    let _e3817 = (((_e91.member_5 * 1.0001f) + (_e3813 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3820 = ((_e3580 * _e3559) - (_e3583 * _e3558));
                                    let _e3823 = ((_e3583 * _e3557) - (_e3577 * _e3559));
                                    let _e3826 = ((_e3577 * _e3558) - (_e3580 * _e3557));
                                    let _e3831 = (((_e3820 * _e3586[0]) + (_e3823 * _e3586[1])) + (_e3826 * _e3586[2]));
                                    let _e3836 = (((_e3820 * _e3603) + (_e3823 * _e3604)) + (_e3826 * _e3605));
                                    let _e3841 = (((_e3820 * _e3612) + (_e3823 * _e3613)) + (_e3826 * _e3614));
                                    let _e3849 = (((_e3820 * _e3611[0]) + (_e3823 * _e3611[1])) + (_e3826 * _e3611[2]));
                                    let _e3854 = (((_e3820 * _e3617[0]) + (_e3823 * _e3617[1])) + (_e3826 * _e3617[2]));
                                    let _e3859 = (((_e3820 * _e3634) + (_e3823 * _e3635)) + (_e3826 * _e3636));
                                    let _e3864 = (((_e3820 * _e3643) + (_e3823 * _e3644)) + (_e3826 * _e3645));
                                    let _e3872 = (((_e3820 * _e3642[0]) + (_e3823 * _e3642[1])) + (_e3826 * _e3642[2]));
                                    if (_e3831 < _e3836) {
                                        phi_6255_ = _e3831;
                                    } else {
                                        phi_6255_ = _e3836;
                                    }
                                    let _e3875 = phi_6255_;
                                    if (_e3841 < _e3849) {
                                        phi_6260_ = _e3841;
                                    } else {
                                        phi_6260_ = _e3849;
                                    }
                                    let _e3878 = phi_6260_;
                                    if (_e3875 < _e3878) {
                                        phi_6265_ = _e3875;
                                    } else {
                                        phi_6265_ = _e3878;
                                    }
                                    let _e3881 = phi_6265_;
                                    if (_e3854 < _e3859) {
                                        phi_6270_ = _e3854;
                                    } else {
                                        phi_6270_ = _e3859;
                                    }
                                    let _e3884 = phi_6270_;
                                    if (_e3864 < _e3872) {
                                        phi_6275_ = _e3864;
                                    } else {
                                        phi_6275_ = _e3872;
                                    }
                                    let _e3887 = phi_6275_;
                                    if (_e3884 < _e3887) {
                                        phi_6280_ = _e3884;
                                    } else {
                                        phi_6280_ = _e3887;
                                    }
                                    let _e3890 = phi_6280_;
                                    if (_e3881 < _e3890) {
                                        phi_6285_ = _e3881;
                                    } else {
                                        phi_6285_ = _e3890;
                                    }
                                    let _e3893 = phi_6285_;
                                    if (_e3831 > _e3836) {
                                        phi_6290_ = _e3831;
                                    } else {
                                        phi_6290_ = _e3836;
                                    }
                                    let _e3896 = phi_6290_;
                                    if (_e3841 > _e3849) {
                                        phi_6295_ = _e3841;
                                    } else {
                                        phi_6295_ = _e3849;
                                    }
                                    let _e3899 = phi_6295_;
                                    if (_e3896 > _e3899) {
                                        phi_6300_ = _e3896;
                                    } else {
                                        phi_6300_ = _e3899;
                                    }
                                    let _e3902 = phi_6300_;
                                    if (_e3854 > _e3859) {
                                        phi_6305_ = _e3854;
                                    } else {
                                        phi_6305_ = _e3859;
                                    }
                                    let _e3905 = phi_6305_;
                                    if (_e3864 > _e3872) {
                                        phi_6310_ = _e3864;
                                    } else {
                                        phi_6310_ = _e3872;
                                    }
                                    let _e3908 = phi_6310_;
                                    if (_e3905 > _e3908) {
                                        phi_6315_ = _e3905;
                                    } else {
                                        phi_6315_ = _e3908;
                                    }
                                    let _e3911 = phi_6315_;
                                    if (_e3902 > _e3911) {
                                        phi_6320_ = _e3902;
                                    } else {
                                        phi_6320_ = _e3911;
                                    }
                                    let _e3914 = phi_6320_;
                                    if (_e3820 < 0f) {
                                        phi_6326_ = -(_e3820);
                                    } else {
                                        phi_6326_ = _e3820;
                                    }
                                    let _e3918 = phi_6326_;
                                    if (_e3823 < 0f) {
                                        phi_6332_ = -(_e3823);
                                    } else {
                                        phi_6332_ = _e3823;
                                    }
                                    let _e3922 = phi_6332_;
                                    if (_e3826 < 0f) {
                                        phi_6339_ = -(_e3826);
                                    } else {
                                        phi_6339_ = _e3826;
                                    }
                                    let _e3927 = phi_6339_;
                                    let _e3928 = ((_e3918 + _e3922) + _e3927);
                                    let _e3933 = -(_e3914);
                                    if (_e3893 > _e3933) {
                                        phi_6350_ = _e3893;
                                    } else {
                                        phi_6350_ = _e3933;
                                    }
                                    let _e3936 = phi_6350_;
                                    let _e3941 = (((_e3936 - ((_e3928 * _e3810) * (0.000000059604645f * (17f / 2f)))) - (_e3928 * _e3817)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3944 = ((_e3580 * _e3574) - (_e3583 * _e3573));
                                    let _e3947 = ((_e3583 * _e3572) - (_e3577 * _e3574));
                                    let _e3950 = ((_e3577 * _e3573) - (_e3580 * _e3572));
                                    let _e3955 = (((_e3944 * _e3586[0]) + (_e3947 * _e3586[1])) + (_e3950 * _e3586[2]));
                                    let _e3960 = (((_e3944 * _e3603) + (_e3947 * _e3604)) + (_e3950 * _e3605));
                                    let _e3965 = (((_e3944 * _e3612) + (_e3947 * _e3613)) + (_e3950 * _e3614));
                                    let _e3973 = (((_e3944 * _e3611[0]) + (_e3947 * _e3611[1])) + (_e3950 * _e3611[2]));
                                    let _e3978 = (((_e3944 * _e3617[0]) + (_e3947 * _e3617[1])) + (_e3950 * _e3617[2]));
                                    let _e3983 = (((_e3944 * _e3634) + (_e3947 * _e3635)) + (_e3950 * _e3636));
                                    let _e3988 = (((_e3944 * _e3643) + (_e3947 * _e3644)) + (_e3950 * _e3645));
                                    let _e3996 = (((_e3944 * _e3642[0]) + (_e3947 * _e3642[1])) + (_e3950 * _e3642[2]));
                                    if (_e3955 < _e3960) {
                                        phi_6421_ = _e3955;
                                    } else {
                                        phi_6421_ = _e3960;
                                    }
                                    let _e3999 = phi_6421_;
                                    if (_e3965 < _e3973) {
                                        phi_6426_ = _e3965;
                                    } else {
                                        phi_6426_ = _e3973;
                                    }
                                    let _e4002 = phi_6426_;
                                    if (_e3999 < _e4002) {
                                        phi_6431_ = _e3999;
                                    } else {
                                        phi_6431_ = _e4002;
                                    }
                                    let _e4005 = phi_6431_;
                                    if (_e3978 < _e3983) {
                                        phi_6436_ = _e3978;
                                    } else {
                                        phi_6436_ = _e3983;
                                    }
                                    let _e4008 = phi_6436_;
                                    if (_e3988 < _e3996) {
                                        phi_6441_ = _e3988;
                                    } else {
                                        phi_6441_ = _e3996;
                                    }
                                    let _e4011 = phi_6441_;
                                    if (_e4008 < _e4011) {
                                        phi_6446_ = _e4008;
                                    } else {
                                        phi_6446_ = _e4011;
                                    }
                                    let _e4014 = phi_6446_;
                                    if (_e4005 < _e4014) {
                                        phi_6451_ = _e4005;
                                    } else {
                                        phi_6451_ = _e4014;
                                    }
                                    let _e4017 = phi_6451_;
                                    if (_e3955 > _e3960) {
                                        phi_6456_ = _e3955;
                                    } else {
                                        phi_6456_ = _e3960;
                                    }
                                    let _e4020 = phi_6456_;
                                    if (_e3965 > _e3973) {
                                        phi_6461_ = _e3965;
                                    } else {
                                        phi_6461_ = _e3973;
                                    }
                                    let _e4023 = phi_6461_;
                                    if (_e4020 > _e4023) {
                                        phi_6466_ = _e4020;
                                    } else {
                                        phi_6466_ = _e4023;
                                    }
                                    let _e4026 = phi_6466_;
                                    if (_e3978 > _e3983) {
                                        phi_6471_ = _e3978;
                                    } else {
                                        phi_6471_ = _e3983;
                                    }
                                    let _e4029 = phi_6471_;
                                    if (_e3988 > _e3996) {
                                        phi_6476_ = _e3988;
                                    } else {
                                        phi_6476_ = _e3996;
                                    }
                                    let _e4032 = phi_6476_;
                                    if (_e4029 > _e4032) {
                                        phi_6481_ = _e4029;
                                    } else {
                                        phi_6481_ = _e4032;
                                    }
                                    let _e4035 = phi_6481_;
                                    if (_e4026 > _e4035) {
                                        phi_6486_ = _e4026;
                                    } else {
                                        phi_6486_ = _e4035;
                                    }
                                    let _e4038 = phi_6486_;
                                    if (_e3944 < 0f) {
                                        phi_6492_ = -(_e3944);
                                    } else {
                                        phi_6492_ = _e3944;
                                    }
                                    let _e4042 = phi_6492_;
                                    if (_e3947 < 0f) {
                                        phi_6498_ = -(_e3947);
                                    } else {
                                        phi_6498_ = _e3947;
                                    }
                                    let _e4046 = phi_6498_;
                                    if (_e3950 < 0f) {
                                        phi_6505_ = -(_e3950);
                                    } else {
                                        phi_6505_ = _e3950;
                                    }
                                    let _e4051 = phi_6505_;
                                    let _e4052 = ((_e4042 + _e4046) + _e4051);
                                    let _e4057 = -(_e4038);
                                    if (_e4017 > _e4057) {
                                        phi_6516_ = _e4017;
                                    } else {
                                        phi_6516_ = _e4057;
                                    }
                                    let _e4060 = phi_6516_;
                                    let _e4065 = (((_e4060 - ((_e4052 * _e3810) * (0.000000059604645f * (17f / 2f)))) - (_e4052 * _e3817)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3941 > _e4065) {
                                        phi_6526_ = _e3941;
                                    } else {
                                        phi_6526_ = _e4065;
                                    }
                                    let _e4068 = phi_6526_;
                                    if true {
                                        let _e4069 = (_e3572 - _e3557);
                                        let _e4070 = (_e3573 - _e3558);
                                        let _e4071 = (_e3574 - _e3559);
                                        let _e4074 = ((_e3580 * _e4071) - (_e3583 * _e4070));
                                        let _e4077 = ((_e3583 * _e4069) - (_e3577 * _e4071));
                                        let _e4080 = ((_e3577 * _e4070) - (_e3580 * _e4069));
                                        let _e4085 = (((_e4074 * _e3586[0]) + (_e4077 * _e3586[1])) + (_e4080 * _e3586[2]));
                                        let _e4090 = (((_e4074 * _e3603) + (_e4077 * _e3604)) + (_e4080 * _e3605));
                                        let _e4095 = (((_e4074 * _e3612) + (_e4077 * _e3613)) + (_e4080 * _e3614));
                                        let _e4103 = (((_e4074 * _e3611[0]) + (_e4077 * _e3611[1])) + (_e4080 * _e3611[2]));
                                        let _e4108 = (((_e4074 * _e3617[0]) + (_e4077 * _e3617[1])) + (_e4080 * _e3617[2]));
                                        let _e4113 = (((_e4074 * _e3634) + (_e4077 * _e3635)) + (_e4080 * _e3636));
                                        let _e4118 = (((_e4074 * _e3643) + (_e4077 * _e3644)) + (_e4080 * _e3645));
                                        let _e4126 = (((_e4074 * _e3642[0]) + (_e4077 * _e3642[1])) + (_e4080 * _e3642[2]));
                                        if (_e4085 < _e4090) {
                                            phi_6599_ = _e4085;
                                        } else {
                                            phi_6599_ = _e4090;
                                        }
                                        let _e4129 = phi_6599_;
                                        if (_e4095 < _e4103) {
                                            phi_6604_ = _e4095;
                                        } else {
                                            phi_6604_ = _e4103;
                                        }
                                        let _e4132 = phi_6604_;
                                        if (_e4129 < _e4132) {
                                            phi_6609_ = _e4129;
                                        } else {
                                            phi_6609_ = _e4132;
                                        }
                                        let _e4135 = phi_6609_;
                                        if (_e4108 < _e4113) {
                                            phi_6614_ = _e4108;
                                        } else {
                                            phi_6614_ = _e4113;
                                        }
                                        let _e4138 = phi_6614_;
                                        if (_e4118 < _e4126) {
                                            phi_6619_ = _e4118;
                                        } else {
                                            phi_6619_ = _e4126;
                                        }
                                        let _e4141 = phi_6619_;
                                        if (_e4138 < _e4141) {
                                            phi_6624_ = _e4138;
                                        } else {
                                            phi_6624_ = _e4141;
                                        }
                                        let _e4144 = phi_6624_;
                                        if (_e4135 < _e4144) {
                                            phi_6629_ = _e4135;
                                        } else {
                                            phi_6629_ = _e4144;
                                        }
                                        let _e4147 = phi_6629_;
                                        if (_e4085 > _e4090) {
                                            phi_6634_ = _e4085;
                                        } else {
                                            phi_6634_ = _e4090;
                                        }
                                        let _e4150 = phi_6634_;
                                        if (_e4095 > _e4103) {
                                            phi_6639_ = _e4095;
                                        } else {
                                            phi_6639_ = _e4103;
                                        }
                                        let _e4153 = phi_6639_;
                                        if (_e4150 > _e4153) {
                                            phi_6644_ = _e4150;
                                        } else {
                                            phi_6644_ = _e4153;
                                        }
                                        let _e4156 = phi_6644_;
                                        if (_e4108 > _e4113) {
                                            phi_6649_ = _e4108;
                                        } else {
                                            phi_6649_ = _e4113;
                                        }
                                        let _e4159 = phi_6649_;
                                        if (_e4118 > _e4126) {
                                            phi_6654_ = _e4118;
                                        } else {
                                            phi_6654_ = _e4126;
                                        }
                                        let _e4162 = phi_6654_;
                                        if (_e4159 > _e4162) {
                                            phi_6659_ = _e4159;
                                        } else {
                                            phi_6659_ = _e4162;
                                        }
                                        let _e4165 = phi_6659_;
                                        if (_e4156 > _e4165) {
                                            phi_6664_ = _e4156;
                                        } else {
                                            phi_6664_ = _e4165;
                                        }
                                        let _e4168 = phi_6664_;
                                        if (_e4074 < 0f) {
                                            phi_6670_ = -(_e4074);
                                        } else {
                                            phi_6670_ = _e4074;
                                        }
                                        let _e4172 = phi_6670_;
                                        if (_e4077 < 0f) {
                                            phi_6676_ = -(_e4077);
                                        } else {
                                            phi_6676_ = _e4077;
                                        }
                                        let _e4176 = phi_6676_;
                                        if (_e4080 < 0f) {
                                            phi_6683_ = -(_e4080);
                                        } else {
                                            phi_6683_ = _e4080;
                                        }
                                        let _e4181 = phi_6683_;
                                        let _e4182 = ((_e4172 + _e4176) + _e4181);
                                        let _e4187 = -(_e4168);
                                        if (_e4147 > _e4187) {
                                            phi_6694_ = _e4147;
                                        } else {
                                            phi_6694_ = _e4187;
                                        }
                                        let _e4190 = phi_6694_;
                                        let _e4195 = (((_e4190 - ((_e4182 * _e3810) * (0.000000059604645f * (17f / 2f)))) - (_e4182 * _e3817)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4068 > _e4195) {
                                            phi_6704_ = _e4068;
                                        } else {
                                            phi_6704_ = _e4195;
                                        }
                                        let _e4198 = phi_6704_;
                                        phi_6705_ = _e4198;
                                    } else {
                                        phi_6705_ = _e4068;
                                    }
                                    let _e4200 = phi_6705_;
                                    phi_6708_ = (_e3544 || (_e4200 > 0f));
                                }
                                let _e4204 = phi_6708_;
                                if _e4204 {
                                    let _e4207 = local_1.member_1[0u];
                                    let _e4213 = local_1.member_2[0u];
                                    let _e4219 = ((_e4207[1] * _e4213[2]) - (_e4207[2] * _e4213[1]));
                                    let _e4222 = ((_e4207[2] * _e4213[0]) - (_e4207[0] * _e4213[2]));
                                    let _e4225 = ((_e4207[0] * _e4213[1]) - (_e4207[1] * _e4213[0]));
                                    let _e4228 = local_1.member_1[1u];
                                    let _e4234 = local_1.member_2[1u];
                                    let _e4240 = ((_e4228[1] * _e4234[2]) - (_e4228[2] * _e4234[1]));
                                    let _e4243 = ((_e4228[2] * _e4234[0]) - (_e4228[0] * _e4234[2]));
                                    let _e4246 = ((_e4228[0] * _e4234[1]) - (_e4228[1] * _e4234[0]));
                                    let _e4249 = local_1.member_1[0u];
                                    let _e4255 = local_1.member_2[1u];
                                    let _e4270 = local_1.member_1[1u];
                                    let _e4276 = local_1.member_2[0u];
                                    let _e4289 = (((_e4249[1] * _e4255[2]) - (_e4249[2] * _e4255[1])) + ((_e4270[1] * _e4276[2]) - (_e4270[2] * _e4276[1])));
                                    let _e4290 = (((_e4249[2] * _e4255[0]) - (_e4249[0] * _e4255[2])) + ((_e4270[2] * _e4276[0]) - (_e4270[0] * _e4276[2])));
                                    let _e4291 = (((_e4249[0] * _e4255[1]) - (_e4249[1] * _e4255[0])) + ((_e4270[0] * _e4276[1]) - (_e4270[1] * _e4276[0])));
                                    let _e4294 = local_1.member[0u];
                                    let _e4305 = local_1.member[1u];
                                    let _e4316 = local_1.member[0u];
                                    let _e4325 = ((((_e4305[0] * _e4219) + (_e4305[1] * _e4222)) + (_e4305[2] * _e4225)) + (((_e4316[0] * _e4289) + (_e4316[1] * _e4290)) + (_e4316[2] * _e4291)));
                                    let _e4328 = local_1.member[0u];
                                    let _e4339 = local_1.member[1u];
                                    let _e4348 = ((((_e4328[0] * _e4240) + (_e4328[1] * _e4243)) + (_e4328[2] * _e4246)) + (((_e4339[0] * _e4289) + (_e4339[1] * _e4290)) + (_e4339[2] * _e4291)));
                                    let _e4351 = local_1.member[1u];
                                    let _e4362 = local_1.member[0u];
                                    if (_e4362[0] < 0f) {
                                        phi_6953_ = -(_e4362[0]);
                                    } else {
                                        phi_6953_ = _e4362[0];
                                    }
                                    let _e4369 = phi_6953_;
                                    if (_e4362[1] < 0f) {
                                        phi_6960_ = -(_e4362[1]);
                                    } else {
                                        phi_6960_ = _e4362[1];
                                    }
                                    let _e4373 = phi_6960_;
                                    if (_e4369 > _e4373) {
                                        phi_6965_ = _e4369;
                                    } else {
                                        phi_6965_ = _e4373;
                                    }
                                    let _e4376 = phi_6965_;
                                    if (_e4362[2] < 0f) {
                                        phi_6972_ = -(_e4362[2]);
                                    } else {
                                        phi_6972_ = _e4362[2];
                                    }
                                    let _e4380 = phi_6972_;
                                    if (_e4376 > _e4380) {
                                        phi_6977_ = _e4376;
                                    } else {
                                        phi_6977_ = _e4380;
                                    }
                                    let _e4383 = phi_6977_;
                                    let _e4386 = local_1.member[1u];
                                    if (_e4386[0] < 0f) {
                                        phi_6990_ = -(_e4386[0]);
                                    } else {
                                        phi_6990_ = _e4386[0];
                                    }
                                    let _e4393 = phi_6990_;
                                    if (_e4386[1] < 0f) {
                                        phi_6997_ = -(_e4386[1]);
                                    } else {
                                        phi_6997_ = _e4386[1];
                                    }
                                    let _e4397 = phi_6997_;
                                    if (_e4393 > _e4397) {
                                        phi_7002_ = _e4393;
                                    } else {
                                        phi_7002_ = _e4397;
                                    }
                                    let _e4400 = phi_7002_;
                                    if (_e4386[2] < 0f) {
                                        phi_7009_ = -(_e4386[2]);
                                    } else {
                                        phi_7009_ = _e4386[2];
                                    }
                                    let _e4404 = phi_7009_;
                                    if (_e4400 > _e4404) {
                                        phi_7014_ = _e4400;
                                    } else {
                                        phi_7014_ = _e4404;
                                    }
                                    let _e4407 = phi_7014_;
                                    if (_e4383 > _e4407) {
                                        phi_7019_ = _e4383;
                                    } else {
                                        phi_7019_ = _e4407;
                                    }
                                    let _e4410 = phi_7019_;
                                    let _e4412 = local_1.member_3;
                                    let _e4413 = (_e4410 + _e4412);
                                    let _e4416 = local_1.member_1[0u];
                                    if (_e4416[0] < 0f) {
                                        phi_7036_ = -(_e4416[0]);
                                    } else {
                                        phi_7036_ = _e4416[0];
                                    }
                                    let _e4423 = phi_7036_;
                                    if (_e4416[1] < 0f) {
                                        phi_7043_ = -(_e4416[1]);
                                    } else {
                                        phi_7043_ = _e4416[1];
                                    }
                                    let _e4427 = phi_7043_;
                                    if (_e4423 > _e4427) {
                                        phi_7048_ = _e4423;
                                    } else {
                                        phi_7048_ = _e4427;
                                    }
                                    let _e4430 = phi_7048_;
                                    if (_e4416[2] < 0f) {
                                        phi_7055_ = -(_e4416[2]);
                                    } else {
                                        phi_7055_ = _e4416[2];
                                    }
                                    let _e4434 = phi_7055_;
                                    if (_e4430 > _e4434) {
                                        phi_7060_ = _e4430;
                                    } else {
                                        phi_7060_ = _e4434;
                                    }
                                    let _e4437 = phi_7060_;
                                    let _e4440 = local_1.member_1[1u];
                                    if (_e4440[0] < 0f) {
                                        phi_7074_ = -(_e4440[0]);
                                    } else {
                                        phi_7074_ = _e4440[0];
                                    }
                                    let _e4447 = phi_7074_;
                                    if (_e4440[1] < 0f) {
                                        phi_7081_ = -(_e4440[1]);
                                    } else {
                                        phi_7081_ = _e4440[1];
                                    }
                                    let _e4451 = phi_7081_;
                                    if (_e4447 > _e4451) {
                                        phi_7086_ = _e4447;
                                    } else {
                                        phi_7086_ = _e4451;
                                    }
                                    let _e4454 = phi_7086_;
                                    if (_e4440[2] < 0f) {
                                        phi_7093_ = -(_e4440[2]);
                                    } else {
                                        phi_7093_ = _e4440[2];
                                    }
                                    let _e4458 = phi_7093_;
                                    if (_e4454 > _e4458) {
                                        phi_7098_ = _e4454;
                                    } else {
                                        phi_7098_ = _e4458;
                                    }
                                    let _e4461 = phi_7098_;
                                    if (_e4437 > _e4461) {
                                        phi_7103_ = _e4437;
                                    } else {
                                        phi_7103_ = _e4461;
                                    }
                                    let _e4464 = phi_7103_;
                                    let _e4466 = local_1.member_3;
                                    let _e4467 = (_e4464 + _e4466);
                                    let _e4470 = local_1.member_2[0u];
                                    if (_e4470[0] < 0f) {
                                        phi_7120_ = -(_e4470[0]);
                                    } else {
                                        phi_7120_ = _e4470[0];
                                    }
                                    let _e4477 = phi_7120_;
                                    if (_e4470[1] < 0f) {
                                        phi_7127_ = -(_e4470[1]);
                                    } else {
                                        phi_7127_ = _e4470[1];
                                    }
                                    let _e4481 = phi_7127_;
                                    if (_e4477 > _e4481) {
                                        phi_7132_ = _e4477;
                                    } else {
                                        phi_7132_ = _e4481;
                                    }
                                    let _e4484 = phi_7132_;
                                    if (_e4470[2] < 0f) {
                                        phi_7139_ = -(_e4470[2]);
                                    } else {
                                        phi_7139_ = _e4470[2];
                                    }
                                    let _e4488 = phi_7139_;
                                    if (_e4484 > _e4488) {
                                        phi_7144_ = _e4484;
                                    } else {
                                        phi_7144_ = _e4488;
                                    }
                                    let _e4491 = phi_7144_;
                                    let _e4494 = local_1.member_2[1u];
                                    if (_e4494[0] < 0f) {
                                        phi_7158_ = -(_e4494[0]);
                                    } else {
                                        phi_7158_ = _e4494[0];
                                    }
                                    let _e4501 = phi_7158_;
                                    if (_e4494[1] < 0f) {
                                        phi_7165_ = -(_e4494[1]);
                                    } else {
                                        phi_7165_ = _e4494[1];
                                    }
                                    let _e4505 = phi_7165_;
                                    if (_e4501 > _e4505) {
                                        phi_7170_ = _e4501;
                                    } else {
                                        phi_7170_ = _e4505;
                                    }
                                    let _e4508 = phi_7170_;
                                    if (_e4494[2] < 0f) {
                                        phi_7177_ = -(_e4494[2]);
                                    } else {
                                        phi_7177_ = _e4494[2];
                                    }
                                    let _e4512 = phi_7177_;
                                    if (_e4508 > _e4512) {
                                        phi_7182_ = _e4508;
                                    } else {
                                        phi_7182_ = _e4512;
                                    }
                                    let _e4515 = phi_7182_;
                                    if (_e4491 > _e4515) {
                                        phi_7187_ = _e4491;
                                    } else {
                                        phi_7187_ = _e4515;
                                    }
                                    let _e4518 = phi_7187_;
                                    let _e4520 = local_1.member_3;
                                    let _e4521 = (_e4518 + _e4520);
                                    let _e4523 = ((_e4467 * 8f) * _e4521);
                                    let _e4530 = local_1.member_3;
                                    if (_e4219 < 0f) {
                                        phi_7218_ = -(_e4219);
                                    } else {
                                        phi_7218_ = _e4219;
                                    }
                                    let _e4547 = phi_7218_;
                                    if (_e4222 < 0f) {
                                        phi_7224_ = -(_e4222);
                                    } else {
                                        phi_7224_ = _e4222;
                                    }
                                    let _e4551 = phi_7224_;
                                    if (_e4225 < 0f) {
                                        phi_7231_ = -(_e4225);
                                    } else {
                                        phi_7231_ = _e4225;
                                    }
                                    let _e4556 = phi_7231_;
                                    let _e4557 = ((_e4547 + _e4551) + _e4556);
                                    if (_e4240 < 0f) {
                                        phi_7238_ = -(_e4240);
                                    } else {
                                        phi_7238_ = _e4240;
                                    }
                                    let _e4561 = phi_7238_;
                                    if (_e4243 < 0f) {
                                        phi_7244_ = -(_e4243);
                                    } else {
                                        phi_7244_ = _e4243;
                                    }
                                    let _e4565 = phi_7244_;
                                    if (_e4246 < 0f) {
                                        phi_7251_ = -(_e4246);
                                    } else {
                                        phi_7251_ = _e4246;
                                    }
                                    let _e4570 = phi_7251_;
                                    let _e4571 = ((_e4561 + _e4565) + _e4570);
                                    if (_e4557 > _e4571) {
                                        phi_7257_ = _e4557;
                                    } else {
                                        phi_7257_ = _e4571;
                                    }
                                    let _e4574 = phi_7257_;
                                    if (_e4289 < 0f) {
                                        phi_7263_ = -(_e4289);
                                    } else {
                                        phi_7263_ = _e4289;
                                    }
                                    let _e4578 = phi_7263_;
                                    if (_e4290 < 0f) {
                                        phi_7269_ = -(_e4290);
                                    } else {
                                        phi_7269_ = _e4290;
                                    }
                                    let _e4582 = phi_7269_;
                                    if (_e4291 < 0f) {
                                        phi_7276_ = -(_e4291);
                                    } else {
                                        phi_7276_ = _e4291;
                                    }
                                    let _e4587 = phi_7276_;
                                    let _e4589 = (((_e4578 + _e4582) + _e4587) * 0.5f);
                                    if (_e4574 > _e4589) {
                                        phi_7283_ = _e4574;
                                    } else {
                                        phi_7283_ = _e4589;
                                    }
                                    let _e4592 = phi_7283_;
                                    let _e4597 = local_1.member_3;
                                    let _e4610 = ((((_e4294[0] * _e4219) + (_e4294[1] * _e4222)) + (_e4294[2] * _e4225)) * 3f);
                                    let _e4611 = ((((_e4351[0] * _e4240) + (_e4351[1] * _e4243)) + (_e4351[2] * _e4246)) * 3f);
                                    if (_e4610 < _e4611) {
                                        phi_7307_ = _e4610;
                                    } else {
                                        phi_7307_ = _e4611;
                                    }
                                    let _e4614 = phi_7307_;
                                    if (_e4325 < _e4348) {
                                        phi_7312_ = _e4325;
                                    } else {
                                        phi_7312_ = _e4348;
                                    }
                                    let _e4617 = phi_7312_;
                                    if (_e4614 < _e4617) {
                                        phi_7317_ = _e4614;
                                    } else {
                                        phi_7317_ = _e4617;
                                    }
                                    let _e4620 = phi_7317_;
                                    if (_e4610 > _e4611) {
                                        phi_7322_ = _e4610;
                                    } else {
                                        phi_7322_ = _e4611;
                                    }
                                    let _e4623 = phi_7322_;
                                    if (_e4325 > _e4348) {
                                        phi_7327_ = _e4325;
                                    } else {
                                        phi_7327_ = _e4348;
                                    }
                                    let _e4626 = phi_7327_;
                                    if (_e4623 > _e4626) {
                                        phi_7332_ = _e4623;
                                    } else {
                                        phi_7332_ = _e4626;
                                    }
                                    let _e4629 = phi_7332_;
                                    let _e4634 = -(_e4629);
                                    if (_e4620 > _e4634) {
                                        phi_7342_ = _e4620;
                                    } else {
                                        phi_7342_ = _e4634;
                                    }
                                    let _e4637 = phi_7342_;
                                    let _e4639 = ((_e4637 - ((((((_e4413 * 8f) * _e4523) * (0.000000059604645f * (524f / 64f))) + ((_e4530 * 19f) * ((_e4413 * (_e4467 + _e4521)) + (_e4467 * _e4521)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4413) * ((1f + _e4467) * (1f + _e4521))))) + ((_e91.member_5 * (((_e4592 + (_e4523 * (0.000000059604645f * 8f))) + ((_e4597 * 6f) * (_e4467 + _e4521))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4467) * (1f + _e4521))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4639 {
                                        phi_8311_ = _e4639;
                                    } else {
                                        let _e4642 = local_1.member_1[0u];
                                        let _e4648 = local_1.member_1[1u];
                                        let _e4652 = (_e4642[0] + _e4648[0]);
                                        let _e4653 = (_e4642[1] + _e4648[1]);
                                        let _e4654 = (_e4642[2] + _e4648[2]);
                                        let _e4657 = local_1.member_2[0u];
                                        let _e4663 = local_1.member_2[1u];
                                        let _e4667 = (_e4657[0] + _e4663[0]);
                                        let _e4668 = (_e4657[1] + _e4663[1]);
                                        let _e4669 = (_e4657[2] + _e4663[2]);
                                        let _e4672 = ((_e4653 * _e4669) - (_e4654 * _e4668));
                                        let _e4675 = ((_e4654 * _e4667) - (_e4652 * _e4669));
                                        let _e4678 = ((_e4652 * _e4668) - (_e4653 * _e4667));
                                        let _e4681 = local_1.member[0u];
                                        let _e4688 = local_1.member_1[0u];
                                        let _e4694 = local_1.member_2[0u];
                                        let _e4698 = (_e4681[0] - _e4688[0]);
                                        let _e4699 = (_e4681[1] - _e4688[1]);
                                        let _e4700 = (_e4681[2] - _e4688[2]);
                                        if true {
                                            phi_7458_ = array<f32, 3>(_e4681[0], _e4681[1], _e4681[2]);
                                        } else {
                                            phi_7458_ = array<f32, 3>((_e4698 - _e4694[0]), (_e4699 - _e4694[1]), (_e4700 - _e4694[2]));
                                        }
                                        let _e4706 = phi_7458_;
                                        let _e4707 = (_e4681[0] - _e4694[0]);
                                        let _e4708 = (_e4681[1] - _e4694[1]);
                                        let _e4709 = (_e4681[2] - _e4694[2]);
                                        let _e4712 = local_1.member[1u];
                                        let _e4719 = local_1.member_1[1u];
                                        let _e4725 = local_1.member_2[1u];
                                        let _e4729 = (_e4712[0] - _e4719[0]);
                                        let _e4730 = (_e4712[1] - _e4719[1]);
                                        let _e4731 = (_e4712[2] - _e4719[2]);
                                        if true {
                                            phi_7523_ = array<f32, 3>(_e4712[0], _e4712[1], _e4712[2]);
                                        } else {
                                            phi_7523_ = array<f32, 3>((_e4729 - _e4725[0]), (_e4730 - _e4725[1]), (_e4731 - _e4725[2]));
                                        }
                                        let _e4737 = phi_7523_;
                                        let _e4738 = (_e4712[0] - _e4725[0]);
                                        let _e4739 = (_e4712[1] - _e4725[1]);
                                        let _e4740 = (_e4712[2] - _e4725[2]);
                                        let _e4743 = local_1.member[0u];
                                        if (_e4743[0] < 0f) {
                                            phi_7545_ = -(_e4743[0]);
                                        } else {
                                            phi_7545_ = _e4743[0];
                                        }
                                        let _e4750 = phi_7545_;
                                        if (_e4743[1] < 0f) {
                                            phi_7552_ = -(_e4743[1]);
                                        } else {
                                            phi_7552_ = _e4743[1];
                                        }
                                        let _e4754 = phi_7552_;
                                        if (_e4750 > _e4754) {
                                            phi_7557_ = _e4750;
                                        } else {
                                            phi_7557_ = _e4754;
                                        }
                                        let _e4757 = phi_7557_;
                                        if (_e4743[2] < 0f) {
                                            phi_7564_ = -(_e4743[2]);
                                        } else {
                                            phi_7564_ = _e4743[2];
                                        }
                                        let _e4761 = phi_7564_;
                                        if (_e4757 > _e4761) {
                                            phi_7569_ = _e4757;
                                        } else {
                                            phi_7569_ = _e4761;
                                        }
                                        let _e4764 = phi_7569_;
                                        let _e4767 = local_1.member[1u];
                                        if (_e4767[0] < 0f) {
                                            phi_7582_ = -(_e4767[0]);
                                        } else {
                                            phi_7582_ = _e4767[0];
                                        }
                                        let _e4774 = phi_7582_;
                                        if (_e4767[1] < 0f) {
                                            phi_7589_ = -(_e4767[1]);
                                        } else {
                                            phi_7589_ = _e4767[1];
                                        }
                                        let _e4778 = phi_7589_;
                                        if (_e4774 > _e4778) {
                                            phi_7594_ = _e4774;
                                        } else {
                                            phi_7594_ = _e4778;
                                        }
                                        let _e4781 = phi_7594_;
                                        if (_e4767[2] < 0f) {
                                            phi_7601_ = -(_e4767[2]);
                                        } else {
                                            phi_7601_ = _e4767[2];
                                        }
                                        let _e4785 = phi_7601_;
                                        if (_e4781 > _e4785) {
                                            phi_7606_ = _e4781;
                                        } else {
                                            phi_7606_ = _e4785;
                                        }
                                        let _e4788 = phi_7606_;
                                        if (_e4764 > _e4788) {
                                            phi_7611_ = _e4764;
                                        } else {
                                            phi_7611_ = _e4788;
                                        }
                                        let _e4791 = phi_7611_;
                                        let _e4793 = local_1.member_3;
                                        let _e4797 = local_1.member_1[0u];
                                        if (_e4797[0] < 0f) {
                                            phi_7628_ = -(_e4797[0]);
                                        } else {
                                            phi_7628_ = _e4797[0];
                                        }
                                        let _e4804 = phi_7628_;
                                        if (_e4797[1] < 0f) {
                                            phi_7635_ = -(_e4797[1]);
                                        } else {
                                            phi_7635_ = _e4797[1];
                                        }
                                        let _e4808 = phi_7635_;
                                        if (_e4804 > _e4808) {
                                            phi_7640_ = _e4804;
                                        } else {
                                            phi_7640_ = _e4808;
                                        }
                                        let _e4811 = phi_7640_;
                                        if (_e4797[2] < 0f) {
                                            phi_7647_ = -(_e4797[2]);
                                        } else {
                                            phi_7647_ = _e4797[2];
                                        }
                                        let _e4815 = phi_7647_;
                                        if (_e4811 > _e4815) {
                                            phi_7652_ = _e4811;
                                        } else {
                                            phi_7652_ = _e4815;
                                        }
                                        let _e4818 = phi_7652_;
                                        let _e4821 = local_1.member_1[1u];
                                        if (_e4821[0] < 0f) {
                                            phi_7666_ = -(_e4821[0]);
                                        } else {
                                            phi_7666_ = _e4821[0];
                                        }
                                        let _e4828 = phi_7666_;
                                        if (_e4821[1] < 0f) {
                                            phi_7673_ = -(_e4821[1]);
                                        } else {
                                            phi_7673_ = _e4821[1];
                                        }
                                        let _e4832 = phi_7673_;
                                        if (_e4828 > _e4832) {
                                            phi_7678_ = _e4828;
                                        } else {
                                            phi_7678_ = _e4832;
                                        }
                                        let _e4835 = phi_7678_;
                                        if (_e4821[2] < 0f) {
                                            phi_7685_ = -(_e4821[2]);
                                        } else {
                                            phi_7685_ = _e4821[2];
                                        }
                                        let _e4839 = phi_7685_;
                                        if (_e4835 > _e4839) {
                                            phi_7690_ = _e4835;
                                        } else {
                                            phi_7690_ = _e4839;
                                        }
                                        let _e4842 = phi_7690_;
                                        if (_e4818 > _e4842) {
                                            phi_7695_ = _e4818;
                                        } else {
                                            phi_7695_ = _e4842;
                                        }
                                        let _e4845 = phi_7695_;
                                        let _e4847 = local_1.member_3;
                                        let _e4851 = local_1.member_2[0u];
                                        if (_e4851[0] < 0f) {
                                            phi_7712_ = -(_e4851[0]);
                                        } else {
                                            phi_7712_ = _e4851[0];
                                        }
                                        let _e4858 = phi_7712_;
                                        if (_e4851[1] < 0f) {
                                            phi_7719_ = -(_e4851[1]);
                                        } else {
                                            phi_7719_ = _e4851[1];
                                        }
                                        let _e4862 = phi_7719_;
                                        if (_e4858 > _e4862) {
                                            phi_7724_ = _e4858;
                                        } else {
                                            phi_7724_ = _e4862;
                                        }
                                        let _e4865 = phi_7724_;
                                        if (_e4851[2] < 0f) {
                                            phi_7731_ = -(_e4851[2]);
                                        } else {
                                            phi_7731_ = _e4851[2];
                                        }
                                        let _e4869 = phi_7731_;
                                        if (_e4865 > _e4869) {
                                            phi_7736_ = _e4865;
                                        } else {
                                            phi_7736_ = _e4869;
                                        }
                                        let _e4872 = phi_7736_;
                                        let _e4875 = local_1.member_2[1u];
                                        if (_e4875[0] < 0f) {
                                            phi_7750_ = -(_e4875[0]);
                                        } else {
                                            phi_7750_ = _e4875[0];
                                        }
                                        let _e4882 = phi_7750_;
                                        if (_e4875[1] < 0f) {
                                            phi_7757_ = -(_e4875[1]);
                                        } else {
                                            phi_7757_ = _e4875[1];
                                        }
                                        let _e4886 = phi_7757_;
                                        if (_e4882 > _e4886) {
                                            phi_7762_ = _e4882;
                                        } else {
                                            phi_7762_ = _e4886;
                                        }
                                        let _e4889 = phi_7762_;
                                        if (_e4875[2] < 0f) {
                                            phi_7769_ = -(_e4875[2]);
                                        } else {
                                            phi_7769_ = _e4875[2];
                                        }
                                        let _e4893 = phi_7769_;
                                        if (_e4889 > _e4893) {
                                            phi_7774_ = _e4889;
                                        } else {
                                            phi_7774_ = _e4893;
                                        }
                                        let _e4896 = phi_7774_;
                                        if (_e4872 > _e4896) {
                                            phi_7779_ = _e4872;
                                        } else {
                                            phi_7779_ = _e4896;
                                        }
                                        let _e4899 = phi_7779_;
                                        let _e4901 = local_1.member_3;
                                        let _e4905 = ((((_e4791 + _e4793) + (_e4845 + _e4847)) + (_e4899 + _e4901)) * 2f);
                                        let _e4908 = local_1.member_3;
                                        let _e4912 = (((_e91.member_5 * 1.0001f) + (_e4908 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4915 = ((_e4675 * _e4654) - (_e4678 * _e4653));
                                        let _e4918 = ((_e4678 * _e4652) - (_e4672 * _e4654));
                                        let _e4921 = ((_e4672 * _e4653) - (_e4675 * _e4652));
                                        let _e4926 = (((_e4915 * _e4681[0]) + (_e4918 * _e4681[1])) + (_e4921 * _e4681[2]));
                                        let _e4931 = (((_e4915 * _e4698) + (_e4918 * _e4699)) + (_e4921 * _e4700));
                                        let _e4936 = (((_e4915 * _e4707) + (_e4918 * _e4708)) + (_e4921 * _e4709));
                                        let _e4944 = (((_e4915 * _e4706[0]) + (_e4918 * _e4706[1])) + (_e4921 * _e4706[2]));
                                        let _e4949 = (((_e4915 * _e4712[0]) + (_e4918 * _e4712[1])) + (_e4921 * _e4712[2]));
                                        let _e4954 = (((_e4915 * _e4729) + (_e4918 * _e4730)) + (_e4921 * _e4731));
                                        let _e4959 = (((_e4915 * _e4738) + (_e4918 * _e4739)) + (_e4921 * _e4740));
                                        let _e4967 = (((_e4915 * _e4737[0]) + (_e4918 * _e4737[1])) + (_e4921 * _e4737[2]));
                                        if (_e4926 < _e4931) {
                                            phi_7858_ = _e4926;
                                        } else {
                                            phi_7858_ = _e4931;
                                        }
                                        let _e4970 = phi_7858_;
                                        if (_e4936 < _e4944) {
                                            phi_7863_ = _e4936;
                                        } else {
                                            phi_7863_ = _e4944;
                                        }
                                        let _e4973 = phi_7863_;
                                        if (_e4970 < _e4973) {
                                            phi_7868_ = _e4970;
                                        } else {
                                            phi_7868_ = _e4973;
                                        }
                                        let _e4976 = phi_7868_;
                                        if (_e4949 < _e4954) {
                                            phi_7873_ = _e4949;
                                        } else {
                                            phi_7873_ = _e4954;
                                        }
                                        let _e4979 = phi_7873_;
                                        if (_e4959 < _e4967) {
                                            phi_7878_ = _e4959;
                                        } else {
                                            phi_7878_ = _e4967;
                                        }
                                        let _e4982 = phi_7878_;
                                        if (_e4979 < _e4982) {
                                            phi_7883_ = _e4979;
                                        } else {
                                            phi_7883_ = _e4982;
                                        }
                                        let _e4985 = phi_7883_;
                                        if (_e4976 < _e4985) {
                                            phi_7888_ = _e4976;
                                        } else {
                                            phi_7888_ = _e4985;
                                        }
                                        let _e4988 = phi_7888_;
                                        if (_e4926 > _e4931) {
                                            phi_7893_ = _e4926;
                                        } else {
                                            phi_7893_ = _e4931;
                                        }
                                        let _e4991 = phi_7893_;
                                        if (_e4936 > _e4944) {
                                            phi_7898_ = _e4936;
                                        } else {
                                            phi_7898_ = _e4944;
                                        }
                                        let _e4994 = phi_7898_;
                                        if (_e4991 > _e4994) {
                                            phi_7903_ = _e4991;
                                        } else {
                                            phi_7903_ = _e4994;
                                        }
                                        let _e4997 = phi_7903_;
                                        if (_e4949 > _e4954) {
                                            phi_7908_ = _e4949;
                                        } else {
                                            phi_7908_ = _e4954;
                                        }
                                        let _e5000 = phi_7908_;
                                        if (_e4959 > _e4967) {
                                            phi_7913_ = _e4959;
                                        } else {
                                            phi_7913_ = _e4967;
                                        }
                                        let _e5003 = phi_7913_;
                                        if (_e5000 > _e5003) {
                                            phi_7918_ = _e5000;
                                        } else {
                                            phi_7918_ = _e5003;
                                        }
                                        let _e5006 = phi_7918_;
                                        if (_e4997 > _e5006) {
                                            phi_7923_ = _e4997;
                                        } else {
                                            phi_7923_ = _e5006;
                                        }
                                        let _e5009 = phi_7923_;
                                        if (_e4915 < 0f) {
                                            phi_7929_ = -(_e4915);
                                        } else {
                                            phi_7929_ = _e4915;
                                        }
                                        let _e5013 = phi_7929_;
                                        if (_e4918 < 0f) {
                                            phi_7935_ = -(_e4918);
                                        } else {
                                            phi_7935_ = _e4918;
                                        }
                                        let _e5017 = phi_7935_;
                                        if (_e4921 < 0f) {
                                            phi_7942_ = -(_e4921);
                                        } else {
                                            phi_7942_ = _e4921;
                                        }
                                        let _e5022 = phi_7942_;
                                        let _e5023 = ((_e5013 + _e5017) + _e5022);
                                        let _e5028 = -(_e5009);
                                        if (_e4988 > _e5028) {
                                            phi_7953_ = _e4988;
                                        } else {
                                            phi_7953_ = _e5028;
                                        }
                                        let _e5031 = phi_7953_;
                                        let _e5036 = (((_e5031 - ((_e5023 * _e4905) * (0.000000059604645f * (17f / 2f)))) - (_e5023 * _e4912)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e5039 = ((_e4675 * _e4669) - (_e4678 * _e4668));
                                        let _e5042 = ((_e4678 * _e4667) - (_e4672 * _e4669));
                                        let _e5045 = ((_e4672 * _e4668) - (_e4675 * _e4667));
                                        let _e5050 = (((_e5039 * _e4681[0]) + (_e5042 * _e4681[1])) + (_e5045 * _e4681[2]));
                                        let _e5055 = (((_e5039 * _e4698) + (_e5042 * _e4699)) + (_e5045 * _e4700));
                                        let _e5060 = (((_e5039 * _e4707) + (_e5042 * _e4708)) + (_e5045 * _e4709));
                                        let _e5068 = (((_e5039 * _e4706[0]) + (_e5042 * _e4706[1])) + (_e5045 * _e4706[2]));
                                        let _e5073 = (((_e5039 * _e4712[0]) + (_e5042 * _e4712[1])) + (_e5045 * _e4712[2]));
                                        let _e5078 = (((_e5039 * _e4729) + (_e5042 * _e4730)) + (_e5045 * _e4731));
                                        let _e5083 = (((_e5039 * _e4738) + (_e5042 * _e4739)) + (_e5045 * _e4740));
                                        let _e5091 = (((_e5039 * _e4737[0]) + (_e5042 * _e4737[1])) + (_e5045 * _e4737[2]));
                                        if (_e5050 < _e5055) {
                                            phi_8024_ = _e5050;
                                        } else {
                                            phi_8024_ = _e5055;
                                        }
                                        let _e5094 = phi_8024_;
                                        if (_e5060 < _e5068) {
                                            phi_8029_ = _e5060;
                                        } else {
                                            phi_8029_ = _e5068;
                                        }
                                        let _e5097 = phi_8029_;
                                        if (_e5094 < _e5097) {
                                            phi_8034_ = _e5094;
                                        } else {
                                            phi_8034_ = _e5097;
                                        }
                                        let _e5100 = phi_8034_;
                                        if (_e5073 < _e5078) {
                                            phi_8039_ = _e5073;
                                        } else {
                                            phi_8039_ = _e5078;
                                        }
                                        let _e5103 = phi_8039_;
                                        if (_e5083 < _e5091) {
                                            phi_8044_ = _e5083;
                                        } else {
                                            phi_8044_ = _e5091;
                                        }
                                        let _e5106 = phi_8044_;
                                        if (_e5103 < _e5106) {
                                            phi_8049_ = _e5103;
                                        } else {
                                            phi_8049_ = _e5106;
                                        }
                                        let _e5109 = phi_8049_;
                                        if (_e5100 < _e5109) {
                                            phi_8054_ = _e5100;
                                        } else {
                                            phi_8054_ = _e5109;
                                        }
                                        let _e5112 = phi_8054_;
                                        if (_e5050 > _e5055) {
                                            phi_8059_ = _e5050;
                                        } else {
                                            phi_8059_ = _e5055;
                                        }
                                        let _e5115 = phi_8059_;
                                        if (_e5060 > _e5068) {
                                            phi_8064_ = _e5060;
                                        } else {
                                            phi_8064_ = _e5068;
                                        }
                                        let _e5118 = phi_8064_;
                                        if (_e5115 > _e5118) {
                                            phi_8069_ = _e5115;
                                        } else {
                                            phi_8069_ = _e5118;
                                        }
                                        let _e5121 = phi_8069_;
                                        if (_e5073 > _e5078) {
                                            phi_8074_ = _e5073;
                                        } else {
                                            phi_8074_ = _e5078;
                                        }
                                        let _e5124 = phi_8074_;
                                        if (_e5083 > _e5091) {
                                            phi_8079_ = _e5083;
                                        } else {
                                            phi_8079_ = _e5091;
                                        }
                                        let _e5127 = phi_8079_;
                                        if (_e5124 > _e5127) {
                                            phi_8084_ = _e5124;
                                        } else {
                                            phi_8084_ = _e5127;
                                        }
                                        let _e5130 = phi_8084_;
                                        if (_e5121 > _e5130) {
                                            phi_8089_ = _e5121;
                                        } else {
                                            phi_8089_ = _e5130;
                                        }
                                        let _e5133 = phi_8089_;
                                        if (_e5039 < 0f) {
                                            phi_8095_ = -(_e5039);
                                        } else {
                                            phi_8095_ = _e5039;
                                        }
                                        let _e5137 = phi_8095_;
                                        if (_e5042 < 0f) {
                                            phi_8101_ = -(_e5042);
                                        } else {
                                            phi_8101_ = _e5042;
                                        }
                                        let _e5141 = phi_8101_;
                                        if (_e5045 < 0f) {
                                            phi_8108_ = -(_e5045);
                                        } else {
                                            phi_8108_ = _e5045;
                                        }
                                        let _e5146 = phi_8108_;
                                        let _e5147 = ((_e5137 + _e5141) + _e5146);
                                        let _e5152 = -(_e5133);
                                        if (_e5112 > _e5152) {
                                            phi_8119_ = _e5112;
                                        } else {
                                            phi_8119_ = _e5152;
                                        }
                                        let _e5155 = phi_8119_;
                                        let _e5160 = (((_e5155 - ((_e5147 * _e4905) * (0.000000059604645f * (17f / 2f)))) - (_e5147 * _e4912)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5036 > _e5160) {
                                            phi_8129_ = _e5036;
                                        } else {
                                            phi_8129_ = _e5160;
                                        }
                                        let _e5163 = phi_8129_;
                                        if true {
                                            let _e5164 = (_e4667 - _e4652);
                                            let _e5165 = (_e4668 - _e4653);
                                            let _e5166 = (_e4669 - _e4654);
                                            let _e5169 = ((_e4675 * _e5166) - (_e4678 * _e5165));
                                            let _e5172 = ((_e4678 * _e5164) - (_e4672 * _e5166));
                                            let _e5175 = ((_e4672 * _e5165) - (_e4675 * _e5164));
                                            let _e5180 = (((_e5169 * _e4681[0]) + (_e5172 * _e4681[1])) + (_e5175 * _e4681[2]));
                                            let _e5185 = (((_e5169 * _e4698) + (_e5172 * _e4699)) + (_e5175 * _e4700));
                                            let _e5190 = (((_e5169 * _e4707) + (_e5172 * _e4708)) + (_e5175 * _e4709));
                                            let _e5198 = (((_e5169 * _e4706[0]) + (_e5172 * _e4706[1])) + (_e5175 * _e4706[2]));
                                            let _e5203 = (((_e5169 * _e4712[0]) + (_e5172 * _e4712[1])) + (_e5175 * _e4712[2]));
                                            let _e5208 = (((_e5169 * _e4729) + (_e5172 * _e4730)) + (_e5175 * _e4731));
                                            let _e5213 = (((_e5169 * _e4738) + (_e5172 * _e4739)) + (_e5175 * _e4740));
                                            let _e5221 = (((_e5169 * _e4737[0]) + (_e5172 * _e4737[1])) + (_e5175 * _e4737[2]));
                                            if (_e5180 < _e5185) {
                                                phi_8202_ = _e5180;
                                            } else {
                                                phi_8202_ = _e5185;
                                            }
                                            let _e5224 = phi_8202_;
                                            if (_e5190 < _e5198) {
                                                phi_8207_ = _e5190;
                                            } else {
                                                phi_8207_ = _e5198;
                                            }
                                            let _e5227 = phi_8207_;
                                            if (_e5224 < _e5227) {
                                                phi_8212_ = _e5224;
                                            } else {
                                                phi_8212_ = _e5227;
                                            }
                                            let _e5230 = phi_8212_;
                                            if (_e5203 < _e5208) {
                                                phi_8217_ = _e5203;
                                            } else {
                                                phi_8217_ = _e5208;
                                            }
                                            let _e5233 = phi_8217_;
                                            if (_e5213 < _e5221) {
                                                phi_8222_ = _e5213;
                                            } else {
                                                phi_8222_ = _e5221;
                                            }
                                            let _e5236 = phi_8222_;
                                            if (_e5233 < _e5236) {
                                                phi_8227_ = _e5233;
                                            } else {
                                                phi_8227_ = _e5236;
                                            }
                                            let _e5239 = phi_8227_;
                                            if (_e5230 < _e5239) {
                                                phi_8232_ = _e5230;
                                            } else {
                                                phi_8232_ = _e5239;
                                            }
                                            let _e5242 = phi_8232_;
                                            if (_e5180 > _e5185) {
                                                phi_8237_ = _e5180;
                                            } else {
                                                phi_8237_ = _e5185;
                                            }
                                            let _e5245 = phi_8237_;
                                            if (_e5190 > _e5198) {
                                                phi_8242_ = _e5190;
                                            } else {
                                                phi_8242_ = _e5198;
                                            }
                                            let _e5248 = phi_8242_;
                                            if (_e5245 > _e5248) {
                                                phi_8247_ = _e5245;
                                            } else {
                                                phi_8247_ = _e5248;
                                            }
                                            let _e5251 = phi_8247_;
                                            if (_e5203 > _e5208) {
                                                phi_8252_ = _e5203;
                                            } else {
                                                phi_8252_ = _e5208;
                                            }
                                            let _e5254 = phi_8252_;
                                            if (_e5213 > _e5221) {
                                                phi_8257_ = _e5213;
                                            } else {
                                                phi_8257_ = _e5221;
                                            }
                                            let _e5257 = phi_8257_;
                                            if (_e5254 > _e5257) {
                                                phi_8262_ = _e5254;
                                            } else {
                                                phi_8262_ = _e5257;
                                            }
                                            let _e5260 = phi_8262_;
                                            if (_e5251 > _e5260) {
                                                phi_8267_ = _e5251;
                                            } else {
                                                phi_8267_ = _e5260;
                                            }
                                            let _e5263 = phi_8267_;
                                            if (_e5169 < 0f) {
                                                phi_8273_ = -(_e5169);
                                            } else {
                                                phi_8273_ = _e5169;
                                            }
                                            let _e5267 = phi_8273_;
                                            if (_e5172 < 0f) {
                                                phi_8279_ = -(_e5172);
                                            } else {
                                                phi_8279_ = _e5172;
                                            }
                                            let _e5271 = phi_8279_;
                                            if (_e5175 < 0f) {
                                                phi_8286_ = -(_e5175);
                                            } else {
                                                phi_8286_ = _e5175;
                                            }
                                            let _e5276 = phi_8286_;
                                            let _e5277 = ((_e5267 + _e5271) + _e5276);
                                            let _e5282 = -(_e5263);
                                            if (_e5242 > _e5282) {
                                                phi_8297_ = _e5242;
                                            } else {
                                                phi_8297_ = _e5282;
                                            }
                                            let _e5285 = phi_8297_;
                                            let _e5290 = (((_e5285 - ((_e5277 * _e4905) * (0.000000059604645f * (17f / 2f)))) - (_e5277 * _e4912)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                            if (_e5163 > _e5290) {
                                                phi_8307_ = _e5163;
                                            } else {
                                                phi_8307_ = _e5290;
                                            }
                                            let _e5293 = phi_8307_;
                                            phi_8308_ = _e5293;
                                        } else {
                                            phi_8308_ = _e5163;
                                        }
                                        let _e5295 = phi_8308_;
                                        phi_8311_ = (_e4639 || (_e5295 > 0f));
                                    }
                                    let _e5299 = phi_8311_;
                                    phi_8313_ = (_e4204 && _e5299);
                                } else {
                                    phi_8313_ = _e4204;
                                }
                                let _e5302 = phi_8313_;
                                if !(_e5302) {
                                    let _e5305 = atomicAdd((&counters[7u]), 1u);
                                    hits[_e2866] = ((2147483648u | (_e5305 << bitcast<u32>(12i))) | _e2869);
                                }
                                phi_8324_ = true;
                            }
                            let _e5312 = phi_8324_;
                            phi_8325_ = _e5312;
                        } else {
                            phi_8325_ = false;
                        }
                        let _e5314 = phi_8325_;
                        continue;
                        continuing {
                            phi_4742_ = _e2858;
                            break if !(_e5314);
                        }
                    }
                    let _e5318 = params.member.member_1.member_3;
                    workgroupBarrier();
                    if (_e73 == 0u) {
                        let _e5321 = atomicLoad((&counters[7u]));
                        if (_e5321 > 0u) {
                            let _e5324 = atomicAdd((&output.member[0u]), _e5321);
                            if ((_e5324 + _e5321) < _e5324) {
                                let _e5328 = atomicAdd((&output.member[2u]), 1u);
                            }
                            atomicStore((&counters[8u]), _e5324);
                        }
                        atomicStore((&counters[5u]), 0u);
                        atomicStore((&counters[6u]), 0u);
                        atomicStore((&counters[7u]), 0u);
                    }
                    workgroupBarrier();
                    let _e5334 = atomicLoad((&counters[8u]));
                    phi_8361_ = type_9(0u, 4u);
                    loop {
                        let _e5336 = phi_8361_;
                        if (_e5336.member < _e5336.member_1) {
                            phi_8362_ = type_9((_e5336.member + 1u), _e5336.member_1);
                            phi_8385_ = type_9(1u, _e5336.member);
                        } else {
                            phi_8362_ = _e5336;
                            phi_8385_ = type_9(0u, type_9().member_1);
                        }
                        let _e5348 = phi_8362_;
                        let _e5350 = phi_8385_;
                        if (bitcast<i32>(_e5350.member) != 0i) {
                            let _e5356 = (_e73 + (_e5350.member_1 * 128u));
                            if (_e5356 >= _e2844) {
                                phi_8480_ = false;
                            } else {
                                let _e5359 = hits[_e5356];
                                if ((_e5359 & 2147483648u) == 0u) {
                                    phi_8409_ = 4294967295u;
                                } else {
                                    phi_8409_ = ((_e5359 & 2147483647u) >> bitcast<u32>(12i));
                                }
                                let _e5366 = phi_8409_;
                                if (_e5366 != 4294967295u) {
                                    let _e5370 = ((_e5359 >> bitcast<u32>(10i)) & 3u);
                                    let _e5377 = firsts[(2u * _e5370)];
                                    let _e5382 = firsts[((2u * _e5370) + 1u)];
                                    let _e5385 = leaves.member[(_e5377 + ((_e5359 >> bitcast<u32>(5i)) & 31u))];
                                    let _e5388 = leaves.member[(_e5382 + (_e5359 & 31u))];
                                    let _e5390 = (_e5334 + _e5366);
                                    if (_e5390 < _e5318) {
                                        let _e5392 = (2u * _e5390);
                                        atomicStore((&output.member[(4u + _e5392)]), _e5385.w);
                                        atomicStore((&output.member[(_e5392 + 5u)]), _e5388.w);
                                    }
                                }
                                phi_8480_ = true;
                            }
                            let _e5398 = phi_8480_;
                            phi_8481_ = _e5398;
                        } else {
                            phi_8481_ = false;
                        }
                        let _e5400 = phi_8481_;
                        continue;
                        continuing {
                            phi_8361_ = _e5348;
                            break if !(_e5400);
                        }
                    }
                    workgroupBarrier();
                    let _e5984 = local_7;
                    phi_1277_ = _e5984;
                } else {
                    phi_1277_ = type_9();
                }
                let _e5403 = phi_1277_;
                continue;
                continuing {
                    phi_1273_ = _e626;
                    phi_1276_ = _e5403;
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
        let _e5408 = atomicLoad((&counters[9u]));
        if (_e5408 > 0u) {
            let _e5411 = atomicAdd((&output.member[1u]), _e5408);
            if ((_e5411 + _e5408) < _e5411) {
                let _e5415 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_8(id, n, lane);
}
