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

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: i32,
    member_1: i32,
}

struct type_15 {
    member: u32,
    member_1: i32,
}

struct type_17 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_28 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_30 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_31 {
    member: u32,
}

struct type_32 {
    member: type_7,
    member_1: type_8,
    member_2: type_31,
}

struct type_33 {
    member: type_32,
}

struct type_36 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> bodies: type_10;
@group(0) @binding(4) 
var<storage> keys: type_28;
@group(0) @binding(5) 
var<storage> paths: type_19;
@group(0) @binding(6) 
var<storage> input: type_10;
@group(0) @binding(7) 
var<storage, read_write> output: type_36;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_33;
@group(0) @binding(1) 
var<storage> boxes: type_25;
@group(0) @binding(2) 
var<storage> elements: type_21;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_144_: bool;
    var phi_145_: bool;
    var phi_149_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_145_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_144_ = (param[0] > param_1[0]);
        } else {
            phi_144_ = false;
        }
        let _e14 = phi_144_;
        phi_145_ = _e14;
    }
    let _e16 = phi_145_;
    if _e16 {
        phi_149_ = param_1;
    } else {
        phi_149_ = param;
    }
    let _e18 = phi_149_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_168_: bool;
    var phi_169_: bool;
    var phi_173_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_169_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_168_ = (param_3[0] > param_2[0]);
        } else {
            phi_168_ = false;
        }
        let _e14 = phi_168_;
        phi_169_ = _e14;
    }
    let _e16 = phi_169_;
    if _e16 {
        phi_173_ = param_3;
    } else {
        phi_173_ = param_2;
    }
    let _e18 = phi_173_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_192_: bool;
    var phi_193_: bool;
    var phi_197_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_193_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_192_ = (param_4[0] > param_5[0]);
        } else {
            phi_192_ = false;
        }
        let _e14 = phi_192_;
        phi_193_ = _e14;
    }
    let _e16 = phi_193_;
    if _e16 {
        phi_197_ = param_5;
    } else {
        phi_197_ = param_4;
    }
    let _e18 = phi_197_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_216_: bool;
    var phi_217_: bool;
    var phi_221_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_217_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_216_ = (param_7[0] > param_6[0]);
        } else {
            phi_216_ = false;
        }
        let _e14 = phi_216_;
        phi_217_ = _e14;
    }
    let _e16 = phi_217_;
    if _e16 {
        phi_221_ = param_7;
    } else {
        phi_221_ = param_6;
    }
    let _e18 = phi_221_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_240_: bool;
    var phi_241_: bool;
    var phi_245_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_241_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_240_ = (param_8[0] > param_9[0]);
        } else {
            phi_240_ = false;
        }
        let _e14 = phi_240_;
        phi_241_ = _e14;
    }
    let _e16 = phi_241_;
    if _e16 {
        phi_245_ = param_9;
    } else {
        phi_245_ = param_8;
    }
    let _e18 = phi_245_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_264_: bool;
    var phi_265_: bool;
    var phi_269_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_265_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_264_ = (param_11[0] > param_10[0]);
        } else {
            phi_264_ = false;
        }
        let _e14 = phi_264_;
        phi_265_ = _e14;
    }
    let _e16 = phi_265_;
    if _e16 {
        phi_269_ = param_11;
    } else {
        phi_269_ = param_10;
    }
    let _e18 = phi_269_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_30;
    var local_1: type_30;
    var local_2: type_30;
    var phi_316_: u32;
    var phi_326_: u32;
    var phi_333_: u32;
    var phi_349_: u32;
    var phi_370_: u32;
    var phi_371_: u32;
    var phi_374_: type_12;
    var phi_375_: type_12;
    var phi_398_: type_12;
    var phi_553_: bool;
    var phi_559_: bool;
    var phi_565_: bool;
    var phi_566_: bool;
    var phi_608_: bool;
    var phi_609_: bool;
    var phi_616_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_768_: u32;
    var phi_769_: u32;
    var phi_774_: type_14;
    var phi_777_: u32;
    var phi_779_: u32;
    var phi_800_: bool;
    var phi_806_: type_15;
    var phi_775_: type_14;
    var phi_820_: type_15;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_891_: bool;
    var phi_895_: bool;
    var phi_896_: bool;
    var phi_901_: u32;
    var phi_902_: u32;
    var phi_903_: u32;
    var phi_904_: u32;
    var phi_905_: bool;
    var phi_778_: u32;
    var phi_780_: u32;
    var phi_906_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_954_: bool;
    var phi_955_: bool;
    var phi_956_: bool;
    var phi_957_: bool;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_966_: bool;
    var phi_970_: bool;
    var phi_971_: bool;
    var phi_975_: bool;
    var phi_976_: bool;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_1111_: bool;
    var phi_1112_: bool;
    var phi_1199_: bool;
    var phi_1200_: bool;
    var phi_1288_: bool;
    var phi_1289_: bool;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1466_: bool;
    var phi_1467_: bool;
    var phi_1554_: bool;
    var phi_1555_: bool;
    var phi_1559_: bool;
    var phi_1560_: bool;
    var phi_1561_: bool;
    var phi_1565_: bool;
    var phi_1566_: bool;
    var phi_1567_: bool;
    var phi_1568_: bool;
    var phi_1569_: bool;
    var phi_1573_: bool;
    var phi_1964_: f32;
    var phi_1971_: f32;
    var phi_1976_: f32;
    var phi_1983_: f32;
    var phi_1988_: f32;
    var phi_2001_: f32;
    var phi_2008_: f32;
    var phi_2013_: f32;
    var phi_2020_: f32;
    var phi_2025_: f32;
    var phi_2030_: f32;
    var phi_2047_: f32;
    var phi_2054_: f32;
    var phi_2059_: f32;
    var phi_2066_: f32;
    var phi_2071_: f32;
    var phi_2085_: f32;
    var phi_2092_: f32;
    var phi_2097_: f32;
    var phi_2104_: f32;
    var phi_2109_: f32;
    var phi_2114_: f32;
    var phi_2131_: f32;
    var phi_2138_: f32;
    var phi_2143_: f32;
    var phi_2150_: f32;
    var phi_2155_: f32;
    var phi_2169_: f32;
    var phi_2176_: f32;
    var phi_2181_: f32;
    var phi_2188_: f32;
    var phi_2193_: f32;
    var phi_2198_: f32;
    var phi_2229_: f32;
    var phi_2235_: f32;
    var phi_2242_: f32;
    var phi_2249_: f32;
    var phi_2255_: f32;
    var phi_2262_: f32;
    var phi_2268_: f32;
    var phi_2274_: f32;
    var phi_2280_: f32;
    var phi_2287_: f32;
    var phi_2294_: f32;
    var phi_2318_: f32;
    var phi_2323_: f32;
    var phi_2328_: f32;
    var phi_2333_: f32;
    var phi_2338_: f32;
    var phi_2343_: f32;
    var phi_2353_: f32;
    var phi_2556_: f32;
    var phi_2563_: f32;
    var phi_2568_: f32;
    var phi_2575_: f32;
    var phi_2580_: f32;
    var phi_2593_: f32;
    var phi_2600_: f32;
    var phi_2605_: f32;
    var phi_2612_: f32;
    var phi_2617_: f32;
    var phi_2622_: f32;
    var phi_2639_: f32;
    var phi_2646_: f32;
    var phi_2651_: f32;
    var phi_2658_: f32;
    var phi_2663_: f32;
    var phi_2677_: f32;
    var phi_2684_: f32;
    var phi_2689_: f32;
    var phi_2696_: f32;
    var phi_2701_: f32;
    var phi_2706_: f32;
    var phi_2723_: f32;
    var phi_2730_: f32;
    var phi_2735_: f32;
    var phi_2742_: f32;
    var phi_2747_: f32;
    var phi_2761_: f32;
    var phi_2768_: f32;
    var phi_2773_: f32;
    var phi_2780_: f32;
    var phi_2785_: f32;
    var phi_2790_: f32;
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
    var phi_2929_: f32;
    var phi_2934_: f32;
    var phi_2940_: f32;
    var phi_2946_: f32;
    var phi_2953_: f32;
    var phi_2964_: f32;
    var phi_3035_: f32;
    var phi_3040_: f32;
    var phi_3045_: f32;
    var phi_3050_: f32;
    var phi_3055_: f32;
    var phi_3060_: f32;
    var phi_3065_: f32;
    var phi_3070_: f32;
    var phi_3075_: f32;
    var phi_3080_: f32;
    var phi_3085_: f32;
    var phi_3090_: f32;
    var phi_3095_: f32;
    var phi_3100_: f32;
    var phi_3106_: f32;
    var phi_3112_: f32;
    var phi_3119_: f32;
    var phi_3130_: f32;
    var phi_3140_: f32;
    var phi_3322_: bool;
    var phi_3774_: f32;
    var phi_3781_: f32;
    var phi_3786_: f32;
    var phi_3793_: f32;
    var phi_3798_: f32;
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
    var phi_3941_: f32;
    var phi_3948_: f32;
    var phi_3953_: f32;
    var phi_3960_: f32;
    var phi_3965_: f32;
    var phi_3979_: f32;
    var phi_3986_: f32;
    var phi_3991_: f32;
    var phi_3998_: f32;
    var phi_4003_: f32;
    var phi_4008_: f32;
    var phi_4039_: f32;
    var phi_4045_: f32;
    var phi_4052_: f32;
    var phi_4059_: f32;
    var phi_4065_: f32;
    var phi_4072_: f32;
    var phi_4078_: f32;
    var phi_4084_: f32;
    var phi_4090_: f32;
    var phi_4097_: f32;
    var phi_4104_: f32;
    var phi_4128_: f32;
    var phi_4133_: f32;
    var phi_4138_: f32;
    var phi_4143_: f32;
    var phi_4148_: f32;
    var phi_4153_: f32;
    var phi_4163_: f32;
    var phi_4366_: f32;
    var phi_4373_: f32;
    var phi_4378_: f32;
    var phi_4385_: f32;
    var phi_4390_: f32;
    var phi_4403_: f32;
    var phi_4410_: f32;
    var phi_4415_: f32;
    var phi_4422_: f32;
    var phi_4427_: f32;
    var phi_4432_: f32;
    var phi_4449_: f32;
    var phi_4456_: f32;
    var phi_4461_: f32;
    var phi_4468_: f32;
    var phi_4473_: f32;
    var phi_4487_: f32;
    var phi_4494_: f32;
    var phi_4499_: f32;
    var phi_4506_: f32;
    var phi_4511_: f32;
    var phi_4516_: f32;
    var phi_4533_: f32;
    var phi_4540_: f32;
    var phi_4545_: f32;
    var phi_4552_: f32;
    var phi_4557_: f32;
    var phi_4571_: f32;
    var phi_4578_: f32;
    var phi_4583_: f32;
    var phi_4590_: f32;
    var phi_4595_: f32;
    var phi_4600_: f32;
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
    var phi_4739_: f32;
    var phi_4744_: f32;
    var phi_4750_: f32;
    var phi_4756_: f32;
    var phi_4763_: f32;
    var phi_4774_: f32;
    var phi_4845_: f32;
    var phi_4850_: f32;
    var phi_4855_: f32;
    var phi_4860_: f32;
    var phi_4865_: f32;
    var phi_4870_: f32;
    var phi_4875_: f32;
    var phi_4880_: f32;
    var phi_4885_: f32;
    var phi_4890_: f32;
    var phi_4895_: f32;
    var phi_4900_: f32;
    var phi_4905_: f32;
    var phi_4910_: f32;
    var phi_4916_: f32;
    var phi_4922_: f32;
    var phi_4929_: f32;
    var phi_4940_: f32;
    var phi_4950_: f32;
    var phi_5132_: bool;
    var phi_5377_: f32;
    var phi_5384_: f32;
    var phi_5389_: f32;
    var phi_5396_: f32;
    var phi_5401_: f32;
    var phi_5414_: f32;
    var phi_5421_: f32;
    var phi_5426_: f32;
    var phi_5433_: f32;
    var phi_5438_: f32;
    var phi_5443_: f32;
    var phi_5460_: f32;
    var phi_5467_: f32;
    var phi_5472_: f32;
    var phi_5479_: f32;
    var phi_5484_: f32;
    var phi_5498_: f32;
    var phi_5505_: f32;
    var phi_5510_: f32;
    var phi_5517_: f32;
    var phi_5522_: f32;
    var phi_5527_: f32;
    var phi_5544_: f32;
    var phi_5551_: f32;
    var phi_5556_: f32;
    var phi_5563_: f32;
    var phi_5568_: f32;
    var phi_5582_: f32;
    var phi_5589_: f32;
    var phi_5594_: f32;
    var phi_5601_: f32;
    var phi_5606_: f32;
    var phi_5611_: f32;
    var phi_5642_: f32;
    var phi_5648_: f32;
    var phi_5655_: f32;
    var phi_5662_: f32;
    var phi_5668_: f32;
    var phi_5675_: f32;
    var phi_5681_: f32;
    var phi_5687_: f32;
    var phi_5693_: f32;
    var phi_5700_: f32;
    var phi_5707_: f32;
    var phi_5731_: f32;
    var phi_5736_: f32;
    var phi_5741_: f32;
    var phi_5746_: f32;
    var phi_5751_: f32;
    var phi_5756_: f32;
    var phi_5766_: f32;
    var phi_5969_: f32;
    var phi_5976_: f32;
    var phi_5981_: f32;
    var phi_5988_: f32;
    var phi_5993_: f32;
    var phi_6006_: f32;
    var phi_6013_: f32;
    var phi_6018_: f32;
    var phi_6025_: f32;
    var phi_6030_: f32;
    var phi_6035_: f32;
    var phi_6052_: f32;
    var phi_6059_: f32;
    var phi_6064_: f32;
    var phi_6071_: f32;
    var phi_6076_: f32;
    var phi_6090_: f32;
    var phi_6097_: f32;
    var phi_6102_: f32;
    var phi_6109_: f32;
    var phi_6114_: f32;
    var phi_6119_: f32;
    var phi_6136_: f32;
    var phi_6143_: f32;
    var phi_6148_: f32;
    var phi_6155_: f32;
    var phi_6160_: f32;
    var phi_6174_: f32;
    var phi_6181_: f32;
    var phi_6186_: f32;
    var phi_6193_: f32;
    var phi_6198_: f32;
    var phi_6203_: f32;
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
    var phi_6342_: f32;
    var phi_6347_: f32;
    var phi_6353_: f32;
    var phi_6359_: f32;
    var phi_6366_: f32;
    var phi_6377_: f32;
    var phi_6448_: f32;
    var phi_6453_: f32;
    var phi_6458_: f32;
    var phi_6463_: f32;
    var phi_6468_: f32;
    var phi_6473_: f32;
    var phi_6478_: f32;
    var phi_6483_: f32;
    var phi_6488_: f32;
    var phi_6493_: f32;
    var phi_6498_: f32;
    var phi_6503_: f32;
    var phi_6508_: f32;
    var phi_6513_: f32;
    var phi_6519_: f32;
    var phi_6525_: f32;
    var phi_6532_: f32;
    var phi_6543_: f32;
    var phi_6553_: f32;
    var phi_6735_: bool;
    var phi_6737_: bool;
    var phi_6739_: bool;
    var phi_6746_: u32;
    var phi_6747_: u32;
    var phi_6748_: bool;
    var phi_6749_: u32;
    var phi_6750_: bool;
    var phi_6751_: type_12;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e51 = id_2;
    let _e52 = n_2;
    let _e53 = lane_2;
    let _e66 = ((_e51.y * _e52.x) + _e51.x);
    let _e69 = (_e52.x * _e52.y);
    let _e72 = params.member.member_1.member_2;
    let _e74 = input.member[0u];
    if (_e72 < _e74) {
        phi_316_ = _e72;
    } else {
        phi_316_ = _e74;
    }
    let _e77 = phi_316_;
    let _e79 = params.member.member_1.member_1;
    if (_e77 > _e79) {
        let _e82 = params.member.member_1.member_1;
        phi_326_ = (_e77 - _e82);
    } else {
        phi_326_ = 0u;
    }
    let _e85 = phi_326_;
    let _e87 = params.member.member_1.member;
    if (_e87 < _e85) {
        phi_333_ = _e87;
    } else {
        phi_333_ = _e85;
    }
    let _e90 = phi_333_;
    let _e91 = (_e90 / 128u);
    if ((_e90 % 128u) > 0u) {
        phi_349_ = (_e91 + 1u);
    } else {
        phi_349_ = _e91;
    }
    let _e96 = phi_349_;
    if (_e96 > _e66) {
        let _e98 = (_e96 - _e66);
        if (_e69 == 0u) {
            return;
        }
        let _e100 = (_e98 / _e69);
        if (_e69 == 0u) {
            return;
        }
        if ((_e98 % _e69) > 0u) {
            phi_370_ = (_e100 + 1u);
        } else {
            phi_370_ = _e100;
        }
        let _e106 = phi_370_;
        phi_371_ = _e106;
    } else {
        phi_371_ = 0u;
    }
    let _e108 = phi_371_;
    phi_374_ = type_12(0u, _e108);
    loop {
        let _e111 = phi_374_;
        if (_e111.member < _e111.member_1) {
            phi_375_ = type_12((_e111.member + 1u), _e111.member_1);
            phi_398_ = type_12(1u, _e111.member);
        } else {
            phi_375_ = _e111;
            phi_398_ = type_12(0u, type_12().member_1);
        }
        let _e123 = phi_375_;
        let _e125 = phi_398_;
        let _e129 = (bitcast<i32>(_e125.member) != 0i);
        if _e129 {
            let _e133 = (((_e66 + (_e125.member_1 * _e69)) * 128u) + _e53);
            if (_e53 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e133 < _e90) {
                let _e139 = params.member.member_1.member_1;
                let _e141 = (2u * (_e139 + _e133));
                let _e144 = input.member[(4u + _e141)];
                let _e147 = input.member[(_e141 + 5u)];
                let _e150 = elements.member[_e144];
                let _e152 = elements.member[_e147];
                let _e162 = params.member.member.member_2[1u];
                let _e166 = params.member.member.member_2[1u];
                let _e169 = boxes.member[(_e162 + _e144)];
                let _e171 = boxes.member[(_e166 + _e147)];
                let _e174 = params.member.member.member_1;
                if ((_e174 & 1u) != 0u) {
                    if (_e152[0] == _e150[0]) {
                        phi_553_ = true;
                    } else {
                        phi_553_ = (_e152[0] == _e150[1]);
                    }
                    let _e180 = phi_553_;
                    if (_e152[1] == _e150[0]) {
                        phi_559_ = true;
                    } else {
                        phi_559_ = (_e152[1] == _e150[1]);
                    }
                    let _e184 = phi_559_;
                    if (_e180 || _e184) {
                        phi_565_ = false;
                    } else {
                        phi_565_ = true;
                    }
                    let _e187 = phi_565_;
                    phi_566_ = _e187;
                } else {
                    phi_566_ = true;
                }
                let _e189 = phi_566_;
                if _e189 {
                    let _e191 = params.member.member.member_1;
                    if ((_e191 & 2u) != 0u) {
                        let _e195 = bodies.member[_e150[0]];
                        let _e197 = bodies.member[_e152[0]];
                        if ((_e195 / 4u) != (_e197 / 4u)) {
                            phi_609_ = true;
                        } else {
                            if ((_e195 & 2u) == 0u) {
                                phi_608_ = false;
                            } else {
                                phi_608_ = true;
                            }
                            let _e204 = phi_608_;
                            phi_609_ = _e204;
                        }
                        let _e206 = phi_609_;
                        if _e206 {
                            phi_616_ = (((_e195 & _e197) & 1u) == 0u);
                        } else {
                            phi_616_ = false;
                        }
                        let _e211 = phi_616_;
                        if _e211 {
                            let _e213 = params.member.member.member_1;
                            if ((_e213 & 4u) != 0u) {
                                let _e218 = params.member.member.member[0u];
                                let _e220 = bodies.member[_e218];
                                let _e223 = bodies.member[(_e218 + 1u)];
                                let _e228 = ((_e218 + 4u) + (2u * (_e195 >> bitcast<u32>(2i))));
                                let _e233 = ((_e218 + 4u) + (2u * (_e197 >> bitcast<u32>(2i))));
                                let _e235 = bodies.member[_e228];
                                let _e237 = bodies.member[_e233];
                                let _e246 = bodies.member[((((_e218 + 4u) + (2u * _e220)) + (_e235 * _e223)) + (_e237 / 32u))];
                                let _e249 = bodies.member[(_e228 + 1u)];
                                let _e252 = bodies.member[(_e233 + 1u)];
                                if (_e249 == _e252) {
                                    if (((_e246 >> bitcast<u32>(((_e237 % 32u) & 31u))) & 1u) == 1u) {
                                        phi_732_ = true;
                                    } else {
                                        phi_732_ = ((_e195 >> bitcast<u32>(2i)) == (_e197 >> bitcast<u32>(2i)));
                                    }
                                    let _e266 = phi_732_;
                                    phi_733_ = _e266;
                                } else {
                                    phi_733_ = false;
                                }
                                let _e268 = phi_733_;
                                if _e268 {
                                    let _e271 = bodies.member[(_e218 + 2u)];
                                    let _e274 = bodies.member[(_e218 + 3u)];
                                    let _e275 = (_e274 + _e218);
                                    if (_e147 < _e144) {
                                        phi_768_ = _e144;
                                        phi_769_ = _e147;
                                    } else {
                                        phi_768_ = _e147;
                                        phi_769_ = _e144;
                                    }
                                    let _e278 = phi_768_;
                                    let _e280 = phi_769_;
                                    phi_774_ = type_14(0i, 32i);
                                    phi_777_ = _e271;
                                    phi_779_ = 0u;
                                    loop {
                                        let _e282 = phi_774_;
                                        let _e284 = phi_777_;
                                        let _e286 = phi_779_;
                                        local_3 = _e286;
                                        local_4 = _e286;
                                        if (_e282.member < _e282.member_1) {
                                            let _e293 = (_e282.member + 1i);
                                            if ((false == (_e293 > _e282.member)) != false) {
                                                phi_800_ = true;
                                            } else {
                                                phi_800_ = false;
                                            }
                                            let _e298 = phi_800_;
                                            if _e298 {
                                                phi_806_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_806_ = type_15(1u, _e293);
                                            }
                                            let _e303 = phi_806_;
                                            phi_775_ = type_14(_e303.member_1, _e282.member_1);
                                            phi_820_ = type_15(1u, _e282.member);
                                        } else {
                                            phi_775_ = _e282;
                                            phi_820_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e309 = phi_775_;
                                        let _e311 = phi_820_;
                                        if (bitcast<i32>(_e311.member) != 0i) {
                                            if (_e286 >= _e284) {
                                                phi_903_ = u32();
                                                phi_904_ = u32();
                                                phi_905_ = false;
                                            } else {
                                                let _e318 = (_e286 + ((_e284 - _e286) / 2u));
                                                let _e320 = (_e275 + (3u * _e318));
                                                let _e322 = bodies.member[_e320];
                                                let _e325 = bodies.member[(_e320 + 1u)];
                                                let _e328 = bodies.member[(_e320 + 2u)];
                                                if (_e322 < 1u) {
                                                    phi_896_ = true;
                                                } else {
                                                    if (_e322 == 1u) {
                                                        if (_e325 < _e280) {
                                                            phi_890_ = false;
                                                        } else {
                                                            if (_e325 == _e280) {
                                                                if (_e328 < _e278) {
                                                                    phi_888_ = false;
                                                                } else {
                                                                    phi_888_ = true;
                                                                }
                                                                let _e335 = phi_888_;
                                                                phi_889_ = _e335;
                                                            } else {
                                                                phi_889_ = true;
                                                            }
                                                            let _e337 = phi_889_;
                                                            phi_890_ = _e337;
                                                        }
                                                        let _e339 = phi_890_;
                                                        phi_891_ = _e339;
                                                    } else {
                                                        phi_891_ = true;
                                                    }
                                                    let _e341 = phi_891_;
                                                    if _e341 {
                                                        phi_895_ = false;
                                                    } else {
                                                        phi_895_ = true;
                                                    }
                                                    let _e343 = phi_895_;
                                                    phi_896_ = _e343;
                                                }
                                                let _e345 = phi_896_;
                                                if _e345 {
                                                    phi_901_ = _e284;
                                                    phi_902_ = (_e318 + 1u);
                                                } else {
                                                    phi_901_ = _e318;
                                                    phi_902_ = _e286;
                                                }
                                                let _e348 = phi_901_;
                                                let _e350 = phi_902_;
                                                phi_903_ = _e348;
                                                phi_904_ = _e350;
                                                phi_905_ = true;
                                            }
                                            let _e352 = phi_903_;
                                            let _e354 = phi_904_;
                                            let _e356 = phi_905_;
                                            phi_778_ = _e352;
                                            phi_780_ = _e354;
                                            phi_906_ = _e356;
                                        } else {
                                            phi_778_ = u32();
                                            phi_780_ = u32();
                                            phi_906_ = false;
                                        }
                                        let _e358 = phi_778_;
                                        let _e360 = phi_780_;
                                        let _e362 = phi_906_;
                                        continue;
                                        continuing {
                                            phi_774_ = _e309;
                                            phi_777_ = _e358;
                                            phi_779_ = _e360;
                                            break if !(_e362);
                                        }
                                    }
                                    let _e365 = local_3;
                                    if (_e365 < _e271) {
                                        let _e368 = local_4;
                                        let _e370 = (_e275 + (3u * _e368));
                                        let _e372 = bodies.member[_e370];
                                        if (_e372 == 1u) {
                                            let _e376 = bodies.member[(_e370 + 1u)];
                                            if (_e376 == _e280) {
                                                let _e380 = bodies.member[(_e370 + 2u)];
                                                phi_954_ = (_e380 == _e278);
                                                phi_955_ = false;
                                            } else {
                                                phi_954_ = bool();
                                                phi_955_ = true;
                                            }
                                            let _e383 = phi_954_;
                                            let _e385 = phi_955_;
                                            phi_956_ = _e383;
                                            phi_957_ = _e385;
                                        } else {
                                            phi_956_ = bool();
                                            phi_957_ = true;
                                        }
                                        let _e387 = phi_956_;
                                        let _e389 = phi_957_;
                                        if _e389 {
                                            phi_961_ = false;
                                        } else {
                                            phi_961_ = _e387;
                                        }
                                        let _e391 = phi_961_;
                                        phi_962_ = _e391;
                                    } else {
                                        phi_962_ = false;
                                    }
                                    let _e393 = phi_962_;
                                    phi_966_ = _e393;
                                } else {
                                    phi_966_ = true;
                                }
                                let _e395 = phi_966_;
                                if _e395 {
                                    phi_970_ = false;
                                } else {
                                    phi_970_ = true;
                                }
                                let _e397 = phi_970_;
                                phi_971_ = _e397;
                            } else {
                                phi_971_ = true;
                            }
                            let _e399 = phi_971_;
                            if _e399 {
                                phi_975_ = false;
                            } else {
                                phi_975_ = true;
                            }
                            let _e401 = phi_975_;
                            phi_976_ = _e401;
                        } else {
                            phi_976_ = true;
                        }
                        let _e403 = phi_976_;
                        if _e403 {
                            phi_980_ = false;
                        } else {
                            phi_980_ = true;
                        }
                        let _e405 = phi_980_;
                        phi_981_ = _e405;
                    } else {
                        phi_981_ = true;
                    }
                    let _e407 = phi_981_;
                    if _e407 {
                        let _e409 = params.member.member.member_1;
                        if ((_e409 & 32u) != 0u) {
                            let _e413 = params.member.member.member_6;
                            let _e454 = (((((_e169.member_1[0] - _e171.member[0]) > _e413) && ((_e171.member_1[0] - _e169.member[0]) > _e413)) && (((_e169.member_1[1] - _e171.member[1]) > _e413) && ((_e171.member_1[1] - _e169.member[1]) > _e413))) && (((_e169.member_1[2] - _e171.member[2]) > _e413) && ((_e171.member_1[2] - _e169.member[2]) > _e413)));
                            if _e454 {
                                phi_1559_ = bool();
                            } else {
                                let _e456 = keys.member[_e150[0]];
                                let _e459 = keys.member[_e150[1]];
                                let _e461 = function_(_e456[0], _e459[0]);
                                let _e463 = keys.member[_e150[1]];
                                let _e465 = function_(_e461, _e463[0]);
                                let _e467 = keys.member[_e152[0]];
                                let _e470 = keys.member[_e152[1]];
                                let _e472 = function_1(_e467[3], _e470[3]);
                                let _e474 = keys.member[_e152[1]];
                                let _e476 = function_1(_e472, _e474[3]);
                                if (_e465[1] > _e476[1]) {
                                    phi_1112_ = true;
                                } else {
                                    if (_e465[1] == _e476[1]) {
                                        phi_1111_ = (_e465[0] > _e476[0]);
                                    } else {
                                        phi_1111_ = false;
                                    }
                                    let _e487 = phi_1111_;
                                    phi_1112_ = _e487;
                                }
                                let _e489 = phi_1112_;
                                let _e492 = keys.member[_e152[0]];
                                let _e495 = keys.member[_e152[1]];
                                let _e497 = function_(_e492[0], _e495[0]);
                                let _e499 = keys.member[_e152[1]];
                                let _e501 = function_(_e497, _e499[0]);
                                let _e503 = keys.member[_e150[0]];
                                let _e506 = keys.member[_e150[1]];
                                let _e508 = function_1(_e503[3], _e506[3]);
                                let _e510 = keys.member[_e150[1]];
                                let _e512 = function_1(_e508, _e510[3]);
                                if (_e501[1] > _e512[1]) {
                                    phi_1200_ = true;
                                } else {
                                    if (_e501[1] == _e512[1]) {
                                        phi_1199_ = (_e501[0] > _e512[0]);
                                    } else {
                                        phi_1199_ = false;
                                    }
                                    let _e523 = phi_1199_;
                                    phi_1200_ = _e523;
                                }
                                let _e525 = phi_1200_;
                                let _e529 = keys.member[_e150[0]];
                                let _e532 = keys.member[_e150[1]];
                                let _e534 = function_2(_e529[1], _e532[1]);
                                let _e536 = keys.member[_e150[1]];
                                let _e538 = function_2(_e534, _e536[1]);
                                let _e540 = keys.member[_e152[0]];
                                let _e543 = keys.member[_e152[1]];
                                let _e545 = function_3(_e540[4], _e543[4]);
                                let _e547 = keys.member[_e152[1]];
                                let _e549 = function_3(_e545, _e547[4]);
                                if (_e538[1] > _e549[1]) {
                                    phi_1289_ = true;
                                } else {
                                    if (_e538[1] == _e549[1]) {
                                        phi_1288_ = (_e538[0] > _e549[0]);
                                    } else {
                                        phi_1288_ = false;
                                    }
                                    let _e560 = phi_1288_;
                                    phi_1289_ = _e560;
                                }
                                let _e562 = phi_1289_;
                                let _e565 = keys.member[_e152[0]];
                                let _e568 = keys.member[_e152[1]];
                                let _e570 = function_2(_e565[1], _e568[1]);
                                let _e572 = keys.member[_e152[1]];
                                let _e574 = function_2(_e570, _e572[1]);
                                let _e576 = keys.member[_e150[0]];
                                let _e579 = keys.member[_e150[1]];
                                let _e581 = function_3(_e576[4], _e579[4]);
                                let _e583 = keys.member[_e150[1]];
                                let _e585 = function_3(_e581, _e583[4]);
                                if (_e574[1] > _e585[1]) {
                                    phi_1377_ = true;
                                } else {
                                    if (_e574[1] == _e585[1]) {
                                        phi_1376_ = (_e574[0] > _e585[0]);
                                    } else {
                                        phi_1376_ = false;
                                    }
                                    let _e596 = phi_1376_;
                                    phi_1377_ = _e596;
                                }
                                let _e598 = phi_1377_;
                                let _e603 = keys.member[_e150[0]];
                                let _e606 = keys.member[_e150[1]];
                                let _e608 = function_4(_e603[2], _e606[2]);
                                let _e610 = keys.member[_e150[1]];
                                let _e612 = function_4(_e608, _e610[2]);
                                let _e614 = keys.member[_e152[0]];
                                let _e617 = keys.member[_e152[1]];
                                let _e619 = function_5(_e614[5], _e617[5]);
                                let _e621 = keys.member[_e152[1]];
                                let _e623 = function_5(_e619, _e621[5]);
                                if (_e612[1] > _e623[1]) {
                                    phi_1467_ = true;
                                } else {
                                    if (_e612[1] == _e623[1]) {
                                        phi_1466_ = (_e612[0] > _e623[0]);
                                    } else {
                                        phi_1466_ = false;
                                    }
                                    let _e634 = phi_1466_;
                                    phi_1467_ = _e634;
                                }
                                let _e636 = phi_1467_;
                                let _e639 = keys.member[_e152[0]];
                                let _e642 = keys.member[_e152[1]];
                                let _e644 = function_4(_e639[2], _e642[2]);
                                let _e646 = keys.member[_e152[1]];
                                let _e648 = function_4(_e644, _e646[2]);
                                let _e650 = keys.member[_e150[0]];
                                let _e653 = keys.member[_e150[1]];
                                let _e655 = function_5(_e650[5], _e653[5]);
                                let _e657 = keys.member[_e150[1]];
                                let _e659 = function_5(_e655, _e657[5]);
                                if (_e648[1] > _e659[1]) {
                                    phi_1555_ = true;
                                } else {
                                    if (_e648[1] == _e659[1]) {
                                        phi_1554_ = (_e648[0] > _e659[0]);
                                    } else {
                                        phi_1554_ = false;
                                    }
                                    let _e670 = phi_1554_;
                                    phi_1555_ = _e670;
                                }
                                let _e672 = phi_1555_;
                                phi_1559_ = (((!(_e489) && !(_e525)) && (!(_e562) && !(_e598))) && (!(_e636) && !(_e672)));
                            }
                            let _e677 = phi_1559_;
                            phi_1560_ = _e677;
                            phi_1561_ = _e454;
                        } else {
                            phi_1560_ = bool();
                            phi_1561_ = true;
                        }
                        let _e679 = phi_1560_;
                        let _e681 = phi_1561_;
                        if _e681 {
                            phi_1565_ = false;
                        } else {
                            phi_1565_ = true;
                        }
                        let _e683 = phi_1565_;
                        phi_1566_ = _e679;
                        phi_1567_ = _e683;
                    } else {
                        phi_1566_ = false;
                        phi_1567_ = true;
                    }
                    let _e685 = phi_1566_;
                    let _e687 = phi_1567_;
                    phi_1568_ = _e685;
                    phi_1569_ = _e687;
                } else {
                    phi_1568_ = false;
                    phi_1569_ = true;
                }
                let _e689 = phi_1568_;
                let _e691 = phi_1569_;
                if _e691 {
                    phi_1573_ = _e689;
                } else {
                    phi_1573_ = true;
                }
                let _e693 = phi_1573_;
                if _e693 {
                    let _e695 = atomicAdd((&counters[1u]), 1u);
                    let _e698 = params.member.member.member_4;
                    let _e700 = params.member.member.member_5;
                    let _e702 = paths.member[_e150[0]];
                    let _e704 = paths.member[_e150[1]];
                    let _e710 = paths.member[_e152[0]];
                    let _e712 = paths.member[_e152[1]];
                    local_2 = type_30(array<array<f32, 3>, 2>(array<f32, 3>((_e710.member[0] - _e702.member[0]), (_e710.member[1] - _e702.member[1]), (_e710.member[2] - _e702.member[2])), array<f32, 3>((_e710.member_1[0] - _e702.member_1[0]), (_e710.member_1[1] - _e702.member_1[1]), (_e710.member_1[2] - _e702.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e704.member[0] - _e702.member[0]), (_e704.member[1] - _e702.member[1]), (_e704.member[2] - _e702.member[2])), array<f32, 3>((_e704.member_1[0] - _e702.member_1[0]), (_e704.member_1[1] - _e702.member_1[1]), (_e704.member_1[2] - _e702.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e710.member[0] - _e712.member[0]), (_e710.member[1] - _e712.member[1]), (_e710.member[2] - _e712.member[2])), array<f32, 3>((_e710.member_1[0] - _e712.member_1[0]), (_e710.member_1[1] - _e712.member_1[1]), (_e710.member_1[2] - _e712.member_1[2]))), (_e698 + _e698));
                    let _e772 = local_2.member_1[0u];
                    let _e778 = local_2.member_2[0u];
                    let _e784 = ((_e772[1] * _e778[2]) - (_e772[2] * _e778[1]));
                    let _e787 = ((_e772[2] * _e778[0]) - (_e772[0] * _e778[2]));
                    let _e790 = ((_e772[0] * _e778[1]) - (_e772[1] * _e778[0]));
                    let _e793 = local_2.member_1[1u];
                    let _e799 = local_2.member_2[1u];
                    let _e805 = ((_e793[1] * _e799[2]) - (_e793[2] * _e799[1]));
                    let _e808 = ((_e793[2] * _e799[0]) - (_e793[0] * _e799[2]));
                    let _e811 = ((_e793[0] * _e799[1]) - (_e793[1] * _e799[0]));
                    let _e814 = local_2.member_1[0u];
                    let _e820 = local_2.member_2[1u];
                    let _e835 = local_2.member_1[1u];
                    let _e841 = local_2.member_2[0u];
                    let _e854 = (((_e814[1] * _e820[2]) - (_e814[2] * _e820[1])) + ((_e835[1] * _e841[2]) - (_e835[2] * _e841[1])));
                    let _e855 = (((_e814[2] * _e820[0]) - (_e814[0] * _e820[2])) + ((_e835[2] * _e841[0]) - (_e835[0] * _e841[2])));
                    let _e856 = (((_e814[0] * _e820[1]) - (_e814[1] * _e820[0])) + ((_e835[0] * _e841[1]) - (_e835[1] * _e841[0])));
                    let _e859 = local_2.member[0u];
                    let _e870 = local_2.member[1u];
                    let _e881 = local_2.member[0u];
                    let _e890 = ((((_e870[0] * _e784) + (_e870[1] * _e787)) + (_e870[2] * _e790)) + (((_e881[0] * _e854) + (_e881[1] * _e855)) + (_e881[2] * _e856)));
                    let _e893 = local_2.member[0u];
                    let _e904 = local_2.member[1u];
                    let _e913 = ((((_e893[0] * _e805) + (_e893[1] * _e808)) + (_e893[2] * _e811)) + (((_e904[0] * _e854) + (_e904[1] * _e855)) + (_e904[2] * _e856)));
                    let _e916 = local_2.member[1u];
                    let _e927 = local_2.member[0u];
                    if (_e927[0] < 0f) {
                        phi_1964_ = -(_e927[0]);
                    } else {
                        phi_1964_ = _e927[0];
                    }
                    let _e934 = phi_1964_;
                    if (_e927[1] < 0f) {
                        phi_1971_ = -(_e927[1]);
                    } else {
                        phi_1971_ = _e927[1];
                    }
                    let _e938 = phi_1971_;
                    if (_e934 > _e938) {
                        phi_1976_ = _e934;
                    } else {
                        phi_1976_ = _e938;
                    }
                    let _e941 = phi_1976_;
                    if (_e927[2] < 0f) {
                        phi_1983_ = -(_e927[2]);
                    } else {
                        phi_1983_ = _e927[2];
                    }
                    let _e945 = phi_1983_;
                    if (_e941 > _e945) {
                        phi_1988_ = _e941;
                    } else {
                        phi_1988_ = _e945;
                    }
                    let _e948 = phi_1988_;
                    let _e951 = local_2.member[1u];
                    if (_e951[0] < 0f) {
                        phi_2001_ = -(_e951[0]);
                    } else {
                        phi_2001_ = _e951[0];
                    }
                    let _e958 = phi_2001_;
                    if (_e951[1] < 0f) {
                        phi_2008_ = -(_e951[1]);
                    } else {
                        phi_2008_ = _e951[1];
                    }
                    let _e962 = phi_2008_;
                    if (_e958 > _e962) {
                        phi_2013_ = _e958;
                    } else {
                        phi_2013_ = _e962;
                    }
                    let _e965 = phi_2013_;
                    if (_e951[2] < 0f) {
                        phi_2020_ = -(_e951[2]);
                    } else {
                        phi_2020_ = _e951[2];
                    }
                    let _e969 = phi_2020_;
                    if (_e965 > _e969) {
                        phi_2025_ = _e965;
                    } else {
                        phi_2025_ = _e969;
                    }
                    let _e972 = phi_2025_;
                    if (_e948 > _e972) {
                        phi_2030_ = _e948;
                    } else {
                        phi_2030_ = _e972;
                    }
                    let _e975 = phi_2030_;
                    let _e977 = local_2.member_3;
                    let _e978 = (_e975 + _e977);
                    let _e981 = local_2.member_1[0u];
                    if (_e981[0] < 0f) {
                        phi_2047_ = -(_e981[0]);
                    } else {
                        phi_2047_ = _e981[0];
                    }
                    let _e988 = phi_2047_;
                    if (_e981[1] < 0f) {
                        phi_2054_ = -(_e981[1]);
                    } else {
                        phi_2054_ = _e981[1];
                    }
                    let _e992 = phi_2054_;
                    if (_e988 > _e992) {
                        phi_2059_ = _e988;
                    } else {
                        phi_2059_ = _e992;
                    }
                    let _e995 = phi_2059_;
                    if (_e981[2] < 0f) {
                        phi_2066_ = -(_e981[2]);
                    } else {
                        phi_2066_ = _e981[2];
                    }
                    let _e999 = phi_2066_;
                    if (_e995 > _e999) {
                        phi_2071_ = _e995;
                    } else {
                        phi_2071_ = _e999;
                    }
                    let _e1002 = phi_2071_;
                    let _e1005 = local_2.member_1[1u];
                    if (_e1005[0] < 0f) {
                        phi_2085_ = -(_e1005[0]);
                    } else {
                        phi_2085_ = _e1005[0];
                    }
                    let _e1012 = phi_2085_;
                    if (_e1005[1] < 0f) {
                        phi_2092_ = -(_e1005[1]);
                    } else {
                        phi_2092_ = _e1005[1];
                    }
                    let _e1016 = phi_2092_;
                    if (_e1012 > _e1016) {
                        phi_2097_ = _e1012;
                    } else {
                        phi_2097_ = _e1016;
                    }
                    let _e1019 = phi_2097_;
                    if (_e1005[2] < 0f) {
                        phi_2104_ = -(_e1005[2]);
                    } else {
                        phi_2104_ = _e1005[2];
                    }
                    let _e1023 = phi_2104_;
                    if (_e1019 > _e1023) {
                        phi_2109_ = _e1019;
                    } else {
                        phi_2109_ = _e1023;
                    }
                    let _e1026 = phi_2109_;
                    if (_e1002 > _e1026) {
                        phi_2114_ = _e1002;
                    } else {
                        phi_2114_ = _e1026;
                    }
                    let _e1029 = phi_2114_;
                    let _e1031 = local_2.member_3;
                    let _e1032 = (_e1029 + _e1031);
                    let _e1035 = local_2.member_2[0u];
                    if (_e1035[0] < 0f) {
                        phi_2131_ = -(_e1035[0]);
                    } else {
                        phi_2131_ = _e1035[0];
                    }
                    let _e1042 = phi_2131_;
                    if (_e1035[1] < 0f) {
                        phi_2138_ = -(_e1035[1]);
                    } else {
                        phi_2138_ = _e1035[1];
                    }
                    let _e1046 = phi_2138_;
                    if (_e1042 > _e1046) {
                        phi_2143_ = _e1042;
                    } else {
                        phi_2143_ = _e1046;
                    }
                    let _e1049 = phi_2143_;
                    if (_e1035[2] < 0f) {
                        phi_2150_ = -(_e1035[2]);
                    } else {
                        phi_2150_ = _e1035[2];
                    }
                    let _e1053 = phi_2150_;
                    if (_e1049 > _e1053) {
                        phi_2155_ = _e1049;
                    } else {
                        phi_2155_ = _e1053;
                    }
                    let _e1056 = phi_2155_;
                    let _e1059 = local_2.member_2[1u];
                    if (_e1059[0] < 0f) {
                        phi_2169_ = -(_e1059[0]);
                    } else {
                        phi_2169_ = _e1059[0];
                    }
                    let _e1066 = phi_2169_;
                    if (_e1059[1] < 0f) {
                        phi_2176_ = -(_e1059[1]);
                    } else {
                        phi_2176_ = _e1059[1];
                    }
                    let _e1070 = phi_2176_;
                    if (_e1066 > _e1070) {
                        phi_2181_ = _e1066;
                    } else {
                        phi_2181_ = _e1070;
                    }
                    let _e1073 = phi_2181_;
                    if (_e1059[2] < 0f) {
                        phi_2188_ = -(_e1059[2]);
                    } else {
                        phi_2188_ = _e1059[2];
                    }
                    let _e1077 = phi_2188_;
                    if (_e1073 > _e1077) {
                        phi_2193_ = _e1073;
                    } else {
                        phi_2193_ = _e1077;
                    }
                    let _e1080 = phi_2193_;
                    if (_e1056 > _e1080) {
                        phi_2198_ = _e1056;
                    } else {
                        phi_2198_ = _e1080;
                    }
                    let _e1083 = phi_2198_;
                    let _e1085 = local_2.member_3;
                    let _e1086 = (_e1083 + _e1085);
                    let _e1088 = ((_e1032 * 8f) * _e1086);
                    let _e1095 = local_2.member_3;
                    if (_e784 < 0f) {
                        phi_2229_ = -(_e784);
                    } else {
                        phi_2229_ = _e784;
                    }
                    let _e1112 = phi_2229_;
                    if (_e787 < 0f) {
                        phi_2235_ = -(_e787);
                    } else {
                        phi_2235_ = _e787;
                    }
                    let _e1116 = phi_2235_;
                    if (_e790 < 0f) {
                        phi_2242_ = -(_e790);
                    } else {
                        phi_2242_ = _e790;
                    }
                    let _e1121 = phi_2242_;
                    let _e1122 = ((_e1112 + _e1116) + _e1121);
                    if (_e805 < 0f) {
                        phi_2249_ = -(_e805);
                    } else {
                        phi_2249_ = _e805;
                    }
                    let _e1126 = phi_2249_;
                    if (_e808 < 0f) {
                        phi_2255_ = -(_e808);
                    } else {
                        phi_2255_ = _e808;
                    }
                    let _e1130 = phi_2255_;
                    if (_e811 < 0f) {
                        phi_2262_ = -(_e811);
                    } else {
                        phi_2262_ = _e811;
                    }
                    let _e1135 = phi_2262_;
                    let _e1136 = ((_e1126 + _e1130) + _e1135);
                    if (_e1122 > _e1136) {
                        phi_2268_ = _e1122;
                    } else {
                        phi_2268_ = _e1136;
                    }
                    let _e1139 = phi_2268_;
                    if (_e854 < 0f) {
                        phi_2274_ = -(_e854);
                    } else {
                        phi_2274_ = _e854;
                    }
                    let _e1143 = phi_2274_;
                    if (_e855 < 0f) {
                        phi_2280_ = -(_e855);
                    } else {
                        phi_2280_ = _e855;
                    }
                    let _e1147 = phi_2280_;
                    if (_e856 < 0f) {
                        phi_2287_ = -(_e856);
                    } else {
                        phi_2287_ = _e856;
                    }
                    let _e1152 = phi_2287_;
                    let _e1154 = (((_e1143 + _e1147) + _e1152) * 0.5f);
                    if (_e1139 > _e1154) {
                        phi_2294_ = _e1139;
                    } else {
                        phi_2294_ = _e1154;
                    }
                    let _e1157 = phi_2294_;
                    let _e1162 = local_2.member_3;
                    let _e1175 = ((((_e859[0] * _e784) + (_e859[1] * _e787)) + (_e859[2] * _e790)) * 3f);
                    let _e1176 = ((((_e916[0] * _e805) + (_e916[1] * _e808)) + (_e916[2] * _e811)) * 3f);
                    if (_e1175 < _e1176) {
                        phi_2318_ = _e1175;
                    } else {
                        phi_2318_ = _e1176;
                    }
                    let _e1179 = phi_2318_;
                    if (_e890 < _e913) {
                        phi_2323_ = _e890;
                    } else {
                        phi_2323_ = _e913;
                    }
                    let _e1182 = phi_2323_;
                    if (_e1179 < _e1182) {
                        phi_2328_ = _e1179;
                    } else {
                        phi_2328_ = _e1182;
                    }
                    let _e1185 = phi_2328_;
                    if (_e1175 > _e1176) {
                        phi_2333_ = _e1175;
                    } else {
                        phi_2333_ = _e1176;
                    }
                    let _e1188 = phi_2333_;
                    if (_e890 > _e913) {
                        phi_2338_ = _e890;
                    } else {
                        phi_2338_ = _e913;
                    }
                    let _e1191 = phi_2338_;
                    if (_e1188 > _e1191) {
                        phi_2343_ = _e1188;
                    } else {
                        phi_2343_ = _e1191;
                    }
                    let _e1194 = phi_2343_;
                    let _e1199 = -(_e1194);
                    if (_e1185 > _e1199) {
                        phi_2353_ = _e1185;
                    } else {
                        phi_2353_ = _e1199;
                    }
                    let _e1202 = phi_2353_;
                    let _e1204 = ((_e1202 - ((((((_e978 * 8f) * _e1088) * (0.000000059604645f * (524f / 64f))) + ((_e1095 * 19f) * ((_e978 * (_e1032 + _e1086)) + (_e1032 * _e1086)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e978) * ((1f + _e1032) * (1f + _e1086))))) + ((_e700 * (((_e1157 + (_e1088 * (0.000000059604645f * 8f))) + ((_e1162 * 6f) * (_e1032 + _e1086))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1032) * (1f + _e1086))))) * (3f * 1.0001f)))) > 0f);
                    if _e1204 {
                        phi_3322_ = _e1204;
                    } else {
                        let _e1207 = local_2.member_1[0u];
                        let _e1213 = local_2.member_1[1u];
                        let _e1217 = (_e1207[0] + _e1213[0]);
                        let _e1218 = (_e1207[1] + _e1213[1]);
                        let _e1219 = (_e1207[2] + _e1213[2]);
                        let _e1222 = local_2.member_2[0u];
                        let _e1228 = local_2.member_2[1u];
                        let _e1232 = (_e1222[0] + _e1228[0]);
                        let _e1233 = (_e1222[1] + _e1228[1]);
                        let _e1234 = (_e1222[2] + _e1228[2]);
                        let _e1237 = ((_e1218 * _e1234) - (_e1219 * _e1233));
                        let _e1240 = ((_e1219 * _e1232) - (_e1217 * _e1234));
                        let _e1243 = ((_e1217 * _e1233) - (_e1218 * _e1232));
                        let _e1246 = local_2.member[0u];
                        let _e1252 = local_2.member_1[0u];
                        let _e1258 = local_2.member_2[0u];
                        let _e1262 = (_e1246[0] - _e1252[0]);
                        let _e1263 = (_e1246[1] - _e1252[1]);
                        let _e1264 = (_e1246[2] - _e1252[2]);
                        let _e1265 = (_e1262 - _e1258[0]);
                        let _e1266 = (_e1263 - _e1258[1]);
                        let _e1267 = (_e1264 - _e1258[2]);
                        let _e1268 = (_e1246[0] - _e1258[0]);
                        let _e1269 = (_e1246[1] - _e1258[1]);
                        let _e1270 = (_e1246[2] - _e1258[2]);
                        let _e1273 = local_2.member[1u];
                        let _e1279 = local_2.member_1[1u];
                        let _e1285 = local_2.member_2[1u];
                        let _e1289 = (_e1273[0] - _e1279[0]);
                        let _e1290 = (_e1273[1] - _e1279[1]);
                        let _e1291 = (_e1273[2] - _e1279[2]);
                        let _e1292 = (_e1289 - _e1285[0]);
                        let _e1293 = (_e1290 - _e1285[1]);
                        let _e1294 = (_e1291 - _e1285[2]);
                        let _e1295 = (_e1273[0] - _e1285[0]);
                        let _e1296 = (_e1273[1] - _e1285[1]);
                        let _e1297 = (_e1273[2] - _e1285[2]);
                        let _e1300 = local_2.member[0u];
                        if (_e1300[0] < 0f) {
                            phi_2556_ = -(_e1300[0]);
                        } else {
                            phi_2556_ = _e1300[0];
                        }
                        let _e1307 = phi_2556_;
                        if (_e1300[1] < 0f) {
                            phi_2563_ = -(_e1300[1]);
                        } else {
                            phi_2563_ = _e1300[1];
                        }
                        let _e1311 = phi_2563_;
                        if (_e1307 > _e1311) {
                            phi_2568_ = _e1307;
                        } else {
                            phi_2568_ = _e1311;
                        }
                        let _e1314 = phi_2568_;
                        if (_e1300[2] < 0f) {
                            phi_2575_ = -(_e1300[2]);
                        } else {
                            phi_2575_ = _e1300[2];
                        }
                        let _e1318 = phi_2575_;
                        if (_e1314 > _e1318) {
                            phi_2580_ = _e1314;
                        } else {
                            phi_2580_ = _e1318;
                        }
                        let _e1321 = phi_2580_;
                        let _e1324 = local_2.member[1u];
                        if (_e1324[0] < 0f) {
                            phi_2593_ = -(_e1324[0]);
                        } else {
                            phi_2593_ = _e1324[0];
                        }
                        let _e1331 = phi_2593_;
                        if (_e1324[1] < 0f) {
                            phi_2600_ = -(_e1324[1]);
                        } else {
                            phi_2600_ = _e1324[1];
                        }
                        let _e1335 = phi_2600_;
                        if (_e1331 > _e1335) {
                            phi_2605_ = _e1331;
                        } else {
                            phi_2605_ = _e1335;
                        }
                        let _e1338 = phi_2605_;
                        if (_e1324[2] < 0f) {
                            phi_2612_ = -(_e1324[2]);
                        } else {
                            phi_2612_ = _e1324[2];
                        }
                        let _e1342 = phi_2612_;
                        if (_e1338 > _e1342) {
                            phi_2617_ = _e1338;
                        } else {
                            phi_2617_ = _e1342;
                        }
                        let _e1345 = phi_2617_;
                        if (_e1321 > _e1345) {
                            phi_2622_ = _e1321;
                        } else {
                            phi_2622_ = _e1345;
                        }
                        let _e1348 = phi_2622_;
                        let _e1350 = local_2.member_3;
                        let _e1354 = local_2.member_1[0u];
                        if (_e1354[0] < 0f) {
                            phi_2639_ = -(_e1354[0]);
                        } else {
                            phi_2639_ = _e1354[0];
                        }
                        let _e1361 = phi_2639_;
                        if (_e1354[1] < 0f) {
                            phi_2646_ = -(_e1354[1]);
                        } else {
                            phi_2646_ = _e1354[1];
                        }
                        let _e1365 = phi_2646_;
                        if (_e1361 > _e1365) {
                            phi_2651_ = _e1361;
                        } else {
                            phi_2651_ = _e1365;
                        }
                        let _e1368 = phi_2651_;
                        if (_e1354[2] < 0f) {
                            phi_2658_ = -(_e1354[2]);
                        } else {
                            phi_2658_ = _e1354[2];
                        }
                        let _e1372 = phi_2658_;
                        if (_e1368 > _e1372) {
                            phi_2663_ = _e1368;
                        } else {
                            phi_2663_ = _e1372;
                        }
                        let _e1375 = phi_2663_;
                        let _e1378 = local_2.member_1[1u];
                        if (_e1378[0] < 0f) {
                            phi_2677_ = -(_e1378[0]);
                        } else {
                            phi_2677_ = _e1378[0];
                        }
                        let _e1385 = phi_2677_;
                        if (_e1378[1] < 0f) {
                            phi_2684_ = -(_e1378[1]);
                        } else {
                            phi_2684_ = _e1378[1];
                        }
                        let _e1389 = phi_2684_;
                        if (_e1385 > _e1389) {
                            phi_2689_ = _e1385;
                        } else {
                            phi_2689_ = _e1389;
                        }
                        let _e1392 = phi_2689_;
                        if (_e1378[2] < 0f) {
                            phi_2696_ = -(_e1378[2]);
                        } else {
                            phi_2696_ = _e1378[2];
                        }
                        let _e1396 = phi_2696_;
                        if (_e1392 > _e1396) {
                            phi_2701_ = _e1392;
                        } else {
                            phi_2701_ = _e1396;
                        }
                        let _e1399 = phi_2701_;
                        if (_e1375 > _e1399) {
                            phi_2706_ = _e1375;
                        } else {
                            phi_2706_ = _e1399;
                        }
                        let _e1402 = phi_2706_;
                        let _e1404 = local_2.member_3;
                        let _e1408 = local_2.member_2[0u];
                        if (_e1408[0] < 0f) {
                            phi_2723_ = -(_e1408[0]);
                        } else {
                            phi_2723_ = _e1408[0];
                        }
                        let _e1415 = phi_2723_;
                        if (_e1408[1] < 0f) {
                            phi_2730_ = -(_e1408[1]);
                        } else {
                            phi_2730_ = _e1408[1];
                        }
                        let _e1419 = phi_2730_;
                        if (_e1415 > _e1419) {
                            phi_2735_ = _e1415;
                        } else {
                            phi_2735_ = _e1419;
                        }
                        let _e1422 = phi_2735_;
                        if (_e1408[2] < 0f) {
                            phi_2742_ = -(_e1408[2]);
                        } else {
                            phi_2742_ = _e1408[2];
                        }
                        let _e1426 = phi_2742_;
                        if (_e1422 > _e1426) {
                            phi_2747_ = _e1422;
                        } else {
                            phi_2747_ = _e1426;
                        }
                        let _e1429 = phi_2747_;
                        let _e1432 = local_2.member_2[1u];
                        if (_e1432[0] < 0f) {
                            phi_2761_ = -(_e1432[0]);
                        } else {
                            phi_2761_ = _e1432[0];
                        }
                        let _e1439 = phi_2761_;
                        if (_e1432[1] < 0f) {
                            phi_2768_ = -(_e1432[1]);
                        } else {
                            phi_2768_ = _e1432[1];
                        }
                        let _e1443 = phi_2768_;
                        if (_e1439 > _e1443) {
                            phi_2773_ = _e1439;
                        } else {
                            phi_2773_ = _e1443;
                        }
                        let _e1446 = phi_2773_;
                        if (_e1432[2] < 0f) {
                            phi_2780_ = -(_e1432[2]);
                        } else {
                            phi_2780_ = _e1432[2];
                        }
                        let _e1450 = phi_2780_;
                        if (_e1446 > _e1450) {
                            phi_2785_ = _e1446;
                        } else {
                            phi_2785_ = _e1450;
                        }
                        let _e1453 = phi_2785_;
                        if (_e1429 > _e1453) {
                            phi_2790_ = _e1429;
                        } else {
                            phi_2790_ = _e1453;
                        }
                        let _e1456 = phi_2790_;
                        let _e1458 = local_2.member_3;
                        let _e1462 = ((((_e1348 + _e1350) + (_e1402 + _e1404)) + (_e1456 + _e1458)) * 2f);
                        let _e1465 = local_2.member_3;
                        let _e1469 = (((_e700 * 1.0001f) + (_e1465 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                        let _e1472 = ((_e1240 * _e1219) - (_e1243 * _e1218));
                        let _e1475 = ((_e1243 * _e1217) - (_e1237 * _e1219));
                        let _e1478 = ((_e1237 * _e1218) - (_e1240 * _e1217));
                        let _e1483 = (((_e1472 * _e1246[0]) + (_e1475 * _e1246[1])) + (_e1478 * _e1246[2]));
                        let _e1488 = (((_e1472 * _e1262) + (_e1475 * _e1263)) + (_e1478 * _e1264));
                        let _e1493 = (((_e1472 * _e1268) + (_e1475 * _e1269)) + (_e1478 * _e1270));
                        let _e1498 = (((_e1472 * _e1265) + (_e1475 * _e1266)) + (_e1478 * _e1267));
                        let _e1503 = (((_e1472 * _e1273[0]) + (_e1475 * _e1273[1])) + (_e1478 * _e1273[2]));
                        let _e1508 = (((_e1472 * _e1289) + (_e1475 * _e1290)) + (_e1478 * _e1291));
                        let _e1513 = (((_e1472 * _e1295) + (_e1475 * _e1296)) + (_e1478 * _e1297));
                        let _e1518 = (((_e1472 * _e1292) + (_e1475 * _e1293)) + (_e1478 * _e1294));
                        if (_e1483 < _e1488) {
                            phi_2869_ = _e1483;
                        } else {
                            phi_2869_ = _e1488;
                        }
                        let _e1521 = phi_2869_;
                        if (_e1493 < _e1498) {
                            phi_2874_ = _e1493;
                        } else {
                            phi_2874_ = _e1498;
                        }
                        let _e1524 = phi_2874_;
                        if (_e1521 < _e1524) {
                            phi_2879_ = _e1521;
                        } else {
                            phi_2879_ = _e1524;
                        }
                        let _e1527 = phi_2879_;
                        if (_e1503 < _e1508) {
                            phi_2884_ = _e1503;
                        } else {
                            phi_2884_ = _e1508;
                        }
                        let _e1530 = phi_2884_;
                        if (_e1513 < _e1518) {
                            phi_2889_ = _e1513;
                        } else {
                            phi_2889_ = _e1518;
                        }
                        let _e1533 = phi_2889_;
                        if (_e1530 < _e1533) {
                            phi_2894_ = _e1530;
                        } else {
                            phi_2894_ = _e1533;
                        }
                        let _e1536 = phi_2894_;
                        if (_e1527 < _e1536) {
                            phi_2899_ = _e1527;
                        } else {
                            phi_2899_ = _e1536;
                        }
                        let _e1539 = phi_2899_;
                        if (_e1483 > _e1488) {
                            phi_2904_ = _e1483;
                        } else {
                            phi_2904_ = _e1488;
                        }
                        let _e1542 = phi_2904_;
                        if (_e1493 > _e1498) {
                            phi_2909_ = _e1493;
                        } else {
                            phi_2909_ = _e1498;
                        }
                        let _e1545 = phi_2909_;
                        if (_e1542 > _e1545) {
                            phi_2914_ = _e1542;
                        } else {
                            phi_2914_ = _e1545;
                        }
                        let _e1548 = phi_2914_;
                        if (_e1503 > _e1508) {
                            phi_2919_ = _e1503;
                        } else {
                            phi_2919_ = _e1508;
                        }
                        let _e1551 = phi_2919_;
                        if (_e1513 > _e1518) {
                            phi_2924_ = _e1513;
                        } else {
                            phi_2924_ = _e1518;
                        }
                        let _e1554 = phi_2924_;
                        if (_e1551 > _e1554) {
                            phi_2929_ = _e1551;
                        } else {
                            phi_2929_ = _e1554;
                        }
                        let _e1557 = phi_2929_;
                        if (_e1548 > _e1557) {
                            phi_2934_ = _e1548;
                        } else {
                            phi_2934_ = _e1557;
                        }
                        let _e1560 = phi_2934_;
                        if (_e1472 < 0f) {
                            phi_2940_ = -(_e1472);
                        } else {
                            phi_2940_ = _e1472;
                        }
                        let _e1564 = phi_2940_;
                        if (_e1475 < 0f) {
                            phi_2946_ = -(_e1475);
                        } else {
                            phi_2946_ = _e1475;
                        }
                        let _e1568 = phi_2946_;
                        if (_e1478 < 0f) {
                            phi_2953_ = -(_e1478);
                        } else {
                            phi_2953_ = _e1478;
                        }
                        let _e1573 = phi_2953_;
                        let _e1574 = ((_e1564 + _e1568) + _e1573);
                        let _e1579 = -(_e1560);
                        if (_e1539 > _e1579) {
                            phi_2964_ = _e1539;
                        } else {
                            phi_2964_ = _e1579;
                        }
                        let _e1582 = phi_2964_;
                        let _e1587 = (((_e1582 - ((_e1574 * _e1462) * (0.000000059604645f * (17f / 2f)))) - (_e1574 * _e1469)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        let _e1590 = ((_e1240 * _e1234) - (_e1243 * _e1233));
                        let _e1593 = ((_e1243 * _e1232) - (_e1237 * _e1234));
                        let _e1596 = ((_e1237 * _e1233) - (_e1240 * _e1232));
                        let _e1601 = (((_e1590 * _e1246[0]) + (_e1593 * _e1246[1])) + (_e1596 * _e1246[2]));
                        let _e1606 = (((_e1590 * _e1262) + (_e1593 * _e1263)) + (_e1596 * _e1264));
                        let _e1611 = (((_e1590 * _e1268) + (_e1593 * _e1269)) + (_e1596 * _e1270));
                        let _e1616 = (((_e1590 * _e1265) + (_e1593 * _e1266)) + (_e1596 * _e1267));
                        let _e1621 = (((_e1590 * _e1273[0]) + (_e1593 * _e1273[1])) + (_e1596 * _e1273[2]));
                        let _e1626 = (((_e1590 * _e1289) + (_e1593 * _e1290)) + (_e1596 * _e1291));
                        let _e1631 = (((_e1590 * _e1295) + (_e1593 * _e1296)) + (_e1596 * _e1297));
                        let _e1636 = (((_e1590 * _e1292) + (_e1593 * _e1293)) + (_e1596 * _e1294));
                        if (_e1601 < _e1606) {
                            phi_3035_ = _e1601;
                        } else {
                            phi_3035_ = _e1606;
                        }
                        let _e1639 = phi_3035_;
                        if (_e1611 < _e1616) {
                            phi_3040_ = _e1611;
                        } else {
                            phi_3040_ = _e1616;
                        }
                        let _e1642 = phi_3040_;
                        if (_e1639 < _e1642) {
                            phi_3045_ = _e1639;
                        } else {
                            phi_3045_ = _e1642;
                        }
                        let _e1645 = phi_3045_;
                        if (_e1621 < _e1626) {
                            phi_3050_ = _e1621;
                        } else {
                            phi_3050_ = _e1626;
                        }
                        let _e1648 = phi_3050_;
                        if (_e1631 < _e1636) {
                            phi_3055_ = _e1631;
                        } else {
                            phi_3055_ = _e1636;
                        }
                        let _e1651 = phi_3055_;
                        if (_e1648 < _e1651) {
                            phi_3060_ = _e1648;
                        } else {
                            phi_3060_ = _e1651;
                        }
                        let _e1654 = phi_3060_;
                        if (_e1645 < _e1654) {
                            phi_3065_ = _e1645;
                        } else {
                            phi_3065_ = _e1654;
                        }
                        let _e1657 = phi_3065_;
                        if (_e1601 > _e1606) {
                            phi_3070_ = _e1601;
                        } else {
                            phi_3070_ = _e1606;
                        }
                        let _e1660 = phi_3070_;
                        if (_e1611 > _e1616) {
                            phi_3075_ = _e1611;
                        } else {
                            phi_3075_ = _e1616;
                        }
                        let _e1663 = phi_3075_;
                        if (_e1660 > _e1663) {
                            phi_3080_ = _e1660;
                        } else {
                            phi_3080_ = _e1663;
                        }
                        let _e1666 = phi_3080_;
                        if (_e1621 > _e1626) {
                            phi_3085_ = _e1621;
                        } else {
                            phi_3085_ = _e1626;
                        }
                        let _e1669 = phi_3085_;
                        if (_e1631 > _e1636) {
                            phi_3090_ = _e1631;
                        } else {
                            phi_3090_ = _e1636;
                        }
                        let _e1672 = phi_3090_;
                        if (_e1669 > _e1672) {
                            phi_3095_ = _e1669;
                        } else {
                            phi_3095_ = _e1672;
                        }
                        let _e1675 = phi_3095_;
                        if (_e1666 > _e1675) {
                            phi_3100_ = _e1666;
                        } else {
                            phi_3100_ = _e1675;
                        }
                        let _e1678 = phi_3100_;
                        if (_e1590 < 0f) {
                            phi_3106_ = -(_e1590);
                        } else {
                            phi_3106_ = _e1590;
                        }
                        let _e1682 = phi_3106_;
                        if (_e1593 < 0f) {
                            phi_3112_ = -(_e1593);
                        } else {
                            phi_3112_ = _e1593;
                        }
                        let _e1686 = phi_3112_;
                        if (_e1596 < 0f) {
                            phi_3119_ = -(_e1596);
                        } else {
                            phi_3119_ = _e1596;
                        }
                        let _e1691 = phi_3119_;
                        let _e1692 = ((_e1682 + _e1686) + _e1691);
                        let _e1697 = -(_e1678);
                        if (_e1657 > _e1697) {
                            phi_3130_ = _e1657;
                        } else {
                            phi_3130_ = _e1697;
                        }
                        let _e1700 = phi_3130_;
                        let _e1705 = (((_e1700 - ((_e1692 * _e1462) * (0.000000059604645f * (17f / 2f)))) - (_e1692 * _e1469)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        if (_e1587 > _e1705) {
                            phi_3140_ = _e1587;
                        } else {
                            phi_3140_ = _e1705;
                        }
                        let _e1708 = phi_3140_;
                        phi_3322_ = (_e1204 || (_e1708 > 0f));
                    }
                    let _e1712 = phi_3322_;
                    if _e1712 {
                        phi_6739_ = _e1712;
                    } else {
                        let _e1715 = local_2.member[0u];
                        let _e1721 = local_2.member[1u];
                        let _e1728 = ((_e1715[0] + _e1721[0]) * 0.5f);
                        let _e1729 = ((_e1715[1] + _e1721[1]) * 0.5f);
                        let _e1730 = ((_e1715[2] + _e1721[2]) * 0.5f);
                        let _e1733 = local_2.member_1[0u];
                        let _e1739 = local_2.member_1[1u];
                        let _e1746 = ((_e1733[0] + _e1739[0]) * 0.5f);
                        let _e1747 = ((_e1733[1] + _e1739[1]) * 0.5f);
                        let _e1748 = ((_e1733[2] + _e1739[2]) * 0.5f);
                        let _e1751 = local_2.member_2[0u];
                        let _e1757 = local_2.member_2[1u];
                        let _e1764 = ((_e1751[0] + _e1757[0]) * 0.5f);
                        let _e1765 = ((_e1751[1] + _e1757[1]) * 0.5f);
                        let _e1766 = ((_e1751[2] + _e1757[2]) * 0.5f);
                        let _e1769 = local_2.member[0u];
                        let _e1772 = local_2.member_1[0u];
                        let _e1775 = local_2.member_2[0u];
                        let _e1777 = local_2.member_3;
                        let _e1780 = local_2.member[1u];
                        let _e1783 = local_2.member_1[1u];
                        let _e1786 = local_2.member_2[1u];
                        let _e1788 = local_2.member_3;
                        local = type_30(array<array<f32, 3>, 2>(_e1769, array<f32, 3>(_e1728, _e1729, _e1730)), array<array<f32, 3>, 2>(_e1772, array<f32, 3>(_e1746, _e1747, _e1748)), array<array<f32, 3>, 2>(_e1775, array<f32, 3>(_e1764, _e1765, _e1766)), _e1777);
                        local_1 = type_30(array<array<f32, 3>, 2>(array<f32, 3>(_e1728, _e1729, _e1730), _e1780), array<array<f32, 3>, 2>(array<f32, 3>(_e1746, _e1747, _e1748), _e1783), array<array<f32, 3>, 2>(array<f32, 3>(_e1764, _e1765, _e1766), _e1786), _e1788);
                        let _e1805 = local.member_1[0u];
                        let _e1811 = local.member_2[0u];
                        let _e1817 = ((_e1805[1] * _e1811[2]) - (_e1805[2] * _e1811[1]));
                        let _e1820 = ((_e1805[2] * _e1811[0]) - (_e1805[0] * _e1811[2]));
                        let _e1823 = ((_e1805[0] * _e1811[1]) - (_e1805[1] * _e1811[0]));
                        let _e1826 = local.member_1[1u];
                        let _e1832 = local.member_2[1u];
                        let _e1838 = ((_e1826[1] * _e1832[2]) - (_e1826[2] * _e1832[1]));
                        let _e1841 = ((_e1826[2] * _e1832[0]) - (_e1826[0] * _e1832[2]));
                        let _e1844 = ((_e1826[0] * _e1832[1]) - (_e1826[1] * _e1832[0]));
                        let _e1847 = local.member_1[0u];
                        let _e1853 = local.member_2[1u];
                        let _e1868 = local.member_1[1u];
                        let _e1874 = local.member_2[0u];
                        let _e1887 = (((_e1847[1] * _e1853[2]) - (_e1847[2] * _e1853[1])) + ((_e1868[1] * _e1874[2]) - (_e1868[2] * _e1874[1])));
                        let _e1888 = (((_e1847[2] * _e1853[0]) - (_e1847[0] * _e1853[2])) + ((_e1868[2] * _e1874[0]) - (_e1868[0] * _e1874[2])));
                        let _e1889 = (((_e1847[0] * _e1853[1]) - (_e1847[1] * _e1853[0])) + ((_e1868[0] * _e1874[1]) - (_e1868[1] * _e1874[0])));
                        let _e1892 = local.member[0u];
                        let _e1903 = local.member[1u];
                        let _e1914 = local.member[0u];
                        let _e1923 = ((((_e1903[0] * _e1817) + (_e1903[1] * _e1820)) + (_e1903[2] * _e1823)) + (((_e1914[0] * _e1887) + (_e1914[1] * _e1888)) + (_e1914[2] * _e1889)));
                        let _e1926 = local.member[0u];
                        let _e1937 = local.member[1u];
                        let _e1946 = ((((_e1926[0] * _e1838) + (_e1926[1] * _e1841)) + (_e1926[2] * _e1844)) + (((_e1937[0] * _e1887) + (_e1937[1] * _e1888)) + (_e1937[2] * _e1889)));
                        let _e1949 = local.member[1u];
                        let _e1960 = local.member[0u];
                        if (_e1960[0] < 0f) {
                            phi_3774_ = -(_e1960[0]);
                        } else {
                            phi_3774_ = _e1960[0];
                        }
                        let _e1967 = phi_3774_;
                        if (_e1960[1] < 0f) {
                            phi_3781_ = -(_e1960[1]);
                        } else {
                            phi_3781_ = _e1960[1];
                        }
                        let _e1971 = phi_3781_;
                        if (_e1967 > _e1971) {
                            phi_3786_ = _e1967;
                        } else {
                            phi_3786_ = _e1971;
                        }
                        let _e1974 = phi_3786_;
                        if (_e1960[2] < 0f) {
                            phi_3793_ = -(_e1960[2]);
                        } else {
                            phi_3793_ = _e1960[2];
                        }
                        let _e1978 = phi_3793_;
                        if (_e1974 > _e1978) {
                            phi_3798_ = _e1974;
                        } else {
                            phi_3798_ = _e1978;
                        }
                        let _e1981 = phi_3798_;
                        let _e1984 = local.member[1u];
                        if (_e1984[0] < 0f) {
                            phi_3811_ = -(_e1984[0]);
                        } else {
                            phi_3811_ = _e1984[0];
                        }
                        let _e1991 = phi_3811_;
                        if (_e1984[1] < 0f) {
                            phi_3818_ = -(_e1984[1]);
                        } else {
                            phi_3818_ = _e1984[1];
                        }
                        let _e1995 = phi_3818_;
                        if (_e1991 > _e1995) {
                            phi_3823_ = _e1991;
                        } else {
                            phi_3823_ = _e1995;
                        }
                        let _e1998 = phi_3823_;
                        if (_e1984[2] < 0f) {
                            phi_3830_ = -(_e1984[2]);
                        } else {
                            phi_3830_ = _e1984[2];
                        }
                        let _e2002 = phi_3830_;
                        if (_e1998 > _e2002) {
                            phi_3835_ = _e1998;
                        } else {
                            phi_3835_ = _e2002;
                        }
                        let _e2005 = phi_3835_;
                        if (_e1981 > _e2005) {
                            phi_3840_ = _e1981;
                        } else {
                            phi_3840_ = _e2005;
                        }
                        let _e2008 = phi_3840_;
                        let _e2010 = local.member_3;
                        let _e2011 = (_e2008 + _e2010);
                        let _e2014 = local.member_1[0u];
                        if (_e2014[0] < 0f) {
                            phi_3857_ = -(_e2014[0]);
                        } else {
                            phi_3857_ = _e2014[0];
                        }
                        let _e2021 = phi_3857_;
                        if (_e2014[1] < 0f) {
                            phi_3864_ = -(_e2014[1]);
                        } else {
                            phi_3864_ = _e2014[1];
                        }
                        let _e2025 = phi_3864_;
                        if (_e2021 > _e2025) {
                            phi_3869_ = _e2021;
                        } else {
                            phi_3869_ = _e2025;
                        }
                        let _e2028 = phi_3869_;
                        if (_e2014[2] < 0f) {
                            phi_3876_ = -(_e2014[2]);
                        } else {
                            phi_3876_ = _e2014[2];
                        }
                        let _e2032 = phi_3876_;
                        if (_e2028 > _e2032) {
                            phi_3881_ = _e2028;
                        } else {
                            phi_3881_ = _e2032;
                        }
                        let _e2035 = phi_3881_;
                        let _e2038 = local.member_1[1u];
                        if (_e2038[0] < 0f) {
                            phi_3895_ = -(_e2038[0]);
                        } else {
                            phi_3895_ = _e2038[0];
                        }
                        let _e2045 = phi_3895_;
                        if (_e2038[1] < 0f) {
                            phi_3902_ = -(_e2038[1]);
                        } else {
                            phi_3902_ = _e2038[1];
                        }
                        let _e2049 = phi_3902_;
                        if (_e2045 > _e2049) {
                            phi_3907_ = _e2045;
                        } else {
                            phi_3907_ = _e2049;
                        }
                        let _e2052 = phi_3907_;
                        if (_e2038[2] < 0f) {
                            phi_3914_ = -(_e2038[2]);
                        } else {
                            phi_3914_ = _e2038[2];
                        }
                        let _e2056 = phi_3914_;
                        if (_e2052 > _e2056) {
                            phi_3919_ = _e2052;
                        } else {
                            phi_3919_ = _e2056;
                        }
                        let _e2059 = phi_3919_;
                        if (_e2035 > _e2059) {
                            phi_3924_ = _e2035;
                        } else {
                            phi_3924_ = _e2059;
                        }
                        let _e2062 = phi_3924_;
                        let _e2064 = local.member_3;
                        let _e2065 = (_e2062 + _e2064);
                        let _e2068 = local.member_2[0u];
                        if (_e2068[0] < 0f) {
                            phi_3941_ = -(_e2068[0]);
                        } else {
                            phi_3941_ = _e2068[0];
                        }
                        let _e2075 = phi_3941_;
                        if (_e2068[1] < 0f) {
                            phi_3948_ = -(_e2068[1]);
                        } else {
                            phi_3948_ = _e2068[1];
                        }
                        let _e2079 = phi_3948_;
                        if (_e2075 > _e2079) {
                            phi_3953_ = _e2075;
                        } else {
                            phi_3953_ = _e2079;
                        }
                        let _e2082 = phi_3953_;
                        if (_e2068[2] < 0f) {
                            phi_3960_ = -(_e2068[2]);
                        } else {
                            phi_3960_ = _e2068[2];
                        }
                        let _e2086 = phi_3960_;
                        if (_e2082 > _e2086) {
                            phi_3965_ = _e2082;
                        } else {
                            phi_3965_ = _e2086;
                        }
                        let _e2089 = phi_3965_;
                        let _e2092 = local.member_2[1u];
                        if (_e2092[0] < 0f) {
                            phi_3979_ = -(_e2092[0]);
                        } else {
                            phi_3979_ = _e2092[0];
                        }
                        let _e2099 = phi_3979_;
                        if (_e2092[1] < 0f) {
                            phi_3986_ = -(_e2092[1]);
                        } else {
                            phi_3986_ = _e2092[1];
                        }
                        let _e2103 = phi_3986_;
                        if (_e2099 > _e2103) {
                            phi_3991_ = _e2099;
                        } else {
                            phi_3991_ = _e2103;
                        }
                        let _e2106 = phi_3991_;
                        if (_e2092[2] < 0f) {
                            phi_3998_ = -(_e2092[2]);
                        } else {
                            phi_3998_ = _e2092[2];
                        }
                        let _e2110 = phi_3998_;
                        if (_e2106 > _e2110) {
                            phi_4003_ = _e2106;
                        } else {
                            phi_4003_ = _e2110;
                        }
                        let _e2113 = phi_4003_;
                        if (_e2089 > _e2113) {
                            phi_4008_ = _e2089;
                        } else {
                            phi_4008_ = _e2113;
                        }
                        let _e2116 = phi_4008_;
                        let _e2118 = local.member_3;
                        let _e2119 = (_e2116 + _e2118);
                        let _e2121 = ((_e2065 * 8f) * _e2119);
                        let _e2128 = local.member_3;
                        if (_e1817 < 0f) {
                            phi_4039_ = -(_e1817);
                        } else {
                            phi_4039_ = _e1817;
                        }
                        let _e2145 = phi_4039_;
                        if (_e1820 < 0f) {
                            phi_4045_ = -(_e1820);
                        } else {
                            phi_4045_ = _e1820;
                        }
                        let _e2149 = phi_4045_;
                        if (_e1823 < 0f) {
                            phi_4052_ = -(_e1823);
                        } else {
                            phi_4052_ = _e1823;
                        }
                        let _e2154 = phi_4052_;
                        let _e2155 = ((_e2145 + _e2149) + _e2154);
                        if (_e1838 < 0f) {
                            phi_4059_ = -(_e1838);
                        } else {
                            phi_4059_ = _e1838;
                        }
                        let _e2159 = phi_4059_;
                        if (_e1841 < 0f) {
                            phi_4065_ = -(_e1841);
                        } else {
                            phi_4065_ = _e1841;
                        }
                        let _e2163 = phi_4065_;
                        if (_e1844 < 0f) {
                            phi_4072_ = -(_e1844);
                        } else {
                            phi_4072_ = _e1844;
                        }
                        let _e2168 = phi_4072_;
                        let _e2169 = ((_e2159 + _e2163) + _e2168);
                        if (_e2155 > _e2169) {
                            phi_4078_ = _e2155;
                        } else {
                            phi_4078_ = _e2169;
                        }
                        let _e2172 = phi_4078_;
                        if (_e1887 < 0f) {
                            phi_4084_ = -(_e1887);
                        } else {
                            phi_4084_ = _e1887;
                        }
                        let _e2176 = phi_4084_;
                        if (_e1888 < 0f) {
                            phi_4090_ = -(_e1888);
                        } else {
                            phi_4090_ = _e1888;
                        }
                        let _e2180 = phi_4090_;
                        if (_e1889 < 0f) {
                            phi_4097_ = -(_e1889);
                        } else {
                            phi_4097_ = _e1889;
                        }
                        let _e2185 = phi_4097_;
                        let _e2187 = (((_e2176 + _e2180) + _e2185) * 0.5f);
                        if (_e2172 > _e2187) {
                            phi_4104_ = _e2172;
                        } else {
                            phi_4104_ = _e2187;
                        }
                        let _e2190 = phi_4104_;
                        let _e2195 = local.member_3;
                        let _e2208 = ((((_e1892[0] * _e1817) + (_e1892[1] * _e1820)) + (_e1892[2] * _e1823)) * 3f);
                        let _e2209 = ((((_e1949[0] * _e1838) + (_e1949[1] * _e1841)) + (_e1949[2] * _e1844)) * 3f);
                        if (_e2208 < _e2209) {
                            phi_4128_ = _e2208;
                        } else {
                            phi_4128_ = _e2209;
                        }
                        let _e2212 = phi_4128_;
                        if (_e1923 < _e1946) {
                            phi_4133_ = _e1923;
                        } else {
                            phi_4133_ = _e1946;
                        }
                        let _e2215 = phi_4133_;
                        if (_e2212 < _e2215) {
                            phi_4138_ = _e2212;
                        } else {
                            phi_4138_ = _e2215;
                        }
                        let _e2218 = phi_4138_;
                        if (_e2208 > _e2209) {
                            phi_4143_ = _e2208;
                        } else {
                            phi_4143_ = _e2209;
                        }
                        let _e2221 = phi_4143_;
                        if (_e1923 > _e1946) {
                            phi_4148_ = _e1923;
                        } else {
                            phi_4148_ = _e1946;
                        }
                        let _e2224 = phi_4148_;
                        if (_e2221 > _e2224) {
                            phi_4153_ = _e2221;
                        } else {
                            phi_4153_ = _e2224;
                        }
                        let _e2227 = phi_4153_;
                        let _e2232 = -(_e2227);
                        if (_e2218 > _e2232) {
                            phi_4163_ = _e2218;
                        } else {
                            phi_4163_ = _e2232;
                        }
                        let _e2235 = phi_4163_;
                        let _e2237 = ((_e2235 - ((((((_e2011 * 8f) * _e2121) * (0.000000059604645f * (524f / 64f))) + ((_e2128 * 19f) * ((_e2011 * (_e2065 + _e2119)) + (_e2065 * _e2119)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2011) * ((1f + _e2065) * (1f + _e2119))))) + ((_e700 * (((_e2190 + (_e2121 * (0.000000059604645f * 8f))) + ((_e2195 * 6f) * (_e2065 + _e2119))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2065) * (1f + _e2119))))) * (3f * 1.0001f)))) > 0f);
                        if _e2237 {
                            phi_5132_ = _e2237;
                        } else {
                            let _e2240 = local.member_1[0u];
                            let _e2246 = local.member_1[1u];
                            let _e2250 = (_e2240[0] + _e2246[0]);
                            let _e2251 = (_e2240[1] + _e2246[1]);
                            let _e2252 = (_e2240[2] + _e2246[2]);
                            let _e2255 = local.member_2[0u];
                            let _e2261 = local.member_2[1u];
                            let _e2265 = (_e2255[0] + _e2261[0]);
                            let _e2266 = (_e2255[1] + _e2261[1]);
                            let _e2267 = (_e2255[2] + _e2261[2]);
                            let _e2270 = ((_e2251 * _e2267) - (_e2252 * _e2266));
                            let _e2273 = ((_e2252 * _e2265) - (_e2250 * _e2267));
                            let _e2276 = ((_e2250 * _e2266) - (_e2251 * _e2265));
                            let _e2279 = local.member[0u];
                            let _e2285 = local.member_1[0u];
                            let _e2291 = local.member_2[0u];
                            let _e2295 = (_e2279[0] - _e2285[0]);
                            let _e2296 = (_e2279[1] - _e2285[1]);
                            let _e2297 = (_e2279[2] - _e2285[2]);
                            let _e2298 = (_e2295 - _e2291[0]);
                            let _e2299 = (_e2296 - _e2291[1]);
                            let _e2300 = (_e2297 - _e2291[2]);
                            let _e2301 = (_e2279[0] - _e2291[0]);
                            let _e2302 = (_e2279[1] - _e2291[1]);
                            let _e2303 = (_e2279[2] - _e2291[2]);
                            let _e2306 = local.member[1u];
                            let _e2312 = local.member_1[1u];
                            let _e2318 = local.member_2[1u];
                            let _e2322 = (_e2306[0] - _e2312[0]);
                            let _e2323 = (_e2306[1] - _e2312[1]);
                            let _e2324 = (_e2306[2] - _e2312[2]);
                            let _e2325 = (_e2322 - _e2318[0]);
                            let _e2326 = (_e2323 - _e2318[1]);
                            let _e2327 = (_e2324 - _e2318[2]);
                            let _e2328 = (_e2306[0] - _e2318[0]);
                            let _e2329 = (_e2306[1] - _e2318[1]);
                            let _e2330 = (_e2306[2] - _e2318[2]);
                            let _e2333 = local.member[0u];
                            if (_e2333[0] < 0f) {
                                phi_4366_ = -(_e2333[0]);
                            } else {
                                phi_4366_ = _e2333[0];
                            }
                            let _e2340 = phi_4366_;
                            if (_e2333[1] < 0f) {
                                phi_4373_ = -(_e2333[1]);
                            } else {
                                phi_4373_ = _e2333[1];
                            }
                            let _e2344 = phi_4373_;
                            if (_e2340 > _e2344) {
                                phi_4378_ = _e2340;
                            } else {
                                phi_4378_ = _e2344;
                            }
                            let _e2347 = phi_4378_;
                            if (_e2333[2] < 0f) {
                                phi_4385_ = -(_e2333[2]);
                            } else {
                                phi_4385_ = _e2333[2];
                            }
                            let _e2351 = phi_4385_;
                            if (_e2347 > _e2351) {
                                phi_4390_ = _e2347;
                            } else {
                                phi_4390_ = _e2351;
                            }
                            let _e2354 = phi_4390_;
                            let _e2357 = local.member[1u];
                            if (_e2357[0] < 0f) {
                                phi_4403_ = -(_e2357[0]);
                            } else {
                                phi_4403_ = _e2357[0];
                            }
                            let _e2364 = phi_4403_;
                            if (_e2357[1] < 0f) {
                                phi_4410_ = -(_e2357[1]);
                            } else {
                                phi_4410_ = _e2357[1];
                            }
                            let _e2368 = phi_4410_;
                            if (_e2364 > _e2368) {
                                phi_4415_ = _e2364;
                            } else {
                                phi_4415_ = _e2368;
                            }
                            let _e2371 = phi_4415_;
                            if (_e2357[2] < 0f) {
                                phi_4422_ = -(_e2357[2]);
                            } else {
                                phi_4422_ = _e2357[2];
                            }
                            let _e2375 = phi_4422_;
                            if (_e2371 > _e2375) {
                                phi_4427_ = _e2371;
                            } else {
                                phi_4427_ = _e2375;
                            }
                            let _e2378 = phi_4427_;
                            if (_e2354 > _e2378) {
                                phi_4432_ = _e2354;
                            } else {
                                phi_4432_ = _e2378;
                            }
                            let _e2381 = phi_4432_;
                            let _e2383 = local.member_3;
                            let _e2387 = local.member_1[0u];
                            if (_e2387[0] < 0f) {
                                phi_4449_ = -(_e2387[0]);
                            } else {
                                phi_4449_ = _e2387[0];
                            }
                            let _e2394 = phi_4449_;
                            if (_e2387[1] < 0f) {
                                phi_4456_ = -(_e2387[1]);
                            } else {
                                phi_4456_ = _e2387[1];
                            }
                            let _e2398 = phi_4456_;
                            if (_e2394 > _e2398) {
                                phi_4461_ = _e2394;
                            } else {
                                phi_4461_ = _e2398;
                            }
                            let _e2401 = phi_4461_;
                            if (_e2387[2] < 0f) {
                                phi_4468_ = -(_e2387[2]);
                            } else {
                                phi_4468_ = _e2387[2];
                            }
                            let _e2405 = phi_4468_;
                            if (_e2401 > _e2405) {
                                phi_4473_ = _e2401;
                            } else {
                                phi_4473_ = _e2405;
                            }
                            let _e2408 = phi_4473_;
                            let _e2411 = local.member_1[1u];
                            if (_e2411[0] < 0f) {
                                phi_4487_ = -(_e2411[0]);
                            } else {
                                phi_4487_ = _e2411[0];
                            }
                            let _e2418 = phi_4487_;
                            if (_e2411[1] < 0f) {
                                phi_4494_ = -(_e2411[1]);
                            } else {
                                phi_4494_ = _e2411[1];
                            }
                            let _e2422 = phi_4494_;
                            if (_e2418 > _e2422) {
                                phi_4499_ = _e2418;
                            } else {
                                phi_4499_ = _e2422;
                            }
                            let _e2425 = phi_4499_;
                            if (_e2411[2] < 0f) {
                                phi_4506_ = -(_e2411[2]);
                            } else {
                                phi_4506_ = _e2411[2];
                            }
                            let _e2429 = phi_4506_;
                            if (_e2425 > _e2429) {
                                phi_4511_ = _e2425;
                            } else {
                                phi_4511_ = _e2429;
                            }
                            let _e2432 = phi_4511_;
                            if (_e2408 > _e2432) {
                                phi_4516_ = _e2408;
                            } else {
                                phi_4516_ = _e2432;
                            }
                            let _e2435 = phi_4516_;
                            let _e2437 = local.member_3;
                            let _e2441 = local.member_2[0u];
                            if (_e2441[0] < 0f) {
                                phi_4533_ = -(_e2441[0]);
                            } else {
                                phi_4533_ = _e2441[0];
                            }
                            let _e2448 = phi_4533_;
                            if (_e2441[1] < 0f) {
                                phi_4540_ = -(_e2441[1]);
                            } else {
                                phi_4540_ = _e2441[1];
                            }
                            let _e2452 = phi_4540_;
                            if (_e2448 > _e2452) {
                                phi_4545_ = _e2448;
                            } else {
                                phi_4545_ = _e2452;
                            }
                            let _e2455 = phi_4545_;
                            if (_e2441[2] < 0f) {
                                phi_4552_ = -(_e2441[2]);
                            } else {
                                phi_4552_ = _e2441[2];
                            }
                            let _e2459 = phi_4552_;
                            if (_e2455 > _e2459) {
                                phi_4557_ = _e2455;
                            } else {
                                phi_4557_ = _e2459;
                            }
                            let _e2462 = phi_4557_;
                            let _e2465 = local.member_2[1u];
                            if (_e2465[0] < 0f) {
                                phi_4571_ = -(_e2465[0]);
                            } else {
                                phi_4571_ = _e2465[0];
                            }
                            let _e2472 = phi_4571_;
                            if (_e2465[1] < 0f) {
                                phi_4578_ = -(_e2465[1]);
                            } else {
                                phi_4578_ = _e2465[1];
                            }
                            let _e2476 = phi_4578_;
                            if (_e2472 > _e2476) {
                                phi_4583_ = _e2472;
                            } else {
                                phi_4583_ = _e2476;
                            }
                            let _e2479 = phi_4583_;
                            if (_e2465[2] < 0f) {
                                phi_4590_ = -(_e2465[2]);
                            } else {
                                phi_4590_ = _e2465[2];
                            }
                            let _e2483 = phi_4590_;
                            if (_e2479 > _e2483) {
                                phi_4595_ = _e2479;
                            } else {
                                phi_4595_ = _e2483;
                            }
                            let _e2486 = phi_4595_;
                            if (_e2462 > _e2486) {
                                phi_4600_ = _e2462;
                            } else {
                                phi_4600_ = _e2486;
                            }
                            let _e2489 = phi_4600_;
                            let _e2491 = local.member_3;
                            let _e2495 = ((((_e2381 + _e2383) + (_e2435 + _e2437)) + (_e2489 + _e2491)) * 2f);
                            let _e2498 = local.member_3;
                            let _e2502 = (((_e700 * 1.0001f) + (_e2498 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e2505 = ((_e2273 * _e2252) - (_e2276 * _e2251));
                            let _e2508 = ((_e2276 * _e2250) - (_e2270 * _e2252));
                            let _e2511 = ((_e2270 * _e2251) - (_e2273 * _e2250));
                            let _e2516 = (((_e2505 * _e2279[0]) + (_e2508 * _e2279[1])) + (_e2511 * _e2279[2]));
                            let _e2521 = (((_e2505 * _e2295) + (_e2508 * _e2296)) + (_e2511 * _e2297));
                            let _e2526 = (((_e2505 * _e2301) + (_e2508 * _e2302)) + (_e2511 * _e2303));
                            let _e2531 = (((_e2505 * _e2298) + (_e2508 * _e2299)) + (_e2511 * _e2300));
                            let _e2536 = (((_e2505 * _e2306[0]) + (_e2508 * _e2306[1])) + (_e2511 * _e2306[2]));
                            let _e2541 = (((_e2505 * _e2322) + (_e2508 * _e2323)) + (_e2511 * _e2324));
                            let _e2546 = (((_e2505 * _e2328) + (_e2508 * _e2329)) + (_e2511 * _e2330));
                            let _e2551 = (((_e2505 * _e2325) + (_e2508 * _e2326)) + (_e2511 * _e2327));
                            if (_e2516 < _e2521) {
                                phi_4679_ = _e2516;
                            } else {
                                phi_4679_ = _e2521;
                            }
                            let _e2554 = phi_4679_;
                            if (_e2526 < _e2531) {
                                phi_4684_ = _e2526;
                            } else {
                                phi_4684_ = _e2531;
                            }
                            let _e2557 = phi_4684_;
                            if (_e2554 < _e2557) {
                                phi_4689_ = _e2554;
                            } else {
                                phi_4689_ = _e2557;
                            }
                            let _e2560 = phi_4689_;
                            if (_e2536 < _e2541) {
                                phi_4694_ = _e2536;
                            } else {
                                phi_4694_ = _e2541;
                            }
                            let _e2563 = phi_4694_;
                            if (_e2546 < _e2551) {
                                phi_4699_ = _e2546;
                            } else {
                                phi_4699_ = _e2551;
                            }
                            let _e2566 = phi_4699_;
                            if (_e2563 < _e2566) {
                                phi_4704_ = _e2563;
                            } else {
                                phi_4704_ = _e2566;
                            }
                            let _e2569 = phi_4704_;
                            if (_e2560 < _e2569) {
                                phi_4709_ = _e2560;
                            } else {
                                phi_4709_ = _e2569;
                            }
                            let _e2572 = phi_4709_;
                            if (_e2516 > _e2521) {
                                phi_4714_ = _e2516;
                            } else {
                                phi_4714_ = _e2521;
                            }
                            let _e2575 = phi_4714_;
                            if (_e2526 > _e2531) {
                                phi_4719_ = _e2526;
                            } else {
                                phi_4719_ = _e2531;
                            }
                            let _e2578 = phi_4719_;
                            if (_e2575 > _e2578) {
                                phi_4724_ = _e2575;
                            } else {
                                phi_4724_ = _e2578;
                            }
                            let _e2581 = phi_4724_;
                            if (_e2536 > _e2541) {
                                phi_4729_ = _e2536;
                            } else {
                                phi_4729_ = _e2541;
                            }
                            let _e2584 = phi_4729_;
                            if (_e2546 > _e2551) {
                                phi_4734_ = _e2546;
                            } else {
                                phi_4734_ = _e2551;
                            }
                            let _e2587 = phi_4734_;
                            if (_e2584 > _e2587) {
                                phi_4739_ = _e2584;
                            } else {
                                phi_4739_ = _e2587;
                            }
                            let _e2590 = phi_4739_;
                            if (_e2581 > _e2590) {
                                phi_4744_ = _e2581;
                            } else {
                                phi_4744_ = _e2590;
                            }
                            let _e2593 = phi_4744_;
                            if (_e2505 < 0f) {
                                phi_4750_ = -(_e2505);
                            } else {
                                phi_4750_ = _e2505;
                            }
                            let _e2597 = phi_4750_;
                            if (_e2508 < 0f) {
                                phi_4756_ = -(_e2508);
                            } else {
                                phi_4756_ = _e2508;
                            }
                            let _e2601 = phi_4756_;
                            if (_e2511 < 0f) {
                                phi_4763_ = -(_e2511);
                            } else {
                                phi_4763_ = _e2511;
                            }
                            let _e2606 = phi_4763_;
                            let _e2607 = ((_e2597 + _e2601) + _e2606);
                            let _e2612 = -(_e2593);
                            if (_e2572 > _e2612) {
                                phi_4774_ = _e2572;
                            } else {
                                phi_4774_ = _e2612;
                            }
                            let _e2615 = phi_4774_;
                            let _e2620 = (((_e2615 - ((_e2607 * _e2495) * (0.000000059604645f * (17f / 2f)))) - (_e2607 * _e2502)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2623 = ((_e2273 * _e2267) - (_e2276 * _e2266));
                            let _e2626 = ((_e2276 * _e2265) - (_e2270 * _e2267));
                            let _e2629 = ((_e2270 * _e2266) - (_e2273 * _e2265));
                            let _e2634 = (((_e2623 * _e2279[0]) + (_e2626 * _e2279[1])) + (_e2629 * _e2279[2]));
                            let _e2639 = (((_e2623 * _e2295) + (_e2626 * _e2296)) + (_e2629 * _e2297));
                            let _e2644 = (((_e2623 * _e2301) + (_e2626 * _e2302)) + (_e2629 * _e2303));
                            let _e2649 = (((_e2623 * _e2298) + (_e2626 * _e2299)) + (_e2629 * _e2300));
                            let _e2654 = (((_e2623 * _e2306[0]) + (_e2626 * _e2306[1])) + (_e2629 * _e2306[2]));
                            let _e2659 = (((_e2623 * _e2322) + (_e2626 * _e2323)) + (_e2629 * _e2324));
                            let _e2664 = (((_e2623 * _e2328) + (_e2626 * _e2329)) + (_e2629 * _e2330));
                            let _e2669 = (((_e2623 * _e2325) + (_e2626 * _e2326)) + (_e2629 * _e2327));
                            if (_e2634 < _e2639) {
                                phi_4845_ = _e2634;
                            } else {
                                phi_4845_ = _e2639;
                            }
                            let _e2672 = phi_4845_;
                            if (_e2644 < _e2649) {
                                phi_4850_ = _e2644;
                            } else {
                                phi_4850_ = _e2649;
                            }
                            let _e2675 = phi_4850_;
                            if (_e2672 < _e2675) {
                                phi_4855_ = _e2672;
                            } else {
                                phi_4855_ = _e2675;
                            }
                            let _e2678 = phi_4855_;
                            if (_e2654 < _e2659) {
                                phi_4860_ = _e2654;
                            } else {
                                phi_4860_ = _e2659;
                            }
                            let _e2681 = phi_4860_;
                            if (_e2664 < _e2669) {
                                phi_4865_ = _e2664;
                            } else {
                                phi_4865_ = _e2669;
                            }
                            let _e2684 = phi_4865_;
                            if (_e2681 < _e2684) {
                                phi_4870_ = _e2681;
                            } else {
                                phi_4870_ = _e2684;
                            }
                            let _e2687 = phi_4870_;
                            if (_e2678 < _e2687) {
                                phi_4875_ = _e2678;
                            } else {
                                phi_4875_ = _e2687;
                            }
                            let _e2690 = phi_4875_;
                            if (_e2634 > _e2639) {
                                phi_4880_ = _e2634;
                            } else {
                                phi_4880_ = _e2639;
                            }
                            let _e2693 = phi_4880_;
                            if (_e2644 > _e2649) {
                                phi_4885_ = _e2644;
                            } else {
                                phi_4885_ = _e2649;
                            }
                            let _e2696 = phi_4885_;
                            if (_e2693 > _e2696) {
                                phi_4890_ = _e2693;
                            } else {
                                phi_4890_ = _e2696;
                            }
                            let _e2699 = phi_4890_;
                            if (_e2654 > _e2659) {
                                phi_4895_ = _e2654;
                            } else {
                                phi_4895_ = _e2659;
                            }
                            let _e2702 = phi_4895_;
                            if (_e2664 > _e2669) {
                                phi_4900_ = _e2664;
                            } else {
                                phi_4900_ = _e2669;
                            }
                            let _e2705 = phi_4900_;
                            if (_e2702 > _e2705) {
                                phi_4905_ = _e2702;
                            } else {
                                phi_4905_ = _e2705;
                            }
                            let _e2708 = phi_4905_;
                            if (_e2699 > _e2708) {
                                phi_4910_ = _e2699;
                            } else {
                                phi_4910_ = _e2708;
                            }
                            let _e2711 = phi_4910_;
                            if (_e2623 < 0f) {
                                phi_4916_ = -(_e2623);
                            } else {
                                phi_4916_ = _e2623;
                            }
                            let _e2715 = phi_4916_;
                            if (_e2626 < 0f) {
                                phi_4922_ = -(_e2626);
                            } else {
                                phi_4922_ = _e2626;
                            }
                            let _e2719 = phi_4922_;
                            if (_e2629 < 0f) {
                                phi_4929_ = -(_e2629);
                            } else {
                                phi_4929_ = _e2629;
                            }
                            let _e2724 = phi_4929_;
                            let _e2725 = ((_e2715 + _e2719) + _e2724);
                            let _e2730 = -(_e2711);
                            if (_e2690 > _e2730) {
                                phi_4940_ = _e2690;
                            } else {
                                phi_4940_ = _e2730;
                            }
                            let _e2733 = phi_4940_;
                            let _e2738 = (((_e2733 - ((_e2725 * _e2495) * (0.000000059604645f * (17f / 2f)))) - (_e2725 * _e2502)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e2620 > _e2738) {
                                phi_4950_ = _e2620;
                            } else {
                                phi_4950_ = _e2738;
                            }
                            let _e2741 = phi_4950_;
                            phi_5132_ = (_e2237 || (_e2741 > 0f));
                        }
                        let _e2745 = phi_5132_;
                        if _e2745 {
                            let _e2748 = local_1.member_1[0u];
                            let _e2754 = local_1.member_2[0u];
                            let _e2760 = ((_e2748[1] * _e2754[2]) - (_e2748[2] * _e2754[1]));
                            let _e2763 = ((_e2748[2] * _e2754[0]) - (_e2748[0] * _e2754[2]));
                            let _e2766 = ((_e2748[0] * _e2754[1]) - (_e2748[1] * _e2754[0]));
                            let _e2769 = local_1.member_1[1u];
                            let _e2775 = local_1.member_2[1u];
                            let _e2781 = ((_e2769[1] * _e2775[2]) - (_e2769[2] * _e2775[1]));
                            let _e2784 = ((_e2769[2] * _e2775[0]) - (_e2769[0] * _e2775[2]));
                            let _e2787 = ((_e2769[0] * _e2775[1]) - (_e2769[1] * _e2775[0]));
                            let _e2790 = local_1.member_1[0u];
                            let _e2796 = local_1.member_2[1u];
                            let _e2811 = local_1.member_1[1u];
                            let _e2817 = local_1.member_2[0u];
                            let _e2830 = (((_e2790[1] * _e2796[2]) - (_e2790[2] * _e2796[1])) + ((_e2811[1] * _e2817[2]) - (_e2811[2] * _e2817[1])));
                            let _e2831 = (((_e2790[2] * _e2796[0]) - (_e2790[0] * _e2796[2])) + ((_e2811[2] * _e2817[0]) - (_e2811[0] * _e2817[2])));
                            let _e2832 = (((_e2790[0] * _e2796[1]) - (_e2790[1] * _e2796[0])) + ((_e2811[0] * _e2817[1]) - (_e2811[1] * _e2817[0])));
                            let _e2835 = local_1.member[0u];
                            let _e2846 = local_1.member[1u];
                            let _e2857 = local_1.member[0u];
                            let _e2866 = ((((_e2846[0] * _e2760) + (_e2846[1] * _e2763)) + (_e2846[2] * _e2766)) + (((_e2857[0] * _e2830) + (_e2857[1] * _e2831)) + (_e2857[2] * _e2832)));
                            let _e2869 = local_1.member[0u];
                            let _e2880 = local_1.member[1u];
                            let _e2889 = ((((_e2869[0] * _e2781) + (_e2869[1] * _e2784)) + (_e2869[2] * _e2787)) + (((_e2880[0] * _e2830) + (_e2880[1] * _e2831)) + (_e2880[2] * _e2832)));
                            let _e2892 = local_1.member[1u];
                            let _e2903 = local_1.member[0u];
                            if (_e2903[0] < 0f) {
                                phi_5377_ = -(_e2903[0]);
                            } else {
                                phi_5377_ = _e2903[0];
                            }
                            let _e2910 = phi_5377_;
                            if (_e2903[1] < 0f) {
                                phi_5384_ = -(_e2903[1]);
                            } else {
                                phi_5384_ = _e2903[1];
                            }
                            let _e2914 = phi_5384_;
                            if (_e2910 > _e2914) {
                                phi_5389_ = _e2910;
                            } else {
                                phi_5389_ = _e2914;
                            }
                            let _e2917 = phi_5389_;
                            if (_e2903[2] < 0f) {
                                phi_5396_ = -(_e2903[2]);
                            } else {
                                phi_5396_ = _e2903[2];
                            }
                            let _e2921 = phi_5396_;
                            if (_e2917 > _e2921) {
                                phi_5401_ = _e2917;
                            } else {
                                phi_5401_ = _e2921;
                            }
                            let _e2924 = phi_5401_;
                            let _e2927 = local_1.member[1u];
                            if (_e2927[0] < 0f) {
                                phi_5414_ = -(_e2927[0]);
                            } else {
                                phi_5414_ = _e2927[0];
                            }
                            let _e2934 = phi_5414_;
                            if (_e2927[1] < 0f) {
                                phi_5421_ = -(_e2927[1]);
                            } else {
                                phi_5421_ = _e2927[1];
                            }
                            let _e2938 = phi_5421_;
                            if (_e2934 > _e2938) {
                                phi_5426_ = _e2934;
                            } else {
                                phi_5426_ = _e2938;
                            }
                            let _e2941 = phi_5426_;
                            if (_e2927[2] < 0f) {
                                phi_5433_ = -(_e2927[2]);
                            } else {
                                phi_5433_ = _e2927[2];
                            }
                            let _e2945 = phi_5433_;
                            if (_e2941 > _e2945) {
                                phi_5438_ = _e2941;
                            } else {
                                phi_5438_ = _e2945;
                            }
                            let _e2948 = phi_5438_;
                            if (_e2924 > _e2948) {
                                phi_5443_ = _e2924;
                            } else {
                                phi_5443_ = _e2948;
                            }
                            let _e2951 = phi_5443_;
                            let _e2953 = local_1.member_3;
                            let _e2954 = (_e2951 + _e2953);
                            let _e2957 = local_1.member_1[0u];
                            if (_e2957[0] < 0f) {
                                phi_5460_ = -(_e2957[0]);
                            } else {
                                phi_5460_ = _e2957[0];
                            }
                            let _e2964 = phi_5460_;
                            if (_e2957[1] < 0f) {
                                phi_5467_ = -(_e2957[1]);
                            } else {
                                phi_5467_ = _e2957[1];
                            }
                            let _e2968 = phi_5467_;
                            if (_e2964 > _e2968) {
                                phi_5472_ = _e2964;
                            } else {
                                phi_5472_ = _e2968;
                            }
                            let _e2971 = phi_5472_;
                            if (_e2957[2] < 0f) {
                                phi_5479_ = -(_e2957[2]);
                            } else {
                                phi_5479_ = _e2957[2];
                            }
                            let _e2975 = phi_5479_;
                            if (_e2971 > _e2975) {
                                phi_5484_ = _e2971;
                            } else {
                                phi_5484_ = _e2975;
                            }
                            let _e2978 = phi_5484_;
                            let _e2981 = local_1.member_1[1u];
                            if (_e2981[0] < 0f) {
                                phi_5498_ = -(_e2981[0]);
                            } else {
                                phi_5498_ = _e2981[0];
                            }
                            let _e2988 = phi_5498_;
                            if (_e2981[1] < 0f) {
                                phi_5505_ = -(_e2981[1]);
                            } else {
                                phi_5505_ = _e2981[1];
                            }
                            let _e2992 = phi_5505_;
                            if (_e2988 > _e2992) {
                                phi_5510_ = _e2988;
                            } else {
                                phi_5510_ = _e2992;
                            }
                            let _e2995 = phi_5510_;
                            if (_e2981[2] < 0f) {
                                phi_5517_ = -(_e2981[2]);
                            } else {
                                phi_5517_ = _e2981[2];
                            }
                            let _e2999 = phi_5517_;
                            if (_e2995 > _e2999) {
                                phi_5522_ = _e2995;
                            } else {
                                phi_5522_ = _e2999;
                            }
                            let _e3002 = phi_5522_;
                            if (_e2978 > _e3002) {
                                phi_5527_ = _e2978;
                            } else {
                                phi_5527_ = _e3002;
                            }
                            let _e3005 = phi_5527_;
                            let _e3007 = local_1.member_3;
                            let _e3008 = (_e3005 + _e3007);
                            let _e3011 = local_1.member_2[0u];
                            if (_e3011[0] < 0f) {
                                phi_5544_ = -(_e3011[0]);
                            } else {
                                phi_5544_ = _e3011[0];
                            }
                            let _e3018 = phi_5544_;
                            if (_e3011[1] < 0f) {
                                phi_5551_ = -(_e3011[1]);
                            } else {
                                phi_5551_ = _e3011[1];
                            }
                            let _e3022 = phi_5551_;
                            if (_e3018 > _e3022) {
                                phi_5556_ = _e3018;
                            } else {
                                phi_5556_ = _e3022;
                            }
                            let _e3025 = phi_5556_;
                            if (_e3011[2] < 0f) {
                                phi_5563_ = -(_e3011[2]);
                            } else {
                                phi_5563_ = _e3011[2];
                            }
                            let _e3029 = phi_5563_;
                            if (_e3025 > _e3029) {
                                phi_5568_ = _e3025;
                            } else {
                                phi_5568_ = _e3029;
                            }
                            let _e3032 = phi_5568_;
                            let _e3035 = local_1.member_2[1u];
                            if (_e3035[0] < 0f) {
                                phi_5582_ = -(_e3035[0]);
                            } else {
                                phi_5582_ = _e3035[0];
                            }
                            let _e3042 = phi_5582_;
                            if (_e3035[1] < 0f) {
                                phi_5589_ = -(_e3035[1]);
                            } else {
                                phi_5589_ = _e3035[1];
                            }
                            let _e3046 = phi_5589_;
                            if (_e3042 > _e3046) {
                                phi_5594_ = _e3042;
                            } else {
                                phi_5594_ = _e3046;
                            }
                            let _e3049 = phi_5594_;
                            if (_e3035[2] < 0f) {
                                phi_5601_ = -(_e3035[2]);
                            } else {
                                phi_5601_ = _e3035[2];
                            }
                            let _e3053 = phi_5601_;
                            if (_e3049 > _e3053) {
                                phi_5606_ = _e3049;
                            } else {
                                phi_5606_ = _e3053;
                            }
                            let _e3056 = phi_5606_;
                            if (_e3032 > _e3056) {
                                phi_5611_ = _e3032;
                            } else {
                                phi_5611_ = _e3056;
                            }
                            let _e3059 = phi_5611_;
                            let _e3061 = local_1.member_3;
                            let _e3062 = (_e3059 + _e3061);
                            let _e3064 = ((_e3008 * 8f) * _e3062);
                            let _e3071 = local_1.member_3;
                            if (_e2760 < 0f) {
                                phi_5642_ = -(_e2760);
                            } else {
                                phi_5642_ = _e2760;
                            }
                            let _e3088 = phi_5642_;
                            if (_e2763 < 0f) {
                                phi_5648_ = -(_e2763);
                            } else {
                                phi_5648_ = _e2763;
                            }
                            let _e3092 = phi_5648_;
                            if (_e2766 < 0f) {
                                phi_5655_ = -(_e2766);
                            } else {
                                phi_5655_ = _e2766;
                            }
                            let _e3097 = phi_5655_;
                            let _e3098 = ((_e3088 + _e3092) + _e3097);
                            if (_e2781 < 0f) {
                                phi_5662_ = -(_e2781);
                            } else {
                                phi_5662_ = _e2781;
                            }
                            let _e3102 = phi_5662_;
                            if (_e2784 < 0f) {
                                phi_5668_ = -(_e2784);
                            } else {
                                phi_5668_ = _e2784;
                            }
                            let _e3106 = phi_5668_;
                            if (_e2787 < 0f) {
                                phi_5675_ = -(_e2787);
                            } else {
                                phi_5675_ = _e2787;
                            }
                            let _e3111 = phi_5675_;
                            let _e3112 = ((_e3102 + _e3106) + _e3111);
                            if (_e3098 > _e3112) {
                                phi_5681_ = _e3098;
                            } else {
                                phi_5681_ = _e3112;
                            }
                            let _e3115 = phi_5681_;
                            if (_e2830 < 0f) {
                                phi_5687_ = -(_e2830);
                            } else {
                                phi_5687_ = _e2830;
                            }
                            let _e3119 = phi_5687_;
                            if (_e2831 < 0f) {
                                phi_5693_ = -(_e2831);
                            } else {
                                phi_5693_ = _e2831;
                            }
                            let _e3123 = phi_5693_;
                            if (_e2832 < 0f) {
                                phi_5700_ = -(_e2832);
                            } else {
                                phi_5700_ = _e2832;
                            }
                            let _e3128 = phi_5700_;
                            let _e3130 = (((_e3119 + _e3123) + _e3128) * 0.5f);
                            if (_e3115 > _e3130) {
                                phi_5707_ = _e3115;
                            } else {
                                phi_5707_ = _e3130;
                            }
                            let _e3133 = phi_5707_;
                            let _e3138 = local_1.member_3;
                            let _e3151 = ((((_e2835[0] * _e2760) + (_e2835[1] * _e2763)) + (_e2835[2] * _e2766)) * 3f);
                            let _e3152 = ((((_e2892[0] * _e2781) + (_e2892[1] * _e2784)) + (_e2892[2] * _e2787)) * 3f);
                            if (_e3151 < _e3152) {
                                phi_5731_ = _e3151;
                            } else {
                                phi_5731_ = _e3152;
                            }
                            let _e3155 = phi_5731_;
                            if (_e2866 < _e2889) {
                                phi_5736_ = _e2866;
                            } else {
                                phi_5736_ = _e2889;
                            }
                            let _e3158 = phi_5736_;
                            if (_e3155 < _e3158) {
                                phi_5741_ = _e3155;
                            } else {
                                phi_5741_ = _e3158;
                            }
                            let _e3161 = phi_5741_;
                            if (_e3151 > _e3152) {
                                phi_5746_ = _e3151;
                            } else {
                                phi_5746_ = _e3152;
                            }
                            let _e3164 = phi_5746_;
                            if (_e2866 > _e2889) {
                                phi_5751_ = _e2866;
                            } else {
                                phi_5751_ = _e2889;
                            }
                            let _e3167 = phi_5751_;
                            if (_e3164 > _e3167) {
                                phi_5756_ = _e3164;
                            } else {
                                phi_5756_ = _e3167;
                            }
                            let _e3170 = phi_5756_;
                            let _e3175 = -(_e3170);
                            if (_e3161 > _e3175) {
                                phi_5766_ = _e3161;
                            } else {
                                phi_5766_ = _e3175;
                            }
                            let _e3178 = phi_5766_;
                            let _e3180 = ((_e3178 - ((((((_e2954 * 8f) * _e3064) * (0.000000059604645f * (524f / 64f))) + ((_e3071 * 19f) * ((_e2954 * (_e3008 + _e3062)) + (_e3008 * _e3062)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2954) * ((1f + _e3008) * (1f + _e3062))))) + ((_e700 * (((_e3133 + (_e3064 * (0.000000059604645f * 8f))) + ((_e3138 * 6f) * (_e3008 + _e3062))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3008) * (1f + _e3062))))) * (3f * 1.0001f)))) > 0f);
                            if _e3180 {
                                phi_6735_ = _e3180;
                            } else {
                                let _e3183 = local_1.member_1[0u];
                                let _e3189 = local_1.member_1[1u];
                                let _e3193 = (_e3183[0] + _e3189[0]);
                                let _e3194 = (_e3183[1] + _e3189[1]);
                                let _e3195 = (_e3183[2] + _e3189[2]);
                                let _e3198 = local_1.member_2[0u];
                                let _e3204 = local_1.member_2[1u];
                                let _e3208 = (_e3198[0] + _e3204[0]);
                                let _e3209 = (_e3198[1] + _e3204[1]);
                                let _e3210 = (_e3198[2] + _e3204[2]);
                                let _e3213 = ((_e3194 * _e3210) - (_e3195 * _e3209));
                                let _e3216 = ((_e3195 * _e3208) - (_e3193 * _e3210));
                                let _e3219 = ((_e3193 * _e3209) - (_e3194 * _e3208));
                                let _e3222 = local_1.member[0u];
                                let _e3228 = local_1.member_1[0u];
                                let _e3234 = local_1.member_2[0u];
                                let _e3238 = (_e3222[0] - _e3228[0]);
                                let _e3239 = (_e3222[1] - _e3228[1]);
                                let _e3240 = (_e3222[2] - _e3228[2]);
                                let _e3241 = (_e3238 - _e3234[0]);
                                let _e3242 = (_e3239 - _e3234[1]);
                                let _e3243 = (_e3240 - _e3234[2]);
                                let _e3244 = (_e3222[0] - _e3234[0]);
                                let _e3245 = (_e3222[1] - _e3234[1]);
                                let _e3246 = (_e3222[2] - _e3234[2]);
                                let _e3249 = local_1.member[1u];
                                let _e3255 = local_1.member_1[1u];
                                let _e3261 = local_1.member_2[1u];
                                let _e3265 = (_e3249[0] - _e3255[0]);
                                let _e3266 = (_e3249[1] - _e3255[1]);
                                let _e3267 = (_e3249[2] - _e3255[2]);
                                let _e3268 = (_e3265 - _e3261[0]);
                                let _e3269 = (_e3266 - _e3261[1]);
                                let _e3270 = (_e3267 - _e3261[2]);
                                let _e3271 = (_e3249[0] - _e3261[0]);
                                let _e3272 = (_e3249[1] - _e3261[1]);
                                let _e3273 = (_e3249[2] - _e3261[2]);
                                let _e3276 = local_1.member[0u];
                                if (_e3276[0] < 0f) {
                                    phi_5969_ = -(_e3276[0]);
                                } else {
                                    phi_5969_ = _e3276[0];
                                }
                                let _e3283 = phi_5969_;
                                if (_e3276[1] < 0f) {
                                    phi_5976_ = -(_e3276[1]);
                                } else {
                                    phi_5976_ = _e3276[1];
                                }
                                let _e3287 = phi_5976_;
                                if (_e3283 > _e3287) {
                                    phi_5981_ = _e3283;
                                } else {
                                    phi_5981_ = _e3287;
                                }
                                let _e3290 = phi_5981_;
                                if (_e3276[2] < 0f) {
                                    phi_5988_ = -(_e3276[2]);
                                } else {
                                    phi_5988_ = _e3276[2];
                                }
                                let _e3294 = phi_5988_;
                                if (_e3290 > _e3294) {
                                    phi_5993_ = _e3290;
                                } else {
                                    phi_5993_ = _e3294;
                                }
                                let _e3297 = phi_5993_;
                                let _e3300 = local_1.member[1u];
                                if (_e3300[0] < 0f) {
                                    phi_6006_ = -(_e3300[0]);
                                } else {
                                    phi_6006_ = _e3300[0];
                                }
                                let _e3307 = phi_6006_;
                                if (_e3300[1] < 0f) {
                                    phi_6013_ = -(_e3300[1]);
                                } else {
                                    phi_6013_ = _e3300[1];
                                }
                                let _e3311 = phi_6013_;
                                if (_e3307 > _e3311) {
                                    phi_6018_ = _e3307;
                                } else {
                                    phi_6018_ = _e3311;
                                }
                                let _e3314 = phi_6018_;
                                if (_e3300[2] < 0f) {
                                    phi_6025_ = -(_e3300[2]);
                                } else {
                                    phi_6025_ = _e3300[2];
                                }
                                let _e3318 = phi_6025_;
                                if (_e3314 > _e3318) {
                                    phi_6030_ = _e3314;
                                } else {
                                    phi_6030_ = _e3318;
                                }
                                let _e3321 = phi_6030_;
                                if (_e3297 > _e3321) {
                                    phi_6035_ = _e3297;
                                } else {
                                    phi_6035_ = _e3321;
                                }
                                let _e3324 = phi_6035_;
                                let _e3326 = local_1.member_3;
                                let _e3330 = local_1.member_1[0u];
                                if (_e3330[0] < 0f) {
                                    phi_6052_ = -(_e3330[0]);
                                } else {
                                    phi_6052_ = _e3330[0];
                                }
                                let _e3337 = phi_6052_;
                                if (_e3330[1] < 0f) {
                                    phi_6059_ = -(_e3330[1]);
                                } else {
                                    phi_6059_ = _e3330[1];
                                }
                                let _e3341 = phi_6059_;
                                if (_e3337 > _e3341) {
                                    phi_6064_ = _e3337;
                                } else {
                                    phi_6064_ = _e3341;
                                }
                                let _e3344 = phi_6064_;
                                if (_e3330[2] < 0f) {
                                    phi_6071_ = -(_e3330[2]);
                                } else {
                                    phi_6071_ = _e3330[2];
                                }
                                let _e3348 = phi_6071_;
                                if (_e3344 > _e3348) {
                                    phi_6076_ = _e3344;
                                } else {
                                    phi_6076_ = _e3348;
                                }
                                let _e3351 = phi_6076_;
                                let _e3354 = local_1.member_1[1u];
                                if (_e3354[0] < 0f) {
                                    phi_6090_ = -(_e3354[0]);
                                } else {
                                    phi_6090_ = _e3354[0];
                                }
                                let _e3361 = phi_6090_;
                                if (_e3354[1] < 0f) {
                                    phi_6097_ = -(_e3354[1]);
                                } else {
                                    phi_6097_ = _e3354[1];
                                }
                                let _e3365 = phi_6097_;
                                if (_e3361 > _e3365) {
                                    phi_6102_ = _e3361;
                                } else {
                                    phi_6102_ = _e3365;
                                }
                                let _e3368 = phi_6102_;
                                if (_e3354[2] < 0f) {
                                    phi_6109_ = -(_e3354[2]);
                                } else {
                                    phi_6109_ = _e3354[2];
                                }
                                let _e3372 = phi_6109_;
                                if (_e3368 > _e3372) {
                                    phi_6114_ = _e3368;
                                } else {
                                    phi_6114_ = _e3372;
                                }
                                let _e3375 = phi_6114_;
                                if (_e3351 > _e3375) {
                                    phi_6119_ = _e3351;
                                } else {
                                    phi_6119_ = _e3375;
                                }
                                let _e3378 = phi_6119_;
                                let _e3380 = local_1.member_3;
                                let _e3384 = local_1.member_2[0u];
                                if (_e3384[0] < 0f) {
                                    phi_6136_ = -(_e3384[0]);
                                } else {
                                    phi_6136_ = _e3384[0];
                                }
                                let _e3391 = phi_6136_;
                                if (_e3384[1] < 0f) {
                                    phi_6143_ = -(_e3384[1]);
                                } else {
                                    phi_6143_ = _e3384[1];
                                }
                                let _e3395 = phi_6143_;
                                if (_e3391 > _e3395) {
                                    phi_6148_ = _e3391;
                                } else {
                                    phi_6148_ = _e3395;
                                }
                                let _e3398 = phi_6148_;
                                if (_e3384[2] < 0f) {
                                    phi_6155_ = -(_e3384[2]);
                                } else {
                                    phi_6155_ = _e3384[2];
                                }
                                let _e3402 = phi_6155_;
                                if (_e3398 > _e3402) {
                                    phi_6160_ = _e3398;
                                } else {
                                    phi_6160_ = _e3402;
                                }
                                let _e3405 = phi_6160_;
                                let _e3408 = local_1.member_2[1u];
                                if (_e3408[0] < 0f) {
                                    phi_6174_ = -(_e3408[0]);
                                } else {
                                    phi_6174_ = _e3408[0];
                                }
                                let _e3415 = phi_6174_;
                                if (_e3408[1] < 0f) {
                                    phi_6181_ = -(_e3408[1]);
                                } else {
                                    phi_6181_ = _e3408[1];
                                }
                                let _e3419 = phi_6181_;
                                if (_e3415 > _e3419) {
                                    phi_6186_ = _e3415;
                                } else {
                                    phi_6186_ = _e3419;
                                }
                                let _e3422 = phi_6186_;
                                if (_e3408[2] < 0f) {
                                    phi_6193_ = -(_e3408[2]);
                                } else {
                                    phi_6193_ = _e3408[2];
                                }
                                let _e3426 = phi_6193_;
                                if (_e3422 > _e3426) {
                                    phi_6198_ = _e3422;
                                } else {
                                    phi_6198_ = _e3426;
                                }
                                let _e3429 = phi_6198_;
                                if (_e3405 > _e3429) {
                                    phi_6203_ = _e3405;
                                } else {
                                    phi_6203_ = _e3429;
                                }
                                let _e3432 = phi_6203_;
                                let _e3434 = local_1.member_3;
                                let _e3438 = ((((_e3324 + _e3326) + (_e3378 + _e3380)) + (_e3432 + _e3434)) * 2f);
                                let _e3441 = local_1.member_3;
                                let _e3445 = (((_e700 * 1.0001f) + (_e3441 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e3448 = ((_e3216 * _e3195) - (_e3219 * _e3194));
                                let _e3451 = ((_e3219 * _e3193) - (_e3213 * _e3195));
                                let _e3454 = ((_e3213 * _e3194) - (_e3216 * _e3193));
                                let _e3459 = (((_e3448 * _e3222[0]) + (_e3451 * _e3222[1])) + (_e3454 * _e3222[2]));
                                let _e3464 = (((_e3448 * _e3238) + (_e3451 * _e3239)) + (_e3454 * _e3240));
                                let _e3469 = (((_e3448 * _e3244) + (_e3451 * _e3245)) + (_e3454 * _e3246));
                                let _e3474 = (((_e3448 * _e3241) + (_e3451 * _e3242)) + (_e3454 * _e3243));
                                let _e3479 = (((_e3448 * _e3249[0]) + (_e3451 * _e3249[1])) + (_e3454 * _e3249[2]));
                                let _e3484 = (((_e3448 * _e3265) + (_e3451 * _e3266)) + (_e3454 * _e3267));
                                let _e3489 = (((_e3448 * _e3271) + (_e3451 * _e3272)) + (_e3454 * _e3273));
                                let _e3494 = (((_e3448 * _e3268) + (_e3451 * _e3269)) + (_e3454 * _e3270));
                                if (_e3459 < _e3464) {
                                    phi_6282_ = _e3459;
                                } else {
                                    phi_6282_ = _e3464;
                                }
                                let _e3497 = phi_6282_;
                                if (_e3469 < _e3474) {
                                    phi_6287_ = _e3469;
                                } else {
                                    phi_6287_ = _e3474;
                                }
                                let _e3500 = phi_6287_;
                                if (_e3497 < _e3500) {
                                    phi_6292_ = _e3497;
                                } else {
                                    phi_6292_ = _e3500;
                                }
                                let _e3503 = phi_6292_;
                                if (_e3479 < _e3484) {
                                    phi_6297_ = _e3479;
                                } else {
                                    phi_6297_ = _e3484;
                                }
                                let _e3506 = phi_6297_;
                                if (_e3489 < _e3494) {
                                    phi_6302_ = _e3489;
                                } else {
                                    phi_6302_ = _e3494;
                                }
                                let _e3509 = phi_6302_;
                                if (_e3506 < _e3509) {
                                    phi_6307_ = _e3506;
                                } else {
                                    phi_6307_ = _e3509;
                                }
                                let _e3512 = phi_6307_;
                                if (_e3503 < _e3512) {
                                    phi_6312_ = _e3503;
                                } else {
                                    phi_6312_ = _e3512;
                                }
                                let _e3515 = phi_6312_;
                                if (_e3459 > _e3464) {
                                    phi_6317_ = _e3459;
                                } else {
                                    phi_6317_ = _e3464;
                                }
                                let _e3518 = phi_6317_;
                                if (_e3469 > _e3474) {
                                    phi_6322_ = _e3469;
                                } else {
                                    phi_6322_ = _e3474;
                                }
                                let _e3521 = phi_6322_;
                                if (_e3518 > _e3521) {
                                    phi_6327_ = _e3518;
                                } else {
                                    phi_6327_ = _e3521;
                                }
                                let _e3524 = phi_6327_;
                                if (_e3479 > _e3484) {
                                    phi_6332_ = _e3479;
                                } else {
                                    phi_6332_ = _e3484;
                                }
                                let _e3527 = phi_6332_;
                                if (_e3489 > _e3494) {
                                    phi_6337_ = _e3489;
                                } else {
                                    phi_6337_ = _e3494;
                                }
                                let _e3530 = phi_6337_;
                                if (_e3527 > _e3530) {
                                    phi_6342_ = _e3527;
                                } else {
                                    phi_6342_ = _e3530;
                                }
                                let _e3533 = phi_6342_;
                                if (_e3524 > _e3533) {
                                    phi_6347_ = _e3524;
                                } else {
                                    phi_6347_ = _e3533;
                                }
                                let _e3536 = phi_6347_;
                                if (_e3448 < 0f) {
                                    phi_6353_ = -(_e3448);
                                } else {
                                    phi_6353_ = _e3448;
                                }
                                let _e3540 = phi_6353_;
                                if (_e3451 < 0f) {
                                    phi_6359_ = -(_e3451);
                                } else {
                                    phi_6359_ = _e3451;
                                }
                                let _e3544 = phi_6359_;
                                if (_e3454 < 0f) {
                                    phi_6366_ = -(_e3454);
                                } else {
                                    phi_6366_ = _e3454;
                                }
                                let _e3549 = phi_6366_;
                                let _e3550 = ((_e3540 + _e3544) + _e3549);
                                let _e3555 = -(_e3536);
                                if (_e3515 > _e3555) {
                                    phi_6377_ = _e3515;
                                } else {
                                    phi_6377_ = _e3555;
                                }
                                let _e3558 = phi_6377_;
                                let _e3563 = (((_e3558 - ((_e3550 * _e3438) * (0.000000059604645f * (17f / 2f)))) - (_e3550 * _e3445)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3566 = ((_e3216 * _e3210) - (_e3219 * _e3209));
                                let _e3569 = ((_e3219 * _e3208) - (_e3213 * _e3210));
                                let _e3572 = ((_e3213 * _e3209) - (_e3216 * _e3208));
                                let _e3577 = (((_e3566 * _e3222[0]) + (_e3569 * _e3222[1])) + (_e3572 * _e3222[2]));
                                let _e3582 = (((_e3566 * _e3238) + (_e3569 * _e3239)) + (_e3572 * _e3240));
                                let _e3587 = (((_e3566 * _e3244) + (_e3569 * _e3245)) + (_e3572 * _e3246));
                                let _e3592 = (((_e3566 * _e3241) + (_e3569 * _e3242)) + (_e3572 * _e3243));
                                let _e3597 = (((_e3566 * _e3249[0]) + (_e3569 * _e3249[1])) + (_e3572 * _e3249[2]));
                                let _e3602 = (((_e3566 * _e3265) + (_e3569 * _e3266)) + (_e3572 * _e3267));
                                let _e3607 = (((_e3566 * _e3271) + (_e3569 * _e3272)) + (_e3572 * _e3273));
                                let _e3612 = (((_e3566 * _e3268) + (_e3569 * _e3269)) + (_e3572 * _e3270));
                                if (_e3577 < _e3582) {
                                    phi_6448_ = _e3577;
                                } else {
                                    phi_6448_ = _e3582;
                                }
                                let _e3615 = phi_6448_;
                                if (_e3587 < _e3592) {
                                    phi_6453_ = _e3587;
                                } else {
                                    phi_6453_ = _e3592;
                                }
                                let _e3618 = phi_6453_;
                                if (_e3615 < _e3618) {
                                    phi_6458_ = _e3615;
                                } else {
                                    phi_6458_ = _e3618;
                                }
                                let _e3621 = phi_6458_;
                                if (_e3597 < _e3602) {
                                    phi_6463_ = _e3597;
                                } else {
                                    phi_6463_ = _e3602;
                                }
                                let _e3624 = phi_6463_;
                                if (_e3607 < _e3612) {
                                    phi_6468_ = _e3607;
                                } else {
                                    phi_6468_ = _e3612;
                                }
                                let _e3627 = phi_6468_;
                                if (_e3624 < _e3627) {
                                    phi_6473_ = _e3624;
                                } else {
                                    phi_6473_ = _e3627;
                                }
                                let _e3630 = phi_6473_;
                                if (_e3621 < _e3630) {
                                    phi_6478_ = _e3621;
                                } else {
                                    phi_6478_ = _e3630;
                                }
                                let _e3633 = phi_6478_;
                                if (_e3577 > _e3582) {
                                    phi_6483_ = _e3577;
                                } else {
                                    phi_6483_ = _e3582;
                                }
                                let _e3636 = phi_6483_;
                                if (_e3587 > _e3592) {
                                    phi_6488_ = _e3587;
                                } else {
                                    phi_6488_ = _e3592;
                                }
                                let _e3639 = phi_6488_;
                                if (_e3636 > _e3639) {
                                    phi_6493_ = _e3636;
                                } else {
                                    phi_6493_ = _e3639;
                                }
                                let _e3642 = phi_6493_;
                                if (_e3597 > _e3602) {
                                    phi_6498_ = _e3597;
                                } else {
                                    phi_6498_ = _e3602;
                                }
                                let _e3645 = phi_6498_;
                                if (_e3607 > _e3612) {
                                    phi_6503_ = _e3607;
                                } else {
                                    phi_6503_ = _e3612;
                                }
                                let _e3648 = phi_6503_;
                                if (_e3645 > _e3648) {
                                    phi_6508_ = _e3645;
                                } else {
                                    phi_6508_ = _e3648;
                                }
                                let _e3651 = phi_6508_;
                                if (_e3642 > _e3651) {
                                    phi_6513_ = _e3642;
                                } else {
                                    phi_6513_ = _e3651;
                                }
                                let _e3654 = phi_6513_;
                                if (_e3566 < 0f) {
                                    phi_6519_ = -(_e3566);
                                } else {
                                    phi_6519_ = _e3566;
                                }
                                let _e3658 = phi_6519_;
                                if (_e3569 < 0f) {
                                    phi_6525_ = -(_e3569);
                                } else {
                                    phi_6525_ = _e3569;
                                }
                                let _e3662 = phi_6525_;
                                if (_e3572 < 0f) {
                                    phi_6532_ = -(_e3572);
                                } else {
                                    phi_6532_ = _e3572;
                                }
                                let _e3667 = phi_6532_;
                                let _e3668 = ((_e3658 + _e3662) + _e3667);
                                let _e3673 = -(_e3654);
                                if (_e3633 > _e3673) {
                                    phi_6543_ = _e3633;
                                } else {
                                    phi_6543_ = _e3673;
                                }
                                let _e3676 = phi_6543_;
                                let _e3681 = (((_e3676 - ((_e3668 * _e3438) * (0.000000059604645f * (17f / 2f)))) - (_e3668 * _e3445)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3563 > _e3681) {
                                    phi_6553_ = _e3563;
                                } else {
                                    phi_6553_ = _e3681;
                                }
                                let _e3684 = phi_6553_;
                                phi_6735_ = (_e3180 || (_e3684 > 0f));
                            }
                            let _e3688 = phi_6735_;
                            phi_6737_ = (_e2745 && _e3688);
                        } else {
                            phi_6737_ = _e2745;
                        }
                        let _e3691 = phi_6737_;
                        phi_6739_ = (_e1712 || _e3691);
                    }
                    let _e3694 = phi_6739_;
                    let _e3695 = !(_e3694);
                    if _e3695 {
                        let _e3697 = atomicAdd((&counters[0u]), 1u);
                        phi_6746_ = _e3697;
                    } else {
                        phi_6746_ = 0u;
                    }
                    let _e3699 = phi_6746_;
                    phi_6747_ = _e3699;
                    phi_6748_ = _e3695;
                } else {
                    phi_6747_ = 0u;
                    phi_6748_ = false;
                }
                let _e3701 = phi_6747_;
                let _e3703 = phi_6748_;
                phi_6749_ = _e3701;
                phi_6750_ = _e3703;
                phi_6751_ = type_12(_e144, _e147);
            } else {
                phi_6749_ = 0u;
                phi_6750_ = false;
                phi_6751_ = type_12(0u, 0u);
            }
            let _e3705 = phi_6749_;
            let _e3707 = phi_6750_;
            let _e3709 = phi_6751_;
            workgroupBarrier();
            if (_e53 == 0u) {
                let _e3712 = atomicLoad((&counters[0u]));
                let _e3714 = atomicLoad((&counters[1u]));
                if (_e3712 > 0u) {
                    let _e3717 = atomicAdd((&output.member[0u]), _e3712);
                    if ((_e3717 + _e3712) < _e3717) {
                        let _e3721 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e3717);
                }
                if (_e3714 > 0u) {
                    let _e3725 = atomicAdd((&output.member[1u]), _e3714);
                    if ((_e3725 + _e3714) < _e3725) {
                        let _e3729 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e3707 {
                let _e3731 = params.member.member_1.member_3;
                let _e3733 = atomicLoad((&counters[2u]));
                let _e3734 = (_e3733 + _e3705);
                if (_e3734 < _e3731) {
                    let _e3738 = (2u * _e3734);
                    atomicStore((&output.member[(4u + _e3738)]), _e3709.member);
                    atomicStore((&output.member[(_e3738 + 5u)]), _e3709.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_374_ = _e123;
            break if !(_e129);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_listed_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
