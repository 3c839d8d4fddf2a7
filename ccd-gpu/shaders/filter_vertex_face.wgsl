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
    var phi_199_: bool;
    var phi_200_: bool;
    var phi_204_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_200_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_199_ = (param[0] > param_1[0]);
        } else {
            phi_199_ = false;
        }
        let _e14 = phi_199_;
        phi_200_ = _e14;
    }
    let _e16 = phi_200_;
    if _e16 {
        phi_204_ = param_1;
    } else {
        phi_204_ = param;
    }
    let _e18 = phi_204_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_223_: bool;
    var phi_224_: bool;
    var phi_228_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_224_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_223_ = (param_3[0] > param_2[0]);
        } else {
            phi_223_ = false;
        }
        let _e14 = phi_223_;
        phi_224_ = _e14;
    }
    let _e16 = phi_224_;
    if _e16 {
        phi_228_ = param_3;
    } else {
        phi_228_ = param_2;
    }
    let _e18 = phi_228_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_247_: bool;
    var phi_248_: bool;
    var phi_252_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_248_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_247_ = (param_4[0] > param_5[0]);
        } else {
            phi_247_ = false;
        }
        let _e14 = phi_247_;
        phi_248_ = _e14;
    }
    let _e16 = phi_248_;
    if _e16 {
        phi_252_ = param_5;
    } else {
        phi_252_ = param_4;
    }
    let _e18 = phi_252_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_271_: bool;
    var phi_272_: bool;
    var phi_276_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_272_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_271_ = (param_7[0] > param_6[0]);
        } else {
            phi_271_ = false;
        }
        let _e14 = phi_271_;
        phi_272_ = _e14;
    }
    let _e16 = phi_272_;
    if _e16 {
        phi_276_ = param_7;
    } else {
        phi_276_ = param_6;
    }
    let _e18 = phi_276_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_300_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_296_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_295_ = (param_8[0] > param_9[0]);
        } else {
            phi_295_ = false;
        }
        let _e14 = phi_295_;
        phi_296_ = _e14;
    }
    let _e16 = phi_296_;
    if _e16 {
        phi_300_ = param_9;
    } else {
        phi_300_ = param_8;
    }
    let _e18 = phi_300_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_324_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_320_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_319_ = (param_11[0] > param_10[0]);
        } else {
            phi_319_ = false;
        }
        let _e14 = phi_319_;
        phi_320_ = _e14;
    }
    let _e16 = phi_320_;
    if _e16 {
        phi_324_ = param_11;
    } else {
        phi_324_ = param_10;
    }
    let _e18 = phi_324_;
    return _e18;
}

fn function_6(param_12: f32, param_13: f32) -> f32 {
    var phi_336_: bool;
    var phi_340_: f32;

    if (param_12 != param_12) {
        phi_336_ = true;
    } else {
        phi_336_ = (param_13 <= param_12);
    }
    let _e6 = phi_336_;
    if _e6 {
        phi_340_ = param_13;
    } else {
        phi_340_ = param_12;
    }
    let _e8 = phi_340_;
    return _e8;
}

fn function_7(param_14: f32, param_15: f32) -> f32 {
    var phi_352_: bool;
    var phi_356_: f32;

    if (param_14 != param_14) {
        phi_352_ = true;
    } else {
        phi_352_ = (param_15 >= param_14);
    }
    let _e6 = phi_352_;
    if _e6 {
        phi_356_ = param_15;
    } else {
        phi_356_ = param_14;
    }
    let _e8 = phi_356_;
    return _e8;
}

