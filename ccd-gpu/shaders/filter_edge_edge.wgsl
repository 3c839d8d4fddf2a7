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
    var phi_8599_: bool;
    var phi_8603_: f32;

    if (param_12 != param_12) {
        phi_8599_ = true;
    } else {
        phi_8599_ = (param_13 >= param_12);
    }
    let _e6 = phi_8599_;
    if _e6 {
        phi_8603_ = param_13;
    } else {
        phi_8603_ = param_12;
    }
    let _e8 = phi_8603_;
    return _e8;
}

fn function_7(param_14: f32, param_15: f32) -> f32 {
    var phi_8583_: bool;
    var phi_8587_: f32;

    if (param_14 != param_14) {
        phi_8583_ = true;
    } else {
        phi_8583_ = (param_15 <= param_14);
    }
    let _e6 = phi_8583_;
    if _e6 {
        phi_8587_ = param_15;
    } else {
        phi_8587_ = param_14;
    }
    let _e8 = phi_8587_;
    return _e8;
}

fn function_8(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_39;
    var local_1: type_39;
    var local_2: type_39;
    var phi_378_: u32;
    var phi_427_: u32;
    var phi_428_: u32;
    var phi_436_: u32;
    var phi_452_: u32;
    var phi_475_: u32;
    var phi_476_: u32;
    var phi_479_: type_9;
    var phi_480_: type_9;
    var phi_505_: type_9;
    var phi_552_: u32;
    var phi_553_: u32;
    var phi_561_: u32;
    var phi_575_: u32;
    var phi_678_: array<u32, 2>;
    var phi_839_: bool;
    var phi_877_: type_29;
    var phi_906_: u32;
    var phi_909_: type_9;
    var phi_912_: u32;
    var phi_910_: type_9;
    var phi_935_: type_9;
    var phi_913_: u32;
    var local_3: u32;
    var phi_1124_: u32;
    var phi_1230_: type_9;
    var phi_1233_: u32;
    var phi_1231_: type_9;
    var phi_1256_: type_9;
    var phi_1280_: bool;
    var phi_1281_: bool;
    var phi_1282_: bool;
    var phi_1286_: bool;
    var phi_1294_: bool;
    var phi_1302_: u32;
    var phi_1234_: u32;
    var phi_1303_: u32;
    var phi_1313_: type_9;
    var phi_1339_: u32;
    var phi_1342_: type_9;
    var phi_1345_: type_9;
    var phi_1343_: type_9;
    var phi_1370_: type_9;
    var phi_1387_: type_9;
    var phi_1390_: type_9;
    var phi_1391_: type_9;
    var phi_1413_: type_9;
    var phi_1447_: type_9;
    var phi_1448_: bool;
    var phi_1388_: type_9;
    var phi_1449_: bool;
    var phi_1457_: u32;
    var phi_1460_: type_9;
    var phi_1461_: type_9;
    var phi_1486_: type_9;
    var phi_1642_: bool;
    var phi_1648_: bool;
    var phi_1654_: bool;
    var phi_1655_: bool;
    var phi_1696_: bool;
    var phi_1697_: bool;
    var phi_1704_: bool;
    var phi_1818_: bool;
    var phi_1819_: bool;
    var phi_1854_: u32;
    var phi_1855_: u32;
    var phi_1860_: type_15;
    var phi_1863_: u32;
    var phi_1865_: u32;
    var phi_1886_: bool;
    var phi_1892_: type_16;
    var phi_1861_: type_15;
    var phi_1906_: type_16;
    var phi_1974_: bool;
    var phi_1975_: bool;
    var phi_1976_: bool;
    var phi_1977_: bool;
    var phi_1981_: bool;
    var phi_1982_: bool;
    var phi_1987_: u32;
    var phi_1988_: u32;
    var phi_1989_: u32;
    var phi_1990_: u32;
    var phi_1991_: bool;
    var phi_1864_: u32;
    var phi_1866_: u32;
    var phi_1992_: bool;
    var local_4: u32;
    var local_5: u32;
    var phi_2040_: bool;
    var phi_2041_: bool;
    var phi_2042_: bool;
    var phi_2043_: bool;
    var phi_2047_: bool;
    var phi_2048_: bool;
    var phi_2052_: bool;
    var phi_2056_: bool;
    var phi_2057_: bool;
    var phi_2061_: bool;
    var phi_2062_: bool;
    var phi_2066_: bool;
    var phi_2067_: bool;
    var phi_2183_: bool;
    var phi_2184_: bool;
    var phi_2271_: bool;
    var phi_2272_: bool;
    var phi_2360_: bool;
    var phi_2361_: bool;
    var phi_2448_: bool;
    var phi_2449_: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_2626_: bool;
    var phi_2627_: bool;
    var phi_2631_: bool;
    var phi_2632_: bool;
    var phi_2633_: bool;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var phi_2639_: bool;
    var phi_2640_: bool;
    var phi_2641_: bool;
    var phi_2645_: bool;
    var phi_2680_: type_43;
    var phi_2805_: type_44;
    var phi_2852_: type_44;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2930_: type_9;
    var phi_2931_: type_9;
    var phi_2954_: type_9;
    var phi_3025_: type_43;
    var phi_3159_: type_39;
    var phi_3439_: f32;
    var phi_3446_: f32;
    var phi_3451_: f32;
    var phi_3458_: f32;
    var phi_3463_: f32;
    var phi_3476_: f32;
    var phi_3483_: f32;
    var phi_3488_: f32;
    var phi_3495_: f32;
    var phi_3500_: f32;
    var phi_3505_: f32;
    var phi_3522_: f32;
    var phi_3529_: f32;
    var phi_3534_: f32;
    var phi_3541_: f32;
    var phi_3546_: f32;
    var phi_3560_: f32;
    var phi_3567_: f32;
    var phi_3572_: f32;
    var phi_3579_: f32;
    var phi_3584_: f32;
    var phi_3589_: f32;
    var phi_3606_: f32;
    var phi_3613_: f32;
    var phi_3618_: f32;
    var phi_3625_: f32;
    var phi_3630_: f32;
    var phi_3644_: f32;
    var phi_3651_: f32;
    var phi_3656_: f32;
    var phi_3663_: f32;
    var phi_3668_: f32;
    var phi_3673_: f32;
    var phi_3704_: f32;
    var phi_3710_: f32;
    var phi_3717_: f32;
    var phi_3724_: f32;
    var phi_3730_: f32;
    var phi_3737_: f32;
    var phi_3743_: f32;
    var phi_3749_: f32;
    var phi_3755_: f32;
    var phi_3762_: f32;
    var phi_3769_: f32;
    var phi_3793_: f32;
    var phi_3798_: f32;
    var phi_3803_: f32;
    var phi_3808_: f32;
    var phi_3813_: f32;
    var phi_3818_: f32;
    var phi_3828_: f32;
    var phi_3944_: array<f32, 3>;
    var phi_4009_: array<f32, 3>;
    var phi_4031_: f32;
    var phi_4038_: f32;
    var phi_4043_: f32;
    var phi_4050_: f32;
    var phi_4055_: f32;
    var phi_4068_: f32;
    var phi_4075_: f32;
    var phi_4080_: f32;
    var phi_4087_: f32;
    var phi_4092_: f32;
    var phi_4097_: f32;
    var phi_4114_: f32;
    var phi_4121_: f32;
    var phi_4126_: f32;
    var phi_4133_: f32;
    var phi_4138_: f32;
    var phi_4152_: f32;
    var phi_4159_: f32;
    var phi_4164_: f32;
    var phi_4171_: f32;
    var phi_4176_: f32;
    var phi_4181_: f32;
    var phi_4198_: f32;
    var phi_4205_: f32;
    var phi_4210_: f32;
    var phi_4217_: f32;
    var phi_4222_: f32;
    var phi_4236_: f32;
    var phi_4243_: f32;
    var phi_4248_: f32;
    var phi_4255_: f32;
    var phi_4260_: f32;
    var phi_4265_: f32;
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
    var phi_4409_: f32;
    var phi_4415_: f32;
    var phi_4421_: f32;
    var phi_4428_: f32;
    var phi_4439_: f32;
    var phi_4510_: f32;
    var phi_4515_: f32;
    var phi_4520_: f32;
    var phi_4525_: f32;
    var phi_4530_: f32;
    var phi_4535_: f32;
    var phi_4540_: f32;
    var phi_4545_: f32;
    var phi_4550_: f32;
    var phi_4555_: f32;
    var phi_4560_: f32;
    var phi_4565_: f32;
    var phi_4570_: f32;
    var phi_4575_: f32;
    var phi_4581_: f32;
    var phi_4587_: f32;
    var phi_4594_: f32;
    var phi_4605_: f32;
    var phi_4615_: f32;
    var phi_4688_: f32;
    var phi_4693_: f32;
    var phi_4698_: f32;
    var phi_4703_: f32;
    var phi_4708_: f32;
    var phi_4713_: f32;
    var phi_4718_: f32;
    var phi_4723_: f32;
    var phi_4728_: f32;
    var phi_4733_: f32;
    var phi_4738_: f32;
    var phi_4743_: f32;
    var phi_4748_: f32;
    var phi_4753_: f32;
    var phi_4759_: f32;
    var phi_4765_: f32;
    var phi_4772_: f32;
    var phi_4783_: f32;
    var phi_4793_: f32;
    var phi_4794_: f32;
    var phi_4797_: bool;
    var phi_4804_: bool;
    var phi_4805_: bool;
    var phi_4810_: type_9;
    var phi_4811_: type_9;
    var phi_4834_: type_9;
    var phi_4905_: type_43;
    var phi_5039_: type_39;
    var phi_5418_: f32;
    var phi_5425_: f32;
    var phi_5430_: f32;
    var phi_5437_: f32;
    var phi_5442_: f32;
    var phi_5455_: f32;
    var phi_5462_: f32;
    var phi_5467_: f32;
    var phi_5474_: f32;
    var phi_5479_: f32;
    var phi_5484_: f32;
    var phi_5501_: f32;
    var phi_5508_: f32;
    var phi_5513_: f32;
    var phi_5520_: f32;
    var phi_5525_: f32;
    var phi_5539_: f32;
    var phi_5546_: f32;
    var phi_5551_: f32;
    var phi_5558_: f32;
    var phi_5563_: f32;
    var phi_5568_: f32;
    var phi_5585_: f32;
    var phi_5592_: f32;
    var phi_5597_: f32;
    var phi_5604_: f32;
    var phi_5609_: f32;
    var phi_5623_: f32;
    var phi_5630_: f32;
    var phi_5635_: f32;
    var phi_5642_: f32;
    var phi_5647_: f32;
    var phi_5652_: f32;
    var phi_5683_: f32;
    var phi_5689_: f32;
    var phi_5696_: f32;
    var phi_5703_: f32;
    var phi_5709_: f32;
    var phi_5716_: f32;
    var phi_5722_: f32;
    var phi_5728_: f32;
    var phi_5734_: f32;
    var phi_5741_: f32;
    var phi_5748_: f32;
    var phi_5772_: f32;
    var phi_5777_: f32;
    var phi_5782_: f32;
    var phi_5787_: f32;
    var phi_5792_: f32;
    var phi_5797_: f32;
    var phi_5807_: f32;
    var phi_5923_: array<f32, 3>;
    var phi_5988_: array<f32, 3>;
    var phi_6010_: f32;
    var phi_6017_: f32;
    var phi_6022_: f32;
    var phi_6029_: f32;
    var phi_6034_: f32;
    var phi_6047_: f32;
    var phi_6054_: f32;
    var phi_6059_: f32;
    var phi_6066_: f32;
    var phi_6071_: f32;
    var phi_6076_: f32;
    var phi_6093_: f32;
    var phi_6100_: f32;
    var phi_6105_: f32;
    var phi_6112_: f32;
    var phi_6117_: f32;
    var phi_6131_: f32;
    var phi_6138_: f32;
    var phi_6143_: f32;
    var phi_6150_: f32;
    var phi_6155_: f32;
    var phi_6160_: f32;
    var phi_6177_: f32;
    var phi_6184_: f32;
    var phi_6189_: f32;
    var phi_6196_: f32;
    var phi_6201_: f32;
    var phi_6215_: f32;
    var phi_6222_: f32;
    var phi_6227_: f32;
    var phi_6234_: f32;
    var phi_6239_: f32;
    var phi_6244_: f32;
    var phi_6323_: f32;
    var phi_6328_: f32;
    var phi_6333_: f32;
    var phi_6338_: f32;
    var phi_6343_: f32;
    var phi_6348_: f32;
    var phi_6353_: f32;
    var phi_6358_: f32;
    var phi_6363_: f32;
    var phi_6368_: f32;
    var phi_6373_: f32;
    var phi_6378_: f32;
    var phi_6383_: f32;
    var phi_6388_: f32;
    var phi_6394_: f32;
    var phi_6400_: f32;
    var phi_6407_: f32;
    var phi_6418_: f32;
    var phi_6489_: f32;
    var phi_6494_: f32;
    var phi_6499_: f32;
    var phi_6504_: f32;
    var phi_6509_: f32;
    var phi_6514_: f32;
    var phi_6519_: f32;
    var phi_6524_: f32;
    var phi_6529_: f32;
    var phi_6534_: f32;
    var phi_6539_: f32;
    var phi_6544_: f32;
    var phi_6549_: f32;
    var phi_6554_: f32;
    var phi_6560_: f32;
    var phi_6566_: f32;
    var phi_6573_: f32;
    var phi_6584_: f32;
    var phi_6594_: f32;
    var phi_6667_: f32;
    var phi_6672_: f32;
    var phi_6677_: f32;
    var phi_6682_: f32;
    var phi_6687_: f32;
    var phi_6692_: f32;
    var phi_6697_: f32;
    var phi_6702_: f32;
    var phi_6707_: f32;
    var phi_6712_: f32;
    var phi_6717_: f32;
    var phi_6722_: f32;
    var phi_6727_: f32;
    var phi_6732_: f32;
    var phi_6738_: f32;
    var phi_6744_: f32;
    var phi_6751_: f32;
    var phi_6762_: f32;
    var phi_6772_: f32;
    var phi_6773_: f32;
    var phi_6776_: bool;
    var phi_7021_: f32;
    var phi_7028_: f32;
    var phi_7033_: f32;
    var phi_7040_: f32;
    var phi_7045_: f32;
    var phi_7058_: f32;
    var phi_7065_: f32;
    var phi_7070_: f32;
    var phi_7077_: f32;
    var phi_7082_: f32;
    var phi_7087_: f32;
    var phi_7104_: f32;
    var phi_7111_: f32;
    var phi_7116_: f32;
    var phi_7123_: f32;
    var phi_7128_: f32;
    var phi_7142_: f32;
    var phi_7149_: f32;
    var phi_7154_: f32;
    var phi_7161_: f32;
    var phi_7166_: f32;
    var phi_7171_: f32;
    var phi_7188_: f32;
    var phi_7195_: f32;
    var phi_7200_: f32;
    var phi_7207_: f32;
    var phi_7212_: f32;
    var phi_7226_: f32;
    var phi_7233_: f32;
    var phi_7238_: f32;
    var phi_7245_: f32;
    var phi_7250_: f32;
    var phi_7255_: f32;
    var phi_7286_: f32;
    var phi_7292_: f32;
    var phi_7299_: f32;
    var phi_7306_: f32;
    var phi_7312_: f32;
    var phi_7319_: f32;
    var phi_7325_: f32;
    var phi_7331_: f32;
    var phi_7337_: f32;
    var phi_7344_: f32;
    var phi_7351_: f32;
    var phi_7375_: f32;
    var phi_7380_: f32;
    var phi_7385_: f32;
    var phi_7390_: f32;
    var phi_7395_: f32;
    var phi_7400_: f32;
    var phi_7410_: f32;
    var phi_7526_: array<f32, 3>;
    var phi_7591_: array<f32, 3>;
    var phi_7613_: f32;
    var phi_7620_: f32;
    var phi_7625_: f32;
    var phi_7632_: f32;
    var phi_7637_: f32;
    var phi_7650_: f32;
    var phi_7657_: f32;
    var phi_7662_: f32;
    var phi_7669_: f32;
    var phi_7674_: f32;
    var phi_7679_: f32;
    var phi_7696_: f32;
    var phi_7703_: f32;
    var phi_7708_: f32;
    var phi_7715_: f32;
    var phi_7720_: f32;
    var phi_7734_: f32;
    var phi_7741_: f32;
    var phi_7746_: f32;
    var phi_7753_: f32;
    var phi_7758_: f32;
    var phi_7763_: f32;
    var phi_7780_: f32;
    var phi_7787_: f32;
    var phi_7792_: f32;
    var phi_7799_: f32;
    var phi_7804_: f32;
    var phi_7818_: f32;
    var phi_7825_: f32;
    var phi_7830_: f32;
    var phi_7837_: f32;
    var phi_7842_: f32;
    var phi_7847_: f32;
    var phi_7926_: f32;
    var phi_7931_: f32;
    var phi_7936_: f32;
    var phi_7941_: f32;
    var phi_7946_: f32;
    var phi_7951_: f32;
    var phi_7956_: f32;
    var phi_7961_: f32;
    var phi_7966_: f32;
    var phi_7971_: f32;
    var phi_7976_: f32;
    var phi_7981_: f32;
    var phi_7986_: f32;
    var phi_7991_: f32;
    var phi_7997_: f32;
    var phi_8003_: f32;
    var phi_8010_: f32;
    var phi_8021_: f32;
    var phi_8092_: f32;
    var phi_8097_: f32;
    var phi_8102_: f32;
    var phi_8107_: f32;
    var phi_8112_: f32;
    var phi_8117_: f32;
    var phi_8122_: f32;
    var phi_8127_: f32;
    var phi_8132_: f32;
    var phi_8137_: f32;
    var phi_8142_: f32;
    var phi_8147_: f32;
    var phi_8152_: f32;
    var phi_8157_: f32;
    var phi_8163_: f32;
    var phi_8169_: f32;
    var phi_8176_: f32;
    var phi_8187_: f32;
    var phi_8197_: f32;
    var phi_8270_: f32;
    var phi_8275_: f32;
    var phi_8280_: f32;
    var phi_8285_: f32;
    var phi_8290_: f32;
    var phi_8295_: f32;
    var phi_8300_: f32;
    var phi_8305_: f32;
    var phi_8310_: f32;
    var phi_8315_: f32;
    var phi_8320_: f32;
    var phi_8325_: f32;
    var phi_8330_: f32;
    var phi_8335_: f32;
    var phi_8341_: f32;
    var phi_8347_: f32;
    var phi_8354_: f32;
    var phi_8365_: f32;
    var phi_8375_: f32;
    var phi_8376_: f32;
    var phi_8379_: bool;
    var phi_8381_: bool;
    var phi_8391_: bool;
    var phi_8392_: bool;
    var phi_8428_: type_9;
    var phi_8429_: type_9;
    var phi_8452_: type_9;
    var phi_8476_: u32;
    var phi_8528_: type_9;
    var phi_8547_: bool;
    var phi_8548_: bool;
    var phi_1346_: type_9;
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
        phi_378_ = _e96;
    } else {
        phi_378_ = _e98;
    }
    let _e101 = phi_378_;
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
            phi_427_ = (_e116 + 1u);
        } else {
            phi_427_ = _e116;
        }
        let _e122 = phi_427_;
        phi_428_ = _e122;
    } else {
        phi_428_ = 0u;
    }
    let _e124 = phi_428_;
    let _e127 = params.member.member_2.member_4;
    if (_e127 < _e124) {
        phi_436_ = _e127;
    } else {
        phi_436_ = _e124;
    }
    let _e130 = phi_436_;
    let _e131 = (_e130 / 4u);
    if ((_e130 % 4u) > 0u) {
        phi_452_ = (_e131 + 1u);
    } else {
        phi_452_ = _e131;
    }
    let _e136 = phi_452_;
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
            phi_475_ = (_e140 + 1u);
        } else {
            phi_475_ = _e140;
        }
        let _e146 = phi_475_;
        phi_476_ = _e146;
    } else {
        phi_476_ = 0u;
    }
    let _e148 = phi_476_;
    phi_479_ = type_9(0u, _e148);
    loop {
        let _e151 = phi_479_;
        if (_e151.member < _e151.member_1) {
            phi_480_ = type_9((_e151.member + 1u), _e151.member_1);
            phi_505_ = type_9(1u, _e151.member);
        } else {
            phi_480_ = _e151;
            phi_505_ = type_9(0u, type_9().member_1);
        }
        let _e163 = phi_480_;
        let _e165 = phi_505_;
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
                    phi_552_ = (_e187 + 1u);
                } else {
                    phi_552_ = _e187;
                }
                let _e193 = phi_552_;
                phi_553_ = _e193;
            } else {
                phi_553_ = 0u;
            }
            let _e195 = phi_553_;
            let _e198 = params.member.member_2.member_4;
            if (_e198 < _e195) {
                phi_561_ = _e198;
            } else {
                phi_561_ = _e195;
            }
            let _e201 = phi_561_;
            let _e202 = (_e174 < _e201);
            let _e205 = params.member.member_1.member_1;
            let _e208 = params.member.member_2.member_3;
            if _e202 {
                phi_575_ = (_e174 * _e208);
            } else {
                phi_575_ = 0u;
            }
            let _e211 = phi_575_;
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
                phi_678_ = array<u32, 2>(0u, 2u);
            } else {
                phi_678_ = array<u32, 2>(1u, 1u);
            }
            let _e248 = phi_678_;
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
                phi_839_ = ((((((_e306.member.x <= _e282.member_1.y) && (_e282.member.x <= _e306.member_1.y)) && (_e306.member.y <= _e282.member_2.x)) && (_e282.member.y <= _e306.member_2.x)) && (_e306.member_1.x <= _e282.member_2.y)) && (_e282.member_1.x <= _e306.member_2.y));
            } else {
                phi_839_ = false;
            }
            let _e358 = phi_839_;
            if _e202 {
                if ((((((_e333.member.x <= _e261.member_1.y) && (_e261.member.x <= _e333.member_1.y)) && (_e333.member.y <= _e261.member_2.x)) && (_e261.member.y <= _e333.member_2.x)) && (_e333.member_1.x <= _e261.member_2.y)) && (_e261.member_1.x <= _e333.member_2.y)) {
                    let _e372 = atomicAdd((&counters[_e251]), 1u);
                    let _e373 = ((_e251 * 32u) + _e372);
                    columns[_e373] = type_29(array<f32, 3>(_e333.member.x, _e333.member.y, _e333.member_1.x), array<f32, 3>(_e333.member_1.y, _e333.member_2.x, _e333.member_2.y));
                    names[_e373] = _e252;
                }
            }
            if _e358 {
                phi_877_ = type_29(array<f32, 3>(_e306.member.x, _e306.member.y, _e306.member_1.x), array<f32, 3>(_e306.member_1.y, _e306.member_2.x, _e306.member_2.y));
            } else {
                phi_877_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e380 = phi_877_;
            workgroupBarrier();
            let _e381 = (_e216 == _e219);
            let _e382 = (_e73 / 32u);
            let _e384 = (_e382 * 32u);
            let _e386 = atomicLoad((&counters[_e382]));
            let _e387 = (_e386 / 4u);
            if ((_e386 % 4u) > 0u) {
                phi_906_ = (_e387 + 1u);
            } else {
                phi_906_ = _e387;
            }
            let _e392 = phi_906_;
            phi_909_ = type_9(0u, _e392);
            phi_912_ = 0u;
            loop {
                let _e395 = phi_909_;
                let _e397 = phi_912_;
                local_3 = _e397;
                local_6 = _e397;
                if (_e395.member < _e395.member_1) {
                    phi_910_ = type_9((_e395.member + 1u), _e395.member_1);
                    phi_935_ = type_9(1u, _e395.member);
                } else {
                    phi_910_ = _e395;
                    phi_935_ = type_9(0u, type_9().member_1);
                }
                let _e409 = phi_910_;
                let _e411 = phi_935_;
                let _e415 = (bitcast<i32>(_e411.member) != 0i);
                if _e415 {
                    let _e416 = (4u * _e411.member_1);
                    let _e419 = columns[(_e384 + _e416)];
                    let _e458 = columns[((_e384 + _e416) + 1u)];
                    let _e499 = columns[((_e384 + _e416) + 2u)];
                    let _e540 = columns[((_e384 + _e416) + 3u)];
                    phi_913_ = (_e397 | ((((select(0u, 1u, ((((((_e380.member[0] <= _e419.member_1[0]) && (_e419.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e419.member_1[1])) && (_e419.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e419.member_1[2])) && (_e419.member[2] <= _e380.member_1[2]))) << bitcast<u32>((_e416 & 31u))) | (select(0u, 1u, ((((((_e380.member[0] <= _e458.member_1[0]) && (_e458.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e458.member_1[1])) && (_e458.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e458.member_1[2])) && (_e458.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e416 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e380.member[0] <= _e499.member_1[0]) && (_e499.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e499.member_1[1])) && (_e499.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e499.member_1[2])) && (_e499.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e416 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e380.member[0] <= _e540.member_1[0]) && (_e540.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e540.member_1[1])) && (_e540.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e540.member_1[2])) && (_e540.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e416 + 3u) & 31u)))));
                } else {
                    phi_913_ = u32();
                }
                let _e580 = phi_913_;
                continue;
                continuing {
                    phi_909_ = _e409;
                    phi_912_ = _e580;
                    break if !(_e415);
                }
            }
            if (_e386 < 32u) {
                let _e588 = local_3;
                phi_1124_ = (_e588 & ((1u << bitcast<u32>((_e386 & 31u))) - 1u));
            } else {
                let _e5557 = local_6;
                phi_1124_ = _e5557;
            }
            let _e591 = phi_1124_;
            if _e381 {
                phi_1230_ = type_9(0u, _e386);
                phi_1233_ = _e591;
                loop {
                    let _e594 = phi_1230_;
                    let _e596 = phi_1233_;
                    local_7 = _e596;
                    if (_e594.member < _e594.member_1) {
                        phi_1231_ = type_9((_e594.member + 1u), _e594.member_1);
                        phi_1256_ = type_9(1u, _e594.member);
                    } else {
                        phi_1231_ = _e594;
                        phi_1256_ = type_9(0u, type_9().member_1);
                    }
                    let _e608 = phi_1231_;
                    let _e610 = phi_1256_;
                    let _e614 = (bitcast<i32>(_e610.member) != 0i);
                    if _e614 {
                        let _e617 = names[(_e384 + _e610.member_1)];
                        if _e381 {
                            let _e618 = ((_e73 % 32u) < _e617);
                            if _e618 {
                                phi_1280_ = bool();
                            } else {
                                phi_1280_ = false;
                            }
                            let _e620 = phi_1280_;
                            phi_1281_ = _e620;
                            phi_1282_ = _e618;
                        } else {
                            phi_1281_ = bool();
                            phi_1282_ = true;
                        }
                        let _e622 = phi_1281_;
                        let _e624 = phi_1282_;
                        if _e624 {
                            phi_1286_ = true;
                        } else {
                            phi_1286_ = _e622;
                        }
                        let _e626 = phi_1286_;
                        if _e626 {
                            phi_1294_ = false;
                        } else {
                            phi_1294_ = true;
                        }
                        let _e628 = phi_1294_;
                        if _e628 {
                            phi_1302_ = (_e596 & ~((1u << bitcast<u32>((_e610.member_1 & 31u)))));
                        } else {
                            phi_1302_ = _e596;
                        }
                        let _e635 = phi_1302_;
                        phi_1234_ = _e635;
                    } else {
                        phi_1234_ = u32();
                    }
                    let _e637 = phi_1234_;
                    continue;
                    continuing {
                        phi_1230_ = _e608;
                        phi_1233_ = _e637;
                        break if !(_e614);
                    }
                }
                let _e5571 = local_7;
                phi_1303_ = _e5571;
            } else {
                phi_1303_ = _e591;
            }
            let _e640 = phi_1303_;
            let _e642 = countOneBits(_e640);
            if (_e642 > 0u) {
                let _e645 = atomicAdd((&counters[4u]), _e642);
                phi_1313_ = type_9(_e640, _e645);
            } else {
                phi_1313_ = type_9(_e640, 0u);
            }
            let _e648 = phi_1313_;
            workgroupBarrier();
            if (_e73 == 0u) {
                let _e651 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e651;
            }
            let _e654 = workgroupUniformLoad((&n_hits[0u]));
            let _e655 = (_e654 / 512u);
            if ((_e654 % 512u) > 0u) {
                phi_1339_ = (_e655 + 1u);
            } else {
                phi_1339_ = _e655;
            }
            let _e660 = phi_1339_;
            phi_1342_ = type_9(0u, _e660);
            phi_1345_ = _e648;
            loop {
                let _e663 = phi_1342_;
                let _e665 = phi_1345_;
                if (_e663.member < _e663.member_1) {
                    phi_1343_ = type_9((_e663.member + 1u), _e663.member_1);
                    phi_1370_ = type_9(1u, _e663.member);
                } else {
                    phi_1343_ = _e663;
                    phi_1370_ = type_9(0u, type_9().member_1);
                }
                let _e677 = phi_1343_;
                let _e679 = phi_1370_;
                let _e683 = (bitcast<i32>(_e679.member) != 0i);
                if _e683 {
                    let _e684 = (_e73 / 32u);
                    let _e686 = (_e679.member_1 * 512u);
                    phi_1387_ = _e665;
                    phi_1390_ = type_9(0u, countOneBits(_e665.member));
                    loop {
                        let _e691 = phi_1387_;
                        let _e693 = phi_1390_;
                        local_8 = _e691;
                        if (_e693.member < _e693.member_1) {
                            phi_1391_ = type_9((_e693.member + 1u), _e693.member_1);
                            phi_1413_ = type_9(1u, _e693.member);
                        } else {
                            phi_1391_ = _e693;
                            phi_1413_ = type_9(0u, type_9().member_1);
                        }
                        let _e705 = phi_1391_;
                        let _e707 = phi_1413_;
                        if (bitcast<i32>(_e707.member) != 0i) {
                            let _e712 = (_e691.member_1 - _e686);
                            if (_e712 >= 512u) {
                                phi_1447_ = type_9();
                                phi_1448_ = false;
                            } else {
                                let _e721 = names[((_e684 * 32u) + select(firstTrailingBit(_e691.member), 32u, (_e691.member == 0u)))];
                                hits[_e712] = (((_e684 << bitcast<u32>(10i)) | ((_e73 % 32u) << bitcast<u32>(5i))) | _e721);
                                phi_1447_ = type_9((_e691.member & (_e691.member - 1u)), (_e691.member_1 + 1u));
                                phi_1448_ = true;
                            }
                            let _e737 = phi_1447_;
                            let _e739 = phi_1448_;
                            phi_1388_ = _e737;
                            phi_1449_ = _e739;
                        } else {
                            phi_1388_ = type_9();
                            phi_1449_ = false;
                        }
                        let _e741 = phi_1388_;
                        let _e743 = phi_1449_;
                        continue;
                        continuing {
                            phi_1387_ = _e741;
                            phi_1390_ = _e705;
                            break if !(_e743);
                        }
                    }
                    workgroupBarrier();
                    let _e746 = n_hits[0u];
                    let _e747 = (_e746 - _e686);
                    if (512u < _e747) {
                        phi_1457_ = 512u;
                    } else {
                        phi_1457_ = _e747;
                    }
                    let _e750 = phi_1457_;
                    phi_1460_ = type_9(0u, 4u);
                    loop {
                        let _e752 = phi_1460_;
                        if (_e752.member < _e752.member_1) {
                            phi_1461_ = type_9((_e752.member + 1u), _e752.member_1);
                            phi_1486_ = type_9(1u, _e752.member);
                        } else {
                            phi_1461_ = _e752;
                            phi_1486_ = type_9(0u, type_9().member_1);
                        }
                        let _e764 = phi_1461_;
                        let _e766 = phi_1486_;
                        if (bitcast<i32>(_e766.member) != 0i) {
                            let _e772 = (_e73 + (_e766.member_1 * 128u));
                            if (_e772 >= _e750) {
                                phi_2924_ = false;
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
                                        phi_1642_ = true;
                                    } else {
                                        phi_1642_ = (_e799.x == _e793.y);
                                    }
                                    let _e854 = phi_1642_;
                                    if (_e799.y == _e793.x) {
                                        phi_1648_ = true;
                                    } else {
                                        phi_1648_ = (_e799.y == _e793.y);
                                    }
                                    let _e858 = phi_1648_;
                                    if (_e854 || _e858) {
                                        phi_1654_ = false;
                                    } else {
                                        phi_1654_ = true;
                                    }
                                    let _e861 = phi_1654_;
                                    phi_1655_ = _e861;
                                } else {
                                    phi_1655_ = true;
                                }
                                let _e863 = phi_1655_;
                                if _e863 {
                                    if ((_e91.member_1 & 2u) != 0u) {
                                        let _e868 = bodies.member[_e793.x];
                                        let _e870 = bodies.member[_e799.x];
                                        if ((_e868 / 4u) != (_e870 / 4u)) {
                                            phi_1697_ = true;
                                        } else {
                                            if ((_e868 & 2u) == 0u) {
                                                phi_1696_ = false;
                                            } else {
                                                phi_1696_ = true;
                                            }
                                            let _e877 = phi_1696_;
                                            phi_1697_ = _e877;
                                        }
                                        let _e879 = phi_1697_;
                                        if _e879 {
                                            phi_1704_ = (((_e868 & _e870) & 1u) == 0u);
                                        } else {
                                            phi_1704_ = false;
                                        }
                                        let _e884 = phi_1704_;
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
                                                        phi_1818_ = true;
                                                    } else {
                                                        phi_1818_ = ((_e868 >> bitcast<u32>(2i)) == (_e870 >> bitcast<u32>(2i)));
                                                    }
                                                    let _e937 = phi_1818_;
                                                    phi_1819_ = _e937;
                                                } else {
                                                    phi_1819_ = false;
                                                }
                                                let _e939 = phi_1819_;
                                                if _e939 {
                                                    let _e942 = bodies.member[(_e91.member[0] + 2u)];
                                                    let _e945 = bodies.member[(_e91.member[0] + 3u)];
                                                    let _e946 = (_e945 + _e91.member[0]);
                                                    if (_e799.w < _e793.w) {
                                                        phi_1854_ = _e793.w;
                                                        phi_1855_ = _e799.w;
                                                    } else {
                                                        phi_1854_ = _e799.w;
                                                        phi_1855_ = _e793.w;
                                                    }
                                                    let _e949 = phi_1854_;
                                                    let _e951 = phi_1855_;
                                                    phi_1860_ = type_15(0i, 32i);
                                                    phi_1863_ = _e942;
                                                    phi_1865_ = 0u;
                                                    loop {
                                                        let _e953 = phi_1860_;
                                                        let _e955 = phi_1863_;
                                                        let _e957 = phi_1865_;
                                                        local_4 = _e957;
                                                        local_5 = _e957;
                                                        if (_e953.member < _e953.member_1) {
                                                            let _e964 = (_e953.member + 1i);
                                                            if ((false == (_e964 > _e953.member)) != false) {
                                                                phi_1886_ = true;
                                                            } else {
                                                                phi_1886_ = false;
                                                            }
                                                            let _e969 = phi_1886_;
                                                            if _e969 {
                                                                phi_1892_ = type_16(0u, type_16().member_1);
                                                            } else {
                                                                phi_1892_ = type_16(1u, _e964);
                                                            }
                                                            let _e974 = phi_1892_;
                                                            phi_1861_ = type_15(_e974.member_1, _e953.member_1);
                                                            phi_1906_ = type_16(1u, _e953.member);
                                                        } else {
                                                            phi_1861_ = _e953;
                                                            phi_1906_ = type_16(0u, type_16().member_1);
                                                        }
                                                        let _e980 = phi_1861_;
                                                        let _e982 = phi_1906_;
                                                        if (bitcast<i32>(_e982.member) != 0i) {
                                                            if (_e957 >= _e955) {
                                                                phi_1989_ = u32();
                                                                phi_1990_ = u32();
                                                                phi_1991_ = false;
                                                            } else {
                                                                let _e989 = (_e957 + ((_e955 - _e957) / 2u));
                                                                let _e991 = (_e946 + (3u * _e989));
                                                                let _e993 = bodies.member[_e991];
                                                                let _e996 = bodies.member[(_e991 + 1u)];
                                                                let _e999 = bodies.member[(_e991 + 2u)];
                                                                if (_e993 < 1u) {
                                                                    phi_1982_ = true;
                                                                } else {
                                                                    if (_e993 == 1u) {
                                                                        if (_e996 < _e951) {
                                                                            phi_1976_ = false;
                                                                        } else {
                                                                            if (_e996 == _e951) {
                                                                                if (_e999 < _e949) {
                                                                                    phi_1974_ = false;
                                                                                } else {
                                                                                    phi_1974_ = true;
                                                                                }
                                                                                let _e1006 = phi_1974_;
                                                                                phi_1975_ = _e1006;
                                                                            } else {
                                                                                phi_1975_ = true;
                                                                            }
                                                                            let _e1008 = phi_1975_;
                                                                            phi_1976_ = _e1008;
                                                                        }
                                                                        let _e1010 = phi_1976_;
                                                                        phi_1977_ = _e1010;
                                                                    } else {
                                                                        phi_1977_ = true;
                                                                    }
                                                                    let _e1012 = phi_1977_;
                                                                    if _e1012 {
                                                                        phi_1981_ = false;
                                                                    } else {
                                                                        phi_1981_ = true;
                                                                    }
                                                                    let _e1014 = phi_1981_;
                                                                    phi_1982_ = _e1014;
                                                                }
                                                                let _e1016 = phi_1982_;
                                                                if _e1016 {
                                                                    phi_1987_ = _e955;
                                                                    phi_1988_ = (_e989 + 1u);
                                                                } else {
                                                                    phi_1987_ = _e989;
                                                                    phi_1988_ = _e957;
                                                                }
                                                                let _e1019 = phi_1987_;
                                                                let _e1021 = phi_1988_;
                                                                phi_1989_ = _e1019;
                                                                phi_1990_ = _e1021;
                                                                phi_1991_ = true;
                                                            }
                                                            let _e1023 = phi_1989_;
                                                            let _e1025 = phi_1990_;
                                                            let _e1027 = phi_1991_;
                                                            phi_1864_ = _e1023;
                                                            phi_1866_ = _e1025;
                                                            phi_1992_ = _e1027;
                                                        } else {
                                                            phi_1864_ = u32();
                                                            phi_1866_ = u32();
                                                            phi_1992_ = false;
                                                        }
                                                        let _e1029 = phi_1864_;
                                                        let _e1031 = phi_1866_;
                                                        let _e1033 = phi_1992_;
                                                        continue;
                                                        continuing {
                                                            phi_1860_ = _e980;
                                                            phi_1863_ = _e1029;
                                                            phi_1865_ = _e1031;
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
                                                                phi_2040_ = (_e1051 == _e949);
                                                                phi_2041_ = false;
                                                            } else {
                                                                phi_2040_ = bool();
                                                                phi_2041_ = true;
                                                            }
                                                            let _e1054 = phi_2040_;
                                                            let _e1056 = phi_2041_;
                                                            phi_2042_ = _e1054;
                                                            phi_2043_ = _e1056;
                                                        } else {
                                                            phi_2042_ = bool();
                                                            phi_2043_ = true;
                                                        }
                                                        let _e1058 = phi_2042_;
                                                        let _e1060 = phi_2043_;
                                                        if _e1060 {
                                                            phi_2047_ = false;
                                                        } else {
                                                            phi_2047_ = _e1058;
                                                        }
                                                        let _e1062 = phi_2047_;
                                                        phi_2048_ = _e1062;
                                                    } else {
                                                        phi_2048_ = false;
                                                    }
                                                    let _e1064 = phi_2048_;
                                                    phi_2052_ = _e1064;
                                                } else {
                                                    phi_2052_ = true;
                                                }
                                                let _e1066 = phi_2052_;
                                                if _e1066 {
                                                    phi_2056_ = false;
                                                } else {
                                                    phi_2056_ = true;
                                                }
                                                let _e1068 = phi_2056_;
                                                phi_2057_ = _e1068;
                                            } else {
                                                phi_2057_ = true;
                                            }
                                            let _e1070 = phi_2057_;
                                            if _e1070 {
                                                phi_2061_ = false;
                                            } else {
                                                phi_2061_ = true;
                                            }
                                            let _e1072 = phi_2061_;
                                            phi_2062_ = _e1072;
                                        } else {
                                            phi_2062_ = true;
                                        }
                                        let _e1074 = phi_2062_;
                                        if _e1074 {
                                            phi_2066_ = false;
                                        } else {
                                            phi_2066_ = true;
                                        }
                                        let _e1076 = phi_2066_;
                                        phi_2067_ = _e1076;
                                    } else {
                                        phi_2067_ = true;
                                    }
                                    let _e1078 = phi_2067_;
                                    if _e1078 {
                                        if ((_e91.member_1 & 32u) != 0u) {
                                            let _e1099 = (((((_e821.member_1.y - _e835.member.x) > _e91.member_6) && ((_e835.member_1.y - _e821.member.x) > _e91.member_6)) && (((_e821.member_2.x - _e835.member.y) > _e91.member_6) && ((_e835.member_2.x - _e821.member.y) > _e91.member_6))) && (((_e821.member_2.y - _e835.member_1.x) > _e91.member_6) && ((_e835.member_2.y - _e821.member_1.x) > _e91.member_6)));
                                            if _e1099 {
                                                phi_2631_ = bool();
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
                                                    phi_2184_ = true;
                                                } else {
                                                    if (_e1110[1] == _e1121[1]) {
                                                        phi_2183_ = (_e1110[0] > _e1121[0]);
                                                    } else {
                                                        phi_2183_ = false;
                                                    }
                                                    let _e1132 = phi_2183_;
                                                    phi_2184_ = _e1132;
                                                }
                                                let _e1134 = phi_2184_;
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
                                                    phi_2272_ = true;
                                                } else {
                                                    if (_e1146[1] == _e1157[1]) {
                                                        phi_2271_ = (_e1146[0] > _e1157[0]);
                                                    } else {
                                                        phi_2271_ = false;
                                                    }
                                                    let _e1168 = phi_2271_;
                                                    phi_2272_ = _e1168;
                                                }
                                                let _e1170 = phi_2272_;
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
                                                    phi_2361_ = true;
                                                } else {
                                                    if (_e1183[1] == _e1194[1]) {
                                                        phi_2360_ = (_e1183[0] > _e1194[0]);
                                                    } else {
                                                        phi_2360_ = false;
                                                    }
                                                    let _e1205 = phi_2360_;
                                                    phi_2361_ = _e1205;
                                                }
                                                let _e1207 = phi_2361_;
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
                                                    phi_2449_ = true;
                                                } else {
                                                    if (_e1219[1] == _e1230[1]) {
                                                        phi_2448_ = (_e1219[0] > _e1230[0]);
                                                    } else {
                                                        phi_2448_ = false;
                                                    }
                                                    let _e1241 = phi_2448_;
                                                    phi_2449_ = _e1241;
                                                }
                                                let _e1243 = phi_2449_;
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
                                                    phi_2539_ = true;
                                                } else {
                                                    if (_e1257[1] == _e1268[1]) {
                                                        phi_2538_ = (_e1257[0] > _e1268[0]);
                                                    } else {
                                                        phi_2538_ = false;
                                                    }
                                                    let _e1279 = phi_2538_;
                                                    phi_2539_ = _e1279;
                                                }
                                                let _e1281 = phi_2539_;
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
                                                    phi_2627_ = true;
                                                } else {
                                                    if (_e1293[1] == _e1304[1]) {
                                                        phi_2626_ = (_e1293[0] > _e1304[0]);
                                                    } else {
                                                        phi_2626_ = false;
                                                    }
                                                    let _e1315 = phi_2626_;
                                                    phi_2627_ = _e1315;
                                                }
                                                let _e1317 = phi_2627_;
                                                phi_2631_ = (((!(_e1134) && !(_e1170)) && (!(_e1207) && !(_e1243))) && (!(_e1281) && !(_e1317)));
                                            }
                                            let _e1322 = phi_2631_;
                                            phi_2632_ = _e1322;
                                            phi_2633_ = _e1099;
                                        } else {
                                            phi_2632_ = bool();
                                            phi_2633_ = true;
                                        }
                                        let _e1324 = phi_2632_;
                                        let _e1326 = phi_2633_;
                                        if _e1326 {
                                            phi_2637_ = false;
                                        } else {
                                            phi_2637_ = true;
                                        }
                                        let _e1328 = phi_2637_;
                                        phi_2638_ = _e1324;
                                        phi_2639_ = _e1328;
                                    } else {
                                        phi_2638_ = false;
                                        phi_2639_ = true;
                                    }
                                    let _e1330 = phi_2638_;
                                    let _e1332 = phi_2639_;
                                    phi_2640_ = _e1330;
                                    phi_2641_ = _e1332;
                                } else {
                                    phi_2640_ = false;
                                    phi_2641_ = true;
                                }
                                let _e1334 = phi_2640_;
                                let _e1336 = phi_2641_;
                                if _e1336 {
                                    phi_2645_ = _e1334;
                                } else {
                                    phi_2645_ = true;
                                }
                                let _e1338 = phi_2645_;
                                if _e1338 {
                                    let _e1340 = atomicAdd((&counters[9u]), 1u);
                                }
                                if _e1338 {
                                    if (_e793.w < _e799.w) {
                                        phi_2680_ = type_43(1u, array<u32, 4>(_e793.x, _e793.y, _e799.x, _e799.y));
                                    } else {
                                        phi_2680_ = type_43(1u, array<u32, 4>(_e799.x, _e799.y, _e793.x, _e793.y));
                                    }
                                    let _e1347 = phi_2680_;
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
                                        phi_2805_ = type_44(array<array<f32, 3>, 2>(array<f32, 3>(_e1441, _e1442, _e1443), array<f32, 3>(_e1445, _e1446, _e1447)), array<array<f32, 3>, 2>(array<f32, 3>(_e1450, _e1451, _e1452), array<f32, 3>(_e1454, _e1455, _e1456)));
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
                                        phi_2805_ = type_44(array<array<f32, 3>, 2>(_e1410, _e1410), array<array<f32, 3>, 2>(array<f32, 3>(_e1425, _e1426, _e1427), array<f32, 3>(_e1435, _e1436, _e1437)));
                                    }
                                    let _e1461 = phi_2805_;
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
                                        phi_2852_ = type_44(array<array<f32, 3>, 2>(array<f32, 3>(_e1486, _e1487, _e1488), array<f32, 3>(_e1490, _e1491, _e1492)), array<array<f32, 3>, 2>(array<f32, 3>(_e1495, _e1496, _e1497), array<f32, 3>(_e1499, _e1500, _e1501)));
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
                                        phi_2852_ = type_44(array<array<f32, 3>, 2>(_e1411, _e1411), array<array<f32, 3>, 2>(array<f32, 3>(_e1470, _e1471, _e1472), array<f32, 3>(_e1480, _e1481, _e1482)));
                                    }
                                    let _e1506 = phi_2852_;
                                    if !(((((((_e1461.member[0][0] - _e1461.member_1[1][0]) > _e1416) && ((_e1506.member[0][0] - _e1506.member_1[1][0]) > _e1416)) || (((_e1461.member_1[0][0] - _e1461.member[1][0]) > _e1416) && ((_e1506.member_1[0][0] - _e1506.member[1][0]) > _e1416))) || ((((_e1461.member[0][1] - _e1461.member_1[1][1]) > _e1416) && ((_e1506.member[0][1] - _e1506.member_1[1][1]) > _e1416)) || (((_e1461.member_1[0][1] - _e1461.member[1][1]) > _e1416) && ((_e1506.member_1[0][1] - _e1506.member[1][1]) > _e1416)))) || ((((_e1461.member[0][2] - _e1461.member_1[1][2]) > _e1416) && ((_e1506.member[0][2] - _e1506.member_1[1][2]) > _e1416)) || (((_e1461.member_1[0][2] - _e1461.member[1][2]) > _e1416) && ((_e1506.member_1[0][2] - _e1506.member[1][2]) > _e1416))))) {
                                        let _e1596 = atomicAdd((&counters[5u]), 1u);
                                        left[_e1596] = _e775;
                                    }
                                }
                                phi_2924_ = true;
                            }
                            let _e1599 = phi_2924_;
                            phi_2925_ = _e1599;
                        } else {
                            phi_2925_ = false;
                        }
                        let _e1601 = phi_2925_;
                        continue;
                        continuing {
                            phi_1460_ = _e764;
                            break if !(_e1601);
                        }
                    }
                    workgroupBarrier();
                    let _e1604 = atomicLoad((&counters[5u]));
                    phi_2930_ = type_9(0u, 4u);
                    loop {
                        let _e1606 = phi_2930_;
                        if (_e1606.member < _e1606.member_1) {
                            phi_2931_ = type_9((_e1606.member + 1u), _e1606.member_1);
                            phi_2954_ = type_9(1u, _e1606.member);
                        } else {
                            phi_2931_ = _e1606;
                            phi_2954_ = type_9(0u, type_9().member_1);
                        }
                        let _e1618 = phi_2931_;
                        let _e1620 = phi_2954_;
                        if (bitcast<i32>(_e1620.member) != 0i) {
                            let _e1626 = (_e73 + (_e1620.member_1 * 128u));
                            if (_e1626 >= _e1604) {
                                phi_4804_ = false;
                            } else {
                                let _e1629 = left[_e1626];
                                let _e1632 = ((_e1629 >> bitcast<u32>(10i)) & 3u);
                                let _e1639 = firsts[(2u * _e1632)];
                                let _e1644 = firsts[((2u * _e1632) + 1u)];
                                let _e1647 = leaves.member[(_e1639 + ((_e1629 >> bitcast<u32>(5i)) & 31u))];
                                let _e1652 = leaves.member[(_e1644 + (_e1629 & 31u))];
                                if (_e1647.w < _e1652.w) {
                                    phi_3025_ = type_43(1u, array<u32, 4>(_e1647.x, _e1647.y, _e1652.x, _e1652.y));
                                } else {
                                    phi_3025_ = type_43(1u, array<u32, 4>(_e1652.x, _e1652.y, _e1647.x, _e1647.y));
                                }
                                let _e1662 = phi_3025_;
                                let _e1667 = paths.member[_e1662.member_1[0]];
                                let _e1682 = paths.member[_e1662.member_1[1]];
                                let _e1697 = paths.member[_e1662.member_1[2]];
                                let _e1712 = paths.member[_e1662.member_1[3]];
                                if (_e1662.member != 0u) {
                                    phi_3159_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1697.member.x - _e1667.member.x), (_e1697.member.y - _e1667.member.y), (_e1697.member.z - _e1667.member.z)), array<f32, 3>((_e1697.member_1.x - _e1667.member_1.x), (_e1697.member_1.y - _e1667.member_1.y), (_e1697.member_1.z - _e1667.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1682.member.x - _e1667.member.x), (_e1682.member.y - _e1667.member.y), (_e1682.member.z - _e1667.member.z)), array<f32, 3>((_e1682.member_1.x - _e1667.member_1.x), (_e1682.member_1.y - _e1667.member_1.y), (_e1682.member_1.z - _e1667.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1697.member.x - _e1712.member.x), (_e1697.member.y - _e1712.member.y), (_e1697.member.z - _e1712.member.z)), array<f32, 3>((_e1697.member_1.x - _e1712.member_1.x), (_e1697.member_1.y - _e1712.member_1.y), (_e1697.member_1.z - _e1712.member_1.z))), (_e91.member_4 + _e91.member_4));
                                } else {
                                    phi_3159_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1667.member.x - _e1682.member.x), (_e1667.member.y - _e1682.member.y), (_e1667.member.z - _e1682.member.z)), array<f32, 3>((_e1667.member_1.x - _e1682.member_1.x), (_e1667.member_1.y - _e1682.member_1.y), (_e1667.member_1.z - _e1682.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1697.member.x - _e1682.member.x), (_e1697.member.y - _e1682.member.y), (_e1697.member.z - _e1682.member.z)), array<f32, 3>((_e1697.member_1.x - _e1682.member_1.x), (_e1697.member_1.y - _e1682.member_1.y), (_e1697.member_1.z - _e1682.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1712.member.x - _e1682.member.x), (_e1712.member.y - _e1682.member.y), (_e1712.member.z - _e1682.member.z)), array<f32, 3>((_e1712.member_1.x - _e1682.member_1.x), (_e1712.member_1.y - _e1682.member_1.y), (_e1712.member_1.z - _e1682.member_1.z))), (_e91.member_4 + _e91.member_4));
                                }
                                let _e1785 = phi_3159_;
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
                                    phi_3439_ = -(_e1981[0]);
                                } else {
                                    phi_3439_ = _e1981[0];
                                }
                                let _e1988 = phi_3439_;
                                if (_e1981[1] < 0f) {
                                    phi_3446_ = -(_e1981[1]);
                                } else {
                                    phi_3446_ = _e1981[1];
                                }
                                let _e1992 = phi_3446_;
                                if (_e1988 > _e1992) {
                                    phi_3451_ = _e1988;
                                } else {
                                    phi_3451_ = _e1992;
                                }
                                let _e1995 = phi_3451_;
                                if (_e1981[2] < 0f) {
                                    phi_3458_ = -(_e1981[2]);
                                } else {
                                    phi_3458_ = _e1981[2];
                                }
                                let _e1999 = phi_3458_;
                                if (_e1995 > _e1999) {
                                    phi_3463_ = _e1995;
                                } else {
                                    phi_3463_ = _e1999;
                                }
                                let _e2002 = phi_3463_;
                                let _e2005 = local_2.member[1u];
                                if (_e2005[0] < 0f) {
                                    phi_3476_ = -(_e2005[0]);
                                } else {
                                    phi_3476_ = _e2005[0];
                                }
                                let _e2012 = phi_3476_;
                                if (_e2005[1] < 0f) {
                                    phi_3483_ = -(_e2005[1]);
                                } else {
                                    phi_3483_ = _e2005[1];
                                }
                                let _e2016 = phi_3483_;
                                if (_e2012 > _e2016) {
                                    phi_3488_ = _e2012;
                                } else {
                                    phi_3488_ = _e2016;
                                }
                                let _e2019 = phi_3488_;
                                if (_e2005[2] < 0f) {
                                    phi_3495_ = -(_e2005[2]);
                                } else {
                                    phi_3495_ = _e2005[2];
                                }
                                let _e2023 = phi_3495_;
                                if (_e2019 > _e2023) {
                                    phi_3500_ = _e2019;
                                } else {
                                    phi_3500_ = _e2023;
                                }
                                let _e2026 = phi_3500_;
                                if (_e2002 > _e2026) {
                                    phi_3505_ = _e2002;
                                } else {
                                    phi_3505_ = _e2026;
                                }
                                let _e2029 = phi_3505_;
                                let _e2031 = local_2.member_3;
                                let _e2032 = (_e2029 + _e2031);
                                let _e2035 = local_2.member_1[0u];
                                if (_e2035[0] < 0f) {
                                    phi_3522_ = -(_e2035[0]);
                                } else {
                                    phi_3522_ = _e2035[0];
                                }
                                let _e2042 = phi_3522_;
                                if (_e2035[1] < 0f) {
                                    phi_3529_ = -(_e2035[1]);
                                } else {
                                    phi_3529_ = _e2035[1];
                                }
                                let _e2046 = phi_3529_;
                                if (_e2042 > _e2046) {
                                    phi_3534_ = _e2042;
                                } else {
                                    phi_3534_ = _e2046;
                                }
                                let _e2049 = phi_3534_;
                                if (_e2035[2] < 0f) {
                                    phi_3541_ = -(_e2035[2]);
                                } else {
                                    phi_3541_ = _e2035[2];
                                }
                                let _e2053 = phi_3541_;
                                if (_e2049 > _e2053) {
                                    phi_3546_ = _e2049;
                                } else {
                                    phi_3546_ = _e2053;
                                }
                                let _e2056 = phi_3546_;
                                let _e2059 = local_2.member_1[1u];
                                if (_e2059[0] < 0f) {
                                    phi_3560_ = -(_e2059[0]);
                                } else {
                                    phi_3560_ = _e2059[0];
                                }
                                let _e2066 = phi_3560_;
                                if (_e2059[1] < 0f) {
                                    phi_3567_ = -(_e2059[1]);
                                } else {
                                    phi_3567_ = _e2059[1];
                                }
                                let _e2070 = phi_3567_;
                                if (_e2066 > _e2070) {
                                    phi_3572_ = _e2066;
                                } else {
                                    phi_3572_ = _e2070;
                                }
                                let _e2073 = phi_3572_;
                                if (_e2059[2] < 0f) {
                                    phi_3579_ = -(_e2059[2]);
                                } else {
                                    phi_3579_ = _e2059[2];
                                }
                                let _e2077 = phi_3579_;
                                if (_e2073 > _e2077) {
                                    phi_3584_ = _e2073;
                                } else {
                                    phi_3584_ = _e2077;
                                }
                                let _e2080 = phi_3584_;
                                if (_e2056 > _e2080) {
                                    phi_3589_ = _e2056;
                                } else {
                                    phi_3589_ = _e2080;
                                }
                                let _e2083 = phi_3589_;
                                let _e2085 = local_2.member_3;
                                let _e2086 = (_e2083 + _e2085);
                                let _e2089 = local_2.member_2[0u];
                                if (_e2089[0] < 0f) {
                                    phi_3606_ = -(_e2089[0]);
                                } else {
                                    phi_3606_ = _e2089[0];
                                }
                                let _e2096 = phi_3606_;
                                if (_e2089[1] < 0f) {
                                    phi_3613_ = -(_e2089[1]);
                                } else {
                                    phi_3613_ = _e2089[1];
                                }
                                let _e2100 = phi_3613_;
                                if (_e2096 > _e2100) {
                                    phi_3618_ = _e2096;
                                } else {
                                    phi_3618_ = _e2100;
                                }
                                let _e2103 = phi_3618_;
                                if (_e2089[2] < 0f) {
                                    phi_3625_ = -(_e2089[2]);
                                } else {
                                    phi_3625_ = _e2089[2];
                                }
                                let _e2107 = phi_3625_;
                                if (_e2103 > _e2107) {
                                    phi_3630_ = _e2103;
                                } else {
                                    phi_3630_ = _e2107;
                                }
                                let _e2110 = phi_3630_;
                                let _e2113 = local_2.member_2[1u];
                                if (_e2113[0] < 0f) {
                                    phi_3644_ = -(_e2113[0]);
                                } else {
                                    phi_3644_ = _e2113[0];
                                }
                                let _e2120 = phi_3644_;
                                if (_e2113[1] < 0f) {
                                    phi_3651_ = -(_e2113[1]);
                                } else {
                                    phi_3651_ = _e2113[1];
                                }
                                let _e2124 = phi_3651_;
                                if (_e2120 > _e2124) {
                                    phi_3656_ = _e2120;
                                } else {
                                    phi_3656_ = _e2124;
                                }
                                let _e2127 = phi_3656_;
                                if (_e2113[2] < 0f) {
                                    phi_3663_ = -(_e2113[2]);
                                } else {
                                    phi_3663_ = _e2113[2];
                                }
                                let _e2131 = phi_3663_;
                                if (_e2127 > _e2131) {
                                    phi_3668_ = _e2127;
                                } else {
                                    phi_3668_ = _e2131;
                                }
                                let _e2134 = phi_3668_;
                                if (_e2110 > _e2134) {
                                    phi_3673_ = _e2110;
                                } else {
                                    phi_3673_ = _e2134;
                                }
                                let _e2137 = phi_3673_;
                                let _e2139 = local_2.member_3;
                                let _e2140 = (_e2137 + _e2139);
                                let _e2142 = ((_e2086 * 8f) * _e2140);
                                let _e2149 = local_2.member_3;
                                if (_e1838 < 0f) {
                                    phi_3704_ = -(_e1838);
                                } else {
                                    phi_3704_ = _e1838;
                                }
                                let _e2166 = phi_3704_;
                                if (_e1841 < 0f) {
                                    phi_3710_ = -(_e1841);
                                } else {
                                    phi_3710_ = _e1841;
                                }
                                let _e2170 = phi_3710_;
                                if (_e1844 < 0f) {
                                    phi_3717_ = -(_e1844);
                                } else {
                                    phi_3717_ = _e1844;
                                }
                                let _e2175 = phi_3717_;
                                let _e2176 = ((_e2166 + _e2170) + _e2175);
                                if (_e1859 < 0f) {
                                    phi_3724_ = -(_e1859);
                                } else {
                                    phi_3724_ = _e1859;
                                }
                                let _e2180 = phi_3724_;
                                if (_e1862 < 0f) {
                                    phi_3730_ = -(_e1862);
                                } else {
                                    phi_3730_ = _e1862;
                                }
                                let _e2184 = phi_3730_;
                                if (_e1865 < 0f) {
                                    phi_3737_ = -(_e1865);
                                } else {
                                    phi_3737_ = _e1865;
                                }
                                let _e2189 = phi_3737_;
                                let _e2190 = ((_e2180 + _e2184) + _e2189);
                                if (_e2176 > _e2190) {
                                    phi_3743_ = _e2176;
                                } else {
                                    phi_3743_ = _e2190;
                                }
                                let _e2193 = phi_3743_;
                                if (_e1908 < 0f) {
                                    phi_3749_ = -(_e1908);
                                } else {
                                    phi_3749_ = _e1908;
                                }
                                let _e2197 = phi_3749_;
                                if (_e1909 < 0f) {
                                    phi_3755_ = -(_e1909);
                                } else {
                                    phi_3755_ = _e1909;
                                }
                                let _e2201 = phi_3755_;
                                if (_e1910 < 0f) {
                                    phi_3762_ = -(_e1910);
                                } else {
                                    phi_3762_ = _e1910;
                                }
                                let _e2206 = phi_3762_;
                                let _e2208 = (((_e2197 + _e2201) + _e2206) * 0.5f);
                                if (_e2193 > _e2208) {
                                    phi_3769_ = _e2193;
                                } else {
                                    phi_3769_ = _e2208;
                                }
                                let _e2211 = phi_3769_;
                                let _e2216 = local_2.member_3;
                                let _e2229 = ((((_e1913[0] * _e1838) + (_e1913[1] * _e1841)) + (_e1913[2] * _e1844)) * 3f);
                                let _e2230 = ((((_e1970[0] * _e1859) + (_e1970[1] * _e1862)) + (_e1970[2] * _e1865)) * 3f);
                                if (_e2229 < _e2230) {
                                    phi_3793_ = _e2229;
                                } else {
                                    phi_3793_ = _e2230;
                                }
                                let _e2233 = phi_3793_;
                                if (_e1944 < _e1967) {
                                    phi_3798_ = _e1944;
                                } else {
                                    phi_3798_ = _e1967;
                                }
                                let _e2236 = phi_3798_;
                                if (_e2233 < _e2236) {
                                    phi_3803_ = _e2233;
                                } else {
                                    phi_3803_ = _e2236;
                                }
                                let _e2239 = phi_3803_;
                                if (_e2229 > _e2230) {
                                    phi_3808_ = _e2229;
                                } else {
                                    phi_3808_ = _e2230;
                                }
                                let _e2242 = phi_3808_;
                                if (_e1944 > _e1967) {
                                    phi_3813_ = _e1944;
                                } else {
                                    phi_3813_ = _e1967;
                                }
                                let _e2245 = phi_3813_;
                                if (_e2242 > _e2245) {
                                    phi_3818_ = _e2242;
                                } else {
                                    phi_3818_ = _e2245;
                                }
                                let _e2248 = phi_3818_;
                                let _e2253 = -(_e2248);
                                if (_e2239 > _e2253) {
                                    phi_3828_ = _e2239;
                                } else {
                                    phi_3828_ = _e2253;
                                }
                                let _e2256 = phi_3828_;
                                let _e2258 = ((_e2256 - ((((((_e2032 * 8f) * _e2142) * (0.000000059604645f * (524f / 64f))) + ((_e2149 * 19f) * ((_e2032 * (_e2086 + _e2140)) + (_e2086 * _e2140)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2032) * ((1f + _e2086) * (1f + _e2140))))) + ((_e91.member_5 * (((_e2211 + (_e2142 * (0.000000059604645f * 8f))) + ((_e2216 * 6f) * (_e2086 + _e2140))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2086) * (1f + _e2140))))) * (3f * 1.0001f)))) > 0f);
                                if _e2258 {
                                    phi_4797_ = _e2258;
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
                                        phi_3944_ = array<f32, 3>(_e2300[0], _e2300[1], _e2300[2]);
                                    } else {
                                        phi_3944_ = array<f32, 3>((_e2317 - _e2313[0]), (_e2318 - _e2313[1]), (_e2319 - _e2313[2]));
                                    }
                                    let _e2326 = phi_3944_;
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
                                        phi_4009_ = array<f32, 3>(_e2332[0], _e2332[1], _e2332[2]);
                                    } else {
                                        phi_4009_ = array<f32, 3>((_e2349 - _e2345[0]), (_e2350 - _e2345[1]), (_e2351 - _e2345[2]));
                                    }
                                    let _e2358 = phi_4009_;
                                    let _e2359 = (_e2332[0] - _e2345[0]);
                                    let _e2360 = (_e2332[1] - _e2345[1]);
                                    let _e2361 = (_e2332[2] - _e2345[2]);
                                    let _e2364 = local_2.member[0u];
                                    if (_e2364[0] < 0f) {
                                        phi_4031_ = -(_e2364[0]);
                                    } else {
                                        phi_4031_ = _e2364[0];
                                    }
                                    let _e2371 = phi_4031_;
                                    if (_e2364[1] < 0f) {
                                        phi_4038_ = -(_e2364[1]);
                                    } else {
                                        phi_4038_ = _e2364[1];
                                    }
                                    let _e2375 = phi_4038_;
                                    if (_e2371 > _e2375) {
                                        phi_4043_ = _e2371;
                                    } else {
                                        phi_4043_ = _e2375;
                                    }
                                    let _e2378 = phi_4043_;
                                    if (_e2364[2] < 0f) {
                                        phi_4050_ = -(_e2364[2]);
                                    } else {
                                        phi_4050_ = _e2364[2];
                                    }
                                    let _e2382 = phi_4050_;
                                    if (_e2378 > _e2382) {
                                        phi_4055_ = _e2378;
                                    } else {
                                        phi_4055_ = _e2382;
                                    }
                                    let _e2385 = phi_4055_;
                                    let _e2388 = local_2.member[1u];
                                    if (_e2388[0] < 0f) {
                                        phi_4068_ = -(_e2388[0]);
                                    } else {
                                        phi_4068_ = _e2388[0];
                                    }
                                    let _e2395 = phi_4068_;
                                    if (_e2388[1] < 0f) {
                                        phi_4075_ = -(_e2388[1]);
                                    } else {
                                        phi_4075_ = _e2388[1];
                                    }
                                    let _e2399 = phi_4075_;
                                    if (_e2395 > _e2399) {
                                        phi_4080_ = _e2395;
                                    } else {
                                        phi_4080_ = _e2399;
                                    }
                                    let _e2402 = phi_4080_;
                                    if (_e2388[2] < 0f) {
                                        phi_4087_ = -(_e2388[2]);
                                    } else {
                                        phi_4087_ = _e2388[2];
                                    }
                                    let _e2406 = phi_4087_;
                                    if (_e2402 > _e2406) {
                                        phi_4092_ = _e2402;
                                    } else {
                                        phi_4092_ = _e2406;
                                    }
                                    let _e2409 = phi_4092_;
                                    if (_e2385 > _e2409) {
                                        phi_4097_ = _e2385;
                                    } else {
                                        phi_4097_ = _e2409;
                                    }
                                    let _e2412 = phi_4097_;
                                    let _e2414 = local_2.member_3;
                                    let _e2418 = local_2.member_1[0u];
                                    if (_e2418[0] < 0f) {
                                        phi_4114_ = -(_e2418[0]);
                                    } else {
                                        phi_4114_ = _e2418[0];
                                    }
                                    let _e2425 = phi_4114_;
                                    if (_e2418[1] < 0f) {
                                        phi_4121_ = -(_e2418[1]);
                                    } else {
                                        phi_4121_ = _e2418[1];
                                    }
                                    let _e2429 = phi_4121_;
                                    if (_e2425 > _e2429) {
                                        phi_4126_ = _e2425;
                                    } else {
                                        phi_4126_ = _e2429;
                                    }
                                    let _e2432 = phi_4126_;
                                    if (_e2418[2] < 0f) {
                                        phi_4133_ = -(_e2418[2]);
                                    } else {
                                        phi_4133_ = _e2418[2];
                                    }
                                    let _e2436 = phi_4133_;
                                    if (_e2432 > _e2436) {
                                        phi_4138_ = _e2432;
                                    } else {
                                        phi_4138_ = _e2436;
                                    }
                                    let _e2439 = phi_4138_;
                                    let _e2442 = local_2.member_1[1u];
                                    if (_e2442[0] < 0f) {
                                        phi_4152_ = -(_e2442[0]);
                                    } else {
                                        phi_4152_ = _e2442[0];
                                    }
                                    let _e2449 = phi_4152_;
                                    if (_e2442[1] < 0f) {
                                        phi_4159_ = -(_e2442[1]);
                                    } else {
                                        phi_4159_ = _e2442[1];
                                    }
                                    let _e2453 = phi_4159_;
                                    if (_e2449 > _e2453) {
                                        phi_4164_ = _e2449;
                                    } else {
                                        phi_4164_ = _e2453;
                                    }
                                    let _e2456 = phi_4164_;
                                    if (_e2442[2] < 0f) {
                                        phi_4171_ = -(_e2442[2]);
                                    } else {
                                        phi_4171_ = _e2442[2];
                                    }
                                    let _e2460 = phi_4171_;
                                    if (_e2456 > _e2460) {
                                        phi_4176_ = _e2456;
                                    } else {
                                        phi_4176_ = _e2460;
                                    }
                                    let _e2463 = phi_4176_;
                                    if (_e2439 > _e2463) {
                                        phi_4181_ = _e2439;
                                    } else {
                                        phi_4181_ = _e2463;
                                    }
                                    let _e2466 = phi_4181_;
                                    let _e2468 = local_2.member_3;
                                    let _e2472 = local_2.member_2[0u];
                                    if (_e2472[0] < 0f) {
                                        phi_4198_ = -(_e2472[0]);
                                    } else {
                                        phi_4198_ = _e2472[0];
                                    }
                                    let _e2479 = phi_4198_;
                                    if (_e2472[1] < 0f) {
                                        phi_4205_ = -(_e2472[1]);
                                    } else {
                                        phi_4205_ = _e2472[1];
                                    }
                                    let _e2483 = phi_4205_;
                                    if (_e2479 > _e2483) {
                                        phi_4210_ = _e2479;
                                    } else {
                                        phi_4210_ = _e2483;
                                    }
                                    let _e2486 = phi_4210_;
                                    if (_e2472[2] < 0f) {
                                        phi_4217_ = -(_e2472[2]);
                                    } else {
                                        phi_4217_ = _e2472[2];
                                    }
                                    let _e2490 = phi_4217_;
                                    if (_e2486 > _e2490) {
                                        phi_4222_ = _e2486;
                                    } else {
                                        phi_4222_ = _e2490;
                                    }
                                    let _e2493 = phi_4222_;
                                    let _e2496 = local_2.member_2[1u];
                                    if (_e2496[0] < 0f) {
                                        phi_4236_ = -(_e2496[0]);
                                    } else {
                                        phi_4236_ = _e2496[0];
                                    }
                                    let _e2503 = phi_4236_;
                                    if (_e2496[1] < 0f) {
                                        phi_4243_ = -(_e2496[1]);
                                    } else {
                                        phi_4243_ = _e2496[1];
                                    }
                                    let _e2507 = phi_4243_;
                                    if (_e2503 > _e2507) {
                                        phi_4248_ = _e2503;
                                    } else {
                                        phi_4248_ = _e2507;
                                    }
                                    let _e2510 = phi_4248_;
                                    if (_e2496[2] < 0f) {
                                        phi_4255_ = -(_e2496[2]);
                                    } else {
                                        phi_4255_ = _e2496[2];
                                    }
                                    let _e2514 = phi_4255_;
                                    if (_e2510 > _e2514) {
                                        phi_4260_ = _e2510;
                                    } else {
                                        phi_4260_ = _e2514;
                                    }
                                    let _e2517 = phi_4260_;
                                    if (_e2493 > _e2517) {
                                        phi_4265_ = _e2493;
                                    } else {
                                        phi_4265_ = _e2517;
                                    }
                                    let _e2520 = phi_4265_;
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
                                        phi_4344_ = _e2547;
                                    } else {
                                        phi_4344_ = _e2552;
                                    }
                                    let _e2591 = phi_4344_;
                                    if (_e2557 < _e2565) {
                                        phi_4349_ = _e2557;
                                    } else {
                                        phi_4349_ = _e2565;
                                    }
                                    let _e2594 = phi_4349_;
                                    if (_e2591 < _e2594) {
                                        phi_4354_ = _e2591;
                                    } else {
                                        phi_4354_ = _e2594;
                                    }
                                    let _e2597 = phi_4354_;
                                    if (_e2570 < _e2575) {
                                        phi_4359_ = _e2570;
                                    } else {
                                        phi_4359_ = _e2575;
                                    }
                                    let _e2600 = phi_4359_;
                                    if (_e2580 < _e2588) {
                                        phi_4364_ = _e2580;
                                    } else {
                                        phi_4364_ = _e2588;
                                    }
                                    let _e2603 = phi_4364_;
                                    if (_e2600 < _e2603) {
                                        phi_4369_ = _e2600;
                                    } else {
                                        phi_4369_ = _e2603;
                                    }
                                    let _e2606 = phi_4369_;
                                    if (_e2597 < _e2606) {
                                        phi_4374_ = _e2597;
                                    } else {
                                        phi_4374_ = _e2606;
                                    }
                                    let _e2609 = phi_4374_;
                                    if (_e2547 > _e2552) {
                                        phi_4379_ = _e2547;
                                    } else {
                                        phi_4379_ = _e2552;
                                    }
                                    let _e2612 = phi_4379_;
                                    if (_e2557 > _e2565) {
                                        phi_4384_ = _e2557;
                                    } else {
                                        phi_4384_ = _e2565;
                                    }
                                    let _e2615 = phi_4384_;
                                    if (_e2612 > _e2615) {
                                        phi_4389_ = _e2612;
                                    } else {
                                        phi_4389_ = _e2615;
                                    }
                                    let _e2618 = phi_4389_;
                                    if (_e2570 > _e2575) {
                                        phi_4394_ = _e2570;
                                    } else {
                                        phi_4394_ = _e2575;
                                    }
                                    let _e2621 = phi_4394_;
                                    if (_e2580 > _e2588) {
                                        phi_4399_ = _e2580;
                                    } else {
                                        phi_4399_ = _e2588;
                                    }
                                    let _e2624 = phi_4399_;
                                    if (_e2621 > _e2624) {
                                        phi_4404_ = _e2621;
                                    } else {
                                        phi_4404_ = _e2624;
                                    }
                                    let _e2627 = phi_4404_;
                                    if (_e2618 > _e2627) {
                                        phi_4409_ = _e2618;
                                    } else {
                                        phi_4409_ = _e2627;
                                    }
                                    let _e2630 = phi_4409_;
                                    if (_e2536 < 0f) {
                                        phi_4415_ = -(_e2536);
                                    } else {
                                        phi_4415_ = _e2536;
                                    }
                                    let _e2634 = phi_4415_;
                                    if (_e2539 < 0f) {
                                        phi_4421_ = -(_e2539);
                                    } else {
                                        phi_4421_ = _e2539;
                                    }
                                    let _e2638 = phi_4421_;
                                    if (_e2542 < 0f) {
                                        phi_4428_ = -(_e2542);
                                    } else {
                                        phi_4428_ = _e2542;
                                    }
                                    let _e2643 = phi_4428_;
                                    let _e2644 = ((_e2634 + _e2638) + _e2643);
                                    let _e2649 = -(_e2630);
                                    if (_e2609 > _e2649) {
                                        phi_4439_ = _e2609;
                                    } else {
                                        phi_4439_ = _e2649;
                                    }
                                    let _e2652 = phi_4439_;
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
                                        phi_4510_ = _e2671;
                                    } else {
                                        phi_4510_ = _e2676;
                                    }
                                    let _e2715 = phi_4510_;
                                    if (_e2681 < _e2689) {
                                        phi_4515_ = _e2681;
                                    } else {
                                        phi_4515_ = _e2689;
                                    }
                                    let _e2718 = phi_4515_;
                                    if (_e2715 < _e2718) {
                                        phi_4520_ = _e2715;
                                    } else {
                                        phi_4520_ = _e2718;
                                    }
                                    let _e2721 = phi_4520_;
                                    if (_e2694 < _e2699) {
                                        phi_4525_ = _e2694;
                                    } else {
                                        phi_4525_ = _e2699;
                                    }
                                    let _e2724 = phi_4525_;
                                    if (_e2704 < _e2712) {
                                        phi_4530_ = _e2704;
                                    } else {
                                        phi_4530_ = _e2712;
                                    }
                                    let _e2727 = phi_4530_;
                                    if (_e2724 < _e2727) {
                                        phi_4535_ = _e2724;
                                    } else {
                                        phi_4535_ = _e2727;
                                    }
                                    let _e2730 = phi_4535_;
                                    if (_e2721 < _e2730) {
                                        phi_4540_ = _e2721;
                                    } else {
                                        phi_4540_ = _e2730;
                                    }
                                    let _e2733 = phi_4540_;
                                    if (_e2671 > _e2676) {
                                        phi_4545_ = _e2671;
                                    } else {
                                        phi_4545_ = _e2676;
                                    }
                                    let _e2736 = phi_4545_;
                                    if (_e2681 > _e2689) {
                                        phi_4550_ = _e2681;
                                    } else {
                                        phi_4550_ = _e2689;
                                    }
                                    let _e2739 = phi_4550_;
                                    if (_e2736 > _e2739) {
                                        phi_4555_ = _e2736;
                                    } else {
                                        phi_4555_ = _e2739;
                                    }
                                    let _e2742 = phi_4555_;
                                    if (_e2694 > _e2699) {
                                        phi_4560_ = _e2694;
                                    } else {
                                        phi_4560_ = _e2699;
                                    }
                                    let _e2745 = phi_4560_;
                                    if (_e2704 > _e2712) {
                                        phi_4565_ = _e2704;
                                    } else {
                                        phi_4565_ = _e2712;
                                    }
                                    let _e2748 = phi_4565_;
                                    if (_e2745 > _e2748) {
                                        phi_4570_ = _e2745;
                                    } else {
                                        phi_4570_ = _e2748;
                                    }
                                    let _e2751 = phi_4570_;
                                    if (_e2742 > _e2751) {
                                        phi_4575_ = _e2742;
                                    } else {
                                        phi_4575_ = _e2751;
                                    }
                                    let _e2754 = phi_4575_;
                                    if (_e2660 < 0f) {
                                        phi_4581_ = -(_e2660);
                                    } else {
                                        phi_4581_ = _e2660;
                                    }
                                    let _e2758 = phi_4581_;
                                    if (_e2663 < 0f) {
                                        phi_4587_ = -(_e2663);
                                    } else {
                                        phi_4587_ = _e2663;
                                    }
                                    let _e2762 = phi_4587_;
                                    if (_e2666 < 0f) {
                                        phi_4594_ = -(_e2666);
                                    } else {
                                        phi_4594_ = _e2666;
                                    }
                                    let _e2767 = phi_4594_;
                                    let _e2768 = ((_e2758 + _e2762) + _e2767);
                                    let _e2773 = -(_e2754);
                                    if (_e2733 > _e2773) {
                                        phi_4605_ = _e2733;
                                    } else {
                                        phi_4605_ = _e2773;
                                    }
                                    let _e2776 = phi_4605_;
                                    let _e2781 = (((_e2776 - ((_e2768 * _e2526) * (0.000000059604645f * (17f / 2f)))) - (_e2768 * _e2533)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e2657 > _e2781) {
                                        phi_4615_ = _e2657;
                                    } else {
                                        phi_4615_ = _e2781;
                                    }
                                    let _e2784 = phi_4615_;
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
                                            phi_4688_ = _e2802;
                                        } else {
                                            phi_4688_ = _e2807;
                                        }
                                        let _e2846 = phi_4688_;
                                        if (_e2812 < _e2820) {
                                            phi_4693_ = _e2812;
                                        } else {
                                            phi_4693_ = _e2820;
                                        }
                                        let _e2849 = phi_4693_;
                                        if (_e2846 < _e2849) {
                                            phi_4698_ = _e2846;
                                        } else {
                                            phi_4698_ = _e2849;
                                        }
                                        let _e2852 = phi_4698_;
                                        if (_e2825 < _e2830) {
                                            phi_4703_ = _e2825;
                                        } else {
                                            phi_4703_ = _e2830;
                                        }
                                        let _e2855 = phi_4703_;
                                        if (_e2835 < _e2843) {
                                            phi_4708_ = _e2835;
                                        } else {
                                            phi_4708_ = _e2843;
                                        }
                                        let _e2858 = phi_4708_;
                                        if (_e2855 < _e2858) {
                                            phi_4713_ = _e2855;
                                        } else {
                                            phi_4713_ = _e2858;
                                        }
                                        let _e2861 = phi_4713_;
                                        if (_e2852 < _e2861) {
                                            phi_4718_ = _e2852;
                                        } else {
                                            phi_4718_ = _e2861;
                                        }
                                        let _e2864 = phi_4718_;
                                        if (_e2802 > _e2807) {
                                            phi_4723_ = _e2802;
                                        } else {
                                            phi_4723_ = _e2807;
                                        }
                                        let _e2867 = phi_4723_;
                                        if (_e2812 > _e2820) {
                                            phi_4728_ = _e2812;
                                        } else {
                                            phi_4728_ = _e2820;
                                        }
                                        let _e2870 = phi_4728_;
                                        if (_e2867 > _e2870) {
                                            phi_4733_ = _e2867;
                                        } else {
                                            phi_4733_ = _e2870;
                                        }
                                        let _e2873 = phi_4733_;
                                        if (_e2825 > _e2830) {
                                            phi_4738_ = _e2825;
                                        } else {
                                            phi_4738_ = _e2830;
                                        }
                                        let _e2876 = phi_4738_;
                                        if (_e2835 > _e2843) {
                                            phi_4743_ = _e2835;
                                        } else {
                                            phi_4743_ = _e2843;
                                        }
                                        let _e2879 = phi_4743_;
                                        if (_e2876 > _e2879) {
                                            phi_4748_ = _e2876;
                                        } else {
                                            phi_4748_ = _e2879;
                                        }
                                        let _e2882 = phi_4748_;
                                        if (_e2873 > _e2882) {
                                            phi_4753_ = _e2873;
                                        } else {
                                            phi_4753_ = _e2882;
                                        }
                                        let _e2885 = phi_4753_;
                                        if (_e2791 < 0f) {
                                            phi_4759_ = -(_e2791);
                                        } else {
                                            phi_4759_ = _e2791;
                                        }
                                        let _e2889 = phi_4759_;
                                        if (_e2794 < 0f) {
                                            phi_4765_ = -(_e2794);
                                        } else {
                                            phi_4765_ = _e2794;
                                        }
                                        let _e2893 = phi_4765_;
                                        if (_e2797 < 0f) {
                                            phi_4772_ = -(_e2797);
                                        } else {
                                            phi_4772_ = _e2797;
                                        }
                                        let _e2898 = phi_4772_;
                                        let _e2899 = ((_e2889 + _e2893) + _e2898);
                                        let _e2904 = -(_e2885);
                                        if (_e2864 > _e2904) {
                                            phi_4783_ = _e2864;
                                        } else {
                                            phi_4783_ = _e2904;
                                        }
                                        let _e2907 = phi_4783_;
                                        let _e2912 = (((_e2907 - ((_e2899 * _e2526) * (0.000000059604645f * (17f / 2f)))) - (_e2899 * _e2533)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e2784 > _e2912) {
                                            phi_4793_ = _e2784;
                                        } else {
                                            phi_4793_ = _e2912;
                                        }
                                        let _e2915 = phi_4793_;
                                        phi_4794_ = _e2915;
                                    } else {
                                        phi_4794_ = _e2784;
                                    }
                                    let _e2917 = phi_4794_;
                                    phi_4797_ = (_e2258 || (_e2917 > 0f));
                                }
                                let _e2921 = phi_4797_;
                                if _e2921 {
                                } else {
                                    let _e2923 = atomicAdd((&counters[6u]), 1u);
                                    hits[_e2923] = _e1629;
                                }
                                phi_4804_ = true;
                            }
                            let _e2926 = phi_4804_;
                            phi_4805_ = _e2926;
                        } else {
                            phi_4805_ = false;
                        }
                        let _e2928 = phi_4805_;
                        continue;
                        continuing {
                            phi_2930_ = _e1618;
                            break if !(_e2928);
                        }
                    }
                    workgroupBarrier();
                    let _e2931 = atomicLoad((&counters[6u]));
                    phi_4810_ = type_9(0u, 4u);
                    loop {
                        let _e2933 = phi_4810_;
                        if (_e2933.member < _e2933.member_1) {
                            phi_4811_ = type_9((_e2933.member + 1u), _e2933.member_1);
                            phi_4834_ = type_9(1u, _e2933.member);
                        } else {
                            phi_4811_ = _e2933;
                            phi_4834_ = type_9(0u, type_9().member_1);
                        }
                        let _e2945 = phi_4811_;
                        let _e2947 = phi_4834_;
                        if (bitcast<i32>(_e2947.member) != 0i) {
                            let _e2953 = (_e73 + (_e2947.member_1 * 128u));
                            if (_e2953 >= _e2931) {
                                phi_8391_ = false;
                            } else {
                                let _e2956 = hits[_e2953];
                                let _e2959 = ((_e2956 >> bitcast<u32>(10i)) & 3u);
                                let _e2966 = firsts[(2u * _e2959)];
                                let _e2971 = firsts[((2u * _e2959) + 1u)];
                                let _e2974 = leaves.member[(_e2966 + ((_e2956 >> bitcast<u32>(5i)) & 31u))];
                                let _e2979 = leaves.member[(_e2971 + (_e2956 & 31u))];
                                if (_e2974.w < _e2979.w) {
                                    phi_4905_ = type_43(1u, array<u32, 4>(_e2974.x, _e2974.y, _e2979.x, _e2979.y));
                                } else {
                                    phi_4905_ = type_43(1u, array<u32, 4>(_e2979.x, _e2979.y, _e2974.x, _e2974.y));
                                }
                                let _e2989 = phi_4905_;
                                let _e2994 = paths.member[_e2989.member_1[0]];
                                let _e3009 = paths.member[_e2989.member_1[1]];
                                let _e3024 = paths.member[_e2989.member_1[2]];
                                let _e3039 = paths.member[_e2989.member_1[3]];
                                if (_e2989.member != 0u) {
                                    phi_5039_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e3024.member.x - _e2994.member.x), (_e3024.member.y - _e2994.member.y), (_e3024.member.z - _e2994.member.z)), array<f32, 3>((_e3024.member_1.x - _e2994.member_1.x), (_e3024.member_1.y - _e2994.member_1.y), (_e3024.member_1.z - _e2994.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3009.member.x - _e2994.member.x), (_e3009.member.y - _e2994.member.y), (_e3009.member.z - _e2994.member.z)), array<f32, 3>((_e3009.member_1.x - _e2994.member_1.x), (_e3009.member_1.y - _e2994.member_1.y), (_e3009.member_1.z - _e2994.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3024.member.x - _e3039.member.x), (_e3024.member.y - _e3039.member.y), (_e3024.member.z - _e3039.member.z)), array<f32, 3>((_e3024.member_1.x - _e3039.member_1.x), (_e3024.member_1.y - _e3039.member_1.y), (_e3024.member_1.z - _e3039.member_1.z))), (_e91.member_4 + _e91.member_4));
                                } else {
                                    phi_5039_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e2994.member.x - _e3009.member.x), (_e2994.member.y - _e3009.member.y), (_e2994.member.z - _e3009.member.z)), array<f32, 3>((_e2994.member_1.x - _e3009.member_1.x), (_e2994.member_1.y - _e3009.member_1.y), (_e2994.member_1.z - _e3009.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3024.member.x - _e3009.member.x), (_e3024.member.y - _e3009.member.y), (_e3024.member.z - _e3009.member.z)), array<f32, 3>((_e3024.member_1.x - _e3009.member_1.x), (_e3024.member_1.y - _e3009.member_1.y), (_e3024.member_1.z - _e3009.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3039.member.x - _e3009.member.x), (_e3039.member.y - _e3009.member.y), (_e3039.member.z - _e3009.member.z)), array<f32, 3>((_e3039.member_1.x - _e3009.member_1.x), (_e3039.member_1.y - _e3009.member_1.y), (_e3039.member_1.z - _e3009.member_1.z))), (_e91.member_4 + _e91.member_4));
                                }
                                let _e3112 = phi_5039_;
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
                                    phi_5418_ = -(_e3370[0]);
                                } else {
                                    phi_5418_ = _e3370[0];
                                }
                                let _e3377 = phi_5418_;
                                if (_e3370[1] < 0f) {
                                    phi_5425_ = -(_e3370[1]);
                                } else {
                                    phi_5425_ = _e3370[1];
                                }
                                let _e3381 = phi_5425_;
                                if (_e3377 > _e3381) {
                                    phi_5430_ = _e3377;
                                } else {
                                    phi_5430_ = _e3381;
                                }
                                let _e3384 = phi_5430_;
                                if (_e3370[2] < 0f) {
                                    phi_5437_ = -(_e3370[2]);
                                } else {
                                    phi_5437_ = _e3370[2];
                                }
                                let _e3388 = phi_5437_;
                                if (_e3384 > _e3388) {
                                    phi_5442_ = _e3384;
                                } else {
                                    phi_5442_ = _e3388;
                                }
                                let _e3391 = phi_5442_;
                                let _e3394 = local.member[1u];
                                if (_e3394[0] < 0f) {
                                    phi_5455_ = -(_e3394[0]);
                                } else {
                                    phi_5455_ = _e3394[0];
                                }
                                let _e3401 = phi_5455_;
                                if (_e3394[1] < 0f) {
                                    phi_5462_ = -(_e3394[1]);
                                } else {
                                    phi_5462_ = _e3394[1];
                                }
                                let _e3405 = phi_5462_;
                                if (_e3401 > _e3405) {
                                    phi_5467_ = _e3401;
                                } else {
                                    phi_5467_ = _e3405;
                                }
                                let _e3408 = phi_5467_;
                                if (_e3394[2] < 0f) {
                                    phi_5474_ = -(_e3394[2]);
                                } else {
                                    phi_5474_ = _e3394[2];
                                }
                                let _e3412 = phi_5474_;
                                if (_e3408 > _e3412) {
                                    phi_5479_ = _e3408;
                                } else {
                                    phi_5479_ = _e3412;
                                }
                                let _e3415 = phi_5479_;
                                if (_e3391 > _e3415) {
                                    phi_5484_ = _e3391;
                                } else {
                                    phi_5484_ = _e3415;
                                }
                                let _e3418 = phi_5484_;
                                let _e3420 = local.member_3;
                                let _e3421 = (_e3418 + _e3420);
                                let _e3424 = local.member_1[0u];
                                if (_e3424[0] < 0f) {
                                    phi_5501_ = -(_e3424[0]);
                                } else {
                                    phi_5501_ = _e3424[0];
                                }
                                let _e3431 = phi_5501_;
                                if (_e3424[1] < 0f) {
                                    phi_5508_ = -(_e3424[1]);
                                } else {
                                    phi_5508_ = _e3424[1];
                                }
                                let _e3435 = phi_5508_;
                                if (_e3431 > _e3435) {
                                    phi_5513_ = _e3431;
                                } else {
                                    phi_5513_ = _e3435;
                                }
                                let _e3438 = phi_5513_;
                                if (_e3424[2] < 0f) {
                                    phi_5520_ = -(_e3424[2]);
                                } else {
                                    phi_5520_ = _e3424[2];
                                }
                                let _e3442 = phi_5520_;
                                if (_e3438 > _e3442) {
                                    phi_5525_ = _e3438;
                                } else {
                                    phi_5525_ = _e3442;
                                }
                                let _e3445 = phi_5525_;
                                let _e3448 = local.member_1[1u];
                                if (_e3448[0] < 0f) {
                                    phi_5539_ = -(_e3448[0]);
                                } else {
                                    phi_5539_ = _e3448[0];
                                }
                                let _e3455 = phi_5539_;
                                if (_e3448[1] < 0f) {
                                    phi_5546_ = -(_e3448[1]);
                                } else {
                                    phi_5546_ = _e3448[1];
                                }
                                let _e3459 = phi_5546_;
                                if (_e3455 > _e3459) {
                                    phi_5551_ = _e3455;
                                } else {
                                    phi_5551_ = _e3459;
                                }
                                let _e3462 = phi_5551_;
                                if (_e3448[2] < 0f) {
                                    phi_5558_ = -(_e3448[2]);
                                } else {
                                    phi_5558_ = _e3448[2];
                                }
                                let _e3466 = phi_5558_;
                                if (_e3462 > _e3466) {
                                    phi_5563_ = _e3462;
                                } else {
                                    phi_5563_ = _e3466;
                                }
                                let _e3469 = phi_5563_;
                                if (_e3445 > _e3469) {
                                    phi_5568_ = _e3445;
                                } else {
                                    phi_5568_ = _e3469;
                                }
                                let _e3472 = phi_5568_;
                                let _e3474 = local.member_3;
                                let _e3475 = (_e3472 + _e3474);
                                let _e3478 = local.member_2[0u];
                                if (_e3478[0] < 0f) {
                                    phi_5585_ = -(_e3478[0]);
                                } else {
                                    phi_5585_ = _e3478[0];
                                }
                                let _e3485 = phi_5585_;
                                if (_e3478[1] < 0f) {
                                    phi_5592_ = -(_e3478[1]);
                                } else {
                                    phi_5592_ = _e3478[1];
                                }
                                let _e3489 = phi_5592_;
                                if (_e3485 > _e3489) {
                                    phi_5597_ = _e3485;
                                } else {
                                    phi_5597_ = _e3489;
                                }
                                let _e3492 = phi_5597_;
                                if (_e3478[2] < 0f) {
                                    phi_5604_ = -(_e3478[2]);
                                } else {
                                    phi_5604_ = _e3478[2];
                                }
                                let _e3496 = phi_5604_;
                                if (_e3492 > _e3496) {
                                    phi_5609_ = _e3492;
                                } else {
                                    phi_5609_ = _e3496;
                                }
                                let _e3499 = phi_5609_;
                                let _e3502 = local.member_2[1u];
                                if (_e3502[0] < 0f) {
                                    phi_5623_ = -(_e3502[0]);
                                } else {
                                    phi_5623_ = _e3502[0];
                                }
                                let _e3509 = phi_5623_;
                                if (_e3502[1] < 0f) {
                                    phi_5630_ = -(_e3502[1]);
                                } else {
                                    phi_5630_ = _e3502[1];
                                }
                                let _e3513 = phi_5630_;
                                if (_e3509 > _e3513) {
                                    phi_5635_ = _e3509;
                                } else {
                                    phi_5635_ = _e3513;
                                }
                                let _e3516 = phi_5635_;
                                if (_e3502[2] < 0f) {
                                    phi_5642_ = -(_e3502[2]);
                                } else {
                                    phi_5642_ = _e3502[2];
                                }
                                let _e3520 = phi_5642_;
                                if (_e3516 > _e3520) {
                                    phi_5647_ = _e3516;
                                } else {
                                    phi_5647_ = _e3520;
                                }
                                let _e3523 = phi_5647_;
                                if (_e3499 > _e3523) {
                                    phi_5652_ = _e3499;
                                } else {
                                    phi_5652_ = _e3523;
                                }
                                let _e3526 = phi_5652_;
                                let _e3528 = local.member_3;
                                let _e3529 = (_e3526 + _e3528);
                                let _e3531 = ((_e3475 * 8f) * _e3529);
                                let _e3538 = local.member_3;
                                if (_e3227 < 0f) {
                                    phi_5683_ = -(_e3227);
                                } else {
                                    phi_5683_ = _e3227;
                                }
                                let _e3555 = phi_5683_;
                                if (_e3230 < 0f) {
                                    phi_5689_ = -(_e3230);
                                } else {
                                    phi_5689_ = _e3230;
                                }
                                let _e3559 = phi_5689_;
                                if (_e3233 < 0f) {
                                    phi_5696_ = -(_e3233);
                                } else {
                                    phi_5696_ = _e3233;
                                }
                                let _e3564 = phi_5696_;
                                let _e3565 = ((_e3555 + _e3559) + _e3564);
                                if (_e3248 < 0f) {
                                    phi_5703_ = -(_e3248);
                                } else {
                                    phi_5703_ = _e3248;
                                }
                                let _e3569 = phi_5703_;
                                if (_e3251 < 0f) {
                                    phi_5709_ = -(_e3251);
                                } else {
                                    phi_5709_ = _e3251;
                                }
                                let _e3573 = phi_5709_;
                                if (_e3254 < 0f) {
                                    phi_5716_ = -(_e3254);
                                } else {
                                    phi_5716_ = _e3254;
                                }
                                let _e3578 = phi_5716_;
                                let _e3579 = ((_e3569 + _e3573) + _e3578);
                                if (_e3565 > _e3579) {
                                    phi_5722_ = _e3565;
                                } else {
                                    phi_5722_ = _e3579;
                                }
                                let _e3582 = phi_5722_;
                                if (_e3297 < 0f) {
                                    phi_5728_ = -(_e3297);
                                } else {
                                    phi_5728_ = _e3297;
                                }
                                let _e3586 = phi_5728_;
                                if (_e3298 < 0f) {
                                    phi_5734_ = -(_e3298);
                                } else {
                                    phi_5734_ = _e3298;
                                }
                                let _e3590 = phi_5734_;
                                if (_e3299 < 0f) {
                                    phi_5741_ = -(_e3299);
                                } else {
                                    phi_5741_ = _e3299;
                                }
                                let _e3595 = phi_5741_;
                                let _e3597 = (((_e3586 + _e3590) + _e3595) * 0.5f);
                                if (_e3582 > _e3597) {
                                    phi_5748_ = _e3582;
                                } else {
                                    phi_5748_ = _e3597;
                                }
                                let _e3600 = phi_5748_;
                                let _e3605 = local.member_3;
                                let _e3618 = ((((_e3302[0] * _e3227) + (_e3302[1] * _e3230)) + (_e3302[2] * _e3233)) * 3f);
                                let _e3619 = ((((_e3359[0] * _e3248) + (_e3359[1] * _e3251)) + (_e3359[2] * _e3254)) * 3f);
                                if (_e3618 < _e3619) {
                                    phi_5772_ = _e3618;
                                } else {
                                    phi_5772_ = _e3619;
                                }
                                let _e3622 = phi_5772_;
                                if (_e3333 < _e3356) {
                                    phi_5777_ = _e3333;
                                } else {
                                    phi_5777_ = _e3356;
                                }
                                let _e3625 = phi_5777_;
                                if (_e3622 < _e3625) {
                                    phi_5782_ = _e3622;
                                } else {
                                    phi_5782_ = _e3625;
                                }
                                let _e3628 = phi_5782_;
                                if (_e3618 > _e3619) {
                                    phi_5787_ = _e3618;
                                } else {
                                    phi_5787_ = _e3619;
                                }
                                let _e3631 = phi_5787_;
                                if (_e3333 > _e3356) {
                                    phi_5792_ = _e3333;
                                } else {
                                    phi_5792_ = _e3356;
                                }
                                let _e3634 = phi_5792_;
                                if (_e3631 > _e3634) {
                                    phi_5797_ = _e3631;
                                } else {
                                    phi_5797_ = _e3634;
                                }
                                let _e3637 = phi_5797_;
                                let _e3642 = -(_e3637);
                                if (_e3628 > _e3642) {
                                    phi_5807_ = _e3628;
                                } else {
                                    phi_5807_ = _e3642;
                                }
                                let _e3645 = phi_5807_;
                                let _e3647 = ((_e3645 - ((((((_e3421 * 8f) * _e3531) * (0.000000059604645f * (524f / 64f))) + ((_e3538 * 19f) * ((_e3421 * (_e3475 + _e3529)) + (_e3475 * _e3529)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3421) * ((1f + _e3475) * (1f + _e3529))))) + ((_e91.member_5 * (((_e3600 + (_e3531 * (0.000000059604645f * 8f))) + ((_e3605 * 6f) * (_e3475 + _e3529))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3475) * (1f + _e3529))))) * (3f * 1.0001f)))) > 0f);
                                if _e3647 {
                                    phi_6776_ = _e3647;
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
                                        phi_5923_ = array<f32, 3>(_e3689[0], _e3689[1], _e3689[2]);
                                    } else {
                                        phi_5923_ = array<f32, 3>((_e3706 - _e3702[0]), (_e3707 - _e3702[1]), (_e3708 - _e3702[2]));
                                    }
                                    let _e3715 = phi_5923_;
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
                                        phi_5988_ = array<f32, 3>(_e3721[0], _e3721[1], _e3721[2]);
                                    } else {
                                        phi_5988_ = array<f32, 3>((_e3738 - _e3734[0]), (_e3739 - _e3734[1]), (_e3740 - _e3734[2]));
                                    }
                                    let _e3747 = phi_5988_;
                                    let _e3748 = (_e3721[0] - _e3734[0]);
                                    let _e3749 = (_e3721[1] - _e3734[1]);
                                    let _e3750 = (_e3721[2] - _e3734[2]);
                                    let _e3753 = local.member[0u];
                                    if (_e3753[0] < 0f) {
                                        phi_6010_ = -(_e3753[0]);
                                    } else {
                                        phi_6010_ = _e3753[0];
                                    }
                                    let _e3760 = phi_6010_;
                                    if (_e3753[1] < 0f) {
                                        phi_6017_ = -(_e3753[1]);
                                    } else {
                                        phi_6017_ = _e3753[1];
                                    }
                                    let _e3764 = phi_6017_;
                                    if (_e3760 > _e3764) {
                                        phi_6022_ = _e3760;
                                    } else {
                                        phi_6022_ = _e3764;
                                    }
                                    let _e3767 = phi_6022_;
                                    if (_e3753[2] < 0f) {
                                        phi_6029_ = -(_e3753[2]);
                                    } else {
                                        phi_6029_ = _e3753[2];
                                    }
                                    let _e3771 = phi_6029_;
                                    if (_e3767 > _e3771) {
                                        phi_6034_ = _e3767;
                                    } else {
                                        phi_6034_ = _e3771;
                                    }
                                    let _e3774 = phi_6034_;
                                    let _e3777 = local.member[1u];
                                    if (_e3777[0] < 0f) {
                                        phi_6047_ = -(_e3777[0]);
                                    } else {
                                        phi_6047_ = _e3777[0];
                                    }
                                    let _e3784 = phi_6047_;
                                    if (_e3777[1] < 0f) {
                                        phi_6054_ = -(_e3777[1]);
                                    } else {
                                        phi_6054_ = _e3777[1];
                                    }
                                    let _e3788 = phi_6054_;
                                    if (_e3784 > _e3788) {
                                        phi_6059_ = _e3784;
                                    } else {
                                        phi_6059_ = _e3788;
                                    }
                                    let _e3791 = phi_6059_;
                                    if (_e3777[2] < 0f) {
                                        phi_6066_ = -(_e3777[2]);
                                    } else {
                                        phi_6066_ = _e3777[2];
                                    }
                                    let _e3795 = phi_6066_;
                                    if (_e3791 > _e3795) {
                                        phi_6071_ = _e3791;
                                    } else {
                                        phi_6071_ = _e3795;
                                    }
                                    let _e3798 = phi_6071_;
                                    if (_e3774 > _e3798) {
                                        phi_6076_ = _e3774;
                                    } else {
                                        phi_6076_ = _e3798;
                                    }
                                    let _e3801 = phi_6076_;
                                    let _e3803 = local.member_3;
                                    let _e3807 = local.member_1[0u];
                                    if (_e3807[0] < 0f) {
                                        phi_6093_ = -(_e3807[0]);
                                    } else {
                                        phi_6093_ = _e3807[0];
                                    }
                                    let _e3814 = phi_6093_;
                                    if (_e3807[1] < 0f) {
                                        phi_6100_ = -(_e3807[1]);
                                    } else {
                                        phi_6100_ = _e3807[1];
                                    }
                                    let _e3818 = phi_6100_;
                                    if (_e3814 > _e3818) {
                                        phi_6105_ = _e3814;
                                    } else {
                                        phi_6105_ = _e3818;
                                    }
                                    let _e3821 = phi_6105_;
                                    if (_e3807[2] < 0f) {
                                        phi_6112_ = -(_e3807[2]);
                                    } else {
                                        phi_6112_ = _e3807[2];
                                    }
                                    let _e3825 = phi_6112_;
                                    if (_e3821 > _e3825) {
                                        phi_6117_ = _e3821;
                                    } else {
                                        phi_6117_ = _e3825;
                                    }
                                    let _e3828 = phi_6117_;
                                    let _e3831 = local.member_1[1u];
                                    if (_e3831[0] < 0f) {
                                        phi_6131_ = -(_e3831[0]);
                                    } else {
                                        phi_6131_ = _e3831[0];
                                    }
                                    let _e3838 = phi_6131_;
                                    if (_e3831[1] < 0f) {
                                        phi_6138_ = -(_e3831[1]);
                                    } else {
                                        phi_6138_ = _e3831[1];
                                    }
                                    let _e3842 = phi_6138_;
                                    if (_e3838 > _e3842) {
                                        phi_6143_ = _e3838;
                                    } else {
                                        phi_6143_ = _e3842;
                                    }
                                    let _e3845 = phi_6143_;
                                    if (_e3831[2] < 0f) {
                                        phi_6150_ = -(_e3831[2]);
                                    } else {
                                        phi_6150_ = _e3831[2];
                                    }
                                    let _e3849 = phi_6150_;
                                    if (_e3845 > _e3849) {
                                        phi_6155_ = _e3845;
                                    } else {
                                        phi_6155_ = _e3849;
                                    }
                                    let _e3852 = phi_6155_;
                                    if (_e3828 > _e3852) {
                                        phi_6160_ = _e3828;
                                    } else {
                                        phi_6160_ = _e3852;
                                    }
                                    let _e3855 = phi_6160_;
                                    let _e3857 = local.member_3;
                                    let _e3861 = local.member_2[0u];
                                    if (_e3861[0] < 0f) {
                                        phi_6177_ = -(_e3861[0]);
                                    } else {
                                        phi_6177_ = _e3861[0];
                                    }
                                    let _e3868 = phi_6177_;
                                    if (_e3861[1] < 0f) {
                                        phi_6184_ = -(_e3861[1]);
                                    } else {
                                        phi_6184_ = _e3861[1];
                                    }
                                    let _e3872 = phi_6184_;
                                    if (_e3868 > _e3872) {
                                        phi_6189_ = _e3868;
                                    } else {
                                        phi_6189_ = _e3872;
                                    }
                                    let _e3875 = phi_6189_;
                                    if (_e3861[2] < 0f) {
                                        phi_6196_ = -(_e3861[2]);
                                    } else {
                                        phi_6196_ = _e3861[2];
                                    }
                                    let _e3879 = phi_6196_;
                                    if (_e3875 > _e3879) {
                                        phi_6201_ = _e3875;
                                    } else {
                                        phi_6201_ = _e3879;
                                    }
                                    let _e3882 = phi_6201_;
                                    let _e3885 = local.member_2[1u];
                                    if (_e3885[0] < 0f) {
                                        phi_6215_ = -(_e3885[0]);
                                    } else {
                                        phi_6215_ = _e3885[0];
                                    }
                                    let _e3892 = phi_6215_;
                                    if (_e3885[1] < 0f) {
                                        phi_6222_ = -(_e3885[1]);
                                    } else {
                                        phi_6222_ = _e3885[1];
                                    }
                                    let _e3896 = phi_6222_;
                                    if (_e3892 > _e3896) {
                                        phi_6227_ = _e3892;
                                    } else {
                                        phi_6227_ = _e3896;
                                    }
                                    let _e3899 = phi_6227_;
                                    if (_e3885[2] < 0f) {
                                        phi_6234_ = -(_e3885[2]);
                                    } else {
                                        phi_6234_ = _e3885[2];
                                    }
                                    let _e3903 = phi_6234_;
                                    if (_e3899 > _e3903) {
                                        phi_6239_ = _e3899;
                                    } else {
                                        phi_6239_ = _e3903;
                                    }
                                    let _e3906 = phi_6239_;
                                    if (_e3882 > _e3906) {
                                        phi_6244_ = _e3882;
                                    } else {
                                        phi_6244_ = _e3906;
                                    }
                                    let _e3909 = phi_6244_;
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
                                        phi_6323_ = _e3936;
                                    } else {
                                        phi_6323_ = _e3941;
                                    }
                                    let _e3980 = phi_6323_;
                                    if (_e3946 < _e3954) {
                                        phi_6328_ = _e3946;
                                    } else {
                                        phi_6328_ = _e3954;
                                    }
                                    let _e3983 = phi_6328_;
                                    if (_e3980 < _e3983) {
                                        phi_6333_ = _e3980;
                                    } else {
                                        phi_6333_ = _e3983;
                                    }
                                    let _e3986 = phi_6333_;
                                    if (_e3959 < _e3964) {
                                        phi_6338_ = _e3959;
                                    } else {
                                        phi_6338_ = _e3964;
                                    }
                                    let _e3989 = phi_6338_;
                                    if (_e3969 < _e3977) {
                                        phi_6343_ = _e3969;
                                    } else {
                                        phi_6343_ = _e3977;
                                    }
                                    let _e3992 = phi_6343_;
                                    if (_e3989 < _e3992) {
                                        phi_6348_ = _e3989;
                                    } else {
                                        phi_6348_ = _e3992;
                                    }
                                    let _e3995 = phi_6348_;
                                    if (_e3986 < _e3995) {
                                        phi_6353_ = _e3986;
                                    } else {
                                        phi_6353_ = _e3995;
                                    }
                                    let _e3998 = phi_6353_;
                                    if (_e3936 > _e3941) {
                                        phi_6358_ = _e3936;
                                    } else {
                                        phi_6358_ = _e3941;
                                    }
                                    let _e4001 = phi_6358_;
                                    if (_e3946 > _e3954) {
                                        phi_6363_ = _e3946;
                                    } else {
                                        phi_6363_ = _e3954;
                                    }
                                    let _e4004 = phi_6363_;
                                    if (_e4001 > _e4004) {
                                        phi_6368_ = _e4001;
                                    } else {
                                        phi_6368_ = _e4004;
                                    }
                                    let _e4007 = phi_6368_;
                                    if (_e3959 > _e3964) {
                                        phi_6373_ = _e3959;
                                    } else {
                                        phi_6373_ = _e3964;
                                    }
                                    let _e4010 = phi_6373_;
                                    if (_e3969 > _e3977) {
                                        phi_6378_ = _e3969;
                                    } else {
                                        phi_6378_ = _e3977;
                                    }
                                    let _e4013 = phi_6378_;
                                    if (_e4010 > _e4013) {
                                        phi_6383_ = _e4010;
                                    } else {
                                        phi_6383_ = _e4013;
                                    }
                                    let _e4016 = phi_6383_;
                                    if (_e4007 > _e4016) {
                                        phi_6388_ = _e4007;
                                    } else {
                                        phi_6388_ = _e4016;
                                    }
                                    let _e4019 = phi_6388_;
                                    if (_e3925 < 0f) {
                                        phi_6394_ = -(_e3925);
                                    } else {
                                        phi_6394_ = _e3925;
                                    }
                                    let _e4023 = phi_6394_;
                                    if (_e3928 < 0f) {
                                        phi_6400_ = -(_e3928);
                                    } else {
                                        phi_6400_ = _e3928;
                                    }
                                    let _e4027 = phi_6400_;
                                    if (_e3931 < 0f) {
                                        phi_6407_ = -(_e3931);
                                    } else {
                                        phi_6407_ = _e3931;
                                    }
                                    let _e4032 = phi_6407_;
                                    let _e4033 = ((_e4023 + _e4027) + _e4032);
                                    let _e4038 = -(_e4019);
                                    if (_e3998 > _e4038) {
                                        phi_6418_ = _e3998;
                                    } else {
                                        phi_6418_ = _e4038;
                                    }
                                    let _e4041 = phi_6418_;
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
                                        phi_6489_ = _e4060;
                                    } else {
                                        phi_6489_ = _e4065;
                                    }
                                    let _e4104 = phi_6489_;
                                    if (_e4070 < _e4078) {
                                        phi_6494_ = _e4070;
                                    } else {
                                        phi_6494_ = _e4078;
                                    }
                                    let _e4107 = phi_6494_;
                                    if (_e4104 < _e4107) {
                                        phi_6499_ = _e4104;
                                    } else {
                                        phi_6499_ = _e4107;
                                    }
                                    let _e4110 = phi_6499_;
                                    if (_e4083 < _e4088) {
                                        phi_6504_ = _e4083;
                                    } else {
                                        phi_6504_ = _e4088;
                                    }
                                    let _e4113 = phi_6504_;
                                    if (_e4093 < _e4101) {
                                        phi_6509_ = _e4093;
                                    } else {
                                        phi_6509_ = _e4101;
                                    }
                                    let _e4116 = phi_6509_;
                                    if (_e4113 < _e4116) {
                                        phi_6514_ = _e4113;
                                    } else {
                                        phi_6514_ = _e4116;
                                    }
                                    let _e4119 = phi_6514_;
                                    if (_e4110 < _e4119) {
                                        phi_6519_ = _e4110;
                                    } else {
                                        phi_6519_ = _e4119;
                                    }
                                    let _e4122 = phi_6519_;
                                    if (_e4060 > _e4065) {
                                        phi_6524_ = _e4060;
                                    } else {
                                        phi_6524_ = _e4065;
                                    }
                                    let _e4125 = phi_6524_;
                                    if (_e4070 > _e4078) {
                                        phi_6529_ = _e4070;
                                    } else {
                                        phi_6529_ = _e4078;
                                    }
                                    let _e4128 = phi_6529_;
                                    if (_e4125 > _e4128) {
                                        phi_6534_ = _e4125;
                                    } else {
                                        phi_6534_ = _e4128;
                                    }
                                    let _e4131 = phi_6534_;
                                    if (_e4083 > _e4088) {
                                        phi_6539_ = _e4083;
                                    } else {
                                        phi_6539_ = _e4088;
                                    }
                                    let _e4134 = phi_6539_;
                                    if (_e4093 > _e4101) {
                                        phi_6544_ = _e4093;
                                    } else {
                                        phi_6544_ = _e4101;
                                    }
                                    let _e4137 = phi_6544_;
                                    if (_e4134 > _e4137) {
                                        phi_6549_ = _e4134;
                                    } else {
                                        phi_6549_ = _e4137;
                                    }
                                    let _e4140 = phi_6549_;
                                    if (_e4131 > _e4140) {
                                        phi_6554_ = _e4131;
                                    } else {
                                        phi_6554_ = _e4140;
                                    }
                                    let _e4143 = phi_6554_;
                                    if (_e4049 < 0f) {
                                        phi_6560_ = -(_e4049);
                                    } else {
                                        phi_6560_ = _e4049;
                                    }
                                    let _e4147 = phi_6560_;
                                    if (_e4052 < 0f) {
                                        phi_6566_ = -(_e4052);
                                    } else {
                                        phi_6566_ = _e4052;
                                    }
                                    let _e4151 = phi_6566_;
                                    if (_e4055 < 0f) {
                                        phi_6573_ = -(_e4055);
                                    } else {
                                        phi_6573_ = _e4055;
                                    }
                                    let _e4156 = phi_6573_;
                                    let _e4157 = ((_e4147 + _e4151) + _e4156);
                                    let _e4162 = -(_e4143);
                                    if (_e4122 > _e4162) {
                                        phi_6584_ = _e4122;
                                    } else {
                                        phi_6584_ = _e4162;
                                    }
                                    let _e4165 = phi_6584_;
                                    let _e4170 = (((_e4165 - ((_e4157 * _e3915) * (0.000000059604645f * (17f / 2f)))) - (_e4157 * _e3922)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4046 > _e4170) {
                                        phi_6594_ = _e4046;
                                    } else {
                                        phi_6594_ = _e4170;
                                    }
                                    let _e4173 = phi_6594_;
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
                                            phi_6667_ = _e4191;
                                        } else {
                                            phi_6667_ = _e4196;
                                        }
                                        let _e4235 = phi_6667_;
                                        if (_e4201 < _e4209) {
                                            phi_6672_ = _e4201;
                                        } else {
                                            phi_6672_ = _e4209;
                                        }
                                        let _e4238 = phi_6672_;
                                        if (_e4235 < _e4238) {
                                            phi_6677_ = _e4235;
                                        } else {
                                            phi_6677_ = _e4238;
                                        }
                                        let _e4241 = phi_6677_;
                                        if (_e4214 < _e4219) {
                                            phi_6682_ = _e4214;
                                        } else {
                                            phi_6682_ = _e4219;
                                        }
                                        let _e4244 = phi_6682_;
                                        if (_e4224 < _e4232) {
                                            phi_6687_ = _e4224;
                                        } else {
                                            phi_6687_ = _e4232;
                                        }
                                        let _e4247 = phi_6687_;
                                        if (_e4244 < _e4247) {
                                            phi_6692_ = _e4244;
                                        } else {
                                            phi_6692_ = _e4247;
                                        }
                                        let _e4250 = phi_6692_;
                                        if (_e4241 < _e4250) {
                                            phi_6697_ = _e4241;
                                        } else {
                                            phi_6697_ = _e4250;
                                        }
                                        let _e4253 = phi_6697_;
                                        if (_e4191 > _e4196) {
                                            phi_6702_ = _e4191;
                                        } else {
                                            phi_6702_ = _e4196;
                                        }
                                        let _e4256 = phi_6702_;
                                        if (_e4201 > _e4209) {
                                            phi_6707_ = _e4201;
                                        } else {
                                            phi_6707_ = _e4209;
                                        }
                                        let _e4259 = phi_6707_;
                                        if (_e4256 > _e4259) {
                                            phi_6712_ = _e4256;
                                        } else {
                                            phi_6712_ = _e4259;
                                        }
                                        let _e4262 = phi_6712_;
                                        if (_e4214 > _e4219) {
                                            phi_6717_ = _e4214;
                                        } else {
                                            phi_6717_ = _e4219;
                                        }
                                        let _e4265 = phi_6717_;
                                        if (_e4224 > _e4232) {
                                            phi_6722_ = _e4224;
                                        } else {
                                            phi_6722_ = _e4232;
                                        }
                                        let _e4268 = phi_6722_;
                                        if (_e4265 > _e4268) {
                                            phi_6727_ = _e4265;
                                        } else {
                                            phi_6727_ = _e4268;
                                        }
                                        let _e4271 = phi_6727_;
                                        if (_e4262 > _e4271) {
                                            phi_6732_ = _e4262;
                                        } else {
                                            phi_6732_ = _e4271;
                                        }
                                        let _e4274 = phi_6732_;
                                        if (_e4180 < 0f) {
                                            phi_6738_ = -(_e4180);
                                        } else {
                                            phi_6738_ = _e4180;
                                        }
                                        let _e4278 = phi_6738_;
                                        if (_e4183 < 0f) {
                                            phi_6744_ = -(_e4183);
                                        } else {
                                            phi_6744_ = _e4183;
                                        }
                                        let _e4282 = phi_6744_;
                                        if (_e4186 < 0f) {
                                            phi_6751_ = -(_e4186);
                                        } else {
                                            phi_6751_ = _e4186;
                                        }
                                        let _e4287 = phi_6751_;
                                        let _e4288 = ((_e4278 + _e4282) + _e4287);
                                        let _e4293 = -(_e4274);
                                        if (_e4253 > _e4293) {
                                            phi_6762_ = _e4253;
                                        } else {
                                            phi_6762_ = _e4293;
                                        }
                                        let _e4296 = phi_6762_;
                                        let _e4301 = (((_e4296 - ((_e4288 * _e3915) * (0.000000059604645f * (17f / 2f)))) - (_e4288 * _e3922)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4173 > _e4301) {
                                            phi_6772_ = _e4173;
                                        } else {
                                            phi_6772_ = _e4301;
                                        }
                                        let _e4304 = phi_6772_;
                                        phi_6773_ = _e4304;
                                    } else {
                                        phi_6773_ = _e4173;
                                    }
                                    let _e4306 = phi_6773_;
                                    phi_6776_ = (_e3647 || (_e4306 > 0f));
                                }
                                let _e4310 = phi_6776_;
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
                                        phi_7021_ = -(_e4468[0]);
                                    } else {
                                        phi_7021_ = _e4468[0];
                                    }
                                    let _e4475 = phi_7021_;
                                    if (_e4468[1] < 0f) {
                                        phi_7028_ = -(_e4468[1]);
                                    } else {
                                        phi_7028_ = _e4468[1];
                                    }
                                    let _e4479 = phi_7028_;
                                    if (_e4475 > _e4479) {
                                        phi_7033_ = _e4475;
                                    } else {
                                        phi_7033_ = _e4479;
                                    }
                                    let _e4482 = phi_7033_;
                                    if (_e4468[2] < 0f) {
                                        phi_7040_ = -(_e4468[2]);
                                    } else {
                                        phi_7040_ = _e4468[2];
                                    }
                                    let _e4486 = phi_7040_;
                                    if (_e4482 > _e4486) {
                                        phi_7045_ = _e4482;
                                    } else {
                                        phi_7045_ = _e4486;
                                    }
                                    let _e4489 = phi_7045_;
                                    let _e4492 = local_1.member[1u];
                                    if (_e4492[0] < 0f) {
                                        phi_7058_ = -(_e4492[0]);
                                    } else {
                                        phi_7058_ = _e4492[0];
                                    }
                                    let _e4499 = phi_7058_;
                                    if (_e4492[1] < 0f) {
                                        phi_7065_ = -(_e4492[1]);
                                    } else {
                                        phi_7065_ = _e4492[1];
                                    }
                                    let _e4503 = phi_7065_;
                                    if (_e4499 > _e4503) {
                                        phi_7070_ = _e4499;
                                    } else {
                                        phi_7070_ = _e4503;
                                    }
                                    let _e4506 = phi_7070_;
                                    if (_e4492[2] < 0f) {
                                        phi_7077_ = -(_e4492[2]);
                                    } else {
                                        phi_7077_ = _e4492[2];
                                    }
                                    let _e4510 = phi_7077_;
                                    if (_e4506 > _e4510) {
                                        phi_7082_ = _e4506;
                                    } else {
                                        phi_7082_ = _e4510;
                                    }
                                    let _e4513 = phi_7082_;
                                    if (_e4489 > _e4513) {
                                        phi_7087_ = _e4489;
                                    } else {
                                        phi_7087_ = _e4513;
                                    }
                                    let _e4516 = phi_7087_;
                                    let _e4518 = local_1.member_3;
                                    let _e4519 = (_e4516 + _e4518);
                                    let _e4522 = local_1.member_1[0u];
                                    if (_e4522[0] < 0f) {
                                        phi_7104_ = -(_e4522[0]);
                                    } else {
                                        phi_7104_ = _e4522[0];
                                    }
                                    let _e4529 = phi_7104_;
                                    if (_e4522[1] < 0f) {
                                        phi_7111_ = -(_e4522[1]);
                                    } else {
                                        phi_7111_ = _e4522[1];
                                    }
                                    let _e4533 = phi_7111_;
                                    if (_e4529 > _e4533) {
                                        phi_7116_ = _e4529;
                                    } else {
                                        phi_7116_ = _e4533;
                                    }
                                    let _e4536 = phi_7116_;
                                    if (_e4522[2] < 0f) {
                                        phi_7123_ = -(_e4522[2]);
                                    } else {
                                        phi_7123_ = _e4522[2];
                                    }
                                    let _e4540 = phi_7123_;
                                    if (_e4536 > _e4540) {
                                        phi_7128_ = _e4536;
                                    } else {
                                        phi_7128_ = _e4540;
                                    }
                                    let _e4543 = phi_7128_;
                                    let _e4546 = local_1.member_1[1u];
                                    if (_e4546[0] < 0f) {
                                        phi_7142_ = -(_e4546[0]);
                                    } else {
                                        phi_7142_ = _e4546[0];
                                    }
                                    let _e4553 = phi_7142_;
                                    if (_e4546[1] < 0f) {
                                        phi_7149_ = -(_e4546[1]);
                                    } else {
                                        phi_7149_ = _e4546[1];
                                    }
                                    let _e4557 = phi_7149_;
                                    if (_e4553 > _e4557) {
                                        phi_7154_ = _e4553;
                                    } else {
                                        phi_7154_ = _e4557;
                                    }
                                    let _e4560 = phi_7154_;
                                    if (_e4546[2] < 0f) {
                                        phi_7161_ = -(_e4546[2]);
                                    } else {
                                        phi_7161_ = _e4546[2];
                                    }
                                    let _e4564 = phi_7161_;
                                    if (_e4560 > _e4564) {
                                        phi_7166_ = _e4560;
                                    } else {
                                        phi_7166_ = _e4564;
                                    }
                                    let _e4567 = phi_7166_;
                                    if (_e4543 > _e4567) {
                                        phi_7171_ = _e4543;
                                    } else {
                                        phi_7171_ = _e4567;
                                    }
                                    let _e4570 = phi_7171_;
                                    let _e4572 = local_1.member_3;
                                    let _e4573 = (_e4570 + _e4572);
                                    let _e4576 = local_1.member_2[0u];
                                    if (_e4576[0] < 0f) {
                                        phi_7188_ = -(_e4576[0]);
                                    } else {
                                        phi_7188_ = _e4576[0];
                                    }
                                    let _e4583 = phi_7188_;
                                    if (_e4576[1] < 0f) {
                                        phi_7195_ = -(_e4576[1]);
                                    } else {
                                        phi_7195_ = _e4576[1];
                                    }
                                    let _e4587 = phi_7195_;
                                    if (_e4583 > _e4587) {
                                        phi_7200_ = _e4583;
                                    } else {
                                        phi_7200_ = _e4587;
                                    }
                                    let _e4590 = phi_7200_;
                                    if (_e4576[2] < 0f) {
                                        phi_7207_ = -(_e4576[2]);
                                    } else {
                                        phi_7207_ = _e4576[2];
                                    }
                                    let _e4594 = phi_7207_;
                                    if (_e4590 > _e4594) {
                                        phi_7212_ = _e4590;
                                    } else {
                                        phi_7212_ = _e4594;
                                    }
                                    let _e4597 = phi_7212_;
                                    let _e4600 = local_1.member_2[1u];
                                    if (_e4600[0] < 0f) {
                                        phi_7226_ = -(_e4600[0]);
                                    } else {
                                        phi_7226_ = _e4600[0];
                                    }
                                    let _e4607 = phi_7226_;
                                    if (_e4600[1] < 0f) {
                                        phi_7233_ = -(_e4600[1]);
                                    } else {
                                        phi_7233_ = _e4600[1];
                                    }
                                    let _e4611 = phi_7233_;
                                    if (_e4607 > _e4611) {
                                        phi_7238_ = _e4607;
                                    } else {
                                        phi_7238_ = _e4611;
                                    }
                                    let _e4614 = phi_7238_;
                                    if (_e4600[2] < 0f) {
                                        phi_7245_ = -(_e4600[2]);
                                    } else {
                                        phi_7245_ = _e4600[2];
                                    }
                                    let _e4618 = phi_7245_;
                                    if (_e4614 > _e4618) {
                                        phi_7250_ = _e4614;
                                    } else {
                                        phi_7250_ = _e4618;
                                    }
                                    let _e4621 = phi_7250_;
                                    if (_e4597 > _e4621) {
                                        phi_7255_ = _e4597;
                                    } else {
                                        phi_7255_ = _e4621;
                                    }
                                    let _e4624 = phi_7255_;
                                    let _e4626 = local_1.member_3;
                                    let _e4627 = (_e4624 + _e4626);
                                    let _e4629 = ((_e4573 * 8f) * _e4627);
                                    let _e4636 = local_1.member_3;
                                    if (_e4325 < 0f) {
                                        phi_7286_ = -(_e4325);
                                    } else {
                                        phi_7286_ = _e4325;
                                    }
                                    let _e4653 = phi_7286_;
                                    if (_e4328 < 0f) {
                                        phi_7292_ = -(_e4328);
                                    } else {
                                        phi_7292_ = _e4328;
                                    }
                                    let _e4657 = phi_7292_;
                                    if (_e4331 < 0f) {
                                        phi_7299_ = -(_e4331);
                                    } else {
                                        phi_7299_ = _e4331;
                                    }
                                    let _e4662 = phi_7299_;
                                    let _e4663 = ((_e4653 + _e4657) + _e4662);
                                    if (_e4346 < 0f) {
                                        phi_7306_ = -(_e4346);
                                    } else {
                                        phi_7306_ = _e4346;
                                    }
                                    let _e4667 = phi_7306_;
                                    if (_e4349 < 0f) {
                                        phi_7312_ = -(_e4349);
                                    } else {
                                        phi_7312_ = _e4349;
                                    }
                                    let _e4671 = phi_7312_;
                                    if (_e4352 < 0f) {
                                        phi_7319_ = -(_e4352);
                                    } else {
                                        phi_7319_ = _e4352;
                                    }
                                    let _e4676 = phi_7319_;
                                    let _e4677 = ((_e4667 + _e4671) + _e4676);
                                    if (_e4663 > _e4677) {
                                        phi_7325_ = _e4663;
                                    } else {
                                        phi_7325_ = _e4677;
                                    }
                                    let _e4680 = phi_7325_;
                                    if (_e4395 < 0f) {
                                        phi_7331_ = -(_e4395);
                                    } else {
                                        phi_7331_ = _e4395;
                                    }
                                    let _e4684 = phi_7331_;
                                    if (_e4396 < 0f) {
                                        phi_7337_ = -(_e4396);
                                    } else {
                                        phi_7337_ = _e4396;
                                    }
                                    let _e4688 = phi_7337_;
                                    if (_e4397 < 0f) {
                                        phi_7344_ = -(_e4397);
                                    } else {
                                        phi_7344_ = _e4397;
                                    }
                                    let _e4693 = phi_7344_;
                                    let _e4695 = (((_e4684 + _e4688) + _e4693) * 0.5f);
                                    if (_e4680 > _e4695) {
                                        phi_7351_ = _e4680;
                                    } else {
                                        phi_7351_ = _e4695;
                                    }
                                    let _e4698 = phi_7351_;
                                    let _e4703 = local_1.member_3;
                                    let _e4716 = ((((_e4400[0] * _e4325) + (_e4400[1] * _e4328)) + (_e4400[2] * _e4331)) * 3f);
                                    let _e4717 = ((((_e4457[0] * _e4346) + (_e4457[1] * _e4349)) + (_e4457[2] * _e4352)) * 3f);
                                    if (_e4716 < _e4717) {
                                        phi_7375_ = _e4716;
                                    } else {
                                        phi_7375_ = _e4717;
                                    }
                                    let _e4720 = phi_7375_;
                                    if (_e4431 < _e4454) {
                                        phi_7380_ = _e4431;
                                    } else {
                                        phi_7380_ = _e4454;
                                    }
                                    let _e4723 = phi_7380_;
                                    if (_e4720 < _e4723) {
                                        phi_7385_ = _e4720;
                                    } else {
                                        phi_7385_ = _e4723;
                                    }
                                    let _e4726 = phi_7385_;
                                    if (_e4716 > _e4717) {
                                        phi_7390_ = _e4716;
                                    } else {
                                        phi_7390_ = _e4717;
                                    }
                                    let _e4729 = phi_7390_;
                                    if (_e4431 > _e4454) {
                                        phi_7395_ = _e4431;
                                    } else {
                                        phi_7395_ = _e4454;
                                    }
                                    let _e4732 = phi_7395_;
                                    if (_e4729 > _e4732) {
                                        phi_7400_ = _e4729;
                                    } else {
                                        phi_7400_ = _e4732;
                                    }
                                    let _e4735 = phi_7400_;
                                    let _e4740 = -(_e4735);
                                    if (_e4726 > _e4740) {
                                        phi_7410_ = _e4726;
                                    } else {
                                        phi_7410_ = _e4740;
                                    }
                                    let _e4743 = phi_7410_;
                                    let _e4745 = ((_e4743 - ((((((_e4519 * 8f) * _e4629) * (0.000000059604645f * (524f / 64f))) + ((_e4636 * 19f) * ((_e4519 * (_e4573 + _e4627)) + (_e4573 * _e4627)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4519) * ((1f + _e4573) * (1f + _e4627))))) + ((_e91.member_5 * (((_e4698 + (_e4629 * (0.000000059604645f * 8f))) + ((_e4703 * 6f) * (_e4573 + _e4627))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4573) * (1f + _e4627))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4745 {
                                        phi_8379_ = _e4745;
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
                                            phi_7526_ = array<f32, 3>(_e4787[0], _e4787[1], _e4787[2]);
                                        } else {
                                            phi_7526_ = array<f32, 3>((_e4804 - _e4800[0]), (_e4805 - _e4800[1]), (_e4806 - _e4800[2]));
                                        }
                                        let _e4813 = phi_7526_;
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
                                            phi_7591_ = array<f32, 3>(_e4819[0], _e4819[1], _e4819[2]);
                                        } else {
                                            phi_7591_ = array<f32, 3>((_e4836 - _e4832[0]), (_e4837 - _e4832[1]), (_e4838 - _e4832[2]));
                                        }
                                        let _e4845 = phi_7591_;
                                        let _e4846 = (_e4819[0] - _e4832[0]);
                                        let _e4847 = (_e4819[1] - _e4832[1]);
                                        let _e4848 = (_e4819[2] - _e4832[2]);
                                        let _e4851 = local_1.member[0u];
                                        if (_e4851[0] < 0f) {
                                            phi_7613_ = -(_e4851[0]);
                                        } else {
                                            phi_7613_ = _e4851[0];
                                        }
                                        let _e4858 = phi_7613_;
                                        if (_e4851[1] < 0f) {
                                            phi_7620_ = -(_e4851[1]);
                                        } else {
                                            phi_7620_ = _e4851[1];
                                        }
                                        let _e4862 = phi_7620_;
                                        if (_e4858 > _e4862) {
                                            phi_7625_ = _e4858;
                                        } else {
                                            phi_7625_ = _e4862;
                                        }
                                        let _e4865 = phi_7625_;
                                        if (_e4851[2] < 0f) {
                                            phi_7632_ = -(_e4851[2]);
                                        } else {
                                            phi_7632_ = _e4851[2];
                                        }
                                        let _e4869 = phi_7632_;
                                        if (_e4865 > _e4869) {
                                            phi_7637_ = _e4865;
                                        } else {
                                            phi_7637_ = _e4869;
                                        }
                                        let _e4872 = phi_7637_;
                                        let _e4875 = local_1.member[1u];
                                        if (_e4875[0] < 0f) {
                                            phi_7650_ = -(_e4875[0]);
                                        } else {
                                            phi_7650_ = _e4875[0];
                                        }
                                        let _e4882 = phi_7650_;
                                        if (_e4875[1] < 0f) {
                                            phi_7657_ = -(_e4875[1]);
                                        } else {
                                            phi_7657_ = _e4875[1];
                                        }
                                        let _e4886 = phi_7657_;
                                        if (_e4882 > _e4886) {
                                            phi_7662_ = _e4882;
                                        } else {
                                            phi_7662_ = _e4886;
                                        }
                                        let _e4889 = phi_7662_;
                                        if (_e4875[2] < 0f) {
                                            phi_7669_ = -(_e4875[2]);
                                        } else {
                                            phi_7669_ = _e4875[2];
                                        }
                                        let _e4893 = phi_7669_;
                                        if (_e4889 > _e4893) {
                                            phi_7674_ = _e4889;
                                        } else {
                                            phi_7674_ = _e4893;
                                        }
                                        let _e4896 = phi_7674_;
                                        if (_e4872 > _e4896) {
                                            phi_7679_ = _e4872;
                                        } else {
                                            phi_7679_ = _e4896;
                                        }
                                        let _e4899 = phi_7679_;
                                        let _e4901 = local_1.member_3;
                                        let _e4905 = local_1.member_1[0u];
                                        if (_e4905[0] < 0f) {
                                            phi_7696_ = -(_e4905[0]);
                                        } else {
                                            phi_7696_ = _e4905[0];
                                        }
                                        let _e4912 = phi_7696_;
                                        if (_e4905[1] < 0f) {
                                            phi_7703_ = -(_e4905[1]);
                                        } else {
                                            phi_7703_ = _e4905[1];
                                        }
                                        let _e4916 = phi_7703_;
                                        if (_e4912 > _e4916) {
                                            phi_7708_ = _e4912;
                                        } else {
                                            phi_7708_ = _e4916;
                                        }
                                        let _e4919 = phi_7708_;
                                        if (_e4905[2] < 0f) {
                                            phi_7715_ = -(_e4905[2]);
                                        } else {
                                            phi_7715_ = _e4905[2];
                                        }
                                        let _e4923 = phi_7715_;
                                        if (_e4919 > _e4923) {
                                            phi_7720_ = _e4919;
                                        } else {
                                            phi_7720_ = _e4923;
                                        }
                                        let _e4926 = phi_7720_;
                                        let _e4929 = local_1.member_1[1u];
                                        if (_e4929[0] < 0f) {
                                            phi_7734_ = -(_e4929[0]);
                                        } else {
                                            phi_7734_ = _e4929[0];
                                        }
                                        let _e4936 = phi_7734_;
                                        if (_e4929[1] < 0f) {
                                            phi_7741_ = -(_e4929[1]);
                                        } else {
                                            phi_7741_ = _e4929[1];
                                        }
                                        let _e4940 = phi_7741_;
                                        if (_e4936 > _e4940) {
                                            phi_7746_ = _e4936;
                                        } else {
                                            phi_7746_ = _e4940;
                                        }
                                        let _e4943 = phi_7746_;
                                        if (_e4929[2] < 0f) {
                                            phi_7753_ = -(_e4929[2]);
                                        } else {
                                            phi_7753_ = _e4929[2];
                                        }
                                        let _e4947 = phi_7753_;
                                        if (_e4943 > _e4947) {
                                            phi_7758_ = _e4943;
                                        } else {
                                            phi_7758_ = _e4947;
                                        }
                                        let _e4950 = phi_7758_;
                                        if (_e4926 > _e4950) {
                                            phi_7763_ = _e4926;
                                        } else {
                                            phi_7763_ = _e4950;
                                        }
                                        let _e4953 = phi_7763_;
                                        let _e4955 = local_1.member_3;
                                        let _e4959 = local_1.member_2[0u];
                                        if (_e4959[0] < 0f) {
                                            phi_7780_ = -(_e4959[0]);
                                        } else {
                                            phi_7780_ = _e4959[0];
                                        }
                                        let _e4966 = phi_7780_;
                                        if (_e4959[1] < 0f) {
                                            phi_7787_ = -(_e4959[1]);
                                        } else {
                                            phi_7787_ = _e4959[1];
                                        }
                                        let _e4970 = phi_7787_;
                                        if (_e4966 > _e4970) {
                                            phi_7792_ = _e4966;
                                        } else {
                                            phi_7792_ = _e4970;
                                        }
                                        let _e4973 = phi_7792_;
                                        if (_e4959[2] < 0f) {
                                            phi_7799_ = -(_e4959[2]);
                                        } else {
                                            phi_7799_ = _e4959[2];
                                        }
                                        let _e4977 = phi_7799_;
                                        if (_e4973 > _e4977) {
                                            phi_7804_ = _e4973;
                                        } else {
                                            phi_7804_ = _e4977;
                                        }
                                        let _e4980 = phi_7804_;
                                        let _e4983 = local_1.member_2[1u];
                                        if (_e4983[0] < 0f) {
                                            phi_7818_ = -(_e4983[0]);
                                        } else {
                                            phi_7818_ = _e4983[0];
                                        }
                                        let _e4990 = phi_7818_;
                                        if (_e4983[1] < 0f) {
                                            phi_7825_ = -(_e4983[1]);
                                        } else {
                                            phi_7825_ = _e4983[1];
                                        }
                                        let _e4994 = phi_7825_;
                                        if (_e4990 > _e4994) {
                                            phi_7830_ = _e4990;
                                        } else {
                                            phi_7830_ = _e4994;
                                        }
                                        let _e4997 = phi_7830_;
                                        if (_e4983[2] < 0f) {
                                            phi_7837_ = -(_e4983[2]);
                                        } else {
                                            phi_7837_ = _e4983[2];
                                        }
                                        let _e5001 = phi_7837_;
                                        if (_e4997 > _e5001) {
                                            phi_7842_ = _e4997;
                                        } else {
                                            phi_7842_ = _e5001;
                                        }
                                        let _e5004 = phi_7842_;
                                        if (_e4980 > _e5004) {
                                            phi_7847_ = _e4980;
                                        } else {
                                            phi_7847_ = _e5004;
                                        }
                                        let _e5007 = phi_7847_;
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
                                            phi_7926_ = _e5034;
                                        } else {
                                            phi_7926_ = _e5039;
                                        }
                                        let _e5078 = phi_7926_;
                                        if (_e5044 < _e5052) {
                                            phi_7931_ = _e5044;
                                        } else {
                                            phi_7931_ = _e5052;
                                        }
                                        let _e5081 = phi_7931_;
                                        if (_e5078 < _e5081) {
                                            phi_7936_ = _e5078;
                                        } else {
                                            phi_7936_ = _e5081;
                                        }
                                        let _e5084 = phi_7936_;
                                        if (_e5057 < _e5062) {
                                            phi_7941_ = _e5057;
                                        } else {
                                            phi_7941_ = _e5062;
                                        }
                                        let _e5087 = phi_7941_;
                                        if (_e5067 < _e5075) {
                                            phi_7946_ = _e5067;
                                        } else {
                                            phi_7946_ = _e5075;
                                        }
                                        let _e5090 = phi_7946_;
                                        if (_e5087 < _e5090) {
                                            phi_7951_ = _e5087;
                                        } else {
                                            phi_7951_ = _e5090;
                                        }
                                        let _e5093 = phi_7951_;
                                        if (_e5084 < _e5093) {
                                            phi_7956_ = _e5084;
                                        } else {
                                            phi_7956_ = _e5093;
                                        }
                                        let _e5096 = phi_7956_;
                                        if (_e5034 > _e5039) {
                                            phi_7961_ = _e5034;
                                        } else {
                                            phi_7961_ = _e5039;
                                        }
                                        let _e5099 = phi_7961_;
                                        if (_e5044 > _e5052) {
                                            phi_7966_ = _e5044;
                                        } else {
                                            phi_7966_ = _e5052;
                                        }
                                        let _e5102 = phi_7966_;
                                        if (_e5099 > _e5102) {
                                            phi_7971_ = _e5099;
                                        } else {
                                            phi_7971_ = _e5102;
                                        }
                                        let _e5105 = phi_7971_;
                                        if (_e5057 > _e5062) {
                                            phi_7976_ = _e5057;
                                        } else {
                                            phi_7976_ = _e5062;
                                        }
                                        let _e5108 = phi_7976_;
                                        if (_e5067 > _e5075) {
                                            phi_7981_ = _e5067;
                                        } else {
                                            phi_7981_ = _e5075;
                                        }
                                        let _e5111 = phi_7981_;
                                        if (_e5108 > _e5111) {
                                            phi_7986_ = _e5108;
                                        } else {
                                            phi_7986_ = _e5111;
                                        }
                                        let _e5114 = phi_7986_;
                                        if (_e5105 > _e5114) {
                                            phi_7991_ = _e5105;
                                        } else {
                                            phi_7991_ = _e5114;
                                        }
                                        let _e5117 = phi_7991_;
                                        if (_e5023 < 0f) {
                                            phi_7997_ = -(_e5023);
                                        } else {
                                            phi_7997_ = _e5023;
                                        }
                                        let _e5121 = phi_7997_;
                                        if (_e5026 < 0f) {
                                            phi_8003_ = -(_e5026);
                                        } else {
                                            phi_8003_ = _e5026;
                                        }
                                        let _e5125 = phi_8003_;
                                        if (_e5029 < 0f) {
                                            phi_8010_ = -(_e5029);
                                        } else {
                                            phi_8010_ = _e5029;
                                        }
                                        let _e5130 = phi_8010_;
                                        let _e5131 = ((_e5121 + _e5125) + _e5130);
                                        let _e5136 = -(_e5117);
                                        if (_e5096 > _e5136) {
                                            phi_8021_ = _e5096;
                                        } else {
                                            phi_8021_ = _e5136;
                                        }
                                        let _e5139 = phi_8021_;
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
                                            phi_8092_ = _e5158;
                                        } else {
                                            phi_8092_ = _e5163;
                                        }
                                        let _e5202 = phi_8092_;
                                        if (_e5168 < _e5176) {
                                            phi_8097_ = _e5168;
                                        } else {
                                            phi_8097_ = _e5176;
                                        }
                                        let _e5205 = phi_8097_;
                                        if (_e5202 < _e5205) {
                                            phi_8102_ = _e5202;
                                        } else {
                                            phi_8102_ = _e5205;
                                        }
                                        let _e5208 = phi_8102_;
                                        if (_e5181 < _e5186) {
                                            phi_8107_ = _e5181;
                                        } else {
                                            phi_8107_ = _e5186;
                                        }
                                        let _e5211 = phi_8107_;
                                        if (_e5191 < _e5199) {
                                            phi_8112_ = _e5191;
                                        } else {
                                            phi_8112_ = _e5199;
                                        }
                                        let _e5214 = phi_8112_;
                                        if (_e5211 < _e5214) {
                                            phi_8117_ = _e5211;
                                        } else {
                                            phi_8117_ = _e5214;
                                        }
                                        let _e5217 = phi_8117_;
                                        if (_e5208 < _e5217) {
                                            phi_8122_ = _e5208;
                                        } else {
                                            phi_8122_ = _e5217;
                                        }
                                        let _e5220 = phi_8122_;
                                        if (_e5158 > _e5163) {
                                            phi_8127_ = _e5158;
                                        } else {
                                            phi_8127_ = _e5163;
                                        }
                                        let _e5223 = phi_8127_;
                                        if (_e5168 > _e5176) {
                                            phi_8132_ = _e5168;
                                        } else {
                                            phi_8132_ = _e5176;
                                        }
                                        let _e5226 = phi_8132_;
                                        if (_e5223 > _e5226) {
                                            phi_8137_ = _e5223;
                                        } else {
                                            phi_8137_ = _e5226;
                                        }
                                        let _e5229 = phi_8137_;
                                        if (_e5181 > _e5186) {
                                            phi_8142_ = _e5181;
                                        } else {
                                            phi_8142_ = _e5186;
                                        }
                                        let _e5232 = phi_8142_;
                                        if (_e5191 > _e5199) {
                                            phi_8147_ = _e5191;
                                        } else {
                                            phi_8147_ = _e5199;
                                        }
                                        let _e5235 = phi_8147_;
                                        if (_e5232 > _e5235) {
                                            phi_8152_ = _e5232;
                                        } else {
                                            phi_8152_ = _e5235;
                                        }
                                        let _e5238 = phi_8152_;
                                        if (_e5229 > _e5238) {
                                            phi_8157_ = _e5229;
                                        } else {
                                            phi_8157_ = _e5238;
                                        }
                                        let _e5241 = phi_8157_;
                                        if (_e5147 < 0f) {
                                            phi_8163_ = -(_e5147);
                                        } else {
                                            phi_8163_ = _e5147;
                                        }
                                        let _e5245 = phi_8163_;
                                        if (_e5150 < 0f) {
                                            phi_8169_ = -(_e5150);
                                        } else {
                                            phi_8169_ = _e5150;
                                        }
                                        let _e5249 = phi_8169_;
                                        if (_e5153 < 0f) {
                                            phi_8176_ = -(_e5153);
                                        } else {
                                            phi_8176_ = _e5153;
                                        }
                                        let _e5254 = phi_8176_;
                                        let _e5255 = ((_e5245 + _e5249) + _e5254);
                                        let _e5260 = -(_e5241);
                                        if (_e5220 > _e5260) {
                                            phi_8187_ = _e5220;
                                        } else {
                                            phi_8187_ = _e5260;
                                        }
                                        let _e5263 = phi_8187_;
                                        let _e5268 = (((_e5263 - ((_e5255 * _e5013) * (0.000000059604645f * (17f / 2f)))) - (_e5255 * _e5020)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5144 > _e5268) {
                                            phi_8197_ = _e5144;
                                        } else {
                                            phi_8197_ = _e5268;
                                        }
                                        let _e5271 = phi_8197_;
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
                                                phi_8270_ = _e5289;
                                            } else {
                                                phi_8270_ = _e5294;
                                            }
                                            let _e5333 = phi_8270_;
                                            if (_e5299 < _e5307) {
                                                phi_8275_ = _e5299;
                                            } else {
                                                phi_8275_ = _e5307;
                                            }
                                            let _e5336 = phi_8275_;
                                            if (_e5333 < _e5336) {
                                                phi_8280_ = _e5333;
                                            } else {
                                                phi_8280_ = _e5336;
                                            }
                                            let _e5339 = phi_8280_;
                                            if (_e5312 < _e5317) {
                                                phi_8285_ = _e5312;
                                            } else {
                                                phi_8285_ = _e5317;
                                            }
                                            let _e5342 = phi_8285_;
                                            if (_e5322 < _e5330) {
                                                phi_8290_ = _e5322;
                                            } else {
                                                phi_8290_ = _e5330;
                                            }
                                            let _e5345 = phi_8290_;
                                            if (_e5342 < _e5345) {
                                                phi_8295_ = _e5342;
                                            } else {
                                                phi_8295_ = _e5345;
                                            }
                                            let _e5348 = phi_8295_;
                                            if (_e5339 < _e5348) {
                                                phi_8300_ = _e5339;
                                            } else {
                                                phi_8300_ = _e5348;
                                            }
                                            let _e5351 = phi_8300_;
                                            if (_e5289 > _e5294) {
                                                phi_8305_ = _e5289;
                                            } else {
                                                phi_8305_ = _e5294;
                                            }
                                            let _e5354 = phi_8305_;
                                            if (_e5299 > _e5307) {
                                                phi_8310_ = _e5299;
                                            } else {
                                                phi_8310_ = _e5307;
                                            }
                                            let _e5357 = phi_8310_;
                                            if (_e5354 > _e5357) {
                                                phi_8315_ = _e5354;
                                            } else {
                                                phi_8315_ = _e5357;
                                            }
                                            let _e5360 = phi_8315_;
                                            if (_e5312 > _e5317) {
                                                phi_8320_ = _e5312;
                                            } else {
                                                phi_8320_ = _e5317;
                                            }
                                            let _e5363 = phi_8320_;
                                            if (_e5322 > _e5330) {
                                                phi_8325_ = _e5322;
                                            } else {
                                                phi_8325_ = _e5330;
                                            }
                                            let _e5366 = phi_8325_;
                                            if (_e5363 > _e5366) {
                                                phi_8330_ = _e5363;
                                            } else {
                                                phi_8330_ = _e5366;
                                            }
                                            let _e5369 = phi_8330_;
                                            if (_e5360 > _e5369) {
                                                phi_8335_ = _e5360;
                                            } else {
                                                phi_8335_ = _e5369;
                                            }
                                            let _e5372 = phi_8335_;
                                            if (_e5278 < 0f) {
                                                phi_8341_ = -(_e5278);
                                            } else {
                                                phi_8341_ = _e5278;
                                            }
                                            let _e5376 = phi_8341_;
                                            if (_e5281 < 0f) {
                                                phi_8347_ = -(_e5281);
                                            } else {
                                                phi_8347_ = _e5281;
                                            }
                                            let _e5380 = phi_8347_;
                                            if (_e5284 < 0f) {
                                                phi_8354_ = -(_e5284);
                                            } else {
                                                phi_8354_ = _e5284;
                                            }
                                            let _e5385 = phi_8354_;
                                            let _e5386 = ((_e5376 + _e5380) + _e5385);
                                            let _e5391 = -(_e5372);
                                            if (_e5351 > _e5391) {
                                                phi_8365_ = _e5351;
                                            } else {
                                                phi_8365_ = _e5391;
                                            }
                                            let _e5394 = phi_8365_;
                                            let _e5399 = (((_e5394 - ((_e5386 * _e5013) * (0.000000059604645f * (17f / 2f)))) - (_e5386 * _e5020)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                            if (_e5271 > _e5399) {
                                                phi_8375_ = _e5271;
                                            } else {
                                                phi_8375_ = _e5399;
                                            }
                                            let _e5402 = phi_8375_;
                                            phi_8376_ = _e5402;
                                        } else {
                                            phi_8376_ = _e5271;
                                        }
                                        let _e5404 = phi_8376_;
                                        phi_8379_ = (_e4745 || (_e5404 > 0f));
                                    }
                                    let _e5408 = phi_8379_;
                                    phi_8381_ = (_e4310 && _e5408);
                                } else {
                                    phi_8381_ = _e4310;
                                }
                                let _e5411 = phi_8381_;
                                if _e5411 {
                                } else {
                                    let _e5413 = atomicAdd((&counters[7u]), 1u);
                                    hits[_e2953] = ((2147483648u | (_e5413 << bitcast<u32>(12i))) | _e2956);
                                }
                                phi_8391_ = true;
                            }
                            let _e5420 = phi_8391_;
                            phi_8392_ = _e5420;
                        } else {
                            phi_8392_ = false;
                        }
                        let _e5422 = phi_8392_;
                        continue;
                        continuing {
                            phi_4810_ = _e2945;
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
                    phi_8428_ = type_9(0u, 4u);
                    loop {
                        let _e5444 = phi_8428_;
                        if (_e5444.member < _e5444.member_1) {
                            phi_8429_ = type_9((_e5444.member + 1u), _e5444.member_1);
                            phi_8452_ = type_9(1u, _e5444.member);
                        } else {
                            phi_8429_ = _e5444;
                            phi_8452_ = type_9(0u, type_9().member_1);
                        }
                        let _e5456 = phi_8429_;
                        let _e5458 = phi_8452_;
                        if (bitcast<i32>(_e5458.member) != 0i) {
                            let _e5464 = (_e73 + (_e5458.member_1 * 128u));
                            if (_e5464 >= _e2931) {
                                phi_8547_ = false;
                            } else {
                                let _e5467 = hits[_e5464];
                                if ((_e5467 & 2147483648u) == 0u) {
                                    phi_8476_ = 4294967295u;
                                } else {
                                    phi_8476_ = ((_e5467 & 2147483647u) >> bitcast<u32>(12i));
                                }
                                let _e5474 = phi_8476_;
                                if (_e5474 != 4294967295u) {
                                    let _e5478 = ((_e5467 >> bitcast<u32>(10i)) & 3u);
                                    let _e5485 = firsts[(2u * _e5478)];
                                    let _e5490 = firsts[((2u * _e5478) + 1u)];
                                    let _e5493 = leaves.member[(_e5485 + ((_e5467 >> bitcast<u32>(5i)) & 31u))];
                                    let _e5496 = leaves.member[(_e5490 + (_e5467 & 31u))];
                                    let _e5498 = (_e5442 + _e5474);
                                    if (_e5493.w < _e5496.w) {
                                        phi_8528_ = type_9(_e5493.w, _e5496.w);
                                    } else {
                                        phi_8528_ = type_9(_e5496.w, _e5493.w);
                                    }
                                    let _e5503 = phi_8528_;
                                    if (_e5498 < _e5426) {
                                        let _e5507 = (2u * _e5498);
                                        atomicStore((&output.member[(4u + _e5507)]), _e5503.member);
                                        atomicStore((&output.member[(_e5507 + 5u)]), _e5503.member_1);
                                    }
                                }
                                phi_8547_ = true;
                            }
                            let _e5513 = phi_8547_;
                            phi_8548_ = _e5513;
                        } else {
                            phi_8548_ = false;
                        }
                        let _e5515 = phi_8548_;
                        continue;
                        continuing {
                            phi_8428_ = _e5456;
                            break if !(_e5515);
                        }
                    }
                    workgroupBarrier();
                    let _e6119 = local_8;
                    phi_1346_ = _e6119;
                } else {
                    phi_1346_ = type_9();
                }
                let _e5518 = phi_1346_;
                continue;
                continuing {
                    phi_1342_ = _e677;
                    phi_1345_ = _e5518;
                    break if !(_e683);
                }
            }
        }
        continue;
        continuing {
            phi_479_ = _e163;
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
