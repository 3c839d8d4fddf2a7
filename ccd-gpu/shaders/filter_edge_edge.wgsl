struct type_4 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_10 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<type_4>,
}

struct type_15 {
    member: array<u32>,
}

struct type_16 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_21 {
    member: u32,
    member_1: u32,
}

struct type_24 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_26 {
    member: array<type_24>,
}

struct type_29 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_35 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_40 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> nodes: type_13;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_4, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(2) 
var<storage> leaves: type_18;
@group(0) @binding(3) 
var<storage> bodies: type_15;
@group(0) @binding(4) 
var<storage> keys: type_29;
@group(0) @binding(5) 
var<storage> paths: type_26;
@group(0) @binding(6) 
var<storage> input: type_15;
@group(0) @binding(7) 
var<storage, read_write> output: type_40;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<f32, 3>, 4>;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var local_3: array<array<f32, 3>, 4>;
    var local_4: array<type_35, 2>;
    var local_5: array<array<f32, 3>, 4>;
    var local_6: array<array<f32, 3>, 4>;
    var local_7: type_35;
    var local_8: array<array<u32, 2>, 6>;
    var local_9: array<array<u32, 2>, 6>;
    var local_10: array<array<u32, 2>, 6>;
    var local_11: array<array<u32, 2>, 6>;
    var local_12: array<array<u32, 2>, 6>;
    var local_13: array<array<u32, 2>, 6>;
    var local_14: array<array<u32, 2>, 6>;
    var local_15: array<array<u32, 2>, 6>;
    var local_16: array<array<u32, 2>, 6>;
    var local_17: array<array<u32, 2>, 6>;
    var local_18: array<array<u32, 2>, 6>;
    var local_19: array<array<u32, 2>, 6>;
    var local_20: array<array<u32, 2>, 6>;
    var local_21: array<array<u32, 2>, 6>;
    var local_22: array<array<u32, 2>, 6>;
    var local_23: array<array<u32, 2>, 6>;
    var local_24: type_16;
    var local_25: type_16;
    var local_26: type_16;
    var local_27: type_16;
    var phi_233_: u32;
    var phi_271_: u32;
    var phi_272_: u32;
    var phi_279_: u32;
    var phi_295_: u32;
    var phi_316_: u32;
    var phi_317_: u32;
    var phi_320_: type_21;
    var phi_321_: type_21;
    var phi_344_: type_21;
    var phi_382_: u32;
    var phi_383_: u32;
    var phi_390_: u32;
    var phi_400_: u32;
    var phi_479_: array<u32, 2>;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_678_: type_4;
    var phi_691_: type_21;
    var phi_694_: u32;
    var phi_692_: type_21;
    var phi_717_: type_21;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_789_: bool;
    var phi_807_: u32;
    var phi_808_: u32;
    var phi_809_: u32;
    var phi_695_: u32;
    var phi_812_: type_21;
    var phi_815_: u32;
    var phi_813_: type_21;
    var phi_838_: type_21;
    var phi_984_: bool;
    var phi_985_: bool;
    var phi_986_: bool;
    var phi_987_: bool;
    var phi_988_: bool;
    var phi_992_: bool;
    var phi_948_: bool;
    var phi_949_: bool;
    var phi_950_: bool;
    var phi_954_: bool;
    var phi_993_: bool;
    var phi_997_: bool;
    var phi_998_: bool;
    var phi_1044_: bool;
    var phi_1054_: bool;
    var phi_1055_: bool;
    var phi_1059_: bool;
    var phi_1060_: bool;
    var phi_1109_: type_21;
    var phi_1112_: bool;
    var phi_1110_: type_21;
    var phi_1135_: type_21;
    var phi_1192_: type_21;
    var phi_1195_: array<u32, 2>;
    var phi_1193_: type_21;
    var phi_1218_: type_21;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1298_: array<u32, 2>;
    var phi_1196_: array<u32, 2>;
    var phi_1349_: type_21;
    var phi_1352_: array<u32, 2>;
    var phi_1350_: type_21;
    var phi_1375_: type_21;
    var phi_1451_: bool;
    var phi_1452_: bool;
    var phi_1456_: array<u32, 2>;
    var phi_1353_: array<u32, 2>;
    var local_28: array<u32, 2>;
    var local_29: array<u32, 2>;
    var local_30: array<u32, 2>;
    var local_31: array<u32, 2>;
    var local_32: array<u32, 2>;
    var local_33: array<u32, 2>;
    var phi_1472_: bool;
    var phi_1473_: bool;
    var phi_1524_: type_21;
    var phi_1527_: array<u32, 2>;
    var phi_1525_: type_21;
    var phi_1550_: type_21;
    var phi_1625_: bool;
    var phi_1626_: bool;
    var phi_1630_: array<u32, 2>;
    var phi_1528_: array<u32, 2>;
    var phi_1681_: type_21;
    var phi_1684_: array<u32, 2>;
    var phi_1682_: type_21;
    var phi_1707_: type_21;
    var phi_1783_: bool;
    var phi_1784_: bool;
    var phi_1788_: array<u32, 2>;
    var phi_1685_: array<u32, 2>;
    var local_34: array<u32, 2>;
    var local_35: array<u32, 2>;
    var local_36: array<u32, 2>;
    var local_37: array<u32, 2>;
    var local_38: array<u32, 2>;
    var local_39: array<u32, 2>;
    var phi_1804_: bool;
    var phi_1805_: bool;
    var phi_1113_: bool;
    var phi_1809_: bool;
    var phi_1810_: bool;
    var phi_1811_: bool;
    var phi_1815_: bool;
    var phi_1816_: bool;
    var phi_1817_: bool;
    var phi_1818_: bool;
    var phi_1819_: bool;
    var phi_1823_: bool;
    var phi_1843_: type_21;
    var phi_1888_: u32;
    var phi_1889_: bool;
    var phi_816_: u32;
    var phi_1890_: bool;
    var phi_1897_: u32;
    var phi_1900_: type_21;
    var phi_1901_: type_21;
    var phi_1924_: type_21;
    var phi_2078_: bool;
    var phi_2079_: bool;
    var phi_2080_: bool;
    var phi_2081_: bool;
    var phi_2082_: bool;
    var phi_2086_: bool;
    var phi_2042_: bool;
    var phi_2043_: bool;
    var phi_2044_: bool;
    var phi_2048_: bool;
    var phi_2087_: bool;
    var phi_2091_: bool;
    var phi_2092_: bool;
    var phi_2138_: bool;
    var phi_2148_: bool;
    var phi_2149_: bool;
    var phi_2153_: bool;
    var phi_2154_: bool;
    var phi_2203_: type_21;
    var phi_2206_: bool;
    var phi_2204_: type_21;
    var phi_2229_: type_21;
    var phi_2286_: type_21;
    var phi_2289_: array<u32, 2>;
    var phi_2287_: type_21;
    var phi_2312_: type_21;
    var phi_2387_: bool;
    var phi_2388_: bool;
    var phi_2392_: array<u32, 2>;
    var phi_2290_: array<u32, 2>;
    var phi_2443_: type_21;
    var phi_2446_: array<u32, 2>;
    var phi_2444_: type_21;
    var phi_2469_: type_21;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2550_: array<u32, 2>;
    var phi_2447_: array<u32, 2>;
    var local_40: array<u32, 2>;
    var local_41: array<u32, 2>;
    var local_42: array<u32, 2>;
    var local_43: array<u32, 2>;
    var local_44: array<u32, 2>;
    var local_45: array<u32, 2>;
    var phi_2566_: bool;
    var phi_2567_: bool;
    var phi_2618_: type_21;
    var phi_2621_: array<u32, 2>;
    var phi_2619_: type_21;
    var phi_2644_: type_21;
    var phi_2719_: bool;
    var phi_2720_: bool;
    var phi_2724_: array<u32, 2>;
    var phi_2622_: array<u32, 2>;
    var phi_2775_: type_21;
    var phi_2778_: array<u32, 2>;
    var phi_2776_: type_21;
    var phi_2801_: type_21;
    var phi_2877_: bool;
    var phi_2878_: bool;
    var phi_2882_: array<u32, 2>;
    var phi_2779_: array<u32, 2>;
    var local_46: array<u32, 2>;
    var local_47: array<u32, 2>;
    var local_48: array<u32, 2>;
    var local_49: array<u32, 2>;
    var local_50: array<u32, 2>;
    var local_51: array<u32, 2>;
    var phi_2898_: bool;
    var phi_2899_: bool;
    var phi_2207_: bool;
    var phi_2903_: bool;
    var phi_2904_: bool;
    var phi_2905_: bool;
    var phi_2909_: bool;
    var phi_2910_: bool;
    var phi_2911_: bool;
    var phi_2912_: bool;
    var phi_2913_: bool;
    var phi_2917_: bool;
    var phi_2963_: type_16;
    var phi_2964_: type_16;
    var phi_3353_: f32;
    var phi_3360_: f32;
    var phi_3365_: f32;
    var phi_3372_: f32;
    var phi_3377_: f32;
    var phi_3390_: f32;
    var phi_3397_: f32;
    var phi_3402_: f32;
    var phi_3409_: f32;
    var phi_3414_: f32;
    var phi_3419_: f32;
    var phi_3436_: f32;
    var phi_3443_: f32;
    var phi_3448_: f32;
    var phi_3455_: f32;
    var phi_3460_: f32;
    var phi_3474_: f32;
    var phi_3481_: f32;
    var phi_3486_: f32;
    var phi_3493_: f32;
    var phi_3498_: f32;
    var phi_3503_: f32;
    var phi_3520_: f32;
    var phi_3527_: f32;
    var phi_3532_: f32;
    var phi_3539_: f32;
    var phi_3544_: f32;
    var phi_3558_: f32;
    var phi_3565_: f32;
    var phi_3570_: f32;
    var phi_3577_: f32;
    var phi_3582_: f32;
    var phi_3587_: f32;
    var phi_3618_: f32;
    var phi_3624_: f32;
    var phi_3631_: f32;
    var phi_3638_: f32;
    var phi_3644_: f32;
    var phi_3651_: f32;
    var phi_3657_: f32;
    var phi_3663_: f32;
    var phi_3669_: f32;
    var phi_3676_: f32;
    var phi_3683_: f32;
    var phi_3707_: f32;
    var phi_3712_: f32;
    var phi_3717_: f32;
    var phi_3722_: f32;
    var phi_3727_: f32;
    var phi_3732_: f32;
    var phi_3742_: f32;
    var phi_3993_: f32;
    var phi_4000_: f32;
    var phi_4005_: f32;
    var phi_4012_: f32;
    var phi_4017_: f32;
    var phi_4030_: f32;
    var phi_4037_: f32;
    var phi_4042_: f32;
    var phi_4049_: f32;
    var phi_4054_: f32;
    var phi_4059_: f32;
    var phi_4076_: f32;
    var phi_4083_: f32;
    var phi_4088_: f32;
    var phi_4095_: f32;
    var phi_4100_: f32;
    var phi_4114_: f32;
    var phi_4121_: f32;
    var phi_4126_: f32;
    var phi_4133_: f32;
    var phi_4138_: f32;
    var phi_4143_: f32;
    var phi_4160_: f32;
    var phi_4167_: f32;
    var phi_4172_: f32;
    var phi_4179_: f32;
    var phi_4184_: f32;
    var phi_4198_: f32;
    var phi_4205_: f32;
    var phi_4210_: f32;
    var phi_4217_: f32;
    var phi_4222_: f32;
    var phi_4227_: f32;
    var phi_4265_: type_21;
    var phi_4268_: f32;
    var phi_4270_: f32;
    var phi_4266_: type_21;
    var phi_4293_: type_21;
    var phi_4343_: f32;
    var phi_4348_: f32;
    var phi_4353_: f32;
    var phi_4358_: f32;
    var phi_4269_: f32;
    var phi_4271_: f32;
    var phi_4364_: f32;
    var phi_4370_: f32;
    var phi_4377_: f32;
    var local_52: f32;
    var local_53: f32;
    var phi_4387_: f32;
    var phi_4418_: type_21;
    var phi_4421_: f32;
    var phi_4423_: f32;
    var phi_4419_: type_21;
    var phi_4446_: type_21;
    var phi_4496_: f32;
    var phi_4501_: f32;
    var phi_4506_: f32;
    var phi_4511_: f32;
    var phi_4422_: f32;
    var phi_4424_: f32;
    var phi_4517_: f32;
    var phi_4523_: f32;
    var phi_4530_: f32;
    var local_54: f32;
    var local_55: f32;
    var phi_4540_: f32;
    var phi_4550_: f32;
    var phi_4718_: bool;
    var phi_5175_: f32;
    var phi_5182_: f32;
    var phi_5187_: f32;
    var phi_5194_: f32;
    var phi_5199_: f32;
    var phi_5212_: f32;
    var phi_5219_: f32;
    var phi_5224_: f32;
    var phi_5231_: f32;
    var phi_5236_: f32;
    var phi_5241_: f32;
    var phi_5258_: f32;
    var phi_5265_: f32;
    var phi_5270_: f32;
    var phi_5277_: f32;
    var phi_5282_: f32;
    var phi_5296_: f32;
    var phi_5303_: f32;
    var phi_5308_: f32;
    var phi_5315_: f32;
    var phi_5320_: f32;
    var phi_5325_: f32;
    var phi_5342_: f32;
    var phi_5349_: f32;
    var phi_5354_: f32;
    var phi_5361_: f32;
    var phi_5366_: f32;
    var phi_5380_: f32;
    var phi_5387_: f32;
    var phi_5392_: f32;
    var phi_5399_: f32;
    var phi_5404_: f32;
    var phi_5409_: f32;
    var phi_5440_: f32;
    var phi_5446_: f32;
    var phi_5453_: f32;
    var phi_5460_: f32;
    var phi_5466_: f32;
    var phi_5473_: f32;
    var phi_5479_: f32;
    var phi_5485_: f32;
    var phi_5491_: f32;
    var phi_5498_: f32;
    var phi_5505_: f32;
    var phi_5529_: f32;
    var phi_5534_: f32;
    var phi_5539_: f32;
    var phi_5544_: f32;
    var phi_5549_: f32;
    var phi_5554_: f32;
    var phi_5564_: f32;
    var phi_5815_: f32;
    var phi_5822_: f32;
    var phi_5827_: f32;
    var phi_5834_: f32;
    var phi_5839_: f32;
    var phi_5852_: f32;
    var phi_5859_: f32;
    var phi_5864_: f32;
    var phi_5871_: f32;
    var phi_5876_: f32;
    var phi_5881_: f32;
    var phi_5898_: f32;
    var phi_5905_: f32;
    var phi_5910_: f32;
    var phi_5917_: f32;
    var phi_5922_: f32;
    var phi_5936_: f32;
    var phi_5943_: f32;
    var phi_5948_: f32;
    var phi_5955_: f32;
    var phi_5960_: f32;
    var phi_5965_: f32;
    var phi_5982_: f32;
    var phi_5989_: f32;
    var phi_5994_: f32;
    var phi_6001_: f32;
    var phi_6006_: f32;
    var phi_6020_: f32;
    var phi_6027_: f32;
    var phi_6032_: f32;
    var phi_6039_: f32;
    var phi_6044_: f32;
    var phi_6049_: f32;
    var phi_6087_: type_21;
    var phi_6090_: f32;
    var phi_6092_: f32;
    var phi_6088_: type_21;
    var phi_6115_: type_21;
    var phi_6165_: f32;
    var phi_6170_: f32;
    var phi_6175_: f32;
    var phi_6180_: f32;
    var phi_6091_: f32;
    var phi_6093_: f32;
    var phi_6186_: f32;
    var phi_6192_: f32;
    var phi_6199_: f32;
    var local_56: f32;
    var local_57: f32;
    var phi_6209_: f32;
    var phi_6240_: type_21;
    var phi_6243_: f32;
    var phi_6245_: f32;
    var phi_6241_: type_21;
    var phi_6268_: type_21;
    var phi_6318_: f32;
    var phi_6323_: f32;
    var phi_6328_: f32;
    var phi_6333_: f32;
    var phi_6244_: f32;
    var phi_6246_: f32;
    var phi_6339_: f32;
    var phi_6345_: f32;
    var phi_6352_: f32;
    var local_58: f32;
    var local_59: f32;
    var phi_6362_: f32;
    var phi_6372_: f32;
    var phi_6540_: bool;
    var phi_6786_: f32;
    var phi_6793_: f32;
    var phi_6798_: f32;
    var phi_6805_: f32;
    var phi_6810_: f32;
    var phi_6823_: f32;
    var phi_6830_: f32;
    var phi_6835_: f32;
    var phi_6842_: f32;
    var phi_6847_: f32;
    var phi_6852_: f32;
    var phi_6869_: f32;
    var phi_6876_: f32;
    var phi_6881_: f32;
    var phi_6888_: f32;
    var phi_6893_: f32;
    var phi_6907_: f32;
    var phi_6914_: f32;
    var phi_6919_: f32;
    var phi_6926_: f32;
    var phi_6931_: f32;
    var phi_6936_: f32;
    var phi_6953_: f32;
    var phi_6960_: f32;
    var phi_6965_: f32;
    var phi_6972_: f32;
    var phi_6977_: f32;
    var phi_6991_: f32;
    var phi_6998_: f32;
    var phi_7003_: f32;
    var phi_7010_: f32;
    var phi_7015_: f32;
    var phi_7020_: f32;
    var phi_7051_: f32;
    var phi_7057_: f32;
    var phi_7064_: f32;
    var phi_7071_: f32;
    var phi_7077_: f32;
    var phi_7084_: f32;
    var phi_7090_: f32;
    var phi_7096_: f32;
    var phi_7102_: f32;
    var phi_7109_: f32;
    var phi_7116_: f32;
    var phi_7140_: f32;
    var phi_7145_: f32;
    var phi_7150_: f32;
    var phi_7155_: f32;
    var phi_7160_: f32;
    var phi_7165_: f32;
    var phi_7175_: f32;
    var phi_7426_: f32;
    var phi_7433_: f32;
    var phi_7438_: f32;
    var phi_7445_: f32;
    var phi_7450_: f32;
    var phi_7463_: f32;
    var phi_7470_: f32;
    var phi_7475_: f32;
    var phi_7482_: f32;
    var phi_7487_: f32;
    var phi_7492_: f32;
    var phi_7509_: f32;
    var phi_7516_: f32;
    var phi_7521_: f32;
    var phi_7528_: f32;
    var phi_7533_: f32;
    var phi_7547_: f32;
    var phi_7554_: f32;
    var phi_7559_: f32;
    var phi_7566_: f32;
    var phi_7571_: f32;
    var phi_7576_: f32;
    var phi_7593_: f32;
    var phi_7600_: f32;
    var phi_7605_: f32;
    var phi_7612_: f32;
    var phi_7617_: f32;
    var phi_7631_: f32;
    var phi_7638_: f32;
    var phi_7643_: f32;
    var phi_7650_: f32;
    var phi_7655_: f32;
    var phi_7660_: f32;
    var phi_7698_: type_21;
    var phi_7701_: f32;
    var phi_7703_: f32;
    var phi_7699_: type_21;
    var phi_7726_: type_21;
    var phi_7776_: f32;
    var phi_7781_: f32;
    var phi_7786_: f32;
    var phi_7791_: f32;
    var phi_7702_: f32;
    var phi_7704_: f32;
    var phi_7797_: f32;
    var phi_7803_: f32;
    var phi_7810_: f32;
    var local_60: f32;
    var local_61: f32;
    var phi_7820_: f32;
    var phi_7851_: type_21;
    var phi_7854_: f32;
    var phi_7856_: f32;
    var phi_7852_: type_21;
    var phi_7879_: type_21;
    var phi_7929_: f32;
    var phi_7934_: f32;
    var phi_7939_: f32;
    var phi_7944_: f32;
    var phi_7855_: f32;
    var phi_7857_: f32;
    var phi_7950_: f32;
    var phi_7956_: f32;
    var phi_7963_: f32;
    var local_62: f32;
    var local_63: f32;
    var phi_7973_: f32;
    var phi_7983_: f32;
    var phi_8151_: bool;
    var phi_8152_: bool;
    var phi_8154_: bool;
    var phi_8164_: bool;
    var phi_8165_: bool;
    var phi_8215_: type_21;
    var phi_8216_: type_21;
    var phi_8239_: type_21;
    var phi_8262_: u32;
    var phi_8316_: type_21;
    var phi_8337_: bool;
    var phi_8338_: bool;
    var local_64: u32;
    var local_65: bool;
    var local_66: bool;
    var local_67: f32;
    var local_68: f32;
    var local_69: f32;
    var local_70: f32;
    var local_71: f32;
    var local_72: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e95 = id_2;
    let _e96 = n_2;
    let _e97 = lane_2;
    let _e110 = ((_e95.y * _e96.x) + _e95.x);
    let _e113 = (_e96.x * _e96.y);
    let _e115 = params.member.member_15;
    let _e117 = input.member[0u];
    if (_e115 < _e117) {
        phi_233_ = _e115;
    } else {
        phi_233_ = _e117;
    }
    let _e120 = phi_233_;
    let _e121 = (_e97 / 32u);
    let _e122 = (_e97 % 32u);
    let _e124 = params.member.member_12;
    if (_e120 > _e124) {
        let _e127 = params.member.member_12;
        let _e128 = (_e120 - _e127);
        let _e130 = params.member.member_13;
        if (_e130 == 0u) {
            return;
        }
        let _e132 = (_e128 / _e130);
        if (_e130 == 0u) {
            return;
        }
        if ((_e128 % _e130) > 0u) {
            phi_271_ = (_e132 + 1u);
        } else {
            phi_271_ = _e132;
        }
        let _e138 = phi_271_;
        phi_272_ = _e138;
    } else {
        phi_272_ = 0u;
    }
    let _e140 = phi_272_;
    let _e142 = params.member.member_14;
    if (_e142 < _e140) {
        phi_279_ = _e142;
    } else {
        phi_279_ = _e140;
    }
    let _e145 = phi_279_;
    let _e146 = (_e145 / 4u);
    if ((_e145 % 4u) > 0u) {
        phi_295_ = (_e146 + 1u);
    } else {
        phi_295_ = _e146;
    }
    let _e151 = phi_295_;
    if (_e151 > _e110) {
        let _e153 = (_e151 - _e110);
        if (_e113 == 0u) {
            return;
        }
        let _e155 = (_e153 / _e113);
        if (_e113 == 0u) {
            return;
        }
        if ((_e153 % _e113) > 0u) {
            phi_316_ = (_e155 + 1u);
        } else {
            phi_316_ = _e155;
        }
        let _e161 = phi_316_;
        phi_317_ = _e161;
    } else {
        phi_317_ = 0u;
    }
    let _e163 = phi_317_;
    phi_320_ = type_21(0u, _e163);
    loop {
        let _e166 = phi_320_;
        if (_e166.member < _e166.member_1) {
            phi_321_ = type_21((_e166.member + 1u), _e166.member_1);
            phi_344_ = type_21(1u, _e166.member);
        } else {
            phi_321_ = _e166;
            phi_344_ = type_21(0u, type_21().member_1);
        }
        let _e178 = phi_321_;
        let _e180 = phi_344_;
        let _e184 = (bitcast<i32>(_e180.member) != 0i);
        if _e184 {
            let _e188 = (((_e110 + (_e180.member_1 * _e113)) * 4u) + _e121);
            let _e190 = params.member.member_12;
            if (_e120 > _e190) {
                let _e193 = params.member.member_12;
                let _e194 = (_e120 - _e193);
                let _e196 = params.member.member_13;
                if (_e196 == 0u) {
                    return;
                }
                let _e198 = (_e194 / _e196);
                if (_e196 == 0u) {
                    return;
                }
                if ((_e194 % _e196) > 0u) {
                    phi_382_ = (_e198 + 1u);
                } else {
                    phi_382_ = _e198;
                }
                let _e204 = phi_382_;
                phi_383_ = _e204;
            } else {
                phi_383_ = 0u;
            }
            let _e206 = phi_383_;
            let _e208 = params.member.member_14;
            if (_e208 < _e206) {
                phi_390_ = _e208;
            } else {
                phi_390_ = _e206;
            }
            let _e211 = phi_390_;
            let _e212 = (_e188 < _e211);
            let _e214 = params.member.member_12;
            if _e212 {
                let _e216 = params.member.member_13;
                phi_400_ = (_e188 * _e216);
            } else {
                phi_400_ = 0u;
            }
            let _e219 = phi_400_;
            let _e221 = (2u * (_e214 + _e219));
            let _e224 = input.member[(4u + _e221)];
            let _e227 = input.member[(_e221 + 5u)];
            if (_e97 < 8u) {
                atomicStore((&counters[_e97]), 0u);
            }
            workgroupBarrier();
            let _e234 = params.member.member_20[0u][1u];
            let _e235 = (_e234 + (_e224 * 32u));
            let _e240 = params.member.member_20[0u][1u];
            let _e241 = (_e240 + (_e227 * 32u));
            if (_e122 == 0u) {
                firsts[(2u * _e121)] = _e235;
                firsts[((2u * _e121) + 1u)] = _e241;
            }
            let _e249 = params.member.member_8;
            if (_e249 == 0u) {
                phi_479_ = array<u32, 2>(0u, 2u);
            } else {
                phi_479_ = array<u32, 2>(1u, 1u);
            }
            let _e252 = phi_479_;
            let _e255 = (_e97 / 32u);
            let _e256 = (_e97 % 32u);
            let _e258 = params.member.member_9;
            let _e262 = params.member.member_20[_e258][_e252[0]];
            let _e265 = nodes.member[(_e262 + _e224)];
            let _e267 = params.member.member_9;
            let _e271 = params.member.member_20[_e267][_e252[1]];
            let _e274 = nodes.member[(_e271 + _e227)];
            let _e276 = params.member.member_9;
            let _e283 = params.member.member_20[(_e276 - 1u)][_e252[0]];
            let _e286 = nodes.member[(_e283 + ((_e224 * 32u) + _e256))];
            let _e288 = params.member.member_9;
            let _e295 = params.member.member_20[(_e288 - 1u)][_e252[1]];
            let _e298 = nodes.member[(_e295 + ((_e227 * 32u) + _e256))];
            if _e212 {
                if ((((((_e298.member[0] <= _e265.member_1[0]) && (_e265.member[0] <= _e298.member_1[0])) && (_e298.member[1] <= _e265.member_1[1])) && (_e265.member[1] <= _e298.member_1[1])) && (_e298.member[2] <= _e265.member_1[2])) && (_e265.member[2] <= _e298.member_1[2])) {
                    let _e336 = atomicAdd((&counters[_e255]), 1u);
                    let _e337 = ((_e255 * 32u) + _e336);
                    columns[_e337] = type_4(array<f32, 3>(_e298.member[0], _e298.member[1], _e298.member[2]), array<f32, 3>(_e298.member_1[0], _e298.member_1[1], _e298.member_1[2]));
                    names[_e337] = _e256;
                }
            }
            workgroupBarrier();
            if _e212 {
                if ((((((_e286.member[0] <= _e274.member_1[0]) && (_e274.member[0] <= _e286.member_1[0])) && (_e286.member[1] <= _e274.member_1[1])) && (_e274.member[1] <= _e286.member_1[1])) && (_e286.member[2] <= _e274.member_1[2])) && (_e274.member[2] <= _e286.member_1[2])) {
                    phi_673_ = false;
                } else {
                    phi_673_ = true;
                }
                let _e387 = phi_673_;
                phi_674_ = _e387;
            } else {
                phi_674_ = true;
            }
            let _e389 = phi_674_;
            if _e389 {
                phi_678_ = type_4(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_678_ = _e286;
            }
            let _e391 = phi_678_;
            let _e393 = (_e97 / 32u);
            let _e394 = (_e97 % 32u);
            let _e396 = atomicLoad((&counters[_e393]));
            phi_691_ = type_21(0u, _e396);
            phi_694_ = 0u;
            loop {
                let _e399 = phi_691_;
                let _e401 = phi_694_;
                local_64 = _e401;
                if (_e399.member < _e399.member_1) {
                    phi_692_ = type_21((_e399.member + 1u), _e399.member_1);
                    phi_717_ = type_21(1u, _e399.member);
                } else {
                    phi_692_ = _e399;
                    phi_717_ = type_21(0u, type_21().member_1);
                }
                let _e413 = phi_692_;
                let _e415 = phi_717_;
                let _e419 = (bitcast<i32>(_e415.member) != 0i);
                if _e419 {
                    let _e423 = names[((_e393 * 32u) + _e415.member_1)];
                    let _e427 = columns[((_e393 * 32u) + _e415.member_1)];
                    if ((((((_e391.member[0] <= _e427.member_1[0]) && (_e427.member[0] <= _e391.member_1[0])) && (_e391.member[1] <= _e427.member_1[1])) && (_e427.member[1] <= _e391.member_1[1])) && (_e391.member[2] <= _e427.member_1[2])) && (_e427.member[2] <= _e391.member_1[2])) {
                        if (_e224 == _e227) {
                            let _e459 = (_e394 < _e423);
                            if _e459 {
                                phi_783_ = bool();
                            } else {
                                phi_783_ = false;
                            }
                            let _e461 = phi_783_;
                            phi_784_ = _e461;
                            phi_785_ = _e459;
                        } else {
                            phi_784_ = bool();
                            phi_785_ = true;
                        }
                        let _e463 = phi_784_;
                        let _e465 = phi_785_;
                        if _e465 {
                            phi_789_ = true;
                        } else {
                            phi_789_ = _e463;
                        }
                        let _e467 = phi_789_;
                        if _e467 {
                            let _e469 = atomicAdd((&counters[4u]), 1u);
                            if (_e469 < 2048u) {
                                hits[_e469] = (((_e393 << bitcast<u32>(10i)) | (_e394 << bitcast<u32>(5i))) | _e423);
                                phi_807_ = _e401;
                            } else {
                                phi_807_ = (_e401 | (1u << bitcast<u32>((_e415.member_1 & 31u))));
                            }
                            let _e483 = phi_807_;
                            phi_808_ = _e483;
                        } else {
                            phi_808_ = _e401;
                        }
                        let _e485 = phi_808_;
                        phi_809_ = _e485;
                    } else {
                        phi_809_ = _e401;
                    }
                    let _e487 = phi_809_;
                    phi_695_ = _e487;
                } else {
                    phi_695_ = u32();
                }
                let _e489 = phi_695_;
                continue;
                continuing {
                    phi_691_ = _e413;
                    phi_694_ = _e489;
                    break if !(_e419);
                }
            }
            phi_812_ = type_21(0u, 32u);
            let _e5164 = local_64;
            phi_815_ = _e5164;
            loop {
                let _e492 = phi_812_;
                let _e494 = phi_815_;
                if (_e492.member < _e492.member_1) {
                    phi_813_ = type_21((_e492.member + 1u), _e492.member_1);
                    phi_838_ = type_21(1u, _e492.member);
                } else {
                    phi_813_ = _e492;
                    phi_838_ = type_21(0u, type_21().member_1);
                }
                let _e506 = phi_813_;
                let _e508 = phi_838_;
                if (bitcast<i32>(_e508.member) != 0i) {
                    if (_e494 == 0u) {
                        phi_1888_ = u32();
                        phi_1889_ = false;
                    } else {
                        let _e519 = names[((_e121 * 32u) + select(firstTrailingBit(_e494), 32u, (_e494 == 0u)))];
                        let _e522 = (_e235 + _e122);
                        let _e523 = (_e241 + _e519);
                        let _e525 = leaves.member[_e522];
                        let _e527 = leaves.member[_e523];
                        local_24 = type_16(array<u32, 3>(_e525.member[0], _e525.member[1], _e525.member[2]), _e525.member_1);
                        local_25 = type_16(array<u32, 3>(_e527.member[0], _e527.member[1], _e527.member[2]), _e527.member_1);
                        let _e543 = nodes.member[_e522];
                        let _e545 = nodes.member[_e523];
                        let _e547 = params.member.member_1;
                        if ((_e547 & 1u) != 0u) {
                            let _e551 = params.member.member_8;
                            if (_e551 == 0u) {
                                let _e595 = local_24.member[0u];
                                let _e598 = local_25.member[0u];
                                if (_e595 == _e598) {
                                    phi_949_ = bool();
                                    phi_950_ = true;
                                } else {
                                    let _e602 = local_24.member[0u];
                                    let _e605 = local_25.member[1u];
                                    let _e606 = (_e602 == _e605);
                                    if _e606 {
                                        phi_948_ = bool();
                                    } else {
                                        let _e609 = local_24.member[0u];
                                        let _e612 = local_25.member[2u];
                                        phi_948_ = (_e609 == _e612);
                                    }
                                    let _e615 = phi_948_;
                                    phi_949_ = _e615;
                                    phi_950_ = _e606;
                                }
                                let _e617 = phi_949_;
                                let _e619 = phi_950_;
                                if _e619 {
                                    phi_954_ = true;
                                } else {
                                    phi_954_ = _e617;
                                }
                                let _e621 = phi_954_;
                                phi_993_ = _e621;
                            } else {
                                let _e555 = local_24.member[0u];
                                let _e558 = local_25.member[0u];
                                if (_e555 == _e558) {
                                    phi_987_ = bool();
                                    phi_988_ = true;
                                } else {
                                    let _e562 = local_24.member[0u];
                                    let _e565 = local_25.member[1u];
                                    if (_e562 == _e565) {
                                        phi_985_ = bool();
                                        phi_986_ = true;
                                    } else {
                                        let _e569 = local_24.member[1u];
                                        let _e572 = local_25.member[0u];
                                        let _e573 = (_e569 == _e572);
                                        if _e573 {
                                            phi_984_ = bool();
                                        } else {
                                            let _e576 = local_24.member[1u];
                                            let _e579 = local_25.member[1u];
                                            phi_984_ = (_e576 == _e579);
                                        }
                                        let _e582 = phi_984_;
                                        phi_985_ = _e582;
                                        phi_986_ = _e573;
                                    }
                                    let _e584 = phi_985_;
                                    let _e586 = phi_986_;
                                    phi_987_ = _e584;
                                    phi_988_ = _e586;
                                }
                                let _e588 = phi_987_;
                                let _e590 = phi_988_;
                                if _e590 {
                                    phi_992_ = true;
                                } else {
                                    phi_992_ = _e588;
                                }
                                let _e592 = phi_992_;
                                phi_993_ = _e592;
                            }
                            let _e623 = phi_993_;
                            if _e623 {
                                phi_997_ = false;
                            } else {
                                phi_997_ = true;
                            }
                            let _e625 = phi_997_;
                            phi_998_ = _e625;
                        } else {
                            phi_998_ = true;
                        }
                        let _e627 = phi_998_;
                        if _e627 {
                            let _e629 = params.member.member_1;
                            if ((_e629 & 2u) != 0u) {
                                let _e634 = local_24.member[0u];
                                let _e636 = bodies.member[_e634];
                                let _e639 = local_25.member[0u];
                                let _e641 = bodies.member[_e639];
                                if ((_e636 / 2u) == (_e641 / 2u)) {
                                    let _e646 = params.member.member_1;
                                    phi_1044_ = !(((_e646 & 4u) != 0u));
                                } else {
                                    phi_1044_ = false;
                                }
                                let _e651 = phi_1044_;
                                if _e651 {
                                    phi_1055_ = true;
                                } else {
                                    if (((_e636 & _e641) & 1u) == 0u) {
                                        phi_1054_ = false;
                                    } else {
                                        phi_1054_ = true;
                                    }
                                    let _e656 = phi_1054_;
                                    phi_1055_ = _e656;
                                }
                                let _e658 = phi_1055_;
                                if _e658 {
                                    phi_1059_ = false;
                                } else {
                                    phi_1059_ = true;
                                }
                                let _e660 = phi_1059_;
                                phi_1060_ = _e660;
                            } else {
                                phi_1060_ = true;
                            }
                            let _e662 = phi_1060_;
                            if _e662 {
                                let _e664 = params.member.member_1;
                                if ((_e664 & 32u) != 0u) {
                                    let _e668 = params.member.member_6;
                                    let _e709 = (((((((_e543.member_1[0] - _e545.member[0]) > _e668) && ((_e545.member_1[0] - _e543.member[0]) > _e668)) && ((_e543.member_1[1] - _e545.member[1]) > _e668)) && ((_e545.member_1[1] - _e543.member[1]) > _e668)) && ((_e543.member_1[2] - _e545.member[2]) > _e668)) && ((_e545.member_1[2] - _e543.member[2]) > _e668));
                                    if _e709 {
                                        phi_1809_ = bool();
                                    } else {
                                        phi_1109_ = type_21(0u, 3u);
                                        phi_1112_ = true;
                                        loop {
                                            let _e713 = phi_1109_;
                                            let _e715 = phi_1112_;
                                            local_65 = _e715;
                                            if (_e713.member < _e713.member_1) {
                                                phi_1110_ = type_21((_e713.member + 1u), _e713.member_1);
                                                phi_1135_ = type_21(1u, _e713.member);
                                            } else {
                                                phi_1110_ = _e713;
                                                phi_1135_ = type_21(0u, type_21().member_1);
                                            }
                                            let _e727 = phi_1110_;
                                            let _e729 = phi_1135_;
                                            let _e733 = (bitcast<i32>(_e729.member) != 0i);
                                            if _e733 {
                                                let _e735 = local_24.member[0u];
                                                let _e737 = keys.member[_e735];
                                                local_22 = array<array<u32, 2>, 6>(array<u32, 2>(_e737[0][0], _e737[0][1]), array<u32, 2>(_e737[1][0], _e737[1][1]), array<u32, 2>(_e737[2][0], _e737[2][1]), array<u32, 2>(_e737[3][0], _e737[3][1]), array<u32, 2>(_e737[4][0], _e737[4][1]), array<u32, 2>(_e737[5][0], _e737[5][1]));
                                                let _e764 = local_22[_e729.member_1];
                                                phi_1192_ = type_21(1u, 3u);
                                                phi_1195_ = array<u32, 2>(_e764[0], _e764[1]);
                                                loop {
                                                    let _e769 = phi_1192_;
                                                    let _e771 = phi_1195_;
                                                    local_28 = _e771;
                                                    local_30 = _e771;
                                                    local_32 = _e771;
                                                    if (_e769.member < _e769.member_1) {
                                                        phi_1193_ = type_21((_e769.member + 1u), _e769.member_1);
                                                        phi_1218_ = type_21(1u, _e769.member);
                                                    } else {
                                                        phi_1193_ = _e769;
                                                        phi_1218_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e783 = phi_1193_;
                                                    let _e785 = phi_1218_;
                                                    let _e789 = (bitcast<i32>(_e785.member) != 0i);
                                                    if _e789 {
                                                        let _e791 = local_24.member[_e785.member_1];
                                                        let _e793 = keys.member[_e791];
                                                        local_23 = array<array<u32, 2>, 6>(array<u32, 2>(_e793[0][0], _e793[0][1]), array<u32, 2>(_e793[1][0], _e793[1][1]), array<u32, 2>(_e793[2][0], _e793[2][1]), array<u32, 2>(_e793[3][0], _e793[3][1]), array<u32, 2>(_e793[4][0], _e793[4][1]), array<u32, 2>(_e793[5][0], _e793[5][1]));
                                                        let _e820 = local_23[_e729.member_1];
                                                        if (_e771[1] > _e820[1]) {
                                                            phi_1294_ = true;
                                                        } else {
                                                            if (_e771[1] == _e820[1]) {
                                                                phi_1293_ = (_e771[0] > _e820[0]);
                                                            } else {
                                                                phi_1293_ = false;
                                                            }
                                                            let _e831 = phi_1293_;
                                                            phi_1294_ = _e831;
                                                        }
                                                        let _e833 = phi_1294_;
                                                        if _e833 {
                                                            phi_1298_ = array<u32, 2>(_e820[0], _e820[1]);
                                                        } else {
                                                            phi_1298_ = _e771;
                                                        }
                                                        let _e835 = phi_1298_;
                                                        phi_1196_ = _e835;
                                                    } else {
                                                        phi_1196_ = array<u32, 2>();
                                                    }
                                                    let _e837 = phi_1196_;
                                                    continue;
                                                    continuing {
                                                        phi_1192_ = _e783;
                                                        phi_1195_ = _e837;
                                                        break if !(_e789);
                                                    }
                                                }
                                                let _e840 = local_25.member[0u];
                                                let _e842 = keys.member[_e840];
                                                local_20 = array<array<u32, 2>, 6>(array<u32, 2>(_e842[0][0], _e842[0][1]), array<u32, 2>(_e842[1][0], _e842[1][1]), array<u32, 2>(_e842[2][0], _e842[2][1]), array<u32, 2>(_e842[3][0], _e842[3][1]), array<u32, 2>(_e842[4][0], _e842[4][1]), array<u32, 2>(_e842[5][0], _e842[5][1]));
                                                let _e870 = local_20[(3u + _e729.member_1)];
                                                phi_1349_ = type_21(1u, 3u);
                                                phi_1352_ = array<u32, 2>(_e870[0], _e870[1]);
                                                loop {
                                                    let _e875 = phi_1349_;
                                                    let _e877 = phi_1352_;
                                                    local_29 = _e877;
                                                    local_31 = _e877;
                                                    local_33 = _e877;
                                                    if (_e875.member < _e875.member_1) {
                                                        phi_1350_ = type_21((_e875.member + 1u), _e875.member_1);
                                                        phi_1375_ = type_21(1u, _e875.member);
                                                    } else {
                                                        phi_1350_ = _e875;
                                                        phi_1375_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e889 = phi_1350_;
                                                    let _e891 = phi_1375_;
                                                    let _e895 = (bitcast<i32>(_e891.member) != 0i);
                                                    if _e895 {
                                                        let _e897 = local_25.member[_e891.member_1];
                                                        let _e899 = keys.member[_e897];
                                                        local_21 = array<array<u32, 2>, 6>(array<u32, 2>(_e899[0][0], _e899[0][1]), array<u32, 2>(_e899[1][0], _e899[1][1]), array<u32, 2>(_e899[2][0], _e899[2][1]), array<u32, 2>(_e899[3][0], _e899[3][1]), array<u32, 2>(_e899[4][0], _e899[4][1]), array<u32, 2>(_e899[5][0], _e899[5][1]));
                                                        let _e927 = local_21[(3u + _e729.member_1)];
                                                        if (_e927[1] > _e877[1]) {
                                                            phi_1452_ = true;
                                                        } else {
                                                            if (_e927[1] == _e877[1]) {
                                                                phi_1451_ = (_e927[0] > _e877[0]);
                                                            } else {
                                                                phi_1451_ = false;
                                                            }
                                                            let _e938 = phi_1451_;
                                                            phi_1452_ = _e938;
                                                        }
                                                        let _e940 = phi_1452_;
                                                        if _e940 {
                                                            phi_1456_ = array<u32, 2>(_e927[0], _e927[1]);
                                                        } else {
                                                            phi_1456_ = _e877;
                                                        }
                                                        let _e942 = phi_1456_;
                                                        phi_1353_ = _e942;
                                                    } else {
                                                        phi_1353_ = array<u32, 2>();
                                                    }
                                                    let _e944 = phi_1353_;
                                                    continue;
                                                    continuing {
                                                        phi_1349_ = _e889;
                                                        phi_1352_ = _e944;
                                                        break if !(_e895);
                                                    }
                                                }
                                                let _e947 = local_28;
                                                let _e950 = local_29;
                                                if (_e947[1] > _e950[1]) {
                                                    phi_1473_ = true;
                                                } else {
                                                    let _e954 = local_30;
                                                    let _e957 = local_31;
                                                    if (_e954[1] == _e957[1]) {
                                                        let _e961 = local_32;
                                                        let _e964 = local_33;
                                                        phi_1472_ = (_e961[0] > _e964[0]);
                                                    } else {
                                                        phi_1472_ = false;
                                                    }
                                                    let _e968 = phi_1472_;
                                                    phi_1473_ = _e968;
                                                }
                                                let _e970 = phi_1473_;
                                                let _e973 = local_25.member[0u];
                                                let _e975 = keys.member[_e973];
                                                local_18 = array<array<u32, 2>, 6>(array<u32, 2>(_e975[0][0], _e975[0][1]), array<u32, 2>(_e975[1][0], _e975[1][1]), array<u32, 2>(_e975[2][0], _e975[2][1]), array<u32, 2>(_e975[3][0], _e975[3][1]), array<u32, 2>(_e975[4][0], _e975[4][1]), array<u32, 2>(_e975[5][0], _e975[5][1]));
                                                let _e1002 = local_18[_e729.member_1];
                                                phi_1524_ = type_21(1u, 3u);
                                                phi_1527_ = array<u32, 2>(_e1002[0], _e1002[1]);
                                                loop {
                                                    let _e1007 = phi_1524_;
                                                    let _e1009 = phi_1527_;
                                                    local_34 = _e1009;
                                                    local_36 = _e1009;
                                                    local_38 = _e1009;
                                                    if (_e1007.member < _e1007.member_1) {
                                                        phi_1525_ = type_21((_e1007.member + 1u), _e1007.member_1);
                                                        phi_1550_ = type_21(1u, _e1007.member);
                                                    } else {
                                                        phi_1525_ = _e1007;
                                                        phi_1550_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1021 = phi_1525_;
                                                    let _e1023 = phi_1550_;
                                                    let _e1027 = (bitcast<i32>(_e1023.member) != 0i);
                                                    if _e1027 {
                                                        let _e1029 = local_25.member[_e1023.member_1];
                                                        let _e1031 = keys.member[_e1029];
                                                        local_19 = array<array<u32, 2>, 6>(array<u32, 2>(_e1031[0][0], _e1031[0][1]), array<u32, 2>(_e1031[1][0], _e1031[1][1]), array<u32, 2>(_e1031[2][0], _e1031[2][1]), array<u32, 2>(_e1031[3][0], _e1031[3][1]), array<u32, 2>(_e1031[4][0], _e1031[4][1]), array<u32, 2>(_e1031[5][0], _e1031[5][1]));
                                                        let _e1058 = local_19[_e729.member_1];
                                                        if (_e1009[1] > _e1058[1]) {
                                                            phi_1626_ = true;
                                                        } else {
                                                            if (_e1009[1] == _e1058[1]) {
                                                                phi_1625_ = (_e1009[0] > _e1058[0]);
                                                            } else {
                                                                phi_1625_ = false;
                                                            }
                                                            let _e1069 = phi_1625_;
                                                            phi_1626_ = _e1069;
                                                        }
                                                        let _e1071 = phi_1626_;
                                                        if _e1071 {
                                                            phi_1630_ = array<u32, 2>(_e1058[0], _e1058[1]);
                                                        } else {
                                                            phi_1630_ = _e1009;
                                                        }
                                                        let _e1073 = phi_1630_;
                                                        phi_1528_ = _e1073;
                                                    } else {
                                                        phi_1528_ = array<u32, 2>();
                                                    }
                                                    let _e1075 = phi_1528_;
                                                    continue;
                                                    continuing {
                                                        phi_1524_ = _e1021;
                                                        phi_1527_ = _e1075;
                                                        break if !(_e1027);
                                                    }
                                                }
                                                let _e1078 = local_24.member[0u];
                                                let _e1080 = keys.member[_e1078];
                                                local_16 = array<array<u32, 2>, 6>(array<u32, 2>(_e1080[0][0], _e1080[0][1]), array<u32, 2>(_e1080[1][0], _e1080[1][1]), array<u32, 2>(_e1080[2][0], _e1080[2][1]), array<u32, 2>(_e1080[3][0], _e1080[3][1]), array<u32, 2>(_e1080[4][0], _e1080[4][1]), array<u32, 2>(_e1080[5][0], _e1080[5][1]));
                                                let _e1108 = local_16[(3u + _e729.member_1)];
                                                phi_1681_ = type_21(1u, 3u);
                                                phi_1684_ = array<u32, 2>(_e1108[0], _e1108[1]);
                                                loop {
                                                    let _e1113 = phi_1681_;
                                                    let _e1115 = phi_1684_;
                                                    local_35 = _e1115;
                                                    local_37 = _e1115;
                                                    local_39 = _e1115;
                                                    if (_e1113.member < _e1113.member_1) {
                                                        phi_1682_ = type_21((_e1113.member + 1u), _e1113.member_1);
                                                        phi_1707_ = type_21(1u, _e1113.member);
                                                    } else {
                                                        phi_1682_ = _e1113;
                                                        phi_1707_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1127 = phi_1682_;
                                                    let _e1129 = phi_1707_;
                                                    let _e1133 = (bitcast<i32>(_e1129.member) != 0i);
                                                    if _e1133 {
                                                        let _e1135 = local_24.member[_e1129.member_1];
                                                        let _e1137 = keys.member[_e1135];
                                                        local_17 = array<array<u32, 2>, 6>(array<u32, 2>(_e1137[0][0], _e1137[0][1]), array<u32, 2>(_e1137[1][0], _e1137[1][1]), array<u32, 2>(_e1137[2][0], _e1137[2][1]), array<u32, 2>(_e1137[3][0], _e1137[3][1]), array<u32, 2>(_e1137[4][0], _e1137[4][1]), array<u32, 2>(_e1137[5][0], _e1137[5][1]));
                                                        let _e1165 = local_17[(3u + _e729.member_1)];
                                                        if (_e1165[1] > _e1115[1]) {
                                                            phi_1784_ = true;
                                                        } else {
                                                            if (_e1165[1] == _e1115[1]) {
                                                                phi_1783_ = (_e1165[0] > _e1115[0]);
                                                            } else {
                                                                phi_1783_ = false;
                                                            }
                                                            let _e1176 = phi_1783_;
                                                            phi_1784_ = _e1176;
                                                        }
                                                        let _e1178 = phi_1784_;
                                                        if _e1178 {
                                                            phi_1788_ = array<u32, 2>(_e1165[0], _e1165[1]);
                                                        } else {
                                                            phi_1788_ = _e1115;
                                                        }
                                                        let _e1180 = phi_1788_;
                                                        phi_1685_ = _e1180;
                                                    } else {
                                                        phi_1685_ = array<u32, 2>();
                                                    }
                                                    let _e1182 = phi_1685_;
                                                    continue;
                                                    continuing {
                                                        phi_1681_ = _e1127;
                                                        phi_1684_ = _e1182;
                                                        break if !(_e1133);
                                                    }
                                                }
                                                let _e1185 = local_34;
                                                let _e1188 = local_35;
                                                if (_e1185[1] > _e1188[1]) {
                                                    phi_1805_ = true;
                                                } else {
                                                    let _e1192 = local_36;
                                                    let _e1195 = local_37;
                                                    if (_e1192[1] == _e1195[1]) {
                                                        let _e1199 = local_38;
                                                        let _e1202 = local_39;
                                                        phi_1804_ = (_e1199[0] > _e1202[0]);
                                                    } else {
                                                        phi_1804_ = false;
                                                    }
                                                    let _e1206 = phi_1804_;
                                                    phi_1805_ = _e1206;
                                                }
                                                let _e1208 = phi_1805_;
                                                phi_1113_ = (_e715 && (!(_e970) && !(_e1208)));
                                            } else {
                                                phi_1113_ = bool();
                                            }
                                            let _e1213 = phi_1113_;
                                            continue;
                                            continuing {
                                                phi_1109_ = _e727;
                                                phi_1112_ = _e1213;
                                                break if !(_e733);
                                            }
                                        }
                                        let _e5240 = local_65;
                                        phi_1809_ = _e5240;
                                    }
                                    let _e1216 = phi_1809_;
                                    phi_1810_ = _e1216;
                                    phi_1811_ = _e709;
                                } else {
                                    phi_1810_ = bool();
                                    phi_1811_ = true;
                                }
                                let _e1218 = phi_1810_;
                                let _e1220 = phi_1811_;
                                if _e1220 {
                                    phi_1815_ = false;
                                } else {
                                    phi_1815_ = true;
                                }
                                let _e1222 = phi_1815_;
                                phi_1816_ = _e1218;
                                phi_1817_ = _e1222;
                            } else {
                                phi_1816_ = false;
                                phi_1817_ = true;
                            }
                            let _e1224 = phi_1816_;
                            let _e1226 = phi_1817_;
                            phi_1818_ = _e1224;
                            phi_1819_ = _e1226;
                        } else {
                            phi_1818_ = false;
                            phi_1819_ = true;
                        }
                        let _e1228 = phi_1818_;
                        let _e1230 = phi_1819_;
                        if _e1230 {
                            phi_1823_ = _e1228;
                        } else {
                            phi_1823_ = true;
                        }
                        let _e1232 = phi_1823_;
                        if _e1232 {
                            let _e1234 = params.member.member_16;
                            let _e1236 = local_24.member_1;
                            let _e1238 = local_25.member_1;
                            if (_e1236 < _e1238) {
                                phi_1843_ = type_21(_e1236, _e1238);
                            } else {
                                phi_1843_ = type_21(_e1238, _e1236);
                            }
                            let _e1243 = phi_1843_;
                            let _e1247 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1247 + 1u) < _e1247) {
                                let _e1251 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1247 < _e1234) {
                                atomicStore((&output.member[(4u + (2u * _e1247))]), _e1243.member);
                                atomicStore((&output.member[((2u * _e1247) + 5u)]), _e1243.member_1);
                            }
                            let _e1260 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1260 + 1u) < _e1260) {
                                let _e1264 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1888_ = (_e494 & (_e494 - 1u));
                        phi_1889_ = true;
                    }
                    let _e1266 = phi_1888_;
                    let _e1268 = phi_1889_;
                    phi_816_ = _e1266;
                    phi_1890_ = _e1268;
                } else {
                    phi_816_ = u32();
                    phi_1890_ = false;
                }
                let _e1270 = phi_816_;
                let _e1272 = phi_1890_;
                continue;
                continuing {
                    phi_812_ = _e506;
                    phi_815_ = _e1270;
                    break if !(_e1272);
                }
            }
            workgroupBarrier();
            let _e1275 = atomicLoad((&counters[4u]));
            if (2048u < _e1275) {
                phi_1897_ = 2048u;
            } else {
                phi_1897_ = _e1275;
            }
            let _e1278 = phi_1897_;
            phi_1900_ = type_21(0u, 16u);
            loop {
                let _e1280 = phi_1900_;
                if (_e1280.member < _e1280.member_1) {
                    phi_1901_ = type_21((_e1280.member + 1u), _e1280.member_1);
                    phi_1924_ = type_21(1u, _e1280.member);
                } else {
                    phi_1901_ = _e1280;
                    phi_1924_ = type_21(0u, type_21().member_1);
                }
                let _e1292 = phi_1901_;
                let _e1294 = phi_1924_;
                if (bitcast<i32>(_e1294.member) != 0i) {
                    let _e1300 = (_e97 + (_e1294.member_1 * 128u));
                    if (_e1300 >= _e1278) {
                        phi_8164_ = false;
                    } else {
                        let _e1303 = hits[_e1300];
                        let _e1306 = ((_e1303 >> bitcast<u32>(10i)) & 3u);
                        let _e1313 = firsts[(2u * _e1306)];
                        let _e1314 = (_e1313 + ((_e1303 >> bitcast<u32>(5i)) & 31u));
                        let _e1318 = firsts[((2u * _e1306) + 1u)];
                        let _e1319 = (_e1318 + (_e1303 & 31u));
                        let _e1321 = leaves.member[_e1314];
                        let _e1323 = leaves.member[_e1319];
                        local_26 = type_16(array<u32, 3>(_e1321.member[0], _e1321.member[1], _e1321.member[2]), _e1321.member_1);
                        local_27 = type_16(array<u32, 3>(_e1323.member[0], _e1323.member[1], _e1323.member[2]), _e1323.member_1);
                        let _e1339 = nodes.member[_e1314];
                        let _e1341 = nodes.member[_e1319];
                        let _e1343 = params.member.member_1;
                        if ((_e1343 & 1u) != 0u) {
                            let _e1347 = params.member.member_8;
                            if (_e1347 == 0u) {
                                let _e1391 = local_26.member[0u];
                                let _e1394 = local_27.member[0u];
                                if (_e1391 == _e1394) {
                                    phi_2043_ = bool();
                                    phi_2044_ = true;
                                } else {
                                    let _e1398 = local_26.member[0u];
                                    let _e1401 = local_27.member[1u];
                                    let _e1402 = (_e1398 == _e1401);
                                    if _e1402 {
                                        phi_2042_ = bool();
                                    } else {
                                        let _e1405 = local_26.member[0u];
                                        let _e1408 = local_27.member[2u];
                                        phi_2042_ = (_e1405 == _e1408);
                                    }
                                    let _e1411 = phi_2042_;
                                    phi_2043_ = _e1411;
                                    phi_2044_ = _e1402;
                                }
                                let _e1413 = phi_2043_;
                                let _e1415 = phi_2044_;
                                if _e1415 {
                                    phi_2048_ = true;
                                } else {
                                    phi_2048_ = _e1413;
                                }
                                let _e1417 = phi_2048_;
                                phi_2087_ = _e1417;
                            } else {
                                let _e1351 = local_26.member[0u];
                                let _e1354 = local_27.member[0u];
                                if (_e1351 == _e1354) {
                                    phi_2081_ = bool();
                                    phi_2082_ = true;
                                } else {
                                    let _e1358 = local_26.member[0u];
                                    let _e1361 = local_27.member[1u];
                                    if (_e1358 == _e1361) {
                                        phi_2079_ = bool();
                                        phi_2080_ = true;
                                    } else {
                                        let _e1365 = local_26.member[1u];
                                        let _e1368 = local_27.member[0u];
                                        let _e1369 = (_e1365 == _e1368);
                                        if _e1369 {
                                            phi_2078_ = bool();
                                        } else {
                                            let _e1372 = local_26.member[1u];
                                            let _e1375 = local_27.member[1u];
                                            phi_2078_ = (_e1372 == _e1375);
                                        }
                                        let _e1378 = phi_2078_;
                                        phi_2079_ = _e1378;
                                        phi_2080_ = _e1369;
                                    }
                                    let _e1380 = phi_2079_;
                                    let _e1382 = phi_2080_;
                                    phi_2081_ = _e1380;
                                    phi_2082_ = _e1382;
                                }
                                let _e1384 = phi_2081_;
                                let _e1386 = phi_2082_;
                                if _e1386 {
                                    phi_2086_ = true;
                                } else {
                                    phi_2086_ = _e1384;
                                }
                                let _e1388 = phi_2086_;
                                phi_2087_ = _e1388;
                            }
                            let _e1419 = phi_2087_;
                            if _e1419 {
                                phi_2091_ = false;
                            } else {
                                phi_2091_ = true;
                            }
                            let _e1421 = phi_2091_;
                            phi_2092_ = _e1421;
                        } else {
                            phi_2092_ = true;
                        }
                        let _e1423 = phi_2092_;
                        if _e1423 {
                            let _e1425 = params.member.member_1;
                            if ((_e1425 & 2u) != 0u) {
                                let _e1430 = local_26.member[0u];
                                let _e1432 = bodies.member[_e1430];
                                let _e1435 = local_27.member[0u];
                                let _e1437 = bodies.member[_e1435];
                                if ((_e1432 / 2u) == (_e1437 / 2u)) {
                                    let _e1442 = params.member.member_1;
                                    phi_2138_ = !(((_e1442 & 4u) != 0u));
                                } else {
                                    phi_2138_ = false;
                                }
                                let _e1447 = phi_2138_;
                                if _e1447 {
                                    phi_2149_ = true;
                                } else {
                                    if (((_e1432 & _e1437) & 1u) == 0u) {
                                        phi_2148_ = false;
                                    } else {
                                        phi_2148_ = true;
                                    }
                                    let _e1452 = phi_2148_;
                                    phi_2149_ = _e1452;
                                }
                                let _e1454 = phi_2149_;
                                if _e1454 {
                                    phi_2153_ = false;
                                } else {
                                    phi_2153_ = true;
                                }
                                let _e1456 = phi_2153_;
                                phi_2154_ = _e1456;
                            } else {
                                phi_2154_ = true;
                            }
                            let _e1458 = phi_2154_;
                            if _e1458 {
                                let _e1460 = params.member.member_1;
                                if ((_e1460 & 32u) != 0u) {
                                    let _e1464 = params.member.member_6;
                                    let _e1505 = (((((((_e1339.member_1[0] - _e1341.member[0]) > _e1464) && ((_e1341.member_1[0] - _e1339.member[0]) > _e1464)) && ((_e1339.member_1[1] - _e1341.member[1]) > _e1464)) && ((_e1341.member_1[1] - _e1339.member[1]) > _e1464)) && ((_e1339.member_1[2] - _e1341.member[2]) > _e1464)) && ((_e1341.member_1[2] - _e1339.member[2]) > _e1464));
                                    if _e1505 {
                                        phi_2903_ = bool();
                                    } else {
                                        phi_2203_ = type_21(0u, 3u);
                                        phi_2206_ = true;
                                        loop {
                                            let _e1509 = phi_2203_;
                                            let _e1511 = phi_2206_;
                                            local_66 = _e1511;
                                            if (_e1509.member < _e1509.member_1) {
                                                phi_2204_ = type_21((_e1509.member + 1u), _e1509.member_1);
                                                phi_2229_ = type_21(1u, _e1509.member);
                                            } else {
                                                phi_2204_ = _e1509;
                                                phi_2229_ = type_21(0u, type_21().member_1);
                                            }
                                            let _e1523 = phi_2204_;
                                            let _e1525 = phi_2229_;
                                            let _e1529 = (bitcast<i32>(_e1525.member) != 0i);
                                            if _e1529 {
                                                let _e1531 = local_26.member[0u];
                                                let _e1533 = keys.member[_e1531];
                                                local_14 = array<array<u32, 2>, 6>(array<u32, 2>(_e1533[0][0], _e1533[0][1]), array<u32, 2>(_e1533[1][0], _e1533[1][1]), array<u32, 2>(_e1533[2][0], _e1533[2][1]), array<u32, 2>(_e1533[3][0], _e1533[3][1]), array<u32, 2>(_e1533[4][0], _e1533[4][1]), array<u32, 2>(_e1533[5][0], _e1533[5][1]));
                                                let _e1560 = local_14[_e1525.member_1];
                                                phi_2286_ = type_21(1u, 3u);
                                                phi_2289_ = array<u32, 2>(_e1560[0], _e1560[1]);
                                                loop {
                                                    let _e1565 = phi_2286_;
                                                    let _e1567 = phi_2289_;
                                                    local_40 = _e1567;
                                                    local_42 = _e1567;
                                                    local_44 = _e1567;
                                                    if (_e1565.member < _e1565.member_1) {
                                                        phi_2287_ = type_21((_e1565.member + 1u), _e1565.member_1);
                                                        phi_2312_ = type_21(1u, _e1565.member);
                                                    } else {
                                                        phi_2287_ = _e1565;
                                                        phi_2312_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1579 = phi_2287_;
                                                    let _e1581 = phi_2312_;
                                                    let _e1585 = (bitcast<i32>(_e1581.member) != 0i);
                                                    if _e1585 {
                                                        let _e1587 = local_26.member[_e1581.member_1];
                                                        let _e1589 = keys.member[_e1587];
                                                        local_15 = array<array<u32, 2>, 6>(array<u32, 2>(_e1589[0][0], _e1589[0][1]), array<u32, 2>(_e1589[1][0], _e1589[1][1]), array<u32, 2>(_e1589[2][0], _e1589[2][1]), array<u32, 2>(_e1589[3][0], _e1589[3][1]), array<u32, 2>(_e1589[4][0], _e1589[4][1]), array<u32, 2>(_e1589[5][0], _e1589[5][1]));
                                                        let _e1616 = local_15[_e1525.member_1];
                                                        if (_e1567[1] > _e1616[1]) {
                                                            phi_2388_ = true;
                                                        } else {
                                                            if (_e1567[1] == _e1616[1]) {
                                                                phi_2387_ = (_e1567[0] > _e1616[0]);
                                                            } else {
                                                                phi_2387_ = false;
                                                            }
                                                            let _e1627 = phi_2387_;
                                                            phi_2388_ = _e1627;
                                                        }
                                                        let _e1629 = phi_2388_;
                                                        if _e1629 {
                                                            phi_2392_ = array<u32, 2>(_e1616[0], _e1616[1]);
                                                        } else {
                                                            phi_2392_ = _e1567;
                                                        }
                                                        let _e1631 = phi_2392_;
                                                        phi_2290_ = _e1631;
                                                    } else {
                                                        phi_2290_ = array<u32, 2>();
                                                    }
                                                    let _e1633 = phi_2290_;
                                                    continue;
                                                    continuing {
                                                        phi_2286_ = _e1579;
                                                        phi_2289_ = _e1633;
                                                        break if !(_e1585);
                                                    }
                                                }
                                                let _e1636 = local_27.member[0u];
                                                let _e1638 = keys.member[_e1636];
                                                local_12 = array<array<u32, 2>, 6>(array<u32, 2>(_e1638[0][0], _e1638[0][1]), array<u32, 2>(_e1638[1][0], _e1638[1][1]), array<u32, 2>(_e1638[2][0], _e1638[2][1]), array<u32, 2>(_e1638[3][0], _e1638[3][1]), array<u32, 2>(_e1638[4][0], _e1638[4][1]), array<u32, 2>(_e1638[5][0], _e1638[5][1]));
                                                let _e1666 = local_12[(3u + _e1525.member_1)];
                                                phi_2443_ = type_21(1u, 3u);
                                                phi_2446_ = array<u32, 2>(_e1666[0], _e1666[1]);
                                                loop {
                                                    let _e1671 = phi_2443_;
                                                    let _e1673 = phi_2446_;
                                                    local_41 = _e1673;
                                                    local_43 = _e1673;
                                                    local_45 = _e1673;
                                                    if (_e1671.member < _e1671.member_1) {
                                                        phi_2444_ = type_21((_e1671.member + 1u), _e1671.member_1);
                                                        phi_2469_ = type_21(1u, _e1671.member);
                                                    } else {
                                                        phi_2444_ = _e1671;
                                                        phi_2469_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1685 = phi_2444_;
                                                    let _e1687 = phi_2469_;
                                                    let _e1691 = (bitcast<i32>(_e1687.member) != 0i);
                                                    if _e1691 {
                                                        let _e1693 = local_27.member[_e1687.member_1];
                                                        let _e1695 = keys.member[_e1693];
                                                        local_13 = array<array<u32, 2>, 6>(array<u32, 2>(_e1695[0][0], _e1695[0][1]), array<u32, 2>(_e1695[1][0], _e1695[1][1]), array<u32, 2>(_e1695[2][0], _e1695[2][1]), array<u32, 2>(_e1695[3][0], _e1695[3][1]), array<u32, 2>(_e1695[4][0], _e1695[4][1]), array<u32, 2>(_e1695[5][0], _e1695[5][1]));
                                                        let _e1723 = local_13[(3u + _e1525.member_1)];
                                                        if (_e1723[1] > _e1673[1]) {
                                                            phi_2546_ = true;
                                                        } else {
                                                            if (_e1723[1] == _e1673[1]) {
                                                                phi_2545_ = (_e1723[0] > _e1673[0]);
                                                            } else {
                                                                phi_2545_ = false;
                                                            }
                                                            let _e1734 = phi_2545_;
                                                            phi_2546_ = _e1734;
                                                        }
                                                        let _e1736 = phi_2546_;
                                                        if _e1736 {
                                                            phi_2550_ = array<u32, 2>(_e1723[0], _e1723[1]);
                                                        } else {
                                                            phi_2550_ = _e1673;
                                                        }
                                                        let _e1738 = phi_2550_;
                                                        phi_2447_ = _e1738;
                                                    } else {
                                                        phi_2447_ = array<u32, 2>();
                                                    }
                                                    let _e1740 = phi_2447_;
                                                    continue;
                                                    continuing {
                                                        phi_2443_ = _e1685;
                                                        phi_2446_ = _e1740;
                                                        break if !(_e1691);
                                                    }
                                                }
                                                let _e1743 = local_40;
                                                let _e1746 = local_41;
                                                if (_e1743[1] > _e1746[1]) {
                                                    phi_2567_ = true;
                                                } else {
                                                    let _e1750 = local_42;
                                                    let _e1753 = local_43;
                                                    if (_e1750[1] == _e1753[1]) {
                                                        let _e1757 = local_44;
                                                        let _e1760 = local_45;
                                                        phi_2566_ = (_e1757[0] > _e1760[0]);
                                                    } else {
                                                        phi_2566_ = false;
                                                    }
                                                    let _e1764 = phi_2566_;
                                                    phi_2567_ = _e1764;
                                                }
                                                let _e1766 = phi_2567_;
                                                let _e1769 = local_27.member[0u];
                                                let _e1771 = keys.member[_e1769];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e1771[0][0], _e1771[0][1]), array<u32, 2>(_e1771[1][0], _e1771[1][1]), array<u32, 2>(_e1771[2][0], _e1771[2][1]), array<u32, 2>(_e1771[3][0], _e1771[3][1]), array<u32, 2>(_e1771[4][0], _e1771[4][1]), array<u32, 2>(_e1771[5][0], _e1771[5][1]));
                                                let _e1798 = local_10[_e1525.member_1];
                                                phi_2618_ = type_21(1u, 3u);
                                                phi_2621_ = array<u32, 2>(_e1798[0], _e1798[1]);
                                                loop {
                                                    let _e1803 = phi_2618_;
                                                    let _e1805 = phi_2621_;
                                                    local_46 = _e1805;
                                                    local_48 = _e1805;
                                                    local_50 = _e1805;
                                                    if (_e1803.member < _e1803.member_1) {
                                                        phi_2619_ = type_21((_e1803.member + 1u), _e1803.member_1);
                                                        phi_2644_ = type_21(1u, _e1803.member);
                                                    } else {
                                                        phi_2619_ = _e1803;
                                                        phi_2644_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1817 = phi_2619_;
                                                    let _e1819 = phi_2644_;
                                                    let _e1823 = (bitcast<i32>(_e1819.member) != 0i);
                                                    if _e1823 {
                                                        let _e1825 = local_27.member[_e1819.member_1];
                                                        let _e1827 = keys.member[_e1825];
                                                        local_11 = array<array<u32, 2>, 6>(array<u32, 2>(_e1827[0][0], _e1827[0][1]), array<u32, 2>(_e1827[1][0], _e1827[1][1]), array<u32, 2>(_e1827[2][0], _e1827[2][1]), array<u32, 2>(_e1827[3][0], _e1827[3][1]), array<u32, 2>(_e1827[4][0], _e1827[4][1]), array<u32, 2>(_e1827[5][0], _e1827[5][1]));
                                                        let _e1854 = local_11[_e1525.member_1];
                                                        if (_e1805[1] > _e1854[1]) {
                                                            phi_2720_ = true;
                                                        } else {
                                                            if (_e1805[1] == _e1854[1]) {
                                                                phi_2719_ = (_e1805[0] > _e1854[0]);
                                                            } else {
                                                                phi_2719_ = false;
                                                            }
                                                            let _e1865 = phi_2719_;
                                                            phi_2720_ = _e1865;
                                                        }
                                                        let _e1867 = phi_2720_;
                                                        if _e1867 {
                                                            phi_2724_ = array<u32, 2>(_e1854[0], _e1854[1]);
                                                        } else {
                                                            phi_2724_ = _e1805;
                                                        }
                                                        let _e1869 = phi_2724_;
                                                        phi_2622_ = _e1869;
                                                    } else {
                                                        phi_2622_ = array<u32, 2>();
                                                    }
                                                    let _e1871 = phi_2622_;
                                                    continue;
                                                    continuing {
                                                        phi_2618_ = _e1817;
                                                        phi_2621_ = _e1871;
                                                        break if !(_e1823);
                                                    }
                                                }
                                                let _e1874 = local_26.member[0u];
                                                let _e1876 = keys.member[_e1874];
                                                local_8 = array<array<u32, 2>, 6>(array<u32, 2>(_e1876[0][0], _e1876[0][1]), array<u32, 2>(_e1876[1][0], _e1876[1][1]), array<u32, 2>(_e1876[2][0], _e1876[2][1]), array<u32, 2>(_e1876[3][0], _e1876[3][1]), array<u32, 2>(_e1876[4][0], _e1876[4][1]), array<u32, 2>(_e1876[5][0], _e1876[5][1]));
                                                let _e1904 = local_8[(3u + _e1525.member_1)];
                                                phi_2775_ = type_21(1u, 3u);
                                                phi_2778_ = array<u32, 2>(_e1904[0], _e1904[1]);
                                                loop {
                                                    let _e1909 = phi_2775_;
                                                    let _e1911 = phi_2778_;
                                                    local_47 = _e1911;
                                                    local_49 = _e1911;
                                                    local_51 = _e1911;
                                                    if (_e1909.member < _e1909.member_1) {
                                                        phi_2776_ = type_21((_e1909.member + 1u), _e1909.member_1);
                                                        phi_2801_ = type_21(1u, _e1909.member);
                                                    } else {
                                                        phi_2776_ = _e1909;
                                                        phi_2801_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1923 = phi_2776_;
                                                    let _e1925 = phi_2801_;
                                                    let _e1929 = (bitcast<i32>(_e1925.member) != 0i);
                                                    if _e1929 {
                                                        let _e1931 = local_26.member[_e1925.member_1];
                                                        let _e1933 = keys.member[_e1931];
                                                        local_9 = array<array<u32, 2>, 6>(array<u32, 2>(_e1933[0][0], _e1933[0][1]), array<u32, 2>(_e1933[1][0], _e1933[1][1]), array<u32, 2>(_e1933[2][0], _e1933[2][1]), array<u32, 2>(_e1933[3][0], _e1933[3][1]), array<u32, 2>(_e1933[4][0], _e1933[4][1]), array<u32, 2>(_e1933[5][0], _e1933[5][1]));
                                                        let _e1961 = local_9[(3u + _e1525.member_1)];
                                                        if (_e1961[1] > _e1911[1]) {
                                                            phi_2878_ = true;
                                                        } else {
                                                            if (_e1961[1] == _e1911[1]) {
                                                                phi_2877_ = (_e1961[0] > _e1911[0]);
                                                            } else {
                                                                phi_2877_ = false;
                                                            }
                                                            let _e1972 = phi_2877_;
                                                            phi_2878_ = _e1972;
                                                        }
                                                        let _e1974 = phi_2878_;
                                                        if _e1974 {
                                                            phi_2882_ = array<u32, 2>(_e1961[0], _e1961[1]);
                                                        } else {
                                                            phi_2882_ = _e1911;
                                                        }
                                                        let _e1976 = phi_2882_;
                                                        phi_2779_ = _e1976;
                                                    } else {
                                                        phi_2779_ = array<u32, 2>();
                                                    }
                                                    let _e1978 = phi_2779_;
                                                    continue;
                                                    continuing {
                                                        phi_2775_ = _e1923;
                                                        phi_2778_ = _e1978;
                                                        break if !(_e1929);
                                                    }
                                                }
                                                let _e1981 = local_46;
                                                let _e1984 = local_47;
                                                if (_e1981[1] > _e1984[1]) {
                                                    phi_2899_ = true;
                                                } else {
                                                    let _e1988 = local_48;
                                                    let _e1991 = local_49;
                                                    if (_e1988[1] == _e1991[1]) {
                                                        let _e1995 = local_50;
                                                        let _e1998 = local_51;
                                                        phi_2898_ = (_e1995[0] > _e1998[0]);
                                                    } else {
                                                        phi_2898_ = false;
                                                    }
                                                    let _e2002 = phi_2898_;
                                                    phi_2899_ = _e2002;
                                                }
                                                let _e2004 = phi_2899_;
                                                phi_2207_ = (_e1511 && (!(_e1766) && !(_e2004)));
                                            } else {
                                                phi_2207_ = bool();
                                            }
                                            let _e2009 = phi_2207_;
                                            continue;
                                            continuing {
                                                phi_2203_ = _e1523;
                                                phi_2206_ = _e2009;
                                                break if !(_e1529);
                                            }
                                        }
                                        let _e5331 = local_66;
                                        phi_2903_ = _e5331;
                                    }
                                    let _e2012 = phi_2903_;
                                    phi_2904_ = _e2012;
                                    phi_2905_ = _e1505;
                                } else {
                                    phi_2904_ = bool();
                                    phi_2905_ = true;
                                }
                                let _e2014 = phi_2904_;
                                let _e2016 = phi_2905_;
                                if _e2016 {
                                    phi_2909_ = false;
                                } else {
                                    phi_2909_ = true;
                                }
                                let _e2018 = phi_2909_;
                                phi_2910_ = _e2014;
                                phi_2911_ = _e2018;
                            } else {
                                phi_2910_ = false;
                                phi_2911_ = true;
                            }
                            let _e2020 = phi_2910_;
                            let _e2022 = phi_2911_;
                            phi_2912_ = _e2020;
                            phi_2913_ = _e2022;
                        } else {
                            phi_2912_ = false;
                            phi_2913_ = true;
                        }
                        let _e2024 = phi_2912_;
                        let _e2026 = phi_2913_;
                        if _e2026 {
                            phi_2917_ = _e2024;
                        } else {
                            phi_2917_ = true;
                        }
                        let _e2028 = phi_2917_;
                        if _e2028 {
                            let _e2030 = atomicAdd((&counters[7u]), 1u);
                            let _e2032 = local_26.member_1;
                            let _e2034 = local_27.member_1;
                            if (_e2032 < _e2034) {
                                phi_2963_ = _e1323;
                                phi_2964_ = _e1321;
                            } else {
                                phi_2963_ = _e1321;
                                phi_2964_ = _e1323;
                            }
                            let _e2037 = phi_2963_;
                            let _e2039 = phi_2964_;
                            let _e2041 = params.member.member_4;
                            let _e2043 = params.member.member_5;
                            let _e2053 = paths.member[_e2039.member[0]];
                            let _e2055 = paths.member[_e2039.member[1]];
                            let _e2061 = paths.member[_e2037.member[0]];
                            let _e2063 = paths.member[_e2037.member[1]];
                            local_7 = type_35(array<array<f32, 3>, 2>(array<f32, 3>((_e2061.member[0] - _e2053.member[0]), (_e2061.member[1] - _e2053.member[1]), (_e2061.member[2] - _e2053.member[2])), array<f32, 3>((_e2061.member_1[0] - _e2053.member_1[0]), (_e2061.member_1[1] - _e2053.member_1[1]), (_e2061.member_1[2] - _e2053.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2055.member[0] - _e2053.member[0]), (_e2055.member[1] - _e2053.member[1]), (_e2055.member[2] - _e2053.member[2])), array<f32, 3>((_e2055.member_1[0] - _e2053.member_1[0]), (_e2055.member_1[1] - _e2053.member_1[1]), (_e2055.member_1[2] - _e2053.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2061.member[0] - _e2063.member[0]), (_e2061.member[1] - _e2063.member[1]), (_e2061.member[2] - _e2063.member[2])), array<f32, 3>((_e2061.member_1[0] - _e2063.member_1[0]), (_e2061.member_1[1] - _e2063.member_1[1]), (_e2061.member_1[2] - _e2063.member_1[2]))), (_e2041 + _e2041));
                            let _e2123 = local_7.member_1[0u];
                            let _e2129 = local_7.member_2[0u];
                            let _e2135 = ((_e2123[1] * _e2129[2]) - (_e2123[2] * _e2129[1]));
                            let _e2138 = ((_e2123[2] * _e2129[0]) - (_e2123[0] * _e2129[2]));
                            let _e2141 = ((_e2123[0] * _e2129[1]) - (_e2123[1] * _e2129[0]));
                            let _e2144 = local_7.member_1[1u];
                            let _e2150 = local_7.member_2[1u];
                            let _e2156 = ((_e2144[1] * _e2150[2]) - (_e2144[2] * _e2150[1]));
                            let _e2159 = ((_e2144[2] * _e2150[0]) - (_e2144[0] * _e2150[2]));
                            let _e2162 = ((_e2144[0] * _e2150[1]) - (_e2144[1] * _e2150[0]));
                            let _e2165 = local_7.member_1[0u];
                            let _e2171 = local_7.member_2[1u];
                            let _e2186 = local_7.member_1[1u];
                            let _e2192 = local_7.member_2[0u];
                            let _e2205 = (((_e2165[1] * _e2171[2]) - (_e2165[2] * _e2171[1])) + ((_e2186[1] * _e2192[2]) - (_e2186[2] * _e2192[1])));
                            let _e2206 = (((_e2165[2] * _e2171[0]) - (_e2165[0] * _e2171[2])) + ((_e2186[2] * _e2192[0]) - (_e2186[0] * _e2192[2])));
                            let _e2207 = (((_e2165[0] * _e2171[1]) - (_e2165[1] * _e2171[0])) + ((_e2186[0] * _e2192[1]) - (_e2186[1] * _e2192[0])));
                            let _e2210 = local_7.member[0u];
                            let _e2221 = local_7.member[1u];
                            let _e2232 = local_7.member[0u];
                            let _e2241 = ((((_e2221[0] * _e2135) + (_e2221[1] * _e2138)) + (_e2221[2] * _e2141)) + (((_e2232[0] * _e2205) + (_e2232[1] * _e2206)) + (_e2232[2] * _e2207)));
                            let _e2244 = local_7.member[0u];
                            let _e2255 = local_7.member[1u];
                            let _e2264 = ((((_e2244[0] * _e2156) + (_e2244[1] * _e2159)) + (_e2244[2] * _e2162)) + (((_e2255[0] * _e2205) + (_e2255[1] * _e2206)) + (_e2255[2] * _e2207)));
                            let _e2267 = local_7.member[1u];
                            let _e2278 = local_7.member[0u];
                            if (_e2278[0] < 0f) {
                                phi_3353_ = -(_e2278[0]);
                            } else {
                                phi_3353_ = _e2278[0];
                            }
                            let _e2285 = phi_3353_;
                            if (_e2278[1] < 0f) {
                                phi_3360_ = -(_e2278[1]);
                            } else {
                                phi_3360_ = _e2278[1];
                            }
                            let _e2289 = phi_3360_;
                            if (_e2285 > _e2289) {
                                phi_3365_ = _e2285;
                            } else {
                                phi_3365_ = _e2289;
                            }
                            let _e2292 = phi_3365_;
                            if (_e2278[2] < 0f) {
                                phi_3372_ = -(_e2278[2]);
                            } else {
                                phi_3372_ = _e2278[2];
                            }
                            let _e2296 = phi_3372_;
                            if (_e2292 > _e2296) {
                                phi_3377_ = _e2292;
                            } else {
                                phi_3377_ = _e2296;
                            }
                            let _e2299 = phi_3377_;
                            let _e2302 = local_7.member[1u];
                            if (_e2302[0] < 0f) {
                                phi_3390_ = -(_e2302[0]);
                            } else {
                                phi_3390_ = _e2302[0];
                            }
                            let _e2309 = phi_3390_;
                            if (_e2302[1] < 0f) {
                                phi_3397_ = -(_e2302[1]);
                            } else {
                                phi_3397_ = _e2302[1];
                            }
                            let _e2313 = phi_3397_;
                            if (_e2309 > _e2313) {
                                phi_3402_ = _e2309;
                            } else {
                                phi_3402_ = _e2313;
                            }
                            let _e2316 = phi_3402_;
                            if (_e2302[2] < 0f) {
                                phi_3409_ = -(_e2302[2]);
                            } else {
                                phi_3409_ = _e2302[2];
                            }
                            let _e2320 = phi_3409_;
                            if (_e2316 > _e2320) {
                                phi_3414_ = _e2316;
                            } else {
                                phi_3414_ = _e2320;
                            }
                            let _e2323 = phi_3414_;
                            if (_e2299 > _e2323) {
                                phi_3419_ = _e2299;
                            } else {
                                phi_3419_ = _e2323;
                            }
                            let _e2326 = phi_3419_;
                            let _e2328 = local_7.member_3;
                            let _e2329 = (_e2326 + _e2328);
                            let _e2332 = local_7.member_1[0u];
                            if (_e2332[0] < 0f) {
                                phi_3436_ = -(_e2332[0]);
                            } else {
                                phi_3436_ = _e2332[0];
                            }
                            let _e2339 = phi_3436_;
                            if (_e2332[1] < 0f) {
                                phi_3443_ = -(_e2332[1]);
                            } else {
                                phi_3443_ = _e2332[1];
                            }
                            let _e2343 = phi_3443_;
                            if (_e2339 > _e2343) {
                                phi_3448_ = _e2339;
                            } else {
                                phi_3448_ = _e2343;
                            }
                            let _e2346 = phi_3448_;
                            if (_e2332[2] < 0f) {
                                phi_3455_ = -(_e2332[2]);
                            } else {
                                phi_3455_ = _e2332[2];
                            }
                            let _e2350 = phi_3455_;
                            if (_e2346 > _e2350) {
                                phi_3460_ = _e2346;
                            } else {
                                phi_3460_ = _e2350;
                            }
                            let _e2353 = phi_3460_;
                            let _e2356 = local_7.member_1[1u];
                            if (_e2356[0] < 0f) {
                                phi_3474_ = -(_e2356[0]);
                            } else {
                                phi_3474_ = _e2356[0];
                            }
                            let _e2363 = phi_3474_;
                            if (_e2356[1] < 0f) {
                                phi_3481_ = -(_e2356[1]);
                            } else {
                                phi_3481_ = _e2356[1];
                            }
                            let _e2367 = phi_3481_;
                            if (_e2363 > _e2367) {
                                phi_3486_ = _e2363;
                            } else {
                                phi_3486_ = _e2367;
                            }
                            let _e2370 = phi_3486_;
                            if (_e2356[2] < 0f) {
                                phi_3493_ = -(_e2356[2]);
                            } else {
                                phi_3493_ = _e2356[2];
                            }
                            let _e2374 = phi_3493_;
                            if (_e2370 > _e2374) {
                                phi_3498_ = _e2370;
                            } else {
                                phi_3498_ = _e2374;
                            }
                            let _e2377 = phi_3498_;
                            if (_e2353 > _e2377) {
                                phi_3503_ = _e2353;
                            } else {
                                phi_3503_ = _e2377;
                            }
                            let _e2380 = phi_3503_;
                            let _e2382 = local_7.member_3;
                            let _e2383 = (_e2380 + _e2382);
                            let _e2386 = local_7.member_2[0u];
                            if (_e2386[0] < 0f) {
                                phi_3520_ = -(_e2386[0]);
                            } else {
                                phi_3520_ = _e2386[0];
                            }
                            let _e2393 = phi_3520_;
                            if (_e2386[1] < 0f) {
                                phi_3527_ = -(_e2386[1]);
                            } else {
                                phi_3527_ = _e2386[1];
                            }
                            let _e2397 = phi_3527_;
                            if (_e2393 > _e2397) {
                                phi_3532_ = _e2393;
                            } else {
                                phi_3532_ = _e2397;
                            }
                            let _e2400 = phi_3532_;
                            if (_e2386[2] < 0f) {
                                phi_3539_ = -(_e2386[2]);
                            } else {
                                phi_3539_ = _e2386[2];
                            }
                            let _e2404 = phi_3539_;
                            if (_e2400 > _e2404) {
                                phi_3544_ = _e2400;
                            } else {
                                phi_3544_ = _e2404;
                            }
                            let _e2407 = phi_3544_;
                            let _e2410 = local_7.member_2[1u];
                            if (_e2410[0] < 0f) {
                                phi_3558_ = -(_e2410[0]);
                            } else {
                                phi_3558_ = _e2410[0];
                            }
                            let _e2417 = phi_3558_;
                            if (_e2410[1] < 0f) {
                                phi_3565_ = -(_e2410[1]);
                            } else {
                                phi_3565_ = _e2410[1];
                            }
                            let _e2421 = phi_3565_;
                            if (_e2417 > _e2421) {
                                phi_3570_ = _e2417;
                            } else {
                                phi_3570_ = _e2421;
                            }
                            let _e2424 = phi_3570_;
                            if (_e2410[2] < 0f) {
                                phi_3577_ = -(_e2410[2]);
                            } else {
                                phi_3577_ = _e2410[2];
                            }
                            let _e2428 = phi_3577_;
                            if (_e2424 > _e2428) {
                                phi_3582_ = _e2424;
                            } else {
                                phi_3582_ = _e2428;
                            }
                            let _e2431 = phi_3582_;
                            if (_e2407 > _e2431) {
                                phi_3587_ = _e2407;
                            } else {
                                phi_3587_ = _e2431;
                            }
                            let _e2434 = phi_3587_;
                            let _e2436 = local_7.member_3;
                            let _e2437 = (_e2434 + _e2436);
                            let _e2439 = ((_e2383 * 8f) * _e2437);
                            let _e2446 = local_7.member_3;
                            if (_e2135 < 0f) {
                                phi_3618_ = -(_e2135);
                            } else {
                                phi_3618_ = _e2135;
                            }
                            let _e2463 = phi_3618_;
                            if (_e2138 < 0f) {
                                phi_3624_ = -(_e2138);
                            } else {
                                phi_3624_ = _e2138;
                            }
                            let _e2467 = phi_3624_;
                            if (_e2141 < 0f) {
                                phi_3631_ = -(_e2141);
                            } else {
                                phi_3631_ = _e2141;
                            }
                            let _e2472 = phi_3631_;
                            let _e2473 = ((_e2463 + _e2467) + _e2472);
                            if (_e2156 < 0f) {
                                phi_3638_ = -(_e2156);
                            } else {
                                phi_3638_ = _e2156;
                            }
                            let _e2477 = phi_3638_;
                            if (_e2159 < 0f) {
                                phi_3644_ = -(_e2159);
                            } else {
                                phi_3644_ = _e2159;
                            }
                            let _e2481 = phi_3644_;
                            if (_e2162 < 0f) {
                                phi_3651_ = -(_e2162);
                            } else {
                                phi_3651_ = _e2162;
                            }
                            let _e2486 = phi_3651_;
                            let _e2487 = ((_e2477 + _e2481) + _e2486);
                            if (_e2473 > _e2487) {
                                phi_3657_ = _e2473;
                            } else {
                                phi_3657_ = _e2487;
                            }
                            let _e2490 = phi_3657_;
                            if (_e2205 < 0f) {
                                phi_3663_ = -(_e2205);
                            } else {
                                phi_3663_ = _e2205;
                            }
                            let _e2494 = phi_3663_;
                            if (_e2206 < 0f) {
                                phi_3669_ = -(_e2206);
                            } else {
                                phi_3669_ = _e2206;
                            }
                            let _e2498 = phi_3669_;
                            if (_e2207 < 0f) {
                                phi_3676_ = -(_e2207);
                            } else {
                                phi_3676_ = _e2207;
                            }
                            let _e2503 = phi_3676_;
                            let _e2505 = (((_e2494 + _e2498) + _e2503) * 0.5f);
                            if (_e2490 > _e2505) {
                                phi_3683_ = _e2490;
                            } else {
                                phi_3683_ = _e2505;
                            }
                            let _e2508 = phi_3683_;
                            let _e2513 = local_7.member_3;
                            let _e2526 = ((((_e2210[0] * _e2135) + (_e2210[1] * _e2138)) + (_e2210[2] * _e2141)) * 3f);
                            let _e2527 = ((((_e2267[0] * _e2156) + (_e2267[1] * _e2159)) + (_e2267[2] * _e2162)) * 3f);
                            if (_e2526 < _e2527) {
                                phi_3707_ = _e2526;
                            } else {
                                phi_3707_ = _e2527;
                            }
                            let _e2530 = phi_3707_;
                            if (_e2241 < _e2264) {
                                phi_3712_ = _e2241;
                            } else {
                                phi_3712_ = _e2264;
                            }
                            let _e2533 = phi_3712_;
                            if (_e2530 < _e2533) {
                                phi_3717_ = _e2530;
                            } else {
                                phi_3717_ = _e2533;
                            }
                            let _e2536 = phi_3717_;
                            if (_e2526 > _e2527) {
                                phi_3722_ = _e2526;
                            } else {
                                phi_3722_ = _e2527;
                            }
                            let _e2539 = phi_3722_;
                            if (_e2241 > _e2264) {
                                phi_3727_ = _e2241;
                            } else {
                                phi_3727_ = _e2264;
                            }
                            let _e2542 = phi_3727_;
                            if (_e2539 > _e2542) {
                                phi_3732_ = _e2539;
                            } else {
                                phi_3732_ = _e2542;
                            }
                            let _e2545 = phi_3732_;
                            let _e2550 = -(_e2545);
                            if (_e2536 > _e2550) {
                                phi_3742_ = _e2536;
                            } else {
                                phi_3742_ = _e2550;
                            }
                            let _e2553 = phi_3742_;
                            if ((_e2553 - ((((((_e2329 * 8f) * _e2439) * (0.000000059604645f * (490f / 64f))) + ((_e2446 * 19f) * ((_e2329 * (_e2383 + _e2437)) + (_e2383 * _e2437)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2329) * ((1f + _e2383) * (1f + _e2437))))) + ((_e2043 * (((_e2508 + (_e2439 * (0.000000059604645f * 4f))) + ((_e2513 * 6f) * (_e2383 + _e2437))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2383) * (1f + _e2437))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4718_ = true;
                            } else {
                                let _e2558 = local_7.member_1[0u];
                                let _e2564 = local_7.member_1[1u];
                                let _e2568 = (_e2558[0] + _e2564[0]);
                                let _e2569 = (_e2558[1] + _e2564[1]);
                                let _e2570 = (_e2558[2] + _e2564[2]);
                                let _e2573 = local_7.member_2[0u];
                                let _e2579 = local_7.member_2[1u];
                                let _e2583 = (_e2573[0] + _e2579[0]);
                                let _e2584 = (_e2573[1] + _e2579[1]);
                                let _e2585 = (_e2573[2] + _e2579[2]);
                                let _e2588 = ((_e2569 * _e2585) - (_e2570 * _e2584));
                                let _e2591 = ((_e2570 * _e2583) - (_e2568 * _e2585));
                                let _e2594 = ((_e2568 * _e2584) - (_e2569 * _e2583));
                                let _e2597 = local_7.member[0u];
                                let _e2603 = local_7.member_1[0u];
                                let _e2609 = local_7.member_2[0u];
                                let _e2613 = (_e2597[0] - _e2603[0]);
                                let _e2614 = (_e2597[1] - _e2603[1]);
                                let _e2615 = (_e2597[2] - _e2603[2]);
                                let _e2624 = local_7.member[1u];
                                let _e2630 = local_7.member_1[1u];
                                let _e2636 = local_7.member_2[1u];
                                let _e2640 = (_e2624[0] - _e2630[0]);
                                let _e2641 = (_e2624[1] - _e2630[1]);
                                let _e2642 = (_e2624[2] - _e2630[2]);
                                local_5 = array<array<f32, 3>, 4>(_e2597, array<f32, 3>(_e2613, _e2614, _e2615), array<f32, 3>((_e2597[0] - _e2609[0]), (_e2597[1] - _e2609[1]), (_e2597[2] - _e2609[2])), array<f32, 3>((_e2613 - _e2609[0]), (_e2614 - _e2609[1]), (_e2615 - _e2609[2])));
                                local_6 = array<array<f32, 3>, 4>(_e2624, array<f32, 3>(_e2640, _e2641, _e2642), array<f32, 3>((_e2624[0] - _e2636[0]), (_e2624[1] - _e2636[1]), (_e2624[2] - _e2636[2])), array<f32, 3>((_e2640 - _e2636[0]), (_e2641 - _e2636[1]), (_e2642 - _e2636[2])));
                                let _e2659 = local_7.member[0u];
                                if (_e2659[0] < 0f) {
                                    phi_3993_ = -(_e2659[0]);
                                } else {
                                    phi_3993_ = _e2659[0];
                                }
                                let _e2666 = phi_3993_;
                                if (_e2659[1] < 0f) {
                                    phi_4000_ = -(_e2659[1]);
                                } else {
                                    phi_4000_ = _e2659[1];
                                }
                                let _e2670 = phi_4000_;
                                if (_e2666 > _e2670) {
                                    phi_4005_ = _e2666;
                                } else {
                                    phi_4005_ = _e2670;
                                }
                                let _e2673 = phi_4005_;
                                if (_e2659[2] < 0f) {
                                    phi_4012_ = -(_e2659[2]);
                                } else {
                                    phi_4012_ = _e2659[2];
                                }
                                let _e2677 = phi_4012_;
                                if (_e2673 > _e2677) {
                                    phi_4017_ = _e2673;
                                } else {
                                    phi_4017_ = _e2677;
                                }
                                let _e2680 = phi_4017_;
                                let _e2683 = local_7.member[1u];
                                if (_e2683[0] < 0f) {
                                    phi_4030_ = -(_e2683[0]);
                                } else {
                                    phi_4030_ = _e2683[0];
                                }
                                let _e2690 = phi_4030_;
                                if (_e2683[1] < 0f) {
                                    phi_4037_ = -(_e2683[1]);
                                } else {
                                    phi_4037_ = _e2683[1];
                                }
                                let _e2694 = phi_4037_;
                                if (_e2690 > _e2694) {
                                    phi_4042_ = _e2690;
                                } else {
                                    phi_4042_ = _e2694;
                                }
                                let _e2697 = phi_4042_;
                                if (_e2683[2] < 0f) {
                                    phi_4049_ = -(_e2683[2]);
                                } else {
                                    phi_4049_ = _e2683[2];
                                }
                                let _e2701 = phi_4049_;
                                if (_e2697 > _e2701) {
                                    phi_4054_ = _e2697;
                                } else {
                                    phi_4054_ = _e2701;
                                }
                                let _e2704 = phi_4054_;
                                if (_e2680 > _e2704) {
                                    phi_4059_ = _e2680;
                                } else {
                                    phi_4059_ = _e2704;
                                }
                                let _e2707 = phi_4059_;
                                let _e2709 = local_7.member_3;
                                let _e2713 = local_7.member_1[0u];
                                if (_e2713[0] < 0f) {
                                    phi_4076_ = -(_e2713[0]);
                                } else {
                                    phi_4076_ = _e2713[0];
                                }
                                let _e2720 = phi_4076_;
                                if (_e2713[1] < 0f) {
                                    phi_4083_ = -(_e2713[1]);
                                } else {
                                    phi_4083_ = _e2713[1];
                                }
                                let _e2724 = phi_4083_;
                                if (_e2720 > _e2724) {
                                    phi_4088_ = _e2720;
                                } else {
                                    phi_4088_ = _e2724;
                                }
                                let _e2727 = phi_4088_;
                                if (_e2713[2] < 0f) {
                                    phi_4095_ = -(_e2713[2]);
                                } else {
                                    phi_4095_ = _e2713[2];
                                }
                                let _e2731 = phi_4095_;
                                if (_e2727 > _e2731) {
                                    phi_4100_ = _e2727;
                                } else {
                                    phi_4100_ = _e2731;
                                }
                                let _e2734 = phi_4100_;
                                let _e2737 = local_7.member_1[1u];
                                if (_e2737[0] < 0f) {
                                    phi_4114_ = -(_e2737[0]);
                                } else {
                                    phi_4114_ = _e2737[0];
                                }
                                let _e2744 = phi_4114_;
                                if (_e2737[1] < 0f) {
                                    phi_4121_ = -(_e2737[1]);
                                } else {
                                    phi_4121_ = _e2737[1];
                                }
                                let _e2748 = phi_4121_;
                                if (_e2744 > _e2748) {
                                    phi_4126_ = _e2744;
                                } else {
                                    phi_4126_ = _e2748;
                                }
                                let _e2751 = phi_4126_;
                                if (_e2737[2] < 0f) {
                                    phi_4133_ = -(_e2737[2]);
                                } else {
                                    phi_4133_ = _e2737[2];
                                }
                                let _e2755 = phi_4133_;
                                if (_e2751 > _e2755) {
                                    phi_4138_ = _e2751;
                                } else {
                                    phi_4138_ = _e2755;
                                }
                                let _e2758 = phi_4138_;
                                if (_e2734 > _e2758) {
                                    phi_4143_ = _e2734;
                                } else {
                                    phi_4143_ = _e2758;
                                }
                                let _e2761 = phi_4143_;
                                let _e2763 = local_7.member_3;
                                let _e2767 = local_7.member_2[0u];
                                if (_e2767[0] < 0f) {
                                    phi_4160_ = -(_e2767[0]);
                                } else {
                                    phi_4160_ = _e2767[0];
                                }
                                let _e2774 = phi_4160_;
                                if (_e2767[1] < 0f) {
                                    phi_4167_ = -(_e2767[1]);
                                } else {
                                    phi_4167_ = _e2767[1];
                                }
                                let _e2778 = phi_4167_;
                                if (_e2774 > _e2778) {
                                    phi_4172_ = _e2774;
                                } else {
                                    phi_4172_ = _e2778;
                                }
                                let _e2781 = phi_4172_;
                                if (_e2767[2] < 0f) {
                                    phi_4179_ = -(_e2767[2]);
                                } else {
                                    phi_4179_ = _e2767[2];
                                }
                                let _e2785 = phi_4179_;
                                if (_e2781 > _e2785) {
                                    phi_4184_ = _e2781;
                                } else {
                                    phi_4184_ = _e2785;
                                }
                                let _e2788 = phi_4184_;
                                let _e2791 = local_7.member_2[1u];
                                if (_e2791[0] < 0f) {
                                    phi_4198_ = -(_e2791[0]);
                                } else {
                                    phi_4198_ = _e2791[0];
                                }
                                let _e2798 = phi_4198_;
                                if (_e2791[1] < 0f) {
                                    phi_4205_ = -(_e2791[1]);
                                } else {
                                    phi_4205_ = _e2791[1];
                                }
                                let _e2802 = phi_4205_;
                                if (_e2798 > _e2802) {
                                    phi_4210_ = _e2798;
                                } else {
                                    phi_4210_ = _e2802;
                                }
                                let _e2805 = phi_4210_;
                                if (_e2791[2] < 0f) {
                                    phi_4217_ = -(_e2791[2]);
                                } else {
                                    phi_4217_ = _e2791[2];
                                }
                                let _e2809 = phi_4217_;
                                if (_e2805 > _e2809) {
                                    phi_4222_ = _e2805;
                                } else {
                                    phi_4222_ = _e2809;
                                }
                                let _e2812 = phi_4222_;
                                if (_e2788 > _e2812) {
                                    phi_4227_ = _e2788;
                                } else {
                                    phi_4227_ = _e2812;
                                }
                                let _e2815 = phi_4227_;
                                let _e2817 = local_7.member_3;
                                let _e2820 = (((_e2707 + _e2709) + (_e2761 + _e2763)) + (_e2815 + _e2817));
                                let _e2823 = local_7.member_3;
                                let _e2827 = (((_e2043 * 1.0001f) + (_e2823 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2830 = ((_e2591 * _e2570) - (_e2594 * _e2569));
                                let _e2833 = ((_e2594 * _e2568) - (_e2588 * _e2570));
                                let _e2836 = ((_e2588 * _e2569) - (_e2591 * _e2568));
                                let _e2838 = local_5[0u];
                                let _e2846 = (((_e2830 * _e2838[0]) + (_e2833 * _e2838[1])) + (_e2836 * _e2838[2]));
                                phi_4265_ = type_21(0u, 4u);
                                phi_4268_ = _e2846;
                                phi_4270_ = _e2846;
                                loop {
                                    let _e2848 = phi_4265_;
                                    let _e2850 = phi_4268_;
                                    let _e2852 = phi_4270_;
                                    local_52 = _e2850;
                                    local_53 = _e2852;
                                    local_67 = _e2852;
                                    if (_e2848.member < _e2848.member_1) {
                                        phi_4266_ = type_21((_e2848.member + 1u), _e2848.member_1);
                                        phi_4293_ = type_21(1u, _e2848.member);
                                    } else {
                                        phi_4266_ = _e2848;
                                        phi_4293_ = type_21(0u, type_21().member_1);
                                    }
                                    let _e2864 = phi_4266_;
                                    let _e2866 = phi_4293_;
                                    let _e2870 = (bitcast<i32>(_e2866.member) != 0i);
                                    if _e2870 {
                                        let _e2872 = local_5[_e2866.member_1];
                                        let _e2880 = (((_e2830 * _e2872[0]) + (_e2833 * _e2872[1])) + (_e2836 * _e2872[2]));
                                        let _e2882 = local_6[_e2866.member_1];
                                        let _e2890 = (((_e2830 * _e2882[0]) + (_e2833 * _e2882[1])) + (_e2836 * _e2882[2]));
                                        if (_e2852 < _e2880) {
                                            phi_4343_ = _e2852;
                                        } else {
                                            phi_4343_ = _e2880;
                                        }
                                        let _e2893 = phi_4343_;
                                        if (_e2893 < _e2890) {
                                            phi_4348_ = _e2893;
                                        } else {
                                            phi_4348_ = _e2890;
                                        }
                                        let _e2896 = phi_4348_;
                                        if (_e2850 > _e2880) {
                                            phi_4353_ = _e2850;
                                        } else {
                                            phi_4353_ = _e2880;
                                        }
                                        let _e2899 = phi_4353_;
                                        if (_e2899 > _e2890) {
                                            phi_4358_ = _e2899;
                                        } else {
                                            phi_4358_ = _e2890;
                                        }
                                        let _e2902 = phi_4358_;
                                        phi_4269_ = _e2902;
                                        phi_4271_ = _e2896;
                                    } else {
                                        phi_4269_ = f32();
                                        phi_4271_ = f32();
                                    }
                                    let _e2904 = phi_4269_;
                                    let _e2906 = phi_4271_;
                                    continue;
                                    continuing {
                                        phi_4265_ = _e2864;
                                        phi_4268_ = _e2904;
                                        phi_4270_ = _e2906;
                                        break if !(_e2870);
                                    }
                                }
                                if (_e2830 < 0f) {
                                    phi_4364_ = -(_e2830);
                                } else {
                                    phi_4364_ = _e2830;
                                }
                                let _e2911 = phi_4364_;
                                if (_e2833 < 0f) {
                                    phi_4370_ = -(_e2833);
                                } else {
                                    phi_4370_ = _e2833;
                                }
                                let _e2915 = phi_4370_;
                                if (_e2836 < 0f) {
                                    phi_4377_ = -(_e2836);
                                } else {
                                    phi_4377_ = _e2836;
                                }
                                let _e2920 = phi_4377_;
                                let _e2921 = ((_e2911 + _e2915) + _e2920);
                                let _e2926 = local_52;
                                let _e2927 = -(_e2926);
                                let _e2929 = local_53;
                                if (_e2929 > _e2927) {
                                    let _e5444 = local_67;
                                    phi_4387_ = _e5444;
                                } else {
                                    phi_4387_ = _e2927;
                                }
                                let _e2932 = phi_4387_;
                                let _e2937 = (((_e2932 - ((_e2921 * _e2820) * (0.000000059604645f * 17f))) - (_e2921 * _e2827)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2940 = ((_e2591 * _e2585) - (_e2594 * _e2584));
                                let _e2943 = ((_e2594 * _e2583) - (_e2588 * _e2585));
                                let _e2946 = ((_e2588 * _e2584) - (_e2591 * _e2583));
                                let _e2948 = local_5[0u];
                                let _e2956 = (((_e2940 * _e2948[0]) + (_e2943 * _e2948[1])) + (_e2946 * _e2948[2]));
                                phi_4418_ = type_21(0u, 4u);
                                phi_4421_ = _e2956;
                                phi_4423_ = _e2956;
                                loop {
                                    let _e2958 = phi_4418_;
                                    let _e2960 = phi_4421_;
                                    let _e2962 = phi_4423_;
                                    local_54 = _e2960;
                                    local_55 = _e2962;
                                    local_68 = _e2962;
                                    if (_e2958.member < _e2958.member_1) {
                                        phi_4419_ = type_21((_e2958.member + 1u), _e2958.member_1);
                                        phi_4446_ = type_21(1u, _e2958.member);
                                    } else {
                                        phi_4419_ = _e2958;
                                        phi_4446_ = type_21(0u, type_21().member_1);
                                    }
                                    let _e2974 = phi_4419_;
                                    let _e2976 = phi_4446_;
                                    let _e2980 = (bitcast<i32>(_e2976.member) != 0i);
                                    if _e2980 {
                                        let _e2982 = local_5[_e2976.member_1];
                                        let _e2990 = (((_e2940 * _e2982[0]) + (_e2943 * _e2982[1])) + (_e2946 * _e2982[2]));
                                        let _e2992 = local_6[_e2976.member_1];
                                        let _e3000 = (((_e2940 * _e2992[0]) + (_e2943 * _e2992[1])) + (_e2946 * _e2992[2]));
                                        if (_e2962 < _e2990) {
                                            phi_4496_ = _e2962;
                                        } else {
                                            phi_4496_ = _e2990;
                                        }
                                        let _e3003 = phi_4496_;
                                        if (_e3003 < _e3000) {
                                            phi_4501_ = _e3003;
                                        } else {
                                            phi_4501_ = _e3000;
                                        }
                                        let _e3006 = phi_4501_;
                                        if (_e2960 > _e2990) {
                                            phi_4506_ = _e2960;
                                        } else {
                                            phi_4506_ = _e2990;
                                        }
                                        let _e3009 = phi_4506_;
                                        if (_e3009 > _e3000) {
                                            phi_4511_ = _e3009;
                                        } else {
                                            phi_4511_ = _e3000;
                                        }
                                        let _e3012 = phi_4511_;
                                        phi_4422_ = _e3012;
                                        phi_4424_ = _e3006;
                                    } else {
                                        phi_4422_ = f32();
                                        phi_4424_ = f32();
                                    }
                                    let _e3014 = phi_4422_;
                                    let _e3016 = phi_4424_;
                                    continue;
                                    continuing {
                                        phi_4418_ = _e2974;
                                        phi_4421_ = _e3014;
                                        phi_4423_ = _e3016;
                                        break if !(_e2980);
                                    }
                                }
                                if (_e2940 < 0f) {
                                    phi_4517_ = -(_e2940);
                                } else {
                                    phi_4517_ = _e2940;
                                }
                                let _e3021 = phi_4517_;
                                if (_e2943 < 0f) {
                                    phi_4523_ = -(_e2943);
                                } else {
                                    phi_4523_ = _e2943;
                                }
                                let _e3025 = phi_4523_;
                                if (_e2946 < 0f) {
                                    phi_4530_ = -(_e2946);
                                } else {
                                    phi_4530_ = _e2946;
                                }
                                let _e3030 = phi_4530_;
                                let _e3031 = ((_e3021 + _e3025) + _e3030);
                                let _e3036 = local_54;
                                let _e3037 = -(_e3036);
                                let _e3039 = local_55;
                                if (_e3039 > _e3037) {
                                    let _e5463 = local_68;
                                    phi_4540_ = _e5463;
                                } else {
                                    phi_4540_ = _e3037;
                                }
                                let _e3042 = phi_4540_;
                                let _e3047 = (((_e3042 - ((_e3031 * _e2820) * (0.000000059604645f * 17f))) - (_e3031 * _e2827)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2937 > _e3047) {
                                    phi_4550_ = _e2937;
                                } else {
                                    phi_4550_ = _e3047;
                                }
                                let _e3050 = phi_4550_;
                                phi_4718_ = (_e3050 > 0f);
                            }
                            let _e3053 = phi_4718_;
                            if _e3053 {
                                phi_8154_ = false;
                            } else {
                                let _e3056 = local_7.member[0u];
                                let _e3062 = local_7.member[1u];
                                let _e3069 = ((_e3056[0] + _e3062[0]) * 0.5f);
                                let _e3070 = ((_e3056[1] + _e3062[1]) * 0.5f);
                                let _e3071 = ((_e3056[2] + _e3062[2]) * 0.5f);
                                let _e3074 = local_7.member_1[0u];
                                let _e3080 = local_7.member_1[1u];
                                let _e3087 = ((_e3074[0] + _e3080[0]) * 0.5f);
                                let _e3088 = ((_e3074[1] + _e3080[1]) * 0.5f);
                                let _e3089 = ((_e3074[2] + _e3080[2]) * 0.5f);
                                let _e3092 = local_7.member_2[0u];
                                let _e3098 = local_7.member_2[1u];
                                let _e3105 = ((_e3092[0] + _e3098[0]) * 0.5f);
                                let _e3106 = ((_e3092[1] + _e3098[1]) * 0.5f);
                                let _e3107 = ((_e3092[2] + _e3098[2]) * 0.5f);
                                let _e3110 = local_7.member[0u];
                                let _e3113 = local_7.member_1[0u];
                                let _e3116 = local_7.member_2[0u];
                                let _e3118 = local_7.member_3;
                                let _e3121 = local_7.member[1u];
                                let _e3124 = local_7.member_1[1u];
                                let _e3127 = local_7.member_2[1u];
                                let _e3129 = local_7.member_3;
                                local_4 = array<type_35, 2>(type_35(array<array<f32, 3>, 2>(_e3110, array<f32, 3>(_e3069, _e3070, _e3071)), array<array<f32, 3>, 2>(_e3113, array<f32, 3>(_e3087, _e3088, _e3089)), array<array<f32, 3>, 2>(_e3116, array<f32, 3>(_e3105, _e3106, _e3107)), _e3118), type_35(array<array<f32, 3>, 2>(array<f32, 3>(_e3069, _e3070, _e3071), _e3121), array<array<f32, 3>, 2>(array<f32, 3>(_e3087, _e3088, _e3089), _e3124), array<array<f32, 3>, 2>(array<f32, 3>(_e3105, _e3106, _e3107), _e3127), _e3129));
                                let _e3148 = local_4[0u].member_1[0u];
                                let _e3154 = local_4[0u].member_2[0u];
                                let _e3160 = ((_e3148[1] * _e3154[2]) - (_e3148[2] * _e3154[1]));
                                let _e3163 = ((_e3148[2] * _e3154[0]) - (_e3148[0] * _e3154[2]));
                                let _e3166 = ((_e3148[0] * _e3154[1]) - (_e3148[1] * _e3154[0]));
                                let _e3169 = local_4[0u].member_1[1u];
                                let _e3175 = local_4[0u].member_2[1u];
                                let _e3181 = ((_e3169[1] * _e3175[2]) - (_e3169[2] * _e3175[1]));
                                let _e3184 = ((_e3169[2] * _e3175[0]) - (_e3169[0] * _e3175[2]));
                                let _e3187 = ((_e3169[0] * _e3175[1]) - (_e3169[1] * _e3175[0]));
                                let _e3190 = local_4[0u].member_1[0u];
                                let _e3196 = local_4[0u].member_2[1u];
                                let _e3211 = local_4[0u].member_1[1u];
                                let _e3217 = local_4[0u].member_2[0u];
                                let _e3230 = (((_e3190[1] * _e3196[2]) - (_e3190[2] * _e3196[1])) + ((_e3211[1] * _e3217[2]) - (_e3211[2] * _e3217[1])));
                                let _e3231 = (((_e3190[2] * _e3196[0]) - (_e3190[0] * _e3196[2])) + ((_e3211[2] * _e3217[0]) - (_e3211[0] * _e3217[2])));
                                let _e3232 = (((_e3190[0] * _e3196[1]) - (_e3190[1] * _e3196[0])) + ((_e3211[0] * _e3217[1]) - (_e3211[1] * _e3217[0])));
                                let _e3235 = local_4[0u].member[0u];
                                let _e3246 = local_4[0u].member[1u];
                                let _e3257 = local_4[0u].member[0u];
                                let _e3266 = ((((_e3246[0] * _e3160) + (_e3246[1] * _e3163)) + (_e3246[2] * _e3166)) + (((_e3257[0] * _e3230) + (_e3257[1] * _e3231)) + (_e3257[2] * _e3232)));
                                let _e3269 = local_4[0u].member[0u];
                                let _e3280 = local_4[0u].member[1u];
                                let _e3289 = ((((_e3269[0] * _e3181) + (_e3269[1] * _e3184)) + (_e3269[2] * _e3187)) + (((_e3280[0] * _e3230) + (_e3280[1] * _e3231)) + (_e3280[2] * _e3232)));
                                let _e3292 = local_4[0u].member[1u];
                                let _e3303 = local_4[0u].member[0u];
                                if (_e3303[0] < 0f) {
                                    phi_5175_ = -(_e3303[0]);
                                } else {
                                    phi_5175_ = _e3303[0];
                                }
                                let _e3310 = phi_5175_;
                                if (_e3303[1] < 0f) {
                                    phi_5182_ = -(_e3303[1]);
                                } else {
                                    phi_5182_ = _e3303[1];
                                }
                                let _e3314 = phi_5182_;
                                if (_e3310 > _e3314) {
                                    phi_5187_ = _e3310;
                                } else {
                                    phi_5187_ = _e3314;
                                }
                                let _e3317 = phi_5187_;
                                if (_e3303[2] < 0f) {
                                    phi_5194_ = -(_e3303[2]);
                                } else {
                                    phi_5194_ = _e3303[2];
                                }
                                let _e3321 = phi_5194_;
                                if (_e3317 > _e3321) {
                                    phi_5199_ = _e3317;
                                } else {
                                    phi_5199_ = _e3321;
                                }
                                let _e3324 = phi_5199_;
                                let _e3327 = local_4[0u].member[1u];
                                if (_e3327[0] < 0f) {
                                    phi_5212_ = -(_e3327[0]);
                                } else {
                                    phi_5212_ = _e3327[0];
                                }
                                let _e3334 = phi_5212_;
                                if (_e3327[1] < 0f) {
                                    phi_5219_ = -(_e3327[1]);
                                } else {
                                    phi_5219_ = _e3327[1];
                                }
                                let _e3338 = phi_5219_;
                                if (_e3334 > _e3338) {
                                    phi_5224_ = _e3334;
                                } else {
                                    phi_5224_ = _e3338;
                                }
                                let _e3341 = phi_5224_;
                                if (_e3327[2] < 0f) {
                                    phi_5231_ = -(_e3327[2]);
                                } else {
                                    phi_5231_ = _e3327[2];
                                }
                                let _e3345 = phi_5231_;
                                if (_e3341 > _e3345) {
                                    phi_5236_ = _e3341;
                                } else {
                                    phi_5236_ = _e3345;
                                }
                                let _e3348 = phi_5236_;
                                if (_e3324 > _e3348) {
                                    phi_5241_ = _e3324;
                                } else {
                                    phi_5241_ = _e3348;
                                }
                                let _e3351 = phi_5241_;
                                let _e3353 = local_4[0u].member_3;
                                let _e3354 = (_e3351 + _e3353);
                                let _e3357 = local_4[0u].member_1[0u];
                                if (_e3357[0] < 0f) {
                                    phi_5258_ = -(_e3357[0]);
                                } else {
                                    phi_5258_ = _e3357[0];
                                }
                                let _e3364 = phi_5258_;
                                if (_e3357[1] < 0f) {
                                    phi_5265_ = -(_e3357[1]);
                                } else {
                                    phi_5265_ = _e3357[1];
                                }
                                let _e3368 = phi_5265_;
                                if (_e3364 > _e3368) {
                                    phi_5270_ = _e3364;
                                } else {
                                    phi_5270_ = _e3368;
                                }
                                let _e3371 = phi_5270_;
                                if (_e3357[2] < 0f) {
                                    phi_5277_ = -(_e3357[2]);
                                } else {
                                    phi_5277_ = _e3357[2];
                                }
                                let _e3375 = phi_5277_;
                                if (_e3371 > _e3375) {
                                    phi_5282_ = _e3371;
                                } else {
                                    phi_5282_ = _e3375;
                                }
                                let _e3378 = phi_5282_;
                                let _e3381 = local_4[0u].member_1[1u];
                                if (_e3381[0] < 0f) {
                                    phi_5296_ = -(_e3381[0]);
                                } else {
                                    phi_5296_ = _e3381[0];
                                }
                                let _e3388 = phi_5296_;
                                if (_e3381[1] < 0f) {
                                    phi_5303_ = -(_e3381[1]);
                                } else {
                                    phi_5303_ = _e3381[1];
                                }
                                let _e3392 = phi_5303_;
                                if (_e3388 > _e3392) {
                                    phi_5308_ = _e3388;
                                } else {
                                    phi_5308_ = _e3392;
                                }
                                let _e3395 = phi_5308_;
                                if (_e3381[2] < 0f) {
                                    phi_5315_ = -(_e3381[2]);
                                } else {
                                    phi_5315_ = _e3381[2];
                                }
                                let _e3399 = phi_5315_;
                                if (_e3395 > _e3399) {
                                    phi_5320_ = _e3395;
                                } else {
                                    phi_5320_ = _e3399;
                                }
                                let _e3402 = phi_5320_;
                                if (_e3378 > _e3402) {
                                    phi_5325_ = _e3378;
                                } else {
                                    phi_5325_ = _e3402;
                                }
                                let _e3405 = phi_5325_;
                                let _e3407 = local_4[0u].member_3;
                                let _e3408 = (_e3405 + _e3407);
                                let _e3411 = local_4[0u].member_2[0u];
                                if (_e3411[0] < 0f) {
                                    phi_5342_ = -(_e3411[0]);
                                } else {
                                    phi_5342_ = _e3411[0];
                                }
                                let _e3418 = phi_5342_;
                                if (_e3411[1] < 0f) {
                                    phi_5349_ = -(_e3411[1]);
                                } else {
                                    phi_5349_ = _e3411[1];
                                }
                                let _e3422 = phi_5349_;
                                if (_e3418 > _e3422) {
                                    phi_5354_ = _e3418;
                                } else {
                                    phi_5354_ = _e3422;
                                }
                                let _e3425 = phi_5354_;
                                if (_e3411[2] < 0f) {
                                    phi_5361_ = -(_e3411[2]);
                                } else {
                                    phi_5361_ = _e3411[2];
                                }
                                let _e3429 = phi_5361_;
                                if (_e3425 > _e3429) {
                                    phi_5366_ = _e3425;
                                } else {
                                    phi_5366_ = _e3429;
                                }
                                let _e3432 = phi_5366_;
                                let _e3435 = local_4[0u].member_2[1u];
                                if (_e3435[0] < 0f) {
                                    phi_5380_ = -(_e3435[0]);
                                } else {
                                    phi_5380_ = _e3435[0];
                                }
                                let _e3442 = phi_5380_;
                                if (_e3435[1] < 0f) {
                                    phi_5387_ = -(_e3435[1]);
                                } else {
                                    phi_5387_ = _e3435[1];
                                }
                                let _e3446 = phi_5387_;
                                if (_e3442 > _e3446) {
                                    phi_5392_ = _e3442;
                                } else {
                                    phi_5392_ = _e3446;
                                }
                                let _e3449 = phi_5392_;
                                if (_e3435[2] < 0f) {
                                    phi_5399_ = -(_e3435[2]);
                                } else {
                                    phi_5399_ = _e3435[2];
                                }
                                let _e3453 = phi_5399_;
                                if (_e3449 > _e3453) {
                                    phi_5404_ = _e3449;
                                } else {
                                    phi_5404_ = _e3453;
                                }
                                let _e3456 = phi_5404_;
                                if (_e3432 > _e3456) {
                                    phi_5409_ = _e3432;
                                } else {
                                    phi_5409_ = _e3456;
                                }
                                let _e3459 = phi_5409_;
                                let _e3461 = local_4[0u].member_3;
                                let _e3462 = (_e3459 + _e3461);
                                let _e3464 = ((_e3408 * 8f) * _e3462);
                                let _e3471 = local_4[0u].member_3;
                                if (_e3160 < 0f) {
                                    phi_5440_ = -(_e3160);
                                } else {
                                    phi_5440_ = _e3160;
                                }
                                let _e3488 = phi_5440_;
                                if (_e3163 < 0f) {
                                    phi_5446_ = -(_e3163);
                                } else {
                                    phi_5446_ = _e3163;
                                }
                                let _e3492 = phi_5446_;
                                if (_e3166 < 0f) {
                                    phi_5453_ = -(_e3166);
                                } else {
                                    phi_5453_ = _e3166;
                                }
                                let _e3497 = phi_5453_;
                                let _e3498 = ((_e3488 + _e3492) + _e3497);
                                if (_e3181 < 0f) {
                                    phi_5460_ = -(_e3181);
                                } else {
                                    phi_5460_ = _e3181;
                                }
                                let _e3502 = phi_5460_;
                                if (_e3184 < 0f) {
                                    phi_5466_ = -(_e3184);
                                } else {
                                    phi_5466_ = _e3184;
                                }
                                let _e3506 = phi_5466_;
                                if (_e3187 < 0f) {
                                    phi_5473_ = -(_e3187);
                                } else {
                                    phi_5473_ = _e3187;
                                }
                                let _e3511 = phi_5473_;
                                let _e3512 = ((_e3502 + _e3506) + _e3511);
                                if (_e3498 > _e3512) {
                                    phi_5479_ = _e3498;
                                } else {
                                    phi_5479_ = _e3512;
                                }
                                let _e3515 = phi_5479_;
                                if (_e3230 < 0f) {
                                    phi_5485_ = -(_e3230);
                                } else {
                                    phi_5485_ = _e3230;
                                }
                                let _e3519 = phi_5485_;
                                if (_e3231 < 0f) {
                                    phi_5491_ = -(_e3231);
                                } else {
                                    phi_5491_ = _e3231;
                                }
                                let _e3523 = phi_5491_;
                                if (_e3232 < 0f) {
                                    phi_5498_ = -(_e3232);
                                } else {
                                    phi_5498_ = _e3232;
                                }
                                let _e3528 = phi_5498_;
                                let _e3530 = (((_e3519 + _e3523) + _e3528) * 0.5f);
                                if (_e3515 > _e3530) {
                                    phi_5505_ = _e3515;
                                } else {
                                    phi_5505_ = _e3530;
                                }
                                let _e3533 = phi_5505_;
                                let _e3538 = local_4[0u].member_3;
                                let _e3551 = ((((_e3235[0] * _e3160) + (_e3235[1] * _e3163)) + (_e3235[2] * _e3166)) * 3f);
                                let _e3552 = ((((_e3292[0] * _e3181) + (_e3292[1] * _e3184)) + (_e3292[2] * _e3187)) * 3f);
                                if (_e3551 < _e3552) {
                                    phi_5529_ = _e3551;
                                } else {
                                    phi_5529_ = _e3552;
                                }
                                let _e3555 = phi_5529_;
                                if (_e3266 < _e3289) {
                                    phi_5534_ = _e3266;
                                } else {
                                    phi_5534_ = _e3289;
                                }
                                let _e3558 = phi_5534_;
                                if (_e3555 < _e3558) {
                                    phi_5539_ = _e3555;
                                } else {
                                    phi_5539_ = _e3558;
                                }
                                let _e3561 = phi_5539_;
                                if (_e3551 > _e3552) {
                                    phi_5544_ = _e3551;
                                } else {
                                    phi_5544_ = _e3552;
                                }
                                let _e3564 = phi_5544_;
                                if (_e3266 > _e3289) {
                                    phi_5549_ = _e3266;
                                } else {
                                    phi_5549_ = _e3289;
                                }
                                let _e3567 = phi_5549_;
                                if (_e3564 > _e3567) {
                                    phi_5554_ = _e3564;
                                } else {
                                    phi_5554_ = _e3567;
                                }
                                let _e3570 = phi_5554_;
                                let _e3575 = -(_e3570);
                                if (_e3561 > _e3575) {
                                    phi_5564_ = _e3561;
                                } else {
                                    phi_5564_ = _e3575;
                                }
                                let _e3578 = phi_5564_;
                                if ((_e3578 - ((((((_e3354 * 8f) * _e3464) * (0.000000059604645f * (490f / 64f))) + ((_e3471 * 19f) * ((_e3354 * (_e3408 + _e3462)) + (_e3408 * _e3462)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3354) * ((1f + _e3408) * (1f + _e3462))))) + ((_e2043 * (((_e3533 + (_e3464 * (0.000000059604645f * 4f))) + ((_e3538 * 6f) * (_e3408 + _e3462))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3408) * (1f + _e3462))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6540_ = true;
                                } else {
                                    let _e3583 = local_4[0u].member_1[0u];
                                    let _e3589 = local_4[0u].member_1[1u];
                                    let _e3593 = (_e3583[0] + _e3589[0]);
                                    let _e3594 = (_e3583[1] + _e3589[1]);
                                    let _e3595 = (_e3583[2] + _e3589[2]);
                                    let _e3598 = local_4[0u].member_2[0u];
                                    let _e3604 = local_4[0u].member_2[1u];
                                    let _e3608 = (_e3598[0] + _e3604[0]);
                                    let _e3609 = (_e3598[1] + _e3604[1]);
                                    let _e3610 = (_e3598[2] + _e3604[2]);
                                    let _e3613 = ((_e3594 * _e3610) - (_e3595 * _e3609));
                                    let _e3616 = ((_e3595 * _e3608) - (_e3593 * _e3610));
                                    let _e3619 = ((_e3593 * _e3609) - (_e3594 * _e3608));
                                    let _e3622 = local_4[0u].member[0u];
                                    let _e3628 = local_4[0u].member_1[0u];
                                    let _e3634 = local_4[0u].member_2[0u];
                                    let _e3638 = (_e3622[0] - _e3628[0]);
                                    let _e3639 = (_e3622[1] - _e3628[1]);
                                    let _e3640 = (_e3622[2] - _e3628[2]);
                                    let _e3649 = local_4[0u].member[1u];
                                    let _e3655 = local_4[0u].member_1[1u];
                                    let _e3661 = local_4[0u].member_2[1u];
                                    let _e3665 = (_e3649[0] - _e3655[0]);
                                    let _e3666 = (_e3649[1] - _e3655[1]);
                                    let _e3667 = (_e3649[2] - _e3655[2]);
                                    local_2 = array<array<f32, 3>, 4>(_e3622, array<f32, 3>(_e3638, _e3639, _e3640), array<f32, 3>((_e3622[0] - _e3634[0]), (_e3622[1] - _e3634[1]), (_e3622[2] - _e3634[2])), array<f32, 3>((_e3638 - _e3634[0]), (_e3639 - _e3634[1]), (_e3640 - _e3634[2])));
                                    local_3 = array<array<f32, 3>, 4>(_e3649, array<f32, 3>(_e3665, _e3666, _e3667), array<f32, 3>((_e3649[0] - _e3661[0]), (_e3649[1] - _e3661[1]), (_e3649[2] - _e3661[2])), array<f32, 3>((_e3665 - _e3661[0]), (_e3666 - _e3661[1]), (_e3667 - _e3661[2])));
                                    let _e3684 = local_4[0u].member[0u];
                                    if (_e3684[0] < 0f) {
                                        phi_5815_ = -(_e3684[0]);
                                    } else {
                                        phi_5815_ = _e3684[0];
                                    }
                                    let _e3691 = phi_5815_;
                                    if (_e3684[1] < 0f) {
                                        phi_5822_ = -(_e3684[1]);
                                    } else {
                                        phi_5822_ = _e3684[1];
                                    }
                                    let _e3695 = phi_5822_;
                                    if (_e3691 > _e3695) {
                                        phi_5827_ = _e3691;
                                    } else {
                                        phi_5827_ = _e3695;
                                    }
                                    let _e3698 = phi_5827_;
                                    if (_e3684[2] < 0f) {
                                        phi_5834_ = -(_e3684[2]);
                                    } else {
                                        phi_5834_ = _e3684[2];
                                    }
                                    let _e3702 = phi_5834_;
                                    if (_e3698 > _e3702) {
                                        phi_5839_ = _e3698;
                                    } else {
                                        phi_5839_ = _e3702;
                                    }
                                    let _e3705 = phi_5839_;
                                    let _e3708 = local_4[0u].member[1u];
                                    if (_e3708[0] < 0f) {
                                        phi_5852_ = -(_e3708[0]);
                                    } else {
                                        phi_5852_ = _e3708[0];
                                    }
                                    let _e3715 = phi_5852_;
                                    if (_e3708[1] < 0f) {
                                        phi_5859_ = -(_e3708[1]);
                                    } else {
                                        phi_5859_ = _e3708[1];
                                    }
                                    let _e3719 = phi_5859_;
                                    if (_e3715 > _e3719) {
                                        phi_5864_ = _e3715;
                                    } else {
                                        phi_5864_ = _e3719;
                                    }
                                    let _e3722 = phi_5864_;
                                    if (_e3708[2] < 0f) {
                                        phi_5871_ = -(_e3708[2]);
                                    } else {
                                        phi_5871_ = _e3708[2];
                                    }
                                    let _e3726 = phi_5871_;
                                    if (_e3722 > _e3726) {
                                        phi_5876_ = _e3722;
                                    } else {
                                        phi_5876_ = _e3726;
                                    }
                                    let _e3729 = phi_5876_;
                                    if (_e3705 > _e3729) {
                                        phi_5881_ = _e3705;
                                    } else {
                                        phi_5881_ = _e3729;
                                    }
                                    let _e3732 = phi_5881_;
                                    let _e3734 = local_4[0u].member_3;
                                    let _e3738 = local_4[0u].member_1[0u];
                                    if (_e3738[0] < 0f) {
                                        phi_5898_ = -(_e3738[0]);
                                    } else {
                                        phi_5898_ = _e3738[0];
                                    }
                                    let _e3745 = phi_5898_;
                                    if (_e3738[1] < 0f) {
                                        phi_5905_ = -(_e3738[1]);
                                    } else {
                                        phi_5905_ = _e3738[1];
                                    }
                                    let _e3749 = phi_5905_;
                                    if (_e3745 > _e3749) {
                                        phi_5910_ = _e3745;
                                    } else {
                                        phi_5910_ = _e3749;
                                    }
                                    let _e3752 = phi_5910_;
                                    if (_e3738[2] < 0f) {
                                        phi_5917_ = -(_e3738[2]);
                                    } else {
                                        phi_5917_ = _e3738[2];
                                    }
                                    let _e3756 = phi_5917_;
                                    if (_e3752 > _e3756) {
                                        phi_5922_ = _e3752;
                                    } else {
                                        phi_5922_ = _e3756;
                                    }
                                    let _e3759 = phi_5922_;
                                    let _e3762 = local_4[0u].member_1[1u];
                                    if (_e3762[0] < 0f) {
                                        phi_5936_ = -(_e3762[0]);
                                    } else {
                                        phi_5936_ = _e3762[0];
                                    }
                                    let _e3769 = phi_5936_;
                                    if (_e3762[1] < 0f) {
                                        phi_5943_ = -(_e3762[1]);
                                    } else {
                                        phi_5943_ = _e3762[1];
                                    }
                                    let _e3773 = phi_5943_;
                                    if (_e3769 > _e3773) {
                                        phi_5948_ = _e3769;
                                    } else {
                                        phi_5948_ = _e3773;
                                    }
                                    let _e3776 = phi_5948_;
                                    if (_e3762[2] < 0f) {
                                        phi_5955_ = -(_e3762[2]);
                                    } else {
                                        phi_5955_ = _e3762[2];
                                    }
                                    let _e3780 = phi_5955_;
                                    if (_e3776 > _e3780) {
                                        phi_5960_ = _e3776;
                                    } else {
                                        phi_5960_ = _e3780;
                                    }
                                    let _e3783 = phi_5960_;
                                    if (_e3759 > _e3783) {
                                        phi_5965_ = _e3759;
                                    } else {
                                        phi_5965_ = _e3783;
                                    }
                                    let _e3786 = phi_5965_;
                                    let _e3788 = local_4[0u].member_3;
                                    let _e3792 = local_4[0u].member_2[0u];
                                    if (_e3792[0] < 0f) {
                                        phi_5982_ = -(_e3792[0]);
                                    } else {
                                        phi_5982_ = _e3792[0];
                                    }
                                    let _e3799 = phi_5982_;
                                    if (_e3792[1] < 0f) {
                                        phi_5989_ = -(_e3792[1]);
                                    } else {
                                        phi_5989_ = _e3792[1];
                                    }
                                    let _e3803 = phi_5989_;
                                    if (_e3799 > _e3803) {
                                        phi_5994_ = _e3799;
                                    } else {
                                        phi_5994_ = _e3803;
                                    }
                                    let _e3806 = phi_5994_;
                                    if (_e3792[2] < 0f) {
                                        phi_6001_ = -(_e3792[2]);
                                    } else {
                                        phi_6001_ = _e3792[2];
                                    }
                                    let _e3810 = phi_6001_;
                                    if (_e3806 > _e3810) {
                                        phi_6006_ = _e3806;
                                    } else {
                                        phi_6006_ = _e3810;
                                    }
                                    let _e3813 = phi_6006_;
                                    let _e3816 = local_4[0u].member_2[1u];
                                    if (_e3816[0] < 0f) {
                                        phi_6020_ = -(_e3816[0]);
                                    } else {
                                        phi_6020_ = _e3816[0];
                                    }
                                    let _e3823 = phi_6020_;
                                    if (_e3816[1] < 0f) {
                                        phi_6027_ = -(_e3816[1]);
                                    } else {
                                        phi_6027_ = _e3816[1];
                                    }
                                    let _e3827 = phi_6027_;
                                    if (_e3823 > _e3827) {
                                        phi_6032_ = _e3823;
                                    } else {
                                        phi_6032_ = _e3827;
                                    }
                                    let _e3830 = phi_6032_;
                                    if (_e3816[2] < 0f) {
                                        phi_6039_ = -(_e3816[2]);
                                    } else {
                                        phi_6039_ = _e3816[2];
                                    }
                                    let _e3834 = phi_6039_;
                                    if (_e3830 > _e3834) {
                                        phi_6044_ = _e3830;
                                    } else {
                                        phi_6044_ = _e3834;
                                    }
                                    let _e3837 = phi_6044_;
                                    if (_e3813 > _e3837) {
                                        phi_6049_ = _e3813;
                                    } else {
                                        phi_6049_ = _e3837;
                                    }
                                    let _e3840 = phi_6049_;
                                    let _e3842 = local_4[0u].member_3;
                                    let _e3845 = (((_e3732 + _e3734) + (_e3786 + _e3788)) + (_e3840 + _e3842));
                                    let _e3848 = local_4[0u].member_3;
                                    let _e3852 = (((_e2043 * 1.0001f) + (_e3848 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3855 = ((_e3616 * _e3595) - (_e3619 * _e3594));
                                    let _e3858 = ((_e3619 * _e3593) - (_e3613 * _e3595));
                                    let _e3861 = ((_e3613 * _e3594) - (_e3616 * _e3593));
                                    let _e3863 = local_2[0u];
                                    let _e3871 = (((_e3855 * _e3863[0]) + (_e3858 * _e3863[1])) + (_e3861 * _e3863[2]));
                                    phi_6087_ = type_21(0u, 4u);
                                    phi_6090_ = _e3871;
                                    phi_6092_ = _e3871;
                                    loop {
                                        let _e3873 = phi_6087_;
                                        let _e3875 = phi_6090_;
                                        let _e3877 = phi_6092_;
                                        local_56 = _e3875;
                                        local_57 = _e3877;
                                        local_69 = _e3877;
                                        if (_e3873.member < _e3873.member_1) {
                                            phi_6088_ = type_21((_e3873.member + 1u), _e3873.member_1);
                                            phi_6115_ = type_21(1u, _e3873.member);
                                        } else {
                                            phi_6088_ = _e3873;
                                            phi_6115_ = type_21(0u, type_21().member_1);
                                        }
                                        let _e3889 = phi_6088_;
                                        let _e3891 = phi_6115_;
                                        let _e3895 = (bitcast<i32>(_e3891.member) != 0i);
                                        if _e3895 {
                                            let _e3897 = local_2[_e3891.member_1];
                                            let _e3905 = (((_e3855 * _e3897[0]) + (_e3858 * _e3897[1])) + (_e3861 * _e3897[2]));
                                            let _e3907 = local_3[_e3891.member_1];
                                            let _e3915 = (((_e3855 * _e3907[0]) + (_e3858 * _e3907[1])) + (_e3861 * _e3907[2]));
                                            if (_e3877 < _e3905) {
                                                phi_6165_ = _e3877;
                                            } else {
                                                phi_6165_ = _e3905;
                                            }
                                            let _e3918 = phi_6165_;
                                            if (_e3918 < _e3915) {
                                                phi_6170_ = _e3918;
                                            } else {
                                                phi_6170_ = _e3915;
                                            }
                                            let _e3921 = phi_6170_;
                                            if (_e3875 > _e3905) {
                                                phi_6175_ = _e3875;
                                            } else {
                                                phi_6175_ = _e3905;
                                            }
                                            let _e3924 = phi_6175_;
                                            if (_e3924 > _e3915) {
                                                phi_6180_ = _e3924;
                                            } else {
                                                phi_6180_ = _e3915;
                                            }
                                            let _e3927 = phi_6180_;
                                            phi_6091_ = _e3927;
                                            phi_6093_ = _e3921;
                                        } else {
                                            phi_6091_ = f32();
                                            phi_6093_ = f32();
                                        }
                                        let _e3929 = phi_6091_;
                                        let _e3931 = phi_6093_;
                                        continue;
                                        continuing {
                                            phi_6087_ = _e3889;
                                            phi_6090_ = _e3929;
                                            phi_6092_ = _e3931;
                                            break if !(_e3895);
                                        }
                                    }
                                    if (_e3855 < 0f) {
                                        phi_6186_ = -(_e3855);
                                    } else {
                                        phi_6186_ = _e3855;
                                    }
                                    let _e3936 = phi_6186_;
                                    if (_e3858 < 0f) {
                                        phi_6192_ = -(_e3858);
                                    } else {
                                        phi_6192_ = _e3858;
                                    }
                                    let _e3940 = phi_6192_;
                                    if (_e3861 < 0f) {
                                        phi_6199_ = -(_e3861);
                                    } else {
                                        phi_6199_ = _e3861;
                                    }
                                    let _e3945 = phi_6199_;
                                    let _e3946 = ((_e3936 + _e3940) + _e3945);
                                    let _e3951 = local_56;
                                    let _e3952 = -(_e3951);
                                    let _e3954 = local_57;
                                    if (_e3954 > _e3952) {
                                        let _e5568 = local_69;
                                        phi_6209_ = _e5568;
                                    } else {
                                        phi_6209_ = _e3952;
                                    }
                                    let _e3957 = phi_6209_;
                                    let _e3962 = (((_e3957 - ((_e3946 * _e3845) * (0.000000059604645f * 17f))) - (_e3946 * _e3852)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3965 = ((_e3616 * _e3610) - (_e3619 * _e3609));
                                    let _e3968 = ((_e3619 * _e3608) - (_e3613 * _e3610));
                                    let _e3971 = ((_e3613 * _e3609) - (_e3616 * _e3608));
                                    let _e3973 = local_2[0u];
                                    let _e3981 = (((_e3965 * _e3973[0]) + (_e3968 * _e3973[1])) + (_e3971 * _e3973[2]));
                                    phi_6240_ = type_21(0u, 4u);
                                    phi_6243_ = _e3981;
                                    phi_6245_ = _e3981;
                                    loop {
                                        let _e3983 = phi_6240_;
                                        let _e3985 = phi_6243_;
                                        let _e3987 = phi_6245_;
                                        local_58 = _e3985;
                                        local_59 = _e3987;
                                        local_70 = _e3987;
                                        if (_e3983.member < _e3983.member_1) {
                                            phi_6241_ = type_21((_e3983.member + 1u), _e3983.member_1);
                                            phi_6268_ = type_21(1u, _e3983.member);
                                        } else {
                                            phi_6241_ = _e3983;
                                            phi_6268_ = type_21(0u, type_21().member_1);
                                        }
                                        let _e3999 = phi_6241_;
                                        let _e4001 = phi_6268_;
                                        let _e4005 = (bitcast<i32>(_e4001.member) != 0i);
                                        if _e4005 {
                                            let _e4007 = local_2[_e4001.member_1];
                                            let _e4015 = (((_e3965 * _e4007[0]) + (_e3968 * _e4007[1])) + (_e3971 * _e4007[2]));
                                            let _e4017 = local_3[_e4001.member_1];
                                            let _e4025 = (((_e3965 * _e4017[0]) + (_e3968 * _e4017[1])) + (_e3971 * _e4017[2]));
                                            if (_e3987 < _e4015) {
                                                phi_6318_ = _e3987;
                                            } else {
                                                phi_6318_ = _e4015;
                                            }
                                            let _e4028 = phi_6318_;
                                            if (_e4028 < _e4025) {
                                                phi_6323_ = _e4028;
                                            } else {
                                                phi_6323_ = _e4025;
                                            }
                                            let _e4031 = phi_6323_;
                                            if (_e3985 > _e4015) {
                                                phi_6328_ = _e3985;
                                            } else {
                                                phi_6328_ = _e4015;
                                            }
                                            let _e4034 = phi_6328_;
                                            if (_e4034 > _e4025) {
                                                phi_6333_ = _e4034;
                                            } else {
                                                phi_6333_ = _e4025;
                                            }
                                            let _e4037 = phi_6333_;
                                            phi_6244_ = _e4037;
                                            phi_6246_ = _e4031;
                                        } else {
                                            phi_6244_ = f32();
                                            phi_6246_ = f32();
                                        }
                                        let _e4039 = phi_6244_;
                                        let _e4041 = phi_6246_;
                                        continue;
                                        continuing {
                                            phi_6240_ = _e3999;
                                            phi_6243_ = _e4039;
                                            phi_6245_ = _e4041;
                                            break if !(_e4005);
                                        }
                                    }
                                    if (_e3965 < 0f) {
                                        phi_6339_ = -(_e3965);
                                    } else {
                                        phi_6339_ = _e3965;
                                    }
                                    let _e4046 = phi_6339_;
                                    if (_e3968 < 0f) {
                                        phi_6345_ = -(_e3968);
                                    } else {
                                        phi_6345_ = _e3968;
                                    }
                                    let _e4050 = phi_6345_;
                                    if (_e3971 < 0f) {
                                        phi_6352_ = -(_e3971);
                                    } else {
                                        phi_6352_ = _e3971;
                                    }
                                    let _e4055 = phi_6352_;
                                    let _e4056 = ((_e4046 + _e4050) + _e4055);
                                    let _e4061 = local_58;
                                    let _e4062 = -(_e4061);
                                    let _e4064 = local_59;
                                    if (_e4064 > _e4062) {
                                        let _e5587 = local_70;
                                        phi_6362_ = _e5587;
                                    } else {
                                        phi_6362_ = _e4062;
                                    }
                                    let _e4067 = phi_6362_;
                                    let _e4072 = (((_e4067 - ((_e4056 * _e3845) * (0.000000059604645f * 17f))) - (_e4056 * _e3852)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3962 > _e4072) {
                                        phi_6372_ = _e3962;
                                    } else {
                                        phi_6372_ = _e4072;
                                    }
                                    let _e4075 = phi_6372_;
                                    phi_6540_ = (_e4075 > 0f);
                                }
                                let _e4078 = phi_6540_;
                                if _e4078 {
                                    let _e4082 = local_4[1u].member_1[0u];
                                    let _e4088 = local_4[1u].member_2[0u];
                                    let _e4094 = ((_e4082[1] * _e4088[2]) - (_e4082[2] * _e4088[1]));
                                    let _e4097 = ((_e4082[2] * _e4088[0]) - (_e4082[0] * _e4088[2]));
                                    let _e4100 = ((_e4082[0] * _e4088[1]) - (_e4082[1] * _e4088[0]));
                                    let _e4103 = local_4[1u].member_1[1u];
                                    let _e4109 = local_4[1u].member_2[1u];
                                    let _e4115 = ((_e4103[1] * _e4109[2]) - (_e4103[2] * _e4109[1]));
                                    let _e4118 = ((_e4103[2] * _e4109[0]) - (_e4103[0] * _e4109[2]));
                                    let _e4121 = ((_e4103[0] * _e4109[1]) - (_e4103[1] * _e4109[0]));
                                    let _e4124 = local_4[1u].member_1[0u];
                                    let _e4130 = local_4[1u].member_2[1u];
                                    let _e4145 = local_4[1u].member_1[1u];
                                    let _e4151 = local_4[1u].member_2[0u];
                                    let _e4164 = (((_e4124[1] * _e4130[2]) - (_e4124[2] * _e4130[1])) + ((_e4145[1] * _e4151[2]) - (_e4145[2] * _e4151[1])));
                                    let _e4165 = (((_e4124[2] * _e4130[0]) - (_e4124[0] * _e4130[2])) + ((_e4145[2] * _e4151[0]) - (_e4145[0] * _e4151[2])));
                                    let _e4166 = (((_e4124[0] * _e4130[1]) - (_e4124[1] * _e4130[0])) + ((_e4145[0] * _e4151[1]) - (_e4145[1] * _e4151[0])));
                                    let _e4169 = local_4[1u].member[0u];
                                    let _e4180 = local_4[1u].member[1u];
                                    let _e4191 = local_4[1u].member[0u];
                                    let _e4200 = ((((_e4180[0] * _e4094) + (_e4180[1] * _e4097)) + (_e4180[2] * _e4100)) + (((_e4191[0] * _e4164) + (_e4191[1] * _e4165)) + (_e4191[2] * _e4166)));
                                    let _e4203 = local_4[1u].member[0u];
                                    let _e4214 = local_4[1u].member[1u];
                                    let _e4223 = ((((_e4203[0] * _e4115) + (_e4203[1] * _e4118)) + (_e4203[2] * _e4121)) + (((_e4214[0] * _e4164) + (_e4214[1] * _e4165)) + (_e4214[2] * _e4166)));
                                    let _e4226 = local_4[1u].member[1u];
                                    let _e4237 = local_4[1u].member[0u];
                                    if (_e4237[0] < 0f) {
                                        phi_6786_ = -(_e4237[0]);
                                    } else {
                                        phi_6786_ = _e4237[0];
                                    }
                                    let _e4244 = phi_6786_;
                                    if (_e4237[1] < 0f) {
                                        phi_6793_ = -(_e4237[1]);
                                    } else {
                                        phi_6793_ = _e4237[1];
                                    }
                                    let _e4248 = phi_6793_;
                                    if (_e4244 > _e4248) {
                                        phi_6798_ = _e4244;
                                    } else {
                                        phi_6798_ = _e4248;
                                    }
                                    let _e4251 = phi_6798_;
                                    if (_e4237[2] < 0f) {
                                        phi_6805_ = -(_e4237[2]);
                                    } else {
                                        phi_6805_ = _e4237[2];
                                    }
                                    let _e4255 = phi_6805_;
                                    if (_e4251 > _e4255) {
                                        phi_6810_ = _e4251;
                                    } else {
                                        phi_6810_ = _e4255;
                                    }
                                    let _e4258 = phi_6810_;
                                    let _e4261 = local_4[1u].member[1u];
                                    if (_e4261[0] < 0f) {
                                        phi_6823_ = -(_e4261[0]);
                                    } else {
                                        phi_6823_ = _e4261[0];
                                    }
                                    let _e4268 = phi_6823_;
                                    if (_e4261[1] < 0f) {
                                        phi_6830_ = -(_e4261[1]);
                                    } else {
                                        phi_6830_ = _e4261[1];
                                    }
                                    let _e4272 = phi_6830_;
                                    if (_e4268 > _e4272) {
                                        phi_6835_ = _e4268;
                                    } else {
                                        phi_6835_ = _e4272;
                                    }
                                    let _e4275 = phi_6835_;
                                    if (_e4261[2] < 0f) {
                                        phi_6842_ = -(_e4261[2]);
                                    } else {
                                        phi_6842_ = _e4261[2];
                                    }
                                    let _e4279 = phi_6842_;
                                    if (_e4275 > _e4279) {
                                        phi_6847_ = _e4275;
                                    } else {
                                        phi_6847_ = _e4279;
                                    }
                                    let _e4282 = phi_6847_;
                                    if (_e4258 > _e4282) {
                                        phi_6852_ = _e4258;
                                    } else {
                                        phi_6852_ = _e4282;
                                    }
                                    let _e4285 = phi_6852_;
                                    let _e4287 = local_4[1u].member_3;
                                    let _e4288 = (_e4285 + _e4287);
                                    let _e4291 = local_4[1u].member_1[0u];
                                    if (_e4291[0] < 0f) {
                                        phi_6869_ = -(_e4291[0]);
                                    } else {
                                        phi_6869_ = _e4291[0];
                                    }
                                    let _e4298 = phi_6869_;
                                    if (_e4291[1] < 0f) {
                                        phi_6876_ = -(_e4291[1]);
                                    } else {
                                        phi_6876_ = _e4291[1];
                                    }
                                    let _e4302 = phi_6876_;
                                    if (_e4298 > _e4302) {
                                        phi_6881_ = _e4298;
                                    } else {
                                        phi_6881_ = _e4302;
                                    }
                                    let _e4305 = phi_6881_;
                                    if (_e4291[2] < 0f) {
                                        phi_6888_ = -(_e4291[2]);
                                    } else {
                                        phi_6888_ = _e4291[2];
                                    }
                                    let _e4309 = phi_6888_;
                                    if (_e4305 > _e4309) {
                                        phi_6893_ = _e4305;
                                    } else {
                                        phi_6893_ = _e4309;
                                    }
                                    let _e4312 = phi_6893_;
                                    let _e4315 = local_4[1u].member_1[1u];
                                    if (_e4315[0] < 0f) {
                                        phi_6907_ = -(_e4315[0]);
                                    } else {
                                        phi_6907_ = _e4315[0];
                                    }
                                    let _e4322 = phi_6907_;
                                    if (_e4315[1] < 0f) {
                                        phi_6914_ = -(_e4315[1]);
                                    } else {
                                        phi_6914_ = _e4315[1];
                                    }
                                    let _e4326 = phi_6914_;
                                    if (_e4322 > _e4326) {
                                        phi_6919_ = _e4322;
                                    } else {
                                        phi_6919_ = _e4326;
                                    }
                                    let _e4329 = phi_6919_;
                                    if (_e4315[2] < 0f) {
                                        phi_6926_ = -(_e4315[2]);
                                    } else {
                                        phi_6926_ = _e4315[2];
                                    }
                                    let _e4333 = phi_6926_;
                                    if (_e4329 > _e4333) {
                                        phi_6931_ = _e4329;
                                    } else {
                                        phi_6931_ = _e4333;
                                    }
                                    let _e4336 = phi_6931_;
                                    if (_e4312 > _e4336) {
                                        phi_6936_ = _e4312;
                                    } else {
                                        phi_6936_ = _e4336;
                                    }
                                    let _e4339 = phi_6936_;
                                    let _e4341 = local_4[1u].member_3;
                                    let _e4342 = (_e4339 + _e4341);
                                    let _e4345 = local_4[1u].member_2[0u];
                                    if (_e4345[0] < 0f) {
                                        phi_6953_ = -(_e4345[0]);
                                    } else {
                                        phi_6953_ = _e4345[0];
                                    }
                                    let _e4352 = phi_6953_;
                                    if (_e4345[1] < 0f) {
                                        phi_6960_ = -(_e4345[1]);
                                    } else {
                                        phi_6960_ = _e4345[1];
                                    }
                                    let _e4356 = phi_6960_;
                                    if (_e4352 > _e4356) {
                                        phi_6965_ = _e4352;
                                    } else {
                                        phi_6965_ = _e4356;
                                    }
                                    let _e4359 = phi_6965_;
                                    if (_e4345[2] < 0f) {
                                        phi_6972_ = -(_e4345[2]);
                                    } else {
                                        phi_6972_ = _e4345[2];
                                    }
                                    let _e4363 = phi_6972_;
                                    if (_e4359 > _e4363) {
                                        phi_6977_ = _e4359;
                                    } else {
                                        phi_6977_ = _e4363;
                                    }
                                    let _e4366 = phi_6977_;
                                    let _e4369 = local_4[1u].member_2[1u];
                                    if (_e4369[0] < 0f) {
                                        phi_6991_ = -(_e4369[0]);
                                    } else {
                                        phi_6991_ = _e4369[0];
                                    }
                                    let _e4376 = phi_6991_;
                                    if (_e4369[1] < 0f) {
                                        phi_6998_ = -(_e4369[1]);
                                    } else {
                                        phi_6998_ = _e4369[1];
                                    }
                                    let _e4380 = phi_6998_;
                                    if (_e4376 > _e4380) {
                                        phi_7003_ = _e4376;
                                    } else {
                                        phi_7003_ = _e4380;
                                    }
                                    let _e4383 = phi_7003_;
                                    if (_e4369[2] < 0f) {
                                        phi_7010_ = -(_e4369[2]);
                                    } else {
                                        phi_7010_ = _e4369[2];
                                    }
                                    let _e4387 = phi_7010_;
                                    if (_e4383 > _e4387) {
                                        phi_7015_ = _e4383;
                                    } else {
                                        phi_7015_ = _e4387;
                                    }
                                    let _e4390 = phi_7015_;
                                    if (_e4366 > _e4390) {
                                        phi_7020_ = _e4366;
                                    } else {
                                        phi_7020_ = _e4390;
                                    }
                                    let _e4393 = phi_7020_;
                                    let _e4395 = local_4[1u].member_3;
                                    let _e4396 = (_e4393 + _e4395);
                                    let _e4398 = ((_e4342 * 8f) * _e4396);
                                    let _e4405 = local_4[1u].member_3;
                                    if (_e4094 < 0f) {
                                        phi_7051_ = -(_e4094);
                                    } else {
                                        phi_7051_ = _e4094;
                                    }
                                    let _e4422 = phi_7051_;
                                    if (_e4097 < 0f) {
                                        phi_7057_ = -(_e4097);
                                    } else {
                                        phi_7057_ = _e4097;
                                    }
                                    let _e4426 = phi_7057_;
                                    if (_e4100 < 0f) {
                                        phi_7064_ = -(_e4100);
                                    } else {
                                        phi_7064_ = _e4100;
                                    }
                                    let _e4431 = phi_7064_;
                                    let _e4432 = ((_e4422 + _e4426) + _e4431);
                                    if (_e4115 < 0f) {
                                        phi_7071_ = -(_e4115);
                                    } else {
                                        phi_7071_ = _e4115;
                                    }
                                    let _e4436 = phi_7071_;
                                    if (_e4118 < 0f) {
                                        phi_7077_ = -(_e4118);
                                    } else {
                                        phi_7077_ = _e4118;
                                    }
                                    let _e4440 = phi_7077_;
                                    if (_e4121 < 0f) {
                                        phi_7084_ = -(_e4121);
                                    } else {
                                        phi_7084_ = _e4121;
                                    }
                                    let _e4445 = phi_7084_;
                                    let _e4446 = ((_e4436 + _e4440) + _e4445);
                                    if (_e4432 > _e4446) {
                                        phi_7090_ = _e4432;
                                    } else {
                                        phi_7090_ = _e4446;
                                    }
                                    let _e4449 = phi_7090_;
                                    if (_e4164 < 0f) {
                                        phi_7096_ = -(_e4164);
                                    } else {
                                        phi_7096_ = _e4164;
                                    }
                                    let _e4453 = phi_7096_;
                                    if (_e4165 < 0f) {
                                        phi_7102_ = -(_e4165);
                                    } else {
                                        phi_7102_ = _e4165;
                                    }
                                    let _e4457 = phi_7102_;
                                    if (_e4166 < 0f) {
                                        phi_7109_ = -(_e4166);
                                    } else {
                                        phi_7109_ = _e4166;
                                    }
                                    let _e4462 = phi_7109_;
                                    let _e4464 = (((_e4453 + _e4457) + _e4462) * 0.5f);
                                    if (_e4449 > _e4464) {
                                        phi_7116_ = _e4449;
                                    } else {
                                        phi_7116_ = _e4464;
                                    }
                                    let _e4467 = phi_7116_;
                                    let _e4472 = local_4[1u].member_3;
                                    let _e4485 = ((((_e4169[0] * _e4094) + (_e4169[1] * _e4097)) + (_e4169[2] * _e4100)) * 3f);
                                    let _e4486 = ((((_e4226[0] * _e4115) + (_e4226[1] * _e4118)) + (_e4226[2] * _e4121)) * 3f);
                                    if (_e4485 < _e4486) {
                                        phi_7140_ = _e4485;
                                    } else {
                                        phi_7140_ = _e4486;
                                    }
                                    let _e4489 = phi_7140_;
                                    if (_e4200 < _e4223) {
                                        phi_7145_ = _e4200;
                                    } else {
                                        phi_7145_ = _e4223;
                                    }
                                    let _e4492 = phi_7145_;
                                    if (_e4489 < _e4492) {
                                        phi_7150_ = _e4489;
                                    } else {
                                        phi_7150_ = _e4492;
                                    }
                                    let _e4495 = phi_7150_;
                                    if (_e4485 > _e4486) {
                                        phi_7155_ = _e4485;
                                    } else {
                                        phi_7155_ = _e4486;
                                    }
                                    let _e4498 = phi_7155_;
                                    if (_e4200 > _e4223) {
                                        phi_7160_ = _e4200;
                                    } else {
                                        phi_7160_ = _e4223;
                                    }
                                    let _e4501 = phi_7160_;
                                    if (_e4498 > _e4501) {
                                        phi_7165_ = _e4498;
                                    } else {
                                        phi_7165_ = _e4501;
                                    }
                                    let _e4504 = phi_7165_;
                                    let _e4509 = -(_e4504);
                                    if (_e4495 > _e4509) {
                                        phi_7175_ = _e4495;
                                    } else {
                                        phi_7175_ = _e4509;
                                    }
                                    let _e4512 = phi_7175_;
                                    if ((_e4512 - ((((((_e4288 * 8f) * _e4398) * (0.000000059604645f * (490f / 64f))) + ((_e4405 * 19f) * ((_e4288 * (_e4342 + _e4396)) + (_e4342 * _e4396)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4288) * ((1f + _e4342) * (1f + _e4396))))) + ((_e2043 * (((_e4467 + (_e4398 * (0.000000059604645f * 4f))) + ((_e4472 * 6f) * (_e4342 + _e4396))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4342) * (1f + _e4396))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_8151_ = true;
                                    } else {
                                        let _e4517 = local_4[1u].member_1[0u];
                                        let _e4523 = local_4[1u].member_1[1u];
                                        let _e4527 = (_e4517[0] + _e4523[0]);
                                        let _e4528 = (_e4517[1] + _e4523[1]);
                                        let _e4529 = (_e4517[2] + _e4523[2]);
                                        let _e4532 = local_4[1u].member_2[0u];
                                        let _e4538 = local_4[1u].member_2[1u];
                                        let _e4542 = (_e4532[0] + _e4538[0]);
                                        let _e4543 = (_e4532[1] + _e4538[1]);
                                        let _e4544 = (_e4532[2] + _e4538[2]);
                                        let _e4547 = ((_e4528 * _e4544) - (_e4529 * _e4543));
                                        let _e4550 = ((_e4529 * _e4542) - (_e4527 * _e4544));
                                        let _e4553 = ((_e4527 * _e4543) - (_e4528 * _e4542));
                                        let _e4556 = local_4[1u].member[0u];
                                        let _e4562 = local_4[1u].member_1[0u];
                                        let _e4568 = local_4[1u].member_2[0u];
                                        let _e4572 = (_e4556[0] - _e4562[0]);
                                        let _e4573 = (_e4556[1] - _e4562[1]);
                                        let _e4574 = (_e4556[2] - _e4562[2]);
                                        let _e4583 = local_4[1u].member[1u];
                                        let _e4589 = local_4[1u].member_1[1u];
                                        let _e4595 = local_4[1u].member_2[1u];
                                        let _e4599 = (_e4583[0] - _e4589[0]);
                                        let _e4600 = (_e4583[1] - _e4589[1]);
                                        let _e4601 = (_e4583[2] - _e4589[2]);
                                        local = array<array<f32, 3>, 4>(_e4556, array<f32, 3>(_e4572, _e4573, _e4574), array<f32, 3>((_e4556[0] - _e4568[0]), (_e4556[1] - _e4568[1]), (_e4556[2] - _e4568[2])), array<f32, 3>((_e4572 - _e4568[0]), (_e4573 - _e4568[1]), (_e4574 - _e4568[2])));
                                        local_1 = array<array<f32, 3>, 4>(_e4583, array<f32, 3>(_e4599, _e4600, _e4601), array<f32, 3>((_e4583[0] - _e4595[0]), (_e4583[1] - _e4595[1]), (_e4583[2] - _e4595[2])), array<f32, 3>((_e4599 - _e4595[0]), (_e4600 - _e4595[1]), (_e4601 - _e4595[2])));
                                        let _e4618 = local_4[1u].member[0u];
                                        if (_e4618[0] < 0f) {
                                            phi_7426_ = -(_e4618[0]);
                                        } else {
                                            phi_7426_ = _e4618[0];
                                        }
                                        let _e4625 = phi_7426_;
                                        if (_e4618[1] < 0f) {
                                            phi_7433_ = -(_e4618[1]);
                                        } else {
                                            phi_7433_ = _e4618[1];
                                        }
                                        let _e4629 = phi_7433_;
                                        if (_e4625 > _e4629) {
                                            phi_7438_ = _e4625;
                                        } else {
                                            phi_7438_ = _e4629;
                                        }
                                        let _e4632 = phi_7438_;
                                        if (_e4618[2] < 0f) {
                                            phi_7445_ = -(_e4618[2]);
                                        } else {
                                            phi_7445_ = _e4618[2];
                                        }
                                        let _e4636 = phi_7445_;
                                        if (_e4632 > _e4636) {
                                            phi_7450_ = _e4632;
                                        } else {
                                            phi_7450_ = _e4636;
                                        }
                                        let _e4639 = phi_7450_;
                                        let _e4642 = local_4[1u].member[1u];
                                        if (_e4642[0] < 0f) {
                                            phi_7463_ = -(_e4642[0]);
                                        } else {
                                            phi_7463_ = _e4642[0];
                                        }
                                        let _e4649 = phi_7463_;
                                        if (_e4642[1] < 0f) {
                                            phi_7470_ = -(_e4642[1]);
                                        } else {
                                            phi_7470_ = _e4642[1];
                                        }
                                        let _e4653 = phi_7470_;
                                        if (_e4649 > _e4653) {
                                            phi_7475_ = _e4649;
                                        } else {
                                            phi_7475_ = _e4653;
                                        }
                                        let _e4656 = phi_7475_;
                                        if (_e4642[2] < 0f) {
                                            phi_7482_ = -(_e4642[2]);
                                        } else {
                                            phi_7482_ = _e4642[2];
                                        }
                                        let _e4660 = phi_7482_;
                                        if (_e4656 > _e4660) {
                                            phi_7487_ = _e4656;
                                        } else {
                                            phi_7487_ = _e4660;
                                        }
                                        let _e4663 = phi_7487_;
                                        if (_e4639 > _e4663) {
                                            phi_7492_ = _e4639;
                                        } else {
                                            phi_7492_ = _e4663;
                                        }
                                        let _e4666 = phi_7492_;
                                        let _e4668 = local_4[1u].member_3;
                                        let _e4672 = local_4[1u].member_1[0u];
                                        if (_e4672[0] < 0f) {
                                            phi_7509_ = -(_e4672[0]);
                                        } else {
                                            phi_7509_ = _e4672[0];
                                        }
                                        let _e4679 = phi_7509_;
                                        if (_e4672[1] < 0f) {
                                            phi_7516_ = -(_e4672[1]);
                                        } else {
                                            phi_7516_ = _e4672[1];
                                        }
                                        let _e4683 = phi_7516_;
                                        if (_e4679 > _e4683) {
                                            phi_7521_ = _e4679;
                                        } else {
                                            phi_7521_ = _e4683;
                                        }
                                        let _e4686 = phi_7521_;
                                        if (_e4672[2] < 0f) {
                                            phi_7528_ = -(_e4672[2]);
                                        } else {
                                            phi_7528_ = _e4672[2];
                                        }
                                        let _e4690 = phi_7528_;
                                        if (_e4686 > _e4690) {
                                            phi_7533_ = _e4686;
                                        } else {
                                            phi_7533_ = _e4690;
                                        }
                                        let _e4693 = phi_7533_;
                                        let _e4696 = local_4[1u].member_1[1u];
                                        if (_e4696[0] < 0f) {
                                            phi_7547_ = -(_e4696[0]);
                                        } else {
                                            phi_7547_ = _e4696[0];
                                        }
                                        let _e4703 = phi_7547_;
                                        if (_e4696[1] < 0f) {
                                            phi_7554_ = -(_e4696[1]);
                                        } else {
                                            phi_7554_ = _e4696[1];
                                        }
                                        let _e4707 = phi_7554_;
                                        if (_e4703 > _e4707) {
                                            phi_7559_ = _e4703;
                                        } else {
                                            phi_7559_ = _e4707;
                                        }
                                        let _e4710 = phi_7559_;
                                        if (_e4696[2] < 0f) {
                                            phi_7566_ = -(_e4696[2]);
                                        } else {
                                            phi_7566_ = _e4696[2];
                                        }
                                        let _e4714 = phi_7566_;
                                        if (_e4710 > _e4714) {
                                            phi_7571_ = _e4710;
                                        } else {
                                            phi_7571_ = _e4714;
                                        }
                                        let _e4717 = phi_7571_;
                                        if (_e4693 > _e4717) {
                                            phi_7576_ = _e4693;
                                        } else {
                                            phi_7576_ = _e4717;
                                        }
                                        let _e4720 = phi_7576_;
                                        let _e4722 = local_4[1u].member_3;
                                        let _e4726 = local_4[1u].member_2[0u];
                                        if (_e4726[0] < 0f) {
                                            phi_7593_ = -(_e4726[0]);
                                        } else {
                                            phi_7593_ = _e4726[0];
                                        }
                                        let _e4733 = phi_7593_;
                                        if (_e4726[1] < 0f) {
                                            phi_7600_ = -(_e4726[1]);
                                        } else {
                                            phi_7600_ = _e4726[1];
                                        }
                                        let _e4737 = phi_7600_;
                                        if (_e4733 > _e4737) {
                                            phi_7605_ = _e4733;
                                        } else {
                                            phi_7605_ = _e4737;
                                        }
                                        let _e4740 = phi_7605_;
                                        if (_e4726[2] < 0f) {
                                            phi_7612_ = -(_e4726[2]);
                                        } else {
                                            phi_7612_ = _e4726[2];
                                        }
                                        let _e4744 = phi_7612_;
                                        if (_e4740 > _e4744) {
                                            phi_7617_ = _e4740;
                                        } else {
                                            phi_7617_ = _e4744;
                                        }
                                        let _e4747 = phi_7617_;
                                        let _e4750 = local_4[1u].member_2[1u];
                                        if (_e4750[0] < 0f) {
                                            phi_7631_ = -(_e4750[0]);
                                        } else {
                                            phi_7631_ = _e4750[0];
                                        }
                                        let _e4757 = phi_7631_;
                                        if (_e4750[1] < 0f) {
                                            phi_7638_ = -(_e4750[1]);
                                        } else {
                                            phi_7638_ = _e4750[1];
                                        }
                                        let _e4761 = phi_7638_;
                                        if (_e4757 > _e4761) {
                                            phi_7643_ = _e4757;
                                        } else {
                                            phi_7643_ = _e4761;
                                        }
                                        let _e4764 = phi_7643_;
                                        if (_e4750[2] < 0f) {
                                            phi_7650_ = -(_e4750[2]);
                                        } else {
                                            phi_7650_ = _e4750[2];
                                        }
                                        let _e4768 = phi_7650_;
                                        if (_e4764 > _e4768) {
                                            phi_7655_ = _e4764;
                                        } else {
                                            phi_7655_ = _e4768;
                                        }
                                        let _e4771 = phi_7655_;
                                        if (_e4747 > _e4771) {
                                            phi_7660_ = _e4747;
                                        } else {
                                            phi_7660_ = _e4771;
                                        }
                                        let _e4774 = phi_7660_;
                                        let _e4776 = local_4[1u].member_3;
                                        let _e4779 = (((_e4666 + _e4668) + (_e4720 + _e4722)) + (_e4774 + _e4776));
                                        let _e4782 = local_4[1u].member_3;
                                        let _e4786 = (((_e2043 * 1.0001f) + (_e4782 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4789 = ((_e4550 * _e4529) - (_e4553 * _e4528));
                                        let _e4792 = ((_e4553 * _e4527) - (_e4547 * _e4529));
                                        let _e4795 = ((_e4547 * _e4528) - (_e4550 * _e4527));
                                        let _e4797 = local[0u];
                                        let _e4805 = (((_e4789 * _e4797[0]) + (_e4792 * _e4797[1])) + (_e4795 * _e4797[2]));
                                        phi_7698_ = type_21(0u, 4u);
                                        phi_7701_ = _e4805;
                                        phi_7703_ = _e4805;
                                        loop {
                                            let _e4807 = phi_7698_;
                                            let _e4809 = phi_7701_;
                                            let _e4811 = phi_7703_;
                                            local_60 = _e4809;
                                            local_61 = _e4811;
                                            local_71 = _e4811;
                                            if (_e4807.member < _e4807.member_1) {
                                                phi_7699_ = type_21((_e4807.member + 1u), _e4807.member_1);
                                                phi_7726_ = type_21(1u, _e4807.member);
                                            } else {
                                                phi_7699_ = _e4807;
                                                phi_7726_ = type_21(0u, type_21().member_1);
                                            }
                                            let _e4823 = phi_7699_;
                                            let _e4825 = phi_7726_;
                                            let _e4829 = (bitcast<i32>(_e4825.member) != 0i);
                                            if _e4829 {
                                                let _e4831 = local[_e4825.member_1];
                                                let _e4839 = (((_e4789 * _e4831[0]) + (_e4792 * _e4831[1])) + (_e4795 * _e4831[2]));
                                                let _e4841 = local_1[_e4825.member_1];
                                                let _e4849 = (((_e4789 * _e4841[0]) + (_e4792 * _e4841[1])) + (_e4795 * _e4841[2]));
                                                if (_e4811 < _e4839) {
                                                    phi_7776_ = _e4811;
                                                } else {
                                                    phi_7776_ = _e4839;
                                                }
                                                let _e4852 = phi_7776_;
                                                if (_e4852 < _e4849) {
                                                    phi_7781_ = _e4852;
                                                } else {
                                                    phi_7781_ = _e4849;
                                                }
                                                let _e4855 = phi_7781_;
                                                if (_e4809 > _e4839) {
                                                    phi_7786_ = _e4809;
                                                } else {
                                                    phi_7786_ = _e4839;
                                                }
                                                let _e4858 = phi_7786_;
                                                if (_e4858 > _e4849) {
                                                    phi_7791_ = _e4858;
                                                } else {
                                                    phi_7791_ = _e4849;
                                                }
                                                let _e4861 = phi_7791_;
                                                phi_7702_ = _e4861;
                                                phi_7704_ = _e4855;
                                            } else {
                                                phi_7702_ = f32();
                                                phi_7704_ = f32();
                                            }
                                            let _e4863 = phi_7702_;
                                            let _e4865 = phi_7704_;
                                            continue;
                                            continuing {
                                                phi_7698_ = _e4823;
                                                phi_7701_ = _e4863;
                                                phi_7703_ = _e4865;
                                                break if !(_e4829);
                                            }
                                        }
                                        if (_e4789 < 0f) {
                                            phi_7797_ = -(_e4789);
                                        } else {
                                            phi_7797_ = _e4789;
                                        }
                                        let _e4870 = phi_7797_;
                                        if (_e4792 < 0f) {
                                            phi_7803_ = -(_e4792);
                                        } else {
                                            phi_7803_ = _e4792;
                                        }
                                        let _e4874 = phi_7803_;
                                        if (_e4795 < 0f) {
                                            phi_7810_ = -(_e4795);
                                        } else {
                                            phi_7810_ = _e4795;
                                        }
                                        let _e4879 = phi_7810_;
                                        let _e4880 = ((_e4870 + _e4874) + _e4879);
                                        let _e4885 = local_60;
                                        let _e4886 = -(_e4885);
                                        let _e4888 = local_61;
                                        if (_e4888 > _e4886) {
                                            let _e5692 = local_71;
                                            phi_7820_ = _e5692;
                                        } else {
                                            phi_7820_ = _e4886;
                                        }
                                        let _e4891 = phi_7820_;
                                        let _e4896 = (((_e4891 - ((_e4880 * _e4779) * (0.000000059604645f * 17f))) - (_e4880 * _e4786)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4899 = ((_e4550 * _e4544) - (_e4553 * _e4543));
                                        let _e4902 = ((_e4553 * _e4542) - (_e4547 * _e4544));
                                        let _e4905 = ((_e4547 * _e4543) - (_e4550 * _e4542));
                                        let _e4907 = local[0u];
                                        let _e4915 = (((_e4899 * _e4907[0]) + (_e4902 * _e4907[1])) + (_e4905 * _e4907[2]));
                                        phi_7851_ = type_21(0u, 4u);
                                        phi_7854_ = _e4915;
                                        phi_7856_ = _e4915;
                                        loop {
                                            let _e4917 = phi_7851_;
                                            let _e4919 = phi_7854_;
                                            let _e4921 = phi_7856_;
                                            local_62 = _e4919;
                                            local_63 = _e4921;
                                            local_72 = _e4921;
                                            if (_e4917.member < _e4917.member_1) {
                                                phi_7852_ = type_21((_e4917.member + 1u), _e4917.member_1);
                                                phi_7879_ = type_21(1u, _e4917.member);
                                            } else {
                                                phi_7852_ = _e4917;
                                                phi_7879_ = type_21(0u, type_21().member_1);
                                            }
                                            let _e4933 = phi_7852_;
                                            let _e4935 = phi_7879_;
                                            let _e4939 = (bitcast<i32>(_e4935.member) != 0i);
                                            if _e4939 {
                                                let _e4941 = local[_e4935.member_1];
                                                let _e4949 = (((_e4899 * _e4941[0]) + (_e4902 * _e4941[1])) + (_e4905 * _e4941[2]));
                                                let _e4951 = local_1[_e4935.member_1];
                                                let _e4959 = (((_e4899 * _e4951[0]) + (_e4902 * _e4951[1])) + (_e4905 * _e4951[2]));
                                                if (_e4921 < _e4949) {
                                                    phi_7929_ = _e4921;
                                                } else {
                                                    phi_7929_ = _e4949;
                                                }
                                                let _e4962 = phi_7929_;
                                                if (_e4962 < _e4959) {
                                                    phi_7934_ = _e4962;
                                                } else {
                                                    phi_7934_ = _e4959;
                                                }
                                                let _e4965 = phi_7934_;
                                                if (_e4919 > _e4949) {
                                                    phi_7939_ = _e4919;
                                                } else {
                                                    phi_7939_ = _e4949;
                                                }
                                                let _e4968 = phi_7939_;
                                                if (_e4968 > _e4959) {
                                                    phi_7944_ = _e4968;
                                                } else {
                                                    phi_7944_ = _e4959;
                                                }
                                                let _e4971 = phi_7944_;
                                                phi_7855_ = _e4971;
                                                phi_7857_ = _e4965;
                                            } else {
                                                phi_7855_ = f32();
                                                phi_7857_ = f32();
                                            }
                                            let _e4973 = phi_7855_;
                                            let _e4975 = phi_7857_;
                                            continue;
                                            continuing {
                                                phi_7851_ = _e4933;
                                                phi_7854_ = _e4973;
                                                phi_7856_ = _e4975;
                                                break if !(_e4939);
                                            }
                                        }
                                        if (_e4899 < 0f) {
                                            phi_7950_ = -(_e4899);
                                        } else {
                                            phi_7950_ = _e4899;
                                        }
                                        let _e4980 = phi_7950_;
                                        if (_e4902 < 0f) {
                                            phi_7956_ = -(_e4902);
                                        } else {
                                            phi_7956_ = _e4902;
                                        }
                                        let _e4984 = phi_7956_;
                                        if (_e4905 < 0f) {
                                            phi_7963_ = -(_e4905);
                                        } else {
                                            phi_7963_ = _e4905;
                                        }
                                        let _e4989 = phi_7963_;
                                        let _e4990 = ((_e4980 + _e4984) + _e4989);
                                        let _e4995 = local_62;
                                        let _e4996 = -(_e4995);
                                        let _e4998 = local_63;
                                        if (_e4998 > _e4996) {
                                            let _e5711 = local_72;
                                            phi_7973_ = _e5711;
                                        } else {
                                            phi_7973_ = _e4996;
                                        }
                                        let _e5001 = phi_7973_;
                                        let _e5006 = (((_e5001 - ((_e4990 * _e4779) * (0.000000059604645f * 17f))) - (_e4990 * _e4786)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4896 > _e5006) {
                                            phi_7983_ = _e4896;
                                        } else {
                                            phi_7983_ = _e5006;
                                        }
                                        let _e5009 = phi_7983_;
                                        phi_8151_ = (_e5009 > 0f);
                                    }
                                    let _e5012 = phi_8151_;
                                    phi_8152_ = _e5012;
                                } else {
                                    phi_8152_ = false;
                                }
                                let _e5014 = phi_8152_;
                                phi_8154_ = !(_e5014);
                            }
                            let _e5017 = phi_8154_;
                            if _e5017 {
                                let _e5019 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1300] = ((2147483648u | (_e5019 << bitcast<u32>(12i))) | _e1303);
                            }
                        }
                        phi_8164_ = true;
                    }
                    let _e5026 = phi_8164_;
                    phi_8165_ = _e5026;
                } else {
                    phi_8165_ = false;
                }
                let _e5028 = phi_8165_;
                continue;
                continuing {
                    phi_1900_ = _e1292;
                    break if !(_e5028);
                }
            }
            workgroupBarrier();
            if (_e97 == 0u) {
                let _e5032 = atomicLoad((&counters[5u]));
                if (_e5032 > 0u) {
                    let _e5035 = atomicAdd((&output.member[0u]), _e5032);
                    if ((_e5035 + _e5032) < _e5035) {
                        let _e5039 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e5035);
                }
            }
            workgroupBarrier();
            let _e5042 = atomicLoad((&counters[6u]));
            if (_e97 == 0u) {
                let _e5045 = atomicLoad((&counters[7u]));
                if (_e5045 > 0u) {
                    let _e5048 = atomicAdd((&output.member[1u]), _e5045);
                    if ((_e5048 + _e5045) < _e5048) {
                        let _e5052 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_8215_ = type_21(0u, 16u);
            loop {
                let _e5054 = phi_8215_;
                if (_e5054.member < _e5054.member_1) {
                    phi_8216_ = type_21((_e5054.member + 1u), _e5054.member_1);
                    phi_8239_ = type_21(1u, _e5054.member);
                } else {
                    phi_8216_ = _e5054;
                    phi_8239_ = type_21(0u, type_21().member_1);
                }
                let _e5066 = phi_8216_;
                let _e5068 = phi_8239_;
                if (bitcast<i32>(_e5068.member) != 0i) {
                    let _e5074 = (_e97 + (_e5068.member_1 * 128u));
                    if (_e5074 >= _e1278) {
                        phi_8337_ = false;
                    } else {
                        let _e5077 = hits[_e5074];
                        if ((_e5077 & 2147483648u) == 0u) {
                            phi_8262_ = 4294967295u;
                        } else {
                            phi_8262_ = ((_e5077 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e5084 = phi_8262_;
                        if (_e5084 != 4294967295u) {
                            let _e5088 = ((_e5077 >> bitcast<u32>(10i)) & 3u);
                            let _e5095 = firsts[(2u * _e5088)];
                            let _e5098 = leaves.member[(_e5095 + ((_e5077 >> bitcast<u32>(5i)) & 31u))];
                            let _e5102 = firsts[((2u * _e5088) + 1u)];
                            let _e5105 = leaves.member[(_e5102 + (_e5077 & 31u))];
                            let _e5109 = params.member.member_16;
                            let _e5110 = (_e5042 + _e5084);
                            if (_e5098.member_1 < _e5105.member_1) {
                                phi_8316_ = type_21(_e5098.member_1, _e5105.member_1);
                            } else {
                                phi_8316_ = type_21(_e5105.member_1, _e5098.member_1);
                            }
                            let _e5115 = phi_8316_;
                            if (_e5110 < _e5109) {
                                atomicStore((&output.member[(4u + (2u * _e5110))]), _e5115.member);
                                atomicStore((&output.member[((2u * _e5110) + 5u)]), _e5115.member_1);
                            }
                        }
                        phi_8337_ = true;
                    }
                    let _e5126 = phi_8337_;
                    phi_8338_ = _e5126;
                } else {
                    phi_8338_ = false;
                }
                let _e5128 = phi_8338_;
                continue;
                continuing {
                    phi_8215_ = _e5066;
                    break if !(_e5128);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_320_ = _e178;
            break if !(_e184);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