fn function_8(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_39;
    var local_1: type_39;
    var local_2: type_39;
    var phi_410_: u32;
    var phi_459_: u32;
    var phi_460_: u32;
    var phi_468_: u32;
    var phi_484_: u32;
    var phi_507_: u32;
    var phi_508_: u32;
    var phi_511_: type_9;
    var phi_512_: type_9;
    var phi_537_: type_9;
    var phi_584_: u32;
    var phi_585_: u32;
    var phi_593_: u32;
    var phi_607_: u32;
    var phi_710_: array<u32, 2>;
    var phi_871_: bool;
    var phi_909_: type_29;
    var phi_938_: u32;
    var phi_941_: type_9;
    var phi_944_: u32;
    var phi_942_: type_9;
    var phi_967_: type_9;
    var phi_945_: u32;
    var local_3: u32;
    var phi_1156_: u32;
    var phi_1345_: type_9;
    var phi_1371_: u32;
    var phi_1374_: type_9;
    var phi_1377_: type_9;
    var phi_1375_: type_9;
    var phi_1402_: type_9;
    var phi_1419_: type_9;
    var phi_1422_: type_9;
    var phi_1423_: type_9;
    var phi_1445_: type_9;
    var phi_1479_: type_9;
    var phi_1480_: bool;
    var phi_1420_: type_9;
    var phi_1481_: bool;
    var phi_1489_: u32;
    var phi_1492_: type_9;
    var phi_1493_: type_9;
    var phi_1518_: type_9;
    var phi_1652_: bool;
    var phi_1659_: bool;
    var phi_1667_: bool;
    var phi_1686_: bool;
    var phi_1687_: bool;
    var phi_1728_: bool;
    var phi_1729_: bool;
    var phi_1736_: bool;
    var phi_1850_: bool;
    var phi_1851_: bool;
    var phi_1892_: type_15;
    var phi_1895_: u32;
    var phi_1897_: u32;
    var phi_1918_: bool;
    var phi_1924_: type_16;
    var phi_1893_: type_15;
    var phi_1938_: type_16;
    var phi_2006_: bool;
    var phi_2007_: bool;
    var phi_2008_: bool;
    var phi_2009_: bool;
    var phi_2013_: bool;
    var phi_2019_: u32;
    var phi_2020_: u32;
    var phi_2021_: u32;
    var phi_2022_: u32;
    var phi_2023_: bool;
    var phi_1896_: u32;
    var phi_1898_: u32;
    var phi_2024_: bool;
    var local_4: u32;
    var local_5: u32;
    var phi_2072_: bool;
    var phi_2073_: bool;
    var phi_2074_: bool;
    var phi_2075_: bool;
    var phi_2079_: bool;
    var phi_2080_: bool;
    var phi_2084_: bool;
    var phi_2088_: bool;
    var phi_2089_: bool;
    var phi_2093_: bool;
    var phi_2094_: bool;
    var phi_2098_: bool;
    var phi_2099_: bool;
    var phi_2215_: bool;
    var phi_2216_: bool;
    var phi_2303_: bool;
    var phi_2304_: bool;
    var phi_2392_: bool;
    var phi_2393_: bool;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var phi_2570_: bool;
    var phi_2571_: bool;
    var phi_2658_: bool;
    var phi_2659_: bool;
    var phi_2663_: bool;
    var phi_2664_: bool;
    var phi_2665_: bool;
    var phi_2669_: bool;
    var phi_2670_: bool;
    var phi_2671_: bool;
    var phi_2672_: bool;
    var phi_2673_: bool;
    var phi_2677_: bool;
    var phi_2837_: type_43;
    var phi_2884_: type_43;
    var phi_2956_: bool;
    var phi_2957_: bool;
    var phi_2962_: type_9;
    var phi_2963_: type_9;
    var phi_2986_: type_9;
    var phi_3191_: type_39;
    var phi_3471_: f32;
    var phi_3478_: f32;
    var phi_3483_: f32;
    var phi_3490_: f32;
    var phi_3495_: f32;
    var phi_3508_: f32;
    var phi_3515_: f32;
    var phi_3520_: f32;
    var phi_3527_: f32;
    var phi_3532_: f32;
    var phi_3537_: f32;
    var phi_3554_: f32;
    var phi_3561_: f32;
    var phi_3566_: f32;
    var phi_3573_: f32;
    var phi_3578_: f32;
    var phi_3592_: f32;
    var phi_3599_: f32;
    var phi_3604_: f32;
    var phi_3611_: f32;
    var phi_3616_: f32;
    var phi_3621_: f32;
    var phi_3638_: f32;
    var phi_3645_: f32;
    var phi_3650_: f32;
    var phi_3657_: f32;
    var phi_3662_: f32;
    var phi_3676_: f32;
    var phi_3683_: f32;
    var phi_3688_: f32;
    var phi_3695_: f32;
    var phi_3700_: f32;
    var phi_3705_: f32;
    var phi_3736_: f32;
    var phi_3742_: f32;
    var phi_3749_: f32;
    var phi_3756_: f32;
    var phi_3762_: f32;
    var phi_3769_: f32;
    var phi_3775_: f32;
    var phi_3781_: f32;
    var phi_3787_: f32;
    var phi_3794_: f32;
    var phi_3801_: f32;
    var phi_3825_: f32;
    var phi_3830_: f32;
    var phi_3835_: f32;
    var phi_3840_: f32;
    var phi_3845_: f32;
    var phi_3850_: f32;
    var phi_3860_: f32;
    var phi_3976_: array<f32, 3>;
    var phi_4041_: array<f32, 3>;
    var phi_4063_: f32;
    var phi_4070_: f32;
    var phi_4075_: f32;
    var phi_4082_: f32;
    var phi_4087_: f32;
    var phi_4100_: f32;
    var phi_4107_: f32;
    var phi_4112_: f32;
    var phi_4119_: f32;
    var phi_4124_: f32;
    var phi_4129_: f32;
    var phi_4146_: f32;
    var phi_4153_: f32;
    var phi_4158_: f32;
    var phi_4165_: f32;
    var phi_4170_: f32;
    var phi_4184_: f32;
    var phi_4191_: f32;
    var phi_4196_: f32;
    var phi_4203_: f32;
    var phi_4208_: f32;
    var phi_4213_: f32;
    var phi_4230_: f32;
    var phi_4237_: f32;
    var phi_4242_: f32;
    var phi_4249_: f32;
    var phi_4254_: f32;
    var phi_4268_: f32;
    var phi_4275_: f32;
    var phi_4280_: f32;
    var phi_4287_: f32;
    var phi_4292_: f32;
    var phi_4297_: f32;
    var phi_4376_: f32;
    var phi_4381_: f32;
    var phi_4386_: f32;
    var phi_4391_: f32;
    var phi_4396_: f32;
    var phi_4401_: f32;
    var phi_4406_: f32;
    var phi_4411_: f32;
    var phi_4416_: f32;
    var phi_4421_: f32;
    var phi_4426_: f32;
    var phi_4431_: f32;
    var phi_4436_: f32;
    var phi_4441_: f32;
    var phi_4447_: f32;
    var phi_4453_: f32;
    var phi_4460_: f32;
    var phi_4471_: f32;
    var phi_4542_: f32;
    var phi_4547_: f32;
    var phi_4552_: f32;
    var phi_4557_: f32;
    var phi_4562_: f32;
    var phi_4567_: f32;
    var phi_4572_: f32;
    var phi_4577_: f32;
    var phi_4582_: f32;
    var phi_4587_: f32;
    var phi_4592_: f32;
    var phi_4597_: f32;
    var phi_4602_: f32;
    var phi_4607_: f32;
    var phi_4613_: f32;
    var phi_4619_: f32;
    var phi_4626_: f32;
    var phi_4637_: f32;
    var phi_4647_: f32;
    var phi_4720_: f32;
    var phi_4725_: f32;
    var phi_4730_: f32;
    var phi_4735_: f32;
    var phi_4740_: f32;
    var phi_4745_: f32;
    var phi_4750_: f32;
    var phi_4755_: f32;
    var phi_4760_: f32;
    var phi_4765_: f32;
    var phi_4770_: f32;
    var phi_4775_: f32;
    var phi_4780_: f32;
    var phi_4785_: f32;
    var phi_4791_: f32;
    var phi_4797_: f32;
    var phi_4804_: f32;
    var phi_4815_: f32;
    var phi_4825_: f32;
    var phi_4826_: f32;
    var phi_4829_: bool;
    var phi_4836_: bool;
    var phi_4837_: bool;
    var phi_4842_: type_9;
    var phi_4843_: type_9;
    var phi_4866_: type_9;
    var phi_5071_: type_39;
    var phi_5450_: f32;
    var phi_5457_: f32;
    var phi_5462_: f32;
    var phi_5469_: f32;
    var phi_5474_: f32;
    var phi_5487_: f32;
    var phi_5494_: f32;
    var phi_5499_: f32;
    var phi_5506_: f32;
    var phi_5511_: f32;
    var phi_5516_: f32;
    var phi_5533_: f32;
    var phi_5540_: f32;
    var phi_5545_: f32;
    var phi_5552_: f32;
    var phi_5557_: f32;
    var phi_5571_: f32;
    var phi_5578_: f32;
    var phi_5583_: f32;
    var phi_5590_: f32;
    var phi_5595_: f32;
    var phi_5600_: f32;
    var phi_5617_: f32;
    var phi_5624_: f32;
    var phi_5629_: f32;
    var phi_5636_: f32;
    var phi_5641_: f32;
    var phi_5655_: f32;
    var phi_5662_: f32;
    var phi_5667_: f32;
    var phi_5674_: f32;
    var phi_5679_: f32;
    var phi_5684_: f32;
    var phi_5715_: f32;
    var phi_5721_: f32;
    var phi_5728_: f32;
    var phi_5735_: f32;
    var phi_5741_: f32;
    var phi_5748_: f32;
    var phi_5754_: f32;
    var phi_5760_: f32;
    var phi_5766_: f32;
    var phi_5773_: f32;
    var phi_5780_: f32;
    var phi_5804_: f32;
    var phi_5809_: f32;
    var phi_5814_: f32;
    var phi_5819_: f32;
    var phi_5824_: f32;
    var phi_5829_: f32;
    var phi_5839_: f32;
    var phi_5955_: array<f32, 3>;
    var phi_6020_: array<f32, 3>;
    var phi_6042_: f32;
    var phi_6049_: f32;
    var phi_6054_: f32;
    var phi_6061_: f32;
    var phi_6066_: f32;
    var phi_6079_: f32;
    var phi_6086_: f32;
    var phi_6091_: f32;
    var phi_6098_: f32;
    var phi_6103_: f32;
    var phi_6108_: f32;
    var phi_6125_: f32;
    var phi_6132_: f32;
    var phi_6137_: f32;
    var phi_6144_: f32;
    var phi_6149_: f32;
    var phi_6163_: f32;
    var phi_6170_: f32;
    var phi_6175_: f32;
    var phi_6182_: f32;
    var phi_6187_: f32;
    var phi_6192_: f32;
    var phi_6209_: f32;
    var phi_6216_: f32;
    var phi_6221_: f32;
    var phi_6228_: f32;
    var phi_6233_: f32;
    var phi_6247_: f32;
    var phi_6254_: f32;
    var phi_6259_: f32;
    var phi_6266_: f32;
    var phi_6271_: f32;
    var phi_6276_: f32;
    var phi_6355_: f32;
    var phi_6360_: f32;
    var phi_6365_: f32;
    var phi_6370_: f32;
    var phi_6375_: f32;
    var phi_6380_: f32;
    var phi_6385_: f32;
    var phi_6390_: f32;
    var phi_6395_: f32;
    var phi_6400_: f32;
    var phi_6405_: f32;
    var phi_6410_: f32;
    var phi_6415_: f32;
    var phi_6420_: f32;
    var phi_6426_: f32;
    var phi_6432_: f32;
    var phi_6439_: f32;
    var phi_6450_: f32;
    var phi_6521_: f32;
    var phi_6526_: f32;
    var phi_6531_: f32;
    var phi_6536_: f32;
    var phi_6541_: f32;
    var phi_6546_: f32;
    var phi_6551_: f32;
    var phi_6556_: f32;
    var phi_6561_: f32;
    var phi_6566_: f32;
    var phi_6571_: f32;
    var phi_6576_: f32;
    var phi_6581_: f32;
    var phi_6586_: f32;
    var phi_6592_: f32;
    var phi_6598_: f32;
    var phi_6605_: f32;
    var phi_6616_: f32;
    var phi_6626_: f32;
    var phi_6699_: f32;
    var phi_6704_: f32;
    var phi_6709_: f32;
    var phi_6714_: f32;
    var phi_6719_: f32;
    var phi_6724_: f32;
    var phi_6729_: f32;
    var phi_6734_: f32;
    var phi_6739_: f32;
    var phi_6744_: f32;
    var phi_6749_: f32;
    var phi_6754_: f32;
    var phi_6759_: f32;
    var phi_6764_: f32;
    var phi_6770_: f32;
    var phi_6776_: f32;
    var phi_6783_: f32;
    var phi_6794_: f32;
    var phi_6804_: f32;
    var phi_6805_: f32;
    var phi_6808_: bool;
    var phi_7053_: f32;
    var phi_7060_: f32;
    var phi_7065_: f32;
    var phi_7072_: f32;
    var phi_7077_: f32;
    var phi_7090_: f32;
    var phi_7097_: f32;
    var phi_7102_: f32;
    var phi_7109_: f32;
    var phi_7114_: f32;
    var phi_7119_: f32;
    var phi_7136_: f32;
    var phi_7143_: f32;
    var phi_7148_: f32;
    var phi_7155_: f32;
    var phi_7160_: f32;
    var phi_7174_: f32;
    var phi_7181_: f32;
    var phi_7186_: f32;
    var phi_7193_: f32;
    var phi_7198_: f32;
    var phi_7203_: f32;
    var phi_7220_: f32;
    var phi_7227_: f32;
    var phi_7232_: f32;
    var phi_7239_: f32;
    var phi_7244_: f32;
    var phi_7258_: f32;
    var phi_7265_: f32;
    var phi_7270_: f32;
    var phi_7277_: f32;
    var phi_7282_: f32;
    var phi_7287_: f32;
    var phi_7318_: f32;
    var phi_7324_: f32;
    var phi_7331_: f32;
    var phi_7338_: f32;
    var phi_7344_: f32;
    var phi_7351_: f32;
    var phi_7357_: f32;
    var phi_7363_: f32;
    var phi_7369_: f32;
    var phi_7376_: f32;
    var phi_7383_: f32;
    var phi_7407_: f32;
    var phi_7412_: f32;
    var phi_7417_: f32;
    var phi_7422_: f32;
    var phi_7427_: f32;
    var phi_7432_: f32;
    var phi_7442_: f32;
    var phi_7558_: array<f32, 3>;
    var phi_7623_: array<f32, 3>;
    var phi_7645_: f32;
    var phi_7652_: f32;
    var phi_7657_: f32;
    var phi_7664_: f32;
    var phi_7669_: f32;
    var phi_7682_: f32;
    var phi_7689_: f32;
    var phi_7694_: f32;
    var phi_7701_: f32;
    var phi_7706_: f32;
    var phi_7711_: f32;
    var phi_7728_: f32;
    var phi_7735_: f32;
    var phi_7740_: f32;
    var phi_7747_: f32;
    var phi_7752_: f32;
    var phi_7766_: f32;
    var phi_7773_: f32;
    var phi_7778_: f32;
    var phi_7785_: f32;
    var phi_7790_: f32;
    var phi_7795_: f32;
    var phi_7812_: f32;
    var phi_7819_: f32;
    var phi_7824_: f32;
    var phi_7831_: f32;
    var phi_7836_: f32;
    var phi_7850_: f32;
    var phi_7857_: f32;
    var phi_7862_: f32;
    var phi_7869_: f32;
    var phi_7874_: f32;
    var phi_7879_: f32;
    var phi_7958_: f32;
    var phi_7963_: f32;
    var phi_7968_: f32;
    var phi_7973_: f32;
    var phi_7978_: f32;
    var phi_7983_: f32;
    var phi_7988_: f32;
    var phi_7993_: f32;
    var phi_7998_: f32;
    var phi_8003_: f32;
    var phi_8008_: f32;
    var phi_8013_: f32;
    var phi_8018_: f32;
    var phi_8023_: f32;
    var phi_8029_: f32;
    var phi_8035_: f32;
    var phi_8042_: f32;
    var phi_8053_: f32;
    var phi_8124_: f32;
    var phi_8129_: f32;
    var phi_8134_: f32;
    var phi_8139_: f32;
    var phi_8144_: f32;
    var phi_8149_: f32;
    var phi_8154_: f32;
    var phi_8159_: f32;
    var phi_8164_: f32;
    var phi_8169_: f32;
    var phi_8174_: f32;
    var phi_8179_: f32;
    var phi_8184_: f32;
    var phi_8189_: f32;
    var phi_8195_: f32;
    var phi_8201_: f32;
    var phi_8208_: f32;
    var phi_8219_: f32;
    var phi_8229_: f32;
    var phi_8302_: f32;
    var phi_8307_: f32;
    var phi_8312_: f32;
    var phi_8317_: f32;
    var phi_8322_: f32;
    var phi_8327_: f32;
    var phi_8332_: f32;
    var phi_8337_: f32;
    var phi_8342_: f32;
    var phi_8347_: f32;
    var phi_8352_: f32;
    var phi_8357_: f32;
    var phi_8362_: f32;
    var phi_8367_: f32;
    var phi_8373_: f32;
    var phi_8379_: f32;
    var phi_8386_: f32;
    var phi_8397_: f32;
    var phi_8407_: f32;
    var phi_8408_: f32;
    var phi_8411_: bool;
    var phi_8413_: bool;
    var phi_8423_: bool;
    var phi_8424_: bool;
    var phi_8460_: type_9;
    var phi_8461_: type_9;
    var phi_8484_: type_9;
    var phi_8508_: u32;
    var phi_8579_: bool;
    var phi_8580_: bool;
    var phi_1378_: type_9;
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
        phi_410_ = _e96;
    } else {
        phi_410_ = _e98;
    }
    let _e101 = phi_410_;
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
            phi_459_ = (_e116 + 1u);
        } else {
            phi_459_ = _e116;
        }
        let _e122 = phi_459_;
        phi_460_ = _e122;
    } else {
        phi_460_ = 0u;
    }
    let _e124 = phi_460_;
    let _e127 = params.member.member_2.member_4;
    if (_e127 < _e124) {
        phi_468_ = _e127;
    } else {
        phi_468_ = _e124;
    }
    let _e130 = phi_468_;
    let _e131 = (_e130 / 4u);
    if ((_e130 % 4u) > 0u) {
        phi_484_ = (_e131 + 1u);
    } else {
        phi_484_ = _e131;
    }
    let _e136 = phi_484_;
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
            phi_507_ = (_e140 + 1u);
        } else {
            phi_507_ = _e140;
        }
        let _e146 = phi_507_;
        phi_508_ = _e146;
    } else {
        phi_508_ = 0u;
    }
    let _e148 = phi_508_;
    phi_511_ = type_9(0u, _e148);
    loop {
        let _e151 = phi_511_;
        if (_e151.member < _e151.member_1) {
            phi_512_ = type_9((_e151.member + 1u), _e151.member_1);
            phi_537_ = type_9(1u, _e151.member);
        } else {
            phi_512_ = _e151;
            phi_537_ = type_9(0u, type_9().member_1);
        }
        let _e163 = phi_512_;
        let _e165 = phi_537_;
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
                    phi_584_ = (_e187 + 1u);
                } else {
                    phi_584_ = _e187;
                }
                let _e193 = phi_584_;
                phi_585_ = _e193;
            } else {
                phi_585_ = 0u;
            }
            let _e195 = phi_585_;
            let _e198 = params.member.member_2.member_4;
            if (_e198 < _e195) {
                phi_593_ = _e198;
            } else {
                phi_593_ = _e195;
            }
            let _e201 = phi_593_;
            let _e202 = (_e174 < _e201);
            let _e205 = params.member.member_1.member_1;
            let _e208 = params.member.member_2.member_3;
            if _e202 {
                phi_607_ = (_e174 * _e208);
            } else {
                phi_607_ = 0u;
            }
            let _e211 = phi_607_;
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
                phi_710_ = array<u32, 2>(0u, 2u);
            } else {
                phi_710_ = array<u32, 2>(1u, 1u);
            }
            let _e248 = phi_710_;
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
                phi_871_ = ((((((_e306.member.x <= _e282.member_1.y) && (_e282.member.x <= _e306.member_1.y)) && (_e306.member.y <= _e282.member_2.x)) && (_e282.member.y <= _e306.member_2.x)) && (_e306.member_1.x <= _e282.member_2.y)) && (_e282.member_1.x <= _e306.member_2.y));
            } else {
                phi_871_ = false;
            }
            let _e358 = phi_871_;
            if _e202 {
                if ((((((_e333.member.x <= _e261.member_1.y) && (_e261.member.x <= _e333.member_1.y)) && (_e333.member.y <= _e261.member_2.x)) && (_e261.member.y <= _e333.member_2.x)) && (_e333.member_1.x <= _e261.member_2.y)) && (_e261.member_1.x <= _e333.member_2.y)) {
                    let _e372 = atomicAdd((&counters[_e251]), 1u);
                    let _e373 = ((_e251 * 32u) + _e372);
                    columns[_e373] = type_29(array<f32, 3>(_e333.member.x, _e333.member.y, _e333.member_1.x), array<f32, 3>(_e333.member_1.y, _e333.member_2.x, _e333.member_2.y));
                    names[_e373] = _e252;
                }
            }
            if _e358 {
                phi_909_ = type_29(array<f32, 3>(_e306.member.x, _e306.member.y, _e306.member_1.x), array<f32, 3>(_e306.member_1.y, _e306.member_2.x, _e306.member_2.y));
            } else {
                phi_909_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e380 = phi_909_;
            workgroupBarrier();
            let _e381 = (_e73 / 32u);
            let _e382 = (_e381 * 32u);
            let _e384 = atomicLoad((&counters[_e381]));
            let _e385 = (_e384 / 4u);
            if ((_e384 % 4u) > 0u) {
                phi_938_ = (_e385 + 1u);
            } else {
                phi_938_ = _e385;
            }
            let _e390 = phi_938_;
            phi_941_ = type_9(0u, _e390);
            phi_944_ = 0u;
            loop {
                let _e393 = phi_941_;
                let _e395 = phi_944_;
                local_3 = _e395;
                local_6 = _e395;
                if (_e393.member < _e393.member_1) {
                    phi_942_ = type_9((_e393.member + 1u), _e393.member_1);
                    phi_967_ = type_9(1u, _e393.member);
                } else {
                    phi_942_ = _e393;
                    phi_967_ = type_9(0u, type_9().member_1);
                }
                let _e407 = phi_942_;
                let _e409 = phi_967_;
                let _e413 = (bitcast<i32>(_e409.member) != 0i);
                if _e413 {
                    let _e414 = (4u * _e409.member_1);
                    let _e417 = columns[(_e382 + _e414)];
                    let _e456 = columns[((_e382 + _e414) + 1u)];
                    let _e497 = columns[((_e382 + _e414) + 2u)];
                    let _e538 = columns[((_e382 + _e414) + 3u)];
                    phi_945_ = (_e395 | ((((select(0u, 1u, ((((((_e380.member[0] <= _e417.member_1[0]) && (_e417.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e417.member_1[1])) && (_e417.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e417.member_1[2])) && (_e417.member[2] <= _e380.member_1[2]))) << bitcast<u32>((_e414 & 31u))) | (select(0u, 1u, ((((((_e380.member[0] <= _e456.member_1[0]) && (_e456.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e456.member_1[1])) && (_e456.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e456.member_1[2])) && (_e456.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e414 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e380.member[0] <= _e497.member_1[0]) && (_e497.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e497.member_1[1])) && (_e497.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e497.member_1[2])) && (_e497.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e414 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e380.member[0] <= _e538.member_1[0]) && (_e538.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e538.member_1[1])) && (_e538.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e538.member_1[2])) && (_e538.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e414 + 3u) & 31u)))));
                } else {
                    phi_945_ = u32();
                }
                let _e578 = phi_945_;
                continue;
                continuing {
                    phi_941_ = _e407;
                    phi_944_ = _e578;
                    break if !(_e413);
                }
            }
            if (_e384 < 32u) {
                let _e586 = local_3;
                phi_1156_ = (_e586 & ((1u << bitcast<u32>((_e384 & 31u))) - 1u));
            } else {
                let _e5440 = local_6;
                phi_1156_ = _e5440;
            }
            let _e589 = phi_1156_;
            let _e591 = countOneBits(_e589);
            if (_e591 > 0u) {
                let _e594 = atomicAdd((&counters[4u]), _e591);
                phi_1345_ = type_9(_e589, _e594);
            } else {
                phi_1345_ = type_9(_e589, 0u);
            }
            let _e597 = phi_1345_;
            workgroupBarrier();
            if (_e73 == 0u) {
                let _e600 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e600;
            }
            let _e603 = workgroupUniformLoad((&n_hits[0u]));
            let _e604 = (_e603 / 512u);
            if ((_e603 % 512u) > 0u) {
                phi_1371_ = (_e604 + 1u);
            } else {
                phi_1371_ = _e604;
            }
            let _e609 = phi_1371_;
            phi_1374_ = type_9(0u, _e609);
            phi_1377_ = _e597;
            loop {
                let _e612 = phi_1374_;
                let _e614 = phi_1377_;
                if (_e612.member < _e612.member_1) {
                    phi_1375_ = type_9((_e612.member + 1u), _e612.member_1);
                    phi_1402_ = type_9(1u, _e612.member);
                } else {
                    phi_1375_ = _e612;
                    phi_1402_ = type_9(0u, type_9().member_1);
                }
                let _e626 = phi_1375_;
                let _e628 = phi_1402_;
                let _e632 = (bitcast<i32>(_e628.member) != 0i);
                if _e632 {
                    let _e633 = (_e73 / 32u);
                    let _e635 = (_e628.member_1 * 512u);
                    phi_1419_ = _e614;
                    phi_1422_ = type_9(0u, countOneBits(_e614.member));
                    loop {
                        let _e640 = phi_1419_;
                        let _e642 = phi_1422_;
                        local_7 = _e640;
                        if (_e642.member < _e642.member_1) {
                            phi_1423_ = type_9((_e642.member + 1u), _e642.member_1);
                            phi_1445_ = type_9(1u, _e642.member);
                        } else {
                            phi_1423_ = _e642;
                            phi_1445_ = type_9(0u, type_9().member_1);
                        }
                        let _e654 = phi_1423_;
                        let _e656 = phi_1445_;
                        if (bitcast<i32>(_e656.member) != 0i) {
                            let _e661 = (_e640.member_1 - _e635);
                            if (_e661 >= 512u) {
                                phi_1479_ = type_9();
                                phi_1480_ = false;
                            } else {
                                let _e670 = names[((_e633 * 32u) + select(firstTrailingBit(_e640.member), 32u, (_e640.member == 0u)))];
                                hits[_e661] = (((_e633 << bitcast<u32>(10i)) | ((_e73 % 32u) << bitcast<u32>(5i))) | _e670);
                                phi_1479_ = type_9((_e640.member & (_e640.member - 1u)), (_e640.member_1 + 1u));
                                phi_1480_ = true;
                            }
                            let _e686 = phi_1479_;
                            let _e688 = phi_1480_;
                            phi_1420_ = _e686;
                            phi_1481_ = _e688;
                        } else {
                            phi_1420_ = type_9();
                            phi_1481_ = false;
                        }
                        let _e690 = phi_1420_;
                        let _e692 = phi_1481_;
                        continue;
                        continuing {
                            phi_1419_ = _e690;
                            phi_1422_ = _e654;
                            break if !(_e692);
                        }
                    }
                    workgroupBarrier();
                    let _e695 = n_hits[0u];
                    let _e696 = (_e695 - _e635);
                    if (512u < _e696) {
                        phi_1489_ = 512u;
                    } else {
                        phi_1489_ = _e696;
                    }
                    let _e699 = phi_1489_;
                    phi_1492_ = type_9(0u, 4u);
                    loop {
                        let _e701 = phi_1492_;
                        if (_e701.member < _e701.member_1) {
                            phi_1493_ = type_9((_e701.member + 1u), _e701.member_1);
                            phi_1518_ = type_9(1u, _e701.member);
                        } else {
                            phi_1493_ = _e701;
                            phi_1518_ = type_9(0u, type_9().member_1);
                        }
                        let _e713 = phi_1493_;
                        let _e715 = phi_1518_;
                        if (bitcast<i32>(_e715.member) != 0i) {
                            let _e721 = (_e73 + (_e715.member_1 * 128u));
                            if (_e721 >= _e699) {
                                phi_2956_ = false;
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
                                        phi_1652_ = true;
                                    } else {
                                        phi_1652_ = (_e748.x == _e742.x);
                                    }
                                    let _e803 = phi_1652_;
                                    if (_e748.y == _e742.x) {
                                        phi_1659_ = true;
                                    } else {
                                        phi_1659_ = (_e748.y == _e742.x);
                                    }
                                    let _e807 = phi_1659_;
                                    if (_e748.z == _e742.x) {
                                        phi_1667_ = true;
                                    } else {
                                        phi_1667_ = (_e748.z == _e742.x);
                                    }
                                    let _e812 = phi_1667_;
                                    if ((_e803 || _e807) || _e812) {
                                        phi_1686_ = false;
                                    } else {
                                        phi_1686_ = true;
                                    }
                                    let _e815 = phi_1686_;
                                    phi_1687_ = _e815;
                                } else {
                                    phi_1687_ = true;
                                }
                                let _e817 = phi_1687_;
                                if _e817 {
                                    if ((_e91.member_1 & 2u) != 0u) {
                                        let _e822 = bodies.member[_e742.x];
                                        let _e824 = bodies.member[_e748.x];
                                        if ((_e822 / 4u) != (_e824 / 4u)) {
                                            phi_1729_ = true;
                                        } else {
                                            if ((_e822 & 2u) == 0u) {
                                                phi_1728_ = false;
                                            } else {
                                                phi_1728_ = true;
                                            }
                                            let _e831 = phi_1728_;
                                            phi_1729_ = _e831;
                                        }
                                        let _e833 = phi_1729_;
                                        if _e833 {
                                            phi_1736_ = (((_e822 & _e824) & 1u) == 0u);
                                        } else {
                                            phi_1736_ = false;
                                        }
                                        let _e838 = phi_1736_;
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
                                                        phi_1850_ = true;
                                                    } else {
                                                        phi_1850_ = ((_e822 >> bitcast<u32>(2i)) == (_e824 >> bitcast<u32>(2i)));
                                                    }
                                                    let _e891 = phi_1850_;
                                                    phi_1851_ = _e891;
                                                } else {
                                                    phi_1851_ = false;
                                                }
                                                let _e893 = phi_1851_;
                                                if _e893 {
                                                    let _e896 = bodies.member[(_e91.member[0] + 2u)];
                                                    let _e899 = bodies.member[(_e91.member[0] + 3u)];
                                                    let _e900 = (_e899 + _e91.member[0]);
                                                    phi_1892_ = type_15(0i, 32i);
                                                    phi_1895_ = _e896;
                                                    phi_1897_ = 0u;
                                                    loop {
                                                        let _e902 = phi_1892_;
                                                        let _e904 = phi_1895_;
                                                        let _e906 = phi_1897_;
                                                        local_4 = _e906;
                                                        local_5 = _e906;
                                                        if (_e902.member < _e902.member_1) {
                                                            let _e913 = (_e902.member + 1i);
                                                            if ((false == (_e913 > _e902.member)) != false) {
                                                                phi_1918_ = true;
                                                            } else {
                                                                phi_1918_ = false;
                                                            }
                                                            let _e918 = phi_1918_;
                                                            if _e918 {
                                                                phi_1924_ = type_16(0u, type_16().member_1);
                                                            } else {
                                                                phi_1924_ = type_16(1u, _e913);
                                                            }
                                                            let _e923 = phi_1924_;
                                                            phi_1893_ = type_15(_e923.member_1, _e902.member_1);
                                                            phi_1938_ = type_16(1u, _e902.member);
                                                        } else {
                                                            phi_1893_ = _e902;
                                                            phi_1938_ = type_16(0u, type_16().member_1);
                                                        }
                                                        let _e929 = phi_1893_;
                                                        let _e931 = phi_1938_;
                                                        if (bitcast<i32>(_e931.member) != 0i) {
                                                            if (_e906 >= _e904) {
                                                                phi_2021_ = u32();
                                                                phi_2022_ = u32();
                                                                phi_2023_ = false;
                                                            } else {
                                                                let _e938 = (_e906 + ((_e904 - _e906) / 2u));
                                                                let _e940 = (_e900 + (3u * _e938));
                                                                let _e942 = bodies.member[_e940];
                                                                let _e945 = bodies.member[(_e940 + 1u)];
                                                                let _e948 = bodies.member[(_e940 + 2u)];
                                                                if (_e942 == 0u) {
                                                                    if (_e945 < _e742.w) {
                                                                        phi_2008_ = false;
                                                                    } else {
                                                                        if (_e945 == _e742.w) {
                                                                            if (_e948 < _e748.w) {
                                                                                phi_2006_ = false;
                                                                            } else {
                                                                                phi_2006_ = true;
                                                                            }
                                                                            let _e954 = phi_2006_;
                                                                            phi_2007_ = _e954;
                                                                        } else {
                                                                            phi_2007_ = true;
                                                                        }
                                                                        let _e956 = phi_2007_;
                                                                        phi_2008_ = _e956;
                                                                    }
                                                                    let _e958 = phi_2008_;
                                                                    phi_2009_ = _e958;
                                                                } else {
                                                                    phi_2009_ = true;
                                                                }
                                                                let _e960 = phi_2009_;
                                                                if _e960 {
                                                                    phi_2013_ = false;
                                                                } else {
                                                                    phi_2013_ = true;
                                                                }
                                                                let _e962 = phi_2013_;
                                                                if _e962 {
                                                                    phi_2019_ = _e904;
                                                                    phi_2020_ = (_e938 + 1u);
                                                                } else {
                                                                    phi_2019_ = _e938;
                                                                    phi_2020_ = _e906;
                                                                }
                                                                let _e965 = phi_2019_;
                                                                let _e967 = phi_2020_;
                                                                phi_2021_ = _e965;
                                                                phi_2022_ = _e967;
                                                                phi_2023_ = true;
                                                            }
                                                            let _e969 = phi_2021_;
                                                            let _e971 = phi_2022_;
                                                            let _e973 = phi_2023_;
                                                            phi_1896_ = _e969;
                                                            phi_1898_ = _e971;
                                                            phi_2024_ = _e973;
                                                        } else {
                                                            phi_1896_ = u32();
                                                            phi_1898_ = u32();
                                                            phi_2024_ = false;
                                                        }
                                                        let _e975 = phi_1896_;
                                                        let _e977 = phi_1898_;
                                                        let _e979 = phi_2024_;
                                                        continue;
                                                        continuing {
                                                            phi_1892_ = _e929;
                                                            phi_1895_ = _e975;
                                                            phi_1897_ = _e977;
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
                                                                phi_2072_ = (_e997 == _e748.w);
                                                                phi_2073_ = false;
                                                            } else {
                                                                phi_2072_ = bool();
                                                                phi_2073_ = true;
                                                            }
                                                            let _e1000 = phi_2072_;
                                                            let _e1002 = phi_2073_;
                                                            phi_2074_ = _e1000;
                                                            phi_2075_ = _e1002;
                                                        } else {
                                                            phi_2074_ = bool();
                                                            phi_2075_ = true;
                                                        }
                                                        let _e1004 = phi_2074_;
                                                        let _e1006 = phi_2075_;
                                                        if _e1006 {
                                                            phi_2079_ = false;
                                                        } else {
                                                            phi_2079_ = _e1004;
                                                        }
                                                        let _e1008 = phi_2079_;
                                                        phi_2080_ = _e1008;
                                                    } else {
                                                        phi_2080_ = false;
                                                    }
                                                    let _e1010 = phi_2080_;
                                                    phi_2084_ = _e1010;
                                                } else {
                                                    phi_2084_ = true;
                                                }
                                                let _e1012 = phi_2084_;
                                                if _e1012 {
                                                    phi_2088_ = false;
                                                } else {
                                                    phi_2088_ = true;
                                                }
                                                let _e1014 = phi_2088_;
                                                phi_2089_ = _e1014;
                                            } else {
                                                phi_2089_ = true;
                                            }
                                            let _e1016 = phi_2089_;
                                            if _e1016 {
                                                phi_2093_ = false;
                                            } else {
                                                phi_2093_ = true;
                                            }
                                            let _e1018 = phi_2093_;
                                            phi_2094_ = _e1018;
                                        } else {
                                            phi_2094_ = true;
                                        }
                                        let _e1020 = phi_2094_;
                                        if _e1020 {
                                            phi_2098_ = false;
                                        } else {
                                            phi_2098_ = true;
                                        }
                                        let _e1022 = phi_2098_;
                                        phi_2099_ = _e1022;
                                    } else {
                                        phi_2099_ = true;
                                    }
                                    let _e1024 = phi_2099_;
                                    if _e1024 {
                                        if ((_e91.member_1 & 32u) != 0u) {
                                            let _e1045 = (((((_e770.member_1.y - _e784.member.x) > _e91.member_6) && ((_e784.member_1.y - _e770.member.x) > _e91.member_6)) && (((_e770.member_2.x - _e784.member.y) > _e91.member_6) && ((_e784.member_2.x - _e770.member.y) > _e91.member_6))) && (((_e770.member_2.y - _e784.member_1.x) > _e91.member_6) && ((_e784.member_2.y - _e770.member_1.x) > _e91.member_6)));
                                            if _e1045 {
                                                phi_2663_ = bool();
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
                                                    phi_2216_ = true;
                                                } else {
                                                    if (_e1056[1] == _e1067[1]) {
                                                        phi_2215_ = (_e1056[0] > _e1067[0]);
                                                    } else {
                                                        phi_2215_ = false;
                                                    }
                                                    let _e1078 = phi_2215_;
                                                    phi_2216_ = _e1078;
                                                }
                                                let _e1080 = phi_2216_;
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
                                                    phi_2304_ = true;
                                                } else {
                                                    if (_e1092[1] == _e1103[1]) {
                                                        phi_2303_ = (_e1092[0] > _e1103[0]);
                                                    } else {
                                                        phi_2303_ = false;
                                                    }
                                                    let _e1114 = phi_2303_;
                                                    phi_2304_ = _e1114;
                                                }
                                                let _e1116 = phi_2304_;
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
                                                    phi_2393_ = true;
                                                } else {
                                                    if (_e1129[1] == _e1140[1]) {
                                                        phi_2392_ = (_e1129[0] > _e1140[0]);
                                                    } else {
                                                        phi_2392_ = false;
                                                    }
                                                    let _e1151 = phi_2392_;
                                                    phi_2393_ = _e1151;
                                                }
                                                let _e1153 = phi_2393_;
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
                                                    phi_2481_ = true;
                                                } else {
                                                    if (_e1165[1] == _e1176[1]) {
                                                        phi_2480_ = (_e1165[0] > _e1176[0]);
                                                    } else {
                                                        phi_2480_ = false;
                                                    }
                                                    let _e1187 = phi_2480_;
                                                    phi_2481_ = _e1187;
                                                }
                                                let _e1189 = phi_2481_;
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
                                                    phi_2571_ = true;
                                                } else {
                                                    if (_e1203[1] == _e1214[1]) {
                                                        phi_2570_ = (_e1203[0] > _e1214[0]);
                                                    } else {
                                                        phi_2570_ = false;
                                                    }
                                                    let _e1225 = phi_2570_;
                                                    phi_2571_ = _e1225;
                                                }
                                                let _e1227 = phi_2571_;
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
                                                    phi_2659_ = true;
                                                } else {
                                                    if (_e1239[1] == _e1250[1]) {
                                                        phi_2658_ = (_e1239[0] > _e1250[0]);
                                                    } else {
                                                        phi_2658_ = false;
                                                    }
                                                    let _e1261 = phi_2658_;
                                                    phi_2659_ = _e1261;
                                                }
                                                let _e1263 = phi_2659_;
                                                phi_2663_ = (((!(_e1080) && !(_e1116)) && (!(_e1153) && !(_e1189))) && (!(_e1227) && !(_e1263)));
                                            }
                                            let _e1268 = phi_2663_;
                                            phi_2664_ = _e1268;
                                            phi_2665_ = _e1045;
                                        } else {
                                            phi_2664_ = bool();
                                            phi_2665_ = true;
                                        }
                                        let _e1270 = phi_2664_;
                                        let _e1272 = phi_2665_;
                                        if _e1272 {
                                            phi_2669_ = false;
                                        } else {
                                            phi_2669_ = true;
                                        }
                                        let _e1274 = phi_2669_;
                                        phi_2670_ = _e1270;
                                        phi_2671_ = _e1274;
                                    } else {
                                        phi_2670_ = false;
                                        phi_2671_ = true;
                                    }
                                    let _e1276 = phi_2670_;
                                    let _e1278 = phi_2671_;
                                    phi_2672_ = _e1276;
                                    phi_2673_ = _e1278;
                                } else {
                                    phi_2672_ = false;
                                    phi_2673_ = true;
                                }
                                let _e1280 = phi_2672_;
                                let _e1282 = phi_2673_;
                                if _e1282 {
                                    phi_2677_ = _e1280;
                                } else {
                                    phi_2677_ = true;
                                }
                                let _e1284 = phi_2677_;
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
                                        phi_2837_ = type_43(array<array<f32, 3>, 2>(array<f32, 3>(_e1373, _e1374, _e1375), array<f32, 3>(_e1377, _e1378, _e1379)), array<array<f32, 3>, 2>(array<f32, 3>(_e1382, _e1383, _e1384), array<f32, 3>(_e1386, _e1387, _e1388)));
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
                                        phi_2837_ = type_43(array<array<f32, 3>, 2>(_e1343, _e1343), array<array<f32, 3>, 2>(array<f32, 3>(_e1357, _e1358, _e1359), array<f32, 3>(_e1367, _e1368, _e1369)));
                                    }
                                    let _e1393 = phi_2837_;
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
                                        phi_2884_ = type_43(array<array<f32, 3>, 2>(array<f32, 3>(_e1417, _e1418, _e1419), array<f32, 3>(_e1421, _e1422, _e1423)), array<array<f32, 3>, 2>(array<f32, 3>(_e1426, _e1427, _e1428), array<f32, 3>(_e1430, _e1431, _e1432)));
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
                                        phi_2884_ = type_43(array<array<f32, 3>, 2>(_e1344, _e1344), array<array<f32, 3>, 2>(array<f32, 3>(_e1401, _e1402, _e1403), array<f32, 3>(_e1411, _e1412, _e1413)));
                                    }
                                    let _e1437 = phi_2884_;
                                    if !(((((((_e1393.member[0][0] - _e1393.member_1[1][0]) > _e1349) && ((_e1437.member[0][0] - _e1437.member_1[1][0]) > _e1349)) || (((_e1393.member_1[0][0] - _e1393.member[1][0]) > _e1349) && ((_e1437.member_1[0][0] - _e1437.member[1][0]) > _e1349))) || ((((_e1393.member[0][1] - _e1393.member_1[1][1]) > _e1349) && ((_e1437.member[0][1] - _e1437.member_1[1][1]) > _e1349)) || (((_e1393.member_1[0][1] - _e1393.member[1][1]) > _e1349) && ((_e1437.member_1[0][1] - _e1437.member[1][1]) > _e1349)))) || ((((_e1393.member[0][2] - _e1393.member_1[1][2]) > _e1349) && ((_e1437.member[0][2] - _e1437.member_1[1][2]) > _e1349)) || (((_e1393.member_1[0][2] - _e1393.member[1][2]) > _e1349) && ((_e1437.member_1[0][2] - _e1437.member[1][2]) > _e1349))))) {
                                        let _e1527 = atomicAdd((&counters[5u]), 1u);
                                        left[_e1527] = _e724;
                                    }
                                }
                                phi_2956_ = true;
                            }
                            let _e1530 = phi_2956_;
                            phi_2957_ = _e1530;
                        } else {
                            phi_2957_ = false;
                        }
                        let _e1532 = phi_2957_;
                        continue;
                        continuing {
                            phi_1492_ = _e713;
                            break if !(_e1532);
                        }
                    }
                    workgroupBarrier();
                    let _e1535 = atomicLoad((&counters[5u]));
                    phi_2962_ = type_9(0u, 4u);
                    loop {
                        let _e1537 = phi_2962_;
                        if (_e1537.member < _e1537.member_1) {
                            phi_2963_ = type_9((_e1537.member + 1u), _e1537.member_1);
                            phi_2986_ = type_9(1u, _e1537.member);
                        } else {
                            phi_2963_ = _e1537;
                            phi_2986_ = type_9(0u, type_9().member_1);
                        }
                        let _e1549 = phi_2963_;
                        let _e1551 = phi_2986_;
                        if (bitcast<i32>(_e1551.member) != 0i) {
                            let _e1557 = (_e73 + (_e1551.member_1 * 128u));
                            if (_e1557 >= _e1535) {
                                phi_4836_ = false;
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
                                    phi_3191_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1614.member.x - _e1586.member.x), (_e1614.member.y - _e1586.member.y), (_e1614.member.z - _e1586.member.z)), array<f32, 3>((_e1614.member_1.x - _e1586.member_1.x), (_e1614.member_1.y - _e1586.member_1.y), (_e1614.member_1.z - _e1586.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1600.member.x - _e1586.member.x), (_e1600.member.y - _e1586.member.y), (_e1600.member.z - _e1586.member.z)), array<f32, 3>((_e1600.member_1.x - _e1586.member_1.x), (_e1600.member_1.y - _e1586.member_1.y), (_e1600.member_1.z - _e1586.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1614.member.x - _e1628.member.x), (_e1614.member.y - _e1628.member.y), (_e1614.member.z - _e1628.member.z)), array<f32, 3>((_e1614.member_1.x - _e1628.member_1.x), (_e1614.member_1.y - _e1628.member_1.y), (_e1614.member_1.z - _e1628.member_1.z))), (_e91.member_4 + _e91.member_4));
                                } else {
                                    phi_3191_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1586.member.x - _e1600.member.x), (_e1586.member.y - _e1600.member.y), (_e1586.member.z - _e1600.member.z)), array<f32, 3>((_e1586.member_1.x - _e1600.member_1.x), (_e1586.member_1.y - _e1600.member_1.y), (_e1586.member_1.z - _e1600.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1614.member.x - _e1600.member.x), (_e1614.member.y - _e1600.member.y), (_e1614.member.z - _e1600.member.z)), array<f32, 3>((_e1614.member_1.x - _e1600.member_1.x), (_e1614.member_1.y - _e1600.member_1.y), (_e1614.member_1.z - _e1600.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1628.member.x - _e1600.member.x), (_e1628.member.y - _e1600.member.y), (_e1628.member.z - _e1600.member.z)), array<f32, 3>((_e1628.member_1.x - _e1600.member_1.x), (_e1628.member_1.y - _e1600.member_1.y), (_e1628.member_1.z - _e1600.member_1.z))), (_e91.member_4 + _e91.member_4));
                                }
                                let _e1700 = phi_3191_;
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
                                    phi_3471_ = -(_e1896[0]);
                                } else {
                                    phi_3471_ = _e1896[0];
                                }
                                let _e1903 = phi_3471_;
                                if (_e1896[1] < 0f) {
                                    phi_3478_ = -(_e1896[1]);
                                } else {
                                    phi_3478_ = _e1896[1];
                                }
                                let _e1907 = phi_3478_;
                                if (_e1903 > _e1907) {
                                    phi_3483_ = _e1903;
                                } else {
                                    phi_3483_ = _e1907;
                                }
                                let _e1910 = phi_3483_;
                                if (_e1896[2] < 0f) {
                                    phi_3490_ = -(_e1896[2]);
                                } else {
                                    phi_3490_ = _e1896[2];
                                }
                                let _e1914 = phi_3490_;
                                if (_e1910 > _e1914) {
                                    phi_3495_ = _e1910;
                                } else {
                                    phi_3495_ = _e1914;
                                }
                                let _e1917 = phi_3495_;
                                let _e1920 = local_2.member[1u];
                                if (_e1920[0] < 0f) {
                                    phi_3508_ = -(_e1920[0]);
                                } else {
                                    phi_3508_ = _e1920[0];
                                }
                                let _e1927 = phi_3508_;
                                if (_e1920[1] < 0f) {
                                    phi_3515_ = -(_e1920[1]);
                                } else {
                                    phi_3515_ = _e1920[1];
                                }
                                let _e1931 = phi_3515_;
                                if (_e1927 > _e1931) {
                                    phi_3520_ = _e1927;
                                } else {
                                    phi_3520_ = _e1931;
                                }
                                let _e1934 = phi_3520_;
                                if (_e1920[2] < 0f) {
                                    phi_3527_ = -(_e1920[2]);
                                } else {
                                    phi_3527_ = _e1920[2];
                                }
                                let _e1938 = phi_3527_;
                                if (_e1934 > _e1938) {
                                    phi_3532_ = _e1934;
                                } else {
                                    phi_3532_ = _e1938;
                                }
                                let _e1941 = phi_3532_;
                                if (_e1917 > _e1941) {
                                    phi_3537_ = _e1917;
                                } else {
                                    phi_3537_ = _e1941;
                                }
                                let _e1944 = phi_3537_;
                                let _e1946 = local_2.member_3;
                                let _e1947 = (_e1944 + _e1946);
                                let _e1950 = local_2.member_1[0u];
                                if (_e1950[0] < 0f) {
                                    phi_3554_ = -(_e1950[0]);
                                } else {
                                    phi_3554_ = _e1950[0];
                                }
                                let _e1957 = phi_3554_;
                                if (_e1950[1] < 0f) {
                                    phi_3561_ = -(_e1950[1]);
                                } else {
                                    phi_3561_ = _e1950[1];
                                }
                                let _e1961 = phi_3561_;
                                if (_e1957 > _e1961) {
                                    phi_3566_ = _e1957;
                                } else {
                                    phi_3566_ = _e1961;
                                }
                                let _e1964 = phi_3566_;
                                if (_e1950[2] < 0f) {
                                    phi_3573_ = -(_e1950[2]);
                                } else {
                                    phi_3573_ = _e1950[2];
                                }
                                let _e1968 = phi_3573_;
                                if (_e1964 > _e1968) {
                                    phi_3578_ = _e1964;
                                } else {
                                    phi_3578_ = _e1968;
                                }
                                let _e1971 = phi_3578_;
                                let _e1974 = local_2.member_1[1u];
                                if (_e1974[0] < 0f) {
                                    phi_3592_ = -(_e1974[0]);
                                } else {
                                    phi_3592_ = _e1974[0];
                                }
                                let _e1981 = phi_3592_;
                                if (_e1974[1] < 0f) {
                                    phi_3599_ = -(_e1974[1]);
                                } else {
                                    phi_3599_ = _e1974[1];
                                }
                                let _e1985 = phi_3599_;
                                if (_e1981 > _e1985) {
                                    phi_3604_ = _e1981;
                                } else {
                                    phi_3604_ = _e1985;
                                }
                                let _e1988 = phi_3604_;
                                if (_e1974[2] < 0f) {
                                    phi_3611_ = -(_e1974[2]);
                                } else {
                                    phi_3611_ = _e1974[2];
                                }
                                let _e1992 = phi_3611_;
                                if (_e1988 > _e1992) {
                                    phi_3616_ = _e1988;
                                } else {
                                    phi_3616_ = _e1992;
                                }
                                let _e1995 = phi_3616_;
                                if (_e1971 > _e1995) {
                                    phi_3621_ = _e1971;
                                } else {
                                    phi_3621_ = _e1995;
                                }
                                let _e1998 = phi_3621_;
                                let _e2000 = local_2.member_3;
                                let _e2001 = (_e1998 + _e2000);
                                let _e2004 = local_2.member_2[0u];
                                if (_e2004[0] < 0f) {
                                    phi_3638_ = -(_e2004[0]);
                                } else {
                                    phi_3638_ = _e2004[0];
                                }
                                let _e2011 = phi_3638_;
                                if (_e2004[1] < 0f) {
                                    phi_3645_ = -(_e2004[1]);
                                } else {
                                    phi_3645_ = _e2004[1];
                                }
                                let _e2015 = phi_3645_;
                                if (_e2011 > _e2015) {
                                    phi_3650_ = _e2011;
                                } else {
                                    phi_3650_ = _e2015;
                                }
                                let _e2018 = phi_3650_;
                                if (_e2004[2] < 0f) {
                                    phi_3657_ = -(_e2004[2]);
                                } else {
                                    phi_3657_ = _e2004[2];
                                }
                                let _e2022 = phi_3657_;
                                if (_e2018 > _e2022) {
                                    phi_3662_ = _e2018;
                                } else {
                                    phi_3662_ = _e2022;
                                }
                                let _e2025 = phi_3662_;
                                let _e2028 = local_2.member_2[1u];
                                if (_e2028[0] < 0f) {
                                    phi_3676_ = -(_e2028[0]);
                                } else {
                                    phi_3676_ = _e2028[0];
                                }
                                let _e2035 = phi_3676_;
                                if (_e2028[1] < 0f) {
                                    phi_3683_ = -(_e2028[1]);
                                } else {
                                    phi_3683_ = _e2028[1];
                                }
                                let _e2039 = phi_3683_;
                                if (_e2035 > _e2039) {
                                    phi_3688_ = _e2035;
                                } else {
                                    phi_3688_ = _e2039;
                                }
                                let _e2042 = phi_3688_;
                                if (_e2028[2] < 0f) {
                                    phi_3695_ = -(_e2028[2]);
                                } else {
                                    phi_3695_ = _e2028[2];
                                }
                                let _e2046 = phi_3695_;
                                if (_e2042 > _e2046) {
                                    phi_3700_ = _e2042;
                                } else {
                                    phi_3700_ = _e2046;
                                }
                                let _e2049 = phi_3700_;
                                if (_e2025 > _e2049) {
                                    phi_3705_ = _e2025;
                                } else {
                                    phi_3705_ = _e2049;
                                }
                                let _e2052 = phi_3705_;
                                let _e2054 = local_2.member_3;
                                let _e2055 = (_e2052 + _e2054);
                                let _e2057 = ((_e2001 * 8f) * _e2055);
                                let _e2064 = local_2.member_3;
                                if (_e1753 < 0f) {
                                    phi_3736_ = -(_e1753);
                                } else {
                                    phi_3736_ = _e1753;
                                }
                                let _e2081 = phi_3736_;
                                if (_e1756 < 0f) {
                                    phi_3742_ = -(_e1756);
                                } else {
                                    phi_3742_ = _e1756;
                                }
                                let _e2085 = phi_3742_;
                                if (_e1759 < 0f) {
                                    phi_3749_ = -(_e1759);
                                } else {
                                    phi_3749_ = _e1759;
                                }
                                let _e2090 = phi_3749_;
                                let _e2091 = ((_e2081 + _e2085) + _e2090);
                                if (_e1774 < 0f) {
                                    phi_3756_ = -(_e1774);
                                } else {
                                    phi_3756_ = _e1774;
                                }
                                let _e2095 = phi_3756_;
                                if (_e1777 < 0f) {
                                    phi_3762_ = -(_e1777);
                                } else {
                                    phi_3762_ = _e1777;
                                }
                                let _e2099 = phi_3762_;
                                if (_e1780 < 0f) {
                                    phi_3769_ = -(_e1780);
                                } else {
                                    phi_3769_ = _e1780;
                                }
                                let _e2104 = phi_3769_;
                                let _e2105 = ((_e2095 + _e2099) + _e2104);
                                if (_e2091 > _e2105) {
                                    phi_3775_ = _e2091;
                                } else {
                                    phi_3775_ = _e2105;
                                }
                                let _e2108 = phi_3775_;
                                if (_e1823 < 0f) {
                                    phi_3781_ = -(_e1823);
                                } else {
                                    phi_3781_ = _e1823;
                                }
                                let _e2112 = phi_3781_;
                                if (_e1824 < 0f) {
                                    phi_3787_ = -(_e1824);
                                } else {
                                    phi_3787_ = _e1824;
                                }
                                let _e2116 = phi_3787_;
                                if (_e1825 < 0f) {
                                    phi_3794_ = -(_e1825);
                                } else {
                                    phi_3794_ = _e1825;
                                }
                                let _e2121 = phi_3794_;
                                let _e2123 = (((_e2112 + _e2116) + _e2121) * 0.5f);
                                if (_e2108 > _e2123) {
                                    phi_3801_ = _e2108;
                                } else {
                                    phi_3801_ = _e2123;
                                }
                                let _e2126 = phi_3801_;
                                let _e2131 = local_2.member_3;
                                let _e2144 = ((((_e1828[0] * _e1753) + (_e1828[1] * _e1756)) + (_e1828[2] * _e1759)) * 3f);
                                let _e2145 = ((((_e1885[0] * _e1774) + (_e1885[1] * _e1777)) + (_e1885[2] * _e1780)) * 3f);
                                if (_e2144 < _e2145) {
                                    phi_3825_ = _e2144;
                                } else {
                                    phi_3825_ = _e2145;
                                }
                                let _e2148 = phi_3825_;
                                if (_e1859 < _e1882) {
                                    phi_3830_ = _e1859;
                                } else {
                                    phi_3830_ = _e1882;
                                }
                                let _e2151 = phi_3830_;
                                if (_e2148 < _e2151) {
                                    phi_3835_ = _e2148;
                                } else {
                                    phi_3835_ = _e2151;
                                }
                                let _e2154 = phi_3835_;
                                if (_e2144 > _e2145) {
                                    phi_3840_ = _e2144;
                                } else {
                                    phi_3840_ = _e2145;
                                }
                                let _e2157 = phi_3840_;
                                if (_e1859 > _e1882) {
                                    phi_3845_ = _e1859;
                                } else {
                                    phi_3845_ = _e1882;
                                }
                                let _e2160 = phi_3845_;
                                if (_e2157 > _e2160) {
                                    phi_3850_ = _e2157;
                                } else {
                                    phi_3850_ = _e2160;
                                }
                                let _e2163 = phi_3850_;
                                let _e2168 = -(_e2163);
                                if (_e2154 > _e2168) {
                                    phi_3860_ = _e2154;
                                } else {
                                    phi_3860_ = _e2168;
                                }
                                let _e2171 = phi_3860_;
                                let _e2173 = ((_e2171 - ((((((_e1947 * 8f) * _e2057) * (0.000000059604645f * (524f / 64f))) + ((_e2064 * 19f) * ((_e1947 * (_e2001 + _e2055)) + (_e2001 * _e2055)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1947) * ((1f + _e2001) * (1f + _e2055))))) + ((_e91.member_5 * (((_e2126 + (_e2057 * (0.000000059604645f * 8f))) + ((_e2131 * 6f) * (_e2001 + _e2055))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2001) * (1f + _e2055))))) * (3f * 1.0001f)))) > 0f);
                                if _e2173 {
                                    phi_4829_ = _e2173;
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
                                        phi_3976_ = array<f32, 3>(_e2215[0], _e2215[1], _e2215[2]);
                                    } else {
                                        phi_3976_ = array<f32, 3>((_e2232 - _e2228[0]), (_e2233 - _e2228[1]), (_e2234 - _e2228[2]));
                                    }
                                    let _e2240 = phi_3976_;
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
                                        phi_4041_ = array<f32, 3>(_e2246[0], _e2246[1], _e2246[2]);
                                    } else {
                                        phi_4041_ = array<f32, 3>((_e2263 - _e2259[0]), (_e2264 - _e2259[1]), (_e2265 - _e2259[2]));
                                    }
                                    let _e2271 = phi_4041_;
                                    let _e2272 = (_e2246[0] - _e2259[0]);
                                    let _e2273 = (_e2246[1] - _e2259[1]);
                                    let _e2274 = (_e2246[2] - _e2259[2]);
                                    let _e2277 = local_2.member[0u];
                                    if (_e2277[0] < 0f) {
                                        phi_4063_ = -(_e2277[0]);
                                    } else {
                                        phi_4063_ = _e2277[0];
                                    }
                                    let _e2284 = phi_4063_;
                                    if (_e2277[1] < 0f) {
                                        phi_4070_ = -(_e2277[1]);
                                    } else {
                                        phi_4070_ = _e2277[1];
                                    }
                                    let _e2288 = phi_4070_;
                                    if (_e2284 > _e2288) {
                                        phi_4075_ = _e2284;
                                    } else {
                                        phi_4075_ = _e2288;
                                    }
                                    let _e2291 = phi_4075_;
                                    if (_e2277[2] < 0f) {
                                        phi_4082_ = -(_e2277[2]);
                                    } else {
                                        phi_4082_ = _e2277[2];
                                    }
                                    let _e2295 = phi_4082_;
                                    if (_e2291 > _e2295) {
                                        phi_4087_ = _e2291;
                                    } else {
                                        phi_4087_ = _e2295;
                                    }
                                    let _e2298 = phi_4087_;
                                    let _e2301 = local_2.member[1u];
                                    if (_e2301[0] < 0f) {
                                        phi_4100_ = -(_e2301[0]);
                                    } else {
                                        phi_4100_ = _e2301[0];
                                    }
                                    let _e2308 = phi_4100_;
                                    if (_e2301[1] < 0f) {
                                        phi_4107_ = -(_e2301[1]);
                                    } else {
                                        phi_4107_ = _e2301[1];
                                    }
                                    let _e2312 = phi_4107_;
                                    if (_e2308 > _e2312) {
                                        phi_4112_ = _e2308;
                                    } else {
                                        phi_4112_ = _e2312;
                                    }
                                    let _e2315 = phi_4112_;
                                    if (_e2301[2] < 0f) {
                                        phi_4119_ = -(_e2301[2]);
                                    } else {
                                        phi_4119_ = _e2301[2];
                                    }
                                    let _e2319 = phi_4119_;
                                    if (_e2315 > _e2319) {
                                        phi_4124_ = _e2315;
                                    } else {
                                        phi_4124_ = _e2319;
                                    }
                                    let _e2322 = phi_4124_;
                                    if (_e2298 > _e2322) {
                                        phi_4129_ = _e2298;
                                    } else {
                                        phi_4129_ = _e2322;
                                    }
                                    let _e2325 = phi_4129_;
                                    let _e2327 = local_2.member_3;
                                    let _e2331 = local_2.member_1[0u];
                                    if (_e2331[0] < 0f) {
                                        phi_4146_ = -(_e2331[0]);
                                    } else {
                                        phi_4146_ = _e2331[0];
                                    }
                                    let _e2338 = phi_4146_;
                                    if (_e2331[1] < 0f) {
                                        phi_4153_ = -(_e2331[1]);
                                    } else {
                                        phi_4153_ = _e2331[1];
                                    }
                                    let _e2342 = phi_4153_;
                                    if (_e2338 > _e2342) {
                                        phi_4158_ = _e2338;
                                    } else {
                                        phi_4158_ = _e2342;
                                    }
                                    let _e2345 = phi_4158_;
                                    if (_e2331[2] < 0f) {
                                        phi_4165_ = -(_e2331[2]);
                                    } else {
                                        phi_4165_ = _e2331[2];
                                    }
                                    let _e2349 = phi_4165_;
                                    if (_e2345 > _e2349) {
                                        phi_4170_ = _e2345;
                                    } else {
                                        phi_4170_ = _e2349;
                                    }
                                    let _e2352 = phi_4170_;
                                    let _e2355 = local_2.member_1[1u];
                                    if (_e2355[0] < 0f) {
                                        phi_4184_ = -(_e2355[0]);
                                    } else {
                                        phi_4184_ = _e2355[0];
                                    }
                                    let _e2362 = phi_4184_;
                                    if (_e2355[1] < 0f) {
                                        phi_4191_ = -(_e2355[1]);
                                    } else {
                                        phi_4191_ = _e2355[1];
                                    }
                                    let _e2366 = phi_4191_;
                                    if (_e2362 > _e2366) {
                                        phi_4196_ = _e2362;
                                    } else {
                                        phi_4196_ = _e2366;
                                    }
                                    let _e2369 = phi_4196_;
                                    if (_e2355[2] < 0f) {
                                        phi_4203_ = -(_e2355[2]);
                                    } else {
                                        phi_4203_ = _e2355[2];
                                    }
                                    let _e2373 = phi_4203_;
                                    if (_e2369 > _e2373) {
                                        phi_4208_ = _e2369;
                                    } else {
                                        phi_4208_ = _e2373;
                                    }
                                    let _e2376 = phi_4208_;
                                    if (_e2352 > _e2376) {
                                        phi_4213_ = _e2352;
                                    } else {
                                        phi_4213_ = _e2376;
                                    }
                                    let _e2379 = phi_4213_;
                                    let _e2381 = local_2.member_3;
                                    let _e2385 = local_2.member_2[0u];
                                    if (_e2385[0] < 0f) {
                                        phi_4230_ = -(_e2385[0]);
                                    } else {
                                        phi_4230_ = _e2385[0];
                                    }
                                    let _e2392 = phi_4230_;
                                    if (_e2385[1] < 0f) {
                                        phi_4237_ = -(_e2385[1]);
                                    } else {
                                        phi_4237_ = _e2385[1];
                                    }
                                    let _e2396 = phi_4237_;
                                    if (_e2392 > _e2396) {
                                        phi_4242_ = _e2392;
                                    } else {
                                        phi_4242_ = _e2396;
                                    }
                                    let _e2399 = phi_4242_;
                                    if (_e2385[2] < 0f) {
                                        phi_4249_ = -(_e2385[2]);
                                    } else {
                                        phi_4249_ = _e2385[2];
                                    }
                                    let _e2403 = phi_4249_;
                                    if (_e2399 > _e2403) {
                                        phi_4254_ = _e2399;
                                    } else {
                                        phi_4254_ = _e2403;
                                    }
                                    let _e2406 = phi_4254_;
                                    let _e2409 = local_2.member_2[1u];
                                    if (_e2409[0] < 0f) {
                                        phi_4268_ = -(_e2409[0]);
                                    } else {
                                        phi_4268_ = _e2409[0];
                                    }
                                    let _e2416 = phi_4268_;
                                    if (_e2409[1] < 0f) {
                                        phi_4275_ = -(_e2409[1]);
                                    } else {
                                        phi_4275_ = _e2409[1];
                                    }
                                    let _e2420 = phi_4275_;
                                    if (_e2416 > _e2420) {
                                        phi_4280_ = _e2416;
                                    } else {
                                        phi_4280_ = _e2420;
                                    }
                                    let _e2423 = phi_4280_;
                                    if (_e2409[2] < 0f) {
                                        phi_4287_ = -(_e2409[2]);
                                    } else {
                                        phi_4287_ = _e2409[2];
                                    }
                                    let _e2427 = phi_4287_;
                                    if (_e2423 > _e2427) {
                                        phi_4292_ = _e2423;
                                    } else {
                                        phi_4292_ = _e2427;
                                    }
                                    let _e2430 = phi_4292_;
                                    if (_e2406 > _e2430) {
                                        phi_4297_ = _e2406;
                                    } else {
                                        phi_4297_ = _e2430;
                                    }
                                    let _e2433 = phi_4297_;
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
                                        phi_4376_ = _e2460;
                                    } else {
                                        phi_4376_ = _e2465;
                                    }
                                    let _e2504 = phi_4376_;
                                    if (_e2470 < _e2478) {
                                        phi_4381_ = _e2470;
                                    } else {
                                        phi_4381_ = _e2478;
                                    }
                                    let _e2507 = phi_4381_;
                                    if (_e2504 < _e2507) {
                                        phi_4386_ = _e2504;
                                    } else {
                                        phi_4386_ = _e2507;
                                    }
                                    let _e2510 = phi_4386_;
                                    if (_e2483 < _e2488) {
                                        phi_4391_ = _e2483;
                                    } else {
                                        phi_4391_ = _e2488;
                                    }
                                    let _e2513 = phi_4391_;
                                    if (_e2493 < _e2501) {
                                        phi_4396_ = _e2493;
                                    } else {
                                        phi_4396_ = _e2501;
                                    }
                                    let _e2516 = phi_4396_;
                                    if (_e2513 < _e2516) {
                                        phi_4401_ = _e2513;
                                    } else {
                                        phi_4401_ = _e2516;
                                    }
                                    let _e2519 = phi_4401_;
                                    if (_e2510 < _e2519) {
                                        phi_4406_ = _e2510;
                                    } else {
                                        phi_4406_ = _e2519;
                                    }
                                    let _e2522 = phi_4406_;
                                    if (_e2460 > _e2465) {
                                        phi_4411_ = _e2460;
                                    } else {
                                        phi_4411_ = _e2465;
                                    }
                                    let _e2525 = phi_4411_;
                                    if (_e2470 > _e2478) {
                                        phi_4416_ = _e2470;
                                    } else {
                                        phi_4416_ = _e2478;
                                    }
                                    let _e2528 = phi_4416_;
                                    if (_e2525 > _e2528) {
                                        phi_4421_ = _e2525;
                                    } else {
                                        phi_4421_ = _e2528;
                                    }
                                    let _e2531 = phi_4421_;
                                    if (_e2483 > _e2488) {
                                        phi_4426_ = _e2483;
                                    } else {
                                        phi_4426_ = _e2488;
                                    }
                                    let _e2534 = phi_4426_;
                                    if (_e2493 > _e2501) {
                                        phi_4431_ = _e2493;
                                    } else {
                                        phi_4431_ = _e2501;
                                    }
                                    let _e2537 = phi_4431_;
                                    if (_e2534 > _e2537) {
                                        phi_4436_ = _e2534;
                                    } else {
                                        phi_4436_ = _e2537;
                                    }
                                    let _e2540 = phi_4436_;
                                    if (_e2531 > _e2540) {
                                        phi_4441_ = _e2531;
                                    } else {
                                        phi_4441_ = _e2540;
                                    }
                                    let _e2543 = phi_4441_;
                                    if (_e2449 < 0f) {
                                        phi_4447_ = -(_e2449);
                                    } else {
                                        phi_4447_ = _e2449;
                                    }
                                    let _e2547 = phi_4447_;
                                    if (_e2452 < 0f) {
                                        phi_4453_ = -(_e2452);
                                    } else {
                                        phi_4453_ = _e2452;
                                    }
                                    let _e2551 = phi_4453_;
                                    if (_e2455 < 0f) {
                                        phi_4460_ = -(_e2455);
                                    } else {
                                        phi_4460_ = _e2455;
                                    }
                                    let _e2556 = phi_4460_;
                                    let _e2557 = ((_e2547 + _e2551) + _e2556);
                                    let _e2562 = -(_e2543);
                                    if (_e2522 > _e2562) {
                                        phi_4471_ = _e2522;
                                    } else {
                                        phi_4471_ = _e2562;
                                    }
                                    let _e2565 = phi_4471_;
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
                                        phi_4542_ = _e2584;
                                    } else {
                                        phi_4542_ = _e2589;
                                    }
                                    let _e2628 = phi_4542_;
                                    if (_e2594 < _e2602) {
                                        phi_4547_ = _e2594;
                                    } else {
                                        phi_4547_ = _e2602;
                                    }
                                    let _e2631 = phi_4547_;
                                    if (_e2628 < _e2631) {
                                        phi_4552_ = _e2628;
                                    } else {
                                        phi_4552_ = _e2631;
                                    }
                                    let _e2634 = phi_4552_;
                                    if (_e2607 < _e2612) {
                                        phi_4557_ = _e2607;
                                    } else {
                                        phi_4557_ = _e2612;
                                    }
                                    let _e2637 = phi_4557_;
                                    if (_e2617 < _e2625) {
                                        phi_4562_ = _e2617;
                                    } else {
                                        phi_4562_ = _e2625;
                                    }
                                    let _e2640 = phi_4562_;
                                    if (_e2637 < _e2640) {
                                        phi_4567_ = _e2637;
                                    } else {
                                        phi_4567_ = _e2640;
                                    }
                                    let _e2643 = phi_4567_;
                                    if (_e2634 < _e2643) {
                                        phi_4572_ = _e2634;
                                    } else {
                                        phi_4572_ = _e2643;
                                    }
                                    let _e2646 = phi_4572_;
                                    if (_e2584 > _e2589) {
                                        phi_4577_ = _e2584;
                                    } else {
                                        phi_4577_ = _e2589;
                                    }
                                    let _e2649 = phi_4577_;
                                    if (_e2594 > _e2602) {
                                        phi_4582_ = _e2594;
                                    } else {
                                        phi_4582_ = _e2602;
                                    }
                                    let _e2652 = phi_4582_;
                                    if (_e2649 > _e2652) {
                                        phi_4587_ = _e2649;
                                    } else {
                                        phi_4587_ = _e2652;
                                    }
                                    let _e2655 = phi_4587_;
                                    if (_e2607 > _e2612) {
                                        phi_4592_ = _e2607;
                                    } else {
                                        phi_4592_ = _e2612;
                                    }
                                    let _e2658 = phi_4592_;
                                    if (_e2617 > _e2625) {
                                        phi_4597_ = _e2617;
                                    } else {
                                        phi_4597_ = _e2625;
                                    }
                                    let _e2661 = phi_4597_;
                                    if (_e2658 > _e2661) {
                                        phi_4602_ = _e2658;
                                    } else {
                                        phi_4602_ = _e2661;
                                    }
                                    let _e2664 = phi_4602_;
                                    if (_e2655 > _e2664) {
                                        phi_4607_ = _e2655;
                                    } else {
                                        phi_4607_ = _e2664;
                                    }
                                    let _e2667 = phi_4607_;
                                    if (_e2573 < 0f) {
                                        phi_4613_ = -(_e2573);
                                    } else {
                                        phi_4613_ = _e2573;
                                    }
                                    let _e2671 = phi_4613_;
                                    if (_e2576 < 0f) {
                                        phi_4619_ = -(_e2576);
                                    } else {
                                        phi_4619_ = _e2576;
                                    }
                                    let _e2675 = phi_4619_;
                                    if (_e2579 < 0f) {
                                        phi_4626_ = -(_e2579);
                                    } else {
                                        phi_4626_ = _e2579;
                                    }
                                    let _e2680 = phi_4626_;
                                    let _e2681 = ((_e2671 + _e2675) + _e2680);
                                    let _e2686 = -(_e2667);
                                    if (_e2646 > _e2686) {
                                        phi_4637_ = _e2646;
                                    } else {
                                        phi_4637_ = _e2686;
                                    }
                                    let _e2689 = phi_4637_;
                                    let _e2694 = (((_e2689 - ((_e2681 * _e2439) * (0.000000059604645f * (17f / 2f)))) - (_e2681 * _e2446)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e2570 > _e2694) {
                                        phi_4647_ = _e2570;
                                    } else {
                                        phi_4647_ = _e2694;
                                    }
                                    let _e2697 = phi_4647_;
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
                                            phi_4720_ = _e2714;
                                        } else {
                                            phi_4720_ = _e2719;
                                        }
                                        let _e2758 = phi_4720_;
                                        if (_e2724 < _e2732) {
                                            phi_4725_ = _e2724;
                                        } else {
                                            phi_4725_ = _e2732;
                                        }
                                        let _e2761 = phi_4725_;
                                        if (_e2758 < _e2761) {
                                            phi_4730_ = _e2758;
                                        } else {
                                            phi_4730_ = _e2761;
                                        }
                                        let _e2764 = phi_4730_;
                                        if (_e2737 < _e2742) {
                                            phi_4735_ = _e2737;
                                        } else {
                                            phi_4735_ = _e2742;
                                        }
                                        let _e2767 = phi_4735_;
                                        if (_e2747 < _e2755) {
                                            phi_4740_ = _e2747;
                                        } else {
                                            phi_4740_ = _e2755;
                                        }
                                        let _e2770 = phi_4740_;
                                        if (_e2767 < _e2770) {
                                            phi_4745_ = _e2767;
                                        } else {
                                            phi_4745_ = _e2770;
                                        }
                                        let _e2773 = phi_4745_;
                                        if (_e2764 < _e2773) {
                                            phi_4750_ = _e2764;
                                        } else {
                                            phi_4750_ = _e2773;
                                        }
                                        let _e2776 = phi_4750_;
                                        if (_e2714 > _e2719) {
                                            phi_4755_ = _e2714;
                                        } else {
                                            phi_4755_ = _e2719;
                                        }
                                        let _e2779 = phi_4755_;
                                        if (_e2724 > _e2732) {
                                            phi_4760_ = _e2724;
                                        } else {
                                            phi_4760_ = _e2732;
                                        }
                                        let _e2782 = phi_4760_;
                                        if (_e2779 > _e2782) {
                                            phi_4765_ = _e2779;
                                        } else {
                                            phi_4765_ = _e2782;
                                        }
                                        let _e2785 = phi_4765_;
                                        if (_e2737 > _e2742) {
                                            phi_4770_ = _e2737;
                                        } else {
                                            phi_4770_ = _e2742;
                                        }
                                        let _e2788 = phi_4770_;
                                        if (_e2747 > _e2755) {
                                            phi_4775_ = _e2747;
                                        } else {
                                            phi_4775_ = _e2755;
                                        }
                                        let _e2791 = phi_4775_;
                                        if (_e2788 > _e2791) {
                                            phi_4780_ = _e2788;
                                        } else {
                                            phi_4780_ = _e2791;
                                        }
                                        let _e2794 = phi_4780_;
                                        if (_e2785 > _e2794) {
                                            phi_4785_ = _e2785;
                                        } else {
                                            phi_4785_ = _e2794;
                                        }
                                        let _e2797 = phi_4785_;
                                        if (_e2703 < 0f) {
                                            phi_4791_ = -(_e2703);
                                        } else {
                                            phi_4791_ = _e2703;
                                        }
                                        let _e2801 = phi_4791_;
                                        if (_e2706 < 0f) {
                                            phi_4797_ = -(_e2706);
                                        } else {
                                            phi_4797_ = _e2706;
                                        }
                                        let _e2805 = phi_4797_;
                                        if (_e2709 < 0f) {
                                            phi_4804_ = -(_e2709);
                                        } else {
                                            phi_4804_ = _e2709;
                                        }
                                        let _e2810 = phi_4804_;
                                        let _e2811 = ((_e2801 + _e2805) + _e2810);
                                        let _e2816 = -(_e2797);
                                        if (_e2776 > _e2816) {
                                            phi_4815_ = _e2776;
                                        } else {
                                            phi_4815_ = _e2816;
                                        }
                                        let _e2819 = phi_4815_;
                                        let _e2824 = (((_e2819 - ((_e2811 * _e2439) * (0.000000059604645f * (17f / 2f)))) - (_e2811 * _e2446)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e2697 > _e2824) {
                                            phi_4825_ = _e2697;
                                        } else {
                                            phi_4825_ = _e2824;
                                        }
                                        let _e2827 = phi_4825_;
                                        phi_4826_ = _e2827;
                                    } else {
                                        phi_4826_ = _e2697;
                                    }
                                    let _e2829 = phi_4826_;
                                    phi_4829_ = (_e2173 || (_e2829 > 0f));
                                }
                                let _e2833 = phi_4829_;
                                if _e2833 {
                                } else {
                                    let _e2835 = atomicAdd((&counters[6u]), 1u);
                                    hits[_e2835] = _e1560;
                                }
                                phi_4836_ = true;
                            }
                            let _e2838 = phi_4836_;
                            phi_4837_ = _e2838;
                        } else {
                            phi_4837_ = false;
                        }
                        let _e2840 = phi_4837_;
                        continue;
                        continuing {
                            phi_2962_ = _e1549;
                            break if !(_e2840);
                        }
                    }
                    workgroupBarrier();
                    let _e2843 = atomicLoad((&counters[6u]));
                    phi_4842_ = type_9(0u, 4u);
                    loop {
                        let _e2845 = phi_4842_;
                        if (_e2845.member < _e2845.member_1) {
                            phi_4843_ = type_9((_e2845.member + 1u), _e2845.member_1);
                            phi_4866_ = type_9(1u, _e2845.member);
                        } else {
                            phi_4843_ = _e2845;
                            phi_4866_ = type_9(0u, type_9().member_1);
                        }
                        let _e2857 = phi_4843_;
                        let _e2859 = phi_4866_;
                        if (bitcast<i32>(_e2859.member) != 0i) {
                            let _e2865 = (_e73 + (_e2859.member_1 * 128u));
                            if (_e2865 >= _e2843) {
                                phi_8423_ = false;
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
                                    phi_5071_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e2922.member.x - _e2894.member.x), (_e2922.member.y - _e2894.member.y), (_e2922.member.z - _e2894.member.z)), array<f32, 3>((_e2922.member_1.x - _e2894.member_1.x), (_e2922.member_1.y - _e2894.member_1.y), (_e2922.member_1.z - _e2894.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2908.member.x - _e2894.member.x), (_e2908.member.y - _e2894.member.y), (_e2908.member.z - _e2894.member.z)), array<f32, 3>((_e2908.member_1.x - _e2894.member_1.x), (_e2908.member_1.y - _e2894.member_1.y), (_e2908.member_1.z - _e2894.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2922.member.x - _e2936.member.x), (_e2922.member.y - _e2936.member.y), (_e2922.member.z - _e2936.member.z)), array<f32, 3>((_e2922.member_1.x - _e2936.member_1.x), (_e2922.member_1.y - _e2936.member_1.y), (_e2922.member_1.z - _e2936.member_1.z))), (_e91.member_4 + _e91.member_4));
                                } else {
                                    phi_5071_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e2894.member.x - _e2908.member.x), (_e2894.member.y - _e2908.member.y), (_e2894.member.z - _e2908.member.z)), array<f32, 3>((_e2894.member_1.x - _e2908.member_1.x), (_e2894.member_1.y - _e2908.member_1.y), (_e2894.member_1.z - _e2908.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2922.member.x - _e2908.member.x), (_e2922.member.y - _e2908.member.y), (_e2922.member.z - _e2908.member.z)), array<f32, 3>((_e2922.member_1.x - _e2908.member_1.x), (_e2922.member_1.y - _e2908.member_1.y), (_e2922.member_1.z - _e2908.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e2936.member.x - _e2908.member.x), (_e2936.member.y - _e2908.member.y), (_e2936.member.z - _e2908.member.z)), array<f32, 3>((_e2936.member_1.x - _e2908.member_1.x), (_e2936.member_1.y - _e2908.member_1.y), (_e2936.member_1.z - _e2908.member_1.z))), (_e91.member_4 + _e91.member_4));
                                }
                                let _e3008 = phi_5071_;
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
                                    phi_5450_ = -(_e3266[0]);
                                } else {
                                    phi_5450_ = _e3266[0];
                                }
                                let _e3273 = phi_5450_;
                                if (_e3266[1] < 0f) {
                                    phi_5457_ = -(_e3266[1]);
                                } else {
                                    phi_5457_ = _e3266[1];
                                }
                                let _e3277 = phi_5457_;
                                if (_e3273 > _e3277) {
                                    phi_5462_ = _e3273;
                                } else {
                                    phi_5462_ = _e3277;
                                }
                                let _e3280 = phi_5462_;
                                if (_e3266[2] < 0f) {
                                    phi_5469_ = -(_e3266[2]);
                                } else {
                                    phi_5469_ = _e3266[2];
                                }
                                let _e3284 = phi_5469_;
                                if (_e3280 > _e3284) {
                                    phi_5474_ = _e3280;
                                } else {
                                    phi_5474_ = _e3284;
                                }
                                let _e3287 = phi_5474_;
                                let _e3290 = local.member[1u];
                                if (_e3290[0] < 0f) {
                                    phi_5487_ = -(_e3290[0]);
                                } else {
                                    phi_5487_ = _e3290[0];
                                }
                                let _e3297 = phi_5487_;
                                if (_e3290[1] < 0f) {
                                    phi_5494_ = -(_e3290[1]);
                                } else {
                                    phi_5494_ = _e3290[1];
                                }
                                let _e3301 = phi_5494_;
                                if (_e3297 > _e3301) {
                                    phi_5499_ = _e3297;
                                } else {
                                    phi_5499_ = _e3301;
                                }
                                let _e3304 = phi_5499_;
                                if (_e3290[2] < 0f) {
                                    phi_5506_ = -(_e3290[2]);
                                } else {
                                    phi_5506_ = _e3290[2];
                                }
                                let _e3308 = phi_5506_;
                                if (_e3304 > _e3308) {
                                    phi_5511_ = _e3304;
                                } else {
                                    phi_5511_ = _e3308;
                                }
                                let _e3311 = phi_5511_;
                                if (_e3287 > _e3311) {
                                    phi_5516_ = _e3287;
                                } else {
                                    phi_5516_ = _e3311;
                                }
                                let _e3314 = phi_5516_;
                                let _e3316 = local.member_3;
                                let _e3317 = (_e3314 + _e3316);
                                let _e3320 = local.member_1[0u];
                                if (_e3320[0] < 0f) {
                                    phi_5533_ = -(_e3320[0]);
                                } else {
                                    phi_5533_ = _e3320[0];
                                }
                                let _e3327 = phi_5533_;
                                if (_e3320[1] < 0f) {
                                    phi_5540_ = -(_e3320[1]);
                                } else {
                                    phi_5540_ = _e3320[1];
                                }
                                let _e3331 = phi_5540_;
                                if (_e3327 > _e3331) {
                                    phi_5545_ = _e3327;
                                } else {
                                    phi_5545_ = _e3331;
                                }
                                let _e3334 = phi_5545_;
                                if (_e3320[2] < 0f) {
                                    phi_5552_ = -(_e3320[2]);
                                } else {
                                    phi_5552_ = _e3320[2];
                                }
                                let _e3338 = phi_5552_;
                                if (_e3334 > _e3338) {
                                    phi_5557_ = _e3334;
                                } else {
                                    phi_5557_ = _e3338;
                                }
                                let _e3341 = phi_5557_;
                                let _e3344 = local.member_1[1u];
                                if (_e3344[0] < 0f) {
                                    phi_5571_ = -(_e3344[0]);
                                } else {
                                    phi_5571_ = _e3344[0];
                                }
                                let _e3351 = phi_5571_;
                                if (_e3344[1] < 0f) {
                                    phi_5578_ = -(_e3344[1]);
                                } else {
                                    phi_5578_ = _e3344[1];
                                }
                                let _e3355 = phi_5578_;
                                if (_e3351 > _e3355) {
                                    phi_5583_ = _e3351;
                                } else {
                                    phi_5583_ = _e3355;
                                }
                                let _e3358 = phi_5583_;
                                if (_e3344[2] < 0f) {
                                    phi_5590_ = -(_e3344[2]);
                                } else {
                                    phi_5590_ = _e3344[2];
                                }
                                let _e3362 = phi_5590_;
                                if (_e3358 > _e3362) {
                                    phi_5595_ = _e3358;
                                } else {
                                    phi_5595_ = _e3362;
                                }
                                let _e3365 = phi_5595_;
                                if (_e3341 > _e3365) {
                                    phi_5600_ = _e3341;
                                } else {
                                    phi_5600_ = _e3365;
                                }
                                let _e3368 = phi_5600_;
                                let _e3370 = local.member_3;
                                let _e3371 = (_e3368 + _e3370);
                                let _e3374 = local.member_2[0u];
                                if (_e3374[0] < 0f) {
                                    phi_5617_ = -(_e3374[0]);
                                } else {
                                    phi_5617_ = _e3374[0];
                                }
                                let _e3381 = phi_5617_;
                                if (_e3374[1] < 0f) {
                                    phi_5624_ = -(_e3374[1]);
                                } else {
                                    phi_5624_ = _e3374[1];
                                }
                                let _e3385 = phi_5624_;
                                if (_e3381 > _e3385) {
                                    phi_5629_ = _e3381;
                                } else {
                                    phi_5629_ = _e3385;
                                }
                                let _e3388 = phi_5629_;
                                if (_e3374[2] < 0f) {
                                    phi_5636_ = -(_e3374[2]);
                                } else {
                                    phi_5636_ = _e3374[2];
                                }
                                let _e3392 = phi_5636_;
                                if (_e3388 > _e3392) {
                                    phi_5641_ = _e3388;
                                } else {
                                    phi_5641_ = _e3392;
                                }
                                let _e3395 = phi_5641_;
                                let _e3398 = local.member_2[1u];
                                if (_e3398[0] < 0f) {
                                    phi_5655_ = -(_e3398[0]);
                                } else {
                                    phi_5655_ = _e3398[0];
                                }
                                let _e3405 = phi_5655_;
                                if (_e3398[1] < 0f) {
                                    phi_5662_ = -(_e3398[1]);
                                } else {
                                    phi_5662_ = _e3398[1];
                                }
                                let _e3409 = phi_5662_;
                                if (_e3405 > _e3409) {
                                    phi_5667_ = _e3405;
                                } else {
                                    phi_5667_ = _e3409;
                                }
                                let _e3412 = phi_5667_;
                                if (_e3398[2] < 0f) {
                                    phi_5674_ = -(_e3398[2]);
                                } else {
                                    phi_5674_ = _e3398[2];
                                }
                                let _e3416 = phi_5674_;
                                if (_e3412 > _e3416) {
                                    phi_5679_ = _e3412;
                                } else {
                                    phi_5679_ = _e3416;
                                }
                                let _e3419 = phi_5679_;
                                if (_e3395 > _e3419) {
                                    phi_5684_ = _e3395;
                                } else {
                                    phi_5684_ = _e3419;
                                }
                                let _e3422 = phi_5684_;
                                let _e3424 = local.member_3;
                                let _e3425 = (_e3422 + _e3424);
                                let _e3427 = ((_e3371 * 8f) * _e3425);
                                let _e3434 = local.member_3;
                                if (_e3123 < 0f) {
                                    phi_5715_ = -(_e3123);
                                } else {
                                    phi_5715_ = _e3123;
                                }
                                let _e3451 = phi_5715_;
                                if (_e3126 < 0f) {
                                    phi_5721_ = -(_e3126);
                                } else {
                                    phi_5721_ = _e3126;
                                }
                                let _e3455 = phi_5721_;
                                if (_e3129 < 0f) {
                                    phi_5728_ = -(_e3129);
                                } else {
                                    phi_5728_ = _e3129;
                                }
                                let _e3460 = phi_5728_;
                                let _e3461 = ((_e3451 + _e3455) + _e3460);
                                if (_e3144 < 0f) {
                                    phi_5735_ = -(_e3144);
                                } else {
                                    phi_5735_ = _e3144;
                                }
                                let _e3465 = phi_5735_;
                                if (_e3147 < 0f) {
                                    phi_5741_ = -(_e3147);
                                } else {
                                    phi_5741_ = _e3147;
                                }
                                let _e3469 = phi_5741_;
                                if (_e3150 < 0f) {
                                    phi_5748_ = -(_e3150);
                                } else {
                                    phi_5748_ = _e3150;
                                }
                                let _e3474 = phi_5748_;
                                let _e3475 = ((_e3465 + _e3469) + _e3474);
                                if (_e3461 > _e3475) {
                                    phi_5754_ = _e3461;
                                } else {
                                    phi_5754_ = _e3475;
                                }
                                let _e3478 = phi_5754_;
                                if (_e3193 < 0f) {
                                    phi_5760_ = -(_e3193);
                                } else {
                                    phi_5760_ = _e3193;
                                }
                                let _e3482 = phi_5760_;
                                if (_e3194 < 0f) {
                                    phi_5766_ = -(_e3194);
                                } else {
                                    phi_5766_ = _e3194;
                                }
                                let _e3486 = phi_5766_;
                                if (_e3195 < 0f) {
                                    phi_5773_ = -(_e3195);
                                } else {
                                    phi_5773_ = _e3195;
                                }
                                let _e3491 = phi_5773_;
                                let _e3493 = (((_e3482 + _e3486) + _e3491) * 0.5f);
                                if (_e3478 > _e3493) {
                                    phi_5780_ = _e3478;
                                } else {
                                    phi_5780_ = _e3493;
                                }
                                let _e3496 = phi_5780_;
                                let _e3501 = local.member_3;
                                let _e3514 = ((((_e3198[0] * _e3123) + (_e3198[1] * _e3126)) + (_e3198[2] * _e3129)) * 3f);
                                let _e3515 = ((((_e3255[0] * _e3144) + (_e3255[1] * _e3147)) + (_e3255[2] * _e3150)) * 3f);
                                if (_e3514 < _e3515) {
                                    phi_5804_ = _e3514;
                                } else {
                                    phi_5804_ = _e3515;
                                }
                                let _e3518 = phi_5804_;
                                if (_e3229 < _e3252) {
                                    phi_5809_ = _e3229;
                                } else {
                                    phi_5809_ = _e3252;
                                }
                                let _e3521 = phi_5809_;
                                if (_e3518 < _e3521) {
                                    phi_5814_ = _e3518;
                                } else {
                                    phi_5814_ = _e3521;
                                }
                                let _e3524 = phi_5814_;
                                if (_e3514 > _e3515) {
                                    phi_5819_ = _e3514;
                                } else {
                                    phi_5819_ = _e3515;
                                }
                                let _e3527 = phi_5819_;
                                if (_e3229 > _e3252) {
                                    phi_5824_ = _e3229;
                                } else {
                                    phi_5824_ = _e3252;
                                }
                                let _e3530 = phi_5824_;
                                if (_e3527 > _e3530) {
                                    phi_5829_ = _e3527;
                                } else {
                                    phi_5829_ = _e3530;
                                }
                                let _e3533 = phi_5829_;
                                let _e3538 = -(_e3533);
                                if (_e3524 > _e3538) {
                                    phi_5839_ = _e3524;
                                } else {
                                    phi_5839_ = _e3538;
                                }
                                let _e3541 = phi_5839_;
                                let _e3543 = ((_e3541 - ((((((_e3317 * 8f) * _e3427) * (0.000000059604645f * (524f / 64f))) + ((_e3434 * 19f) * ((_e3317 * (_e3371 + _e3425)) + (_e3371 * _e3425)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3317) * ((1f + _e3371) * (1f + _e3425))))) + ((_e91.member_5 * (((_e3496 + (_e3427 * (0.000000059604645f * 8f))) + ((_e3501 * 6f) * (_e3371 + _e3425))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3371) * (1f + _e3425))))) * (3f * 1.0001f)))) > 0f);
                                if _e3543 {
                                    phi_6808_ = _e3543;
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
                                        phi_5955_ = array<f32, 3>(_e3585[0], _e3585[1], _e3585[2]);
                                    } else {
                                        phi_5955_ = array<f32, 3>((_e3602 - _e3598[0]), (_e3603 - _e3598[1]), (_e3604 - _e3598[2]));
                                    }
                                    let _e3610 = phi_5955_;
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
                                        phi_6020_ = array<f32, 3>(_e3616[0], _e3616[1], _e3616[2]);
                                    } else {
                                        phi_6020_ = array<f32, 3>((_e3633 - _e3629[0]), (_e3634 - _e3629[1]), (_e3635 - _e3629[2]));
                                    }
                                    let _e3641 = phi_6020_;
                                    let _e3642 = (_e3616[0] - _e3629[0]);
                                    let _e3643 = (_e3616[1] - _e3629[1]);
                                    let _e3644 = (_e3616[2] - _e3629[2]);
                                    let _e3647 = local.member[0u];
                                    if (_e3647[0] < 0f) {
                                        phi_6042_ = -(_e3647[0]);
                                    } else {
                                        phi_6042_ = _e3647[0];
                                    }
                                    let _e3654 = phi_6042_;
                                    if (_e3647[1] < 0f) {
                                        phi_6049_ = -(_e3647[1]);
                                    } else {
                                        phi_6049_ = _e3647[1];
                                    }
                                    let _e3658 = phi_6049_;
                                    if (_e3654 > _e3658) {
                                        phi_6054_ = _e3654;
                                    } else {
                                        phi_6054_ = _e3658;
                                    }
                                    let _e3661 = phi_6054_;
                                    if (_e3647[2] < 0f) {
                                        phi_6061_ = -(_e3647[2]);
                                    } else {
                                        phi_6061_ = _e3647[2];
                                    }
                                    let _e3665 = phi_6061_;
                                    if (_e3661 > _e3665) {
                                        phi_6066_ = _e3661;
                                    } else {
                                        phi_6066_ = _e3665;
                                    }
                                    let _e3668 = phi_6066_;
                                    let _e3671 = local.member[1u];
                                    if (_e3671[0] < 0f) {
                                        phi_6079_ = -(_e3671[0]);
                                    } else {
                                        phi_6079_ = _e3671[0];
                                    }
                                    let _e3678 = phi_6079_;
                                    if (_e3671[1] < 0f) {
                                        phi_6086_ = -(_e3671[1]);
                                    } else {
                                        phi_6086_ = _e3671[1];
                                    }
                                    let _e3682 = phi_6086_;
                                    if (_e3678 > _e3682) {
                                        phi_6091_ = _e3678;
                                    } else {
                                        phi_6091_ = _e3682;
                                    }
                                    let _e3685 = phi_6091_;
                                    if (_e3671[2] < 0f) {
                                        phi_6098_ = -(_e3671[2]);
                                    } else {
                                        phi_6098_ = _e3671[2];
                                    }
                                    let _e3689 = phi_6098_;
                                    if (_e3685 > _e3689) {
                                        phi_6103_ = _e3685;
                                    } else {
                                        phi_6103_ = _e3689;
                                    }
                                    let _e3692 = phi_6103_;
                                    if (_e3668 > _e3692) {
                                        phi_6108_ = _e3668;
                                    } else {
                                        phi_6108_ = _e3692;
                                    }
                                    let _e3695 = phi_6108_;
                                    let _e3697 = local.member_3;
                                    let _e3701 = local.member_1[0u];
                                    if (_e3701[0] < 0f) {
                                        phi_6125_ = -(_e3701[0]);
                                    } else {
                                        phi_6125_ = _e3701[0];
                                    }
                                    let _e3708 = phi_6125_;
                                    if (_e3701[1] < 0f) {
                                        phi_6132_ = -(_e3701[1]);
                                    } else {
                                        phi_6132_ = _e3701[1];
                                    }
                                    let _e3712 = phi_6132_;
                                    if (_e3708 > _e3712) {
                                        phi_6137_ = _e3708;
                                    } else {
                                        phi_6137_ = _e3712;
                                    }
                                    let _e3715 = phi_6137_;
                                    if (_e3701[2] < 0f) {
                                        phi_6144_ = -(_e3701[2]);
                                    } else {
                                        phi_6144_ = _e3701[2];
                                    }
                                    let _e3719 = phi_6144_;
                                    if (_e3715 > _e3719) {
                                        phi_6149_ = _e3715;
                                    } else {
                                        phi_6149_ = _e3719;
                                    }
                                    let _e3722 = phi_6149_;
                                    let _e3725 = local.member_1[1u];
                                    if (_e3725[0] < 0f) {
                                        phi_6163_ = -(_e3725[0]);
                                    } else {
                                        phi_6163_ = _e3725[0];
                                    }
                                    let _e3732 = phi_6163_;
                                    if (_e3725[1] < 0f) {
                                        phi_6170_ = -(_e3725[1]);
                                    } else {
                                        phi_6170_ = _e3725[1];
                                    }
                                    let _e3736 = phi_6170_;
                                    if (_e3732 > _e3736) {
                                        phi_6175_ = _e3732;
                                    } else {
                                        phi_6175_ = _e3736;
                                    }
                                    let _e3739 = phi_6175_;
                                    if (_e3725[2] < 0f) {
                                        phi_6182_ = -(_e3725[2]);
                                    } else {
                                        phi_6182_ = _e3725[2];
                                    }
                                    let _e3743 = phi_6182_;
                                    if (_e3739 > _e3743) {
                                        phi_6187_ = _e3739;
                                    } else {
                                        phi_6187_ = _e3743;
                                    }
                                    let _e3746 = phi_6187_;
                                    if (_e3722 > _e3746) {
                                        phi_6192_ = _e3722;
                                    } else {
                                        phi_6192_ = _e3746;
                                    }
                                    let _e3749 = phi_6192_;
                                    let _e3751 = local.member_3;
                                    let _e3755 = local.member_2[0u];
                                    if (_e3755[0] < 0f) {
                                        phi_6209_ = -(_e3755[0]);
                                    } else {
                                        phi_6209_ = _e3755[0];
                                    }
                                    let _e3762 = phi_6209_;
                                    if (_e3755[1] < 0f) {
                                        phi_6216_ = -(_e3755[1]);
                                    } else {
                                        phi_6216_ = _e3755[1];
                                    }
                                    let _e3766 = phi_6216_;
                                    if (_e3762 > _e3766) {
                                        phi_6221_ = _e3762;
                                    } else {
                                        phi_6221_ = _e3766;
                                    }
                                    let _e3769 = phi_6221_;
                                    if (_e3755[2] < 0f) {
                                        phi_6228_ = -(_e3755[2]);
                                    } else {
                                        phi_6228_ = _e3755[2];
                                    }
                                    let _e3773 = phi_6228_;
                                    if (_e3769 > _e3773) {
                                        phi_6233_ = _e3769;
                                    } else {
                                        phi_6233_ = _e3773;
                                    }
                                    let _e3776 = phi_6233_;
                                    let _e3779 = local.member_2[1u];
                                    if (_e3779[0] < 0f) {
                                        phi_6247_ = -(_e3779[0]);
                                    } else {
                                        phi_6247_ = _e3779[0];
                                    }
                                    let _e3786 = phi_6247_;
                                    if (_e3779[1] < 0f) {
                                        phi_6254_ = -(_e3779[1]);
                                    } else {
                                        phi_6254_ = _e3779[1];
                                    }
                                    let _e3790 = phi_6254_;
                                    if (_e3786 > _e3790) {
                                        phi_6259_ = _e3786;
                                    } else {
                                        phi_6259_ = _e3790;
                                    }
                                    let _e3793 = phi_6259_;
                                    if (_e3779[2] < 0f) {
                                        phi_6266_ = -(_e3779[2]);
                                    } else {
                                        phi_6266_ = _e3779[2];
                                    }
                                    let _e3797 = phi_6266_;
                                    if (_e3793 > _e3797) {
                                        phi_6271_ = _e3793;
                                    } else {
                                        phi_6271_ = _e3797;
                                    }
                                    let _e3800 = phi_6271_;
                                    if (_e3776 > _e3800) {
                                        phi_6276_ = _e3776;
                                    } else {
                                        phi_6276_ = _e3800;
                                    }
                                    let _e3803 = phi_6276_;
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
                                        phi_6355_ = _e3830;
                                    } else {
                                        phi_6355_ = _e3835;
                                    }
                                    let _e3874 = phi_6355_;
                                    if (_e3840 < _e3848) {
                                        phi_6360_ = _e3840;
                                    } else {
                                        phi_6360_ = _e3848;
                                    }
                                    let _e3877 = phi_6360_;
                                    if (_e3874 < _e3877) {
                                        phi_6365_ = _e3874;
                                    } else {
                                        phi_6365_ = _e3877;
                                    }
                                    let _e3880 = phi_6365_;
                                    if (_e3853 < _e3858) {
                                        phi_6370_ = _e3853;
                                    } else {
                                        phi_6370_ = _e3858;
                                    }
                                    let _e3883 = phi_6370_;
                                    if (_e3863 < _e3871) {
                                        phi_6375_ = _e3863;
                                    } else {
                                        phi_6375_ = _e3871;
                                    }
                                    let _e3886 = phi_6375_;
                                    if (_e3883 < _e3886) {
                                        phi_6380_ = _e3883;
                                    } else {
                                        phi_6380_ = _e3886;
                                    }
                                    let _e3889 = phi_6380_;
                                    if (_e3880 < _e3889) {
                                        phi_6385_ = _e3880;
                                    } else {
                                        phi_6385_ = _e3889;
                                    }
                                    let _e3892 = phi_6385_;
                                    if (_e3830 > _e3835) {
                                        phi_6390_ = _e3830;
                                    } else {
                                        phi_6390_ = _e3835;
                                    }
                                    let _e3895 = phi_6390_;
                                    if (_e3840 > _e3848) {
                                        phi_6395_ = _e3840;
                                    } else {
                                        phi_6395_ = _e3848;
                                    }
                                    let _e3898 = phi_6395_;
                                    if (_e3895 > _e3898) {
                                        phi_6400_ = _e3895;
                                    } else {
                                        phi_6400_ = _e3898;
                                    }
                                    let _e3901 = phi_6400_;
                                    if (_e3853 > _e3858) {
                                        phi_6405_ = _e3853;
                                    } else {
                                        phi_6405_ = _e3858;
                                    }
                                    let _e3904 = phi_6405_;
                                    if (_e3863 > _e3871) {
                                        phi_6410_ = _e3863;
                                    } else {
                                        phi_6410_ = _e3871;
                                    }
                                    let _e3907 = phi_6410_;
                                    if (_e3904 > _e3907) {
                                        phi_6415_ = _e3904;
                                    } else {
                                        phi_6415_ = _e3907;
                                    }
                                    let _e3910 = phi_6415_;
                                    if (_e3901 > _e3910) {
                                        phi_6420_ = _e3901;
                                    } else {
                                        phi_6420_ = _e3910;
                                    }
                                    let _e3913 = phi_6420_;
                                    if (_e3819 < 0f) {
                                        phi_6426_ = -(_e3819);
                                    } else {
                                        phi_6426_ = _e3819;
                                    }
                                    let _e3917 = phi_6426_;
                                    if (_e3822 < 0f) {
                                        phi_6432_ = -(_e3822);
                                    } else {
                                        phi_6432_ = _e3822;
                                    }
                                    let _e3921 = phi_6432_;
                                    if (_e3825 < 0f) {
                                        phi_6439_ = -(_e3825);
                                    } else {
                                        phi_6439_ = _e3825;
                                    }
                                    let _e3926 = phi_6439_;
                                    let _e3927 = ((_e3917 + _e3921) + _e3926);
                                    let _e3932 = -(_e3913);
                                    if (_e3892 > _e3932) {
                                        phi_6450_ = _e3892;
                                    } else {
                                        phi_6450_ = _e3932;
                                    }
                                    let _e3935 = phi_6450_;
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
                                        phi_6521_ = _e3954;
                                    } else {
                                        phi_6521_ = _e3959;
                                    }
                                    let _e3998 = phi_6521_;
                                    if (_e3964 < _e3972) {
                                        phi_6526_ = _e3964;
                                    } else {
                                        phi_6526_ = _e3972;
                                    }
                                    let _e4001 = phi_6526_;
                                    if (_e3998 < _e4001) {
                                        phi_6531_ = _e3998;
                                    } else {
                                        phi_6531_ = _e4001;
                                    }
                                    let _e4004 = phi_6531_;
                                    if (_e3977 < _e3982) {
                                        phi_6536_ = _e3977;
                                    } else {
                                        phi_6536_ = _e3982;
                                    }
                                    let _e4007 = phi_6536_;
                                    if (_e3987 < _e3995) {
                                        phi_6541_ = _e3987;
                                    } else {
                                        phi_6541_ = _e3995;
                                    }
                                    let _e4010 = phi_6541_;
                                    if (_e4007 < _e4010) {
                                        phi_6546_ = _e4007;
                                    } else {
                                        phi_6546_ = _e4010;
                                    }
                                    let _e4013 = phi_6546_;
                                    if (_e4004 < _e4013) {
                                        phi_6551_ = _e4004;
                                    } else {
                                        phi_6551_ = _e4013;
                                    }
                                    let _e4016 = phi_6551_;
                                    if (_e3954 > _e3959) {
                                        phi_6556_ = _e3954;
                                    } else {
                                        phi_6556_ = _e3959;
                                    }
                                    let _e4019 = phi_6556_;
                                    if (_e3964 > _e3972) {
                                        phi_6561_ = _e3964;
                                    } else {
                                        phi_6561_ = _e3972;
                                    }
                                    let _e4022 = phi_6561_;
                                    if (_e4019 > _e4022) {
                                        phi_6566_ = _e4019;
                                    } else {
                                        phi_6566_ = _e4022;
                                    }
                                    let _e4025 = phi_6566_;
                                    if (_e3977 > _e3982) {
                                        phi_6571_ = _e3977;
                                    } else {
                                        phi_6571_ = _e3982;
                                    }
                                    let _e4028 = phi_6571_;
                                    if (_e3987 > _e3995) {
                                        phi_6576_ = _e3987;
                                    } else {
                                        phi_6576_ = _e3995;
                                    }
                                    let _e4031 = phi_6576_;
                                    if (_e4028 > _e4031) {
                                        phi_6581_ = _e4028;
                                    } else {
                                        phi_6581_ = _e4031;
                                    }
                                    let _e4034 = phi_6581_;
                                    if (_e4025 > _e4034) {
                                        phi_6586_ = _e4025;
                                    } else {
                                        phi_6586_ = _e4034;
                                    }
                                    let _e4037 = phi_6586_;
                                    if (_e3943 < 0f) {
                                        phi_6592_ = -(_e3943);
                                    } else {
                                        phi_6592_ = _e3943;
                                    }
                                    let _e4041 = phi_6592_;
                                    if (_e3946 < 0f) {
                                        phi_6598_ = -(_e3946);
                                    } else {
                                        phi_6598_ = _e3946;
                                    }
                                    let _e4045 = phi_6598_;
                                    if (_e3949 < 0f) {
                                        phi_6605_ = -(_e3949);
                                    } else {
                                        phi_6605_ = _e3949;
                                    }
                                    let _e4050 = phi_6605_;
                                    let _e4051 = ((_e4041 + _e4045) + _e4050);
                                    let _e4056 = -(_e4037);
                                    if (_e4016 > _e4056) {
                                        phi_6616_ = _e4016;
                                    } else {
                                        phi_6616_ = _e4056;
                                    }
                                    let _e4059 = phi_6616_;
                                    let _e4064 = (((_e4059 - ((_e4051 * _e3809) * (0.000000059604645f * (17f / 2f)))) - (_e4051 * _e3816)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3940 > _e4064) {
                                        phi_6626_ = _e3940;
                                    } else {
                                        phi_6626_ = _e4064;
                                    }
                                    let _e4067 = phi_6626_;
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
                                            phi_6699_ = _e4084;
                                        } else {
                                            phi_6699_ = _e4089;
                                        }
                                        let _e4128 = phi_6699_;
                                        if (_e4094 < _e4102) {
                                            phi_6704_ = _e4094;
                                        } else {
                                            phi_6704_ = _e4102;
                                        }
                                        let _e4131 = phi_6704_;
                                        if (_e4128 < _e4131) {
                                            phi_6709_ = _e4128;
                                        } else {
                                            phi_6709_ = _e4131;
                                        }
                                        let _e4134 = phi_6709_;
                                        if (_e4107 < _e4112) {
                                            phi_6714_ = _e4107;
                                        } else {
                                            phi_6714_ = _e4112;
                                        }
                                        let _e4137 = phi_6714_;
                                        if (_e4117 < _e4125) {
                                            phi_6719_ = _e4117;
                                        } else {
                                            phi_6719_ = _e4125;
                                        }
                                        let _e4140 = phi_6719_;
                                        if (_e4137 < _e4140) {
                                            phi_6724_ = _e4137;
                                        } else {
                                            phi_6724_ = _e4140;
                                        }
                                        let _e4143 = phi_6724_;
                                        if (_e4134 < _e4143) {
                                            phi_6729_ = _e4134;
                                        } else {
                                            phi_6729_ = _e4143;
                                        }
                                        let _e4146 = phi_6729_;
                                        if (_e4084 > _e4089) {
                                            phi_6734_ = _e4084;
                                        } else {
                                            phi_6734_ = _e4089;
                                        }
                                        let _e4149 = phi_6734_;
                                        if (_e4094 > _e4102) {
                                            phi_6739_ = _e4094;
                                        } else {
                                            phi_6739_ = _e4102;
                                        }
                                        let _e4152 = phi_6739_;
                                        if (_e4149 > _e4152) {
                                            phi_6744_ = _e4149;
                                        } else {
                                            phi_6744_ = _e4152;
                                        }
                                        let _e4155 = phi_6744_;
                                        if (_e4107 > _e4112) {
                                            phi_6749_ = _e4107;
                                        } else {
                                            phi_6749_ = _e4112;
                                        }
                                        let _e4158 = phi_6749_;
                                        if (_e4117 > _e4125) {
                                            phi_6754_ = _e4117;
                                        } else {
                                            phi_6754_ = _e4125;
                                        }
                                        let _e4161 = phi_6754_;
                                        if (_e4158 > _e4161) {
                                            phi_6759_ = _e4158;
                                        } else {
                                            phi_6759_ = _e4161;
                                        }
                                        let _e4164 = phi_6759_;
                                        if (_e4155 > _e4164) {
                                            phi_6764_ = _e4155;
                                        } else {
                                            phi_6764_ = _e4164;
                                        }
                                        let _e4167 = phi_6764_;
                                        if (_e4073 < 0f) {
                                            phi_6770_ = -(_e4073);
                                        } else {
                                            phi_6770_ = _e4073;
                                        }
                                        let _e4171 = phi_6770_;
                                        if (_e4076 < 0f) {
                                            phi_6776_ = -(_e4076);
                                        } else {
                                            phi_6776_ = _e4076;
                                        }
                                        let _e4175 = phi_6776_;
                                        if (_e4079 < 0f) {
                                            phi_6783_ = -(_e4079);
                                        } else {
                                            phi_6783_ = _e4079;
                                        }
                                        let _e4180 = phi_6783_;
                                        let _e4181 = ((_e4171 + _e4175) + _e4180);
                                        let _e4186 = -(_e4167);
                                        if (_e4146 > _e4186) {
                                            phi_6794_ = _e4146;
                                        } else {
                                            phi_6794_ = _e4186;
                                        }
                                        let _e4189 = phi_6794_;
                                        let _e4194 = (((_e4189 - ((_e4181 * _e3809) * (0.000000059604645f * (17f / 2f)))) - (_e4181 * _e3816)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4067 > _e4194) {
                                            phi_6804_ = _e4067;
                                        } else {
                                            phi_6804_ = _e4194;
                                        }
                                        let _e4197 = phi_6804_;
                                        phi_6805_ = _e4197;
                                    } else {
                                        phi_6805_ = _e4067;
                                    }
                                    let _e4199 = phi_6805_;
                                    phi_6808_ = (_e3543 || (_e4199 > 0f));
                                }
                                let _e4203 = phi_6808_;
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
                                        phi_7053_ = -(_e4361[0]);
                                    } else {
                                        phi_7053_ = _e4361[0];
                                    }
                                    let _e4368 = phi_7053_;
                                    if (_e4361[1] < 0f) {
                                        phi_7060_ = -(_e4361[1]);
                                    } else {
                                        phi_7060_ = _e4361[1];
                                    }
                                    let _e4372 = phi_7060_;
                                    if (_e4368 > _e4372) {
                                        phi_7065_ = _e4368;
                                    } else {
                                        phi_7065_ = _e4372;
                                    }
                                    let _e4375 = phi_7065_;
                                    if (_e4361[2] < 0f) {
                                        phi_7072_ = -(_e4361[2]);
                                    } else {
                                        phi_7072_ = _e4361[2];
                                    }
                                    let _e4379 = phi_7072_;
                                    if (_e4375 > _e4379) {
                                        phi_7077_ = _e4375;
                                    } else {
                                        phi_7077_ = _e4379;
                                    }
                                    let _e4382 = phi_7077_;
                                    let _e4385 = local_1.member[1u];
                                    if (_e4385[0] < 0f) {
                                        phi_7090_ = -(_e4385[0]);
                                    } else {
                                        phi_7090_ = _e4385[0];
                                    }
                                    let _e4392 = phi_7090_;
                                    if (_e4385[1] < 0f) {
                                        phi_7097_ = -(_e4385[1]);
                                    } else {
                                        phi_7097_ = _e4385[1];
                                    }
                                    let _e4396 = phi_7097_;
                                    if (_e4392 > _e4396) {
                                        phi_7102_ = _e4392;
                                    } else {
                                        phi_7102_ = _e4396;
                                    }
                                    let _e4399 = phi_7102_;
                                    if (_e4385[2] < 0f) {
                                        phi_7109_ = -(_e4385[2]);
                                    } else {
                                        phi_7109_ = _e4385[2];
                                    }
                                    let _e4403 = phi_7109_;
                                    if (_e4399 > _e4403) {
                                        phi_7114_ = _e4399;
                                    } else {
                                        phi_7114_ = _e4403;
                                    }
                                    let _e4406 = phi_7114_;
                                    if (_e4382 > _e4406) {
                                        phi_7119_ = _e4382;
                                    } else {
                                        phi_7119_ = _e4406;
                                    }
                                    let _e4409 = phi_7119_;
                                    let _e4411 = local_1.member_3;
                                    let _e4412 = (_e4409 + _e4411);
                                    let _e4415 = local_1.member_1[0u];
                                    if (_e4415[0] < 0f) {
                                        phi_7136_ = -(_e4415[0]);
                                    } else {
                                        phi_7136_ = _e4415[0];
                                    }
                                    let _e4422 = phi_7136_;
                                    if (_e4415[1] < 0f) {
                                        phi_7143_ = -(_e4415[1]);
                                    } else {
                                        phi_7143_ = _e4415[1];
                                    }
                                    let _e4426 = phi_7143_;
                                    if (_e4422 > _e4426) {
                                        phi_7148_ = _e4422;
                                    } else {
                                        phi_7148_ = _e4426;
                                    }
                                    let _e4429 = phi_7148_;
                                    if (_e4415[2] < 0f) {
                                        phi_7155_ = -(_e4415[2]);
                                    } else {
                                        phi_7155_ = _e4415[2];
                                    }
                                    let _e4433 = phi_7155_;
                                    if (_e4429 > _e4433) {
                                        phi_7160_ = _e4429;
                                    } else {
                                        phi_7160_ = _e4433;
                                    }
                                    let _e4436 = phi_7160_;
                                    let _e4439 = local_1.member_1[1u];
                                    if (_e4439[0] < 0f) {
                                        phi_7174_ = -(_e4439[0]);
                                    } else {
                                        phi_7174_ = _e4439[0];
                                    }
                                    let _e4446 = phi_7174_;
                                    if (_e4439[1] < 0f) {
                                        phi_7181_ = -(_e4439[1]);
                                    } else {
                                        phi_7181_ = _e4439[1];
                                    }
                                    let _e4450 = phi_7181_;
                                    if (_e4446 > _e4450) {
                                        phi_7186_ = _e4446;
                                    } else {
                                        phi_7186_ = _e4450;
                                    }
                                    let _e4453 = phi_7186_;
                                    if (_e4439[2] < 0f) {
                                        phi_7193_ = -(_e4439[2]);
                                    } else {
                                        phi_7193_ = _e4439[2];
                                    }
                                    let _e4457 = phi_7193_;
                                    if (_e4453 > _e4457) {
                                        phi_7198_ = _e4453;
                                    } else {
                                        phi_7198_ = _e4457;
                                    }
                                    let _e4460 = phi_7198_;
                                    if (_e4436 > _e4460) {
                                        phi_7203_ = _e4436;
                                    } else {
                                        phi_7203_ = _e4460;
                                    }
                                    let _e4463 = phi_7203_;
                                    let _e4465 = local_1.member_3;
                                    let _e4466 = (_e4463 + _e4465);
                                    let _e4469 = local_1.member_2[0u];
                                    if (_e4469[0] < 0f) {
                                        phi_7220_ = -(_e4469[0]);
                                    } else {
                                        phi_7220_ = _e4469[0];
                                    }
                                    let _e4476 = phi_7220_;
                                    if (_e4469[1] < 0f) {
                                        phi_7227_ = -(_e4469[1]);
                                    } else {
                                        phi_7227_ = _e4469[1];
                                    }
                                    let _e4480 = phi_7227_;
                                    if (_e4476 > _e4480) {
                                        phi_7232_ = _e4476;
                                    } else {
                                        phi_7232_ = _e4480;
                                    }
                                    let _e4483 = phi_7232_;
                                    if (_e4469[2] < 0f) {
                                        phi_7239_ = -(_e4469[2]);
                                    } else {
                                        phi_7239_ = _e4469[2];
                                    }
                                    let _e4487 = phi_7239_;
                                    if (_e4483 > _e4487) {
                                        phi_7244_ = _e4483;
                                    } else {
                                        phi_7244_ = _e4487;
                                    }
                                    let _e4490 = phi_7244_;
                                    let _e4493 = local_1.member_2[1u];
                                    if (_e4493[0] < 0f) {
                                        phi_7258_ = -(_e4493[0]);
                                    } else {
                                        phi_7258_ = _e4493[0];
                                    }
                                    let _e4500 = phi_7258_;
                                    if (_e4493[1] < 0f) {
                                        phi_7265_ = -(_e4493[1]);
                                    } else {
                                        phi_7265_ = _e4493[1];
                                    }
                                    let _e4504 = phi_7265_;
                                    if (_e4500 > _e4504) {
                                        phi_7270_ = _e4500;
                                    } else {
                                        phi_7270_ = _e4504;
                                    }
                                    let _e4507 = phi_7270_;
                                    if (_e4493[2] < 0f) {
                                        phi_7277_ = -(_e4493[2]);
                                    } else {
                                        phi_7277_ = _e4493[2];
                                    }
                                    let _e4511 = phi_7277_;
                                    if (_e4507 > _e4511) {
                                        phi_7282_ = _e4507;
                                    } else {
                                        phi_7282_ = _e4511;
                                    }
                                    let _e4514 = phi_7282_;
                                    if (_e4490 > _e4514) {
                                        phi_7287_ = _e4490;
                                    } else {
                                        phi_7287_ = _e4514;
                                    }
                                    let _e4517 = phi_7287_;
                                    let _e4519 = local_1.member_3;
                                    let _e4520 = (_e4517 + _e4519);
                                    let _e4522 = ((_e4466 * 8f) * _e4520);
                                    let _e4529 = local_1.member_3;
                                    if (_e4218 < 0f) {
                                        phi_7318_ = -(_e4218);
                                    } else {
                                        phi_7318_ = _e4218;
                                    }
                                    let _e4546 = phi_7318_;
                                    if (_e4221 < 0f) {
                                        phi_7324_ = -(_e4221);
                                    } else {
                                        phi_7324_ = _e4221;
                                    }
                                    let _e4550 = phi_7324_;
                                    if (_e4224 < 0f) {
                                        phi_7331_ = -(_e4224);
                                    } else {
                                        phi_7331_ = _e4224;
                                    }
                                    let _e4555 = phi_7331_;
                                    let _e4556 = ((_e4546 + _e4550) + _e4555);
                                    if (_e4239 < 0f) {
                                        phi_7338_ = -(_e4239);
                                    } else {
                                        phi_7338_ = _e4239;
                                    }
                                    let _e4560 = phi_7338_;
                                    if (_e4242 < 0f) {
                                        phi_7344_ = -(_e4242);
                                    } else {
                                        phi_7344_ = _e4242;
                                    }
                                    let _e4564 = phi_7344_;
                                    if (_e4245 < 0f) {
                                        phi_7351_ = -(_e4245);
                                    } else {
                                        phi_7351_ = _e4245;
                                    }
                                    let _e4569 = phi_7351_;
                                    let _e4570 = ((_e4560 + _e4564) + _e4569);
                                    if (_e4556 > _e4570) {
                                        phi_7357_ = _e4556;
                                    } else {
                                        phi_7357_ = _e4570;
                                    }
                                    let _e4573 = phi_7357_;
                                    if (_e4288 < 0f) {
                                        phi_7363_ = -(_e4288);
                                    } else {
                                        phi_7363_ = _e4288;
                                    }
                                    let _e4577 = phi_7363_;
                                    if (_e4289 < 0f) {
                                        phi_7369_ = -(_e4289);
                                    } else {
                                        phi_7369_ = _e4289;
                                    }
                                    let _e4581 = phi_7369_;
                                    if (_e4290 < 0f) {
                                        phi_7376_ = -(_e4290);
                                    } else {
                                        phi_7376_ = _e4290;
                                    }
                                    let _e4586 = phi_7376_;
                                    let _e4588 = (((_e4577 + _e4581) + _e4586) * 0.5f);
                                    if (_e4573 > _e4588) {
                                        phi_7383_ = _e4573;
                                    } else {
                                        phi_7383_ = _e4588;
                                    }
                                    let _e4591 = phi_7383_;
                                    let _e4596 = local_1.member_3;
                                    let _e4609 = ((((_e4293[0] * _e4218) + (_e4293[1] * _e4221)) + (_e4293[2] * _e4224)) * 3f);
                                    let _e4610 = ((((_e4350[0] * _e4239) + (_e4350[1] * _e4242)) + (_e4350[2] * _e4245)) * 3f);
                                    if (_e4609 < _e4610) {
                                        phi_7407_ = _e4609;
                                    } else {
                                        phi_7407_ = _e4610;
                                    }
                                    let _e4613 = phi_7407_;
                                    if (_e4324 < _e4347) {
                                        phi_7412_ = _e4324;
                                    } else {
                                        phi_7412_ = _e4347;
                                    }
                                    let _e4616 = phi_7412_;
                                    if (_e4613 < _e4616) {
                                        phi_7417_ = _e4613;
                                    } else {
                                        phi_7417_ = _e4616;
                                    }
                                    let _e4619 = phi_7417_;
                                    if (_e4609 > _e4610) {
                                        phi_7422_ = _e4609;
                                    } else {
                                        phi_7422_ = _e4610;
                                    }
                                    let _e4622 = phi_7422_;
                                    if (_e4324 > _e4347) {
                                        phi_7427_ = _e4324;
                                    } else {
                                        phi_7427_ = _e4347;
                                    }
                                    let _e4625 = phi_7427_;
                                    if (_e4622 > _e4625) {
                                        phi_7432_ = _e4622;
                                    } else {
                                        phi_7432_ = _e4625;
                                    }
                                    let _e4628 = phi_7432_;
                                    let _e4633 = -(_e4628);
                                    if (_e4619 > _e4633) {
                                        phi_7442_ = _e4619;
                                    } else {
                                        phi_7442_ = _e4633;
                                    }
                                    let _e4636 = phi_7442_;
                                    let _e4638 = ((_e4636 - ((((((_e4412 * 8f) * _e4522) * (0.000000059604645f * (524f / 64f))) + ((_e4529 * 19f) * ((_e4412 * (_e4466 + _e4520)) + (_e4466 * _e4520)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4412) * ((1f + _e4466) * (1f + _e4520))))) + ((_e91.member_5 * (((_e4591 + (_e4522 * (0.000000059604645f * 8f))) + ((_e4596 * 6f) * (_e4466 + _e4520))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4466) * (1f + _e4520))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4638 {
                                        phi_8411_ = _e4638;
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
                                            phi_7558_ = array<f32, 3>(_e4680[0], _e4680[1], _e4680[2]);
                                        } else {
                                            phi_7558_ = array<f32, 3>((_e4697 - _e4693[0]), (_e4698 - _e4693[1]), (_e4699 - _e4693[2]));
                                        }
                                        let _e4705 = phi_7558_;
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
                                            phi_7623_ = array<f32, 3>(_e4711[0], _e4711[1], _e4711[2]);
                                        } else {
                                            phi_7623_ = array<f32, 3>((_e4728 - _e4724[0]), (_e4729 - _e4724[1]), (_e4730 - _e4724[2]));
                                        }
                                        let _e4736 = phi_7623_;
                                        let _e4737 = (_e4711[0] - _e4724[0]);
                                        let _e4738 = (_e4711[1] - _e4724[1]);
                                        let _e4739 = (_e4711[2] - _e4724[2]);
                                        let _e4742 = local_1.member[0u];
                                        if (_e4742[0] < 0f) {
                                            phi_7645_ = -(_e4742[0]);
                                        } else {
                                            phi_7645_ = _e4742[0];
                                        }
                                        let _e4749 = phi_7645_;
                                        if (_e4742[1] < 0f) {
                                            phi_7652_ = -(_e4742[1]);
                                        } else {
                                            phi_7652_ = _e4742[1];
                                        }
                                        let _e4753 = phi_7652_;
                                        if (_e4749 > _e4753) {
                                            phi_7657_ = _e4749;
                                        } else {
                                            phi_7657_ = _e4753;
                                        }
                                        let _e4756 = phi_7657_;
                                        if (_e4742[2] < 0f) {
                                            phi_7664_ = -(_e4742[2]);
                                        } else {
                                            phi_7664_ = _e4742[2];
                                        }
                                        let _e4760 = phi_7664_;
                                        if (_e4756 > _e4760) {
                                            phi_7669_ = _e4756;
                                        } else {
                                            phi_7669_ = _e4760;
                                        }
                                        let _e4763 = phi_7669_;
                                        let _e4766 = local_1.member[1u];
                                        if (_e4766[0] < 0f) {
                                            phi_7682_ = -(_e4766[0]);
                                        } else {
                                            phi_7682_ = _e4766[0];
                                        }
                                        let _e4773 = phi_7682_;
                                        if (_e4766[1] < 0f) {
                                            phi_7689_ = -(_e4766[1]);
                                        } else {
                                            phi_7689_ = _e4766[1];
                                        }
                                        let _e4777 = phi_7689_;
                                        if (_e4773 > _e4777) {
                                            phi_7694_ = _e4773;
                                        } else {
                                            phi_7694_ = _e4777;
                                        }
                                        let _e4780 = phi_7694_;
                                        if (_e4766[2] < 0f) {
                                            phi_7701_ = -(_e4766[2]);
                                        } else {
                                            phi_7701_ = _e4766[2];
                                        }
                                        let _e4784 = phi_7701_;
                                        if (_e4780 > _e4784) {
                                            phi_7706_ = _e4780;
                                        } else {
                                            phi_7706_ = _e4784;
                                        }
                                        let _e4787 = phi_7706_;
                                        if (_e4763 > _e4787) {
                                            phi_7711_ = _e4763;
                                        } else {
                                            phi_7711_ = _e4787;
                                        }
                                        let _e4790 = phi_7711_;
                                        let _e4792 = local_1.member_3;
                                        let _e4796 = local_1.member_1[0u];
                                        if (_e4796[0] < 0f) {
                                            phi_7728_ = -(_e4796[0]);
                                        } else {
                                            phi_7728_ = _e4796[0];
                                        }
                                        let _e4803 = phi_7728_;
                                        if (_e4796[1] < 0f) {
                                            phi_7735_ = -(_e4796[1]);
                                        } else {
                                            phi_7735_ = _e4796[1];
                                        }
                                        let _e4807 = phi_7735_;
                                        if (_e4803 > _e4807) {
                                            phi_7740_ = _e4803;
                                        } else {
                                            phi_7740_ = _e4807;
                                        }
                                        let _e4810 = phi_7740_;
                                        if (_e4796[2] < 0f) {
                                            phi_7747_ = -(_e4796[2]);
                                        } else {
                                            phi_7747_ = _e4796[2];
                                        }
                                        let _e4814 = phi_7747_;
                                        if (_e4810 > _e4814) {
                                            phi_7752_ = _e4810;
                                        } else {
                                            phi_7752_ = _e4814;
                                        }
                                        let _e4817 = phi_7752_;
                                        let _e4820 = local_1.member_1[1u];
                                        if (_e4820[0] < 0f) {
                                            phi_7766_ = -(_e4820[0]);
                                        } else {
                                            phi_7766_ = _e4820[0];
                                        }
                                        let _e4827 = phi_7766_;
                                        if (_e4820[1] < 0f) {
                                            phi_7773_ = -(_e4820[1]);
                                        } else {
                                            phi_7773_ = _e4820[1];
                                        }
                                        let _e4831 = phi_7773_;
                                        if (_e4827 > _e4831) {
                                            phi_7778_ = _e4827;
                                        } else {
                                            phi_7778_ = _e4831;
                                        }
                                        let _e4834 = phi_7778_;
                                        if (_e4820[2] < 0f) {
                                            phi_7785_ = -(_e4820[2]);
                                        } else {
                                            phi_7785_ = _e4820[2];
                                        }
                                        let _e4838 = phi_7785_;
                                        if (_e4834 > _e4838) {
                                            phi_7790_ = _e4834;
                                        } else {
                                            phi_7790_ = _e4838;
                                        }
                                        let _e4841 = phi_7790_;
                                        if (_e4817 > _e4841) {
                                            phi_7795_ = _e4817;
                                        } else {
                                            phi_7795_ = _e4841;
                                        }
                                        let _e4844 = phi_7795_;
                                        let _e4846 = local_1.member_3;
                                        let _e4850 = local_1.member_2[0u];
                                        if (_e4850[0] < 0f) {
                                            phi_7812_ = -(_e4850[0]);
                                        } else {
                                            phi_7812_ = _e4850[0];
                                        }
                                        let _e4857 = phi_7812_;
                                        if (_e4850[1] < 0f) {
                                            phi_7819_ = -(_e4850[1]);
                                        } else {
                                            phi_7819_ = _e4850[1];
                                        }
                                        let _e4861 = phi_7819_;
                                        if (_e4857 > _e4861) {
                                            phi_7824_ = _e4857;
                                        } else {
                                            phi_7824_ = _e4861;
                                        }
                                        let _e4864 = phi_7824_;
                                        if (_e4850[2] < 0f) {
                                            phi_7831_ = -(_e4850[2]);
                                        } else {
                                            phi_7831_ = _e4850[2];
                                        }
                                        let _e4868 = phi_7831_;
                                        if (_e4864 > _e4868) {
                                            phi_7836_ = _e4864;
                                        } else {
                                            phi_7836_ = _e4868;
                                        }
                                        let _e4871 = phi_7836_;
                                        let _e4874 = local_1.member_2[1u];
                                        if (_e4874[0] < 0f) {
                                            phi_7850_ = -(_e4874[0]);
                                        } else {
                                            phi_7850_ = _e4874[0];
                                        }
                                        let _e4881 = phi_7850_;
                                        if (_e4874[1] < 0f) {
                                            phi_7857_ = -(_e4874[1]);
                                        } else {
                                            phi_7857_ = _e4874[1];
                                        }
                                        let _e4885 = phi_7857_;
                                        if (_e4881 > _e4885) {
                                            phi_7862_ = _e4881;
                                        } else {
                                            phi_7862_ = _e4885;
                                        }
                                        let _e4888 = phi_7862_;
                                        if (_e4874[2] < 0f) {
                                            phi_7869_ = -(_e4874[2]);
                                        } else {
                                            phi_7869_ = _e4874[2];
                                        }
                                        let _e4892 = phi_7869_;
                                        if (_e4888 > _e4892) {
                                            phi_7874_ = _e4888;
                                        } else {
                                            phi_7874_ = _e4892;
                                        }
                                        let _e4895 = phi_7874_;
                                        if (_e4871 > _e4895) {
                                            phi_7879_ = _e4871;
                                        } else {
                                            phi_7879_ = _e4895;
                                        }
                                        let _e4898 = phi_7879_;
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
                                            phi_7958_ = _e4925;
                                        } else {
                                            phi_7958_ = _e4930;
                                        }
                                        let _e4969 = phi_7958_;
                                        if (_e4935 < _e4943) {
                                            phi_7963_ = _e4935;
                                        } else {
                                            phi_7963_ = _e4943;
                                        }
                                        let _e4972 = phi_7963_;
                                        if (_e4969 < _e4972) {
                                            phi_7968_ = _e4969;
                                        } else {
                                            phi_7968_ = _e4972;
                                        }
                                        let _e4975 = phi_7968_;
                                        if (_e4948 < _e4953) {
                                            phi_7973_ = _e4948;
                                        } else {
                                            phi_7973_ = _e4953;
                                        }
                                        let _e4978 = phi_7973_;
                                        if (_e4958 < _e4966) {
                                            phi_7978_ = _e4958;
                                        } else {
                                            phi_7978_ = _e4966;
                                        }
                                        let _e4981 = phi_7978_;
                                        if (_e4978 < _e4981) {
                                            phi_7983_ = _e4978;
                                        } else {
                                            phi_7983_ = _e4981;
                                        }
                                        let _e4984 = phi_7983_;
                                        if (_e4975 < _e4984) {
                                            phi_7988_ = _e4975;
                                        } else {
                                            phi_7988_ = _e4984;
                                        }
                                        let _e4987 = phi_7988_;
                                        if (_e4925 > _e4930) {
                                            phi_7993_ = _e4925;
                                        } else {
                                            phi_7993_ = _e4930;
                                        }
                                        let _e4990 = phi_7993_;
                                        if (_e4935 > _e4943) {
                                            phi_7998_ = _e4935;
                                        } else {
                                            phi_7998_ = _e4943;
                                        }
                                        let _e4993 = phi_7998_;
                                        if (_e4990 > _e4993) {
                                            phi_8003_ = _e4990;
                                        } else {
                                            phi_8003_ = _e4993;
                                        }
                                        let _e4996 = phi_8003_;
                                        if (_e4948 > _e4953) {
                                            phi_8008_ = _e4948;
                                        } else {
                                            phi_8008_ = _e4953;
                                        }
                                        let _e4999 = phi_8008_;
                                        if (_e4958 > _e4966) {
                                            phi_8013_ = _e4958;
                                        } else {
                                            phi_8013_ = _e4966;
                                        }
                                        let _e5002 = phi_8013_;
                                        if (_e4999 > _e5002) {
                                            phi_8018_ = _e4999;
                                        } else {
                                            phi_8018_ = _e5002;
                                        }
                                        let _e5005 = phi_8018_;
                                        if (_e4996 > _e5005) {
                                            phi_8023_ = _e4996;
                                        } else {
                                            phi_8023_ = _e5005;
                                        }
                                        let _e5008 = phi_8023_;
                                        if (_e4914 < 0f) {
                                            phi_8029_ = -(_e4914);
                                        } else {
                                            phi_8029_ = _e4914;
                                        }
                                        let _e5012 = phi_8029_;
                                        if (_e4917 < 0f) {
                                            phi_8035_ = -(_e4917);
                                        } else {
                                            phi_8035_ = _e4917;
                                        }
                                        let _e5016 = phi_8035_;
                                        if (_e4920 < 0f) {
                                            phi_8042_ = -(_e4920);
                                        } else {
                                            phi_8042_ = _e4920;
                                        }
                                        let _e5021 = phi_8042_;
                                        let _e5022 = ((_e5012 + _e5016) + _e5021);
                                        let _e5027 = -(_e5008);
                                        if (_e4987 > _e5027) {
                                            phi_8053_ = _e4987;
                                        } else {
                                            phi_8053_ = _e5027;
                                        }
                                        let _e5030 = phi_8053_;
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
                                            phi_8124_ = _e5049;
                                        } else {
                                            phi_8124_ = _e5054;
                                        }
                                        let _e5093 = phi_8124_;
                                        if (_e5059 < _e5067) {
                                            phi_8129_ = _e5059;
                                        } else {
                                            phi_8129_ = _e5067;
                                        }
                                        let _e5096 = phi_8129_;
                                        if (_e5093 < _e5096) {
                                            phi_8134_ = _e5093;
                                        } else {
                                            phi_8134_ = _e5096;
                                        }
                                        let _e5099 = phi_8134_;
                                        if (_e5072 < _e5077) {
                                            phi_8139_ = _e5072;
                                        } else {
                                            phi_8139_ = _e5077;
                                        }
                                        let _e5102 = phi_8139_;
                                        if (_e5082 < _e5090) {
                                            phi_8144_ = _e5082;
                                        } else {
                                            phi_8144_ = _e5090;
                                        }
                                        let _e5105 = phi_8144_;
                                        if (_e5102 < _e5105) {
                                            phi_8149_ = _e5102;
                                        } else {
                                            phi_8149_ = _e5105;
                                        }
                                        let _e5108 = phi_8149_;
                                        if (_e5099 < _e5108) {
                                            phi_8154_ = _e5099;
                                        } else {
                                            phi_8154_ = _e5108;
                                        }
                                        let _e5111 = phi_8154_;
                                        if (_e5049 > _e5054) {
                                            phi_8159_ = _e5049;
                                        } else {
                                            phi_8159_ = _e5054;
                                        }
                                        let _e5114 = phi_8159_;
                                        if (_e5059 > _e5067) {
                                            phi_8164_ = _e5059;
                                        } else {
                                            phi_8164_ = _e5067;
                                        }
                                        let _e5117 = phi_8164_;
                                        if (_e5114 > _e5117) {
                                            phi_8169_ = _e5114;
                                        } else {
                                            phi_8169_ = _e5117;
                                        }
                                        let _e5120 = phi_8169_;
                                        if (_e5072 > _e5077) {
                                            phi_8174_ = _e5072;
                                        } else {
                                            phi_8174_ = _e5077;
                                        }
                                        let _e5123 = phi_8174_;
                                        if (_e5082 > _e5090) {
                                            phi_8179_ = _e5082;
                                        } else {
                                            phi_8179_ = _e5090;
                                        }
                                        let _e5126 = phi_8179_;
                                        if (_e5123 > _e5126) {
                                            phi_8184_ = _e5123;
                                        } else {
                                            phi_8184_ = _e5126;
                                        }
                                        let _e5129 = phi_8184_;
                                        if (_e5120 > _e5129) {
                                            phi_8189_ = _e5120;
                                        } else {
                                            phi_8189_ = _e5129;
                                        }
                                        let _e5132 = phi_8189_;
                                        if (_e5038 < 0f) {
                                            phi_8195_ = -(_e5038);
                                        } else {
                                            phi_8195_ = _e5038;
                                        }
                                        let _e5136 = phi_8195_;
                                        if (_e5041 < 0f) {
                                            phi_8201_ = -(_e5041);
                                        } else {
                                            phi_8201_ = _e5041;
                                        }
                                        let _e5140 = phi_8201_;
                                        if (_e5044 < 0f) {
                                            phi_8208_ = -(_e5044);
                                        } else {
                                            phi_8208_ = _e5044;
                                        }
                                        let _e5145 = phi_8208_;
                                        let _e5146 = ((_e5136 + _e5140) + _e5145);
                                        let _e5151 = -(_e5132);
                                        if (_e5111 > _e5151) {
                                            phi_8219_ = _e5111;
                                        } else {
                                            phi_8219_ = _e5151;
                                        }
                                        let _e5154 = phi_8219_;
                                        let _e5159 = (((_e5154 - ((_e5146 * _e4904) * (0.000000059604645f * (17f / 2f)))) - (_e5146 * _e4911)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5035 > _e5159) {
                                            phi_8229_ = _e5035;
                                        } else {
                                            phi_8229_ = _e5159;
                                        }
                                        let _e5162 = phi_8229_;
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
                                                phi_8302_ = _e5179;
                                            } else {
                                                phi_8302_ = _e5184;
                                            }
                                            let _e5223 = phi_8302_;
                                            if (_e5189 < _e5197) {
                                                phi_8307_ = _e5189;
                                            } else {
                                                phi_8307_ = _e5197;
                                            }
                                            let _e5226 = phi_8307_;
                                            if (_e5223 < _e5226) {
                                                phi_8312_ = _e5223;
                                            } else {
                                                phi_8312_ = _e5226;
                                            }
                                            let _e5229 = phi_8312_;
                                            if (_e5202 < _e5207) {
                                                phi_8317_ = _e5202;
                                            } else {
                                                phi_8317_ = _e5207;
                                            }
                                            let _e5232 = phi_8317_;
                                            if (_e5212 < _e5220) {
                                                phi_8322_ = _e5212;
                                            } else {
                                                phi_8322_ = _e5220;
                                            }
                                            let _e5235 = phi_8322_;
                                            if (_e5232 < _e5235) {
                                                phi_8327_ = _e5232;
                                            } else {
                                                phi_8327_ = _e5235;
                                            }
                                            let _e5238 = phi_8327_;
                                            if (_e5229 < _e5238) {
                                                phi_8332_ = _e5229;
                                            } else {
                                                phi_8332_ = _e5238;
                                            }
                                            let _e5241 = phi_8332_;
                                            if (_e5179 > _e5184) {
                                                phi_8337_ = _e5179;
                                            } else {
                                                phi_8337_ = _e5184;
                                            }
                                            let _e5244 = phi_8337_;
                                            if (_e5189 > _e5197) {
                                                phi_8342_ = _e5189;
                                            } else {
                                                phi_8342_ = _e5197;
                                            }
                                            let _e5247 = phi_8342_;
                                            if (_e5244 > _e5247) {
                                                phi_8347_ = _e5244;
                                            } else {
                                                phi_8347_ = _e5247;
                                            }
                                            let _e5250 = phi_8347_;
                                            if (_e5202 > _e5207) {
                                                phi_8352_ = _e5202;
                                            } else {
                                                phi_8352_ = _e5207;
                                            }
                                            let _e5253 = phi_8352_;
                                            if (_e5212 > _e5220) {
                                                phi_8357_ = _e5212;
                                            } else {
                                                phi_8357_ = _e5220;
                                            }
                                            let _e5256 = phi_8357_;
                                            if (_e5253 > _e5256) {
                                                phi_8362_ = _e5253;
                                            } else {
                                                phi_8362_ = _e5256;
                                            }
                                            let _e5259 = phi_8362_;
                                            if (_e5250 > _e5259) {
                                                phi_8367_ = _e5250;
                                            } else {
                                                phi_8367_ = _e5259;
                                            }
                                            let _e5262 = phi_8367_;
                                            if (_e5168 < 0f) {
                                                phi_8373_ = -(_e5168);
                                            } else {
                                                phi_8373_ = _e5168;
                                            }
                                            let _e5266 = phi_8373_;
                                            if (_e5171 < 0f) {
                                                phi_8379_ = -(_e5171);
                                            } else {
                                                phi_8379_ = _e5171;
                                            }
                                            let _e5270 = phi_8379_;
                                            if (_e5174 < 0f) {
                                                phi_8386_ = -(_e5174);
                                            } else {
                                                phi_8386_ = _e5174;
                                            }
                                            let _e5275 = phi_8386_;
                                            let _e5276 = ((_e5266 + _e5270) + _e5275);
                                            let _e5281 = -(_e5262);
                                            if (_e5241 > _e5281) {
                                                phi_8397_ = _e5241;
                                            } else {
                                                phi_8397_ = _e5281;
                                            }
                                            let _e5284 = phi_8397_;
                                            let _e5289 = (((_e5284 - ((_e5276 * _e4904) * (0.000000059604645f * (17f / 2f)))) - (_e5276 * _e4911)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                            if (_e5162 > _e5289) {
                                                phi_8407_ = _e5162;
                                            } else {
                                                phi_8407_ = _e5289;
                                            }
                                            let _e5292 = phi_8407_;
                                            phi_8408_ = _e5292;
                                        } else {
                                            phi_8408_ = _e5162;
                                        }
                                        let _e5294 = phi_8408_;
                                        phi_8411_ = (_e4638 || (_e5294 > 0f));
                                    }
                                    let _e5298 = phi_8411_;
                                    phi_8413_ = (_e4203 && _e5298);
                                } else {
                                    phi_8413_ = _e4203;
                                }
                                let _e5301 = phi_8413_;
                                if _e5301 {
                                } else {
                                    let _e5303 = atomicAdd((&counters[7u]), 1u);
                                    hits[_e2865] = ((2147483648u | (_e5303 << bitcast<u32>(12i))) | _e2868);
                                }
                                phi_8423_ = true;
                            }
                            let _e5310 = phi_8423_;
                            phi_8424_ = _e5310;
                        } else {
                            phi_8424_ = false;
                        }
                        let _e5312 = phi_8424_;
                        continue;
                        continuing {
                            phi_4842_ = _e2857;
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
                    phi_8460_ = type_9(0u, 4u);
                    loop {
                        let _e5334 = phi_8460_;
                        if (_e5334.member < _e5334.member_1) {
                            phi_8461_ = type_9((_e5334.member + 1u), _e5334.member_1);
                            phi_8484_ = type_9(1u, _e5334.member);
                        } else {
                            phi_8461_ = _e5334;
                            phi_8484_ = type_9(0u, type_9().member_1);
                        }
                        let _e5346 = phi_8461_;
                        let _e5348 = phi_8484_;
                        if (bitcast<i32>(_e5348.member) != 0i) {
                            let _e5354 = (_e73 + (_e5348.member_1 * 128u));
                            if (_e5354 >= _e2843) {
                                phi_8579_ = false;
                            } else {
                                let _e5357 = hits[_e5354];
                                if ((_e5357 & 2147483648u) == 0u) {
                                    phi_8508_ = 4294967295u;
                                } else {
                                    phi_8508_ = ((_e5357 & 2147483647u) >> bitcast<u32>(12i));
                                }
                                let _e5364 = phi_8508_;
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
                                phi_8579_ = true;
                            }
                            let _e5396 = phi_8579_;
                            phi_8580_ = _e5396;
                        } else {
                            phi_8580_ = false;
                        }
                        let _e5398 = phi_8580_;
                        continue;
                        continuing {
                            phi_8460_ = _e5346;
                            break if !(_e5398);
                        }
                    }
                    workgroupBarrier();
                    let _e5982 = local_7;
                    phi_1378_ = _e5982;
                } else {
                    phi_1378_ = type_9();
                }
                let _e5401 = phi_1378_;
                continue;
                continuing {
                    phi_1374_ = _e626;
                    phi_1377_ = _e5401;
                    break if !(_e632);
                }
            }
        }
        continue;
        continuing {
            phi_511_ = _e163;
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
